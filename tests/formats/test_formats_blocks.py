"""Blocks, uses, splines and joined ends: placement and limits."""

from fractions import Fraction
from math import cos, radians, sin

import pytest
import strategies
from hypothesis import given
from hypothesis import strategies as st
from linear import require_linear
from test_formats_curves import distance
from test_formats_dxf import Tags, dxf, polyline
from tiers import examples

from exactsweep import Polygon, limits
from exactsweep.formats import FormatError, parse_polygon, parse_polygons
from exactsweep.formats.candidate import Candidate
from exactsweep.formats.curved.affine import IDENTITY
from exactsweep.formats.curved.join import OpenLine, join
from exactsweep.formats.curved.spline import Spline
from exactsweep.formats.reading import Reading
from exactsweep.numbers.number import Point

fewer = examples(30)
small = st.fractions(-9, 9, max_denominator=10)
points = st.builds(Point, small, small)


def with_blocks(blocks: dict[str, Tags], *inserts: Tags) -> str:
    tags: Tags = [(0, "SECTION"), (2, "BLOCKS")]
    for name, entities in blocks.items():
        tags += [(0, "BLOCK"), (2, name), (10, 1), (20, 2), *entities, (0, "ENDBLK")]
    tags.append((0, "ENDSEC"))
    head = "".join(f"{code:>3}\n{value}\n" for code, value in tags)
    return head + dxf(*inserts)


def insert(name: str, *more: tuple[int, object]) -> Tags:
    return [(0, "INSERT"), (2, name), (10, 10), (20, 20), *more]


TRIANGLE = polyline((1, 2), (4, 2), (1, 4))


@fewer
@given(st.fractions(-360, 360, max_denominator=100), points)
def test_rotated_blocks_stay_within_the_tolerance(degrees: Fraction, third: Point) -> None:
    tolerance = Fraction(1, 1000)
    corners = [(1, 2), (4, 2), (str(float(third.x)), str(float(third.y) + 20))]
    angle = f"{float(degrees):.6f}"
    text = with_blocks({"a": polyline(*corners)}, insert("a", (50, angle)))
    found = parse_polygon(text, tolerance=tolerance)
    turn = radians(float(angle))
    for x, y in corners:
        u, v = float(str(x)) - 1, float(str(y)) - 2
        true = (10 + u * cos(turn) - v * sin(turn), 20 + u * sin(turn) + v * cos(turn))
        near = min(abs(p.x - true[0]) + abs(p.y - true[1]) for p in found.vertices)
        assert near < tolerance


BOMB = {f"b{k}": [*insert(f"b{k + 1}"), *insert(f"b{k + 1}")] for k in range(40)}


@pytest.mark.long
def test_recursive_blocks_are_rejected() -> None:
    with pytest.raises(FormatError, match="blocks expand to more than 20,000 entities"):
        parse_polygon(with_blocks({**BOMB, "b20": TRIANGLE}, insert("b0")))


def test_recursive_uses_are_rejected(monkeypatch: pytest.MonkeyPatch) -> None:
    uses = [f'<use href="#g{k + 1}"/>' * 10 for k in range(9)]
    bomb = "".join(f'<g id="g{k}">{drawn}</g>' for k, drawn in enumerate(uses))
    with limits(max_mib=1), pytest.raises(FormatError, match=r"655 .* the first: line 1: use"):
        parse_polygon(f"<svg>{bomb}</svg>")
    monkeypatch.setattr("exactsweep.formats.reading.MAX_COPIES", 2000)
    with pytest.raises(FormatError, match="uses expand to more than 2,000 elements"):
        parse_polygon(f'<svg>{bomb}<rect id="g9" width="1" height="1"/></svg>')


