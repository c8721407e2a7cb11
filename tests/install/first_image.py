"""Twelve lines from nothing to an image, in the file that is named; packaging/try-packages runs them."""

import sys

import numpy as np
import sarsim

scene = sarsim.Scene()
t = np.array([-2.0, 2.0])
scene.platforms.add("Plane", path="points", trajectory=(t, np.column_stack([100 * t, -8000 + 0 * t, 3000 + 0 * t])))
scene.radars.add("SAR", platform="Plane", carrier="9.6 GHz", prf="400 Hz", pulse="chirp", bandwidth="100 MHz", pulse_width="1 us")
scene.targets.add_many([[0, 0, 0], [-40, 30, 0], [50, -60, 0]], rcs_m2=[1, 1, 4])
scene.recordings.add("strip.npy", radar="SAR", range_start=8.4e3, range_end=8.9e3, time_start=-1.5, time_end=1.5, sample_rate="120 MHz")
image = sarsim.focus(scene.record(), algorithm="back-projection", window="hamming", azimuth="-80:80", range="8480:8600")
image.picture().save(sys.argv[1])
for row in image.measure():
    print(f"target {row['target']:.0f}: {row['azimuth_error_m']:+.4f} m along, {row['range_error_m']:+.4f} m across")
