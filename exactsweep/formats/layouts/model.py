"""Layouts read from a file, and their instances."""

import re
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from fractions import Fraction
from types import MappingProxyType
from typing import Any, NamedTuple

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.error import FormatError
from exactsweep.formats.node import Data, JsonNode, write_ring, write_shape
from exactsweep.formats.rounded import RoundedOutline
from exactsweep.geometry.convex import cut_to_convex
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import quote
from exactsweep.numbers.number import Point

_INDEX = re.compile(r"\[\d+\]")

IDENTITY_PLACEMENT: Data = {"turn": "0", "move": ["0", "0"]}  # the identity placement
# Flattens parts (by id) and the container (None) at another tolerance, if possible.
Flatten = Callable[[Collection[str | None], Fraction], Mapping[str | None, Data]]


class FoundLayout(NamedTuple):
    """A layout read from a file."""

    name: str  # "" if the file has a single layout
    data: Data  # Layout JSON, for `exactsweep.layout.Layout.from_json`
    notes: tuple[str, ...] = ()
    unchecked: tuple[str, ...] = ()  # rules and shapes that are not judged
    places: tuple[str, ...] = ()  # the location of each placement, such as "line 7"
    unit: str = ""  # of length, such as "mm"
    flatten: Flatten | None = None  # None without curves


class NestingInstance(NamedTuple):
    kind: str  # "jagua", "packingsolver" or "cgshop"
    parts: dict[str, Data]  # Layout JSON by id, with the maximum number of placements as demand
    least: dict[str, int]  # minimum number of placements by id
    containers: dict[str, Data]  # Layout JSON by id; empty for a strip of variable width
    rest: Data  # members for each layout: "spacing", "margin"
    notes: tuple[str, ...]
    unchecked: tuple[str, ...] = ()  # rules that are not judged
    height: Fraction | None = None  # of a strip of variable width
    width: Fraction | None = None  # maximum width of that strip
    stock: Mapping[str, int] = MappingProxyType({})  # containers by id; unlimited if missing


class FilledSheet(NamedTuple):
    """A container with its placements, in Layout JSON, without parts and demands."""

    container: Data
    placements: list[Data]
    copies: int = 1  # number of identical sheets
    rest: Mapping[str, Any] = MappingProxyType({})  # members of this layout only
    places: tuple[str, ...] = ()  # as for `FoundLayout`


def make_layouts(
    sheets: Sequence[FilledSheet],
    instance: NestingInstance,
    notes: Sequence[str] = (),
    unchecked: Sequence[str] = (),
) -> list[FoundLayout]:
    """Make a layout for each sheet.

    The sheets share the demand: each demands the parts placed on it, up to the remaining demand,
    and the last one also demands the parts still missing. So the total demand is met if and only if
    no sheet has missing or surplus parts. A layout contains only the parts placed or demanded on
    it.
    """
    order = {name: k for k, name in enumerate(instance.parts)}
    remaining = {name: part.get("demand") for name, part in instance.parts.items()}
    wanted = dict(instance.least)
    remarks = (*instance.notes, *notes)
    found = []
    for k, sheet in enumerate(sheets):
        placed = Counter(placement["part"] for placement in sheet.placements)
        last = k == len(sheets) - 1
        parts = []
        for name in order if last else sorted(order.keys() & placed.keys(), key=order.__getitem__):
            part, number, most, asked = instance.parts[name], placed[name], remaining[name], 0
            if most is not None:
                asked = number if number * sheet.copies <= most else most // sheet.copies
                remaining[name] = most - min(most, number * sheet.copies)
                wanted[name] = max(0, wanted.get(name, 0) - number * sheet.copies)
                if last:
                    asked += wanted[name]
                part = {**part, "demand": asked}
            if asked or number:
                parts.append(part)
        data = {"container": sheet.container, "parts": parts, "placements": sheet.placements}
        copies = f", {sheet.copies} copies" if sheet.copies > 1 else ""
        name = f"sheet {k}{copies}" if len(sheets) > 1 else ""
        data |= {**instance.rest, **sheet.rest}
        rules = (*instance.unchecked, *unchecked)
        found.append(FoundLayout(name, data, remarks, rules, sheet.places))
    return found


def compare_stock(used: Counter[str], instance: NestingInstance) -> list[str]:
    return [
        f"container {name}: {number} used, {instance.stock[name]} in stock"
        for name, number in used.items()
        if number > instance.stock.get(name, number)
    ]


def require_instance(known: NestingInstance | None, kind: str, lacking: str) -> NestingInstance:
    if known is None or known.kind != kind:
        raise FormatError(f"the solution has no {lacking}; --instance FILE reads its instance")
    return known


def require_within_strip(container: Data, instance: NestingInstance, place: str) -> None:
    for axis, (length, larger) in enumerate(
        ((instance.width, "wider"), (instance.height, "taller"))
    ):
        side = [Fraction(vertex[axis]) for vertex in container["exterior"]]
        if length is not None and side and max(side) - min(side) > length:
            raise FormatError(f"{place} is {larger} than the strip of the instance")


def find_named(items: Mapping[str, Any], name: JsonNode, what: str) -> Any:
    if name.name not in items:
        raise FormatError(f"{name.path}: there is no {what} {quote(name.name)}")
    return items[name.name]


def write_rings(outline: Candidate) -> Data:
    """Convert an outline with holes to Layout JSON; the judge reports crossings."""
    if outline.rounded is not None and not outline.holes():
        return write_rounded(outline.rounded)
    holes = [write_ring(hole.vertices()) for hole in outline.holes()]
    shape = write_shape(write_ring(outline.vertices()), holes)
    return shape | ({"error": format_fraction(outline.error)} if outline.error else {})


def write_union(outlines: Sequence[Candidate]) -> Data:
    """Convert separate outlines to one rigid part of convex pieces."""
    shapes = [*map(write_rings, outlines)]
    if len(shapes) == 1:
        return shapes[0]
    pieces: list[Data] = []
    for one, shape in zip(outlines, shapes, strict=True):
        if "pieces" in shape:
            pieces += shape["pieces"]
            continue
        scale, rings = one.region().lattice()
        for piece in cut_to_convex(rings):  # type: ignore[arg-type]
            points = [Point(Fraction(x, scale), Fraction(y, scale)) for x, y in piece]
            pieces.append({"points": write_ring(points)})
    error = max(Fraction(shape.get("error", 0)) for shape in shapes)
    return {"pieces": pieces} | ({"error": format_fraction(error)} if error else {})


def write_rounded(outline: RoundedOutline) -> Data:
    points, radius = write_ring(outline.points), format_fraction(outline.radius)
    error = {"error": format_fraction(outline.error)} if outline.error else {}
    return {"pieces": [{"points": points, "radius": radius}], **error}


def read_rounded(part: Data) -> RoundedOutline | None:
    if "pieces" not in part:
        return None
    (piece,) = part["pieces"]
    points = tuple(Point(Fraction(x), Fraction(y)) for x, y in piece["points"])
    return RoundedOutline(points, Fraction(piece["radius"]), Fraction(part.get("error", 0)))


def list_unknown(nodes: Iterable[JsonNode], *known: str) -> list[str]:
    found = {
        f"{_INDEX.sub('', node.path).removeprefix('$').removeprefix('.')}.{name}".removeprefix(".")
        for node in nodes
        if isinstance(node.value, Mapping)
        for name in node.value
        if name not in known
    }
    return [f"the unknown field {quote(name)}" for name in sorted(found)]
