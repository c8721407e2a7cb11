#!/usr/bin/env python3
"""Runs every command that the pages about commands show, each in a folder with the files that it speaks of.

usage: command_examples.py PROJECT BIN_FOLDER [--show]     --show prints how long each takes

Commands are the lines that begin with "sarsim" in fences without a language. The files they name (scene.toml, sim1.h5
...) are stand-ins, small ones of the kind that the section is about; a thousand seeds are twenty here, a hundred frames
ten. What needs a cluster is left out here, told, and tested in tests/parts and tests/engines.
"""

import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

PAGES = ["commands.md", "sweeps.md", "many-machines.md", "verify.md"]
FEWEST = 75  # Commands on these pages.
SECONDS = 300  # With sanitizers; a second or two otherwise.
ELSEWHERE = {
    r"\$SLURM|mpirun|srun |ssh |parallel |rsync ": "needs other machines: tests/parts, tests/engines",
    r"^sarsim (SCENE|COMMAND)|^sarsim  ": "is no command but a form of one",
    r"seed=1\.\.100000": "takes long",
    r"^sarsim verify$|^sarsim verify --html": "takes long: tests/verify, and --quick here",
}

# A small scene that stands for any, of four pulses.
SCENE = """
format = "sarsim 2"

[let]
speed = "240 m/s"
height = "2 km"

[[platform]]
name = "Aircraft"
path = { type = "line", start = [0, 0, "height"], velocity = ["speed", "0 m/s", "0 m/s"] }
navigation = { type = "ins", position = "1 mm" }

[[target]]
position = [0, 3000, 0]

[[target]]
position = [0, 3100, 0]
rcs = 2

[[target]]
position = [10, 3200, 0]

[[radar]]
name = "Radar1"
pulse = { type = "chirp", bandwidth = "10 MHz", width = "2 us" }
repetition = "1 kHz"
carrier = "3 GHz"
power = "1 MW"
noise_temperature = "300 K"
beam = { type = "fixed", elevation = "0 deg", azimuth = "90 deg" }

[[recording]]
radar = "Radar1"
range = [1600, 3518.67]
time = ["0 s", "3 ms"]
sample_rate = "20 MHz"
lsb = "10 nV"
file = "sim1.bin"

[[recording]]
radar = "Radar1"
range = [1600, 3518.67]
time = ["0 s", "3 ms"]
sample_rate = "20 MHz"
processing = "matched-filter"
format = "hdf5"
file = "sim2.h5"

[[geometry]]
radar = "Radar1"
range = ["0 m", "100 km"]
time = ["0 s", "10 ms"]
columns = ["time", "frequency", "position", "velocity", "rotation", "delay", "amplitude", "radial_speed"]
file = "geo1.txt"
"""


# A script in the language of 1998.
OLD = """
$TARGET Earth  0, 3000, 0  0, 0, 0  1, 0  ISOTROPIC
$RADAR Radar1 Earth  CHIRP 0.01 2000 RECT  CONSTANT 1000  SINGLE 3  1000 0 300  ISOTROPIC SAME  FIXED 0 90  RECT  NO_STC
$SIMULATION Radar1  1600, 3518.67  0, 0.003  8  0.02  1E-5  BINARY RAW sim1.bin BEGIN
"""


def writing(scene, name, form):
    """A scene whose last recording has another name and format; sim2 where the name is taken."""
    head, mark, tail = scene.rpartition("[[recording]]")
    name = "sim2" + pathlib.Path(name).suffix if f'"{name}"' in head else name
    tail, _, rest = tail.partition("\n[[")
    tail = re.sub(r"^(file|format) = .*\n", "", tail, flags=re.MULTILINE)
    return f'{head}{mark}{tail.rstrip()}\nfile = "{name}"\nformat = "{form}"\n' + (f"\n[[{rest}" if rest else "")


def commands_of(text):
    """Section and command of each line, continued lines joined, comments taken off."""
    section, inside, lines = "", False, []
    for line in re.sub(r"\\\n\s*", "", text).splitlines():
        if line.startswith("```"):
            inside = line == "```" and not inside
        elif inside and re.match(r"(sarsim|for k in)\b", line):
            lines.append((section, re.sub(r"\s+#.*", "", line).strip()))
        elif not inside and line.startswith("## "):
            section = line[3:].removeprefix("sarsim ")
    return lines


