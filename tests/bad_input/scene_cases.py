"""Scenes that are well written and make no sense."""

from base import SCENE, script
from harness import SCRIPT, Case

STEPS = ("SINGLE 1\n", "STEPPED 1 0.001 4 1\n")
ZERO_LIST = "CONSTANT 1000\nSINGLE 1\n"
OWN_PULSES = ("! a target that passes a radar\n", "$OPTIONS AMBIGUOUS_ECHOES NONE\n")


def window(text):
    return ("900 1400\n0 0.019", text)


def recording_cases():
    """What is recorded, and how."""
    return [
        Case(
            "empty_window",
            "slant range window of no length",
            script(window("900 @900\n0 0.019")),
            message=["window is empty"],
        ),
        Case(
            "reversed_window",
            "slant range window with its ends exchanged",
            script(window("1400 @900\n0 0.019")),
            message=["window is empty"],
        ),
        Case(
            "reversed_time",
            "azimuth window with its ends exchanged",
            script(window("900 1400\n0.019 @0")),
            message=["ends before it starts"],
        ),
        Case(
            "no_pulse",
            "azimuth window between two pulses",
            script(window("900 1400\n0.0001 @0.0002")),
            message=["no pulse is sent", "for instance 0 s or 1 ms"],
        ),
        Case(
            "no_sample",
            "window shorter than a sample",
            script(window("900 900.1\n0 0.019"), ("8 0.1 0", "8 @0.1 0")),
            message=["too short for one sample"],
        ),
        Case("zero_rate", "sampling frequency 0", script(("8 0.1 0", "8 @0 0")), message=["sampling frequency"]),
        Case("huge_rate", "sampling frequency 1e300 GHz", script(("8 0.1 0", "8 @1e300 0")), message=["too large"]),
        Case(
            "long_row",
            "row of 1e12 samples",
            script(window("0 @1.5e12\n0 0.019")),
            message=["a row of 1.*e.?12 samples is too long|a row of .* is too long"],
        ),
        Case(
            "endless_row",
            "recording of 1e20 samples",
            script(window("0 @1.5e15\n0 1000")),
            message=["is too long|cannot be made"],
        ),
        Case(
            "endless_recording",
            "recording of 1e12 rows",
            script(window("900 1400\n0 1e9"), ("BINARY", "HDF5")),
            status=1,
            severity="",
            message=["sarsim: error: the disk of '.' has not enough room: .* are needed"],
        ),
        Case(
            "uncountable_pulses",
            "recording of 1e20 pulses",
            script(window("900 1400\n0 @1e17")),
            message=["number its pulses"],
        ),
        Case(
            "uncountable_samples",
            "recording of 3e17 samples",
            script(window("900 1400\n0 @1e12")),
            message=["samples cannot be made"],
        ),
        Case(
            "endless_table",
            "geometry table of 1e12 lines",
            {SCRIPT: SCENE[: SCENE.index("$SIM")] + "$GEOMETRY Radar1 0 2000 0 1e9 SPACE 227 t.txt\n"},
            status=1,
            severity="",
            message=["not enough room"],
        ),
        Case(
            "table_without_pulse",
            "geometry table between two pulses",
            {SCRIPT: SCENE + "$GEOMETRY Radar1 0 2000 0.0001 @0.0002 SPACE 227 t.txt\n"},
            message=["no pulse is sent"],
        ),
        Case("no_bits", "A/D converter of 0 bits", script(("8 0.1 0", "@0 0.1 0")), message=["bits"]),
        Case("many_bits", "A/D converter of 65 bits", script(("8 0.1 0", "@65 0.1 0")), message=["bits"]),
        Case(
            "negative_lsb",
            "negative least significant bit",
            script(("8 0.1 0", "8 0.1 @-1")),
            message=["negative|zero or more"],
        ),
        Case(
            "folded_band_strict",
            "sampling below the bandwidth, --strict",
            script(("8 0.1 0", "8 @0.01 0")),
            ("run", SCRIPT, "--strict"),
            severity="warning",
            message=["alias back"],
            shown="sarsim run scene.scr --strict",
        ),
        Case(
            "no_echo_strict",
            "target outside the window, --strict",
            script(window("@5000 5500\n0 0.019")),
            ("run", SCRIPT, "--strict"),
            severity="warning",
            message=["no echo falls into", "about 10\\d\\d"],
            shown="sarsim run scene.scr --strict",
        ),
        Case(
            "no_target_strict",
            "scene without targets, --strict",
            {SCRIPT: SCENE[: SCENE.index("$TARGET")] + SCENE[SCENE.index("$RADAR") :].replace("$SIM", "@$SIM")},
            ("run", SCRIPT, "--strict"),
            severity="warning",
            message=["has no target"],
            shown="sarsim run scene.scr --strict",
        ),
        Case(
            "far_window_strict",
            "window beyond five pulse intervals, --strict",
            script(window("900 @750000\n0 0.019"), ("RAW", "RAW"), OWN_PULSES),
            ("run", SCRIPT, "--strict"),
            severity="warning",
            message=["unambiguous range"],
            shown="sarsim run scene.scr --strict",
        ),
        Case(
            "clipping_strict",
            "least significant bit that clips, --strict",
            script(("8 0.1 0", "8 0.1 @1e-12")),
            ("run", SCRIPT, "--strict"),
            severity="warning",
            message=["clipped"],
            shown="sarsim run scene.scr --strict",
        ),
        Case(
            "srp_without_steps",
            "synthetic range profile without frequency steps",
            script(("BINARY RAW", "BINARY @SRP")),
            message=["at least two frequency steps"],
        ),
        Case(
            "srp_one_step",
            "synthetic range profile of one step",
            script(("SINGLE 1\n", "STEPPED 1 0.001 1 1\n"), ("BINARY RAW", "BINARY @SRP")),
            message=["at least two frequency steps; found '1 step'"],
        ),
        Case(
            "srp_no_burst",
            "synthetic range profile without a whole burst",
            script(
                ("CHIRP 0.05", "MONO"),
                ("SINGLE 1\n", "STEPPED 1 0.001 64 1\n"),
                window("900 1400\n0 @0.019"),
                ("BINARY RAW", "BINARY SRP"),
            ),
            message=["no complete burst"],
        ),
        Case(
            "output_dots",
            "output called ..",
            script(("RAW sim.bin", "RAW @..")),
            message=["output file has no name"],
        ),
        Case(
            "output_folder_name",
            "output that ends in a slash",
            script(("RAW sim.bin", "RAW @results/")),
            message=["output file has no name"],
        ),
        Case(
            "output_elsewhere",
            "output in another folder: only its name counts",
            script(("RAW sim.bin", "RAW ../../sim.bin")),
            status=0,
            severity="",
            hint=False,
            makes=["sim.bin"],
        ),
        Case(
            "output_long_name",
            "output with a name of 5000 letters",
            script(("RAW sim.bin", "RAW " + "x" * 5000)),
            status=1,
            severity="",
            message=["sarsim: error: .*[Nn]ame too long"],
        ),
    ]


