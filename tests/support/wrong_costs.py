"""Sabotages with right answers and too many operations, seconds or bytes."""

from collections.abc import Callable
from functools import reduce
from itertools import product
from typing import Any

from sabotage import Procedure, Sabotage, sabotage

from exactsweep.procedures import cc, chain, cm, graph, mm
from exactsweep.procedures.chain import Chain, precedes
from exactsweep.procedures.graph import Graph

Waste = Callable[..., object]


def before(waste: Waste) -> Sabotage:
    """Do useless work on the arguments first, and keep its result during the run."""

    def wrong(right: Procedure) -> Procedure:
        def procedure(*arguments: Any) -> Any:
            kept = waste(*arguments)
            found = right(*arguments)
            del kept
            return found

        return procedure

    return wrong


def after(waste: Waste) -> Sabotage:
    """Do useless work on the answer and the arguments."""

    def wrong(right: Procedure) -> Procedure:
        def procedure(*arguments: Any) -> Any:
            found = right(*arguments)
            waste(found, *arguments)
            return found

        return procedure

    return wrong


def repeated(times: Callable[[int], int]) -> Sabotage:
    """Repeat in proportion to the size of the first argument."""

    def wrong(right: Procedure) -> Procedure:
        def procedure(*arguments: Any) -> Any:
            for _ in range(times(len(arguments[0].vertices)) - 1):
                right(*arguments)
            return right(*arguments)

        return procedure

    return wrong


def restart(right: Procedure) -> Procedure:
    """Also run for the prefixes of the last argument."""

    def procedure(*arguments: Any) -> Any:
        points = [*arguments[-1]]
        for end in range(2, len(points)):
            right(*arguments[:-1], Chain.of(points[:end]))
        return right(*arguments)

    return procedure


def compare_all(first: Any, second: Any) -> None:
    """Compare all vertices of two chains, which counts as operations."""
    for x, _ in first:
        for other, _ in second:
            x < other  # noqa: B015


def measure(chains: Any) -> int:
    """Count the vertices of chains."""
    return sum(len(c.vertices) for c in chains)


def compare_log_times(numbers: Any, size: int) -> None:
    for x in numbers:
        for _ in range(size.bit_length()):
            x < x  # noqa: B015


def compare_trajectory(generatrix: Any, directrix: Any, trajectory: Any = None) -> None:
    if trajectory is None:
        trajectory = cm.trajectory_cm(generatrix, directrix)
    for _ in range(len(directrix.vertices).bit_length()):
        compare_all(directrix, trajectory)


def compare_in_parts(chain_of: Callable[[Any, Any], Any]) -> Waste:
    """Compare all vertices of each convex part of a chain with one another."""

    def waste(generatrix: Any, directrix: Any) -> None:
        points = [*chain_of(generatrix, directrix)]
        for part in chain.partition(*[Chain.of(points)] * 2)[1]:
            own = points[part.first : part.first + len(part.edges) + 1]
            compare_all(own * 4, own)

    return waste


def keep_table(*arguments: Any) -> object:
    """Keep a table of all pairs of vertices of D, which has about twice as many as D_b."""
    return list(product(range(2 * len(list(arguments[-1]))), repeat=2))


def concatenate(found: Any, *arguments: Any) -> None:
    """Copy the list for each edge."""
    points: list[Any] = []
    for point in found:
        points = [*points, point]


def copy_for_each(found: Any, *arguments: Any) -> None:
    """Copy the whole result once for each of its vertices."""
    for points in map(list, found if isinstance(found, tuple) else (found,)):
        for _ in points:
            list(points)


def keep_each(right: Procedure) -> Procedure:
    kept: list[Any] = []

    def lower_envelope_cm(partial: Any, piece: Any) -> Any:
        kept.append((partial.breaks[:], partial.pieces[:]))
        return right(partial, piece)

    return lower_envelope_cm


def copy(right: Procedure) -> Procedure:
    return lambda partial, piece: right(Graph(partial.breaks[:], partial.pieces[:]), piece)


