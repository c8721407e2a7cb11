"""What is made of echoes: images, profiles, maps, tables. The work of the commands of the same names."""

from __future__ import annotations

import ctypes
import json
import os
from ctypes import byref
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, Tuple, Union

import numpy as np

from . import _convert
from . import _declarations as c
from ._library import WORK, Handle, Progress, _decoded, call, lib, made, text_of, texts, work
from .problems import Problems
from .recording import Recording
from .samples import Axis, Samples
from .scene import Scene
from .table import Table, take_table

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .scene import Path

Source = Union[Recording, "Raster", Scene, str, "os.PathLike[str]"]
"""Echoes to work on: a recording in memory, one in a file (by its name, or opened), or a scene, which is simulated."""


class Raster(Samples):
    """Samples of a file or of work that was done. They are read when they are asked for."""

    def __init__(self, handle: Handle) -> None:
        self._handle = handle
        info = c.sarsim_raster_info(ctypes.sizeof(c.sarsim_raster_info))
        call(lib.sarsim_raster_get_info, handle, byref(info))
        self.path = _decoded(info.path)
        """The file; "" in memory."""
        self.format = _decoded(info.format)
        """Of the file: "hdf5"."""
        self._size: "Tuple[int, int]" = (info.rows, info.columns)
        self._complex = info.value == c.SARSIM_COMPLEX
        self._whole: "np.ndarray | None" = None
        attributes = {
            _decoded(lib.sarsim_raster_attribute_name(handle, index)): _decoded(
                lib.sarsim_raster_attribute_value(handle, index)
            )
            for index in range(info.attributes)
        }
        super().__init__([_axis(handle, index) for index in range(info.axes)], attributes)

    @classmethod
    def of(
        cls,
        samples: "ArrayLike",
        axes: "Mapping[str, ArrayLike] | None" = None,
        attributes: "Mapping[str, str] | None" = None,
    ) -> "Raster":
        """An array of your own as samples that can be saved with their axes.

        :param samples:    complex, in volts, or real: rows, columns. They are not copied where they are complex64 or float32
        :param axes:       by name: pulse_time_s, carrier_hz, azimuth_m, cross_range_m, y_m of rows; slant_range_m,
                           ground_range_m, x_m of columns
        :param attributes: what a file says of them: script, radar, sample_rate_hz, bits, lsb_v
        """
        whole = _convert.samples(samples, "samples")
        handle = made(
            lib.sarsim_raster_free,
            lib.sarsim_raster_of_floats,
            whole.ctypes.data,
            *whole.shape,
            int(np.iscomplexobj(whole)),
        )
        for name, values in (axes or {}).items():
            places = _convert.reals(values, f"axis {name}")
            if places.ndim != 1:
                raise ValueError(f"axis {name} has the shape {places.shape}; expected one dimension")
            call(lib.sarsim_raster_set_axis, handle, _convert.text(name, "an axis"), places.ctypes.data, places.size)
        for name, value in (attributes or {}).items():
            told = _convert.word(value, f"attribute {name}").encode("utf-8", "surrogateescape")
            call(lib.sarsim_raster_set_attribute, handle, _convert.text(name, "an attribute"), told)
        raster = cls(handle)
        raster._whole = whole  # Which the handle looks at.
        return raster

    @property
    def shape(self) -> "Tuple[int, int]":
        """Rows, columns."""
        return self._size

    @property
    def dtype(self) -> np.dtype:
        """complex64, or float32 where the samples are real."""
        return np.dtype(np.complex64 if self._complex else np.float32)

    @property
    def samples(self) -> np.ndarray:
        """All samples, read once: in volts, or counts as they are."""
        if self._whole is None:
            self._whole = self.window()
        return self._whole

    def window(self, rows: "slice | None" = None, columns: "slice | None" = None) -> np.ndarray:
        """Some rows and columns, read from the file: window(slice(0, 100), slice(None, None, 4))."""
        for part in (rows, columns):
            if part is not None and not isinstance(part, slice):
                raise TypeError(f"a window is made of slices, not of {part!r}")
        places = [(slice(None) if part is None else part).indices(count) for part, count in zip((rows, columns), self._size)]
        counts = [len(range(*place)) for place in places]
        if any(step < 0 for _, _, step in places):
            raise ValueError("a window runs forwards")
        if 0 in counts:
            return np.empty(counts, self.dtype)
        (row, _, row_step), (column, _, column_step) = places
        window = c.sarsim_window(
            ctypes.sizeof(c.sarsim_window), row, counts[0], column, counts[1], row_step, column_step
        )
        pairs = np.empty(counts, np.complex64)
        work(lib.sarsim_raster_read_float, self._handle, byref(window), pairs.ctypes.data, WORK)
        return pairs if self._complex else pairs.real.copy()

    def save(self, path: "Path", *, threads: int = 0, progress: Progress = None, **options: Any) -> None:
        """Writes the samples to a file in the format of its ending, with axes and attributes as far as it has place for
        them. It appears when it is complete. `sarsim.options("write")` lists the options."""
        words = _words(options)
        work(
            lib.sarsim_raster_write,
            self._handle,
            _convert.path(path),
            texts(words),
            len(words),
            WORK,
            threads=threads,
            progress=progress,
        )


