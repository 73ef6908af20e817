"""`locate`, compared with the definition at many positions."""

from fractions import Fraction
from itertools import pairwise

from hypothesis import given, settings
from hypothesis import strategies as st
from polyominoes import Cells, polyominoes, region
from strategies import simple_polygons

from exactsweep import Point, Polygon, no_fit_polygon
from exactsweep.check import classify
from exactsweep.geometry.region import AnyPolygon

SAID = {"OVERLAP": "overlap", "CONTACT": "contact", "FREE": "free"}
HALF = Fraction(1, 2)


def check_positions(directrix: AnyPolygon, generatrix: AnyPolygon, aside: Point) -> None:
    """Compare at vertices, at midpoints of edges and of exact fits, and next to these."""
    n = no_fit_polygon(directrix, generatrix, reference=(1, 0))
    corners = [vertex for loop in (n.exterior, *n.holes) for vertex in loop]
    ends = list(pairwise(corners)) + list(n.exact_fits)
    places = corners + [Point((p.x + q.x) / 2, (p.y + q.y) / 2) for p, q in ends]
    for x, y in places[:: len(places) // 12 + 1]:
        for t in Point(x, y), Point(x + aside.x, y + aside.y):
            verdict = classify(directrix, generatrix, (t.x - 1, t.y)).verdict
            assert n.locate(t) == SAID[verdict]


steps = st.builds(Point, *[st.sampled_from([-HALF, Fraction(0), HALF, Fraction(2)])] * 2)


@settings(max_examples=20)
@given(simple_polygons(), simple_polygons(), steps)
def test_located_positions_of_polygons_match_the_definition(
    d: Polygon, g: Polygon, aside: Point
) -> None:
    check_positions(d, g, aside)


@settings(max_examples=20)
@given(polyominoes(10, 4), polyominoes(5, 3), steps)
def test_located_positions_near_exact_fits_match_the_definition(
    d: Cells, g: Cells, aside: Point
) -> None:
    check_positions(region(d), region(g), aside)
