"""Regions: polygons with holes, validated, immutable, in canonical form."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain

from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.lattice import lcm_within
from exactsweep.geometry.overlap import Places, find_points_between, is_inside, touch
from exactsweep.geometry.point_set import AffineMap, PointSet
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_interface, refuse_number
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.error import name_refusals
from exactsweep.numbers.number import abridge
from exactsweep.numbers.point import Point, Vertex
from exactsweep.words import write_pair, write_size

Vertices = Polygon | Iterable[Iterable[object]]


class Region(PointSet):
    """A polygon with holes; equal to another when both are the same set of points.

    Args:
        exterior: the outer boundary, a Polygon or its vertices as `Polygon` takes them; or a
            Region, or another object with a `__geo_interface__`, whose holes then count with the
            others.
        holes: the holes, likewise, in any order and orientation.

    Raises:
        PolygonError: a ring is not simple; a hole is not inside the exterior, or overlaps another
            one; two rings run along each other, or touch in so many points that the interior falls
            apart. Rings are named "exterior" and "hole k", their vertices and edges by their index
            in the input; edge i runs from vertex i to the next.
        NumberError: a coordinate that is not an exact number.

    Cost: O(n log n + p) for n vertices, p pairs of edges whose bounds meet, and O(n) for each hole.

    Example:
        >>> plate = Region([(0, 0), (4, 0), (4, 3), (0, 3)], [[(1, 1), (2, 1), (1, 2)]])
        >>> plate.area, len(plate.holes)
        (Fraction(23, 2), 1)
        >>> plate
        Region([(0, 0), (4, 0), (4, 3), (0, 3)], [[(1, 1), (2, 1), (1, 2)]])
    """

    __slots__ = ("_given", "_order", "exterior", "holes")

    exterior: Polygon
    holes: tuple[Polygon, ...]
    _order: tuple[int, ...]
    _given: tuple[Polygon, ...]

    def __init__(self, exterior: Region | Vertices, holes: Iterable[Vertices] = ()) -> None:
        inner: list[Polygon] = []
        if isinstance(exterior, Region):
            inner += exterior.holes
            exterior = exterior.exterior
        elif not isinstance(exterior, Polygon):
            exterior, *told = read_interface(exterior) or [exterior]
            inner += [_read_named(hole, f"hole {k}") for k, hole in enumerate(told)]
        outer = _read_named(exterior, "exterior")
        try:
            given = list(holes)
        except TypeError:
            raise PolygonError(f"{type(holes).__name__} is not a sequence of holes") from None
        inner += [_read_named(hole, f"hole {k}") for k, hole in enumerate(given)]
        if inner:
            _check(outer, inner)
        order = sorted(range(len(inner)), key=lambda k: inner[k].vertices)
        object.__setattr__(self, "exterior", outer)
        object.__setattr__(self, "holes", tuple(inner[k] for k in order))
        # Places in the caller's input, which most never ask for.
        object.__setattr__(self, "_order", (0, *(k + 1 for k in order)))
        object.__setattr__(self, "_given", (outer, *inner))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a Region is immutable: {name} cannot be set")

    @property
    def rings(self) -> tuple[tuple[Point, ...], ...]:
        """The vertices of the exterior and of each hole, all counter-clockwise."""
        return (self.exterior.vertices, *(hole.vertices for hole in self.holes))

    @property
    def vertices(self) -> tuple[Point, ...]:
        """The vertices of all `rings`, one after another."""
        return tuple(chain.from_iterable(self.rings))

    def lattice(self) -> tuple[int, tuple[tuple[Vertex, ...], ...]]:
        """Return the region on the coarsest integer lattice that holds it.

        Returns:
            `(scale, rings)`: the exterior counter-clockwise and the holes clockwise, so that the
            interior is on the left of all; each point is a vertex times the scale. The scale is as
            for `Polygon.lattice`.

        Example:
            >>> Region([(0, 0), (3, 0), (0, 3)], [[("1/2", 1), (1, "1/2"), (1, 1)]]).lattice()[1]
            (((0, 0), (6, 0), (0, 6)), ((1, 2), (2, 2), (2, 1)))
        """
        scale, rings = common_lattice((self.exterior, *self.holes))
        return scale, (rings[0], *((ring[0], *ring[:0:-1]) for ring in rings[1:]))

    @property
    def area(self) -> Fraction:
        """The area: that of the exterior less those of the holes."""
        return self.exterior.area - add_up(hole.area for hole in self.holes)

    @property
    def is_convex(self) -> bool:
        """Whether it is convex, which it is not with a hole."""
        return not self.holes and self.exterior.is_convex

    @property
    def bounding_box(self) -> tuple[Point, Point]:
        """The lower left and the upper right corner of the least axis-parallel rectangle."""
        return self.exterior.bounding_box

    def _image(self, under: AffineMap) -> Region:
        return self._like([ring._image(under) for ring in (self.exterior, *self.holes)])

    def _like(self, rings: Sequence[Polygon]) -> Region:
        """The region of other rings, in the order of this one's, which need no checking."""
        order = sorted(range(1, len(rings)), key=lambda k: rings[k].vertices)
        holes = tuple(rings[k] for k in order)
        return _restore(rings[0], holes, (0, *(self._order[k] for k in order)), self._given)

    def vertex_index(self, k: int) -> int:
        """Return the index in the caller's input of vertex k, counted through all `rings`.

        The input is counted through, too: the exterior, then the holes in the order given.

        Raises:
            PolygonError: there is no vertex k; as in a list, those below 0 count from the end.
        """
        ring, k = self._ring_of(k, "vertex")
        return self._first_index(self._order[ring]) + self._polygon(ring).vertex_index(k)

    def edge_index(self, k: int) -> int:
        """Return the index in the caller's input of edge k, from vertex k to the next of its ring.

        Counted as for `vertex_index`; of collinear edges the first, as for `Polygon`.

        Raises:
            PolygonError: there is no edge k.
        """
        ring, k = self._ring_of(k, "edge")
        return self._first_index(self._order[ring]) + self._polygon(ring).edge_index(k)

    def _first_index(self, ring: int) -> int:
        """How many vertices the caller gave before those of a ring."""
        before = self._given[:ring]
        return sum(1 + max(map(given.edge_index, range(len(given)))) for given in before)

    def _polygon(self, ring: int) -> Polygon:
        return self.holes[ring - 1] if ring else self.exterior

    def _ring_of(self, k: int, what: str) -> tuple[int, int]:
        try:
            k = range(len(self))[k]
        except (TypeError, IndexError):
            raise refuse_number(k, what, len(self)) from None
        ring = 0
        while k >= len(self._polygon(ring)):
            k -= len(self._polygon(ring))
            ring += 1
        return ring, k

    def __len__(self) -> int:
        return len(self.exterior) + sum(map(len, self.holes))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Region):
            return NotImplemented
        return self.exterior == other.exterior and self.holes == other.holes

    def __hash__(self) -> int:
        return hash((self.exterior, self.holes))

    def __reduce__(self) -> tuple[object, ...]:
        return _restore, (self.exterior, self.holes, self._order, self._given)

    def __repr__(self) -> str:
        holes = ", ".join(repr(hole).removeprefix("Polygon(")[:-1] for hole in self.holes)
        return f"Region({repr(self.exterior).removeprefix('Polygon(')[:-1]}, [{holes}])"

    def __str__(self) -> str:
        return "; hole ".join(map(str, (self.exterior, *self.holes)))

    def _repr_svg_(self) -> str:
        from exactsweep.canvas.svg import draw_rings

        return draw_rings(self.rings, write_size(len(self), self.area))

    def _repr_html_(self) -> str:
        from exactsweep.canvas.svg import put_beside

        low, high = self.bounding_box
        rows = [
            ("vertices", str(len(self))),
            ("holes", str(len(self.holes))),
            ("area", abridge(self.area)),
            ("from", write_pair(low)),
            ("to", write_pair(high)),
        ]
        return put_beside(self._repr_svg_(), rows)