class Image(Raster):
    """An image or map that was made of echoes."""

    def __init__(self, handle: Handle, report: "Dict[str, Any]", tables: "List[Table]", remarks: Problems) -> None:
        super().__init__(handle)
        self.report = report
        """What the command prints with --json."""
        self.tables = tables
        """Targets of range profiles, detections of maps."""
        self.remarks = remarks
        """What is worth knowing."""

    def measure(self, **options: Any) -> Table:
        """Measures the point targets of the image, each beside its theory: see `sarsim.measure`."""
        return measure(self, **options)


def _axis(handle: Handle, index: int) -> Axis:
    info = c.sarsim_axis_info(ctypes.sizeof(c.sarsim_axis_info))
    call(lib.sarsim_raster_axis_info, handle, index, byref(info))
    values = np.empty(info.count)
    call(lib.sarsim_raster_axis, handle, index, 0, info.count, values.ctypes.data)
    return Axis(_decoded(info.name), _decoded(info.unit), bool(info.of_columns), values)


def open(path: "Path", **options: Any) -> Raster:  # noqa: A001  (sarsim.open)
    """Opens a file of samples of any format that Sarsim reads: recordings, images, pictures. `sarsim.options("raster")`
    lists what can be said of a file that does not describe itself."""
    words = _words(options)
    opened = Handle(lib.sarsim_raster_free)
    work(lib.sarsim_raster_open, _convert.path(path), texts(words), len(words), WORK, opened.out)
    return Raster(opened)


def options(work_name: str) -> str:
    """What options "focus", "profiles", "isar", "doppler", "search", "measure", "geometry", "theory", "export", "sweep",
    "raster" or "write" take. In Python a hyphen in a name is an underscore, and an option without a value is True."""
    return text_of(lib.sarsim_options, _convert.text(work_name, "the name of work"), c.SARSIM_WORDS)


def _words(given: "Mapping[str, Any]") -> "List[str]":
    """Options as the command has them: NAME=VALUE."""
    return _convert.words(given.items())


def _source(what: Source, number: "int | str | None") -> "Tuple[Handle, Any]":
    """Echoes to work on, and what has to be kept meanwhile."""
    if isinstance(what, Recording):
        samples = np.ascontiguousarray(what.samples)
        of_memory = lib.sarsim_source_floats if samples.dtype == np.complex64 else lib.sarsim_source_doubles
        return made(lib.sarsim_source_free, of_memory, what.plan._handle, samples.ctypes.data), samples
    if isinstance(what, Scene):
        from .recording import _number_of

        which = 0 if number is None else _number_of(what, number)
        return made(lib.sarsim_source_free, lib.sarsim_source_scene, what._handle, which), what
    path = _convert.path(what.path if isinstance(what, Raster) else what, "the source of the echoes")
    if not path:
        raise ValueError("the samples are in memory alone; write them to a file first")
    return made(lib.sarsim_source_free, lib.sarsim_source_file, path), None


