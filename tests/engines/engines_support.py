"""What the tests of engines have in common: programs that start parts of a run, and start them again."""

import os
import pathlib
import sys
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]
RECIPES = SOURCE / "examples" / "engines"
sys.path.insert(0, str(SOURCE / "tests" / "parts"))

import parts_support  # noqa: E402
from parts_support import SKIPPED, claims, expect, expect_done, expect_same, program, run  # noqa: E402, F401


def write_scene(folder, pulses):
    """scene.toml, of targets that shake, seen by a noisy receiver: 334 samples a pulse."""
    parts_support.write_scene(folder, pulses)
    expect_done(run([program(), "format", "scene.scr", "--upgrade", "-o", "scene.toml"], cwd=folder))


def bin_folder(folder):
    """A folder for the PATH in which the program is called as recipes call it."""
    path = pathlib.Path(folder) / "bin"
    path.mkdir()
    (path / "sarsim").symlink_to(program())
    return path


def python_with(*modules):
    """A Python that has modules: that of SARSIM_TEST_PYTHON, or the one that runs this; skipped where neither does."""
    imports = "import " + ", ".join(modules)
    for python in (os.environ.get("SARSIM_TEST_PYTHON"), sys.executable, "/usr/bin/python3"):
        if python and run([python, "-c", imports]).returncode == 0:
            return python
    return skip(f"no Python has {' and '.join(modules)}")


def commands():
    """The commands of all processes with their own numbers and those of their parents: pid -> (parent, words)."""
    found = {}
    for folder in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            words = (folder / "cmdline").read_bytes().decode(errors="replace").split("\0")[:-1]
            parent = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
        except (OSError, ValueError):
            continue  # Has ended meanwhile.
        found[int(folder.name)] = (parent, words)
    return found


def part_at_work(folder, output, known=()):
    """Waits for a process that makes a part in a folder and has entered it: (pid, parent, name of the part)."""
    end = time.monotonic() + 30
    while time.monotonic() < end:
        for pid, (parent, words) in commands().items():
            part = words[words.index("--part") + 1].replace("/", "-of-") if "--part" in words else None
            ours = words[:1] == ["sarsim"] and part not in known and str(folder) in cwd_of(pid)
            if ours and (folder / output / "sim.bin.parts" / f"part-{part}.journal").exists():
                return pid, parent, part
        time.sleep(0.01)
    return expect(False, "after 30 s no part is at work")


def cwd_of(pid):
    try:
        return os.readlink(f"/proc/{pid}/cwd")
    except OSError:
        return ""


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)
