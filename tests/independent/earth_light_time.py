#!/usr/bin/env python3
"""The program's delays over a turning Earth against the same light-time equation solved in axes that do not turn, in
extended precision and from formulas alone.

    earth_light_time.py            SARSIM_BUILT_PROGRAM names the program, SARSIM_PROGRAM another one

A satellite on a circular orbit and points on the ellipsoid; X and Ka band. What is allowed is 1e-4 of a wavelength of
the way out and home.
"""

import csv
import io
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import with_numpy  # noqa: E402, F401

import numpy as np  # noqa: E402

import light_time
from running import program

LIGHT_SPEED = np.longdouble(299792458)
EARTH_RATE = np.longdouble("7.292115e-5")
SEMI_MAJOR = np.longdouble(6378137)
FLATTENING = 1 / np.longdouble("298.257223563")
MU = np.longdouble("3.986004418e14")
AXIS = np.longdouble(7071000)
INCLINATION = np.radians(np.longdouble("98.18"))
LATITUDE_ARGUMENT = np.radians(np.longdouble(-17))  # at time 0, from the ascending node
NODE = np.radians(np.longdouble(-75))

# Latitude, longitude [deg], height [m]: near the middle of the swath, at its edges, and high above it.
PLACES = [(-16.0, -79.9, 0.0), (-16.3, -79.2, 350.5), (-15.5, -81.5, 12.25), (-17.0, -80.5, 8000.0)]
CARRIERS_HZ = {"X": 9.65e9, "Ka": 35.75e9}


def turned(angle, vector):
    """About the z axis, counterclockwise."""
    cosine, sine = np.cos(angle), np.sin(angle)
    x, y, z = vector
    return np.array([cosine * x - sine * y, sine * x + cosine * y, z])


def orbit(time_s):
    """Place and velocity of the satellite in axes that rest and are those of the Earth at time 0."""
    rate = np.sqrt(MU / AXIS**3)
    u = LATITUDE_ARGUMENT + rate * time_s

    def from_plane(along, across):
        in_plane = np.array([along, across * np.cos(INCLINATION), across * np.sin(INCLINATION)])
        return turned(NODE, in_plane)

    return AXIS * from_plane(np.cos(u), np.sin(u)), AXIS * rate * from_plane(-np.sin(u), np.cos(u))


def over_earth(time_s):
    """The same over the turning Earth."""
    place, velocity = orbit(time_s)
    spin = EARTH_RATE * np.array([-place[1], place[0], np.longdouble(0)])
    return turned(-EARTH_RATE * time_s, place), turned(-EARTH_RATE * time_s, velocity - spin)


def ecef(latitude_deg, longitude_deg, height_m):
    """Earth-fixed place of geodetic coordinates."""
    latitude, longitude = np.radians(np.longdouble(latitude_deg)), np.radians(np.longdouble(longitude_deg))
    e2 = FLATTENING * (2 - FLATTENING)
    normal = SEMI_MAJOR / np.sqrt(1 - e2 * np.sin(latitude) ** 2)
    out = (normal + height_m) * np.cos(latitude)
    up = (normal * (1 - e2) + height_m) * np.sin(latitude)
    return np.array([out * np.cos(longitude), out * np.sin(longitude), up])


def scene(carrier_hz):
    targets = "".join(
        f'[[target]]\nposition = {{ latitude = "{a} deg", longitude = "{b} deg", height = "{h} m" }}\n'
        for a, b, h in PLACES
    )
    return f"""format = "sarsim 2"
[world]
frame = "earth"
anchor = {{ latitude = "-16.1 deg", longitude = "-79.7 deg", height = "200 m", heading = "25 deg" }}
[[platform]]
name = "Satellite"
path = {{ type = "ephemeris", file = "orbit.csv" }}
rotation = "zero-doppler"
{targets}
[[radar]]
name = "SAR"
platform = "Satellite"
carrier = "{carrier_hz} Hz"
repetition = "20 Hz"
"""


def table(folder, carrier_hz):
    """Times and delays as the program has them."""
    folder = pathlib.Path(folder)
    lines = ["t,x,y,z,vx,vy,vz"]
    for time_s in range(-60, 61, 10):
        place, velocity = over_earth(np.longdouble(time_s))
        lines.append(",".join([str(time_s), *(repr(float(v)) for v in (*place, *velocity))]))
    (folder / "orbit.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    (folder / "scene.toml").write_text(scene(carrier_hz), encoding="utf-8")
    command = [program(), "geometry", str(folder / "scene.toml"), "--radar", "SAR", "--start", "-1", "--end", "1", "--csv"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"exit status {done.returncode}: {done.stderr}")
    return list(csv.DictReader(io.StringIO(done.stdout)))


def delay(place, send_time_s, earth_turns_light=True):
    """Out and home in axes that rest; or, wrongly, in those of the Earth as if they rested."""
    if earth_turns_light:

        def radar(time_s):
            return orbit(time_s)[0]

        def point(time_s):
            return turned(EARTH_RATE * time_s, place)

    else:

        def radar(time_s):
            return over_earth(time_s)[0]

        def point(_):
            return place

    return light_time.times_of_flight(radar, point, send_time_s, LIGHT_SPEED)[1]


def main():
    if np.finfo(np.longdouble).eps > 2e-19:
        print("long double has too few digits here: skipped")
        return 77
    failures = 0
    for band, carrier_hz in CARRIERS_HZ.items():
        wavelength_m = float(LIGHT_SPEED) / carrier_hz
        with tempfile.TemporaryDirectory() as folder:
            rows = table(folder, carrier_hz)
        worst = wrong = 0.0
        for row in rows:
            for number, place in enumerate(PLACES, 1):
                time_s = np.longdouble(int(row["pulse"])) / 20
                told_s = np.longdouble(row[f"target {number} delay_s"])
                worst = max(worst, abs(float((told_s - delay(ecef(*place), time_s)) * LIGHT_SPEED)))
                wrong = max(wrong, abs(float((told_s - delay(ecef(*place), time_s, False)) * LIGHT_SPEED)))
        allowed = 1e-4 * wavelength_m
        print(f"{band}: {len(rows)} pulses, {len(PLACES)} places: {worst:.2e} m of {allowed:.1e} m allowed; "
              f"{wrong:.2e} m were the Earth at rest while light is under way")
        failures += len(rows) < 40 or worst > allowed or wrong < 3 * allowed
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
