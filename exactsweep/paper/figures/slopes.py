"""Figures 4 and 5: a CC sweep follows the edges of both polygons in order of slope."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from exactsweep.corpus.generator.shapes import walk
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import Edge, Point, Rational, Vertex
from exactsweep.paper.figures import figure
from exactsweep.paper.figures.figure import PaperFigure
from exactsweep.paper.kernel import sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import inverse
from exactsweep.sweep import Sweep, sweep

GENERATRIX = [(0, 0), (2, -1), (5, -2), (6, 1), (3, 3), (2, 3)]
DIRECTRIX = [(0, 5), (2, 1), (4, -1), (8, -2), (10, -1), (7, 6)]
STEPS = 4
OWNERS = ("D_b", "G_t")


class Move(NamedTuple):
    """An edge along which G slides: its chain, and its vector in the path."""

    owner: str
    by: Vertex

    @property
    def slope(self) -> Rational:
        return Fraction(self.by[1]) / self.by[0]


def sweep_example() -> Sweep:
    return sweep(GENERATRIX, DIRECTRIX, reference=(6, 1))


def list_edges() -> dict[str, list[Move]]:
    half = figure.take_half(sweep_example())
    chains = {"D_b": half.directrix, "G_t": inverse(half.top), "G_b": half.bottom}
    return {
        owner: [Move(owner, (q[0] - p[0], q[1] - p[1])) for p, q in pairwise(chain)]
        for owner, chain in chains.items()
    }


def sort_by_slope(*owners: str) -> list[Move]:
    found = list_edges()
    return sorted((move for owner in owners for move in found[owner]), key=lambda m: m.slope)


def lay(start: Vertex, moves: Sequence[Move]) -> list[Point]:
    return [Point(Fraction(x), Fraction(y)) for x, y in walk((m.by for m in moves), start)]


def find_stations() -> list[Point]:
    """Return the path of the right end of G, which starts at the left end of D_b (Lemma 3.1)."""
    return lay(figure.take_half(sweep_example()).directrix[0], sort_by_slope("D_b", "G_t"))


def write_slope(move: Move) -> str:
    return format_fraction(Fraction(move.slope)).replace("-", "\N{MINUS SIGN}")


def compute_slopes() -> PaperFigure:
    s, path, half = sweep_example(), find_stations(), figure.take_half(sweep_example())
    found = figure.shift(trajectory_cc(half.top, half.directrix), s.reference)
    across = [(x, 0) for ring in figure.place(s, path[: STEPS + 1]) for x, _ in ring]
    whole = PaperFigure(
        facts=[("edges of the trajectory", len(path) - 1)],
        laws=[("trajectory", found, path)],
        shapes={"across": across},
        sweeps=[(s, path)],
    )
    steps = {letter: _show(letter, s, path, step) for step, letter in enumerate("abcd")}
    return figure.join_panels(steps | {"": whole})


def _show(letter: str, s: Sweep, path: Sequence[Point], step: int) -> PaperFigure:
    taken, done = sort_by_slope("D_b", "G_t")[step], sort_by_slope("D_b", "G_t")[:step]
    ours, theirs = (
        next(move for move in list_edges()[owner] if move not in done) for owner in OWNERS
    )
    x, y = lay(figure.take_half(s).directrix[0], [move for move in done if move.owner == "D_b"])[-1]
    on_d = [(x, y), (x + ours.by[0], y + ours.by[1])]
    on_g = [(x, y), (x - theirs.by[0], y - theirs.by[1])]
    placed, moved = figure.place(s, path[step : step + 2])
    slopes = f"{ours.slope}, {theirs.slope}: {taken.owner} is next"
    first = min(ours, theirs, key=lambda move: move.slope)
    return PaperFigure(
        facts=[(f"({letter}) slopes ahead on D_b and on G_t", slopes)],
        laws=[
            (f"edge taken in step {step}", taken, first),
            (f"contacts before step {step}", [c.event for c in s.contacts_at(path[step])], ["VV"]),
        ],
        shapes={"placed": placed, "moved": moved, "path": path[: step + 1], "met": [(x, y)]}
        | {"edge": on_d if taken == ours else on_g}
        | {"middles": [figure.find_middle(*on_d), figure.find_middle(*on_g)]},
        words={"ours": [write_slope(ours)], "theirs": [write_slope(theirs)]},
    )


def compute_outer_slopes() -> PaperFigure:
    s, path, edges = sweep_example(), find_stations(), list_edges()
    half, sides, order = figure.take_half(s), sort_by_slope("D_b", "G_t"), sort_by_slope(*edges)
    between = [
        [move for move in edges["G_b"] if before.slope < move.slope < after.slope]
        for before, after in pairwise(sides)
    ]
    # The vertex of the trajectory with the most edges of G_b between the slopes of its two edges.
    turn = max(range(1, len(sides)), key=lambda k: len(between[k - 1]))
    (x, y), first, last = half.directrix[0], half.bottom[0], half.top[0]
    outer = lay((x + first[0] - last[0], y + first[1] - last[1]), order)
    # The edges separated by gaps, all centered at height 0.
    apart: list[Edge] = []
    start: Rational = 0
    for dx, dy in (move.by for move in order):
        apart.append(((start, -Fraction(dy) / 2), (start + dx, Fraction(dy) / 2)))
        start += dx + Fraction(3, 2)
    middles = [figure.find_middle(*piece).x for piece in apart]
    return PaperFigure(
        facts=[
            ("edges of D_b, G_t, G_b", figure.write_list(map(len, edges.values()))),
            ("edges of the outer boundary", len(outer) - 1),
            ("slopes of t_i and t_(i+1)", f"{sides[turn - 1].slope}, {sides[turn].slope}"),
            ("slopes of G_b between them", figure.write_list(m.slope for m in between[turn - 1])),
        ],
        laws=[
            ("outer boundary", sweep_outer_cc(half.top, half.bottom, half.directrix), outer),
            ("edges", len(outer) - 1, sum(map(len, edges.values()))),
        ],
        shapes={"path": path, "stops": path[1:-1], "turn": path[turn]}
        | {"t": path[turn - 1 : turn + 2], "outer": outer, "pieces": apart}
        | {
            f"{panel}_{owner}": [
                piece for piece, move in zip(pieces, order, strict=True) if move.owner == owner
            ]
            for panel, pieces in (("a", list(pairwise(outer))), ("b", apart))
            for owner in edges
        }
        | {
            "lowest": [(x, min(p[1], q[1])) for x, (p, q) in zip(middles, apart, strict=True)],
            "tops": [
                (middles[k], max(y for _, y in apart[k]))
                for k in (order.index(sides[turn - 1]), order.index(sides[turn]))
            ],
        },
        words={"slopes": [f"{write_slope(move)}\n${move.owner}$" for move in order]},
        sweeps=[(s, [path[turn]])],
    )
