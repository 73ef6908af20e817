"""Rounding of regions to a decimal grid: to the closest points, outward, or inward.

For outward rounding, each ring has its region on the left. Let v be a vertex between edges e and f.

1. The new vertices for v lie on or right of the lines of e and f, so the old edges lie on or left
   of the new ones.
2. At a left turn, the new vertices are the corners of the grid cell around v that are extreme in
   some direction between the normals of e and f. At a right turn, the new vertex is the closest
   such grid point within reach.
3. In a notch narrower than a cell, new edges may cross, or a right turn may have no grid point.
   Then right turns are dropped, smallest ears first, which fills the notch. The last resort is the
   convex hull of all cells.
4. An exact test proves that the result is a polygon that contains the old one.

Holes are clockwise rings that shrink, and are dropped if nothing is left. When rounding inward,
holes grow, and may merge and divide the region; its parts are rounded again until all vertices are
on the grid.
"""

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import chain, pairwise
from math import ceil, floor
from typing import Literal, NamedTuple

from exactsweep.formats.candidate import NamedRegion
from exactsweep.formats.curved.curves import round_root_up
from exactsweep.formats.error import FormatError
from exactsweep.formats.filling import fill
from exactsweep.geometry import overlap
from exactsweep.geometry.canonical import PolygonError, find_doubled_area
from exactsweep.geometry.distance import measure_to_edge
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region, share_lattice
from exactsweep.geometry.vectors import cross, find_hull, minus, orientation
from exactsweep.numbers.error import explain_type_errors, quote
from exactsweep.numbers.number import Edge, Fit, Point, Rational, Vertex

Side = Literal["closest", "outward", "inward"]
_REACH = 3  # cells to search around the vertex of a right turn
MAX_PLACES = 4000


class Rounding(NamedTuple):
    """Number of decimal places, and whether to round only outward (free regions inward)."""

    places: int
    outward: bool = False


class Rounded(NamedTuple):
    """A rounded region."""

    regions: tuple[Region, ...]  # one, or for "inward" any number
    # Bounds the distance between old and new rings, except dropped rings and merged holes.
    distance: Fraction
    left_out: int = 0  # dropped holes and parts

    @property
    def region(self) -> Region | None:
        """The only region, or None; raises FormatError if there are several."""
        if len(self.regions) > 1:
            raise FormatError(f"rounding leaves {len(self.regions)} regions; see `regions`")
        return self.regions[0] if self.regions else None


class Changes(NamedTuple):
    """The numbers of changed regions and dropped rings, and the maximum distance."""

    changed: int
    distance: Fraction
    left_out: int


@explain_type_errors
def round_regions(
    regions: Iterable[NamedRegion], places: int, side_of: Callable[[NamedRegion], Side]
) -> tuple[list[NamedRegion], Changes]:
    """Round regions to decimals; `side_of` returns the `side` of `round_region` for each.

    >>> third = NamedRegion(Region([(0, 0), (1, 0), (0, "1/3")]), "third", None)
    >>> rounded, changes = round_regions([third], 1, lambda region: "outward")
    >>> print(rounded[0].region, changes.changed)
    (0, 0) (1, 0) (0, 2/5) 1
    """
    found: list[NamedRegion] = []
    changed = left_out = 0
    distance = Fraction(0)
    for named in regions:
        try:
            rounded = round_region(named.region, places, side_of(named))
        except PolygonError as error:
            name = "" if named.name is None else f"{ascii(named.name)[1:-1]}, "
            raise PolygonError(f"{name}rounded to {places} places: {error}") from None
        changed += rounded.regions != (named.region,)
        distance = max(distance, rounded.distance)
        left_out += rounded.left_out
        found += [named._replace(region=region) for region in rounded.regions]
    return found, Changes(changed, distance, left_out)


def round_fits(fits: Sequence[Fit], rounding: Rounding) -> tuple[list[Fit], int]:
    """Round exact fits, and count those that move; outward rounding drops them."""
    places, outward = rounding

    def move(p: Point) -> Point:
        return Point(round(p.x, places), round(p.y, places))

    moved = [(move(p), move(q)) for p, q in fits]
    kept = [fit for fit, to in zip(fits, moved, strict=True) if fit == to]
    return (kept if outward else moved), len(fits) - len(kept)


