"""Where stretches of contact lines cross, and on which sides of each other they go on."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor

from exactsweep.procedures.contact_lines import Stretch

_UNITS = 2**32
_NEITHER = False, False


def cut_at_crossings(stretches: Sequence[Stretch]) -> None:
    """Note in all stretches where they cross or touch those of other lines.

    Cost: O(k^2) at worst for k stretches.
    """
    boxes = sorted((*_bound(stretch), k) for k, stretch in enumerate(stretches))
    active: list[tuple[int, int, int, int, int]] = []
    for box in boxes:
        left, _, low, high, k = box
        active = [other for other in active if other[1] >= left]
        stretch = stretches[k]
        for _, _, other_low, other_high, other in active:
            if other_low <= high and low <= other_high:
                cross(stretch, stretches[other])
        active.append(box)


def _bound(stretch: Stretch) -> tuple[int, int, int, int]:
    """Bounds of a stretch, rounded outwards to ints: left, right, low, high."""
    dx, dy, c, (low, _), (high, _) = stretch.dx, stretch.dy, stretch.c, stretch.low, stretch.high
    if dx == 0:
        return floor(-c), ceil(-c), floor(low), ceil(high)
    first, last = low * dy + c, high * dy + c
    if dy < 0:
        first, last = last, first
    return floor(low), ceil(high), int(first // dx), int(-(-last // dx))


def cross(first: Stretch, second: Stretch) -> None:
    """Note in two stretches where they cross or touch, unless they are parallel. Cost: O(1)."""
    adx, ady, ac = first.dx, first.dy, first.c
    bdx, bdy, bc = second.dx, second.dy, second.c
    turn = adx * bdy - ady * bdx
    if turn == 0:
        return
    d = abs(turn)
    if adx and bdx:
        n = m = ac * bdx - bc * adx if turn > 0 else bc * adx - ac * bdx
    else:
        # One of them is vertical, and its places are values of y.
        x, y = ac * bdx - bc * adx, ac * bdy - bc * ady
        n, m = x if adx else y, x if bdx else y
        if turn < 0:
            n, m = -n, -m
    low, high, other_low, other_high = first.low[0], first.high[0], second.low[0], second.high[0]
    if n < low * d or n > high * d or m < other_low * d or m > other_high * d:
        return
    # There is overlap all around on the sides of what runs through.
    a_left, a_right = first.left, first.right
    if n == low * d:
        a_left, a_right = first.low_through or _NEITHER
    elif n == high * d:
        a_left, a_right = first.high_through or _NEITHER
    b_left, b_right = second.left, second.right
    if m == other_low * d:
        b_left, b_right = second.low_through or _NEITHER
    elif m == other_high * d:
        b_left, b_right = second.high_through or _NEITHER
    if turn < 0:
        # The first goes from the right of the second to its left, and so on.
        a_left, a_right, b_left, b_right = a_right, a_left, b_right, b_left
    twice = second.left and second.right
    first.cuts.append((int((n * _UNITS) // d), (n, d), b_left, b_right, twice))
    twice = first.left and first.right
    second.cuts.append((int((m * _UNITS) // d), (m, d), a_right, a_left, twice))
