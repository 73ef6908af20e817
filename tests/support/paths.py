"""Degenerate paths for sums."""

from fractions import Fraction
from random import Random

from exactsweep import Polyline, Region


def draw_path(rng: Random, shape: Region) -> Polyline:
    """Draw a path that may cross or retrace itself, with segments as long as parts of a shape."""
    vertices = [p for ring in shape.rings for p in ring]
    points = [(Fraction(rng.randint(-4, 4)), Fraction(rng.randint(-4, 4)))]
    size = rng.randint(2, 6)
    while len(points) < size:
        (x, y), (p, q) = points[-1], rng.sample(vertices, 2)
        along = x + q.x - p.x, y + q.y - p.y
        moved = [(x + rng.randint(-5, 5), y), (x, y + rng.randint(-5, 5)), (-x, 1 - y)]
        points.append(rng.choice([along, *moved, rng.choice(points)]))
    path = Polyline(points, closed=rng.random() < 0.4)
    return path if len(path) > 1 else draw_path(rng, shape)
