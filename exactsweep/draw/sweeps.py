"""The picture of a sweep, and the pictures of its parts from which it is made."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.canvas.scale import Scale
from exactsweep.draw.features import Features, Span
from exactsweep.draw.figure import require_matplotlib
from exactsweep.draw.picture import Picture
from exactsweep.draw.stretches import stretches
from exactsweep.geometry.point import Point
from exactsweep.geometry.polygon import Polygon, read_point

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from exactsweep.evidence.swept import Swept
    from exactsweep.evidence.undercut import Undercut

_MOST_SHOWN = 4
_MANY = 60


def plot_sweep(
    s: Swept, axes: Axes | None = None, *, positions: Iterable[Iterable[object]] | None = None
) -> Axes:
    """Draw a sweep: both polygons, the loops, undercuts, exact fits, the trajectory by event.

    Args:
        s: a Sweep.
        axes: an Axes of matplotlib; a new figure of `matplotlib.pyplot` if left out.
        positions: pairs of numbers, where the reference point of G is when G is drawn; if left
            out, those of `telling_positions`.

    Returns:
        The Axes. Where the reference point is far from G, the path that is drawn is that of the
        first vertex of G, and the legend says so.

    Raises:
        DrawError: matplotlib is not installed.
        PolygonError, NumberError: a position is not a pair of numbers.

    Cost: that of the loops, the contacts and the undercuts, and linear in their sizes.

    Example:
        >>> from exactsweep import sweep
        >>> from exactsweep.draw import new_figure
        >>> s = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (3, 0), (0, 3)])
        >>> axes = plot_sweep(s, new_figure().axes[0], positions=[(3, "-1/2")])
        >>> [text.get_text() for text in axes.get_legend().get_texts()][:2]
        ['swept area', 'directrix D']
    """
    require_matplotlib()
    if positions is None:
        places: Sequence[Point] = telling_positions(s)
    else:
        places = [read_point(place, f"position {k}") for k, place in enumerate(positions)]
    if axes is None:
        from matplotlib import pyplot

        with style.in_style():
            _, axes = pyplot.subplots(layout="compressed")
    placed = [placed_generatrix(s, place).vertices for place in places]
    picture = Picture(axes, Scale.of(s.outer.vertices, path(s).vertices, *placed))
    draw_loops(picture, s)
    draw_undercuts(picture, s.undercuts)
    draw_trajectory(picture, s)
    draw_exact_fits(picture, s)
    draw_generatrix(picture, s, places)
    draw_contacts(picture, s, places)
    picture.legend()
    return axes


def anchor(s: Swept) -> Point:
    """Return the point of G whose path is drawn: the reference point, or a vertex of G.

    A vertex where the reference point is off G by more than the sizes of G and D together: its
    path would be far from both polygons, which would shrink to points.

    >>> from exactsweep import sweep
    >>> triangle, far = [(0, 0), (1, 0), (0, 1)], [(99, 0), (100, 0), (99, 1)]
    >>> anchor(sweep(triangle, triangle)) == (0, 0), anchor(sweep(far, triangle)) == (99, 0)
    (True, True)
    """
    (left, bottom), (right, top) = s.generatrix.bounding_box
    low, high = s.directrix.bounding_box
    room = max(right - left, top - bottom) + max(high.x - low.x, high.y - low.y)
    x, y = s.reference
    near = left - room <= x <= right + room and bottom - room <= y <= top + room
    return s.reference if near else s.generatrix.vertices[0]


def anchor_name(s: Swept) -> str:
    """Return what the anchor is, in words."""
    if anchor(s) == s.reference:
        return "reference point of G"
    return f"vertex {s.generatrix.vertex_index(0)} of G"


def shift(s: Swept) -> Point:
    """Return the vector from a position of the reference point to that of the anchor."""
    x, y = anchor(s)
    return Point(x - s.reference.x, y - s.reference.y)


def path(s: Swept) -> Polygon:
    """Return the trajectory of the anchor."""
    return s.trajectory.translated(shift(s))


def placed_generatrix(s: Swept, position: Point) -> Polygon:
    """Return G with its reference point at a position."""
    return s.generatrix.translated((position.x - s.reference.x, position.y - s.reference.y))


def telling_positions(s: Swept) -> list[Point]:
    """Choose positions worth drawing: in undercuts and exact fits, and at a corner.

    Returns:
        list of Point: where G closes each of the first undercuts, the inner ends of the first
        exact fits, and the first vertex of the trajectory; four at most.
    """
    found = [undercut.positions[0] for undercut in s.undercuts[: _MOST_SHOWN - 2]]
    found += [inside for _, inside in s.exact_fits[: _MOST_SHOWN - 1 - len(found)]]
    return list(dict.fromkeys([*found, s.trajectory.vertices[0]]))


def draw_loops(picture: Picture, s: Swept) -> None:
    """Draw the swept area between the inner and the outer loop, and the directrix."""
    outer, inner = s.outer.vertices, s.inner.vertices
    picture.ring(outer, inner, style.SWEPT, "swept area")
    picture.area(s.directrix.vertices, style.DIRECTRIX, "directrix D")
    picture.line(inner, style.INNER, "inner loop", closed=True)
    picture.line(outer, style.OUTER, "outer loop", closed=True)


def draw_undercuts(picture: Picture, undercuts: Iterable[Undercut]) -> None:
    """Hatch undercuts."""
    for undercut in undercuts:
        picture.area(undercut.polygon.vertices, style.UNDERCUT, "undercut")


def draw_trajectory(picture: Picture, s: Swept) -> None:
    """Draw the path of the anchor, each stretch as its contact event has it."""
    dx, dy = shift(s)
    of = "trajectory" if anchor(s) == s.reference else f"path of {anchor_name(s)}"
    chains: dict[str, list[list[Point]]] = {}
    last = None
    for stretch in stretches(s):
        start, end = (Point(p.x + dx, p.y + dy) for p in (stretch.start, stretch.end))
        if stretch.event != last:
            chains.setdefault(stretch.event, []).append([start])
        chains[stretch.event][-1].append(end)
        last = stretch.event
    for event, look in style.EVENTS.items():
        if event in chains:
            picture.lines(chains[event], look, f"{of}, {event}")
    if "several" in chains:
        picture.lines(chains["several"], style.SEVERAL_EVENTS, f"{of}, several events")


def draw_exact_fits(picture: Picture, s: Swept) -> None:
    """Mark exact fits as positions of the anchor, hollow where they hang on the trajectory.

    Many are thin lines without marks, so that they do not hide each other.
    """
    dx, dy = shift(s)
    fits = [[Point(p.x + dx, p.y + dy) for p in fit] for fit in s.exact_fits]
    if len(fits) > _MANY:
        picture.lines(fits, style.MANY_EXACT_FITS, "exact fit")
    elif fits:
        picture.lines(fits, style.EXACT_FIT, "exact fit")
        picture.lines([[hanging] for hanging, _ in fits], style.HANGING_END)


def draw_generatrix(picture: Picture, s: Swept, positions: Iterable[Point]) -> None:
    """Draw G with its reference point at each of some positions, and dots where the anchor is."""
    dx, dy = shift(s)
    dots = []
    for position in positions:
        loop = placed_generatrix(s, position).vertices
        picture.area(loop, style.GENERATRIX, "generatrix G")
        dots.append([Point(position.x + dx, position.y + dy)])
    if dots:
        picture.lines(dots, style.REFERENCE, anchor_name(s))


def draw_contacts(picture: Picture, s: Swept, positions: Iterable[Point]) -> None:
    """Mark where G touches D when its reference point is at each of some positions."""
    features = Features(s)
    spots: dict[str, list[Span]] = {}
    for position in positions:
        for contact in s.contacts_at(position):
            spots.setdefault(contact.event, []).append(features.spot(contact, position))
    for event, look in style.CONTACTS.items():
        if event in spots:
            picture.lines(spots[event], look, f"contact, {event}")
