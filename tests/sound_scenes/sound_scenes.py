"""Random scenes that a radar engineer would call sound: `sarsim check` has to be nearly silent about them.

    sound_scenes.py SARSIM [--count N] [--seed N] [--all]

Draws N scenes of nine kinds (strip and spotlight SAR from the air, in gusts, with an antenna by points, from orbit, search
radar, MTI, stepped frequencies, short range), checks each and counts the warnings and errors by their text without numbers.
Exit status 1 if one of them appears on more than 1 % of the scenes (on more than two if there are fewer than 300 scenes).
--all prints one scene of each message.
"""

import argparse
import collections
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

C = 299792458.0
HEADER = 'format = "sarsim 2"\n'


def number(x):
    return f"{x:.9g}"


def vector(values):
    return "[" + ", ".join(number(v) for v in values) + "]"


def targets(points, extra=""):
    return f"[[target]]\npositions = [{', '.join(vector(p) for p in points)}]\n{extra}"


def recording(near_m, far_m, begin_s, end_s, rate_hz, more=""):
    return (f'[[recording]]\nradar = "R"\nfile = "r.h5"\nformat = "hdf5"\nrange = ["{number(near_m)} m", "{number(far_m)} m"]\n'
            f'time = ["{number(begin_s)} s", "{number(end_s)} s"]\nsample_rate = "{number(rate_hz)} Hz"\n{more}')


def chirp(band_hz, width_s):
    return f'pulse = {{ type = "chirp", bandwidth = "{number(band_hz)} Hz", width = "{number(width_s)} s" }}\n'


