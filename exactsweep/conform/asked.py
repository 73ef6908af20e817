"""Cases in the terms of an implementation: its reference point, its numbers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from exactsweep.conform.protocol import Hello
from exactsweep.corpus import Case
from exactsweep.polygon import ORIGIN, Point, Polygon


class UnsupportedError(ValueError):
    """A case that the numbers of an implementation do not hold."""


def asked(case: Case, hello: Hello) -> Case:
    """Return the case that is put to an implementation, with the answers that it should give.

    Args:
        case: a Case.
        hello: what the implementation said.

    Returns:
        The same pair, with the reference point that the implementation uses, and multiplied by
        `integer_scale` where its numbers need that.

    Raises:
        UnsupportedError: its numbers do not hold the case, multiplied or not.

    Cost: linear, and that of `Polygon` where it is multiplied.

    Example:
        >>> case = Case.of("a", "", [(0, 0), ("1/2", 0), (0, 1)], [(1, 1), (2, 1), (1, 2)])
        >>> whole = asked(case, Hello("mine", numbers="int32", reference="first"))
        >>> print(whole.directrix, "from", whole.trajectory.vertices[0])
        (0, 0) (1, 0) (0, 2) from Point(x=Fraction(-2, 1), y=Fraction(0, 1))
    """
    if hello.reference != "given":
        case = _referred(case, ORIGIN if hello.reference == "origin" else case.generatrix_ring[0])
    if hello.numbers == "rational":
        return case
    if hello.numbers == "binary64":
        for candidate in (case, scaled(case)):
            if "binary64" in candidate.representable:
                return candidate
    elif hello.numbers == "integer" or hello.numbers in case.representable:
        return scaled(case)
    raise UnsupportedError(f"{hello.numbers} does not hold the case")


def scaled(case: Case) -> Case:
    """Return the case multiplied by its `integer_scale`."""
    k = case.integer_scale
    if k == 1:
        return case
    return replace(
        case,
        directrix_ring=_multiplied(case.directrix_ring, k),
        generatrix_ring=_multiplied(case.generatrix_ring, k),
        reference=_times(case.reference, k),
        trajectory=Polygon(_multiplied(case.trajectory.vertices, k)),
        inner=Polygon(_multiplied(case.inner.vertices, k)),
        outer=Polygon(_multiplied(case.outer.vertices, k)),
        exact_fits=tuple((_times(p, k), _times(q, k)) for p, q in case.exact_fits),
        area=case.area * k * k,
    )


def _referred(case: Case, reference: Point) -> Case:
    """Return the case with another reference point."""
    by = Point(reference.x - case.reference.x, reference.y - case.reference.y)
    if by == ORIGIN:
        return case
    return replace(
        case,
        reference=reference,
        trajectory=case.trajectory.translated(by),
        exact_fits=tuple((_plus(p, by), _plus(q, by)) for p, q in case.exact_fits),
    )


def _multiplied(points: Iterable[Point], k: int) -> tuple[Point, ...]:
    return tuple(_times(point, k) for point in points)


def _times(point: Point, k: int) -> Point:
    return Point(point.x * k, point.y * k)


def _plus(point: Point, by: Point) -> Point:
    return Point(point.x + by.x, point.y + by.y)


def as_numbers(value: Fraction, numbers: str) -> object:
    """Return a number in the type of an implementation that is called, and not spoken to."""
    if numbers == "rational":
        return value
    return float(value) if numbers == "binary64" else int(value)
