"""The reference itself: known answers by hand, and every loop compared with `classify`."""

from fractions import Fraction
from typing import Any

import pytest
import strategies as own
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Point, Polygon
from exactsweep.check import classify, point_in_polygon
from exactsweep.paper.definition import reference_exact_fits, reference_loops

Pair = tuple[Polygon, Polygon]
Loop = list[tuple[Any, Any]]
half = Fraction(1, 2)
# The reference is slow by design.
patient = examples(50)

UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]
#   #.#   a slot exactly as wide as UNIT
#   #.#
#   ###
SLOT = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
WIDE_SLOT = [(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)]
VALLEY = [(0, 0), (4, 0), (4, 3), (2, 1), (0, 3)]
#   ##
#   ##
#   ####
STAIR = [(0, 0), (4, 0), (4, 1), (2, 1), (2, 3), (0, 3)]


@pytest.mark.parametrize(
    ("g", "d", "trajectory", "inner", "outer"),
    [
        pytest.param(
            UNIT,
            UNIT,
            [(-1, -1), (1, -1), (1, 1), (-1, 1)],
            UNIT,
            [(-1, -1), (2, -1), (2, 2), (-1, 2)],
            id="square about itself",
        ),
        pytest.param(
            [(0, 0), (1, 0), (0, 1)],
            [(0, 0), (2, 0), (2, 2), (0, 2)],
            [(-1, 0), (0, -1), (2, -1), (2, 2), (-1, 2)],
            [(0, 0), (2, 0), (2, 2), (0, 2)],
            # D plus the hexagon that is the triangle plus its inverse.
            [(-1, 0), (0, -1), (3, -1), (3, 2), (2, 3), (-1, 3)],
            id="triangle about a square",
        ),
        pytest.param(
            UNIT,
            VALLEY,
            # The square rests on two corners, halfway between the walls.
            [(-1, -1), (4, -1), (4, 3), (3, 3), (3 * half, 3 * half), (0, 3), (-1, 3)],
            [(0, 0), (4, 0), (4, 3), (5 * half, 3 * half), (3 * half, 3 * half), (0, 3)],
            # Its top follows the higher corner: a valley of one point, one unit up.
            [(-1, -1), (5, -1), (5, 4), (3, 4), (2, 3), (1, 4), (-1, 4)],
            id="CM, an undercut under a square",
        ),
        pytest.param(
            UNIT,
            SLOT,
            [(-1, -1), (3, -1), (3, 3), (-1, 3)],
            [(0, 0), (3, 0), (3, 3), (0, 3)],
            [(-1, -1), (4, -1), (4, 4), (-1, 4)],
            id="slot that fits exactly: the regular loops pass it by",
        ),
        pytest.param(
            UNIT,
            WIDE_SLOT,
            [(-1, -1), (4, -1), (4, 3), (2, 3), (2, 1), (1, 1), (1, 3), (-1, 3)],
            WIDE_SLOT,
            # The square covers all of the slot of width two.
            [(-1, -1), (5, -1), (5, 4), (-1, 4)],
            id="slot wider than G",
        ),
        pytest.param(
            UNIT,
            STAIR,
            [(-1, -1), (4, -1), (4, 1), (2, 1), (2, 3), (-1, 3)],
            STAIR,
            [(-1, -1), (5, -1), (5, 2), (3, 2), (3, 4), (-1, 4)],
            id="vertical edge inside D's top",
        ),
        pytest.param(
            #   .#   one step up on the left
            #   ##
            [(0, 0), (2, 0), (2, 2), (1, 2), (1, 1), (0, 1)],
            STAIR,
            # The notch of G passes under the right end of D: the step at x = 3.
            [(-2, -2), (3, -2), (3, -1), (4, -1), (4, 1), (2, 1), (2, 3), (-2, 3)],
            STAIR,
            [
                *[(-2, -2), (5, -2), (5, -1), (6, -1), (6, 3)],
                *[(4, 3), (4, 5), (-1, 5), (-1, 4), (-2, 4)],
            ],
            id="vertical edges inside chains of both",
        ),
        pytest.param(
            # Two prongs, at x = 0 and x = 2, straddle the valley |x - 2| of D. In each quarter of
            # the sweep one prong touches: T falls and climbs by one, three times.
            [(0, 0), (1, 1), (2, 0), (2, 2), (0, 2)],
            [(0, -1), (4, -1), (4, 2), (2, 0), (0, 2)],
            [(-2, -3), (4, -3), (4, 2), (3, 1), (2, 2), (1, 1), (0, 2), (-1, 1), (-2, 2)],
            # Under the tips of the prongs, the rest of the valley is a W with a tooth to (2, 2).
            [(0, -1), (4, -1), (4, 2), (3, 1), (2, 2), (1, 1), (0, 2)],
            [(-2, -3), (6, -3), (6, 4), (-2, 4)],
            id="MM, two prongs in a valley",
        ),
    ],
)
def test_known_loops(g: Loop, d: Loop, trajectory: Loop, inner: Loop, outer: Loop) -> None:
    found = reference_loops(g, d)
    assert found.trajectory == Polygon(trajectory).vertices
    assert found.inner == Polygon(inner).vertices
    assert found.outer == Polygon(outer).vertices


