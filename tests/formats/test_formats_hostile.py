"""Texts that were made to keep a reader busy: all of them are refused, in linear time."""

from collections.abc import Callable
from pathlib import Path

import pytest
from linear import require_linear

from exactsweep import Polygon
from exactsweep.formats import FormatError, parse_polygon, read_polygon
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
