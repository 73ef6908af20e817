"""Minkowski sums of a shape and a path, with exact answers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from exactsweep.corpus.names import require_known
from exactsweep.corpus.shipped import read_shipped
from exactsweep.geometry.polyline import Polyline
from exactsweep.geometry.region import Region
from exactsweep.numbers.error import explain_type_errors


class PathCase(NamedTuple):
    """A shape, a path, and their exact Minkowski sum.

    Attributes:
        id: the name of the case, whose meaning never changes.
        title: a description in one line.
        shape: a Region.
        path: a Polyline.
        sum: a Region.
        data: the case as JSON data: "shape" and "expected" have "exterior" and "holes", and "path"
            has "points" and "closed"; numbers are strings.
        note: the purpose of the case.
    """

    id: str
    title: str
    shape: Region
    path: Polyline
    sum: Region
    data: dict[str, Any]
    note: str = ""


@explain_type_errors
def path_cases() -> Iterator[PathCase]:
    """Yield the shipped sums with paths.

    Example:
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
    """Find a shipped sum by its id, or raise UnknownNameError.

    Example:
        >>> find_path_case("paths-loop").sum.holes
        (Polygon([(2, 2), (9, 2), (9, 9), (2, 9)]),)
    """
    found = {case.id: case for case in path_cases()}
    return found[require_known(id, found, "sum with a path")]
