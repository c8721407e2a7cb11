"""Scripts and data files that are wrong as text, or say what makes no sense."""

from base import SCENE, script, spoiled
from harness import SCRIPT, Case


def with_data_file(name, **files):
    """A scene whose reflectivity comes from a data file."""
    return script(("ISOTROPIC\n$RADAR", f"DIRECTIONAL 0 0 0 0 OTHER_GAIN LINEAR FILE {name}\n$RADAR"), **files)


def file_cases():
    """The script as a file."""
    return [
        Case("empty_script", "script without a word", {SCRIPT: ""}, message=["no scene: it seems to be an empty file"]),
        Case("blank_script", "script of comments only", {SCRIPT: "! nothing\n\n"}, message=["defines nothing to compute"]),
        Case("missing_script", "script that does not exist", message=["scene.scr: error: .*no such file"]),
        Case("folder_as_script", "folder in place of the script", {f"{SCRIPT}/x": ""}, message=["is a folder"]),
        Case(
            "device_as_script",
            "device in place of the script",
            command=("run", "/dev/full"),
            message=["is not a file"],
            shown="sarsim run /dev/full",
        ),
        Case(
            "binary_script",
            "program in place of the script",
            {SCRIPT: b"\x7fELF\x02\x01\x01\0\0\0" * 99},
            message=[r"no scene: it seems to be a program \(ELF\)"],
        ),
        Case(
            "nul_in_script",
            "byte 0 in a script",
            {SCRIPT: spoiled(("CHIRP 0.05", "CHIRP @\0 0.05"))},
            message=["not a text file"],
        ),
        Case(
            "utf16_script",
            "script in UTF-16",
            {SCRIPT: SCENE.encode("utf-16")},
            message=["not a text file", "UTF-16"],
            anywhere=True,
        ),
        Case(
            "no_permission_script",
            "script that may not be read",
            script(),
            message=["ermission"],
            user=65534,
            prepare=lambda folder: (folder / SCRIPT).chmod(0),
        ),
        Case(
            "samples_as_script",
            "file of samples in place of the script",
            {SCRIPT: "12 -7\n3 4\n" * 9},
            message=[r"^scene\.scr: error: this is no scene: it seems to be a table of numbers"],
        ),
        Case(
            "nothing_asked",
            "script that describes nothing: options alone",
            {SCRIPT: "$OPTIONS SEED 2\n"},
            message=[r"scene\.scr: .*defines nothing to compute"],
        ),
    ]


def truncated():
    """The script ends in the middle of each command."""
    cases = []
    for word, after in (("PLATFORM", "STDDEV 0 0"), ("TARGET", "0 0 0\n0 0"), ("RADAR", "CONSTANT 1000"),
                        ("SIMULATION", "0 0.019")):
        begin = SCENE.index("$" + word)
        end = SCENE.index(after, begin) + len(after)
        cut = SCENE[:end]
        # The message points to the last word there is.
        last = max(cut.rfind(" "), cut.rfind("\n")) + 1
        cases.append(Case(f"truncated_{word.lower()}", f"script that ends within ${word}",
                          {SCRIPT: cut[:last] + "@" + cut[last:]}, message=[rf"\${word} ends before"]))
    for word, text in (("SURFACE", "$SURFACE Ground 1 2 3 4 @5"), ("GEOMETRY", "$GEOMETRY Radar1 0 1 @2"),
                       ("OPTIONS", "$OPTIONS @SEED")):
        cases.append(Case(f"truncated_{word.lower()}", f"script that ends within ${word}", {SCRIPT: SCENE + text},
                          message=[rf"\${word} ends before"]))
    cases.append(Case("truncated_inline", "script that ends within INLINE data",
                      {SCRIPT: SCENE[: SCENE.index("1 0, 1000")].rstrip().removesuffix(" 1, 20") + "@"},
                      message=["2 points were announced for position x .*end after 1"]))
    return cases


