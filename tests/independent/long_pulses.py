"""Long pulses of fast targets against the light-time equation of every sample, solved without any expansion.

What is received at a time was sent when send time and light time add up to it (docs/theory/echo-model.md, 3). This is
what t(n), BEGIN and CENTRE, the Doppler factor and the acceleration within the pulse have to agree with.
"""

import functools
import tempfile
import unittest

import numpy as np

import light_time
import scenes
from curves import Curve
from model import Model
from running import simulated

HALF_PULSES = 1.01  # Samples farther from an echo's middle, in half pulses, are left out.


class EmissionModel(Model):
    """Finds for each sample when it was sent, in 80 bits."""

    def received(self, number, times, interval_s):
        after_send, samples = self.after_send(times), np.zeros(times.shape, complex)
        for target in self.scene.targets:
            echo = self.echo(target, number)
            near = np.abs(after_send - echo.delay_s) < HALF_PULSES * self.shape.width_s / 2
            arrivals = after_send[near].astype(np.longdouble)
            sent = np.array([self.sent(target, number, arrival) for arrival in arrivals])
            cycles = np.fmod(self.carrier(number) * (sent - arrivals), 1).astype(float)
            pulse = self.shape.transmitted(sent.astype(float) + self.shape.width_s / 2, interval_s)
            samples[near] += echo.amplitude * pulse * np.exp(2j * np.pi * cycles)
        return samples

    def sent(self, target, number, arrival):
        """When, counted from t(n), left what arrives at a time counted from there."""
        begin = np.longdouble(self.send_time(number))
        radar, carrying = self.platform(self.radar.platform), self.platform(target.platform)

        def delay(sent):
            return light_time.times_of_flight(
                lambda time: self.motion(radar, time, 1).place[0],
                lambda time: self.motion(carrying, time, 1).of(target.position)[0],
                begin + sent,
                np.longdouble(self.light_speed),
            )[1]

        return light_time.settled(lambda sent: arrival - delay(sent), np.longdouble(0))


def straight(place, velocity):
    return [Curve("LINEAR", [(0, p), (1, p + v)]) for p, v in zip(place, velocity)]


def circle(radius, speed):
    """A circular orbit about (0, 0, -Earth's radius), by points so close that the spline between them is smooth."""
    times = np.linspace(-0.5, 0.5, 11)
    angles = speed * times / radius
    axes = (0 * times, radius * np.sin(angles), radius * np.cos(angles) - 6371000.0)
    return [Curve("CUBIC", list(zip(times.round(3), axis.round(9)))) for axis in axes]


def long_pulse(radar_path, target_path, carrier_ghz, bandwidth_ghz, width_ns, position, samples=40):
    """A scene of one target in front of one radar, recorded coarsely; an ideal chirp does not mind."""
    platforms = [scenes.Platform("Radar", trajectory=radar_path), scenes.Platform("Target", trajectory=target_path)]
    pulse = scenes.Pulse("CHIRP", width_ns, bandwidth_ghz)
    radar = scenes.Radar("Radar", pulse, prf_hz=100.0, carrier=scenes.Carrier("SINGLE", carrier_ghz))
    recording = scenes.Recording(0.0, 0.0, 0.0, 0.01, samples / width_ns, pulse_position=position)
    scene = scenes.Scene("physical", platforms, [scenes.Target("Target", (0.0, 0.0, 0.0))], radar, recording)
    delay = float(Model(scene).echoes(0)[0].delay_s)
    middle, reach = delay * 299792458.0 / 2, width_ns * 1e-9 * 299792458.0
    recording.near_m, recording.far_m = max(0.0, middle - 0.6123 * reach), middle + 1.1 * reach
    return scene


ORIGIN, REST = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
SQUINTED = (654000.0, 238000.0, 0.0)  # 20 degrees off broadside of what flies along y.
CASES = {  # Paths of radar and target, GHz, GHz, ns.
    "missile 2 km/s, X, 1 GHz, 100 us": (
        straight(ORIGIN, REST),
        straight((60000.0, 0.0, 0.0), (-2000.0, 0.0, 0.0)),
        9.6,
        1.0,
        1e5,
    ),
    "satellite, squint 20 deg, X, 1.2 GHz, 50 us": (
        straight(ORIGIN, (0.0, 7600.0, 0.0)),
        straight(SQUINTED, REST),
        9.65,
        1.2,
        5e4,
    ),
    "satellite in orbit, Ka, 500 MHz, 100 us": (
        circle(7071000.0, 7500.0),
        straight((150000.0, 40000.0, 0.0), (5.0, 0.0, 0.0)),
        35.75,
        0.5,
        1e5,
    ),
    "aircraft 300 m/s, X, 500 MHz, 100 us": (
        straight(ORIGIN, REST),
        straight((0.0, 40000.0, 3000.0), (20.0, 300.0, 0.0)),
        9.6,
        0.5,
        1e5,
    ),
    "car 50 m/s, 77 GHz, 150 MHz, 1 ms": (
        straight(ORIGIN, REST),
        straight((100.0, 3.0, 0.0), (-50.0, 0.0, 0.0)),
        77.0,
        0.15,
        1e6,
    ),
    "car 30 m/s passing at 5 m, 77 GHz, 150 MHz, 1 ms": (
        straight(ORIGIN, REST),
        straight((0.0, 5.0, 0.0), (30.0, 0.0, 0.0)),
        77.0,
        0.15,
        1e6,
    ),
}
# Of the amplitude, which is radians: pi f tau''' Tp^3/24, 6e-5 for the nearest car, and a run's tolerance.
EXPANSION, RUN = 1e-4, 1e-6


@functools.cache
def truth_of(name, position):
    """Scene and samples of a case."""
    scene = long_pulse(*CASES[name], position)
    return scene, EmissionModel(scene).samples()


class LongPulses(unittest.TestCase):
    def compare(self, samples_of, allowed):
        for name in CASES:
            for position in ("BEGIN", "CENTRE"):
                scene, truth = truth_of(name, position)
                error = np.abs(samples_of(scene) - truth).max() / np.abs(truth).max()
                print(f"{name}, {position}: {error:.1e} rad")
                with self.subTest(case=name, position=position):
                    self.assertLessEqual(error, allowed)

    def test_the_second_order_of_the_theory_is_enough(self):
        self.compare(lambda scene: Model(scene).samples(), EXPANSION)

    def test_the_program_agrees_sample_by_sample(self):
        with tempfile.TemporaryDirectory(prefix="sarsim-independent-") as folder:
            for engine in ("reference", "auto"):
                self.compare(lambda scene: simulated(scene, engine, folder), EXPANSION + RUN)
