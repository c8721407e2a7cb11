#!/usr/bin/env python3
"""A sweep, or one recording, in parts on the workers of Dask.

    dask_sweep.py --parts 50 sweep scene.toml --set seed=1..1000 --out /shared/runs
    dask_sweep.py --parts 8 --scheduler tcp://lab:8786 run scene.toml --out /shared/run1

Without --scheduler the workers are processes of this machine. The arguments are those of sarsim; each part is a process
"sarsim ... --part K/N --resume" of its own, in the folder in which this is called, which all workers must see. Parts of
workers that are lost are made by others.
"""

import argparse
import os
import subprocess
import sys
import time

from dask.distributed import Client, as_completed

BAD_INPUT, TRY_AGAIN = 2, 75


def make_part(number, parts, command, folder):
    """Makes a part; may be called again, on any worker, whatever became of an earlier call. Returns the exit status."""
    words = ["sarsim", *command, "--part", f"{number}/{parts}", "--resume", "--quiet"]
    while (status := subprocess.run(words, cwd=folder, check=False).returncode) == TRY_AGAIN:
        time.sleep(5)  # The process of a lost worker still makes this part.
    if status not in (0, BAD_INPUT):
        raise RuntimeError(f"part {number}/{parts}: exit status {status}")
    return status


def main():
    usage = "%(prog)s [--scheduler ADDRESS] [--workers N] [--parts N] [--threads N] ARGUMENTS OF SARSIM"
    parser = argparse.ArgumentParser(usage=usage)
    parser.add_argument("--scheduler", help="address of a scheduler that runs")
    parser.add_argument("--workers", type=int, help="processes of this machine, where there is no scheduler")
    parser.add_argument("--parts", type=int, default=8)
    parser.add_argument("--threads", type=int, default=1, help="of each part")
    parser.add_argument("command", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    local = {"n_workers": options.workers, "threads_per_worker": 1, "dashboard_address": None}
    with Client(options.scheduler) if options.scheduler else Client(**local) as client:
        numbers = range(1, options.parts + 1)
        command = [*options.command, "--threads", str(options.threads)]
        task = {"parts": options.parts, "command": command, "folder": os.getcwd()}
        futures = client.map(make_part, numbers, **task, pure=False, retries=3)
        for future in as_completed(futures):
            if future.result() == BAD_INPUT:  # Its message stands in the log of the worker; no retry can help.
                client.cancel(futures)
                sys.exit(BAD_INPUT)


if __name__ == "__main__":
    main()