@pytest.mark.parametrize(
    ("d", "fits"),
    [
        pytest.param(SLOT, [((1, 3), (1, 1))], id="from above"),
        pytest.param([(x, -y) for x, y in SLOT], [((1, -4), (1, -2))], id="from below"),
        pytest.param(WIDE_SLOT, [], id="too wide"),
        pytest.param(STAIR, [], id="no slot"),
        pytest.param(
            [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 2), (0, 2)],
            [((1, 2), (1, 1))],
            id="unequal walls: the fit ends at the lower one",
        ),
        pytest.param(
            [(0, 0), (3, 0), (3, 3), (2, 3), (2, 2), (1, 1), (1, 3), (0, 3)],
            [((1, 3), (1, 2))],
            id="sloping floor",
        ),
        pytest.param(
            [(0, 0), (3, 0), (3, 3), (2, 3), (2, 2), (1, half), (1, half + 1), (0, 3)],
            [],
            id="floor as high as the lower wall lets G stand",
        ),
        pytest.param(
            #   #.#
            #   ###
            #   #.#
            [
                *[(0, 0), (1, 0), (1, 1), (2, 1), (2, 0), (3, 0)],
                *[(3, 3), (2, 3), (2, 2), (1, 2), (1, 3), (0, 3)],
            ],
            [((1, -1), (1, 0)), ((1, 3), (1, 2))],
            id="from both sides",
        ),
    ],
)
def test_known_fits_of_the_unit_square(d: Loop, fits: list[Any]) -> None:
    assert reference_exact_fits(UNIT, d) == tuple(fits)


def test_fork_in_two_slots_fits_with_both_prongs() -> None:
    """Prongs of depth one in slots of depth two; one prong alone reaches nothing more.

    #.#.#       ###
    #.#.#       #.#
    #####
    """
    fork = [(0, 0), (1, 0), (1, 1), (2, 1), (2, 0), (3, 0), (3, 2), (0, 2)]
    comb = [(0, 0), (5, 0), (5, 3), (4, 3), (4, 1), (3, 1), (3, 3), (2, 3), (2, 1), (1, 1)]
    comb += [(1, 3), (0, 3)]
    # With its left prong at x = -1 and its right one in the left slot, or the mirror image, the
    # fork's bridge rests on an outer wall.
    expected: tuple[Any, ...] = (((-1, 3), (-1, 2)), ((1, 3), (1, 2)), ((3, 3), (3, 2)))
    assert reference_exact_fits(fork, comb) == expected


def test_direction_is_respected() -> None:
    """A slot that opens to the right: only horizontal lines meet it in a single segment."""
    lying = [(y, x) for x, y in SLOT]
    with pytest.raises(ValueError, match="the directrix is not monotone in direction \\(1, 0\\)"):
        reference_loops(UNIT, lying)
    for evaluate in (reference_loops, reference_exact_fits):
        with pytest.raises(
            ValueError, match="the generatrix is not monotone in direction \\(1, 0\\)"
        ):
            evaluate(lying, UNIT)
    ((start, inner),) = reference_exact_fits(UNIT, lying, (0, -2))
    assert (start, inner) == (Point(Fraction(3), Fraction(1)), Point(Fraction(1), Fraction(1)))


