"""Families that stress arithmetic, and families of large or unequal pairs."""

from collections.abc import Sequence
from fractions import Fraction

from exactsweep.corpus.generator import shapes
from exactsweep.corpus.generator.growing import bumps, comb
from exactsweep.corpus.generator.plain import RingPair, fits_pair, grid_pair, monotone_pair
from exactsweep.corpus.generator.prng import Prng
from exactsweep.geometry.vectors import find_hull

NEAR = 10**15
Rationals = list[tuple[Fraction, Fraction]]
RationalRings = Sequence[Rationals]


def rounded_crossings_pair(random: Prng) -> RingPair:
    """Steep edges over coprime widths: the answer is not on the grid.

    Crossings have denominators of about 7 digits. Rounding their x to an integer changes y by
    thousands on the steepest edges.
    """
    grid = shapes.Grid(cells=(2, 6), widths=(997, 1009, 1013, 2003, 3), height=100_003, pointed=5)
    directrix = shapes.draw_monotone(random, grid)
    if random.chance(1, 3):
        return shapes.draw_convex(random, 7, 1999), directrix
    return shapes.draw_monotone(random, grid), directrix


def near_parallel_pair(random: Prng) -> RingPair:
    """Slopes that differ by one part in 10**15 in both polygons; coordinates within 2**53."""
    return _ripple(random), _ripple(random)


def near_fits_pair(random: Prng) -> RingPair:
    """A pair of the family "fits", up to 2**48 times larger, with some walls moved by one.

    Slots are as wide as G, or wider or narrower by one part in 2**48.
    """
    return _perturb(random, fits_pair(random))


def perturbed_pair(random: Prng) -> RingPair:
    """A pair of the family "grid", up to 2**48 times larger, with some vertices moved by one."""
    return _perturb(random, grid_pair(random))


def slivers_pair(random: Prng) -> RingPair:
    """Polygons of height 1 to 3 on a length of 10**5 to 10**9."""
    length = 10 ** random.between(5, 9)
    unit = length // 4
    grid = shapes.Grid(cells=(1, 4), widths=(unit, unit + 1, unit - 1), height=1, pointed=6)
    first = shapes.draw_monotone(random, grid)
    second = random.choice(
        [
            shapes.draw_monotone(random, grid),
            shapes.draw_convex(random, 8, 12),
            shapes.draw_monotone(random, grid),
        ]
    )
    return (first, second) if random.chance(1, 2) else (second, first)


def int32_edge_pair(random: Prng) -> RingPair:
    """Coordinates from -2**31 to 2**31 - 1, both included."""
    return _full_range(random, 31), _full_range(random, 31)


def int64_edge_pair(random: Prng) -> RingPair:
    """Coordinates from -2**63 to 2**63 - 1, both included."""
    return _full_range(random, 63), _full_range(random, 63)


def far_pair(random: Prng) -> RingPair:
    """A small pair, each polygon translated by up to 2**52: only the last digits matter."""
    rings = random.choice([grid_pair, monotone_pair, fits_pair])(random)
    return [_move(random, ring, 2**52) for ring in rings]


def binary64_edge_pair(random: Prng) -> RationalRings:
    """A small pair times a power of two, from the least binary64 to near the greatest.

    Some pairs are from the family "perturbed", whose coordinates have 53 bits.
    """
    exponent = random.choice([-1074, -1060, -1022, -540, -300, 300, 480, 960, 1010])
    make = random.choice([grid_pair, monotone_pair, fits_pair, perturbed_pair])
    # Sums of all coordinates stay below 2**1024.
    unit = Fraction(2) ** min(exponent, 960 if make is perturbed_pair else 1010)
    return [[(x * unit, y * unit) for x, y in ring] for ring in make(random)]


def fractions_pair(random: Prng) -> RationalRings:
    """Coordinates with small denominators, or with some up to a million that share few factors."""
    most = random.choice([9, 10**6])
    return [_fractional(random, ring, most) for ring in monotone_pair(random)]


