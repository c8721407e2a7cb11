"""Recordings of scenes: in memory, in blocks of rows, in files."""

from __future__ import annotations

import ctypes
import os
from ctypes import byref
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, Iterator, Tuple

import numpy as np

from . import _convert
from . import _declarations as c
from ._library import WORK, Handle, Progress, _decoded, call, lib, work
from .problems import Problems
from .samples import Axis, Samples

if TYPE_CHECKING:
    from .scene import Path, Scene

_AXES = (
    ("pulse_time_s", "s", c.SARSIM_ROW_TIME_S, 1),
    ("slant_range_m", "m", c.SARSIM_COLUMN_RANGE_M, 1),
    ("carrier_hz", "Hz", c.SARSIM_ROW_CARRIER_HZ, 1),
    ("platform_position_m", "m", c.SARSIM_ROW_POSITION_M, 3),
    ("platform_velocity_mps", "m/s", c.SARSIM_ROW_VELOCITY_MPS, 3),
    ("platform_rotation_rad", "rad", c.SARSIM_ROW_ROTATION_RAD, 3),
)
_RECORDERS = {np.dtype(np.complex64): "sarsim_record_float", np.dtype(np.complex128): "sarsim_record_double"}
_BLOCK_BYTES = 8 << 20


def _number_of(scene: "Scene", which: "int | str") -> int:
    """The number of a recording, from 1."""
    if not isinstance(which, (str, os.PathLike)):
        return _convert.whole(which, "the number of a recording", 1, 2**31)
    which = _convert.text(which, "the file of a recording").decode("utf-8", "surrogateescape")
    files = [one.file for one in scene.recordings]
    if which not in files:
        raise KeyError(f"no recording has the file {which!r}; there is {', '.join(files) or 'none'}")
    return files.index(which) + 1


class Plan:
    """A recording of a scene, checked and with everything decided before its first pulse.

    Its attributes are what it is and takes: rows, columns, sample_rate_hz, bits, lsb_v, radar, processing, format, file,
    engine, engine_reason, echoes, seconds, memory_bytes, file_bytes.
    """

    rows: int
    columns: int
    sample_rate_hz: float
    bits: int
    lsb_v: float
    radar: str
    processing: str
    format: str
    file: str
    engine: str
    engine_reason: str
    echoes: float
    seconds: float
    memory_bytes: float
    file_bytes: float

    def __init__(self, scene: "Scene", number: "int | str" = 1, *, threads: int = 0, progress: Progress = None) -> None:
        self._handle = Handle(lib.sarsim_plan_free)
        self.remarks: Problems = work(
            lib.sarsim_plan_new,
            scene._handle,
            _number_of(scene, number),
            WORK,
            self._handle.out,
            threads=threads,
            progress=progress,
        )
        """What is worth knowing of it."""
        info = c.sarsim_plan_info(ctypes.sizeof(c.sarsim_plan_info))
        call(lib.sarsim_plan_get_info, self._handle, byref(info))
        for name, *_ in c.sarsim_plan_info._fields_[1:]:
            value = getattr(info, name)
            setattr(self, name, value if isinstance(value, (int, float)) else _decoded(value))

    def axis(self, which: int, parts: int) -> np.ndarray:
        count = self.columns if which == c.SARSIM_COLUMN_RANGE_M else self.rows
        values = np.empty(count if parts == 1 else (count, parts))
        call(lib.sarsim_plan_axis, self._handle, which, 0, count, values.ctypes.data)
        return values

    def samples(self, first: int, count: int, dtype: Any, threads: int, progress: Progress) -> np.ndarray:
        """Rows [first, first + count), computed into the memory of a new array."""
        kind = np.dtype(dtype)
        if kind not in _RECORDERS:
            raise ValueError(f"samples of {kind} are not computed; expected complex64 or complex128")
        first = _convert.whole(first, "the first row", 0, self.rows)
        count = _convert.whole(count, "the number of rows", 0, self.rows - first)
        samples = np.empty((count, self.columns), kind)
        recorder = getattr(lib, _RECORDERS[kind])
        work(recorder, self._handle, first, count, samples.ctypes.data, WORK, threads=threads, progress=progress)
        return samples

    def __repr__(self) -> str:
        return f"<Plan: {self.radar}, {self.processing}, {self.rows} x {self.columns}, about {self.seconds:.3g} s>"


