"""A ceiling over a trajectory: which sub-trajectories cannot reach below it.

Most pairs of convex parts of a monotone pair never come near the envelope.  The x-range is cut
into strips of equal width, each with an upper bound of an envelope already computed; a
sub-trajectory whose least y is no less than the bounds of all strips that it crosses is nowhere
below that envelope, and need not be made.  Bounds are rounded upwards to ints: exact.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import inf

from exactsweep.chain import Rational
from exactsweep.envelope import Envelope
from exactsweep.piece import Break, line_of, min_break, precedes, upper_bound

Box = tuple[Rational, Rational, Rational]
"""Of a chain: least x, greatest x, least y."""

STRIPS_PER_EDGE = 4


class Ceiling:
    """Upper bounds of an envelope over strips of its x-range; of a hole, infinity.

    Args:
        envelope: what is known of the envelope to be found.
        floor: a chain that no sub-trajectory reaches below, over the x-range of interest.  Strips
            in which the envelope already lies on it, or beyond that range, are settled.

    Cost: O(size of the envelope and of the floor).
    """

    def __init__(self, envelope: Envelope, floor: Envelope | None = None) -> None:
        self.start: Rational
        breaks, lines = envelope.breaks, envelope.lines()
        (start, start_d), (end, end_d) = breaks[0], breaks[-1]
        self.start = start // start_d
        width = end // end_d + 1 - self.start
        count = min(STRIPS_PER_EDGE * len(lines), int(width))
        self.width = -(-width // count)
        # One strip more: the end of the x-range may lie on its border.
        self.tops: list[Rational | float] = [-inf] * (count + 1)
        for k, line in enumerate(lines):
            left, right = breaks[k], breaks[k + 1]
            first = (left[0] // left[1] - self.start) // self.width
            last = (right[0] // right[1] - self.start) // self.width
            top = inf if line is None else max(upper_bound(line, left), upper_bound(line, right))
            for strip in range(int(first), int(last) + 1):
                if top > self.tops[strip]:
                    self.tops[strip] = top

        if floor is not None:
            self._settle(breaks[0], floor.breaks[0])
            self._settle(floor.breaks[-1], breaks[-1])
            for left, right in coincidences(envelope, floor):
                self._settle(left, right)

    def _settle(self, left: Break, right: Break) -> None:
        first = -((self.start * left[1] - left[0]) // (self.width * left[1]))
        last = (right[0] - self.start * right[1]) // (self.width * right[1])
        for strip in range(int(first), int(last)):
            self.tops[strip] = -inf

    def reached(self, chain: Box, boxes: Sequence[Box]) -> Iterator[int]:
        """The numbers of the boxes whose sum with that of a chain comes below the ceiling.

        Cost: O(strips crossed), for most boxes O(1).
        """
        left, right, low = chain
        left -= self.start
        right -= self.start
        width, tops = self.width, self.tops
        for k, (first, last, least) in enumerate(boxes):
            strips = tops[int((left + first) // width) : int((right + last) // width) + 1]
            if least + low < max(strips):
                yield k


def coincidences(envelope: Envelope, floor: Envelope) -> Iterator[tuple[Break, Break]]:
    """The maximal x-ranges in which an envelope lies on a chain over part of its x-range.

    Cost: O(size of both).
    """
    lines, breaks = envelope.lines(), envelope.breaks
    i = envelope.edge_after(floor.breaks[0])
    since = floor.breaks[0]
    for j, (dx, dy, c) in enumerate(map(line_of, floor.edges)):
        start, end = floor.breaks[j], floor.breaks[j + 1]
        while True:
            line = lines[i]
            if line is None or line[1] * dx != dy * line[0] or line[2] * dx != c * line[0]:
                if precedes(since, start):
                    yield since, start
                since = start = min_break(breaks[i + 1], end)
            else:
                start = min_break(breaks[i + 1], end)
            if precedes(end, breaks[i + 1]):
                break
            i += 1
            if start == end or i == len(lines) or not precedes(start, end):
                break
    if precedes(since, start):
        yield since, start
