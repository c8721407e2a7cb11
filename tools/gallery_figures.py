"""The figures of the gallery: their commands, what to look at and their numbers. Read by tools/gallery."""

import collections
import math

from gallery_measures import (
    after,
    at_strongest,
    band_hz,
    begins,
    compressed_chirp,
    counts,
    displaced_targets,
    ends,
    first_null_s,
    first_side_lobe_db,
    found_targets,
    half_power,
    highest_doppler_hz,
    highest_between,
    length,
    mean_step_rad,
    moved,
    of_report,
    peak_v,
    of_target,
    peak_between,
    peaks_above,
    phase_step_deg,
    ratio,
    rows_of,
    side_lobe_db,
    sinc,
    steady_doppler_hz,
    step_of,
    strongest,
    strongest_between_s,
    value_at,
    width_at,
    worst_knot,
    worst_place,
    worst_place_of_ship,
    worst_width,
)

# A number of a figure: what it is, its unit, what it has to be and who says so ("thesis", or a formula of the page), how
# far off it may be, how it is written, and how it is measured: a function of a Lab.
Number = collections.namedtuple("Number", "what unit expected source tolerance form measure")
# A figure: its number in the thesis or, without a point in it, a name; a title, the commands that make its pictures, what
# to look at, its numbers.
Figure = collections.namedtuple("Figure", "name title commands look numbers")

PASS = "examples/thesis_figure_2_3.toml"
FIRST = "examples/thesis_chapter3.toml"
KNOTS = "examples/thesis_figure_4_12.toml"
SAR = "examples/sar_r.toml"
SAR_1998 = "examples/sar_r_1998.scr"
A2 = "examples/thesis_a2.toml"
A3 = "examples/thesis_a3.toml"
A4 = "examples/thesis_a4.toml"
BEAM = "examples/thesis_figure_a14.toml"
BARKER = "examples/barker_chirp.toml"
STEPS = "sarsim profiles examples/stepped_srp.toml --out steps.img --quiet"
STEPS_VIEW = "steps.img --kind pulse --range 2994 3014"
SHIP_IMAGE = "sarsim isar examples/turning_ship.toml --out ship.img --quiet"
SEARCH = "sarsim search examples/search_radar.toml --out ppi.img --quiet"
MAPS = "sarsim doppler examples/mti.toml --interval 256 --out mti.img --quiet"
PROFILES = "sarsim profiles examples/stepped_aircraft.toml --velocity estimated --group scans --out aircraft.img --quiet"
STRIP = "examples/stripmap_motion.toml"
FOCUS_MOTION = f"sarsim focus {STRIP} --out motion.img --quiet"
STRIP_VIEW = "--show db --span 40 --azimuth -250 280 --range 8420 8670 --colours ember --size 480 440"
SPOT = "examples/spotlight.toml"
FOCUS_SPOT = f"sarsim focus {SPOT} --out spotlight.img --quiet"
FOCUS_STRIP = f"sarsim focus {SPOT} --simulation 2 --out strip.img --quiet"
PAIR = "--kind range --at-range 8000 --azimuth -3 3"
OWN = "examples/user_functions.toml"
OWN_PULSE = f"{OWN} --kind pulse --at-time 0"
OWN_PHASE = f"{OWN} --kind phase --at-range 20000"
SURFACE = "examples/surface.toml"
ORBIT = "examples/satellite.toml"
FOCUS_ORBIT = f"sarsim focus {ORBIT} --algorithm back-projection --azimuth=-200:200 --out satellite.img --quiet"
GUSTS = "examples/gusts.toml"
RUN_GUSTS = f"sarsim run {GUSTS} --quiet"
BELIEF = f"sarsim motion {GUSTS} --navigation --out nav.csv"
FOCUS_GUSTS = "sarsim focus gusts.h5 --navigation nav.csv --out believed.img --quiet"
FOCUS_GUSTS_NONE = "sarsim focus gusts.h5 --motion-compensation none --out straight.img --quiet"
def after_gusts(measure):
    """What is measured once the flight is recorded and its navigation is written."""
    return after(RUN_GUSTS, after(BELIEF, measure))


GUSTS_VIEW = "--show db --span 40 --azimuth -40 90 --range 2990 3060 --colours ember --size 480 440"
WAVES_IMAGE = "sarsim isar examples/ship_in_waves.toml --out waves.img --quiet"
ROTOR = "examples/helicopter.toml"
FLASHES = f"{ROTOR} --kind range --at-range 3000 --show magnitude"
LIGHT_SPEED = 299792458.0
# Number, name, and speed along the line of sight 16.7011 s into the turn: tests/examples/numbers_of_motion.py derives it.
FORMATION = [(1, "the leader", 70.706), (2, "the left one", 68.967), (3, "the right one", 75.788), (4, "the last one", 86.526)]
TURN = "sarsim doppler examples/formation.toml --simulation 2 --interval 512 --window hamming --cfar os --out turn.img --quiet"
PLATE = f"{SURFACE} --kind range --at-range 5060"
MOVING = f"{A3} --simulation 2 --time 0 0.0315 --padding 8"

SIZE = "--size 800 500"
SHIP = "--kind pulse --range 28000 32000 --rate 2e8 --recorded"
JET = "--kind pulse --range 34000 38000 --rate 2e8 --recorded"
CELL_M = 149.8962  # c/2 for a microsecond
CLASSIC_COLOURS = "--colours classic_red_blue"

