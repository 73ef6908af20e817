"""Figure 5: the outer boundary of a CC sweep, in order of slope."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

from exactsweep.numbers.number import Edge, Rational
from exactsweep.paper.figures.figure import (
    PaperFigure,
    find_middle,
    take_half,
    write_list,
)
from exactsweep.paper.figures.slopes import (
    find_stations,
    lay,
    list_edges,
    sort_by_slope,
    sweep_example,
    write_slope,
)
from exactsweep.paper.kernel import sweep_outer_cc


def compute() -> PaperFigure:
    s, path, edges = sweep_example(), find_stations(), list_edges()
    half, sides, order = take_half(s), sort_by_slope("D_b", "G_t"), sort_by_slope(*edges)
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
    middles = [find_middle(*piece).x for piece in apart]
    return PaperFigure(
        facts=[
            ("edges of D_b, G_t, G_b", write_list(map(len, edges.values()))),
            ("edges of the outer boundary", len(outer) - 1),
            ("slopes of t_i and t_(i+1)", f"{sides[turn - 1].slope}, {sides[turn].slope}"),
            ("slopes of G_b between them", write_list(m.slope for m in between[turn - 1])),
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
