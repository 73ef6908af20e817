"""An answer held against the exact one."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise

from exactsweep.check import classify
from exactsweep.conform.judge.answer import (
    LOOPS,
    AnswerError,
    Loop,
    Ring,
    name_kind,
    read_loop,
    read_number,
    read_segments,
)
from exactsweep.conform.judge.frechet import walk_together
from exactsweep.conform.judge.hausdorff import distance_squared
from exactsweep.conform.judge.region import RegionError, area, differences
from exactsweep.conform.judge.verdict import Comparison, PartComparison, Verdict, Witness
from exactsweep.conform.judge.witness import LOOP_NAMES, at_position, crossing_of, minus, witness
from exactsweep.corpus import Case
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.number import quoted
from exactsweep.geometry.point import ORIGIN, Point
from exactsweep.geometry.polygon import Polygon
from exactsweep.words import count

FLOAT_ROUNDING = Fraction(1, 2**32)
"""The rounding allowed to floats, in parts of the largest coordinate."""
LEAST_ROUNDING = Fraction(2, 2**1074)
"""Twice the least positive binary64: no less is allowed to floats."""


Segment = tuple[Point, Point]


def compare(
    case: Case,
    result: object,
    *,
    rounding: Fraction | None = None,
    promised: Collection[str] = (),
) -> Comparison:
    """Compare an answer with the exact one of its case.

    Args:
        case: the case.
        result: the answer, plain data: a mapping with any of "trajectory", "inner" and "outer",
            each a loop as `read_loop` takes it, and "exact_fits", a list of pairs of points. It
            may have the "id" of the case, and in "rounding" by how much a coordinate may be off.
        rounding: the same, before what the answer says; `Verdict` says what it is otherwise.
        promised: names of loops that must be there.

    Returns:
        A Comparison; `Verdict` defines the verdicts. Parts that are neither there nor promised are
        left out, and an answer without any part is unsupported. Exact fits are a part where they
        are answered, and where a trajectory is: without any, that answers that there are none.

    Raises:
        AnswerError: the answer has the id of another case.
        WitnessError: the expected answer of the case is refuted by the definition.

    Cost: linear for an exact answer; otherwise that of `differences`, `distance_squared` and
        `walk_together`, and of a witness.

    Example:
        >>> case = Case.of("a", "", [(0, 0), (2, 0), (1, 2)], [(0, 0), (1, 0), (1, 1), (0, 1)])
        >>> answer = [[-1, -1], [2, -1], [2, 0], [1, 2], [0, 2], [-1, 0.25]]
        >>> part = compare(case, {"trajectory": answer}).parts[0]
        >>> part.verdict.value, str(part.area), part.distance_squared
        ('conservative', '1/8', (Fraction(1, 80), Fraction(1, 80)))
        >>> part.conservative.says
        'at (-1/2,13/12) G does not touch D; that is inside their trajectory'
    """
    if not isinstance(result, Mapping):
        return Comparison(
            case.id, Verdict.MALFORMED, f"the answer is {name_kind(result)}, not an object"
        )
    if "id" in result and result["id"] != case.id:
        raise AnswerError(f"the answer is that of {quoted(result['id'])}, not of {case.id!r}")
    parts = []
    try:
        if rounding is None and "rounding" in result:
            rounding = abs(read_number(result["rounding"], "$.rounding"))
    except AnswerError as error:
        return Comparison(case.id, Verdict.MALFORMED, str(error))
    for name in LOOPS:
        if name in result:
            parts.append(_compare_loop(case, name, result[name], rounding))
        elif name in promised:
            parts.append(PartComparison(name, Verdict.MALFORMED, f"$.{name} is missing"))
    if "exact_fits" in result or "trajectory" in result:
        parts.append(_compare_fits(case, result.get("exact_fits", [])))
    if not parts:
        return Comparison(case.id, Verdict.UNSUPPORTED, "the answer has no loops")
    worst = max(parts, key=lambda part: part.verdict.severity)
    return Comparison(case.id, worst.verdict, worst.reason, tuple(parts))


def _compare_fits(case: Case, value: object) -> PartComparison:
    try:
        return compare_fits(case, read_segments(value, "$.exact_fits"))
    except AnswerError as error:
        return PartComparison("exact_fits", Verdict.MALFORMED, str(error))


def _compare_loop(
    case: Case, name: str, value: object, rounding: Fraction | None
) -> PartComparison:
    try:
        loop = read_loop(value, f"$.{name}")
    except AnswerError as error:
        return PartComparison(name, Verdict.MALFORMED, str(error))
    exact: Polygon = getattr(case, name)
    if len(loop.rings) == 1 and _is_rotation(loop.rings[0], exact.vertices):
        return _same(name, Verdict.EXACT)
    polygons: list[Polygon] = []
    fault = None
    try:
        for k, ring in enumerate(loop.rings):
            place = f"$.{name}" if len(loop.rings) == 1 else f"$.{name}[{k}]"
            polygons.append(_polygon(ring, place))
        _require_apart(polygons, f"$.{name}")
    except AnswerError as error:
        fault = str(error)
    if polygons == [exact]:
        return _same(name, Verdict.EQUIVALENT)
    return _measured(case, name, loop, polygons, fault, rounding)


def _measured(
    case: Case,
    name: str,
    loop: Loop,
    polygons: Sequence[Polygon],
    fault: str | None,
    rounding: Fraction | None,
) -> PartComparison:
    """Compare a loop that is not the exact one, ring for ring."""
    exact: Polygon = getattr(case, name)
    try:
        cells = list(differences([exact.vertices], loop.rings))
    except RegionError as error:
        return PartComparison(name, Verdict.MALFORMED, fault or f"$.{name}: {error}")
    lost, extra = ([c for c in cells if c.first is first] for first in (True, False))
    if fault is None and not cells:
        return _same(name, Verdict.EQUIVALENT)
    if fault is not None:
        verdict, reason = Verdict.MALFORMED, fault
    elif len(polygons) == 1 and walk_together(
        exact.vertices,
        polygons[0].vertices,
        _rounding(loop, exact) if rounding is None else rounding,
    ):
        verdict, reason = Verdict.WITHIN, "rounded"
    elif lost and extra:
        verdict, reason = (
            Verdict.WRONG,
            f"neither holds the exact {LOOP_NAMES[name]} nor is held by it",
        )
    elif lost:
        verdict, reason = Verdict.UNSOUND, f"part of the exact {LOOP_NAMES[name]} is missing"
    else:
        verdict, reason = Verdict.CONSERVATIVE, f"more than the exact {LOOP_NAMES[name]}"
    return PartComparison(
        name,
        verdict,
        reason,
        distance_squared([exact.vertices], loop.rings),
        area(lost),
        area(extra),
        witness(case, name, loop.rings, lost) if lost else None,
        witness(case, name, loop.rings, extra) if extra else None,
    )


def _same(name: str, verdict: Verdict) -> PartComparison:
    zero = Fraction(0)
    return PartComparison(name, verdict, "", (zero, zero), zero, zero)


def _rounding(loop: Loop, exact: Polygon) -> Fraction:
    if loop.has_floats:
        largest = max(abs(c) for vertex in exact.vertices for c in vertex)
        return max(FLOAT_ROUNDING * largest, LEAST_ROUNDING)
    whole = all(c.denominator == 1 for vertex in exact.vertices for c in vertex)
    return Fraction(1 if loop.is_integer and not whole else 0)


def _is_rotation(ring: Ring, vertices: Ring) -> bool:
    if len(ring) != len(vertices):
        return False
    if ring == vertices:
        return True
    try:
        start = ring.index(vertices[0])
    except ValueError:
        return False
    return ring[start:] + ring[:start] == vertices


def _polygon(ring: Ring, place: str) -> Polygon:
    try:
        return Polygon(ring)
    except PolygonError as error:
        raise AnswerError(f"{place}: {error}") from None


def _require_apart(polygons: Sequence[Polygon], place: str) -> None:
    """Refuse rings that overlap, unless one is inside the other, with other points between."""
    for k, one in enumerate(polygons):
        for j, other in enumerate(polygons[:k]):
            if classify(one, other, ORIGIN).verdict != "OVERLAP":
                continue
            sides = {cell.first for cell in differences([one.vertices], [other.vertices])}
            if len(sides) != 1:
                raise AnswerError(f"{place}: rings {j} and {k} overlap")


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
