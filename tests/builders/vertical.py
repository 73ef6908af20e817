"""Vertical edges: at the ends, inside both chains, opposite each other."""

from collections.abc import Iterator
from fractions import Fraction

from builders.entry import UNIT, Entry, Ring, box, columns, mirrored, turned, under

TITLE = "Vertical edges at the ends and inside the chains"

DIAMOND: Ring = [(0, 0), (2, -2), (4, 0), (2, 2)]
LEFT_WALL: Ring = [(0, 0), (3, 1), (0, 4)]
STAIRS: Ring = under(columns([1, 1, 1, 1], [0, 1, 2, 3]), 5)
SLOT: Ring = under([(0, 0), (1, 0), (1, 2), (3, 2), (3, 0), (4, 0)], 3)
TEETH: Ring = under(columns([1] * 7, [0, 2, 0, 3, 0, 2, 0]), 5)
SAWTOOTH: Ring = under([(0, 0), (2, 2), (2, 0), (4, 2), (4, 0), (6, 2), (6, 0), (7, 0)], 4)
STEP: Ring = turned(under(columns([1, 2], [0, 1]), 3))
OVERHANG: Ring = [(0, 0), (6, 0), (6, 1), (7, 1), (7, 5), (6, 5), (6, 3), (0, 3)]
HALF = Fraction(1, 2)


def entries() -> Iterator[Entry]:
    yield Entry(
        "none", "No vertical edges, for comparison", DIAMOND, [(0, 0), (1, -1), (3, 0), (1, 2)]
    )
    yield Entry("left-of-g", "One at the left of G", DIAMOND, LEFT_WALL)
    yield Entry("right-of-g", "One at the right of G", DIAMOND, mirrored(LEFT_WALL))
    yield Entry("left-of-d", "One at the left of D", LEFT_WALL, DIAMOND)
    yield Entry(
        "left-of-both",
        "One at the left of each: of opposite sense, both in the answer",
        LEFT_WALL,
        LEFT_WALL,
    )
    yield Entry(
        "left-and-right",
        "One at the left of D, one at the right of G: they add up",
        LEFT_WALL,
        mirrored(LEFT_WALL),
    )
    yield Entry("stairs-up", "Stairs going up", STAIRS, UNIT)
    yield Entry("stairs-down", "Stairs going down", mirrored(STAIRS), UNIT)
    yield Entry("stairs-and-diamond", "Stairs, and no vertical edge of G", STAIRS, DIAMOND)
    yield Entry("stairs-and-stairs", "Stairs in stairs that fit", STAIRS, turned(STAIRS))
    yield Entry(
        "stairs-against-stairs",
        "Stairs against stairs of the other sense",
        STAIRS,
        turned(mirrored(STAIRS)),
    )
    yield Entry("wide-slot", "A slot wider than G", SLOT, UNIT)
    yield Entry(
        "wide-slot-diamond",
        "A slot wider than a G without vertical edges",
        SLOT,
        [(0, 0), (HALF, -1), (1, 0), (HALF, 1)],
    )
    yield Entry("narrow-slot", "A slot narrower than G", SLOT, box(3, 1))
    yield Entry("teeth", "Teeth, closer than G is wide", TEETH, box(2, 1))
    yield Entry("teeth-and-step", "Teeth around which a step goes", TEETH, STEP)
    yield Entry("saw-teeth", "Saw teeth with one vertical flank each", SAWTOOTH, UNIT)
    yield Entry(
        "saw-teeth-mirrored",
        "Saw teeth with the vertical flank on the other side",
        mirrored(SAWTOOTH),
        UNIT,
    )
    yield Entry("saw-in-saw", "Saw teeth in saw teeth", SAWTOOTH, turned(SAWTOOTH))
    yield Entry(
        "wall-of-g-inside",
        "A vertical edge inside G's top chain",
        DIAMOND,
        [(0, 0), (3, 0), (3, 1), (2, 1), (2, 3), (0, 3)],
    )
    yield Entry("overhang", "G's overhang keeps it out of D's corner", OVERHANG, OVERHANG)
    yield Entry(
        "wall-up-and-down",
        "Walls that meet at one abscissa, at the bottom and at the top",
        LIGHTNING,
        UNIT,
    )
    yield Entry(
        "needle",
        "A slot that narrows to nothing",
        under([(0, 0), (1, 0), (1, 3), (2, 0), (3, 0)], 4),
        box(HALF, 2),
    )


LIGHTNING: Ring = [(0, 0), (2, 0), (2, 1), (4, 1), (4, 4), (2, 4), (2, 3), (0, 3)]
