"""Verdicts on answers of other programs, and answers read unchecked."""

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
    """The verdicts on an answer, from best to worst. The worst part of an answer decides.

    E is the closed region inside the exact loop, T the one inside the answered loop: the points
    around which the rings wind an odd number of times. One loop gets the first of these verdicts
    that holds, malformed before those that compare regions:

    - malformed: the answer determines no region, though its parts may still be measured. A
      number is nan, infinite or unreadable; a vertex has not two coordinates; a loop that was
      promised is missing or empty, or larger than `limits` allow. Or the region is not the exact
      one, nor rounded, and programs that read the rings would not agree on it: edges cross, two
      rings overlap, a ring encloses nothing (fewer than three distinct vertices, or zero area),
      or a line is traced in and out, which is no exact fit and does not lead to another ring.
    - exact: the vertices of the exact loop, each once, counter-clockwise. Any of them may come
      first, and may be repeated at the end.
    - equivalent: T = E, given in another way: clockwise, with collinear or repeated vertices, in
      other rings, keyholed, crossing itself where it does no harm, or with exact fits traced.
    - within: theirs is the exact region except for rounding. By the larger of the differences in x
      and in y, each point of either boundary is closer than `rounding` to the other one, and each
      point in only one of T and E closer than half of it to one of the boundaries (see
      `closeness`). Vertices may fall together or appear on edges so, and rings may touch or part,
      but nothing that is as wide as `rounding` is lost or gained. Rings that are nowhere so far
      from one exact fit trace it. A rounded answer may permit overlap, or lose free space: the
      witnesses say whether it does.
    - false exact fits: of exact fits alone: the answer has positions that are on none.
    - conservative: T contains E. An answered trajectory permits no overlap, but forbids free
      positions.
    - unsound: E contains T. An answered trajectory permits overlap.
    - wrong: neither. An answered trajectory permits overlap and forbids free positions. A
      different region with too many edges to compare (`region.MAX_WORK`) is wrong, too.

    The caller declares `rounding`, or `rounding.grant_rounding` derives it from the program's
    numbers. An answer's own claim is granted up to `rounding.MOST_CLAIMED`.

    Exact fits, where the trajectory is answered, are a part of their own; `judge_fits` says what
    they may be. Where they are only missing, too short or rounded, the part is "equivalent except
    for exact fits", which is thus the verdict on an answer whose loops are exact or equivalent.
    Programs for Minkowski sums cannot know them; a false one counts against the program.

    The runner adds timeout, memory (more than was allowed), crash, and unsupported: no answer that
    could be judged; and undecided, where there is one that could not be compared in time, by no
    fault of the implementation.

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
        """The place in the order above, 0 for exact."""
        return _SEVERITY[self]

    @property
    def is_judgement(self) -> bool:
        """Decide whether it says what an implementation did: not undecided, not unsupported."""
        return self not in (Verdict.UNDECIDED, Verdict.UNSUPPORTED)


_SEVERITY = {verdict: k for k, verdict in enumerate(Verdict)}


@dataclass(frozen=True)
class Witness:
    """A place where theirs is wrong, checked again before it is handed out.

    Attributes:
        says: one sentence that describes it.
        translation: Point, where G's origin is to be put, or None if the witness is no position.
        classified: what `classify` says of that translation: FREE, CONTACT, OVERLAP; or None.
        point: Point of the plane: in both interiors, for an OVERLAP; for the inner and the outer
            loop the point that G can or cannot cover; or None.
    """

    says: str
    translation: Point | None = None
    classified: Meeting | None = None
    point: Point | None = None


@dataclass(frozen=True)
class PartComparison:
    """One part of an answer beside the exact one.

    Attributes:
        name: "trajectory", "inner", "outer" or "exact_fits".
        verdict: of this part alone.
        reason: one line.
        distance_squared: bounds (low, high) of the square of the Hausdorff distance between the
            two loops, both equal where it is rational; None where it is not defined.
        permitted: area of E without T: overlap permitted, for the trajectory.
        forbidden: area of T without E: free space lost, for the trajectory.
        unsound: Witness in E without T, or None.
        conservative: Witness in T without E, or None.
        granted: the bound that coordinate errors had to stay below, if one was needed.
        kind: in which way exact fits differ, or how else the loop is special; "" where it is not.
        diagnosis: the questions to which the loop is exact, the likeliest first; () if none.
    """

    name: str
    verdict: Verdict
    reason: str = ""
    distance_squared: tuple[Fraction, Fraction] | None = None
    permitted: Fraction | None = None
    forbidden: Fraction | None = None
    unsound: Witness | None = None
    conservative: Witness | None = None
    granted: Fraction | None = None
    kind: str = ""
    diagnosis: tuple[str, ...] = ()

    @property
    def area(self) -> Fraction | None:
        """Area of the symmetric difference of E and T; None where it is not defined."""
        if self.permitted is None or self.forbidden is None:
            return None
        return self.permitted + self.forbidden

    @property
    def witnesses(self) -> tuple[Witness, ...]:
        """All witnesses there are, the one of overlap first."""
        found = (self.unsound, self.conservative)
        return tuple(witness for witness in found if witness is not None)

    def to_json(self) -> dict[str, Any]:
        """Return plain data, numbers as strings, the area included."""
        said = asdict(self) | {"verdict": self.verdict.value, "area": self.area}
        return to_plain(said)


@dataclass(frozen=True)
class Comparison:
    """An answer beside the exact one; by `compare`, or by the runner where there is no answer.

    Attributes:
        id: of the case.
        verdict: the worst of the parts.
        reason: one line, that of the worst part.
        parts: tuple of PartComparison: the parts that were answered, trajectory, inner, outer,
            exact fits in this order.
    """

    id: str
    verdict: Verdict
    reason: str = ""
    parts: tuple[PartComparison, ...] = ()

    @property
    def worst(self) -> PartComparison | None:
        """The first of the worst parts; None without parts."""
        return max(self.parts, key=lambda part: part.verdict.severity, default=None)

    @property
    def witness(self) -> Witness | None:
        """The first witness of the worst part, or None if it has none."""
        part = self.worst
        return part.witnesses[0] if part is not None and part.witnesses else None

    def to_json(self) -> dict[str, Any]:
        """Return plain data, numbers as strings."""
        parts = [part.to_json() for part in self.parts]
        return vars(self) | {"verdict": self.verdict.value, "parts": parts}


LOOPS = ("trajectory", "inner", "outer", "no_fit", "minkowski_sum", "inner_fit")
"""The members of an answer: loops of a sweep, rings of the fits, and those of a + b."""


class AnswerError(ExactSweepError):
    """An answer, or a part of it, that does not say which points it means; with the place."""


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
        """Decide whether all coordinates are integers, and none was a float."""
        return not self.has_floats and all(
            c.denominator == 1 for ring in self.rings for point in ring for c in point
        )


def read_loop(value: object, path: str, *, may_be_empty: bool = False) -> AnsweredLoop:
    """Read a loop: a list of pairs of numbers, or a list of such lists, its rings.

    Args:
        value: plain data. A number is an int; a float, taken as the binary value that it is; a
            string that `to_fraction` reads; or what else that reads. A ring may be closed (the
            last vertex repeats the first) or not.
        path: where the value stands, for messages.
        may_be_empty: whether no ring at all is an answer, as that a part does not fit.

    Returns:
        The AnsweredLoop. Rings of fewer than three vertices are read, too.

    Raises:
        AnswerError: anything else, numbers that are not finite, a ring without vertices, or
            more of them than `limits` allow.

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


def read_number(value: object, path: str) -> Fraction:
    """Read one number, as `read_loop` does.

    Raises:
        AnswerError: it is none.
    """
    try:
        return to_fraction(value)
    except NumberError as error:
        raise AnswerError(f"{path}: {error}") from None


def _read_points(pairs: Sequence[object], path: str) -> tuple[Loop, bool]:
    """Read points, and tell whether a coordinate is a float."""
    points, has_floats = [], False
    for k, pair in enumerate(pairs):
        found = _list(pair, f"{path}[{k}]", "a pair of numbers")
        if len(found) != 2:
            raise AnswerError(f"{path}[{k}] has {count(len(found), 'coordinate')}, not 2")
        points.append(Point(*(read_number(c, f"{path}[{k}]") for c in found)))
        has_floats = has_floats or any(isinstance(c, float) for c in found)
    return tuple(points), has_floats


def _list(value: object, path: str, what: str) -> Sequence[object]:
    if not isinstance(value, (list, tuple)):
        raise AnswerError(f"{path} is {name_kind(value)}, not {what}")
    return value


def name_kind(value: object) -> str:
    """Name the kind of any value; answers of Python callables may hold anything."""
    return describe_kind(value) if isinstance(value, (dict, list, str, bool)) else quote(value)
