"""A case of the corpus: a pair, exactly as given, and what its sweep must be."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import chain
from math import lcm
from typing import Literal, get_args

from exactsweep.corpus.facts import find_facts
from exactsweep.corpus.representable import find_types
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_point
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.numbers.arguments import tells_arguments
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.point import Fit, Loop, Point
from exactsweep.procedures.solution import Kind
from exactsweep.sweep import Sweep, inner_fit_polygon, sweep

KINDS: tuple[Kind, ...] = get_args(Kind)
Shapes = Literal["convex", "monotone", "simple", "any"]
SHAPES: tuple[Shapes, ...] = get_args(Shapes)
"""The kinds of pairs; each includes those before it. A pair without holes is simple."""
_SHAPES_OF: dict[Kind, Shapes] = {
    "CC": "convex",
    "CM": "monotone",
    "MM": "monotone",
    "SS": "simple",
}
Given = AnyPolygon | Iterable[Iterable[object]]


class CaseError(ExactSweepError):
    """A case that cannot be read, or that contradicts itself; the message says where."""


@dataclass(frozen=True)
class Case:
    """A pair of polygons with the exact answers for tests of an implementation.

    Attributes:
        id: the name of the case; it never changes its meaning.
        title: one line for people.
        directrix_ring: D, or its exterior, as the case gives it: tuple of Point, not closed, and
            with the orientation, collinear vertices and repeated vertices of the input.
        generatrix_ring: G, likewise.
        reference: the point of G whose path the trajectory is.
        kind: "CC", "CM", "MM" or "SS", as of the sweep.
        flags: what is special about the case, sorted; `exactsweep.corpus.notes` has a note on each.
        trajectory: the expected trajectory, a Polygon, and so for the inner and outer loop.
        inner: the expected inner loop.
        outer: the expected outer loop.
        exact_fits: the expected exact fits, as `Sweep.exact_fits` has them.
        area: the expected swept area.
        directrix_holes: the holes of D, each a ring as given.
        generatrix_holes: those of G.
        holes: the expected holes of the no-fit polygon, whose exterior is the trajectory.
        unswept: the expected further holes of the swept area.
        inner_regions: the expected regions of positions of G inside D; None where that is not
            asked. It is, of all cases of class "SS", and of containers of any class.
        inner_exact_fits: the expected exact fits of G inside D.
        note: where the case comes from, if there is more to say than the title says.
        version: the number of the corpus in which the case appeared; frozen.
    """

    id: str
    title: str
    directrix_ring: Loop
    generatrix_ring: Loop
    reference: Point
    kind: Kind
    flags: tuple[str, ...]
    trajectory: Polygon
    inner: Polygon
    outer: Polygon
    exact_fits: tuple[Fit, ...]
    area: Fraction
    directrix_holes: tuple[Loop, ...] = ()
    generatrix_holes: tuple[Loop, ...] = ()
    holes: tuple[Polygon, ...] = ()
    unswept: tuple[Polygon, ...] = ()
    inner_regions: tuple[Region, ...] | None = None
    inner_exact_fits: tuple[Fit, ...] = ()
    note: str = ""
    version: int = 1

    @classmethod
    @tells_arguments
    def of(
        cls,
        id: str,
        title: str,
        directrix: Given,
        generatrix: Given,
        reference: Iterable[object] = (0, 0),
        flags: Iterable[str] = (),
        *,
        directrix_holes: Iterable[Given] = (),
        generatrix_holes: Iterable[Given] = (),
        inner_fit: bool = False,
        note: str = "",
    ) -> Case:
        """Make a case by sweeping the pair.

        Args:
            id: its name.
            title: one line for people.
            directrix: D, a Polygon, a Region or vertices as `Polygon` takes them; vertices are kept
                as they are, except for a last one that repeats the first.
            generatrix: G, likewise.
            reference: the point of G whose path the trajectory is.
            flags: what cannot be seen from the pair; `find_facts` adds what can.
            directrix_holes: the holes of D, where it is no Region, each as D is given.
            generatrix_holes: those of G.
            inner_fit: whether the positions of G inside D are asked of a pair that is not "SS".
            note: where the case comes from.

        Returns:
            The Case with its expected answers.

        Raises:
            ValueError: what `sweep` refuses.

        Cost: that of the sweep and of its loops, of the inner fit and of `find_facts`.

        Example:
            >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
            >>> case = Case.of("mine-1", "a square around itself", square, square)
            >>> case.kind, case.area, case.integer_scale, sorted(case.representable)
            ('CC', Fraction(8, 1), 1, ['binary64', 'int32', 'int64'])
            >>> plate = Region([(0, 0), (9, 0), (9, 9), (0, 9)], [[(2, 2), (4, 2), (4, 4), (2, 4)]])
            >>> case = Case.of("mine-2", "a square in a plate", plate, square)
            >>> case.kind, len(case.holes), len(case.inner_regions)
            ('SS', 1, 1)
        """
        d, g = (
            read_given_rings(directrix, directrix_holes),
            read_given_rings(generatrix, generatrix_holes),
        )
        s = sweep(_shape(g), _shape(d), reference=reference)
        inside = None
        if inner_fit or s.kind == "SS":
            inside = inner_fit_polygon(_shape(d), _shape(g), reference=reference)
        case = cls(
            id=id,
            title=title,
            directrix_ring=d[0],
            generatrix_ring=g[0],
            reference=s.reference,
            kind=s.kind,
            flags=(),
            trajectory=s.trajectory,
            inner=s.inner,
            outer=s.outer,
            exact_fits=s.exact_fits,
            area=s.area,
            directrix_holes=d[1:],
            generatrix_holes=g[1:],
            holes=s.no_fit_holes,
            unswept=s.unswept,
            inner_regions=None if inside is None else inside.regions,
            inner_exact_fits=() if inside is None else inside.exact_fits,
            note=note,
        )
        return replace(case, flags=tuple(sorted({*flags, *find_facts(case)})))

    @property
    def directrix_rings(self) -> tuple[Loop, ...]:
        """The exterior and the holes of D as given."""
        return (self.directrix_ring, *self.directrix_holes)

    @property
    def generatrix_rings(self) -> tuple[Loop, ...]:
        """The exterior and the holes of G as given."""
        return (self.generatrix_ring, *self.generatrix_holes)

    @cached_property
    def directrix(self) -> AnyPolygon:
        """D in canonical form; a Region if it has holes."""
        return _shape(self.directrix_rings)

    @cached_property
    def generatrix(self) -> AnyPolygon:
        """G in canonical form; a Region if it has holes."""
        return _shape(self.generatrix_rings)

    def sweep(self) -> Sweep:
        """Sweep the pair anew."""
        return sweep(self.generatrix, self.directrix, reference=self.reference)

    @property
    def shapes(self) -> Shapes:
        """The least of SHAPES that holds the pair."""
        if self.directrix_holes or self.generatrix_holes:
            return "any"
        return _SHAPES_OF[self.kind]

    @property
    def size(self) -> int:
        """The vertices of all rings as given."""
        return sum(map(len, (*self.directrix_rings, *self.generatrix_rings)))

    @cached_property
    def integer_scale(self) -> int:
        """The least positive int by which every coordinate of the input becomes an integer.

        The input is D, G and the reference point. The answer at this scale may still have
        fractions: then the case has the flag "rounded-answer".
        """
        return lcm(*(c.denominator for c in self.list_input()))

    @cached_property
    def representable(self) -> frozenset[str]:
        """The number types that hold the input, every coordinate of it, without rounding.

        "int32" and "int64" when the type holds the input times `integer_scale`; "binary64" when
        that type holds the input as it is. (Where "int32" is named, binary64 holds the input times
        `integer_scale`, too.)
        """
        return find_types(list(self.list_input()), self.integer_scale)

    @cached_property
    def answer_representable(self) -> frozenset[str]:
        """The number types that hold the expected answer, in the same sense and scale.

        The answer is the trajectory, the inner and outer loop and the exact fits.
        """
        return find_types(list(self.list_answer()), self.integer_scale)

    def list_input(self) -> Iterator[Fraction]:
        """List the coordinates of D, of G and of the reference point."""
        rings = *self.directrix_rings, *self.generatrix_rings, (self.reference,)
        return chain(*chain(*rings))

    def list_answer(self) -> Iterator[Fraction]:
        """List the coordinates of all expected loops and exact fits."""
        loops = (self.trajectory, self.inner, self.outer, *self.holes, *self.unswept)
        rings = [shape.vertices for shape in (*loops, *(self.inner_regions or ()))]
        return chain(*chain(*rings, *self.exact_fits, *self.inner_exact_fits))


def read_given_rings(shape: Given, holes: Iterable[Given] = ()) -> tuple[Loop, ...]:
    """Read the exterior and the holes of a shape, each as it is given; see `given_ring`."""
    if isinstance(shape, Region):
        return shape.rings
    return (given_ring(shape), *map(given_ring, holes))


def given_ring(vertices: Given) -> Loop:
    """Read vertices as they are given, except for a last one that repeats the first.

    >>> len(given_ring([(0, 0), (1, 0), (1, 0), (0, 1), (0, 0)]))
    4
    """
    if isinstance(vertices, (Polygon, Region)):
        return vertices.vertices
    ring = tuple(read_point(pair, f"vertex {i}") for i, pair in enumerate(vertices))
    return ring[:-1] if len(ring) > 1 and ring[0] == ring[-1] else ring


def _shape(rings: tuple[Loop, ...]) -> AnyPolygon:
    exterior, *holes = rings
    return Region(exterior, holes) if holes else Polygon(exterior)
