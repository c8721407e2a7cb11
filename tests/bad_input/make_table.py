#!/usr/bin/env python3
"""Records what sarsim says to each bad input, word for word, and makes docs/guide/bad-input.md of it.

    SARSIM_PROGRAM=build/dev/src/sarsim tests/bad_input/make_table.py [--check]

The record is said/cases.txt. With --check nothing is written; exit status 1 where the record and the program disagree. What
depends on the machine, such as free room on a disk, is left out of the messages; rows of cases that this machine does not
allow are kept.
"""

import difflib
import re
import sys

import groups
import interruptions
import numeric_fields
import page
import scene_cases
import script_cases
import world_cases
from harness import possible, program

RECORD = page.SAID / "cases.txt"
RULE = "|---|---|---|---|"
HEAD = ["| what is wrong | command, where not `sarsim run scene.scr` | exit status | what the user sees |", RULE]
NUMBERS_HEAD = ["| command | numeric fields | bad values, each in a run of its own | for example |", RULE]

TITLES = {
    "files": "The script as a file",
    "truncated": "Scripts that end too early",
    "words": "Words of a script",
    "names": "Names",
    "data": "Data files and INLINE data",
    "recordings": "Recordings",
    "radars": "Radars",
    "targets": "Targets, platforms, surfaces",
    "commands": "The command line",
    "outputs": "Outputs",
    "disks": "Disks and devices",
    "samples": "Files of samples",
    "interruptions": "Interruptions",
}


def shortened(text):
    text = re.sub(r"\S{80,}", lambda m: m[0][:40] + "...", text)
    text = re.sub(r"[\d.]+ [kMGTPE]?B\b", "... B", text)
    return text.replace(program(), "sarsim")


def as_cell(paragraph):
    lines = [line.strip() for line in shortened(paragraph).splitlines()]
    ticks = "``" if any("`" in line for line in lines) else "`"
    return "<br>".join(ticks + line.replace("|", "\\|") + ticks for line in lines)


def message_of(case, seen):
    """The message of a case: its problem, or the line that the command ends with."""
    if case.severity:
        return seen.problems(case.severity)[0]
    told = [p for p in seen.paragraphs() if ": error: " in p]
    return told[0] if told else ""


def row(case):
    command = f"`{case.shown}`".replace("|", "\\|") if case.shown else ""
    if isinstance(case, interruptions.Interruption):
        killed = case.status < 0
        message = "" if killed else "sarsim: interrupted; no partial output was left behind"
        status = "killed" if killed else case.status
    else:
        seen, _ = groups.attempt(case)
        message, status = message_of(case, seen), seen.status
        if case.name == "reader_gone":  # Behind a pipe, whose status is that of its reader.
            status = 1
    return f"| {case.wrong} | {command} | {status} | {as_cell(message) if message else 'nothing'} |"


def table(name, cases, old):
    lines = ["", f"## {TITLES[name]}", "", *HEAD]
    for case in cases:
        kept = [line for line in old if line.startswith(f"| {case.wrong} |")]
        lines.append(row(case) if possible(case) or not kept else kept[0])
    return lines


def numbers():
    """One row for the fields of each command, with an example."""
    lines = ["", "## Numbers in scripts", "", *NUMBERS_HEAD]
    for command in numeric_fields.COMMANDS:
        cases = numeric_fields.cases(command)
        fields = [field for field in numeric_fields.FIELDS if field.command == command]
        seen, _ = groups.attempt(cases[len(fields) % 7])
        lines.append(f"| `{command}` | {len(fields)} | {len(cases)} | {as_cell(message_of(cases[0], seen))} |")
    return lines


def all_tables(old):
    lines = numbers()
    count = len(numeric_fields.COMMANDS)
    for module in (script_cases, scene_cases, world_cases, interruptions):
        for name, cases in module.GROUPS.items():
            made = cases()
            count += len(made)
            lines += table(name, made, old)
    values = sum(len(numeric_fields.cases(command)) for command in numeric_fields.COMMANDS)
    return [f"{count} rows, of which the first {len(numeric_fields.COMMANDS)} stand for {values} bad numbers.", *lines]


def main():
    old = RECORD.read_text(encoding="utf-8")
    made = "\n".join(all_tables(old.splitlines())) + "\n"
    if "--check" not in sys.argv[1:]:
        RECORD.write_text(made, encoding="utf-8")
        page.write()
        return 0
    if made == old:
        return 0
    print(f"{RECORD.name} and the program disagree; tests/bad_input/make_table.py writes it anew:")
    print("\n".join(difflib.unified_diff(old.splitlines(), made.splitlines(), "record", "program", lineterm="")))
    return 1


if __name__ == "__main__":
    sys.exit(main())
