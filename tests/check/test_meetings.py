"""Common points of boundaries, and witnesses: touching rings, edges along a ray, fractions."""

from collections import Counter
from fractions import Fraction
from itertools import product
from random import Random
from typing import Any

import pytest
from shape_families import untangled

from exactsweep import Point, Region
from exactsweep.check import Classification, classify
from exactsweep.check.cone import cross, find_common_direction, subtract
from exactsweep.check.meeting import list_meetings
from exactsweep.check.shape import LatticeShape, list_edges
from exactsweep.numbers.number import Vertex

AROUND = [(-9, -9), (30, -9), (30, 30), (-9, 30)]


@pytest.mark.parametrize(
    "notch",
    [
        [(20, 5), (2, 2), (10, 10), (20, 9), (20, 20)],
        [(20, 15), (10, 10), (2, 2), (10, 20)],
        [(20, 5), (3, 1), (1, 3), (20, 6), (20, 20)],
        [(20, 3), (2, 2), (3, 20)],
    ],
)
def test_a_witness_is_halfway_to_the_boundary(notch: list[tuple[int, int]]) -> None:
    """The diagonal from the least vertex meets a notch at (2, 2), which may continue along the
    diagonal."""
    part = [(0, 0), (20, 0), *notch, (0, 20)]
    found = classify(AROUND, part, (0, 0))
    assert found == Classification("OVERLAP", Point(Fraction(1), Fraction(1)))
    assert classify(part, AROUND, (0, 0)) == found


@pytest.mark.parametrize("turns", range(4))
def test_holes_that_touch_the_exterior_inside_an_edge(turns: int) -> None:
    """At the point of contact, the shape fills two angles of 45 degrees each."""

    def turn(points: Any) -> list[Any]:
        for _ in range(turns):
            points = [(-y, x) for x, y in points]
        return list(points)

    plate = [(-4, 0), (4, 0), (4, 8), (-4, 8)], [(0, 0), (2, 2), (-2, 2)]
    shape = Region(turn(plate[0]), [turn(plate[1])])
    third = Fraction(1, 3)
    for part, verdict in [
        ([(0, 0), (third, 1), (-third, 1)], "CONTACT"),
        ([(0, 0), (1, 1), (-1, 1)], "CONTACT"),
        ([(0, 0), (-1, -1), (1, -1)], "CONTACT"),
        ([(0, 0), (-1, 0), (0, -1), (1, 0)], "CONTACT"),
        ([(0, 0), (2, third), (2, 1)], "OVERLAP"),
        ([(0, 0), (-2, 1), (-2, third)], "OVERLAP"),
        ([(0, 0), (2, 2), (0, 1)], "CONTACT"),
        ([(0, 0), (3, 2), (0, 1)], "OVERLAP"),
    ]:
        for one, other in ((shape, turn(part)), (turn(part), shape)):
            assert classify(one, other, (0, 0)).verdict == verdict


def test_the_lowest_two_edges_may_cross() -> None:
    """A triangle that starts inside a square and crosses its bottom edge."""
    square, triangle = ((0, 0), (4, 0), (4, 4), (0, 4)), ((1, 1), (2, -1), (3, 1))
    for shapes in (((square,), (triangle,)), ((triangle,), (square,))):
        point, cones = next(list_meetings(shapes))
        assert point == (Fraction(3, 2), 0)
        assert find_common_direction(*cones) is not None


def _meet(shapes: tuple[LatticeShape, LatticeShape], scale: int) -> list[Any]:
    found = []
    for (x, y), cones in list_meetings(shapes):
        overlap = find_common_direction(*cones) is not None
        found.append((x * scale, y * scale, overlap))
        if overlap:
            break
    return found


def _cross(a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> bool:
    """Decide whether two segments cross at an interior point of both."""
    sides = [
        cross(subtract(q, p), subtract(r, p))
        for p, q, r in ((a, b, c), (a, b, d), (c, d, a), (c, d, b))
    ]
    return sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0


def test_meetings_do_not_depend_on_the_unit_of_length() -> None:
    """Crossing edges are never missed, either."""
    rng = Random(7)
    seen = Counter[bool]()
    for _ in range(150):
        by = rng.randint(-6, 6), rng.randint(-6, 6)
        rings = [untangled(rng, rng.randint(3, 7)).vertices for _ in "dg"]
        d, g = (
            tuple((int(x) + dx, int(y) + dy) for x, y in ring)
            for ring, (dx, dy) in zip(rings, ((0, 0), by), strict=True)
        )
        small, other = (tuple((Fraction(x, 1000), Fraction(y, 1000)) for x, y in r) for r in (d, g))
        found = _meet(((d,), (g,)), 1)
        assert _meet(((small,), (other,)), 1000) == found
        overlaps = any(overlap for _, _, overlap in found)
        if any(_cross(*e, *f) for e, f in product(list_edges([d]), list_edges([g]))):
            assert overlaps
        seen[overlaps] += 1
    assert min(seen.values()) > 20
