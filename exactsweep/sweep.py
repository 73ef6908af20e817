"""The public functions for sweeps, no-fit polygons, inner fits and free positions."""

from __future__ import annotations

from collections.abc import Iterable

from exactsweep.answers import InnerFit, NoFitPolygon, Sweep
from exactsweep.geometry.direction import DirectionError, Vector, read_direction
from exactsweep.geometry.frame import find_shared_direction, require_monotone
from exactsweep.geometry.reading import read_point
from exactsweep.geometry.region import AnyPolygon, Region, Vertices, to_region, to_regions, to_shape
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import ORIGIN

__all__ = [
    "InnerFit",
    "NoFitPolygon",
    "Sweep",
    "free_positions",
    "inner_fit_polygon",
    "minkowski_difference",
    "no_fit_polygon",
    "sweep",
]


@explain_type_errors
def sweep(
    generatrix: Region | Vertices,
    directrix: Region | Vertices,
    *,
    direction: Iterable[object] | None = None,
    reference: Iterable[object] = (0, 0),
) -> Sweep:
    """Sweep a generatrix (first argument) around a directrix, in contact and without overlap.

    The order of the arguments follows the paper's (G, D).

    Args:
        generatrix: G, a Polygon, a Region or the vertices of a polygon.
        directrix: D, in any of these forms.
        direction: a pair of numbers, a shared direction of monotonicity; by default the choice of
            `find_shared_direction`. The loops do not depend on it.
        reference: the point of G whose path is the trajectory, in the coordinates of G.

    Returns:
        A Sweep with its trajectory, inner loop and outer loop.

    Raises:
        PolygonError: a polygon is not simple.
        NumberError: a coordinate is not an exact number. Messages begin with the argument's name.
        DirectionError: a polygon is not monotone in the requested direction, or has a hole.

    Cost: O(m + n) for CC and O(m n) for CM. For MM, O(m n log n) for the trajectory and
    O(m n^2 log n) for the loops (Corollaries 3.4, 4.5, 4.6, 5.7, 5.8).

    Example:
        >>> square, triangle = [(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (2, 0), (1, 2)]
        >>> s = sweep(generatrix=square, directrix=triangle)
        >>> s.kind, s.area
        ('CC', Fraction(12, 1))
        >>> print(s.trajectory)
        (-1, -1) (2, -1) (2, 0) (1, 2) (0, 2) (-1, 0)
    """
    g, d = to_shape(generatrix, "generatrix"), to_shape(directrix, "directrix")
    origin = read_point(reference, "reference")
    if direction is None:
        chosen = _share(g, d)
    else:
        chosen = read_direction(direction)
        for shape, name in ((g, "generatrix"), (d, "directrix")):
            if shape.holes:
                raise DirectionError(
                    f"the {name} has a hole, so it is not monotone in any direction"
                )
            require_monotone(shape.exterior, chosen, name)
    if chosen is None:
        g, d = Region(g), Region(d)
    return Sweep(g, d, chosen, origin)


def _share(generatrix: AnyPolygon, directrix: AnyPolygon) -> Vector | None:
    """Return the shared direction of monotonicity; None if there is none."""
    if generatrix.holes or directrix.holes:
        return None
    return find_shared_direction(generatrix.exterior, directrix.exterior)


@explain_type_errors
def no_fit_polygon(
    stationary: Region | Vertices,
    orbiting: Region | Vertices,
    *,
    reference: Iterable[object] = (0, 0),
) -> NoFitPolygon:
    """Find the positions where an orbiting polygon overlaps a stationary one (first argument).

    Unlike in `sweep`, the moving polygon is the second argument.

    Args:
        stationary: D, a Polygon, a Region or the vertices of a polygon.
        orbiting: G, in any of these forms.
        reference: the point of G that marks a position, in the coordinates of G.

    Returns:
        A NoFitPolygon with its exterior, the trajectory of the sweep (G, D); its holes, where G
        fits inside D; and its exact fits, free positions without any play.

    Raises:
        PolygonError: a shape is not valid.
        NumberError: a coordinate is not an exact number. Messages begin with the argument's name.

    Cost: as for the trajectory of `sweep`; for kind "SS", as for `positions.find_no_fit`.

    Example:
        >>> square, triangle = [(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (2, 0), (1, 2)]
        >>> n = no_fit_polygon(stationary=triangle, orbiting=square)
        >>> print(n.exterior)
        (-1, -1) (2, -1) (2, 0) (1, 2) (0, 2) (-1, 0)
        >>> hollow = Region([(0, 0), (9, 0), (9, 9), (0, 9)], [[(1, 1), (4, 1), (4, 3), (1, 3)]])
        >>> print(no_fit_polygon(stationary=hollow, orbiting=square).holes[0])
        (1, 1) (3, 1) (3, 2) (1, 2)
    """
    d, g = to_shape(stationary, "stationary"), to_shape(orbiting, "orbiting")
    origin = read_point(reference, "reference")
    return NoFitPolygon(Region(d), Region(g), _share(g, d), origin)