def word_cases():
    """Words that are none, or not there."""
    return [
        Case(
            "unknown_command",
            "command that does not exist",
            script(("$TARGET", "@$TRAGET")),
            message=["unknown command", r"did you mean \$TARGET\?"],
        ),
        Case(
            "foreign_command",
            "command of another language",
            script(("$TARGET Car", "@$import os\n$TARGET Car")),
            message=["unknown command"],
        ),
        Case(
            "unknown_radar_command",
            "misspelt $RADAR, whose radar is used below",
            script(("$RADAR", "@$RADRA")),
            message=["unknown command", r"did you mean \$RADAR\?"],
        ),
        Case("unknown_pulse", "keyword that does not exist", script(("CHIRP", "@CHRIP")), message=["did you mean CHIRP"]),
        Case(
            "unknown_format",
            "file format that does not exist",
            script(("BINARY", "@BNIARY")),
            message=["did you mean BINARY"],
        ),
        Case(
            "unknown_option",
            "option that does not exist",
            script(("$PLATFORM Ground", "$OPTIONS @SPEED 1\n$PLATFORM Ground")),
            message=["not a valid choice", "SEED"],
        ),
        Case(
            "unknown_profile",
            "profile that does not exist",
            script(("$PLATFORM Ground", "$OPTIONS PROFILE @MODERN\n$PLATFORM Ground")),
            message=["CLASSIC or PHYSICAL"],
        ),
        Case(
            "missing_number",
            "number left out",
            script(("CONSTANT 1000\nSINGLE", "CONSTANT\n@SINGLE")),
            message=["frequency is missing"],
        ),
        Case(
            "number_too_many",
            "number too many",
            script(("SINGLE 1\n100", "SINGLE 1 2\n@100")),
            message=["3 values between the power and the transmit antenna|values between"],
        ),
        Case(
            "missing_name",
            "command without its name",
            script(("$TARGET Car\n0 0 0\n0 0 0\n1 0\nISOTROPIC", "@$TARGET")),
            message=["ends before the name"],
        ),
        Case("empty_name", "empty name", script(("$PLATFORM Car", '$PLATFORM @""')), message=["is empty"]),
        Case(
            "unit_behind_number",
            "unit behind a number",
            script(("CONSTANT 1000", "CONSTANT @1000Hz")),
            message=["not a number; found '1000Hz'", "the unit is fixed"],
        ),
        Case(
            "decimal_comma",
            "comma as decimal mark",
            script(("CHIRP 0.05\n1000", "CHIRP 0,05\n@1000")),
            message=["one number too many before it"],
        ),
        Case(
            "hexadecimal",
            "number in base 16",
            script(("CONSTANT 1000", "CONSTANT @0x3e8")),
            message=["not a number"],
        ),
        Case(
            "open_quote",
            "quote that is not closed",
            script(("$TARGET Car", '$TARGET @"Car')),
            message=["quote is not closed"],
        ),
        Case(
            "long_word",
            "word of a megabyte",
            script(("CONSTANT 1000", "CONSTANT @" + "9" * 1_000_000)),
            message=["too large a number; found '9{60}\\.\\.\\.'"],
        ),
        Case(
            "long_name",
            "unknown platform with a name of a megabyte",
            script(("$TARGET Car", "$TARGET @" + "x" * 1_000_000)),
            message=["no platform has this name; found 'x{10,250}\\.\\.\\.'"],
        ),
        Case(
            "long_line",
            "line of ten megabytes with a mistake at its end",
            script(("CONSTANT 1000", "CONSTANT " + " " * 10_000_000 + "oops")),
            message=[r"scene\.scr:25:10000010: error: .*not a number; found 'oops'"],
        ),
        Case(
            "many_errors",
            "mistake repeated 5000 times",
            {SCRIPT: SCENE + "$NONSENSE\n" * 5000},
            severity="",
            hint=False,
            message=[r"scene\.scr:38:1: error: unknown command.*\(1000 times\)", "stopped after 1000 errors"],
        ),
    ]


def name_cases():
    """Names that mean nothing, or two things."""
    return [
        Case(
            "unknown_platform",
            "target on an unknown platform",
            script(("$TARGET Car", "$TARGET @Cra")),
            message=["no platform has this name; found 'Cra'", "Did you mean Car"],
        ),
        Case(
            "radar_unknown_platform",
            "radar on an unknown platform",
            script(("Radar1 Ground", "Radar1 @Sky")),
            message=["no platform has this name; found 'Sky'"],
        ),
        Case(
            "unknown_radar",
            "recording by an unknown radar",
            script(("$SIMULATION Radar1", "$SIMULATION @Rader1")),
            message=["no radar has this name; found 'Rader1'", "Did you mean Radar1"],
        ),
        Case(
            "geometry_unknown_radar",
            "geometry table of an unknown radar",
            {SCRIPT: SCENE + "$GEOMETRY @Lidar 0 1 0 0.01 SPACE 1 t.txt\n"},
            message=["no radar has this name"],
        ),
        Case(
            "ambiguous_name",
            "beginning of two names",
            script(
                (
                    "$TARGET Car",
                    "$PLATFORM Cargo STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n$TARGET @Ca",
                ),
            ),
            message=["several platforms begin", "Car, Cargo"],
        ),
        Case(
            "duplicate_platform",
            "two platforms of one name",
            script(("$PLATFORM Car", "$PLATFORM @Ground"), ("$TARGET Car\n0 0 0", "$TARGET Ground\n1000 0 0")),
            status=0,
            severity="warning",
            message=["means the first"],
            makes=["sim.bin"],
        ),
        Case(
            "duplicate_platform_strict",
            "two platforms of one name, --strict",
            script(("$PLATFORM Car", "$PLATFORM @Ground"), ("$TARGET Car\n0 0 0", "$TARGET Ground\n1000 0 0")),
            ("run", SCRIPT, "--strict"),
            severity="warning",
            message=["means the first"],
            shown="sarsim run scene.scr --strict",
        ),
        Case(
            "duplicate_radar",
            "two radars of one name, --strict",
            script(
                (
                    "$SIMULATION",
                    (
                        "$RADAR @Radar1 Ground MONO 1000 RECT CONSTANT 1000 SINGLE 1 100 0 300\n"
                        "ISOTROPIC SAME FIXED 0 0 RECT NO_STC\n"
                        "$SIMULATION"
                    ),
                ),
            ),
            ("run", SCRIPT, "--strict"),
            severity="warning",
            message=["means the first"],
            shown="sarsim run scene.scr --strict",
        ),
        Case(
            "duplicate_output",
            "two recordings of one name, --strict",
            {SCRIPT: SCENE + "$SIMULATION Radar1 900 1400 0 0.019 8 0.1 0 BINARY RAW @sim.bin BEGIN 1 1\n"},
            ("run", SCRIPT, "--strict"),
            severity="warning",
            message=["sim-2.bin"],
            shown="sarsim run scene.scr --strict",
        ),
    ]


