"""Scenes as Python objects, their text as scripts (docs/formats/script.md), and random ones.

Values are in the units of the scripts: ns, GHz, kW, dB, degrees, metres, seconds. Only what the model computes can be
said: no chance, no surfaces, volts instead of counts.
"""

import dataclasses
import random

import numpy as np

from curves import Curve
from model import LIGHT_SPEED, Model


@dataclasses.dataclass
class Platform:
    name: str
    position: tuple = (0.0, 0.0, 0.0)
    trajectory: list | None = None  # Three curves against slow time, in place of the position.
    aligned: bool = False
    rotation: tuple = (0.0, 0.0, 0.0)
    rotation_curves: list | None = None  # In place of the rotation.
    rotation_rate: tuple = (0.0, 0.0, 0.0)


@dataclasses.dataclass
class Target:
    platform: str
    position: tuple
    cross_section: float = 1.0
    normal_deg: tuple | None = None  # Azimuth and elevation; None is isotropic.
    reflectivity: Curve | None = None  # In dB against the incidence angle; None is the cosine law.


@dataclasses.dataclass
class Pulse:
    kind: str = "MONO"
    width_ns: float = 1000.0
    bandwidth_ghz: float = 0.0
    code: int = 6
    in_phase: Curve | None = None
    quadrature: Curve | None = None
    envelope: str = "RECT"
    rise_ns: float = 0.0
    fall_ns: float = 0.0
    envelope_curve: Curve | None = None
    band_limited: bool = False
    oversampling: float = 1.0
    kept_width: float = 1.0


@dataclasses.dataclass
class Carrier:
    kind: str = "SINGLE"
    first_ghz: float = 1.0
    step_ghz: float = 0.0
    steps: int = 1
    pulses_per_step: int = 1
    frequencies_ghz: tuple = ()


@dataclasses.dataclass
class Antenna:
    kind: str = "ISOTROPIC"
    elevation_beamwidth_deg: float = 0.0
    azimuth_beamwidth_deg: float = 0.0
    azimuth_cut: Curve | None = None
    elevation_cut: Curve | None = None


@dataclasses.dataclass
class Beam:
    kind: str = "FIXED"
    elevation_deg: float = 0.0
    azimuth_deg: float = 0.0
    rate_deg_s: float = 0.0
    point: tuple = ()
    curves: tuple = ()


@dataclasses.dataclass
class Window:
    kind: str = "RECT"
    pedestal: float = 1.0
    curve: Curve | None = None


@dataclasses.dataclass
class Radar:
    platform: str
    pulse: Pulse = dataclasses.field(default_factory=Pulse)
    prf_hz: float = 1000.0
    intervals: list | None = None  # In place of the PRF.
    carrier: Carrier = dataclasses.field(default_factory=Carrier)
    power_kw: float = 1.0
    transmit_gain_db: float = 0.0
    receive_gain_db: float = 0.0
    losses_db: float = 0.0
    transmit: Antenna = dataclasses.field(default_factory=Antenna)
    receive: Antenna | None = None  # None: the same.
    beam: Beam = dataclasses.field(default_factory=Beam)
    window: Window = dataclasses.field(default_factory=Window)
    stc: str | None = None
    stc_curve: Curve | None = None


@dataclasses.dataclass
class Recording:
    near_m: float
    far_m: float
    begin_s: float
    end_s: float
    sampling_ghz: float
    processing: str = "RAW"
    pulse_position: str = "BEGIN"
    other_pulses: bool = False  # Whether their echoes are received, too.
    eclipsing: bool = False


@dataclasses.dataclass
class Scene:
    profile: str
    platforms: list
    targets: list
    radar: Radar
    recording: Recording


# ---- Text ----


def numbers(*values):
    return " ".join(repr(float(value)) for value in values)


def block(*curves):
    """A block of user-defined functions, on lines of its own."""
    lines = [f"{len(c.points)} " + " ".join(f"{x!r}, {y!r}" for x, y in c.points) for c in curves]
    return "\n".join(["", " ".join(c.kind for c in curves), "INLINE", *lines, ""])


def listed(values):
    """A block whose values are taken in turn."""
    return block(Curve("LINEAR", enumerate(values)))


def platform_text(platform):
    place = f"STATIONARY {numbers(*platform.position)}"
    if platform.trajectory:
        place = f"TRAJECTORY {block(*platform.trajectory)} {'ALIGNED' if platform.aligned else 'NOT_ALIGNED'}"
    curves = platform.rotation_curves
    rotation = f"OTHER {block(*curves)}" if curves else f"CONST {numbers(*platform.rotation)}"
    return (
        f"$PLATFORM {platform.name} {place} {rotation} {numbers(*platform.rotation_rate)} STDDEV 0 0 0 STDDEV 0 0 0\n"
    )


