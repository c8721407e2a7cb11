"""Installs the library, builds another program with it, and compares what that computes with `sarsim run`.

usage: project_test.py CMAKE BUILD_FOLDER GENERATOR COMPILER BUILD_TYPE
"""

import pathlib
import struct
import sys
import tempfile

from installing import SOURCE, expect, install, run


def fnv(data):
    total = 0xCBF29CE484222325
    for byte in data:
        total = (total ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
    return total


def samples_of(npy):
    """The bytes behind the header of an NPY file of version 1."""
    data = npy.read_bytes()
    expect(data[:8] == b"\x93NUMPY\x01\x00", "not an NPY file of version 1")
    (length,) = struct.unpack("<H", data[8:10])
    expect(b"<c8" in data[10 : 10 + length], "not samples in single precision")
    return data[10 + length :]


def main():
    cmake, build, generator, compiler, build_type = sys.argv[1:]
    script = SOURCE / "examples" / "sar_r.scr"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        install(cmake, build, folder / "first", "program", "library", "development")
        prefix = folder / "moved"
        (folder / "first").rename(prefix)

        made = folder / "made"
        configured = run(
            cmake,
            *("-S", SOURCE / "tests" / "install" / "project", "-B", made, "-G", generator),
            *(f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_BUILD_TYPE={build_type}"),
            *(f"-DCMAKE_PREFIX_PATH={prefix}", f"-DHEADERS={prefix / 'include' / 'sarsim'}"),
        )
        expect(configured.returncode == 0, "the other program cannot be configured", configured)
        compiled = run(cmake, "--build", made)
        expect(compiled.returncode == 0, "the other program cannot be built", compiled)

        own = run(made / "record", script, folder / "own.h5", folder / "own.png")
        expect(own.returncode == 0, "the other program fails", own)
        expect((folder / "own.png").read_bytes().startswith(b"\x89PNG"), "the other program draws nothing", own)
        sarsim = prefix / "bin" / "sarsim"
        for kind in ("npy", "hdf5"):
            finished = run(sarsim, "run", script, "1", "--format", kind, "--out", folder / kind)
            expect(finished.returncode == 0, "sarsim run fails", finished)
        version, _, checksum = own.stdout.splitlines()
        expect(run(sarsim, "--version").stdout.startswith(version + "\n"), "library and program differ in version", own)
        expected = fnv(samples_of(next((folder / "npy").iterdir())))
        expect(int(checksum, 16) == expected, f"other samples than those of sarsim run ({expected:x})", own)
        same = (folder / "own.h5").read_bytes() == next((folder / "hdf5").iterdir()).read_bytes()
        expect(same, "other bytes than those of sarsim run", own)


main()
