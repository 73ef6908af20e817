"""Reports of judged layouts: the table, the picture and the page."""

from __future__ import annotations

import json
import re
from fractions import Fraction
from itertools import combinations
from typing import Any
from xml.etree import ElementTree

import pytest
from layouts import image

from exactsweep.corpus import find_layout_case, layout_cases
from exactsweep.layout import Judgement, Layout, judge_layout
from exactsweep.layout.report import (
    draw_layout,
    rank_faults,
    report_layout,
    worst,
    write_layout_json,
    write_layout_page,
)
from exactsweep.layout.report.picture import SIDE, enlarge_faults, place_part

SVG = "{http://www.w3.org/2000/svg}"


def judged(slug: str) -> Judgement:
    return judge_layout(find_layout_case(f"layouts-{slug}").layout)


def test_the_worst_faults_come_first() -> None:
    text = report_layout(judged("all-at-once"))
    assert text == (
        "verdict     not valid: 1 overlap, 1 outside, 2 too close, 1 missing\n"
        "placements  5 of 1 part\n"
        "density     0.3125, exactly 5/16\n"
        "contacts    0\n"
        "\n"
        "   fault      where              how bad                             witness          "
        "    repaired by\n"
        "1  overlap    0 tile and 1 tile  0.5 deep                            (0.75, 0.5)      "
        "    moving 1 by (1.1, 0)\n"
        "2  outside    2 tile             0.5 deep                            (3.5, 4.25)      "
        "    moving 2 by (0, -0.5)\n"
        "3  too close  0 tile and 3 tile  0.5 apart, 0.6 required, 0.1 short  (0, 1) (0, 1.5)  "
        "    moving 3 by (0, 0.1)\n"
        "4  too close  1 tile and 3 tile  0.5 apart, 0.6 required, 0.1 short  (0.5, 1) (0.5, 1.5)"
        "  moving 3 by (0, 0.1)\n"
        "5  missing    part tile          1 placement\n"
    )


def test_reports_fit_the_terminal() -> None:
    text = report_layout(judged("all-at-once"), terminal_width=60)
    plain = re.sub(r"\x1b\[[0-9;]*m", "", text)
    assert max(map(len, plain.splitlines())) <= 60
    assert text != plain


def test_a_valid_layout_reports_its_minimum_distance() -> None:
    text = report_layout(judged("gap-1e-30"), notes=["one", "two"])
    assert text.startswith("verdict     valid\n")
    assert "nearest     0 tile and 1 tile, 1e-30 apart\n" in text
    assert text.endswith("note: one\nnote: two\n")


@pytest.mark.parametrize(
    ("slug", "said"),
    [
        ("overlap-1e-30", "1e-30 deep"),
        ("too-large", "no free position at this rotation"),
        ("bow-tie", "the boundary crosses itself"),
        ("turn-forbidden", "part tile forbids rotation by 90 degrees"),
        ("missing-all", "part bar  2 placements"),
        ("angle-45-undecided", "undecided within"),
        ("margin-missed", "0.125 apart"),
    ],
)
def test_each_kind_of_fault_reports_its_measure(slug: str, said: str) -> None:
    assert said in report_layout(judged(slug))


def many(number: int) -> Judgement:
    """Overlaps of unit squares by 1/k, k from 2 on, the smallest first."""
    tile = {"id": "tile", "exterior": [[0, 0], [1, 0], [1, 1], [0, 1]]}
    placed = []
    for k in range(number):
        x = Fraction(3 * k)
        placed.append({"part": "tile", "turn": 0, "move": [str(x), 0]})
        placed.append(
            {"part": "tile", "turn": 0, "move": [str(x + 1 - Fraction(1, number + 1 - k)), 0]}
        )
    box = [[0, 0], [3 * number, 0], [3 * number, 1], [0, 1]]
    return judge_layout(
        Layout.from_json({"container": {"exterior": box}, "parts": [tile], "placements": placed})
    )


def test_long_lists_are_cut_and_sorted() -> None:
    judgement = many(40)
    ranked = rank_faults(judgement)
    squares = [one.square for one in ranked]
    assert squares == sorted(squares, key=lambda square: -(square or 0))
    assert squares[0] == Fraction(1, 4)
    text = report_layout(judgement, ranked)
    assert text.endswith("... 10 more (--all)\n")
    assert text.count("overlap ") == 30
    assert report_layout(judgement, ranked, everything=True).count("deep") == 40
    assert "more" not in report_layout(many(30))


