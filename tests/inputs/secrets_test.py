#!/usr/bin/env python3
"""Messages quote at most one word of any file, and names send no control characters to a terminal.

    secrets_test.py

Every place of a scene, a recording and a command line that names a file is given one that was never meant to be read, and
descriptions of samples hold such texts; no command may tell more of them than one word of at most 60 letters. The program is SARSIM_PROGRAM or SARSIM_BUILT_PROGRAM of
the environment.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PROGRAM = os.path.abspath(os.environ.get("SARSIM_PROGRAM") or os.environ["SARSIM_BUILT_PROGRAM"])
LONGEST = 60

SCENE = """format = "sarsim 2"
{top}
[[platform]]
name = "{name}"
path = {path}
{rotation}
[[target]]
positions = {positions}
[[radar]]
name = "X"
platform = "{name}"
pulse = {pulse}
repetition = "120 Hz"
carrier = "9.6 GHz"
power = "1 kW"
{antenna}
[[recording]]
radar = "X"
file = "small.{ending}"
format = "{word}"
sample_rate = "75 MHz"
range = ["2850 m", "2990 m"]
time = ["-0.1 s", "0.1 s"]
"""
LINE = '{ type = "line", start = [0, -2500, 1500], velocity = [100, 0, 0] }'
CHIRP = '{ type = "chirp", bandwidth = "60 MHz", width = "0.5 us" }'
# Each line is one that some reader might take for its own, or begin to.
SECRETS = {
    "passwords": "root:x1:hunter2 correct horse battery staple\nsecond: alpha bravo charlie\n",
    "table": "x,y,z\n1,2,hunter2 correct horse battery staple\n",
    "numbers": "1 2 hunter2 correct horse battery staple\n3 4 alpha bravo charlie\n",
    "keys": "format = hunter2 correct horse battery staple\nalpha = bravo charlie\n",
    "json": '{"key": "hunter2 correct horse battery staple", "alpha": bravo charlie}\n',
    "long": "0," + "7" * 300_000 + " hunter2 correct horse\n",
    "xml": "<?xml version='1.0'?>\n<hunter2 correct='horse battery'>staple alpha bravo</hunter2>\n",
    "tle": "1 25544U hunter2 correct horse battery staple alpha bravo charlie delta echo\n2 more of it\n",
    "oem": "CCSDS_OEM_VERS = hunter2 correct horse\nMETA_START alpha bravo charlie\n",
    "unit": "x,w\n0,1\n1,5 alpha bravo charlie delta\n",
    "heading": "x [hunter2 correct horse battery],w [alpha bravo charlie]\n0,1\n1,5\n",
    "names": "alpha bravo,charlie delta\nhunter2 correct horse,battery staple\n",
    "mark": 'format = "hunter2 correct horse battery staple"\nalpha = "bravo charlie"\n',
    "letters": "0,1\n1," + "hunter2" * 100 + " correct horse\n",
}
WORDS = set("hunter2 correct horse battery staple alpha bravo charlie delta echo".split())


def scene(top="", path=LINE, rotation="", positions="[[0, 0, 0], [31, 23, 0]]", pulse=CHIRP, antenna="", name="Plane",
          ending="h5", word="hdf5"):  # fmt: skip
    return SCENE.format(**locals())


def places(file):
    """Scenes that name the file in one field each."""
    yield "include", scene(top=f'include = ["{file}"]')
    yield "positions", scene(positions=f'{{ file = "{file}" }}')
    yield "path", scene(path=f'{{ type = "ephemeris", file = "{file}" }}')
    yield "path by points", scene(path=f'{{ type = "points", file = "{file}" }}')
    yield "attitude", scene(rotation=f'rotation = {{ type = "quaternions", file = "{file}" }}')
    points = f'{{ type = "points", file = "{file}" }}'
    yield "rotation by points", scene(rotation=f"rotation = {points}")
    yield "pulse", scene(pulse=f'{{ type = "points", width = "1 us", file = "{file}" }}')
    for field in ("antenna", "receive_antenna", "envelope", "window", "stc", "beam"):
        yield field, scene(antenna=f"{field} = {points}")
    yield "intervals", scene().replace('repetition = "120 Hz"', f'repetition = {{ type = "list", file = "{file}" }}')
    yield "carriers", scene().replace('carrier = "9.6 GHz"', f'carrier = {{ type = "list", file = "{file}" }}')
    yield "reflectivity", scene().replace("[[radar]]", f'reflectivity = {{ type = "directional", gain = {points} }}\n[[radar]]', 1)
    yield "geoid", scene().replace("[[platform]]", f"""[world]
