"""Texts that were made to keep a reader busy: all of them are refused, in linear time."""

from collections.abc import Callable
from pathlib import Path

import pytest
from linear import require_linear

from exactsweep import Polygon
from exactsweep.formats import FormatError, parse_polygon, parse_polygons, read_polygon
from exactsweep.formats.candidate import MAX_FAULTS, Candidate
from exactsweep.formats.reading import MAX_VERTICES

TEXTS: dict[str, Callable[[int], str]] = {
    "wkt word": lambda n: "P" * n,
    "wkt integer": lambda n: f"POLYGON (({'1' * n}x 0))",
    "wkt decimal": lambda n: f"POLYGON ((1.{'1' * n}x 0))",
    "wkt digits": lambda n: f"POLYGON (({'1' * n} 0))",
    "wkt brackets": lambda n: f"POLYGON (({'(' * n}",
    "json digits": lambda n: f"[[{'1' * n}, 0]]",
    "json string": lambda n: f'[["1{"1" * n}x", 0]]',
    "json brackets": lambda n: "[" * n,
    "dxf blank lines": lambda n: "0" + "\n" * n,
    "dxf blank comment": lambda n: "999" + "\n" * n,
    "dxf comments": lambda n: "999\n\n" * n,
    "xml literal": lambda n: f'<!DOCTYPE svg SYSTEM "{"<!--&" * n}"><svg/>',
    "xml comments": lambda n: f"<svg>{'<!-- & -->' * n}</svg>",
}
SHAPES: dict[str, Callable[[int], str]] = {
    "path edges": lambda n: f'<path d="M0 0{"L1 1" * (n // 20)}"/>',
    "subpaths": lambda n: f'<path fill-rule="evenodd" d="{"M0 0h1v1z" * (n // 20)}"/>',
    "path digits": lambda n: f'<path d="M{"1" * n}x"/>',
    "path gaps": lambda n: f'<path d="{" ," * n}x"/>',
    "points": lambda n: f'<polygon points="{"1" * n}x"/>',
    "functions": lambda n: f'<path transform="{"scale(1e4000)" * n}"/>',
    "open functions": lambda n: f'<path transform="{"scale(" * n}"/>',
    "letters": lambda n: f'<path transform="{"a" * n}"/>',
    "blanks": lambda n: f'<path transform="{" " * n}x"/>',
    "elements": lambda n: "<path>" * n,
}


def refuse(text: str) -> None:
    with pytest.raises(ValueError, match=r"\w") as caught:
        parse_polygon(text)
    assert len(str(caught.value)) < 200


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_long_texts_are_refused_in_linear_time(text: Callable[[int], str]) -> None:
    require_linear(lambda n: refuse(text(n)))


@pytest.mark.parametrize("body", SHAPES.values(), ids=SHAPES)
def test_long_shapes_are_refused_in_linear_time(body: Callable[[int], str]) -> None:
    require_linear(lambda n: refuse(f"<svg>{body(n)}</svg>"))


def test_equal_rings_are_one_ring_in_linear_time() -> None:
    def read(n: int) -> None:
        text = f'<svg><path d="{"M0 0h1v1z" * (n // 20)}"/></svg>'
        assert parse_polygon(text) == Polygon([(0, 0), (1, 0), (1, 1)])

    require_linear(read)


MANY = MAX_VERTICES + 1


@pytest.mark.parametrize(
    "text",
    [
        lambda: "POLYGON ((" + "0 0," * MANY + "0 0))",
        lambda: "[" + "[0,0]," * MANY + "[0,0]]",
        lambda: '[{"x":0,"y":0}' + ',{"x":0,"y":0}' * MANY + "]",
        lambda: "0,0\n" * (MANY + 1),
        lambda: f'<svg><polygon points="{"0 0 " * MANY}"/></svg>',
    ],
    ids=["wkt", "json", "objects", "csv", "points"],
)
def test_more_vertices_than_memory_is_for_are_refused_unread(text: Callable[[], str]) -> None:
    with pytest.raises(FormatError, match=r"more than [14],000,000 (vertices|characters)"):
        parse_polygon(text())


