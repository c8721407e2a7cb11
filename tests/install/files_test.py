"""Installs everything into a folder and looks at what is there.

usage: files_test.py CHECK CMAKE BUILD_FOLDER COMPONENT...

A check is one of the functions below. Exit status 77: a program that it needs is missing.
"""

import configparser
import gzip
import pathlib
import re
import shutil
import sys
import tempfile
import xml.etree.ElementTree

from installing import SOURCE, expect, install, run, skip

MIME = "{http://www.freedesktop.org/standards/shared-mime-info}"


def text_of(page):
    return gzip.open(page, "rt").read() if page.suffix == ".gz" else page.read_text()


def pages(prefix):
    return sorted((prefix / "share" / "man" / "man1").iterdir())


def everything(prefix, components):
    """Each component brings what belongs to it."""
    wanted = [
        "bin/sarsim",
        "lib/sarsim/sarsim_hdf5.so",
        "lib/sarsim/sarsim_drawing.so",
        "share/man/man1/sarsim.1*",
        "share/bash-completion/completions/sarsim",
        "share/zsh/vendor-completions/_sarsim",
        "share/fish/vendor_completions.d/sarsim.fish",
        *(f"share/sarsim/{path.relative_to(SOURCE)}" for path in (SOURCE / "examples").rglob("*") if path.is_file()),
        "share/doc/sarsim/README.md",
        "share/doc/sarsim/guide/commands.md",
        "share/doc/sarsim/copyright",
        "share/doc/sarsim/LICENSE",
        "lib/libsarsim.so.0",
        "lib/libsarsim.so",
        "lib/pkgconfig/sarsim.pc",
        "include/sarsim.h",
        "share/doc/libsarsim0/copyright",
        "share/doc/libsarsim-dev/copyright",
        "lib/python3/dist-packages/sarsim/__init__.py",
        "lib/python3/dist-packages/sarsim/py.typed",
        "share/doc/python3-sarsim/notebooks/01-first-echo.ipynb",
        "share/doc/python3-sarsim/copyright",
        "lib/libsarsim_simulate.a",
        "lib/libsarsim_picture.a",
        "lib/cmake/Sarsim/SarsimConfig.cmake",
        "include/sarsim/simulate/run/run.hpp",
        "include/sarsim/picture/figure/picture_file.hpp",
        "include/sarsim/core/build/version.hpp",
        "share/doc/sarsim-dev/copyright",
    ]
    if "workbench" in components:
        wanted += [
            "bin/sarsim-gui",
            "share/man/man1/sarsim-gui.1*",
            "share/applications/sarsim-gui.desktop",
            "share/mime/packages/sarsim.xml",
            "share/icons/hicolor/scalable/apps/sarsim-gui.svg",
            "share/icons/hicolor/48x48/apps/sarsim-gui.png",
            "share/icons/hicolor/scalable/mimetypes/text-x-sarsim-script.svg",
        ]
    if "mpi" in components:
        wanted += ["bin/sarsim-mpi", "share/man/man1/sarsim-mpi.1*"]
    missing = [name for name in wanted if not list(prefix.glob(name))]
    expect(not missing, f"not installed: {missing}")
    private = [path.name for path in prefix.rglob("*.hpp") if re.search(r"-inl|_test_|^hdf5_|^canvas", path.name)]
    expect(not private, f"private headers were installed: {private}")


def version(prefix, components):
    """All programs and manual pages state one version, alone on the first line."""
    programs = ["sarsim"] + (["sarsim-gui"] if "workbench" in components else [])
    numbers = set()
    for name in programs:
        told = run(prefix / "bin" / name, "--version")
        lines = told.stdout.splitlines()
        first = re.fullmatch(rf"{name} (\d+\.\d+\.\d+)", lines[0] if lines else "")
        expect(told.returncode == 0 and first, "the first line is not program and version", told)
        numbers.add(first.group(1))
        for words in ("Source: ", "Build: ", "SIMD: ", "Libraries: FFTW "):
            expect(any(line.startswith(words) for line in lines), f"no line '{words}'", told)
        expect(re.search(r"HDF5 \d+\.\d+\.\d+", told.stdout), "no version of HDF5", told)
        expect("CLI11 " in told.stdout, "no version of CLI11", told)
        expect(name != "sarsim-gui" or "Qt 6." in told.stdout, "no version of Qt", told)
    for page in pages(prefix):
        numbers |= set(re.findall(r'^\.TH .*"sarsim (.*?)"', text_of(page), re.MULTILINE))
    expect(len(numbers) == 1, f"different versions: {numbers}")


