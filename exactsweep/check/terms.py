"""Terms for Coq: the values in a claim, and their conversion to plain numbers.

A term is an int (an integer in Coq), a Fraction (a rational), a `Nat`, a bool, a list, a tuple, a
`Record`, a `Constructor`, a `Some` or None.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import groupby
from math import lcm
from typing import Any, NamedTuple

from exactsweep.numbers.error import ExactSweepError

RationalPoint = tuple[Fraction, Fraction]
POINT = "Statements.point"
SEGMENTS = f"list ({POINT} * {POINT})"


class TheoremError(ExactSweepError):
    """A certificate whose claim the checker in Coq does not cover."""


class Nat(int):
    """A natural number, of Coq's type nat."""


class Some(NamedTuple):
    """An optional value that is present."""

    value: Any


class Record(NamedTuple):
    """Named fields, in the order of the record in Coq."""

    fields: dict[str, Any]


class Constructor(NamedTuple):
    """A constructor: its number in the driver, its Coq name, and its arguments."""

    number: int
    name: str
    arguments: tuple[Any, ...]


class CoqClaim(NamedTuple):
    """A claim for the checker in Coq.

    `statement` contains the arguments of the claim by name and type, `evidence` the others, which
    no theorem trusts.
    """

    kind: str
    statement: dict[str, tuple[str, Any]]
    evidence: dict[str, tuple[str, Any]]


def write_numbers(claim: CoqClaim) -> str:
    """Write a claim as the input of the extracted checker."""
    terms = [term for part in claim[1:] for _, term in part.values()]
    return " ".join([claim.kind, *(word for term in terms for word in _words(term))])


def _words(term: Any) -> Iterable[str]:
    if isinstance(term, Some):
        return ["1", *_words(term.value)]
    if isinstance(term, Constructor):
        return [str(term.number), *(word for value in term.arguments for word in _words(value))]
    if isinstance(term, Record):
        return [word for value in term.fields.values() for word in _words(value)]
    if isinstance(term, list):
        return [str(len(term)), *(word for value in term for word in _words(value))]
    if isinstance(term, tuple):
        return [word for value in term for word in _words(value)]
    if isinstance(term, Fraction):
        return [f"{term.numerator}/{term.denominator}"]
    return ["0" if term is None else str(int(term))]


def read_points(items: Any) -> list[RationalPoint]:
    """Read a list of points."""
    return [(Fraction(x), Fraction(y)) for x, y in items]


def read_ring(items: Any) -> list[RationalPoint]:
    """Read a ring and drop points equal to their predecessors."""
    points = read_points(items)
    return [p for k, p in enumerate(points) if p != points[k - 1]]


def read_path(items: Any) -> list[RationalPoint]:
    """Read a path and drop points equal to their predecessors."""
    return [point for point, _ in groupby(read_points(items))]


def read_fits(items: Any) -> list[tuple[RationalPoint, RationalPoint]]:
    """Read exact fits or slits: pairs of points."""
    return [(start, end) for start, end in map(read_points, items)]


def _area(ring: list[RationalPoint]) -> Fraction:
    ends = zip(ring, ring[1:] + ring[:1], strict=True)
    return sum((p[0] * q[1] - p[1] * q[0] for p, q in ends), Fraction(0))


def read_rings(shape: Any) -> list[list[RationalPoint]]:
    """Return the rings of a shape, the exterior counter-clockwise, holes clockwise."""
    rings = [read_ring(shape["exterior"]), *map(read_ring, shape.get("holes") or [])]
    return [e if (_area(e) > 0) != bool(k) else e[::-1] for k, e in enumerate(rings)]


def find_unit(*rings: Iterable[RationalPoint]) -> int:
    """Return the least common denominator of coordinates."""
    return lcm(*(n.denominator for ring in rings for p in ring for n in p))


def scale(pieces: list[list[RationalPoint]], unit: int) -> list[Any]:
    """Convert pieces to integer multiples of 1/unit."""
    return [[(int(x * unit), int(y * unit)) for x, y in ring] for ring in pieces]
