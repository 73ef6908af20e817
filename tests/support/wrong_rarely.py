"""Sabotages of the paper's procedures that affect only large sizes or rare cases."""

from itertools import pairwise
from typing import Any

from sabotage import Procedure, sabotage

from exactsweep.procedures import cc, cm, mm
from exactsweep.procedures.chain import Chain
from exactsweep.procedures.graph import Graph


@sabotage("Trajectory_CC: of two equal edges one is lost", cc.trajectory_cc)
def lose_equal_edge(right: Procedure) -> Procedure:
    def trajectory_cc(one: Any, second: Any) -> Any:
        first = [*one]
        steps = {(q[0] - p[0], q[1] - p[1]) for p, q in pairwise(second)}
        for k, (p, q) in enumerate(pairwise(first)):
            x, y = q[0] - p[0], q[1] - p[1]
            if (x, y) in steps and len(first) > 2:
                moved = [(a - x, b - y) for a, b in first[k + 2 :]]
                return right(Chain.of([*first[: k + 1], *moved]), second)
        return right(one, second)

    return trajectory_cc


def lose_middle(points: Any, fewest: int = 0) -> Any:
    """Drop the middle point of a long list."""
    corners = list(points)
    if len(corners) < fewest:
        return points
    if isinstance(points, Graph):
        k = len(points.pieces) // 2
        return Graph(
            [*points.breaks[:k], *points.breaks[k + 1 :]],
            [*points.pieces[:k], *points.pieces[k + 1 :]],
        )
    del corners[len(corners) // 2]
    return Chain.of(corners)


def lose_corner_of_large(right: Procedure) -> Procedure:
    """Lose a corner if the second argument has more than 40 vertices."""
    return lambda *arguments: lose_middle(
        right(*arguments), 0 if len(list(arguments[1])) > 40 else 10**9
    )


for fault, procedure in (
    ("Trajectory_CM: a corner is lost where D_b has more than 40 vertices", cm.trajectory_cm),
    ("SweepO_CM: a corner is lost where G_b has more than 40 vertices", cm.sweep_outer_cm),
):
    sabotage(fault, procedure)(lose_corner_of_large)


@sabotage("SweepI_CM: a corner of undercuts of more than eight edges is lost", cm.sweep_inner_cm)
def lose_corner_of_undercut(right: Procedure) -> Procedure:
    def sweep_inner_cm(generatrix: Any, directrix: Any, trajectory: Any = None) -> Any:
        found = right(generatrix, directrix, trajectory)
        known, points, run = set(directrix), [*found], 0
        for k, point in enumerate(points):
            run = 0 if point in known else run + 1
            if run > 8:
                return Chain.of([*points[:k], *points[k + 1 :]])
        return found

    return sweep_inner_cm


@sabotage("Sweep_MM, outer loop: the ninth corner of G_b is forgotten", mm.sweep_outer_mm)
def forget_ninth(right: Procedure) -> Procedure:
    def sweep_outer_mm(bottom: Any, path: Any) -> Any:
        points = [*bottom]
        kept = bottom if len(points) < 12 else Chain.of([*points[:8], *points[9:]])
        return right(kept, path)

    return sweep_outer_mm


@sabotage("Sweep_MM, inner loop: narrow gaps are taken for touched", mm.find_untouched)
def skip_narrow(right: Procedure) -> Procedure:
    def find_untouched(generatrix: Any, directrix: Any, trajectory: Any) -> Any:
        width = directrix.vertices[-1][0] - directrix.vertices[0][0]
        return [
            (before, (n, d), after, (k, e))
            for before, (n, d), after, (k, e) in right(generatrix, directrix, trajectory)
            if 100 * (k * d - n * e) > width * d * e
        ]

    return find_untouched


@sabotage("Sweep_MM, inner loop: gaps after the fifth are taken for touched", mm.find_untouched)
def stop_at_fifth(right: Procedure) -> Procedure:
    return lambda *arguments: right(*arguments)[:5]


@sabotage("Sweep_MM, inner loop: a corner is lost where there are 60 or more", mm.sweep_inner_mm)
def lose_inner_corner(right: Procedure) -> Procedure:
    return lambda *arguments: lose_middle(right(*arguments), 60)


@sabotage("Trajectory_MM: heights beyond 2^60 are rounded to doubles", mm.trajectory_mm)
def round_large(right: Procedure) -> Procedure:
    def trajectory_mm(generatrix: Any, directrix: Any, *ranges: Any) -> Any:
        found = right(generatrix, directrix, *ranges)
        if ranges or max(abs(c) for _, _, c, _, _ in found.pieces) < 2**60:
            return found
        pieces = [(dx, dy, int(float(c)), *ends) for dx, dy, c, *ends in found.pieces]
        return Graph(found.breaks, pieces)

    return trajectory_mm