def radar_cases():
    """Radars and their pulses."""
    return [
        Case("zero_pulse", "pulse width 0", script(("0.05\n1000", "0.05\n@0")), message=["pulse width"]),
        Case("zero_carrier", "carrier 0", script(("SINGLE 1\n", "SINGLE @0\n")), message=["carrier"]),
        Case("negative_carrier", "negative carrier", script(("SINGLE 1\n", "SINGLE @-1\n")), message=["carrier"]),
        Case("zero_prf", "PRF 0", script(("CONSTANT 1000", "CONSTANT @0")), message=["pulse repetition frequency"]),
        Case(
            "infinite_prf",
            "infinite PRF",
            script(("CONSTANT 1000", "CONSTANT @inf")),
            message=["pulse repetition frequency is not a number"],
        ),
        Case(
            "nan_power",
            "power that is not a number",
            script(("\n100\n", "\n@NaN\n")),
            message=["power is not a number"],
        ),
        Case("negative_power", "negative power", script(("\n100\n", "\n@-1\n")), message=["power is out of range"]),
        Case(
            "zero_in_pri_list",
            "list of pulse intervals with 0",
            script(("CONSTANT 1000", "OTHER LINEAR INLINE 2 0 0.001 1 @0")),
            message=["interval"],
        ),
        Case(
            "empty_pri_list",
            "list of no pulse intervals",
            script(("CONSTANT 1000", "OTHER @LINEAR INLINE 0")),
            message=["has no points|no points"],
        ),
        Case(
            "zero_in_carrier_list",
            "list of carriers with 0",
            script(("SINGLE 1\n", "OTHER LINEAR INLINE 2 0 1 1 @0\n")),
            message=["frequency"],
        ),
        Case("barker_number", "Barker code 7", script(("CHIRP 0.05", "BARKER @7")), message=["Barker code"]),
        Case(
            "no_step",
            "0 frequency steps",
            script(("SINGLE 1\n", "STEPPED 1 0.001 @0 1\n")),
            message=["number of frequencies"],
        ),
        Case(
            "silent_pulse",
            "user-defined pulse of zeros",
            script(("CHIRP 0.05", "OTHER_PULSE @LINEAR LINEAR INLINE 1 0 0 1 0 0")),
            message=["zero throughout"],
        ),
        Case(
            "silent_envelope",
            "pulse envelope of zeros",
            script(("RECT\nCONSTANT", "OTHER @LINEAR INLINE 1 0 0\nCONSTANT")),
            message=["zero throughout"],
        ),
        Case(
            "silent_window",
            "matched-filter window of zeros",
            script(("RECT NO_STC", "OTHER @LINEAR INLINE 1 0 0 NO_STC")),
            message=["zero throughout"],
        ),
        Case("no_beam", "beam width 0", script(("ISOTROPIC SAME", "SINX @0 10 SAME")), message=["beam width"]),
        Case(
            "wide_beam",
            "beam width above a full circle",
            script(("ISOTROPIC SAME", "SINX 10 @361 SAME")),
            message=["beam width"],
        ),
        Case(
            "long_pulse_strict",
            "pulse longer than the pulse interval, --strict",
            script(("0.05\n1000", "0.05\n@2e6"), OWN_PULSES),
            ("run", SCRIPT, "--strict"),
            severity="warning",
            message=["longer than the interval"],
            shown="sarsim run scene.scr --strict",
        ),
        Case(
            "long_replica",
            "matched filter of a pulse of 1e11 samples",
            script(window("900 900.01\n0 0.019"), ("8 0.1 0", "8 @1e8 0"), ("RAW", "MATCHED_FILTER")),
            message=["a pulse of 1e.11 samples is too long"],
        ),
        Case(
            "huge_gain",
            "gains of 300 dB and much power",
            script(("\n100\n0 300", "\n1e15\n300 300 0 300"), ("Car\n0 0 0\n0", "Car\n@0 0 0\n0")),
            message=["too strong to be recorded"],
        ),
        Case(
            "gain_beyond",
            "gain of 301 dB",
            script(("\n100\n0 300", "\n100\n@301 0 0 300")),
            message=["gain of the transmitter is out of range", "0 to 300"],
        ),
    ]


