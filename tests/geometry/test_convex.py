"""Convex pieces of plates with many holes."""

from collections.abc import Iterable
from math import cos, pi, sin
from random import Random
from typing import Any

import pytest
from linear import require_linear

from exactsweep.geometry import convex
from exactsweep.geometry.canonical import find_doubled_area, find_turns
from exactsweep.geometry.convex import IntRing, cut_to_convex


def make_plate(holes: int, seed: int = 0) -> list[IntRing]:
    """Return a square plate with triangles and quadrilaterals as holes, at random on a lattice."""
    random = Random(seed)
    columns = round(holes**0.5)
    wide = 10 * columns
    rings: list[IntRing] = [[(0, 0), (wide, 0), (wide, wide), (0, wide)]]
    for k in range(columns**2):
        x, y = 10 * (k % columns) + random.randint(1, 4), 10 * (k // columns) + random.randint(1, 4)
        corners = [(x, y), (x, y + 5), (x + 5, y + 4), (x + 4, y)]
        rings.append(corners[random.randrange(2) :])
    return rings


@pytest.mark.parametrize("shear", [0, 3, -40])
@pytest.mark.parametrize("holes", [9, 81])
def test_a_plate_with_many_holes_is_cut_into_convex_pieces(holes: int, shear: int) -> None:
    rings = [[(x + shear * y, y) for x, y in ring] for ring in make_plate(holes, holes)]
    pieces = cut_to_convex(rings)
    assert sum(map(find_doubled_area, pieces)) == sum(map(find_doubled_area, rings))
    assert all(min(find_turns(piece)) > 0 for piece in pieces)
    # At most one more than the number of reflex vertices.
    assert len(pieces) <= 1 + sum(map(len, rings[1:]))


def test_a_diagonal_collinear_with_an_edge_elsewhere_is_free() -> None:
    plus = [(0, 3), (3, 3), (3, 4), (4, 4), (4, 3), (5, 3), (5, 0), (6, 0), (6, 3), (9, 3), (9, 4)]
    ring = [
        *plus,
        (7, 4),
        (7, 5),
        (4, 5),
        (4, 7),
        (3, 7),
        (3, 6),
        (2, 6),
        (2, 7),
        (1, 7),
        (1, 6),
        (0, 6),
    ]
    for k in range(len(ring)):
        pieces = cut_to_convex([ring[k:] + ring[:k]])
        assert sum(map(find_doubled_area, pieces)) == find_doubled_area(ring)
        assert all(min(find_turns(piece)) > 0 for piece in pieces)


@pytest.mark.long
def test_many_holes_take_linear_time() -> None:
    require_linear(lambda holes: cut_to_convex(make_plate(holes)), 36)


def test_few_vertices_are_tried_for_each_diagonal(monkeypatch: pytest.MonkeyPatch) -> None:
    """All vertices of the hole of a ring are reflex, and their diagonals end far away."""
    tried: list[int] = []
    find_ends = convex._list_ends

    def count(p: Any, wide: Any, cones: Any, vertices: Iterable[Any]) -> Any:
        listed = [*vertices]
        tried.append(len(listed))
        return find_ends(p, wide, cones, listed)

    monkeypatch.setattr(convex, "_list_ends", count)
    numbers = []
    for n in (400, 1600):
        around = [(cos(2 * pi * k / n), sin(2 * pi * k / n)) for k in range(n)]
        outer, inner = ([(round(r * x), round(r * y)) for x, y in around] for r in (3e9, 1e9))
        tried.clear()
        cut_to_convex([outer, inner[::-1]])
        numbers.append(sum(tried))
    # All vertices for each diagonal would be 16 times as many.
    assert numbers[1] < 9 * numbers[0]
