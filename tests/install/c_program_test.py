"""Installs the library for C, moves it, and compiles and runs the program of docs/formats/c-interface.md with what
pkg-config says; then looks at what the library exports.

usage: c_program_test.py CMAKE BUILD_FOLDER COMPILER PKG_CONFIG [SANITIZE]
"""

import os
import pathlib
import re
import shlex
import sys
import tempfile

from installing import SOURCE, expect, install, run, skip


def main():
    cmake, build, compiler, pkg_config, *sanitize = sys.argv[1:]
    if not os.access(pkg_config, os.X_OK):
        skip("there is no pkg-config (Debian: pkg-config)")
    page = (SOURCE / "docs" / "formats" / "c-interface.md").read_text()
    program = next(text for text in re.findall(r"```c\n(.*?)```", page, re.DOTALL) if "int main(" in text)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        install(cmake, build, folder / "first", "library", "header")
        (folder / "first").rename(folder / "moved")
        library = folder / "moved" / "lib"
        environment = {**os.environ, "PKG_CONFIG_PATH": str(library / "pkgconfig"), "LD_LIBRARY_PATH": str(library)}
        told = run(pkg_config, "--cflags", "--libs", "sarsim", env=environment)
        expect(told.returncode == 0, "pkg-config does not know it", told)
        (folder / "record.c").write_text(program)
        flags = [f"-fsanitize={sanitize[0]}"] if sanitize and sanitize[0] else []
        compiled = run(compiler, "-std=c99", *flags, folder / "record.c", "-o", folder / "record", *shlex.split(told.stdout))
        expect(compiled.returncode == 0, "the program cannot be compiled", compiled)
        finished = run(folder / "record", SOURCE / "examples" / "sar_r.toml", folder / "own.h5", env=environment)
        expect(finished.returncode == 0 and "1240 pulses of 500 samples" in finished.stdout, "it does not run", finished)
        expect((folder / "own.h5").stat().st_size > 1e6, "it wrote no HDF5")

        version = run(pkg_config, "--modversion", "sarsim", env=environment).stdout.strip()
        expect(re.fullmatch(r"\d+\.\d+\.\d+", version), f"not a version: {version}")
        exports = SOURCE / "tests" / "c_interface" / "exports_test.py"
        judged = run(sys.executable, exports, folder / "moved" / "include" / "sarsim.h", library / "libsarsim.so.0")
        expect(judged.returncode in (0, 77), "the installed library exports something else", judged)


main()
