#!/usr/bin/env python3
"""Makes likely mistakes in a sound scene in format 2 and compares what sarsim says with the record of it.

    SARSIM_PROGRAM=build/dev/src/sarsim tests/bad_input/mistakes_format_2.py [--check]

The mistakes are those of format_2_cases.py, and those of the Earth and of motion below.

Without --check the record said/format_2.txt is written, and docs/guide/bad-input.md, which is made of it. Each mistake must be
reported in the words, at the place and with the exit status that are given with it, whatever the record says. Exit status 1
if one is not, or if the record differs.
"""

import difflib
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import page
from base import spoiled
from format_2_cases import CHECK, LINE, SCENE, THEMES, Mistake, instead, path
from harness import program, split_mark
from mistakes import as_cell, message_of

RECORD = page.SAID / "format_2.txt"
HEAD = ["| | what is typed | what is wrong | exit status | what the user sees |", "|---|---|---|---|---|"]
SCENE_FILE = "scene.toml"


# ---- A satellite, and the files of its orbit ------------------------------------------------------------------------

WORLD = '''\
frame = "earth"
epoch = "2020-07-28T22:59:42Z"
anchor = { latitude = "-16 deg", longitude = "-68.5 deg" }
'''
EPOCH = 'epoch = "2020-07-28T22:59:42Z"'
ANCHOR = 'anchor = { latitude = "-16 deg", longitude = "-68.5 deg" }'
ORBIT = 'path = { type = "ephemeris", file = "orbit.csv" }'
STATE_M = "[2057735.247194, -6459802.571744, -2037501.319184]"
STATE_MPS = "[-886.585360, -2517.114487, 7108.167902]"
STEERING = 'rotation = "zero-doppler"'
PLACE = 'position = { latitude = "-16 deg", longitude = "-68.6 deg", height = "0 m" }'
SATELLITE = f"""\
format = "sarsim 2"

[world]
{WORLD}
[[platform]]
name = "Satellite"
{ORBIT}
{STEERING}

[[target]]
{PLACE}

[[radar]]
name = "SAR"
platform = "Satellite"
repetition = "1700 Hz"
carrier = "5.405 GHz"

[[recording]]
radar = "SAR"
file = "echoes.h5"
format = "hdf5"
range = ["837 km", "839 km"]
time = ["-0.3 s", "0.3 s"]
sample_rate = "96 MHz"
"""


def states():
    """Times [s], places [m] and velocities [m/s] of a circular orbit over the Earth, every 10 s for two minutes."""
    axis, rate, spin = 7.0786e6, 2.0 * math.pi / 5928.0, 7.292115e-5
    tilt, node, begin = math.radians(98.18), math.radians(-75.0), math.radians(-16.9)

    def over_earth(along, across, angle):
        level, up = across * math.cos(tilt), across * math.sin(tilt)
        cosine, sine = math.cos(angle), math.sin(angle)
        return cosine * along - sine * level, sine * along + cosine * level, up

    made = []
    for time_s in range(-60, 61, 10):
        u, angle = begin + rate * time_s, node - spin * time_s
        x, y, z = over_earth(axis * math.cos(u), axis * math.sin(u), angle)
        vx, vy, vz = over_earth(-axis * rate * math.sin(u), axis * rate * math.cos(u), angle)
        made.append((time_s, x, y, z, vx + spin * y, vy - spin * x, vz))
    return made


STATES = states()


def stamp(time_s):
    second = 22 * 3600 + 59 * 60 + 42 + time_s
    return f"2020-07-28T{second // 3600:02}:{second % 3600 // 60:02}:{second % 60:02}"


def numbers(values, form, between):
    return between.join(format(value, form) for value in values)


CSV = "t,x,y,z,vx,vy,vz\n" + "".join(f"{row[0]},{numbers(row[1:], '.6f', ',')}\n" for row in STATES)


def segment(rows):
    """A segment of an OEM."""
    head = ["META_START", "OBJECT_NAME = SENTINEL-1B", "OBJECT_ID = 2016-025A", "CENTER_NAME = EARTH",
            "REF_FRAME = ITRF2014", "TIME_SYSTEM = UTC", f"START_TIME = {stamp(rows[0][0])}",
            f"STOP_TIME = {stamp(rows[-1][0])}", "META_STOP"]
    lines = [f"{stamp(row[0])} {numbers((value / 1e3 for value in row[1:]), '.9f', ' ')}" for row in rows]
    return "\n".join([*head, *lines, ""])


