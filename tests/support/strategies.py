"""Polygons by construction: every class, and degenerate on purpose.

Everything here yields a `Polygon`, or a pair of them; nothing is filtered. Shapes are built on a
small integer grid, where features meet often, and then placed: scaled, from 10**-30 to 10**30, and
moved.
"""

from collections.abc import Sequence
from fractions import Fraction
from typing import Literal

from hypothesis import strategies as st

from exactsweep.geometry.hull import find_hull
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import to_fraction
from exactsweep.numbers.point import Point

Ring = Sequence[tuple[int, int]]
Kind = Literal["CC", "CM", "MM"]
Matrix = tuple[tuple[int, int], tuple[int, int]]

SCALES = [Fraction(1), Fraction(1), Fraction(7, 3), Fraction(10**30), Fraction(1, 10**30)]


def tiny(low: int = 0, high: int = 4) -> st.SearchStrategy[int]:
    """Integers of a grid so small that coincidences are the rule."""
    return st.integers(low, high)


def coordinates() -> st.SearchStrategy[Fraction]:
    """Small integers, small rationals, and both around 10**30 and 10**-30."""
    small = st.fractions(-9, 9, max_denominator=12) | tiny().map(Fraction)
    return st.builds(lambda value, scale: value * scale, small, st.sampled_from(SCALES))


def translations() -> st.SearchStrategy[tuple[Fraction, Fraction]]:
    return st.tuples(coordinates(), coordinates())


def points(*pairs: tuple[object, object]) -> tuple[Point, ...]:
    """Points written as pairs of ints or strings."""
    return tuple(Point(to_fraction(x), to_fraction(y)) for x, y in pairs)


@st.composite
def convex_rings(draw: st.DrawFn) -> Ring:
    """Hulls of random points, or of a line of nearly parallel steps; never flat."""
    if draw(st.booleans()):
        side = draw(st.sampled_from([2, 4, 12]))
        grid = st.tuples(tiny(0, side), tiny(0, side))
        points = draw(st.lists(grid, min_size=1, max_size=12))
    else:
        k = draw(st.sampled_from([3, 1000, 10**9]))
        steps = [(k, 1), (k + 1, 1), (k, -1), (k - 1, 1), (1, k), (k, k - 1), (k + 1, k)]
        x = y = 0
        points = [(0, 0)]
        for dx, dy in draw(st.lists(st.sampled_from(steps), min_size=1, max_size=6)):
            x, y = x + dx, y + dy
            points.append((x, y))
    found = find_hull(points)
    if len(found) < 3:
        x, y = points[0]
        found = find_hull([*points, (x + 1, y), (x, y + 1)])
    return found


@st.composite
def strict_rings(draw: st.DrawFn) -> Ring:
    """No vertical edge: both chains start and end in common points."""
    if draw(st.booleans()):
        # Breakpoints of their own, on either side of the line y = slope * x.
        last = draw(tiny(2, 8))
        slope = draw(tiny(-2, 2))
        inside = st.sets(tiny(1, last - 1), min_size=1, max_size=5)
        bottom = [(x, draw(tiny(-5, -1))) for x in sorted(draw(inside))]
        top = [(x, draw(tiny(1, 5))) for x in sorted(draw(inside))]
        straight = [(0, 0), *bottom, (last, 0), *reversed(top)]
        return [(x, y + slope * x) for x, y in straight]
    xs = draw(_abscissas(3))
    bottom = [(x, draw(tiny(0, 5))) for x in xs]
    top = [(x, y + draw(tiny(1, 4))) for x, y in bottom[1:-1]]
    return [*bottom, *reversed(top)]


