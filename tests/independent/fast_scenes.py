"""Random scenes in which light time, Doppler and acceleration within the pulse matter: docs/theory/echo-model.md, 2."""

import typing

import numpy as np

from curves import Curve
from scenes import Carrier, Draw, Platform


class Family(typing.NamedTuple):
    """What scenes of a kind draw from; SI units, but widths in ns and frequencies in GHz."""

    distance: tuple
    radar_speed: tuple
    target_speed: tuple
    acceleration: float  # The largest, along each axis.
    turning_deg_s: float  # The fastest, about each axis.
    carriers_ghz: tuple
    width_ns: tuple
    bandwidth_ghz: float
    sampling_ghz: tuple
    prf_hz: tuple


FAMILIES = {
    "spaceborne": Family(
        (5e5, 9e5), (7000, 7700), (0, 30), 9, 2, (5.405, 9.65, 35.75), (2e4, 1e5), 0.6, (0.005, 0.02), (1500, 5000)
    ),
    "missile": Family(
        (1e4, 2e5), (0, 600), (500, 3000), 300, 90, (3.0, 9.6, 35.0), (1e4, 1e5), 1.0, (0.005, 0.02), (500, 2000)
    ),
    "FMCW": Family((5, 200), (0, 40), (1, 70), 10, 90, (24.0, 77.0), (2e5, 1e6), 0.15, (0.0005, 0.002), (500, 900)),
    "turning": Family((1e3, 3e4), (0, 200), (0, 60), 10, 3000, (1.3, 9.6), (1e3, 2e4), 0.05, (0.01, 0.1), (500, 5000)),
    "accelerating": Family(
        (1e4, 2e5), (0, 800), (50, 800), 1000, 90, (3.0, 9.6), (1e3, 5e4), 0.2, (0.01, 0.05), (500, 5000)
    ),
}
KNOTS_S = np.linspace(-0.4, 0.6, 6)


class FastDraw(Draw):
    """Draws one scene of a family."""

    def __init__(self, seed, family):
        super().__init__(seed)
        self.profile = "physical"
        self.family = FAMILIES[family]
        self.distance = self.number(*self.family.distance)
        azimuth, depression = self.number(-np.pi, np.pi), self.number(0.1, 1.2)
        away = (np.sin(azimuth) * np.cos(depression), np.cos(azimuth) * np.cos(depression), -np.sin(depression))
        self.target_place = np.array([self.number(-100, 100), self.number(-100, 100), self.number(0, 50)])
        self.radar_place = np.round(self.target_place - self.distance * np.array(away), 3)
        self.spread = min(200.0, 0.2 * self.distance)

    def flight(self, place, speeds):
        """Straight and even, or accelerated along each axis."""
        heading = np.array([self.random.gauss(0, 1) for _ in range(3)]) * (1, 1, 0.2)
        velocity = self.number(*speeds) * heading / np.linalg.norm(heading)
        if self.chance(0.4):
            return [Curve("LINEAR", [(0, p), (1, round(p + v, 4))]) for p, v in zip(place, velocity)]
        accelerations = [self.number(-1, 1) * self.family.acceleration for _ in range(3)]
        return [
            Curve("CUBIC", [(round(t, 3), round(p + v * t + a * t * t / 2, 5)) for t in KNOTS_S])
            for p, v, a in zip(place, velocity, accelerations)
        ]

    def platform(self, name, place, moving):
        platform = Platform(name, tuple(place))
        if name == "Earth":
            return platform
        speeds = self.family.radar_speed if name == "Aircraft" else self.family.target_speed
        if self.chance(0.85):
            platform.trajectory, platform.aligned = self.flight(place, speeds), self.chance(0.5)
        if self.chance(0.6):
            platform.rotation = tuple(self.number(-60, 60) for _ in range(3))
        if self.chance(0.5):
            fastest = min(self.family.turning_deg_s, 90) if name == "Aircraft" else self.family.turning_deg_s
            platform.rotation_rate = tuple(self.number(-1, 1) * fastest for _ in range(3))
        return platform

    def target(self):
        target = super().target()
        shrink = min(1.0, self.spread / 200)
        target.position = tuple(round(shrink * x, 4) for x in target.position)
        if target.platform == "Earth":
            target.position = tuple(round(x + self.number(-1, 1) * self.spread, 3) for x in self.target_place)
        return target

    def pulse(self, sampling_ghz):
        pulse = super().pulse(sampling_ghz)
        pulse.width_ns = round(self.number(*self.family.width_ns), 1)
        if pulse.band_limited:  # Whose quadrature wants few cycles.
            pulse.width_ns = min(pulse.width_ns, round(1000 / sampling_ghz, 1))
        elif pulse.kind == "CHIRP":
            pulse.bandwidth_ghz = round(self.number(-1, 1) * self.family.bandwidth_ghz, 5)
        pulse.rise_ns, pulse.fall_ns = (round(pulse.width_ns * self.number(0, 0.5), 1) for _ in range(2))
        return pulse

    def carrier(self):
        carrier = super().carrier()
        first = self.choice(*self.family.carriers_ghz)
        scale = first / carrier.first_ghz
        frequencies = tuple(round(scale * frequency, 5) for frequency in carrier.frequencies_ghz)
        return Carrier(
            carrier.kind, first, carrier.step_ghz, carrier.steps, carrier.pulses_per_step, frequencies_ghz=frequencies
        )

    def radar(self, sampling_ghz):
        radar = super().radar(sampling_ghz)
        radar.prf_hz = self.number(*self.family.prf_hz)
        radar.intervals = radar.intervals and [round(x, 6) for x in np.array(radar.intervals) * 300 / radar.prf_hz]
        return radar

    def recording(self, radar, sampling_ghz):
        recording = super().recording(radar, sampling_ghz)
        if recording.processing != "SRP":
            recording.end_s = recording.begin_s + round(4 * max(radar.intervals or [1 / radar.prf_hz]), 6)
        return recording

    def sampling(self):
        return self.number(*self.family.sampling_ghz, digits=5)
