"""Sabotages that give right answers, and take too many operations, seconds or bytes."""

from collections.abc import Callable
from functools import reduce
from typing import Any

from sabotage import Procedure, sabotage

from exactsweep.paper import literal
from exactsweep.procedures import cc, chain, cm, lower_envelope, mm
from exactsweep.procedures.envelope import Envelope, precedes


def compare_all(first: Any, second: Any) -> None:
    """Compare every vertex of a chain with every one of another, which is counted."""
    for x, _ in first:
        for other, _ in second:
            x < other  # noqa: B015


@sabotage("Trajectory_CC: right, but in quadratic time", cc.merge_by_slope, "Corollary 3.4")
def compare_all_edges(right: Procedure) -> Procedure:
    def merge_by_slope(first: Any, second: Any) -> Any:
        compare_all(first, second)
        return right(first, second)

    return merge_by_slope


@sabotage(
    "LowerEnvelope_CM: right, but all of the partial trajectory is walked each time",
    lower_envelope.lower_envelope_cm,
    "LowerEnvelope_CM",
    "Corollary 4.5",
)
def walk_as_a_whole(right: Procedure) -> Procedure:
    def lower_envelope_cm(partial: Any, piece: Any) -> Any:
        for at in partial.breaks:
            precedes(at, piece.breaks[0])
        return right(partial, piece)

    return lower_envelope_cm


@sabotage(
    "LowerEnvelope_CM: right, but all of the partial trajectory is copied each time",
    lower_envelope.lower_envelope_cm,
    "LowerEnvelope_CM",
)
def copy_each_time(right: Procedure) -> Procedure:
    def lower_envelope_cm(partial: Any, piece: Any) -> Any:
        whole = Envelope(partial.breaks[:], partial.pieces[:])
        return right(whole, piece)

    return lower_envelope_cm


@sabotage(
    "LowerEnvelope_CM: replaced by LowerEnvelope_MM",
    lower_envelope.lower_envelope_cm,
    "Corollary 4.5",
)
def merge_instead(right: Procedure) -> Procedure:
    return lambda partial, piece: lower_envelope.lower_envelope_mm([partial, piece])


@sabotage(
    "LowerEnvelope_CM: right, but every partial trajectory is kept",
    lower_envelope.lower_envelope_cm,
    "Corollary 4.5",
)
def keep_each(right: Procedure) -> Procedure:
    kept: list[Any] = []

    def lower_envelope_cm(partial: Any, piece: Any) -> Any:
        kept.append((partial.breaks[:], partial.pieces[:]))
        return right(partial, piece)

    return lower_envelope_cm


@sabotage(
    "Trajectory_CC: right, but the list is copied for each edge",
    cc.merge_by_slope,
    "Corollary 3.4",
    timed=True,
)
def concatenate(right: Procedure) -> Procedure:
    def merge_by_slope(first: Any, second: Any) -> Any:
        chain: list[Any] = []
        for point in right(first, second):
            chain = [*chain, point]
        return chain

    return merge_by_slope


@sabotage(
    "Trajectory_CM: right, but with m² + n² comparisons more", cm.trajectory_cm, "Corollary 4.5"
)
def compare_squared(right: Procedure) -> Procedure:
    def trajectory_cm(generatrix: Any, directrix: Any) -> Any:
        for points in (list(generatrix), list(directrix)):
            compare_all(points, points)
        return right(generatrix, directrix)

    return trajectory_cm


@sabotage("Trajectory_MM: right, but run log n times", mm.trajectory_mm, "Corollary 5.7")
def run_log_times(right: Procedure) -> Procedure:
    def trajectory_mm(generatrix: Any, directrix: Any) -> Any:
        for _ in range(len(generatrix).bit_length() - 1):
            right(generatrix, directrix)
        return right(generatrix, directrix)

    return trajectory_mm


@sabotage(
    "LowerEnvelope_MM: right, but one chain after the other",
    lower_envelope.lower_envelope_mm,
    "Levels of divide and conquer",
)
def merge_by_turns(right: Procedure) -> Procedure:
    return lambda envelopes: reduce(lower_envelope.merge, envelopes)


