"""A case of the corpus: a pair, exactly as given, and what its sweep must be."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import lcm
from typing import Literal, get_args

from exactsweep.corpus.facts import facts
from exactsweep.corpus.representable import types_holding
from exactsweep.geometry.error import ExactSweepError
from exactsweep.geometry.point import Point
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_point
from exactsweep.sweep import sweep

Kind = Literal["CC", "CM", "MM", "SS"]
KINDS: tuple[Kind, ...] = get_args(Kind)
Ring = tuple[Point, ...]


class CaseError(ExactSweepError):
    """A case that cannot be read, or that contradicts itself; the message says where."""


@dataclass(frozen=True)
class Case:
    """A pair of polygons with the exact answers that an implementation is held against.

    Attributes:
        id: the name of the case; it never changes its meaning.
        title: one line for people.
        directrix_ring: D as the case gives it: tuple of Point, not closed, and with the
            orientation, collinear vertices and repeated vertices of the input.
        generatrix_ring: G, likewise.
        reference: the point of G whose path the trajectory is.
        kind: "CC", "CM" or "MM", as of the sweep.
        flags: what is special about the case, sorted; `exactsweep.corpus.notes` has a note on each.
        trajectory: the expected trajectory, a Polygon, and so for the inner and outer loop.
        inner: the expected inner loop.
        outer: the expected outer loop.
        exact_fits: the expected exact fits, as `Sweep.exact_fits` has them.
        area: the expected swept area.
    """

    id: str
    title: str
    directrix_ring: Ring
    generatrix_ring: Ring
    reference: Point
    kind: Kind
    flags: tuple[str, ...]
    trajectory: Polygon
    inner: Polygon
    outer: Polygon
    exact_fits: tuple[tuple[Point, Point], ...]
    area: Fraction

    @classmethod
    def of(
        cls,
        id: str,
        title: str,
        directrix: Polygon | Iterable[Iterable[object]],
        generatrix: Polygon | Iterable[Iterable[object]],
        reference: Iterable[object] = (0, 0),
        flags: Iterable[str] = (),
    ) -> Case:
        """Make a case by sweeping the pair.

        Args:
            id: its name.
            title: one line for people.
            directrix: D, a Polygon or vertices as `Polygon` takes them; vertices are kept as they
                are, except for a last one that repeats the first.
            generatrix: G, likewise.
            reference: the point of G whose path the trajectory is.
            flags: what cannot be seen from the pair; `facts` adds what can.

        Returns:
            The Case with its expected answers.

        Raises:
            ValueError: what `sweep` refuses.

        Cost: that of the sweep and of its loops, and of `facts`.

        Example:
            >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
            >>> case = Case.of("mine-1", "a square around itself", square, square)
            >>> case.kind, case.area, case.integer_scale, sorted(case.representable)
            ('CC', Fraction(8, 1), 1, ['binary64', 'int32', 'int64'])
        """
        d, g = given_ring(directrix), given_ring(generatrix)
        s = sweep(g, d, reference=reference)
        return cls(
            id=id,
            title=title,
            directrix_ring=d,
            generatrix_ring=g,
            reference=s.reference,
            kind=s.kind,
            flags=tuple(sorted({*flags, *facts(d, g, s)})),
            trajectory=s.trajectory,
            inner=s.inner,
            outer=s.outer,
            exact_fits=s.exact_fits,
            area=s.area,
        )

    @cached_property
    def directrix(self) -> Polygon:
        """D as a Polygon, in canonical form."""
        return Polygon(self.directrix_ring)

    @cached_property
    def generatrix(self) -> Polygon:
        """G as a Polygon, in canonical form."""
        return Polygon(self.generatrix_ring)

    @property
    def size(self) -> int:
        """The vertices of both rings as given."""
        return len(self.directrix_ring) + len(self.generatrix_ring)

    @cached_property
    def integer_scale(self) -> int:
        """The least positive int by which every coordinate of the input becomes an integer.

        The input is D, G and the reference point. The answer at this scale may still have
        fractions: then the case has the flag "rounded-answer".
        """
        return lcm(*(c.denominator for c in self._input()))

    @cached_property
    def representable(self) -> frozenset[str]:
        """The number types that hold the input, every coordinate of it, without rounding.

        "int32" and "int64" when the type holds the input times `integer_scale`; "binary64" when
        that type holds the input as it is. (Where "int32" is named, binary64 holds the input times
        `integer_scale`, too.)
        """
        return types_holding(list(self._input()), self.integer_scale)

    @cached_property
    def answer_representable(self) -> frozenset[str]:
        """The number types that hold the expected answer, in the same sense and scale.

        The answer is the trajectory, the inner and outer loop and the exact fits.
        """
        return types_holding(list(self._answer()), self.integer_scale)

    def _input(self) -> Iterator[Fraction]:
        for ring in self.directrix_ring, self.generatrix_ring, (self.reference,):
            for point in ring:
                yield from point

    def _answer(self) -> Iterator[Fraction]:
        for loop in self.trajectory, self.inner, self.outer:
            for vertex in loop.vertices:
                yield from vertex
        for fit in self.exact_fits:
            for point in fit:
                yield from point


def given_ring(vertices: Polygon | Iterable[Iterable[object]]) -> Ring:
    """Read vertices as they are given, except for a last one that repeats the first.

    >>> len(given_ring([(0, 0), (1, 0), (1, 0), (0, 1), (0, 0)]))
    4
    """
    if isinstance(vertices, Polygon):
        return vertices.vertices
    ring = tuple(read_point(pair, f"vertex {i}") for i, pair in enumerate(vertices))
    return ring[:-1] if len(ring) > 1 and ring[0] == ring[-1] else ring
