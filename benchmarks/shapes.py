"""The growth of no-fit polygons of any shape: counts of their steps, and seconds.

The steps are those of `exactsweep.procedures.ss`. There are at most 2 m n contact segments; what
lies in squares that are known to be overlapped is left out, and of the rest few pieces remain at
which the overlap has to be asked for.
"""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks.clock import milliseconds
from benchmarks.families import ANY_SHAPE
from exactsweep import Polygon, no_fit_polygon
from exactsweep.geometry.overlap import Overlap
from exactsweep.numbers.number import Point
from exactsweep.paper.growth import MN, MN_LOG, Growth, Size
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.contact_lines import find_contact_stretches
from exactsweep.procedures.cover import leave_out_covered
from exactsweep.procedures.crossings import cut_at_crossings
from exactsweep.procedures.free_positions import find_free_positions

SIZES = {"radial": (16, 32, 64, 128), "tangled": (12, 24, 48)}
STEPS = (
    "stretches of contact lines",
    "stretches that leave the squares",
    "crossings of these",
    "questions of overlap",
)
_RISE = 0.3
"""By how much an exponent may be above that of the bound: one pair stands for each size."""


def count_steps(family: str, size: int) -> tuple[int, ...]:
    """Count the STEPS on the pair of a family with m = n = size."""
    generatrix, directrix = ANY_SHAPE[family](size, size, 0)
    moving = [inverse(generatrix)]
    stretches = find_contact_stretches([directrix], moving)
    left = leave_out_covered(stretches, [directrix], moving)
    cut_at_crossings(left)
    overlap, asked = Overlap([directrix], [generatrix]), [0]

    def ask(t: Point) -> bool:
        asked[0] += 1
        return overlap.at(t)

    find_free_positions(left, ask, 1)
    crossings = sum(len(stretch.cuts) for stretch in left) // 2
    return len(stretches), len(left), crossings, asked[0]


def measure_shapes(*, quick: bool = False) -> Iterator[Growth]:
    """The series: counts beside m n, and seconds beside m n log n."""
    for family, sizes in SIZES.items():
        sizes = sizes[:3] if quick else sizes
        counts = {size: count_steps(family, size) for size in sizes}
        name, bound = MN
        for k, what in enumerate(STEPS):
            points = [Size(n, n, counts[n][k], bound(n, n)) for n in sizes]
            yield Growth(what, family, name, tuple(points), _RISE)
        if not quick:
            name, bound = MN_LOG
            points = [Size(n, n, _seconds(family, n), bound(n, n)) for n in sizes]
            yield Growth("seconds of the no-fit polygon", family, name, tuple(points))


def _seconds(family: str, size: int) -> float:
    generatrix, directrix = map(Polygon, ANY_SHAPE[family](size, size, 0))
    times = milliseconds(lambda: no_fit_polygon(directrix, generatrix).exact_fits, 0.2)
    return min(times) / 1000