def _restore(
    exterior: Polygon,
    holes: tuple[Polygon, ...],
    order: tuple[int, ...],
    given: tuple[Polygon, ...],
) -> Region:
    """Make a copy, which has the numbers of the input and needs no checking."""
    region = Region(exterior)
    for name, value in (("holes", holes), ("_order", order), ("_given", given)):
        object.__setattr__(region, name, value)
    return region


def walk_rings(shape: Polygon | Region) -> Iterator[tuple[int, int, int]]:
    """Count the vertices through all rings of a shape.

    Yields:
        The number of the vertex before, of a vertex, and of the next one of its ring.

    Example:
        >>> plate = Region([(0, 0), (4, 0), (0, 4)], [[(1, 1), (2, 1), (1, 2)]])
        >>> list(walk_rings(plate))
        [(2, 0, 1), (0, 1, 2), (1, 2, 0), (5, 3, 4), (3, 4, 5), (4, 5, 3)]
    """
    first = 0
    for ring in shape.rings:
        size = len(ring)
        for k in range(size):
            yield first + (k - 1) % size, first + k, first + (k + 1) % size
        first += size


def number_features(
    shape: Polygon | Region,
) -> tuple[dict[int, Point], dict[int, tuple[int, int]]]:
    """Find the features of a shape by the numbers that they have in the input.

    Returns:
        The vertices by number, and of each edge by number the numbers of its two ends.

    Cost: linear.

    Example:
        >>> corners, edges = number_features(Polygon([(0, 0), (0, 1), (2, 0), (1, 0)]))
        >>> sorted(corners), edges[2]
        ([0, 1, 2], (0, 2))
    """
    numbers = [shape.vertex_index(k) for k in range(len(shape))]
    return (
        dict(zip(numbers, shape.vertices, strict=True)),
        {
            shape.edge_index(k): (numbers[k], numbers[following])
            for _, k, following in walk_rings(shape)
        },
    )


