"""Small certificates of every kind."""

from __future__ import annotations

import json
from functools import cache
from typing import Any

from exactsweep import (
    Polyline,
    Region,
    inner_fit_polygon,
    minkowski_sum,
    no_fit_polygon,
    sweep,
)

Certificate = dict[str, Any]
Ring = list[list[str]]

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
HOUSE = [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]
NOTCHED = [(0, 0), (8, 0), (8, 5), (7, 5), (3, 1), (2, 5), (0, 5)]
SLOT = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 2), (0, 2)]
CAVE = [(0, 0), (4, 0), (4, 2), (3, 2), (3, 1), (1, 1), (1, 4), (3, 4), (3, 3), (4, 3), (4, 5)]
CAVE += [(0, 5)]
ROOM = Region(
    [(0, 0), (6, 0), (6, 6), (0, 6)],
    [[(1, 1), (2, 1), (2, 2), (1, 2)], [(3, 2), (5, 4), (3, 4)], [(2, 2), (3, 4), (2, 4)]],
)
# The square enters the cavity and leaves a hole in the swept area.
BAY = [(0, 0), (1, 0), (1, 4), (5, 4), (5, 1), (3, 1), (3, 0), (6, 0), (6, 5), (0, 5)]
HOOK = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (3, 3), (3, 4), (0, 4)]
PLATE = Region([(0, 0), (9, 0), (9, 9), (0, 9)], [[(4, 4), (5, 4), (5, 5), (4, 5)]])


@cache
def certificates() -> dict[str, Certificate]:
    """Return a certificate of each kind, with exact fits, slits, holes and islands."""
    made: dict[str, Any] = {
        "CC": sweep(HOUSE, SQUARE),
        "CM": sweep(SQUARE, NOTCHED),
        "MM": sweep(NOTCHED, SLOT),
        "fit": sweep(SQUARE, SLOT),
        "SS": sweep(HOOK, CAVE),
        "unswept": sweep(SQUARE, BAY),
        "cave": no_fit_polygon(CAVE, SQUARE),
        "room": no_fit_polygon(ROOM, SQUARE),
        "inside": inner_fit_polygon(ROOM, SQUARE),
        "island": inner_fit_polygon(PLATE, SQUARE),
        "inside exactly": inner_fit_polygon(SLOT, SQUARE),
        "nowhere": inner_fit_polygon(SQUARE, HOUSE),
        "path": minkowski_sum(SLOT, Polyline([(0, 0), (9, 0), (9, 9), (0, 9)], closed=True)),
        "slit": minkowski_sum(SLOT, Polyline([(0, 0), (1, 0)])),
    }
    return {name: json.loads(json.dumps(a.certificate())) for name, a in made.items()}


def rect(left: Any, low: Any, right: Any, high: Any) -> Ring:
    corners = (left, low), (right, low), (right, high), (left, high)
    return [[str(x), str(y)] for x, y in corners]


L = [["0", "0"], ["2", "0"], ["2", "1"], ["1", "1"], ["1", "2"], ["0", "2"]]
PIECES_OF_L = [rect(0, 0, 2, 1), rect(0, 1, 1, 2)]


def layout(
    parts: list[Any], placements: list[Any], pieces: list[Any], size: int = 20, **more: Any
) -> Certificate:
    """Return the certificate of a layout in a square from 0 to its size, without normals."""
    far = size + 1
    outside = [rect(-1, -1, far, 0), rect(-1, size, far, far)]
    outside += [rect(-1, 0, 0, size), rect(size, 0, far, size)]
    apart = more.pop("apart", [])
    defects = [[e["exterior"]] for e in more.get("defects", [])]
    frame = ["-1", "-1", str(far), str(far)]
    proof = {"frame": frame, "pieces": [*pieces, outside, *defects], "apart": apart}
    given = {"container": {"exterior": rect(0, 0, size, size)}, "parts": parts}
    return {
        "format": "exactsweep certificate",
        "version": 3,
        "claim": "layout",
        "layout": {**given, "placements": placements, **more},
        "valid": True,
        "turns": [["1", "0"]] * len(placements),
        "proof": proof,
    }


def two_ls() -> Certificate:
    """Return two Ls that fill a 3 by 2 box; a third shape touches with a slanted edge."""
    parts: list[Any] = [{"id": "L", "exterior": L, "demand": 2, "turns": ["0", "180"]}]
    placed = [
        {"part": "L", "turn": "0", "move": ["0", "0"]},
        {"part": "L", "turn": "180", "move": ["3", "2"]},
    ]
    found = layout(parts, placed, [PIECES_OF_L], 3)
    return {**found, "turns": [["1", "0"], ["-1", "0"]]}


def with_faults(certificate: Certificate, *faults: Any) -> Certificate:
    """Return the certificate with faults instead of its proof."""
    kept = {key: value for key, value in certificate.items() if key != "proof"}
    return {**kept, "valid": False, "faults": list(faults)}
