"""JSON of sparrow, jagua-rs and spyrrow.

An instance has a strip or bins, and items with a demand and allowed orientations in degrees (all if
missing). A solution rotates items counter-clockwise about their origin, then translates them. Since
version 1.0.0, an instance has a minimum distance between items and from the container, and each
item an `orientation`: its rotations, and the axes of reflections before them. A `reflected`
placement is mirrored in the X axis before its rotation. spyrrow writes no files; its solutions have
these members as attributes. All three programs convert angles to radians and back in single
precision: 30 degrees become 30.000002.

Source: `io/ext_repr.rs` and `probs/*/io/ext_repr.rs` of jagua-rs, `util/io.rs` of sparrow, `lib.rs`
of spyrrow.
"""

from collections import Counter
from collections.abc import Iterable, Iterator
from ctypes import c_float
from fractions import Fraction
from itertools import chain
from math import nan, pi

from exactsweep.formats.error import FormatError
from exactsweep.formats.layouts import model
from exactsweep.formats.node import Data, JsonNode, write_box, write_shape
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import quote

_DOCUMENT = "name", "items", "bins", "strips", "strip_height", "min_item_separation", "solution"
_ITEM = "id", "demand", "shape", "allowed_orientations", "orientation", "min_quality"
_CONTAINER = "id", "shape", "zones", "stock", "cost"
_SOLUTION = (
    *("strip_width", "width", "height", "layout", "layouts", "containers", "density", "cost"),
    *("run_time_sec", "placed_items", "container_id", "usage"),
)
_PLACED = "item_id", "id", "transformation", "rotation", "translation", "reflected"
_MOST_TURNS = 65_536
_NEARLY = Fraction(1, 10_000)  # bounds the error of angles in single precision, in degrees


def read_instance(document: JsonNode) -> model.NestingInstance:
    parts: dict[str, Data] = {}
    containers, stock = {}, {}
    unchecked = model.list_unknown([document], *_DOCUMENT)
    unchecked += model.list_unknown((document / "items").each(), *_ITEM)
    unchecked += model.list_unknown(document.get("bins", []).each(), *_CONTAINER)
    for item in (document / "items").each():
        name = (item / "id").name
        if name in parts:
            raise FormatError(f"{item.path}.id: duplicate id {quote(name)}")
        part = {"id": name, **_shape(item / "shape"), "demand": (item / "demand").whole}
        part["mirrored"] = False
        if item.has("orientation"):
            unchecked += model.list_unknown([item / "orientation"], "rotation", "reflection_axes")
            part |= _read_orientation(item / "orientation")
        elif item.has("allowed_orientations"):
            turns = [turn.number for turn in (item / "allowed_orientations").each()]
            part["turns"] = turns or ["0"]
        if item.has("min_quality"):
            unchecked.append(f"the minimum quality of item {name}")
        parts[name] = part
    for bin in document.get("bins", []).each():
        containers[(bin / "id").name] = _container(bin, unchecked)
        if bin.has("stock"):
            stock[(bin / "id").name] = (bin / "stock").whole
    least = {name: part["demand"] for name, part in parts.items()}
    strip = document.either("strips")
    name = "height" if document.has("strips") else "strip_height"
    height = (strip / name).fraction if strip.has(name) else None
    width = (strip / "max_width").fraction if strip.has("max_width") else None
    rest = {}
    if document.has("min_item_separation"):
        apart = (document / "min_item_separation").number
        rest = {"spacing": apart, "margin": apart}
    return model.NestingInstance(
        "jagua", parts, least, containers, rest, (), tuple(unchecked), height, width, stock
    )


def _read_orientation(orientation: JsonNode) -> Data:
    """Convert the allowed rotations, also of reflected copies, to Layout JSON."""
    rotation = orientation / "rotation"
    mode = (rotation / "mode").name
    axes = [axis.fraction for axis in orientation.get("reflection_axes", []).each()]
    found: Data = {"mirrored": bool(axes)}
    if mode == "continuous":
        return found
    if mode == "discrete":
        turns = [(angle.fraction, angle.number) for angle in (rotation / "angles").each()]
    elif mode == "stepped":
        step = (rotation / "step").fraction
        number = round(360 / step) if step > 0 else 0
        if not 0 < number <= _MOST_TURNS or abs(number * step - 360) > _NEARLY:
            raise FormatError(f"{rotation.path}.step does not divide 360 degrees")
        # A step such as 51.428571 means the exact quotient.
        angles = [Fraction(360 * k, number) for k in range(number)]
        turns = [(angle, format_fraction(angle)) for angle in angles]
    else:
        raise FormatError(f"{rotation.path}.mode: {quote(mode)} is not a rotation mode")
    found["turns"] = [written for _, written in turns]
    # Mirroring in the Y axis and rotating by 180 degrees is mirroring in the X axis.
    mirrored = sorted({(angle + 2 * axis + 180) % 360 for angle, _ in turns for axis in axes})
    if mirrored and set(mirrored) != {angle % 360 for angle, _ in turns}:
        found["mirrored_turns"] = [format_fraction(angle) for angle in mirrored]
    return found


