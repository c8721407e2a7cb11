#!/usr/bin/env python3
"""The notes of a release: this version, what is new, a table in which everything holds; an error where it does not.

usage: release_notes_test.py PROGRAM
"""

import pathlib
import subprocess
import sys

TOOL = pathlib.Path(__file__).resolve().parent.parent.parent / "tools" / "release-notes"


def notes(program, *options):
    return subprocess.run([TOOL, program, *options], capture_output=True, text=True, check=False)


def main():
    program = sys.argv[1]
    made = notes(program, "--quick")
    assert made.returncode == 0, made.stderr
    version = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
    lines = made.stdout.splitlines()
    assert lines[0] == f"# Sarsim {version}", lines[0]
    news = (TOOL.parent.parent / "CHANGELOG.md").read_text().split("\n## ")[1].splitlines()[1:]
    assert len([line for line in news if line]) > 5 and set(news) <= set(lines), "what is new is missing"
    assert "Closed forms" in lines and "Numbers of the thesis" in lines, "the table is missing"
    assert any(line.endswith("comparisons agree") for line in lines), "the count of the table is missing"
    refused = notes("/bin/false")
    assert refused.returncode != 0 and not refused.stdout, "a program that fails its own test was released"
    assert "/bin/false verify ended with status 1" in refused.stderr, refused.stderr
    assert notes(program, "--unknown").returncode != 0


if __name__ == "__main__":
    main()
