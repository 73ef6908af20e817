"""Envelopes of segments inside a trajectory: why Lemma 5.2 needs one more factor.

The lower envelope of s segments can have more pieces than any constant times s (Wiernik and Sharir
1988), but at most s times the inverse Ackermann function. Place two copies of the segments side by
side in D_b, and s equal peaks at the same distance in G_t. Then the trajectory has s + 1 windows
with the envelope of all segments. So trajectories have size O(mn) only if envelopes of segments
have linear size.
"""

import json
from collections.abc import Sequence
from fractions import Fraction
from importlib.resources import files
from itertools import pairwise

from exactsweep.numbers.number import Vertex
from exactsweep.paper.pairs import SweepPair, read_pair

Stroke = Sequence[int]

_DATA = json.loads(
    files("exactsweep.paper.checks").joinpath("segments.json").read_text(encoding="utf-8")
)

# The segments with the most pieces that simulated annealing found, by number of segments. Up to
# five, they attain the longest Davenport-Schinzel sequence of order 3.
BEST: list[list[Stroke]] = _DATA["best"]
FINE = 64

# (m_b, n_t, n_b) = (2, 2, 2): 10, (2, 4, 4): 36, (2, 4, 6): 49
RECORDS = tuple(map(read_pair, _DATA["records"]))


def count_pieces(segments: Sequence[Stroke]) -> int:
    """Count the pieces of the lower envelope of some segments, which must have no gaps."""
    lines = [
        (x0, x1, Fraction(y1 - y0, x1 - x0), y0 - Fraction(y1 - y0, x1 - x0) * x0)
        for x0, y0, x1, y1 in segments
    ]
    cuts = {Fraction(x) for x0, x1, _, _ in lines for x in (x0, x1)}
    for k, (_, _, a, b) in enumerate(lines):
        cuts |= {(b - d) / (c - a) for _, _, c, d in lines[:k] if a != c}
    lowest = []
    for left, right in pairwise(sorted(cuts)):
        x = (left + right) / 2
        over = [(a * x + b, k) for k, (x0, x1, a, b) in enumerate(lines) if x0 < x < x1]
        if over:
            lowest.append(min(over)[1])
    return 1 + sum(p != q for p, q in pairwise(lowest))


def build_windows(segments: Sequence[Stroke]) -> SweepPair:
    """Build a pair whose trajectory contains the envelope of all s segments s + 1 times.

    On both sides are envelopes of the first or the last 1, ..., s - 1 segments.
    """
    count = len(segments)
    directrix, width, high = _lay_side_by_side(segments, 2)
    top = _peaks(count, width, high)
    right, low = top[-1]
    return SweepPair([top[0], (right // 2, low - high), *top[:0:-1]], directrix)


def build_windows_of_windows(segments: Sequence[Stroke]) -> SweepPair:
    """Build a pair whose outer boundary contains the envelope of all s segments s² - s + 1 times.

    On both sides are envelopes of the first or the last 1, ..., s - 1 segments.
    """
    count = len(segments)
    directrix, width, high = _lay_side_by_side(segments, 1)
    top = _peaks(count, count * width, high)
    low = top[0][1] - high
    tips: list[tuple[int, int]] = []
    for k in range(count):
        tips += [(k * width - 1, low), (k * width, low - 8 * high), (k * width + 1, low)]
    top[-1] = (top[-1][0] + count * width, top[-1][1])
    return SweepPair([top[0], *tips, *top[:0:-1]], directrix)


def _lay_side_by_side(
    segments: Sequence[Stroke], copies: int
) -> tuple[list[tuple[int, int]], int, int]:
    """Return a D of segments between walls, their distance, and half the height of the walls.

    Walls are one unit wide; the coordinates of the segments are multiplied by `FINE`.
    """
    left, low = min(s[0] for s in segments), min(min(s[1], s[3]) for s in segments)
    moved = [(x0 - left, y0 - low, x1 - left, y1 - low) for x0, y0, x1, y1 in segments]
    width = FINE * (max(s[2] for s in moved) + 2)
    high = FINE * (max(max(s[1], s[3]) for s in moved) + 2)
    bottom: list[tuple[int, int]] = [(-3, 2 * high)]
    for k, (x0, y0, x1, y1) in enumerate(moved * copies):
        start = k * width
        bottom += [
            (start + FINE * x0 - 1, 2 * high),
            (start + FINE * x0, FINE * y0),
            (start + FINE * x1, FINE * y1),
            (start + FINE * x1 + 1, 2 * high),
        ]
    right = copies * len(moved) * width
    return [*bottom, (right, 2 * high), (right // 2, 4 * high)], width, high


def _peaks(count: int, apart: int, high: int) -> list[tuple[int, int]]:
    """Return G_t, from left to right: peaks of half-width 1, twice as high as the walls."""
    top: list[tuple[int, int]] = [(-2, -4 * high)]
    for k in range(count):
        top += [(k * apart - 1, -4 * high), (k * apart, 0), (k * apart + 1, -4 * high)]
    return [*top, ((count - 1) * apart + 2, -4 * high)]


def pieces_in(trajectory: Sequence[Vertex], segments: Sequence[Stroke]) -> int:
    """Count the edges of a trajectory that come from one of the segments, by their slopes."""
    slopes = {Fraction(y1 - y0, x1 - x0) for x0, y0, x1, y1 in segments}
    return sum(
        Fraction(qy - py) / (qx - px) in slopes
        for (px, py), (qx, qy) in pairwise(trajectory)
        if px != qx
    )