def common_lattice(
    polygons: Sequence[Polygon],
) -> tuple[int, list[tuple[Vertex, ...]]]:
    """Put polygons on one lattice, the coarsest that holds them all.

    Returns:
        The scale and, of each polygon, its vertices times the scale; if that had more than 8192
        bits, as for one polygon, 1 and the vertices.
    """
    scale = lcm_within(polygon.lattice()[0] for polygon in polygons)
    if scale is None:
        return 1, [polygon.vertices for polygon in polygons]
    return scale, [
        tuple((x * (scale // own), y * (scale // own)) for x, y in points)
        for own, points in (polygon.lattice() for polygon in polygons)
    ]


def _read_named(ring: Vertices, name: str) -> Polygon:
    with name_refusals(name):
        return Polygon(ring)


def _check(exterior: Polygon, holes: Sequence[Polygon]) -> None:
    """Refuse rings that are not the boundary of one region."""
    polygons = [exterior, *holes]
    names = ["the exterior", *(f"hole {k}" for k in range(len(holes)))]
    scale, rings = common_lattice(polygons)
    places = [Places(set) for _ in rings]
    touching: defaultdict[Vertex, set[int]] = defaultdict(set)
    for (k, i), (j, h) in _near(rings):
        a, b = rings[k][i], rings[k][(i + 1) % len(rings[k])]
        p, q = rings[j][h], rings[j][(h + 1) % len(rings[j])]
        shared = touch(a, b, p, q)
        if shared is None or len(set(shared)) > 1:
            first = f"{names[k]}, edge {polygons[k].edge_index(i)}"
            second = f"{names[j]}, edge {polygons[j].edge_index(h)}"
            along = (b[0] - a[0]) * (q[1] - p[1]) == (b[1] - a[1]) * (q[0] - p[0])
            what = "run along each other" if along else "cross"
            raise PolygonError(f"{first}, and {second} {what}")
        for point in shared:
            touching[point] |= {k, j}
            places[k][0, i].add(point)
            places[j][0, h].add(point)
    for k in range(1, len(rings)):
        if not all(is_inside(p, rings[:1]) for p in find_points_between({0: rings[k]}, places[k])):
            raise PolygonError(f"{names[k]} is not inside the exterior")
    for k, j in _find_enclosed(rings):
        points = find_points_between({0: rings[k]}, places[k])
        if any(is_inside(point, [rings[j]]) for point in points):
            raise PolygonError(f"{names[k]} is inside {names[j]}")
    _refuse_parted(len(rings), touching, names, scale)


def _near(rings: Sequence[Sequence[Vertex]]) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    """The pairs of edges of different rings whose bounds meet."""
    boxes = []
    for k, ring in enumerate(rings):
        for i, (px, py) in enumerate(ring):
            qx, qy = ring[(i + 1) % len(ring)]
            boxes.append((min(px, qx), max(px, qx), min(py, qy), max(py, qy), k, i))
    boxes.sort()
    active: list[tuple[int | Fraction, ...]] = []
    for box in boxes:
        left, _, low, high, k, i = box
        active = [other for other in active if other[1] >= left]
        for _, _, other_low, other_high, j, h in active:
            if j != k and other_low <= high and low <= other_high:
                yield (k, i), (int(j), int(h))
        active.append(box)


def _find_enclosed(rings: Sequence[Sequence[Vertex]]) -> Iterator[tuple[int, int]]:
    """The pairs of holes of which the bounds of the first lie in those of the second."""
    boxes = []
    for k, ring in enumerate(rings[1:], 1):
        xs, ys = zip(*ring, strict=True)
        boxes.append((min(xs), max(xs), min(ys), max(ys), k))
    boxes.sort()
    active: list[tuple[int | Fraction, ...]] = []
    for box in boxes:
        left, right, low, high, k = box
        active = [other for other in active if other[1] >= left]
        for other_left, other_right, other_low, other_high, j in active:
            if right <= other_right and other_low <= low and high <= other_high:
                yield k, int(j)
            if (
                other_left == left
                and other_right <= right
                and low <= other_low <= other_high <= high
            ):
                yield int(j), k
        active.append(box)


def _refuse_parted(
    rings: int, touching: dict[Vertex, set[int]], names: Sequence[str], scale: int
) -> None:
    """Refuse rings whose touching points part the interior.

    It falls apart exactly if one can go from ring to ring through touching points in a circle.
    """
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
                f"the interior falls apart: {listed} touch at {at} and are joined elsewhere, too"
            )
        for k in leaders:
            group[k] = min(leaders)
