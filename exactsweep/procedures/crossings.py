"""Crossings of stretches of contact lines, with the sides on which the stretches continue."""

from __future__ import annotations

from collections.abc import Sequence

from exactsweep.geometry.near import find_near
from exactsweep.procedures.contact_lines import Stretch

_UNIT_BITS = 32
_NEITHER = False, False


def cut_at_crossings(stretches: Sequence[Stretch]) -> None:
    """Record in all stretches their crossings and contacts with stretches of other lines.

    Cost: that of `find_near`; O(k^2) at worst for k stretches.
    """
    for k, j in find_near([stretch.bound() for stretch in stretches]):
        cross(stretches[k], stretches[j])


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
