"""Seeded pairs of polygons of every class, with deliberate degeneracies.

All shapes are first X-monotone, on small integer grids where features often coincide. Then the
pair is scaled, moved, rotated, and its vertices are listed differently. The only source of
randomness is one `random.Random`, so the seed reproduces a pair.
"""

import random
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.corpus.generator.prng import Prng
from exactsweep.corpus.generator.shapes import (
    Grid,
    close_between,
    draw_convex,
    draw_monotone,
    draw_rectilinear,
    walk,
)
from exactsweep.geometry.vectors import find_hull

IntRing = list[tuple[int, int]]
Ring = list[tuple[Fraction, Fraction]]
Shape = Callable[[random.Random], IntRing]

NEAR = 10**15
WIDTHS = [[1], [1, 2], [1, 1, 1, 4]]
# Rows of invertible matrices, one of them orientation-reversing.
MATRICES = [
    (0, -1, 1, 0),
    (1, 0, 1, 1),
    (1, 1, 0, 1),
    (3, -4, 4, 3),
    (2, 1, 1, 1),
    (1, 2, 3, -1),
    (7, 10**6, 1, 3),
]


class Pair(NamedTuple):
    """Generatrix and directrix as passed to `sweep`, and their shared direction."""

    generatrix: Ring
    directrix: Ring
    direction: tuple[int, int]


def convex(
    rng: random.Random, sides: Sequence[int] = (1, 2, 3, 5, 12, 1000), most: int = 14
) -> IntRing:
    """Draw the hull of grid points, often with vertical or parallel edges."""
    return [*draw_convex(_prng(rng), most, rng.choice(sides))]


def box(rng: random.Random) -> IntRing:
    width, height = rng.randint(1, 3), rng.randint(1, 3)
    return [(0, 0), (width, 0), (width, height), (0, height)]


def fan(rng: random.Random) -> IntRing:
    """Draw a convex ring whose slopes differ by one part in 10**15."""
    steps = [(NEAR, rng.randint(-3, 3)) for _ in range(rng.randint(2, 5))]
    steps += [(NEAR + rng.randint(0, 2), NEAR) for _ in range(rng.randint(0, 2))]
    return [*find_hull([*walk(steps), (0, 1), (NEAR, rng.randint(2, 9))])]


def jagged(rng: random.Random, walls: int = 0, cells: tuple[int, int] = (1, 6)) -> IntRing:
    """Draw bottom and top on independent breakpoints; `walls` eighths have vertical edges."""
    grid = Grid(cells, rng.choice(WIDTHS), rng.choice([1, 2, 4, 9]), walls)
    return draw_monotone(_prng(rng), grid)


def walled(rng: random.Random) -> IntRing:
    return jagged(rng, walls=5)


def long(rng: random.Random) -> IntRing:
    return jagged(rng, walls=rng.choice([0, 2]), cells=(8, 20))


def rectilinear(rng: random.Random) -> IntRing:
    """Draw horizontal and vertical edges: slots and teeth, often of equal width."""
    return draw_rectilinear(_prng(rng), (2, 6), rng.choice(WIDTHS), rng.randint(1, 3))


def teeth(rng: random.Random, depths: Sequence[int] = (1, 3, 1000), most: int = 7) -> IntRing:
    """Draw spikes of few slopes: parallel edges, tangent envelopes."""
    depth = rng.choice(depths)
    steps = [(1, depth), (1, -depth), (1, depth), (1, -depth), (2, 0)]
    chains = [walk([rng.choice(steps) for _ in range(rng.randint(2, most))]) for _ in "bt"]
    bottom, top = chains
    return close_between(_prng(rng), bottom, top)


def ripple(rng: random.Random) -> IntRing:
    """Draw slopes that differ by one part in 10**15, up and down."""
    slope = rng.choice([0, 1, NEAR])
    chains = [
        walk([(NEAR, slope + rng.randint(-2, 2)) for _ in range(rng.randint(2, 5))]) for _ in "bt"
    ]
    bottom, top = chains
    return close_between(_prng(rng), bottom, top)


def mould(rng: random.Random, ring: IntRing) -> IntRing:
    """Draw a directrix with notches that fit the top of a generatrix, usually exactly."""
    top = _top_of(ring)
    ground = min(y for _, y in top) - rng.randint(0, 2)
    bottom: IntRing = [(0, ground)]
    for _ in range(rng.randint(1, 2)):
        gap = rng.choice([1, 2, top[-1][0]])
        factor = rng.choice([1, 1, 1, 2])
        x = bottom[-1][0] + gap
        bottom += [(x, ground), *((x + factor * px, py) for px, py in top)]
        bottom.append((bottom[-1][0], ground))
    bottom.append((bottom[-1][0] + rng.randint(1, 2), ground))
    ceiling = max(y for _, y in bottom) + 1
    return [*bottom, (bottom[-1][0], ceiling), (0, ceiling)]


