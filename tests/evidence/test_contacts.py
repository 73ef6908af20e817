"""Contacts, compared with a test of all pairs of features."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise, product
from typing import Any

import pytest
import strategies as own
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Point, Polygon, PolygonError, Region, sweep
from exactsweep.evidence.contact import (
    find_contacts,
)
from exactsweep.geometry.outline import Outline
from exactsweep.numbers.number import Vertex

Pair = tuple[Polygon, Polygon]
Found = set[tuple[str, int, int]]
Edge = tuple[Point, Point]

usually = examples(40)


def numbered(polygon: Polygon) -> Polygon:
    """Return the polygon with its features numbered in canonical order."""
    return Polygon(iter(polygon.vertices))


any_pair = (own.pairs("CC") | own.pairs("CM") | own.pairs("MM")).map(
    lambda pair: (numbered(pair[0]), numbered(pair[1]))
)

UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]


def edges(polygon: Polygon) -> list[Edge]:
    v = polygon.vertices
    return list(zip(v, (*v[1:], v[0]), strict=True))


def cross(a: Vertex, b: Vertex, c: Vertex) -> Fraction | int:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def inside(edge: tuple[Vertex, Vertex], p: Vertex) -> bool:
    return min(edge) < p < max(edge) and cross(*edge, p) == 0


def overlap(e: tuple[Vertex, Vertex], f: tuple[Vertex, Vertex]) -> bool:
    """Decide whether two edges have a segment of positive length in common."""
    if max(min(e), min(f)) >= min(max(e), max(f)):
        return False
    return cross(*e, f[0]) == cross(*e, f[1]) == 0


def touching(generatrix: Polygon, directrix: Polygon, t: Point) -> Found:
    """List all contacts of G + t with D, with features numbered in canonical order."""
    moved = [(x + t.x, y + t.y) for x, y in generatrix.vertices]
    return meetings(moved, directrix.vertices)


def meetings(g: Sequence[Vertex], d: Sequence[Vertex]) -> Found:
    """List all contacts of two rings."""
    sides, others = (list(enumerate(zip(r, (*r[1:], r[0]), strict=True))) for r in (g, d))
    found: Found = set()
    found |= {("VV", i, j) for (i, w), (j, v) in product(enumerate(g), enumerate(d)) if w == v}
    found |= {("EV", i, j) for (i, e), (j, v) in product(sides, enumerate(d)) if inside(e, v)}
    found |= {("VE", i, j) for (i, w), (j, f) in product(enumerate(g), others) if inside(f, w)}
    found |= {("EE", i, j) for (i, e), (j, f) in product(sides, others) if overlap(e, f)}
    return found


def lasting(generatrix: Polygon, directrix: Polygon, p: Point, q: Point) -> Found:
    """Find the contacts that persist along a segment of a trajectory edge.

    Contacts change only where a vertex meets a vertex, so one point between each two suffices.
    """
    n, m = len(generatrix), len(directrix)
    differences = {
        Point(v.x - w.x, v.y - w.y) for v, w in product(directrix.vertices, generatrix.vertices)
    }
    stops = sorted({p, q} | {t for t in differences if inside((p, q), t)})
    whole: Found = set()
    for a, b in pairwise(stops):
        found = touching(generatrix, directrix, Point((a.x + b.x) / 2, (a.y + b.y) / 2))
        parts: Found = set()
        for event, i, j in found:
            if event == "EE":
                parts |= {("EV", i, j), ("EV", i, (j + 1) % m)}
                parts |= {("VE", i, j), ("VE", (i + 1) % n, j)}
        whole |= found - parts
    return whole


@given(any_pair)
@examples(24)
def test_all_lasting_contacts_of_each_edge_are_found(pair: Pair) -> None:
    generatrix, directrix = pair
    s = sweep(generatrix, directrix)
    assert len(s.contacts) == len(s.trajectory)
    for (p, q), found in zip(edges(s.trajectory), s.contacts, strict=True):
        assert found
        assert list(found) == sorted(lasting(generatrix, directrix, p, q))


@given(any_pair)
@usually
def test_all_contacts_at_each_vertex_are_found(pair: Pair) -> None:
    generatrix, directrix = pair
    s = sweep(generatrix, directrix)
    assert len(s.vertex_contacts) == len(s.trajectory)
    for t, found in zip(s.trajectory.vertices, s.vertex_contacts, strict=True):
        assert found
        assert list(found) == sorted(touching(generatrix, directrix, t))


@given(any_pair, own.tiny(1, 6))
@usually
def test_all_contacts_at_any_position_are_found(pair: Pair, part: int) -> None:
    generatrix, directrix = pair
    s = sweep(generatrix, directrix)
    p, q = edges(s.trajectory)[part % len(s.trajectory)]
    t = Point(p.x + (q.x - p.x) * part / 7, p.y + (q.y - p.y) * part / 7)
    assert list(s.contacts_at(t)) == sorted(touching(generatrix, directrix, t))
    for fit in s.exact_fits:
        assert list(s.contacts_at(fit[1])) == sorted(touching(generatrix, directrix, fit[1]))
    box = directrix.bounding_box[1]
    beyond = Point(box.x + generatrix.bounding_box[1].x + generatrix.area + 10**40, box.y)
    assert s.contacts_at(beyond) == ()


@given(any_pair, st.data())
@usually
def test_features_are_numbered_as_in_the_input(pair: Pair, data: st.DataObject) -> None:
    """Reversed, rotated, closed, with repeated and with collinear vertices."""
    spelled = [data.draw(own.spellings(polygon)) for polygon in pair]
    s, plain = sweep(*spelled), sweep(*pair)
    assert s.trajectory == plain.trajectory

    def canonical(kind: str, polygon: Polygon, given_: Any, index: int) -> int:
        """Return the canonical number of the vertex or edge that has an index in the input."""
        a, b = Point(*given_[index]), Point(*given_[(index + 1) % len(given_)])
        if kind == "V":
            return polygon.vertices.index(a)
        (k,) = (k for k, edge in enumerate(edges(polygon)) if overlap(edge, (a, b)))
        return k

    positions = (*s.contacts, *s.vertex_contacts)
    for found, expected in zip(positions, (*plain.contacts, *plain.vertex_contacts), strict=True):
        renumbered = [
            (
                event,
                canonical(event[0], pair[0], spelled[0], i),
                canonical(event[1], pair[1], spelled[1], j),
            )
            for event, i, j in found
        ]
        assert sorted(renumbered) == list(expected)


@given(own.pairs("CC") | own.pairs("CM"))
@examples(150)
def test_lasting_contacts_of_a_convex_generatrix_involve_one_edge_of_it(pair: Pair) -> None:
    """Lemma A.1, for contacts that last, vertical edges of the frame included.

    Either one vertex of G slides along one edge of D (VE), or all contacts are of one edge of G
    (EV and EE). For a convex G has one vertex or one edge furthest out to either side of
    a line; a vertex that slid along two edges of D, in one line, would dip in between them.
    """
    generatrix, directrix = pair
    for found in sweep(generatrix, directrix).contacts:
        events = {event for event, _, _ in found}
        if "VE" in events:
            assert len(found) == 1
        else:
            assert events <= {"EV", "EE"}
            assert len({i for _, i, _ in found}) == 1


def test_positions_must_be_points() -> None:
    with pytest.raises(PolygonError, match=r"position is .*, not a pair of numbers"):
        sweep(UNIT, UNIT).contacts_at([1])


BLOCK = [(0, 0), (2, 0), (2, 2), (0, 2)]
BRACKET = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (3, 2), (3, 3), (0, 3)]
KITE = [(0, 0), (1, -2), (2, 0), (1, 1)]
BOOT = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 3), (0, 2)]


@pytest.mark.parametrize(
    ("g", "d"), [(BLOCK, BRACKET), (KITE, BOOT), (BOOT, KITE), (BOOT, BLOCK), (KITE, KITE)]
)
def test_contacts_at_all_positions_of_a_grid(g: list[Vertex], d: list[Vertex]) -> None:
    twice = [(2 * x, 2 * y) for x, y in d]
    for x, y in product(range(-5, 9), range(-7, 11)):
        moved = [(2 * u + x, 2 * v + y) for u, v in g]
        expected = sorted(meetings(moved, twice))
        t = Fraction(x, 2), Fraction(y, 2)
        assert find_contacts(Outline([g]), Outline([d]), t) == expected


def test_contacts_along_loops_of_untyped_positions() -> None:
    s = sweep(UNIT, [(0, 0), (3, 0), (0, 3)])
    # Along the lower side and back; without length; with a stop; without a position.
    loops: list[Any] = [[(-1, -1), ("3", "-1")], [(3, 0)], [(-1, -1), (-1, -1), (3, -1)], []]
    below = (("EE", 2, 0),)
    assert [list(found) for found in s.contacts_along(loops)] == [
        [below, below],
        [()],
        [(), below, below],
        [],
    ]
    with pytest.raises(PolygonError, match=r"^position is .*, not a pair of numbers$"):
        s.contacts_along([[1, 2]])  # type: ignore[list-item]


def test_all_rings_that_touch_at_a_point_have_contacts_there() -> None:
    """A former version reported only the corner of the hole."""
    d = Region([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)], [[(1, 1), (2, 1), (2, 2), (1, 2)]])
    found = [f"{event}({i},{j})" for event, i, j in sweep(UNIT, d).contacts_at((2, 2))]
    assert found == ["EE(0,2)", "EE(3,3)", "VE(1,2)", "VE(3,3)", "VV(0,3)", "VV(0,8)"]
