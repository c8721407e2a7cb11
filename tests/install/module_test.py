"""Installs the program into a folder, moves it, writes and reads HDF5 and draws with it; then without its modules.

usage: module_test.py CMAKE BUILD_FOLDER
"""

import pathlib
import sys
import tempfile

from installing import SOURCE, expect, install, run


def main():
    cmake, build = sys.argv[1:]
    example = SOURCE / "examples" / "sar_r.scr"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        install(cmake, build, folder / "first", "program", "library")
        (folder / "first").rename(folder / "moved")
        program = folder / "moved" / "bin" / "sarsim"
        out = folder / "out"

        finished = run(program, "run", example, "--out", out)
        expect(finished.returncode == 0, "the installed program cannot write HDF5", finished)
        recording = next(out.glob("*.h5"))
        info = run(program, "info", recording)
        expect(info.returncode == 0 and "HDF5" in info.stdout.upper(), "it cannot read HDF5", info)

        picture = out / "picture.png"
        drawn = run(program, "plot", recording, "-o", picture)
        expect(drawn.returncode == 0 and picture.read_bytes().startswith(b"\x89PNG"), "it cannot draw", drawn)
        picture.unlink()
        (folder / "moved" / "lib" / "sarsim" / "sarsim_drawing.so").unlink()
        drawn = run(program, "plot", recording, "-o", picture)
        told = drawn.returncode == 1 and "sarsim_drawing.so" in drawn.stderr and not picture.exists()
        expect(told, "it does not say that the module for pictures is missing", drawn)

        (folder / "moved" / "lib" / "sarsim" / "sarsim_hdf5.so").unlink()
        info = run(program, "info", recording)
        told = info.returncode == 1 and str(recording) in info.stderr and "sarsim_hdf5.so" in info.stderr
        expect(told, "it does not say that the module is missing", info)
        finished = run(program, "run", example, "--out", out / "again")
        left = list((out / "again").iterdir()) if (out / "again").exists() else []
        told = finished.returncode == 1 and "sarsim_hdf5.so" in finished.stderr
        expect(told and not left, "it left something behind", finished)
        finished = run(program, "run", example, "--out", out / "npy", "--format", "npy")
        expect(finished.returncode == 0, "other formats need the module", finished)


main()
