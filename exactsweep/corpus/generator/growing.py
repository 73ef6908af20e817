"""Families of pairs with growing sizes, for the counts of the ledger.

A seeded family takes (m, n, seed), m and n even, and returns a generatrix of n and a directrix of m
vertices as counter-clockwise lists of pairs of ints. `random.Random` draws the same integers on
all platforms.
"""

from fractions import Fraction
from itertools import pairwise
from math import gcd
from random import Random

from exactsweep.corpus.generator.shapes import IntegerPoint, Ring, reflect_ring, walk


def convex(n: int, random: Random, size: int = 1000) -> Ring:
    """Make a convex polygon of n vertices: n/2 random primitive edges and their opposites."""
    edges: set[IntegerPoint] = set()
    while len(edges) < n // 2:
        x, y = random.randrange(1, size + 1), random.randrange(-size, size + 1)
        if gcd(x, y) == 1:
            edges.add((x, y))
    ordered = sorted(edges, key=lambda edge: Fraction(edge[1], edge[0]))
    return walk([*ordered, *reflect_ring(ordered)][:-1])


def zigzag(n: int, random: Random, step: int = 1000, height: int = 1000) -> Ring:
    """Make an X-monotone polygon of n vertices: two random chains on a regular grid of x."""
    half = n // 2 - 1
    bottom = [(step * k, random.randrange(-height, 0)) for k in range(1, half + 1)]
    top = [(step * k, random.randrange(1, height + 1)) for k in range(1, half + 1)]
    return [(0, 0), *bottom, (step * (half + 1), 0), *reversed(top)]


def comb(m: int, width: int, depth: int) -> Ring:
    half = m // 2 - 1
    bottom = [(width * k, -depth if k % 2 else 0) for k in range(1, half + 1)]
    top = [(x, 2 * depth - y) for x, y in bottom]
    return [(0, depth), *bottom, (width * (half + 1), depth), *reversed(top)]


def cc(m: int, n: int, seed: int = 0) -> tuple[Ring, Ring]:
    random = Random(f"cc {m} {n} {seed}")
    size = max(1000, 4 * max(m, n))
    return convex(n, random, size), convex(m, random, size)