def target_text(target):
    law = "ISOTROPIC"
    if target.normal_deg is not None:
        gain = f"OTHER_GAIN {block(target.reflectivity)}" if target.reflectivity else "COS_GAIN"
        law = f"DIRECTIONAL {numbers(*target.normal_deg)} 0 0 {gain}"
    return f"$TARGET {target.platform} {numbers(*target.position)} 0 0 0 {numbers(target.cross_section)} 0 {law}\n"


def pulse_text(pulse):
    kind = {
        "MONO": lambda: "",
        "CHIRP": lambda: numbers(pulse.bandwidth_ghz),
        "BARKER": lambda: str(pulse.code),
        "OTHER_PULSE": lambda: block(pulse.in_phase, pulse.quadrature),
    }[pulse.kind]()
    envelope = {
        "RECT": lambda: "",
        "LINEAR": lambda: numbers(pulse.rise_ns, pulse.fall_ns),
        "OTHER": lambda: block(pulse.envelope_curve),
    }[pulse.envelope]()
    return f"{pulse.kind} {kind} {numbers(pulse.width_ns)} {pulse.envelope} {envelope}\n"


def carrier_text(carrier):
    if carrier.kind == "OTHER":
        return f"OTHER {listed(carrier.frequencies_ghz)}\n"
    if carrier.kind == "SINGLE":
        return f"SINGLE {numbers(carrier.first_ghz)}\n"
    return f"STEPPED {numbers(carrier.first_ghz, carrier.step_ghz)} {carrier.steps} {carrier.pulses_per_step}\n"


def antenna_text(antenna):
    if antenna is None:
        return "SAME\n"
    if antenna.kind == "SINX":
        return f"SINX {numbers(antenna.elevation_beamwidth_deg, antenna.azimuth_beamwidth_deg)}\n"
    return f"OTHER {block(antenna.azimuth_cut, antenna.elevation_cut)}\n" if antenna.kind == "OTHER" else "ISOTROPIC\n"


def beam_text(beam):
    values = {
        "FIXED": lambda: numbers(beam.elevation_deg, beam.azimuth_deg),
        "ROTATING": lambda: numbers(beam.elevation_deg, beam.rate_deg_s),
        "SPOT": lambda: numbers(*beam.point),
        "OTHER": lambda: block(*beam.curves),
    }[beam.kind]()
    return f"{beam.kind} {values}\n"


def window_text(window):
    values = {"HANNING": lambda: numbers(window.pedestal), "OTHER": lambda: block(window.curve)}
    return f"{window.kind} {values.get(window.kind, str)()}\n"


def radar_text(radar):
    stc = f"APPLY_STC {radar.stc} {block(radar.stc_curve) if radar.stc == 'OTHER' else ''}" if radar.stc else "NO_STC"
    return "".join(
        (
            f"$RADAR Radar {radar.platform}\n",
            pulse_text(radar.pulse),
            f"OTHER {listed(radar.intervals)}\n" if radar.intervals else f"CONSTANT {numbers(radar.prf_hz)}\n",
            carrier_text(radar.carrier),
            numbers(radar.power_kw, radar.transmit_gain_db, radar.receive_gain_db, radar.losses_db, 0) + "\n",
            antenna_text(radar.transmit),
            antenna_text(radar.receive),
            beam_text(radar.beam),
            window_text(radar.window),
            stc + "\n",
        )
    )


def script(scene, file="samples.npy"):
    """The text of a scene, with volts (NPY) as output."""
    recording, pulse = scene.recording, scene.radar.pulse
    window = numbers(recording.near_m, recording.far_m, recording.begin_s, recording.end_s)
    simulation = f"$SIMULATION Radar {window} 16 {numbers(recording.sampling_ghz)} 0 NPY {recording.processing} {file}"
    factors = f"{recording.pulse_position} {numbers(pulse.oversampling, pulse.kept_width)}"
    options = f"$OPTIONS PROFILE {scene.profile} PULSE {'BAND_LIMITED' if pulse.band_limited else 'IDEAL'}"
    options += f" AMBIGUOUS_ECHOES {'ALL' if recording.other_pulses else 'NONE'}"
    options += f" ECLIPSING {'BLANKED' if recording.eclipsing else 'NONE'}"
    parts = [platform_text(platform) for platform in scene.platforms] + [
        target_text(target) for target in scene.targets
    ]
    return "".join(parts) + radar_text(scene.radar) + f"{simulation} {factors}\n{options}\n"


# ---- Random scenes ----

TRIAL_S = (-0.4, 0.4)  # Slow times that functions of time are given for.


