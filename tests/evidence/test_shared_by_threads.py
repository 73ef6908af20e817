"""Answers shared by threads: results computed twice are equal."""

import sys
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from threading import Barrier

import mpmath
import pytest

from exactsweep import Sweep, no_fit_polygon, sweep
from exactsweep.formats.curved.arc import find_pi
from exactsweep.geometry.turn import bound_half_tangent

HOOK = [(0, 0), (3, 0), (3, 3), (0, 3), (0, 2), (2, 2), (2, 1), (0, 1)]
HOUSE = [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]
BLOCK = [(0, 0), (8, 0), (8, 5), (7, 5), (3, 1), (2, 5), (0, 5)]
NOTCHED = [(0, 0), (4, 0), (4, 3), (3, 1), (2, 3), (1, 1), (0, 3)]
NAMES = ("unswept", "area", "outer", "inner", "trajectory", "undercuts", "contacts", "exact_fits")


def comb(teeth: int) -> list[tuple[int, int]]:
    """Return a comb with unswept holes between its teeth."""
    tips = [
        vertex
        for k in reversed(range(teeth))
        for vertex in (
            (4 * k + 4, 9 + k % 3),
            (4 * k + 2, 9 - k % 2),
            (4 * k + 2, 3 + k % 2),
            (4 * k, 4),
        )
    ]
    return [(0, 0), (4 * teeth, 0), *tips]


def read(s: Sweep) -> list[object]:
    return [getattr(s, name) for name in NAMES]


def test_loops_are_compared_by_value() -> None:
    """In a former version, an inner loop computed twice counted as unswept: a negative area."""
    s, again = sweep(HOOK, comb(12)), sweep(HOOK, comb(12))
    again.solution.__dict__["inner"] = [*again.solution.inner]
    assert again.unswept == s.unswept
    assert again.area == s.area > 0


PAIRS = {"CC": (HOUSE, HOUSE), "CM": (HOUSE, BLOCK), "MM": (NOTCHED, BLOCK), "SS": (HOOK, comb(6))}


@pytest.mark.parametrize("kind", PAIRS)
def test_threads_get_the_answer_of_one_thread(kind: str) -> None:
    expected = read(sweep(*PAIRS[kind]))
    together = Barrier(4)

    def join(s: Sweep) -> list[object]:
        together.wait()
        return read(s)

    with ThreadPoolExecutor(4) as pool:
        for _ in range(5):
            s = sweep(*PAIRS[kind])
            assert s.kind == kind
            assert all(found == expected for found in pool.map(join, [s] * 4))


def test_threads_may_share_polygons() -> None:
    n = no_fit_polygon(HOUSE, NOTCHED)
    with ThreadPoolExecutor(4) as pool:
        found = [*pool.map(lambda _: no_fit_polygon(n.stationary, n.orbiting).exterior, range(8))]
    assert {*found} == {n.exterior}


def test_threads_may_rotate_with_different_precisions() -> None:
    def bound(k: int) -> tuple[Fraction, ...]:
        bits = 4000 if k % 2 else 8
        return (*bound_half_tangent(Fraction(k % 89 + 1), bits), find_pi(bits))

    before, interval = mpmath.iv.prec, sys.getswitchinterval()
    expected = [*map(bound, range(300))]
    sys.setswitchinterval(1e-6)
    try:
        with ThreadPoolExecutor(4) as pool:
            assert [*pool.map(bound, range(300))] == expected
    finally:
        sys.setswitchinterval(interval)
    assert mpmath.iv.prec == before
