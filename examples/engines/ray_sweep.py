#!/usr/bin/env python3
"""A sweep, or one recording, in parts as tasks of Ray.

    ray_sweep.py --parts 50 sweep scene.toml --set seed=1..1000 --out /shared/runs
    ray_sweep.py --parts 8 --address auto run scene.toml --out /shared/run1

Without --address, Ray is started on this machine. The arguments are those of sarsim; each part is a process
"sarsim ... --part K/N --resume" of its own, in the folder in which this is called, which all nodes must see. Parts of nodes
that are lost are made by others.
"""

import argparse
import os
import subprocess
import sys
import time

import ray

BAD_INPUT, TRY_AGAIN = 2, 75


@ray.remote(max_retries=3, retry_exceptions=True)
def make_part(number, parts, command, folder):
    """Makes a part; may be called again, on any node, whatever became of an earlier call. Returns the exit status."""
    words = ["sarsim", *command, "--part", f"{number}/{parts}", "--resume", "--quiet"]
    while (status := subprocess.run(words, cwd=folder, check=False).returncode) == TRY_AGAIN:
        time.sleep(5)  # The process of a lost node still makes this part.
    if status not in (0, BAD_INPUT):
        raise RuntimeError(f"part {number}/{parts}: exit status {status}")
    return status


def main():
    parser = argparse.ArgumentParser(usage="%(prog)s [--address ADDRESS] [--workers N] [--parts N] [--threads N] ARGUMENTS OF SARSIM")
    parser.add_argument("--address", help="of a cluster that runs, or auto")
    parser.add_argument("--workers", type=int, help="processors of this machine, where there is no cluster")
    parser.add_argument("--parts", type=int, default=8)
    parser.add_argument("--threads", type=int, default=1, help="of each part")
    parser.add_argument("command", nargs=argparse.REMAINDER)
    options = parser.parse_args()
    ray.init(address=options.address, num_cpus=None if options.address else options.workers)
    numbers = range(1, options.parts + 1)
    command = [*options.command, "--threads", str(options.threads)]
    task = make_part.options(num_cpus=options.threads)
    todo = [task.remote(number, options.parts, command, os.getcwd()) for number in numbers]
    while todo:
        (done,), todo = ray.wait(todo)
        if ray.get(done) == BAD_INPUT:  # Its message stands in the log of the node; no retry can help.
            sys.exit(BAD_INPUT)


if __name__ == "__main__":
    main()
