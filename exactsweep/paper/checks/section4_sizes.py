"""Section 4: size and time of a CM sweep."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from exactsweep.paper.checks.section4 import sub_trajectories_suffice
from exactsweep.paper.claim import Counterexample, Effort, Observation, Table
from exactsweep.paper.costs import RUNS
from exactsweep.paper.functions import keep_corners, list_sub_chains, look_up_bottom
from exactsweep.paper.kernel import find_convex_parts
from exactsweep.paper.pairs import SweepPair


def sizes_are_bounded(pair: SweepPair) -> Iterator[str]:
    """With k parts, at most m_b + k n_t, m_b + k (n_t + n_b) and m_b + (k - 1) n_t edges."""
    chains, parts = pair.chains, find_convex_parts(pair.chains.directrix)
    n_t, n_b, m_b = (len(keep_corners(chain)) - 1 for chain in chains)
    for loop, procedure, most in (
        ("trajectory", "Trajectory_CM", m_b + len(parts) * n_t),
        ("outer", "SweepO_CM", m_b + len(parts) * (n_t + n_b)),
        ("inner", "SweepI_CM", m_b + (len(parts) - 1) * n_t),
    ):
        size, expected = len(list(RUNS[procedure](chains))), len(look_up_bottom(pair, loop))
        if size != expected or size - 1 > most:
            yield f"{procedure}: {size - 1} edges, {expected - 1} by the definition, bound {most}"


def find_large_parts(effort: Effort) -> Iterator[Observation]:
    """Count the edges of outer boundaries when G_t is a single edge."""
    rows = []
    for n_b in (4, 8, 16):
        pair = under_a_lid(n_b)
        edges, bound = len(look_up_bottom(pair, "outer")) - 1, len(pair.chains.directrix) - 1
        rows.append([str(n_b), str(bound), str(edges)])
        yield from parts_are_bounded(pair)
    growing = [int(row[2]) for row in rows]
    if all(later > 1.5 * before for before, later in pairwise(growing)):
        yield Counterexample(
            f"the outer boundary has {growing[0]} edges, although m_b n_t = {bound}, and grows "
            "with n_b",
            "built by hand: deep teeth, and a G with one top edge",
            *under_a_lid(4),
        )
    yield Table("G_t with one edge, D_b with four teeth", ("n_b", "m_b n_t", "edges"), rows)


def parts_are_bounded(pair: SweepPair) -> Iterator[str]:
    """With k parts, they have at most m_b + k n_t and m_b + k (n_t + n_b) edges in total."""
    n_t, n_b, m_b = (len(chain) - 1 for chain in pair.chains)
    paths, outers = list_sub_chains(pair)
    k = len(paths)
    inner, outer = (sum(len(keep_corners(c)) - 1 for c in found) for found in (paths, outers))
    if inner > m_b + k * n_t or outer > m_b + k * (n_t + n_b):
        yield f"{inner} and {outer} edges in all sub-trajectories and sub-outer chains"
    yield from sub_trajectories_suffice(pair)


def under_a_lid(n_b: int) -> SweepPair:
    """Build a convex G with one top edge and n_b bottom edges, and a D with four deep teeth."""
    generatrix = [(2 * k, k * (k - n_b)) for k in range(n_b + 1)]
    width, depth = 2 * n_b + 2, n_b * n_b
    bottom = [(width * k, -depth if k % 2 else 0) for k in range(9)]
    return SweepPair(generatrix, [*bottom, (4 * width, depth)])
