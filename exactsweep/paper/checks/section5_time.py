"""Section 5.1: how long an MM sweep takes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import reduce
from itertools import pairwise, product
from math import log2

from exactsweep.corpus.generator.growing import cm_hard, figure10, mm, needles, rim
from exactsweep.corpus.generator.shapes import Ring
from exactsweep.numbers.number import Vertex
from exactsweep.paper import literal
from exactsweep.paper.checks.section4 import lowest
from exactsweep.paper.checks.section5_sizes import (
    OUTGROWING,
    beyond_mn2,
    outgrows_its_parts,
)
from exactsweep.paper.claim import Counterexample, Effort, Evidence, find_first_failure, weigh
from exactsweep.paper.costs import INNER, STEPS
from exactsweep.paper.counting import (
    PairFamily,
    count_by,
    count_chains,
    count_operations,
    grow,
    make_counted,
    watch_operations,
)
from exactsweep.paper.functions import (
    clip_to,
    keep_corners,
    list_sub_trajectories,
    look_up_bottom,
    tell_difference,
)
from exactsweep.paper.growth import M_PLUS_N, MN, MN2, SUM_LOG, Bound, Growth, double
from exactsweep.paper.pairs import Chains, SweepPair
from exactsweep.procedures.chain import find_convex_parts, inverse
from exactsweep.procedures.cm import trajectory_cm
from exactsweep.procedures.envelope import Envelope
from exactsweep.procedures.lower_envelope import lower_envelope_mm
from exactsweep.procedures.mm import inner_mm, trajectory_mm


def count_one_merge(effort: Effort) -> Evidence:
    """Count the operations of one merge, and merge all tiny chains."""

    def merge(*chains: list[Vertex]) -> Envelope:
        return lower_envelope_mm([Envelope.of(make_counted(chain)) for chain in chains])

    def zigzags(m: int, n: int) -> tuple[Ring, Ring]:
        return [(2 * k, k % 2 * 10) for k in range(m)], [(2 * k, 6 - k % 2) for k in range(n)]

    def count(chains: SweepPair) -> int:
        return count_operations(merge, *chains)

    # Nothing but the ends keeps the counts from being in proportion.
    growth = grow("operations of one merge", zigzags, M_PLUS_N, double(64, 4), count, limit=1.005)
    pairs = list(product(_tiny_chains(), repeat=2))
    failure = growth.failure or find_first_failure(
        lowest("chain", [a, b], list(lower_envelope_mm([Envelope.of(a), Envelope.of(b)])))
        for a, b in pairs
    )
    return Evidence(
        f"All {len(pairs)} pairs of chains of one or two edges on the 3 by 3 grid; counts.",
        failure,
        growth=(growth,),
        searched=len(pairs),
    )


def _tiny_chains() -> list[list[Vertex]]:
    """Chains over 0, 1 and 2, at heights 0 to 2, those of one edge first."""
    straight: list[list[Vertex]] = [[(0, a), (2, b)] for a, b in product(range(3), repeat=2)]
    bends: list[list[Vertex]] = [
        [(0, a), (1, b), (2, c)] for a, b, c in product(range(3), repeat=3) if a + c != 2 * b
    ]
    return straight + bends


def count_levels(effort: Effort) -> Evidence:
    """Count the operations of merging envelopes."""
    return weigh("", *(_envelope_growth(family, effort) for family in (figure10, mm)))


def count_halves(effort: Effort) -> Evidence:
    """Count the operations of merging by halves, by the kernel and to the letter."""
    return weigh(
        "Counts.",
        _envelope_growth(mm, effort),
        _envelope_growth(figure10, effort),
        _envelope_growth(figure10, effort, to_the_letter=True),
    )


def _envelope_growth(family: PairFamily, effort: Effort, *, to_the_letter: bool = False) -> Growth:
    """Operations of LowerEnvelope_MM beside N log k, N the size of what goes in."""

    def count(pair: SweepPair) -> tuple[int, float]:
        top, _, directrix = pair.chains
        with watch_operations() as tally:
            chains = [
                trajectory_cm(make_counted(inverse(part)), make_counted(directrix))
                for part in find_convex_parts(inverse(top))
            ]
            size = sum(len(chain.pieces) for chain in chains)
            paths = [list(chain) for chain in chains]
            before = tally.total
            merge_all = literal.lower_envelope_mm if to_the_letter else lower_envelope_mm
            merged: Iterable[Vertex] = merge_all(paths if to_the_letter else chains)  # type: ignore[arg-type]
        return tally.total - before + sum(1 for _ in merged), size * max(1.0, log2(len(chains)))

    what = f"operations of LowerEnvelope_MM{' to the letter' if to_the_letter else ''}"
    return grow(what, family, "N log k", effort.sizes(), count)


def lower_envelope_mm_is_right(pair: SweepPair) -> str:
    """LowerEnvelope_MM returns the lowest chain over every x."""
    chains = list_sub_trajectories(pair)
    found = lower_envelope_mm(chains)
    return lowest(
        "sub-trajectory", [list(chain) for chain in chains], list(found)
    ) or tell_difference("the lower envelope", found, look_up_bottom(pair, "trajectory"))


def find_large_trajectory(effort: Effort) -> Evidence:
    """Count what Trajectory_MM costs; the size that the bound rests on fails."""
    found = outgrows_its_parts(OUTGROWING)
    how = "the first of the non-convex quadrilaterals on the 4 by 4 grid"
    return Evidence("", against=Counterexample(found, how, *OUTGROWING) if found else None)


def find_large_loop(effort: Effort) -> Evidence:
    """Count what Sweep_MM costs; the size that the bound rests on fails."""
    failure, against, _ = beyond_mn2()
    return Evidence("", failure, against)


def count_step_2(effort: Effort) -> Evidence:
    """Count the operations of all calls of Trajectory_CM."""

    def step_2(chains: Chains) -> list[Vertex]:
        parts = literal.split_at_reflex([(-x, -y) for x, y in chains.top])
        tops = ([(-x, -y) for x, y in part] for part in parts)
        return [p for top in tops for p in literal.trajectory_cm(top, chains.directrix)]

    sizes = effort.sizes(32)
    count = count_by("operations", step_2)
    counts = (grow("operations of step 2", family, MN, sizes, count) for family in (figure10, mm))
    return weigh("Counts of the step to the letter.", *counts)


def count_glance(effort: Effort) -> Evidence:
    """Count the operations of merging one sub-trajectory after the other, and by halves."""

    def merge_by_turns(chains: Chains) -> list[Vertex]:
        return reduce(literal.merge, _sub_trajectories(chains))

    def merge_by_halves(chains: Chains) -> list[Vertex]:
        return literal.lower_envelope_mm(_sub_trajectories(chains))

    by_turns, by_halves = (count_by("operations", run) for run in (merge_by_turns, merge_by_halves))
    sizes = [(size, 16) for size, _ in effort.sizes(16, 3, 5)]
    bounds = (
        ("m²n log mn", lambda m, n: m * m * n * log2(m * n)),
        ("mn log m", lambda m, n: m * n * log2(m)),
    )
    growth = (
        grow("operations of merging by turns", cm_hard, bounds[0], sizes, by_turns),
        grow("operations of merging by halves", cm_hard, bounds[1], sizes, by_halves, STEPS),
    )
    fast = "" if growth[0].exponent() >= 1.7 else "merging by turns takes less than order m²"
    return weigh("Counts to the letter.", *growth, failure=fast)


def _sub_trajectories(chains: Chains) -> list[list[Vertex]]:
    parts = literal.split_at_reflex(chains.directrix)
    return [literal.trajectory_cc(chains.top, part) for part in parts]


def inner_again(chains: Chains, trajectory: Envelope) -> list[Vertex]:
    """The inner boundary to the letter: Trajectory_MM along all of T's inside."""
    bottom, path = inverse(chains.top), keep_corners(trajectory)
    return clip_to(literal.slide_inside(bottom, path, literal.trajectory_mm), chains.directrix)


