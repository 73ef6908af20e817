"""Flags that are computed from a pair and its answer, so that a test can check them."""

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, pairwise
from math import lcm

from exactsweep.check import classify
from exactsweep.corpus.representable import INTEGER_BITS, find_types, is_in_range
from exactsweep.geometry.direction import Vector
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import AnyPolygon
from exactsweep.numbers.point import Fit, Point, PointRings
from exactsweep.sweep import InnerFit, Sweep

NEAR = Fraction(1, 10**14)
HUGE = Fraction(2**53)
TINY = Fraction(1, 2**30)
MANY = 256


def find_facts(
    directrix: PointRings, generatrix: PointRings, s: Sweep, inside: InnerFit | None = None
) -> set[str]:
    """Find the flags of a pair that can be seen.

    Args:
        directrix: the exterior and the holes of D as given, not closed.
        generatrix: those of G.
        s: the sweep of the two.
        inside: the positions of G inside D, where they are asked for.

    Returns:
        Names of flags; `exactsweep.corpus.notes` says what each means.

    Cost: O((m + n) log(m + n)) besides the sweep and `classify`.

    Example:
        >>> from exactsweep import sweep
        >>> square = [Point(Fraction(x), Fraction(y)) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        >>> sorted(find_facts([square], [square], sweep(square, square)))
        ['identical', 'inverse', 'parallel-edges', 'vertical-edge']
    """
    return {
        *(name for name, holds in _SPELLING.items() if holds(directrix) or holds(generatrix)),
        *(name for name, holds in _ANSWER.items() if holds(s)),
        *(name for name, holds in _INSIDE.items() if inside is not None and holds(inside)),
        *_sizes(directrix, generatrix, s, inside),
        *_slopes(s),
    }


def is_clockwise(ring: Sequence[Point]) -> bool:
    """Decide whether a ring runs clockwise."""
    return sum(p.x * q.y - q.x * p.y for p, q in _edges(ring)) < 0


def _repeats(rings: PointRings) -> bool:
    return any(p == q for ring in rings for p, q in _edges(ring))


def _collinear(rings: PointRings) -> bool:
    return any(len(Polygon(ring)) < sum(p != q for p, q in _edges(ring)) for ring in rings)


_SPELLING: dict[str, Callable[[PointRings], bool]] = {
    "clockwise": lambda rings: is_clockwise(rings[0]),
    "repeated-vertex": _repeats,
    "collinear-vertex": _collinear,
    "hole": lambda rings: len(rings) > 1,
}


def _identical(s: Sweep) -> bool:
    return _at_origin(s.generatrix) == _at_origin(s.directrix)


def _inverse(s: Sweep) -> bool:
    return _at_origin(s.generatrix.reflected()) == _at_origin(s.directrix)


def _at_origin(shape: AnyPolygon) -> AnyPolygon:
    x, y = shape.vertices[0]
    return shape.translated((-x, -y))


def _is_point(fit: Fit) -> bool:
    return fit[0] == fit[1]


def _is_long(s: Sweep) -> bool:
    loops = (polygon.vertices for polygon in (s.trajectory, s.inner, s.outer))
    return any(len(ring) > MANY for ring in (*loops, *s.directrix.rings, *s.generatrix.rings))


def _touch(s: Sweep) -> bool:
    return classify(s.directrix, s.generatrix, (0, 0)).verdict == "CONTACT"


_ANSWER: dict[str, Callable[[Sweep], bool]] = {
    "identical": _identical,
    "inverse": _inverse,
    "touching": _touch,
    "reference-point": lambda s: any(s.reference),
    "turned": lambda s: s.kind != "SS" and s.direction != (1, 0),
    "exact-fit": lambda s: bool(s.exact_fits),
    "single-position": lambda s: any(map(_is_point, s.exact_fits)),
    "undercut": lambda s: s.inner.vertices != s.directrix.rings[0],
    "no-fit-hole": lambda s: bool(s.no_fit_holes),
    "unswept": lambda s: bool(s.unswept),
    "many-vertices": _is_long,
}

_INSIDE: dict[str, Callable[[InnerFit], bool]] = {
    "room-inside": lambda inside: bool(inside.regions),
    "several-rooms": lambda inside: len(inside.regions) > 1,
    "exact-fit-inside": lambda inside: bool(inside.exact_fits),
    "does-not-fit": lambda inside: not inside.regions and not inside.exact_fits,
}


