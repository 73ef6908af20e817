"""A contact sheet: a small picture of every case, as SVG.

Coordinates are scaled exactly, each case to its own picture, and only then rounded to pixels. Where
a picture would be over twelve times as long as wide, its axes are scaled apart, and it says so.
"""

from collections.abc import Iterable, Iterator, Sequence
from math import isqrt
from xml.sax.saxutils import escape

from exactsweep.canvas.svg import path_data
from exactsweep.canvas.window import Window
from exactsweep.corpus.case import Case
from exactsweep.geometry.point import Point

_SIDE = 200
_MARGIN = 12
_LABEL = 34

_STYLE = """<style>
 svg { background: #fff; font: 9px sans-serif; }
 path { fill: none; stroke-width: 1; stroke-linejoin: round; vector-effect: non-scaling-stroke; }
 .outer { stroke: #999; fill: #f3f3f3; }
 .inner { stroke: #b00; fill: #fff; stroke-dasharray: 3 2; }
 .directrix { stroke: #124; fill: #9bd; }
 .generatrix { stroke: #730; fill: #fc9; fill-opacity: 0.7; }
 .trajectory { stroke: #080; }
 .fit { stroke: #c0c; stroke-width: 2; }
 .note { fill: #777; }
</style>
"""


def cases_to_svg(cases: Iterable[Case]) -> Iterator[str]:
    """Draw cases on a sheet about as wide as high.

    Args:
        cases: the cases.

    Returns:
        An iterator of parts of the text. D is blue; G, orange, stands where the trajectory begins.
        The trajectory is green, as the path of G's leftmost vertex wherever the reference point is;
        exact fits are magenta; the outer loop is grey, the inner one a dashed line in red.

    Cost: linear in the number of vertices.

    Example:
        >>> from exactsweep.corpus import find_case
        >>> "".join(cases_to_svg([find_case("fits-square")])).count("<path")
        6
    """
    drawn = list(cases)
    columns = max(1, isqrt(max(0, len(drawn) - 1)) + 1)
    rows = -(-len(drawn) // columns)
    width, height = columns * _SIDE, rows * (_SIDE + _LABEL)
    yield (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
        f'viewBox="0 0 {width} {height}">\n{_STYLE}'
    )
    for k, case in enumerate(drawn):
        x, y = k % columns * _SIDE, k // columns * (_SIDE + _LABEL)
        yield f'<g transform="translate({x} {y})">\n{"".join(_picture(case))}</g>\n'
    yield "</svg>\n"


def _picture(case: Case) -> Iterator[str]:
    window = Window.around(case.outer.vertices, _SIDE, _SIDE, _MARGIN)

    def path(name: str, points: Sequence[Point], *, closed: bool = True) -> str:
        data = path_data([map(window.place, points)], closed=closed)
        return f'<path class="{name}" d="{data}"/>\n'

    def moved(points: Sequence[Point], by: Point, back: Point) -> list[Point]:
        return [Point(p.x + by.x - back.x, p.y + by.y - back.y) for p in points]

    g = case.generatrix.vertices
    start = case.trajectory.vertices[0]
    yield path("outer", case.outer.vertices)
    yield path("inner", case.inner.vertices)
    yield path("directrix", case.directrix_ring)
    yield path("generatrix", moved(g, start, case.reference))
    yield path("trajectory", moved(case.trajectory.vertices, g[0], case.reference))
    for fit in case.exact_fits:
        yield path("fit", moved(fit, g[0], case.reference), closed=False)
    note = f"{case.kind}, {case.size} vertices{'' if window.is_true else ', axes scaled apart'}"
    yield f'<text x="{_MARGIN}" y="{_SIDE + 8}">{escape(case.id)}</text>\n'
    yield f'<text x="{_MARGIN}" y="{_SIDE + 20}" class="note">{note}</text>\n'
