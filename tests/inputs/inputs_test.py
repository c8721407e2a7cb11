#!/usr/bin/env python3
"""No output of any command replaces, or is put into, anything that the command reads.

    inputs_test.py [WORD...]     cases whose names contain all of the words

Each option of each command that names a file is an input or an output here; an option that no case covers fails the test
(the options are those of --help). Each output is pointed at each input in turn: by the input's own name, through "..", by
a symbolic link, by a hard link. The command must end with an error, and all that it reads must be unchanged. The program is SARSIM_PROGRAM or SARSIM_BUILT_PROGRAM of the environment.
"""

import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PROGRAM = os.path.abspath(os.environ.get("SARSIM_PROGRAM") or os.environ["SARSIM_BUILT_PROGRAM"])
FILE_TYPES = {"FILE", "FILE.csv", "DIR", "SCENE", "IN", "IMAGE", "OUT", "CSV", "PICTURE", "DATA", "FOLDER", "JSON"}

SCENE = """format = "sarsim 2"
include = ["part.toml"]
[[platform]]
name = "Plane"
path = { type = "ephemeris", file = "track.csv" }
[[target]]
positions = { file = "points.csv" }
[[target]]
positions = [[0, 0, 0], [31, 23, 0]]
[[radar]]
name = "X"
platform = "Plane"
pulse = { type = "chirp", bandwidth = "60 MHz", width = "0.5 us" }
repetition = "120 Hz"
carrier = "9.6 GHz"
power = "1 kW"
[[recording]]
radar = "X"
file = "small.h5"
format = "hdf5"
sample_rate = "75 MHz"
range = ["2850 m", "2990 m"]
time = ["-0.2 s", "0.2 s"]
[[geometry]]
radar = "X"
file = "table.txt"
time = ["-0.1 s", "0.1 s"]
"""
STEPPED = """format = "sarsim 2"
include = ["part.toml"]
[[platform]]
name = "Site"
[[target]]
positions = { file = "points.csv" }
[[platform]]
name = "Ship"
path = { type = "line", start = [1000, 0, 0], velocity = [0, 10, 0] }
[[target]]
platform = "Ship"
positions = [[0, 0, 0], [8, 3, 0]]
[[radar]]
name = "S"
platform = "Site"
pulse = { type = "mono", width = "100 ns" }
repetition = "4 kHz"
carrier = { type = "stepped", first = "9 GHz", step = "5 MHz", count = 16 }
power = "1 kW"
noise_temperature = "290 K"
[[recording]]
radar = "S"
file = "stepped.h5"
format = "hdf5"
sample_rate = "20 MHz"
range = ["900 m", "1100 m"]
time = ["0 s", "0.1 s"]
"""


class Case:
    """A command line with the files that it reads, and its outputs: the placeholder of each, and its extension."""

    def __init__(self, line, inputs, **outputs):
        self.words = line.split()
        self.inputs = inputs.split()
        self.outputs = outputs


