"""Reader of layouts; the content determines the format."""

import os
from collections.abc import Collection, Mapping
from fractions import Fraction
from functools import partial
from glob import has_magic
from typing import Any, Literal, Unpack

from exactsweep.formats.curved.arc import to_degrees
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import parse_json
from exactsweep.formats.files import read_text, show_path
from exactsweep.formats.layouts import cgshop, jagua, model, packingsolver
from exactsweep.formats.layouts.drawing import draw_layouts
from exactsweep.formats.layouts.instances import read_instance
from exactsweep.formats.layouts.inventory import compare_inventory, read_inventory
from exactsweep.formats.layouts.table import is_table, read_parts, read_table
from exactsweep.formats.node import Data, JsonNode
from exactsweep.formats.polygons import prefix_path, split_choice
from exactsweep.formats.reading import Options, Reading
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.region import Region
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import explain_type_errors, quote
from exactsweep.numbers.number import to_fraction

_Container = str | Literal[False] | None

_ALLOWED = ("turns", "mirrored_turns")


class LayoutOptions(Options, total=False):
    part: str | None
    radians: bool
    instance: str | None
    container: _Container
    tolerance: object


@explain_type_errors
def read_layout(path: str, **options: Unpack[LayoutOptions]) -> dict[str, Any]:
    """Read a file with a single layout, like `read_layouts`; return Layout JSON."""
    found = read_layouts(path, **options)
    if len(found) > 1:
        raise FormatError(f"{show_path(path)}: expected one layout, found {len(found)}")
    return found[0].data


@explain_type_errors
def parse_layouts(text: str, **options: Unpack[LayoutOptions]) -> list[model.FoundLayout]:
    """Read the layouts in a string, like `read_layouts`; the instance is also a string.

    >>> rectangle = '<rect id="sheet" width="4" height="3"/>'
    >>> (found,) = parse_layouts(f'<svg>{rectangle}<path id="a" d="M0 0H3V1z"/></svg>')
    >>> found.data["parts"]
    [{'id': 'a', 'exterior': [['0', '0'], ['3', '0'], ['3', '1']]}]
    """
    instance, container, reading = _parse_options(**options)
    known = _parse_instance(instance, reading)
    if instance is not None and known is None:
        raise FormatError("not an instance of a nesting program")
    return _parse_each(text, known, container, reading)


@explain_type_errors
def read_layouts(path: str, **options: Unpack[LayoutOptions]) -> list[model.FoundLayout]:
    """Read the layouts in a file, or in standard input.

    Args:
        path: a path, or "-" for standard input, optionally with "#" and the index of a sheet.
            Layout JSON; JSON of sparrow, jagua-rs, spyrrow, packingsolver and CG:SHOP 2024; SVG of
            sparrow, jagua-rs, SVGnest and Deepnest; a table of placements; or any drawing that
            `read_regions` reads, with the outlines in place.
        instance: a file with the instance of a solution (demands and allowed rotations); or a
            drawing, a file of polygons or a folder of parts, each to be placed once.
        part: the file with the parts of a table of placements.
        radians: whether angles are in radians.
        container: the name, index, layer or group of the container in a drawing; False for no
            container; detected by default.
        tolerance: as for `exactsweep.formats.parse_polygons`.
        options: as for `exactsweep.formats.parse_polygons`.

    Returns:
        A list of FoundLayout, one per sheet.

    Raises:
        FormatError: not a layout; the message gives the file and the location.

    Cost: linear in the length of the text.
    """
    part, radians = options.get("part"), options.get("radians", False)
    instance, container, reading = _parse_options(**options)
    file, choice = split_choice(path)
    known, wanted = None, None
    if instance is not None:
        text = "" if os.path.isdir(instance) or has_magic(instance) else read_text(instance)
        with prefix_path(instance):
            known = _parse_instance(text, reading) if text.lstrip()[:1] == "{" else None
        if known is None:
            wanted = read_inventory(instance, reading)
    parts = None if part is None else read_parts(part, reading)
    with prefix_path(file):
        text = read_text(file)
        if parts is not None or is_table(text):
            found = _read_table(text, parts, known, radians=radians)
        else:
            found = _parse_each(text, known, container, reading)
            found = [*map(_from_radians, found)] if radians else found
        if wanted is not None:
            if len(found) > 1:
                raise FormatError(f"{len(found)} sheets; only one can be compared with parts")
            found = [compare_inventory(one, wanted) for one in found]
        if choice is None:
            return found
        if choice.isascii() and choice.isdigit() and int(choice) < len(found):
            return [found[int(choice)]]
        raise FormatError(f"no sheet has the index {quote(choice)}; there are {len(found)}")


def _read_table(
    text: str,
    parts: Mapping[str, Data] | None,
    known: model.NestingInstance | None,
    *,
    radians: bool,
) -> list[model.FoundLayout]:
    if parts is None:
        parts = {} if known is None else known.parts
    found = read_table(text, parts, radians=radians)
    if known is not None and len(known.containers) == 1:
        (container,) = known.containers.values()
        rest = {"container": container, **known.rest}
        found = [one._replace(data={**one.data, **rest}) for one in found]
    return found


