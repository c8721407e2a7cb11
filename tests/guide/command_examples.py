#!/usr/bin/env python3
"""Runs every command that the pages about commands show, each in a folder with the files that it speaks of.

usage: command_examples.py PROJECT BIN_FOLDER [--show]     --show prints how long each takes

Commands are the lines that begin with "sarsim" in fences without a language. The files they name (scene.scr, sim1.h5
...) are stand-ins, small ones of the kind that the section is about; a thousand seeds are twenty here. What needs a
cluster is left out here, told, and tested in tests/parts.
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
    r"\$SLURM|mpirun|srun |ssh |parallel |rsync ": "needs other machines: tests/parts",
    r"^sarsim (SCENE|COMMAND)|^sarsim  ": "is no command but a form of one",
    r"seed=1\.\.100000": "takes long",
    r"^sarsim verify$|^sarsim verify --html": "takes long: tests/verify, and --quick here",
}

# A small scene that stands for any, of four pulses.
SCENE = """
$TARGET Earth  0, 3000, 0  0, 0, 0  1, 0  ISOTROPIC
$TARGET Earth  0, 3100, 0  0, 0, 0  2, 0  ISOTROPIC
$TARGET Earth  10, 3200, 0  0, 0, 0  1, 0  ISOTROPIC
$RADAR Radar1 Earth  CHIRP 0.01 2000 RECT  CONSTANT 1000  SINGLE 3  1000 0 300  ISOTROPIC SAME  FIXED 0 90  RECT  NO_STC
$SIMULATION Radar1  1600, 3518.67  0, 0.003  8  0.02  1E-5  BINARY RAW sim1.bin BEGIN
$SIMULATION Radar1  1600, 3518.67  0, 0.003  8  0.02  0  HDF5 MATCHED_FILTER sim2.h5 BEGIN
$GEOMETRY Radar1  0, 100000  0, 0.01  SPACE  255  geo1.txt
"""


def writing(script, name, form):
    """A script whose recording has another name and format."""
    head, tail = script.rsplit("$SIMULATION", 1)
    tail = re.sub(r"\b(HDF5|NPY|ASCII|BINARY)\b", form, tail, count=1)
    own = name if re.search(r"^\S+\.(h5|npy|asc|bin)", tail, re.MULTILINE) else "sim2" + pathlib.Path(name).suffix
    return head + "$SIMULATION" + re.sub(r"\S+\.(h5|npy|asc|bin)\b", own, tail, count=1)


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
        return (self.examples / f"{name}.scr").read_text(encoding="utf-8")

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def sarsim(self, *words):
        subprocess.run([self.programs / "sarsim", *words, "--quiet"], cwd=self.folder, check=True, capture_output=True)

    def recordings(self, script):
        """The script as scene.scr, which writes sim1.bin, and its recording in several formats."""
        self.write("scene.scr", writing(script, "sim1.bin", "BINARY"))
        for form in ("binary", "hdf5", "ascii"):
            self.sarsim("run", "scene.scr", "1", "--format", form, "--force")

    def make(self, section):
        for name in ("sar_r", "stripmap_motion", "mti", "search_radar", "stepped_aircraft", "turning_ship"):
            self.write(f"{name}.scr", self.example(name))
        self.write("old.scr", SCENE)
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
            self.recordings(SCENE.replace("0, 0.003", "0, 0.3") if section in ("plot", "") else SCENE)
        if section in ("plot", "measure", "info", "convert"):
            for form in ("npy", "img"):  # Both have the header sar_r.hdr, kept here under names of their own.
                self.sarsim("focus", "sar_r.scr", "--out", f"sar_r.{form}")
                (self.folder / "sar_r.hdr").rename(self.folder / f"sar_r.{form}.hdr")
        if section in ("run", "info", "geometry"):
            self.write("sar_r.scr", SCENE)
        if section == "check":
            for name in ("stripmap_motion", "mti", "search_radar", "stepped_aircraft", "turning_ship"):
                (self.folder / f"{name}.scr").unlink()
        shutil.copyfile(self.folder / "sim1.h5", self.folder / "big.h5")
        shutil.copyfile(self.folder / "sim1.h5", self.folder / "recording.h5")
        if section in ("merge", "Recipes"):
            self.parts()
        for place in (".zfunc", ".config/fish/completions"):
            (self.folder / place).mkdir(parents=True)

    def parts(self):
        self.write("scene.scr", SCENE.replace("sim1.bin", "sim.bin"))
        for k, places in ((1, ("out", "a", "here")), (2, ("out", "b", "here"))):
            for place in places:
                self.sarsim("run", "scene.scr", "1", "--out", place, "--part", f"{k}/2", "--part-file")


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
            shutil.copyfile(stage / "sar_r.scr", folder / "sar_r.scr")
        elif entry.suffix == ".scr" and "*.scr" in words:
            shutil.copyfile(entry, folder / entry.name)


def run(command, stage, folder, programs):
    """The complaint about a command, or nothing."""
    copy_named(command, stage, folder)
    started = time.monotonic()
    text = command.replace("/data", ".").replace("seed=1..1000 ", "seed=1..20 ")
    environment = dict(
        os.environ, HOME=str(folder), PATH=f"{programs}:{os.environ['PATH']}", QT_QPA_PLATFORM="offscreen"
    )
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
