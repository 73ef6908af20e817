"""JSON of the CG:SHOP challenge 2024, maximum polygon packing.

A polygon is a list of x and a list of y; solutions only translate it. Up to `quantity` copies of
each item may be placed. Only the instance contains the polygons.

Source: the verifier of the challenge, `CG-SHOP/pyutils24`.
"""

from exactsweep.formats.error import FormatError
from exactsweep.formats.layouts import model
from exactsweep.formats.node import Data, JsonNode

_DOCUMENT = "type", "instance_name", "name", "items", "container", "meta", "num_items"


def read_instance(document: JsonNode) -> model.NestingInstance:
    parts = {}
    for k, item in enumerate((document / "items").each()):
        allowed = {"demand": item.get("quantity", "1").whole, "turns": ["0"], "mirrored": False}
        parts[str(k)] = {"id": str(k), **_polygon(item), **allowed}
    containers = {"container": _polygon(document / "container")}
    unchecked = model.list_unknown([document], *_DOCUMENT)
    unchecked += model.list_unknown((document / "items").each(), "quantity", "value", "x", "y")
    return model.NestingInstance("cgshop", parts, {}, containers, {}, (), tuple(unchecked))


def read_solution(
    document: JsonNode, known: model.NestingInstance | None
) -> list[model.FoundLayout]:
    instance = model.require_instance(known, "cgshop", "polygons")
    names = "item_indices", "x_translations", "y_translations"
    indices, xs, ys = ([*(document / name).each()] for name in names)
    if not len(indices) == len(xs) == len(ys):
        raise FormatError(f"$: {', '.join(names)} differ in length")
    placements = []
    for index, x, y in zip(indices, xs, ys, strict=True):
        model.find_named(instance.parts, index, "item")
        placements.append(
            model.IDENTITY_PLACEMENT | {"part": index.name, "move": [x.number, y.number]}
        )
    return model.make_layouts(
        [model.FilledSheet(instance.containers["container"], placements)], instance
    )


def _polygon(value: JsonNode) -> Data:
    xs, ys = ([one.value for one in (value / axis).each()] for axis in "xy")
    if len(xs) != len(ys):
        raise FormatError(f"{value.path}: {len(xs)} x and {len(ys)} y coordinates")
    return {"exterior": JsonNode([[x, y] for x, y in zip(xs, ys, strict=True)], value.path).ring}
