"""A second echo model: what a recording has to contain, written from the theory and from nothing else.

The sources are the pages of docs/theory and R. Lengenfelder, The Design and Implementation of a Radar Simulator,
University of Cape Town, 1998 ("thesis"). It shares nothing with the program, and has to stay so: where the two
differ, the pages decide, never the program's sources. Chance (noise, jitter), surfaces and the converter to counts are
left out.
"""

import math
import typing

import numpy as np

import light_time
from motion import Kinematics, angles_of, direction, wrapped
from pulse import EDGE, FILTER_LENGTH, Shape

OTHER_DELAYS_S = 1e-4  # By how much delays may change over the pulses that are in flight.
LIGHT_SPEED = {"physical": 299792458.0, "classic": 299792500.0}  # m/s; docs/decisions/physics-rules.md, 1.


class Echo(typing.NamedTuple):
    """One target as one pulse meets it."""

    delay_s: float  # Two-way time of the pulse's middle, after it was sent.
    amplitude: float
    doppler: float  # D; receding is positive.
    acceleration: float  # a, in 1/s.


def sinx_gain(offset, beamwidth_deg):
    """sin(x)/x, x = 0.88 pi sin(offset)/beamwidth, nothing from 90 degrees on (thesis A.17)."""
    offset = abs(wrapped(offset))
    return 0.0 if offset >= np.pi / 2 else np.sinc(0.88 * np.sin(offset) / np.radians(beamwidth_deg))


