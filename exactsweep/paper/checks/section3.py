"""Section 3: convex generatrix, convex directrix."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import chain, pairwise

from exactsweep import Polygon, sweep
from exactsweep.corpus.generator.shapes import walk
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.vectors import minus
from exactsweep.numbers.number import Edge, Vertex
from exactsweep.paper.checks.section2 import contacts_are_correct
from exactsweep.paper.claim import Effort, Evidence, Observation
from exactsweep.paper.costs import RUNS
from exactsweep.paper.functions import (
    compare_loops,
    describe_difference,
    keep_corners,
    look_up_bottom,
    write_chain,
)
from exactsweep.paper.kernel import find_convex_parts, require_convex, sweep_inner_cc
from exactsweep.paper.laws import Law
from exactsweep.paper.pairs import SweepPair, draw_pairs
from exactsweep.procedures.chain import inverse, reverse


def returns(
    words: str = "",
    fails: Callable[[str, Sequence[Vertex]], Iterable[str]] = lambda procedure, chain: (),
    **procedures: str,
) -> Law:
    """Return the law that each procedure, a key of RUNS, computes the bottom chain of its loop.

    `words` states the law if it says more than that; `fails` checks the returned chain further.
    """

    def law(pair: SweepPair) -> Iterator[str]:
        for loop, procedure in procedures.items():
            found = list(RUNS[procedure](pair.chains))
            yield describe_difference(procedure, found, look_up_bottom(pair, loop))
            yield from fails(procedure, found)

    loop, procedure = next(iter(procedures.items()))
    boundary = loop if loop == "trajectory" else f"{loop} boundary"
    law.__doc__ = words or f"{procedure} returns the {boundary} as defined."
    return law


def slope(edge: Edge) -> Fraction:
    (px, py), (qx, qy) = edge
    return Fraction(qy - py) / (qx - px)


def lay_by_slope(start: Vertex, edges: Sequence[Edge], sign: int = 1) -> list[Vertex]:
    """Join edges, each directed to the right, by ascending slope, or descending if `sign` is -1."""
    ordered = sorted(edges, key=lambda edge: sign * slope(edge))
    return keep_corners(walk((minus(*sorted(edge)[::-1]) for edge in ordered), start))


def start_of(top: Sequence[Vertex], directrix: Sequence[Vertex]) -> Vertex:
    """Return the start of the trajectory: the right end of G_t is on the left end of D_b."""
    return directrix[0][0] - top[0][0], directrix[0][1] - top[0][1]


def merge_all(pair: SweepPair, sign: int = 1) -> list[Vertex]:
    """Apply Lemma 3.1 as printed: sort the edges of reversed G_t and of D_b by slope."""
    top, _, directrix = pair.chains
    edges = [*reverse(list(pairwise(top))), *pairwise(directrix)]
    return lay_by_slope(start_of(top, directrix), edges, sign)


def reversed_edges_make_the_inverse(pair: SweepPair) -> Iterator[str]:
    """Reversing a chain twice restores it; its reversed edges, joined, form its inverse."""
    top = pair.chains.top
    edges = list(pairwise(top))
    backward = reverse(edges)
    if [(q, p) for p, q in backward] != edges or reverse(backward) != edges:
        yield "reversal changes more than the direction of each edge"
    if list(map(slope, backward)) != list(map(slope, edges)):
        yield "reversal changes the slopes"
    if walk((minus(q, p) for p, q in backward), inverse(top)[0]) != inverse(top):
        yield "the reversed edges, joined, are not the inverse of G_t"


def left_turns_merge(pair: SweepPair) -> Iterator[str]:
    """A chain with only left turns is a single convex part, and merges by slope."""
    directrix = pair.chains.directrix
    if keep_corners(require_convex(directrix)) != keep_corners(directrix):
        yield "a chain with only left turns has several convex parts"
    yield from trajectory_by_slope(pair)


def right_turns_are_edges(pair: SweepPair) -> Iterator[str]:
    """A chain with only right turns has as many convex parts as edges."""
    chain = [(x, -y) for x, y in pair.chains.directrix]
    if len(parts := find_convex_parts(chain)) != len(chain) - 1:
        yield f"the chain has {len(parts)} convex parts"


def closed_chains_merge(pair: SweepPair) -> Iterator[str]:
    """Lemma 3.1 holds for every D_b that a straight edge closes into a convex polygon."""
    with suppress(PolygonError):
        if Polygon(pair.chains.directrix).is_convex and any(trajectory_by_slope(pair)):
            yield "D_b is convex when closed by an edge; the merge by slope is not the trajectory"


def clockwise_slopes_merge(pair: SweepPair) -> Iterator[str]:
    """Sorting the edges by clockwise slope yields the trajectory."""
    if merge_all(pair, sign=-1) != look_up_bottom(pair, "trajectory"):
        yield "the edges sorted by clockwise slope are not the trajectory"


def trajectory_by_slope(pair: SweepPair) -> Iterator[str]:
    """The merge by slope is the trajectory as defined."""
    expected = look_up_bottom(pair, "trajectory")
    yield describe_difference("the merge by slope", merge_all(pair), expected)


def leaves_parallel_edges(procedure: str, chain: Sequence[Vertex]) -> Iterator[str]:
    if len(chain) != len(keep_corners(chain)):
        yield f"{procedure} does not join two parallel edges"


trajectory_cc_is_correct = returns(
    "Trajectory_CC returns the trajectory as defined, with parallel edges joined.",
    leaves_parallel_edges,
    trajectory="Trajectory_CC",
)
outer_cc_is_correct = returns(
    "SweepO_CC returns the outer boundary as defined, with parallel edges joined.",
    leaves_parallel_edges,
    outer="SweepO_CC",
)


def inner_cc_is_correct(pair: SweepPair) -> Iterator[str]:
    """SweepI_CC returns D_b, which is the inner boundary as defined."""
    top, _, directrix = pair.chains
    expected = look_up_bottom(pair, "inner")
    yield describe_difference("SweepI_CC", sweep_inner_cc(top, directrix), expected)
    yield describe_difference("D_b", directrix, expected)


def outer_by_slope(pair: SweepPair) -> Iterator[str]:
    """Sorting the edges of all three chains by slope yields the outer boundary."""
    top, bottom, directrix = pair.chains
    x, y = start_of(top, directrix)
    edges = [*reverse(list(pairwise(top))), *pairwise(bottom), *pairwise(directrix)]
    found = lay_by_slope((x + bottom[0][0], y + bottom[0][1]), edges)
    yield describe_difference("the merge by slope", found, look_up_bottom(pair, "outer"))


def loops_are_small(pair: SweepPair) -> Iterator[str]:
    """All loops are convex, and their sizes are within the stated bounds."""
    s, (n, m) = sweep(*pair), map(len, pair)
    for loop, most in (s.trajectory, m + n), (s.inner, m), (s.outer, m + 2 * n):
        if not loop.is_convex or len(loop) > most:
            yield f"a loop is not convex, or has more than {most} edges: {write_chain(loop)}"
    yield from compare_loops(s)


def count_attained(effort: Effort) -> Iterator[Observation]:
    drawn = (
        draw_pairs(effort, "CC", effort.cases(count), *how)
        for count, *how in ((200,), (100, "weak"), (10, "large"))
    )
    attained = sum(len(sweep(g, d).outer) == len(d) + 2 * len(g) for g, d in chain(*drawn))
    yield Evidence(f"The outer loop attains its bound in {attained} of them.")
    yield "" if attained else "no outer loop attains its bound"


def every_edge_is_touched(pair: SweepPair) -> Iterator[str]:
    """Every edge of D is in a VE or EE contact."""
    s = sweep(*pair)
    slid = {c.directrix for at in s.contacts for c in at if c.event in ("VE", "EE")}
    yield from contacts_are_correct(s)
    if missing := set(range(len(s.directrix))) - slid:
        yield f"no contact along edges {sorted(missing)} of D"
