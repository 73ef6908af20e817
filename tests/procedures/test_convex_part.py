"""Convex parts worked by hand: what of a pair matters, where it is cut, and how high it is."""

from fractions import Fraction
from math import inf

import pytest

from exactsweep.numbers.number import Vertex
from exactsweep.procedures.convex_part import (
    ConvexPart,
    CrossingPart,
    Slope,
    round_outwards,
    take_whole,
)
from exactsweep.procedures.envelope import Break, Envelope

# Slopes -1 and 1, and of the other chain -1, 0 and 2: times the unit.
CORNER: list[Vertex] = [(0, 0), (2, -2), (4, 0)]
BOWL: list[Vertex] = [(10, 10), (12, 8), (13, 8), (15, 12)]
UNIT = 100


def make(points: list[Vertex], flattest: Slope = -inf, steepest: Slope = inf) -> ConvexPart:
    return take_whole(points, UNIT)._replace(flattest=flattest, steepest=steepest)


def cross(part: ConvexPart, left: Break | None = None, right: Break | None = None) -> CrossingPart:
    """The same part by its lines, its ends cut."""
    whole = Envelope.of(part.points)
    breaks = [left or whole.breaks[0], *whole.breaks[1:-1], right or whole.breaks[-1]]
    return CrossingPart(whole.pieces, breaks, part.flattest, part.steepest, part.slopes)


@pytest.mark.parametrize(
    ("part", "chain", "expected"),
    [
        # All of both; edges of slope -1 become one.
        (make(CORNER), make(BOWL), [(10, 10), (14, 6), (15, 6), (17, 8), (19, 12)]),
        # Nothing steeper than the last edge.
        (make(CORNER, -UNIT, UNIT), make(BOWL), [(10, 10), (14, 6), (15, 6), (17, 8)]),
        # Nothing of the part, which is flatter than all of the chain, or steeper.
        (
            make(CORNER, -inf, inf),
            make([(0, 0), (1, 2), (2, 5)], 2 * UNIT),
            [(4, 0), (5, 2), (6, 5)],
        ),
        (
            make(CORNER, -inf, inf),
            make([(0, 5), (1, 2), (2, 0)], -inf, -2 * UNIT),
            [(0, 5), (1, 2), (2, 0)],
        ),
        # Nothing of the chain.
        (make(CORNER, 0), make([(0, 0), (1, -1)]), [(1, -1), (3, -3), (5, -1)]),
        (make(CORNER, -inf, 2 * UNIT), make([(0, 0), (1, 3)]), [(0, 0), (2, -2), (4, 0)]),
    ],
)
def test_what_matters_of_two_parts(
    part: ConvexPart, chain: ConvexPart, expected: list[Vertex]
) -> None:
    for one in (part, cross(part)):
        found = one.sweep(chain, 7)
        assert found is not None
        assert [*found] == expected
        assert found.sources == [7] * (len(expected) - 1)


def test_parts_without_common_slopes_sweep_nothing() -> None:
    chains: list[list[Vertex]] = [[(0, 0), (1, 2), (2, 5)], [(0, 5), (1, 2), (2, 0)]]
    part = make(CORNER, -UNIT, UNIT)
    for points, first, last in zip(chains, (2, -3), (3, -2), strict=True):
        chain = make(points, first * UNIT, last * UNIT)
        for one in (part, cross(part)):
            assert one.sweep(chain, 7) is None
        whole = part.sweep(make(points, -UNIT, UNIT), 7)
        assert whole is not None


def test_an_edge_that_is_cut_is_swept_as_far_as_it_holds() -> None:
    cut = cross(make(CORNER, -UNIT, UNIT), (1, 2), (7, 2))
    both, half = cut.sweep(make(BOWL), 0), cut.sweep(make([(0, 0), (1, 0)], 0), 0)
    assert both is not None
    assert half is not None
    ends = [Fraction(19, 2), 6, 6, Fraction(15, 2)]
    assert [*both] == [*zip([Fraction(21, 2), 14, 15, Fraction(33, 2)], ends, strict=True)]
    # Of the part its second edge alone, which is cut on the right.
    assert [*half] == [(2, -2), (3, -2), (Fraction(9, 2), Fraction(-1, 2))]


def test_boxes_are_rounded_outwards() -> None:
    assert round_outwards((1, 2), (7, 2)) == (0, 4)
    assert round_outwards((-1, 2), (-7, 2)) == (-1, -3)
    assert round_outwards((6, 2), (8, 2)) == (3, 4)
    part = make([(0, 0), (2, -2), (5, -4)])
    assert part.box == cross(part).box == cross(part, (1, 2), (9, 2)).box == (0, 5, -4)
    for run in (1, 2, 3):
        gentle = make([(0, 9), (2, 7), (2 + run, 8), (5 + run, 14)])
        by_lines = cross(gentle)._replace(slopes=[Fraction(s) / UNIT for s in gentle.slopes])
        assert gentle.box == by_lines.box == (0, 5 + run, 7)
    rising = make([(1, 7), (3, 8), (6, 19)])
    assert rising.box == cross(rising, (3, 2), (11, 2)).box == (1, 6, 7)
