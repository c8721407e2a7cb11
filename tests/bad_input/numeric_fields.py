"""Every numeric field of the script language with every value that is none.

In SCENE a line `~VALUE  what it is | more bad values` is a numeric field on a line of its own. `#` before the value
marks a whole number, `*` a number of points. A bad value with a `+` behind it is found at the line after its own, where
it contradicts what stands there.
"""

import dataclasses

from harness import SCRIPT, Case

SCENE = """\
$OPTIONS
SEED
~#7  seed | -1, 18446744073709551616
TOLERANCE
~1e-6  tolerated relative error | 0, 0.11, 9e-13
$PLATFORM Still
STATIONARY
~0  position x
~0  position y
~0  position z
CONST
~0  rotation about x
~0  rotation about y
~0  rotation about z
~0  rotation rate about x
~0  rotation rate about y
~0  rotation rate about z
STDDEV
~0  standard deviation of position x | -1e-300
~0  standard deviation of position y | -1e-300
~0  standard deviation of position z | -1e-300
STDDEV
~0  standard deviation of the rotation about x | -1e-300
~0  standard deviation of the rotation about y | -1e-300
~0  standard deviation of the rotation about z | -1e-300
$PLATFORM Moving
TRAJECTORY LINEAR LINEAR LINEAR INLINE
~*2  number of points for position x | -1
~0  time of a point
~1000  position x of a point
~1  time of a point | 0
~1010  position x of a point
~*2  number of points for position y | -1
~0  time of a point
~0  position y of a point
~1  time of a point | 0
~10  position y of a point
~*1  number of points for position z | -1
~0  time of a point
~0  position z of a point
NOT_ALIGNED
OTHER LINEAR LINEAR LINEAR INLINE
~*1  number of points for rotation x | -1
~0  time of a point
~0  rotation x of a point
~*1  number of points for rotation y | -1
~0  time of a point
~0  rotation y of a point
~*2  number of points for rotation z | -1
~0  time of a point
~0  rotation z of a point
~1  time of a point | 0
~5  rotation z of a point
~0  rotation rate about x
~0  rotation rate about y
~1  rotation rate about z
OTHER LINEAR LINEAR LINEAR INLINE
~*2  number of points for error weight x | -1
~0  time before now of a point
~0.001  error weight x of a point
~0.01  time before now of a point | 0
~0  error weight x of a point
2 0 0 0.01 0
2 0 0 0.01 0
OTHER LINEAR LINEAR LINEAR INLINE
2 0 0 0.01 0
2 0 0 0.01 0
~*2  number of points for error weight z | -1
~0  time before now of a point
~0.001  error weight z of a point
~0.01  time before now of a point | 0
~0  error weight z of a point
$SURFACE Still
~1000  corner x
~0  corner y
~0  corner z
~1000  corner x
~0  corner y
~1  corner z
~1000  corner x
~1  corner y
~0  corner z
$TARGET Moving
~10  position x
~0  position y
~0  position z
~0.1  standard deviation of position x | -1e-300
~0  standard deviation of position y | -1e-300
~0  standard deviation of position z | -1e-300
~1  radar cross-section
~0.1  standard deviation of the radar cross-section | -1e-300
DIRECTIONAL
~-90  azimuth of the target's face
~0  elevation of the target's face
~1  standard deviation of the azimuth | -1e-300
~1  standard deviation of the elevation | -1e-300
OTHER_GAIN LINEAR INLINE
~*2  number of points for reflectivity | -1
~0  incidence angle of a point
~0  reflectivity of a point
~90  incidence angle of a point | 0
~-20  reflectivity of a point
$RADAR Steps Still CHIRP
~0.001  chirp bandwidth
~1000  pulse width | 0, -1e-300
LINEAR
~100  rise time | -1e-300
~100  fall time | -1e-300
CONSTANT
~1000  pulse repetition frequency | 0, 9.9999e-6, -1000
STEPPED
~1  first carrier frequency | 0, -1
~0.001  frequency step | -1e-300
~#4  number of frequencies | 0, 1001
~#2  pulses at each frequency | 0, 101
~1  transmitted power | -1e-300
~0  gain of the transmitter | -1e-300
~0  gain of the receiver | -1e-300
~0  losses of the system | -1e-300
~300  noise temperature | -1e-300
SINX
~40  beam width in elevation | 0, -1, 360.00000000000006
~40  beam width in azimuth | 0, -1, 360.00000000000006
SINX
~40  beam width in elevation | 0, -1, 360.00000000000006
~40  beam width in azimuth | 0, -1, 360.00000000000006
FIXED
~0  elevation of the beam
~90  azimuth of the beam
HANNING
~0.5  Hanning constant | -1e-300, 1.0000000000000002
NO_STC
$RADAR Code Still BARKER
~#6  Barker code | -1, 7
1300 RECT CONSTANT 1000 SINGLE
~1  carrier frequency | 0, -1
~1  transmitted power | -1e-300
~0  losses of the system | -1e-300
~0  noise temperature | -1e-300
ISOTROPIC SAME ROTATING
~0  elevation of the beam
~60  rotation rate of the beam | -1e-300
RECT NO_STC
$RADAR Spot Still MONO 1000 RECT CONSTANT 1000 SINGLE 1 1 0 0 SINX 40 40 ISOTROPIC SPOT
~1000  spot x
~0  spot y
~0  spot z
RECT NO_STC
$RADAR User Still OTHER_PULSE LINEAR LINEAR INLINE
~*2  number of points for I | -1
~0  fraction of the pulse width of a point
~1  I of a point
~1  fraction of the pulse width of a point | 0
~1  I of a point
~*1  number of points for Q | -1
~0  fraction of the pulse width of a point
~0  Q of a point
1000
OTHER LINEAR INLINE
~*2  number of points for amplitude | -1
~0  fraction of the pulse width of a point
~1  amplitude of a point
~1  fraction of the pulse width of a point | 0
~1  amplitude of a point
OTHER LINEAR INLINE
~*2  number of points for interval | -1
~0  pulse number of a point
~0.001  interval of a point | 0, -1e-300
~1  pulse number of a point
~0.002  interval of a point | 0, -1e-300
OTHER LINEAR INLINE
~*2  number of points for frequency | -1
~0  pulse number of a point
~1  frequency of a point | 0, -1e-300
~1  pulse number of a point
~1.1  frequency of a point | 0, -1e-300
1 0 0
OTHER LINEAR LINEAR INLINE
~*2  number of points for gain in azimuth | -1
~0  angle off the beam of a point
~0  gain in azimuth of a point
~180  angle off the beam of a point | 0
~-3  gain in azimuth of a point
~*1  number of points for gain in elevation | -1
~0  angle off the beam of a point
~0  gain in elevation of a point
OTHER LINEAR LINEAR INLINE
~*1  number of points for gain in azimuth | -1
~0  angle off the beam of a point
~0  gain in azimuth of a point
~*1  number of points for gain in elevation | -1
~0  angle off the beam of a point
~0  gain in elevation of a point
OTHER LINEAR LINEAR LINEAR INLINE
~*1  number of points for position x | -1
~0  time of a point
~1000  position x of a point
~*1  number of points for position y | -1
~0  time of a point
~0  position y of a point
~*1  number of points for position z | -1
~0  time of a point
~0  position z of a point
OTHER LINEAR INLINE
~*2  number of points for weight | -1
~0  fraction of the pulse width of a point
~1  weight of a point
~1  fraction of the pulse width of a point | 0
~1  weight of a point
APPLY_STC OTHER LINEAR INLINE
~*2  number of points for voltage gain | -1
~0  range of a point
~1  voltage gain of a point
~2000  range of a point | 0
~1  voltage gain of a point
$SIMULATION Steps
~900  slant range of the first sample | 1400+
~1400  slant range of the end | 900
~0  slow time of the start | 0.021+
~0.02  slow time of the end | -0.001
~#8  bits | 0, 65
~0.01  sampling frequency | 0, -1, 1e-300
~0  least significant bit | -1e-300
BINARY RAW steps.bin BEGIN
~1  over-sampling | 0.9999999999999999, 100.00000000000001
~1  kept length of a band-limited pulse | -1e-300, 0.9999999999999999, 100.00000000000001
$SIMULATION User 900 1400 0 0.02 8 0.01 0 ASCII MATCHED_FILTER user.asc BEGIN 1 1
$SIMULATION Code 900 1400 0 0.02 8 0.02 0 ASCII RAW code.asc BEGIN 1 1
$SIMULATION Spot 900 1400 0 0.02 8 0.02 0 ASCII RAW spot.asc BEGIN 1 1
$GEOMETRY Steps
~900  slant range of the start | 1400+
~1400  slant range of the end | 900
~0  slow time of the start | 0.021+
~0.02  slow time of the end | -0.001
SPACE
~#255  sum of the column bits | -1, 256
steps.txt
"""

