"""What is claimed and what is true: on which segments a point is."""

from fractions import Fraction
from typing import Any

import pytest

from exactsweep import Point
from exactsweep.check.certificate import CertificateError
from exactsweep.check.cover import find_middle
from exactsweep.check.difference import LoopOrFit, compare

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
        compare([fit(p, p)], true, lambda t: "somewhere else")
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
        compare([fit(a, b), fit(middle, middle)], [fit(a, b)], str)
    assert found.value.witness == Point(*middle)
    with pytest.raises(
        CertificateError, match="on the boundary, but not one of exact_fits"
    ) as found:
        compare([fit(a, b), fit(a, middle)], [fit(a, b)], str)
    assert found.value.witness == Point(*((c + d) / 2 for c, d in zip(a, middle, strict=True)))


@pytest.mark.parametrize(
    ("extent", "line", "middle"),
    [((2, 6), (2, 0, -6), (3, 4)), ((1, 2), (1, 2, -4), (Fraction(3, 2), Fraction(5, 4)))],
)
def test_the_middle_of_an_extent_is_on_its_line(extent: Any, line: Any, middle: Any) -> None:
    x, y, w = find_middle(extent, line)
    assert (Fraction(x, w), Fraction(y, w)) == middle
