"""Where the reference point is: it moves the trajectory and the exact fits, and nothing else."""

from collections.abc import Iterator
from fractions import Fraction

from builders.entry import UNIT, Entry, Ring, columns, mapped, moved, under

TITLE = "Reference points inside, on, outside and far away from the generatrix"

SLOT: Ring = under(columns([1, 1, 1], [0, 2, 0]), 4)
HOUSE: Ring = [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]
LEAF: Ring = [(0, 0), (3, -2), (7, 1), (4, 3)]


def entries() -> Iterator[Entry]:
    for slug, title, point in [
        ("vertex", "A vertex of G", (2, 1)),
        ("edge", "The middle of an edge of G", (1, 0)),
        ("inside", "A point inside G", (1, 1)),
        ("outside", "A point outside G", (-5, 9)),
        (
            "thirds",
            "A point on thirds, off the grid of the polygons",
            (Fraction(1, 3), Fraction(-2, 3)),
        ),
        ("far", "A point 10^15 away", (10**15, -(10**15))),
        ("huge-fraction", "A point with a denominator of 10^18", (Fraction(1, 10**18), 0)),
    ]:
        yield Entry(slug, title, LEAF, HOUSE, reference=point)
    yield Entry(
        "moved-along",
        "G moved, its reference point with it: the same trajectory",
        LEAF,
        moved(HOUSE, 40, 50),
        reference=(40, 50),
    )
    yield Entry("fits", "An exact fit moves with the reference point", SLOT, UNIT, reference=(1, 1))
    yield Entry(
        "fits-elsewhere",
        "An exact fit, the reference point off the grid",
        SLOT,
        UNIT,
        reference=(Fraction(1, 7), 3),
    )
    for slug, title, point in [
        ("halves", "In the middle of G, on halves", (Fraction(1, 2), Fraction(3, 2))),
        ("sevenths", "On sevenths and elevenths", (Fraction(5, 7), Fraction(-9, 11))),
        ("tenths", "On tenths, which doubles do not hold", (Fraction(1, 10), Fraction(7, 10))),
        ("far-half", "Half a unit beside a point 10^18 away", (10**18 + Fraction(1, 2), 1)),
        ("long", "With a denominator of 40 digits", (Fraction(1, 10**40 + 1), Fraction(2, 3))),
        ("tiny", "A point 10^-400 beside the origin", (Fraction(1, 10**400), 0)),
    ]:
        yield Entry(f"fraction-{slug}", title, LEAF, HOUSE, reference=point)
        yield Entry(f"fraction-{slug}-fit", f"{title}, and a fit", SLOT, UNIT, reference=point)
        d, g = (mapped(ring, (3, -4, 4, 3)) for ring in (SLOT, HOUSE))
        title = f"{title}, a slanted pair"
        yield Entry(f"fraction-{slug}-slanted", title, d, g, reference=point)
