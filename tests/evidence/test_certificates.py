"""Certificates of pairs with many convex parts, which small random polygons rarely have."""

import json
from fractions import Fraction
from random import Random

import pytest
from tiers import mostly_long

from exactsweep import Polygon, inner_fit_polygon, sweep
from exactsweep.check import verify


def zigzag(random: Random, n: int, size: int) -> list[tuple[int, int]]:
    """Return an X-monotone polygon of about n vertices on an irregular grid, with walls."""
    xs = sorted(random.choices(range(1, size), k=n))
    low, high = xs[::2], xs[1::2]
    bottom = [(x, -random.randrange(1, size)) for x in low]
    top = [(x, random.randrange(1, size)) for x in high]
    return [(0, 0), *bottom, (size, 0), *reversed(top)]


@pytest.mark.parametrize("size", mostly_long([12, 60, 10**6], [12]))
@pytest.mark.parametrize(("n", "m"), [(8, 40), (24, 24), (40, 8)])
def test_sweeps_of_many_parts_are_proved(n: int, m: int, size: int) -> None:
    random = Random(f"{n} {m} {size}")
    proved = 0
    while proved < 2:
        try:
            s = sweep(zigzag(random, n, size), zigzag(random, m, size), direction=(1, 0))
        except ValueError:
            continue
        found = verify(json.loads(json.dumps(s.certificate())))
        assert found.proved, (s.generatrix.vertices, s.directrix.vertices, found)
        proved += 1


@pytest.mark.parametrize("is_convex", mostly_long([True, False], []))
def test_polygons_without_a_common_lattice_have_certificates(is_convex: bool) -> None:
    """A former version searched only lines at integer distances, as if all were on a lattice."""
    rng = Random(1)

    def shift() -> Fraction:
        return Fraction(1, rng.getrandbits(1000 if is_convex else 450) | 1)

    def draw() -> Polygon:
        if is_convex:
            return Polygon([(x + shift(), x and x * x + shift()) for x in range(5)])
        low, high = (
            [(x + shift(), y + rng.randrange(5) + shift()) for x in range(5)] for y in (0, 20)
        )
        return Polygon(low + high[::-1])

    s = sweep(draw(), draw())
    assert s.directrix.lattice()[0] == 1
    assert not all(type(c) is int for point in s.directrix.lattice()[1] for c in point)
    assert s.kind == ("CC" if is_convex else "MM")
    assert verify(s.certificate()).proved


def test_the_frame_of_an_inner_fit_has_integer_coordinates() -> None:
    part = [("1/3", 0), ("2", 0), ("2", "7/2")]
    fit = inner_fit_polygon([("1/2", "1/2"), ("19/2", "1/2"), ("19/2", "19/2"), (0, "17/2")], part)
    # The part is 5/3 wide and 7/2 high, in whole units 1 and 3; margins are one and two larger.
    assert fit.certificate()["proof"]["frame"] == ["-2", "-4", "12", "14"]
