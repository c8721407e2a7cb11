#!/usr/bin/env python3
"""Lets system calls of every command that writes fail, one after the other.

    fault_test.py [--all] [--tries N] [--seed S] [STORY...]

Whatever fails, a command either ends well and has made what it should, or ends with a status and a message that names
the file; what was there under a name stays as it was, and nothing unfinished is left. With --all every call is made to
fail in every way; otherwise N tries of each story, chosen by the seed.
"""

import argparse
import collections
import dataclasses
import pathlib
import random
import shutil
import sys

from faults import ALL_CALLS, FAULTS, Fault, count_calls, program, stages, try_fault
from stories import all_stories


def tries_of(stage, arguments, chance):
    """(fault, number of the call, whether over an earlier result)."""
    chosen = []
    for earlier in (False, True) if stage.story.force else (False,):
        for fault in FAULTS:
            calls = len(count_calls(stage, fault, earlier)) if arguments.all else None
            if arguments.all:
                chosen += [(fault, at, earlier) for at in range(1, calls + 1)]
    if arguments.all:
        return chosen
    return [draw(stage, chance) for _ in range(2 if stage.story.slow else arguments.tries)]


_counts = {}


def draw(stage, chance):
    fault = chance.choice(FAULTS)
    earlier = bool(stage.story.force) and chance.random() < 0.7
    key = (stage.story.name, earlier)
    if key not in _counts:
        _counts[key] = count_calls(stage, Fault("any", 0, ALL_CALLS), earlier)
    calls = [call for call in _counts[key] if call[0] in fault.calls]
    # Of many writes alike, the first, the last and any between; others are rare and more telling.
    kinds = sorted({call for call, _ in calls})
    if not kinds:
        return fault, 1, earlier
    kind = chance.choice(kinds)
    return fault, chance.choice([i for i, (call, _) in enumerate(calls, 1) if call == kind]), earlier


def faults_of_stale_file(story):
    """What passes by itself ends with a status of its own: whoever started the command may try again."""
    stale = dataclasses.replace(FAULTS[-1], statuses=(75,))
    with stages([story]) as chosen:
        (stage,) = chosen
        found = [text for call in ("write", "renameat2") for text in stale_at(stage, dataclasses.replace(stale, calls=(call,)))]
    print("\n".join(found))
    return found


def stale_at(stage, fault):
    found = try_fault(stage, fault, 1, False)
    return [f"{stage.story.name}: no {fault.calls[0]} was made"] if found is None else found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("stories", nargs="*")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--tries", type=int, default=8)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    known = all_stories()
    names = arguments.stories or list(known)
    chance = random.Random(arguments.seed)
    told, tried = [], collections.Counter()
    with stages(known[name] for name in names) as chosen:
        for stage in chosen:
            for fault, at, earlier in tries_of(stage, arguments, chance):
                found = try_fault(stage, fault, at, earlier)
                if found is None:
                    continue
                tried[stage.story.name] += 1
                told += found
                for text in found:
                    print(text, flush=True)
            shutil.rmtree(stage.root)
    told += faults_of_stale_file(known["format"])
    print(f"{sum(tried.values())} faults in {len(tried)} stories, {len(told)} failures")
    sys.exit(1 if told else 0)


if __name__ == "__main__":
    main()
