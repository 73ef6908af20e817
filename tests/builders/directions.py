"""Pairs that are monotone to a shared direction other than the x-axis."""

from collections.abc import Iterator

from builders.entry import UNIT, Entry, Ring, box, columns, mapped, under

TITLE = "Monotone to another direction than the x-axis"

JAWS: Ring = under([(0, 0), (2, 0), (2, 3), (5, 4), (6, 0), (8, 0)], 6)
HOUSE: Ring = [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]
SLOT: Ring = under(columns([1, 1, 1], [0, 2, 0]), 4)
HOOK: Ring = [(0, 0), (6, 0), (6, 1), (5, 2), (3, 1), (1, 3), (0, 3)]
# The letter C: every horizontal line meets it in one piece, and vertical ones in two.
C: Ring = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (3, 3), (3, 4), (0, 4)]
E: Ring = [
    (0, 0),
    (3, 0),
    (3, 1),
    (1, 1),
    (1, 2),
    (2, 2),
    (2, 3),
    (1, 3),
    (1, 4),
    (3, 4),
    (3, 5),
    (0, 5),
]
# Monotone within a narrow wedge of directions only.
DART: Ring = [(0, 0), (10, 9), (9, 10), (5, 6), (4, 6)]


def entries() -> Iterator[Entry]:
    for slug, title, matrix in [
        ("y", "The y-axis", (0, -1, 1, 0)),
        ("diagonal", "The diagonal, with room to spare", (1, -1, 1, 1)),
        ("3-4-5", "The direction (3, 4)", (3, -4, 4, 3)),
        ("steep", "The direction (1, 1000)", (1, -1000, 1000, 1)),
        ("far-from-all-axes", "The direction (987, 610)", (987, -610, 610, 987)),
        ("large", "A direction of 15 digits", (10**15, -1, 1, 10**15)),
    ]:
        yield Entry(slug, title, mapped(JAWS, matrix), mapped(HOUSE, matrix))
        yield Entry(
            f"{slug}-fit", f"{title}: an exact fit", mapped(SLOT, matrix), mapped(UNIT, matrix)
        )
    yield Entry("letters", "A letter C around a letter E", E, C)
    yield Entry("letters-back", "A letter E around a letter C", C, E)
    yield Entry("letter-box", "A box into the mouth of a letter C, lying", C, box(2, 1))
    yield Entry("letter-plug", "A plug that fits both mouths of a letter E", E, box(1, 1))
    yield Entry("dart", "A dart with few directions to choose from", DART, HOOK)
    yield Entry("dart-itself", "A dart around itself", DART, DART)
    yield Entry("only-one-direction", "Two pairs of jaws with the x-axis alone in common", *ONLY)


ONLY = (
    [
        (0, 0),
        (2, 0),
        (2, 2),
        (4, 2),
        (4, 0),
        (6, 0),
        (6, 8),
        (4, 8),
        (4, 6),
        (2, 6),
        (2, 8),
        (0, 8),
    ],
    under(columns([1, 1, 1], [0, 2, 0]), 3),
)
