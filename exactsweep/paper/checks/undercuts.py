"""Section 5: number and size of the undercuts of an MM sweep, and size of the inner loop."""

from collections.abc import Iterator, Sequence
from dataclasses import astuple
from itertools import combinations, pairwise

from exactsweep import Point, Sweep, sweep
from exactsweep.check import verify
from exactsweep.corpus.generator.growing import (
    ceilings,
    edges_over_needles,
    needles,
    undercuts_under_ceilings,
)
from exactsweep.draw import place_generatrix
from exactsweep.geometry.segment import make_segment
from exactsweep.geometry.vectors import is_on_segment
from exactsweep.paper.checks.beyond import covers
from exactsweep.paper.checks.section4 import undercuts_fill_the_inner_loop
from exactsweep.paper.claim import Counterexample, Effort, Evidence, Observation, Table
from exactsweep.paper.costs import count_all
from exactsweep.paper.functions import list_edges, lower_undercuts
from exactsweep.paper.kernel import sweep_mm
from exactsweep.paper.pairs import SweepPair
from exactsweep.procedures.undercuts import find_undercuts


def find_long_undercut(effort: Effort) -> Iterator[Observation]:
    yield Evidence("A family of needles; a certificate proves one pair.")
    yield from prove(SweepPair(*needles(10, 8)))
    for growth in count_all("Lemma 5.5", effort):
        yield growth
        for m, n, count, _ in map(astuple, growth.points):
            if count - 1 < edges_over_needles(m, n):
                yield f"{count - 1} edges for ({m}, {n}), fewer than proved"
    for n in (10, 20, 30):
        # The only undercut between two needles has at least the proved number of edges.
        longest, least = find_longest(SweepPair(*needles(7, n))), edges_over_needles(7, n)
        if longest < least:
            yield f"an undercut of {longest} edges for n = {n}, at least {least} proved"


def find_longest(pair: SweepPair) -> int:
    return max((len(u.bottom) - 1 for u in sweep(*pair).undercuts), default=0)


def long_undercut(pair: SweepPair) -> Iterator[str]:
    """The bottom chain of an undercut has at most as many edges as G_t."""
    longest, most = find_longest(pair), len(pair.chains.top) - 1
    if longest > most:
        yield f"an undercut has {longest} edges, G_t has {most}"


def prove(pair: SweepPair) -> Iterator[str]:
    yield from undercuts_fill_the_inner_loop(pair)
    verdict = verify(sweep(*pair).certificate())
    yield "" if verdict.proved else verdict.reason


def undercuts_are_closed(pair: SweepPair) -> Iterator[str]:
    """At and between the positions that close an undercut, G traces its whole bottom chain."""
    s = sweep(*pair)
    for undercut in s.undercuts:
        drawn = list(map(make_segment, _list_drawn(s, undercut.positions)))
        for start, end in pairwise(undercut.bottom):
            if not covers(drawn, (start, end)):
                yield f"an undercut is open from ({start.x}, {start.y}) to ({end.x}, {end.y})"


def _list_drawn(s: Sweep, positions: Sequence[Point]) -> list[tuple[Point, Point]]:
    """List the edges of G at some positions, and the paths of its vertices along edges of T."""
    drawn = [edge for t in positions for edge in list_edges(place_generatrix(s, t).vertices)]
    for edge in list_edges(s.trajectory.vertices):
        low, high = sorted(edge)
        along = [t for t in positions if low <= t <= high and is_on_segment(t, low, high)]
        drawn += [
            (Point(x + t.x, y + t.y), Point(x + u.x, y + u.y))
            for t, u in combinations(along, 2)
            for x, y in s.generatrix.vertices
        ]
    return drawn


def count_lower_undercuts(pair: SweepPair) -> int:
    """Count the undercuts of the lower sweep, with both chains closed at the top."""
    inner, directrix = sweep_mm(*pair.chains)[0], pair.chains.directrix
    above = 1 + max(y for _, y in directrix)
    lid = [(directrix[-1][0] + 1, above), (directrix[0][0] - 1, above)]
    return len(find_undercuts([*inner, *lid], [*directrix, *lid]))


def count_undercuts(effort: Effort) -> Iterator[Observation]:
    small = [(7, 8)] if effort.quick else [(7, 8), (10, 12), (13, 16)]
    tried = ", ".join(map(str, small))
    yield Evidence(f"A family of ceilings. Certificates prove the pairs of {tried}.")
    for m, n in small:
        yield from prove(SweepPair(*ceilings(m, n)))
    rows = []
    for growth in count_all("Number of undercuts, MM", effort):
        yield growth
        for m, n, count, _ in map(astuple, growth.points):
            expected = undercuts_under_ceilings(m, n)
            rows.append([*(f"{x:,}" for x in (m, n, m * n, count, expected))])
            rows[-1].append(f"{count / (m * n * n):.4f}")
            if count != expected:
                yield f"{count} undercuts for ({m}, {n}), {expected} proved"
    pair = SweepPair(*ceilings(7, 8))
    yield Counterexample(
        f"the lower sweep has {len(lower_undercuts(sweep(*pair)))} disjoint undercuts; D_b has "
        f"{len(pair.chains.directrix)} vertices",
        "the smallest of the family of ceilings",
        *pair,
    )
    yield Table(
        "Undercuts of the lower sweep under ceilings: counted, and (N - 1)(P(P - 1) + 1) with "
        "m = 3N + 1 and n = 2P + 2",
        ("m", "n", "mn", "counted", "proved", "counted / mn²"),
        rows,
    )
