"""A point deep inside two polygonal solids, by chords of their intersection.

(1) The straight homotopy from the boundary of a solid to the true boundary moves no point farther
    than the slack. So a point inside the solid and farther than the slack from its boundary is
    inside the true solid.
(2) Between two consecutive heights of vertices of the intersection, a horizontal line meets each
    component of its interior there, and passes through no vertex.
(3) A line through a point deeper than the slack of both solids runs inside both of them for more
    than twice the lesser slack. So no shorter chord has such a point.
"""

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from heapq import nlargest
from itertools import pairwise

from exactsweep.geometry.distance import measure_to_edge
from exactsweep.geometry.intersection import find_common_boundary
from exactsweep.geometry.near import BoxRows, bound_points
from exactsweep.layout.solid import LatticeForm, Solid
from exactsweep.numbers.number import Edge, Point, Rational, Vertex

# Maximum number of chords to test, longest first, and of centering moves per chord.
_MAX_CHORDS, _MAX_MOVES = 32, 2
_ChordEnds = tuple[Rational, Rational]
_HorizontalChord = tuple[Rational, Rational, Rational]


def find_deep_point(a: Solid, b: Solid) -> Point | None:
    """Find a point inside both true polygonal solids of one lattice by (1); None if none is found.

    If the solids overlap and are exact, such a point exists. At most 32 chords are tested.
    """
    boundary = find_common_boundary(_list_rings(a), _list_rings(b))
    least = 2 * min(a.slack, b.slack) * a.scale
    lines = (line for line in _list_lines(boundary) if line[1] - line[0] > least)
    for left, right, y in nlargest(_MAX_CHORDS, lines, key=lambda line: line[1] - line[0]):
        point: Vertex = (_halve(left, right), y)
        for k in range(_MAX_MOVES + 1):
            if _is_deep(point, a) and _is_deep(point, b):
                return a.to_point(*point)
            # The midpoint may be close to an end of the perpendicular chord: center it there, too.
            axis = 1 - k % 2
            middle = _halve(*_find_chord(boundary, point, axis))
            point = (point[0], middle) if axis else (middle, point[1])
    return None


def _list_rings(solid: Solid) -> list[list[Vertex]]:
    assert isinstance(solid.form, LatticeForm)
    x, y = solid.x, solid.y
    return [[(px + x, py + y) for px, py in ring] for ring in solid.form.rings]


def _list_lines(boundary: Sequence[Edge]) -> Iterator[_HorizontalChord]:
    boxes = [*map(bound_points, boundary)]
    rows, right = BoxRows(boxes), max((box[1] for box in boxes), default=0)
    left = min((box[0] for box in boxes), default=0)
    for low, high in pairwise(sorted({y for edge in boundary for _, y in edge})):
        y = _halve(low, high)
        crossed = (boundary[k] for k in rows.find((left, right, y, y)))
        # The left end, the right end and the height of each chord.
        yield from ((*chord, y) for chord in _list_chords(crossed, y, 0))


def _find_chord(boundary: Sequence[Edge], point: Vertex, axis: int) -> _ChordEnds:
    at = point[axis]
    chords = _list_chords(boundary, point[1 - axis], axis)
    return next((low, high) for low, high in chords if low < at < high)


def _list_chords(edges: Iterable[Edge], line: Rational, axis: int) -> Iterator[_ChordEnds]:
    across, found = 1 - axis, list[Rational]()
    for p, q in edges:
        u, v = p[across], q[across]
        if u <= line < v or v <= line < u:
            found.append(p[axis] + Fraction(line - u) * (q[axis] - p[axis]) / (v - u))
    found.sort()
    return zip(found[::2], found[1::2], strict=True)


def _halve(low: Rational, high: Rational) -> Rational:
    """Return a number between two others: an int near the midpoint, or else the midpoint."""
    middle = (low + high) // 2
    return middle if low < middle else Fraction(low + high) / 2


def _is_deep(point: Vertex, solid: Solid) -> bool:
    """Return whether an interior point is farther from the boundary than the slack."""
    if not solid.slack:
        return True
    assert isinstance(solid.form, LatticeForm)
    slack = solid.slack * solid.scale
    x, y = point[0] - solid.x, point[1] - solid.y
    near = solid.form.near((x - slack, x + slack, y - slack, y + slack))
    sides = (measure_to_edge((x, y), (e[4], e[5])) for e in near)
    return all(square > slack * slack * length for square, length in sides)
