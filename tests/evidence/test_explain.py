"""The steps of a sweep, compared with the definition."""

from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import pairwise

import strategies as own
from hypothesis import example, given
from hypothesis import strategies as st
from many_contacts import FORK, ROOF, STAIRS, STEPS, TABLE
from tiers import examples

from exactsweep import Point, Polygon, Region, Sweep, sweep
from exactsweep.check import classify
from exactsweep.check.location import point_in_polygon
from exactsweep.evidence.contact import Contact, find_contacts
from exactsweep.evidence.steps import Step, blocks, explain
from exactsweep.text.explanation import describe_steps

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
SLOT = [(0, 0), (3, 0), (3, 5), (2, 5), (2, 1), (1, 1), (1, 3), (0, 3)]
# A step much shorter than every feature.
SHORT = Fraction(1, 10**60)

patient = examples(60)


def pairs() -> st.SearchStrategy[tuple[Polygon, Polygon]]:
    return own.pairs("CC") | own.pairs("CM") | own.pairs("MM")


def sweeps() -> st.SearchStrategy[Sweep]:
    directions = st.sampled_from([None, (1, 0)])
    return st.builds(
        lambda pair, direction, reference: sweep(*pair, direction=direction, reference=reference),
        pairs(),
        directions,
        st.sampled_from([(0, 0), ("1/3", -2)]),
    )


def turned_sweeps() -> st.SearchStrategy[Sweep]:
    """Sweeps whose shared direction is not the X axis, starting at an arbitrary vertex."""

    def turned(polygon: Polygon) -> Polygon:
        return Polygon([(x - 2 * y, 3 * x + y) for x, y in polygon.vertices])

    return pairs().map(lambda pair: sweep(*map(turned, pair), direction=(1, 2)))


def any_sweeps() -> st.SearchStrategy[Sweep]:
    return sweeps() | turned_sweeps()


PAIRS = [(FORK, TABLE), (FORK, ROOF), (ROOF, TABLE[::-1]), (FORK[::-1], TABLE), (STEPS, STAIRS)]


def known() -> Iterator[Sweep]:
    for g, d in [(SQUARE, SLOT), *PAIRS]:
        yield sweep(g, d, direction=(1, 0), reference=("1/3", -2))
        yield sweep([(-x, y) for x, y in g], [(-x, y) for x, y in d], direction=(1, 0))
        turned = ([(x - y, x + y) for x, y in shape] for shape in (g, d))
        yield sweep(*turned, direction=(1, 1))


def also_known(law: Callable[[Sweep], None]) -> Callable[[Sweep], None]:
    """Try a law first on some sweeps with several simultaneous contacts."""
    for s in known():
        law = example(s)(law)
    return law


def verdict(s: Sweep, position: Point) -> str:
    (x, y), (rx, ry) = position, s.reference
    return classify(s.directrix, s.generatrix, (x - rx, y - ry)).verdict


def beyond(position: Point, way: tuple[Fraction | int, Fraction | int]) -> Point:
    return Point(position.x + way[0] * SHORT, position.y + way[1] * SHORT)


def middle(p: Point, q: Point) -> Point:
    return Point((p.x + q.x) / 2, (p.y + q.y) / 2)


def vector(p: Point, q: Point) -> tuple[Fraction, Fraction]:
    return q.x - p.x, q.y - p.y


def share(step: Step, point: Point) -> Fraction:
    """Return the parameter of a point on the step's line: 0 at the start, 1 at the end."""
    (dx, dy), (px, py) = vector(step.start, step.end), vector(step.start, point)
    assert dx * py == dy * px
    return px / dx if dx else py / dy


def cross(p: tuple[int, int], q: tuple[int, int]) -> int:
    return p[0] * q[1] - p[1] * q[0]


