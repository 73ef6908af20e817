"""Checks of the paper report faults planted in their input."""

import re
from fractions import Fraction
from itertools import count
from types import SimpleNamespace
from typing import Any

import pytest

from exactsweep import Point, Polygon, sweep
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.steps import Touch
from exactsweep.paper import functions
from exactsweep.paper.checks import appendix, beyond, section1, section2, section4
from exactsweep.paper.functions import compare_loops
from exactsweep.paper.pairs import SweepPair

SQUARES = SweepPair([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (3, 0), (3, 3), (0, 3)])


def _copy(s: Any, *names: str, **planted: Any) -> Any:
    """A sweep with some attributes replaced."""
    return SimpleNamespace(**{name: getattr(s, name) for name in names} | planted)


def test_a_wrong_loop_is_reported() -> None:
    s = sweep([(0, 0), (1, 0), (0, 1)], [(0, 0), (3, 0), (3, 3), (0, 3)])
    names = "generatrix", "directrix", "reference", "trajectory", "outer"
    wrong = _copy(s, *names, inner=s.outer)
    assert [*compare_loops(s)] == [*compare_loops(wrong, "trajectory", "outer")] == []
    for asked in ((), ("inner",), ("outer", "inner")):
        assert [*compare_loops(wrong, *asked)] == ["the inner loop differs from the definition"]


def test_a_fit_that_is_cut_short_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    slot = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
    pair = SweepPair([(0, 0), (1, 0), (1, 1), (0, 1)], slot)
    s = sweep(*pair)
    ((start, end),) = s.exact_fits
    middle = Point((start.x + end.x) / 2, (start.y + end.y) / 2)
    found = []
    for fit in ((start, end), (start, middle), (middle, end)):
        wrong = _copy(s, "directrix", "generatrix", "trajectory", exact_fits=(fit,))
        monkeypatch.setattr(section1, "sweep", lambda *_, s=wrong: s)
        found.append([*section1.fits_are_whole(pair)])
    x, y = middle
    assert found[0] == []
    assert [re.sub(r"at \(1, .*\)", "there", text) for text in found[1]] == [
        "there along an exact fit: CONTACT"
    ]
    assert found[2] == [f"the exact fit from ({x}, {y}) does not start on the trajectory"]


def test_a_slide_that_is_cut_short_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    directrix = [(-1, 5), (2, 0), (10, 2), (11, 6), (7, 3), (5, 5), (0, 4)]
    pair = SweepPair([(5, 0), (17, 2), (9, 4)], directrix)
    s = sweep(*pair)
    wrong = _copy(s, "generatrix", "directrix", "reference", "inner")
    monkeypatch.setattr(section4, "sweep", lambda *_: wrong)
    slide, other = s.undercuts
    p, q = slide.positions
    middle = Point((p.x + q.x) / 2, (p.y + q.y) / 2)
    for ends, is_whole in (((p, q), True), ((p, middle), False), ((middle, q), False)):
        wrong.undercuts = slide._replace(positions=ends), other
        reported = [text.partition(":")[0] for text in section4.bottom_chains_have_two_forms(pair)]
        assert reported == ([] if is_whole else ["not at both ends of the segment alone"])
    # A bottom chain on another line, or on two edges, is not one edge.
    first, last = slide.bottom
    for bottom in ((first, slide.polygon.vertices[1]), (first, last, other.bottom[1])):
        wrong.undercuts = slide._replace(bottom=bottom), other
        reported = [text.partition(":")[0] for text in section4.bottom_chains_have_two_forms(pair)]
        assert reported[:1] == ["not a single parallel edge"]


