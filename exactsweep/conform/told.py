"""A comparison, for people to read."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal
from fractions import Fraction
from typing import Any

from exactsweep.conform.verdict import Comparison, PartComparison
from exactsweep.conform.witness import LOOP_NAMES

_APPROXIMATE = Context(prec=6, Emax=MAX_EMAX, Emin=MIN_EMIN)


def told(comparison: Comparison) -> str:
    """Say what came of a comparison.

    Args:
        comparison: a Comparison.

    Returns:
        Lines of text: the verdict; then, for each part, its verdict, how far it is off, and its
        witnesses. Distances and areas are rounded to six digits, up for distances.

    Example:
        >>> from exactsweep.conform.compare import compare
        >>> from exactsweep.corpus import Case
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> case = Case.of("a", "", square, square)
        >>> print(told(compare(case, {"trajectory": [[-1, -1], [1, -1], [1, 1]]})), end="")
        a: unsound
        trajectory: unsound, part of the exact trajectory is missing
          off by at most 1.41422, area 2
          at (0,1/2) G overlaps D; that is outside their trajectory
          translation (0,1/2): OVERLAP, point (1/4,3/4)
        exact fits: exact
    """
    lines = [f"{comparison.id}: {comparison.verdict}"]
    if not comparison.parts:
        lines[0] += f", {comparison.reason}"
    for part in comparison.parts:
        lines += _part(part)
    return "".join(f"{line}\n" for line in lines)


def _part(part: PartComparison) -> list[str]:
    name = LOOP_NAMES.get(part.name, "exact fits")
    lines = [f"{name}: {part.verdict}" + (f", {part.reason}" if part.reason else "")]
    if part.distance_squared is not None and part.area:
        distance = _root_above(part.distance_squared[1])
        lines.append(f"  off by at most {distance}, area {_about(part.area)}")
    for witness in part.witnesses:
        lines += (f"  {line}" for line in witness_lines(witness.to_json()))
    return lines


def witness_lines(witness: Mapping[str, Any]) -> list[str]:
    """Say what a witness shows, and what `classify` says of it, in full, to be tried elsewhere.

    Args:
        witness: what `Witness.to_json` gives.

    Returns:
        One line or two.
    """
    lines = [witness["says"]]
    if witness["translation"] is not None:
        point = f", point ({','.join(witness['point'])})" if witness["point"] is not None else ""
        place = ",".join(witness["translation"])
        lines.append(f"translation ({place}): {witness['classified']}{point}")
    return lines


def _about(value: Fraction) -> str:
    exact = _APPROXIMATE.divide(Decimal(value.numerator), Decimal(value.denominator))
    return f"{exact.normalize(_APPROXIMATE):g}"


def _root_above(square: Fraction) -> str:
    """The square root, rounded up."""
    above = Context(prec=6, rounding="ROUND_CEILING", Emax=MAX_EMAX, Emin=MIN_EMIN)
    quotient = Context(prec=20, rounding="ROUND_CEILING", Emax=MAX_EMAX, Emin=MIN_EMIN).divide(
        Decimal(square.numerator), Decimal(square.denominator)
    )
    # Decimal's square root rounds half-even, whatever the context says.
    root = quotient.sqrt(Context(prec=20, Emax=MAX_EMAX, Emin=MIN_EMIN))
    return f"{above.plus(root):g}"
