"""Command lines, outputs and disks that cannot be used, and files of samples that cannot be read."""

from base import SCENE, script
from harness import SCRIPT, Case

NOBODY = 65534


def command_cases():
    """The command line."""
    def case(name, wrong, command, *message, **more):
        return Case(name, wrong, script(), command, message=message, shown="sarsim " + " ".join(command), **more)

    return [
        case(
            "unknown_command_word",
            "command that does not exist",
            ("rnu", SCRIPT),
            "unknown command 'rnu'",
            "did you mean 'run'",
        ),
        case(
            "unknown_option",
            "option that does not exist",
            ("run", SCRIPT, "--ouy", "x"),
            "unknown option '--ouy'",
            "did you mean '--out'",
        ),
        case("missing_scene", "no script", ("run",), "(SCENE|scene).*required", "--help"),
        case("missing_value", "option without its value", ("run", SCRIPT, "--out"), "--out", "--help"),
        case("value_no_number", "text for a number", ("run", SCRIPT, "--threads", "many"), "--threads", "--help"),
        case("value_with_tail", "number with a tail", ("run", SCRIPT, "--threads", "5x"), "--threads", "--help"),
        case("too_many_threads", "number out of range", ("run", SCRIPT, "--threads", "5000"), "--threads", "--help"),
        case(
            "negative_threads",
            "negative number of threads",
            ("run", SCRIPT, "--threads", "-1"),
            "--threads",
            "--help",
        ),
        case("negative_seed", "negative seed", ("run", SCRIPT, "--seed", "-1"), "--seed", "--help"),
        case(
            "too_large_seed",
            "seed beyond 64 bits",
            ("run", SCRIPT, "--seed", "18446744073709551616"),
            "--seed",
            "18446744073709551615",
        ),
        case(
            "pulses_beyond",
            "pulses behind the last one",
            ("run", SCRIPT, "--pulses", "21:"),
            "no recording has as many pulses",
            "1 to 20",
        ),
        case("plot_no_span", "no decibels to show", ("plot", SCRIPT, "--csv", "x.csv", "--span", "0"), "above 0"),
        case(
            "plot_too_large",
            "picture that is too large",
            ("plot", SCRIPT, "-o", "x.png", "--size", "20000", "20000", "--scale", "16"),
            "--size and --scale",
            "too large",
        ),
        case("nan_tolerance", "tolerance that is not a number", ("run", SCRIPT, "--tolerance", "nan"), "tolerance"),
        case("zero_tolerance", "tolerance 0", ("run", SCRIPT, "--tolerance", "0"), "tolerance is out of range"),
        case(
            "unknown_format_word",
            "format that does not exist",
            ("run", SCRIPT, "--format", "matlab"),
            "--format",
            "hdf5",
        ),
        case(
            "unknown_profile_word",
            "profile that does not exist",
            ("run", SCRIPT, "--profile", "modern"),
            "--profile",
            "classic",
        ),
        case("unknown_product_number", "recording 2 of 1", ("run", SCRIPT, "2"), "2"),
        case("zeroth_product", "recording 0", ("run", SCRIPT, "0"), "0"),
        case("unknown_product_name", "product that does not exist", ("run", SCRIPT, "sin.bin"), "sin.bin", r"sim\.bin"),
        case("two_scripts", "two scripts", ("run", SCRIPT, "other.scr"), "other.scr"),
        case("unknown_shell", "shell that does not exist", ("completion", "tcsh"), "tcsh"),
        case(
            "geometry_unknown_radar_option",
            "radar that does not exist",
            ("geometry", SCRIPT, "--radar", "Lidar", "--start", "0", "--end", "1"),
            "no radar 'Lidar'",
        ),
        case(
            "geometry_infinite_end",
            "infinite time",
            ("geometry", SCRIPT, "--radar", "Radar1", "--start", "0", "--end", "inf"),
            "--end|end",
        ),
        case(
            "geometry_reversed",
            "times exchanged",
            ("geometry", SCRIPT, "--radar", "Radar1", "--start", "1", "--end", "0"),
            "end",
        ),
        case(
            "geometry_no_pulse",
            "times between two pulses",
            ("geometry", SCRIPT, "--radar", "Radar1", "--start", "0.0001", "--end", "0.0002"),
            "no pulse is sent",
        ),
    ]