@pytest.mark.parametrize(("i", "k", "chain"), [(1, 2, "bottom"), (2, 1, "bottom"), (4, 5, "top")])
def test_a_contact_of_two_like_chains_is_reported(
    i: int, k: int, chain: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    ring = [(0, 0), (2, -1), (4, -1), (6, 0), (4, 1), (2, 1)]
    pair = SweepPair(ring, ring)
    assert not [*section2.like_chains_have_no_contact(pair)]
    s = sweep(*pair)
    for event in ("VV", "VE", "EV"):
        contacts = [[(event, i, k)]]
        wrong = _copy(s, "generatrix", "directrix", contacts=contacts, vertex_contacts=[])
        monkeypatch.setattr(section2, "sweep", lambda *_, s=wrong: s)
        monkeypatch.setattr(section2, "contacts_are_correct", lambda _: ())
        assert [*section2.like_chains_have_no_contact(pair)] == [
            f"{event} of two {chain} chains: {i} of G, {k} of D"
        ]


def test_a_path_that_is_a_translated_directrix_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not [*section1.path_is_not_the_directrix(SQUARES)]
    d = sweep(*SQUARES).directrix
    wrong = SimpleNamespace(directrix=d, trajectory=d.translated((2, 7)))
    monkeypatch.setattr(section1, "sweep", lambda *_: wrong)
    assert [*section1.path_is_not_the_directrix(SQUARES)] == ["the trajectory is a translate of D"]


def test_a_sweep_that_starts_elsewhere_is_reported(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    assert not [*section2.starts_and_stops_at_the_ends(SQUARES)]
    moved = SimpleNamespace(trajectory=sweep(*SQUARES).trajectory.translated((2, 7)))
    monkeypatch.setattr(section2, "sweep", lambda *_: moved)
    assert [*section2.starts_and_stops_at_the_ends(SQUARES)] == [
        "the sweep starts at (1, 6), where (1, 1) is off D's end",
        "the sweep stops at (5, 6), where (0, 1) is off D's end",
    ]


def test_contacts_of_two_edges_at_a_time_are_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not [*appendix.one_edge_at_a_time(SQUARES)]
    step = appendix.list_lower_steps(sweep(*SQUARES))[0]
    middle = Point((step.start.x + step.end.x) / 2, (step.start.y + step.end.y) / 2)
    contacts = Contact("EV", 0, 1), Contact("EV", 1, 2)
    monkeypatch.setattr(section2, "touches_are_correct", lambda *_: ())
    for ends, is_reported in ((step.end, step.start), True), ((middle, middle), False):
        spans = (step.start, ends[0]), (ends[1], step.end)
        touches = tuple(Touch(c, *span) for c, span in zip(contacts, spans, strict=True))
        planted = step._replace(touches=touches)
        monkeypatch.setattr(appendix, "list_lower_steps", lambda _, step=planted: [step])
        reported = {text.partition(": ")[2] for text in appendix.one_edge_at_a_time(SQUARES)}
        assert reported == ({"EV of 0 and 1, EV of 1 and 2"} if is_reported else set())


def test_a_contact_that_moves_left_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    assert not [*appendix.contact_moves_right(SQUARES)]
    places = count(9, -1)
    monkeypatch.setattr(
        appendix, "find_contact_extent", lambda *_: [x := next(places), x + Fraction(1, 2)]
    )
    first, *_ = appendix.contact_moves_right(SQUARES)
    assert re.sub(r"at \(.*?\)", "there", first) == (
        "there the contact is from x = 8 to 17/2, after 9 to 19/2"
    )


@pytest.mark.parametrize(("shift", "is_reported"), [(0, True), (1, True), (2, False)])
def test_holes_that_overlap_are_reported(
    shift: int, is_reported: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    outer, hole = (Polygon([(0, 0), (s, 0), (s, s), (0, s)]) for s in (9, 2))
    found = SimpleNamespace(exterior=outer, holes=(hole, hole.translated((shift, 0))))
    monkeypatch.setattr(beyond, "no_fit_polygon", lambda *_: found)
    monkeypatch.setattr(functions, "no_fit_is_the_definition", lambda _: ())
    assert [*beyond.loops_are_simple(SQUARES)] == ["two holes overlap"] * is_reported
