import re
from fractions import Fraction
from math import radians, tan

import pytest
import strategies
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon
from exactsweep.formats import FormatError, format_polygons, parse_polygon, parse_polygons

fewer = examples(40)
SQUARE = Polygon([(0, 0), (2, 0), (2, 2), (0, 2)])
SPACE = 'xmlns="http://www.w3.org/2000/svg"'


def svg(body: str) -> str:
    return f"<svg {SPACE}>{body}</svg>"


@pytest.mark.parametrize(
    "body",
    [
        '<polygon points="0,0 2,0 2,2 0,2"/>',
        '<polygon points="0 0,2 0 2 2-0,2"/>',
        '<polyline points="0,0 2,0 2,2 0,2 0,0"/>',
        '<rect width="2" height="2"/>',
        '<rect x="0" y="0" width="2" height="2" rx="0"/>',
        '<path d="M0 0L2 0L2 2L0 2Z"/>',
        '<path d="M 0,0 2,0 2,2 0,2 0,0"/>',
        '<path d="m0 0h2v2h-2z"/>',
        '<path d="M0,0H2V2H0V0"/>',
        '<path d="m 0 0 l 2 0 0 2 -2 0 z"/>',
        '<path d="M0 0h.5.5 1v2e0L0+2z"/>',
        '<path d="\n M 0\t0 L 2,0\r\n2 2 0 2 z \n"/>',
        '<g transform="translate(1 1)"><path d="M-1-1h2v2h-2z"/></g>',
        '<g transform="scale(2)"><rect width="1" height="1"/></g>',
        '<g transform="rotate(90 1 1)"><a transform="scale(2,.5)"><path d="M0 0h1v4H0z"/></a></g>',
        '<rect width="1" height="4" transform="matrix(2 0 0 .5 0 0)"/>',
        '<rect x="-2" width="2" height="2" transform="rotate(-90)"/>',
        '<rect width="2" height="2" transform="skewX(45) skewX(-45)skewY(0)"/>',
        "<defs><circle r='1'/></defs><title>t</title><text>x</text><rect width='2' height='2'/>",
        "<g display='none'><circle/></g><path style='display: none'/><rect width='2' height='2'/>",
        "<!-- a comment --><?php 1?><rect width='2' height='2'/>",
    ],
)
def test_spelling_does_not_matter(body: str) -> None:
    assert parse_polygon(svg(body)) == SQUARE
    assert parse_polygon(f"<?xml version='1.0'?>\n<svg>{body}</svg>") == SQUARE


def test_a_document_type_is_not_fetched() -> None:
    doctype = '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://127.0.0.1:9/svg11.dtd">'
    assert parse_polygon(doctype + svg('<rect width="2" height="2"/>')) == SQUARE


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


def test_shapes_are_chosen_by_id_or_index() -> None:
    text = svg(
        '<rect id="a" width="1" height="1"/><g><rect id="1" width="2" height="2"/></g>'
        '<rect width="3" height="3"/><rect id="a b" width="4" height="4"/>'
    )
    names = [part.name for part in parse_polygons(text)]
    assert names == ["a", "1", None, "a b"]
    widths = [parse_polygon(text, choice).area for choice in ("a", "0", "1", "2", "a b", "3")]
    assert widths == [1, 1, 4, 9, 16, 16]
    with pytest.raises(FormatError, match="holds 4 polygons; choose one by name, index or layer"):
        parse_polygon(text)
    with pytest.raises(FormatError, match="no polygon has the name, index or layer 'a c'; did you"):
        parse_polygon(text, "a c")


@pytest.mark.parametrize("doctype", ['svg SYSTEM "x.dtd"', "svg [%x;]"])
def test_what_a_document_type_elsewhere_may_declare_is_refused(doctype: str) -> None:
    text = f"<!DOCTYPE {doctype}>\n<!-- &a; --><svg><polygon points='0 0 1 0 &b;'/></svg>"
    with pytest.raises(FormatError, match=r"^line 2: the entity 'b' is not declared here$"):
        parse_polygon(text)
    assert parse_polygon(text.replace("&b;", "&#48; 1")).area == Fraction(1, 2)


def test_a_bad_shape_concerns_no_other() -> None:
    text = svg('<rect id="a" width="1" height="1"/>\n<path id="b" d="M0 0"/>\n<use id="c"/>')
    assert parse_polygon(text, "a").area == 1
    with pytest.raises(ValueError, match=r"^line 2: path 'b': fewer than three vertices"):
        parse_polygon(text, "b")
    with pytest.raises(FormatError, match=r"^line 3: use 'c': draws nothing that is in the file"):
        parse_polygon(text, "c")


