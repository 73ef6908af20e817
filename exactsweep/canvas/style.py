"""The style of all pictures, for print and for color-blind readers.

A color has the same meaning in all pictures and pages. A test checks that readers with red-green
color blindness can distinguish them. Lines and areas also differ in width, dashes, hatching or
markers, for black-and-white prints. Numbered items have the colors of Okabe and Ito.
"""

import tomllib
from contextlib import AbstractContextManager
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

BLACK = "#000000"
GRAY = "#5f5f5f"
ORANGE = "#e69f00"
SKY = "#56b4e9"
GREEN = "#009e73"
YELLOW = "#f0e442"
BLUE = "#0072b2"
RED = "#d55e00"
PURPLE = "#cc79a7"

PALETTE = (BLUE, RED, GREEN, PURPLE, ORANGE, SKY, BLACK)
"""The colors of numbered items, such as chains."""

_DATA: dict[str, Any] = tomllib.loads(
    files("exactsweep.canvas").joinpath("style.toml").read_text(encoding="utf-8")
)
# Colors on a light and on a dark background; the colors of an external answer suit both.
LIGHT: dict[str, str] = _DATA["light"]
DARK: dict[str, str] = _DATA["dark"]
JUDGED: dict[str, str] = _DATA["judged"]


def write_style_sheet() -> str:
    """Write all colors as CSS variables, for light and dark backgrounds."""
    light, dark = (
        " ".join(f"--{name}: {color};" for name, color in (palette | JUDGED).items())
        for palette in (LIGHT, DARK)
    )
    scheme = "@media (prefers-color-scheme: dark)"
    return f":root {{ {light} }}\n{scheme} {{ :root {{ {dark} }} }}\n"


def use_style() -> AbstractContextManager[None]:
    """Apply the matplotlib settings of the style in a `with` block."""
    from matplotlib import rc_context

    return rc_context(_DATA["settings"])


@dataclass(frozen=True)
class Look:
    """The look of one kind of object, in the terms of matplotlib.

    `width` and the `size` of markers are in points. Objects with a higher `order` are drawn on top.
    Markers can be filled with white (`hollow`) or have a white rim (`halo`).
    """

    color: str
    width: float = 1.2
    dash: Any = "-"
    fill: str | None = None
    hatch: str | None = None
    marker: str | None = None
    hollow: bool = False
    order: float = 3
    size: float = 4.5
    halo: bool = False

    @property
    def as_line(self) -> dict[str, Any]:
        return {
            "color": self.color,
            "linewidth": self.width,
            "linestyle": self.dash,
            "marker": self.marker,
            "markersize": self.size,
            "markerfacecolor": "white" if self.hollow else self.color,
            "markeredgecolor": "white" if self.halo else self.color,
            "markeredgewidth": 0.8 if self.halo else 1.0,
            "zorder": self.order,
        }

    @property
    def as_area(self) -> dict[str, Any]:
        return {
            "facecolor": self.fill or "none",
            "edgecolor": self.color,
            "linewidth": self.width,
            "linestyle": self.dash,
            "hatch": self.hatch,
            "zorder": self.order,
        }


def _look(name: str, width: float, **rest: Any) -> Look:
    return Look(LIGHT[name], width, **rest)


DIRECTRIX = _look("directrix", 1.0, fill=LIGHT["directrix-fill"], order=1)
GENERATRIX = _look("generatrix", 1.6, fill=LIGHT["generatrix-fill"], order=4)
SWEPT = Look("none", 0, fill=LIGHT["swept"], order=0)
OUTER = _look("outer", 1.6, dash=(0, (8, 2)), order=2)
INNER = _look("inner", 2.4, order=2.5)
UNDERCUT = _look("undercut", 0.5, hatch="//////", order=2)
EXACT_FIT = _look("fit", 2.2, marker="o", order=6)
MANY_EXACT_FITS = _look("fit", 0.5, order=6)
POINT_FIT = _look("fit", 0, dash="none", marker="*", order=7.2, size=12)
# Regions of free positions: holes of no-fit polygons, and inner fits.
FREE = _look("free", 1.6, fill=LIGHT["free-fill"], dash=(0, (6, 1.5)), order=4.5)
HANGING_END = _look("fit", 0, dash="none", marker="o", hollow=True, order=6.1)
TRAJECTORY = _look("path", 1.2, order=5)
REFERENCE = _look("generatrix", 0, dash="none", marker="o", order=7, size=5.5, halo=True)
# The trajectory, by contact event.
EVENTS = {
    "EV": _look("EV", 1.6, order=5),
    "VE": _look("VE", 1.6, dash=(0, (3, 1.5)), order=5),
    "EE": _look("EE", 2.4, dash=(0, (1, 1)), order=5),
}
# Contact points, by contact event.
CONTACTS = {
    "EV": _look("EV", 0, dash="none", marker="s", order=8, size=5.5, halo=True),
    "VE": _look("VE", 0, dash="none", marker="^", order=8, size=6.5, halo=True),
    "EE": _look("EE", 3.2, order=7.5),
    "VV": _look("VV", 0, dash="none", marker="D", order=8, size=5.5, halo=True),
}
SEVERAL_EVENTS = _look("path", 1.8, dash="-.", order=5)
SUB_TRAJECTORY = Look(GRAY, 0.9, dash=(0, (4, 2)), order=3)
ENVELOPE = Look(BLACK, 2.2, order=4)


def choose_chain_look(k: int) -> Look:
    markers, dashes = "os^Dv", ("-", (0, (5, 1.5)), (0, (2, 1)))
    return Look(
        PALETTE[k % len(PALETTE)],
        1.6,
        dash=dashes[k % len(dashes)],
        marker=markers[k % len(markers)],
    )