@pytest.mark.parametrize("number", [1, 2, 3])
def test_only_the_first_faults_are_measured(number: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(worst, "MAX_MEASURED", 2)
    reported: list[tuple[int, int]] = []
    ranked = rank_faults(many(number), lambda *of: reported.append(of))
    assert reported == [(k, min(number, 2)) for k in range(min(number, 2))]
    assert [one.square is not None for one in ranked] == [True, True, False][:number]


def test_the_deepest_of_many_faults_are_measured(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(worst, "MAX_MEASURED", 2)
    ranked = rank_faults(many(9))
    assert [one.square for one in ranked[:2]] == [Fraction(1, 4), Fraction(1, 9)]


def test_many_tiny_faults_look_like_rounding(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(worst, "MAX_MEASURED", 2)
    tile = [[0, 0], [1, 0], ["1", "1"], [0, 1]]
    places = [{"part": "t", "move": [str(k * (1 - Fraction(1, 10**9))), 0]} for k in range(9)]
    layout = {"parts": [{"id": "t", "exterior": tile}], "placements": places}
    text = report_layout(judge_layout(Layout.from_json(layout)))
    assert "note: 8 overlaps, all at most 1e-9 deep: possibly rounding; --accept 1e-9" in text


def test_witnesses_far_from_the_origin_have_the_digits_of_the_layout() -> None:
    part = {"id": "t", "exterior": [[0, 0], [2, 0], [2, 2], [0, 2]]}
    places = [{"part": "t", "move": [x, 10**9]} for x in (4 * 10**8, 4 * 10**8 + 1)]
    text = report_layout(judge_layout(Layout.from_json({"parts": [part], "placements": places})))
    assert "(400000001.5, 1000000001)" in text


def test_json_is_exact() -> None:
    data = json.loads(write_layout_json(judged("overlap-1e-30"), ["a note"]))
    assert data["valid"] is False
    assert data["density"] == "2/3"
    assert data["notes"] == ["a note"]
    (fault,) = data["faults"]
    assert fault["move"] == [f"1/{10**30}", "0"]
    assert data["nearest"] == [0, 1]


def classes(svg: str) -> dict[str, int]:
    found: dict[str, int] = {}
    for element in ElementTree.fromstring(svg).iter():
        for name in element.get("class", "").split():
            found[name] = found.get(name, 0) + 1
    return found


def test_a_picture_shows_all_parts_with_faulty_ones_in_red() -> None:
    judgement = judged("all-at-once")
    svg = draw_layout(judgement, rank_faults(judgement), "a <layout>")
    assert "<title>a &lt;layout&gt;</title>" in svg
    found = classes(svg)
    # One part has no fault. Four faults have a witness, so an enlargement; three show two parts.
    assert (found["part"], found["frame"]) == (1, 4)
    assert found["bad"] == 4 + 2 + 1 + 2 + 2
    assert found["number"] == 5  # of the placements
    valid = judged("tiles")
    found = classes(draw_layout(valid, (), "tiles"))
    assert found["part"] == 6
    assert not {"bad", "frame", "mark"} & found.keys()


def require_room(svg: ElementTree.Element) -> None:
    """Require that enlarged faults and their captions are below the layout, in the picture."""
    width, height = float(svg.get("width", "")), float(svg.get("height", ""))
    panels = [(float(p.get("x", "")), float(p.get("y", ""))) for p in svg.findall(f"{SVG}svg")]
    drawn = " ".join(path.get("d", "") for path in svg.findall(f"{SVG}path"))
    ends = [float(y) for y in re.findall(r"[ML]-?[\d.]+ (-?[\d.]+)", drawn)]
    lines = [float(text.get("y", "")) for text in svg.findall(f"{SVG}text")]
    assert all(max(ends) <= y <= height - SIDE and 0 <= x <= width - SIDE for x, y in panels)
    assert max(lines, default=0) <= height
    assert width <= 1000
    for (ax, ay), (bx, by) in combinations(panels, 2):
        assert abs(ax - bx) > SIDE or abs(ay - by) > SIDE


@pytest.mark.parametrize("case", [*layout_cases()], ids=lambda case: case.id)
def test_every_case_is_drawn(case: Any) -> None:
    judgement = judge_layout(case.layout)
    ranked = rank_faults(judgement)
    for y_down in (False, True):
        require_room(ElementTree.fromstring(draw_layout(judgement, ranked, "", y_down=y_down)))
    page = write_layout_page(judgement, ranked, case.title)
    assert "nan" not in page
    assert (' class="valid"' in page) == case.expected["valid"]


@pytest.mark.parametrize("case", [*layout_cases()], ids=lambda case: case.id)
def test_enlargements_are_translation_invariant(case: Any) -> None:
    """The translation is integral, so that corners of the picture remain on a lattice."""
    here, there = map(judge_layout, (case.layout, image(case.layout, Fraction(1), 1000, -777)))
    panels, others = (enlarge_faults(j, rank_faults(j)) for j in (here, there))
    assert [panel.svg for panel in others] == [panel.svg for panel in panels]


def test_an_overlap_of_1e_30_is_visible_in_its_enlargement() -> None:
    judgement = judged("far-1e-30")
    (place,) = enlarge_faults(judgement, rank_faults(judgement))
    assert place.caption == "overlap, 0 tile and 1 tile; the picture is 6e-30 wide"
    edges = set()
    for data in re.findall(r'class="bad" d="([^"]+)"', place.svg):
        edges |= {float(x) for x in re.findall(r"[ML](-?[\d.]+) ", data) if 0 < float(x) < SIDE}
    # The overlapping ends of the tiles are a sixth of the picture apart, around the middle.
    low, high = sorted(edges)
    assert abs((high - low) * 6 - SIDE) < 1
    assert abs((low + high) - SIDE) < 1


def test_mirrored_rotated_parts_are_drawn_in_place() -> None:
    layout = find_layout_case("layouts-mirrored").layout
    (ring,) = place_part(layout, 1)
    xs, ys = zip(*ring, strict=True)
    assert (min(xs), max(xs), min(ys), max(ys)) == (0, 3, 2, 4)
    layout = find_layout_case("layouts-ells-345").layout
    (ring,) = place_part(layout, 1)
    assert max(x for x, _ in ring) == Fraction(12, 5)


def test_names_in_a_page_are_text() -> None:
    judgement = judged("missing")
    page = write_layout_page(judgement, rank_faults(judgement), "<b>", ["<i>"])
    assert "<b>" not in page
    assert "<i>" not in page
    assert "&lt;b&gt;" in page
    assert "script-src 'sha256-" in page
    assert page.count("<script") == 1
    assert "default-src 'none'" in page
