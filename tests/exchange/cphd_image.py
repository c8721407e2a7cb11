"""An image formed from a CPHD file by nothing of Sarsim: a reader of its own, or those of sarkit and sarpy, and the
back-projection sum of the standard's formula. Says how far the peaks of targets are from their places, and their phases.

    cphd_image.py FILE.cphd --anchor=LAT,LON,HEIGHT,HEADING "--targets=X,Y,Z;X,Y,Z" [--reader own|sarkit|sarpy]

The anchor is in degrees and m, targets in m of the world. Sign and exit status say whether all are where they belong.
"""

import argparse
import xml.etree.ElementTree as ElementTree

import numpy as np

LIGHT = 299792458.0


class Own:
    """A reader of 30 lines."""

    def __init__(self, path):
        data = open(path, "rb").read()
        header = data[: data.index(b"\f\n")].decode().splitlines()
        keys = dict(line.split(" := ") for line in header[1:])
        at = {name: int(keys[name + "_BLOCK_BYTE_OFFSET"]) for name in ("XML", "PVP", "SIGNAL")}
        root = ElementTree.fromstring(data[at["XML"] : at["XML"] + int(keys["XML_BLOCK_SIZE"])])
        for element in root.iter():
            element.tag = element.tag.split("}")[-1]
        channel = root.find("Data/Channel")
        vectors, samples = (int(channel.findtext(name)) for name in ("NumVectors", "NumSamples"))
        words = int(root.findtext("Data/NumBytesPVP")) // 8
        pvp = np.frombuffer(data, ">f8", vectors * words, at["PVP"]).reshape(vectors, words).astype(float)
        self.pvp = {}
        for field in root.find("PVP"):
            first, size = int(field.findtext("Offset")), int(field.findtext("Size"))
            self.pvp[field.tag] = pvp[:, first] if size == 1 else pvp[:, first : first + size]
        kind = {"CF8": ">f4", "CI4": ">i2", "CI2": "i1"}[root.findtext("Data/SignalArrayFormat")]
        numbers = np.frombuffer(data, kind, 2 * vectors * samples, at["SIGNAL"]).reshape(vectors, samples, 2)
        self.signal = numbers[..., 0].astype(float) + 1j * numbers[..., 1]
        if "AmpSF" in self.pvp:
            self.signal *= self.pvp["AmpSF"][:, None]
        self.sign = int(root.findtext("Global/SGN"))
        self.domain = root.findtext("Global/DomainType")


class Sarkit:
    def __init__(self, path):
        import sarkit.cphd

        with open(path, "rb") as file, sarkit.cphd.Reader(file) as reader:
            tree = reader.metadata.xmltree
            signal, pvp = reader.read_channel(tree.findtext("{*}Data/{*}Channel/{*}Identifier"))
        self.pvp = {name: pvp[name] for name in pvp.dtype.names}
        if signal.dtype.names:  # Integers, to which the scale is not applied.
            signal = signal["real"].astype(float) + 1j * signal["imag"]
        self.signal = signal.astype(complex)
        if "AmpSF" in self.pvp:
            self.signal *= self.pvp["AmpSF"][:, None]
        self.sign = int(tree.findtext("{*}Global/{*}SGN"))
        self.domain = tree.findtext("{*}Global/{*}DomainType")


class Sarpy:
    def __init__(self, path):
        import sarpy.io.phase_history as phase_history

        reader = phase_history.open(path)
        meta = reader.cphd_meta
        names = ["TxPos", "RcvPos", "SRPPos", "SC0", "SCSS"]
        self.pvp = {name: np.asarray(reader.read_pvp_variable(name, 0)) for name in names}
        self.signal = reader[:, :].astype(complex)  # The scale is applied.
        self.sign = int(meta.Global.SGN)
        self.domain = meta.Global.DomainType


def ecf_of(points, anchor):
    """World coordinates over a plane, or the Earth, at an anchor."""
    lat, lon, height, heading = np.radians(anchor[0]), np.radians(anchor[1]), anchor[2], np.radians(anchor[3])
    a, f = 6378137.0, 1 / 298.257223563
    e2 = f * (2 - f)
    n = a / np.sqrt(1 - e2 * np.sin(lat) ** 2)
    up = np.array([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])
    origin = (n + height) * up - np.array([0, 0, e2 * n * np.sin(lat)])
    east = np.array([-np.sin(lon), np.cos(lon), 0])
    north = np.cross(up, east)
    x = np.cos(heading) * east - np.sin(heading) * north
    y = np.sin(heading) * east + np.cos(heading) * north
    return origin + points @ np.array([x, y, up]), x, y


