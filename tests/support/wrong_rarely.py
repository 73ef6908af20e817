"""Sabotages of the paper's procedures that show at large sizes or in rare places alone."""

from fractions import Fraction
from itertools import pairwise
from typing import Any

from sabotage import Procedure, sabotage

from exactsweep.procedures import cc, cm, mm
from exactsweep.procedures.envelope import Envelope


@sabotage("Trajectory_CC: of two equal edges one is lost", cc.merge_by_slope)
def lose_equal_edge(right: Procedure) -> Procedure:
    def merge_by_slope(first: Any, second: Any) -> Any:
        steps = {(q[0] - p[0], q[1] - p[1]) for p, q in pairwise(second)}
        for k, (p, q) in enumerate(pairwise(first)):
            x, y = q[0] - p[0], q[1] - p[1]
            if (x, y) in steps and len(first) > 2:
                return right(
                    [*first[: k + 1], *((a - x, b - y) for a, b in first[k + 2 :])], second
                )
        return right(first, second)

    return merge_by_slope


def lose_middle(points: Any, fewest: int = 0) -> Any:
    """The same without its middle point, if there are as many as that."""
    corners = list(points)
    if len(corners) < fewest:
        return points
    del corners[len(corners) // 2]
    return Envelope.of(corners) if isinstance(points, Envelope) else corners


def lose_corner_of_large(right: Procedure) -> Procedure:
    """A corner is lost where the second argument has more than 40 vertices."""
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
        known, run = set(directrix), 0
        for k, point in enumerate(found):
            run = 0 if point in known else run + 1
            if run > 8:
                return [*found[:k], *found[k + 1 :]]
        return found

    return sweep_inner_cm


@sabotage("Sweep_MM, outer loop: the ninth corner of G_b is forgotten", mm.outer_mm)
def forget_ninth(right: Procedure) -> Procedure:
    return lambda bottom, trajectory: right(
        bottom if len(bottom) < 12 else [*bottom[:8], *bottom[9:]], trajectory
    )


@sabotage("Sweep_MM, inner loop: narrow gaps are taken for touched", mm.find_gaps)
def skip_narrow(right: Procedure) -> Procedure:
    def find_gaps(trajectory: Any, parts: Any) -> Any:
        width = parts[-1][-1][0] - parts[0][0][0]
        return [
            ((n, d), (k, e))
            for (n, d), (k, e) in right(trajectory, parts)
            if 100 * (k * d - n * e) > width * d * e
        ]

    return find_gaps


@sabotage("Sweep_MM, inner loop: gaps after the fifth are taken for touched", mm.find_gaps)
def stop_at_fifth(right: Procedure) -> Procedure:
    return lambda *arguments: right(*arguments)[:5]


@sabotage("Sweep_MM, inner loop: a corner is lost where there are 60 or more", mm.inner_mm)
def lose_inner_corner(right: Procedure) -> Procedure:
    return lambda *arguments: lose_middle(right(*arguments), 60)


@sabotage("Trajectory_MM: heights beyond 2^60 are rounded to doubles", mm.trajectory_mm)
def round_large(right: Procedure) -> Procedure:
    def trajectory_mm(generatrix: Any, directrix: Any) -> Any:
        found = right(generatrix, directrix)
        corners = [(Fraction(x), Fraction(y)) for x, y in found]
        if max(abs(y) for _, y in corners) < 2**60:
            return found
        return Envelope.of([(x, Fraction(float(y))) for x, y in corners])

    return trajectory_mm
