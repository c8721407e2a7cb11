"""Everything that sarsim writes, in runs of some milliseconds: commands, what they need, what they make."""

import dataclasses
import re
import typing

EARTH = "$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n"
CAR = """$PLATFORM Car TRAJECTORY LINEAR LINEAR LINEAR INLINE 2 0, 0 1, 20 1 0, 1000 1 0, 0
NOT_ALIGNED CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0
$TARGET Car 0 0 0 0 0 0 1 0 ISOTROPIC
$RADAR Radar1 Earth CHIRP 0.05 1000 RECT CONSTANT 1000 SINGLE 1 100 0 300 ISOTROPIC SAME FIXED 0 0 RECT NO_STC
"""


def recording(file="sim.bin", word="BINARY", pulses=20, lsb="1e-6"):
    return f"$SIMULATION Radar1 900 1400 0 {(pulses - 0.5) * 0.001} 8 0.1 {lsb} {word} RAW {file} BEGIN 1 1\n"


def moving(pulses=20, word="BINARY", file="sim.bin", lsb="1e-6"):
    return EARTH + CAR + recording(file, word, pulses, lsb)


TABLE = "$GEOMETRY Radar1 0 2000 0 0.02 SPACE 255 table.txt\n"

SAR = (
    EARTH
    + """$PLATFORM Plane TRAJECTORY LINEAR LINEAR LINEAR INLINE 2 0, 100 1, -100 1 0, -3000 1 0, 1000
NOT_ALIGNED CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0
$TARGET Earth 0 0 0 0 0 0 1 0 ISOTROPIC
$TARGET Earth 10 20 0 0 0 0 1 0 ISOTROPIC
$RADAR Radar1 Plane CHIRP 0.1 500 RECT CONSTANT 400 SINGLE 5 100 0 0 ISOTROPIC SAME SPOT 0 0 0 RECT NO_STC
$SIMULATION Radar1 3120 3240 0.42 0.58 8 0.12 0 HDF5 RAW sar.h5 BEGIN 1 1
"""
)

SEARCHING = (
    EARTH
    + CAR.replace("ISOTROPIC SAME FIXED 0 0", "SINX 20 20 SAME ROTATING 0 3000").replace("CHIRP 0.05", "CHIRP 0.02")
    + "$SIMULATION Radar1 900 1400 0 0.1295 8 0.03 1e-6 BINARY RAW sim.bin BEGIN 1 1\n"
)

STEPPED = (
    EARTH
    + """$PLATFORM Ship STATIONARY 0 1000 0 CONST 0 0 0 0 0 20 STDDEV 0 0 0 STDDEV 0 0 0
$TARGET Ship 0 0 0 0 0 0 1 0 ISOTROPIC
$TARGET Ship 3 4 0 0 0 0 1 0 ISOTROPIC
$RADAR Radar1 Earth MONO 100 RECT CONSTANT 2000 STEPPED 3 0.005 16 1 100 0 0 ISOTROPIC SAME FIXED 0 0 RECT NO_STC
$SIMULATION Radar1 985 1015 0 0.1279 8 0.02 0 HDF5 RAW stepped.h5 BEGIN 1 1
"""
)

# Times and rates that differ from run to run.
TIMES = re.compile(rb"(\d+(\.\d+)?(e[-+]?\d+)?|\.\d+) ?(s|ms|min|h|us|ns|MB|GB|echoes/s)\b|\d{4}-\d\d-\d\d[T ]\d\d:\d\d:\d\d")


@dataclasses.dataclass
class Story:
    """One command and its files."""

    name: str
    command: typing.Sequence[str]
    makes: typing.Sequence[str]  # Names of what it makes.
    files: dict[str, str | bytes] = dataclasses.field(default_factory=dict)
    before: typing.Sequence[typing.Sequence[str]] = ()  # Commands that make what it reads.
    force: str = "--force"  # How it is told to replace; empty: it always does.
    resumes: bool = False  # Run again, it goes on; what stands in its working folder may stay.
    working: typing.Sequence[str] = ()  # Patterns of names that it may leave behind when it fails.
    same: bool = True  # The same bytes in every run.
    slow: bool = False  # Not for each of the many faults of the suite.


def scene(text, name="scene.scr"):
    return {name: text}


def run_stories():
    words = {"binary": "bin", "ascii": "asc", "bracket": "brk", "csv": "csv", "npy": "npy", "hdf5": "h5"}
    for word, extension in words.items():
        yield Story(
            f"run_{word}", ("run", "scene.scr", "--format", word), (f"sim.{extension}",), scene(moving(200, lsb="0"))
        )
    yield Story("run_counts", ("run", "scene.scr", "--format", "hdf5", "--counts"), ("sim.h5",), scene(moving(50)))
    yield Story("run_long_hdf5", ("run", "scene.scr", "--format", "hdf5"), ("sim.h5",), scene(moving(3000)))
    yield Story(
        "run_several",
        ("run", "scene.scr", "--out", "new/folder"),
        ("new/folder/sim.bin", "new/folder/b.npy", "new/folder/table.txt"),
        scene(moving(20) + recording("b.npy", "NPY") + TABLE),
    )
    yield Story(
        "run_part_file",
        ("run", "scene.scr", "--part", "1/2", "--part-file"),
        ("sim.bin.parts/part-1-of-2.journal", "sim.bin.parts/part-1-of-2.rows"),
        scene(moving(200)),
        force="",
        resumes=True,
        working=("sim.bin.parts*",),
        same=False,
    )
    for word in ("binary", "hdf5", "ascii"):
        extension = words[word]
        yield Story(
            f"run_resume_{word}",
            ("run", "scene.scr", "--resume", "--save-every", "0", "--format", word),
            (f"sim.{extension}",),
            scene(moving(200, lsb="0" if word == "ascii" else "1e-6")),
            force="",
            resumes=True,
            working=(f"sim.{extension}.parts*", f"sim.{extension}.journal"),
        )


