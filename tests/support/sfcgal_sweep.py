"""Answers by an independent exact library: Minkowski sums of SFCGAL, which uses CGAL.

The no-fit polygon is P = D + I(G), with all its holes. For the area swept along its exterior T, the
outer loop and further holes are those of T + G, T filled; the inner loop and the other holes are
those of (a large box minus the inside of T) + G.

The library accepts holes of one polygon only. If both have holes, G lies in a hole of D, or D in
one of G: the holes are those of both sums, each with the holes of the other polygon filled.

`exactsweep corpus export | python tests/support/sfcgal_sweep.py` prints a line per case, its id,
and "differs" if the loops differ. It runs in its own process because the library may crash. It
covers neither exact fits nor inner fits.
"""

import json
import sys
from collections.abc import Iterable, Sequence
from fractions import Fraction

from benchmarks.peers.adapters.adapter import prepare_shape
from benchmarks.peers.adapters.sfcgal_sum import add
from exactsweep import Point, Polygon, Region
from exactsweep.check import classify
from exactsweep.check.location import locate
from exactsweep.corpus import Case, case_from_json

Ring = Sequence[tuple[Fraction, Fraction]]
Rings = Sequence[Ring]


def differs(case: Case) -> list[str]:
    """List the answers in which the program differs."""
    # Translate both to the origin and scale them to size 1: the program checks input in doubles.
    (at_dx, at_dy), (at_gx, at_gy) = case.directrix.vertices[0], case.generatrix.vertices[0]
    d = [[(x - at_dx, y - at_dy) for x, y in ring] for ring in case.directrix.rings]
    g = [[(x - at_gx, y - at_gy) for x, y in ring] for ring in case.generatrix.rings]
    unit = max(abs(c) for ring in (*d, *g) for point in ring for c in point)
    d, g = ([[(x / unit, y / unit) for x, y in ring] for ring in rings] for rings in (d, g))
    inverse = [[(-x, -y) for x, y in ring] for ring in g]
    on_d = at_dx, at_dy
    at_t = at_dx - at_gx + case.reference.x, at_dy - at_gy + case.reference.y

    def back(rings: Iterable[Ring], by: tuple[Fraction, Fraction]) -> list[Polygon]:
        found = [Polygon([(unit * x + by[0], unit * y + by[1]) for x, y in ring]) for ring in rings]
        return sorted(found, key=lambda polygon: polygon.vertices)

    exterior, *holes = _sum(d, inverse[:1])
    if len(inverse) > 1:
        holes += _sum(inverse, d[:1])[1:]
    # The library also reports a hole if one polygon is inside the other, or in a gap of it.
    holes = [hole for hole in holes if _is_hole(d, g, hole)]
    # Its own collinear vertices crash the library.
    path = Polygon(exterior).vertices
    outer, *further = _sum([path], g) if len(g) == 1 else _sum(g, [path])
    inside = _inside(path, g[0])
    found = {
        "trajectory": (back([exterior], at_t), [case.trajectory]),
        "holes": (list(dict.fromkeys(back(holes, at_t))), list(case.holes)),
        "outer": (back([outer], on_d), [case.outer]),
        "unswept": (
            back([*further, *inside], on_d),
            sorted((case.inner, *case.unswept), key=lambda polygon: polygon.vertices),
        ),
    }
    return [name for name, (theirs, ours) in found.items() if theirs != ours]


def _inside(ring: Ring, moving: Ring) -> list[Ring]:
    """Find the points p with p - MOVING inside a ring: holes of the sum of a frame and MOVING.

    If p - MOVING is entirely inside the frame, SFCGAL also treats p as a point of a hole.
    """
    reach = 9 * max(abs(c) for points in (ring, moving) for point in points for c in point)
    box = [(-reach, -reach), (reach, -reach), (reach, reach), (-reach, reach)]
    _, *holes = _sum([box, ring], [moving])
    x, y = moving[0]
    found: list[Ring] = []
    for hole in holes:
        p = _point_inside(hole)
        if locate(Point(p.x - x, p.y - y), [Point(*q) for q in ring]) > 0:
            found.append(hole)
    return found


def _is_hole(d: Rings, g: Rings, ring: Ring) -> bool:
    """Decide whether a hole has an interior, and no overlap at a vertex."""
    stays, moves = Region(d[0], d[1:]), Region(g[0], g[1:])
    is_free = classify(stays, moves, _point_inside(ring)).verdict == "FREE"
    return is_free and all(classify(stays, moves, t).verdict != "OVERLAP" for t in ring)


def _point_inside(ring: Ring) -> Point:
    """Return a point inside a ring, near its least vertex."""
    k = min(range(len(ring)), key=lambda k: ring[k])
    (ax, ay), (x, y), (bx, by) = ring[k - 1], ring[k], ring[(k + 1) % len(ring)]
    share = Fraction(1, 3)
    while True:
        p = Point(x + share * (ax + bx - 2 * x), y + share * (ay + by - 2 * y))
        if locate(p, [Point(*q) for q in ring]) > 0:
            return p
        share /= 4


def _sum(rings: Rings, others: Rings) -> list[list[tuple[Fraction, Fraction]]]:
    found = add(*(prepare_shape([list(ring) for ring in shape]) for shape in (rings, others)))
    return [[(Fraction(x), Fraction(y)) for x, y in ring[:-1]] for ring in found]


def main() -> None:
    for line in sys.stdin:
        case = case_from_json(json.loads(line))
        wrong = differs(case)
        print(" ".join([case.id, *(["differs:", ", ".join(wrong)] if wrong else [])]), flush=True)


if __name__ == "__main__":
    main()
