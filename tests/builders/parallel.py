"""Edges that are parallel, in the same or the opposite sense."""

from collections.abc import Iterator

from builders.entry import UNIT, Entry, Ring, box, mirrored, scaled, turned, under

TITLE = "Parallel edges, in the same and in the opposite sense"

HEXAGON: Ring = [(0, 0), (2, -1), (4, 0), (4, 2), (2, 3), (0, 2)]
PARALLELOGRAM: Ring = [(0, 0), (4, 1), (5, 3), (1, 2)]
TRAPEZIUM: Ring = [(0, 0), (6, 0), (5, 2), (2, 2)]
TRIANGLE: Ring = [(0, 0), (4, 2), (1, 3)]
SAW: Ring = under([(0, 0), (1, 2), (2, 0), (3, 2), (4, 0), (5, 2), (6, 0)], 4)


def entries() -> Iterator[Entry]:
    yield Entry("boxes", "Rectangles: four pairs of edges", box(5, 3), box(2, 1))
    yield Entry("hexagons", "Hexagons with opposite edges parallel", scaled(HEXAGON, 3), HEXAGON)
    yield Entry(
        "one-edge", "One edge of each is parallel, in the same sense", TRAPEZIUM, PARALLEL_TOP
    )
    yield Entry("one-edge-against", "One edge of each is parallel, in the opposite sense", *AGAINST)
    yield Entry(
        "g-with-itself", "Parallel edges of G's bottom and top; none of D", TRIANGLE, PARALLELOGRAM
    )
    yield Entry(
        "d-with-itself", "Parallel edges of D's bottom and top; none of G", PARALLELOGRAM, TRIANGLE
    )
    yield Entry(
        "all", "Parallelograms of the same directions", scaled(PARALLELOGRAM, 2), PARALLELOGRAM
    )
    yield Entry("saw-and-roof", "Every tooth of a saw fits G's roof", SAW, ROOF)
    yield Entry("saw-and-saw", "Two saws of the same slopes", SAW, turned_saw(3))
    yield Entry("saw-and-long-saw", "The longer saw goes round the shorter one", turned_saw(2), SAW)
    yield Entry("saw-and-box", "Parallel edges in D alone, and vertical ones in both", SAW, UNIT)
    yield Entry("saw-of-two-depths", "Parallel flanks of different lengths", DEEP_SAW, ROOF)
    yield Entry("lines-in-common", "Flanks that lie on common lines", LINED_UP, ROOF)
    yield Entry(
        "mirror-image", "Each slope comes with its opposite", mirrored(TRAPEZIUM), TRAPEZIUM
    )


PARALLEL_TOP: Ring = [(0, 0), (2, -1), (3, 1), (1, 1)]
AGAINST = ([(0, 0), (3, 1), (2, 4)], [(0, 0), (2, -1), (4, 4), (1, 3)])
ROOF: Ring = [(0, 0), (2, 0), (1, 2)]
DEEP_SAW: Ring = under([(0, 0), (1, 2), (2, 0), (4, 4), (6, 0), (7, 2), (8, 0)], 6)
LINED_UP: Ring = under([(0, 0), (1, 2), (2, 2), (3, 4), (4, 4), (5, 2), (6, 2), (7, 0)], 6)


def turned_saw(teeth: int) -> Ring:
    chain = [(k, 2 * (k % 2)) for k in range(2 * teeth + 1)]
    return turned(under(chain, 4))
