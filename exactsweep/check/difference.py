"""Loops and exact fits, claimed and true: where the lines that they run along differ.

Steps 3 to 5 of `complete`.
"""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from exactsweep.check.certificate import CertificateError
from exactsweep.check.size import Budget
from exactsweep.check.uncovered import unite
from exactsweep.numbers.point import Fit, Loop, Point


class LoopOrFit(NamedTuple):
    """A loop or an exact fit of a list."""

    group: str
    name: str
    points: Loop
    is_loop: bool

    @property
    def segments(self) -> list[Fit]:
        """Its edges, or the fit itself."""
        return list(pairwise((*self.points, self.points[0]) if self.is_loop else self.points))


def compare(
    claimed: Sequence[LoopOrFit],
    true: Sequence[LoopOrFit],
    say: Callable[[Point], str],
    budget: Budget,
) -> None:
    """Check that parts are those that they should be, in the same order.

    Args:
        claimed: the parts of a certificate.
        true: those of the answer.
        say: the message for a point of a claimed part that is on no true one.
        budget: the steps that it may take.

    Raises:
        CertificateError: the witness is a point of just one of the two, or a point of a part
            that is none, although it runs along others.

    Cost: O(k log k) for k edges, and O(k) for each single point that just one of the two has.
    """
    known, listed = _Segments(true), _Segments(claimed)
    budget.take(4 * (known.count_searches(claimed) + listed.count_searches(true)))
    for part in claimed:
        if (t := known.first_outside(part)) is not None:
            raise CertificateError(f"{part.name}: at the witness {say(t)}", t)
    for part in true:
        if (t := listed.first_outside(part)) is not None:
            raise CertificateError(f"{part.group}: one is missing, or a part of it", t)
    right = {(part.group, part.points) for part in true}
    for part in claimed:
        if (part.group, part.points) not in right:
            (ax, ay), (bx, by) = part.points[:2]
            middle = Point((ax + bx) / 2, (ay + by) / 2)
            raise CertificateError(
                f"{part.name}: on the boundary, but not one of {part.group}", middle
            )
    for part, other in zip(claimed, true, strict=False):
        if part != other:
            reason = f"{part.group}: one is listed twice, is missing, or they are not sorted"
            raise CertificateError(reason, part.points[0])
    if len(claimed) != len(true):
        reason = "one is listed twice or is missing"
        raise CertificateError(reason, max(claimed, true, key=len)[-1].points[0])


class _Segments:
    """The segments of some parts, by the lines that they are on."""

    def __init__(self, parts: Iterable[LoopOrFit]) -> None:
        spans_of: dict[_SlopeForm, list[_Reach]] = defaultdict(list)
        self._points = set()
        for a, b in (segment for part in parts for segment in part.segments):
            if a == b:
                self._points.add(a)
            else:
                line = _line_through(a, b)
                spans_of[line].append(_span(a, b, line))
        self._spans = {line: unite(spans) for line, spans in spans_of.items()}

    def first_outside(self, part: LoopOrFit) -> Point | None:
        """A point of a part that is on none of the segments."""
        for a, b in part.segments:
            if a == b:
                if not self._holds(a):
                    return a
                continue
            line = _line_through(a, b)
            low, high = _span(a, b, line)
            spans = self._spans.get(line, [])
            # The first that ends beyond the lower end: the one before ends at it, or below.
            k = bisect_right(spans, low, key=_end)
            start, end = spans[k] if k < len(spans) else (high, high)
            if low < start:
                return _at((low + min(start, high)) / 2, line)
            if end < high:
                after = spans[k + 1][0] if k + 1 < len(spans) else high
                return _at((end + min(after, high)) / 2, line)
        return None

    def count_searches(self, parts: Iterable[LoopOrFit]) -> int:
        """Count the lines that are searched for single points of parts that are not listed."""
        points = {a for part in parts for a, b in part.segments if a == b}
        return len(points - self._points) * len(self._spans)

    def _holds(self, p: Point) -> bool:
        return p in self._points or any(
            p == _at(along := p.y if line[0] is None else p.x, line)
            and any(low <= along <= high for low, high in spans)
            for line, spans in self._spans.items()
        )


_Reach = tuple[Fraction, Fraction]

# Slope and height at x = 0, or None and x.
_SlopeForm = tuple[Fraction | None, Fraction]


def _line_through(a: Point, b: Point) -> _SlopeForm:
    if a.x == b.x:
        return None, a.x
    slope = (b.y - a.y) / (b.x - a.x)
    return slope, a.y - slope * a.x


def _end(span: _Reach) -> Fraction:
    return span[1]


def _span(a: Point, b: Point, line: _SlopeForm) -> _Reach:
    low, high = sorted((a.y, b.y) if line[0] is None else (a.x, b.x))
    return low, high


def _at(along: Fraction, line: _SlopeForm) -> Point:
    slope, height = line
    return Point(height, along) if slope is None else Point(along, slope * along + height)
