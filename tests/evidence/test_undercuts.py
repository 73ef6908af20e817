"""Undercuts: the regions between D and the inner loop, and the positions that close them."""

import random
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any

import families
import pytest
import strategies as own
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Point, Polygon, sweep
from exactsweep.check import classify, point_in_polygon
from exactsweep.evidence.undercut import Tracer, Undercut, find_closing_positions
from exactsweep.geometry.outline import Outline
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Vertex

Pair = tuple[Polygon, Polygon]
Edge = tuple[Point, Point]

often = examples(100)
walled_pairs = st.integers(0, 10**9).map(
    lambda seed: families.random_pair(random.Random(seed), ["same", "mould", "walls"])
)
any_pair = (
    own.pairs("CM")
    | own.pairs("MM")
    | walled_pairs.map(lambda pair: (Polygon(pair.generatrix), Polygon(pair.directrix)))
)


def edges(polygon: Polygon) -> list[Edge]:
    v = polygon.vertices
    return list(zip(v, (*v[1:], v[0]), strict=True))


def middle(p: Point, q: Point) -> Point:
    return Point((p.x + q.x) / 2, (p.y + q.y) / 2)


def along(edge: Edge, p: Point, q: Point) -> bool:
    """Decide whether the segment from p to q lies on a directed edge, in the same direction."""
    (ax, ay), (bx, by) = edge
    if not all(min(edge) <= v <= max(edge) for v in (p, q)):
        return False
    turns = [(bx - ax) * (v.y - ay) - (by - ay) * (v.x - ax) for v in (p, q)]
    return turns == [0, 0] and (bx - ax) * (q.x - p.x) + (by - ay) * (q.y - p.y) > 0


@given(any_pair)
@often
def test_directrix_and_undercuts_make_up_the_inner_loop(pair: Pair) -> None:
    s = sweep(*pair)
    regions = [undercut.polygon for undercut in s.undercuts]
    assert sum(region.area for region in regions) + s.directrix.area == s.inner.area
    for region in regions:
        assert classify(s.directrix, region, (0, 0)).verdict == "CONTACT"
        assert all(point_in_polygon(v, s.inner) >= 0 for v in region.vertices)
    for one, other in combinations(regions, 2):
        assert classify(one, other, (0, 0)).verdict != "OVERLAP"


@given(any_pair)
@often
def test_bottom_chain_is_a_piece_of_the_inner_loop(pair: Pair) -> None:
    """It is also a piece of the region's boundary, with the region on its left."""
    s = sweep(*pair)
    for undercut in s.undercuts:
        assert undercut.extremes == (undercut.bottom[0], undercut.bottom[-1])
        for p, q in pairwise(undercut.bottom):
            assert any(along(edge, p, q) for edge in edges(s.inner))
            assert any(along(edge, p, q) for edge in edges(undercut.polygon))
            assert point_in_polygon(middle(p, q), s.directrix) == -1


def covers(generatrix: Polygon, position: Point, undercut: Undercut) -> bool:
    """Decide whether the bottom chain lies on the boundary of G at a position, edge in edge."""
    boundary = edges(generatrix.translated(position))
    return all(
        # The region is on the left of the chain, G on its right.
        any(along(edge, q, p) for edge in boundary)
        for p, q in pairwise(undercut.bottom)
    )


@given(any_pair)
@often
def test_generatrix_closes_undercuts_at_their_positions(pair: Pair) -> None:
    s = sweep(*pair)
    for undercut in s.undercuts:
        assert undercut.positions
        for position in undercut.positions:
            assert point_in_polygon(position, s.trajectory) == 0
            assert classify(s.directrix, s.generatrix, position).verdict == "CONTACT"
        if len(undercut.positions) == 1:
            assert undercut.intersection == "point"
        if len(undercut.positions) == 1 or undercut.intersection == "segment":
            assert all(covers(s.generatrix.exterior, p, undercut) for p in undercut.positions)


