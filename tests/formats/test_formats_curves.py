"""Flattened curves: the flattening error is checked in rational arithmetic.

The error is computed from the equation for circles, and at points of the curve and at the vertices
of the chords for other curves.
"""

import re
from collections.abc import Iterable
from fractions import Fraction
from itertools import pairwise
from math import atan2, comb, cos, pi, sin, tau

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from mpmath import mp
from tiers import examples

from exactsweep import limits
from exactsweep.formats import FormatError, parse_polygon, parse_polygons
from exactsweep.formats.curved.affine import IDENTITY, Affine, make_affine
from exactsweep.formats.curved.arc import find_unit_point, make_arc
from exactsweep.formats.curved.curves import (
    Bezier,
    Curve,
    find_arc_center,
    make_bezier,
    make_round_arc,
    round_root_up,
)
from exactsweep.formats.curved.path import Path
from exactsweep.formats.curved.spline import Spline
from exactsweep.formats.curved.svg_path import make_elliptic_arc
from exactsweep.formats.reading import Reading
from exactsweep.formats.size import VERTEX
from exactsweep.numbers.number import Point

fewer = examples(25)
small = st.fractions(-9, 9, max_denominator=10)
points = st.builds(Point, small, small)
tolerances = st.sampled_from([Fraction(1), Fraction(1, 7), Fraction(1, 100)])


def draw(drawn: tuple[Curve, bool], ends: Iterable[Point], tolerance: Fraction) -> list[Point]:
    """The lines of a curve between two ends."""
    curve, forward = drawn
    path = Path(ends, {0: (curve, forward)})
    return path.draw(tolerance, Reading())


def distance(p: Point, line: list[Point]) -> Fraction:
    """The square of the distance of a point from a line."""
    return min(squared_distance(p, a, b) for a, b in pairwise(line))


def squared_distance(p: Point, a: Point, b: Point) -> Fraction:
    """The square of the distance of a point from a segment."""
    dx, dy = b.x - a.x, b.y - a.y
    length = dx * dx + dy * dy
    t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / length if length else Fraction(0)
    t = min(max(t, Fraction(0)), Fraction(1))
    return (a.x + t * dx - p.x) ** 2 + (a.y + t * dy - p.y) ** 2


def assert_close_to_circle(
    line: list[Point], center: Point, square: Fraction, tolerance: Fraction
) -> None:
    """Return whether a line lies in the annulus of a tolerance around a circle."""
    # r lies between these two.
    above = round_root_up(square)
    below = square / above if above else Fraction(0)
    for a, b in pairwise(line):
        assert (a.x - center.x) ** 2 + (a.y - center.y) ** 2 <= (below + tolerance) ** 2
        if above > tolerance:
            assert squared_distance(center, a, b) >= (above - tolerance) ** 2


@given(st.integers(0, 10**12), st.sampled_from([1, 10**6, 10**60]))
def test_roots_have_the_requested_error(square: int, scale: int) -> None:
    above = round_root_up(Fraction(square), scale)
    assert max(above - Fraction(1, scale), Fraction(0)) ** 2 <= square <= above * above


@given(st.fractions(Fraction(1, 100), 1000, max_denominator=100), points, tolerances)
@fewer
def test_circles_stay_within_the_tolerance(
    radius: Fraction, center: Point, tolerance: Fraction
) -> None:
    tolerance = max(tolerance, radius / 10**4)
    start = Point(center.x + radius, center.y)
    arc = make_round_arc(center, start, start, IDENTITY, left=True)
    line = draw(arc, (start, start), tolerance)
    assert line[0] == line[-1] == start
    assert_close_to_circle(line, center, radius * radius, tolerance)
    assert len(line) <= 16 + 8 * round_root_up(radius / tolerance)


@given(points, points, st.fractions(-9, 9, max_denominator=9), tolerances)
@fewer
def test_arcs_over_a_chord_stay_within_the_tolerance(
    first: Point, last: Point, bulge: Fraction, tolerance: Fraction
) -> None:
    if first == last or bulge == 0:
        return
    center = find_arc_center(first, last, (1 - bulge**2) / (2 * bulge))
    arc = make_round_arc(center, first, last, IDENTITY, left=bulge > 0)
    line = draw(arc, (first, last), tolerance)
    assert (line[0], line[-1]) == (first, last)
    square = (first.x - center.x) ** 2 + (first.y - center.y) ** 2
    assert_close_to_circle(line, center, square, tolerance)
    # The apex of the arc is `bulge` half chords right of the midpoint of the chord.
    dx, dy = (last.x - first.x) / 2, (last.y - first.y) / 2
    top = Point(first.x + dx + bulge * dy, first.y + dy - bulge * dx)
    assert distance(top, line) <= tolerance**2


