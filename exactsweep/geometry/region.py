"""Regions: polygons with holes, validated, immutable, in canonical form."""

from __future__ import annotations

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import accumulate

from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.edges import EdgeIndex
from exactsweep.geometry.near import find_near
from exactsweep.geometry.overlap import Relation, find_outside, relate
from exactsweep.geometry.point_set import AffineMap, PointSet
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import lcm_within, read_interface, refuse_number
from exactsweep.geometry.vectors import touch
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.digits import abridge
from exactsweep.numbers.error import prefix_errors
from exactsweep.numbers.number import Area, Point, Rational, Vertex, ratio
from exactsweep.words import write_pair

Vertices = Polygon | Iterable[Iterable[object]]


class Region(PointSet):
    """A polygon with holes; regions are equal if they are the same set of points.

    Args:
        exterior: the outer boundary, as a Polygon or vertices; or a Region or another object with a
            `__geo_interface__`, whose holes are added to the others.
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

    __slots__ = ("_firsts", "_starts", "exterior", "holes")

    exterior: Polygon
    holes: tuple[Polygon, ...]
    # The number of the first vertex of each ring, here and in the input.
    _starts: tuple[int, ...]
    _firsts: tuple[int, ...]

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
        firsts: tuple[int, ...] = (0,)
        if inner:
            if given or not is_checked:
                _check(outer, inner)
            firsts = tuple(accumulate(map(_count_given, (outer, *inner[:-1])), initial=0))
        self._set((outer, *inner), firsts)

    def _set(self, rings: Sequence[Polygon], firsts: Sequence[int]) -> None:
        order = [0, *sorted(range(1, len(rings)), key=lambda k: rings[k].vertices)]
        holes = tuple(rings[k] for k in order[1:])
        sizes = map(len, (rings[0], *holes[:-1])) if holes else ()
        for name, value in (
            ("exterior", rings[0]),
            ("holes", holes),
            ("_starts", tuple(accumulate(sizes, initial=0))),
            ("_firsts", tuple(firsts[k] for k in order)),
        ):
            object.__setattr__(self, name, value)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a Region is immutable: {name} cannot be set")

    @property
    def rings(self) -> tuple[tuple[Point, ...], ...]:
        """The vertices of the exterior and of each hole, all counter-clockwise."""
        return (self.exterior.vertices, *(hole.vertices for hole in self.holes))

    def lattice(self) -> tuple[int, tuple[tuple[Vertex, ...], ...]]:
        """Return `(scale, rings)`, the region on the coarsest integer lattice that contains it.

        The rings have the interior on the left. The scale is that of `Polygon.lattice`.

        Example:
            >>> Region([(0, 0), (3, 0), (0, 3)], [[("1/2", 1), (1, "1/2"), (1, 1)]]).lattice()[1]
            (((0, 0), (6, 0), (0, 6)), ((1, 2), (2, 2), (2, 1)))
        """
        scale, rings = common_lattice((self.exterior, *self.holes))
        return scale, (rings[0], *((ring[0], *ring[:0:-1]) for ring in rings[1:]))

    @property
    def area(self) -> Fraction:
        """The area of the exterior minus the areas of the holes."""
        return Area(self.exterior.area - add_up(hole.area for hole in self.holes))

    @property
    def is_convex(self) -> bool:
        """Whether the region is convex; False if it has holes."""
        return not self.holes and self.exterior.is_convex

    def _image(self, under: AffineMap) -> Region:
        return _restore([ring._image(under) for ring in (self.exterior, *self.holes)], self._firsts)

    def vertex_index(self, k: int) -> int:
        """Return the input index of vertex k, counted across all `rings`.

        The input also starts with the exterior; the holes follow in the given order. Negative k
        count from the end. Raises PolygonError if there is no vertex k.
        """
        first, ring, k = self._ring_of(k, "vertex")
        return first + ring.vertex_index(k)

    def edge_index(self, k: int) -> int:
        """Return the input index of edge k, from vertex k to the next of its ring.

        Edges are counted as in `vertex_index`. If several collinear input edges form edge k, it is
        the first.
        """
        first, ring, k = self._ring_of(k, "edge")
        return first + ring.edge_index(k)

    def _ring_of(self, k: int, what: str) -> tuple[int, Polygon, int]:
        try:
            k = range(len(self))[k]
        except (TypeError, IndexError):
            raise refuse_number(k, what, len(self)) from None
        number = bisect_right(self._starts, k) - 1
        ring = self.holes[number - 1] if number else self.exterior
        return self._firsts[number], ring, k - self._starts[number]

    def __len__(self) -> int:
        return self._starts[-1] + len(self.holes[-1] if self.holes else self.exterior)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, (Polygon, Region)):
            return NotImplemented
        return self.exterior == other.exterior and self.holes == other.holes

    def __hash__(self) -> int:
        # A Region without holes equals its exterior.
        return hash((self.exterior, self.holes) if self.holes else self.exterior)

    def __reduce__(self) -> tuple[object, ...]:
        return _restore, ((self.exterior, *self.holes), self._firsts)

    def __repr__(self) -> str:
        exterior, *holes = (repr(ring) for ring in (self.exterior, *self.holes))
        if any(ring.startswith("<") for ring in (exterior, *holes)):
            return f"<Region of {len(self)} vertices: {self}>"
        lists = [ring.removeprefix("Polygon(")[:-1] for ring in (exterior, *holes)]
        return f"Region({lists[0]}, [{', '.join(lists[1:])}])"

    def __str__(self) -> str:
        return "; hole ".join(map(str, (self.exterior, *self.holes)))

    def _facts(self) -> list[tuple[str, str]]:
        return [("holes", str(len(self.holes))), ("area", abridge(self.area))]


def _restore(rings: Sequence[Polygon], firsts: Sequence[int]) -> Region:
    """Restore a copy with its input numbering, without validation."""
    region = Region.__new__(Region)
    region._set(rings, firsts)
    return region


def _count_given(ring: Polygon) -> int:
    return 1 + max(map(ring.edge_index, range(len(ring))))


AnyPolygon = Polygon | Region
"""A polygon with or without holes; both types have an exterior, holes and rings."""


def to_shape(shape: Region | Vertices, name: str) -> AnyPolygon:
    """Read a Polygon, a Region or the vertices of a polygon: a Region if there are holes.

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


