from fractions import Fraction
from pathlib import Path

import pytest
import strategies
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon
from exactsweep.formats import (
    FormatError,
    format_polygons,
    parse_polygon,
    parse_polygons,
    parse_regions,
)
from exactsweep.formats.polygons import read_choice

fewer = examples(40)
SPACE = 'xmlns="http://www.w3.org/2000/svg"'


def svg(body: str) -> str:
    return f"<svg {SPACE}>{body}</svg>"


@given(strategies.simple_polygons(), st.sampled_from(["M{} Z", "M{0} {1}", "m{}z"]))
@fewer
def test_straight_paths_are_read_exactly(polygon: Polygon, form: str) -> None:
    points = polygon.lattice()[1]
    if form.startswith("m"):
        pairs = zip(points, ((0, 0), *points), strict=False)
        points = tuple((x - px, y - py) for (x, y), (px, py) in pairs)
    spelled = [f"{x}e-1,{y}e-1" for x, y in points]
    path = form.format(" ".join(spelled), spelled[0])
    expected = Polygon([(Fraction(x, 10), Fraction(y, 10)) for x, y in polygon.lattice()[1]])
    assert parse_polygon(svg(f'<path d="{path}"/>')) == expected


@given(strategies.simple_polygons(), strategies.matrices(), strategies.translations())
@fewer
def test_transformations_are_exact(
    polygon: Polygon, matrix: strategies.Matrix, shift: tuple[Fraction, Fraction]
) -> None:
    scaled = Polygon(polygon.lattice()[1])
    move = [round(number, 3) for number in shift]
    (a, c), (b, d) = matrix
    numbers = " ".join(str(float(n)) if abs(n) < 10**6 else str(int(n)) for n in (a, b, c, d))
    e, f = (f"{int(n * 1000)}e-3" for n in move)
    body = format_polygons([scaled], "svg").partition("\n")[2].partition("</svg>")[0]
    image = parse_polygon(svg(f'<g transform="matrix({numbers} {e},{f})">{body}</g>'))
    assert image == strategies.mapped(scaled, matrix).translated(move)


@given(st.text(alphabet="MmLlHhVvZzCcSsQqTtAa0123456789.eE+-, ", max_size=30))
def test_any_path_is_read_or_rejected(data: str) -> None:
    try:
        message = str(parse_polygon(svg(f'<path d="{data}"/>'), tolerance="1"))
    except ValueError as error:
        message = str(error)
    assert message.isprintable()


RULES = ".b {display: none} .a {display: inline} #c {display: none} .d {display: none !important}"


@pytest.mark.parametrize(
    ("attributes", "is_drawn"),
    [
        ("class='a b'", True),
        ("class='b a'", True),
        ("class='b'", False),
        ("class='a' id='c'", False),
        ("class='b' style='display: inline'", True),
        ("class='d' style='display: inline'", False),
        ("style='display: none; display: inline'", True),
        ("style='/* off */ DISPLAY: None'", False),
    ],
)
def test_the_cascade_decides_what_is_hidden(attributes: str, is_drawn: bool) -> None:
    drawing = svg(f"<style>{RULES}</style><rect width='2' height='1' {attributes}/>")
    if is_drawn:
        assert parse_polygon(drawing).area == 2
    else:
        with pytest.raises(FormatError, match="contains no polygon"):
            parse_polygon(drawing)


@pytest.mark.parametrize("style", ["transform-origin: 1px 1px", "transform-box: fill-box"])
@pytest.mark.parametrize("start", ["<style>rect {{{}}}</style><rect", "<rect style='{}'"])
def test_transform_origins_are_rejected(style: str, start: str) -> None:
    shape = f"{start.format(style)} width='2' height='1'"
    assert parse_polygon(svg(f"{shape}/>")).area == 2
    with pytest.raises(FormatError, match="transform-origin is not supported"):
        parse_polygon(svg(f"{shape} transform='rotate(90)'/>"))


def test_other_styles_do_not_move_shapes() -> None:
    style = "text-transform: none; transform-origin: 0px 0px; transform-box: view-box"
    turned = parse_polygon(svg(f"<path d='M0 0H1V1z' style='{style}' transform='rotate(90)'/>"))
    assert turned == Polygon([(0, 0), (0, 1), (-1, 1)])


