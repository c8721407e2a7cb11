"""The trees that tools/railway finds, as a page with pictures and as texts."""

import os
import sys

try:
    import railroad
except ImportError:
    railroad = None
    # The system's Python may have what the first one on the path has not.
    SYSTEM = "/usr/bin/python3"
    if os.path.exists(SYSTEM) and os.path.realpath(SYSTEM) != os.path.realpath(sys.executable):
        os.execv(SYSTEM, [SYSTEM, *sys.argv])

STYLE = """
path { stroke-width: 1.5; stroke: #57606a; fill: none; }
text { font: 14px "DejaVu Sans Mono", monospace; text-anchor: middle; white-space: pre; fill: #1b1f24; }
rect { stroke-width: 1.5; stroke: #57606a; fill: #ffffff; }
rect.paper { stroke: none; fill: #ffffff; }
text.comment { font: italic 12px "DejaVu Sans", sans-serif; fill: #57606a; }
g.terminal rect { fill: #dbe9fb; stroke: #2f6fbf; }
g.terminal text { font-weight: bold; }
@media (prefers-color-scheme: dark) {
  path { stroke: #a0a9b3; }
  text { fill: #e3e6ea; }
  rect { stroke: #a0a9b3; fill: #20252b; }
  rect.paper { stroke: none; fill: #16191d; }
  text.comment { fill: #a0a9b3; }
  g.terminal rect { fill: #1d3a5c; stroke: #84b9ff; }
}
"""
# The same for light pages as attributes, for programs that do not read style sheets; a style sheet goes before them.
LINE = 'stroke-width="1.5" stroke="#57606a"'
ATTRIBUTES = [
    ("<path ", f'<path fill="none" {LINE} '),
    ("<rect ", f'<rect fill="#ffffff" {LINE} '),
    ("<text ", '<text text-anchor="middle" font-family="DejaVu Sans Mono, monospace" font-size="14" fill="#1b1f24" '),
]
WIDEST = 820  # Pixels of a row; longer ones are broken.

if railroad is not None:
    railroad.INTERNAL_ALIGNMENT = "left"

HEAD = """# The script language as diagrams

Follow the line from left to right; where it forks, any way may be taken. Round boxes are words of the language (three letters
are enough, five of a command), boxes with corners are values, with the unit in which they are written. Commas, blanks and line ends
separate values and mean nothing else. [The script language](script.md) says what the values mean and what their defaults are.

This page and its pictures are made by `tools/railway`, which asks the program what may come next; a test does it again and
compares. Below each picture is the same as text: `|` between alternatives, `[ ]` around what may be left out. The scripts in
[examples](../../examples) show the layout and the comments of `sarsim format`.
"""

BLOCK_TEXT = """## User-defined functions

Wherever a diagram has a *block*, one to three functions follow, each by points. Their number, axes and units are
[in a table](script.md#user-defined-functions).

![A block of functions](diagrams/block.svg)

```text
( CUBIC | MFILTER | LINEAR ) for each function
( INLINE ( number of points, then x, y of each ) for each function | FILE name )
```
"""


def label_of(node):
    """The words of a value, with its unit and range."""
    if node.kind == "block":
        count = len(node.functions)
        return f"block of {count} function{'s' if count > 1 else ''}: {node.words}"
    if node.kind == "name":
        return node.words
    unit, bounds = unit_and_range(node)
    notes = [text for text in (unit, bounds) if text]
    return node.words + (f" ({'; '.join(notes)})" if notes else "")


def unit_and_range(node):
    kind, _, bounds = node.expected.partition(", ")
    unit = kind.split(" in ")[1] if " in " in kind else ""
    if kind.startswith("a whole number"):
        bounds = ("whole, " + bounds) if bounds else "whole"
    return unit, bounds


def vectors_joined(items):
    """Three numbers x, y, z as one value."""
    out, at = [], 0
    while at < len(items):
        three = items[at : at + 3]
        if len(three) == 3 and all(not isinstance(item, tuple) and item.kind == "number" for item in three):
            stems = [item.words[:-2] for item in three]
            if len(set(stems)) == 1 and [item.words[-2:] for item in three] == [" x", " y", " z"]:
                unit, bounds = unit_and_range(three[0])
                notes = "; ".join(text for text in (unit, bounds) if text)
                out.append(("value", f"{stems[0]} x, y, z" + (f" ({notes})" if notes else "")))
                at += 3
                continue
        item = items[at]
        out.append(
            item
            if isinstance(item, tuple)
            else ("optional", [("value", label_of(item))])
            if item.optional
            else ("value", label_of(item))
        )
        at += 1
    return out


