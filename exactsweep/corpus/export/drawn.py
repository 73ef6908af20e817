"""What a case consists of for programs that draw: named rings and segments."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from exactsweep.corpus.case import Case
from exactsweep.polygon import Point


class Figure(NamedTuple):
    """A ring or a segment of a case.

    Attributes:
        name: "directrix", "generatrix", "trajectory", "inner", "outer" or "exact fit".
        closed: whether it is a ring; a segment has two points.
        points: tuple of Point, a ring's first one not repeated.
    """

    name: str
    closed: bool
    points: Sequence[Point]


def figures(case: Case) -> Iterator[Figure]:
    """Yield the rings and segments of a case: its input, and the expected answer."""
    yield Figure("directrix", True, case.directrix_ring)
    yield Figure("generatrix", True, case.generatrix_ring)
    yield Figure("trajectory", True, case.trajectory.vertices)
    yield Figure("inner", True, case.inner.vertices)
    yield Figure("outer", True, case.outer.vertices)
    for fit in case.exact_fits:
        yield Figure("exact fit", False, fit)
