#!/usr/bin/env python3
"""Scripts, files and arguments that ask for more than any machine has, and names that want more than to be read.

    hostile_test.py [CASE...]

Each is refused with a status and a message, soon, in little memory, and nothing but the named outputs is written. What
tests/bad_input tries is not tried again. The program is SARSIM_PROGRAM or SARSIM_BUILT_PROGRAM of the environment.
"""

import dataclasses
import os
import pathlib
import resource
import struct
import subprocess
import sys
import tempfile
import time
import typing

TIME_LIMIT_S = 60  # Far more than it takes, for machines that are busy.
ADDRESS_SPACE = 4 << 30
MOST_RESIDENT = 600 << 20

EARTH = "$PLATFORM Earth STATIONARY 0 0 0 CONST 0 0 0 0 0 0 STDDEV 0 0 0 STDDEV 0 0 0\n"
TARGET = "$TARGET Earth 0 1000 0 0 0 0 1 0 ISOTROPIC\n"
RADAR = "$RADAR R Earth {pulse} RECT CONSTANT 1000 {carrier} 100 0 0 ISOTROPIC SAME FIXED 0 0 RECT NO_STC\n"
SIMULATION = "$SIMULATION R 900 1400 0 0.0095 8 0.1 1e-6 BINARY RAW {file} BEGIN {factors}\n"


def scene(pulse="CHIRP 0.05 1000", carrier="SINGLE 1", file="sim.bin", factors="1 1", more=""):
    return EARTH + TARGET + RADAR.format(pulse=pulse, carrier=carrier) + SIMULATION.format(file=file, factors=factors) + more


def gain_file(name):
    return scene(more=f'$TARGET Earth 0 1000 0 0 0 0 1 0 DIRECTIONAL 0 0 0 0 OTHER_GAIN LINEAR FILE "{name}"\n')


def envi(samples, lines, offset=0):
    return f"ENVI\nsamples = {samples}\nlines = {lines}\nbands = 1\nheader offset = {offset}\ndata type = 6\nbyte order = 0\n"


def npy(shape):
    header = f"{{'descr': '<c8', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode()


def sun(width, height):
    return struct.pack(">8I", 0x59A66A95, width, height, 8, 0xFFFFFFFF, 1, 0, 0)


@dataclasses.dataclass
class Case:
    name: str
    command: typing.Sequence[str]
    files: dict[str, str | bytes] = dataclasses.field(default_factory=dict)
    prepare: typing.Callable[[pathlib.Path], None] | None = None
    ends_well: bool = False  # It is harmless as it is meant.
    makes: typing.Sequence[str] = ()


BIG_SURFACE = "$SURFACE Earth 1000 -3000 0 1000 3000 0 1000 0 6000\n"
STEPPED = scene(carrier="STEPPED 3 0.005 8 1")


def memory_cases():
    yield Case("surfaces_together", ("run", "s.scr"), {"s.scr": scene(more=BIG_SURFACE * 200)})
    yield Case(
        "own_band_of_a_long_pulse",
        ("run", "s.scr"),
        {"s.scr": scene("CHIRP 0.000001 90000000", factors="2 1", more="$OPTIONS PULSE BAND_LIMITED\n")},
    )
    for name, values in (("seeds", "seed=1..1000000000000000000"), ("steps", "Target1.x=0:1e-300:1")):
        yield Case(f"sweep_{name}", ("sweep", "s.scr", "--set", values, "--dry-run"), {"s.scr": scene()})
    combined = ("--set", "seed=1..4000000000", "--set", "R.power=1:1:4000000000")
    yield Case("sweep_combinations", ("sweep", "s.scr", *combined, "--dry-run"), {"s.scr": scene()})
    yield Case("ppi_of_tiny_pixels", ("search", "s.scr", "--pixel", "1e-9"), {"s.scr": scene()})
    yield Case("ppi_of_all_the_world", ("search", "s.scr", "--extent", "1e18", "--pixel", "1"), {"s.scr": scene()})
    yield Case("profiles_of_many_bins", ("profiles", "s.scr", "--oversampling", "1000000000"), {"s.scr": STEPPED})
    yield Case("isar_of_a_continent", ("isar", "s.scr", "--cross-range", "1e12", "--range", "1e12"), {"s.scr": STEPPED})
    yield Case("doppler_of_many_rows", ("doppler", "s.scr", "--frequencies", "1000000000000"), {"s.scr": scene()})
    yield Case("plot_of_many_bins", ("plot", "s.scr", "--csv", "a.csv", "--kind", "doppler", "--padding", "1000000000"), {"s.scr": scene()})