def plain(items):
    """A tree of tuples and texts alone: ("value", text), ("choice", [(words, items)]), ("optional", items), ("repeat", groups)."""
    out = []
    for item in vectors_joined(items):
        if item[0] == "value":
            out.append(item)
        elif item[0] == "optional":
            out.append(("optional", plain_inside(item[1])))
        elif item[0] == "repeat":
            out.append(("repeat", [(words, plain(way)) for words, way in item[1]]))
        else:
            out.append(("choice", [(words, plain(way)) for words, way in item[2]]))
    return out


def plain_inside(items):
    return [item for item in items] if items and isinstance(items[0], tuple) else plain(items)


def as_text(tree, indent=0):
    """The tree as lines."""
    pad, lines = "  " * indent, []
    for item in tree:
        if item[0] == "value":
            lines.append(pad + item[1])
        elif item[0] == "optional":
            lines.append(pad + "[ " + ", ".join(inner[1] for inner in item[1]) + " ]")
        else:
            groups = item[1]
            if all(not way for _, way in groups):
                lines.append(pad + " | ".join(word for words, _ in groups for word in words))
                continue
            for i, (words, way) in enumerate(groups):
                sign = ("( " if i == 0 else "| ") + (" | ".join(words) if words else "without the word:")
                lines.append(pad + sign)
                lines += as_text(way, indent + 2)
            lines.append(pad + (") once for each key, in any order" if item[0] == "repeat" else ")"))
    return lines


def drawn(item):
    if item[0] == "value":
        return railroad.NonTerminal(item[1])
    if item[0] == "optional":
        return railroad.Optional(railroad.Sequence(*[drawn(inner) for inner in item[1]]))
    ways = [drawn_way(words, way) for words, way in item[1]]
    choice = choice_of(ways)
    return railroad.OneOrMore(choice) if item[0] == "repeat" else choice


def choice_of(ways):
    """Ways below each other; the library forgets the height of the last one, where that has several rows."""
    choice = railroad.Choice(0, *ways)
    if len(ways) > 1:
        choice.down += choice.items[-1].height
    return choice


def drawn_way(words, way):
    first = [railroad.Terminal(words[0])] if len(words) == 1 else []
    if len(words) > 1:
        first = [railroad.Choice(0, *[railroad.Terminal(word) for word in words])]
    rows = rows_of(first + [drawn(item) for item in way])
    return rows[0] if len(rows) == 1 else railroad.Stack(*rows)


def width_of(item):
    return item.width + (20 if item.needsSpace else 0)


def rows_of(items):
    """Sequences that are not too wide."""
    rows, row, width = [], [], 0
    for item in items:
        if row and width + width_of(item) > WIDEST:
            rows.append(railroad.Sequence(*row))
            row, width = [], 0
        row.append(item)
        width += width_of(item)
    if row:
        rows.append(railroad.Sequence(*row))
    return rows or [railroad.Skip()]


def picture(items):
    """A diagram as SVG that fits light and dark pages."""
    if railroad is None:
        return None
    rows = rows_of(items)
    diagram = railroad.Diagram(rows[0] if len(rows) == 1 else railroad.Stack(*rows), css=STYLE)
    diagram.attrs["xmlns"] = "http://www.w3.org/2000/svg"
    parts = []
    diagram.writeSvg(parts.append)
    text = "".join(parts).rstrip() + "\n"
    for plain_start, start in ATTRIBUTES:
        text = text.replace(plain_start, start)
    size = f'width="{diagram.attrs["width"]}" height="{diagram.attrs["height"]}"'
    return text.replace("</style>", f'</style><rect class="paper" fill="#ffffff" {size}/>', 1)


def block_picture():
    if railroad is None:
        return None
    terminal, value = railroad.Terminal, railroad.NonTerminal
    kinds = railroad.OneOrMore(
        railroad.Choice(0, terminal("CUBIC"), terminal("MFILTER"), terminal("LINEAR")),
        railroad.Comment("for each function"),
    )
    points = railroad.OneOrMore(
        railroad.Sequence(value("number of points"), railroad.ZeroOrMore(railroad.Sequence(value("x"), value("y")))),
        railroad.Comment("for each function"),
    )
    source = railroad.Choice(
        0,
        railroad.Sequence(terminal("INLINE"), points),
        railroad.Sequence(terminal("FILE"), value("name of a data file")),
    )
    return picture([kinds, source])


def page_and_pictures(commands):
    """The files of docs/formats, by their names; pictures are None where they cannot be drawn."""
    text, files = HEAD, {}
    for word, items in commands.items():
        tree = plain(items)
        lines = "\n".join(as_text(tree))
        text += f"\n## ${word}\n\n![${word}](diagrams/{word.lower()}.svg)\n\n```text\n${word}\n{lines}\n```\n"
        drawn_items = [] if railroad is None else [railroad.Terminal("$" + word), *[drawn(item) for item in tree]]
        files[f"diagrams/{word.lower()}.svg"] = picture(drawn_items)
    files["diagrams/block.svg"] = block_picture()
    return {"script-diagrams.md": text + "\n" + BLOCK_TEXT, **files}
