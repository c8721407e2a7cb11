#!/usr/bin/env python3
"""Random geometries, focused by the program and judged by back-projection of the recorded samples in NumPy.

    focusing_draws.py SARSIM [--draws N] [--first K] [--methods default omega-k ...] [--jobs J] [--keep FOLDER]
    focusing_draws.py SARSIM --numbers K L ...   these draws
    focusing_draws.py SARSIM --show K            the scene of draw K

Each draw is simulated, focused by the default command (and by each method that is named), and compared at its point with
the judge: amplitude, phase, position, widths. It is right within 0.1 dB, 0.02 rad and a twentieth of a cell; otherwise the
program has to refuse it, or to give a warning with a number within a factor of two of what the judge finds. Exit status:
0 if with the first method at least nine of ten draws are right, all others are refused or warned of in this way, and at
most one of fifty right draws gets a warning; 1 otherwise; 77 without Python with NumPy and h5py."""

import argparse
import collections
import concurrent.futures
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import with_numpy  # noqa: E402, F401

try:
    import h5py
except ImportError:
    print("skipped: no h5py")
    sys.exit(77)
import numpy as np  # noqa: E402

import geometry  # noqa: E402
import images  # noqa: E402
import judge  # noqa: E402

MOST_DB, MOST_RAD, MOST_CELLS = 0.1, 0.02, 0.05
METHODS = ("default", "omega-k", "range-doppler", "chirp-scaling", "back-projection")


def run(program, *arguments):
    """Exit status, standard output and error of the program."""
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, check=False, timeout=900)
    return done.returncode, done.stdout, done.stderr


def recorded(draw, folder):
    """The recording of a draw; the flight is computed here and compared with that of the file."""
    with h5py.File(folder / "echoes.h5") as file:
        samples = file["samples"][:].astype(complex)
        times = file["pulse_time_s"][:]
        of_file = file["platform_position_m"][:]
        first = 2 * file["slant_range_m"][0] / judge.LIGHT
    places = geometry.flight(draw, times)
    apart = np.abs(places - of_file).max()
    if apart > 1e-7 * draw.slant + 1e-6:
        raise RuntimeError(f"the flight of the file is {apart} m off")
    step = 1e-4 / draw.prf
    velocities = (geometry.flight(draw, times + step) - geometry.flight(draw, times - step)) / (2 * step)
    return judge.Recording(
        samples, first, draw.sample_rate, draw.carrier, draw.bandwidth, draw.pulse_width, of_file, velocities, times
    )


def radar_equation(draw, recording):
    """Mean amplitude of the echoes in the middle of the beam [V]."""
    distances = np.linalg.norm(recording.places - np.array(draw.target), axis=1)
    return np.mean(np.sqrt(1000.0 * 100.0 * draw.wavelength**2 / (4 * math.pi) ** 3) / distances**2)


def compared(draw, recording, truth, image):
    """Errors of an image at the point: dB, rad, metres in azimuth and range, ratios of widths to those of the judge."""
    point = np.array(draw.target)
    place = image.place_of(point)
    if not image.holds(place):
        return {"outside": True}
    azimuth_cell, range_cell = cells_of(draw, recording, image)
    peak = peak_near(image, place, azimuth_cell, range_cell)
    # Phases are taken from the distance to the line; a grid of level ground says nothing of it.
    distance = place[1] if image.across is None else judge.distance_from_line(recording.times, recording.places, point)
    turns = 2 * draw.carrier * distance / judge.LIGHT
    value = image.at(peak) * image.carrier_between(peak, place) * np.exp(2j * np.pi * (turns - round(turns)))
    found = {
        "db": 20 * math.log10(abs(value) / abs(truth)),
        "rad": float(np.angle(value / truth)),
        "azimuth_m": peak[0] - place[0],
        "range_m": peak[1] - place[1],
        "azimuth_cell": azimuth_cell,
        "range_cell": range_cell,
        "cells": cells_off(draw, recording, image, peak[0] - place[0], peak[1] - place[1]),
    }
    for axis, cell in ((0, azimuth_cell), (1, range_cell)):
        found["azimuth_width" if axis == 0 else "range_width"] = width_ratio(recording, image, point, place, peak, axis, cell)
    return found


