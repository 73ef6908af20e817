"""Section 5.1: time of an MM sweep."""

from collections.abc import Callable, Iterator, Sequence
from functools import reduce
from itertools import chain, pairwise, product
from math import log2

from exactsweep.corpus.generator.shapes import Ring
from exactsweep.numbers.number import Vertex
from exactsweep.paper import counting, kernel
from exactsweep.paper.checks.appendix import watch_slots
from exactsweep.paper.checks.section4 import lowest
from exactsweep.paper.checks.section5_sizes import EXCEEDING, exceeds_its_parts, find_beyond_mn2
from exactsweep.paper.claim import Counterexample, Effort, Evidence, Observation, Table
from exactsweep.paper.costs import count_all
from exactsweep.paper.functions import clip_to, describe_difference, look_up_bottom
from exactsweep.paper.growth import M_PLUS_N, Growth, double
from exactsweep.paper.pairs import Chains, SweepPair
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.graph import Graph, lower_envelope_mm, merge

Inner = Callable[[Chains, Graph], list[Vertex]]


def count_one_merge(effort: Effort) -> Iterator[Observation]:
    def run(*chains: Sequence[Vertex]) -> Graph:
        return lower_envelope_mm(list(map(kernel.to_graph, chains)))

    def zigzags(m: int, n: int) -> tuple[Ring, Ring]:
        return [(2 * k, k % 2 * 10) for k in range(m)], [(2 * k, 6 - k % 2) for k in range(n)]

    def count(chains: SweepPair) -> int:
        return counting.count_operations(run, *map(counting.make_counted, chains))

    pairs = list(product(_tiny_chains(), repeat=2))
    tried = f"All {len(pairs)} pairs of chains of one or two edges on the 3 by 3 grid, and counts."
    yield Evidence(tried, searched=len(pairs))
    # Only the ends of the chains keep the counts from being proportional.
    yield counting.grow(
        "operations of one merge", zigzags, M_PLUS_N, double(64, 4), count, limit=1.005
    )
    yield from (lowest("chain", chains, list(run(*chains))) for chains in pairs)


def _tiny_chains() -> list[list[Vertex]]:
    straight: list[list[Vertex]] = [[(0, a), (2, b)] for a, b in product(range(3), repeat=2)]
    bends: list[list[Vertex]] = [
        [(0, a), (1, b), (2, c)] for a, b, c in product(range(3), repeat=3) if a + c != 2 * b
    ]
    return straight + bends


def merge_by_halves(pair: SweepPair) -> tuple[int, float]:
    """Count the operations of LowerEnvelope_MM; the bound is N log k for k chains, N edges."""
    graphs = kernel.list_sub_trajectories(counting.count_chains(pair))
    size = sum(len(graph.pieces) for graph in graphs)
    with counting.watch_operations() as tally:
        merged = lower_envelope_mm(graphs)
    return tally.total + sum(1 for _ in merged), size * max(1.0, log2(len(graphs)))


def lower_envelope_mm_is_correct(pair: SweepPair) -> Iterator[str]:
    """LowerEnvelope_MM returns the lower envelope of its chains."""
    chains = kernel.list_sub_trajectories(pair.chains)
    found = lower_envelope_mm(chains)
    yield lowest("sub-trajectory", [list(chain) for chain in chains], list(found))
    yield describe_difference("the lower envelope", found, look_up_bottom(pair, "trajectory"))


def find_large_trajectory(effort: Effort) -> Iterator[Observation]:
    how = "the first of the non-convex quadrilaterals on the 4 by 4 grid"
    yield from (Counterexample(text, how, *EXCEEDING) for text in exceeds_its_parts(EXCEEDING))


def find_large_loop(effort: Effort) -> Iterator[Observation]:
    yield from (part for part in find_beyond_mn2(effort) if not isinstance(part, Table))


def step_2(pair: SweepPair) -> int:
    """Count the operations of all calls of Trajectory_CM."""
    return counting.operations(
        lambda c: chain.from_iterable(kernel.list_sub_trajectories(c)), pair.chains
    )


def merge_parts_in_turn(pair: SweepPair) -> int:
    """Count the operations and copied slots of merging one sub-trajectory at a time."""
    graphs = _sub_trajectories(counting.count_chains(pair))
    with counting.watch_operations() as tally:
        merged = reduce(lambda partial, graph: merge(watch_slots(partial), graph), graphs)
    return tally.total + len(merged.pieces)


def merge_parts_by_halves(pair: SweepPair) -> int:
    graphs = _sub_trajectories(counting.count_chains(pair))
    with counting.watch_operations() as tally:
        merged = lower_envelope_mm(graphs)
    return tally.total + len(merged.pieces)


def count_glance(effort: Effort) -> Iterator[Observation]:
    growth = list(count_all("Envelopes at first glance", effort))
    yield Evidence("Operations are counted.")
    yield from growth
    if growth[0].exponent() < 1.7:
        yield "merging in turn takes less than order m²"


def _sub_trajectories(chains: Chains) -> list[Graph]:
    parts = kernel.find_convex_parts(chains.directrix)
    return [kernel.to_graph(kernel.trajectory_cc(chains.top, part)) for part in parts]


def inner_again(chains: Chains, trajectory: Graph) -> list[Vertex]:
    """Compute the inner boundary as printed, by Trajectory_MM along the inside of all of T."""
    bottom, path = inverse(chains.top), list(trajectory)
    found = kernel.slide_inside(bottom, path, kernel.merge_sub_trajectories)
    return clip_to(found, chains.directrix)


def inner_by_gaps(chains: Chains, trajectory: Graph) -> list[Vertex]:
    return kernel.sweep_inner_mm(chains.top, chains.directrix, trajectory)


def sweep_again(pair: SweepPair, inner: Inner = inner_again) -> int:
    """Count the operations after the trajectory if the whole of T is swept from inside."""
    chains = counting.count_chains(pair)
    return counting.count_operations(inner, chains, kernel.trajectory_mm(*chains[::2]))


def sweep_gaps(pair: SweepPair) -> int:
    return sweep_again(pair, inner_by_gaps)


def gaps_give_the_same(pair: SweepPair) -> Iterator[str]:
    """Sweeping only the undercuts yields the inner boundary of Sweep_MM."""
    chains = pair.chains
    trajectory = kernel.trajectory_mm(*chains[::2])
    found, expected = inner_by_gaps(chains, trajectory), inner_again(chains, trajectory)
    yield describe_difference("the inner boundary", found, expected)


def _outgrows(slow: Growth, fast: Growth) -> bool:
    factors = [p.count / q.count for p, q in zip(slow.points, fast.points, strict=False)]
    return all(after > 1.4 * before for before, after in pairwise(factors))


def count_gaps(effort: Effort) -> Iterator[Observation]:
    gaps, again, written = growth = list(count_all("A faster inner loop", effort))
    last, other = written.points[-1], gaps.points[len(again.points) - 1]
    yield Evidence(
        "Operations counted with most of D_b in contact: "
        f"{other.count:,} instead of {again.points[-1].count:,} at m = n = {other.m}. "
        "A family of needles, with vertices counted."
    )
    yield from growth
    yield "" if _outgrows(again, gaps) else "calling Trajectory_MM again is about as fast"
    yield Counterexample(
        f"the output has {last.count:,} vertices for m = {last.m} and n = {last.n}; mn is "
        f"{last.m * last.n:,}",
        "a family built for this: see Lemma 5.5",
    )
