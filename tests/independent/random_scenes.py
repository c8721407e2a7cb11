"""The scene of a number: ordinary ones, and in every other place those in which the exact light time matters."""

from fast_scenes import FAMILIES, FastDraw
from scenes import Draw


def family(number):
    """Name of the family of a scene, or None of an ordinary one."""
    return list(FAMILIES)[number // 2 % len(FAMILIES)] if number % 2 == 0 else None


def random_scene(number):
    return FastDraw(number, family(number)).scene() if family(number) else Draw(number).scene()