@st.composite
def weak_rings(draw: st.DrawFn) -> Ring:
    """Vertical edges inside both chains and at the ends."""
    xs = draw(_abscissas(2))
    left, right = draw(tiny()), draw(tiny())
    bottom, top = [(xs[0], left)], [(xs[0], left + draw(tiny(1, 3)))]
    for x in xs[1:-1]:
        before, after = draw(tiny()), draw(tiny())
        bottom += [(x, before), (x, after)]
        floor = max(before, after) + 1
        top += [(x, floor + draw(tiny(0, 3))), (x, floor + draw(tiny(0, 3)))]
    bottom.append((xs[-1], right))
    top.append((xs[-1], right + draw(tiny(0, 3))))
    return [*bottom, *reversed(top)]


@st.composite
def rectilinear_rings(draw: st.DrawFn) -> Ring:
    """Horizontal and vertical edges only: slots and teeth that fit exactly, or stairs."""
    xs = draw(_abscissas(2))
    cells = len(xs) - 1
    if draw(st.booleans()):
        floors = [draw(tiny(0, 2)) for _ in range(cells)]
        ceilings = [draw(tiny(3, 5)) for _ in range(cells)]
    else:
        height = draw(tiny(2, 4))
        floors = [0]
        for _ in range(cells - 1):
            floors.append(floors[-1] + draw(tiny(0, 1)))
        ceilings = [floor + height for floor in floors]
    bottom, top = (
        [(x, y) for i, y in enumerate(ys) for x in xs[i : i + 2]] for ys in (floors, ceilings)
    )
    return [*bottom, *reversed(top)]


def monotone_rings() -> st.SearchStrategy[Ring]:
    return strict_rings() | weak_rings() | rectilinear_rings()


@st.composite
def star_rings(draw: st.DrawFn) -> Ring:
    """Seen whole from the origin; as a rule not monotone."""
    compass = [(1, 0), (2, 1), (1, 1), (1, 2), (0, 1), (-1, 1), (-2, 1), (-1, 0)]
    compass += [(-2, -1), (-1, -1), (0, -1), (1, -2), (1, -1)]
    # The first, sixth and eleventh see the origin inside their triangle.
    rays = [ray for i, ray in enumerate(compass) if i % 5 == 0 or draw(st.booleans())]
    return [(r * x, r * y) for x, y in rays for r in [draw(tiny(1, 4))]]


@st.composite
def comb_rings(draw: st.DrawFn) -> Ring:
    """Teeth that lean over, all alike, standing up or lying on their side."""
    lean = draw(tiny(-3, 3))
    ring = [(0, -1), (draw(tiny(2, 4)) * 4, -1)]
    for x in range(ring[1][0] - 4, -1, -4):
        height = draw(tiny(1, 4))
        tip = x + lean * height
        ring += [(x + 4, 0), (tip + 3, height), (tip + 1, height), (x + 1, 0)]
    return [(y, x) for x, y in ring] if draw(st.booleans()) else ring


@st.composite
def spiral_rings(draw: st.DrawFn) -> Ring:
    """A corridor of width one that winds inwards."""
    turns = draw(tiny(2, 9))
    outer, inner = [], []
    for i in range(turns + 1):
        reach = 2 * (turns + 2 - i)
        sx, sy = [(-1, -1), (1, -1), (1, 1), (-1, 1)][i % 4]
        outer.append((sx * reach, sy * reach))
        inner.append((sx * (reach - 1), sy * (reach - 1)))
    return [*outer, *reversed(inner)]


def simple_rings() -> st.SearchStrategy[Ring]:
    turned = monotone_rings().map(lambda ring: [(x - y, 2 * x + y) for x, y in ring])
    return convex_rings() | monotone_rings() | turned | star_rings() | comb_rings() | spiral_rings()


def placed(ring: Ring, scale: Fraction, shift: tuple[Fraction, Fraction]) -> Polygon:
    return Polygon([(x * scale + shift[0], y * scale + shift[1]) for x, y in ring])


def _polygons(rings: st.SearchStrategy[Ring]) -> st.SearchStrategy[Polygon]:
    return st.builds(placed, rings, st.sampled_from(SCALES), translations())


def convex_polygons() -> st.SearchStrategy[Polygon]:
    return _polygons(convex_rings())


