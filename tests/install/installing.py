"""What the tests of installing have in common."""

import pathlib
import subprocess
import sys

SOURCE = pathlib.Path(__file__).parents[2]
SKIPPED = 77


def install(cmake, build, prefix, *components):
    for component in components:
        subprocess.run(
            [cmake, "--install", build, "--prefix", prefix, "--component", component],
            check=True,
            stdout=subprocess.DEVNULL,
        )


def run(program, *arguments, **options):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=False, **options)


def expect(condition, what, finished=None):
    if condition:
        return
    if finished is not None:
        what += f"\n{finished.args}\nstatus {finished.returncode}\n{finished.stdout}{finished.stderr}"
    sys.exit(what)


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)
