"""The pairs of convex parts that need no sweep, by boxes and a ceiling over a trajectory.

Two parts without a common slope have no relevant edges (see `convex_part`). Along the inside of a
trajectory only the pieces over gaps are relevant. Most of the remaining pairs never come near the
envelope. So the x-range of the envelope is cut into strips of equal width. Each strip has an upper
bound of an envelope that is already computed. A sub-trajectory whose least y reaches the bounds of
all strips that it crosses is nowhere below that envelope, and need not be made. The bounds of
strips are rounded upwards to ints, and those of boxes downwards.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Sequence
from math import inf

from exactsweep.numbers.number import Rational
from exactsweep.procedures.convex_part import Box, ConvexPart, Parts
from exactsweep.procedures.envelope import Break, Envelope, Span
from exactsweep.procedures.lower_envelope import join, lower_envelope_mm, merge

STRIPS_PER_EDGE = 2
STRIPS_PER_CHAIN = 4
FEW_PAIRS = 40
"""The number of pairs up to which sweeping all is faster than a ceiling over half of them."""


class Ceiling:
    """Upper bounds of an envelope over strips of its x-range.

    Args:
        envelope: an upper bound of the envelope to be found.
        rows: the boxes of the parts of one chain, from left to right.
        columns: the boxes of the parts of the other chain, likewise.
        gaps: the relevant x-ranges; the whole x-range by default.

    Attributes:
        tops: the bound over each strip: infinity if the envelope does not reach all of the strip,
            minus infinity if the strip is not relevant.

    The number of strips is proportional to that of all parts, so that a sum of two boxes crosses
    O(1) strips on average.

    Cost: O(size of the envelope + strips).
    """

    def __init__(
        self,
        envelope: Envelope,
        rows: Sequence[Box],
        columns: Sequence[Box],
        gaps: Sequence[Span] | None = None,
    ) -> None:
        breaks, pieces = envelope.breaks, envelope.pieces
        self.columns = columns
        self.start = rows[0][0] + columns[0][0]
        width = rows[-1][1] + columns[-1][1] - self.start + 1
        chains = len(rows) + len(columns)
        size = int(min(STRIPS_PER_EDGE * len(pieces), STRIPS_PER_CHAIN * chains, width))
        self.width = -(-width // size)
        strips = self._find_strips(breaks)
        self.tops: list[Rational | float] = [inf] * size
        first, last = strips[0] + 1, strips[-1]
        self.tops[first:last] = [-inf] * (last - first)
        for k, (dx, dy, c, _, _) in enumerate(pieces):
            n, d = breaks[k + 1] if dy > 0 else breaks[k]
            top = -(-(dy * n + c * d) // (dx * d)) if dx else inf
            for strip in range(strips[k], strips[k + 1] + 1):
                if top > self.tops[strip]:
                    self.tops[strip] = top
        if gaps is not None:
            relevant: list[Rational | float] = [-inf] * size
            for gap in gaps:
                first, last = self._find_strips(gap)
                relevant[first : last + 1] = self.tops[first : last + 1]
            self.tops = relevant

    def _find_strips(self, breaks: Iterable[Break]) -> list[int]:
        """Find the strips that contain breaks."""
        start, width = self.start, self.width
        return [(n // d - start) // width for n, d in breaks]

    def find_reaching(self, row: Box, numbers: Iterable[int]) -> list[int]:
        """Find the columns, of those given, whose sum with a row comes below the ceiling.

        Cost: O(strips crossed), for most sums O(1).
        """
        left, right, low = row
        left, right = left - self.start, right - self.start
        width, tops, columns = self.width, self.tops, self.columns
        both, twice = left + right, 2 * width
        reached: list[int] = []
        for k in numbers:
            first, last, least = columns[k]
            least += low
            # The strip in the middle decides most of them.
            if least < tops[(both + first + last) // twice] or least < max(
                tops[(left + first) // width : (right + last) // width + 1]
            ):
                reached.append(k)
        return reached


# The sub-trajectories of a batch become few envelopes. Let c be a part of G_t and p_1, p_2, ...
# the parts of D_b from left to right. A sum is symmetric in its chains; so if G_t has more parts, c
# is a part of D_b and p_1, p_2, ... are the parts of reversed G_t. Let s_j be the whole
# sub-trajectory of c and p_j, and s'_j its relevant edges, s_j cut at its ends (see `convex_part`).
# E is the envelope of all pairs.
#
#     (1)  For j < k, wherever p_j and p_k lie, s_j - s_k never decreases along x. So they cross
#          once at most, and s_k is lower on the right (Lemma A.3; `cm` has the reason).
#     (2)  At each x some s'_j is on E; and s_j >= E everywhere.
#
# A run R joins s'_j for ascending j. If s'_k starts over R and does not end before R,
# LowerEnvelope_CM joins it. If s'_k starts right of R, it joins R with a gap between. Otherwise a
# new run begins. The invariant is
#
#     (3)  where a member s'_j of R is on E, R is on E.
#
# To prove (3), let s'_k join R and replace it over x >= w.
#
#     (4)  R loses its part right of w. There R is not below s'_k, so s'_k is on E where R was.
#     (5)  s'_k loses a part left of w only if some s'_j in R is not above it at w. Then s_j <= s_k
#          there, and further left, by (1). If s'_k is on E at some x there, so is s_j, by (2).
#          Either x is in the range of s'_j, and R is on E by (3); or s_j is cut off there, where it
#          is above E except for single points.
#
# So the lowest of all runs is E, by (2) and (3). A single run need not be the envelope of its
# members. If only gaps are relevant, (2) holds for each x in a gap.


def sweep_pairs(
    chains: Sequence[ConvexPart], parts: Parts, gaps: Sequence[Span] | None = None
) -> Envelope:
    """Steps 2 and 3: sweep each convex part of G_t, and take the lower envelope.

    Only the edges between the slopes of both parts are relevant (see `convex_part`), so pairs
    without a common slope give nothing. The other pairs are swept in batches, each three times as
    large as the last, with the parts that reach lowest first. The result of a batch is a ceiling
    for the next one, and pairs that do not come below it need no sweep.

    Args:
        chains: the convex parts of reversed G_t.
        parts: the convex parts of D_b.
        gaps: the relevant x-ranges, from left to right; the whole x-range by default.

    Returns:
        The lower envelope, `sources` as in `trajectory_mm`.

    Cost: O(m n log k) for k runs; between one for each part of G_t and one for each pair.
    """
    exchanged = len(parts) < len(chains)
    rows, columns = (parts, chains) if exchanged else (chains, parts)

    def sweep_row(i: int, numbers: Iterable[int]) -> list[Envelope]:
        """Compute the runs of one row, with some of the columns."""
        runs: list[Envelope] = []
        for k in numbers:
            c, p = (k, i) if exchanged else (i, k)
            piece = parts[p].sweep(chains[c], c * len(parts) + p)
            if piece is not None and not (runs and add_to_run(runs[-1], piece)):
                runs.append(piece)
        return runs

    facing: Sequence[Sequence[int]] = [range(len(columns))] * len(rows)
    if gaps is not None:
        facing = keep_over(gaps, rows, columns)
    if len(rows) * len(columns) > FEW_PAIRS:
        facing = find_facing(facing, rows, columns)
    if sum(map(len, facing)) <= FEW_PAIRS:
        runs: list[Envelope] = []
        for i, numbers in enumerate(facing):
            runs += sweep_row(i, numbers)
        return lower_envelope_mm(runs)
    row_boxes, boxes = [row.box for row in rows], [column.box for column in columns]
    found: Envelope | None = None
    order = sorted(range(len(rows)), key=lambda i: row_boxes[i][2])
    for batch in split_batches(order, facing, max(len(rows) + len(columns), FEW_PAIRS)):
        runs = []
        ceiling = None if found is None else Ceiling(found, row_boxes, boxes, gaps)
        for i in batch:
            numbers = facing[i]
            if ceiling is not None:
                numbers = ceiling.find_reaching(row_boxes[i], numbers)
            runs += sweep_row(i, numbers)
        if runs:
            lowest = lower_envelope_mm(runs)
            found = lowest if found is None else merge(found, lowest)
    assert found is not None, "some pair draws the trajectory"
    return found


def split_batches(
    order: Sequence[int], facing: Sequence[Sequence[int]], size: int
) -> Iterator[Sequence[int]]:
    """Split rows into batches of about `size` pairs, each three times as large as the last.

    >>> list(split_batches(range(5), [[0, 1], [0], [1, 2], [0, 1, 2], [1]], 3))
    [range(0, 2), range(2, 5)]
    """
    first = pairs = 0
    for k, row in enumerate(order):
        if first < k and pairs + len(facing[row]) > size:
            yield order[first:k]
            first, pairs, size = k, 0, 3 * size
        pairs += len(facing[row])
    yield order[first:]


def find_facing(numbers: Sequence[Sequence[int]], rows: Parts, columns: Parts) -> list[list[int]]:
    """Keep, for each row, the given columns that have a slope in common with it.

    Cost: O(columns given).
    """
    ends = [(k, column.flattest, column.steepest) for k, column in enumerate(columns)]
    found = []
    for row, given in zip(rows, numbers, strict=True):
        flattest, steepest = row.flattest, row.steepest
        some = ends if len(given) == len(ends) else [ends[k] for k in given]
        found.append([k for k, first, last in some if first <= steepest and flattest <= last])
    return found


def keep_over(gaps: Sequence[Span], rows: Parts, columns: Parts) -> list[list[int]]:
    """Find, for each row, the columns whose sum with it lies over some gap.

    Cost: O(log m) for each row and each gap, and O(numbers returned).
    """
    boxes = [column.box for column in columns]
    lefts, rights = [box[0] for box in boxes], [box[1] for box in boxes]
    ends = [(n // d, -(-m // e)) for (n, d), (m, e) in gaps]
    kept = []
    for row in rows:
        left, right, _ = row.box
        found: list[int] = []
        done = 0
        for low, high in ends:
            begin = bisect_right(rights, low - right, done)
            done = bisect_left(lefts, high - left, begin)
            found += range(begin, done)
        kept.append(found)
    return kept


def add_to_run(run: Envelope, piece: Envelope) -> bool:
    """Join a piece to a run, if it starts over the run or right of it, and does not end before it.

    Returns whether the piece was joined. Cost: as for `lower_envelope_cm`.
    """
    (n, d), (start, start_d) = run.breaks[-1], piece.breaks[0]
    if n * start_d <= start * d:
        run.take_all(piece)
        return True
    (first, first_d), (last, last_d) = run.breaks[0], piece.breaks[-1]
    if start * first_d >= first * start_d and last * d >= n * last_d:
        join(run, piece)
        return True
    return False
