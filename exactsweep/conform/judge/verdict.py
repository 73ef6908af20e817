"""Verdicts on answers, and a reader of answers."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from enum import StrEnum
from fractions import Fraction
from typing import Any, NamedTuple

from exactsweep.check.classify import Meeting
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import describe_kind
from exactsweep.formats.size import VERTEX, require_count
from exactsweep.numbers.digits import to_plain
from exactsweep.numbers.error import ExactSweepError, NumberError, quote
from exactsweep.numbers.number import Loop, Point, to_fraction
from exactsweep.words import count

LOOPS = ("trajectory", "inner", "outer", "no_fit", "minkowski_sum", "inner_fit")


class Verdict(StrEnum):
    """The verdicts from best to worst; VERDICTS.md defines them.

    An answer gets the worst verdict of its parts. E is the region inside the exact loop and T the
    region inside the answered loop; a point is inside if the rings have an odd winding number.

    >>> max(Verdict.EXACT, Verdict.WITHIN, key=lambda verdict: verdict.severity).value
    'within'
    """

    EXACT = "exact"
    EQUIVALENT = "equivalent"
    EQUIVALENT_EXCEPT_FOR_EXACT_FITS = "equivalent except for exact fits"
    WITHIN = "within"
    FALSE_EXACT_FITS = "false exact fits"
    CONSERVATIVE = "conservative"
    UNSOUND = "unsound"
    WRONG = "wrong"
    MALFORMED = "malformed"
    TIMEOUT = "timeout"
    MEMORY = "memory"
    CRASH = "crash"
    UNDECIDED = "undecided"
    UNSUPPORTED = "unsupported"

    @property
    def severity(self) -> int:
        """The rank of the verdict; 0 for exact."""
        return [*Verdict].index(self)

    @property
    def is_judgement(self) -> bool:
        """Whether the program was judged: neither undecided nor unsupported."""
        return self not in (Verdict.UNDECIDED, Verdict.UNSUPPORTED)


@dataclass(frozen=True)
class Witness:
    """A verified position or point at which an answer is wrong.

    The point is in both interiors for an OVERLAP; G can or cannot cover it for inner and outer
    loops.
    """

    says: str  # one sentence
    translation: Point | None = None  # of G, if the witness is a position
    classified: Meeting | None = None  # the verdict of `classify` on the translation
    point: Point | None = None


@dataclass(frozen=True)
class PartComparison:
    """The comparison of one part of an answer with the exact part."""

    name: str  # a key of `PART_NAMES`
    verdict: Verdict  # on this part alone
    reason: str = ""  # one line
    # By `measure_distance`; None if the loop is too large or has no vertices.
    distance_squared: Fraction | None = None
    permitted: Fraction | None = None  # area of permitted overlap: E without T for a trajectory
    forbidden: Fraction | None = None  # area of lost free space: T without E for a trajectory
    unsound: Witness | None = None  # of permitted overlap
    conservative: Witness | None = None  # of lost free space
    granted: Fraction | None = None  # the strict bound on coordinate errors, if one was needed
    kind: str = ""  # the differences of exact fits, or another property of the loop
    diagnosis: tuple[str, ...] = ()  # questions that the loop answers exactly, likeliest first

    @property
    def area(self) -> Fraction | None:
        """The area of the symmetric difference of E and T; None if it is not defined."""
        if self.permitted is None or self.forbidden is None:
            return None
        return self.permitted + self.forbidden

    def to_json(self) -> dict[str, Any]:
        """Return plain data with numbers as strings."""
        return to_plain(asdict(self) | {"verdict": self.verdict.value, "area": self.area})


@dataclass(frozen=True)
class Comparison:
    """The comparison of an answer with the exact one, or the reason why there is no answer."""

    id: str  # of the case
    verdict: Verdict  # the worst of the parts
    reason: str = ""  # one line, from the worst part
    parts: tuple[PartComparison, ...] = ()  # loops first

    @property
    def worst(self) -> PartComparison | None:
        """The first part with the worst verdict; None if there are no parts."""
        return max(self.parts, key=lambda part: part.verdict.severity, default=None)

    def to_json(self) -> dict[str, Any]:
        """Return plain data with numbers as strings."""
        parts = [part.to_json() for part in self.parts]
        return vars(self) | {"verdict": self.verdict.value, "parts": parts}


class AnswerError(ExactSweepError):
    """An unreadable answer; the message states where."""


class AnsweredLoop(NamedTuple):
    rings: tuple[Loop, ...]
    has_floats: bool

    @property
    def is_integer(self) -> bool:
        return not self.has_floats and all(
            c.denominator == 1 for ring in self.rings for point in ring for c in point
        )


def read_loop(value: object, path: str, *, may_be_empty: bool = False) -> AnsweredLoop:
    """Read a loop: a ring, which is a list of pairs of numbers, or a list of rings, open or closed.

    >>> loop = read_loop([[0, 0], [0.5, 0], ["1/3", 1], [0, 0]], "$.inner")
    >>> len(loop.rings[0]), loop.has_floats
    (3, True)
    >>> read_loop([[0, 0], [1, float("nan")]], "$.inner")
    Traceback (most recent call last):
    exactsweep.conform.judge.verdict.AnswerError: $.inner[1]: nan is not a finite number
    """
    outermost = _list(value, path, "a list of vertices")
    if not outermost:
        if may_be_empty:
            return AnsweredLoop((), False)
        raise AnswerError(f"{path} is empty")
    first = outermost[0]
    rings = [(outermost, path)]
    if isinstance(first, (list, tuple)) and (not first or isinstance(first[0], (list, tuple))):
        rings = [
            (_list(ring, f"{path}[{k}]", "a ring"), f"{path}[{k}]")
            for k, ring in enumerate(outermost)
        ]
    for ring, place in rings:
        if not ring:
            raise AnswerError(f"{place} is empty")
    try:
        require_count(sum(len(ring) for ring, _ in rings), VERTEX, "vertices")
    except FormatError as error:
        raise AnswerError(f"{path} has {error}") from None
    read = [_read_points(ring, place) for ring, place in rings]
    opened = (p[:-1] if len(p) > 1 and p[0] == p[-1] else p for p, _ in read)
    return AnsweredLoop(tuple(opened), any(has_floats for _, has_floats in read))


def read_segments(value: object, path: str) -> AnsweredLoop:
    """Read exact fits, a list of pairs of points, each as a ring of two points."""
    read = []
    for k, pair in enumerate(_list(value, path, "a list of segments")):
        place = f"{path}[{k}]"
        ends = _list(pair, place, "a pair of points")
        if len(ends) != 2:
            raise AnswerError(f"{place} has {count(len(ends), 'end')}, not 2")
        read.append(_read_points(ends, place))
    return AnsweredLoop(tuple(p for p, _ in read), any(has_floats for _, has_floats in read))


def _read_points(pairs: Sequence[object], path: str) -> tuple[Loop, bool]:
    points, has_floats = [], False
    for k, pair in enumerate(pairs):
        found = _list(pair, f"{path}[{k}]", "a pair of numbers")
        if len(found) != 2:
            raise AnswerError(f"{path}[{k}] has {count(len(found), 'coordinate')}, not 2")
        try:
            points.append(Point(*map(to_fraction, found)))
        except NumberError as error:
            raise AnswerError(f"{path}[{k}]: {error}") from None
        has_floats = has_floats or any(isinstance(c, float) for c in found)
    return tuple(points), has_floats


def _list(value: object, path: str, what: str) -> Sequence[object]:
    if not isinstance(value, (list, tuple)):
        raise AnswerError(f"{path} is {describe_type(value)}, not {what}")
    return value


def describe_type(value: object) -> str:
    return describe_kind(value) if isinstance(value, (dict, list, str, bool)) else quote(value)