FIGURES = [
    Figure(
        "2.3",
        "A target passes the radar",
        [f"sarsim plot {PASS} {CLASSIC_COLOURS} {SIZE} -o figure_2_3.png"],
        "The echo comes nearest at time 0 and weakens with distance. Along range the bands are a chirp whose bandwidth, as in"
        " the thesis, is unrealistically low; over time they are the phase of the changing distance.",
        [
            Number("strongest, and so nearest, at", "s", 0.0, "thesis", 1e-6, ".3f",
                   at_strongest("azimuth time", f"{PASS} --kind range --at-range 2300 --recorded")),
            Number("amplitude 15 s later, relative", "1", (2000.0**2 / (2000.0**2 + 3000.0**2)), "(2000 m/3606 m)²", 1e-4,
                   ".4f", ratio("magnitude", f"{PASS} --kind pulse --at-time 15", f"{PASS} --kind pulse --at-time 0",
                                lambda a, b: a / b)),
        ],
    ),
    Figure(
        "3.5",
        "A point target at 3000 m",
        [f"sarsim plot {FIRST} --radar Radar1 --time 0 0.01 --screen --draw pixels {CLASSIC_COLOURS} {SIZE}"
         " -o figure_3_5.png"],
        "One sample for each pixel of the screen, too few for a chirp of 50 MHz: the pattern is aliasing, as the thesis"
        " says, and goes away when one looks closer (figure 3.6).",
        [
            Number("highest magnitude", "mV", 4.095e-5, "thesis", 1e-8, ".4e",
                   at_strongest("magnitude", f"{FIRST} --kind pulse", 1e3)),
            Number("the echo begins at", "m", 3000.0, "thesis", 0.2, ".1f",
                   begins(f"{FIRST} --kind pulse --range 2990 3010 --rate 1e9 --recorded")),
        ],
    ),
    Figure(
        "3.6",
        "The same, closer",
        [f"sarsim plot {FIRST} --time -0.0005 0.0035 {SIZE} -o figure_3_6.png"],
        "Pulses at least 20 pixels apart are drawn as curves, here of the real part. Each chirp swings slowly in its middle"
        " and fast at its ends.",
        [
            Number("from pulse to pulse", "s", 0.001, "thesis", 1e-9, ".4f",
                   step_of("azimuth time", f"{FIRST} --kind range --at-range 3300 --recorded")),
            Number("length of the echo", "m", 749.48, "5 µs · c/2", 0.2, ".1f",
                   length(f"{FIRST} --kind pulse --rate 1e9 --recorded")),
        ],
    ),
    Figure(
        "4.12",
        "The three interpolations of a function",
        [f"sarsim plot {KNOTS} --kind function --compare {SIZE} -o figure_4_12.png"],
        "All three go through the five points, which are at equal intervals, and differ between them and beyond.",
        [
            Number("farthest from a point", "m", 0.0, "thesis", 1e-9, ".6f",
                   worst_knot(f"{KNOTS} --kind function --compare")),
            Number("straight line after half a second", "m", 0.75, "half of 1.5 m", 1e-9, ".3f",
                   value_at(f"{KNOTS} --kind function --compare", "linear", "Time", 0.5)),
            Number("moved after 3 s, as the radar sees it", "m", -5.0, "fourth point", 1e-3, ".3f",
                   moved(f"{KNOTS} --kind phase --at-range 1100", 3.0)),
        ],
    ),
    Figure(
        "4.14",
        "A recording, as slices",
        [
            f"sarsim run {SAR} --quiet",
            f"sarsim plot sar_r.h5 --draw ranges --show real --range 10096 10126 --time 0.4 0.6 {SIZE} -o figure_4_14.png",
            "sarsim-gui sar_r.h5 --window viewer --size 900 620 --screenshot figure_4_14_window.png",
        ],
        "The thesis shows the image viewer's window with slices in azimuth. The first picture is the slices, made from the"
        " file of a recording; the second is the viewer of the workbench with the same file.",
        [
            Number("pulses in the file", "1", 1240, "620 Hz for 2 s", 0, "d",
                   lambda lab: (lab.once(f"sarsim run {SAR} --quiet"), rows_of("sar_r.h5 --kind range")(lab))[1]),
        ],
    ),
    Figure(
        "7.2",
        "The letter R, focused",
        [
            f"sarsim focus {SAR} --out sar_r.img --quiet",
            "sarsim plot sar_r.img --show db --span 40 --range 10090 10310 --azimuth -210 210 --colours ember"
            " --size 560 860 -o figure_7_2.png",
        ],
        "Figure 7.2 is the arrangement of the 24 points; 7.4 the image that the thesis made of it by chirp scaling. This one"
        " is made by omega-k from the example with enough pulses per second, without the artifacts of the thesis' figure.",
        [
            Number("points found", "1", 24, "thesis", 0, "d", found_targets),
            Number("farthest from its place", "m", 0.0, "theory", 0.03, ".3f", worst_place),
        ],
    ),
    Figure(
        "7.3",
        "What the radar of the letter R receives",
        [f"sarsim plot {SAR_1998} {SIZE} -o figure_7_3.png"],
        "The echoes of 24 points on top of each other; the R cannot be seen. The window and its 600 pulses are those of"
        " figures 7.3 and 7.5.",
        [
            Number("pulses", "1", 600, "thesis", 0, "d", rows_of(f"{SAR_1998} --kind range")),
            Number("samples of a pulse", "1", 500, "500 m · 2 · 150 MHz/c", 0, "d",
                   rows_of(f"{SAR_1998} --kind pulse --recorded")),
        ],
    ),
    Figure(
        "A.1",
        "Two pulses of a raw return",
        [f"sarsim plot {A2} --time -0.0003 0.0015 {SIZE} -o figure_a1.png"],
        "The target stands still: each pulse is the same rectangle, here its real part, which is negative. Below are the 53"
        " samples of the worksheet, figure A.2, and their counts.",
        [
            Number("samples", "1", 53, "thesis", 0, "d", rows_of(f"{A2} --kind pulse --recorded")),
            Number("their distance", "m", 37.47, "thesis", 0.01, ".2f",
                   step_of("slant range", f"{A2} --kind pulse --recorded")),
            Number("count I, classic profile", "1", -25, "thesis", 0, "d",
                   counts("I", f"{A2} --kind pulse --recorded --profile classic", 1.67572e-9)),
            Number("count Q, classic profile", "1", -125, "thesis", 0, "d",
                   counts("Q", f"{A2} --kind pulse --recorded --profile classic", 1.67572e-9)),
        ],
    ),
    Figure(
        "A.7",
        "Magnitude of the raw return",
        [f"sarsim plot {A2} --show magnitude {SIZE} -o figure_a7.png"],
        "The echo begins at the target's distance and is half as long in range as in the air.",
        [
            Number("the echo begins at", "m", 1000.0, "thesis", 0.3, ".1f",
                   begins(f"{A2} --kind pulse --rate 1e9 --recorded")),
            Number("its length", "m", 750.0, "thesis", 0.7, ".1f", length(f"{A2} --kind pulse --rate 1e9 --recorded")),
            Number("from pulse to pulse", "ms", 1.0, "thesis", 1e-9, ".3f",
                   lambda lab: 1e3 * step_of("azimuth time", f"{A2} --kind range --at-range 1300 --recorded")(lab)),
            Number("magnitude", "mV", 2.1282e-4, "thesis", 1e-8, ".4e",
                   at_strongest("magnitude", f"{A2} --kind pulse --recorded", 1e3)),
            Number("phase, classic profile", "deg", -101.15, "thesis", 0.005, ".2f",
                   at_strongest("phase", f"{A2} --kind pulse --recorded --profile classic")),
        ],
    ),
    Figure(
        "A.8",
        "Magnitude after range compression",
        [f"sarsim plot {A2} --simulation 2 --show magnitude {SIZE} -o figure_a8.png"],
        "A rectangle correlated with itself is a triangle. Its peak keeps magnitude and phase of the raw echo.",
        [
            Number("peak at", "m", 1000.0, "thesis", 1.0, ".1f",
                   at_strongest("slant range", f"{A2} --simulation 2 --kind pulse --rate 4e8 --recorded")),
            Number("peak over raw magnitude", "1", 1.0, "thesis", 1e-3, ".4f",
                   ratio("magnitude", f"{A2} --simulation 2 --kind pulse --rate 4e8 --recorded",
                         f"{A2} --kind pulse --recorded", lambda a, b: a / b)),
            Number("turn of the phase", "deg", 0.0, "thesis", 1e-3, ".4f",
                   ratio("phase", f"{A2} --simulation 2 --kind pulse --rate 4e8 --recorded",
                         f"{A2} --kind pulse --recorded", lambda a, b: a - b)),
        ],
    ),
    Figure(
        "A.11",
        "Two targets 8 m apart, raw",
        [f"sarsim plot {A3} --kind pulse --at-time 0 {SIZE} -o figure_a11.png"],
        "The real part of one pulse. The two echoes, each 375 m long, interfere: slow and fast beats, but no sign of two"
        " targets.",
        [
            Number("length of both together", "m", 382.74, "2.5 µs · c/2 + 8 m", 0.8, ".1f",
                   length(f"{A3} --kind pulse --at-time 0 --rate 4e8 --recorded", 0.25)),
        ],
    ),
    Figure(
        "A.12",
        "The same, compressed",
        [f"sarsim plot {A3} --simulation 2 --kind pulse --at-time 0 --show magnitude --mark-peaks 2 {SIZE} -o figure_a12.png"],
        "Two peaks, at the places of the two targets. Their sidelobes overlap, which shifts each by a few centimetres.",
        [
            Number("first peak", "m", 300.0, "thesis", 0.1, ".2f",
                   peak_between(f"{A3} --simulation 2 --kind pulse --at-time 0 --recorded", 296.0, 304.0)),
            Number("second peak", "m", 308.0, "thesis", 0.1, ".2f",
                   peak_between(f"{A3} --simulation 2 --kind pulse --at-time 0 --recorded", 304.0, 312.0)),
            Number("width 3.92 dB below the peak", "m", 1.5, "thesis", 0.1, ".2f",
                   width_at(f"{A3} --simulation 2 --kind pulse --at-time 0 --recorded", 296.0, 304.0, 2.0 / math.pi)),
        ],
    ),
    Figure(
        "A.13",
        "Phase from pulse to pulse",
        [f"sarsim plot {A3} --simulation 2 --kind phase --at-range 300 --size 800 640 -o figure_a13.png"],
        "The first target moves away by 5 cm from pulse to pulse and its phase falls evenly. The lower panel is the same as"
        " a distance. The thesis' value belongs to c = 3e8 m/s; the other target's sidelobes add half a percent.",
        [
            Number("pulses", "1", 9, "thesis", 0, "d",
                   lambda lab: len(lab.table(f"{A3} --simulation 2 --kind phase --at-range 300")["Unwrapped phase"])),
            Number("step of the phase", "rad", -1.0472, "thesis", 0.008, ".3f",
                   mean_step_rad(f"{A3} --simulation 2 --kind phase --at-range 300")),
        ],
    ),
    Figure(
        "A.14",
        "Antenna pattern with a beam of 10 degrees",
        [f"sarsim plot {BEAM} --kind antenna --angles -45 45 {SIZE} -o figure_a14.png"],
        "One-way amplitude. The crosses are the half-power points, half a beam's width off the middle.",
        [
            Number("half the power at", "deg", 5.0, "thesis", 0.05, ".2f",
                   half_power(f"{BEAM} --kind antenna --angles -45 45")),
        ],
    ),
    Figure(
        "A.16",
        "A beam passes a target",
        [f"sarsim plot {A4} --kind range --at-range 2000 --show magnitude --profile classic {SIZE} -o figure_a16.png"],
        "Each pulse is one point: the passage draws the pattern with its sidelobes. As in the thesis sin(x)/x is the pattern"
        " of both ways together, which is what the classic profile has.",
        [
            Number("strongest at", "s", 1.875, "45°/(24°/s)", 1e-6, ".3f",
                   at_strongest("azimuth time", f"{A4} --kind range --at-range 2000 --recorded --profile classic")),
            Number("magnitude there", "mV", 7.9833e-5, "thesis", 1e-8, ".4e",
                   at_strongest("magnitude", f"{A4} --kind range --at-range 2000 --recorded --profile classic", 1e3)),
            Number("phase there", "deg", 180.0, "thesis", 0.1, ".1f",
                   at_strongest("phase", f"{A4} --kind range --at-range 2000 --recorded --profile classic")),
        ],
    ),
    Figure(
        "A.17",
        "The same after range compression",
        [f"sarsim plot {A4} --simulation 2 --kind range --at-range 1632.7 --show db --span 40 --profile classic {SIZE}"
         " -o figure_a17.png"],
        "In decibels the sidelobes can be read off. Compression changes nothing over slow time; in range it makes the"
        " rectangle of the raw echo a triangle (figure A.8), as wide at half its height as the echo is long.",
        [
            Number("first sidelobe", "dB", -13.5, "thesis", 0.3, ".2f",
                   first_side_lobe_db(f"{A4} --simulation 2 --kind range --at-range 1632.7 --recorded --profile classic")),
            Number("width in range", "m", 749.5, "thesis", 3.0, ".1f",
                   length(f"{A4} --simulation 2 --kind pulse --at-time 1.875 --range 600 2600 --rate 1e8 --recorded")),
        ],
    ),
    Figure(
        "point",
        "Beyond the thesis: a point of the focused R",
        [
            f"sarsim focus {SAR} --out sar_r.img --quiet",
            "sarsim plot sar_r.img --kind range --at-range 10198.04 --azimuth -12 12 --show db --span 50 --mark-peaks 3"
            f" {SIZE} -o point.png",
        ],
        "A cut along the track through the point in the origin: its sidelobes are those of sin(x)/x. `sarsim measure` holds"
        " every point of an image against theory.",
        [
            Number("widths along the track differ from theory by", "1", 0.0, "theory", 0.01, ".4f", worst_width("azimuth")),
            Number("widths in range differ from theory by", "1", 0.0, "theory", 0.01, ".4f", worst_width("range")),
        ],
    ),
    Figure(
        "doppler",
        "Beyond the thesis: range-Doppler map",
        [f"sarsim plot {MOVING} --kind doppler --at-range 300 --size 800 640 -o doppler.png"],
        "The two targets of example A.3 over 32 pulses: two ranges, one speed. They recede, so the Doppler frequency is"
        " negative; the scale to the right says the speed.",
        [
            Number("Doppler frequency", "Hz", -166.78, "-2 · 50 m/s · 0.5 GHz/c", 1.0, ".1f",
                   steady_doppler_hz(f"{MOVING} --kind doppler --at-range 300")),
        ],
    ),
    Figure(
        "turning_ship",
        "Beyond the thesis: a turning ship",
        [
            SHIP_IMAGE,
            "sarsim plot ship.img --show db --span 40 --size 800 640 -o turning_ship.png",
        ],
        "Ten points of a ship that turns on the sea, imaged from stepped frequencies. `sarsim isar` prints where each was"
        " found and where it is.",
        [
            Number("points found", "1", 10, "script", 0, "d",
                   of_report(SHIP_IMAGE, lambda ship: sum(t["found"] is not None for t in ship["images"][0]["targets"]))),
            Number("farthest from its place", "m", 0.0, "script", 0.05, ".3f", of_report(SHIP_IMAGE, worst_place_of_ship)),
        ],
    ),
    Figure(
        "search",
        "Beyond the thesis: the picture of a search radar",
        [
            SEARCH,
            "sarsim plot ppi.img --show db --span 40 --size 760 680 -o search.png",
        ],
        "A ship, an aircraft and the noise of the receiver on the plan of a rotating antenna, north up. The table of detections"
        " is written beside the picture.",
        [
            Number("ship's distance", "m", 10000.0, "script", 20.0, ".0f",
                   of_report(SEARCH, lambda plan: plan["targets"][0]["strongest"]["range_m"])),
            Number("aircraft's, after 1.8985 s", "m", 15000.0 - 240.0 * 1.8985 - 4803.2 * 10e-6 * CELL_M, "15 km - vt - fd/K·c/2",
                   20.0, ".0f",
                   of_report(SEARCH, lambda plan: plan["targets"][1]["strongest"]["range_m"])),
            Number("its azimuth", "deg", 323.13, "script", 1.0, ".1f",
                   of_report(SEARCH, lambda plan: plan["targets"][1]["strongest"]["azimuth_deg"])),
            Number("its speed, folded", "m/s", -40.0, "-240 m/s + 2 λ·PRF/2", 2.0, ".1f",
                   of_report(SEARCH, lambda plan: plan["targets"][1]["strongest"]["speed_mps"])),
        ],
    ),
    Figure(
        "moving",
        "Beyond the thesis: moving targets in clutter",
        [
            MAPS,
            "sarsim plot mti.img --show db --span 60 --size 800 640 -o moving.png",
        ],
        "Stationary objects are on the zero-Doppler line, the car above it at the same range as a house that is"
        " much stronger.",
        [
            Number("car's Doppler frequency", "Hz", 1000.0, "2·15 m/s/λ", 2.0, ".1f",
                   of_report(MAPS, lambda maps: maps["targets"][1]["strongest"]["doppler_hz"])),
            Number("house over car", "dB", 10.0 * math.log10(1000.0 / 5.0), "cross-sections", 1.0, ".1f",
                   of_report(MAPS, lambda maps: 20.0 * math.log10(maps["targets"][0]["strongest"]["magnitude_v"]
                                                                  / maps["targets"][1]["strongest"]["magnitude_v"]))),
        ],
    ),
    Figure(
        "aircraft",
        "Beyond the thesis: range profiles of an aircraft",
        [
            PROFILES,
            "sarsim plot aircraft.img --show db --span 50 --size 800 640 -o aircraft.png",
        ],
        "Three turns of the antenna see the aircraft come nearer; its speed is found in the echoes.",
        [
            Number("speed found in the second scan", "m/s", -191.74, "script, a part of the aircraft", 0.3, ".2f",
                   of_report(PROFILES, lambda profiles: profiles["scans"][1]["speed_mps"])),
        ],
    ),
    Figure(
        "steps",
        "Beyond the thesis: a profile from stepped frequencies",
        [STEPS, f"sarsim plot {STEPS_VIEW} --show db --span 60 --mark-peaks 4 --size 640 280 -o steps.png"],
        "64 pulses on 64 carriers, each too narrow-band to resolve targets less than 15 m apart, make one"
        " profile 320 MHz wide: four targets within 9 m. A Hamming window keeps their sidelobes 40 dB down.",
        [
            *(
                Number(f"target at {place} m", "m", place, "script", 0.05, ".2f",
                       after(STEPS, peak_between(STEPS_VIEW, place - 0.5, place + 0.5)))
                for place in (3000, 3003, 3004.5, 3009)
            ),
            Number("width at half power", "m", 1.303 * 0.149896229 / 0.32, "1.303 c/2B", 0.03, ".3f",
                   after(STEPS, width_at(STEPS_VIEW, 2999.5, 3000.5, math.sqrt(0.5)))),
        ],
    ),
    Figure(
        "sent",
        "Beyond the thesis: the pulse that is sent",
        [f"sarsim plot {A3} --kind sent --span 40 --size 800 640 -o sent.png"],
        "The chirp of example A.3 and its spectrum, flat over the swept bandwidth but for Fresnel's ripples.",
        [
            Number("width 6 dB below the largest", "MHz", 100.0, "bandwidth of the sweep", 3.0, ".1f",
                   lambda lab: 1e-6 * band_hz(f"{A3} --kind sent --span 40", -6.0)(lab)),
        ],
    ),
    Figure(
        "barker",
        "Beyond the thesis: a Barker code and chirps",
        [
            f"sarsim plot {BARKER} --simulation {n} --kind pulse --show db --span 60 --range 27500 38500 --title '{title}'"
            f" --size 800 320 -o {name}.png"
            for n, title, name in (
                (1, "Barker code of 13 chips", "barker"),
                (2, "Chirp of the same band", "barker_chirp"),
                (4, "Chirp of ten times the band, Hamming window", "barker_window"),
            )
        ],
        "The same energy three times, compressed. Of the ship to the left the code has even sidelobes of 1/13, the chirp fewer"
        " and higher ones, which a window lowers; chirps can be made finer at will. The aircraft to the right moves so fast that"
        " the phase turns by half a turn within the pulse: the code falls apart, the chirps only shift.",
        [
            Number("highest sidelobe, code", "dB", -20.0 * math.log10(13.0), "1/13", 0.01, ".2f",
                   side_lobe_db(f"{BARKER} {SHIP}", 28000.0, 32000.0)),
            Number("highest sidelobe, chirp of B·Tp 13", "dB", compressed_chirp(13.0)[0], "sin(πx(1 - x/n))/(πx)", 0.05, ".2f",
                   side_lobe_db(f"{BARKER} --simulation 2 {SHIP}", 28000.0, 32000.0)),
            Number("highest sidelobe, chirp of B·Tp 130", "dB", compressed_chirp(130.0)[0], "the same", 0.05, ".2f",
                   side_lobe_db(f"{BARKER} --simulation 3 {SHIP}", 28000.0, 32000.0)),
            Number("width at half power, code", "m", (2.0 - math.sqrt(2.0)) * CELL_M, "triangle", 0.9, ".1f",
                   width_at(f"{BARKER} {SHIP}", 29000.0, 31000.0, math.sqrt(0.5))),
            Number("width at half power, chirp of B·Tp 13", "m", compressed_chirp(13.0)[1] * CELL_M, "sin(πx(1 - x/n))/(πx)", 0.5, ".1f",
                   width_at(f"{BARKER} --simulation 2 {SHIP}", 29000.0, 31000.0, math.sqrt(0.5))),
            Number("width at half power, chirp of B·Tp 130", "m", compressed_chirp(130.0)[1] * CELL_M / 10.0, "the same", 0.1, ".2f",
                   width_at(f"{BARKER} --simulation 3 {SHIP}", 29000.0, 31000.0, math.sqrt(0.5))),
            Number("aircraft over ship, code", "1", sinc(40027.7 * 13e-6), "sinc(fd·Tp)", 1e-3, ".4f",
                   lambda lab: highest_between(f"{BARKER} {JET}", 35900.0, 36100.0)(lab)
                   / highest_between(f"{BARKER} {SHIP}", 29900.0, 30100.0)(lab)),
            Number("aircraft is shown at, B·Tp 130", "m", 36000.0 - 40027.7 * 13e-6 * CELL_M / 10.0, "-fd/K·c/2", 0.2, ".2f",
                   peak_between(f"{BARKER} --simulation 3 {JET}", 35900.0, 36100.0)),
        ],
    ),
    Figure(
        "motion",
        "Beyond the thesis: an aircraft that the wind pushes about",
        [
            FOCUS_MOTION,
            f"sarsim plot motion.img {STRIP_VIEW} --title 'Motion compensated' -o motion.png",
            f"sarsim focus {STRIP} --motion-compensation none --out strayed.img --quiet",
            f"sarsim plot strayed.img {STRIP_VIEW} --title 'Not compensated' -o motion_none.png",
        ],
        "Nine points of a strip, seen from an aircraft that leaves its line by a metre, which is 30 wavelengths. Where"
        " that is not removed from the echoes, the points are smeared along the track by up to 50 m.",
        [
            Number("points found", "1", 9, "script", 0, "d", lambda lab: found_targets(lab, FOCUS_MOTION)),
            Number("farthest from its place", "m", 0.0, "theory", 0.02, ".3f", lambda lab: worst_place(lab, FOCUS_MOTION)),
            Number("widths along the track differ from theory by", "1", 0.0, "theory", 0.01, ".4f",
                   worst_width("azimuth", FOCUS_MOTION)),
        ],
    ),
    Figure(
        "spotlight",
        "Beyond the thesis: spotlight",
        [
            FOCUS_SPOT,
            "sarsim plot spotlight.img --show db --span 40 --azimuth -26 26 --range 7974 8026 --colours ember"
            " --size 520 560 -o spotlight.png",
            f"sarsim plot spotlight.img {PAIR} --show db --span 40 --mark-peaks 2 --size 800 320 -o spotlight_pair.png",
            FOCUS_STRIP,
            f"sarsim plot strip.img {PAIR} --show db --span 40 --mark-peaks 1 --size 800 320 -o spotlight_strip.png",
        ],
        "A beam that is held on a place sees it for longer, and resolves it more finely than half the antenna's length. The cuts go"
        " through the two points in the middle, half a metre apart: two peaks with the beam held, one with the same antenna"
        " looking sideways. The sidelobes of each move the other's peak by 4 cm.",
        [
            Number("width along the track", "m", 0.8859 * 0.0299792458 * 8000.0 / (2.0 * 450.0), "0.886 λR/(2·450 m)", 0.003,
                   ".3f", of_target(4, FOCUS_SPOT, "azimuth", "width_m")),
            Number("width in range", "m", 0.8859 * 0.149896229 / 0.3, "0.886 c/2B", 0.003, ".3f",
                   of_target(4, FOCUS_SPOT, "range", "width_m")),
            Number("highest sidelobe along the track", "dB", -13.26, "sin(x)/x", 0.2, ".2f",
                   of_target(10, FOCUS_SPOT, "azimuth", "pslr_db")),
            Number("point 100 m off over that nearest in the ring", "dB",
                   20.0 * math.log10((math.sin(1.3196) / 1.3196) ** 2), "pattern, out and back", 0.2, ".2f",
                   lambda lab: 20.0 * math.log10(of_target(15, FOCUS_SPOT, "amplitude_v")(lab)
                                                 / of_target(7, FOCUS_SPOT, "amplitude_v")(lab))),
            Number("peaks of the pair", "1", 2, "half a metre apart", 0, "d",
                   peaks_above(FOCUS_SPOT, f"spotlight.img {PAIR}", 0.5)),
            Number("with the beam sideways", "1", 1, "half a metre apart", 0, "d",
                   peaks_above(FOCUS_STRIP, f"strip.img {PAIR}", 0.5)),
        ],
    ),
    Figure(
        "functions",
        "Beyond the thesis: pulse, intervals and antenna of one's own",
        [
            f"sarsim plot {OWN_PULSE} --show db --span 50 --title 'Frank code, cosecant-squared antenna' --size 800 320"
            " -o functions_own.png",
            f"sarsim plot {OWN_PULSE} --simulation 2 --show db --span 50 --title 'Chirp, no antenna' --size 800 320"
            " -o functions_plain.png",
            f"sarsim plot {OWN_PHASE} --pulses 12 --wrapped --size 800 520 -o functions_phase.png",
        ],
        "Four targets at one height: an antenna that is given by points makes them equally strong, a code that is given by"
        " points has its own sidelobes. The one 20 km away moves at a blind speed of 1 ms, where the phase is level;"
        " the other two intervals, 1.2 and 1.1 ms, show that it moves.",
        [
            Number("farthest over nearest, own antenna", "1", 1.0, "sin²/sin² of one height", 0.002, ".4f",
                   lambda lab: highest_between(f"{OWN_PULSE} --recorded", 39500.0, 40500.0)(lab)
                   / highest_between(f"{OWN_PULSE} --recorded", 9500.0, 10500.0)(lab)),
            Number("farthest over nearest, none", "1", 1.0 / 16.0, "1/R²", 1e-3, ".4f",
                   lambda lab: highest_between(f"{OWN_PULSE} --simulation 2 --rate 1e8 --recorded", 39500.0, 40500.0)(lab)
                   / highest_between(f"{OWN_PULSE} --simulation 2 --rate 1e8 --recorded", 9500.0, 10500.0)(lab)),
            Number("highest sidelobe, code", "dB", 20.0 * math.log10(math.sqrt(2.0) / 16.0), "√2/16", 0.01, ".2f",
                   side_lobe_db(f"{OWN_PULSE} --rate 1e8 --recorded", 26000.0, 34000.0)),
            Number("highest sidelobe, chirp of B·Tp 16", "dB", compressed_chirp(16.0)[0], "sin(πx(1 - x/n))/(πx)", 0.05, ".2f",
                   side_lobe_db(f"{OWN_PULSE} --simulation 2 --rate 1e8 --recorded", 26000.0, 34000.0)),
            *(
                Number(f"turn of the phase in {milliseconds} ms", "deg", expected, "4πv·PRI/λ, less whole turns", 0.1, ".2f",
                       phase_step_deg(OWN_PHASE, pulse))
                for pulse, milliseconds, expected in ((0, "1", 0.0), (1, "1.2", 72.0), (2, "1.1", 36.0))
            ),
        ],
    ),
    Figure(
        "surface",
        "Beyond the thesis: surfaces, front and back",
        [
            f"sarsim plot {PLATE} --show db --span 60 --title 'Turning plate, wavelength 3 m' --size 800 320"
            " -o surface_long.png",
            f"sarsim plot {PLATE} --simulation 2 --time -1 1 --show db --span 40 --title 'The same, wavelength 0.5 m'"
            " --size 640 280 -o surface_short.png",
            f"sarsim plot {SURFACE} --simulation 3 --kind profile --title 'Ridge, from 45 degrees above' --size 800 320"
            " -o surface_ridge.png",
        ],
        "A plate of 20 m by 20 m turns once in 10 s. Its front draws the pattern of an antenna of its size; its back is silent."
        " At a shorter wavelength the points that a surface is made of produce grating lobes. The slopes of a ridge, as"
        " long as each other, are bright and short where they face the radar, dim and long behind.",
        [
            Number("cross-section facing the radar", "dB above 1 m²", 10.0 * math.log10(390.0 * 400.0), "390 points · area", 0.02,
                   ".2f",
                   lambda lab: 20.0 * math.log10(
                       at_strongest("magnitude", f"{PLATE} --recorded")(lab)
                       * (4.0 * math.pi) ** 1.5 * 5000.0**2 / (3.0 * math.sqrt(1000.0)))),
            Number("first null after", "s", math.degrees(math.asin(3.0 / 40.0)) / 36.0, "asin(λ/2L)/36°/s", 0.003, ".3f",
                   first_null_s(f"{PLATE} --recorded")),
            Number("first sidelobe", "dB", -13.26, "sin(x)/x", 0.2, ".2f", first_side_lobe_db(f"{PLATE} --recorded")),
            Number("largest echo of the back", "V", 0.0, "cosine law", 0.0, ".1f",
                   lambda lab: strongest_between_s(f"{PLATE} --recorded", 2.501, 5.0)(lab)[1]),
            Number("first grating lobe, wavelength 0.5 m, after", "s",
                   math.degrees(math.asin(0.5 / (2.0 * 20.0 / 21.0))) / 36.0, "asin(λ/2d)/36°/s", 0.003, ".3f",
                   lambda lab: strongest_between_s(f"{PLATE} --simulation 2 --recorded", 0.2, 0.6)(lab)[0]),
            Number("ridge's echo ends, 60 m beside its middle", "m", math.sqrt(60.0**2 + 5040.0**2 + 5000.0**2), "distance",
                   0.5, ".1f", ends(f"{SURFACE} --simulation 3 --kind pulse --at-time -0.6", 7060.0, 7090.0)),
        ],
    ),
    Figure(
        "satellite",
        "Beyond the thesis: three reflectors from an orbit",
        [
            FOCUS_ORBIT,
            "sarsim plot satellite.img --show db --span 40 --azimuth -140 90 --range 826580 827000 --colours ember"
            " --size 640 560 -o satellite.png",
        ],
        "Sentinel-1 looks at three corner reflectors, given by latitude, longitude and height, from 827 km. The orbit comes from"
        " a file, the Earth turns under it, and light takes 5.5 ms.",
        [
            Number("points found", "1", 3, "script", 0, "d", lambda lab: found_targets(lab, FOCUS_ORBIT)),
            Number("farthest from its place", "m", 0.0, "theory", 0.05, ".3f", lambda lab: worst_place(lab, FOCUS_ORBIT)),
            Number("widths along the orbit differ from theory by", "1", 0.0, "theory", 0.01, ".4f",
                   worst_width("azimuth", FOCUS_ORBIT)),
            Number("width in range", "m", 0.886 * LIGHT_SPEED / 2.0 / 80e6, "0.886 c/2B", 0.02, ".3f",
                   of_target(1, FOCUS_ORBIT, "range", "width_m")),
            Number("range of the first", "m", 826846.86, "integrated orbit, WGS 84", 0.05, ".2f",
                   of_target(1, FOCUS_ORBIT, "range_m")),
        ],
    ),
    Figure(
        "gusts",
        "Beyond the thesis: turbulence, and what the navigation believes",
        [
            RUN_GUSTS,
            BELIEF,
            FOCUS_GUSTS,
            f"sarsim plot believed.img {GUSTS_VIEW} --title 'With the navigation' -o gusts.png",
            FOCUS_GUSTS_NONE,
            f"sarsim plot straight.img {GUSTS_VIEW} --title 'As if it flew straight' -o gusts_none.png",
        ],
        "A light aircraft in moderate turbulence. The track that its inertial navigation believes is a metre off, but smooth: it"
        " makes sharp points, a little beside their places.",
        [
            Number("points beside their places with the navigation", "1", 3, "script", 0, "d",
                   after_gusts(lambda lab: displaced_targets(lab, FOCUS_GUSTS))),
            Number("their widths along the track differ from theory by", "1", 0.0, "theory", 0.02, ".4f",
                   after_gusts(worst_width("azimuth", FOCUS_GUSTS))),
            Number("a point's height over that of straight flight", "dB", 21.0, "12 to 30 dB", 9.0, ".1f",
                   after_gusts(lambda lab: 20.0 * math.log10(
                       peak_v(1, FOCUS_GUSTS)(lab) / peak_v(1, FOCUS_GUSTS_NONE)(lab)))),
        ],
    ),
    Figure(
        "ship in waves",
        "Beyond the thesis: a ship in waves",
        [
            WAVES_IMAGE,
            "sarsim plot waves.img --show db --span 40 --size 640 560 -o ship_in_waves.png",
        ],
        "The ship rolls in sea state 5. Its own motion makes the image: cross-range is height here, and the mast stands 30 m above"
        " the water.",
        [
            Number("turned by", "deg", 1.0461, "roll of the ship", 0.1, ".3f",
                   of_report(WAVES_IMAGE, lambda report: math.degrees(report["images"][0]["turn_rad"]))),
            Number("place of the mast's top", "m", 30.0, "its height", 1.5, ".2f",
                   of_report(WAVES_IMAGE, lambda report: report["images"][0]["targets"][10]["cross_range_m"]
                             + report["images"][0]["targets"][10]["found"]["cross_range_error_m"])),
        ],
    ),
    Figure(
        "helicopter",
        "Beyond the thesis: the rotor of a helicopter",
        [
            f"sarsim plot {FLASHES} --size 800 320 -o helicopter.png",
            f"sarsim plot {ROTOR} --kind doppler-time --at-range 3000 --padding 4 --size 800 600 -o helicopter_doppler.png",
        ],
        "Three blades flash when they are across the line of sight, six times a turn. Their Doppler frequencies reach those of the"
        " tips, which go to and fro as a sine; the line at 0 is the fuselage.",
        [
            Number("the second flash is at", "s", 1.0 / 30.0, "1/(2 N f)", 2e-4, ".4f",
                   lambda lab: strongest_between_s(f"{FLASHES} --recorded", 0.01, 0.05)(lab)[0]),
            Number("the third", "s", 2.0 / 30.0, "2/(2 N f)", 2e-4, ".4f",
                   lambda lab: strongest_between_s(f"{FLASHES} --recorded", 0.05, 0.08)(lab)[0]),
            Number("Doppler frequencies up to", "Hz", 2.0 * 10.0 * math.pi * 6.0 * 3e9 / LIGHT_SPEED, "2 Ω L/λ", 60.0, ".0f",
                   highest_doppler_hz(f"{ROTOR} --kind doppler --at-range 3000")),
        ],
    ),
    Figure(
        "formation",
        "Beyond the thesis: a formation in a turn",
        [
            TURN,
            "sarsim plot turn.img --show db --span 60 --range 10000 11100 --size 640 560 -o formation.png",
        ],
        "Four aircraft in a turn to the left: the one on the inner circle is slower, the one on the outer circle faster, and the last"
        " one is not as far around.",
        [
            *(
                Number(f"speed of {name}", "m/s", speed, "v (R + d)/R along the line of sight", 0.1, ".2f",
                       of_report(TURN, lambda report, n=number: report["targets"][n - 1]["strongest"]["speed_mps"]))
                for number, name, speed in FORMATION
            ),
        ],
    ),
]

# Examples without a figure, by their names, and what each shows.
OTHERS = {
    "helicopter_blades.csv": "the points of the blades of helicopter.toml",
    "satellite.EOF": "the orbit of satellite.toml",
}
