"""The Python package: scenes, recordings, images, interrupts, threads, processes. Compared with the command where it can be.

    package_test.py CLASS      one of the classes below

The environment has SARSIM_LIBRARY, PYTHONPATH and SARSIM_PROGRAM.
"""

import contextlib
import copy
import io
import multiprocessing
import os
import pathlib
import pickle
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings
import zlib
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
import more_python  # noqa: E402

if "OtherPackages" in sys.argv:
    more_python.prefer("xarray", "distributed")
import with_numpy  # noqa: E402, F401

import numpy as np  # noqa: E402
import sarsim  # noqa: E402

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"


def command(*words):
    done = subprocess.run([os.environ["SARSIM_PROGRAM"], *map(str, words)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{words}: {done.stderr}"
    return done.stdout


def sar_r():
    return sarsim.read(EXAMPLES / "sar_r.toml")


def power_at(scene):
    """For processes: the energy of a recording."""
    return float((np.abs(scene.record(threads=1).samples) ** 2).sum())


class Folder(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)


class Scenes(Folder):
    def test_the_atmosphere_has_attributes(self):
        scene = sar_r()
        dry = np.abs(scene.record()).max()
        scene.atmosphere.rain_mm_per_h = 100
        scene.atmosphere.rain_top = "5 km"
        self.assertEqual(scene["Atmosphere.rain.rate"], 100.0)
        self.assertLess(np.abs(scene.record()).max(), 0.99 * dry)
        self.assertIn("rain", " ".join(scene.atmosphere.fields()))

    def test_reading_says_what_is_odd_with_the_files_of_a_scene(self):
        (self.folder / "points.csv").write_text("x,y,z,rcs\n0,0,0,1\n5,0,0,-1\n", encoding="ascii")
        text = (EXAMPLES / "sar_r.toml").read_text(encoding="utf-8") + '\n[[target]]\npositions = { file = "points.csv" }\n'
        (self.folder / "s.toml").write_text(text, encoding="utf-8")
        for scene in (sarsim.read(self.folder / "s.toml"), sarsim.Scene(text, name=str(self.folder / "s.toml"))):
            self.assertEqual(str(scene.remarks).count("cross-sections are negative"), 1)
            self.assertEqual(str(scene.check()).count("cross-sections are negative"), 1)

    def test_a_problem_of_an_added_object_says_which(self):
        scene = sar_r()
        scene.targets.add_many([[0, 0, 0], [float("nan"), 0, 0]])
        self.assertRegex(str(scene.check()), "error: target 26: the position is not made of finite numbers")

    def test_fields_are_numbers_in_base_units_and_take_texts(self):
        scene = sar_r()
        radar = scene.radars["Radar1"]
        radar.carrier = "9.65 GHz"
        self.assertEqual(radar.carrier, 9.65e9)
        self.assertEqual(scene.number("Radar1.carrier_hz"), 9.65e9)
        with self.assertRaisesRegex(sarsim.ProblemError, "Radar1.carrier: nan is not a finite number"):
            radar.carrier = float("nan")
        radar.power = 2000
        self.assertEqual(scene.get("Radar1.power"), "2 kW")
        radar.beam_elevation = "-0.2 rad"
        self.assertAlmostEqual(radar.beam_elevation, np.degrees(-0.2), 12)
        self.assertIs(radar.same_antenna, True)
        radar.same_antenna = False
        radar.receive_antenna.pattern = "isotropic"
        self.assertEqual(radar.receive_antenna.pattern, "isotropic")
        radar.pulse = "barker"
        radar.barker_code = "7"
        self.assertEqual((radar.pulse, radar.barker_code), ("barker", "7"))
        self.assertEqual(radar["pulse.width"], radar.pulse_width)
        scene.options.seed = 2**63 + 1
        self.assertEqual(scene.options.seed, 2**63 + 1)

    def test_words_are_those_that_can_be_set(self):
        scene = sar_r()
        for kind, one in (("platforms", scene.platforms[0]), ("radars", scene.radars[0]), ("recordings", scene.recordings[0])):
            for name in one.fields():
                words = getattr(getattr(type(one), name.partition(".")[0], None), "words", None)
                if words and name != "carrier":
                    with self.subTest(kind, name=name):
                        self.assertIn(getattr(one, name), words)

    def test_vectors_are_arrays_and_set_as_a_whole(self):
        scene = sar_r()
        target = scene.targets[0]
        target.position = [1, "2 km", -3.5]
        np.testing.assert_array_equal(target.position, [1, 2000, -3.5])
        with self.assertRaises(ValueError):
            target.position[0] = 5
        with self.assertRaises(sarsim.ProblemError):
            target.position = [7, "8 parsec", 9]
        np.testing.assert_array_equal(target.position, [1, 2000, -3.5])
        with self.assertRaisesRegex(ValueError, "three values"):
            target.position = [1, 2]

    def test_an_unknown_name_says_the_nearest(self):
        radar = sar_r().radars[0]
        with self.assertRaisesRegex(AttributeError, "did you mean bandwidth") as raised:
            radar.bandwith = 3
        self.assertEqual(raised.exception.problems[0].severity, "error")
        with self.assertRaisesRegex(sarsim.ProblemError, "did you mean bandwidth"):
            radar.bandwith
        self.assertFalse(hasattr(radar, "_anything"))
        self.assertIn("transmit_antenna", dir(radar))
        self.assertIn("Swept over the pulse width", type(radar).bandwidth.__doc__)

    def test_problems_have_their_places(self):
        with self.assertRaises(sarsim.ProblemError) as raised:
            sarsim.Scene('format = "sarsim 2"\n[[radar]]\npower = "3 km"\n', name="wrong.toml")
        problem = raised.exception.problems.errors[0]
        self.assertEqual((problem.file, problem.line), ("wrong.toml", 3))
        self.assertIn("wrong.toml:3:", str(problem))
        self.assertIn("wrong.toml:3:", raised.exception._repr_html_())
        found = sar_r().check()
        self.assertEqual([], found.errors)
        self.assertIn(repr(found.notes[0]).splitlines()[0], command("check", EXAMPLES / "sar_r.toml") )

    def test_objects_are_found_added_and_removed(self):
        scene = sar_r()
        self.assertEqual((len(scene.targets), scene.radars.names), (24, ["Radar1"]))
        self.assertEqual(scene.targets[-1], scene.targets["Target24"])
        with self.assertRaises(KeyError):
            scene.radars["Radar2"]
        with self.assertRaises(IndexError):
            scene.radars[1]
        new = scene.targets.add(position=(1, 2, 3), rcs="10 dBsm")
        self.assertAlmostEqual(new.rcs, 10.0)
        with self.assertRaises(AttributeError):
            scene.targets.add(colour=3)
        self.assertEqual(len(scene.targets), 25)
        scene.targets.remove(new)
        del scene.targets[0]
        self.assertEqual(len(scene.targets), 23)
        scene.radars.remove("Radar1")
        self.assertEqual(len(scene.recordings), 0)

    def test_texts_pickles_and_copies_are_the_scene(self):
        scene = sar_r()
        scene.radars[0].power = "3 kW"
        for other in (pickle.loads(pickle.dumps(scene)), copy.deepcopy(scene), sarsim.Scene(scene.text())):
            self.assertEqual(other, scene)
            other.radars[0].power = 1
            self.assertNotEqual(other, scene)
        scene.write(self.folder / "a.scr")
        self.assertEqual(sarsim.read(self.folder / "a.scr").radars[0].power, 3000)
        varied = scene.with_({"Target*.rcs": 5.0}, seed=7)
        self.assertEqual((varied.targets[3].rcs, varied.options.seed, scene.options.seed), (5, 7, 1))
        self.assertEqual(eval(repr(scene.targets.names)), scene.targets.names)

    def test_names_of_let_take_values(self):
        text = 'format = "sarsim 2"\n[let]\nup = "1 km"\n[[platform]]\nname = "P"\nposition = [0, 0, "2 * up"]\n'
        self.assertEqual(sarsim.Scene(text, let={"up": "3 km"}).platforms["P"].position[2], 6000)

    def test_a_library_that_is_not_there_is_told(self):
        environment = {**os.environ, "SARSIM_LIBRARY": str(self.folder / "libsarsim.so.0")}
        done = subprocess.run([sys.executable, "-c", "import sarsim"], capture_output=True, text=True, env=environment)
        self.assertRegex(done.stderr, "ImportError: sarsim needs its library: .*Install the package libsarsim0")
        self.assertEqual(done.returncode, 1)

    def test_notebooks_show_things(self):
        scene = sar_r()
        self.assertIn("24", scene._repr_html_())
        self.assertIn("5.3 GHz", scene.radars[0]._repr_html_())
        self.assertEqual(repr(scene.radars[0]), "<Radar Radar1>")
        self.assertIn("bandwidth", sarsim.explain("radar.pulse"))


class Recordings(Folder):
    def test_samples_are_those_of_the_command(self):
        for example in ("sar_r.toml", "barker_chirp.toml", "stepped_srp.toml"):
            for dtype, words in ((np.complex64, ()), (np.complex128, ("--double",))):
                with self.subTest(example, dtype=dtype):
                    out = self.folder / f"{example}{dtype.__name__}"
                    command("run", EXAMPLES / example, "1", "--quiet", "--format", "npy", "--out", out, *words)
                    expected = np.load(next(out.glob("*.npy")))
                    made = sarsim.read(EXAMPLES / example).record(dtype=dtype, threads=2)
                    self.assertEqual(made.dtype, dtype)
                    np.testing.assert_array_equal(made, expected)

    def test_files_are_those_of_the_command(self):
        command("run", EXAMPLES / "sar_r.toml", "--quiet", "--out", self.folder)
        report = sar_r().record_file(self.folder / "own.h5")
        self.assertEqual((self.folder / "own.h5").read_bytes(), (self.folder / "sar_r.h5").read_bytes())
        self.assertEqual(report.bytes, (self.folder / "own.h5").stat().st_size)
        with self.assertRaisesRegex(sarsim.ProblemError, "exists"):
            sar_r().record_file(self.folder / "own.h5")
        with self.assertRaises(OSError):
            sar_r().record_file("/proc/none/own.h5")

    def test_blocks_of_rows_are_the_whole(self):
        scene = sar_r()
        whole = scene.record()
        blocks = list(scene.rows(block=500))
        self.assertEqual([first for first, _ in blocks], [0, 500, 1000])
        np.testing.assert_array_equal(np.concatenate([rows for _, rows in blocks]), whole)

    def test_axes_say_where_samples_are(self):
        recording = sar_r().record("sar_r.h5")
        self.assertEqual(recording.dims, ("pulse_time_s", "slant_range_m"))
        np.testing.assert_allclose(recording.pulse_time_s, -0.5 + np.arange(1240) / 620, atol=1e-12)
        np.testing.assert_allclose(np.diff(recording.slant_range_m), 299792458 / 150e6 / 2)
        np.testing.assert_allclose(recording.platform_velocity_mps[:, 0], -200, atol=1e-9)
        self.assertEqual(recording.platform_position_m.shape, (1240, 3))
        self.assertIn("slant_range_m", dir(recording))
        with self.assertRaisesRegex(AttributeError, "its axes are pulse_time_s"):
            recording.height_m
        self.assertEqual(recording[3:5].shape, (2, 500))
        self.assertEqual(recording.db().max(), 0.0)
        self.assertIn("data:image/png", recording._repr_html_())

    def test_a_picture_is_a_png_of_the_magnitudes(self):
        class Ramp(sarsim.Samples):
            samples = np.outer([1.0, 0.1], [1.0, 0.01, 1.0])

        png = Ramp([], {}).picture(span_db=40, width=3, height=2).png
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        chunks, place = {}, 8
        while place < len(png):
            length, name = struct.unpack(">I4s", png[place : place + 8])
            body = png[place + 8 : place + 8 + length]
            self.assertEqual(struct.unpack(">I", png[place + 8 + length :][:4])[0], zlib.crc32(name + body))
            chunks[name], place = body, place + 12 + length
        self.assertEqual(struct.unpack(">II", chunks[b"IHDR"][:8]), (3, 2))
        # -20 dB of 40 is half; late rows are at the top; each row begins with a 0.
        self.assertEqual(list(zlib.decompress(chunks[b"IDAT"])), [0, 128, 0, 128, 0, 255, 0, 255])
        wide = Ramp([], {}).picture(width=2, height=1).levels
        self.assertEqual(wide.tolist(), [[255, 255]])
        self.assertEqual(Ramp([], {}).picture(width=8, height=4).levels.shape, (4, 6))

    def test_own_arrays_are_what_the_scene_language_says(self):
        """A chirp, a track and targets as arrays give the echoes of those that the language has words for."""
        scene = sar_r()
        radar = scene.radars[0]
        expected = scene.record().samples
        fraction = np.linspace(0, 1, 4001)
        turns = radar.bandwidth * radar.pulse_width * (fraction - 0.5) ** 2 / 2
        own = scene.copy()
        own.radars[0].pulse = "points"
        own.radars[0].pulse_iq = fraction, np.exp(2j * np.pi * turns)
        time_s = np.array([-1.0, 2.0])
        own.platforms[0].trajectory = sarsim.Points(
            time_s, np.column_stack([100 - 200 * time_s, np.full(2, -10000.0), np.full(2, 2000.0)]), "linear"
        )
        positions = np.array([target.position for target in scene.targets])
        for target in list(own.targets)[::-1]:
            own.targets.remove(target)
        own.targets.add_many(positions[:10], 1.0)
        own.clouds.add_points(positions[10:], np.ones(14))
        made = own.record().samples
        self.assertLess(np.abs(made - expected).max(), 2e-3 * np.abs(expected).max())
        # The points of the cloud come with the file.
        with self.assertRaisesRegex(TypeError, "in memory alone"):
            pickle.dumps(own)
        own.write(self.folder / "own.toml")
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(sarsim.read(self.folder / "own.toml"))).record(), made)
        with self.assertRaisesRegex(ValueError, r"expected \(n, 3\)"):
            own.targets.add_many(np.zeros((3, 2)))
        with self.assertRaisesRegex(ValueError, "expected"):
            sarsim.Points([0, 1], [1, 2, 3])

    def test_nothing_is_printed(self):
        with warnings.catch_warnings(), contextlib.redirect_stdout(io.StringIO()) as out:
            warnings.simplefilter("error")
            with contextlib.redirect_stderr(io.StringIO()) as err:
                recording = sar_r().record()
        self.assertEqual(out.getvalue() + err.getvalue(), "")
        self.assertIn("Doppler band", str(recording.remarks))

    def test_progress_comes_to_its_end(self):
        seen = []
        sar_r().record(progress=lambda *far: seen.append(far))
        stage, done, total = seen[-1]
        self.assertEqual(done, total)
        with contextlib.redirect_stderr(io.StringIO()) as err:
            sar_r().record(progress=True)
        self.assertIn("100", err.getvalue())


