"""Scenes and the objects in them."""

from __future__ import annotations

import ctypes
import os
import pathlib
from ctypes import byref
from typing import TYPE_CHECKING, Any, Dict, Generic, Iterator, List, Mapping, Sequence, Type, TypeVar, Union, overload

import numpy as np

from . import _convert
from . import _declarations as c
from ._fields import Part, Points
from ._library import WORK, Handle, Progress, WithWork, call, lib, made, text_of, texts, work
from .problems import ProblemError, Problems

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._objects import Atmosphere, Cloud, Geometry, Options, Platform, Radar, Surface, Target  # noqa: F401
    from ._objects import Recording as RecordingFields
    from .recording import FileReport, Recording

Path = Union[str, "os.PathLike[str]"]


class SceneObject(Part):
    """An object of a scene: the one at this place of its list. Its attributes are its fields."""

    __slots__ = ("_of", "_index")
    _kind = ""
    _of: "Scene"
    _index: int

    def __init__(self, scene: "Scene", index: int = 0) -> None:
        object.__setattr__(self, "_of", scene)
        object.__setattr__(self, "_index", index)

    @property
    def _scene(self) -> "Scene":
        return self._of

    @property
    def _address(self) -> str:
        """What precedes the point in the names of its fields: "Radar1"."""
        return text_of(lib.sarsim_scene_name, self._of._handle, self._kind.encode(), self._index)

    def _name(self, field: str) -> str:
        return f"{self._address}.{field}"

    def __eq__(self, other: object) -> bool:
        return type(other) is type(self) and other._of is self._of and other._index == self._index  # type: ignore

    def __hash__(self) -> int:
        return hash((self._kind, self._index))

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self._address}>"

    def _repr_html_(self) -> str:
        from ._show import fields_html

        return fields_html(self)

    def fields(self) -> "Dict[str, str]":
        """The fields that mean something as the object is, with their values as texts with units."""
        prefix = self._name("")
        return {field["name"][len(prefix) :]: field["value"] for field in self._facts()}

    def _facts(self) -> "List[Dict[str, Any]]":
        import json

        facts: "List[Dict[str, Any]]" = json.loads(
            text_of(lib.sarsim_scene_fields, self._of._handle, self._kind.encode(), self._index)
        )
        return facts


class LoneObject(SceneObject):
    """What a scene has once: its atmosphere, its options."""

    __slots__ = ()

    @property
    def _address(self) -> str:
        return self._kind

    def _name(self, field: str) -> str:
        return field if self._kind == "options" else f"{self._kind.title()}.{field}"


T = TypeVar("T", bound=SceneObject)


