"""The MM sweep: monotone generatrix, monotone directrix (Section 5).

G_t is split into convex parts as well; each is a CM sweep, and the trajectory is the lower
envelope of what those give (Lemma 5.1).  Both loops are trajectories again, of the inverse
generatrix along the two sides of the first trajectory (Lemma 5.3).

Errata.  Lemma 5.3: along the inner side, I(G) must stay inside T, so that its x-range stays within
T's; the boundary lives on D's x-range, and what Trajectory_MM adds at either end, where I(G) only
partly overlaps, is cut off.  Lemma 5.2: the size is O(m n alpha(min(m, n))), alpha the inverse
Ackermann function, since an envelope of segments can have more pieces than segments.  Lemma 5.5:
the inner boundary can have order m n^2 edges, not O(m n): near a needle of D_b it has a corner for
every pair of a peak and a valley of G_t.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from exactsweep.ceiling import Boxes, Ceiling
from exactsweep.chain import Vertex, complement, corners, inverse
from exactsweep.envelope import Envelope, lower_envelope_cm, lower_envelope_mm
from exactsweep.inside import Run, inside_runs
from exactsweep.parts import ConvexPart, joined_parts
from exactsweep.piece import Break, Span
from exactsweep.touched import gaps, pierced

Guess = Sequence[Collection[int]]
"""For each part of G_t, numbers of parts of D_b."""


def trajectory_mm(generatrix: Sequence[Vertex], directrix: Sequence[Vertex] | Envelope) -> Envelope:
    """Trajectory T(G_t, D_b) of a monotone top chain along a monotone bottom chain.

    Procedure Trajectory_MM.

    Args:
        generatrix: G_t: points from right to left, vertical edges allowed.
        directrix: D_b: points from left to right, vertical edges allowed; or an envelope.

    Returns:
        the path of G's origin as an envelope; with k convex parts in D_b, `sources` is
        i * k + j where part i of G_t slides along part j of D_b.

    Raises:
        ChainError: when a chain is not X-monotone.

    Cost: O(m n log n).

    >>> print(trajectory_mm([(2, 1), (1, 0), (0, 1)], [(0, 0), (1, 1), (2, 0)]))
    (-2, -1) (-1, 0) (0, -1) (1, 0) (2, -1)
    """
    return sweep_pairs(joined_parts(inverse(generatrix)), joined_parts(directrix))


def sweep_pairs(
    chains: Sequence[ConvexPart],
    parts: Sequence[ConvexPart] | Sequence[Run],
    known: Envelope | None = None,
    gaps: Sequence[Span] | None = None,
    guess: Guess | None = None,
) -> Envelope:
    """Steps 2 and 3: the CM sweep of each convex part of G_t, and their lower envelope.

    What matters of a sub-trajectory is its edges between the slopes of both parts (see
    `exactsweep.parts`); a pair without slopes in common gives nothing.  The others are swept in
    batches, each three times the last, those parts of G_t first that reach highest.  What a batch
    gives is a ceiling over the next, and pairs that do not come below it need not be swept.

    Lemma A.3 holds for any two whole sub-trajectories of one part of G_t, neighbours or not: on
    the right it is the later one that is lower.  So LowerEnvelope_CM joins them, as long as the
    later one starts over the partial trajectory and does not end before it; else a new run begins.
    Since they are cut, a run may leave out a stretch of one that is lower than the run there.
    Invariant: where a sub-trajectory lies on the final envelope, so does its run.  For what is left
    out is nowhere below the whole sub-trajectory that the run is on just before the later one takes
    over; and where that is cut off, it is above the final envelope.

    Args:
        chains: the convex parts of reversed G_t.
        parts: the convex parts of D_b.
        known: the envelope outside the gaps, with holes in them.
        gaps: the x-ranges that matter; all of it, if left out.
        guess: for each chain the numbers of the parts with which it is likely to be lowest;
            these pairs go first.

    Returns:
        The lower envelope, `sources` as in `trajectory_mm`.

    Cost: O(m n log k) for k runs, one for each part of G_t at best, and at most one for each pair.
    """
    boxes = Boxes.of(parts)
    chain_boxes = [chain.box for chain in chains]
    order = sorted(range(len(chains)), key=lambda i: chain_boxes[i].low)

    start: Break = (min(box.left for box in chain_boxes) + boxes.lefts[0], 1)
    end: Break = (max(box.right for box in chain_boxes) + boxes.rights[-1], 1)

    def lowered(envelope: Envelope | None, batch: Mapping[int, list[int]]) -> Envelope | None:
        runs: list[Envelope] = []
        ceiling = None
        if envelope is not None:
            runs.append(envelope)
            ceiling = Ceiling(envelope.padded(start, end), len(chains) + len(parts), gaps)
        for i, numbers in batch.items():
            chain, first = chains[i], i * len(parts)
            if ceiling is not None:
                numbers = ceiling.reached(chain_boxes[i], boxes, numbers)
            since = len(runs)
            for j in numbers:
                piece = parts[j].swept(chain, first + j)
                if len(runs) > since and piece.follows(runs[-1]):
                    lower_envelope_cm(runs[-1], piece)
                elif piece.edges:
                    runs.append(piece)
        return lower_envelope_mm(runs) if runs else None

    envelope = known
    if guess is not None:
        # Its pairs come up again with the others, few of them under the ceiling that they make.
        envelope = lowered(envelope, {i: sorted(guess[i]) for i in order})
    size, pairs = len(chains) + len(parts), 0
    batch: dict[int, list[int]] = {}
    for i in order:
        facing = boxes.facing(chain_boxes[i])
        if batch and pairs + len(facing) > size:
            envelope = lowered(envelope, batch)
            batch, size, pairs = {}, 3 * size, 0
        batch[i] = facing
        pairs += len(facing)
    envelope = lowered(envelope, batch)
    assert envelope is not None, "some pair draws the trajectory"
    return envelope


def sweep_mm(
    generatrix_top: Sequence[Vertex],
    generatrix_bottom: Sequence[Vertex],
    directrix: Sequence[Vertex],
    trajectory: Envelope | None = None,
) -> tuple[list[Vertex], list[Vertex]]:
    """Inner and outer boundary of the sweep of a monotone G along a monotone D_b.

    Procedure Sweep_MM: `inner_mm` and `outer_mm` for T(G_t, D_b).

    Args:
        generatrix_top: G_t: points from right to left.
        generatrix_bottom: G_b: points from left to right.
        directrix: D_b: points from left to right.
        trajectory: The result of `trajectory_mm` for G_t and D_b, when it is at hand.

    Returns:
        (inner, outer), each from left to right, vertical edges included, no three collinear.

    Raises:
        ChainError: when a chain is not X-monotone.

    Cost: O(m n^2 log n).

    >>> inner, outer = sweep_mm([(1, 1), (0, 1)], [(0, 0), (1, 0)], [(0, 0), (2, 0)])
    >>> inner == [(0, 0), (2, 0)], outer
    (True, [(-1, -1), (3, -1)])
    """
    if trajectory is None:
        trajectory = trajectory_mm(generatrix_top, directrix)
    return (
        inner_mm(generatrix_top, trajectory, directrix),
        list(outer_mm(generatrix_bottom, trajectory)),
    )


def outer_mm(generatrix_bottom: Sequence[Vertex], trajectory: Envelope) -> Envelope:
    """Outer boundary: I(G) slides along the outside of T (Lemma 5.3).

    Cost: O(t n log n) for t edges of T.
    """
    return trajectory_mm(inverse(generatrix_bottom), trajectory)


def inner_mm(
    generatrix_top: Sequence[Vertex], trajectory: Envelope, directrix: Sequence[Vertex]
) -> list[Vertex]:
    """Inner boundary: I(G) slides along the inside of T (Lemma 5.3).

    Turned by half a turn, that is G_t along the bottom chain of the inverse of T's complement.
    Where G touches D_b the boundary is D_b itself, so that only the gaps between are swept: the
    faster way that the paper mentions after Corollary 5.8 (see `exactsweep.touched`).

    Cost: O(t log m + m) to find the gaps, and O(t' n log n) for the t' edges of T along which G
    overlaps a gap; all t of them at worst.
    """
    parts = joined_parts(directrix)
    open_spans = [((-n, d), (-m, e)) for (m, e), (n, d) in reversed(gaps(trajectory, parts))]
    if not open_spans:
        return corners(directrix)
    chains = joined_parts(inverse(generatrix_top))
    inside = inside_runs(trajectory)
    # The part of G_t that draws the trajectory is likely to reach deepest into the gap beside it.
    guess: list[set[int]] = [set() for _ in chains]
    for k, run in enumerate(inside):
        for source in run.sources:
            guess[source // len(parts)].add(k)
    floor = Envelope.of(inverse(complement(directrix)))
    boundary = sweep_pairs(chains, inside, pierced(floor, open_spans), open_spans, guess)
    boundary = boundary.restricted(-directrix[-1][0], -directrix[0][0])
    return inverse(complement(list(boundary)))
