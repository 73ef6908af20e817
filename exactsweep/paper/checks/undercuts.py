"""Section 5: undercuts of an MM sweep, how many and how long, and so the size of the inner loop."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain, combinations, pairwise

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
from exactsweep.paper.claim import Counterexample, Effort, Evidence, Table, find_first_failure
from exactsweep.paper.costs import INNER
from exactsweep.paper.counting import PairFamily, count_by, grow
from exactsweep.paper.functions import list_edges, lower_undercuts
from exactsweep.paper.growth import MN2, Growth
from exactsweep.paper.pairs import SweepPair
from exactsweep.paper.tiny import search_grid
from exactsweep.procedures.mm import sweep_mm
from exactsweep.procedures.pockets import find_pockets


def find_long_undercut(effort: Effort) -> Evidence:
    """Look for an undercut with more edges than G_t, and count the edges over needles."""
    found = search_grid(3, 8, "bent", "bent", long_undercut)
    growth = tuple(
        grow("vertices of inner boundary", needles, MN2, sizes, count_by("vertices", INNER))
        for sizes in (
            [(size, 16) for size, _ in effort.sizes(16, 3, 5)],
            [(16, size) for _, size in effort.sizes(8, 3, 5)],
            effort.sizes(8, 2, 3),
        )
    )
    failure = proved_case(needles, 10, 8) or find_first_failure(map(_fall_behind, growth))
    failure = failure or find_first_failure(map(_undercut_falls_behind, (10, 20, 30)))
    tried = f"{found.tried} A family of needles, one of them proved by its certificate."
    return replace(found, tried=tried, failure=failure, growth=growth)


def _fall_behind(growth: Growth) -> str:
    for point in growth.points:
        if point.count - 1 < edges_over_needles(point.m, point.n):
            return f"{point.count - 1} edges for ({point.m}, {point.n}) are fewer than proved"
    return "" if growth.is_attained else "the inner boundary over the needles falls behind mn²"


def _undercut_falls_behind(n: int) -> str:
    """The only undercut between two needles has as many edges as the proof says."""
    longest = max(len(u.bottom) - 1 for u in sweep(*needles(7, n)).undercuts)
    least = edges_over_needles(7, n)
    return "" if longest >= least else f"an undercut of {longest} edges for n = {n}, not {least}"


def long_undercut(pair: SweepPair) -> str:
    """An undercut whose bottom chain has more edges than G_t."""
    most = len(pair.chains.top) - 1
    longest = max((len(u.bottom) - 1 for u in sweep(*pair).undercuts), default=0)
    return f"an undercut of {longest} edges, G_t having {most}" if longest > most else ""


def proved_case(family: PairFamily, m: int, n: int) -> str:
    """Compare one pair of a family with the definition, and prove its certificate."""
    pair = SweepPair(*family(m, n))
    verdict = verify(sweep(*pair).certificate())
    return undercuts_fill_the_inner_loop(pair) or ("" if verdict.proved else verdict.reason)


def undercuts_are_closed(pair: SweepPair) -> str:
    """In its positions, and on the way between two of them, G draws all of a bottom chain."""
    s = sweep(*pair)
    for undercut in s.undercuts:
        drawn = list(map(make_segment, _list_drawn(s, undercut.positions)))
        for start, end in pairwise(undercut.bottom):
            if not covers(drawn, (start, end)):
                return f"an undercut from ({start.x}, {start.y}) to ({end.x}, {end.y}) is left open"
    return ""


def _list_drawn(s: Sweep, positions: Sequence[Point]) -> list[tuple[Point, Point]]:
    """The edges of G at some positions, and the ways of its vertices along edges of T."""
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


def count_undercuts(effort: Effort) -> Evidence:
    """Count the undercuts under ceilings; those of small pairs are proved by certificates."""

    def count(pair: SweepPair) -> int:
        return len(find_pockets(sweep_mm(*pair.chains)[0], pair.chains.directrix))

    growth = tuple(
        grow("undercuts of the lower sweep", ceilings, MN2, sizes, count)
        for sizes in (
            [(3 * size + 4, 16) for size, _ in effort.sizes(8, 2, 3)],
            [(7, 2 * size + 2) for size, _ in effort.sizes(16, 2, 3)],
        )
    )
    amiss = (
        f"{p.count} undercuts for ({p.m}, {p.n}) are not as many as proved"
        for g in growth
        for p in g.points
        if p.count != undercuts_under_ceilings(p.m, p.n)
    )
    pair = SweepPair(*ceilings(7, 8))
    against = Counterexample(
        f"{len(lower_undercuts(sweep(*pair)))} disjoint undercuts of the lower sweep where D_b has "
        f"{len(pair.chains.directrix)} vertices",
        "the least of the family of ceilings",
        *pair,
    )
    table = Table(
        "Undercuts of the lower sweep under ceilings: counted, and (N - 1)(P(P - 1) + 1), where "
        "m = 3N + 1 and n = 2P + 2",
        ("m", "n", "mn", "counted", "by the proof", "counted / mn²"),
        [
            [
                *(f"{x:,}" for x in (p.m, p.n, p.m * p.n, int(p.count))),
                f"{undercuts_under_ceilings(p.m, p.n):,}",
                f"{p.ratio:.4f}",
            ]
            for g in growth
            for p in g.points
        ],
    )
    small = [(7, 8)] if effort.quick else [(7, 8), (10, 12), (13, 16)]
    proved = (proved_case(ceilings, m, n) for m, n in small)
    failure = find_first_failure(chain(proved, amiss))
    tried = f"A family of ceilings. Certificates prove the pairs of {', '.join(map(str, small))}."
    return Evidence(tried, failure, against, tables=(table,), growth=growth)
