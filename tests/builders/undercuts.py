"""Undercuts: one or many, on both sides, closed by edges, by points, by two positions."""

from collections.abc import Iterator

from builders.entry import UNIT, Entry, Ring, box, columns, turned, under

TITLE = "Places that the generatrix cannot reach"

VALLEY: Ring = under([(0, 0), (3, 4), (6, 0)], 6)
ROUND: Ring = [(0, 0), (1, -1), (3, -1), (4, 0), (4, 2), (3, 3), (1, 3), (0, 2)]
STAIRCASE: Ring = under([(0, 0), (1, 1), (2, 1), (3, 3), (4, 3), (5, 1), (6, 1), (7, 0)], 5)


def entries() -> Iterator[Entry]:
    yield Entry("none", "A valley that G reaches whole", VALLEY, [(0, 0), (2, 0), (1, 6)])
    yield Entry("round-in-valley", "A round G in a valley", VALLEY, ROUND)
    yield Entry("square-in-valley", "A square in a valley", VALLEY, box(2, 2))
    yield Entry("staircase", "A stepped valley that a square reaches whole", STAIRCASE, UNIT)
    yield Entry("staircase-wide", "A stepped valley for a wider G", STAIRCASE, box(3, 1))
    yield Entry("below-and-above", "Undercuts below and above", BOTH, ROUND)
    yield Entry("facing", "Undercuts below and above that nearly meet", THIN, UNIT)
    yield Entry(
        "row", "A row of six undercuts", under([(k, 2 * (k % 2)) for k in range(13)], 4), ROUND
    )
    yield Entry(
        "row-rectilinear",
        "A row of rectilinear undercuts",
        under(columns([1, 1] * 5 + [1], [0, 3] * 5 + [0]), 5),
        box(2, 1),
    )
    yield Entry(
        "of-growing-width",
        "Undercuts, the last of which G can enter",
        under(columns([1, 1, 1, 1, 1, 3, 1], [0, 2, 0, 2, 0, 2, 0]), 4),
        box(2, 1),
    )
    yield Entry(
        "two-tips-in-one-valley",
        "Two tips that share a valley",
        VALLEY,
        turned(under([(0, 0), (1, -2), (2, 0), (3, -2), (4, 0)], 1)),
    )
    yield Entry(
        "deep-and-thin",
        "A gorge of depth 1000",
        under([(0, 0), (3, 0), (4, 1000), (5, 0), (8, 0)], 1001),
        ROUND,
    )
    yield Entry("wide-g", "A G wider than all of D", VALLEY, box(50, 1))


BOTH: Ring = [(0, 0), (3, 2), (6, 0), (6, 8), (3, 5), (0, 8)]
THIN: Ring = [(0, 0), (4, 4), (8, 0), (8, 9), (4, 5), (0, 9)]
