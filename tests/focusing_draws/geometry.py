"""Random geometries for synthetic aperture: a radar, a flight and one point, as a scene of the program and as numbers.

Everything is drawn from wide ranges, then made smaller until samples and pulses are few: the aperture is shortened, the
near edge of the window moved up. Pulses are as close as the Doppler frequencies of the point need, at the upper end of
the band. Draws from MIXED on sway besides climbing or turning, and the beam points beside the point."""

import dataclasses
import math

import numpy as np

LIGHT = 299792458.0
MOST_PULSES = 400
MOST_SAMPLES = 500
MOST_IMAGE = 1.5e6
LEAST_CELLS = 12.0
MOST_ACCELERATION = 20.0  # Of sways and turns, m/s^2.
MIXED = 1_000_000
PATHS = ("line", "line", "line", "climb", "sway", "sway", "turn")


@dataclasses.dataclass
class Draw:
    """One geometry; lengths in metres, angles in radians, frequencies in Hz."""

    number: int
    carrier: float
    bandwidth: float
    pulse_width: float
    sample_rate: float
    slant: float  # To the point from the middle of the flight.
    height: float
    squint: float
    beam: float
    spot: bool  # The beam is held on the point; else it is fixed.
    path: str
    climb: float
    sways: list  # Of (axis, amplitude, frequency, phase).
    turn: float  # By which the heading changes over the flight, positive to the right.
    speed: float
    duration: float
    prf: float
    near: float
    far: float
    target: tuple
    aim: tuple = None  # Where the beam points; None: at the target.

    @property
    def cell(self):
        """Resolution of range."""
        return LIGHT / (2 * self.bandwidth)

    @property
    def wavelength(self):
        """At the carrier."""
        return LIGHT / self.carrier

    def words(self):
        """One line about it."""
        return (
            f"{self.carrier / 1e9:.4g} GHz, B/f0 {self.bandwidth / self.carrier:.3g}, range {self.slant:.4g} m, "
            f"height {self.height:.3g} m, squint {math.degrees(self.squint):.1f}, beam {math.degrees(self.beam):.3g} "
            f"{'spot' if self.spot else 'strip'}, {self.path}"
            + (f" {math.degrees(self.climb):.2g} deg" if self.climb else "")
            + (f" {math.degrees(self.turn):.3g} deg" if self.path == "turn" else "")
            + (f" {[round(s[1] / self.cell, 2) for s in self.sways]} cells" if self.sways else "")
            + f", window {self.near:.4g} to {self.far:.4g} m, {round(self.prf * self.duration) + 1} pulses"
        )


def log_uniform(random, low, high):
    """A number whose logarithm is even between those of two others."""
    return math.exp(random.uniform(math.log(low), math.log(high)))


def flight(draw, times):
    """Positions of the antenna."""
    straight = draw.speed * times
    if draw.path == "turn":
        rate = draw.turn / draw.duration
        radius = draw.speed / rate
        heading = rate * times  # From the x axis to the right, towards -y.
        places = np.stack([radius * np.sin(heading), -radius * (1 - np.cos(heading)), np.full_like(times, draw.height)], 1)
    else:
        places = np.stack(
            [
                straight * math.cos(draw.climb),
                np.zeros_like(times),
                draw.height + straight * math.sin(draw.climb),
            ],
            1,
        )
    for axis, amplitude, frequency, phase in draw.sways:
        places[:, "xyz".index(axis)] += amplitude * np.sin(2 * math.pi * frequency * times + phase)
    return places