def cells_of(draw, recording, image):
    """Resolution along both axes [m], from the directions in which the point is seen."""
    sight = np.array(draw.target) - recording.places
    distances = np.linalg.norm(sight, axis=1)
    sines = sight @ image.along / distances
    waves = [2 * f * s / judge.LIGHT for f in (draw.carrier - draw.bandwidth / 2, draw.carrier + draw.bandwidth / 2) for s in sines]
    cosines = np.sqrt(1 - sines**2)
    ranges = [2 * f * c / judge.LIGHT for f in (draw.carrier - draw.bandwidth / 2, draw.carrier + draw.bandwidth / 2) for c in cosines]
    return 1 / (max(waves) - min(waves)), 1 / (max(ranges) - min(ranges))


def cells_off(draw, recording, image, azimuth_m, range_m):
    """Displacement in cells: along the line of sight in the middle of the flight or across it, the larger."""
    sight = np.array(draw.target) - recording.places
    angles = np.arcsin(sight @ image.along / np.linalg.norm(sight, axis=1))
    middle = angles.mean()
    along = azimuth_m * np.sin(middle) + range_m * np.cos(middle)
    across = azimuth_m * np.cos(middle) - range_m * np.sin(middle)
    return float(max(abs(along) / draw.cell, abs(across) * 2 * (angles.max() - angles.min()) / draw.wavelength))


def peak_near(image, place, azimuth_cell, range_cell):
    """The largest magnitude within two cells, by halved steps from the largest of a lattice."""
    lattice = [
        (place[0] + i * azimuth_cell / 2, place[1] + k * range_cell / 2) for i in range(-4, 5) for k in range(-4, 5)
    ]
    best = max((p for p in lattice if image.holds(p)), key=lambda p: abs(image.at(p)), default=place)
    height = abs(image.at(best))
    step = (azimuth_cell / 4, range_cell / 4)
    for _ in range(9):
        better = True
        while better:
            better = False
            for da, dr in ((1, 0), (-1, 0), (0, 1), (0, -1)):
                other = (best[0] + da * step[0], best[1] + dr * step[1])
                if image.holds(other) and abs(image.at(other)) > height:
                    best, height, better = other, abs(image.at(other)), True
        step = (step[0] / 2, step[1] / 2)
    return best


CUTS = {}  # Of the judge: images of a recording by several methods share their axes.


def width_ratio(recording, image, point, place, peak, axis, cell):
    """Width at -3 dB of the image over that of the judge, along an axis; None where it is not to be seen."""
    offsets = np.linspace(-0.9, 0.9, 15) * cell
    key = (axis, cell, tuple(np.round(image.along, 9)), tuple(point))
    cached = CUTS.get(key)
    ours, theirs = [], []
    for offset in offsets:
        move = (offset, 0.0) if axis == 0 else (0.0, offset)
        ours.append(abs(image.at((peak[0] + move[0], peak[1] + move[1]))))
        if cached is None:
            at = image.point_at((place[0] + move[0], place[1] + move[1]), point)
            theirs.append(abs(judge.integrated(recording, at)[0]))
    if cached is None:
        cached = CUTS[key] = np.array(theirs)
    mine, right = judge.half_width(offsets, np.array(ours)), judge.half_width(offsets, cached)
    return mine / right if mine and right else None


def is_right(found):
    """Whether the errors are within the tolerance."""
    if found.get("outside"):
        return False
    return abs(found["db"]) <= MOST_DB and abs(found["rad"]) <= MOST_RAD and found["cells"] <= MOST_CELLS