@given(st.lists(points, min_size=3, max_size=4), tolerances, st.fractions(0, 1))
@fewer
def test_bezier_curves_stay_within_the_tolerance(
    controls: list[Point], tolerance: Fraction, t: Fraction
) -> None:
    line = draw(make_bezier(controls), (controls[0], controls[-1]), tolerance)
    assert (line[0], line[-1]) == (controls[0], controls[-1])
    assert distance(bernstein(controls, t), line) <= tolerance**2


def bernstein(controls: list[Point], t: Fraction) -> Point:
    n = len(controls) - 1
    weights = [comb(n, k) * t**k * (1 - t) ** (n - k) for k in range(n + 1)]
    x, y = (
        sum((w * p[i] for w, p in zip(weights, controls, strict=True)), Fraction(0)) for i in (0, 1)
    )
    return Point(x, y)


radii = st.fractions(Fraction(1, 10), 20, max_denominator=10)


@given(
    st.tuples(points, points),
    st.tuples(radii, radii),
    st.fractions(-400, 400, max_denominator=7),
    st.tuples(st.booleans(), st.booleans()),
    tolerances,
)
@fewer
def test_elliptic_arcs_stay_within_the_tolerance(
    ends: tuple[Point, Point],
    both: tuple[Fraction, Fraction],
    degrees: Fraction,
    flags: tuple[bool, bool],
    tol: Fraction,
) -> None:
    (first, last), (rx, ry), (large, left) = ends, both, flags
    if first == last:
        return
    arc = make_elliptic_arc((first, last), (rx, ry), degrees, (large, left), IDENTITY)
    line = draw(arc, ends, tol)
    assert (line[0], line[-1]) == (first, last)
    # The center, recomputed in floats, which suffice here.
    cosine, sine = cos(float(degrees) * pi / 180), sin(float(degrees) * pi / 180)
    (x0, y0), (x1, y1) = (
        (float(x) * cosine + float(y) * sine, float(y) * cosine - float(x) * sine) for x, y in ends
    )
    a, b = float(rx), float(ry)
    hx, hy = (x0 - x1) / 2, (y0 - y1) / 2
    need = hx * hx / a / a + hy * hy / b / b
    grow = max(1.0, need) ** 0.5
    a, b = a * grow, b * grow
    factor = (1 / need - 1) ** 0.5 if need < 1 else 0.0
    factor = -factor if large == left else factor
    cx, cy = factor * a * hy / b, -factor * b * hx / a
    cx, cy = cx + (x0 + x1) / 2, cy + (y0 + y1) / 2
    start = atan2((y0 - cy) / b, (x0 - cx) / a)
    span = (atan2((y1 - cy) / b, (x1 - cx) / a) - start) % tau
    span = span if left else span - tau
    for k in range(1, 8):
        angle = start + span * k / 8
        x, y = cx + a * cos(angle), cy + b * sin(angle)
        true = Point(Fraction(x * cosine - y * sine), Fraction(x * sine + y * cosine))
        assert distance(true, line) <= (tol + Fraction(1, 10**6)) ** 2


@given(st.fractions(-720, 720, max_denominator=1000), st.integers(3, 60))
@fewer
def test_points_of_the_unit_circle_are_close_to_their_angle(degrees: Fraction, digits: int) -> None:
    x, y = find_unit_point(degrees, Fraction(1, 10**digits))
    assert x * x + y * y == 1
    with mp.workdps(digits + 20):
        angle = mp.mpf(degrees.numerator) * mp.pi / (180 * degrees.denominator)
        off = abs(mp.cos(angle) - mp.mpf(x.numerator) / x.denominator)
        off += abs(mp.sin(angle) - mp.mpf(y.numerator) / y.denominator)
        assert off < 2 * mp.mpf(10) ** -digits


SHAPES = {
    '<circle r="1"/>': pi,
    '<circle cx="5" cy="-5" r="1" transform="scale(2)"/>': 4 * pi,
    '<ellipse rx="2" ry="1"/>': 2 * pi,
    '<rect width="4" height="4" rx="1"/>': 12 + pi,
    '<rect width="4" height="4" ry="9"/>': 4 * pi,
    '<path d="M-1 0A1 1 0 0 1 1 0A1 1 33 0 1-1 0z"/>': pi,
    '<path d="M-1 0A.5.5 0 111 0A.5.5 0 11-1 0"/>': pi,
    '<path d="m-1 0a1 1 0 00 2 0a1 1 0 00-2 0"/>': pi,
    '<path d="M0-2A1 2 0 0 1 0 2 2 1 90 0 1 0-2"/>': 2 * pi,
    '<path d="M1 0A1 1 0 1 1 0-1z"/>': 0.75 * pi + 0.5,
    '<path d="M1 0A1 1 0 0 0 0-1z"/>': pi / 4 - 0.5,
    '<path d="M0 0Q1 2 2 0z"/>': 4 / 3,
    '<path d="M0 0Q1 2 2 0T4 0V-3H0z"/>': 12,
    '<path d="M0 0q1 2 2 0t2 0v-3h-4z"/>': 12,
    '<path d="M0 0C0 1 1 1 1 0z"/>': 0.6,
    '<path d="M0 0c0 1 1 1 1 0s1-1 1 0v-3h-2z"/>': 6,
    '<path d="M0 0S1 1 1 0V-1z"/>': 0.8,
    '<path d="M0 0A0 1 0 0 0 1 0L0 1z"/>': 0.5,
}


