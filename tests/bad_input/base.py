"""A sound script to be spoiled, and short ways to spoil it."""

from harness import SCRIPT

SCENE = """\
! a target that passes a radar
$PLATFORM Ground
STATIONARY 0 0 0
CONST 0 0 0 0 0 0
STDDEV 0 0 0
STDDEV 0 0 0
$PLATFORM Car
TRAJECTORY LINEAR LINEAR LINEAR INLINE
2 0, 0 1, 20
1 0, 1000
1 0, 0
NOT_ALIGNED
CONST 0 0 0 0 0 0
STDDEV 0 0 0
STDDEV 0 0 0
$TARGET Car
0 0 0
0 0 0
1 0
ISOTROPIC
$RADAR Radar1 Ground
CHIRP 0.05
1000
RECT
CONSTANT 1000
SINGLE 1
100
0 300
ISOTROPIC SAME
FIXED 0 0
RECT NO_STC
$SIMULATION Radar1
900 1400
0 0.019
8 0.1 0
BINARY RAW sim.bin
BEGIN 1 1
"""


def spoiled(*changes, text=SCENE):
    """A script with passages replaced, each of which has to be there exactly once."""
    for old, new in changes:
        if text.count(old) != 1:
            raise ValueError(f"{old!r} stands {text.count(old)} times in the script")
        text = text.replace(old, new)
    return text


def script(*changes, **more):
    """The files of a case: the spoiled script and others."""
    return {SCRIPT: spoiled(*changes), **more}


def long_scene(**more):
    """A scene whose recording takes seconds: half a gigabyte of noise."""
    return script(("0 0.019", "0 800"), ("8 0.1 0", "8 0.1 3e-5"), **more)
