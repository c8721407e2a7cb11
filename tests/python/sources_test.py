"""The declarations, the fields and the reference are those of the library; and a change of its header is noticed.

    sources_test.py LIBRARY
"""

import importlib.machinery
import importlib.util
import pathlib
import runpy
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))
import with_numpy  # noqa: E402, F401

TOOL = str(ROOT / "tools" / "python-sources")


def expect(made, *parts):
    for part in parts:
        if part not in made:
            sys.exit(f"{part!r} is not in what was made of the header:\n{made}")


loader = importlib.machinery.SourceFileLoader("python_sources", TOOL)
tool = importlib.util.module_from_spec(importlib.util.spec_from_loader("python_sources", loader))
loader.exec_module(tool)
header = """#define SARSIM_ABI_VERSION 7
enum { SARSIM_ONE = 0, /* a */ SARSIM_TWO = 1 };
typedef int (*sarsim_rows)(void* user, uint64_t first, const float* samples);
typedef struct sarsim_new { size_t struct_size; const char* name; double value; sarsim_rows rows; } sarsim_new;
SARSIM_API void sarsim_act(const sarsim_new* what, const char* name, uint64_t count,
                           sarsim_problems** problems);
SARSIM_API const char* sarsim_say(void);
"""
expect(
    tool.declarations(header),
    "ABI_VERSION = 7",
    "SARSIM_TWO = 1",
    "sarsim_rows = CFUNCTYPE(c_int, c_void_p, c_uint64, c_void_p)",
    '("struct_size", c_size_t),\n        ("name", c_char_p),\n        ("value", c_double),\n        ("rows", sarsim_rows),',
    '"sarsim_act": (None, (c_void_p, c_char_p, c_uint64, c_void_p)),',
    '"sarsim_say": (c_char_p, ()),',
)
declared = tool.declarations(tool.HEADER.read_text(encoding="utf-8"))
named = tool.HEADER.read_text(encoding="utf-8").count("\nSARSIM_API ")
if declared.count('    "sarsim_') != named:
    sys.exit(f"not every one of {named} functions of the header is declared")

sys.argv = [TOOL, "--check", sys.argv[1]]
runpy.run_path(TOOL, run_name="__main__")
