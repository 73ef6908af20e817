"""Drawing of polygons and chains on matplotlib Axes, at an exact scale, with enlarged details."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from math import ceil, nan
from string import ascii_lowercase
from typing import TYPE_CHECKING, Any, NamedTuple, Self

from exactsweep.canvas import style
from exactsweep.canvas.style import Look, use_style
from exactsweep.canvas.window import Scale
from exactsweep.geometry.region import AnyPolygon
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import Point, Vertex

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.transforms import Bbox

# In inches: the height and the width of a legend entry, the margins of the Axes, and their minimum
# width.
_LEGEND_LINE, _LEGEND_WIDTH = 0.18, 2.0
_LEFT, _RIGHT, _ABOVE, _BELOW = 0.75, 0.1, 0.35, 0.55
_MIN_WIDTH = 0.5
_LEGEND_COLUMNS = 3
# The aspect ratio of a picture with different units on the axes.
_STRETCHED_ASPECT = 0.6


class Picture:
    r"""Matplotlib Axes for shapes with exact coordinates.

    Args:
        axes: an Axes, whose aspect ratio and labels are set.
        scale: a Scale that covers the shapes; `scale.place` returns the position of a point.
        y_down: whether Y points down, as in SVG.
        window: the lower left and the upper right corner of the visible part; default: everything.

    Example:
        >>> from exactsweep import Polygon
        >>> from exactsweep.draw import make_figure, style
        >>> square = Polygon([(0, 0), (10**40, 0), (10**40, 10**40), (0, 10**40)])
        >>> (axes,) = make_figure().axes
        >>> picture = Picture(axes, Scale.of(square.vertices))
        >>> picture.area(square.vertices, style.DIRECTRIX, "directrix")
        >>> axes.get_xlabel()
        '$x\\,/\\,10^{39}$'
    """

    def __init__(
        self,
        axes: Axes,
        scale: Scale,
        *,
        y_down: bool = False,
        window: tuple[Vertex, Vertex] | None = None,
    ) -> None:
        self.axes = axes
        self.scale = scale
        self.y_down = y_down
        self._window = window
        self._reserved = 0.0
        self._named: set[str] = set()
        axes.set_aspect("equal" if scale.is_true else "auto", adjustable="box")
        axes.set_xlabel(scale.x.label("x"))
        axes.set_ylabel(scale.y.label("y"))
        axes.ticklabel_format(useOffset=False, style="plain")
        if not scale.is_true:
            note = "not to scale: the axes have different units"
            axes.set_title(note, loc="right", fontsize="small")
        if y_down:
            axes.yaxis.set_inverted(True)

    def area(self, loop: Iterable[Vertex], look: Look, label: str | None = None) -> None:
        """Fill, hatch and outline a loop; equal labels share a legend entry."""
        self.shape([loop], look, label)

    def ring(
        self, outer: Iterable[Vertex], inner: Iterable[Vertex], look: Look, label: str | None = None
    ) -> None:
        """Fill the area between two loops, `inner` inside `outer`."""
        self.shape([outer, inner], look, label)

    def shape(
        self, rings: Iterable[Iterable[Vertex]], look: Look, label: str | None = None
    ) -> None:
        """Fill the first loop without the following loops, all of them counter-clockwise."""
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path

        exterior, *holes = (self.scale.places(ring) for ring in rings)
        paths = [
            Path([*places, places[0]], closed=True)
            for places in (exterior, *(hole[::-1] for hole in holes))
        ]
        path = Path.make_compound_path(*paths)
        if self._window is not None:
            # Formats with single precision misplace points far outside.
            path = path.clip_to_bbox(self._box(of=3))
            if not path.to_polygons():
                return
        self.axes.add_patch(PathPatch(path, label=self._once(label), **look.as_area))

    def line(
        self,
        points: Iterable[Vertex],
        look: Look,
        label: str | None = None,
        *,
        closed: bool = False,
    ) -> None:
        """Draw a chain, or a loop if `closed`."""
        chain = list(points)
        self.lines([[*chain, chain[0]] if closed else chain], look, label)

    def lines(
        self, chains: Iterable[Iterable[Vertex]], look: Look, label: str | None = None
    ) -> None:
        """Draw several chains with a single legend entry."""
        # NaNs separate the chains.
        places = [place for chain in chains for place in ((nan, nan), *self.scale.places(chain))]
        xs, ys = ([place[axis] for place in places[1:]] for axis in (0, 1))
        self.axes.plot(xs, ys, label=self._once(label), **look.as_line)

    def text(self, at: Vertex, words: str, *, color: str = "black") -> None:
        """Write text to the upper right of a point."""
        self.axes.annotate(
            words, self.scale.place(at), (4, 4), textcoords="offset points", color=color, zorder=8
        )

    @property
    def aspect(self) -> float:
        """The ratio of height to width."""
        if not self.scale.is_true:
            return _STRETCHED_ASPECT
        left, right = self.axes.get_xlim()
        low, high = self.axes.get_ylim()
        return abs(high - low) / abs(right - left)

    def reserve(self, share: float) -> None:
        """Reserve space for details below the picture, as a share of its width."""
        self._reserved = share

    def show_window(self) -> None:
        """Show only the window, without tick labels."""
        box = self._box()
        self.axes.set_xlim(box.x0, box.x1)
        self.axes.set_ylim(*((box.y1, box.y0) if self.y_down else (box.y0, box.y1)))
        self.axes.set(xticks=[], yticks=[], xlabel="", ylabel="")

    def legend(self) -> None:
        """Put the legend on the right of the picture, or below it if the legend is taller."""
        if not self.scale.is_true:
            self.axes.set_box_aspect(_STRETCHED_ASPECT)
        entries = len(self.axes.get_legend_handles_labels()[1])
        width, height = self._space()
        whole = self.aspect + self._reserved
        drawn = min(width - _LEGEND_WIDTH, height / whole)
        fits_right = entries * _LEGEND_LINE <= drawn * whole
        if not fits_right:
            rows = ceil(entries / _LEGEND_COLUMNS) + 1
            drawn = min(width, (height - rows * _LEGEND_LINE) / whole)
        self._lay_out(max(drawn, _MIN_WIDTH))
        place: dict[str, Any] = {"bbox_to_anchor": (1.01, 1.0)}
        if not fits_right:
            shown = self.axes.get_position(original=True).width * self._figure_size()[0]
            low = -(_BELOW / shown + self._reserved) / self.aspect
            place = {"bbox_to_anchor": (0.0, low), "ncols": _LEGEND_COLUMNS}
        with use_style():
            self.axes.legend(loc="upper left", borderaxespad=0.0, **place)

    def _alone(self) -> Figure | None:
        """Return the figure if these are its only Axes and it has a layout."""
        from matplotlib.figure import Figure

        figure = self.axes.figure
        if not isinstance(figure, Figure) or figure.get_layout_engine() is None:
            return None
        return figure if figure.axes == [self.axes] else None

    def _figure_size(self) -> tuple[float, float]:
        figure: Any = self.axes.figure
        return figure.bbox.width / figure.dpi, figure.bbox.height / figure.dpi

    def _space(self) -> tuple[float, float]:
        """Return the width and height for the Axes and the legend, in inches."""
        width, height = self._figure_size()
        if self._alone():
            return width - _LEFT - _RIGHT, height - _ABOVE - _BELOW
        space = self.axes.get_position(original=True)
        return width * space.width, height * space.height

    def _lay_out(self, drawn: float) -> None:
        """Set the width of the Axes in inches if they are alone in their figure."""
        figure = self._alone()
        if figure is None:
            return
        width, height = self._figure_size()
        high = drawn * self.aspect
        figure.set_layout_engine("none")
        self.axes.set_position(
            (_LEFT / width, 1 - (_ABOVE + high) / height, drawn / width, high / height)
        )

    def _box(self, of: int = 1) -> Bbox:
        from matplotlib.transforms import Bbox

        assert self._window is not None
        return Bbox([self.scale.place(corner) for corner in self._window]).expanded(of, of)

    def _once(self, label: str | None) -> str | None:
        if label is None or label in self._named:
            return None
        self._named.add(label)
        return label


@explain_type_errors
def draw_chains(picture: Picture, chains: Mapping[str, Iterable[Vertex]]) -> None:
    """Draw named chains, each with its own color and marker."""
    for k, (name, chain) in enumerate(chains.items()):
        picture.line(chain, style.choose_chain_look(k), name)


@explain_type_errors
def draw_sub_trajectories(
    picture: Picture, chains: Iterable[Iterable[Vertex]], envelope: Iterable[Vertex] | None = None
) -> None:
    """Draw sub-trajectories as thin dashed lines, and their lower envelope as a bold line."""
    for chain in chains:
        picture.line(chain, style.SUB_TRAJECTORY, "sub-trajectory")
    if envelope is not None:
        picture.line(envelope, style.ENVELOPE, "lower envelope")


# Ratios of picture size and polygon size that call for a detail, up to the resolution of floats.
_SMALL = range(25, 10**9)
_MAX_DETAILS = 3
# Relative to the picture's width: the width of a detail, and the horizontal and vertical spacing.
_DETAIL_WIDTH, _DETAIL_SPACING, _DETAIL_DROP = 0.3, 0.35, 0.18
# The size of a detail relative to that of the small polygon.
_ENLARGED = Fraction(5, 2)


class Detail(NamedTuple):
    """An enlarged square of the plane: its lower left corner and side length."""

    left: Fraction
    bottom: Fraction
    side: Fraction

    @classmethod
    def around(cls, center: Vertex, side: Fraction) -> Self:
        x, y = center
        return cls(x - side / 2, y - side / 2, side)

    @property
    def corners(self) -> tuple[Point, Point]:
        left, bottom, side = self
        return Point(left, bottom), Point(left + side, bottom + side)

    def is_near(self, other: Self) -> bool:
        """Decide whether two details mostly overlap."""
        reach = self.side / 2
        return abs(self.left - other.left) < reach and abs(self.bottom - other.bottom) < reach


def find_details(
    shown: Iterable[Vertex],
    directrix: AnyPolygon,
    placed: Sequence[AnyPolygon],
    spots: Iterable[Vertex],
) -> list[Detail]:
    """Choose up to three details: shapes under 1/25 of the picture's size, or else spots."""
    corners = list(shown)
    boxes = [(min(values), max(values)) for values in zip(*corners, strict=True)]
    sides = [Fraction(high - low) for low, high in boxes]
    whole = max(sides)
    found: list[Detail] = []
    for shapes in ([directrix], placed):
        small = max(map(_longest, shapes))
        if int(whole / small) in _SMALL:
            found += [Detail.around(_middle(shape), _ENLARGED * small) for shape in shapes]
    if not found and not Scale.of(corners).is_true and int(whole / min(sides)) in _SMALL:
        middle = Point(*((low + high) / Fraction(2) for low, high in boxes))
        short = sides.index(min(sides))
        for x, y in spots:
            center = (x, middle.y) if short else (middle.x, y)
            found.append(Detail.around(center, min(sides)))
    chosen: list[Detail] = []
    for detail in found:
        if len(chosen) < _MAX_DETAILS and not any(map(detail.is_near, chosen)):
            chosen.append(detail)
    return chosen


