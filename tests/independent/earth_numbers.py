#!/usr/bin/env python3
"""Published numbers of the Earth, of orbits and of motion, reached through the command line.

    earth_numbers.py               SARSIM_BUILT_PROGRAM names the program, SARSIM_PROGRAM another one

Each line has a number, what it has to be and by how much it may be off; exit status 1 where one is. What is expected was
published, or follows from formulas here; nothing of the program's own is used.
"""

import csv
import io
import math
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import with_numpy  # noqa: E402, F401

import numpy as np  # noqa: E402

from running import program

LIGHT_SPEED = 299792458.0
WAVELENGTH = 0.05546576
CARRIER_HZ = LIGHT_SPEED / WAVELENGTH
EARTH_RATE, MU, J2, SEMI_MAJOR = 7.292115e-5, 3.986004418e14, 1.082626683e-3, 6378137.0
ECCENTRICITY_2 = (2.0 - 1.0 / 298.257223563) / 298.257223563
GRAVITY = 9.80665

# Published states, Earth-fixed: time, place, velocity; then the yaw that steers them to zero Doppler.
STATES = {
    "S1A, April 2024": ("2024-04-01T22:59:42Z", (1950200.216160, -4143460.384445, -5401629.615817),
                        (579.550068, -5889.842297, 4730.338429), 2.4642),
    "S1B, July 2020": ("2020-07-28T22:59:42Z", (2057735.247194, -6459802.571744, -2037501.319184),
                       (-886.585360, -2517.114487, 7108.167902), 3.6919),
    "S1A, July 2020": ("2020-07-23T22:59:42Z", (-1659308.501505, 6753819.113038, -1317158.267893),
                       (1875.247563, -954.537857, -7297.506531), 3.7884),
    "Envisat at the node": ("2006-07-20T02:38:29.989786Z", (2500149.266, -6714929.064, 0.0),
                            (-1530.874437, -560.873432, 7377.493385), 3.9214),
    "NISAR-like": ("2022-01-01T00:00:00Z", (3610265.1977, -6139538.4368, 159314.0910),
                   (-1429.7297, -647.2513, 7405.3360), 3.8958),
}
# Of the second state, looking right: look angle [deg], distance [km], Doppler frequency [Hz] when the satellite follows its
# inertial velocity, rate of the Doppler frequency [Hz/s], effective speed [m/s].
LOOKS = [(25, 784.8553, -7452.36, -2386.887, 7207.891), (30, 826.8470, -8816.40, -2265.100, 7206.987),
         (35, 882.2892, -10113.35, -2121.735, 7205.242), (40, 955.8742, -11333.33, -1956.760, 7202.224)]
# Geodetic latitude, longitude [deg], height [m], Earth-fixed place (CartConvert of GeographicLib).
PLACES = [((-33.95, 18.46, 100.0), (5023911.9730, 1677078.3275, -3541903.1355)),
          ((45.0, 45.0, 700000.0), (3544419.1451, 3544419.1451, 4982323.1557)),
          ((78.2298, 15.4078, 450.0), (1258427.1176, 346812.9001, 6222660.9372)),
          ((27.99, 86.93, 8820.0), (302271.4327, 5635928.3675, 2979666.1349)),
          ((90.0, 0.0, 0.0), (0.0, 0.0, 6356752.3142)),
          ((0.0, 0.0, 0.0), (6378137.0, 0.0, 0.0))]
TLE = """\
00005
1 00005U 58002B   00179.78495062  .00000023  00000-0  28098-4 0  4753
2 00005  34.2682 348.7242 1859667 331.7664  19.3264 10.82419157413667
"""
RADAR = f'[[radar]]\nname = "R"\nplatform = "P"\ncarrier = {CARRIER_HZ!r}\nrepetition = "1 kHz"\n'

failures = 0


def near(what, found, expected, tolerance):
    global failures
    right = bool(abs(found - expected) <= tolerance)
    failures += not right
    print(f"{'   ' if right else 'NO '} {what}: {found:.10g}, expected {expected:.10g} within {tolerance:.3g}")


