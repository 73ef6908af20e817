"""The sweep (G, D): classify the pair, run the procedures of its class, assemble the loops.

Definitions 1.1 to 1.3, Theorems 2.1 and 2.2. The lower sweep (G_t, D_b) and the upper sweep
(G_b, D_t) never mix; the upper one is the lower one of both polygons turned by half a turn.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, ClassVar

from exactsweep.evidence import no_fit
from exactsweep.evidence.swept import Swept
from exactsweep.evidence.swept_shape import SweptShape
from exactsweep.geometry.direction import (
    DirectionError,
    Vector,
    choose_direction,
    read_direction,
    require_monotone,
)
from exactsweep.geometry.given import to_region, to_shape
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_point
from exactsweep.geometry.region import Region, Vertices
from exactsweep.numbers.arguments import tells_arguments

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from exactsweep.view import InlinePage


class EqualByQuestion:
    """What equals another if the same was asked of the same polygons.

    Polygons are equal as sets of points: in which order their vertices were given shows in the
    numbers of features, and not here.
    """

    asked: ClassVar[tuple[str, ...]]
    """The names of the attributes that say what was asked."""

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)) or not isinstance(self, type(other)):
            return NotImplemented
        return all(getattr(self, name) == getattr(other, name) for name in self.asked)

    def __hash__(self) -> int:
        return hash(tuple(getattr(self, name) for name in self.asked))


class Sweep(EqualByQuestion, Swept):
    """A sweep that shows itself; made by `sweep`. What is computed is said in `Swept`."""

    asked = ("generatrix", "directrix", "direction", "reference")

    def plot(
        self,
        axes: Axes | None = None,
        *,
        positions: Iterable[Iterable[object]] | None = None,
        y_down: bool = False,
    ) -> Axes:
        """Draw the sweep with matplotlib, the `plot` extra: see `exactsweep.draw.plot_sweep`."""
        from exactsweep.draw import plot_sweep

        return plot_sweep(self, axes, positions=positions, y_down=y_down)

    def view(self, height: int = 600) -> InlinePage:
        """Return the interactive page, which a notebook shows: see `exactsweep.view.page`.

        Args:
            height: of the frame in the notebook, in pixels.
        """
        from exactsweep.view import InlinePage

        return InlinePage(self, height)

    def _repr_svg_(self) -> str:
        from exactsweep.draw.notebook import draw_sweep

        return draw_sweep(self)

    def _repr_html_(self) -> str:
        from exactsweep.draw.notebook import show_sweep

        return show_sweep(self)


class ShapeSweep(SweptShape, Sweep):
    """A sweep of kind "SS"; made by `sweep` for polygons without a shared direction."""


class FoundPositions(EqualByQuestion):
    """Positions that show themselves: those of a no-fit polygon, or of an inner fit."""

    def plot(
        self: Any,
        axes: Axes | None = None,
        *,
        positions: Iterable[Iterable[object]] | None = None,
        y_down: bool = False,
    ) -> Axes:
        """Draw them with matplotlib, the `plot` extra: see `exactsweep.draw.plot_positions`."""
        from exactsweep.draw import plot_positions

        return plot_positions(self, axes, positions=positions, y_down=y_down)

    def _repr_svg_(self: Any) -> str:
        from exactsweep.draw.notebook import draw_positions

        return draw_positions(self)

    def _repr_html_(self: Any) -> str:
        from exactsweep.draw.notebook import show_positions

        return show_positions(self)


class NoFitPolygon(FoundPositions, no_fit.NoFitPositions):
    """A no-fit polygon that shows itself; made by `no_fit_polygon`."""

    asked = ("stationary", "orbiting", "reference")


class InnerFit(FoundPositions, no_fit.InnerFitPositions):
    """An inner fit that shows itself; made by `inner_fit_polygon` or `free_positions`."""

    asked = ("container", "part", "reference", "placed")


@tells_arguments
def sweep(
    generatrix: Region | Vertices,
    directrix: Region | Vertices,
    *,
    direction: Iterable[object] | None = None,
    reference: Iterable[object] = (0, 0),
) -> Sweep:
    """Sweep a generatrix, given first, around a directrix: always in contact, never overlapping.

    In the order of the paper's (G, D); with `generatrix=` and `directrix=` no order matters.

    Args:
        generatrix: G, a Polygon, a Region or the vertices of a polygon.
        directrix: D, likewise.
        direction: a pair of numbers, the shared direction of monotonicity to be used; chosen as
            by `choose_direction` if left out. The loops do not depend on it.
        reference: the point of G whose path the trajectory is, in the coordinates of G.

    Returns:
        A Sweep with trajectory, inner and outer loop.

    Raises:
        PolygonError: a polygon is not simple; the message begins with its name.
        NumberError: a coordinate is not an exact number; likewise.
        DirectionError: a polygon is not monotone to the direction asked for, or has a hole.

    Cost: O(m + n) for CC, O(m n) for CM; for MM O(m n log n) for the trajectory and
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


