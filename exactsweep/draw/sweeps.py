"""Pictures of sweeps and their parts."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Protocol

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.canvas.window import Scale
from exactsweep.draw.figure import require_matplotlib
from exactsweep.draw.intervals import Ends, SweepFeatures, cut_trajectory
from exactsweep.draw.picture import Picture, draw_with_details, find_details
from exactsweep.evidence.sweep import SweepAnswer
from exactsweep.evidence.undercut import Undercut
from exactsweep.geometry.point_set import is_on
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_point
from exactsweep.geometry.region import AnyPolygon
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import Fit, Point

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_MAX_SHOWN = 4
_MAX_MARKED_FITS = 60


class Moving(Protocol):
    """A Sweep, or the shapes of a no-fit polygon or an inner fit."""

    @property
    def generatrix(self) -> AnyPolygon: ...

    @property
    def directrix(self) -> AnyPolygon: ...

    @property
    def reference(self) -> Point: ...


@explain_type_errors
def plot_sweep(
    s: SweepAnswer,
    axes: Axes | None = None,
    *,
    positions: Iterable[Iterable[object]] | None = None,
    y_down: bool = False,
) -> Axes:
    """Draw a sweep: polygons, loops, undercuts, exact fits, and the trajectory by contact event.

    If the reference point is far from G, the picture shows the path of G's first vertex instead.
    For enlarged details, see `find_details`.

    Args:
        s: a Sweep.
        axes: a matplotlib Axes; by default, those of a new pyplot figure.
        positions: positions at which to draw G, as pairs of numbers; by default those of
            `choose_telling_positions`.
        y_down: whether Y points down, as in SVG viewers.

    Raises:
        DrawError: matplotlib is not installed.
        PolygonError, NumberError: a position is not a pair of numbers.

    Cost: linear in the size of the loops, contacts and undercuts, plus the cost of computing them.

    Example:
        >>> from exactsweep import sweep
        >>> from exactsweep.draw import make_figure
        >>> s = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (3, 0), (0, 3)])
        >>> axes = plot_sweep(s, make_figure().axes[0], positions=[(3, "-1/2")])
        >>> [text.get_text() for text in axes.get_legend().get_texts()][:2]
        ['swept area', 'directrix D']
    """
    axes = axes or make_axes()
    places = choose_telling_positions(s) if positions is None else read_positions(positions)
    placed = [place_generatrix(s, place) for place in places]
    spots = find_spots(s, places)

    def paint(picture: Picture) -> None:
        draw_loops(picture, s)
        draw_undercuts(picture, s.undercuts)
        draw_trajectory(picture, s)
        draw_exact_fits(picture, s, s.exact_fits, [s.trajectory])
        draw_generatrix(picture, s, places)
        draw_spots(picture, spots)

    shown = [*s.outer.vertices, *trace_anchor(s).vertices, *(v for g in placed for v in g.vertices)]
    touching = [spot[0] for several in spots.values() for spot in several]
    details = find_details(shown, s.directrix, placed or [s.generatrix], touching)
    draw_with_details(Picture(axes, Scale.of(shown), y_down=y_down), details, paint)
    return axes


def make_axes() -> Axes:
    require_matplotlib()
    from matplotlib import pyplot

    with style.use_style():
        _, axes = pyplot.subplots(layout="compressed")
    return axes


def read_positions(positions: Iterable[Iterable[object]]) -> list[Point]:
    return [read_point(place, f"position {k}") for k, place in enumerate(positions)]


def find_anchor(s: Moving) -> Point:
    """Return the anchor, the point of G whose path is drawn.

    This is the reference point, or a vertex of G if the reference point is so far from G that both
    polygons would be tiny in the picture.
    """
    (left, bottom), (right, top) = s.generatrix.bounding_box
    low, high = s.directrix.bounding_box
    reach = max(right - left, top - bottom) + max(high.x - low.x, high.y - low.y)
    x, y = s.reference
    near = left - reach <= x <= right + reach and bottom - reach <= y <= top + reach
    return s.reference if near else s.generatrix.vertices[0]


def name_anchor(s: Moving) -> str:
    if find_anchor(s) == s.reference:
        return "reference point of G"
    return f"vertex {s.generatrix.vertex_index(0)} of G"


def find_shift(s: Moving) -> Point:
    x, y = find_anchor(s)
    return Point(x - s.reference.x, y - s.reference.y)


def trace_anchor(s: SweepAnswer) -> Polygon:
    return s.trajectory.translated(find_shift(s))


@explain_type_errors
def place_generatrix(s: Moving, position: Point) -> AnyPolygon:
    """Return G with its reference point at a position."""
    return s.generatrix.translated((position.x - s.reference.x, position.y - s.reference.y))


@explain_type_errors
def choose_telling_positions(s: SweepAnswer) -> list[Point]:
    """Choose up to four positions to draw, far from each other.

    Candidates are positions that close undercuts, inner ends of exact fits, and the first vertex of
    the trajectory.
    """
    corner = s.trajectory.vertices[0]
    closing = [undercut.positions[0] for undercut in s.undercuts]
    found = _choose_distant(closing, [corner], _MAX_SHOWN - 2)
    inside = [end for _, end in s.exact_fits]
    found += _choose_distant(inside, [corner, *found], _MAX_SHOWN - 1 - len(found))
    return list(dict.fromkeys([*found, corner]))


def _choose_distant(points: Iterable[Point], others: Iterable[Point], most: int) -> list[Point]:
    """Choose points greedily, each as far as possible from all others."""
    far = list(others)
    listed = list(dict.fromkeys(points))
    off = {p: min(_square(p, other) for other in far) for p in listed}
    found: list[Point] = []
    while off and len(found) < most:
        best = max(off, key=off.__getitem__)
        found.append(best)
        off = {p: min(least, _square(p, best)) for p, least in off.items() if p != best}
    return found


def _square(p: Point, q: Point) -> Fraction:
    return (p.x - q.x) ** 2 + (p.y - q.y) ** 2


@explain_type_errors
def draw_loops(picture: Picture, s: SweepAnswer) -> None:
    """Draw the swept area, the loops and the directrix."""
    outer, inner = s.outer.vertices, s.inner.vertices
    unswept = [loop.vertices for loop in s.unswept]
    picture.shape([outer, inner, *unswept], style.SWEPT, "swept area")
    draw_shape(picture, s.directrix, style.DIRECTRIX, "directrix D")
    picture.line(inner, style.INNER, "inner loop", closed=True)
    for hole in unswept:
        picture.line(hole, style.INNER, "inner loop", closed=True)
    picture.line(outer, style.OUTER, "outer loop", closed=True)


@explain_type_errors
def draw_shape(picture: Picture, shape: AnyPolygon, look: Look, label: str | None = None) -> None:
    """Draw a polygon with its holes."""
    picture.shape(shape.rings, look, label)


@explain_type_errors
def draw_undercuts(picture: Picture, undercuts: Iterable[Undercut]) -> None:
    """Hatch undercuts."""
    for undercut in undercuts:
        picture.area(undercut.polygon.vertices, style.UNDERCUT, "undercut")


@explain_type_errors
def draw_trajectory(picture: Picture, s: SweepAnswer) -> None:
    """Draw the path of the anchor, styled by contact event."""
    of = "trajectory" if find_anchor(s) == s.reference else f"path of {name_anchor(s)}"
    chains: dict[str, list[list[Point]]] = {}
    last = None
    for interval in cut_trajectory(s):
        start, end = move_to_anchor((interval.start, interval.end), s)
        if interval.event != last:
            chains.setdefault(interval.event, []).append([start])
        chains[interval.event][-1].append(end)
        last = interval.event
    for event, look in style.EVENTS.items():
        if event in chains:
            picture.lines(chains[event], look, f"{of}, {event}")
    if "several" in chains:
        picture.lines(chains["several"], style.SEVERAL_EVENTS, f"{of}, several events")


@explain_type_errors
def draw_exact_fits(
    picture: Picture, s: Moving, fits: Iterable[Fit], loops: Iterable[Polygon]
) -> None:
    """Draw exact fits as positions of the anchor, with hollow markers at ends on a loop.

    More than 60 segments become thin lines without markers; single positions become stars.
    """
    segments, points = split_fits(fits)
    if segments:
        look = style.MANY_EXACT_FITS if len(segments) > _MAX_MARKED_FITS else style.EXACT_FIT
        picture.lines([move_to_anchor(fit, s) for fit in segments], look, "exact fit")
    if 0 < len(segments) <= _MAX_MARKED_FITS:
        ends = [
            [p]
            for p in dict.fromkeys(p for fit in segments for p in fit)
            if any(is_on(p, loop.vertices) for loop in loops)
        ]
        picture.lines([move_to_anchor(end, s) for end in ends], style.HANGING_END)
    if points:
        picture.lines(
            [move_to_anchor([p], s) for p in points], style.POINT_FIT, "exact fit, one position"
        )


def split_fits(fits: Iterable[Fit]) -> tuple[list[Fit], list[Point]]:
    """Split exact fits into segments and single positions."""
    listed = list(fits)
    return [fit for fit in listed if fit[0] != fit[1]], [p for p, q in listed if p == q]


def move_to_anchor(points: Iterable[Point], s: Moving) -> list[Point]:
    """Convert positions of the reference point to positions of the anchor."""
    dx, dy = find_shift(s)
    return [Point(p.x + dx, p.y + dy) for p in points]


@explain_type_errors
def draw_generatrix(
    picture: Picture, s: Moving, positions: Iterable[Point], label: str = "generatrix G"
) -> None:
    """Draw G at positions of its reference point, with a dot at the anchor."""
    dots = []
    for position in positions:
        draw_shape(picture, place_generatrix(s, position), style.GENERATRIX, label)
        dots.append(move_to_anchor([position], s))
    if dots:
        picture.lines(dots, style.REFERENCE, name_anchor(s))


@explain_type_errors
def draw_contacts(picture: Picture, s: SweepAnswer, positions: Iterable[Point]) -> None:
    """Mark the contacts of G and D at positions of the reference point."""
    draw_spots(picture, find_spots(s, positions))


def find_spots(s: SweepAnswer, positions: Iterable[Point]) -> dict[str, list[Ends]]:
    features = SweepFeatures(s)
    spots: dict[str, list[Ends]] = {}
    for position in positions:
        for contact in s.contacts_at(position):
            spots.setdefault(contact.event, []).append(features.spot(contact, position))
    return spots


def draw_spots(picture: Picture, spots: Mapping[str, list[Ends]]) -> None:
    for event, look in style.CONTACTS.items():
        if event in spots:
            picture.lines(spots[event], look, f"contact, {event}")
