"""The sweep (G, D): classify the pair, run the procedures of its class, assemble the loops.

Definitions 1.1 to 1.3, Theorems 2.1 and 2.2.  The lower sweep (G_t, D_b) and the upper sweep
(G_b, D_t) never mix; the upper one is the lower one of both polygons turned by half a turn.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from functools import cached_property
from math import lcm
from typing import TYPE_CHECKING, Any

from exactsweep.chain import Vertex, inverse, split
from exactsweep.collector import resting
from exactsweep.contact import Boundary, Contact, contacts_at, edge_contacts
from exactsweep.direction import X_AXIS, Vector, read_direction, require_monotone, shared_direction
from exactsweep.exact_fit import exact_fits
from exactsweep.frame import Frame
from exactsweep.lower import Kind, LowerSweep
from exactsweep.polygon import ORIGIN, Point, Polygon, abridged, read_point
from exactsweep.tracing import Tracer
from exactsweep.undercut import Undercut, closing_positions, pockets

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Vertices = Polygon | Iterable[Iterable[object]]


class Sweep:
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

    @cached_property
    def _frame(self) -> Frame:
        return Frame(self.direction, lcm(self.generatrix.lattice()[0], self.directrix.lattice()[0]))

    @cached_property
    def _halves(self) -> tuple[LowerSweep, LowerSweep]:
        frame = self._frame
        g_bottom, g_top = split(frame.turned(frame.lattice(self.generatrix)))
        d_bottom, d_top = split(frame.turned(frame.lattice(self.directrix)))
        return (
            LowerSweep(self.kind, g_top, g_bottom, d_bottom),
            LowerSweep(self.kind, inverse(g_bottom), inverse(g_top), inverse(d_top)),
        )

    def _loop(self, half: Callable[[LowerSweep], Iterable[Vertex]], shift: Point) -> Polygon:
        with resting():
            lower, upper = (list(half(side)) for side in self._halves)
            upper = inverse(upper)
            # At each end the two chains meet in a point or are joined by a vertical edge.
            if upper[0] == lower[-1]:
                del upper[0]
            if upper[-1] == lower[0]:
                del upper[-1]
            loop = lower + upper
            if self.direction != X_AXIS:
                points = self._frame.turned_back(loop)
                start = min(range(len(points)), key=points.__getitem__)
                loop = loop[start:] + loop[:start]
            return Polygon._from_canonical(self._frame.leave(loop, shift))

    @cached_property
    def trajectory(self) -> Polygon:
        """The path of the reference point of G: the boundary of the no-fit polygon."""
        return self._loop(lambda half: half.path, self.reference)

    @cached_property
    def inner(self) -> Polygon:
        """The inner loop of the swept area: D with its undercuts closed."""
        return self._loop(lambda half: half.inner, ORIGIN)

    @cached_property
    def outer(self) -> Polygon:
        """The outer loop of the swept area."""
        return self._loop(lambda half: half.outer, ORIGIN)

    @cached_property
    def area(self) -> Fraction:
        """The swept area, outer minus inner loop."""
        return self.outer.area - self.inner.area

    @cached_property
    def _translations(self) -> list[Vertex]:
        """The trajectory of G's origin on the lattice, in canonical order."""
        return self._frame.raised(self.trajectory.vertices, self.reference)

    @cached_property
    def _numbered_contacts(self) -> list[list[Contact]]:
        """Contacts along the edges of the trajectory, features numbered in canonical order."""
        frame = self._frame
        return edge_contacts(
            self._translations, frame.lattice(self.generatrix), frame.lattice(self.directrix)
        )

    @cached_property
    def contacts(self) -> tuple[tuple[Contact, ...], ...]:
        """The contacts along each edge of the trajectory (Table 1).

        Item k holds those that last for a piece of positive length of edge k, from vertex k of
        the trajectory to the next: EV, VE and EE events.  Features are numbered as the caller gave
        the polygons: vertex i, and edge i from vertex i to the next.

        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> sweep(square, [(0, 0), (3, 0), (0, 3)]).contacts[2]
        (Contact(event='VE', generatrix=0, directrix=1),)
        """
        return tuple(tuple(map(self._as_given, found)) for found in self._numbered_contacts)

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
        frame = self._frame
        t = frame.turned(frame.raised([read_point(position, "position")], self.reference))[0]
        return tuple(map(self._as_given, contacts_at(*self._boundaries, t)))

    @cached_property
    def _boundaries(self) -> tuple[Boundary, Boundary]:
        frame = self._frame
        return (
            Boundary(frame.turned(frame.lattice(self.generatrix))),
            Boundary(frame.turned(frame.lattice(self.directrix))),
        )

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

        Each as (the end that hangs on the trajectory, the end inside the slot).  G touches D there
        without overlap, but no free positions are near: the trajectory does not show them.

        >>> slot = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
        >>> for fit in sweep([(0, 0), (1, 0), (1, 1), (0, 1)], slot).exact_fits:
        ...     print(*((str(x), str(y)) for x, y in fit))
        ('1', '3') ('1', '1')
        """
        found: list[tuple[Point, Point]] = []
        for half, turned in zip(self._halves, (False, True), strict=True):
            for fit in exact_fits(half.top, half.directrix, half.trajectory):
                ends = inverse(fit) if turned else fit
                hanging, inside = self._frame.leave(ends, self.reference)
                found.append((hanging, inside))
        return tuple(sorted(found))

    @cached_property
    def _tracer(self) -> Tracer:
        return Tracer(self._translations, self._frame.lattice(self.generatrix))

    @cached_property
    def undercuts(self) -> tuple[Undercut, ...]:
        """The regions between D and the inner loop (Figure 7), along the inner loop."""
        found: list[Undercut] = []
        frame = self._frame
        for half, turned in zip(self._halves, (False, True), strict=True):
            for pocket in pockets(half.inner, half.directrix):
                chains = (inverse(chain) if turned else chain for chain in pocket)
                bottom, top = (frame.leave(chain, ORIGIN) for chain in chains)
                intersection, positions = closing_positions(
                    frame.raised(bottom, ORIGIN), self._tracer
                )
                scale, (dx, dy) = frame.scale, self.reference
                found.append(
                    Undercut(
                        Polygon(bottom + top[-2:0:-1]),
                        (bottom[0], bottom[-1]),
                        tuple(bottom),
                        intersection,
                        tuple(
                            Point(Fraction(x) / scale + dx, Fraction(y) / scale + dy)
                            for x, y in positions
                        ),
                    )
                )
        return tuple(found)

    def certificate(self) -> dict[str, Any]:
        """Plain JSON data from which anyone can check the sweep: see `exactsweep.certificate`."""
        from exactsweep.certificate import certificate

        return certificate(self)

    def plot(
        self, axes: Axes | None = None, *, positions: Iterable[Iterable[object]] | None = None
    ) -> Axes:
        """Draw the sweep with matplotlib, the `plot` extra: see `exactsweep.draw.plot_sweep`."""
        from exactsweep.draw import plot_sweep

        return plot_sweep(self, axes, positions=positions)

    def _repr_svg_(self) -> str:
        from exactsweep.draw.notebook import sweep_svg

        return sweep_svg(self)

    def _repr_html_(self) -> str:
        from exactsweep.draw.notebook import sweep_html

        return sweep_html(self)

    def __str__(self) -> str:
        names = "trajectory", "inner", "outer"
        loops = [(name, getattr(self, name)) for name in names]
        return "\n".join(
            [f"{self.kind} sweep, monotone to {self.direction}, area {abridged(self.area)}"]
            + [f"{name}, {len(loop)} vertices: {loop}" for name, loop in loops]
        )

    def __repr__(self) -> str:
        return (
            f"<Sweep {self.kind} of {len(self.generatrix)} around {len(self.directrix)} vertices, "
            f"direction {self.direction}: trajectory {len(self.trajectory)}, "
            f"inner {len(self.inner)}, outer {len(self.outer)} vertices>"
        )


def sweep(
    generatrix: Vertices,
    directrix: Vertices,
    *,
    direction: Iterable[object] | None = None,
    reference: Iterable[object] = (0, 0),
) -> Sweep:
    """Sweep a generatrix G around a directrix D: always in contact, never overlapping.

    Args:
        generatrix: G, a Polygon or its vertices as `Polygon` takes them.
        directrix: D, likewise.
        direction: a pair of numbers, the shared direction of monotonicity to be used; chosen as
            by `shared_direction` if left out.  The loops do not depend on it.
        reference: the point of G whose path the trajectory is, in the coordinates of G.

    Returns:
        A Sweep with trajectory, inner and outer loop.

    Raises:
        PolygonError: a polygon is not simple.
        NumberError: a coordinate is not an exact number.
        DirectionError: the polygons are monotone to no shared direction, or not to this one.

    Cost: O(m + n) for CC, O(m n) for CM; for MM O(m n log n) for the trajectory and
    O(m n^2 log n) for the loops (Corollaries 3.4, 4.5, 4.6, 5.7, 5.8).

    Example:
        >>> s = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (2, 0), (1, 2)])
        >>> s.kind, s.area
        ('CC', Fraction(12, 1))
        >>> print(s.trajectory)
        (-1, -1) (2, -1) (2, 0) (1, 2) (0, 2) (-1, 0)
    """
    g, d = Polygon(generatrix), Polygon(directrix)
    if direction is None:
        chosen = shared_direction(g, d)
    else:
        chosen = read_direction(direction)
        require_monotone(g, chosen, "generatrix")
        require_monotone(d, chosen, "directrix")
    return Sweep(g, d, chosen, read_point(reference, "reference"))


def no_fit_polygon(stationary: Vertices, orbiting: Vertices) -> Polygon:
    """The no-fit polygon: where the origin of the orbiting polygon runs while both touch.

    Args:
        stationary: the directrix D, a Polygon or its vertices.
        orbiting: the generatrix G, likewise.

    Returns:
        The trajectory T(G, D), a Polygon.  Translations in its interior make the two overlap, but
        for exact fits.

    Raises, cost: as for the trajectory of `sweep`.

    Example:
        >>> print(no_fit_polygon([(0, 0), (2, 0), (1, 2)], [(0, 0), (1, 0), (1, 1), (0, 1)]))
        (-1, -1) (2, -1) (2, 0) (1, 2) (0, 2) (-1, 0)
    """
    return sweep(orbiting, stationary).trajectory
