"""Comparison of an answer with the exact one."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from itertools import islice
from operator import itemgetter

from exactsweep.conform.judge import region, witness
from exactsweep.conform.judge.boundary import are_bridges, find_boundary, subtract_fits, trace_rings
from exactsweep.conform.judge.closeness import describe_merge, match_rounded
from exactsweep.conform.judge.diagnosis import diagnose
from exactsweep.conform.judge.fits import judge_fits
from exactsweep.conform.judge.rounding import grant_rounding, name_arithmetic
from exactsweep.conform.judge.verdict import (
    LOOPS,
    AnsweredLoop,
    AnswerError,
    Comparison,
    PartComparison,
    Verdict,
    describe_type,
    read_loop,
    read_segments,
)
from exactsweep.corpus import Case
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.edges import EdgeIndex
from exactsweep.geometry.near import find_near
from exactsweep.geometry.overlap import Relation, contains, relate
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import common_lattice
from exactsweep.numbers.error import explain_type_errors, quote
from exactsweep.numbers.number import Fit, Loop

MAX_MEASURED = 3000  # edges of both loops for measuring area and distance
MAX_PAIRS = 20_000  # pairs of rings examined for overlap: a few seconds
JudgedLoop = tuple[PartComparison, Sequence[Fit]]  # with the exact fits that the rings trace


@explain_type_errors
def compare(
    case: Case,
    result: object,
    *,
    rounding: Fraction | None = None,
    promised: Collection[str] = (),
    numbers: str | None = None,
) -> Comparison:
    """Compare an answer with the exact one of its case.

    Args:
        case: the case that was asked.
        result: the answer as plain data: a mapping with some of `LOOPS`, as for `read_loop`;
            "exact_fits" and "inner_exact_fits", lists of pairs of points; and optionally the "id"
            of the case.
        rounding: the strict bound on coordinate errors; by default that of `grant_rounding`.
        promised: names of required loops.
        numbers: the numbers of the program, as for `Hello`, or None.

    Returns:
        A Comparison of all parts that were answered or promised. An answer without parts is
        unsupported. An answer without exact fits states that there are none.

    Raises:
        AnswerError: the answer has the id of another case.
        WitnessError: the definition refutes the expected answer of the case.

    Example:
        >>> case = Case.of("a", "", [(0, 0), (2, 0), (1, 2)], [(0, 0), (1, 0), (1, 1), (0, 1)])
        >>> answer = [[-1, -1], [2, -1], [2, 0], [1, 2], [0, 2], [-1, 0.25]]
        >>> part = compare(case, {"trajectory": answer}).parts[0]
        >>> part.verdict.value, str(part.area), part.distance_squared
        ('conservative', '1/8', Fraction(1, 80))
        >>> part.conservative.says
        'at (-1/2,13/12) G does not touch D; it is inside the answered trajectory'
    """
    if not isinstance(result, Mapping):
        return Comparison(
            case.id, Verdict.MALFORMED, f"the answer is {describe_type(result)}, not an object"
        )
    if "id" in result and result["id"] != case.id:
        raise AnswerError(f"the answer has the id {quote(result['id'])}, not {case.id!r}")

    def grant(name: str, loop: AnsweredLoop) -> Fraction:
        return grant_rounding(case, name, loop, numbers) if rounding is None else rounding

    whiskers: dict[str, list[Fit]] = {witness.NAME: [], witness.INSIDE: []}

    def judge_part(name: str) -> PartComparison:
        place = f"$.{name}"
        if name in whiskers:
            fits = read_segments(result.get(name, []), place)
            segments = [(p, q) for p, q in fits.rings]
            return judge_fits(case, segments, grant(name, fits), whiskers[name], name)
        if name not in result:
            raise AnswerError(f"{place} is missing")
        loop = read_loop(result[name], place, may_be_empty=name == "inner_fit")
        part, traced = judge_loop(case, name, loop, grant(name, loop))
        if name in witness.FITS_OF and name != witness.SUM:
            whiskers[witness.FITS_OF[name]] += traced
        return part

    parts = []
    for name in _list_parts(case, result, promised):
        try:
            parts.append(judge_part(name))
        except AnswerError as error:
            parts.append(PartComparison(name, Verdict.MALFORMED, str(error)))
    if not parts:
        return Comparison(case.id, Verdict.UNSUPPORTED, "the answer has no loops")
    worst = max(parts, key=lambda part: part.verdict.severity)
    return Comparison(case.id, worst.verdict, worst.reason, tuple(parts))


def _list_parts(
    case: Case, result: Mapping[str, object], promised: Collection[str]
) -> Iterator[str]:
    """List the parts to judge: loops first, since they may trace exact fits."""
    asked = {*result, *promised}
    if case.inner_regions is None:
        asked.discard("inner_fit")
    yield from (name for name in LOOPS if name in asked)
    answered = asked & result.keys()
    if answered & {"trajectory", "no_fit", witness.NAME}:
        yield witness.NAME
    if "inner_fit" in answered:
        yield witness.INSIDE


def judge_loop(case: Case, name: str, loop: AnsweredLoop, rounding: Fraction) -> JudgedLoop:
    exact = witness.list_exact_rings(case, name)
    if _have_same_vertices(loop.rings, exact):
        return _same(name, Verdict.EXACT), ()
    fits = (
        witness.list_exact_fits(case, name if name == witness.SUM else witness.FITS_OF[name])
        if name in witness.FITS_OF
        else ()
    )
    boundary, right = find_boundary(loop.rings), find_boundary(exact)
    on_fits, others = subtract_fits(boundary.doubled, fits)
    is_bridged = are_bridges(others, [*boundary.solid, *on_fits])
    if is_bridged and boundary.solid == right.solid:
        kind = "whisker" if on_fits else ""
        reason = "the loop traces exact fits" if kind else ""
        return _same(name, Verdict.EQUIVALENT, reason, kind), on_fits
    traced = match_rounded(boundary, right, fits, rounding)
    if traced is not None:
        plain = tuple(trace_rings(boundary))
        joint = describe_merge(exact, plain, name, rounding)
        phrases = ("rounded", "the loop traces exact fits" if traced else "", joint)
        part = replace(
            _measure(case, name, plain, None, (), rounding, is_rounded=True),
            verdict=Verdict.WITHIN,
            reason=", ".join(filter(None, phrases)),
            kind="whisker" if traced else "",
        )
        return part, traced
    rings, fault = loop.rings, find_fault(loop.rings, f"$.{name}")
    if fault is not None and is_bridged:
        plain = tuple(trace_rings(boundary))
        if find_fault(plain, "") is None:
            rings, fault = plain, None
    # Other mistakes do not make rings cross.
    diagnosis = (
        name_arithmetic(exact, loop.rings) if fault else diagnose(case, name, rings, rounding)
    )
    return _measure(case, name, rings, fault, diagnosis, rounding), on_fits


def find_fault(rings: Sequence[Loop], place: str) -> str | None:
    """Find the reason why rings are malformed, or None."""
    polygons = []
    for k, ring in enumerate(rings):
        try:
            polygons.append(Polygon(ring))
        except PolygonError as error:
            return f"{place if len(rings) == 1 else f'{place}[{k}]'}: {error}"
    _, lattice = common_lattice(polygons)
    shapes = [EdgeIndex([ring]) for ring in lattice]
    for j, k in sorted(
        islice(find_near([one.box for one in shapes]), MAX_PAIRS), key=itemgetter(1, 0)
    ):
        # Rings overlap unless one contains the other; equal rings contain each other.
        one, other = shapes[j].rings, shapes[k].rings
        if relate(shapes[j], shapes[k]) is Relation.OVERLAP and (
            contains(one, other) == contains(other, one)
        ):
            return f"{place}: rings {j} and {k} overlap"
    return None


def _measure(
    case: Case,
    name: str,
    rings: Sequence[Loop],
    fault: str | None,
    diagnosis: tuple[str, ...],
    rounding: Fraction,
    is_rounded: bool = False,
) -> PartComparison:
    exact = witness.list_exact_rings(case, name)
    is_small = sum(map(len, exact)) + sum(map(len, rings)) <= MAX_MEASURED
    cells: list[region.Trapezoid] = []
    is_whole = False
    if is_small or not (fault or is_rounded):
        with suppress(region.RegionError):
            # After an error, keep the cells found so far.
            for cell in region.find_differences(exact, rings):
                cells.append(cell)
            is_whole = True
    lost = [cell for cell in cells if cell.first]
    extra = [cell for cell in cells if not cell.first]
    verdict, reason = _judge_difference(name, fault, lost, extra, is_whole)
    if diagnosis:
        reason = f"{diagnosis[0]}; {reason}"
    is_measured = is_small and is_whole
    # An inner fit consists of free positions, other loops of overlapping ones.
    overlapping, free = (extra, lost) if name == "inner_fit" else (lost, extra)
    return PartComparison(
        name,
        verdict,
        reason,
        region.measure_distance(exact, rings) if is_measured and exact and rings else None,
        region.add_areas(overlapping) if is_measured else None,
        region.add_areas(free) if is_measured else None,
        witness.find_witness(case, name, rings, overlapping) if overlapping else None,
        witness.find_witness(case, name, rings, free) if free else None,
        rounding,
        "",
        diagnosis,
    )


def _judge_difference(
    name: str,
    fault: str | None,
    lost: Sequence[region.Trapezoid],
    extra: Sequence[region.Trapezoid],
    is_whole: bool,
) -> tuple[Verdict, str]:
    loop_name = witness.LOOP_NAMES[name]
    if fault is not None:
        return Verdict.MALFORMED, fault
    if lost and extra:
        return Verdict.WRONG, f"neither contains the exact {loop_name} nor lies inside it"
    if not is_whole:
        rest = "too many edges cross to compare the rest"
        return Verdict.WRONG, f"not the exact {loop_name}; {rest}"
    reason = (
        f"part of the exact {loop_name} is missing"
        if lost
        else f"extends beyond the exact {loop_name}"
    )
    permits_overlap = bool(lost) != (name == "inner_fit")
    return Verdict.UNSOUND if permits_overlap else Verdict.CONSERVATIVE, reason


def _same(name: str, verdict: Verdict, reason: str = "", kind: str = "") -> PartComparison:
    zero = Fraction(0)
    return PartComparison(name, verdict, reason, zero, zero, zero, kind=kind)


def _have_same_vertices(rings: Sequence[Loop], exact: Sequence[Loop]) -> bool:
    (first, holes), (right, exact_holes) = ((some[:1], some[1:]) for some in (rings, exact))
    # Holes may have either orientation.
    return [*map(_rotate, first)] == [*map(_rotate, right)] and (
        sorted(map(_orient, holes)) == sorted(map(_orient, exact_holes))
    )


def _rotate(ring: Loop) -> Loop:
    least = ring.index(min(ring))
    return ring[least:] + ring[:least]


def _orient(ring: Loop) -> Loop:
    return min(_rotate(ring), _rotate(ring[::-1]))
