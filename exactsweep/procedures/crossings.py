"""Where stretches of contact lines cross, and on which sides of each other they go on."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor

from exactsweep.geometry.number import quotient
from exactsweep.procedures.contact_lines import Cut, Stretch


def cut_at_crossings(stretches: Sequence[Stretch]) -> None:
    """Note in all stretches where they cross or touch those of other lines.

    Cost: O(k^2) at worst for k stretches.
    """
    boxes = sorted((*_box(stretch), k) for k, stretch in enumerate(stretches))
    active: list[tuple[int, int, int, int, int]] = []
    for box in boxes:
        left, _, low, high, k = box
        active = [other for other in active if other[1] >= left]
        stretch = stretches[k]
        for _, _, other_low, other_high, other in active:
            if other_low <= high and low <= other_high:
                cross(stretch, stretches[other])
        active.append(box)


def _box(stretch: Stretch) -> tuple[int, int, int, int]:
    """Bounds of a stretch, rounded outwards to ints: left, right, low, high."""
    dx, dy, c, low, high = stretch.dx, stretch.dy, stretch.c, stretch.low, stretch.high
    if dx == 0:
        return floor(-c), ceil(-c), floor(low), ceil(high)
    first, last = low * dy + c, high * dy + c
    if dy < 0:
        first, last = last, first
    return floor(low), ceil(high), int(first // dx), int(-(-last // dx))


def cross(first: Stretch, second: Stretch) -> None:
    """Note in two stretches where they cross or touch, unless they are parallel.  Cost: O(1)."""
    adx, ady, ac = first.dx, first.dy, first.c
    bdx, bdy, bc = second.dx, second.dy, second.c
    turn = adx * bdy - ady * bdx
    if turn == 0:
        return
    x, y = ac * bdx - bc * adx, ac * bdy - bc * ady
    if turn < 0:
        x, y, d = -x, -y, -turn
    else:
        d = turn
    n, m = x if adx else y, x if bdx else y
    if n < first.low * d or n > first.high * d or m < second.low * d or m > second.high * d:
        return
    place, other_place = quotient(n, d), quotient(m, d)
    a_left, a_right = _sides(first, place)
    b_left, b_right = _sides(second, other_place)
    if turn < 0:
        # The first goes from the right of the second to its left.
        b_left, b_right = b_right, b_left
        a_left, a_right = a_right, a_left
    first.cuts.append(Cut(place, b_left, b_right, second.left and second.right))
    second.cuts.append(Cut(other_place, a_right, a_left, first.left and first.right))


def _sides(stretch: Stretch, place: object) -> tuple[bool, bool]:
    """On which sides of a stretch there is overlap all around a point of it."""
    if place == stretch.low:
        return stretch.low_through or (False, False)
    if place == stretch.high:
        return stretch.high_through or (False, False)
    return stretch.left, stretch.right
