"""Whether every example is the same scene in both languages: NAME.toml (format 2) beside NAME.scr.

usage: same_in_both_languages.py SARSIM [FOLDER]

Compares the scenes, bit for bit, without a platform Earth that stands at the origin (format 2 leaves it out), the samples
of all recordings, the findings of "sarsim check", and the commands that the headings quote. Prints what differs and ends
with status 1 where something does.
"""

import difflib
import pathlib
import re
import sys
import tempfile

from run_example import Sarsim, failed, quotations, run

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"
OLD_LANGUAGE_ONLY = {"sar_r_1998"}  # teaches what a script of 1998 does
# What the language of 1998 cannot say: the Earth, orbits, legs, gusts, waves, parents.
NEW_LANGUAGE_ONLY = {"formation", "gusts", "helicopter", "satellite", "ship_in_waves"}
LONGEST_LINE = 120
RESTING_EARTH = '[[platform]]\nname = "Earth"\n\n'  # at the origin


def scene_text(sarsim, path):
    """A scene as format 2 writes it, with every value to its last bit, and complaints."""
    done = sarsim("format", str(path), "--upgrade")
    if done.returncode != 0:
        return "", failed(f"sarsim format {path.name}", done)
    return done.stdout.replace(RESTING_EARTH, "", 1), []


def complaints_about_scenes(sarsim, pair):
    texts = []
    for path in pair:
        text, complaints = scene_text(sarsim, path)
        if complaints:
            return complaints
        texts.append(text.splitlines())
    lines = list(difflib.unified_diff(*texts, *(path.name for path in pair), n=1, lineterm=""))
    return ["the scenes differ\n" + "\n".join(lines)] if lines else []


def complaints_about_findings(sarsim, pair):
    """Counts of errors, warnings and notes; the places are others."""
    counts = []
    for path in pair:
        done = sarsim("check", str(path))
        if done.returncode != 0:
            return failed(f"sarsim check {path.name}", done)
        counts.append(done.stdout.splitlines()[-1].rpartition(": ")[2])
    return [] if counts[0] == counts[1] else [f"sarsim check finds {counts[1]}, in the script {counts[0]}"]


def samples(sarsim, path):
    """Bytes of each recording by its name, and complaints."""
    products, complaints = run(sarsim, str(path), path.suffix[1:], "--format", "npy")
    files = [sarsim.folder / product["file"] for product in products]
    return {file.name: file.read_bytes() for file in files}, complaints


def complaints_about_samples(sarsim, pair):
    (old, old_complaints), (new, new_complaints) = (samples(sarsim, path) for path in pair)
    if old_complaints or new_complaints:
        return old_complaints + new_complaints
    if list(old) != list(new):
        return [f"the recordings are {', '.join(new)}, in the script {', '.join(old)}"]
    return [f"the samples of {name} differ" for name in old if old[name] != new[name]]


def complaints_about_comments(pair):
    """The headings have to quote the same commands, each with its own file."""
    old, new = (quotations(path.read_text(encoding="utf-8")) for path in pair)
    wanted = [re.sub(rf"\b{re.escape(pair[0].name)}\b", pair[1].name, quote) for quote in old]
    return [] if new == wanted else [f"the heading quotes {new} instead of {wanted}"]


def complaints_about_lines(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    return [f"line {n} is longer than {LONGEST_LINE} characters" for n, line in enumerate(lines, 1) if len(line) > LONGEST_LINE]


def complaints_about(program, script):
    """What is wrong with the scene of format 2 that belongs to a script."""
    scene = script.with_suffix(".toml")
    if not scene.is_file():
        return [f"there is no {scene.name}"]
    pair = (script, scene)
    with tempfile.TemporaryDirectory() as folder:
        sarsim = Sarsim(program, folder)
        complaints = complaints_about_scenes(sarsim, pair)
        if not complaints:
            complaints = complaints_about_findings(sarsim, pair) + complaints_about_samples(sarsim, pair)
    return complaints + complaints_about_comments(pair) + complaints_about_lines(scene)


def own_complaints(scene):
    return [f"{scene.name}: {complaint}" for complaint in complaints_about_lines(scene)]


def complaints_about_folder(program, folder):
    """All of a folder's, each with the name of its file."""
    scripts = {path.stem: path for path in sorted(folder.glob("*.scr"))}
    said = [] if scripts else [f"{folder}: no examples"]
    for name, script in scripts.items():
        if name not in OLD_LANGUAGE_ONLY:
            said += [f"{name}.toml: {complaint}" for complaint in complaints_about(program, script)]
    scenes = {path.stem for path in folder.glob("*.toml")}
    lonely = sorted(f"{name}.toml" for name in scenes - scripts.keys() - NEW_LANGUAGE_ONLY)
    said += [f"{name}.toml: there is a script of that name" for name in sorted(NEW_LANGUAGE_ONLY & scripts.keys())]
    said += [line for name in sorted(NEW_LANGUAGE_ONLY & scenes) for line in own_complaints(folder / f"{name}.toml")]
    return said + [f"{name}: there is no script that it belongs to" for name in lonely]


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    folder = pathlib.Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else EXAMPLES
    complaints = complaints_about_folder(program, folder)
    print("\n".join(complaints) or f"{folder}: the same in both languages")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
