"""Directions of monotonicity, compared with counts of sign changes for single directions."""

from fractions import Fraction
from itertools import combinations, pairwise
from math import gcd
from typing import Any

import pytest
import strategies as own
from hypothesis import example, given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import DirectionError, Polygon, sweep
from exactsweep.geometry.direction import (
    X_AXIS,
    Directions,
    _find_simplest_between,
    find_monotone_directions,
    read_direction,
    reduce_direction,
    slope_key,
)
from exactsweep.geometry.frame import find_shared_direction
from exactsweep.geometry.vectors import compare_angles

Vector = tuple[int, int]

often = examples(100)

UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]
#  ____     a notch from the left: vertical lines
#  \\   |    meet it twice, horizontal lines once
#  /___|
NOTCHED = [(0, 0), (3, 0), (3, 2), (0, 2), (2, 1)]
# The same notch from all four sides.
STAR = [(0, 0), (2, 0), (3, 2), (4, 0), (6, 0), (6, 2), (4, 3), (6, 4)]
STAR += [(6, 6), (4, 6), (3, 4), (2, 6), (0, 6), (0, 4), (2, 3), (0, 2)]
#  |\\_/|  to the x-axis alone: vertical walls on both sides of a slot
SLOT = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
PLUS = [(1, 0), (2, 0), (2, 1), (3, 1), (3, 2), (2, 2)]
PLUS += [(2, 3), (1, 3), (1, 2), (0, 2), (0, 1), (1, 1)]


def ascents(polygon: Polygon, direction: Vector) -> list[int]:
    """Return the sign of each edge along a direction."""
    p, q = direction
    v = polygon.vertices
    steps = [p * (b.x - a.x) + q * (b.y - a.y) for a, b in zip(v, (*v[1:], v[0]), strict=True)]
    return [(step > 0) - (step < 0) for step in steps]


def is_weakly_monotone(polygon: Polygon, direction: Vector) -> bool:
    signs = [sign for sign in ascents(polygon, direction) if sign]
    return sum(a != b for a, b in zip(signs, signs[1:] + signs[:1], strict=True)) == 2


def is_strictly_monotone(polygon: Polygon, direction: Vector) -> bool:
    return all(ascents(polygon, direction)) and is_weakly_monotone(polygon, direction)


def is_strict(found: Directions, u: Vector) -> bool:
    """Decide whether a direction lies strictly inside an arc between critical directions."""
    return reduce_direction(u) not in found.critical and found.after[found._last_up_to(u)]


