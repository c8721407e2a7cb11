"""Likely mistakes in a scene in format 2, by themes: what is typed, why it is wrong, and what sarsim has to say."""

import dataclasses

# An aircraft passes a point on the ground at 8.5 km; S band, 100 MHz, 2 us.
SCENE = """\
format = "sarsim 2"

[let]
speed = "100 m/s"

[[platform]]
name = "Plane"
[platform.path]
type = "line"
start = [0, -8000, 3000]
velocity = ["speed", 0, 0]

[[target]]
position = [20, 60, 0]

[[radar]]
name = "R"
platform = "Plane"
pulse = { type = "chirp", bandwidth = "100 MHz", width = "2 us" }
repetition = "500 Hz"
carrier = "3 GHz"
power = "1 kW"
antenna = { type = "sinx", elevation_width = "10 deg", azimuth_width = "3 deg" }
beam = { type = "fixed", elevation = "-20.6 deg", azimuth = "0 deg" }

[[recording]]
radar = "R"
file = "echoes.h5"
format = "hdf5"
range = ["8450 m", "8950 m"]
time = ["-0.999 s", "1 s"]
sample_rate = "120 MHz"
"""
OLD_SCRIPT = """\
! the ground
$PLATFORM Ground
STATIONARY 0 0 0
CONST 0 0 0 0 0 0
STDDEV 0 0 0
STDDEV 0 0 0
"""
GROUND = 'format = "sarsim 2"\n[[platform]]\nname = "Ground"\n'
CHECK = "check scene.toml"

LINE = """\
type = "line"
start = [0, -8000, 3000]
velocity = ["speed", 0, 0]
"""
PULSE = '{ type = "chirp", bandwidth = "100 MHz", width = "2 us" }'
BEAM = '{ type = "fixed", elevation = "-20.6 deg", azimuth = "0 deg" }'
MARK = 'format = "sarsim 2"\n'
POSITION = "position = [20, 60, 0]"
POWER = 'power = "1 kW"'
LAST = 'sample_rate = "120 MHz"\n'


@dataclasses.dataclass
class Mistake:
    """One mistake; the mark `@` in what is typed stands where the message has to point, and is not written."""

    why: str  # A line of plain text for the page.
    words: str  # Regular expression that the message matches.
    changes: tuple = ()  # (old, typed) in SCENE; each old text stands there once.
    whole: str | None = None  # Instead of SCENE.
    typed: str | None = None  # For the page, instead of the changed lines.
    command: str = CHECK
    status: int = 2
    errors: int = 1  # At most, where the status is not 0: there are those that follow from one.
    files: dict = dataclasses.field(default_factory=dict)
    coding: str = "utf-8"


def instead(old, new, why, words, **more):
    return Mistake(why, words, ((old, new),), **more)


def behind(line, added, why, words):
    """Something is added in the lines behind another one."""
    return Mistake(why, words, ((line, f"{line}\n{added}"),))


def at_end(added, why, words):
    return Mistake(why, words, ((LAST, LAST + added),))


def path(new, why, words, **more):
    """Another path of the platform, below its header."""
    return instead(LINE, new, why, words, **more)


