"""Functions that a script gives by points (docs/theory/echo-model.md, "Functions given by points")."""

import functools

import numpy as np

REACH = 11  # Grid points that the low-pass filter reaches to either side.


class Curve:
    """One function y(x) of a kind (LINEAR, CUBIC, MFILTER) by its points; x and results are numbers or arrays.

    No points are zero everywhere, one point is a constant. Derivatives are known of LINEAR and CUBIC only, in the
    precision of x.
    """

    def __init__(self, kind, points):
        self.kind = kind
        self.points = [(float(x), float(y)) for x, y in points]
        self.knots = np.array([x for x, _ in self.points])
        self.heights = np.array([y for _, y in self.points])

    def value(self, x, classic=False):
        if self.kind == "MFILTER" and len(self.points) > 1:
            return self._low_pass_classic(np.asarray(x)) if classic else self._low_pass(np.asarray(x))
        return self.derivative(x, 0)

    def gain(self, x, classic=False):
        """A gain: beyond the points it keeps the value of the nearer end; classic goes on as its kind does."""
        if classic or len(self.points) < 2:
            return self.value(x, classic)
        return self.value(np.clip(np.asarray(x), self.knots[0], self.knots[-1]))

    def at_angle(self, degrees, in_azimuth, classic=False):
        """A cut through an antenna, of a signed angle up to half a turn; classic takes its magnitude."""
        if classic or len(self.points) < 2 or (self.knots[0] >= 0 and self.knots[-1] <= 180):
            return self.gain(abs(degrees), classic)
        if in_azimuth and self._round is not None:
            return self._round.value(degrees)
        if not self.knots[0] <= degrees <= self.knots[-1]:
            middle = (self.knots[0] + self.knots[-1]) / 2
            degrees = min((degrees + turn for turn in (-360, 0, 360)), key=lambda angle: abs(angle - middle))
        return self.gain(degrees)

    @functools.cached_property
    def _round(self):
        """The points of many turns, where they may be interpolated across the gap behind; otherwise None."""
        gap = 360 - (self.knots[-1] - self.knots[0])
        closed = abs(gap) < 1e-9
        steps, wide = closed and self.heights[0] != self.heights[-1], gap > 2 * np.diff(self.knots).max() + 1e-9
        if gap < -1e-9 or steps or (wide and not closed):
            return None
        points = self.points[:-1] if closed else self.points
        turns = [(x + 360 * turn, y) for turn in range(-40, 40) for x, y in points]
        return Curve(self.kind, [*turns, (points[0][0] + 360 * 40, points[0][1])])

    def derivative(self, x, order):
        """Of order 0 to 3."""
        x = np.asarray(x, np.longdouble if isinstance(x, np.longdouble) else float)
        if len(self.points) < 2:
            return np.full(x.shape, self.heights[0] if len(self.points) == 1 and order == 0 else 0.0)
        return {"LINEAR": self._linear, "CUBIC": self._cubic}[self.kind](x, order)

    def _piece(self, x):
        """Number of the piece that x lies in; a point belongs to the right one, what is outside to the outer ones."""
        # Much sooner for a single number than np.clip.
        return np.minimum(np.maximum(self.knots.searchsorted(x, side="right") - 1, 0), len(self.points) - 2)

    @functools.cache
    def _in_precision(self, kind):
        """Knots, heights, widths and slopes of the pieces as numbers of a kind."""
        heights, knots = self.heights.astype(kind), self.knots.astype(kind)
        return knots, heights, np.diff(knots), np.diff(heights) / np.diff(knots)

    def _linear(self, x, order):
        i = self._piece(x + 4e-16 * np.maximum(np.abs(x), np.abs(self.knots[-1])))
        knots, heights, _, slopes = self._in_precision(x.dtype)
        slope = slopes[i]
        return heights[i] + slope * (x - knots[i]) if order == 0 else slope if order == 1 else 0 * slope

    @functools.cached_property
    def _knot_slopes(self):
        """Of the clamped spline: those of the outer chords at the ends, continuous second derivatives between."""
        heights, knots = self.heights.astype(np.longdouble), self.knots.astype(np.longdouble)
        width, count = np.diff(knots), len(self.points)
        chord = np.diff(heights) / width
        diagonal, right = np.ones(count, np.longdouble), np.concatenate([chord[:1], chord])
        for k in range(1, count - 1):  # Elimination from the left; row k links its slope with those beside it.
            share = 1 / width[k - 1] / diagonal[k - 1]
            above = 0 if k == 1 else 1 / width[k - 1]
            diagonal[k] = 2 / width[k - 1] + 2 / width[k] - share * above
            right[k] = 3 * (chord[k - 1] / width[k - 1] + chord[k] / width[k]) - share * right[k - 1]
        for k in range(count - 2, 0, -1):
            right[k] = (right[k] - right[k + 1] / width[k]) / diagonal[k]
        return right

    def _cubic(self, x, order):
        knots, heights, widths, chords = self._in_precision(x.dtype)
        slopes, i = self._knot_slopes.astype(x.dtype), self._piece(x)
        width, begin, end = widths[i], slopes[i], slopes[i + 1]
        chord, u = chords[i], x - knots[i]
        square = (3 * chord - 2 * begin - end) / width
        cube = (begin + end - 2 * chord) / width**2
        inside = (
            heights[i] + u * (begin + u * (square + u * cube)),
            begin + u * (2 * square + 3 * u * cube),
            2 * square + 6 * u * cube,
            6 * cube,
        )[order]
        for outside, k in ((x < knots[0], 0), (x >= knots[-1], -1)):
            line = (heights[k] + slopes[k] * (x - knots[k]), slopes[k], 0.0, 0.0)[order]
            inside = np.where(outside, line, inside)
        return inside

    def _spacing(self):
        return (self.knots[-1] - self.knots[0]) / (len(self.points) - 1)

    def _bins(self, places):
        """Mean height of the points nearest to each whole number, by that number; half way counts downwards."""
        numbers = np.ceil(places - 0.5 - 1e-9).astype(int)
        return {k: self.heights[numbers == k].mean() for k in numbers}

    def _low_pass(self, x):
        """Tapered sinc on a grid anchored at the first point, normalised, the ends held."""
        spacing, count = self._spacing(), len(self.points)
        means = self._bins((self.knots - self.knots[0]) / spacing)
        between = Curve("LINEAR", self.points)
        grid = np.array([means.get(k, between.value(self.knots[0] + k * spacing)) for k in range(count)], float)
        u = np.clip((x - self.knots[0]) / spacing, 0, count - 1)
        total, weights = np.zeros(u.shape), np.zeros(u.shape)
        for step in range(-REACH, REACH + 2):
            k = np.floor(u).astype(int) + step
            z = u - k
            weight = np.where(np.abs(z) < REACH, np.sinc(z) * (1 + np.cos(np.pi * z / REACH)) / 2, 0.0)
            total = total + weight * grid[np.clip(k, 0, count - 1)]
            weights = weights + weight
        return total / weights

    def _low_pass_classic(self, x):
        """Bare sinc of the 21 nearest points of a grid anchored at 0, empty grid points being zero."""
        means = self._bins(self.knots / self._spacing())
        u = x / self._spacing()
        nearest = np.floor(u + 0.5)
        return sum(np.where(np.abs(k - nearest) < REACH, height * np.sinc(u - k), 0.0) for k, height in means.items())
