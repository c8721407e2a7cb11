"""Compiles the programs of docs/formats/c-interface.md as C99 and runs them; the file of the first is that of `sarsim run`.

usage: doc_example_test.py PAGE HEADER_FOLDER LIBRARY COMPILER SARSIM SCENE [FLAG...]
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile


def run(*words, **options):
    finished = subprocess.run(words, capture_output=True, text=True, check=False, **options)
    if finished.returncode:
        sys.exit(f"{words}\nstatus {finished.returncode}\n{finished.stdout}{finished.stderr}")
    return finished


def main():
    page, headers, library, compiler, sarsim, scene, *flags = sys.argv[1:]
    programs = re.findall(r"```c\n(.*?)```", pathlib.Path(page).read_text(), re.DOTALL)
    if len(programs) != 2:
        sys.exit(f"{len(programs)} programs on the page")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "record.c").write_text(programs[0])
        (folder / "image.c").write_text(programs[1])
        strict = ("-std=c99", "-Wall", "-Wextra", "-Wno-missing-field-initializers", "-Wpedantic", "-Werror")
        for program in ("record", "image"):
            run(compiler, *strict, *flags, f"-I{headers}", folder / f"{program}.c", library, "-o", folder / program)
        environment = {**os.environ, "LD_LIBRARY_PATH": str(pathlib.Path(library).parent)}
        told = run(folder / "record", scene, folder / "own.h5", env=environment).stdout
        if not re.search(r"Radar1: 1240 pulses of 500 samples\n100 % done\nstrongest sample: .* W at .* s, 10\d\d\d\.\d m", told):
            sys.exit(f"it says something else:\n{told}")
        run(sarsim, "run", scene, "--quiet", "--set", "Radar1.power=2 kW", "--out", folder / "run")
        if (folder / "own.h5").read_bytes() != (folder / "run" / "sar_r.h5").read_bytes():
            sys.exit("the file differs from that of sarsim run")
        told = run(folder / "image", env=environment).stdout
        errors = [float(number) for number in re.findall(r"^target [123]: azimuth_error_m = (.*)$", told, re.MULTILINE)]
        if len(errors) != 3 or max(map(abs, errors)) > 0.01:
            sys.exit(f"the second one says\n{told}")


main()
