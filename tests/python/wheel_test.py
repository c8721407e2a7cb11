"""The wheel: the tags that it names are true, and in an environment of its own it records, writes HDF5 and focuses without any
library of the system but those that every system has.

    wheel_test.py LIBRARY

SARSIM_TEST_PYTHON names a Python with auditwheel and NumPy.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = """
import os, pathlib, sys
import numpy as np
import sarsim
scene = sarsim.read(sys.argv[1])
recording = scene.record()
scene.record_file("a.h5")
assert np.array_equal(sarsim.open("a.h5"), recording)
assert len(sarsim.measure(sarsim.focus("a.h5"))) == 24
loaded = {line.split()[-1] for line in open("/proc/self/maps") if ".so" in line}
print("\\n".join(sorted(loaded)))
"""
OF_EVERY_SYSTEM = re.compile(r"/(ld-linux|lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s|resolv|util)\.so)")


def run(*words, **options):
    done = subprocess.run([*map(str, words)], capture_output=True, text=True, check=False, **options)
    if done.returncode == 77:
        print(done.stderr)
        sys.exit(77)
    assert done.returncode == 0, f"{words}:\n{done.stdout}{done.stderr}"
    return done.stdout


def main():
    python = os.environ.get("SARSIM_TEST_PYTHON")
    if not python:
        print("skipped: SARSIM_TEST_PYTHON names no Python with auditwheel")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        wheel = pathlib.Path(run(sys.executable, ROOT / "tools" / "wheel", "--library", sys.argv[1], folder).strip())
        tag = re.fullmatch(r"sarsim-[\d.]+(\+\S+)?-py3-none-(manylinux_2_\d+_\w+)\.whl", wheel.name)
        assert tag, wheel.name
        told = run(python, "-m", "auditwheel", "show", wheel)
        assert f'platform tag: "{tag[2]}"' in " ".join(told.split()), told
        with zipfile.ZipFile(wheel) as content:
            names = content.namelist()
        assert any(re.search(r"licenses/libfftw3", one) for one in names), names
        place = folder / "place"
        run(python, "-m", "pip", "install", "-q", "--no-index", "--no-deps", "--target", place, wheel)
        environment = {word: value for word, value in os.environ.items() if not word.startswith(("SARSIM", "LD_"))}
        environment["PYTHONPATH"] = str(place)
        loaded = run(python, "-c", PROGRAM, ROOT / "examples" / "sar_r.toml", cwd=folder, env=environment).split()
        assert f"{place}/sarsim/libsarsim.so.0" in loaded and f"{place}/sarsim/sarsim/sarsim_hdf5.so" in loaded, loaded
        own = [path for path in loaded if path.startswith(str(place))]
        assert any("libhdf5" in path for path in own) and any("libfftw3f" in path for path in own), own
        pythons = (str(pathlib.Path(python).parents[1]), sys.base_prefix, "/usr/lib/python3")
        others = [one for one in loaded if one not in own and not one.startswith(pythons) and not OF_EVERY_SYSTEM.search(one)]
        assert not [one for one in others if re.search("hdf5|fftw|fmt|hwy|curl|erfa", one)], others


main()