@sabotage(
    "Sweep_MM, inner loop: right, but all of T's inside is swept",
    mm.inner_mm,
    "A faster inner loop",
)
def sweep_all_again(right: Procedure) -> Procedure:
    def inner_mm(top: Any, trajectory: Any, directrix: Any) -> Any:
        literal.trajectory_mm(top, chain.inverse(chain.complement(list(trajectory))))
        return right(top, trajectory, directrix)

    return inner_mm


def keep_table(right: Procedure) -> Procedure:
    """A table of all pairs of vertices of D_b is kept while the procedure runs."""

    def large(*arguments: Any) -> Any:
        directrix = list(arguments[-1])
        kept = [(p, q) for p in range(len(directrix)) for q in range(len(directrix))]
        return right(*arguments) if kept else []

    return large


for fault, procedure, row in (
    ("Trajectory_CC", cc.trajectory_cc, "Corollary 3.4"),
    ("SweepI_CM", cm.sweep_inner_cm, "Corollary 4.6"),
    ("Trajectory_MM", mm.trajectory_mm, "Corollary 5.7"),
    ("Sweep_MM", mm.sweep_mm, "Corollary 5.8"),
):
    sabotage(f"{fault}: right, but a table of m² is kept", procedure, row)(keep_table)


@sabotage(
    "SweepO_CM: right, but begun anew for each vertex of D_b", cm.sweep_outer_cm, "Corollary 4.5"
)
def begin_anew(right: Procedure) -> Procedure:
    def sweep_outer_cm(top: Any, bottom: Any, directrix: Any) -> Any:
        for end in range(2, len(directrix)):
            right(top, bottom, directrix[:end])
        return right(top, bottom, directrix)

    return sweep_outer_cm


@sabotage(
    "SweepI_CM: right, but every edge of the trajectory compared with every vertex of D_b",
    cm.sweep_inner_cm,
    "Misprint in SweepI_CM's cost",
    "Corollary 4.6",
)
def compare_with_all(right: Procedure) -> Procedure:
    def sweep_inner_cm(generatrix: Any, directrix: Any, trajectory: Any = None) -> Any:
        found = cm.trajectory_cm(generatrix, directrix) if trajectory is None else trajectory
        compare_all(directrix, found)
        return right(generatrix, directrix, found)

    return sweep_inner_cm


@sabotage(
    "Sweep_MM, outer loop: right, but every vertex of it compared with every one of T",
    mm.outer_mm,
    "Corollary 5.8",
)
def compare_outer_with_all(right: Procedure) -> Procedure:
    def outer_mm(bottom: Any, trajectory: Any) -> Any:
        found = right(bottom, trajectory)
        path = list(trajectory)
        compare_all(found, path)
        return found

    return outer_mm


@sabotage(
    "merge: right, but all vertices of one chain are compared with all of the other",
    lower_envelope.merge,
    "Two chains in linear time",
)
def merge_squared(right: Procedure) -> Procedure:
    def merge(first: Any, second: Any) -> Any:
        compare_all(first, second)
        return right(first, second)

    return merge


def copy_for_each(right: Procedure) -> Procedure:
    """All that comes out is copied once for each vertex of it."""

    def slow(*arguments: Any) -> Any:
        found = right(*arguments)
        chains = found if isinstance(found, tuple) else (found,)
        for points in map(list, chains):
            for _ in points:
                points = list(points)
        return found

    return slow


for fault, procedure, row in (
    ("Trajectory_MM", mm.trajectory_mm, "Corollary 5.7"),
    ("Sweep_MM", mm.sweep_mm, "Corollary 5.8"),
    ("SweepI_CM", cm.sweep_inner_cm, "Corollary 4.6"),
):
    sabotage(f"{fault}: right, but copied for each vertex", procedure, row, timed=True)(
        copy_for_each
    )


