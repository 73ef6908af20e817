"""What a notebook shows of a polygon and of a sweep: a picture, and a table beside it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.canvas.svg import Shape, put_beside, svg
from exactsweep.draw.sweeps import path, placed_generatrix, shift, telling_positions
from exactsweep.geometry.number import abridged
from exactsweep.geometry.point import Point
from exactsweep.words import CLASSES, pair, size

if TYPE_CHECKING:
    from exactsweep.evidence.swept import Swept


def sweep_svg(s: Swept) -> str:
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


def sweep_html(s: Swept) -> str:
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
    rows += [(name, size(len(loop), loop.area)) for name, loop in loops.items()]
    rows += [
        ("swept area", abridged(s.area)),
        ("undercuts", str(len(s.undercuts))),
        ("exact fits", str(len(s.exact_fits))),
    ]
    return put_beside(sweep_svg(s), rows)
