import copy
import math
import pickle
import re
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

import pytest
import strategies
from hypothesis import given
from hypothesis import strategies as st
from refusals import list_refusals, require_refused

from exactsweep import NumberError, Point, Polygon, Region, limits

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]


def cross(o: Point, a: Point, b: Point) -> Fraction:
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x)


@given(strategies.simple_polygons())
def test_vertices_are_canonical(polygon: Polygon) -> None:
    v = polygon.vertices
    turns = [cross(v[i - 2], v[i - 1], v[i]) for i in range(len(v))]
    assert v[0] == min(v)
    assert all(turns)
    assert polygon.is_convex == all(turn > 0 for turn in turns)
    assert (
        polygon.area
        == sum(cross(Point(Fraction(0), Fraction(0)), v[i - 1], v[i]) for i in range(len(v))) / 2
    )
    assert polygon.area > 0
    assert len(polygon) == len(v)


@pytest.mark.parametrize("scale", [1, 3, Fraction(1, 2), Fraction(1, 2**9000)])
def test_the_smallest_triangles_are_oriented_counter_clockwise(scale: Fraction) -> None:
    """Twice their area is one unit of the lattice, the smallest nonzero value."""
    corners = [(0, 0), (scale, 0), (0, scale)]
    for k in range(3):
        spelled = corners[k:] + corners[:k]
        for ring in (spelled, spelled[::-1]):
            assert Polygon(ring).vertices == strategies.points(*corners)


@given(strategies.simple_polygons(), st.data())
def test_spelling_does_not_matter(polygon: Polygon, data: st.DataObject) -> None:
    spelled = Polygon(data.draw(strategies.spellings(polygon)))
    assert spelled == polygon
    assert hash(spelled) == hash(polygon)
    assert spelled.vertices == polygon.vertices
    assert spelled.lattice() == polygon.lattice()


@given(strategies.simple_polygons(), st.data())
def test_indices_lead_back_to_the_input(polygon: Polygon, data: st.DataObject) -> None:
    given_ = data.draw(strategies.spellings(polygon))
    spelled = Polygon(iter(given_))
    n = len(given_)
    for k, corner in enumerate(spelled.vertices):
        end = spelled.vertices[(k + 1) % len(spelled)]
        i, e = spelled.vertex_index(k), spelled.edge_index(k)
        a, b = (Point(*given_[j % n]) for j in (e, e + 1))
        assert given_[i] == corner
        assert given_[i] not in given_[:i]
        assert a != b
        assert a in (corner, end)
        assert cross(corner, end, a) == cross(corner, end, b) == 0
        assert min(corner, end) <= b <= max(corner, end)


@given(strategies.simple_polygons())
def test_lattice_is_the_coarsest(polygon: Polygon) -> None:
    scale, points = polygon.lattice()
    assert (
        tuple(Point(Fraction(x, scale), Fraction(y, scale)) for x, y in points) == polygon.vertices
    )
    assert scale == math.lcm(*(c.denominator for v in polygon.vertices for c in v))


@given(strategies.simple_polygons(), strategies.translations())
def test_translation_commutes_with_construction(
    polygon: Polygon, by: tuple[Fraction, Fraction]
) -> None:
    moved = polygon.translated(by)
    assert moved == Polygon([(x + by[0], y + by[1]) for x, y in polygon.vertices])
    assert moved.translated((-by[0], -by[1])).vertices == polygon.vertices
    assert moved.area == polygon.area


@given(strategies.simple_polygons())
def test_bounding_box_is_tight(polygon: Polygon) -> None:
    xs, ys = zip(*polygon.vertices, strict=True)
    assert polygon.bounding_box == ((min(xs), min(ys)), (max(xs), max(ys)))


@given(strategies.simple_polygons())
def test_copies_are_equal(polygon: Polygon) -> None:
    for other in (
        Polygon(polygon),
        copy.copy(polygon),
        copy.deepcopy(polygon),
        pickle.loads(pickle.dumps(polygon)),
    ):
        assert other == polygon
        assert other.vertex_index(0) == polygon.vertex_index(0)


def test_polygons_are_immutable() -> None:
    polygon: Any = Polygon(SQUARE)
    for name in ("vertices", "area", "anything"):
        with pytest.raises(AttributeError):
            setattr(polygon, name, ())


def test_other_things_are_not_equal() -> None:
    assert Polygon(SQUARE) != SQUARE
    assert Polygon(SQUARE) != Polygon(SQUARE[:3])


def test_text_is_exact_unless_abbreviated() -> None:
    halves = Polygon([(0, 0), ("1/2", 0), (0, -1)])
    assert repr(halves) == "Polygon([(0, -1), ('1/2', 0), (0, 0)])"
    assert eval(repr(halves)) == halves
    assert str(halves) == "(0, -1) (1/2, 0) (0, 0)"
    long = Polygon([(x, x * x * 10**5000) for x in range(50)])
    assert str(long).startswith("(0, 0) (1, 1e+5000) (2, ")
    assert str(long).endswith(" ... 42 more")
    assert str(Polygon(long.vertices[:9])).endswith(" ... 1 more")
    assert "more" not in str(Polygon(long.vertices[:8]))
    assert len(repr(long)) < 400