CONVEX: dict[str, Sequence[Shape]] = {
    "grid": [convex],
    "walls": [box, convex],
    "rectilinear": [box],
    "teeth": [convex],
    "near-parallel": [fan],
    "long": [convex],
}
MONOTONE: dict[str, Sequence[Shape]] = {
    "grid": [jagged],
    "walls": [walled],
    "rectilinear": [rectilinear],
    "teeth": [teeth],
    "near-parallel": [ripple],
    "long": [long],
}
FAMILIES = (*CONVEX, "mould", "same", "opposite", "unequal")
CLASSES = ("CC", "CM", "MC", "MM")


def random_pair(rng: random.Random, families: Sequence[str] = FAMILIES) -> Pair:
    """Draw a pair of any class; an "M" ring may happen to be convex."""
    family = rng.choice(families)
    letters = rng.choice(CLASSES)
    shapes = family if family in CONVEX else rng.choice([*CONVEX][:-1])
    generatrix, directrix = (
        rng.choice((CONVEX if letter == "C" else MONOTONE)[shapes])(rng) for letter in letters
    )
    ratio = Fraction(1)
    if family == "mould":
        directrix = mould(rng, generatrix)
    elif family == "same":
        directrix = generatrix
    elif family == "opposite":
        directrix = [(-x, -y) for x, y in generatrix]
    elif family == "unequal":
        ratio = Fraction(rng.choice(["1/7", "3", "10", "1e9", "1e-9"]))
    return place(rng, _scaled(generatrix, ratio), _scaled(directrix, Fraction(1)))


def place(rng: random.Random, *rings: Ring) -> Pair:
    """Scale, rotate, rewrite and translate both polygons."""
    placement = rng.choice(["as built", "moved", "huge", "minute", "turned", "respelled"])
    direction = (1, 0)
    if placement in ("huge", "minute"):
        unit = Fraction("1e30" if placement == "huge" else "1e-30")
        rings = tuple(_scaled(ring, unit) for ring in rings)
    elif placement == "turned":
        a, b, c, d = rng.choice(MATRICES)
        rings = tuple([(a * x + b * y, c * x + d * y) for x, y in ring] for ring in rings)
        # (d, -b) times the matrix is (ad - bc, 0): the old x-axis.
        direction = (d, -b)
    elif placement == "respelled":
        rings = tuple(respelled(rng, ring) for ring in rings)
    if placement != "as built":
        rings = tuple(_moved(rng, ring) for ring in rings)
    generatrix, directrix = rings
    return Pair(generatrix, directrix, direction)


def respelled(rng: random.Random, ring: Ring) -> Ring:
    """Change first vertex and orientation; add repeated and collinear vertices; close."""
    first = rng.randrange(len(ring))
    ring = [*ring[first:], *ring[:first]]
    spelled: Ring = []
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1], strict=True):
        spelled += [(ax, ay)] * rng.choice([1, 1, 2])
        if rng.random() < 0.4:
            share = Fraction(1, rng.randint(2, 4))
            spelled.append((ax + share * (bx - ax), ay + share * (by - ay)))
    if rng.random() < 0.5:
        spelled.append(spelled[0])
    return spelled[::-1] if rng.random() < 0.5 else spelled


def _prng(rng: random.Random) -> Prng:
    return Prng(str(rng.getrandbits(64)))


def _top_of(ring: IntRing) -> IntRing:
    """Return the top chain of a counter-clockwise ring, from left to right, starting at x = 0."""
    n = len(ring)
    right = max(range(n), key=lambda k: ring[k])
    left = min(range(n), key=lambda k: (ring[k][0], -ring[k][1]))
    chain = [ring[(left - k) % n] for k in range((left - right) % n + 1)]
    return [(x - ring[left][0], y) for x, y in chain]


def _scaled(ring: IntRing | Ring, factor: Fraction) -> Ring:
    return [(x * factor, y * factor) for x, y in ring]


def _moved(rng: random.Random, ring: Ring) -> Ring:
    dx, dy = (Fraction(rng.randint(-9, 9), rng.choice([1, 3])) for _ in "xy")
    return [(x + dx, y + dy) for x, y in ring]
