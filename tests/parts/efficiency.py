#!/usr/bin/env python3
"""Measures what parts and journals cost, and what that means for many machines. A tool, not a test.

    efficiency.py [--pulses N] [--repeat R]

Times are processor times (user and system) of all processes, because they do not depend on how many cores there are and
what else they do; the best of R. The program is SARSIM_PROGRAM or SARSIM_BUILT_PROGRAM of the environment, the MPI program
SARSIM_BUILT_MPI_PROGRAM.
"""

import argparse
import json
import os
import pathlib
import resource
import subprocess
import tempfile
import time

from parts_support import expect, program, write_scene


def processor_s():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def together(folder, commands):
    """Processor seconds of commands at the same time, wall seconds, and their JSON."""
    before, begin = processor_s(), time.monotonic()
    processes = [
        subprocess.Popen([str(w) for w in c], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        for c in commands
    ]
    outs = [p.communicate() for p in processes]
    for process, (_, err) in zip(processes, outs):
        expect(process.returncode == 0, err)
    return processor_s() - before, time.monotonic() - begin, [json.loads(out)["products"][0] for out, _ in outs]


class Bench:
    def __init__(self, folder, repeat):
        self.folder, self.repeat, self.number = folder, repeat, 0

    def run(self, *options):
        self.number += 1
        return [program(), "run", "scene.scr", "--quiet", "--json", "--threads", "1", "--out", f"o{self.number}", *options]

    def best(self, make):
        """The measurement with the least processor time."""
        return min((together(self.folder, make()) for _ in range(self.repeat)), key=lambda m: m[0])

    def single(self):
        return self.best(lambda: [self.run()])

    def parts(self, count):
        def make():
            commands = [self.run("--part", f"{k}/{count}") for k in range(1, count + 1)]
            for command in commands:
                command[command.index("--out") + 1] = f"o{self.number}"
            return commands

        return self.best(make)


def table(bench, pulses):
    single_s, _, _ = bench.single()
    print(f"{pulses} pulses, a single run: {single_s:.2f} s of processor time")
    print("| processes | processor time | more than a single run | for each process | waiting for the disk | an entry |")
    print("|---|---|---|---|---|---|")
    for count in (1, 2, 4, 8):
        used_s, _, parts = bench.parts(count)
        more_s = used_s - single_s
        journal = sum(p["journal_seconds"] for p in parts) / sum(p["seconds"] for p in parts)
        entry_s = sum(p["journal_seconds"] for p in parts) / sum(p["journal_entries"] for p in parts)
        print(f"| {count} | {used_s:.2f} s | {100 * more_s / single_s:+.1f} % | {1e3 * more_s / count:.0f} ms "
              f"| {100 * journal:.2f} % | {1e3 * entry_s:.1f} ms |")
    return single_s


def prediction(start_s):
    """Efficiency where each of P workers has one part of a run of so many hours, and needs start_s beside it."""
    print(f"\nWith {1e3 * start_s:.0f} ms for each part beside its pulses:")
    print("| run on one core | 64 workers | 1 000 workers |")
    print("|---|---|---|")
    for hours in (0.1, 1, 10, 100):
        shares = [hours * 3600 / workers for workers in (64, 1000)]
        print(f"| {hours:g} h | " + " | ".join(f"{100 * s / (s + start_s):.2f} %" for s in shares) + " |")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--pulses", type=int, default=400_000)
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="sarsim-efficiency-", dir=os.environ.get("TMPDIR")) as name:
        folder = pathlib.Path(name)
        write_scene(folder, arguments.pulses)
        bench = Bench(folder, arguments.repeat)
        table(bench, arguments.pulses)
        write_scene(folder, 64)
        prediction(bench.parts(1)[0])


if __name__ == "__main__":
    main()
