"""Sweeps by an independent exact program: Minkowski sums of SFCGAL, that is of CGAL.

The trajectory is the boundary of P = D + I(G), the outer loop that of P + G; the inner loop bounds
the hole of (a large box without P) + G.

`exactsweep corpus export | python tests/support/sfcgal_sweep.py` answers each case, a line each,
with its id, and "differs" behind it where the loops do. It is a process of its own because it may
crash.
"""

import json
import re
import sys
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from exactsweep import Point, Polygon
from exactsweep.corpus import case_from_json

Ring = Sequence[tuple[Fraction, Fraction]]
_RING = re.compile(r"\(([^()]*)\)")


def loops(directrix: Polygon, generatrix: Polygon, reference: Point) -> tuple[Polygon, ...]:
    """The trajectory, the inner and the outer loop."""
    # Both come to the origin and to a size of one: the program checks its input with doubles.
    at_d, at_g = directrix.vertices[0], generatrix.vertices[0]
    d, g = directrix.translated((-at_d.x, -at_d.y)), generatrix.translated((-at_g.x, -at_g.y))
    unit = max(abs(c) for polygon in (d, g) for vertex in polygon.vertices for c in vertex)
    around_d, moving = ([(x / unit, y / unit) for x, y in p.vertices] for p in (d, g))

    def back(ring: Ring, x: Fraction, y: Fraction) -> Polygon:
        return Polygon([(unit * px + x, unit * py + y) for px, py in ring])

    (found,) = _sum([around_d], [(-x, -y) for x, y in moving])
    # Its own collinear vertices, given back to it, crash the program.
    no_fit = Polygon(found)
    positions = no_fit.vertices
    (outer,) = _sum([positions], moving)
    (low_x, low_y), (high_x, high_y) = no_fit.bounding_box
    left, bottom, right, top = low_x - 9, low_y - 9, high_x + 9, high_y + 9
    box = [(left, bottom), (right, bottom), (right, top), (left, top)]
    _, inner = _sum([box, positions[::-1]], moving)
    by = at_d.x - at_g.x + reference.x, at_d.y - at_g.y + reference.y
    return back(positions, *by), back(inner, *at_d), back(outer, *at_d)


def _sum(rings: Sequence[Ring], other: Ring) -> list[list[tuple[Fraction, Fraction]]]:
    from pysfcgal.geometry import Geometry

    both: list[Any] = [Geometry.from_wkt(_polygon(shape)) for shape in (rings, [other])]
    found = _RING.findall(both[0].minkowski_sum(both[1]).to_wkt())
    return [
        [(Fraction(x), Fraction(y)) for x, y in map(str.split, ring.split(",")[:-1])]
        for ring in found
    ]


def _polygon(rings: Sequence[Ring]) -> str:
    texts = (", ".join(f"{x} {y}" for x, y in [*ring, ring[0]]) for ring in rings)
    return f"POLYGON ({', '.join(f'({text})' for text in texts)})"


def main() -> None:
    for line in sys.stdin:
        case = case_from_json(json.loads(line))
        same = loops(case.directrix, case.generatrix, case.reference) == (
            case.trajectory,
            case.inner,
            case.outer,
        )
        print(case.id if same else f"{case.id} differs", flush=True)


if __name__ == "__main__":
    main()
