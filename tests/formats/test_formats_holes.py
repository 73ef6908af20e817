"""Polygons with holes in every format: no hole is lost or becomes a part."""

import re

import pytest
import shapely
from cells import shape_of
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon, PolygonError, Region
from exactsweep.corpus.generator.cells import Cell, connect
from exactsweep.formats import (
    FormatError,
    from_shapely,
    from_wkt,
    parse_regions,
    to_shapely,
)
from exactsweep.geometry.edges import EdgeIndex
from exactsweep.geometry.overlap import Relation, relate

OUTER, INNER = [(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (2, 1), (2, 2), (1, 2)]
PLATE = Region(OUTER, [INNER])


@pytest.mark.parametrize(
    ("rings", "plates"),
    [
        ([(k, 1000 - k) for k in range(400)], 200),
        ([(k, 1000 - k) for k in reversed(range(400))], 200),
        ([(0, 9)] * 400, None),
        ([(3 * k, 3 * k + 2) for k in range(400)], 400),
    ],
)
@pytest.mark.parametrize("form", ["path", "polygons"])
def test_nested_rings_are_compared_once_each(
    rings: list[tuple[int, int]], plates: int | None, form: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Comparisons of all pairs would take quadratic time."""
    asked = 0

    def count(shape: EdgeIndex, part: EdgeIndex) -> Relation:
        nonlocal asked
        asked += 1
        return relate(shape, part)

    monkeypatch.setattr("exactsweep.geometry.overlap.relate", count)
    if form == "path":
        drawn = "".join(f"M{a} {a}H{b}V{b}H{a}z" for a, b in rings)
        text = f"<svg><path fill-rule='evenodd' d='{drawn}'/></svg>"
    else:
        square = "POLYGON (({0} {0}, {1} {0}, {1} {1}, {0} {1}, {0} {0}))"
        text = "".join(square.format(a, b) for a, b in rings)
    if plates is None and form == "polygons":
        assert len(parse_regions(text, nested=True)) == len(rings)
    elif plates is None:
        with pytest.raises(ValueError, match="line 1: path: its fill rule fills nothing"):
            parse_regions(text)
    else:
        assert len(parse_regions(text, nested=form == "polygons")) == plates
    # Two tests: one decides whether it lies in the next one, the other whether they cross.
    assert asked <= 2 * len(rings)


Box = tuple[int, int, int, int, bool]
boxes = st.lists(
    st.tuples(
        st.integers(0, 6), st.integers(0, 6), st.integers(1, 7), st.integers(1, 7), st.booleans()
    ),
    min_size=1,
    max_size=4,
)


def path_of(box: Box) -> str:
    x, y, width, height, left = box
    if left:
        return f"M{x} {y}h{width}v{height}h-{width}z"
    return f"M{x} {y}v{height}h{width}v-{height}z"


def filled(found: list[Box], even_odd: bool) -> set[Cell]:
    """Count for each unit square the boxes around it."""
    cells = {(x, y): 0 for x in range(14) for y in range(14)}
    for x, y, width, height, left in found:
        for cell in ((i, j) for i in range(x, x + width) for j in range(y, y + height)):
            cells[cell] += 1 if even_odd or left else -1
    return {cell for cell, count in cells.items() if (count % 2 if even_odd else count)}


def have_common_edges(found: list[Box]) -> bool:
    """Return whether the boundaries of two boxes share a unit segment."""
    seen: list[tuple[Cell, Cell]] = []
    for x, y, width, height, _ in found:
        seen += [((i, j), (i + 1, j)) for i in range(x, x + width) for j in (y, y + height)]
        seen += [((i, j), (i, j + 1)) for i in (x, x + width) for j in range(y, y + height)]
    return len(set(seen)) < len(seen)


@examples(300)
@given(boxes, st.booleans())
def test_fill_rules_agree_with_counting(found: list[Box], even_odd: bool) -> None:
    rule = "evenodd" if even_odd else "nonzero"
    data = "".join(map(path_of, found))
    text = f"<svg><path fill-rule='{rule}' d='{data}'/></svg>"
    try:
        drawn = parse_regions(text)
    except ValueError:
        with pytest.raises(ValueError, match=r"cross|overlap along|is disconnected|fills nothing"):
            parse_regions(text)
        return
    if drawn.left_out:
        assert re.search(r"cross|overlap along|is disconnected", drawn.left_out[0])
        return
    cells = filled(found, even_odd)
    assert sum(part.region.area for part in drawn) == len(cells)
    if not have_common_edges(found):
        parts = []
        while cells:
            parts.append(connect(cells))
            cells = cells - parts[-1]
        assert {part.region for part in drawn} == {Region(*shape_of(part)) for part in parts}


def test_shapely_interiors_are_holes() -> None:
    found = from_shapely(shapely.box(0, 0, 4, 4) - shapely.box(1, 1, 2, 2))
    assert found == PLATE
    assert isinstance(from_shapely(shapely.box(0, 0, 4, 4)), Polygon)
    assert from_wkt("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))") == PLATE
    with pytest.raises(FormatError, match=r"^hole 0, vertex 1: 4/3 is not a float; nearest"):
        to_shapely(Region(OUTER, [[(1, 1), ("4/3", 1), (1, 2)]]))
    crossing = shapely.Polygon(OUTER, [[(3, 1), (9, 1), (3, 2)]])
    with pytest.raises(PolygonError, match="the exterior, edge 1, and hole 0, edge 0 cross"):
        from_shapely(crossing)
