"""Nests of twenty plates with holes, drawn as DXF by ezdxf and as SVG."""

from collections.abc import Sequence
from decimal import Decimal
from io import StringIO
from typing import NamedTuple

Ring = Sequence[tuple[Decimal, Decimal]]


class Plate(NamedTuple):
    """A plate: its name, its outline and its holes."""

    name: str
    outline: Ring
    holes: Sequence[Ring]


def _box(x: Decimal, y: Decimal, width: Decimal, height: Decimal) -> Ring:
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def draw_plates(moved: dict[int, tuple[str, str]] | None = None) -> list[Plate]:
    """Make twenty 30 by 20 plates on a grid, at distance 2 from each other and the edge."""
    plates = []
    for k in range(20):
        dx, dy = map(Decimal, (moved or {}).get(k, ("0", "0")))
        x, y = Decimal(2 + 32 * (k % 5)) + dx, Decimal(2 + 22 * (k // 5)) + dy
        holes: list[Ring] = [_box(x + 3, y + 3, Decimal("4.5"), Decimal(6))]
        if k % 2:
            holes.append([(x + 12, y + 4), (x + 22, y + 4), (x + 12, y + Decimal("15.25"))])
        plates.append(Plate(f"plate{k:02}", _box(x, y, Decimal(30), Decimal(20)), holes))
    return plates


SHEET = _box(Decimal(0), Decimal(0), Decimal(162), Decimal(90))
ENGRAVED: Ring = [(Decimal(4), Decimal(12)), (Decimal(8), Decimal(18)), (Decimal(12), Decimal(12))]


def write_dxf(plates: Sequence[Plate], *, engraved: bool = False, sheet: bool = True) -> str:
    """Write a nest as DXF, with each plate and its holes on the layer of its name."""
    import ezdxf

    document = ezdxf.new("R2010", units=4)  # type: ignore[attr-defined]
    space = document.modelspace()
    if sheet:
        _draw(space, SHEET, "Sheet")
    for plate in plates:
        for ring in (plate.outline, *plate.holes):
            _draw(space, ring, plate.name)
    if engraved:
        points = [(float(x), float(y)) for x, y in ENGRAVED]
        space.add_lwpolyline(points, dxfattribs={"layer": "engrave"})
        space.add_text("A7", dxfattribs={"layer": "engrave"})
    out = StringIO()
    document.write(out)
    return out.getvalue()


def _draw(space: object, ring: Ring, layer: str) -> None:
    points = [(float(x), float(y)) for x, y in ring]
    space.add_lwpolyline(points, close=True, dxfattribs={"layer": layer})  # type: ignore[attr-defined]


def write_svg(plates: Sequence[Plate], *, engraved: bool = False, sheet: bool = True) -> str:
    """Write a nest as SVG in millimeters: plates with an id, holes as separate shapes."""
    drawn = [_write_polygon(SHEET, 'id="Sheet"')] if sheet else []
    for plate in plates:
        drawn.append(_write_polygon(plate.outline, f'id="{plate.name}"'))
        drawn += [_write_polygon(hole, "") for hole in plate.holes]
    groups = _group("cut", drawn)
    if engraved:
        points = " ".join(f"{x},{y}" for x, y in ENGRAVED)
        groups += _group(
            "engrave",
            [f'<polyline points="{points}" fill="none" stroke="black"/>', "<text>A7</text>"],
        )
    inkscape = "http://www.inkscape.org/namespaces/inkscape"
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="{inkscape}" width="162mm" '
        f'height="90mm" viewBox="0 0 162 90">{groups}</svg>'
    )


def _group(layer: str, shapes: Sequence[str]) -> str:
    lines = "\n".join(shapes)
    return f'\n<g inkscape:groupmode="layer" inkscape:label="{layer}">\n{lines}\n</g>'


def _write_polygon(ring: Ring, attributes: str) -> str:
    points = " ".join(f"{x},{y}" for x, y in ring)
    return f'<polygon {attributes} points="{points}" fill="none" stroke="red"/>'