def _sizes(
    directrix: PointRings, generatrix: PointRings, s: Sweep, inside: InnerFit | None
) -> Iterator[str]:
    rings = [*directrix, *generatrix, [s.reference]]
    given = [c for ring in rings for point in ring for c in point]
    scale = lcm(*(c.denominator for c in given))
    answer = [c * scale for c in _answer(s, inside)]
    given = [c * scale for c in given]
    if scale > 1:
        yield "fractional-input"
    if any(c.denominator > 1 for c in answer):
        yield "rounded-answer"
    for name, bits in INTEGER_BITS.items():
        if all(is_in_range(c, bits) for c in given):
            if not all(is_in_range(c, bits) for c in answer):
                yield f"overflow-{name}"
            if not is_in_range(_greatest_product(s, scale), bits):
                yield f"product-overflow-{name}"
    if "binary64" in find_types([c / scale for c in given], 1) and _rounds_products(s):
        yield "product-rounding"
    if max(map(abs, given)) > HUGE * scale:
        yield "huge"
    if min(abs(c) for p, q in _all_edges(s) for c in (q.x - p.x, q.y - p.y) if c) < TINY:
        yield "tiny"


def _answer(s: Sweep, inside: InnerFit | None) -> Iterator[Fraction]:
    shapes = [s.trajectory, s.inner, s.outer, *s.no_fit_holes, *s.unswept]
    rings = [shape.vertices for shape in shapes]
    fits = [*s.exact_fits]
    if inside is not None:
        rings += [region.vertices for region in inside.regions]
        fits += inside.exact_fits
    for points in (*rings, *fits):
        for point in points:
            yield from point


def _greatest_product(s: Sweep, scale: int) -> Fraction:
    """The greatest cross product of the sides of the boxes around D and G, on the lattice."""
    boxes = [polygon.bounding_box for polygon in (s.directrix, s.generatrix)]
    width, height = (max(high[axis] - low[axis] for low, high in boxes) * scale for axis in (0, 1))
    return 2 * width * height


def _rounds_products(s: Sweep) -> bool:
    for ring in (*s.directrix.rings, *s.generatrix.rings):
        widths, heights = ([q[i] - p[i] for p, q in _edges(ring)] for i in (0, 1))
        next_widths, next_heights = widths[1:] + widths[:1], heights[1:] + heights[:1]
        for first, second in (widths, next_heights), (heights, next_widths):
            products = [a * b for a, b in zip(first, second, strict=True)]
            if "binary64" not in find_types(products, 1):
                return True
    return False


def _slopes(s: Sweep) -> Iterator[str]:
    d, g = (_directions(shape.rings) for shape in (s.directrix, s.generatrix))
    if any(x == 0 for x, _ in d | g):
        yield "vertical-edge"
    if d & g:
        yield "parallel-edges"
    ordered = sorted(d | g, key=_slope)
    if any(_near(u, v) for u, v in pairwise((*ordered, ordered[0]))):
        yield "near-parallel"


def _directions(rings: PointRings) -> set[Vector]:
    """The primitive vectors along the edges, in the right half plane."""
    found = set()
    for p, q in chain.from_iterable(map(_edges, rings)):
        dx, dy = q.x - p.x, q.y - p.y
        slope = Fraction(dy, dx) if dx else None
        found.add((0, 1) if slope is None else (slope.denominator, slope.numerator))
    return found


def _slope(vector: Vector) -> tuple[int, Fraction]:
    x, y = vector
    return (1, Fraction(0)) if x == 0 else (0, Fraction(y, x))


def _near(u: Vector, v: Vector) -> bool:
    """Decide whether two directions differ by less than one part in 10**14, and do differ."""
    cross = u[0] * v[1] - u[1] * v[0]
    return 0 < cross * cross < NEAR**2 * (u[0] ** 2 + u[1] ** 2) * (v[0] ** 2 + v[1] ** 2)


def _all_edges(s: Sweep) -> Iterator[tuple[Point, Point]]:
    return chain.from_iterable(map(_edges, (*s.directrix.rings, *s.generatrix.rings)))


def _edges(ring: Sequence[Point]) -> Iterator[tuple[Point, Point]]:
    return pairwise((*ring, ring[0]))