def read_solution(
    document: JsonNode, known: model.NestingInstance | None
) -> list[model.FoundLayout]:
    """Read a solution: the document, or its member "solution"."""
    instance = model.require_instance(known, "jagua", "items")
    solution = document.either("solution")
    containers, used = dict(instance.containers), Counter[str]()
    for one in solution.get("containers", []).each():
        # The solution states the sheets cut from a strip, the instance all others.
        if instance.height is not None:
            sheet = containers[(one / "id").name] = _container(one, [])
            model.require_within_strip(sheet, instance, one.path)
    if solution.has("layouts"):
        layouts = [*(solution / "layouts").each()]
        boxes = [model.find_named(containers, one / "container_id", "container") for one in layouts]
        used.update((one / "container_id").name for one in layouts)
    elif instance.height is None:
        raise FormatError(f"{solution.path} is a strip of unknown height (--instance)")
    else:
        layouts = [solution.either("layout")]
        width = solution / ("width" if solution.has("width") else "strip_width")
        zero = Fraction(0)
        boxes = [{"exterior": write_box(zero, zero, width.fraction, instance.height)}]
    placed = [*map(_placed, layouts)]
    notes = [*_allow_rounded(instance, chain(*placed))]
    items = [item for one in layouts for item in (one / "placed_items").each()]
    motions = [item.either("transformation") for item in items]
    unchecked = [
        *model.compare_stock(used, instance),
        *model.list_unknown([solution], *_SOLUTION),
        *model.list_unknown(layouts, *_SOLUTION),
        *model.list_unknown([*items, *motions], *_PLACED),
    ]
    return model.make_layouts([*map(model.FilledSheet, boxes, placed)], instance, notes, unchecked)


def _placed(layout: JsonNode) -> list[Data]:
    found = []
    for item in (layout / "placed_items").each():
        motion = item.either("transformation")
        part = (item / ("item_id" if item.has("item_id") else "id")).name
        move, turn = (motion / "translation").pair, (motion / "rotation").number
        placement: Data = {"part": part, "turn": turn, "move": move}
        if motion.get("reflected", False).is_true:
            half_turned = format_fraction((motion / "rotation").fraction + 180)
            placement |= {"turn": half_turned, "mirrored": True}
        found.append(placement)
    return found


def _allow_rounded(instance: model.NestingInstance, placements: Iterable[Data]) -> Iterator[str]:
    """Allow rotations that equal allowed ones after rounding, and yield notes on them."""
    exact: dict[tuple[str, str], set[Fraction]] = {
        (name, key): {Fraction(turn) % 360 for turn in part[key]}
        for name, part in instance.parts.items()
        for key in ("turns", "mirrored_turns")
        if key in part
    }
    for placement in placements:
        name, turn = placement["part"], placement["turn"]
        key = "mirrored_turns" if placement.get("mirrored") else "turns"
        if (name, key) not in exact:
            key = "turns"
        if (name, key) in exact and Fraction(turn) % 360 not in exact[name, key]:
            allowed = instance.parts[name][key]
            is_near = _is_near if placement.get("mirrored") else _is_rounded
            meant = next((one for one in allowed if is_near(one, turn)), None)
            if meant is not None:
                exact[name, key].add(Fraction(turn) % 360)
                allowed.append(turn)
                yield f"item {name}: the rotation {turn} is {meant} in single precision"


def _is_near(degrees: str, written: str) -> bool:
    apart = (Fraction(degrees) - Fraction(written)) % 360
    return min(apart, 360 - apart) <= _NEARLY


def _is_rounded(degrees: str, written: str) -> bool:
    """Return whether conversion to radians and back in single precision has the given result."""
    radians = c_float(_read_single(degrees) * c_float(c_float(pi).value / 180).value).value
    return c_float(radians * c_float(180 / pi).value).value == _read_single(written)


def _read_single(number: str) -> float:
    """Read a number in single precision; fractions become NaN."""
    return nan if "/" in number else c_float(float(number)).value


def _container(value: JsonNode, unchecked: list[str]) -> Data:
    """Read a container; zones of quality 0 are holes."""
    found = _shape(value / "shape")
    for zone in value.get("zones", []).each():
        quality = (zone / "quality").whole
        if quality:
            unchecked.append(f"a zone of quality {quality} ({zone.path})")
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
    raise FormatError(f"{value.path}: shapes of type {quote(kind)} are not supported")
