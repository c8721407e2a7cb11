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

    def test_headers_of_the_system_belong_to_one_room(self):
        cmake = "sarsim_folder(core ROOMS os text)\n"
        include = "#include <sys/stat.h>\n"
        files = {"core/os/a.cpp": include, "core/text/a_test.cpp": include, "core/text/b.cpp": "\n" + include}
        found = self.lines(files, cmake)
        self.assertEqual(found, ["core/text/b.cpp:2: <sys/stat.h> is a header of the system: include it in core/os"])

    def test_undeclared_folders_are_found(self):
        found = self.lines({"extra/a.cpp": "", "base/a.cpp": '#include "other/b.hpp"\n'})
        self.assertEqual(
            found,
            [
                'base/a.cpp:1: "other/b.hpp" is in no declared folder',
                "extra/a.cpp:1: folder extra is not declared in CMakeLists.txt",
            ],
        )

    def test_rooms_use_what_they_declare(self):
        cmake = 'sarsim_folder(core ROOMS text)\nsarsim_folder(scene USES core ROOMS model "check: model" edit)\n'
        sound = {
            "core/text/a.hpp": "#pragma once\n",
            "scene/model/b.hpp": '#pragma once\n#include "core/text/a.hpp"\n',
            "scene/check/c.cpp": '#include "scene/check/c.hpp"\n#include "scene/model/b.hpp"\n',
            "scene/model/b_test.cpp": '#include "scene/check/c.hpp"\n',
        }
        self.assertEqual(check("check-layers", {"CMakeLists.txt": cmake, **sound}), (0, ["layers: nothing found"]))
        found = self.lines(
            {
                "scene/edit/d.cpp": '#include "scene/model/b.hpp"\n#include "scene/b.hpp"\n',
                "scene/other/e.cpp": "",
                "scene/f.cpp": "",
            },
            cmake,
        )
        self.assertEqual(
            found,
            [
                "scene/edit/d.cpp:1: scene/edit may not use scene/model",
                'scene/edit/d.cpp:2: "scene/b.hpp" is in no declared folder',
                "scene/f.cpp:1: folder scene is not declared in CMakeLists.txt",
                "scene/other/e.cpp:1: folder scene/other is not declared in CMakeLists.txt",
            ],
        )

    def test_a_room_of_too_many_units_is_found(self):
        cmake = "sarsim_folder(scene ROOMS model)\n"
        files = {f"scene/model/a{i}.cpp": "" for i in range(40)} | {"scene/model/a1.hpp": "#pragma once\n"}
        tests = {f"scene/model/a{i}_test.cpp": "" for i in range(9)}
        self.assertEqual(check("check-layers", {"CMakeLists.txt": cmake, **files, **tests})[0], 0)
        found = self.lines({**files, "scene/model/b.cpp": ""}, cmake)
        self.assertEqual(found, ["scene/model:1: the room has 41 units, more than 40"])

    def test_a_source_of_too_many_lines_is_found(self):
        self.passes({"math/b.cpp": "\n" * 800})
        found = self.lines({"math/b.cpp": "\n" * 801})
        self.assertEqual(found, ["math/b.cpp:1: the source has 801 lines, more than 800"])

    def test_a_room_that_uses_a_later_one_is_found(self):
        found = self.lines({}, 'sarsim_folder(scene ROOMS "model: check" "check: model")\n')
        self.assertEqual(found, ["CMakeLists.txt:1: scene/model uses check, which is not declared before it"])

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

    def test_limits_to_the_clock_on_the_wall_are_found(self):
        words = "a limit to the clock on the wall; expected one to processor time (tests/support/processor_time.hpp)"
        for limit in ("EXPECT_LT(std::chrono::steady_clock::now() - begin,\n std::chrono::seconds(2));", "QVERIFY(timer.elapsed() < 300);"):
            status, lines = check("check-assertions", {"a_test.cpp": f"TEST(A, B) {{\n  {limit}\n}}\n"})
            self.assertEqual((status, lines), (1, [f"a_test.cpp:2: {words}"]))
        sound = "TEST(A, B) {\n  EXPECT_LT(time.seconds(), 2.0);\n  QVERIFY(clock.elapsed() >= 200);\n  while (steady_clock::now() < end) f();\n}\n"
        self.assertEqual(check("check-assertions", {"a_test.cpp": sound})[0], 0)

    def test_a_test_file_without_test_is_found(self):
        status, lines = check("check-assertions", {"a_test.cpp": "int f();\n"})
        self.assertEqual((status, lines), (1, ["a_test.cpp:1: holds no test"]))


