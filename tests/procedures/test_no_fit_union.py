"""Groups of shapes as one rigid shape: known answers, and the definition."""

from fractions import Fraction
from itertools import product
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pruned import STEPS, pruning
from strategies import points

from exactsweep import (
    Point,
    PolygonError,
    Region,
    free_positions,
    inner_fit_polygon,
    no_fit_polygon,
    no_fit_union,
    overlap,
)
from exactsweep.check import classify
from exactsweep.procedures.positions import find_no_fit_union

Corners = list[tuple[int, int]]


def box(left: int, low: int, right: int, high: int) -> Corners:
    return [(left, low), (right, low), (right, high), (left, high)]


UNIT = box(0, 0, 1, 1)


def test_two_obstacles_give_the_union_and_the_gap_between_them() -> None:
    n = no_fit_union([UNIT, box(2, 0, 3, 1)], [UNIT])
    assert n.regions == (Region(box(-1, -1, 3, 1)),)
    assert n.area == 8
    assert n.exact_fits == (points((1, -1), (1, 1)),)
    assert [n.locate((x, 0)) for x in (0, 1, 3, 4)] == ["overlap", "contact", "contact", "free"]


def test_a_moving_group_is_the_reflection_of_a_stationary_one() -> None:
    group = [UNIT, box(2, 0, 3, 1), [(0, 5), (2, 5), (1, 7)]]
    still, moved = no_fit_union(group, [UNIT]), no_fit_union([UNIT], group)
    assert {r.scaled((-1, -1)) for r in still.regions} == set(moved.regions)
    assert still.area == moved.area


def test_a_single_pair_is_its_no_fit_polygon() -> None:
    hollow = Region(box(0, 0, 9, 9), [box(1, 1, 4, 3), box(5, 5, 6, 6)])
    n, one = no_fit_union([hollow], [UNIT]), no_fit_polygon(hollow, UNIT)
    assert n.regions == (Region(one.exterior, one.holes),)
    assert n.exact_fits == one.exact_fits