class Scene:
    """A scene in a folder of its own."""

    def __init__(self, folder, text, **files):
        self.folder = pathlib.Path(folder)
        self.path = self.folder / "scene.toml"
        self.path.write_text('format = "sarsim 2"\n' + text, encoding="utf-8")
        for name, content in files.items():
            (self.folder / name.replace("_", ".")).write_text(content, encoding="utf-8")

    def run(self, command, *words):
        done = subprocess.run([program(), command, str(self.path), *words], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"sarsim {command} ended with status {done.returncode}\n{self.path.read_text()}\n{done.stderr}")
        return done.stdout

    def geometry(self, start=0.0, end=0.0):
        said = self.run("geometry", "--radar", "R", "--start", repr(start), "--end", repr(end), "--csv")
        rows = csv.DictReader(io.StringIO(said))
        return [{name: float(cell) for name, cell in row.items() if name != "utc"} for row in rows]

    def motion(self, end, spacing, platform="P"):
        """Rows t, x, y, z, vx, vy, vz; over the Earth Earth-fixed."""
        self.run("motion", "--platform", platform, "--start", "0", "--end", repr(end), "--spacing", repr(spacing),
                 "--out", str(self.folder / "m.csv"), "--force")
        lines = (self.folder / "m.csv").read_text(encoding="utf-8").splitlines()
        begin = next(number for number, line in enumerate(lines) if line.startswith("t,"))
        return np.array([[float(cell) for cell in line.split(",")] for line in lines[begin + 1 :]])


def earth(anchor, more=""):
    latitude, longitude, height = anchor
    return (f'[world]\nframe = "earth"\n{more}anchor = {{ latitude = "{latitude!r} deg", longitude = "{longitude!r} deg", '
            f'height = "{height!r} m" }}\n')


def place(latitude, longitude, height):
    return f'{{ latitude = "{latitude!r} deg", longitude = "{longitude!r} deg", height = "{height!r} m" }}'


# ---- Places ---------------------------------------------------------------------------------------------------------


def geodetic_places(folder):
    for (latitude, longitude, height), expected in PLACES:
        scene = Scene(folder, earth((-33.95, 18.46, 100.0)) +
                      f'[[platform]]\nname = "P"\nposition = {place(latitude, longitude, height)}\n')
        row = scene.motion(1.0, 0.25)[0]
        worst = max(abs(a - b) for a, b in zip(row[1:4], expected))
        near(f"Earth-fixed place of {latitude}, {longitude}, {height}: farthest coordinate [m]", worst, 0.0, 6e-5)
    scene = Scene(folder, earth((-33.95, 18.46, 100.0)) +
                  f'[[platform]]\nname = "P"\nposition = {place(-33.94, 18.47, 150.0)}\n[[target]]\n' + RADAR)
    row = scene.geometry()[0]
    for axis, expected in zip("xyz", (924.518614, 1109.195047, 49.836275)):
        near(f"world {axis} of -33.94, 18.47, 150 from an anchor at -33.95, 18.46, 100 [m]", row[f"P {axis}_m"], expected, 1e-6)
    near("its distance from the anchor [m]", row["target 1 distance_m"], math.sqrt(924.518614**2 + 1109.195047**2 + 49.836275**2), 2e-6)


# ---- Orbits ---------------------------------------------------------------------------------------------------------


def acceleration(x):
    """Of gravity with J2, in axes that rest."""
    distance = np.sqrt(x @ x)
    up = 5.0 * (x[2] / distance) ** 2
    return -MU * x / distance**3 + 1.5 * J2 * MU * SEMI_MAJOR**2 / distance**5 * x * np.array([up - 1.0, up - 1.0, up - 3.0])


