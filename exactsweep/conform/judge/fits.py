"""Comparison of answered exact fits with the expected ones.

A fit is missing if no position is answered, and too short if some are. An answer is too long if it
extends a fit, and invented if it is on none. A fit is a whisker if the loop traces it: orbiting
programs enter an exact slot and leave it on the same path.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

from exactsweep.conform.judge import witness
from exactsweep.conform.judge.boundary import are_collinear, subtract_fits
from exactsweep.conform.judge.closeness import covers
from exactsweep.conform.judge.verdict import PartComparison, Verdict, Witness
from exactsweep.corpus import Case
from exactsweep.geometry.vectors import is_on_segment
from exactsweep.numbers.number import Fit, Point
from exactsweep.words import count


def judge_fits(
    case: Case,
    theirs: Sequence[Fit],
    rounding: Fraction = Fraction(0),
    whiskers: Sequence[Fit] = (),
    name: str = witness.NAME,
) -> PartComparison:
    """Compare answered exact fits, and those that loops trace, with the expected ones."""

    def show(position: Point, which: str) -> Witness:
        found = witness.at_position(case, position, inside=name == witness.INSIDE)
        return replace(found, says=f"{found.says}; it is on {which} exact fit")

    fits = witness.list_exact_fits(case, name)
    exact, answered = {*map(frozenset, fits)}, [*map(frozenset, theirs)]
    if set(answered) == exact and len(answered) == len(exact):
        return PartComparison(name, Verdict.EXACT)
    given = [*theirs, *whiskers]
    if not subtract_fits(given, fits)[1] and not subtract_fits(fits, given)[1]:
        kind = "whisker" if whiskers else "repeated or split"
        reason = "traced by the loop as whiskers" if whiskers else kind
        return PartComparison(name, Verdict.EQUIVALENT, reason, kind=kind)
    missing = [f for f in fits if frozenset(f) not in answered]
    others = [f for f in given if frozenset(f) not in exact]
    rounded = [f for f in missing if rounding and covers(others, [f], rounding)]
    missing = [f for f in missing if f not in rounded]
    others = [f for f in others if not (rounded and covers(rounded, [f], rounding))]
    differences = _count_differences(missing, others)
    if twice := len(answered) - len(set(answered)):
        differences["repeated"] = twice
    if rounded:
        differences["rounded"] = len(rounded)
    far = [fit for fit in others if not (rounding and covers(fits, [fit], rounding))]
    shown = [
        show(position, "an answered")
        for fit in subtract_fits(far, fits)[1]
        for position in _places(case, fit, name)
        if not any(is_on_segment(position, *known) for known in fits)
    ]
    overlap = next((found for found in shown if found.classified == "OVERLAP"), None)
    kind = ", ".join(differences)
    listed = ", ".join(f"{count(number, 'exact fit')} {how}" for how, number in differences.items())
    if overlap is not None:
        reason = f"G overlaps D at an answered exact fit: {listed}"
        return PartComparison(name, Verdict.UNSOUND, reason, unsound=overlap, kind=kind)
    if shown:
        reason = f"an answered exact fit is false: {listed}"
        verdict = Verdict.FALSE_EXACT_FITS
        return PartComparison(name, verdict, reason, conservative=shown[0], kind=kind)
    missed = (show(witness.find_middle(*fit), "a missing") for fit in missing)
    return PartComparison(
        name,
        Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS,
        listed,
        conservative=next(missed, None),
        kind=kind,
        granted=rounding if rounded else None,
    )


def _count_differences(missing: Sequence[Fit], others: Sequence[Fit]) -> dict[str, int]:
    counts = dict.fromkeys(("missing", "too short", "too long", "invented"), 0)
    touched = set()
    for other in others:
        near = [fit for fit in missing if _are_mergeable(fit, other)]
        touched.update(near)
        is_inside = any(all(is_on_segment(p, *fit) for p in other) for fit in near)
        counts["invented" if not near else "too short" if is_inside else "too long"] += 1
    counts["missing"] = len(set(missing) - touched)
    return {how: number for how, number in counts.items() if number}


def _are_mergeable(one: Fit, other: Fit) -> bool:
    """Decide whether segments are collinear and share more than an end, or one is a point."""
    low, high = max(min(one), min(other)), min(max(one), max(other))
    return are_collinear((*one, *other)) and (
        low < high or (low == high and (one[0] == one[1] or other[0] == other[1]))
    )


def _places(case: Case, segment: Fit, name: str) -> Iterator[Point]:
    """Yield the ends of a segment, and positions between its crossings with loops and fits."""
    p, q = segment
    ends = {p, q}
    rings = witness.list_exact_rings(case, "inner_fit" if name == witness.INSIDE else "no_fit")
    for ring in (*rings, *witness.list_exact_fits(case, name)):
        crossings = (witness.crossing_of(p, q, ring[k - 1], b) for k, b in enumerate(ring))
        ends |= {c for c in crossings if c} | {v for v in ring if is_on_segment(v, p, q)}
    yield from dict.fromkeys(segment)
    # Between two crossings, all positions overlap or none does.
    for a, b in pairwise(sorted(ends, reverse=q < p)):
        yield witness.find_middle(a, b)
