"""The sweep (G, D): classify the pair, run the procedures of its class, assemble the loops.

Definitions 1.1 to 1.3, Theorems 2.1 and 2.2. The lower sweep (G_t, D_b) and the upper sweep
(G_b, D_t) never mix; the upper one is the lower one of both polygons turned by half a turn.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from exactsweep.evidence.swept import Swept, Vertices
from exactsweep.geometry.direction import (
    read_direction,
    require_monotone,
    shared_direction,
)
from exactsweep.geometry.polygon import Polygon, read_point

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


def sweep(
    generatrix: Vertices,
    directrix: Vertices,
    *,
    direction: Iterable[object] | None = None,
    reference: Iterable[object] = (0, 0),
) -> Sweep:
    """Sweep a generatrix G around a directrix D: always in contact, never overlapping.

    Args:
        generatrix: G, a Polygon or its vertices as `Polygon` takes them.
        directrix: D, likewise.
        direction: a pair of numbers, the shared direction of monotonicity to be used; chosen as
            by `shared_direction` if left out. The loops do not depend on it.
        reference: the point of G whose path the trajectory is, in the coordinates of G.

    Returns:
        A Sweep with trajectory, inner and outer loop.

    Raises:
        PolygonError: a polygon is not simple.
        NumberError: a coordinate is not an exact number.
        DirectionError: the polygons are monotone to no shared direction, or not to this one.

    Cost: O(m + n) for CC, O(m n) for CM; for MM O(m n log n) for the trajectory and
    O(m n^2 log n) for the loops (Corollaries 3.4, 4.5, 4.6, 5.7, 5.8).

    Example:
        >>> s = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (2, 0), (1, 2)])
        >>> s.kind, s.area
        ('CC', Fraction(12, 1))
        >>> print(s.trajectory)
        (-1, -1) (2, -1) (2, 0) (1, 2) (0, 2) (-1, 0)
    """
    g, d = Polygon(generatrix), Polygon(directrix)
    if direction is None:
        chosen = shared_direction(g, d)
    else:
        chosen = read_direction(direction)
        require_monotone(g, chosen, "generatrix")
        require_monotone(d, chosen, "directrix")
    return Sweep(g, d, chosen, read_point(reference, "reference"))


def no_fit_polygon(stationary: Vertices, orbiting: Vertices) -> Polygon:
    """The no-fit polygon: where the origin of the orbiting polygon runs while both touch.

    Args:
        stationary: the directrix D, a Polygon or its vertices.
        orbiting: the generatrix G, likewise.

    Returns:
        The trajectory T(G, D), a Polygon. Translations in its interior make the two overlap, but
        for exact fits.

    Raises, cost: as for the trajectory of `sweep`.

    Example:
        >>> print(no_fit_polygon([(0, 0), (2, 0), (1, 2)], [(0, 0), (1, 0), (1, 1), (0, 1)]))
        (-1, -1) (2, -1) (2, 0) (1, 2) (0, 2) (-1, 0)
    """
    return sweep(orbiting, stationary).trajectory