@pytest.mark.parametrize("shape", SHAPES)
def test_areas_converge(shape: str) -> None:
    polygon = parse_polygon(f"<svg>{shape}</svg>", tolerance="1e-5")
    assert abs(float(polygon.area) - SHAPES[shape]) < 2e-4


def test_too_many_chords_are_rejected_early() -> None:
    with pytest.raises(FormatError, match=r"circle: a curve needs 3,206,376,105 chords at"):
        parse_polygon("<svg><circle r='1'/></svg>", tolerance="1e-18")
    with pytest.raises(FormatError, match=r"needs more than 10\*\*12 chords at this"):
        parse_polygon("<svg><circle r='1'/></svg>", tolerance="1e-30")
    circle = '<circle r="1"/>'
    with limits(max_mib=1000 * VERTEX / 2**20):
        assert len(parse_polygons(f"<svg>{circle * 2}</svg>", tolerance="6e-5")) == 2
        found = parse_polygons(f"<svg>{circle * 3}</svg>", tolerance="6e-5")
    assert len(found) == 2
    assert re.search(r"need 1,\d{3} chords .* 1,000 \(max", found.left_out[0])


@pytest.mark.parametrize("tolerance", [0, "-1", "x", float("nan"), True])
def test_a_tolerance_is_a_positive_number(tolerance: object) -> None:
    with pytest.raises(FormatError, match=r"^the tolerance"):
        parse_polygon("<svg/>", tolerance=tolerance)


weights_of = st.lists(st.fractions(Fraction(1, 20), 3, max_denominator=20), min_size=3, max_size=3)


@given(st.lists(points, min_size=3, max_size=3), weights_of, st.integers(1, 15))
@fewer
def test_second_derivatives_of_rational_curves_are_bounded(
    corners: list[Point], weights: list[Fraction], place: int
) -> None:
    """Second differences are values of the second derivative, coordinate by coordinate."""
    at, step = Fraction(place, 16), Fraction(1, 64)
    before, here, after = (rational_point(corners, weights, t) for t in (at - step, at, at + step))
    bound = Bezier(corners, weights).bend()
    assert abs(before.x - 2 * here.x + after.x) <= bound * step**2
    assert abs(before.y - 2 * here.y + after.y) <= bound * step**2


def test_the_bound_is_invariant_under_scaling_of_the_weights() -> None:
    corners = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (5, 1), (4, 7)]]
    weights = [Fraction(1), Fraction(1, 2), Fraction(3)]
    bound, scaled = (Bezier(corners, [k * w for w in weights]).bend() for k in (1, 7))
    assert abs(scaled / bound - 1) < Fraction(1, 10**6)


def rational_point(corners: list[Point], weights: list[Fraction], t: Fraction) -> Point:
    shares = [w * b for w, b in zip(weights, ((1 - t) ** 2, 2 * t * (1 - t), t**2), strict=True)]
    pairs = list(zip(shares, corners, strict=True))
    whole = sum(shares, Fraction(0))
    x = sum((share * p.x for share, p in pairs), Fraction(0))
    y = sum((share * p.y for share, p in pairs), Fraction(0))
    return Point(x / whole, y / whole)


@pytest.mark.parametrize(
    ("degree", "count", "knots", "weights", "says"),
    [
        (0, 3, [0, 1, 2, 3], [], r"the degree must be 1 to \d+, not 0"),
        (2, 2, [0, 0, 0, 1, 1], [], "2 control points; degree 2 needs 3"),
        (2, 3, [0, 0, 0, 1, 1], [], "5 knots, expected 6"),
        (2, 3, [0, 0, 1, 0, 1, 1], [], "the knots are not in order"),
        (2, 3, [0, 0, 1, 1, 1, 1], [], "all knots are equal"),
        (2, 3, [0, 0, 0, 1, 1, 1], [1, 1], "expected one positive weight"),
        (2, 3, [0, 0, 0, 1, 1, 1], [1, 0, 1], "expected one positive weight"),
    ],
)
def test_invalid_splines_are_rejected(
    degree: int, count: int, knots: list[int], weights: list[int], says: str
) -> None:
    corners = [Point(Fraction(k), Fraction(k * k)) for k in range(count)]
    spline = Spline(degree, corners, [*map(Fraction, knots)], [*map(Fraction, weights)])
    with pytest.raises(FormatError, match=f"^{says}"):
        spline.validate()


