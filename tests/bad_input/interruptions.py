"""Signals while something is written: sarsim cleans up, or at least leaves nothing under a final name."""

import dataclasses
import os
import pathlib
import signal
import subprocess
import tempfile
import time

from base import SCENE, long_scene
from harness import SCRIPT, Case, Seen, changes, snapshot, start, write_files

PATIENCE_S = 60.0  # Until the writing begins.
GRACE_S = 2.0  # Of processors, from the signal to the end.


@dataclasses.dataclass
class Interruption(Case):
    """A case that a signal ends as soon as an unfinished file grows."""

    number: signal.Signals = signal.SIGINT
    grace_s: float = GRACE_S


def unfinished(folder):
    return [p for p in folder.rglob(".*.partial-*") if p.stat().st_size > 0]


def wait_for_writing(process, folder):
    """Whether an unfinished file grew while the process ran."""
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end and process.poll() is None:
        if unfinished(folder):
            return True
        time.sleep(0.005)
    return False


def processor_s_of(pid):
    """Of a program that runs; 0 where it has ended."""
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    except OSError:
        return 0.0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def processor_s_of_ended():
    """Of all programs that were started and have ended."""
    times = os.times()
    return times.children_user + times.children_system


def attempt(case, folder):
    write_files(case, folder)
    before = snapshot(folder)
    with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as err:
        # Where the tests themselves were started to survive a closed terminal, the program shall not.
        process = start(case, folder, before=("env", "--default-signal=HUP"), stdout=out, stderr=err)
        found = [] if wait_for_writing(process, folder) else ["nothing was being written"]
        before_s, others_s = processor_s_of(process.pid), processor_s_of_ended()
        os.kill(process.pid, case.number) if process.poll() is None else found.append("ended before the signal")
        try:
            status = process.wait(30)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            status = None
        seconds = processor_s_of_ended() - others_s - before_s
        if case.number == signal.SIGKILL:  # The one thing that may stay, hidden and under a name of its own.
            for path in folder.rglob(".*.partial-*"):
                path.unlink()
        left = changes(before, snapshot(folder))
        out.seek(0)
        err.seek(0)
        seen = Seen(status, out.read(), err.read(), left)
    if seconds > case.grace_s:
        found.append(f"took {seconds:.1f} s of processors to end")
    if status != case.status:
        found.append(f"exit status {status} instead of {case.status}")
    if case.number != signal.SIGKILL and seen.err.count("sarsim: interrupted; no partial output was left behind") != 1:
        found.append("the interruption is not told")
    return seen, found + left


def try_interruption(case):
    with tempfile.TemporaryDirectory(prefix="sarsim-bad-") as folder:
        return attempt(case, pathlib.Path(folder))


def interruption_cases():
    table = {
        SCRIPT: SCENE[: SCENE.index("$SIM")] + "$GEOMETRY Radar1 0 2000 0 20000 SPACE 255 t.txt\n",
        "t.txt": "earlier",
    }
    cases = []
    for number, status, words in (
        (signal.SIGHUP, 129, "SIGHUP"),
        (signal.SIGINT, 130, "Ctrl-C (SIGINT)"),
        (signal.SIGTERM, 143, "SIGTERM"),
        (signal.SIGKILL, -9, "SIGKILL (no message; a hidden unfinished file may stay)"),
    ):
        for word, option, output in (
            ("binary", "", "sim.bin"),
            ("hdf5", " --format hdf5", "sim.h5"),
            ("ascii", " --format ascii", "sim.asc"),
        ):
            command = ("run", SCRIPT, "--force", *option.split())
            cases.append(
                Interruption(
                    f"{number.name.lower()}_{word}",
                    f"{words} while {word.upper()} is written",
                    long_scene(**{output: "earlier"}),
                    command,
                    status,
                    severity="",
                    number=number,
                    shown="sarsim " + " ".join(command),
                ),
            )
        cases.append(
            Interruption(
                f"{number.name.lower()}_table",
                f"{words} while a geometry table is written",
                table,
                ("run", SCRIPT, "--force"),
                status,
                severity="",
                number=number,
                shown="sarsim run scene.scr --force",
            ),
        )
    return cases


GROUPS = {"interruptions": interruption_cases}
