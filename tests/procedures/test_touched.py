"""What G touches of D_b: the inner loop is D itself there."""

from fractions import Fraction
from itertools import pairwise

import strategies as own
from hypothesis import given
from tiers import examples

from exactsweep import Polygon
from exactsweep.check import reference_loops
from exactsweep.numbers.point import Vertex
from exactsweep.procedures.chain import find_convex_parts, list_graph_edges, split
from exactsweep.procedures.envelope import value
from exactsweep.procedures.mm import trajectory_mm
from exactsweep.procedures.mm_inner import find_gaps


def height(chain: list[Vertex], x: Fraction) -> Fraction:
    """Of a chain at an x at which it has no wall."""
    (px, py), (qx, qy) = next((p, q) for p, q in list_graph_edges(chain) if p[0] <= x <= q[0])
    return py + Fraction(x - px) * (qy - py) / (qx - px)


@given(own.pairs("MM"))
@examples(100)
def test_outside_the_gaps_the_inner_loop_is_the_directrix(pair: tuple[Polygon, Polygon]) -> None:
    (_, g_top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    inner, _ = split(reference_loops(*pair, (1, 0)).inner)
    found = find_gaps(trajectory_mm(g_top, bottom), find_convex_parts(bottom))
    ends = [value(end) for gap in found for end in gap]
    # Between gaps and walls, both functions are continuous: midpoints of what is left will do.
    xs = sorted({*ends, *(Fraction(x) for x, _ in bottom), *(Fraction(x) for x, _ in inner)})
    untouched = list(zip(ends[::2], ends[1::2], strict=True))
    for x in ((a + b) / 2 for a, b in pairwise(xs)):
        if not any(left < x < right for left, right in untouched):
            assert height(inner, x) == height(bottom, x)


def test_a_notch_too_narrow_leaves_one_gap() -> None:
    # A flat top of width 1 under a notch 2 wide: its ends stop where the notch is 1 wide.
    notch = [(0, 0), (2, 0), (3, 2), (4, 0), (6, 0)]
    found = find_gaps(trajectory_mm([(1, 0), (0, 0)], notch), find_convex_parts(notch))
    assert [(value(a), value(b)) for a, b in found] == [(Fraction(5, 2), Fraction(7, 2))]


def test_a_lone_vertex_divides_two_gaps() -> None:
    # The flat top of G, 4 wide, rests on the three teeth; between them it reaches nothing.
    comb = [(0, 0), (1, 3), (2, 0), (3, 3), (4, 0)]
    found = find_gaps(trajectory_mm([(4, 0), (0, 0)], comb), find_convex_parts(comb))
    assert [(value(a), value(b)) for a, b in found] == [
        (Fraction(0), Fraction(2)),
        (Fraction(2), Fraction(4)),
    ]
