"""Beyond the paper: sizes of no-fit polygons of any shape, and of their contact segments."""

from __future__ import annotations

from dataclasses import replace

from exactsweep import no_fit_polygon
from exactsweep.corpus.generator.growing import cm_hard, figure10, forks, mm
from exactsweep.numbers.number import Vertex
from exactsweep.paper import literal
from exactsweep.paper.claim import Counterexample, Effort, Evidence, find_first_failure, weigh
from exactsweep.paper.costs import STEPS
from exactsweep.paper.counting import (
    count_by,
    count_chains,
    count_operations,
    grow,
    make_counted,
)
from exactsweep.paper.functions import no_fit_is_the_definition, tell_difference
from exactsweep.paper.growth import MN, MN2, Bound
from exactsweep.paper.pairs import Chains, SweepPair
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.contact_lines import find_contact_stretches

SPIKES: Bound = ("(m - 6)²(n - 6)²", lambda m, n: float((m - 6) ** 2 * (n - 6) ** 2))
PAIRS: Bound = ("2mn", lambda m, n: 2.0 * m * n)


def count_holes(effort: Effort) -> Evidence:
    """Count the holes of no-fit polygons of forks, and compare a small one with the definition."""

    def holes(pair: SweepPair) -> int:
        return len(no_fit_polygon(*pair[::-1]).holes)

    last = 3 if effort.quick else 4
    growth = [
        grow("holes of the no-fit polygon", forks, SPIKES, sizes, holes)
        for sizes in (
            [(6 + 12 * k, 6 + 12 * k) for k in range(1, last)],
            [(6 + (6 << k), 24) for k in range(1, last + 1)],
        )
    ]
    few = (
        f"{p.count} holes for ({p.m}, {p.n}) are fewer than proved"
        for series in growth
        for p in series.points
        if p.count < ((p.m // 6 - 1) * (p.n // 6 - 1) - 1) ** 2
    )
    failure = no_fit_is_the_definition(SweepPair(*forks(18, 18))) or find_first_failure(few)
    tried = "A family of forks, one of them compared with the definition."
    return weigh(tried, *growth, failure=failure)


def count_contact_segments(effort: Effort) -> Evidence:
    """Count the stretches of the kernel beside the number of contact segments that there can be."""

    def stretches(pair: SweepPair) -> int:
        return len(find_contact_stretches([pair.directrix], [inverse(pair.generatrix)]))

    tried = (forks, effort.sizes(24, 2, 3)), (mm, effort.sizes(16, 3, 4))
    what = "stretches of contact segments"
    growth = [grow(what, family, PAIRS, sizes, stretches) for family, sizes in tried]
    most = max(point.ratio for series in growth for point in series.points)
    return weigh("Counts.", *growth, failure=f"{most:.2g} times 2mn" if most > 1 else "")


def count_trajectory(effort: Effort) -> Evidence:
    """Count the edges of the exterior beside mn, with many holes inside it and with none."""

    def edges(pair: SweepPair) -> int:
        return len(no_fit_polygon(*pair[::-1]).exterior)

    spikes = [(6 + size, 6 + size) for size, _ in effort.sizes(12, 1, 2)]
    tried, what = ((forks, spikes), (mm, effort.sizes(16, 3, 4))), "edges of the trajectory"
    return weigh("Counts.", *(grow(what, family, MN, sizes, edges) for family, sizes in tried))


def count_convolution(effort: Effort) -> Evidence:
    """Run a Minkowski sum algorithm for G and the trajectory, and count what another one cuts."""

    def stretches(pair: SweepPair) -> int:
        scale, path = no_fit_polygon(*pair[::-1]).exterior.lattice()
        moving = [(scale * x, scale * y) for x, y in pair.generatrix]
        return len(find_contact_stretches([path], [moving]))

    def sum_by_parts(pair: SweepPair) -> int:
        chains = count_chains(pair)
        path = make_counted(literal.find_trajectory(pair.chains))
        return count_operations(literal.trajectory_mm, inverse(chains.bottom), path)

    def sweep_by_parts(chains: Chains) -> list[Vertex]:
        return literal.sweep_outer_cm(*chains)

    sizes, what = effort.sizes(16, 2, 3), "stretches of the convolution"
    summed = grow(
        "operations of the sum of T and G by convex parts", cm_hard, MN, sizes, sum_by_parts, STEPS
    )
    by_parts = count_by("operations", sweep_by_parts)
    swept = grow("operations of SweepO_CM", cm_hard, MN, sizes, by_parts, STEPS)
    chains = SweepPair(*cm_hard(32, 32)).chains
    found = weigh(
        "Counts; both to the letter.",
        summed,
        swept,
        grow(what, cm_hard, MN, sizes, stretches),
        grow(what, figure10, MN2, sizes, stretches),
        failure=tell_difference(
            "the sum of T and G", literal.find_outer(chains), literal.sweep_outer_cm(*chains)
        ),
    )
    last, beside = summed.points[-1], swept.points[-1]
    against = Counterexample(
        f"the sum of T and G by convex parts takes {last.count:,} operations for m = n = {last.m}, "
        f"and SweepO_CM {beside.count:,}: both {summed.verdict} with mn",
        "deep teeth, at the largest size that was counted",
    )
    return replace(found, against=against)
