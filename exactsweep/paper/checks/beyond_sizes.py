"""Beyond the paper: how large no-fit polygons of any shape get, and what they are made of."""

from __future__ import annotations

from collections.abc import Callable
from math import lcm

from exactsweep import no_fit_polygon
from exactsweep.corpus.generator.growing import cm_hard, figure10, forks, mm
from exactsweep.corpus.generator.shapes import Ring
from exactsweep.paper.checks.beyond import no_fit_is_the_definition
from exactsweep.paper.claim import Counterexample, Effort, Evidence, find_first_failure
from exactsweep.paper.counting import PairFamily
from exactsweep.paper.growth import MN, MN2, Bound, Growth, double, grow
from exactsweep.paper.pairs import SweepPair
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


def _beside_bounds(*growth: Growth, failure: str = "", tried: str = "Counts.") -> Evidence:
    failure = failure or find_first_failure(series.failure for series in growth)
    return Evidence(tried, failure, growth=growth)


def count_holes(effort: Effort) -> Evidence:
    """Count the holes of no-fit polygons of forks, and hold a small one against the definition."""

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
    tried = "A family of forks, one of them held against the definition."
    return _beside_bounds(*growth, failure=failure, tried=tried)


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
    return _beside_bounds(*growth, failure=f"{most:.2g} times 2mn" if most > 1 else "")


def count_trajectory(effort: Effort) -> Evidence:
    """Count the edges of the exterior beside mn, with many holes inside it and with none."""

    def edges(generatrix: Ring, directrix: Ring) -> int:
        return len(no_fit_polygon(directrix, generatrix).exterior)

    last, what = 2 if effort.quick else 3, "edges of the trajectory"
    sizes = [(6 + (6 << k), 6 + (6 << k)) for k in range(1, last + 1)]
    return _beside_bounds(
        _grow(what, edges, forks, MN, sizes), _grow(what, edges, mm, MN, double(16, last + 1))
    )


def count_convolution(effort: Effort) -> Evidence:
    """Count the contact segments of G and the trajectory, beside the bound on the outer loop."""

    def stretches(generatrix: Ring, directrix: Ring) -> int:
        corners = no_fit_polygon(directrix, generatrix).exterior.vertices
        scale = lcm(*(c.denominator for corner in corners for c in corner))
        path = [(int(x * scale), int(y * scale)) for x, y in corners]
        return len(
            find_contact_stretches([path], [[(scale * x, scale * y) for x, y in generatrix]])
        )

    sizes, what = double(16, 2 if effort.quick else 3), "stretches of the convolution"
    found = _beside_bounds(
        _grow(what, stretches, cm_hard, MN, sizes), _grow(what, stretches, figure10, MN2, sizes)
    )
    last = found.growth[0].points[-1]
    against = Counterexample(
        f"the convolution of G and T has {last.count:,} contact segments for m = n = {last.m}, "
        f"{last.ratio:.2g} mn, which is the order of the outer loop",
        "deep teeth, at the largest size that was counted",
    )
    return Evidence(found.tried, found.failure, against, growth=found.growth)