# Warnings about something other than the focused point.
OTHER = re.compile("the azimuth beamwidth|the elevation beamwidth|left and right|ambigu|beam's Doppler bandwidth|beam has a Doppler band|echo of|in flight")


def warnings_of(report):
    """What warnings that concern the image of a point found: not what they expected, whose limits are numbers too."""
    return [
        f'{p["message"]}; found {p.get("found", "")}'
        for p in report.get("problems", [])
        if p["severity"] == "warning" and not OTHER.search(p["text"])
    ]


def numbers_before(unit, texts):
    """Magnitudes of the numbers before a unit."""
    pattern = re.compile(r"([-+]?\d[\d.]*(?:e[-+]?\d+)?) (?:dB|rad|m)\b".replace("(?:dB|rad|m)", unit), re.IGNORECASE)
    return [abs(float(x)) for text in texts for x in pattern.findall(text)]


def fits(found, texts):
    """Whether a warning has a number within a factor of two of an error that is too large."""
    wrong = []
    if found.get("outside"):
        return bool(texts)
    if abs(found["db"]) > MOST_DB:
        wrong.append(("dB", abs(found["db"])))
    if abs(found["rad"]) > MOST_RAD:
        wrong.append(("rad", abs(found["rad"])))
    if found["cells"] > MOST_CELLS:
        wrong += [("m", abs(found["azimuth_m"])), ("m", abs(found["range_m"]))]
    return any(0.5 * error <= n <= 2 * error for unit, error in wrong for n in numbers_before(unit, texts))


def kind_of(status, found, texts):
    """Kind of a draw: right, refused, warned (with a right number), misnumbered, silent, or false (right, but with a warning)."""
    if status != 0:
        return "refused"
    if is_right(found):
        return "false" if texts else "right"
    if not texts:
        return "silent"
    return "warned" if fits(found, texts) else "misnumbered"


def judged(program, number, methods, keep):
    """Result of a draw: its description, and for each method its kind, errors and warnings."""
    CUTS.clear()
    draw = geometry.draw_of(number)
    out = {"number": number, "words": draw.words(), "methods": {}}
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(keep) / str(number) if keep else pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "scene.toml").write_text(geometry.scene(draw), encoding="utf-8")
        status, _, error = run(program, "run", folder / "scene.toml", "--out", folder, "--force", "--quiet", "--threads", 1)
        if status != 0:
            out["failed"] = error.strip()[:400]
            return out
        recording = recorded(draw, folder)
        truth, whole = judge.integrated(recording, np.array(draw.target))
        out["coherent"] = abs(truth) / whole
        if out["coherent"] < 0.999:
            out["failed"] = f"the judge finds {out['coherent']:.4f} of the echoes at the point"
            return out
        out["theory_db"] = 20 * math.log10(abs(truth) / radar_equation(draw, recording)) if draw.spot and not draw.aim else None
        for method in methods:
            out["methods"][method] = focused(program, draw, recording, truth, folder, method)
        if keep:
            (folder / "result.json").write_text(json.dumps(out, indent=1), encoding="utf-8")
    return out


def focused(program, draw, recording, truth, folder, method):
    """Result of a method on a recording."""
    picture = folder / f"{method}.npy"
    more = [] if method == "default" else ["--algorithm", method]
    command = ["focus", folder / "echoes.h5", "--out", picture, "--force", "--json", "--threads", 1, *more]
    status, output, error = run(program, *command)
    result = {"status": status, "kind": "refused", "texts": []}
    if status != 0:
        result["texts"] = [error.strip()[:400] or output[:400]]
        return result
    report = json.loads(output)
    result["texts"] = warnings_of(report)
    result["algorithm"] = report["algorithm"]
    result["found"] = compared(draw, recording, truth, images.read(str(picture)))
    result["kind"] = kind_of(status, result["found"], result["texts"])
    return result


KINDS = ("right", "false", "refused", "warned", "misnumbered", "silent")