BY_FAULT: dict[Procedure, dict[str, Sabotage]] = {
    cc.trajectory_cc: {
        "Trajectory_CC: right, but in quadratic time": before(
            lambda *chains: compare_all(*chains[:2])
        ),
        "Trajectory_CC: right, but with (m + n)^1.5 additions": before(
            lambda *chains: [
                x + x for x, _ in chains[0] for _ in range(int(measure(chains) ** 0.5))
            ]
        ),
        "Trajectory_CC: right, but (m + n)^1.5 slots of a list are kept": before(
            lambda *chains: [None] * int(measure(chains) ** 1.5)
        ),
        "Trajectory_CC: right, but each vertex is compared 8 log(m + n) times": after(
            lambda found, *chains: compare_log_times([x for x, _ in found] * 8, measure(chains))
        ),
        "Trajectory_CC: right, but a table of m² is kept": before(keep_table),
    },
    cc.sweep_outer_cc: {
        "SweepO_CC: right, but sorted twice by comparisons": after(
            lambda found, *chains: [
                sorted(x * step % 104729 for x, _ in found) for step in (7919, 1299709)
            ]
        )
    },
    graph.lower_envelope_cm: {
        "LowerEnvelope_CM: right, but all of the partial trajectory is walked each time": before(
            lambda partial, piece: [precedes(at, piece.breaks[0]) for at in partial.breaks]
        ),
        "LowerEnvelope_CM: right, but all of the partial trajectory is copied each time": copy,
        "LowerEnvelope_CM: replaced by LowerEnvelope_MM": lambda right: (
            lambda partial, piece: graph.lower_envelope_mm([partial, piece])
        ),
        "LowerEnvelope_CM: right, but every partial trajectory is kept": keep_each,
    },
    cm.trajectory_cm: {
        "Trajectory_CM: right, but with m² + n² additional comparisons": before(
            lambda *chains: [*map(compare_all, chains, chains)]
        ),
        "Trajectory_CM: right, but restarted at each vertex of D_b": restart,
        "Trajectory_CM: right, but quadratic in the edges of a convex part of D_b": before(
            compare_in_parts(lambda generatrix, directrix: list(directrix))
        ),
    },
    cm.sweep_inner_cm: {
        "SweepI_CM: right, but a table of m² is kept": before(keep_table),
        "SweepI_CM: right, but T's edges are compared log m times with every vertex of D_b": before(
            compare_trajectory
        ),
    },
    cm.sweep_outer_cm: {"SweepO_CM: right, but restarted at each vertex of D_b": restart},
    mm.trajectory_mm: {
        "Trajectory_MM: right, but run log n times": repeated(int.bit_length),
        "Trajectory_MM: right, but a table of m² is kept": before(keep_table),
        "Trajectory_MM: right, but quadratic in the edges of a convex part of G_t": before(
            compare_in_parts(lambda generatrix, directrix: generatrix)
        ),
    },
    mm.sweep_inner_mm: {
        "Sweep_MM, inner loop: right, but the whole inside of T is swept": before(
            lambda generatrix, directrix, trajectory, *path: mm.trajectory_mm(
                generatrix, trajectory.chain().half_turn()
            )
        )
    },
    mm.sweep_outer_mm: {
        "Sweep_MM, outer loop: right, but each vertex is compared with every vertex of T": after(
            lambda found, bottom, trajectory: compare_all(found, trajectory)
        )
    },
    mm.sweep_mm: {
        "Sweep_MM: right, but a table of m² is kept": before(keep_table),
        "Sweep_MM: right, but computed √n times": repeated(lambda n: int(n**0.5)),
    },
    graph.lower_envelope_mm: {
        "LowerEnvelope_MM: right, but one chain at a time": lambda right: (
            lambda graphs: reduce(graph.merge, graphs)
        )
    },
    graph.merge: {
        "merge: right, but all vertices of one chain are compared with all of the other": before(
            compare_all
        ),
        "LowerEnvelope_MM: right, but each break of a merge is compared log(m + n) times": after(
            lambda found, *chains: compare_log_times(
                (n for n, _ in found.breaks), len(found.breaks)
            )
        ),
    },
}
for procedure, faults in BY_FAULT.items():
    for fault, wrong in faults.items():
        sabotage(fault, procedure)(wrong)
for fault, procedure, waste in (
    ("Trajectory_CC: right, but the list is copied for each edge", cc.trajectory_cc, concatenate),
    ("Trajectory_MM: right, but copied for each vertex", mm.trajectory_mm, copy_for_each),
    ("Sweep_MM: right, but copied for each vertex", mm.sweep_mm, copy_for_each),
    ("SweepI_CM: right, but copied for each vertex", cm.sweep_inner_cm, copy_for_each),
):
    sabotage(fault, procedure, timed=True)(after(waste))
