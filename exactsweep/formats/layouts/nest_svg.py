"""SVG of nesting programs, whose parts have exact translations and rotations.

sparrow and jagua-rs draw the container as a group `container_N`, formerly `bin_N`, and place
definitions `item_K` by `use`. SVGnest and Deepnest write a group for each part, next to a sheet of
class `bin` or with a stroke of #00ff00. All programs write `translate(x y) rotate(degrees)`; the
rotation applies first.

Source: `io/svg/layout_to_svg.rs` of jagua-rs, `svgnest.js` of SVGnest, `export.service.ts` of
Deepnest.
"""

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from xml.etree.ElementTree import Element

from exactsweep.formats.curved.svg import DRAWN, SHAPES, explain_hidden, read_svg
from exactsweep.formats.curved.svg_placed import PlacedElement, Style, find_link, name_kind
from exactsweep.formats.curved.xml import line
from exactsweep.formats.decimals import DECIMAL, read_decimal
from exactsweep.formats.depth import nest_candidates
from exactsweep.formats.error import FormatError
from exactsweep.formats.layouts.model import FilledSheet, NestingInstance, write_rings
from exactsweep.formats.node import Data
from exactsweep.formats.reading import Reading
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import prefix_errors, quote

_MOTION = re.compile(
    rf"\s*translate\(\s*({DECIMAL})(?:[\s,]+({DECIMAL}))?\s*\)"
    rf"(?:[\s,]*rotate\(\s*({DECIMAL})\s*\))?\s*"
)
_SHEET = "#00ff00"


def read_nest(
    root: Element, reading: Reading, containers: Mapping[str, Data]
) -> tuple[NestingInstance, list[FilledSheet]] | None:
    """Read parts and sheets; None for another format. `containers` override those drawn."""
    drawing = _NestDrawing(root, reading)
    sheets = list(_jagua(drawing, containers)) or list(_nested(root, drawing))
    if not sheets:
        return None
    return NestingInstance("jagua", drawing.parts, {}, {}, {}, ()), sheets


class _NestDrawing:
    def __init__(self, root: Element, reading: Reading) -> None:
        self.reading = reading
        self.style = Style(root)
        self.placed = {root: PlacedElement(root, None, reading, style=self.style)}
        self.parts: dict[str, Data] = {}
        for element in root.iter():
            shown = []
            for child in element:
                placed = PlacedElement(child, self.placed[element], reading)
                if not reading.skip_hidden(explain_hidden(placed)):
                    self.placed[child] = placed
                    shown.append(child)
            element[:] = shown
        self.named = {e.attrib["id"]: e for e in reversed(self.placed) if "id" in e.attrib}

    def read_one_shape(self, elements: Iterable[Element], within: Element) -> Data:
        """Read elements that draw a single shape, ignoring the transformation of `within`."""
        rule = self.placed[within].inherited("fill-rule", "nonzero")
        place = Element("svg", {"#line": "1", "style": f"fill-rule: {rule}"})
        place.extend(elements)
        outlines = read_svg(place, self.reading, self.style)
        found = nest_candidates(outlines) if len(outlines) > 1 else outlines
        if len(found) != 1:
            lines = ", ".join(line(element) for element in elements)
            raise FormatError(f"line {lines}: expected one outline, found {len(found)}")
        return write_rings(found[0])

    def read_motion(self, element: Element) -> Data:
        placed = self.placed[element]
        with prefix_errors(placed.place, FormatError):
            match = _MOTION.fullmatch(placed.transform)
        if match is None or not element.attrib.keys().isdisjoint("xy"):
            raise FormatError(f"{placed.place}: expected translate(...) rotate(...)")
        x, y, turn = (format_fraction(read_decimal(number or "0")) for number in match.groups())
        return {"turn": turn, "move": [x, y]}

    def require_all(self, within: Element, read: Iterable[Element]) -> None:
        known = {*read}
        for element in within.iter():
            placed, kind = self.placed[element], name_kind(element)
            around = placed.parent and placed.parent.element
            if kind not in DRAWN or around in known:
                known.add(element)
            elif kind in SHAPES and element not in known:
                raise FormatError(f"{placed.place}: neither a sheet nor a placed part")


def _jagua(drawing: _NestDrawing, containers: Mapping[str, Data]) -> Iterator[FilledSheet]:
    named, placed = drawing.named, drawing.placed
    around = next(
        (e for name, e in named.items() if re.fullmatch(r"(?:container|bin)_\d+", name)), None
    )
    if around is None or "items" not in named:
        return
    container = containers.get(around.attrib["id"].rpartition("_")[2])
    zones = named.get("quality_zones")
    if container is None and zones is not None and len(zones):
        # Zones of quality 0 are defects, but the drawn container lacks them.
        raise FormatError(f"line {line(zones)}: quality zones need --instance")
    container = container or drawing.read_one_shape([around], around)
    items, outer = placed[named["items"]], placed[around].parent
    if outer is None or items.matrix != outer.matrix:
        raise FormatError(f"{items.place}: moved differently from the container")
    uses = [child for child in items.element if name_kind(child) == "use"]
    drawing.require_all(items.element, uses)
    placements = []
    for use in uses:
        link = find_link(use)
        name = link.removeprefix("#item_")
        if f"item_{name}" not in named:
            raise FormatError(f"line {line(use)}: use: no item {quote(link)}")
        if name not in drawing.parts:
            shape = drawing.read_one_shape([named[f"item_{name}"]], use)
            drawing.parts[name] = {"id": name, **shape}
        placements.append({"part": name, **drawing.read_motion(use)})
    yield FilledSheet(container, placements, places=_list_lines(uses))


def _nested(root: Element, drawing: _NestDrawing) -> Iterator[FilledSheet]:
    """Read the sheets of SVGnest and Deepnest; equal outlines are one part."""
    known: dict[str, str] = {}
    read: list[Element] = []
    for group in root.iter():
        outlines = [child for child in group if _is_sheet(child)]
        moved = [child for child in group if name_kind(child) == "g" and len(child)]
        read += outlines
        if not outlines or not moved:
            continue
        read += moved
        placements = []
        for child in moved:
            shape = drawing.read_one_shape(child, child)
            key = json.dumps(shape)
            if key not in known:
                known[key] = str(len(known))
                drawing.parts[known[key]] = {"id": known[key], **shape}
            placements.append({"part": known[key], **drawing.read_motion(child)})
        container = drawing.read_one_shape(outlines, group)
        yield FilledSheet(container, placements, places=_list_lines(moved))
    if known:
        drawing.require_all(root, read)


def _list_lines(elements: Iterable[Element]) -> tuple[str, ...]:
    return tuple(f"line {line(element)}" for element in elements)


def _is_sheet(element: Element) -> bool:
    stroke = element.get("stroke", "") + element.get("style", "")
    return "bin" in element.get("class", "").split() or (
        _SHEET in stroke.lower() and name_kind(element) != "g"
    )