class Images(Folder):
    def test_a_file_of_a_standard_is_that_of_the_command(self):
        scene = EXAMPLES.parent / "tests" / "exchange" / "small_scene.toml"
        words = ("--anchor", "47.5,8.25,400", "--encoding", "ci2")
        command("convert", scene, self.folder / "command.cphd", *words)
        (self.folder / "python").mkdir()
        path = self.folder / "python" / "command.cphd"
        told = sarsim.export(sarsim.read(scene), path, anchor="47.5,8.25,400", encoding="ci2")
        self.assertEqual(path.read_bytes(), (self.folder / "command.cphd").read_bytes())
        self.assertEqual(told["vectors"], len(sarsim.read(scene).record().pulse_time_s))
        with self.assertRaisesRegex(sarsim.ProblemError, "is not the name of a CPHD or CRSD file"):
            sarsim.export(sarsim.read(scene), self.folder / "a.h5", anchor="47.5,8.25,400")

    def test_an_image_is_that_of_the_command(self):
        command("run", EXAMPLES / "sar_r.toml", "--quiet", "--out", self.folder)
        words = ("--algorithm", "omega-k", "--azimuth-window", "hann")
        command("focus", self.folder / "sar_r.h5", "--quiet", "--out", self.folder / "a.npy", *words)
        expected = np.load(self.folder / "a.npy")
        recording = sar_r().record()
        for source in (recording, self.folder / "sar_r.h5", sarsim.open(self.folder / "sar_r.h5")):
            image = sarsim.focus(source, algorithm="omega-k", azimuth_window="hann")
            self.assertEqual((image.report["algorithm"], image.dims[0]), ("omega-k", "azimuth_m"))
            np.testing.assert_array_equal(image, expected)
        image.save(self.folder / "b.npy")
        np.testing.assert_array_equal(np.load(self.folder / "b.npy"), expected)

    def test_targets_are_where_theory_has_them(self):
        table = sarsim.focus(sar_r().record(dtype=np.complex128)).measure()
        self.assertEqual(len(table), 24)
        self.assertLess(np.abs(table["azimuth_error_m"]).max(), 0.1)
        self.assertLess(np.abs(table["range_error_m"]).max(), 0.1)
        theory = sarsim.theory(sar_r())
        np.testing.assert_allclose(theory["range_m"], table["theory_range_m"], rtol=1e-9)
        self.assertEqual(np.asarray(table)["target"][3], table["target"][3])
        self.assertIn("azimuth_error_m", table._repr_html_())
        with self.assertRaisesRegex(KeyError, "there is target"):
            table["colour"]

    def test_windows_of_files_are_parts_of_the_whole(self):
        sar_r().record_file(self.folder / "a.h5")
        file = sarsim.open(self.folder / "a.h5")
        whole = sar_r().record().samples
        self.assertEqual((file.shape, file.format), (whole.shape, "hdf5"))
        np.testing.assert_array_equal(file.window(slice(10, 20), slice(None, None, 7)), whole[10:20, ::7])
        np.testing.assert_array_equal(file, whole)
        self.assertEqual(file.attributes["radar"], "Radar1")

    def test_arrays_become_files(self):
        recording = sar_r().record()
        recording.samples[:] *= 2
        recording.save(self.folder / "own.h5")
        again = sarsim.open(self.folder / "own.h5")
        np.testing.assert_array_equal(again, recording)
        np.testing.assert_array_equal(again.slant_range_m, recording.slant_range_m)
        np.testing.assert_array_equal(again.pulse_time_s, recording.pulse_time_s)
        image, twice = sarsim.focus(sar_r().record()), sarsim.focus(again)
        np.testing.assert_allclose(twice.samples, 2 * image.samples, atol=1e-6 * np.abs(image.samples).max())
        own = sarsim.Raster.of(np.arange(6.0).reshape(2, 3), {"x_m": [0, 2, 4], "y_m": [1, 2]})
        self.assertEqual((own.dims, own.dtype), (("y_m", "x_m"), np.float32))
        own.save(self.folder / "own.npy")
        with self.assertRaises(sarsim.ProblemError):
            sarsim.Raster.of(np.zeros((2, 3)), {"x_m": [1, 2]})

    def test_options_that_mean_nothing_are_told(self):
        with self.assertRaises(sarsim.ProblemError):
            sarsim.focus(sar_r(), algorithm="omega")
        with self.assertRaises(sarsim.ProblemError):
            sarsim.focus(sar_r(), algorithms="omega-k")
        self.assertIn("algorithm", sarsim.options("focus"))

    def test_geometry_is_that_of_the_axes(self):
        table = sarsim.geometry(sar_r(), radar="Radar1", start=-0.5, end=0.5)
        self.assertEqual(len(table), 621)


