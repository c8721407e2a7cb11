#!/usr/bin/env python3
"""Every row of docs/developer/thesis-rows.md names tests that exist, and every section of chapter 4 has rows.

    thesis_rows_test.py ROOT      or: thesis_rows_test.py --self
"""

import re
import sys
from pathlib import Path

SECTIONS = [f"4.{i}" for i in range(1, 12)]


def covered(words):
    """The sections that a first cell such as "4.1.2" or "4.2 to 4.4" speaks of."""
    numbers = [int(n) for n in re.findall(r"4\.(\d+)", words)]
    return {f"4.{i}" for i in range(numbers[0], numbers[-1] + 1)} if numbers else set()


def faults(page, sources):
    """What is wrong; sources: text of each file of tests/gui by its name."""
    wrong, seen = [], set()
    for line in page.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if not line.startswith("| 4.") or len(cells) != 3:
            continue
        seen |= covered(cells[0])
        names = re.findall(r"`([^`]+)`", cells[2])
        if not names:
            wrong.append(f"{cells[0]}, {cells[1]}: no test")
        for name in names:
            if name.endswith(".cpp"):
                continue
            file, _, function = name.partition(".")
            if f"{file}.cpp" not in sources:
                wrong.append(f"{cells[0]}: no file {file}.cpp")
            elif function and not re.search(rf"\bvoid {re.escape(function)}\(", sources[f"{file}.cpp"]):
                wrong.append(f"{cells[0]}: {file}.cpp has no test {function}")
    wrong += [f"no row of section {section}" for section in SECTIONS if section not in seen]
    return wrong


def check_itself():
    sources = {"a_test.cpp": "  void one() {", "b_test.cpp": ""}
    good = "\n".join(f"| {section} | row | `a_test.one` `b_test` |" for section in SECTIONS)
    assert faults(good, sources) == []
    assert faults(good.replace("| 4.3 | row", "| 4.3 to 4.5 | row").replace("| 4.4 | row", "| x | row"), sources) == []
    assert faults(good.replace("`a_test.one` `b_test`", "`a_test.two`", 1), sources) == ["4.1: a_test.cpp has no test two"]
    assert faults(good.replace("`b_test`", "`c_test`", 1), sources) == ["4.1: no file c_test.cpp"]
    assert faults(good.replace("| 4.7 |", "| 5.7 |"), sources) == ["no row of section 4.7"]
    assert faults(good.replace("`a_test.one` `b_test`", "none", 1), sources) == ["4.1, row: no test"]


def main():
    check_itself()
    if sys.argv[1] == "--self":
        return 0
    root = Path(sys.argv[1])
    sources = {path.name: path.read_text(encoding="utf-8") for path in (root / "tests/gui").glob("*_test.cpp")}
    wrong = faults((root / "docs/developer/thesis-rows.md").read_text(encoding="utf-8"), sources)
    for fault in wrong:
        print(fault)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
