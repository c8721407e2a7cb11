#!/usr/bin/env python3
"""Kills long runs at random moments: whatever has a final name is complete, or what it was.

    kill_test.py [--kills N] [--seed S]

The commands and formats take turns. Each runs over results of an earlier run and is killed (SIGKILL) at a moment between
its start and its usual end. Only hidden unfinished files may stay, which the next run does not mind.
"""

import argparse
import collections
import fnmatch
import os
import random
import signal
import sys
import time

import stories
from faults import EARLIER, contents, end_process, faults_of_folder, stages, start

UNFINISHED = (".*.partial-*", "*/.*.partial-*", "*.new-*")


def long_stories():
    """Runs of some tenths of a second."""
    words = {"binary": "bin", "ascii": "asc", "bracket": "brk", "csv": "csv", "npy": "npy", "hdf5": "h5"}
    for word, extension in words.items():
        yield stories.Story(
            f"run_{word}",
            ("run", "scene.scr", "--threads", "1", "--format", word),
            (f"sim.{extension}",),
            stories.scene(stories.moving(4000)),
        )
    sar = stories.scene(stories.SAR.replace("0.42 0.58", "0.1 0.9"), "sar.scr")
    yield stories.Story("focus", ("focus", "sar.scr", "--threads", "1"), ("sar.img", "sar.hdr"), sar)
    yield stories.Story(
        "sweep",
        ("sweep", "scene.scr", "--set", "seed=1..40", "--out", "out", "--jobs", "1"),
        ("out/sweep.csv", "out/sweep.json", *(f"out/sim-{n:02}.bin" for n in ())),
        stories.scene(stories.moving(150)),
        working=("out/sweep.journal", "out/sim*.bin"),
        same=False,
    )
    yield stories.Story(
        "resume",
        ("run", "scene.scr", "--resume", "--save-every", "0.02", "--threads", "1"),
        ("sim.bin",),
        stories.scene(stories.moving(4000)),
        force="",
        resumes=True,
        working=("sim.bin.parts*", "sim.bin.journal"),
    )


def usual_seconds(stage):
    begin = time.monotonic()
    process = start(stage.command(True), stage.copy("timed", bool(stage.story.force)))
    process.communicate()
    return time.monotonic() - begin


def recordings_are_whole(stage, after):
    """Every recording of a sweep that has its final name is that of the whole sweep."""
    return [
        f"{name} is not complete"
        for name, content in after.items()
        if fnmatch.fnmatch(name, "out/sim*.bin") and content != stage.whole[name]
    ]


def kill_once(stage, seconds, chance):
    """Whether it was killed at work, and what is wrong then."""
    folder = stage.copy("killed", bool(stage.story.force))
    before = contents(folder)
    process = start(stage.command(True), folder)
    time.sleep(chance.uniform(0.0, 1.05) * seconds)
    end_process(process)
    if process.returncode != -signal.SIGKILL:
        return False, []
    after = {name: content for name, content in contents(folder).items() if not any(fnmatch.fnmatch(name, u) for u in UNFINISHED)}
    found = faults_of_folder(stage, before, after, None) + recordings_are_whole(stage, after)
    # Then it is made anew, whatever was left.
    again = start(stage.command(True), folder)
    _, err = again.communicate()
    if again.returncode != 0:
        found.append(f"the next run fails: {err.decode(errors='replace')!r}")
    made = contents(folder)
    found += [f"the next run does not make {name}" for name in stage.story.makes if made.get(name) in (None, EARLIER)]
    found += [f"the next run makes another {name}" for name in stage.story.makes if not stage.is_whole(name, made.get(name, b""))]
    return True, found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kills", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    chance = random.Random(arguments.seed)
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})  # The work lasts as long on any machine.
    told, kills = [], collections.Counter()
    with stages(long_stories()) as chosen:
        taken = [(stage, usual_seconds(stage)) for stage in chosen]
        for attempt in range(4 * arguments.kills):
            if sum(kills.values()) >= arguments.kills:
                break
            stage, seconds = taken[attempt % len(taken)]
            killed, found = kill_once(stage, seconds, chance)
            kills[stage.story.name] += killed
            told += [f"{stage.story.name}: {text}" for text in found]
    for text in told:
        print(text)
    print(f"{sum(kills.values())} kills ({', '.join(f'{n} {k}' for k, n in kills.items())}), {len(told)} failures")
    sys.exit(1 if told or sum(kills.values()) < arguments.kills else 0)


if __name__ == "__main__":
    main()
