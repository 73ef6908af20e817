"""Section 5: monotone generatrix, monotone directrix; the loops and the inverse generatrix."""

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from itertools import pairwise

from exactsweep import Polygon, Sweep, sweep
from exactsweep.check import point_in_polygon
from exactsweep.geometry.region import AnyPolygon
from exactsweep.geometry.segment import Segment, make_segment
from exactsweep.numbers.number import Edge, Rational, Vertex
from exactsweep.paper import kernel
from exactsweep.paper.checks.section3 import returns, slope
from exactsweep.paper.checks.section4 import MONOTONE, is_monotone, lowest
from exactsweep.paper.claim import Counterexample, Effort, Observation, find_first_failure
from exactsweep.paper.functions import (
    clip_to,
    compare_boundaries,
    compare_loops,
    describe_difference,
    keep_corners,
    list_edges,
    look_up,
    look_up_bottom,
    write_chain,
)
from exactsweep.paper.laws import search_grid, shrink
from exactsweep.paper.pairs import SweepPair
from exactsweep.procedures.chain import complement, inverse, split

# Along one edge of T, edges of both loops are at distance 11, but G has width 16.
NARROW = SweepPair(
    [(0, 0), (1, -8), (2, -1), (7, -1), (10, 7), (9, 8), (7, 1), (5, 0), (2, 3)],
    [(0, 0), (30, 0), (15, 3)],
)


trajectory_mm_is_correct = returns(trajectory="Trajectory_MM")
mm_trajectory_is_monotone = returns("", is_monotone, trajectory="Trajectory_MM")


def sub_trajectories_suffice(pair: SweepPair) -> Iterator[str]:
    """The trajectory is the lower envelope of the trajectories of G_t's convex parts."""
    chains = [list(chain) for chain in kernel.list_sub_trajectories(pair.chains)]
    yield lowest("sub-trajectory", chains, look_up_bottom(pair, "trajectory"))


def inverse_is_a_reflection(pair: SweepPair) -> Iterator[str]:
    """The inverses of vertices, of chains and of the polygon are their point reflections."""
    g = Polygon(pair.generatrix)
    if g.reflected().reflected() != g:
        yield "the inverse of the inverse is not G"
    mirrored = g.reflected((1, 2))
    if mirrored != g.reflected().translated((2, 4)):
        yield "reflections about two points differ by more than a translation"
    if any(point_in_polygon((2 - x, 4 - y), mirrored) != 0 for x, y in pair.generatrix):
        yield "the image of a vertex is off the boundary of the image"
    bottom, top = split(pair.generatrix)
    inverted = [(int(x), int(y)) for x, y in g.reflected().vertices]
    if split(inverted) != (inverse(top), inverse(bottom)):
        yield "the inverse of the top chain is not the bottom chain of the inverse"


def complement_has_the_exterior_left(pair: SweepPair) -> Iterator[str]:
    """The complement is the same chain, with the exterior on its left."""
    directrix = pair.chains.directrix
    if complement(complement(directrix)) != directrix:
        yield "the complement of the complement is a different chain"
    polygon, eps = Polygon(pair.directrix), Fraction(1, 10**9)
    for sign, chain in ((1, directrix), (-1, complement(directrix))):
        for (px, py), (qx, qy) in pairwise(chain):
            x, y = (px + qx) * Fraction(1, 2), (py + qy) * Fraction(1, 2)
            left = x - eps * (qy - py), y + eps * (qx - px)
            if point_in_polygon(left, polygon) != sign:
                yield f"the wrong side of D is on the left of ({px}, {py}) to ({qx}, {qy})"


def loops_are_retraced(pair: SweepPair) -> Iterator[str]:
    """Both loops are trajectories of I(G): around T for the outer, inside T for the inner loop."""
    inner, outer = kernel.find_inner(pair.chains), kernel.find_outer(pair.chains)
    whole = sweep(sweep(*pair).generatrix.reflected(), sweep(*pair).trajectory).trajectory
    if whole.vertices != look_up(pair).outer:
        yield "the trajectory of I(G) around T is not the outer loop"
    yield from compare_boundaries(pair, inner=clip_to(inner, pair.chains.directrix), outer=outer)


def inner_as_printed(pair: SweepPair) -> Iterator[str]:
    """Trajectory_MM along the inside of T returns the inner boundary."""
    inner = keep_corners(kernel.find_inner(pair.chains))
    expected = look_up_bottom(pair, "inner")
    if inner != expected:
        yield (
            f"Trajectory_MM along the inside of T extends from x = {inner[0][0]} to {inner[-1][0]} "
            f"in {len(inner) - 1} edges; the inner boundary, from {expected[0][0]} to "
            f"{expected[-1][0]} in {len(expected) - 1}"
        )


sweep_mm_is_correct = returns(
    "Sweep_MM, as corrected, returns both boundaries as defined.",
    inner="Sweep_MM, inner loop",
    outer="Sweep_MM, outer loop",
)
loops_are_monotone = returns(
    MONOTONE, is_monotone, inner="Sweep_MM, inner loop", outer="Sweep_MM, outer loop"
)


def trajectory_is_monotone(pair: SweepPair) -> Iterator[str]:
    """The trajectory is a simple polygon that consists of two X-monotone chains."""
    s = sweep(*pair)
    bottom, top = split(Polygon(s.trajectory.vertices).vertices)
    yield from compare_loops(s, "trajectory")
    yield from mm_trajectory_is_monotone(pair)
    yield from is_monotone("the bottom chain of T", bottom)
    yield from is_monotone("the top chain of T", top[::-1])


