"""Exact fits from the definition, at the few places where there can be one.

At x the lower halves of D and I(G), as functions A and B, leave G free to slide up as far as the
least A(u) + B(x - u) inside intervals without breakpoints; what is beyond both one-sided limits of
T = min A + B at x is an exact fit. Where A and B jump at u and x - u, the two limits of T
count one more pair each: just right of x both values after falling, just left of x both values
before rising. To come below the fit, each needs such a pair. So there are a sum of two falls and a
sum of two rises at x, the ends of A and B being a fall from infinity and a rise to it.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise

from exactsweep.check.chain import LowerChain, Node, walk_heights
from exactsweep.check.loop import MonotoneLoop, NodeFrame
from exactsweep.geometry.point import Fit


def list_exact_fits(directrix: MonotoneLoop, inverse: MonotoneLoop, frame: NodeFrame) -> list[Fit]:
    """List the exact fits of the sweep (G, D), as translations.

    Args:
        directrix: D, on the lattice.
        inverse: I(G), likewise.
        frame: to leave the lattice.

    Returns:
        sorted list of pairs of Point, the end that hangs on the trajectory first.

    Cost: O(mn) for pairs of jumps, O(m + n) for each place that is left.
    Source: as `exactsweep.check.reference_exact_fits`.
    """
    fits = []
    for sign, a, b in zip((1, -1), directrix.halves, inverse.halves, strict=True):
        for x, *ends in _lower_fits(a, b):
            hanging, inner = (
                frame.leave((sign * x * y.denominator, sign * y.numerator, y.denominator))
                for y in ends
            )
            fits.append((hanging, inner))
    return sorted(fits)


def _lower_fits(a: LowerChain, b: LowerChain) -> Iterator[tuple[int, Fraction, Fraction]]:
    """Triples x, y on the trajectory, y at the inner end."""
    (a_falls, a_rises), (b_falls, b_rises) = _jumps(a), _jumps(b)
    falls = {x + z for x in a_falls for z in b_falls}
    rises = {x + z for x in a_rises for z in b_rises}
    for x in falls & rises:
        hanging = max(_least(a, b, x, -1), _least(a, b, x, 1))
        limit = _least(a, b, x, 0)
        if hanging < limit:
            yield x, hanging, limit


def _jumps(chain: LowerChain) -> tuple[list[int], list[int]]:
    falls, rises = [chain.edges[0][0][0]], [chain.edges[-1][1][0]]
    for (_, (x, before_y, _), _), ((_, after_y, _), _, _) in pairwise(chain.edges):
        if before_y != after_y:
            (falls if after_y < before_y else rises).append(x)
    return falls, rises


def _least(a: LowerChain, b: LowerChain, x: int, side: int) -> Fraction:
    origin: Node = (x, 0, 1)
    return min(Fraction(*height) for height in walk_heights(a, b, origin, side))
