"""tools/build does nothing, and at once, where no source is newer than the last build; cmake is a stand-in that counts.

usage: build_tool_test.py
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LONGEST_S = 0.2  # of a processor, for a user who waits for ./run check

CMAKE = """#!/bin/sh
echo "$@" >> "$CALLS"
[ ! -e "$CALLS.fail" ] || exit 1
mkdir -p build/release
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" > build/release/CMakeCache.txt
touch build/release/build.ninja
"""


class Checkout:
    """A copy of the tool with a few sources."""

    def __init__(self, folder):
        self.folder = folder
        self.calls = folder / "calls"
        for name in ("src/core", "cmake", "docs", "bin"):
            (folder / name).mkdir(parents=True)
        for name in ("src/core/a.cpp", "CMakeLists.txt", "CMakePresets.json", "docs/page.md"):
            (folder / name).write_text("")
        shutil.copytree(ROOT / "tools", folder / "tools")
        (folder / "bin/cmake").write_text(CMAKE)
        (folder / "bin/cmake").chmod(0o755)

    def build(self, *words):
        """Status of the tool, and how often it called cmake."""
        before = len(self.calls.read_text().splitlines()) if self.calls.exists() else 0
        environment = dict(os.environ, PATH=f"{self.folder}/bin:{os.environ['PATH']}", CALLS=str(self.calls))
        done = subprocess.run([self.folder / "tools/build", *words], env=environment, capture_output=True, text=True, check=False)
        after = len(self.calls.read_text().splitlines()) if self.calls.exists() else 0
        return done.returncode, after - before


def processor_s():
    """Of the programs that were started and have ended."""
    times = os.times()
    return times.children_user + times.children_system


def main():
    wrong = []

    def expect(found, wanted, what):
        if found != wanted:
            wrong.append(f"{what}: {found}, expected {wanted}")

    def later(path):
        # A moment after the last build, whatever the clock of the file system can tell apart.
        time.sleep(0.02)
        path.write_text("x")

    with tempfile.TemporaryDirectory() as name:
        checkout = Checkout(pathlib.Path(name))
        sources = checkout.folder / "src/core"
        expect(checkout.build("--is-done", "release", "sarsim"), (1, 0), "before the first build")
        expect(checkout.build("release", "sarsim"), (0, 2), "the first build")
        expect(checkout.build("release", "sarsim"), (0, 0), "the second")
        expect(checkout.build("release", "all"), (0, 2), "another target")
        later(sources / "a.cpp")
        expect(checkout.build("--is-done", "release", "sarsim"), (1, 0), "after a change")
        expect(checkout.build("release", "sarsim"), (0, 2), "the build of a change")
        later(sources / "b.cpp")
        expect(checkout.build("release", "sarsim"), (0, 2), "the build of a new file")
        time.sleep(0.02)
        (sources / "b.cpp").unlink()
        expect(checkout.build("release", "sarsim"), (0, 2), "the build without a file")
        later(checkout.folder / "docs/page.md")
        expect(checkout.build("release", "sarsim"), (0, 0), "after a change of a page, the program")
        expect(checkout.build("release", "all"), (0, 2), "after a change of a page, all")
        later(sources / "a.cpp")
        pathlib.Path(f"{checkout.calls}.fail").touch()
        expect(checkout.build("release", "sarsim"), (1, 1), "a build that fails")
        pathlib.Path(f"{checkout.calls}.fail").unlink()
        expect(checkout.build("release", "sarsim"), (0, 2), "the build after it")
        before_s = processor_s()
        expect(checkout.build("--is-done", "release", "sarsim"), (0, 0), "in the end")
        expect(processor_s() - before_s < LONGEST_S, True, f"within {LONGEST_S} s")
        moved = checkout.folder.with_name(checkout.folder.name + "-moved")
        shutil.copytree(checkout.folder, moved)
        checkout.folder, checkout.calls = moved, moved / "calls"
        expect(checkout.build("--is-done", "release", "sarsim"), (1, 0), "after a move")
        shutil.rmtree(moved)
    print("\n".join(wrong) if wrong else "tools/build builds when it has to")
    sys.exit(1 if wrong else 0)


main()