def test_a_zero_direction_is_rejected() -> None:
    with pytest.raises(ValueError, match="must not be"):
        reference_loops(UNIT, UNIT, (0, 0))


def all_pairs() -> st.SearchStrategy[Pair]:
    return own.pairs("CC") | own.pairs("CM") | own.pairs("MM")


def on_segment(p: tuple[Fraction, Fraction], a: Point, b: Point) -> bool:
    cross = (b.x - a.x) * (p[1] - a.y) - (b.y - a.y) * (p[0] - a.x)
    return cross == 0 and min(a, b) <= p <= max(a, b)


def turned(polygon: Polygon, a: int, b: int) -> Polygon:
    return Polygon([(a * x - b * y, b * x + a * y) for x, y in polygon.vertices])


@st.composite
def translations_near(draw: st.DrawFn, g: Polygon, d: Polygon) -> tuple[Fraction, Fraction]:
    """Positions of vertices on vertices, midpoints of two such positions, and positions nearby."""
    corner, feature = st.sampled_from(d.vertices), st.sampled_from(g.vertices)
    (px, py), (qx, qy) = draw(corner), draw(corner)
    (rx, ry), (sx, sy) = draw(feature), draw(feature)
    off = st.sampled_from([Fraction(0)] * 3 + [Fraction(1, 7), -Fraction(1, 10**9)])
    return (px + qx - rx - sx) / 2 + draw(off), (py + qy - ry - sy) / 2 + draw(off)


@patient
@given(all_pairs(), st.data())
def test_trajectory_and_fits_agree_with_classify(pair: Pair, data: st.DataObject) -> None:
    g, d = pair
    t = data.draw(translations_near(g, d))
    trajectory = reference_loops(g, d).trajectory
    fits = reference_exact_fits(g, d)
    in_fit = any(on_segment(t, *fit) for fit in fits)
    expected = {-1: "FREE", 0: "CONTACT", 1: "CONTACT" if in_fit else "OVERLAP"}
    assert classify(d, g, t).verdict == expected[point_in_polygon(t, trajectory)]
    for (x, start), (_, inner) in fits:
        beyond = inner + (inner - start) / 1000
        middle = (start + inner) / 2
        little = abs(inner - start) / 1000
        assert point_in_polygon((x, start), trajectory) == 0
        assert classify(d, g, (x, inner)).verdict == "CONTACT"
        assert classify(d, g, (x, middle)).verdict == "CONTACT"
        for aside in ((x, beyond), (x - little, middle), (x + little, middle)):
            assert classify(d, g, aside).verdict == "OVERLAP"


@examples(24)
@given(own.rectilinear_rings(), own.rectilinear_rings())
def test_fits_of_rectilinear_pairs_are_all_the_contacts_inside_the_trajectory(
    g: own.Ring, d: own.Ring
) -> None:
    """The ends of a fit are grid points, so its midpoint is on the half grid."""
    trajectory = Polygon(reference_loops(g, d).trajectory)
    low, high = trajectory.bounding_box
    found = {
        (x, y + half)
        for x in map(Fraction, range(int(low.x), int(high.x) + 1))
        for y in map(Fraction, range(int(low.y), int(high.y)))
        if point_in_polygon((x, y + half), trajectory) > 0
        and classify(d, g, (x, y + half)).verdict == "CONTACT"
    }
    expected = {
        (x, y + half)
        for (x, a), (_, b) in reference_exact_fits(g, d)
        for y in map(Fraction, range(int(min(a, b)), int(max(a, b))))
    }
    assert found == expected


@patient
@given(all_pairs(), st.data())
def test_the_outer_loop_encloses_all_covered_points(pair: Pair, data: st.DataObject) -> None:
    g, d = pair
    loops = reference_loops(g, d)
    p = data.draw(translations_near(Polygon(loops.trajectory), Polygon(loops.outer)))
    # p is in P + G where -G + p meets P.
    expected = {-1: "FREE", 0: "CONTACT", 1: "OVERLAP"}
    verdict = classify(loops.trajectory, g.reflected(), p).verdict
    assert verdict == expected[point_in_polygon(p, loops.outer)]