def monotone_polygons() -> st.SearchStrategy[Polygon]:
    """Weakly x-monotone."""
    return _polygons(monotone_rings())


def simple_polygons() -> st.SearchStrategy[Polygon]:
    return _polygons(simple_rings())


@st.composite
def pairs(draw: st.DrawFn, kind: Kind) -> tuple[Polygon, Polygon]:
    """Generatrix and directrix, both x-monotone.

    On one grid as a rule, so that edges are parallel, equal or fit exactly; sometimes one polygon
    twice, or one that is far larger than the other. In "CM" the generatrix is the convex one.
    """
    first, second = (
        convex_rings() if letter == "C" else monotone_rings() | rectilinear_rings()
        for letter in kind
    )
    scale = draw(st.sampled_from(SCALES))
    ratio = draw(
        st.sampled_from([Fraction(1)] * 4 + [Fraction(1, 2), Fraction(5), Fraction(10**9)])
    )
    generatrix = placed(draw(first), scale * ratio, draw(_grid_shifts(scale)))
    if kind != "CM" and draw(st.integers(0, 7)) == 0:
        return generatrix, draw(st.sampled_from([generatrix, generatrix.reflected()]))
    return generatrix, placed(draw(second), scale, draw(_grid_shifts(scale)))


def _grid_shifts(scale: Fraction) -> st.SearchStrategy[tuple[Fraction, Fraction]]:
    return st.tuples(*[tiny(-3, 3).map(lambda n: n * scale)] * 2)


@st.composite
def _abscissas(draw: st.DrawFn, least: int) -> list[int]:
    """Increasing, with small equal steps more often than not."""
    xs = [0]
    for width in draw(st.lists(tiny(1, 2), min_size=least - 1, max_size=7)):
        xs.append(xs[-1] + width)
    return xs


@st.composite
def spellings(draw: st.DrawFn, polygon: Polygon) -> list[tuple[Fraction, Fraction]]:
    """The same polygon in other words: turned, reversed, closed, repeated, collinear vertices."""
    corners = polygon.vertices
    first = draw(st.integers(0, len(corners) - 1))
    corners = corners[first:] + corners[:first]
    spelled: list[tuple[Fraction, Fraction]] = []
    for (ax, ay), (bx, by) in zip(corners, (*corners[1:], corners[0]), strict=True):
        spelled += [(ax, ay)] * draw(tiny(1, 2))
        for share in sorted(
            draw(st.lists(st.sampled_from([Fraction(1, 3), Fraction(1, 2)]), max_size=2))
        ):
            spelled.append((ax + share * (bx - ax), ay + share * (by - ay)))
    if draw(st.booleans()):
        spelled.append(spelled[0])
    return spelled[::-1] if draw(st.booleans()) else spelled


def mapped(polygon: Polygon, matrix: Matrix) -> Polygon:
    (a, b), (c, d) = matrix
    return Polygon([(a * x + b * y, c * x + d * y) for x, y in polygon.vertices])


@st.composite
def matrices(draw: st.DrawFn) -> Matrix:
    """Invertible, of integers; turning over as often as not."""
    a, b = draw(st.sampled_from([(1, 0), (0, 1), (-1, 0), (1, 1), (2, -1), (3, 4), (10**6, 7)]))
    along, across = draw(tiny(-2, 2)), draw(st.sampled_from([1, -1, 2]))
    return (a, b), (along * a - across * b, along * b + across * a)


@st.composite
def turned_pairs(draw: st.DrawFn, kind: Kind) -> tuple[Polygon, Polygon, tuple[int, int]]:
    """A pair and a direction to which both are monotone, as a rule not the x-axis."""
    generatrix, directrix = draw(pairs(kind))
    matrix = draw(matrices())
    (_, b), (_, d) = matrix
    # (d, -b) times the matrix is the determinant times (1, 0): the old x-axis.
    return mapped(generatrix, matrix), mapped(directrix, matrix), (d, -b)