frame = "earth"
epoch = "2024-04-01T00:00:00Z"
anchor = {{ latitude = "47 deg", longitude = "8 deg", height = "0 m" }}
geoid = {{ file = "{file}" }}
[[platform]]""", 1).replace("[[radar]]", """[[target]]
position = { latitude = "47 deg", longitude = "8 deg", altitude = "1 m" }
[[radar]]""", 1)


def call(folder, *words):
    result = subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, timeout=120)
    return result.returncode, (result.stdout + result.stderr).decode(errors="replace")


# Text that says where a file is that cannot be read.
NOWHERE = "nowhere.dat"


def check_forms(folder):
    """Every place does read its file: one that is not there is missed by its name, and no field is unknown."""
    wrong = []
    count = 0
    for place, text in places(NOWHERE):
        (folder / "s.toml").write_text(text)
        count += 1
        status, output = call(folder, "check", "s.toml")
        if status != 2 or NOWHERE not in output or "has no field" in output:
            wrong.append(f"{place} does not read its file: {status}: {output[:300]}")
    return count, wrong


def foreign_files(folder, secret, content):
    """Files of samples whose descriptions hold the secret: their names, and what is read of them."""
    quoted = json.dumps(content[:2000])
    metas = {
        "raw": content,
        "type": '{"global": {"core:datatype": %s, "core:version": "1.0.0"}, "captures": [], "annotations": []}' % quoted,
        "version": '{"global": {"core:datatype": "cf32_le", "core:version": %s}, "captures": [], "annotations": []}' % quoted,
        "rate": '{"global": {"core:datatype": "cf32_le", "core:sample_rate": %s}, "captures": []}' % quoted,
        "dataset": '{"global": {"core:datatype": "cf32_le", "core:dataset": %s}, "captures": []}' % quoted,
        "sum": '{"global": {"core:datatype": "cf32_le", "core:sha512": %s}, "captures": []}' % quoted,
    }
    for kind, text in metas.items():
        (folder / f"{secret}-{kind}.sigmf-meta").write_text(text)
        (folder / f"{secret}-{kind}.sigmf-data").write_bytes(bytes(64))
        yield f"{secret}-{kind}.sigmf-meta"
    array = '{"zarr_format": 2, "shape": [2, 2], "chunks": [2, 2], "dtype": "<c8", "compressor": %s, "fill_value": 0, "order": "C", "filters": null}'
    for kind, zarray, zattrs in (("array", content, "{}"), ("attributes", array % "null", content), ("compressor", array % quoted, "{}"),
                                 ("units", array % "null", '{"units": %s, "scale_factor": %s}' % (quoted, quoted))):  # fmt: skip
        store = folder / f"{secret}-{kind}.zarr"
        (store / "samples").mkdir(parents=True, exist_ok=True)
        (store / ".zgroup").write_text('{"zarr_format": 2}')
        (store / "samples" / ".zarray").write_text(zarray)
        (store / "samples" / ".zattrs").write_text(zattrs)
        (store / "samples" / "0.0").write_bytes(bytes(32))
        yield store.name
    one_line = content.replace("\n", " ")[:2000]
    for kind, field in (("type", "data type"), ("order", "byte order"), ("interleave", "interleave"), ("samples", "samples")):
        values = {"samples": "2", "lines": "2", "bands": "1", "data type": "6", "interleave": "bsq", "byte order": "0"} | {field: one_line}
        (folder / f"{secret}-{kind}.hdr").write_text("ENVI\n" + "".join(f"{key} = {value}\n" for key, value in values.items()))
        (folder / f"{secret}-{kind}.img").write_bytes(bytes(32))
        yield f"{secret}-{kind}.img"
    (folder / f"{secret}.cphd").write_text("CPHD/1.1.0\nXML_BLOCK_SIZE := " + one_line + "\n\f\n" + content)
    yield f"{secret}.cphd"
    (folder / f"{secret}.npy").write_bytes(b"\x93NUMPY\x01\x00" + min(len(content), 200).to_bytes(2, "little") + content.encode()[:200] + bytes(64))
    yield f"{secret}.npy"


def check_foreign(folder):
    """What describes samples of other programs."""
    wrong = []
    count = 0
    for secret, content in SECRETS.items():
        for name in foreign_files(folder, secret, content):
            for words in (("info", name), ("convert", name, "out.npy", "--force")):
                count += 1
                status, output = call(folder, *words)
                wrong += [f"{' '.join(words)}: {what}" for what in told(output)[0]]
                if status < 0:
                    wrong.append(f"{' '.join(words)}: ended with {status}")
    return count, wrong


def told(text):
    """Faults of a printed text, and the words of the file in it."""
    # Whoever named the file knows its name; the text of the scene is the user's own.
    found = sorted(WORDS & set(re.findall(r"[A-Za-z0-9_]+", text)))
    wrong = [f"{len(found)} words: {' '.join(found)}: {text[:160]}"] if len(found) > 1 else []
    if re.search(r"7{%d,}" % (LONGEST + 1), text):
        wrong.append("a long word")
    if len(text) > 20_000:
        wrong.append(f"{len(text)} bytes")
    return wrong, found


def check_places(folder):
    wrong = []
    count = 0
    for secret, content in SECRETS.items():
        for ending in ("", ".csv", ".txt", ".oem", ".json", ".EOF", ".toml"):
            (folder / f"{secret}{ending}").write_text(content)
    for secret in SECRETS:
        for ending in ("", ".csv", ".oem"):
            for place, text in places(f"{secret}{ending}"):
                (folder / "s.toml").write_text(text)
                count += 1
                status, output = call(folder, "check", "s.toml")
                wrong += [f"{place} = {secret}{ending}: {what}" for what in told(output)[0]]
                if "has no field" in output:
                    wrong.append(f"{place} = {secret}{ending}: {output[:200]}")
        (folder / "m.toml").write_text(scene())
        for words in (
            ("check", "m.toml", "--targets", f"{secret}.csv"),
            ("sweep", "m.toml", "--values", f"{secret}.csv", "--out", "o", "--dry-run"),
            ("sweep", "m.toml", "--values", f"{secret}.csv", "--out", "o", "--json"),
            ("focus", "small.h5", "--navigation", f"{secret}.csv", "--out", "o.img"),
        ):
            count += 1
            status, output = call(folder, *words)
            wrong += [f"{' '.join(words)}: {what}" for what in told(output)[0]]
            if status < 0:
                wrong.append(f"{' '.join(words)}: ended with {status}")
    return count, wrong


def put_script(folder, text):
    """Puts a script into a Zarr store."""
    for name in (".zattrs", ".zmetadata"):
        path = folder / "small.zarr" / name
        data = json.loads(path.read_text())
        (data["metadata"][".zattrs"] if name == ".zmetadata" else data)["script"] = text
        path.write_text(json.dumps(data))


def check_recordings(folder):
    """Scripts inside recordings."""
    wrong = []
    (folder / "m.toml").write_text(scene(ending="zarr", word="zarr"))
    (folder / "points.csv").write_text("x,y,z\n5,5,0\n")
    call(folder, "run", "m.toml", "--quiet", "--force")
    # Recorded by us, of a scene with a table: it is focused as ever.
    (folder / "t.toml").write_text(scene(ending="zarr", word="zarr", positions='{ file = "points.csv" }').replace("small", "tables"))
    call(folder, "run", "t.toml", "--quiet", "--force")
    status, output = call(folder, "focus", "tables.zarr", "--out", "i.npy", "--force", "--quiet")
    if status != 0:
        wrong.append(f"a recording with a table: {output[:300]}")
    count = 1
    for secret in SECRETS:
        for place, text in places(f"{secret}.csv"):
            text = text.replace('"small.h5"', '"small.zarr"').replace('"hdf5"', '"zarr"')
            put_script(folder, text)
            count += 1
            for words in (("focus", "small.zarr", "--out", "i.npy", "--force"), ("geometry", "small.zarr", "--csv")):
                status, output = call(folder, *words)
                _, found = told(output)
                if found or status == 0:
                    wrong.append(f"{words[0]}, {place} = {secret}: {status}: {' '.join(found)}: {output[:200]}")
                if place == "include" and "includes" not in output:
                    wrong.append(f"{words[0]}: an include is not named: {output[:200]}")
    # The included file may be a sound one: it is not read either.
    (folder / "part.toml").write_text('format = "sarsim 2"\n')
    put_script(folder, scene(top='include = ["part.toml"]', ending="zarr", word="zarr"))
    status, output = call(folder, "focus", "small.zarr", "--out", "i.npy", "--force")
    if status != 2 or "includes" not in output:
        wrong.append(f"a sound include: {status}: {output[:200]}")
    return count, wrong


ORDERS = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]")


def check_terminal(folder):
    """Names with control characters."""
    wrong = []
    count = 0
    for code in ("009b31m", "001b]0;x", "0007", "007f", "202e", "2066", "2028", "0085", "200f", "061c"):
        name = "A\\u" + code + "B"
        (folder / "c.toml").write_text(scene(name=name))
        for words in (
            ("info", "c.toml"), ("info", "c.toml", "--json"), ("check", "c.toml"), ("check", "c.toml", "--json"),
            ("check", "c.toml", "--set", "Nobody.x=1"), ("motion", "c.toml", "--out", "m.csv", "--force"), ("format", "c.toml"),
            ("run", "c.toml", "--force"), ("run", "c.toml", "--force", "--json"), ("geometry", "c.toml", "--radar", "X", "--start", "0",
             "--end", "0.05"), ("focus", "small.h5", "--out", "i.img", "--force"), ("info", "small.h5"), ("info", "small.h5", "--json"),
            ("measure", "i.img"), ("sweep", "c.toml", "--fields"), ("sweep", "c.toml", "--set", "seed=1..2", "--out", "o", "--force"),
            ("sweep", "c.toml", "--set", "seed=1..2", "--out", "o", "--resume", "--json"),
        ):  # fmt: skip
            count += 1
            status, output = call(folder, *words)
            data = words[0] in ("format", "geometry")  # Byte for byte into a pipe; a terminal is told in words.
            if not data and (found := ORDERS.search(output)):
                wrong.append(f"U+{code}: {' '.join(words)}: U+{ord(found[0]):04x} is printed")
    return count, wrong


def main():
    wrong = []
    count = 0
    with tempfile.TemporaryDirectory(prefix="sarsim-secrets-") as name:
        folder = pathlib.Path(name)
        (folder / "m.toml").write_text(scene())
        status, output = call(folder, "run", "m.toml", "--quiet")
        if status != 0:
            sys.exit(output)
        for check in (check_forms, check_places, check_foreign, check_recordings, check_terminal):
            more, found = check(folder)
            count += more
            wrong += found
    print("\n".join(wrong))
    print(f"{count} cases, {len(wrong)} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
