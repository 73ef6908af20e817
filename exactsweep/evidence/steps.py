"""The sweep step by step: the contacts of each step, and the reason for its end.

A step is an edge of the trajectory. G travels counter-clockwise, with D on the left. At the end of
a step, G turns left or right:

- left, at a corner: a vertex of G is on a vertex of D. Straight ahead, G would lose contact. G
  turns onto the next edge of D or of G by slope, as in Lemma 3.1.
- right, at a stop: straight ahead, G would overlap D at one or more new contacts.
- right, without a stop: straight ahead is an exact fit.

A contact stops G if every move in that direction, however short, causes overlap there. Near a
contact, both polygons are cones; inside an edge, the cone is a half-plane. After a short step, G
overlaps D there if and only if the step lies in the sum of D's open cone and the reflection of G's.
A step along an edge in contact is on the boundary of that sum, so it is allowed.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from itertools import pairwise, permutations
from typing import TYPE_CHECKING, Literal, NamedTuple

from exactsweep.evidence.contact import Contact, find_contacts, find_translations, list_edges
from exactsweep.geometry.direction import Vector
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.segment import find_direction, make_segment
from exactsweep.geometry.vectors import cross, minus
from exactsweep.numbers.number import Edge, Point, Rational, Vertex

if TYPE_CHECKING:
    from exactsweep.evidence.sweep import SweepAnswer

Half = Literal["lower", "right", "upper", "left"]
Mark = Literal["undercut", "undercut opens", "undercut closes", "exact fit"]
Ending = Literal["corner", "stop", "exact fit"]


class Touch(NamedTuple):
    """A contact, and the piece of the step along which it lasts, in the direction of travel."""

    contact: Contact
    start: Point
    end: Point


class Landmark(NamedTuple):
    """An undercut or an exact fit that G passes.

    Attributes:
        mark: "undercut" if G closes an entire undercut in this position; "undercut opens" and
            "undercut closes" at the first and the last of several positions; "exact fit" at the end
            of an exact fit.
        number: index in `Sweep.undercuts` or `Sweep.exact_fits`.
        position: a Point on the step other than its start.
    """

    mark: Mark
    number: int
    position: Point


class Step(NamedTuple):
    """An edge of the trajectory.

    Attributes:
        start: the first position of the reference point, a Point.
        end: the last position, a Point.
        direction: the primitive integer vector from start to end.
        half: "lower" for the sweep (G_t, D_b), "upper" for (G_b, D_t), and "right" or "left" for a
            vertical edge between the two, if the shared direction points to the right.
        touches: tuple of Touch, sorted by their start.
        landmarks: tuple of Landmark in the order of travel.
        ending: "corner", "stop" or "exact fit": the reason why the step ends.
        reasons: tuple of Contact, features as in the input: at a corner the vertices that meet, at
            a stop the contacts that stop G; empty before an exact fit.
    """

    start: Point
    end: Point
    direction: Vector
    half: Half
    touches: tuple[Touch, ...]
    landmarks: tuple[Landmark, ...]
    ending: Ending
    reasons: tuple[Contact, ...]


def explain(s: SweepAnswer) -> tuple[Step, ...]:
    """Explain a sweep step by step, starting at the first vertex of the trajectory.

    Step k corresponds to `s.contacts[k]`. Cost: O(m n + t) look-ups for t edges of the trajectory,
    plus O((m + n) log(m + n)) for each of its right turns.

    >>> from exactsweep import sweep
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> slot = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
    >>> step = explain(sweep(square, slot))[2]
    >>> step.direction, [touch.contact.event for touch in step.touches], step.ending
    ((-1, 0), ['EE', 'EE'], 'corner')
    >>> [mark.mark for mark in step.landmarks]
    ['undercut', 'exact fit']
    """
    return _Guide(s).steps()


class _Guide:
    """The data of a sweep in the coordinates of its frame."""

    def __init__(self, s: SweepAnswer) -> None:
        self.sweep = s
        self.generatrix, self.directrix = s._boundaries
        self.path = s._route
        loop = self.path.vertices
        self.first = min(range(len(loop)), key=loop.__getitem__)

    def steps(self) -> tuple[Step, ...]:
        s = self.sweep
        edges = list_edges(self.path.vertices)
        landmarks = self._landmarks()
        halves = self._halves()
        found = []
        positions, leave = s.trajectory.vertices, s.solution.frame.leave_point
        for k, (edge, following) in enumerate(pairwise([*edges, edges[0]])):
            pieces = [(c, self._piece(c, edge)) for c in s._numbered_contacts[k]]
            pieces.sort(key=lambda piece: _progress(edge, piece[1][0]))
            ending, reasons = self._ending(edge, following, s._numbered_contacts[k])
            found.append(
                Step(
                    positions[k],
                    positions[(k + 1) % len(positions)],
                    _direction(positions[k], positions[(k + 1) % len(positions)]),
                    halves[k],
                    tuple(
                        Touch(s._as_given(c), leave(start, s.reference), leave(end, s.reference))
                        for c, (start, end) in pieces
                    ),
                    tuple(landmarks[k]),
                    ending,
                    tuple(sorted(map(s._as_given, reasons))),
                )
            )
        return tuple(found)

    def _piece(self, contact: Contact, edge: Edge) -> Edge:
        """Find the piece of an edge of the trajectory along which a contact lasts."""
        lasting = find_translations(contact, self.generatrix, self.directrix)
        whole = make_segment(edge)
        ends = max(lasting.low, whole.low), min(lasting.high, whole.high)
        start, end = map(whole.point, ends if edge[0] < edge[1] else ends[::-1])
        return start, end

    def _ending(
        self, edge: Edge, following: Edge, contacts: Sequence[Contact]
    ) -> tuple[Ending, list[Contact]]:
        step, turned = minus(edge[1], edge[0]), minus(following[1], following[0])
        if cross(step, turned) > 0:
            return "corner", self._meeting(edge[1], contacts)
        g, d = self.generatrix, self.directrix
        stops = [c for c in find_contacts(g, d, edge[1]) if blocks(c, step, g, d)]
        return ("stop", stops) if stops else ("exact fit", [])

    def _meeting(self, t: Vertex, contacts: Sequence[Contact]) -> list[Contact]:
        """Find the vertices of features in contact along the step that meet at a translation."""
        g, d = self.generatrix, self.directrix
        found = set()
        for event, i, j in contacts:
            for a in (i, g.after[i]) if event[0] == "E" else (i,):
                for b in (j, d.after[j]) if event[1] == "E" else (j,):
                    if minus(d.vertices[b], g.vertices[a]) == t:
                        found.add(Contact("VV", a, b))
        return list(found)

    def _landmarks(self) -> defaultdict[int, list[Landmark]]:
        listed: list[Landmark] = []
        for number, undercut in enumerate(self.sweep.undercuts):
            positions = sorted(undercut.positions, key=self._place)
            if len(positions) == 1:
                listed.append(Landmark("undercut", number, positions[0]))
            else:
                listed.append(Landmark("undercut opens", number, positions[0]))
                listed.append(Landmark("undercut closes", number, positions[-1]))
        for number, fit in enumerate(self.sweep.exact_fits):
            # An exact fit in a cavity or a hole has no end on the trajectory.
            hanging = [end for end in fit if self._edge_to(end) is not None]
            listed += [Landmark("exact fit", number, end) for end in hanging[:1]]
        found: defaultdict[int, list[Landmark]] = defaultdict(list)
        for landmark in sorted(listed, key=lambda landmark: self._place(landmark.position)):
            k, _ = self._place(landmark.position)
            found[(k + self.first) % len(self.path.vertices)].append(landmark)
        return found

    def _edge_to(self, position: Point) -> int | None:
        """Find the edge of the trajectory that contains a position other than its start."""
        point = self.sweep.solution.frame.enter_point(position, self.sweep.reference)
        for kind, k in self.path.find_at(point):
            return k if kind == "E" else self.path.before[k]
        return None

    def _place(self, position: Point) -> tuple[int, Rational]:
        """Find a position on the trajectory, counted from its first vertex in the frame."""
        # No undercut of either sweep extends across that vertex.
        k = self._edge_to(position)
        assert k is not None
        point = self.sweep.solution.frame.enter_point(position, self.sweep.reference)
        return (k - self.first) % len(self.path.vertices), _progress(self.path.edge(k), point)

    def _halves(self) -> list[Half]:
        loop = self.path.vertices
        size, left, right = len(loop), loop[self.first][0], max(loop)[0]
        halves: list[Half] = ["upper"] * size
        for k in range(self.first, self.first + size):
            if loop[k % size][0] == right:
                break
            halves[k % size] = "lower"
        for k, (p, q) in enumerate(list_edges(loop)):
            if p[0] == q[0] and p[0] in (left, right):
                halves[k] = "left" if p[0] == left else "right"
        return halves


def _progress(edge: Edge, point: Vertex) -> Rational:
    """Return a coordinate along an edge that increases in its direction."""
    (x, y), (u, v) = minus(point, edge[0]), minus(edge[1], edge[0])
    return x * u + y * v


def _direction(start: Point, end: Point) -> Vector:
    p, q = find_direction((start, end))
    return (p, q) if start < end else (-p, -q)


def blocks(contact: Contact, step: Vertex, generatrix: Outline, directrix: Outline) -> bool:
    """Decide whether every short move in the direction `step` causes overlap at a contact.

    Before the move, G touches D without overlap.

    >>> square = Outline([[(0, 0), (1, 0), (1, 1), (0, 1)]])
    >>> on_top = Contact("EE", 0, 2)
    >>> [blocks(on_top, step, square, square) for step in [(1, 0), (1, 1), (1, -1)]]
    [False, False, True]
    """
    event, i, j = contact
    if event == "EV":
        _, forward = _rays(generatrix, i)
        return cross(forward, step) < 0
    if event != "VV":
        _, forward = _rays(directrix, j)
        return cross(forward, step) > 0
    g_back, g_forward = _rays(generatrix, i)
    d_back, d_forward = _rays(directrix, j)
    back = minus((0, 0), step)
    # In a reflex corner, the free cone is convex, and the other polygon can only move within it,
    # unless it is elsewhere and touches another ring at this point.
    if cross(d_forward, d_back) < 0:
        return _is_held((d_back, d_forward), (g_back, g_forward), step)
    if cross(g_forward, g_back) < 0:
        return _is_held((g_back, g_forward), (d_back, d_forward), back)
    # The sum of two convex cones without overlap is convex, at most a half-plane. If the cones
    # overlap, another ring lies between them.
    rays = [d_forward, d_back, minus((0, 0), g_forward), minus((0, 0), g_back)]
    return any(
        all(cross(first, other) >= 0 and cross(other, last) >= 0 for other in rays)
        for first, last in permutations(rays, 2)
        if cross(first, step) > 0 and cross(step, last) > 0
    )


def _is_held(free: tuple[Vertex, Vertex], rays: Sequence[Vertex], step: Vertex) -> bool:
    """Decide whether a step leads out of a convex free cone that contains the given rays."""
    first, last = free

    def is_out(ray: Vertex) -> bool:
        return cross(first, ray) < 0 or cross(ray, last) < 0

    return is_out(step) and not any(map(is_out, rays))


def _rays(outline: Outline, k: int) -> tuple[Vertex, Vertex]:
    vertices = outline.vertices
    here = vertices[k]
    return minus(vertices[outline.before[k]], here), minus(vertices[outline.after[k]], here)