def file_cases():
    yield Case("npy_of_2_31_squared", ("info", "a.npy"), {"a.npy": npy("(2147483648, 2147483648)") + bytes(64)})
    yield Case("npy_of_no_columns", ("info", "a.npy"), {"a.npy": npy("(9223372036854775807, 0)")})
    for samples, lines, offset in ((2**31, 2**31, 0), (2**62, 8, 0), (4, 4, 2**63 - 1), (0, 0, 0)):
        files = {"a.img": bytes(64), "a.hdr": envi(samples, lines, offset), "s.scr": scene()}
        yield Case(f"envi_{samples}_{lines}_{offset}", ("measure", "a.img", "--script", "s.scr"), files)
        yield Case(f"envi_plot_{samples}_{lines}_{offset}", ("plot", "a.img", "--csv", "a.csv", "--kind", "pulse"), files)
    yield Case("sun_raster_of_2_31_squared", ("plot", "a.ras", "--csv", "a.csv"), {"a.ras": sun(2**31, 2**31) + bytes(64)})
    yield Case("rows_as_long_as_the_world", ("info", "a.bin", "--columns", "1099511627776", "--bits", "8"), {"a.bin": bytes(4096)})
    journal = {"sim.bin.parts/part-1-of-1.journal": "sarsim journal 1 #0\nrows 0 4611686018427387904 at 0 bytes 1\n"}
    yield Case("journal_of_2_62_rows", ("merge", "sim.bin.parts"), journal)


def make_fifo(folder):
    os.mkfifo(folder / "gain.dat")


def make_loop(folder):
    (folder / "gain.dat").symlink_to("gain.dat")


def name_cases():
    yield Case("data_from_a_fifo", ("run", "s.scr"), {"s.scr": gain_file("gain.dat")}, make_fifo)
    yield Case("data_from_a_loop", ("run", "s.scr"), {"s.scr": gain_file("gain.dat")}, make_loop)
    for number, name in enumerate(("|touch hacked", "$(touch hacked)", "`touch hacked`", "; touch hacked", "file:///etc/passwd", "~root")):
        yield Case(f"data_from_a_command_{number}", ("run", "s.scr"), {"s.scr": gain_file(name)})
    yield Case("samples_from_a_fifo", ("info", "gain.dat"), {}, make_fifo)
    outputs = {"../../escaped.bin": "escaped.bin", "/escaped.bin": "escaped.bin", "$(touch hacked).bin": "$(touch hacked).bin", "-rf": "-rf"}
    for number, (name, made) in enumerate(outputs.items()):
        yield Case(f"output_{number}", ("run", "s.scr"), {"s.scr": scene(file=f'"{name}"')}, ends_well=True, makes=(made,))
    yield Case("output_without_a_name", ("run", "s.scr"), {"s.scr": scene(file="..")})
    yield Case("output_of_300_letters", ("run", "s.scr"), {"s.scr": scene(file="x" * 300)})


def all_cases():
    return [*memory_cases(), *file_cases(), *name_cases()]


def program():
    return os.path.abspath(os.environ.get("SARSIM_PROGRAM") or os.environ["SARSIM_BUILT_PROGRAM"])


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (ADDRESS_SPACE, ADDRESS_SPACE))


def run(case, folder):
    """Status (None where it did not end), standard error, and the largest resident memory."""
    preexec = None if os.environ.get("SARSIM_SANITIZED") else limit_memory
    with tempfile.TemporaryFile() as err:
        process = subprocess.Popen(
            [program(), *case.command], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=err, preexec_fn=preexec
        )
        end = time.monotonic() + TIME_LIMIT_S
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() > end:
                process.kill()
                os.wait4(process.pid, 0)
                return None, "", 0
            time.sleep(0.005)
        process.returncode = os.waitstatus_to_exitcode(status)
        err.seek(0)
        return process.returncode, err.read().decode(errors="replace"), usage.ru_maxrss << 10


def faults_of(case, above):
    """What is wrong with how a case ends; it runs three folders below one that is watched."""
    folder = above / "a" / "b" / "c"
    folder.mkdir(parents=True)
    for name, content in case.files.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    if case.prepare:
        case.prepare(folder)
    before = {str(path) for path in above.rglob("*")}
    status, err, resident = run(case, folder)
    new = {str(path) for path in above.rglob("*")} - before - {str(folder / name) for name in case.makes}
    found = [f"{name} was made" for name in sorted(new)]
    if pathlib.Path("/escaped.bin").exists():
        found.append("/escaped.bin was made")
    found += [f"{name} was not made" for name in case.makes if not (folder / name).exists()]
    if status is None:
        return [*found, f"did not end within {TIME_LIMIT_S} s"]
    if case.ends_well != (status == 0):
        found.append(f"status {status}: {err[-300:]!r}")
    if not case.ends_well and (status not in (1, 2) or "error" not in err):
        found.append(f"status {status} with the message {err[-300:]!r}")
    if "not enough memory" in err or resident > MOST_RESIDENT and not os.environ.get("SARSIM_SANITIZED"):
        found.append(f"took {resident >> 20} MB: {err[-200:]!r}")
    return found


def main():
    told, most = 0, 0
    cases = [case for case in all_cases() if not sys.argv[1:] or case.name in sys.argv[1:]]
    for case in cases:
        with tempfile.TemporaryDirectory(prefix="sarsim-hostile-") as above:
            begin = time.monotonic()
            found = faults_of(case, pathlib.Path(above))
        most = max(most, time.monotonic() - begin)
        for text in found:
            told += 1
            print(f"{case.name}: {text}", flush=True)
    print(f"{len(cases)} cases, {told} failures, the longest took {most:.1f} s")
    sys.exit(1 if told else 0)


if __name__ == "__main__":
    main()