def _from_radians(found: model.FoundLayout) -> model.FoundLayout:
    parts = [
        {
            name: [*map(_convert_turn, value)]
            if name in _ALLOWED and isinstance(value, list)
            else value
            for name, value in part.items()
        }
        for part in found.data["parts"]
    ]
    placements = [
        {**one, "turn": _convert_turn(one["turn"])}
        if isinstance(one, dict) and "turn" in one
        else one
        for one in found.data["placements"]
    ]
    return found._replace(data={**found.data, "parts": parts, "placements": placements})


def _convert_turn(turn: Any) -> Any:
    if not isinstance(turn, str):
        return turn
    return format_fraction(to_degrees(to_fraction(turn)))


def _parse_options(
    instance: str | None = None,
    container: _Container = None,
    tolerance: object = None,
    part: str | None = None,
    radians: bool = False,
    **options: Unpack[Options],
) -> tuple[str | None, _Container, Reading]:
    for name, value in (("instance", instance), ("container", container or None)):
        if not isinstance(value, str | None):
            raise FormatError(f"{name} is {quote(value)}, not a string")
    reading = Reading(tolerance, **options)
    reading.dots = True
    return instance, container, reading


def _parse_instance(text: str | None, reading: Reading) -> model.NestingInstance | None:
    if text is None:
        return None
    return read_instance(JsonNode(parse_json(text)), reading)


def _parse_each(
    text: str,
    known: model.NestingInstance | None,
    container: _Container,
    reading: Reading,
) -> list[model.FoundLayout]:
    """Read the layouts in a string, with a `flatten` function for those with curves."""
    found = _parse(text, known, container, reading)
    if container is False:
        found = [one._replace(data={**one.data}) for one in found]
        for one in found:
            one.data.pop("container", None)
    if text.lstrip()[:1] in "[{":
        # Layout JSON states its own errors.
        return found

    def flatten(
        k: int, names: Collection[str | None], tolerance: Fraction
    ) -> Mapping[str | None, Data]:
        data = _parse(text, known, container, reading.with_tolerance(tolerance))[k].data
        shapes = {part["id"]: part for part in data["parts"]} | {None: data.get("container", {})}
        return {name: shapes[name] for name in names if name in shapes}

    return [
        one
        if one.flatten
        or not any("error" in s for s in (one.data.get("container", {}), *one.data["parts"]))
        else one._replace(flatten=partial(flatten, k))
        for k, one in enumerate(found)
    ]


def _parse(
    text: str,
    known: model.NestingInstance | None,
    container: _Container,
    reading: Reading,
) -> list[model.FoundLayout]:
    first = text.lstrip()[:1]
    if not container and first == "{":
        found = _read_json(JsonNode(parse_json(text)), known, reading)
        if found:
            # These formats state no unit.
            reading.scale(None)
            return found
    if not container and first == "<" and reading.unit is None:
        from exactsweep.formats.curved.xml import parse_xml
        from exactsweep.formats.layouts.nest_svg import read_nest

        nest = read_nest(parse_xml(text), reading, known.containers if known else {})
        if nest is not None:
            drawn, sheets = nest
            notes = [*reading.list_hidden(), *reading.notes]
            if known is not None:
                notes += _compare_parts(drawn, known)
                for sheet in sheets:
                    model.require_within_strip(sheet.container, known, "the container")
            return model.make_layouts(sheets, known or drawn, notes)
    if known is not None:
        raise FormatError("not a solution to the instance")
    return draw_layouts(text, container, reading)


def _read_json(
    document: JsonNode, known: model.NestingInstance | None, reading: Reading
) -> list[model.FoundLayout]:
    if all(map(document.has, ("parts", "placements"))):
        if known is not None:
            raise FormatError("Layout JSON has its own parts and rules; omit --instance")
        return [model.FoundLayout("", _with_counts(document))]
    instance = known or read_instance(document, reading)
    if document.get("type", "").value == "cgshop2024_solution":
        return cgshop.read_solution(document, instance)
    if document.has("bins") and not document.has("items"):
        return packingsolver.read_solution(document, instance)
    if any(map(document.has, ("solution", "placed_items", "layout", "layouts"))):
        return jagua.read_solution(document, instance)
    if instance is not None:
        raise FormatError("an instance without a solution: nothing is placed")
    return []


def _with_counts(document: JsonNode) -> Data:
    parts = []
    for part in (document / "parts").each():
        counts = {"demand": (part / "demand").whole} if part.has("demand") else {}
        parts.append({**part.value, **counts} if isinstance(part.value, dict) else part.value)
    assert isinstance(document.value, dict)
    return {**document.value, "parts": parts}


def _compare_parts(drawn: model.NestingInstance, known: model.NestingInstance) -> list[str]:
    others = []
    for name, part in drawn.parts.items():
        if name not in known.parts:
            raise FormatError(f"its instance has no part {quote(name)}")
        if _make_shape(part) != _make_shape(known.parts[name]):
            others.append(name)
    if not others:
        return []
    what = f"part {others[0]} is" if len(others) == 1 else f"parts {', '.join(others)} are"
    return [f"{what} drawn differently from the instance; the instance is used"]


def _make_shape(part: Data) -> object:
    if "pieces" in part:
        return part["pieces"]
    rings = part["exterior"], part.get("holes", [])
    try:
        return Region(*rings)
    except PolygonError:
        return rings
