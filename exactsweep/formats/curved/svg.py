"""Reader of SVG 1.1: shapes, and open lines joined to outlines."""

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from itertools import islice
from typing import NoReturn
from xml.etree.ElementTree import Element

from exactsweep.formats.candidate import Candidate, limit_faults, match_region
from exactsweep.formats.curved.affine import Affine
from exactsweep.formats.curved.join import OpenLine, draw_outline, join_layers
from exactsweep.formats.curved.path import Path, draw_circle, draw_lines, flatten_together
from exactsweep.formats.curved.svg_path import Subpaths, read_path
from exactsweep.formats.curved.svg_placed import PlacedElement, Style, find_link, name_kind
from exactsweep.formats.curved.xml import line
from exactsweep.formats.decimals import count_decimals, read_decimal, read_points
from exactsweep.formats.depth import nest_lines
from exactsweep.formats.error import FormatError, OrnamentError
from exactsweep.formats.filling import Filled, fill
from exactsweep.formats.reading import Reading
from exactsweep.geometry.canonical import PolygonError
from exactsweep.numbers.error import quote
from exactsweep.numbers.number import Point
from exactsweep.words import count

_GROUPS = {"svg", "g", "a"}
_CONDITIONS = {"requiredExtensions", "requiredFeatures", "systemLanguage"}
_INVISIBLE = ("hidden", "collapse")
_TOO_FEW = "fewer than three vertices"
_UNPAINTED = ("none", "transparent")
MAX_DEPTH = 32  # of nested uses


def read_svg(root: Element, reading: Reading, style: Style | None = None) -> list[Candidate]:
    if name_kind(root) != "svg":
        raise FormatError(f"line {line(root)}: the root element is {quote(root.tag)}, not svg")
    document = Document(root, reading)
    style = style or Style(root)
    if style.ignored:
        number, first = count(len(style.ignored), "style sheet selector"), quote(style.ignored[0])
        only = "only names, classes and ids are read"
        reading.notes[f"{number} ignored, first {first}: {only}"] = None
    placed = PlacedElement(root, None, reading, style=style)
    # A missing unit is an error of the whole file.
    _ = placed.unit if reading.unit is None else placed.matrix
    try:
        return join_layers(limit_faults(_draw(document.shapes(placed, 0), reading)), reading)
    except RecursionError:
        raise FormatError("nested too deeply") from None


def _draw(shapes: Iterator[PlacedElement], reading: Reading) -> Iterator[Candidate | OpenLine]:
    for shape in shapes:
        parts = _read(shape, reading)
        # Too many vertices are an error of the whole file.
        reading.charge_vertices(0)
        yield from parts


class Document:
    def __init__(self, root: Element, reading: Reading) -> None:
        self.reading = reading
        elements = list(root.iter())
        self.by_id = {e.attrib["id"]: e for e in reversed(elements) if "id" in e.attrib}
        linked = {find_link(e).removeprefix("#") for e in elements}
        # Unused definitions.
        self.unused = {
            child
            for defs in elements
            if name_kind(defs) == "defs"
            for child in defs
            if name_kind(child) in _GROUPS | SHAPES.keys()
            if not any(e.get("id") in linked for e in child.iter())
        }

    def shapes(self, placed: PlacedElement, depth: int) -> Iterator[PlacedElement]:
        for child in placed.element:
            yield from self._drawn(PlacedElement(child, placed, self.reading), depth)

    def _drawn(self, placed: PlacedElement, depth: int) -> Iterator[PlacedElement]:
        element, name = placed.element, name_kind(placed.element)
        if name == "defs":
            for child in element:
                if child in self.unused and not self.reading.skip_hidden(
                    f"{name_kind(child)} in defs"
                ):
                    yield from self._drawn(PlacedElement(child, placed, self.reading), depth)
            return
        if self.reading.skip_hidden(explain_hidden(placed)):
            return
        if depth:
            size = sum(map(len, element.attrib.values()))
            self.reading.charge_copies(1, size, "uses expand to", "elements")
        if name in _GROUPS:
            yield from self.shapes(placed, depth)
        elif name == "switch":
            plain = (e for e in element if name_kind(e) and _CONDITIONS.isdisjoint(e.attrib))
            for first in islice(plain, 1):
                yield from self._drawn(PlacedElement(first, placed, self.reading), depth)
        elif name == "use":
            yield from self._follow_use(placed, depth + 1)
        elif name in SHAPES:
            if (
                placed.inherited("fill", "black") in _UNPAINTED
                and placed.inherited("stroke", "none") in _UNPAINTED
            ):
                self.reading.notes[f"a {name} with neither fill nor stroke is read"] = None
            yield placed

    def _follow_use(self, placed: PlacedElement, depth: int) -> Iterator[PlacedElement]:
        link = find_link(placed.element)
        target = self.by_id.get(link.removeprefix("#")) if link.startswith("#") else None
        if target is None or depth > MAX_DEPTH:
            # `_reject_missing_target` reports the missing target.
            yield placed
            return
        drawn = PlacedElement(target, placed, self.reading, used=placed)
        if name_kind(target) == "symbol":
            yield from self.shapes(drawn, depth)
        else:
            yield from self._drawn(drawn, depth)


