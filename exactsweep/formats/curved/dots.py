"""Dots of SVG: zero-length paths, which round caps draw as discs as wide as the stroke."""

from __future__ import annotations

from exactsweep.formats.curved.affine import Affine
from exactsweep.formats.curved.path import Path, draw_circle
from exactsweep.formats.curved.svg_placed import PlacedElement
from exactsweep.formats.decimals import read_decimal

_UNPAINTED = ("none", "transparent")


def draw_dot(path: Path, shape: PlacedElement, matrix: Affine) -> Path | None:
    """Return the disc that a zero-length path draws; None for all other paths.

    Raises FormatError if the width of the stroke is not a number.
    """
    (x, y), *others = path.points
    is_round = shape.inherited("stroke-linecap", "butt") == "round"
    if not is_round or path.curves or any(p != (x, y) for p in others):
        return None
    if shape.inherited("stroke", "none") in _UNPAINTED:
        return None
    radius = read_decimal(shape.inherited("stroke-width", "1").strip().removesuffix("px")) / 2
    a, b, c, d = (number * radius for number in matrix[:4])
    return draw_circle(Affine(a, b, c, d, x, y, matrix.off)) if radius > 0 else None
