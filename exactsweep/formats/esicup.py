"""Reader of nesting instances in ESICUP XML."""

from collections.abc import Iterator
from xml.etree.ElementTree import Element

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.decimals import read_decimal
from exactsweep.formats.error import FormatError
from exactsweep.numbers.error import quote
from exactsweep.numbers.number import Point


def is_esicup(root: Element) -> bool:
    return _find_kind(root) == "nesting"


def read_esicup(root: Element) -> list[Candidate]:
    polygons = {one.get("id", ""): one for one in root.iter() if _find_kind(one) == "polygon"}
    return [_read_piece(one, polygons) for one in root.iter() if _find_kind(one) == "piece"]


def _find_kind(element: Element) -> str:
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def _read_piece(piece: Element, polygons: dict[str, Element]) -> Candidate:
    name = piece.get("id", "")
    components = [one for one in piece if _find_kind(one) == "component"]
    place = f"piece {quote(name)}"
    try:
        if len(components) != 1:
            raise FormatError(f"expected one component, found {len(components)}")
        component = components[0]
        polygon = polygons.get(component.get("idPolygon", ""))
        if polygon is None:
            raise FormatError(f"there is no polygon {quote(component.get('idPolygon', ''))}")
        x, y = (read_decimal(component.get(f"{axis}Offset", "0")) for axis in "xy")
        points = [Point(p.x + x, p.y + y) for p in _read_corners(polygon)]
    except FormatError as error:
        return Candidate.from_error(f"{place}: {error}", name)
    return Candidate(place, points.copy, name)


def _read_corners(polygon: Element) -> Iterator[Point]:
    for one in polygon.iter():
        kind = _find_kind(one)
        if kind == "segment":
            yield Point(*(read_decimal(one.get(name, "")) for name in ("x0", "y0")))
        elif kind == "arc":
            raise FormatError("arcs are not supported; convert the instance to segments")
