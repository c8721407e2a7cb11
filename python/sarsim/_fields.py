"""Fields of objects as attributes. What fields there are, the table in _objects.py says."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Generic, Iterable, List, Tuple, TypeVar, Union, overload

import numpy as np

from . import _convert
from .problems import ProblemError, UnknownNameError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from .scene import Scene

Number = Union[float, str]
"""A number in the base unit of its field (SI; degrees, dB), or a text with a unit: "9.65 GHz"."""


class Points:
    """A function given by points: x ascending, and a value of y for each, or a column of values for each part.

    A pulse has two parts (I and Q), a track three (x, y, z). `method` says how the function runs between its points:
    "linear", "cubic" or "low-pass".
    """

    def __init__(self, x: ArrayLike, y: ArrayLike, method: str = "linear") -> None:
        self.x: NDArray[np.float64] = _convert.reals(x, "x")
        if np.iscomplexobj(y):
            values = _convert.complexes(y, "y")
            y = np.stack([values.real, values.imag], axis=-1)
        self.y: NDArray[np.float64] = _convert.reals(y, "y")
        self.method = method
        if self.x.ndim != 1 or self.y.ndim not in (1, 2) or len(self.y) != len(self.x):
            raise ValueError(f"x has the shape {self.x.shape} and y {self.y.shape}; expected (n,) and (n,) or (n, parts)")

    def __repr__(self) -> str:
        return f"<{len(self.x)} points, {self.method}>"


class Part:
    """Fields with a common name: an object's, or those below a point in their names ("transmit_antenna.pattern")."""

    __slots__ = ("_owner", "_prefix")
    _owner: "Part"
    _prefix: str

    def __init__(self, owner: "Part", prefix: str) -> None:
        object.__setattr__(self, "_owner", owner)
        object.__setattr__(self, "_prefix", prefix)

    @property
    def _scene(self) -> "Scene":
        return self._owner._scene

    def _name(self, field: str) -> str:
        """The whole name of a field, as Scene.get and Scene.set take it."""
        return self._owner._name(f"{self._prefix}.{field}")

    def __getitem__(self, field: str) -> "float | str":
        """The value of a field by any of its names, those of format 2 among them: radar["pulse.width"]."""
        return self._scene[self._name(field)]

    def __setitem__(self, field: str, value: Any) -> None:
        self._scene[self._name(field)] = value

    def __getattr__(self, field: str) -> Any:
        if field.startswith("_"):
            raise AttributeError(field)
        try:
            return self[field]
        except ProblemError as error:
            raise UnknownNameError(error.problems) from None

    def __setattr__(self, field: str, value: Any) -> None:
        known = getattr(type(self), field, None)
        if isinstance(known, (Field, PartField)):
            known.__set__(self, value)
            return
        try:
            self[field] = value
        except ProblemError as error:
            raise UnknownNameError(error.problems) from None

    def __repr__(self) -> str:
        return f"<{self._name('')[:-1]}>"


class Field:
    """One field of the table."""

    def __init__(self, name: str, unit: str = "", doc: str = "") -> None:
        self.name = name
        self.unit = unit
        self.__doc__ = doc

    def __set__(self, part: Part, value: Any) -> None:
        part._scene[part._name(self.name)] = value


class NumberField(Field):
    """A number, in the base unit of its field."""

    @overload
    def __get__(self, part: None, kind: Any = None) -> "NumberField": ...
    @overload
    def __get__(self, part: Part, kind: Any = None) -> float: ...
    def __get__(self, part: "Part | None", kind: Any = None) -> "NumberField | float":
        return self if part is None else part._scene.number(part._name(self.name))

    def __set__(self, part: Part, value: Number) -> None:
        super().__set__(part, value)


class WholeField(Field):
    """A whole number."""

    @overload
    def __get__(self, part: None, kind: Any = None) -> "WholeField": ...
    @overload
    def __get__(self, part: Part, kind: Any = None) -> int: ...
    def __get__(self, part: "Part | None", kind: Any = None) -> "WholeField | int":
        return self if part is None else int(part._scene.get(part._name(self.name)))

    def __set__(self, part: Part, value: "int | str") -> None:
        value = _convert.plain(value)
        if not isinstance(value, str):
            value = str(_convert.whole(value, part._name(self.name), -(2**63), 2**64 - 1))
        super().__set__(part, value)


class TextField(Field):
    """A text, or the name of another object."""

    @overload
    def __get__(self, part: None, kind: Any = None) -> "TextField": ...
    @overload
    def __get__(self, part: Part, kind: Any = None) -> str: ...
    def __get__(self, part: "Part | None", kind: Any = None) -> "TextField | str":
        return self if part is None else part._scene.get(part._name(self.name))

    def __set__(self, part: Part, value: "str | Part") -> None:
        super().__set__(part, value)


