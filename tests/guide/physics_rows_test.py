#!/usr/bin/env python3
"""Compares the table of choices in docs/guide/physics.md with the language of scenes.

    physics_rows_test.py CHECKOUT     the pages as they are
    physics_rows_test.py --self       whether faults of the pages are found

The reference of docs/formats/scene.md is compared with the program by another test, so it represents the language here. Reports
  * each object, choice and field of the reference without a word in the table, and each word that the reference does not have;
  * what is modelled by a field of the language and listed as not modelled, in physics.md or limits.md.
Exit status: 0 nothing found, 1 something found.
"""

import pathlib
import re
import sys

# Fields that change no echo: names of objects and of files, and how files are written.
SILENT = {
    "platform": {"name"},
    "target": {"platform"},
    "surface": {"platform"},
    "cloud": {"platform", "file"},
    "radar": {"name", "platform"},
    "recording": {"radar", "file", "format"},
    "geometry": {"radar", "range", "time", "file", "separator", "columns"},
}

# Beginnings of a first cell of a list of what is not modelled, for each field that models it.
MODELLED = {
    ("atmosphere", "rain"): r"rain\b|losses? (on the way|by rain)",
    ("atmosphere", "gases"): r"gases|losses? (on the way|by gases)|propagation losses",
    ("atmosphere", "ionosphere"): r"ionosphere|the ionosphere(?!'s)|Faraday",
    ("atmosphere.refraction", "exponential"): r"(losses and )?refraction|the delay of the air|troposphere",
    ("options", "ambiguous_echoes"): r"echoes of (earlier|other) pulses(?! below)|range-ambiguous",
    ("options", "eclipsing"): r"blanking",
    ("world.frame", "earth"): r"the (turning )?Earth|light time over",
    ("platform.path", "orbit"): r"orbits",
    ("platform.position_error", "gusts"): r"gusts|turbulence",
    ("platform.waves", "ship"): r"ships|waves",
    ("platform.navigation", "ins"): r"navigation|errors of navigation",
    ("platform", "parent"): r"rotors|platforms on platforms",
    ("radar.antenna", "points"): r"antennas that are not even|asymmetric patterns",
    ("radar", "noise_temperature"): r"(receiver )?noise\b",
}

HEADING = re.compile(r"^### `?\[+(\w+)\]+`?\s*$|^#### `?([\w.]+)`?\s*$")


def language_of(page):
    """Tables of the reference, {"radar.pulse": {"mono", ...}}; of fields outside of choices only their first part."""
    tables = {}
    here = None
    for line in page[page.index("## Reference") :].split("\n"):
        found = HEADING.match(line)
        if line.startswith("###"):
            here = (found[1] or found[2]) if found else None
            if here is not None:
                tables.setdefault(here, set())
            continue
        cell = re.match(r"\| (`[^|]*`) \|", line)
        if here is None or not cell:
            continue
        for word in re.findall(r"`([^`]+)`", cell[1]):
            if "." in word and "." in here:
                continue  # a field of a choice, which the choice stands for
            tables[here].add(word.split(".")[0])
    return {name: words for name, words in tables.items() if words}


def rows_below(page, heading, columns):
    section = page[page.index(heading) :].split("\n## ")[0]
    for line in section.split("\n"):
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if len(cells) == columns and not set(cells[0]) <= {"-", " "}:
            yield cells


def faults(scene, physics, limits):
    found = []
    language = language_of(scene)
    table = {}
    for cells in rows_below(physics, "## Every choice of a scene", 3):
        for name in re.findall(r"`([^`]+)`", cells[0]):
            table[name] = set(re.findall(r"`([^`]+)`", cells[1]))
    for name, words in language.items():
        words = words - SILENT.get(name, set())
        for missing in sorted(words - table.get(name, set())):
            found.append(f"physics.md: `{name}` has no word for `{missing}`")
    for name, words in table.items():
        for stale in sorted(words - language.get(name, set())):
            found.append(f"physics.md: `{name}` has no `{stale}` in the language of scenes")
    left_out = [cells[0] for cells in rows_below(physics, "## What is not modelled", 3)]
    summary = re.search(r"What the model leaves out \(([^)]*)\)", limits)
    if not summary:
        found.append("limits.md: no list of what the model leaves out")
    else:
        left_out += [item.strip() for item in summary[1].replace("\n", " ").split(",")]
    for (name, word), pattern in MODELLED.items():
        if word not in language.get(name, set()):
            found.append(f"this test: `{name}` has no `{word}`")
        for cell in left_out:
            if re.match(pattern, cell, re.IGNORECASE):
                found.append(f"'{cell}' is listed as not modelled; `{name}` `{word}` models it")
    return found


def self_test(root):
    pages = pages_of(root)
    assert not faults(*pages), faults(*pages)
    scene, physics, limits = pages
    broken = [
        (scene, physics.replace("`gusts`", "", 1), limits),
        (scene, physics.replace("`zero-doppler`", "`zero-dopler`"), limits),
        (scene.replace("| `gusts` |", "| `storms` |"), physics, limits),
        (scene, physics.replace("| polarisation |", "| losses and refraction on the way |"), limits),
        (scene, physics, limits.replace("(shadowing", "(echoes of earlier pulses, shadowing")),
    ]
    for number, case in enumerate(broken):
        assert case != pages, f"fault {number} could not be made"
        assert faults(*case), f"fault {number} is not found"


def pages_of(root):
    return tuple(
        (root / "docs" / page).read_text("utf-8") for page in ("formats/scene.md", "guide/physics.md", "guide/limits.md")
    )


def main():
    if sys.argv[1] == "--self":
        self_test(pathlib.Path(__file__).resolve().parents[2])
        return 0
    found = faults(*pages_of(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "physics rows: nothing found")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
