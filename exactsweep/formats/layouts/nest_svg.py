"""SVG as nesting programs write it: parts in groups or by `use`, each moved and turned.

sparrow and jagua-rs draw the container as a group `container_N`, formerly `bin_N`, and place
definitions `item_K` by `use`. SVGnest and Deepnest put each part into a group of its own, beside a
sheet of class `bin`, or with a stroke of #00ff00. All write `translate(x y) rotate(degrees)` and
mean the turn first. Angles stay as they are written, so that none needs a tolerance.

Source: `io/svg/layout_to_svg.rs` of jagua-rs, `svgnest.js` of SVGnest, `export.service.ts` of
Deepnest.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

from exactsweep.formats.curved.svg import read_svg
from exactsweep.formats.curved.svg_style import find_link, name_kind
from exactsweep.formats.curved.xml import line
from exactsweep.formats.decimals import DECIMAL, read_decimal
from exactsweep.formats.error import FormatError
from exactsweep.formats.layouts.found import FilledSheet, NestingInstance, write_rings
from exactsweep.formats.nesting import nest_candidates
from exactsweep.formats.node import Data
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import quote

if TYPE_CHECKING:
    from exactsweep.formats.reading import Reading

_MOTION = re.compile(
    rf"\s*translate\(\s*({DECIMAL})(?:[\s,]+({DECIMAL}))?\s*\)"
    rf"(?:[\s,]*rotate\(\s*({DECIMAL})\s*\))?\s*"
)
_SHEET = "#00ff00"


def read_nest(
    root: Element, reading: Reading, containers: Mapping[str, Data]
) -> tuple[NestingInstance, list[FilledSheet]] | None:
    """Read the SVG of a nesting program.

    Args:
        root: of the document, as `parse_xml` parsed it.
        reading: how its shapes are read.
        containers: those of an instance, by id, which go before the ones that are drawn.

    Returns:
        The parts, without demands, and the sheets; None if no program that is known wrote it.

    Raises:
        FormatError: a part or a sheet cannot be read.
    """
    parts: dict[str, Data] = {}
    sheets = list(_jagua(root, reading, parts, containers)) or list(_nested(root, reading, parts))
    if not sheets:
        return None
    return NestingInstance("jagua", parts, {}, {}, {}, ()), sheets


def _jagua(
    root: Element, reading: Reading, parts: dict[str, Data], containers: Mapping[str, Data]
) -> Iterator[FilledSheet]:
    named = {e.attrib["id"]: e for e in root.iter() if "id" in e.attrib}
    around = next(
        (e for name, e in named.items() if re.fullmatch(r"(?:container|bin)_\d+", name)), None
    )
    if around is None or "items" not in named:
        return
    container = containers.get(around.attrib["id"].rpartition("_")[2])
    zones = named.get("quality_zones")
    if container is None and zones is not None and len(zones):
        # Those of quality 0 are defects of the container, which is drawn without them.
        raise FormatError(f"line {line(zones)}: zones of quality are read with --instance only")
    container = container or _one_shape([around], reading)
    placements = []
    for use in named["items"]:
        if name_kind(use) != "use":
            continue
        link = find_link(use)
        name = link.removeprefix("#item_")
        if f"item_{name}" not in named:
            raise FormatError(f"line {line(use)}: use: no item {quote(link)}")
        if name not in parts:
            parts[name] = {"id": name, **_one_shape([named[f"item_{name}"]], reading)}
        motion = _read_motion(use)
        if motion is None:
            raise FormatError(f"line {line(use)}: use: not a move and a turn")
        placements.append({"part": name, **motion})
    yield FilledSheet(container, placements)


def _nested(root: Element, reading: Reading, parts: dict[str, Data]) -> Iterator[FilledSheet]:
    """Read sheets of SVGnest and Deepnest; equal outlines are one part."""
    known: dict[str, str] = {}
    for group in root.iter():
        outlines = [child for child in group if _is_sheet(child)]
        moved = [(child, _read_motion(child)) for child in group if name_kind(child) == "g"]
        if not outlines or not moved:
            continue
        placements = []
        for child, motion in moved:
            if motion is None:
                raise FormatError(f"line {line(child)}: g: not a move and a turn")
            shape = _one_shape(child, reading)
            key = json.dumps(shape)
            if key not in known:
                known[key] = str(len(known))
                parts[known[key]] = {"id": known[key], **shape}
            placements.append({"part": known[key], **motion})
        yield FilledSheet(_one_shape(outlines, reading), placements)


def _is_sheet(element: Element) -> bool:
    stroke = element.get("stroke", "") + element.get("style", "")
    return "bin" in element.get("class", "").split() or (
        _SHEET in stroke.lower() and name_kind(element) != "g"
    )


def _read_motion(element: Element) -> Data | None:
    match = _MOTION.fullmatch(element.get("transform", ""))
    if match is None:
        return None
    x, y, turn = (format_fraction(read_decimal(number or "0")) for number in match.groups())
    return {"turn": turn, "move": [x, y]}


def _one_shape(elements: Element | list[Element], reading: Reading) -> Data:
    """Read what elements draw together, without the motion of their group: an outline and holes."""
    place = Element("svg")
    place.attrib["#line"] = "1"
    place.extend(elements)
    outlines = read_svg(place, reading)
    found = nest_candidates(outlines) if len(outlines) > 1 else outlines
    if len(found) != 1:
        lines = ", ".join(line(element) for element in elements)
        raise FormatError(f"line {lines}: {len(found)} outlines, which are not one part")
    return write_rings(found[0])