def test_sizes_in_styles_are_rejected() -> None:
    with pytest.raises(FormatError, match="width in a style"):
        parse_polygon(svg("<rect width='2' height='1' style='width: 5px'/>"))


@pytest.mark.parametrize(
    ("ratio", "side"), [("xMidYMid", 5), ("xMinYMax slice", 10), ("xMaxYMid meet", 5)]
)
def test_the_tighter_side_determines_the_unit(ratio: str, side: int) -> None:
    root = f"<svg width='100mm' height='50mm' viewBox='0 0 100 100' preserveAspectRatio='{ratio}'>"
    square = f"{root}<rect width='10' height='10'/></svg>"
    assert parse_polygon(square, unit="mm").area == side * side
    with pytest.raises(FormatError, match="the horizontal and vertical units differ"):
        parse_polygon(square.replace(ratio, "none"), unit="mm")
    assert parse_polygon(square.replace(ratio, "none")).area == 100


def test_a_shape_has_the_name_of_the_outermost_use_that_draws_it() -> None:
    text = (
        '<svg><defs><polygon id="tile" points="0,0 1,0 0,1"/><g id="pair"><use href="#tile"/>'
        '<use id="inner" href="#tile" x="2"/></g></defs><use id="left" href="#tile" x="9"/>'
        '<use href="#pair" y="5"/><use id="outer" href="#pair" y="9"/></svg>'
    )
    names = ["left", "tile", "inner", "outer", "outer"]
    assert [polygon.name for polygon in parse_polygons(text)] == names


@pytest.mark.parametrize(("choice", "left_out"), [("", 1), ("#tile", 0)])
def test_ornaments_are_reported_unless_the_shape_is_named(
    tmp_path: Path, choice: str, left_out: int
) -> None:
    path = tmp_path / "a.svg"
    path.write_text('<svg><polygon id="tile" points="0,0 1,0 0,1"/><line x2="1"/></svg>')
    found = read_choice(f"{path}{choice}")
    assert [one.name for one in found] == ["tile"]
    assert len(found.left_out) == left_out


BOX, SAME, OPPOSITE = "M0 0H9V9H0Z", "M1 1H3V3H1Z", "M1 1V3H3V1Z"


def read_areas(body: str) -> list[Fraction]:
    return sorted(one.region.area for one in parse_regions(svg(body)))


@pytest.mark.parametrize("inner", [SAME, OPPOSITE])
def test_lines_inside_an_unfilled_outline_are_holes_in_either_direction(inner: str) -> None:
    assert read_areas(f'<path fill="none" stroke="red" d="{BOX}{inner}"/>') == [77]


def test_the_direction_of_lines_determines_filling() -> None:
    assert read_areas(f'<path d="{BOX}{SAME}"/>') == [81]
    assert read_areas(f'<path d="{BOX}{OPPOSITE}"/>') == [77]


def test_unfilled_outlines_that_cross_are_not_merged() -> None:
    drawn = f'<path fill="none" stroke="red" d="{BOX}M5 5H12V12H5ZM6 6H7V7H6Z"/>'
    assert read_areas(drawn) == [1, 49, 81]


@pytest.mark.parametrize(
    ("command", "wanted"),
    [
        ("v", "numbers after v"),
        ("L1", "2 numbers, or a multiple, after L"),
        ("A1 1 0 2 0 3 3", "7 numbers, the flags 0 or 1, or a multiple, after A"),
        ("z5", "no number after z"),
    ],
)
def test_a_command_names_the_numbers_that_it_needs(command: str, wanted: str) -> None:
    found = parse_polygons(svg(f'<path d="M0 0h1v1z"/><path d="M0 0{command}"/>')).left_out
    assert f"path data, character 5: expected {wanted}, found" in found[0]


def test_an_unknown_choice_may_be_a_group() -> None:
    drawing = svg('<g id="tool"><rect width="1" height="1"/></g>')
    with pytest.raises(FormatError, match=r"layer or group 'tol'; did you mean 'tool'\?$"):
        parse_polygon(drawing, "tol")
