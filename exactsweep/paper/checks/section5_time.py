"""Section 5.1: how long an MM sweep takes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import product
from math import log2

from exactsweep.corpus.generator.growing import figure10, mm, needles, rim
from exactsweep.geometry.point import Vertex
from exactsweep.paper.checks.section4 import lowest
from exactsweep.paper.checks.section5_sizes import (
    MN2,
    OUTGROWING,
    beyond_mn2,
    inner_boundary,
    outgrows_its_parts,
    sizes_from,
    whole_trajectory,
)
from exactsweep.paper.claim import Counterexample, Effort, Evidence, first_failure
from exactsweep.paper.counting import Family, counting, make_counted, operations_grow, vertices_grow
from exactsweep.paper.functions import bottom_of, differs, exact, reference, text
from exactsweep.paper.growth import Growth, double, grow
from exactsweep.paper.pairs import Chains, Pair
from exactsweep.procedures.chain import complement, convex_parts, inverse
from exactsweep.procedures.cm import trajectory_cm
from exactsweep.procedures.convex_part import joined_parts
from exactsweep.procedures.envelope import Envelope
from exactsweep.procedures.lower_envelope import lower_envelope_mm
from exactsweep.procedures.mm import outer_mm
from exactsweep.procedures.mm_inner import inner_mm, inside_runs
from exactsweep.procedures.part_pairs import sweep_pairs

MN = ("mn", lambda m, n: float(m * n))
SUM_LOG = ("(m + n) log m", lambda m, n: (m + n) * log2(m))
MN_LOG = ("mn log n", lambda m, n: m * n * log2(n))
MN2_LOG = ("mn² log n", lambda m, n: m * n * n * log2(n))

# How far the counts of an MM sweep may rise at a step, where one more batch is needed.
STEPS = 1.35


def count_one_merge(effort: Effort) -> Evidence:
    """Count the operations of one merge, and merge all tiny chains."""

    def count(m: int, n: int) -> tuple[int, float]:
        first = [(2 * k, (k % 2) * 10) for k in range(m)]
        second = [(2 * k, 6 - (k % 2)) for k in range(n)]
        with counting() as tally:
            chains = [Envelope.of(make_counted(chain)) for chain in (first, second)]
            merged = lower_envelope_mm(chains)
            out = len(list(merged))
        return tally.total + out, m + n

    growth = grow("operations of one merge", "zigzags", "m + n", double(64, 4), count)
    failure = growth.failure() or first_failure(
        lowest("chain", [a, b], list(lower_envelope_mm([Envelope.of(a), Envelope.of(b)])))
        for a, b in product(_tiny_chains(), repeat=2)
    )
    return Evidence(
        "All pairs of chains of one or two edges on a tiny grid; counts for 64 to 1024 points.",
        failure,
        None,
        (),
        (growth,),
    )


def _tiny_chains() -> list[list[Vertex]]:
    """Chains over 0, 1 and 2, at heights 0 to 2, those of one edge first."""
    straight: list[list[Vertex]] = [[(0, a), (2, b)] for a, b in product(range(3), repeat=2)]
    bends: list[list[Vertex]] = [
        [(0, a), (1, b), (2, c)] for a, b, c in product(range(3), repeat=3) if a + c != 2 * b
    ]
    return straight + bends


def find_growing_level(effort: Effort) -> Evidence:
    """Look for two chains with a larger envelope than both, and count the operations."""
    against = None
    for first, second in sorted(product(_tiny_chains(), repeat=2), key=lambda p: sum(map(len, p))):
        merged = exact(lower_envelope_mm([Envelope.of(first), Envelope.of(second)]))
        if len(merged) - 1 > len(first) + len(second) - 2:
            against = Counterexample(
                f"the chains {text(first)} and {text(second)} have {len(first) + len(second) - 2} "
                f"edges, their lower envelope {len(merged) - 1}",
                "the first of all pairs of chains with up to two edges on the 3 by 3 grid",
            )
            break
    growth = tuple(_envelope_growth(family, effort) for family in (figure10, mm))
    return Evidence(
        "All pairs of chains of one or two edges on a tiny grid; counts.",
        first_failure(g.failure() for g in growth),
        against,
        growth=growth,
    )


def _envelope_growth(family: Family, effort: Effort) -> Growth:
    """Operations of LowerEnvelope_MM beside N log k, N the size of what goes in."""

    def count(m: int, n: int) -> tuple[int, float]:
        top, _, directrix = Pair(*family(m, n)).chains
        with counting() as tally:
            chains = [
                trajectory_cm(make_counted(inverse(part)), make_counted(directrix))  # type: ignore[arg-type]
                for part in convex_parts(inverse(top))
            ]
            before, size = tally.total, sum(len(chain.edges) for chain in chains)
            merged = lower_envelope_mm(chains)
        return tally.total - before + len(merged.edges), size * max(1.0, log2(len(chains)))

    return grow(
        "operations of LowerEnvelope_MM", family.__name__, "N log k", sizes_from(effort), count
    )


def lower_envelope_mm_is_right(pair: Pair) -> str:
    """LowerEnvelope_MM returns what is lowest over every x."""
    top, _, directrix = pair.chains
    parts = convex_parts(inverse(top))
    chains = [trajectory_cm(inverse(part), directrix) for part in parts]
    found = lower_envelope_mm(chains)
    return lowest("sub-trajectory", [list(chain) for chain in chains], list(found)) or differs(
        "the lower envelope", found, bottom_of(reference(pair).trajectory)
    )


def count_trajectory(effort: Effort) -> Evidence:
    """Count the operations of Trajectory_MM."""
    growth = tuple(
        operations_grow("Trajectory_MM", whole_trajectory, family, MN_LOG, sizes_from(effort))
        for family in (figure10, mm)
    )
    found = outgrows_its_parts(OUTGROWING)
    how = "the first of the non-convex quadrilaterals on the 4 by 4 grid"
    against = Counterexample(found, how, *OUTGROWING) if found else None
    return _counted(growth, "", against)


def _counted(growth: tuple[Growth, ...], failure: str, against: Counterexample | None) -> Evidence:
    """Flat counts, beside a size that is not what the proof takes it for.

    What is swept goes in batches, each three times the last, so that the counts rise in steps.
    """
    return Evidence(
        f"Counts for n = {growth[0].points[0].n} to {growth[0].points[-1].n}.",
        failure or first_failure(g.failure(STEPS) for g in growth),
        against,
        growth=growth,
    )


def count_loops(effort: Effort) -> Evidence:
    """Count the operations of Sweep_MM."""
    sizes = sizes_from(effort, 8)

    def inner(chains: Chains) -> list[Vertex]:
        return inner_mm(chains.top, whole_trajectory(chains), chains.directrix)

    def outer(chains: Chains) -> Envelope:
        return outer_mm(chains.bottom, whole_trajectory(chains))

    growth = (
        operations_grow("Sweep_MM, inner", inner, needles, MN2_LOG, [(16, n) for _, n in sizes]),
        operations_grow("Sweep_MM, inner", inner, mm, MN2_LOG, sizes),
        operations_grow("Sweep_MM, outer", outer, figure10, MN2_LOG, sizes),
    )
    failure, against, _ = beyond_mn2()
    return _counted(growth, failure, against)


def inner_again(chains: Chains, trajectory: Envelope) -> list[Vertex]:
    """The inner boundary as Sweep_MM has it: Trajectory_MM along all of T's inside."""
    directrix = chains.directrix
    boundary = sweep_pairs(joined_parts(inverse(chains.top)), inside_runs(trajectory))
    boundary = boundary.restricted(-directrix[-1][0], -directrix[0][0])
    return inverse(complement(list(boundary)))