@fewer
@given(strategies.simple_polygons(), st.randoms(use_true_random=False))
def test_joined_ends_move_within_the_distance(polygon: Polygon, random: object) -> None:
    step = Fraction(1, 10**9)
    ring = [Point(Fraction(x), Fraction(y)) for x, y in polygon.lattice()[1]]

    def off(point: Point) -> Point:
        by = [step * random.randint(-3, 3) for _ in "xy"]  # type: ignore[attr-defined]
        return Point(point.x + by[0], point.y + by[1])

    lines = []
    for k, (a, b) in enumerate(zip(ring, [*ring[1:], ring[0]], strict=True)):
        ends = off(a), off(b)
        lines.append(OpenLine(Candidate(str(k), list), ends))
    random.shuffle(lines)  # type: ignore[attr-defined]
    reach = 9 * step
    ((_, candidate),) = join(dict(enumerate(lines)), Reading(join=reach))
    *found, last = candidate.vertices()
    assert last == found[0]
    assert len(found) == len(ring)
    for point in ring:
        assert min((p.x - point.x) ** 2 + (p.y - point.y) ** 2 for p in found) <= (2 * reach) ** 2


@pytest.mark.parametrize(
    "ends",
    [
        lambda k: (0, 0, 1, 0),
        lambda k: (0, 0, k + 1, 1),
        lambda k: (k, 0, k + 1, 0),
        lambda k: (k % 2, 0, k, 1),
    ],
    ids=["equal", "star", "chain", "two stars"],
)
def test_joining_takes_linear_time(ends: object) -> None:
    def join_lines(size: int) -> None:
        lines = {}
        for k in range(size):
            a, b, c, d = map(Fraction, ends(k))  # type: ignore[operator]
            lines[k] = OpenLine(Candidate("", list), (Point(a, b), Point(c, d)))
        list(join(lines, Reading()))

    require_linear(join_lines, size=500)


@fewer
@given(
    st.lists(points, min_size=4, max_size=7, unique=True),
    st.lists(st.integers(0, 4), min_size=12, max_size=12),
    st.lists(st.fractions("1/4", 4, max_denominator=4), min_size=7, max_size=7),
    st.booleans(),
    st.integers(0, 40),
)
def test_splines_stay_within_the_tolerance(
    controls: list[Point], steps: list[int], weights: list[Fraction], rational: bool, place: int
) -> None:
    degree, size = 3, len(controls)
    knots = [Fraction(sum(steps[:k])) for k in range(size + degree + 1)]
    spline = Spline(degree, controls, knots, weights[:size] if rational else ())
    if knots[degree] == knots[size] or any(knots[k] == knots[k + degree + 1] for k in range(size)):
        return
    spline.validate()
    tolerance = Fraction(1, 50)
    found = spline.draw(IDENTITY).draw(tolerance, Reading())
    t = knots[degree] + (knots[size] - knots[degree]) * Fraction(place, 41)
    shares = [cox_de_boor(knots, k, degree, t) for k in range(size)]
    if rational:
        shares = [share * weight for share, weight in zip(shares, weights, strict=False)]
    x, y = (
        sum((share * p[axis] for share, p in zip(shares, controls, strict=True)), Fraction(0))
        / sum(shares)
        for axis in (0, 1)
    )
    if len(found) > 1:
        assert distance(Point(x, y), found) <= tolerance**2


def cox_de_boor(knots: list[Fraction], k: int, degree: int, t: Fraction) -> Fraction:
    """The basis function of a control point, from its definition."""
    if degree == 0:
        return Fraction(knots[k] <= t < knots[k + 1])
    found = Fraction(0)
    if knots[k + degree] > knots[k]:
        share = (t - knots[k]) / (knots[k + degree] - knots[k])
        found += share * cox_de_boor(knots, k, degree - 1, t)
    if knots[k + degree + 1] > knots[k + 1]:
        share = (knots[k + degree + 1] - t) / (knots[k + degree + 1] - knots[k + 1])
        found += share * cox_de_boor(knots, k + 1, degree - 1, t)
    return found


def test_a_block_draws_up_to_the_limit(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("exactsweep.formats.curved.dxf.MAX_COPIES", 6)
    steps = (44, 9), (45, 9)
    text = with_blocks({"a": TRIANGLE}, insert("a", (70, 3), (71, 2), *steps))
    assert len(parse_polygons(text)) == 6
    for block in (TRIANGLE, []):
        with pytest.raises(FormatError, match="expands to more than 6 entities"):
            parse_polygons(with_blocks({"a": block}, insert("a", (70, 7), *steps)))