def test_entities_beyond_counting_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("exactsweep.formats.curved.dxf_entity.MAX_ENTITIES", 1000)
    with pytest.raises(FormatError, match=r"^more than 1,000 entities$"):
        parse_polygon("0\nSECTION\n2\nENTITIES\n" + "0\nLINE\n" * 2000)


def test_a_path_stops_at_the_vertex_that_is_too_many(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("exactsweep.formats.curved.svg_path.MAX_VERTICES", 1000)
    data = "M0 0" + "h1" * 5000
    with pytest.raises(FormatError, match=r"path data, character 2003: more than 1,000 vertices"):
        parse_polygon(f'<svg><path d="{data}"/></svg>')


def test_long_files_that_are_no_text_are_refused_in_linear_time(tmp_path: Path) -> None:
    path = tmp_path / "file"

    def read(n: int) -> None:
        path.write_bytes(b"\n" * n + b"\xff")
        with pytest.raises(FormatError, match="not UTF-8 text: "):
            read_polygon(str(path))

    require_linear(read)


def test_nested_transformations_do_not_grow_without_end() -> None:
    group = f'<g transform="scale({"7" * 4000})">'
    text = f"<svg>{group * 90}<rect width='1' height='1'/>{'</g>' * 90}</svg>"
    with pytest.raises(FormatError, match=r"^line 1: g: the numbers of the product of transform"):
        parse_polygon(text)


FAULTS: dict[str, Callable[[int], str]] = {
    "json numbers": lambda n: f'{{"polygons": [{"1," * n}1]}}',
    "json objects": lambda n: '{"polygons": [' + '{"vertices": 1},' * n + "1]}",
    "json lines": lambda n: '{"vertices": 1}\n' * n,
    "features": lambda n: f'{{"type": "FeatureCollection", "features": [{"1," * n}1]}}',
    "polygons": lambda n: f'{{"type": "MultiPolygon", "coordinates": [{"1," * n}1]}}',
    "wkt": lambda n: "POLYGON EMPTY " * n,
    "svg": lambda n: f"<svg>{'<path/>' * n}</svg>",
}


@pytest.mark.parametrize("text", FAULTS.values(), ids=FAULTS)
def test_of_what_is_no_polygon_a_bounded_number_is_kept(
    text: Callable[[int], str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Once 2 MiB of GeoJSON took 2.8 GB: each refusal held on to all that it came from."""
    made = 0
    refused = Candidate.refused

    def count(reason: str, name: str | None = None, layer: str | None = None) -> Candidate:
        nonlocal made
        made += 1
        return refused(reason, name, layer)

    monkeypatch.setattr(Candidate, "refused", count)
    with pytest.raises(FormatError, match=f"more than {MAX_FAULTS:,} "):
        parse_polygon(text(3 * MAX_FAULTS))
    assert made == MAX_FAULTS + 1


def test_refusals_are_kept_as_words() -> None:
    text = f"[{'[[1]],' * 500}[[1]]]"
    with pytest.raises(FormatError, match=r"; and 497 more$") as caught:
        parse_polygons(text)
    assert caught.value.__context__ is None


def test_numbers_elements_and_names_beyond_counting_are_refused(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with pytest.raises(FormatError, match=r"^more than 4,000,000 numbers$"):
        parse_polygon(f"[{'1,' * (4 * MAX_VERTICES + 1)}1]")
    monkeypatch.setattr("exactsweep.formats.curved.xml.MAX_ELEMENTS", 9)
    with pytest.raises(FormatError, match=r"^line 1: more than 9 elements$"):
        parse_polygon(f"<svg>{'<a/>' * 9}</svg>")
    monkeypatch.setattr("exactsweep.formats.csv.MAX_POLYGONS", 9)
    with pytest.raises(FormatError, match=r"^more than 9 polygons$"):
        parse_polygon("name,x,y\n" + "".join(f"{k},0,0\n" for k in range(99)))


def test_columns_that_are_not_asked_for_cost_nothing_in_each_row() -> None:
    """Once each row went through all names of columns."""

    def read(n: int) -> None:
        head = ",".join(f"c{k}" for k in range(n))
        refuse(f"x,y,{head}\n" + "1,2\n" * n)

    require_linear(read, size=2000)