class ObjectList(Sequence[T], Generic[T]):
    """The objects of one kind, in their order; by number from 0 or by name."""

    def __init__(self, scene: "Scene", kind: "Type[T]") -> None:
        self._scene = scene
        self._kind = kind

    def __len__(self) -> int:
        count = ctypes.c_size_t()
        call(lib.sarsim_scene_count, self._scene._handle, self._kind._kind.encode(), byref(count))
        return count.value

    @property
    def names(self) -> "List[str]":
        """What precedes the point in the names of their fields: "Radar1", "Target3"."""
        return [one._address for one in self]

    @overload
    def __getitem__(self, which: "int | str") -> T: ...
    @overload
    def __getitem__(self, which: slice) -> "List[T]": ...
    def __getitem__(self, which: "int | str | slice") -> "T | List[T]":
        if isinstance(which, slice):
            return [self._kind(self._scene, index) for index in range(*which.indices(len(self)))]
        if isinstance(which, str):
            return self._kind(self._scene, self._called(which))
        count = len(self)
        number = _convert.whole(which, f"the number of a {self._kind._kind}", -(2**63), 2**63)
        if not -count <= number < count:
            raise IndexError(f"the scene has {count} of the kind {self._kind._kind}, and no number {number}")
        return self._kind(self._scene, number % count)

    def _called(self, name: str) -> int:
        names = self.names
        if name not in names:
            raise KeyError(f"no {self._kind._kind} is called {name!r}; there is {', '.join(names) or 'none'}")
        return names.index(name)

    def __iter__(self) -> "Iterator[T]":
        return (self._kind(self._scene, index) for index in range(len(self)))

    def __contains__(self, which: object) -> bool:
        return which in self.names if isinstance(which, str) else super().__contains__(which)

    def __repr__(self) -> str:
        names = self.names if len(self) <= 8 else [*(one._address for one in self[:3]), "...", self[-1]._address]
        return f"[{', '.join(names)}]"

    def _ipython_key_completions_(self) -> "List[str]":
        return self.names

    def add(self, name: "str | None" = None, **fields: Any) -> T:
        """Adds an object at the end, with the values that a new one has, and sets these fields in their order.

        :param name: of a platform or radar, or the file of a recording; None: one that is free
        """
        changed = self._scene.copy()
        index = ctypes.c_size_t()
        told = None if name is None else _convert.text(name, "the name")
        call(lib.sarsim_scene_add, changed._handle, self._kind._kind.encode(), told, byref(index))
        new = self._kind(changed, index.value)
        for field, value in fields.items():
            setattr(new, field, value)
        self._scene._take(changed)
        return self._kind(self._scene, index.value)

    def remove(self, which: "T | int | str") -> None:
        """Removes an object. With a platform goes what stands on it, with a radar its recordings."""
        if isinstance(which, SceneObject) and not (isinstance(which, self._kind) and which._of is self._scene):
            raise ValueError(f"{which!r} is no {self._kind._kind} of this scene")
        index = which._index if isinstance(which, SceneObject) else self[which]._index
        call(lib.sarsim_scene_remove, self._scene._handle, self._kind._kind.encode(), index)

    __delitem__ = remove


class TargetList(ObjectList["Target"]):
    """The targets of a scene."""

    def add_many(self, positions_m: ArrayLike, rcs_m2: "ArrayLike | None" = None, *, platform: str = "Earth") -> None:
        """Adds a target for each row of positions_m, of the shape (n, 3), in the frame of a platform.

        :param rcs_m2: a cross-section for each, or one for all; None: 1 m2
        """
        positions, sections = _cloud_arrays(positions_m, rcs_m2)
        call(
            lib.sarsim_scene_add_targets,
            self._scene._handle,
            _convert.text(platform, "platform"),
            len(positions),
            positions.ctypes.data,
            None if sections is None else sections.ctypes.data,
        )


class CloudList(ObjectList["Cloud"]):
    """The clouds of a scene: many points that are alike in all but place and cross-section."""

    def add_points(
        self,
        positions_m: ArrayLike,
        rcs_m2: "ArrayLike | None" = None,
        *,
        platform: str = "Earth",
        file: "str | None" = None,
    ) -> "Cloud":
        """Adds a cloud of points, of which positions_m has a row each: shape (n, 3). A point takes 32 bytes.

        :param rcs_m2: a cross-section for each, or one for all; None: 1 m2
        :param file:   of the points beside the scene's text: "ship.npy". It is written by Scene.write. None: one that is
                       free
        """
        positions, sections = _cloud_arrays(positions_m, rcs_m2)
        name = f"cloud{len(self) + 1}.npy" if file is None else _convert.text(file, "file").decode("utf-8", "surrogateescape")
        call(
            lib.sarsim_scene_add_cloud,
            self._scene._handle,
            _convert.text(platform, "platform"),
            _convert.text(name, "file"),
            len(positions),
            positions.ctypes.data,
            None if sections is None else sections.ctypes.data,
        )
        ones = np.ones(len(positions)) if sections is None else sections
        self._scene._points[name] = np.column_stack([positions, ones])
        return self[-1]


def _cloud_arrays(positions_m: ArrayLike, rcs_m2: "ArrayLike | None") -> "tuple[np.ndarray, np.ndarray | None]":
    positions = _convert.points(positions_m, "positions")
    return positions, None if rcs_m2 is None else _convert.one_for_each(rcs_m2, len(positions), "cross-sections")