class Interrupts(unittest.TestCase):
    """Ctrl-C at any time: raised, soon, once, and the library goes on."""

    def test_interrupts_arrive(self):
        scene = sar_r()
        expected = scene.record().samples
        scene.targets.add_many(np.random.default_rng(1).uniform(0, 100, (3000, 3)))
        late = []
        for number in range(15):
            begun = time.process_time()
            delay = 0.003 + 0.003 * number
            signal.signal(signal.SIGPROF, signal.default_int_handler)
            with self.assertRaises(KeyboardInterrupt):
                signal.setitimer(signal.ITIMER_PROF, delay)  # Of processor time.
                while True:
                    scene.record(progress=(lambda *far: None) if number % 2 else None)
            late.append(time.process_time() - begun - delay)
        self.assertLess(np.median(late), 0.2, late)
        self.assertEqual(threading.active_count(), 1)
        np.testing.assert_array_equal(sar_r().record(), expected)

    def test_an_exception_of_progress_stops_the_work(self):
        scene = sar_r()
        scene.targets.add_many(np.zeros((3000, 3)))

        def fail(stage, done, total):
            raise ZeroDivisionError

        with self.assertRaises(ZeroDivisionError):
            scene.record(progress=fail)

    def test_handles_are_given_back(self):
        scene = sar_r()

        def memory_kb():
            return 4 * int(pathlib.Path("/proc/self/statm").read_text().split()[1])

        def work(times):
            for _ in range(times):
                other = scene.copy()
                other.radars[0].power = 3
                with self.assertRaises(sarsim.ProblemError):
                    other.set("Radar1.powr", "3")

        work(200)
        before = memory_kb()
        work(1000)
        self.assertLess(memory_kb() - before, 1000)


