"""The growth of no-fit polygons of any shape: counts of steps, and seconds.

The steps are those of `exactsweep.procedures.positions`, with at most 2 m n contact segments.
"""

from __future__ import annotations

from collections.abc import Iterator

from benchmarks.clock import milliseconds
from benchmarks.families import ANY_SHAPE
from exactsweep import Polygon, no_fit_polygon
from exactsweep.geometry.edges import EdgeIndex
from exactsweep.geometry.frame import HomogeneousPoint
from exactsweep.geometry.overlap import Relation, relate
from exactsweep.paper.growth import MN, MN_LOG, Growth, Size
from exactsweep.procedures.cover import leave_out_covered
from exactsweep.procedures.crossings import cut
from exactsweep.procedures.neighbors import leave_out_overlapped
from exactsweep.procedures.positions import reflect
from exactsweep.procedures.segments import find_contact_segments
from exactsweep.procedures.walk import find_free

SIZES = {"radial": (16, 32, 64, 128), "tangled": (12, 24, 48)}
STEPS = (
    "contact segments",
    "segments not covered by squares",
    "crossings of these segments",
    "overlap tests",
)
_RISE = 0.3  # the permitted excess of an exponent, as each size has only one pair


def count_steps(family: str, size: int) -> tuple[int, ...]:
    """Count the STEPS on the pair of a family with m = n = size."""
    generatrix, directrix = ANY_SHAPE[family](size, size, 0)
    moving = reflect([generatrix])
    segments = find_contact_segments([directrix], moving, leave_out_overlapped)
    left = leave_out_covered(segments, [[directrix]], [moving])
    pieces = cut(left)
    pair, asked = (EdgeIndex([directrix]), EdgeIndex([generatrix])), [0]

    def overlaps(position: HomogeneousPoint) -> bool:
        asked[0] += 1
        return relate(*pair, *position) is Relation.OVERLAP

    find_free(pieces, overlaps)
    crossings = sum(len(segment.cuts) for segment in left) // 2
    return len(segments), len(left), crossings, asked[0]


def measure_shapes(*, quick: bool = False) -> Iterator[Growth]:
    """Tabulate counts divided by m n, and seconds divided by m n log n."""
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
