"""The library exports what its header names, and nothing else; and needs no library of the command line or of windows.

usage: exports_test.py HEADER LIBRARY
"""

import pathlib
import re
import shutil
import subprocess
import sys

if shutil.which("nm") is None:
    print("skipped: there is no nm (Debian: binutils)")
    sys.exit(77)

header, library = sys.argv[1:]
text = re.sub(r"/\*.*?\*/", "", pathlib.Path(header).read_text(), flags=re.DOTALL)
named = set(re.findall(r"^SARSIM_API[^;]*?\b(sarsim_\w+)\s*\(", text, re.MULTILINE))
listed = subprocess.run(["nm", "-D", "--defined-only", library], capture_output=True, text=True, check=True).stdout
symbols = [words[-1] for words in map(str.split, listed.splitlines()) if words[1] != "A"]
exported = {symbol.split("@")[0] for symbol in symbols}
versions = {symbol.split("@")[-1] for symbol in symbols}
if len(named) < 20:
    sys.exit(f"the header names {len(named)} functions only: it was not understood")
if exported != named:
    sys.exit(f"not exported: {sorted(named - exported)}\nnot in the header: {sorted(exported - named)}")
if versions != {"SARSIM_0"}:
    sys.exit(f"versions {sorted(versions)} instead of SARSIM_0")

dynamic = subprocess.run(["readelf", "-d", library], capture_output=True, text=True, check=True).stdout
soname = re.search(r"SONAME.*\[(.*)\]", dynamic)
if soname is None or soname.group(1) != "libsarsim.so.0":
    sys.exit(f"the library is not called libsarsim.so.0:\n{dynamic}")
needed = re.findall(r"NEEDED.*\[(.*)\]", dynamic)
if wrong := [name for name in needed if re.search("Qt|hdf5|cairo|pango|mpi|CLI", name, re.IGNORECASE)]:
    sys.exit(f"the library needs {wrong}")