@pytest.mark.parametrize("place", range(4))
def test_ends_of_scaled_arcs_are_accurate(place: int) -> None:
    # Each entry of the image alone decides the scale.
    entries = [0, 0, 0, 0]
    entries[place] = 10**8
    image = make_affine(*entries, 5, 7)
    for start, end in ((10, 40), (77, 131), (200, 349)):
        arc = make_arc(image, Fraction(start), Fraction(end))
        for found, degrees in zip(arc.points, (start, end), strict=True):
            c, s = cos(degrees * pi / 180), sin(degrees * pi / 180)
            asked = image.point(Fraction(c), Fraction(s))
            assert (found.x - asked.x) ** 2 + (found.y - asked.y) ** 2 < Fraction(1, 1000) ** 2


numbers = st.lists(st.integers(-3, 3).map(Fraction), min_size=6, max_size=6)
ONE = Fraction(1)
signs = st.lists(st.sampled_from([-1, 1]), min_size=6, max_size=6)
offs = st.sampled_from([Fraction(0), Fraction(1, 3), Fraction(2)])


@example([ONE] * 6, [ONE] * 6, [1] * 6, [1] * 6, ONE, ONE)  # As far off as can be.
@given(numbers, numbers, signs, signs, offs, offs)
def test_products_of_maps_bound_their_error(
    one: list[Fraction],
    two: list[Fraction],
    up: list[int],
    down: list[int],
    o: Fraction,
    p: Fraction,
) -> None:
    last, first = make_affine(*one)._replace(error=o), make_affine(*two)._replace(error=p)
    true_last = Affine(*(x + o * sign for x, sign in zip(one, up, strict=True)))
    true_first = Affine(*(x + p * sign for x, sign in zip(two, down, strict=True)))
    found, true = last @ first, true_last @ true_first
    assert all(abs(a - b) <= found.error for a, b in zip(found[:6], true[:6], strict=True))


@given(
    st.lists(st.tuples(*[st.integers(-9, 9)] * 2, st.integers(1, 9)), min_size=2, max_size=5),
    st.tuples(*[st.integers(-99, 99)] * 2),
)
def test_the_bound_is_invariant_under_translation(
    given: list[tuple[int, int, int]], by: tuple[int, int]
) -> None:
    weights = [Fraction(w) for _, _, w in given]
    here, there = (
        [Point(Fraction(x + dx), Fraction(y + dy)) for x, y, _ in given] for dx, dy in ((0, 0), by)
    )
    assert Bezier(here, weights).bend() == Bezier(there, weights).bend()


def test_huge_numbers_of_chords_are_abbreviated() -> None:
    reading = Reading(tolerance=Fraction(1))
    with pytest.raises(FormatError, match="needs 1,000,000,000,000 chords"):
        reading.charge_chords(10**12)
    with pytest.raises(FormatError, match=r"needs more than 10\*\*12 chords"):
        reading.charge_chords(10**12 + 1)


def test_errors_beyond_a_sixteenth_of_the_tolerance_are_rejected() -> None:
    ends = Point(Fraction(0), Fraction(0)), Point(Fraction(3), Fraction(4))
    assert Path(ends, error=Fraction(1, 16)).draw(Fraction(1), Reading()) == [*ends]
    with pytest.raises(FormatError, match="too large for an irrational"):
        Path(ends, error=Fraction(1, 16) + Fraction(1, 10**9)).draw(Fraction(1), Reading())


@pytest.mark.parametrize("place", range(4))
@pytest.mark.parametrize("sign", [1, -1])
def test_scaled_elliptic_arcs_keep_their_width(place: int, sign: int) -> None:
    """The center is irrational. Each entry of the image alone decides the scale."""
    entries = [0, 0, 0, 0]
    entries[place] = sign * 10**4
    one, zero = Fraction(1), Fraction(0)
    ends = Point(zero, zero), Point(Fraction(3, 5), Fraction(4, 5))
    image, how = make_affine(*entries, 0, 0), (True, True)
    arc = make_elliptic_arc(ends, (one, one), zero, how, image)
    found = draw(arc, (image.point(*end) for end in ends), Fraction(1, 10))
    across = [p.x + p.y for p in found]
    # Up and left of the midpoint of the chord by the height of an equilateral triangle.
    height = round_root_up(Fraction(3, 4), 10**20)
    center = image.point(Fraction(3, 10) + height * 4 / 5, Fraction(2, 5) - height * 3 / 5)
    middle, reach = center.x + center.y, 10**4
    assert abs(min(across) - (middle - reach)) < Fraction(1, 5)
    assert abs(max(across) - (middle + reach)) < Fraction(1, 5)
