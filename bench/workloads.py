"""The fixed workloads of the benchmark suite: scripts made from a seed, the same every time."""

import random

C = 299792458.0

# name: targets, pulses, samples of a pulse, samples of the swath
SIZES = {
    "one": (1, 1000, 400, 4096),
    "field": (1000, 500, 400, 1024),
    "scene": (20000, 1000, 1000, 4096),
    "long": (2000, 1000, 10000, 16384),
    "million": (1000000, 200, 1000, 8192),
    "moving": (1000, 2000, 1000, 4096),
}

RATE_HZ = 120e6
BANDWIDTH_HZ = 100e6
CARRIER_HZ = 5.3e9
NEAR_M = 10000.0
PRF_HZ = 500.0


def platform(name, position="STATIONARY 0 0 0", rotation="CONST 0 0 0 0 0 0"):
    return f"$PLATFORM {name} {position} {rotation} STDDEV 0 0 0 STDDEV 0 0 0"


def target(name, x, y, z, rcs):
    return f"$TARGET {name} {x:.4f} {y:.4f} {z:.4f} 0 0 0 {rcs:.4f} 0 ISOTROPIC"


def radar(pulse_samples):
    width_ns = pulse_samples / RATE_HZ * 1e9
    return (f"$RADAR Radar1 Earth CHIRP {BANDWIDTH_HZ / 1e9} {width_ns!r} RECT CONSTANT {PRF_HZ} SINGLE {CARRIER_HZ / 1e9} "
            "1 0 0 ISOTROPIC SAME FIXED 0 0 RECT NO_STC")


def simulation(pulses, swath_samples, output):
    # Half a sample more than the swath, so that rounding cannot lose one.
    end = NEAR_M + (swath_samples + 0.25) * C / (2 * RATE_HZ)
    return (f"$SIMULATION Radar1 {NEAR_M} {end!r} 0 {(pulses - 0.5) / PRF_HZ!r} 8 {RATE_HZ / 1e9} 1E-7 "
            f"{output} RAW {output.lower()}.out BEGIN 1 1")


def cloud_script(points):
    """Text of `million` with its targets from the table of points of that name."""
    _, pulses, pulse_samples, swath_samples = SIZES["million"]
    return "\n".join([platform("Earth"), f"$CLOUD Earth FILE {points} 0 0 0 1 0 ISOTROPIC", radar(pulse_samples),
                      simulation(pulses, swath_samples, "BINARY")]) + "\n"


def cloud_rows(count, numpy):
    """Its points: x, y, z, cross-section."""
    randoms = numpy.random.default_rng(1998)
    room = SIZES["million"][3] * C / (2 * RATE_HZ) - SIZES["million"][2] * C / (2 * RATE_HZ)
    return numpy.column_stack([randoms.uniform(-200, 200, count), NEAR_M + randoms.uniform(0, room, count),
                               randoms.uniform(-20, 20, count), randoms.uniform(0.5, 2, count)])


def script(name, targets=None, pulses=None, pulse_samples=None, swath_samples=None, output="BINARY", options="", flying=False, noisy=False, processing="RAW"):
    """Text of a workload; sizes may be changed to see how times scale. Flying, the radar passes at 200 m/s, 3 km high."""
    base = SIZES[name]
    targets = base[0] if targets is None else targets
    pulses = base[1] if pulses is None else pulses
    pulse_samples = base[2] if pulse_samples is None else pulse_samples
    swath_samples = base[3] if swath_samples is None else swath_samples
    randoms = random.Random(1998)
    length = swath_samples * C / (2 * RATE_HZ)
    room = max(length - pulse_samples * C / (2 * RATE_HZ), 0.1 * length)
    lines = [platform("Earth")]
    if name == "moving":
        # A hundred platforms that pass by and turn, ten targets on each.
        groups = 100
        for g in range(groups):
            y = NEAR_M + room * randoms.random()
            vx, vy = randoms.uniform(-50, 50), randoms.uniform(-50, 50)
            path = f"TRAJECTORY LINEAR LINEAR LINEAR INLINE 2 0 0 1 {vx:.3f} 2 0 {y:.3f} 1 {y + vy:.3f} 1 0 0 NOT_ALIGNED"
            turn = f"CONST 0 0 0 {randoms.uniform(-5, 5):.3f} {randoms.uniform(-5, 5):.3f} {randoms.uniform(-20, 20):.3f}"
            lines.append(platform(f"P{g}", path, turn))
        for k in range(targets):
            lines.append(target(f"P{k % groups}", *(randoms.uniform(-20, 20) for _ in range(3)), randoms.uniform(0.5, 2)))
    else:
        for _ in range(targets):
            y = NEAR_M + room * randoms.random()
            lines.append(target("Earth", randoms.uniform(-200, 200), y, randoms.uniform(-20, 20), randoms.uniform(0.5, 2)))
    lines.append(radar(pulse_samples).replace(" 1 0 0 ISOTROPIC", " 1 0 290 ISOTROPIC" if noisy else " 1 0 0 ISOTROPIC"))
    lines.append(simulation(pulses, swath_samples, output).replace(" RAW ", f" {processing} "))
    if flying:
        path = "TRAJECTORY LINEAR LINEAR LINEAR INLINE 2 -10 -2000 10 2000 1 0 0 1 0 3000 NOT_ALIGNED"
        lines = [platform("Plane", path), *(line.replace("$RADAR Radar1 Earth", "$RADAR Radar1 Plane") for line in lines)]
    if options:
        lines.append("$OPTIONS " + options)
    return "\n".join(lines) + "\n"


