"""Answered exact fits: each kind of right or wrong answer, by hand."""

from fractions import Fraction
from typing import Any

import pytest
from strategies import points

from exactsweep.conform.judge.compare import compare
from exactsweep.conform.judge.fits import _are_mergeable, _places
from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.judge.witness import NAME, at_position
from exactsweep.corpus import Case

BLOCK = [(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)]
WIDE = [(0, 0), (2, 0), (2, 1), (0, 1)]
# One fit, from (1, 3) down to (1, 1).
FIT = Case.of("fit", "", BLOCK, WIDE)
# The same, translated by a third to the right.
THIRDS = Case.of(
    "thirds", "", [(Fraction(x) + Fraction(1, 3), Fraction(y) / 3) for x, y in BLOCK], WIDE
)
FALSE = "false exact fits"


@pytest.mark.parametrize("to", [float, round])
def test_rounded_fits_rank_like_missing_ones(to: Any) -> None:
    loop = [[to(x), to(y)] for x, y in THIRDS.trajectory.vertices]
    fits = [[[to(p.x), to(p.y)], [to(q.x), to(q.y)]] for p, q in THIRDS.exact_fits]
    answered, left_out = (
        compare(THIRDS, {"trajectory": loop, "exact_fits": given}) for given in (fits, [])
    )
    assert answered.parts[1].kind == "rounded"
    assert answered.verdict == left_out.verdict == Verdict.WITHIN


def test_only_points_merge_with_the_end_of_a_segment() -> None:
    low, middle, high, aside = points((0, 0), (2, 1), (4, 2), (4, 3))
    for one, other, united in [
        ((low, middle), (middle, high), False),
        ((low, middle), (middle, middle), True),
        ((low, high), (middle, high), True),
        ((low, low), (middle, middle), False),
        ((low, middle), (aside, aside), False),
    ]:
        for a, b in ((one, other), (one[::-1], other), (one, other[::-1])):
            assert _are_mergeable(a, b) == _are_mergeable(b, a) == united


def test_a_short_overlap_on_a_long_segment_is_sampled() -> None:
    # The loop is around [-2, 4] x [-1, 3]. One segment crosses it, one cuts off a corner.
    for ends in ((-3, 0), (20, 0)), ((-16, 12), (34, -13)):
        p, q = points(*ends)
        classes = {at_position(FIT, place).classified for place in _places(FIT, (p, q), NAME)}
        assert classes == {"FREE", "OVERLAP"}
