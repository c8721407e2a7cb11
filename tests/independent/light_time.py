"""The way of a pulse to a point and back, every motion at its own time: docs/theory/echo-model.md, "Light time"."""

import typing

import numpy as np

ROUNDS = 60  # The error falls by speed over c with each.


class Flight(typing.NamedTuple):
    """What leaves at a send time, met by a point and received."""

    delay_s: float
    out_s: float  # Until the point is met.
    look: np.ndarray  # From the radar when it sends to the point when it is met, metres, world axes.
    doppler: float  # D = tau'/(1 + tau').
    acceleration: float  # a = tau''/(1 + tau')^3, 1/s.


def settled(function, start):
    """The fixed point of a contraction, to the last digits."""
    value = start
    for _ in range(ROUNDS):
        last, value = value, function(value)
        if abs(value - last) <= 2e-19 * abs(value):
            break
    return value


def times_of_flight(radar_at, point_at, send_time, light_speed):
    """Seconds on the way out and on both ways; the arguments give places at a time."""
    begin = radar_at(send_time)

    def arrival(out):
        return np.sqrt(np.sum((point_at(send_time + out) - begin) ** 2)) / light_speed

    out = settled(arrival, np.longdouble(0))
    met = point_at(send_time + out)

    def reception(both):
        return out + np.sqrt(np.sum((radar_at(send_time + both) - met) ** 2)) / light_speed

    return out, settled(reception, 2 * out)


def derivatives(sent, met, received, light_speed):
    """tau' and tau'' from place, velocity and acceleration of radar, point and radar at their own times."""
    leg_1, leg_2 = met[0] - sent[0], received[0] - met[0]
    length_1, length_2 = np.sqrt(leg_1 @ leg_1), np.sqrt(leg_2 @ leg_2)
    along_1, along_2 = leg_1 / length_1, leg_2 / length_2
    closing_1, closing_2 = light_speed - along_1 @ met[1], light_speed - along_2 @ received[1]
    rate_1 = (light_speed - along_1 @ sent[1]) / closing_1
    rate_2 = rate_1 * (light_speed - along_2 @ met[1]) / closing_2
    drift_1, drift_2 = met[1] * rate_1 - sent[1], received[1] * rate_2 - met[1] * rate_1
    swing_1 = (drift_1 @ drift_1 - (along_1 @ drift_1) ** 2) / length_1
    swing_2 = (drift_2 @ drift_2 - (along_2 @ drift_2) ** 2) / length_2
    bend_1 = (swing_1 + along_1 @ (met[2] * rate_1**2 - sent[2])) / closing_1
    bend_2 = swing_2 + along_2 @ (received[2] * rate_2**2 - met[2] * rate_1**2)
    bend_2 = (bend_2 + bend_1 * (light_speed - along_2 @ met[1])) / closing_2
    return rate_2 - 1, bend_2


def flight(radar, point, send_time, light_speed):
    """The first two arguments give lists of place, velocity and acceleration at a time, or of as many as they are asked for."""
    out, delay = times_of_flight(lambda t: radar(t, 1)[0], lambda t: point(t, 1)[0], send_time, light_speed)
    sent, met, received = radar(send_time, 3), point(send_time + out, 3), radar(send_time + delay, 3)
    rate, bend = derivatives(sent, met, received, light_speed)
    return Flight(delay, out, met[0] - sent[0], rate / (1 + rate), bend / (1 + rate) ** 3)
