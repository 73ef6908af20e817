"""Features of shapes: found by their places as by looking at all."""

from fractions import Fraction
from itertools import product
from random import Random

import families
from small_pairs import draw_touching

from exactsweep import Polygon, Region
from exactsweep.evidence.contact import MonotoneOutline
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.vectors import is_on_segment


def test_monotone_outlines_find_what_others_do_and_each_once() -> None:
    rng = Random(4)
    for _ in range(25):
        loop = Polygon(families.jagged(rng, 0.5, (1, 3))).lattice()[1]
        slow, quick = Outline([loop]), MonotoneOutline(loop)
        (left, right), (low, high) = (
            (min(p[k] for p in loop), max(p[k] for p in loop)) for k in (0, 1)
        )
        xs, ys = (
            [Fraction(k, 2) for k in range(2 * int(a) - 1, 2 * int(b) + 2)]
            for a, b in ((left, right), (low, high))
        )
        for point in product(xs, ys):
            assert sorted(quick.edges_through(point)) == sorted(slow.edges_through(point))
        enlarged = quick.scaled(3)
        assert enlarged.vertices == [(3 * x, 3 * y) for x, y in loop]
        assert enlarged.edges == slow.scaled(3).edges
        for low, high in [(0, 0), (1, 3), (-2, 1)]:
            found = slow.vertices_between(low, high)
            assert {*found} == {k for k, (x, _) in enumerate(loop) if low <= x <= high}
            assert [loop[k][0] for k in found] == sorted(loop[k][0] for k in found)


def test_features_are_counted_through_all_rings() -> None:
    square, hole = [(0, 0), (9, 0), (9, 9), (0, 9)], [(1, 1), (1, 2), (2, 1)]
    outline = Outline([square, hole])
    assert outline.after == [1, 2, 3, 0, 5, 6, 4]
    assert outline.before == [3, 0, 1, 2, 6, 4, 5]
    assert outline.edge(6) == ((2, 1), (1, 1))
    assert [*outline.edges_through((Fraction(3, 2), 1))] == [6]
    assert outline.scaled(2).edges == [
        ((2 * a, 2 * b), (2 * c, 2 * d)) for (a, b), (c, d) in outline.edges
    ]


def test_vertices_of_other_rings_inside_edges_are_found() -> None:
    touched = 0
    for number in range(40):
        exterior, *holes = draw_touching(Random(number)).directrix
        # On either side of the diagonal, so that x and y are not taken for each other.
        shape = Region(exterior, holes).translated((2**50 * (-1) ** number, 0))
        outline = Outline(shape.lattice()[1])
        for k, (p, q) in enumerate(outline.edges):
            expected = {
                j
                for j, v in enumerate(outline.vertices)
                if v not in (p, q) and is_on_segment(v, p, q)
            }
            assert {*outline.vertices_inside(k)} == expected
            touched += len(expected)
    assert touched > 20
