#!/usr/bin/env python3
"""Runs every story under valgrind's memcheck: memcheck.py [STORY...]; started by tools/valgrind."""

import os
import re
import subprocess
import sys
import tempfile
import time

from faults import program
from stories import all_stories

MISUSED = 99


def command_line(words):
    """With an instruction set that valgrind knows, where the command can be told."""
    simd = ["--simd", "avx2"] if words[0] in ("run", "sweep") else []
    options = ["-q", f"--error-exitcode={MISUSED}", "--leak-check=full", "--errors-for-leak-kinds=definite"]
    return ["valgrind", *options, program(), *words, *simd]


def try_story(story, folder):
    """What memcheck says; empty for nothing."""
    for name, text in story.files.items():
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)
    for words in story.before:
        subprocess.run([program(), *words, "--quiet"], cwd=folder, check=True, capture_output=True)
    done = subprocess.run(command_line(story.command), cwd=folder, capture_output=True, text=True, check=False)
    found = "\n".join(line for line in done.stderr.splitlines() if re.match(r"==\d+==", line))
    if done.returncode not in (0, MISUSED):
        found += f"\nstatus {done.returncode}: {done.stderr[-500:]}"
    return found.strip()


def main():
    known = all_stories()
    names = sys.argv[1:] or list(known)
    misused = 0
    for name in names:
        begin = time.monotonic()
        with tempfile.TemporaryDirectory(prefix="sarsim-memcheck-") as folder:
            found = try_story(known[name], folder)
        misused += bool(found)
        print(f"{name}: {'FOUND SOMETHING' if found else 'nothing'}, {time.monotonic() - begin:.0f} s\n{found}".rstrip(), flush=True)
    print(f"{len(names)} stories, {misused} with findings")
    sys.exit(1 if misused else 0)


if __name__ == "__main__":
    main()
