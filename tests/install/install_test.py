"""Installs the program into a folder, moves it, and writes and reads HDF5 with it; then without its module.

usage: install_test.py CMAKE BUILD_FOLDER
"""

import pathlib
import subprocess
import sys
import tempfile


def sarsim(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=False)


def expect(condition, what, run):
    if not condition:
        sys.exit(f"{what}\n{run.args}\nstatus {run.returncode}\n{run.stdout}{run.stderr}")


def main():
    cmake, build = sys.argv[1:]
    source = pathlib.Path(__file__).parents[2]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run(
            [cmake, "--install", build, "--prefix", folder / "first", "--component", "program"],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        (folder / "first").rename(folder / "moved")
        program = folder / "moved" / "bin" / "sarsim"
        out = folder / "out"

        run = sarsim(program, "run", source / "examples" / "sar_r.scr", "--out", out)
        expect(run.returncode == 0, "the installed program cannot write HDF5", run)
        recording = next(out.glob("*.h5"))
        info = sarsim(program, "info", recording)
        expect(info.returncode == 0 and "HDF5" in info.stdout.upper(), "it cannot read HDF5", info)

        (folder / "moved" / "lib" / "sarsim" / "sarsim_hdf5.so").unlink()
        info = sarsim(program, "info", recording)
        told = info.returncode == 1 and str(recording) in info.stderr and "sarsim_hdf5.so" in info.stderr
        expect(told, "it does not say that the module is missing", info)
        run = sarsim(program, "run", source / "examples" / "sar_r.scr", "--out", out / "again")
        left = list((out / "again").iterdir()) if (out / "again").exists() else []
        expect(run.returncode == 1 and "sarsim_hdf5.so" in run.stderr and not left, "it left something behind", run)
        run = sarsim(program, "run", source / "examples" / "sar_r.scr", "--out", out / "npy", "--format", "npy")
        expect(run.returncode == 0, "other formats need the module", run)


main()
