"""Whether an example does what it says: it is right, runs whole, keeps its meaning when it is formatted, its commands work.

usage: run_example.py SARSIM SCRIPT

Works in a folder of its own. Prints what is wrong and ends with status 1 where something is.
"""

import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "guide" / "gallery.md"
EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"
LONGEST_S = 200  # of a command: far more than any needs
READ_ONLY = ("check", "info", "measure")  # commands that write no file, and so know no --force


class Sarsim:
    """Runs sarsim in a folder."""

    def __init__(self, program, folder):
        self.program = pathlib.Path(program)
        self.folder = pathlib.Path(folder)

    def __call__(self, *words):
        """Status, standard output and error of a command."""
        # The speed of the machine, which takes 0.2 s to measure, is kept from one test to the next.
        cache = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
        environment = dict(os.environ, HOME=str(self.folder), XDG_RUNTIME_DIR=str(self.folder), XDG_CACHE_HOME=cache,
                           QT_LOGGING_RULES="*=false")
        return subprocess.run(
            [self.program, *words],
            cwd=self.folder,
            env=environment,
            capture_output=True,
            text=True,
            timeout=LONGEST_S,
            check=False,
        )


# ---- What a script says of itself -----------------------------------------------------------------------------------


def heading(text):
    """The comment that a scene of either language begins with, without its marks ("!" or "#")."""
    lines = []
    for line in text.splitlines():
        if not line.startswith(("!", "#")):
            break
        lines.append(line[1:])
    return lines


def quotations(text):
    """Commands ("sarsim ...") and options ("--...") that the heading quotes or has in lines of their own, in order."""
    found = []
    flowing = []
    for line in heading(text):
        if line.startswith("     sarsim "):
            found += quoted(" ".join(flowing)) + [line.strip()]
            flowing = []
        else:
            flowing.append(line.strip())
    return found + quoted(" ".join(flowing))


def quoted(text):
    return [" ".join(words.split()) for words in re.findall(r'"((?:sarsim |--)[^"]*)"', text)]


def product_count(text):
    """Recordings and geometry tables that a scene of either language asks for."""
    if re.search(r"^format\s*=", text, re.MULTILINE):
        return len(re.findall(r"^\[\[(?:recording|geometry)\]\]", text, re.MULTILINE))
    bare = re.sub(r"!.*", "", text)
    return len(re.findall(r"\$\s*(?:SIMUL|GEOME)", bare, re.IGNORECASE))


def data_files(text):
    """Files beside the examples that a scene of format 2 reads."""
    named = re.findall(r'\bfile = "([^"]+)"', text)
    return [path for path in (EXAMPLES / name for name in named) if path.is_file()]


# ---- What it has to do ----------------------------------------------------------------------------------------------


def failed(what, done):
    return [f"{what} ended with status {done.returncode}\n{done.stdout}{done.stderr}"]


def complaints_about_check(sarsim, name):
    done = sarsim("check", name)
    return [] if done.returncode == 0 else failed(f"sarsim check {name}", done)


def run(sarsim, name, folder, *options):
    """Products of a run of a whole script into a folder, and complaints."""
    done = sarsim("run", name, "--out", folder, "--json", "--quiet", *options)
    if done.returncode != 0:
        return [], failed(f"sarsim run {name}", done)
    return json.loads(done.stdout)["products"], []


def complaints_about_products(sarsim, products, wanted):
    """Each product has to be there, and a recording has to have something in it."""
    complaints = []
    if len(products) != wanted:
        complaints.append(f"{wanted} products are asked for, {len(products)} were made")
    for product in products:
        path = sarsim.folder / product["file"]
        if not path.is_file() or path.stat().st_size == 0:
            complaints.append(f"{path.name} is missing or empty")
        elif product["kind"] == "recording" and not product["maximum_v"] > 0.0:
            complaints.append(f"{path.name} has nothing but zeros")
    return complaints


def values(sarsim, path):
    """The samples of a recording as bytes, without what else its file says."""
    if path.suffix != ".h5":
        return path.read_bytes()
    table = path.with_suffix(".samples.npy")
    done = sarsim("convert", str(path), str(table))
    if done.returncode != 0:
        raise RuntimeError(failed(f"sarsim convert {path.name}", done)[0])
    return table.read_bytes()


def complaints_about_format(sarsim, name, products):
    """The formatted script has to give the same fields, and the same samples bit for bit."""
    formatted = "formatted" + pathlib.Path(name).suffix
    done = sarsim("format", name, "-o", formatted)
    if done.returncode != 0:
        return failed(f"sarsim format {name}", done)
    fields = [sarsim("sweep", script, "--fields").stdout for script in (name, formatted)]
    if fields[0] != fields[1] or not fields[0]:
        return [f"sarsim format {name} changes fields\n{fields[0]}\nbecomes\n{fields[1]}"]
    again, complaints = run(sarsim, formatted, "again")
    if complaints:
        return complaints
    for first, second in zip(products, again):
        if values(sarsim, sarsim.folder / first["file"]) != values(sarsim, sarsim.folder / second["file"]):
            complaints.append(f"{first['file']} differs once the script is formatted")
    return complaints


def runnable(command, name):
    """The words after sarsim; of a command alone with the script; files of earlier commands may be replaced."""
    words = shlex.split(command)[1:]
    if len(words) == 1:
        words.append(name)
    return words if words[0] in READ_ONLY else [*words, "--force"]


def complaints_about_commands(sarsim, name, quotes):
    """Each command of the heading has to work; each option belongs to the command before it."""
    complaints = []
    known = ""
    for quote in quotes:
        if quote.startswith("--"):
            option = quote.split()[0]
            if not re.search(rf"(?<![\w-]){re.escape(option)}(?![\w-])", known):
                complaints.append(f'"{quote}" is no option of the command before it')
            continue
        words = runnable(quote, name)
        known = sarsim(words[0], "--help").stdout
        done = sarsim(*words)
        if done.returncode != 0:
            complaints += failed(f'"{quote}"', done)
    return complaints


def complaints_about_page(name, page):
    """The page names an example in either language."""
    stem = name.rpartition(".")[0]
    named = any(f"(../../examples/{stem}.{ending})" in page for ending in ("toml", "scr"))
    return [] if named else [f"the gallery does not name {name}"]


def complaints_about(program, script):
    text = script.read_text(encoding="utf-8")
    quotes = quotations(text)
    with tempfile.TemporaryDirectory() as folder:
        sarsim = Sarsim(program, folder)
        for path in (script, *data_files(text)):
            shutil.copy(path, folder)
        complaints = complaints_about_check(sarsim, script.name)
        if complaints:
            return complaints
        products, complaints = run(sarsim, script.name, "first")
        complaints += complaints_about_products(sarsim, products, product_count(text))
        if not complaints:
            complaints += complaints_about_format(sarsim, script.name, products)
        complaints += complaints_about_commands(sarsim, script.name, quotes)
    return complaints + complaints_about_page(script.name, PAGE.read_text(encoding="utf-8"))


def main():
    program, script = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    complaints = complaints_about(program, script)
    for complaint in complaints:
        print(f"{script.name}: {complaint}")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
