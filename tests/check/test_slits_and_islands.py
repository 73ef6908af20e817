"""Exact fits that follow each other on a line, and loops that touch, from the definition."""

from typing import Any

import pytest
from cells import grid

from exactsweep import Region
from exactsweep.check import reference_inner_fit, reference_loops, reference_no_fit
from exactsweep.paper.piecewise import LinearPiece, take_least_sum

UNIT = grid("#")


def _square(x: int, y: int, size: int) -> list[tuple[int, int]]:
    return [(x, y), (x + size, y), (x + size, y + size), (x, y + size)]


def _pairs(points: Any) -> list[Any]:
    return [(p.x, p.y) for p in points]


def test_slits_on_one_line_are_joined_where_no_loop_passes() -> None:
    """A corridor with a chamber beside it, and then another corridor across it."""
    plate = grid(
        "############",
        "#######.####",
        "####..#.####",
        "#..........#",
        "############",
    )
    found = reference_no_fit(plate, UNIT)
    assert [_pairs(hole) for hole in found.holes] == [_square(4, 1, 1)]
    assert [_pairs(fit) for fit in found.exact_fits] == [
        [(4, 1), (1, 1)],
        [(5, 1), (10, 1)],
        [(7, 1), (7, 3)],
    ]


@pytest.mark.parametrize("steps", [[(1, 1)], [(1, -1)], [(1, 1), (1, 1)], [(1, -1), (-1, -1)]])
def test_islands_that_touch_are_holes_of_their_own_sorted(steps: list[tuple[int, int]]) -> None:
    """Squares of 1 around a square of 1, at steps of (2, 2), are squares of 2 that touch."""
    x, y = 4, 6
    corners = [(x, y)]
    for dx, dy in steps:
        x, y = x + 2 * dx, y + 2 * dy
        corners.append((x, y))
    box = Region(_square(0, 0, 20), [_square(x, y, 1) for x, y in corners])
    ((exterior, holes),) = reference_inner_fit(box, UNIT).regions
    assert _pairs(exterior) == _square(0, 0, 19)
    assert [_pairs(hole) for hole in holes] == sorted(_square(x - 1, y - 1, 2) for x, y in corners)


@pytest.mark.parametrize(
    "ring", [[(0, 0), (5, 0), (5, 4), (0, 4)], [(0, 2), (2, 0), (5, 3), (3, 5)]]
)
def test_a_container_is_closed_on_all_sides(ring: list[tuple[int, int]]) -> None:
    """A part of its size is put inside at one position, and a larger one at none."""
    found = reference_inner_fit(ring, [(2 * x, 2 * y) for x, y in ring])
    assert found == ((), ())
    found = reference_inner_fit(ring, ring)
    assert found.regions == ()
    assert [_pairs(fit) for fit in found.exact_fits] == [[(0, 0)] * 2]
    ((exterior, holes),) = reference_inner_fit(ring, [(x / 2, y / 2) for x, y in ring]).regions
    assert _pairs(exterior) == [(x / 2, y / 2) for x, y in ring]
    assert holes == ()


OCTAGON = [(1, 0), (2, 0), (3, 1), (3, 2), (2, 3), (1, 3), (0, 2), (0, 1)]


@pytest.mark.parametrize("direction", [(1, -1), (0, 1), (-1, 2), (2, -1), (-1, -1)])
def test_an_octagon_is_swept_alike_in_every_direction(direction: tuple[int, int]) -> None:
    """Its least vertex is inside the lower chain for some of them, and at an end for others."""
    assert reference_loops(OCTAGON, OCTAGON, direction) == reference_loops(OCTAGON, OCTAGON)


def test_a_least_sum_is_written_in_as_few_pieces_as_it_has_lines() -> None:
    """Breakpoints of the two that leave no corner are not those of the sum."""
    level = (LinearPiece(0, 0, 1, 0),)
    assert take_least_sum(level, (LinearPiece(0, 0, 2, 0),)) == (LinearPiece(0, 0, 3, 0),)
    rising = (LinearPiece(0, 0, 1, 1), LinearPiece(1, 1, 3, 1))
    assert take_least_sum(level, rising) == (
        LinearPiece(0, 0, 1, 0),
        LinearPiece(1, 0, 2, 1),
        LinearPiece(2, 1, 4, 1),
    )
