"""Conversions from Python to the library: every kind of array, number and text, the result, and the message if it is refused.

The environment has SARSIM_LIBRARY and PYTHONPATH.
"""

import collections
import decimal
import fractions
import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import with_numpy  # noqa: E402, F401

import numpy as np  # noqa: E402
import sarsim  # noqa: E402
from sarsim import _convert  # noqa: E402

POSITIONS = np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])
SCENE = """format = "sarsim 2"
[[platform]]
name = "Plane"
position = [0, -2500, 1500]
[[target]]
[[radar]]
name = "X"
platform = "Plane"
carrier = "1 GHz"
pulse = "1 us"
repetition = "1 kHz"
[[recording]]
radar = "X"
file = "x.npy"
range = ["2.8 km", "3 km"]
time = ["0 s", "3 ms"]
sample_rate = "24 MHz"
"""


def read_only(values):
    values = values.copy()
    values.flags.writeable = False
    return values


class Frame:
    """As pandas.DataFrame is to NumPy: no array, but something that becomes one."""

    def __init__(self, values):
        self.values = values

    def __array__(self, dtype=None, copy=None):
        return np.asarray(self.values, dtype=dtype)


# All of these are POSITIONS.
SAME_POSITIONS = {
    "list": POSITIONS.tolist(),
    "tuples": tuple(map(tuple, POSITIONS.tolist())),
    "float32": POSITIONS.astype(np.float32),
    "float16": POSITIONS.astype(np.float16),
    "longdouble": POSITIONS.astype(np.longdouble),
    "int8": POSITIONS.astype(np.int8),
    "uint64": POSITIONS.astype(np.uint64),
    "big-endian": POSITIONS.astype(">f8"),
    "big-endian int": POSITIONS.astype(">i4"),
    "columns": np.asfortranarray(POSITIONS),
    "strided": np.repeat(np.repeat(POSITIONS, 2, axis=0), 3, axis=1)[::2, ::3],
    "reversed": POSITIONS[::-1, ::-1].copy()[::-1, ::-1],
    "transposed": np.ascontiguousarray(POSITIONS.T).T,
    "read-only": read_only(POSITIONS),
    "unaligned": np.frombuffer(b"x" + POSITIONS.tobytes(), np.float64, offset=1).reshape(2, 3),
    "memory view": memoryview(POSITIONS),
    "objects": POSITIONS.astype(object),
    "objects of many kinds": np.array(
        [[1, 2.0, np.float32(3)], [np.int16(4), fractions.Fraction(5), decimal.Decimal(6)]], dtype=object
    ),
    "matrix": np.matrix(POSITIONS),
    "masked, none masked": np.ma.masked_array(POSITIONS, mask=np.zeros((2, 3), bool)),
    "a frame": Frame(POSITIONS),
    "a frame of objects": Frame(POSITIONS.astype(object)),
    "a subclass": POSITIONS.view(type("Mine", (np.ndarray,), {})),
}

