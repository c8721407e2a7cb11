#!/usr/bin/env python3
"""Makes the tables of docs/guide/bad-input.md from the records of what sarsim says to bad input.

    tests/bad_input/page.py [--check]     compares instead; exit status 1 where page and records disagree

The records in said/ have each bad input with its message, word for word; make_table.py, mistakes.py and mistakes_format_2.py
compare them with the program. The page has a row for each kind of message that docs/guide/troubleshooting.md does not explain:
what is wrong, and the message without its place, what was found and what was expected.
"""

import pathlib
import re
import sys

SAID = pathlib.Path(__file__).resolve().parent / "said"
GUIDE = pathlib.Path(__file__).resolve().parents[2] / "docs/guide/bad-input.md"
TROUBLESHOOTING = GUIDE.with_name("troubleshooting.md")
BEGIN, END = "<!-- made by tests/bad_input/page.py -->", "<!-- end of the tables -->"
HEAD = ["| what is wrong | message |", "|---|---|"]
SHORTEST = 12  # Shorter quotes fit too much.
SEVERITY = re.compile(r"^(?:[^\s:]+(?::\d+:\d+)?: )?(?:sarsim: )?(error|warning|note): ")
DETAILS = re.compile(r"; found '|[,;] expected ")

# Each record: its title on the page, and the columns of what is wrong and of what is said.
RECORDS = [
    ("format_2.txt", "Scenes in format 2", 2, 4),
    ("likely_mistakes.txt", "Likely mistakes in scripts of 1998", 1, 4),
    ("cases.txt", "Scripts of 1998, commands and files", 0, 3),
]


def rows(text):
    """(theme, cells) of each row of a record's tables; their heads are left out."""
    theme = ""
    lines = text.splitlines()
    for line, below in zip(lines, [*lines[1:], ""]):
        if line.startswith("## "):
            theme = line[3:]
        elif line.startswith("| ") and not below.startswith("|---"):
            yield theme, [cell.strip() for cell in re.split(r"(?<!\\) \| ", line[2:].removesuffix(" |"))]


def message(cell):
    """A message without place, severity, findings and hint; warnings and notes keep their mark."""
    first = cell.split("<br>")[0].strip("`").strip()
    severity = SEVERITY.match(first)
    text = DETAILS.split(first[severity.end() :] if severity else first)[0]
    return text if severity is None or severity[1] == "error" else f"{severity[1]}: {text}"


def shape(text):
    """What messages of one kind have in common: neither names nor numbers nor the field that they are about."""
    text = re.sub(r"'[^']*'", "''", text)
    text = re.sub(r"\S*[./]\S+[\w/]", "FILE", text)
    text = re.sub(r"-?\d[\d.e+-]*", "0", text)
    text = re.sub(r"^(warning: )?.*?(?=(?:is|are|has|needs|takes|ends|belongs|was|were) )", r"\1", text)
    return re.sub(r"(?<=is a )\w+; the field takes .*|(?<=ends before ).*", "", text)


def explained():
    """A pattern that fits the messages of the page that explains them."""
    patterns, in_table = [], False
    for line in TROUBLESHOOTING.read_text(encoding="utf-8").splitlines():
        in_table = line.startswith("|") and (in_table or line.startswith("| Message |"))
        for quote in re.findall(r"`([^`]+)`", line.split(" | ")[0]) if in_table else []:
            parts = [re.escape(part.strip()) for part in quote.split("...") if part.strip()]
            if len("".join(parts)) >= SHORTEST:
                patterns.append(".*".join(parts))
    return re.compile("|".join(patterns))


def as_cell(text):
    ticks = "``" if "`" in text else "`"
    return f"{ticks}{text}{ticks}"


def tables():
    lines, seen, inputs, known = [], set(), 0, explained()
    for name, title, wrong, said in RECORDS:
        lines += ["", f"## {title}"]
        last = None
        for theme, cells in rows((SAID / name).read_text(encoding="utf-8")):
            if theme == "Numbers in scripts":  # Counts of fields, not bad inputs.
                inputs += int(cells[2])
                continue
            inputs += 1
            text = message(cells[said])
            if text == "nothing" or shape(text) in seen:
                continue
            seen.add(shape(text))
            if known.search(text):
                continue
            if theme != last:
                lines += ["", *([f"### {theme}", ""] if theme else []), *HEAD]
            last = theme
            lines.append(f"| {cells[wrong].removesuffix('.')} | {as_cell(text)} |")
    return ["", f"The tests try {inputs} bad inputs and get {len(seen)} kinds of messages.", *lines, "", ""]


def parts():
    before, rest = GUIDE.read_text(encoding="utf-8").split(BEGIN)
    old, after = rest.split(END)
    return before + BEGIN, old, END + after


def write():
    before, _, after = parts()
    GUIDE.write_text(before + "\n".join(tables()) + after, encoding="utf-8")


def main():
    if "--check" not in sys.argv[1:]:
        write()
        return 0
    if "\n".join(tables()) == parts()[1]:
        return 0
    print(f"{GUIDE.name} is not made of the records; tests/bad_input/page.py writes it anew")
    return 1


if __name__ == "__main__":
    sys.exit(main())
