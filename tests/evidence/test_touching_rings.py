"""Contacts of Regions whose rings touch, at a common vertex or with a vertex inside an edge."""

from fractions import Fraction

import pytest
from contacts import without_parts
from hypothesis import example, given, settings
from hypothesis import strategies as st
from polyominoes import Cells, polyominoes, region

from exactsweep import Point, Polygon, Region, Sweep, sweep
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.steps import explain
from exactsweep.geometry.region import AnyPolygon

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
# The hole shares the vertex (2, 2) with the exterior.
PINCHED = Region(
    [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)], [[(1, 1), (2, 1), (2, 2), (1, 2)]]
)
# The hole has a vertex inside the right edge.
AT_THE_RIM = Region([(0, 0), (4, 0), (4, 4), (0, 4)], [[(1, 1), (4, 2), (1, 3)]])


def point(x: int, y: int) -> Point:
    return Point(Fraction(x), Fraction(y))


def test_all_features_at_a_shared_vertex_touch() -> None:
    s = sweep(SQUARE, PINCHED)
    # From the outside: vertex 0 of G, its bottom and its left side. Vertex 8 is the hole's.
    expected = [("EE", 0, 2), ("EE", 3, 3), ("VE", 1, 2), ("VE", 3, 3), ("VV", 0, 3), ("VV", 0, 8)]
    assert list(s.contacts_at((2, 2))) == expected
    (at,) = [k for k, vertex in enumerate(s.trajectory) if vertex == point(2, 2)]
    assert list(s.vertex_contacts[at]) == expected
    # The paths along the top and up the side meet here: G stops at the side, not at the hole.
    (step,) = [step for step in explain(s) if step.end == s.trajectory[at]]
    assert step.ending == "stop"
    assert ("VV", 0, 8) not in step.reasons
    assert ("VV", 0, 3) in step.reasons


def test_a_vertex_inside_an_edge_of_another_ring_touches_where_the_edge_does() -> None:
    s = sweep(SQUARE, AT_THE_RIM)
    (right,) = [
        found
        for vertex, found in zip(s.trajectory, s.contacts, strict=True)
        if vertex == point(4, -1)
    ]
    assert right == (Contact("EE", 3, 1), Contact("EV", 3, 5))
    assert Contact("EV", 3, 5) in s.contacts_at((4, "3/2"))
    assert Contact("EV", 3, 5) not in s.contacts_at((4, "5/2"))


def lasting(s: Sweep, p: Point, q: Point) -> set[Contact]:
    """List the contacts at sample points from p to q, one between each two possible changes."""
    count = 4 * int(max(abs(q.x - p.x), abs(q.y - p.y)))
    found: set[Contact] = set()
    for k in range(count):
        share = (k + Fraction(1, 3)) / count
        found.update(s.contacts_at((p.x + share * (q.x - p.x), p.y + share * (q.y - p.y))))
    return without_parts(s, found)


@settings(max_examples=20)
@given(polyominoes(12, 5), polyominoes(6, 4), st.booleans())
@example({(0, 0), (1, 0), (2, 0), (0, 1), (2, 1), (0, 2), (1, 2)}, {(0, 0)}, True)
def test_contacts_along_edges_match_those_at_their_points(d: Cells, g: Cells, turns: bool) -> None:
    shapes: list[AnyPolygon] = [region(g), region(d)]
    if turns:
        shapes.reverse()
    check(sweep(*shapes))


@pytest.mark.parametrize("shape", [PINCHED, AT_THE_RIM])
def test_contacts_along_edges_of_touching_rings_match_those_at_their_points(shape: Region) -> None:
    for other in (Polygon(SQUARE), shape, Polygon([(0, 0), (2, 1), (0, 2)])):
        check(sweep(other, shape))
        check(sweep(shape, other))


def check(s: Sweep) -> None:
    corners = s.trajectory.vertices
    for p, q, found in zip(corners, (*corners[1:], corners[0]), s.contacts, strict=True):
        assert set(found) == lasting(s, p, q)
    assert len(explain(s)) == len(corners)
