"""Reader of exact JSON and of GeoJSON (RFC 7946)."""

from collections.abc import Iterator, Mapping, Sequence
from functools import partial

from exactsweep.formats.candidate import Candidate, limit_faults
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import describe_kind, read_vertices
from exactsweep.formats.node import JsonNode
from exactsweep.numbers.number import Point

_MAX_DEPTH = 100  # of GeoJSON collections
_LOOPS = ("trajectory", "inner", "outer", "unswept", "regions")
_LISTS = ("unswept", "regions")
_RINGS = ("vertices", "exterior", "points", "polygon")


def find_candidates(
    document: object, path: str = "$", notes: dict[str, None] | None = None
) -> Sequence[Candidate]:
    if isinstance(document, dict) and "type" in document and "vertices" not in document:
        found = read_geojson(document, path, notes)
        return found if len(found) > 1 else [one._replace(place="") for one in found]
    return read_exact(document, path)


def read_exact(document: object, path: str = "$") -> list[Candidate]:
    """Find the polygons of an exact JSON document.

    A document is a polygon, a list of polygons, an object with such a list as "polygons", or a
    result, with "trajectory", "inner", "outer" and "unswept", or with "regions". A polygon is a
    list of vertices, or an object with such a list as "vertices", "points" or "polygon", or as
    "exterior" with a list of "holes"; optionally with "id" and "error".
    """
    node = JsonNode(document, path)
    if isinstance(document, dict) and "polygons" in document:
        return _read_each(node / "polygons")
    if _is_list_of_rings(document):
        return _read_each(node)
    if isinstance(document, dict) and not {*_RINGS} & document.keys():
        found = _read_result(node, document)
        if found:
            return found
    return [_read_one(node)._replace(place="" if path == "$" else path)]


def _read_each(node: JsonNode) -> list[Candidate]:
    return [*limit_faults(map(_read_one, node.each("a list of polygons")))]


def _is_list_of_rings(value: object) -> bool:
    first = value[0] if isinstance(value, list) and value else None
    return isinstance(first, list) and bool(first) and isinstance(first[0], (list, dict))


def _read_result(node: JsonNode, document: Mapping[str, object]) -> list[Candidate]:
    found: list[Candidate] = []
    for member in _LOOPS:
        if member not in document:
            continue
        loop = node / member
        if _is_list_of_rings(loop.value) or (member in _LISTS and isinstance(loop.value, list)):
            each = enumerate(_read_each(loop))
            found += [one._replace(name=f"{member} {k}") for k, one in each]
        else:
            found.append(_read_one(loop)._replace(name=member))
    named = _find_record_name(document)
    if named is not None:
        found = [one._replace(name=f"{named} {one.name}") for one in found]
    if not found and isinstance(document.get("error"), str):
        found = [Candidate.from_error(f"{node.path}: an error: {document['error']}", named)]
    return found


def _find_record_name(document: Mapping[str, object]) -> str | None:
    for members in (("id",), ("generatrix", "directrix"), ("index",)):
        values = [document.get(member) for member in members]
        if all(isinstance(value, str) for value in values):
            return " ".join(map(str, values))
    return None


def _read_one(node: JsonNode) -> Candidate:
    value, path = node
    if isinstance(value, list):
        return Candidate(path, partial(read_vertices, value, path))
    if not isinstance(value, dict):
        return Candidate.from_error(f"{path} is {describe_kind(value)}, not a list of vertices")
    member = next((name for name in _RINGS if name in value), "exterior")
    if member not in value:
        if "placements" in value:
            raise FormatError(f"{path} is a layout; 'exactsweep layout' judges it")
        raise FormatError(
            f'{path} has neither "vertices" nor "polygons" nor, as in GeoJSON, a "type"'
            if path.endswith("$")
            else f'{path} has no "vertices"'
        )
    name, exterior = node.get("id", None).id, node / member
    try:
        exterior.entries("a list of vertices")
    except FormatError as error:
        return Candidate.from_error(error, name)
    holes = []
    if member == "exterior" and "holes" in value:
        holes = [*(node / "holes").each("a list of holes")]
    for hole in holes:
        hole.entries("a list of vertices")
    readers = ((ring.path, partial(read_vertices, *ring)) for ring in (exterior, *holes))
    bound = node.get("error", "0").fraction
    if bound < 0:
        raise FormatError(f"{path}.error is negative")
    return Candidate.of_rings(readers, path, name, error=bound)


def read_geojson(
    document: Mapping[str, object], path: str = "$", notes: dict[str, None] | None = None
) -> list[Candidate]:
    """Find the Polygons of a document parsed by `parse_json`; other geometries are rejected."""
    found = _read_geometry(JsonNode(document, path), None, 0, {} if notes is None else notes)
    return [*limit_faults(found)]


def _read_geometry(
    node: JsonNode, name: str | None, depth: int, notes: dict[str, None]
) -> Iterator[Candidate]:
    if not isinstance(node.value, dict):
        yield Candidate.from_error(
            f"{node.path} is {describe_kind(node.value)}, not a Polygon", name
        )
        return
    if depth > _MAX_DEPTH:
        raise FormatError("nested too deeply")
    kind = node.get("type", None).value
    if kind == "Feature":
        name = node.get("id", None).id
        yield from _read_geometry(node.get("geometry", None), name, depth + 1, notes)
    elif kind == "Polygon":
        yield _read_rings(node.get("coordinates", None), name, notes)
    elif kind == "MultiPolygon":
        for rings in node.get("coordinates", None).each():
            yield _read_rings(rings, name, notes)
    elif kind in ("FeatureCollection", "GeometryCollection"):
        member = "features" if kind == "FeatureCollection" else "geometries"
        for part in node.get(member, None).each():
            yield from _read_geometry(part, name, depth + 1, notes)
    else:
        yield Candidate.from_error(
            f"{node.path}.type is {describe_kind(kind)}, not 'Polygon'", name
        )


def _read_rings(node: JsonNode, name: str | None, notes: dict[str, None]) -> Candidate:
    try:
        rings = [*node.each("a list of rings")]
        level = []
        for ring in rings:
            entries = ring.entries("a list of vertices")
            flat = [p[:2] if isinstance(p, list) and len(p) == 3 else p for p in entries]
            level.append(JsonNode(flat, ring.path))
    except FormatError as error:
        return Candidate.from_error(error, name)
    if not rings:
        return Candidate.from_error(f"{node.path} is empty", name)
    if level != rings:
        notes["third coordinates (heights) are ignored"] = None
    readers = ((ring.path, partial(_read_ring, *ring)) for ring in level)
    return Candidate.of_rings(readers, node.path, name)


def _read_ring(value: object, path: str) -> list[Point]:
    ring = read_vertices(value, path)
    if not ring:
        raise FormatError(f"{path} is empty")
    if ring[0] != ring[-1]:
        raise FormatError(f"{path} is not closed: the last vertex must repeat the first")
    return ring
