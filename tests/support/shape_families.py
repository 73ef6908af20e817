"""Seeded pairs of shapes of any kind: the families of the corpus, with extreme sizes.

The only source of randomness is one `random.Random`, so the seed reproduces a pair.
"""

import math
from fractions import Fraction
from random import Random
from typing import NamedTuple

from cells import Holed

from exactsweep import Polygon, PolygonError, Region
from exactsweep.corpus.generator import FAMILIES, any_shape
from exactsweep.corpus.generator.prng import Prng
from exactsweep.corpus.generator.shapes import untangle

SCALES = [Fraction(1), Fraction(1), Fraction(7, 3), Fraction(10**30), Fraction(1, 10**30)]


class ShapePair(NamedTuple):
    """D, G and their origin."""

    family: str
    placement: str
    directrix: Holed
    generatrix: Holed


def untangled(rng: Random, most: int = 12, side: int = 9) -> Polygon:
    """Draw a simple polygon by reversing parts of a random tour until no edges cross."""
    while True:
        n = rng.randint(3, most)
        points = [(rng.randint(0, side), rng.randint(0, side)) for _ in range(n)]
        try:
            return Polygon(untangle(dict.fromkeys(points)))
        except PolygonError:
            continue


def draw_radial_pair(random: Prng) -> any_shape.Regions:
    """Draw two star-shaped polygons with a vertex in each direction."""

    def draw_radial() -> Region:
        n, size = random.between(5, 14), random.choice([9, 30, 1000])
        turn = 2 * math.pi / n
        reach = [random.between(35, 100) / 100 * size for _ in range(n)]
        return Region(
            [
                (round(r * math.cos(k * turn)), round(r * math.sin(k * turn)))
                for k, r in enumerate(reach)
            ]
        )

    return draw_radial(), draw_radial()


OF_ANY_SHAPE = [family for family in FAMILIES.values() if family.level == "any shape"]
SHAPES: dict[str, any_shape.Draw] = {f.name: f.make for f in OF_ANY_SHAPE}
SHAPES["radial"] = draw_radial_pair


def random_shapes(rng: Random, families: tuple[str, ...] = tuple(SHAPES)) -> ShapePair:
    """Draw a pair of shapes, placed."""
    family, scale = rng.choice(families), rng.choice(SCALES)
    pair = any_shape.place(Prng(str(rng.getrandbits(64))), SHAPES[family], [scale])
    g, d = (Holed(region.exterior, region.holes) for region in pair)
    placement = "minute" if scale < 1 else "huge" if scale > 10 else "as built"
    return ShapePair(family, placement, d, g)