def explain_hidden(placed: PlacedElement) -> str:
    """Return why an element is hidden; "" if it is visible."""
    name = name_kind(placed.element)
    if name in SHAPES and placed.inherited("visibility", "visible") in _INVISIBLE:
        return f"{name} that is not visible"
    is_hidden = name in DRAWN and placed.style("display") == "none"
    return f"{name} with display: none" if is_hidden else ""


def _read(shape: PlacedElement, reading: Reading) -> list[Candidate | OpenLine]:
    whole = Candidate(shape.place, list, _name(shape), shape.layer, groups=shape.groups)
    try:
        matrix = shape.matrix
    except FormatError as error:
        return [whole.rejected(str(error))]
    whole = whole._replace(words=tuple(shape.element.get("class", "").split()))
    try:
        found = SHAPES[name_kind(shape.element)](shape, matrix, reading)
        if reading.dots:
            found = [_draw_dot(path, shape, matrix) or path for path in found]
            if all(map(_is_point, found)):
                raise OrnamentError("a stroke of length zero; only round caps draw a disc")
        closed = [path for path in found if len(path.points) > 1 and path.is_closed]
        opened = [path for path in found if not path.is_closed]
        # Filling closes open paths, but the ends of a single one may meet other lines.
        if len(found) > 1 and is_filled(shape):
            closed += [path.closed() for path in opened if len(path.points) > 2 or path.curves]
            opened = [path for path in opened if len(path.points) == 2 and not path.curves]
        drawn: list[Candidate | OpenLine] = []
        outline = whole._replace(rule=shape.rule)
        if len(closed) > 1 and is_filled(shape):
            drawn += _draw_regions(closed, outline, reading)
        else:
            # Unfilled paths are outlines, and those inside others are holes.
            lines = [draw_outline(path, outline, reading) for path in closed]
            drawn += lines if reading.separate or len(lines) < 2 else nest_lines(lines)
        if not drawn and not opened:
            raise OrnamentError("its fill rule fills nothing" if closed else _TOO_FEW)
    except ValueError as error:
        is_ornament = isinstance(error, OrnamentError)
        return [whole.rejected(f"{shape.place}: {error}", ornament=is_ornament)]
    line = outline if is_filled(shape) else whole
    return drawn + [OpenLine.from_path(line, path, is_exact=not matrix.error) for path in opened]


def _draw_dot(path: Path, shape: PlacedElement, matrix: Affine) -> Path | None:
    """Return the disc of a zero-length path with round caps, as wide as the stroke, else None."""
    x, y = path.points[0]
    is_round = shape.inherited("stroke-linecap", "butt") == "round"
    if not is_round or len(path.points) < 2 or not _is_point(path):
        return None
    if shape.inherited("stroke", "none") in _UNPAINTED:
        return None
    radius = read_decimal(shape.inherited("stroke-width", "1").strip().removesuffix("px")) / 2
    a, b, c, d = (number * radius for number in matrix[:4])
    error = matrix.error * max(radius, Fraction(1)) + path.error
    return draw_circle(Affine(a, b, c, d, x, y, error)) if radius > 0 else None


def _is_point(path: Path) -> bool:
    return not path.curves and len({*path.points}) == 1


def is_filled(shape: PlacedElement) -> bool:
    return shape.inherited("fill", "black") not in _UNPAINTED


def _draw_regions(
    closed: Sequence[Path], shape: Candidate, reading: Reading
) -> Sequence[Candidate]:
    rule = shape.rule or "nonzero"
    whole = shape._replace(error=max(path.find_error(reading) for path in closed))

    def fill_simply(rings: Sequence[Sequence[Point]]) -> Filled:
        filled = fill(rings, rule)
        if filled.touching:
            raise PolygonError(f"subpaths intersect: {[*map(len, filled.regions)]} rings")
        return filled

    rings, filled = flatten_together(closed, reading, fill_simply)
    pieces = whole.make_regions(filled or fill(rings, rule, measured=bool(whole.error)))
    if filled is None:
        number = count(len(pieces), "polygon")
        note = f"{shape.place}: the subpaths intersect; {number} by the {rule} fill rule"
        reading.notes[note] = None

    def find_finer(k: int, tolerance: Fraction) -> Candidate | None:
        return match_region(
            pieces, k, _draw_regions(closed, shape, reading.with_tolerance(tolerance))
        )

    return [piece._replace(finer=partial(find_finer, k)) for k, piece in enumerate(pieces)]


