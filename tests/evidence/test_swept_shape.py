"""Sweeps of polygons of any shape: contacts, undercuts, steps and certificates."""

from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

from hypothesis import assume, given
from hypothesis import strategies as st
from polyominoes import Cells, frame, polyominoes, region
from tiers import examples

from exactsweep import Point, Polygon, Region, Sweep, sweep
from exactsweep.check import classify, verify
from exactsweep.evidence.contact import number_as_given
from exactsweep.geometry.outline import Outline
from exactsweep.numbers.number import ORIGIN
from exactsweep.procedures.any_shape import ShapeSolution

SHEARS = [(1, 0, 0, 1), (1, 1, 0, 1), (2, 1, 1, 1), (0, -1, 1, 0)]
UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]


def shape_sweep(g: Region, d: Region) -> Sweep:
    return Sweep(g, d, None, ORIGIN)


def on_segment(p: Point, a: Point, b: Point) -> bool:
    turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)
    return turn == 0 and min(a, b) <= p <= max(a, b)


def respell(shape: Region, turns: bool, by: int) -> list[list[Point]]:
    """Return the rings with another first vertex, possibly reversed."""
    rings = [[*ring[by % len(ring) :], *ring[: by % len(ring)]] for ring in shape.rings]
    return [ring[::-1] for ring in rings] if turns else rings


def feature(rings: list[list[Point]], k: int, event: str) -> tuple[Point, ...]:
    for ring in rings:
        if k < len(ring):
            return (ring[k], ring[(k + 1) % len(ring)]) if event == "E" else (ring[k],)
        k -= len(ring)
    raise IndexError(k)


@given(
    polyominoes(12, 5),
    polyominoes(7, 4),
    st.sampled_from(SHEARS),
    st.booleans(),
    st.integers(0, 5),
)
@examples(60)
def test_contacts_touch_at_their_positions(
    d: Cells, g: Cells, matrix: tuple[int, int, int, int], turns: bool, by: int
) -> None:
    directrix, generatrix = (respell(region(cells, matrix), turns, by) for cells in (d, g))
    s = shape_sweep(*(Region(rings[0], rings[1:]) for rings in (generatrix, directrix)))
    for k, t in enumerate(s.trajectory.vertices):
        after = s.trajectory.vertices[(k + 1) % len(s.trajectory)]
        middle = Point((t.x + after.x) / 2, (t.y + after.y) / 2)
        at_middle = s.contacts_at(middle)
        assert at_middle
        lasting = {c for c in at_middle if c.event != "VV"}
        assert s.contacts[k]
        assert {c for c in lasting if c.event == "EE"} <= set(s.contacts[k])
        for event, i, j in at_middle:
            moved = [
                Point(p.x + middle.x, p.y + middle.y) for p in feature(generatrix, i, event[0])
            ]
            other = feature(directrix, j, event[1])
            if event == "VV":
                assert moved == [*other]
            elif event == "VE":
                assert on_segment(moved[0], *other)
            elif event == "EV":
                assert on_segment(other[0], *moved)
            else:
                assert any(on_segment(p, *moved) for p in other) or any(
                    on_segment(p, *other) for p in moved
                )


@given(polyominoes(12, 5), polyominoes(7, 4))
@examples(40)
def test_undercuts_holes_and_the_directrix_fill_the_inner_loop(d: Cells, g: Cells) -> None:
    s = shape_sweep(region(g), region(d))
    undercuts = sum((u.polygon.area for u in s.undercuts), Fraction(0))
    assert s.directrix.exterior.area + undercuts == s.inner.area
    for undercut in s.undercuts:
        assert undercut.positions
        for position in undercut.positions:
            assert classify(s.directrix, s.generatrix, position).verdict == "CONTACT"


def test_an_inner_loop_through_all_corners_and_midpoints_of_the_directrix() -> None:
    """Found by the campaign: the undercut lies in a quarter of an edge of D."""
    d = [(12, 7), (20, 13), (24, 15), (23, 17), (16, 13)]
    g = [(-3, 10), (3, 13), (4, 13), (9, 16), (14, 21), (21, 26), (7, 19), (10, 19), (3, 15)]
    s = shape_sweep(Region([*g, (2, 16), (1, 15)]), Region(d))
    closed = [(12, 7), (18, "23/2"), ("203/11", "129/11"), ("208/11", "134/11")]
    assert s.inner == Polygon([*closed, *d[1:]])


@given(polyominoes(6, 3))
@examples(20)
def test_a_mold_around_its_part(g: Cells) -> None:
    mold = frame(g, 2)
    assume(len(region(g).holes) == 0)
    s = sweep(region(g), region(mold))
    assert s.kind == "SS"
    assert (ORIGIN, ORIGIN) in s.exact_fits
    assert verify(s.certificate()).proved


def test_features_of_several_holes_are_numbered_as_in_the_input() -> None:
    rings = [
        [(9, 0), (9, 9), (0, 9), (0, 0)],
        [(2, 1), (1, 1), (1, 2)],
        [(5, 3), (5, 5), (3, 5), (3, 3)],
        [(7, 7), (6, 7), (7, 6)],
    ]
    shape, given = Region(rings[0], rings[1:]), [p for ring in rings for p in ring]
    following = [p for ring in rings for p in ring[1:] + ring[:1]]
    outline = Outline(shape.lattice()[1])
    for k, vertex in enumerate(outline.vertices):
        assert given[number_as_given(shape, outline, k, of_edge=False)] == vertex
        i = number_as_given(shape, outline, k, of_edge=True)
        assert {given[i], following[i]} == set(outline.edge(k))
    swept = sweep(UNIT, shape).directrix
    for k, vertex in enumerate(swept.vertices):
        x, y = given[swept.vertex_index(k)]
        assert vertex == Point(Fraction(x), Fraction(y))


def test_threads_may_share_a_sweep() -> None:
    """Two threads read the same unswept holes and the same area."""
    size = 24
    comb = [(0, 0), (4 * size, 0)]
    for k in reversed(range(size)):
        comb += [(4 * k + 4, 9 + k % 3), (4 * k + 2, 9 - k % 2), (4 * k + 2, 3 + k % 2), (4 * k, 4)]
    hook = [(0, 0), (3, 0), (3, 3), (0, 3), (0, 2), (2, 2), (2, 1), (0, 1)]
    expected = sweep(hook, comb)
    area = expected.area
    for _ in range(3):
        s = sweep(hook, comb)
        with ThreadPoolExecutor(2) as pool:
            both = pool.map(lambda shared: shared.unswept, [s, s])
        assert [*both] == [expected.unswept] * 2
        assert s.area == area


def test_the_inner_loop_is_recognized_by_value() -> None:
    """Another thread may compute an equal loop that is not the same object."""
    frame_ = Region([(-2, -2), (7, -2), (7, 7), (-2, 7)], [[(0, 0), (4, 0), (4, 3), (0, 3)]])
    s = shape_sweep(Region(UNIT), frame_)
    assert isinstance(s.solution, ShapeSolution)
    s.solution.__dict__["inner"] = [*s.solution.inner]
    assert s.unswept == ()
    assert s.inner == frame_.exterior