def names():
    return [
        behind('velocity = ["speed", 0, 0]', "@rotation_rate = [0, 0, 1]", "A field of the platform stands behind the header of its path.", "move it above"),
        behind('velocity = ["speed", 0, 0]', 'aligned = @"yes"', "A yes or no is true or false.", "true or false"),
        instead("[[target]]", "@[[simulation]]", "A kind of object has its name from the language of 1998.", "write ..recording"),

        instead(POSITION, "@postion = [20, 60, 0]", "A field is misspelt.", "did you mean 'position'"),
        instead(POWER, '@Power = "1 kW"', "Names of fields are written in small letters.", "did you mean 'power'"),
        instead("[[target]]", "@[[traget]]", "A kind of object is misspelt.", "did you mean 'target'"),
        instead("[[target]]", "@[[targets]]", "The name of a kind stands in the singular.", "did you mean 'target'"),
        instead("[[target]]", "@[[Target]]", "Kinds of objects are written in small letters.", "write ..target"),
        behind(
            "[[target]]", '@power = "1 kW"', "The field of a radar stands in a target.", "'power' is a field of radar"
        ),
        behind("[[target]]", "@colour = 3", "There is no such field; a name of the user's own begins with x-.", "x-"),
        instead("[let]", "[option]\nseed = 1\n[let]", "A table is misspelt.", "did you mean 'options'"),
        instead(
            "[let]",
            "[options]\n@sede = 1\n[let]",
            "A field of the options is misspelt.",
            "did you mean 'seed'",
        ),
        instead(
            f"beam = {BEAM}",
            '[radar.beam]\ntype = "fixed"\nelevation = "-20.6 deg"\n@window = "hamming"',
            "What follows a header belongs to its table: the window is one of the radar, not of its beam.",
            "move it above the header",
        ),
        behind("[[radar]]", '@wavelength = "3 cm"', "A word of the trade, not of the language.", 'write carrier = "9.993 GHz"'),
        behind("[[radar]]", '@pri = "1 ms"', "The interval of the pulses is given, not their frequency.", 'write repetition = "1 kHz"'),
        behind("[[radar]]", '@noise_figure = "3 dB"', "Noise is given by its temperature.", 'noise_temperature = "578.6 K"'),
        behind("[[radar]]", '@gain = "30 dB"', "Each way has a gain of its own.", "transmit_gain .* and receive_gain"),
        behind("[[radar]]", '@polarization = "HH"', "There is no such thing in the model.", "not modelled"),
        behind("[[target]]", "@velocity = [10, 0, 0]", "What moves is the platform of a target.", "move with their platform"),
        behind("[[recording]]", '@fs = "60 MHz"', "A word of the trade for the sampling frequency.", 'write sample_rate = "60 MHz"'),
        instead(MARK, MARK + "@[[transmitter]]\n", "Another program has transmitters apart.", "write ..radar"),
        instead(MARK, MARK + "@power = 3\n", "A field stands before all headers.", "'power' is a field of radar"),
        Mistake(
            "An object has a header of its own.",
            r"\[\[target\]\]",
            (("[let]", "@target.position = [1, 2, 3]\n[let]"), (f"[[target]]\n{POSITION}\n", "")),
        ),
    ]


def units():
    return [
        instead('"3 GHz"', "@3", "A number without a unit counts in Hz.", "is a unit missing", status=0),
        instead('"3 GHz"', '"@3 km"', "The unit is one of a length.", "takes a frequency"),
        instead('azimuth_width = "3 deg"', 'azimuth_width = "@1 m"', "The length of the antenna is given, not its width.", "5.073 deg"),
        instead(POSITION, f'{POSITION}\nrcs = "@1 km"', "A cross-section is an area.", "takes an area"),
        instead(
            'repetition = "500 Hz"', 'repetition = "@2 ms"', "The interval is given, not the frequency.", "takes a freq"
        ),
        instead('"3 GHz"', "3 @GHz", "A value with a unit needs straight quotes.", "needs straight quotes"),
        instead('"100 MHz"', '"100 @mHz"', "A small m is milli, a capital M is mega.", "write MHz"),
        instead(
            POWER, 'power = "1 @mw"', "Capital and small letters matter here: milliwatts or megawatts?", "mW or MW"
        ),
        instead('"2 us"', '"2 @usec"', "There is no such unit.", "did you mean 'us'"),
        instead('"speed", 0, 0', '"@10 m", 0, 0', "A velocity is given in m/s.", "takes a speed"),
        instead(POSITION, f"{POSITION}\nrcs = @-10", "It is in m2, not in dBsm.", "dBsm", status=0),
        behind(POWER, 'losses = @"-3 dB"', "Losses are counted as positive decibels.", "zero or more"),
    ]


