"""Targets stand at their places, with the phase 0, in images that NumPy alone makes of CRSD files: what is recorded of
each pulse is compared with the pulse that the file describes, sent from where and received where it says.

    crsd_test.py SARSIM SCENE

Exit status: 0 as it should be, 1 not, 77 NumPy is missing.
"""

import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "support"))

import with_numpy  # noqa: E402, F401
import numpy as np  # noqa: E402

import cphd_image  # noqa: E402

TARGETS = np.array([[0, 0, 0], [31, 23, 0], [-27, -35, 2]], float)
ANCHOR = [47.5, 8.25, 400.0, 30.0]
LIGHT = cphd_image.LIGHT


class Crsd:
    def __init__(self, path):
        data = open(path, "rb").read()
        header = data[: data.index(b"\f\n")].decode().splitlines()
        assert header[0] == "CRSDsar/1.0"
        keys = dict(line.split(" := ") for line in header[1:])
        at = {name: int(keys[name + "_BLOCK_BYTE_OFFSET"]) for name in ("XML", "SUPPORT", "PPP", "PVP", "SIGNAL")}
        root = ElementTree.fromstring(data[at["XML"] : at["XML"] + int(keys["XML_BLOCK_SIZE"])])
        for element in root.iter():
            element.tag = element.tag.split("}")[-1]
        channel = root.find("Data/Receive/Channel")
        vectors, samples = (int(channel.findtext(name)) for name in ("NumVectors", "NumSamples"))
        self.pulse = self.parameters(data, root.find("PPP"), at["PPP"], root.findtext("Data/Transmit/NumBytesPPP"), vectors)
        self.row = self.parameters(data, root.find("PVP"), at["PVP"], root.findtext("Data/Receive/NumBytesPVP"), vectors)
        kind = {"CF8": ">f4", "CI4": ">i2", "CI2": "i1"}[root.findtext("Data/Receive/SignalArrayFormat")]
        numbers = np.frombuffer(data, kind, 2 * vectors * samples, at["SIGNAL"]).reshape(vectors, samples, 2)
        self.signal = (numbers[..., 0].astype(float) + 1j * numbers[..., 1]) * self.row["AmpSF"][:, None]
        self.rate = float(root.findtext("Channel/Parameters/Fs"))

    @staticmethod
    def parameters(data, fields, at, size, count):
        words = int(size) // 8
        floats = np.frombuffer(data, ">f8", count * words, at).reshape(count, words).astype(float)
        whole = np.frombuffer(data, ">i8", count * words, at).reshape(count, words).astype(float)
        read = {}
        for field in fields:
            first, length = int(field.findtext("Offset")), int(field.findtext("Size"))
            kind = field.findtext("Format")
            if kind.startswith("Int="):
                read[field.tag] = whole[:, first] + floats[:, first + 1]
            elif kind == "I8":
                read[field.tag] = whole[:, first]
            else:
                read[field.tag] = floats[:, first] if length == 1 else floats[:, first : first + length]
        return read

    def image_at(self, points):
        """The mean over pulses of each row matched to the echo of each point."""
        p, r = self.pulse, self.row
        index = r["TxPulseIndex"].astype(int)
        after = np.arange(self.signal.shape[1]) / self.rate
        total = []
        for point in points:
            out = np.linalg.norm(p["TxPos"][index] - point, axis=1)
            delay = 2 * out / LIGHT
            for _ in range(3):  # The receiver as the echo comes back.
                since = p["TxTime"][index] + delay - r["RcvStart"]
                receiver = r["RcvPos"] + since[:, None] * r["RcvVel"]
                delay = (out + np.linalg.norm(receiver - point, axis=1)) / LIGHT
            # Time from the middle of the pulse, sample by sample, and the phases of pulse and receiver, in cycles.
            u = r["RcvStart"][:, None] - p["TxTime"][index][:, None] - delay[:, None] + after
            sent = p["PhiX0"][index][:, None] + p["FxFreq0"][index][:, None] * u + 0.5 * p["FxRate"][index][:, None] * u**2
            reference = r["RefPhi0"][:, None] + r["RefFreq"][:, None] * after
            on = np.abs(u) < 0.5 * p["TXmt"][index][:, None]
            total.append(np.sum(self.signal * on * np.exp(-2j * np.pi * (sent - reference))) / on.sum())
        return np.array(total)


def check(path):
    file = Crsd(path)
    places, x, y = cphd_image.ecf_of(TARGETS, ANCHOR)
    worst_rad = np.abs(np.angle(file.image_at(places))).max()
    worst_m = 0.0
    steps = np.linspace(-0.2, 0.2, 5)
    for place in places:
        values = np.abs(file.image_at([place + a * x + b * y for a in steps for b in steps])).reshape(5, 5)
        i, j = np.unravel_index(np.argmax(values), values.shape)
        offset = lambda v: 0.1 * 0.5 * (v[0] - v[2]) / (v[0] - 2 * v[1] + v[2])
        assert 0 < i < 4 and 0 < j < 4, "a peak is not near its place"
        worst_m = max(worst_m, np.hypot(steps[i] + offset(values[i - 1 : i + 2, j]),
                                        steps[j] + offset(values[i, j - 1 : j + 2])))
    print(f"{path.name}: peaks within {worst_m:.4f} m, phases within {worst_rad:.5f} rad")
    assert worst_m <= 0.05 and worst_rad <= 0.01, path.name


def main(program, scene):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        anchor = "--anchor=" + ",".join(str(number) for number in ANCHOR)
        for name, options in {"floats": [], "integers": ["--encoding", "ci4"], "moving": ["--reference-point", "moving"]}.items():
            path = folder / f"{name}.crsd"
            subprocess.run([program, "convert", scene, str(path), anchor, *options], check=True, stderr=subprocess.DEVNULL)
            check(path)


if __name__ == "__main__":
    main(*sys.argv[1:])
