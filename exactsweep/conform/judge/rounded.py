"""Loops equal to the exact ones up to rounding, which may merge or split rings."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from exactsweep.conform.judge.boundary import RingBoundary, are_bridges
from exactsweep.conform.judge.closeness import (
    are_boundaries_close,
    covers,
    is_close,
    is_near,
    take_pairs,
)
from exactsweep.numbers.number import Fit, Loop, Point
from exactsweep.words import write_pair

_NUMBERS = {2: "two", 3: "three", 4: "four"}


def match_rounded(
    theirs: RingBoundary, exact: RingBoundary, fits: Sequence[Fit], rounding: Fraction
) -> list[Fit] | None:
    """Find the fits that rings trace, or None if the regions differ by more than rounding."""
    if not rounding:
        return None
    known = [*exact.solid, *fits]
    near = [line for line in theirs.doubled if covers(known, [line], rounding)]
    far = [line for line in theirs.doubled if line not in near]
    if not (
        are_bridges(far, [*theirs.solid, *near])
        and are_boundaries_close(exact, theirs, rounding, fits)
    ):
        return None
    if not fits:
        return []
    # Segments that are not close to the loop trace fits.
    lines = [line for line in (*theirs.solid, *near) if not covers(exact.solid, [line], rounding)]
    return [fit for fit in fits if covers(lines, [fit], rounding)]


def name_joint(exact: Sequence[Loop], theirs: Sequence[Loop], name: str, rounding: Fraction) -> str:
    """Describe which rings rounding merges or splits, and where; "" if none."""
    if len(exact) == len(theirs):
        return ""
    left = list[Sequence[Point]](theirs)
    missing = list(take_pairs(exact, left, rounding))
    is_joined = len(missing) > len(left)
    several, verb = (missing, "joins") if is_joined else (left, "parts")
    has_outer = name != "inner_fit" and exact[0] in missing
    what = "rings" if has_outer or name == "inner_fit" else "holes"
    for k, ring in enumerate(several):
        edges = [(other[j - 1], p) for other in several[:k] for j, p in enumerate(other)]
        place = next((p for p in ring if any(is_close(p, e, 2 * rounding) for e in edges)), None)
        if place is not None:
            corners = (p for one in exact for p in one if is_near(p, place, 2 * rounding))
            at = write_pair(next(corners, place))
            return f"the rounding {verb} {_NUMBERS.get(len(several), 'several')} {what} at {at}"
    return f"the rounding leaves {len(theirs)} of {len(exact)} rings"
