"""Answers of other implementations, read as they are: whatever they may hold."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import describe_kind
from exactsweep.formats.size import VERTEX, require_count
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import NumberError, quote, to_fraction
from exactsweep.numbers.point import Loop, Point

LOOPS = ("trajectory", "inner", "outer", "no_fit", "inner_fit")
"""What an answer may hold: the loops of a sweep, and the rings of the two fits."""


class AnswerError(ExactSweepError):
    """An answer, or a part of it, that does not say which points it means; with the place."""


class AnsweredLoop(NamedTuple):
    """One loop as it was answered.

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
        exactsweep.conform.judge.answer.AnswerError: $.inner[1]: nan is not a finite number
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
    has_floats = False
    read = []
    for ring, place in rings:
        points = []
        for k, pair in enumerate(ring):
            point, is_float = _read_pair(pair, place, k)
            points.append(point)
            has_floats = has_floats or is_float
        if len(points) > 1 and points[0] == points[-1]:
            points.pop()
        read.append(tuple(points))
    return AnsweredLoop(tuple(read), has_floats)


def read_segments(value: object, path: str) -> AnsweredLoop:
    """Read exact fits: a list of pairs of points, as `read_loop` reads points.

    Returns:
        An AnsweredLoop, each segment a ring of two points, which may be equal.

    Raises:
        AnswerError: anything else.
    """
    segments = []
    has_floats = False
    for k, pair in enumerate(_list(value, path, "a list of segments")):
        place = f"{path}[{k}]"
        ends = _list(pair, place, "a pair of points")
        if len(ends) != 2:
            raise AnswerError(f"{place} has {len(ends)} ends, not 2")
        read = [_read_pair(end, place, j) for j, end in enumerate(ends)]
        segments.append(tuple(point for point, _ in read))
        has_floats = has_floats or any(is_float for _, is_float in read)
    return AnsweredLoop(tuple(segments), has_floats)


def read_number(value: object, path: str) -> Fraction:
    """Read one number, as `read_loop` does.

    Raises:
        AnswerError: it is none.
    """
    try:
        return to_fraction(value)
    except NumberError as error:
        raise AnswerError(f"{path}: {error}") from None


def _read_pair(pair: object, path: str, k: int) -> tuple[Point, bool]:
    if not isinstance(pair, (list, tuple)):
        raise AnswerError(f"{path}[{k}] is {name_kind(pair)}, not a pair of numbers")
    if len(pair) != 2:
        raise AnswerError(f"{path}[{k}] has {len(pair)} coordinates, not 2")
    x, y = pair
    try:
        point = Point(to_fraction(x), to_fraction(y))
    except NumberError as error:
        raise AnswerError(f"{path}[{k}]: {error}") from None
    return point, isinstance(x, float) or isinstance(y, float)


def _list(value: object, path: str, what: str) -> Sequence[object]:
    if not isinstance(value, (list, tuple)):
        raise AnswerError(f"{path} is {name_kind(value)}, not {what}")
    return value


def name_kind(value: object) -> str:
    """Name the kind of a value, whatever it is; answers of Python callables may hold anything."""
    return describe_kind(value) if isinstance(value, (dict, list, str, bool)) else quote(value)
