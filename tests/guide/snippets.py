#!/usr/bin/env python3
"""Runs the snippets of a page of the guide in their order, as a reader would, and compares what they print with the page.

usage: snippets.py PAGE BIN_FOLDER [--show]   BIN_FOLDER holds the program sarsim; --show prints what the snippets print
       snippets.py --self                       whether this finds what it looks for

A page is read by its fences:

    ```sh           run by bash in an empty folder of the page's own, with sarsim on the path and a copy of examples/
    ```python       run by Python (with NumPy, h5py and the package sarsim), ```octave by Octave, ```gdl by GNU Data Language
    ```python MODULE ...   by a Python that has these, too; SARSIM_TEST_PYTHON may name one
    ```toml NAME    written to the file NAME of that folder, as is ```scr NAME
    ```output       what the snippet before printed: these lines, in this order; "..." stands for any lines, and within a line
                    for any text

Fences in other languages of programs (matlab, idl, ...) cannot be run, and neither can those that need what is too large.
Above them the page has to say "not run by the tests". Exit status: 0 as the page says, 1 not, 77 a program was missing.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

MARK = "not run by the tests"
RUN = {"sh", "python", "octave", "gdl"}
SCENES = {"toml", "scr"}
UNRUNNABLE = {"matlab", "idl", "vba", "powershell"}
QUIET = {"", "text", "json", "csv", "make", "c"}
PROJECT = pathlib.Path(__file__).resolve().parents[2]
WORKBENCH = re.compile(r"^sarsim-gui ", re.MULTILINE)
SECONDS = 300  # With sanitizers; a second or two otherwise.


class Fence:
    def __init__(self, line, words, marked):
        self.line = line
        self.language = words[0] if words else ""
        self.words = words[1:]
        self.marked = marked
        self.lines = []

    @property
    def text(self):
        return "\n".join(self.lines) + "\n"


def read_fences(text):
    """All fences of a page, with what stands in the paragraph above them."""
    fences, open_fence, above, ended = [], None, "", True
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith("```"):
            if open_fence is None:
                open_fence = Fence(number, line[3:].split(), MARK in above)
            else:
                fences.append(open_fence)
                open_fence, above, ended = None, "", True
        elif open_fence is not None:
            open_fence.lines.append(line)
        elif line.strip():
            above, ended = (line if ended else f"{above} {line}"), False
        else:
            ended = True
    return fences


def misses(expected, printed):
    """The first line of the page's output that is not in the printed one, in this order, or None."""
    lines = iter(printed.splitlines())
    for line in expected:
        if line.strip() == "...":
            continue
        pattern = re.compile(r"\s+".join(".*".join(map(re.escape, w.split("..."))) for w in line.split()) + r"\s*$")
        if not any(pattern.match(candidate.strip()) for candidate in lines):
            return line
    return None


class Machine:
    """Runs snippets in one folder."""

    def __init__(self, folder, programs, library=None):
        self.folder = folder
        self.programs = programs  # Of each language; None where it is missing.
        self.has_workbench = (folder.parent / "bin" / "sarsim-gui").exists()
        self.environment = dict(os.environ, MPLBACKEND="Agg", QT_QPA_PLATFORM="offscreen", HOME=str(folder.parent))
        self.environment["PATH"] = f"{folder.parent / 'bin'}:{os.environ['PATH']}"
        self.environment.update(PYTHONPATH=str(PROJECT / "python"), PYTHONDONTWRITEBYTECODE="1")
        if library is not None:
            self.environment["SARSIM_LIBRARY"] = str(library)

    def program_for(self, fence):
        """What runs a snippet; None where it is missing."""
        if fence.language == "python" and fence.words:
            return python_with(["numpy", "h5py", *fence.words])
        return self.programs[fence.language]

    def run(self, fence):
        """Status and output of a snippet."""
        command = [*self.program_for(fence)]
        name = {"sh": "snippet.sh", "python": "snippet.py", "octave": "snippet.m", "gdl": "snippet.pro"}[fence.language]
        file = self.folder.parent / name
        text = fence.text
        if fence.language == "gdl":
            # A batch file, where one statement stands on one line as at the prompt.
            text = text + "exit\n"
        file.write_text(text, encoding="utf-8")
        done = subprocess.run(
            [*command, str(file)],
            cwd=self.folder,
            env=self.environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            timeout=SECONDS,
            check=False,
        )
        complaint = fence.language == "gdl" and re.search(r"^% (?!Compiled|Loaded)", done.stdout, re.MULTILINE)
        return (1 if complaint else done.returncode), done.stdout


def python_with(modules):
    for program in (sys.executable, "/usr/bin/python3", os.environ.get("SARSIM_TEST_PYTHON", "")):
        imports = f"import {', '.join(modules)}"
        if os.path.exists(program) and subprocess.run([program, "-c", imports], capture_output=True).returncode == 0:
            return [program]
    return None


def find_programs():
    octave = shutil.which("octave-cli") or shutil.which("octave")
    gdl = shutil.which("gdl")
    return {
        "sh": ["bash", "-euo", "pipefail"],
        "python": python_with(["numpy", "h5py"]),
        "octave": [octave, "--no-gui", "--norc", "-q"] if octave else None,
        "gdl": [gdl, "-q"] if gdl else None,
    }


class Result:
    def __init__(self):
        self.run, self.marked, self.missing, self.faults, self.seconds = 0, 0, [], [], {}


