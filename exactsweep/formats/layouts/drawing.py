"""Layouts from drawings: each outline is a placed part or a hole."""

import re
from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import Literal

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.choice import describe_layer, get_layer
from exactsweep.formats.depth import Nested, describe_ambiguity, describe_place, nest_outlines
from exactsweep.formats.error import FormatError
from exactsweep.formats.folder import make_unique
from exactsweep.formats.layouts.containers import Sheet, find_sheets
from exactsweep.formats.layouts.model import IDENTITY_PLACEMENT, FoundLayout, write_rings
from exactsweep.formats.node import Data
from exactsweep.formats.parsing import parse_with
from exactsweep.formats.part_list import Remarks
from exactsweep.formats.reading import UNITS, Reading
from exactsweep.geometry.canonical import PolygonError, find_doubled_area
from exactsweep.geometry.edges import is_inside
from exactsweep.geometry.near import BoxRows, bound_points
from exactsweep.numbers.number import Point
from exactsweep.words import count

_LINE = re.compile(r"line \d+")


def draw_layouts(
    text: str, container: str | Literal[False] | None, reading: Reading
) -> list[FoundLayout]:
    """Make a layout for each container.

    Unreadable outlines are rejected, since skipping one could falsify the verdict.
    """
    flat = reading.without_nesting()
    flat.separate = reading.nested is not False
    drawn = parse_with(text, flat)
    notes = [*drawn.left_out, *drawn.notes]
    notes += [f"skipped: {one.fault}" for one in drawn if one.fault and one.ornament]
    plain = [one for one in drawn if not one.ornament]
    if not plain:
        raise FormatError(notes[0] if notes else "the drawing has no outline")
    remarks = Remarks(notes, notes)
    outlines: list[Candidate] = []
    for one in plain:
        try:
            outlines += [] if one.fault else one.split(remarks)
        except PolygonError:
            # Keep the invalid shape; the judge reports it.
            outlines.append(one)
    if not outlines:
        raise FormatError(plain[0].fault)
    sheets = (
        [Sheet(None, [], outlines, [])] if container is False else find_sheets(outlines, container)
    )
    is_nested = reading.nested is not False
    nests = [
        nest_outlines(sheet.outlines) if is_nested else Nested(sheet.outlines, [], [], [])
        for sheet in sheets
    ]
    unchecked = _list_open(plain, [part for found in nests for part in found.outlines])
    if all(not sheet.outlines for sheet in sheets):
        raise FormatError("only one outline found; a layout needs a container and parts")
    # SVG without a unit is in pixels.
    sizes = {size: name for name, size in UNITS.items() if name != "px"}
    unit = sizes.get(drawn.coordinates.unit or Fraction(0), "")
    found = []
    for k, (sheet, nest) in enumerate(zip(sheets, nests, strict=True)):
        name = f"sheet {k}" if len(sheets) > 1 else ""
        layout = _make_layout(sheet, nest)
        found.append(
            layout._replace(
                name=name,
                notes=(*notes, *layout.notes),
                unchecked=(*unchecked, *layout.unchecked),
                unit=unit,
            )
        )
    return found


def _list_open(outlines: Sequence[Candidate], parts: Sequence[Candidate]) -> list[str]:
    """Describe engraving: open shapes on layers without closed outlines, or on parts."""
    rejected = [one for one in outlines if one.fault]
    if not rejected:
        return []
    layers = {one.layer for one in outlines if not one.fault}
    rows = BoxRows([bound_points(part.vertices()) for part in parts])
    left, engraved = Counter[str | None](), list[str]()
    for one in rejected:
        layer = get_layer(one)
        if one.layer not in layers:
            left[one.layer] += 1
        elif one.points and any(_is_on(one, parts[k]) for k in rows.find(bound_points(one.points))):
            engraved.append(one.fault)
        else:
            hint = "" if layer is None else f" (--ignore-layer {layer} skips its layer)"
            raise FormatError(f"{one.fault}{hint}")
    remarks = [
        f"{count(number, 'shape')} on {describe_layer(layer)}, none of them closed"
        for layer, number in left.items()
    ]
    if engraved:
        match = _LINE.search(engraved[0])
        where = f" ({match[0]}{', ...' if len(engraved) > 1 else ''})" if match else ""
        remarks.append(f"{count(len(engraved), 'open shape')} on parts{where}")
    return remarks


def _is_on(shape: Candidate, part: Candidate) -> bool:
    """Return whether all points of an open shape lie on a part; False for outlines."""
    # A hole on the layer of the shape, not on that of the part, is engraving.
    holes = [h for h in part.holes() if h.layer in (None, part.layer) or h.layer != shape.layer]
    rings = [ring.vertices() for ring in (part, *holes)]
    return all(is_inside(point, rings) for point in shape.points)