class Together(Folder):
    """Many at a time: threads, processes, sweeps."""

    def test_a_table_of_a_sweep_is_that_of_the_command(self):
        words = ("--set", "Radar1.power=1,2,4kW", "--discard", "--quiet")
        command("sweep", EXAMPLES / "sar_r.toml", *words, "--out", self.folder / "command")
        table = sarsim.sweep_table(sar_r(), set=["Radar1.power=1,2,4kW"], discard=True, out=self.folder / "own")
        np.testing.assert_allclose(table["maximum_v"] / table["maximum_v"][0], np.sqrt([1, 2, 4]), rtol=1e-6)
        with open(self.folder / "command" / "sweep.csv", encoding="utf-8") as file:
            names, first = file.readline().strip().split(","), file.readline().strip().split(",")
        self.assertEqual(table.names, names)
        self.assertEqual(table["maximum_v"][0], float(first[names.index("maximum_v")]))

    def test_eight_threads_record_different_scenes(self):
        scenes = [sar_r().with_({"Radar1.power": 100.0 * (1 + number)}) for number in range(8)]
        expected = [scene.record(threads=1).samples for scene in scenes]
        with ThreadPoolExecutor(8) as pool:
            for recording, samples in zip(pool.map(lambda scene: scene.record(threads=1), scenes), expected):
                np.testing.assert_array_equal(recording, samples)

    def test_python_runs_while_the_library_works(self):
        scene = sar_r()
        scene.targets.add_many(np.random.default_rng(1).uniform(0, 100, (20000, 3)))
        steps = []
        worker = threading.Thread(target=lambda: steps.append(scene.record(threads=1)))
        worker.start()
        count = 0
        while worker.is_alive():
            count += 1
            time.sleep(0.001)
        self.assertGreater(count, 20)

    def test_a_sweep_is_what_each_variation_gives(self):
        scene = sar_r()
        values = {"Radar1.power": [100.0, 400.0], "Target*.rcs": [1.0, 2.0, 4.0]}
        alone = sarsim.sweep(scene, values, power_at)
        self.assertEqual(alone.shape, (2, 3))
        whole = np.asarray(alone)
        np.testing.assert_allclose(whole[1], 4 * whole[0], rtol=1e-6)
        np.testing.assert_allclose(whole[:, 2], 4 * whole[:, 0], rtol=1e-6)
        with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
            np.testing.assert_array_equal(sarsim.sweep(scene, values, power_at, executor=pool), whole)
        fields, energy = next(iter(alone))
        self.assertEqual((fields, energy), ({"Radar1.power": 100.0, "Target*.rcs": 1.0}, whole[0, 0]))


class OtherPackages(Folder):
    """With packages that the Python package knows but does not need."""

    def test_xarray_has_the_axes(self):
        try:
            import xarray  # noqa: F401
        except ImportError:
            self.skipTest("no xarray")
        array = sar_r().record().to_xarray()
        self.assertEqual(array.dims, ("pulse_time_s", "slant_range_m"))
        self.assertEqual(array.slant_range_m.attrs["units"], "m")
        near = array.sel(slant_range_m=10100, method="nearest")
        self.assertLess(abs(float(near.slant_range_m) - 10100), 0.5)

    def test_dask_gives_the_same_numbers(self):
        try:
            from dask.distributed import Client
        except ImportError:
            self.skipTest("no Dask (Debian: python3-distributed)")
        values = {"Radar1.power": [100.0, 400.0]}
        with Client(processes=False, n_workers=1, threads_per_worker=2, dashboard_address=None) as client:
            made = np.asarray(sarsim.sweep(sar_r(), values, power_at, executor=client))
        np.testing.assert_array_equal(made, sarsim.sweep(sar_r(), values, power_at))


if __name__ == "__main__":
    unittest.main()
