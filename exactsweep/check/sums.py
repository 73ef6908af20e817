"""Nothing goes beyond a loop: a sum of two regions is held by the region of a loop.

Lemma. Let A, B and Q be simple polygons, all weakly monotone to x. If

(a) a + b is in Q for every convex corner a of A and b of B, and
(b) at every concave corner o of Q the boundary of A + B keeps to the inner side of o: in the limit
    from a side on which the boundary of Q goes on from o without a vertical edge,

then A + B is in Q.

Proof, for the lower halves: Q is above the chain q; A + B is above s(x) = min A(u) + B(x - u).

A convex corner of A + B is a sum of convex corners of A and B: if a is no convex corner of A, then
a segment through a lies in A, so one through a + b lies in A + B, and a convex corner is inside
no segment. The ends of s and the bottoms of its vertical edges are convex corners of A + B, so by
(a) they are in Q; also, A + B is in the range of x of Q.

Suppose q - s is positive somewhere. Take its greatest one-sided limit, at x from side i.

- s jumps or ends at x. If i is the lower side of the jump, (x, s) is a convex corner and in Q; so
  q jumps, too, and i is its higher side, which (b) rules out. If i is the higher side, q must jump
  by as much to the same side, lest q - s be greater on the other side; (b) again.
- Only q jumps: the limit is greatest on the higher side of q; (b).
- Neither jumps. By (a) s is not convex at x, by (b) q is not concave; so q - s is convex near x,
  and greatest there, hence constant. Go on to the next corner, where this holds again; at the
  latest the end of s is reached, where it cannot be.
"""

from __future__ import annotations

from collections.abc import Sequence

from exactsweep.check.certificate import CertificateError
from exactsweep.check.chain import LowerChain, Node, heights
from exactsweep.check.loop import MonotoneLoop, NodeFrame


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
        second: B, its nodes on the lattice.
        outside: what to say where (a) fails, with places for the numbers of both corners.
        inside: the same for (b) and the number of the corner of the loop.

    Raises:
        CertificateError: the witness is the sum of the corners, or a point of the loop inside
            A + B, at or near the corner of the loop.

    Cost: `steps_within`.
    """
    for sign, chain, a, b in zip((1, -1), loop.halves, first.halves, second.halves, strict=True):
        if found := _corner_outside(chain, a, b) or _corner_inside(chain, a, b):
            (x, y, w), numbers = found
            reason = outside if len(numbers) == 2 else inside
            raise CertificateError(reason.format(*numbers), frame.leave((sign * x, sign * y, w)))


def steps_within(loop: MonotoneLoop, first: MonotoneLoop, second: MonotoneLoop) -> int:
    """Count the steps of `check_sum_within`.

    For (a) they are pairs of convex corners, or all corners and edges once where all three are
    convex; for (b), at each concave corner of the loop, the edges
    of B, and those edges of A that B turned about the corner is over.
    """
    steps = 0
    for chain, a, b in zip(loop.halves, first.halves, second.halves, strict=True):
        if _are_convex(chain, a, b):
            steps += len(chain.edges) + len(a.convex) + len(b.convex)
        else:
            steps += len(a.convex) * len(b.convex)
        (left, _, _), (right, _, _) = b.edges[0].left, b.edges[-1].right
        for _, (x, _, w), _, _ in chain.concave:
            passed = a.first_reaching(x - left * w, w) - a.first_reaching(x - right * w, w)
            steps += passed + len(b.edges)
    return steps


_Found = tuple[Node, tuple[int, ...]]


def _are_convex(*chains: LowerChain) -> bool:
    return not any(chain.concave for chain in chains)


def are_above(chain: LowerChain, first: LowerChain, second: LowerChain) -> bool:
    """Whether all sums of corners are in the region, all three chains being convex.

    They are if the first and the last one are, and if at each edge the lowest corners of both, as
    seen from its line, have a sum above it. From edge to edge the lowest corners move to the right.
    """
    a_corners, b_corners = ([c[0], *c[2:], c[1]] for c in (first.convex, second.convex))
    for k in (0, -1):
        (x, y, w), (dx, dy, _) = a_corners[k][1], b_corners[k][1]
        if not chain.holds((x + dx * w, y + dy * w, w)):
            return False
    i = j = 0
    for _, _, (a, b, c) in chain.edges:
        i, j = _lowest(a_corners, i, a, b), _lowest(b_corners, j, a, b)
        (x, y, w), (dx, dy, _) = a_corners[i][1], b_corners[j][1]
        if a * (x + dx * w) + b * (y + dy * w) + c * w < 0:
            return False
    return True


def _lowest(corners: Sequence[tuple[int, Node]], k: int, a: int, b: int) -> int:
    """The corner with the least a x + b y, not before the k-th one."""
    x, y, w = corners[k][1]
    least = a * x + b * y
    while k + 1 < len(corners):
        x, y, v = corners[k + 1][1]
        if (a * x + b * y) * w > least * v:
            break
        k, least, w = k + 1, a * x + b * y, v
    return k


def _corner_outside(chain: LowerChain, first: LowerChain, second: LowerChain) -> _Found | None:
    if _are_convex(chain, first, second) and are_above(chain, first, second):
        return None
    for k, (x, y, w) in first.convex:
        for m, (dx, dy, _) in second.convex:
            node = x + dx * w, y + dy * w, w
            if not chain.holds(node):
                return node, (k, m)
    return None


def _corner_inside(chain: LowerChain, first: LowerChain, second: LowerChain) -> _Found | None:
    for k, corner, side, beside in chain.concave:
        if _passes_below(first, second, corner, side):
            # Below in the limit may mean touching at the corner itself, but not all along.
            node = corner
            while not _passes_below(first, second, node, 0):
                node = beside = _middle(corner, beside)
            return node, (k,)
    return None


def _passes_below(first: LowerChain, second: LowerChain, node: Node, side: int) -> bool:
    return any(height < 0 for height, _ in heights(first, second, node, side))


def _middle(p: Node, q: Node) -> Node:
    (px, py, pw), (qx, qy, qw) = p, q
    return px * qw + qx * pw, py * qw + qy * pw, 2 * pw * qw
