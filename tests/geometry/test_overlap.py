"""Whether interiors meet, where boundaries do no more than touch."""

from collections import Counter
from fractions import Fraction
from itertools import permutations, product
from random import Random

import pytest
import small_pairs

from exactsweep import Point, Region
from exactsweep.check import classify
from exactsweep.geometry.overlap import Overlap, touch
from exactsweep.geometry.point import Vertex

ORIGIN = Point(Fraction(0), Fraction(0))
SQUARE = [[(0, 0), (4, 0), (4, 4), (0, 4)]]


def test_triangle_hangs_in_a_square_by_its_first_vertex() -> None:
    triangle = [[(0, 2), (3, 1), (3, 3)]]
    assert Overlap(triangle, SQUARE).at(ORIGIN)
    assert Overlap(SQUARE, triangle).at(ORIGIN)


def test_tips_of_holes_touch_the_middles_of_all_edges() -> None:
    """The inside of a square is overlapped, though no middle of its edges is."""
    tips = [
        [(2, 0), (1, -2), (3, -2)],
        [(4, 2), (6, 1), (6, 3)],
        [(2, 4), (3, 6), (1, 6)],
        [(0, 2), (-2, 3), (-2, 1)],
    ]
    plate = Region([(-9, -9), (13, -9), (13, 13), (-9, 13)], tips).lattice()[1]
    assert Overlap(SQUARE, plate).at(ORIGIN)
    assert Overlap(plate, SQUARE).at(ORIGIN)


@pytest.mark.parametrize("end", [(1, 2), (1, -2)])
def test_edges_that_touch_with_one_end(end: Vertex) -> None:
    long, short = ((0, 0), (2, 0)), ((1, 0), end)
    for one, other in permutations((long, short)):
        for first, second in product((one, one[::-1]), (other, other[::-1])):
            assert touch(*first, *second) == [(1, 0)]


def test_interiors_meet_where_the_definition_says() -> None:
    """At vertices on vertices and on the middles of edges, beside these, and one in the other."""
    rng = Random(5)
    found: Counter[bool] = Counter()
    for number in range(100):
        pair = (small_pairs.draw_shapeless if number % 2 else small_pairs.draw)(rng)
        g, d = (Region(shape[0], shape[1:]) for shape in pair)
        # Off the lattice a point and its floor may lie in different columns of edges.
        aside = rng.choice([None, None, Fraction(1, 3), Fraction(5, 7)]) or Fraction(0)
        rings: list[list[Vertex]] = [[(x + aside, y) for x, y in ring] for ring in d.lattice()[1]]
        overlap = Overlap(rings if aside else d.lattice()[1], g.lattice()[1])
        for _ in range(10):
            (v, _), (p, q) = (edge_of(rng, shape) for shape in pair)
            share = Fraction(rng.randint(0, 2), 2)
            beside = rng.choice([Fraction(0), Fraction(0), Fraction(1, 3)])
            t = Point(*(b + share * (c - b) - a + beside for a, b, c in zip(v, p, q, strict=True)))
            there = classify(d, g, t).verdict == "OVERLAP"
            assert overlap.at(Point(t.x + aside, t.y)) == there, (pair, t, aside)
            found[there] += 1
    assert min(found.values()) > 200


def edge_of(rng: Random, shape: small_pairs.Shape) -> tuple[Vertex, Vertex]:
    ring = rng.choice(shape)
    k = rng.randrange(len(ring))
    return ring[k - 1], ring[k]
