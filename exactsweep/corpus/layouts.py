"""Layouts with known faults, and sums of a shape and a path with exact answers."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from exactsweep.corpus.names import require_known
from exactsweep.corpus.shipped import read_shipped
from exactsweep.geometry.polyline import Polyline
from exactsweep.geometry.region import Region
from exactsweep.layout import Layout
from exactsweep.numbers.error import explain_type_errors


class LayoutCase(NamedTuple):
    """A layout with its expected faults.

    Attributes:
        data: the layout as JSON data.
        expected: "valid"; "contacts"; sometimes "density" and the minimum "distance_squared" of two
            parts; and "faults", each with "kind", "placements", and possibly "part", "number",
            "distance_squared" and "move_squared", the squared length of the shortest repairing
            move, null if there is none or it is irrational. Numbers are reduced rationals.
    """

    id: str  # its meaning never changes
    title: str
    data: dict[str, Any]
    expected: dict[str, Any]
    note: str = ""  # the origin of the case, or a remark

    @property
    def layout(self) -> Layout:
        """The Layout, read from `data`."""
        return Layout.from_json(self.data)


@explain_type_errors
def layout_cases() -> Iterator[LayoutCase]:
    """Yield the shipped layouts.

    >>> next(layout_cases()).title
    'Six tiles fill a box'
    """
    for data in read_shipped("layouts")["cases"]:
        yield LayoutCase(
            data["id"], data["title"], data["layout"], data["expected"], data.get("note", "")
        )


@explain_type_errors
def find_layout_case(id: str) -> LayoutCase:
    """Find a shipped layout by its id; raise UnknownNameError if there is none.

    >>> find_layout_case("layouts-slot").expected["valid"]
    True
    """
    found = {case.id: case for case in layout_cases()}
    return found[require_known(id, found, "layout")]


class PathCase(NamedTuple):
    """A shape, a path, and their exact Minkowski sum.

    In the JSON `data`, "shape" and "expected" have "exterior" and "holes", and "path" has "points"
    and "closed"; numbers are strings.
    """

    id: str
    title: str
    shape: Region
    path: Polyline
    sum: Region
    data: dict[str, Any]
    note: str = ""  # the purpose of the case


@explain_type_errors
def path_cases() -> Iterator[PathCase]:
    """Yield the shipped sums with paths.

    >>> next(path_cases()).sum.area
    Fraction(9255, 1)
    """
    for data in read_shipped("paths")["cases"]:
        path = Polyline(data["path"]["points"], closed=data["path"]["closed"])
        shapes = [
            Region(one["exterior"], one.get("holes", ()))
            for one in (data["shape"], data["expected"])
        ]
        note = data.get("note", "")
        yield PathCase(data["id"], data["title"], shapes[0], path, shapes[1], data, note)


@explain_type_errors
def find_path_case(id: str) -> PathCase:
    """Find a shipped sum by its id; raise UnknownNameError if there is none.

    >>> find_path_case("paths-loop").sum.holes
    (Polygon([(2, 2), (9, 2), (9, 9), (2, 9)]),)
    """
    found = {case.id: case for case in path_cases()}
    return found[require_known(id, found, "sum with a path")]
