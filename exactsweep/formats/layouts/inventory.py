"""Comparison of a layout with an inventory: the parts in a drawing or a folder."""

from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.formats.error import FormatError
from exactsweep.formats.files import show_path
from exactsweep.formats.folder import list_parts, make_unique
from exactsweep.formats.layouts import congruence
from exactsweep.formats.layouts.model import FoundLayout, read_rounded, write_rounded
from exactsweep.formats.node import Data, write_ring
from exactsweep.formats.reading import Reading
from exactsweep.formats.rounded import RoundedOutline
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.region import Region
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import quote
from exactsweep.numbers.number import to_fraction
from exactsweep.words import count


class WantedPart(NamedTuple):
    name: str
    region: Region
    error: Fraction  # of its curves
    number: int  # of required placements
    rounded: RoundedOutline | None = None

    def write_shape(self) -> Data:
        if self.rounded is not None:
            return write_rounded(self.rounded)
        holes = [write_ring(hole.vertices) for hole in self.region.holes]
        shape = {"exterior": write_ring(self.region.exterior.vertices), "holes": holes}
        return shape | ({"error": format_fraction(self.error)} if self.error else {})

    def find_map(self, part: Data) -> congruence.Congruence | None:
        """Find the map to a Layout JSON part; None if they are not congruent."""
        if len(part.get("pieces", ())) > 1:
            return None
        drawn = read_rounded(part)
        if self.rounded is not None and drawn is not None:
            return congruence.find_rounded_congruence(self.rounded, drawn)
        if drawn is not None:
            return None
        return congruence.find_congruence(
            self.region, Region(part["exterior"], part.get("holes", []))
        )


def read_inventory(path: str, reading: Reading) -> list[WantedPart]:
    listing = list_parts([path], reading.tolerance, **(reading.options | {"nested": True}))
    found: list[WantedPart] = []
    names = make_unique([part.name for part in listing.parts])
    for name, part in zip(names, listing.parts, strict=True):
        if part.candidate.ornament:
            continue
        wanted = WantedPart(
            name,
            part.candidate.region(),
            part.candidate.error,
            1,
            None if part.candidate.holes() else part.candidate.rounded,
        )
        for k, one in enumerate(found):
            same = one.find_map(wanted.write_shape())
            if same is not None and same.exact:
                found[k] = one._replace(number=one.number + 1)
                break
        else:
            found.append(wanted)
    if not found:
        raise FormatError(f"{show_path(path)}: neither a nesting instance nor parts")
    return found


def compare_inventory(found: FoundLayout, wanted: Sequence[WantedPart]) -> FoundLayout:
    """Make a layout of the required parts, so that missing, surplus or changed parts are faults.

    A part of the layout congruent to a required part is replaced by a placement of it. A nearly
    congruent part also meets the demand, but keeps its shape. Other parts are surplus.
    """
    parts: dict[str, Data] = {part["id"]: part for part in found.data["parts"]}
    used = Counter(placement["part"] for placement in found.data["placements"])
    turned = {
        placement["part"]
        for placement in found.data["placements"]
        if placement.get("turn", "0") != "0" or placement.get("mirrored")
    }
    left = {one.name: one.number for one in wanted}
    exact: dict[str, tuple[WantedPart, Data]] = {}
    others: list[Data] = []
    notes: list[str] = []
    for name, part in parts.items():
        match = _find_match(part, wanted, left)
        if match is None:
            others.append({**part, "demand": 0})
            near = next((one for one in wanted if _is_named(name, one.name)), None)
            what = "is not in the instance" if near is None else "has another shape in the instance"
            notes.append(f"part {quote(name)} {what}")
            continue
        one, placed = match
        if placed is None or name in turned:
            take = min(used[name], left[one.name])
            others.append({**part, "demand": take})
            left[one.name] -= take
            if placed is None:
                notes.append(
                    f"part {quote(name)} is nearly congruent to part {quote(one.name)} in the "
                    "instance"
                )
        else:
            exact[name] = one, placed
    taken = {part["id"] for part in others}
    names = {one.name: _find_name(one.name, taken) for one in wanted}
    placements = []
    for placement in found.data["placements"]:
        name = placement["part"]
        if name not in exact:
            placements.append(placement)
            continue
        one, placed = exact[name]
        pairs = zip(placed["move"], placement["move"], strict=True)
        move = [format_fraction(to_fraction(a) + to_fraction(b)) for a, b in pairs]
        placements.append({**placed, "part": names[one.name], "move": move})
    shapes = [
        {
            "id": names[one.name],
            **one.write_shape(),
            "demand": left[one.name],
        }
        for one in wanted
    ]
    data = {**found.data, "parts": [*shapes, *others], "placements": placements}
    notes.insert(0, f"{count(sum(one.number for one in wanted), 'part')} in the instance")
    return found._replace(data=data, notes=(*found.notes, *notes))


def _find_match(
    part: Data, wanted: Sequence[WantedPart], left: dict[str, int]
) -> tuple[WantedPart, Data | None] | None:
    """Match a part of the layout with a required part; add its placement if exactly congruent."""
    found: tuple[WantedPart, Data | None] | None = None
    for one in sorted(wanted, key=lambda one: not _is_named(part["id"], one.name)):
        try:
            same = one.find_map(part)
        except PolygonError:
            return None
        if same is not None and same.exact:
            turn = [*map(format_fraction, same.turn)]
            placed: Data = {"turn": turn, "move": [*map(format_fraction, same.move)]}
            return one, placed | ({"mirrored": True} if same.mirrored else {})
        if found is None and (same is not None or _is_alike(one, part)):
            found = one, None
    return found


def _is_alike(wanted: WantedPart, part: Data) -> bool:
    """Return whether a required part and a curved shape have equal areas within their errors."""
    error = wanted.error + Fraction(str(part.get("error", 0)))
    if not error or "pieces" in part:
        return False
    one, other = wanted.region, Region(part["exterior"], part.get("holes", []))
    if len(one.holes) != len(other.holes):
        return False
    around = sum(
        float((a.x - b.x) ** 2 + (a.y - b.y) ** 2) ** 0.5
        for ring in one.rings
        for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)
    )
    return bool(abs(float(one.area - other.area)) <= 2 * around * float(error))


def _is_named(name: str, wanted: str) -> bool:
    return name == wanted or name.rpartition("-")[0] == wanted


def _find_name(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "'"
    return name
