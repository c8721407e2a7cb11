"""What the scripts that make recordings in parts have in common."""

import filecmp
import os
import pathlib
import subprocess
import sys

SKIPPED = 77

SCENE = """! targets that shake, seen by a noisy receiver: enough of them that a run can be killed in the middle
$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0
$PLATFORM Car TRAJECTORY LINEAR LINEAR LINEAR INLINE 2 0, 0 1, 20 1 0, 1000 1 0, 0
NOT_ALIGNED CONST 0 0 0 0 0 0 STDDEV 0.1 0.2 0.3 STDDEV 0.1 0.1 0.1
{targets}
$RADAR Radar1 Earth CHIRP 0.05 1000 RECT CONSTANT 1000 SINGLE 1 100 0 300
  ISOTROPIC SAME FIXED 0 0 RECT NO_STC
$SIMULATION Radar1 900 1400 0 {end} 8 0.1 {lsb} BINARY RAW sim.bin BEGIN 1 1
"""

FILES = {"binary": "sim.bin", "hdf5": "sim.h5", "npy": "sim.npy", "csv": "sim.csv", "ascii": "sim.asc", "zarr": "sim.zarr"}


def program():
    return os.environ.get("SARSIM_PROGRAM") or os.environ["SARSIM_BUILT_PROGRAM"]


def write_scene(folder, pulses, lsb="3e-5"):
    path = pathlib.Path(folder) / "scene.scr"
    targets = "\n".join(f"$TARGET Car {k % 10} {k // 10} 0 0 0 0 1 0 ISOTROPIC" for k in range(200))
    path.write_text(SCENE.format(end=(pulses - 1) * 0.001, lsb=lsb, targets=targets))
    return path


def run(words, **options):
    """A finished process with its output as text."""
    return subprocess.run([str(w) for w in words], capture_output=True, text=True, check=False, **options)


def expect(truth, message):
    if not truth:
        sys.exit(f"FAILED: {message}")


def expect_done(finished):
    expect(finished.returncode == 0, f"{finished.args}: status {finished.returncode}\n{finished.stdout}{finished.stderr}")
    return finished


def expect_same(a, b):
    a, b = pathlib.Path(a), pathlib.Path(b)
    expect(b.exists(), f"{b} is missing")
    if a.is_dir():
        names = [sorted(path.relative_to(folder) for path in folder.rglob("*")) for folder in (a, b)]
        expect(names[0] == names[1], f"{a} and {b} hold other files")
        for name in names[0]:
            if (a / name).is_file():
                expect_same(a / name, b / name)
        return
    expect(filecmp.cmp(a, b, shallow=False), f"{a} and {b} differ")


def claims(journal):
    """The whole lines of a journal that vouch for rows, as (first, count)."""
    try:
        text = pathlib.Path(journal).read_text()
    except FileNotFoundError:
        return []
    whole = text[: text.rfind("\n") + 1]
    return [tuple(map(int, line.split()[1:3])) for line in whole.splitlines() if line.startswith("rows ")]
