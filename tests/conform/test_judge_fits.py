"""Answered exact fits: each way to be right or wrong, by hand."""

from fractions import Fraction
from typing import Any

import pytest

from exactsweep.check import classify
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
BUT = "equivalent except for exact fits"
FALSE = "false exact fits"


@pytest.mark.parametrize(
    ("fits", "verdict", "kind"),
    [
        ([[[1, 1], [1, 3]]], "exact", ""),
        ([[[1, 1], [1, 3]], [[1, 3], [1, 1]]], "equivalent", "given twice or in pieces"),
        ([[[1, 1], [1, 2]], [[1, 2], [1, 3]]], "equivalent", "given twice or in pieces"),
        ([], BUT, "missing"),
        ([[[1, 2], [1, 3]]], BUT, "too short"),
        ([[[1, 1], [1, 7]]], FALSE, "too long"),
        ([[[1, 0], [1, 3]]], "unsound", "too long"),
        ([[[1, 1], [1, 3]], [[9, 9], [9, 8]]], FALSE, "invented"),
        ([[[1, 1], [1, 3]], [[0, 3], [-1, 3]]], FALSE, "invented"),
        ([[[1, 1], [1, 3]], [[9, 9], [9, 9]]], FALSE, "invented"),
        ([[[1, 1], [1, 3]], [[0, 0], [1, 0]]], "unsound", "invented"),
        ([[[1, 1], [1, 3]], [[1, 1], [1, 3]], [[9, 9], [9, 8]]], FALSE, "invented, given twice"),
        ([[[1.0000000001, 1.0], [1.0, 3.0]]], BUT, "rounded"),
        ([[[1.001, 1.0], [1.0, 3.0]]], "unsound", "missing, invented"),
        ([[[0, 1], [2, 1]]], "unsound", "missing, invented"),
        ([[[-2, 0], [-2, 1]]], FALSE, "missing, invented"),
        ([[[1, 3]]], "malformed", ""),
        ([[1, 3]], "malformed", ""),
    ],
)
def test_a_fit_is_judged_by_itself(fits: Any, verdict: str, kind: str) -> None:
    (part,) = compare(FIT, {"exact_fits": fits}).parts
    assert (part.verdict, part.kind) == (verdict, kind)
    if part.verdict is Verdict.UNSOUND:
        assert part.unsound is not None
        assert part.unsound.translation is not None
        assert classify(BLOCK, WIDE, part.unsound.translation).verdict == "OVERLAP"


@pytest.mark.parametrize("to", [float, round])
def test_fits_that_are_rounded_are_no_worse_than_none(to: Any) -> None:
    loop = [[to(x), to(y)] for x, y in THIRDS.trajectory.vertices]
    fits = [[[to(p.x), to(p.y)], [to(q.x), to(q.y)]] for p, q in THIRDS.exact_fits]
    answered, left_out = (
        compare(THIRDS, {"trajectory": loop, "exact_fits": given}) for given in (fits, [])
    )
    assert answered.parts[1].kind == "rounded"
    assert answered.verdict == left_out.verdict == Verdict.WITHIN


def test_a_fit_may_be_traced_as_a_whisker_of_the_loop() -> None:
    loop: list[list[Any]] = [list(p) for p in FIT.trajectory.vertices]
    for k in range(len(loop)):
        (ax, ay), (bx, by) = loop[k - 1], loop[k]
        if ay == by == 3 and min(ax, bx) < 1 < max(ax, bx):
            traced = [*loop[:k], [1, 3], [1, 1], [1, 3], *loop[k:]]
    trajectory, fits = compare(FIT, {"trajectory": traced}).parts
    assert (trajectory.verdict, trajectory.kind) == ("equivalent", "whisker")
    assert (fits.verdict, fits.kind) == ("equivalent", "whisker")
    floats = [[float(x) + 1e-12 * (x == 4), float(y)] for x, y in traced]
    assert compare(FIT, {"trajectory": floats}).parts[0].verdict is Verdict.WITHIN
    # A spike that is on no fit stays a spike.
    deeper = [[x, 0 if (x, y) == (1, 1) else y] for x, y in traced]
    assert compare(FIT, {"trajectory": deeper}).parts[0].verdict is Verdict.MALFORMED
