"""Reduction of failing cases to smaller ones with the same fault.

The greedy search moves the pair to the origin, removes vertices and shortens numbers, until a round
changes nothing. A candidate replaces the case if it is smaller, `sweep` accepts it, it has the same
fault, and all its flags are flags of the case, since another flag could be another fault.
"""

import time
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import chain
from math import gcd, lcm
from typing import NamedTuple, Self

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.corpus import Case
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.error import ExactSweepError, explain_type_errors
from exactsweep.numbers.number import ORIGIN, Loop


class ShrinkError(ExactSweepError):
    pass


class _GivenPair(NamedTuple):
    """A pair as given: `split` rings of D, then the rings of G, and the reference point."""

    rings: tuple[Loop, ...]
    split: int

    @classmethod
    def of(cls, case: Case) -> Self:
        d, g = case.directrix_rings, case.generatrix_rings
        return cls((*d, *g, (case.reference,)), len(d))

    def size(self) -> tuple[int, int, Fraction]:
        """Return the number of coordinates, their bits, and the sum of their absolute values."""
        numbers = [*chain(*chain(*self.rings))]
        bits = sum(c.numerator.bit_length() + c.denominator.bit_length() for c in numbers)
        return len(numbers), bits, sum(map(abs, numbers), Fraction(0))

    def replace(self, k: int, *ring: Loop) -> Self:
        rings = (*self.rings[:k], *ring, *self.rings[k + 1 :])
        return self._replace(rings=rings, split=self.split - (not ring and k < self.split))

    def map(
        self, function: Callable[[Fraction], Fraction], axes: str = "xy", which: slice = slice(None)
    ) -> Self:
        rings = list(self.rings)
        rings[which] = (
            tuple(p._replace(**{axis: function(getattr(p, axis)) for axis in axes}) for p in ring)
            for ring in rings[which]
        )
        return self._replace(rings=tuple(rings))

    def put_in_corner(self, which: slice) -> Self:
        """Move the lower left corner of a shape to the origin."""
        x, y = map(min, zip(*self.rings[which][0], strict=True))
        return self.map(lambda c: c - x, "x", which).map(lambda c: c - y, "y", which)


@explain_type_errors
def shrink(
    case: Case, judge: Callable[[Case], str], *, tries: int = 1000, seconds: float = 60.0
) -> Case:
    """Find a smaller case with the same fault, by at most `tries` calls of `judge`.

    `judge` returns the property of a case to preserve, such as its verdict; an exception ends the
    search. The id becomes "ID-shrunk", even if no smaller pair was found.

    Raises:
        ShrinkError: the verdict on the case is exact or equivalent.

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
    def __init__(
        self, case: Case, judge: Callable[[Case], str], fault: str, tries: int, deadline: float
    ) -> None:
        self._judge, self._fault = judge, fault
        self._tries, self._deadline = tries, deadline
        self._case = case
        self._pair = _GivenPair.of(case)
        self._size = self._pair.size()
        self._seen: set[_GivenPair] = set()
        self.best = self._make(self._pair)
        self._flags = {*case.flags, *self.best.flags}

    @property
    def is_over(self) -> bool:
        return self._tries <= 0 or time.monotonic() >= self._deadline

    def improve(self) -> bool:
        before = self._size
        for candidates in (_move, _remove, _shorten_all, _shorten_one):
            # Candidates depend on the current pair, so they start over after a change.
            while any(self._accept(pair) for pair in candidates(self._pair)):
                pass
        return self._size < before

    def _accept(self, pair: _GivenPair) -> bool:
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
        (d, *d_holes), (g, *g_holes) = pair.rings[: pair.split], pair.rings[pair.split : -1]
        return Case.of(
            f"{self._case.id}-shrunk",
            f"shrunk: {self._case.title}",
            d,
            g,
            pair.rings[-1][0],
            directrix_holes=d_holes,
            generatrix_holes=g_holes,
            inner_fit=self._case.inner_regions is not None,
        )


def _move(pair: _GivenPair) -> Iterator[_GivenPair]:
    """Canonicalize the rings, and move the reference point or a shape to the origin."""
    canonical = (Polygon(ring).vertices for ring in pair.rings[:-1])
    yield _GivenPair((*canonical, (ORIGIN,)), pair.split)
    yield pair.replace(len(pair.rings) - 1, (ORIGIN,))
    d, g = slice(pair.split), slice(pair.split, -1)
    yield pair.put_in_corner(d).put_in_corner(g)
    yield pair.put_in_corner(d)
    yield pair.put_in_corner(g)


def _remove(pair: _GivenPair) -> Iterator[_GivenPair]:
    for k, ring in enumerate(pair.rings[:-1]):
        if k not in (0, pair.split):
            yield pair.replace(k)
        length = len(ring) // 2
        while length:
            for start in range(0, len(ring), length):
                rest = ring[:start] + ring[start + length :]
                if len(rest) > 2:
                    yield pair.replace(k, rest)
            length //= 2


def _shorten_all(pair: _GivenPair) -> Iterator[_GivenPair]:
    """Shorten all numbers: to coprime integers, to fewer bits, or to their ranks on an axis."""
    numbers = [*chain(*chain(*pair.rings))]
    scale = lcm(*(c.denominator for c in numbers))
    common = gcd(*(int(c * scale) for c in numbers)) or 1
    yield pair.map(lambda c: c * scale / common)
    bits = max(abs(c.numerator) for c in numbers).bit_length()
    while bits:
        power = 2 ** (bits := bits // 2)
        yield pair.map(lambda c, power=power: Fraction(round(c / power)))  # type: ignore[misc]
    for axis in "xy":
        values = sorted({getattr(p, axis) for p in chain(*pair.rings)})
        yield pair.map({c: Fraction(k) for k, c in enumerate(values)}.__getitem__, axis)


def _shorten_one(pair: _GivenPair) -> Iterator[_GivenPair]:
    """Shorten one number, or all equal coordinates of a ring."""
    for k, ring in enumerate(pair.rings[:-1]):
        for axis in "xy":
            for value in sorted({getattr(p, axis) for p in ring}, key=abs, reverse=True):
                where = [j for j, p in enumerate(ring) if getattr(p, axis) == value]
                for other in _find_simpler(value):
                    for chosen in [where, *([j] for j in where if len(where) > 1)]:
                        moved = list(ring)
                        for j in chosen:
                            moved[j] = ring[j]._replace(**{axis: other})
                        yield pair.replace(k, tuple(moved))


def _find_simpler(value: Fraction) -> list[Fraction]:
    found = [Fraction(0), Fraction(round(value)), Fraction(int(value / 2))]
    if abs(value) < 32:
        found.append(value - 1 if value > 0 else value + 1)
    return [other for other in dict.fromkeys(found) if other != value]