def _ripple(random: Prng) -> shapes.Ring:
    slope = random.choice([0, 1, NEAR])
    if random.chance(1, 4):
        steps = [(NEAR, slope + random.between(-3, 3)) for _ in range(random.between(2, 3))]
        return find_hull(
            [*shapes.walk(steps), (0, 1 + abs(slope)), (NEAR, random.between(4, 9) + abs(slope))]
        )
    bottom, top = (
        shapes.walk((NEAR, slope + random.between(-2, 2)) for _ in range(random.between(1, 3)))
        for _ in "bt"
    )
    return shapes.close_between(random, bottom, top)


def _perturb(random: Prng, rings: RingPair) -> RingPair:
    scale = 2 ** random.choice([10, 24, 40, 48])
    return [_nudge(random, ring, scale) for ring in rings]


def _nudge(random: Prng, ring: shapes.Ring, scale: int) -> shapes.Ring:
    # Vertices with equal x stay together, so the ring stays monotone.
    aside = {x: random.between(-1, 1) for x in sorted({x for x, _ in ring})}
    return [(scale * x + aside[x], scale * y + random.between(-1, 1)) for x, y in ring]


def _full_range(random: Prng, bits: int) -> shapes.Ring:
    low, high = -(2**bits), 2**bits - 1
    edge = [low, low + 1, high - 1, high]

    def anywhere() -> int:
        return random.choice(edge) if random.chance(1, 3) else random.between(low, high)

    if random.chance(1, 2):
        corners = [(anywhere(), anywhere()) for _ in range(random.between(3, 7))]
        found = find_hull(corners)
        return found if len(found) > 2 else [(low, low), (high, low), (low, high)]
    xs = sorted({low, high, *(anywhere() for _ in range(random.between(1, 3)))})
    bottom: list[shapes.IntegerPoint] = [(x, random.between(low, -1)) for x in xs]
    top: list[shapes.IntegerPoint] = [(x, random.between(1, high)) for x in xs]
    bottom[0], top[-1] = (low, low), (high, high)
    return [*bottom, *reversed(top)]


def _move(random: Prng, ring: shapes.Ring, most: int) -> shapes.Ring:
    dx, dy = (random.between(-most, most) for _ in "xy")
    return [(x + dx, y + dy) for x, y in ring]


def _fractional(random: Prng, ring: shapes.Ring, most: int) -> Rationals:
    # Vertices with equal x stay together, and keep their order.
    def share() -> Fraction:
        denominator = random.between(3, most)
        return Fraction(random.between(0, (denominator - 1) // 3), denominator)

    aside = {x: share() for x in sorted({x for x, _ in ring})}
    return [(x + aside[x], y + share()) for x, y in ring]


def lower_bound_pair(random: Prng) -> RingPair:
    """The sheared pair of Figure 10, or a comb whose teeth a convex polygon follows."""
    if random.chance(1, 2):
        sizes = random.choice([(2, 4, 6), (2, 6, 6), (4, 4, 6), (2, 4, 8), (4, 4, 4), (4, 6, 4)])
        slope = random.between(-3, 3)
        return [[(x, y + slope * x) for x, y in ring] for ring in bumps(*sizes)]
    generatrix = shapes.draw_convex(random, 12, 40)
    width = max(x for x, _ in generatrix) - min(x for x, _ in generatrix)
    # In wide gaps G follows each tooth; above narrow gaps it rests on two teeth.
    share = random.choice([1, 2, 5])
    return generatrix, comb(4 * random.between(2, 5), max(1, 2 * width // share), 100 * width)


def long_pair(random: Prng) -> RingPair:
    """Two monotone polygons of up to 60 vertices, with some vertical edges."""
    grid = shapes.Grid(cells=(10, 25), widths=(1, 2, 3), height=9, walls=1)
    return shapes.draw_monotone(random, grid), shapes.draw_monotone(random, grid)


def unequal_pair(random: Prng) -> RationalRings:
    """A pair of the family "grid" or "monotone", one polygon 10**6 to 10**12 times the other."""
    rings = random.choice([grid_pair, monotone_pair])(random)
    ratio = Fraction(10) ** (random.between(6, 12) * random.choice([1, -1]))
    generatrix = [(x * ratio, y * ratio) for x, y in rings[0]]
    return generatrix, [(Fraction(x), Fraction(y)) for x, y in rings[1]]
