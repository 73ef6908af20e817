"""Section 4: convex generatrix, monotone directrix."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import chain, pairwise

from exactsweep import Point, sweep
from exactsweep.check import classify, point_in_polygon
from exactsweep.draw.features import Features
from exactsweep.evidence.undercut import Undercut
from exactsweep.numbers.number import Vertex
from exactsweep.paper.checks.section1 import STEP
from exactsweep.paper.checks.section3 import returns
from exactsweep.paper.checks.touching import contacts_are_right
from exactsweep.paper.claim import Effort, Evidence, find_first_failure
from exactsweep.paper.functions import (
    evaluate,
    list_sub_chains,
    look_up_bottom,
    lower_undercuts,
    reaches,
    sample_between,
    tell_loops,
)
from exactsweep.paper.pairs import SweepPair, draw_pairs
from exactsweep.procedures.chain import find_convex_parts


def lowest(name: str, chains: Sequence[Sequence[Vertex]], envelope: Sequence[Vertex]) -> str:
    """Say where an envelope is not the lowest of some chains; empty if it is everywhere."""
    for x in sample_between(envelope, *chains):
        least = min((evaluate(chain, x) for chain in chains if reaches(chain, x)), default=None)
        found = evaluate(envelope, x) if reaches(envelope, x) else None
        if least != found:
            return f"over {x} the lowest {name} is at {least}, the envelope at {found}"
    return ""


def sub_trajectories_suffice(pair: SweepPair) -> str:
    """The trajectory and the outer boundary are the lower envelopes of the parts' ones."""
    paths, outers = list_sub_chains(pair)
    return lowest("sub-trajectory", paths, look_up_bottom(pair, "trajectory")) or lowest(
        "sub-outer chain", outers, look_up_bottom(pair, "outer")
    )


def is_monotone(name: str, chain: Iterable[Vertex]) -> str:
    """Say that a chain turns back along x, or has a vertical edge; empty if it does not."""
    backs = [p[0] for p, q in pairwise(chain) if p[0] >= q[0]]
    return f"{name} is not strictly X-monotone at x = {backs[0]}" if backs else ""


trajectory_cm_is_right = returns(trajectory="Trajectory_CM")
outer_cm_is_right = returns(outer="SweepO_CM")
inner_cm_is_right = returns(inner="SweepI_CM")
inner_is_monotone = returns(
    "The inner boundary is X-monotone, strictly so.", is_monotone, inner="SweepI_CM"
)
MONOTONE = "Without vertical edges in G and D there are none in the chains, which are X-monotone."
loops_are_monotone = returns(MONOTONE, is_monotone, trajectory="Trajectory_CM", outer="SweepO_CM")


def few_undercuts(pair: SweepPair) -> str:
    """There are fewer undercuts than convex parts of D_b, and each has at most n_t edges."""
    s, (top, _, directrix) = sweep(*pair), pair.chains
    if failure := tell_loops(s, "inner"):
        return failure
    lower = lower_undercuts(s)
    if len(lower) >= len(find_convex_parts(directrix)):
        return f"{len(lower)} undercuts of {len(find_convex_parts(directrix))} convex parts"
    longest = max((len(u.bottom) - 1 for u in lower), default=0)
    return f"an undercut with {longest} edges" if longest > len(top) - 1 else ""


def bottom_chains_have_two_forms(pair: SweepPair) -> str:
    """Closed in a point: a piece of G's boundary; along a segment: one edge, parallel to it."""
    s = sweep(*pair)
    failures = (_form(undercut, pair) for undercut in s.undercuts)
    return find_first_failure(failures) or undercuts_fill_the_inner_loop(pair)


def undercuts_fill_the_inner_loop(pair: SweepPair) -> str:
    """The undercuts are apart, and make up the difference between the inner loop and D."""
    s = sweep(*pair)
    if sum(u.polygon.area for u in s.undercuts) + s.directrix.area != s.inner.area:
        return "the undercuts do not make up the difference between the inner loop and D"
    return tell_loops(s, "inner")


def count_forms(effort: Effort) -> Evidence:
    """Count the undercuts of each form."""
    random = draw_pairs(effort, "CM", effort.cases(150))
    resting = draw_pairs(effort, "CM", effort.cases(40), "resting")
    swept = (sweep(*pair) for pair in chain(random, resting))
    forms = Counter(undercut.intersection for s in swept for undercut in s.undercuts)
    return Evidence(
        f"Undercuts: {forms['point']} closed in a point, {forms['segment']} along a segment.",
        "" if len(forms) == 2 else "one of the two forms is never seen",
    )


def _form(undercut: Undercut, pair: SweepPair) -> str:
    bottom, positions = undercut.bottom, undercut.positions

    def rests(t: Point) -> bool:
        """Decide whether G at a position, free of D, has both ends on its boundary."""
        placed = [Point(x + t.x, y + t.y) for x, y in pair.generatrix]
        is_closed = all(point_in_polygon(end, placed) == 0 for end in (bottom[0], bottom[-1]))
        return is_closed and classify(pair.directrix, pair.generatrix, t).verdict == "CONTACT"

    if undercut.intersection == "segment":
        (a, b), (c, d) = (bottom[0], bottom[-1]), (positions[0], positions[-1])
        if len(bottom) != 2 or (b.x - a.x) * (d.y - c.y) != (b.y - a.y) * (d.x - c.x):
            return f"not one edge: {undercut}"
        ends = [(c, d), (d, c)]
        beyond = [Point(p.x + STEP * (p.x - q.x), p.y + STEP * (p.y - q.y)) for p, q in ends]
        closed = [rests(t) for t in (c, d, *beyond)]
        return "" if c != d and closed == [True, True, False, False] else f"not there: {undercut}"
    (t,) = positions
    placed = [Point(x + t.x, y + t.y) for x, y in pair.generatrix]
    if any(point_in_polygon(p, placed) for p in bottom):
        return f"the bottom chain is off the boundary of G: {undercut}"
    return "" if set(bottom[1:-1]) <= set(placed) else f"a corner that G has not: {undercut}"


def labels_name_the_extremes(pair: SweepPair) -> str:
    """The contacts at the positions that close an undercut name both of its extremes."""
    s = sweep(*pair)
    if failure := contacts_are_right(s) or tell_loops(s, "inner"):
        return failure
    features = Features(s)
    for undercut in s.undercuts:
        spots = {
            spot
            for t in undercut.positions
            for c in s.contacts_at(t)
            for spot in features.spot(c, t)
        }
        missed = set(undercut.extremes) - spots
        if missed:
            return f"no label names ({min(missed).x}, {min(missed).y}), an end of an undercut"
    return ""