def _make_layout(sheet: Sheet, found: Nested) -> FoundLayout:
    parts, notes = found.outlines, _report_holes(found)
    unchecked = [
        f"{describe_ambiguity(outline, around)} (skipped)" for outline, around in found.ambiguous
    ]
    unchecked += _find_lookalikes(found) + _find_artwork(found)
    if sheet.defects:
        number = len(sheet.defects)
        read = "read as a defect" if number == 1 else "read as defects"
        where = "on the layer or in the group of the container"
        notes.append(f"{count(number, 'outline')} {where} {read}")
    if sheet.copies:
        notes.append(f"skipped: {count(len(sheet.copies), 'duplicate')} of the container")
    names = make_unique(
        # "0" is the default layer of DXF.
        [
            one.name or (one.layer if one.layer != "0" else None) or str(k)
            for k, one in enumerate(parts)
        ]
    )
    data: Data = {
        "parts": [{"id": name, **write_rings(one)} for name, one in zip(names, parts, strict=True)],
        "placements": [IDENTITY_PLACEMENT | {"part": name} for name in names],
    }
    if sheet.container is not None:
        data["container"] = write_rings(sheet.container)
    if sheet.defects:
        data["defects"] = [write_rings(one) for one in sheet.defects]
    drawn_as: dict[str | None, Candidate] = dict(zip(names, parts, strict=True))
    if sheet.container is not None:
        drawn_as[None] = sheet.container
    shapes = [data.get("container", {}), *data["parts"]]
    is_curved = any("error" in shape for shape in shapes)
    return FoundLayout(
        "",
        data,
        tuple(notes),
        tuple(unchecked),
        tuple(match[0] if (match := _LINE.search(one.place)) else "" for one in parts),
        flatten=partial(_flatten, drawn_as) if is_curved else None,
    )


def _flatten(
    drawn_as: Mapping[str | None, Candidate], names: Collection[str | None], tolerance: Fraction
) -> Mapping[str | None, Data]:
    found: dict[str | None, Data] = {}
    for name in names:
        finer = drawn_as[name].finer if name in drawn_as else None
        one = finer(tolerance) if finer else None
        if one is not None:
            found[name] = write_rings(one)
    return found


def _report_holes(found: Nested) -> list[str]:
    """Report outlines read as holes, since overlapping parts look the same."""
    if not found.holes:
        return []
    first = ", ".join(
        f"{describe_place(one)} in {describe_place(other)}" for one, other in found.holes[:2]
    )
    more = ", ..." if len(found.holes) > 2 else ""
    number = len(found.holes)
    what = f"{count(number, 'outline')} inside others"
    read = "read as a hole, not as a part" if number == 1 else "read as holes, not as parts"
    return [f"{what} {read}: {first}{more} (--flat reads each outline as a part)"]


def _find_lookalikes(found: Nested) -> list[str]:
    """Report holes of the size of a part, since they may be overlapping parts."""
    shapes = {_measure(one.vertices()): one for one in reversed(found.outlines)}
    alike = [
        (one, around, shapes[shape])
        for one, around in found.holes
        if (shape := _measure(one.vertices())) in shapes
    ]
    return [
        f"whether {describe_place(one)} is a hole of {describe_place(around)}, or a part on it: "
        f"it has the size of the part {describe_place(part)}"
        for one, around, part in alike[:1]
    ] + ([f"{len(alike) - 1} more like it"] if len(alike) > 1 else [])


def _find_artwork(found: Nested) -> list[str]:
    """Report a hole on another layer than its part, if it contains a part on that part's layer."""
    around = {id(hole): part for hole, part in found.holes}
    doubtful = [
        (hole, around[id(hole)], inner)
        for inner, hole in found.islands
        if id(hole) in around and hole.layer and inner.layer == around[id(hole)].layer != hole.layer
    ]
    return [
        f"whether {describe_place(hole)} on {describe_layer(hole.layer)} is a hole of "
        f"{describe_place(part)}; if not, {describe_place(inner)} overlaps that part "
        "(--flat reads each outline as a part, "
        f"--ignore-layer {hole.layer} skips the layer)"
        for hole, part, inner in doubtful[:1]
    ]


def _measure(ring: Sequence[Point]) -> tuple[int, str]:
    """Return the number of vertices and the rounded area, invariant under rigid motions."""
    area = abs(Fraction(find_doubled_area(ring)))
    digits = f"{area.numerator / area.denominator:.6e}" if area < Fraction(10) ** 300 else ""
    return len(ring) - (ring[0] == ring[-1]), digits
