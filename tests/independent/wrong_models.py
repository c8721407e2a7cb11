"""Models with one rule wrong each: the comparison has to find every one of them, or it proves nothing."""

import dataclasses
import tempfile
import unittest

import numpy as np

import light_time
import scenes
from curves import Curve
from long_pulses import CASES, long_pulse
from model import Model
from random_scenes import random_scene
from running import TOLERANCE, allowed_for, error_of, reason_to_leave_out, simulated


def telling_scene(**changes):
    """One that shows every rule that a wrong model breaks: all moves and turns, and echoes lie within the swath."""
    aircraft = scenes.Platform(
        "Aircraft", trajectory=flight((0, 90), (0, 120), (500, -4)), aligned=True, rotation=(3, -4, 60)
    )
    ship = scenes.Platform(
        "Ship", trajectory=flight((300, 60), (4000, -90), (100, 5)), aligned=True, rotation_rate=(9, -20, 40)
    )
    targets = [
        scenes.Target("Ship", (30.0, -20.0, 5.0), 3.0, (170.0, 4.0)),
        scenes.Target(
            "Earth", (250.0, 3990.0, 60.0), 2.0, (-175.0, 5.0), Curve("CUBIC", [(0, 1), (30, -2), (90, -20)])
        ),
    ]
    radar = scenes.Radar(
        "Aircraft",
        scenes.Pulse("CHIRP", 1500.0, 0.03, envelope="LINEAR", rise_ns=200.0, fall_ns=100.0),
        prf_hz=321.0,
        carrier=scenes.Carrier("STEPPED", 5.0, 0.02, 4, 1),
        transmit=scenes.Antenna("SINX", 20.0, 30.0),
        beam=scenes.Beam("SPOT", point=(200.0, 4000.0, 80.0)),
        window=scenes.Window("HAMMING"),
    )
    recording = scenes.Recording(3700.0, 4400.0, 0.1, 0.135, 0.05)
    scene = scenes.Scene("physical", [scenes.Platform("Earth"), aircraft, ship], targets, radar, recording)
    for name, value in changes.items():
        owner = radar if hasattr(radar, name) else recording if hasattr(recording, name) else scene
        setattr(owner, name, value)
    return scene


def flight(*axes):
    """A path that bends, by the place and the speed at its beginning of each axis."""
    knots = (0.0, 0.1, 0.2)
    return [
        Curve("CUBIC", [(t, start + speed * t + 20 * axis * t * t) for t in knots])
        for axis, (start, speed) in enumerate(axes, 1)
    ]


STILL = [np.zeros((3, 3))] * 2


class LateByAPicosecond(Model):
    def echo(self, target, number):
        echo = super().echo(target, number)
        return echo._replace(delay_s=echo.delay_s + 1e-12)


class WithoutLightTime(Model):
    """As the thesis prints it at 6.18."""

    def echo(self, target, number):
        echo = super().echo(target, number)
        return echo._replace(delay_s=echo.delay_s / (1 + echo.doppler / 2))


class WithoutDopplerInThePulse(Model):
    def echo(self, target, number):
        return super().echo(target, number)._replace(doppler=0.0)


class DopplerTheOtherWay(Model):
    def echo(self, target, number):
        echo = super().echo(target, number)
        return echo._replace(doppler=-echo.doppler)


class WithoutTurningOfTargets(Model):
    """Speed of a point of a platform without that of its rotation."""

    def motion(self, platform, time, orders=3):
        pose = super().motion(platform, time, orders)
        return pose._replace(world_from_platform=[pose.world_from_platform[0], *STILL][:orders])


class WithoutTurningOfThePath(Model):
    """An aligned platform whose turning along its path moves no point."""

    def alignment(self, path):
        return [[angle[0], *[0.0] * (len(angle) - 1)] for angle in super().alignment(path)]


class NextCarrier(Model):
    def carrier(self, number):
        return super().carrier(number + 1)


class FirstWavelength(Model):
    """Amplitudes with the wavelength of the first carrier."""

    def amplitude(self, carrier, antennas, cross_section, distance):
        return super().amplitude(self.carrier(0), antennas, cross_section, distance)


class OneWayAntenna(Model):
    def amplitude(self, carrier, antennas, cross_section, distance):
        return super().amplitude(carrier, np.sqrt(np.abs(antennas)), cross_section, distance)


class HalfOfAnAntenna(Model):
    """Takes the magnitude of an angle."""

    def antenna_factor(self, antenna, azimuth, elevation):
        return super().antenna_factor(antenna, abs(azimuth), abs(elevation))


class WithoutDirection(Model):
    def cross_section(self, target, look, target_motion):
        return target.cross_section


class LightOfTheOtherProfile(Model):
    def __init__(self, scene):
        super().__init__(scene)
        self.light_speed += 42


class LastPulseLeftOut(Model):
    def pulses(self):
        return super().pulses()[:-1]


