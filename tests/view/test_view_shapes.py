"""The page of polygons of any shape: along the trajectory, around holes and into exact fits."""

from __future__ import annotations

import pytest
from contacts import between, without_parts
from hypothesis import given
from shown import Open, Shown
from strategies import points, simple_polygons
from tiers import examples

from exactsweep import Polygon, Region, sweep
from exactsweep.view.data import list_tracks, track_stops

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
# Holes in which the square moves freely, slides, and fits exactly.
PLATE = Region(
    [(0, 0), (20, 0), (20, 12), (0, 12)],
    [
        [(2, 2), (7, 2), (7, 6), (2, 6)],
        [(9, 2), (11, 2), (11, 10), (9, 10)],
        [(13, 3), (15, 3), (15, 5), (13, 5)],
    ],
)
EXAMPLE = sweep(SQUARE, PLATE)
NAMES = ["the trajectory", "hole 0", "exact fit 0", "exact fit 1"]


def drag(shown: Shown, position: tuple[int, int], steps: int = 12) -> None:
    """Drag G by its middle until its reference point is at a position."""
    (x, y), (right, _) = shown.pixels[:2]
    unit = (right - x) / 2
    at = shown.position
    middle = x + unit, y - unit
    shown.tab.mouse.move(*middle)
    shown.tab.mouse.down()
    dx, dy = (float(b - a) for a, b in zip(at, position, strict=True))
    shown.tab.mouse.move(middle[0] + dx * unit + 2, middle[1] - dy * unit + 2, steps=steps)
    shown.tab.mouse.up()
    shown.settle()


def track_of(shown: Shown) -> str:
    name: str = shown.tab.evaluate("exactsweep.track()")
    return name


@examples(15)
@given(simple_polygons(), simple_polygons())
def test_contacts_between_stops_of_every_track_are_correct(g: Polygon, d: Polygon) -> None:
    s = sweep(g, d, reference=(1, "1/3"))
    listed = list_tracks(s)
    for track, found in zip(listed, track_stops(s, listed)[0], strict=True):
        corners = [stop.position for stop in found if stop.vertex is not None]
        assert corners == list(track.corners)
        for stop, following in list(zip(found, found[1:] + found[:1], strict=True))[:8]:
            if len(found) == 1:
                assert not stop.contacts
                continue
            here = s.contacts_at(between(stop.position, following.position))
            assert without_parts(s, here) == set(stop.contacts)


@pytest.mark.long
def test_g_can_be_played_on_every_track(show: Open) -> None:
    shown = show(EXAMPLE)
    for name in NAMES:
        assert track_of(shown) == name
        shown.press("Space")
        shown.tab.wait_for_timeout(60)
        shown.press("Space")
        assert track_of(shown) == name
        shown.press("t")
    assert track_of(shown) == NAMES[0]


def test_g_is_dragged_into_holes_and_fits_and_out_again(show: Open) -> None:
    shown = show(EXAMPLE)
    drag(shown, (13, 3))
    assert (track_of(shown), shown.position) == ("exact fit 1", points((13, 3))[0])
    assert shown.text("where") == "exact fit 1, a single position"
    drag(shown, (9, 5))
    assert track_of(shown) == "exact fit 0"
    assert shown.position.x == 9
    drag(shown, (5, 4))
    assert (track_of(shown), shown.position) == ("hole 0", points((5, 4))[0])
    # Far from all tracks, G stays at the nearest point of its track.
    drag(shown, (6, 8), steps=1)
    assert track_of(shown) == "hole 0"
    assert shown.position.y == 4
    drag(shown, (20, 12))
    assert (track_of(shown), shown.position) == ("the trajectory", points((20, 12))[0])


def test_holes_of_d_and_g_are_not_painted(show: Open) -> None:
    ring = Region([(0, 0), (6, 0), (6, 6), (0, 6)], [[(2, 2), (4, 2), (4, 4), (2, 4)]])
    shown = show(sweep(ring, PLATE))
    (x, y), (right, _) = shown.pixels[:2]
    unit = (right - x) / 6
    colors = shown.colors()
    middle, rim = (x + 3 * unit, y - 3 * unit), (x + unit, y - 4.5 * unit)
    assert colors.getpixel(middle) != colors.getpixel(rim)
    # G can only be dragged by its material, not by its hole.
    shown.tab.mouse.move(*middle)
    shown.settle()
    assert "on-generatrix" not in str(shown.tab.get_attribute("#top", "class") or "")
    shown.tab.mouse.move(*rim)
    shown.settle()
    assert "on-generatrix" in str(shown.tab.get_attribute("#top", "class"))


def test_a_single_track_has_no_selector(show: Open) -> None:
    shown = show(sweep(SQUARE, SQUARE))
    assert not shown.tab.is_visible("#track")
    assert not shown.tab.is_visible("#hole")
