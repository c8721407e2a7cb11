"""The scenes of the tests of SICD, each with its targets and how it is focused."""

import numpy as np

from sicd_file import anchored, ecf

ANCHOR = (-33.9, 18.4, 120.0, 30.0)
POINTS = [(0, 0, 0), (30, 40, 0), (-35, -30, 0)]

AIR = """format = "sarsim 2"
[[platform]]
name = "Plane"
{rotation}[platform.path]
type = "points"
x = {{ interpolation = "cubic", points = [[0, {x0}], [1, {x1}]] }}
y = {{ interpolation = "cubic", points = {y} }}
z = {{ interpolation = "cubic", points = {z} }}
[[target]]
positions = {points}
[[radar]]
name = "Radar1"
platform = "Plane"
pulse = {{ type = "chirp", bandwidth = "100 MHz", width = "1 us" }}
repetition = "{prf} Hz"
carrier = "9.6 GHz"
power = "1 kW"
antenna = {antenna}
beam = {beam}
[[recording]]
radar = "Radar1"
file = "sim.h5"
format = "hdf5"
range = {range}
time = {time}
sample_rate = "150 MHz"
"""

ORBIT = """format = "sarsim 2"
[world]
frame = "earth"
epoch = "2025-03-14T12:00:00Z"
anchor = { latitude = "-33.958 deg", longitude = "18.4813 deg" }
[[platform]]
name = "Satellite"
rotation = "zero-doppler"
[platform.path]
type = "orbit"
semi_major_axis = "7070.5 km"
eccentricity = 0.00114
inclination = "98.1817 deg"
node_longitude = "8.4 deg"
perigee = "90 deg"
anomaly = "-125 deg"
[[target]]
position = { latitude = "-33.958 deg", longitude = "18.4813 deg" }
[[target]]
position = { latitude = "-33.9575 deg", longitude = "18.4813 deg", height = "20 m" }
[[radar]]
name = "SAR"
platform = "Satellite"
pulse = { type = "chirp", bandwidth = "100 MHz", width = "2 us" }
repetition = "3 kHz"
carrier = "9.65 GHz"
power = "5 kW"
antenna = { type = "sinx", elevation_width = "2 deg", azimuth_width = "0.3 deg" }
beam = { type = "fixed", azimuth = "180 deg", elevation = "-60 deg" }
[[recording]]
radar = "SAR"
file = "cape.h5"
format = "hdf5"
range = ["827.9 km", "828.3 km"]
time = ["-0.2 s", "0.2 s"]
sample_rate = "120 MHz"
bits = 16
"""


def air(**values):
    """A flight past the origin along x, 3 km away and 1 km high."""
    values = {
        "rotation": "",
        "prf": 800,
        "x0": 0,
        "x1": 100,
        "y": "[[0, -3000]]",
        "z": "[[0, 1000]]",
        "points": str([list(p) for p in POINTS]),
        "antenna": '{ type = "sinx", elevation_width = "30 deg", azimuth_width = "4 deg" }',
        "beam": '{ type = "fixed", elevation = "-18.435 deg", azimuth = "0 deg" }',
        "range": '["3000 m", "3400 m"]',
        "time": '["-2.4 s", "2.4 s"]',
    } | values
    return AIR.format(**values)


def laid(points):
    return [anchored(np.array(p, float), ANCHOR) for p in points]


PLACE = ("--anchor", ",".join(map(str, ANCHOR)))
# name: script, options of focus, where the targets are
SCENES = {
    # Flown along +x, the origin is on the left: columns count against the flight.
    "stripmap_left": (air(), ("--algorithm", "omega-k", *PLACE), laid(POINTS)),
    "stripmap_right": (
        air(x1=-100),
        ("--algorithm", "range-doppler", "--window", "taylor:35:5", *PLACE),
        laid(POINTS),
    ),
    "squinted": (
        air(
            x0=-529,
            x1=-429,
            beam='{ type = "fixed", elevation = "-18.2 deg", azimuth = "9.5 deg" }',
            range='["3000 m", "3500 m"]',
        ),
        ("--algorithm", "omega-k", *PLACE),
        laid(POINTS),
    ),
    "spotlight": (
        air(prf=600, beam='{ type = "spot", point = [0, 0, 0] }', time='["-0.8 s", "0.8 s"]'),
        ("--algorithm", "chirp-scaling", *PLACE),
        laid(POINTS),
    ),
    # Swaying; the second target stands 12 m above the grid, and lies over.
    "ground": (
        air(
            prf=500,
            y="[[-2, -3000], [-1, -2999.4], [0, -3000.5], [1, -2999.7], [2, -3000]]",
            points=str([[0, 0, 0], [30, 40, 12], [-35, -30, 0]]),
        ),
        ("--algorithm", "back-projection", "--grid", "ground", "--height", "0", "--doppler-bandwidth", 450, "--azimuth", "-100:100", *PLACE),
        laid([(0, 0, 0), (30, 40, 12), (-35, -30, 0)]),
    ),
    "orbit": (
        ORBIT,
        ("--algorithm", "omega-k"),
        [ecf(-33.958, 18.4813, 0), ecf(-33.9575, 18.4813, 20)],
    ),
    "orbit_ground": (
        ORBIT,
        ("--algorithm", "back-projection", "--grid", "ground", "--height", "0"),
        [ecf(-33.958, 18.4813, 0), ecf(-33.9575, 18.4813, 20)],
    ),
}
