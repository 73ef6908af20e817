"""Overlap of interiors where boundaries only touch."""

from collections import Counter
from collections.abc import Collection, Sequence
from fractions import Fraction
from itertools import product
from math import ceil, cos, floor, lcm, pi, sin
from random import Random

import pytest
import small_pairs
from cells import shape_of
from polyominoes import Matrix

from exactsweep import Point, Region
from exactsweep.check import classify
from exactsweep.corpus.generator.cells import Cell, grow
from exactsweep.geometry.edges import EdgeIndex, Rings, is_inside
from exactsweep.geometry.overlap import Relation, contains, find_outside, relate
from exactsweep.geometry.vectors import touch
from exactsweep.numbers.number import Rational, Vertex
from exactsweep.paper.counting import make_counted, watch_operations

Pair = tuple[EdgeIndex, EdgeIndex]

ORIGIN = Point(Fraction(0), Fraction(0))


def overlaps(pair: Pair, t: Point) -> bool:
    return relation(pair, t) is Relation.OVERLAP


def relation(pair: Pair, t: Point) -> Relation:
    scale = lcm(t.x.denominator, t.y.denominator)
    return relate(*pair, int(t.x * scale), int(t.y * scale), scale)


def pair_of(stationary: Rings, orbiting: Rings) -> Pair:
    return EdgeIndex(stationary), EdgeIndex(orbiting)


AROUND = [*product(range(-1, 4), repeat=2)]
SQUARE = [[(0, 0), (4, 0), (4, 4), (0, 4)]]


def test_tips_of_holes_touch_the_midpoints_of_all_edges() -> None:
    """The interior of a square is overlapped, but no midpoint of its edges is."""
    tips = [
        [(2, 0), (1, -2), (3, -2)],
        [(4, 2), (6, 1), (6, 3)],
        [(2, 4), (3, 6), (1, 6)],
        [(0, 2), (-2, 3), (-2, 1)],
    ]
    plate = Region([(-9, -9), (13, -9), (13, 13), (-9, 13)], tips).lattice()[1]
    assert overlaps(pair_of(SQUARE, plate), ORIGIN)
    assert overlaps(pair_of(plate, SQUARE), ORIGIN)


def test_overlap_matches_the_definition() -> None:
    """With vertices on vertices and on midpoints of edges, next to these, and with containment."""
    rng = Random(5)
    found: Counter[bool] = Counter()
    for number in range(100):
        pair = (small_pairs.draw_shapeless if number % 2 else small_pairs.draw)(rng)
        g, d = (Region(shape[0], shape[1:]) for shape in pair)
        # Off the lattice a point and its floor may lie in different columns of edges.
        aside = rng.choice([None, None, Fraction(1, 3), Fraction(5, 7)]) or Fraction(0)
        rings: list[list[Vertex]] = [[(x + aside, y) for x, y in ring] for ring in d.lattice()[1]]
        test = pair_of(rings if aside else d.lattice()[1], g.lattice()[1])
        for _ in range(10):
            (v, _), (p, q) = (edge_of(rng, shape) for shape in pair)
            share = Fraction(rng.randint(0, 2), 2)
            shift = rng.choice([Fraction(0), Fraction(0), Fraction(1, 3)])
            t = Point(*(b + share * (c - b) - a + shift for a, b, c in zip(v, p, q, strict=True)))
            there = classify(d, g, t).verdict == "OVERLAP"
            assert overlaps(test, Point(t.x + aside, t.y)) == there, (pair, t, aside)
            found[there] += 1
    assert min(found.values()) > 200


