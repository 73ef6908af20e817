"""The paper's procedures on lists of vertices, and unoptimized combinations of them.

As in the paper, G_t runs from right to left; all other chains run from left to right.
"""

from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise, product

from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Vertex
from exactsweep.paper.pairs import Chains
from exactsweep.procedures import cc, chain, cm, graph, mm
from exactsweep.procedures.chain import Chain, inverse
from exactsweep.procedures.graph import Graph, Piece, VertexContact

VertexList = list[Vertex]


def invert_top(top: Sequence[Vertex]) -> Chain:
    return Chain.of(inverse(top))


def trajectory_cc(top: Sequence[Vertex], directrix: Sequence[Vertex]) -> VertexList:
    return list(cc.trajectory_cc(invert_top(top), Chain.of(directrix)))


def sweep_inner_cc(top: Sequence[Vertex], directrix: Sequence[Vertex]) -> VertexList:
    return cc.sweep_inner_cc(invert_top(top), Chain.of(directrix)).points


def sweep_outer_cc(
    top: Sequence[Vertex], bottom: Sequence[Vertex], directrix: Sequence[Vertex]
) -> VertexList:
    return list(cc.sweep_outer_cc(invert_top(top), Chain.of(bottom), Chain.of(directrix)))


def trajectory_cm(top: Sequence[Vertex], directrix: Sequence[Vertex]) -> Graph:
    return cm.trajectory_cm(invert_top(top), Chain.of(directrix))


def sweep_inner_cm(
    top: Sequence[Vertex], directrix: Sequence[Vertex], trajectory: Graph | None = None
) -> VertexList:
    return cm.sweep_inner_cm(invert_top(top), Chain.of(directrix), trajectory).points


def sweep_outer_cm(
    top: Sequence[Vertex], bottom: Sequence[Vertex], directrix: Sequence[Vertex]
) -> Graph:
    return cm.sweep_outer_cm(invert_top(top), Chain.of(bottom), Chain.of(directrix))


def trajectory_mm(top: Sequence[Vertex], directrix: Sequence[Vertex]) -> Graph:
    return mm.trajectory_mm(invert_top(top), Chain.of(directrix))


def sweep_mm(
    top: Sequence[Vertex], bottom: Sequence[Vertex], directrix: Sequence[Vertex]
) -> tuple[VertexList, VertexList]:
    inner, outer = mm.sweep_mm(invert_top(top), Chain.of(bottom), Chain.of(directrix))
    return inner.points, outer.points


def sweep_inner_mm(
    top: Sequence[Vertex], directrix: Sequence[Vertex], trajectory: Graph
) -> VertexList:
    """Compute the inner boundary of Sweep_MM by sweeping only the undercuts."""
    path = trajectory.chain()
    return mm.sweep_inner_mm(invert_top(top), Chain.of(directrix), trajectory, path).points


def find_convex_parts(points: Sequence[Vertex]) -> list[VertexList]:
    """Split a bottom chain at its reflex vertices and vertical edges (Section 4, step 1)."""
    made = Chain.of(points)
    return [
        made.points[part.first : part.first + len(part.edges) + 1]
        for part in chain.partition(made, made)[1]
    ]


def require_convex(points: Sequence[Vertex]) -> VertexList:
    first, *others = find_convex_parts(points)
    if others:
        x, y = others[0][0]
        raise ExactSweepError(f"the chain has a reflex vertex or a vertical edge at ({x}, {y})")
    return first


def to_graph(points: Sequence[Vertex]) -> Graph:
    """Convert a bottom chain to a graph, with contacts between one vertex of G and those of D_b."""
    made = Chain.of(points)
    contacts: list[VertexContact] = [(v, k, 0) for k, v in enumerate(made.vertices)]
    pieces: list[Piece] = [
        (*line, *ends) for line, ends in zip(made.lines, pairwise(contacts), strict=True) if line[0]
    ]
    (*_, ((x, _, w), _, _)) = pieces[-1]
    return Graph([*((u, v) for _, _, _, ((u, _, v), _, _), _ in pieces), (x, w)], pieces)


def list_sub_trajectories(chains: Chains) -> list[Graph]:
    """Run Trajectory_CM for each convex part of G_t (Trajectory_MM, step 2)."""
    parts = find_convex_parts(inverse(chains.top))
    return [cm.trajectory_cm(Chain.of(part), Chain.of(chains.directrix)) for part in parts]


def merge_sub_trajectories(chains: Chains) -> Graph:
    """Run Trajectory_MM as printed: all calls of Trajectory_CM, then LowerEnvelope_MM."""
    return graph.lower_envelope_mm(list_sub_trajectories(chains))


def find_trajectory(chains: Chains) -> VertexList:
    """Compute the trajectory for any class, as the lower envelope of sums of two convex parts."""
    parts = find_convex_parts(inverse(chains.top)), find_convex_parts(chains.directrix)
    sums = [trajectory_cc(inverse(one), other) for one, other in product(*parts)]
    return list(graph.lower_envelope_mm(list(map(to_graph, sums))))


def find_outer(chains: Chains) -> VertexList:
    """Compute the outer boundary for any class, as Sweep_MM does."""
    return find_trajectory(Chains(inverse(chains.bottom), [], find_trajectory(chains)))


def find_inner(chains: Chains) -> VertexList:
    """Compute the inner boundary for any class; it extends beyond D_b at both ends."""
    return slide_inside(inverse(chains.top), find_trajectory(chains), find_trajectory)


def slide_inside(
    bottom: Sequence[Vertex],
    container: Sequence[Vertex],
    trajectory: Callable[[Chains], Iterable[Vertex]],
) -> VertexList:
    """Compute the lowest path of a shape that slides along the inside of a bottom chain."""
    # After a half turn, the complement of the container is again a bottom chain.
    outside = chain.complement(inverse(container))
    path = trajectory(Chains(inverse(bottom), [], outside))
    return chain.complement(inverse(path))