def orbit_table(position, velocity):
    """States every 2 s about time 0, over the Earth."""
    spin = np.array([0.0, 0.0, EARTH_RATE], dtype=np.longdouble)
    first = np.array(position, dtype=np.longdouble)
    moving = np.array(velocity, dtype=np.longdouble) + np.cross(spin, first)
    lines = ["t,x,y,z,vx,vy,vz"]
    made = {}
    for direction in (1, -1):
        x, v = first, moving
        made[0] = (x, v)
        for step in range(1, 501):
            h = np.longdouble(0.02) * direction
            a1, v1 = acceleration(x), v
            a2, v2 = acceleration(x + h / 2 * v1), v + h / 2 * a1
            a3, v3 = acceleration(x + h / 2 * v2), v + h / 2 * a2
            a4, v4 = acceleration(x + h * v3), v + h * a3
            x, v = x + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4), v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
            if step % 100 == 0:
                made[direction * step // 50] = (x, v)
    for time_s in sorted(made):
        x, v = made[time_s]
        cosine, sine = np.cos(np.longdouble(EARTH_RATE) * time_s), np.sin(np.longdouble(EARTH_RATE) * time_s)
        turn = np.array([[cosine, sine, 0], [-sine, cosine, 0], [0, 0, 1]], dtype=np.longdouble)
        row = [*(turn @ x), *(turn @ (v - np.cross(spin, x)))]
        lines.append(",".join([str(time_s), *(repr(float(value)) for value in row)]))
    return "\n".join(lines) + "\n"


def geodetic(position):
    """Latitude, longitude [deg] and height [m]."""
    across = math.hypot(position[0], position[1])
    latitude = math.atan2(position[2], across * (1.0 - ECCENTRICITY_2))
    height = 0.0
    for _ in range(20):
        normal = SEMI_MAJOR / math.sqrt(1.0 - ECCENTRICITY_2 * math.sin(latitude) ** 2)
        height = across / math.cos(latitude) - normal
        latitude = math.atan2(position[2], across * (1.0 - ECCENTRICITY_2 * normal / (normal + height)))
    return math.degrees(latitude), math.degrees(math.atan2(position[1], position[0])), height


def axes(row):
    """Columns: the platform's x, y, z in the world, of its three angles."""
    a, b, c = (math.radians(row[f"P r{axis}_deg"]) for axis in "xyz")
    ca, sa, cb, sb, cc, sc = math.cos(a), math.sin(a), math.cos(b), math.sin(b), math.cos(c), math.sin(c)
    about_x = np.array([[1, 0, 0], [0, ca, -sa], [0, sa, ca]])
    about_y = np.array([[cb, 0, sb], [0, 1, 0], [-sb, 0, cb]])
    about_z = np.array([[cc, -sc, 0], [sc, cc, 0], [0, 0, 1]])
    return (about_x @ about_y @ about_z).T


def velocity_of(row):
    return np.array([row[f"P v{axis}_mps"] for axis in "xyz"])


def seen_from_orbit(position, velocity, look_deg):
    """Where the look of a zero-Doppler beam to the right meets the ellipsoid, and how far that is."""
    position = np.array(position)
    ahead = np.array(velocity) / np.linalg.norm(velocity)
    up = position - (position @ ahead) * ahead
    up /= np.linalg.norm(up)
    look = math.radians(look_deg)
    beam = -math.sin(look) * np.cross(up, ahead) - math.cos(look) * up
    stretch = np.array([1.0, 1.0, 1.0 / math.sqrt(1.0 - ECCENTRICITY_2)])
    p, d = position * stretch, beam * stretch
    slant = (-(p @ d) - math.sqrt((p @ d) ** 2 - (d @ d) * (p @ p - SEMI_MAJOR**2))) / (d @ d)
    return position + slant * beam, slant


def steered(folder, state, rotation, targets=""):
    epoch, position, velocity, _ = state
    anchor = geodetic(seen_from_orbit(position, velocity, 30.0)[0])
    text = earth((anchor[0], anchor[1], 0.0), f'epoch = "{epoch}"\n')
    text += f'[[platform]]\nname = "P"\npath = {{ type = "ephemeris", file = "orbit.csv" }}\nrotation = {rotation}\n'
    return Scene(folder, text + (targets or "[[target]]\n") + RADAR, orbit_csv=orbit_table(position, velocity))


NADIR = '{ type = "nadir", along = "inertial" }'


def yaws(folder):
    for name, state in STATES.items():
        ground = axes(steered(folder, state, '"zero-doppler"').geometry()[0])
        stars = axes(steered(folder, state, NADIR).geometry()[0])
        down = -stars[:, 2]
        level = [x - (x @ down) * down for x in (ground[:, 0], stars[:, 0])]
        cosine = level[0] @ level[1] / np.linalg.norm(level[0]) / np.linalg.norm(level[1])
        near(f"{name}: yaw from the inertial to the Earth-fixed direction of flight [deg]", math.degrees(math.acos(cosine)),
             state[3], 2e-3)


def speeds(folder):
    for name, earth_fixed, height in (("S1A, April 2024", 7576.4254, 715933.903), ("S1B, July 2020", 7592.6247, 702817.751),
                                      ("S1A, July 2020", 7594.8204, 700903.258), ("Envisat at the node", 7555.4989, 787127.733),
                                      ("NISAR-like", 7569.8125, 746010.741)):
        scene = steered(folder, STATES[name], '"zero-doppler"')
        row = scene.motion(1.0, 0.25)[0]
        near(f"{name}: speed over the Earth [m/s]", np.linalg.norm(row[4:7]), earth_fixed, 1e-4)
        near(f"{name}: height [m]", geodetic(row[1:4])[2], height, 2e-3)


def dopplers(folder):
    state = STATES["S1B, July 2020"]
    grounds = [seen_from_orbit(state[1], state[2], look[0]) for look in LOOKS]
    targets = "".join(f"[[target]]\nposition = {place(*geodetic(ground))}\n" for ground, _ in grounds)
    scene = steered(folder, state, '"zero-doppler"', targets)
    rows = scene.geometry(-0.5, 0.5)
    times = np.array([row["pulse"] / 1000.0 for row in rows])
    middle = next(row for row in rows if row["pulse"] == 0)
    # The table's x axis lies along the inertial velocity itself; the nadir law keeps x level, so it is pitched to it.
    position, moving = np.array(state[1]), np.array(state[2]) + np.cross([0.0, 0.0, EARTH_RATE], state[1])
    up = position / np.linalg.norm(position)
    climb = math.degrees(math.asin(moving @ up / np.linalg.norm(moving)))
    level = moving - (moving @ up) * up
    left = np.cross(up, level / np.linalg.norm(level))
    nadir = steered(folder, state, NADIR).geometry()[0]
    inertial = steered(folder, state, NADIR.replace(" }", f', angles = [0, "{climb!r} deg", 0] }}')).geometry()[0]
    for number, (look, distance_km, inertial_hz, rate_hz_s, speed) in enumerate(LOOKS, 1):
        delays = np.array([row[f"target {number} delay_s"] for row in rows])
        doppler = -2.0 / WAVELENGTH * np.array([row[f"target {number} radial_speed_mps"] for row in rows])
        # An echo tells of the middle of its way.
        fit = np.polyfit(times + delays / 2.0, doppler, 3)
        radius = np.polyval(np.polyfit(times + delays / 2.0, delays * LIGHT_SPEED / 2.0, 4), 0.0)
        near(f"look {look} deg: distance [km]", radius / 1e3, distance_km, 2e-4)
        near(f"look {look} deg: Doppler frequency of the place at zero Doppler [Hz]", fit[-1], 0.0, 0.02)
        near(f"look {look} deg: rate of the Doppler frequency [Hz/s]", fit[-2], rate_hz_s, 0.05)
        near(f"look {look} deg: effective speed [m/s]", math.sqrt(-fit[-2] * WAVELENGTH * radius / 2.0), speed, 0.1)
        beam = np.array([0.0, -math.sin(math.radians(look)), -math.cos(math.radians(look))])
        side = -math.sin(math.radians(look)) * left - math.cos(math.radians(look)) * up
        level_hz = 2.0 * np.array(state[2]) @ side / WAVELENGTH
        for law, row, expected, tolerance in (("zero-Doppler", middle, 0.0, 1e-6), ("nadir", nadir, level_hz, 0.01),
                                              ("inertial", inertial, inertial_hz, 0.02)):
            doppler_hz = 2.0 * velocity_of(row) @ (axes(row) @ beam) / WAVELENGTH
            near(f"look {look} deg, {law} steering: Doppler frequency of the beam [Hz]", doppler_hz, expected, tolerance)


def mean_elements(folder):
    # 4320 minutes behind the epoch of the elements; UT1 is UTC.
    text = earth((0.0, 0.0, 0.0), 'epoch = "2000-06-30T18:50:19.733568Z"\n')
    scene = Scene(folder, text + '[[platform]]\nname = "P"\npath = { type = "ephemeris", file = "o.tle" }\n', o_tle=TLE)
    row = scene.motion(1.0, 0.25)[0]
    for axis, found, expected in zip("xyz", row[1:4], (6692370.040, -7681662.711, 813686.732)):
        near(f"00005 after 4320 min, Earth-fixed {axis} [m]", found, expected, 0.1)
    near("00005 after 4320 min, distance from the centre [m]", np.linalg.norm(row[1:4]),
         1e3 * math.sqrt(9060.47373569**2 + 4658.70952502**2 + 813.68673153**2), 2e-3)


# ---- Aircraft and rotors --------------------------------------------------------------------------------------------


def flight(folder, speed, legs):
    return Scene(folder, f'[[platform]]\nname = "P"\nrotation = "coordinated"\n[platform.path]\ntype = "legs"\n'
                 f'start = [0, 0, 3000]\nheading = "90 deg"\nspeed = "{speed} m/s"\nlegs = [{legs}]\n')


def turns(folder):
    for speed, bank, radius, circle_s in ((200.0, 30.0, 7064.801, 221.947), (120.0, 25.0, 3148.975, 2 * 82.440),
                                          (100.0, 45.0, 1019.716, 64.071)):
        scene = flight(folder, speed, f'{{ leg = "turn", angle = "720 deg", bank = "{bank} deg" }}')
        rows = scene.motion(circle_s, circle_s / 4.0)
        near(f"{speed} m/s, bank {bank} deg: diameter of the turn [m]", np.linalg.norm(rows[2, 1:4] - rows[0, 1:4]), 2 * radius, 0.01)
        near(f"{speed} m/s, bank {bank} deg: gap after {circle_s} s [m]", np.linalg.norm(rows[4, 1:4] - rows[0, 1:4]), 0.0,
             0.6e-3 * speed + 1e-3)
        turned = math.degrees(math.atan2(rows[1, 4] * rows[0, 5] - rows[1, 5] * rows[0, 4], rows[1, 4:6] @ rows[0, 4:6]))
        near(f"{speed} m/s, bank {bank} deg: rate of turn [deg/s]", turned / (circle_s / 4.0),
             math.degrees(GRAVITY * math.tan(math.radians(bank)) / speed), 1e-3)
    radius = 120.0**2 / (GRAVITY * math.tan(math.radians(25.0)))
    around = 2.0 * (20e3 / 120.0 + math.pi * radius / 120.0)
    half = '{ leg = "straight", length = "20 km" }, { leg = "turn", angle = "180 deg", bank = "25 deg" }'
    rows = flight(folder, 120.0, f"{half}, {half}").motion(around, around / 8.0)
    near("a racetrack closes within [m]", np.linalg.norm(rows[-1, 1:4] - rows[0, 1:4]), 0.0, 1e-8)
    near("half-way it is aside by [m]", rows[4, 2], -6297.950, 1e-3)


def rotors(folder):
    scene = Scene(folder, '[[platform]]\nname = "P"\nposition = [0, 2000, 0]\n[[platform]]\nname = "Rotor"\nparent = "P"\n'
                  'rotation_rate = [0, 0, "300 rpm"]\n[[target]]\nplatform = "Rotor"\nposition = [6, 0, 0]\n'
                  '[[radar]]\nname = "R"\ncarrier = "9.993081933 GHz"\nrepetition = "10 kHz"\n')
    rows = scene.geometry(0.0, 0.2)
    speeds_of_tip = np.array([row["target 1 radial_speed_mps"] for row in rows])
    fastest = np.abs(speeds_of_tip).max()
    near("tip of a blade of 6 m at 300 rpm [m/s]", fastest, 188.496, 1e-3)
    near("its Doppler frequency at 30 mm [Hz]", 2.0 * fastest / 0.03, 12566.4, 0.1)
    near("comes nearest as fast as it goes away [m/s]", speeds_of_tip.max() + speeds_of_tip.min(), 0.0, 1e-2)
    scene = Scene(folder, '[[platform]]\nname = "P"\npath = { type = "line", start = [0, 2000, 100], velocity = [0, 50, 0] }\n'
                  '[[platform]]\nname = "Rotor"\nparent = "P"\nrotation_rate = [0, 0, "300 rpm"]\n[[target]]\nplatform = "Rotor"\n'
                  'position = [6, 0, 0]\n[[radar]]\nname = "R"\ncarrier = "10 GHz"\nrepetition = "10 kHz"\n')
    moving = np.array([row["target 1 radial_speed_mps"] for row in scene.geometry(0.0, 0.2)])
    near("mean of both ends in a fuselage that goes away at 50 m/s [m/s]", (moving.max() + moving.min()) / 2.0, 50.0, 0.1)


def main():
    for check in (geodetic_places, speeds, yaws, dopplers, mean_elements, turns, rotors):
        with tempfile.TemporaryDirectory() as folder:
            check(folder)
    print(f"{failures} numbers are off" if failures else "all numbers as they should be")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
