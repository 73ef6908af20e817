"""Nothing goes beyond a loop: a sum of two regions is held by the region of a loop.

Lemma. Let A, B and Q be simple polygons, all weakly monotone to x. A corner of a lower chain *has*
the slopes of the lines through it that the chain near it is not below: from that of the edge before
it to that of the edge after it, from minus infinity at the first corner, to infinity at the last.
It is convex if it has more than one. If

(a) a + b is in Q for all corners a of A and b of B that have more than one slope in common, and
(b) at every concave corner o of Q the boundary of A + B keeps to the inner side of o: in the limit
    from a side on which the boundary of Q goes on from o without a vertical edge,

both for the lower chains and, turned by half a turn, for the upper ones, then A + B is in Q.

Proof, for the lower halves: Q is above the chain q; A + B is above s(x) = min A(u) + B(x - u).

A convex corner of s is one of the sums of (a). It is a sum a + b, and s is nowhere above A moved by
b, nor above B moved by a, which pass through a + b, too. So a has all slopes that a + b has, and so
has b. The ends of s and the bottoms of its vertical edges are convex corners, so by (a) they are in
Q; also, A + B is in the range of x of Q.

Suppose q - s is positive somewhere. Take its greatest one-sided limit, at x from side i.

- s jumps or ends at x. If i is the lower side of the jump, (x, s) is a convex corner and in Q; so
  q jumps, too, and i is its higher side, which (b) rules out. If i is the higher side, q must jump
  by as much to the same side, or q - s would be greater on the other side; (b) again.
- Only q jumps: the limit is greatest on the higher side of q; (b).
- Neither jumps. By (a) s is not convex at x, by (b) q is not concave; so q - s is convex near x,
  and greatest there, hence constant. Go on to the next corner, where this holds again; at the
  latest the end of s is reached, where it cannot be.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from exactsweep.check.certificate import CertificateError
from exactsweep.check.chain import (
    ChainCorner,
    Line,
    LowerChain,
    Node,
    add_nodes,
    put_longer_first,
    turn,
    walk_heights,
)
from exactsweep.check.loop import MonotoneLoop, NodeFrame

# A witness that would have to be nearer to a corner, by 2**14 bits, is not looked for.
_MOST_DOUBLINGS = 16


def check_sum_within(
    loop: MonotoneLoop,
    first: MonotoneLoop,
    second: MonotoneLoop,
    frame: NodeFrame,
    outside: str,
    inside: str,
) -> None:
    """Check that A + B is in the region of a loop, by the lemma.

    Args:
        frame: to name witnesses in the plane.
        loop: of the region.
        first: A.
        second: B.
        outside: what to say where (a) fails, with places for the numbers of both corners.
        inside: the same for (b) and the number of the corner of the loop.

    Raises:
        CertificateError: the witness is the sum of the corners, or a point of the loop inside
            A + B, at or near the corner of the loop.

    Cost: `count_steps`.
    """
    for sign, chain, a, b in zip((1, -1), loop.halves, first.halves, second.halves, strict=True):
        if found := _corner_outside(chain, a, b) or _corner_inside(chain, a, b):
            (x, y, w), numbers = found
            reason = outside if len(numbers) == 2 else inside
            raise CertificateError(reason.format(*numbers), frame.leave((sign * x, sign * y, w)))


def count_steps(loop: MonotoneLoop, first: MonotoneLoop, second: MonotoneLoop) -> int:
    """Count the steps of `check_sum_within`.

    For (a) each run of convex corners of A is walked along with each of B; for (b), at each concave
    corner of the loop, the edges of one of the two that has fewer, and those edges of the other
    that it is over when it is turned about the corner.
    """
    steps = 0
    for chain, a, b in zip(loop.halves, first.halves, second.halves, strict=True):
        steps += len(a.runs) * sum(map(len, b.runs)) + len(b.runs) * sum(map(len, a.runs))
        a, b = put_longer_first(a, b)
        (left, _, z), (right, _, t) = b.edges[0][0], b.edges[-1][1]
        for _, (x, _, w), _, _ in chain.concave:
            last = a.first_reaching(x * z - left * w, w * z)
            first_passed = a.first_reaching(x * t - right * w, w * t)
            steps += last - first_passed + len(b.edges)
    return steps


def corners_with_common_slopes(
    first: LowerChain, second: LowerChain
) -> Iterator[tuple[ChainCorner, ChainCorner]]:
    """Pairs of corners, one of each chain, that have more than one slope in common.

    Along two runs slopes grow: what a corner is too steep for, the later ones are, too.
    """
    for a_run in first.runs:
        for b_run in second.runs:
            start = 0
            for a in a_run:
                _, _, before, after = a
                while start < len(b_run) and not _is_below(before, b_run[start][3]):
                    start += 1
                for b in islice(b_run, start, None):
                    if not _is_below(b[2], after):
                        break
                    yield a, b


def _is_below(one: Line, other: Line) -> bool:
    """Compare slopes: is an edge before a corner flatter than an edge after one?"""
    return turn(one, other) > 0 or one[1] == other[1] == 0


_Found = tuple[Node, tuple[int, ...]]


def _corner_outside(chain: LowerChain, first: LowerChain, second: LowerChain) -> _Found | None:
    pairs = corners_with_common_slopes(first, second)
    for (k, corner, _, _), (m, other, _, _) in pairs:
        node = add_nodes(corner, other)
        if not chain.holds(node):
            return node, (k, m)
    return None


def _corner_inside(chain: LowerChain, first: LowerChain, second: LowerChain) -> _Found | None:
    for k, corner, side, beside in chain.concave:
        if _passes_below(first, second, corner, side):
            # Below in the limit may mean touching at the corner itself, but not all along. A node
            # that is below may need many bits; each try doubles their number.
            for doublings in range(_MOST_DOUBLINGS):
                node = _approach(corner, beside, 2 ** (doublings - 1)) if doublings else corner
                if _passes_below(first, second, node, 0):
                    break
            return node, (k,)
    return None


def _passes_below(first: LowerChain, second: LowerChain, node: Node, side: int) -> bool:
    return any(height < 0 for height, _ in walk_heights(first, second, node, side))


def _approach(p: Node, q: Node, bits: int) -> Node:
    """The point of the segment from p to q that is 2**bits times as near to p as q is."""
    (px, py, pw), (qx, qy, qw) = p, q
    far = qw * ((1 << bits) - 1)
    return px * far + qx * pw, py * far + qy * pw, pw * qw << bits
