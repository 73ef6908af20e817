"""Answered exact fits: each way to be right or wrong, by hand."""

from fractions import Fraction
from typing import Any

import pytest

from exactsweep.conform.judge.compare import compare
from exactsweep.conform.judge.verdict import Verdict
from exactsweep.corpus import Case

BLOCK = [(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)]
WIDE = [(0, 0), (2, 0), (2, 1), (0, 1)]
# One fit, from (1, 3) down to (1, 1).
FIT = Case.of("fit", "", BLOCK, WIDE)
# The same, a third to the right.
THIRDS = Case.of(
    "thirds", "", [(Fraction(x) + Fraction(1, 3), Fraction(y) / 3) for x, y in BLOCK], WIDE
)
FALSE = "false exact fits"


@pytest.mark.parametrize("to", [float, round])
def test_fits_that_are_rounded_are_no_worse_than_none(to: Any) -> None:
    loop = [[to(x), to(y)] for x, y in THIRDS.trajectory.vertices]
    fits = [[[to(p.x), to(p.y)], [to(q.x), to(q.y)]] for p, q in THIRDS.exact_fits]
    answered, left_out = (
        compare(THIRDS, {"trajectory": loop, "exact_fits": given}) for given in (fits, [])
    )
    assert answered.parts[1].kind == "rounded"
    assert answered.verdict == left_out.verdict == Verdict.WITHIN
