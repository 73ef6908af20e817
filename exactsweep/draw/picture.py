"""Polygons and chains on the Axes of matplotlib, at one exact scale."""

from __future__ import annotations

from collections.abc import Iterable
from math import nan
from typing import TYPE_CHECKING

from exactsweep.canvas.scale import Scale
from exactsweep.canvas.style import Look, in_style
from exactsweep.geometry.point import Vertex

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Points = Iterable[Vertex]


class Picture:
    r"""An Axes on which shapes with exact coordinates are drawn.

    Args:
        axes: an Axes of matplotlib; its aspect and its labels are set.
        scale: a Scale that holds the shapes.

    Attributes:
        axes: the Axes, for anything else.
        scale: the Scale; `scale.place` says where on the Axes a point is.

    Example:
        >>> from exactsweep import Polygon
        >>> from exactsweep.draw import new_figure, style
        >>> square = Polygon([(0, 0), (10**40, 0), (10**40, 10**40), (0, 10**40)])
        >>> (axes,) = new_figure().axes
        >>> picture = Picture(axes, Scale.of(square.vertices))
        >>> picture.area(square.vertices, style.DIRECTRIX, "directrix")
        >>> axes.get_xlabel()
        '$x\\,/\\,10^{39}$'
    """

    def __init__(self, axes: Axes, scale: Scale) -> None:
        self.axes = axes
        self.scale = scale
        self._named: set[str] = set()
        axes.set_aspect("equal" if scale.is_true else "auto", adjustable="box")
        axes.set_xlabel(scale.x.label("x"))
        axes.set_ylabel(scale.y.label("y"))
        axes.ticklabel_format(useOffset=False, style="plain")
        if not scale.is_true:
            axes.set_title("not to scale: each axis has a unit of its own", fontsize="small")

    def area(self, loop: Points, look: Look, label: str | None = None) -> None:
        """Fill, hatch and outline a loop; things of one label are one entry of the legend."""
        xs, ys = self._columns(loop)
        self.axes.fill(xs, ys, label=self._once(label), **look.as_area)

    def ring(self, outer: Points, inner: Points, look: Look, label: str | None = None) -> None:
        """Fill what lies between two loops; `inner` lies in `outer`."""
        self.shape([outer, inner], look, label)

    def shape(self, rings: Iterable[Points], look: Look, label: str | None = None) -> None:
        """Fill what lies in the first of some counter-clockwise loops and in no other."""
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        exterior, *holes = (self.scale.places(ring) for ring in rings)
        paths = [
            Path([*places, places[0]], closed=True)
            for places in (exterior, *(hole[::-1] for hole in holes))
        ]
        patch = PathPatch(Path.make_compound_path(*paths), label=self._once(label), **look.as_area)
        self.axes.add_patch(patch)

    def line(
        self, points: Points, look: Look, label: str | None = None, *, closed: bool = False
    ) -> None:
        """Draw a chain, or a loop if it is closed."""
        chain = list(points)
        self.lines([[*chain, chain[0]] if closed else chain], look, label)

    def lines(self, chains: Iterable[Points], look: Look, label: str | None = None) -> None:
        """Draw several chains as one thing."""
        xs: list[float] = []
        ys: list[float] = []
        for chain in chains:
            if xs:
                xs.append(nan)
                ys.append(nan)
            more_xs, more_ys = self._columns(chain)
            xs += more_xs
            ys += more_ys
        self.axes.plot(xs, ys, label=self._once(label), **look.as_line)

    def text(self, at: Vertex, words: str, *, color: str = "black") -> None:
        """Write a few words a little above and to the right of a point."""
        self.axes.annotate(
            words, self.scale.place(at), (4, 4), textcoords="offset points", color=color, zorder=8
        )

    def legend(self) -> None:
        """Put the legend beside the picture, where it hides nothing."""
        with in_style():
            self.axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0)

    def _columns(self, points: Points) -> tuple[list[float], list[float]]:
        places = self.scale.places(points)
        return [x for x, _ in places], [y for _, y in places]

    def _once(self, label: str | None) -> str | None:
        if label is None or label in self._named:
            return None
        self._named.add(label)
        return label
