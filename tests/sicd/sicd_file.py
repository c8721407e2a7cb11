"""Reads SICD files with the standard library and NumPy alone: container, pixels, geometry by ranges and their rates."""

import xml.etree.ElementTree as ElementTree

import numpy as np

LIGHT_MPS = 299792458.0


class SicdFile:
    """A file as MIL-STD-2500C lays it out, with the XML text of its first extension."""

    def __init__(self, path):
        self.bytes = path.read_bytes()
        data = self.bytes
        assert data[:9] == b"NITF02.10"
        assert int(data[342:354]) == len(data), "the file's length"
        header = int(data[354:360])
        at, self.images = header, []
        place = 360
        images, place = int(data[place : place + 3]), place + 3
        lengths = [
            (int(data[place + 16 * i : place + 16 * i + 6]), int(data[place + 16 * i + 6 : place + 16 * i + 16]))
            for i in range(images)
        ]
        place += 16 * images
        assert data[place : place + 9] == b"000000000"
        place += 9
        assert data[place : place + 3] == b"001"
        extension = (int(data[place + 3 : place + 7]), int(data[place + 7 : place + 16]))
        assert place + 16 + 3 + 5 + 5 == header
        for subheader, length in lengths:
            self.images.append((data[at : at + subheader], at + subheader, length))
            at += subheader + length
        self.extension = data[at : at + extension[0]]
        text = data[at + extension[0] : at + sum(extension)]
        assert at + sum(extension) == len(data)
        self.root = ElementTree.fromstring(text)

    def text(self, path):
        return self.root.find("/".join("{*}" + name for name in path.split("/"))).text

    def number(self, path):
        return float(self.text(path))

    def vector(self, path):
        return np.array([self.number(f"{path}/{axis}") for axis in "XYZ"])

    def polynomial(self, path):
        node = self.root.find("/".join("{*}" + name for name in path.split("/")))
        if "order2" not in node.attrib:
            terms = np.zeros(int(node.get("order1")) + 1)
            for term in node:
                terms[int(term.get("exponent1"))] = float(term.text)
            return terms
        terms = np.zeros((int(node.get("order1")) + 1, int(node.get("order2")) + 1))
        for term in node:
            terms[int(term.get("exponent1")), int(term.get("exponent2"))] = float(term.text)
        return terms

    def pixels(self):
        columns = int(self.text("ImageData/NumCols"))
        parts = [np.frombuffer(self.bytes, ">c8", length // 8, start) for _, start, length in self.images]
        return np.concatenate(parts).reshape(-1, columns).astype("c16")

    def coordinates(self, row, column):
        """Of a pixel: metres from the reference point."""
        return (
            (row - self.number("ImageData/SCPPixel/Row")) * self.number("Grid/Row/SS"),
            (column - self.number("ImageData/SCPPixel/Col")) * self.number("Grid/Col/SS"),
        )

    def antenna(self, time):
        """Position and velocity, ECF."""
        poly = np.polynomial.polynomial
        terms = [self.polynomial(f"Position/ARPPoly/{axis}") for axis in "XYZ"]
        return (
            np.array([poly.polyval(time, t) for t in terms]),
            np.array([poly.polyval(time, poly.polyder(t)) for t in terms]),
        )

    def contour(self, row, column):
        """What the standard says of a pixel (Volume 3): time, range and range rate at the middle of its aperture."""
        poly = np.polynomial.polynomial
        x, y = self.coordinates(row, column)
        time = poly.polyval2d(x, y, self.polynomial("Grid/TimeCOAPoly"))
        place, velocity = self.antenna(time)
        if self.text("Grid/Type") == "RGZERO":
            nearest = self.number("RMA/INCA/R_CA_SCP") + x
            passed = time - poly.polyval(y, self.polynomial("RMA/INCA/TimeCAPoly"))
            speed = np.linalg.norm(self.antenna(time - passed)[1])
            factor = poly.polyval2d(x, y, self.polynomial("RMA/INCA/DRateSFPoly"))
            distance = np.sqrt(nearest**2 + factor * (speed * passed) ** 2)
            return time, distance, factor * speed**2 * passed / distance
        point = self.vector("GeoData/SCP/ECF") + x * self.vector("Grid/Row/UVectECF") + y * self.vector("Grid/Col/UVectECF")
        sight = point - place
        return time, np.linalg.norm(sight), -velocity @ sight / np.linalg.norm(sight)

    def miss(self, row, column, point):
        """How far a point on the Earth lies from where a pixel says that it is: across and along the track, m."""
        time, distance, rate = self.contour(row, column)
        place, velocity = self.antenna(time)
        sight = point - place
        true = np.linalg.norm(sight)
        speed = np.linalg.norm(velocity)
        return distance - true, (rate + velocity @ sight / true) * true / speed

    def offset(self, direction, row, column):
        x, y = self.coordinates(row, column)
        return np.polynomial.polynomial.polyval2d(x, y, self.polynomial(f"Grid/{direction}/DeltaKCOAPoly"))


def ecf(latitude, longitude, height):
    """Degrees and metres over WGS 84."""
    a, f = 6378137.0, 1 / 298.257223563
    e2 = f * (2 - f)
    lat, lon = np.radians(latitude), np.radians(longitude)
    n = a / np.sqrt(1 - e2 * np.sin(lat) ** 2)
    return np.array(
        [(n + height) * np.cos(lat) * np.cos(lon), (n + height) * np.cos(lat) * np.sin(lon), (n * (1 - e2) + height) * np.sin(lat)]
    )


def anchored(point, anchor):
    """ECF of a point of a flat world whose origin lies at (latitude, longitude, height, heading)."""
    latitude, longitude, height, heading = anchor
    lat, lon, turn = np.radians(latitude), np.radians(longitude), np.radians(heading)
    east = np.array([-np.sin(lon), np.cos(lon), 0])
    up = np.array([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])
    north = np.cross(up, east)
    x = np.cos(turn) * east - np.sin(turn) * north
    y = np.sin(turn) * east + np.cos(turn) * north
    return ecf(latitude, longitude, height) + point[0] * x + point[1] * y + point[2] * up


def peak(pixels, row, column, offsets, reach=16):
    """The largest value near a pixel, between samples: (row, column, value). `offsets` are the middles of the spectrum,
    in turns for each row and column."""
    finer = 32
    r0, c0 = int(round(row)) - reach, int(round(column)) - reach
    patch = pixels[r0 : r0 + 2 * reach, c0 : c0 + 2 * reach]
    r, c = np.unravel_index(np.argmax(np.abs(patch)), patch.shape)
    r0, c0 = r0 + r - reach, c0 + c - reach
    patch = pixels[r0 : r0 + 2 * reach, c0 : c0 + 2 * reach]
    index = np.arange(2 * reach)
    carrier = np.exp(2j * np.pi * (offsets[0] * index[:, None] + offsets[1] * index[None, :]))
    spectrum = np.fft.fft2(patch / carrier)
    padded = np.zeros(np.array(spectrum.shape) * finer, complex)
    rows = np.fft.fftfreq(2 * reach, 1 / (2 * reach)).astype(int)
    padded[np.ix_(rows, rows)] = spectrum
    fine = np.fft.ifft2(padded) * finer**2
    inner = np.zeros(fine.shape)
    near = slice((reach - 2) * finer, (reach + 2) * finer)
    inner[near, near] = np.abs(fine[near, near])
    r, c = np.unravel_index(np.argmax(inner), inner.shape)

    def vertex(before, at, behind):
        return 0.5 * (before - behind) / (before - 2 * at + behind)

    dr = vertex(inner[r - 1, c], inner[r, c], inner[r + 1, c])
    dc = vertex(inner[r, c - 1], inner[r, c], inner[r, c + 1])
    row, column = (r + dr) / finer, (c + dc) / finer
    value = fine[r, c] * np.exp(2j * np.pi * (offsets[0] * row + offsets[1] * column))
    return r0 + row, c0 + column, value
