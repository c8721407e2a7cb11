"""Whether run_example.py and same_in_both_languages.py find what they look for.

usage: run_example_test.py SARSIM
"""

import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import run_example  # noqa: E402
import same_in_both_languages  # noqa: E402

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"
PROGRAM = pathlib.Path(sys.argv.pop()).resolve()


class Reading(unittest.TestCase):
    HEADING = """\
! A title with "a quotation"
!
!     sarsim isar ship.scr --autofocus
!
!   - "sarsim plot ship.scr --kind
!     range -o a.png" draws it; with "--show db" in decibels.
$RADAR                                   ! "sarsim nonsense"
"""

    def test_commands_and_options_of_the_heading_are_found_in_order_also_across_lines(self):
        self.assertEqual(
            run_example.quotations(self.HEADING),
            ["sarsim isar ship.scr --autofocus", "sarsim plot ship.scr --kind range -o a.png", "--show db"],
        )

    def test_headings_of_format_2_are_read_as_well(self):
        text = self.HEADING.replace("!", "#").replace(".scr", ".toml")
        self.assertEqual(
            run_example.quotations(text),
            ["sarsim isar ship.toml --autofocus", "sarsim plot ship.toml --kind range -o a.png", "--show db"],
        )

    def test_recordings_and_tables_are_counted_but_not_in_comments(self):
        self.assertEqual(run_example.product_count("$SIMULATION a\n$ simulation\n! $SIMULATION\n$GEOMETRY\n$SURFACE"), 3)

    def test_a_command_alone_gets_the_script(self):
        self.assertEqual(run_example.runnable("sarsim check", "a.scr"), ["check", "a.scr"])

    def test_what_earlier_commands_wrote_is_replaced(self):
        self.assertEqual(run_example.runnable("sarsim plot a.scr -o a.png", "a.scr"), ["plot", "a.scr", "-o", "a.png", "--force"])


