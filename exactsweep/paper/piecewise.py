"""Piecewise linear functions of one variable, and their min-plus convolution."""

from collections import defaultdict
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import pairwise
from math import lcm
from typing import NamedTuple

from exactsweep.check.cone import divide
from exactsweep.numbers.number import Rational


class LinearPiece(NamedTuple):
    """A linear function on the open interval (x0, x1); y0 and y1 are its limits at the ends."""

    x0: Rational
    y0: Rational
    x1: Rational
    y1: Rational

    def at(self, x: Rational) -> Rational:
        """Return the value at x, or the limit at an end."""
        if x == self.x0 or self.y0 == self.y1:
            return self.y0
        if x == self.x1:
            return self.y1
        return self.y0 + divide((self.y1 - self.y0) * (x - self.x0), self.x1 - self.x0)


# A function of x: adjacent pieces from left to right. Different limits at a common end form a
# vertical edge. Isolated values cannot occur, because loops bound regular closed sets.
PiecewiseLinear = tuple[LinearPiece, ...]


class _ScaledLine(NamedTuple):
    """The line y = slope * x + constant, with y in a unit that makes both ints."""

    slope: int
    constant: int

    def at(self, x: Rational) -> Rational:
        return self.slope * x + self.constant


def mirror(function: Iterable[LinearPiece]) -> PiecewiseLinear:
    return tuple(LinearPiece(x0, -y0, x1, -y1) for x0, y0, x1, y1 in function)


def list_ends(function: Iterable[LinearPiece]) -> set[tuple[Rational, Rational]]:
    """Return the breakpoints with their limits: one if continuous, two at a jump."""
    return {end for x0, y0, x1, y1 in function for end in ((x0, y0), (x1, y1))}


def min_plus_convolution(
    f: PiecewiseLinear, g: PiecewiseLinear, within: tuple[Rational, Rational] | None = None
) -> PiecewiseLinear:
    """Compute the function x -> min over u of f(u) + g(x - u), everywhere or between two cuts.

    Between two consecutive sums of breakpoints, a breakpoint of one function attains the minimum
    inside a piece of the other, as a one-sided limit. So the result is the lower envelope of g's
    pieces moved by f's breakpoints, and of f's pieces moved by g's breakpoints.
    """
    unit = lcm(*(c.denominator for function in (f, g) for piece in function for c in piece))
    scaled = [[[int(c * unit) for c in piece] for piece in function] for function in (f, g)]
    fine = lcm(*(x1 - x0 for function in scaled for x0, _, x1, _ in function))
    starting: dict[int, set[tuple[_ScaledLine, int]]] = defaultdict(set)
    cuts: set[int] = set()
    for fixed, other in (scaled, scaled[::-1]):
        corners = {end for x0, y0, x1, y1 in fixed for end in ((x0, y0), (x1, y1))}
        for x0, y0, x1, y1 in other:
            slope = (y1 - y0) * (fine // (x1 - x0))
            for x, y in corners:
                line = _ScaledLine(slope, (y0 + y) * fine - slope * (x0 + x))
                starting[x0 + x].add((line, x1 + x))
                cuts.update((x0 + x, x1 + x))
    over: set[tuple[_ScaledLine, int]] = set()  # pieces over the interval, with their right ends
    found: list[tuple[_ScaledLine, Rational]] = []  # lowest lines, with their left ends
    last: Rational = 0
    for left, right in pairwise(sorted(cuts)):
        over = {entry for entry in over if entry[1] > left} | starting[left]
        if within is None or (within[0] * unit <= left and right <= within[1] * unit):
            last = right
            for lowest in _lower_envelope(left, right, {line for line, _ in over}):
                if not found or found[-1][0] != lowest[0]:
                    found.append(lowest)
    stops = [x for _, x in found[1:]] + [last]
    return tuple(
        LinearPiece(
            divide(x0, unit),
            divide(line.at(x0), fine * unit),
            divide(x1, unit),
            divide(line.at(x1), fine * unit),
        )
        for (line, x0), x1 in zip(found, stops, strict=True)
    )


def _lower_envelope(
    left: int, right: int, lines: Iterable[_ScaledLine]
) -> Iterator[tuple[_ScaledLine, Rational]]:
    """Yield the lower envelope of some lines over an interval, as lines with their left ends."""
    _, _, line = min((line.at(left), line.slope, line) for line in lines)
    yield line, left
    # Invariant: `line` is lowest just right of its left end. The first crossing with a line that
    # is lower at the right end comes next; among several there, the steepest descent wins.
    end = line.at(right)
    while lower := [rival for rival in lines if rival.at(right) < end]:
        x, _, line = min(
            (Fraction(rival.constant - line.constant, line.slope - rival.slope), rival.slope, rival)
            for rival in lower
        )
        yield line, x
        end = line.at(right)
