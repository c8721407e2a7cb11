"""What people give, as the library takes it: the one place where texts, paths, numbers and arrays are converted.

Each function takes what the value is called in messages. Nothing is dropped in silence: what does not fit is a TypeError
where it is of another kind, a ValueError where it is of the right kind and cannot be taken.
"""

from __future__ import annotations

import numbers
import operator
import os
from typing import Any, Iterable, List

import numpy as np

MOST_THREADS = 65535
"""More than any machine has cores; the library counts them in 32 bits."""


def _kind(value: Any) -> str:
    """What a value is, for messages."""
    if isinstance(value, np.ndarray):
        return f"an array of {value.dtype} of the shape {value.shape}"
    return f"{type(value).__name__} {_short(value)}"


def _short(value: Any) -> str:
    try:
        words = repr(value)
    except Exception:  # noqa: B902  (of somebody's class)
        return ""
    return words if len(words) <= 60 else words[:57] + "..."


def plain(value: Any) -> Any:
    """A scalar of Python in place of an array of no dimensions; everything else as it is."""
    if isinstance(value, np.ma.MaskedArray) and value.ndim == 0 and bool(np.ma.getmaskarray(value)):
        return np.ma.masked
    return value.item() if isinstance(value, np.ndarray) and value.ndim == 0 else value


def text(value: Any, what: str) -> bytes:
    """A text, or a path as a text, in UTF-8. What came from bytes that are none (surrogates) goes back to these bytes."""
    value = plain(value)
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if not isinstance(value, str):
        raise TypeError(f"{what} is {_kind(value)}; expected a text")
    if "\0" in value:
        raise ValueError(f"{what} has a NUL character at {value.index(chr(0))}: {_short(value)}; texts end there for the library")
    try:
        return value.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError as error:
        raise ValueError(f"{what} has half of a character at {error.start}: {_short(value)}; expected a text") from None


def path(value: Any, what: str = "the path") -> bytes:
    """The name of a file: text, bytes or path."""
    value = plain(value)
    if not isinstance(value, (str, bytes, os.PathLike)):
        raise TypeError(f"{what} is {_kind(value)}; expected the name of a file")
    try:
        name = os.fsencode(value)
    except UnicodeEncodeError as error:
        raise ValueError(f"{what} has half of a character at {error.start}: {_short(value)}; expected a name") from None
    if b"\0" in name:
        raise ValueError(f"{what} has a NUL character: {_short(value)}; no file has such a name")
    return name


def whole(value: Any, what: str, low: int = 0, high: "int | None" = None) -> int:
    """A whole number of Python or NumPy within [low, high]. No yes or no, and no number that only happens to be whole."""
    value = plain(value)
    if isinstance(value, (bool, np.bool_)) or not hasattr(type(value), "__index__") or isinstance(value, np.ndarray):
        raise TypeError(f"{what} is {_kind(value)}; expected a whole number")
    number = operator.index(value)
    if number < low or (high is not None and number > high):
        limits = f"{low} or more" if high is None else f"{low} to {high}"
        raise ValueError(f"{what} is {_short(number)}; expected {limits}")
    return number


def threads(value: Any) -> int:
    """A number of threads; 0 means one for each core."""
    return whole(value, "threads", 0, MOST_THREADS)


def is_number(value: Any) -> bool:
    """Whether a value is a real or complex number, decimal fractions of Python's among them; not yes or no."""
    if isinstance(value, (bool, np.bool_, np.timedelta64, np.datetime64)):
        return False
    return isinstance(value, numbers.Number)


def real(value: Any, what: str) -> float:
    """A real number of Python or NumPy. Complex ones are refused, even without an imaginary part."""
    value = plain(value)
    if not is_number(value):
        raise TypeError(f"{what} is {_kind(value)}; expected a number")
    if isinstance(value, (complex, np.complexfloating)) or not hasattr(value, "__float__"):
        raise TypeError(f"{what} is complex: {_short(value)}; expected a real number, such as its .real")
    try:
        number = float(value)
    except (OverflowError, ValueError):
        raise ValueError(f"{what} is {_short(value)}; expected what a double holds, up to 1.8e308") from None
    if np.isinf(number) and not _is_infinite(value):
        raise ValueError(f"{what} is {_short(value)}; expected what a double holds, up to 1.8e308")
    return number


def _is_infinite(value: Any) -> bool:
    return bool(value == value + 1)  # Also of long doubles and decimals.


def _as_array(values: Any, what: str) -> np.ndarray:
    """Any kind of array, without masked elements."""
    if isinstance(values, (str, bytes)):
        raise TypeError(f"{what} is {_kind(values)}; expected an array of numbers")
    try:
        whole_one = np.ma.asanyarray(values) if np.ma.isMaskedArray(values) else np.asarray(values)
    except (ValueError, TypeError) as error:
        raise ValueError(f"{what} is no array: {error}") from None
    if np.ma.isMaskedArray(whole_one):
        if np.ma.is_masked(whole_one):
            raise ValueError(f"{what} has {int(np.ma.getmaskarray(whole_one).sum())} masked elements; fill or remove them")
        whole_one = np.ma.getdata(whole_one)
    return np.asarray(whole_one)