# Refused values, with a word of the message.
BAD_POSITIONS = {
    "complex": (POSITIONS + 1j, TypeError, "complex"),
    "complex without imaginary parts": (POSITIONS.astype(complex), TypeError, "complex"),
    "complex objects": ((POSITIONS + 1j).astype(object), TypeError, "complex"),
    "bool": (POSITIONS > 2, TypeError, "bool"),
    "texts": (POSITIONS.astype(str), TypeError, "texts"),
    "bytes": (POSITIONS.astype("S"), TypeError, "texts"),
    "dates": (POSITIONS.astype("M8[s]"), TypeError, "dates"),
    "durations": (POSITIONS.astype("m8[s]"), TypeError, "durations"),
    "structured": (np.zeros(2, [("x", float), ("y", float), ("z", float)]), TypeError, "structured"),
    "masked": (np.ma.masked_greater(POSITIONS, 5), ValueError, "1 masked"),
    "a masked scalar": (np.ma.masked, ValueError, "masked"),
    "None": (None, TypeError, "NoneType"),
    "objects with None": (np.array([[1, 2, None]], dtype=object), TypeError, "NoneType"),
    "objects with texts": (np.array([[1, 2, "3"]], dtype=object), TypeError, "str"),
    "ragged": ([[1, 2, 3], [4, 5]], (ValueError, TypeError), "positions"),
    "a dictionary": ({"x": 1}, TypeError, "dict"),
    "a text": ("1,2,3", TypeError, "str"),
    "a number": (3.0, ValueError, "shape"),
    "no dimensions": (np.array(3.0), ValueError, "shape"),
    "one dimension": (POSITIONS[0], ValueError, "shape"),
    "columns and rows exchanged": (np.zeros((3, 2)), ValueError, "shape"),
    "three dimensions": (np.zeros((2, 3, 1)), ValueError, "shape"),
    "empty": ([], ValueError, "shape"),
    "a huge whole number": ([[10**400, 0, 0]], ValueError, "double"),
}
if np.finfo(np.longdouble).max > np.finfo(float).max:
    BAD_POSITIONS["a huge long double"] = (np.full((1, 3), np.longdouble("1e4000")), ValueError, "double")

NOT_WHOLE = [0.0, 0.5, np.float64(1), True, np.True_, "0x", b"0", None, 1j, fractions.Fraction(1), decimal.Decimal(1), [0]]


