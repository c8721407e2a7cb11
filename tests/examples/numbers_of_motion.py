#!/usr/bin/env python3
"""Whether the examples of motion have the numbers of closed forms, computed here.

usage: numbers_of_motion.py SARSIM EXAMPLE

Prints each number, what it has to be and by how much it may be off, and ends with status 1 where one is.
"""

import csv
import io
import json
import math
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import with_numpy  # noqa: E402, F401

import numpy as np  # noqa: E402

import satellite_orbit
from run_example import Sarsim

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"
LIGHT_SPEED = 299792458.0
GRAVITY = 9.80665


class Report:
    """Numbers beside what they have to be."""

    def __init__(self):
        self.failures = 0

    def near(self, what, found, expected, tolerance):
        right = abs(found - expected) <= tolerance
        self.failures += not right
        print(f"{'   ' if right else 'NO '} {what}: {found:.8g}, expected {expected:.8g} within {tolerance:.3g}")

    def within(self, what, found, least, most):
        self.near(what, found, 0.5 * (least + most), 0.5 * (most - least))


class Runner:
    """The program on one example."""

    def __init__(self, sarsim, scene):
        self.sarsim, self.scene = sarsim, scene

    def __call__(self, *words):
        done = self.sarsim(*words)
        if done.returncode != 0:
            sys.exit(f"sarsim {' '.join(words)} ended with status {done.returncode}\n{done.stderr}")
        return done.stdout

    def geometry(self, radar, start, end, *options):
        table = self("geometry", self.scene, "--radar", radar, "--start", str(start), "--end", str(end), "--csv", *options)
        return list(csv.DictReader(io.StringIO(table)))

    def measured(self, image):
        return json.loads(self("measure", image, "--json"))["targets"]


def peak_of(target):
    """The peak that was measured, displaced or not."""
    return target["found"] or target["peak"]


def column(rows, name):
    return np.array([float(row[name]) for row in rows])


# ---- A satellite ----------------------------------------------------------------------------------------------------

# Latitude and longitude [deg], height [m] of the reflectors.
REFLECTORS = [(-16.012920, -68.551945, 0.0), (-16.0117, -68.549, 120.0), (-16.0145, -68.5545, 40.0)]
WAVELENGTH = LIGHT_SPEED / 5.405000454334350e9


def ecef(latitude_deg, longitude_deg, height_m):
    latitude, longitude = np.radians(latitude_deg), np.radians(longitude_deg)
    e2 = (2.0 - 1.0 / 298.257223563) / 298.257223563
    normal = 6378137.0 / np.sqrt(1.0 - e2 * np.sin(latitude) ** 2)
    out = (normal + height_m) * np.cos(latitude)
    up = (normal * (1.0 - e2) + height_m) * np.sin(latitude)
    return np.array([out * np.cos(longitude), out * np.sin(longitude), up], dtype=np.longdouble)


def near_epoch():
    """Place and velocity of the satellite over the Earth at times within a second, integrated."""
    inertial = np.concatenate([satellite_orbit.PLACE, satellite_orbit.VELOCITY + satellite_orbit.spun(satellite_orbit.PLACE)])

    def at(time_s):
        return satellite_orbit.over_earth(satellite_orbit.stepped(inertial, np.longdouble(time_s)), np.longdouble(time_s))

    return at


def straight(at):
    """The straight line that fits the track of the pulses best, to which images refer: its middle and direction."""
    times = np.arange(-578, 579) / 1700.0
    places = np.array([at(time_s)[0] for time_s in times])
    speed = (times[:, None] * places).sum(axis=0) / (times**2).sum()
    return places.mean(axis=0), speed / np.sqrt(speed @ speed)