def table(results, methods):
    """Shares and worst errors of right and all draws, per method."""
    lines = [
        f"{'method':16s} " + " ".join(f"{k:>11s}" for k in KINDS) + "   of those that are right: dB, rad, cell, widths"
    ]
    for method in methods:
        of = [r["methods"][method] for r in results if method in r["methods"]]
        counts = collections.Counter(m["kind"] for m in of)
        good = [m["found"] for m in of if m["kind"] in ("right", "false")]
        worst = lambda f: max((f(g) for g in good), default=0.0)
        widths = [abs(g[k] - 1) for g in good for k in ("azimuth_width", "range_width") if g[k]]
        lines.append(
            f"{method:16s} "
            + " ".join(f"{counts[k]:5d} {100 * counts[k] / max(len(of), 1):4.1f}%" for k in KINDS)
            + f"   {worst(lambda g: abs(g['db'])):.3f} {worst(lambda g: abs(g['rad'])):.4f} "
            + f"{worst(lambda g: g['cells']):.3f} "
            + f"{max(widths, default=0.0):.3f}"
        )
    return "\n".join(lines)


def as_promised(results, method):
    """Whether all draws were made and the goal is met."""
    kinds = collections.Counter(r["methods"][method]["kind"] if method in r["methods"] else "failed" for r in results)
    right = kinds["right"] + kinds["false"]
    failed = kinds["silent"] + kinds["misnumbered"] + kinds["failed"]
    return failed == 0 and right >= 0.9 * len(results) and kinds["false"] <= 0.02 * right


def report_of(result, methods):
    """Lines about the methods of a draw that are not simply right."""
    lines = []
    for method in methods:
        m = result["methods"].get(method)
        if not m or m["kind"] in ("right",):
            continue
        found = m.get("found") or {}
        errors = " ".join(
            f"{k} {v:.3g}" for k, v in found.items() if isinstance(v, float) and k not in ("azimuth_cell", "range_cell")
        )
        lines.append(f"  {method} ({m.get('algorithm', '')}): {m['kind']}: {errors or found}; " + " | ".join(t[:260] for t in m["texts"]))
    if lines or "failed" in result:
        lines.insert(0, f"{result['number']}: {result['words']} {result.get('failed', '')}")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--draws", type=int, default=400)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--methods", nargs="*", default=["default"])
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--keep")
    parser.add_argument("--json")
    parser.add_argument("--numbers", type=int, nargs="+")
    parser.add_argument("--show", type=int)
    parser.add_argument("--quiet", action="store_true", help="no line of draws that are refused or warned of as promised")
    arguments = parser.parse_args()
    if arguments.show is not None:
        print(geometry.scene(geometry.draw_of(arguments.show)))
        return 0
    methods = METHODS if arguments.methods == ["all"] else arguments.methods
    numbers = arguments.numbers or range(arguments.first, arguments.first + arguments.draws)
    results = []
    with concurrent.futures.ProcessPoolExecutor(arguments.jobs) as pool:
        jobs = [pool.submit(judged, arguments.program, n, methods, arguments.keep) for n in numbers]
        for job in concurrent.futures.as_completed(jobs):
            result = job.result()
            results.append(result)
            text = report_of(result, methods)
            if text and not arguments.quiet:
                print(text, flush=True)
    results.sort(key=lambda r: r["number"])
    if arguments.json:
        pathlib.Path(arguments.json).write_text(json.dumps(results, indent=1), encoding="utf-8")
    print(table(results, methods))
    theory = [abs(r["theory_db"]) for r in results if r.get("theory_db") is not None]
    coherent = [r["coherent"] for r in results if "coherent" in r]
    print(f"judge against the radar equation: {max(theory, default=0):.4f} dB; least coherence {min(coherent, default=1):.6f}")
    return 0 if as_promised(results, methods[0]) else 1


if __name__ == "__main__":
    sys.exit(main())