def scene(draw):
    """The text of format 2."""
    if draw.path == "turn":
        radius = abs(draw.speed * draw.duration / draw.turn)
        half = draw.turn / 2
        sign = math.copysign(1.0, draw.turn)
        start = (-radius * math.sin(abs(half)), -sign * radius * (1 - math.cos(half)), draw.height)
        heading = 90.0 - math.degrees(half)
        path = (
            f'{{ type = "legs", start = [{float(start[0])!r}, {float(start[1])!r}, {float(start[2])!r}], heading = "{float(heading)!r} deg", '
            f'speed = "{float(draw.speed)!r} m/s", start_time = "{float(-draw.duration / 2)!r} s", '
            f'legs = [{{ leg = "turn", angle = "{float(math.degrees(draw.turn))!r} deg", radius = "{float(radius)!r} m" }}] }}'
        )
    else:
        velocity = (draw.speed * math.cos(draw.climb), 0.0, draw.speed * math.sin(draw.climb))
        path = f'{{ type = "line", start = [0.0, 0.0, {float(draw.height)!r}], velocity = [{float(velocity[0])!r}, 0.0, {float(velocity[2])!r}] }}'
    sways = ", ".join(
        f'{{ axis = "{a}", amplitude = "{float(m)!r} m", frequency = "{float(f)!r} Hz", phase = "{float(math.degrees(p))!r} deg" }}'
        for a, m, f, p in draw.sways
    )
    x, y, z = draw.aim or draw.target
    elevation = math.degrees(math.atan2(z - draw.height, math.hypot(x, y)))
    azimuth = math.degrees(math.atan2(x, y))
    beam = (
        f'{{ type = "spot", point = [{float(x)!r}, {float(y)!r}, {float(z)!r}] }}'
        if draw.spot
        else f'{{ type = "fixed", elevation = "{float(elevation)!r} deg", azimuth = "{float(azimuth)!r} deg" }}'
    )
    width = min(math.degrees(draw.beam), 40.0) if draw.spot else math.degrees(draw.beam)
    time = draw.duration / 2 * (1 + 1e-9)
    return f"""format = "sarsim 2"
# {draw.words()}
[options]
ambiguous_echoes = "none"
[[platform]]
name = "Plane"
path = {path}
{f"oscillations = [{sways}]" if sways else ""}
[[target]]
position = [{float(draw.target[0])!r}, {float(draw.target[1])!r}, {float(draw.target[2])!r}]
rcs = "100 m2"
[[radar]]
name = "Radar"
platform = "Plane"
pulse = {{ type = "chirp", bandwidth = "{float(draw.bandwidth)!r} Hz", width = "{float(draw.pulse_width)!r} s" }}
repetition = "{float(draw.prf)!r} Hz"
carrier = "{float(draw.carrier)!r} Hz"
power = "1 kW"
antenna = {{ type = "sinx", elevation_width = "{float(max(width, 20.0))!r} deg", azimuth_width = "{float(width)!r} deg" }}
beam = {beam}
[[recording]]
radar = "Radar"
file = "echoes.h5"
format = "hdf5"
range = ["{float(draw.near)!r} m", "{float(draw.far)!r} m"]
time = ["{float(-time)!r} s", "{float(time)!r} s"]
sample_rate = "{float(draw.sample_rate)!r} Hz"
"""


def spacing(draw, distances, lengths):
    """Between pulses, so that all Doppler frequencies of the point are told apart, with 40 % to spare."""
    slopes = np.gradient(distances, lengths)
    waves = [2 * f / LIGHT * s for f in (draw.carrier - draw.bandwidth / 2, draw.carrier + draw.bandwidth / 2) for s in slopes]
    return 1 / (1.4 * (max(waves) - min(waves)))


def attempt(random, number):
    """A geometry, or nothing where what was drawn does not fit together."""
    carrier = log_uniform(random, 30e6, 94e9)
    bandwidth = carrier * log_uniform(random, 0.0005, 1.0)
    cell = LIGHT / (2 * bandwidth)
    slant = log_uniform(random, 20.0, 1e6)
    if slant < 8 * cell:
        return None
    height = 0.0 if random.random() < 0.15 else log_uniform(random, 1.0, min(0.95 * slant, 8e5))
    squint = 0.0 if random.random() < 0.4 else math.radians(random.uniform(0.0, 60.0))
    beam = math.radians(log_uniform(random, 0.3, 90.0))
    path = PATHS[random.integers(len(PATHS))]
    mixed = number >= MIXED
    climb = math.radians(random.uniform(-10.0, 10.0)) if path == "climb" or (mixed and path != "turn") else 0.0
    sine, cosine = math.sin(climb), math.cos(climb)
    x = (slant * math.sin(squint) + height * sine) / cosine
    across = slant * slant - height * height - x * x
    if across <= (0.05 * slant) ** 2:
        return None
    draw = Draw(
        number=number,
        carrier=carrier,
        bandwidth=bandwidth,
        pulse_width=random.uniform(80.0, 200.0) / bandwidth,
        sample_rate=bandwidth * random.uniform(1.4, 1.8),
        slant=slant,
        height=height,
        squint=squint,
        beam=beam,
        spot=bool(random.random() < 0.5) or math.degrees(beam) > 40.0,
        path=path,
        climb=climb,
        sways=[],
        turn=0.0,
        speed=7500.0 if height > 1e5 else log_uniform(random, 2.0, min(300.0, max(4.0, slant / 4))),
        duration=0.0,
        prf=0.0,
        near=0.0,
        far=0.0,
        target=(x, math.sqrt(across), 0.0),
    )
    if mixed:
        aside = random.uniform(-0.25, 0.25) * beam * slant
        draw.aim = (x + aside, draw.target[1] * random.uniform(0.97, 1.03), 0.0)
    return shaped(random, draw)


