"""Convex pieces of plates with many holes."""

from random import Random

import pytest
from linear import require_linear

from exactsweep.geometry.canonical import find_doubled_area, find_turns
from exactsweep.geometry.convex import IntRing, cut_to_convex


def make_plate(holes: int, seed: int = 0) -> list[IntRing]:
    """A square plate with holes of three or four corners, at random on a lattice."""
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
    # At most one for each concave corner, and the first.
    assert len(pieces) <= 1 + sum(map(len, rings[1:]))


@pytest.mark.long
def test_many_holes_take_linear_time() -> None:
    require_linear(lambda holes: cut_to_convex(make_plate(holes)), 36)
