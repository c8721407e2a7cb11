"""Images of the program: ENVI headers beside NPY, and their values between samples."""

import dataclasses

import numpy as np


@dataclasses.dataclass
class Image:
    """A complex image and its axes."""

    values: np.ndarray
    first: tuple  # Azimuth, range.
    step: tuple
    centre: tuple  # Of the spectrum, cycles per metre.
    origin: np.ndarray
    along: np.ndarray
    carrier: float
    algorithm: str
    across: np.ndarray = None  # Of a grid of level ground; None: the second axis is the distance from the line.

    def place_of(self, point):
        """Azimuth and range of a point."""
        if self.across is not None:
            return float(np.dot(point - self.origin, self.along)), float(np.dot(point - self.origin, self.across))
        azimuth = float(np.dot(point - self.origin, self.along))
        return azimuth, float(np.linalg.norm(point - self.origin - azimuth * self.along))

    def point_at(self, place, near):
        """The point at the height of `near` at some coordinates: by Newton's method from it."""
        if self.across is not None:
            return self.origin + place[0] * self.along + place[1] * self.across
        point = np.array(near, dtype=float)
        for _ in range(30):
            a, r = self.place_of(point)
            across = (point - self.origin - a * self.along) / r
            matrix = np.array([[self.along[0], self.along[1]], [across[0], across[1]]])
            step = np.linalg.solve(matrix, [place[0] - a, place[1] - r])
            point[:2] += step
            if np.abs(step).max() < 1e-9 * (1 + abs(place[1])):
                break
        return point

    def index(self, place):
        """Row and column of a place."""
        return tuple((place[k] - self.first[k]) / self.step[k] for k in (0, 1))

    def holds(self, place):
        """Whether it lies between samples."""
        return all(0 <= i <= n - 1 for i, n in zip(self.index(place), self.values.shape))

    def at(self, place):
        """The value at a place: a tapered sinc about the centre of the spectrum."""
        rows, columns = (self.weights(k, i) for k, i in enumerate(self.index(place)))
        patch = self.values[rows[0] : rows[0] + len(rows[1]), columns[0] : columns[0] + len(columns[1])]
        return complex(rows[1] @ patch.astype(complex) @ columns[1])

    def weights(self, axis, index, reach=64):
        """First sample and weights of an axis."""
        count = self.values.shape[axis]
        low, high = max(int(index) - reach, 0), min(int(index) + reach + 1, count)
        off = np.arange(low, high) - index
        u = np.clip(off / reach, -1, 1) * np.pi / 2
        taper = 0.42 + 0.5 * np.cos(2 * u) + 0.08 * np.cos(4 * u)
        turns = self.centre[axis] * self.step[axis] * off
        return low, np.sinc(off) * taper * np.exp(-2j * np.pi * turns)

    def carrier_between(self, place, other):
        """Factor that carries a value from one place to another nearby, by the centre of the spectrum."""
        turns = sum(self.centre[k] * (other[k] - place[k]) for k in (0, 1))
        return np.exp(2j * np.pi * turns)


def read(path):
    """An image in NPY with its header."""
    fields = {}
    with open(str(path)[: -len(".npy")] + ".hdr", encoding="utf-8") as header:
        for line in header:
            if " = " in line:
                name, value = line.rstrip("\n").split(" = ", 1)
                fields[name.strip()] = value.strip().strip("{}").strip()
    number = {k: fields[k] for k in fields}
    vector = lambda name: np.array([float(x) for x in number[name].split(",")])
    return Image(
        values=np.load(path, mmap_mode="r"),
        first=(float(number["azimuth first m"]), float(number["range first m"])),
        step=(float(number["azimuth step m"]), float(number["range step m"])),
        centre=(float(number["azimuth spectrum centre per m"]), float(number["range spectrum centre per m"])),
        origin=vector("origin m"),
        along=vector("along"),
        carrier=float(number["carrier hz"]),
        algorithm=number["algorithm"],
        across=vector("across") if fields.get("image plane", "").startswith("ground") else None,
    )
