"""./test installs what the program's own tests need and no more, and leaves the foreign ones to ./test --all; ./test quick builds
and runs one room. The package manager, cmake and ctest are stand-ins that write down how they were called.

usage: test_command_test.py
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from installing import expect

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_PACKAGES = 25  # of Debian, asked for by name
FOREIGN = ("slurm", "munge", "octave", "gnudatalanguage", "snakemake", "mpi", "node", "venv", "xvfb", "clang")
STAND_IN = '#!/bin/sh\necho "${0##*/} $*" >> "$CALLS"\n'
CMAKE = STAND_IN + 'mkdir -p build/dev\necho "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" > build/dev/CMakeCache.txt\n'


class Checkout:
    """A copy of the tools with a few sources."""

    def __init__(self, folder):
        self.folder = folder
        for name in ("test", "tools"):
            copy = shutil.copytree if (ROOT / name).is_dir() else shutil.copy
            copy(ROOT / name, folder / name)
        self.write("src/scene/check/a_test.cpp", "TEST(Checks, A) {\n}\nTEST_P(CheckCases, B) {\n}\n")
        self.write("src/scene/edit/b_test.cpp", "TEST_F(Edits, C) {\n}\n")
        self.write("tests/cli/CMakeLists.txt", "add_test(NAME cli.a COMMAND a $<TARGET_FILE:sarsim-gui>)\n")
        self.write("CMakeLists.txt", "")
        for name, text in (("dpkg-query", "#!/bin/sh\nexit 1\n"), ("apt-get", STAND_IN), ("ctest", STAND_IN), ("cmake", CMAKE),
                           ("sudo", '#!/bin/sh\nexec "$@"\n')):
            self.write(f"bin/{name}", text, 0o755)
        self.write("tools/test-python", STAND_IN, 0o755)
        self.write("build/dev/src/scene_test", STAND_IN, 0o755)

    def write(self, name, text, mode=0o644):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(mode)

    def run(self, *words):
        """What is called by ./test with these words, line by line, and how it ended."""
        calls = self.folder / "calls"
        calls.write_text("")
        environment = dict(os.environ, PATH=f"{self.folder}/bin:{os.environ['PATH']}", CALLS=str(calls), TMPDIR=str(self.folder))
        done = subprocess.run([self.folder / "test", *words], env=environment, capture_output=True, text=True, check=False)
        return calls.read_text().splitlines(), done

    def run_well(self, *words):
        lines, done = self.run(*words)
        expect(done.returncode == 0, f"./test {' '.join(words)} fails", done)
        return lines


def packages(lines):
    words = [word for line in lines if line.startswith("apt-get install") for word in line.split()[2:]]
    return {word for word in words if not word.startswith("-")}


def only(lines, program):
    """The call of a program, which several processes may make in the same words."""
    found = sorted({line for line in lines if line.startswith(program + " ")})
    expect(len(found) == 1, f"{program} was called {len(found)} times: {lines}")
    return found[0]


def own_tests(checkout):
    lines = checkout.run_well("-R", "Chirp")
    asked = packages(lines)
    expect(10 < len(asked) <= MOST_PACKAGES, f"{len(asked)} packages instead of at most {MOST_PACKAGES}: {sorted(asked)}")
    expect(not [p for p in asked if any(word in p for word in FOREIGN)], f"foreign packages: {sorted(asked)}")
    expect(only(lines, "ctest").endswith("--label-exclude ^foreign$ -R Chirp"), only(lines, "ctest"))
    return len(asked)


def all_tests(checkout):
    lines = checkout.run_well("--all", "-R", "Chirp")
    missing = [word for word in FOREIGN if not any(word in package for package in packages(lines))]
    expect(not missing, f"./test --all installs nothing for {missing}")
    called = only(lines, "ctest")
    expect("exclude" not in called and called.endswith("-R Chirp"), called)
    only(lines, "test-python")


def one_room(checkout):
    built = []
    for room, suites in (("scene/check", {"Checks", "CheckCases"}), ("src/scene/", {"Checks", "CheckCases", "Edits"})):
        lines = checkout.run_well("quick", room)
        built += [line for line in lines if re.search(r"--build .*--target scene_test$", line)]
        found = only(lines, "scene_test")
        filters = re.search(r"--gtest_filter=(\S+)-\*ForeignProgram\*", found)
        expect(filters and {one.split(".")[0] for one in filters[1].split(":")} >= suites, found)
        expect(("Edits" in suites) == ("Edits" in found), found)
        expect(not packages(lines), f"{room} installs {packages(lines)}")
    expect(len(built) == 1, f"built {len(built)} times, expected once: {built}")
    lines = checkout.run_well("quick", "tests/cli", "-R", "a")
    expect(any(re.search(r"--target sarsim tests/cli/all sarsim-gui$", line) for line in lines), str(lines))
    called = only(lines, "ctest")
    expect("build/dev/tests/cli " in called and called.endswith("--label-exclude ^foreign$ -R a"), called)
    for wrong in ("scene/chek", "tests/clj", ""):
        lines, done = checkout.run("quick", wrong)
        expect(done.returncode == 2 and "expected a folder of src/" in done.stderr and not lines, f"'{wrong}'", done)


def main():
    with tempfile.TemporaryDirectory() as name:
        checkout = Checkout(pathlib.Path(name))
        count = own_tests(checkout)
        all_tests(checkout)
        one_room(checkout)
    print(f"./test asks for {count} packages of Debian")


if __name__ == "__main__":
    sys.exit(main())
