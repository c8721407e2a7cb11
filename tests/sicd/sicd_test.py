#!/usr/bin/env python3
"""SICD files of the program, read by a reader of their own and by GDAL.

    sicd_test.py NAME      one of the functions below

The program is SARSIM_PROGRAM or SARSIM_BUILT_PROGRAM of the environment. Exit status: 0 as it should be, 1 not, 77
something to compare with is missing.
"""

import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
if importlib.util.find_spec("numpy") is None:
    other = os.environ.pop("SARSIM_TEST_PYTHON", "") or "/usr/bin/python3"
    if other == sys.executable or not pathlib.Path(other).exists():
        print("there is no NumPy")
        sys.exit(SKIPPED)
    os.execv(other, [other, "-B", *sys.argv])

import numpy as np  # noqa: E402

import sicd_file  # noqa: E402
from scenes import SCENES  # noqa: E402


def sarsim(*words, fails=False):
    program = os.environ.get("SARSIM_PROGRAM") or os.environ["SARSIM_BUILT_PROGRAM"]
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=False)
    assert fails == (done.returncode != 0), f"{words}: {done.stderr}"
    return done.stderr if fails else done.stdout


def focused(folder, name, *outputs):
    """The image of a scene under each of the names."""
    script, options, points = SCENES[name]
    (folder / f"{name}.toml").write_text(script)
    for output in outputs:
        place = options if output.suffix in (".nitf", ".ntf", ".sicd") else [
            word for i, word in enumerate(options) if "--anchor" not in (word, options[i - 1])
        ]
        sarsim("focus", folder / f"{name}.toml", "--out", output, "--quiet", *place)
    return points


def check_places(folder, name):
    """Where targets are found in the pixels is where they are on the Earth, with the phase of their distance."""
    image, slant = folder / f"{name}.nitf", name not in ("ground", "orbit_ground")
    points = focused(folder, name, image)
    file = sicd_file.SicdFile(image)
    pixels = file.pixels()
    steps = file.number("Grid/Row/SS"), file.number("Grid/Col/SS")
    worst, phases = 0.0, []
    carrier = 0.5 * (file.number("RadarCollection/TxFrequency/Min") + file.number("RadarCollection/TxFrequency/Max"))
    for point in points:
        row, column = place_in(file, point, pixels.shape)
        offsets = [steps[i] * file.offset(d, row, column) for i, d in enumerate(("Row", "Col"))]
        true = row, column
        row, column, value = sicd_file.peak(pixels, row, column, offsets)
        misses = file.miss(row, column, point)
        worst = max(worst, *map(abs, misses))
        if slant:
            # The carrier of the image takes the peak's phase to the true place; that of the range is not in the pixels.
            turns = offsets[0] * (true[0] - row) + offsets[1] * (true[1] - column)
            nearest = file.number("RMA/INCA/R_CA_SCP") + file.coordinates(*true)[0]
            turns += 2 * carrier * nearest / sicd_file.LIGHT_MPS
            phases.append(np.angle(value * np.exp(2j * np.pi * turns)))
        print(f"{name}: target off by {misses[0]:+.4f} m across, {misses[1]:+.4f} m along", end="")
        print(f", phase by {phases[-1]:+.4f} rad" if slant else "")
    assert worst < 0.05, worst
    assert all(abs(phase) < 0.03 for phase in phases), phases


def place_in(file, point, shape):
    """The pixel of a point on the Earth, by steps of Newton."""
    row, column = (n / 2 for n in shape)
    for _ in range(30):
        here = np.array(file.miss(row, column, point))
        turn = np.array([
            (np.array(file.miss(row + 1, column, point)) - here),
            (np.array(file.miss(row, column + 1, point)) - here),
        ]).T
        step = np.linalg.solve(turn, -here)
        row, column = row + step[0], column + step[1]
        if np.abs(step).max() < 1e-4:
            break
    return row, column


def check_spectrum(folder, name):
    """The spectrum of a point lies where DeltaKCOAPoly says, in both directions: the sign of the phase is right."""
    image = folder / f"{name}.nitf"
    points = focused(folder, name, image)
    file = sicd_file.SicdFile(image)
    pixels = file.pixels()
    for point in points:
        row, column = place_in(file, point, pixels.shape)
        for i, direction in enumerate(("Row", "Col")):
            step = file.number(f"Grid/{direction}/SS")
            width = file.number(f"Grid/{direction}/ImpRespBW")
            reach = 24
            r, c = int(round(row)), int(round(column))
            patch = pixels[r - reach : r + reach, c - reach : c + reach]
            following = patch[1:, :] * patch[:-1, :].conj() if i == 0 else patch[:, 1:] * patch[:, :-1].conj()
            measured = np.angle(following.sum()) / (2 * np.pi * step)
            said = file.offset(direction, row, column)
            off = (measured - said + 0.5 / step) % (1 / step) - 0.5 / step
            print(f"{name} {direction}: spectrum at {measured:.3f}, said {said:.3f} per m, of {width:.3f}")
            assert abs(off) < 0.08 * width, (off, width)
            assert file.number(f"Grid/{direction}/DeltaK1") >= -0.5 / step * (1 + 1e-9)
        assert file.text("Grid/Row/Sgn") == file.text("Grid/Col/Sgn") == "-1"


