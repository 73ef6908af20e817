"""Pictures and tables in notebooks."""

import re
import subprocess
import sys
from html import unescape
from html.parser import HTMLParser
from typing import Any
from xml.etree import ElementTree

from command import EXAMPLE, PATIENCE
from hypothesis import given
from strategies import pairs, simple_polygons
from tiers import examples

from exactsweep import Polygon, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.view import make_page

SVG = "{http://www.w3.org/2000/svg}"
VOID = {"meta", "link", "input"}


class Balanced(HTMLParser):
    """A parser that rejects unbalanced tags and collects the text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.texts: list[str] = []
        self.feed(text)
        self.close()
        assert not self.open

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.texts.append(data)


def inside(picture: ElementTree.Element) -> bool:
    """Decide whether all shapes are inside the picture."""
    width, height = (float(picture.attrib[name]) for name in ("width", "height"))
    data = "".join(path.attrib["d"] for path in picture.iterfind(f"{SVG}path"))
    for letter in "MLZ":
        data = data.replace(letter, " ")
    numbers = list(map(float, data.split()))
    return all(0 <= x <= width for x in numbers[::2]) and all(
        0 <= y <= height for y in numbers[1::2]
    )


@examples(50)
@given(simple_polygons())
def test_every_polygon_has_a_picture(polygon: Polygon) -> None:
    assert inside(ElementTree.fromstring(polygon._repr_svg_()))
    Balanced(polygon._repr_html_())


@examples(40)
@given(pairs("CC") | pairs("CM") | pairs("MM"))
def test_every_sweep_has_a_picture(pair: tuple[Polygon, Polygon]) -> None:
    s = sweep(*pair)
    assert inside(ElementTree.fromstring(s._repr_svg_()))
    Balanced(s._repr_html_())


def test_a_polygon_is_drawn_upright() -> None:
    (path,) = ElementTree.fromstring(
        Polygon([(0, 0), (2, 0), (2, 1), (0, "1/2")])._repr_svg_()
    ).iterfind(f"{SVG}path")
    assert path.attrib["d"] == "M12.00 259.00L408.00 259.00L408.00 61.00L12.00 160.00Z"


def test_matplotlib_is_not_needed() -> None:
    program = (
        "import sys; sys.modules['matplotlib'] = None\n"
        "from exactsweep import sweep\n"
        "s = sweep([(0, 0), (1, 0), (0, 1)], [(0, 0), (1, 0), (0, 1)])\n"
        "print(s._repr_svg_()[:4], s.directrix._repr_html_()[:4])\n"
    )
    run = subprocess.run(
        [sys.executable, "-c", program],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=True,
    )
    assert run.stdout == "<svg <div\n"


def test_notebooks_show_the_page_in_a_frame() -> None:
    view = EXAMPLE.view(height=300)
    Balanced(view._repr_html_())
    (frame,) = re.findall(r"<iframe .*</iframe>", view._repr_html_(), re.S)
    assert unescape(re.findall(r'srcdoc="([^"]*)"', frame)[0]) == view.html == make_page(EXAMPLE)
    assert 'sandbox="allow-scripts"' in frame
    assert "height:300px" in frame
    assert repr(view) == "<InlinePage: Sweep of 5 around 7 vertices>"


@examples(25)
@given(simple_polygons(), simple_polygons())
def test_every_answer_has_a_picture_in_a_notebook(d: Polygon, g: Polygon) -> None:
    for found in (no_fit_polygon(d, g), inner_fit_polygon(d, g)):
        assert inside(ElementTree.fromstring(found._repr_svg_()))
        Balanced(found._repr_html_())