def _longest(shape: AnyPolygon) -> Fraction:
    low, high = shape.bounding_box
    return max(high.x - low.x, high.y - low.y)


def _middle(shape: AnyPolygon) -> Point:
    low, high = shape.bounding_box
    return Point((low.x + high.x) / 2, (low.y + high.y) / 2)


def draw_with_details(
    picture: Picture, details: Sequence[Detail], paint: Callable[[Picture], None]
) -> None:
    """Draw a picture with its legend and frames around the details, and the details below it."""
    paint(picture)
    for k, detail in enumerate(details):
        low, high = detail.corners
        # Convert a share of the width to a share of the height.
        height = picture.aspect
        axes = picture.axes.inset_axes(
            (
                k * _DETAIL_SPACING,
                -(_DETAIL_DROP + _DETAIL_WIDTH) / height,
                _DETAIL_WIDTH,
                _DETAIL_WIDTH / height,
            )
        )
        scale = Scale.of([low, high])
        enlarged = Picture(axes, scale, y_down=picture.y_down, window=(low, high))
        paint(enlarged)
        enlarged.show_window()
        (left, bottom), (right, top) = picture.scale.place(low), picture.scale.place(high)
        picture.axes.indicate_inset((left, bottom, right - left, top - bottom), edgecolor="black")
        name = ascii_lowercase[k]
        picture.text(low if picture.y_down else (low.x, high.y), name)
        axes.set_title(f"{name}, to scale", fontsize="small")
    if details:
        picture.reserve(_DETAIL_DROP + _DETAIL_WIDTH)
    picture.legend()
