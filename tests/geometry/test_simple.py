"""The sweep of `find_conflict`, compared with all pairs of edges on grids where most rings fail."""

import random
from fractions import Fraction
from itertools import combinations

import pytest

from exactsweep import Polygon, PolygonError
from exactsweep.geometry.canonical import canonicalize_ring, find_turns
from exactsweep.geometry.simplicity import Conflict, find_conflict
from exactsweep.numbers.number import Vertex


def turn(a: Vertex, b: Vertex, c: Vertex) -> int:
    product = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (product > 0) - (product < 0)


def on_segment(p: Vertex, a: Vertex, b: Vertex) -> bool:
    return turn(a, b, p) == 0 and min(a, b) <= p <= max(a, b)


def segments_meet(a: Vertex, b: Vertex, c: Vertex, d: Vertex) -> bool:
    if turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0:
        return True
    return on_segment(c, a, b) or on_segment(d, a, b) or on_segment(a, c, d) or on_segment(b, c, d)


def is_simple(points: list[Vertex]) -> bool:
    """Apply the definition: adjacent edges meet only in their common vertex, others nowhere."""
    ring = [p for i, p in enumerate(points) if p != points[i - 1]]
    n = len(ring)
    if n < 3:
        return False
    for i, j in combinations(range(n), 2):
        a, b, c, d = ring[i], ring[(i + 1) % n], ring[j], ring[(j + 1) % n]
        if j == i + 1:
            if on_segment(d, a, b) or on_segment(a, c, d):
                return False
        elif (j + 1) % n == i:
            if on_segment(c, a, b) or on_segment(b, c, d):
                return False
        elif segments_meet(a, b, c, d):
            return False
    return True


def holds(conflict: Conflict, ring: list[Vertex]) -> bool:
    """Decide whether the reported features meet as reported."""
    kind, i, j = conflict
    p, q = ring[i], ring[j]
    p_next, q_next = ring[(i + 1) % len(ring)], ring[(j + 1) % len(ring)]
    if kind == "vertices coincide":
        return i != j and p == q
    if kind == "vertex touches edge":
        return p not in (q, q_next) and on_segment(p, q, q_next)
    sides = [
        turn(p, p_next, q),
        turn(p, p_next, q_next),
        turn(q, q_next, p),
        turn(q, q_next, p_next),
    ]
    return sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0


def agrees(points: list[Vertex]) -> bool:
    """Compare with the definition; return whether the ring is simple."""
    expected = is_simple(points)
    try:
        canonicalize_ring(points)
    except PolygonError:
        assert not expected, points
    else:
        assert expected, points
    ring = [p for i, p in enumerate(points) if p != points[i - 1]]
    turns_back = any(
        turn(a, b, c) == 0 and not min(a, c) < b < max(a, c)
        for a, b, c in zip(ring, ring[1:] + ring[:1], ring[2:] + ring[:2], strict=True)
    )
    if len(ring) > 2 and not turns_back:
        conflict = find_conflict(ring)
        assert (conflict is None) == expected, ring
        assert conflict is None or holds(conflict, ring), (conflict, ring)
    return expected


@pytest.mark.parametrize("side", [2, 3, 5, 9])
def test_sweep_agrees_with_all_pairs_on_random_rings(side: int) -> None:
    rng = random.Random(side)
    simple = 0
    for _ in range(4000):
        count = rng.randint(3, 9)
        points: list[Vertex] = [(rng.randrange(side), rng.randrange(side)) for _ in range(count)]
        simple += agrees(points)
    assert simple > 50


@pytest.mark.parametrize("side", [4, 8])
def test_sweep_agrees_with_all_pairs_on_nearly_simple_rings(side: int) -> None:
    """Rings made simple by reversing crossed segments, then one vertex moved."""
    rng = random.Random(side)
    simple = 0
    for _ in range(500):
        grid = [(x, y) for x in range(side) for y in range(side)]
        ring = untangled(rng.sample(grid, rng.randint(5, 12)))
        simple += agrees(ring)
        ring[rng.randrange(len(ring))] = rng.choice(grid)
        agrees(ring)
    assert simple > 100


