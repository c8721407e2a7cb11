"""The transmitted pulse against the time after its leading edge: docs/theory/echo-model.md, "Pulse"; thesis 4.4."""

import numpy as np

BARKER_CODES = ("+-", "++-", "++-+", "+++-+", "+++--+-", "+++---+--+-", "+++++--++-+-+")  # Skolnik, ch. 8.
EDGE = 1e-9  # Of a sampling interval: what is closer to an edge counts as on it.
CUTOFF, TAPER, FILTER_LENGTH = 0.92, 14.0, 28.0  # Fc/F, beta and Th F of docs/decisions/0005-band-limited-pulse.md.
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


class Shape:
    """The pulse of a radar: bare, with its envelope, and as it is transmitted (ideal or band-limited)."""

    def __init__(self, pulse, sampling_hz, classic):
        self.pulse = pulse
        self.sampling_hz = sampling_hz
        self.classic = classic
        self.width_s = pulse.width_ns * 1e-9
        self.code = np.array([1.0 if sign == "+" else -1.0 for sign in BARKER_CODES[pulse.code]])

    @property
    def sweep_rate(self):
        """K = B/Tp of a chirp in Hz/s, else 0 (thesis 6.16)."""
        return self.pulse.bandwidth_ghz * 1e9 / self.width_s if self.pulse.kind == "CHIRP" else 0.0

    def bare(self, times, edge_s=0.0):
        """p(w) without envelope, as if it went on for ever."""
        if self.pulse.kind == "CHIRP":
            return np.exp(1j * np.pi * self.sweep_rate * (times - self.width_s / 2) ** 2)
        if self.pulse.kind == "BARKER":
            chips = np.floor((times + edge_s) * len(self.code) / self.width_s).astype(int)
            return self.code[np.clip(chips, 0, len(self.code) - 1)].astype(complex)
        if self.pulse.kind == "OTHER_PULSE":
            x = times / self.width_s
            return self.pulse.in_phase.gain(x, self.classic) + 1j * self.pulse.quadrature.gain(x, self.classic)
        return np.ones(times.shape, complex)

    def envelope(self, times):
        """1, straight ramps, or the user's function of w/Tp (thesis figure 4.5)."""
        if self.pulse.envelope == "OTHER":
            return self.pulse.envelope_curve.gain(times / self.width_s, self.classic)
        height = np.ones(times.shape)
        if self.pulse.envelope == "LINEAR" and self.pulse.rise_ns > 0:
            height = np.minimum(height, times / (self.pulse.rise_ns * 1e-9))
        if self.pulse.envelope == "LINEAR" and self.pulse.fall_ns > 0:
            height = np.minimum(height, (self.width_s - times) / (self.pulse.fall_ns * 1e-9))
        return np.maximum(height, 0.0)

    def ideal(self, times, interval_s):
        """Hard edges, on for 0 <= w < Tp ("Edge rule")."""
        edge = EDGE * interval_s
        on = (times >= -edge) & (times < self.width_s - edge)
        samples = np.zeros(times.shape, complex)
        samples[on] = self.bare(times[on], edge) * self.envelope(times[on])
        return samples

    def transmitted(self, times, interval_s):
        return self.band_limited(times, interval_s) if self.pulse.band_limited else self.ideal(times, interval_s)

    def nominal_bandwidth_hz(self):
        """Sweep of a chirp, code length/Tp, or 1/Tp, and never less than that (docs/decisions/physics-rules.md, 7)."""
        sweep = abs(self.pulse.bandwidth_ghz) * 1e9 if self.pulse.kind == "CHIRP" else 0.0
        chips = len(self.code) if self.pulse.kind == "BARKER" else 1
        return max(sweep, chips / self.width_s)

    def _corners(self):
        """Where the pulse jumps or bends, in ascending order."""
        corners = [0.0, self.width_s]
        if self.pulse.kind == "BARKER":
            corners += list(np.arange(1, len(self.code)) * self.width_s / len(self.code))
        if self.pulse.envelope == "LINEAR":
            corners += [self.pulse.rise_ns * 1e-9, self.width_s - self.pulse.fall_ns * 1e-9]
        curves = [self.pulse.envelope_curve] if self.pulse.envelope == "OTHER" else []
        curves += [self.pulse.in_phase, self.pulse.quadrature] if self.pulse.kind == "OTHER_PULSE" else []
        corners += [knot * self.width_s for curve in curves for knot in curve.knots if 0 < knot < 1]
        return np.unique(corners)

    def _quadrature(self, bandwidth_hz):
        """Nodes and weights of Gauss's rule between the corners, in pieces of three cycles of the band at most."""
        nodes, weights = [], []
        for begin, end in zip(self._corners()[:-1], self._corners()[1:]):
            pieces = max(1, int(np.ceil((end - begin) * bandwidth_hz / 3)))
            edges = np.linspace(begin, end, pieces + 1)
            half = np.diff(edges)[:, None] / 2
            nodes.append((edges[:-1, None] + half + half * NODES).ravel())
            weights.append((half * WEIGHTS).ravel())
        return np.concatenate(nodes), np.concatenate(weights)

    def band_limited(self, times, interval_s):
        """The ideal pulse behind the low-pass filter of docs/decisions/0005-band-limited-pulse.md."""
        own_band = self.pulse.oversampling > 1
        band = self.nominal_bandwidth_hz() if own_band else self.sampling_hz
        reach = FILTER_LENGTH / (band / 2)
        near = (times > -reach) & (times < self.width_s + reach)
        if own_band:  # Then it is cut to a kept width about its middle.
            kept = self.pulse.kept_width * self.width_s / 2
            near &= times >= self.width_s / 2 - kept - EDGE * interval_s
            near &= times < self.width_s / 2 + kept - EDGE * interval_s
        nodes, weights = self._quadrature(max(band, self.nominal_bandwidth_hz()))
        heights = self.bare(nodes) * self.envelope(nodes) * weights
        samples = np.zeros(times.shape, complex)
        # Some samples at a time, and only the nodes within reach of them.
        for some in np.array_split(np.flatnonzero(near), max(1, near.sum() // 32)):
            if some.size == 0:
                continue
            first, last = np.searchsorted(nodes, [times[some].min() - reach, times[some].max() + reach])
            lag = times[some, None] - nodes[first:last]
            taper = np.exp(TAPER * (np.sqrt(np.clip(1 - (lag / reach) ** 2, 0, None)) - 1))
            response = np.where(np.abs(lag) <= reach, CUTOFF * band * np.sinc(CUTOFF * band * lag) * taper, 0.0)
            samples[some] = response @ heights[first:last]
        return samples
