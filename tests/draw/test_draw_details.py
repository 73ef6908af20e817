"""Distinct colors, details of unequal and flat pairs, legends, text, the Y direction."""

import re
from fractions import Fraction
from itertools import combinations
from math import dist
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from command import EXAMPLE, run
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from tiers import examples

from exactsweep import Polygon, Sweep, sweep
from exactsweep.canvas import style
from exactsweep.draw import (
    choose_telling_positions,
    make_figure,
    plot_sweep,
)
from exactsweep.draw.picture import find_details

# Colors in linear light as seen by normal, green-blind and red-blind readers: Machado, Oliveira and
# Fernandes (2009), severity 1.
EYES = {
    "all": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "deuteranopia": (
        (0.367322, 0.860646, -0.227968),
        (0.280085, 0.672501, 0.047413),
        (-0.011820, 0.042940, 0.968881),
    ),
    "protanopia": (
        (0.152286, 1.052583, -0.204868),
        (0.114503, 0.786281, 0.099216),
        (-0.003882, -0.048116, 1.051998),
    ),
}
# In CIE Lab, a difference of 2.3 is just noticeable.
APART = 14

UNIT = [(0, 0), (1, 0), (1, 1), ("1/2", 2), (0, 1)]
# A notch and a slot as wide as the unit, in a plate a thousand times as long.
PLATE = [(0, 0), (1000, 0), (1000, 600), (600, 600), (599, 598), (598, 600), (300, 600)]
PLATE += [(300, 100), (299, 100), (299, 600), (0, 600)]
UNEQUAL = sweep(UNIT, PLATE)
FLAT = sweep(
    [(0, 0), (30, 0), (30, "1/20"), (0, "1/10")],
    [(0, 0), (100, 0), (100, "1/5"), (60, "1/5"), (50, "1/20"), (40, "1/5"), (0, "1/5")],
)
COMB = [(0, 0), (40, 0), *((40 - k, 6 + k % 2 * 3) for k in range(41))]


def lab(color: str, eye: str) -> tuple[float, float, float]:
    """Return the CIE Lab coordinates of a color, for white of daylight."""
    parts = [int(color[k : k + 2], 16) / 255 for k in (1, 3, 5)]
    light = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    seen = [sum(m * c for m, c in zip(row, light, strict=True)) for row in EYES[eye]]
    r, g, b = (min(1.0, max(0.0, c)) for c in seen)
    rows = ((0.4339, 0.3762, 0.1899), (0.2126, 0.7152, 0.0722), (0.0177, 0.1095, 0.8729))
    ratios = [x * r + y * g + z * b for x, y, z in rows]
    a, o, c = (t ** (1 / 3) if t > 0.008856 else 7.787 * t + 16 / 116 for t in ratios)
    return 116 * o - 16, 500 * (a - o), 200 * (o - c)


def too_near(colors: dict[str, str]) -> list[tuple[str, str, str]]:
    return [
        (eye, one, other)
        for eye in EYES
        for one, other in combinations(sorted(colors), 2)
        if dist(lab(colors[one], eye), lab(colors[other], eye)) < APART
    ]


def lines_of(palette: dict[str, str]) -> dict[str, str]:
    return {
        name: color
        for name, color in palette.items()
        if not name.endswith("-fill") and name != "swept"
    }


@pytest.mark.parametrize("palette", [style.LIGHT, style.DARK], ids=["light", "dark"])
def test_colors_are_distinguishable_for_color_blind_readers(palette: dict[str, str]) -> None:
    assert palette.keys() == style.LIGHT.keys()
    assert too_near(lines_of(palette)) == []
    # The former colors fail: EV had the color of G, VE that of undercuts, VV that of fits.
    assert too_near({**lines_of(palette), "EV": palette["generatrix"]})
    assert too_near({"D": "#5f5f5f", "VE": "#882255"})


def test_colors_of_judged_and_exact_things_differ() -> None:
    shown = {name: style.LIGHT[name] for name in ("directrix", "generatrix", "path")}
    assert too_near(shown | style.JUDGED) == []
    assert not set(style.JUDGED.values()) & set(style.LIGHT.values())


def drawn(s: Sweep, **options: Any) -> Axes:
    return plot_sweep(s, make_figure().axes[0], **options)


def details(axes: Axes) -> list[Axes]:
    return [child for child in axes.child_axes if isinstance(child, Axes)]


def test_the_small_one_may_be_the_directrix() -> None:
    small, big = Polygon(UNIT), Polygon(PLATE)
    assert len(details(drawn(sweep(big, small), positions=[(0, 0), (-1000, 0)]))) == 1
    assert [d.side for d in find_details(big.vertices, small, [big], [])] == [5]


@pytest.mark.parametrize("exponent", [9, 5000])
def test_no_ratio_is_too_large(exponent: int) -> None:
    big = [(x * 10**exponent, y * 10**exponent) for x, y in [(0, 0), (1, 0), (0, 1)]]
    assert drawn(sweep(UNIT, big)).get_legend() is not None


