#!/usr/bin/env python3
"""A recipe on two workers, one of which is killed with the program that it has started, and then one alone.

    workers_test.py dask     examples/engines/dask_sweep.py
    workers_test.py ray      examples/engines/ray_sweep.py

The first is a machine that was lost: its part is made by the other worker from where it stood. The second leaves a program
that goes on, but for Ray: whoever is given its part finds it taken (exit status 75) and waits. Skipped (77) where no Python has the engine.
"""

import fcntl
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

from engines_support import (RECIPES, bin_folder, expect, expect_done, expect_same, part_at_work, program, python_with, run,
                             write_scene)

PARTS = 6
ENGINES = {"dask": ("dask", "distributed"), "ray": ("ray",)}


def wait_for(file, words):
    end = time.monotonic() + 60  # Python starts anew on each worker, which takes long on a machine that has much else to do.
    while words not in file.read_text():
        expect(time.monotonic() < end, f"no '{words}' in\n{file.read_text()[-3000:]}")
        time.sleep(0.02)


def stop_part_at_work(folder, output, lost):
    """Stops a process that makes another part than the lost one and does not hold the lock of the folder.

    One that ends before it stands still does not count.
    """
    known = [lost]
    while True:
        pid, parent, part = part_at_work(folder, output, known)
        if not signalled(pid, signal.SIGSTOP) or not stands_still(pid):
            known.append(part)
        elif is_open(folder / output / "sim.bin.parts"):
            return pid, parent, part
        else:
            signalled(pid, signal.SIGCONT)
            time.sleep(0.01)


def signalled(pid, number):
    try:
        os.kill(pid, number)
    except ProcessLookupError:
        return False
    return True


def is_open(parts):
    """Whether a process may enter the folder: nobody who stands still holds its lock."""
    end = time.monotonic() + 1
    with open(parts / "lock", "r+") as lock:
        while time.monotonic() < end:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                return True
            except BlockingIOError:
                time.sleep(0.01)
    return False


def stands_still(pid):
    """Whether a process was stopped, not ended; waits until it is one of them."""
    while True:
        try:
            state = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
        except OSError:
            return False
        if state in "TZX":
            return state == "T"
        time.sleep(0.01)


def main():
    engine = sys.argv[1]
    python = python_with(*ENGINES[engine])
    with tempfile.TemporaryDirectory(prefix=f"sarsim-{engine}-") as name:
        folder = pathlib.Path(name)
        write_scene(folder, 160_000)
        environment = dict(os.environ, PATH=f"{bin_folder(folder)}:{os.environ['PATH']}")
        sarsim = ["run", "scene.toml", "--out", "run1"]
        words = [python, RECIPES / f"{engine}_sweep.py", "--workers", "2", "--parts", PARTS, *sarsim]
        with open(folder / "log", "w") as log:
            script = subprocess.Popen([str(w) for w in words], cwd=folder, env=environment, stdout=log, stderr=log)
        try:
            pid, worker, lost = part_at_work(folder, "run1")
            os.kill(worker, signal.SIGKILL)
            os.kill(pid, signal.SIGKILL)
            pid, worker, orphan = stop_part_at_work(folder, "run1", lost)
            os.kill(worker, signal.SIGKILL)
            expect_done(run([program(), "run", "scene.toml", "--out", "whole", "--threads", "1"], cwd=folder))
            if engine == "dask":  # Ray ends what its workers have started.
                wait_for(folder / "log", f"part {orphan.replace('-of-', '/')} is being made by another process")
                os.kill(pid, signal.SIGCONT)
            script.wait(60)
        except SystemExit:
            print((folder / "log").read_text()[-3000:])
            raise
        finally:
            script.kill()
            script.wait()
        expect(script.returncode == 0, f"exit status {script.returncode}\n{(folder / 'log').read_text()[-3000:]}")
        expect_same(folder / "whole" / "sim.bin", folder / "run1" / "sim.bin")
        bad = run([*words, "--bandwidth", "1"], cwd=folder, env=environment)
        expect(bad.returncode == 2, f"bad input: {bad.returncode}\n{bad.stderr}")
    print(f"{engine}: part {lost} was lost with its machine, {orphan} with its worker: bytes of a single run")


if __name__ == "__main__":
    main()
