"""A grid finds all that is near a segment or a vertex, and serves to cut plates with holes."""

from itertools import combinations
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st
from linear import require_linear
from tiers import examples

from exactsweep.geometry.canonical import find_doubled_area, find_turns
from exactsweep.geometry.convex import IntRing, cut_to_convex
from exactsweep.geometry.edges import touch
from exactsweep.geometry.grid import WallGrid
from exactsweep.geometry.vectors import turn

POINTS = st.tuples(st.integers(-30, 30), st.integers(-9, 9))


@examples(30)
@given(st.lists(POINTS, min_size=40, max_size=150, unique=True), st.randoms(use_true_random=False))
def test_all_that_meets_a_segment_is_found(points: list[tuple[int, int]], random: Random) -> None:
    grid = WallGrid(points)
    assert grid.columns > 1
    pairs = random.sample([*combinations(points, 2)], 60)
    walls, segments = pairs[:30], pairs[30:]
    for wall in walls:
        grid.build(*wall)
    for a, b in segments:
        found = {(p, q) for *_, p, q in grid.find_walls(a, b)}
        assert {wall for wall in walls if touch(a, b, *wall) != []} <= found <= {*walls}
        on = [p for p in points if p not in (a, b) and not turn(a, b, p)]
        low, high = sorted((a, b))
        assert sorted(grid.find_on(a, b)) == sorted(p for p in on if low < p < high)
        around = [{*grid.find_around(a, reach)} for reach in range(grid.columns + 1)]
        assert a in around[0]
        assert around == sorted(around, key=len)
        assert around[-1] == {*points}


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
