"""What work in memory comes to is, once written, what the command writes: images, headers and tables, byte by byte.

usage: same_work_test.py SARSIM WORK_PROGRAM EXAMPLES
"""

import filecmp
import pathlib
import subprocess
import sys
import tempfile

sarsim, program, examples = sys.argv[1:]
EXCHANGED = pathlib.Path(__file__).resolve().parent.parent / "exchange"

# Work, scene, and the name that the command gives its table of detections: images' name with that ending.
WORK = [("focus", "sar_r", None), ("profiles", "stepped_aircraft", None), ("isar", "turning_ship", None),
        ("doppler", "search_radar", "-detections.csv"), ("search", "search_radar", "-detections.csv")]


def expect_same(work, a, b):
    if not filecmp.cmp(a, b, shallow=False):
        sys.exit(f"{work}: {a.name} in memory and by the command differ")


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    for side in ("memory", "command"):
        (folder / side).mkdir()
    for work, scene, table in WORK:
        path = pathlib.Path(examples) / f"{scene}.toml"
        for ending in (".img", ".h5") if work in ("profiles", "doppler") else (".img",):
            own = folder / "memory" / (work + ending)
            other = folder / "command" / (work + ending)
            detections = folder / "memory" / f"{work}-detections.csv"
            subprocess.run([program, work, path, own, detections], check=True, cwd=folder / "memory")
            subprocess.run([sarsim, work, path, "--out", other, "--quiet", "--force"], check=True, cwd=folder / "command",
                           stdout=subprocess.DEVNULL)
            expect_same(work, own, other)
            if ending == ".img":
                expect_same(work, own.with_suffix(".hdr"), other.with_suffix(".hdr"))
            if table:
                expect_same(work, detections, folder / "command" / (work + table))
    scene = pathlib.Path(examples) / "sar_r.toml"
    for ending in ("cphd", "crsd"):
        own, other = folder / "memory" / f"e.{ending}", folder / "command" / f"e.{ending}"
        options = [f"out={own}", "encoding=ci4", "reference-point=moving", "anchor=47.5,8.25,400"]
        echoes = EXCHANGED / "small_scene.toml"
        subprocess.run([program, "export", echoes, "none", "none", *options], check=True)
        subprocess.run([sarsim, "convert", echoes, other, *(f"--{option}" for option in options[1:])], check=True)
        expect_same("export", own, other)
    subprocess.run([program, "geometry", scene, "none", folder / "table.csv", "radar=Radar1", "start=0", "end=0.1"], check=True)
    told = subprocess.run([sarsim, "geometry", scene, "--radar", "Radar1", "--start", "0", "--end", "0.1", "--csv"],
                          check=True, capture_output=True).stdout
    if (folder / "table.csv").read_bytes() != told:
        sys.exit("geometry: the table differs")
