"""Verification of certificates by `standalone.prove`, and comparison with given polygons."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby
from typing import Any, NamedTuple

from exactsweep.check.standalone import (
    SHAPE,
    Refused,
    Ring,
    area,
    edges,
    need,
    node,
    place,
    point,
    prove,
    read,
    rings_of,
)
from exactsweep.geometry.polyline import Polyline
from exactsweep.geometry.reading import read_interface, read_point
from exactsweep.numbers.error import ExactSweepError, explain_type_errors, prefix_errors
from exactsweep.numbers.number import Point


class Verification(NamedTuple):
    """The verdict on a certificate: proved, or the first reason why it is not.

    The witness, if there is one, is a point of the loop, edge, shape or layout named in the reason.
    For the exterior, the holes and the exact fits, it is a translation of the generatrix.
    """

    proved: bool
    reason: str
    witness: Point | None


@explain_type_errors
def verify(
    certificate: Any,
    *,
    generatrix: Any = None,
    directrix: Any = None,
    part: Any = None,
    container: Any = None,
    shape: Any = None,
    path: Any = None,
    max_steps: int | None = None,
) -> Verification:
    """Decide whether a certificate proves its answer.

    Args:
        certificate: the output of `json.loads`, from any source: the certificate of a sweep, a
            no-fit polygon, an inner fit, a sum with a path or a layout.
        generatrix: the required polygon G: a Polygon, its vertices, a Region or an object with a
            `__geo_interface__`, such as a shapely polygon; by default any.
        directrix: the required polygon D, in any of these forms.
        part: the required part of an inner fit.
        container: the required container of an inner fit.
        shape: the required shape of a sum with a path.
        path: the required path of the sum: a Polyline, or what Polyline reads.
        max_steps: the limit on the work, in steps of at most a microsecond if numbers are short.
            The default grows with the certificate: 100 kB end within half a minute.

    Returns:
        A Verification. The reason is "proved" or names the wrong loop, edge, fit or piece. No
        certificate makes `verify` raise an exception.

    Raises:
        ExactSweepError: a required shape is not a polygon or a path, and the message begins with
            its name; or `max_steps` is not a positive int.

    Cost: O(k) for k pairs of an edge and a sum of pieces whose boxes meet; O(n log n) for n pieces
    of a layout with O(n) pairs of nearby pieces.
    Source: the docstring of `exactsweep.check.standalone`.

    >>> verify({"format": "exactsweep certificate"})
    Verification(proved=False, reason='version: not 3', witness=None)
    """
    if max_steps is not None and (type(max_steps) is not int or max_steps < 1):
        raise ExactSweepError("max_steps must be an int, at least 1")
    names = "generatrix", "directrix", "part", "container", "shape"
    asked = zip(names, (generatrix, directrix, part, container, shape), strict=True)
    given = {name: _read_given(polygon, name) for name, polygon in asked if polygon is not None}
    walked = None if path is None else _read_path(path)
    try:
        prove(certificate, max_steps)
        for name, rings in given.items():
            need(name in certificate, f"the certificate has no {name}")
            is_same = _outline(rings_of(read(name, certificate[name], SHAPE))) == _outline(rings)
            need(is_same, f"{name} of the certificate is not the given polygon")
        if walked is not None:
            need("path" in certificate, "the certificate has no path")
            listed = read("path", certificate["path"], [point])
            is_same = [p for p, _ in groupby(listed)] == walked
            need(is_same, "path of the certificate is not the given path")
    except Refused as refused:
        witness = refused.witness and Point(*refused.witness)
        return Verification(False, str(refused), witness)
    return Verification(True, "proved", None)


def _read_given(polygon: Any, name: str) -> list[Ring]:
    is_own = hasattr(polygon, "holes")
    with prefix_errors(name):
        rings = (polygon.exterior, *polygon.holes) if is_own else read_interface(polygon)
        try:
            listed = [getattr(points, "vertices", points) for points in rings or [polygon]]
            return [_read_points(points) for points in listed]
        except TypeError:
            raise ExactSweepError(f"{type(polygon).__name__} is not a polygon") from None


def _read_path(path: Any) -> Ring:
    with prefix_errors("path"):
        line = Polyline(path)
    return _read_points([*line.points, *line.points[: line.closed]])


def _read_points(points: Iterable[Iterable[object]]) -> Ring:
    return [node(*read_point(p, f"vertex {k}")) for k, p in enumerate(points)]


def _outline(rings: list[Ring]) -> list[Ring]:
    """Normalize rings, and sort the holes."""
    exterior, *holes = map(normalize, rings)
    return [exterior, *sorted(holes)]


def normalize(points: Ring) -> Ring:
    """Convert a ring to counter-clockwise corners, starting at the least vertex."""
    points = [p for k, p in enumerate(points) if p != points[k - 1]]
    around = edges(points if area(edges(points)) > 0 else points[::-1])
    bent = [
        p
        for k, (p, _, (a, b, _)) in enumerate(around)
        if around[k - 1][2][0] * b != around[k - 1][2][1] * a
    ]
    least = bent.index(min(bent, key=place)) if bent else 0
    return bent[least:] + bent[:least]
