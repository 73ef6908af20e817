"""Seeded random pairs for the checks, on small integer grids, where features often coincide.

Besides the paper's classes "CC", "CM" and "MM", the letter "S" stands for a polygon of any shape.
Some pairs have a kind: "weak" polygons have vertical edges, at the ends and inside chains; "large"
ones make the kernel prune; "far" ones have coordinates of 30 digits; in "resting" pairs, a long
edge of G lies on several teeth of D.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from typing import NamedTuple

from exactsweep.corpus.generator.growing import cc, cm, cm_hard, cm_undercut, figure10, mm
from exactsweep.corpus.generator.prng import Prng
from exactsweep.corpus.generator.shapes import Grid, Ring, draw_convex, draw_monotone, untangle
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import Vertex
from exactsweep.paper.claim import Effort
from exactsweep.procedures.chain import split


class Chains(NamedTuple):
    """The chains of a lower sweep; `top` runs from right to left."""

    top: list[Vertex]
    bottom: list[Vertex]
    directrix: list[Vertex]


class SweepPair(NamedTuple):
    """A generatrix and a directrix, X-monotone unless their class is "S"."""

    generatrix: Ring
    directrix: Ring

    @property
    def chains(self) -> Chains:
        bottom, top = split(self.generatrix)
        return Chains(top, bottom, split(self.directrix)[0])


def read_pair(rings: Iterable[Iterable[Sequence[int]]]) -> SweepPair:
    return SweepPair(*([(x, y) for x, y in ring] for ring in rings))


def draw_pair(random: Prng, kind: str, *, strict: bool = True) -> SweepPair:
    generatrix, directrix = (_draw_ring(random, letter, strict=strict) for letter in kind)
    factor = random.choice([1, 1, 2, 7])
    return SweepPair(
        list_corners(generatrix), list_corners([(factor * x, factor * y) for x, y in directrix])
    )


def _draw_ring(random: Prng, letter: str, *, strict: bool) -> Ring:
    if letter == "S":
        return _draw_any(random)
    if letter == "C":
        side = random.choice([2, 4, 9])
        found = draw_convex(random, 9, side)
        return [((side + 1) * x + y, y) for x, y in found] if strict else found
    height, slope = random.choice([2, 5, 30]), random.between(-2, 2)
    ends = {"walls": 0, "pointed": 8} if strict else {"walls": 3, "pointed": 4}
    ring = draw_monotone(random, Grid(cells=(1, 5), widths=(1, 1, 2, 3), height=height, **ends))
    return [(x, y + slope * x) for x, y in ring]


def _draw_any(random: Prng) -> Ring:
    side = random.choice([4, 6, 9])
    while True:
        points = range(random.between(4, 9))
        drawn = [(random.between(0, side), random.between(0, side)) for _ in points]
        with suppress(PolygonError):
            return list_corners(untangle(drawn))


def list_corners(ring: Ring) -> Ring:
    """Return the canonical ring, without collinear vertices."""
    return [(int(x), int(y)) for x, y in Polygon(ring).vertices]


FAR = 10**30 + 57
LARGE: dict[str, tuple[Callable[..., tuple[Ring, Ring]], ...]] = {
    "CC": (cc,),
    "CM": (cm, cm_hard, cm_undercut),
    "MM": (mm, figure10),
}


def draw_large(random: Prng, kind: str) -> SweepPair:
    family = random.choice(LARGE[kind])
    m, n = (4 * random.between(6, 16) for _ in "mn")
    return SweepPair(*family(m, n, random.between(0, 10**6)))


def draw_pairs(effort: Effort, kind: str, count: int, how: str = "") -> Iterator[SweepPair]:
    """Draw pairs that depend only on the seed, the class, the kind `how` and their number."""
    for number in range(count):
        random = effort.random(f"{kind} {how} {number}")
        if how == "large":
            yield draw_large(random, kind)
        elif how == "resting":
            yield draw_resting(random)
        elif how == "far":
            yield SweepPair(*(_move_far(ring) for ring in draw_pair(random, kind)))
        else:
            yield draw_pair(random, kind, strict=not how)


def draw_resting(random: Prng) -> SweepPair:
    """Draw a CM pair in which a sloped edge of G rests on teeth of D."""
    slope, depth, teeth = random.between(-2, 2), random.between(1, 2), random.between(2, 3)
    bottom, x = [(0, 2)], 1
    for _ in range(teeth):
        flat = random.between(0, 1)
        bottom += [(x, 0), (x + flat, 0), (x + flat + 1, depth)]
        x += flat + 2
    end = bottom.pop()[0]
    lid = [(end, 2), (end // 2, 3)]
    wide = random.choice([4, 9])
    pair = [(1, 0), (wide, 0), (wide + 1, 1), (0, 1)], [*bottom, *lid]
    return SweepPair(*(list_corners([(x, y + slope * x) for x, y in ring]) for ring in pair))


def _move_far(ring: Ring) -> Ring:
    return list_corners([(FAR * x + 7**33, FAR * y - 5**41) for x, y in ring])