@pytest.mark.parametrize("matrix", [(1, 0, 0, 1), (0, -1, 1, 0), (2, 1, 1, 2), (1, -3, 0, 2)])
def test_polyominoes_overlap_if_their_squares_do(
    matrix: Matrix,
) -> None:
    """On the grid, halfway between grid points, and elsewhere."""
    rng = Random(matrix[1])
    found: Counter[tuple[bool, bool]] = Counter()
    relations: Counter[Relation] = Counter()
    for _ in range(40):
        d, g = (grow(rng.randrange(10**6) for _ in range(rng.randrange(n))) for n in (24, 4))
        (outer, orbiting) = (loops_of(cells, matrix, rng) for cells in (d, g))
        inside_of = pair_of(outer, orbiting)
        room = -99, 99, -99, 99
        outside = [find_outside(outer[0], room), *([ring[::-1]] for ring in outer[1:])]
        outside_of = [pair_of(rings, orbiting) for rings in outside]
        for _ in range(12):
            part = rng.choice([1, 2, 3])
            (dx, dy), (gx, gy) = (rng.choice(sorted(cells)) for cells in (d, g))
            ux, uy = (a - b + Fraction(rng.randint(-2, 2), part) for a, b in ((dx, gx), (dy, gy)))
            over = {
                (x, y)
                for gx, gy in g
                for x in (floor(gx + ux), ceil(gx + ux))
                for y in (floor(gy + uy), ceil(gy + uy))
            }
            t = Point(matrix[0] * ux + matrix[1] * uy, matrix[2] * ux + matrix[3] * uy)
            assert overlaps(inside_of, t) == bool(over & d), (d, g, t)
            reaches_out = any(overlaps(pair, t) for pair in outside_of)
            assert reaches_out == bool(over - d), (d, g, t)
            found[bool(over & d), bool(over - d)] += 1
            near = any(
                abs(gx + ux - dx) <= 1 and abs(gy + uy - dy) <= 1
                for (dx, dy), (gx, gy) in product(d, g)
            )
            closed = Relation.CONTACT if near else Relation.APART
            expected = Relation.OVERLAP if over & d else closed
            assert relation(inside_of, t) is expected, (d, g, t)
            assert relation(pair_of(orbiting, outer), Point(-t.x, -t.y)) is expected, (d, g, t)
            relations[expected] += 1
    assert len(found) == len(relations) == 3
    assert min(found.values()) > 20
    assert min(relations.values()) > 5


