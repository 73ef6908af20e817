"""Layouts with known faults, for tests of judges of layouts."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from exactsweep.corpus.names import require_known
from exactsweep.corpus.shipped import read_shipped
from exactsweep.layout import Layout
from exactsweep.numbers.error import explain_type_errors


class LayoutCase(NamedTuple):
    """A layout with its expected faults.

    Attributes:
        id: the name of the case, whose meaning never changes.
        title: a description in one line.
        data: the layout as JSON data.
        expected: "valid"; "contacts"; sometimes "density" and the least "distance_squared" of two
            parts; and "faults", each with "kind", "placements", and possibly "part", "number",
            "distance_squared" and "move_squared", the squared length of the shortest repairing
            move, null if there is none or it is irrational. Numbers are reduced rationals.
        note: the origin of the case, or a remark.
    """

    id: str
    title: str
    data: dict[str, Any]
    expected: dict[str, Any]
    note: str = ""

    @property
    def layout(self) -> Layout:
        """The Layout, read from `data`."""
        return Layout.from_json(self.data)


@explain_type_errors
def layout_cases() -> Iterator[LayoutCase]:
    """Yield the shipped layouts.

    Example:
        >>> next(layout_cases()).title
        'Six tiles fill a box'
    """
    for data in read_shipped("layouts")["cases"]:
        yield LayoutCase(
            data["id"], data["title"], data["layout"], data["expected"], data.get("note", "")
        )


@explain_type_errors
def find_layout_case(id: str) -> LayoutCase:
    """Find a shipped layout by its id, or raise UnknownNameError.

    Example:
        >>> find_layout_case("layouts-slot").expected["valid"]
        True
    """
    found = {case.id: case for case in layout_cases()}
    return found[require_known(id, found, "layout")]
