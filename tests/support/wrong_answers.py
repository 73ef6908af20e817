"""Sabotages of the paper's procedures that give wrong answers."""

from itertools import pairwise
from typing import Any

from sabotage import Procedure, sabotage

from exactsweep.procedures import (
    cc,
    chain,
    cm,
    convex_part,
    lower_envelope,
    mm,
    part_pairs,
)
from exactsweep.procedures.envelope import Envelope


@sabotage("Trajectory_CC: edges laid end to end, not merged", cc.trajectory_cc)
def lay_end_to_end(right: Procedure) -> Procedure:
    def trajectory_cc(generatrix: Any, directrix: Any) -> Any:
        laid = list(directrix)
        path = chain.inverse(generatrix)
        (x, y), (dx, dy) = laid[-1], path[0]
        return [(a + dx, b + dy) for a, b in laid] + [(x + a, y + b) for a, b in path[1:]]

    return trajectory_cc


@sabotage("SweepI_CC: D_b cut short by a straight edge", cc.sweep_inner_cc)
def straighten(right: Procedure) -> Procedure:
    return lambda generatrix, directrix: [directrix[0], directrix[-1]]


@sabotage("SweepO_CC: the edges of G_b forgotten", cc.sweep_outer_cc)
def forget_bottom(right: Procedure) -> Procedure:
    return lambda top, bottom, directrix: cc.trajectory_cc(top, directrix)


@sabotage("Trajectory_CM, step 2: only the first convex part of D_b", convex_part.split_parts)
def take_first_part(right: Procedure) -> Procedure:
    return lambda directrix, unit: right(directrix, unit)[:1]


@sabotage("SweepI_CM: undercuts left open", cm.sweep_inner_cm)
def leave_undercuts_open(right: Procedure) -> Procedure:
    return lambda generatrix, directrix, trajectory=None: chain.take_corners(directrix)


@sabotage("SweepO_CM: the edges of G_b forgotten", cm.sweep_outer_cm)
def forget_bottom_cm(right: Procedure) -> Procedure:
    return lambda top, bottom, directrix: cm.trajectory_cm(top, directrix)


@sabotage("Trajectory_MM, steps 2 and 3: only the first convex part of G_t", part_pairs.sweep_pairs)
def take_first_chain(right: Procedure) -> Procedure:
    return lambda chains, *more, **options: right(chains[:1], *more, **options)


@sabotage("Sweep_MM, outer loop: G mirrored in an axis instead of inverted", mm.outer_mm)
def mirror_instead(right: Procedure) -> Procedure:
    def outer_mm(bottom: Any, trajectory: Any) -> Any:
        mirrored = [(-x, y) for x, y in bottom]
        return mm.trajectory_mm(mirrored[::-1], trajectory)

    return outer_mm


@sabotage("Sweep_MM, inner loop: D_b returned", mm.inner_mm)
def return_directrix(right: Procedure) -> Procedure:
    return lambda top, trajectory, directrix: chain.take_corners(directrix)


@sabotage(
    "LowerEnvelope_CM: the new piece always taken from its start", lower_envelope.lower_envelope_cm
)
def always_take_over(right: Procedure) -> Procedure:
    def lower_envelope_cm(partial: Any, piece: Any) -> Any:
        k = partial.edge_before(piece.breaks[0]) if len(partial.pieces) > 1 else 0
        cut = Envelope(
            [*partial.breaks[: k + 1], piece.breaks[0]],
            partial.pieces[: k + 1],
        )
        cut.pieces += piece.pieces
        cut.breaks += piece.breaks[1:]
        return cut

    return lower_envelope_cm


@sabotage("SweepI_CM: every other corner of a bottom chain left out", cm.sweep_inner_cm)
def draw_straight(right: Procedure) -> Procedure:
    def sweep_inner_cm(generatrix: Any, directrix: Any, trajectory: Any = None) -> Any:
        inner = right(generatrix, directrix, trajectory)
        known = set(directrix)
        return chain.take_corners([p for k, p in enumerate(inner) if p in known or k % 2])

    return sweep_inner_cm


@sabotage("step 1: chains not split at reflex vertices", chain.split_by_slope)
def never_split(right: Procedure) -> Procedure:
    def split_by_slope(points: Any, unit: Any) -> Any:
        columns = zip(*right(points, unit), strict=True)
        return [tuple([item for part in column for item in part] for column in columns)]

    return split_by_slope


@sabotage("LowerEnvelope_MM: the last sub-trajectory left out", lower_envelope.lower_envelope_mm)
def leave_out_last(right: Procedure) -> Procedure:
    return lambda envelopes: right(list(envelopes)[:-1] or envelopes)


@sabotage("inverse: mirrored in the Y axis, not in a point", chain.inverse)
def mirror_in_an_axis(right: Procedure) -> Procedure:
    return lambda points: [(-x, y) for x, y in points]


@sabotage("complement: walked the same way", chain.complement)
def leave_as_it_is(right: Procedure) -> Procedure:
    return lambda points: list(points)


@sabotage("Sweep_MM, inner loop: the last gap that G leaves is forgotten", mm.find_gaps)
def forget_last_gap(right: Procedure) -> Procedure:
    return lambda *arguments: list(right(*arguments))[:-1]


@sabotage("SweepI_CC: a vertex of any D_b with more than six is lost", cc.sweep_inner_cc)
def lose_vertex(right: Procedure) -> Procedure:
    def sweep_inner_cc(generatrix: Any, directrix: Any) -> Any:
        found = right(generatrix, directrix)
        return [*found[:3], *found[4:]] if len(found) > 6 else found

    return sweep_inner_cc


@sabotage("Trajectory_MM: a corner of large trajectories is lost", mm.trajectory_mm)
def lose_corner(right: Procedure) -> Procedure:
    def trajectory_mm(generatrix: Any, directrix: Any) -> Any:
        found = right(generatrix, directrix)
        corners = list(found)
        if len(generatrix) <= 12 or len(corners) <= 40:
            return found
        return Envelope.of([*corners[:20], *corners[21:]])

    return trajectory_mm


@sabotage("Trajectory_MM: a ceiling drops a pair that it should sweep", part_pairs.Ceiling)
def drop_pair(right: Procedure) -> Procedure:
    class Leaky(right):  # type: ignore[misc, valid-type]
        def find_reaching(self, *arguments: Any) -> Any:
            return super().find_reaching(*arguments)[1:]

    return Leaky


@sabotage("Trajectory_CC: parallel edges are left as two", cc.merge_by_slope)
def leave_in_two(right: Procedure) -> Procedure:
    def merge_by_slope(first: Any, second: Any) -> Any:
        found = list(right(first, second))
        steps = {(q[0] - p[0], q[1] - p[1]) for c in (first, second) for p, q in pairwise(c)}
        for k, (p, q) in enumerate(pairwise(found)):
            halves = [(a, b) for a, b in steps if (p[0] + a, p[1] + b) != q and a < q[0] - p[0]]
            for a, b in halves:
                if a * (q[1] - p[1]) == b * (q[0] - p[0]):
                    return [*found[: k + 1], (p[0] + a, p[1] + b), *found[k + 1 :]]
        return found

    return merge_by_slope


@sabotage("split: an edge beyond the right end", chain.split)
def split_late(right: Procedure) -> Procedure:
    def split(loop: Any) -> Any:
        bottom, top = right(loop)
        return [*bottom, *top[1:2]], top[1:]

    return split
