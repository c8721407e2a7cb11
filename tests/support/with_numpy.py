"""To be imported before NumPy: goes on with Debian's Python where the present one has no NumPy, and ends with 77, skipped,
where that has none either."""

import os
import subprocess
import sys

DEBIAN = "/usr/bin/python3"

try:
    import numpy  # noqa: F401
except ImportError:
    known = sys.executable == DEBIAN or not os.path.exists(DEBIAN)
    if known or subprocess.run([DEBIAN, "-c", "import numpy"], capture_output=True, check=False).returncode != 0:
        print("skipped: no Python with NumPy")
        sys.exit(77)
    os.execv(DEBIAN, [DEBIAN, "-B", *sys.argv])
