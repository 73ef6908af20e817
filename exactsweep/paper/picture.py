"""Small pictures of pairs: D, G beside it, and the path of G if there is one."""

from __future__ import annotations

from collections.abc import Sequence

from exactsweep import sweep
from exactsweep.direction import DirectionError
from exactsweep.draw.path import path_data
from exactsweep.paper.pairs import Pair

SIZE, MARGIN = 200, 6
XY = Sequence[tuple[float, float]]


def pair_svg(pair: Pair) -> str:
    """An SVG with D filled grey, G blue at one end of its path, and the path of its origin dashed.

    For polygons without a shared direction G stands beside D.

    >>> triangle = [(0, 0), (1, 0), (0, 1)]
    >>> pair_svg(Pair(triangle, triangle)).count("<path")
    3
    """
    directrix: XY = [(float(x), float(y)) for x, y in pair.directrix]
    path: XY = []
    try:
        corners = sweep(*pair).trajectory.vertices
        t = (float(corners[0].x), float(corners[0].y))
        path = [(float(x), float(y)) for x, y in corners]
    except DirectionError:
        right = max(x for x, _ in directrix) - min(x for x, _ in pair.generatrix)
        t = (right + 1.0, min(y for _, y in directrix))
    generatrix: XY = [(x + t[0], y + t[1]) for x, y in pair.generatrix]
    xs, ys = zip(*directrix, *generatrix, *path, strict=True)
    scale = SIZE / max(max(xs) - min(xs), max(ys) - min(ys))
    width, height = ((max(c) - min(c)) * scale + 2 * MARGIN for c in (xs, ys))

    left, top = min(xs), max(ys)

    def shape(points: XY, kind: str) -> str:
        placed = [((x - left) * scale + MARGIN, (top - y) * scale + MARGIN) for x, y in points]
        return f'<path class="{kind}" d="{path_data([placed], closed=True, digits=1)}"/>'

    shapes = [shape(directrix, "directrix"), shape(generatrix, "generatrix")]
    if path:
        shapes.append(shape(path, "path"))
    return (
        f'<svg role="img" aria-label="D grey, G blue" width="{width:.0f}" height="{height:.0f}">'
        f"{''.join(shapes)}</svg>"
    )