def tool_stories():
    yield Story(
        "merge",
        ("merge", "sim.bin.parts"),
        ("sim.bin",),
        scene(moving(200)),
        [("run", "scene.scr", "--part", f"{k}/2", "--part-file") for k in (1, 2)],
        working=("sim.bin.parts*", "sim.bin.journal"),
    )
    yield Story(
        "merge_encoded",
        ("merge", "sim.asc.parts"),
        ("sim.asc",),
        scene(moving(200, "ASCII", "sim.asc", "0")),
        [("run", "scene.scr", "--part", f"{k}/2", "--part-file") for k in (1, 2)],
        working=("sim.asc.parts*", "sim.asc.journal"),
    )
    for target in ("b.csv", "b.npy", "b.asc", "b.brk", "b.bin", "b.h5"):
        yield Story(
            f"convert_{target[2:]}",
            ("convert", "sim.h5", target, "--bits", "8", "--lsb", "1e-9"),
            (target,),
            scene(moving(60, "HDF5", "sim.h5")),
            [("run", "scene.scr")],
        )
    yield Story("format", ("format", "scene.scr", "-o", "new.scr"), ("new.scr",), scene(moving()))
    yield Story("format_in_place", ("format", "scene.scr", "--in-place"), ("scene.scr",), scene(moving()), force="")
    yield Story("geometry", ("geometry", "scene.scr", "-o", "t.txt"), ("t.txt",), scene(moving() + TABLE))
    yield Story("verify", ("verify", "--quick", "--html", "v.html"), ("v.html",), same=False, slow=True)
    yield Story("plot_csv", ("plot", "scene.scr", "--csv", "p.csv"), ("p.csv",), scene(moving()))
    for picture in ("p.png", "p.svg", "p.pdf"):
        yield Story(f"plot_{picture[2:]}", ("plot", "scene.scr", "-o", picture), (picture,), scene(moving()), slow=True)


def image_stories():
    yield Story("focus", ("focus", "sar.scr"), ("sar.img", "sar.hdr"), scene(SAR, "sar.scr"))
    yield Story(
        "focus_magnitude",
        ("focus", "sar.scr", "--magnitude"),
        ("sar.img", "sar.hdr", "sar-magnitude.img", "sar-magnitude.hdr"),
        scene(SAR, "sar.scr"),
    )
    for extension in ("npy", "h5", "csv"):
        yield Story(
            f"focus_{extension}", ("focus", "sar.scr", "--out", f"a.{extension}"), (f"a.{extension}",), scene(SAR, "sar.scr")
        )
    yield Story(
        "focus_on_disk",
        ("focus", "sar.scr", "--memory", "1M", "--scratch", "."),
        ("sar.img", "sar.hdr"),
        scene(SAR.replace("3120 3240 0.42 0.58", "3050 3550 0.1 0.9"), "sar.scr"),
    )
    yield Story(
        "focus_back_projection",
        ("focus", "sar.scr", "--algorithm", "back-projection"),
        ("sar.img", "sar.hdr"),
        scene(SAR, "sar.scr"),
        slow=True,
    )
    yield Story(
        "doppler",
        ("doppler", "scene.scr"),
        ("scene-doppler.img", "scene-doppler.hdr", "scene-doppler-detections.csv"),
        scene(moving(128)),
    )
    yield Story(
        "search",
        ("search", "scene.scr", "--extent", "1500", "--pixel", "20"),
        ("scene-ppi.img", "scene-ppi.hdr", "scene-ppi-detections.csv"),
        scene(SEARCHING),
    )
    yield Story("profiles", ("profiles", "s.scr"), ("s-profiles.img", "s-profiles.hdr"), scene(STEPPED, "s.scr"))
    yield Story("profiles_csv", ("profiles", "s.scr", "--out", "a.csv"), ("a.csv",), scene(STEPPED, "s.scr"))
    yield Story("isar", ("isar", "s.scr"), ("s-isar.img", "s-isar.hdr"), scene(STEPPED, "s.scr"))
    yield Story(
        "isar_several",
        ("isar", "s.scr", "--bursts", "8", "--magnitude"),
        [f"s-isar-{n}{part}.{end}" for n in (1, 2) for part in ("", "-magnitude") for end in ("img", "hdr")],
        scene(STEPPED, "s.scr"),
    )


def sweep_stories():
    makes = [f"out/{name}" for name in ("sweep.csv", "sweep.json")]
    yield Story(
        "sweep",
        ("sweep", "scene.scr", "--set", "seed=1..3", "--out", "out"),
        makes,
        scene(moving(50)),
        resumes=True,
        working=("out/sweep.journal", "out/sim*.bin"),
        same=False,
    )


def all_stories():
    stories = [*run_stories(), *tool_stories(), *image_stories(), *sweep_stories()]
    return {story.name: story for story in stories}