_LONG = 1024
"""Maximum number of bits of the scale of a lattice that regions share."""


def common_lattice(
    polygons: Sequence[Polygon],
) -> tuple[int, list[tuple[Vertex, ...]]]:
    """Put polygons on the coarsest lattice that contains them all, as `to_lattice` does."""
    scale = lcm_within(polygon.lattice()[0] for polygon in polygons)
    if scale is None:
        return 1, [polygon.vertices for polygon in polygons]
    return scale, [
        tuple((x * (scale // own), y * (scale // own)) for x, y in points)
        for own, points in (polygon.lattice() for polygon in polygons)
    ]


def share_lattice(regions: Sequence[Region]) -> tuple[int, list[list[list[Vertex]]]]:
    """Put regions on the coarsest integer lattice that contains them all.

    Returns the scale, and the rings of each region times the scale, with the interior on the left.
    If the scale would exceed 1024 bits, scaled numbers would be longer than the originals; then
    it is 1, and vertices off that lattice are Fractions.
    """
    lattices = [region.lattice() for region in regions]
    scale = lcm_within((own for own, _ in lattices), _LONG)

    def place(coordinate: Rational, own: int) -> Rational:
        return coordinate * (scale // own) if scale else ratio(coordinate, own)

    return scale or 1, [
        [[(place(x, own), place(y, own)) for x, y in ring] for ring in rings]
        for own, rings in lattices
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
        (ax, ay, bx, by, k, i), (px, py, qx, qy, j, h) = edges[later][4:], edges[earlier][4:]
        if k == j:
            continue
        shared = touch((ax, ay), (bx, by), (px, py), (qx, qy))
        if shared is None or len(set(shared)) > 1:
            first = f"{names[k]}, edge {polygons[k].edge_index(i)}"
            second = f"{names[j]}, edge {polygons[j].edge_index(h)}"
            along = (bx - ax) * (qy - py) == (by - ay) * (qx - px)
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
        # No edges cross, so a hole only partly inside another one touches it more than once, which
        # `_refuse_parted` rejects.
        is_nested = EdgeIndex([*one.rings, *other.rings]).box == other.box
        if is_nested and relate(one, other) is Relation.OVERLAP:
            raise PolygonError(f"{names[inner]} is inside {names[outer]}")
    _refuse_parted(len(rings), touching, names, scale)


def _refuse_parted(
    rings: int, touching: dict[Vertex, set[int]], names: Sequence[str], scale: int
) -> None:
    """Reject a disconnected interior: the graph of rings and touching points has a cycle."""
    group = list(range(rings))

    def leader(k: int) -> int:
        while group[k] != k:
            k = group[k]
        return k

    for (x, y), there in touching.items():
        leaders = {leader(k) for k in there}
        if len(leaders) < len(there):
            at = write_pair((Fraction(x) / scale, Fraction(y) / scale))
            listed = " and ".join(names[k] for k in sorted(there))
            raise PolygonError(
                f"the interior is disconnected: {listed} touch at {at} and elsewhere"
            )
        for k in leaders:
            group[k] = min(leaders)
