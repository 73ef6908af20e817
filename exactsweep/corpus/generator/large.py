"""Families with answers of maximum size, and pairs of unequal size."""

from fractions import Fraction

from exactsweep.corpus.generator.growing import bumps, comb
from exactsweep.corpus.generator.numeric import RationalRings
from exactsweep.corpus.generator.plain import RingPair, grid_pair, monotone_pair
from exactsweep.corpus.generator.prng import Prng
from exactsweep.corpus.generator.shapes import Grid, draw_convex, draw_monotone


def lower_bound_pair(random: Prng) -> RingPair:
    """The sheared pair of Figure 10, or a comb whose teeth a convex polygon follows."""
    if random.chance(1, 2):
        sizes = random.choice([(2, 4, 6), (2, 6, 6), (4, 4, 6), (2, 4, 8), (4, 4, 4), (4, 6, 4)])
        slope = random.between(-3, 3)
        return [[(x, y + slope * x) for x, y in ring] for ring in bumps(*sizes)]
    generatrix = draw_convex(random, 12, 40)
    width = max(x for x, _ in generatrix) - min(x for x, _ in generatrix)
    # In wide gaps G follows each tooth; above narrow gaps it rests on two teeth.
    share = random.choice([1, 2, 5])
    return generatrix, comb(4 * random.between(2, 5), max(1, 2 * width // share), 100 * width)


def long_pair(random: Prng) -> RingPair:
    """Two monotone polygons of up to 60 vertices, with some vertical edges."""
    grid = Grid(cells=(10, 25), widths=(1, 2, 3), height=9, walls=1)
    return draw_monotone(random, grid), draw_monotone(random, grid)


def unequal_pair(random: Prng) -> RationalRings:
    """A pair of the family "grid" or "monotone", one polygon 10**6 to 10**12 times the other."""
    rings = random.choice([grid_pair, monotone_pair])(random)
    ratio = Fraction(10) ** (random.between(6, 12) * random.choice([1, -1]))
    generatrix = [(x * ratio, y * ratio) for x, y in rings[0]]
    return generatrix, [(Fraction(x), Fraction(y)) for x, y in rings[1]]