def squinted_has_its_spectrum(folder):
    check_spectrum(folder, "squinted")


def spotlight_has_its_spectrum(folder):
    check_spectrum(folder, "spotlight")


def ground_has_its_spectrum(folder):
    check_spectrum(folder, "ground")


def gdal_reads_the_pixels(folder):
    """Rows and columns, numbers bit for bit."""
    if shutil.which("gdal_translate") is None:
        print("there is no gdal_translate")
        sys.exit(SKIPPED)
    for name in ("stripmap_left", "stripmap_right"):
        image, plain = folder / f"{name}.ntf", folder / f"{name}.npy"
        focused(folder, name, image, plain)
        raw = folder / f"{name}.raw"
        unturned = ["-a_ullr", "0", "1", "1", "0"]  # ENVI's headers do not hold how an image is turned.
        subprocess.run(["gdal_translate", "-q", "-of", "ENVI", "-co", "INTERLEAVE=BIP", *unturned, str(image), str(raw)], check=True)
        ours = np.load(plain)
        wanted = ours.T if name == "stripmap_right" else ours[::-1].T
        read = np.fromfile(raw, "<f4").reshape(*wanted.shape, 2)
        assert np.array_equal(read[..., 0] + 1j * read[..., 1], wanted), name


def the_program_reads_its_own(folder):
    """As an image of any command: info, convert, and the same bytes however it is made."""
    image, plain, copy = folder / "a.nitf", folder / "a.npy", folder / "b.npy"
    focused(folder, "stripmap_right", image, plain)
    assert "sicd" in sarsim("info", image)
    sarsim("convert", image, copy)
    assert np.array_equal(np.load(copy), np.load(plain).T)
    sarsim("plot", image, "-o", folder / "a.png")
    for name in ("stripmap_left", "stripmap_right"):
        focused(folder, name, folder / f"{name}.nitf", folder / f"{name}.img")
        # All but the first line, which names the file.
        measured = [sarsim("measure", folder / f"{name}{ending}").split("\n", 1)[1] for ending in (".nitf", ".img")]
        assert measured[0] == measured[1] and "3 of 3 targets found" in measured[0], measured
    script, options, _ = SCENES["stripmap_right"]
    again = folder / "c.nitf"
    sarsim("focus", folder / "stripmap_right.toml", "--out", again, "--quiet", "--threads", 1, "--memory", "2M", *options)
    same = image.read_bytes().replace(b"<CoreName>a<", b"<CoreName>c<")
    assert len(same) == again.stat().st_size
    ours, theirs = sicd_file.SicdFile(image), sicd_file.SicdFile(again)
    assert np.array_equal(ours.pixels(), theirs.pixels())


def converted_images_are_the_same(folder):
    """From every format of images; all but the name in the file is that of the focused one."""
    image = folder / "direct" / "a.nitf"
    image.parent.mkdir()
    copies = [folder / f"a.{ending}" for ending in ("img", "h5")]
    focused(folder, "squinted", image, *copies)
    for copy in copies:
        made = folder / copy.suffix[1:] / "a.nitf"
        made.parent.mkdir()
        place = SCENES["squinted"][1]
        sarsim("convert", copy, made, *place[place.index("--anchor") :])
        assert made.read_bytes() == image.read_bytes(), copy


def nothing_is_assumed(folder):
    """A flat scene has no place on the Earth unless it is given one; no other command writes SICD."""
    script, options, _ = SCENES["spotlight"]
    (folder / "flat.toml").write_text(script)
    words = sarsim("focus", folder / "flat.toml", "--out", folder / "flat.nitf", fails=True)
    assert "the world of the scene is flat" in words and "--anchor" in words, words
    words = sarsim("focus", folder / "flat.toml", "--out", folder / "flat.nitf", "--anchor", "91,0,0", fails=True)
    assert "not a place" in words, words
    words = sarsim("focus", folder / "flat.toml", "--out", folder / "flat.img", "--anchor", "1,2,3", fails=True)
    assert "--anchor" in words, words
    (folder / "orbit.toml").write_text(SCENES["orbit"][0])
    words = sarsim("focus", folder / "orbit.toml", "--out", folder / "a.nitf", "--anchor", "1,2,3", fails=True)
    assert "says itself" in words, words
    words = sarsim("doppler", folder / "flat.toml", "--out", folder / "map.nitf", fails=True)
    assert "SICD" in words, words
    assert not list(folder.glob("*.nitf"))


def main():
    name = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        if name in SCENES:
            check_places(pathlib.Path(folder), name)
        else:
            globals()[name](pathlib.Path(folder))


if __name__ == "__main__":
    main()