def spread(file, points):
    """Sum over pulses and frequencies, matched to each of the points."""
    p = file.pvp
    signal = file.signal if file.sign < 0 else file.signal.conj()
    way = lambda at: np.linalg.norm(p["TxPos"] - at, axis=1) + np.linalg.norm(p["RcvPos"] - at, axis=1)
    reference = way(p["SRPPos"])
    # exp(2 pi j f toa), f = SC0 + k SCSS, of blocks of frequencies and of those within a block.
    inner = 64
    vectors, count = signal.shape
    outer = -(-count // inner)
    blocks = np.zeros((vectors, outer * inner), complex)
    blocks[:, :count] = signal
    blocks = blocks.reshape(vectors, outer, inner)
    first_hz = p["SC0"][:, None] + p["SCSS"][:, None] * inner * np.arange(outer)
    beyond_hz = p["SCSS"][:, None] * np.arange(inner)
    total = []
    for point in points:
        turns = 2j * np.pi * (way(point) - reference)[:, None] / LIGHT
        sums = (blocks @ np.exp(turns * beyond_hz)[:, :, None])[:, :, 0]
        total.append((sums * np.exp(turns * first_hz)).sum() / signal.size)
    return np.array(total)


def peak(file, place, x, y, reach, count):
    """Where the magnitude is largest about a place, by a parabola through the best of a fine grid; and the value there."""
    steps = np.linspace(-reach, reach, count)
    grid = np.array([place + u * x + v * y for u in steps for v in steps])
    values = np.abs(spread(file, grid)).reshape(count, count)
    i, j = np.unravel_index(np.argmax(values), values.shape)
    if not (0 < i < count - 1 and 0 < j < count - 1):
        return np.inf
    offset = lambda a, b, c: 0.5 * (a - c) / (a - 2 * b + c)
    du = steps[i] + (steps[1] - steps[0]) * offset(*values[i - 1 : i + 2, j])
    dv = steps[j] + (steps[1] - steps[0]) * offset(*values[i, j - 1 : j + 2])
    return float(np.hypot(du, dv))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("file")
    parser.add_argument("--anchor", default="0,0,0,0")
    parser.add_argument("--targets", required=True)
    parser.add_argument("--geodetic", action="store_true", help="targets are latitude, longitude, height")
    parser.add_argument("--reader", default="own", choices=["own", "sarkit", "sarpy"])
    parser.add_argument("--metres", type=float, default=0.05, help="largest distance of a peak from its place")
    parser.add_argument("--radians", type=float, default=0.01, help="largest phase at a place")
    parser.add_argument("--reach", type=float, default=0.2, help="of the grid about each target, m")
    arguments = parser.parse_args()
    file = {"own": Own, "sarkit": Sarkit, "sarpy": Sarpy}[arguments.reader](arguments.file)
    assert file.domain == "FX"
    anchor = [float(word) for word in arguments.anchor.split(",")]
    points = np.array([[float(word) for word in place.split(",")] for place in arguments.targets.split(";")])
    if arguments.geodetic:
        places = np.array([ecf_of(np.zeros(3), [*point, 0.0])[0] for point in points])
        _, x, y = ecf_of(np.zeros(3), [*points[0], 0.0])
    else:
        places, x, y = ecf_of(points, anchor + [0.0] * (4 - len(anchor)))
    at_places = spread(file, places)
    worst_m = max(peak(file, place, x, y, arguments.reach, 9) for place in places)
    worst_rad = np.abs(np.angle(at_places)).max()
    levels = np.abs(at_places) / np.abs(at_places).mean()
    print(f"{len(places)} targets: peaks within {worst_m:.4f} m, phases within {worst_rad:.5f} rad, "
          f"levels {levels.min():.3f} to {levels.max():.3f} of their mean")
    assert worst_m <= arguments.metres, "a peak is not at its place"
    assert worst_rad <= arguments.radians, "a phase is not 0"


if __name__ == "__main__":
    main()
