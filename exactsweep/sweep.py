"""The sweep (G, D): classify the pair, run the procedures of its class, assemble the loops.

Definitions 1.1 to 1.3, Theorems 2.1 and 2.2. The lower sweep (G_t, D_b) and the upper sweep
(G_b, D_t) never mix; the upper one is the lower one of both polygons turned by half a turn.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from exactsweep.evidence import no_fit
from exactsweep.evidence.swept import Swept
from exactsweep.evidence.swept_shape import SweptShape
from exactsweep.geometry.direction import (
    DirectionError,
    Vector,
    read_direction,
    require_monotone,
    shared_direction,
)
from exactsweep.geometry.polygon import Polygon, read_point
from exactsweep.geometry.region import Region, Vertices

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Sweep(Swept):
    """A sweep that shows itself; made by `sweep`. What is computed is said in `Swept`."""

    def plot(
        self, axes: Axes | None = None, *, positions: Iterable[Iterable[object]] | None = None
    ) -> Axes:
        """Draw the sweep with matplotlib, the `plot` extra: see `exactsweep.draw.plot_sweep`."""
        from exactsweep.draw import plot_sweep

        return plot_sweep(self, axes, positions=positions)

    def _repr_svg_(self) -> str:
        from exactsweep.draw.notebook import sweep_svg

        return sweep_svg(self)

    def _repr_html_(self) -> str:
        from exactsweep.draw.notebook import sweep_html

        return sweep_html(self)


class ShapeSweep(SweptShape, Sweep):
    """A sweep of kind "SS"; made by `sweep` for polygons without a shared direction."""


class NoFitPolygon(no_fit.NoFitPolygon):
    """A no-fit polygon that shows itself; made by `no_fit_polygon`."""

    def plot(
        self, axes: Axes | None = None, *, positions: Iterable[Iterable[object]] | None = None
    ) -> Axes:
        """Draw it with matplotlib, the `plot` extra: see `exactsweep.draw.plot_no_fit`."""
        from exactsweep.draw import plot_no_fit

        return plot_no_fit(self, axes, positions=positions)

    def _repr_svg_(self) -> str:
        from exactsweep.draw.notebook import positions_svg

        return positions_svg(self)

    def _repr_html_(self) -> str:
        from exactsweep.draw.notebook import no_fit_html

        return no_fit_html(self)


class InnerFit(no_fit.InnerFit):
    """An inner fit that shows itself; made by `inner_fit_polygon`."""

    def plot(
        self, axes: Axes | None = None, *, positions: Iterable[Iterable[object]] | None = None
    ) -> Axes:
        """Draw them with matplotlib, the `plot` extra: see `exactsweep.draw.plot_inner_fit`."""
        from exactsweep.draw import plot_inner_fit

        return plot_inner_fit(self, axes, positions=positions)

    def _repr_svg_(self) -> str:
        from exactsweep.draw.notebook import positions_svg

        return positions_svg(self)

    def _repr_html_(self) -> str:
        from exactsweep.draw.notebook import inner_fit_html

        return inner_fit_html(self)


def sweep(
    generatrix: Region | Vertices,
    directrix: Region | Vertices,
    *,
    direction: Iterable[object] | None = None,
    reference: Iterable[object] = (0, 0),
) -> Sweep:
    """Sweep a generatrix G around a directrix D: always in contact, never overlapping.

    Args:
        generatrix: G, a Polygon, a Region or the vertices of a polygon.
        directrix: D, likewise.
        direction: a pair of numbers, the shared direction of monotonicity to be used; chosen as
            by `shared_direction` if left out. The loops do not depend on it.
        reference: the point of G whose path the trajectory is, in the coordinates of G.

    Returns:
        A Sweep with trajectory, inner and outer loop.

    Raises:
        PolygonError: a polygon is not simple.
        NumberError: a coordinate is not an exact number.
        DirectionError: a polygon is not monotone to the direction asked for, or has a hole.

    Cost: O(m + n) for CC, O(m n) for CM; for MM O(m n log n) for the trajectory and
    O(m n^2 log n) for the loops (Corollaries 3.4, 4.5, 4.6, 5.7, 5.8).

    Example:
        >>> s = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (2, 0), (1, 2)])
        >>> s.kind, s.area
        ('CC', Fraction(12, 1))
        >>> print(s.trajectory)
        (-1, -1) (2, -1) (2, 0) (1, 2) (0, 2) (-1, 0)
    """
    g, d, origin = _read(generatrix), _read(directrix), read_point(reference, "reference")
    if direction is not None:
        chosen = read_direction(direction)
        for shape, name in ((g, "generatrix"), (d, "directrix")):
            if isinstance(shape, Region):
                raise DirectionError(f"the {name} has a hole: it is monotone to no direction")
            require_monotone(shape, chosen, name)
    monotone = _share(g, d, None if direction is None else chosen)
    if monotone is None:
        return ShapeSweep(Region(g), Region(d), origin)
    return Sweep(*monotone, origin)


def _read(shape: Region | Vertices) -> Polygon | Region:
    """A shape with holes as a Region, any other as a Polygon."""
    if isinstance(shape, Region):
        return shape if shape.holes else shape.exterior
    return Polygon(shape)


def _share(
    generatrix: Polygon | Region, directrix: Polygon | Region, direction: Vector | None = None
) -> tuple[Polygon, Polygon, Vector] | None:
    """G, D and the shared direction, if the paper's procedures can sweep them."""
    if isinstance(generatrix, Region) or isinstance(directrix, Region):
        return None
    try:
        chosen = direction or shared_direction(generatrix, directrix)
    except DirectionError:
        return None
    return generatrix, directrix, chosen


