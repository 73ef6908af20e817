"""Outlines inside others become holes only on request."""

from fractions import Fraction
from pathlib import Path

import pytest
from cells import shape_of
from command import refusal, run
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Region
from exactsweep.corpus.generator.cells import Cell, connect
from exactsweep.formats import (
    FormatError,
    NamedPolygon,
    format_polygons,
    parse_region,
    parse_regions,
    read_regions,
)


@examples(100)
@given(
    st.sets(st.tuples(st.integers(0, 6), st.integers(0, 6)), min_size=1),
    st.randoms(use_true_random=False),
    st.sampled_from([Fraction(1), Fraction(1, 8), Fraction(10**20)]),
)
def test_any_set_of_parts_round_trips(cells: set[Cell], random: object, scale: Fraction) -> None:
    parts = []
    while cells:
        part = connect(cells)
        cells = cells - part
        parts.append(shape_of(part).mapped(((2, 1), (1, 1)), scale))
    rings = [NamedPolygon(ring) for part in parts for ring in (part.exterior, *part.holes)]
    random.shuffle(rings)  # type: ignore[attr-defined]
    for form in ("dxf", "svg", "json"):
        found = parse_regions(format_polygons(rings, form), nested=True)
        assert {part.region for part in found} == {Region(*part) for part in parts}
        assert len(found) == len(parts)
    regions = [Region(*part) for part in parts]
    for form in ("dxf", "wkt"):
        found = parse_regions(format_polygons(regions, form), nested=True)
        assert [part.region for part in found] == regions


WKT = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))\n"


def test_nested_outlines_are_read_by_commands(tmp_path: Path) -> None:
    source, drawing, unit = (str(tmp_path / name) for name in ("p.wkt", "p.dxf", "unit.json"))
    Path(source).write_text(WKT)
    Path(unit).write_text("[[0, 0], [1, 0], [1, 1], [0, 1]]")
    done = run("convert", source, "-o", drawing)
    assert (done.exit_code, done.stdout) == (0, "")
    assert done.stderr == "1 hole written as closed polylines; read them with --nested\n"
    assert run("convert", drawing, "--to", "wkt").stdout.count("POLYGON") == 2
    assert run("convert", drawing, "--to", "wkt", "--nested").output == WKT
    assert "contains 2 polygons" in refusal(run("ifp", drawing, unit))
    assert len(run("nfp", drawing, unit).stdout.splitlines()) == 3
    for command, pair in (("nfp", (drawing, unit)), ("sweep", (unit, drawing))):
        output = run(command, *pair, "--nested").output.replace(drawing, source)
        assert output == run(command, *(source if p == drawing else p for p in pair)).output


GROUP = (
    '<svg><rect id="sheet" width="9" height="9"/><g id="part" transform="translate(1 1)">'
    '<rect width="4" height="4"/><g id="inner"><rect x="1" y="1" width="1" height="1"/></g></g>'
    "</svg>"
)


def test_outlines_of_a_group_are_one_region() -> None:
    plate = parse_region(GROUP, "part")
    assert plate.area == 15
    assert parse_region(GROUP, "inner").area == 1
    assert [part.name for part in parse_regions(GROUP)] == ["sheet", None, None]


def test_a_group_of_separate_outlines_is_not_one_region(tmp_path: Path) -> None:
    text = GROUP.replace("</g></g>", '</g><rect x="6" width="1" height="1"/></g>')
    with pytest.raises(
        FormatError, match=r"^the group 'part' has 2 outlines, not one; choose one by index$"
    ):
        parse_region(text, "part")
    drawing = tmp_path / "drawing.svg"
    drawing.write_text(text)
    assert [part.region.area for part in read_regions(f"{drawing}#part")] == [15, 1]
    with pytest.raises(FormatError, match="cannot nest the outlines: line 1: path: open end"):
        parse_region(GROUP.replace("</g></g>", '</g><path fill="none" d="M0 0h1v1"/></g>'), "part")
