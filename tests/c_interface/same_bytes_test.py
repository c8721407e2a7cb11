"""What a C program records, in files and in memory, are the bytes that `sarsim run` writes.

usage: same_bytes_test.py SARSIM C_RECORD EXAMPLES
"""

import pathlib
import struct
import subprocess
import sys
import tempfile

FORMATS = ("ascii", "csv", "bracket", "binary", "npy", "hdf5")
# Raw, in both languages; compressed with noise and all the rest; range profiles. With the formats that are compared.
CASES = (("sar_r.toml", FORMATS), ("sar_r.scr", ("hdf5",)), ("barker_chirp.toml", ("hdf5",)), ("stepped_srp.toml", ("npy", "hdf5")))


def run(*words):
    finished = subprocess.run(words, capture_output=True, text=True, check=False)
    if finished.returncode:
        sys.exit(f"{words}\nstatus {finished.returncode}\n{finished.stdout}{finished.stderr}")
    return finished


def made_by_run(sarsim, scene, folder, *options):
    run(sarsim, "run", scene, "1", "--quiet", "--out", folder, *options)
    return next(path for path in folder.iterdir() if path.is_file()).read_bytes()


def samples_of(npy):
    (length,) = struct.unpack("<H", npy[8:10])
    return npy[10 + length :]


def main():
    sarsim, record, examples = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for example, formats in CASES:
            scene = pathlib.Path(examples) / example
            for word in formats:
                expected = made_by_run(sarsim, scene, folder / f"{example}-{word}", "--format", word)
                run(record, scene, "1", folder / "own", word)
                if (folder / "own").read_bytes() != expected:
                    sys.exit(f"{example}: other bytes in {word}")
                (folder / "own").unlink()
            for precision, options in (("float", ()), ("double", ("--double",))):
                npy = made_by_run(sarsim, scene, folder / f"{example}-{precision}", "--format", "npy", *options)
                run(record, scene, "1", folder / "own", precision)
                if (folder / "own").read_bytes() != samples_of(npy):
                    sys.exit(f"{example}: other samples in {precision}")
                (folder / "own").unlink()


main()