def no_fit_polygon(
    stationary: Region | Vertices,
    orbiting: Region | Vertices,
    *,
    reference: Iterable[object] = (0, 0),
) -> NoFitPolygon:
    """The no-fit polygon (stationary, orbiting): where the one overlaps the other.

    Args:
        stationary: D, a Polygon, a Region or the vertices of a polygon.
        orbiting: G, likewise.
        reference: the point of G whose positions are told, in the coordinates of G.

    Returns:
        A NoFitPolygon: its exterior, the trajectory of the sweep (G, D); its holes, where G fits
        inside D without overlap; and its exact fits, free positions without room around them.

    Raises:
        PolygonError: a polygon is not simple, or a hole is not inside.
        NumberError: a coordinate is not an exact number.

    Cost: as for the trajectory of `sweep`; for other shapes as for `ss.no_fit_ss`.

    Example:
        >>> n = no_fit_polygon([(0, 0), (2, 0), (1, 2)], [(0, 0), (1, 0), (1, 1), (0, 1)])
        >>> print(n.exterior)
        (-1, -1) (2, -1) (2, 0) (1, 2) (0, 2) (-1, 0)
        >>> hollow = Region([(0, 0), (9, 0), (9, 9), (0, 9)], [[(1, 1), (4, 1), (4, 3), (1, 3)]])
        >>> print(no_fit_polygon(hollow, [(0, 0), (1, 0), (1, 1), (0, 1)]).holes[0])
        (1, 1) (3, 1) (3, 2) (1, 2)
    """
    d, g, origin = _read(stationary), _read(orbiting), read_point(reference, "reference")
    monotone = _share(g, d)
    swept = None if monotone is None else Swept(*monotone, origin)
    return NoFitPolygon(Region(d), Region(g), origin, swept)


def inner_fit_polygon(
    container: Region | Vertices,
    part: Region | Vertices,
    *,
    reference: Iterable[object] = (0, 0),
) -> InnerFit:
    """The inner-fit polygon (container, part): all positions of the part inside the container.

    Args:
        container: a Polygon, a Region, whose holes are defects, or the vertices of a polygon.
        part: likewise.
        reference: the point of the part whose positions are told, in the coordinates of the part.

    Returns:
        An InnerFit: its regions, and its exact fits, where a container is exactly as wide as the
        part. A part that does not fit has neither.

    Raises:
        PolygonError: a polygon is not simple, or a hole is not inside.
        NumberError: a coordinate is not an exact number.

    Cost: as for `ss.inner_fit_ss`.

    Example:
        >>> bin, unit = [(0, 0), (4, 0), (4, 2), (0, 2)], [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> print(inner_fit_polygon(bin, unit).regions[0])
        (0, 0) (3, 0) (3, 1) (0, 1)
        >>> print(inner_fit_polygon(bin, [(0, 0), (2, 0), (2, 2), (0, 2)]))
        exact fit: (0,0) (2,0)
    """
    return InnerFit(Region(container), Region(part), read_point(reference, "reference"))