@given(own.pairs("CM"))
@often
def test_convex_generatrix_closes_an_undercut_at_one_position(pair: Pair) -> None:
    """Figure 7: the intersection is a point, or a segment if the bottom chain is straight."""
    s = sweep(*pair)
    for undercut in s.undercuts:
        if undercut.intersection == "point":
            assert len(undercut.positions) == 1
        else:
            assert len(undercut.positions) == len(undercut.bottom) == 2


@given(any_pair)
@often
def test_one_position_is_returned_if_it_suffices(pair: Pair) -> None:
    s = sweep(*pair)
    for undercut in s.undercuts:
        closing = [t for t in s.trajectory.vertices if covers(s.generatrix.exterior, t, undercut)]
        if len(undercut.bottom) > 2 and closing:
            assert len(undercut.positions) == 1
            assert {*undercut.positions} <= {*closing}


@given(any_pair)
@often
def test_segments_are_maximal(pair: Pair) -> None:
    s = sweep(*pair)
    for undercut in s.undercuts:
        if undercut.intersection == "segment":
            p, q = undercut.positions
            assert p != q
            for a, b in (p, q), (q, p):
                share = Fraction(1, 10**20)
                beyond = Point(b.x + share * (b.x - a.x), b.y + share * (b.y - a.y))
                on_path = point_in_polygon(beyond, s.trajectory) == 0
                assert not (on_path and covers(s.generatrix.exterior, beyond, undercut))
                assert covers(s.generatrix.exterior, middle(a, b), undercut)


@given(own.turned_pairs("MM"), st.booleans())
@examples(50)
def test_undercuts_do_not_depend_on_the_frame(
    pair: tuple[Polygon, Polygon, Any], exchanged: bool
) -> None:
    generatrix, directrix, direction = pair
    if exchanged:
        generatrix, directrix = directrix, generatrix
    s = sweep(generatrix, directrix, direction=direction)
    regions = {undercut.polygon for undercut in s.undercuts}
    assert len(regions) == len(s.undercuts)
    assert regions == {undercut.polygon for undercut in sweep(generatrix, directrix).undercuts}


def test_touching_pockets_are_separate_undercuts() -> None:
    r"""Two adjacent notches share the tip between them.

    ::

        # # # # # # # # #
        # + + # + # + + #
        =================
    """
    ridge = [(0, 0), (1, 0), (2, 2), (3, 0), (4, 2), (5, 0), (6, 0), (6, 3), (0, 3)]
    s = sweep([(0, 0), (5, 0), (5, 1), (0, 1)], ridge)
    assert [undercut.polygon for undercut in s.undercuts] == [
        Polygon([(1, 0), (3, 0), (2, 2)]),
        Polygon([(3, 0), (5, 0), (4, 2)]),
    ]
    # The bar lies on both rims of one notch along a segment of length 3, then of the other.
    assert [undercut.positions for undercut in s.undercuts] == [
        own.points((-2, -1), (1, -1)),
        own.points((0, -1), (3, -1)),
    ]
    assert [undercut.intersection for undercut in s.undercuts] == ["segment", "segment"]


def test_wall_of_the_generatrix_belongs_to_the_bottom_chain() -> None:
    """An earlier version mistook the upper end of G's wall, which is not on D, for the contact.

    D around itself: the overhang at G's right end keeps it out of the corner before D's tower.

    ::

                    #
                  + #       G at (-1, 3): its floor on D, its overhang at the tower
        # # # # # # #
        # # # # # #
    """
    tower = [(0, 0), (6, 0), (6, 1), (7, 1), (7, 5), (6, 5), (6, 3), (0, 3)]
    (undercut,) = sweep(tower, tower).undercuts
    assert undercut.polygon == Polygon([(5, 3), (6, 3), (6, 4), (5, 4)])
    assert undercut.bottom == own.points((6, 4), (5, 4), (5, 3))
    assert undercut.positions == own.points((-1, 3))


