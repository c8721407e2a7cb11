"""The expected image of a point, from the recorded samples and the true flight alone: back-projection by direct summation,
each echo through its own matched filter with the Doppler shift within the pulse (docs/theory/echo-model.md). Shares no
code with the program."""

import dataclasses

import numpy as np

LIGHT = 299792458.0


@dataclasses.dataclass
class Recording:
    """Raw echoes, a row for each pulse, and the antenna's position and velocity at the middle of each pulse; SI units."""

    samples: np.ndarray
    first_delay: float
    sample_rate: float
    carrier: float
    bandwidth: float
    pulse_width: float
    places: np.ndarray
    velocities: np.ndarray
    times: np.ndarray = None


def echo_terms(recording, point):
    """Delay of the middle of each pulse and Doppler factor, of a point at rest and an antenna without acceleration."""
    sight = np.asarray(point) - recording.places
    w = -recording.velocities  # Of the point, seen from the antenna.
    # Out: |r| = c s1. Home: the antenna has flown on.
    distance = np.linalg.norm(sight, axis=1)
    speed2 = np.sum(w * w, axis=1)
    delay = 2 * (LIGHT * distance + np.sum(sight * w, axis=1)) / (LIGHT**2 - speed2)
    home = sight + w * delay[:, None]
    home_distance = np.linalg.norm(home, axis=1)
    # d tau/dt0 of both ways.
    out_rate = np.sum(sight * w, axis=1) / distance
    home_rate = np.sum(home * w, axis=1) / home_distance
    slope = (1 + out_rate / LIGHT) / (1 - home_rate / LIGHT) - 1
    return delay, slope / (1 + slope)


def integrated(recording, point):
    """The mean over the pulses of the matched filter's output for this point, in volts; its phase is 0 for an echo with
    the phase -2 pi f0 tau. Also the mean of the magnitudes, which is the peak of an isolated point."""
    delay, doppler = echo_terms(recording, point)
    count = int(np.ceil(recording.pulse_width * recording.sample_rate)) + 1
    first = np.ceil((delay - recording.first_delay) * recording.sample_rate - 1e-9).astype(int)
    columns = first[:, None] + np.arange(count)[None, :]
    inside = (columns >= 0) & (columns < recording.samples.shape[1])
    values = np.take_along_axis(recording.samples, np.clip(columns, 0, recording.samples.shape[1] - 1), axis=1)
    times = recording.first_delay + columns / recording.sample_rate
    since = times - delay[:, None] - recording.pulse_width / 2
    sent = since * (1 - doppler[:, None])
    on = np.abs(sent) < recording.pulse_width / 2
    rate = recording.bandwidth / recording.pulse_width
    turns = 0.5 * rate * sent**2 - recording.carrier * doppler[:, None] * since
    filtered = np.where(on & inside, values * np.exp(-2j * np.pi * turns), 0).sum(axis=1) / on.sum(axis=1)
    whole = recording.carrier * delay
    peaks = filtered * np.exp(2j * np.pi * (whole - np.round(whole)))
    return peaks.mean(), np.abs(peaks).mean()


def distance_from_line(times, places, point):
    """Distance of a point from the straight line that fits a flight."""
    fit = np.polyfit(times - times.mean(), places, 1)
    along = fit[0] / np.linalg.norm(fit[0])
    off = point - fit[1]
    return float(np.linalg.norm(off - np.dot(off, along) * along))


def half_width(offsets, magnitudes):
    """Width at -3 dB about the largest of some magnitudes, by straight lines; None where it does not fall so far."""
    peak = int(np.argmax(magnitudes))
    level = magnitudes[peak] / np.sqrt(2)
    ends = []
    for step in (-1, 1):
        k = peak
        while 0 <= k + step < len(magnitudes) and magnitudes[k + step] > level:
            k += step
        if not 0 <= k + step < len(magnitudes):
            return None
        share = (magnitudes[k] - level) / (magnitudes[k] - magnitudes[k + step])
        ends.append(offsets[k] + share * (offsets[k + step] - offsets[k]))
    return ends[1] - ends[0]
