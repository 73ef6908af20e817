"""Sabotages of the paper's procedures that cause wrong answers."""

from itertools import pairwise
from math import inf
from typing import Any

from sabotage import Procedure, sabotage

from exactsweep.procedures import cc, ceiling, chain, cm, graph, mm
from exactsweep.procedures.chain import Chain
from exactsweep.procedures.graph import Graph


@sabotage("Trajectory_CC: edges laid end to end, not merged", cc.trajectory_cc)
def lay_end_to_end(right: Procedure) -> Procedure:
    def trajectory_cc(generatrix: Any, directrix: Any) -> Any:
        laid, path = list(directrix), list(generatrix)
        (x, y), (dx, dy) = laid[-1], path[0]
        moved = [(a + dx, b + dy) for a, b in laid]
        return Chain.of(moved + [(x + a, y + b) for a, b in path[1:]])

    return trajectory_cc


@sabotage("SweepI_CC: D_b cut short by a straight edge", cc.sweep_inner_cc)
def straighten(right: Procedure) -> Procedure:
    return lambda generatrix, directrix: Chain.of([*directrix][:: len([*directrix]) - 1])


@sabotage("SweepO_CC: the edges of G_b forgotten", cc.sweep_outer_cc)
def forget_bottom(right: Procedure) -> Procedure:
    return lambda generatrix, bottom, directrix: cc.trajectory_cc(generatrix, directrix)


@sabotage("Trajectory_CM, step 2: only the first convex part of D_b", chain.partition)
def take_first_part(right: Procedure) -> Procedure:
    def partition(*chains: Any) -> Any:
        generatrix_parts, directrix_parts = right(*chains)
        return generatrix_parts, directrix_parts[:1]

    return partition


@sabotage("SweepI_CM: undercuts left open", cm.sweep_inner_cm)
def leave_undercuts_open(right: Procedure) -> Procedure:
    return lambda generatrix, directrix, trajectory=None: directrix


@sabotage("SweepO_CM: the edges of G_b forgotten", cm.sweep_outer_cm)
def forget_bottom_cm(right: Procedure) -> Procedure:
    return lambda generatrix, bottom, directrix: cm.trajectory_cm(generatrix, directrix)


@sabotage(
    "Trajectory_MM, steps 2 and 3: only the first convex part of G_t", ceiling.subtrajectories
)
def take_first_chain(right: Procedure) -> Procedure:
    return lambda parts, *more: right(parts[:1], *more)


@sabotage("Sweep_MM, outer loop: G mirrored in an axis instead of inverted", mm.sweep_outer_mm)
def mirror_instead(right: Procedure) -> Procedure:
    def sweep_outer_mm(bottom: Any, path: Any) -> Any:
        return mm.trajectory_mm(Chain.of([(x, -y) for x, y in bottom]), path)

    return sweep_outer_mm


@sabotage("Sweep_MM, inner loop: D_b returned", mm.sweep_inner_mm)
def return_directrix(right: Procedure) -> Procedure:
    return lambda generatrix, directrix, *more: directrix


@sabotage("LowerEnvelope_CM: the new piece always taken from its start", graph.lower_envelope_cm)
def always_take_over(right: Procedure) -> Procedure:
    def lower_envelope_cm(partial: Any, piece: Any) -> Any:
        k = max(0, graph.find_piece(partial, piece.breaks[0]))
        k -= k == len(partial.pieces)
        breaks = [*partial.breaks[: k + 1], *piece.breaks]
        return Graph(breaks, [*partial.pieces[: k + 1], *piece.pieces])

    return lower_envelope_cm


@sabotage("SweepI_CM: every other corner of a bottom chain left out", cm.sweep_inner_cm)
def draw_straight(right: Procedure) -> Procedure:
    def sweep_inner_cm(generatrix: Any, directrix: Any, trajectory: Any = None) -> Any:
        inner = right(generatrix, directrix, trajectory)
        known = set(directrix)
        return Chain.of([p for k, p in enumerate(inner) if p in known or k % 2])

    return sweep_inner_cm


@sabotage("step 1: chains not split at reflex vertices", chain.find_convex_parts)
def never_split(right: Procedure) -> Procedure:
    def find_convex_parts(*arguments: Any) -> Any:
        first, *others = right(*arguments)
        edges = [edge for part in (first, *others) for edge in part.edges]
        return [first._replace(edges=edges, least_slope=(-inf,), greatest_slope=(inf,))]

    return find_convex_parts


@sabotage("LowerEnvelope_MM: the last sub-trajectory left out", graph.lower_envelope_mm)
def leave_out_last(right: Procedure) -> Procedure:
    return lambda graphs: right(list(graphs)[:-1] or graphs)


@sabotage("inverse: mirrored in the Y axis, not in a point", chain.inverse)
def mirror_in_an_axis(right: Procedure) -> Procedure:
    return lambda points: [(-x, y) for x, y in points]


@sabotage("Sweep_MM, inner loop: the last gap that G leaves is forgotten", mm.find_untouched)
def forget_last_gap(right: Procedure) -> Procedure:
    return lambda *arguments: list(right(*arguments))[:-1]


@sabotage("SweepI_CC: a vertex of any D_b with more than six is lost", cc.sweep_inner_cc)
def lose_vertex(right: Procedure) -> Procedure:
    def sweep_inner_cc(generatrix: Any, directrix: Any) -> Any:
        found = right(generatrix, directrix)
        points = [*found]
        return Chain.of([*points[:3], *points[4:]]) if len(points) > 6 else found

    return sweep_inner_cc


@sabotage("Trajectory_MM: a corner of large trajectories is lost", mm.trajectory_mm)
def lose_corner(right: Procedure) -> Procedure:
    def trajectory_mm(generatrix: Any, directrix: Any, *ranges: Any) -> Any:
        found = right(generatrix, directrix, *ranges)
        if ranges or len(generatrix.vertices) <= 12 or len(found.pieces) <= 40:
            return found
        return Graph(
            [*found.breaks[:20], *found.breaks[21:]], [*found.pieces[:20], *found.pieces[21:]]
        )

    return trajectory_mm


@sabotage("Trajectory_MM: a ceiling drops a pair that it should sweep", ceiling.subtrajectories)
def drop_pair(right: Procedure) -> Procedure:
    def subtrajectories(*arguments: Any) -> Any:
        first, *others = right(*arguments)
        return others or [first]

    return subtrajectories


@sabotage("Trajectory_CC: parallel edges are left as two", cc.trajectory_cc)
def leave_in_two(right: Procedure) -> Procedure:
    def trajectory_cc(*chains: Any) -> Any:
        found = list(right(*chains))
        steps = {(q[0] - p[0], q[1] - p[1]) for c in chains for p, q in pairwise(c)}
        for k, (p, q) in enumerate(pairwise(found)):
            halves = [(a, b) for a, b in steps if (p[0] + a, p[1] + b) != q and a < q[0] - p[0]]
            for a, b in halves:
                if a * (q[1] - p[1]) == b * (q[0] - p[0]):
                    return Chain.of([*found[: k + 1], (p[0] + a, p[1] + b), *found[k + 1 :]])
        return Chain.of(found)

    return trajectory_cc


@sabotage("split: an edge beyond the right end", chain.split)
def split_late(right: Procedure) -> Procedure:
    def split(loop: Any) -> Any:
        bottom, top = right(loop)
        return [*bottom, *top[1:2]], top[1:]

    return split


@sabotage("complement: walked the same way", chain.complement)
def leave_as_it_is(right: Procedure) -> Procedure:
    return lambda points: list(points)
