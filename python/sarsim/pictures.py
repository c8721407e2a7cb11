"""Pictures of samples: by matplotlib where it is installed, else PNG made here."""

from __future__ import annotations

import struct
import zlib
from typing import TYPE_CHECKING, Any, Dict, Tuple

import numpy as np

if TYPE_CHECKING:
    import os

    from .samples import Samples


class Picture:
    """A picture in grey. Notebooks show it."""

    def __init__(self, levels: np.ndarray) -> None:
        self.levels = np.ascontiguousarray(levels, dtype=np.uint8)
        """0 to 255; the first row is at the top."""

    @property
    def png(self) -> bytes:
        """The picture as a PNG file."""
        height, width = self.levels.shape
        rows = np.zeros((height, width + 1), dtype=np.uint8)  # Each row begins with its filter: none.
        rows[:, 1:] = self.levels
        header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
        parts = ((b"IHDR", header), (b"IDAT", zlib.compress(rows.tobytes(), 6)), (b"IEND", b""))
        return b"\x89PNG\r\n\x1a\n" + b"".join(map(_chunk, parts))

    def save(self, path: "str | os.PathLike[str]") -> None:
        """Writes the PNG file."""
        with open(path, "wb") as file:
            file.write(self.png)

    def _repr_png_(self) -> bytes:
        return self.png

    def __repr__(self) -> str:
        height, width = self.levels.shape
        return f"<Picture: {width} x {height}>"


def _chunk(part: "Tuple[bytes, bytes]") -> bytes:
    name, data = part
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def _shrunk(values: np.ndarray, length: int) -> np.ndarray:
    """At most `length` rows, each the largest of those that it stands for."""
    if len(values) <= length:
        return values
    starts = np.arange(length) * len(values) // length
    return np.maximum.reduceat(values, starts, axis=0)


def _grown(values: np.ndarray, length: int) -> np.ndarray:
    """As many copies of each row as fit."""
    return np.repeat(values, max(1, length // max(1, len(values))), axis=0)


def picture(samples: "Samples", span_db: float, width: int, height: int) -> Picture:
    magnitudes = np.abs(samples.samples)
    small = _grown(_shrunk(_grown(_shrunk(magnitudes, height), height).T, width), width).T
    largest = float(small.max()) if small.size else 0.0
    if largest == 0.0:
        return Picture(np.zeros(small.shape))
    levels = 20 * np.log10(np.maximum(small / largest, 1e-15)) / span_db + 1
    return Picture(np.rint(255 * np.clip(levels, 0, 1))[::-1])


def _extent(samples: "Samples") -> "Tuple[float, float, float, float]":
    """Left, right, bottom and top of a picture, half a sample beyond the outer samples."""
    edges = []
    for name, count in zip(reversed(samples.dims), reversed(samples.shape)):
        values = samples.axes[name].values if name in samples.axes else np.arange(count)
        first, last = float(values[0]), float(values[-1])
        half = (last - first) / max(1, count - 1) / 2 or 0.5
        edges += [first - half, last + half]
    left, right, bottom, top = edges
    return left, right, bottom, top


def _label(name: str, samples: "Samples") -> str:
    unit = samples.axes[name].unit if name in samples.axes else ""
    words = name[: -len(unit) - 1] if unit and name.endswith("_" + unit) else name
    return words.replace("_", " ") + (f" [{unit}]" if unit else "")


def plot(samples: "Samples", ax: Any, span_db: float, options: "Dict[str, Any]") -> Any:
    try:
        import matplotlib.pyplot as pyplot
    except ImportError:
        if ax is not None:
            raise
        return samples.picture(span_db=span_db)
    if ax is None:
        ax = pyplot.subplots()[1]
    look = {"aspect": "auto", "origin": "lower", "cmap": "gray", "vmin": -span_db, "vmax": 0.0, **options}
    shown = ax.imshow(samples.db(), extent=_extent(samples), **look)
    ax.figure.colorbar(shown, ax=ax, label="dB of the largest")
    rows, columns = samples.dims
    ax.set_xlabel(_label(columns, samples))
    ax.set_ylabel(_label(rows, samples))
    return ax
