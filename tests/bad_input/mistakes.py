#!/usr/bin/env python3
"""Makes likely mistakes in a sound script and compares what sarsim says with the record of it.

    SARSIM_PROGRAM=build/dev/src/sarsim tests/bad_input/mistakes.py [--check]

Without --check the record said/likely_mistakes.txt is written, and docs/guide/bad-input.md, which is made of it. Each mistake
must be reported in the words and with the exit status that are given here, whatever the record says. Exit status 1 if it is
not, or if the record differs.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

import page
from base import spoiled
from harness import program

RECORD = page.SAID / "likely_mistakes.txt"

# An aircraft passes two points on the ground at 8.5 km; S band, 100 MHz, 2 us.
SCENE = """\
$PLATFORM Ground
STATIONARY 0 0 0
CONST 0 0 0 0 0 0
STDDEV 0 0 0
STDDEV 0 0 0
$PLATFORM Plane
TRAJECTORY LINEAR LINEAR LINEAR INLINE
2 -1, -100 1, 100
1 0, -8000
1 0, 3000
NOT_ALIGNED
CONST 0 0 0 0 0 0
STDDEV 0 0 0
STDDEV 0 0 0
$TARGET Ground
0 0 0
0 0 0
1 0
ISOTROPIC
$TARGET Ground
20 60 0
0 0 0
1 0
ISOTROPIC
$RADAR R Plane
CHIRP 0.1
2000
RECT
CONSTANT 500
SINGLE 3
1000
30 30 0 300
SINX 10 3
SAME
FIXED -20.6 0
RECT NO_STC
$SIMULATION R
8450 8950
-0.999 1
8 0.12 0
HDF5 RAW base.h5
BEGIN 1 1
"""

CHECK = "check scene.scr"


def carelessly(number, what, changes, words, command=CHECK, status=0):
    return {"number": number, "what": what, "changes": changes, "words": words, "command": command, "status": status}


MISTAKES = [
    carelessly(1, "carrier 3000 for 3 GHz", [("SINGLE 3\n", "SINGLE 3000\n")], "GHz: write 3 for 3 GHz"),
    carelessly(2, "pulse of 2 for 2 us", [("\n2000\n", "\n2\n")], "ns: write 2000 for 2 us"),
    carelessly(3, "PRF of 1 for 1 kHz", [("CONSTANT 500", "CONSTANT 1"), ("-0.999 1", "-0.4 0.4")], "single pulse"),
    carelessly(4, "power too small for the noise", [("\n1000\n30 30", "\n0.0000001\n30 30")], "have too low an SNR"),
    carelessly(5, "sampling frequency of 120 for 120 MHz", [("8 0.12 0", "8 120 0")], "far above the bandwidth"),
    carelessly(6, "bandwidth of 100 for 100 MHz", [("CHIRP 0.1", "CHIRP 100")], "below the bandwidth"),
    carelessly(7, "ranges in km", [("8450 8950", "8.45 8.95")], "Scripts give ranges in metres", status=2),
    carelessly(8, "times in ms", [("-0.999 1", "-999 1000")], "Times are in seconds"),
    carelessly(9, "ranges swapped", [("8450 8950", "8950 8450")], "end beyond the start", status=2),
    carelessly(10, "azimuth and elevation of the beam swapped", [("FIXED -20.6 0", "FIXED 0 -20.6")], "swapped"),
    carelessly(11, "beam upwards", [("FIXED -20.6 0", "FIXED 20.6 0")], "write -20.6"),
    carelessly(12, "beam to the side, counted from the flight", [("FIXED -20.6 0", "FIXED -20.6 90")], "azimuth to 0"),
    carelessly(13, "beam the opposite way", [("FIXED -20.6 0", "FIXED -20.6 180")], "no echo is received.*opposite way"),
    carelessly(14, "comma as decimal mark", [("CHIRP 0.1", "CHIRP 0,1")], "write 0.1", status=2),
    carelessly(15, "number with its unit", [("CHIRP 0.1", "CHIRP 100MHz")], r"\(GHz\): write 0.1", status=2),
    carelessly(16, "keyword misspelt", [("CHIRP 0.1", "CHRIP 0.1")], "did you mean CHIRP", status=2),
    carelessly(17, "target outside the window", [("8450 8950", "9450 9950")], "set the slant range window to about 85"),
    carelessly(18, "platform that does not exist", [("$RADAR R Plane", "$RADAR R Jet")], "Ground, Plane", status=2),
    carelessly(19, "radar called by another name", [("$SIMULATION R\n", "$SIMULATION Radar1\n")], "Write the whole name"),
    carelessly(20, "noise temperature left out", [("30 30 0 300", "30 30 0")], "2 .*or 4", status=2),
    carelessly(
        21,
        "trajectory as rows of t x y z",
        [("2 -1, -100 1, 100\n1 0, -8000\n1 0, 3000", "2\n-1 -100 -8000 3000\n1 100 -8000 3000")],
        "points of each coordinate in a list of their own",
        status=2,
    ),
    carelessly(22, "no $SIMULATION", [(SCENE[SCENE.index("$SIMULATION") :], "")], "defines nothing to compute.*add a .SIMULATION"),
    carelessly(23, "HDF5 under the name of another format", [("base.h5", "base.npy")], "of another format"),
    carelessly(24, "window shorter than the pulse", [("8450 8950", "8530 8630")], "shorter than the pulse"),
    carelessly(25, "sampling frequency equal to the bandwidth", [("8 0.12 0", "8 0.1 0")], "only just exceeds"),
    carelessly(26, "name without .scr", [], r"did you mean scene.scr\?", "run scene", 2),
    carelessly(27, "option misspelt", [], "did you mean .--format", "run scene.scr --fromat npy", 2),
    carelessly(28, "--set without a unit", [], "counts in Hz", "info scene.scr --set R.bandwidth=50"),
    carelessly(29, "RCS in dBsm", [("0 0 0\n1 0\nISOTROPIC\n$R", "0 0 0\n-10 0\nISOTROPIC\n$R")], "negative.*dBsm"),
    carelessly(30, "picture asked from focus", [], "sarsim plot x.img", "focus scene.scr --out x.png", 2),
    carelessly(31, "script of another file", [], "rows", "focus base.h5 --script other.scr --out x.img", 2),
    carelessly(32, "radar that does not move", [("2 -1, -100 1, 100\n", "1 0, 0\n")], "does not move", "focus scene.scr --out x.img", 2),
    carelessly(33, "A/D converter of 3 bits, HDF5", [("8 0.12 0", "3 0.12 0")], "not quantised", "run scene.scr --out made"),
    carelessly(
        34,
        "CENTRE, and a target just inside the window",
        [("8450 8950", "8530 8950"), ("BEGIN", "CENTRE")],
        "cuts the echoes of 2 of 2 targets .*while the beam is on them",
    ),
    carelessly(35, "milliwatts in small letters", [], "mW or MW", "run scene.scr --set R.power=1mw", 2),
    carelessly(36, "chirp of more than twice the carrier", [("SINGLE 3\n", "SINGLE 0.04\n")], "below 0 Hz"),
    carelessly(37, "Hanning window of constant 1", [("RECT NO_STC", "HANNING 1 NO_STC")], "has no effect"),
    carelessly(38, "beam too wide for sin(x)/x", [("SINX 10 3", "SINX 10 90")], "104.5 degrees"),
]


def said(mistake, folder):
    """Exit status and all that a user sees."""
    pathlib.Path(folder, "scene.scr").write_text(spoiled(*mistake["changes"], text=SCENE), encoding="ascii")
    if mistake["number"] == 31:
        subprocess.run([program(), "run", "scene.scr", "--quiet"], cwd=folder, check=True, capture_output=True)
        pathlib.Path(folder, "other.scr").write_text(SCENE.replace("-0.999 1", "-0.5 0.5"), encoding="ascii")
    done = subprocess.run(
        [program(), *mistake["command"].split()], cwd=folder, capture_output=True, text=True, timeout=60, check=False
    )
    return done.returncode, done.stdout + done.stderr


def message_of(mistake, text):
    """The paragraph that names the mistake."""
    paragraphs = []
    for line in text.splitlines():
        if line.startswith("    ") and paragraphs:
            paragraphs[-1] += "\n" + line
        else:
            paragraphs.append(line)
    fitting = [p for p in paragraphs if re.search(mistake["words"], p.replace("\n", " "), re.DOTALL)]
    return fitting[0] if fitting else None


def as_cell(paragraph):
    lines = [line.strip().replace("|", "\\|") for line in paragraph.replace(program(), "sarsim").splitlines()]
    return "<br>".join(("``" if "`" in line else "`") + line + ("``" if "`" in line else "`") for line in lines)


def rows():
    lines, faults = [], []
    for mistake in MISTAKES:
        with tempfile.TemporaryDirectory() as folder:
            status, text = said(mistake, folder)
        message = message_of(mistake, text)
        if message is None or status != mistake["status"]:
            faults.append(f"{mistake['number']} {mistake['what']}: exit status {status}, said:\n{text}")
        lines.append(
            f"| {mistake['number']} | {mistake['what']} | `sarsim {mistake['command']}` | {status} "
            f"| {as_cell(message or 'nothing')} |"
        )
    return lines, faults


def main():
    lines, faults = rows()
    head = ["| | mistake | command | exit status | what the user sees |", "|---|---|---|---|---|"]
    made = "\n".join([*head, *lines, ""])
    old = RECORD.read_text(encoding="utf-8")
    if "--check" not in sys.argv[1:]:
        RECORD.write_text(made, encoding="utf-8")
        page.write()
    elif made != old:
        faults.append(f"{RECORD.name} and the program disagree; tests/bad_input/mistakes.py writes it anew")
        faults += [line for line in lines if line not in old.splitlines()]
    print("\n".join(faults) or f"{len(MISTAKES)} mistakes, all of them reported")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