def output_cases():
    """Where the output is to go."""
    old = {"sim.bin": "the result of another day"}

    def blocked_parent(folder):
        (folder / "file").write_text("in the way")

    def locked(folder):
        (folder / "locked").mkdir()
        (folder / "locked").chmod(0o555)

    return [
        Case(
            "existing_output",
            "output that exists",
            script(**old),
            message=[r"exists already; found 'sim\.bin'", "--force"],
        ),
        Case(
            "output_is_folder",
            "output whose name belongs to a folder",
            script(**{"sim.bin/kept": "x"}),
            message=["belongs to a folder"],
        ),
        Case(
            "output_is_folder_force",
            "the same with --force",
            script(**{"sim.bin/kept": "x"}),
            ("run", SCRIPT, "--force"),
            message=["belongs to a folder"],
            shown="sarsim run scene.scr --force",
        ),
        Case(
            "output_is_script",
            "output that would replace its script",
            script(("RAW sim.bin", "RAW scene.scr")),
            ("run", SCRIPT, "--force"),
            message=["would replace the file"],
            shown="sarsim run scene.scr --force",
        ),
        Case(
            "output_leads_out",
            "output above the folder of the run",
            script(("RAW sim.bin", "RAW @../sim.bin")),
            ("run", SCRIPT, "--keep-paths"),
            message=["leads out of the folder"],
            shown="sarsim run scene.scr --keep-paths",
        ),
        Case(
            "output_absolute",
            "output with an absolute name",
            script(("RAW sim.bin", "RAW @/tmp/sim.bin")),
            ("run", SCRIPT, "--keep-paths"),
            message=["leads out of the folder"],
            shown="sarsim run scene.scr --keep-paths",
        ),
        Case(
            "table_over_script",
            "table in place of the script",
            script(),
            ("geometry", SCRIPT, "--radar", "Radar1", "--start", "0", "--end", "0", "-o", SCRIPT, "--force"),
            message=["would replace the file"],
            shown="sarsim geometry scene.scr ... -o scene.scr --force",
        ),
        Case(
            "table_over_script_of_data",
            "detections in place of the script of the data",
            {**script(), "sim.bin": b"\0" * (20 * 334 * 2)},
            ("doppler", "sim.bin", "--script", SCRIPT, "--detections", SCRIPT, "--force"),
            message=["would replace the file"],
            shown="sarsim doppler sim.bin --script scene.scr --detections scene.scr --force",
        ),
        Case(
            "picture_in_no_folder",
            "picture in a folder that does not exist",
            script(),
            ("plot", SCRIPT, "-o", "nowhere/x.png"),
            message=["there is no folder 'nowhere'"],
            shown="sarsim plot scene.scr -o nowhere/x.png",
        ),
        Case(
            "folder_is_file",
            "output folder that is a file",
            script(),
            ("run", SCRIPT, "--out", "file"),
            prepare=blocked_parent,
            message=["'file' is not a folder"],
            shown="sarsim run scene.scr --out file",
        ),
        Case(
            "folder_below_file",
            "output folder below a file",
            script(),
            ("run", SCRIPT, "--out", "file/below"),
            prepare=blocked_parent,
            status=1,
            severity="",
            message=["sarsim: error: .*file/below"],
            shown="sarsim run scene.scr --out file/below",
        ),
        Case(
            "folder_locked",
            "output folder without permission to write",
            script(),
            ("run", SCRIPT, "--out", "locked"),
            prepare=locked,
            status=1,
            user=NOBODY,
            severity="",
            message=["sarsim: error: cannot create locked/sim.bin.*ermission"],
            shown="sarsim run scene.scr --out locked",
        ),
        Case(
            "folder_in_proc",
            "output folder where no files can be",
            script(),
            ("run", SCRIPT, "--out", "/proc/self"),
            status=1,
            severity="",
            message=["sarsim: error: .*/proc/self"],
            shown="sarsim run scene.scr --out /proc/self",
        ),
        Case(
            "disk_too_small",
            "disk too small for a recording",
            script(("0 0.019", "0 2e6")),
            status=1,
            severity="",
            message=["sarsim: error: the disk of '.' has not enough room: .* are needed, .* are free"],
        ),
        Case(
            "format_over_itself",
            "rewritten script over its original",
            script(),
            ("format", SCRIPT, "-o", SCRIPT),
            message=["would replace|exists already"],
            shown="sarsim format scene.scr -o scene.scr",
        ),
        Case(
            "geometry_existing",
            "geometry table onto a file that exists",
            script(**{"t.txt": "kept"}),
            ("geometry", SCRIPT, "--radar", "Radar1", "--start", "0", "--end", "1", "-o", "t.txt"),
            message=["exists already", "--force"],
            shown="sarsim geometry scene.scr ... -o t.txt",
        ),
        Case(
            "format_of_errors",
            "rewriting a script with errors in place",
            script(("CHIRP", "@CHRIP")),
            ("format", SCRIPT, "--in-place"),
            message=["did you mean CHIRP"],
            shown="sarsim format scene.scr --in-place",
        ),
    ]