def test_repr_round_trips_or_is_in_angle_brackets() -> None:
    for vertices in (
        [(0, 0), (0.1, 0), ("1/3", 1)],
        [(0, 0), (Fraction(1, 7**40), 0), (0, 1)],
        [(x, x * x) for x in range(9)],
        [(0, 0), (0.1 + 0.2, 0), (0, Fraction(0.1) + Fraction(0.2))],
    ):
        for shape in (Polygon(vertices), Region(vertices)):
            shown = repr(shape)
            assert shown.startswith("<") or eval(shown) == shape


def test_floats_are_shown_as_their_shortest_decimals() -> None:
    polygon = Polygon([(0, 0), (0.1, 0), (0, Fraction(0.1) + Fraction(0.2))])
    assert str(polygon) == "(0, 0) (0.1~, 0) (0, 0.3~)"
    assert f"{polygon:.2f}" == "(0.00, 0.00) (0.10, 0.00) (0.00, 0.30)"
    assert f"{polygon[1]:.3f}" == "(0.100, 0.000)"
    assert f"{polygon}" == f"{polygon!s}"


@pytest.mark.parametrize(("call", "said"), list_refusals(__file__))
def test_errors_name_the_location(call: str, said: str) -> None:
    require_refused(call, said)


@given(strategies.simple_polygons())
def test_columns_and_single_vertices_are_read_alike(polygon: Polygon) -> None:
    """Vertices that are neither tuples nor lists are read one by one."""
    rows = [tuple(map(str, vertex)) for vertex in polygon.vertices]
    one_by_one = Polygon([iter(row) for row in rows])
    assert Polygon(rows) == one_by_one == polygon
    assert Polygon([list(row) for row in rows]).lattice() == one_by_one.lattice()


@pytest.mark.parametrize("bad", [True, math.nan, "0x1", None, 1j, "1" * 400])
@pytest.mark.parametrize("row", [tuple, list])
def test_one_invalid_number_among_many_is_named(bad: object, row: Callable[..., Any]) -> None:
    ring = [row((x, x * x)) for x in range(1000)]
    ring[700] = row((700, bad))
    with limits(max_digits=10), pytest.raises(NumberError, match=r"^vertex 700: "):
        Polygon(ring)


@pytest.mark.parametrize(("last", "convex"), [((4, 3), "yes"), ((1, 1), "no")])
def test_a_notebook_shows_whether_a_polygon_is_convex(last: tuple[int, int], convex: str) -> None:
    html = Polygon([(0, 0), (4, 0), last, (0, 4)])._repr_html_()
    assert re.search(rf"convex\W.*?\b{convex}\b", html)


@pytest.mark.parametrize("factor", [1, Fraction(1, 7), 1 + Fraction(1, 3**5200)])
@pytest.mark.parametrize("kind", [tuple, list])
def test_vertices_inside_straight_edges_are_dropped(factor: Fraction, kind: Any) -> None:
    ring = [(0, 0), (1, 0), (2, 0), (2, 2), (1, 1)]
    polygon = Polygon([kind((factor * x, factor * y)) for x, y in ring])
    assert polygon.vertices == tuple(
        Point(factor * x, factor * y) for x, y in ring[::2][:1] + ring[2:4]
    )


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_every_protocol_of_pickle_keeps_shapes_and_numbers(protocol: int) -> None:
    polygon = Polygon([(0, 2), (1, 1), (2, 2), (2, 0), ("1/3", 0)])
    for shape in (polygon, Region(polygon)):
        again = pickle.loads(pickle.dumps(shape, protocol))
        assert again == shape
        numbers = range(len(shape))
        assert [*map(again.edge_index, numbers)] == [*map(shape.edge_index, numbers)]


def test_a_polygon_equals_the_region_without_holes() -> None:
    polygon = Polygon(SQUARE)
    assert polygon == Region(polygon)
    assert Region(polygon) == polygon
    assert len({polygon, Region(polygon)}) == 1
    assert polygon != Region(polygon, [[(1, 1), ("3/2", 1), (1, "3/2")]])


def test_a_polygon_is_a_sequence_of_its_vertices() -> None:
    polygon: Any = Polygon(SQUARE)
    assert issubclass(Polygon, Sequence)
    assert [*reversed(polygon)] == [*polygon.vertices[::-1]]
    assert [polygon.index(vertex) for vertex in polygon] == [0, 1, 2, 3]
    assert [polygon.count(point) for point in (polygon[0], (1, 1))] == [1, 0]


def test_heights_are_dropped_with_a_warning() -> None:
    flat = {"type": "Polygon", "coordinates": [[(0, 0), (1, 0), (0, 1), (0, 0)]]}
    high = {"type": "Polygon", "coordinates": [[(x, y, 7) for x, y in flat["coordinates"][0]]]}
    with pytest.warns(UserWarning, match="Z coordinates are dropped"):
        assert Polygon(high) == Polygon(flat)
