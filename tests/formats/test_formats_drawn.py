"""Flattened curves, compared with a certified interval evaluation of the true curves.

In every direction, at every scale and tolerance, the lines of a simple outline are simple and
within the tolerance of the curve, and the curve is within the tolerance of the lines.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise
from random import Random
from typing import Any

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from mpmath import iv, mp
from rounded import compare_rounded, draw_rounded
from tiers import examples

from exactsweep.formats import parse_polygons, parse_regions
from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.numbers.number import Point

tolerances = st.sampled_from(["1", "1/10", "1/100", "1/1000", "1e-5"])
scales = st.sampled_from([Fraction(1, 1000), Fraction(1), Fraction(7, 3), Fraction(10**5)])
_SAMPLES = 24

Curve = Callable[[Fraction], tuple[Any, Any]]
"""Maps a parameter from 0 to 1 to a point of the curve, as two intervals."""


def lie_within(curve: Curve, line: Sequence[Point], tolerance: Fraction) -> bool:
    """Decide whether points of a curve, by intervals, are within the tolerance of a line."""
    for k in range(_SAMPLES + 1):
        x, y = curve(Fraction(k, _SAMPLES))
        best = min(measure(x, y, a, b) for a, b in pairwise(line))
        if best > tolerance:
            return False
    return True


def measure(x: Any, y: Any, a: Point, b: Point) -> Fraction:
    """A bound on the distance of a point, given by intervals, from a segment."""
    px, py = (Fraction(*to_ratio(mp.mpf(v.mid))) for v in (x, y))
    room = sum((Fraction(*to_ratio(mp.mpf(v.delta))) for v in (x, y)), Fraction(0))
    dx, dy = b.x - a.x, b.y - a.y
    length = dx * dx + dy * dy
    t = ((px - a.x) * dx + (py - a.y) * dy) / length if length else Fraction(0)
    t = min(max(t, Fraction(0)), Fraction(1))
    square = (a.x + t * dx - px) ** 2 + (a.y + t * dy - py) ** 2
    return Fraction(float(square) ** 0.5 * (1 + 1e-12)) + room


def to_ratio(value: Any) -> tuple[int, int]:
    from mpmath.libmp import to_rational

    n, d = to_rational(value._mpf_)
    return int(n), int(d)


def to_interval(value: Fraction | int) -> Any:
    return iv.mpf(value.numerator) / value.denominator


@examples(10)
@given(
    st.fractions(Fraction(1, 100), 3, max_denominator=1000),
    st.sampled_from([1, -1]),
    st.booleans(),
    scales,
    tolerances,
)
def test_a_circular_segment_is_simple_and_close_in_both_directions(
    bulge: Fraction, side: int, backward: bool, scale: Fraction, tolerance: str
) -> None:
    """A bulged polyline and its chord, in either direction."""
    reach = Fraction(tolerance) * scale
    ends = [(Fraction(0), Fraction(0)), (30 * scale, 10 * scale)]
    if backward:
        ends, side = ends[::-1], -side
    first, last = ends
    text = draw_polyline([first, last], [side * bulge, 0])
    (part,) = parse_polygons(text, tolerance=reach)
    vertices = part.polygon.vertices
    dx, dy = last[0] - first[0], last[1] - first[1]
    height = (1 - bulge * bulge) / (2 * bulge) * side
    center = first[0] + dx / 2 - height * dy / 2, first[1] + dy / 2 + height * dx / 2
    square = (first[0] - center[0]) ** 2 + (first[1] - center[1]) ** 2
    with mp.workdps(60):
        near = 4 * mp.atan(mp.mpf(bulge.numerator) / bulge.denominator)
        angle = iv.mpf([near - mp.mpf(10) ** -15, near + mp.mpf(10) ** -15])
    start = Point(first[0] - center[0], first[1] - center[1])

    def curve(t: Fraction) -> tuple[Any, Any]:
        c, s = iv.cos(angle * to_interval(t)), iv.sin(angle * to_interval(t)) * side
        x, y = to_interval(start.x), to_interval(start.y)
        return to_interval(center[0]) + x * c - y * s, to_interval(center[1]) + x * s + y * c

    ring = [*vertices, vertices[0]]
    assert lie_within(curve, ring, part.error)
    assert part.error <= reach
    sector = to_interval(square) / 2 * (angle - iv.sin(angle))
    area = find_doubled_area(vertices) / 2
    around = Fraction(float(square) ** 0.5 * float(mp.mpf(angle.b)) + float(abs(dx) + abs(dy)))
    off = abs(Fraction(float(mp.mpf(sector.mid))) - Fraction(area))
    allowed = around * part.error * Fraction(11, 10) + Fraction(1, 10**9) * scale * scale
    assert off <= allowed


@examples(8)
@given(
    st.lists(st.tuples(*[st.fractions(-9, 9, max_denominator=10)] * 2), min_size=2, max_size=2),
    st.booleans(),
    scales,
    tolerances,
)
def test_a_cubic_over_its_chord_is_close_in_both_directions(
    inner: list[tuple[Fraction, Fraction]], backward: bool, scale: Fraction, tolerance: str
) -> None:
    """Above its chord, from left to right, so that it is simple."""
    reach = Fraction(tolerance) * scale
    (a, b), (c, d) = inner
    low, high = sorted((abs(a), abs(c)))
    zero, ten = Fraction(0), Fraction(10)
    controls = [(zero, zero), (low, abs(b) + 1), (9 - low / 9 + high / 9, abs(d) + 1), (ten, zero)]
    points = [(x * scale, y * scale) for x, y in controls]
    if backward:
        points = points[::-1]
    data = "M{} C{} {} {} Z".format(*(f"{to_text(x)},{to_text(y)}" for x, y in points))
    (part,) = parse_regions(f'<svg><path d="{data}"/></svg>', tolerance=reach)

    def curve(t: Fraction) -> tuple[Any, Any]:
        shares = (1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3
        read = [(Fraction(to_text(x)), Fraction(to_text(y))) for x, y in points]
        return tuple(
            to_interval(sum(s * p[i] for s, p in zip(shares, read, strict=True))) for i in (0, 1)
        )

    ring = [*part.region.exterior.vertices, part.region.exterior.vertices[0]]
    assert lie_within(curve, ring, part.error)


@examples(60)
@given(
    st.fractions(Fraction(1, 10), Fraction(99, 100), max_denominator=200),
    st.sampled_from([0, 1]),
    st.booleans(),
    st.integers(0, 359),
    tolerances,
)
def test_tangent_arcs_are_simple_at_all_tolerances_and_directions(
    ratio: Fraction, sweep: int, backward: bool, degrees: int, tolerance: str
) -> None:
    """Two internally tangent circles, joined at the tangent point: a cusp of angle 0."""
    large, small = Fraction(50), 50 * ratio
    if backward:
        data = f"M0 0 A{to_text(small)} {to_text(small)} 0 0 {sweep} 0 {to_text(2 * small)}"
        data += f" L0 {to_text(2 * large)} A50 50 0 0 {1 - sweep} 0 0 Z"
    else:
        data = f"M0 0 A50 50 0 0 {sweep} 0 {to_text(2 * large)} L0 {to_text(2 * small)}"
        data += f" A{to_text(small)} {to_text(small)} 0 0 {1 - sweep} 0 0 Z"
    text = f'<svg><path transform="rotate({degrees})" d="{data}"/></svg>'
    found = parse_regions(text, tolerance=tolerance)
    assert not found.notes
    (part,) = found
    read = Fraction(to_text(small))
    true = 3.141592653589793 / 2 * float(large**2 - read**2)
    assert abs(float(part.region.area) - true) <= 320 * float(part.error) + 1e-6


def test_the_same_region_is_read_in_both_directions() -> None:
    forward = "M100 100A20 20 0 1 1 100 140A30 30 0 0 0 100 80Z"
    backward = "M100 80A30 30 0 0 1 100 140A20 20 0 1 0 100 100Z"
    for tolerance in ("1", "1/10", "1/100", "1/1000", None):
        one, other = (
            parse_regions(f'<svg><path d="{data}"/></svg>', tolerance)[0].region
            for data in (forward, backward)
        )
        assert one == other


@pytest.mark.parametrize("tolerance", ["1", "1/10", "1/100", "1/1000", "1e-6"])
@pytest.mark.parametrize("more", ["0.4142135623731", "0.41421357", "0.414213562373095049"])
def test_bulges_near_a_quarter_circle_leave_no_spike(more: str, tolerance: str) -> None:
    corners = [(3, 0), (27, 0), (30, 3), (30, 7), (27, 10), (3, 10), (0, 7), (0, 3)]
    text = draw_polyline(corners, [0, more] * 4)
    (part,) = parse_polygons(text, tolerance=tolerance)
    assert abs(float(part.polygon.area) - (300 - (4 - 3.14159265) * 9)) < 90 * float(part.error)


def to_text(value: Any) -> str:
    """Write a number as a decimal of at most 12 places."""
    return f"{float(value):.12f}".rstrip("0").rstrip(".")


def draw_polyline(points: Sequence[tuple[Any, Any]], bulges: Sequence[Any]) -> str:
    """Write a closed polyline of DXF; decimals are exact where they are finite."""
    from exactsweep.formats.decimals import format_decimal

    tags = f"0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n90\n{len(points)}\n70\n1\n"
    for (x, y), bulge in zip(points, bulges, strict=True):
        numbers = []
        for value in (x, y, bulge):
            exact = Fraction(value)
            numbers.append(format_decimal(Fraction(round(exact * 10**15), 10**15)))
        tags += "10\n{}\n20\n{}\n42\n{}\n".format(*numbers)
    return f"{tags}0\nENDSEC\n0\nEOF\n"


@pytest.mark.parametrize("seed", range(8))
def test_rounded_shapes_near_contact_are_never_judged_wrongly(seed: int) -> None:
    rng = Random(seed)
    assert not compare_rounded(draw_rounded(rng), rng, True)


def test_crossing_outlines_are_filled_by_their_rule() -> None:
    star = "M5 0L8 9L0 3.5H10L2 9Z"
    whole, ends = (
        parse_regions(f'<svg><path fill-rule="{rule}" d="{star}"/></svg>')
        for rule in ("nonzero", "evenodd")
    )
    assert [len(whole), len(ends)] == [1, 5]
    bow = parse_regions('<svg><path d="M20 5L30 15L30 5L20 15Z"/></svg>')
    assert [part.region.area for part in bow] == [25, 25]
    assert "2 polygons by the nonzero fill rule" in bow.notes[0]
    cleaned = parse_regions('<svg><path d="M0 0H4V4H0zM9 9h.1v.1h-.1z"/></svg>', clean="1/2")
    assert [part.region.area for part in cleaned] == [16]
    assert "below --clean" in cleaned.left_out[0]


@examples(8)
@given(
    st.fractions(1, 50, max_denominator=100),
    st.fractions(Fraction(1, 20), 1, max_denominator=100),
    st.lists(st.fractions(-2, 2, max_denominator=10), min_size=4, max_size=4),
    scales,
    tolerances,
)
def test_an_ellipse_under_any_map_is_simple_and_close(
    radius: Fraction, ratio: Fraction, matrix: list[Fraction], scale: Fraction, tolerance: str
) -> None:
    a, b, c, d = matrix
    assume(abs(a * d - b * c) > Fraction(1, 20))
    size = radius * scale
    rx, ry = (Fraction(to_text(value)) for value in (size, size * ratio))
    reach = max(Fraction(tolerance) * scale, size / 10**4)
    shape = f'<ellipse rx="{to_text(rx)}" ry="{to_text(ry)}"'
    transform = f"matrix({' '.join(map(to_text, matrix))} 0 0)"
    a, b, c, d = (Fraction(to_text(value)) for value in matrix)
    parts = parse_polygons(f'<svg>{shape} transform="{transform}"/></svg>', tolerance=reach)
    (part,) = parts
    assert not parts.notes
    assert part.error <= reach

    def curve(t: Fraction) -> tuple[Any, Any]:
        angle = 2 * iv.pi * to_interval(t)
        x, y = to_interval(rx) * iv.cos(angle), to_interval(ry) * iv.sin(angle)
        p, q, r, s = map(to_interval, (a, b, c, d))
        return p * x + r * y, q * x + s * y

    vertices = part.polygon.vertices
    assert lie_within(curve, [*vertices, vertices[0]], part.error)
    area = float(rx * ry * abs(a * d - b * c)) * float(mp.pi)
    around = 7 * float(max(rx, ry) * (abs(a) + abs(b) + abs(c) + abs(d)))
    assert abs(area - float(part.polygon.area)) <= around * float(part.error)


@examples(8)
@given(
    st.integers(2, 5),
    st.lists(st.fractions(Fraction(3, 5), 1, max_denominator=50), min_size=6, max_size=9),
    st.booleans(),
    scales,
    tolerances,
)
def test_a_closed_spline_is_simple_and_close_in_both_directions(
    degree: int, radii: list[Fraction], backward: bool, scale: Fraction, tolerance: str
) -> None:
    """A periodic B-spline around a point, evaluated by de Boor's algorithm in rationals."""
    reach = max(Fraction(tolerance), Fraction(1, 1000)) * scale
    corners = []
    for k, radius in enumerate(radii):
        angle = 2 * mp.pi * k / len(radii)
        x, y = (
            Fraction(float(one)).limit_denominator(1000) for one in (mp.cos(angle), mp.sin(angle))
        )
        corners.append(tuple(Fraction(to_text(30 * radius * scale * v)) for v in (x, y)))
    points = corners + corners[:degree]
    if backward:
        points.reverse()
    tags: list[object] = [0, "SECTION", 2, "ENTITIES", 0, "SPLINE", 8, 0, 71, degree]
    tags += [tag for k in range(len(points) + degree + 1) for tag in (40, k)]
    tags += [tag for x, y in points for tag in (10, to_text(x), 20, to_text(y))]
    tags += [0, "ENDSEC", 0, "EOF"]
    parts = parse_polygons("".join(f"{tag}\n" for tag in tags), tolerance=reach)
    (part,) = parts
    assert not parts.notes
    assert part.error <= reach

    def curve(t: Fraction) -> tuple[Any, Any]:
        u = degree + t * len(radii)
        first = min(int(u), len(points) - 1) - degree
        row = points[first : first + degree + 1]
        for step in range(1, degree + 1):
            shares = [(u - first - k) / (degree + 1 - step) for k in range(step, degree + 1)]
            row = [
                tuple(p + s * (q - p) for p, q in zip(one, other, strict=True))
                for s, (one, other) in zip(shares, pairwise(row), strict=True)
            ]
        ((x, y),) = row
        return to_interval(x), to_interval(y)

    vertices = part.polygon.vertices
    assert lie_within(curve, [*vertices, vertices[0]], part.error)
