"""Compiles the C file of docs/guide/recipes/octave-library.md with mkoctfile, runs the page's Octave, and compares what it
prints with the page.

usage: octave_recipe_test.py PAGE HEADER_FOLDER LIBRARY EXAMPLES
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile


def fences(text, language):
    return re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)


def run(*words, **options):
    finished = subprocess.run(words, capture_output=True, text=True, check=False, **options)
    if finished.returncode:
        sys.exit(f"{words}\nstatus {finished.returncode}\n{finished.stdout}{finished.stderr}")
    return finished.stdout


def pattern_of(expected):
    return "".join(".*?" if part == "..." else re.escape(part) for part in re.split(r"(\.\.\.)", expected.rstrip("\n")))


def main():
    page, headers, library, examples = sys.argv[1:]
    octave = shutil.which("octave-cli") or shutil.which("octave")
    if octave is None or shutil.which("mkoctfile") is None:
        print("skipped: there is no octave or no mkoctfile (Debian: octave, octave-dev)")
        sys.exit(77)
    text = pathlib.Path(page).read_text()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "sarsim_image.c").write_text(fences(text, "c")[0])
        (folder / "page.m").write_text("warning('off', 'sarsim:remark');\n" + fences(text, "octave")[0])
        shutil.copytree(examples, folder / "examples")
        libraries = str(pathlib.Path(library).parent)
        run("mkoctfile", "--mex", "sarsim_image.c", f"-I{headers}", f"-L{libraries}", "-lsarsim", cwd=folder)
        environment = {**os.environ, "LD_LIBRARY_PATH": libraries}
        told = run(octave, "--no-gui", "--norc", "--quiet", "page.m", cwd=folder, env=environment)
        expected = fences(text, "text")[1]
        if not re.fullmatch(pattern_of(expected), told.rstrip("\n"), re.DOTALL):
            sys.exit(f"the page says\n{expected}\nOctave printed\n{told}")


main()