def target_cases():
    """Targets, platforms and surfaces."""
    same = ("1 0, 1000\n", "1 0, 0\n")
    return [
        Case(
            "target_at_radar",
            "target at the radar's position",
            script(("$TARGET Car\n0 0 0", "$TARGET Ground\n@0 0 0")),
            message=["is at the position of radar 'Radar1'", "move the target"],
        ),
        Case(
            "everything_at_origin",
            "target and radar at the origin of one platform",
            script(
                ("$TARGET Car\n0 0 0", "$TARGET Ground\n@0 0 0"),
                (
                    "BEGIN 1 1\n",
                    "BEGIN 1 1\n$SIMULATION Radar1 900 1400 0 0.01 8 0.1 0 BINARY RAW other.bin BEGIN 1 1\n",
                ),
            ),
            message=["is at the position"],
        ),
        Case(
            "target_through_radar",
            "target that flies through the radar between the pulses looked at first",
            script(
                ("2 0, 0 1, 20\n1 0, 1000", "2 0, -777 1, 223\n1 0, 0"),
                ("$TARGET Car\n0", "$TARGET Car\n@0"),
                ("900 1400\n0 0.019", "0 1400\n0 2"),
            ),
            alone=False,
            message=["is at the position of radar 'Radar1'.*pulse 777"],
        ),
        Case(
            "faster_than_light",
            "target faster than light",
            script(("1, 20\n", "1, 6e8\n"), ("$TARGET Car\n0", "$TARGET Car\n@0"), same),
            message=["as fast as light"],
        ),
        Case(
            "nan_position",
            "position that is not a number",
            script(("$TARGET Car\n0", "$TARGET Car\n@NaN")),
            message=["position x is not a number"],
        ),
        Case(
            "infinite_position",
            "infinite position",
            script(("$TARGET Car\n0", "$TARGET Car\n@inf")),
            message=["position x is not a number"],
        ),
        Case(
            "far_position",
            "position 1e300 m",
            script(("$TARGET Car\n0", "$TARGET Car\n@1e300")),
            message=["too large to compute with"],
        ),
        Case(
            "negative_rcs_strict",
            "negative radar cross-section, --strict",
            script(("\n1 0\nISO", "\n@-1 0\nISO")),
            ("run", SCRIPT, "--strict"),
            severity="warning",
            message=["negative and counts as zero"],
            shown="sarsim run scene.scr --strict",
        ),
        Case(
            "negative_deviation",
            "negative standard deviation",
            script(("0 0 0\n1 0\nISO", "0 @-1 0\n1 0\nISO")),
            message=["deviation"],
        ),
        Case(
            "same_time_twice",
            "trajectory with the same time twice",
            script(("2 0, 0 1, 20", "2 0, 0 @0, 20")),
            message=["must ascend"],
        ),
        Case(
            "single_point_envelope",
            "error function of a single point",
            script(
                (
                    "CONST 0 0 0 0 0 0\nSTDDEV 0 0 0\nSTDDEV 0 0 0\n$TARGET",
                    (
                        "CONST 0 0 0 0 0 0\nOTHER @LINEAR LINEAR LINEAR INLINE 1 0 1 2 0 1 1 0 2 0 1 1 0\n"
                        "STDDEV 0 0 0\n$TARGET"
                    ),
                ),
            ),
            message=["single point"],
        ),
        Case(
            "huge_surface",
            "surface of 1e18 points",
            {SCRIPT: SCENE + "$SURFACE Ground @1000 0 0 1000 1.5e9 0 1000 0 1.5e9\n"},
            message=["surface is too large"],
        ),
        Case(
            "flat_surface_strict",
            "surface without area, --strict",
            {SCRIPT: SCENE + "$SURFACE Ground @1000 0 0 1000 1 0 1000 2 0\n"},
            ("run", SCRIPT, "--strict"),
            severity="warning",
            message=["no area"],
            shown="sarsim run scene.scr --strict",
        ),
    ]


GROUPS = {"recordings": recording_cases, "radars": radar_cases, "targets": target_cases}
