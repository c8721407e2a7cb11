#!/usr/bin/env python3
"""What the guide quotes of the program is what the program says: messages, windows, and the tests that guard formulas.

usage: quotes_test.py PROJECT      checks docs/guide/troubleshooting.md, docs/guide/windows.md, docs/guide/physics.md
       quotes_test.py --self       whether the checkers find what they look for
"""

import pathlib
import re
import sys
import unittest

STRING = r'"((?:[^"\\]|\\.)*)"'
# Files whose messages users meet; each message in them has to be in the guide.
EXPLAINED = [
    "raster/cphd/cphd_file.cpp",
    "raster/table/raster_gate.cpp",
    "scene/check/check_findings.cpp",
    "scene/check/check_function_ends.cpp",
    "scene/check/check_names.cpp",
    "scene/check/check_platform.cpp",
    "scene/check/check_plausible.cpp",
    "scene/check/check_radar.cpp",
    "scene/check/check_recording.cpp",
    "scene/check/check_target.cpp",
    "scene/script/data_file.cpp",
    "scene/script/field_reader.cpp",
    "scene/script/problem_log.cpp",
    "scene/script/read_options.cpp",
    "simulate/resolve/impossible_echo.cpp",
    "simulate/survey/limit_rules.cpp",
    "simulate/survey/survey.cpp",
    "simulate/survey/table_rules.cpp",
    "workflow/focus/method_choice.cpp",
    "workflow/focus/motion_residual.cpp",
    "workflow/focus/navigation_check.cpp",
    "workflow/focus/azimuth_ambiguities.cpp",
    "workflow/input/motion_accuracy.cpp",
    "workflow/input/output_names.cpp",
    "workflow/search/search_checks.cpp",
    "workflow/stepped/isar_scene.cpp",
    "workflow/stepped/stepped_remarks.cpp",
]
# Where a message stands in the sources, behind the rule that it is of.
RULE = r"(?:\"[a-z-]+\.[a-z-]+\",\s*)?"
MESSAGE = [
    r"\.message\s*=\s*(?:fmt::format\(\s*)?" + STRING,
    r"core::(?:error|warning)\(\s*" + RULE + r"(?:fmt::format\(\s*)?" + STRING,
    r"Severity::(?:warning|error),\s*" + RULE + r"(?:fmt::format\(\s*)?" + STRING,
    r"(?:reporter_\.|reader\.)?(?:error|warning|structural_error|pass_over)\([^;\"{]*\{\s*(?:fmt::format\(\s*)?"
    + STRING,
]
SHORTEST = 18  # Shorter ones are parts of sentences.


def joined(source):
    """C++ with strings that stand beside each other made one."""
    return re.sub(r'"\s*\n\s*"', "", source)


def shape(text):
    """A message with all that varies as one sign: {} in sources, ... on pages."""
    text = re.sub(r"\{[^{}]*\}|\.\.\.", "\0", text.replace('\\"', '"'))
    return re.sub(r"\s+", " ", re.sub(r"\0+", "\0", text)).strip()


def strings_of(source):
    return [shape(text) for text in re.findall(STRING, joined(source)) if len(text) >= 6]


def messages_of(source):
    found = []
    for pattern in MESSAGE:
        found += re.findall(pattern, joined(source))
    rule = re.compile(r"[a-z-]+\.[a-z-]+")
    return [shape(text) for text in dict.fromkeys(found) if len(text) >= SHORTEST and not rule.fullmatch(text)]


def quotes_of(page):
    """The messages of a page: what is in code marks in the first column of tables headed Message."""
    quotes, in_table = [], False
    for line in page.splitlines():
        if line.startswith("| Message |"):
            in_table = True
        elif not line.startswith("|"):
            in_table = False
        elif in_table and not line.startswith("|---"):
            quotes += re.findall(r"`([^`]+)`", line.split(" | ")[0])
    return quotes


