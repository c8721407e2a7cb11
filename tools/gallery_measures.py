"""How the numbers of the gallery are measured: each function makes one of a Lab of tools/gallery."""

import functools
import json
import math
import statistics


def strongest(table):
    """Number of the row with the largest magnitude."""
    return max(range(len(table["magnitude"])), key=table["magnitude"].__getitem__)


def at_strongest(name, arguments, scale=1.0):
    def measure(lab):
        table = lab.table(arguments)
        return scale * table[name][strongest(table)]

    return measure


def inside(table, share=0.5):
    """First and last row whose magnitude is at least a share of the largest, and the spacing of the rows."""
    level = share * max(table["magnitude"])
    rows = [i for i, value in enumerate(table["magnitude"]) if value >= level]
    place = next(name for name in table if name in ("slant range", "azimuth time"))
    places = table[place]
    return places[rows[0]], places[rows[-1]], places[1] - places[0]


def begins(arguments):
    return lambda lab: inside(lab.table(arguments))[0]


def length(arguments, share=0.5):
    """From the first to behind the last sample of at least a share of the largest magnitude."""

    def measure(lab):
        first, last, spacing = inside(lab.table(arguments), share)
        return last - first + spacing

    return measure


def rows_of(arguments):
    return lambda lab: len(lab.table(arguments)["I"])


def step_of(name, arguments):
    return lambda lab: lab.table(arguments)[name][1] - lab.table(arguments)[name][0]


def peak_between(arguments, low, high):
    """Place of the largest magnitude between two ranges, by the parabola through three samples."""

    def measure(lab):
        table = lab.table(arguments)
        x, y = table["slant range"], table["magnitude"]
        i = max((k for k in range(1, len(x) - 1) if low <= x[k] <= high), key=y.__getitem__)
        bend = y[i - 1] - 2 * y[i] + y[i + 1]
        return x[i] + 0.5 * (y[i - 1] - y[i + 1]) / bend * (x[i + 1] - x[i])

    return measure


def width_at(arguments, low, high, share):
    """Width of the highest peak between two ranges at a share of its magnitude, straight lines between samples."""

    def measure(lab):
        table = lab.table(arguments)
        x, y = table["slant range"], table["magnitude"]
        peak = max((k for k in range(len(x)) if low <= x[k] <= high), key=y.__getitem__)
        level = share * y[peak]

        def crossing(direction):
            i = peak
            while y[i + direction] >= level:
                i += direction
            return x[i] + (y[i] - level) / (y[i] - y[i + direction]) * (x[i + direction] - x[i])

        return crossing(1) - crossing(-1)

    return measure


def highest_between(arguments, low, high):
    """Largest magnitude between two ranges."""

    def measure(lab):
        table = lab.table(arguments)
        return max(y for x, y in zip(table["slant range"], table["magnitude"]) if low <= x <= high)

    return measure


def side_lobe_db(arguments, low, high):
    """Between two ranges, the highest magnitude outside the main lobe, which ends where it first rises again."""

    def measure(lab):
        table = lab.table(arguments)
        y = [level for x, level in zip(table["slant range"], table["magnitude"]) if low <= x <= high]
        left = right = peak = max(range(len(y)), key=y.__getitem__)
        while y[left - 1] < y[left]:
            left -= 1
        while y[right + 1] < y[right]:
            right += 1
        return 20.0 * math.log10(max(y[:left] + y[right + 1:]) / y[peak])

    return measure


def sinc(x):
    return math.sin(math.pi * x) / (math.pi * x)


def compressed_chirp(product):
    """Highest sidelobe in dB, and half-power width times the bandwidth, of |sin(pi x (1 - x/n))/(pi x)|, n = B Tp."""
    steps = 100_000
    x = [(i + 1) * product / steps for i in range(steps - 1)]
    y = [abs(math.sin(math.pi * a * (1.0 - a / product)) / (math.pi * a)) for a in x]
    first_rise = next(i for i in range(len(y)) if y[i + 1] > y[i])
    half_power = next(i for i in range(len(y)) if y[i] < math.sqrt(0.5))
    return 20.0 * math.log10(max(y[first_rise:])), 2.0 * x[half_power]