@patient
@also_known
@given(any_sweeps())
def test_steps_are_the_edges_of_the_trajectory(s: Sweep) -> None:
    steps = explain(s)
    assert tuple(step.start for step in steps) == s.trajectory.vertices
    assert all(p.end == q.start for p, q in pairwise([*steps, steps[0]]))
    for step in steps:
        (dx, dy), (p, q) = vector(step.start, step.end), step.direction
        assert dx * q == dy * p
        assert dx * p + dy * q > 0
        assert Fraction(p, q or 1).denominator == abs(q or 1)
        assert abs(p) + abs(q) == 1 or p * q != 0


@patient
@also_known
@given(any_sweeps())
def test_touches_are_the_contacts_with_their_intervals(s: Sweep) -> None:
    for step, listed in zip(explain(s), s.contacts, strict=True):
        assert sorted(touch.contact for touch in step.touches) == sorted(listed)
        reached = Fraction(0)
        for contact, start, end in step.touches:
            low, high = share(step, start), share(step, end)
            # Some features always touch.
            assert 0 <= low <= reached
            assert low < high <= 1
            reached = max(reached, high)
            assert contact in s.contacts_at(middle(start, end))
            if low > 0:
                assert contact not in s.contacts_at(middle(step.start, start))
            if high < 1:
                assert contact not in s.contacts_at(middle(end, step.end))
        assert reached == 1
        starts = [share(step, touch.start) for touch in step.touches]
        assert starts == sorted(starts)


@patient
@also_known
@given(any_sweeps())
def test_g_turns_before_losing_contact_and_stops_before_overlap(s: Sweep) -> None:
    steps = explain(s)
    for step, following in pairwise([*steps, steps[0]]):
        straight_on = verdict(s, beyond(step.end, vector(step.start, step.end)))
        turn = cross(step.direction, following.direction)
        if step.ending == "corner":
            assert turn > 0
            assert straight_on != "OVERLAP"
            assert {event for event, _, _ in step.reasons} == {"VV"}
        else:
            assert turn < 0
            assert (straight_on == "OVERLAP") == (step.ending == "stop") == bool(step.reasons)
        assert not {touch.contact for touch in step.touches} & set(step.reasons)
        assert set(step.reasons) <= set(s.contacts_at(step.end))
        assert [*step.reasons] == sorted(step.reasons)


def ends_of(polygon: Polygon) -> dict[int, set[int]]:
    """Return the input indices of the ends of each edge."""
    vertex, edge, size = polygon.vertex_index, polygon.edge_index, len(polygon)
    return {edge(k): {vertex(k), vertex((k + 1) % size)} for k in range(size)}


def test_vertices_of_touching_features_meet_at_a_corner() -> None:
    for s in known():
        g_ends, d_ends = ends_of(s.generatrix.exterior), ends_of(s.directrix.exterior)
        for step in explain(s):
            if step.ending == "corner":
                near = {
                    (a, b)
                    for (event, i, j), _, _ in step.touches
                    for a in (g_ends[i] if event[0] == "E" else {i})
                    for b in (d_ends[j] if event[1] == "E" else {j})
                }
                met = {(i, j) for event, i, j in s.contacts_at(step.end) if event == "VV"}
                assert {(i, j) for _, i, j in step.reasons} == near & met


@patient
@also_known
@given(any_sweeps())
def test_a_step_that_ends_at_an_exact_fit_points_into_it(s: Sweep) -> None:
    for step in explain(s):
        if step.ending == "exact fit":
            fits = [mark for mark in step.landmarks if mark.mark == "exact fit"]
            along = [vector(*s.exact_fits[f.number]) for f in fits if f.position == step.end]
            u = vector(step.start, step.end)
            assert any(u[0] * y == u[1] * x and u[0] * x + u[1] * y > 0 for x, y in along)


