"""Features of shapes: found by their places as by looking at all."""

from fractions import Fraction
from itertools import product
from random import Random

import families
from small_pairs import draw_touching

from exactsweep import Polygon, Region
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.vectors import is_between, is_on_segment


def test_features_at_a_point_are_those_of_the_definition() -> None:
    """For points on the lattice and between, with more edges than a search looks at one by one."""
    rng = Random(4)
    for n in range(25):
        loop = Polygon(families.jagged(rng, 4, (1, 3))).lattice()[1]
        outline = Outline([loop, *([[(x, y + 50) for x, y in loop]] if n % 2 else [])])
        (left, right), (low, high) = (
            (int(min(p[k] for p in loop)), int(max(p[k] for p in loop))) for k in (0, 1)
        )
        for x, y in product(range(2 * left - 1, 2 * right + 2), range(2 * low - 1, 2 * high + 2)):
            point = Fraction(x, 2), Fraction(y, 2)
            expected = [k for k, edge in enumerate(outline.edges) if is_between(point, *edge)]
            assert sorted(outline.edges_through(point)) == expected
            assert sorted(outline.edges_through((x, y), 2)) == expected
            corners = [k for k, vertex in enumerate(outline.vertices) if vertex == point]
            assert [*outline.vertices_at(point)] == [*outline.vertices_at((x, y), 2)] == corners


def test_features_are_counted_through_all_rings() -> None:
    square, hole = [(0, 0), (9, 0), (9, 9), (0, 9)], [(1, 1), (1, 2), (2, 1)]
    outline = Outline([square, hole])
    assert outline.after == [1, 2, 3, 0, 5, 6, 4]
    assert outline.before == [3, 0, 1, 2, 6, 4, 5]
    assert outline.edge(6) == ((2, 1), (1, 1))
    assert [*outline.edges_through((Fraction(3, 2), 1))] == [6]


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
