#!/usr/bin/env python3
"""Kills random parts of a run again and again: the file is that of a single run, and nothing is computed twice that a
journal vouches for.

    kill_test.py [--kills N] [--seed S] [--format WORD] [--lsb MV]

The program is SARSIM_PROGRAM or SARSIM_BUILT_PROGRAM of the environment.
"""

import argparse
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import tempfile
import time

from parts_support import FILES, claims, expect, expect_done, expect_same, program, run, write_scene

PARTS = 8
ROUNDS = 5


class Worker:
    """One part, started as often as it takes."""

    def __init__(self, number, folder, word):
        self.number, self.folder, self.word = number, folder, word
        self.journal = folder / "out" / (FILES[word] + ".parts") / f"part-{number}-of-{PARTS}.journal"
        self.before = []
        self.start()

    def start(self):
        words = [program(), "run", "scene.scr", "--out", "out", "--format", self.word, "--quiet", "--json", "--threads", 1]
        words += ["--part", f"{self.number}/{PARTS}", "--resume", "--save-every", "0.05"]
        self.process = subprocess.Popen(
            [str(w) for w in words], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
        )

    def busy(self):
        return self.process.poll() is None

    def kill(self):
        """Whether it was killed in the middle of its work."""
        self.process.send_signal(signal.SIGKILL)
        self.process.communicate()
        if self.process.returncode != -signal.SIGKILL:
            return False
        now = claims(self.journal)
        if self.before and not self.journal.exists():  # The file was complete: only what made it up was being removed.
            now = self.before
        expect(now[: len(self.before)] == self.before, f"part {self.number}: the journal was not only added to")
        rows = sorted(now)
        for (first, count), (following, _) in zip(rows, rows[1:]):
            expect(first + count <= following, f"part {self.number}: row {following} was vouched for twice")
        self.before = now
        self.start()
        return True

    def finish(self):
        out, err = self.process.communicate(timeout=250)
        expect(self.process.returncode == 0, f"part {self.number}: status {self.process.returncode}\n{err}")
        part = json.loads(out)["products"][0]
        known = sum(count for _, count in self.before)
        expect(part["rejected_rows"] == 0, f"part {self.number}: a row that was vouched for was not there")
        # Another part may have put the file together before this one was started the last time.
        expect(
            part["computed_rows"] in (part["part_rows"] - known, 0),
            f"part {self.number}: {part['computed_rows']} rows were computed, {known} of {part['part_rows']} were known",
        )
        return part


def kill_at_random(workers, kills, chance):
    """How many of the kills found somebody at work."""
    done = 0
    while done < kills and (busy := [w for w in workers if w.busy()]):
        time.sleep(chance.uniform(0.02, 0.12))
        done += chance.choice(busy).kill()
    return done


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--kills", type=int, default=30)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--format", choices=FILES, default="binary")
    parser.add_argument("--lsb", default="3e-5")
    parser.add_argument("--pulses", type=int, default=240_000)
    arguments = parser.parse_args()
    chance = random.Random(arguments.seed)
    with tempfile.TemporaryDirectory(prefix="sarsim-kill-") as name:
        folder = pathlib.Path(name)
        write_scene(folder, arguments.pulses, arguments.lsb)
        expect_done(run([program(), "run", "scene.scr", "--out", "whole", "--format", arguments.format], cwd=folder))
        # On one core the work lasts as long on any machine, and there is somebody to be killed to the end.
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
        kills, known = 0, 0
        for _ in range(ROUNDS):  # Where much else is done, this script sleeps longer than it asked for, and a run ends early.
            workers = [Worker(k, folder, arguments.format) for k in range(1, PARTS + 1)]
            kills += kill_at_random(workers, arguments.kills - kills, chance)
            known += sum(count for w in workers for _, count in w.before)
            parts = [w.finish() for w in workers]
            expect(any(part["complete"] for part in parts), "no part has completed the file")
            file = FILES[arguments.format]
            expect_same(folder / "whole" / file, folder / "out" / file)
            if kills == arguments.kills:
                break
            shutil.rmtree(folder / "out")
        expect(kills == arguments.kills, f"only {kills} kills found somebody at work in {ROUNDS} runs")
        print(f"{kills} kills, {known} rows were known from journals, same bytes")


if __name__ == "__main__":
    main()
