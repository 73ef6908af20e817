"""Certificates from the definition, by brute force."""

from collections.abc import Iterator
from itertools import pairwise
from typing import Any

from tampering import Certificate

from exactsweep import Point, Polygon
from exactsweep.check import (
    reference_exact_fits,
    reference_loops,
)
from exactsweep.numbers.digits import format_fraction

Vertices = tuple[Point, ...]

UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]
SLOT = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
WIDE_SLOT = [(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)]
VALLEY = [(0, 0), (4, 0), (4, 3), (2, 1), (0, 3)]


def certificate_of(
    g: Polygon, d: Polygon, loops: tuple[Vertices, Vertices, Vertices] | None = None
) -> Certificate:
    """The certificate of a pair, or one that gives other loops with all evidence that there is."""
    trajectory, inner, outer = loops or reference_loops(g, d)
    certificate: Certificate = {
        "format": "exactsweep certificate",
        "version": 2,
        "generatrix": texts(g.vertices),
        "directrix": texts(d.vertices),
        "kind": "MM" if not g.is_convex else "CC" if d.is_convex else "CM",
        "direction": [1, 0],
        "reference": ["0", "0"],
        "trajectory": texts(trajectory),
        "inner": texts(inner),
        "outer": texts(outer),
        "area": format_fraction(Polygon(outer).area - Polygon(inner).area),
        "exact_fits": [texts(fit) for fit in reference_exact_fits(g, d)],
        "contacts": [_contacts(g, d, edge) for edge in edges(trajectory)],
    }
    features = [[kind, k] for k in range(len(g)) for kind in ("vertex", "edge")]
    positions = [[kind, k] for k in range(len(trajectory)) for kind in ("vertex", "edge")]
    for name, loop in (("inner", inner), ("outer", outer)):
        certificate[f"{name}_drawn"] = [
            [
                [position, feature]
                for position in positions
                for feature in features
                if _share(edge, _sums(trajectory, position, g.vertices, feature, 1))
            ]
            for edge in edges(loop)
        ]
    return certificate


def replace_trajectory(
    certificate: Certificate, g: Polygon, d: Polygon, trajectory: Vertices
) -> None:
    """Put in another one with all contacts that there are, and leave out what depends on it."""
    certificate["trajectory"] = texts(trajectory)
    certificate["contacts"] = [_contacts(g, d, edge) for edge in edges(trajectory)]
    for loop in ("inner", "outer"):
        certificate[f"{loop}_drawn"] = [[] for _ in certificate[loop]]


def _contacts(g: Polygon, d: Polygon, edge: Vertices) -> list[list[Any]]:
    found: list[list[Any]] = []
    for event in ("EE", "EV", "VE"):
        of_g, of_d = ("edge" if letter == "E" else "vertex" for letter in event)
        for i in range(len(g)):
            for j in range(len(d)):
                sums = _sums(d.vertices, [of_d, j], g.vertices, [of_g, i], -1)
                # The EE pairs whose segments would include that of an EV or VE pair.
                if event == "EE":
                    wider = []
                elif event == "EV":
                    wider = [["EE", i, b % len(d)] for b in (j - 1, j)]
                else:
                    wider = [["EE", a % len(g), j] for a in (i - 1, i)]
                if _share(edge, sums) and not any(contact in found for contact in wider):
                    found.append([event, i, j])
    return sorted(found)


def _sums(one: Vertices, feature: list[Any], other: Vertices, of: list[Any], sign: int) -> Vertices:
    return tuple(
        Point(p.x + sign * q.x, p.y + sign * q.y)
        for p in _ends(one, *feature)
        for q in _ends(other, *of)
    )


def _ends(loop: Vertices, kind: str, k: int) -> Vertices:
    return (loop[k], loop[(k + 1) % len(loop)]) if kind == "edge" else (loop[k],)


def _share(edge: Vertices, sums: Vertices) -> bool:
    """Decide whether all points are on the line of an edge, with a piece of it between them."""
    (px, py), (qx, qy) = edge
    if any((qx - px) * (y - py) != (qy - py) * (x - px) for x, y in sums):
        return False
    return max(min(edge), min(sums)) < min(max(edge), max(sums))


def edges(loop: Vertices) -> Iterator[Vertices]:
    return pairwise((*loop, loop[0]))


def texts(points: Vertices) -> list[list[str]]:
    return [[format_fraction(c) for c in point] for point in points]


def find_meetings(one: Vertices, other: Vertices) -> Iterator[Point]:
    """The point in which two edges meet that are not parallel."""
    (ax, ay), (bx, by) = one
    (cx, cy), (dx, dy) = other
    det = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
    if det:
        share = ((cx - ax) * (dy - cy) - (cy - ay) * (dx - cx)) / det
        meeting = Point(ax + share * (bx - ax), ay + share * (by - ay))
        if all(min(edge) <= meeting <= max(edge) for edge in (one, other)):
            yield meeting
