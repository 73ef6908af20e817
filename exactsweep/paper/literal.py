"""The paper's procedures to the letter, on lists of vertices: a baseline for the kernel.

The procedures do not prune, guess or work in batches, and share no code with the kernel. They take
strictly X-monotone polygons, as in the paper. SweepI_CC returns D_b, and the kernel's SweepI_CM is
as printed, so it is not repeated here. Chains are lists of vertices: G_t from right to left, all
others from left to right.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from functools import reduce
from itertools import pairwise

from exactsweep.corpus.generator.shapes import walk
from exactsweep.numbers.number import Vertex
from exactsweep.paper.functions import clip_to
from exactsweep.paper.pairs import Chains

Chain = list[Vertex]


def trajectory_cc(top: Sequence[Vertex], directrix: Sequence[Vertex]) -> Chain:
    """Merge the edges of reversed G_t and of D_b by slope.

    >>> trajectory_cc([(1, 1), (0, 1)], [(0, 0), (1, -1), (2, 0)])
    [(-1, -1), (0, -2), (1, -2), (2, -1)]
    """
    (x, y), (dx, dy) = directrix[0], top[0]
    return _lay((x - dx, y - dy), _turn(top), directrix)


def sweep_outer_cc(
    top: Sequence[Vertex], bottom: Sequence[Vertex], directrix: Sequence[Vertex]
) -> Chain:
    """Merge the edges of reversed G_t, of G_b and of D_b, from v_l of D + (v_l - v_r of G) on."""
    (x, y), (left_x, left_y), (right_x, right_y) = directrix[0], bottom[0], top[0]
    return _lay((x + left_x - right_x, y + left_y - right_y), _turn(top), bottom, directrix)


def trajectory_cm(top: Sequence[Vertex], directrix: Sequence[Vertex]) -> Chain:
    """Call Trajectory_CC for each convex chain of D_b, and LowerEnvelope_CM after each."""
    parts = (trajectory_cc(top, part) for part in split_at_reflex(directrix))
    return reduce(lower_envelope_cm, parts, [])


def sweep_outer_cm(
    top: Sequence[Vertex], bottom: Sequence[Vertex], directrix: Sequence[Vertex]
) -> Chain:
    """Call SweepO_CC for each convex chain of D_b, and LowerEnvelope_CM after each."""
    parts = (sweep_outer_cc(top, bottom, part) for part in split_at_reflex(directrix))
    return reduce(lower_envelope_cm, parts, [])


def lower_envelope_cm(partial: Chain, piece: Sequence[Vertex]) -> Chain:
    """Walk both from right to left until they meet; the partial trajectory is cut in place.

    Cost: O(edges of the piece + edges trimmed off).
    """
    if not partial:
        return list(piece)
    x, k = partial[-1][0], len(piece) - 1
    while piece[k - 1][0] >= x:
        k -= 1
    gap = partial[-1][1] - _height(piece[k - 1], piece[k], x)
    while True:
        before, end = partial[-2:]
        left = max(before[0], piece[k - 1][0])
        height = _height(before, end, left)
        above = height - _height(piece[k - 1], piece[k], left)
        if above <= 0:
            share = Fraction(above) / (above - gap) if gap != above else Fraction(1)
            meeting = left + share * (x - left)
            partial.pop()
            for point in ((meeting, _height(before, end, meeting)), *piece[k:]):
                _append(partial, point)
            return partial
        x, gap = left, above
        if before[0] == left:
            partial.pop()
        if piece[k - 1][0] == left:
            k -= 1


def trajectory_mm(top: Sequence[Vertex], directrix: Sequence[Vertex]) -> Chain:
    """Call Trajectory_CM for each convex chain of G_t, and LowerEnvelope_MM for all that comes."""
    parts = [_turn(part) for part in split_at_reflex(_turn(top))]
    return lower_envelope_mm([trajectory_cm(part, directrix) for part in parts])


def lower_envelope_mm(chains: Sequence[Chain]) -> Chain:
    """Halve the chains, and merge the envelopes of both halves.

    Cost: O(N log k) for k chains, N being the largest total size on a level of the recursion.
    """
    if len(chains) == 1:
        return chains[0]
    half = len(chains) // 2
    return merge(lower_envelope_mm(chains[:half]), lower_envelope_mm(chains[half:]))


def merge(first: Chain, second: Chain) -> Chain:
    """Walk two chains in vertical sync, and keep the lower one.

    Cost: O(size of first + size of second).

    >>> merge([(0, 0), (4, 4)], [(0, 4), (4, 0)])
    [(0, 0), (Fraction(2, 1), Fraction(2, 1)), (4, 0)]
    """
    merged: Chain = []
    i = j = 0
    x = min(first[0][0], second[0][0])
    while i < len(first) - 1 or j < len(second) - 1:
        one = (first[i], first[i + 1]) if i < len(first) - 1 else None
        other = (second[j], second[j + 1]) if j < len(second) - 1 else None
        edges = [edge for edge in (one, other) if edge]
        right = min(q[0] if p[0] <= x else p[0] for p, q in edges)
        ends = [(_height(p, q, x), _height(p, q, right)) for p, q in edges if p[0] <= x]
        ends.sort()
        if len(ends) == 2 and ends[0][1] > ends[1][1]:
            (a, b), (c, d) = ends
            share = Fraction(c - a) / (c - a + b - d)
            _append(merged, (x, a))
            _append(merged, (x + share * (right - x), a + share * (b - a)))
            _append(merged, (right, d))
        elif ends:
            _append(merged, (x, ends[0][0]))
            _append(merged, (right, ends[0][1]))
        i += one is not None and one[1][0] == right
        j += other is not None and other[1][0] == right
        x = right
    return merged


def sweep_mm(
    top: Sequence[Vertex], bottom: Sequence[Vertex], directrix: Sequence[Vertex]
) -> tuple[Chain, Chain]:
    """Call Trajectory_MM for D, and for I(G) along either side of what comes.

    Returns the inner boundary, beyond D's range of x as well, and the outer one.
    """
    path = trajectory_mm(top, directrix)
    return slide_inside(_turn(top), path, trajectory_mm), trajectory_mm(_turn(bottom), path)


def slide_inside(
    bottom: Sequence[Vertex],
    container: Sequence[Vertex],
    trajectory: Callable[[Sequence[Vertex], Sequence[Vertex]], Iterable[Vertex]],
) -> Chain:
    """The lowest path of something inside a bottom chain, its own bottom chain touching it.

    Turned by half a turn it slides along the complement of the chain, which is a bottom chain.
    """
    return _turn(trajectory(_turn(bottom), _turn(container)[::-1]))[::-1]


def find_trajectory(chains: Chains) -> Chain:
    """The trajectory of a pair of any class: a convex chain is one part."""
    return trajectory_mm(chains.top, chains.directrix)


def find_outer(chains: Chains) -> Chain:
    """The outer boundary of a pair of any class, by Sweep_MM."""
    return trajectory_mm(_turn(chains.bottom), find_trajectory(chains))


def find_inner(chains: Chains) -> Chain:
    """The inner boundary of a pair of any class, by Sweep_MM, cut off at the ends of D_b."""
    inner = slide_inside(_turn(chains.top), find_trajectory(chains), trajectory_mm)
    return clip_to(inner, chains.directrix)


def split_at_reflex(chain: Sequence[Vertex]) -> list[Chain]:
    """Break a bottom chain at the vertices at which it turns right.

    >>> split_at_reflex([(0, 0), (1, 1), (2, 0)])
    [[(0, 0), (1, 1)], [(1, 1), (2, 0)]]
    """
    parts = [list(chain[:2])]
    for point in chain[2:]:
        (px, py), (qx, qy) = parts[-1][-2:]
        if (qx - px) * (point[1] - qy) < (qy - py) * (point[0] - qx):
            parts.append([(qx, qy)])
        parts[-1].append(point)
    return parts


def _turn(chain: Iterable[Vertex]) -> Chain:
    """A chain turned by half a turn: I(G)'s bottom chain for G_t, and so on."""
    return [(-x, -y) for x, y in chain]


