"""What tools/site and the link checker of tests/guide know about Markdown: how forges name headings, and plain texts."""

import re


def plain_text(inline):
    """The text of an inline token of markdown-it without its marks; pictures give their alternative texts."""
    parts = []
    for child in inline.children or []:
        if child.type in ("text", "code_inline"):
            parts.append(child.content)
        elif child.type in ("softbreak", "hardbreak"):
            parts.append(" ")
        elif child.type == "image":
            parts.append(child.content)
    return "".join(parts)


class AnchorNames:
    """The names of a page's headings, given one after the other: "Mouse and keys: a list" is mouse-and-keys-a-list."""

    def __init__(self):
        self.given = {}

    def name_of(self, heading):
        name = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        again = self.given.get(name, 0)
        self.given[name] = again + 1
        return f"{name}-{again}" if again else name
