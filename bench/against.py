"""Compares two builds of sarsim command by command: which commands became slower.

Each workload is a whole command on one thread, run by both builds alternately (A B, B A, A B, ...). Measured is the processor
time of the child, user and system; wall time is not used. Prints the medians of both builds, the median of the ratios
now/before of the pairs, and the spread of that median: 1.253 times the standard error from the quartiles of the ratios (the
standard error of a median of normal values). A workload is slower if its ratio exceeds both its limit and 1 plus three times
its spread.
"""

import json
import os
import pathlib
import statistics
import subprocess

import workloads

LIMIT = 1.03
FOCUS_LIMIT = 1.05
PAIRS = 9
# Repeats of a short command within one timed process, so that a figure has at least this many seconds.
MIN_SECONDS = 0.1

# Starts a command some times and prints the processor seconds of all; small, so that it adds nothing of its own.
TIMER = """
import os, sys
repeats, seconds = int(sys.argv[1]), 0.0
null = os.open(os.devnull, os.O_RDWR)
for _ in range(repeats):
    pid = os.posix_spawn(sys.argv[2], sys.argv[2:], os.environ,
                         file_actions=[(os.POSIX_SPAWN_DUP2, null, fd) for fd in (0, 1, 2)])
    _, status, usage = os.wait4(pid, 0)
    seconds += usage.ru_utime + usage.ru_stime
    if os.waitstatus_to_exitcode(status) != 0:
        sys.exit(1)
print(seconds)
"""


def program_of(build):
    """The program of a build folder, of a folder that contains the program, or the program itself."""
    path = pathlib.Path(build).resolve()
    for candidate in (path / "src/sarsim", path / "sarsim", path):
        if candidate.is_file() and os.access(candidate, os.X_OK):
            return candidate
    raise SystemExit(f"bench/run: --against takes a build folder or a program; '{build}' contains no src/sarsim that can be started")


def processor_seconds(program, words, repeats):
    out = subprocess.run(["python3", "-S", "-c", TIMER, str(repeats), str(program), *map(str, words)], capture_output=True, text=True)
    if out.returncode != 0:
        raise RuntimeError(f"{program} {' '.join(map(str, words))} failed")
    return float(out.stdout) / repeats


def spread_of(ratios):
    """Standard error of the median of `ratios`, from their quartiles."""
    lower, _, upper = statistics.quantiles(ratios, n=4)
    return 1.253 * (upper - lower) / 1.349 / len(ratios) ** 0.5


def compare(before, now, words, pairs):
    """Medians of the processor seconds of both programs, the median ratio and its spread."""
    first = max(processor_seconds(program, words, 1) for program in (before, now))  # A warm-up as well.
    repeats = max(1, round(MIN_SECONDS / max(first, 1e-4)))
    figures = {before: [], now: []}
    for pair in range(pairs):
        for program in (before, now) if pair % 2 == 0 else (now, before):
            figures[program].append(processor_seconds(program, words, repeats))
    ratios = [b / a for a, b in zip(figures[before], figures[now])]
    return {"before_s": statistics.median(figures[before]), "now_s": statistics.median(figures[now]),
            "ratio": statistics.median(ratios), "spread": spread_of(ratios)}


def is_slower(row):
    return row["ratio"] > row["limit"] and row["ratio"] > 1.0 + 3.0 * row["spread"]


def run_words(script):
    return ["run", script, "--discard", "--quiet", "--threads", "1"]


def write(folder, name, text):
    path = os.path.join(folder, name)
    pathlib.Path(path).write_text(text, encoding="ascii")
    return path


def echo_commands(folder):
    """Recordings of the fixed workloads, in all variants that the engine treats differently."""
    pulses = {"one": 1000, "field": 200, "scene": 40, "long": 60, "million": 2, "moving": 200}
    commands = {}
    for name, (workload, changes) in workloads.FORECASTS.items():
        if name == "long, few targets":
            changes = {**changes, "pulses": 400}
        text = workloads.script(workload, **{"pulses": pulses[workload], **changes})
        commands[f"run {name}"] = run_words(write(folder, f"{name.replace(' ', '_')}.scr", text))
    for options in ("", "PULSE BAND_LIMITED"):
        text = workloads.spot_script(20_000, 40, options)
        commands["run spot" + " band-limited" * bool(options)] = run_words(write(folder, f"spot{len(options)}.scr", text))
    return commands


