"""Failing cases made smaller while they still fail.

Greedy, in rounds, until a round changes nothing: vertices are left out, many at once and then one
by one; the pair is moved to the origin and freed of common factors; numbers are made shorter, all
together and then one by one. A candidate replaces the case if it is smaller, `sweep` accepts it, it
shows the same fault, and all its flags are flags of the case: a lost notch must not become a
repeated vertex, which is another fault. Cases have a total order, by numbers of vertices and sizes
of numbers, and each candidate is less than the one before, so rounds end.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import chain
from math import gcd, lcm
from typing import NamedTuple

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.corpus import Case
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.error import ExactSweepError, tells_arguments
from exactsweep.numbers.number import ORIGIN, Loop, Point


class ShrinkError(ExactSweepError):
    """A case that does not fail."""


class _GivenPair(NamedTuple):
    """The rings of D and of G as given, the exterior of each first, and the reference point."""

    shapes: tuple[tuple[Loop, ...], ...]
    reference: Point

    def size(self) -> tuple[int, int, Fraction]:
        """Measure a case for shrinking: vertices, then digits, then numbers."""
        numbers = [c for point in self.points() for c in point]
        digits = sum(c.numerator.bit_length() + c.denominator.bit_length() for c in numbers)
        vertices = sum(map(len, chain(*self.shapes)))
        return vertices, digits, sum(map(abs, numbers), Fraction(0))

    def points(self) -> Iterator[Point]:
        return chain(*chain(*self.shapes), (self.reference,))

    def rings(self) -> Iterator[tuple[int, int, Loop]]:
        """The rings, each with the number of its polygon and its own number there."""
        for which, rings in enumerate(self.shapes):
            yield from ((which, k, ring) for k, ring in enumerate(rings))

    def with_ring(self, which: int, k: int, *ring: Loop) -> _GivenPair:
        """The pair with another ring in the place of one, or with none."""
        shapes = list(self.shapes)
        shapes[which] = (*shapes[which][:k], *ring, *shapes[which][k + 1 :])
        return self._replace(shapes=tuple(shapes))

    def put(self, function: Callable[[Point], Point]) -> _GivenPair:
        """The pair with a function applied to each point."""
        shapes = tuple(_put(rings, function) for rings in self.shapes)
        return _GivenPair(shapes, function(self.reference))

    def map(self, function: Callable[[Fraction], Fraction]) -> _GivenPair:
        """The pair with a function applied to each number."""
        return self.put(lambda p: Point(function(p.x), function(p.y)))


def _put(rings: tuple[Loop, ...], function: Callable[[Point], Point]) -> tuple[Loop, ...]:
    return tuple(tuple(map(function, ring)) for ring in rings)


@tells_arguments
def shrink(
    case: Case, judge: Callable[[Case], str], *, tries: int = 1000, seconds: float = 60.0
) -> Case:
    """Find a small case that shows the same fault.

    Args:
        case: a case that fails.
        judge: gives the verdict on a case, as by an implementation and `compare`, or more than
            the verdict: the value that must stay the same. An exception ends the search.
        tries: the most calls of `judge`.
        seconds: the time after which it is not called again.

    Returns:
        A Case with the id "ID-shrunk"; the same pair, if none that is smaller was found.

    Raises:
        ShrinkError: the verdict on the case is exact or equivalent.

    Cost: that of `tries` times `judge` and `sweep`.

    Example:
        >>> from exactsweep.corpus import find_case
        >>> def loses_fits(case):
        ...     return (
        ...         Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS if case.exact_fits else Verdict.EXACT
        ...     )
        >>> small = shrink(find_case("fits-square"), loses_fits)
        >>> print(small.generatrix, "into", small.directrix)
        (0, 0) (1, 1) (0, 1) into (0, 2) (1, 0) (1, 1) (2, 1) (2, 0) (3, 1)
    """
    fault = judge(case)
    if fault in (Verdict.EXACT, Verdict.EQUIVALENT):
        raise ShrinkError(f"case {case.id} does not fail: {fault}")
    search = _Search(case, judge, fault, tries - 1, time.monotonic() + seconds)
    while search.improve() and not search.is_over:
        pass
    return search.best


class _Search:
    """The smallest case so far, and how long the search may go on."""

    def __init__(
        self, case: Case, judge: Callable[[Case], str], fault: str, tries: int, deadline: float
    ) -> None:
        self._judge, self._fault = judge, fault
        self._tries, self._deadline = tries, deadline
        self._case = case
        self._pair = _GivenPair((case.directrix_rings, case.generatrix_rings), case.reference)
        self._size = self._pair.size()
        self._seen: set[_GivenPair] = set()
        self.best = self._make(self._pair)
        self._flags = {*case.flags, *self.best.flags}

    @property
    def is_over(self) -> bool:
        """Decide whether no more may be asked."""
        return self._tries <= 0 or time.monotonic() >= self._deadline

    def improve(self) -> bool:
        """Go through all ways to a smaller pair once; tell whether one was found."""
        before = self._size
        for candidates in (_move, _leave_out, _shorten_all, _shorten_one):
            # Each way goes on from the pair as it is now, and begins again when that has changed.
            while any(self._take(pair) for pair in candidates(self._pair)):
                pass
        return self._size < before

    def _take(self, pair: _GivenPair) -> bool:
        if self.is_over or pair in self._seen or pair.size() >= self._size:
            return False
        self._seen.add(pair)
        try:
            case = self._make(pair)
        except ValueError:
            return False
        if not self._flags.issuperset(case.flags):
            return False
        self._tries -= 1
        if self._judge(case) != self._fault:
            return False
        self._pair, self._size, self.best = pair, pair.size(), case
        return True

    def _make(self, pair: _GivenPair) -> Case:
        (d, *d_holes), (g, *g_holes) = pair.shapes
        return Case.of(
            f"{self._case.id}-shrunk",
            f"shrunk: {self._case.title}",
            d,
            g,
            pair.reference,
            directrix_holes=d_holes,
            generatrix_holes=g_holes,
            inner_fit=self._case.inner_regions is not None,
        )


def _move(pair: _GivenPair) -> Iterator[_GivenPair]:
    """Canonical rings, the reference at the origin, each polygon with its corner there."""
    canonical = (tuple(Polygon(ring).vertices for ring in rings) for rings in pair.shapes)
    yield _GivenPair(tuple(canonical), ORIGIN)
    yield pair._replace(reference=ORIGIN)
    (d, g), (low_d, low_g) = pair.shapes, map(_put_in_corner, pair.shapes)
    for shapes in ((low_d, low_g), (low_d, g), (d, low_g)):
        yield pair._replace(shapes=shapes)


def _put_in_corner(rings: tuple[Loop, ...]) -> tuple[Loop, ...]:
    x, y = map(min, zip(*rings[0], strict=True))
    return _put(rings, lambda p: Point(p.x - x, p.y - y))


def _leave_out(pair: _GivenPair) -> Iterator[_GivenPair]:
    """Holes, and vertices."""
    for which, k, ring in pair.rings():
        if k > 0:
            yield pair.with_ring(which, k)
        length = len(ring) // 2
        while length:
            for start in range(0, len(ring), length):
                rest = ring[:start] + ring[start + length :]
                if len(rest) > 2:
                    yield pair.with_ring(which, k, rest)
            length //= 2


def _shorten_all(pair: _GivenPair) -> Iterator[_GivenPair]:
    """All numbers at once: as integers without a common factor; rounded to fewer digits."""
    numbers = [c for point in pair.points() for c in point]
    scale = lcm(*(c.denominator for c in numbers))
    common = gcd(*(int(c * scale) for c in numbers)) or 1
    yield pair.map(lambda c: c * scale / common)
    digits = max(abs(c.numerator) for c in numbers).bit_length()
    while digits := digits // 2:
        power = 2**digits
        yield pair.map(lambda c, power=power: Fraction(round(c / power)))  # type: ignore[misc]
    yield pair.map(lambda c: Fraction(round(c)))
    for axis in (0, 1):
        yield _rank(pair, axis)


def _rank(pair: _GivenPair, axis: int) -> _GivenPair:
    """The pair with the coordinates of one axis numbered by their order."""
    rank = {c: Fraction(k) for k, c in enumerate(sorted({p[axis] for p in pair.points()}))}
    return pair.put(lambda p: p._replace(**{"xy"[axis]: rank[p[axis]]}))


def _shorten_one(pair: _GivenPair) -> Iterator[_GivenPair]:
    """One number at a time, or all numbers of a polygon that are equal to it on its axis."""
    for which, number, ring in pair.rings():
        for axis in "xy":
            for value in sorted({getattr(p, axis) for p in ring}, key=abs, reverse=True):
                for other in _find_simpler(value):
                    where = [k for k, p in enumerate(ring) if getattr(p, axis) == value]
                    for chosen in [where, *([k] for k in where if len(where) > 1)]:
                        moved = (
                            p._replace(**{axis: other}) if k in chosen else p
                            for k, p in enumerate(ring)
                        )
                        yield pair.with_ring(which, number, tuple(moved))


def _find_simpler(value: Fraction) -> list[Fraction]:
    """Numbers that are simpler than another one, the simplest first."""
    towards_zero = 1 if value < 0 else -1
    found = [Fraction(0), Fraction(round(value)), Fraction(int(value / 2))]
    if abs(value) < 32:
        found.append(value + towards_zero)
    return [other for other in dict.fromkeys(found) if other != value]
