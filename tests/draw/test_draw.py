"""Pictures of sweeps and chains."""

import sys
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from command import EXAMPLE
from matplotlib import pyplot
from matplotlib.axes import Axes
from strategies import points

from exactsweep import Sweep, sweep
from exactsweep.canvas import style
from exactsweep.draw import (
    DrawError,
    make_figure,
    plot_sweep,
    save,
)
from exactsweep.draw.sweeps import find_anchor


@pytest.fixture(autouse=True)
def no_windows() -> Iterator[None]:
    pyplot.switch_backend("Agg")
    pyplot.close("all")  # what an example of a README.md left open
    yield
    pyplot.close("all")


def picture_of(s: Sweep, **options: Any) -> Axes:
    return plot_sweep(s, make_figure().axes[0], **options)


def labels(axes: Axes) -> list[str]:
    legend = axes.get_legend()
    assert legend is not None
    return [text.get_text() for text in legend.get_texts()]


def corners(axes: Axes, label: str) -> list[tuple[float, float]]:
    """The vertices of all areas and lines with a label."""
    areas: list[Any] = [p.get_path().vertices for p in axes.patches if p.get_label() == label]
    lines: list[Any] = [p.get_xydata() for p in axes.lines if p.get_label() == label]
    # NaNs separate the chains of a line.
    shapes = [area[:-1] for area in areas] + lines
    return [(float(x), float(y)) for shape in shapes for x, y in shape if x == x]


def scaled(s: Sweep, factor: Fraction) -> Sweep:
    g, d = ([(x * factor, y * factor) for x, y in p.vertices] for p in (s.generatrix, s.directrix))
    return sweep(g, d)


@pytest.mark.parametrize("exponent", [30, -30, 900])
def test_size_changes_labels_only(exponent: int) -> None:
    plain, large = picture_of(EXAMPLE), picture_of(scaled(EXAMPLE, Fraction(10) ** exponent))
    assert large.get_xlabel() == rf"$x\,/\,10^{{{exponent}}}$"
    assert labels(plain) == labels(large)
    for label in labels(plain):
        assert corners(plain, label) == corners(large, label)


def test_a_reference_point_is_far_beyond_both_sizes() -> None:
    triangle = [(0, 0), (1, 0), (0, 1)]
    for x, y in ((-2, 0), (3, 0), (0, -2), (0, 3)):
        at, beyond = points((x, y), (Fraction(9 * x, 8), Fraction(9 * y, 8)))
        assert find_anchor(sweep(triangle, triangle, reference=at)) == at
        assert find_anchor(sweep(triangle, triangle, reference=beyond)) == points((0, 0))[0]


def test_plot_uses_given_axes_or_a_new_figure() -> None:
    axes = EXAMPLE.plot()
    assert pyplot.get_fignums() == [1]
    _, mine = pyplot.subplots()
    assert EXAMPLE.plot(mine, positions=[]) is mine
    assert axes is not mine
    assert "generatrix G" not in labels(mine)


def test_no_two_things_differ_by_color_alone() -> None:
    looks = [*style.EVENTS.values(), style.SEVERAL_EVENTS, style.INNER, style.OUTER]
    assert len({(look.width, str(look.dash)) for look in looks}) == len(looks)
    solid = [style.EVENTS["EV"], style.INNER, style.EXACT_FIT]
    assert len({(look.marker, look.width) for look in solid}) == len(solid)
    areas = [style.DIRECTRIX, style.GENERATRIX, style.UNDERCUT]
    assert len({(look.width, look.hatch) for look in areas}) == len(areas)
    assert len({look.marker for look in style.CONTACTS.values()}) == len(style.CONTACTS)
    chains = [style.choose_chain_look(k) for k in range(7)]
    assert len({(look.marker, str(look.dash)) for look in chains}) == len(chains)


@pytest.mark.parametrize("suffix", ["svg", pytest.param("pdf", marks=pytest.mark.long), "png"])
def test_files_are_the_same_byte_by_byte(tmp_path: Path, suffix: str) -> None:
    paths = [tmp_path / f"{name}.{suffix}" for name in "ab"]
    for path in paths:
        figure = make_figure()
        plot_sweep(EXAMPLE, figure.axes[0])
        save(figure, str(path))
    first, second = (path.read_bytes() for path in paths)
    assert first == second
    assert len(first) > 3000
    if suffix == "svg":
        assert ElementTree.fromstring(first).tag == "{http://www.w3.org/2000/svg}svg"


def test_without_matplotlib_the_error_states_how_to_install_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(DrawError, match=r"pip install matplotlib"):
        EXAMPLE.plot()
    with pytest.raises(DrawError, match="a picture needs matplotlib"):
        make_figure()