STRIP = "scene.toml part.toml points.csv track.csv"
STEPS = "steps.toml part.toml points.csv"
ZARR = "small.zarr small.zarr/.zattrs small.zarr/samples/0.0"
# OUT stands for a file of that ending; FOLDER/NAME for a file of a folder that the command makes files in.
CASES = [
    Case("run scene.toml --out FOLDER --targets extra.csv --force", STRIP + " extra.csv", FOLDER="small.h5"),
    Case("run scene.toml --out FOLDER --force", STRIP, FOLDER="table.txt"),
    Case("sweep scene.toml --values values.csv --targets extra.csv --out FOLDER --force", STRIP + " extra.csv values.csv",
         FOLDER="sweep.csv"),
    Case("sweep scene.toml --set Target2.x=0,1 --focus --with --navigation=nav.csv --out FOLDER --table t --force", "nav.csv",
         FOLDER="t.csv"),
    Case("geometry scene.toml --csv --targets extra.csv --out OUT --force", STRIP + " extra.csv", OUT=".csv"),
    Case("geometry small.h5 --out OUT --force", "small.h5 track.csv", OUT=".csv"),
    Case("geometry small.bin --script scene.toml --out OUT --force", "small.bin " + STRIP, OUT=".csv"),
    Case("geometry small.zarr --csv --out OUT --force", ZARR, OUT=".csv"),
    Case("motion scene.toml --targets extra.csv --out OUT --force", STRIP, OUT=".csv"),
    Case("plot scene.toml --kind track --targets extra.csv --out OUT --force", STRIP + " extra.csv", OUT=".png"),
    Case("plot small.h5 --kind pulse --csv OUT --with small.zarr --force", "small.h5 " + ZARR, OUT=".csv"),
    Case("plot small.zarr --kind pulse --csv OUT --force", ZARR, OUT=".csv"),
    Case("plot small.bin --script scene.toml --kind pulse --csv OUT --force", "small.bin " + STRIP, OUT=".csv"),
    Case("plot image.img --kind pulse --csv OUT --force", "image.img image.hdr", OUT=".csv"),
    Case("merge small.npy.parts --out OUT --force", "small.npy.parts small.npy.parts/product small.npy.parts/part-1-of-1.journal",
         OUT=".npy"),
    Case("convert small.h5 OUT --to npy --force", "small.h5", OUT=".npy"),
    Case("convert small.zarr OUT --to npy --force", ZARR, OUT=".npy"),
    Case("convert small.zarr OUT --to npy --force", ZARR, OUT=""),
    Case("geometry small.zarr --csv --out OUT --force", ZARR + " small.zarr/pulse_time_s/0", OUT=""),
    Case("convert small.bin OUT --script scene.toml --to csv --force", "small.bin " + STRIP, OUT=".csv"),
    Case("convert image.img OUT --force", "image.img image.hdr", OUT=".npy"),
    Case("convert image.img OUT --anchor 47,8,400 --force", "image.img image.hdr small.h5 track.csv", OUT=".nitf"),
    Case("convert scene.toml OUT --targets extra.csv --force", STRIP + " extra.csv", OUT=".toml"),
    Case("convert scene.toml OUT --anchor 47,8,400 --targets extra.csv --force", STRIP + " extra.csv", OUT=".cphd"),
    Case("convert small.h5 OUT --anchor 47,8,400 --force", "small.h5 track.csv", OUT=".crsd"),
    Case("convert small.npy --references OUT --script scene.toml --force", "small.npy scene.toml part.toml", OUT=".json"),
    Case("focus scene.toml --targets extra.csv --out OUT --force", STRIP + " extra.csv", OUT=".npy"),
    Case("focus small.h5 --navigation nav.csv --out OUT --force", "small.h5 nav.csv track.csv points.csv", OUT=".csv"),
    Case("focus small.h5 --scratch . --autofocus --autofocus-phase OUT --out other.img --force", "small.h5 points.csv", OUT=".csv"),
    Case("focus small.zarr --out OUT --force", ZARR + " points.csv", OUT=".npy"),
    Case("focus small.bin --script scene.toml --out OUT --force", "small.bin " + STRIP, OUT=".img"),
    Case("focus small.cphd --out OUT --force", "small.cphd", OUT=".npy"),
    Case("measure image.img --cuts FOLDER --force", "image.img image.hdr small.h5", FOLDER="target-1.png"),
    Case("measure image.img --script scene.toml --cuts FOLDER --force", "image.img " + STRIP, FOLDER="target-1.png"),
    Case("doppler steps.toml --interval 1 --targets extra.csv --out OUT --force", STEPS + " extra.csv", OUT=".npy"),
    Case("doppler stepped.bin --interval 1 --script steps.toml --detections OUT --out other.img --force", "stepped.bin " + STEPS, OUT=".csv"),
    Case("search stepped.h5 --out OUT --force", "stepped.h5 points.csv", OUT=".npy"),
    Case("search stepped.bin --script steps.toml --detections OUT --out other.img --force", "stepped.bin " + STEPS, OUT=".csv"),
    Case("search steps.toml --targets extra.csv --out OUT --force", STEPS + " extra.csv", OUT=".npy"),
    Case("profiles steps.toml --targets extra.csv --out OUT --force", STEPS + " extra.csv", OUT=".csv"),
    Case("profiles stepped.bin --script steps.toml --out OUT --force", "stepped.bin " + STEPS, OUT=".img"),
    Case("isar steps.toml --targets extra.csv --out OUT --force", STEPS + " extra.csv", OUT=".npy"),
    Case("isar stepped.bin --script steps.toml --out OUT --force", "stepped.bin " + STEPS, OUT=".img"),
    Case("format scene.toml --targets extra.csv --out OUT --force", STRIP + " extra.csv", OUT=".toml"),
]  # fmt: skip
# Options of commands that read no file, or write none.
ALONE = {
    ("new", "--out"), ("explain", "--out"), ("verify", "--html"), ("check", "--targets"), ("check", "scenes"),
    ("info", "file"), ("info", "--script"), ("info", "--targets"),
}  # fmt: skip


