"""Figure 4: a CC sweep goes along the edges of both polygons in order of slope."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING, Literal, NamedTuple

from exactsweep.canvas import style
from exactsweep.draw import place_generatrix
from exactsweep.numbers.number import format_fraction
from exactsweep.numbers.point import Point, Rational, Vertex
from exactsweep.paper.figures.figure import Facts, differ, loops_differ, overlaps
from exactsweep.paper.figures.sheet import (
    BOLD,
    GHOST,
    PLACED,
    SMALL,
    SMALL_DOT,
    TRAJECTORY,
    WIDE,
    BarePicture,
    Extent,
    Sheet,
    find_middle,
    shift,
)
from exactsweep.procedures.cc import trajectory_cc
from exactsweep.procedures.chain import inverse, split
from exactsweep.sweep import Sweep, sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure

GENERATRIX = [(0, 0), (2, -1), (5, -2), (6, 1), (3, 3), (2, 3)]
DIRECTRIX = [(0, 5), (2, 1), (4, -1), (8, -2), (10, -1), (7, 6)]
STEPS = 4

Owner = Literal["D_b", "G_t", "G_b"]


class Move(NamedTuple):
    """An edge along which G slides: whose it is, and which vector it adds to the path."""

    owner: Owner
    by: Vertex

    @property
    def slope(self) -> Rational:
        """Its slope."""
        return Fraction(self.by[1]) / self.by[0]


def sweep_example() -> Sweep:
    """The CC sweep of Figures 4 and 5; the reference point is the right end of G."""
    return sweep(GENERATRIX, DIRECTRIX, reference=(6, 1))


def list_edges() -> dict[Owner, list[Move]]:
    """The edges of D_b, of reversed G_t and of G_b, each from left to right."""
    s = sweep_example()
    g_bottom, g_top = split(s.generatrix.vertices)
    chains: dict[Owner, list[Vertex]] = {
        "D_b": split(s.directrix.vertices)[0],
        "G_t": inverse(g_top),
        "G_b": g_bottom,
    }
    return {
        owner: [Move(owner, (q[0] - p[0], q[1] - p[1])) for p, q in pairwise(chain)]
        for owner, chain in chains.items()
    }


def sort_by_slope(*owners: Owner) -> list[Move]:
    """The edges of some chains, sorted."""
    found = list_edges()
    return sorted((move for owner in owners for move in found[owner]), key=lambda m: m.slope)


def lay(start: Vertex, moves: Sequence[Move]) -> list[Vertex]:
    """Edges laid end to end."""
    path = [start]
    for move in moves:
        path += shift([move.by], path[-1])
    return path


def find_stations() -> list[Vertex]:
    """The path of the right end of G, from the left end of D_b on, by Lemma 3.1."""
    return lay(split(sweep_example().directrix.vertices)[0][0], sort_by_slope("D_b", "G_t"))


def _find_upcoming(step: int) -> tuple[Move, Move]:
    """The next edges of D_b and of reversed G_t before a move."""
    done = sort_by_slope("D_b", "G_t")[:step]
    waiting = [
        [m for m in moves if m not in done] for o, moves in list_edges().items() if o != "G_b"
    ]
    return waiting[0][0], waiting[1][0]


def write_slope(value: Rational) -> str:
    """A slope, with a true minus sign."""
    return format_fraction(Fraction(value)).replace("-", "\N{MINUS SIGN}")


def list_facts() -> Facts:
    """List the figure's statements."""
    rows = []
    for step in range(STEPS):
        ours, theirs = _find_upcoming(step)
        taken = sort_by_slope("D_b", "G_t")[step]
        rows.append(
            (
                f"({'abcd'[step]}) slopes ahead on D_b and on G_t",
                f"{ours.slope}, {theirs.slope}: {taken.owner} is next",
            )
        )
    return [*rows, ("edges of the trajectory", str(len(find_stations()) - 1))]


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    s = sweep_example()
    yield from loops_differ(s)
    yield from overlaps(s, [Point(Fraction(x), Fraction(y)) for x, y in find_stations()])
    half = [split(p.vertices) for p in (s.generatrix, s.directrix)]
    yield differ(
        "trajectory", shift(trajectory_cc(half[0][1], half[1][0]), s.reference), find_stations()
    )
    for step in range(STEPS):
        first = min(_find_upcoming(step), key=lambda move: move.slope)
        yield differ(f"edge taken in step {step}", sort_by_slope("D_b", "G_t")[step], first)
        contacts = [c.event for c in s.contacts_at(find_stations()[step])]
        yield differ(f"contacts before step {step}", contacts, ["VV"])


def draw() -> Figure:
    """The picture."""
    s = sweep_example()
    path = [Point(Fraction(x), Fraction(y)) for x, y in find_stations()]
    placed = [place_generatrix(s, place).vertices for place in path[: STEPS + 1]]
    across = [(x, 0) for ring in placed for x, _ in ring]
    boxes = [
        Extent.around(s.directrix.vertices, across, *placed[k : k + 2], title=f"({'abcd'[k]})")
        for k in range(STEPS)
    ]
    with Sheet([boxes[:2], boxes[2:]], WIDE) as sheet:
        for step, panel in enumerate(sheet.panels):
            panel.area(s.directrix.vertices, style.DIRECTRIX)
            panel.area(placed[step + 1], GHOST)
            panel.area(placed[step], PLACED)
            panel.line(path[: step + 1], TRAJECTORY)
            panel.dots([path[step]], SMALL_DOT)
            panel.label((6, 3), "$D$")
            panel.label(path[step], "$G$", -38, -4)
            _show_step(panel, step)
    return sheet.figure


def _show_step(panel: BarePicture, step: int) -> None:
    """Mark the vertices that have met, the edge along which G goes on, and both slopes."""
    ours, theirs = _find_upcoming(step)
    x, y = _find_meeting(step)
    on_d = (x, y), (x + ours.by[0], y + ours.by[1])
    on_g = (x, y), (x - theirs.by[0], y - theirs.by[1])
    edge = on_d if sort_by_slope("D_b", "G_t")[step] == ours else on_g
    panel.line(edge, BOLD)
    panel.dots([(x, y)])
    panel.label(find_middle(*on_d), write_slope(ours.slope), 3, 6, ha="left", size=SMALL)
    panel.label(find_middle(*on_g), write_slope(theirs.slope), -7, -9, size=SMALL)


def _find_meeting(step: int) -> Vertex:
    """The vertex of D_b at which G's vertex is before a move."""
    done = [move for move in sort_by_slope("D_b", "G_t")[:step] if move.owner == "D_b"]
    return lay(split(sweep_example().directrix.vertices)[0][0], done)[-1]