class Stage:
    """The files that commands of a section may name, made once."""

    def __init__(self, folder, project, programs):
        self.folder, self.programs = folder, programs
        self.examples = project / "examples"

    def example(self, name):
        return (self.examples / f"{name}.toml").read_text(encoding="utf-8")

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def sarsim(self, *words):
        subprocess.run([self.programs / "sarsim", *words, "--quiet"], cwd=self.folder, check=True, capture_output=True)

    def recordings(self, scene):
        """The scene as scene.toml, which writes sim1.bin, and its recording in several formats."""
        self.write("scene.toml", writing(scene, "sim1.bin", "binary"))
        for form in ("binary", "hdf5", "ascii"):
            self.sarsim("run", "scene.toml", "1", "--format", form, "--force")

    def make(self, section):
        for name in ("sar_r", "stripmap_motion", "mti", "search_radar", "stepped_aircraft", "turning_ship"):
            self.write(f"{name}.toml", self.example(name))
        self.write("old.scr", OLD)
        self.write("points.csv", "x,y,z,rcs\n1000,5,0,2\n")
        self.write("cases.csv", "Target1.rcs [m2],seed\n1,1\n1,2\n4,1\n")
        kinds = {
            "focus": "sar_r",
            "doppler": "mti",
            "search": "search_radar",
            "profiles": "stepped_aircraft",
            "isar": "turning_ship",
        }
        if section in kinds:
            self.recordings(self.example(kinds[section]))
        else:
            self.recordings(SCENE.replace("3 ms", "300 ms") if section in ("plot", "") else SCENE)
        if section in ("plot", "measure", "info", "convert"):
            for form in ("npy", "img"):  # Both have the header sar_r.hdr, kept here under names of their own.
                self.sarsim("focus", "sar_r.toml", "--out", f"sar_r.{form}")
                (self.folder / "sar_r.hdr").rename(self.folder / f"sar_r.{form}.hdr")
        if section == "focus":  # A file as satellites deliver them.
            subprocess.run([self.programs / "sarsim", "convert", "sar_r.toml", "umbra.cphd", "--anchor", "47.5,8.25,400"],
                           cwd=self.folder, check=True, capture_output=True)
        if section in ("run", "info", "geometry"):
            self.write("sar_r.toml", SCENE)
        if section == "check":
            for name in ("stripmap_motion", "mti", "search_radar", "stepped_aircraft", "turning_ship"):
                (self.folder / f"{name}.toml").unlink()
        shutil.copyfile(self.folder / "sim1.h5", self.folder / "big.h5")
        shutil.copyfile(self.folder / "sim1.h5", self.folder / "recording.h5")
        if section in ("merge", "Recipes"):
            self.parts()
        for place in (".zfunc", ".config/fish/completions"):
            (self.folder / place).mkdir(parents=True)

    def parts(self):
        self.write("scene.toml", SCENE.replace("sim1.bin", "sim.bin"))
        for k, places in ((1, ("out", "a", "here")), (2, ("out", "b", "here"))):
            for place in places:
                self.sarsim("run", "scene.toml", "1", "--out", place, "--part", f"{k}/2", "--part-file")


def outputs_named(command):
    """Files that a command makes and that must not be there before."""
    words = command.split()
    made = [words[i + 1] for i, word in enumerate(words[:-1]) if word in ("-o", "--out", "--output")]
    return made + ([words[3]] if words[1] == "convert" else [])


def copy_named(command, stage, folder):
    """What the command speaks of and does not make: files by their names, images with their headers, hidden folders."""
    words = set(re.findall(r"[\w./*-]+", command)) - set(outputs_named(command))
    tops = {word.split("/")[0] for word in words}
    folder.mkdir()
    for entry in stage.iterdir():
        if entry.is_dir() and (entry.name in tops or entry.name.startswith(".")):
            shutil.copytree(entry, folder / entry.name)
        elif entry.name in words:
            shutil.copyfile(entry, folder / entry.name)
        elif entry.suffix == ".hdr" and entry.stem in words:
            shutil.copyfile(entry, folder / f"{entry.stem.split('.')[0]}.hdr")
            shutil.copyfile(stage / "sar_r.toml", folder / "sar_r.toml")
        elif entry.suffix == ".toml" and "*.toml" in words:
            shutil.copyfile(entry, folder / entry.name)


def run(command, stage, folder, programs):
    """The complaint about a command, or nothing."""
    copy_named(command, stage, folder)
    started = time.monotonic()
    text = command.replace("/data", ".").replace("seed=1..1000 ", "seed=1..20 ").replace("--frames 100 ", "--frames 10 ")
    environment = dict(
        os.environ, HOME=str(folder), PATH=f"{programs}:{os.environ['PATH']}", QT_QPA_PLATFORM="offscreen"
    )
    environment["XDG_CACHE_HOME"] = str(folder.parent / "cache")  # The speed of the machine is measured once.
    try:
        done = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", text],
            cwd=folder,
            env=environment,
            capture_output=True,
            text=True,
            errors="replace",
            timeout=SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return f"{command}: not done after {SECONDS} s"
    shutil.rmtree(folder)
    if "--show" in sys.argv:
        print(f"{time.monotonic() - started:6.2f} s  {command}")
    return (
        ""
        if done.returncode == 0
        else f"{command}: exit status {done.returncode}\n{(done.stdout + done.stderr)[-600:]}"
    )


def reason_elsewhere(command):
    return next((why for pattern, why in ELSEWHERE.items() if re.search(pattern, command)), None)


def main():
    project, programs = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    shown = []
    for page in PAGES:
        shown += commands_of((project / "docs/guide" / page).read_text(encoding="utf-8"))
    shown = list(dict.fromkeys(shown))
    left_out = [command for _, command in shown if reason_elsewhere(command)]
    work = [item for item in shown if item[1] not in left_out]
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        stages = {}
        for section in dict.fromkeys(section for section, _ in work):
            stages[section] = root / f"stage{len(stages)}"
            stages[section].mkdir()
            Stage(stages[section], project, programs).make(section)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            jobs = [
                pool.submit(run, command, stages[s], root / f"run{i}", programs) for i, (s, command) in enumerate(work)
            ]
        faults = [job.result() for job in jobs if job.result()]
    print("\n".join(faults))
    print(f"{len(work)} commands run, {len(left_out)} need more than this machine or are tested elsewhere")
    if faults or len(shown) < FEWEST:
        sys.exit(1)


main()