def wrong_quotes(page, strings):
    """Quotes of the page that no string of the sources holds."""
    everything = "\n".join(strings)
    return [quote for quote in quotes_of(page) if shape(quote).strip("\0 ") not in everything]


def unexplained(page, messages):
    """Messages that no quote of the page stands for."""
    quotes = [shape(quote).strip("\0 ") for quote in quotes_of(page)]
    return [m.replace("\0", "...") for m in messages if not any(q in m or m.strip("\0 ") in q for q in quotes)]


def missing_guards(page, tests):
    """Names of tests on a page, as Suite.Name or Suite.*, that do not exist."""
    named = re.findall(r"`([A-Z]\w+\.(?:[A-Z]\w+|\*))`", page)
    suites = {name.split(".")[0] for name in tests}
    return [name for name in named if name not in tests and not (name.endswith(".*") and name[:-2] in suites)]


def tests_of(source):
    return {f"{suite}.{name}" for suite, name in re.findall(r"^TEST(?:_[FP])?\((\w+),\s*(\w+)\)", source, re.MULTILINE)}


class Checkers(unittest.TestCase):
    PAGE = "| Message | Why |\n|---|---|\n| `no ... has this name`, `too few` | `code` |\n\n| Other |\n| `not looked at` |\n"

    def test_quotes_are_read_from_tables_of_messages(self):
        self.assertEqual(quotes_of(self.PAGE), ["no ... has this name", "too few"])

    def test_a_quote_that_the_sources_do_not_hold_is_found(self):
        strings = strings_of('fmt::format("no {:>4} has "\n   "this name", x); f("too many");')
        self.assertEqual(wrong_quotes(self.PAGE, strings), ["too few"])

    def test_a_message_that_is_not_explained_is_found(self):
        source = 'findings.error("f", {.message = fmt::format("no {} has this name", k)}); core::warning("prf.low",\n"the PRF is too low");'
        self.assertEqual(unexplained(self.PAGE, messages_of(source)), ["the PRF is too low"])

    def test_a_guard_that_does_not_exist_is_found(self):
        tests = tests_of("TEST(Noise, IsWhite) {\nTEST_F(Delay, IsExact) {\n")
        self.assertEqual(
            missing_guards("`Noise.IsWhite` `Delay.*` `Noise.IsBlack` `Range.*`", tests), ["Noise.IsBlack", "Range.*"]
        )

    def test_a_number_that_the_table_has_not_is_found(self):
        page = "## Thesis, classic and physical side by side\n| A.2 | x | −1.5° | 2e-4 mV |\n\n## More\n| 7 | 8 | 9 |\n"
        self.assertEqual(strange_numbers(page, "| 0 | -1.5 | 2e-5 |"), ["2e-4"])


def check_messages(project):
    page = (project / "docs/guide/troubleshooting.md").read_text(encoding="utf-8")
    strings = []
    for file in sorted((project / "src").rglob("*.[ch]pp")):
        if not file.name.endswith("_test.cpp"):
            strings += strings_of(file.read_text(encoding="utf-8"))
    wrong = [
        f"troubleshooting.md quotes what the program does not say: {quote}" for quote in wrong_quotes(page, strings)
    ]
    for name in EXPLAINED:
        messages = messages_of((project / "src" / name).read_text(encoding="utf-8"))
        wrong += [
            f"troubleshooting.md does not explain: {message} (src/{name})" for message in unexplained(page, messages)
        ]
    return wrong, len(quotes_of(page))


def check_guards(project):
    tests = set()
    for folder in ("src", "tests"):
        for file in (project / folder).rglob("*_test.cpp"):
            tests |= tests_of(file.read_text(encoding="utf-8"))
    page = (project / "docs/guide/physics.md").read_text(encoding="utf-8")
    return [f"physics.md names a test that does not exist: {name}" for name in missing_guards(page, tests)]