def local_width(pair: SweepPair) -> Iterator[str]:
    """The distance of the outer loop from an edge of a convex D is the width of G there."""
    s = sweep(*pair)
    yield from _compare_width(s, s.inner)


def _compare_width(s: Sweep, inside: AnyPolygon) -> Iterator[str]:
    """Report edges whose distance from the outer loop differs from the width of G across them."""
    for p, q in list_edges(inside.vertices):
        normal = q.y - p.y, p.x - q.x
        reach, own = (max(_measure(normal, loop)) for loop in (s.outer, inside))
        if reach - own != _measure_width(normal, s.generatrix):
            yield f"across ({p.x}, {p.y}) to ({q.x}, {q.y}) the width differs from that of G"


def _measure(normal: Vertex, points: Iterable[Vertex]) -> list[Rational]:
    """Return the distances of points along a vector, in units of its length."""
    return [normal[0] * x + normal[1] * y for x, y in points]


def _measure_width(normal: Vertex, polygon: AnyPolygon) -> Rational:
    heights = _measure(normal, polygon.vertices)
    return max(heights) - min(heights)


def find_missing_edge(effort: Effort) -> Iterator[Observation]:
    def misses_slopes(pair: SweepPair, name: str) -> Iterator[str]:
        s = sweep(*pair)
        slopes, own = ({*map(slope, list_edges(x))} for x in (s.trajectory, getattr(s, name)))
        for missing in sorted(slopes - own):
            yield f"the trajectory has edges of slope {missing}, the {name} loop has none"

    yield search_grid(2, 6, "convex", "convex", partial(misses_slopes, name="inner"))
    yield (outer := search_grid(3, 8, "bent", "bent", partial(misses_slopes, name="outer")))
    yield "" if outer.cases else "the outer loop has edges of all slopes of the trajectory"
    near = shrink(edges_are_near, NARROW)
    text = find_first_failure(edges_are_near(near))
    how = "by hand, reduced while both edges remain too near"
    yield Counterexample(text, how, *near) if text else "no edges are nearer than the width of G"


def edges_are_near(pair: SweepPair) -> Iterator[str]:
    """Report edges of both loops along one edge of T that are nearer than the width of G."""
    s = sweep(*pair)
    if any(p.x == q.x for polygon in (s.generatrix, s.directrix) for p, q in list_edges(polygon)):
        return
    loops = [[make_segment(edge) for edge in list_edges(loop)] for loop in (s.inner, s.outer)]
    for p, q in list_edges(s.trajectory):
        normal = q.y - p.y, p.x - q.x
        inner, outer = (
            _measure(normal, [v for v in s.generatrix.vertices if _traces(v, (p, q), loop)])
            for loop in loops
        )
        width = _measure_width(normal, s.generatrix)
        if inner and outer and max(outer) - min(inner) < width:
            yield (
                f"along ({p.x}, {p.y}) to ({q.x}, {q.y}) both edges exist, at distance "
                f"{max(outer) - min(inner)}, but G has width {width}, in units of the edge's "
                "length"
            )


def _traces(v: Vertex, edge: Edge, loop: Sequence[Segment]) -> bool:
    """Decide whether a vertex of G traces part of a loop along an edge of the trajectory."""
    (px, py), (qx, qy) = edge
    drawn = make_segment(((px + v[0], py + v[1]), (qx + v[0], qy + v[1])))
    return any(drawn[:2] == other[:2] and drawn.shares_piece(other) for other in loop)


def outside_of_the_inner_loop(pair: SweepPair) -> Iterator[str]:
    """The sweep of G around the inner loop has the same trajectory as that around D."""
    s = sweep(*pair)
    if sweep(s.generatrix, s.inner).trajectory != s.trajectory:
        yield "the trajectory around the inner loop differs"
    yield from compare_loops(s, "inner")


def inside_of_the_outer_loop(pair: SweepPair) -> Iterator[str]:
    """The lowest path of G inside the outer loop is the trajectory."""
    path, outer = look_up_bottom(pair, "trajectory"), look_up_bottom(pair, "outer")
    found = clip_to(
        kernel.slide_inside(pair.chains.bottom, outer, lambda c: kernel.trajectory_mm(*c[::2])),
        path,
    )
    if found != path:
        chains = write_chain(found), write_chain(path)
        yield f"inside the outer loop, the path of G is {chains[0]}; the trajectory, {chains[1]}"


def shortcuts_change_nothing(pair: SweepPair) -> Iterator[str]:
    """Pruning, and sweeping only the undercuts, change neither trajectory nor boundaries."""
    top, bottom, directrix = pair.chains
    inner, outer = kernel.find_inner(pair.chains), kernel.find_outer(pair.chains)
    path, found = kernel.trajectory_mm(top, directrix), kernel.sweep_mm(top, bottom, directrix)
    for name, chain, literally in (
        ("trajectory", path, kernel.find_trajectory(pair.chains)),
        ("outer boundary", found[1], outer),
        ("inner boundary", found[0], clip_to(inner, directrix)),
    ):
        yield describe_difference(f"the {name}", chain, literally, "as printed")


def outer_loop_extends_by_the_width(pair: SweepPair) -> Iterator[str]:
    """The outer loop extends beyond each edge of D by the width of G across the edge."""
    s = sweep(*pair)
    yield from compare_loops(s, "outer")
    yield from _compare_width(s, s.directrix)
