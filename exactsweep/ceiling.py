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
from exactsweep.piece import upper_bound

Box = tuple[Rational, Rational, Rational]
"""Of a chain: least x, greatest x, least y."""

STRIPS_PER_EDGE = 2


class Ceiling:
    """Upper bounds of an envelope over strips of its x-range; of a hole, infinity.

    Cost: O(size of the envelope).
    """

    def __init__(self, envelope: Envelope) -> None:
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
