"""Beyond the paper: sizes of no-fit polygons of any shape, and of their contact segments."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import lcm

from exactsweep import no_fit_polygon
from exactsweep.corpus.generator.growing import cm_hard, figure10, forks, mm
from exactsweep.corpus.generator.shapes import Ring
from exactsweep.numbers.number import Vertex
from exactsweep.paper import literal
from exactsweep.paper.claim import Counterexample, Effort, Evidence, find_first_failure, weigh
from exactsweep.paper.costs import STEPS
from exactsweep.paper.counting import PairFamily, operations
from exactsweep.paper.functions import no_fit_is_the_definition, tell_difference
from exactsweep.paper.growth import MN, MN2, Bound, Growth, double, grow
from exactsweep.paper.pairs import Chains, SweepPair
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.contact_lines import find_contact_stretches

SPIKES: Bound = ("(m - 6)²(n - 6)²", lambda m, n: float((m - 6) ** 2 * (n - 6) ** 2))
PAIRS: Bound = ("2mn", lambda m, n: 2.0 * m * n)


def _grow(
    what: str,
    count: Callable[[Ring, Ring], int],
    family: PairFamily,
    bound: Bound,
    sizes: list[tuple[int, int]],
) -> Growth:
    """Count something of the pairs (G, D) of a family beside a bound."""

    def beside(m: int, n: int) -> tuple[float, float]:
        return count(*family(m, n)), bound[1](m, n)

    return grow(what, family.__name__, bound[0], sizes, beside)


def count_holes(effort: Effort) -> Evidence:
    """Count the holes of no-fit polygons of forks, and compare a small one with the definition."""

    def holes(generatrix: Ring, directrix: Ring) -> int:
        return len(no_fit_polygon(directrix, generatrix).holes)

    last = 3 if effort.quick else 4
    growth = [
        _grow("holes of the no-fit polygon", holes, forks, SPIKES, sizes)
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

    def stretches(generatrix: Ring, directrix: Ring) -> int:
        return len(find_contact_stretches([directrix], [inverse(generatrix)]))

    last, what = 3 if effort.quick else 4, "stretches of contact segments"
    growth = [
        _grow(what, stretches, forks, PAIRS, [(6 << k, 6 << k) for k in range(2, last + 2)]),
        _grow(what, stretches, mm, PAIRS, double(16, last)),
    ]
    most = max(point.ratio for series in growth for point in series.points)
    return weigh("Counts.", *growth, failure=f"{most:.2g} times 2mn" if most > 1 else "")


def count_trajectory(effort: Effort) -> Evidence:
    """Count the edges of the exterior beside mn, with many holes inside it and with none."""

    def edges(generatrix: Ring, directrix: Ring) -> int:
        return len(no_fit_polygon(directrix, generatrix).exterior)

    last, what = 2 if effort.quick else 3, "edges of the trajectory"
    sizes = [(6 + (6 << k), 6 + (6 << k)) for k in range(1, last + 1)]
    tried = (forks, sizes), (mm, double(16, last + 1))
    return weigh("Counts.", *(_grow(what, edges, family, MN, sizes) for family, sizes in tried))


def count_convolution(effort: Effort) -> Evidence:
    """Run a Minkowski sum algorithm for G and the trajectory, and count what another one cuts."""

    def stretches(generatrix: Ring, directrix: Ring) -> int:
        corners = no_fit_polygon(directrix, generatrix).exterior.vertices
        scale = lcm(*(c.denominator for corner in corners for c in corner))
        path = [(int(x * scale), int(y * scale)) for x, y in corners]
        return len(
            find_contact_stretches([path], [[(scale * x, scale * y) for x, y in generatrix]])
        )

    def sum_by_parts(chains: Chains) -> list[Vertex]:
        return literal.trajectory_mm(inverse(chains.bottom), chains.directrix)

    def beyond(run: Callable[[Chains], Iterable[Vertex]], what: str, *, of_path: bool) -> Growth:
        def count(m: int, n: int) -> tuple[int, float]:
            chains = SweepPair(*cm_hard(m, n)).chains
            path = literal.find_trajectory(chains) if of_path else chains.directrix
            return operations(run, chains._replace(directrix=path)), m * n

        return grow(f"operations of {what}", "cm_hard", "mn", sizes, count, limit=STEPS)

    sizes, what = double(16, 2 if effort.quick else 3), "stretches of the convolution"
    summed = beyond(sum_by_parts, "the sum of T and G by convex parts", of_path=True)
    swept = beyond(lambda chains: literal.sweep_outer_cm(*chains), "SweepO_CM", of_path=False)
    chains = SweepPair(*cm_hard(32, 32)).chains
    found = weigh(
        "Counts; both to the letter.",
        summed,
        swept,
        _grow(what, stretches, cm_hard, MN, sizes),
        _grow(what, stretches, figure10, MN2, sizes),
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
    return Evidence(found.tried, found.failure, against, growth=found.growth)
