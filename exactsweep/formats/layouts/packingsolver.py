"""JSON of packingsolver's irregular problems.

An item is mirrored (x to -x), then rotated counter-clockwise about its origin, in degrees, then
translated. A solution also contains the placed `item_shapes`, rounded; these are read only without
an instance.

Source: `irregular/instance_builder.cpp` and `irregular/solution.cpp`; `shape.hpp` of fontanf/shape.
"""

from collections import Counter
from collections.abc import Callable
from fractions import Fraction

from exactsweep.formats.curved.affine import make_affine
from exactsweep.formats.curved.path import draw_circle
from exactsweep.formats.error import FormatError
from exactsweep.formats.layouts import model
from exactsweep.formats.node import Data, JsonNode, write_box, write_ring, write_shape
from exactsweep.formats.reading import Reading
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import quote

_SHAPE = "type", "x", "y", "width", "height", "radius", "vertices", "elements", "holes", "shape"
_DOCUMENT = "objective", "parameters", "item_types", "bin_types", "name", "bins", "open_dimension_x"
_PARAMETERS = "item_item_minimum_spacing", "item_bin_minimum_spacing", "leftover_corner"
_ITEM = (
    *("shapes", "copies", "copies_min", "allowed_rotations", "allow_mirroring", "profit", "name"),
    *_SHAPE,
)
_BIN = (
    *("defects", "item_bin_minimum_spacing", "copies", "copies_min", "cost", "fixed_items", "name"),
    *_SHAPE,
)


def read_instance(document: JsonNode, reading: Reading) -> model.NestingInstance:
    unchecked = model.list_unknown([document], *_DOCUMENT)
    unchecked += model.list_unknown((document / "item_types").each(), *_ITEM)
    unchecked += model.list_unknown((document / "bin_types").each(), *_BIN)
    optional = document.get("objective", "").name.lower() == "knapsack"
    parameters = document.get("parameters", {})
    unchecked += model.list_unknown([parameters], *_PARAMETERS)
    parts, least, containers, stock = {}, {}, {}, {}
    for k, item in enumerate((document / "item_types").each()):
        shapes = [*(item / "shapes").each()] if item.has("shapes") else [item]
        if len(shapes) != 1:
            raise FormatError(f"{item.path}: expected one shape, found {len(shapes)}")
        part = {"id": str(k), **_shape(shapes[0], reading), **_allowed(item, unchecked)}
        copies, few = item.get("copies", "1").whole, item.get("copies_min", "-1").whole
        if copies >= 0:
            part["demand"] = copies
        least[str(k)] = few if few >= 0 else 0 if optional else copies
        parts[str(k)] = part
    for k, bin in enumerate((document / "bin_types").each()):
        container, defects = _shape(bin, reading), []
        # Before 2026, all bins had the same spacing.
        common = parameters.get("item_bin_minimum_spacing", "0").value
        margin = bin.get("item_bin_minimum_spacing", common)
        copies = bin.get("copies", "1").whole
        if copies >= 0:
            stock[str(k)] = copies
        if bin.has("fixed_items"):
            unchecked.append(f"whether the fixed items of {bin.path} are placed")
        for defect in bin.get("defects", []).each():
            shape = _shape(defect, reading)
            apart = defect.get("item_defect_minimum_spacing", "0").number
            defects.append(shape | {"spacing": apart})
            unchecked += model.list_unknown([defect], "item_defect_minimum_spacing", "id", *_SHAPE)
        containers[str(k)] = container | {"margin": margin.number, "defects": defects}
    rest = {"spacing": parameters.get("item_item_minimum_spacing", "0").number}
    return model.NestingInstance(
        "packingsolver", parts, least, containers, rest, (), tuple(unchecked), stock=stock
    )


def read_solution(
    document: JsonNode, instance: model.NestingInstance | None
) -> list[model.FoundLayout]:
    """Read the bins of a solution; without an instance, as drawn."""
    if instance is None or instance.kind != "packingsolver":
        return _read_drawn(document)
    found = []
    used: Counter[str] = Counter()
    for bin in (document / "bins").each():
        container = dict(model.find_named(instance.containers, bin / "id", "bin type"))
        rest: Data = {"margin": container.pop("margin")}
        if defects := container.pop("defects"):
            rest["defects"] = defects
        placements = []
        for item in (bin / "items").each():
            model.find_named(instance.parts, item / "id", "item type")
            x, y, turn = ((item / name).number for name in ("x", "y", "angle"))
            placement = {"part": (item / "id").name, "turn": turn, "move": [x, y]}
            mirrored = item.get("mirror", False).is_true
            placements.append(placement | ({"mirrored": True} if mirrored else {}))
        copies = bin.get("copies", "1").whole
        used[(bin / "id").name] += copies
        found.append(model.FilledSheet(container, placements, copies, rest))
    return model.make_layouts(found, instance, (), model.compare_stock(used, instance))


