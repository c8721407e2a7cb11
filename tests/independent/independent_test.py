#!/usr/bin/env python3
"""Random scenes, by the program and by a second model that was written from the theory alone, sample by sample.

    independent_test.py [--scenes N] [--first S] [--engines NAME...]
    independent_test.py --show S     the script of scene S
    independent_test.py --self       whether wrong models are found

The program is SARSIM_PROGRAM or SARSIM_BUILT_PROGRAM of the environment. Where the two differ, docs/theory decides
which is right. Never read the program's sources to mend the model: it would agree with anything then. Exit status: 0
they agree, 1 not, 77 no Python with NumPy was found.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy as np
except ImportError:  # The Python that CMake found may be without it; Debian's has it.
    DEBIAN = "/usr/bin/python3"
    known = sys.executable == DEBIAN or not os.path.exists(DEBIAN)
    if known or subprocess.run([DEBIAN, "-c", "import numpy"], capture_output=True, check=False).returncode != 0:
        print("skipped: no Python with NumPy")
        sys.exit(77)
    os.execv(DEBIAN, [DEBIAN, "-B", *sys.argv])

import scenes
from model import Model
from random_scenes import family, random_scene
from running import TOLERANCE, VANISHING_V, allowed_for, error_of, reason_to_leave_out, simulated


class Comparison:
    """Errors and failures of many scenes."""

    def __init__(self, engines):
        self.worst = {engine: (0.0, 0.0, None) for engine in engines}  # Over what is allowed, error, scene.
        self.left_out = {}
        self.failures = 0
        self.compared = 0

    def fail(self, number, text):
        self.failures += 1
        print(f"FAILED scene {number}: {text}", flush=True)

    def add(self, number, folder):
        scene = random_scene(number)
        expecting = Model(scene)
        expected = expecting.samples()
        reason = reason_to_leave_out(expected)
        if reason:
            self.left_out[reason] = self.left_out.get(reason, 0) + 1
        self.compared += not reason
        for engine in self.worst:
            try:
                samples = simulated(scene, engine, folder)
            except RuntimeError as failure:
                self.fail(number, failure)
                continue
            if not reason:
                level = 0.0 if engine == "reference" else expecting.echo_level()
                self.judge(number, engine, error_of(samples, expected, level), allowed_for(expecting, engine))
            elif np.abs(samples).max(initial=0.0) > VANISHING_V:
                self.fail(number, f"{engine} has echoes, the model {reason}")

    def judge(self, number, engine, error, allowed):
        if not error / allowed <= self.worst[engine][0]:
            self.worst[engine] = (error / allowed, error, number)
        if not error <= allowed:
            kind = family(number) or "ordinary"
            self.fail(number, f"{engine} differs by {error:.2e} (allowed {allowed:.2e}; {kind})")

    def summary(self):
        left_out = "".join(f", {count} left out: {reason}" for reason, count in self.left_out.items())
        lines = [f"{self.compared} scenes compared{left_out}"]
        for engine, (share, error, number) in self.worst.items():
            lines.append(f"{engine}: largest error {error:.2e} in scene {number}, {share:.2f} of what is allowed")
        return "\n".join(lines)


def compare(first, count, engines):
    comparison = Comparison(engines)
    with tempfile.TemporaryDirectory(prefix="sarsim-independent-") as folder:
        for number in range(first, first + count):
            comparison.add(number, folder)
    print(comparison.summary())
    return 1 if comparison.failures or not comparison.compared else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", type=int, default=60, metavar="N", help="how many (60)")
    parser.add_argument("--first", type=int, default=1, metavar="S", help="number of the first scene (1)")
    parser.add_argument("--engines", nargs="+", choices=TOLERANCE, default=["reference", "auto"])
    parser.add_argument("--show", type=int, metavar="S", help="print the script of a scene and end")
    parser.add_argument("--self", action="store_true", help="try whether wrong models are found")
    arguments = parser.parse_args()
    if arguments.self:
        suites = [unittest.defaultTestLoader.loadTestsFromName(name) for name in ("wrong_models", "long_pulses")]
        return 0 if unittest.TextTestRunner().run(unittest.TestSuite(suites)).wasSuccessful() else 1
    if arguments.show is not None:
        print(scenes.script(random_scene(arguments.show)), end="")
        return 0
    return compare(arguments.first, arguments.scenes, arguments.engines)


if __name__ == "__main__":
    sys.exit(main())