PRODUCTS = ("steps.bin", "user.asc", "code.asc", "spot.asc", "steps.txt")
NO_NUMBERS = ("NaN", "inf", "-inf", "1e999", "xyz", "5Hz")
# Finite, but no distance, time or power of this world: nothing can be computed with them.
TOO_LARGE = ("1e300", "-1e300")


@dataclasses.dataclass
class Field:
    """A numeric field of SCENE."""

    command: str
    line: int  # In SCENE, from 1.
    words: str
    kind: str  # "", "#" or "*"
    out_of_range: list[str]

    def bad_values(self):
        return [*NO_NUMBERS, *TOO_LARGE, *(["1.5"] if self.kind else []), *self.out_of_range]


def parse():
    """The lines of the sound script, and its numeric fields."""
    lines = []
    fields = []
    command = ""
    for number, line in enumerate(SCENE.splitlines(), 1):
        if line.startswith("$"):
            command = line.split()[0]
        if not line.startswith("~"):
            lines.append(line)
            continue
        value, text = line[1:].split(None, 1)
        kind = value[0] if value[0] in "#*" else ""
        words, _, bad = text.partition(" | ")
        fields.append(Field(command, number, words, kind, bad.split(", ") if bad else []))
        lines.append(value[len(kind) :])
    return lines, fields


LINES, FIELDS = parse()


def sound_case():
    """The scene as it is, which has to run."""
    return Case(
        "sound scene", "nothing", {SCRIPT: "\n".join(LINES) + "\n"}, status=0, severity="", makes=PRODUCTS, hint=False
    )


def case_of(field, value):
    lines = list(LINES)
    elsewhere = value.endswith("+")
    lines[field.line - 1] = value.rstrip("+")
    marked = field.line if elsewhere else field.line - 1
    lines[marked] = "@" + lines[marked]
    message = []
    if value in NO_NUMBERS:
        wrong = "is not a number|is too large a number|is not a seed|whole number"
        message = [rf"{field.words}\b.* ({wrong})", f"found '{value}'"]
    return Case(
        f"{field.command} line {field.line}, {field.words}: {value}",
        f"{field.words} is {value}",
        {SCRIPT: "\n".join(lines) + "\n"},
        message=message,
    )


def cases(command):
    """All bad values of all numeric fields of a command."""
    return [case_of(field, value) for field in FIELDS if field.command == command for value in field.bad_values()]


COMMANDS = list(dict.fromkeys(field.command for field in FIELDS))
