"""Numbers of hundreds and thousands of digits: correct, and with few operations."""

import math
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from itertools import chain
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exactsweep import Polygon, PolygonError, Region, sweep
from exactsweep.check import verify
from exactsweep.geometry.canonical import CanonicalRing, canonicalize_ring, find_doubled_area
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.digits import read_ratio, write_int
from exactsweep.numbers.number import Vertex
from exactsweep.numbers.unreduced import unreduced_points

GRID = st.lists(st.tuples(st.integers(0, 4), st.integers(0, 4)), min_size=3, max_size=9)
MINUTE = Fraction(1, 10**400)


def outcome(points: list[tuple[int | Fraction, int | Fraction]]) -> CanonicalRing | str:
    try:
        return canonicalize_ring(points)
    except PolygonError as error:
        return str(error)


@given(GRID)
def test_rings_of_fractions_are_judged_as_those_of_ints(points: list[tuple[int, int]]) -> None:
    """Most have vertices on edges, where the first digits decide nothing."""
    assert outcome([(Fraction(x), Fraction(y)) for x, y in points]) == outcome([*points])


@given(GRID, st.integers(0, 10**9))
def test_equal_first_digits_need_exact_computation(
    points: list[tuple[int, int]], seed: int
) -> None:
    """Move each vertex by less than its interval; a separate lattice shows this exactly."""
    rng = Random(seed)
    moves = [(rng.randrange(-1, 2), rng.randrange(-1, 2)) for _ in points]
    moved = [(x + i * MINUTE, y + j * MINUTE) for (x, y), (i, j) in zip(points, moves, strict=True)]
    scaled = [(int(x / MINUTE), int(y / MINUTE)) for x, y in moved]
    one, other = outcome([*moved]), outcome([*scaled])
    if isinstance(one, str) or isinstance(other, str):
        assert one == other
    else:
        assert one[1:] == other[1:]


@given(st.fractions(), st.fractions())
def test_unreduced_numbers_compare_as_fractions_do(x: Fraction, y: Fraction) -> None:
    ((a, b),) = unreduced_points([(x, y)])
    ((c, _),) = unreduced_points([(x * y, x - y)])
    assert (a > b, a >= b, a < b, a <= b, a == b) == (x > y, x >= y, x < y, x <= y, x == y)
    assert (a > 0, a >= 0, a < 0, a <= 0, a == 0) == (x > 0, x >= 0, x < 0, x <= 0, x == 0)
    assert (a * b, Fraction((a - b).n, (a - b).d)) == (c, x - y)
    assert hash(a * b) == hash(c)