class _Done:
    """What work came to."""

    def __init__(self, function: Any, what: Any, given: "Dict[str, Any]") -> None:
        threads, progress = given.pop("threads", 0), given.pop("progress", None)
        number = given.pop("recording", None)
        of_itself = function in (lib.sarsim_measure, lib.sarsim_sweep)  # Not of its echoes.
        handle, kept = (what._handle, what) if of_itself else _source(what, number)
        words = _words(given)
        result = Handle(lib.sarsim_result_free)
        self.remarks = work(
            function, handle, texts(words), len(words), WORK, result.out, threads=threads, progress=progress
        )
        del kept
        self.report: "Dict[str, Any]" = json.loads(_decoded(lib.sarsim_result_json(result)))
        self.rasters = [
            made(lib.sarsim_raster_free, lib.sarsim_result_raster, result, index)
            for index in range(lib.sarsim_result_raster_count(result))
        ]
        self.tables = [
            take_table(made(lib.sarsim_table_free, lib.sarsim_result_table, result, index))
            for index in range(lib.sarsim_result_table_count(result))
        ]

    def images(self) -> "List[Image]":
        return [Image(handle, self.report, self.tables, self.remarks) for handle in self.rasters]


def focus(what: Source, **options: Any) -> Image:
    """Focuses echoes to a SAR image, as `sarsim focus` does.

    focus(recording, algorithm="back-projection", window="hann", autofocus=True). `sarsim.options("focus")` lists the
    options; besides there are `recording` (number of a scene's, from 1), `threads` and `progress`.
    """
    return _Done(lib.sarsim_focus, what, options).images()[0]


def export(what: Source, path: Path, **options: Any) -> "Dict[str, Any]":
    """Writes echoes as a file of a standard that programs of others read: CPHD or CRSD, as the ending of the path says.

    export(scene, "flight.cphd", anchor="47.5,8.25,400", encoding="ci4"). `sarsim.options("export")` lists the options.
    Gives the numbers of vectors and samples.
    """
    return _Done(lib.sarsim_export, what, {**options, "out": os.fsdecode(_convert.path(path))}).report


def profiles(what: Source, **options: Any) -> Image:
    """Range profiles of a stepped carrier, one in each row, as `sarsim profiles` makes them."""
    return _Done(lib.sarsim_profiles, what, options).images()[0]


def isar(what: Source, **options: Any) -> "List[Image]":
    """Images of a turning target, as `sarsim isar` makes them."""
    return _Done(lib.sarsim_isar, what, options).images()


def doppler(what: Source, **options: Any) -> Image:
    """Range-Doppler maps, one below the other, with their detections in `tables`, as `sarsim doppler` makes them."""
    return _Done(lib.sarsim_doppler, what, options).images()[0]


def search(what: Source, **options: Any) -> Image:
    """The picture of a rotating antenna, with its detections in `tables`, as `sarsim search` makes it."""
    return _Done(lib.sarsim_search, what, options).images()[0]


def measure(image: Raster, **options: Any) -> Table:
    """Measures the point targets of an image that `focus` made: a row for each, found values beside their theory."""
    return _Done(lib.sarsim_measure, image, options).tables[0]


def theory(what: Source, **options: Any) -> Table:
    """What theory says of the targets in the image that `focus` would make with these options. Reads no echoes."""
    return _Done(lib.sarsim_theory, what, options).tables[0]


def geometry(what: Source, **options: Any) -> Table:
    """Where platforms and targets are, pulse by pulse, as `sarsim geometry` says it."""
    return _Done(lib.sarsim_geometry, what, options).tables[0]


def sweep_table(scene: Scene, **options: Any) -> Table:
    """Runs a scene with many values as `sarsim sweep` does: a table with a row for each variation.

    sweep_table(scene, set=["seed=1..100"], discard=True, focus=True, measure=True) measures a hundred images. Its table, its
    journal and the recordings go to the folder `out`, by default the current one; `discard` leaves the recordings out.
    `sarsim.sweep` calls a function of your own instead.
    """
    return _Done(lib.sarsim_sweep, scene, options).tables[0]
