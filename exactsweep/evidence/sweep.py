"""The sweep (G, D): loops, contacts, undercuts and exact fits, each computed on first access."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import Any

from exactsweep.evidence.certificate import claim_no_fit, claim_sweep
from exactsweep.evidence.certified import Certified
from exactsweep.evidence.contact import (
    Contact,
    find_contacts,
    find_edge_contacts,
    list_edges,
    number_as_given,
)
from exactsweep.evidence.undercut import Tracer, Undercut, find_closing_positions
from exactsweep.geometry.direction import Vector
from exactsweep.geometry.frame import Kind
from exactsweep.geometry.interface import GeoJson, make_polygon
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_point
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.digits import abridge
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import ORIGIN, Area, Fit, Point, Vertex
from exactsweep.procedures.any_shape import ShapeSolution
from exactsweep.procedures.monotone import MonotoneSolution
from exactsweep.procedures.undercuts import find_undercuts
from exactsweep.words import write_vector

Solution = MonotoneSolution | ShapeSolution
"""The loops and exact fits of a pair, each computed on first access."""


def solve(generatrix: AnyPolygon, directrix: AnyPolygon, direction: Vector | None) -> Solution:
    """Choose the Solution of a pair; without a direction, it accepts any shape."""
    if direction is None:
        return ShapeSolution(Region(generatrix), Region(directrix))
    return MonotoneSolution(generatrix.exterior, directrix.exterior, direction)


def place_loop(loop: Sequence[Point], reference: Point = ORIGIN) -> Polygon:
    """Convert a canonical loop of positions of G's origin to a Polygon for a reference point."""
    return Polygon._trust(_move(loop, reference))


def place_fits(fits: Iterable[Fit], reference: Point) -> tuple[Fit, ...]:
    """Convert exact fits from positions of G's origin to positions of a reference point."""
    return tuple((p, q) for p, q in (_move(fit, reference) for fit in fits))


def claim_pair(stationary: Region, orbiting: Region, found: Solution) -> dict[str, Any]:
    """Claim the no-fit polygon of a pair, with positions of the origin."""
    exterior, holes = place_loop(found.trajectory), map(place_loop, found.holes)
    return claim_no_fit(stationary, orbiting, exterior, holes, found.fits)


def _move(points: Sequence[Point], by: Point) -> Sequence[Point]:
    if by == ORIGIN:
        return points
    dx, dy = by
    return [Point(x + dx, y + dy) for x, y in points]