OEM_HEAD = "CCSDS_OEM_VERS = 2.0\nCREATION_DATE = 2020-07-29T00:00:00\nORIGINATOR = TEST\n"
OEM = OEM_HEAD + segment(STATES)


def osv(row):
    """A state of an EOF."""
    units = zip(("X", "Y", "Z", "VX", "VY", "VZ"), ["m"] * 3 + ["m/s"] * 3, row[1:])
    numbers_of_it = [f'<{name} unit="{unit}">{value:.6f}</{name}>' for name, unit, value in units]
    time = f"<UTC>UTC={stamp(row[0])}.000000</UTC>"
    return "\n".join(["<OSV>", time, *numbers_of_it, "<Quality>NOMINAL</Quality>", "</OSV>", ""])


EOF = (
    "<Earth_Explorer_File>\n<Ref_Frame>EARTH_FIXED</Ref_Frame>\n"
    f'<List_of_OSVs count="{len(STATES)}">\n'
    + "".join(osv(row) for row in STATES)
    + "</List_of_OSVs>\n</Earth_Explorer_File>\n"
)


def sp3(rows):
    lines = [f"#dP2020  7 28 22 59 42.00000000{len(rows):8} ORBIT IGS14 FIT TEST", "+    1   L51" + "  0" * 16,
             "%c L  cc GPS ccc cccc cccc cccc cccc ccccc ccccc ccccc ccccc"]
    for row in rows:
        second = 22 * 3600 + 59 * 60 + 42 + 18 + row[0]
        lines += [f"*  2020  7 28 {second // 3600:2} {second % 3600 // 60:2} {second % 60:11.8f}",
                  "PL51" + numbers((value / 1e3 for value in row[1:4]), "14.6f", "") + " 999999.999999"]
    return "\n".join([*lines, "EOF", ""])


SP3 = sp3(STATES)
TLE = """\
CBERS 2
1 28057U 03049A   20210.78615833  .00000060  00000-0  35940-4 0  1830
2 28057  98.4283 247.6961 0000884  88.1964 271.9322 14.35478080140550
"""
OMM = """\
CCSDS_OMM_VERS = 2.0
CREATION_DATE = 2020-07-29T00:00:00
ORIGINATOR = TEST
OBJECT_NAME = CBERS 2
OBJECT_ID = 2003-049A
CENTER_NAME = EARTH
REF_FRAME = TEME
TIME_SYSTEM = UTC
MEAN_ELEMENT_THEORY = SGP4
EPOCH = 2020-07-28T18:52:04
MEAN_MOTION = 14.35478080
ECCENTRICITY = 0.0000884
INCLINATION = 98.4283
RA_OF_ASC_NODE = 247.6961
ARG_OF_PERICENTER = 88.1964
MEAN_ANOMALY = 271.9322
BSTAR = 0.00003594
"""
AEM = """\
CCSDS_AEM_VERS = 1.0
CREATION_DATE = 2020-07-29T00:00:00
ORIGINATOR = TEST
META_START
OBJECT_NAME = SENTINEL-1B
OBJECT_ID = 2016-025A
CENTER_NAME = EARTH
REF_FRAME_A = EME2000
REF_FRAME_B = SC_BODY_1
ATTITUDE_DIR = A2B
TIME_SYSTEM = UTC
START_TIME = 2020-07-28T22:58:42
STOP_TIME = 2020-07-28T23:00:42
ATTITUDE_TYPE = QUATERNION
QUATERNION_TYPE = LAST
META_STOP
DATA_START
2020-07-28T22:58:42 0 0 0 1
2020-07-28T22:59:42 0 0 0 1
2020-07-28T23:00:12 0 0 0 1
2020-07-28T23:00:42 0 0 0 1
DATA_STOP
"""


# ---- Mistakes in them -----------------------------------------------------------------------------------------------


def lines_of(text, base):
    """The lines of a scene that are not those of a sound one, as a cell of the page."""
    text, _ = split_mark(text)
    sound, lines = base.splitlines(), text.splitlines()
    steps = difflib.SequenceMatcher(None, sound, lines, autojunk=False).get_opcodes()
    return as_cell("\n".join(line for tag, _, _, begin, end in steps if tag != "equal" for line in lines[begin:end] if line))


