"""Runs the program on a scene, and says how far its samples are from those of a model."""

import os
import pathlib
import subprocess

import numpy as np

import scenes

# Of the largest sample of the recording; for the fast engines of its echoes, where the swath cuts off what is highest.
TOLERANCE = {
    # Samples are written in single precision, which rounds I and Q by up to 6e-8 each; phases of 1e7 turns add 1e-8.
    "reference": 2e-7,
    # --tolerance promises 1e-6 for a row's r.m.s. error against its echoes; a sample may be a few times worse.
    "auto": 3e-6,
    "direct": 3e-6,
    "spectral": 3e-6,
}
# What the engines leave out of the light time of both ways, as a phase [rad]; docs/theory/echo-model.md, 6.
LIGHT_TIME = 5e-7
VANISHING_V = 1e-30  # Far from where single precision ends, 1e-38: filters in between still have digits to lose.


def program():
    return os.path.abspath(os.environ.get("SARSIM_PROGRAM") or os.environ["SARSIM_BUILT_PROGRAM"])


def simulated(scene, engine, folder):
    """What the program makes of a scene, in volts."""
    script = pathlib.Path(folder) / "scene.scr"
    script.write_text(scenes.script(scene), encoding="utf-8")
    command = [program(), "run", str(script), "--out", str(folder), "--engine", engine]
    done = subprocess.run(
        [*command, "--threads", "1", "--force", "--quiet"], capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        raise RuntimeError(f"exit status {done.returncode}: {done.stderr.strip()[-300:]}")
    return np.load(pathlib.Path(folder) / "samples.npy").astype(complex)


def error_of(samples, expected, level=0.0):
    """The largest difference over the largest sample or a level; infinite where shapes differ or numbers miss."""
    if samples.shape != expected.shape or not np.isfinite(samples).all():
        return np.inf
    return np.abs(samples - expected).max() / max(np.abs(expected).max(), level)


def allowed_for(model, engine):
    """Error of a scene by an engine: what both promise, and the rounding of a phase in double precision."""
    return TOLERANCE[engine] + rounding_of(model.scene) + (0.0 if model.classic else LIGHT_TIME)


def rounding_of(scene):
    """Of a phase [rad] that is computed in double precision: of places, delays and their product with the carrier."""
    radar, light_speed = scene.radar, 299792458.0
    carrier = 1e9 * max(radar.carrier.frequencies_ghz or [radar.carrier.first_ghz])
    begins = [[curve.heights[0] for curve in p.trajectory] if p.trajectory else p.position for p in scene.platforms]
    farthest = max(np.linalg.norm(place) for place in begins) + scene.recording.far_m
    return 4 * 2.0**-53 * 4 * np.pi * carrier / light_speed * farthest


def reason_to_leave_out(expected):
    largest = np.abs(expected).max(initial=0.0)
    if largest == 0:
        return "no echo in the window"
    return "at the end of single precision" if largest < VANISHING_V else None
