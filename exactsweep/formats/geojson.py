"""A reader of GeoJSON (RFC 7946): Polygons with their holes, at any depth of a document."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial

from exactsweep.formats.candidate import Candidate, allow_faults
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import describe_kind, read_name, read_vertices
from exactsweep.numbers.point import Point

_MAX_DEPTH = 100


def read_geojson(
    document: Mapping[str, object], path: str = "$", notes: dict[str, None] | None = None
) -> list[Candidate]:
    """Find the polygons of a GeoJSON document.

    Args:
        document: an object with a "type", as `parse_json` returns it.
        path: its JSON path, for messages.
        notes: collects notes of ignored parts. Without it, third coordinates are refused.

    Returns:
        list with a Candidate for each Polygon, named by the id of its Feature. Candidates of other
        geometries refuse, and so do those of Polygons with an open ring. Third coordinates, which
        are heights, are ignored.

    Raises:
        FormatError: an id is neither a string nor a number, a collection has no list, or the
            document is nested too deeply; the message starts with the JSON path.

    Cost: linear.

    Example:
        >>> ring = [["0", "0"], ["1", "0"], ["0", "1"], ["0", "0"]]
        >>> (outline,) = read_geojson({"type": "Polygon", "coordinates": [ring]})
        >>> len(outline.vertices())
        4
    """
    return allow_faults(_read(document, path, None, 0, notes))


def _read(
    value: object, path: str, name: str | None, depth: int, notes: dict[str, None] | None
) -> Iterator[Candidate]:
    if not isinstance(value, dict):
        yield Candidate.refused(f"{path} is {describe_kind(value)}, not a Polygon", name)
        return
    kind = value.get("type")
    if depth > _MAX_DEPTH:
        raise FormatError("nested too deeply")
    if kind == "Feature":
        name = read_name(value.get("id"), f"{path}.id")
        yield from _read(value.get("geometry"), f"{path}.geometry", name, depth + 1, notes)
    elif kind == "Polygon":
        yield _outline(value.get("coordinates"), f"{path}.coordinates", name, notes)
    elif kind == "MultiPolygon":
        for k, rings in enumerate(_list(value, "coordinates", path)):
            yield _outline(rings, f"{path}.coordinates[{k}]", name, notes)
    elif kind in ("FeatureCollection", "GeometryCollection"):
        member = "features" if kind == "FeatureCollection" else "geometries"
        for k, part in enumerate(_list(value, member, path)):
            yield from _read(part, f"{path}.{member}[{k}]", name, depth + 1, notes)
    else:
        yield Candidate.refused(f"{path}.type is {describe_kind(kind)}, not 'Polygon'", name)


def _list(value: Mapping[str, object], member: str, path: str) -> list[object]:
    found = value.get(member)
    if not isinstance(found, list):
        raise FormatError(f"{path}.{member} is {describe_kind(found)}, not a list")
    return found


def _outline(
    rings: object, path: str, name: str | None, notes: dict[str, None] | None
) -> Candidate:
    """Make the outline of the rings of a Polygon."""
    if not isinstance(rings, list):
        return Candidate.refused(f"{path} is {describe_kind(rings)}, not a list of rings", name)
    for k, ring in enumerate(rings):
        if not isinstance(ring, list):
            return Candidate.refused(
                f"{path}[{k}] is {describe_kind(ring)}, not a list of vertices", name
            )
    if not rings:
        return Candidate.refused(f"{path} is empty", name)
    if notes is not None:
        level = [[_drop_height(position) for position in ring] for ring in rings]
        if level != rings:
            notes["third coordinates, which are heights, are ignored"] = None
        rings = level
    places = ((f"{path}[{k}]", ring) for k, ring in enumerate(rings))
    readers = ((place, partial(_ring, ring, place)) for place, ring in places)
    return Candidate.of_rings(readers, path, name)


def _drop_height(position: object) -> object:
    return position[:2] if isinstance(position, list) and len(position) == 3 else position


def _ring(value: object, path: str) -> list[Point]:
    ring = read_vertices(value, path)
    if not ring:
        raise FormatError(f"{path} is empty")
    if ring[0] != ring[-1]:
        raise FormatError(f"{path} is not closed: the last vertex must repeat the first")
    return ring