def trials(*polygons: Polygon) -> list[Vector]:
    """List the critical directions of polygons, one between each two, and a few more."""
    critical: set[Vector] = {(1, 0), (0, 1)}
    for polygon in polygons:
        v = polygon.lattice()[1]
        for (ax, ay), (bx, by) in zip(v, (*v[1:], v[0]), strict=True):
            critical |= {reduce_direction((ay - by, bx - ax))}
    turned = sorted(critical, key=lambda u: (u[0] == 0, u[1] * 10**40 // u[0] if u[0] else 0))
    between = [(a + c, b + d) for (a, b), (c, d) in pairwise(turned)]
    (a, b), (c, d) = turned[0], turned[-1]
    small = [(p, q) for p in range(3) for q in range(-2, 3) if gcd(p, q) == 1]
    return [*turned, *between, reduce_direction((c - a, d - b)), *map(reduce_direction, small)]


@given(own.simple_polygons())
@examples(50)
def test_monotone_means_two_changes_of_sign(polygon: Polygon) -> None:
    found = find_monotone_directions(polygon)
    for u in trials(polygon):
        assert (u in found) == is_weakly_monotone(polygon, u), u
        assert is_strict(found, u) == is_strictly_monotone(polygon, u), u
        assert ((-u[0], -u[1]) in found) == (u in found)
    assert bool(found) == any(is_weakly_monotone(polygon, u) for u in trials(polygon))


@given(own.simple_polygons())
@often
def test_x_monotonicity_is_the_same_for_every_construction(polygon: Polygon) -> None:
    expected = is_weakly_monotone(polygon, (1, 0))
    turned = polygon.reflected()
    made = [polygon, Polygon(polygon), Polygon(polygon.vertices), turned, Polygon(turned.vertices)]
    assert [shape.is_x_monotone for shape in made] == [expected] * 5


@given(own.simple_polygons(), own.simple_polygons())
@often
def test_shared_directions_are_monotone_for_both(one: Polygon, other: Polygon) -> None:
    shared = find_monotone_directions(one) & find_monotone_directions(other)
    for u in trials(one, other):
        assert (u in shared) == (is_weakly_monotone(one, u) and is_weakly_monotone(other, u)), u
        strictly = is_strictly_monotone(one, u) and is_strictly_monotone(other, u)
        assert is_strict(shared, u) == strictly, u


@given(own.simple_polygons())
@often
def test_arcs_contain_exactly_the_monotone_directions(polygon: Polygon) -> None:
    found = find_monotone_directions(polygon)
    if polygon.is_convex:
        first = found.critical[0]
        assert found.arcs() == ((first, first),)
        return
    for u in trials(polygon):
        within = any(on_arc(u, first, last) for first, last in found.arcs())
        assert within == (u in found), u
    # The arcs are maximal: directions between two of them are not monotone.
    assert len({first for first, _ in found.arcs()}) == len(found.arcs())


def on_arc(u: Vector, first: Vector, last: Vector) -> bool:
    """Decide whether u or -u lies on a counter-clockwise arc of at most a half turn."""

    def cross(a: Vector, b: Vector) -> int:
        return a[0] * b[1] - a[1] * b[0]

    if first == last:
        return reduce_direction(u) == first
    return any(cross(first, v) >= 0 and cross(v, last) >= 0 for v in (u, (-u[0], -u[1])))


@given(own.simple_polygons(), own.simple_polygons())
@examples(40)
def test_the_simplest_direction_is_chosen(one: Polygon, other: Polygon) -> None:
    """Prefer the x-axis, then strict directions, then the shortest vector."""
    tried = [reduce_direction(u) for u in trials(one, other)]
    tried += [(p, q) for p in range(12) for q in range(-11, 12) if gcd(p, q) == 1]
    shared = {u for u in tried if is_weakly_monotone(one, u) and is_weakly_monotone(other, u)}
    if not shared:
        assert find_shared_direction(one, other) is None
        return
    strict = {u for u in shared if is_strictly_monotone(one, u) and is_strictly_monotone(other, u)}
    chosen = find_shared_direction(one, other)
    assert chosen is not None
    assert chosen == (find_monotone_directions(one) & find_monotone_directions(other)).simplest()
    assert chosen == reduce_direction(chosen)
    if X_AXIS in shared:
        assert chosen == X_AXIS
    else:
        least = min(p * p + q * q for p, q in strict or shared)
        assert chosen[0] ** 2 + chosen[1] ** 2 <= least
        assert is_weakly_monotone(one, chosen)
        assert is_weakly_monotone(other, chosen)
        if strict:
            assert is_strictly_monotone(one, chosen)
            assert is_strictly_monotone(other, chosen)


@pytest.mark.parametrize(
    ("vertices", "text"),
    [
        (UNIT, "all directions"),
        # Perpendicular to the notch's edges, (2, 1) and (2, -1).
        (NOTCHED, "all from (1, 2) to (-1, 2), 63.4 to 116.6 degrees"),
        ([(y, x) for x, y in NOTCHED], "all from (2, -1) to (2, 1), -26.6 to 26.6 degrees"),
        (SLOT, "only (1, 0), 0 degrees"),
        (PLUS, "only (1, 0), 0 degrees and only (0, 1), 90 degrees"),
        (STAR, "no direction"),
    ],
)
def test_ranges_worked_by_hand(vertices: Any, text: str) -> None:
    assert str(find_monotone_directions(Polygon(vertices))) == text


def test_a_rejected_direction_lists_the_monotone_ones() -> None:
    with pytest.raises(DirectionError) as caught:
        sweep(UNIT, NOTCHED, direction=("1/2", 0))
    start = "the directrix is not monotone in direction (1, 0), 0 degrees; "
    assert str(caught.value).startswith(start)
    assert str(caught.value).endswith(str(find_monotone_directions(Polygon(NOTCHED))))


@pytest.mark.parametrize(
    ("given_", "expected"),
    [
        ((-4, 6), (2, -3)),
        ((0, -5), (0, 1)),
        (("1/2", "1/3"), (3, 2)),
        ((0.5, 1), (1, 2)),
        (iter((1, 0)), (1, 0)),
    ],
)
def test_directions_are_read_as_primitive_vectors(given_: Any, expected: Vector) -> None:
    assert read_direction(given_) == expected


# All directions of small components, by angle.
HALF = sorted(
    ((p, q) for p in range(7) for q in range(-6, 7) if gcd(p, q) == 1 and (p or q > 0)),
    key=slope_key,
)


def test_the_simplest_between_two_directions_is_strictly_between() -> None:
    """Also across the start of the circle; the X axis would be preferred."""
    turn = [*HALF, *((-p, -q) for p, q in HALF)]
    for i, u in enumerate(HALF):
        for j in range(i + 2, i + len(HALF)):
            between = {reduce_direction(v) for v in turn[i + 1 : j]}
            if X_AXIS not in between:
                least = min(between, key=lambda w: w[0] ** 2 + w[1] ** 2)
                assert _find_simplest_between(u, turn[j]) == least, (u, turn[j])


def test_the_simplest_of_single_directions_is_the_shortest() -> None:
    for u, v in combinations(HALF, 2):
        if X_AXIS not in (u, v):
            least = min(u, v, key=lambda w: (w[0] ** 2 + w[1] ** 2, w))
            assert Directions((u, v), (True, True), (False, False)).simplest() == least


def test_shared_directions_change_where_either_changes() -> None:
    flat = Polygon([(0, 0), (9, 1), (18, 0), (9, -1)])
    square, steep = find_monotone_directions(Polygon(UNIT)), find_monotone_directions(flat)
    assert steep.critical == ((1, -9), (1, 9))
    steep = find_monotone_directions(flat.rotated(90))
    assert steep.critical == ((9, -1), (9, 1))
    for shared in (square & steep, steep & square):
        assert shared.critical == ((9, -1), (1, 0), (9, 1), (0, 1))
    lying, sloped = find_monotone_directions(Polygon(NOTCHED)), find_monotone_directions(flat)
    assert str(lying & sloped) == str(sloped & lying) == str(lying)


COMPASS = [(2, 0), (2, 1), (1, 2), (0, 2), (-1, 2), (-2, 1)]
COMPASS += [(-x, -y) for x, y in COMPASS]
lengths = st.fractions(Fraction(1, 9), 9)


@given(st.sampled_from(COMPASS), st.sampled_from(COMPASS), lengths, lengths)
@example((2, 0), (2, 0), Fraction(1), Fraction(1, 9))
def test_angles_are_compared_counter_clockwise_at_any_length(
    u: tuple[int, int], v: tuple[int, int], one: Fraction, other: Fraction
) -> None:
    k, m = COMPASS.index(u), COMPASS.index(v)
    found = compare_angles((u[0] * one, u[1] * one), (v[0] * other, v[1] * other))
    assert found == (k > m) - (k < m)


VECTORS = [(x, y) for x in range(4) for y in range(-3, 4) if gcd(x, y) == 1 and (x, y) > (0, 0)]


@pytest.mark.parametrize("steep", [2, 3, 4, 99])
@pytest.mark.parametrize("way", VECTORS)
def test_the_simplest_of_few_directions_is_chosen(way: Vector, steep: int) -> None:
    x, y = way
    up = [(k * x - steep * (k % 2) * y, k * y + steep * (k % 2) * x) for k in range(5)]
    down = [(p + y, q - x) for p, q in reversed(up)]
    # A zigzag along `way`: the larger `steep`, the closer to `way` are its directions of
    # monotonicity.
    zigzag = Polygon([(-x, -y), *up, (5 * x, 5 * y), *down])
    chosen = find_shared_direction(zigzag, zigzag)
    assert chosen == find_monotone_directions(zigzag).simplest()
    assert chosen == way or steep < 99
