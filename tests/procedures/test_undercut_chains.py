"""Undercuts below walls, at points and over steps: known answers."""

import pytest

from exactsweep.numbers.number import Vertex
from exactsweep.procedures.undercuts import UndercutChains, find_undercuts, keep_corners

Chain = list[Vertex]


def under_lid(chain: Chain) -> Chain:
    """Return the region between a chain and a lid above it, as a loop."""
    return keep_corners([*chain, (chain[-1][0] + 1, 10**6), (chain[0][0] - 1, 10**6)])


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
def test_known_undercuts_of_chains(
    sign: int, inner: Chain, directrix: Chain, expected: list[tuple[Chain, Chain]]
) -> None:
    def turn(chain: Chain) -> Chain:
        return [(sign * x, y) for x, y in chain][::sign]

    found = find_undercuts(under_lid(turn(inner)), under_lid(turn(directrix)))
    assert found == [UndercutChains(turn(bottom), turn(top)) for bottom, top in expected][::sign]
