"""Exact fits of monotone pairs, in slots of D exactly as wide as G.

In an exact fit, G touches D without overlap, but a shift to either side causes overlap. Such
positions are not on the boundary of the no-fit polygon, which is a regular set; but they satisfy
Definition 1.1, which requires only contact and disjoint interiors. From below, at x0, the heights
are

    max(T(x0-), T(x0+))  <  y  <=  least limit of D_b(a) - G_t(a - x0) over the open common x-range.

D confines G on both sides only if two discontinuities of D meet two of G at x0; each is a vertical
edge or an end of a polygon. All fits of monotone pairs are segments of positive length.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Sequence
from itertools import pairwise
from operator import itemgetter

from exactsweep.numbers.number import Edge, Rational, Vertex, ratio
from exactsweep.procedures.chain import Chain, inverse


def find_exact_fits(
    generatrix: Chain, directrix: Chain, trajectory: Chain
) -> list[tuple[Vertex, Vertex]]:
    """Find the exact fits of G_t from below in D_b, by x, for reversed G_t and D_b.

    Each is a pair: the end on the trajectory, the end inside the slot. Cost: O(d g) for d and g
    discontinuities, plus the number of overlapping edges at each x0 at which two pairs meet.

    >>> from exactsweep.procedures.cm import trajectory_cm
    >>> slot = Chain.of([(0, 0), (1, 0), (1, 2), (2, 2), (2, 0), (3, 0)])
    >>> lid = Chain.of([(-1, 0), (0, 0)])
    >>> find_exact_fits(lid, slot, trajectory_cm(lid, slot).chain())
    [((1, 0), (1, 2))]
    """
    g, d = inverse(generatrix)[::-1], directrix.points
    shifts = Counter(p - q for p in _discontinuities(d) for q in _discontinuities(g))
    meetings = sorted(x for x, count in shifts.items() if count > 1)
    if not meetings:
        return []
    path, top, bottom = trajectory.points, list_edges(g), list_edges(d)
    fits: list[tuple[Vertex, Vertex]] = []
    for x in meetings:
        hanging, limit = _find_greatest(path, x), _least_height(top, bottom, x)
        if limit > hanging:
            fits.append(((x, hanging), (x, limit)))
    return fits


def list_edges(chain: Sequence[Vertex]) -> list[Edge]:
    """List the edges of a chain that are not vertical."""
    return [(p, q) for p, q in pairwise(chain) if p[0] != q[0]]


def evaluate(edge: Edge, x: Rational) -> Rational:
    """Return the height of an edge at x."""
    (px, py), (qx, qy) = edge
    return py if x == px else qy if x == qx else py + ratio((qy - py) * (x - px), qx - px)


def _find_greatest(chain: Sequence[Vertex], x: Rational) -> Rational:
    first, after = (side(chain, x, key=itemgetter(0)) for side in (bisect_left, bisect_right))
    if first == after:
        return evaluate((chain[first - 1], chain[first]), x)
    return max(chain[first][1], chain[after - 1][1])


def _discontinuities(chain: Sequence[Vertex]) -> set[Rational]:
    """Find where a chain, as a function of x, jumps or ends."""
    ends = {chain[0][0], chain[-1][0]}
    return ends | {p[0] for p, q in pairwise(chain) if p[0] == q[0]}


def _least_height(top: Sequence[Edge], bottom: Sequence[Edge], shift: Rational) -> Rational:
    """Return the least limit of D_b(a) - G_t(a - shift) over the open common x-range."""
    heights: list[Rational] = []
    i = bisect_right(top, bottom[0][0][0] - shift, key=lambda edge: edge[1][0])
    j = bisect_right(bottom, top[0][0][0] + shift, key=lambda edge: edge[1][0])
    while i < len(top) and j < len(bottom):
        (gp, gq), (dp, dq) = top[i], bottom[j]
        low, high = max(gp[0] + shift, dp[0]), min(gq[0] + shift, dq[0])
        for x in low, high:
            heights.append(evaluate(bottom[j], x) - evaluate(top[i], x - shift))
        i += gq[0] + shift == high
        j += dq[0] == high
    return min(heights)
