"""The page in a browser: contacts at its stops, names, numbers, and many fits."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from command import EXAMPLE
from contacts import without_parts
from shown import WIDTH, Open, Shown, scale_example

from exactsweep import Region, sweep
from exactsweep.evidence.contact import Contact
from exactsweep.numbers.digits import format_fraction
from exactsweep.view import make_page
from exactsweep.view.data import list_tracks, track_stops

ROOF = [(0, -20), (10, -20), (10, -12), (8, 1), (6, -12), (4, 0), (0, 0)]
PEAKS = [(-20, 30), (0, 0), (3, 20), (6, 1), (20, 30), (20, 31), (-20, 31)]
WEDGE = [(0, 0), (3, 0), (5, 4), (6, 4), (6, -1), (-3, -1), (-3, 4), (-2, 4)]
HOLLOW = Region([(0, 0), (9, 0), (9, 9), (0, 9)], [[(1, 1), (4, 1), (4, 4), (1, 4)]])
STAIR = [(0, 0), (1, 0), (1, 1), (2, 1), (2, 2), (3, 2), (3, 3), (0, 3)]


@pytest.mark.parametrize(
    ("g", "d", "factor"),
    [
        (ROOF, PEAKS, Fraction(1)),
        ([(0, 0), (3, 0), (3, 1), (0, 1)], WEDGE, Fraction(1, 7 * 10**30)),
        (STAIR, STAIR, Fraction(10**30, 3)),
        ([(0, 0), (1, 0), (1, 1), (0, 1)], HOLLOW, Fraction(1)),
        ([(0, 0), (3, 0), (3, 3), (0, 3)], HOLLOW, Fraction(1, 3)),
        (STAIR[::-1], HOLLOW, Fraction(1)),
    ],
    ids=["meeting", "wedge", "stairs", "hole", "fit", "holes"],
)
def test_the_page_finds_all_contacts_at_a_stop(
    show: Open, g: Any, d: Any, factor: Fraction
) -> None:
    shapes = [Region(shape).scaled(factor) for shape in (g, d)]
    s = sweep(*shapes, reference=("1/3", 10))
    shown = show(s)
    listed = list_tracks(s)
    for number, found in enumerate(track_stops(s, listed)[0]):
        for k, stop in enumerate(found):
            here = set(s.contacts_at(stop.position))
            touching = shown.tab.evaluate(f"exactsweep.contacts({k}, {number})")
            assert {Contact(*contact) for contact in touching} == here
            brief = shown.tab.evaluate(f"exactsweep.brief({k}, {number})")
            lasting = {*stop.contacts, *found[k - 1].contacts}
            assert {Contact(*c) for c in brief} == without_parts(s, here | lasting) - lasting


@pytest.mark.long
def test_arrows_move_g_after_a_drag(show: Open) -> None:
    shown = show(EXAMPLE)
    shown.tab.focus("#top")
    start, before = shown.position, shown.pixels
    shown.press("ArrowRight")
    assert (shown.position, shown.pixels == before) == (start, False)
    (x, y), (right, _) = shown.pixels[:2]
    middle = ((x + right) / 2, y - (right - x) / 4)
    shown.tab.mouse.move(*middle)
    shown.tab.mouse.down()
    shown.tab.mouse.move(middle[0] + 3, middle[1] + 60, steps=4)
    shown.tab.mouse.up()
    shown.settle()
    dragged = shown.position
    assert dragged != start
    shown.press("ArrowRight")
    assert shown.position != dragged
    # After the picture is dragged, the arrow keys pan it again.
    shown.tab.mouse.move(WIDTH // 3, 30)
    shown.tab.mouse.down()
    shown.tab.mouse.move(WIDTH // 3 + 40, 40, steps=3)
    shown.tab.mouse.up()
    shown.settle()
    at, where = shown.position, shown.pixels
    shown.press("ArrowLeft")
    assert (shown.position, shown.pixels == where) == (at, False)


@pytest.mark.long
def test_the_grid_can_be_hidden(show: Open) -> None:
    shown = show(EXAMPLE)
    shown.tab.focus("#top")
    shown.tab.mouse.move(1, 1)
    gridded = shown.colors()
    shown.press("g")
    plain = shown.colors()
    assert gridded.tobytes() != plain.tobytes()
    shown.press("g")
    assert shown.colors().tobytes() == gridded.tobytes()
    zoomed = ["+"] * 60
    shown.press(*zoomed)
    steps = shown.tab.evaluate("[0.3, 1, 1.1, 2.5, 70].map(exactsweep.roundStep)")
    assert steps == pytest.approx([0.5, 1, 2, 5, 100])


def test_names_are_shown(browser: Any, tmp_path: Path) -> None:
    file = tmp_path / "sweep.html"
    text = make_page(EXAMPLE, names=("house.json", "<b>block</b>.wkt"))
    file.write_text(text, encoding="utf-8")
    shown = Shown(browser, file)
    assert shown.tab.inner_text("h1") == ("house.json around <b>block</b>.wkt: 5 around 7 vertices")
    legend = shown.text("legend")
    assert "generatrix G, house.json;" in legend
    assert "directrix D, <b>block</b>.wkt" in legend
    shown.tab.close()
    assert shown.complaints == []


def test_y_may_point_down(browser: Any, tmp_path: Path) -> None:
    file = tmp_path / "sweep.html"
    file.write_text(make_page(EXAMPLE, y_down=True), encoding="utf-8")
    shown = Shown(browser, file)
    (x0, y0), _, _, (_, roof), _ = shown.pixels
    assert roof > y0
    # G follows the pointer.
    shown.tab.mouse.move(x0 + 5, y0 + 5)
    shown.tab.mouse.down()
    shown.tab.mouse.move(x0 + 5, y0 - 100, steps=5)
    shown.tab.mouse.up()
    shown.settle()
    assert shown.pixels[0][1] < y0
    shown.tab.close()


def test_long_numbers_are_shortened_and_copied_in_full(browser: Any, tmp_path: Path) -> None:
    file = tmp_path / "sweep.html"
    file.write_text(make_page(scale_example(Fraction(10**60, 3 * 7**30))), encoding="utf-8")
    shown = Shown(browser, file, permissions=["clipboard-read", "clipboard-write"])
    area = format_fraction(72 * Fraction(10**60, 3 * 7**30) ** 2)
    assert re.fullmatch(r"\d{28}\u2026\d+\S* \(\d+ characters\)", shown.text("area"))
    assert len(shown.text("area")) < 70 < len(area)
    shown.tab.click("[data-copy=area]")
    shown.tab.wait_for_function("document.querySelector('[data-copy=area]').textContent != 'copy'")
    assert shown.tab.evaluate("navigator.clipboard.readText()") == area
    shown.tab.close()


@pytest.mark.long
def test_more_than_a_thousand_fits_are_visited_in_turn(show: Open) -> None:
    count = 1500
    comb = [(0, 0), (4 * count, 0)]
    for k in reversed(range(count)):
        comb += [(4 * k + 4, 5), (4 * k + 2, 5), (4 * k + 2, 1), (4 * k + 1, 1), (4 * k + 1, 5)]
    s = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], [*comb, (0, 5)])
    shown = show(s)
    shown.press("f", "f")
    assert shown.text("where").startswith("end 0 of exact fit 1")
    assert shown.position == s.exact_fits[1][0]


@pytest.mark.long
def test_the_page_runs_in_the_frame_of_a_notebook(browser: Any, tmp_path: Path) -> None:
    file = tmp_path / "notebook.html"
    file.write_text(f"<!doctype html><p>A cell</p>{EXAMPLE.view()._repr_html_()}")
    tab = browser.new_page()
    complaints: list[str] = []
    tab.on("pageerror", lambda error: complaints.append(str(error)))
    tab.goto(file.as_uri())
    frame = tab.frames[1]
    frame.wait_for_function("window.exactsweep !== undefined")
    assert frame.evaluate("exactsweep.position()") == ["-2", "-1"]
    # The frame cannot access the notebook.
    reached = "(() => { try { return parent.document.title } catch { return null } })()"
    assert frame.evaluate(reached) is None
    tab.close()
    assert complaints == []
