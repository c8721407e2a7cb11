#!/usr/bin/env python3
"""Makes likely mistakes in a sound scene in format 2 and compares what sarsim says with the guide.

    SARSIM_PROGRAM=build/dev/src/sarsim tests/bad_input/mistakes_format_2.py [--check]

Without --check the tables of docs/guide/bad-input-format-2.md are written. Each mistake must be reported in the words,
at the place and with the exit status that format_2_cases.py gives, whatever the tables hold. Exit status 1 if one is
not, or if the tables differ.
"""

import difflib
import pathlib
import re
import subprocess
import sys
import tempfile

from base import spoiled
from format_2_cases import CHECK, SCENE, THEMES
from harness import program, split_mark
from mistakes import as_cell, message_of

GUIDE = pathlib.Path(__file__).resolve().parent.parent.parent / "docs/guide/bad-input-format-2.md"
BEGIN, END = "<!-- mistakes: made by tests/bad_input/mistakes_format_2.py -->", "<!-- end of the mistakes -->"
HEAD = ["| | what is typed | what is wrong | exit status | what the user sees |", "|---|---|---|---|---|"]
SCENE_FILE = "scene.toml"


def written(mistake):
    """The bytes of the scene, and where the message has to point: "scene.toml:9:1"."""
    text = spoiled(*mistake.changes, text=SCENE) if mistake.whole is None else mistake.whole
    text, place = split_mark(text)
    if mistake.coding == "crlf":
        made = text.replace("\n", "\r\n").encode()
    else:
        made = text.encode(mistake.coding)
    return made, place and f"{SCENE_FILE}:{place}: "


def said(mistake, folder):
    """Exit status and all that a user sees."""
    for name, text in mistake.files.items():
        pathlib.Path(folder, name).write_text(text, encoding="utf-8")
    made, place = written(mistake)
    pathlib.Path(folder, SCENE_FILE).write_bytes(made)
    done = subprocess.run(
        [program(), *mistake.command.split()], cwd=folder, capture_output=True, timeout=60, check=False
    )
    return done.returncode, (done.stdout + done.stderr).decode(errors="backslashreplace"), place


def faults_of(mistake, status, text, place):
    """What is wrong with what was said."""
    message = message_of({"words": mistake.words}, text)
    errors = len(re.findall(r"^(?:\S+ )?error: ", text, re.MULTILINE))
    most = mistake.errors if mistake.status else 0
    found = []
    if message is None:
        found.append(f"nothing matches {mistake.words!r}")
    elif place and not message.startswith(place):
        found.append(f"the message does not point at {place}")
    if status != mistake.status:
        found.append(f"exit status {status} instead of {mistake.status}")
    if errors > most:
        found.append(f"{errors} errors instead of {most}")
    return [f"{mistake.why} {fault}; said:\n{text}" for fault in found]


def typed(mistake):
    """The lines that are not those of the sound scene."""
    if mistake.typed is not None:
        return mistake.typed
    text, _ = split_mark(spoiled(*mistake.changes, text=SCENE))
    sound, lines = SCENE.splitlines(), text.splitlines()
    steps = difflib.SequenceMatcher(None, sound, lines, autojunk=False).get_opcodes()
    return as_cell("\n".join(line for tag, _, _, begin, end in steps if tag != "equal" for line in lines[begin:end]))


def row(number, mistake, message):
    command = "" if mistake.command == CHECK else f"`sarsim {mistake.command}`"
    shown = " ".join(filter(None, [typed(mistake), command]))
    return f"| {number} | {shown} | {mistake.why} | {mistake.status} | {as_cell(message or 'nothing')} |"


def tables():
    lines, faults, number = [], [], 0
    for theme, mistakes in THEMES.items():
        lines += ["", f"## {theme}", "", *HEAD]
        for mistake in mistakes():
            number += 1
            with tempfile.TemporaryDirectory() as folder:
                status, text, place = said(mistake, folder)
            faults += faults_of(mistake, status, text, place)
            lines.append(row(number, mistake, message_of({"words": mistake.words}, text)))
    return [f"{number} mistakes.", *lines], faults


def main():
    lines, faults = tables()
    made = "\n".join(["", *lines, "", ""])
    text = GUIDE.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    old, after = rest.split(END)
    if "--check" not in sys.argv[1:]:
        GUIDE.write_text(before + BEGIN + made + END + after, encoding="utf-8")
    elif made != old:
        faults.append(f"{GUIDE.name} and the program disagree; tests/bad_input/mistakes_format_2.py writes it anew")
        faults += [line for line in lines if line not in old.splitlines()]
    print("\n".join(faults) or f"{lines[0].removesuffix('.')}, all of them reported")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
