"""What the page is given: places as floats, scaled exactly, and the exact coordinates as text.

A stop is a vertex of the trajectory, or a point of an edge where a contact begins or ends, where
two vertices meet or where an undercut is closed; from each stop to the next the same features
touch. In large sweeps, what touches for an instant only is not looked for. Holes of the no-fit
polygon and exact fits have stops as the trajectory has.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

from exactsweep.draw import Scale, Stretch, stretches
from exactsweep.draw.features import Features
from exactsweep.draw.sweeps import anchor, anchor_name, path, shift
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.swept import Swept
from exactsweep.geometry.number import format_fraction
from exactsweep.geometry.point import Point
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.view.touches import Meetings, brief_contacts, can_be_found
from exactsweep.words import CLASSES


class Track(NamedTuple):
    """Positions along which G can be moved.

    Attributes:
        name: what it is called.
        corners: the vertices of a loop; of an exact fit the ends, for the way there and back.
    """

    name: str
    corners: Sequence[Point]


class Stop(NamedTuple):
    """A position of the reference point, and the stretch of a track that begins there."""

    position: Point
    vertex: int | None
    brief: tuple[Contact, ...]
    contacts: tuple[Contact, ...]


def tracks(s: Swept) -> list[Track]:
    """List the trajectory, the holes of the no-fit polygon and the exact fits."""
    holes = [Track(f"hole {k}", hole.vertices) for k, hole in enumerate(s.no_fit_holes)]
    fits = [
        Track(f"exact fit {k}", tuple(dict.fromkeys(fit))) for k, fit in enumerate(s.exact_fits)
    ]
    return [Track("the trajectory", s.trajectory.vertices), *holes, *fits]


def stops(s: Swept) -> list[Stop]:
    """Find all stops of the trajectory, as `track_stops` does."""
    return next(track_stops(s, tracks(s)[:1]))


def track_stops(s: Swept, listed: Iterable[Track]) -> Iterator[list[Stop]]:
    """Find all stops of tracks, each all the way around from its first vertex.

    Yields:
        For each track a list of Stop: its `vertex` is its number in the track, None inside an edge;
        its `contacts` last from there to the next stop; its `brief` ones are those there that last
        neither up to it nor from it: all of them if `can_be_found`, else those of two vertices
        that meet there as ends of features in contact before or after.

    Cost: that of `Sweep.contacts`, `undercuts` and `exact_fits`, and O(u t) if u of their
    positions are inside one of t stretches; that of `Meetings` and of `Sweep.contacts_at` for each
    vertex if `can_be_found`.
    """
    features = Features(s)
    meetings = Meetings(s) if can_be_found(s) else None
    landmarks = _landmarks(s)
    for k, track in enumerate(listed):
        if len(track.corners) == 1:
            brief = brief_contacts(features, s.contacts_at(track.corners[0]), set())
            yield [Stop(track.corners[0], 0, tuple(sorted(brief)), ())]
            continue
        met = {} if meetings is None else meetings.on_edges(track.corners)
        cut = stretches(s, track.corners if k else None)
        pieces = _cut(cut, landmarks.union(met))
        found = []
        for i, (edge, start, _, contacts) in enumerate(pieces):
            around = {*contacts, *pieces[i - 1].contacts}
            vertex = edge if start == track.corners[edge] else None
            if meetings is None:
                brief = {m for c in around for m in features.meetings(c, start)}
            elif vertex is None:
                brief = set(met.get(start, ()))
            else:
                brief = brief_contacts(features, s.contacts_at(start), around)
            found.append(Stop(start, vertex, tuple(sorted(brief)), contacts))
        yield found


def page_data(s: Swept) -> dict[str, Any]:
    """Gather what the page shows, as plain JSON data.

    Returns:
        Places are flat lists x, y, x, y, ... of floats, those of G relative to the point whose
        path is drawn; "exact" are the coordinates in the same order as strings.

    Cost: that of `stops` and of the loops.
    """
    dx, dy = shift(s)
    outer, moved = s.outer.vertices, path(s).vertices
    scale = Scale.of(outer, moved)
    listed = tracks(s)
    found = list(track_stops(s, listed))
    number = {stop.position: k for k, stop in enumerate(found[0])}
    holes = len(s.no_fit_holes)
    on_loops = {stop.position for on_track in found[: holes + 1] for stop in on_track}

    def shown(points: Iterable[Point]) -> dict[str, Any]:
        points = list(points)
        return {
            "places": [c for point in points for c in scale.place(point)],
            "exact": [format_fraction(c) for point in points for c in point],
        }

    def positions(points: Iterable[Point]) -> dict[str, Any]:
        """Positions of the reference point, placed where the anchor is then."""
        points = list(points)
        placed = shown(Point(p.x + dx, p.y + dy) for p in points)["places"]
        return {"places": placed, "exact": [format_fraction(c) for p in points for c in p]}

    return {
        "title": f"Sweep of {len(s.generatrix)} around {len(s.directrix)} vertices",
        "class": CLASSES[s.kind],
        "area": format_fraction(s.area),
        "stretched": not scale.is_true,
        "allBrief": can_be_found(s),
        "path": "" if anchor(s) == s.reference else anchor_name(s),
        "reference": [format_fraction(c) for c in s.reference],
        "generatrix": {**_around_anchor(s, scale), **_numbers(s.generatrix)},
        "directrix": {**shown(s.directrix.vertices), **_numbers(s.directrix)},
        "inner": shown(s.inner.vertices),
        "outer": shown(outer),
        "unswept": [shown(loop.vertices) for loop in s.unswept],
        "holes": holes,
        "tracks": [
            {
                "name": track.name,
                **positions(stop.position for stop in on_track),
                "vertex": [stop.vertex for stop in on_track],
                "brief": [stop.brief for stop in on_track],
                "contacts": [stop.contacts for stop in on_track],
            }
            for track, on_track in zip(listed, found, strict=True)
        ],
        "undercuts": [
            {
                **shown(undercut.polygon.vertices),
                "area": format_fraction(undercut.polygon.area),
                "slides": undercut.intersection == "segment",
                "extremes": [format_fraction(c) for p in undercut.extremes for c in p],
                "stops": [number[position] for position in undercut.positions],
            }
            for undercut in s.undercuts
        ],
        "fits": [
            {**positions(fit), "hangs": [end in on_loops for end in fit]} for fit in s.exact_fits
        ],
    }


def _landmarks(s: Swept) -> set[Point]:
    ends = {end for fit in s.exact_fits for end in fit}
    return ends.union(*(undercut.positions for undercut in s.undercuts))


def _cut(pieces: list[Stretch], landmarks: set[Point]) -> list[Stretch]:
    """Cut stretches at those positions that are inside one."""
    inside = sorted(landmarks - {piece.start for piece in pieces})
    found = []
    for piece in pieces:
        low, high = sorted((piece.start, piece.end))
        near = inside[bisect_right(inside, low) : bisect_left(inside, high)]
        cuts = [p for p in near if _on_line(p, low, high)]
        if low != piece.start:
            cuts.reverse()
        for end in [*cuts, piece.end]:
            found.append(piece._replace(end=end))
            piece = piece._replace(start=end)
    return found


def _on_line(p: Point, a: Point, b: Point) -> bool:
    return (b.x - a.x) * (p.y - a.y) == (b.y - a.y) * (p.x - a.x)


def _around_anchor(s: Swept, scale: Scale) -> dict[str, Any]:
    x, y = anchor(s)
    corners = s.generatrix.vertices
    return {
        "places": [
            float(part)
            for v in corners
            for part in ((v.x - x) / scale.x.unit, (v.y - y) / scale.y.unit)
        ],
        "exact": [format_fraction(c) for v in corners for c in v],
    }


def _numbers(shape: Polygon | Region) -> dict[str, list[int]]:
    """The numbers that the caller gave the vertices and edges, and the sizes of the rings."""
    size = range(len(shape))
    return {
        "vertices": [shape.vertex_index(k) for k in size],
        "edges": [shape.edge_index(k) for k in size],
        "rings": [len(ring) for ring in shape.rings],
    }
