"""mypy finds the package and a program that uses it without fault, and finds faults in one that has some.

SARSIM_TEST_PYTHON may name a Python that has mypy.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

PACKAGE = pathlib.Path(__file__).resolve().parents[2] / "python"
GOOD = """
import numpy as np
import sarsim
scene: sarsim.Scene = sarsim.read("a.toml")
radar = scene.radars["Radar1"]
radar.bandwidth = "50 MHz"
radar.carrier = 9.65e9
radar.transmit_antenna.azimuth_beamwidth = 2
width: float = radar.bandwidth * radar.pulse_width
place: float = scene.targets[0].position[1]
table = scene.record(dtype=np.complex64).samples
image: sarsim.Image = sarsim.focus(scene.record(), window="hann")
errors = sarsim.measure(image)["azimuth_error_m"].max()
"""
# But that arrays need not say of what, and that two versions of NumPy know different things of them.
STRICT = ("--strict", "--ignore-missing-imports", "--allow-any-generics", "--no-warn-return-any", "--no-warn-unused-ignores")
BAD = (
    ("radar.bandwidth = [3]", "Incompatible types in assignment"),
    ("radar.same_antenna = 3.5", "Incompatible types in assignment"),
    ("text: str = radar.pulse_width", "Incompatible types in assignment"),
    ("scene.recrod()", "has no attribute"),
    ("sarsim.read()", "Missing positional argument"),
)


def python_with_mypy():
    for program in (os.environ.get("SARSIM_TEST_PYTHON", ""), sys.executable, "/usr/bin/python3"):
        if program and subprocess.run([program, "-c", "import mypy, numpy"], capture_output=True).returncode == 0:
            return program
    print("skipped: no Python with mypy and NumPy (Debian: mypy)")
    sys.exit(77)


def mypy(program, folder, *words):
    environment = {**os.environ, "MYPYPATH": str(PACKAGE)}
    command = [program, "-m", "mypy", "--cache-dir", str(folder / "cache"), *map(str, words)]
    done = subprocess.run(command, capture_output=True, text=True, cwd=folder, env=environment, check=False)
    return done.stdout + done.stderr


def main():
    program = python_with_mypy()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "good.py").write_text(GOOD)
        (folder / "bad.py").write_text(GOOD + "\n".join(line for line, _ in BAD) + "\n")
        told = mypy(program, folder, *STRICT, "good.py", "bad.py").splitlines()
        faults = [one for one in told if ": error:" in one]
        others = [one for one in faults if not one.startswith("bad.py:")]
        if others:
            sys.exit("\n".join(others))
        first = GOOD.count("\n") + 1
        for number, (line, fault) in enumerate(BAD, first):
            if not any(one.startswith(f"bad.py:{number}:") and fault in one for one in faults):
                sys.exit(f"{line}: no '{fault}' in\n" + "\n".join(told))
        if len(faults) != len(BAD):
            sys.exit("\n".join(faults))


main()
