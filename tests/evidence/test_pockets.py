"""Pockets of the lower sweep, against what shapes of any kind have between them."""

import random

import families
import pytest

from exactsweep.numbers.number import Vertex
from exactsweep.paper.kernel import sweep_inner_mm, trajectory_mm
from exactsweep.procedures.chain import split
from exactsweep.procedures.pockets import Pocket, find_mouths, find_pockets, keep_corners

Chain = list[Vertex]


def under_lid(chain: Chain) -> Chain:
    """Return the region between a chain and a lid above it, as a loop."""
    return keep_corners([*chain, (chain[-1][0], 10**6), (chain[0][0], 10**6)])


@pytest.mark.parametrize("family", ["walled", "rectilinear", "teeth", "jagged"])
def test_pockets_are_the_undercuts_of_a_shape(family: str) -> None:
    """Between a chain and what a generatrix of the same kind leaves of it."""
    rng = random.Random(family)
    shape = getattr(families, family)
    found = 0
    for _ in range(100):
        directrix, top = keep_corners(split(shape(rng))[0]), keep_corners(split(shape(rng))[1])
        inner = sweep_inner_mm(top, directrix, trajectory_mm(top, directrix))
        mouths = find_mouths(under_lid(inner), under_lid(directrix))
        pockets = find_pockets(inner, directrix)
        assert pockets == mouths
        found += len(pockets)
    assert found > 15


@pytest.mark.parametrize("sign", [1, -1], ids=["to the right", "to the left"])
@pytest.mark.parametrize(
    ("inner", "directrix", "expected"),
    [
        pytest.param(
            [(0, 0), (2, 0), (2, 2), (4, 2)],
            [(0, 0), (0, 1), (2, 1), (2, 3), (4, 3), (4, 2)],
            [
                ([(0, 0), (2, 0), (2, 1)], [(0, 0), (0, 1), (2, 1)]),
                ([(2, 2), (4, 2)], [(2, 2), (2, 3), (4, 3), (4, 2)]),
            ],
            id="a wall between two",
        ),
        pytest.param(
            [(0, 0), (2, 0), (2, 1), (4, 1)],
            [(0, 0), (0, 1), (2, 1), (2, 3), (4, 3), (4, 1)],
            [
                ([(0, 0), (2, 0), (2, 1)], [(0, 0), (0, 1), (2, 1)]),
                ([(2, 1), (4, 1)], [(2, 1), (2, 3), (4, 3), (4, 1)]),
            ],
            id="a point between two",
        ),
        pytest.param(
            [(0, 0), (2, 0), (2, 1), (4, 1)],
            [(0, 0), (0, 2), (2, 2), (2, 3), (4, 3), (4, 1)],
            [([(0, 0), (2, 0), (2, 1), (4, 1)], [(0, 0), (0, 2), (2, 2), (2, 3), (4, 3), (4, 1)])],
            id="one that goes on over a wall of both",
        ),
        pytest.param(
            [(0, 2), (1, 2), (1, 0), (3, 0), (3, 2), (4, 2)],
            [(0, 2), (1, 2), (1, 4), (3, 4), (3, 2), (4, 2)],
            [([(1, 2), (1, 0), (3, 0), (3, 2)], [(1, 2), (1, 4), (3, 4), (3, 2)])],
            id="walls of both down and up from a contact",
        ),
    ],
)
def test_pockets_by_hand(
    sign: int, inner: Chain, directrix: Chain, expected: list[tuple[Chain, Chain]]
) -> None:
    def turn(chain: Chain) -> Chain:
        return [(sign * x, y) for x, y in chain][::sign]

    found = find_pockets(turn(inner), turn(directrix))
    assert found == [Pocket(turn(bottom), turn(top)) for bottom, top in expected][::sign]
