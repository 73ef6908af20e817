"""Named, seeded families of pairs for the benchmarks.

Each takes (m, n, seed), m and n even, and returns a generatrix of n and a directrix of m vertices
as counter-clockwise lists of pairs of ints; `figure10` ignores the seed. The families for the
paper's claims are in `corpus.generator.growing`.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, sin
from random import Random

from exactsweep import Polygon, PolygonError
from exactsweep.corpus.generator.growing import cc, cm, cm_hard, cm_undercut, figure10, mm
from exactsweep.corpus.generator.shapes import Ring, untangle

Family = Callable[[int, int, int], tuple[Ring, Ring]]


def stairs(n: int, random: Random, step: int = 1000, height: int = 1000) -> Ring:
    """Make a rectilinear X-monotone polygon of about n vertices with random steps on both sides."""
    count = n // 4
    xs = [step * k + random.randrange(step // 2) for k in range(count + 1)]
    low = [random.randrange(-height, 0) for _ in range(count)]
    high = [random.randrange(1, height + 1) for _ in range(count)]
    bottom = [p for k, y in enumerate(low) for p in ((xs[k], y), (xs[k + 1], y))]
    top = [p for k, y in enumerate(high) for p in ((xs[k], y), (xs[k + 1], y))]
    return bottom + top[::-1]


def stair(m: int, n: int, seed: int = 0) -> tuple[Ring, Ring]:
    """Make two random rectilinear polygons."""
    random = Random(f"stair {m} {n} {seed}")
    return stairs(n, random), stairs(m, random)


def star(n: int, random: Random, size: int = 10**6) -> Ring:
    """Make a polygon with vertices at equal angles and random distances from the center."""
    turn, radii = 2 * pi / n, [random.uniform(0.35 * size, size) for _ in range(n)]
    return [(round(r * cos(k * turn)), round(r * sin(k * turn))) for k, r in enumerate(radii)]


def radial(m: int, n: int, seed: int = 0) -> tuple[Ring, Ring]:
    """Make two spiky stars without a direction of monotonicity."""
    random = Random(f"radial {m} {n} {seed}")
    return star(n, random), star(m, random)


def tangle(n: int, random: Random, size: int = 1000) -> Ring:
    """Draw random points, and untangle a tour of them by 2-opt."""
    while True:
        ring = untangle((random.randrange(size), random.randrange(size)) for _ in range(n))
        try:
            return [(int(x), int(y)) for x, y in Polygon(ring).vertices]
        except PolygonError:
            continue


def tangled(m: int, n: int, seed: int = 0) -> tuple[Ring, Ring]:
    """Make two outlines with cavities and hooks, like published tests of nesting programs."""
    random = Random(f"tangled {m} {n} {seed}")
    return tangle(n, random), tangle(m, random)


FAMILIES: dict[str, Family] = {
    "cc": cc,
    "cm": cm,
    "cm_hard": cm_hard,
    "cm_undercut": cm_undercut,
    "mm": mm,
    "stair": stair,
    "figure10": figure10,
}

# Without a shared direction of monotonicity.
ANY_SHAPE: dict[str, Family] = {"radial": radial, "tangled": tangled}
