"""Verdicts on answers of other programs, and a reader of answers."""

from __future__ import annotations

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


class Verdict(StrEnum):
    """The verdicts on an answer, from best to worst; the worst part of an answer decides.

    E is the closed region inside the exact loop, T the one inside the answered loop: the points
    around which the rings wind an odd number of times. A loop gets the first of these verdicts
    that holds, malformed before those that compare regions:

    - malformed: a number or a loop is unreadable or missing; or the region is neither exact nor
      rounded, and readers of the rings would not agree on it: edges cross, rings overlap, a ring
      encloses nothing, or a line is traced in and out that is no exact fit and does not lead to
      another ring.
    - exact: the vertices of the exact loop, each once, counter-clockwise, from any of them.
    - equivalent: T = E, written differently.
    - within: T equals E except for rounding, as `closeness` defines it.
    - false exact fits: only for exact fits: a position of the answer is on none.
    - conservative: T contains E. An answered trajectory permits no overlap, but forbids free
      positions.
    - unsound: E contains T. An answered trajectory permits overlap.
    - wrong: neither; also a different region with too many edges (`region.MAX_WORK`).

    Exact fits are a part of their own; see `judge_fits`. If they are only missing, too short or
    rounded, that part is "equivalent except for exact fits". Programs for Minkowski sums cannot
    know exact fits; a false one counts against the program.

    The runner adds timeout, memory, crash and unsupported, without an answer to judge; and
    undecided, if the comparison took too long, which is no fault of the program.

    Example:
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
        """The index in the order above, 0 for exact."""
        return [*Verdict].index(self)

    @property
    def is_judgement(self) -> bool:
        """Whether the program was judged: it is neither undecided nor unsupported."""
        return self not in (Verdict.UNDECIDED, Verdict.UNSUPPORTED)


@dataclass(frozen=True)
class Witness:
    """A position or a point at which an answer is wrong, verified.

    Attributes:
        says: a description in one sentence.
        translation: the translation of G, or None if the witness is no position.
        classified: the verdict of `classify` on it: FREE, CONTACT, OVERLAP; or None.
        point: for an OVERLAP a Point in both interiors; for the inner and the outer loop the Point
            that G can or cannot cover; or None.
    """

    says: str
    translation: Point | None = None
    classified: Meeting | None = None
    point: Point | None = None


@dataclass(frozen=True)
class PartComparison:
    """One part of an answer, compared with the exact one.

    Attributes:
        name: "trajectory", "inner", "outer" or "exact_fits".
        verdict: of this part alone.
        reason: one line.
        distance_squared: by `measure_distance`; None if the loop is too large or has no vertices.
        permitted: area of E without T: overlap permitted, for the trajectory.
        forbidden: area of T without E: free space lost, for the trajectory.
        unsound: Witness in E without T, or None.
        conservative: Witness in T without E, or None.
        granted: the bound that coordinate errors had to stay below, if one was needed.
        kind: how exact fits differ, or another property of the loop; "" if there is none.
        diagnosis: the questions to which the loop is exact, the likeliest first; () if none.
    """

    name: str
    verdict: Verdict
    reason: str = ""
    distance_squared: Fraction | None = None
    permitted: Fraction | None = None
    forbidden: Fraction | None = None
    unsound: Witness | None = None
    conservative: Witness | None = None
    granted: Fraction | None = None
    kind: str = ""
    diagnosis: tuple[str, ...] = ()

    @property
    def area(self) -> Fraction | None:
        """Area of the symmetric difference of E and T; None if it is not defined."""
        if self.permitted is None or self.forbidden is None:
            return None
        return self.permitted + self.forbidden

    def to_json(self) -> dict[str, Any]:
        """Return plain data, numbers as strings, the area included."""
        return to_plain(asdict(self) | {"verdict": self.verdict.value, "area": self.area})


@dataclass(frozen=True)
class Comparison:
    """An answer, compared with the exact one by `compare`; or the lack of one, by the runner.

    Attributes:
        id: of the case.
        verdict: the worst of the parts.
        reason: one line, that of the worst part.
        parts: tuple of PartComparison: trajectory, inner, outer, exact fits in this order.
    """

    id: str
    verdict: Verdict
    reason: str = ""
    parts: tuple[PartComparison, ...] = ()

    @property
    def worst(self) -> PartComparison | None:
        """The first of the worst parts; None without parts."""
        return max(self.parts, key=lambda part: part.verdict.severity, default=None)

    def to_json(self) -> dict[str, Any]:
        """Return plain data, numbers as strings."""
        parts = [part.to_json() for part in self.parts]
        return vars(self) | {"verdict": self.verdict.value, "parts": parts}


LOOPS = ("trajectory", "inner", "outer", "no_fit", "minkowski_sum", "inner_fit")
"""The loops that an answer may have."""


class AnswerError(ExactSweepError):
    """An unreadable answer or part of one; the message says where."""


class AnsweredLoop(NamedTuple):
    """One answered loop.

    Attributes:
        rings: tuple of rings, each a tuple of Point, not closed, otherwise as given.
        has_floats: whether a coordinate was a float.
    """

    rings: tuple[Loop, ...]
    has_floats: bool

    @property
    def is_integer(self) -> bool:
        """Whether all coordinates are integers, and none was a float."""
        return not self.has_floats and all(
            c.denominator == 1 for ring in self.rings for point in ring for c in point
        )


def read_loop(value: object, path: str, *, may_be_empty: bool = False) -> AnsweredLoop:
    """Read a loop: a list of pairs of numbers, or a list of such lists, its rings.

    Args:
        value: plain data. A number is anything that `to_fraction` reads; a float has its binary
            value. A ring may be closed (the last vertex repeats the first) or not.
        path: the place of the value, for messages.
        may_be_empty: whether an answer may have no rings, if a part does not fit.

    Returns:
        The AnsweredLoop. Rings may have fewer than three vertices.

    Raises:
        AnswerError: anything else, a number is not finite, a ring has no vertices, or there are
            more vertices than `limits` allow.

    Cost: linear.

    Example:
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
    """Read exact fits: a list of pairs of points, as `read_loop` reads points.

    Returns:
        An AnsweredLoop, each segment a ring of two points, which may be equal.

    Raises:
        AnswerError: anything else.
    """
    read = []
    for k, pair in enumerate(_list(value, path, "a list of segments")):
        place = f"{path}[{k}]"
        ends = _list(pair, place, "a pair of points")
        if len(ends) != 2:
            raise AnswerError(f"{place} has {count(len(ends), 'end')}, not 2")
        read.append(_read_points(ends, place))
    return AnsweredLoop(tuple(p for p, _ in read), any(has_floats for _, has_floats in read))


def _read_points(pairs: Sequence[object], path: str) -> tuple[Loop, bool]:
    """Read points; return them, and whether a coordinate is a float."""
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
        raise AnswerError(f"{path} is {name_kind(value)}, not {what}")
    return value


def name_kind(value: object) -> str:
    """Name the kind of any value; a Python function may return anything."""
    return describe_kind(value) if isinstance(value, (dict, list, str, bool)) else quote(value)
