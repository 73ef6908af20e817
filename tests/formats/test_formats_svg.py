from fractions import Fraction

import strategies
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon
from exactsweep.formats import format_polygons, parse_polygon

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
def test_any_path_is_read_or_refused(data: str) -> None:
    try:
        message = str(parse_polygon(svg(f'<path d="{data}"/>'), tolerance="1"))
    except ValueError as error:
        message = str(error)
    assert message.isprintable()
