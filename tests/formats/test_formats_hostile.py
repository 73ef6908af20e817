"""Hostile texts are rejected in linear time."""

from collections.abc import Callable
from pathlib import Path

import pytest
from linear import require_linear

from exactsweep import Polygon, limits
from exactsweep.formats import FormatError, parse_polygon, parse_polygons, read_polygon
from exactsweep.formats.candidate import Candidate
from exactsweep.formats.size import ELEMENT, ENTITY, FAULT, VERTEX

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
    "selectors": lambda n: (
        f"<style>.a{',.b' * n}{{{''.join(f'p{k}:1;' for k in range(n))}}}</style>"
    ),
}


def refuse(text: str) -> None:
    with pytest.raises(ValueError, match=r"\w") as caught:
        parse_polygon(text)
    assert len(str(caught.value)) < 200


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS)
def test_long_strings_are_rejected_in_linear_time(text: Callable[[int], str]) -> None:
    require_linear(lambda n: refuse(text(n)))


@pytest.mark.parametrize("body", SHAPES.values(), ids=SHAPES)
@pytest.mark.long
def test_long_shapes_are_rejected_in_linear_time(body: Callable[[int], str]) -> None:
    require_linear(lambda n: refuse(f"<svg>{body(n)}</svg>"))


@pytest.mark.long
def test_equal_rings_are_one_ring_in_linear_time() -> None:
    def read(n: int) -> None:
        text = f'<svg><path d="{"M0 0h1v1z" * (n // 20)}"/></svg>'
        assert parse_polygon(text) == Polygon([(0, 0), (1, 0), (1, 1)])

    require_linear(read)


MANY = 2**24 // VERTEX + 1
MAX_FAULTS = 2**24 // FAULT


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
def test_too_many_vertices_are_rejected_unread(text: Callable[[], str]) -> None:
    with pytest.raises(FormatError, match=r"more than 1,048,576 (drawn )?vertices.*\(max_mib\)"):
        parse_polygon(text())


def test_too_many_entities_are_rejected() -> None:
    few = limits(max_mib=1000 * ENTITY / 2**20)
    with few, pytest.raises(FormatError, match=r"^more than 1,000 entities \(max_mib\)$"):
        parse_polygon("0\nSECTION\n2\nENTITIES\n" + "0\nLINE\n" * 2000)


@pytest.mark.parametrize("form", ["svg", "dxf"])
def test_repeated_elements_are_charged_again(form: str) -> None:
    """140 kB could draw 40 million vertices."""
    teeth = [(k, k % 2) for k in range(200)] + [(0, 300)]
    if form == "svg":
        points = " ".join(f"{x},{y}" for x, y in teeth)
        uses = '<use href="#a"/>' * 200
        text = f'<svg><polygon id="a" points="{points}"/>{uses}</svg>'
        refusal = r"^more than [\d,]+ drawn vertices \(max_mib\)$"
    else:
        points = "".join(f"10\n{x}\n20\n{y}\n" for x, y in teeth)
        block = f"0\nBLOCK\n2\nA\n10\n0\n20\n0\n0\nLWPOLYLINE\n70\n1\n{points}0\nENDBLK\n"
        inserts = "0\nINSERT\n2\nA\n10\n0\n20\n0\n" * 200
        text = (
            f"0\nSECTION\n2\nBLOCKS\n{block}0\nENDSEC\n"
            f"0\nSECTION\n2\nENTITIES\n{inserts}0\nENDSEC\n0\nEOF\n"
        )
        refusal = r"^blocks expand to more than 0.\d+ MiB \(max_mib\)$"
    assert len(parse_polygons(text)) in (200, 201)
    with limits(max_mib=3 * len(text) / 2**20), pytest.raises(FormatError, match=refusal):
        parse_polygons(text)


def test_reading_stops_at_the_limit_of_vertices() -> None:
    """The limit applies to one path or several; a path may reach it with its last command."""
    most = 1000 * VERTEX / 2**20
    with limits(max_mib=most):
        assert len(parse_polygon(f'<svg><path d="M0 0{"h1" * 997}V9z"/></svg>').vertices) == 3
    arc = "a9 9 0 0 1 9 9"
    assert len(parse_polygon(f'<svg><path d="M0 0{arc}V-9z"/></svg>', tolerance="1/1000")) > 30
    for data in (["h1" * 998], ["h1" * 5000], ["h1" * 900, "h1" * 900], ["h1" * 997 + arc]):
        paths = "".join(f'<path d="M0 0{some}V9z"/>' for some in data)
        refusal = r"^more than 1,000 drawn vertices \(max_mib\)$"
        with limits(max_mib=most), pytest.raises(FormatError, match=refusal):
            parse_polygons(f"<svg>{paths}</svg>", tolerance="1/1000")


