"""A polygon around itself, its inverse, its mirror image, and around larger copies."""

from collections.abc import Iterator
from fractions import Fraction

from builders.entry import Entry, Ring, mirrored, moved, scaled, turned, under

TITLE = "A polygon around itself, around its inverse, and around copies of another size"

TRIANGLE: Ring = [(0, 0), (3, 1), (1, 4)]
OCTAGON: Ring = [(0, 0), (1, -1), (3, -1), (4, 0), (4, 2), (3, 3), (1, 3), (0, 2)]
ZIGZAG: Ring = [(0, 0), (2, -3), (4, 1), (7, -2), (9, 0), (7, 3), (5, 2), (2, 5)]
TOWER: Ring = [(0, 0), (6, 0), (6, 1), (7, 1), (7, 5), (6, 5), (6, 3), (0, 3)]
CHANNEL: Ring = under([(0, 0), (1, 0), (1, 2), (2, 2), (2, 0), (3, 0)], 3)
SHAPES = {
    "triangle": TRIANGLE,
    "octagon": OCTAGON,
    "zigzag": ZIGZAG,
    "tower": TOWER,
    "channel": CHANNEL,
}


def entries() -> Iterator[Entry]:
    for name, shape in SHAPES.items():
        yield Entry(f"{name}-itself", f"{name.capitalize()} around itself, in place", shape, shape)
        yield Entry(
            f"{name}-inverse", f"{name.capitalize()} around its inverse", turned(shape), shape
        )
    yield Entry(
        "zigzag-moved", "Zigzag around itself, moved", moved(ZIGZAG, 100, Fraction(-7, 3)), ZIGZAG
    )
    yield Entry("zigzag-mirrored", "Zigzag around its mirror image", mirrored(ZIGZAG), ZIGZAG)
    yield Entry("zigzag-double", "Zigzag around itself, twice as large", scaled(ZIGZAG, 2), ZIGZAG)
    yield Entry(
        "zigzag-half", "Zigzag around itself, half as large", scaled(ZIGZAG, Fraction(1, 2)), ZIGZAG
    )
    yield Entry(
        "triangle-thousand",
        "Triangle around itself, a thousandfold",
        scaled(TRIANGLE, 1000),
        TRIANGLE,
    )
    yield Entry(
        "octagon-thousandth",
        "Octagon around its thousandth",
        scaled(OCTAGON, Fraction(1, 1000)),
        OCTAGON,
    )
