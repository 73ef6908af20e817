"""Certificates of pairs with many convex parts, which small random polygons hardly ever have."""

import json
from random import Random

import pytest

from exactsweep import sweep
from exactsweep.check import verify


def zigzag(random: Random, n: int, size: int) -> list[tuple[int, int]]:
    """An X-monotone polygon of about n vertices on an irregular grid, some walls among them."""
    xs = sorted(random.choices(range(1, size), k=n))
    low, high = xs[::2], xs[1::2]
    bottom = [(x, -random.randrange(1, size)) for x in low]
    top = [(x, random.randrange(1, size)) for x in high]
    return [(0, 0), *bottom, (size, 0), *reversed(top)]


@pytest.mark.parametrize("size", [12, 60, 10**6])
@pytest.mark.parametrize(("n", "m"), [(8, 40), (24, 24), (40, 8)])
def test_sweeps_of_many_parts_are_proved(n: int, m: int, size: int) -> None:
    random = Random(f"{n} {m} {size}")
    proved = 0
    while proved < 12:
        try:
            s = sweep(zigzag(random, n, size), zigzag(random, m, size), direction=(1, 0))
        except ValueError:
            continue
        found = verify(json.loads(json.dumps(s.certificate())))
        assert found.proved, (s.generatrix.vertices, s.directrix.vertices, found)
        proved += 1
