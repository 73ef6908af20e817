"""The sweep (G, D): loops, contacts, undercuts and exact fits, each made when first read."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from functools import cached_property
from itertools import chain
from math import lcm
from typing import Any

from exactsweep.evidence.certificate import Statement, write_certificate
from exactsweep.evidence.contact import (
    Contact,
    MonotoneOutline,
    find_contacts,
    find_edge_contacts,
    list_edges,
)
from exactsweep.evidence.exact_fit import find_exact_fits
from exactsweep.evidence.trace import Tracer
from exactsweep.evidence.undercut import Undercut, find_closing_positions, find_pockets
from exactsweep.geometry.canonical import find_least
from exactsweep.geometry.direction import X_AXIS, Vector
from exactsweep.geometry.frame import Frame
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import read_point
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.arguments import tells_arguments
from exactsweep.numbers.number import abridge
from exactsweep.numbers.point import ORIGIN, Point, Vertex
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.lower_sweep import Kind, LowerSweep, split_polygon
from exactsweep.procedures.made_once import made_once
from exactsweep.words import write_vector


class Swept:
    """The sweep (G, D) of a generatrix around a directrix; made by `sweep`.

    Each loop is computed when it is first read.

    Attributes:
        generatrix: G, a Polygon.
        directrix: D, a Polygon.
        kind: "CC" if both are convex, "CM" if only G must be, else "MM".
        direction: the shared direction of monotonicity, a primitive integer vector.
        reference: the point of G whose path the trajectory is, a Point.
    """

    def __init__(
        self, generatrix: Polygon, directrix: Polygon, direction: Vector, reference: Point
    ) -> None:
        self.generatrix = generatrix
        self.directrix = directrix
        self.direction = direction
        self.reference = reference
        self.kind: Kind = (
            "MM" if not generatrix.is_convex else "CC" if directrix.is_convex else "CM"
        )

    @made_once
    def _frame(self) -> Frame:
        return Frame(self.direction, lcm(self.generatrix.lattice()[0], self.directrix.lattice()[0]))

    @made_once
    def _polygons(self) -> tuple[list[Vertex], list[Vertex]]:
        """G and D in the frame: all is computed there, and left as it is handed out."""
        enter = self._frame.enter
        return enter(*self.generatrix.lattice()), enter(*self.directrix.lattice())

    @made_once
    def _halves(self) -> tuple[LowerSweep, LowerSweep]:
        g_bottom, g_top = split_polygon(self.generatrix, self._frame)
        d_bottom, d_top = split_polygon(self.directrix, self._frame)
        return (
            LowerSweep(self.kind, g_top, g_bottom, d_bottom),
            LowerSweep(self.kind, inverse(g_bottom), inverse(g_top), inverse(d_top)),
        )

    def _loop(
        self, half: Callable[[LowerSweep], list[Vertex]], shift: Point = ORIGIN
    ) -> tuple[list[Vertex], Polygon]:
        """A loop in the frame, and as a Polygon; the vertices of both in canonical order."""
        with pause_collector():
            lower, upper = map(half, self._halves)
            upper = inverse(upper)
            # At each end the two chains meet in a point or are joined by a vertical edge.
            loop = lower + upper[upper[0] == lower[-1] : len(upper) - (upper[-1] == lower[0])]
            points = self._frame.leave(loop, shift)
            if self.direction != X_AXIS:
                first = find_least(points)
                loop, points = loop[first:] + loop[:first], points[first:] + points[:first]
            return loop, Polygon._from_canonical(points)

    @made_once
    def _trajectory(self) -> tuple[list[Vertex], Polygon]:
        """The path of G's origin in the frame; and that of the reference point."""
        return self._loop(lambda half: half.path, self.reference)

    @made_once
    def _inner(self) -> tuple[list[Vertex], Polygon]:
        return self._loop(lambda half: half.inner)

    @made_once
    def _outer(self) -> tuple[list[Vertex], Polygon]:
        return self._loop(lambda half: half.outer)

    @property
    def trajectory(self) -> Polygon:
        """The path of the reference point of G: the boundary of the no-fit polygon."""
        return self._trajectory[1]

    @property
    def inner(self) -> Polygon:
        """The inner loop of the swept area: D with its undercuts closed."""
        return self._inner[1]

    @property
    def outer(self) -> Polygon:
        """The outer loop of the swept area."""
        return self._outer[1]

    @property
    def unswept(self) -> tuple[Polygon, ...]:
        """The holes of the swept area beside the inner loop: none, but of kind "SS"."""
        return ()

    @property
    def no_fit_holes(self) -> tuple[Polygon, ...]:
        """The holes of the no-fit polygon, which G does not reach: none, but of kind "SS"."""
        return ()

    @cached_property
    def area(self) -> Fraction:
        """The swept area: the outer loop without the inner one and what is not swept."""
        return self.outer.area - add_up(loop.area for loop in (self.inner, *self.unswept))

    @cached_property
    def _boundaries(self) -> tuple[Outline, Outline]:
        """The features of G and of D in the frame."""
        generatrix, directrix = self._polygons
        return MonotoneOutline(generatrix), MonotoneOutline(directrix)

    @cached_property
    def _route(self) -> Outline:
        """The trajectory of G's origin in the frame, for finding what lies on it."""
        return MonotoneOutline(self._trajectory[0])

    @cached_property
    def _numbered_contacts(self) -> list[list[Contact]]:
        """Contacts along the edges of the trajectory, features numbered in canonical order."""
        return find_edge_contacts(list_edges(self._route.vertices), *self._boundaries)

    @cached_property
    def contacts(self) -> tuple[tuple[Contact, ...], ...]:
        """The contacts along each edge of the trajectory (Table 1).

        Item k holds those that last for a piece of positive length of edge k, from vertex k of
        the trajectory to the next: EV, VE and EE events. Features are numbered as the caller gave
        the polygons: vertex i, and edge i from vertex i to the next.

        >>> from exactsweep import sweep
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> sweep(square, [(0, 0), (3, 0), (0, 3)]).contacts[2]
        (Contact(event='VE', generatrix=0, directrix=1),)
        """
        return tuple(tuple(map(self._as_given, found)) for found in self._numbered_contacts)

    @tells_arguments
    def contacts_along(
        self, loops: Iterable[Iterable[Iterable[object]]]
    ) -> Iterator[tuple[tuple[Contact, ...], ...]]:
        """The contacts along each edge of each of some loops of positions, all free, as `contacts`.

        A loop of two positions is the way from one to the other, and back; along no way there are
        no contacts.

        Cost: that of `contacts` for all loops together, not for each.
        """
        enter, reference = self._frame.enter_point, self.reference
        edges = [
            list_edges([enter(read_point(point, "position"), reference) for point in loop])
            for loop in loops
        ]
        ways = [(p, q) for p, q in chain.from_iterable(edges) if p != q]
        found = iter(find_edge_contacts(ways, *self._boundaries))
        return (
            tuple(tuple(map(self._as_given, next(found))) if p != q else () for p, q in of_loop)
            for of_loop in edges
        )

    @cached_property
    def vertex_contacts(self) -> tuple[tuple[Contact, ...], ...]:
        """All contacts at each vertex of the trajectory, VV among them, numbered as `contacts`.

        Cost: O(t (m + n) log(m + n)) for t vertices.
        """
        return tuple(self.contacts_at(vertex) for vertex in self.trajectory.vertices)

    def contacts_at(self, position: Iterable[object]) -> tuple[Contact, ...]:
        """All contacts when the reference point of G is at a position, numbered as `contacts`.

        Cost: O((m + n) log(m + n)).
        """
        t = self._frame.enter_point(read_point(position, "position"), self.reference)
        return tuple(map(self._as_given, find_contacts(*self._boundaries, t)))

    def _as_given(self, contact: Contact) -> Contact:
        event, i, j = contact
        g, d = self.generatrix, self.directrix
        return Contact(
            event,
            g.edge_index(i) if event[0] == "E" else g.vertex_index(i),
            d.edge_index(j) if event[1] == "E" else d.vertex_index(j),
        )

    @cached_property
    def exact_fits(self) -> tuple[tuple[Point, Point], ...]:
        """The segments of positions in slots of D that are exactly as wide as G, sorted.

        Each as (the end that hangs on the trajectory, the end inside the slot). G touches D there
        without overlap, but no free positions are near: the trajectory does not show them.

        >>> from exactsweep import sweep
        >>> slot = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
        >>> for fit in sweep([(0, 0), (1, 0), (1, 1), (0, 1)], slot).exact_fits:
        ...     print(*((str(x), str(y)) for x, y in fit))
        ('1', '3') ('1', '1')
        """
        found: list[tuple[Point, Point]] = []
        for half, turned in zip(self._halves, (False, True), strict=True):
            for fit in find_exact_fits(half.top, half.directrix, half.trajectory):
                ends = inverse(fit) if turned else fit
                hanging, inside = self._frame.leave(ends, self.reference)
                found.append((hanging, inside))
        return tuple(sorted(found))

    @cached_property
    def _tracer(self) -> Tracer:
        return Tracer(self._route, self._boundaries[0])

    @cached_property
    def undercuts(self) -> tuple[Undercut, ...]:
        """The regions between D and the inner loop (Figure 7), along the inner loop."""
        found: list[Undercut] = []
        for half, turned in zip(self._halves, (False, True), strict=True):
            for pocket in find_pockets(half.inner, half.directrix):
                bottom, top = map(inverse, pocket) if turned else pocket
                found.append(self._undercut(bottom, top[-2:0:-1]))
        return tuple(found)

    def _undercut(self, bottom: list[Vertex], back: list[Vertex]) -> Undercut:
        """The undercut above a bottom chain, with the vertices of D on the way back."""
        intersection, positions = find_closing_positions(bottom, self._tracer)
        points = self._frame.leave(bottom + back, ORIGIN)
        chain = tuple(points[: len(bottom)])
        return Undercut(
            Polygon(points),
            (chain[0], chain[-1]),
            chain,
            intersection,
            tuple(self._frame.leave(positions, self.reference)),
        )

    def certificate(self) -> dict[str, Any]:
        """Plain JSON data from which anyone can check the sweep: see `evidence.certificate`."""
        return write_certificate(
            Statement(
                generatrix=self.generatrix,
                directrix=self.directrix,
                kind=self.kind,
                direction=self.direction,
                reference=self.reference,
                trajectory=self.trajectory,
                inner=self.inner,
                outer=self.outer,
                area=self.area,
                exact_fits=self.exact_fits,
                contacts=self._numbered_contacts,
                inner_drawn=list(map(self._tracer.trace, list_edges(self._inner[0]))),
                outer_drawn=list(map(self._tracer.trace, list_edges(self._outer[0]))),
            )
        )

    def __str__(self) -> str:
        names = "trajectory", "inner", "outer"
        loops = [(name, getattr(self, name)) for name in names]
        # Of kind "SS" there is no direction.
        to = f"monotone to {write_vector(self.direction)}" if self.direction else "of any shape"
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


class pause_collector:  # noqa: N801
    """Keep the collector from running while many objects are made that refer to one another.

    It looks for cycles among all objects each time that their number has grown by some share. The
    kernel makes none, but 100,000 vertices make it look so often that this takes half of the time.
    """

    def __enter__(self) -> None:
        self.runs = gc.isenabled()
        gc.disable()

    def __exit__(self, *error: object) -> None:
        if self.runs:
            gc.enable()
