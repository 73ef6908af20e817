"""What a builder says of a case: the input alone, never an answer."""

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from exactsweep import Region
from exactsweep.corpus.generator.cells import Matrix, map_region

Ring = Sequence[tuple[Any, Any]]
UNIT: Ring = [(0, 0), (1, 0), (1, 1), (0, 1)]


class Entry(NamedTuple):
    """The input of a case; its id is the theme, a hyphen and the slug."""

    slug: str
    title: str
    d: Ring | Region
    g: Ring | Region
    flags: tuple[str, ...] = ()
    reference: tuple[Any, Any] = (0, 0)
    inside: bool = False  # whether G is to be put inside D, too; of any shapes it is anyway
    note: str = ""
    d_holes: tuple[Ring, ...] = ()
    g_holes: tuple[Ring, ...] = ()


SLANTED: Matrix = ((3, -4), (4, 3))
SHEARED: Matrix = ((1, 2), (0, 1))


def in_places(slug: str, title: str, d: Region, g: Region) -> Iterator[Entry]:
    """A pair as drawn, and slanted, sheared and scaled, and with another reference point."""
    yield Entry(slug, title, d, g, inside=True)
    slanted_d, slanted_g = (map_region(shape, SLANTED) for shape in (d, g))
    yield Entry(f"{slug}-slanted", f"{title}, slanted 3 in 4", slanted_d, slanted_g, inside=True)
    third = Fraction(1, 3)
    d, g = (map_region(shape, SHEARED, third, (5, -2)) for shape in (d, g))
    title = f"{title}, sheared, on thirds"
    yield Entry(f"{slug}-thirds", title, d, g, reference=g.vertices[-1], inside=True)


def box(width: Any, height: Any, x: Any = 0, y: Any = 0) -> Ring:
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def scaled(ring: Ring, factor: int | Fraction) -> Ring:
    return [(x * factor, y * factor) for x, y in ring]


def moved(ring: Ring, dx: Any, dy: Any) -> Ring:
    return [(x + dx, y + dy) for x, y in ring]


def mirrored(ring: Ring) -> Ring:
    """Left and right exchanged, counter-clockwise again."""
    return [(-x, y) for x, y in reversed(ring)]


def turned(ring: Ring) -> Ring:
    """By half a turn."""
    return [(-x, -y) for x, y in ring]


def mapped(ring: Ring, matrix: tuple[int, int, int, int]) -> Ring:
    """By a matrix with positive determinant, its rows one after the other."""
    a, b, c, d = matrix
    return [(a * x + b * y, c * x + d * y) for x, y in ring]


def under(bottom: Iterable[tuple[Any, Any]], lid: Any) -> Ring:
    """A block with this bottom chain, from left to right, and a flat top."""
    chain = [*bottom]
    return [*chain, (chain[-1][0], lid), (chain[0][0], lid)]


def columns(widths: Sequence[Any], heights: Sequence[Any]) -> list[tuple[Any, Any]]:
    """A chain of horizontal and vertical edges, from x = 0 on."""
    chain: list[tuple[Any, Any]] = []
    x = 0
    for width, height in zip(widths, heights, strict=True):
        chain += [(x, height), (x + width, height)]
        x += width
    return chain