class WindowOfHalfAPercentMore(Model):
    def window(self, x):
        return super().window(x) + 0.005


class WithoutSensitivityTimeControl(Model):
    def stc_gain(self, slant_range):
        return self.recording.far_m**2


class BeamOfThePlatform(Model):
    """Where the beam's yaw does not follow the aligned platform."""

    def motion(self, platform, time, orders=3):
        motion = super().motion(platform, time, orders)
        carries_radar = platform.name == self.radar.platform
        return motion._replace(world_from_platform=[np.eye(3), *STILL][:orders]) if carries_radar else motion


class LegHomeToWhereItWasSent(Model):
    """Without the way that the radar flies while its pulse is in the air."""

    def flight(self, target, send_time):
        radar, carrying = self.platform(self.radar.platform), self.platform(target.platform)
        begin, sent = np.longdouble(send_time), self.motion(radar, np.longdouble(send_time)).place
        return light_time.flight(
            lambda time, orders: sent[:orders] if time == begin else [sent[0], *self.motion(radar, time, orders).place[1:]],
            lambda time, orders: self.motion(carrying, time, orders).of(target.position),
            begin,
            np.longdouble(self.light_speed),
        )


class TargetWhereItWas(Model):
    """With the target's place when the pulse was sent."""

    def flight(self, target, send_time):
        radar, carrying = self.platform(self.radar.platform), self.platform(target.platform)
        begin = np.longdouble(send_time)
        point = self.motion(carrying, begin).of(target.position)
        return light_time.flight(
            lambda time, orders: self.motion(radar, time, orders).place,
            lambda time, orders: point,
            begin,
            np.longdouble(self.light_speed),
        )


class WithoutAcceleration(Model):
    def echo(self, target, number):
        return super().echo(target, number)._replace(acceleration=0.0)


class SweepOfTheThesis(Model):
    """Whose sweep is changed once by the Doppler factor instead of twice."""

    def turns(self, echo, carrier, after_middle):
        more = self.shape.sweep_rate * after_middle**2 / 2
        return super().turns(echo, carrier, after_middle) - float(echo.doppler) * more


class LeadingEdgeAtTheSendTime(Model):
    """Which reads t(n) as the time at which the pulse begins."""

    def flight(self, target, send_time):
        return super().flight(target, send_time + self.shape.width_s / 2)


LOPSIDED = scenes.Antenna(
    "OTHER",
    azimuth_cut=Curve("CUBIC", [(-9, -20), (-3, -9), (0, 0), (4, -3), (9, -4)]),
    elevation_cut=Curve("LINEAR", [(-2, -20), (0, 0), (2, -3)]),
)
FIXED_BEAM = scenes.Beam("FIXED", -5.0, -6.0)
WRONG_IN_RAW = (
    LateByAPicosecond,
    WithoutLightTime,
    WithoutDopplerInThePulse,
    DopplerTheOtherWay,
    WithoutTurningOfTargets,
    WithoutTurningOfThePath,
    NextCarrier,
    FirstWavelength,
    OneWayAntenna,
    WithoutDirection,
    LightOfTheOtherProfile,
    LastPulseLeftOut,
)
WRONG_ELSEWHERE = (
    (WindowOfHalfAPercentMore, {"processing": "MATCHED_FILTER"}),
    (WindowOfHalfAPercentMore, {"processing": "SRP"}),
    (WithoutSensitivityTimeControl, {"stc": "1OVERR4"}),
    (BeamOfThePlatform, {"beam": FIXED_BEAM}),
    (HalfOfAnAntenna, {"transmit": LOPSIDED}),
    (LightOfTheOtherProfile, {"profile": "classic"}),
)

WRONG_IN_LONG_PULSES = (
    (LegHomeToWhereItWasSent, "satellite, squint 20 deg, X, 1.2 GHz, 50 us"),
    (TargetWhereItWas, "missile 2 km/s, X, 1 GHz, 100 us"),
    (WithoutAcceleration, "car 30 m/s passing at 5 m, 77 GHz, 150 MHz, 1 ms"),
    (SweepOfTheThesis, "aircraft 300 m/s, X, 500 MHz, 100 us"),
    (LeadingEdgeAtTheSendTime, "satellite, squint 20 deg, X, 1.2 GHz, 50 us"),
)