def shaped(random, draw):
    """Aperture, sway, turn, pulses and window of a draw."""
    angle = min(draw.beam, math.radians(100.0))
    turn = log_uniform(random, 0.02, 1.5) * (1 if random.random() < 0.5 else -1)
    sway = [(axis, random.uniform(0.0, 30.0), random.uniform(0.4, 3.0), random.uniform(0.0, 2 * math.pi)) for axis in "yz"]
    closest = draw.slant * math.cos(draw.squint)
    for _ in range(60):
        low, high = max(draw.squint - angle / 2, -1.31), min(draw.squint + angle / 2, 1.31)
        # The middle of the flight stays where the beam's is; the flight is even about it.
        reach = closest * min(math.tan(high) - math.tan(draw.squint), math.tan(draw.squint) - math.tan(low))
        draw.duration = 2 * reach / draw.speed
        # While an echo is under way the antenna is taken to fly straight on.
        delay = 2 * draw.slant / LIGHT
        acceleration = min(MOST_ACCELERATION, draw.wavelength / (100 * delay**2))
        most_turn = acceleration * draw.duration / draw.speed
        draw.turn = math.copysign(min(abs(turn) * angle, most_turn), turn) if draw.path == "turn" else 0.0
        draw.sways = []
        if draw.path == "sway" or draw.number >= MIXED:
            for axis, cells, periods, phase in sway:
                frequency = periods / draw.duration
                rate = 2 * math.pi * frequency
                amplitude = min(
                    cells * draw.cell, 0.02 * draw.slant, 0.05 * draw.speed / rate, acceleration / rate**2
                )
                draw.sways.append((axis, amplitude, frequency, phase))
        times = np.linspace(-0.5, 0.5, 801) * draw.duration
        places = flight(draw, times)
        distances = np.linalg.norm(places - np.array(draw.target), axis=1)
        lengths = draw.speed * times
        step = spacing(draw, distances, lengths)
        pulses = 2 * reach / step
        if places[:, 2].min() < 0.0 or pulses < 24:
            return None
        # Of the Doppler frequencies at the carrier, in cells of the aperture: fewer make no synthetic aperture.
        if 2 * reach * (math.sin(high) - math.sin(low)) * 2 / draw.wavelength < LEAST_CELLS:
            return None
        span = distances.max() - distances.min()
        if pulses <= MOST_PULSES and span * 2 * draw.sample_rate / LIGHT < 0.6 * MOST_SAMPLES:
            break
        angle *= 0.8
    else:
        return None
    draw.prf = draw.speed / step
    draw.duration = math.floor(draw.duration * draw.prf / 2) * 2 / draw.prf
    column = LIGHT / (2 * draw.sample_rate)
    pulse = LIGHT / 2 * draw.pulse_width
    nearest, farthest = distances.min() - 6 * draw.cell, distances.max() + 6 * draw.cell
    farthest += random.uniform(0.0, 0.3) * (farthest - nearest)
    near = min(log_uniform(random, column, 0.95 * draw.slant), nearest)
    draw.far = farthest + pulse
    draw.near = max(near, column, draw.far - MOST_SAMPLES * column)
    if draw.near > nearest or draw.near <= 0.0:
        return None
    while image_samples(draw, step, low, high) > MOST_IMAGE and draw.near < nearest:
        draw.near = min(draw.far - 0.8 * (draw.far - draw.near), nearest)
    return draw if image_samples(draw, step, low, high) <= MOST_IMAGE else None


def image_samples(draw, step, low, high):
    """Of the image, about: a squint lays its columns beside each other, a wide aperture widens their spectrum."""
    cosines = [math.cos(low), math.cos(high)] + ([1.0] if low < 0.0 < high else [])
    widened = draw.bandwidth + draw.carrier * (max(cosines) - min(cosines))
    columns = 2 * (draw.far - draw.near) / LIGHT * max(draw.sample_rate, 1.1 * widened)
    rows = 1.3 * draw.speed * draw.duration / step + (draw.far - draw.near) * math.tan(draw.squint) / step
    return rows * columns


def draw_of(number):
    """The geometry of a number: the same on every machine."""
    random = np.random.default_rng([54, number])
    while True:
        found = attempt(random, number)
        if found:
            return found
