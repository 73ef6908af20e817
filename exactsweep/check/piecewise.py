"""Functions of one variable that are linear in pieces, and the least of their sums."""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple


class Piece(NamedTuple):
    """A linear function on the open interval (x0, x1); y0 and y1 are its limits at the ends."""

    x0: Fraction
    y0: Fraction
    x1: Fraction
    y1: Fraction

    def at(self, x: Fraction) -> Fraction:
        """The value at x, or the limit if x is an end."""
        if x == self.x1:
            return self.y1
        return self.y0 + (self.y1 - self.y0) * (x - self.x0) / (self.x1 - self.x0)


# A function of x: pieces from left to right, each beginning where the last one ends. Two limits
# that differ at a common end are a vertical edge; a value at one x alone is never represented,
# because the loops bound regular closed sets.
Function = tuple[Piece, ...]


def mirror(function: Iterable[Piece]) -> Function:
    """The function with the sign of its values changed."""
    return tuple(Piece(x0, -y0, x1, -y1) for x0, y0, x1, y1 in function)


def ends(function: Function) -> set[tuple[Fraction, Fraction]]:
    """The breakpoints with the limits there: one where the function goes on, two at a jump."""
    return {end for p in function for end in ((p.x0, p.y0), (p.x1, p.y1))}


def piece_over(function: Function, x: Fraction) -> Piece | None:
    """The piece whose open interval holds x, for an x that is no breakpoint."""
    k = bisect_right(function, x, key=lambda p: p.x0) - 1
    return function[k] if k >= 0 and x < function[k].x1 else None


def least_sum(
    f: Function, g: Function, within: tuple[Fraction, Fraction] | None = None
) -> Function:
    """Take the function x -> min over u of f(u) + g(x - u), all of it or between two cuts.

    For x strictly between two consecutive sums of breakpoints, no breakpoint of f meets one of
    g, so the minimum is attained at a breakpoint of one inside a piece of the other, in the limit
    from one side: it is the lower envelope of g's pieces moved by f's breakpoints, and of f's
    moved by g's.
    """
    moved = [
        Piece(x0 + x, y0 + y, x1 + x, y1 + y)
        for fixed, other in ((f, g), (g, f))
        for x, y in ends(fixed)
        for x0, y0, x1, y1 in other
    ]
    cuts = sorted({x for piece in moved for x in (piece.x0, piece.x1)})
    starting = defaultdict(list)
    for piece in moved:
        starting[piece.x0].append(piece)
    over: list[tuple[Piece, Fraction]] = []  # the pieces over the interval, each at its left
    result: list[Piece] = []
    for left, right in pairwise(cuts):
        over = [(piece, y) for piece, y in over if piece.x1 > left]
        over += [(piece, piece.y0) for piece in starting[left]]
        ahead = [(piece, piece.at(right)) for piece, _ in over]
        if within is None or (within[0] <= left and right <= within[1]):
            lines = [(y, end) for (_, y), (_, end) in zip(over, ahead, strict=True)]
            for part in _lower_envelope(left, right, lines):
                if result and _one_line(result[-1], part):
                    result[-1] = Piece(*result[-1][:2], *part[2:])
                else:
                    result.append(part)
        over = ahead
    return tuple(result)


def _one_line(p: Piece, q: Piece) -> bool:
    slopes_agree = (p.y1 - p.y0) * (q.x1 - q.x0) == (q.y1 - q.y0) * (p.x1 - p.x0)
    return p.y1 == q.y0 and slopes_agree


def _lower_envelope(
    left: Fraction, right: Fraction, lines: list[tuple[Fraction, Fraction]]
) -> Iterator[Piece]:
    """The lowest of some lines over an interval; a line is its heights at left and right."""
    line = min(lines)
    x, y = left, line[0]
    # Invariant: `line` is lowest just right of x, so it is first left by a line that ends lower.
    while lower := [rival for rival in lines if rival[1] < line[1]]:
        share, _, rival = min(
            ((r[0] - line[0]) / (r[0] - line[0] + line[1] - r[1]), r[1], r) for r in lower
        )
        corner = left + share * (right - left), line[0] + share * (line[1] - line[0])
        yield Piece(x, y, *corner)
        (x, y), line = corner, rival
    yield Piece(x, y, right, line[1])