class Draw:
    """Draws one scene from a seed: a radar, and targets on platforms that rest, fly and turn some kilometres away."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.profile = "classic" if self.chance(0.35) else "physical"
        self.radar_place = np.array([self.number(-100, 100), self.number(-100, 100), self.number(0, 1000)])
        self.distance = self.number(800, 30000)
        heading = self.number(-np.pi, np.pi)
        away = np.array([np.sin(heading), np.cos(heading), self.number(-0.1, 0.1)])
        self.target_place = self.radar_place + self.distance * away

    def chance(self, probability):
        return self.random.random() < probability

    def number(self, low, high, digits=4):
        return round(self.random.uniform(low, high), digits)

    def choice(self, *values):
        return self.random.choice(values)

    def curve(self, low, high, begin, end, low_pass=True):
        kind = self.choice("LINEAR", "CUBIC", *(("MFILTER",) if low_pass else ()))
        count = self.random.randint(3 if kind == "MFILTER" else 1, 6)
        knots = sorted(self.random.uniform(begin, end) for _ in range(count))
        for i in range(1, count):
            knots[i] = max(knots[i], knots[i - 1] + (end - begin) / 50)
        return Curve(kind, [(round(knot, 6), self.number(low, high)) for knot in knots])

    def trajectory(self, place):
        """A straight flight, or one that strays from it by some metres between its knots."""
        speed, heading = self.number(5, 600), self.number(-np.pi, np.pi)
        velocity = (speed * np.sin(heading), speed * np.cos(heading), self.number(-50, 50))
        if self.chance(0.5):
            return [Curve("LINEAR", [(0, start), (1, start + rate)]) for start, rate in zip(place, velocity)]
        return [
            Curve(
                self.choice("LINEAR", "CUBIC"),
                [(knot, round(start + rate * knot + self.number(-4, 4), 4)) for knot in (-0.4, -0.1, 0.05, 0.3)],
            )
            for start, rate in zip(place, velocity)
        ]

    def platform(self, name, place, moving):
        platform = Platform(name, tuple(place))
        if self.chance(moving):
            platform.trajectory, platform.aligned = self.trajectory(place), self.chance(0.5)
        if self.chance(0.6):
            platform.rotation = tuple(self.number(-60, 60) for _ in range(3))
        if self.chance(0.3):
            platform.rotation_curves = [self.curve(-40, 40, *TRIAL_S, low_pass=False) for _ in range(3)]
        if self.chance(0.5):
            platform.rotation_rate = tuple(self.number(-90, 90) for _ in range(3))
        return platform

    def target(self):
        target = Target(self.choice("Ship", "Drone"), tuple(self.number(-40, 40) for _ in range(3)))
        if self.chance(0.3):
            target = Target("Earth", tuple(round(x + self.number(-50, 50), 3) for x in self.target_place))
        target.cross_section = round(10 ** self.number(-1, 2), 3)
        if self.chance(0.5):
            target.normal_deg = (self.number(-180, 180), self.number(-80, 80))
            target.reflectivity = self.curve(-20, 3, 0, 180) if self.chance(0.6) else None
        return target

    def pulse(self, sampling_ghz):
        pulse = Pulse(
            self.choice("MONO", "CHIRP", "BARKER", "OTHER_PULSE"), self.choice(self.number(100, 4000, 1), 1000.0)
        )
        pulse.band_limited = self.chance(0.25)
        low_pass = not pulse.band_limited  # Whose corners the model's quadrature does not know.
        pulse.bandwidth_ghz = self.number(-1, 1) * sampling_ghz if pulse.kind == "CHIRP" else 0.0
        pulse.code = self.random.randint(0, 6)
        if pulse.kind == "OTHER_PULSE":
            pulse.in_phase, pulse.quadrature = self.curve(-1, 1, 0, 1, low_pass), self.curve(-1, 1, 0, 1, low_pass)
        elif pulse.band_limited and self.chance(0.5):  # The own band of a user-defined pulse is not modelled.
            pulse.oversampling, pulse.kept_width = self.number(1.1, 4), self.number(1, 2.5)
        pulse.envelope = self.choice("RECT", "RECT", "LINEAR", "OTHER")
        if pulse.envelope == "LINEAR":
            pulse.rise_ns, pulse.fall_ns = (round(pulse.width_ns * self.number(0, 0.5), 1) for _ in range(2))
        if pulse.envelope == "OTHER":
            pulse.envelope_curve = self.curve(0, 1, 0, 1, low_pass)
        return pulse

    def carrier(self):
        carrier = Carrier(self.choice("SINGLE", "STEPPED", "OTHER"), round(10 ** self.number(-0.5, 1.3), 4))
        if carrier.kind == "STEPPED":
            carrier.step_ghz = self.number(0, 0.05)
            carrier.steps, carrier.pulses_per_step = self.random.randint(3, 4), self.random.randint(1, 2)
        if carrier.kind == "OTHER":
            count = self.random.randint(1, 5)
            carrier.frequencies_ghz = tuple(round(carrier.first_ghz * self.number(0.9, 1.1), 5) for _ in range(count))
        return carrier

    def antenna(self):
        kind = self.choice("ISOTROPIC", "SINX", "OTHER")
        if kind == "SINX":
            return Antenna(kind, self.number(3, 60), self.number(3, 60))
        cuts = [self.curve(-30, 0, self.choice(0, -180), 180) for _ in range(2)]
        return Antenna(kind, azimuth_cut=cuts[0], elevation_cut=cuts[1])

    def beam(self):
        beam = Beam(self.choice("FIXED", "ROTATING", "SPOT", "OTHER"), self.number(-40, 40), self.number(-180, 180))
        beam.rate_deg_s = self.number(0, 4000)
        beam.point = tuple(round(x + self.number(-200, 200), 1) for x in self.target_place)
        beam.curves = tuple(self.curve(x - 300, x + 300, *TRIAL_S, low_pass=False) for x in self.target_place)
        return beam

    def radar(self, sampling_ghz):
        radar = Radar("Aircraft", self.pulse(sampling_ghz), prf_hz=self.number(200, 600), carrier=self.carrier())
        if self.chance(0.3):
            radar.intervals = [self.number(0.001, 0.004, 6) for _ in range(self.random.randint(1, 5))]
        radar.power_kw, radar.losses_db = self.number(0.1, 100), self.number(0, 10)
        radar.transmit_gain_db, radar.receive_gain_db = self.number(0, 40), self.number(0, 40)
        radar.transmit, radar.receive = self.antenna(), self.antenna() if self.chance(0.5) else None
        radar.beam = self.beam()
        kind = self.choice("RECT", "HANNING", "HAMMING", "BARTLETT", "OTHER")
        radar.window = Window(kind, self.number(0.05, 1), self.curve(0.1, 1, 0, 1))
        if self.chance(0.3):
            radar.stc, radar.stc_curve = self.choice("1OVERR4", "OTHER"), self.curve(0.5, 3, 0, 2 * self.distance)
        return radar

    def recording(self, radar, sampling_ghz):
        begin = 0.0 if self.chance(0.2) else self.number(-0.3, 0.2)
        recording = Recording(0.0, 0.0, begin, begin + 0.02, sampling_ghz)
        recording.processing = self.choice("RAW", "RAW", "MATCHED_FILTER")
        if radar.carrier.kind == "STEPPED" and self.chance(0.5):
            recording.processing = "SRP"  # Of one burst or two.
            burst = radar.carrier.steps * radar.carrier.pulses_per_step
            recording.end_s = begin + 2.2 * burst * max(radar.intervals or [1 / radar.prf_hz])
        recording.pulse_position = self.choice("BEGIN", "CENTRE")
        return recording

    def set_swath(self, scene):
        """A range window around the echoes, that cuts their beginning, or that ends among them."""
        model, light_speed = Model(scene), LIGHT_SPEED[scene.profile]
        slant_ranges = [float(echo.delay_s) * light_speed / 2 for n in model.pulses() for echo in model.echoes(n)]
        nearest, farthest = min(slant_ranges), max(slant_ranges)
        extent = scene.radar.pulse.width_ns * 1e-9 * light_speed / 2
        swaths = (
            (nearest - 0.7 * extent - 20, farthest + 1.3 * extent + 20),
            (nearest + 0.3 * extent, farthest + 0.5 * extent + 30),
            (nearest - 0.6 * extent - 5, nearest + 0.2 * extent + 60),
        )
        near, far = self.choice(swaths[0], *swaths)
        scene.recording.near_m, scene.recording.far_m = max(0.0, round(near, 2)), round(far, 2)

    def sampling(self):
        return self.choice(self.number(0.01, 0.15), 0.05)

    def scene(self):
        platforms = [
            self.platform("Earth", (0.0, 0.0, 0.0), 0) if self.chance(0.3) else Platform("Earth"),
            self.platform("Aircraft", self.radar_place, 0.7),
            self.platform("Ship", self.target_place, 0.7),
            self.platform("Drone", self.target_place + (30, -40, 5), 0.5),
        ]
        targets = [self.target() for _ in range(self.random.randint(1, 6))]
        sampling_ghz = self.sampling()
        radar = self.radar(sampling_ghz)
        scene = Scene(self.profile, platforms, targets, radar, self.recording(radar, sampling_ghz))
        self.set_swath(scene)
        return scene
