#!/usr/bin/env python3
"""Tests of the judge against closed forms and deliberate errors. Echoes are made sample by sample, by the light time of
each instant, without any code of the judge."""

import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import with_numpy  # noqa: E402, F401
import numpy as np  # noqa: E402

import focusing_draws  # noqa: E402
import images  # noqa: E402
import judge  # noqa: E402

POINT = np.array([40.0, 900.0, 0.0])
AMPLITUDE = 3e-5


def place(time):
    """Of an antenna that climbs."""
    return np.array([180.0 * time, 20.0, 300.0 + 11.0 * time])


def sent_time(received, position=place):
    """When what is received at an instant was sent, by iteration over both ways."""
    back = np.linalg.norm(POINT - position(received)) / judge.LIGHT
    sent = received - 2 * back
    for _ in range(30):
        out = np.linalg.norm(POINT - position(sent)) / judge.LIGHT
        sent = received - back - out
    return sent


def recording(carrier=1.3e9, speed_scale=1.0):
    """Raw echoes of the point."""
    bandwidth, width, rate = 40e6, 2e-6, 70e6
    times = np.arange(-6, 7) / 15.0
    first = 2 * 880.0 / judge.LIGHT
    samples = np.zeros((len(times), 420), dtype=complex)
    for p, time in enumerate(times):
        for n in range(samples.shape[1]):
            # The leading edge of the pulse leaves half a pulse before its middle; delays count from there.
            after = first + n / rate - width / 2
            since = sent_time(time + after) - time
            if -width / 2 <= since < width / 2:
                turns = 0.5 * bandwidth / width * since**2 + carrier * (since - after)
                samples[p, n] = AMPLITUDE * np.exp(2j * np.pi * turns)
    places = np.array([place(t) for t in times])
    velocities = np.tile((place(1.0) - place(0.0)) * speed_scale, (len(times), 1))
    return judge.Recording(samples, first, rate, carrier, bandwidth, width, places, velocities)


class Judge(unittest.TestCase):
    def test_finds_amplitude_and_phase_of_a_point(self):
        value, whole = judge.integrated(recording(), POINT)
        self.assertLess(abs(value - AMPLITUDE), 1e-6 * AMPLITUDE)
        self.assertLess(abs(whole - AMPLITUDE), 1e-6 * AMPLITUDE)

    def test_sees_a_tenth_of_a_wavelength(self):
        wavelength = judge.LIGHT / 1.3e9
        found = recording()
        sight = POINT - found.places[6]
        moved = POINT + 0.1 * wavelength * sight / np.linalg.norm(sight)
        value, _ = judge.integrated(found, moved)
        self.assertAlmostEqual(np.angle(value), 4 * np.pi * 0.1, delta=0.01)

    def test_sees_a_wrong_speed(self):
        value, _ = judge.integrated(recording(speed_scale=3.0), POINT)
        self.assertGreater(abs(value / AMPLITUDE - 1), 1e-3)

    def test_integrates_coherently_over_the_flight(self):
        found = recording()
        value, whole = judge.integrated(found, POINT + np.array([6.0, 0.0, 0.0]))
        self.assertLess(abs(value), 0.5 * whole)

    def test_measures_from_the_line_that_fits_a_flight(self):
        times = np.linspace(0, 1, 11)
        places = np.stack([5 + 40 * times, 3 * np.where(np.arange(11) % 2, 1, -1), 7 + 0 * times], 1)
        places[:, 1] -= np.polyval(np.polyfit(times, places[:, 1], 1), times)
        self.assertAlmostEqual(judge.distance_from_line(times, places, np.array([999.0, 3.0, 3.0])), 5.0)


class Image(unittest.TestCase):
    def test_finds_the_place_of_coordinates_on_the_ground(self):
        along = np.array([180.0, 0.0, 11.0]) / np.hypot(180.0, 11.0)
        frame = (np.zeros((2, 2)), (0.0, 0.0), (1.0, 1.0), (0.0, 0.0), np.array([0.0, 20.0, 300.0]), along, 1e9, "none")
        image = images.Image(*frame)
        at = image.point_at(image.place_of(POINT), POINT + np.array([5.0, -7.0, 0.0]))
        self.assertLess(np.abs(at - POINT).max(), 1e-6)
        level = images.Image(*frame, across=np.array([0.0, 1.0, 0.0]))
        self.assertEqual(level.place_of(frame[4] + 4 * level.across), (0.0, 4.0))

    def test_is_read_between_samples_about_its_centre(self):
        step, centre = (0.7, 1.1), (0.9, -0.4)
        rows, columns = np.meshgrid(np.arange(200) * step[0], np.arange(180) * step[1], indexing="ij")
        waves = [(centre[0] + 0.4, centre[1] - 0.3, 1.0), (centre[0] - 0.5, centre[1] + 0.35, 0.5j)]
        value = lambda a, r: sum(c * np.exp(2j * np.pi * (u * a + v * r)) for u, v, c in waves)
        image = images.Image(value(rows, columns), (0.0, 0.0), step, centre, np.zeros(3), np.zeros(3), 1e9, "none")
        for at in ((70.3, 99.9), (64.05, 88.7)):
            self.assertLess(abs(image.at(at) - value(*at)), 3e-3)


class Warnings(unittest.TestCase):
    def test_their_own_limits_are_no_predictions(self):
        found = "motion compensation leaves an error: the peak loses 1.2 dB"
        problem = {"severity": "warning", "message": found, "found": "", "expected": "up to 0.02 rad, 0.1 dB"}
        problem["text"] = f"{found}; expected {problem['expected']}"
        texts = focusing_draws.warnings_of({"problems": [problem]})
        self.assertTrue(focusing_draws.fits({"db": 1.0, "rad": 0.0, "cells": 0.0}, texts))
        self.assertFalse(focusing_draws.fits({"db": 0.15, "rad": 0.0, "cells": 0.0}, texts))


if __name__ == "__main__":
    unittest.main()
