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

from collections.abc import Container, Iterable, Iterator, Sequence

from exactsweep.ceiling import Boxes, Ceiling
from exactsweep.chain import Vertex, complement, convex_parts, corners, inverse
from exactsweep.envelope import Envelope, lower_envelope_cm, lower_envelope_mm
from exactsweep.inside import Run, inside_runs
from exactsweep.parts import ConvexPart, joined_parts
from exactsweep.piece import Break, Span
from exactsweep.touched import gaps, pierced

Guess = Sequence[Container[int]]
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
    return sweep_pairs(convex_parts(inverse(generatrix)), joined_parts(directrix))


def sweep_pairs(
    chains: Sequence[Sequence[Vertex]],
    parts: Sequence[ConvexPart] | Sequence[Run],
    known: Envelope | None = None,
    gaps: Sequence[Span] | None = None,
    guess: Guess | None = None,
) -> Envelope:
    """Steps 2 and 3: the CM sweep of each convex part of G_t, and their lower envelope.

    A guess goes first: the part of G_t that reaches highest, or the pairs that are given.  What
    it gives is a ceiling, and pairs that do not come below it need not be swept; the others follow
    in batches, each four times the last, so that the ceiling is lowered only O(log n) times.

    LowerEnvelope_CM needs neighbours: what it drops it drops for the next part's sake.  So the
    parts left are taken in runs of consecutive ones, each run a directrix of its own, about whose
    left end G turns in any case.  To the right of its last part only what is higher than the part
    left out is dropped or was never made, which is above the ceiling.

    Args:
        chains: the convex chains of reversed edges of G_t.
        parts: the convex parts of D_b.
        known: the envelope outside the gaps, with holes in them.
        gaps: the x-ranges that matter; all of it, if left out.
        guess: for each chain the numbers of the parts with which it is likely to be lowest.

    Returns:
        The lower envelope, `sources` as in `trajectory_mm`.

    Cost: O(m n log n), the number of pairs that are swept being at most m n.
    """
    boxes = Boxes.of(parts)
    chain_boxes = [(c[0][0], c[-1][0], min(y for _, y in c)) for c in chains]

    def sweep(i: int, numbers: Iterable[int]) -> Iterator[Envelope]:
        run, following = None, -1
        for j in numbers:
            source = i * len(parts) + j
            if run is not None and j == following:
                lower_envelope_cm(run, parts[j].swept(chains[i], source))
            else:
                if run is not None:
                    yield run
                run = parts[j].swept(chains[i], source, turns_left=True)
            following = j + 1
        if run is not None:
            yield run

    def lowered(envelope: Envelope, batch: Iterable[int], guess: Guess | None = None) -> Envelope:
        ceiling = Ceiling(envelope, len(chains) + len(parts), gaps)
        swept: list[Envelope] = []
        for i in batch:
            reached = ceiling.reached(chain_boxes[i], boxes)
            swept += sweep(i, (j for j in reached if guess is None or j in guess[i]))
        return lower_envelope_mm([*swept, envelope])

    start: Break = (min(first for first, _, _ in chain_boxes) + boxes.lefts[0], 1)
    end: Break = (max(last for _, last, _ in chain_boxes) + boxes.rights[-1], 1)
    envelope = Envelope.hole(start, end) if known is None else known.padded(start, end)
    order = sorted(range(len(chains)), key=lambda i: chain_boxes[i][2])
    done, size = 0, 1
    if guess is not None:
        # Its pairs come up again with the others, few of them under the ceiling that they make.
        envelope = lowered(envelope, order, guess)
        size = 4
    while done < len(order):
        envelope = lowered(envelope, order[done : done + size])
        done, size = done + size, 4 * size
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
    chains = convex_parts(inverse(generatrix_top))
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
