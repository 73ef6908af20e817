"""Features at a point, compared with a scan of all features."""

from fractions import Fraction
from itertools import product
from random import Random

import families

from exactsweep import Polygon
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.vectors import is_between


def test_features_at_a_point_match_the_definition() -> None:
    """On and between lattice points, with and without more edges than a linear scan handles."""
    rng = Random(4)
    for n in range(25):
        loop = Polygon(families.jagged(rng, 4, (1, 3))).lattice()[1]
        outline = Outline([loop, *([[(x, y + 50) for x, y in loop]] if n % 2 else [])])
        (left, right), (low, high) = (
            (int(min(p[k] for p in loop)), int(max(p[k] for p in loop))) for k in (0, 1)
        )
        for x, y in product(range(2 * left - 1, 2 * right + 2), range(2 * low - 1, 2 * high + 2)):
            point = Fraction(x, 2), Fraction(y, 2)
            inside = [k for k, edge in enumerate(outline.edges) if is_between(point, *edge)]
            corners = [k for k, vertex in enumerate(outline.vertices) if vertex == point]
            expected = [*(("E", k) for k in inside), *(("V", k) for k in corners)]
            assert sorted(outline.find_at(point)) == expected
            assert sorted(outline.find_at((x, y), 2)) == expected


def test_features_are_counted_through_all_rings() -> None:
    square, hole = [(0, 0), (9, 0), (9, 9), (0, 9)], [(1, 1), (1, 2), (2, 1)]
    outline = Outline([square, hole])
    assert outline.after == [1, 2, 3, 0, 5, 6, 4]
    assert outline.before == [3, 0, 1, 2, 6, 4, 5]
    assert outline.edge(6) == ((2, 1), (1, 1))
    assert [*outline.find_at((Fraction(3, 2), 1))] == [("E", 6)]
