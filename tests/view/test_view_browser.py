"""The interactive page in a real browser: Debian's Chromium, if installed."""

from __future__ import annotations

import re
from fractions import Fraction
from math import ulp

import pytest
from command import EXAMPLE
from shown import HEIGHT, Open, Shown, find_stops, scale_example

from exactsweep import Point, Sweep, sweep
from exactsweep.draw import Scale
from exactsweep.draw.sweeps import trace_anchor

SLOT = sweep(
    [(0, 0), (1, 0), (1, 1), (0, 1)],
    [(0, 0), (3, 0), (3, 5), (2, 5), (2, 1), (1, 1), (1, 3), (0, 3)],
)
PARTS = 1_000_000


def assert_in_place(shown: Shown, s: Sweep, position: Point) -> None:
    """Require that G is drawn at its position, with each coordinate rounded to a float."""
    scale = Scale.of(s.outer.vertices, trace_anchor(s).vertices)
    assert shown.position == position
    exact = [
        scale.place(Point(x + position.x - s.reference.x, y + position.y - s.reference.y))
        for x, y in s.generatrix.vertices
    ]
    wanted = [c for place in exact for c in place]
    for a, b in zip(shown.corners, wanted, strict=True):
        assert abs(Fraction(a) - Fraction(b)) <= 2 * Fraction(ulp(max(map(abs, wanted))))


