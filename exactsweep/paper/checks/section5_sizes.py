"""Section 5: size of an MM sweep, and why Lemma 5.2 needs one more factor.

The lower envelope of s segments can have more pieces than any constant times s (Wiernik and Sharir
1988), and up to order s times the inverse Ackermann function. Place two copies of the segments side
by side in D_b, and s equal peaks at the same distance in G_t. Then the trajectory contains the
envelope of all segments in s + 1 windows. So it has size O(mn) only if envelopes have linear size.
"""

import json
from collections.abc import Iterator, Sequence
from fractions import Fraction
from importlib.resources import files
from itertools import pairwise

from exactsweep.corpus.generator.growing import bumps, edges_of_bumps, printed_count
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Vertex
from exactsweep.paper.checks.section5 import sub_trajectories_suffice, trajectory_mm_is_correct
from exactsweep.paper.claim import Counterexample, Effort, Evidence, Observation, Table
from exactsweep.paper.costs import RUNS
from exactsweep.paper.functions import describe_difference, keep_corners, look_up_bottom
from exactsweep.paper.kernel import list_sub_trajectories, trajectory_mm
from exactsweep.paper.pairs import Chains, SweepPair, read_pair

Stroke = Sequence[int]

_DATA = json.loads(
    files("exactsweep.paper.checks").joinpath("segments.json").read_text(encoding="utf-8")
)

# For each number of segments, those with the largest envelope that simulated annealing found. Up to
# five, they attain the longest Davenport-Schinzel sequence of order 3.
BEST: list[list[Stroke]] = _DATA["best"]
FINE = 64

# (m_b, n_t, n_b) = (2, 2, 2): 10, (2, 4, 4): 36, (2, 4, 6): 49
RECORDS = tuple(map(read_pair, _DATA["records"]))

# Found by the search of Lemma 5.2.
EXCEEDING = SweepPair([(0, 3), (1, 0), (2, 3), (1, 1)], [(0, 0), (1, 1), (3, 0), (1, 2)])


def exceeds_its_parts(pair: SweepPair) -> Iterator[str]:
    """A trajectory has at most as many edges as its sub-trajectories in total."""
    sizes = [len(keep_corners(chain)) - 1 for chain in list_sub_trajectories(pair.chains)]
    found = len(keep_corners(trajectory_mm(*pair.chains[::2]))) - 1
    if found > sum(sizes):
        yield (
            f"the size argument fails: the lower envelope has {found} edges, the sub-trajectories "
            f"have {sizes}"
        )


def pieces_at_the_sides(segments: Sequence[Stroke]) -> int:
    """Count the pieces of the envelopes of the first k and of the last s - k of s segments."""
    return sum(
        count_pieces(segments[:k]) + count_pieces(segments[k:]) for k in range(1, len(segments))
    )


def fill_windows(effort: Effort) -> Iterator[Observation]:
    rows = []
    for segments in BEST:
        pair, count, most = build_windows(segments), len(segments), count_pieces(segments)
        if count <= 3:
            yield from trajectory_mm_is_correct(pair)
        # One trajectory contains all windows.
        expected = (count + 1) * most + pieces_at_the_sides(segments)
        found = pieces_in(keep_corners(trajectory_mm(*pair.chains[::2])), segments)
        if found != expected:
            yield f"{found} pieces of {count} segments in T, {expected} expected"
        numbers = map(str, (count, most, 2 * count - 1))
        shares = most / count, found / (2 * count**2)
        rows.append([*numbers, f"{shares[0]:.2f}", f"{found:,}", f"{shares[1]:.2f}"])
    yield Table(
        "Lower envelopes of s segments, the best found by a search, and a trajectory of 2s "
        "segments and s peaks that contains s + 1 such envelopes",
        ("s", "pieces", "2s - 1", "pieces / s", "pieces in T", "per segment and peak"),
        rows,
    )
    yield _report_fall([row[3] for row in rows], "the pieces per segment do not rise")
    yield from trajectory_mm_is_correct(EXCEEDING)
    yield from sub_trajectories_suffice(EXCEEDING)


def _report_fall(rates: Sequence[str], words: str) -> str:
    return "" if sorted(rates, key=float) == [*rates] else words


def find_outer(pair: SweepPair) -> list[Vertex]:
    outer = keep_corners(RUNS["Sweep_MM, outer loop"](pair.chains))
    if failure := describe_difference("the outer boundary", outer, look_up_bottom(pair, "outer")):
        raise ExactSweepError(failure)
    return outer


