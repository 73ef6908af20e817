"""Slips of the pen, each with a case in which what is printed is not what is meant."""

from __future__ import annotations

from dataclasses import replace

from exactsweep.corpus.generator.growing import cm_undercut
from exactsweep.paper import literal
from exactsweep.paper.checks.appendix import meetings
from exactsweep.paper.claim import Effort, Evidence
from exactsweep.paper.counting import make_counted, watch_operations
from exactsweep.paper.functions import keep_corners, look_up, take_bottom
from exactsweep.paper.growth import Growth, double, grow
from exactsweep.paper.literal import split_at_reflex
from exactsweep.paper.pairs import Chains, SweepPair
from exactsweep.paper.tiny import is_any, is_convex, search_grid
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