@pytest.mark.parametrize(
    "factor",
    [
        Fraction(1),
        pytest.param(Fraction(10**30), marks=pytest.mark.long),
        pytest.param(Fraction(1, 7 * 10**30), marks=pytest.mark.long),
    ],
)
def test_the_slider_moves_g_to_exactly_the_right_place(show: Open, factor: Fraction) -> None:
    s = scale_example(factor)
    shown = show(s)
    found = find_stops(s)
    for k, stop in enumerate(found):
        shown.slide(k * PARTS)
        assert_in_place(shown, s, stop.position)
        after = found[(k + 1) % len(found)].position
        shown.slide(k * PARTS + PARTS // 4)
        quarter = ((3 * a + b) / 4 for a, b in zip(stop.position, after, strict=True))
        assert_in_place(shown, s, Point(*quarter))
    shown.slide(len(found) * PARTS)
    assert_in_place(shown, s, found[0].position)


def test_g_is_painted_at_its_position(show: Open) -> None:
    shown = show(EXAMPLE)
    away = shown.colors()
    # Below D; the corners on the right are far from the marks of the contact.
    shown.slide(PARTS + PARTS // 2)
    here = shown.colors()
    corners = shown.pixels
    cx, cy = (sum(values) / len(corners) for values in zip(*corners, strict=True))
    for x, y in corners[1:3]:
        step = 8 / ((cx - x) ** 2 + (cy - y) ** 2) ** 0.5
        within = x + step * (cx - x), y + step * (cy - y)
        beyond = x - step * (cx - x), y - step * (cy - y)
        assert here.getpixel(within) != away.getpixel(within)
        assert here.getpixel(beyond) == away.getpixel(beyond)


def test_keys_zoom_and_move_the_picture(show: Open) -> None:
    shown = show(EXAMPLE)
    before = shown.pixels
    shown.press("+")
    assert shown.pixels != before
    shown.press("-", "0")
    assert shown.pixels == before
    shown.tab.focus("#top")
    shown.press("ArrowRight")
    assert [x - y for (x, _), (y, _) in zip(before, shown.pixels, strict=True)] == [60] * 5
    assert not shown.tab.is_visible("#incomplete")


@pytest.mark.long
def test_playing_moves_g_until_paused(show: Open) -> None:
    shown = show(EXAMPLE)
    start = shown.position
    shown.press(" ")
    shown.tab.wait_for_function(f"exactsweep.position()[0] !== '{start.x}'")
    shown.tab.click("[data-do=play]")
    shown.settle()
    paused = shown.position
    shown.settle()
    assert shown.position == paused
    assert any(contact in shown.text("contacts") for contact in ("EV", "VE", "EE"))


def test_dragging_slides_g_along_the_trajectory(show: Open) -> None:
    shown = show(EXAMPLE)
    (x, y) = (sum(values) / 5 for values in zip(*shown.pixels, strict=True))
    unit = shown.pixels[1][0] - shown.pixels[0][0]
    mouse = shown.tab.mouse
    mouse.move(x, y)
    mouse.down()
    on_path = []
    for k in range(1, 13):
        # Drag straight to the right, through D: G slides along below it.
        mouse.move(x + k * unit / 3, y + unit)
        shown.settle()
        on_path.append(shown.position)
    mouse.up()
    corners = EXAMPLE.trajectory.vertices
    for p in on_path:
        assert any(
            (b.x - a.x) * (p.y - a.y) == (b.y - a.y) * (p.x - a.x) and min(a, b) <= p <= max(a, b)
            for a, b in zip(corners, corners[1:] + corners[:1], strict=True)
        )
    assert [p.x for p in on_path] == sorted(p.x for p in on_path)
    assert on_path[-1].y == -2
    assert 4 < on_path[-1].x < 7


def test_vertices_undercuts_and_fits_have_tips(show: Open) -> None:
    shown = show(EXAMPLE)
    shown.slide(10 * PARTS)
    tip = shown.hover(*shown.pixels[0]).splitlines()
    assert tip[0] == "vertex 0 of G"
    assert {"vertex 6 of the trajectory", "(13/5, 13/5)"} <= set(tip)
    (ax, ay), (bx, _) = shown.pixels[:2]
    unit = (bx - ax) / 2
    below = shown.hover(ax + 0.8 * unit, ay + 0.5 * unit)
    assert below.splitlines() == [
        "undercut 0, area 8/5",
        "extreme contact points (23/5, 13/5) and (13/5, 13/5)",
        "closed by G at (13/5, 13/5)",
    ]
    slot = show(SLOT)
    slot.press("f")
    assert slot.position == SLOT.exact_fits[0][0]
    (x, y), (right, _) = slot.pixels[:2]
    fit = slot.hover(x, y + right - x)
    assert fit == "exact fit 0: G can slide from (1, 3) to (1, 1), touching D on both sides"


def test_a_tap_shows_the_tip_of_a_feature(show: Open) -> None:
    shown = show(SLOT, has_touch=True)
    (x, y), (right, _) = shown.pixels[:2]
    # From (-1, -1), where G is, to (1, 2).
    shown.tab.touchscreen.tap(x + 2 * (right - x), y - 3 * (right - x))
    shown.settle()
    assert shown.text("tip") == shown.text("pointed")
    assert shown.text("pointed").startswith("exact fit 0: ")


def test_vertices_of_g_have_exact_coordinates_between_stops(show: Open) -> None:
    shown = show(scale_example(Fraction(10**30)))
    shown.slide(PARTS + PARTS // 4)
    tip = shown.hover(*shown.pixels[3])
    assert tip.splitlines() == ["vertex 3 of G", f"({2 * 10**30}, 0)"]


@pytest.mark.long
def test_zooming_keeps_the_point_under_the_pointer(show: Open) -> None:
    shown = show(EXAMPLE)
    shown.slide(6 * PARTS)
    (x, y), (x1, _) = before = shown.pixels[:2]
    px, py = round(x), round(y)
    shown.tab.mouse.move(px, py)
    for _ in range(24):
        shown.tab.mouse.wheel(0, -400)
    shown.settle()
    (left, top), (right, _) = shown.pixels[:2]
    ratio = (right - left) / (x1 - x)
    assert ratio > 10**5
    assert abs(left - px - ratio * (x - px)) < 1
    assert abs(top - py - ratio * (y - py)) < 1
    shown.tab.click("[data-do=whole]")
    shown.settle()
    assert shown.pixels[:2] == before


@pytest.mark.long
@pytest.mark.parametrize("s", [EXAMPLE, SLOT], ids=["undercut", "fit"])
def test_light_and_dark_differ_and_follow_the_system(show: Open, s: Sweep) -> None:
    light, dark = (show(s, color_scheme=scheme) for scheme in ("light", "dark"))
    corner = (20, HEIGHT // 2)
    assert sum(light.colors().getpixel(corner)) > 600
    assert sum(dark.colors().getpixel(corner)) < 200
    dark.tab.emulate_media(color_scheme="light")
    assert dark.colors().tobytes() == light.colors().tobytes()


@pytest.mark.long
def test_a_loop_of_10000_vertices_works(show: Open) -> None:
    teeth = [(x, -(x % 2) * 3) for x in range(5001)]
    s = sweep([(0, 0), ("1/4", 0), ("1/8", "1/4")], [*teeth, (5000, 9), (0, 9)])
    assert min(len(s.trajectory), len(s.inner), len(s.outer)) > 10_000
    shown = show(s)
    assert shown.position == s.trajectory.vertices[0]
    shown.slide(5000 * PARTS)
    assert shown.position in s.trajectory.vertices
    assert_in_place(shown, s, shown.position)
    assert shown.tab.is_visible("#incomplete")
    assert re.fullmatch(
        r"and \d+ more; zoom in to see them", shown.hover(*shown.pixels[0]).splitlines()[-1]
    )
    before = shown.position
    shown.press("+", "+", "PageDown")
    assert_in_place(shown, s, shown.position)
    assert shown.position != before


@pytest.mark.long
def test_long_numbers_are_shortened(show: Open) -> None:
    shown = show(scale_example(Fraction(10**30)))
    assert shown.text("area") == f"{72 * 10**60}"
    assert shown.text("area-about") == "about 7.2e61"
    shown.slide(10 * PARTS)
    assert shown.text("position-about") == "about (2.6e30, 2.6e30)"
    short = show(EXAMPLE)
    assert short.text("area-about") == short.text("position-about") == ""
    numbers = {
        "123456789012345678901/123456789": "1e12",
        "-99999999999999999999999/1000000000000000000000": "-100",
        "1/300000000000000000000000000": "3.33333e-27",
        "-1234567/100000000000000000000": "-1.23457e-14",
        "12345/6789": "1.81838",
        "-8/13": "",
    }
    for number, rounded in numbers.items():
        assert shown.tab.evaluate("n => exactsweep.about(n)", number) == rounded


@pytest.mark.long
def test_keys_scroll_in_the_panel(show: Open) -> None:
    shown = show(EXAMPLE)
    shown.tab.focus("summary")
    start = shown.position
    shown.press("PageDown", "ArrowDown", "End")
    assert shown.position == start
    shown.press("u")
    assert shown.position != start