class Flight:
    """An aircraft along y at x = 0 that looks to its right, at level ground."""

    def __init__(self, draw):
        self.height_m = draw.uniform(1500, 8000)
        depression = math.radians(draw.uniform(20, 50))
        self.range_m = self.height_m / math.sin(depression)
        self.depression_deg = math.degrees(depression)
        self.ground_m = self.height_m / math.tan(depression)
        self.speed_mps = draw.uniform(60, 200)
        self.carrier_hz = draw.choice([1.3e9, 3.2e9, 5.4e9, 9.6e9, 16e9])
        self.wavelength_m = C / self.carrier_hz
        length_m = draw.uniform(0.8, 2.5) * max(1.0, 10 * self.wavelength_m)
        self.width_rad = 0.886 * self.wavelength_m / length_m
        self.band_hz = min(draw.uniform(30e6, 150e6), 0.1 * self.carrier_hz)
        self.pulse_s = draw.uniform(1e-6, 6e-6)
        highest_hz = C / 2 / (self.range_m + 3000)
        self.prf_hz = min(4 * self.speed_mps / self.wavelength_m * math.sin(1.3 * self.width_rad) * draw.uniform(1.1, 1.6) + 50, 0.9 * highest_hz)

    def points(self, draw, count):
        # Far enough apart to be resolved.
        return [(self.ground_m + draw.uniform(-15, 15) + 30 * (k // 3), 20 * (k % 3 - 1) + draw.uniform(-3, 3), draw.uniform(0, 2)) for k in range(count)]

    def radar(self, beam, power="1 kW"):
        return (f'[[radar]]\nname = "R"\nplatform = "Plane"\n{chirp(self.band_hz, self.pulse_s)}repetition = "{number(self.prf_hz)} Hz"\n'
                f'carrier = "{number(self.carrier_hz)} Hz"\npower = "{power}"\n'
                f'antenna = {{ type = "sinx", azimuth_width = "{number(math.degrees(self.width_rad))} deg", elevation_width = "12 deg" }}\n{beam}\n')

    def platform(self, more=""):
        return (f'[[platform]]\nname = "Plane"\npath = {{ type = "line", start = [0, 0, {number(self.height_m)}], '
                f"velocity = [0, {number(self.speed_mps)}, 0] }}\n{more}")

    def recording(self, half_s):
        bent_m = (self.speed_mps * half_s + 30) ** 2 / 2 / self.range_m
        echo_m = C * self.pulse_s / 2
        return recording(self.range_m - 40 - 30, self.range_m + 120 + bent_m + echo_m, -half_s, half_s, 1.25 * self.band_hz)


def strip(draw, gusts=False):
    flight = Flight(draw)
    if gusts:  # The beam turns with the velocity.
        flight.prf_hz = min(1.6 * flight.prf_hz, 0.9 * C / 2 / (flight.range_m + 3000))
    half_s = (flight.range_m * math.tan(0.75 * flight.width_rad) + 60) / flight.speed_mps
    error = (f'position_error = {{ type = "gusts", turbulence = "light", height = "{number(max(flight.height_m, 600))} m", '
             f'airspeed = "{number(flight.speed_mps)} m/s" }}\n') if gusts else ""
    beam = f'beam = {{ type = "fixed", azimuth = "90 deg", elevation = "{number(-flight.depression_deg)} deg" }}'
    return HEADER + flight.platform(error) + targets(flight.points(draw, 6)) + flight.radar(beam) + flight.recording(half_s)


def spotlight(draw):
    flight = Flight(draw)
    half_s = draw.uniform(0.7, 1.2) * flight.range_m * math.tan(flight.width_rad) / flight.speed_mps
    beam = f'beam = {{ type = "spot", point = [{number(flight.ground_m)}, 0, 0] }}'
    flight.prf_hz = min(max(flight.prf_hz, 5 * flight.speed_mps / flight.wavelength_m * math.sin(1.3 * flight.width_rad + math.atan(flight.speed_mps * half_s / flight.range_m))),
                        0.9 * C / 2 / (flight.range_m + 3000))
    return HEADER + flight.platform() + targets(flight.points(draw, 4)) + flight.radar(beam) + flight.recording(half_s)


def by_points(draw):
    """The strip with an antenna whose cuts are measured all around."""
    flight = Flight(draw)
    half_s = (flight.range_m * math.tan(0.75 * flight.width_rad) + 60) / flight.speed_mps
    width_deg = math.degrees(flight.width_rad)
    cut = [[0, 0], [width_deg / 2, -3], [width_deg, -13], [2 * width_deg, -25], [90, -40], [180, -45]]
    high = [[0, 0], [6, -3], [12, -13], [30, -25], [90, -40]]
    both = lambda half: [[-a, g] for a, g in reversed(half) if 0 < a < 180] + half
    beam = f'beam = {{ type = "fixed", azimuth = "90 deg", elevation = "{number(-flight.depression_deg)} deg" }}'
    radar = re.sub(r"antenna = .*\n", f'antenna = {{ type = "points", azimuth = {{ points = {both(cut)} }}, elevation = {{ points = {both(high)} }} }}\n', flight.radar(beam))
    return HEADER + flight.platform() + targets(flight.points(draw, 6)) + radar + flight.recording(half_s)


def orbit(draw):
    look = draw.uniform(22, 38)
    height_m = 693e3
    wavelength_m = C / 5.405e9
    earth_m = 6371e3
    incidence = math.asin((earth_m + height_m) / earth_m * math.sin(math.radians(look)))
    angle = incidence - math.radians(look)
    range_m = earth_m * math.sin(angle) / math.sin(math.radians(look))
    state = [earth_m + 7e3 + height_m, 0.0, 0.0]
    speed = math.sqrt(3.986004418e14 / state[0])
    band_hz = draw.uniform(20e6, 80e6)
    pulse_s = draw.uniform(5e-6, 20e-6)
    # Seen from above the equator, to the right of a northbound orbit.
    return (HEADER + '[world]\nframe = "earth"\nepoch = "2024-03-01T06:00:00Z"\n'
            f'anchor = {{ latitude = "0 deg", longitude = "{number(math.degrees(angle))} deg" }}\n'
            '[[platform]]\nname = "Satellite"\n'
            f'path = {{ type = "state", position = {vector(state)}, velocity = [0, 0, {number(speed)}] }}\nrotation = "zero-doppler"\n'
            f'[[target]]\nposition = {{ latitude = "0 deg", longitude = "{number(math.degrees(angle))} deg", height = "0 m" }}\nrcs = "30 dBsm"\n'
            f'[[radar]]\nname = "R"\nplatform = "Satellite"\n{chirp(band_hz, pulse_s)}repetition = "2600 Hz"\ncarrier = "5.405 GHz"\npower = "4 kW"\n'
            f'antenna = {{ type = "sinx", elevation_width = "6 deg", azimuth_width = "{number(math.degrees(0.886 * wavelength_m / 12.3))} deg" }}\n'
            f'beam = {{ type = "fixed", azimuth = "180 deg", elevation = "{number(look - 90)} deg" }}\n'
            + recording(range_m - 14e3, range_m + 14e3 + C * pulse_s / 2, -0.5, 0.5, 1.2 * band_hz))


def search(draw):
    carrier_hz = draw.choice([1.3e9, 3e9, 5.6e9])
    prf_hz = draw.uniform(1500, 3000)
    far_m = 0.85 * C / 2 / prf_hz
    blind_mps = C / carrier_hz * prf_hz / 2
    speed = blind_mps * draw.uniform(0.1, 0.4)
    azimuth = draw.uniform(0, 2 * math.pi)
    start = [0.6 * far_m * math.sin(azimuth), 0.6 * far_m * math.cos(azimuth), 1000]
    velocity = [-speed * math.sin(azimuth), -speed * math.cos(azimuth), 0]
    width_s = draw.uniform(5e-6, 20e-6)
    return (HEADER + f'[[platform]]\nname = "Aircraft"\npath = {{ type = "line", start = {vector(start)}, velocity = {vector(velocity)} }}\n'
            f'[[target]]\nplatform = "Aircraft"\nrcs = "5 m2"\n[[target]]\nposition = {vector([0.4 * far_m, 0.2 * far_m, 0])}\nrcs = "20 m2"\n'
            f'[[radar]]\nname = "R"\n{chirp(2e6, width_s)}repetition = "{number(prf_hz)} Hz"\ncarrier = "{number(carrier_hz)} Hz"\npower = "2 kW"\n'
            'transmit_gain = "34 dB"\nreceive_gain = "34 dB"\nlosses = "6 dB"\nnoise_temperature = "290 K"\n'
            'antenna = { type = "sinx", elevation_width = "20 deg", azimuth_width = "2 deg" }\n'
            f'beam = {{ type = "rotating", elevation = "0 deg", rate = "{number(draw.uniform(90, 360))} deg/s" }}\nwindow = "hamming"\n'
            + recording(2 * C * width_s / 2, far_m, 0, 4.0, 2.5e6, 'processing = "matched-filter"\n'))


def mti(draw):
    carrier_hz = draw.uniform(3e9, 16e9)
    prf_hz = draw.uniform(3e3, 8e3)
    range_m = draw.uniform(3e3, 10e3)
    speed = C / carrier_hz * prf_hz / 2 * draw.uniform(0.08, 0.45)
    return (HEADER + f'[[platform]]\nname = "Mast"\nposition = [0, 0, 20]\n[[platform]]\nname = "Car"\npath = {{ type = "line", start = [20, {number(range_m)}, 0], velocity = [0, {number(-speed)}, 0] }}\n'
            f'[[target]]\nposition = [0, {number(range_m + 200)}, 5]\nrcs = "500 m2"\n[[target]]\nplatform = "Car"\nrcs = "5 m2"\n'
            f'[[radar]]\nname = "R"\nplatform = "Mast"\n{chirp(5e6, 10e-6)}repetition = "{number(prf_hz)} Hz"\ncarrier = "{number(carrier_hz)} Hz"\npower = "100 W"\n'
            'transmit_gain = "30 dB"\nreceive_gain = "30 dB"\nnoise_temperature = "290 K"\n'
            'antenna = { type = "sinx", elevation_width = "5 deg", azimuth_width = "5 deg" }\nbeam = { type = "fixed", elevation = "0 deg", azimuth = "0 deg" }\nwindow = "hamming"\n'
            + recording(range_m - 500, range_m + 2500, 0, 0.04, 6.25e6))


def stepped(draw):
    range_m = draw.uniform(5e3, 15e3)
    turn = draw.uniform(0.3, 0.9)
    step_hz = 2.5e6
    points = [[12, 0, 0], [4, 5, 0], [4, -5, 0], [-10, 3, 1], [-10, -3, 1]]
    return (HEADER + f'[[platform]]\nname = "Ship"\nposition = [0, {number(range_m)}, 0]\nrotation_rate = [0, 0, {number(turn)}]\n'
            f'[[target]]\nplatform = "Ship"\npositions = {points}\n'
            f'[[radar]]\nname = "R"\npulse = {{ type = "mono", width = "400 ns" }}\nrepetition = "6 kHz"\n'
            f'carrier = {{ type = "stepped", first = "9 GHz", step = "{number(step_hz)} Hz", count = 64, pulses = 1 }}\npower = "10 kW"\n'
            'antenna = { type = "sinx", elevation_width = "10 deg", azimuth_width = "6 deg" }\nbeam = { type = "fixed", elevation = "0 deg", azimuth = "0 deg" }\nwindow = "hamming"\n'
            + recording(range_m - 150, range_m + 150, 0, 64 * 32 / 6e3, 5e6, 'pulse_position = "centre"\n'))


def short_range(draw):
    width_s = 20e-9
    range_m = draw.uniform(15, 60)
    return (HEADER + f'[[platform]]\nname = "Car"\npath = {{ type = "line", start = [1, {number(range_m)}, 0.5], velocity = [0, {number(draw.uniform(-8, 8))}, 0] }}\n'
            f'[[target]]\nplatform = "Car"\nrcs = "10 m2"\n[[target]]\nposition = [-4, {number(0.7 * range_m)}, 1]\nrcs = "1 m2"\n'
            f'[[radar]]\nname = "R"\n{chirp(1e9, width_s)}repetition = "20 kHz"\ncarrier = "77 GHz"\npower = "0.01 W"\ntransmit_gain = "12 dB"\nreceive_gain = "12 dB"\n'
            'antenna = { type = "sinx", elevation_width = "20 deg", azimuth_width = "40 deg" }\nbeam = { type = "fixed", elevation = "0 deg", azimuth = "0 deg" }\n'
            + recording(3.1, range_m + 20, 0, 0.01, 1.25e9))


KINDS = {"strip": strip, "gusts": lambda draw: strip(draw, True), "spotlight": spotlight, "antenna by points": by_points, "orbit": orbit,
         "search": search, "mti": mti, "stepped": stepped, "short range": short_range}


def plain(message):
    """The words of a message without its numbers and names."""
    message = re.sub(r"\(estimate from [^)]*\)", "", message)
    return re.sub(r"\s+", " ", re.sub(r"-?\d[\d.eE+-]*", "#", message)).strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=3)
    parser.add_argument("--all", action="store_true")
    arguments = parser.parse_args()
    met = collections.defaultdict(list)
    silent = 0
    with tempfile.TemporaryDirectory() as folder:
        for k in range(arguments.count):
            kind = list(KINDS)[k % len(KINDS)]
            scene = pathlib.Path(folder, "scene.toml")
            scene.write_text(KINDS[kind](random.Random(arguments.seed * 1_000_003 + k)), encoding="utf-8")
            out = subprocess.run([arguments.program, "check", "--json", str(scene)], capture_output=True, text=True)
            report = json.loads(out.stdout)
            loud = {plain(p["message"]): p for p in report["scripts"][0]["problems"] if p["severity"] != "note"}
            silent += not loud
            for words, problem in loud.items():
                met[words].append((kind, k, problem))
    limit = max(2, arguments.count // 100)
    print(f"{silent} of {arguments.count} sound scenes without a warning")
    failed = False
    for words, cases in sorted(met.items(), key=lambda item: -len(item[1])):
        failed = failed or len(cases) > limit
        kinds = collections.Counter(kind for kind, _, _ in cases)
        print(f"{len(cases):5d}  {words}  ({', '.join(f'{name} {n}' for name, n in kinds.items())})")
        if arguments.all:
            print(f"       e.g. {cases[0][0]} {cases[0][1]}: {json.dumps(cases[0][2])[:400]}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
