#!/usr/bin/env python3
"""Compares SigMF recordings of the program with the rules of SigMF and with the samples that the program copies itself.

    sigmf_test.py schema     rules of SigMF 1.2 as far as they concern us, by jsonschema
    sigmf_test.py package    the package `sigmf` of PyPI validates the recording and reads its samples

The program is SARSIM_PROGRAM or SARSIM_BUILT_PROGRAM of the environment, an interpreter with the package
SARSIM_TEST_PYTHON. Exit status: 0 as it should be, 1 not, 77 packages are missing.
"""

import datetime
import importlib.util
import json
import os
import pathlib
import subprocess
import sys
import tempfile

SKIPPED = 77
NEEDS = {"schema": ("numpy", "jsonschema"), "package": ("numpy", "sigmf")}
SCENE = """format = "sarsim 2"
[world]
frame = "earth"
anchor = { latitude = "52.3 deg", longitude = "13.4 deg" }
epoch = "2024-04-01T22:59:42Z"
[[target]]
positions = [[1000, 0, 0]]
[[radar]]
name = "R"
pulse = { type = "chirp", bandwidth = "30 MHz", width = "500 ns" }
repetition = "1 kHz"
carrier = "1 GHz"
power = "1 kW"
[[recording]]
radar = "R"
file = "sim.h5"
format = "hdf5"
range = ["900 m", "1200 m"]
time = ["0 s", "0.0199 s"]
sample_rate = "50 MHz"
bits = 12
lsb = "1e-6 mV"
"""

# Of the rules of SigMF 1.2.5 those for what is written; extensions are objects of their own there.
SCHEMA = {
    "type": "object",
    "required": ["global", "captures", "annotations"],
    "additionalProperties": False,
    "properties": {
        "global": {
            "type": "object",
            "required": ["core:datatype", "core:version"],
            "properties": {
                "core:datatype": {"enum": ["cf32_le", "cf64_le", "ci16_le", "ci32_le"]},
                "core:version": {"type": "string", "pattern": r"^\d+\.\d+\.\d+$"},
                "core:num_channels": {"type": "integer", "minimum": 1},
                "core:sample_rate": {"type": "number", "exclusiveMinimum": 0, "maximum": 1e12},
                "core:recorder": {"type": "string"},
                "core:description": {"type": "string"},
                "core:extensions": {
                    "type": "array",
                    "minItems": 1,
                    "items": {
                        "type": "object",
                        "required": ["name", "version", "optional"],
                        "additionalProperties": False,
                        "properties": {
                            "name": {"type": "string"},
                            "version": {"type": "string"},
                            "optional": {"type": "boolean"},
                        },
                    },
                },
            },
            "patternProperties": {"^sarsim:[a-z_]+$": {}},
            "additionalProperties": False,
        },
        "captures": {
            "type": "array",
            "minItems": 1,
            "items": {
                "type": "object",
                "required": ["core:sample_start"],
                "properties": {
                    "core:sample_start": {"type": "integer", "minimum": 0},
                    "core:frequency": {"type": "number", "minimum": -1e12, "maximum": 1e12},
                    "core:datetime": {"type": "string", "pattern": r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?Z$"},
                },
                "patternProperties": {"^sarsim:[a-z_]+$": {}},
                "additionalProperties": False,
            },
        },
        "annotations": {"type": "array", "maxItems": 0},
    },
}


def skip_without(modules):
    """Ends the test where a package is missing, after another interpreter has been tried."""
    missing = [name for name in modules if importlib.util.find_spec(name) is None]
    if not missing:
        return
    other = os.environ.pop("SARSIM_TEST_PYTHON", "")
    if other:
        os.execv(other, [other, "-B", *sys.argv])
    print(f"{sys.executable} has no {', '.join(missing)}; SARSIM_TEST_PYTHON may name an interpreter that has")
    sys.exit(SKIPPED)


def sarsim(*words):
    program = os.environ.get("SARSIM_PROGRAM") or os.environ["SARSIM_BUILT_PROGRAM"]
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{words}: {done.stderr}"
    return done.stdout


def recordings(folder):
    """SigMF by `run` and by `convert`, of volts, doubles and counts, each with the samples as an array."""
    import numpy

    (folder / "scene.toml").write_text(SCENE)
    sarsim("run", folder / "scene.toml", "--out", folder, "--quiet")
    for number, words in enumerate(((), ("--double",), ("--counts",))):
        out = folder / str(number)
        for kind in ("npy", "sigmf"):
            sarsim("run", folder / "scene.toml", "--out", out, "--quiet", "--format", kind, *words)
        yield out / "sim.sigmf-meta", numpy.load(out / "sim.npy")
    sarsim("convert", folder / "sim.h5", folder / "copy.sigmf-meta")
    own, copy = (json.loads(path.read_text()) for path in (folder / "0/sim.sigmf-meta", folder / "copy.sigmf-meta"))
    own["global"].pop("sarsim:script"), copy["global"].pop("sarsim:script")
    assert own == copy
    yield folder / "copy.sigmf-meta", numpy.load(folder / "0" / "sim.npy")


def schema(folder):
    import jsonschema
    import numpy

    for path, expected in recordings(folder):
        meta = json.loads(path.read_text())
        jsonschema.Draft202012Validator(SCHEMA).validate(meta)
        kind = {"cf32_le": "<c8", "cf64_le": "<c16", "ci16_le": "<i2"}[meta["global"]["core:datatype"]]
        samples = numpy.fromfile(path.with_suffix(".sigmf-data"), kind)
        numpy.testing.assert_array_equal(samples, expected.ravel())
        captures = meta["captures"]
        assert len(captures) == 20 and captures[3]["core:sample_start"] == 3 * expected.shape[1]
        assert captures[3]["core:frequency"] == 1e9 and abs(captures[3]["sarsim:pulse_time_s"] - 0.003) < 1e-12
        at = datetime.datetime.fromisoformat(captures[3]["core:datetime"].replace("Z", "+00:00"))
        since = at - datetime.datetime(2024, 4, 1, 22, 59, 42, tzinfo=datetime.timezone.utc)
        assert abs(since.total_seconds() - 0.003) < 1e-6, captures[3]
        assert meta["global"]["core:sample_rate"] == 50e6
        # The program reads it back, axes and script included.
        assert "send times" in sarsim("info", path)
        sarsim("convert", path, folder / "back.npy", "--force", *(["--counts"] if kind == "<i2" else []))
        if kind != "<c16":
            numpy.testing.assert_array_equal(numpy.load(folder / "back.npy"), expected)
        sarsim("plot", path, "-o", folder / "p.png", "--force")


def package(folder):
    import numpy
    import sigmf

    for path, expected in recordings(folder):
        recording = sigmf.fromfile(str(path))
        recording.validate()
        if expected.ndim == 2:
            numpy.testing.assert_allclose(recording.read_samples(), expected.ravel(), rtol=1e-7)
        assert recording.get_captures()[3]["core:frequency"] == 1e9


def main():
    name = sys.argv[1]
    skip_without(NEEDS[name])
    with tempfile.TemporaryDirectory() as folder:
        globals()[name](pathlib.Path(folder))


main()
