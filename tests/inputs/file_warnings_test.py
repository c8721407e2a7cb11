#!/usr/bin/env python3
"""What check says of the files that a scene names is said by every command that reads these files.

    file_warnings_test.py [WORD...]     commands that contain all of the words

A scene has a file of each kind with something to warn of: states too far apart, numbers behind the last function of a
data file, negative cross-sections of a table of points. Each command must say what check says of them, with the same
words. Recordings hold the points of functions themselves. The program is SARSIM_PROGRAM or SARSIM_BUILT_PROGRAM of the environment.
"""

import math
import os
import pathlib
import subprocess
import sys
import tempfile

PROGRAM = os.path.abspath(os.environ.get("SARSIM_PROGRAM") or os.environ["SARSIM_BUILT_PROGRAM"])

SCENE = """format = "sarsim 2"
[[platform]]
name = "Plane"
path = { type = "ephemeris", file = "track.csv" }
[[radar]]
name = "X"
platform = "Plane"
pulse = { type = "chirp", width = "1 us", bandwidth = "20 MHz" }
repetition = "100 Hz"
carrier = "1 GHz"
antenna = { type = "points", file = "cut.txt" }
beam = { type = "spot", point = [0, 0, 0] }
[[target]]
position = [0, 0, 0]
[[target]]
positions = { file = "points.csv" }
[[recording]]
radar = "X"
range = ["3 km", "4 km"]
time = ["-0.5 s", "0.5 s"]
sample_rate = "24 MHz"
file = "r.h5"
format = "hdf5"
[[geometry]]
radar = "X"
range = ["3 km", "4 km"]
time = ["-0.5 s", "0.5 s"]
file = "g.txt"
"""

TRACK, CUT, POINTS = "track.csv: its states are too far apart", "cut.txt:3:", "points.csv: cross-sections are negative"
ALL = [TRACK, CUT, POINTS]
CARRIED = [TRACK, POINTS]  # The points of functions are in the recording.

CASES = [
    (ALL, "run s.toml -o out --force"),
    (ALL, "info s.toml"),
    (ALL, "convert s.toml out/c.toml --force"),
    (ALL, "format s.toml"),
    (ALL, "plot s.toml -o out/p.png --force"),
    (ALL, "plot s.toml --kind track -o out/p.png --force"),
    (ALL, "plot s.toml --kind range -o out/p.png --force"),
    (ALL, "plot s.toml --kind scene -o out/p.png --force"),
    (ALL, "plot s.toml --kind antenna -o out/p.png --force"),
    (ALL, "plot s.toml --vary X.power=1,2 --kind range -o out/p.png --force"),
    (ALL, "plot samples.bin --script s.toml --simulation 1 -o out/p.png --force"),
    (ALL, "convert samples.bin out/c.npy --script s.toml --simulation 1 --force"),
    (ALL, "geometry s.toml -o out/g.txt --force"),
    (CARRIED, "geometry r.h5 -o out/g.txt --force"),
    (ALL, "geometry r.h5 --script s.toml -o out/g.txt --force"),
    (ALL, "motion s.toml --platform Plane --spacing 0.1 -o out/m.csv --force"),
    (ALL, "focus s.toml -o out/f.img --force"),
    (CARRIED, "focus r.h5 -o out/f.img --force"),
    (ALL, "focus r.h5 --script s.toml -o out/f.img --force"),
    (CARRIED, "measure f.img"),
    (ALL, "measure f.img --script s.toml"),
    (ALL, "search s.toml -o out/d --force"),
    (CARRIED, "search r.h5 -o out/d --force"),
    (ALL, "doppler s.toml -o out/d --force"),
    (CARRIED, "doppler r.h5 -o out/d --force"),
    (ALL, "isar s.toml -o out/d --force"),
    (ALL, "profiles s.toml -o out/d --force"),
    (ALL, "sweep s.toml --set X.power=1,2 -o out/sw --force"),
]


def write_files():
    """The scene and its files, into the current folder."""
    rate = 2.0 * math.pi / 120.0
    with open("track.csv", "w", encoding="ascii") as file:
        file.write("t,x,y,z\n")
        for time in range(-120, 241, 30):
            file.write(f"{time},{3000 * math.cos(rate * time):.6f},{3000 * math.sin(rate * time):.6f},1500\n")
    pathlib.Path("cut.txt").write_text("3 -40 -3 0 0 40 -3\n3 -40 -3 0 0 40 -3\n17\n", encoding="ascii")
    pathlib.Path("points.csv").write_text("x,y,z,rcs\n3,0,0,1\n5,5,0,-1\n", encoding="ascii")
    pathlib.Path("s.toml").write_text(SCENE, encoding="ascii")
    pathlib.Path("out").mkdir()


def said(command):
    """What a command writes to its error output, and its status."""
    done = subprocess.run([PROGRAM, *command.split()], capture_output=True, text=True, check=False)
    return done.stderr + done.stdout, done.returncode


def main():
    words = sys.argv[1:]
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        write_files()
        told, _ = said("check s.toml")
        failures += [f"check does not say '{warning}'" for warning in ALL if warning not in told]
        for command in ("run s.toml --force", "focus r.h5 -o f.img", "convert r.h5 samples.bin"):
            text, status = said(command)
            if status != 0:
                failures.append(f"{command}: {text}")
        for expected, command in CASES:
            if not all(word in command for word in words):
                continue
            text, _ = said(command)
            failures += [f"{command}: does not say '{warning}'" for warning in expected if warning not in text]
        os.chdir("/")
    for failure in failures:
        print(failure)
    print(f"{len(CASES)} commands, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