def call(*words, folder):
    return subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, text=True, errors="replace", timeout=300)


def options_with_files():
    """(command, option) for all options in --help, with the last and longest of their names."""
    found = set()
    commands = re.findall(r"^  (\w+) ", call("--help", folder=".").stdout.split("SUBCOMMANDS:")[-1], re.M)
    for command in commands:
        help_text = call(command, "--help", folder=".").stdout
        for line in help_text.splitlines() if f"Usage: sarsim {command} " in help_text else []:
            match = re.match(r"^  (-[-\w,]*|[a-z]+)\s+(\S+)", line)
            if match and FILE_TYPES & set(re.split(r"[|=\[\]]", match[2])):
                names = match[1].split(",")
                found.add((command, "--out" if "--out" in names else names[-1]))
    return found


def make_inputs(folder):
    """Everything that some command reads."""
    rows = [f"{t},{100 * t},-2500,1500,100,0,0" for t in range(-10, 11)]
    (folder / "track.csv").write_text("t,x,y,z,vx,vy,vz\n" + "\n".join(rows) + "\n")
    (folder / "nav.csv").write_text("t,x,y,z\n" + "\n".join(",".join(row.split(",")[:4]) for row in rows) + "\n")
    (folder / "part.toml").write_text('format = "sarsim 2"\n[options]\nseed = 3\n')
    (folder / "points.csv").write_text("x,y,z\n5,5,0\n-20,10,0\n")
    (folder / "extra.csv").write_text("x,y,z\n12,-5,0\n")
    (folder / "values.csv").write_text("Target2.x [m]\n0\n1\n")
    (folder / "scene.toml").write_text(SCENE)
    (folder / "steps.toml").write_text(STEPPED)
    steps = [
        ("run", "scene.toml", "--quiet"),
        ("run", "scene.toml", "--format", "binary", "--quiet", "--force"),
        ("run", "scene.toml", "--format", "npy", "--quiet", "--force"),
        ("run", "steps.toml", "--quiet"),
        ("run", "steps.toml", "--format", "binary", "--quiet"),
        ("convert", "small.h5", "small.zarr"),
        ("convert", "small.h5", "small.cphd", "--anchor", "47,8,400"),
        ("focus", "small.h5", "--out", "image.img", "--quiet"),
        ("run", "scene.toml", "--format", "npy", "--part", "1/1", "--part-file", "--quiet", "--force"),
    ]
    for words in steps:
        result = call(*words, folder=folder)
        if result.returncode != 0:
            sys.exit(f"{' '.join(words)}: {result.stderr}")


def sums(folder, names):
    """Checksums of files, and of all files of folders."""
    result = {}
    for name in names:
        path = folder / name
        for file in sorted(path.rglob("*")) if path.is_dir() else [path]:
            if file.is_file():
                result[str(file.relative_to(folder))] = hashlib.md5(file.read_bytes()).hexdigest()
    return result


def aliases(name, ending, is_folder):
    """Ways to name an input: (word, what has to be made first, in words)."""
    if name.endswith(ending) or is_folder:
        yield "itself", name
        yield "around", f"sub/../{name}"
    yield "link", f"alias{ending}"
    if not is_folder:
        yield "second name", f"second{ending}"


def make_alias(folder, kind, word, name):
    if kind == "around":
        (folder / "sub").mkdir()
    elif kind == "link":
        os.symlink(name, folder / word)
    elif kind == "second name":
        os.link(folder / name, folder / word)