def numbers():
    return [
        instead('"2 us"', '"@2,5 us"', "The decimal mark is the point.", "decimal mark is the point"),
        instead("[20, 60, 0]", "@[20,5, 60, 0]", "A decimal comma makes two numbers of one.", "three numbers"),
        instead('"8450 m"', '"@8 450 m"', "A number holds no blanks.", "write 8450"),
        instead(POWER, "power = @.5", "TOML wants a digit before and behind the point.", r"0\.5 for \.5"),
        instead(POWER, "power = @007", "TOML allows no zero in front.", "leading zero"),
        instead(POWER, "power = @nan", "Numbers are finite.", "not finite"),
        instead(POWER, "power = @1e30", "That is too large a number.", "too large"),
        instead(LAST, LAST + "bits = @65\n", "A value is out of its range.", "1 to 64"),
        instead(LAST, LAST + "bits = @8.5\n", "The field takes whole numbers.", "whole number"),
        instead(
            'repetition = "500 Hz"', "repetition = @0", "A pulse repetition frequency is above zero.", "out of range"
        ),
        instead(POWER, "power = @true", "The field takes a number.", "not a number"),
        instead(POWER, "power = @2024-04-01", "A date is not a number.", "date"),
        instead(
            '"8450 m", "8950 m"', '"8950 m", @"8450 m"', "The ends of the window are swapped.", "end beyond the start"
        ),
    ]


def expressions():
    return [
        instead('speed = "100 m/s"', 'sped = "100 m/s"', "A name of [let] is misspelt.", "did you mean 'sped'"),
        instead('"speed", 0, 0', '"@Speed", 0, 0', "Capital letters count in names of [let].", "did you mean 'speed'"),
        instead('["speed", 0, 0]', "[@speed, 0, 0]", "An expression needs straight quotes.", "needs straight quotes", errors=2),
        instead(
            'speed = "100 m/s"',
            'speed = "@twice / 2"\ntwice = "speed * 2"',
            "Two names are defined by each other.",
            "itself",
        ),
        behind("[let]", "@m = 3", "The name is that of a unit.", "name of a unit"),
        behind("[let]", "@pi = 3", "The name is that of a constant.", "name of a constant"),
        behind("[let]", '@my-speed = "1 m/s"', "In expressions a hyphen is a minus sign.", "my_speed"),
        behind('speed = "100 m/s"', "@speed = 3", "A name is given twice.", "twice"),
        behind("[let]", "@centre = [1, 2, 3]", "A name of [let] is a number or an expression.", "neither a number nor"),
        instead('speed = "100 m/s"', 'speed = "100 m"', "A name has the wrong unit where it is used.", "takes a speed"),
        instead('["speed", 0, 0]', '["@2 pi * speed", 0, 0]', "A product is written with *.", r"2\*pi"),
        instead("[20, 60, 0]", '["@5 m + 3", 60, 0]', "A metre and a pure number cannot be added.", "lack a unit"),
        instead("[20, 60, 0]", '["sqrt@(4 m^2", 60, 0]', "A bracket is not closed.", "not closed"),
        instead("[20, 60, 0]", '["@4 m / 0", 60, 0]', "The divisor is zero.", "divides by zero"),
        Mistake("--let names what [let] does not have.", "no such name", command=f"{CHECK} --let height=3"),
        Mistake("--let gives a value of another kind.", "takes a speed", command=f"{CHECK} --let speed=3km"),
        Mistake(
            "A script of the language of 1998 has no [let].",
            "has no \\[let\\]",
            typed="any script",
            files={"old.scr": OLD_SCRIPT},
            command="check old.scr --let speed=3",
        ),
    ]


