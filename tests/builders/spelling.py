"""The same polygons in other words: collinear and repeated vertices, orientation, first vertex."""

from collections.abc import Iterator
from fractions import Fraction

from builders.entry import UNIT, Entry, Ring, box

TITLE = "Collinear and repeated vertices, clockwise input, any first vertex"

HOUSE: Ring = [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]
BLOCK: Ring = [(0, 0), (8, 0), (8, 5), (7, 5), (3, 1), (2, 5), (0, 5)]


def entries() -> Iterator[Entry]:
    yield Entry("plain", "The pair of this theme, in canonical form", BLOCK, HOUSE)
    yield Entry("clockwise-d", "D clockwise", BLOCK[::-1], HOUSE)
    yield Entry("clockwise-g", "G clockwise", BLOCK, HOUSE[::-1])
    yield Entry("clockwise-both", "Both clockwise", BLOCK[::-1], HOUSE[::-1])
    for k in range(1, 5):
        yield Entry(
            f"from-vertex-{k}", f"Both from vertex {k} on", started(BLOCK, k), started(HOUSE, k)
        )
    yield Entry("midpoints-d", "A collinear vertex in every edge of D", split(BLOCK, 2), HOUSE)
    yield Entry("midpoints-g", "A collinear vertex in every edge of G", BLOCK, split(HOUSE, 2))
    yield Entry(
        "midpoints-both", "A collinear vertex in all edges", split(BLOCK, 2), split(HOUSE, 2)
    )
    yield Entry(
        "thirds-both",
        "Two collinear vertices in all edges, on thirds",
        split(BLOCK, 3),
        split(HOUSE, 3),
    )
    yield Entry("many-in-one-edge", "Nine collinear vertices in one edge", MANY, HOUSE)
    yield Entry("twice-each-d", "Every vertex of D twice", repeated(BLOCK, 2), HOUSE)
    yield Entry("twice-each-g", "Every vertex of G twice", BLOCK, repeated(HOUSE, 2))
    yield Entry(
        "thrice-each", "Every vertex of both three times", repeated(BLOCK, 3), repeated(HOUSE, 3)
    )
    yield Entry(
        "everything",
        "Clockwise, from another vertex on, with collinear and repeated vertices",
        repeated(split(started(BLOCK, 3), 2), 2)[::-1],
        repeated(split(started(HOUSE, 2), 2), 2)[::-1],
    )
    yield Entry(
        "collinear-square",
        "A square with a vertex in the middle of each side",
        box(2, 2),
        split(box(2, 2), 2),
    )
    yield Entry(
        "collinear-start",
        "The first vertex is collinear",
        started(split(UNIT, 2), 1),
        started(split(HOUSE, 2), 3),
    )
    yield Entry(
        "collinear-vertical",
        "Collinear vertices in vertical edges only",
        [(0, 0), (3, 0), (3, 1), (3, 2), (0, 2), (0, 1)],
        [(0, 0), (1, 0), (1, Fraction(1, 2)), (1, 1), (0, 1)],
    )
    slot: Ring = [(0, 0), (1, 0), (1, 2), (2, 2), (2, 0), (3, 0), (3, 3), (0, 3)]
    dart: Ring = [(0, 0), (4, 3), (0, 6), (1, 3)]
    for slug, title, d, g in [
        ("house", "A house around a notched block", BLOCK, HOUSE),
        ("convex", "A triangle around a diamond", DIAMOND, HOUSE[1:4]),
        ("notched", "A notched block around itself", BLOCK, BLOCK),
        ("fit", "A square into a slot that fits", slot, UNIT),
        ("dart", "A dart around a dart", dart, [(-x, y + 1) for x, y in dart[::-1]]),
    ]:
        yield Entry(f"both-clockwise-{slug}", f"{title}, both clockwise", d[::-1], g[::-1])
        for name, k in (("first", 0), ("last", -1)):
            yield Entry(
                f"{name}-twice-{slug}",
                f"{title}, the {name} vertices twice",
                with_twice(d, k),
                with_twice(g, k),
            )
            yield Entry(
                f"{name}-twice-clockwise-{slug}",
                f"{title}, both clockwise and the {name} vertices twice",
                with_twice(d[::-1], k),
                with_twice(g[::-1], k),
            )


MANY: Ring = [*((Fraction(4 * k, 5), 0) for k in range(10)), *BLOCK[1:]]


DIAMOND: Ring = [(0, 0), (2, -2), (5, 0), (2, 2)]


def with_twice(ring: Ring, k: int) -> Ring:
    """With the first or the last vertex twice in a row."""
    return [ring[0], *ring] if k == 0 else [*ring, ring[-1]]


def started(ring: Ring, first: int) -> Ring:
    return [*ring[first:], *ring[:first]]


def repeated(ring: Ring, times: int) -> Ring:
    return [vertex for vertex in ring for _ in range(times)]


def split(ring: Ring, parts: int) -> Ring:
    """With every edge cut into so many equal ones."""
    spelled = []
    for (ax, ay), (bx, by) in zip(ring, [*ring[1:], ring[0]], strict=True):
        for k in range(parts):
            share = Fraction(k, parts)
            spelled.append((ax + share * (bx - ax), ay + share * (by - ay)))
    return spelled