def test_long_binary_files_are_rejected_in_linear_time(tmp_path: Path) -> None:
    path = tmp_path / "file"

    def read(n: int) -> None:
        path.write_bytes(b"\n" * n + b"\xff")
        with pytest.raises(FormatError, match="not UTF-8 text: "):
            read_polygon(str(path))

    require_linear(read)


def nest_geojson(depth: int) -> str:
    corner = '{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [0, 1], [0, 0]]]}'
    return '{"type": "GeometryCollection", "geometries": [' * depth + corner + "]}" * depth


def test_collections_are_read_to_a_depth_of_100() -> None:
    assert parse_polygon(nest_geojson(100)) == Polygon([(0, 0), (1, 0), (0, 1)])
    with pytest.raises(FormatError, match="nested too deeply"):
        parse_polygon(nest_geojson(101))


@pytest.mark.parametrize("depth", [100, 101])
def test_svg_elements_are_read_to_a_depth_of_100(depth: int) -> None:
    groups = depth - 2
    text = f'<svg>{"<g>" * groups}<polygon points="0,0 1,0 0,1"/>{"</g>" * groups}</svg>'
    if depth == 100:
        assert parse_polygon(text) == Polygon([(0, 0), (1, 0), (0, 1)])
    else:
        with pytest.raises(FormatError, match="line 1: nested deeper than 100 elements"):
            parse_polygon(text)


def test_uses_in_deep_groups_are_rejected() -> None:
    groups = (
        f'<g id="g{k}">{"<g>" * 90}<use href="#g{k + 1}"/>{"</g>" * 90}</g>' for k in range(30)
    )
    with pytest.raises(FormatError, match="nested too deeply"):
        parse_polygons(f'<svg><defs>{"".join(groups)}</defs><use href="#g0"/></svg>')


def test_nested_transformations_are_bounded() -> None:
    group = f'<g transform="scale({"7" * 4000})">'
    text = f"<svg>{group * 90}<rect width='1' height='1'/>{'</g>' * 90}</svg>"
    with pytest.raises(
        FormatError, match=r"^line 1: g: the numbers in the product of the transform"
    ):
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
def test_the_number_of_rejected_elements_is_bounded(
    text: Callable[[int], str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Exceptions that keep their frames took 2.8 GB for 2 MiB of GeoJSON."""
    made = 0
    make = Candidate.from_error

    def count(*words: str | None, ornament: bool = False) -> Candidate:
        nonlocal made
        made += 1
        return make(*words, ornament=ornament)  # type: ignore[arg-type]

    monkeypatch.setattr(Candidate, "from_error", count)
    with pytest.raises(FormatError, match=f"more than {MAX_FAULTS:,} "):
        parse_polygon(text(3 * MAX_FAULTS))
    assert made == MAX_FAULTS + 1


def test_errors_are_kept_as_text() -> None:
    text = f"[{'[[1]],' * 500}[[1]]]"
    with pytest.raises(FormatError, match=r"; and 497 more$") as caught:
        parse_polygons(text)
    assert caught.value.__context__ is None


def test_too_many_numbers_elements_or_names_are_rejected() -> None:
    with pytest.raises(FormatError, match=r"^more than 4,194,304 numbers \(max_mib\)$"):
        parse_polygon(f"[{'1,' * (4 * MANY)}1]")
    few = limits(max_mib=20 * ELEMENT / 2**20)
    with few, pytest.raises(FormatError, match=r"^more than 20 elements \(max_mib\)$"):
        parse_polygon(f"<svg>{'<a/>' * 20}</svg>")
    few = limits(max_mib=9 * 3 * VERTEX / 2**20)
    with few, pytest.raises(FormatError, match=r"^more than 9 polygons \(max_mib\)$"):
        parse_polygon("name,x,y\n" + "".join(f"{k},0,0\n" for k in range(20)))


def test_unused_columns_cost_nothing() -> None:
    """Looking up all column names in each row would take quadratic time."""

    def read(n: int) -> None:
        head = ",".join(f"c{k}" for k in range(n))
        refuse(f"x,y,{head}\n" + "1,2\n" * n)

    require_linear(read, size=2000)