def long_star(n: int, digits: int) -> list[tuple[Fraction, Fraction]]:
    """A star that is monotone in no direction, with unrelated denominators."""
    rng = Random(n)
    points = []
    for k in range(n):
        radius, angle = 100 if k % 2 else 50, 2 * math.pi * k / n + 0.1
        for unit in (math.cos(angle), math.sin(angle)):
            denominator = rng.getrandbits(int(3.32 * digits)) | 1
            points.append(Fraction(int(radius * unit * 10**9) * denominator // 10**9, denominator))
    return [*zip(points[::2], points[1::2], strict=True)]


def test_orientations_of_mixed_numbers_are_correct() -> None:
    half = Fraction(1, 2)
    ring: list[Vertex] = [(0, 0), (1, 0), (0, half)]
    for spelled in (ring, ring[::-1]):
        found = canonicalize_ring(spelled)
        assert found.points == ((0, 0), (1, 0), (0, half))
        assert found.convex
    assert find_doubled_area(ring) == half
    assert type(find_doubled_area([(0, 0), (1, 0), (0, 1)])) is int


@given(st.lists(st.fractions(), max_size=40))
def test_sums_in_pairs_are_sums(terms: list[Fraction]) -> None:
    assert add_up(terms) == sum(terms, Fraction(0))
    long = [term + MINUTE**2 / (k + 1) for k, term in enumerate(terms)]
    assert add_up(long) == sum(long, Fraction(0))


def divisor_work(monkeypatch: pytest.MonkeyPatch, action: Callable[[], Fraction]) -> float:
    """The work of all gcd calls, relative to the squared length of the result."""
    work = 0
    gcd = math.gcd

    def count(a: int, b: int) -> int:
        nonlocal work
        work += a.bit_length() * b.bit_length()
        return gcd(a, b)

    monkeypatch.setattr(math, "gcd", count)
    bits = action().denominator.bit_length()
    monkeypatch.undo()
    return work / bits**2


def test_an_area_costs_as_much_as_its_reduction(monkeypatch: pytest.MonkeyPatch) -> None:
    """Formerly, an area took 8 s for 400 vertices with denominators of 500 digits, and a swept
    area 67 s for two polygons of 200 vertices."""
    points = long_star(40, 400)
    polygon = Polygon(points)
    expected = find_doubled_area(polygon.vertices) / 2
    assert polygon.area == expected > 0
    assert divisor_work(monkeypatch, lambda: polygon.area) < 2
    # The former version: everything over one denominator, reduced at the end.
    terms = [x * v - u * y for (x, y), (u, v) in zip(points, points[1:] + points[:1], strict=True)]
    over = math.prod(term.denominator for term in terms)
    total = sum(term.numerator * (over // term.denominator) for term in terms)
    assert abs(Fraction(total, over)) == 2 * expected
    assert divisor_work(monkeypatch, lambda: Fraction(total, over)) > 3


@pytest.mark.long
def test_areas_of_answers_add_up_in_time(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = Random(3)
    holes = []
    for k in range(12):
        size = Fraction(1, rng.getrandbits(1600) | 1)
        holes.append([(4 * k + 1, 1), (4 * k + 2 + size, 1), (4 * k + 1, 2 - size)])
    plate = Region([(0, 0), (50, 0), (50, 3), (0, 3)], holes)
    assert plate.area == 150 - sum((Polygon(hole).area for hole in holes), Fraction(0))
    assert divisor_work(monkeypatch, lambda: plate.area) < 3
    parabola = [(k + Fraction(1, rng.getrandbits(700) | 1), k * k) for k in range(14)]
    s = sweep(parabola, [(2 * x, 2 * y) for x, y in parabola])
    assert s.area == s.outer.area - s.inner.area
    assert verify(s.certificate()).proved


def test_holes_with_unrelated_denominators_share_no_lattice() -> None:
    """A former version multiplied all 60 denominators of 2000 bits each."""
    rng = Random(5)
    units = [Fraction(1, rng.getrandbits(2000) | 1) for _ in range(60)]
    holes = [[(3 * k, 1), (3 * k + 1 + e, 1), (3 * k, 2 - e)] for k, e in enumerate(units)]
    plate = Region([(-1, 0), (200, 0), (200, 3), (-1, 3)], holes)
    scale, rings = plate.lattice()
    assert scale == 1
    assert (
        max(n.bit_length() for p in chain(*rings) for c in p for n in c.as_integer_ratio()) < 2100
    )
    with pytest.raises(PolygonError, match=r"hole 60, edge \d.* cross"):
        Region(plate.exterior, [*holes, [(units[1], units[2]), (1, units[2]), (units[0], 2)]])


@pytest.mark.parametrize("digits", [1, 639, 640, 641, 4299, 4300, 4301, 40_000])
@pytest.mark.parametrize("sign", ["", "-"])
def test_digits_round_trip(digits: int, sign: str) -> None:
    rng = Random(digits)
    for text in ("9" * digits, "1" + "0" * (digits - 1), str(rng.getrandbits(64)) * (digits // 19)):
        if text:
            value = int(Decimal(sign + text))
            assert read_ratio(sign + text) == (value, 1)
            assert write_int(value) == sign + text
    assert read_ratio("0") == read_ratio("-0") == (0, 1)
    assert write_int(0) == "0"
