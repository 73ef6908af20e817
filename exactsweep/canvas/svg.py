"""Small SVG pictures without matplotlib, for notebooks.

Coordinates are scaled exactly, then rounded to a hundredth of a pixel.
"""

from collections.abc import Iterable, Sequence
from html import escape
from itertools import chain
from typing import NamedTuple

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.canvas.window import Window
from exactsweep.numbers.number import Vertex

_WIDTH, _HEIGHT, _MARGIN = 420, 320, 12
_HATCH = "exactsweep-hatch"


class Shape(NamedTuple):
    loops: Sequence[Iterable[Vertex]]
    look: Look
    closed: bool = True


def write_svg(shapes: Iterable[Shape], title: str) -> str:
    """Write shapes as an SVG image, in drawing order; raises DrawError if there are no points."""
    drawn = [Shape([list(loop) for loop in s.loops], s.look, s.closed) for s in shapes if s.loops]
    points = chain.from_iterable(chain.from_iterable(shape.loops for shape in drawn))
    window = Window.around(points, _WIDTH, _HEIGHT, _MARGIN)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH}" height="{_HEIGHT}" '
        f'viewBox="0 0 {_WIDTH} {_HEIGHT}" role="img">'
        f"<title>{escape(title)}</title>"
        '<rect width="100%" height="100%" fill="#ffffff"/>'
        f"{''.join(_path(shape, window) for shape in drawn)}</svg>"
    )


def _path(shape: Shape, window: Window) -> str:
    data = write_path((map(window.place, loop) for loop in shape.loops), closed=shape.closed)
    look = shape.look
    fill, hatching = look.fill or "none", ""
    if look.hatch:
        # All pictures of a page share the id and the pattern.
        fill = f"url(#{_HATCH})"
        hatching = (
            f'<pattern id="{_HATCH}" width="5" height="5" patternUnits="userSpaceOnUse" '
            f'patternTransform="rotate(45)"><path d="M0 0V5" stroke="{look.color}" '
            'stroke-width="1.4"/></pattern>'
        )
    ends = "" if shape.closed else ' stroke-linecap="round"'
    dash = ""
    if not isinstance(look.dash, str):
        lengths = " ".join(f"{length * look.width:.1f}" for length in look.dash[1])
        dash = f' stroke-dasharray="{lengths}"'
    return (
        f'{hatching}<path d="{data}" fill="{fill}" fill-rule="evenodd" stroke="{look.color}" '
        f'stroke-width="{look.width}" stroke-linejoin="round"{ends}{dash}/>'
    )


def draw_rings(rings: Iterable[Iterable[Vertex]], title: str) -> str:
    return write_svg([Shape(list(rings), style.DIRECTRIX)], title)


def add_table(picture: str, rows: Iterable[tuple[str, str]]) -> str:
    """Write HTML with a table on the right of a picture."""
    table = "".join(
        f'<tr><th style="text-align:left">{escape(name)}</th>'
        f'<td style="text-align:left">{escape(text)}</td></tr>'
        for name, text in rows
    )
    return (
        '<div style="display:flex;flex-wrap:wrap;gap:1em;align-items:flex-start">'
        f"{picture}<table>{table}</table></div>"
    )


def write_path(
    lines: Iterable[Iterable[tuple[float, float]]], *, closed: bool, digits: int = 2
) -> str:
    """Write the path data of polylines, or of loops if `closed`, in pixels.

    >>> write_path([[(0, 0), (1, 0.125)]], closed=True)
    'M0.00 0.00L1.00 0.12Z'
    """
    corners = ("L".join(f"{x:.{digits}f} {y:.{digits}f}" for x, y in line) for line in lines)
    return "".join(f"M{line}{'Z' * closed}" for line in corners if line)
