#!/usr/bin/env python3
"""Puts arrays together from the places that `sarsim convert --references` names, with nothing but the standard library,
and compares their bytes with those that the program itself copies.

The program is SARSIM_PROGRAM or SARSIM_BUILT_PROGRAM of the environment.
"""

import base64
import json
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile

SCENE = """$TARGET Earth 1000 0 0 0 0 0 1 0 ISOTROPIC
$RADAR Radar1 Earth CHIRP 0.03 500 RECT CONSTANT 1000 SINGLE 1 1 0 0 ISOTROPIC SAME FIXED 0 0 RECT NO_STC
$SIMULATION Radar1 900 1200 0 {end} 8 0.05 1E-6 HDF5 RAW sim.h5 BEGIN 1 1
"""
SIZES = {"|u1": 1, "<u2": 2, "<f4": 4, "<i2": 2, "<c8": 8, "<c16": 16, "<f8": 8, "<i4": 4, "<U1": 4}


def sarsim(*words, status=0):
    program = os.environ.get("SARSIM_PROGRAM") or os.environ["SARSIM_BUILT_PROGRAM"]
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)
    assert done.returncode == status, f"{words}: status {done.returncode}: {done.stderr}"
    return done.stderr


def recorded(folder, pulses, *words):
    (folder / "scene.scr").write_text(SCENE.format(end=f"{(pulses - 1) / 1000 + 0.0004:.4f}"))
    sarsim("run", folder / "scene.scr", "--out", folder, "--quiet", "--force", *words)
    return next(path for path in (folder / "sim.h5", folder / "sim.npy") if path.exists())


