"""Small SVG pictures without matplotlib, for the display of notebooks.

They are for looking at: coordinates are scaled exactly and then rounded to a hundredth of a pixel.
"""

from __future__ import annotations

from collections.abc import Iterable
from html import escape
from itertools import chain
from typing import NamedTuple

from exactsweep.canvas import style
from exactsweep.canvas.scale import Scale
from exactsweep.canvas.style import Look
from exactsweep.geometry.point import Vertex

_WIDTH, _HEIGHT, _MARGIN = 420, 320, 12
_HATCH = "exactsweep-hatch"


class Shape(NamedTuple):
    """A loop, or several loops or chains, and how they look."""

    loops: list[Iterable[Vertex]]
    look: Look
    closed: bool = True


def svg(shapes: Iterable[Shape], title: str) -> str:
    """Write shapes as one SVG image on a white ground.

    Args:
        shapes: what is drawn, from the ground up; points have Fraction coordinates.
        title: what the picture shows.

    Returns:
        An `svg` element.

    Raises:
        DrawError: there is nothing to draw.

    Cost: linear in the number of points.
    """
    drawn = [Shape([list(loop) for loop in s.loops], s.look, s.closed) for s in shapes]
    scale = Scale.of(*chain.from_iterable(shape.loops for shape in drawn))
    placed = [[scale.places(loop) for loop in shape.loops] for shape in drawn]
    xs, ys = zip(*chain.from_iterable(chain.from_iterable(placed)), strict=True)
    left, top = min(xs), max(ys)
    across, up = max(xs) - left, top - min(ys)
    x_unit, y_unit = (_WIDTH / (across or 1), _HEIGHT / (up or 1))
    if scale.is_true:
        x_unit = y_unit = min(_WIDTH / (across or up or 1), _HEIGHT / (up or across or 1))
    paths = [
        _path(
            [
                [((x - left) * x_unit + _MARGIN, (top - y) * y_unit + _MARGIN) for x, y in loop]
                for loop in loops
            ],
            shape,
        )
        for loops, shape in zip(placed, drawn, strict=True)
    ]
    width, height = across * x_unit + 2 * _MARGIN, up * y_unit + 2 * _MARGIN
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}" '
        f'viewBox="0 0 {width:.0f} {height:.0f}" role="img">'
        f"<title>{escape(title)}</title>"
        '<rect width="100%" height="100%" fill="#ffffff"/>'
        f"{''.join(paths)}</svg>"
    )


def _path(loops: list[list[tuple[float, float]]], shape: Shape) -> str:
    data = path_data(loops, closed=shape.closed)
    look = shape.look
    fill, hatching = look.fill or "none", ""
    if look.hatch:
        # Equal in all pictures of a page, so that it does not matter whose is found.
        fill = f"url(#{_HATCH})"
        hatching = (
            f'<pattern id="{_HATCH}" width="5" height="5" patternUnits="userSpaceOnUse" '
            f'patternTransform="rotate(45)"><path d="M0 0V5" stroke="{look.color}" '
            'stroke-width="1.4"/></pattern>'
        )
    dash = ""
    if not isinstance(look.dash, str):
        lengths = " ".join(f"{length * look.width:.1f}" for length in look.dash[1])
        dash = f' stroke-dasharray="{lengths}"'
    return (
        f'{hatching}<path d="{data}" fill="{fill}" fill-rule="evenodd" stroke="{look.color}" '
        f'stroke-width="{look.width}" stroke-linejoin="round"{dash}/>'
    )


def draw_rings(rings: Iterable[Iterable[Vertex]], title: str) -> str:
    """Draw the rings of one polygon as an SVG image. Cost: O(n)."""
    return svg([Shape(list(rings), style.DIRECTRIX)], title)


def put_beside(picture: str, rows: Iterable[tuple[str, str]]) -> str:
    """Show a picture as HTML with a table of names and texts beside it."""
    table = "".join(
        f'<tr><th style="text-align:left">{escape(name)}</th>'
        f'<td style="text-align:left">{escape(text)}</td></tr>'
        for name, text in rows
    )
    return (
        '<div style="display:flex;flex-wrap:wrap;gap:1em;align-items:flex-start">'
        f"{picture}<table>{table}</table></div>"
    )


def path_data(
    lines: Iterable[Iterable[tuple[float, float]]], *, closed: bool, digits: int = 2
) -> str:
    """Write lines as the data of one SVG path.

    Args:
        lines: of points, in pixels; empty ones are left out.
        closed: whether each line is a loop.
        digits: how many decimals there are.

    Cost: linear in the number of points.

    >>> path_data([[(0, 0), (1, 0.125)]], closed=True)
    'M0.00 0.00L1.00 0.12Z'
    """
    corners = ("L".join(f"{x:.{digits}f} {y:.{digits}f}" for x, y in line) for line in lines)
    return "".join(f"M{line}{'Z' * closed}" for line in corners if line)
