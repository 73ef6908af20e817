"""Chains as functions of x, and comparisons with the loops computed from the definition."""

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import cache
from itertools import pairwise
from operator import itemgetter
from typing import Any, TypeVar

from exactsweep.answers import InnerFit, NoFitPolygon
from exactsweep.check import verify
from exactsweep.evidence.undercut import Undercut
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Fit, Vertex
from exactsweep.paper.definition import ReferenceLoops, reference_loops
from exactsweep.paper.kernel import find_convex_parts, sweep_outer_cc, trajectory_cc
from exactsweep.paper.pairs import SweepPair
from exactsweep.procedures.chain import split, take_corners
from exactsweep.sweep import Sweep, no_fit_polygon

P = TypeVar("P", bound=tuple[Any, Any])


def keep_corners(chain: Iterable[Vertex]) -> list[Vertex]:
    """Drop collinear vertices, so that equal chains become equal lists."""
    return [(x, y) for x, y, _ in take_corners((Fraction(x), Fraction(y), 1) for x, y in chain)]


def evaluate(chain: Sequence[Vertex], x: Fraction) -> Fraction:
    """Evaluate a left-to-right chain at an x that has no vertical edge."""
    k = bisect_left(chain, x, key=itemgetter(0))
    if k == len(chain) or x < chain[0][0]:
        raise ExactSweepError(f"{x} is outside the range of the chain")
    (px, py), (qx, qy) = chain[k - 1], chain[k]
    return Fraction(qy) if x == qx else Fraction(py) + Fraction(qy - py) * (x - px) / (qx - px)


def sample_between(*chains: Sequence[Vertex]) -> Iterator[Fraction]:
    """Yield a point inside each interval between consecutive vertex abscissas."""
    xs = sorted({Fraction(x) for chain in chains for x, _ in chain})
    for left, right in pairwise(xs):
        yield (5 * left + 3 * right) / 8


def reaches(chain: Sequence[Vertex], x: Fraction) -> bool:
    return chain[0][0] < x < chain[-1][0]


def list_gaps(first: Sequence[Vertex], second: Sequence[Vertex]) -> list[tuple[Fraction, Fraction]]:
    """List x and first(x) - second(x) at all vertices in the common x-range."""
    left, right = max(first[0][0], second[0][0]), min(first[-1][0], second[-1][0])
    xs = sorted({Fraction(x) for x, _ in (*first, *second) if left <= x <= right})
    return [(x, evaluate(first, x) - evaluate(second, x)) for x in xs]


def find_common_points(first: Sequence[Vertex], second: Sequence[Vertex]) -> list[Fraction]:
    return [x for x, gap in list_gaps(first, second) if gap == 0]


def clip(chain: Sequence[Vertex], left: Fraction, right: Fraction) -> list[Vertex]:
    """Clip a chain to a closed x-range that has no vertical edges at its ends."""
    inside = [(x, y) for x, y in chain if left < x < right]
    return keep_corners([(left, evaluate(chain, left)), *inside, (right, evaluate(chain, right))])


def clip_to(chain: Sequence[Vertex], other: Sequence[Vertex]) -> list[Vertex]:
    return clip(chain, Fraction(other[0][0]), Fraction(other[-1][0]))


def take_bottom(loop: Iterable[Vertex]) -> list[Vertex]:
    """Return the bottom chain of a canonical loop, without vertical edges at its ends."""
    return keep_corners(split([(x, y) for x, y in loop])[0])


def look_up(pair: SweepPair) -> ReferenceLoops:
    """Return the loops of a pair as computed from the definition, cached."""
    return _reference(tuple(pair.generatrix), tuple(pair.directrix))


def look_up_bottom(pair: SweepPair, loop: str) -> list[Vertex]:
    return take_bottom(getattr(look_up(pair), loop))


@cache
def _reference(generatrix: tuple[Vertex, ...], directrix: tuple[Vertex, ...]) -> ReferenceLoops:
    return reference_loops(list(generatrix), list(directrix))


def compare_loops(s: Sweep, *names: str) -> Iterator[str]:
    expected, (x, y) = _reference(s.generatrix.vertices, s.directrix.vertices), s.reference
    for name in names or expected._fields:
        found = getattr(s, name).translated((-x, -y) if name == "trajectory" else (0, 0))
        if found.vertices != getattr(expected, name):
            loop = name if name == "trajectory" else f"{name} loop"
            yield f"the {loop} differs from the definition"


def describe_difference(
    name: str, found: Iterable[Vertex], expected: Iterable[Vertex], by: str = "by the definition"
) -> str:
    """Describe how two chains differ; return an empty string if they do not."""
    found, expected = keep_corners(found), keep_corners(expected)
    if found == expected:
        return ""
    return f"{name} is {write_chain(found)}, but {write_chain(expected)} {by}"


def compare_boundaries(pair: SweepPair, **loops: Iterable[Vertex]) -> Iterator[str]:
    for name, found in loops.items():
        yield describe_difference(f"the {name} boundary", found, look_up_bottom(pair, name))


def list_sub_chains(pair: SweepPair) -> tuple[list[list[Vertex]], list[list[Vertex]]]:
    """Return the sub-trajectories and the sub-outer chains of a convex G, one per part of D_b."""
    top, bottom, directrix = pair.chains
    parts = find_convex_parts(directrix)
    paths = [trajectory_cc(top, part) for part in parts]
    return paths, [sweep_outer_cc(top, bottom, part) for part in parts]


def lower_undercuts(s: Sweep) -> list[Undercut]:
    return [u for u in s.undercuts if u.bottom[0].x < u.bottom[-1].x]


def no_fit_is_the_definition(pair: SweepPair) -> Iterator[str]:
    """The exterior, holes and exact fits of the no-fit polygon match the definition."""
    yield explain_unproved(no_fit_polygon(*pair[::-1]))


def explain_unproved(answer: Sweep | NoFitPolygon | InnerFit) -> str:
    """Return why the certificate of an answer is not proved, or an empty string."""
    verdict = verify(answer.certificate())
    return "" if verdict.proved else f"not the definition: {verdict.reason}"


def frame_around(shape: Polygon, part: AnyPolygon) -> Region:
    """Build a frame around a polygon at a distance that leaves room for the part."""
    room = sum(high - low for low, high in zip(*part.bounding_box, strict=True)) + 1
    (left, low), (right, high) = shape.bounding_box
    left, low, right, high = left - room, low - room, right + room, high + room
    return Region([(left, low), (right, low), (right, high), (left, high)], [shape])


def show_fits(fits: Iterable[Fit]) -> str:
    return "; ".join(f"({p.x}, {p.y}) to ({q.x}, {q.y})" for p, q in fits) or "none"


def list_edges(corners: Iterable[P]) -> list[tuple[P, P]]:
    first, *others = corners
    return list(pairwise([first, *others, first]))


def write_chain(chain: Iterable[Vertex]) -> str:
    return " ".join(f"({x}, {y})" for x, y in chain)
