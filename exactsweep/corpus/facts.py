"""Flags that can be seen from a pair and its answer, so that nobody has to be believed for them."""

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from math import lcm

from exactsweep.check import classify
from exactsweep.corpus.representable import INTEGER_BITS, in_range, types_holding
from exactsweep.geometry.point import Point
from exactsweep.geometry.polygon import Polygon
from exactsweep.sweep import Sweep

Ring = Sequence[Point]
Vector = tuple[int, int]

NEAR = Fraction(1, 10**14)
HUGE = Fraction(2**53)
TINY = Fraction(1, 2**30)


def facts(directrix: Ring, generatrix: Ring, s: Sweep) -> set[str]:
    """Find the flags of a pair that can be seen.

    Args:
        directrix: D as given, not closed.
        generatrix: G as given, not closed.
        s: the sweep of the two.

    Returns:
        Names of flags; `exactsweep.corpus.notes` says what each means.

    Cost: O((m + n) log(m + n)) besides the sweep and `classify`.

    Example:
        >>> from exactsweep import sweep
        >>> square = [Point(Fraction(x), Fraction(y)) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        >>> sorted(facts(square, square, sweep(square, square)))
        ['identical', 'inverse', 'parallel-edges', 'vertical-edge']
    """
    return {
        *(name for name, holds in _SPELLING.items() if holds(directrix) or holds(generatrix)),
        *(name for name, holds in _ANSWER.items() if holds(s)),
        *_sizes(directrix, generatrix, s),
        *_slopes(s),
    }


def is_clockwise(ring: Ring) -> bool:
    """Whether a ring runs clockwise."""
    return sum(p.x * q.y - q.x * p.y for p, q in _edges(ring)) < 0


def _repeated(ring: Ring) -> bool:
    return any(p == q for p, q in _edges(ring))


def _collinear(ring: Ring) -> bool:
    distinct = [p for p, q in _edges(ring) if p != q]
    return len(Polygon(ring)) < len(distinct)


_SPELLING: dict[str, Callable[[Ring], bool]] = {
    "clockwise": is_clockwise,
    "repeated-vertex": _repeated,
    "collinear-vertex": _collinear,
}


def _identical(s: Sweep) -> bool:
    return _at_origin(s.generatrix) == _at_origin(s.directrix)


def _inverse(s: Sweep) -> bool:
    return _at_origin(s.generatrix.reflected()) == _at_origin(s.directrix)


def _at_origin(polygon: Polygon) -> Polygon:
    x, y = polygon.vertices[0]
    return polygon.translated((-x, -y))


def _touching(s: Sweep) -> bool:
    return classify(s.directrix, s.generatrix, (0, 0)).verdict == "CONTACT"


_ANSWER: dict[str, Callable[[Sweep], bool]] = {
    "identical": _identical,
    "inverse": _inverse,
    "touching": _touching,
    "reference-point": lambda s: any(s.reference),
    "turned": lambda s: s.direction != (1, 0),
    "exact-fit": lambda s: bool(s.exact_fits),
    "undercut": lambda s: s.inner != s.directrix,
}


def _sizes(directrix: Ring, generatrix: Ring, s: Sweep) -> Iterator[str]:
    given = [c for ring in (directrix, generatrix, [s.reference]) for point in ring for c in point]
    scale = lcm(*(c.denominator for c in given))
    answer = [c * scale for c in _answer(s)]
    given = [c * scale for c in given]
    if scale > 1:
        yield "fractional-input"
    if any(c.denominator > 1 for c in answer):
        yield "rounded-answer"
    for name, bits in INTEGER_BITS.items():
        if all(in_range(c, bits) for c in given):
            if not all(in_range(c, bits) for c in answer):
                yield f"overflow-{name}"
            if not in_range(_greatest_product(s, scale), bits):
                yield f"product-overflow-{name}"
    if "binary64" in types_holding([c / scale for c in given], 1) and _rounds_products(s):
        yield "product-rounding"
    if max(map(abs, given)) > HUGE * scale:
        yield "huge"
    if min(abs(c) for p, q in _all_edges(s) for c in (q.x - p.x, q.y - p.y) if c) < TINY:
        yield "tiny"


def _answer(s: Sweep) -> Iterator[Fraction]:
    points = [*s.trajectory.vertices, *s.inner.vertices, *s.outer.vertices]
    for point in [*points, *(end for fit in s.exact_fits for end in fit)]:
        yield from point


def _greatest_product(s: Sweep, scale: int) -> Fraction:
    """The greatest cross product of the sides of the boxes around D and G, on the lattice."""
    boxes = [polygon.bounding_box for polygon in (s.directrix, s.generatrix)]
    width, height = (max(high[axis] - low[axis] for low, high in boxes) * scale for axis in (0, 1))
    return 2 * width * height


def _rounds_products(s: Sweep) -> bool:
    for polygon in s.directrix, s.generatrix:
        widths, heights = ([q[i] - p[i] for p, q in _edges(polygon.vertices)] for i in (0, 1))
        next_widths, next_heights = widths[1:] + widths[:1], heights[1:] + heights[:1]
        for first, second in (widths, next_heights), (heights, next_widths):
            products = [a * b for a, b in zip(first, second, strict=True)]
            if "binary64" not in types_holding(products, 1):
                return True
    return False


def _slopes(s: Sweep) -> Iterator[str]:
    d, g = (_directions(polygon) for polygon in (s.directrix, s.generatrix))
    if any(x == 0 for x, _ in d | g):
        yield "vertical-edge"
    if d & g:
        yield "parallel-edges"
    ordered = sorted(d | g, key=_slope)
    if any(_near(u, v) for u, v in zip(ordered, [*ordered[1:], ordered[0]], strict=True)):
        yield "near-parallel"


def _directions(polygon: Polygon) -> set[Vector]:
    """The primitive vectors along the edges, in the right half plane."""
    found = set()
    for p, q in _edges(polygon.vertices):
        dx, dy = q.x - p.x, q.y - p.y
        slope = Fraction(dy, dx) if dx else None
        found.add((0, 1) if slope is None else (slope.denominator, slope.numerator))
    return found


def _slope(vector: Vector) -> tuple[int, Fraction]:
    x, y = vector
    return (1, Fraction(0)) if x == 0 else (0, Fraction(y, x))


def _near(u: Vector, v: Vector) -> bool:
    """Whether two directions differ by less than one part in 10**14, and do differ."""
    cross = u[0] * v[1] - u[1] * v[0]
    return 0 < cross * cross < NEAR**2 * (u[0] ** 2 + u[1] ** 2) * (v[0] ** 2 + v[1] ** 2)


def _all_edges(s: Sweep) -> Iterator[tuple[Point, Point]]:
    yield from _edges(s.directrix.vertices)
    yield from _edges(s.generatrix.vertices)


def _edges(ring: Ring) -> Iterator[tuple[Point, Point]]:
    yield from zip(ring, [*ring[1:], ring[0]], strict=True)
