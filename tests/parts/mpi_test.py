#!/usr/bin/env python3
"""sarsim-mpi: the bytes of a single run with any number of ranks, restarts, and what it refuses.

The programs are SARSIM_BUILT_PROGRAM and SARSIM_BUILT_MPI_PROGRAM of the environment. Skipped (77) without mpirun.
"""

import concurrent.futures
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from parts_support import FILES, SKIPPED, claims, expect, expect_done, expect_same, program, run, write_scene

PULSES = 100_000  # Of a run that is killed.
MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "--mca", "btl", "self,vader,tcp"]


def mpi(ranks, *words):
    """A job with a folder of its own for what its processes share: by default the jobs of a user share one, and a job
    that ends may remove it while another begins."""
    shared = ["--mca", "orte_tmpdir_base", tempfile.mkdtemp(prefix="job-")]
    return [*MPIRUN, *shared, "-n", str(ranks), os.environ["SARSIM_BUILT_MPI_PROGRAM"], *words]


def figures(err):
    """The report but for its times."""
    return err[err.rindex("  largest magnitude") :]


def same_bytes(folder):
    for lsb in ("3e-5", "0"):
        write_scene(folder, 400, lsb)
        for word, file in FILES.items():
            whole = expect_done(
                run([program(), "run", "scene.scr", "--format", word, "--out", "whole", "--force"], cwd=folder)
            )
            # How rows are dealt knows no formats.
            for ranks in (1, 2, 4) if word == "binary" else (4,):
                out = f"out-{word}-{lsb}-{ranks}"
                together = expect_done(
                    run(mpi(ranks, "run", "scene.scr", "--format", word, "--out", out, "--threads", "2"), cwd=folder)
                )
                expect_same(folder / "whole" / file, folder / out / file)
                expect(figures(together.stderr) == figures(whole.stderr), f"{out}: the reports differ")
                expect(together.stderr.count("largest magnitude") == 1, f"{out}: more than one rank reports")
                expect(sorted(os.listdir(folder / out)) == [file, file + ".journal"], f"{out}: something stayed")


def killed_and_resumed(folder):
    write_scene(folder, PULSES)
    expect_done(run([program(), "run", "scene.scr", "--out", "whole", "--force"], cwd=folder))
    words = mpi(3, "run", "scene.scr", "--out", "killed", "--resume", "--save-every", "0.05", "--threads", "1", "--json")
    process = subprocess.Popen(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    parts = folder / "killed" / "sim.bin.parts"
    for _ in range(1000):
        time.sleep(0.02)
        if sum(count for journal in parts.glob("*.journal") for _, count in claims(journal)) > 20_000:
            break
    victims = subprocess.run(
        ["pgrep", "-P", str(process.pid), "-f", "sarsim-mpi"], capture_output=True, text=True, check=False
    ).stdout.split()
    expect(len(victims) == 3, f"not three ranks but {victims}")
    os.kill(int(victims[-1]), signal.SIGKILL)
    process.communicate(timeout=60)
    expect(process.returncode != 0, "the loss of a rank was not noticed")
    known = sum(count for journal in parts.glob("*.journal") for _, count in claims(journal))
    expect(known > 20_000, "the journals have lost something")
    again = expect_done(run(mpi(2, *words[words.index("run") :]), cwd=folder))
    part = json.loads(again.stdout)["products"][0]
    expect(part["computed_rows"] == PULSES - known, f"{part['computed_rows']} rows computed, {known} were known")
    expect_same(folder / "whole" / "sim.bin", folder / "killed" / "sim.bin")
    finished = expect_done(run(mpi(2, *words[words.index("run") :]), cwd=folder))
    expect(json.loads(finished.stdout)["products"][0]["computed_rows"] == 0, "a finished run computes again")


def taken(folder):
    """The journal of a process that works on the first pulse: all processes of the job end so that it is tried again."""
    write_scene(folder, 400_000)
    part = [program(), "run", "scene.scr", "--out", "taken", "--part", "1/2", "--threads", "1", "--quiet"]
    busy = subprocess.Popen([str(w) for w in part], cwd=folder)
    try:
        for _ in range(500):
            if (folder / "taken" / "sim.bin.parts" / "part-1-of-2.journal").exists():
                break
            time.sleep(0.01)
        refused = run(mpi(3, "run", "scene.scr", "--out", "taken", "--resume"), cwd=folder, timeout=60)
    finally:
        busy.kill()
        busy.wait()
    expect(refused.returncode == 75, f"status {refused.returncode}: {refused.stderr}")
    expect(refused.stderr.count("which is being made") == 1, f"not told once: {refused.stderr}")


def refusals(folder):
    alone = run([os.environ["SARSIM_BUILT_MPI_PROGRAM"], "run", "scene.scr"], cwd=folder)
    expect(alone.returncode == 2 and "was not started by MPI" in alone.stderr, f"started alone: {alone.stderr}")
    write_scene(folder, 100)
    cases = (
        (["run", "nothing.scr"], "nothing.scr"),
        (["run", "scene.scr", "--part", "1/2"], "MPI distributes the pulses itself"),
        (["run", "scene.scr", "--discard"], "measure with sarsim run --discard"),
        (["run", "scene.scr", "--out", "whole"], "the output exists already"),
        (["check", "scene.scr"], "unknown command 'check'"),
    )
    # At once, because mpirun waits a second or two for a job that fails.
    with concurrent.futures.ThreadPoolExecutor(len(cases)) as pool:
        ends = pool.map(lambda case: run(mpi(2, *case[0]), cwd=folder, timeout=60), cases)
    for (words, sentence), refused in zip(cases, ends):
        expect(refused.returncode != 0, f"{words} was not refused")
        expect(refused.stderr.count(sentence) == 1, f"{words}: not once '{sentence}':\n{refused.stderr}")


def main():
    if shutil.which("mpirun") is None or not os.environ.get("SARSIM_BUILT_MPI_PROGRAM"):
        print("skipped: there is no mpirun, or sarsim-mpi was not built")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory(prefix="sarsim-mpi-") as name:
        folder = pathlib.Path(name)
        tempfile.tempdir = name
        refusals_folder = folder / "refusals"
        same_bytes(folder)
        killed_and_resumed(folder)
        taken(folder)
        refusals_folder.mkdir()
        (refusals_folder / "whole").mkdir()
        shutil.copy(folder / "whole" / "sim.bin", refusals_folder / "whole")
        refusals(refusals_folder)
    print("MPI: same bytes with 1, 2 and 4 ranks in every format; restarts; refusals")


if __name__ == "__main__":
    main()
