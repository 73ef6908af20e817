"""Section 5.1: how long an MM sweep takes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import product
from math import log2

from exactsweep.corpus.generator.growing import figure10, mm, needles, rim
from exactsweep.geometry.point import Vertex
from exactsweep.paper.checks.section4 import lowest
from exactsweep.paper.checks.section5_sizes import (
    GRID,
    MN2,
    OUTGROWING,
    beyond_mn2,
    inner_boundary,
    outgrows_its_parts,
    sizes_from,
    whole_trajectory,
)
from exactsweep.paper.claim import Claim, Counterexample, Evidence, Run, Status, first_failure
from exactsweep.paper.counting import Family, counted, counting, operations_grow, vertices_grow
from exactsweep.paper.functions import bottom_of, differs, exact, reference, text
from exactsweep.paper.growth import Growth, doubled, grow
from exactsweep.paper.laws import Trial
from exactsweep.paper.pairs import Chains, Pair
from exactsweep.procedures.chain import complement, convex_parts, inverse
from exactsweep.procedures.cm import trajectory_cm
from exactsweep.procedures.convex_part import split_envelope, split_parts
from exactsweep.procedures.envelope import Envelope
from exactsweep.procedures.lower_envelope import lower_envelope_mm
from exactsweep.procedures.mm import outer_mm
from exactsweep.procedures.mm_inner import inner_mm, take_inside
from exactsweep.procedures.part_pairs import sweep_pairs

MN = ("mn", lambda m, n: float(m * n))
SUM_LOG = ("(m + n) log m", lambda m, n: (m + n) * log2(m))
MN_LOG = ("mn log n", lambda m, n: m * n * log2(n))
MN2_LOG = ("mn² log n", lambda m, n: m * n * n * log2(n))

# How far the counts of an MM sweep may rise at a step, where one more batch is needed.
STEPS = 1.35


def _check_two_chains(run: Run) -> Evidence:
    def count(m: int, n: int) -> tuple[int, float]:
        first = [(2 * k, (k % 2) * 10) for k in range(m)]
        second = [(2 * k, 6 - (k % 2)) for k in range(n)]
        with counting() as tally:
            merged = lower_envelope_mm([Envelope.of(counted(first)), Envelope.of(counted(second))])
            out = len(list(merged))
        return tally.total + out, m + n

    growth = grow("operations of one merge", "zigzags", "m + n", doubled(64, 4), count)
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


def _check_levels(run: Run) -> Evidence:
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
    growth = tuple(_envelope_growth(family, run) for family in (figure10, mm))
    return Evidence(
        "All pairs of chains of one or two edges on a tiny grid; counts.",
        first_failure(g.failure() for g in growth),
        against,
        growth=growth,
    )


def _envelope_growth(family: Family, run: Run) -> Growth:
    """Operations of LowerEnvelope_MM beside N log k, N the size of what goes in."""

    def count(m: int, n: int) -> tuple[int, float]:
        top, _, directrix = Pair(*family(m, n)).chains
        with counting() as tally:
            chains = [
                trajectory_cm(counted(inverse(part)), counted(directrix))  # type: ignore[arg-type]
                for part in convex_parts(inverse(top))
            ]
            before, size = tally.total, sum(len(chain.edges) for chain in chains)
            merged = lower_envelope_mm(chains)
        return tally.total - before + len(merged.edges), size * max(1.0, log2(len(chains)))

    return grow(
        "operations of LowerEnvelope_MM", family.__name__, "N log k", sizes_from(run), count
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


def _check_lower_envelope_mm(run: Run) -> Evidence:
    trial = Trial(run).of(lower_envelope_mm_is_right, "MM", 100)
    trial.of(lower_envelope_mm_is_right, "MM", 60, strict=False)
    return Evidence(trial.tried, trial.failure)


def _check_corollary_5_7(run: Run) -> Evidence:
    growth = tuple(
        operations_grow("Trajectory_MM", whole_trajectory, family, MN_LOG, sizes_from(run))
        for family in (figure10, mm)
    )
    found = outgrows_its_parts(OUTGROWING)
    text = f"the size that it rests on fails: {found}"
    against = Counterexample(text, GRID, *OUTGROWING) if found else None
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


def _check_corollary_5_8(run: Run) -> Evidence:
    sizes = sizes_from(run, 8)

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
    boundary = sweep_pairs(
        split_parts(inverse(chains.top)), list(split_envelope(take_inside(trajectory)))
    )
    boundary = boundary.restrict(-directrix[-1][0], -directrix[0][0])
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
        chains = Chains(*(counted(chain) for chain in Pair(*rim(m, n)).chains))  # type: ignore[arg-type]
        trajectory = whole_trajectory(chains)
        with counting() as tally:
            out = len(inner(chains, trajectory))
        return tally.total + out, bound[1](m, n)

    return grow(f"operations of the inner boundary, {what}", rim.__name__, bound[0], sizes, count)


def _gaps_give_the_same(pair: Pair) -> str:
    """Sweeping the gaps alone gives the inner boundary of Sweep_MM."""
    chains = pair.chains
    trajectory = whole_trajectory(chains)
    return differs(
        "the inner boundary",
        inner_by_gaps(chains, trajectory),
        inner_again(chains, trajectory),
    )


def _check_faster_inner(run: Run) -> Evidence:
    sizes = [(16, n) for _, n in sizes_from(run, 8)]
    written = vertices_grow("inner boundary", inner_boundary, needles, MN2, sizes)
    gaps = _inner_grows("gaps only", inner_by_gaps, SUM_LOG, sizes_from(run))
    again = _inner_grows("Trajectory_MM again", inner_again, MN, sizes_from(run))
    trial = Trial(run).of(_gaps_give_the_same, "MM", 100)
    last = written.points[-1]
    return Evidence(
        f"{trial.tried} Operations counted where most of D_b is touched: "
        f"{gaps.points[-1].count:,} in place of {again.points[-1].count:,} at m = n = "
        f"{gaps.points[-1].m}. A family of needles, vertices counted.",
        trial.failure
        or gaps.failure()
        or ("" if written.is_attained else "the inner boundary falls behind mn²")
        or ("" if again.is_attained else "calling Trajectory_MM again takes less than order mn"),
        Counterexample(
            f"{last.count - 1:,} edges to be written for m = {last.m} and n = {last.n}, mn being "
            f"{last.m * last.n:,}",
            "a family made for the purpose: see Lemma 5.5",
        ),
        growth=(gaps, again, written),
    )


CLAIMS = (
    Claim(
        "Two chains in linear time",
        "5.1",
        "The lower envelope of two monotone chains takes time linear in their sizes (said without "
        "proof).",
        Status.REPRODUCED,
        (
            "exactsweep.procedures.lower_envelope.merge",
            "exactsweep.procedures.lower_envelope.lower_envelope_mm",
        ),
        _check_two_chains,
    ),
    Claim(
        "Levels of divide and conquer",
        "5.1",
        "Each level of the recursion takes time and space proportional to the size of the "
        "sub-trajectories.",
        Status.REFUTED,
        ("exactsweep.procedures.lower_envelope.lower_envelope_mm",),
        _check_levels,
        "To the size of what that level merges, which can be larger than what the first level "
        "merged: by a factor of two at once, and by any constant in the end, though by no more "
        "than a constant times alpha(N) for N edges (see Lemma 5.2).",
    ),
    Claim(
        "LowerEnvelope_MM",
        "5.1",
        "Merge the sub-trajectories by divide and conquer, two chains walked in vertical sync.",
        Status.REPRODUCED,
        (
            "exactsweep.procedures.lower_envelope.lower_envelope_mm",
            "exactsweep.procedures.lower_envelope.merge",
        ),
        _check_lower_envelope_mm,
    ),
    Claim(
        "Corollary 5.7",
        "5.1",
        "Trajectory_MM takes time O(mn log n) and space O(mn).",
        Status.REFUTED,
        ("exactsweep.procedures.mm.trajectory_mm",),
        _check_corollary_5_7,
        "The trajectory alone can take more space, by a factor alpha(min(m, n)) (Lemma 5.2). With "
        "that factor both bounds hold. On the families counted, the operations stay in proportion "
        "to the bound as printed, or below.",
    ),
    Claim(
        "Corollary 5.8",
        "5.1",
        "Sweep_MM takes time O(mn² log n) and space O(mn²) for both loops, which is the optimum "
        "for the outer loop but for the factor log n.",
        Status.REFUTED,
        ("exactsweep.procedures.mm.sweep_mm",),
        _check_corollary_5_8,
        "The outer loop alone can take more space (Lemma 5.6). Up to inverse Ackermann factors "
        "both bounds hold, and the time is the optimum but for these and log n. Since Lemma 5.5 "
        "fails, that is so for the inner loop as well.",
    ),
    Claim(
        "A faster inner loop",
        "5.1",
        "For the inner loop of an MM sweep there is a more efficient algorithm (said without "
        "giving it).",
        Status.CONDITION,
        ("exactsweep.procedures.mm_inner.inner_mm", "exactsweep.procedures.mm_inner.find_gaps"),
        _check_faster_inner,
        "Where G touches D_b the inner boundary is D_b, and the edges of the trajectory say where "
        "that is; only the gaps between have to be swept. Where they are few, that takes O((m + n) "
        "log m) beyond the trajectory, while calling Trajectory_MM again takes order mn. In the "
        "worst case writing the boundary out takes order mn² (see Lemma 5.5), so that no algorithm "
        "gains more than the factor log n.",
    ),
)
