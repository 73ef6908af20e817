"""The page of a layout in a real browser, if there is one."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from command import run
from drawn_nests import draw_plates, write_dxf


@pytest.fixture
def tab(browser: Any, tmp_path: Path) -> Iterator[Any]:
    nest, page = tmp_path / "nest.dxf", tmp_path / "nest.html"
    nest.write_text(write_dxf(draw_plates({0: ("-2.5", "0"), 11: ("3", "0")})))
    assert run("layout", str(nest), "--html", str(page)).exit_code == 1
    tab = browser.contexts[0].new_page()
    complaints: list[str] = []
    tab.on("console", lambda message: complaints.append(message.text))
    tab.on("pageerror", lambda error: complaints.append(str(error)))
    tab.goto(page.as_uri())
    yield tab
    tab.close()
    assert complaints == []


def find_box(tab: Any) -> list[float]:
    return [float(word) for word in tab.get_attribute("#picture", "viewBox").split()]


def test_a_click_shows_one_fault(tab: Any) -> None:
    whole = find_box(tab)
    tab.click("#next")
    assert tab.text_content("#status").startswith("1: overlap, 11 plate11")
    assert find_box(tab)[2] < whole[2] / 1.5
    assert tab.locator(".found").count() == 2
    tab.click("#next")
    assert tab.text_content("#status").startswith("2: outside, 0 plate00")
    tab.click("tr[data-parts] >> nth=0")
    assert tab.text_content("#status").startswith("1: overlap")
    tab.click("#all")
    assert find_box(tab) == whole


def test_a_part_is_found_by_its_name(tab: Any) -> None:
    for word, found in (("plate07", "7 plate07"), ("13 plate13", "13 plate13")):
        tab.fill("#find", word)
        tab.press("#find", "Enter")
        assert tab.text_content("#status") == found
        assert tab.get_attribute(".found", "data-name") == found
    tab.fill("#find", "nothing")
    tab.press("#find", "Enter")
    assert tab.text_content("#status") == "no part nothing"


def test_the_wheel_and_the_pointer_zoom_and_pan(tab: Any) -> None:
    whole, frame = find_box(tab), tab.locator("#picture").bounding_box()
    x, y = frame["x"] + frame["width"] / 2, frame["y"] + frame["height"] / 2
    tab.mouse.move(x, y)
    tab.mouse.wheel(0, -600)
    near = find_box(tab)
    assert abs(near[2] - whole[2] / 4) < 1
    tab.mouse.down()
    tab.mouse.move(x + 100, y)
    tab.mouse.up()
    moved = find_box(tab)
    assert moved[0] < near[0]
    assert moved[2] == near[2]
    tab.keyboard.press("0")
    assert find_box(tab) == whole


def test_a_narrow_screen_needs_no_horizontal_scrolling(tab: Any) -> None:
    tab.set_viewport_size({"width": 390, "height": 800})
    assert tab.evaluate("document.documentElement.scrollWidth") <= 390
