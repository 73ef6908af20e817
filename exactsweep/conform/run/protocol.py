"""The protocol between the runner and a program; PROTOCOL.md specifies it."""

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import chain
from typing import Any, Literal, TypeVar, get_args

from exactsweep.corpus import Case
from exactsweep.corpus.answered import SHAPES, Shapes, find_types
from exactsweep.formats import FormatError
from exactsweep.formats.exact_json import describe_kind, parse_certificate
from exactsweep.geometry.point_set import PointSet
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import ExactSweepError, prefix_errors, quote
from exactsweep.numbers.number import ORIGIN, Loop, Point
from exactsweep.words import suggest

Numbers = Literal["rational", "integer", "int64", "int32", "binary64"]
Reference = Literal["given", "origin", "first"]
Question = Literal["sweep", "no_fit", "minkowski_sum", "inner_fit"]
Word = TypeVar("Word", bound=str)
LOOPS = ("trajectory", "inner", "outer")
NUMBERS: tuple[Numbers, ...] = get_args(Numbers)
REFERENCES: tuple[Reference, ...] = get_args(Reference)
QUESTIONS: tuple[Question, ...] = get_args(Question)
_MEMBERS = ("hello", "loops", "numbers", "reference", "questions", "shapes")
SUM: Question = "minkowski_sum"
BYE = '{"bye": true}'
MAX_NAME = 200
_POSITIONS = (
    *("reference", "trajectory", "holes", "exact_fits"),
    *("inner_regions", "inner_exact_fits"),
)
# Members of a case that do not depend on the reference point.
_FIXED = (
    *("directrix_ring", "directrix_holes", "generatrix_ring", "generatrix_holes"),
    *("inner", "outer", "unswept"),
)


class ProtocolError(ExactSweepError):
    """A line from a program that violates the protocol."""


@dataclass(frozen=True)
class Hello:
    name: str  # with its version, for the report
    loops: tuple[str, ...] = ("trajectory",)  # of a sweep; () without sweeps
    numbers: Numbers = "rational"  # that it reads
    reference: Reference = "given"  # the point of G that it uses as reference point
    questions: tuple[Question, ...] = ("sweep",)
    shapes: Shapes = "monotone"  # the pairs that it accepts

    def parts(self, case: Case) -> tuple[str, ...]:
        """List the parts of an answer to a case: loops of a sweep, and other questions."""
        others = {"sweep"} if case.inner_regions is not None else {"sweep", "inner_fit"}
        return (*self.loops, *(name for name in self.questions if name not in others))

    def to_json(self) -> dict[str, Any]:
        return {
            "hello": self.name,
            "loops": list(self.loops),
            "numbers": self.numbers,
            "reference": self.reference,
            "questions": list(self.questions),
            "shapes": self.shapes,
        }


def make_hello(said: Mapping[str, object]) -> Hello:
    for member in said:
        if member not in _MEMBERS:
            raise ProtocolError(
                f"unknown member {quote(member)} of the hello{suggest(member, _MEMBERS)}"
            )
    said = {"questions": ["sweep"], "shapes": "monotone", **said}
    if said["questions"] == [SUM]:
        # A sum has no reference point.
        said = {"reference": "given", **said}
    name, questions = said["hello"], _choose_some(said, "questions", QUESTIONS)
    if not isinstance(name, str) or not 0 < len(name) <= MAX_NAME or not name.isprintable():
        raise ProtocolError(f'"hello" is not a name of 1 to {MAX_NAME} printable characters')
    try:
        return Hello(
            name,
            _choose_some(said, "loops", LOOPS) if "sweep" in questions else (),
            _choose(said, "numbers", NUMBERS),
            _choose(said, "reference", REFERENCES),
            questions,
            _choose(said, "shapes", SHAPES),
        )
    except KeyError as error:
        raise ProtocolError(f'the hello has no "{error.args[0]}"') from None


def _choose(said: Mapping[str, object], key: str, allowed: tuple[Word, ...]) -> Word:
    if said[key] not in allowed:
        raise ProtocolError(f'"{key}" is {quote(said[key])}, not one of {", ".join(allowed)}')
    return allowed[allowed.index(said[key])]


def _choose_some(
    said: Mapping[str, object], key: str, allowed: tuple[Word, ...]
) -> tuple[Word, ...]:
    found = said[key]
    if isinstance(found, (list, tuple)) and found and all(word in allowed for word in found):
        return tuple(word for word in allowed if word in found)
    raise ProtocolError(f'"{key}" is {quote(found)}, not a nonempty list of {", ".join(allowed)}')