REFUSED = {
    "<circle r='1'/>": "line 1: circle: a curve, which is read only with a tolerance",
    "<ellipse rx='1' ry='2'/>": "line 1: ellipse: a curve, which is read only with a tolerance",
    "<rect width='9' height='9' rx='1'/>": "line 1: rect: a curve, which is read only with",
    "<rect width='9em' height='9'/>": "line 1: rect: width: '9em' is not a decimal number",
    "<rect height='9'/>": "line 1: rect: width is missing",
    "<rect height='9' width='-1'/>": "line 1: rect: width is negative",
    "<circle r='-1'/>": "line 1: circle: r is negative",
    "<use href='#a'/>": "line 1: use: draws nothing that is in the file",
    "<g id='a'><use href='#a'/></g>": "line 1: use: draws nothing that is in the file, or itself",
    "<use href='other.svg#a'/>": "line 1: use: draws nothing that is in the file",
    "<line id='x'/>": "line 1: line 'x': fewer than three distinct vertices",
    "<polyline points='0 0 1 1 2 0'/>": "line 1: polyline: the end (0,0) meets no other end",
    "<polygon points='0 0 1'/>": "line 1: polygon: points: an odd number of coordinates",
    "<polygon points='0 0 1 x'/>": "line 1: polygon: '0 0 1 x' is not a list of decimal numbers",
    "<polygon/>": "line 1: polygon: points: none",
    "<path/>": "line 1: path: path data, character 1: the path is empty",
    "<path d='L1 1'/>": "line 1: path: path data, character 1: the path does not begin with M",
    "<path d='1 1'/>": "line 1: path: path data, character 1: '1 1' instead of a command",
    "<path d='M0 0 1'/>": "line 1: path: path data, character 7: the end instead of a number",
    "<path d='M0 0B'/>": "line 1: path: path data, character 5: 'B' is no command",
    "<path d='M0 0 Z 3'/>": "line 1: path: path data, character 8: '3' instead of a command",
    "<path d='M0 0L1 0 1 1'/>": "line 1: path: the end (0,0) meets no other end exactly (--join",
    "<path d='M0 0h1v1zM5 5h1v1z'/>": "holds 2 polygons; choose one by name",
    "<path d='M0 0h1v1M5 5h1v1z'/>": (
        "holds 1 polygon; choose one by name, index or layer, as in FILE#0: #0; and 1 other thing, "
        "line 1: path: the end (0,0) meets no other end"
    ),
    "<path d='M0 0h1v1z 7'/>": "line 1: path: path data, character 11: '7' instead of a command",
    "<path d='M0 0C1 1 2 2 3 3z'/>": "line 1: path: path data, character 5: a curve, which is",
    "<path d='M0 0A1 1 0 2 0 3 3z'/>": "line 1: path: path data, character 12: '2 0 3 3z' instead",
    "<path d='M0 0L1e9999 0z'/>": (
        "line 1: path: path data, character 6: '1e9999' has more than 4300 digits"
    ),
    "<g transform='rotate(30)'><path/></g>": "line 1: g: an angle of 30 degrees, which is",
    "<g transform='skewX(90)'><path/></g>": "line 1: g: a skew by 90 degrees",
    "<path transform='warp(1)'/>": "line 1: path: 'warp' is not a transformation",
    "<path transform='scale()'/>": "line 1: path: scale with 0 numbers",
    "<path transform='scale(1'/>": "line 1: path: 'scale(1' is not a transformation",
    "<path transform='scale(x)'/>": "line 1: path: 'x' is not a list of decimal numbers",
    "<path style='transform:none'/>": "line 1: path: a transformation in a style cannot be read",
    "<svg viewBox='0 0 9 9'><path d='M0 0'/></svg>": "line 1: svg: width: a percentage of what",
    "<svg viewBox='0 0 9'><path d='M0 0'/></svg>": "line 1: svg: viewBox: not a corner and two",
    "<path": "line 1, column 46: not XML: not well-formed (invalid token)",
    "</g>": "line 1, column 43: not XML: mismatched tag",
    "<text/>": "holds no polygon",
    "<g>" * 100: "line 1: nested deeper than 100 elements",
}


@pytest.mark.parametrize(("body", "message"), REFUSED.items(), ids=range(len(REFUSED)))
def test_refusals_name_place_and_reason(body: str, message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}") as caught:
        parse_polygon(svg(body))
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 200


def test_another_root_is_refused() -> None:
    with pytest.raises(FormatError, match=r"^line 2: the root is 'html', not svg"):
        parse_polygon("<!-- x -->\n<html/>")