def inner_by_gaps(chains: Chains, trajectory: Envelope) -> list[Vertex]:
    """The inner boundary as the kernel has it: only what G does not touch of D_b is swept."""
    return inner_mm(chains.top, trajectory, chains.directrix)


def _inner_grows(
    what: str,
    inner: Callable[[Chains, Envelope], list[Vertex]],
    bound: Bound,
    sizes: Iterable[tuple[int, int]],
) -> Growth:
    """Operations beyond the trajectory, on a family that is touched almost everywhere."""

    def count(pair: SweepPair) -> int:
        chains = count_chains(pair)
        return count_operations(inner, chains, trajectory_mm(*chains[::2]))

    return grow(f"operations of the inner boundary, {what}", rim, bound, sizes, count)


def gaps_give_the_same(pair: SweepPair) -> str:
    """Sweeping the gaps alone gives the inner boundary of Sweep_MM."""
    chains = pair.chains
    trajectory = trajectory_mm(*chains[::2])
    return tell_difference(
        "the inner boundary",
        inner_by_gaps(chains, trajectory),
        inner_again(chains, trajectory),
    )


def _outgrows(slow: Growth, fast: Growth) -> bool:
    """Decide whether one count outgrows another with each doubling."""
    factors = [p.count / q.count for p, q in zip(slow.points, fast.points, strict=False)]
    return all(after > 1.4 * before for before, after in pairwise(factors))


def count_gaps(effort: Effort) -> Evidence:
    """Count the operations of both ways to the inner boundary, and the size of the output."""
    sizes = [(16, n) for _, n in effort.sizes(8)]
    written = grow("vertices of inner boundary", needles, MN2, sizes, count_by("vertices", INNER))
    gaps = _inner_grows("gaps only", inner_by_gaps, SUM_LOG, effort.sizes())
    few = effort.sizes(16, 1, 3)
    again = _inner_grows("Trajectory_MM again", inner_again, MN, few)
    last, beside = written.points[-1], gaps.points[len(few) - 1]
    return Evidence(
        "Operations counted where most of D_b is touched: "
        f"{beside.count:,} in place of {again.points[-1].count:,} at m = n = {beside.m}. "
        "A family of needles, vertices counted.",
        find_first_failure(
            [
                gaps.failure,
                "" if written.is_attained else "the inner boundary falls behind mn²",
                ""
                if _outgrows(again, gaps)
                else "calling Trajectory_MM again is as good, or nearly",
            ]
        ),
        Counterexample(
            f"{last.count:,} vertices to be written for m = {last.m} and n = {last.n}, mn being "
            f"{last.m * last.n:,}",
            "a family made for the purpose: see Lemma 5.5",
        ),
        growth=(gaps, again, written),
    )
