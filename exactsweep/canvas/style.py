"""How things look: one style for all pictures, for print and for colour-blind readers.

Colours are those of Okabe and Ito. No two things differ by colour alone: they differ in line
width, dashes, hatching or markers, too, and so remain apart in black and white.
"""

from __future__ import annotations

from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any

BLACK = "#000000"
GREY = "#5f5f5f"
ORANGE = "#e69f00"
SKY = "#56b4e9"
GREEN = "#009e73"
YELLOW = "#f0e442"
BLUE = "#0072b2"
RED = "#d55e00"
PURPLE = "#cc79a7"

PALETTE = (BLUE, RED, GREEN, PURPLE, ORANGE, SKY, BLACK)
"""The order in which things of one kind, such as chains, take colours."""

_SETTINGS: Any = {
    "axes.edgecolor": GREY,
    "axes.labelsize": 9,
    "axes.linewidth": 0.6,
    "figure.dpi": 120,
    "figure.figsize": (7.2, 4.8),
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "hatch.linewidth": 0.7,
    "legend.fontsize": 8,
    "legend.frameon": False,
    "legend.handlelength": 2.6,
    "lines.solid_capstyle": "round",
    "lines.solid_joinstyle": "round",
    "mathtext.fontset": "dejavusans",
    "pdf.fonttype": 42,
    "savefig.dpi": 200,
    "svg.fonttype": "path",
    # Names inside an SVG file are made from this instead of at random.
    "svg.hashsalt": "exactsweep",
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
}


def in_style() -> AbstractContextManager[None]:
    """Return a context in which matplotlib has the settings of the style."""
    from matplotlib import rc_context

    return rc_context(_SETTINGS)


@dataclass(frozen=True)
class Look:
    """How one kind of thing looks.

    Attributes:
        color: of lines, markers and hatching.
        width: of lines, in points.
        dash: line style of matplotlib.
        fill: colour of the inside, None for an empty one.
        hatch: hatching of matplotlib, None for none.
        marker: marker of matplotlib at each point, None for none.
        hollow: whether markers are filled with white.
        order: what is drawn later, over the rest, has a higher one.
        size: of markers, in points.
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

    @property
    def as_line(self) -> dict[str, Any]:
        """Keyword arguments for `Axes.plot`."""
        return {
            "color": self.color,
            "linewidth": self.width,
            "linestyle": self.dash,
            "marker": self.marker,
            "markersize": self.size,
            "markerfacecolor": "white" if self.hollow else self.color,
            "zorder": self.order,
        }

    @property
    def as_area(self) -> dict[str, Any]:
        """Keyword arguments for `Axes.fill`."""
        return {
            "facecolor": self.fill or "none",
            "edgecolor": self.color,
            "linewidth": self.width,
            "linestyle": self.dash,
            "hatch": self.hatch,
            "zorder": self.order,
        }


DIRECTRIX = Look(GREY, 1.0, fill="#cccccc", order=1)
GENERATRIX = Look(BLUE, 1.6, fill="#56b4e940", order=4)
SWEPT = Look("none", 0, fill="#fbf6d0", order=0)
OUTER = Look(ORANGE, 1.6, dash=(0, (8, 2)), order=2)
INNER = Look(GREEN, 2.4, order=2.5)
UNDERCUT = Look(RED, 0.5, hatch="//////", order=2)
EXACT_FIT = Look(PURPLE, 2.2, marker="o", order=6)
MANY_EXACT_FITS = Look(PURPLE, 0.5, order=6)
POINT_FIT = Look(PURPLE, 0, dash="none", marker="*", order=7.2, size=12)
FREE = Look(GREEN, 1.6, fill="#009e7338", dash=(0, (6, 1.5)), order=4.5)
"""Positions without overlap: holes of a no-fit polygon, regions of an inner fit."""
HANGING_END = Look(PURPLE, 0, dash="none", marker="o", hollow=True, order=6.1)
TRAJECTORY = Look(BLACK, 1.2, order=5)
REFERENCE = Look(BLACK, 0, dash="none", marker="o", order=7)
EVENTS = {
    "EV": Look(BLUE, 1.6, order=5),
    "VE": Look(RED, 1.6, dash=(0, (3, 1.5)), order=5),
    "EE": Look(BLACK, 2.0, dash=(0, (1, 1)), order=5),
}
"""The trajectory by contact event."""
CONTACTS = {
    "EV": Look(BLUE, 0, dash="none", marker="s", order=8),
    "VE": Look(RED, 0, dash="none", marker="^", order=8),
    "EE": Look(BLACK, 2.6, order=7.5),
    "VV": Look(PURPLE, 0, dash="none", marker="D", order=8),
}
"""Where G touches D, by contact event."""
SEVERAL_EVENTS = Look(GREY, 2.0, dash="-.", order=5)
SUB_TRAJECTORY = Look(GREY, 0.9, dash=(0, (4, 2)), order=3)
ENVELOPE = Look(BLACK, 2.2, order=4)


def chain_look(k: int) -> Look:
    """The look of chain number k of several: by colour, marker and dashes.

    >>> chain_look(0) == chain_look(1)
    False
    """
    markers, dashes = "os^Dv", ("-", (0, (5, 1.5)), (0, (2, 1)))
    return Look(
        PALETTE[k % len(PALETTE)],
        1.6,
        dash=dashes[k % len(dashes)],
        marker=markers[k % len(markers)],
    )
