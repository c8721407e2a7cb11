"""The scene of a number: ordinary ones, and in every other place those in which the exact light time matters.

Half of the physical ones receive the echoes of other pulses: some in windows that only those reach, some at so high a
PRF that a row meets several pulses.
"""

import dataclasses
import random

from fast_scenes import FAMILIES, FastDraw
from scenes import LIGHT_SPEED, Draw


def family(number):
    """Name of the family of a scene, or None of an ordinary one."""
    return list(FAMILIES)[number // 2 % len(FAMILIES)] if number % 2 == 0 else None


def random_scene(number):
    scene = FastDraw(number, family(number)).scene() if family(number) else Draw(number).scene()
    draw = random.Random(f"other pulses of {number}")
    if scene.profile == "classic":
        return scene
    recording = dataclasses.replace(scene.recording, eclipsing=draw.random() < 0.2)
    scene = dataclasses.replace(scene, recording=recording)
    if draw.random() < 0.5:
        return scene
    recording.other_pulses = True
    change = draw.choice((None, moved_window, more_pulses))
    if change:
        change(scene, draw)
    return scene


def moved_window(scene, draw):
    """Nearer or farther by a few pulse intervals: only echoes of other pulses fall into it."""
    recording = scene.recording
    interval_m = LIGHT_SPEED[scene.profile] / 2 * (scene.radar.intervals or [1 / scene.radar.prf_hz])[0]
    nearer = [count for count in (1, 2, 3) if recording.near_m - count * interval_m >= 0]
    shift_m = draw.choice([-count for count in nearer] + [1, 2]) * interval_m
    recording.near_m, recording.far_m = round(recording.near_m + shift_m, 2), round(recording.far_m + shift_m, 2)


def more_pulses(scene, draw):
    """Intervals shorter than the window; at most twenty pulses are under way."""
    recording, radar = scene.recording, scene.radar
    window_s = 2 * (recording.far_m - recording.near_m) / LIGHT_SPEED[scene.profile]
    if radar.intervals or recording.processing == "SRP":
        return
    interval_s = max(draw.uniform(0.3, 0.9) * window_s, recording.far_m / LIGHT_SPEED[scene.profile] / 10)
    radar.prf_hz = float(f"{1 / interval_s:.5g}")
    recording.end_s = recording.begin_s + 4 / radar.prf_hz