def find_beyond_mn2(effort: Effort) -> Iterator[Observation]:
    """Show outer boundaries with more than order mn² edges: a table, and the largest one."""
    rows = []
    # The definition tests all pairs of edges, so it is slow with more segments.
    for segments in BEST[:4]:
        pair, count = build_windows_of_windows(segments), len(segments)
        full, most = count * (count - 1) + 1, count_pieces(segments)
        # The ends of G may add pieces.
        least = full * most + pieces_at_the_sides(segments)
        found = pieces_in(find_outer(pair), segments)
        if found < least:
            yield f"{found} pieces of {count} segments, at least {least} expected"
        rate = f"{found / count**3:.2f}"
        rows.append([*map(str, (count, most, full)), f"{found:,}", rate])
    yield _report_fall([row[-1] for row in rows], "the pieces per segment, peak and tip fall")
    yield Counterexample(
        f"the size argument fails: with {count} segments, peaks and tips, {found:,} pieces of "
        f"outer boundary in {full} full windows, {rate} per segment, peak and tip; this rate rises "
        "with the envelopes of segments (see Lemma 5.2)",
        "the segments of Lemma 5.2 in two levels of windows",
        *pair,
    )
    yield Table(
        "Outer boundaries of s segments in D_b, s peaks in G_t and s tips in G_b that contain "
        "s² - s + 1 envelopes of all segments",
        ("s", "pieces", "full windows", "pieces in all", "per segment, peak and tip"),
        rows,
    )


def fill_windows_of_windows(effort: Effort) -> Iterator[Observation]:
    last = RECORDS[-1]
    yield Evidence(
        "The family of Figure 10; windows of windows, and the records of a search, both compared "
        f"with the definition. The last record: G = {last.generatrix}, D = {last.directrix}."
    )
    yield from find_beyond_mn2(effort)
    rows = []
    for pair in RECORDS:
        m_b, n_t, n_b = sizes = sizes_of(pair.chains)
        counts = printed_count(*sizes), m_b * n_t * n_b, len(find_outer(pair)) - 1
        rows.append([str(sizes), *map(str, counts)])
    yield Table(
        "Edges of the outer boundary: maxima found by hill climbing from random chains",
        ("(m_b, n_t, n_b)", "count of Figure 10", "product", "found"),
        rows,
    )


def sizes_of(half: Chains) -> tuple[int, int, int]:
    return len(half.directrix) - 1, len(half.top) - 1, len(half.bottom) - 1


def count_bumps(effort: Effort) -> Iterator[Observation]:
    """Compare the printed formula with the family of Figure 10."""
    sizes = [(2, 4, 6), (2, 2, 4), (4, 2, 4), (4, 4, 4), (4, 4, 6), (4, 6, 8), (6, 6, 6), (6, 8, 8)]
    rows, differing = [], []
    for size in sizes[: 5 if effort.quick else None]:
        pair = SweepPair(*bumps(*size))
        edges, printed = len(find_outer(pair)) - 1, printed_count(*size)
        expected = edges_of_bumps(*size)
        rows.append([str(size), str(printed), str(expected), str(edges)])
        if edges != expected:
            yield f"{edges} edges for {size}, not {expected}"
        if edges != printed:
            text = f"{edges} edges for (m_b, n_t, n_b) = {size}; the formula gives {printed}"
            how = "the smallest pair of the family with two teeth and two peaks"
            differing.append(Counterexample(text, how, *pair))
    yield from differing[:1]
    yield Table(
        "Edges of the outer boundary in the family of Figure 10",
        ("(m_b, n_t, n_b)", "formula of the paper", "m_b n_t n_b / 4 + 4", "edges"),
        rows,
    )
    yield Evidence(f"{len(rows)} pairs, compared with the definition.")


def count_pieces(segments: Sequence[Stroke]) -> int:
    """Count the pieces of the lower envelope of segments, which must have no gaps."""
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

    Envelopes of the first or the last 1, ..., s - 1 segments precede and follow them.
    """
    count = len(segments)
    directrix, width, high = _lay_side_by_side(segments, 2)
    top = _peaks(count, width, high)
    right, low = top[-1]
    return SweepPair([top[0], (right // 2, low - high), *top[:0:-1]], directrix)


def build_windows_of_windows(segments: Sequence[Stroke]) -> SweepPair:
    """Build a pair whose outer boundary contains the envelope of all s segments s² - s + 1 times.

    Envelopes of the first or the last 1, ..., s - 1 segments precede and follow them.
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
    """Return a D of enlarged segments between walls, their distance, and half the walls' height."""
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


def _peaks(count: int, distance: int, high: int) -> list[tuple[int, int]]:
    """Return G_t, from left to right: peaks of half-width 1, twice as high as the walls."""
    top: list[tuple[int, int]] = [(-2, -4 * high)]
    for k in range(count):
        top += [(k * distance - 1, -4 * high), (k * distance, 0), (k * distance + 1, -4 * high)]
    return [*top, ((count - 1) * distance + 2, -4 * high)]


def pieces_in(trajectory: Sequence[Vertex], segments: Sequence[Stroke]) -> int:
    """Count the edges of a trajectory that have the slope of one of the segments."""
    slopes = {Fraction(y1 - y0, x1 - x0) for x0, y0, x1, y1 in segments}
    return sum(
        Fraction(qy - py) / (qx - px) in slopes
        for (px, py), (qx, qy) in pairwise(trajectory)
        if px != qx
    )
