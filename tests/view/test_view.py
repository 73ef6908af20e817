"""The interactive page, without a browser."""

import json
import re
from base64 import b64encode
from fractions import Fraction
from hashlib import sha256
from itertools import pairwise
from math import ulp
from pathlib import Path
from typing import Any

import pytest
from command import EXAMPLE, HOUSE, NOTCH, refusal, run
from contacts import between, without_parts
from hypothesis import given
from shown import find_stops
from strategies import pairs, points
from tiers import examples

from exactsweep import Point, Polygon, sweep
from exactsweep.draw import Scale
from exactsweep.draw.sweeps import trace_anchor
from exactsweep.evidence.contact import Contact
from exactsweep.geometry.vectors import is_between, minus
from exactsweep.view import make_page
from exactsweep.view.data import Meetings, gather_page_data
from exactsweep.view.page import embed_json

SLOT = sweep(
    [(0, 0), (1, 0), (1, 1), (0, 1)],
    [(0, 0), (3, 0), (3, 5), (2, 5), (2, 1), (1, 1), (1, 3), (0, 3)],
)
any_pair = pairs("CC") | pairs("CM") | pairs("MM")


def data_of(text: str) -> Any:
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.S)
    assert found
    return json.loads(found[1])


def exact_points(exact: list[str]) -> tuple[Point, ...]:
    return points(*zip(exact[::2], exact[1::2], strict=True))


def places(flat: list[float]) -> list[tuple[float, float]]:
    return list(zip(flat[::2], flat[1::2], strict=True))


@examples(30)
@given(any_pair)
def test_stops_go_once_around_and_include_all_landmarks(pair: tuple[Polygon, Polygon]) -> None:
    s = sweep(*pair, reference=(3, "1/7"))
    found = find_stops(s)
    assert [stop.position for stop in found if stop.vertex is not None] == list(
        s.trajectory.vertices
    )
    positions = [stop.position for stop in found]
    assert len(set(positions)) == len(positions)
    for undercut in s.undercuts:
        assert set(undercut.positions) <= set(positions)
    for start, _ in s.exact_fits:
        assert start in positions


@examples(30)
@given(any_pair)
def test_contacts_between_and_at_stops_are_correct(pair: tuple[Polygon, Polygon]) -> None:
    s = sweep(*pair)
    found = find_stops(s)
    for stop, following in list(zip(found, found[1:] + found[:1], strict=True))[:12]:
        assert stop.contacts
        here = s.contacts_at(between(stop.position, following.position))
        assert without_parts(s, here) == set(stop.contacts)


def test_a_meeting_of_two_vertices_is_a_stop() -> None:
    # One peak of D slides along a flat edge of G; halfway, another one meets a peak of G.
    roof = [(0, -20), (10, -20), (10, -12), (8, 1), (6, -12), (4, 0), (0, 0)]
    peaks = [(-20, 30), (0, 0), (3, 20), (6, 1), (20, 30), (20, 31), (-20, 31)]
    s = sweep(roof, peaks)
    halfway = Point(Fraction(-2), Fraction(0))
    (stop,) = (stop for stop in find_stops(s) if stop.position == halfway)
    assert stop.vertex is None
    assert stop.contacts == (Contact("EV", 5, 1),)
    assert Contact("VV", 3, 3) in s.contacts_at(halfway)


@pytest.mark.parametrize(
    ("limit", "most"),
    [
        ("_MAX_PAIRS", len(EXAMPLE.generatrix) * len(EXAMPLE.directrix)),
        ("_MAX_TESTS", len(Meetings(EXAMPLE).translations) * len(EXAMPLE.trajectory)),
    ],
)
def test_large_sweeps_state_that_meetings_are_not_stops(
    monkeypatch: pytest.MonkeyPatch, limit: str, most: int
) -> None:
    monkeypatch.setattr(f"exactsweep.view.data.{limit}", most)
    assert gather_page_data(EXAMPLE)["hasMeetings"]
    monkeypatch.setattr(f"exactsweep.view.data.{limit}", most - 1)
    assert not gather_page_data(EXAMPLE)["hasMeetings"]
    assert [stop.position for stop in find_stops(EXAMPLE)] == list(EXAMPLE.trajectory.vertices)


@examples(30)
@given(any_pair)
def test_the_page_places_g_exactly(pair: tuple[Polygon, Polygon]) -> None:
    s = sweep(*pair, reference=(10**40, "1/3"))
    data = gather_page_data(s)
    scale = Scale.of(s.outer.vertices, trace_anchor(s).vertices)
    x, y = s.reference
    for (tx, ty), (px, py) in zip(
        exact_points(data["tracks"][0]["exact"]), places(data["tracks"][0]["places"]), strict=True
    ):
        for (gx, gy), (qx, qy) in zip(
            s.generatrix.vertices, places(data["generatrix"]["places"]), strict=True
        ):
            shown = px + qx, py + qy
            exact = scale.place(Point(gx + tx - x, gy + ty - y))
            # The sum of two coordinates, each rounded once.
            for a, b, parts in zip(shown, exact, ((px, qx), (py, qy)), strict=True):
                assert abs(Fraction(a) - Fraction(b)) <= 2 * ulp(max(1.0, *map(abs, parts)))


def test_features_have_the_numbers_of_the_input() -> None:
    clockwise = [(0, 0), (0, 1), (1, 2), (2, 1), (2, 0), (1, 0)]
    data = gather_page_data(sweep(clockwise, EXAMPLE.directrix))
    assert data["generatrix"]["vertices"] == [0, 4, 3, 2, 1]
    assert data["generatrix"]["edges"] == [4, 3, 2, 1, 0]


