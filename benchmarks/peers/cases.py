"""The pairs that are measured, and how much faster than CGAL the kernel has to be on them."""

from __future__ import annotations

from typing import NamedTuple

from benchmarks import families
from exactsweep.corpus.generator.shapes import Ring

TRAJECTORY, LOOPS = "trajectory", "three loops"


# Polygons of any shape: the no-fit polygon with all its holes and exact fits, though only its
# exterior is compared. CGAL gives the holes, too, but no exact fits.
ANY_SHAPE = {
    "tangled": {(26, 18): 0.5},
    "radial": {(16, 16): 0.5, (64, 64): 1.0, (256, 64): 3.0, (256, 256): 5.0},
}


class Case(NamedTuple):
    """A pair of a family, and which operations are measured on it."""

    family: str
    m: int
    n: int
    operations: tuple[str, ...] = (TRAJECTORY, LOOPS)

    def pair(self) -> tuple[Ring, Ring]:
        """Generatrix and directrix."""
        return (families.FAMILIES | families.ANY_SHAPE)[self.family](self.m, self.n, 0)

    def bar(self, operation: str) -> float | None:
        """The least ratio of CGAL's time to the kernel's that is asked for."""
        if self.family in ANY_SHAPE:
            return ANY_SHAPE[self.family].get((self.m, self.n))
        if operation == LOOPS:
            bars = {(16, 16): 2.5, (64, 64): 6.0, (256, 64): 5.0, (256, 256): 20.0}
        elif self.family in ("mm", "stair"):
            bars = {(16, 16): 2.5, (64, 64): 2.0, (256, 64): 5.0, (256, 256): 5.0}
        else:
            bars = {(16, 16): 2.5, (64, 64): 2.0, (256, 64): 2.0, (256, 256): 2.0}
        return bars.get((self.m, self.n))


_SIZES = ((16, 16), (64, 64), (256, 64), (256, 256))
_LARGE = (
    Case("cc", 10_000, 10_000, (TRAJECTORY,)),
    Case("cm_hard", 1024, 256, (TRAJECTORY,)),
    Case("mm", 1024, 256, (TRAJECTORY,)),
)

CASES = tuple(
    case
    for family in ("cc", "cm", "cm_hard", "mm", "stair")
    for case in (
        *(Case(family, m, n) for m, n in _SIZES),
        *(large for large in _LARGE if large.family == family),
    )
)

CASES += tuple(
    Case(family, m, n, (TRAJECTORY,)) for family, bars in ANY_SHAPE.items() for m, n in bars
)

# Trajectories that are compared only with the making of the output's Fractions.
FLOOR_CASES = (
    Case("cc", 100_000, 100_000, (TRAJECTORY,)),
    Case("cm_hard", 1024, 256, (TRAJECTORY,)),
)
FLOOR_BAR = 3.0
# So is the way from lists of ints to the two Polygons.
READING_BAR = 0.8

MEMORY_CASE = Case("cm_hard", 1024, 256, (TRAJECTORY,))
PAIRS_BARS = {TRAJECTORY: 2000.0, LOOPS: 700.0}
MEMORY_BYTES = 600
MEMORY_FIXED = 50_000_000
