"""Slips of the pen, each with a case in which the printed and the meant statement differ."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from exactsweep.corpus.generator.growing import cm_undercut, wide
from exactsweep.numbers.point import Vertex
from exactsweep.paper import literal
from exactsweep.paper.checks.appendix import meetings
from exactsweep.paper.claim import Counterexample, Effort, Evidence
from exactsweep.paper.counting import make_counted, watch_operations
from exactsweep.paper.functions import keep_corners, look_up, take_bottom, write_chain
from exactsweep.paper.growth import Growth, double, grow
from exactsweep.paper.literal import split_at_reflex
from exactsweep.paper.pairs import Chains, SweepPair
from exactsweep.paper.tiny import is_any, is_convex, search_grid
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.cm import sweep_inner_cm, trajectory_cm


def find_whole_trajectory(effort: Effort) -> Evidence:
    """Look for a partial trajectory that shares more than a segment with all of T(G_t, D_b)."""

    def fails(pair: SweepPair) -> str:
        top, _, directrix = pair.chains
        parts = split_at_reflex(directrix)
        partial = literal.trajectory_cm(
            top, [*parts[0], *(p for part in parts[1:-1] for p in part[1:])]
        )
        whole = take_bottom(look_up(pair).trajectory)
        failure, _ = meetings(partial, whole)
        return failure and f"T_(i-1) and T(G_t, D_b): {failure}"

    return search_grid(2, 7, is_convex, is_any, fails)


def find_open_output(effort: Effort) -> Evidence:
    """Look for a pair of which Trajectory_CC does not return T(G, D)."""

    def fails(pair: SweepPair) -> str:
        found = keep_corners(literal.trajectory_cc(pair.chains.top, pair.chains.directrix))
        whole = look_up(pair).trajectory
        if len(found) - 1 == len(whole):
            return ""
        return f"a chain of {len(found) - 1} edges comes out, and T(G, D) has {len(whole)}"

    return search_grid(2, 6, is_convex, is_convex, fails)


def count_step_3(effort: Effort) -> Evidence:
    """Count the operations of SweepI_CM beyond the trajectory; find a pair that needs step 3."""

    def needed(pair: SweepPair) -> str:
        loops = look_up(pair)
        if take_bottom(loops.inner) == take_bottom(pair.directrix):
            return ""
        return "after step 2 the list L is still D_b, and not the inner boundary"

    found = search_grid(2, 8, is_convex, is_any, needed)
    growth = grow_beyond_trajectory(effort)
    return replace(found, failure=growth.failure, growth=(growth,))


def grow_beyond_trajectory(effort: Effort) -> Growth:
    """Operations of step 3 over close teeth."""

    def count(m: int, n: int) -> tuple[int, float]:
        chains = Chains(*(make_counted(chain) for chain in SweepPair(*cm_undercut(m, n)).chains))  # type: ignore[arg-type]
        trajectory = trajectory_cm(chains.top, chains.directrix)
        with watch_operations() as tally:
            out = len(sweep_inner_cm(chains.top, chains.directrix, trajectory))
        return tally.total + out, m * n

    sizes = double(16, 2 if effort.quick else 4)
    return grow("operations of step 3", "cm_undercut", "mn", sizes, count)


def find_boundary_off_trajectory(effort: Effort) -> Evidence:
    """Look for a pair whose partial outer boundary is no trajectory."""

    def fails(pair: SweepPair) -> str:
        loops = look_up(pair)
        if take_bottom(loops.outer) == take_bottom(loops.trajectory):
            return ""
        return "S_1, an outer boundary, is not where a point of G goes"

    return search_grid(2, 6, is_convex, is_convex, fails)


def find_loops_apart(effort: Effort) -> Evidence:
    """Look for two pairs with one G_t and one D_b, and two outer loops."""
    first: dict[tuple[tuple[Vertex, ...], ...], SweepPair] = {}

    def fails(pair: SweepPair) -> str:
        top, _, directrix = pair.chains
        known = first.setdefault((tuple(top), tuple(directrix)), pair)
        if look_up(known).outer == look_up(pair).outer:
            return ""
        return f"G = {known.generatrix} and D = {known.directrix} have them, too, and other loops"

    return search_grid(2, 7, is_any, is_any, fails)


def find_generatrix_not_inverted(effort: Effort) -> Evidence:
    """Look for a pair whose T(G_b, T(G_t, D_b)) is not its outer boundary, wherever it lies."""

    def fails(pair: SweepPair) -> str:
        top, bottom, directrix = pair.chains
        path = literal.trajectory_mm(top, directrix)
        found = keep_corners(literal.trajectory_mm(bottom[::-1], path))
        expected = take_bottom(look_up(pair).outer)
        if _shape(found) == _shape(expected):
            return ""
        return f"T(G_b, T(G_t, D_b)) is {write_chain(found)}, and not the outer boundary, moved"

    return search_grid(2, 7, is_any, is_any, fails)


def _shape(chain: Sequence[Vertex]) -> list[Vertex]:
    (x, y), *_ = chain
    return [(p - x, q - y) for p, q in chain]


def find_part_without_number(effort: Effort) -> Evidence:
    """Look for a CM pair with a D_2 and no G_2."""

    def fails(pair: SweepPair) -> str:
        top, _, directrix = pair.chains
        parts, others = len(split_at_reflex(directrix)), len(split_at_reflex(inverse(top)))
        return f"D_b has {parts} convex parts, G_t {others}: no G_2" if parts > others else ""

    return search_grid(2, 7, is_convex, is_any, fails)


def find_other_size(effort: Effort) -> Evidence:
    """Look for a pair whose trajectory and outer loop together have not mn vertices."""

    def fails(pair: SweepPair) -> str:
        (n, m), loops = map(len, pair), look_up(pair)
        size = len(loops.trajectory) + len(loops.outer)
        return f"{size} vertices are written for m = {m} and n = {n}" if size != m * n else ""

    return search_grid(2, 6, is_convex, is_any, fails)


def count_calls(effort: Effort) -> Evidence:
    """Count the operations of all calls of Trajectory_CC beside the edges of the trajectory."""

    def count(m: int, n: int) -> tuple[int, float]:
        chains = Chains(*(make_counted(chain) for chain in SweepPair(*wide(m, n)).chains))  # type: ignore[arg-type]
        edges = len(keep_corners(trajectory_cm(*chains[::2]))) - 1
        with watch_operations() as tally:
            for part in split_at_reflex(chains.directrix):
                literal.trajectory_cc(chains.top, part)
        return tally.total, edges

    sizes = [(size, 16) for size, _ in double(16, 2 if effort.quick else 4)]
    growth = grow("operations of all calls", "wide", "edges of T", sizes, count)
    last = growth.points[-1]
    against = Counterexample(
        f"for m = {last.m} and n = {last.n} the calls take {last.count:,} operations, and the "
        f"trajectory has {last.bound:.0f} edges: its size does not bound the time",
        "a G wider than D, at the largest size that was counted",
    )
    is_beyond = growth.exponent() > growth.claimed() + 0.2
    failure = "" if is_beyond else "the edges keep up with the operations"
    return Evidence("Counts to the letter.", failure, against, growth=(growth,))
