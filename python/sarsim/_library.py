"""libsarsim.so.0: where it is, how its functions are called, what becomes of its handles and problems."""

from __future__ import annotations

import _thread
import ctypes
import os
import pathlib
import threading
import time
import weakref
from ctypes import byref, c_void_p
from typing import Any, Callable, Union

from . import _convert
from . import _declarations as c
from .problems import FailedError, Problem, ProblemError, Problems, TryAgainError

SONAME = "libsarsim.so.0"


def _load() -> ctypes.CDLL:
    """The library that $SARSIM_LIBRARY names, the one in this folder, or that of the system."""
    beside = pathlib.Path(__file__).with_name(SONAME)
    named = os.environ.get("SARSIM_LIBRARY") or (str(beside) if beside.exists() else SONAME)
    try:
        library = ctypes.CDLL(named)
    except OSError as error:
        raise ImportError(
            f"sarsim needs its library: {error}. Install the package libsarsim0, or name the file in SARSIM_LIBRARY."
        ) from error
    library.sarsim_abi_version.restype = ctypes.c_int
    number = library.sarsim_abi_version()
    if number < c.ABI_VERSION:
        raise ImportError(f"{named} is too old: its interface is number {number}, this package needs {c.ABI_VERSION}")
    for name, (result, arguments) in c.FUNCTIONS.items():
        function = getattr(library, name)
        function.restype = result
        function.argtypes = arguments
    return library


lib = _load()


class Handle:
    """A handle of the library, which is given back when nobody has it any more.

    It exists before the function that fills it in is called, and is freed by a weak reference whose callback is the
    library's function itself. So there is no moment at which an interrupt could lose it, and no Python code in which one
    could be swallowed, as it is in __del__ and in callbacks of ctypes.
    """

    __slots__ = ("_as_parameter_", "__weakref__")

    def __init__(self, free: Any) -> None:
        self._as_parameter_ = c_void_p()
        reference = _Freeing(self, free)
        reference._as_parameter_ = self._as_parameter_
        _Freeing.kept.add(reference)
        if len(_Freeing.kept) > 2 * _Freeing.alive:
            _Freeing.forget()

    def __bool__(self) -> bool:
        return self._as_parameter_.value is not None

    @property
    def out(self) -> Any:
        """The place that a function puts its result in."""
        return byref(self._as_parameter_)


class _Freeing(weakref.ref):  # type: ignore[type-arg]
    __slots__ = ("_as_parameter_",)
    _as_parameter_: c_void_p
    __hash__ = object.__hash__
    __eq__ = object.__eq__
    kept: "set[_Freeing]" = set()
    alive = 256

    @classmethod
    def forget(cls) -> None:
        """Drops the references whose handles are gone."""
        for reference in list(cls.kept):
            if reference() is None:
                cls.kept.discard(reference)
        cls.alive = max(256, len(cls.kept))


def texts(values: "list[str]") -> Any:
    """An array of texts of `_convert`; keeps them alive."""
    return (ctypes.c_char_p * max(1, len(values)))(*(_convert.text(value, "an option") for value in values))


def _decoded(value: "bytes | None") -> str:
    return (value or b"").decode("utf-8", "surrogateescape")


def take_text(handle: Handle) -> str:
    return _decoded(lib.sarsim_text_chars(handle))


_PROBLEM_TEXTS = ("message", "found", "expected", "hint", "file", "object", "field", "text")
_SEVERITIES = {c.SARSIM_ERROR: "error", c.SARSIM_WARNING: "warning", c.SARSIM_NOTE: "note"}


def _taken(found: Handle) -> Problems:
    """A list of problems as Python has it."""
    problems = Problems()
    for index in range(lib.sarsim_problems_count(found) if found else 0):
        one = c.sarsim_problem(ctypes.sizeof(c.sarsim_problem))
        lib.sarsim_problems_get(found, index, byref(one))
        members: "dict[str, Any]" = {name: _decoded(getattr(one, name)) for name in _PROBLEM_TEXTS}
        members.update({name: getattr(one, name) for name in ("line", "column", "object_index", "count")})
        problems.append(Problem(severity=_SEVERITIES[one.severity], **members))
    return problems


