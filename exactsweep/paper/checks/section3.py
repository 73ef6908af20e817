"""Section 3: convex generatrix, convex directrix."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

from exactsweep import Polygon, sweep
from exactsweep.corpus.generator.growing import cc
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.point import Edge, Rational, Vertex
from exactsweep.paper.checks.touching import contacts_are_right
from exactsweep.paper.claim import Claim, Counterexample, Evidence, Run, Status, first_failure
from exactsweep.paper.counting import operations_grow
from exactsweep.paper.functions import bottom_of, differs, exact, reference
from exactsweep.paper.growth import doubled
from exactsweep.paper.laws import Law, Trial
from exactsweep.paper.pairs import Pair
from exactsweep.paper.tiny import convex_and_strict, is_strict, smallest_pair
from exactsweep.procedures.cc import sweep_inner_cc, sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import convex_chain, convex_parts, inverse, reverse

GRID = "the first of all such pairs on the 3 by 3 grid, fewest vertices first"
M_PLUS_N = ("m + n", lambda m, n: float(m + n))


def slope(edge: Edge) -> Fraction:
    """The slope of an edge, growing counter-clockwise; the same for the reversed edge."""
    (px, py), (qx, qy) = edge
    return Fraction(qy - py) / (qx - px)


def laid_by_slope(start: Vertex, edges: Sequence[Edge], sign: int = 1) -> list[Vertex]:
    """Edges laid end to end, each to the right, in ascending order of slope (or descending)."""
    chain: list[Vertex] = [start]
    for (px, py), (qx, qy) in sorted(edges, key=lambda edge: sign * slope(edge)):
        x, y = chain[-1]
        run: Rational = qx - px if qx > px else px - qx
        rise: Rational = qy - py if qx > px else py - qy
        chain.append((x + run, y + rise))
    return exact(chain)


def start_of(top: Sequence[Vertex], directrix: Sequence[Vertex]) -> Vertex:
    """Where the trajectory starts: the right end of G_t on the left end of D_b."""
    return directrix[0][0] - top[0][0], directrix[0][1] - top[0][1]


def merged(pair: Pair, sign: int = 1) -> list[Vertex]:
    """Lemma 3.1 as it stands: the edges of reversed G_t and of D_b sorted by slope."""
    top, _, directrix = pair.chains
    edges = [*reverse(list(pairwise(top))), *pairwise(directrix)]
    return laid_by_slope(start_of(top, directrix), edges, sign)


def _check_definition_3_1(run: Run) -> Evidence:
    def law(pair: Pair) -> str:
        """Reversed twice, a chain is itself; reversed and laid end to end, it is its inverse."""
        top = pair.chains.top
        edges = list(pairwise(top))
        turned = reverse(edges)
        if [(q, p) for p, q in turned] != edges or reverse(turned) != edges:
            return "the edges are not the same in the same order, each the other way round"
        if list(map(slope, turned)) != list(map(slope, edges)):
            return "the slopes change"
        x, y = inverse(top)[0]
        laid = [(x, y)]
        for (px, py), (qx, qy) in turned:
            x, y = x + qx - px, y + qy - py
            laid.append((x, y))
        return "" if laid == inverse(top) else "laid end to end they are not the inverse of G_t"

    trial = Trial(run)
    for kind in ("CC", "MM"):
        trial.of(law, kind, 100)
    return Evidence(trial.tried, trial.failure)


def _check_convex_chain(run: Run) -> Evidence:
    def fails(pair: Pair) -> str:
        directrix = pair.chains.directrix
        try:
            closed = Polygon(directrix)
        except PolygonError:
            return ""
        expected = bottom_of(reference(pair).trajectory)
        if not closed.is_convex or merged(pair) == expected:
            return ""
        return "D_b, closed by an edge, is convex; the merge by slope is not the trajectory"

    def law(pair: Pair) -> str:
        """A chain that turns left everywhere is one convex part, and merges by slope."""
        directrix = pair.chains.directrix
        if exact(convex_chain(directrix)) != exact(directrix):
            return "a chain that turns left at every vertex is another one as a convex chain"
        return trajectory_by_slope(pair)

    def bulging(pair: Pair) -> str:
        """A chain that turns right everywhere has as many convex parts as edges."""
        chain = [(x, -y) for x, y in pair.chains.directrix]
        parts = convex_parts(chain)
        if len(parts) != len(chain) - 1:
            return f"a chain that turns right has {len(parts)} convex parts"
        return ""

    trial = Trial(run).of(law, "CC", 60).of(bulging, "CC", 60)
    found = smallest_pair(2, 8, convex_and_strict, is_strict, fails)
    return Evidence(trial.tried, trial.failure, found and Counterexample(found[1], GRID, *found[0]))


def _check_slope(run: Run) -> Evidence:
    def fails(pair: Pair) -> str:
        expected = bottom_of(reference(pair).trajectory)
        if merged(pair, sign=-1) == expected:
            return ""
        return "sorted by slopes that grow clockwise, the edges do not make the trajectory"

    trial = Trial(run).of(trajectory_by_slope, "CC", 60).of(trajectory_cc_is_right, "CC", 60)
    found = smallest_pair(2, 7, convex_and_strict, convex_and_strict, fails)
    return Evidence(trial.tried, trial.failure, found and Counterexample(found[1], GRID, *found[0]))


def trajectory_by_slope(pair: Pair) -> str:
    """The merge by slope is the trajectory of the definition."""
    return differs("the merge by slope", merged(pair), bottom_of(reference(pair).trajectory))


def trajectory_cc_is_right(pair: Pair) -> str:
    """Trajectory_CC returns the trajectory of the definition."""
    top, _, directrix = pair.chains
    expected = bottom_of(reference(pair).trajectory)
    return differs("Trajectory_CC", trajectory_cc(top, directrix), expected)


def inner_cc_is_right(pair: Pair) -> str:
    """SweepI_CC returns D_b, which is the inner boundary of the definition."""
    top, _, directrix = pair.chains
    expected = bottom_of(reference(pair).inner)
    found = sweep_inner_cc(top, directrix)
    return differs("SweepI_CC", found, expected) or differs("D_b", directrix, expected)


def outer_by_slope(pair: Pair) -> str:
    """The edges of all three chains, sorted by slope, are the outer boundary."""
    top, bottom, directrix = pair.chains
    x, y = start_of(top, directrix)
    edges = [*reverse(list(pairwise(top))), *pairwise(bottom), *pairwise(directrix)]
    found = laid_by_slope((x + bottom[0][0], y + bottom[0][1]), edges)
    return differs("the merge by slope", found, bottom_of(reference(pair).outer))


def outer_cc_is_right(pair: Pair) -> str:
    """SweepO_CC returns the outer boundary of the definition."""
    expected = bottom_of(reference(pair).outer)
    return differs("SweepO_CC", sweep_outer_cc(*pair.chains), expected)


def _try(run: Run, *laws: Law) -> Evidence:
    trial = Trial(run)
    for law in laws:
        trial.of(law, "CC", 150).of(law, "CC", 100, strict=False)
    return Evidence(trial.tried, trial.failure)


def _check_corollary_3_3(run: Run) -> Evidence:
    attained = 0

    def law(pair: Pair) -> str:
        """All loops are convex and no larger than stated."""
        nonlocal attained
        s, loops, (n, m) = sweep(*pair), reference(pair), map(len, pair)
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
        attained += len(s.outer) == m + 2 * n
        return ""

    trial = Trial(run).of(law, "CC", 200).of(law, "CC", 100, strict=False)
    failure = trial.failure or ("" if attained else "the bounds are never attained")
    return Evidence(
        f"{trial.tried} The bound for the outer loop is attained by {attained} of them.", failure
    )


def _check_corollary_3_4(run: Run) -> Evidence:
    sizes = doubled(64, 3 if run.quick else 5)
    growth = (
        operations_grow(
            "Trajectory_CC", lambda c: trajectory_cc(c.top, c.directrix), cc, M_PLUS_N, sizes
        ),
        operations_grow(
            "SweepI_CC", lambda c: sweep_inner_cc(c.top, c.directrix), cc, M_PLUS_N, sizes
        ),
        operations_grow("SweepO_CC", lambda c: sweep_outer_cc(*c), cc, M_PLUS_N, sizes),
    )
    failure = first_failure(g.failure() for g in growth)
    return Evidence(f"Counts for m = n = 64 to {sizes[-1][0]}.", failure, growth=growth)


def _check_touched(run: Run) -> Evidence:
    def law(pair: Pair) -> str:
        """Every edge of D is in a VE or EE contact."""
        s = sweep(*pair)
        if failure := contacts_are_right(s):
            return failure
        slid = {c.directrix for at in s.contacts for c in at if c.event in ("VE", "EE")}
        missing = set(range(len(s.directrix))) - slid
        return f"edges {sorted(missing)} of D are not slid along" if missing else ""

    trial = Trial(run).of(law, "CC", 100).of(law, "CC", 60, strict=False)
    return Evidence(trial.tried, trial.failure)


CLAIMS = (
    Claim(
        "Convex chain",
        "3",
        "A chain is convex if a straight edge between its ends makes it a convex polygon.",
        Status.CONDITION,
        ("exactsweep.procedures.chain.convex_parts", "exactsweep.procedures.chain.convex_chain"),
        _check_convex_chain,
        "The convex polygon has to be a counter-clockwise one, or the chain a single edge, which "
        "closes to nothing: a chain is convex if it turns left at every vertex. Lemma 3.1 needs "
        "the side to which it bulges.",
    ),
    Claim(
        "Definition 3.1",
        "3",
        "Reversing a chain turns each edge round and leaves the edges in their order.",
        Status.REPRODUCED,
        ("exactsweep.procedures.chain.reverse", "exactsweep.procedures.chain.inverse"),
        _check_definition_3_1,
        "The slope, being a tangent, does not change; laid end to end, the reversed edges are the "
        "inverse of the chain (Definition 5.1).",
    ),
    Claim(
        "Slope",
        "3",
        "The slope of an edge is the tangent of its angle, measured clockwise from the X axis.",
        Status.REFUTED,
        ("exactsweep.procedures.cc.merge_by_slope", "exactsweep.procedures.envelope.cross"),
        _check_slope,
        "The angle is measured counter-clockwise (a slip of the pen): clockwise, the slopes of a "
        "counter-clockwise convex bottom chain descend, and Lemma 3.1 has them ascend.",
    ),
    Claim(
        "Lemma 3.1",
        "3",
        "The CC trajectory T(G_t, D_b) consists of the edges of reversed G_t and of D_b, in order "
        "of slope.",
        Status.REPRODUCED,
        ("exactsweep.procedures.cc.trajectory_cc", "exactsweep.procedures.cc.merge_by_slope"),
        lambda run: _try(run, trajectory_by_slope, trajectory_cc_is_right),
        "Parallel edges, in either order, make one edge.",
    ),
    Claim(
        "Lemma 3.2",
        "3",
        "In a CC sweep the inner boundary is D_b; the outer one consists of the edges of reversed "
        "G_t, of G_b and of D_b, in order of slope.",
        Status.REPRODUCED,
        ("exactsweep.procedures.cc.sweep_inner_cc", "exactsweep.procedures.cc.sweep_outer_cc"),
        lambda run: _try(run, inner_cc_is_right, outer_by_slope, outer_cc_is_right),
    ),
    Claim(
        "Every edge of D is touched",
        "4",
        "In a CC sweep G slides along every edge of D (said in Section 4 without proof).",
        Status.REPRODUCED,
        ("exactsweep.evidence.swept.Swept.contacts",),
        _check_touched,
    ),
    Claim(
        "Corollary 3.3",
        "3",
        "In a CC sweep all three loops are convex and monotone; they have at most m + n edges "
        "(trajectory), m (inner) and m + 2n (outer).",
        Status.REPRODUCED,
        ("exactsweep.evidence.swept.Swept.trajectory", "exactsweep.evidence.swept.Swept.outer"),
        _check_corollary_3_3,
        "The bounds are attained.",
    ),
    Claim(
        "Corollary 3.4",
        "3",
        "In a CC sweep all of it takes time and space O(m + n), which is optimal.",
        Status.REPRODUCED,
        (
            "exactsweep.procedures.cc.trajectory_cc",
            "exactsweep.procedures.cc.sweep_inner_cc",
            "exactsweep.procedures.cc.sweep_outer_cc",
        ),
        _check_corollary_3_4,
    ),
    Claim(
        "Trajectory_CC",
        "3",
        "Merge the edges of reversed G_t and of D_b by slope.",
        Status.REPRODUCED,
        ("exactsweep.procedures.cc.trajectory_cc",),
        lambda run: _try(run, trajectory_cc_is_right),
    ),
    Claim(
        "SweepI_CC",
        "3",
        "Return D_b.",
        Status.REPRODUCED,
        ("exactsweep.procedures.cc.sweep_inner_cc",),
        lambda run: _try(run, inner_cc_is_right),
    ),
    Claim(
        "SweepO_CC",
        "3",
        "From the left end of D plus the left end of G minus its right end, merge the edges of all "
        "three chains by slope.",
        Status.REPRODUCED,
        ("exactsweep.procedures.cc.sweep_outer_cc",),
        lambda run: _try(run, outer_cc_is_right),
    ),
)
