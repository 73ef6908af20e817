"""Pieces of the trajectory that touch, or several that meet in one point."""

from collections.abc import Iterator

from builders.entry import UNIT, Entry, Ring, box, mirrored, under
from exactsweep.corpus.generator.growing import comb

TITLE = "Pieces of the trajectory that touch, or meet in one point"

FLAG = ("tangent",)
KITE: Ring = [(0, 0), (2, -1), (4, 0), (2, 4)]
ROOF: Ring = [(0, 0), (4, 0), (2, 2)]
CROWN: Ring = [(0, -1), (8, -1), (8, 2), (6, 0), (4, 2), (2, 0), (0, 2)]


def entries() -> Iterator[Entry]:
    yield Entry(
        "tooth-to-the-line",
        "A tooth that just reaches the line of its neighbours",
        under([(0, 0), (2, -2), (4, 0), (6, -2), (8, 0), (10, -2), (12, 0)], 3),
        box(4, 1),
        FLAG,
    )
    yield Entry(
        "tooth-short-of-the-line",
        "A tooth that ends above the line of its neighbours by one part in 10^12",
        under(SHORT, 3 * 10**12),
        box(4 * 10**12, 10**12),
        FLAG,
    )
    yield Entry(
        "tooth-beyond-the-line",
        "A tooth that ends below the line of its neighbours by one part in 10^12",
        under(BEYOND, 3 * 10**12),
        box(4 * 10**12, 10**12),
        FLAG,
    )
    yield Entry(
        "three-through-a-point",
        "Three pieces cross in one point",
        under([(0, 0), (2, -6), (4, 0), (5, -3), (6, 0), (8, -6), (10, 0)], 2),
        ROOF,
        FLAG,
    )
    yield Entry(
        "three-corners-at-once",
        "G rests on three corners of D",
        under([(0, 0), (1, -2), (3, 0), (4, -2), (6, 0), (7, -2), (8, 0)], 2),
        [(0, 0), (8, 0), (4, -4)],
        FLAG,
    )
    yield Entry(
        "two-corners-one-slope",
        "G's slope rests on two corners in its own line",
        under([(0, 0), (1, -1), (2, 0), (3, -3), (4, 0), (5, -5), (6, 0)], 2),
        [(0, 0), (8, -8), (9, 0)],
        FLAG,
    )
    yield Entry(
        "crown-on-teeth",
        "All tips of a crown reach all notches at once",
        under([(0, 0), (2, 2), (4, 0), (6, 2), (8, 0), (10, 2), (12, 0)], 4),
        CROWN,
        FLAG,
    )
    yield Entry(
        "crown-on-a-plane", "All tips of a crown slide along one edge", box(20, 5), CROWN, FLAG
    )
    yield Entry(
        "crown-on-a-slope",
        "Tips of a crown along a slope through all of them",
        under([(0, 0), (10, 5), (12, 0)], 8),
        [(0, -1), (8, -1), (8, 5), (6, 2), (4, 3), (2, 0), (0, 1)],
        FLAG,
    )
    yield Entry(
        "hidden-touch",
        "A piece that touches the envelope from above only",
        under([(0, 0), (4, -4), (8, 0), (9, -1), (10, 0), (14, -4), (18, 0)], 3),
        box(6, 2),
        FLAG,
    )
    yield Entry(
        "equal-teeth", "Equal teeth: all crossings at one height", comb(16, 2, 6), UNIT, FLAG
    )
    yield Entry(
        "equal-teeth-kite", "Equal teeth, no edge parallel to one of G", comb(12, 3, 7), KITE, FLAG
    )
    yield Entry(
        "mirror-pair",
        "Crossings on the axis of a pair that is its own mirror image",
        under([(-6, 0), (-3, -5), (0, 0), (3, -5), (6, 0)], 2),
        [(-2, 0), (0, -3), (2, 0), (0, 2)],
        FLAG,
    )
    yield Entry(
        "flush-pocket",
        "A pocket closed by two corners and the edge between them",
        under([(0, 0), (1, 3), (4, 3), (5, 0)], 5),
        mirrored([(0, 0), (5, 0), (4, 3), (1, 3)]),
        FLAG,
    )


SHORT: Ring = [
    (0, 0),
    (2 * 10**12, -2 * 10**12),
    (4 * 10**12, 0),
    (6 * 10**12, -2 * 10**12 + 1),
    (8 * 10**12, 0),
    (10 * 10**12, -2 * 10**12),
    (12 * 10**12, 0),
]
BEYOND: Ring = [(x, y - 2 if y % 10 == 1 else y) for x, y in SHORT]