def test_one_corner_of_the_generatrix_closes_a_bent_pocket() -> None:
    """The bottom chain bends at (9, 9/5); the corner (0, -4) of G has the same two edges.

    A former version started from the end of the chain and returned two positions instead of one.
    """
    bent = [(0, -4), (5, -1), (5, -9), (10, -6), (8, 2), (0, 0)]
    (undercut,) = sweep(bent, [(6, -6), (11, 3), ("35/4", "5/4"), (9, 5)]).undercuts
    assert undercut.bottom == own.points((11, 3), (9, "9/5"), (9, 5))
    assert undercut.positions == own.points((9, "29/5"))


def test_numbers_without_a_useful_lattice_change_no_evidence() -> None:
    factor = 1 + Fraction(1, 3**5200)
    for seed in (2, 5):
        pair = families.random_pair(random.Random(seed), ["same", "mould", "walls"])
        g, d = Polygon(pair.generatrix), Polygon(pair.directrix)
        near = sweep(Polygon(g.vertices), Polygon(d.vertices))
        far = sweep(*(Polygon([(factor * x, factor * y) for x, y in p.vertices]) for p in (g, d)))
        assert far.generatrix.lattice()[0] == 1
        positions = [
            [Point(factor * x, factor * y) for x, y in u.positions] for u in near.undercuts
        ]
        assert [[*u.positions] for u in far.undercuts] == positions
        assert far.contacts == near.contacts, seed


def close(chain: list[Vertex], path: Outline, g: Outline) -> Any:
    """Find the closure of a chain on the inner loop of a trajectory."""
    return find_closing_positions(chain, Tracer(path, g))


def test_a_chain_may_be_covered_from_the_middle_of_an_edge_but_not_beyond_g() -> None:
    g = Outline([[(0, 5), (1, 2), (2, 0), (4, 0), (5, 2), (6, 5)]])
    # A notch from above, down to (0, 0).
    path = Outline([[(-9, -9), (9, -9), (9, 9), (1, 9), (0, 0), (-1, 9), (-9, 9)]])
    chain: list[Vertex] = [(1, 2), (2, 0), (4, 0), (5, 2), (6, 5)]
    assert close(chain, path, g) == close(chain[::-1], path, g) == ("point", [(0, 0)])
    with pytest.raises(ExactSweepError):
        close([*chain[:-1], (7, 8)], path, g)


def test_a_straight_chain_is_covered_along_a_piece_of_the_trajectory() -> None:
    """The top edge of a bar covers it: 5 long, at distance 3 from the origin of the bar."""
    bar = Outline([[(3, 0), (8, 0), (8, 1), (3, 1)]])
    path = Outline([[(0, -1), (4, -1), (5, 7), (6, 7), (7, -1), (20, -1), (20, 9), (0, 9)]])
    for low, high, expected in [
        (5, 7, (0, 2)),
        (6, 7, (0, 3)),
        (9, 10, (2, 4)),
        (10, 12, (4,)),
        (11, 13, (7, 8)),
        (11, 12, (7, 8)),  # and at (4, -1)
        (12, 17, (9,)),
        (7, 12, (4,)),
    ]:
        _, found = close([(low, 0), (high, 0)], path, bar)
        assert found == [(x, -1) for x in expected]


@pytest.mark.parametrize(
    "way",
    [(1, 0), (0, 1), (-1, 0), (0, -1)],
    ids=["upright", "lying", "turned", "turned and lying"],
)
def test_an_edge_of_several_positions_is_traced_at_vertices_of_the_trajectory(
    way: tuple[int, int],
) -> None:
    """An edge of G of length 2 traces an edge of length 4 that begins and ends at its midpoint."""

    def turn(*points: tuple[int, int]) -> list[Vertex]:
        c, s = way
        return [(c * x - s * y, s * x + c * y) for x, y in points]

    square = Outline([turn((0, 0), (1, 0), (1, 2), (0, 2))])
    zigzag = Outline([turn((8, 2), (3, 4), (4, 3), (3, 2), (4, 1), (3, 0))])
    start, end = turn((3, 5), (3, 1))
    intersection, found = close([start, end], zigzag, square)
    assert (intersection, {*found}) == ("point", {zigzag.vertices[k] for k in (1, 3, 5)})