def _lay(start: Vertex, *chains: Sequence[Vertex]) -> Chain:
    """The edges of some chains, merged by slope and laid end to end."""
    steps: Chain = []
    for chain in chains:
        edges = [(qx - px, qy - py) for (px, py), (qx, qy) in pairwise(chain)]
        steps = _merge_by_slope(steps, edges)
    return walk(steps, start)


def _merge_by_slope(first: Sequence[Vertex], second: Sequence[Vertex]) -> Chain:
    steps: Chain = []
    i = j = 0
    while i < len(first) and j < len(second):
        if first[i][1] * second[j][0] <= second[j][1] * first[i][0]:
            steps.append(first[i])
            i += 1
        else:
            steps.append(second[j])
            j += 1
    return [*steps, *first[i:], *second[j:]]


def _height(p: Vertex, q: Vertex, x: int | Fraction) -> int | Fraction:
    if x == p[0]:
        return p[1]
    if x == q[0]:
        return q[1]
    return p[1] + Fraction(q[1] - p[1]) * (x - p[0]) / (q[0] - p[0])


def _append(chain: Chain, point: Vertex) -> None:
    """A vertex further on, unless it is there; one in a straight line takes the last one's place.

    A chain that is cut where another one has a vertex stays one edge.
    """
    if chain and chain[-1] == point:
        return
    if len(chain) > 1:
        (px, py), (qx, qy) = chain[-2:]
        if (qx - px) * (point[1] - qy) == (qy - py) * (point[0] - qx):
            chain.pop()
    chain.append(point)
