"""Targets stand at their places, with the phase 0, in images that NumPy alone makes of CPHD files (cphd_image.py).

    cphd_test.py SARSIM SCENE

Exit status: 0 as it should be, 1 not, 77 NumPy is missing.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import with_numpy  # noqa: E402, F401
import numpy as np  # noqa: E402

import cphd_image  # noqa: E402

TARGETS = np.array([[0, 0, 0], [31, 23, 0], [-27, -35, 2]], float)
ANCHOR = [47.5, 8.25, 400.0, 30.0]


def check(path, metres, radians):
    file = cphd_image.Own(path)
    places, x, y = cphd_image.ecf_of(TARGETS, ANCHOR)
    at_places = cphd_image.spread(file, places)
    worst_m = max(cphd_image.peak(file, place, x, y, 0.2, 5) for place in places)
    worst_rad = np.abs(np.angle(at_places)).max()
    print(f"{path.name}: peaks within {worst_m:.4f} m, phases within {worst_rad:.5f} rad")
    assert worst_m <= metres and worst_rad <= radians, path.name


def main(program, scene):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        run = lambda *words: subprocess.run([program, *words], check=True, stderr=subprocess.DEVNULL)
        anchor = "--anchor=" + ",".join(str(number) for number in ANCHOR)
        for name, options in {
            "fixed": [],
            "moving": ["--reference-point", "moving"],
            "given": ["--reference-point", "40,-30,5"],
            "ci4": ["--encoding", "ci4"],
            "ci2": ["--encoding", "ci2"],
        }.items():
            path = folder / f"{name}.cphd"
            run("convert", scene, str(path), anchor, *options)
            check(path, 0.05, 0.01)
        # Points appear again after lambda R PRF/(2 v) in azimuth, which is said where the image is wider.
        words = [program, "focus", str(folder / "fixed.cphd"), "--force", "--out", str(folder / "focused.img")]
        said = subprocess.run(words, check=True, capture_output=True, text=True).stderr
        repeats_m = float(re.search(r"appears again every ([0-9.]+) m", said).group(1))
        expected_m = 299792458 / 9.6e9 * np.hypot(2500, 1500) * 120 / 200
        assert abs(repeats_m / expected_m - 1) < 0.01, (repeats_m, expected_m)
        said = subprocess.run([*words, "--azimuth", "-24:24"], check=True, capture_output=True, text=True).stderr
        assert "appears again" not in said, said
        # From a recording of raw pulses, whose scene it carries: of counts, too.
        run("run", scene, "--pulse", "band-limited", "--out", str(folder), "--set", "Simulation1.range_end=3065m")
        run("convert", str(folder / "small.h5"), str(folder / "recorded.cphd"), anchor)
        check(folder / "recorded.cphd", 0.05, 0.01)


if __name__ == "__main__":
    main(*sys.argv[1:])
