"""The thirteen figures of the paper, redrawn from computed sweeps of polygons of our own.

`FIGURES` has them in order. Each is a row of the ledger, too: what it states is computed, and its
check holds that against the definition. Drawing needs matplotlib, the `plot` extra.
"""

from __future__ import annotations

from exactsweep.paper.figures import (
    boundaries,
    chains,
    contact_motion,
    envelopes,
    inverses,
    local_width,
    lower_bound,
    minkowski,
    outer_slopes,
    procedures,
    slopes,
    undercuts,
    vertex_event,
)
from exactsweep.paper.figures.figure import PaperFigure

FIGURES: tuple[PaperFigure, ...] = (
    minkowski.FIGURE,
    chains.FIGURE,
    boundaries.FIGURE,
    slopes.FIGURE,
    outer_slopes.FIGURE,
    envelopes.FIGURE,
    undercuts.FIGURE,
    inverses.FIGURE,
    local_width.FIGURE,
    lower_bound.FIGURE,
    procedures.FIGURE,
    vertex_event.FIGURE,
    contact_motion.FIGURE,
)
CLAIMS = tuple(figure.claim for figure in FIGURES)

__all__ = ["CLAIMS", "FIGURES", "PaperFigure"]
