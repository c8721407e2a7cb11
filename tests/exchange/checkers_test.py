"""The checkers of sarkit and sarpy find nothing wrong with our files, and images from what these two read have targets at
their places.

    checkers_test.py SARSIM EXAMPLES SCENE

Needs a Python with sarkit and sarpy: this one, or the one that SARSIM_TEST_PYTHON names. Exit status: 0 as it should be, 1
not, 77 packages are missing.
"""

import importlib
import importlib.util
import multiprocessing
import os
import pathlib
import re
import runpy
import subprocess
import sys
import tempfile

NEEDED = ("numpy", "lxml", "shapely", "sarkit", "sarpy", "pytest")

# Names of files, scenes and options: stripmap, spotlight, from the air and from orbit.
AIR = ["--anchor", "47,8,400,120"]
FILES = {
    "air_cf8": ("small", AIR),
    "air_ci4": ("small", [*AIR, "--encoding", "ci4", "--reference-point", "40,-30,5"]),
    "air_ci2": ("small", [*AIR, "--encoding", "ci2", "--reference-point", "moving"]),
    "errors_cf8": ("stripmap_motion.toml", ["--anchor=-80,170,2000"]),
    "spot_cf8": ("spotlight.toml", AIR),
    "spot_ci4": ("spotlight.toml", [*AIR, "--encoding", "ci4"]),
    "strip_ci4": ("spotlight.toml", [*AIR, "--simulation", "2", "--reference-point", "moving", "--encoding", "ci4"]),
    "orbit_cf8": ("satellite.toml", []),
    "orbit_ci2": ("satellite.toml", ["--encoding", "ci2"]),
    "orbit_moving": ("satellite.toml", ["--reference-point", "moving"]),
}

# Raw rows, whose pulses have to keep the clock of the converter: 600 MHz/1 kHz, 75 MHz/120 Hz.
RECEIVED = {
    "air_crsd": ("small", AIR),
    "air_crsd_ci4": ("small", [*AIR, "--encoding", "ci4", "--reference-point", "moving"]),
    "spot_crsd": ("spotlight.toml", AIR),
    "strip_crsd_ci2": ("spotlight.toml", [*AIR, "--simulation", "2", "--encoding", "ci2"]),
}

# crsdcheck computes the ground range as an arc cosine and asks for 1e-6 m. Its own rounding is R^2 1.1e-16/G, 1.8e-6 m at
# 2.5 km: what it says of the near scene changes with the last bit of NumPy's sums.
ROUNDED = re.compile(r"\[Error\] Need: (Tx|Rcv)Parameters/GroundRange matches defined calculation")

# What is seen in some of them: places, how they are given, and in what metres a peak is looked for.
IMAGES = {
    "air_cf8": ["--anchor=47,8,400,120", "--targets=0,0,0;31,23,0;-27,-35,2"],
    "air_ci2": ["--anchor=47,8,400,120", "--targets=0,0,0;31,23,0;-27,-35,2"],
    "orbit_cf8": ["--geodetic", "--reach=1.5", "--targets=-16.012920,-68.551945,0;-16.0117,-68.549,120"],
}


# What takes seconds to import, here once for all checks.
CHECKERS = {
    "sarkit": ("sarkit.verification._cphdcheck", "--thorough"),
    "sarpy": ("sarpy.consistency.cphd_consistency", "--signal-data"),
    "crsd": ("sarkit.verification._crsdcheck", "--thorough"),
}
OTHERS = ("numpy", "sarkit.cphd", "sarkit.crsd", "sarpy.io.phase_history.cphd", "_pytest.assertion.rewrite")


def run(*words):
    done = subprocess.run(words, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def run_apart(module, *words):
    """Runs a module or a file as a program, in a process of its own that has the imports of this one. Returns its exit status
    and what it printed."""
    with tempfile.TemporaryFile("w+") as output:
        process = multiprocessing.get_context("fork").Process(target=become, args=(module, words, output.fileno()))
        process.start()
        process.join()
        output.seek(0)
        return process.exitcode, output.read()


def become(module, words, output):
    os.dup2(output, 1)
    os.dup2(output, 2)
    sys.argv = [module, *words]
    if not module.endswith(".py"):
        sys.modules.pop(module, None)  # Else runpy warns that it is there already.
        runpy.run_module(module, run_name="__main__")
        return
    sys.path.insert(0, str(pathlib.Path(module).parent))
    runpy.run_path(module, run_name="__main__")


def checks_of(name, path):
    """Names of checks, and the module or file with its words that does each."""
    if name in RECEIVED:
        return {"sarkit": (*CHECKERS["crsd"], path)}
    checks = {reader: (*CHECKERS[reader], path) for reader in ("sarkit", "sarpy")}
    program = str(pathlib.Path(__file__).parent / "cphd_image.py")
    for reader in ("sarkit", "sarpy") if name in IMAGES else ():
        checks["image by " + reader] = (program, path, "--reader", reader, *IMAGES[name])
    return checks


def main(program, examples, small):
    for module in (*OTHERS, *(words[0] for words in CHECKERS.values())):
        importlib.import_module(module)
    failed = []
    with tempfile.TemporaryDirectory() as folder:
        for name, (scene, options) in (FILES | RECEIVED).items():
            path = str(pathlib.Path(folder) / f"{name}.{'crsd' if name in RECEIVED else 'cphd'}")
            scene = small if scene == "small" else str(pathlib.Path(examples) / scene)
            status, said = run(program, "convert", scene, path, *options)
            assert status == 0, said
            for check, words in checks_of(name, path).items():
                status, said = run_apart(*words)
                said, rounded = ROUNDED.subn("", said)
                good = (status == 0 or rounded > 0) and "[Error]" not in said and "[Warning]" not in said
                print(f"{name}, {check}: {'good' if good else said}")
                if not good:
                    failed.append((name, check))
    return 1 if failed else 0


if __name__ == "__main__":
    other = os.environ.pop("SARSIM_TEST_PYTHON", "")
    missing = [name for name in NEEDED if importlib.util.find_spec(name) is None]
    if missing and other and os.path.abspath(other) != os.path.abspath(sys.executable):
        os.execv(other, [other, *sys.argv])
    if missing:
        print(f"{sys.executable} has no {', '.join(missing)}; SARSIM_TEST_PYTHON may name an interpreter that has")
        sys.exit(77)
    sys.exit(main(*sys.argv[1:]))