@explain_type_errors
def round_region(region: Region, places: int, side: Side = "closest") -> Rounded:
    """Round a region to decimals.

    Args:
        region: a Region.
        places: the number of decimal places.
        side: "closest" moves each vertex to the closest grid point; "outward" returns a region that
            contains the input, "inward" regions inside the input.

    Raises:
        PolygonError: the closest grid points do not form a region.

    Cost: O(n log n) for n vertices, plus an `Overlap` for each ring; a few times as much if
        vertices are dropped.

    Example:
        >>> part = Region([(0, 0), ("10/3", 0), ("10/3", "7/3"), (0, "7/3")])
        >>> for side in ("closest", "outward", "inward"):
        ...     print(round_region(part, 0, side).region)
        (0, 0) (3, 0) (3, 2) (0, 2)
        (0, 0) (4, 0) (4, 3) (0, 3)
        (0, 0) (3, 0) (3, 2) (0, 2)
    """
    if not 0 <= places <= MAX_PLACES:
        raise FormatError(f"decimal places must be between 0 and {MAX_PLACES}, not {quote(places)}")
    grid = Fraction(1, 10**places)
    if side == "closest":
        rings = [[Point(round(x, places), round(y, places)) for x, y in r] for r in region.rings]
        distance = max(
            round_root_up(_measure(p, (q, q)))
            for old, new in zip(region.rings, rings, strict=True)
            for p, q in zip(old, new, strict=True)
        )
        return Rounded((Region(rings[0], rings[1:]),), distance)
    exterior, *holes = region.rings if side == "outward" else [r[::-1] for r in region.rings]
    outer = _move(exterior, grid)
    moved = [ring for hole in holes if (ring := _move(hole[::-1], grid)) is not None]
    if outer is None:
        return Rounded((), Fraction(0), 1)
    distance = max(ring.distance for ring in (outer, *moved))
    left_out = len(holes) - len(moved)
    inner = [ring.polygon for ring in moved]
    with suppress(PolygonError):
        return Rounded((Region(outer.polygon, inner),), distance, left_out)
    # Holes grew into each other, or out of the region; intersections may be off the grid.
    clockwise = [ring.vertices[::-1] for ring in inner]
    filled = fill([outer.polygon.vertices, *clockwise], "positive")
    parts = [round_region(Region(ring, rings), places, side) for ring, *rings in filled.regions]
    found = tuple(chain.from_iterable(part.regions for part in parts))
    left_out += sum(part.left_out for part in parts) or not parts
    distance += max((part.distance for part in parts), default=Fraction(0))
    return Rounded(found, distance if found else Fraction(0), left_out)


def contains(outer: Region, inner: Region) -> bool:
    _, (around, within) = share_lattice([outer, inner])
    return overlap.contains(around, within)


class _Moved(NamedTuple):
    polygon: Polygon
    distance: Fraction


def _move(ring: Sequence[Point], grid: Fraction) -> _Moved | None:
    """Move a ring to grid points on its right; return None if no ring is left."""
    points = [Point(x / grid, y / grid) for x, y in ring]
    old = Polygon(points)
    is_exterior = find_doubled_area(points) > 0
    alive = list(range(len(points)))
    drop = 1
    while len(alive) > 2:
        corners = [points[i] for i in alive]
        chains = _chains(corners)
        moved = [*chain.from_iterable(chains)]
        if all(chains) and _is_proved(moved, old, is_exterior):
            return _scale(moved, _distance(points, alive, chains), grid)
        turns = (
            orientation(corners[i - 1], v, corners[(i + 1) % len(corners)])
            for i, v in enumerate(corners)
        )
        # Twice the area of the ear at each right turn, and its index.
        ears = [(-area, i) for i, area in enumerate(turns) if area < 0]
        # Drop vertices without a grid point first, twice as many each time.
        ears.sort(key=lambda ear: (bool(chains[ear[1]]), ear))
        if not ears:
            break
        gone = {position for _, position in ears[:drop]}
        alive = [i for position, i in enumerate(alive) if position not in gone]
        drop *= 2
    if not is_exterior:
        return None
    cells = (
        Point(Fraction(x), Fraction(y))
        for v in points
        for x in (floor(v.x), ceil(v.x))
        for y in (floor(v.y), ceil(v.y))
    )
    hull = find_hull(cells)
    edges = [*pairwise((*hull, hull[0]))]
    far = max(min(_measure(point, edge) for edge in edges) for point in points)
    return _scale(hull, max(round_root_up(far), Fraction(3, 2)), grid)


