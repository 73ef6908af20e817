"""Crossings of stretches of contact lines, with the sides on which the stretches continue."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf

from exactsweep.procedures.contact_lines import Stretch

_UNIT_BITS = 32
_NEITHER = False, False
_NumberedBox = tuple[int, int, int, int, int]
"""The bounds of a stretch, rounded outwards, and its number: left, right, low, high, number."""
_IN_BAND = 1000
"""The number of stretches in each horizontal band, if all were short."""
_DROPPED_AFTER = 8
"""After so many boxes, those that are further left are dropped together."""


def cut_at_crossings(stretches: Sequence[Stretch]) -> None:
    """Record in all stretches their crossings and contacts with stretches of other lines.

    Cost: O(k^2) at worst for k stretches.
    """
    boxes = sorted([(*stretch.bound(), k) for k, stretch in enumerate(stretches)])
    if len(boxes) <= _IN_BAND:
        _cut_in_band(stretches, boxes, -inf)
        return
    bottom, top = min(box[2] for box in boxes), max(box[3] for box in boxes)
    height = (top - bottom) // (len(boxes) // _IN_BAND + 1) + 1
    for floor in range(bottom, top + 1, height):
        band = [box for box in boxes if box[2] < floor + height and box[3] >= floor]
        _cut_in_band(stretches, band, floor)


def _cut_in_band(stretches: Sequence[Stretch], boxes: Sequence[_NumberedBox], floor: float) -> None:
    """Cut stretches at crossings, except for pairs whose boxes also meet below the floor."""
    active: list[_NumberedBox] = []
    for step, box in enumerate(boxes):
        left, _, low, high, k = box
        if step % _DROPPED_AFTER == 0:
            active = [other for other in active if other[1] >= left]
        stretch = stretches[k]
        for _, other_right, other_low, other_high, other in active:
            if (
                other_low <= high
                and low <= other_high
                and left <= other_right
                and (low >= floor or other_low >= floor)
            ):
                cross(stretch, stretches[other])
        active.append(box)


def cross(first: Stretch, second: Stretch) -> None:
    """Record in two stretches where they meet, unless they are parallel. Cost: O(1)."""
    adx, ady, ac = first.dx, first.dy, first.c
    bdx, bdy, bc = second.dx, second.dy, second.c
    turn = adx * bdy - ady * bdx
    if turn == 0:
        return
    d = abs(turn)
    if first.e != 1 or second.e != 1:
        ac, bc, d = ac * second.e, bc * first.e, d * first.e * second.e
    if adx and bdx:
        n = m = ac * bdx - bc * adx if turn > 0 else bc * adx - ac * bdx
    else:
        # One of them is vertical, and its places are values of y.
        x, y = ac * bdx - bc * adx, ac * bdy - bc * ady
        n, m = x if adx else y, x if bdx else y
        if turn < 0:
            n, m = -n, -m
    # The distances past the ends, times positive numbers.
    (low, below), (high, above) = first.low, first.high
    past_low, to_high = n * below - low * d, high * d - n * above
    if past_low < 0 or to_high < 0:
        return
    (low, below), (high, above) = second.low, second.high
    past_other_low, to_other_high = m * below - low * d, high * d - m * above
    if past_other_low < 0 or to_other_high < 0:
        return
    # A segment that runs through has overlap on its left, on both sides of the crossing.
    a_left, a_right = first.left, first.right
    if past_low == 0:
        a_left, a_right = first.low_through or _NEITHER
    elif to_high == 0:
        a_left, a_right = first.high_through or _NEITHER
    b_left, b_right = second.left, second.right
    if past_other_low == 0:
        b_left, b_right = second.low_through or _NEITHER
    elif to_other_high == 0:
        b_left, b_right = second.high_through or _NEITHER
    if turn < 0:
        # The first stretch goes from the right of the second to its left: exchange the sides.
        a_left, a_right, b_left, b_right = a_right, a_left, b_right, b_left
    twice = second.left and second.right
    first.cuts.append(((n << _UNIT_BITS) // d, (n, d), b_left, b_right, twice))
    twice = first.left and first.right
    second.cuts.append(((m << _UNIT_BITS) // d, (m, d), a_right, a_left, twice))
