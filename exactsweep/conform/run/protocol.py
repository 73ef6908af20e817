"""The protocol between the runner and an implementation: JSON lines, both ways.

The implementation speaks first, one line that says what it can do:

    {"hello": "my program 1.0", "loops": ["trajectory"], "numbers": "integer", "reference": "given"}

The runner sends a case a line, waits for one line of answer, and at the end sends a last line:

    {"id": "...", "class": "CM", "directrix": [["0", "0"], ...], "generatrix": [...],
     "reference": ["0", "0"]}
    {"bye": true}

An answer has the id of the case and the loops that the hello promised; or the reason why there is
none, which is the verdict unsupported or crash:

    {"id": "...", "trajectory": [["-1", "0"], ...], "exact_fits": [[["1", "3"], ["1", "1"]]]}
    {"id": "...", "unsupported": "not convex"}
    {"id": "...", "error": "division by zero"}

All numbers of a case are strings. Those of an answer are strings, decimal or fraction, or JSON
numbers: an integer is itself, any other is the nearest binary64.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, Literal, Self, cast, get_args

from exactsweep.corpus import Case
from exactsweep.formats import FormatError
from exactsweep.formats.exact_json import described, parse_certificate
from exactsweep.geometry.error import ExactSweepError
from exactsweep.geometry.number import format_fraction, quoted
from exactsweep.geometry.point import ORIGIN, Point
from exactsweep.geometry.polygon import Polygon

Numbers = Literal["rational", "integer", "int64", "int32", "binary64"]
Reference = Literal["given", "origin", "first"]

LOOPS = ("trajectory", "inner", "outer")
NUMBERS: tuple[Numbers, ...] = get_args(Numbers)
REFERENCES: tuple[Reference, ...] = get_args(Reference)
BYE = '{"bye": true}'
MAX_LINE = 4 * 2**20
"""The most bytes of one line from an implementation."""
MAX_NAME = 200


class ProtocolError(ExactSweepError):
    """A line from an implementation that is not what the protocol asks for there."""


@dataclass(frozen=True)
class Hello:
    """What an implementation says of itself.

    Attributes:
        name: its name and version, for the report.
        loops: what it answers, of "trajectory", "inner", "outer".
        numbers: what it reads. "rational": everything. "integer", "int64", "int32": cases are
            multiplied to integers, and those beyond the type are not asked. "binary64": cases
            that the type holds as they are, or else multiplied to integers.
        reference: the point of G whose path its trajectory is. "given": the case's. "origin": the
            point (0, 0) in the coordinates of G. "first": the first vertex of G. The cases it gets
            have that reference point.
    """

    name: str
    loops: tuple[str, ...] = ("trajectory",)
    numbers: Numbers = "rational"
    reference: Reference = "given"

    @classmethod
    def of(cls, name: object, loops: object, numbers: object, reference: object) -> Self:
        """Check what an implementation says of itself.

        Raises:
            ProtocolError: one of them is nothing that it may say.
        """
        if not isinstance(name, str) or not 0 < len(name) <= MAX_NAME or not name.isprintable():
            raise ProtocolError(f'"hello" is not a name of 1 to {MAX_NAME} printable characters')
        listed = list(loops) if isinstance(loops, (list, tuple)) else []
        if not listed or any(loop not in LOOPS for loop in listed):
            raise ProtocolError(
                f'"loops" is {quoted(loops)}, not a list of some of {", ".join(LOOPS)}'
            )
        for key, value, allowed in (
            ("numbers", numbers, NUMBERS),
            ("reference", reference, REFERENCES),
        ):
            if value not in allowed:
                raise ProtocolError(f'"{key}" is {quoted(value)}, not one of {", ".join(allowed)}')
        ordered = tuple(loop for loop in LOOPS if loop in listed)
        return cls(name, ordered, cast(Numbers, numbers), cast(Reference, reference))

    def to_json(self) -> dict[str, Any]:
        """Return the line as plain data."""
        return {
            "hello": self.name,
            "loops": list(self.loops),
            "numbers": self.numbers,
            "reference": self.reference,
        }


def read_hello(line: str) -> Hello:
    """Read the first line of an implementation.

    Raises:
        ProtocolError: not a hello; the message says what is wrong.

    Example:
        >>> read_hello('{"hello": "mine", "loops": ["inner"], "numbers": "int64"}')
        Traceback (most recent call last):
        exactsweep.conform.run.protocol.ProtocolError: the hello has no "reference"
    """
    try:
        found = read_object(line)
    except ProtocolError as error:
        raise ProtocolError(f"the first line is no hello: {error}") from None
    if "hello" not in found:
        raise ProtocolError('the first line is no hello: it has no "hello"')
    for name in ("loops", "numbers", "reference"):
        if name not in found:
            raise ProtocolError(f'the hello has no "{name}"')
    return Hello.of(found["hello"], found["loops"], found["numbers"], found["reference"])


def case_line(
    id: str,
    kind: str,
    directrix: Iterable[Point],
    generatrix: Iterable[Point],
    reference: Point,
    numbers: Numbers,
) -> str:
    """Write the line of a case, without its end.

    Example:
        >>> triangle = [Point(Fraction(x), Fraction(y)) for x, y in ((0, 0), (1, 0), (0, 1))]
        >>> case_line("a", "CC", triangle, triangle[:1], triangle[0], "binary64")[:50]
        '{"id": "a", "class": "CC", "directrix": [["0.0", "'
    """
    write = _binary64 if numbers == "binary64" else format_fraction
    return json.dumps(
        {
            "id": id,
            "class": kind,
            "directrix": [[write(c) for c in point] for point in directrix],
            "generatrix": [[write(c) for c in point] for point in generatrix],
            "reference": [write(c) for c in reference],
        }
    )


def read_object(line: str) -> dict[str, Any]:
    """Read a line that must be a JSON object.

    Raises:
        ProtocolError: anything else; the message quotes the start of the line.

    Cost: linear; memory about 30 times the line, at worst.
    """
    try:
        found = parse_certificate(line)
    except FormatError as error:
        # The file of one line that the parser sees is no place to look at.
        reason = str(error).removeprefix("line 1, ")
        raise ProtocolError(f"{quoted(line)} is no JSON line: {reason}") from None
    if not isinstance(found, dict):
        raise ProtocolError(f"{quoted(line)} is {described(found)}, not an object")
    return found


def _binary64(value: Fraction) -> str:
    return repr(float(value))


class UnsupportedError(ExactSweepError):
    """A case that the numbers of an implementation do not hold."""


def adapt(case: Case, hello: Hello) -> Case:
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
        >>> whole = adapt(case, Hello("mine", numbers="int32", reference="first"))
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