def satellite(run, report):
    at = near_epoch()
    run("focus", run.scene, "--algorithm", "back-projection", "--azimuth=-200:200", "--out", "a.img", "--quiet")
    targets = run.measured("a.img")
    rows = run.geometry("SAR", -0.001, 0.001)
    middle = next(row for row in rows if int(row["pulse"]) == 0)
    origin, ahead = straight(at)
    for number, (place, target) in enumerate(zip(REFLECTORS, targets), 1):
        sight = ecef(*place) - origin
        along = float(sight @ ahead)
        distance = float(np.sqrt(sight @ sight - (sight @ ahead) ** 2))
        found, theory = target["found"], target["theory"]
        name = f"reflector {number}"
        report.near(f"{name}, along the orbit [m]", found["azimuth_m"], along, 0.05)
        report.near(f"{name}, slant range [m]", found["range_m"], distance, 0.05)
        turn = (found["phase_rad"] - theory["phase_rad"] + math.pi) % (2.0 * math.pi) - math.pi
        report.near(f"{name}, phase against theory [rad]", turn, 0.0, 0.02)
        for axis in ("azimuth", "range"):
            ratio = found[axis]["width_m"] / theory[axis]["width_m"]
            report.near(f"{name}, width in {axis} over theory", ratio, 1.0, 0.01)
        # Out and home: the echo of a pulse tells of the middle of its way.
        place_now, velocity_now = at(distance / LIGHT_SPEED)
        sight = place_now - ecef(*place)
        rate = float(sight @ velocity_now / np.sqrt(sight @ sight))
        report.near(f"{name}, Doppler frequency at time 0 [Hz]",
                    -2.0 * float(middle[f"target {number} radial_speed_mps"]) / WAVELENGTH, -2.0 * rate / WAVELENGTH, 0.02)
    # Zero-Doppler steering holds the middle of the beam on the first: all of the radar equation.
    whole = math.sqrt(4e3 * WAVELENGTH**2 * 1000.0 / (4.0 * math.pi) ** 3) / 826846.99**2
    report.near("echo of reflector 1 at time 0, of the radar equation", float(middle["target 1 amplitude_v"]) / whole, 1.0, 0.01)
    # Of uniform weight over the aperture: 0.886 c/2B along range.
    report.near("width in range [m]", targets[0]["found"]["range"]["width_m"], 0.886 * LIGHT_SPEED / 2.0 / 80e6, 0.01)
    ends = run.geometry("SAR", -0.34, 0.34)
    speeds, times = column(ends, "target 1 radial_speed_mps"), column(ends, "time_s")
    report.near("rate of the Doppler frequency [Hz/s]", -2.0 / WAVELENGTH * np.polyfit(times, speeds, 1)[0], -2265.100, 0.5)


# ---- An aircraft in gusts -------------------------------------------------------------------------------------------


def entropy(path):
    """Of the powers of a picture: small where it is sharp."""
    power = np.abs(np.load(path)) ** 2
    share = power[power > 0.0] / power.sum()
    return float(-(share * np.log(share)).sum())


def gusts(run, report):
    run("run", run.scene, "--quiet")
    run("motion", run.scene, "--navigation", "--out", "nav.csv")
    run("motion", run.scene, "--out", "truth.csv")
    found, sharpness = {}, {}
    for name, options in {"true": (), "nav": ("--navigation", "nav.csv"), "straight": ("--motion-compensation", "none")}.items():
        for file in (f"{name}.img", f"{name}-samples.npy"):
            run("focus", "gusts.h5", *options, "--out", file, "--quiet")
        targets = run.measured(f"{name}.img")
        found[name] = np.mean([20.0 * math.log10(peak_of(t)["amplitude_v"]) for t in targets])
        sharpness[name] = entropy(run.sarsim.folder / f"{name}-samples.npy")
        if name != "straight":
            for number, target in enumerate(targets, 1):
                ratio = peak_of(target)["azimuth"]["width_m"] / target["theory"]["azimuth"]["width_m"]
                report.near(f"{name}: width of point {number} along the track over theory", ratio, 1.0, 0.02)
                height = 20.0 * math.log10(peak_of(target)["amplitude_v"] / target["theory"]["amplitude_v"])
                report.within(f"{name}: point {number} against theory [dB]", height, -0.5, 0.1)
    report.within("peaks with the navigation, against the truth [dB]", found["nav"] - found["true"], -0.3, 0.05)
    report.within("peaks without compensation, against the truth [dB]", found["straight"] - found["true"], -30.0, -12.0)
    report.within("entropy with the navigation, more than with the truth", sharpness["nav"] - sharpness["true"], -0.05, 0.3)
    report.within("entropy without compensation, more than with the truth",
                  sharpness["straight"] - sharpness["true"], 1.0, 10.0)
    track, truth = (np.loadtxt(run.sarsim.folder / name, delimiter=",", comments=["#", "t"]) for name in ("nav.csv", "truth.csv"))
    # Accelerometer b/2 t^2, gyro g eps t^3/6, a minute behind the alignment; the wandering error is 2 mm.
    bias, drift, age = 50e-6 * GRAVITY, math.radians(0.05) / 3600.0, 60.0
    off = np.interp(0.0, track[:, 0], track[:, 2]) - np.interp(0.0, truth[:, 0], truth[:, 2])
    report.near("what the navigation is off across the track [m], size", abs(off),
                abs(bias * age**2 / 2.0 + drift * GRAVITY * age**3 / 6.0), 0.02)
    up = np.interp(0.0, track[:, 0], track[:, 3]) - np.interp(0.0, truth[:, 0], truth[:, 3])
    report.near("... and in height [m]", up, bias * age**2 / 2.0, 0.01)
    report.within("gusts move the aircraft off its line by [m]", np.abs(truth[:, 2] + 3000.0).max(), 0.3, 10.0)