class References:
    """The arrays of a file of references."""

    def __init__(self, path):
        text = json.loads(path.read_text())
        assert text["version"] == 1
        self.file = text["templates"]["file"]
        self.refs = text["refs"]
        self.inline = 0
        assert json.loads(self.refs[".zgroup"]) == {"zarr_format": 2}

    def names(self):
        return sorted(name.split("/")[0] for name in self.refs if name.endswith("/.zarray"))

    def attributes(self, name=None):
        return json.loads(self.refs[f"{name}/.zattrs" if name else ".zattrs"])

    def piece(self, reference):
        if isinstance(reference, str):
            self.inline += 1
            assert reference.startswith("base64:")
            return base64.b64decode(reference[len("base64:") :], validate=True)
        address, offset, size = reference
        assert address == "{{file}}"
        with open(self.file, "rb") as file:
            file.seek(offset)
            return file.read(size)

    def array(self, name):
        """Type, shape and bytes, as any reader of Zarr puts them together."""
        about = json.loads(self.refs[f"{name}/.zarray"])
        assert about["zarr_format"] == 2 and about["order"] == "C" and about["compressor"] is None
        shape, chunks = about["shape"], about["chunks"]
        assert chunks[1:] == shape[1:]
        assert len(self.attributes(name)["_ARRAY_DIMENSIONS"]) == len(shape)
        row = SIZES[about["dtype"]] * math.prod(shape[1:])
        pieces = []
        for i in range(-(-shape[0] // chunks[0])):
            pieces.append(self.piece(self.refs["/".join([name, ".".join([str(i)] + ["0"] * (len(shape) - 1))])]))
            assert len(pieces[-1]) == row * chunks[0], f"{name}: piece {i} is not full"
        return about["dtype"], shape, b"".join(pieces)[: row * shape[0]]


def bytes_of_npy(path):
    """What stands behind the header of NumPy."""
    data = path.read_bytes()
    return data[10 + struct.unpack("<H", data[8:10])[0] :]


def check(folder, path, kind, shape, copy=None):
    sarsim("convert", path, "--references", folder / "r.json", "--force")
    references = References(folder / "r.json")
    found_kind, found_shape, found = references.array("samples")
    assert (found_kind, found_shape) == (kind, shape), (found_kind, found_shape)
    if copy is None and path.suffix != ".npy":
        copy = folder / "copy.npy"
        sarsim("convert", path, copy, "--force", *(["--counts"] if kind == "<i4" else []))
    assert found == bytes_of_npy(copy or path), "other samples"
    return references


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        # A number of pulses that nothing divides: the last piece is not full, and stands in the references themselves.
        for pulses, inline in ((20, 0), (10007, 1)):
            references = check(folder, recorded(folder, pulses), "<c8", [pulses, 100])
            assert references.inline == inline, references.inline
            assert references.attributes("samples")["_ARRAY_DIMENSIONS"] == ["pulse_time_s", "slant_range_m"]
            assert references.attributes("samples")["units"] == "V"
            assert references.attributes()["bits"] == 8 and "CHIRP" in references.attributes()["script"]
            times = struct.unpack(f"<{pulses}d", references.array("pulse_time_s")[2])
            assert all(abs(time - 0.001 * i) < 1e-9 for i, time in enumerate(times)), times[:3]
            assert references.array("world_axis")[2].decode("utf-32-le") == "xyz"
            assert references.names() == sorted(
                "samples pulse_time_s carrier_hz slant_range_m platform_position_m platform_velocity_mps".split()
                + ["platform_rotation_rad", "world_axis"]
            ), references.names()
        # Copies are in single precision, so doubles are compared with those of another run.
        (folder / "npy").mkdir()
        doubles = recorded(folder / "npy", 20, "--double", "--format", "npy")
        check(folder, recorded(folder, 20, "--double"), "<c16", [20, 100], doubles)
        references = check(folder, recorded(folder, 20, "--counts"), "<i4", [20, 100, 2])
        assert references.attributes("samples")["_ARRAY_DIMENSIONS"][2] == "iq"
        assert references.array("iq")[2].decode("utf-32-le") == "IQ"
        (folder / "sim.h5").unlink()
        check(folder, recorded(folder, 20, "--format", "npy"), "<c8", [20, 100])
        check(folder, recorded(folder, 20, "--format", "npy", "--counts"), "<i4", [20, 100, 2])
        # BINARY, by its script: counts with their offset, and the axes of the recording.
        for bits, kind in ((8, "|u1"), (12, "<u2")):
            scene = folder / "counts.scr"
            scene.write_text(SCENE.format(end="0.0194").replace(" 8 0.05", f" {bits} 0.05").replace("HDF5 RAW sim.h5", "BINARY RAW sim.bin"))
            sarsim("run", scene, "--out", folder, "--quiet", "--force")
            sarsim("convert", folder / "sim.bin", "--references", folder / "r.json", "--force", "--script", scene)
            references = References(folder / "r.json")
            found_kind, shape, found = references.array("samples")
            assert (found_kind, shape) == (kind, [20, 100, 2]), (found_kind, shape)
            assert found == (folder / "sim.bin").read_bytes()
            assert references.attributes("samples")["add_offset"] == -(2 ** (bits - 1) - 1)
            assert references.attributes("samples")["_ARRAY_DIMENSIONS"] == ["pulse_time_s", "slant_range_m", "iq"]
            times = struct.unpack("<20d", references.array("pulse_time_s")[2])
            assert all(abs(time - 0.001 * i) < 1e-9 for i, time in enumerate(times)), times
            assert struct.unpack("<100d", references.array("slant_range_m")[2])[0] == 900.0
        # SigMF, and an image with a header of ENVI.
        sarsim("run", folder / "scene.scr", "--out", folder, "--quiet", "--format", "sigmf", "--force")
        sarsim("convert", folder / "sim.sigmf-meta", "--references", folder / "r.json", "--force")
        references = References(folder / "r.json")
        assert references.array("samples") == ("<c8", [20, 100], (folder / "sim.sigmf-data").read_bytes())
        assert len(references.array("slant_range_m")[2]) == 800
        (folder / "a.img").write_bytes(struct.pack("<12f", *range(12)))
        header = "ENVI\nsamples = 3\nlines = 2\nbands = 1\nheader offset = 0\ndata type = 6\ninterleave = bsq\nbyte order = 0\n"
        header += "image plane = {ground grid}\nazimuth first m = {-5}\nazimuth step m = {2.5}\n"
        header += "range first m = {100}\nrange step m = {0.5}\n"
        (folder / "a.hdr").write_text(header)
        sarsim("convert", folder / "a.img", "--references", folder / "r.json", "--force")
        references = References(folder / "r.json")
        assert references.array("samples") == ("<c8", [2, 3], (folder / "a.img").read_bytes())
        assert references.attributes("samples")["_ARRAY_DIMENSIONS"] == ["azimuth_m", "ground_range_m"]
        assert struct.unpack("<2d", references.array("azimuth_m")[2]) == (-5.0, -2.5)
        assert struct.unpack("<3d", references.array("ground_range_m")[2]) == (100.0, 100.5, 101.0)
        # What is refused.
        assert "exists" in sarsim("convert", folder / "sim.npy", "--references", folder / "r.json", status=2)
        sarsim("convert", folder / "sim.npy", folder / "sim.asc", "--bits", "8", "--lsb", "1e-6", "--counts")
        message = sarsim("convert", folder / "sim.asc", "--references", folder / "t.json", status=2)
        assert "(ascii)" in message and "convert it to .h5, .npy or .zarr" in message, message
        message = sarsim("convert", folder / "scene.scr", "--references", folder / "t.json", status=2)
        assert "is a scene" in message, message
        message = sarsim("convert", folder / "sim.npy", folder / "x.h5", "--references", folder / "t.json", status=2)
        assert "writes no samples" in message, message
        assert not (folder / "t.json").exists()
    return 0


sys.exit(main())
