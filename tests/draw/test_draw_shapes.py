"""Pictures of no-fit polygons and inner fits, and of polygons with holes."""

import json
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from command import run
from hypothesis import given
from matplotlib.axes import Axes
from strategies import simple_polygons
from test_notebook import Balanced, inside
from tiers import examples

from exactsweep import (
    InnerFit,
    NoFitPolygon,
    Polygon,
    Region,
    inner_fit_polygon,
    no_fit_polygon,
)
from exactsweep.canvas import style
from exactsweep.draw import make_figure

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
# Holes in which the square has room, just slides, and just fits.
PLATE = Region(
    [(0, 0), (9, 0), (9, 5), (0, 5)],
    [
        [(1, 1), (4, 1), (4, 3), (1, 3)],
        [(5, 1), (6, 1), (6, 4), (5, 4)],
        [(7, 2), (8, 2), (8, 3), (7, 3)],
    ],
)
CHANNEL = [(0, 0), (5, 0), (5, 1), (0, 1)]


def picture_of(found: NoFitPolygon | InnerFit, **options: Any) -> Axes:
    return found.plot(make_figure().axes[0], **options)


def labels(axes: Axes) -> list[str]:
    legend = axes.get_legend()
    assert legend is not None
    return [text.get_text() for text in legend.get_texts()]


def line(axes: Axes, label: str) -> list[tuple[float, float]]:
    """The points of the line of a label; chains are parted by nan."""
    (found,) = (one for one in axes.lines if one.get_label() == label)
    points: Any = found.get_xydata()
    return [(float(x), float(y)) for x, y in points if x == x]


def rings(axes: Axes, order: float) -> list[list[tuple[float, float]]]:
    """The rings of the areas that are drawn at a height."""
    found = []
    for patch in axes.patches:
        if patch.get_zorder() == order:
            for ring in patch.get_path().to_polygons(closed_only=False):
                points: Any = ring
                found.append([(float(x), float(y)) for x, y in points[:-1]])
    return found


def test_holes_are_cut_out() -> None:
    for shape, order in (PLATE, style.DIRECTRIX.order), (Region(SQUARE), style.GENERATRIX.order):
        axes = picture_of(no_fit_polygon(PLATE, SQUARE), positions=[(0, 0)])
        exterior, *holes = rings(axes, order)
        assert exterior == [(float(x), float(y)) for x, y in shape.exterior.vertices]
        # Holes run clockwise: what is inside them is not filled.
        assert [hole[::-1] for hole in holes] == [
            [(float(x), float(y)) for x, y in hole.vertices] for hole in shape.holes
        ]


def test_a_ring_that_moves_keeps_its_hole() -> None:
    ring = Region([(0, 0), (3, 0), (3, 3), (0, 3)], [[(1, 1), (2, 1), (2, 2), (1, 2)]])
    axes = picture_of(no_fit_polygon(SQUARE, ring), positions=[(10, 0)])
    exterior, hole = rings(axes, style.GENERATRIX.order)
    assert exterior == [(10, 0), (13, 0), (13, 3), (10, 3)]
    assert hole[::-1] == [(11, 1), (12, 1), (12, 2), (11, 2)]
    # It goes over the square where this just fits its hole.
    assert line(axes, "exact fit, one position") == [(-1, -1)]


def test_a_far_reference_point_leaves_the_picture_alone() -> None:
    near = picture_of(no_fit_polygon(PLATE, SQUARE))
    far = picture_of(no_fit_polygon(PLATE, SQUARE, reference=(10**40, 0)))
    assert line(near, "exact fit") == line(far, "exact fit")
    assert rings(near, style.FREE.order) == rings(far, style.FREE.order)
    assert "vertex 0 of G" in labels(far)


@examples(25)
@given(simple_polygons(), simple_polygons())
def test_every_answer_has_a_picture_in_a_notebook(d: Polygon, g: Polygon) -> None:
    for found in (no_fit_polygon(d, g), inner_fit_polygon(d, g)):
        assert inside(ElementTree.fromstring(found._repr_svg_()))
        Balanced(found._repr_html_())


def test_a_sweep_of_any_shape_is_drawn(tmp_path: Path) -> None:
    parts = tmp_path / "plate.json"
    parts.write_text(json.dumps({"exterior": [[0, 0], [5, 0], [5, 5], [0, 5]],
                                 "holes": [[[1, 1], [3, 1], [3, 3], [1, 3]]]}))  # fmt: skip
    output = tmp_path / "out.png"
    result = run("draw", "-", str(parts), "-o", str(output), stdin=json.dumps(SQUARE))
    assert (result.exit_code, result.output) == (0, "")
    assert output.read_bytes().startswith(b"\x89PNG")
