"""Reader of GeoJSON (RFC 7946): Polygons with holes, at any depth."""

from collections.abc import Iterator, Mapping
from functools import partial
from typing import Any

from exactsweep.formats.candidate import Candidate, allow_faults
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import describe_kind, read_vertices
from exactsweep.formats.node import JsonNode
from exactsweep.numbers.number import Point

_MAX_DEPTH = 100
_VERTICES = "a list of vertices"


def read_geojson(
    document: Mapping[str, object], path: str = "$", notes: dict[str, None] | None = None
) -> list[Candidate]:
    """Find the Polygons of a document parsed by `parse_json`, named by their Feature ids.

    Other geometries and open rings become rejected candidates. Raises FormatError for malformed
    collections and ids.
    """
    found = _read(JsonNode(document, path), None, 0, {} if notes is None else notes)
    return [*allow_faults(found)]


def _read(
    node: JsonNode, name: str | None, depth: int, notes: dict[str, None]
) -> Iterator[Candidate]:
    if not isinstance(node.value, dict):
        yield Candidate.refused(f"{node.path} is {describe_kind(node.value)}, not a Polygon", name)
        return
    if depth > _MAX_DEPTH:
        raise FormatError("nested too deeply")
    kind = node.get("type", None).value
    if kind == "Feature":
        name = node.get("id", None).id
        yield from _read(node.get("geometry", None), name, depth + 1, notes)
    elif kind == "Polygon":
        yield _outline(node.get("coordinates", None), name, notes)
    elif kind == "MultiPolygon":
        for rings in node.get("coordinates", None).each():
            yield _outline(rings, name, notes)
    elif kind in ("FeatureCollection", "GeometryCollection"):
        member = "features" if kind == "FeatureCollection" else "geometries"
        for part in node.get(member, None).each():
            yield from _read(part, name, depth + 1, notes)
    else:
        yield Candidate.refused(f"{node.path}.type is {describe_kind(kind)}, not 'Polygon'", name)


def _outline(node: JsonNode, name: str | None, notes: dict[str, None]) -> Candidate:
    try:
        rings = [*node.each("a list of rings")]
        level = [JsonNode(_drop_heights(ring.entries(_VERTICES)), ring.path) for ring in rings]
    except FormatError as error:
        return Candidate.refused(error, name)
    if not rings:
        return Candidate.refused(f"{node.path} is empty", name)
    if level != rings:
        notes["third coordinates (heights) are ignored"] = None
    readers = ((ring.path, partial(_ring, *ring)) for ring in level)
    return Candidate.of_rings(readers, node.path, name)


def _drop_heights(ring: list[Any]) -> list[Any]:
    return [p[:2] if isinstance(p, list) and len(p) == 3 else p for p in ring]


def _ring(value: object, path: str) -> list[Point]:
    ring = read_vertices(value, path)
    if not ring:
        raise FormatError(f"{path} is empty")
    if ring[0] != ring[-1]:
        raise FormatError(f"{path} is not closed: the last vertex must repeat the first")
    return ring