def read_hello(line: str) -> Hello:
    with prefix_errors("the first line is not a hello"):
        found = read_object(line)
        if "hello" not in found:
            raise ProtocolError('it has no "hello"')
    return make_hello(found)


def write_case_line(case: Case, hello: Hello) -> str:
    """Format a case as a line, without the newline, for a program with this hello."""
    is_double = hello.numbers == "binary64"

    def ring(points: Iterable[Point]) -> list[list[str]]:
        return [[repr(float(c)) if is_double else format_fraction(c) for c in p] for p in points]

    shapes: dict[str, Iterable[Loop]] = {}
    if SUM in hello.questions:
        shapes = {"a": case.directrix_rings, "b": list_reflected_rings(case)}
    if hello.questions != (SUM,):
        shapes |= {"directrix": case.directrix_rings, "generatrix": case.generatrix_rings}
    line: dict[str, Any] = {"id": case.id, "class": case.kind}
    holes = {}
    for name, (exterior, *inner) in shapes.items():
        line[name] = ring(exterior)
        if inner:
            holes[f"{name}_holes"] = [ring(hole) for hole in inner]
    if hello.questions != (SUM,):
        line["reference"] = ring([case.reference])[0]
    return json.dumps({**line, **holes, "ask": list(hello.parts(case))})


def list_reflected_rings(case: Case) -> tuple[Loop, ...]:
    # The rings of -G, the second summand of a Minkowski sum.
    return tuple(tuple(Point(-x, -y) for x, y in ring) for ring in case.generatrix_rings)


def read_object(line: str) -> dict[str, Any]:
    try:
        found = parse_certificate(line)
    except FormatError as error:
        # The input has only one line.
        reason = str(error).removeprefix("line 1, ")
        raise ProtocolError(f"{quote(line)} is not a line of JSON: {reason}") from None
    if not isinstance(found, dict):
        raise ProtocolError(f"{quote(line)} is {describe_kind(found)}, not an object")
    return found


def read_reply(line: str) -> dict[str, Any]:
    result = read_object(line)
    if "id" not in result:
        raise ProtocolError('the answer has no "id"')
    return result


class UnsupportedError(ExactSweepError):
    pass


def adapt(case: Case, hello: Hello) -> Case:
    """Adapt a case and its answers to a program: set the reference point, and scale if necessary.

    An UnsupportedError is raised if the hello excludes the case.

    >>> case = Case.of("a", "", [(0, 0), ("1/2", 0), (0, 1)], [(1, 1), (2, 1), (1, 2)])
    >>> whole = adapt(case, Hello("mine", numbers="int32", reference="first"))
    >>> print(whole.directrix, "from", whole.trajectory.vertices[0])
    (0, 0) (1, 0) (0, 2) from (-2, 0)
    """
    if SHAPES.index(case.shapes) > SHAPES.index(hello.shapes):
        raise UnsupportedError(f"skipped: the program accepts only {hello.shapes} pairs")
    if not hello.parts(case):
        raise UnsupportedError("skipped: the case has no inner fit")
    if hello.reference != "given":
        x, y = ORIGIN if hello.reference == "origin" else case.generatrix_ring[0]
        case = _transform(case, by=Point(x - case.reference.x, y - case.reference.y))
    if hello.numbers == "rational":
        return case
    if hello.numbers == "binary64":
        for candidate in (case, _transform(case, case.integer_scale)):
            if "binary64" in candidate.representable:
                return candidate
    elif hello.numbers == "integer" or hello.numbers in case.representable:
        scaled = _transform(case, case.integer_scale)
        if SUM not in hello.questions or hello.numbers == "integer":
            return scaled
        # The minimum of a signed type cannot be negated, so check the reflected rings too.
        reflected = chain.from_iterable(chain.from_iterable(list_reflected_rings(scaled)))
        if hello.numbers in find_types([*reflected], 1):
            return scaled
    raise UnsupportedError(f"{hello.numbers} cannot represent the case")


def _transform(case: Case, k: int | Fraction = 1, by: Point = ORIGIN) -> Case:
    """Scale polygons p to k p, and map positions t to k t + by."""
    if (k, by) == (1, ORIGIN):
        return case

    def put(found: Any, by: Point) -> Any:
        if isinstance(found, Point):
            return Point(found.x * k + by.x, found.y * k + by.y)
        if isinstance(found, PointSet):
            return found.scaled(k).translated(by)
        return found and tuple(put(one, by) for one in found)

    moved = dict.fromkeys(_FIXED, ORIGIN) | dict.fromkeys(_POSITIONS, by)
    parts = {name: put(getattr(case, name), offset) for name, offset in moved.items()}
    return replace(case, area=case.area * k * k, **parts)
