"""Axis direction and unit survive reading and writing."""

import re
from fractions import Fraction
from io import StringIO
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import ezdxf.filemanagement as files
import pytest
import shapely
from command import refusal, run
from drawings import Drawing, every_drawing

from exactsweep import Region, no_fit_polygon
from exactsweep.formats import (
    Coordinates,
    PartList,
    format_polygons,
    parse_regions,
    read_region,
    read_regions,
)
from exactsweep.formats.candidate import NamedRegion

# The letter L, which no rotation maps to its mirror image.
ELL = [(0, 0), (4, 0), (4, 1), (1, 1), (1, 9), (0, 9)]
WITH_UNIT = ("mm", "cm", "m", "um", "dm", "in", "ft")


@pytest.fixture
def ells(tmp_path: Path) -> dict[str, str]:
    """Write an L that looks the same on the screen in files of both axis directions."""
    down = " ".join(f"{x},{9 - y}" for x, y in ELL)
    texts = {
        "svg": f'<svg width="4in" viewBox="0 0 101.6 9"><polygon id="l" points="{down}"/></svg>',
        "dxf": format_polygons([Region(ELL)], "dxf", coordinates=Coordinates(unit=Fraction(1))),
        "json": format_polygons([Region(ELL)], "json"),
    }
    for form, text in texts.items():
        (tmp_path / f"l.{form}").write_text(text)
    return {form: str(tmp_path / f"l.{form}") for form in texts}


def test_pairs_of_both_axis_directions_agree(ells: dict[str, str]) -> None:
    ell = read_region(ells["json"])
    for first, second in (("dxf", "svg"), ("svg", "dxf"), ("svg", "json")):
        done = run("nfp", ells[first], ells[second], "--to", "wkt")
        assert done.exit_code == 0
        assert "l.svg: Y axis flipped: it points down in this file and up in others" in done.stderr
        (found,) = parse_regions(done.stdout)
        n = no_fit_polygon(ell, ell)
        assert found.region.area == n.area
        assert found.region == Region(n.exterior).translated((0, 9 if second == "svg" else -9))
    same = run("nfp", ells["svg"], ells["svg"], "--to", "svg")
    assert (same.exit_code, same.stderr) == (0, "")
    both = run("ifp", ells["svg"], ells["dxf"])
    assert "Y axis flipped" in both.stderr


def test_sheets_of_both_axis_directions_agree(ells: dict[str, str], tmp_path: Path) -> None:
    done = run("convert", str(tmp_path), "--to", "json")
    parts = [part.region for part in parse_regions(done.stdout)]
    assert len(parts) == 3
    assert len({part.translated([-c for c in part.bounding_box[0]]) for part in parts}) == 1
    assert done.stderr.count("Y axis flipped") == 1


@pytest.mark.parametrize("source", ["svg", "dxf", "json"])
@pytest.mark.parametrize("target", ["svg", "dxf", "json", "wkt", "geojson", "csv"])
def test_converted_parts_look_the_same(source: str, target: str, ells: dict[str, str]) -> None:
    done = run("convert", ells[source], "--to", target)
    assert done.exit_code == 0
    differs = (source == "svg") != (target == "svg")
    assert ("Y axis flipped" in done.stderr) == differs
    (part,) = parse_regions(done.stdout)
    region = part.region.scaled((1, -1)) if target == "svg" else part.region
    x, y = region.bounding_box[0]
    assert region.translated((-x, -y)) == Region(ELL)


def test_flags_override_the_axis_direction(ells: dict[str, str]) -> None:
    plain = run("convert", ells["svg"], "--y-up", "--to", "json")
    assert plain.stderr == ""
    assert parse_regions(plain.stdout)[0].region == Region([(x, 9 - y) for x, y in ELL])
    kept = run("convert", ells["json"], "--y-down", "--to", "svg")
    assert kept.stderr == ""
    assert parse_regions(kept.stdout)[0].region == Region(ELL)
    assert run("convert", ells["json"], "--y-down", "--to", "json").stderr == ""


def test_python_keeps_coordinates(ells: dict[str, str]) -> None:
    drawn, cut = read_regions(ells["svg"]), read_regions(ells["dxf"])
    assert drawn.coordinates == Coordinates(y_down=True, unit=Fraction(1))
    assert cut.coordinates == Coordinates(y_down=False, unit=Fraction(1))
    text = format_polygons(drawn, "dxf", coordinates=drawn.coordinates)
    assert parse_regions(text)[0].region.translated((0, 9)) == cut[0].region
    assert isinstance(drawn, PartList)