def tries():
    """(name, case, placeholder, kind, word, input)"""
    for number, case in enumerate(CASES):
        for placeholder, ending in case.outputs.items():
            for name in case.inputs:
                is_folder = name.endswith((".zarr", ".parts"))
                if placeholder == "FOLDER":
                    kinds = [("link", ending), ("second name", ending)]
                else:
                    kinds = list(aliases(name, ending, is_folder))
                for kind, word in kinds:
                    yield f"{number} {case.words[0]} {placeholder}{ending} is {name} by {kind}", case, placeholder, kind, word, name


def fresh(base, work):
    """A copy of all inputs."""
    folder = work / "try"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(base, folder)
    return folder


def separated(words):
    """The words of a command line, where one of them is a line of options."""
    return [word.replace("=", " ", 1) if word.startswith("--navigation=") else word for word in words]


def check_free_names(base, work, case):
    """Fault of a case whose outputs have free names; empty if there is none."""
    folder = fresh(base, work)
    words = ["made" if word == "FOLDER" else f"own{case.outputs[word]}" if word in case.outputs else word for word in case.words]
    before = sums(folder, case.inputs)
    result = call(*separated(words), folder=folder)
    if result.returncode != 0 or "--quiet" in words:
        return f"{' '.join(words)}: ended with {result.returncode}: {result.stderr[:300]}"
    if case.words[0] == "merge":  # Which may take its parts away.
        return ""
    return "" if sums(folder, case.inputs) == before else f"{' '.join(words)}: changed what it reads"


def check_one(base, work, case, placeholder, kind, word, name):
    """The fault; empty if there is none."""
    folder = fresh(base, work)
    words = list(case.words)
    if placeholder == "FOLDER":
        (folder / "made").mkdir()
        if kind == "link":
            os.symlink(f"../{name}", folder / "made" / word)
        else:
            os.link(folder / name, folder / "made" / word)
        out = "made"
    else:
        make_alias(folder, kind, word, name)
        out = word
    words = separated([out if w == placeholder else w for w in words])
    before = sums(folder, case.inputs)
    result = call(*words, folder=folder)
    after = sums(folder, case.inputs)
    wrong = []
    if result.returncode == 0:
        wrong.append("it ended well")
    if result.returncode < 0 or "Traceback" in result.stderr:
        wrong.append(f"it ended with {result.returncode}")
    changed = [file for file in before if after.get(file) != before[file]]
    if changed:
        wrong.append(f"changed: {' '.join(changed)}")
    return f"{' '.join(words)}: {', '.join(wrong)}: {result.stderr[:200]}" if wrong else ""


def covered():
    names = set(ALONE)
    positional = {"run": ["scene"], "sweep": ["scene"], "geometry": ["input"], "motion": ["input"], "plot": ["input"],
                  "merge": ["folders"], "convert": ["input", "output"], "focus": ["input"], "measure": ["image"],
                  "doppler": ["input"], "search": ["input"], "profiles": ["input"], "isar": ["input"], "format": ["scene"]}  # fmt: skip
    for case in CASES:
        command = case.words[0]
        names |= {(command, word) for word in positional[command]}
        names |= {(command, word) for word in case.words if word.startswith("--")}
    return names


def main():
    wanted = sys.argv[1:]
    missing = options_with_files() - covered()
    wrong = [f"no case has {command} {option}" for command, option in sorted(missing)]
    known = options_with_files()
    if len(known) < 50:
        wrong.append(f"--help names {len(known)} files, fewer than there are")
    with tempfile.TemporaryDirectory(prefix="sarsim-inputs-") as name:
        work = pathlib.Path(name)
        base = work / "base"
        base.mkdir()
        make_inputs(base)
        count = 0
        for case in CASES:
            if text := check_free_names(base, work, case):
                wrong.append(text)
        for name, *rest in tries():
            if not all(word in name for word in wanted):
                continue
            count += 1
            if text := check_one(base, work, *rest):
                wrong.append(f"{name}\n    {text}")
    print("\n".join(wrong))
    print(f"{count} outputs, {len(wrong)} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