_ADVICE = {
    "b": "yes and no; use astype(float) where 0 and 1 are meant",
    "c": "complex; use its .real, or give real and imaginary parts apart",
    "M": "dates; use seconds, as in (times - times[0]) / numpy.timedelta64(1, 's')",
    "m": "durations; divide them by numpy.timedelta64(1, 's')",
    "S": "texts; use astype(float)",
    "U": "texts; use astype(float)",
    "V": "structured; use numpy.lib.recfunctions.structured_to_unstructured",
}


def reals(values: Any, what: str) -> np.ndarray:
    """Real numbers in any kind of array as float64 in one piece: native, in the order of C. Floats and whole numbers of any
    width, byte order and stride, and objects that are numbers."""
    given = _as_array(values, what)
    kind = given.dtype.kind
    if kind == "O":
        return np.array([real(one, f"an element of {what}") for one in given.ravel()], np.float64).reshape(given.shape)
    if kind not in "iuf":
        raise TypeError(f"{what} is {_kind(given)}: {_ADVICE.get(kind, 'no numbers')}")
    with np.errstate(over="ignore"):
        converted = np.ascontiguousarray(given, np.float64).reshape(given.shape)
    _expect_same_infinities(given, converted, what, "double")
    return converted


def complexes(values: Any, what: str) -> np.ndarray:
    """Complex numbers as complex128, without masked elements."""
    given = _as_array(values, what)
    if given.dtype.kind not in "iufc":
        raise TypeError(f"{what} is {_kind(given)}: {_ADVICE.get(given.dtype.kind, 'no numbers of one kind')}")
    return np.ascontiguousarray(given, np.complex128).reshape(given.shape)


def points(values: Any, what: str) -> np.ndarray:
    """Real numbers of the shape (n, 3)."""
    whole_one = reals(values, what)
    if whole_one.ndim != 2 or whole_one.shape[1] != 3:
        raise ValueError(f"{what} have the shape {whole_one.shape}; expected (n, 3)")
    return whole_one


def one_for_each(values: Any, count: int, what: str) -> np.ndarray:
    """Real numbers: one for each of `count`, or one for all."""
    given = reals(values, what)
    if given.ndim > 1 or (given.ndim == 1 and len(given) not in (1, count)):
        raise ValueError(f"{what} have the shape {given.shape}; expected one, or ({count},)")
    return np.ascontiguousarray(np.broadcast_to(given, count))


def samples(values: Any, what: str) -> np.ndarray:
    """Rows and columns of samples in one piece: complex64 where they are complex, else float32."""
    given = _as_array(values, what)
    if given.dtype.kind not in "biufc":
        raise TypeError(f"{what} is {_kind(given)}: {_ADVICE.get(given.dtype.kind, 'no array of numbers of one kind')}")
    if given.ndim != 2:
        raise ValueError(f"{what} have the shape {given.shape}; expected rows and columns")
    with np.errstate(over="ignore"):
        converted = np.ascontiguousarray(given, np.complex64 if given.dtype.kind == "c" else np.float32)
    _expect_same_infinities(given, converted, what, "single")
    return converted


def _expect_same_infinities(given: np.ndarray, converted: np.ndarray, what: str, precision: str) -> None:
    if given.dtype.itemsize <= converted.dtype.itemsize or given.dtype.kind not in "fc":
        return
    lost = int((np.isinf(converted) & np.isfinite(given)).sum())
    if lost:
        raise ValueError(f"{what} have {lost} numbers beyond what {precision} precision holds")


def word(value: Any, what: str) -> str:
    """One value of an option as a text: a text, a path, or a number in full precision."""
    value = plain(value)
    if isinstance(value, (str, os.PathLike)):
        return text(value, what).decode("utf-8", "surrogateescape")
    if isinstance(value, np.generic) and is_number(value):
        value = value.item()
    if isinstance(value, numbers.Integral) and not isinstance(value, (bool, np.bool_)):
        return str(int(value))
    if is_number(value):
        real(value, what)  # Refuses complex ones.
        return str(value)
    raise TypeError(f"{what} is {_kind(value)}; expected a text or a number")


def words(given: "Iterable[tuple[str, Any]]") -> "List[str]":
    """Options as the command has them: NAME=VALUE, NAME alone for True, one for each element of a list or array."""
    told: "List[str]" = []
    for given_name, value in given:
        what = f"option {given_name}"
        name = text(given_name, "the name of an option").decode("utf-8", "surrogateescape").rstrip("_").replace("_", "-")
        value = plain(value)
        if value is None:
            continue
        if isinstance(value, (bool, np.bool_)):
            told += [name] if value else []
        elif isinstance(value, np.ndarray) or isinstance(value, (list, tuple)):
            if isinstance(value, np.ndarray) and value.ndim != 1:
                raise TypeError(f"{what} is {_kind(value)}; expected one dimension")
            told += [f"{name}={word(one, what)}" for one in value]
        else:
            told.append(f"{name}={word(value, what)}")
    return told
