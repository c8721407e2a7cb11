"""Where platforms are and how they turn, with the first two derivatives by time: docs/theory/frames.md.

Numbers keep the precision of the time that they are asked for; a time of 80 bits gives results of 80 bits.
"""

import typing

import numpy as np

RADIANS_PER_DEGREE = np.arccos(np.longdouble(-1)) / 180


class Pose(typing.NamedTuple):
    """A platform at an instant: lists of a quantity and its first two derivatives, in metres, seconds and radians."""

    place: list
    world_from_platform: list
    pitch: float
    yaw: float

    def of(self, point):
        """Place, velocity and acceleration of a point of the platform in the world."""
        return [origin + rotation @ point for origin, rotation in zip(self.place, self.world_from_platform)]


def direction(azimuth, elevation):
    """Unit vector; azimuth clockwise from y towards x, elevation up."""
    level = np.cos(elevation)
    return np.array([np.sin(azimuth) * level, np.cos(azimuth) * level, np.sin(elevation)])


def angles_of(vector):
    """Azimuth and elevation of a vector."""
    return np.arctan2(vector[0], vector[1]), np.arctan2(vector[2], np.hypot(vector[0], vector[1]))


def wrapped(angle):
    return (angle + np.pi) % (2 * np.pi) - np.pi


def angle_between(x, y):
    """atan2(x, y) and its first two derivatives from those of x and y, where they are given."""
    if len(x) == 1:
        return [np.arctan2(x[0], y[0])]
    square, half_slope = x[0] ** 2 + y[0] ** 2, x[0] * x[1] + y[0] * y[1]
    rate = (x[1] * y[0] - x[0] * y[1]) / square
    return [np.arctan2(x[0], y[0]), rate, (x[2] * y[0] - x[0] * y[2] - 2 * rate * half_slope) / square]


def length_of(x, y):
    """Root of x^2 + y^2 and its first two derivatives from those of x and y, where they are given."""
    length = np.hypot(x[0], y[0])
    if len(x) == 1:
        return [length]
    rate = (x[0] * x[1] + y[0] * y[1]) / length
    return [length, rate, (x[1] ** 2 + x[0] * x[2] + y[1] ** 2 + y[0] * y[2] - rate**2) / length]


def cross_matrix(axis):
    """What a vector product with the unit vector of axis 0, 1 or 2 does."""
    cross = np.zeros((3, 3))
    cross[(axis + 2) % 3, (axis + 1) % 3], cross[(axis + 1) % 3, (axis + 2) % 3] = 1.0, -1.0
    return cross


CROSS = [cross_matrix(axis) for axis in range(3)]
ACROSS = [-cross @ cross for cross in CROSS]
IDENTITY = np.eye(3)


def turn(axis, angle):
    """Right-handed rotation about axis 0, 1 or 2 with its first two derivatives, from those of the angle, where they are
    given."""
    cross, across, sine, cosine = CROSS[axis], ACROSS[axis], np.sin(angle[0]), np.cos(angle[0])
    matrix = IDENTITY + sine * cross - (1 - cosine) * across
    if len(angle) == 1:
        return [matrix]
    by_angle = cosine * cross - sine * across
    return [
        matrix,
        by_angle * angle[1],
        by_angle * angle[2] - (sine * cross + cosine * across) * angle[1] ** 2,
    ]


def product(a, b):
    """Of two matrices that change with time, and its first two derivatives where theirs are given."""
    if len(a) == 1:
        return [a[0] @ b[0]]
    return [a[0] @ b[0], a[1] @ b[0] + a[0] @ b[1], a[2] @ b[0] + 2 * a[1] @ b[1] + a[0] @ b[2]]


class Kinematics:
    """The motion of platforms. Each rule is a method, so that a test can put a wrong one in its place.

    Light time needs places alone, which take a third of the time: `orders` says how much is asked for, 1 place and rotation,
    3 their first two derivatives as well.
    """

    def track(self, platform, time, orders):
        """Position and as many of its derivatives."""
        if platform.trajectory is None:
            return [np.array(platform.position, type(time)), *[np.zeros(3)] * orders]
        return [np.array([curve.derivative(time, order) for curve in platform.trajectory]) for order in range(orders + 1)]

    def alignment(self, path):
        """What "align x axis to path" adds to the angles about x, y and z, with one derivative less than the path."""
        x, y, z = ([slope[axis] for slope in path[1:]] for axis in range(3))
        azimuth, elevation = angle_between(x, y), angle_between(z, length_of(x, y))
        azimuth[0] = azimuth[0] - 90 * RADIANS_PER_DEGREE
        return [[0.0] * len(azimuth), elevation, azimuth]

    def motion(self, platform, time, orders=3):
        path = self.track(platform, time, orders)
        angles = []
        for axis in range(3):
            constant, rate = platform.rotation[axis], platform.rotation_rate[axis]
            curve = platform.rotation_curves and platform.rotation_curves[axis]
            angle = [curve.derivative(time, order) for order in range(orders)] if curve else [constant, 0.0, 0.0][:orders]
            even = [rate * time, rate, 0.0]
            angles.append([RADIANS_PER_DEGREE * (a + b) for a, b in zip(angle, even)])
        if platform.aligned:
            angles = [[a + b for a, b in zip(*both)] for both in zip(angles, self.alignment(path))]
        roll, pitch, yaw = (turn(axis, [-order for order in angles[axis]]) for axis in range(3))
        rotation = product(product(yaw, pitch), roll)  # Rz(-c) Ry(-b) Rx(-a) (thesis 6.1).
        return Pose(path[:orders], rotation, float(angles[1][0]), float(angles[2][0]))
