"""An answer held against the exact one."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from fractions import Fraction

from exactsweep.conform.judge.answer import (
    LOOPS,
    AnsweredLoop,
    AnswerError,
    name_kind,
    read_loop,
    read_number,
    read_segments,
)
from exactsweep.conform.judge.fits import FITS_OF, INSIDE, NAME, judge_fits
from exactsweep.conform.judge.loops import judge_loop
from exactsweep.conform.judge.rounding import grant_rounding, limit_claim
from exactsweep.conform.judge.verdict import Comparison, PartComparison, Verdict
from exactsweep.corpus import Case
from exactsweep.numbers.arguments import tells_arguments
from exactsweep.numbers.number import quote
from exactsweep.numbers.point import Fit


@tells_arguments
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
        case: the case.
        result: the answer, plain data: a mapping with any of "trajectory", "inner", "outer",
            "no_fit" and "inner_fit", each a loop as `read_loop` takes it, an "inner_fit" perhaps
            empty; "exact_fits", a list of pairs of points, and "inner_exact_fits". It may have the
            "id" of the case, and in "rounding" a claim by how much less a coordinate may be off,
            of which `limit_claim` says how much is granted.
        rounding: the same, without limits, before what the answer says; `grant_rounding` says what
            it is otherwise.
        promised: names of loops that must be there.
        numbers: what the implementation says that it reads, as for `Hello`, or None: one that reads
            binary64 means 3.0 where it writes 3.

    Returns:
        A Comparison; `Verdict` defines the verdicts. Parts that are neither there nor promised are
        left out, as is an "inner_fit" that the case does not ask for, and an answer without any
        part is unsupported. Exact fits are a part where they are answered, and where a trajectory,
        a "no_fit" or an "inner_fit" is: without any, that answers that there are none.

    Raises:
        AnswerError: the answer has the id of another case.
        WitnessError: the expected answer of the case is refuted by the definition.

    Cost: linear for an exact answer; otherwise that of `judge_loop` and `judge_fits`.

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
        raise AnswerError(f"the answer is that of {quote(result['id'])}, not of {case.id!r}")
    claim = None
    try:
        if rounding is None and "rounding" in result:
            claim = abs(read_number(result["rounding"], "$.rounding"))
    except AnswerError as error:
        return Comparison(case.id, Verdict.MALFORMED, str(error))

    def grant(name: str, loop: AnsweredLoop) -> Fraction:
        if rounding is not None:
            return rounding
        granted = grant_rounding(case, name, loop, numbers)
        return granted if claim is None else limit_claim(case, claim, granted)

    parts = []
    whiskers: dict[str, list[Fit]] = {}
    for name in LOOPS:
        if name == "inner_fit" and case.inner_regions is None:
            continue
        if name not in result:
            if name in promised:
                parts.append(PartComparison(name, Verdict.MALFORMED, f"$.{name} is missing"))
            continue
        try:
            loop = read_loop(result[name], f"$.{name}", may_be_empty=name == "inner_fit")
        except AnswerError as error:
            parts.append(PartComparison(name, Verdict.MALFORMED, str(error)))
            continue
        part, traced = judge_loop(case, name, loop, grant(name, loop))
        if part.verdict is Verdict.WITHIN and claim is not None:
            part = replace(part, reason=f"{part.reason}, as it claims for itself")
        if name in FITS_OF:
            whiskers[FITS_OF[name]] = [*whiskers.get(FITS_OF[name], ()), *traced]
        parts.append(part)
    judged = {part.name for part in parts}
    for name, loops in ((NAME, {"trajectory", "no_fit"}), (INSIDE, {"inner_fit"})):
        if not (name == NAME and NAME in result) and not (loops & judged & result.keys()):
            continue
        try:
            fits = read_segments(result.get(name, []), f"$.{name}")
            segments = [(p, q) for p, q in fits.rings]
            on_loops = whiskers.get(name, ())
            parts.append(judge_fits(case, segments, grant(name, fits), on_loops, name))
        except AnswerError as error:
            parts.append(PartComparison(name, Verdict.MALFORMED, str(error)))
    if not parts:
        return Comparison(case.id, Verdict.UNSUPPORTED, "the answer has no loops")
    worst = max(parts, key=lambda part: part.verdict.severity)
    return Comparison(case.id, worst.verdict, worst.reason, tuple(parts))