@sabotage(
    "LowerEnvelope_MM to the letter: right, but one chain after the other",
    literal.lower_envelope_mm,
    "LowerEnvelope_MM",
    "Corollary 5.7",
    "Envelopes at first glance",
)
def merge_literally_by_turns(right: Procedure) -> Procedure:
    return lambda chains: reduce(literal.merge, chains)


@sabotage(
    "Trajectory_CC: right, but with (m + n)^1.5 additions", cc.merge_by_slope, "Corollary 3.4"
)
def add_often(right: Procedure) -> Procedure:
    def merge_by_slope(first: Any, second: Any) -> Any:
        size = len(first) + len(second)
        for x, _ in first:
            for _ in range(int(size**0.5)):
                x + x
        return right(first, second)

    return merge_by_slope


@sabotage(
    "Trajectory_CC: right, but (m + n)^1.4 slots of a list are kept",
    cc.merge_by_slope,
    "Corollary 3.4",
)
def keep_slots(right: Procedure) -> Procedure:
    def merge_by_slope(first: Any, second: Any) -> Any:
        kept = [None] * int((len(first) + len(second)) ** 1.4)
        return right(first, second) if kept else []

    return merge_by_slope


@sabotage(
    "Trajectory_CC: right, but each third vertex is compared log(m + n) times",
    cc.merge_by_slope,
    "Corollary 3.4",
)
def compare_log_times(right: Procedure) -> Procedure:
    def merge_by_slope(first: Any, second: Any) -> Any:
        found = list(right(first, second))
        for x, _ in found[::3]:
            for _ in range(len(found).bit_length()):
                x < x  # noqa: B015
        return found

    return merge_by_slope


@sabotage(
    "Trajectory_CM to the letter: right, but begun anew for each vertex of D_b",
    literal.trajectory_cm,
    "Cost of step 2",
)
def begin_literally_anew(right: Procedure) -> Procedure:
    def trajectory_cm(top: Any, directrix: Any) -> Any:
        for end in range(2, len(directrix)):
            right(top, directrix[:end])
        return right(top, directrix)

    return trajectory_cm


def compare_in_parts(which: int) -> Callable[[Procedure], Procedure]:
    """All vertices of each convex part of G_t (0) or of D_b (1) are compared with one another."""

    def wrong(right: Procedure) -> Procedure:
        def procedure(generatrix: Any, directrix: Any) -> Any:
            for part in chain.find_convex_parts(
                [chain.inverse(generatrix), list(directrix)][which]
            ):
                compare_all(part, part)
            return right(generatrix, directrix)

        return procedure

    return wrong


sabotage(
    "Trajectory_CM: right, but quadratic in the edges of a convex part of D_b",
    cm.trajectory_cm,
    "Corollary 4.5",
)(compare_in_parts(1))
sabotage(
    "Trajectory_MM: right, but quadratic in the edges of a convex part of G_t",
    mm.trajectory_mm,
    "Corollary 5.7",
)(compare_in_parts(0))


@sabotage("Sweep_MM: right, but found anew √n times", mm.sweep_mm, "Corollary 5.8")
def find_anew(right: Procedure) -> Procedure:
    def sweep_mm(*arguments: Any) -> Any:
        return [right(*arguments) for _ in range(int(len(arguments[0]) ** 0.5))][-1]

    return sweep_mm


@sabotage("SweepO_CC: right, but sorted by comparisons", cc.sweep_outer_cc, "Corollary 3.4")
def sort_again(right: Procedure) -> Procedure:
    def sweep_outer_cc(*arguments: Any) -> Any:
        found = right(*arguments)
        sorted(x * 7919 % 104729 for x, _ in found)
        return found

    return sweep_outer_cc


@sabotage(
    "LowerEnvelope_MM: right, but each break of a merge is compared log(m + n) times",
    lower_envelope.merge,
    "Two chains in linear time",
)
def compare_breaks(right: Procedure) -> Procedure:
    def merge(first: Any, second: Any) -> Any:
        found = right(first, second)
        for n, _ in found.breaks:
            for _ in range(len(found.breaks).bit_length()):
                n < n  # noqa: B015
        return found

    return merge