class Examples(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.script = pathlib.Path(self.folder.name) / "thesis_a2.scr"
        self.text = (EXAMPLES / "thesis_a2.scr").read_text(encoding="utf-8")

    def complaints(self, old="", new=""):
        """What is said of an example in which a text is replaced, wherever it is."""
        self.assertIn(old, self.text)
        self.script.write_text(self.text.replace(old, new) if old else self.text, encoding="utf-8")
        return "\n".join(run_example.complaints_about(PROGRAM, self.script))

    def test_a_good_example_is_not_complained_about(self):
        self.assertEqual(self.complaints(), "")

    def test_a_mistake_in_the_script_is_told(self):
        self.assertIn("not a number", self.complaints("1000, 0, 0", "1000, zero, 0"))

    def test_a_recording_of_nothing_is_told(self):
        self.assertIn("nothing but zeros", self.complaints("1000, 0, 0", "90000, 0, 0"))

    def test_a_command_that_does_not_work_is_told(self):
        self.assertIn("ended with status 2", self.complaints("! What to look at:", '! "sarsim plot --kind colour -o a.png"'))

    def test_an_option_that_the_command_before_does_not_have_is_told(self):
        said = self.complaints("! What to look at:", '! "sarsim check" and "--canceller two"')
        self.assertIn("no option of the command before it", said)

    def test_an_example_that_the_gallery_does_not_name_is_told(self):
        self.script = self.script.with_name("unknown.scr")
        self.assertIn("the gallery does not name unknown.scr", self.complaints())


class Products(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.sarsim = run_example.Sarsim(PROGRAM, self.folder.name)

    def test_missing_and_empty_files_are_told(self):
        (self.sarsim.folder / "empty.npy").touch()
        products = [{"file": name, "kind": "recording", "maximum_v": 1.0} for name in ("empty.npy", "missing.npy")]
        said = run_example.complaints_about_products(self.sarsim, products, 3)
        self.assertEqual(len(said), 3)

    def test_a_formatted_script_with_other_samples_is_told(self):
        shutil.copy(EXAMPLES / "thesis_a2.scr", self.sarsim.folder)
        products, _ = run_example.run(self.sarsim, "thesis_a2.scr", "first")
        self.assertEqual(run_example.complaints_about_format(self.sarsim, "thesis_a2.scr", products), [])
        path = self.sarsim.folder / products[1]["file"]
        path.write_bytes(path.read_bytes().replace(b"1", b"2", 1))
        (self.sarsim.folder / "formatted.scr").unlink()
        shutil.rmtree(self.sarsim.folder / "again")
        said = run_example.complaints_about_format(self.sarsim, "thesis_a2.scr", products)
        self.assertIn("differs once the script is formatted", said[0])


class Pairs(unittest.TestCase):
    NAME = "thesis_figure_a14"

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for ending in ("scr", "toml"):
            shutil.copy(EXAMPLES / f"{self.NAME}.{ending}", self.folder)
        self.scene = self.folder / f"{self.NAME}.toml"

    def complaints(self, old="", new=""):
        """What is said of the pair once a text of the scene is replaced, wherever it is."""
        text = self.scene.read_text(encoding="utf-8")
        self.assertIn(old, text)
        self.scene.write_text(text.replace(old, new) if old else text, encoding="utf-8")
        return "\n".join(same_in_both_languages.complaints_about_folder(PROGRAM, self.folder))

    def test_a_scene_that_is_the_same_in_both_is_not_complained_about(self):
        self.assertEqual(self.complaints(), "")

    def test_a_missing_scene_is_told(self):
        self.scene.unlink()
        said = same_in_both_languages.complaints_about_folder(PROGRAM, self.folder)
        self.assertEqual(said, [f"{self.NAME}.toml: there is no {self.NAME}.toml"])

    def test_a_scene_without_a_script_is_told(self):
        shutil.copy(self.scene, self.folder / "lonely.toml")
        self.assertEqual(self.complaints(), "lonely.toml: there is no script that it belongs to")

    def test_a_folder_without_examples_is_told(self):
        for path in self.folder.iterdir():
            path.unlink()
        said = same_in_both_languages.complaints_about_folder(PROGRAM, self.folder)
        self.assertEqual(said, [f"{self.folder}: no examples"])

    def test_another_value_is_told_to_the_last_bit(self):
        said = self.complaints("24 deg/s", "24.000000000000004 deg/s")
        self.assertIn("the scenes differ", said)
        self.assertIn('rate = "24.000000000000004 deg/s"', said)

    def test_a_platform_more_is_told_but_a_resting_earth_is_not(self):
        self.assertEqual(self.complaints("[[target]]", "[[platform]]\n\n[[target]]"), "")
        said = self.complaints("[[platform]]\n", '[[platform]]\nname = "Mast"\n')
        self.assertIn("the scenes differ", said)

    def test_a_mistake_is_told(self):
        self.assertIn("ended with status", self.complaints("24 deg/s", "24 km"))

    def test_a_command_of_the_heading_for_the_other_file_is_told(self):
        said = self.complaints("plot thesis_figure_a14.toml", "plot thesis_figure_a14.scr")
        self.assertIn("the heading quotes ['sarsim plot thesis_figure_a14.scr", said)

    def test_a_long_line_is_told(self):
        said = self.complaints('name = "Radar1"', 'name = "Radar1"' + " " * 100 + "# far away")
        self.assertIn("is longer than 120 characters", said)

    def test_other_samples_are_told(self):
        sarsim = run_example.Sarsim(PROGRAM, self.folder)
        pair = (self.folder / f"{self.NAME}.scr", self.scene)
        self.assertEqual(same_in_both_languages.complaints_about_samples(sarsim, pair), [])
        for name in ("scr", "toml"):
            shutil.rmtree(self.folder / name)
        text = self.scene.read_text(encoding="utf-8")
        self.scene.write_text(text.replace('rcs = "1 m2"', 'rcs = "2 m2"'), encoding="utf-8")
        said = same_in_both_languages.complaints_about_samples(sarsim, pair)
        self.assertEqual(said, [f"the samples of {self.NAME}.npy differ"])


if __name__ == "__main__":
    unittest.main()