def untangled(ring: list[Vertex]) -> list[Vertex]:
    n = len(ring)
    for _ in range(4 * n):
        for i, j in combinations(range(n), 2):
            a, b, c, d = ring[i], ring[i + 1], ring[j], ring[(j + 1) % n]
            if turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0:
                ring[i + 1 : j + 1] = ring[i + 1 : j + 1][::-1]
                break
        else:
            break
    return ring


def test_many_vertices_are_checked_by_a_sweep() -> None:
    """All pairs would be 5 * 10**7 here."""
    teeth = [(x, 10**6 * (x % 2)) for x in range(5000)]
    ring = [*teeth, *((x, 10**6 * (x % 2) + 1) for x, _ in reversed(teeth))]
    assert len(Polygon(ring)) == len(ring)
    ring[7000] = (ring[7000][0], ring[7000][1] - 2)
    with pytest.raises(PolygonError, match=r"edges 2998 and 7000 cross|edges 2999 and 6999 cross"):
        Polygon(ring)


def random_monotone_ring(rng: random.Random, width: int, height: int) -> list[Vertex]:
    """Draw two chains from left to right on a small grid, with walls; they may touch or cross."""

    def chain() -> list[Vertex]:
        xs = sorted(rng.randrange(width) for _ in range(rng.randint(1, 5)))
        return [(x, rng.randrange(height)) for x in xs]

    return chain() + chain()[::-1]


@pytest.mark.parametrize(("width", "height"), [(3, 3), (4, 5), (8, 5)])
def test_rings_of_two_chains_from_left_to_right(width: int, height: int) -> None:
    rng = random.Random(width)
    simple = sum(agrees(random_monotone_ring(rng, width, height)) for _ in range(4000))
    assert simple > 200


@pytest.mark.parametrize(
    "ring",
    [
        # A wall of the top chain whose far end is below the near end of a wall of the bottom chain.
        [(0, 0), (2, 2), (2, 0), (4, 0), (4, 5), (2, 1), (2, 3), (0, 3)],
        # The chains cross at the last vertex, behind all others.
        [(0, 0), (3, 1), (4, 4), (4, 3), (3, 2)],
        [(0, 0), (1, 1), (1, 0), (4, 0), (1, 1), (0, 1)],
    ],
)
def test_chains_that_meet_at_walls_are_rejected(ring: list[Vertex]) -> None:
    assert not agrees(ring)
    assert not agrees(ring[::-1])
    assert not agrees([(-x, -y) for x, y in ring])


@pytest.mark.parametrize("scale", [1, 10**40, Fraction(1, 10**4), Fraction(7, 10**9 + 7)])
def test_the_unit_does_not_matter(scale: int | Fraction) -> None:
    """Also for cross products below 1, and with a single vertex of ints."""
    rng, kinds = random.Random(9), set()
    for _ in range(300):
        size = rng.randint(3, 6)
        points: list[Vertex] = [
            (0, 0),
            *((rng.randint(-3, 3), rng.randint(-3, 3)) for _ in range(size)),
        ]
        scaled: list[Vertex] = [(x * scale, y * scale) if x or y else (0, 0) for x, y in points]
        try:
            ring = canonicalize_ring(points)
        except PolygonError as error:
            with pytest.raises(PolygonError, match=str(error)):
                canonicalize_ring(scaled)
            continue
        found = canonicalize_ring(scaled)
        assert found.points == tuple((x * scale, y * scale) for x, y in ring.points)
        assert found[1:] == ring[1:]
        assert ring.convex == (min(find_turns(ring.points)) > 0)
        kinds.add(found[3:])
    assert kinds == {(True, True), (False, True), (False, False)}
