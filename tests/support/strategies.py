"""Polygons of every class, valid by construction, many of them degenerate.

All strategies yield a `Polygon` or a pair, without filtering. The seeded families build shapes on a
small integer grid, where features often coincide, and then scale them by 10**-30 to 10**30 and
translate them.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from random import Random
from typing import Any, Literal

import families
from hypothesis import strategies as st

from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import Point, to_fraction

Ring = Sequence[tuple[int, int]]
Kind = Literal["CC", "CM", "MM"]
Matrix = tuple[tuple[int, int], tuple[int, int]]

SCALES = [Fraction(1), Fraction(1), Fraction(7, 3), Fraction(10**30), Fraction(1, 10**30)]


def tiny(low: int = 0, high: int = 4) -> st.SearchStrategy[int]:
    """Draw integers of a tiny grid, with many coincidences."""
    return st.integers(low, high)


def coordinates() -> st.SearchStrategy[Fraction]:
    """Draw small integers and rationals, also around 10**30 and 10**-30."""
    small = st.fractions(-9, 9, max_denominator=12) | tiny().map(Fraction)
    return st.builds(lambda value, scale: value * scale, small, st.sampled_from(SCALES))


def translations() -> st.SearchStrategy[tuple[Fraction, Fraction]]:
    return st.tuples(coordinates(), coordinates())


def points(*pairs: tuple[object, object]) -> tuple[Point, ...]:
    """Return points written as pairs of ints or strings."""
    return tuple(Point(to_fraction(x), to_fraction(y)) for x, y in pairs)


def seeded(*makers: Callable[[Random], Any]) -> st.SearchStrategy[Any]:
    """Make a strategy of functions that take a seeded `Random`."""
    seeds = st.integers(0, 2**32 - 1).map(Random)
    return seeds.map(lambda random: random.choice(makers)(random))


def convex_rings() -> st.SearchStrategy[Ring]:
    """Draw hulls of random points, or of nearly parallel steps."""
    return seeded(families.convex, families.convex, families.fan)


def rectilinear_rings() -> st.SearchStrategy[Ring]:
    """Draw horizontal and vertical edges: slots and teeth that fit exactly, or stairs."""
    return seeded(families.rectilinear)


def monotone_rings() -> st.SearchStrategy[Ring]:
    return seeded(families.jagged, families.walled, families.rectilinear, families.teeth)


@st.composite
def star_rings(draw: st.DrawFn) -> Ring:
    """Draw star-shaped rings, usually not monotone."""
    compass = [(1, 0), (2, 1), (1, 1), (1, 2), (0, 1), (-1, 1), (-2, 1), (-1, 0)]
    compass += [(-2, -1), (-1, -1), (0, -1), (1, -2), (1, -1)]
    # The first, sixth and eleventh points form a triangle around the origin.
    rays = [ray for i, ray in enumerate(compass) if i % 5 == 0 or draw(st.booleans())]
    return [(r * x, r * y) for x, y in rays for r in [draw(tiny(1, 4))]]


@st.composite
def comb_rings(draw: st.DrawFn) -> Ring:
    """Draw equal slanted teeth, upright or on their side."""
    lean = draw(tiny(-3, 3))
    ring = [(0, -1), (draw(tiny(2, 4)) * 4, -1)]
    for x in range(ring[1][0] - 4, -1, -4):
        height = draw(tiny(1, 4))
        tip = x + lean * height
        ring += [(x + 4, 0), (tip + 3, height), (tip + 1, height), (x + 1, 0)]
    return [(y, x) for x, y in ring] if draw(st.booleans()) else ring


@st.composite
def spiral_rings(draw: st.DrawFn) -> Ring:
    """Draw a spiral corridor of width one."""
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
    """Draw weakly X-monotone polygons."""
    return _polygons(monotone_rings())


def simple_polygons() -> st.SearchStrategy[Polygon]:
    return _polygons(simple_rings())


@st.composite
def pairs(draw: st.DrawFn, kind: Kind) -> tuple[Polygon, Polygon]:
    """Generatrix and directrix, both x-monotone.

    Usually on one grid, so that edges are parallel, equal or fit exactly; sometimes one polygon
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


def spellings(polygon: Polygon) -> st.SearchStrategy[families.Ring]:
    """Draw notations: first vertex, orientation, closing, repeated and collinear vertices."""
    return seeded(lambda random: families.respelled(random, [*polygon.vertices]))


def mapped(polygon: Polygon, matrix: Matrix) -> Polygon:
    (a, b), (c, d) = matrix
    return Polygon([(a * x + b * y, c * x + d * y) for x, y in polygon.vertices])


@st.composite
def matrices(draw: st.DrawFn) -> Matrix:
    """Draw regular integer matrices, half of them orientation-reversing."""
    a, b = draw(st.sampled_from([(1, 0), (0, 1), (-1, 0), (1, 1), (2, -1), (3, 4), (10**6, 7)]))
    along, across = draw(tiny(-2, 2)), draw(st.sampled_from([1, -1, 2]))
    return (a, b), (along * a - across * b, along * b + across * a)


@st.composite
def turned_pairs(draw: st.DrawFn, kind: Kind) -> tuple[Polygon, Polygon, tuple[int, int]]:
    """Draw a pair with a shared direction of monotonicity, usually not the x-axis."""
    generatrix, directrix = draw(pairs(kind))
    matrix = draw(matrices())
    (_, b), (_, d) = matrix
    # (d, -b) times the matrix is the determinant times (1, 0): the old x-axis.
    return mapped(generatrix, matrix), mapped(directrix, matrix), (d, -b)
