"""Contents of a file: polygons, direction of Y, unit, and omissions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple, TypeVar

from exactsweep.formats.error import FormatError

_Listed = TypeVar("_Listed")
_Read = TypeVar("_Read")
_SHOWN = 4


class Coordinates(NamedTuple):
    """The direction of Y, and the length of one unit in millimeters, None if unknown."""

    y_down: bool = False
    unit: Fraction | None = None


class PartList(list[_Listed]):
    """Polygons in a file, in order.

    Attributes:
        coordinates: the direction of Y and the unit.
        left_out: a reason for each skipped element: hidden, an ornament, or not a polygon.
        notes: further remarks.
        is_group: whether the polygons are one group, selected by FILE#GROUP.
    """

    is_group = False

    def __init__(
        self,
        items: Iterable[_Listed] = (),
        coordinates: Coordinates = Coordinates(),  # noqa: B008
        left_out: Iterable[str] = (),
        notes: Iterable[str] = (),
    ) -> None:
        super().__init__(items)
        self.coordinates, self.left_out, self.notes = coordinates, [*left_out], [*notes]

    def replaced(self, items: Iterable[_Read], left_out: Iterable[str] = ()) -> PartList[_Read]:
        """Return a list of other items from the same file, with further omissions."""
        return PartList(items, self.coordinates, [*self.left_out, *left_out], self.notes)

    def read_each(self, read: Callable[[_Listed, Remarks], Iterable[_Read]]) -> PartList[_Read]:
        """Read all items, and skip invalid ones; raises ValueError if none is left."""
        found: list[_Read] = []
        remarks = Remarks([*self.notes], [*self.left_out])
        kind: type[ValueError] | None = None
        for item in self:
            try:
                found += read(item, remarks)
            except ValueError as error:
                # Keep only the message, because an exception keeps its frames alive.
                kind = kind or type(error)
                remarks.left_out.append(str(error))
        if remarks.left_out and not found:
            raise (kind or FormatError)(summarize(remarks.left_out))
        return PartList(found, self.coordinates, remarks.left_out, remarks.notes)


class Remarks(NamedTuple):
    notes: list[str]
    left_out: list[str]


def summarize(reasons: Sequence[str]) -> str:
    more = len(reasons) - _SHOWN
    return "; ".join(reasons[:_SHOWN]) + (f"; and {more} more" if more > 0 else "")