class ChoiceField(TextField):
    """One of some words, those of format 2."""

    def __init__(self, name: str, words: "Dict[str, str]", doc: str = "") -> None:
        super().__init__(name, "", doc)
        self.words = tuple(words)
        self._word_of = {shown: word for word, shown in reversed(words.items())}

    @overload
    def __get__(self, part: None, kind: Any = None) -> "ChoiceField": ...
    @overload
    def __get__(self, part: Part, kind: Any = None) -> str: ...
    def __get__(self, part: "Part | None", kind: Any = None) -> "ChoiceField | str":
        if part is None:
            return self
        shown = part._scene.get(part._name(self.name))
        return self._word_of.get(shown, shown)


class ChoiceOrNumberField(ChoiceField):
    """One of some words, or the number that goes with the usual one: a carrier."""

    def __init__(self, name: str, words: "Dict[str, str]", unit: str, doc: str = "") -> None:
        super().__init__(name, words, doc)
        self.unit = unit

    @overload
    def __get__(self, part: None, kind: Any = None) -> "ChoiceOrNumberField": ...
    @overload
    def __get__(self, part: Part, kind: Any = None) -> Any: ...
    def __get__(self, part: "Part | None", kind: Any = None) -> Any:
        if part is None:
            return self
        value = part._scene[part._name(self.name)]
        return self._word_of.get(value, value) if isinstance(value, str) else value

    def __set__(self, part: Part, value: "Number | Part") -> None:
        Field.__set__(self, part, value)


class CheckField(Field):
    """Yes or no."""

    @overload
    def __get__(self, part: None, kind: Any = None) -> "CheckField": ...
    @overload
    def __get__(self, part: Part, kind: Any = None) -> bool: ...
    def __get__(self, part: "Part | None", kind: Any = None) -> "CheckField | bool":
        return self if part is None else part._scene.number(part._name(self.name)) != 0

    def __set__(self, part: Part, value: "bool | str") -> None:
        super().__set__(part, value)


class VectorField(Field):
    """Three numbers: x, y and z, in their base unit."""

    @overload
    def __get__(self, part: None, kind: Any = None) -> "VectorField": ...
    @overload
    def __get__(self, part: Part, kind: Any = None) -> "NDArray[np.float64]": ...
    def __get__(self, part: "Part | None", kind: Any = None) -> "VectorField | NDArray[np.float64]":
        if part is None:
            return self
        values = np.array([part._scene.number(name) for name in self._names(part)])
        values.flags.writeable = False  # It would not change the scene.
        return values

    def __set__(self, part: Part, value: "Iterable[Number]") -> None:
        if isinstance(value, (str, bytes)):
            raise TypeError(f"{part._name(self.name)} is a text; expected three values, x, y and z")
        values = list(value)
        if len(values) != 3:
            raise ValueError(f"{part._name(self.name)} has three values, x, y and z, not {len(values)}")
        changed = part._scene.copy()
        for name, one in zip(self._names(part), values):
            changed[name] = one
        part._scene._take(changed)

    def _names(self, part: Part) -> "List[str]":
        return [part._name(f"{self.name}.{axis}") for axis in "xyz"]


class PointsField(Field):
    """A function given by points. It is set by `Points`, by a pair (x, y), or by the name of a data file."""

    @overload
    def __get__(self, part: None, kind: Any = None) -> "PointsField": ...
    @overload
    def __get__(self, part: Part, kind: Any = None) -> str: ...
    def __get__(self, part: "Part | None", kind: Any = None) -> "PointsField | str":
        return self if part is None else part._scene.get(part._name(self.name))

    def __set__(self, part: Part, value: "Points | Tuple[ArrayLike, ArrayLike] | str") -> None:
        if isinstance(value, str):
            super().__set__(part, value)
            return
        points = value if isinstance(value, Points) else Points(*value)
        part._scene.set_points(part._name(self.name), points)


P = TypeVar("P", bound=Part)


class PartField(Generic[P]):
    """Fields below a point."""

    def __init__(self, name: str, kind: "type[P]", doc: str = "") -> None:
        self.name = name
        self.kind = kind
        self.__doc__ = doc

    @overload
    def __get__(self, part: None, kind: Any = None) -> "PartField[P]": ...
    @overload
    def __get__(self, part: Part, kind: Any = None) -> P: ...
    def __get__(self, part: "Part | None", kind: Any = None) -> "PartField[P] | P":
        return self if part is None else self.kind(part, self.name)

    def __set__(self, part: Part, value: Any) -> None:
        raise AttributeError(f"{self.name} has fields of its own: {', '.join(public(self.kind))}")


def public(kind: type) -> "List[str]":
    """The names of the fields of a class."""
    return [name for name in dir(kind) if not name.startswith("_")]