def alternatives():
    ends = 'azimuth = "0 deg" }\n'
    points = 'type = "points"\nx = {{ points = {} }}\ny = {{ points = [[0, -8000]] }}\nz = {{ points = [[0, 3000]] }}\n'
    spline = points.format("[[0, 0]]").replace("points = [[0, 0]]", 'interpolation = @"spline", points = [[0, 0]]')
    return [
        instead('"chirp"', '@"chrip"', "A choice is misspelt.", 'did you mean "chirp"'),
        instead('"chirp"', '@"CHIRP"', "Choices are written in small letters.", 'did you mean "chirp"'),
        instead('"hdf5"', '@"h5"', "There is no such choice.", "hdf5, csv, npy, zarr or sigmf"),
        instead(PULSE, '{ bandwidth = "100 MHz" }', "It is not said which kind of pulse it is.", "has no type"),
        instead(
            ends, 'azimuth = "0 deg", @rate = "3 rpm" }\n', "The field is one of another kind of beam.", "type rotating"
        ),
        behind(
            POWER,
            'window = { type = "hamming", @pedestal = 0.3 }',
            "The field is one of another window.",
            "type hann",
        ),
        instead('type = "line"', 'type = "stationary"', "A path that stays has no start.", "type line", errors=2),
        path('type = @"line"\n', "A straight path needs its velocity.", "no velocity", typed='`type = "line"` alone'),
        path(points.format("[[1, 0], [@0, 100]]"), "Times of points ascend.", "must ascend"),
        path(points.format("[[0, 0], @[1, 100, 5]]"), "A point is a time and a value.", "not a pair"),
        path(spline, "There is no such interpolation.", "linear, cubic or low-pass"),
        path('type = "points"\nfile = @"path.dat"\n', "A data file is not there.", "cannot read the data file"),
        at_end(
            '[[geometry]]\nradar = "R"\nfile = "geometry.txt"\ncolumns = ["time", @"velosity"]\n',
            "A column is misspelt.",
            'did you mean "velocity"',
        ),
    ]


def positions():
    return [
        instead("[20, 60, 0]", "@[20, 60]", "A position has three coordinates.", "2 of them"),
        instead("[20, 60, 0]", "@[20, 60, 0, 1]", "A position has three coordinates.", "4 of them"),
        instead("[20, 60, 0]", '@"20, 60, 0"', "An array stands in brackets, not in quotes.", "three numbers"),
        instead("[20, 60, 0]", "[20 @60 0]", "Values are parted by commas.", "comma"),
        instead(
            POSITION, f"{POSITION}\n@positions = [[1, 2, 3]]", "A target has one of the two.", "either position or"
        ),
        instead(POSITION, "positions = [[1, 2, 3], @[4, 5]]", "A row is too short.", "2 of them"),
        instead(POSITION, "positions = [[1, 2, 3], @[4, 5, 6, 7]]", "A row is too long.", "4 of them"),
        instead(POSITION, 'positions = @"points.npy"', "The file stands in a table.", r"\{ file = "),
        instead(POSITION, 'positions = { file = @"points.npy" }', "The file of the points is not there.", "not there"),
        instead('range = ["8450 m", "8950 m"]', 'range = @["8450 m"]', "A window has two ends.", r"\[start, end\]"),
    ]


def references():
    double = '[[platform]]\nname = @"Plane"\n'
    return [
        instead(
            'platform = "Plane"', 'platform = @"plane"', "Capital letters count in names.", "Capital letters count"
        ),
        instead('platform = "Plane"', 'platform = @"Plan"', "The beginning of a name is not enough.", 'mean "Plane"'),
        instead('radar = "R"', 'radar = @"Radar"', "There is no radar of this name.", "no radar of this name"),
        instead("[[target]]\n", f"{double}[[target]]\n", "Two platforms have one name.", "this name"),
        behind(POWER, '@power = "2 kW"', "A field is given twice.", "appears twice"),
        behind(f"pulse = {PULSE}", '@pulse.width = "3 us"', "A table in braces is complete.", "cannot be extended"),
        instead('name = "Plane"', "name = @Plane", "Text needs straight quotes.", "needs straight quotes", errors=2),
        instead('name = "R"', "name = @5", "A name is a text.", "not a string", errors=2),
    ]


def includes():
    return [
        instead(MARK, MARK + 'include = [@"ground.toml"]\n', "The file is not there.", "cannot read an included file"),
        instead(MARK, MARK + 'include = @"ground.toml"\n', "A single file stands in brackets too.", r"include = \["),
        instead(
            MARK,
            MARK + 'include = ["ground.toml", @"ground.toml"]\n',
            "A file is included twice.",
            "included twice",
            files={"ground.toml": GROUND},
        ),
        instead(
            MARK,
            MARK + 'include = [@"scene.toml"]\n',
            "A file includes itself.",
            "includes itself",
            errors=2,
        ),
        instead(
            MARK,
            MARK + 'include = ["names.toml"]\n',
            "Another file has a name of [let] too.",
            "given twice",
            files={"names.toml": 'format = "sarsim 2"\n[let]\nspeed = 1\n'},
        ),
        instead(
            MARK,
            MARK + 'include = ["ground.toml"]\n',
            "An included file states its format too.",
            "ground.toml:1:1: .*not stated",
            files={"ground.toml": GROUND.split("\n", 1)[1]},
        ),
        at_end('@include = ["ground.toml"]\n', "What is included stands before all headers.", "no field 'include'"),
    ]


