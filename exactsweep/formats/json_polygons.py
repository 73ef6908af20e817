"""Reader of exact JSON: lists of vertices, parts with holes, lists of these, and results."""

from collections.abc import Mapping
from functools import partial

from exactsweep.formats.candidate import Candidate, allow_faults
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import describe_kind, read_vertices
from exactsweep.formats.node import JsonNode

_LOOPS = ("trajectory", "inner", "outer", "unswept", "regions")
_LISTS = ("unswept", "regions")
_RINGS = ("vertices", "exterior", "points", "polygon")


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
    return [*allow_faults(map(_read_one, node.each("a list of polygons")))]


def _is_list_of_rings(value: object) -> bool:
    first = value[0] if isinstance(value, list) and value else None
    return isinstance(first, list) and bool(first) and isinstance(first[0], (list, dict))


def _read_result(node: JsonNode, document: Mapping[str, object]) -> list[Candidate]:
    """Find the loops of a result, named by their kind and the names of the pair."""
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
    named = read_record_name(document)
    if named is not None:
        found = [one._replace(name=f"{named} {one.name}") for one in found]
    if not found and isinstance(document.get("error"), str):
        found = [Candidate.refused(f"{node.path}: an error: {document['error']}", named)]
    return found


def read_record_name(document: Mapping[str, object]) -> str | None:
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
        return Candidate.refused(f"{path} is {describe_kind(value)}, not a list of vertices")
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
        return Candidate.refused(error, name)
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
