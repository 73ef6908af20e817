"""Section 4: how large a CM sweep gets, and how long it takes."""

from __future__ import annotations

from itertools import pairwise

from exactsweep.corpus.generator.growing import cm_hard, cm_undercut
from exactsweep.paper.checks.section4 import sub_trajectories_suffice
from exactsweep.paper.claim import (
    Counterexample,
    Effort,
    Evidence,
    Table,
    weigh,
)
from exactsweep.paper.costs import RUNS
from exactsweep.paper.counting import PairFamily, count_by, grow
from exactsweep.paper.functions import (
    keep_corners,
    list_sub_chains,
    look_up,
    look_up_bottom,
    take_bottom,
)
from exactsweep.paper.growth import MN
from exactsweep.paper.pairs import SweepPair
from exactsweep.procedures.chain import find_convex_parts
from exactsweep.procedures.cm import sweep_inner_cm, sweep_outer_cm, trajectory_cm


def sizes_are_bounded(pair: SweepPair) -> str:
    """For k parts, m_b + k n_t, m_b + k (n_t + n_b) and m_b + (k - 1) n_t edges are enough."""
    top, bottom, directrix = pair.chains
    m_b, n_t, n_b = (len(keep_corners(chain)) - 1 for chain in (directrix, top, bottom))
    k, loops = len(find_convex_parts(directrix)), look_up(pair)
    found = [
        len(list(chain)) - 1
        for chain in (
            trajectory_cm(top, directrix),
            sweep_outer_cm(top, bottom, directrix),
            sweep_inner_cm(top, directrix),
        )
    ]
    expected = [len(take_bottom(loop)) - 1 for loop in (loops.trajectory, loops.outer, loops.inner)]
    most = [m_b + k * n_t, m_b + k * (n_t + n_b), m_b + (k - 1) * n_t]
    if found != expected:
        return f"sizes {found}, and {expected} by the definition"
    if any(size > bound for size, bound in zip(found, most, strict=True)):
        return f"sizes {found} of trajectory, outer and inner boundary, beyond {most}"
    return ""


def count_outer_vertices(effort: Effort) -> Evidence:
    """Count the vertices of the trajectory and of the outer boundary over deep teeth."""
    runs = ("trajectory", "Trajectory_CM"), ("outer boundary", "SweepO_CM")
    return _weigh_sizes(effort, cm_hard, *runs)


def count_inner_vertices(effort: Effort) -> Evidence:
    """Count the vertices of the inner boundary over close teeth."""
    return _weigh_sizes(effort, cm_undercut, ("inner boundary", "SweepI_CM"))


def _weigh_sizes(effort: Effort, family: PairFamily, *runs: tuple[str, str]) -> Evidence:
    sizes = effort.sizes(32, 3)
    grown = (
        grow(f"vertices of {name}", family, MN, sizes, count_by("vertices", RUNS[run]))
        for name, run in runs
    )
    return weigh("", *grown, attained=True)


def find_large_parts(effort: Effort) -> Evidence:
    """Count the edges of an outer boundary under a G_t of one edge."""
    rows = []
    for n_b in (4, 8, 16):
        pair = under_a_lid(n_b)
        edges, bound = len(look_up_bottom(pair, "outer")) - 1, len(pair.chains.directrix) - 1
        rows.append([str(n_b), str(bound), str(edges)])
        if failure := parts_are_bounded(pair):
            return Evidence("", failure)
    growing = [int(row[2]) for row in rows]
    against = None
    if all(later > 1.5 * before for before, later in pairwise(growing)):
        against = Counterexample(
            f"{growing[0]} edges in the outer boundary where m_b n_t = {bound}, and more with n_b",
            "by hand: deep teeth, and a G with one edge on top",
            *under_a_lid(4),
        )
    table = Table("G_t is one edge, D_b has four teeth", ("n_b", "m_b n_t", "edges"), rows)
    return Evidence("", "", against, tables=(table,))


def parts_are_bounded(pair: SweepPair) -> str:
    """With k convex parts in D_b, these have at most m_b + k n_t and m_b + k (n_t + n_b) edges."""
    n_t, n_b, m_b = (len(chain) - 1 for chain in pair.chains)
    paths, outers = list_sub_chains(pair)
    k = len(paths)
    inner, outer = (sum(len(keep_corners(c)) - 1 for c in found) for found in (paths, outers))
    if inner > m_b + k * n_t or outer > m_b + k * (n_t + n_b):
        return f"{inner} and {outer} edges in all sub-trajectories and sub-outer chains"
    return sub_trajectories_suffice(pair)


def under_a_lid(n_b: int) -> SweepPair:
    """A convex G with one edge on top and n_b below, and D with four teeth deeper than G turns."""
    generatrix = [(2 * k, k * (k - n_b)) for k in range(n_b + 1)]
    width, depth = 2 * n_b + 2, n_b * n_b
    bottom = [(width * k, -depth if k % 2 else 0) for k in range(9)]
    return SweepPair(generatrix, [*bottom, (4 * width, depth)])