class Conversions(unittest.TestCase):
    def setUp(self):
        self.scene = sarsim.Scene(SCENE)

    def refused(self, kind, words, call, *arguments, **named):
        with self.assertRaisesRegex(kind, words):
            call(*arguments, **named)

    def test_positions_of_every_kind_are_the_same(self):
        for name, values in SAME_POSITIONS.items():
            with self.subTest(name):
                scene = sarsim.Scene()
                scene.targets.add_many(values)
                np.testing.assert_array_equal([target.position for target in scene.targets], POSITIONS)
                scene.clouds.add_points(values)
                np.testing.assert_array_equal(scene._points["cloud1.npy"][:, :3], POSITIONS)

    def test_other_positions_are_refused_by_name(self):
        for name, (values, kind, word) in BAD_POSITIONS.items():
            for add in (self.scene.targets.add_many, self.scene.clouds.add_points):
                with self.subTest(name):
                    self.refused(kind, word, add, values)
        self.assertEqual((len(self.scene.targets), len(self.scene.clouds)), (1, 0))

    def test_not_a_number_and_nothing_at_all_go_to_the_library(self):
        self.scene.targets.add_many([[float("nan"), 0, 0]])
        self.assertIn("not made of finite numbers", str(self.scene.check()))
        self.scene.targets.add_many(np.empty((0, 3)))
        self.assertEqual(len(self.scene.targets), 2)

    def test_cross_sections_are_one_or_one_for_each(self):
        for values in (2, 2.0, np.array(2), np.float32(2), [2], [2, 2], np.full(2, 2, ">i2")):
            with self.subTest(repr(values)):
                scene = sarsim.Scene()
                scene.targets.add_many(POSITIONS, values)
                self.assertEqual([target.rcs for target in scene.targets], [2.0, 2.0])
        for values, kind in (([1, 2, 3], ValueError), (2j, TypeError), (True, TypeError), ("2", TypeError), ([[1, 2]], ValueError)):
            with self.subTest(repr(values)):
                self.refused(kind, "cross-sections", self.scene.targets.add_many, POSITIONS, values)

    def test_points_take_what_positions_take(self):
        for values in ([0, 1], (0, 1), np.array([0, 1], ">i8"), np.array([0, 1], object), range(2), collections.deque([0, 1])):
            with self.subTest(repr(values)):
                np.testing.assert_array_equal(sarsim.Points(values, values).x, [0.0, 1.0])
        complex_y = sarsim.Points([0, 1], [1 + 2j, 3 - 4j])
        np.testing.assert_array_equal(complex_y.y, [[1, 2], [3, -4]])
        for x, y, kind in (
            ([0, 1j], [0, 1], TypeError),
            ([0, 1], np.ma.masked_equal([0, 1], 1), ValueError),
            (np.array(["2020-01-01", "2020-01-02"], "M8"), [0, 1], TypeError),
            (0.5, 1.0, ValueError),
            ([0, 1], [0], ValueError),
            ([True, False], [0, 1], TypeError),
        ):
            with self.subTest(repr((x, y))):
                self.refused(kind, "", sarsim.Points, x, y)

    def test_numbers_of_every_kind_set_a_field(self):
        radar = self.scene.radars["X"]
        for value in (
            2, 2.0, np.int8(2), np.uint64(2), np.float16(2), np.float32(2), np.longdouble(2), np.array(2), np.array(2.0),
            np.array(2, object), np.ma.array(2), fractions.Fraction(4, 2), decimal.Decimal(2), "2 W", np.str_("2 W"), np.array("2 W"),
        ):  # fmt: skip
            with self.subTest(repr(value)):
                radar.power = 1000
                radar.power = value
                self.assertEqual(radar.power, 2.0)
        for value, kind in (
            (2 + 0j, TypeError), (np.complex64(2), TypeError), (None, TypeError), ([2], TypeError), (np.array([2, 3]), TypeError),
            (b"2 W", TypeError), (np.bytes_(b"2"), TypeError), (np.datetime64("2020-01-01"), TypeError), (np.timedelta64(2, "s"), TypeError),
            (np.ma.masked, TypeError), ({}, TypeError), (10**400, ValueError), (object(), TypeError), ("2\0 W", ValueError), ("\ud800", ValueError),
        ):  # fmt: skip
            with self.subTest(repr(value)):
                self.refused(kind, "power", setattr, radar, "power", value)
                self.assertEqual(radar.power, 2.0)

    def test_vectors_take_three_numbers(self):
        platform = self.scene.platforms["Plane"]
        for value in ([1, 2, 3], np.array([1, 2, 3], np.float16), np.array([1, 2, 3], object), ("1 m", 2, "3 m"), range(1, 4)):
            with self.subTest(repr(value)):
                platform.position = value
                np.testing.assert_array_equal(platform.position, [1, 2, 3])
        for value in ([1, 2], [1, 2, 3j], "123", np.array([1, 2, 3j]), [1, None, 3], 7, np.array(7), np.eye(3)):
            with self.subTest(repr(value)):
                self.refused((TypeError, ValueError), "", setattr, platform, "position", value)
                np.testing.assert_array_equal(platform.position, [1, 2, 3])

    def test_whole_fields_take_whole_numbers(self):
        options = self.scene.options
        for value in (7, np.int16(7), np.uint64(7), np.array(7), "7"):
            options.seed = value
            self.assertEqual(options.seed, 7)
        for value in (7.5, 7.0, True, None, 7j, [7]):
            with self.subTest(repr(value)):
                self.refused(TypeError, "seed", setattr, options, "seed", value)
        for value in (2**70, -(2**70)):
            self.refused(ValueError, "seed", setattr, options, "seed", value)

    def test_objects_are_counted_in_whole_numbers(self):
        for which in (0, -1, np.int8(0), np.uint64(0), np.array(0)):
            self.assertEqual(self.scene.radars[which].name, "X")
        for which in NOT_WHOLE:
            with self.subTest(repr(which)):
                self.refused((TypeError, KeyError), "", self.scene.radars.__getitem__, which)
        for which in (1, -2, 2**70, -(2**70), np.uint64(2**63)):
            with self.subTest(repr(which)):
                self.refused((IndexError, ValueError), "", self.scene.radars.__getitem__, which)
        self.refused((TypeError, ValueError), "", self.scene.radars.remove, self.scene.platforms[0])
        self.refused((TypeError, ValueError), "", self.scene.radars.remove, sarsim.Scene(SCENE).radars[0])
        self.assertEqual(len(self.scene.radars), 1)

    def test_threads_and_numbers_of_recordings_are_whole(self):
        whole = self.scene.record()
        for threads in (1, np.int64(1), np.array(1), 0):
            np.testing.assert_array_equal(self.scene.record(threads=threads), whole)
        for threads in (-1, 2**32, 2**70, -(2**31), 10**6):
            with self.subTest(threads):
                self.refused(ValueError, "threads", self.scene.record, threads=threads)
                self.refused(ValueError, "threads", self.scene.check, threads=threads)
                self.refused(ValueError, "threads", sarsim.focus, self.scene, threads=threads)
        for threads in (1.0, True, "2", None, 1j):
            with self.subTest(threads):
                self.refused(TypeError, "threads", self.scene.record, threads=threads)
        for number in (1.5, True, 1j, None):
            self.refused(TypeError, "number of a recording", self.scene.record, number)
        for number in (0, -1, 2**70):
            self.refused(ValueError, "number of a recording", self.scene.record, number)
        np.testing.assert_array_equal(self.scene.record(np.int32(1)), whole)
        np.testing.assert_array_equal(self.scene.record(pathlib.Path("x.npy")), whole)
        for block in (-1, 1.5, True, 2**-1):
            self.refused((TypeError, ValueError), "block", lambda size: list(self.scene.rows(block=size)), block)
        self.refused(TypeError, "progress", self.scene.record, progress=3)

    def test_a_nul_ends_no_text(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "m.toml")
            pathlib.Path(path).write_text(SCENE, encoding="utf-8")
            recording = self.scene.record()
            raster = sarsim.Raster.of(np.zeros((2, 3)))
            for call in (
                lambda: sarsim.read(path + "\0evil"),
                lambda: sarsim.read(path.encode() + b"\0evil"),
                lambda: sarsim.read(path, let={"a\0": 1}),
                lambda: sarsim.Scene(SCENE, name="a\0b"),
                lambda: sarsim.open(path + "\0.npy"),
                lambda: sarsim.focus(path + "\0"),
                lambda: recording.save(os.path.join(folder, "x.npy\0.h5")),
                lambda: raster.save(os.path.join(folder, "x.npy\0.h5")),
                lambda: self.scene.record_file(os.path.join(folder, "x.npy\0.h5")),
                lambda: self.scene.record_file(os.path.join(folder, "x.npy"), format="npy\0"),
                lambda: self.scene.write(os.path.join(folder, "s\0.toml")),
                lambda: sarsim.export(self.scene, os.path.join(folder, "x\0.cphd")),
                lambda: self.scene.platforms.add("a\0b"),
                lambda: setattr(self.scene.platforms[0], "name", "a\0b"),
                lambda: self.scene.set("X.power\0", "1 W"),
                lambda: self.scene.set("X.power", "1 W\0"),
                lambda: self.scene.get("X.power\0"),
                lambda: self.scene.number("X.power\0"),
                lambda: self.scene.__setitem__("X.power\0", 1.0),
                lambda: self.scene.targets.add_many(POSITIONS, platform="Plane\0"),
                lambda: self.scene.clouds.add_points(POSITIONS, file="c.npy\0"),
                lambda: sarsim.focus(self.scene, window="hann\0"),
                lambda: sarsim.focus(self.scene, **{"window\0": "hann"}),
                lambda: sarsim.Raster.of(np.zeros((2, 3)), {"pulse_time_s\0": [0, 1]}),
                lambda: sarsim.Raster.of(np.zeros((2, 3)), attributes={"radar": "a\0b"}),
                lambda: sarsim.explain("power\0"),
                lambda: sarsim.options("focus\0"),
            ):
                self.refused(ValueError, "NUL|null byte", call)
            self.assertEqual(os.listdir(folder), ["m.toml"])

    def test_paths_are_texts_bytes_and_paths(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "m\u00fc.toml")
            path.write_text(SCENE, encoding="utf-8")
            for name in (path, str(path), os.fsencode(path), np.str_(path), np.array(str(path))):
                self.assertEqual(sarsim.read(name), self.scene)
            for name in (3, None, [str(path)], 1.5, True):
                self.refused(TypeError, "path", sarsim.read, name)
            odd = os.path.join(folder, "odd\udcff.npy")
            sarsim.Raster.of(np.ones((2, 3))).save(odd)
            self.assertEqual(sarsim.open(odd).shape, (2, 3))
            self.refused(ValueError, "half of a character", sarsim.read, "a\ud800")
            self.refused(ValueError, "half of a character", self.scene.platforms.add, "a\ud800")

    def test_scenes_and_names_are_texts(self):
        for text in (SCENE.encode(), 3, ["a"]):
            self.refused(TypeError, "text", sarsim.Scene, text)
        for name in (b"a", 3, ["a"], np.bytes_(b"a")):
            self.refused(TypeError, "name", self.scene.platforms.add, name)
        self.assertEqual(self.scene.platforms.add(np.str_("P")).name, "P")

    def test_options_are_words_and_numbers(self):
        told = _convert.words(
            {
                "a_b": True, "c": False, "d": None, "e": 3, "f": np.float64(0.1), "g": [1, "x"], "h": np.array([1, 2]), "i_": np.True_,
                "j": pathlib.Path("p"), "k": np.array(2), "l": np.float32(0.5), "m": decimal.Decimal("0.1"), "n": "w", "o": 10**20,
            }.items()
        )  # fmt: skip
        self.assertEqual(
            told,
            ["a-b", "e=3", "f=0.1", "g=1", "g=x", "h=1", "h=2", "i", "j=p", "k=2", "l=0.5", "m=0.1", "n=w", "o=100000000000000000000"],
        )
        for value in (1j, b"x", {}, object(), np.eye(2), [None], [[1]], np.datetime64("2020-01-01"), [True]):
            with self.subTest(repr(value)):
                self.refused(TypeError, "option a", _convert.words, {"a": value}.items())

    def test_samples_become_floats_of_their_kind(self):
        real = np.array([[1.0, 2, 3], [4, 5, 6]])
        for name, values in SAME_POSITIONS.items():
            if "objects" in name:
                continue
            with self.subTest(name):
                raster = sarsim.Raster.of(values)
                np.testing.assert_array_equal(raster.window(), real)
                self.assertEqual(raster.dtype, np.float32)
        for values in (real + 1j, (real + 1j).astype(">c16"), np.asfortranarray(real + 1j), (real + 1j).astype(np.complex64)[:, ::-1][:, ::-1]):
            np.testing.assert_array_equal(sarsim.Raster.of(values).window(), real + 1j)
        for values, kind in (
            (real.astype(object), TypeError), (real.astype("M8[s]"), TypeError), (real.astype(str), TypeError), (real[0], ValueError),
            (np.ma.masked_equal(real, 2), ValueError), (real * 1e300, ValueError), ((real + 1j) * 1e300, ValueError), (np.zeros(2, "f,f"), TypeError),
        ):  # fmt: skip
            with self.subTest(repr(values)):
                self.refused(kind, "samples", sarsim.Raster.of, values)
        np.testing.assert_array_equal(np.isinf(sarsim.Raster.of(np.array([[np.inf, 1.0]])).window()), [[True, False]])
        for axis in ([0, 1j], np.eye(2), "ab", [0, None]):
            self.refused((TypeError, ValueError), "axis", sarsim.Raster.of, real, {"pulse_time_s": axis})

    def test_windows_are_slices(self):
        raster = sarsim.Raster.of(POSITIONS)
        np.testing.assert_array_equal(raster.window(slice(0, 0)), np.empty((0, 3)))
        for rows in (0, [0], "0", slice(0.5, 1), slice(None, None, -1)):
            self.refused((TypeError, ValueError), "", raster.window, rows)


if __name__ == "__main__":
    unittest.main()