def cm(m: int, n: int, seed: int = 0) -> tuple[Ring, Ring]:
    random = Random(f"cm {m} {n} {seed}")
    generatrix = convex(n, random, 100)
    step = max(1, max(x for x, _ in generatrix) // 5)
    return generatrix, zigzag(m, random, step, 4 * step)


def cm_hard(m: int, n: int, seed: int = 0) -> tuple[Ring, Ring]:
    """Make teeth so deep that G moves around each of them: a trajectory of Theta(m n) edges."""
    random = Random(f"cm_hard {m} {n} {seed}")
    generatrix = convex(n, random, 100)
    width = max(x for x, _ in generatrix)
    return generatrix, comb(m, width, 200 * width)


def cm_undercut(m: int, n: int, seed: int = 0) -> tuple[Ring, Ring]:
    """Make gaps narrower than G, so that it rests on two teeth: an inner loop of Theta(m n)."""
    random = Random(f"cm_undercut {m} {n} {seed}")
    generatrix = convex(n, random, 100)
    width = max(x for x, _ in generatrix)
    return generatrix, comb(m, max(1, 2 * width // 5), 200 * width)


def mm(m: int, n: int, seed: int = 0) -> tuple[Ring, Ring]:
    random = Random(f"mm {m} {n} {seed}")
    return zigzag(n, random), zigzag(m, random)


def figure10(m: int, n: int, seed: int = 0) -> tuple[Ring, Ring]:
    n_t = 2 * (n // 4)
    return bumps(m - 2, n_t, n - n_t)


def needles(m: int, n: int) -> tuple[Ring, Ring]:
    """Make an inner loop with order m n^2 edges, by the proof of Lemma 5.5.

    D_b has about m / 3 needles under a high ceiling, at distances of nearly the width of G. G_t has
    `inner_peaks(n)` peaks.
    """
    peaks = inner_peaks(n)
    pitch = 2 * peaks + 2
    top: Ring = []
    for k in range(peaks):
        top += [(k * pitch + k, 0), ((k + 1) * pitch - 1, pitch)]
    top.append((peaks * pitch + peaks, 0))
    generatrix = [(0, 0), (top[-1][0] // 2, -pitch), *top[:0:-1]]
    apart, ceiling = (peaks - 1) * pitch + peaks + 1, 32 * pitch
    directrix: Ring = []
    for k in range(max(2, (m - 1) // 3)):
        x = k * apart
        directrix += [(x - 1, ceiling), (x, 0), (x + 1, ceiling)]
    return generatrix, [*directrix, (directrix[-1][0] // 2, ceiling + 1)]


def inner_peaks(n: int) -> int:
    return max(2, (n - 2) // 2)


def edges_over_needles(m: int, n: int) -> int:
    """Return a lower bound on the edges of the inner boundary of `needles`, by Lemma 5.5."""
    count, peaks = max(2, (m - 1) // 3), inner_peaks(n)
    return 2 * (count - 1) * (peaks * (peaks - 1) - 1)


def ceilings(m: int, n: int) -> tuple[Ring, Ring]:
    """Make order m n^2 undercuts, by the proof of "Number of undercuts, MM"."""
    generatrix, directrix = needles(m, n)
    high = max(y for _, y in generatrix)
    lowered = [(x, min(y, high)) for x, y in directrix[1:-2]]
    return generatrix, [directrix[0], *lowered, *directrix[-2:]]


def undercuts_under_ceilings(m: int, n: int) -> int:
    """Count the undercuts of the lower sweep of `ceilings`, by the same proof."""
    count, peaks = max(2, (m - 1) // 3), inner_peaks(n)
    return (count - 1) * (peaks * (peaks - 1) + 1)


def wide(m: int, n: int, seed: int = 0) -> tuple[Ring, Ring]:
    random = Random(f"wide {m} {n} {seed}")
    generatrix = convex(n, random, 100)
    return [(m * x, m * y) for x, y in generatrix], zigzag(m, random, 10, 10)


def bowls(m: int, n: int, seed: int = 0) -> tuple[Ring, Ring]:
    """Put a convex generatrix below a D_b of four convex chains of about m / 4 edges each."""
    random = Random(f"bowls {m} {n} {seed}")
    ends = [i * (m - 2) // 4 for i in range(5)]
    arcs = [(j - i, k) for i, j in pairwise(ends) for k in range(j - i)]
    bottom = [(60 * x, k * (k - size)) for x, (size, k) in enumerate([*arcs, (1, 0)])]
    return convex(n, random, 100), [*bottom, (60 * ends[-1] // 2, m)]


def rim(m: int, n: int) -> tuple[Ring, Ring]:
    """Make a bottom chain of m / 2 edges, convex except for a notch, below a G with n spikes."""
    width = 10 * n
    arc = [(3 * width + 4 * width * k, 20 * k * k) for k in range((m - 5) // 2 + 1)]
    top = arc[-1][1] + 50
    directrix = [(-x, y) for x, y in reversed(arc)] + [(0, 25 * n), *arc]
    directrix += [(arc[-1][0], top), (-arc[-1][0], top)]
    spikes = [(width - 10 * k - k * k % 7, 40 + 17 * k * k % 31 * (k % 2)) for k in range(n)]
    return [(0, 0), (width, 0), *spikes], directrix


def bumps(m_b: int, n_t: int, n_b: int) -> tuple[Ring, Ring]:
    """Make the pair of Figure 10: m_b / 2 teeth in D_b, n_t / 2 peaks in G_t, a round tip in G_b.

    Each peak passes each tooth at a distinct position, where the tip of G_b, n_b - 2 flat edges
    between steep flanks, adds to the outer boundary of the lower sweep. It has m_b n_t n_b / 4 + 4
    edges, 16 for (2, 4, 6). m_b, n_t and n_b are even.
    """
    flat = n_b - 2
    pitch = 2 * flat + 2
    half = n_t * pitch // 4
    tooth, peak, flank = (flat + 1) * half, (flat + 2) * pitch // 2, (flat + 3) * (half - flat // 2)
    bottom = [(half * k, -tooth if k % 2 else 0) for k in range(m_b + 1)]
    directrix = [*bottom, (half * m_b // 2, tooth)]
    tip = [(half - flat // 2, -flank)]
    for k in range(flat):
        tip.append((tip[-1][0] + 1, tip[-1][1] + 2 * k - flat + 1))
    top = [(pitch * k // 2, peak if k % 2 else 0) for k in range(n_t, 0, -1)]
    return [(0, 0), *tip, *top], directrix


def edges_of_bumps(m_b: int, n_t: int, n_b: int) -> int:
    """Count the edges of the outer boundary of `bumps`: tips, flanks, and two edges at each end."""
    return m_b * n_t * n_b // 4 + 4


def printed_count(m_b: int, n_t: int, n_b: int) -> int:
    return m_b + n_t + (m_b // 2) * (n_t // 2) * (n_b - 2) + 2


def forks(m: int, n: int) -> tuple[Ring, Ring]:
    """Make a no-fit polygon with order (m n)^2 holes: forks with spikes down and to the right.

    D has m / 6 - 1 spikes in each direction, and -G has n / 6 - 1 at distances larger by the factor
    m / 6 - 1; "Size of a no-fit polygon" has the proof. m and n are multiples of 6, at least 18.

    >>> forks(18, 18)[1][:4]
    [(-1, -120), (0, -120), (0, -117), (48, -116)]
    """
    few, many = m // 6 - 1, n // 6 - 1
    reach = 4 * few * many
    long = 3 * reach
    far = 2 * long + reach
    start = far - long - 4
    directrix = [(-1, -far - 4 * few), (0, -far - 4 * few)]
    directrix += [p for i in range(few)[::-1] for p in _spike_right(0, -far - 4 * i, long)]
    directrix += [(0, 0), *(p for i in range(few) for p in _spike_down(far + 4 * i, 0, long))]
    directrix += [(far + 4 * few, 0), (far + 4 * few, 1), (-1, 1)]
    turned = [(-2, 0), *(p for j in range(many) for p in _spike_down(4 * few * j, 0, long))]
    turned.append((start, 0))
    turned += [p for j in range(many)[::-1] for p in _spike_right(start, start - 4 * few * j, long)]
    turned += [(start, start + 2), (start - 1, start + 2), (start - 1, 1), (-2, 1)]
    return [(-x, -y) for x, y in turned], directrix


def _spike_down(x: int, y: int, long: int) -> Ring:
    return [(x - 1, y), (x, y - long), (x + 1, y)]


def _spike_right(x: int, y: int, long: int) -> Ring:
    return [(x, y - 1), (x + long, y), (x, y + 1)]
