"""Polygons with holes, read from every format that has them; none is lost or made a part."""

import re
from pathlib import Path

import pytest
import shapely
from cells import shape_of
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Point, Polygon, PolygonError, Region
from exactsweep.corpus.generator.cells import Cell, connect
from exactsweep.formats import (
    FormatError,
    NamedRegion,
    from_shapely,
    parse_polygon,
    parse_polygons,
    parse_region,
    parse_regions,
    read_polygons,
    read_region,
    read_regions,
)
from exactsweep.geometry.overlap import Overlap

OUTER, INNER = [(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (2, 1), (2, 2), (1, 2)]
PLATE = Region(OUTER, [INNER])
RINGS = "[[[0,0],[4,0],[4,4],[0,4],[0,0]], [[1,1],[2,1],[2,2],[1,2],[1,1]]]"
TEXTS = {
    "json": '{"exterior": [[0,0],[4,0],[4,4],[0,4]], "holes": [[[1,1],[2,1],[2,2],[1,2]]]}',
    "wkt": "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))",
    "multi": "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1)))",
    "geojson": f'{{"type": "Polygon", "coordinates": {RINGS}}}',
    "geojson multi": f'{{"type": "MultiPolygon", "coordinates": [{RINGS}]}}',
    "svg nonzero": "<svg><path d='M0 0H4V4H0zM1 1v1h1v-1z'/></svg>",
    "svg evenodd": "<svg><path fill-rule='evenodd' d='M0 0H4V4H0zM1 1h1v1H1z'/></svg>",
    "svg relative": "<svg><path d='m0 0h4v4h-4zm1 1v1h1v-1z'/></svg>",
    "svg hole first": "<svg><path d='M1 1v1h1v-1zM0 0H4V4H0V0'/></svg>",
    "svg inherited": "<svg fill-rule='evenodd'><g><path d='M0 0H4V4H0zM1 1h1v1H1z'/></g></svg>",
    "svg style": "<svg><path fill-rule='nonzero' style='a:b; fill-rule : evenodd!important' "
    "d='M0 0H4V4H0zM1 1h1v1H1z'/></svg>",
    "svg mirrored": "<svg><path transform='scale(-1 1)' d='M0 0H-4V4H0zM-1 1v1h-1v-1z'/></svg>",
}  # fmt: skip
PLACES = {
    "json": "$.holes[0]",
    "wkt": "line 1, column 37",
    "multi": "line 1, column 43",
    "geojson": "$.coordinates[1]",
    "geojson multi": "$.coordinates[0][1]",
    "svg hole first": "line 1: path: subpath 0",
}


@pytest.mark.parametrize("name", TEXTS)
def test_holes_are_read(name: str, tmp_path: Path) -> None:
    path = tmp_path / "plate"
    path.write_text(TEXTS[name])
    assert parse_region(TEXTS[name]) == read_region(str(path)) == PLATE
    assert parse_regions(TEXTS[name]) == read_regions(f"{path}#0") == [NamedRegion(PLATE)]


@pytest.mark.parametrize("name", TEXTS)
def test_who_wants_a_polygon_is_told_of_the_hole(name: str, tmp_path: Path) -> None:
    place = PLACES.get(name, "line 1: path: subpath 1")
    path = tmp_path / "plate"
    path.write_text(TEXTS[name])
    for read in (parse_polygon, parse_polygons):
        with pytest.raises(FormatError) as caught:
            read(TEXTS[name])
        assert str(caught.value) == f"{place}: an inner ring: with it, this is a Region, no Polygon"
    with pytest.raises(FormatError, match=r"plate: .*an inner ring"):
        read_polygons(str(path))


def test_a_ring_that_winds_the_same_way_draws_nothing() -> None:
    inner = "M1 1h2v2H1z"
    text = f"<svg><path d='M0 0H4V4H0z{inner}'/></svg>"
    assert parse_polygon(text) == Polygon(OUTER)
    assert parse_region(text) == Region(OUTER)
    twice = f"<svg><path d='M0 0H4V4H0z{inner}M1 1v1h1V1zM1 1v1h1V1z'/></svg>"
    assert parse_region(twice) == PLATE


REFUSED = {
    "d='M0 0H4V4H0zM3 1v1h9v-1z'": "subpath 0 and subpath 1 cross",
    "d='M0 0H4V4H0zM2 0h9v9z'": "subpath 1 and subpath 0 cross",
    "d='M0 0H4V4H0zM1 1h1z'": "subpath 1: fewer than three distinct vertices",
    "d='M0 0H4V4H0zM0 1v1h1v-1z'": "hole 0, edge 0, and the exterior, edge 3 run along each other",
    "d='M0 0H4V4H0zM0 2L2 3 4 2 2 1z'": "the interior falls apart",
    "fill-rule='odd' d='M0 0H4V4H0zM1 1h1v1z'": "the fill rule 'odd' is neither",
}  # fmt: skip


@pytest.mark.parametrize(
    ("data", "regions"),
    [
        ("M0 0H4V4H0z M5 0h1v1h-1z", [(16, 0), (1, 0)]),
        ("M0 0H9V9H0z M1 1v7h7v-7z M2 2h1v1h-1z", [(81 - 49, 1), (1, 0)]),
        ("M0 0H9V9H0z M1 1H8V8H1z M2 2v1h1v-1z", [(81, 0)]),
        ("M0 0H9V9H0z M1 1H8V8H1z M2 2v1h1v-1z M4 4v1h1v-1z", [(81, 0)]),
    ],
)
def test_a_path_may_draw_several_regions(data: str, regions: list[tuple[int, int]]) -> None:
    found = parse_regions(f"<svg><path d='{data}'/></svg>")
    assert [(int(part.region.area), len(part.region.holes)) for part in found] == regions


@pytest.mark.parametrize("path", REFUSED)
def test_paths_that_draw_no_region_are_named(path: str) -> None:
    with pytest.raises(ValueError, match=r"^line 2: path 'p': ") as caught:
        parse_region(f"<svg>\n<path id='p' {path}/></svg>")
    assert REFUSED[path] in str(caught.value)


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
def test_rings_in_rings_are_asked_about_once_each(
    rings: list[tuple[int, int]], plates: int | None, form: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An earlier version compared each with all around it, and refused more than 100 of them."""
    asked = 0
    at = Overlap.at

    def count(self: Overlap, t: Point) -> bool:
        nonlocal asked
        asked += 1
        return at(self, t)

    monkeypatch.setattr(Overlap, "at", count)
    if form == "path":
        drawn = "".join(f"M{a} {a}H{b}V{b}H{a}z" for a, b in rings)
        text = f"<svg><path fill-rule='evenodd' d='{drawn}'/></svg>"
    else:
        square = "POLYGON (({0} {0}, {1} {0}, {1} {1}, {0} {1}, {0} {0}))"
        text = "".join(square.format(a, b) for a, b in rings)
    if plates is None:
        with pytest.raises(ValueError, match="hole 0, edge 3, and the exterior, edge 3 run along"):
            parse_regions(text, nested=form == "polygons")
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
    """The unit squares that the boxes draw, by counting for each square the boxes around it."""
    cells = {(x, y): 0 for x in range(14) for y in range(14)}
    for x, y, width, height, left in found:
        for cell in ((i, j) for i in range(x, x + width) for j in range(y, y + height)):
            cells[cell] += 1 if even_odd or left else -1
    return {cell for cell, count in cells.items() if (count % 2 if even_odd else count)}


def have_common_edges(found: list[Box]) -> bool:
    """Decide whether two boxes have a unit of their boundaries in common."""
    seen: list[tuple[Cell, Cell]] = []
    for x, y, width, height, _ in found:
        seen += [((i, j), (i + 1, j)) for i in range(x, x + width) for j in (y, y + height)]
        seen += [((i, j), (i, j + 1)) for i in (x, x + width) for j in range(y, y + height)]
    return len(set(seen)) < len(seen)


@examples(300)
@given(boxes, st.booleans())
def test_the_fill_rules_are_those_of_counting(found: list[Box], even_odd: bool) -> None:
    rule = "evenodd" if even_odd else "nonzero"
    data = "".join(map(path_of, found))
    text = f"<svg><path fill-rule='{rule}' d='{data}'/></svg>"
    try:
        drawn = parse_regions(text)
    except ValueError:
        with pytest.raises(ValueError, match=r"cross|run along|falls apart"):
            parse_regions(text)
        return
    if drawn.left_out:
        assert re.search(r"cross|run along|falls apart", drawn.left_out[0])
        return
    cells = filled(found, even_odd)
    assert sum(part.region.area for part in drawn) == len(cells)
    if not have_common_edges(found):
        parts = []
        while cells:
            parts.append(connect(cells))
            cells = cells - parts[-1]
        assert {part.region for part in drawn} == {Region(*shape_of(part)) for part in parts}


def test_interiors_of_shapely_are_holes() -> None:
    found = from_shapely(shapely.box(0, 0, 4, 4) - shapely.box(1, 1, 2, 2))
    assert found == PLATE
    assert isinstance(from_shapely(shapely.box(0, 0, 4, 4)), Polygon)
    crossing = shapely.Polygon(OUTER, [[(3, 1), (9, 1), (3, 2)]])
    with pytest.raises(PolygonError, match="the exterior, edge 1, and hole 0, edge 0 cross"):
        from_shapely(crossing)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('{"type": "Polygon", "coordinates": [[], []]}', r"^\$\.coordinates\[0\] is empty$"),
        (
            f'{{"type": "Polygon", "coordinates": {RINGS.replace(",[1,1]]]", "]]")}}}',
            r"^\$\.coordinates\[1\] is not closed: the last vertex must repeat the first$",
        ),
        (
            f'{{"type": "Polygon", "coordinates": {RINGS.replace("[1,2]", "[1,9]")}}}',
            r"^hole 0, edge 3, and the exterior, edge 2 cross$",
        ),
    ],
)
def test_bad_inner_rings_are_named(text: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        parse_region(text)
