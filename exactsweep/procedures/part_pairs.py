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
from collections.abc import Callable, Iterable, Mapping, Sequence
from math import inf
from typing import NamedTuple, cast

from exactsweep.numbers.number import Rational
from exactsweep.procedures.convex_part import Box, ConvexPart, Parts
from exactsweep.procedures.envelope import Break, Envelope, Span
from exactsweep.procedures.lower_envelope import join, lower_envelope_mm, merge

STRIPS_PER_EDGE = 2
STRIPS_PER_CHAIN = 4
FEW_PAIRS = 40
"""The number of pairs up to which sweeping all is faster than a ceiling over half of them."""

Guess = Callable[[], Iterable[tuple[int, int]]]
"""Makes pairs of numbers, of parts of G_t and of D_b."""


class Boxes(NamedTuple):
    """The boxes of consecutive parts, and their left and right ends, each ascending."""

    boxes: list[Box]
    lefts: list[Rational]
    rights: list[Rational]

    @classmethod
    def of(cls, parts: Parts) -> Boxes:
        """Collect the boxes of parts, from left to right."""
        boxes = [part.box for part in parts]
        return cls(boxes, [box[0] for box in boxes], [box[1] for box in boxes])


class Ceiling:
    """Upper bounds of an envelope over strips of its x-range; of a gap, infinity.

    Args:
        envelope: an upper bound of the envelope to be found.
        span: bounds of the x-ranges of all sums.
        chains: the number of convex chains of G_t and D_b. The number of strips is proportional to
            it, so that a pair crosses O(1) of them on average.
        gaps: the relevant x-ranges, from left to right; the whole x-range by default.

    Cost: O(size of the envelope).
    """

    def __init__(
        self,
        envelope: Envelope,
        span: tuple[Rational, Rational],
        chains: int,
        gaps: Sequence[Span] | None = None,
    ) -> None:
        breaks, pieces = envelope.breaks, envelope.pieces
        self.start, end = span
        width = end - self.start + 1
        count = int(min(STRIPS_PER_EDGE * len(pieces), STRIPS_PER_CHAIN * chains, width))
        self.width = -(-width // count)
        # One more strip: the end of the x-range may lie on a border.
        self.tops = tops = [cast("Rational | float", -inf)] * (count + 1)
        # First and last strip of each window; no strip is in two of them.
        self.windows: list[tuple[int, int]] = []
        strips = self._find_strips(breaks)
        for left, right in [((self.start, 1), (end, 1))] if gaps is None else gaps:
            first, last = self._find_strips((left, right))
            begin, stop = envelope.edge_after(left), envelope.edge_before(right)
            if begin < 0:
                self._open(first, min(strips[0], last))
            if stop == len(pieces):
                self._open(max(first, strips[-1]), last)
            for k in range(max(begin, 0), min(stop + 1, len(pieces))):
                dx, dy, c, _, _ = pieces[k]
                n, d = breaks[k + 1] if dy > 0 else breaks[k]
                top: Rational | float = -(-(dy * n + c * d) // (dx * d)) if dx else inf
                strip, end_strip = strips[k], strips[k + 1]
                while strip <= end_strip:
                    if top > tops[strip]:
                        tops[strip] = top
                    strip += 1
            if self.windows and first <= self.windows[-1][1]:
                first = self.windows.pop()[0]
            self.windows.append((first, last))

    def _open(self, first: int, last: int) -> None:
        """Mark some strips as unbounded."""
        self.tops[first : last + 1] = [inf] * (last + 1 - first)

    def _find_strips(self, breaks: Iterable[Break]) -> list[int]:
        """Find the strips that contain breaks."""
        start, width = self.start, self.width
        return [(n // d - start) // width for n, d in breaks]

    def find_reaching(self, part: Box, boxes: Boxes, numbers: Sequence[int]) -> list[int]:
        """Find the boxes whose sum with that of a part comes below the ceiling.

        Args:
            part: the box of a part of G_t.
            boxes: the boxes of D_b.
            numbers: the numbers of the boxes to test, ascending.

        Cost: O(strips crossed), for most boxes O(1), and O(log m) for each window.
        """
        left, right, low = part
        left, right = left - self.start, right - self.start
        width, tops = self.width, self.tops
        both, twice, each = left + right, 2 * width, boxes.boxes
        reached: list[int] = []
        done = 0
        for first_strip, last_strip in self.windows:
            begin = max(done, bisect_left(boxes.rights, first_strip * width - right))
            done = bisect_right(boxes.lefts, (last_strip + 1) * width - left, begin)
            for k in numbers[bisect_left(numbers, begin) : bisect_left(numbers, done)]:
                first, last, least = each[k]
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
# members. If only gaps are relevant, (2) holds for each x in a gap. Then pairs whose sums lie
# outside all gaps are left out, and so are the pieces of a run there.


def sweep_pairs(
    chains: Sequence[ConvexPart],
    parts: Parts,
    gaps: Sequence[Span] | None = None,
    guess: Guess | None = None,
) -> Envelope:
    """Steps 2 and 3: sweep each convex part of G_t, and take the lower envelope.

    Only the edges between the slopes of both parts are relevant (see `convex_part`), so pairs
    without a common slope give nothing. The other pairs are swept in batches, each three times as
    large as the last. The parts of G_t that reach highest come first. The result of a batch is a
    ceiling for the next one, and pairs that do not come below it need no sweep.

    Args:
        chains: the convex parts of reversed G_t.
        parts: the convex parts of D_b.
        gaps: the relevant x-ranges, from left to right; the whole x-range by default.
        guess: returns pairs of a chain and a part that are likely to be lowest. They come first, if
            there are too many pairs to sweep them all at once.

    Returns:
        The lower envelope, `sources` as in `trajectory_mm`.

    Cost: O(m n log k) for k runs; between one for each part of G_t and one for each pair.
    """
    exchanged = len(parts) < len(chains)
    rows, columns = (parts, chains) if exchanged else (chains, parts)
    count = len(parts)
    facing: Sequence[Sequence[int]] = [range(len(columns))] * len(rows)
    few = len(rows) * len(columns) <= FEW_PAIRS
    if gaps is not None:
        facing = keep_over(gaps, rows, columns)
    if not few:
        facing = find_facing(facing, rows, columns)
        few = sum(map(len, facing)) <= FEW_PAIRS

    def sweep_row(i: int, numbers: Iterable[int]) -> Iterable[Envelope]:
        """Compute the runs of one row, with some of the columns."""
        runs: list[Envelope] = []
        run: Envelope | None = None
        for k in numbers:
            chain, part = (k, i) if exchanged else (i, k)
            piece = parts[part].sweep(chains[chain], chain * count + part)
            if piece is not None and not (run is not None and add_to_run(run, piece)):
                run = piece
                runs.append(run)
        return runs if gaps is None else filter(None, [run.keep(gaps) for run in runs])

    if few:
        found: list[Envelope] = []
        for i, numbers in enumerate(facing):
            found += sweep_row(i, numbers)
        return lower_envelope_mm(found)

    row_boxes, boxes = Boxes.of(rows).boxes, Boxes.of(columns)
    span = row_boxes[0][0] + boxes.lefts[0], row_boxes[-1][1] + boxes.rights[-1]

    def sweep_batch(
        envelope: Envelope | None, batch: Mapping[int, Sequence[int]]
    ) -> Envelope | None:
        runs: list[Envelope] = []
        ceiling = None
        if envelope is not None:
            ceiling = Ceiling(envelope, span, len(rows) + len(columns), gaps)
        for i, numbers in batch.items():
            if ceiling is not None:
                numbers = ceiling.find_reaching(row_boxes[i], boxes, numbers)
            runs += sweep_row(i, numbers)
        if not runs:
            return envelope
        found = lower_envelope_mm(runs)
        return merge(envelope, found) if envelope is not None else found

    envelope: Envelope | None = None
    order = sorted(range(len(rows)), key=lambda i: row_boxes[i][2])
    if guess is not None:
        guessed: list[set[int]] = [set() for _ in rows]
        for chain, part in guess():
            i, k = (part, chain) if exchanged else (chain, part)
            guessed[i].add(k)
        likely = {i: [k for k in facing[i] if k in guessed[i]] for i in order}
        envelope = sweep_batch(envelope, likely)
        facing = [[k for k in facing[i] if k not in guessed[i]] for i in range(len(rows))]
    batch: dict[int, Sequence[int]] = {}
    size, pairs = max(len(rows) + len(columns), FEW_PAIRS), 0
    for i in order:
        if batch and pairs + len(facing[i]) > size:
            envelope = sweep_batch(envelope, batch)
            batch, size, pairs = {}, 3 * size, 0
        batch[i] = facing[i]
        pairs += len(facing[i])
    envelope = sweep_batch(envelope, batch)
    assert envelope is not None, "some pair draws the trajectory"
    return envelope


def find_facing(asked: Sequence[Sequence[int]], rows: Parts, columns: Parts) -> list[list[int]]:
    """Keep, for each row, the given columns that have a slope in common with it.

    Cost: O(columns given).
    """
    ends = [(k, columns[k].flattest, columns[k].steepest) for k in range(len(columns))]
    found = []
    for i, numbers in enumerate(asked):
        flattest, steepest = rows[i].flattest, rows[i].steepest
        some = ends if len(numbers) == len(ends) else [ends[k] for k in numbers]
        found.append([k for k, first, last in some if first <= steepest and flattest <= last])
    return found


def keep_over(gaps: Sequence[Span], rows: Parts, columns: Parts) -> list[list[int]]:
    """Find, for each row, the columns whose sum with it lies over some gap.

    Cost: O(log m) for each row and each gap, and O(numbers returned).
    """
    lefts: list[Rational] = [column.x_range[0] for column in columns]
    rights: list[Rational] = [column.x_range[1] for column in columns]
    ends = [(n // d, -(-m // e)) for (n, d), (m, e) in gaps]
    kept = []
    for row in rows:
        left, right = row.x_range
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