def completion(prefix, _components):
    """What is installed for a shell is what the program prints for it."""
    places = {
        "bash": "share/bash-completion/completions/sarsim",
        "zsh": "share/zsh/vendor-completions/_sarsim",
        "fish": "share/fish/vendor_completions.d/sarsim.fish",
    }
    for shell, place in places.items():
        printed = run(prefix / "bin" / "sarsim", "completion", shell)
        expect(printed.stdout == (prefix / place).read_text(), f"{place} is old", printed)


def manual_pages(prefix, components):
    """They are there, and that of the workbench names its options."""
    expect(pages(prefix), "there are none")
    if "workbench" in components:
        told = run(prefix / "bin" / "sarsim-gui", "--help")
        page = text_of(next((prefix / "share/man/man1").glob("sarsim-gui.1*"))).replace("\\-", "-")
        options = set(re.findall(r"--[a-z][a-z-]*", told.stdout))
        expect(len(options) > 5, "no options were found", told)
        expect(all(option in page for option in options), f"options are missing: {[o for o in options if o not in page]}")


def manual_pages_render(prefix, _components):
    """Pages render without a warning."""
    if shutil.which("man") is None:
        skip("there is no man (Debian: man-db)")
    for page in pages(prefix):
        rendered = run("man", "--warnings", "-l", "-Tutf8", page)
        expect(rendered.returncode == 0 and not rendered.stderr, f"{page.name} does not render", rendered)
        expect("@" not in rendered.stdout, f"{page.name} has a place that was not filled in")


def desktop(prefix, _components):
    """The entry starts an installed program, shows an installed icon and opens a type that is declared."""
    file = prefix / "share/applications/sarsim-gui.desktop"
    parser = configparser.ConfigParser(interpolation=None)
    parser.optionxform = str
    parser.read(file)
    entry = parser["Desktop Entry"]
    expect((prefix / "bin" / entry["Exec"].split()[0]).exists(), f"no such program: {entry['Exec']}")
    icons = prefix / "share/icons/hicolor"
    expect(list(icons.glob(f"*/apps/{entry['Icon']}.*")), f"no such icon: {entry['Icon']}")
    for icon in icons.rglob("*.svg"):
        xml.etree.ElementTree.parse(icon)
    root = xml.etree.ElementTree.parse(prefix / "share/mime/packages/sarsim.xml").getroot()
    types = [kind.get("type") for kind in root.iter(f"{MIME}mime-type")]
    expect(entry["MimeType"] == "".join(f"{kind};" for kind in types), f"{entry['MimeType']} is not {types}")
    for kind in root.iter(f"{MIME}icon"):
        expect(list(icons.glob(f"*/mimetypes/{kind.get('name')}.*")), f"no such icon: {kind.get('name')}")


def desktop_is_valid(prefix, _components):
    """The entry passes the validator of freedesktop.org."""
    file = prefix / "share/applications/sarsim-gui.desktop"
    if shutil.which("desktop-file-validate") is None:
        skip("there is no desktop-file-validate (Debian: desktop-file-utils)")
    judged = run("desktop-file-validate", file)
    expect(judged.returncode == 0 and not judged.stdout, "the entry is not valid", judged)


def mime(prefix, _components):
    """Examples are known as scripts by what stands in them."""
    root = xml.etree.ElementTree.parse(prefix / "share/mime/packages/sarsim.xml").getroot()
    magic = [match.get("value").replace("\\n", "\n").encode() for match in root.iter(f"{MIME}match")]
    for script in (SOURCE / "examples").glob("*.scr"):
        expect(any(words in script.read_bytes()[:4096] for words in magic), f"{script.name} has no word of the type")


def mime_is_valid(prefix, _components):
    """The type is taken by the database, for names of scripts."""
    if shutil.which("update-mime-database") is None:
        skip("there is no update-mime-database (Debian: shared-mime-info)")
    made = run("update-mime-database", prefix / "share" / "mime")
    expect(made.returncode == 0, "the type is not valid", made)
    globs = (prefix / "share/mime/globs2").read_text()
    expect("60:text/x-sarsim-script:*.scr" in globs, f"the type has no files:\n{globs}", made)


def main():
    check, cmake, build, *components = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        prefix = pathlib.Path(name) / "prefix"
        needed = components if check == "everything" else [c for c in components if c not in ("development", "header")]
        install(cmake, build, prefix, *needed)
        globals()[check](prefix, components)


main()