def orbit(changes, why, words, files=None, **more):
    """A mistake in the scene of the satellite, or in a file beside it."""
    text = spoiled(*changes, text=SATELLITE)
    return Mistake(why, words, whole=text, typed=more.pop("typed", None) or lines_of(text, SATELLITE),
                   files={"orbit.csv": CSV} | (files or {}), **more)


def file(name, text, change, why, words, changes=(), **more):
    """A mistake in a file of the orbit: (old, new) in it. The page has what is new, with the name of the file."""
    old, new = change
    shown = as_cell("\n".join(new.splitlines()[:2])) if new.strip() else f"a part of `{name}` is missing"
    typed = more.pop("typed", f"{name}: {shown}" if new.strip() else shown)
    made = text.replace(old, new, 1)
    if old and made == text:
        raise ValueError(f"{old!r} does not stand in {name}")
    files = {name: made} if old else {name: new}
    return orbit([("orbit.csv", name), *changes], why, words, files, typed=typed, **more)


def worlds():
    flat = [('frame = "earth"\n', ""), (f"{ANCHOR}\n", "")]
    return [
        orbit([('"earth"', '@"globe"')], "There are two kinds of worlds.", "expected flat or earth", errors=9),
        orbit([("[world]", "@[[world]]")], "There is one world.", "single brackets"),
        orbit([('"-16 deg", longitude = "-68.5', '@"95 deg", longitude = "-68.5')], "No latitude is above 90 deg.",
              "latitude of the anchor is out of range"),
        orbit([('"-16 deg", longitude = "-68.5', '@"90 deg", longitude = "-68.5')],
              "At a pole there is neither east nor north.", "anchor is at a pole", status=0),
        orbit([('"-68.5 deg"', '"@-68.5 km"')], "A longitude is an angle.", "takes an angle"),
        orbit([(EPOCH, 'epoch = @"2020-07-28T22:59:42+02:00"')], "The epoch is in UTC.", "write UTC with a Z"),
        orbit([(EPOCH, 'epoch = @"2020-02-30T22:59:42Z"')], "February has no 30th.", "not a date of the calendar"),
        orbit([(EPOCH, "epoch = @2020-07-28T22:59:42Z")], "The epoch needs straight quotes.", "expected text in quotes"),
        orbit([(EPOCH, 'epoch = @"1950-07-28T22:59:42Z"')], "Before 1972 UTC had no whole seconds.", "before 1972"),
        orbit([(EPOCH, 'epoch = @"2016-12-31T23:59:59.8Z"')], "A leap second lies within the recording.", "leap second"),
        orbit([(EPOCH, f'{EPOCH}\ndut1 = @"37 s"')], "UT1 - UTC is below 0.9 s; 37 s are TAI - UTC.", "UT1 - UTC is out of"),
        orbit([(ANCHOR, f'{ANCHOR}\ngeoid.file = @"egm96-5.pgm"')], "The grid of the geoid is not there.", "cannot read the grid"),
        orbit([(ANCHOR, f'{ANCHOR}\ngeoid.file = "grid.pgm"')], "A picture is no grid of the geoid.", "do not have 16 bits",
              {"grid.pgm": "P5\n# a picture\n4 4\n255\n0123456789abcdef"}),
        orbit([(ANCHOR, f'{ANCHOR}\ngeoid.file = @"orbit.csv"')], "A table is no grid of the geoid.", "no grid of the geoid"),
        orbit([(ANCHOR, f'{ANCHOR}\ngeoid.undulation = @"3 km"')], "No geoid is so far from the ellipsoid.", "undulation"),
        orbit([("[world]", '[options]\nprofile = "classic"\n[world]')], "The programs of 1998 knew no Earth.", "knows no Earth"),
        orbit([("[[target]]", "[@world]\nframe = \"earth\"\n[[target]]")], "There is one world.", "appears twice"),
        orbit([*flat, (PLACE, "position = [0, 0, 0]")], "Zero-Doppler steering needs the Earth.", "needs the Earth", errors=2),
        orbit([*flat, (STEERING, "")], "A flat world has no latitudes.", "world is flat and has no latitudes",
              typed='`frame = "earth"` is missing'),
        orbit([*flat, (STEERING, ""), (PLACE, "position = [0, 0, 0]"),
               (ORBIT, 'path = { type = @"orbit", semi_major_axis = "7070 km" }')],
              "There are no orbits over a flat world.", "an orbit needs the Earth"),
        orbit([*flat, (STEERING, ""), (PLACE, "position = [0, 0, 0]"), ("orbit.csv", "orbit.oem")],
              "What is in the file is fixed to the Earth.", "needs the Earth", {"orbit.oem": OEM}),
    ]