def test_undercuts_that_are_shown_are_far_apart() -> None:
    s = sweep([(0, 0), (1, "-1/2"), (2, 0), (2, 3), (1, "7/2"), (0, 3)], COMB)
    assert len(s.undercuts) > 15
    *shown, corner = choose_telling_positions(s)
    assert corner == s.trajectory.vertices[0]
    first, second = shown
    closing = {undercut.positions[0] for undercut in s.undercuts}
    assert {first, second} <= closing
    assert first == max(closing, key=lambda p: (p.x - corner.x) ** 2 + (p.y - corner.y) ** 2)
    # No other undercut is farther from both.
    nearer = [
        min((p.x - q.x) ** 2 + (p.y - q.y) ** 2 for q in (first, corner))
        for p in (second, *closing)
    ]
    assert nearer[0] == max(nearer)


@pytest.mark.parametrize("s", [EXAMPLE, UNEQUAL, FLAT], ids=["plain", "unequal", "flat"])
@pytest.mark.parametrize("size", [None, (9, 3)])
def test_the_legend_is_never_taller_than_the_picture(
    s: Sweep, size: tuple[float, float] | None
) -> None:
    figure = make_figure(size=size)
    axes = plot_sweep(s, figure.axes[0])
    require_lower_legend(axes)


@examples(6)
@given(st.integers(1, 140), st.booleans())
def test_legends_of_wide_and_tall_pictures_are_no_taller_than_the_picture(
    width: int, upright: bool
) -> None:
    sides = (Fraction(width, 10), Fraction(1))
    x, y = sides[::-1] if upright else sides
    require_lower_legend(drawn(sweep(UNIT, [(0, 0), (10 * x, 0), (10 * x, 10 * y), (0, 10 * y)])))


def require_lower_legend(axes: Axes) -> None:
    figure: Any = axes.figure
    figure.draw_without_rendering()
    legend: Any = axes.get_legend()
    box, picture = legend.get_window_extent(), axes.get_window_extent()
    bottom = min([picture.y0, *(child.get_window_extent().y0 for child in details(axes))])
    if box.x0 >= picture.x1:
        assert box.height <= picture.y1 - bottom + 1
    else:
        # Below the picture, in several columns, where it hides nothing, either.
        assert box.y1 <= bottom
        assert len(legend.get_texts()) > legend._ncols > 1


def test_an_svg_has_real_text_a_title_and_a_size(tmp_path: Path) -> None:
    path = tmp_path / "out.svg"
    title = "50 $ & <b>: a^b_c $x$"
    result = run("draw", "-o", str(path), "--title", title, "--size", "5", "4")
    assert (result.exit_code, result.output) == (0, "")
    root = ElementTree.fromstring(path.read_bytes())
    texts = {"".join(text.itertext()) for text in root.iter("{http://www.w3.org/2000/svg}text")}
    assert {title, "trajectory, VE", "undercut"} <= texts
    (width,) = re.findall(r"([\d.]+)pt", root.get("width", ""))
    wide = tmp_path / "wide.svg"
    run("draw", "-o", str(wide), "--size", "10", "8")
    assert float(width) < float(re.findall(r'width="([\d.]+)pt"', wide.read_text())[0])


def test_svg_input_is_drawn_with_y_down(tmp_path: Path) -> None:
    drawing = tmp_path / "parts.SVG"
    drawing.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg"><path id="d" d="M0 0h8v5h-8z"/>'
        '<path id="g" d="M0 0h2v1z"/></svg>'
    )
    pair = (f"{drawing}#g", f"{drawing}#d")
    out = {name: str(tmp_path / f"{name}.svg") for name in ("given", "up", "down")}
    run("draw", *pair, "-o", out["given"])
    run("draw", *pair, "--y-up", "-o", out["up"])
    run("draw", *pair, "--y-down", "-o", out["down"])
    given_, up, down = (Path(path).read_bytes() for path in out.values())
    assert given_ == down != up
    axes = drawn(EXAMPLE, y_down=True)
    assert axes.yaxis_inverted()
    assert all(detail.yaxis_inverted() for detail in details(drawn(UNEQUAL, y_down=True)))


def test_the_layout_of_given_figures_is_unchanged() -> None:
    left, right = make_figure(columns=2).axes
    places = [tuple(axes.get_position(original=True).bounds) for axes in (left, right)]
    plot_sweep(UNEQUAL, left)
    assert [tuple(a.get_position(original=True).bounds) for a in (left, right)] == places
    parts: Any = Figure().subfigures(1, 2)
    assert plot_sweep(EXAMPLE, parts[0].subplots()).get_legend() is not None


@pytest.mark.parametrize(("size", "enlarged"), [(24, 0), (25, 1), (10**9 - 1, 1), (10**9, 0)])
def test_small_polygons_are_enlarged_as_far_as_floats_show_them(size: int, enlarged: int) -> None:
    big, small = (Polygon([(0, 0), (n, 0), (0, n)]).translated((5, 5)) for n in (size, 1))
    assert len(find_details(big.vertices, big, [small], [])) == enlarged
