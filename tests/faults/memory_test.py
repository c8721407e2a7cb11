#!/usr/bin/env python3
"""Processes whose memory is limited (RLIMIT_AS) end with a message that names it, not by a signal.

The program is SARSIM_PROGRAM or SARSIM_BUILT_PROGRAM of the environment.
"""

import pathlib
import resource
import subprocess
import sys
import tempfile

import stories
from faults import program

COMMANDS = (
    ("check", "scene.scr"),
    ("info", "scene.scr"),
    ("run", "scene.scr", "--discard", "--quiet"),
    ("sweep", "scene.scr", "--set", "seed=1..3", "--discard", "--quiet"),
    ("focus", "sar.scr", "--force", "--quiet"),
    ("verify", "--quick"),
)
FOR_EVER = "temporary failure: try again later"


def limited(megabytes):
    most = megabytes << 20
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (most, most))


def main():
    told, refused = [], 0
    with tempfile.TemporaryDirectory(prefix="sarsim-memory-") as name:
        folder = pathlib.Path(name)
        (folder / "scene.scr").write_text(stories.moving(200))
        (folder / "sar.scr").write_text(stories.SAR)
        for megabytes in (30, 40, 50, 60, 80, 120):
            for words in COMMANDS:
                end = subprocess.run([program(), *words], cwd=folder, capture_output=True, text=True, errors="replace", check=False,
                                     preexec_fn=limited(megabytes), timeout=120)  # fmt: skip
                if end.returncode == 127:
                    continue  # Too little to load the program.
                where = f"{megabytes} MB: {' '.join(words)}"
                if end.returncode < 0:
                    told.append(f"{where}: ended by signal {-end.returncode}: {end.stderr.strip()[-200:]}")
                if FOR_EVER in end.stderr:
                    told.append(f"{where}: {end.stderr.strip()[-200:]}")
                refused += end.returncode > 0
                (folder / "sweep.journal").unlink(missing_ok=True)
    print("\n".join(told))
    print(f"{refused} refused, {len(told)} wrong")
    sys.exit(1 if told or refused == 0 else 0)


if __name__ == "__main__":
    main()
