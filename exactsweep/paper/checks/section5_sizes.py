"""Section 5: how large an MM sweep gets."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from exactsweep.corpus.generator.growing import (
    bumps,
    edges_of_bumps,
    figure10,
    mm,
    printed_count,
)
from exactsweep.numbers.error import ExactSweepError
from exactsweep.paper.checks.section5 import sub_trajectories_suffice, trajectory_mm_is_right
from exactsweep.paper.checks.segments import (
    BEST,
    RECORDS,
    Stroke,
    build_windows,
    build_windows_of_windows,
    count_pieces,
    pieces_in,
)
from exactsweep.paper.claim import (
    Counterexample,
    Effort,
    Evidence,
    Table,
    find_first_failure,
    weigh,
)
from exactsweep.paper.costs import OUTER, RUNS
from exactsweep.paper.counting import count_by, grow
from exactsweep.paper.functions import (
    keep_corners,
    list_sub_trajectories,
    look_up_bottom,
    tell_difference,
)
from exactsweep.paper.growth import MN, MN2
from exactsweep.paper.pairs import Chains, SweepPair
from exactsweep.paper.tiny import search_grid
from exactsweep.procedures.mm import trajectory_mm
from exactsweep.procedures.monotone import LowerSweep

# The pair that the search in `_check_lemma_5_2` finds.
OUTGROWING = SweepPair([(0, 3), (1, 0), (2, 3), (1, 1)], [(0, 0), (1, 1), (3, 0), (1, 2)])


def outgrows_its_parts(pair: SweepPair) -> str:
    """The trajectory has more edges than the sub-trajectories of which it is the envelope."""
    sizes = [len(keep_corners(chain)) - 1 for chain in list_sub_trajectories(pair)]
    found = len(keep_corners(trajectory_mm(*pair.chains[::2]))) - 1
    if found <= sum(sizes):
        return ""
    return (
        f"the size argument fails: {found} edges in the lower envelope of sub-trajectories of "
        f"{sizes} edges"
    )


def pieces_at_the_sides(segments: Sequence[Stroke]) -> int:
    """Pieces of the envelopes of the first and of the last 1, ..., s - 1 of s segments."""
    return sum(
        count_pieces(segments[:k]) + count_pieces(segments[k:]) for k in range(1, len(segments))
    )


def window_is_full(segments: Sequence[Stroke]) -> tuple[str, list[str]]:
    """All windows come out in one trajectory: what fails, and a row of the table."""
    pair, count = build_windows(segments), len(segments)
    most = count_pieces(segments)
    expected = (count + 1) * most + pieces_at_the_sides(segments)
    found = pieces_in(keep_corners(trajectory_mm(*pair.chains[::2])), segments)
    failure = trajectory_mm_is_right(pair) if count <= 3 else ""
    if found != expected:
        failure = failure or f"{found} pieces of {count} segments in T, {expected} by the envelopes"
    numbers = [count, most, 2 * count - 1, f"{most / count:.2f}"]
    return failure, [*map(str, numbers), f"{found:,}", f"{found / (2 * count**2):.2f}"]


def fill_windows(effort: Effort) -> Evidence:
    """Count the pieces of trajectories that hold many envelopes of segments."""
    found = search_grid(3, 8, "bent", "bent", outgrows_its_parts)
    results = [window_is_full(segments) for segments in BEST]
    table = Table(
        "Lower envelopes of s segments, the best that a search has found, and a trajectory, of "
        "2s segments and s peaks, that holds s + 1 such envelopes",
        (
            "s",
            "pieces",
            "2s - 1",
            "pieces / s",
            "pieces in T",
            "for each segment and peak",
        ),
        [row for _, row in results],
    )
    rates = [float(row[3]) for _, row in results]
    rising = "" if rates == sorted(rates) else "the pieces for each segment do not rise"
    count = count_by("vertices", RUNS["Trajectory_MM"])
    growth = tuple(
        grow("vertices of trajectory", family, MN, effort.sizes(), count)
        for family in (mm, figure10)
    )
    failure = find_first_failure(text for text, _ in results) or rising
    failure = failure or weigh("", *growth).failure or trajectory_mm_is_right(OUTGROWING)
    failure = failure or sub_trajectories_suffice(OUTGROWING)
    return replace(found, failure=failure, tables=(table,), growth=growth)


def outer_edges(pair: SweepPair) -> int:
    """Count the edges of the outer boundary of the lower sweep, and check it by the definition."""
    outer = keep_corners(OUTER(pair.chains))
    if failure := tell_difference("the outer boundary", outer, look_up_bottom(pair, "outer")):
        raise ExactSweepError(failure)
    return len(outer) - 1


def windows_of_windows_are_full(segments: Sequence[Stroke]) -> tuple[str, list[str]]:
    """All windows come out in one outer boundary: what fails, and a row of the table."""
    pair, count = build_windows_of_windows(segments), len(segments)
    most, full = count_pieces(segments), count * (count - 1) + 1
    outer = keep_corners(OUTER(pair.chains))
    # The ends of G may add some.
    least, found = full * most + pieces_at_the_sides(segments), pieces_in(outer, segments)
    failure = tell_difference("the outer boundary", outer, look_up_bottom(pair, "outer"))
    if found < least:
        failure = failure or f"{found} pieces of {count} segments, {least} by the envelopes"
    return failure, [*map(str, (count, most, full)), f"{found:,}", f"{found / count**3:.2f}"]


def beyond_mn2() -> tuple[str, Counterexample, Table]:
    """Outer boundaries of more than order mn²: what fails, the largest, and all of them."""
    # The definition, which takes all pairs of edges, is slow with more segments.
    results = [windows_of_windows_are_full(segments) for segments in BEST[:4]]
    rates = [float(row[-1]) for _, row in results]
    rising = "" if rates == sorted(rates) else "the pieces for each segment, peak and tip fall"
    count, _, full, found, rate = results[-1][1]
    against = Counterexample(
        f"the size argument fails: with {count} segments, peaks and tips, {found} pieces of outer "
        f"boundary in {full} full windows, {rate} for each segment, peak and tip, which rises with "
        "the envelopes of segments (see Lemma 5.2)",
        "the segments of Lemma 5.2, laid over one another twice",
        *build_windows_of_windows(BEST[len(results) - 1]),
    )
    table = Table(
        "Outer boundaries of s segments in D_b, s peaks in G_t and s tips in G_b that hold "
        "s² - s + 1 envelopes of all segments",
        ("s", "pieces", "full windows", "pieces in all", "for each segment, peak and tip"),
        [row for _, row in results],
    )
    return find_first_failure([*(text for text, _ in results), rising]), against, table


def fill_windows_of_windows(effort: Effort) -> Evidence:
    """Count the edges of outer boundaries."""
    rows = []
    for pair in RECORDS:
        sizes = sizes_of(pair.chains)
        m_b, n_t, n_b = sizes
        counts = printed_count(*sizes), m_b * n_t * n_b, outer_edges(pair)
        rows.append([str(sizes), *map(str, counts)])
    count = count_by("vertices", OUTER)
    growth = grow("vertices of outer boundary", figure10, MN2, effort.sizes(), count)
    fallen = "" if growth.is_attained else "the outer boundary falls behind mn²"
    failure, against, beyond = beyond_mn2()
    records = Table(
        "Edges of the outer boundary: the most that hill climbing from random chains has found",
        ("(m_b, n_t, n_b)", "count of Figure 10", "product", "found"),
        rows,
    )
    last = RECORDS[-1]
    return Evidence(
        "The family of Figure 10; windows of windows, and the records of a search, both held "
        f"against the definition. The last record: G = {last.generatrix}, D = {last.directrix}.",
        failure or growth.failure or fallen,
        against,
        tables=(beyond, records),
        growth=(growth,),
    )


def sizes_of(half: Chains | LowerSweep) -> tuple[int, int, int]:
    """m_b, n_t and n_b of a lower sweep."""
    return len(half.directrix) - 1, len(half.top) - 1, len(half.bottom) - 1


def count_bumps(effort: Effort) -> Evidence:
    """Compare the printed count with the family of Figure 10."""
    sizes = [(2, 4, 6), (2, 2, 4), (4, 2, 4), (4, 4, 4), (4, 4, 6), (4, 6, 8), (6, 6, 6), (6, 8, 8)]
    rows, failure, against = [], "", None
    for m_b, n_t, n_b in sizes[: 5 if effort.quick else None]:
        pair = SweepPair(*bumps(m_b, n_t, n_b))
        edges, printed = outer_edges(pair), printed_count(m_b, n_t, n_b)
        expected = edges_of_bumps(m_b, n_t, n_b)
        rows.append([f"({m_b}, {n_t}, {n_b})", str(printed), str(expected), str(edges)])
        if edges != expected:
            failure = failure or f"{edges} edges for {(m_b, n_t, n_b)}, not {expected}"
        if edges != printed and against is None:
            against = Counterexample(
                f"{edges} edges for (m_b, n_t, n_b) = ({m_b}, {n_t}, {n_b}); the formula says "
                f"{printed}",
                "the first of the family, by size, with two teeth and two peaks",
                *pair,
            )
    table = Table(
        "Edges of the outer boundary in the family of Figure 10",
        ("(m_b, n_t, n_b)", "formula of the paper", "m_b n_t n_b / 4 + 4", "edges"),
        rows,
    )
    return Evidence(f"{len(rows)} pairs, by the definition.", failure, against, tables=(table,))
