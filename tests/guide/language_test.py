#!/usr/bin/env python3
"""Every word and every field that the sources of the language name is in its diagrams.

The diagrams come from asking the program (tools/railway); this looks from the other side, so that nothing is missing
that the questions did not lead to.

usage: language_test.py PROJECT
"""

import html
import pathlib
import re
import sys

WORD = re.compile(r'\{\s*"([A-Z0-9_]+)",\s*[\w:]+')
FIELD = re.compile(r'inline constexpr Field (\w+)\{\s*"[^"]*",\s*"([^"]+)"')
BLOCK = re.compile(r'inline constexpr FunctionBlock \w+\{\s*"([^"]+)"')
# How a value is read; choices and blocks are in the diagrams by their words.
VALUE = re.compile(r"reader\.(?:number|integer|seed|text|leading_name|angle|angles|vector|decibels)\((?:\w+_)?grammar::(\w+)")


def without_breaks(source):
    return re.sub(r'"\s*\n\s*"', "", source)


def read(files):
    return "\n".join(without_breaks(file.read_text(encoding="utf-8")) for file in files)


def main():
    project = pathlib.Path(sys.argv[1])
    folder = project / "docs/formats"
    page = (folder / "script-diagrams.md").read_text(encoding="utf-8")
    pictures = html.unescape(" ".join(file.read_text(encoding="utf-8") for file in (folder / "diagrams").glob("*.svg")))
    schema = project / "src/scene/schema"
    grammar = read([schema / "scene_grammar.hpp", schema / "radar_grammar.hpp"])
    words = WORD.findall(grammar)
    blocks = BLOCK.findall(read([schema / "function_block.hpp"]))
    read_as_values = set(VALUE.findall(read((project / "src/scene/script").glob("read_*.cpp"))))
    values = [words_of_field for name, words_of_field in FIELD.findall(grammar) if name in read_as_values]
    wrong = [f"word {word}" for word in words if word not in page or f">{word}<" not in pictures]
    reference = (folder / "script.md").read_text(encoding="utf-8")
    wrong += [f"word {word} in script.md" for word in words if word not in reference]
    wrong += [f"block {block}" for block in blocks if block not in page or block not in pictures]
    wrong += [f"field {field}" for field in values if field not in page or field not in pictures]
    if len(words) < 50 or len(values) < 40 or len(blocks) != 14:
        wrong.append(
            f"only {len(words)} words, {len(values)} fields and {len(blocks)} blocks were found in the sources"
        )
    print(
        "\n".join(f"not in the diagrams: {text}" for text in wrong)
        or f"{len(words)} words, {len(values)} fields, {len(blocks)} blocks"
    )
    sys.exit(1 if wrong else 0)


main()