def features(scene):
    """Words of the language that a scene uses."""
    radar, recording = scene.radar, scene.recording
    antennas = {f"antenna {antenna.kind}" for antenna in (radar.transmit, radar.receive) if antenna}
    laws = {
        "ISOTROPIC" if t.normal_deg is None else "OTHER_GAIN" if t.reflectivity else "COS_GAIN" for t in scene.targets
    }
    platforms = {f"aligned {platform.aligned}" for platform in scene.platforms if platform.trajectory}
    return {
        scene.profile,
        f"pulse {radar.pulse.kind}",
        f"envelope {radar.pulse.envelope}",
        f"band-limited {radar.pulse.band_limited} {radar.pulse.oversampling > 1}",
        f"intervals {radar.intervals is not None}",
        f"carrier {radar.carrier.kind}",
        f"beam {radar.beam.kind}",
        f"STC {radar.stc} {scene.profile}",
        f"{recording.processing} {scene.profile}",
        recording.pulse_position,
        *([f"window {radar.window.kind}"] if recording.processing != "RAW" else []),
        *antennas,
        *laws,
        *platforms,
    }


class SceneDraw(unittest.TestCase):
    def test_the_sixty_scenes_of_the_suite_use_all_that_others_do(self):
        of_scene = [features(random_scene(number)) for number in range(1, 111)]
        used, every = set.union(*of_scene[:60]), set.union(*of_scene)
        self.assertEqual(sorted(every - used), [])
        self.assertGreater(len(every), 45)
        print(f"{len(every)} features")


class WrongModels(unittest.TestCase):
    """What differs from the program has to be told, and by more than any engine may differ."""

    def errors(self, models, **changes):
        scene = telling_scene(**changes)
        with tempfile.TemporaryDirectory(prefix="sarsim-independent-") as folder:
            samples = simulated(scene, "reference", folder)
        return [error_of(samples, model(scene).samples()) for model in models]

    def test_the_right_model_agrees_and_wrong_ones_do_not(self):
        right, *wrong = self.errors((Model, *WRONG_IN_RAW))
        self.assertLessEqual(right, allowed_for(Model(telling_scene()), "reference"))
        for model, error in zip(WRONG_IN_RAW, wrong):
            with self.subTest(model=model.__name__):
                print(f"{model.__name__}: {error:.1e}")
                self.assertGreater(error, 10 * allowed_for(Model(telling_scene()), "auto"))

    def test_wrong_processing_beams_and_profiles_are_found(self):
        for model, changes in WRONG_ELSEWHERE:
            with self.subTest(model=model.__name__, changes=changes):
                right, wrong = self.errors((Model, model), **changes)
                print(f"{model.__name__} ({', '.join(changes)}): {wrong:.1e}")
                self.assertLessEqual(right, allowed_for(Model(telling_scene(**changes)), "reference"))
                self.assertGreater(wrong, 10 * allowed_for(Model(telling_scene()), "auto"))

    def test_wrong_light_times_are_found(self):
        for model, case in WRONG_IN_LONG_PULSES:
            with self.subTest(model=model.__name__), tempfile.TemporaryDirectory() as folder:
                scene = long_pulse(*CASES[case], "BEGIN")
                samples = simulated(scene, "reference", folder)
                right, wrong = (error_of(samples, kind(scene).samples()) for kind in (Model, model))
                print(f"{model.__name__} ({case}): {wrong:.1e}, right {right:.1e}")
                self.assertLessEqual(right, allowed_for(Model(scene), "reference"))
                self.assertGreater(wrong, 30 * right)

    def test_echoes_of_other_pulses_are_those_of_their_own_rows(self):
        scene = telling_scene(carrier=scenes.Carrier("SINGLE", 5.0), prf_hz=40000.0, end_s=0.1001)
        alone, recording = Model(scene), dataclasses.replace(scene.recording, other_pulses=True)
        model = Model(dataclasses.replace(scene, recording=recording))
        times = np.arange(5e-7, 6e-5, 1e-7)
        expected = sum(alone.received(m, times + (4001 - m) / 40000.0, 2e-8) for m in range(3998, 4004))
        found = model.received(4001, times, 2e-8)
        self.assertGreater(error_of(found, alone.received(4001, times, 2e-8)), 0.5)
        self.assertLess(error_of(found, expected), 1e-9)

    def test_samples_of_another_shape_or_without_numbers_are_no_agreement(self):
        self.assertEqual(error_of(np.ones((2, 3)), np.ones((2, 4))), np.inf)
        self.assertEqual(error_of(np.array([[np.nan, 1]]), np.ones((1, 2))), np.inf)

    def test_one_wrong_sample_is_found(self):
        expected = Model(telling_scene()).samples()
        samples = expected.copy()
        samples[3, 7] += 3e-7 * np.abs(expected).max()
        self.assertGreater(error_of(samples, expected), TOLERANCE["reference"])

    def test_scenes_without_echoes_are_left_out(self):
        self.assertEqual(reason_to_leave_out(np.zeros((2, 3))), "no echo in the window")
        self.assertEqual(reason_to_leave_out(np.full((2, 3), 1e-33)), "at the end of single precision")
        self.assertIsNone(reason_to_leave_out(np.full((2, 3), 1e-20)))

    def test_a_scene_that_the_program_refuses_is_a_failure(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaises(RuntimeError):
            simulated(telling_scene(prf_hz=-1.0), "reference", folder)
