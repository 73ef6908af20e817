"""Laws of the whole sweep, and the sweep compared with its definition."""

from fractions import Fraction
from itertools import product
from typing import Any

import pytest
import strategies as own
from definition import find_failure
from hypothesis import given
from hypothesis import strategies as st
from refusals import list_refusals, require_refused
from small_pairs import SmallPair
from tiers import examples

from exactsweep import (
    Point,
    Polygon,
    Region,
    Sweep,
    sweep,
)
from exactsweep.check import classify, point_in_polygon
from exactsweep.geometry.direction import find_monotone_directions
from exactsweep.paper.definition import reference_loops
from exactsweep.paper.kernel import find_convex_parts
from exactsweep.procedures.chain import inverse, split
from exactsweep.procedures.exact_fit import list_edges

Pair = tuple[Polygon, Polygon]
Loops = tuple[Polygon, Polygon, Polygon]

often = examples(100)
seldom = examples(40)
each_kind = pytest.mark.parametrize("kind", ["CC", "CM", "MM"])
any_pair = own.pairs("CC") | own.pairs("CM") | own.pairs("MM")

UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]


def loops(s: Sweep) -> Loops:
    return s.trajectory, s.inner, s.outer


def edges(polygon: Polygon) -> list[tuple[Point, Point]]:
    v = polygon.vertices
    return list(zip(v, (*v[1:], v[0]), strict=True))


