"""JSON of sparrow, jagua-rs and spyrrow.

An instance has items with a demand and orientations in degrees, any where none are listed, and a
strip or bins. A solution turns items counter-clockwise about their origin, then moves them. spyrrow
writes no file: the attributes of its solution are the members here.

Source: `io/ext_repr.rs` and `probs/*/io/ext_repr.rs` of jagua-rs, `util/io.rs` of sparrow, `lib.rs`
of spyrrow.
"""

from __future__ import annotations

from fractions import Fraction

from exactsweep.formats.error import FormatError
from exactsweep.formats.layouts.found import (
    FilledSheet,
    FoundLayout,
    NestingInstance,
    find_named,
    make_layouts,
    require_instance,
)
from exactsweep.formats.node import Data, JsonNode, write_box, write_shape
from exactsweep.numbers.error import quote


def read_instance(document: JsonNode) -> NestingInstance:
    """Read the items and bins of an instance; raises FormatError."""
    parts: dict[str, Data] = {}
    containers, notes = {}, []
    for item in (document / "items").each():
        name = (item / "id").name
        if name in parts:
            raise FormatError(f"{item.path}.id: the id {quote(name)} is there twice")
        part = {"id": name, **_shape(item / "shape"), "demand": (item / "demand").whole}
        part["mirrored"] = False
        if item.has("allowed_orientations"):
            turns = [turn.number for turn in (item / "allowed_orientations").each()]
            part["turns"] = turns or ["0"]
        if item.has("min_quality"):
            notes.append(f"item {name}: its least quality is not looked at")
        parts[name] = part
    for bin in document.get("bins", []).each():
        containers[(bin / "id").name] = _container(bin, notes)
    least = {name: part["demand"] for name, part in parts.items()}
    strip = document.either("strips")
    name = "height" if document.has("strips") else "strip_height"
    height = (strip / name).fraction if strip.has(name) else None
    return NestingInstance("jagua", parts, least, containers, {}, tuple(notes), height)


def read_solution(document: JsonNode, known: NestingInstance | None) -> list[FoundLayout]:
    """Read a solution; it is the document, or its member "solution"."""
    instance = require_instance(known, "jagua", "items")
    solution = document.either("solution")
    containers = dict(instance.containers)
    for one in solution.get("containers", []).each():
        containers[(one / "id").name] = _container(one, [])
    if solution.has("layouts"):
        layouts = [*(solution / "layouts").each()]
        boxes = [find_named(containers, one / "container_id", "container") for one in layouts]
    elif instance.height is None:
        raise FormatError(f"{solution.path} is a strip, and nothing says how high (--instance)")
    else:
        layouts = [solution.either("layout")]
        width = solution / ("width" if solution.has("width") else "strip_width")
        zero = Fraction(0)
        boxes = [{"exterior": write_box(zero, zero, width.fraction, instance.height)}]
    return make_layouts([*map(FilledSheet, boxes, map(_placed, layouts))], instance)


def _placed(layout: JsonNode) -> list[Data]:
    found = []
    for item in (layout / "placed_items").each():
        motion = item.either("transformation")
        part = (item / ("item_id" if item.has("item_id") else "id")).name
        move, turn = (motion / "translation").pair, (motion / "rotation").number
        found.append({"part": part, "turn": turn, "move": move})
    return found


def _container(value: JsonNode, notes: list[str]) -> Data:
    """Read a container, of which zones of quality 0 are holes."""
    found = _shape(value / "shape")
    for zone in value.get("zones", []).each():
        quality = (zone / "quality").whole
        if quality:
            notes.append(f"{zone.path}: a zone of quality {quality} is not looked at")
        else:
            found.setdefault("holes", []).append(_shape(zone / "shape")["exterior"])
    return found


def _shape(value: JsonNode) -> Data:
    if isinstance(value.value, list):
        return {"exterior": value.ring}
    kind = (value / "type").name.lower().replace("_", "")
    data = value / "data"
    if kind == "rectangle":
        sides = "x_min", "y_min", "width", "height"
        return {"exterior": write_box(*((data / name).fraction for name in sides))}
    if kind == "simplepolygon":
        return {"exterior": data.ring}
    if kind == "polygon":
        holes = [hole.ring for hole in data.get("inner", []).each()]
        return write_shape((data / "outer").ring, holes)
    raise FormatError(f"{value.path}: a shape of type {quote(kind)} is not one part")
