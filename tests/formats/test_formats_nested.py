"""Closed outlines inside others become holes when that is asked for, and only then."""

from fractions import Fraction
from pathlib import Path

import pytest
from cells import shape_of
from command import refusal, run
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon, Region
from exactsweep.corpus.generator.cells import Cell, connect
from exactsweep.formats import (
    FormatError,
    NamedPolygon,
    format_polygons,
    parse_region,
    parse_regions,
)


def square(low: int, high: int) -> Polygon:
    return Polygon([(low, low), (high, low), (high, high), (low, high)])


def drawn(*squares: tuple[int, int], layer: str = "cut") -> list[NamedPolygon]:
    return [NamedPolygon(square(*sides), layer=layer) for sides in squares]


def test_layers_are_nested_apart() -> None:
    text = format_polygons(drawn((0, 9)) + drawn((1, 2), layer="fold"), "dxf")
    assert [part.layer for part in parse_regions(text, nested=True)] == ["cut", "fold"]
    assert parse_region(text, "cut", nested=True) == Region(square(0, 9))
    text = format_polygons(drawn((0, 9), (1, 2)) + drawn((1, 2), layer="fold"), "dxf")
    assert parse_region(text, "cut", nested=True) == Region(square(0, 9), [square(1, 2)])


@examples(100)
@given(
    st.sets(st.tuples(st.integers(0, 6), st.integers(0, 6)), min_size=1),
    st.randoms(use_true_random=False),
    st.sampled_from([Fraction(1), Fraction(1, 8), Fraction(10**20)]),
)
def test_any_set_of_parts_comes_back(cells: set[Cell], random: object, scale: Fraction) -> None:
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


def test_what_cannot_be_read_might_be_a_hole() -> None:
    text = format_polygons(drawn((0, 9), (1, 2)) + drawn((0, 3), layer="b"), "dxf")
    end = "  0\nENDSEC\n"
    text = text.replace(end, f"  0\nCIRCLE\n  8\ncut\n 10\n5\n 20\n5\n 40\n1\n{end}")
    message = r"^nested outlines are read with all of their layer: line \d+: CIRCLE: a curve, which"
    for k in "013":
        with pytest.raises(FormatError, match=message):
            parse_region(text, k, nested=True)
    assert parse_region(text, "b", nested=True) == Region(square(0, 3))
    assert len(parse_region(text, "0", "1/10", nested=True).holes) == 2


@pytest.mark.parametrize(
    ("squares", "message"),
    [
        (((0, 3), (2, 5)), r"layer: line \d+: POLYLINE and line \d+: POLYLINE cross$"),
        (((0, 9), (1, 5), (4, 8)), r"POLYLINE cross$"),
        (((0, 9), (0, 9)), "run along each other"),
        (((0, 9), (0, 5)), "run along each other"),
    ],
)
def test_crossing_outlines_are_refused(squares: tuple[tuple[int, int], ...], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        parse_regions(format_polygons(drawn(*squares), "dxf"), nested=True)


def test_names_are_those_of_the_exteriors() -> None:
    text = "<svg><rect id='p' width='9' height='9'/><circle id='drill' cx='4' cy='4' r='1'/></svg>"
    (part,) = parse_regions(text, "1/10", nested=True)
    assert (part.name, len(part.region.holes)) == ("p", 1)


WKT = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))\n"


def test_nested_outlines_are_read_by_commands(tmp_path: Path) -> None:
    source, drawing, unit = (str(tmp_path / name) for name in ("p.wkt", "p.dxf", "unit.json"))
    Path(source).write_text(WKT)
    Path(unit).write_text("[[0, 0], [1, 0], [1, 1], [0, 1]]")
    done = run("convert", source, "-o", drawing)
    assert (done.exit_code, done.stdout) == (0, "")
    assert done.stderr == "1 hole written as closed polylines, which --nested reads as holes\n"
    assert run("convert", drawing, "--to", "wkt").stdout.count("POLYGON") == 2
    assert run("convert", drawing, "--to", "wkt", "--nested").output == WKT
    assert "holds 2 polygons" in refusal(run("ifp", drawing, unit))
    assert len(run("nfp", drawing, unit).stdout.splitlines()) == 3
    assert run("nfp", drawing, unit, "--nested").output == run("nfp", source, unit).output
    assert run("sweep", unit, drawing, "--nested").output == run("sweep", unit, source).output
