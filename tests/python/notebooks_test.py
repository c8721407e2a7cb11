"""Runs the notebooks of a folder as a reader would, each in an empty folder of its own, cell after cell.

    notebooks_test.py FOLDER

No cell may fail, no output may be stored. The environment has SARSIM_LIBRARY and PYTHONPATH; SARSIM_TEST_PYTHON may name a Python
that has matplotlib.
"""

import ast
import json
import os
import pathlib
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import more_python  # noqa: E402

more_python.prefer("matplotlib")
import with_numpy  # noqa: E402, F401

LESSONS = 10


def source(cell):
    return "".join(cell["source"])


def shown(value):
    """Asks for everything that a notebook would show of a value."""
    for name in ("_repr_html_", "_repr_png_"):
        if hasattr(value, name) and not isinstance(value, type):
            assert getattr(value, name)(), f"{name} gives nothing"
    return repr(value)


def execute(text, names, place):
    """Runs a cell; shows its last value as a notebook does, unless a semicolon follows it."""
    tree = ast.parse(text, place)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, place, "exec"), names)
    if last is not None:
        value = eval(compile(ast.Expression(last.value), place, "eval"), names)
        if value is not None and not text.rstrip().endswith(";"):
            print(shown(value)[:200])


def run(path):
    notebook = json.loads(path.read_text(encoding="utf-8"))
    cells = notebook["cells"]
    assert notebook["nbformat"] == 4 and source(cells[0]).startswith("# "), f"{path.name}: no title"
    names = {"__name__": "__main__"}
    for number, cell in enumerate(cells, 1):
        if cell["cell_type"] != "code":
            continue
        assert cell["outputs"] == [] and cell["execution_count"] is None, f"{path.name}, cell {number}: has outputs"
        execute(source(cell), names, f"{path.name}, cell {number}")


def main():
    os.environ.setdefault("MPLBACKEND", "Agg")
    paths = sorted(pathlib.Path(sys.argv[1]).resolve().glob("*.ipynb"))
    assert len(paths) == LESSONS, f"{len(paths)} notebooks"
    for path in paths:
        begun = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            print(f"== {path.name}", flush=True)
            run(path)
            os.chdir("/")
        print(f"{path.name}: {time.monotonic() - begun:.2f} s", flush=True)
        if "matplotlib.pyplot" in sys.modules:
            sys.modules["matplotlib.pyplot"].close("all")


if __name__ == "__main__":
    main()
