#!/usr/bin/env python3
"""The harness finds each kind of fault, in programs that have just that one."""

import os
import pathlib
import tempfile
import unittest

import harness
from harness import Case, try_case

GOOD = "echo 'scene.scr:1:3: error: wrong; found 5, expected 6' >&2; exit 2"


class Faults(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program = pathlib.Path(folder.name) / "program"
        self.addCleanup(os.environ.__setitem__, "SARSIM_PROGRAM", os.environ.get("SARSIM_PROGRAM", ""))
        os.environ["SARSIM_PROGRAM"] = str(self.program)
        self.addCleanup(setattr, harness, "TIME_LIMIT_S", harness.TIME_LIMIT_S)

    def faults_of(self, text, **more):
        """What is found wrong with a program of this text."""
        self.program.write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
        self.program.chmod(0o755)
        case = Case("case", "5", {"scene.scr": "1 @5\n", "sim.bin": "earlier"}, message=["found 5"], **more)
        return " ".join(try_case(case)[1])

    def test_nothing_is_wrong_with_a_proper_refusal(self):
        self.assertEqual(self.faults_of(GOOD), "")

    def test_silent_acceptance(self):
        self.assertIn("exit status 0 instead of 2", self.faults_of("exit 0"))

    def test_crash(self):
        self.assertIn("exit status -6", self.faults_of("kill -ABRT $$"))

    def test_hang(self):
        harness.TIME_LIMIT_S = 0.3
        self.assertIn("did not end", self.faults_of("sleep 60"))

    def test_place_of_another_line(self):
        self.assertIn("does not name scene.scr:1:3", self.faults_of(GOOD.replace("1:3", "2:3")))

    def test_missing_hint(self):
        self.assertIn("no hint", self.faults_of(GOOD.replace(", expected 6", "")))

    def test_message_told_twice(self):
        self.assertIn("2 errors instead of one", self.faults_of(GOOD.replace("exit", "echo 'error: again' >&2; exit")))

    def test_other_talk(self):
        self.assertIn("more is said", self.faults_of("echo hello >&2; " + GOOD))

    def test_other_message(self):
        self.assertIn("does not say: found 5", self.faults_of(GOOD.replace("found 5", "found 7")))

    def test_words_on_standard_output(self):
        self.assertIn("standard output", self.faults_of("echo hello; " + GOOD))

    def test_file_left_behind_even_if_hidden(self):
        self.assertIn(".part: left behind", self.faults_of("touch .part; " + GOOD))

    def test_folder_left_behind(self):
        self.assertIn("out: left behind", self.faults_of("mkdir out; " + GOOD))

    def test_earlier_file_changed_or_gone(self):
        self.assertIn("sim.bin: changed", self.faults_of("echo more >> sim.bin; " + GOOD))
        self.assertIn("sim.bin: gone", self.faults_of("rm sim.bin; " + GOOD))

    def test_report_of_a_sanitizer(self):
        self.assertIn("insides", self.faults_of("echo '==1==ERROR: AddressSanitizer: x' >&2; " + GOOD))


if __name__ == "__main__":
    unittest.main()