# ---- A ship in waves ------------------------------------------------------------------------------------------------

HEIGHT, PERIOD, LENGTH, BEAM, DRAUGHT, METACENTRE, DAMPING = 3.25, 9.7, 110.0, 15.0, 5.0, 1.2, 0.1


def sea_variances(heading_deg, speed, damping):
    """Of heave [m] and roll [deg] of a box in the sea: the integrals of docs/theory/motion.md, 8."""
    w = np.linspace(0.2, 6.0, 200_000)
    peak = 2.0 * math.pi / PERIOD
    sea = 5.0 / 16.0 * HEIGHT**2 * peak**4 * w**-5.0 * np.exp(-1.25 * (peak / w) ** 4)
    k = w**2 / GRAVITY
    along, across = math.cos(math.radians(heading_deg)), math.sin(math.radians(heading_deg))
    depth = np.exp(-k * DRAUGHT / 2.0)
    mean = np.sinc(k * LENGTH * along / 2.0 / math.pi) * np.sinc(k * BEAM * across / 2.0 / math.pi) * depth
    roll_period = 2.0 * (0.373 + 0.023 * BEAM / DRAUGHT - 0.043 * LENGTH / 100.0) * BEAM / math.sqrt(METACENTRE)
    w0 = 2.0 * math.pi / roll_period
    met = w - w**2 * speed * along / GRAVITY
    resonance = w0**2 / np.abs(w0**2 - met**2 + 2j * damping * w0 * met)
    roll = k * across * mean * resonance
    step = w[1] - w[0]
    return (sea * mean**2).sum() * step, math.degrees(1.0) ** 2 * (sea * roll**2).sum() * step


def ship_in_waves(run, report):
    rows = run.geometry("Watch", 0, 1800, "--set", "Watch.prf=4Hz")
    heave = column(rows, "Ship z_m")
    rolling = column(rows, "Ship rx_deg")
    for what, found, variance in zip(("heave [m]", "roll [deg]"), (heave, rolling), sea_variances(230.0, 6.0, DAMPING)):
        report.near(f"standard deviation over half an hour, {what}", found.std(), math.sqrt(variance), 0.15 * math.sqrt(variance))
    rows = run.geometry("Watch", 0, 20)
    roll, pitch = column(rows, "Ship rx_deg"), column(rows, "Ship ry_deg")
    # The mast's top is 26 m above the sides' edges amidships: roll tilts it towards the radar.
    rate = np.radians(np.gradient(roll, column(rows, "time_s")))
    mast, left, right = (column(rows, f"target {n} radial_speed_mps") for n in (11, 3, 4))
    pitching = np.radians(np.gradient(pitch, column(rows, "time_s")))
    slope = np.linalg.lstsq(np.column_stack([rate, pitching]), mast - (left + right) / 2.0, rcond=None)[0]
    report.near("metres of mast over the sides, by their radial speeds and the rate of roll", abs(slope[0]), 26.0, 0.5)
    said = json.loads(run("isar", run.scene, "--out", "ship.img", "--quiet", "--json"))["images"][0]
    seen = (column(rows, "time_s") >= 4.0) & (column(rows, "time_s") <= 5.0)
    report.near("turn against the line of sight while it is seen [deg]", math.degrees(abs(said["turn_rad"])),
                np.ptp(roll[seen]), 0.2)
    errors = [math.hypot(t["found"]["cross_range_error_m"], t["found"]["range_error_m"]) for t in said["targets"]]
    report.within("points of the ship within 0.15 m", sum(error < 0.15 for error in errors), 10, 11)
    top = max(said["targets"], key=lambda target: target["cross_range_m"])
    report.near("mast's top, above the waterline by its place in the image [m]", top["cross_range_m"], 30.0, 1.5)


# ---- A helicopter ---------------------------------------------------------------------------------------------------