@explain_type_errors
def inner_fit_polygon(
    container: Region | Vertices,
    part: Region | Vertices,
    *,
    reference: Iterable[object] = (0, 0),
) -> InnerFit:
    """Find all positions of a part inside a container (first argument).

    Args:
        container: a Polygon, a Region, whose holes are defects, or the vertices of a polygon.
        part: the part, in any of these forms.
        reference: the point of the part that marks a position, in the coordinates of the part.

    Returns:
        An InnerFit with its regions, and its exact fits, where the container is exactly as wide as
        the part. Both are empty if the part does not fit.

    Raises:
        PolygonError: a shape is not valid.
        NumberError: a coordinate is not an exact number. Messages begin with the argument's name.

    Cost: as for `positions.find_inner_fit`.

    Example:
        >>> bin, unit = [(0, 0), (4, 0), (4, 2), (0, 2)], [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> print(inner_fit_polygon(container=bin, part=unit).regions[0])
        (0, 0) (3, 0) (3, 1) (0, 1)
        >>> print(inner_fit_polygon(container=bin, part=[(0, 0), (2, 0), (2, 2), (0, 2)]))
        exact fit: (0,0) (2,0)
    """
    shapes = to_region(container, "container"), to_region(part, "part")
    return InnerFit(*shapes, read_point(reference, "reference"))


@explain_type_errors
def minkowski_difference(a: Region | Vertices, b: Region | Vertices) -> InnerFit:
    """Find the Minkowski difference of two shapes, the erosion of a by b.

    It consists of all translations that move b into a: `inner_fit_polygon` with a as the container
    and b as the part. It has the same arguments, errors and cost; messages begin with "a" or "b".

    >>> print(minkowski_difference([(0, 0), (4, 0), (0, 4)], [(0, 0), (1, 0), (1, 1), (0, 1)]))
    region, 3 vertices: (0, 0) (2, 0) (0, 2)
    """
    return InnerFit(to_region(a, "a"), to_region(b, "b"), ORIGIN)


@explain_type_errors
def free_positions(
    container: Region | Vertices,
    placed: Iterable[Region | Vertices],
    part: Region | Vertices,
    *,
    reference: Iterable[object] = (0, 0),
    attached: Iterable[Region | Vertices] = (),
) -> InnerFit:
    """Find all positions of a part inside a container that are free of placed shapes.

    Args:
        container: a Polygon, a Region, whose holes are defects, or the vertices of a polygon.
        placed: a list of shapes in their positions, in any of these forms. They may touch or
            overlap each other and the container.
        part: the part, in any of these forms.
        reference: the point of the part that marks a position, in the coordinates of the part.
        attached: further shapes that move with the part, as a rigid group.

    Returns:
        An InnerFit with its regions, and its exact fits, where the part touches obstacles on at
        least two sides. It is falsy if there are no positions.

    Raises:
        PolygonError: a shape is not valid.
        NumberError: a coordinate is not an exact number. Messages begin with the argument's name.

    Cost: as for `positions.find_inner_fit`.

    Example:
        >>> bin, unit = [(0, 0), (4, 0), (4, 2), (0, 2)], [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> print(free_positions(bin, [[(1, 0), (3, 0), (3, 1), (1, 1)]], unit))
        exact fit: (0,0) (0,1)
        exact fit: (0,1) (3,1)
        exact fit: (3,0) (3,1)
        >>> bool(free_positions(bin, [bin], unit))
        False
    """
    fixed, moved = to_region(container, "container"), to_region(part, "part")
    others, along = to_regions(placed, "placed"), to_regions(attached, "attached")
    return InnerFit(fixed, moved, read_point(reference, "reference"), others, along)
