"""No-fit polygons of shapes of any kind, by their definition.

Let O be the positions t at which the interiors of D and G + t meet, and F the others.

1. O is the union of the open sets D_i + I(G_j), over open convex pieces of D and of G. For if the
   interiors of D and of G + t meet, they meet in an open set, and the cuts between pieces hold
   none; so two pieces meet.
2. The boundary of O is the set of contacts: positions in F at which D and G + t touch. For O is
   open, its boundary is in F, and by compactness limits of overlap touch. Where they touch in a
   point, interior points of both are close to it, so that a small step makes them overlap.
3. At a contact a vertex of one lies on an edge of the other (edges that cross overlap), so the
   contact segments and the meetings of two vertices, less O, are the boundary of O. Along one
   segment O is a union of open intervals, one for each pair of pieces.
4. Split where they meet, the edges of the boundary have O on at least one side, and the side does
   not change along an edge. Those with F on the other side bound the interior of F; the others,
   and the points without edges, are the exact fits, split where they meet the first ones.
5. Each component of the plane without the closure of O is bounded by one simple loop, if O is
   connected: around the unbounded one runs the exterior, around the others the holes.

For positions inside a container, D is the complement of the container, within a box. Any box around
the container will do: if G + t touches the container and is not inside it, G + t has points outside
it that are as close to it as any. Here O may be disconnected, so that a component is bounded by
more loops than one, and may touch itself: loops are cut where they would visit a point twice.

The area swept along the exterior T is T + G: p is outside it if p + H, where H = -G, does not meet
T, which means that p + H is outside T, or inside it. So its outer loop and the holes are those of
the no-fit polygon of what T surrounds and of H, and the exteriors of the positions of H inside T.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import inf
from typing import Any, NamedTuple

from exactsweep.check.arrangement import Boundary, WalkedLoop, assemble, canonicalize
from exactsweep.check.contact_segments import find_contacts
from exactsweep.check.convex import cut_to_convex
from exactsweep.check.location import locate
from exactsweep.check.shape import (
    LatticeRing,
    LatticeShape,
    Outlines,
    list_rings,
    scale_shapes,
    to_point,
    to_points,
)
from exactsweep.check.standalone import Work
from exactsweep.check.uncovered import OpenSets
from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.error import tells_arguments
from exactsweep.numbers.number import Fit, Loop, Point, Vertex

UNLIMITED = Work(inf)


class ReferenceNoFit(NamedTuple):
    """Loops as tuples of Point in canonical order, sorted, and exact fits, sorted."""

    exterior: Loop
    holes: tuple[Loop, ...]
    exact_fits: tuple[Fit, ...]


class ReferenceInnerFit(NamedTuple):
    """Regions, each an exterior and its holes, sorted, and exact fits, sorted."""

    regions: tuple[tuple[Loop, tuple[Loop, ...]], ...]
    exact_fits: tuple[Fit, ...]


class ReferenceSwept(NamedTuple):
    """The outer loop of the area swept, the loop around D, and further holes, sorted."""

    outer: Loop
    inner: Loop
    unswept: tuple[Loop, ...]


@tells_arguments
def reference_no_fit(directrix: Any, generatrix: Any) -> ReferenceNoFit:
    """Evaluate the no-fit polygon of two shapes from the definition.

    Args:
        directrix: D, a Polygon, its vertices or a Region, m edges.
        generatrix: G, likewise, n edges.

    Returns:
        ReferenceNoFit. Of an exact fit the end that hangs on a loop comes first, where just one
        does; a single position is a fit of two equal ends.

    Raises:
        PolygonError: vertices are not those of a simple polygon.

    Cost: O(m**2 n**2) for the intervals of all pairs of pieces on all lines of contact.
    Source: Definition 1.1.

    >>> cave = [(0, 0), (4, 0), (4, 4), (2, 4), (2, 3), (3, 3), (3, 1), (1, 1), (1, 4), (0, 4)]
    >>> found = reference_no_fit(cave, [(0, 0), (2, 0), (2, 2), (0, 2)])
    >>> [[tuple(map(str, p)) for p in fit] for fit in found.exact_fits]
    [[('1', '1'), ('1', '1')]]
    """
    return find_no_fit(list_rings(directrix), list_rings(generatrix), UNLIMITED)


def find_no_fit(directrix: Outlines, generatrix: Outlines, budget: Work) -> ReferenceNoFit:
    """Evaluate `reference_no_fit` within a budget."""
    scale, (d, h) = scale_shapes((directrix, _turn(generatrix)))
    found = _assemble_boundary(cut_to_convex(d, budget), d, h, budget)
    (exterior,) = (loop for loop in found.loops if not loop.is_hole)
    return ReferenceNoFit(
        _vertices(exterior, scale),
        tuple(sorted(_vertices(loop, scale) for loop in found.loops if loop.is_hole)),
        _fits(found, scale),
    )


@tells_arguments
def reference_inner_fit(container: Any, part: Any) -> ReferenceInnerFit:
    """Evaluate the positions of a part inside a container from the definition.

    Args:
        container: a Polygon, its vertices or a Region, m edges.
        part: likewise, n edges.

    Returns:
        ReferenceInnerFit, empty if the part does not fit. Rings of a region may touch in vertices.

    Raises:
        PolygonError: vertices are not those of a simple polygon.

    Cost: as `reference_no_fit`.
    Source: Definition 1.1, for the complement of the container.

    >>> reference_inner_fit([(0, 0), (3, 0), (3, 1), (0, 1)], [(0, 0), (1, 0), (1, 1), (0, 1)])[1]
    ((Point(x=Fraction(0, 1), y=Fraction(0, 1)), Point(x=Fraction(2, 1), y=Fraction(0, 1))),)
    """
    return find_inner_fit(list_rings(container), list_rings(part), UNLIMITED)


def find_inner_fit(container: Outlines, part: Outlines, budget: Work) -> ReferenceInnerFit:
    """Evaluate `reference_inner_fit` within a budget."""
    scale, (c, h) = scale_shapes((container, _turn(part)))
    outside = tuple(ring[::-1] for ring in c)
    solids = [(_box_around(c[0]), outside[0]), *((ring,) for ring in outside[1:])]
    pieces = [piece for solid in solids for piece in cut_to_convex(solid, budget)]
    found = _assemble_boundary(pieces, outside, h, budget)
    # Where each hole lies.
    holes = sum(not loop.is_hole for loop in found.loops)
    budget.take(holes * sum(len(loop.points) for loop in found.loops) // 8)
    return ReferenceInnerFit(_regions(found.loops, scale), _fits(found, scale))


@tells_arguments
def reference_swept(
    directrix: Any, generatrix: Any, exterior: Sequence[Point] | None = None
) -> ReferenceSwept:
    """Evaluate the area that G sweeps along the exterior of its no-fit polygon around D.

    Args:
        directrix: D, a Polygon, its vertices or a Region, m edges.
        generatrix: G, likewise, n edges.
        exterior: of the no-fit polygon, if it is known, t edges.

    Returns:
        ReferenceSwept.

    Raises:
        PolygonError: vertices are not those of a simple polygon.

    Cost: as `reference_no_fit`, and O(t**2 n**2).
    Source: Definition 1.3.

    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> [len(loop) for loop in reference_swept(square, square)]
    [4, 4, 0]
    """
    if exterior is None:
        exterior = reference_no_fit(directrix, generatrix).exterior
    shapes = list_rings(directrix), list_rings(generatrix)
    return find_swept(*shapes, Polygon(exterior).vertices, UNLIMITED)


def find_swept(
    directrix: Outlines, generatrix: Outlines, trajectory: Loop, budget: Work
) -> ReferenceSwept:
    """Evaluate `reference_swept` within a budget."""
    inverse = _turn(generatrix)
    beyond = find_no_fit((trajectory,), inverse, budget)
    within = [exterior for exterior, _ in find_inner_fit((trajectory,), inverse, budget).regions]
    scale, (d,) = scale_shapes((directrix,))
    inside = to_point(_point_inside(cut_to_convex(d, budget)[0]), scale)
    (inner,) = (loop for loop in within if locate(inside, loop) > 0)
    unswept = [*beyond.holes, *(loop for loop in within if loop is not inner)]
    return ReferenceSwept(beyond.exterior, inner, tuple(sorted(unswept)))


def _turn(shape: Outlines) -> Outlines:
    """Turn a shape by half a turn."""
    return tuple(tuple(Point(-x, -y) for x, y in ring) for ring in shape)


def _assemble_boundary(
    pieces: Sequence[LatticeRing], boundary: LatticeShape, h: LatticeShape, budget: Work
) -> Boundary:
    """Assemble the boundary of the positions at which G overlaps a solid, by steps 1 to 4.

    Args:
        pieces: the convex pieces of the solid.
        boundary: its rings, as far as G is to touch them.
        h: the rings of I(G).
        budget: the steps that it may take.
    """
    sets = OpenSets(pieces, cut_to_convex(h, budget), budget)
    segments, points = find_contacts(boundary, h)
    left, more = sets.uncovered(segments)
    single = more | {p for p in points if not sets.holds(p)}
    return assemble(left, single, sets, budget)


def _vertices(loop: WalkedLoop, scale: int) -> Loop:
    return to_points(canonicalize(loop.points), scale)


def _fits(found: Boundary, scale: int) -> tuple[Fit, ...]:
    pairs = (to_points(fit, scale) for fit in found.fits)
    return tuple(sorted((hanging, end) for hanging, end in pairs))


def _regions(loops: Sequence[WalkedLoop], scale: int) -> tuple[tuple[Loop, tuple[Loop, ...]], ...]:
    """Give each hole of a region to the least exterior around it."""
    exteriors = [loop for loop in loops if loop.is_hole]
    exteriors.sort(key=lambda loop: find_doubled_area(loop.points))
    holes: list[list[Loop]] = [[] for _ in exteriors]
    for loop in loops:
        if not loop.is_hole:
            around = (k for k, e in enumerate(exteriors) if locate(loop.beside, e.points) > 0)
            holes[next(around)].append(_vertices(loop, scale))
    found = zip(exteriors, holes, strict=True)
    return tuple(sorted((_vertices(e, scale), tuple(sorted(inside))) for e, inside in found))


def _box_around(ring: LatticeRing) -> LatticeRing:
    """A box with a margin, which G + t overlaps if it touches the ring and is not inside it."""
    xs, ys = zip(*ring, strict=True)
    left, low, right, high = min(xs) - 1, min(ys) - 1, max(xs) + 1, max(ys) + 1
    return (left, low), (right, low), (right, high), (left, high)


def _point_inside(piece: LatticeRing) -> Vertex:
    """The centre of a triangle of a convex piece."""
    xs, ys = zip(*piece[:3], strict=True)
    return Fraction(sum(xs)) / 3, Fraction(sum(ys)) / 3
