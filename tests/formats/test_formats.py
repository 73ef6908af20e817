import json
import re
from fractions import Fraction
from pathlib import Path

import pytest
import strategies
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon, limits, sweep
from exactsweep.cli.pair import DIRECTRIX, GENERATRIX
from exactsweep.formats import (
    FormatError,
    parse_polygon,
    read_polygon,
)
from exactsweep.formats.json_polygons import read_geojson
from exactsweep.text.results import sweep_to_json

POLYGONS = Path(__file__).parents[1] / "support" / "polygons"


@pytest.mark.parametrize(
    ("name", "polygon"),
    [("house.json", GENERATRIX), ("notch.wkt", DIRECTRIX), ("notch.geojson", DIRECTRIX)],
)
def test_the_example_files_match_the_built_in_example(name: str, polygon: Polygon) -> None:
    assert read_polygon(str(POLYGONS / name)) == polygon


def scientific(value: Fraction) -> str:
    """Write a finite decimal as an integer with an exponent."""
    places = 0
    while (value * 10**places).denominator != 1:
        places += 1
    return f"{int(value * 10**places)}e-{places}"


@given(strategies.simple_polygons(), st.integers(-40, 40), st.sampled_from([1, 2, 125, 1024]))
def test_wkt_is_read_exactly(polygon: Polygon, exponent: int, divisor: int) -> None:
    factor = Fraction(10) ** exponent / divisor
    ring = [(factor * x, factor * y) for x, y in polygon.lattice()[1]]
    written = ", ".join(f"{scientific(x)} {scientific(y)}" for x, y in [*ring, ring[0]])
    assert parse_polygon(f"POLYGON (({written}))") == Polygon(ring)


@given(strategies.pairs("CM"), strategies.translations())
@examples(50)
def test_json_of_a_sweep_is_complete(
    pair: tuple[Polygon, Polygon], reference: tuple[Fraction, Fraction]
) -> None:
    result = sweep(*pair, reference=reference)
    document = json.loads(sweep_to_json(result))
    for name in ("generatrix", "directrix", "trajectory", "inner", "outer"):
        # The polygons are canonical in the file, too.
        assert Polygon(document.pop(name)).vertices == getattr(result, name).vertices
    assert document == {
        "kind": result.kind,
        "direction": [*result.solution.frame.direction],
        "reference": [str(coordinate) for coordinate in reference],
        "area": str(result.area),
    }


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[" * 100_000, "nested too deeply"),
        ('{"a":' * 100_000, "nested too deeply"),
        ("[" * 100_000 + "]" * 100_000, "nested too deeply"),
        (
            f"[[0, 0], [{'7' * 137_608}, 0], [0, 1]]",
            f"$[1][0]: '{'7' * 36}... has more than 137607 digits (max_digits)",
        ),
        ("x,y\n" + "1" * 200_000 + ",2\n", "line 2: '1111"),
    ],
    ids=["lists", "objects", "closed lists", "digits", "a cell"],
)
def test_long_strings_are_rejected_by_name(text: str, message: str) -> None:
    with pytest.raises(FormatError, match=f"^{re.escape(message)}"):
        parse_polygon(text)


@given(st.text(alphabet="[]{}(),:\"'POLYGNtypevrics0123456789.eE+-/ \n\x00é", max_size=30))
def test_any_text_is_read_or_rejected(text: str) -> None:
    try:
        message = str(parse_polygon(text))
    except ValueError as error:
        message = str(error)
    assert message.isprintable()


def test_limits_apply_to_files(tmp_path: Path) -> None:
    (tmp_path / "long.json").write_text("[[0, 0], [1e5000, 0], [0, 1]]")
    with limits(max_digits=5001):
        assert read_polygon(str(tmp_path / "long.json")).area == Fraction(10**5000, 2)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "empty"),
        (b"[[0, 0], [1, \xff]]", "not UTF-8 text: invalid start byte at byte 13"),
        ("[[0, 0], [1, 0]]".encode("utf-16"), "UTF-16 text; save it as UTF-8"),
        (b" " * (2**24 + 1), "more than 16 MiB (max_mib)"),
        (b"\x89PNG\r\n", "not UTF-8 text: invalid start byte at byte 0"),
        (b"\x1f\x8b\x08\x00", "a gzip file; decompress it first"),
    ],
    ids=["empty", "latin", "utf-16", "enormous", "png", "svgz"],
)
def test_rejected_files_are_named(tmp_path: Path, content: bytes, message: str) -> None:
    path = tmp_path / "bad file.json"
    path.write_bytes(content)
    with pytest.raises(FormatError, match=f"^{re.escape(f'{path}: {message}')}$"):
        read_polygon(str(path))


def test_a_byte_order_mark_is_ignored(tmp_path: Path) -> None:
    path = tmp_path / "marked.json"
    path.write_text("[[0, 0], [1, 0], [0, 1]]", encoding="utf-8-sig")
    assert read_polygon(str(path)) == Polygon([(0, 0), (1, 0), (0, 1)])


def test_geojson_is_read_without_notes() -> None:
    ring = [[x, y, "9"] for x, y in ("00", "10", "01", "00")]
    (found,) = read_geojson({"type": "Polygon", "coordinates": [ring]})
    assert found.shape() == Polygon([(0, 0), (1, 0), (0, 1)])