class Scene:
    """What is simulated: platforms that move, targets and surfaces on them, radars, recordings.

    Without a text the scene is empty. A text is in format 2 (TOML) or in the script language. What has no attributes here, a
    world on the turning Earth, legs and waypoints of a path, is said in the text.

    :param text: of the scene
    :param name: of a file that need not exist: problems have it as their place, and data files are looked for in its folder
    :param let:  values for names of [let]: {"height": "3 km"}
    """

    def __init__(self, text: "str | None" = None, *, name: str = "scene.toml", let: "Mapping[str, Any] | None" = None) -> None:
        given_name = _convert.path(name, "the name of the scene")
        self._name = os.fsdecode(given_name)
        self._points: "Dict[str, np.ndarray]" = {}
        self._handle = Handle(lib.sarsim_scene_free)
        self.remarks = Problems()
        """Warnings and notes about its text and the files that it names."""
        if text is None:
            self.remarks = call(lib.sarsim_scene_new, given_name, self._handle.out)
        else:
            if not isinstance(text, str):
                raise TypeError(f"the text of the scene is {type(text).__name__}; expected a text, or sarsim.read of a file")
            whole = text.encode("utf-8", "surrogateescape")
            arguments = (lib.sarsim_scene_read_text, whole, len(whole), given_name)
            if len(whole) > _LONG_TEXT:
                self.remarks = work(*arguments, WithWork(lambda how: _reading(let, how)), self._handle.out)
            else:
                self.remarks = call(*arguments, _reading(let, None), self._handle.out)

    @classmethod
    def read(cls, path: Path, *, let: "Mapping[str, Any] | None" = None) -> "Scene":
        """Reads a scene file in either language, with the files that it includes and names."""
        scene = cls.__new__(cls)
        name = _convert.path(path)
        scene._name = os.fsdecode(name)
        scene._points = {}
        scene._handle = Handle(lib.sarsim_scene_free)
        options = WithWork(lambda how: _reading(let, how))
        scene.remarks = work(lib.sarsim_scene_read_file, name, options, scene._handle.out)
        return scene

    # Objects

    def _list(self, kind: str) -> Any:
        from . import _objects

        return ObjectList(self, getattr(_objects, kind))

    @property
    def platforms(self) -> "ObjectList[Platform]":
        """Frames that carry targets and radars."""
        return self._list("Platform")  # type: ignore[no-any-return]

    @property
    def targets(self) -> TargetList:
        """Points that reflect."""
        from ._objects import Target

        return TargetList(self, Target)

    @property
    def clouds(self) -> CloudList:
        """Many points that are alike in all but place and cross-section."""
        from ._objects import Cloud

        return CloudList(self, Cloud)

    @property
    def surfaces(self) -> "ObjectList[Surface]":
        """Triangles that reflect."""
        return self._list("Surface")  # type: ignore[no-any-return]

    @property
    def radars(self) -> "ObjectList[Radar]":
        """Transmitters and receivers."""
        return self._list("Radar")  # type: ignore[no-any-return]

    @property
    def recordings(self) -> "ObjectList[RecordingFields]":
        """Recordings to be made."""
        return self._list("Recording")  # type: ignore[no-any-return]

    @property
    def geometries(self) -> "ObjectList[Geometry]":
        """Tables of delays, amplitudes and speeds to be made."""
        return self._list("Geometry")  # type: ignore[no-any-return]

    @property
    def atmosphere(self) -> "Atmosphere":
        """What lies between radars and targets: air, rain, the ionosphere."""
        from ._objects import Atmosphere

        return Atmosphere(self)

    @property
    def options(self) -> "Options":
        """What holds for everything that is made of the scene: seed, profile, tolerance."""
        from ._objects import Options

        return Options(self)

    # Fields by name

    def get(self, field: str) -> str:
        """The value of a field as a text with its unit. `field` is a name as `sarsim run --set` takes it."""
        return text_of(lib.sarsim_scene_get, self._handle, _field(field))

    def number(self, field: str) -> float:
        """The value of a numeric field in the base unit of the language: SI, angles in degrees, ratios in dB."""
        value = ctypes.c_double()
        call(lib.sarsim_scene_get_number, self._handle, _field(field), byref(value))
        return value.value

    def set(self, field: str, value: str) -> Problems:
        """Sets a field to a text as `sarsim run --set` does; "Target*.rcs" means all targets. Gives what is worth knowing."""
        return call(lib.sarsim_scene_set, self._handle, _field(field), _convert.text(value, str(field)))

    def set_points(self, field: str, points: Points) -> None:
        """Sets a function given by points: a pulse, a pattern, a track."""
        values = np.ascontiguousarray(np.atleast_2d(points.y.T))  # All of the first part before the second.
        call(
            lib.sarsim_scene_set_points,
            self._handle,
            _field(field),
            len(points.x),
            len(values),
            points.x.ctypes.data,
            values.ctypes.data,
            _convert.text({"low-pass": "mfilter"}.get(points.method, points.method), "the method"),
        )

    def __getitem__(self, field: str) -> "float | str":
        """The value of a field: a number in its base unit where it is one, else a text."""
        try:
            return self.number(field)
        except ProblemError:
            return self.get(field)

    def __setitem__(self, field: str, value: Any) -> None:
        """Sets a field to a number in its base unit, a text, yes or no, or to points."""
        value = _convert.plain(value)
        if isinstance(value, Points):
            self.set_points(field, value)
        elif isinstance(value, (bool, np.bool_)):
            self.set(field, "yes" if value else "no")
        elif _convert.is_number(value):
            call(lib.sarsim_scene_set_number, self._handle, _field(field), _convert.real(value, str(field)))
        elif isinstance(value, SceneObject):
            self.set(field, str(value["name"]))
        elif isinstance(value, (str, os.PathLike)):
            self.set(field, os.fspath(value))
        else:
            raise TypeError(
                f"{field} cannot be set to {type(value).__name__}; expected a number, a text, yes or no, or sarsim.Points"
            )

    def with_(self, fields: "Mapping[str, Any] | None" = None, **options: Any) -> "Scene":
        """A copy with other values: scene.with_({"Radar1.power": "2 kW"}, seed=3)."""
        changed = self.copy()
        for field, value in {**(fields or {}), **options}.items():
            changed[field] = value
        return changed

    # Text, copies, comparison

    def text(self, language: str = "format 2") -> str:
        """The scene as it is now, in "format 2" or as a "script" of 1998. Comments are not in it."""
        if language not in ("format 2", "script"):
            raise ValueError(f"language {language!r}; expected 'format 2' or 'script'")
        return text_of(lib.sarsim_scene_text, self._handle, c.SARSIM_SCRIPT if language == "script" else c.SARSIM_FORMAT_2)

    def write(self, path: Path) -> None:
        """Writes the scene as a text, with the points of clouds that were given as arrays: a script where the name ends in
        ".scr", else format 2."""
        path = pathlib.Path(path)
        whole = self.text("script" if path.suffix == ".scr" else "format 2")
        for name, points in self._points.items():
            with open(path.parent / name, "wb") as file:
                np.save(file, points)
        path.write_text(whole, encoding="utf-8", errors="surrogateescape")

    def copy(self) -> "Scene":
        """A scene that can be changed without changing this one."""
        other = type(self).__new__(type(self))
        other._name = self._name
        other._points = dict(self._points)
        other.remarks = self.remarks
        other._handle = made(lib.sarsim_scene_free, lib.sarsim_scene_copy, self._handle)
        return other

    __copy__ = copy

    def __deepcopy__(self, memo: Any) -> "Scene":
        return self.copy()

    def _take(self, other: "Scene") -> None:
        """Becomes another scene."""
        self._handle, self._points = other._handle, other._points

    def __reduce__(self) -> Any:
        if self._points:
            raise TypeError(
                f"the points of {', '.join(self._points)} are in memory alone, and other processes have not; "
                "write the scene to a file and read it again"
            )
        return _scene_of, (self.text(), os.path.abspath(self._name))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scene) and self.text() == other.text()

    __hash__ = None  # type: ignore[assignment]

    def _counts(self) -> "Dict[str, int]":
        words = ("platforms", "targets", "clouds", "surfaces", "radars", "recordings")
        return {word: len(getattr(self, word)) for word in words}

    def __repr__(self) -> str:
        told = [f"{count} {word[:-1] if count == 1 else word}" for word, count in self._counts().items() if count]
        return f"<Scene {self._name}: {', '.join(told) or 'empty'}>"

    def _repr_html_(self) -> str:
        from ._show import scene_html

        return scene_html(self)

    # Work

    def check(self, *, threads: int = 0, progress: Progress = None) -> Problems:
        """Everything that is wrong with the scene or worth knowing about its echoes, as `sarsim check` lists it."""
        try:
            return work(lib.sarsim_scene_check, self._handle, WORK, threads=threads, progress=progress)
        except ProblemError as error:
            return error.problems

    def record(
        self, number: "int | str" = 1, *, dtype: Any = np.complex64, threads: int = 0, progress: Progress = None
    ) -> "Recording":
        """Computes a recording: an array of complex samples in volts, a row for each pulse, with its axes.

        The samples are those of the HDF5 and NPY files of `sarsim run`, bit for bit.

        :param number:   of the recording, from 1 as the commands count, or the name of its file
        :param dtype:    numpy.complex64 or numpy.complex128
        :param threads:  0: one for each core
        :param progress: True: a bar by tqdm where it is installed, else a line; or a function of stage, done and total
        """
        from .recording import record

        return record(self, number, dtype=dtype, threads=threads, progress=progress)

    def rows(
        self, number: "int | str" = 1, *, block: int = 0, dtype: Any = np.complex64, threads: int = 0
    ) -> "Iterator[tuple[int, np.ndarray]]":
        """The rows of a recording in blocks, as they are computed: (number of the first row, samples). Memory does not grow
        with the recording.

        :param block: rows of a block; 0: as many as make a few megabytes
        """
        from .recording import rows

        return rows(self, number, block=block, dtype=dtype, threads=threads)

    def record_file(self, path: Path, number: "int | str" = 1, **options: Any) -> "FileReport":
        """Makes the file of a recording: the bytes that `sarsim run` writes. It appears when it is complete.

        Options: format ("hdf5", "npy", "csv", "ascii", "bracket", "binary"; else by the ending of the name), replace,
        counts, header, doubles, threads, progress.
        """
        from .recording import record_file

        return record_file(self, path, number, **options)


def _field(name: str) -> bytes:
    return _convert.text(name, "the name of a field")


_LONG_TEXT = 1 << 20  # Bytes whose reading somebody may want to interrupt.


def _reading(values: "Mapping[str, Any] | None", how: Any) -> Any:
    """Options of reading, which keep alive what they point at."""
    if not values and how is None:
        return None
    words = texts([f"{name}={_convert.word(value, f'the value of {name}')}" for name, value in (values or {}).items()])
    size = ctypes.sizeof(c.sarsim_scene_options)
    options = c.sarsim_scene_options(
        size, ctypes.addressof(words), len(values or {}), None if how is None else ctypes.addressof(how)
    )
    options.kept = (words, how)
    return byref(options)


def _scene_of(whole: str, name: str) -> Scene:
    return Scene(whole, name=name)


def read(path: Path, *, let: "Mapping[str, Any] | None" = None) -> Scene:
    """Reads a scene file in either language, with the files that it includes and names."""
    return Scene.read(path, let=let)


def explain(word: str = "") -> str:
    """Explains a field, a choice, a kind of object or a word of format 2, as `sarsim explain` does."""
    return text_of(lib.sarsim_explain, _convert.text(word, "the word"), c.SARSIM_WORDS)
