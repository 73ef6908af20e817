"""Section 3: convex generatrix, convex directrix."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import chain, pairwise

from exactsweep import Polygon, sweep
from exactsweep.corpus.generator.shapes import walk
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.vectors import minus
from exactsweep.numbers.number import Edge, Vertex
from exactsweep.paper.checks.touching import contacts_are_right
from exactsweep.paper.claim import Effort, Evidence
from exactsweep.paper.functions import keep_corners, look_up, take_bottom, tell_difference
from exactsweep.paper.pairs import SweepPair, draw_pairs
from exactsweep.procedures.cc import sweep_inner_cc, sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import find_convex_parts, inverse, require_convex, reverse


def slope(edge: Edge) -> Fraction:
    """The slope of an edge, growing counter-clockwise; the same for the reversed edge."""
    (px, py), (qx, qy) = edge
    return Fraction(qy - py) / (qx - px)


def lay_by_slope(start: Vertex, edges: Sequence[Edge], sign: int = 1) -> list[Vertex]:
    """Edges laid end to end, each to the right, in ascending order of slope (or descending)."""
    ordered = sorted(edges, key=lambda edge: sign * slope(edge))
    return keep_corners(walk((minus(*sorted(edge)[::-1]) for edge in ordered), start))


def start_of(top: Sequence[Vertex], directrix: Sequence[Vertex]) -> Vertex:
    """Find the start of the trajectory: the right end of G_t on the left end of D_b."""
    return directrix[0][0] - top[0][0], directrix[0][1] - top[0][1]


def merge_all(pair: SweepPair, sign: int = 1) -> list[Vertex]:
    """Lemma 3.1 as it stands: the edges of reversed G_t and of D_b sorted by slope."""
    top, _, directrix = pair.chains
    edges = [*reverse(list(pairwise(top))), *pairwise(directrix)]
    return lay_by_slope(start_of(top, directrix), edges, sign)


def reversed_edges_make_the_inverse(pair: SweepPair) -> str:
    """Reversed twice, a chain is itself; reversed and laid end to end, it is its inverse."""
    top = pair.chains.top
    edges = list(pairwise(top))
    turned = reverse(edges)
    if [(q, p) for p, q in turned] != edges or reverse(turned) != edges:
        return "the edges are not the same in the same order, each the other way round"
    if list(map(slope, turned)) != list(map(slope, edges)):
        return "the slopes change"
    laid = walk((minus(q, p) for p, q in turned), inverse(top)[0])
    return "" if laid == inverse(top) else "laid end to end they are not the inverse of G_t"


def left_turns_merge(pair: SweepPair) -> str:
    """A chain that turns left everywhere is one convex part, and merges by slope."""
    directrix = pair.chains.directrix
    if keep_corners(require_convex(directrix)) != keep_corners(directrix):
        return "a chain that turns left at every vertex is another one as a convex chain"
    return trajectory_by_slope(pair)


def right_turns_are_edges(pair: SweepPair) -> str:
    """A chain that turns right everywhere has as many convex parts as edges."""
    chain = [(x, -y) for x, y in pair.chains.directrix]
    parts = find_convex_parts(chain)
    return "" if len(parts) == len(chain) - 1 else f"it has {len(parts)} convex parts"


def closed_chains_merge(pair: SweepPair) -> str:
    """Lemma 3.1 holds for every D_b that a straight edge makes convex."""
    try:
        closed = Polygon(pair.chains.directrix)
    except PolygonError:
        return ""
    if not closed.is_convex or not trajectory_by_slope(pair):
        return ""
    return "D_b, closed by an edge, is convex; the merge by slope is not the trajectory"


def clockwise_slopes_merge(pair: SweepPair) -> str:
    """The edges, sorted by slopes that grow clockwise, are the trajectory."""
    if merge_all(pair, sign=-1) == take_bottom(look_up(pair).trajectory):
        return ""
    return "sorted by slopes that grow clockwise, the edges do not make the trajectory"


def trajectory_by_slope(pair: SweepPair) -> str:
    """The merge by slope is the trajectory of the definition."""
    return tell_difference(
        "the merge by slope", merge_all(pair), take_bottom(look_up(pair).trajectory)
    )


def trajectory_cc_is_right(pair: SweepPair) -> str:
    """Trajectory_CC returns the trajectory of the definition, parallel edges added up."""
    top, _, directrix = pair.chains
    expected = take_bottom(look_up(pair).trajectory)
    found = trajectory_cc(top, directrix)
    return tell_difference("Trajectory_CC", found, expected) or _has_edge_in_two(found)


def _has_edge_in_two(chain: Sequence[Vertex]) -> str:
    return "" if len(chain) == len(keep_corners(chain)) else "parallel edges are left as two"


def inner_cc_is_right(pair: SweepPair) -> str:
    """SweepI_CC returns D_b, which is the inner boundary of the definition."""
    top, _, directrix = pair.chains
    expected = take_bottom(look_up(pair).inner)
    found = tell_difference("SweepI_CC", sweep_inner_cc(top, directrix), expected)
    return found or tell_difference("D_b", directrix, expected)


def outer_by_slope(pair: SweepPair) -> str:
    """The edges of all three chains, sorted by slope, are the outer boundary."""
    top, bottom, directrix = pair.chains
    x, y = start_of(top, directrix)
    edges = [*reverse(list(pairwise(top))), *pairwise(bottom), *pairwise(directrix)]
    found = lay_by_slope((x + bottom[0][0], y + bottom[0][1]), edges)
    return tell_difference("the merge by slope", found, take_bottom(look_up(pair).outer))


def outer_cc_is_right(pair: SweepPair) -> str:
    """SweepO_CC returns the outer boundary of the definition, parallel edges added up."""
    found, expected = sweep_outer_cc(*pair.chains), take_bottom(look_up(pair).outer)
    return tell_difference("SweepO_CC", found, expected) or _has_edge_in_two(found)


def loops_are_small(pair: SweepPair) -> str:
    """All loops are convex and no larger than stated."""
    s, loops, (n, m) = sweep(*pair), look_up(pair), map(len, pair)
    if (s.trajectory.vertices, s.inner.vertices, s.outer.vertices) != tuple(loops):
        return "the loops are not those of the definition"
    for name, loop, most in (
        ("trajectory", s.trajectory, m + n),
        ("inner loop", s.inner, m),
        ("outer loop", s.outer, m + 2 * n),
    ):
        if not loop.is_convex:
            return f"the {name} is not convex"
        if len(loop) > most:
            return f"the {name} has {len(loop)} edges, more than {most}"
    return ""


def count_attained(effort: Effort) -> Evidence:
    """Count the pairs that attain the bound for the outer loop."""
    drawn = (
        draw_pairs(effort, "CC", effort.cases(count), *how)
        for count, *how in ((200,), (100, "weak"), (10, "large"))
    )
    attained = sum(len(sweep(g, d).outer) == len(d) + 2 * len(g) for g, d in chain(*drawn))
    return Evidence(
        f"The bound for the outer loop is attained by {attained} of them.",
        "" if attained else "the bounds are never attained",
    )


def every_edge_is_touched(pair: SweepPair) -> str:
    """Every edge of D is in a VE or EE contact."""
    s = sweep(*pair)
    if failure := contacts_are_right(s):
        return failure
    slid = {c.directrix for at in s.contacts for c in at if c.event in ("VE", "EE")}
    missing = set(range(len(s.directrix))) - slid
    return f"edges {sorted(missing)} of D are not slid along" if missing else ""
