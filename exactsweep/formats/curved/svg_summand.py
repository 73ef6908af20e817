"""SVG paths as summands of Minkowski sums."""

from itertools import islice

from exactsweep.formats.curved.svg import SHAPES, Document, is_filled
from exactsweep.formats.curved.svg_placed import PlacedElement
from exactsweep.formats.curved.svg_style import Style, name_kind
from exactsweep.formats.curved.xml import parse_xml
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import Reading
from exactsweep.geometry.polyline import Polyline
from exactsweep.numbers.error import prefix_errors


def read_svg_path(text: str, reading: Reading, *, filled: bool = False) -> Polyline | None:
    """Read an SVG document with a single path; return None for any other.

    The path must be open and unfilled, unless `filled` is set.

    >>> text = '<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0h2v1" fill="none"/></svg>'
    >>> print(read_svg_path(text, Reading()))
    (0,0) (2,0) (2,1)
    """
    root = parse_xml(text)
    if name_kind(root) != "svg":
        return None
    placed = PlacedElement(root, None, reading, style=Style(root))
    shapes = [*islice(Document(root, reading).shapes(placed, 0), 2)]
    if len(shapes) != 1 or (is_filled(shapes[0]) and not filled):
        return None
    with prefix_errors(shapes[0].place, FormatError):
        found = SHAPES[name_kind(shapes[0].element)](shapes[0], shapes[0].matrix, reading)
        if len(found) != 1 or (found[0].is_closed and not filled):
            return None
        if not found[0].is_exact:
            raise FormatError("a path with curves; draw it with straight segments")
    return Polyline(found[0].points, closed=found[0].is_closed)
