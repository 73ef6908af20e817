"""Walks around cells: loops that meet in points are cut there, once each."""

from collections import defaultdict

from exactsweep.check.arrangement import _walk_loops
from hypothesis import example, given
from hypothesis import strategies as st

from exactsweep.check.cone import subtract
from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.numbers.number import Vertex

Cells = frozenset[Vertex]
cells = st.frozensets(st.tuples(st.integers(0, 4), st.integers(0, 4)), min_size=1)


def cells_of(*rows: str) -> Cells:
    return frozenset((x, -y) for y, row in enumerate(rows) for x, c in enumerate(row) if c == "#")


def surround(free: Cells) -> set[tuple[Vertex, Vertex]]:
    """The sides of unit squares, free ones on the left, without those between two of them."""
    found = set()
    for x, y in free:
        corners = (x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)
        found |= {*zip(corners, (*corners[1:], corners[0]), strict=True)}
    return {(p, q) for p, q in found if (q, p) not in found}


@example(cells_of("####", "#  #", "# ##", "## #", " ###"))
@example(cells_of("# # #", " # # ", "# # #", " # # ", "# # #"))
@given(cells)
def test_walked_loops_are_simple_and_bound_what_is_free(free: Cells) -> None:
    sides, ahead = surround(free), defaultdict(list)
    for p, q in sorted(sides):
        ahead[p].append(q)
    loops = _walk_loops(ahead)
    assert sum(find_doubled_area(loop.points) for loop in loops) == 2 * len(free)
    walked: list[Vertex] = []
    for points, _ in loops:
        around: list[Vertex] = []
        for p, q in zip(points, points[1:] + points[:1], strict=True):
            dx, dy = subtract(q, p)
            steps = int(max(dx, -dx, dy, -dy))
            around += [(p[0] + dx * k // steps, p[1] + dy * k // steps) for k in range(steps)]
        assert len({*around}) == len(around)
        walked += around
    assert sorted(walked) == sorted(p for p, _ in sides)