def counts(name, arguments, lsb_v):
    def measure(lab):
        table = lab.table(arguments)
        return round(table[name][strongest(table)] / lsb_v)

    return measure


def ratio(name, above, below, combine):
    return lambda lab: combine(at_strongest(name, above)(lab), at_strongest(name, below)(lab))


def half_power(arguments):
    """Offset at which an antenna's amplitude falls below 1/sqrt(2)."""

    def measure(lab):
        table = lab.table(arguments)
        offset = table["Offset from the beam's middle"]
        (gain,) = (values for name, values in table.items() if name != "Offset from the beam's middle")
        middle = max(range(len(gain)), key=gain.__getitem__)
        level = gain[middle] / math.sqrt(2.0)
        i = middle
        while gain[i + 1] >= level:
            i += 1
        return offset[i] + (gain[i] - level) / (gain[i] - gain[i + 1]) * (offset[i + 1] - offset[i])

    return measure


def first_side_lobe_db(arguments):
    """Of magnitudes over time, how far the first maximum behind the main lobe is below it."""

    def measure(lab):
        level = lab.table(arguments)["magnitude"]
        i = peak = max(range(len(level)), key=level.__getitem__)
        while level[i + 1] < level[i]:
            i += 1
        return 20.0 * math.log10(max(level[i:]) / level[peak])

    return measure


def first_null_s(arguments):
    """Of magnitudes over time, how long after the largest they first rise again."""

    def measure(lab):
        table = lab.table(arguments)
        level = table["magnitude"]
        i = peak = max(range(len(level)), key=level.__getitem__)
        while level[i + 1] < level[i]:
            i += 1
        return table["azimuth time"][i] - table["azimuth time"][peak]

    return measure


def strongest_between_s(arguments, low, high):
    """When the magnitude is largest between two times, and how large."""

    def measure(lab):
        table = lab.table(arguments)
        rows = zip(table["magnitude"], table["azimuth time"])
        magnitude, time = max(row for row in rows if low <= row[1] <= high)
        return time, magnitude

    return measure


def ends(arguments, low, high):
    """Where the magnitude falls for good below half its median between two ranges."""

    def measure(lab):
        table = lab.table(arguments)
        rows = list(zip(table["slant range"], table["magnitude"]))
        level = 0.5 * statistics.median(y for x, y in rows if low <= x <= high)
        return max(x for x, y in rows if y >= level)

    return measure


def mean_step_rad(arguments):
    """Mean turn of the unwrapped phase from pulse to pulse."""

    def measure(lab):
        phase = lab.table(arguments)["Unwrapped phase"]
        return math.radians(phase[-1] - phase[0]) / (len(phase) - 1)

    return measure


def phase_step_deg(arguments, pulse):
    """Turn of the unwrapped phase from a pulse to the next, counted from 0."""

    def measure(lab):
        phase = lab.table(arguments)["Unwrapped phase"]
        return phase[pulse + 1] - phase[pulse]

    return measure


def worst_knot(arguments):
    """Largest distance of the three interpolations from the five points of figure 4.12."""
    knots = {0: 0.0, 1: 1.5, 2: 0.0, 3: -5.0, 4: -3.5}

    def measure(lab):
        table = lab.table(arguments)
        time = table["Time"]
        rows = {at: min(range(len(time)), key=lambda i, at=at: abs(time[i] - at)) for at in knots}
        methods = ("linear", "cubic splines", "low-pass filter")
        return max(abs(table[method][rows[at]] - value) for method in methods for at, value in knots.items())

    return measure


def value_at(arguments, name, place_name, place):
    def measure(lab):
        table = lab.table(arguments)
        places = table[place_name]
        return table[name][min(range(len(places)), key=lambda i: abs(places[i] - place))]

    return measure


