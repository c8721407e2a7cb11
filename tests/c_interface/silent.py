"""Runs a test program in a folder of its own, which has to end with 0 and to print nothing: the library never does.

usage: silent.py PROGRAM EXAMPLES
"""

import subprocess
import sys
import tempfile

with tempfile.TemporaryDirectory() as folder:
    finished = subprocess.run(sys.argv[1:], capture_output=True, text=True, errors="replace", check=False, cwd=folder)
sys.stdout.write(finished.stdout + finished.stderr)
sys.exit(1 if finished.returncode or finished.stdout or finished.stderr else 0)
