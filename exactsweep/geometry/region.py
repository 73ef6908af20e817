"""Regions: polygons with holes, validated, immutable, in canonical form."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import accumulate, chain, islice

from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.edges import EdgeIndex
from exactsweep.geometry.near import find_near
from exactsweep.geometry.overlap import Relation, find_outside, relate
from exactsweep.geometry.point_set import AffineMap, PointSet
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import LATTICE_BITS, lcm_within, read_interface
from exactsweep.geometry.vectors import cross, minus, touch
from exactsweep.numbers.error import prefix_errors
from exactsweep.numbers.number import Rational, Vertex, ratio
from exactsweep.words import write_pair

Vertices = Polygon | Iterable[Iterable[object]]


class Region(PointSet):
    """A polygon with holes; regions are equal if they are the same set of points.

    Args:
        exterior: the outer boundary, as a Polygon or vertices; or a Region or another object with a
            `__geo_interface__`, whose holes come before `holes`.
        holes: Polygons or their vertices, in any order and orientation.

    Raises:
        PolygonError: a ring is not simple; a hole is not inside the exterior, or overlaps another
            hole; two rings overlap along a segment; the interior is disconnected where rings touch.
            The message names rings "exterior" and "hole k", and vertices and edges by their index
            in the input; edge i runs from vertex i to the next.
        NumberError: a coordinate that is not an exact number.

    Cost: O(n log n + h n + p) for n vertices, h holes and p pairs of edges whose bounds meet.

    Example:
        >>> plate = Region([(0, 0), (4, 0), (4, 3), (0, 3)], [[(1, 1), (2, 1), (1, 2)]])
        >>> plate.area, len(plate.holes)
        (Fraction(23, 2), 1)
        >>> plate
        Region([(0, 0), (4, 0), (4, 3), (0, 3)], [[(1, 1), (2, 1), (1, 2)]])
    """

    __slots__ = ("_edge_index", "_firsts", "_vertex_index", "exterior", "holes")

    exterior: Polygon
    holes: tuple[Polygon, ...]
    # The input index of the first vertex of each ring.
    _firsts: Sequence[int]

    def __init__(self, exterior: Region | Vertices, holes: Iterable[Vertices] = ()) -> None:
        inner: list[Polygon] = []
        is_checked = isinstance(exterior, Region)
        if isinstance(exterior, Region):
            # Restore the input order of the holes, to keep the feature numbering.
            order = sorted(range(len(exterior.holes)), key=exterior._firsts[1:].__getitem__)
            inner += [exterior.holes[k] for k in order]
            exterior = exterior.exterior
        elif not isinstance(exterior, Polygon):
            exterior, *others = read_interface(exterior) or [exterior]
            inner += [_read_named(hole, f"hole {k}") for k, hole in enumerate(others)]
        outer = _read_named(exterior, "exterior")
        try:
            given = list(holes)
        except TypeError:
            raise PolygonError(f"{type(holes).__name__} is not a sequence of holes") from None
        inner += [_read_named(hole, f"hole {k}") for k, hole in enumerate(given)]
        if inner and (given or not is_checked):
            _check(outer, inner)
        self._set([outer, *inner])

    @staticmethod
    def _trust(rings: Sequence[Polygon], firsts: Sequence[int] = ()) -> Region:
        """Make a Region from its exterior and its holes, without validation."""
        region = Region.__new__(Region)
        region._set(rings, firsts)
        return region

    def _set(self, rings: Sequence[Polygon], firsts: Sequence[int] = ()) -> None:
        if not firsts:
            counts = (1 + max(ring._edge_index) for ring in rings[:-1])
            firsts = [*accumulate(counts, initial=0)]
        order = [0, *sorted(range(1, len(rings)), key=lambda k: rings[k].vertices)]
        placed = [(firsts[k], rings[k]) for k in order]
        for name, value in (
            ("exterior", rings[0]),
            ("holes", tuple(rings[k] for k in order[1:])),
            ("_firsts", [first for first, _ in placed]),
            ("_vertex_index", [first + n for first, ring in placed for n in ring._vertex_index]),
            ("_edge_index", [first + n for first, ring in placed for n in ring._edge_index]),
        ):
            object.__setattr__(self, name, value)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a Region is immutable: {name} cannot be set")

    def lattice(self) -> tuple[int, tuple[tuple[Vertex, ...], ...]]:
        """Return `(scale, rings)`, the region on the coarsest integer lattice that contains it.

        The rings have the interior on the left. The scale is as in `Polygon.lattice`.

        >>> Region([(0, 0), (3, 0), (0, 3)], [[("1/2", 1), (1, "1/2"), (1, 1)]]).lattice()[1]
        (((0, 0), (6, 0), (0, 6)), ((1, 2), (2, 2), (2, 1)))
        """
        scale, (rings,) = share_lattice([self], LATTICE_BITS)
        return scale, tuple(map(tuple, rings))

    @property
    def is_convex(self) -> bool:
        """Whether the region is convex; False if it has holes."""
        return not self.holes and self.exterior.is_convex

    def _image(self, under: AffineMap) -> Region:
        rings = [ring._image(under) for ring in (self.exterior, *self.holes)]
        return Region._trust(rings, self._firsts)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, (Polygon, Region)):
            return NotImplemented
        return self.exterior == other.exterior and self.holes == other.holes

    def __hash__(self) -> int:
        # A Region without holes equals its exterior.
        return hash((self.exterior, self.holes) if self.holes else self.exterior)

    def __reduce__(self) -> tuple[object, ...]:
        return Region._trust, ((self.exterior, *self.holes), self._firsts)

    def __repr__(self) -> str:
        exterior, *holes = (repr(ring) for ring in (self.exterior, *self.holes))
        if any(ring.startswith("<") for ring in (exterior, *holes)):
            return f"<Region of {len(self)} vertices: {self}>"
        lists = [ring.removeprefix("Polygon(")[:-1] for ring in (exterior, *holes)]
        return f"Region({lists[0]}, [{', '.join(lists[1:])}])"

    def __str__(self) -> str:
        return "; hole ".join(map(str, (self.exterior, *self.holes)))


AnyPolygon = Polygon | Region
"""A polygon with or without holes; both types have an exterior, holes and rings."""


def to_shape(shape: Region | Vertices, name: str) -> AnyPolygon:
    """Read a Polygon, a Region or vertices: as a Region if there are holes, else as a Polygon.

    Raises PolygonError or NumberError; the message begins with the name.
    """
    if isinstance(shape, Region):
        return shape if shape.holes else shape.exterior
    if isinstance(shape, Polygon):
        return shape
    with prefix_errors(name):
        exterior, *holes = read_interface(shape) or [shape]
        # A single ring needs no name of its own.
        return Region(exterior, holes) if holes else Polygon(exterior)


def to_region(shape: Region | Vertices, name: str) -> Region:
    """Read a shape as `to_shape` does, but always as a Region."""
    return shape if isinstance(shape, Region) else Region(to_shape(shape, name))


def to_regions(shapes: Iterable[Region | Vertices], name: str) -> tuple[Region, ...]:
    """Read a list of shapes; errors give the index of a shape."""
    if isinstance(shapes, (Polygon, Region)):
        raise PolygonError(f"{name} is a single shape; give a list of shapes")
    return tuple(to_region(shape, f"{name} shape {k}") for k, shape in enumerate(shapes))


def common_lattice(
    polygons: Sequence[Polygon], bits: int = LATTICE_BITS
) -> tuple[int, list[list[Vertex]]]:
    """Put polygons on the coarsest integer lattice that contains them all.

    Returns the scale, and the vertices times the scale. If the scale would have more than the given
    bits, it is 1 and the vertices are unchanged, because scaled numbers would be longer.
    """
    lattices = [polygon.lattice() for polygon in polygons]
    scale = lcm_within((own for own, _ in lattices), bits)

    def place(coordinate: Rational, own: int) -> Rational:
        return coordinate * (scale // own) if scale else ratio(coordinate, own)

    rings = [[(place(x, own), place(y, own)) for x, y in points] for own, points in lattices]
    return scale or 1, rings


def share_lattice(
    regions: Sequence[Region], bits: int = 1024
) -> tuple[int, list[list[list[Vertex]]]]:
    """Put regions on one lattice as `common_lattice` does, with the interior on the left."""
    polygons = chain.from_iterable((region.exterior, *region.holes) for region in regions)
    scale, found = common_lattice([*polygons], bits)
    rings = iter(found)
    return scale, [
        [next(rings), *([hole[0], *hole[:0:-1]] for hole in islice(rings, len(region.holes)))]
        for region in regions
    ]


def _read_named(ring: Vertices, name: str) -> Polygon:
    with prefix_errors(name):
        return Polygon(ring)


def _check(exterior: Polygon, holes: Sequence[Polygon]) -> None:
    """Reject rings that are not the boundary of one region."""
    polygons = [exterior, *holes]
    names = ["the exterior", *(f"hole {k}" for k in range(len(holes)))]
    scale, rings = common_lattice(polygons)
    touching: defaultdict[Vertex, set[int]] = defaultdict(set)
    edges = EdgeIndex(rings).edges
    for later, earlier in sorted((n, m) for m, n in find_near([edge[:4] for edge in edges])):
        (a, b, k, i), (p, q, j, h) = edges[later][4:], edges[earlier][4:]
        if k == j:
            continue
        shared = touch(a, b, p, q)
        if shared is None or len(set(shared)) > 1:
            first = f"{names[k]}, edge {polygons[k].edge_index(i)}"
            second = f"{names[j]}, edge {polygons[j].edge_index(h)}"
            along = cross(minus(b, a), minus(q, p)) == 0
            what = "overlap along a segment" if along else "cross"
            raise PolygonError(f"{first}, and {second} {what}")
        for point in shared:
            touching[point] |= {k, j}
    shapes = [EdgeIndex([ring]) for ring in rings]
    outside = EdgeIndex(find_outside(rings[0], EdgeIndex(rings).box))
    for k, shape in enumerate(shapes[1:], 1):
        if relate(outside, shape) is Relation.OVERLAP:
            raise PolygonError(f"{names[k]} is not inside the exterior")
    for pair in find_near([shape.box for shape in shapes[1:]]):
        inner, outer = sorted((k + 1 for k in pair), key=lambda k: polygons[k].area)
        one, other = shapes[inner], shapes[outer]
        # No edges cross, so a hole only partly inside another touches it more than once, which
        # `_refuse_parted` rejects.
        is_nested = EdgeIndex([*one.rings, *other.rings]).box == other.box
        if is_nested and relate(one, other) is Relation.OVERLAP:
            raise PolygonError(f"{names[inner]} is inside {names[outer]}")
    _refuse_parted(touching, names, scale)


def _refuse_parted(touching: dict[Vertex, set[int]], names: Sequence[str], scale: int) -> None:
    """Reject a disconnected interior: the graph of rings and touching points has a cycle."""
    groups = {k: {k} for k in range(len(names))}
    for (x, y), there in touching.items():
        joined = set().union(*(groups[k] for k in there))
        if len(joined) < sum(len(groups[k]) for k in there):
            at = write_pair((Fraction(x) / scale, Fraction(y) / scale))
            listed = " and ".join(names[k] for k in sorted(there))
            raise PolygonError(
                f"the interior is disconnected: {listed} touch at {at} and elsewhere"
            )
        groups.update(dict.fromkeys(joined, joined))
