"""What a notebook shows of a polygon and of a sweep: a picture, and a table beside it."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from exactsweep.draw import style
from exactsweep.draw.svg import Shape, svg
from exactsweep.draw.sweeps import path, placed_generatrix, shift, telling_positions
from exactsweep.polygon import Point, Polygon, abridged
from exactsweep.words import CLASSES, pair

if TYPE_CHECKING:
    from exactsweep.sweep import Sweep


def polygon_svg(polygon: Polygon) -> str:
    """Draw a polygon as an SVG image.  Cost: O(n)."""
    return svg([Shape([polygon.vertices], style.DIRECTRIX)], _title(polygon))


def polygon_html(polygon: Polygon) -> str:
    """Show a polygon as HTML: its picture, size and bounding box."""
    low, high = polygon.bounding_box
    rows = [
        ("vertices", str(len(polygon))),
        ("area", abridged(polygon.area)),
        ("convex", "yes" if polygon.is_convex else "no"),
        ("from", pair(low)),
        ("to", pair(high)),
    ]
    return _beside(polygon_svg(polygon), rows)


def sweep_svg(s: Sweep) -> str:
    """Draw a sweep as an SVG image: polygons, loops, trajectory, undercuts and exact fits.

    Cost: that of the loops and the undercuts, and linear in their sizes.
    """
    outer, inner = s.outer.vertices, s.inner.vertices
    dx, dy = shift(s)
    placed = [placed_generatrix(s, place).vertices for place in telling_positions(s)]
    shapes = [
        Shape([outer, inner], style.SWEPT),
        Shape([s.directrix.vertices], style.DIRECTRIX),
        Shape([undercut.polygon.vertices for undercut in s.undercuts], style.UNDERCUT),
        Shape([outer], style.OUTER),
        Shape([inner], style.INNER),
        *(Shape([loop], style.GENERATRIX) for loop in placed),
        Shape([path(s).vertices], style.TRAJECTORY),
        Shape(
            [[Point(p.x + dx, p.y + dy) for p in fit] for fit in s.exact_fits],
            style.EXACT_FIT,
            closed=False,
        ),
    ]
    title = f"{s.kind} sweep of {len(s.generatrix)} around {len(s.directrix)} vertices"
    return svg([shape for shape in shapes if shape.loops], title)


def sweep_html(s: Sweep) -> str:
    """Show a sweep as HTML: its picture, class, and the sizes of its loops."""
    rows = [
        ("class", CLASSES[s.kind]),
        ("monotone to", pair(s.direction)),
        ("reference", pair(s.reference)),
    ]
    loops = {
        "generatrix": s.generatrix,
        "directrix": s.directrix,
        "trajectory": s.trajectory,
        "inner loop": s.inner,
        "outer loop": s.outer,
    }
    rows += [(name, _title(loop)) for name, loop in loops.items()]
    rows += [
        ("swept area", abridged(s.area)),
        ("undercuts", str(len(s.undercuts))),
        ("exact fits", str(len(s.exact_fits))),
    ]
    return _beside(sweep_svg(s), rows)


def _title(polygon: Polygon) -> str:
    return f"{len(polygon)} vertices, area {abridged(polygon.area)}"


def _beside(picture: str, rows: list[tuple[str, str]]) -> str:
    table = "".join(
        f'<tr><th style="text-align:left">{escape(name)}</th>'
        f'<td style="text-align:left">{escape(text)}</td></tr>'
        for name, text in rows
    )
    return (
        '<div style="display:flex;flex-wrap:wrap;gap:1em;align-items:flex-start">'
        f"{picture}<table>{table}</table></div>"
    )
