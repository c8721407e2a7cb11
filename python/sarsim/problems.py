"""What is wrong or worth knowing, as the command tells it."""

from __future__ import annotations

import html
from dataclasses import dataclass
from typing import Iterable, List


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong, or worth knowing. Texts are "" and numbers 0 where there is nothing to say."""

    severity: str
    """"error", "warning" or "note"."""
    message: str
    """What is wrong, in words."""
    found: str = ""
    """The text or value that is to blame."""
    expected: str = ""
    """What would have been right."""
    hint: str = ""
    """How to mend it."""
    file: str = ""
    """Where it stands, with `line` and `column` from 1."""
    line: int = 0
    column: int = 0
    object: str = ""
    """The kind of object that it is about: "platform", "target", "radar", ..."""
    object_index: int = 0
    """Which of them, from 0."""
    field: str = ""
    """The field that it is about: "bandwidth_hz"."""
    count: int = 1
    """How often the same cause was met."""
    text: str = ""
    """All of it, as the command prints it."""

    def __str__(self) -> str:
        return self.text or f"{self.severity}: {self.message}"

    __repr__ = __str__

    def _repr_html_(self) -> str:
        colour = {"error": "#b00020", "warning": "#a15c00"}.get(self.severity, "#555")
        return f'<pre style="color:{colour};white-space:pre-wrap;margin:0">{html.escape(str(self))}</pre>'


class Problems(List[Problem]):
    """A list of problems: errors before warnings before notes. Its text is what the command prints."""

    def __init__(self, problems: Iterable[Problem] = ()) -> None:
        super().__init__(problems)

    def _of(self, severity: str) -> "Problems":
        return Problems(problem for problem in self if problem.severity == severity)

    @property
    def errors(self) -> "Problems":
        """Those that keep the scene from being used."""
        return self._of("error")

    @property
    def warnings(self) -> "Problems":
        """What is probably not meant."""
        return self._of("warning")

    @property
    def notes(self) -> "Problems":
        """What is worth knowing."""
        return self._of("note")

    def __str__(self) -> str:
        return "\n".join(map(str, self)) if self else "no problems"

    __repr__ = __str__

    def _repr_html_(self) -> str:
        return "".join(problem._repr_html_() for problem in self) if self else "no problems"


class ProblemError(Exception):
    """Raised where something is wrong; `problems` has all of it."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        super().__init__(problems)
        self.problems = Problems(problems)

    def __str__(self) -> str:
        return str(self.problems)

    def _repr_html_(self) -> str:
        return self.problems._repr_html_()


class UnknownNameError(ProblemError, AttributeError):
    """No field or object has this name; says the nearest one."""


class FailedError(ProblemError, OSError):
    """A failure of the world: a disk that is full, a folder that cannot be written."""


class TryAgainError(ProblemError, BlockingIOError):
    """Nobody's mistake: another process holds what is needed, or the system failed in a way that may pass."""