class Recording(Samples):
    """A recording in memory: complex samples in volts, a row for each pulse."""

    pulse_time_s: np.ndarray
    """When each pulse is sent."""
    carrier_hz: np.ndarray
    """Its carrier."""
    slant_range_m: np.ndarray
    """One way, of each column."""
    platform_position_m: np.ndarray
    """x, y, z of the radar's platform at each pulse, in world axes."""
    platform_velocity_mps: np.ndarray
    """Its velocity."""
    platform_rotation_rad: np.ndarray
    """Its rotations about x, y and z."""

    def __init__(self, scene: "Scene", plan: Plan, samples: np.ndarray) -> None:
        axes = [Axis(name, unit, name == "slant_range_m", plan.axis(which, parts)) for name, unit, which, parts in _AXES]
        super().__init__(axes, {"radar": plan.radar, "processing": plan.processing, "units": "V"})
        self._samples = samples
        self.scene = scene
        """The scene as it was."""
        self.plan = plan
        """What was decided before the first pulse."""

    @property
    def samples(self) -> np.ndarray:
        """The samples: pulses, ranges."""
        return self._samples

    @property
    def remarks(self) -> Problems:
        """What is worth knowing of it."""
        return self.plan.remarks

    def save(self, path: "Path", **options: Any) -> None:
        """Writes the samples as they are now, in single precision, to a file in the format of its ending, with their axes, the
        scene and the radar as far as it has place for them. `Scene.record_file` writes the file that `sarsim run` does."""
        from .products import Raster

        axes = {name: axis.values for name, axis in self.axes.items() if axis.values.ndim == 1}
        attributes = {"script": self.scene.text(), "radar": self.plan.radar, "bits": str(self.plan.bits)}
        attributes["sample_rate_hz"] = repr(self.plan.sample_rate_hz)
        Raster.of(self.samples, axes, attributes).save(path, **options)


def record(scene: "Scene", number: "int | str", *, dtype: Any, threads: int, progress: Progress) -> Recording:
    plan = Plan(scene, number, threads=threads)
    samples = plan.samples(0, plan.rows, dtype, threads, progress)
    return Recording(scene.copy(), plan, samples)


def rows(
    scene: "Scene", number: "int | str", *, block: int, dtype: Any, threads: int
) -> "Iterator[Tuple[int, np.ndarray]]":
    block = _convert.whole(block, "block")
    plan = Plan(scene, number, threads=threads)
    size = block or max(1, _BLOCK_BYTES // (max(1, plan.columns) * np.dtype(dtype).itemsize))
    for first in range(0, plan.rows, size):
        yield first, plan.samples(first, min(size, plan.rows - first), dtype, threads, None)


@dataclass(frozen=True)
class FileReport:
    """What the file of a recording turned out to be."""

    seconds: float
    """That it took."""
    bytes: float
    """Of the file."""
    maximum_v: float
    """Largest magnitude."""
    lsb_v: float
    """Least significant bit that was used."""
    saturated: int
    """Samples whose I or Q was clipped."""
    zero: int
    """Samples whose counts are both 0."""
    remarks: Problems
    """What is worth knowing."""


def record_file(
    scene: "Scene",
    path: "Path",
    number: "int | str",
    *,
    format: "str | None" = None,
    replace: bool = False,
    counts: bool = False,
    header: bool = False,
    doubles: bool = False,
    threads: int = 0,
    progress: Progress = None,
) -> FileReport:
    plan = Plan(scene, number, threads=threads)
    options = c.sarsim_file_options(
        ctypes.sizeof(c.sarsim_file_options),
        None if format is None else _convert.text(format, "the format"),
        bool(replace),
        bool(counts),
        bool(header),
        bool(doubles),
    )
    report = c.sarsim_file_report(ctypes.sizeof(c.sarsim_file_report))
    remarks = work(
        lib.sarsim_record_file,
        plan._handle,
        _convert.path(path),
        byref(options),
        WORK,
        byref(report),
        threads=threads,
        progress=progress,
    )
    members: "Dict[str, Any]" = {name: getattr(report, name) for name, *_ in c.sarsim_file_report._fields_[1:]}
    return FileReport(**members, remarks=Problems([*plan.remarks, *remarks]))