def focus_commands(folder, program):
    """Images by each algorithm of a recording of 1024 x 2048 samples."""
    script = write(folder, "focus.scr", workloads.focus_script("HDF5", "focus.h5", 1024, 2048))
    subprocess.run([program, "run", script, "--out", folder, "--force", "--quiet"], check=True, stderr=subprocess.DEVNULL)
    recording, image = os.path.join(folder, "focus.h5"), os.path.join(folder, "image.img")
    return {f"focus {algorithm}": ["focus", recording, "--out", image, "--force", "--quiet", "--threads", "1", "--algorithm", algorithm]
            for algorithm in (*workloads.FOCUS_SIZES, "back-projection")}


def example_commands(folder, program, examples):
    """Typical commands on the examples: check, info, run, focus, measure, maps, plots, conversions."""
    recordings = {}
    for example in ("sar_r", "mti", "search_radar", "stepped_aircraft", "turning_ship", "spotlight"):
        out = os.path.join(folder, example)
        subprocess.run([program, "run", examples / f"{example}.toml", "--out", out, "--force", "--quiet", "--format", "hdf5"], check=True,
                       stderr=subprocess.DEVNULL)
        recordings[example] = sorted(pathlib.Path(out).glob("*.h5"))
    commands = {}
    for example in ("sar_r", "gusts", "satellite", "search_radar", "user_functions", "ship_in_waves", "helicopter", "surface"):
        commands[f"check {example}"] = ["check", examples / f"{example}.toml"]
        commands[f"info {example}"] = ["info", examples / f"{example}.toml"]
        commands[f"run {example}"] = run_words(examples / f"{example}.toml")
    for kind in ("hdf5", "npy", "csv"):
        out = os.path.join(folder, f"written_{kind}")
        commands[f"run sar_r to {kind}"] = ["run", examples / "sar_r.toml", "--out", out, "--force", "--quiet", "--format", kind]
    image = os.path.join(folder, "sar_r.img")
    sar_r = recordings["sar_r"][0]
    subprocess.run([program, "focus", sar_r, "--out", image, "--force", "--quiet"], check=True, stderr=subprocess.DEVNULL)
    quiet = ["--force", "--quiet"]
    commands |= {
        "focus sar_r": ["focus", sar_r, "--out", os.path.join(folder, "again.img"), *quiet],
        "measure sar_r": ["measure", image],
        "convert sar_r to NPY": ["convert", sar_r, os.path.join(folder, "sar_r.npy"), "--force"],
        "convert sar_r to CSV": ["convert", sar_r, os.path.join(folder, "sar_r.csv"), "--force"],
        "plot sar_r": ["plot", sar_r, "-o", os.path.join(folder, "sar_r.png"), "--force"],
        "profiles stepped_aircraft": ["profiles", recordings["stepped_aircraft"][0], "--out", os.path.join(folder, "p.img"), *quiet],
        "isar turning_ship": ["isar", recordings["turning_ship"][0], "--out", os.path.join(folder, "i.img"), *quiet],
        "doppler mti": ["doppler", recordings["mti"][0], "--out", os.path.join(folder, "d.img"), *quiet],
        "search search_radar": ["search", recordings["search_radar"][0], "--out", os.path.join(folder, "s.img"), *quiet],
    }
    return commands


def works(program, words):
    null = subprocess.DEVNULL
    return subprocess.run([program, *map(str, words)], stdin=null, stdout=null, stderr=null).returncode == 0


def against(before, now, folder, examples, pairs, names):
    """Compares two programs over all workloads whose names contain one of `names` (all where there are none); the rows."""
    commands = echo_commands(folder) | focus_commands(folder, before) | example_commands(folder, before, examples)
    rows = []
    print(f"{'processor seconds, one thread':32} {'before':>10} {'now':>10} {'ratio':>7} {'spread':>7}   ({pairs} pairs)")
    for name, words in commands.items():
        if names and not any(part in name for part in names):
            continue
        broken = [which for which, program in (("before", before), ("now", now)) if not works(program, words)]
        if broken:
            print(f"{name:32} fails: {', '.join(broken)}", flush=True)
            rows.append({"workload": name, "fails": broken})
            continue
        row = {"workload": name, "limit": FOCUS_LIMIT if name.startswith("focus") else LIMIT, **compare(before, now, words, pairs)}
        row["slower"] = is_slower(row)
        rows.append(row)
        print(f"{name:32} {row['before_s']:8.4f} s {row['now_s']:8.4f} s {row['ratio']:7.3f} {row['spread']:7.3f}"
              + f"   slower than {row['limit']}" * row["slower"], flush=True)
    slower = [row["workload"] for row in rows if row.get("slower")]
    failing = [row["workload"] for row in rows if row.get("fails")]
    print(f"{len(rows)} workloads, {len(slower)} slower" + (": " + ", ".join(slower)) * bool(slower) + f", {len(failing)} not compared" * bool(failing))
    return rows


def save(rows, path):
    pathlib.Path(path).write_text(json.dumps(rows, indent=1), encoding="utf-8")