def _scale(ring: Sequence[Point], distance: Fraction, grid: Fraction) -> _Moved:
    return _Moved(Polygon([(x * grid, y * grid) for x, y in ring]), distance * grid)


def _is_proved(ring: Sequence[Point], old: Polygon, is_exterior: bool) -> bool:
    """Return whether a new ring is simple, equally oriented, and on the right of the old one."""
    try:
        new = Polygon(ring)
    except PolygonError:
        return False
    if (find_doubled_area(ring) > 0) != is_exterior:
        return False
    outer, inner = (new, old) if is_exterior else (old, new)
    return contains(Region(outer), Region(inner))


def _chains(corners: Sequence[Point]) -> list[list[Point]]:
    """Find the new vertices for each corner; none for a right turn without a grid point."""
    found = []
    for i, v in enumerate(corners):
        e, f = minus(v, corners[i - 1]), minus(corners[(i + 1) % len(corners)], v)
        if v.x.denominator == v.y.denominator == 1:
            found.append([v])
        elif cross(e, f) >= 0:
            found.append(_extremes(v, e, f))
        else:
            found.append(_closest(v, e, f))
    return found


def _extremes(v: Point, e: Vertex, f: Vertex) -> list[Point]:
    """Return the corners of the cell of v that are extreme between the normals of e and f."""
    first = _quadrant(e[1], -e[0])
    # The quadrant that ends at the other normal, found by reflection.
    last = -_quadrant(-f[0], f[1]) % 4
    corners = [(ceil, ceil), (floor, ceil), (floor, floor), (ceil, floor)]
    count = (last - first) % 4 + 1
    # On a straight axis-parallel line, either corner will do.
    turns = [corners[(first + k) % 4] for k in range(count if count < 4 else 1)]
    return [Point(Fraction(x(v.x)), Fraction(y(v.y))) for x, y in turns]


def _quadrant(x: Rational, y: Rational) -> int:
    """Return the quadrant of a direction; each includes its first axis."""
    if y >= 0 and x > 0:
        return 0
    if y > 0:
        return 1
    return 2 if x < 0 else 3


def _closest(v: Point, e: Vertex, f: Vertex) -> list[Point]:
    """Return the closest grid point on or right of the lines of e and f, if within reach."""
    near = [
        (by[0] * by[0] + by[1] * by[1], Point(Fraction(x), Fraction(y)))
        for x in range(floor(v.x) - _REACH, ceil(v.x) + _REACH + 1)
        for y in range(floor(v.y) - _REACH, ceil(v.y) + _REACH + 1)
        for by in [(x - v.x, y - v.y)]
        if cross(e, by) <= 0 and cross(f, by) <= 0
    ]
    return [min(near)[1]] if near else []


def _distance(
    points: Sequence[Point], alive: Sequence[int], chains: Sequence[Sequence[Point]]
) -> Fraction:
    """Bound the distance between old and new ring; along an edge, it is greatest at an end."""
    largest = Fraction(0)
    for position, (i, new) in enumerate(zip(alive, chains, strict=True)):
        largest = max(largest, *(_measure(points[i], (p, p)) for p in new))
        k = (position + 1) % len(alive)
        end = alive[k] + len(points) * (k == 0)
        for j in range(i + 1, end):
            edge = new[-1], chains[k][0]
            largest = max(largest, _measure(points[j % len(points)], edge))
    return round_root_up(largest)


def _measure(point: Point, edge: Edge) -> Fraction:
    return Fraction(*measure_to_edge(point, edge))
