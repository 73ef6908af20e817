"""JSON of sparrow, jagua-rs and spyrrow.

An instance has items with a demand and orientations in degrees, any where none are listed, and a
strip or bins. A solution turns items counter-clockwise about their origin, then moves them. spyrrow
writes no file: the attributes of its solution are the members here. All convert an angle of the
instance to radians and back in single precision: of 30 degrees they write 30.000002.

Source: `io/ext_repr.rs` and `probs/*/io/ext_repr.rs` of jagua-rs, `util/io.rs` of sparrow, `lib.rs`
of spyrrow.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from ctypes import c_float
from fractions import Fraction
from itertools import chain
from math import nan, pi

from exactsweep.formats.error import FormatError
from exactsweep.formats.layouts.found import (
    FilledSheet,
    FoundLayout,
    NestingInstance,
    compare_stock,
    find_named,
    make_layouts,
    require_instance,
    require_within_strip,
)
from exactsweep.formats.node import Data, JsonNode, write_box, write_shape
from exactsweep.numbers.error import quote


def read_instance(document: JsonNode) -> NestingInstance:
    """Read the items and bins of an instance; raises FormatError."""
    parts: dict[str, Data] = {}
    containers, stock, notes = {}, {}, []
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
        if bin.has("stock"):
            stock[(bin / "id").name] = (bin / "stock").whole
    least = {name: part["demand"] for name, part in parts.items()}
    strip = document.either("strips")
    name = "height" if document.has("strips") else "strip_height"
    height = (strip / name).fraction if strip.has(name) else None
    width = (strip / "max_width").fraction if strip.has("max_width") else None
    return NestingInstance(
        "jagua", parts, least, containers, {}, tuple(notes), height, width, stock
    )


def read_solution(document: JsonNode, known: NestingInstance | None) -> list[FoundLayout]:
    """Read a solution; it is the document, or its member "solution"."""
    instance = require_instance(known, "jagua", "items")
    solution = document.either("solution")
    containers, used = dict(instance.containers), Counter[str]()
    for one in solution.get("containers", []).each():
        # A solution cuts its sheets from a strip; those of an instance are as that says.
        if instance.height is not None:
            sheet = containers[(one / "id").name] = _container(one, [])
            require_within_strip(sheet, instance, one.path)
    if solution.has("layouts"):
        layouts = [*(solution / "layouts").each()]
        boxes = [find_named(containers, one / "container_id", "container") for one in layouts]
        used.update((one / "container_id").name for one in layouts)
    elif instance.height is None:
        raise FormatError(f"{solution.path} is a strip, and nothing says how high (--instance)")
    else:
        layouts = [solution.either("layout")]
        width = solution / ("width" if solution.has("width") else "strip_width")
        zero = Fraction(0)
        boxes = [{"exterior": write_box(zero, zero, width.fraction, instance.height)}]
    placed = [*map(_placed, layouts)]
    notes = [*compare_stock(used, instance), *_allow_rounded(instance, chain(*placed))]
    return make_layouts([*map(FilledSheet, boxes, placed)], instance, notes)


def _placed(layout: JsonNode) -> list[Data]:
    found = []
    for item in (layout / "placed_items").each():
        motion = item.either("transformation")
        part = (item / ("item_id" if item.has("item_id") else "id")).name
        move, turn = (motion / "translation").pair, (motion / "rotation").number
        found.append({"part": part, "turn": turn, "move": move})
    return found


def _allow_rounded(instance: NestingInstance, placements: Iterable[Data]) -> Iterator[str]:
    """Allow turns that are allowed ones as the program rounds them, and name them."""
    exact = {
        name: {Fraction(turn) % 360 for turn in part["turns"]}
        for name, part in instance.parts.items()
        if "turns" in part
    }
    for placement in placements:
        name, turn = placement["part"], placement["turn"]
        if name in exact and Fraction(turn) % 360 not in exact[name]:
            allowed = instance.parts[name]["turns"]
            meant = next((one for one in allowed if _round(one) == _read_single(turn)), None)
            if meant is not None:
                exact[name].add(Fraction(turn) % 360)
                allowed.append(turn)
                yield f"item {name}: the turn {turn} is {meant} in single precision"


def _round(degrees: str) -> float:
    """Convert degrees to radians and back, as the program does in single precision."""
    radians = c_float(_read_single(degrees) * c_float(c_float(pi).value / 180).value).value
    return c_float(radians * c_float(180 / pi).value).value


def _read_single(number: str) -> float:
    """Read a number in single precision; a fraction, which no program writes, as NaN."""
    return nan if "/" in number else c_float(float(number)).value


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