def check_fence(fence, machine, result):
    """Runs or counts one fence that is no output; gives what it printed, or None."""
    if fence.marked:
        result.marked += 1
    elif fence.language in SCENES and fence.words:
        (machine.folder / fence.words[0]).write_text(fence.text, encoding="utf-8")
    elif fence.language in UNRUNNABLE:
        result.faults.append(f"line {fence.line}: a snippet in {fence.language} without the words '{MARK}' above it")
    elif fence.language not in RUN | QUIET | SCENES:
        result.faults.append(f"line {fence.line}: no such language: {fence.language}")
    elif fence.language in RUN and machine.program_for(fence) is None:
        result.missing.append(fence.language + (f" with {', '.join(fence.words)}" if fence.words else ""))
    elif WORKBENCH.search(fence.text) and not machine.has_workbench:
        result.missing.append("sarsim-gui")
    elif fence.language in RUN:
        started = time.monotonic()
        status, printed = machine.run(fence)
        result.seconds[fence.line] = time.monotonic() - started
        result.run += 1
        if status != 0:
            result.faults.append(f"line {fence.line}: exit status {status}\n{fence.text}---\n{printed}")
        return printed
    return None


def check_page(text, machine, show=False):
    result, printed, before = Result(), None, None
    for fence in read_fences(text):
        if fence.language == "output":
            if before is None or before.language not in RUN or before.marked:
                result.faults.append(f"line {fence.line}: output of no snippet")
            elif printed is not None:
                missed = misses(fence.lines, printed)
                if missed is not None:
                    result.faults.append(f"line {fence.line}: not printed: {missed}\n---\n{printed}")
        else:
            printed, before = check_fence(fence, machine, result), fence
            if show and printed:
                print(f"--- line {fence.line}\n{printed}")
    return result


def prepare(root, program_folder, project):
    """The page's folder below root, with examples and programs."""
    (root / "bin").mkdir()
    (root / "work").mkdir()
    for name in ("sarsim", "sarsim-gui"):
        if (program_folder / name).exists():
            (root / "bin" / name).symlink_to((program_folder / name).resolve())
    shutil.copytree(project / "examples", root / "work" / "examples")
    return root / "work"


class Reading(unittest.TestCase):
    def setUp(self):
        self.root = tempfile.TemporaryDirectory()
        folder = pathlib.Path(self.root.name) / "work"
        folder.mkdir()
        self.machine = Machine(folder, {**find_programs(), "gdl": None})
        self.addCleanup(self.root.cleanup)

    def check(self, text):
        result = check_page(text, self.machine)
        return result.run, result.marked, result.missing, [fault.splitlines()[0] for fault in result.faults]

    def test_snippets_run_in_order_in_one_folder(self):
        text = "```toml a.toml\n# x\n```\n```sh\ncat a.toml > b\n```\n```python\nprint(open('b').read())\n```\n```output\n# x\n```\n"
        self.assertEqual(self.check(text), (2, 0, [], []))
        self.assertEqual(self.check(text.replace("toml", "scr")), (2, 0, [], []))
        self.assertEqual(self.check("```toml\nx = 1\n```\n"), (0, 0, [], []))

    def test_a_snippet_that_fails_is_found(self):
        self.assertEqual(self.check("a\n\n```sh\nfalse\ntrue\n```\n"), (1, 0, [], ["line 3: exit status 1"]))

    def test_output_that_differs_is_found(self):
        text = "```sh\nprintf 'one\\ntwo 2.5 m\\nthree\\n'\n```\n```output\n{}\n```\n"
        for good in ("one\ntwo 2.5 m\nthree", "one\n...\nthree", "two ... m", "two   2.5  m"):
            self.assertEqual(self.check(text.format(good))[3], [], good)
        for bad in ("two 2.4 m", "three\none", "two", "on"):
            self.assertEqual(len(self.check(text.format(bad))[3]), 1, bad)

    def test_what_cannot_be_run_has_to_say_so(self):
        self.assertEqual(
            self.check("```matlab\nx\n```\n")[3],
            ["line 1: a snippet in matlab without the words '" + MARK + "' above it"],
        )
        self.assertEqual(self.check(f"MATLAB ({MARK}):\n\n```matlab\nx\n```\n"), (0, 1, [], []))
        self.assertEqual(self.check(f"A ({MARK}).\n\nB:\n\n```sh\nfalse\n```\n")[3], ["line 5: exit status 1"])

    def test_unknown_languages_and_outputs_of_nothing_are_found(self):
        self.assertEqual(self.check("```cobol\n```\n")[3], ["line 1: no such language: cobol"])
        self.assertEqual(self.check("```output\nx\n```\n")[3], ["line 1: output of no snippet"])

    def test_missing_modules_are_told(self):
        self.assertEqual(self.check("```python no_such_module\nx\n```\n"), (0, 0, ["python with no_such_module"], []))
        self.assertEqual(self.check("```python json\nimport json\n```\n"), (1, 0, [], []))

    def test_a_missing_program_is_told(self):
        self.assertEqual(self.check("```gdl\nprint, 1\n```\n```output\n1\n```\n"), (0, 0, ["gdl"], []))


def main():
    if sys.argv[1:] == ["--self"]:
        unittest.main(argv=sys.argv[:1])
    page, programs = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        folder = prepare(pathlib.Path(name), programs, PROJECT)
        machine = Machine(folder, find_programs(), programs.resolve().parent / "lib" / "libsarsim.so.0")
        result = check_page(page.read_text(encoding="utf-8"), machine, "--show" in sys.argv)
    for fault in result.faults:
        print(f"{page}: {fault}")
    missing = (
        f", {len(result.missing)} left out without {', '.join(sorted(set(result.missing)))}" if result.missing else ""
    )
    print(f"{page.name}: {result.run} snippets run, {result.marked} marked as not run{missing}")
    slow = sorted(result.seconds.items(), key=lambda item: -item[1])[:3]
    print("slowest: " + ", ".join(f"line {line} {seconds:.1f} s" for line, seconds in slow))
    if result.faults:
        sys.exit(1)
    sys.exit(77 if result.missing else 0)


main()
