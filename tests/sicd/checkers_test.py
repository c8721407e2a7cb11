#!/usr/bin/env python3
"""SICD files of the program under the checkers of sarkit and sarpy, and projected by both.

    checkers_test.py NAME...      scenes

Where sarkit, sarpy and what they need are missing, SARSIM_TEST_PYTHON may name an interpreter that has them. Exit status:
0 as it should be, 1 not, 77 packages are missing.
"""

import importlib.util
import logging
import os
import pathlib
import sys
import tempfile
import warnings

SKIPPED = 77
missing = [name for name in ("numpy", "sarkit", "sarpy", "lxml", "shapely") if importlib.util.find_spec(name) is None]
if missing:
    other = os.environ.pop("SARSIM_TEST_PYTHON", "")
    if other:
        os.execv(other, [other, "-B", *sys.argv])
    print(f"{sys.executable} has no {', '.join(missing)}; SARSIM_TEST_PYTHON may name an interpreter that has")
    sys.exit(SKIPPED)

import numpy as np  # noqa: E402
import sarkit.sicd as sksicd  # noqa: E402
import sarkit.verification as skver  # noqa: E402

warnings.simplefilter("ignore")
import sarpy.consistency.sicd_consistency as sarpy_check  # noqa: E402
from sarpy.io.complex.converter import open_complex  # noqa: E402

import sicd_file  # noqa: E402
import sicd_test as own  # noqa: E402


def check_by_both(path):
    with path.open("rb") as file:
        checker = skver.SicdConsistency.from_file(file)
    checker.check()
    failures = checker.failures()
    print(f"{path.name}: sarkit: {len(checker.passes())} checks passed, {len(failures)} failed")
    assert not failures, failures
    errors = []

    class Errors(logging.Handler):
        def emit(self, record):
            if record.levelno >= logging.ERROR:
                errors.append(record.getMessage())

    handler = Errors()
    logging.getLogger().addHandler(handler)
    valid = sarpy_check.check_file(str(path))
    logging.getLogger().removeHandler(handler)
    print(f"{path.name}: sarpy: {'valid' if valid else 'not valid'}, {len(errors)} errors")
    assert valid and not errors, errors


def check_projections(path, points):
    """Where other programs see a target, its peak is: on the Earth and in the image."""
    file = sicd_file.SicdFile(path)
    with path.open("rb") as stream, sksicd.NitfReader(stream) as reader:
        tree = reader.metadata.xmltree
        pixels = reader.read_image()
    other = open_complex(str(path))
    assert np.array_equal(pixels, file.pixels().astype("c8")), "sarkit reads other pixels"
    assert np.array_equal(other[:, :], file.pixels().astype("c8")), "sarpy reads other pixels"
    steps = np.array([file.number("Grid/Row/SS"), file.number("Grid/Col/SS")])
    worst = 0.0
    for point in points:
        grid, _, good = sksicd.scene_to_image(tree, point)
        assert good
        wanted = sksicd.xrowycol_to_rowcol(tree, grid)
        sarpy_wanted = other.sicd_meta.project_ground_to_image(point)[0]
        offsets = [steps[i] * file.offset(d, *wanted) for i, d in enumerate(("Row", "Col"))]
        row, column, _ = sicd_file.peak(pixels.astype("c16"), *wanted, offsets)
        there = np.array([row, column])
        into_image = np.abs((there - wanted) * steps).max(), np.abs((there - sarpy_wanted) * steps).max()
        # To the plane through the target, level there.
        lon, lat = np.arctan2(point[1], point[0]), np.arctan2(point[2], 0.99330562 * np.hypot(point[0], point[1]))
        up = np.array([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])
        place = sksicd.rowcol_to_xrowycol(tree, there)
        ground, _, good = sksicd.image_to_ground_plane(tree, place, point, up)
        assert good
        sarpy_ground = other.sicd_meta.project_image_to_ground(there, projection_type="PLANE", gref=point, ugpn=up)
        onto_earth = np.linalg.norm(ground - point), np.linalg.norm(sarpy_ground - point)
        print(
            f"{path.stem}: ground to image off by {into_image[0]:.4f} m (sarkit), {into_image[1]:.4f} m (sarpy); "
            f"image to ground by {onto_earth[0]:.4f}, {onto_earth[1]:.4f} m"
        )
        worst = max(worst, *into_image, *onto_earth)
    assert worst < 0.05, worst


def main():
    with tempfile.TemporaryDirectory() as folder:
        for name in sys.argv[1:]:
            path = pathlib.Path(folder) / f"{name}.nitf"
            points = own.focused(pathlib.Path(folder), name, path)
            check_by_both(path)
            check_projections(path, points)


if __name__ == "__main__":
    main()
