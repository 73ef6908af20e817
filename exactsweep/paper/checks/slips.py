"""Misprints, each with a case that distinguishes the printed from the intended statement."""

from collections.abc import Iterator, Sequence

from exactsweep.numbers.number import Vertex
from exactsweep.paper import functions
from exactsweep.paper.checks.appendix import describe_meeting
from exactsweep.paper.claim import Counterexample, Effort, Evidence, Observation
from exactsweep.paper.costs import count_all
from exactsweep.paper.counting import count_chains, count_operations, watch_operations
from exactsweep.paper.kernel import (
    find_convex_parts,
    find_trajectory,
    sweep_inner_cm,
    trajectory_cc,
    trajectory_cm,
)
from exactsweep.paper.laws import search_grid
from exactsweep.paper.pairs import Chains, SweepPair
from exactsweep.procedures.chain import inverse


def partial_meets_whole(pair: SweepPair) -> Iterator[str]:
    """The partial trajectory meets all of T(G_t, D_b) in a point or a segment."""
    top, _, directrix = pair.chains
    parts = find_convex_parts(directrix)
    first = [*parts[0], *(p for part in parts[1:-1] for p in part[1:])]
    partial = list(trajectory_cm(top, first))
    whole = functions.look_up_bottom(pair, "trajectory")
    if failure := describe_meeting(partial, whole)[0]:
        yield f"T_(i-1) and T(G_t, D_b): {failure}"


def output_is_closed(pair: SweepPair) -> Iterator[str]:
    """Trajectory_CC returns T(G, D), a closed loop."""
    found = functions.keep_corners(trajectory_cc(pair.chains.top, pair.chains.directrix))
    whole = functions.look_up(pair).trajectory
    if len(found) - 1 != len(whole):
        yield f"it returns a chain of {len(found) - 1} edges; T(G, D) has {len(whole)}"


def inner_is_complete_before(pair: SweepPair) -> Iterator[str]:
    """Before step 3 of SweepI_CM the list L is the inner boundary."""
    if functions.look_up_bottom(pair, "inner") != functions.take_bottom(pair.directrix):
        yield "after step 2, the list L is still D_b, not the inner boundary"


def step_3(pair: SweepPair) -> int:
    """Count the operations of SweepI_CM in addition to the trajectory."""
    top, _, directrix = count_chains(pair)
    return count_operations(sweep_inner_cm, top, directrix, trajectory_cm(top, directrix))


def boundary_is_trajectory(pair: SweepPair) -> Iterator[str]:
    """The partial outer boundary is a trajectory."""
    if functions.look_up_bottom(pair, "outer") != functions.look_up_bottom(pair, "trajectory"):
        yield "S_1, an outer boundary, is not the path of a point of G"


def find_loops_apart(effort: Effort) -> Iterator[Observation]:
    first: dict[tuple[tuple[Vertex, ...], ...], SweepPair] = {}

    def fails(pair: SweepPair) -> Iterator[str]:
        top, _, directrix = pair.chains
        known = first.setdefault((tuple(top), tuple(directrix)), pair)
        if functions.look_up(known).outer != functions.look_up(pair).outer:
            yield f"G = {known[0]} and D = {known[1]} have the same G_t and D_b, but other loops"

    yield search_grid(2, 7, "any", "any", fails)


def generatrix_sweeps_again(pair: SweepPair) -> Iterator[str]:
    """T(G_b, T(G_t, D_b)) is a translate of the outer boundary."""
    bottom = pair.chains.bottom
    path = find_trajectory(pair.chains)
    found = functions.keep_corners(find_trajectory(Chains(bottom[::-1], [], path)))
    if _shape(found) != _shape(functions.look_up_bottom(pair, "outer")):
        chain = functions.write_chain(found)
        yield f"T(G_b, T(G_t, D_b)) is {chain}, not a translate of the outer boundary"


def _shape(chain: Sequence[Vertex]) -> list[Vertex]:
    (x, y), *_ = chain
    return [(p - x, q - y) for p, q in chain]


def parts_have_counterparts(pair: SweepPair) -> Iterator[str]:
    """There is a G_i for each D_i."""
    top, _, directrix = pair.chains
    parts, others = len(find_convex_parts(directrix)), len(find_convex_parts(inverse(top)))
    if parts > others:
        yield f"D_b has {parts} convex parts, but G_t has {others}: there is no G_2"


def output_has_mn_vertices(pair: SweepPair) -> Iterator[str]:
    """The trajectory and the outer loop together have mn vertices."""
    (n, m), loops = map(len, pair), functions.look_up(pair)
    if (size := len(loops.trajectory) + len(loops.outer)) != m * n:
        yield f"the output has {size} vertices for m = {m} and n = {n}"


def calls(pair: SweepPair) -> tuple[int, float]:
    """Count the operations of all calls of Trajectory_CC; the bound is the trajectory's size."""
    chains = count_chains(pair)
    edges = len(functions.keep_corners(trajectory_cm(*chains[::2]))) - 1
    with watch_operations() as tally:
        for part in find_convex_parts(chains.directrix):
            trajectory_cc(chains.top, part)
    return tally.total, edges


def count_calls(effort: Effort) -> Iterator[Observation]:
    (growth,) = count_all("Corollary 4.3 cited for a time", effort)
    last = growth.points[-1]
    yield Evidence("Operations are counted.", growth=(growth,))
    yield Counterexample(
        f"for m = {last.m} and n = {last.n}, the calls take {last.count:,} operations, but the "
        f"trajectory has {last.bound:.0f} edges: its size does not bound the time",
        "a G wider than D, at the largest size counted",
    )
    if growth.exponent() <= growth.claimed() + 0.2:
        yield "the number of edges grows as fast as the number of operations"
