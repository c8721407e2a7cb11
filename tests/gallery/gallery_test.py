"""Whether tools/gallery --check finds what it looks for."""

import importlib.machinery
import importlib.util
import pathlib
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).parents[2]


def loaded():
    loader = importlib.machinery.SourceFileLoader("gallery", str(SOURCE / "tools" / "gallery"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("gallery", loader))
    loader.exec_module(module)
    return module


gallery = loaded()
figures = sys.modules["gallery_figures"]
EXACT = {figure.name: [number.expected for number in figure.numbers] for figure in gallery.FIGURES}


class Lines(unittest.TestCase):
    ROW = "| phase | -101.15 deg | thesis | {} deg | 0.005 deg |"

    def test_a_measured_number_may_differ_by_one_in_its_last_digit_only(self):
        self.assertTrue(gallery.same_line(self.ROW.format("-101.15"), self.ROW.format("-101.14")))
        self.assertFalse(gallery.same_line(self.ROW.format("-101.15"), self.ROW.format("-101.13")))

    def test_powers_of_ten_count(self):
        self.assertTrue(gallery.same_line(self.ROW.format("4.0957e-5"), self.ROW.format("4.0956e-5")))
        self.assertFalse(gallery.same_line(self.ROW.format("4.0957e-5"), self.ROW.format("4.0957e-6")))

    def test_anything_else_has_to_be_equal(self):
        self.assertFalse(gallery.same_line(self.ROW.format("1.00"), self.ROW.format("1.00").replace("0.005", "0.006")))
        self.assertFalse(gallery.same_line("some words", "other words"))


class Page(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.addCleanup(setattr, gallery, "PAGE", gallery.PAGE)
        self.addCleanup(setattr, gallery, "PICTURES", gallery.PICTURES)
        self.addCleanup(setattr, gallery, "ROOT", gallery.ROOT)
        gallery.ROOT = pathlib.Path(self.folder.name)
        gallery.PAGE = gallery.ROOT / "gallery.md"
        gallery.PICTURES = gallery.ROOT / "pictures"
        gallery.PICTURES.mkdir()
        (gallery.ROOT / "examples").mkdir()

    def test_a_page_that_was_just_written_is_current(self):
        gallery.PAGE.write_text(gallery.page(EXACT), encoding="utf-8")
        self.assertEqual(gallery.complaints_about_page(gallery.page(EXACT)), [])

    def test_a_changed_command_a_missing_line_and_no_page_are_found(self):
        text = gallery.page(EXACT)
        self.assertIn("there is no", gallery.complaints_about_page(text)[0])
        gallery.PAGE.write_text(text.replace("--kind antenna", "--kind sent"), encoding="utf-8")
        self.assertIn("not current", gallery.complaints_about_page(text)[0])
        gallery.PAGE.write_text(text + "more\n", encoding="utf-8")
        self.assertIn("lines", gallery.complaints_about_page(text)[0])

    def test_pictures_missing_left_over_and_too_large_are_found(self):
        names = [name for figure in gallery.FIGURES for name in gallery.picture_names(figure)]
        for name in names[1:]:
            (gallery.PICTURES / name).write_bytes(b"x")
        (gallery.PICTURES / "old.png").write_bytes(b"x" * (gallery.LARGEST_BYTES + 1))
        complaints = "\n".join(gallery.complaints_about_files())
        for words in (
            f"{names[0]} is missing",
            "old.png belongs to no figure",
            f"old.png takes {gallery.LARGEST_BYTES + 1} bytes",
            "the pictures take",
        ):
            self.assertIn(words, complaints)

    def test_an_example_that_no_figure_uses_is_found(self):
        for name in ("new.toml", "new.scr", "only.scr", "sar_r.toml", "sar_r.scr"):
            (gallery.ROOT / "examples" / name).write_text("", encoding="utf-8")
        complaints = "\n".join(gallery.complaints_about_files())
        self.assertIn("examples/new.toml is neither", complaints)
        self.assertIn("examples/only.scr is neither", complaints)
        self.assertNotIn("examples/new.scr", complaints)  # The same scene in the other language.
        self.assertNotIn("examples/sar_r", complaints)


class Numbers(unittest.TestCase):
    def test_a_number_beyond_its_tolerance_is_told(self):
        number = figures.Number("length", "m", 750.0, "thesis", 0.7, ".1f", lambda lab: lab)
        self.addCleanup(gallery.FIGURES.__setitem__, slice(None), gallery.FIGURES[:])
        gallery.FIGURES[:] = [figures.Figure("A.7", "", [], "", [number])]
        self.assertEqual(gallery.measure_all(749.5), ({"A.7": [749.5]}, []))
        self.assertIn("749.2 m instead of 750", gallery.measure_all(749.2)[1][0])
        self.assertTrue(gallery.measure_all(float("nan"))[1])


if __name__ == "__main__":
    unittest.main()
