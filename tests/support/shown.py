"""The interactive page in a browser."""

from __future__ import annotations

import io
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

from command import EXAMPLE, PATIENCE

from exactsweep import Point, Sweep, sweep
from exactsweep.numbers.number import to_fraction
from exactsweep.view.data import Stop, list_tracks, track_stops

FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
WIDTH, HEIGHT = 1000, 640
SIZE = {"width": WIDTH, "height": HEIGHT}
MILLISECONDS = 1000 * PATIENCE


class Shown:
    """A page in the browser, and its error messages."""

    def __init__(self, browser: Any, file: Path, **options: Any) -> None:
        self.complaints: list[str] = []
        self.requests: list[str] = []
        # A tab in the existing context takes half the time of one with a new context.
        context = browser if options else browser.contexts[0]
        self.tab = context.new_page(**({"viewport": SIZE, **options} if options else {}))
        self.tab.set_default_timeout(MILLISECONDS)
        self.tab.on("console", lambda message: self.complaints.append(message.text))
        self.tab.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.tab.on("request", lambda request: self.requests.append(request.url))
        self.tab.goto(file.as_uri())
        self.settle()

    def settle(self) -> None:
        """Wait until the page is drawn and its texts are written."""
        # The next frame draws the findings of one frame, such as the size.
        self.tab.evaluate(
            "() => new Promise(f => requestAnimationFrame(() => requestAnimationFrame("
            "() => setTimeout(f))))"
        )

    def press(self, *keys: str) -> None:
        for key in keys:
            self.tab.keyboard.press(key)
        self.settle()

    def slide(self, value: int) -> None:
        self.tab.evaluate(
            "value => { const s = document.getElementById('slider'); s.value = value;"
            " s.dispatchEvent(new Event('input', {bubbles: true})); }",
            value,
        )
        self.settle()

    def hover(self, x: float, y: float) -> str:
        self.tab.mouse.move(x, y)
        self.settle()
        return self.text("tip") if self.tab.is_visible("#tip") else ""

    def text(self, identity: str) -> str:
        text: str = self.tab.inner_text(f"#{identity}")
        return text

    @property
    def position(self) -> Point:
        x, y = self.tab.evaluate("exactsweep.position()")
        return Point(to_fraction(x), to_fraction(y))

    @property
    def corners(self) -> list[float]:
        found: list[float] = self.tab.evaluate("exactsweep.corners()")
        return found

    @property
    def pixels(self) -> list[tuple[float, float]]:
        """The corners of G on the screen."""
        flat = self.tab.evaluate("exactsweep.pixels()")
        return list(zip(flat[::2], flat[1::2], strict=True))

    def colors(self) -> Any:
        from PIL import Image

        self.settle()
        return Image.open(io.BytesIO(self.tab.screenshot())).convert("RGB")


Open = Callable[..., Shown]
"""Opens the page of a sweep; takes the options of a tab."""


def find_stops(s: Sweep) -> list[Stop]:
    """Find all stops of the trajectory."""
    found, _ = track_stops(s, list_tracks(s)[:1])
    return found[0]


def scale_example(factor: Fraction) -> Sweep:
    g, d = EXAMPLE.generatrix, EXAMPLE.directrix
    return sweep(*([(x * factor, y * factor) for x, y in p.vertices] for p in (g, d)))
