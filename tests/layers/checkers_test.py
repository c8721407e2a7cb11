#!/usr/bin/env python3
"""The checkers of tools/ find each kind of offence, at its line, and pass a tree that has none."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOLS = pathlib.Path(__file__).resolve().parent.parent.parent / "tools"

LAYERS = """
# sarsim_folder(comment USES nothing)
sarsim_folder(base LIBS fmt::fmt)
sarsim_folder(math USES base LIBS PkgConfig::FFTW)
sarsim_folder(echo USES math
              base)
sarsim_folder(data USES math base LIBS hdf5::hdf5)
sarsim_folder(cli USES echo math base)
"""


def check(tool, files):
    """Runs a checker over a tree of these files; its exit status and its lines, relative to the tree."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
        result = subprocess.run([sys.executable, TOOLS / tool, root], capture_output=True, text=True, check=False)
        return result.returncode, result.stdout.replace(f"{root}/", "").splitlines()


class Layers(unittest.TestCase):
    def lines(self, files, cmake=LAYERS):
        status, lines = check("check-layers", {"CMakeLists.txt": cmake, **files})
        self.assertEqual(status, 1)
        return lines

    def passes(self, files):
        status, lines = check("check-layers", {"CMakeLists.txt": LAYERS, **files})
        self.assertEqual((status, lines), (0, ["layers: nothing found"]))

    def test_a_sound_tree_passes(self):
        self.passes(
            {
                "base/a.hpp": "// A comment before.\n#pragma once\n#include <vector>\n",
                "math/b.cpp": '#include "math/b.hpp"\n#include "base/a.hpp"\n#include <fftw3.h>\n',
                "math/b.hpp": "#pragma once\n",
                "echo/c.cpp": '#include "math/b.hpp"\n#include "base/a.hpp"\n',
                "cli/main.cpp": '#include "echo/c.hpp"\nint main() { std::cout << 1; exit(0); }\n',
            }
        )

    def test_only_tests_may_use_what_tests_share(self):
        self.passes({"math/b_test.cpp": '#include "support/folders.hpp"\n'})
        found = self.lines({"math/b.cpp": '#include "support/folders.hpp"\n'})
        self.assertEqual(found, ['math/b.cpp:1: "support/folders.hpp" is in no declared folder'])

    def test_an_upward_include_is_found(self):
        found = self.lines({"base/a.cpp": '#include <vector>\n#include "math/b.hpp"\n'})
        self.assertEqual(found, ["base/a.cpp:2: base may not use math"])

    def test_a_sideways_include_is_found(self):
        found = self.lines({"echo/a.cpp": '#include "data/b.hpp"\n'})
        self.assertEqual(found, ["echo/a.cpp:1: echo may not use data"])

    def test_tests_keep_to_the_layers_too(self):
        found = self.lines({"base/a_test.cpp": '#include "math/b.hpp"\n'})
        self.assertEqual(found, ["base/a_test.cpp:1: base may not use math"])

    def test_an_include_without_a_folder_is_found(self):
        found = self.lines({"base/a.cpp": '#include "a.hpp"\n', "math/b.cpp": '#include "../base/a.hpp"\n'})
        self.assertEqual(
            found,
            [
                'base/a.cpp:1: "a.hpp" is included without its folder',
                'math/b.cpp:1: "../base/a.hpp" is included without its folder',
            ],
        )

    def test_an_outside_library_belongs_to_the_folder_that_lists_it(self):
        found = self.lines({"echo/a.cpp": "#include <hdf5.h>\n", "data/b.cpp": "#include <hdf5.h>\n"})
        self.assertEqual(found, ["echo/a.cpp:1: echo includes <hdf5.h> without hdf5 among its LIBS"])

    def test_undeclared_folders_are_found(self):
        found = self.lines({"extra/a.cpp": "", "base/a.cpp": '#include "other/b.hpp"\n'})
        self.assertEqual(
            found,
            [
                'base/a.cpp:1: "other/b.hpp" is in no declared folder',
                "extra/a.cpp:1: folder extra is not declared in CMakeLists.txt",
            ],
        )

    def test_a_folder_that_uses_a_later_one_is_found(self):
        found = self.lines({}, "sarsim_folder(base USES math)\nsarsim_folder(math USES base)\n")
        self.assertEqual(found, ["CMakeLists.txt:1: base uses math, which is not declared before it"])

    def test_printing_and_leaving_below_cli_are_found(self):
        for code in ("std::cout << 1;", "std::cerr << 1;", "printf(x);", "fprintf(stderr, x);", "puts(x);",
                     "fmt::print(x);", "exit(1);", "std::abort();", "std::terminate();", "std::_Exit(2);"):
            with self.subTest(code):
                found = self.lines({"math/a.cpp": f"void f() {{\n  {code}\n}}\n"})
                self.assertEqual(len(found), 1, found)
                self.assertRegex(found[0], r"^math/a\.cpp:2: .* below cli$")

    def test_words_about_printing_are_not_printing(self):
        self.passes(
            {
                "math/a.cpp": '// exit(1) and std::cout\n/* abort() */ auto t = "printf(";\nauto r = R"(puts())";\n'
                "int n = snprintf(b, 3, f); loop.exit(); on_exit(3); const int big = 1'000; auto c = '\"';\n",
                "math/a_test.cpp": "int main() { std::cout << 1; }\n",
            }
        )

    def test_a_header_without_a_guard_is_found(self):
        found = self.lines({"base/a.hpp": "#include <vector>\n#pragma once\n", "base/b.hpp.in": "int x;\n"})
        self.assertEqual(
            found,
            [f"base/{name}:1: header does not begin with #pragma once" for name in ("a.hpp", "b.hpp.in")],
        )


class Assertions(unittest.TestCase):
    def test_tests_with_assertions_pass(self):
        status, lines = check(
            "check-assertions",
            {
                "a_test.cpp": "TEST(A, B) { EXPECT_EQ(1, 1); }\nTEST_F(A, C) {\n  if (x) { FAIL(); }\n}\n",
                "b_test.cpp": "void same(int a) { ASSERT_EQ(a, 1); }\nTEST(A, D) { same(2); }\n"
                "TEST_P(A, E) { expect_near_all(a, b); }\n",
            },
        )
        self.assertEqual((status, lines), (0, ["assertions: nothing found in 2 files"]))

    def test_a_test_without_assertion_is_found(self):
        status, lines = check(
            "check-assertions",
            {"a_test.cpp": 'TEST(A, B) { EXPECT_EQ(1, 1); }\n\nTEST(A, C) {\n  f("EXPECT_EQ(");  // EXPECT_EQ(1, 2)\n}\n'},
        )
        self.assertEqual((status, lines), (1, ["a_test.cpp:3: A.C asserts nothing"]))

    def test_a_test_file_without_test_is_found(self):
        status, lines = check("check-assertions", {"a_test.cpp": "int f();\n"})
        self.assertEqual((status, lines), (1, ["a_test.cpp:1: holds no test"]))


if __name__ == "__main__":
    unittest.main()