def _finished(status: int, found: Handle) -> Problems:
    """The remarks of a call that succeeded; raises what a failed one means."""
    problems = _taken(found)
    if status == c.SARSIM_OK:
        return problems
    if status == c.SARSIM_NO_MEMORY:
        raise MemoryError(str(problems) or "Sarsim has not enough memory for this")
    if status == c.SARSIM_FAILED:
        raise FailedError(problems)
    if status == c.SARSIM_TRY_AGAIN:
        raise TryAgainError(problems)
    if status == c.SARSIM_STOPPED:
        raise KeyboardInterrupt
    raise ProblemError(problems)


def call(function: Any, *arguments: Any) -> Problems:
    """Calls a function that is quick; gives its remarks, raises what went wrong."""
    found = Handle(lib.sarsim_problems_free)
    return _finished(function(*arguments, found.out), found)


def made(free: Any, function: Any, *arguments: Any) -> Handle:
    """The handle that a quick function makes as the last of its results."""
    handle = Handle(free)
    call(function, *arguments, handle.out)
    return handle


def text_of(function: Any, *arguments: Any) -> str:
    return take_text(made(lib.sarsim_text_free, function, *arguments))


WORK = object()  # Stands for the sarsim_work in the arguments of `work`.


class WithWork:
    """An argument of `work` that is made of the sarsim_work."""

    def __init__(self, make: "Callable[[Any], Any]") -> None:
        self.make = make


_GLANCE_S = 0.05  # Between two looks at the progress.
_START_S = 1.0  # After which a thread that has not begun never will: the interrupt came before it was started.


def work(function: Any, *arguments: Any, threads: int = 0, progress: Any = None) -> Problems:
    """Calls a function that may take long: it can be interrupted and shows how far it is.

    The function runs on a thread of its own, without Python's lock. The main thread waits, because Python runs its signal
    handlers there alone; whatever is raised while it waits (KeyboardInterrupt, SystemExit, the exception of a handler or
    of `progress`) stops the function and goes on from here once it has returned.
    """
    threads = _convert.threads(threads)
    if not (progress is None or isinstance(progress, bool) or callable(progress)):
        raise TypeError(f"progress is {progress!r}; expected True, or a function of stage, done and total")
    found = Handle(lib.sarsim_problems_free)
    stop = made(lib.sarsim_stop_free, lib.sarsim_stop_new)
    seen: "list[tuple[str, int, int]]" = []

    def look(_user: Any, stage: bytes, done: int, total: int) -> None:
        seen[:] = [(stage.decode(), done, total)]

    callback = c.sarsim_progress(look) if progress else c.sarsim_progress()
    how = c.sarsim_work(ctypes.sizeof(c.sarsim_work), threads, stop._as_parameter_, callback, None)
    whole = [
        byref(how) if argument is WORK else argument.make(how) if isinstance(argument, WithWork) else argument
        for argument in arguments
    ]
    if threading.current_thread() is not threading.main_thread() and not progress:
        return _finished(function(*whole, found.out), found)

    status: "list[int]" = []
    began: "list[bool]" = []
    ended: "list[bool]" = []
    done = _thread.allocate_lock()
    done.acquire()

    def run() -> None:
        began.append(True)
        try:
            status.append(function(*whole, found.out))
        finally:
            ended.append(True)
            done.release()

    # Locks and threads of C: those of `threading` are held by Python code, in which an interrupt can leave them locked.
    show = _shower(progress)
    try:
        _thread.start_new_thread(run, ())
        while not done.acquire(timeout=_GLANCE_S):
            show(seen)
        show(seen)
    except BaseException:
        lib.sarsim_stop_request(stop)
        given_up = time.monotonic() + _START_S
        while not ended and (began or time.monotonic() < given_up):
            done.acquire(timeout=0.01)  # Which may have succeeded already, just before the interrupt.
        raise
    finally:
        show(None)
    if not status:
        raise RuntimeError("a call of the library did not return")
    return _finished(status[0], found)


Progress = Union[None, bool, Callable[[str, int, int], object]]


def _shower(progress: Progress) -> "Callable[[list[tuple[str, int, int]] | None], None]":
    """What is done with progress: `progress` itself, or for True a bar by tqdm or a line. Called with None at the end."""
    if not progress:
        return lambda seen: None
    if progress is True:
        from ._progress import bar

        return bar()
    told: "list[tuple[str, int, int]]" = []

    def show(seen: "list[tuple[str, int, int]] | None") -> None:
        if seen and told != seen:
            told[:] = seen
            progress(*told[0])

    return show