def _name(shape: PlacedElement) -> str | None:
    """Return the id of the outermost `use` that draws a shape, else its own id."""
    name = shape.element.get("id")
    placed: PlacedElement | None = shape
    while placed is not None:
        if placed.used is not None:
            name = placed.used.element.get("id", name)
        placed = placed.parent
    return name


def _polygon(shape: PlacedElement, matrix: Affine, reading: Reading) -> list[Path]:
    text = shape.element.get("points", "")
    reading.charge_vertices(count_decimals(text) // 2)
    points = read_points(text)
    if not points:
        raise FormatError("no points")
    if name_kind(shape.element) == "polygon":
        points.append(points[0])
    return [draw_lines(points, matrix)]


def _line(shape: PlacedElement, matrix: Affine, reading: Reading) -> list[Path]:
    ends = [Point(shape.length(f"x{k}"), shape.length(f"y{k}")) for k in (1, 2)]
    return [draw_lines(ends, matrix)]


def _rectangle(shape: PlacedElement, matrix: Affine, reading: Reading) -> list[Path]:
    x, y = shape.length("x"), shape.length("y")
    width, height = shape.size("width"), shape.size("height")
    _require_size(width, height)
    u, v = x + width, y + height
    rx, ry = _read_radii(shape)
    if rx and ry:
        radii = min(rx, width / 2), min(ry, height / 2)
        return [_round_rectangle((x, y, u, v), radii, matrix, reading)]
    corners = [Point(*corner) for corner in ((x, y), (u, y), (u, v), (x, v), (x, y))]
    return [draw_lines(corners, matrix)]


def _require_size(width: Fraction, height: Fraction) -> None:
    if not width or not height:
        raise OrnamentError("no width or height, so nothing is drawn")


def _read_radii(shape: PlacedElement) -> tuple[Fraction, Fraction]:
    """Read both radii; a missing or "auto" radius equals the other."""
    auto = {None, "auto"}
    found = [
        None if shape.element.get(name, shape.styled.get(name)) in auto else shape.size(name)
        for name in ("rx", "ry")
    ]
    zero = Fraction(0)
    rx, ry = found
    return rx if rx is not None else ry or zero, ry if ry is not None else rx or zero


def _round_rectangle(
    box: Sequence[Fraction], radii: Sequence[Fraction], matrix: Affine, reading: Reading
) -> Path:
    """Draw a rounded rectangle as path data (SVG 1.1, 9.2)."""
    (x, y, u, v), (rx, ry) = box, radii
    drawn = Subpaths(matrix, reading)
    drawn.draw("M", [[u - rx, y]])
    ends = [(u, y + ry), (u, v - ry), (u - rx, v), (x + rx, v)]
    ends += [(x, v - ry), (x, y + ry), (x + rx, y), (u - rx, y)]
    for end, start in zip(ends[::2], ends[1::2], strict=True):
        drawn.draw("A", [[*radii, *map(Fraction, (0, 0, 1)), *end]])
        if start != end:
            drawn.draw("L", [start])
    return drawn.found[0]


def _ellipse(shape: PlacedElement, matrix: Affine, reading: Reading) -> list[Path]:
    if name_kind(shape.element) == "circle":
        rx = ry = shape.size("r")
    else:
        rx, ry = _read_radii(shape)
    _require_size(rx, ry)
    zero = Fraction(0)
    image = matrix @ Affine(rx, zero, zero, ry, shape.length("cx"), shape.length("cy"))
    return [draw_circle(image)]


def _reject_missing_target(shape: PlacedElement, matrix: Affine, reading: Reading) -> NoReturn:
    raise FormatError("refers to itself or to a missing element")


SHAPES: dict[str, Callable[[PlacedElement, Affine, Reading], Sequence[Path]]] = {
    "polygon": _polygon,
    "polyline": _polygon,
    "rect": _rectangle,
    "circle": _ellipse,
    "ellipse": _ellipse,
    "line": _line,
    "path": lambda shape, *how: read_path(shape.element.get("d", ""), *how),
    # A missing target.
    "use": _reject_missing_target,
}
DRAWN = _GROUPS | SHAPES.keys() | {"switch"}
