"""No program or library of the build looks for libraries in the folder in which it is started.

usage: run_path_test.py BUILD_FOLDER
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

from installing import expect, run


def is_elf(path):
    with path.open("rb") as file:
        return file.read(4) == b"\x7fELF"


def binaries(build):
    for folder, folders, files in os.walk(build):
        folders[:] = [name for name in folders if name != "CMakeFiles"]
        for name in files:
            path = pathlib.Path(folder, name)
            if path.suffix not in (".o", ".a") and path.is_file() and not path.is_symlink() and is_elf(path):
                yield path


def run_paths(path):
    listed = subprocess.run(["readelf", "--dynamic", path], check=True, capture_output=True, text=True).stdout
    return re.findall(r"\((?:RPATH|RUNPATH)\).*\[(.*)\]", listed)


def is_fixed(part):
    return part.startswith(("/", "$ORIGIN/", "${ORIGIN}/")) or part in ("$ORIGIN", "${ORIGIN}")


def main():
    build = pathlib.Path(sys.argv[1])
    found = list(binaries(build))
    program = build / "src" / "sarsim"
    expect(program in found and len(found) > 1, f"no programs found in {build}")
    for path in found:
        for run_path in run_paths(path):
            expect(all(map(is_fixed, run_path.split(":"))), f"{path} looks for libraries in '{run_path}'")
    with tempfile.TemporaryDirectory() as folder:
        for name in ("libhwy.so.1", "libfftw3.so.3", "libfmt.so.9", "sarsim_hdf5.so"):
            pathlib.Path(folder, name).write_text("not a library")
        pathlib.Path(folder, "damaged.h5").write_bytes(b"\x89HDF\r\n\x1a\n")
        finished = run(program, "info", "damaged.h5", cwd=folder)
        expect(finished.returncode == 2 and "as HDF5" in finished.stderr, "planted libraries are opened", finished)


main()