def disk_cases():
    """Disks that fill up while something is written; also files that may not grow, where no disk can be made."""
    table = SCENE[: SCENE.index("$SIM")] + "$GEOMETRY Radar1 0 2000 0 20 SPACE 255 t.txt\n"
    cases = []
    for word, option, output, text in (
        ("BINARY", "", "sim.bin", None),
        ("ASCII", " --format ascii", "sim.asc", None),
        ("NPY", " --format npy", "sim.npy", None),
        ("HDF5", " --format hdf5", "sim.h5", None),
        ("a geometry table", "", "t.txt", table),
    ):
        files = {SCRIPT: text} if text else script(("0 0.019", "0 5"))
        cases.append(
            Case(
                f"full_disk_{output}",
                f"file that may not grow while {word} is written",
                {**files, output: "earlier"},
                shell="ulimit -f 200; exec {sarsim} run scene.scr --force" + option,
                status=1,
                severity="",
                message=[rf"sarsim: error: cannot (write|complete|set).*{output}"],
                shown="sarsim run scene.scr --force" + option,
            )
        )
    return cases + device_cases() + small_disk_cases(table)


def device_cases():
    """Outputs that take nothing."""
    read_by_nobody = "{sarsim} geometry scene.scr --radar Radar1 --start 0 --end 100"
    return [
        Case(
            "full_device",
            "full device",
            script(),
            ("format", SCRIPT, "-o", "/dev/full", "--force"),
            status=1,
            severity="",
            message=["sarsim: error: cannot write /dev/full: No space left"],
            shown="sarsim format scene.scr -o /dev/full --force",
        ),
        Case(
            "full_standard_output",
            "full standard output",
            script(),
            shell="{sarsim} format scene.scr > /dev/full",
            status=1,
            severity="",
            message=["sarsim: error: cannot write to standard output: No space left"],
            shown="sarsim format scene.scr > /dev/full",
        ),
        Case(
            "reader_gone",
            "standard output whose reader has gone",
            script(),
            shell="{ " + read_by_nobody + "; echo $? >&3; } 3>&2 | head -n 0",
            status=0,  # Of head; the program's own is the only thing that is printed.
            severity="",
            hint=False,
            message=[r"^1\n$"],
            shown="sarsim geometry scene.scr ... | head -n 0",
        ),
    ]


def small_disk_cases(table):
    """Small disks made for the purpose, in a name space of their own."""

    def on_disk(options, before, after):
        mount = f"mkdir disk && mount -t tmpfs -o {options} none disk && {before}"
        command = "{sarsim} run scene.scr --force --out disk; status=$?"
        return f"exec unshare -rm sh -c '{mount} {command}; {after} umount disk; rmdir disk; exit $status'"

    return [
        Case(
            "full_tmpfs",
            "disk that fills while a geometry table is written",
            {SCRIPT: table},
            shell=on_disk("size=200k", "echo earlier > disk/t.txt;", "ls -A disk >&2; cat disk/t.txt >&2;"),
            mounts=True,
            status=1,
            severity="",
            message=[r"cannot write disk/t\.txt: No space left.*\nt\.txt\nearlier\n$"],
            shown="sarsim run scene.scr --force --out disk",
        ),
        Case(
            "read_only_disk",
            "disk that may only be read",
            script(),
            shell=on_disk("ro", "", ""),
            mounts=True,
            status=1,
            severity="",
            message=["Read-only file system"],
            shown="sarsim run scene.scr --force --out disk",
        ),
    ]