# What the windows are called on the page, by their names in ToolWindows::names().
WINDOWS = {
    "main": "Main window",
    "objects": "Objects",
    "properties": "Properties",
    "script": "Script File",
    "simulations": "Recordings",
    "log": "Log",
    "image": "[the live image](workbench.md#the-live-image)",
    "geometry": "Geometry",
    "simulation": "Raw Return",
    "compressed": "Range Compressed",
    "targets": "Table of Targets",
    "function": "Function",
    "commands": "Search",
    "welcome": "Welcome",
    "tour": "Tour",
    "help": "Help, Contents",
    "import": "Import Targets",
    "viewer": "Image viewer",
    "output": "Simulation Output",
    "save_data": "Save Data",
    "saving": "Saving",
    "range_profile": "Range profile",
    "range_doppler": "range-Doppler map",
    "doppler_time": "Doppler against time",
    "spectrum": "spectrum",
    "phase_history": "phase history",
    "products": "Make an Image",
}


def check_windows(project):
    source = (project / "src/gui/frame/tool_windows.cpp").read_text(encoding="utf-8")
    page = (project / "docs/guide/windows.md").read_text(encoding="utf-8")
    names = re.findall(r'"(\w+)"', source.split("ToolWindows::names()")[1].split("}")[0])
    wrong = [
        f"a window of the program is not in windows.md: {name}" for name in names if WINDOWS.get(name, "\0") not in page
    ]
    return wrong if len(names) > 20 else [*wrong, "the names of the windows were not found in src/gui/frame/tool_windows.cpp"]


def numbers_of(text):
    return re.findall(r"-?\d+(?:\.\d+)?(?:e-?\d+)?", text.replace("−", "-"))


def strange_numbers(page, table):
    """Numbers in the thesis' comparison of a page that the tested table of numbers does not have."""
    rows = page.split("## Thesis, classic and physical side by side", 1)[1].split("\n## ", 1)[0]
    values = [cell for row in rows.splitlines() if row.startswith("|") for cell in row.split("|")[2:-1]]
    known = set(numbers_of(table))
    return [number for cell in values for number in numbers_of(cell) if number not in known]


def check_numbers(project):
    page = (project / "docs/guide/old-scripts.md").read_text(encoding="utf-8")
    table = (project / "docs/theory/thesis-numbers.md").read_text(encoding="utf-8")
    found = strange_numbers(page, table)
    return [f"old-scripts.md has a number that thesis-numbers.md has not: {number}" for number in found]


def check_help_places(project):
    """Every page and heading that F1 leads to is there."""
    source = (project / "src/gui/frame/help_key.cpp").read_text(encoding="utf-8")
    constants = dict(re.findall(r'constexpr const char\* (\w+) = "([^"]+)";', source))
    places = re.findall(r'^    \{"(\w+)", (\w+|"[^"]+"), "([^"]*)"\},$', source, re.MULTILINE)
    wrong = [] if len(places) > 15 else ["the places of F1 were not found in src/gui/frame/help_key.cpp"]
    for widget, page, heading in places:
        file = project / "docs" / (page.strip('"') if page.startswith('"') else constants[page])
        if not file.exists():
            wrong.append(f"F1 in {widget} leads to {file}, which does not exist")
        elif heading and not re.search(rf"^#+ {re.escape(heading)}$", file.read_text(encoding="utf-8"), re.MULTILINE):
            wrong.append(f"F1 in {widget} leads to '{heading}', which {file} does not have")
    return wrong


def main():
    if sys.argv[1:] == ["--self"]:
        unittest.main(argv=sys.argv[:1])
    project = pathlib.Path(sys.argv[1])
    wrong, quotes = check_messages(project)
    wrong += check_guards(project) + check_windows(project) + check_help_places(project) + check_numbers(project)
    print(
        "\n".join(wrong)
        if wrong
        else f"{quotes} messages are quoted as they are, every guard, window and page of F1 is there"
    )
    sys.exit(1 if wrong else 0)


main()
