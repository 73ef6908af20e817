"""Stops of G at a contact: every pair of corners on a small grid, every direction of motion."""

from fractions import Fraction
from itertools import product

import pytest

from exactsweep import Polygon
from exactsweep.check import classify
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.steps import blocks
from exactsweep.geometry.outline import Outline
from exactsweep.numbers.number import Vertex

COMPASS: list[Vertex] = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)]
DIRECTIONS: list[Vertex] = [*COMPASS, (2, 1), (-1, 2), (-2, -1), (1, -2)]


def corner(forward: int, back: int) -> list[Vertex]:
    """Return a polygon with first vertex (0, 0) and edges there in two of eight directions."""
    size = (back - forward) % 8
    return [(0, 0), *(COMPASS[(forward + k) % 8] for k in range(size + 1))]


def overlaps(d: list[Vertex], g: list[Vertex], t: Vertex) -> bool:
    fixed, moved = (Polygon([(100 * x, 100 * y) for x, y in ring]) for ring in (d, g))
    return classify(fixed, moved, t).verdict == "OVERLAP"


@pytest.mark.parametrize(("forward", "size"), [(0, 1), (1, Fraction(1, 9))])
def test_a_corner_blocks_another_where_they_would_overlap(
    forward: int, size: Fraction | int
) -> None:
    """Convex and reflex corners, with and without parallel edges."""
    tried = 0
    for d_size, g_first, g_size in product(range(1, 8), range(8), range(1, 8)):
        if 4 in (d_size, g_size) or d_size + g_size > 8:
            continue
        d, g = corner(forward, forward + d_size), corner(g_first, g_first + g_size)
        if overlaps(d, g, (0, 0)):
            continue
        one, other = (Outline([[(size * x, size * y) for x, y in ring]]) for ring in (g, d))
        for direction in DIRECTIONS:
            stopped = blocks(Contact("VV", 0, 0), direction, one, other)
            assert stopped == overlaps(d, g, direction), (d, g, direction)
            tried += 1
    assert tried > 500


@pytest.mark.parametrize("size", [1, Fraction(1, 9)])
def test_a_corner_on_an_edge_lets_g_pass_along_and_away(size: Fraction | int) -> None:
    """A corner of one touches the left edge of the other, which runs straight down."""
    square = Outline([[(0, 0), (size, 0), (size, size), (0, size)]])
    for direction in DIRECTIONS:
        on_directrix = blocks(Contact("VE", 2, 3), direction, square, square)
        on_generatrix = blocks(Contact("EV", 3, 2), direction, square, square)
        assert (on_directrix, on_generatrix) == (direction[0] > 0, direction[0] < 0)