def _share(
    generatrix: Polygon | Region, directrix: Polygon | Region, direction: Vector | None = None
) -> tuple[Polygon, Polygon, Vector] | None:
    """G, D and the shared direction, if the paper's procedures can sweep them."""
    if isinstance(generatrix, Region) or isinstance(directrix, Region):
        return None
    try:
        chosen = direction or choose_direction(generatrix, directrix)
    except DirectionError:
        return None
    return generatrix, directrix, chosen


@tells_arguments
def no_fit_polygon(
    stationary: Region | Vertices,
    orbiting: Region | Vertices,
    *,
    reference: Iterable[object] = (0, 0),
) -> NoFitPolygon:
    """Find where an orbiting polygon overlaps a stationary one, which is given first.

    With `stationary=` and `orbiting=` no order matters; `sweep` takes what moves first.

    Args:
        stationary: D, a Polygon, a Region or the vertices of a polygon.
        orbiting: G, likewise.
        reference: the point of G whose positions are told, in the coordinates of G.

    Returns:
        A NoFitPolygon: its exterior, the trajectory of the sweep (G, D); its holes, where G fits
        inside D without overlap; and its exact fits, free positions without room around them.

    Raises:
        PolygonError: a polygon is not simple, or a hole is not inside; the message begins with its
            name.
        NumberError: a coordinate is not an exact number; likewise.

    Cost: as for the trajectory of `sweep`; for other shapes as for `ss.no_fit_ss`.

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
    monotone = _share(g, d)
    swept = None if monotone is None else Swept(*monotone, origin)
    return NoFitPolygon(Region(d), Region(g), origin, swept)


@tells_arguments
def inner_fit_polygon(
    container: Region | Vertices,
    part: Region | Vertices,
    *,
    reference: Iterable[object] = (0, 0),
) -> InnerFit:
    """Find all positions inside a container, which is given first, of a part.

    With `container=` and `part=` no order matters.

    Args:
        container: a Polygon, a Region, whose holes are defects, or the vertices of a polygon.
        part: likewise.
        reference: the point of the part whose positions are told, in the coordinates of the part.

    Returns:
        An InnerFit: its regions, and its exact fits, where a container is exactly as wide as the
        part. A part that does not fit has neither.

    Raises:
        PolygonError: a polygon is not simple, or a hole is not inside; the message begins with its
            name.
        NumberError: a coordinate is not an exact number; likewise.

    Cost: as for `ss.inner_fit_ss`.

    Example:
        >>> bin, unit = [(0, 0), (4, 0), (4, 2), (0, 2)], [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> print(inner_fit_polygon(container=bin, part=unit).regions[0])
        (0, 0) (3, 0) (3, 1) (0, 1)
        >>> print(inner_fit_polygon(container=bin, part=[(0, 0), (2, 0), (2, 2), (0, 2)]))
        exact fit: (0,0) (2,0)
    """
    shapes = to_region(container, "container"), to_region(part, "part")
    return InnerFit(*shapes, read_point(reference, "reference"))


@tells_arguments
def free_positions(
    container: Region | Vertices,
    placed: Iterable[Region | Vertices],
    part: Region | Vertices,
    *,
    reference: Iterable[object] = (0, 0),
) -> InnerFit:
    """Find all positions of a part inside a container that are free of placed shapes.

    Args:
        container: a Polygon, a Region, whose holes are defects, or the vertices of a polygon.
        placed: shapes, likewise, where they stand. They may touch or overlap each other and the
            container.
        part: likewise.
        reference: the point of the part whose positions are reported, in the coordinates of the
            part.

    Returns:
        An InnerFit: its regions, and its exact fits, where the part touches what is around it on
        two sides at least. It is false if there is no position.

    Raises:
        PolygonError: a polygon is not simple, or a hole is not inside; the message begins with its
            name.
        NumberError: a coordinate is not an exact number; likewise.

    Cost: as for `ss.inner_fit_ss`.

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
    others = [to_region(shape, f"placed shape {k}") for k, shape in enumerate(placed)]
    return InnerFit(fixed, moved, read_point(reference, "reference"), others)
