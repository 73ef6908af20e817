"""Exact fits as answered, beside the exact ones."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise

from exactsweep.conform.verdict import PartComparison, Verdict, Witness
from exactsweep.conform.witness import at_position, crossing_of, minus
from exactsweep.corpus import Case
from exactsweep.polygon import Point
from exactsweep.words import count

Segment = tuple[Point, Point]


def compare_fits(case: Case, theirs: Sequence[Segment]) -> PartComparison:
    """Compare exact fits.

    Args:
        case: the case.
        theirs: segments of positions of the reference point, in any order and direction.

    Returns:
        The part "exact_fits": exact; unsound, with a position that overlaps; or "equivalent but
        for exact fits", with a position on a fit that is missing or in another way answered.

    Cost: O(f t) for f segments and t edges of the trajectory, times that of `classify`.
    """
    exact, answered = ({frozenset(fit) for fit in fits} for fits in (case.exact_fits, theirs))
    if exact == answered:
        return PartComparison("exact_fits", Verdict.EXACT)
    missing = [fit for fit in case.exact_fits if frozenset(fit) not in answered]
    invented = [fit for fit in theirs if frozenset(fit) not in exact]
    for fit in invented:
        for position in _places(case, fit):
            found = at_position(case, position)
            if found.classified == "OVERLAP":
                says = f"{found.says}; that is on an exact fit of theirs"
                return PartComparison(
                    "exact_fits",
                    Verdict.UNSOUND,
                    "an exact fit of theirs overlaps",
                    unsound=Witness(says, found.translation, "OVERLAP", found.point),
                )
    reasons = [
        f"{count(len(fits), 'exact fit')} {what}"
        for fits, what in ((missing, "missing"), (invented, "that are none of these"))
        if fits
    ]
    return PartComparison(
        "exact_fits",
        Verdict.EQUIVALENT_BUT_FOR_EXACT_FITS,
        ", ".join(reasons),
        conservative=_missed(case, missing[0]) if missing else None,
    )


def _missed(case: Case, fit: Segment) -> Witness:
    (p, q) = fit
    found = at_position(case, Point((p.x + q.x) / 2, (p.y + q.y) / 2))
    says = f"{found.says}; that is on an exact fit which is not among theirs"
    return Witness(says, found.translation, found.classified, found.point)


def _places(case: Case, segment: Segment) -> Iterator[Point]:
    """Positions on a segment, one of each piece that is all overlap or all free of it.

    Such pieces end on the trajectory or at the end of an exact fit.
    """
    p, q = segment
    d = minus(q, p)
    square = d.x * d.x + d.y * d.y
    yield from (p, q) if square else (p,)
    if not square:
        return
    loop = case.trajectory.vertices
    ends = [loop[k] for k in range(len(loop))]
    ends += [end for fit in case.exact_fits for end in fit]
    crossings = [crossing_of(p, q, loop[k - 1], b) for k, b in enumerate(loop)]
    on_line = [v for v in ends if d.x * (v.y - p.y) == d.y * (v.x - p.x)]
    shares = {Fraction(0), Fraction(1)}
    for v in [*(c for c in crossings if c is not None), *on_line]:
        share = (d.x * (v.x - p.x) + d.y * (v.y - p.y)) / square
        if 0 < share < 1:
            shares.add(share)
    for a, b in pairwise(sorted(shares)):
        middle = (a + b) / 2
        yield Point(p.x + middle * d.x, p.y + middle * d.y)