def brackets():
    return [
        instead("[[radar]]", "@[radar]", "There can be many radars: double brackets.", "double brackets", errors=2),
        instead("[[radar]]", "[[radar@]", "A bracket of a header is missing.", r"expected \]\]"),
        instead("[[radar]]", '[[radar]] @name = "R2"', "A header stands in a line of its own.", "line should end"),
        instead('"3 GHz"', '@"3 GHz', "A quote is missing.", "not closed"),
        instead('"3 GHz"', "@“3 GHz”", "Word processors make other quotes.", "needs straight quotes"),
        instead("[20, 60, 0]", "@[20, 60, 0", "A bracket is missing.", r"closing \]"),
        instead("[20, 60, 0]", "[20, 60, 0]@]", "There is one bracket too many.", "line should end"),
        instead("[20, 60, 0]", "@(20, 60, 0)", "Arrays have square brackets.", "not a TOML value"),
        instead('"2 us" }', '"2 us", @}', "No comma stands before the brace.", "no comma"),
        instead('{ type = "chirp", b', '@{ type = "chirp",\n  b', "A table in braces stands in one line.", "same line"),
        instead('"chirp", bandwidth', '"chirp" @bandwidth', "A comma is missing.", "comma"),
        instead(POWER, 'power@: "1 kW"', "A value follows an equals sign.", "key = value"),
        instead(POWER, "power =@", "The value is missing.", "value is missing"),
        instead(POWER, f"{POWER}@;", "A line ends without a semicolon.", "line should end"),
        instead(
            '"echoes.h5"', '"C:@\\data\\echoes.h5"', "A backslash is doubled, or the text stands in ' '.", "backslash"
        ),
    ]


def texts():
    return [
        instead("[[target]]", "@! the target\n[[target]]", "Comments begin with #.", "begin with #"),
        instead("[[target]]", "@// the target\n[[target]]", "Comments begin with #.", "key is missing"),
        at_end(
            "@$RADAR R2 Plane\n", "That is a command of the language of 1998.", "key is missing"
        ),
        Mistake("Scenes are in UTF-8.", "looks like UTF-16", typed="a file in UTF-16", coding="utf-16"),
        Mistake(
            "Letters beyond ASCII are written in UTF-8.",
            "not UTF-8",
            (('name = "R"', 'name = "R@ä"'), ('radar = "R"', 'radar = "Rä"')),
            typed="a file in Latin-1",
            coding="latin-1",
            errors=2,
        ),
        instead(
            '"100 MHz"',
            '"@100 ms"',
            "Lines that end as in Windows are read and counted as others.",
            "takes a frequency",
            typed="`bandwidth = \"100 ms\"` in a file with CR LF",
            coding="crlf",
        ),
        instead(
            MARK, "", "The first line says which format it is.", "not stated", typed="no line with the format", errors=1
        ),
        instead('"sarsim 2"', '@"sarsim 3"', "The file was written for a newer Sarsim.", "newer Sarsim"),
        instead('"sarsim 2"', '@"Sarsim 2"', "The mark of the format is written in small letters.", "not known"),
        instead('"sarsim 2"', "@2", "The mark of the format is a text.", "not known"),
        Mistake("The file is not there.", "no such file", command="check scenes.toml", typed="nothing"),
        Mistake(
            "Nothing is recorded.",
            "defines nothing to compute",
            whole='format = "sarsim 2"\n',
            typed="the line with the format alone",
            status=0,
        ),
    ]


THEMES = {
    "Names": names,
    "Units": units,
    "Numbers": numbers,
    "Expressions, [let] and --let": expressions,
    "Alternatives": alternatives,
    "Positions and rows": positions,
    "Names of objects": references,
    "Included files": includes,
    "Brackets, quotes and commas": brackets,
    "The file": texts,
}
