"""The crossings of contact segments, and the remaining pieces between them.

Boxes of segments that intersect (`geometry.near`) give the crossings; each removes pieces next to
it, without any test of a position.

(1) A piece of a segment between two consecutive crossings is either all free or all in O. If
    another segment crosses an end of the piece, and overlap passes through that end on the side
    where the piece lies, the piece is in O, by (2) of `segments`.
(2) Each remaining piece bounds a free region on its right; or it is an exact fit, if it has overlap
    on both sides; or it is in O after all.
(3) A single free position is surrounded by overlap. So every direction lies left of some
    contact segment through it: three lines or more, or two with segments in both directions.

The *key* of a parameter n / d is (n << bits) // d, with enough bits that different parameters of
one line have different keys. So keys and parameters have the same order.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd
from typing import NamedTuple

from exactsweep.geometry.frame import HomogeneousPoint
from exactsweep.geometry.near import find_near
from exactsweep.procedures.chain import Line
from exactsweep.procedures.segments import BOTH, ContactSegment, Sides

OneSidedPiece = tuple[HomogeneousPoint, HomogeneousPoint, int, int]
"""A piece with overlap on its left: its start, its end, its direction."""

TwoSidedPiece = tuple[Line, HomogeneousPoint, HomogeneousPoint]
"""A piece with overlap on both sides: its line, its lower and its upper end."""


_Parameter = tuple[int, int]
"""A parameter n / d, d > 0."""


class Pieces(NamedTuple):
    """The remaining pieces by (2), and the points that may be single free positions by (3)."""

    one_sided: list[OneSidedPiece]
    two_sided: list[TwoSidedPiece]
    meetings: set[HomogeneousPoint]


def cut(segments: Sequence[ContactSegment]) -> Pieces:
    """Cut segments at their crossings, and drop pieces in O, by (1).

    Cost: as for `find_near`, plus O(c log c) for c crossings.
    """
    pieces = Pieces([], [], set())
    bits = measure_keys(segments)
    for k, j in find_near([segment.box for segment in segments]):
        record_crossing(segments[k], segments[j], bits)
    for segment in segments:
        dx, dy, _ = segment.line
        for p, q in _find_remaining(segment, pieces.meetings):
            if segment.sides == BOTH:
                pieces.two_sided.append((segment.line, p, q))
            elif segment.sides[0]:
                pieces.one_sided.append((p, q, dx, dy))
            else:
                pieces.one_sided.append((q, p, -dx, -dy))
    return pieces


def measure_keys(segments: Sequence[ContactSegment]) -> int:
    """Compute the keys of the ends of segments; return the number of bits of keys."""
    longest = at_ends = 1
    for segment in segments:
        dx, dy, _ = segment.line
        longest |= dx | abs(dy)
        at_ends |= segment.low.denominator | segment.high.denominator
    # Bitwise or has the length of the longest number. Crossings have denominators of at most
    # 2 longest^2.
    bits = 2 * max(1 + 2 * longest.bit_length(), at_ends.bit_length())
    for segment in segments:
        (n, d), (m, e) = segment.low.as_integer_ratio(), segment.high.as_integer_ratio()
        segment.keys = (n << bits) // d, (m << bits) // e
    return bits


def record_crossing(first: ContactSegment, second: ContactSegment, bits: int) -> None:
    """Record a crossing in both segments, with the sides on which overlap passes there."""
    (adx, ady, ac), (bdx, bdy, bc) = first.line, second.line
    d = adx * bdy - ady * bdx
    if d <= 0:
        if d < 0:
            record_crossing(second, first, bits)
        return
    x, y = ac * bdx - bc * adx, ac * bdy - bc * ady
    n, m = x if adx else y, x if bdx else y
    key, (low, high) = (n << bits) // d, first.keys
    if key < low or key > high:
        return
    other_key, (other_low, other_high) = (m << bits) // d, second.keys
    if other_key < other_low or other_key > other_high:
        return
    a, b = _find_sides(first, key), _find_sides(second, other_key)
    # The second segment goes from the right of the first to its left.
    first.cuts.append((key, n, d, b[0], b[1], second.sides))
    second.cuts.append((other_key, m, d, a[1], a[0], first.sides))


def _find_sides(segment: ContactSegment, key: int) -> Sides:
    """Return the sides on which overlap passes through a point of a segment."""
    low, high = segment.keys
    return segment.low_sides if key == low else segment.high_sides if key == high else segment.sides


def _find_remaining(
    segment: ContactSegment, meetings: set[HomogeneousPoint]
) -> list[tuple[HomogeneousPoint, HomogeneousPoint]]:
    """Return the ends of the pieces that remain by (1), and add points to the meetings by (3)."""
    line, is_two_sided = segment.line, segment.sides == BOTH
    remaining: list[tuple[_Parameter, _Parameter]] = []
    # The last place passed: its parameter `start`, its key `at`, and whether a crossing there
    # proves the piece after it in O. The piece before it waits, since further crossings at the same
    # place may prove it in O.
    waiting: tuple[_Parameter, _Parameter] | None = None
    start, (at, end), covered = segment.low.as_integer_ratio(), segment.keys, False
    last: int | None = None
    for key, n, d, before, after, other_sides in sorted(segment.cuts):
        if key == last or (is_two_sided and other_sides == BOTH):  # (3)
            meetings.add(find_point(line, n, d))
        last = key
        if key > at:
            if waiting:
                remaining.append(waiting)
            waiting = None if covered or before else (start, (n, d))  # (1)
            start, at, covered = (n, d), key, after
        else:
            waiting = None if before else waiting
            covered = covered or after
    if waiting:
        remaining.append(waiting)
    if at < end and not covered:
        remaining.append((start, segment.high.as_integer_ratio()))
    return [(find_point(line, *p), find_point(line, *q)) for p, q in remaining]


def find_point(line: Line, n: int, d: int) -> HomogeneousPoint:
    """Return the point on a line at parameter n / d, in lowest terms."""
    dx, dy, c = line
    x, y, w = (n * dx, n * dy + c * d, dx * d) if dx else (-c * d, n * dy, dy * d)
    common = gcd(x, y, w)
    return x // common, y // common, w // common
