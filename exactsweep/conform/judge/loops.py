"""One loop of an answer, all of its rings, beside the rings of the exact one."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations

from exactsweep.conform.judge.answer import AnsweredLoop, AnswerError
from exactsweep.conform.judge.arithmetic import name_arithmetic
from exactsweep.conform.judge.diagnosis import diagnose
from exactsweep.conform.judge.frechet import match_rings
from exactsweep.conform.judge.hausdorff import bound_distance
from exactsweep.conform.judge.region import (
    RegionError,
    Trapezoid,
    add_areas,
    find_differences,
    find_overlap,
)
from exactsweep.conform.judge.verdict import PartComparison, Verdict
from exactsweep.conform.judge.whiskers import strip_whiskers, trace_whiskers
from exactsweep.conform.judge.witness import LOOP_NAMES, find_witness, list_exact_rings
from exactsweep.corpus import Case
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.point import Loop, Point

_POSITIONS = ("trajectory", "no_fit")
"""Loops on which exact fits of G around D may hang."""
MOST_MEASURED = 3000
"""Of loops with more edges, exact and theirs together, neither area nor distance is measured."""
_MOST_SHOWN = 100
"""Of these, so many places are enough to choose a witness from."""
MOST_RINGS = 200
"""More rings than that are not looked at: each has to be held against each other one."""


def judge_loop(case: Case, name: str, loop: AnsweredLoop, rounding: Fraction) -> PartComparison:
    """Hold an answered loop against the exact one.

    Args:
        case: the case.
        name: a key of LOOP_NAMES.
        loop: what was answered.
        rounding: by how much less a coordinate may be off.

    Returns:
        A PartComparison; `Verdict` says what its verdict means. All rings count, and each of them
        on its own: a broken one is not made good by others.

    Raises:
        WitnessError: the expected answer of the case is refuted by the definition.

    Cost: linear for an exact answer; otherwise that of `find_differences`, `bound_distance`,
        `match_rings` and `diagnose`, all of which are bounded by counts, and of a witness. What is
        too large to be compared so is undecided.
    """
    exact = list_exact_rings(case, name)
    if _are_rotations(loop.rings, exact):
        return _same(name, Verdict.EXACT)
    try:
        fault = find_fault(loop.rings, f"$.{name}")
    except RegionError as error:
        return PartComparison(name, Verdict.UNDECIDED, str(error))
    if fault is None and _canonical(loop.rings) == sorted(exact):
        return _same(name, Verdict.EQUIVALENT)
    if name in _POSITIONS and fault is not None:
        rings, whiskers = strip_whiskers(loop.rings, case.exact_fits)
        if whiskers and find_fault(rings, "") is None and _canonical(rings) == sorted(exact):
            reason = "exact fits are traced as whiskers of the loop"
            return _same(name, Verdict.EQUIVALENT, reason, "whisker")
    return _measure(case, name, loop.rings, exact, fault, rounding)


def find_fault(rings: Sequence[Loop], place: str) -> str | None:
    """Say what is wrong with some rings by themselves, or return None; raises RegionError."""
    polygons: list[Polygon] = []
    try:
        for k, ring in enumerate(rings):
            polygons.append(_polygon(ring, place if len(rings) == 1 else f"{place}[{k}]"))
        _require_apart(polygons, place)
    except AnswerError as error:
        return str(error)
    return None


def _measure(
    case: Case,
    name: str,
    rings: Sequence[Loop],
    exact: Sequence[Loop],
    fault: str | None,
    rounding: Fraction,
) -> PartComparison:
    """Compare a loop that is not the exact one, ring for ring."""
    kind = ""
    diagnosis: tuple[str, ...] = ()
    rounded = match_rings(exact, rings, rounding)
    if not rounded and name in _POSITIONS and case.exact_fits:
        rounded = match_rings(trace_whiskers(exact, case.exact_fits), rings, rounding)
        kind = "whisker" if rounded else ""
    is_small = sum(map(len, exact)) + sum(map(len, rings)) <= MOST_MEASURED
    lost: list[Trapezoid] = []
    extra: list[Trapezoid] = []
    is_whole = False
    if is_small or not (rounded or fault):
        lost, extra, is_whole = _find_cells(exact, rings, is_small)
    if fault is None and is_whole and not lost and not extra:
        return _same(name, Verdict.EQUIVALENT)
    if rounded:
        whiskers = ", exact fits traced as whiskers of the loop" if kind else ""
        verdict, reason = Verdict.WITHIN, f"rounded{whiskers}"
    else:
        # Other mistakes than those of numbers make sound rings of sound ones.
        diagnosis = (
            name_arithmetic(exact, rings) if fault else diagnose(case, name, rings, rounding)
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
        kind,
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
        if lost or extra:
            return Verdict.WRONG, f"not the exact {loop_name}, and {rest}"
        return Verdict.UNDECIDED, rest
    reason = (
        f"part of the exact {loop_name} is missing" if lost else f"more than the exact {loop_name}"
    )
    permits_overlap = bool(lost) != (name == "inner_fit")
    return Verdict.UNSOUND if permits_overlap else Verdict.CONSERVATIVE, reason


def _same(name: str, verdict: Verdict, reason: str = "", kind: str = "") -> PartComparison:
    zero = Fraction(0)
    return PartComparison(name, verdict, reason, (zero, zero), zero, zero, kind=kind)


def _are_rotations(rings: Sequence[Loop], exact: Sequence[Loop]) -> bool:
    """Whether rings are the exact ones, the first one counter-clockwise, from any vertex on."""
    if len(rings) != len(exact):
        return False
    if not exact:
        return True
    if not _is_rotation(rings[0], exact[0]):
        return False
    left = list(exact[1:])
    for ring in rings[1:]:
        # Holes are written in either orientation.
        same = [other for other in left if _is_rotation(ring, other)]
        same += [other for other in left if _is_rotation(ring[::-1], other)]
        if not same:
            return False
        left.remove(same[0])
    return True


def _is_rotation(ring: Loop, vertices: Loop) -> bool:
    if len(ring) != len(vertices):
        return False
    if ring == vertices:
        return True
    try:
        start = ring.index(vertices[0])
    except ValueError:
        return False
    return ring[start:] + ring[:start] == vertices


def _canonical(rings: Sequence[Loop]) -> list[Loop]:
    return sorted(Polygon(ring).vertices for ring in rings)


def _polygon(ring: Loop, place: str) -> Polygon:
    try:
        return Polygon(ring)
    except PolygonError as error:
        raise AnswerError(f"{place}: {error}") from None


def _require_apart(polygons: Sequence[Polygon], place: str) -> None:
    """Refuse rings that overlap, unless one is inside the other, with other points between."""
    if len(polygons) > MOST_RINGS:
        raise AnswerError(f"{place} has more than {MOST_RINGS} rings")
    boxes = [polygon.bounding_box for polygon in polygons]
    if any(_boxes_meet(*one, *other) for one, other in combinations(boxes, 2)):
        overlap = find_overlap([polygon.vertices for polygon in polygons])
        if overlap is not None:
            raise AnswerError(f"{place}: rings {overlap[0]} and {overlap[1]} overlap")


def _boxes_meet(low: Point, high: Point, other_low: Point, other_high: Point) -> bool:
    return (
        low.x < other_high.x
        and other_low.x < high.x
        and low.y < other_high.y
        and other_low.y < high.y
    )
