"""Pages and pictures of no-fit polygons and of inner fits."""

import json
import re
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from command import refusal, run
from hypothesis import given
from shown import Open
from strategies import simple_polygons
from tiers import examples

from exactsweep import (
    InnerFit,
    NoFitPolygon,
    Point,
    Polygon,
    Region,
    inner_fit_polygon,
    no_fit_polygon,
    sweep,
)
from exactsweep.draw import make_figure, plot_positions, save_svg
from exactsweep.draw.no_fits import Positions
from exactsweep.geometry.vectors import is_between
from exactsweep.numbers.digits import format_fraction
from exactsweep.view.data import gather_page_data, gather_positions

PLATE = Region([(0, 0), (9, 0), (9, 9), (0, 9)], [[(2, 2), (7, 2), (7, 4), (2, 4)]])
PART = Polygon([(0, 0), (2, 0), (2, 1), (0, 1)])
TIGHT = Polygon([(0, 0), (2, 0), (2, 2), (0, 2)])


def is_inside_an_edge(t: Point, loop: Polygon) -> bool:
    corners = loop.vertices
    return any(is_between(t, corners[k - 1], corners[k]) for k in range(len(corners)))


@pytest.mark.parametrize("answer", [no_fit_polygon, inner_fit_polygon])
@pytest.mark.parametrize("part", [PART, TIGHT, Polygon([(0, 0), (1, 0), ("1/2", 2)])])
def test_meetings_of_vertices_inside_edges_are_stops(
    answer: Callable[..., NoFitPolygon | InnerFit], part: Polygon
) -> None:
    found = answer(PLATE, part)
    tracks = gather_positions(found)["tracks"]
    stops = {
        Point(*map(Fraction, track["exact"][2 * k : 2 * k + 2]))
        for track in tracks
        for k, vertex in enumerate(track["vertex"])
        if vertex is None and not track["name"].startswith("exact fit")
    }
    corners = [corner for ring in PLATE.rings for corner in ring]
    met = {Point(p.x - q.x, p.y - q.y) for p in corners for q in part.vertices}
    loops = Positions.of(found).loops
    assert stops == {t for t in met if any(is_inside_an_edge(t, loop) for loop in loops)}
    assert stops


@pytest.fixture
def files(tmp_path: Path) -> tuple[str, str]:
    exterior, hole = [[0, 0], [9, 0], [9, 9], [0, 9]], [[2, 2], [7, 2], [7, 4], [2, 4]]
    plate = {"exterior": exterior, "holes": [hole]}
    (tmp_path / "plate.json").write_text(json.dumps(plate))
    (tmp_path / "part.json").write_text("[[0, 0], [2, 0], [2, 1], [0, 1]]")
    return str(tmp_path / "plate.json"), str(tmp_path / "part.json")


@pytest.mark.parametrize("asked", ["nfp", "ifp"])
def test_commands_show_positions(asked: str, files: tuple[str, str], tmp_path: Path) -> None:
    done = run("view", "--of", asked, *files)
    assert done.exit_code == 0
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', done.stdout)
    assert found is not None
    data = json.loads(found[1])
    assert data["names"] == [files[1], files[0]]
    where = " around " if asked == "nfp" else " in "
    assert data["title"] == f"{files[1]}{where}{files[0]}: 4{where}8 vertices"
    picture = tmp_path / "a.svg"
    assert run("draw", "--of", asked, *files, "-o", str(picture)).exit_code == 0
    figure = make_figure()
    answer = no_fit_polygon if asked == "nfp" else inner_fit_polygon
    plot_positions(answer(PLATE, PART), figure.axes[0])
    assert picture.read_text() == save_svg(figure)
    assert run("view", "--of", asked).exit_code == 0


def test_questions_without_a_picture_are_rejected(files: tuple[str, str]) -> None:
    message = refusal(run("view", "--of", "ifp", files[1], files[0]))
    assert message == "there is no position: the part does not fit"
    done = run("view", "--of", "nfp", *files, "--direction", "1", "0")
    assert done.exit_code == 2
    assert "--direction is for sweeps" in done.stderr


def test_the_page_names_contacts_of_positions(show: Open) -> None:
    page = show(inner_fit_polygon(PLATE, PART))
    assert page.text("contacts").splitlines()
    assert page.text("area") == "35"
    page.press("t", "PageDown")
    assert page.text("contacts").splitlines()


def test_a_phone_shows_all_controls(show: Open) -> None:
    page = show(sweep(TIGHT, PLATE))
    page.tab.set_viewport_size({"width": 390, "height": 800})
    page.settle()
    sizes = "() => [document.documentElement.scrollWidth, ...[...document.querySelectorAll("
    sizes += "'#player *, #zooming *')].map((e) => e.getBoundingClientRect().right)]"
    assert page.tab.is_visible("#track")
    assert max(page.tab.evaluate(sizes)) <= 390


def test_a_tiny_generatrix_is_found(show: Open) -> None:
    tiny = PART.scaled(Fraction(1, 10**6))
    page = show(sweep(tiny, PLATE))
    page.press("z")
    xs, ys = zip(*page.pixels, strict=True)
    assert max(xs) - min(xs) > 100
    assert 0 < min(xs) < max(xs) < 1000
    assert 0 < min(ys) < max(ys) < 640


def test_the_note_on_scale_covers_no_label(show: Open) -> None:
    flat = Polygon([(0, 0), (400, 0), (400, 5), (0, 5)])
    page = show(sweep(PART, flat))
    for width in (1000, 390):
        page.tab.set_viewport_size({"width": width, "height": 640})
        page.settle()
        note = page.tab.locator("#stretched").bounding_box()
        buttons = page.tab.locator("#zooming").bounding_box()
        # Numbers are at the lower edge, and at the right edge from 46 pixels down.
        assert note["y"] + note["height"] <= 56
        assert note["x"] >= buttons["x"] + buttons["width"]


@pytest.mark.long
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_names_of_contacts_have_the_contrast_of_text(scheme: str, show: Open) -> None:
    page = show(sweep(TIGHT, PLATE), color_scheme=scheme)
    look = (
        "(e) => [getComputedStyle(e).color, getComputedStyle(e.closest('aside')).backgroundColor]"
    )
    found = [page.tab.evaluate(look, b) for b in page.tab.query_selector_all("#contacts b")]
    assert found
    for colors in found:
        light, dark = sorted(map(_luminance, colors), reverse=True)
        assert (light + 0.05) / (dark + 0.05) >= 4.5


def _luminance(color: str) -> float:
    """The relative luminance of a color, by WCAG 2."""
    shares = [int(part) / 255 for part in re.findall(r"[0-9]+", color)[:3]]
    red, green, blue = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in shares)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def list_stops(data: dict[str, Any]) -> dict[str, set[tuple[str, str]]]:
    tracks = {track["name"]: track["exact"] for track in data["tracks"]}
    exterior = tracks.pop("the trajectory", None) or tracks.pop("the exterior")
    return {
        name: set(zip(exact[::2], exact[1::2], strict=True))
        for name, exact in {**tracks, "exterior": exterior}.items()
    }


@given(simple_polygons(), simple_polygons())
@examples(40)
def test_a_no_fit_polygon_has_the_stops_of_the_sweep(g: Polygon, d: Polygon) -> None:
    s = sweep(g, d)
    closing = {tuple(map(format_fraction, p)) for one in s.undercuts for p in one.positions}
    stops = list_stops(gather_positions(no_fit_polygon(d, g)))
    expected = list_stops(gather_page_data(s))
    assert stops.keys() == expected.keys()
    for name, positions in expected.items():
        assert positions - closing <= stops[name] <= positions