def places():
    return [
        orbit([(PLACE, PLACE.replace('"-16', '@"-96'))], "No latitude is below -90 deg.", "latitude is out of range"),
        orbit([(PLACE, 'position = @{ latitude = "-16 deg", height = "0 m" }')], "Half of a place.", "needs latitude and longitude"),
        orbit([(PLACE, PLACE.replace(" }", ', altitude = "3 m" }').replace("= {", "= @{"))],
              "Above the ellipsoid, or above the sea?", "a height or an altitude"),
        orbit([(PLACE, PLACE.replace("latitude", "@lattitude"))], "A word is misspelt.", "did you mean 'latitude'", errors=2),
        orbit([(PLACE, PLACE.replace('"-68.6', '"-12'))], "The Earth hides the target.", "1 of 1 target behind the horizon", status=0),
        orbit([(PLACE, PLACE.replace('"0 m"', '@"-700 km"'))], "That is far below the ground.", "height is out of range"),
        orbit([(ORBIT, ORBIT.replace("ephemeris", "orbit").replace('file = "orbit.csv"', 'semi_major_axis = @"700 km"'))],
              "The axis counts from the centre of the Earth.", "semi-major axis is out of range"),
        orbit([(ORBIT, 'path = { type = @"orbit", semi_major_axis = "7070 km", eccentricity = 0.2 }')],
              "The perigee is inside the Earth.", "perigee of the orbit is inside the Earth"),
        orbit([(ORBIT, 'path = { type = "orbit", semi_major_axis = "7070 km", eccentricity = @1.2 }')],
              "That is no ellipse.", "eccentricity is out of range"),
        orbit([(ORBIT, 'path = { type = "orbit", semi_major_axis = "7070 km", inclination = @"200 deg" }')],
              "Inclinations end at 180 deg.", "inclination is out of range"),
        orbit([(ORBIT, f'path = {{ type = @"state", position = [6000e3, 0, 0], velocity = {STATE_MPS} }}')],
              "The state counts from the centre of the Earth.", "state of the orbit is inside the Earth"),
        orbit([(ORBIT, f'path = {{ type = "state", position = {STATE_M}, velocity = @[-0.886, -2.517, 7.108] }}')],
              "Velocities are in m/s.", "the orbit comes down to the ground", status=0),
        orbit([(ORBIT, f'path = {{ type = "state", position = {STATE_M}, @speed = "7.6 km/s" }}')],
              "A state needs a velocity, not a speed.", "does not apply here"),
        orbit([(ORBIT, f'parent = @"Base"\n{ORBIT}'), ("[[target]]", '[[platform]]\nname = "Base"\n[[target]]')],
              "An orbit is a path in the world.", "not in the frame of a parent"),
        orbit([(ORBIT, "position = [0, 0, 5000]")], "What rests has no direction of flight.", "stays where it is"),
    ]


