#!/usr/bin/env python3
"""examples/engines/Snakefile, killed with all that it has started, unlocked and started again.

Skipped (77) without snakemake.
"""

import os
import pathlib
import signal
import subprocess
import tempfile

from engines_support import (RECIPES, bin_folder, expect, expect_done, expect_same, part_at_work, program, python_with, run,
                             write_scene)

PARTS = 4


def main():
    python = python_with("snakemake")
    with tempfile.TemporaryDirectory(prefix="sarsim-snakemake-") as name:
        folder = pathlib.Path(name)
        write_scene(folder, 100_000)
        environment = dict(os.environ, PATH=f"{bin_folder(folder)}:{os.environ['PATH']}", HOME=name)
        words = [python, "-m", "snakemake", "--snakefile", RECIPES / "Snakefile", "--cores", "2", "--config", f"parts={PARTS}"]
        with open(folder / "log", "w") as log:
            # In a session of its own, so that it can be killed with its children.
            first = subprocess.Popen([str(w) for w in words], cwd=folder, env=environment, stdout=log, stderr=log,
                                     start_new_session=True)
        try:
            _, _, part = part_at_work(folder, "run1")
        finally:
            os.killpg(first.pid, signal.SIGKILL)
            first.wait()
        expect(not (folder / "run1" / "sim.bin").exists(), "it had finished")
        expect_done(run([*words, "--unlock"], cwd=folder, env=environment))
        again = expect_done(run(words, cwd=folder, env=environment))
        expect_done(run([program(), "run", "scene.toml", "--out", "whole"], cwd=folder))
        expect_same(folder / "whole" / "sim.bin", folder / "run1" / "sim.bin")
        expect((folder / "run1" / f"part-{PARTS}.done").exists(), f"no mark\n{again.stderr}")
        idle = expect_done(run(words, cwd=folder, env=environment))
        expect("Nothing to be done" in idle.stdout + idle.stderr, f"it computes again\n{idle.stderr}")
    print(f"Snakemake: killed in part {part}, started again: bytes of a single run")


if __name__ == "__main__":
    main()
