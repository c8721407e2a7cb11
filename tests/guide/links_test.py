#!/usr/bin/env python3
"""Every link of the documentation leads somewhere, in the Markdown and in the site made of it.

usage: links_test.py PROJECT [SITE]    checks README.md, CONTRIBUTING.md, CHANGELOG.md and docs/; SITE is where the site is
                                       built, a temporary folder otherwise
       links_test.py --self            whether the checkers find what they look for
"""

import html.parser
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

HERE = pathlib.Path(__file__).resolve().parent
TOOLS = HERE.parents[1] / "tools"
sys.path.insert(0, str(TOOLS))

try:
    from markdown_it import MarkdownIt
except ImportError:
    SYSTEM = "/usr/bin/python3"
    if os.path.exists(SYSTEM) and os.path.realpath(SYSTEM) != os.path.realpath(sys.executable):
        os.execv(SYSTEM, [SYSTEM, *sys.argv])
    print("skipped: Python has no markdown_it (tools/install-deps site)")
    sys.exit(77)

import markdown_links  # noqa: E402


class Attributes(html.parser.HTMLParser):
    """Links, pictures, scripts and names of a text in HTML."""

    def __init__(self, text):
        super().__init__()
        self.links, self.loaded, self.names = [], [], set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        if "id" in values:
            self.names.add(values["id"])
        if values.get("href"):
            (self.loaded if tag == "link" else self.links).append(values["href"])
        if values.get("src"):
            self.loaded.append(values["src"])


class MarkdownPage:
    """The links of a page and the names of its headings."""

    def __init__(self, file):
        self.links, self.anchors = [], set()
        tokens = MarkdownIt("commonmark", {"html": True}).enable("table").parse(file.read_text(encoding="utf-8"))
        names = markdown_links.AnchorNames()
        for i, token in enumerate(tokens):
            if token.type == "heading_open":
                self.anchors.add(names.name_of(markdown_links.plain_text(tokens[i + 1])))
            for part in [token, *(token.children or [])]:
                self.links += [value for value in (part.attrGet("href"), part.attrGet("src")) if value]
                if part.type in ("html_block", "html_inline"):
                    attributes = Attributes(part.content)
                    self.links += attributes.links + attributes.loaded


def is_outside(target):
    return bool(urllib.parse.urlsplit(target).scheme)


def wrong_links(files):
    """One line for each link of Markdown files that leads nowhere."""
    pages = {}

    def page(file):
        if file not in pages:
            pages[file] = MarkdownPage(file)
        return pages[file]

    wrong = []
    for file in files:
        for target in page(file).links:
            if is_outside(target):
                continue
            parts = urllib.parse.urlsplit(target)
            goal = (file.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else file
            if not goal.exists():
                wrong.append(f"{file}: {target} does not exist")
            elif parts.fragment and (goal.suffix != ".md" or parts.fragment not in page(goal).anchors):
                wrong.append(f"{file}: {target}: no such heading")
    return wrong


def wrong_in_site(site):
    """One line for each link of a site that leads nowhere, and for each file that is loaded from outside."""
    pages = {file.resolve(): Attributes(file.read_text(encoding="utf-8")) for file in site.rglob("*.html")}
    wrong = []
    for file, page in pages.items():
        wrong += [f"{file}: loads {target} from outside" for target in page.loaded if is_outside(target)]
        for target in page.links + page.loaded:
            if is_outside(target):
                continue
            parts = urllib.parse.urlsplit(target)
            goal = (file.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else file
            if not goal.is_file():
                wrong.append(f"{file}: {target} is no file")
            elif parts.fragment and parts.fragment not in pages[goal].names:
                wrong.append(f"{file}: {target}: no such place")
    return wrong


class Checkers(unittest.TestCase):
    def in_folder(self, files, check):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name).resolve()
            for place, text in files.items():
                (folder / place).parent.mkdir(parents=True, exist_ok=True)
                (folder / place).write_text(text, encoding="utf-8")
            return [line.replace(f"{folder}/", "") for line in check(folder)]

    def markdown(self, files):
        return self.in_folder(files, lambda folder: wrong_links(sorted(folder.rglob("*.md"))))

    def site(self, files):
        return self.in_folder(files, wrong_in_site)

    def test_sound_links_pass(self):
        text = "# A: b, `c`\n[x](#a-b-c) [y](sub/two.md#two) [z](sub) <https://example.org> ![p](sub/p.png)\n"
        self.assertEqual(self.markdown({"one.md": text, "sub/two.md": "# Two\n", "sub/p.png": ""}), [])

    def test_missing_files_pictures_and_headings_are_found(self):
        found = self.markdown({"one.md": '# A\n[x](two.md) ![y](p.png) [z](#b)\n\n<img src="q.png">\n'})
        self.assertEqual(
            found,
            [
                "one.md: two.md does not exist",
                "one.md: p.png does not exist",
                "one.md: #b: no such heading",
                "one.md: q.png does not exist",
            ],
        )

    def test_links_in_code_are_none(self):
        self.assertEqual(self.markdown({"one.md": "`[x](y)`\n\n    [x](y)\n\n```\n[x](y)\n```\n"}), [])

    def test_the_second_heading_of_a_name_is_numbered(self):
        self.assertEqual(
            self.markdown({"one.md": "# A\n# A\n[x](#a-1) [y](#a-2)\n"}), ["one.md: #a-2: no such heading"]
        )

    def test_what_a_page_of_the_site_loads_is_beside_it(self):
        page = '<link rel="stylesheet" href="s.css"><script src="https://example.org/x.js"></script><a href="#n">n</a>'
        self.assertEqual(
            self.site({"a.html": page}),
            [
                "a.html: loads https://example.org/x.js from outside",
                "a.html: #n: no such place",
                "a.html: s.css is no file",
            ],
        )


def check(project, site):
    files = [project / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    files += sorted((project / "docs").rglob("*.md"))
    wrong = wrong_links(files)
    build = subprocess.run([sys.executable, TOOLS / "site", site], capture_output=True, text=True, check=False)
    if build.returncode != 0:
        wrong.append(f"tools/site failed: {build.stdout}{build.stderr}")
    else:
        wrong += wrong_in_site(site)
    print("\n".join(wrong) if wrong else f"{len(files)} pages: every link leads somewhere")
    return 1 if wrong else 0


def main():
    if sys.argv[1:] == ["--self"]:
        unittest.main(argv=sys.argv[:1])
    project = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        sys.exit(check(project, pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else folder + "/site")))


main()
