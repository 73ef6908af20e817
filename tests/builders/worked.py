"""Pairs whose answers are short enough to be worked out by hand."""

from collections.abc import Iterator
from fractions import Fraction

from builders.entry import UNIT, Entry, Ring, box, mirrored, scaled, under

TITLE = "Answers to be worked out by hand"

STAIR: Ring = [(0, 0), (2, 0), (2, 1), (4, 1), (4, 3), (0, 3)]
TENT: Ring = [(-4, -4), (0, 0), (4, -4), (4, 1), (-4, 1)]
HORNS: Ring = [(0, -12), (12, -12), (12, 0), (10, 1), (10, -10), (2, -10), (2, 1), (0, 0)]
TAIL: Ring = [(0, -1), (2, -1), (2, 2), (1, 0), (0, 2)]
ROOF: Ring = [(0, 0), (2, 2), (4, 0), (4, 4), (0, 4)]


def entries() -> Iterator[Entry]:
    yield Entry("unit-squares", "A unit square around a unit square", UNIT, UNIT)
    yield Entry(
        "triangles", "A right triangle around itself", [(0, 0), (1, 0), (0, 1)], triangle(1)
    )
    yield Entry("triangle-square", "A triangle around a square", box(2, 2), triangle(1))
    yield Entry("square-triangle", "A square around a triangle", triangle(4), UNIT)
    yield Entry("step-up", "A wall inside the bottom of D, on the right", STAIR, UNIT)
    yield Entry("step-down", "A wall inside the bottom of D, on the left", mirrored(STAIR), UNIT)
    yield Entry("roof", "A square caught by its two upper corners", ROOF, UNIT)
    yield Entry("two-horns", "Two horns, each closing half of a pocket", TENT, HORNS)
    yield Entry(
        "swallowtail",
        "The paths of two tips close one pocket",
        under([(0, 0), (3, 3), (6, 0)], 4),
        TAIL,
    )
    yield Entry(
        "bar-over-notch",
        "A bar slides over a notch and closes it all the while",
        under([(0, 0), (2, 0), (3, 1), (4, 0), (6, 0)], 4),
        box(3, 1),
    )
    yield Entry(
        "two-pockets-in-a-point",
        "Two undercuts that touch in a point",
        under([(0, 0), (1, 0), (2, 2), (3, 0), (4, 2), (5, 0), (6, 0)], 3),
        box(5, 1),
    )
    yield Entry(
        "pocket-at-a-wall",
        "An undercut that ends on a wall",
        under([(0, 1), (1, 1), (1, 3), (4, 0), (5, 0)], 4),
        UNIT,
    )
    yield Entry("thirds", "The swallowtail pair on thirds", scaled(TENT, Fraction(1, 3)), TAIL)
    yield Entry("spike-in-a-v", "A spike reaches the bottom of a blunter notch", TENT, SPIKE)
    yield Entry("blunt-in-a-v", "A blunt tip does not reach the bottom of a notch", TENT, BLUNT)
    yield Entry("same-angle-in-a-v", "A tip of exactly the angle of the notch", TENT, SAME)


SPIKE: Ring = [(0, 0), (2, 0), (1, 5)]
BLUNT: Ring = [(0, 0), (4, 0), (2, 1)]
SAME: Ring = [(0, 0), (4, 0), (2, 2)]


def triangle(side: int) -> Ring:
    return [(0, 0), (side, 0), (0, side)]