def test_the_page_is_self_contained() -> None:
    text = make_page(EXAMPLE)
    assert not re.search(r'(?:src|href|url)\s*[=(]\s*["\']?(?!data:|#)[\w/.]', markup(text))
    assert "@import" not in text
    assert "default-src 'none'" in text
    assert "Mike Bostock" in text
    assert "Robert Penner" in text
    assert not re.search(r"\{\{\w+\}\}", text)


def markup(text: str) -> str:
    """The page without the contents of its scripts."""
    return re.sub(r"(<script[^>]*>).*?</script>", r"\1</script>", text, flags=re.S)


def test_only_its_own_scripts_may_run() -> None:
    text = make_page(EXAMPLE)
    scripts = re.findall(r"<script>(.*?)</script>", text, re.S)
    hashes = [f"'sha256-{b64encode(sha256(s.encode()).digest()).decode()}'" for s in scripts]
    assert f"script-src {' '.join(hashes)};" in text
    assert len(scripts) == 2
    assert "unsafe-inline" not in text.split("script-src")[1].split(";")[0]


def test_data_cannot_leave_its_element() -> None:
    hostile = ["</script><script>alert(1)</script>", "<!--", "&lt;", "]]>"]
    written = embed_json(hostile)
    assert not set("<>&") & set(written)
    assert json.loads(written) == hostile


def test_file_names_are_in_the_page_as_text(tmp_path: Path) -> None:
    bad = tmp_path / "<img src=x onerror=alert(1)>.json"
    bad.write_text(Path(HOUSE).read_text())
    result = run("view", str(bad), NOTCH)
    assert result.exit_code == 0
    assert "<img" not in result.stdout
    assert data_of(result.stdout)["names"] == [str(bad), NOTCH]
    assert f"&lt;img src=x onerror=alert(1)&gt;.json around {NOTCH}: 5 around" in result.stdout


def test_the_page_reports_its_progress() -> None:
    steps: list[str] = []
    assert make_page(SLOT, progress=steps.append) == make_page(SLOT)
    assert steps == ["the loops", "exact fits", "undercuts", "contacts along 8 edges"]


def test_contacts_of_all_tracks_are_found_in_one_call() -> None:
    # Contacts of all tracks are found at once: a thousand slots side by side, and in a line.
    def contacts_along(count: int) -> tuple[int, int]:
        comb = [(0, 0), (4 * count, 0)]
        for k in reversed(range(count)):
            comb += [(4 * k + 4, 5), (4 * k + 2, 5), (4 * k + 2, 1), (4 * k + 1, 1), (4 * k + 1, 5)]
        s = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], [*comb, (0, 5)])
        calls: list[int] = []
        found = s.contacts_along

        def counted(loops: Any) -> Any:
            calls.append(len(loops))
            return found(loops)

        vars(s)["contacts_along"] = counted
        assert len(gather_page_data(s)["tracks"]) == 1 + count
        return len(calls), sum(calls)

    assert contacts_along(3) == (1, 4)
    assert contacts_along(60) == (1, 61)


def test_the_command_writes_a_page(tmp_path: Path) -> None:
    path = tmp_path / "sweep.html"
    assert run("view", "-o", str(path)).output == ""
    assert path.read_text() == make_page(EXAMPLE)
    assert data_of(path.read_text())["title"] == "Sweep of 5 around 7 vertices"
    nowhere = tmp_path / "none" / "sweep.html"
    assert refusal(run("view", "-o", str(nowhere))) == f"{nowhere}: No such file or directory"


def test_vertices_meet_without_a_common_lattice() -> None:
    """Off-lattice coordinates keep their fractional part, which was once truncated."""
    thin = [Fraction(1, 10**900 + k) for k in range(8)]
    block = [(thin[0], thin[1]), (3 + thin[2], thin[1]), (3 + thin[2], 2 + thin[3])]
    s = sweep([(0, 0), (1 + thin[4], 0), (1 + thin[4], 1 + thin[5]), (thin[6], 1)], block)
    assert s.directrix.lattice()[0] == 1
    found = Meetings(s)
    differences = {
        ((v.x - w.x) * found.scale, (v.y - w.y) * found.scale)
        for v in s.directrix.vertices
        for w in s.generatrix.vertices
    }
    assert found.translations
    assert set(found.translations) <= differences


@pytest.mark.parametrize(
    ("generatrix", "directrix", "met"),
    [
        # A spike of G passes a corner of D; a corner of G passes a spike of D.
        ([(0, 1), (4, 5), (2, 4), (2, 5)], [(0, 5), (1, 2), (6, 2)], (-1, -3)),
        ([(0, 5), (2, 1), (6, 3)], [(0, 4), (6, 1), (5, 4), (5, 3), (4, 6)], (3, 3)),
    ],
)
def test_vertices_met_in_passing_are_all_found(
    generatrix: list[tuple[int, int]], directrix: list[tuple[int, int]], met: tuple[int, int]
) -> None:
    s = sweep(generatrix, directrix)
    loop = s.trajectory.vertices
    differences = {minus(q, p) for q in s.directrix.vertices for p in s.generatrix.vertices}
    # No position of the trajectory overlaps, so each difference on it is a meeting.
    on_edges = {
        t for t in differences if any(is_between(t, *edge) for edge in pairwise([*loop, loop[0]]))
    }
    assert met in on_edges
    assert Meetings(s).on_edges(loop) == sorted(on_edges)