def ephemerides():
    rows = CSV.splitlines(keepends=True)
    state = f"{stamp(-20)} "
    x_of_first = EOF[EOF.index("<X") : EOF.index("<Y")]
    return [
        orbit([("orbit.csv", "nothing.csv")], "The file is not there.", "cannot be read"),
        file("orbit.txt", CSV, ("", "hello\n"), "That is not an orbit.", "not an orbit file"),
        file("orbit.aem", AEM, ("TEST", "ESA"), "An attitude file is not an orbit file.", "which holds attitudes",
             typed="orbit.aem: a CCSDS AEM"),
        file("orbit.csv", CSV, (rows[4], rows[3]), "A time appears twice.", "must ascend"),
        file("orbit.csv", CSV, (rows[4], "-30,1,2\n"), "Cells are missing.", "another number of cells"),
        file("orbit.csv", CSV, (rows[0], "t,x [km],y,z,vx,vy,vz\n"), "Positions are in m.", "another name than it should", errors=3),
        file("orbit.csv", CSV, ("", "".join(rows[:4])), "Three states are too few.", "too few states", typed="orbit.csv: 3 states"),
        orbit([("orbit.csv", "orbit.EOF"), (EPOCH, 'epoch = "2020-07-29T22:59:42Z"')], "The epoch lies outside of the file.",
              "does not cover the recordings", {"orbit.EOF": EOF}),
        orbit([("orbit.csv", "orbit.EOF"), (EPOCH + "\n", "")], "The file has dates.", "has no epoch", {"orbit.EOF": EOF}),
        orbit([('"0.3 s"', '"100 s"')], "The states end before the recording.", "does not cover the recordings"),
        orbit([(ORBIT, ORBIT.replace(" }", ', interpolation = @"spline" }'))], "There is no such interpolation.", "expected automatic"),
        file("orbit.EOF", EOF, (EOF[len(EOF) // 2 :], ""), "The file is cut off.", "not closed"),
        file("orbit.EOF", EOF, (x_of_first, ""), "A coordinate is missing.", "X is missing"),
        file("orbit.EOF", EOF, ("EARTH_FIXED", "BM2000"), "The frame is another one.", "expected EARTH_FIXED"),
        file("orbit.EOF", EOF, ('<X unit="m">', '<X unit="km">'), "The unit is another one.", "another unit"),
        file("orbit.EOF", EOF, ('count="13"', 'count="9361"'), "States are missing.", "the one that the list announces"),
        file("orbit.oem", OEM, ("ITRF2014", "MOD"), "The frame is another one.", "the frame is not known"),
        file("orbit.oem", OEM, ("= EARTH", "= MARS"), "The centre is another one.", "not the Earth"),
        file("orbit.oem", OEM, ("REF_FRAME = ITRF2014\n", ""), "The frame is missing.", "REF_FRAME is missing"),
        file("orbit.oem", OEM, ("= UTC", "= TDB"), "The times are of another kind.", "time system is not known"),
        file("orbit.oem", OEM, (state, "2020-07-28 25:00 "), "That is no time.", "not a state"),
        file("orbit.oem", OEM, ("META_STOP", f"USEABLE_START_TIME = {stamp(10)}\nMETA_STOP"), "The usable states begin later.",
             "does not cover the recordings"),
        file("orbit.oem", OEM, (OEM, OEM_HEAD + segment(STATES[:6]) + segment(STATES[7:])),
             "Time 0 lies between two segments.", "no segment of orbit.oem covers", typed="orbit.oem: two segments with a gap"),
        file("orbit.oem", OEM, (OEM, OEM_HEAD + segment(STATES[:9]) + segment(STATES[5:])),
             "Two segments overlap.", "used at the same time", typed="orbit.oem: two segments that overlap"),
        orbit([(ORBIT, 'path = { type = "ephemeris", file = "orbit.oem", satellite = "ENVISAT" }')], "It is of another satellite.",
              "does not hold the satellite", {"orbit.oem": OEM}),
        file("orbit.sp3", SP3, (SP3[len(SP3) * 2 // 3 :], ""), "The file is cut off.", "EOF is missing", errors=2),
        file("orbit.sp3", SP3, ("#dP", "#aP"), "An old version.", "version of SP3"),
        file("orbit.sp3", SP3, ("GPS", "BDT"), "The times are of another kind.", "time system is not known"),
        file("orbit.sp3", SP3, ("IGS14", "J2000"), "The frame does not rotate with the Earth.", "fixed to the Earth"),
        file("orbit.sp3", SP3, (SP3, sp3(STATES[3:9])), "Six positions are too few.", "too few states", typed="orbit.sp3: 6 positions"),
        file("orbit.tle", TLE, ("1830", "1836"), "A digit was changed.", "checksum"),
        file("orbit.tle", TLE, (TLE[TLE.index("2 28057") :], ""), "The second line is missing.", "second line of a set is missing"),
        file("orbit.oem", OEM, ("META_STOP\n", ""), "The end of the metadata is missing.", "metadata is not closed"),
        orbit([(ORBIT, 'path = { type = "ephemeris", file = "orbit.csv", satellite = @"ENVISAT" }')], "A table holds one path.",
              "satellite is not looked for", status=0),
        file("orbit.tle", TLE, ("2 28057", "2 28058"), "The lines are of two satellites.", "different satellites", errors=2),
        orbit([("orbit.csv", "orbit.tle"), (EPOCH, 'epoch = "2021-07-28T22:59:42Z"')], "The elements are a year old.",
              "mean elements are old", {"orbit.tle": TLE}, status=0),
        file("orbit.omm", OMM, ("= SGP4", "= DSST"), "The elements are of another theory.", "expected SGP4"),
        file("orbit.omm", OMM, ("BSTAR = 0.00003594\n", ""), "The drag term is missing.", "BSTAR is missing"),
        orbit([(STEERING, 'rotation = { type = "quaternions", file = "orbit.csv" }')], "An orbit file is not an attitude file.",
              "not an attitude file"),
        attitude(("QUATERNION_TYPE = LAST\n", ""), "Where the scalar stands is not said.", "QUATERNION_TYPE is missing"),
        attitude(("= QUATERNION\n", "= EULER_ANGLE\n"), "Angles are not read.", "type of attitude is not read"),
        attitude(("22:59:42 0 0 0 1", "22:59:42 0 0 0 0.9"), "A quaternion has the length 1.", "does not have the length 1"),
        attitude((AEM[AEM.index("2020-07-28T23:00:42 0") :], ""), "The file is cut off.", "ends within a block"),
        attitude(("META_STOP\nDATA_START", f"USEABLE_START_TIME = {stamp(10)}\nMETA_STOP\nDATA_START"), "The attitudes begin later.",
                 "does not cover the recordings; found '2020-07-28T22:59:52Z to 2020-07-28T23:00:42Z"),
    ]


def attitude(change, why, words):
    """A mistake in a file of attitudes."""
    old, new = change
    if AEM.count(old) != 1:
        raise ValueError(f"{old!r} stands {AEM.count(old)} times in the file of attitudes")
    shown = f"turn.aem: {as_cell(new)}" if new.strip() else "a part of `turn.aem` is missing"
    return orbit([(STEERING, 'rotation = { type = "quaternions", file = "turn.aem" }')], why, words,
                 {"turn.aem": AEM.replace(old, new)}, typed=shown)


def legs(leg, why, words, **more):
    """A path of one leg."""
    return path(f'type = "legs"\nstart = [0, -8000, 3000]\nspeed = "speed"\nlegs = [{leg}]\n', why, words, **more)


def route(points, why, words, bank='bank = "25 deg"\n', **more):
    """A path past waypoints: x and y of each in km."""
    rows = ", ".join(f"{{ position = [{1000 * x}, {1000 * y}, 3000] }}" for x, y in points)
    return path(f'type = "waypoints"\nspeed = "speed"\n{bank}waypoints = [{rows}]\n', why, words, **more)


def routes():
    corner = [(0, 0), (0, 20), (20, 20)]
    straight = 'start = [0, -8000, 3000]\nspeed = "speed"\n'
    return [
        legs('{ leg = "straight" }', "How long is it?", "leg 1: a length or a duration is missing, or 0"),
        legs('{ leg = "straight", length = "2 km", duration = "3 s" }', "One of the two is enough.", "both duration and length"),
        legs('{ leg = "turn", angle = "90 deg" }', "Neither bank nor radius.", "neither bank nor radius"),
        legs('{ leg = "turn", angle = "90 deg", bank = "0 deg" }', "Without bank there is no turn.", "neither bank nor radius"),
        legs('{ leg = "turn", angle = "90 deg", bank = @"90 deg" }', "The radius would be 0.", "bank of the turn is out of range"),
        legs('{ leg = "turn", angle = "90 deg", bank = "20 deg", radius = "2 km" }', "The speed and one of them give the other.",
             "both bank and radius"),
        legs('{ leg = "climb-to", height = "4 km" }', "How fast?", "leg 1: a rate is missing, or 0"),
        legs('@{ leg = "climb-to", rate = "5 m/s" }', "How high?", "leg 1 lacks the height"),
        legs('{ leg = "straight", length = "2 km" }, @{ leg = "turn-to", bank = "20 deg" }', "To which heading?", "leg 2 lacks the heading"),
        legs('{ leg = "straight", length = "2 km", @radius = "3 km" }', "A straight leg has no radius.", "belongs to leg turn, turn-to or circle"),
        legs('{ leg = "climb", duration = "20 s", rate = "5 m/s", rounding = "0.1 m/s2" }', "Its ends take all of the climb.",
             "too short to reach its rate", status=0),
        legs('{ leg = "straight", @lenght = "2 km" }', "A word is misspelt.", "did you mean 'length'"),
        legs('{ leg = @"loop", length = "2 km" }', "There is no such leg.", "unknown kind of leg"),
        legs('@"straight"', "A leg is a table.", "not a table"),
        legs('{ leg = "straight", length = "20 km", acceleration = "-1 m/s2" }', "It would stop before the end.", "comes to 0"),
        path(f'type = "legs"\n{straight}legs = @"legs.csv"\n', "Legs are an array.", "not an array"),
        path('type = "legs"\nlegs = [{ leg = "turn", angle = "90 deg", bank = "20 deg" }]\n', "The speed is missing.", "the path has no speed"),
        route(corner[:1], "One point is no route.", "at least two waypoints"),
        route([(0, 0), (0, 0)], "Both are the same.", "has no length"),
        route([(0, 0), (0, 20), (1, 20), (1, 0)], "The turns do not fit between them.", "must be 4.37.* km long and is 1 km"),
        route([(0, 0), (0, 20), (0, 0)], "It flies back.", "turns back on itself"),
        route(corner, "Without bank there are no turns.", "the bank is 0", bank=""),
        path('type = "waypoints"\nspeed = "speed"\nwaypoints = [@[0, 0, 0], [0, 1000, 0]]\n', "Waypoints are tables.",
             "not a table", errors=2),
        path('type = "relative"\noffset = [0, 100, 0]\n', "Relative to what?", "has no leader"),
        path('type = "relative"\nleader = @"Leader"\n', "There is no leader of this name.", "no platform of this name"),
        path('type = "relative"\nleader = @"Plane"\n', "It follows itself.", "come back to itself"),
        Mistake("Each follows the other.", "come back to itself",
                ((LINE, 'type = "relative"\nleader = @"B"\n'),
                 ("[[target]]", '[[platform]]\nname = "B"\npath = { type = "relative", leader = "Plane" }\n[[target]]')), errors=2),
        Mistake("Each is mounted on the other.", "come back to itself",
                (('name = "Plane"\n', 'name = "Plane"\nparent = @"B"\n'),
                 ("[[target]]", '[[platform]]\nname = "B"\nparent = "Plane"\n[[target]]')), errors=2),
    ]


def motions():
    def plane(line, why, words, **more):
        return instead('name = "Plane"', f'name = "Plane"\n{line}', why, words, **more)

    return [
        plane('oscillations = [{ axis = @"surge", amplitude = "1 m" }]', "There is no such axis.", "expected x, y, z"),
        plane('oscillations = [{ axis = "roll", @amplitude = "1 deg" }]', "The amplitude of a roll is its angle.", "belongs to axis x, y or z"),
        plane('position_error = { type = "gusts", turbulence = @"extreme" }', "Light, moderate or severe.", "expected light"),
        plane('position_error = { type = "gusts", airspeed = @"0 m/s" }', "An aircraft at rest meets no gusts.", "airspeed is out of"),
        plane('waves = { type = @"sea" }', "There are no such waves.", "unknown kind of waves"),
        plane('waves = { type = "ship", height = @"50 m" }', "No sea is so high.", "wave height is out of range"),
        plane('navigation = @"gps"', "There is no such navigation.", "unknown kind of navigation"),
        plane('navigation = { type = "ins", position_time = @"0 s" }', "Errors cannot wander so fast.", "correlation time"),
        plane('rotation = @"zerodoppler"', "A hyphen is missing.", "write .zero-doppler"),
        Mistake("The scene has no navigation.", "has no navigation", whole=SCENE, typed="",
                command="motion scene.toml --platform Plane --navigation --out nav.csv"),
        Mistake("Dates need an epoch.", "has no epoch", whole=SCENE, typed="", command="motion scene.toml --out plane.oem"),
        Mistake("There is no such format.", "names no format", whole=SCENE, typed="", command="motion scene.toml --out plane.xyz"),
        Mistake("A person does not walk so fast.", "that is running", whole=SCENE, typed="",
                command="motion --walker 9 --out walker.toml"),
        Mistake("Centimetres were taken for metres.", "a person is", whole=SCENE, typed="",
                command="motion --walker 1 --height 180 --out walker.toml"),
        Mistake("The navigation begins too late.", "does not cover the recordings", whole=SCENE, typed="",
                command="focus scene.toml --navigation nav.csv --out a.img --quiet",
                files={"nav.csv": "t,x,y,z,vx,vy,vz\n" + "".join(f"{t},{t}00,-8000,3000,100,0,0\n" for t in range(5))}),
    ]


ALL_THEMES = THEMES | {
    "The world": worlds,
    "Places and orbits": places,
    "Files of orbits and attitudes": ephemerides,
    "Legs, routes, leaders and parents": routes,
    "Waves, gusts and navigation": motions,
}


# ---- What is said to them -------------------------------------------------------------------------------------------


def written(mistake):
    """The bytes of the scene, and where the message has to point: "scene.toml:9:1"."""
    text = spoiled(*mistake.changes, text=SCENE) if mistake.whole is None else mistake.whole
    text, place = split_mark(text)
    if mistake.coding == "crlf":
        made = text.replace("\n", "\r\n").encode()
    else:
        made = text.encode(mistake.coding)
    return made, place and f"{SCENE_FILE}:{place}: "


def said(mistake, folder):
    """Exit status and all that a user sees."""
    for name, text in mistake.files.items():
        pathlib.Path(folder, name).write_text(text, encoding="utf-8")
    made, place = written(mistake)
    pathlib.Path(folder, SCENE_FILE).write_bytes(made)
    done = subprocess.run(
        [program(), *mistake.command.split()], cwd=folder, capture_output=True, timeout=60, check=False
    )
    return done.returncode, (done.stdout + done.stderr).decode(errors="backslashreplace"), place


def faults_of(mistake, status, text, place):
    """What is wrong with what was said."""
    message = message_of({"words": mistake.words}, text)
    errors = len(re.findall(r"^(?:\S+ )?error: ", text, re.MULTILINE))
    most = mistake.errors if mistake.status else 0
    found = []
    if message is None:
        found.append(f"nothing matches {mistake.words!r}")
    elif place and not message.startswith(place):
        found.append(f"the message does not point at {place}")
    if status != mistake.status:
        found.append(f"exit status {status} instead of {mistake.status}")
    if errors > most:
        found.append(f"{errors} errors instead of {most}")
    return [f"{mistake.why} {fault}; said:\n{text}" for fault in found]


def typed(mistake):
    """The lines that are not those of the sound scene."""
    if mistake.typed is not None:
        return mistake.typed
    return lines_of(spoiled(*mistake.changes, text=SCENE), SCENE)


def row(number, mistake, message):
    command = "" if mistake.command == CHECK else f"`sarsim {mistake.command}`"
    shown = " ".join(filter(None, [typed(mistake), command]))
    return f"| {number} | {shown} | {mistake.why} | {mistake.status} | {as_cell(message or 'nothing')} |"


def tables():
    lines, faults, number = [], [], 0
    for theme, mistakes in ALL_THEMES.items():
        lines += ["", f"## {theme}", "", *HEAD]
        for mistake in mistakes():
            number += 1
            with tempfile.TemporaryDirectory() as folder:
                status, text, place = said(mistake, folder)
            faults += faults_of(mistake, status, text, place)
            lines.append(row(number, mistake, message_of({"words": mistake.words}, text)))
    return [f"{number} mistakes.", *lines], faults


def main():
    lines, faults = tables()
    made = "\n".join([*lines, ""])
    old = RECORD.read_text(encoding="utf-8")
    if "--check" not in sys.argv[1:]:
        RECORD.write_text(made, encoding="utf-8")
        page.write()
    elif made != old:
        faults.append(f"{RECORD.name} and the program disagree; tests/bad_input/mistakes_format_2.py writes it anew")
        faults += [line for line in lines if line not in old.splitlines()]
    print("\n".join(faults) or f"{lines[0].removesuffix('.')}, all of them reported")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