def test_touching_regions_stay_separate() -> None:
    # The squares of overlap share the corner (1, 1).
    corners = no_fit_union([UNIT, box(2, 2, 3, 3)], [UNIT])
    assert corners.regions == (Region(box(-1, -1, 1, 1)), Region(box(1, 1, 3, 3)))
    # Two hooks whose regions touch at (1, 4) and (4, 1) enclose free positions.
    low = [(0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (0, 4)]
    high = [(6, 6), (2, 6), (2, 5), (5, 5), (5, 2), (6, 2)]
    n = no_fit_union([low, high], [UNIT])
    assert n.regions == (
        Region([(-1, -1), (4, -1), (4, 1), (1, 1), (1, 4), (-1, 4)]),
        Region([(6, 6), (1, 6), (1, 4), (4, 4), (4, 1), (6, 1)]),
    )
    assert (n.exact_fits, n.locate((2, 2)), n.locate((1, 4))) == ((), "free", "contact")


def test_a_region_may_lie_in_a_hole_of_another() -> None:
    ring = Region(box(0, 0, 9, 9), [box(1, 1, 8, 8)])
    n = no_fit_union([ring, box(4, 4, 5, 5)], [UNIT])
    assert [str(region.area) for region in n.regions] == ["64", "4"]


def test_shapes_of_a_group_may_touch_and_overlap() -> None:
    halves = no_fit_union([box(0, 0, 1, 2), box(1, 0, 2, 2)], [UNIT, UNIT])
    assert (halves.regions, halves.exact_fits) == ((Region(box(-1, -1, 2, 2)),), ())
    assert no_fit_union([UNIT, UNIT, box(0, 0, 1, 2)], [UNIT]).area == 6


def test_an_attached_shape_moves_with_the_part() -> None:
    f = free_positions(box(0, 0, 9, 3), [], UNIT, attached=[box(3, 0, 4, 1)])
    assert f.regions == (Region(box(0, 0, 5, 2)),)
    placed = free_positions(box(0, 0, 9, 1), [box(2, 0, 3, 1)], UNIT, attached=[box(3, 0, 4, 1)])
    # Both parts are left of the placed box, on both sides of it, or right of it.
    assert placed.exact_fits == (points((0, 0), (1, 0)), points((3, 0), (5, 0)))
    exact = free_positions(box(0, 0, 4, 1), [], UNIT, attached=[box(3, 0, 4, 1)])
    assert exact.exact_fits == (points((0, 0), (0, 0)),)
    assert f != inner_fit_polygon(box(0, 0, 9, 3), UNIT)


def test_errors_name_the_shape() -> None:
    with pytest.raises(PolygonError, match=r"^orbiting shape 1: "):
        no_fit_union([UNIT], [UNIT, [(0, 0), (1, 1)]])
    with pytest.raises(PolygonError, match="stationary has no shape"):
        no_fit_union([], [UNIT])
    with pytest.raises(PolygonError, match="stationary is a single shape"):
        no_fit_union(Region(UNIT), [UNIT])  # type: ignore[arg-type]
    with pytest.raises(PolygonError, match="do not cover groups"):
        no_fit_union([UNIT], [UNIT]).certificate()
    with pytest.raises(PolygonError, match="placed shapes or attached ones"):
        free_positions(UNIT, [], UNIT, attached=[UNIT]).certificate()


@st.composite
def shapes(draw: st.DrawFn) -> Region:
    """Draw a small shape on the integer lattice."""
    w, h = draw(st.integers(1, 3)), draw(st.integers(1, 3))
    drawn = [
        Region(box(0, 0, w, h)),
        Region([(0, 0), (w, 0), (0, h)]),
        Region([(0, 0), (w + 1, 0), (w + 1, 1), (1, 1), (1, h + 1), (0, h + 1)]),
        Region(box(0, 0, w + 2, h + 2), [box(1, 1, w + 1, h + 1)]),
        Region([(0, 0), (w, h), (0, 2 * h), (-w, h)]),
    ]
    mirror = draw(st.sampled_from([(1, 1), (-1, 1), (1, -1), (-1, -1)]))
    move = draw(st.integers(0, 5)), draw(st.integers(0, 5))
    return draw(st.sampled_from(drawn)).scaled(mirror).translated(move)


groups = st.lists(shapes(), min_size=1, max_size=3)


def expected(stationary: list[Region], orbiting: list[Region], t: Point) -> str:
    """Locate a position by the definition, pair by pair."""
    verdicts = {classify(d, g, t).verdict for d in stationary for g in orbiting}
    return next(v for v in ("OVERLAP", "CONTACT", "FREE") if v in verdicts).lower()


def list_positions(regions: tuple[Region, ...]) -> list[Point]:
    """List a grid of halves around regions."""
    low, high = zip(*(region.bounding_box for region in regions), strict=True)
    xs = range(int(2 * min(p.x for p in low)) - 1, int(2 * max(p.x for p in high)) + 2)
    ys = range(int(2 * min(p.y for p in low)) - 1, int(2 * max(p.y for p in high)) + 2)
    return [Point(Fraction(x, 2), Fraction(y, 2)) for x, y in product(xs, ys)]


@given(groups, groups, st.randoms(use_true_random=False))
@settings(max_examples=30)
def test_positions_match_the_definition(
    stationary: list[Region], orbiting: list[Region], rng: Random
) -> None:
    n = no_fit_union(stationary, orbiting)
    loops = [ring for region in n.regions for ring in region.rings]
    edges = [(ring[k - 1], p) for ring in loops for k, p in enumerate(ring)]
    marked = [Point((p.x + q.x) / 2, (p.y + q.y) / 2) for p, q in (*edges, *n.exact_fits)]
    grid = list_positions(n.regions)
    for t in rng.sample(grid, min(40, len(grid))) + rng.sample(marked, min(20, len(marked))):
        assert n.locate(t) == expected(stationary, orbiting, t)
        assert sum(region.contains(t) for region in n.regions) <= 1 or n.locate(t) == "contact"


@given(groups, groups)
@settings(max_examples=30)
def test_regions_of_overlap_are_connected_and_disjoint(
    stationary: list[Region], orbiting: list[Region]
) -> None:
    n = no_fit_union(stationary, orbiting)
    for k, region in enumerate(n.regions):
        # Reading the rings again checks them: a Region has a connected interior.
        assert Region(region.exterior.vertices, [h.vertices for h in region.holes]) == region
        assert all(overlap(region, other).verdict != "OVERLAP" for other in n.regions[:k])


@given(groups, groups, st.randoms(use_true_random=False))
@settings(max_examples=30)
def test_free_positions_of_a_group_match_the_definition(
    placed: list[Region], parts: list[Region], rng: Random
) -> None:
    bin, frame = box(-3, -3, 9, 9), Region(box(-99, -99, 99, 99), [box(-3, -3, 9, 9)])
    f = free_positions(bin, placed, parts[0], attached=parts[1:])
    said = {"inside": "free", "boundary": "contact", "outside": "overlap"}
    for t in rng.sample(list_positions((Region(bin),)), 40):
        assert said[f.locate(t)] == expected([frame, *placed], parts, t)


@given(groups, groups)
@settings(max_examples=15)
def test_pruning_steps_do_not_change_answers(
    stationary: list[Region], orbiting: list[Region]
) -> None:
    d, g = ([shape.lattice()[1] for shape in group] for group in (stationary, orbiting))
    plain = find_no_fit_union(d, g)
    for thin, wide in STEPS:
        with pruning(thin=thin, wide=wide):
            assert find_no_fit_union(d, g) == plain