class DocComments(unittest.TestCase):
    def found(self, *headers):
        status, lines = check("check-doc-comments", {f"h{i}.hpp": text for i, text in enumerate(headers)})
        self.assertEqual(status, 1 if lines[0].startswith("h") else 0)
        return lines if status else []

    def passes(self, text):
        self.assertEqual(self.found(text), [])

    def test_a_tree_without_fault_passes(self):
        status, lines = check("check-doc-comments", {"a.hpp": "/// Words.\nint f();\n", "b_test_scene.hpp": "int g();\n"})
        self.assertEqual((status, lines), (0, ["doc comments: nothing found in 1 headers"]))

    def test_functions_types_and_enumerations_without_words_are_found_at_their_lines(self):
        self.assertEqual(
            self.found(
                "namespace n {\n"
                "int f(int a,\n      int b);\n"
                "\nstruct S {\n  int value = 0;\n};\n"
                "\nclass C;\n"
                "\nenum class E { a, b };\n"
                "\ntemplate <class T>\n[[nodiscard]] T g(const std::function<void(int)>& call) {\n  if (call) return 1;\n  return 2;\n}\n"
                "}\n"
            ),
            ["h0.hpp:2: function f", "h0.hpp:5: struct S", "h0.hpp:11: enum E", "h0.hpp:13: function g"],
        )

    def test_only_what_is_public_counts(self):
        found = self.found(
            "/// Words.\nclass C {\n  void hidden();\n public:\n  void seen();\n protected:\n  void kept();\n"
            " signals:\n  void sent();\n private slots:\n  void secret();\n private:\n  struct Inner {};\n};\n"
            "namespace detail {\nvoid inner();\n}\n"
        )
        self.assertEqual(found, ["h0.hpp:5: function seen", "h0.hpp:9: function sent"])

    def test_words_above_behind_and_for_a_group_explain(self):
        self.passes(
            "/// Of both.\nint f();\nint g();\n\n"
            "/// Words.\nclass C {\n public:\n  /// Above.\n  void a();\n  void a(int);  ///< Behind.\n"
            "  /// @name Both.\n  /// @{\n  void b();\n  void c();\n  /// @}\n};\n"
            "\nenum class E {\n  a,  ///< One.\n  /// Two.\n  b\n};\n"
            "\n/// All of them.\nnamespace n {\n\nint k();\nint l();\n\n}\n"
        )

    def test_a_member_below_an_explained_one_of_another_name_is_found(self):
        found = self.found("/// Words.\nstruct S {\n  /// Words.\n  void a();\n  void b();\n};\n")
        self.assertEqual(found, ["h0.hpp:5: function b"])

    def test_what_the_language_or_the_eye_explains_needs_no_words(self):
        self.passes(
            "/// Words.\nclass C : public B {\n  Q_OBJECT\n\n public:\n  C() = default;\n  explicit C(QWidget* parent = nullptr);\n"
            "  C(const C&) = delete;\n  C& operator=(C&& other) noexcept;\n  ~C();\n  explicit C(int a) : a_{a} {}\n"
            "  int rows(const QModelIndex& parent = {}) const override;\n"
            "  [[nodiscard]] int size() const { return a_; }\n  [[nodiscard]] int twice() const {\n    return 2 * a_;\n  }\n"
            "  friend bool operator==(const C&, const C&) = default;\n  std::function<int(int)> call = {};\n"
            "  std::vector<int> list{1, 2};\n  using Report = std::function<void(double)>;\n};\n"
            '// int f();\nconst char* const text = "int f();";\n#define F(x) \\\n  int x()\nclass Later;\n'
            "/// Words.\ntemplate <class T>\nint f(T t);\n\nint other = 1;\n\ntemplate <class T>\nint f(T t) {\n  t();\n  return 1;\n}\n"
            "\ntemplate <class T>\nint D<T>::g() {\n  t();\n  return 1;\n}\n"
        )

    def test_two_statements_are_no_explanation(self):
        found = self.found("/// Words.\nstruct S {\n  int f() {\n    ++a;\n    return a;\n  }\n  int a = 0;\n};\n")
        self.assertEqual(found, ["h0.hpp:3: function f"])


if __name__ == "__main__":
    unittest.main()