def helicopter(run, report):
    run("run", run.scene, "--quiet")
    samples = np.load(run.sarsim.folder / "helicopter.npy")
    rows = samples[:, np.abs(samples).sum(axis=0).argmax()]
    prf, wavelength, tip = 10e3, LIGHT_SPEED / 3e9, 6.0
    rate = 2.0 * math.pi * 300.0 / 60.0
    moving = np.abs(rows - rows.mean())
    times = np.flatnonzero(moving > moving.max() / 2.0) / prf
    flashes = np.array([group.mean() for group in np.split(times, np.flatnonzero(np.diff(times) > 0.01) + 1)])
    report.near("flashes in a turn", np.count_nonzero(flashes < 0.199), 6, 0)
    report.near("time between flashes, 1/(2 N f) [s]", np.diff(flashes[1:6]).mean(), 1.0 / (2 * 3 * 5.0), 2e-4)
    spectrum = np.abs(np.fft.fft(rows - rows.mean())) ** 2
    frequency = np.fft.fftfreq(len(rows), 1.0 / prf)
    level = np.median(spectrum[(np.rint(frequency) % 15 == 0) & (np.abs(frequency) > 1000.0) & (np.abs(frequency) < 3500.0)])
    for sign in (1, -1):
        seen = frequency[(spectrum > 0.1 * level) & (sign * frequency > 0)]
        report.near("highest Doppler frequency, 2 Omega L/lambda [Hz]", sign * (sign * seen).max(), sign * 2 * rate * tip / wavelength, 60)
    report.near("Doppler lines that are none of N f, share of power", spectrum[np.rint(frequency) % 15 != 0].sum() / spectrum.sum(),
                0.0, 1e-3)


# ---- A formation ----------------------------------------------------------------------------------------------------


def place_of_leader(time_s):
    """Place and heading [rad, clockwise from y] of the leader, its speed 120 m/s."""
    speed, radius = 120.0, 120.0**2 / (GRAVITY * math.tan(math.radians(30.0)))
    turned = max(0.0, time_s - 20.0) * speed / radius
    north = 6000.0 + speed * min(time_s, 20.0) + radius * math.sin(turned)
    return np.array([2000.0 - radius * (1.0 - math.cos(turned)), north, 3000.0]), -turned


def follower(ahead, left, delay):
    def at(time_s):
        place, heading = place_of_leader(time_s - delay)
        along = np.array([math.sin(heading), math.cos(heading), 0.0])
        aside = np.array([-math.cos(heading), math.sin(heading), 0.0])
        return place + ahead * along + left * aside

    return at


AIRCRAFT = [follower(0, 0, 0), follower(-60, 150, 0), follower(-60, -150, 0), follower(0, 0, 5)]


def formation(run, report):
    wavelength = LIGHT_SPEED / 3e9
    for number, middle in ((1, 10.0511), (2, 36.7011)):
        said = json.loads(run("doppler", run.scene, "--simulation", str(number), "--interval", "512", "--window", "hamming",
                              "--cfar", "os", "--out", f"{number}.img", "--quiet", "--json"))
        table = list(csv.DictReader((run.sarsim.folder / f"{number}-detections.csv").open(encoding="utf-8")))
        report.near(f"recording {number}: detections", len(table), 4, 0)
        report.near(f"recording {number}: status", float(said.get("status", "done") not in ("done", "ok")), 0, 0)
        for index, at in enumerate(AIRCRAFT, 1):
            distance = float(np.linalg.norm(at(middle)))
            rate = float(np.linalg.norm(at(middle + 1e-3)) - np.linalg.norm(at(middle - 1e-3))) / 2e-3
            # A chirp that sweeps upward shows what recedes farther by fd Tp/B c/2.
            shift = 2.0 * rate / wavelength * 5e-6 / 10e6 * LIGHT_SPEED / 2.0
            row = next((row for row in table if row["target"] == str(index)), None)
            if row is None:
                report.near(f"recording {number}: aircraft {index} found", 0, 1, 0)
                continue
            report.near(f"recording {number}: aircraft {index}, range [m]", float(row["range_m"]), distance + shift, 1.0)
            report.near(f"recording {number}: aircraft {index}, speed [m/s]", float(row["speed_mps"]), rate, 0.1)
    rows = run.geometry("Watch", 36.65, 36.65)
    radius = 120.0**2 / (GRAVITY * math.tan(math.radians(30.0)))
    for name, left in (("Left", 150.0), ("Right", -150.0)):
        speed = 120.0 / radius * math.hypot(radius - left, 60.0)
        found = math.hypot(float(rows[0][f"{name} vx_mps"]), float(rows[0][f"{name} vy_mps"]))
        report.near(f"{name}, speed in the turn [m/s]", found, speed, 1e-6)
        report.near(f"{name}, bank [deg]", float(rows[0][f"{name} rx_deg"]),
                    math.degrees(math.atan(speed * 120.0 / radius / GRAVITY)), 1e-6)


EXAMPLES_OF_MOTION = {f.__name__: f for f in (satellite, gusts, ship_in_waves, helicopter, formation)}


def main():
    program, name = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    report = Report()
    with tempfile.TemporaryDirectory() as folder:
        sarsim = Sarsim(program, folder)
        for path in EXAMPLES.glob(f"{name}*"):
            (sarsim.folder / path.name).write_bytes(path.read_bytes())
        EXAMPLES_OF_MOTION[name](Runner(sarsim, f"{name}.toml"), report)
    return 1 if report.failures else 0


if __name__ == "__main__":
    sys.exit(main())
