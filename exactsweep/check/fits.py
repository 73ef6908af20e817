"""Exact fits from the definition, at the few places where there can be one.

At x the lower halves of D and I(G), as functions A and B, leave G free to slide up as far as the
least A(u) + B(x - u) inside intervals without breakpoints; the part beyond both one-sided limits of
T = min A + B at x is an exact fit. Where A and B jump at u and x - u, the two limits of T
count one more pair each: just right of x both values after falling, just left of x both values
before rising. To come below the fit, each needs such a pair. So there are a sum of two falls and a
sum of two rises at x, the ends of A and B being a fall from infinity and a rise to it.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from exactsweep.check.chain import LowerChain, Node, walk_heights
from exactsweep.check.loop import MonotoneLoop, NodeFrame
from exactsweep.numbers.point import Fit, Rational


class FitPlace(NamedTuple):
    """A possible place of an exact fit: a sum of two falls and of two rises.

    Attributes:
        sign: 1 of the lower chains, -1 of the upper ones, which are turned.
        directrix, inverse: the chains.
        x: the place.
    """

    sign: int
    directrix: LowerChain
    inverse: LowerChain
    x: Rational


def count_pairs(directrix: MonotoneLoop, inverse: MonotoneLoop) -> int:
    """Count the pairs of jumps that `find_places` goes through; in time O(m + n)."""
    halves = zip(directrix.halves, inverse.halves, strict=True)
    jumps = [(_jumps(a), _jumps(b)) for a, b in halves]
    return sum(len(one) * len(other) for a, b in jumps for one, other in zip(a, b, strict=True))


def find_places(directrix: MonotoneLoop, inverse: MonotoneLoop) -> list[FitPlace]:
    """Find all places at which there may be an exact fit.

    Args:
        directrix: D.
        inverse: I(G), likewise.

    Returns:
        list of FitPlace.

    Cost: O(m + n + `count_pairs`).
    """
    found = []
    for sign, a, b in zip((1, -1), directrix.halves, inverse.halves, strict=True):
        (a_falls, a_rises), (b_falls, b_rises) = _jumps(a), _jumps(b)
        falls = {x + z for x in a_falls for z in b_falls}
        rises = {x + z for x in a_rises for z in b_rises}
        found += [FitPlace(sign, a, b, x) for x in falls & rises]
    return found


def list_exact_fits(places: Iterable[FitPlace], frame: NodeFrame) -> list[Fit]:
    """List the exact fits of the sweep (G, D), as translations.

    Args:
        places: as `find_places` found them.
        frame: to leave the lattice.

    Returns:
        sorted list of pairs of Point, the end that hangs on the trajectory first.

    Cost: O(m + n) for each place.
    Source: as `exactsweep.check.reference_exact_fits`.
    """
    fits = []
    for sign, a, b, x in places:
        hanging = max(_least(a, b, x, -1), _least(a, b, x, 1))
        inner = _least(a, b, x, 0)
        if hanging < inner:
            n, w = x.as_integer_ratio()
            first, last = (
                frame.leave((sign * n * e, sign * y.numerator * w, w * e))
                for y in (hanging, inner)
                for e in (y.denominator,)
            )
            fits.append((first, last))
    return sorted(fits)


def _jumps(chain: LowerChain) -> tuple[list[Rational], list[Rational]]:
    falls, rises = [_take_x(chain.edges[0][0])], [_take_x(chain.edges[-1][1])]
    for (_, before, _), (after, _, _) in pairwise(chain.edges):
        rise = after[1] * before[2] - before[1] * after[2]
        if rise:
            (falls if rise < 0 else rises).append(_take_x(before))
    return falls, rises


def _take_x(node: Node) -> Rational:
    x, _, w = node
    return x if w == 1 else Fraction(x, w)


def _least(a: LowerChain, b: LowerChain, x: Rational, side: int) -> Fraction:
    n, w = x.as_integer_ratio()
    origin: Node = (n, 0, w)
    return min(Fraction(*height) for height in walk_heights(a, b, origin, side))