class Model(Kinematics):
    """The samples of a scene's recording. Each rule is a method, so that a test can put a wrong one in its place."""

    def __init__(self, scene):
        self.scene = scene
        self.radar = scene.radar
        self.recording = scene.recording
        self.classic = scene.profile == "classic"
        self.light_speed = LIGHT_SPEED[scene.profile]
        self.sampling_hz = self.recording.sampling_ghz * 1e9
        self.shape = Shape(self.radar.pulse, self.sampling_hz, self.classic)
        self.lead_s = self.shape.width_s / 2 if self.recording.pulse_position == "CENTRE" else 0.0  # thesis 6.19
        self.known_echoes = {}
        self.burst_size = self.radar.carrier.steps * self.radar.carrier.pulses_per_step

    # ---- Which pulses, when, on which carrier: docs/theory/echo-model.md, 1 ----

    def send_time(self, number):
        """n/PRF, or the running sum of intervals that repeat in both directions (thesis 6.1, 6.7, 6.8)."""
        if not self.radar.intervals:
            return number / self.radar.prf_hz
        sums = np.concatenate([[0.0], np.cumsum(self.radar.intervals)])
        rounds, rest = divmod(number, len(self.radar.intervals))
        return rounds * sums[-1] + sums[rest]

    def pulses(self):
        """Numbers of the pulses of the window of slow time; both ends belong to it, widened by 1e-9 of an interval."""
        intervals = self.radar.intervals or [1 / self.radar.prf_hz]
        begin, end, shortest = self.recording.begin_s, self.recording.end_s, min(intervals)
        first, last = math.floor(begin / shortest), math.ceil(end / shortest)
        numbers = range(min(first, 0) - 2, max(last, 0) + 3)
        return [n for n in numbers if begin - EDGE * shortest <= self.send_time(n) <= end + EDGE * shortest]

    def carrier(self, number):
        """In Hz: constant, stepped or a list in turn (thesis 6.4 to 6.6)."""
        plan = self.radar.carrier
        if plan.kind == "OTHER":
            return plan.frequencies_ghz[number % len(plan.frequencies_ghz)] * 1e9
        return plan.first_ghz * 1e9 + plan.step_ghz * 1e9 * ((number % self.burst_size) // plan.pulses_per_step)

    # ---- Geometry: docs/theory/echo-model.md, 2, and docs/theory/frames.md ----

    def platform(self, name):
        return next(platform for platform in self.scene.platforms if platform.name == name)

    def flight(self, target, send_time):
        """The way of what leaves at a time, in 80 bits (physical)."""
        radar, carrying, place = self.platform(self.radar.platform), self.platform(target.platform), target.position
        return light_time.flight(
            lambda time, orders: self.motion(radar, time, orders).place,
            lambda time, orders: self.motion(carrying, time, orders).of(place),
            np.longdouble(send_time),
            np.longdouble(self.light_speed),
        )

    def frozen_flight(self, target, send_time):
        """tau = 2 d/(c - v) of the geometry at the send time (thesis 6.9; classic)."""
        time = np.longdouble(send_time)
        point = self.motion(self.platform(target.platform), time).of(target.position)
        radar = self.motion(self.platform(self.radar.platform), time).place
        look, rate = point[0] - radar[0], point[1] - radar[1]
        distance = np.sqrt(look @ look)
        speed = (look @ rate) / distance
        delay = self.frozen_delay(distance, speed)
        return light_time.Flight(delay, distance / self.light_speed, look, 2 * speed / self.light_speed, 0.0)

    def frozen_delay(self, distance, speed):
        return 2 * distance / (self.light_speed - speed)

    # ---- Antennas and beams: docs/theory/frames.md, "Antenna frame" ----

    def beam_angles(self, time, radar_motion):
        """Azimuth and elevation of the beam: in the platform's frame, or in the world's where it is held on a point."""
        beam = self.radar.beam
        if beam.kind == "FIXED":
            return np.radians(beam.azimuth_deg), np.radians(beam.elevation_deg)
        if beam.kind == "ROTATING":
            return np.radians(beam.rate_deg_s * time), np.radians(beam.elevation_deg)
        point = [float(curve.value(time)) for curve in beam.curves] if beam.kind == "OTHER" else beam.point
        return angles_of(np.array(point, float) - radar_motion.place[0])

    def offsets(self, look, time, radar_motion):
        """How far the target is from the beam in azimuth and elevation."""
        azimuth, elevation = self.beam_angles(time, radar_motion)
        on_platform = self.radar.beam.kind in ("FIXED", "ROTATING")
        if self.classic:
            target_azimuth, target_elevation = angles_of(look)
            if on_platform:
                azimuth, elevation = azimuth + radar_motion.yaw, elevation + radar_motion.pitch
            return wrapped(azimuth - target_azimuth), wrapped(elevation - target_elevation)
        along = direction(azimuth, elevation)
        right = np.array([np.cos(azimuth), -np.sin(azimuth), 0.0])
        seen = radar_motion.world_from_platform[0].T @ look if on_platform else look
        seen = np.array([right @ seen, along @ seen, np.cross(right, along) @ seen]) / np.linalg.norm(look)
        return np.arctan2(seen[0], seen[1]), np.arcsin(np.clip(seen[2], -1, 1))

    def antenna_factor(self, antenna, azimuth, elevation):
        """One-way amplitude (docs/theory/echo-model.md, "Amplitude"; thesis 6.14, A.17)."""
        if antenna.kind == "ISOTROPIC":
            return 1.0
        if antenna.kind == "SINX":
            gain = sinx_gain(azimuth, antenna.azimuth_beamwidth_deg) * sinx_gain(
                elevation, antenna.elevation_beamwidth_deg
            )
            return math.sqrt(abs(gain)) if self.classic else gain
        in_azimuth = antenna.azimuth_cut.at_angle(np.degrees(wrapped(azimuth)), True, self.classic)
        in_elevation = antenna.elevation_cut.at_angle(np.degrees(wrapped(elevation)), False, self.classic)
        return 10 ** (float(in_azimuth + in_elevation) / 20)

    # ---- The echo: docs/theory/echo-model.md, 3 ----

    def cross_section(self, target, look, target_motion):
        """In square metres: RCS times the law of the incidence angle (thesis 4.2)."""
        if target.normal_deg is None:
            return target.cross_section
        normal = target_motion.world_from_platform[0] @ direction(*np.radians(target.normal_deg))
        cosine = np.clip(-(normal @ look) / np.linalg.norm(look), -1, 1)
        if target.reflectivity is None:
            return target.cross_section * max(cosine, 0.0)
        return target.cross_section * 10 ** (
            float(target.reflectivity.gain(np.degrees(np.arccos(cosine)), self.classic)) / 10
        )

    def amplitude(self, carrier, antennas, cross_section, distance):
        """The radar equation, in sqrt W (thesis 2.2, 6.13, 6.15); classic STC leaves 1/d^2 out.

        The distance is the geometric mean of the ways out and home.
        """
        radar = self.radar
        power = radar.power_kw * 1e3 * 10 ** ((radar.transmit_gain_db + radar.receive_gain_db - radar.losses_db) / 10)
        strength = math.sqrt(power * cross_section) * self.light_speed / carrier * antennas / (4 * np.pi) ** 1.5
        return strength if self.classic and radar.stc else strength / distance**2

    def echoes(self, number):
        """Of all targets to one pulse, worked out once."""
        if number not in self.known_echoes:
            self.known_echoes[number] = [self.echo(target, number) for target in self.scene.targets]
        return self.known_echoes[number]

    def echo(self, target, number):
        time = self.send_time(number)
        flight = self.frozen_flight(target, time) if self.classic else self.flight(target, time)
        met = np.longdouble(time) if self.classic else time + flight.out_s
        radar_motion = self.motion(self.platform(self.radar.platform), np.longdouble(time))
        target_motion = self.motion(self.platform(target.platform), met)
        home = flight.out_s if self.classic else flight.delay_s - flight.out_s
        look = flight.look.astype(float)
        azimuth, elevation = self.offsets(look, time, radar_motion)
        antennas = self.antenna_factor(self.radar.transmit, azimuth, elevation)
        antennas *= self.antenna_factor(self.radar.receive or self.radar.transmit, azimuth, elevation)
        cross_section = self.cross_section(target, look, target_motion)
        distance = self.light_speed * math.sqrt(flight.out_s * home)
        amplitude = self.amplitude(self.carrier(number), antennas, cross_section, distance)
        return Echo(flight.delay_s, amplitude, flight.doppler, flight.acceleration)

    def after_send(self, times):
        """Times of a row counted from t(n), when the middle of its pulse leaves."""
        return times + (self.lead_s - self.shape.width_s / 2)

    def sent_when(self, echo, after_middle):
        """When, counted from the pulse's middle, left what is received some time after that middle."""
        if self.classic:
            return after_middle
        return after_middle * (1 - float(echo.doppler)) - float(echo.acceleration) * after_middle**2 / 2

    def turns(self, echo, carrier, after_middle):
        """Of the Doppler shift within the pulse, in cycles."""
        doppler, acceleration = float(echo.doppler), float(echo.acceleration)
        if self.classic:  # Thesis 6.21 to 6.24.
            return doppler * (carrier * after_middle + self.shape.sweep_rate * after_middle**2 / 2)
        return carrier * (doppler * after_middle + acceleration * after_middle**2 / 2)

    def senders(self, number, after_send):
        """Numbers of the pulses that may be heard in a row: its own, or all whose echoes reach it."""
        if self.classic or not self.recording.other_pulses:
            return [number]
        delays = [float(echo.delay_s) for echo in self.echoes(number)]
        margin = self.shape.width_s * max(1.0, self.radar.pulse.kept_width) + OTHER_DELAYS_S
        margin += FILTER_LENGTH / (self.shape.nominal_bandwidth_hz() / 2) if self.radar.pulse.band_limited else 0.0
        early, late = min(delays) - after_send[-1] - margin, max(delays) - after_send[0] + margin
        begin, shortest = self.send_time(number), min(self.radar.intervals or [1 / self.radar.prf_hz])
        numbers = range(number - math.ceil(max(late, 0) / shortest), number + math.ceil(max(-early, 0) / shortest) + 1)
        return [m for m in numbers if m == number or early <= begin - self.send_time(m) <= late]

    def received(self, number, times, interval_s):
        """The sum of all echoes at times of the row of a pulse (docs/theory/echo-model.md, 3)."""
        total, carrier, after_send = np.zeros(times.shape, complex), self.carrier(number), self.after_send(times)
        for sender in self.senders(number, after_send):
            own, since = self.carrier(sender), np.longdouble(self.send_time(number)) - self.send_time(sender)
            if abs(own - carrier) > self.sampling_hz:
                continue
            for echo in self.echoes(sender):
                after_middle = (after_send + since - echo.delay_s).astype(float)
                cycles = float(np.fmod(own * echo.delay_s, 1)) + self.turns(echo, own, after_middle)
                cycles = cycles - (own - carrier) * after_send
                sent = self.sent_when(echo, after_middle) + self.shape.width_s / 2
                total += echo.amplitude * self.shape.transmitted(sent, interval_s) * np.exp(-2j * np.pi * cycles)
        total[self.eclipsed(number, after_send, interval_s)] = 0.0
        return total * self.stc_gain(self.light_speed * times / 2)

    def eclipsed(self, number, after_send, interval_s):
        """Which samples of a row are taken while the radar sends, where its receiver is off then."""
        sending = np.zeros(after_send.shape, bool)
        if not self.recording.eclipsing:
            return sending
        edge, shortest = EDGE * interval_s, min(self.radar.intervals or [1 / self.radar.prf_hz])
        first, last = math.floor(after_send[0] / shortest) - 1, math.ceil(after_send[-1] / shortest) + 1
        for m in range(number + min(first, 0) - 1, number + max(last, 0) + 2):
            after_edge = after_send + (self.send_time(number) - self.send_time(m)) + self.shape.width_s / 2
            sending |= (after_edge >= -edge) & (after_edge < self.shape.width_s - edge)
        return sending

    # ---- The receiver: docs/theory/echo-model.md, 4 and 5, and docs/theory/compression.md ----

    def stc_gain(self, slant_range):
        """Physical: R^2 or the user's gain at the range of the sample; classic: see amplitude()."""
        if self.classic or not self.radar.stc:
            return 1.0
        return slant_range**2 if self.radar.stc == "1OVERR4" else self.radar.stc_curve.gain(slant_range, self.classic)

    def gates(self):
        """N = floor(2 fs (end - start)/c + 1/2) (thesis 4.5.2)."""
        return math.floor(
            2 * self.sampling_hz * (self.recording.far_m - self.recording.near_m) / self.light_speed + 0.5
        )

    def raw_row(self, number):
        """Sample i at slant range start + i c/(2 fs); classic: start + i (end - start)/N."""
        spacing = self.light_speed / (2 * self.sampling_hz)
        if self.classic:
            spacing = (self.recording.far_m - self.recording.near_m) / self.gates()
        times = 2 * (self.recording.near_m + np.arange(self.gates()) * spacing) / self.light_speed
        return self.received(number, times, 2 * spacing / self.light_speed)

    def window(self, x):
        """Weights against x = t/Tp (docs/theory/compression.md, "Windows")."""
        window = self.radar.window
        return {
            "RECT": lambda: np.ones_like(x),
            "HANNING": lambda: (1 + window.pedestal - (1 - window.pedestal) * np.cos(2 * np.pi * x)) / 2,
            "HAMMING": lambda: 0.54 - 0.46 * np.cos(2 * np.pi * x),
            "BARTLETT": lambda: np.where(x < 0.5, 2 * x, 2 - 2 * x),
            "OTHER": lambda: window.curve.gain(x, self.classic),
        }[window.kind]()

    def compressed_row(self, number):
        """Behind the matched filter; the raw row begins at the start of the window, moved by the pulse position."""
        count, interval, width = self.gates(), 1 / self.sampling_hz, self.shape.width_s
        length = math.floor(width * self.sampling_hz + EDGE)
        begin = 2 * self.recording.near_m / self.light_speed - self.lead_s
        raw = self.received(number, begin + np.arange(count + length + 4) * interval, interval)
        if self.classic:
            return self.compressed_classic(raw, length)
        times = np.arange(length + 1) * interval
        times = times[times < width - EDGE * interval]
        weights, pulse = self.window(times / width), self.shape.transmitted(times, interval)
        return np.correlate(raw, weights * pulse, "valid")[:count] / np.sum(weights * np.abs(pulse) ** 2)

    def compressed_classic(self, raw, length):
        """The conjugate of the bare pulse, taken from its trailing edge with both ends, over 2 fs."""
        width, count = self.shape.width_s, self.gates()
        times = np.arange(length + 1) / self.sampling_hz
        if self.radar.pulse.kind == "BARKER":  # Chips are counted from the trailing edge.
            chips = np.floor((times + EDGE / self.sampling_hz) * len(self.shape.code) / width).astype(int)
            replica = self.shape.code[::-1][np.minimum(chips, len(self.shape.code) - 1)]
        else:
            replica = np.conj(self.shape.bare(width - times))
        filtered = np.convolve(raw, self.window(np.minimum(times / width, 1)) * replica)[length:] / (
            2 * self.sampling_hz
        )
        extent = self.recording.far_m - self.recording.near_m
        step = 2 * self.sampling_hz * extent / (self.light_speed * count)
        return filtered[np.floor(np.arange(count) * step + EDGE).astype(int)]

    def range_profiles(self):
        """A row for each complete burst, all bins of a gate beside each other (docs/theory/compression.md, "SRP")."""
        plan, numbers = self.radar.carrier, self.pulses()
        bursts = [n for n in numbers if n % self.burst_size == 0 and n + self.burst_size - 1 <= numbers[-1]]
        spacing = (self.recording.far_m - self.recording.near_m) / self.gates()
        if not self.classic:
            spacing = self.light_speed / (2 * self.sampling_hz)
        slant_ranges = self.recording.near_m + np.arange(self.gates()) * spacing
        steps = np.arange(plan.steps)
        weights = self.window(steps / (plan.steps - 1))
        cycles = np.outer(steps, plan.step_ghz * 1e9 * 2 * slant_ranges / self.light_speed)
        to_bins = np.exp(2j * np.pi * np.outer(steps, steps) / plan.steps)
        rows = []
        for first in bursts:
            raw = np.array([self.raw_row(first + n) for n in range(self.burst_size)])
            averaged = raw.reshape(plan.steps, plan.pulses_per_step, -1).mean(axis=1)
            steered = weights[:, None] * averaged * np.exp(2j * np.pi * cycles)
            rows.append((to_bins @ steered / weights.sum()).T.ravel())
        return np.array(rows)

    def echo_level(self):
        """How high the echoes of the strongest pulse stand in its row where the swath holds them whole.

        The root of the sum of their squares, of those near the swath, behind the filter (docs/theory/compression.md).
        """
        reach = self.shape.width_s * max(1.0, self.radar.pulse.kept_width)
        begin = 2 * self.recording.near_m / self.light_speed - 2 * reach
        end = 2 * self.recording.far_m / self.light_speed + 2 * reach
        rows = [[echo.amplitude for echo in self.echoes(n) if begin < echo.delay_s < end] for n in self.pulses()]
        level = max(float(np.linalg.norm(row)) for row in rows)
        gain = np.max(self.stc_gain(np.array([self.recording.near_m, self.recording.far_m])))
        filtered = self.classic and self.recording.processing == "MATCHED_FILTER"
        return level * gain * (self.shape.width_s / 2 if filtered else 1.0)

    def samples(self):
        """Of the whole recording: a row for each pulse, or for each burst of range profiles."""
        if self.recording.processing == "SRP":
            return self.range_profiles()
        row = self.raw_row if self.recording.processing == "RAW" else self.compressed_row
        return np.array([row(number) for number in self.pulses()])
