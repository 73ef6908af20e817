"""Figure 10, outer boundaries with order mn² edges, and an additional figure of many undercuts."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise

from exactsweep.corpus.generator import growing
from exactsweep.numbers.number import Edge, Point, Vertex
from exactsweep.paper.checks.section5_sizes import sizes_of
from exactsweep.paper.figures.figure import (
    PaperFigure,
    find_middle,
    join_panels,
    take_half,
    write_list,
)
from exactsweep.paper.functions import lower_undercuts, take_bottom
from exactsweep.paper.kernel import sweep_mm
from exactsweep.sweep import Sweep, sweep

# Two peaks, and a round tip of four edges between steep flanks, in units of 1/4 and 1/20.
PEAKS = [(80, 0), (60, 80), (40, 0), (20, 80), (0, 0)]
TIP = [(25, -120), (33, -135), (40, -142), (47, -135), (55, -120)]
SIZES = ((2, 4, 6), (4, 4, 6), (4, 6, 8), (6, 6, 6), (6, 8, 8))
COLUMNS = (3, 10, 16)


def sweep_example(teeth: int) -> Sweep:
    """Sweep a pair flatter and wider than `bumps`; one tooth gives the paper's sizes."""
    bottom = [(40 * k, -120 if k % 2 else 0) for k in range(2 * teeth + 1)]
    rings = PEAKS + TIP, [*bottom, (40 * teeth, 60)]
    g, d = ([(Fraction(x, 4), Fraction(y, 20)) for x, y in ring] for ring in rings)
    return sweep(g, d)


def _place_numbers(edges: Sequence[Edge]) -> Iterator[Vertex]:
    """Yield the offset of each edge's number: below, but above where the chain turns right."""
    vectors = [(Fraction(q[0] - p[0]), Fraction(q[1] - p[1])) for p, q in edges]
    right = [dx * ny < dy * nx for (dx, dy), (nx, ny) in pairwise(vectors)]
    for k, (dx, dy) in enumerate(vectors):
        if any(right[max(k - 1, 0) : k + 1]):
            yield (-5 if dy > 0 else 5), 8
        else:
            # Two-digit numbers of adjacent short edges alternate between two levels.
            yield 7 * dy / (dx + abs(dy)), -14 if k >= 9 and k % 2 and dx < 3 else -7


def _show(letter: str, s: Sweep) -> PaperFigure:
    size, lower = sizes_of(take_half(s)), take_bottom(s.outer.vertices)
    edges = list(pairwise(lower))
    # G is drawn with one of its peaks under a tooth.
    at = min(s.trajectory.vertices, key=lambda p: (p.y, p.x))
    return PaperFigure(
        facts=[(f"({letter}) (m_b, n_t, n_b): edges", f"{size}: {len(edges)}")],
        laws=[(f"edges for {size}", len(edges), growing.edges_of_bumps(*size))],
        shapes={"name": (at.x + 10, at.y), "edges": edges, "lower": lower}
        | {"middles": [find_middle(*e) for e in edges], "offsets": list(_place_numbers(edges))},
        words={"title": [f"({letter}) {len(edges)} edges"]}
        | {"numbers": [str(k + 1) for k in range(len(edges))]},
        sweeps=[(s, [at])],
    )


def compute_lower_bound() -> PaperFigure:
    first, second = sweep_example(1), sweep_example(2)
    facts: list[tuple[str, object]] = []
    laws: list[tuple[str, object, object]] = [
        ("sizes", sizes_of(take_half(first)), (2, 4, 6)),
        ("edges", len(take_bottom(first.outer.vertices)) - 1, growing.printed_count(2, 4, 6)),
    ]
    cells: list[str] = []
    for size in SIZES:
        s, printed = sweep(*growing.bumps(*size)), growing.printed_count(*size)
        found = len(take_bottom(s.outer.vertices)) - 1
        facts.append((f"family, {size}: edges, formula of the paper", f"{found}, {printed}"))
        laws.append((f"edges for {size}", found, len(sweep_mm(*take_half(s))[1]) - 1))
        laws.append((f"edges for {size}", found, growing.edges_of_bumps(*size)))
        cells += [str(size), str(printed), str(found)]
    rows = range(1, len(SIZES) + 1)
    places = [(x, 16 - Fraction(5, 2) * row) for row in rows for x in COLUMNS]
    whole = PaperFigure(facts, laws, {"cells": places}, {"cells": cells})
    return join_panels({"a": _show("a", first), "b": _show("b", second), "": whole})


M, N = 7, 8
CEILING = 8
# With G at PLACE, the tip of the left needle, the origin, is in the first inner valley of G_t.
PLACE = Point(Fraction(-9), Fraction(0))


def compute_ceilings() -> PaperFigure:
    s = sweep(*growing.ceilings(M, N))
    lower = sorted(lower_undercuts(s), key=lambda u: u.bottom[0])
    # Between two undercuts, G touches the ceiling at a point.
    touched = [undercut.bottom[-1] for undercut in lower[:-1]]
    return PaperFigure(
        facts=[
            ("(m, n)", f"({M}, {N})"),
            ("undercuts between the needles", len(lower)),
            ("places where G touches the ceiling", len(touched)),
            ("their x", write_list(p.x for p in touched)),
        ],
        laws=[
            ("undercuts", len(lower), growing.undercuts_under_ceilings(M, N)),
            ("heights of the places", {p.y for p in touched}, {CEILING}),
        ],
        shapes={"undercuts": [u.polygon.vertices for u in lower], "touched": touched},
        sweeps=[(s, [PLACE])],
    )
