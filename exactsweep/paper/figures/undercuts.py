"""Figure 7: the two forms of undercuts."""

from __future__ import annotations

from exactsweep.evidence.undercut import Undercut
from exactsweep.geometry.region import Vertices
from exactsweep.paper.figures.figure import (
    PaperFigure,
    join_panels,
    place,
    shift,
    take_half,
)
from exactsweep.paper.functions import take_bottom
from exactsweep.paper.kernel import find_convex_parts, trajectory_cc
from exactsweep.sweep import Sweep, sweep

DIRECTRIX = [(0, 4), (3, 0), (6, 5), (9, 1), (12, 5), (6, 8)]
# A roof, and a long straight edge parallel to the line through the two lowest vertices of D.
GENERATRICES: tuple[Vertices, ...] = (
    [(0, 0), (5, -4), (9, 0), (4, 3)],
    [(0, -1), (6, -4), (11, 0), (10, "3/2"), (1, 0)],
)
REFERENCES = ((5, -4), (6, -4))


def sweep_examples() -> tuple[Sweep, Sweep]:
    """Compute both sweeps; the reference points are the lowest vertices of G."""
    first, second = (
        sweep(g, DIRECTRIX, reference=r) for g, r in zip(GENERATRICES, REFERENCES, strict=True)
    )
    return first, second


def find_undercut(s: Sweep) -> Undercut:
    (found,) = s.undercuts
    return found


def compute() -> PaperFigure:
    panels = zip("ab", sweep_examples(), ("point", "segment"), strict=True)
    return join_panels({letter: _show(letter, s, kind) for letter, s, kind in panels})


def _show(letter: str, s: Sweep, kind: str) -> PaperFigure:
    found, half, gap = find_undercut(s), take_half(s), s.inner.area - s.directrix.area
    parts = (trajectory_cc(half.top, part) for part in find_convex_parts(half.directrix))
    first, *others = place(s, found.positions)
    return PaperFigure(
        facts=[
            (f"({letter}) undercuts", len(s.undercuts)),
            (f"({letter}) the sub-trajectories meet in a", found.intersection),
            (f"({letter}) edges of the bottom chain", len(found.bottom) - 1),
            (f"({letter}) contact points", " ".join(f"({p.x}, {p.y})" for p in found.extremes)),
        ],
        laws=[
            ("kind", found.intersection, kind),
            ("positions", len(found.positions), 1 if kind == "point" else 2),
            ("area between D and the inner loop", gap, found.polygon.area),
        ],
        shapes={
            "first": first,
            "others": others,
            "parts": [shift(part, s.reference) for part in parts],
        }
        | {"path": take_bottom(s.trajectory.vertices), "bottom": found.bottom}
        | {"touched": found.extremes, "positions": found.positions},
        sweeps=[(s, found.positions)],
    )
