#!/usr/bin/env python3
"""Makes examples/satellite.EOF, the orbit of examples/satellite.toml, from one published state.

usage: satellite_orbit.py [--check]

The state is that of Sentinel-1B at 2020-07-28T22:59:42 UTC; from it the orbit is integrated in the field of a flattened
Earth (J2), in extended precision, and written as a Sentinel-1 orbit file. With --check nothing is written; exit status 1
where the file differs by more than its last digit.
"""

import datetime
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import with_numpy  # noqa: E402, F401

import numpy as np  # noqa: E402

FILE = pathlib.Path(__file__).parents[2] / "examples" / "satellite.EOF"
EPOCH = datetime.datetime(2020, 7, 28, 22, 59, 42)
TAI_S = 37
PLACE = np.array([2057735.247194, -6459802.571744, -2037501.319184], dtype=np.longdouble)
VELOCITY = np.array([-886.585360, -2517.114487, 7108.167902], dtype=np.longdouble)
EARTH_RATE = np.longdouble("7.292115e-5")
MU, J2, RADIUS = np.longdouble("3.986004418e14"), np.longdouble("1.082626683e-3"), np.longdouble(6378137)
REACH_S, SPACING_S, STEP_S = 60, 10, np.longdouble("0.1")


def spun(place):
    """Velocity of a place that rests on the Earth."""
    return EARTH_RATE * np.array([-place[1], place[0], np.longdouble(0)])


def acceleration(place):
    distance = np.sqrt(place @ place)
    up = 5 * (place[2] / distance) ** 2
    return -MU * place / distance**3 + 1.5 * J2 * MU * RADIUS**2 / distance**5 * place * np.array([up - 1, up - 1, up - 3])


def slope(state):
    return np.concatenate([state[3:], acceleration(state[:3])])


def stepped(state, step):
    """A step of Runge and Kutta."""
    first = slope(state)
    second = slope(state + step / 2 * first)
    third = slope(state + step / 2 * second)
    fourth = slope(state + step * third)
    return state + step / 6 * (first + 2 * second + 2 * third + fourth)


def over_earth(state, time_s):
    """Place and velocity in the turning axes of the Earth."""
    cosine, sine = np.cos(EARTH_RATE * time_s), np.sin(EARTH_RATE * time_s)
    turn = np.array([[cosine, sine, 0], [-sine, cosine, 0], [0, 0, 1]], dtype=np.longdouble)
    return turn @ state[:3], turn @ (state[3:] - spun(state[:3]))


def states():
    """Times, places and velocities over the Earth."""
    inertial = np.concatenate([PLACE, VELOCITY + spun(PLACE)])
    made = {0: inertial}
    for direction in (1, -1):
        state = inertial
        for time_s in range(SPACING_S, REACH_S + 1, SPACING_S):
            for _ in range(round(SPACING_S / float(STEP_S))):
                state = stepped(state, direction * STEP_S)
            made[direction * time_s] = state
    return [(time_s, *over_earth(made[time_s], np.longdouble(time_s))) for time_s in sorted(made)]


def stamp(time_s, scale):
    return f"{scale}={EPOCH + datetime.timedelta(seconds=time_s):%Y-%m-%dT%H:%M:%S.%f}"


def block(time_s, place, velocity):
    lines = ["<OSV>", f"  <TAI>{stamp(time_s + TAI_S, 'TAI')}</TAI>", f"  <UTC>{stamp(time_s, 'UTC')}</UTC>"]
    lines += [f'  <{axis} unit="m">{value:.6f}</{axis}>' for axis, value in zip("XYZ", place)]
    lines += [f'  <V{axis} unit="m/s">{value:.6f}</V{axis}>' for axis, value in zip("XYZ", velocity)]
    return [*lines, "  <Quality>NOMINAL</Quality>", "</OSV>"]


def text():
    blocks = [block(*state) for state in states()]
    osvs = ["      " + line for lines in blocks for line in lines]
    return "\n".join([
        '<?xml version="1.0"?>',
        "<!-- Integrated from one published state by tests/examples/satellite_orbit.py; no product of ESA -->",
        "<Earth_Explorer_File>",
        "  <Earth_Explorer_Header><Variable_Header>",
        "    <Ref_Frame>EARTH_FIXED</Ref_Frame>",
        "    <Time_Reference>UTC</Time_Reference>",
        "  </Variable_Header></Earth_Explorer_Header>",
        '  <Data_Block type="xml">',
        f'    <List_of_OSVs count="{len(blocks)}">',
        *osvs,
        "    </List_of_OSVs>",
        "  </Data_Block>",
        "</Earth_Explorer_File>",
        "",
    ])


NUMBER = re.compile(r"-?\d+\.\d{6}(?=<)")


def same(there, made):
    """Equal, but that a number may differ by one unit of its last digit."""
    if NUMBER.sub("", there) != NUMBER.sub("", made):
        return False
    pairs = zip(NUMBER.findall(there), NUMBER.findall(made))
    return all(abs(float(a) - float(b)) < 1.5e-6 for a, b in pairs)


def main():
    if "--check" not in sys.argv[1:]:
        FILE.write_text(text(), encoding="utf-8")
        return 0
    if np.finfo(np.longdouble).eps > 2e-19:
        print("long double has too few digits here: skipped")
        return 77
    if same(FILE.read_text(encoding="utf-8"), text()):
        return 0
    print(f"{FILE.name} is not what {pathlib.Path(__file__).name} makes")
    return 1


if __name__ == "__main__":
    sys.exit(main())