@patient
@given(all_pairs(), st.data())
def test_inner_loop_bounds_uncovered_points(pair: Pair, data: st.DataObject) -> None:
    g, d = pair
    loops = reference_loops(g, d)
    low, high = Polygon(loops.outer).bounding_box
    steps = st.integers(1, 96).map(lambda k: Fraction(k, 97))
    # An abscissa that avoids all vertices and so any dropped whisker of a loop.
    p = low.x + data.draw(steps) * (high.x - low.x), low.y + data.draw(steps) * (high.y - low.y)
    on_edge = data.draw(st.sampled_from(list(zip(loops.inner, loops.inner[1:], strict=False))))
    a, b = on_edge
    q = a.x + data.draw(steps) * (b.x - a.x), a.y + Fraction(0)
    if a.x != b.x:
        q = q[0], a.y + (b.y - a.y) * (q[0] - a.x) / (b.x - a.x)
        assert not covered(loops.trajectory, g, q)
    assert covered(loops.trajectory, g, p) == (point_in_polygon(p, loops.inner) < 0)


def covered(trajectory: tuple[Point, ...], g: Polygon, p: tuple[Fraction, Fraction]) -> bool:
    """Decide whether G's interior reaches p from a free position: -G + p overlaps P's outside.

    Two polygons represent the relevant part of the outside, below and above P; horizontal lines
    from its leftmost and rightmost vertices separate them.
    """
    v = trajectory
    right = max(range(len(v)), key=lambda k: v[k])
    low, high = Polygon(v).bounding_box
    reach = g.bounding_box[1].x - g.bounding_box[0].x
    rise = g.bounding_box[1].y - g.bounding_box[0].y
    far = 2 * (high.x - low.x + reach + high.y - low.y + rise)
    (west, south), (east, north) = (low.x - far, low.y - far), (high.x + far, high.y + far)
    first, last = v[0], v[right]
    below = [(west, south), (east, south), (east, last.y), *v[right::-1], (west, first.y)]
    above = [(west, first.y), first, *v[: right - 1 : -1], (east, last.y)]
    above += [(east, north), (west, north)]
    return any(
        classify(outside, g.reflected(), p).verdict == "OVERLAP" for outside in (below, above)
    )


@patient
@given(all_pairs())
def test_directrix_in_inner_loop_in_outer_loop(pair: Pair) -> None:
    g, d = pair
    _, inner, outer = reference_loops(g, d)
    assert all(point_in_polygon(p, inner) >= 0 for p in d.vertices)
    assert all(point_in_polygon(p, outer) > 0 for p in inner)
    if g.is_convex and d.is_convex:
        assert inner == d.vertices


@patient
@given(all_pairs(), own.translations(), own.translations())
def test_translation_commutes(pair: Pair, by_g: Any, by_d: Any) -> None:
    g, d = pair
    loops = reference_loops(g, d)
    moved = reference_loops(g.translated(by_g), d.translated(by_d))
    shift = by_d[0] - by_g[0], by_d[1] - by_g[1]
    assert moved.trajectory == Polygon(loops.trajectory).translated(shift).vertices
    assert moved.inner == Polygon(loops.inner).translated(by_d).vertices
    assert moved.outer == Polygon(loops.outer).translated(by_d).vertices


@patient
@given(all_pairs(), own.tiny(-3, 3), own.tiny(1, 3))
def test_turning_commutes(pair: Pair, a: int, b: int) -> None:
    g, d = pair
    way = Fraction(a, b + 1), Fraction(b, b + 1)
    loops = reference_loops(turned(g, a, b), turned(d, a, b), way)
    assert loops == tuple(turned(Polygon(loop), a, b).vertices for loop in reference_loops(g, d))
    fits = reference_exact_fits(turned(g, a, b), turned(d, a, b), way)
    assert len(fits) == len(reference_exact_fits(g, d))


@patient
@given(all_pairs())
def test_opposite_direction_changes_nothing(pair: Pair) -> None:
    assert reference_loops(*pair, (-1, 0)) == reference_loops(*pair)
    assert reference_exact_fits(*pair, (-1, 0)) == reference_exact_fits(*pair)
