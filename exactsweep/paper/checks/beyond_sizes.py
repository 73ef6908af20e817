"""Beyond the paper: sizes of no-fit polygons of any shape, and of their contact segments."""

from __future__ import annotations

from collections.abc import Iterator

from exactsweep import no_fit_polygon
from exactsweep.corpus.generator.growing import cm_hard, forks
from exactsweep.paper import kernel
from exactsweep.paper.claim import Counterexample, Effort, Evidence, Observation
from exactsweep.paper.counting import count_chains, count_operations, grow, make_counted
from exactsweep.paper.counts import count_all
from exactsweep.paper.functions import describe_difference, no_fit_is_the_definition
from exactsweep.paper.growth import BOUNDS
from exactsweep.paper.pairs import Chains, SweepPair
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.segments import find_contact_segments


def holes(pair: SweepPair) -> int:
    return len(no_fit_polygon(*pair[::-1]).holes)


def count_holes(effort: Effort) -> Iterator[Observation]:
    """Count the holes of no-fit polygons of forks, and compare a small one with the definition."""
    yield Evidence("A family of forks; a small pair is compared with the definition.")
    yield from no_fit_is_the_definition(SweepPair(*forks(18, 18)))
    sizes = [(6 + 12 * k, 6 + 12 * k) for k in range(1, 3 if effort.quick else 4)]
    bound = BOUNDS["(m - 6)²(n - 6)²"]
    together = grow("holes of the no-fit polygon", forks, bound, sizes, holes)
    for series in (together, *count_all("Size of a no-fit polygon", effort)):
        yield series
        for p in series.points:
            if p.count < ((p.m // 6 - 1) * (p.n // 6 - 1) - 1) ** 2:
                yield f"{p.count} holes for ({p.m}, {p.n}), fewer than proved"


def segments(pair: SweepPair) -> int:
    """Count the contact segments after joining them along each line."""
    return len(find_contact_segments([pair.directrix], [inverse(pair.generatrix)]))


def count_contact_segments(effort: Effort) -> Iterator[Observation]:
    """Compare the number of contact segments with its bound."""
    yield Evidence("Contact segments are counted.")
    for series in count_all("Contact segments", effort):
        yield series
        if (most := max(point.ratio for point in series.points)) > 1:
            yield f"the number is {most:.2g} times 2mn"


def edges(pair: SweepPair) -> int:
    """Count the edges of the exterior of the no-fit polygon."""
    return len(no_fit_polygon(*pair[::-1]).exterior)


def convolution(pair: SweepPair) -> int:
    """Count the contact segments of the trajectory and G."""
    scale, path = no_fit_polygon(*pair[::-1]).exterior.lattice()
    moving = [(scale * x, scale * y) for x, y in pair.generatrix]
    return len(find_contact_segments([path], [moving]))


def sum_by_parts(pair: SweepPair) -> int:
    """Count the operations of summing the trajectory and G by convex parts, without pruning."""
    chains = count_chains(pair)
    path = make_counted(kernel.find_trajectory(pair.chains))
    return count_operations(kernel.merge_sub_trajectories, Chains(inverse(chains.bottom), [], path))


def sweep_by_parts(pair: SweepPair) -> int:
    """Count the operations of SweepO_CM as printed."""
    return count_operations(kernel.sweep_outer_cm, *count_chains(pair))


def count_convolution(effort: Effort) -> Iterator[Observation]:
    """Count the operations of two Minkowski sum algorithms for the trajectory and G."""
    yield Evidence("Operations and contact segments are counted.")
    summed, swept, *_ = growth = list(count_all("Minkowski sum algorithms", effort))
    yield from growth
    chains = SweepPair(*cm_hard(32, 32)).chains
    found, expected = kernel.find_outer(chains), kernel.sweep_outer_cm(*chains)
    yield describe_difference("the sum of T and G", found, expected)
    last, other = summed.points[-1], swept.points[-1]
    yield Counterexample(
        f"for m = n = {last.m}, summing T and G by convex parts takes {last.count:,} operations, "
        f"SweepO_CM {other.count:,}: both {summed.verdict} with mn",
        "deep teeth, at the largest counted size",
    )
