"""SVG in (SVG 1.1): the polygons, closed paths and rectangles that are drawn, exactly."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache, cached_property, partial
from typing import TYPE_CHECKING, NoReturn

from exactsweep.formats.curved.affine import IDENTITY, Affine
from exactsweep.formats.curved.curves import flatten_arc
from exactsweep.formats.curved.svg_path import elliptic_arc, read_path
from exactsweep.formats.curved.svg_transform import composed, read_transform
from exactsweep.formats.curved.xml import line, parse_xml
from exactsweep.formats.decimals import read_decimal, read_decimals, required_tolerance
from exactsweep.formats.error import FormatError
from exactsweep.formats.nesting import drawn
from exactsweep.formats.outline import Outline
from exactsweep.geometry.number import quoted
from exactsweep.geometry.point import ORIGIN, Point

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

_SPACE = "{http://www.w3.org/2000/svg}"
_GROUPS = {"svg", "g", "a"}
_VIEW = {"x", "y", "viewBox"}


def parse_svg(text: str, tolerance: Fraction | None) -> list[Outline]:
    """Find the outlines of an SVG document.

    Args:
        text: the document.
        tolerance: how far lines may be from the curves that they replace; None to refuse curves.

    Returns:
        list of Outline, for each shape that is drawn itself, in order, with its id as the name.
        Coordinates are the user units of the document, y as it is there, downward; transformations
        are applied.

    Raises:
        FormatError: not XML, entities, nested too deeply, not SVG.

    Cost: linear in the length of the text.

    Example:
        >>> text = '<svg xmlns="http://www.w3.org/2000/svg"><path id="a" d="M0 0h2v.5z"/></svg>'
        >>> [(outline.name, str(outline.polygon())) for outline in parse_svg(text, None)]
        [('a', '(0, 0) (2, 0) (2, 1/2)')]
    """
    root = parse_xml(text)
    if _kind(root) != "svg":
        raise FormatError(f"line {line(root)}: the root is {quoted(root.tag)}, not svg")
    return list(_outlines(root, None, tolerance))


class _Placed:
    """An element among its ancestors; its transformation is read when it is wanted."""

    def __init__(self, element: Element, parent: _Placed | None) -> None:
        self.element, self.parent = element, parent
        self.place = f"line {line(element)}: {_kind(element)}"
        if "id" in element.attrib:
            self.place += f" {quoted(element.attrib['id'])}"

    @cached_property
    def matrix(self) -> Affine:
        outer = IDENTITY if self.parent is None else self.parent.matrix
        attributes = self.element.attrib
        try:
            if "transform" in attributes.get("style", ""):
                raise FormatError("a transformation in a style cannot be read")
            inner = self.parent is not None and _kind(self.element) == "svg"
            if inner and not _VIEW.isdisjoint(attributes):
                raise FormatError("a view of its own inside another cannot be read")
            return composed(outer, read_transform(attributes.get("transform", "")))
        except ValueError as error:
            raise FormatError(f"{self.place}: {error}") from None

    @property
    def is_even_odd(self) -> bool:
        """Whether the fill rule of a path is evenodd; it is inherited, and nonzero if not given."""
        attributes = self.element.attrib
        rule = attributes.get("fill-rule", "inherit")
        for declaration in attributes.get("style", "").split(";"):
            name, _, value = declaration.partition(":")
            if name.strip() == "fill-rule":
                rule = value.removesuffix("!important")
        rule = rule.strip()
        if rule == "inherit":
            return self.parent is not None and self.parent.is_even_odd
        if rule not in ("evenodd", "nonzero"):
            raise FormatError(f"the fill rule {quoted(rule)} is neither nonzero nor evenodd")
        return rule == "evenodd"

    def length(self, name: str, default: str | None = "0") -> Fraction:
        text = self.element.get(name, default)
        if text is None:
            raise FormatError(f"{name} is missing")
        try:
            return read_decimal(text.strip())
        except ValueError as error:
            raise FormatError(f"{name}: {error}") from None

    def size(self, name: str, default: str | None = None) -> Fraction:
        found = self.length(name, default)
        if found < 0:
            raise FormatError(f"{name} is negative")
        return found


def _outlines(
    element: Element, parent: _Placed | None, tolerance: Fraction | None
) -> Iterator[Outline]:
    placed = _Placed(element, parent)
    for child in element:
        kind = _kind(child)
        style = child.get("style", "").replace(" ", "")
        if child.get("display") == "none" or "display:none" in style:
            continue
        if kind in _GROUPS:
            yield from _outlines(child, placed, tolerance)
        elif kind == "path" or kind in _SHAPES:
            yield _outline(_Placed(child, placed), tolerance)


def _outline(shape: _Placed, tolerance: Fraction | None) -> Outline:
    rings = cache(partial(_rings, shape, tolerance))
    return Outline(
        shape.place,
        lambda: rings()[0].vertices(),
        shape.element.get("id"),
        holes=lambda: rings()[1:],
    )


def _rings(shape: _Placed, tolerance: Fraction | None) -> list[Outline]:
    """The exterior and the holes that a shape draws."""
    matrix = shape.matrix
    try:
        if _kind(shape.element) != "path":
            found = [_SHAPES[_kind(shape.element)](shape, matrix, tolerance)]
        else:
            found = read_path(shape.element.get("d", ""), matrix, tolerance)
        # What a single subpath is, is told when it is made a polygon.
        order = drawn(found, even_odd=shape.is_even_odd) if len(found) > 1 else [0]
    except ValueError as error:
        raise FormatError(f"{shape.place}: {error}") from None
    return [Outline(f"{shape.place}: subpath {k}", partial(list, found[k])) for k in order]


def _kind(element: Element) -> str:
    # Comments and processing instructions have a function for a tag.
    return element.tag.removeprefix(_SPACE) if isinstance(element.tag, str) else ""


def _polygon(shape: _Placed, matrix: Affine, tolerance: Fraction | None) -> list[Point]:
    numbers = read_decimals(shape.element.get("points", ""))
    if len(numbers) % 2:
        raise FormatError("points: an odd number of coordinates")
    points = [Point(*pair) for pair in zip(numbers[::2], numbers[1::2], strict=True)]
    if _kind(shape.element) == "polyline" and (not points or points[0] != points[-1]):
        raise FormatError("the line is not closed: its last point must repeat the first")
    return [matrix.point(*point) for point in points]


def _rectangle(shape: _Placed, matrix: Affine, tolerance: Fraction | None) -> list[Point]:
    x, y = shape.length("x"), shape.length("y")
    width, height = shape.size("width"), shape.size("height")
    if "rx" in shape.element.attrib or "ry" in shape.element.attrib:
        either = shape.element.get("rx", shape.element.get("ry"))
        rx = min(shape.size("rx", either), width / 2)
        ry = min(shape.size("ry", either), height / 2)
        if rx > 0 and ry > 0:
            return _rounded_rectangle((x, y, x + width, y + height), (rx, ry), matrix, tolerance)
    corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
    return [matrix.point(*corner) for corner in corners]


def _rounded_rectangle(
    box: tuple[Fraction, Fraction, Fraction, Fraction],
    radii: tuple[Fraction, Fraction],
    matrix: Affine,
    tolerance: Fraction | None,
) -> list[Point]:
    (x, y, u, v), (rx, ry) = box, radii
    corners = [
        (Point(u - rx, y), Point(u, y + ry)),
        (Point(u, v - ry), Point(u - rx, v)),
        (Point(x + rx, v), Point(x, v - ry)),
        (Point(x, y + ry), Point(x + rx, y)),
    ]
    allowed = required_tolerance(tolerance)
    found: list[Point] = []
    for first, last in corners:
        found += elliptic_arc(first, last, radii, False, True, matrix, allowed)
    return found


def _ellipse(shape: _Placed, matrix: Affine, tolerance: Fraction | None) -> list[Point]:
    names = ("r", "r") if _kind(shape.element) == "circle" else ("rx", "ry")
    rx, ry = (shape.size(name) for name in names)
    zero = Fraction(0)
    image = matrix @ Affine(rx, zero, zero, ry, shape.length("cx"), shape.length("cy"))
    start = Point(Fraction(1), zero)
    return flatten_arc(ORIGIN, start, start, True, image, required_tolerance(tolerance))


def _no_outline(shape: _Placed, matrix: Affine, tolerance: Fraction | None) -> NoReturn:
    raise FormatError("not an outline")


_SHAPES: dict[str, Callable[[_Placed, Affine, Fraction | None], list[Point]]] = {
    "polygon": _polygon,
    "polyline": _polygon,
    "rect": _rectangle,
    "circle": _ellipse,
    "ellipse": _ellipse,
    "line": _no_outline,
    "use": _no_outline,
    # What it draws depends on the language of whoever looks.
    "switch": _no_outline,
}
