#!/usr/bin/env python3
"""Two signals at once, at any moment of a long run: the second ends the program and leaves no unfinished file.

    signals_test.py [--tries N]
"""

import argparse
import os
import pathlib
import signal
import sys
import tempfile
import time

import stories
from faults import TIME_LIMIT_S, end_process, start

FORMATS = ("ascii", "binary", "bracket", "csv", "hdf5", "npy")
PULSES = 2_000_000  # Far more than are made before the signals.


def unfinished(folder):
    return sorted(path.name for path in folder.glob(".*.partial-*"))


def wait_for_file(process, folder):
    """Whether the run has begun its file."""
    end = time.monotonic() + TIME_LIMIT_S
    while process.poll() is None and time.monotonic() < end:
        if unfinished(folder):
            return True
        time.sleep(0.005)
    return False


def send_at_once(process, *numbers):
    """Signals that are all pending before the process goes on; sent one by one, the first may have ended it."""
    process.send_signal(signal.SIGSTOP)
    os.waitid(os.P_PID, process.pid, os.WSTOPPED | os.WEXITED | os.WNOWAIT)
    for number in numbers:
        process.send_signal(number)
    process.send_signal(signal.SIGCONT)


def try_format(word, folder, delay):
    """What is wrong with how the run ends."""
    for name, text in stories.scene(stories.moving(PULSES)).items():
        (folder / name).write_text(text)
    before = {path.name for path in folder.iterdir()}
    process = start(("run", "scene.scr", "--threads", "1", "--format", word, "--quiet"), folder)
    try:
        if not wait_for_file(process, folder):
            return "begins no file"
        time.sleep(delay)
        send_at_once(process, signal.SIGTERM, signal.SIGINT)  # Two of one kind may arrive as one.
        process.wait(TIME_LIMIT_S)
    finally:
        end_process(process)
    if process.returncode not in (-signal.SIGTERM, -signal.SIGINT):
        return f"ended with {process.returncode}"
    left = {path.name for path in folder.iterdir()} - before
    return f"left {', '.join(sorted(left))}" if left else None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tries", type=int, default=4)
    arguments = parser.parse_args()
    wrong = []
    for word in FORMATS:
        for attempt in range(arguments.tries):
            with tempfile.TemporaryDirectory(prefix="sarsim-signals-") as folder:
                found = try_format(word, pathlib.Path(folder), 0.05 * attempt)
            if found:
                wrong.append(f"{word}, {50 * attempt} ms after its file began: {found}")
    print("\n".join(wrong) or f"nothing is left of {len(FORMATS) * arguments.tries} runs")
    sys.exit(bool(wrong))


main()
