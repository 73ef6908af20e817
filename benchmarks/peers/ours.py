"""The kernel, from lists of pairs to lists of Fractions, all checks of the input included."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

import exactsweep
from benchmarks.families import Pair
from benchmarks.peers.worker import Loop


def version() -> str:
    return f"exactsweep {exactsweep.__version__}"


def trajectory(generatrix: Sequence[Pair], directrix: Sequence[Pair]) -> Callable[[], list[Loop]]:
    return lambda: [exactsweep.sweep(generatrix, directrix).trajectory.vertices]


def loops(generatrix: Sequence[Pair], directrix: Sequence[Pair]) -> Callable[[], list[Loop]]:
    def run() -> list[Loop]:
        swept = exactsweep.sweep(generatrix, directrix)
        return [swept.trajectory.vertices, swept.inner.vertices, swept.outer.vertices]

    return run


def floor(generatrix: Sequence[Pair], directrix: Sequence[Pair]) -> Callable[[], list[Loop]]:
    """The floor: the Fractions of the trajectory from its numerators and denominators."""
    vertices = exactsweep.sweep(generatrix, directrix).trajectory.vertices
    ratios = [(c.numerator, c.denominator) for vertex in vertices for c in vertex]

    def run() -> list[Loop]:
        [Fraction(n) if d == 1 else Fraction(n, d) for n, d in ratios]
        return []

    return run