def test_vertices_of_one_ring_are_read_once(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[type] = []
    for kind in (Polygon, Region):

        def note(self: Any, *given: Any, make: Any = kind.__init__) -> None:
            made.append(type(self))
            make(self, *given)

        monkeypatch.setattr(kind, "__init__", note)
    assert sweep(UNIT, UNIT).kind == "CC"
    assert made == [Polygon, Polygon]


@each_kind
@given(st.data())
@examples(40)
def test_the_sweep_matches_the_definition(kind: own.Kind, data: st.DataObject) -> None:
    generatrix, directrix, direction = data.draw(own.turned_pairs(kind))
    pair = SmallPair([[*generatrix.vertices]], [[*directrix.vertices]])
    assert find_failure(pair, deep=direction[0] % 2 == 0) == ""


@pytest.mark.parametrize("name", ["trajectory", "inner", "outer"])
@pytest.mark.parametrize(
    ("generatrix", "directrix"),
    [
        # A part of the trajectory that begins where the partial outer chain ends, both at x = -2,
        # one of them written as the break -12/6.
        pytest.param(
            [(4, -4), (5, -3), (4, 1), (4, 0), (2, 0), (1, 1)],
            [(0, 0), (1, -1), (2, -1)],
            id="break not reduced, wall in the generatrix",
        ),
        pytest.param(
            [(3, -2), (4, -3), (5, -3), (5, 2), (4, 1), (0, 0)],
            [(4, 0), (3, 5), (3, 4), (1, 4), (0, 5)],
            id="break not reduced, straight directrix",
        ),
        pytest.param(
            [(4, -7), (5, -6), (12, -2), (6, 0), (2, -2)],
            [(14, 2), (18, 4), (24, 2), (24, 0), (28, 3), (0, 6)],
            id="break not reduced, wall in the directrix",
        ),
        # A part of the trajectory left of one on the outer boundary need not be swept; without
        # it, a later part seemed to lie below all parts on its right.
        pytest.param(
            [
                *[(4, -1), (15, -2), (18, 0), (35, -1), (24, 3)],
                *[(19, 3), (18, 2), (14, 3), (3, 1), (1, 3)],
            ],
            [(0, 0), (9, 0), (13, 1), (14, 0), (15, 5)],
            id="pruned neighbour, convex directrix except for one vertex",
        ),
        pytest.param(
            [
                *[(6, -1), (12, 1), (29, 0), (18, 5), (17, 6)],
                *[(15, 6), (5, 4), (3, 6), (2, 4), (0, 6)],
            ],
            [(1, 0), (5, -2), (6, 0), (7, -2), (17, -1), (0, 8)],
            id="pruned neighbour, zigzag directrix",
        ),
    ],
)
def test_pairs_that_once_failed(generatrix: Any, directrix: Any, name: str) -> None:
    expected = reference_loops(generatrix, directrix)
    found = getattr(sweep(generatrix, directrix), name)
    assert found.vertices == getattr(expected, name)


@given(any_pair, own.translations(), own.translations())
@often
def test_translation_commutes(pair: Pair, g: Any, d: Any) -> None:
    generatrix, directrix = pair
    s = sweep(generatrix, directrix)
    moved = sweep(generatrix.translated(g), directrix.translated(d))
    by = d[0] - g[0], d[1] - g[1]
    assert moved.trajectory == s.trajectory.translated(by)
    assert moved.inner == s.inner.translated(d)
    assert moved.outer == s.outer.translated(d)
    assert moved.area == s.area == s.outer.area - s.inner.area


@given(any_pair, own.matrices())
@often
def test_linear_maps_commute(pair: Pair, matrix: own.Matrix) -> None:
    generatrix, directrix = pair
    (_, b), (_, d) = matrix
    s = sweep(generatrix, directrix)
    image = sweep(own.mapped(generatrix, matrix), own.mapped(directrix, matrix), direction=(d, -b))
    assert loops(image) == tuple(own.mapped(loop, matrix) for loop in loops(s))


@given(any_pair)
@often
def test_exchanging_the_roles_inverts_the_trajectory(pair: Pair) -> None:
    generatrix, directrix = pair
    s, exchanged = sweep(generatrix, directrix), sweep(directrix, generatrix)
    assert exchanged.trajectory == s.trajectory.reflected()
    inverted = {tuple((-x, -y) for x, y in fit) for fit in s.exact_fits}
    assert {*exchanged.exact_fits} == inverted


@given(any_pair)
@often
def test_direction_does_not_matter(pair: Pair) -> None:
    generatrix, directrix = pair
    shared = find_monotone_directions(generatrix) & find_monotone_directions(directrix)
    s = sweep(generatrix, directrix)
    candidates = {u for arc in shared.arcs() for u in arc} | {shared.simplest()}
    candidates |= {u for u in product((0, 1, 2), (-2, -1, 1, 3)) if u in shared}
    for u in sorted(candidates)[:8]:
        other = sweep(generatrix, directrix, direction=u)
        assert loops(other) == loops(s)
        assert other.exact_fits == s.exact_fits
        assert other.contacts == s.contacts


@given(any_pair, own.translations())
@seldom
def test_the_reference_point_only_translates_the_positions(pair: Pair, point: Any) -> None:
    s, other = sweep(*pair), sweep(*pair, reference=point)
    dx, dy = point

    def moved(positions: Any) -> Any:
        return tuple(Point(x + dx, y + dy) for x, y in positions)

    assert other.trajectory.vertices == moved(s.trajectory.vertices)
    assert (other.inner, other.outer, other.area) == (s.inner, s.outer, s.area)
    assert other.exact_fits == tuple(map(moved, s.exact_fits))
    assert other.contacts == s.contacts
    assert other.vertex_contacts == s.vertex_contacts
    assert other.undercuts == tuple(
        undercut._replace(positions=moved(undercut.positions)) for undercut in s.undercuts
    )


@given(any_pair, st.data())
@often
def test_the_side_of_the_trajectory_determines_the_verdict(pair: Pair, data: st.DataObject) -> None:
    """Inside it is overlap, except on exact fits; on the loop contact; outside free."""
    generatrix, directrix = pair
    s = sweep(generatrix, directrix)
    p, q = data.draw(st.sampled_from(edges(s.trajectory)))
    share = data.draw(st.sampled_from([Fraction(0), Fraction(1, 2), Fraction(1, 3)]))
    reach = (abs(q.x - p.x) + abs(q.y - p.y)) / data.draw(st.sampled_from([1, 8, 10**20]))
    for dx, dy in (0, 0), (1, 0), (-1, 0), (0, 1), (0, -1), (1, -2), (-3, 1):
        x = p.x + share * (q.x - p.x) + dx * reach
        y = p.y + share * (q.y - p.y) + dy * reach
        verdict = classify(directrix, generatrix, (x, y)).verdict
        side = point_in_polygon((x, y), s.trajectory)
        fits = any(on_segment(Point(x, y), *fit) for fit in s.exact_fits)
        assert verdict == ("FREE" if side < 0 else "CONTACT" if side == 0 or fits else "OVERLAP")


def on_segment(point: Point, p: Point, q: Point) -> bool:
    turn = (q.x - p.x) * (point.y - p.y) - (q.y - p.y) * (point.x - p.x)
    return turn == 0 and min(p, q) <= point <= max(p, q)


def support(polygon: Polygon, x: Fraction, y: Fraction) -> Fraction:
    return max(x * v.x + y * v.y for v in polygon.vertices)


def mixed(one: Polygon, other: Polygon) -> Fraction:
    """Return twice the mixed area of two convex polygons, edge by edge (Minkowski)."""
    return sum(
        (support(other, q.y - p.y, p.x - q.x) for p, q in edges(one)),
        start=Fraction(0),
    )


@given(own.pairs("CC"))
@often
def test_areas_of_convex_sweeps_are_mixed_areas(pair: Pair) -> None:
    g, d = pair
    s = sweep(g, d)
    inverted = g.reflected()
    assert s.trajectory.area == d.area + g.area + mixed(d, inverted)
    assert s.inner == d
    outer = d.area + 2 * g.area + mixed(d, inverted) + mixed(d, g) + mixed(g, inverted)
    assert s.outer.area == outer


@given(own.pairs("CC"))
@often
def test_sizes_of_convex_sweeps(pair: Pair) -> None:
    """Corollary 3.3, with constants."""
    g, d = pair
    n, m = len(g), len(d)
    s = sweep(g, d)
    assert len(s.trajectory) <= m + n
    assert len(s.inner) == m
    assert len(s.outer) <= m + 2 * n


@given(own.pairs("CM"))
@often
@pytest.mark.long
def test_sizes_of_sweeps_with_a_convex_generatrix(pair: Pair) -> None:
    """Corollaries 4.3 and 4.4 for each half: k convex parts of D_b, meeting k - 1 times.

    A meeting cuts two edges, neither in two, and may leave a vertical edge; each part but the
    first brings G's top (and bottom) once more, and so does each undercut.
    """
    g, d = pair
    s = sweep(g, d, direction=(1, 0))

    def chains(polygon: Polygon) -> tuple[tuple[Any, Any], tuple[Any, Any]]:
        bottom, top = split(polygon.vertices)
        return (bottom, top), (inverse(top), inverse(bottom))

    for of_g, of_d, of_t, of_inner, of_outer in zip(
        *map(chains, (g, d, s.trajectory, s.inner, s.outer)), strict=True
    ):
        m, n, other = len(list_edges(of_d[0])), len(of_g[1]) - 1, len(of_g[0]) - 1
        k = len(find_convex_parts(of_d[0]))
        assert len(of_t[0]) - 1 <= m + k * n + k - 1
        assert len(of_outer[0]) - 1 <= m + k * (n + other) + k - 1
        assert len(of_inner[0]) - 1 <= len(of_d[0]) - 1 + (k - 1) * n


@given(any_pair, st.data())
@seldom
def test_spelling_of_the_input_does_not_matter(pair: Pair, data: st.DataObject) -> None:
    generatrix, directrix = pair
    s = sweep(data.draw(own.spellings(generatrix)), data.draw(own.spellings(directrix)))
    assert loops(s) == loops(sweep(generatrix, directrix))


@given(any_pair)
@seldom
def test_the_kind_is_the_smallest_class(pair: Pair) -> None:
    generatrix, directrix = pair
    kind = "MM" if not generatrix.is_convex else "CC" if directrix.is_convex else "CM"
    s = sweep(generatrix, directrix)
    assert s.kind == kind
    assert repr(s).startswith(f"<Sweep {kind} of {len(generatrix)} around {len(directrix)} vert")


def test_sweeps_and_loops_have_informative_reprs() -> None:
    s = sweep(UNIT, [(0, 0), (4, 0), (4, 3), (2, 1), (0, 3)])
    assert [loop.is_convex for loop in loops(s)] == [False, False, False]
    assert [loop.is_convex for loop in loops(sweep(UNIT, UNIT))] == [True, True, True]
    assert str(s).splitlines() == [
        "CM sweep, monotone in (1, 0), area 83/4",
        "trajectory, 7 vertices: (-1, -1) (4, -1) (4, 3) (3, 3) (3/2, 3/2) (0, 3) (-1, 3)",
        "inner, 6 vertices: (0, 0) (4, 0) (4, 3) (5/2, 3/2) (3/2, 3/2) (0, 3)",
        "outer, 7 vertices: (-1, -1) (5, -1) (5, 4) (3, 4) (2, 3) (1, 4) (-1, 4)",
    ]


# Sideways notches: no line across both arms meets them in one segment.


@pytest.mark.parametrize(("call", "said"), list_refusals(__file__))
def test_errors_name_the_fault(call: str, said: str) -> None:
    require_refused(call, said)