class SweepAnswer(Certified):
    """The loops, contacts, undercuts and exact fits of a sweep (G, D); see `exactsweep.Sweep`."""

    asked = ("generatrix", "directrix", "direction", "reference")

    generatrix: AnyPolygon
    directrix: AnyPolygon
    direction: Vector | None
    reference: Point
    kind: Kind
    solution: Solution

    def __init__(
        self,
        generatrix: AnyPolygon,
        directrix: AnyPolygon,
        direction: Vector | None,
        reference: Point,
    ) -> None:
        solution = solve(generatrix, directrix, direction)
        vars(self).update(generatrix=generatrix, directrix=directrix, direction=direction)
        vars(self).update(reference=reference, solution=solution, kind=solution.kind)

    @cached_property
    def trajectory(self) -> Polygon:
        """The path of the reference point of G: the boundary of the no-fit polygon."""
        return place_loop(self.solution.trajectory, self.reference)

    @cached_property
    def inner(self) -> Polygon:
        """The inner loop of the swept area: D with its undercuts and holes closed."""
        return place_loop(self.solution.inner)

    @cached_property
    def outer(self) -> Polygon:
        """The outer loop of the swept area."""
        return place_loop(self.solution.outer)

    @cached_property
    def unswept(self) -> tuple[Polygon, ...]:
        """The holes of the swept area other than the inner loop, sorted; only for kind "SS"."""
        return tuple(map(place_loop, self.solution.unswept))

    @cached_property
    def no_fit_holes(self) -> tuple[Polygon, ...]:
        """The holes of the no-fit polygon, sorted: positions of G in a cavity or a hole of D."""
        return tuple(place_loop(loop, self.reference) for loop in self.solution.holes)

    @cached_property
    def exact_fits(self) -> tuple[Fit, ...]:
        """The exact fits, sorted: segments of positions in slots of D exactly as wide as G.

        Each segment is (the end on a loop, the end inside the slot). The trajectory does not show
        these positions.

        >>> from exactsweep import sweep
        >>> slot = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
        >>> for fit in sweep([(0, 0), (1, 0), (1, 1), (0, 1)], slot).exact_fits:
        ...     print(*((str(x), str(y)) for x, y in fit))
        ('1', '3') ('1', '1')
        """
        return place_fits(self.solution.fits, self.reference)

    @cached_property
    def area(self) -> Fraction:
        """The swept area: the area of the outer loop minus the inner loop and `unswept`."""
        return Area(self.outer.area - add_up(loop.area for loop in (self.inner, *self.unswept)))

    @cached_property
    def _boundaries(self) -> tuple[Outline, Outline]:
        frame, outlines = self.solution.frame, []
        for shape in (self.generatrix, self.directrix):
            scale, rings = Region(shape).lattice()
            outlines.append(Outline([frame.enter(scale, ring) for ring in rings]))
        generatrix, directrix = outlines
        return generatrix, directrix

    @cached_property
    def _route(self) -> Outline:
        """The trajectory of G's origin in the frame, indexed for point queries."""
        return Outline([self._enter(self.solution.trajectory)])

    def _enter(self, points: Iterable[Point]) -> list[Vertex]:
        return list(map(self.solution.frame.enter_point, points))

    @cached_property
    def _numbered_contacts(self) -> list[list[Contact]]:
        """The contacts along the edges of the trajectory, numbered in canonical order."""
        return find_edge_contacts(list_edges(self._route.vertices), *self._boundaries)

    @cached_property
    def contacts(self) -> tuple[tuple[Contact, ...], ...]:
        """The contacts along each edge of the trajectory (Table 1).

        Item k contains the EV, VE and EE contacts that last along a piece of positive length of
        edge k, from vertex k of the trajectory to the next. It omits contacts at single positions,
        such as VV (see `vertex_contacts`), and EV and VE contacts that an EE contact implies.
        Features are numbered as in the input: edge i runs from vertex i to the next.

        >>> from exactsweep import sweep
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> sweep(square, [(0, 0), (3, 0), (0, 3)]).contacts[2]
        (Contact(event='VE', generatrix=0, directrix=1),)
        """
        return tuple(tuple(map(self._as_given, found)) for found in self._numbered_contacts)

    @explain_type_errors
    def contacts_along(
        self, loops: Iterable[Iterable[Iterable[object]]]
    ) -> Iterator[tuple[tuple[Contact, ...], ...]]:
        """Find the contacts along the edges of loops of free positions, formatted as in `contacts`.

        A loop of two positions runs from one to the other and back; it has no contacts if they are
        equal. Cost: as for `contacts`.
        """
        enter, reference = self.solution.frame.enter_point, self.reference
        edges = [
            list_edges([enter(read_point(point, "position"), reference) for point in loop])
            for loop in loops
        ]
        moves = [(p, q) for p, q in chain.from_iterable(edges) if p != q]
        found = iter(find_edge_contacts(moves, *self._boundaries))
        return (
            tuple(tuple(map(self._as_given, next(found))) if p != q else () for p, q in of_loop)
            for of_loop in edges
        )

    @cached_property
    def vertex_contacts(self) -> tuple[tuple[Contact, ...], ...]:
        """All contacts at each vertex of the trajectory, including VV, numbered as in `contacts`.

        Cost: O(t (m + n) log(m + n)) for t vertices.
        """
        return tuple(self.contacts_at(vertex) for vertex in self.trajectory.vertices)

    def contacts_at(self, position: Iterable[object]) -> tuple[Contact, ...]:
        """Find all contacts at a position of G's reference point, numbered as in `contacts`.

        Cost: O((m + n) log(m + n)).
        """
        t = self.solution.frame.enter_point(read_point(position, "position"), self.reference)
        return tuple(map(self._as_given, find_contacts(*self._boundaries, t)))

    def _as_given(self, contact: Contact) -> Contact:
        event, i, j = contact
        g, d = self._boundaries
        return Contact(
            event,
            number_as_given(self.generatrix, g, i, of_edge=event[0] == "E"),
            number_as_given(self.directrix, d, j, of_edge=event[1] == "E"),
        )

    @cached_property
    def undercuts(self) -> tuple[Undercut, ...]:
        """The undercuts (Figure 7), in order along the inner loop; holes of D do not count."""
        frame, loop = self.solution.frame, self._enter(self.solution.inner)
        first = loop.index(min(loop))
        directrix = self._enter(self.directrix.exterior.vertices)
        undercuts = find_undercuts(loop[first:] + loop[:first], directrix)
        if not undercuts:
            return ()
        tracer, found = Tracer(self._route, self._boundaries[0]), []
        for bottom, top in undercuts:
            intersection, positions = find_closing_positions(bottom, tracer)
            points = list(map(frame.leave_point, bottom + top[-2:0:-1]))
            chain = tuple(points[: len(bottom)])
            placed = tuple(frame.leave_point(t, self.reference) for t in positions)
            extremes = chain[0], chain[-1]
            found.append(Undercut(Polygon(points), extremes, chain, intersection, placed))
        return tuple(found)

    @property
    def __geo_interface__(self) -> GeoJson:
        """The swept area as a GeoJSON Polygon with holes."""
        return make_polygon([loop.vertices for loop in (self.outer, self.inner, *self.unswept)])

    def _claim(self) -> dict[str, Any]:
        no_fit = claim_pair(Region(self.directrix), Region(self.generatrix), self.solution)
        return claim_sweep(no_fit, self.inner, self.outer, self.unswept, self.area)

    def __str__(self) -> str:
        names = "trajectory", "inner", "outer"
        loops = [(name, getattr(self, name)) for name in names]
        # Kind "SS" has no direction.
        to = f"monotone in {write_vector(self.direction)}" if self.direction else "of any shape"
        return "\n".join(
            [f"{self.kind} sweep, {to}, area {abridge(self.area)}"]
            + [f"{name}, {len(loop)} vertices: {loop}" for name, loop in loops]
        )

    def __repr__(self) -> str:
        direction = self.direction and write_vector(self.direction)
        return (
            f"<Sweep {self.kind} of {len(self.generatrix)} around {len(self.directrix)} vertices, "
            f"direction {direction}: trajectory {len(self.trajectory)}, "
            f"inner {len(self.inner)}, outer {len(self.outer)} vertices>"
        )
