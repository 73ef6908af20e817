"""Data of the page: exactly scaled coordinates as floats, and exact coordinates as text.

A stop is a vertex of a track, or a point of an edge at which a contact begins or ends, two vertices
meet, or G closes an undercut. Contacts are constant between stops. For large pairs, VV contacts
inside edges are not stops. The page computes the contacts at a stop.

Inside an edge of a loop, the only momentary contacts are VV, vertex on vertex: the positions at
which two given features touch form a segment that does not cross the loop, so only an end of it can
touch the loop, with a VV contact.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from math import inf
from typing import Any, NamedTuple

from exactsweep.draw import ContactInterval, DrawError, Scale
from exactsweep.draw.intervals import cut_loops
from exactsweep.draw.no_fits import Positions
from exactsweep.draw.sweeps import Moving, find_anchor, move_to_anchor, name_anchor, trace_anchor
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.no_fit import InnerFitAnswer, NoFitAnswer
from exactsweep.evidence.sweep import SweepAnswer
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.region import AnyPolygon, share_lattice, to_region
from exactsweep.geometry.vectors import cross, minus, orientation
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import Fit, Point
from exactsweep.text.results import list_indices
from exactsweep.words import CLASSES

# The numbers of vertex pairs, and of tests of a pair with an edge, that take about a second.
_MAX_PAIRS, _MAX_TESTS = 250_000, 4_000_000


class Meetings:
    """The positions of VV contact without overlap nearby.

    `others` are additional stationary shapes; `inside` is true for inner fits. Cost:
    O((m + n) log(m + n) + p log p) for p pairs of an edge and a vertex that can touch without
    overlap; p is O(m + n) for convex polygons, and O(mn) in general.
    """

    def __init__(
        self, s: Moving, others: Sequence[AnyPolygon] = (), *, inside: bool = False
    ) -> None:
        self.reference = s.reference
        shapes = [to_region(shape, "") for shape in (s.generatrix, s.directrix, *others)]
        self.scale, (moving, around, *placed) = share_lattice(shapes)
        g = Outline(moving)
        translations = set()
        for rings in ([ring[::-1] for ring in around] if inside else around, *placed):
            d = Outline(rings)
            pairs = set()
            for i, j in find_facing(g, d):
                pairs |= {(i, j), (g.after[i], j)}
            for j, i in find_facing(d, g):
                pairs |= {(i, j), (i, d.after[j])}
            translations |= {minus(d.vertices[j], g.vertices[i]) for i, j in pairs}
        self.translations = sorted(translations)

    def on_edges(self, loop: Sequence[Point]) -> list[Point]:
        """Return the sorted meetings inside edges of a loop of free positions."""
        (rx, ry), scale = self.reference, self.scale
        corners = [((x - rx) * scale, (y - ry) * scale) for x, y in loop]
        found = set()
        for p, q in pairwise([*corners, corners[0]]):
            low, high = sorted((p, q))
            start = bisect_right(self.translations, low)
            for x, y in self.translations[start : bisect_left(self.translations, high)]:
                if not orientation(low, high, (x, y)):
                    found.add(Point(Fraction(x, scale) + rx, Fraction(y, scale) + ry))
        return sorted(found)


def find_meetings(
    s: Moving, corners: int, others: Sequence[AnyPolygon] = (), *, inside: bool = False
) -> Meetings | None:
    """Return the VV contacts, or None if the search would take more than a second."""
    if len(s.generatrix) * sum(map(len, (s.directrix, *others))) > _MAX_PAIRS:
        return None
    found = Meetings(s, others, inside=inside)
    return found if len(found.translations) * corners <= _MAX_TESTS else None


def find_facing(shape: Outline, outline: Outline) -> Iterator[tuple[int, int]]:
    """Yield the pairs of an edge of one polygon and a vertex of another that can touch.

    The vertex must be convex, and the direction of the reversed edge must lie between those of the
    two edges at the vertex. Cost: O((m + n) log n + pairs) for n edges and m vertices.

    >>> square, steep = Outline([[(0, 0), (1, 0), (1, 1), (0, 1)]]), Outline([[(1, 0), (0, 1)]])
    >>> sorted(pair for pair in find_facing(steep, square) if pair[0] == 0)
    [(0, 0)]
    """
    # Slopes of edges at most 2**n wide differ by at least 4**-n: ints in that unit keep the order.
    widths = [piece.direction[0] for o in (shape, outline) for piece in o.pieces]
    bits = 2 * max(widths).bit_length()

    def angle(o: Outline, k: int, *, reverse: bool) -> tuple[bool, float]:
        """Return a key that orders directed edges by angle, starting just above -90 degrees."""
        a, b = o.pieces[k].direction
        p, q = o.edge(k)
        return (p > q) != reverse, (b << bits) // a if a else inf

    order = sorted((angle(shape, i, reverse=True), i) for i in range(len(shape.vertices)))
    angles = [key for key, _ in order]
    directions = [angle(outline, k, reverse=False) for k in range(len(outline.vertices))]
    for j, into in enumerate(outline.before):
        first, last = directions[into], directions[j]
        if (cross(outline.pieces[into].direction, outline.pieces[j].direction) > 0) == (
            first[0] == last[0]
        ):
            start, end = bisect_left(angles, first), bisect_right(angles, last)
            found = order[start:end] if first <= last else order[start:] + order[:end]
            for _, i in found:
                yield i, j


class Track(NamedTuple):
    """A loop of positions along which G moves, or an exact fit, traced back and forth."""

    name: str
    corners: Sequence[Point]


class Stop(NamedTuple):
    """A position, its index in the track if a vertex, and the contacts up to the next stop."""

    position: Point
    vertex: int | None
    contacts: tuple[Contact, ...]


def list_tracks(s: SweepAnswer) -> list[Track]:
    loops = [s.trajectory.vertices, *(hole.vertices for hole in s.no_fit_holes)]
    return _name_tracks(loops, s.exact_fits, "the trajectory")


def _name_tracks(
    loops: Sequence[Sequence[Point]], fits: Iterable[Fit], first: str = ""
) -> list[Track]:
    """Name loops and exact fits; `first` names the first loop if it is the exterior."""
    found = [Track(first, loops[0])] if first else []
    word = "hole" if first else "loop"
    found += [Track(f"{word} {k}", loop) for k, loop in enumerate(loops[len(found) :])]
    ends = (tuple(dict.fromkeys(fit)) for fit in fits)
    return [*found, *(Track(f"exact fit {k}", corners) for k, corners in enumerate(ends))]


def track_stops(s: SweepAnswer, listed: Sequence[Track]) -> tuple[list[list[Stop]], bool]:
    """Return the stops of each track, and whether all VV contacts are included."""
    meetings = find_meetings(s, sum(len(track.corners) for track in listed))
    loops = [track.corners for track in listed if len(track.corners) > 1]
    return _cut_tracks(listed, cut_loops(s, loops), _landmarks(s), meetings), meetings is not None


def _cut_tracks(
    listed: Iterable[Track],
    intervals: Iterator[list[ContactInterval]],
    landmarks: Sequence[Point],
    meetings: Meetings | None,
) -> list[list[Stop]]:
    found = []
    for _, corners in listed:
        if len(corners) == 1:
            found.append([Stop(corners[0], 0, ())])
            continue
        pieces = _cut(next(intervals), landmarks)
        if meetings is not None:
            pieces = _cut(pieces, meetings.on_edges(corners))
        found.append(
            [
                Stop(start, edge if start == corners[edge] else None, contacts)
                for edge, start, _, contacts in pieces
            ]
        )
    return found


def gather_page_data(
    s: SweepAnswer,
    *,
    names: tuple[str, str] | None = None,
    y_down: bool = False,
    progress: Callable[[str], object] = str,
) -> dict[str, Any]:
    """Collect the JSON data for a Sweep's page; for the arguments see `make_page`.

    Scaled coordinates are flat lists x, y, x, y, ... of floats, for G relative to the anchor.
    "exact" holds the coordinates as strings, in the same order.
    """
    progress("the loops")
    outer, moved = s.outer.vertices, trace_anchor(s).vertices
    scale = Scale.of(outer, moved)
    progress("exact fits")
    listed = list_tracks(s)
    progress("undercuts")
    closed = s.undercuts
    progress(f"contacts along {sum(len(track.corners) for track in listed)} edges")
    found, has_meetings = track_stops(s, listed)
    number = {stop.position: k for k, stop in enumerate(found[0])}
    stops = {track.name: on_track for track, on_track in zip(listed, found, strict=True)}
    return (
        gather_shapes(s, scale, names, "Sweep", y_down)
        | _gather_tracks(s, scale, stops, s.exact_fits, outside=1)
        | {
            "class": CLASSES[s.kind],
            "asked": "sweep",
            "area": format_fraction(s.area),
            "areaName": "Swept area",
            "hasMeetings": has_meetings,
            "inner": show_points(scale, s.inner.vertices),
            "outer": show_points(scale, outer),
            "unswept": [show_points(scale, loop.vertices) for loop in s.unswept],
            "undercuts": [
                {
                    **show_points(scale, undercut.polygon.vertices),
                    "area": format_fraction(undercut.polygon.area),
                    "slides": undercut.intersection == "segment",
                    "extremes": [format_fraction(c) for p in undercut.extremes for c in p],
                    "stops": [number[position] for position in undercut.positions],
                }
                for undercut in closed
            ],
        }
    )


def gather_positions(
    found: NoFitAnswer | InnerFitAnswer,
    *,
    names: tuple[str, str] | None = None,
    y_down: bool = False,
) -> dict[str, Any]:
    """Collect the JSON data for the page of a no-fit polygon or an inner fit.

    Stops are the vertices of loops, ends of exact fits on loops, and VV contacts.
    """
    shapes = Positions.of(found)
    is_outside = shapes.exterior is not None
    loops = [loop.vertices for loop in shapes.loops]
    listed = _name_tracks(loops, shapes.exact_fits, "the exterior" if is_outside else "")
    if not listed:
        raise DrawError("there is no position: the part does not fit")
    paths = [p for track in listed for p in move_to_anchor(track.corners, shapes)]
    scale = Scale.of(shapes.directrix.vertices, paths)
    meetings = find_meetings(shapes, len(paths), shapes.placed, inside=not is_outside)
    edges = (enumerate(pairwise([*c, c[0]])) for _, c in listed if len(c) > 1)
    intervals = ([ContactInterval(k, *edge, ()) for k, edge in around] for around in edges)
    landmarks = sorted({end for fit in shapes.exact_fits for end in fit})
    found_stops = _cut_tracks(listed, intervals, landmarks, meetings)
    stops = {track.name: on_track for track, on_track in zip(listed, found_stops, strict=True)}
    where, title = ("around", "No-fit polygon") if is_outside else ("in", "Inner fit")
    return {
        **gather_shapes(shapes, scale, names, title, y_down, where),
        **_gather_tracks(shapes, scale, stops, shapes.exact_fits, outside=int(is_outside)),
        "class": "",
        "asked": "positions",
        "area": format_fraction(found.area),
        "areaName": "Area of overlap" if is_outside else "Area of free positions",
        "hasMeetings": meetings is not None,
        "inner": show_points(scale, []),
        "outer": show_points(scale, []),
        "unswept": [],
        "undercuts": [],
    }


def _gather_tracks(
    s: Moving,
    scale: Scale,
    stops: Mapping[str, Sequence[Stop]],
    fits: Sequence[Fit],
    *,
    outside: int,
) -> dict[str, Any]:
    """Collect the tracks, loops first, and the exact fits; "hangs" marks ends on loops."""
    loops = len(stops) - len(fits)
    on_loops = {stop.position for on_track in [*stops.values()][:loops] for stop in on_track}
    return {
        "loops": loops,
        "outside": outside,
        "tracks": [
            {
                "name": name,
                **show_positions(s, scale, [stop.position for stop in on_track]),
                "vertex": [stop.vertex for stop in on_track],
                "contacts": [stop.contacts for stop in on_track],
            }
            for name, on_track in stops.items()
        ],
        "fits": [
            {**show_positions(s, scale, fit), "hangs": [end in on_loops for end in fit]}
            for fit in fits
        ],
    }


def gather_shapes(
    s: Moving,
    scale: Scale,
    names: tuple[str, str] | None,
    title: str,
    y_down: bool,
    where: str = "around",
) -> dict[str, Any]:
    called = f"{title} of " if names is None else f"{f' {where} '.join(names)}: "
    return {
        "title": f"{called}{len(s.generatrix)} {where} {len(s.directrix)} vertices",
        "names": names,
        "down": y_down,
        "axes": [
            {"origin": format_fraction(axis.origin), "exponent": axis.exponent}
            for axis in scale[:2]
        ],
        "stretched": not scale.is_true,
        "path": "" if find_anchor(s) == s.reference else name_anchor(s),
        "reference": [format_fraction(c) for c in s.reference],
        "generatrix": {**_around_anchor(s, scale), **_number(s.generatrix)},
        "directrix": {**show_points(scale, s.directrix.vertices), **_number(s.directrix)},
    }


def show_points(scale: Scale, points: Sequence[Point]) -> dict[str, Any]:
    places = [c for point in points for c in scale.place(point)]
    return {"places": places, "exact": _exact(points)}


def show_positions(s: Moving, scale: Scale, points: Sequence[Point]) -> dict[str, Any]:
    """Return scaled positions of the anchor, and exact positions of the reference point."""
    return {**show_points(scale, move_to_anchor(points, s)), "exact": _exact(points)}


def _exact(points: Sequence[Point]) -> list[str]:
    return [format_fraction(c) for point in points for c in point]


def _landmarks(s: SweepAnswer) -> list[Point]:
    ends = {end for fit in s.exact_fits for end in fit}
    return sorted(ends.union(*(undercut.positions for undercut in s.undercuts)))


def _cut(pieces: list[ContactInterval], inside: Sequence[Point]) -> list[ContactInterval]:
    found = []
    for piece in pieces:
        low, high = sorted((piece.start, piece.end))
        near = inside[bisect_right(inside, low) : bisect_left(inside, high)]
        cuts = [p for p in near if not orientation(low, high, p)]
        if low != piece.start:
            cuts.reverse()
        for end in [*cuts, piece.end]:
            found.append(piece._replace(end=end))
            piece = piece._replace(start=end)
    return found


def _around_anchor(s: Moving, scale: Scale) -> dict[str, Any]:
    (x, y), corners = find_anchor(s), s.generatrix.vertices
    units = scale.x.unit, scale.y.unit
    parts = (part for v in corners for part in ((v.x - x) / units[0], (v.y - y) / units[1]))
    return {"places": [*map(float, parts)], "exact": _exact(corners)}


def _number(shape: AnyPolygon) -> dict[str, list[int]]:
    return {**list_indices(shape), "rings": [len(ring) for ring in shape.rings]}