@patient
@given(pairs(), st.data())
def test_exactly_blocking_contacts_lead_to_overlap(
    pair: tuple[Polygon, Polygon], data: st.DataObject
) -> None:
    s = sweep(*pair)
    position = data.draw(st.sampled_from(s.trajectory.vertices))
    edge = data.draw(st.sampled_from([*pair[0].vertices, *pair[1].vertices]))
    compass = st.tuples(own.tiny(-2, 2), own.tiny(-2, 2)).filter(any)
    aside = data.draw(compass | st.just(vector(edge, position)).filter(any))
    loops = s._boundaries
    frame = s.solution.frame
    way = frame.enter_point(Point(*map(Fraction, aside)))
    t = frame.enter_point(position, s.reference)
    stopped = any(blocks(c, way, *loops) for c in find_contacts(*loops, t))
    assert stopped == (verdict(s, beyond(position, aside)) == "OVERLAP")


@patient
@also_known
@given(any_sweeps())
def test_landmarks_are_on_their_step(s: Sweep) -> None:
    for step in explain(s):
        shares = [share(step, mark.position) for mark in step.landmarks]
        assert shares == sorted(shares)
        assert all(0 < where <= 1 for where in shares)


@patient
@also_known
@given(any_sweeps())
def test_every_undercut_is_closed_once(s: Sweep) -> None:
    marks = [mark for step in explain(s) for mark in step.landmarks]
    for number, undercut in enumerate(s.undercuts):
        own_marks = {m.mark: m.position for m in marks if m.number == number and "f" not in m.mark}
        if len(undercut.positions) == 1:
            assert own_marks == {"undercut": undercut.positions[0]}
            # G touches D there in both of the extreme points.
            (x, y), (rx, ry) = undercut.positions[0], s.reference
            there = s.generatrix.translated((x - rx, y - ry))
            for point in undercut.extremes:
                assert point_in_polygon(point, there) == point_in_polygon(point, s.directrix) == 0
        else:
            assert own_marks.keys() == {"undercut opens", "undercut closes"}
            assert set(own_marks.values()) <= set(undercut.positions)
    fits = [m for m in marks if m.mark == "exact fit"]
    assert sorted(m.number for m in fits) == list(range(len(s.exact_fits)))
    assert all(m.position == s.exact_fits[m.number][0] for m in fits)
    undercuts = [m.number for m in marks if m.mark in ("undercut", "undercut opens")]
    assert sorted(undercuts) == list(range(len(s.undercuts)))
    assert len(undercuts) + len(fits) + sum(m.mark == "undercut closes" for m in marks) == len(
        marks
    )


@patient
@also_known
@given(any_sweeps())
def test_an_undercut_opens_before_it_closes(s: Sweep) -> None:
    steps = explain(s)
    p, q = s.solution.frame.direction
    # Begin at the start of the lower sweep, whatever the first vertex of the trajectory.
    start = min(
        range(len(steps)),
        key=lambda k: (
            p * steps[k].start.x + q * steps[k].start.y,
            p * steps[k].start.y - q * steps[k].start.x,
        ),
    )
    open_ones = set()
    for step in steps[start:] + steps[:start]:
        for mark, number, _ in step.landmarks:
            if mark == "undercut opens":
                open_ones.add(number)
            elif mark == "undercut closes":
                open_ones.remove(number)
    assert not open_ones


@patient
@also_known
@given(any_sweeps())
def test_the_halves_follow_each_other(s: Sweep) -> None:
    halves = [step.half for step in explain(s)]
    changes = sum(p != q for p, q in pairwise([*halves, halves[0]]))
    assert changes == len(set(halves))
    assert {"lower", "upper"} <= set(halves)
    p, q = s.solution.frame.direction
    for step in explain(s):
        along = step.direction[0] * p + step.direction[1] * q
        assert along == 0 or (along > 0) == (step.half == "lower")
        assert along == 0 or step.half in ("lower", "upper")
        if step.half in ("left", "right"):
            places = [x * p + y * q for x, y in s.trajectory.vertices]
            here = step.start.x * p + step.start.y * q
            assert here == (min if step.half == "left" else max)(places)