def steady_doppler_hz(arguments):
    """Of the spectrum of one range cell, where its peak is, by the parabola through three levels in decibels."""

    def measure(lab):
        cut = lab.panels(arguments)[-1]
        f, level = cut["Doppler frequency"], cut["Level above 1 V"]
        i = max(range(1, len(f) - 1), key=level.__getitem__)
        bend = level[i - 1] - 2 * level[i] + level[i + 1]
        return f[i] + 0.5 * (level[i - 1] - level[i + 1]) / bend * (f[i + 1] - f[i])

    return measure


def highest_doppler_hz(arguments):
    """Of the spectrum of one range cell, where it falls for good 10 dB below its median within 3 kHz, but for lines."""

    def measure(lab):
        cut = lab.panels(arguments)[-1]
        rows = list(zip(cut["Doppler frequency"], cut["Level above 1 V"]))
        level = statistics.median(y for f, y in rows if 1000.0 < f < 3000.0)
        return max(f for f, y in rows if y > level - 10.0)

    return measure


def band_hz(arguments, level_db):
    """Width of a sent pulse's spectrum at a level below its largest."""

    def measure(lab):
        spectrum = lab.panels(arguments)[1]
        inside = [f for f, level in zip(*spectrum.values()) if level >= level_db]
        return inside[-1] - inside[0]

    return measure


def moved(arguments, time):
    """Change of range from the first pulse to the one nearest to a time, by the phase."""

    def measure(lab):
        history = lab.panels(arguments)[1]
        times = history["Azimuth time"]
        return history["Change of range"][min(range(len(times)), key=lambda i: abs(times[i] - time))]

    return measure


def worst_width(axis, *focus):
    """Of all points of a focused image, by default the R, the largest share by which a width differs from theory."""

    def measure(lab):
        return max(
            abs(response_of(target)[axis]["width_m"] / target["theory"][axis]["width_m"] - 1.0)
            for target in measured_targets(lab, *focus)
        )

    return measure


def measured_targets(lab, focus="sarsim focus examples/sar_r.toml --out sar_r.img --quiet"):
    """What `sarsim measure` says of each target in the image that a command makes."""
    lab.once(focus)
    words = focus.split()
    return json.loads(lab.once(f"sarsim measure {words[words.index('--out') + 1]} --json"))["targets"]


def response_of(target):
    """The peak that was measured, displaced or not."""
    return target["found"] or target["peak"]


def of_target(number, focus, *path):
    """A figure that was found of one target, counted from 1."""

    def measure(lab):
        found = response_of(measured_targets(lab, focus)[number - 1])
        return functools.reduce(lambda value, name: value[name], path, found)

    return measure


def report(lab, command):
    """What a command of the page says as JSON; its files get other names."""
    return json.loads(lab.once(command.replace(".img", "-measured.img") + " --json"))


def of_report(command, read):
    return lambda lab: read(report(lab, command))


def worst_place_of_ship(ship):
    """Largest distance of a point of a turning target from where it has to be, in metres."""
    errors = [target["found"] for target in ship["images"][0]["targets"]]
    return max(math.hypot(error["cross_range_error_m"], error["range_error_m"]) for error in errors)


def after(command, measure):
    """What is measured once a command has made its file."""

    def both(lab):
        lab.once(command)
        return measure(lab)

    return both


def peaks_above(focus, arguments, share):
    """Number of maxima of a cut that reach a share of the largest."""

    def measure(lab):
        lab.once(focus)
        y = lab.table(arguments)["magnitude"]
        return sum(a < b >= c and b >= share * max(y) for a, b, c in zip(y, y[1:], y[2:]))

    return measure


def found_targets(lab, *focus):
    return sum(target["found"] is not None for target in measured_targets(lab, *focus))


def displaced_targets(lab, *focus):
    return sum(target["state"] == "displaced" for target in measured_targets(lab, *focus))


def peak_v(number, focus):
    """The largest peak where a target is looked for, found or not."""

    def measure(lab):
        target = measured_targets(lab, focus)[number - 1]
        return target["noise_v"] * 10.0 ** (target["snr_db"] / 20.0)

    return measure


def worst_place(lab, *focus):
    """Largest distance of a measured target from where it has to be, in metres."""
    return max(
        math.hypot(t["azimuth_error_m"], t["range_error_m"])
        for t in measured_targets(lab, *focus)
    )
