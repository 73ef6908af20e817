"""Pairs that touch as they are given, in every way, and pairs that only seem to."""

from collections.abc import Iterator
from fractions import Fraction

from builders.entry import UNIT, Entry, Ring, box, moved, under

TITLE = "Pairs that touch, overlap or nest as they are given"

TRIANGLE: Ring = [(0, 0), (4, 0), (0, 4)]
NOTCH: Ring = under([(0, 0), (2, 2), (4, 0)], 4)


def entries() -> Iterator[Entry]:
    yield Entry("corner-corner", "A corner on a corner", box(2, 2), box(1, 1, 2, 2))
    yield Entry("corner-edge", "A corner on an edge", TRIANGLE, box(1, 1, 2, 2))
    yield Entry("edge-edge", "An edge on a part of an edge", box(3, 3), box(1, 1, 3, 1))
    yield Entry(
        "edge-edge-end", "An edge on an edge, with a corner in common", box(3, 3), box(1, 1, 3, 0)
    )
    yield Entry("whole-edge", "A whole edge in common", UNIT, box(1, 1, 1, 0))
    yield Entry(
        "two-points",
        "Two points of a notch at once",
        NOTCH,
        moved(UNIT, Fraction(3, 2), Fraction(1, 2)),
    )
    yield Entry("tip-in-notch", "A tip fills a notch", NOTCH, [(0, 0), (4, 0), (2, 2)])
    yield Entry("overlap", "Overlapping, which does not matter", box(3, 3), box(2, 2, 1, 1))
    yield Entry("inside", "G inside D, which does not matter", box(9, 9), box(1, 1, 4, 4))
    yield Entry("around", "D inside G, which does not matter", box(1, 1, 4, 4), box(9, 9))
    yield Entry("touching-inside", "G inside D, an edge in common", box(9, 9), box(1, 1, 4, 0))
    yield Entry("apart", "Far apart", UNIT, box(1, 1, 10**6, -(10**6)))
    yield Entry(
        "nearly", "Apart by one part in 10^18", UNIT, moved(UNIT, 1 + Fraction(1, 10**18), 0)
    )
