"""Pictures of no-fit polygons and inner fits."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, NamedTuple

from exactsweep.canvas import style
from exactsweep.canvas.window import Scale
from exactsweep.draw import sweeps
from exactsweep.draw.figure import require_matplotlib
from exactsweep.draw.picture import Picture, draw_with_details, find_details
from exactsweep.evidence.no_fit import InnerFitAnswer, NoFitAnswer
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import Fit, Point

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Positions(NamedTuple):
    """The contents of a picture; `names` are for both shapes and the free regions."""

    directrix: Region
    generatrix: Region
    reference: Point
    names: tuple[str, str, str]
    exterior: Region | None
    free: tuple[Region, ...]
    exact_fits: tuple[Fit, ...]
    placed: tuple[Region, ...] = ()

    @classmethod
    def of(cls, found: NoFitAnswer | InnerFitAnswer) -> Positions:
        if isinstance(found, InnerFitAnswer):
            shapes = found.container, found.part, found.reference
            names = "container D", "part G", "free positions"
            return cls(*shapes, names, None, found.regions, found.exact_fits, found.placed)
        return cls(
            found.stationary,
            found.orbiting,
            found.reference,
            ("stationary D", "orbiting G", "hole"),
            Region(found.exterior),
            tuple(map(Region, found.holes)),
            found.exact_fits,
        )

    @property
    def loops(self) -> list[Polygon]:
        regions = self.free if self.exterior is None else (self.exterior, *self.free)
        return [ring for region in regions for ring in (region.exterior, *region.holes)]

    def choose_positions(self) -> list[Point]:
        """Choose positions: exact fits of both kinds, one on a hole, and one on the exterior."""
        segments, points = sweeps.split_fits(self.exact_fits)
        found = [inside for _, inside in segments[:1]] + points[:1]
        found += [region.vertices[0] for region in self.free[:1]]
        if self.exterior is not None:
            found.append(self.exterior.vertices[0])
        return list(dict.fromkeys(found))


@explain_type_errors
def plot_positions(
    found: NoFitAnswer | InnerFitAnswer,
    axes: Axes | None = None,
    *,
    positions: Iterable[Iterable[object]] | None = None,
    y_down: bool = False,
) -> Axes:
    """Draw a no-fit polygon or an inner fit: both polygons, all loops, and the exact fits.

    Args:
        found: a NoFitPolygon or an InnerFit.
        axes: see `plot_sweep`.
        positions: positions at which to draw the moving shape, as pairs of numbers; by default,
            some exact fits, free positions and a position on the exterior.
        y_down: see `plot_sweep`.

    Raises:
        DrawError, PolygonError, NumberError: see `plot_sweep`.

    Cost: linear in the size of the loops and fits, plus the cost of computing them.

    Example:
        >>> from exactsweep import no_fit_polygon
        >>> from exactsweep.draw import make_figure
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> axes = plot_positions(no_fit_polygon(square, square), make_figure().axes[0])
        >>> [text.get_text() for text in axes.get_legend().get_texts()]
        ['stationary D', 'exterior', 'orbiting G', 'reference point of G']
    """
    require_matplotlib()
    axes, shown = axes or sweeps.make_axes(), Positions.of(found)
    places = shown.choose_positions() if positions is None else sweeps.read_positions(positions)
    fixed, moving, free = shown.names
    by = sweeps.find_shift(shown)
    placed = [sweeps.place_generatrix(shown, place) for place in places]
    paths = [loop.translated(by).vertices for loop in shown.loops]
    fits = [sweeps.move_to_anchor(fit, shown) for fit in shown.exact_fits]

    def paint(picture: Picture) -> None:
        sweeps.draw_shape(picture, shown.directrix, style.DIRECTRIX, fixed)
        for other in shown.placed:
            sweeps.draw_shape(picture, other, style.GENERATRIX, "placed")
        for region in shown.free:
            sweeps.draw_shape(picture, region.translated(by), style.FREE, free)
        if shown.exterior is not None:
            picture.line(paths[0], style.TRAJECTORY, "exterior", closed=True)
        sweeps.draw_exact_fits(picture, shown, shown.exact_fits, shown.loops)
        sweeps.draw_generatrix(picture, shown, places, moving)

    drawn = [shown.directrix.vertices, *paths, *fits, *(g.vertices for g in placed)]
    everything = [point for points in drawn for point in points]
    spots = [point for fit in fits for point in fit] or [g.vertices[0] for g in placed]
    details = find_details(everything, shown.directrix, placed or [shown.generatrix], spots)
    draw_with_details(Picture(axes, Scale.of(everything), y_down=y_down), details, paint)
    return axes
