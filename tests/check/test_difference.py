"""The segments of claimed and true answers that contain a point."""

from fractions import Fraction
from typing import Any

import pytest

from exactsweep import Point
from exactsweep.check.certificate import CertificateError
from exactsweep.check.cover import find_middle
from exactsweep.check.difference import LoopOrFit, compare
from exactsweep.check.size import UNLIMITED, Budget

LINES = [((0, 0), (4, 2)), ((3, -1), (3, 5)), ((-2, 2), (5, 2))]
SHARES = [-1, Fraction(-1, 2), 0, Fraction(1, 3), 1, Fraction(3, 2)]


def fit(*ends: Any) -> LoopOrFit:
    return LoopOrFit("exact_fits", "exact_fits[0]", tuple(Point(*p) for p in ends), False)


@pytest.mark.parametrize("aside", [0, Fraction(1, 10**9)])
@pytest.mark.parametrize("share", SHARES)
@pytest.mark.parametrize("line", LINES)
def test_a_single_position_is_on_a_segment_or_is_not(line: Any, share: Any, aside: Any) -> None:
    a, b = ([Fraction(c) for c in p] for p in line)
    p = [c + share * (d - c) + aside * k for k, (c, d) in enumerate(zip(a, b, strict=True), 1)]
    true = [fit(a, b), fit((9, 9), (9, 12))]
    with pytest.raises(CertificateError) as caught:
        compare([fit(p, p)], true, lambda t: "somewhere else", UNLIMITED)
    is_on = 0 <= share <= 1 and aside == 0
    reason = "on the boundary, but not one" if is_on else "at the witness somewhere else"
    if is_on:  # though the segments themselves are not claimed
        reason = "one is missing, or a part of it"
    assert reason in caught.value.args[0]


@pytest.mark.parametrize("line", LINES)
def test_a_single_position_on_a_segment_is_not_one_of_the_fits(line: Any) -> None:
    a, b = ([Fraction(c) for c in p] for p in line)
    middle = [(c + d) / 2 for c, d in zip(a, b, strict=True)]
    with pytest.raises(
        CertificateError, match="on the boundary, but not one of exact_fits"
    ) as found:
        compare([fit(a, b), fit(middle, middle)], [fit(a, b)], str, UNLIMITED)
    assert found.value.witness == Point(*middle)
    with pytest.raises(
        CertificateError, match="on the boundary, but not one of exact_fits"
    ) as found:
        compare([fit(a, b), fit(a, middle)], [fit(a, b)], str, UNLIMITED)
    assert found.value.witness == Point(*((c + d) / 2 for c, d in zip(a, middle, strict=True)))


@pytest.mark.parametrize(
    ("extent", "line", "middle"),
    [((2, 6), (2, 0, -6), (3, 4)), ((1, 2), (1, 2, -4), (Fraction(3, 2), Fraction(5, 4)))],
)
def test_the_middle_of_an_extent_is_on_its_line(extent: Any, line: Any, middle: Any) -> None:
    x, y, w = find_middle(extent, line)
    assert (Fraction(x, w), Fraction(y, w)) == middle


def part(is_loop: bool, *points: Any) -> LoopOrFit:
    name = "exterior" if is_loop else "exact_fits"
    return LoopOrFit(name, name, tuple(Point(Fraction(x), Fraction(y)) for x, y in points), is_loop)


@pytest.mark.parametrize("ends", [(0, 1), (1, 0)])
@pytest.mark.parametrize("way", [(1, 0), (0, 1), (1, 2), (-2, 1), (1, -1)])
def test_a_witness_is_half_way_to_the_next_segment(way: Any, ends: Any) -> None:
    """On a line beside the origin, claimed from 0 to 8; whichever way segments are written."""

    def put(low: Any, high: Any) -> LoopOrFit:
        along = [(low, high)[k] for k in ends]
        return part(False, *((1 + k * way[0], 5 + k * way[1]) for k in along))

    def find(*true: LoopOrFit) -> Any:
        with pytest.raises(CertificateError) as found:
            compare([put(0, 8)], true, lambda _: "nothing is", UNLIMITED)
        assert found.value.args[0] == "exact_fits: at the witness nothing is"
        assert found.value.witness is not None
        x, y = found.value.witness
        assert (x - 1) * way[1] == (y - 5) * way[0]
        return (x - 1) / way[0] if way[0] else (y - 5) / way[1]

    # From left to right, or straight up.
    assert find(put(2, 3), put(5, 6)) == (1 if way > (0, 0) else 7)
    assert find(put(0, 3), put(2, 5), put(6, 8)) == Fraction(11, 2)
    assert find(put(-3, 4), put(4, 7)) == Fraction(15, 2)
    assert find(put(0, 1), put(3, 6), put(7, 8)) == (2 if way > (0, 0) else Fraction(13, 2))
    assert find(put(9, 12)) == 4
    compare([put(0, 8)], [put(0, 8)], str, UNLIMITED)


def test_a_position_on_one_of_two_segments_of_a_line_is_on_a_segment() -> None:
    true = [part(False, (0, 0), (1, 1)), part(False, (3, 3), (5, 5))]
    for where in (0, 1, 3, 4):
        with pytest.raises(CertificateError, match="on the boundary, but not one of exact_fits"):
            compare([*true, part(False, (where, where), (where, where))], true, str, UNLIMITED)
    with pytest.raises(CertificateError, match="at the witness it is beside"):
        compare([*true, part(False, (2, 2), (2, 2))], true, lambda _: "it is beside", UNLIMITED)


def test_the_last_edge_of_a_loop_is_one_of_its_edges() -> None:
    loop = part(True, (0, 0), (4, 0), (0, 4))
    for along in ([(0, 1), (0, 3)], [(0, 4), (0, 0)], [(0, 2), (0, 2)]):
        with pytest.raises(CertificateError, match="on the boundary, but not one of exact_fits"):
            compare([loop, part(False, *along)], [loop], str, UNLIMITED)


def test_each_false_position_takes_a_step_for_each_line() -> None:
    true = [fit((0, k), (1, 2 * k)) for k in range(30)]
    false = [fit((k, 99), (k, 99)) for k in range(40)]
    budget = Budget(10**6)
    with pytest.raises(CertificateError, match="at the witness"):
        compare(false, true, str, budget)
    assert budget.left is not None
    assert 30 * 40 <= 10**6 - budget.left <= 8 * 30 * 40