@pytest.mark.parametrize("unit", WITH_UNIT)
@pytest.mark.parametrize("form", ["svg", "dxf"])
def test_units_survive_writing_and_reading(unit: str, form: str, ells: dict[str, str]) -> None:
    done = run("convert", ells["svg"], "--unit", "mm", "--to", form)
    (millimeters,) = parse_regions(done.stdout, unit="mm")
    assert millimeters.region.area == Region(ELL).area
    (part,) = parse_regions(done.stdout, unit=unit)
    text = format_polygons(
        [part._replace(region=part.region.scaled(381))],
        form,
        coordinates=parse_regions(done.stdout, unit=unit).coordinates,
    )
    assert parse_regions(text, unit="mm")[0].region == millimeters.region.scaled(381)


def test_svg_has_the_size_of_its_outlines_and_a_margin(ells: dict[str, str]) -> None:
    done = run("convert", ells["dxf"], "--to", "svg")
    root = ElementTree.fromstring(done.stdout)
    assert (root.get("fill"), root.get("stroke")) == ("none", "black")
    left, top, width, height = map(Fraction, str(root.get("viewBox")).split())
    assert (root.get("width"), root.get("height")) == (f"{float(width)}mm", f"{float(height)}mm")
    assert left < 0
    assert top < -9
    assert left + width > 4
    assert top + height > 0
    assert Fraction(str(root.get("stroke-width"))) < width / 50


def test_different_units_are_reported(ells: dict[str, str], tmp_path: Path) -> None:
    inches = tmp_path / "inches.dxf"
    inches.write_text(
        format_polygons([Region(ELL)], "dxf", coordinates=Coordinates(unit=Fraction("25.4")))
    )
    assert "different units (--unit" in run("nfp", ells["dxf"], str(inches)).stderr
    assert run("nfp", ells["dxf"], str(inches), "--unit", "cm").stderr == ""
    assert "--unit" in refusal(run("nfp", ells["json"], str(inches), "--unit", "cm"))


def test_insunits_14_is_a_decimeter() -> None:
    text = format_polygons([Region(ELL)], "dxf", coordinates=Coordinates(unit=Fraction(100)))
    assert re.search(r"\$INSUNITS\n 70\n14\n", text)
    assert parse_regions(text, unit="cm")[0].region == Region(ELL).scaled(10)


READ = [drawing for drawing in every_drawing() if drawing.areas]


@pytest.mark.long
@pytest.mark.parametrize("form", ["svg", "dxf"])
@pytest.mark.parametrize("drawing", READ, ids=lambda drawing: drawing.name)
def test_other_libraries_read_the_same_area_and_handedness(
    form: str, drawing: Drawing, tmp_path: Path
) -> None:
    """ezdxf and ElementTree read; shapely measures areas and centroids."""
    path = tmp_path / drawing.name
    path.write_text(drawing.text, encoding="utf-8", newline="")
    done = run("convert", str(path), *drawing.options, "--to", form)
    options = dict(zip(drawing.options[::2], drawing.options[1::2], strict=False))
    parts = read_regions(
        str(path),
        options.get("--flatten"),
        join=options.get("--join"),
        unit=options.get("--unit"),
        nested="--nested" in drawing.options,
    )
    side = -1 if parts.coordinates.y_down != (form == "svg") else 1
    rings = [ring for part in parts for ring in part.region.rings]
    wanted = sorted(_measure([(float(x), side * float(y)) for x, y in ring]) for ring in rings)
    read = _read_svg(done.stdout) if form == "svg" else _read_dxf(done.stdout)
    found = sorted(map(_measure, read))
    assert len(found) == len(wanted)
    for one, other in zip(found, wanted, strict=True):
        assert one == pytest.approx(other, abs=3e-5)
    if form == "dxf":
        unit = parts.coordinates.unit
        assert files.read(StringIO(done.stdout)).units == (
            4 if unit == 1 else 5 if unit == 10 else 0
        )


def _measure(ring: list[tuple[float, float]]) -> tuple[float, float, float]:
    polygon = shapely.Polygon(ring)
    # Rounded, so that equal areas are sorted by the centroid.
    return round(polygon.area, 5), round(polygon.centroid.x, 5), round(polygon.centroid.y, 5)


def _read_svg(text: str) -> list[list[tuple[float, float]]]:
    found = []
    for element in ElementTree.fromstring(text):
        for ring in re.findall(r"[^Mz]+", element.get("points") or element.get("d") or ""):
            pairs = [point.split(",") for point in ring.split()]
            found.append([(float(x), float(y)) for x, y in pairs])
    return [ring for ring in found if ring]


def _read_dxf(text: str) -> list[list[tuple[float, float]]]:
    space: Any = files.read(StringIO(text)).modelspace()
    return [[(p.x, p.y) for p in line.points()] for line in space.query("POLYLINE")]


def test_regions_flip_with_their_holes() -> None:
    plate = NamedRegion(Region([(0, 0), (9, 0), (0, 9)], [[(1, 1), (3, 1), (1, 2)]]), "p")
    assert plate.flipped().region == Region(
        [(0, 0), (9, 0), (0, -9)], [[(1, -1), (3, -1), (1, -2)]]
    )
    assert plate.flipped().flipped() == plate
