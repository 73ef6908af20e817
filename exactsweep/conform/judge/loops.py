"""One loop of an answer, all of its rings, beside the rings of the exact one."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.conform.judge.answer import AnsweredLoop, AnswerError
from exactsweep.conform.judge.boundary import (
    are_bridges,
    find_boundary,
    subtract_fits,
    trace_rings,
)
from exactsweep.conform.judge.diagnosis import diagnose
from exactsweep.conform.judge.fits import FITS_OF, find_rounded_fit, list_exact_fits, trace_whiskers
from exactsweep.conform.judge.frechet import match_rings
from exactsweep.conform.judge.hausdorff import bound_distance
from exactsweep.conform.judge.region import (
    RegionError,
    Trapezoid,
    add_areas,
    find_differences,
    find_overlap,
)
from exactsweep.conform.judge.rounding import name_arithmetic
from exactsweep.conform.judge.verdict import PartComparison, Verdict
from exactsweep.conform.judge.witness import LOOP_NAMES, find_witness, list_exact_rings
from exactsweep.corpus import Case
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.point import Fit, Loop

MOST_MEASURED = 3000
"""Of loops with more edges, exact and theirs together, neither area nor distance is measured."""
_MOST_SHOWN = 100
"""Of these, so many places are enough to choose a witness from."""


class JudgedLoop(NamedTuple):
    """The judgement of one loop.

    Attributes:
        part: the comparison.
        traced: segments of positions that its rings go along and back, on exact fits.
    """

    part: PartComparison
    traced: Sequence[Fit] = ()


class _Writing(NamedTuple):
    """The region of some rings, and how it is written.

    Attributes:
        rings: as answered; or of the region alone, nothing doubled, if these are faulty.
        traced: segments on exact fits that rings go along and back.
        fault: why the rings determine no region, or None.
    """

    rings: Sequence[Loop]
    traced: Sequence[Fit]
    fault: str | None


def judge_loop(case: Case, name: str, loop: AnsweredLoop, rounding: Fraction) -> JudgedLoop:
    """Compare an answered loop with the exact one.

    Args:
        case: the case.
        name: a key of LOOP_NAMES.
        loop: what was answered.
        rounding: by how much less a coordinate may be off.

    Returns:
        A JudgedLoop; `Verdict` says what its verdict means.

    Raises:
        WitnessError: the expected answer of the case is refuted by the definition.

    Cost: linear for an exact answer, O(n log n) for an equivalent one; otherwise that of
        `find_differences`, `bound_distance`, `match_rings` and `diagnose`, all of which are bounded
        by counts, and of a witness.
    """
    exact = list_exact_rings(case, name)
    if _have_same_vertices(loop.rings, exact):
        return JudgedLoop(_same(name, Verdict.EXACT))
    fits = list_exact_fits(case, FITS_OF[name]) if name in FITS_OF else ()
    boundary = find_boundary(loop.rings)
    on_fits, others = subtract_fits(boundary.doubled, fits)
    is_bridged = are_bridges(others, [*boundary.solid, *on_fits])
    if is_bridged and boundary.solid == find_boundary(exact).solid:
        kind = "whisker" if on_fits else ""
        reason = "exact fits are traced by the loop" if kind else ""
        return JudgedLoop(_same(name, Verdict.EQUIVALENT, reason, kind), on_fits)
    writing = _Writing(loop.rings, on_fits, find_fault(loop.rings, f"$.{name}"))
    if writing.fault is not None and is_bridged:
        rings = trace_rings(boundary)
        if find_fault(rings, "") is None:
            writing = _Writing(rings, on_fits, None)
    traced = _match_rounded(loop.rings, writing, exact, fits, rounding)
    return JudgedLoop(
        _measure(case, name, loop.rings, writing, exact, traced, rounding),
        writing.traced if traced is None else traced,
    )


def find_fault(rings: Sequence[Loop], place: str) -> str | None:
    """Say what is wrong with some rings by themselves, or return None."""
    try:
        for k, ring in enumerate(rings):
            _require_simple(ring, place if len(rings) == 1 else f"{place}[{k}]")
    except AnswerError as error:
        return str(error)
    try:
        overlap = find_overlap(rings) if len(rings) > 1 else None
    except RegionError:
        # They are compared with the exact ones all the same.
        return None
    return f"{place}: rings {overlap[0]} and {overlap[1]} overlap" if overlap else None


def _match_rounded(
    rings: Sequence[Loop],
    writing: _Writing,
    exact: Sequence[Loop],
    fits: Sequence[Fit],
    rounding: Fraction,
) -> Sequence[Fit] | None:
    """Return the fits that rings trace if they are the exact ones except for rounding, or None."""
    if not rounding:
        return None
    if match_rings(exact, rings, rounding):
        return []
    if fits and match_rings(trace_whiskers(exact, fits), rings, rounding):
        return fits
    is_traced = writing.fault is None and writing.rings is not rings
    plain = trace_rings(find_boundary(exact)) if is_traced else exact
    # Rings that are nowhere so far from an exact fit trace it.
    thin = [find_rounded_fit(ring, fits, rounding) for ring in writing.rings]
    rest = [ring for ring, fit in zip(writing.rings, thin, strict=True) if fit is None]
    if match_rings(plain, writing.rings, rounding):
        return writing.traced
    if match_rings(plain, rest, rounding):
        return [*writing.traced, *(fit for fit in thin if fit is not None)]
    return None


def _measure(
    case: Case,
    name: str,
    given: Sequence[Loop],
    writing: _Writing,
    exact: Sequence[Loop],
    traced: Sequence[Fit] | None,
    rounding: Fraction,
) -> PartComparison:
    """Compare a loop whose region is not the exact one."""
    rings, fault = writing.rings, writing.fault
    is_small = sum(map(len, exact)) + sum(map(len, rings)) <= MOST_MEASURED
    lost: list[Trapezoid] = []
    extra: list[Trapezoid] = []
    is_whole = False
    if is_small or (traced is None and not fault):
        lost, extra, is_whole = _find_cells(exact, rings, is_small)
    diagnosis: tuple[str, ...] = ()
    if traced is not None:
        verdict = Verdict.WITHIN
        reason = f"rounded{', exact fits traced by the loop' if traced else ''}"
    else:
        # Other mistakes than those of numbers make sound rings of sound ones.
        diagnosis = (
            name_arithmetic(exact, given) if fault else diagnose(case, name, rings, rounding)
        )
        verdict, reason = _judge_difference(name, fault, lost, extra, is_whole)
        if diagnosis:
            reason = f"{diagnosis[0]}; {reason}"
    is_measured = is_small and is_whole
    # An inner fit tells where G may be, and not where it may not.
    overlapping, free = (extra, lost) if name == "inner_fit" else (lost, extra)
    return PartComparison(
        name,
        verdict,
        reason,
        bound_distance(exact, rings) if is_measured and exact and rings else None,
        add_areas(overlapping) if is_measured else None,
        add_areas(free) if is_measured else None,
        find_witness(case, name, rings, overlapping) if overlapping else None,
        find_witness(case, name, rings, free) if free else None,
        rounding,
        "whisker" if traced else "",
        diagnosis,
    )


def _find_cells(
    exact: Sequence[Loop], rings: Sequence[Loop], is_small: bool
) -> tuple[list[Trapezoid], list[Trapezoid], bool]:
    """Find what is lost, what is extra, and whether that is all: of large loops, some of it."""
    sides: tuple[list[Trapezoid], list[Trapezoid]] = [], []
    try:
        for cell in find_differences(exact, rings):
            found = sides[not cell.first]
            if is_small or len(found) < _MOST_SHOWN:
                found.append(cell)
            if not is_small and all(sides):
                return *sides, False
    except RegionError:
        return *sides, False
    return *sides, True


def _judge_difference(
    name: str,
    fault: str | None,
    lost: Sequence[Trapezoid],
    extra: Sequence[Trapezoid],
    is_whole: bool,
) -> tuple[Verdict, str]:
    loop_name = LOOP_NAMES[name]
    if fault is not None:
        return Verdict.MALFORMED, fault
    if lost and extra:
        return Verdict.WRONG, f"neither holds the exact {loop_name} nor is held by it"
    if not is_whole:
        rest = "too many edges cross for the rest to be compared"
        return Verdict.WRONG, f"not the exact {loop_name}, and {rest}"
    reason = (
        f"part of the exact {loop_name} is missing" if lost else f"more than the exact {loop_name}"
    )
    permits_overlap = bool(lost) != (name == "inner_fit")
    return Verdict.UNSOUND if permits_overlap else Verdict.CONSERVATIVE, reason


def _same(name: str, verdict: Verdict, reason: str = "", kind: str = "") -> PartComparison:
    zero = Fraction(0)
    return PartComparison(name, verdict, reason, (zero, zero), zero, zero, kind=kind)


def _have_same_vertices(rings: Sequence[Loop], exact: Sequence[Loop]) -> bool:
    """Decide whether rings are the exact ones, from any vertex on."""
    if len(rings) != len(exact):
        return False
    if not exact:
        return True
    if _rotate(rings[0]) != _rotate(exact[0]):
        return False
    # Holes are written in either orientation.
    return sorted(map(_orient, rings[1:])) == sorted(map(_orient, exact[1:]))


def _rotate(ring: Loop) -> Loop:
    least = ring.index(min(ring))
    return ring[least:] + ring[:least]


def _orient(ring: Loop) -> Loop:
    return min(_rotate(ring), _rotate(ring[::-1]))


def _require_simple(ring: Loop, place: str) -> None:
    try:
        Polygon(ring)
    except PolygonError as error:
        raise AnswerError(f"{place}: {error}") from None
