"""Runs search_test.js over a built site, where there is something that runs scripts of browsers.

usage: search_test.py SITE       exit status: that of the script, 77 where Node is missing
"""

import os
import pathlib
import shutil
import sys

node = shutil.which("node") or shutil.which("nodejs")
if node is None:
    print("skipped: there is no node (Debian: nodejs; tools/install-deps compare)")
    sys.exit(77)
os.execv(node, [node, str(pathlib.Path(__file__).with_suffix(".js")), *sys.argv[1:]])
