"""Slots that G fits exactly, and slots that it nearly fits."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from builders.entry import UNIT, Entry, Ring, box, columns, mapped, moved, scaled, turned, under

TITLE = "Slots that the generatrix fits exactly, and nearly"

NEAR = 10**15
# The first columns of the matrices by which slots are turned, in all quarters.
DIRECTIONS = [
    *[(0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (1, -1), (2, 1), (1, 3), (-1, 2)],
    *[(-3, 1), (-2, -1), (-1, -4), (1, -2), (4, -1), (1000, 1), (-1, 999)],
]
HORN: Ring = [(0, 0), (3, 0), (3, 1), (2, 1), (2, 2), (1, 2), (1, 1), (0, 1)]
TWO_HORNS: Ring = [(0, 0), (5, 0), (5, 3), (4, 3), (4, 1), (1, 1), (1, 2), (0, 2)]
HOUSE: Ring = [(0, 0), (2, 0), (2, 2), (1, 3), (0, 2)]
BLUNT: Ring = [(0, 0), (2, 0), (2, 2), (0, 2)]


def slot(width: Any, depth: Any, rim: int = 1) -> Ring:
    """A block with one slot in its bottom, from x = rim to x = rim + width."""
    return under(columns([rim, width, rim], [0, depth, 0]), depth + rim)


def slot_from_origin(width: Fraction) -> Ring:
    """A block with one slot in its bottom, from x = 0 on, all on binary64 where the width is."""
    return under([(-1, 0), (0, 0), (0, 2), (width, 2), (width, 0), (3, 0)], 3)


def entries() -> Iterator[Entry]:
    yield Entry("square", "A square into a slot as wide", slot(1, 2), UNIT)
    yield Entry(
        "square-from-above", "A square into a slot as wide, from above", turned(slot(1, 2)), UNIT
    )
    yield Entry("deep", "A slot deeper than G is high", slot(1, 4), UNIT)
    yield Entry("shallow", "A slot less deep than G is high", slot(1, 1), box(1, 3))
    yield Entry("level", "A slot exactly as deep as G is high", slot(1, 3), box(1, 3))
    yield Entry("fraction", "A slot a third wide", slot(Fraction(1, 3), 2), box(Fraction(1, 3), 1))
    yield Entry(
        "two-slots", "Two slots that both fit", under(columns([1] * 5, [0, 2, 0, 3, 0]), 5), UNIT
    )
    yield Entry(
        "slots-of-three-widths",
        "A slot that fits between a wider and a narrower one",
        THREE,
        box(2, 1),
    )
    yield Entry("both-sides", "A slot below and a slot above", BOTH_SIDES, UNIT)
    yield Entry(
        "uneven-rims",
        "The rims of the slot differ in height",
        under(columns([1, 1, 1], [0, 3, 1]), 5),
        UNIT,
    )
    yield Entry(
        "slanted-rims",
        "The rims of the slot are slanted",
        under([(0, 1), (1, 0), (1, 3), (2, 3), (2, 0), (3, 1)], 5),
        UNIT,
    )
    yield Entry("gable", "A gable into a slot with a flat end", slot(2, 4), HOUSE)
    yield Entry(
        "gable-into-gable",
        "A gable into a slot of its own shape",
        under([(0, 0), (1, 0), (1, 2), (2, 3), (3, 2), (3, 0), (4, 0)], 5),
        HOUSE,
    )
    yield Entry(
        "flat-into-gable",
        "A flat end into a slot with a gable",
        under([(0, 0), (1, 0), (1, 2), (2, 3), (3, 2), (3, 0), (4, 0)], 5),
        BLUNT,
    )
    yield Entry(
        "horn",
        "A horn into a slot, stopped by its base",
        under(columns([1, 1, 1], [0, 2, 0]), 3),
        HORN,
    )
    yield Entry(
        "two-horns",
        "Two horns, one of which fits at a time",
        under(columns([1, 1, 1], [0, 4, 0]), 5),
        TWO_HORNS,
    )
    yield Entry(
        "two-horns-two-slots",
        "Two horns into two slots at once",
        under(columns([1, 1, 3, 1, 1], [0, 4, 0, 4, 0]), 5),
        TWO_HORNS,
    )
    yield Entry(
        "comb-in-comb",
        "A comb into a comb",
        under(columns([1] * 7, [0, 2, 0, 2, 0, 2, 0]), 4),
        turned(under(columns([1] * 7, [0, 2, 0, 2, 0, 2, 0]), 4)),
    )
    yield Entry(
        "stepped-slot",
        "A slot that narrows to the width of G",
        under(columns([1, 1, 2, 1, 1], [0, 1, 4, 1, 0]), 5),
        box(2, 1),
    )
    yield Entry(
        "stepped-slot-fits-wide",
        "A slot that fits first and is too narrow then",
        under(columns([1, 1, 2, 1, 1], [0, 2, 4, 2, 0]), 5),
        box(4, 1),
    )
    yield Entry(
        "stepped-plug",
        "A stepped plug into a stepped slot",
        under(columns([1, 1, 2, 1, 1], [0, 2, 4, 2, 0]), 5),
        turned(under(columns([1, 2, 1], [2, 0, 2]), 3)),
    )
    yield Entry(
        "at-the-side",
        "Walls on one side only: a corner and no slot",
        under(columns([1, 2], [0, 2]), 4),
        box(2, 1),
    )
    yield Entry(
        "tapered-plug",
        "A plug that tapers: only its widest part fits",
        slot(2, 4),
        [(0, 0), (2, 0), (2, 1), (Fraction(3, 2), 3), (Fraction(1, 2), 3), (0, 1)],
    )
    yield Entry(
        "moved",
        "A fit that starts elsewhere, with a reference point of its own",
        moved(slot(1, 2), 7, -3),
        UNIT,
        reference=(1, 1),
    )
    yield Entry(
        "turned",
        "A slanted slot, found in a slanted direction",
        mapped(slot(1, 2), (3, -4, 4, 3)),
        mapped(UNIT, (3, -4, 4, 3)),
    )
    yield Entry(
        "sheared",
        "A slot whose floor is slanted",
        mapped(slot(1, 2), (1, 0, 1, 1)),
        mapped(UNIT, (1, 0, 1, 1)),
    )
    near = ("near-fit",)
    yield Entry(
        "too-narrow",
        "A slot too narrow by one part in 10^15",
        slot(NEAR - 1, NEAR, NEAR),
        box(NEAR, NEAR // 2),
        near,
    )
    yield Entry(
        "exact-at-10-15",
        "A slot of 10^15 that fits",
        slot(NEAR, NEAR, NEAR),
        box(NEAR, NEAR // 2),
        near,
    )
    yield Entry(
        "too-wide",
        "A slot wider by one part in 10^15",
        slot(NEAR + 1, NEAR, NEAR),
        box(NEAR, NEAR // 2),
        near,
    )
    yield Entry(
        "one-ulp",
        "A slot wider than 1 by the least binary64 step",
        slot_from_origin(1 + Fraction(1, 2**52)),
        UNIT,
        near,
    )
    yield Entry(
        "minus-one-ulp",
        "A slot narrower than 1 by the least binary64 step",
        slot_from_origin(1 - Fraction(1, 2**53)),
        UNIT,
        near,
    )
    yield Entry("tenth", "A slot of 1/10, G of 1/10: as doubles they may differ", *TENTHS, near)
    yield Entry(
        "opening-slot",
        "A slot of G's width, wider at its rim by one part in 10^15",
        leaning(2 * NEAR, 2 * NEAR + 1),
        box(NEAR, NEAR),
        near,
    )
    yield Entry(
        "closing-slot",
        "A slot of G's width at its rim, narrower inside by one part in 10^15",
        leaning(2 * NEAR - 1, 2 * NEAR),
        box(NEAR, NEAR),
        near,
    )
    yield Entry("huge", "A fit at 10^30", scaled(slot(1, 2), 10**30), scaled(UNIT, 10**30))
    yield Entry(
        "tiny",
        "A fit at 10^-30",
        scaled(slot(1, 2), Fraction(1, 10**30)),
        scaled(UNIT, Fraction(1, 10**30)),
    )
    for a, b in DIRECTIONS:
        turn = (a, -b, b, a)
        slug = f"along-{a}-{b}".replace("--", "-minus-")
        title = f"G slides in the direction of ({-b}, {a})"
        yield Entry(slug, title, mapped(slot(1, 2), turn), mapped(UNIT, turn))
        if (a + b) % 2:
            yield Entry(
                f"{slug}-gable",
                f"{title}, a gable into a slot with a flat end",
                mapped(slot(2, 4), turn),
                mapped(HOUSE, turn),
                reference=(Fraction(a, 3), Fraction(b, 7)),
            )
    for slug, title, factor in [
        ("beyond-binary64", "A fit at 10^320", Fraction(10**320)),
        ("below-binary64", "A fit at 10^-340", Fraction(1, 10**340)),
        ("25-digits", "A slot whose width has 25 digits", Fraction(10**24 + 7)),
        ("prime", "A slot whose width has a prime denominator", Fraction(10**20, 10**9 + 7)),
    ]:
        yield Entry(slug, title, scaled(slot(1, 2), factor), scaled(UNIT, factor))
        turn = (3, -4, 4, 3)
        d, g = (mapped(scaled(ring, factor), turn) for ring in (slot(1, 2), UNIT))
        yield Entry(f"{slug}-slanted", f"{title}, slanted", d, g)
    digits = 10**24
    for slug, title, width in [
        ("25-digits-too-narrow", "A slot too narrow by one part in 10^24", digits - 1),
        ("25-digits-too-wide", "A slot wider by one part in 10^24", digits + 1),
    ]:
        yield Entry(slug, title, slot(width, digits, digits), box(digits, 5), near)


THREE: Ring = under(columns([1, 3, 1, 2, 1, 1, 1], [0, 2, 0, 2, 0, 2, 0]), 4)
BOTH_SIDES: Ring = [
    *columns([1, 1, 3], [0, 2, 0]),
    *reversed(columns([3, 1, 1], [6, 4, 6])),
]
# 3/10 - 2/10 is 1/10, though not with doubles.
TENTHS = (
    under(
        [
            (0, 0),
            (Fraction(2, 10), 0),
            (Fraction(2, 10), 1),
            (Fraction(3, 10), 1),
            (Fraction(3, 10), 0),
            (1, 0),
        ],
        2,
    ),
    box(Fraction(1, 10), Fraction(1, 2)),
)


def leaning(inside: int, rim: int) -> Ring:
    """A slot from x = NEAR to one abscissa inside and another at the rim."""
    return under(
        [(0, 0), (NEAR, 0), (NEAR, 2 * NEAR), (inside, 2 * NEAR), (rim, 0), (3 * NEAR, 0)],
        3 * NEAR,
    )