def data_file_cases():
    """Data files of user-defined functions."""
    def case(name, wrong, content, message, **more):
        return Case(name, wrong, with_data_file("@gain.dat", **{"gain.dat": content}), message=[message], **more)

    return [
        Case(
            "missing_data_file",
            "data file that does not exist",
            with_data_file("@gain.dat"),
            message=["data file not found; looked for gain.dat"],
        ),
        Case(
            "script_as_data_file",
            "script that names itself as data file",
            with_data_file("@" + SCRIPT),
            message=["data file not found|a script, not a data file"],
        ),
        Case(
            "other_script_as_data_file",
            "another script as data file",
            with_data_file("@other.scr", **{"other.scr": SCENE}),
            message=["a script, not a data file"],
        ),
        Case(
            "folder_as_data_file",
            "folder in place of a data file",
            with_data_file("@gain.dat", **{"gain.dat/x": ""}),
            message=["is a folder"],
        ),
        Case(
            "data_file_device",
            "endless device as data file",
            with_data_file("@/dev/zero"),
            message=["is not a file"],
        ),
        case("binary_data_file", "binary data file", b"\x89PNG\r\n\x1a\n\0\0\0", "gain.dat:2:1: not a text file"),
        case("empty_data_file", "empty data file", "", "holds no numbers"),
        case(
            "truncated_data_file",
            "data file that ends early",
            "3\n0 0\n45 -3\n90",
            "3 points were announced .*end after 2",
        ),
        case(
            "huge_count",
            "data file that announces 1e18 points",
            "1e18\n0 0\n90 -3\n",
            "points were announced .*end after 2|is out of range|too large",
        ),
        case("overflowing_count", "data file that announces 1e30 points", "1e30\n0 0\n", "number of points"),
        case(
            "broken_count",
            "number of points that is not whole",
            "2.5\n0 0\n90 -3\n",
            "not a whole number; found '2.5'",
        ),
        case("zero_count", "data file of no points", "0\n", "too small; found '0'"),
        case("negative_count", "negative number of points", "-2\n0 0\n90 -3\n", "too small; found '-2'"),
        case(
            "text_in_data_file",
            "text among the numbers of a data file",
            "2\n0 zero\n90 -3\n",
            "not a number; found 'zero'",
        ),
        case("nan_in_data_file", "NaN in a data file", "2\n0 nan\n90 -3\n", "not a number; found 'nan'"),
        case(
            "descending_data",
            "data file whose x does not ascend",
            "3\n0 0\n90 -3\n45 -1\n",
            "must ascend; found '45'",
        ),
        case("repeated_x", "data file with the same x twice", "3\n0 0\n45 -3\n45 -1\n", "must ascend; found '45'"),
        Case(
            "data_file_too_short",
            "data file with one function of three",
            script(
                (
                    "TRAJECTORY LINEAR LINEAR LINEAR INLINE\n2 0, 0 1, 20\n1 0, 1000\n1 0, 0\n",
                    "TRAJECTORY LINEAR LINEAR LINEAR FILE @path.dat\n",
                ),
                **{"path.dat": "2 0 0 1 20\n"},
            ),
            message=["2 of 3 functions"],
        ),
        Case(
            "huge_inline_count",
            "INLINE data that announce 1e18 points",
            script(
                ("2 0, 0 1, 20\n1 0, 1000\n1 0, 0\n", "1000000000000000000 0, 0 1, 20\n1 0, 1000\n1 0, 0\n"),
                ("NOT_ALIGNED", "@NOT_ALIGNED"),
            ),
            message=["1000000000000000000 points were announced"],
        ),
        Case(
            "short_inline",
            "INLINE data with a point too few",
            script(
                ("2 0, 0 1, 20\n1 0, 1000\n1 0, 0\n", "2 0, 0 1, 20\n1 0, 1000\n1 0\n"),
                ("NOT_ALIGNED", "@NOT_ALIGNED"),
            ),
            message=["end after 0"],
        ),
        Case(
            "no_interpolation",
            "interpolation that does not exist",
            script(("LINEAR LINEAR LINEAR", "LINEAR @SPLINE LINEAR")),
            message=["CUBIC, MFILTER or LINEAR"],
        ),
    ]


GROUPS = {
    "files": file_cases,
    "truncated": truncated,
    "words": word_cases,
    "names": name_cases,
    "data": data_file_cases,
}
