"""Progress for people: a bar by tqdm where it is installed, else a line on standard error."""

from __future__ import annotations

import sys
from typing import Any, Callable, Optional

Seen = Optional["list[tuple[str, int, int]]"]


def bar() -> Callable[[Seen], None]:
    """Takes what was seen last, as (stage, done, total) in a list; None at the end."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return _line()
    shown: "dict[str, Any]" = {}

    def show(seen: Seen) -> None:
        if seen is None or (shown and seen and seen[0][0] not in shown):
            for one in shown.values():
                one.close()
            shown.clear()
        if seen:
            stage, done, total = seen[0]
            if stage not in shown:
                shown[stage] = tqdm(total=total, desc=stage)
            shown[stage].update(done - shown[stage].n)

    return show


def _line() -> Callable[[Seen], None]:
    said: "list[str]" = []

    def show(seen: Seen) -> None:
        if seen:
            stage, done, total = seen[0]
            words = f"{stage}: {100 * done // max(1, total)} %"
            if said != [words]:
                sys.stderr.write(f"\r{words:<60}")
                said[:] = [words]
        elif seen is None and said:
            sys.stderr.write("\n")
            said.clear()

    return show