def sample_cases():
    """Files of samples for info and convert."""
    hdf5 = b"\x89HDF\r\n\x1a\n" + b"\0" * 40
    header = b"{'descr': '<c8', 'fortran_order': False, 'shape': (1000, 1000), }"
    npy = b"\x93NUMPY\x01\x00\x76\x00" + header.ljust(117) + b"\n"
    huge = npy.replace(b"(1000, 1000), }" + b" " * 30, b"(1000000000000, 1000000000000), }".ljust(45))
    def info(name, wrong, file, content, *message, options=(), **more):
        return Case(
            name,
            wrong,
            {file: content},
            ("info", file, *options),
            message=message,
            shown=" ".join(["sarsim info", file, *options]),
            **more,
        )

    return [
        Case(
            "info_missing",
            "file of samples that does not exist",
            {},
            ("info", "sim.h5"),
            message=[r"sim\.h5", "no such file|No such file"],
            shown="sarsim info sim.h5",
        ),
        Case(
            "info_folder",
            "folder in place of a file of samples",
            {"sim.h5/x": ""},
            ("info", "sim.h5"),
            message=["folder"],
            shown="sarsim info sim.h5",
        ),
        info("info_empty", "empty file of samples", "sim.bin", b"", r"sim\.bin", "empty|no samples|holds"),
        info("info_truncated_hdf5", "truncated HDF5", "sim.h5", hdf5, r"sim\.h5"),
        info("info_false_hdf5", "text called .h5", "sim.h5", b"12 -7\n", r"sim\.h5"),
        info("info_truncated_npy", "truncated NPY", "sim.npy", npy + b"\0" * 100, r"sim\.npy"),
        info("info_npy_header", "NPY that ends in its header", "sim.npy", npy[:40], r"sim\.npy"),
        info("info_npy_huge", "NPY that announces 1e24 samples", "sim.npy", huge, r"sim\.npy"),
        info("info_npy_python", "NPY of Python objects", "sim.npy", npy.replace(b"<c8", b"|O8"), r"sim\.npy"),
        info(
            "info_binary_shape",
            "BINARY that is no whole number of rows",
            "sim.bin",
            b"\1\2\3\4\5",
            r"sim\.bin",
            options=("--columns", "2", "--bits", "8"),
        ),
        info("info_ascii_text", "ASCII with a word in it", "sim.asc", b"1 2\n3 four\n", r"sim\.asc:2", anywhere=False),
        info(
            "info_ascii_short",
            "ASCII whose rows differ in length",
            "sim.asc",
            b"1 2\n3 4\n\n5 6\n\n7 8\n9 1\n",
            r"sim\.asc",
        ),
        info("info_ascii_half", "ASCII that ends within a sample", "sim.asc", b"1 2\n3 4\n5", r"sim\.asc"),
        info(
            "info_no_shape",
            "BINARY whose shape nobody says",
            "sim.bin",
            b"\1\2\3\4",
            r"sim\.bin",
            "samples of a row",
        ),
        info(
            "info_zero_columns",
            "0 samples of a row",
            "sim.bin",
            b"\1\2\3\4",
            "--columns",
            options=("--columns", "0", "--bits", "8"),
        ),
        Case(
            "convert_truncated",
            "conversion of truncated NPY",
            {"sim.npy": npy + b"\0" * 100},
            ("convert", "sim.npy", "sim.csv"),
            message=[r"sim\.npy"],
            shown="sarsim convert sim.npy sim.csv",
        ),
        Case(
            "convert_unknown",
            "conversion into an unknown format",
            {"sim.asc": "1 2\n"},
            ("convert", "sim.asc", "sim.xyz"),
            message=["names no format", "--to"],
            shown="sarsim convert sim.asc sim.xyz",
        ),
        Case(
            "convert_onto_itself",
            "conversion of a file onto itself",
            {"sim.asc": "1 2\n"},
            ("convert", "sim.asc", "sim.asc", "--force"),
            message=["would replace the file"],
            shown="sarsim convert sim.asc sim.asc --force",
        ),
        Case(
            "convert_existing",
            "conversion onto a file that exists",
            {"sim.asc": "1 2\n", "sim.csv": "kept"},
            ("convert", "sim.asc", "sim.csv", "--bits", "8"),
            message=["exists already", "--force"],
            shown="sarsim convert sim.asc sim.csv --bits 8",
        ),
        Case(
            "convert_broken_late",
            "conversion of ASCII that is wrong in its last line",
            {"sim.asc": "1 2\n" * 100000 + "3 x\n"},
            ("convert", "sim.asc", "sim.csv"),
            message=[r"sim\.asc:100001"],
            shown="sarsim convert sim.asc sim.csv",
        ),
    ]


GROUPS = {"commands": command_cases, "outputs": output_cases, "disks": disk_cases, "samples": sample_cases}