@patient
@given(pairs(), st.data())
def test_features_are_numbered_as_in_the_input(
    pair: tuple[Polygon, Polygon], data: st.DataObject
) -> None:
    g, d = (Polygon(data.draw(own.spellings(polygon))) for polygon in pair)

    def as_given(contact: Contact) -> Contact:
        event, i, j = contact
        return Contact(
            event,
            g.edge_index(i) if event[0] == "E" else g.vertex_index(i),
            d.edge_index(j) if event[1] == "E" else d.vertex_index(j),
        )

    canonical = [Polygon(list(polygon.vertices)) for polygon in pair]
    for plain, spelled in zip(explain(sweep(*canonical)), explain(sweep(g, d)), strict=True):
        touches = {touch._replace(contact=as_given(touch.contact)) for touch in plain.touches}
        assert touches == set(spelled.touches)
        assert sorted(map(as_given, plain.reasons)) == list(spelled.reasons)


@patient
@also_known
@given(any_sweeps())
def test_explanations_cover_all_steps_undercuts_and_fits(s: Sweep) -> None:
    lines = list(describe_steps(s))
    text = "\n".join(lines)
    assert text.isascii()
    assert "\n\n\n" not in text
    assert [line for line in lines if line != line.rstrip() or "\n" in line] == []
    starts = [line.split(":")[0] for line in lines if line.startswith("Step ")]
    assert starts == [f"Step {k}" for k in range(len(s.trajectory))]
    for k in range(len(s.undercuts)):
        assert text.count(f"undercut {k}, of area") == 1
    for k in range(len(s.exact_fits)):
        assert text.count(f"exact fit {k} begins") == 1
    words = [line.split(":")[0].strip() for line in lines if line.startswith("  ")]
    assert words.count("Stop") == sum(step.ending == "stop" for step in explain(s))
    assert words.count("Corner") == sum(step.ending == "corner" for step in explain(s))


def test_an_exact_fit_in_a_hole_is_not_passed() -> None:
    box, hole = [(0, 0), (3, 0), (3, 3), (0, 3)], [(1, 1), (2, 1), (2, 2), (1, 2)]
    s = sweep(SQUARE, Region(box, [hole]))
    assert s.exact_fits == ((Point(Fraction(1), Fraction(1)),) * 2,)
    assert [step.landmarks for step in explain(s)] == [()] * 4


def test_an_undercut_closes_at_the_last_of_three_positions() -> None:
    g = [(1, -1), (0, -2), (-4, -1), (-5, -2), (-4, -5), (0, -4), (1, -5)]
    s = sweep(g, [(2, 0), (1, -2), (0, 0), (-1, -2), (-2, -4), (-2, -6), (2, -6)])
    marks = [mark for step in explain(s) for mark in step.landmarks]
    (undercut,) = s.undercuts
    assert sorted(undercut.positions) == [*own.points((0, 4), ("4/7", "29/7"), ("38/9", "41/9"))]
    # Along the top of the trajectory, from right to left.
    assert [(mark.mark, mark.position.x) for mark in marks] == [
        ("undercut opens", Fraction(38, 9)),
        ("undercut closes", 0),
    ]


def test_landmarks_of_one_step_come_in_the_order_of_travel() -> None:
    """From right to left, over a slot of exact fit and then over one too narrow."""
    d = [(0, 0), (9, 0), (9, 3), (8, 3), (8, 1), (7, 1), (7, 3), (5, 3), (5, 1), ("9/2", 1)]
    s = sweep(SQUARE, [*d, ("9/2", 3), (0, 3)])
    (marks,) = (step.landmarks for step in explain(s) if step.landmarks)
    assert [mark.mark for mark in marks] == [
        "undercut",
        "exact fit",
        "undercut opens",
        "undercut closes",
    ]
    assert [mark.position.x for mark in marks] == [7, 7, Fraction(9, 2), 4]
