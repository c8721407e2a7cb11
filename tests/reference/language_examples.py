#!/usr/bin/env python3
"""Three scenes of format 2 give the samples of their scripts; the fourth says what later editions add, and is refused
with a message for each thing at its place.

usage: language_examples.py PROGRAM EXAMPLES REFERENCE
"""

import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import with_numpy  # noqa: E402, F401
import numpy  # noqa: E402

# What the fourth scene says that this edition does not know, and where.
AHEAD = {
    23: "attitude", 40: "[platform.gusts]", 51: "[[terrain]]", 59: "geodetic", 66: "fluctuation", 69: "[[antenna]]", 90: "polarisation", 91: "tops",
    93: "[[radar.swath]]", 112: "[[radar.receiver]]", 128: "[[radar.transmitter]]", 141: "receivers", 152: "crsd",
}


def samples(program, scene, folder):
    """The volts of the first recording of a scene."""
    subprocess.run([program, "run", scene, "--format", "npy", "--out", folder, "--quiet", "--force"], check=True)
    return numpy.load(next(pathlib.Path(folder).glob("*.npy")))


def complaint_about(program, name, examples, language, tolerance):
    with tempfile.TemporaryDirectory() as folder:
        ours = samples(program, language / f"{name}.toml", f"{folder}/toml")
        theirs = samples(program, examples / f"{name}.scr", f"{folder}/scr")
    if ours.shape != theirs.shape:
        return f"{name}: {ours.shape} samples instead of {theirs.shape}"
    error = numpy.abs(ours - theirs).max() / numpy.abs(theirs).max()
    return f"{name}: samples differ by {error:.2g}" if not error <= tolerance else ""


def complaints_about_the_fourth(program, scene):
    done = subprocess.run([program, "check", "--json", scene], capture_output=True, text=True, check=False)
    told = [p for p in json.loads(done.stdout)["scripts"][0]["problems"] if p["severity"] == "error"]
    wrong = [] if done.returncode == 2 else [f"{scene.name}: exit status {done.returncode}"]
    for line, word in AHEAD.items():
        said = [p for p in told if p["line"] == line and word.strip("[]") in json.dumps(p)]
        if not said:
            wrong.append(f"{scene.name}:{line}: nothing is said of {word}")
    return wrong


def main():
    program, examples, reference = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    language = reference / "language"
    if not language.is_dir():
        print(f"skipped: there is no folder {language}")
        return 77
    # The path of search_radar is an expression, 1e-11 m beside the typed digits.
    wrong = [complaint_about(program, name, examples, language, tolerance)
             for name, tolerance in (("sar_r", 0.0), ("stepped_srp", 0.0), ("search_radar", 1e-7))]
    wrong += complaints_about_the_fourth(program, language / "tops_bistatic_mimo.toml")
    print("\n".join(filter(None, wrong)) or "as they should be")
    return 1 if any(wrong) else 0


sys.exit(main())