# Recordings whose time and memory are forecast: workload and what is changed of it.
FORECASTS = {
    **{name: (name, {}) for name in SIZES},
    "one, noise": ("one", {"noisy": True}),
    "one, compressed": ("one", {"processing": "MATCHED"}),
    "field in flight": ("field", {"flying": True}),
    "field band-limited": ("field", {"options": "PULSE BAND_LIMITED"}),
    "scene in flight": ("scene", {"flying": True}),
    "scene band-limited": ("scene", {"options": "PULSE BAND_LIMITED"}),
    "scene bl. in flight": ("scene", {"options": "PULSE BAND_LIMITED", "flying": True}),
    "scene, tolerance 1e-9": ("scene", {"options": "TOLERANCE 1E-9"}),
    "long in flight": ("long", {"flying": True}),
    "long, few targets": ("long", {"targets": 20}),
}

FOCUS_PULSES = 4096
FOCUS_SAMPLES = 4096

# algorithm: sizes of its transforms over range and azimuth of this scene, and how often each row of Doppler frequencies is transformed
FOCUS_SIZES = {"range-doppler": (4800, 6400, 1), "chirp-scaling": (4800, 6400, 3), "omega-k": (6000, 6400, 1)}


def spot_script(targets, pulses, options=""):
    """An aircraft 10 km off looks at 300 m x 300 m of scatterers: X band, 600 MHz, pulses of 2 000 samples in rows of 4 000."""
    randoms = random.Random(2)
    rate_hz, near_m, speed, prf_hz = 750e6, 9700.0, 100.0, 500.0
    end_m = near_m + 4000.25 * C / (2 * rate_hz)
    half_s = pulses / prf_hz / 2
    path = (f"TRAJECTORY LINEAR LINEAR LINEAR INLINE 2 {-half_s - 1} {-speed * (half_s + 1)} {half_s + 1} {speed * (half_s + 1)} "
            "1 0 0 1 0 3000 NOT_ALIGNED")
    lines = [platform("Earth"), platform("Plane", path)]
    lines += [target("Earth", randoms.uniform(-150, 150), 9540 + randoms.uniform(-150, 150), 0, randoms.uniform(0.5, 2)) for _ in range(targets)]
    lines += [f"$RADAR Radar1 Plane CHIRP 0.6 {2000 / rate_hz * 1e9!r} RECT CONSTANT {prf_hz} SINGLE 9.6 1 0 0 SINX 4 4 SAME FIXED -17.4 0 RECT NO_STC",
              f"$SIMULATION Radar1 {near_m} {end_m!r} {-half_s} {half_s - 1 / prf_hz} 16 {rate_hz / 1e9} 1E-9 BINARY RAW spot.out BEGIN 1 1"]
    return "\n".join(lines + ["$OPTIONS " + options] * bool(options)) + "\n"


# For back-projection: pulses, samples, and the rows of the image.
PROJECTED = (1024, 1024, 1281)


def focus_script(file_format, file, pulses=FOCUS_PULSES, samples=FOCUS_SAMPLES):
    """An aircraft maps a strip from 8 km on: raw samples 1 m apart, two points."""
    prf_hz, speed, rate_hz, near_m = 500.0, 150.0, 150e6, 8000.0
    flight_s = pulses / prf_hz
    end_m = near_m + (samples + 0.25) * C / (2 * rate_hz)
    path = f"TRAJECTORY LINEAR LINEAR LINEAR INLINE 2 -10 {-10 * speed} 10 {10 * speed} 1 0 0 1 0 3000 NOT_ALIGNED"
    return "\n".join([
        platform("Earth"), platform("Plane", path), target("Earth", 0, 7739.5090, 0, 10), target("Earth", 60, 8166.3945, 0, 10),
        f"$RADAR Radar1 Plane CHIRP 0.1 2000 RECT CONSTANT {prf_hz} SINGLE 9.6 1 0 0 SINX 20 1.2 SAME FIXED -17 0 RECT NO_STC",
        f"$SIMULATION Radar1 {near_m} {end_m!r} {-flight_s / 2} {flight_s / 2 - 1 / prf_hz} 8 {rate_hz / 1e9} 0 {file_format} RAW "
        f"{file} BEGIN 1 1", ""])
