"""Answers of the public functions, with plots and notebook output."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from exactsweep.evidence.no_fit import InnerFitAnswer, NoFitAnswer
from exactsweep.evidence.sweep import SweepAnswer

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from exactsweep.view import InlinePage


class Sweep(SweepAnswer):
    """The sweep (G, D) of a generatrix around a directrix; see `exactsweep.sweep`.

    Each loop is computed on first access.

    Attributes:
        generatrix: G, a Polygon; a Region if the kind is "SS".
        directrix: D, of the same type.
        kind: "CC" if both are convex, "CM" if only G is convex, "MM" if both are monotone, or "SS"
            for any shape.
        direction: the shared direction of monotonicity, a primitive integer vector; None if the
            kind is "SS".
        reference: the point of G whose path is the trajectory, a Point.
    """

    def plot(
        self,
        axes: Axes | None = None,
        *,
        positions: Iterable[Iterable[object]] | None = None,
        y_down: bool = False,
    ) -> Axes:
        """Draw the sweep with matplotlib, the `plot` extra; see `exactsweep.draw.plot_sweep`."""
        from exactsweep.draw import plot_sweep

        return plot_sweep(self, axes, positions=positions, y_down=y_down)

    def view(self, height: int = 600) -> InlinePage:
        """Return the interactive page for a notebook; `height` is in pixels."""
        from exactsweep.view import InlinePage

        return InlinePage(self, height)

    def _repr_svg_(self) -> str:
        from exactsweep.draw.notebook import draw_sweep

        return draw_sweep(self)

    def _repr_html_(self) -> str:
        from exactsweep.draw.notebook import show_sweep

        return show_sweep(self)


class _Shown:
    """Plots and notebook output of positions."""

    def plot(
        self: Any,
        axes: Axes | None = None,
        *,
        positions: Iterable[Iterable[object]] | None = None,
        y_down: bool = False,
    ) -> Axes:
        """Draw the positions with matplotlib; see `exactsweep.draw.plot_positions`."""
        from exactsweep.draw import plot_positions

        return plot_positions(self, axes, positions=positions, y_down=y_down)

    def _repr_svg_(self: Any) -> str:
        from exactsweep.draw.notebook import draw_positions

        return draw_positions(self)

    def _repr_html_(self: Any) -> str:
        from exactsweep.draw.notebook import show_positions

        return show_positions(self)


class NoFitPolygon(_Shown, NoFitAnswer):
    """The positions where an orbiting polygon overlaps a stationary one; see `no_fit_polygon`.

    Each property is computed on first access.

    Attributes:
        stationary: D, a Region.
        orbiting: G, a Region.
        reference: the point of G that marks a position, a Point.
        kind: "CC", "CM" or "MM" if the paper's procedures apply, else "SS".
    """


class InnerFit(_Shown, InnerFitAnswer):
    """The positions of a part inside a container, free of placed shapes if there are any.

    Returned by `inner_fit_polygon` and `free_positions`. It is falsy if there are no positions.

    Attributes:
        container: a Region, whose holes are defects.
        part: a Region.
        reference: the point of the part that marks a position, a Point.
        placed: the Regions that the part must not overlap.
        attached: the Regions that move with the part.
    """
