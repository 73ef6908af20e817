"""Flags computed from a pair and its answer."""

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, pairwise

from exactsweep.check import classify
from exactsweep.corpus.answered import INTEGER_BITS, AnsweredPair, find_types, is_in_range
from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.direction import Vector
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import AnyPolygon
from exactsweep.geometry.vectors import angle_key, cross
from exactsweep.numbers.number import Point, PointRings

NEAR = Fraction(1, 10**14)
HUGE = Fraction(2**53)
TINY = Fraction(1, 2**30)
MANY = 256


def find_flags(case: AnsweredPair) -> set[str]:
    """Compute the flags of a pair, which `exactsweep.corpus.notes` explains.

    >>> from exactsweep.corpus import Case
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> case = Case.of("mine-1", "a square around itself", square, square)
    >>> sorted(find_flags(case))
    ['identical', 'inverse', 'parallel-edges', 'vertical-edge']
    """
    given = case.directrix_rings, case.generatrix_rings
    return {
        *(name for name, holds in _SPELLING.items() if any(map(holds, given))),
        *(name for name, holds in _ANSWER.items() if holds(case)),
        *_sizes(case),
        *_slopes(case),
    }


def _collinear(rings: PointRings) -> bool:
    return any(len(Polygon(ring)) < sum(p != q for p, q in _edges(ring)) for ring in rings)


_SPELLING: dict[str, Callable[[PointRings], bool]] = {
    "clockwise": lambda rings: find_doubled_area(rings[0]) < 0,
    "repeated-vertex": lambda rings: any(p == q for ring in rings for p, q in _edges(ring)),
    "collinear-vertex": _collinear,
    "hole": lambda rings: len(rings) > 1,
}


def _at_origin(shape: AnyPolygon) -> AnyPolygon:
    x, y = shape.vertices[0]
    return shape.translated((-x, -y))


def _list_rings(case: AnsweredPair) -> PointRings:
    return (*case.directrix.rings, *case.generatrix.rings)


def _is_long(case: AnsweredPair) -> bool:
    loops = (case.trajectory, case.inner, case.outer)
    return any(len(ring) > MANY for ring in (*_list_rings(case), *(p.vertices for p in loops)))


_ANSWER: dict[str, Callable[[AnsweredPair], bool]] = {
    "identical": lambda case: _at_origin(case.generatrix) == _at_origin(case.directrix),
    "inverse": lambda case: _at_origin(case.generatrix.reflected()) == _at_origin(case.directrix),
    "touching": lambda case: classify(case.directrix, case.generatrix, (0, 0)).verdict == "CONTACT",
    "turned": lambda case: case.kind != "SS" and case.sweep().direction != (1, 0),
    "undercut": lambda case: case.inner.vertices != case.directrix.rings[0],
    "reference-point": lambda case: any(case.reference),
    "exact-fit": lambda case: bool(case.exact_fits),
    "single-position": lambda case: any(p == q for p, q in case.exact_fits),
    "no-fit-hole": lambda case: bool(case.holes),
    "unswept": lambda case: bool(case.unswept),
    "many-vertices": _is_long,
    "room-inside": lambda case: bool(case.inner_regions),
    "several-rooms": lambda case: len(case.inner_regions or ()) > 1,
    "exact-fit-inside": lambda case: bool(case.inner_exact_fits),
    "does-not-fit": lambda case: case.inner_regions == () and not case.inner_exact_fits,
}


def _sizes(case: AnsweredPair) -> Iterator[str]:
    scale = case.integer_scale
    answer = [c * scale for c in case.list_answer()]
    if scale > 1:
        yield "fractional-input"
    if any(c.denominator > 1 for c in answer):
        yield "rounded-answer"
    for name, bits in INTEGER_BITS.items():
        if name in case.representable:
            if not all(is_in_range(c, bits) for c in answer):
                yield f"overflow-{name}"
            if not is_in_range(_greatest_product(case), bits):
                yield f"product-overflow-{name}"
    if "binary64" in case.representable and _rounds_products(case):
        yield "product-rounding"
    if max(map(abs, case.list_input())) > HUGE:
        yield "huge"
    edges = chain.from_iterable(map(_edges, _list_rings(case)))
    if min(abs(c) for p, q in edges for c in (q.x - p.x, q.y - p.y) if c) < TINY:
        yield "tiny"


def _greatest_product(case: AnsweredPair) -> Fraction:
    """Return the greatest cross product of the sides of the bounding boxes, on the lattice."""
    boxes = [polygon.bounding_box for polygon in (case.directrix, case.generatrix)]
    width, height = (
        max(high[axis] - low[axis] for low, high in boxes) * case.integer_scale for axis in (0, 1)
    )
    return 2 * width * height


def _rounds_products(case: AnsweredPair) -> bool:
    for ring in _list_rings(case):
        widths, heights = ([q[i] - p[i] for p, q in _edges(ring)] for i in (0, 1))
        next_widths, next_heights = widths[1:] + widths[:1], heights[1:] + heights[:1]
        for first, second in (widths, next_heights), (heights, next_widths):
            products = [a * b for a, b in zip(first, second, strict=True)]
            if "binary64" not in find_types(products, 1):
                return True
    return False


def _slopes(case: AnsweredPair) -> Iterator[str]:
    d, g = (_directions(shape.rings) for shape in (case.directrix, case.generatrix))
    if any(x == 0 for x, _ in d | g):
        yield "vertical-edge"
    if d & g:
        yield "parallel-edges"
    ordered = sorted(d | g, key=angle_key)
    for u, v in pairwise((*ordered, ordered[0])):
        squares = (u[0] ** 2 + u[1] ** 2) * (v[0] ** 2 + v[1] ** 2)
        if 0 < cross(u, v) ** 2 < NEAR**2 * squares:
            yield "near-parallel"
            break


def _directions(rings: PointRings) -> set[Vector]:
    """Return the primitive vectors along the edges, in the right half-plane."""
    found = set()
    for p, q in chain.from_iterable(map(_edges, rings)):
        dx, dy = q.x - p.x, q.y - p.y
        found.add((0, 1) if dx == 0 else Fraction(dy, dx).as_integer_ratio()[::-1])
    return found


def _edges(ring: Sequence[Point]) -> Iterator[tuple[Point, Point]]:
    return pairwise((*ring, ring[0]))