@pytest.mark.parametrize("matrix", [(1, 0, 0, 1), (1, 1, 0, 1), (2, 1, 1, 2), (1, -3, 0, 2)])
@pytest.mark.parametrize("unit", [1, Fraction(1, 9)])
def test_a_point_is_inside_if_all_squares_around_it_are(
    matrix: Matrix, unit: int | Fraction
) -> None:
    """At vertices, on edges, above and below edges and elsewhere, on a grid of halves."""
    rng = Random(matrix[1])
    a, b, c, d = (unit * part for part in matrix)
    half = Fraction(1, 2)
    for _ in range(6):
        cells = grow(rng.randrange(10**6) for _ in range(rng.randrange(24)))
        rings = loops_of(cells, (a, b, c, d), rng)
        for x, y in {(2 * cx + i, 2 * cy + j) for cx, cy in cells for i, j in AROUND}:
            around = product({x // 2, (x - 1) // 2}, {y // 2, (y - 1) // 2})
            found = is_inside(((a * x + b * y) * half, (c * x + d * y) * half), rings)
            assert found == cells.issuperset(around), (cells, x, y)


@pytest.mark.parametrize("turns", range(4))
def test_a_tip_in_a_bar(turns: int) -> None:
    """No other part of one is near the other, and neither contains a vertex of the other."""

    def turned(ring: list[tuple[int, int]]) -> list[list[Vertex]]:
        for _ in range(turns):
            ring = [(-y, x) for x, y in ring]
        return [[*ring]]

    tip, bar = turned([(0, 0), (4, 0), (2, 6)]), turned([(0, 4), (4, 4), (4, 5), (0, 5)])
    assert overlaps(pair_of(tip, bar), ORIGIN)
    assert overlaps(pair_of(bar, tip), ORIGIN)
    above = turned([(0, 6), (4, 6), (4, 8), (0, 8)])
    assert not overlaps(pair_of(tip, above), ORIGIN)
    assert not overlaps(pair_of(above, tip), ORIGIN)


def test_shared_parts_of_edges_match_the_definition() -> None:
    def is_on(v: Vertex, a: Vertex, b: Vertex) -> bool:
        return turn(a, b, v) == 0 and min(a, b) <= v <= max(a, b)

    def turn(a: Vertex, b: Vertex, c: Vertex) -> int | Fraction:
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    def expect(a: Vertex, b: Vertex, p: Vertex, q: Vertex) -> set[Vertex] | None:
        shared = {v for v in (a, b) if is_on(v, p, q)} | {v for v in (p, q) if is_on(v, a, b)}
        if len(shared) == 2:
            return None if (a < b) == (p < q) else shared
        crossing = turn(a, b, p) * turn(a, b, q) < 0 and turn(p, q, a) * turn(p, q, b) < 0
        return None if crossing else shared

    rng = Random(8)
    for side in (3, 4, 7):
        grid = [(x, y) for x in range(side) for y in range(side)]
        for _ in range(2000):
            (a, b), (p, q) = rng.sample(grid, 2), rng.sample(grid, 2)
            found = touch(a, b, p, q)
            assert (found if found is None else {*found}) == expect(a, b, p, q), (a, b, p, q)


def loops_of(
    cells: Collection[Cell], matrix: Sequence[Rational], rng: Random
) -> list[list[Vertex]]:
    """Return the rings of a polyomino, holes clockwise, each from a random first vertex."""
    a, b, c, d = matrix
    loops = []
    for ring in Region(*shape_of(cells)).lattice()[1]:
        first = rng.randrange(len(ring))
        loop = [*ring[first:], *ring[:first]]
        loops.append([(a * x + b * y, c * x + d * y) for x, y in loop])
    return loops


def edge_of(rng: Random, shape: small_pairs.Shape) -> tuple[Vertex, Vertex]:
    ring = rng.choice(shape)
    k = rng.randrange(len(ring))
    return ring[k - 1], ring[k]


@pytest.mark.parametrize("far", [-(10**6), 0, 10**6])
def test_the_edges_near_a_point_are_found(far: int) -> None:
    """The edges whose boxes meet a query box, ordered by left end, among 800 adjacent edges."""
    low = [(3 * k + far, k % 2) for k in range(400)]
    shape = EdgeIndex([[*low, *((x, y + 5) for x, y in low[::-1])]])
    for x in range(far, far + 1197, 7):
        found = shape.near((x, x, 0, 6))
        assert found == [e for e in shape.edges if e[0] <= x <= e[1]]
        assert 2 <= len(found) <= 4


TRIANGLE = [(4, 0), (3, 4), (5, 4)]


@pytest.mark.parametrize("upright", [False, True])
def test_a_hole_touches_the_exterior_inside_an_edge_along_another_shape(upright: bool) -> None:
    """Both edges lie on y = 0; a hole of the plate, wider at the top, touches its edge at (4, 0).

    At that point, only the cone of the hole is open on both sides of y = 0.
    """

    def place(*rings: Sequence[Vertex]) -> list[list[Vertex]]:
        if upright:
            return [[(y, -x) for x, y in ring] for ring in rings]
        return [[*ring] for ring in rings]

    plate = place([(0, 0), (8, 0), (8, 8), (0, 8)], TRIANGLE)
    below = place([(2, -4), (6, -4), (6, 0), (2, 0)])
    above = place([(2, 0), (6, 0), (6, 4), (2, 4)])
    for other, expected in ((below, Relation.CONTACT), (above, Relation.OVERLAP)):
        for one, second in ((plate, other), (other, plate)):
            assert relation(pair_of(one, second), ORIGIN) is expected


def test_a_shape_contains_shapes_without_points_outside() -> None:
    plate: Rings = [[(0, 0), (8, 0), (8, 8), (0, 8)], [(4, 2), (3, 4), (5, 4)]]
    assert contains(plate, [[(0, 0), (2, 0), (0, 8)]])
    assert contains(plate[:1], plate)
    assert contains(plate, plate)
    assert not contains(plate, plate[:1])
    assert not contains(plate, [[(20, 0), (22, 0), (22, 1)]])


def test_a_path_overlaps_where_it_is_inside() -> None:
    """Along an edge, or at a vertex from outside, it only touches."""
    along, through, into = [(1, 0), (3, 0)], [(-2, 2), (2, -2)], [(-1, 2), (0, 2), (0, 1), (1, 1)]
    for path, expected in (
        (along, Relation.CONTACT),
        (through, Relation.CONTACT),
        ([(-2, 2), (1, -2)], Relation.APART),
        (into, Relation.OVERLAP),
        ([(1, 1), (2, 2)], Relation.OVERLAP),
        ([(-3, 2), (7, 2)], Relation.OVERLAP),
    ):
        ring = [*path, *path[-2:0:-1]]
        assert relation(pair_of(SQUARE, [ring]), ORIGIN) is expected, path
        assert relation(pair_of([ring], SQUARE), ORIGIN) is expected, path


def gear(teeth: int, radius: int) -> list[Vertex]:
    ring: list[Vertex] = []
    for k in range(2 * teeth):
        angle, reach = pi * k / teeth, radius + 100 * (k % 2)
        ring.append((round(reach * cos(angle)), round(reach * sin(angle))))
    return ring


def test_operations_grow_with_the_number_of_close_edges() -> None:
    counts = []
    for teeth in (100, 400):
        square: list[Vertex] = [(-2000, -2000), (2000, -2000), (2000, 2000), (-2000, 2000)]
        rings = [square, gear(teeth, 1000)[::-1], gear(teeth, 850)]
        around, hole, wheel = [make_counted(ring) for ring in rings]
        with watch_operations() as tally:
            assert relate(EdgeIndex([around, hole]), EdgeIndex([wheel])) is Relation.APART
        counts.append(tally.total)
    assert counts[1] < 8 * counts[0], counts
