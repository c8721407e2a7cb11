#!/usr/bin/env python3
"""Every word, field and block of the script language is in its diagrams.

The diagrams come from asking the program (tools/railway); this looks from the other side, at the library's tables, so
that nothing is missing that the questions did not lead to.

usage: language_test.py PROJECT FIELD_TABLES
"""

import html
import pathlib
import subprocess
import sys


def main():
    folder = pathlib.Path(sys.argv[1]) / "docs/formats"
    page = (folder / "script-diagrams.md").read_text(encoding="utf-8")
    pictures = html.unescape(" ".join(file.read_text(encoding="utf-8") for file in (folder / "diagrams").glob("*.svg")))
    reference = (folder / "script.md").read_text(encoding="utf-8")
    text = subprocess.run([sys.argv[2]], check=True, capture_output=True, encoding="utf-8").stdout
    lines = [line.split(" ", 1) for line in text.split("=== language\n")[1].splitlines()]
    of_kind = {kind: [name for found, name in lines if found == kind] for kind in ("word", "field", "block")}
    wrong = [f"word {word}" for word in of_kind["word"] if word not in page or f">{word}<" not in pictures]
    wrong += [f"word {word} in script.md" for word in of_kind["word"] if word not in reference]
    for kind in ("field", "block"):
        wrong += [f"{kind} {name}" for name in of_kind[kind] if name not in page or name not in pictures]
    counts = ", ".join(f"{len(names)} {kind}s" for kind, names in of_kind.items())
    if len(of_kind["word"]) < 50 or len(of_kind["field"]) < 40 or len(of_kind["block"]) != 15:
        wrong.append(f"only {counts} were found in the tables")
    print("\n".join(f"not in the diagrams: {name}" for name in wrong) or counts)
    sys.exit(1 if wrong else 0)


main()