LAUGHS = "".join(
    f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in zip("abcdefghi", "bcdefghij", strict=True)
)


@pytest.mark.parametrize(
    "text",
    [
        f'<!DOCTYPE svg [<!ENTITY a "aaaaaaaaaa">{LAUGHS}]><svg>&j;</svg>',
        '<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd">]><svg>&x;</svg>',
        '<!DOCTYPE svg [<!ENTITY % x SYSTEM "http://127.0.0.1:9/x.dtd">%x;]><svg/>',
    ],
)
def test_entities_are_refused(text: str) -> None:
    with pytest.raises(FormatError, match=r"^declares the entity '[bx]', which is not expanded$"):
        parse_polygon(text)


@given(st.text(alphabet="MmLlHhVvZzCcSsQqTtAa0123456789.eE+-, ", max_size=30))
def test_any_path_is_read_or_refused(data: str) -> None:
    try:
        message = str(parse_polygon(svg(f'<path d="{data}"/>'), tolerance="1"))
    except ValueError as error:
        message = str(error)
    assert message.isprintable()


def test_a_view_box_of_one_unit_is_one() -> None:
    inner = '<svg viewBox="0 0 1 1" width="2" height="2"><path d="M0 0h1v1z"/></svg>'
    assert parse_polygon(f"<svg>{inner}</svg>") == Polygon([(0, 0), (2, 0), (2, 2)])


@pytest.mark.parametrize(
    ("fit", "scales", "moved"),
    [
        ("", (2, 2), (1, 0)),
        ('preserveAspectRatio="none"', (4, 2), (0, 0)),
        ('preserveAspectRatio="xMinYMin"', (2, 2), (0, 0)),
        ('preserveAspectRatio=" xMidYMax meet"', (2, 2), (1, 0)),
        ('preserveAspectRatio="xMaxYMin meet"', (2, 2), (2, 0)),
        ('preserveAspectRatio="xMaxYMin slice"', (4, 4), (0, 0)),
        ('preserveAspectRatio="xMinYMid slice"', (4, 4), (0, -1)),
        ('preserveAspectRatio="xMidYMax slice"', (4, 4), (0, -2)),
    ],
)
def test_a_view_is_fitted_into_its_box(
    fit: str, scales: tuple[int, int], moved: tuple[int, int]
) -> None:
    """A unit square becomes a box of 4 by 2."""
    inner = f'<svg viewBox="3 5 1 1" width="4" height="2" {fit}><path d="M3 5h1v1z"/></svg>'
    (x, y), (dx, dy) = scales, moved
    expected = Polygon([(dx, dy), (dx + x, dy), (dx + x, dy + y)])
    assert parse_polygon(f"<svg>{inner}</svg>") == expected


@pytest.mark.parametrize("fit", ["yMidXMid", "xMidYmid", "xMidMid", "slice", "xMidYMidd"])
def test_a_view_is_fitted_in_no_other_way(fit: str) -> None:
    inner = f'<svg viewBox="0 0 1 1" width="4" height="2" preserveAspectRatio="{fit}">'
    with pytest.raises(FormatError, match=f"preserveAspectRatio is '{fit}'$"):
        parse_polygon(f'<svg>{inner}<path d="M0 0h1v1z"/></svg></svg>')


@pytest.mark.parametrize("degrees", [30, -60, 89, "100.5"])
def test_a_skew_moves_by_the_tangent(degrees: object) -> None:
    shape = f'<path transform="{{}}({degrees})" d="M0 0H3V2Z"/>'
    along = parse_polygon(svg(shape.format("skewX")), tolerance="1e-3")
    tangent = tan(radians(float(str(degrees))))
    for x, y in [(0.0, 0), (3.0, 0), (3 + 2 * tangent, 2)]:
        assert min(abs(p.x - x) + abs(p.y - y) for p in along.vertices) < 1e-3
    across = parse_polygon(svg(shape.format("skewY")), tolerance="1e-3")
    for x, v in [(0, 0.0), (3, 3 * tangent), (3, 3 * tangent + 2)]:
        assert min(abs(p.x - x) + abs(p.y - v) for p in across.vertices) < 1e-3


@pytest.mark.parametrize("degrees", ["89.99999", "-90.00001"])
def test_a_skew_by_nearly_a_quarter_is_refused(degrees: str) -> None:
    shape = f'<path transform="skewX({degrees})" d="M0 0H3V2Z"/>'
    with pytest.raises(FormatError, match="a skew by"):
        parse_polygon(svg(shape), tolerance="1e-3")