def _read_drawn(document: JsonNode) -> list[model.FoundLayout]:
    parts: dict[str, Data] = {}
    sheets = []
    for bin in (document / "bins").each():
        container = _drawn(bin)
        defects = [_drawn(defect) for defect in bin.get("defects", []).each()]
        placements = []
        for item in (bin / "items").each():
            for shape in (item / "item_shapes").each():
                name = str(len(parts))
                parts[name] = {"id": name, **_drawn(shape)}
                placements.append(model.IDENTITY_PLACEMENT | {"part": name})
        rest = {"defects": defects} if defects else {}
        sheets.append(model.FilledSheet(container, placements, rest=rest))
    note = "without the instance, items are judged as the solution draws them, rounded"
    return model.make_layouts(
        sheets, model.NestingInstance("packingsolver", parts, {}, {}, {}, (note,))
    )


def _allowed(item: JsonNode, unchecked: list[str]) -> Data:
    plain: list[Fraction] = []
    mirrored: list[Fraction] = []
    ranges: list[Fraction] = []
    both = item.get("allow_mirroring", False).is_true
    for one in item.get("allowed_rotations", []).each():
        low, high = (one / "start").fraction, (one / "end").fraction
        (mirrored if one.get("mirror", False).is_true else plain).append(low)
        ranges.append(high - low)
    found: Data = {"mirrored": both or bool(mirrored)}
    if any(size and size < 360 for size in ranges):
        unchecked.append(f"whether rotations are in the ranges of {item.path}")
    if any(ranges):
        return found
    found["turns"] = [*map(format_fraction, plain or ([] if mirrored else [Fraction(0)]))]
    if mirrored:
        copies = [*plain, *mirrored] if both else mirrored
        found["mirrored_turns"] = [*map(format_fraction, copies)]
    return found


def _shape(value: JsonNode, reading: Reading) -> Data:
    errors: list[Fraction] = []
    holes = [_outline(hole, reading, errors) for hole in value.get("holes", []).each()]
    shape = write_shape(_outline(value, reading, errors), holes)
    return shape | ({"error": format_fraction(max(errors))} if errors else {})


def _outline(value: JsonNode, reading: Reading, errors: list[Fraction]) -> list[list[str]]:
    kind = (value / "type").name
    if kind == "polygon":
        return (value / "vertices").ring
    if kind == "general":
        return _join(value / "elements", lambda element: (element / "start").value)
    x, y = (value.get(name, "0").fraction for name in "xy")
    if kind == "rectangle":
        return write_box(x, y, (value / "width").fraction, (value / "height").fraction)
    if kind == "circle":
        radius = (value / "radius").fraction
        path = draw_circle(make_affine(radius, 0, 0, radius, x, y))
        errors.append(path.find_error(reading))
        return write_ring(path.flatten(reading))
    raise FormatError(f"{value.path}.type: {quote(kind)} is not a shape")


def _drawn(value: JsonNode) -> Data:
    """Read a drawn shape: elements in "shape", and lists of elements in "holes"."""
    holes = [_drawn_ring(hole) for hole in value.get("holes", []).each()]
    return {"exterior": _drawn_ring(value / "shape"), "holes": holes}


def _drawn_ring(elements: JsonNode) -> list[list[str]]:
    return _join(elements, lambda element: [(element / name).value for name in ("xs", "ys")])


def _join(elements: JsonNode, find_start: Callable[[JsonNode], object]) -> list[list[str]]:
    """Return the start points of elements; reject arcs, whose ends are rounded."""
    for element in elements.each():
        if (element / "type").name.lower() not in ("linesegment", "line_segment", "l"):
            raise FormatError(f"{element.path}: arcs with rounded ends are not supported")
    return JsonNode([*map(find_start, elements.each())], elements.path).ring
