"""The methods that Polygons and Regions share as sets of points: locate, move, rotate, show.

All maps are affine with rational coefficients, so nothing is rounded. A rotation is rational if and
only if it maps the X axis to a vector of rational coordinates *and* rational length: quarter turns,
and rotations by Pythagorean triples such as (3, 4, 5).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, pairwise
from typing import TYPE_CHECKING, Any, NamedTuple, Self, overload

from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.edges import is_inside
from exactsweep.geometry.interface import GeoJson, make_polygon
from exactsweep.geometry.reading import read_point
from exactsweep.geometry.turn import TURN_BITS, read_turn
from exactsweep.geometry.vectors import is_on_segment
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.digits import abridge
from exactsweep.numbers.error import NumberError, explain_type_errors, quote
from exactsweep.numbers.number import Area, Point
from exactsweep.words import write_pair, write_size

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_ONE, _ZERO = Fraction(1), Fraction(0)


class AffineMap(NamedTuple):
    """The map (x, y) -> (a x + b y + dx, c x + d y + dy), ad - bc not 0."""

    a: Fraction
    b: Fraction
    c: Fraction
    d: Fraction
    dx: Fraction = _ZERO
    dy: Fraction = _ZERO

    def about(self, center: Iterable[object]) -> AffineMap:
        """Return the map with the same linear part and the given fixed point."""
        x, y = read_point(center, "center")
        a, b, c, d = self[:4]
        return self._replace(dx=x - a * x - b * y, dy=y - c * x - d * y)


class PointSet:
    """The points of a Polygon or a Region, including the boundary.

    Methods cost O(n). Images keep the input's numbering of vertices and edges.
    """

    __slots__ = ()

    _vertex_index: Sequence[int]
    _edge_index: Sequence[int]

    @property
    def rings(self: Any) -> tuple[tuple[Point, ...], ...]:
        """The vertices of the exterior and of each hole, all counter-clockwise."""
        return (self.exterior.vertices, *(hole.vertices for hole in self.holes))

    @property
    def vertices(self) -> tuple[Point, ...]:
        """The vertices of all `rings`, one ring after another."""
        return tuple(chain.from_iterable(self.rings))

    @property
    def area(self: Any) -> Fraction:
        """The area of the exterior minus the areas of the holes."""
        return Area(self.exterior.area - add_up(hole.area for hole in self.holes))

    @property
    def bounds(self) -> tuple[Fraction, Fraction, Fraction, Fraction]:
        """The least x and y, and the greatest x and y, in the order of shapely's `bounds`."""
        xs, ys = zip(*self.rings[0], strict=True)
        return min(xs), min(ys), max(xs), max(ys)

    @property
    def bounding_box(self) -> tuple[Point, Point]:
        """The lower left and the upper right corner of the bounding box."""
        left, low, right, high = self.bounds
        return Point(left, low), Point(right, high)

    def vertex_index(self, k: int) -> int:
        """Return the input index of vertex k, counted across all `rings`.

        The input also starts with the exterior; the holes follow in the given order. Negative k
        count from the end. Raises PolygonError if there is no vertex k.
        """
        return _pick(self._vertex_index, k, "vertex")

    def edge_index(self, k: int) -> int:
        """Return the input index of edge k, from vertex k to the next of its ring.

        Edges are counted as in `vertex_index`. If several collinear input edges form edge k, it is
        the first. Raises PolygonError if there is no edge k.

        >>> from exactsweep import Polygon
        >>> clockwise = Polygon([(0, 0), (0, 2), (2, 0)])
        >>> [clockwise.edge_index(k) for k in range(3)]
        [2, 1, 0]
        """
        return _pick(self._edge_index, k, "edge")

    def __len__(self) -> int:
        return len(self._vertex_index)

    def _image(self, under: AffineMap) -> Self:
        raise NotImplementedError

    def _repr_svg_(self) -> str:
        from exactsweep.canvas.svg import draw_rings

        return draw_rings(self.rings, write_size(len(self), self.area))

    def _repr_html_(self: Any) -> str:
        from exactsweep.canvas.svg import add_table

        low, high = map(write_pair, self.bounding_box)
        facts = [
            ("vertices", str(len(self))),
            *([("holes", str(len(self.holes)))] if self.holes else []),
            ("area", abridge(self.area)),
            ("convex", "yes" if self.is_convex else "no"),
            ("from", low),
            ("to", high),
        ]
        return add_table(self._repr_svg_(), facts)

    @explain_type_errors
    def plot(self, axes: Axes | None = None, **style: Any) -> Axes:
        """Draw the shape with matplotlib, filled, with equal units on both axes.

        Args:
            axes: Axes to draw on; by default those of a new `matplotlib.pyplot` figure.
            style: properties of a `matplotlib.patches.PathPatch`, such as `color="red"`.

        Raises DrawError if matplotlib is not installed.

        Example:
            >>> from matplotlib.figure import Figure
            >>> from exactsweep import Polygon
            >>> triangle = Polygon([(0, 0), (2, 0), (0, 1)])
            >>> axes = triangle.plot(Figure().subplots(), facecolor="gold")
            >>> len(axes.patches)
            1
        """
        from exactsweep.canvas.plot import plot_rings

        return plot_rings(self.rings, axes, style)

    def translated(self, by: Iterable[object]) -> Self:
        """Return the shape moved by a vector, a pair of numbers.

        >>> from exactsweep import Polygon
        >>> Polygon([(0, 0), (1, 0), (0, 1)]).translated((2, "1/2"))
        Polygon([(2, '1/2'), (3, '1/2'), (2, '3/2')])
        """
        return self._image(AffineMap(_ONE, _ZERO, _ZERO, _ONE, *read_point(by, "translation")))

    @explain_type_errors
    def rotated(
        self, by: object, center: Iterable[object] = (0, 0), *, bits: int = TURN_BITS
    ) -> Self:
        """Return the shape rotated counter-clockwise, exactly if the rotation is rational.

        Multiples of 90 degrees and pairs of numbers are exact. Other numbers of degrees would give
        irrational vertices. They are replaced by a rational rotation with an error of at most
        2**-bits on the unit circle, so the error of a vertex is at most 2**-bits times its distance
        from the center. `exactsweep.geometry.turn.read_turn(by).near(bits)` returns that rotation
        and its error.

        Args:
            by: degrees; or a pair of numbers, the image of the X axis, a direction of rational
                length, such as (3, 4) or the equivalent ("3/5", "4/5").
            center: a pair of numbers, the fixed point.
            bits: the precision of an irrational rotation.

        Raises:
            NumberError: a direction of irrational length.

        Example:
            >>> from exactsweep import Polygon
            >>> print(Polygon([(0, 0), (2, 0), (2, 1)]).rotated(90))
            (-1, 2) (0, 0) (0, 2)
            >>> print(Polygon([(0, 0), (5, 0), (5, 5)]).rotated((3, 4)))
            (-1, 7) (0, 0) (3, 4)
            >>> print(Polygon([(0, 0), (1, 0), (0, 1)]).rotated(45, bits=8))
            (-696/985, 697/985) (0, 0) (697/985, 696/985)
        """
        cosine, sine, _ = read_turn(by).near(bits)
        return self._image(AffineMap(cosine, -sine, sine, cosine).about(center))

    def scaled(self, by: object, center: Iterable[object] = (0, 0)) -> Self:
        """Return the shape scaled by a nonzero number, or by a pair of them for X and Y.

        `center` is the fixed point. Raises NumberError for a factor of 0.

        >>> from exactsweep import Polygon
        >>> print(Polygon([(0, 0), (1, 0), (0, 1)]).scaled((3, "1/2"), center=(1, 0)))
        (-2, 0) (1, 0) (-2, 1/2)
        """
        across, up = read_point(by if _is_pair(by) else (by, by), "factor")  # type: ignore[arg-type]
        if not across or not up:
            raise NumberError("a factor of 0 leaves no area")
        return self._image(AffineMap(across, _ZERO, _ZERO, up).about(center))

    def reflected(self, center: Iterable[object] = (0, 0)) -> Self:
        """Return the shape after a half turn about a center, the point reflection I of the paper.

        >>> from exactsweep import Polygon
        >>> Polygon([(0, 0), (1, 0), (0, 1)]).reflected()
        Polygon([(-1, 0), (0, -1), (0, 0)])
        """
        return self._image(AffineMap(-_ONE, _ZERO, _ZERO, -_ONE).about(center))

    def mirrored(self, along: Iterable[object] = (0, 1), center: Iterable[object] = (0, 0)) -> Self:
        """Return the mirror image in a line.

        Args:
            along: a pair of numbers, the direction of the line; vertical by default.
            center: a pair of numbers, a point of the line.

        Raises:
            NumberError: the direction (0, 0).

        Example:
            >>> from exactsweep import Polygon
            >>> print(Polygon([(0, 0), (2, 0), (2, 1)]).mirrored())
            (-2, 0) (0, 0) (-2, 1)
        """
        p, q = read_point(along, "direction")
        square = p * p + q * q
        if not square:
            raise NumberError("(0, 0) is not a direction")
        cosine, sine = (p * p - q * q) / square, 2 * p * q / square
        return self._image(AffineMap(cosine, sine, sine, -cosine).about(center))

    def contains(self, point: Iterable[object], *, strictly: bool = False) -> bool:
        """Decide exactly whether a point is in the shape, as `point in shape` does.

        `strictly` excludes points of the boundary.

        >>> from exactsweep import Polygon
        >>> third = Polygon([(0, 0), (1, 0), (0, "1/3")])
        >>> third.contains(("1/2", "1/6")), third.contains((0.5, 1 / 6), strictly=True)
        (True, True)
        >>> ("1/2", "1/6") in third, third.contains(("1/2", "1/6"), strictly=True)
        (True, False)
        """
        place = read_point(point, "point")
        if is_inside(place, self.rings):
            return True
        return not strictly and any(is_on(place, ring) for ring in self.rings)

    def __contains__(self, point: Iterable[object]) -> bool:
        return self.contains(point)

    def __iter__(self) -> Iterator[Point]:
        return iter(self.vertices)

    @overload
    def __getitem__(self, k: int) -> Point: ...
    @overload
    def __getitem__(self, k: slice) -> tuple[Point, ...]: ...
    def __getitem__(self, k: int | slice) -> Point | tuple[Point, ...]:
        return self.vertices[k]

    @property
    def __geo_interface__(self) -> GeoJson:
        """The shape as a GeoJSON Polygon, as used by `shapely.geometry.shape(polygon)`.

        Coordinates are ints or floats if these are exact, otherwise Fractions.
        """
        return make_polygon(self.rings)


def is_on(point: Point, ring: tuple[Point, ...]) -> bool:
    """Decide whether a point is on a ring. Cost: O(n)."""
    return any(is_on_segment(point, a, b) for a, b in pairwise((*ring, ring[0])))


def _pick(numbers: Sequence[int], k: object, what: str) -> int:
    try:
        return numbers[k]  # type: ignore[no-any-return, call-overload]
    except (TypeError, IndexError):
        last = len(numbers) - 1
        raise PolygonError(f"there is no {what} {quote(k)}; the last one is {last}") from None


def _is_pair(value: object) -> bool:
    return isinstance(value, Iterable) and not isinstance(value, str)
