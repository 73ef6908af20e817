"""SVG dots: zero-length paths with round caps, drawn as discs as wide as the stroke."""

from fractions import Fraction

from exactsweep.formats.curved.affine import Affine
from exactsweep.formats.curved.path import Path, draw_circle
from exactsweep.formats.curved.svg_placed import PlacedElement
from exactsweep.formats.decimals import read_decimal

_UNPAINTED = ("none", "transparent")


def draw_dot(path: Path, shape: PlacedElement, matrix: Affine) -> Path | None:
    """Return the disc of a zero-length path, else None; raises FormatError for a bad width."""
    x, y = path.points[0]
    is_round = shape.inherited("stroke-linecap", "butt") == "round"
    if not is_round or len(path.points) < 2 or not is_point(path):
        return None
    if shape.inherited("stroke", "none") in _UNPAINTED:
        return None
    radius = read_decimal(shape.inherited("stroke-width", "1").strip().removesuffix("px")) / 2
    a, b, c, d = (number * radius for number in matrix[:4])
    off = matrix.off * max(radius, Fraction(1)) + path.off
    return draw_circle(Affine(a, b, c, d, x, y, off)) if radius > 0 else None


def is_point(path: Path) -> bool:
    return not path.curves and len({*path.points}) == 1