def inner_by_gaps(chains: Chains, trajectory: Envelope) -> list[Vertex]:
    """The inner boundary as the kernel has it: only what G does not touch of D_b is swept."""
    return inner_mm(chains.top, trajectory, chains.directrix)


def _inner_grows(
    what: str,
    inner: Callable[[Chains, Envelope], list[Vertex]],
    bound: tuple[str, Callable[[int, int], float]],
    sizes: Iterable[tuple[int, int]],
) -> Growth:
    """Operations beyond the trajectory, on a family that is touched almost everywhere."""

    def count(m: int, n: int) -> tuple[int, float]:
        chains = Chains(*(make_counted(chain) for chain in Pair(*rim(m, n)).chains))  # type: ignore[arg-type]
        trajectory = whole_trajectory(chains)
        with counting() as tally:
            out = len(inner(chains, trajectory))
        return tally.total + out, bound[1](m, n)

    return grow(f"operations of the inner boundary, {what}", rim.__name__, bound[0], sizes, count)


def gaps_give_the_same(pair: Pair) -> str:
    """Sweeping the gaps alone gives the inner boundary of Sweep_MM."""
    chains = pair.chains
    trajectory = whole_trajectory(chains)
    return differs(
        "the inner boundary",
        inner_by_gaps(chains, trajectory),
        inner_again(chains, trajectory),
    )


def count_gaps(effort: Effort) -> Evidence:
    """Count the operations of both ways to the inner boundary, and what is written."""
    sizes = [(16, n) for _, n in sizes_from(effort, 8)]
    written = vertices_grow("inner boundary", inner_boundary, needles, MN2, sizes)
    gaps = _inner_grows("gaps only", inner_by_gaps, SUM_LOG, sizes_from(effort))
    again = _inner_grows("Trajectory_MM again", inner_again, MN, sizes_from(effort))
    last = written.points[-1]
    return Evidence(
        f"Operations counted where most of D_b is touched: "
        f"{gaps.points[-1].count:,} in place of {again.points[-1].count:,} at m = n = "
        f"{gaps.points[-1].m}. A family of needles, vertices counted.",
        gaps.failure()
        or ("" if written.is_attained else "the inner boundary falls behind mn²")
        or ("" if again.is_attained else "calling Trajectory_MM again takes less than order mn"),
        Counterexample(
            f"{last.count - 1:,} edges to be written for m = {last.m} and n = {last.n}, mn being "
            f"{last.m * last.n:,}",
            "a family made for the purpose: see Lemma 5.5",
        ),
        growth=(gaps, again, written),
    )
