"""The loops of the area that a generatrix of any shape sweeps along its trajectory (kind "SS").

G travels along the loop T, the exterior of the no-fit polygon, and covers S = T + G. A point p is
left out exactly if I(G) + p misses T, and so lies inside of T or outside. The first are the
positions in which I(G) fits into T; the second those around which T's inside is a no-fit polygon.
So the two sides of S are one question each of those that `ss` answers.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

from exactsweep.evidence.contact import Contact
from exactsweep.evidence.no_fit import LatticePair, NoFitPositions
from exactsweep.evidence.shape_certificate import write_points
from exactsweep.evidence.shape_undercuts import find_mouths
from exactsweep.evidence.swept import Swept
from exactsweep.evidence.undercut import Undercut
from exactsweep.geometry.direction import X_AXIS
from exactsweep.geometry.frame import Frame
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.overlap import Overlap
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.numbers.number import format_fraction
from exactsweep.numbers.point import ORIGIN, Fit, Point
from exactsweep.procedures.made_once import made_once


class SweptShape(Swept):
    """The sweep of two shapes, with holes or without, that share no direction of monotonicity.

    Attributes are those of `Swept`; `direction` is None. Each loop is computed when it is first
    read.
    """

    generatrix: Region  # type: ignore[assignment]
    directrix: Region  # type: ignore[assignment]
    direction: None  # type: ignore[assignment]

    def __init__(self, generatrix: Region, directrix: Region, reference: Point) -> None:
        self.generatrix = generatrix
        self.directrix = directrix
        self.reference = reference
        self.direction = None
        self.kind = "SS"

    @cached_property
    def _no_fit(self) -> NoFitPositions:
        return NoFitPositions(self.directrix, self.generatrix, self.reference, None)

    @property
    def trajectory(self) -> Polygon:
        """The path of the reference point of G: the exterior of the no-fit polygon."""
        return self._no_fit.exterior

    @property
    def exact_fits(self) -> tuple[Fit, ...]:
        """Exact fits anywhere, in caves and holes, too: those of the no-fit polygon."""
        return self._no_fit.exact_fits

    @property
    def no_fit_holes(self) -> tuple[Polygon, ...]:
        """The holes of the no-fit polygon, sorted: where G fits into a cave or a hole of D."""
        return self._no_fit.holes

    @cached_property
    def _path(self) -> LatticePair:
        """T's inside, and I(G), which misses T where a point is not swept."""
        x, y = self.reference
        path = Region(self.trajectory.translated((-x, -y)))
        # T's corners where contact segments cross would make the common lattice huge.
        scale = self._no_fit.pair.scale
        return LatticePair(path, self.generatrix.reflected(), ORIGIN, scale=scale)

    @cached_property
    def _outside(self) -> tuple[Polygon, tuple[Polygon, ...]]:
        found = self._path.no_fit()
        return self._path.polygon(found.exterior), self._path.polygons(found.holes)

    @cached_property
    def _inside(self) -> tuple[Polygon, ...]:
        found = self._path.inner_fit()
        return self._path.polygons([loop for loop, _ in found.regions])

    @property
    def outer(self) -> Polygon:
        """The outer loop of the swept area."""
        return self._outside[0]

    @cached_property
    def inner(self) -> Polygon:
        """The loop around D of what is not swept: D with its undercuts and holes closed."""
        ring = self.directrix.exterior.vertices
        # D lies in one of them, and they have no inner points in common.
        return next(loop for loop in self._inside if Overlap([loop.vertices], [ring]).at(ORIGIN))

    @cached_property
    def unswept(self) -> tuple[Polygon, ...]:
        """The other holes of the swept area, sorted."""
        others = [loop for loop in self._inside if loop is not self.inner]
        return tuple(sorted((*others, *self._outside[1]), key=lambda loop: loop.vertices))

    @made_once
    def _frame(self) -> Frame:
        return Frame(X_AXIS, self._no_fit.pair.scale)

    @cached_property
    def _boundaries(self) -> tuple[Outline, Outline]:
        """The features of G and of D on the lattice."""
        pair = self._no_fit.pair
        return Outline(pair.moved), Outline(pair.fixed)

    @cached_property
    def _route(self) -> Outline:
        """The trajectory of G's origin on the lattice."""
        enter = self._frame.enter_point
        return Outline([[enter(vertex, self.reference) for vertex in self.trajectory.vertices]])

    def _as_given(self, contact: Contact) -> Contact:
        event, i, j = contact
        g, d = self._boundaries
        return Contact(
            event,
            _number(self.generatrix, g, i, of_edge=event[0] == "E"),
            _number(self.directrix, d, j, of_edge=event[1] == "E"),
        )

    @cached_property
    def undercuts(self) -> tuple[Undercut, ...]:
        """The regions between D and the inner loop, along the inner loop; no holes of D."""
        inner = [self._frame.enter_point(vertex, ORIGIN) for vertex in self.inner.vertices]
        return tuple(
            self._undercut(bottom, top[1:-1])
            for bottom, top in find_mouths(inner, self._no_fit.pair.fixed[0])
        )

    def certificate(self) -> dict[str, Any]:
        """Plain JSON data from which anyone can check the sweep, positions told of G's origin."""
        return {
            **self._no_fit.certificate(),
            "claim": "sweep",
            "kind": "SS",
            "inner": write_points(self.inner.vertices),
            "outer": write_points(self.outer.vertices),
            "unswept": [write_points(loop.vertices) for loop in self.unswept],
            "area": format_fraction(self.area),
        }


def _number(shape: Region, outline: Outline, k: int, *, of_edge: bool) -> int:
    """The index in the caller's input of feature k of an outline, whose holes run clockwise."""
    size = len(shape.exterior)
    if k < size:
        return shape.edge_index(k) if of_edge else shape.vertex_index(k)
    # Of a hole, vertex 0 is the same both ways; its edge k ends where the edge as given starts.
    first = size
    for hole in shape.holes:
        if k < first + len(hole):
            break
        first += len(hole)
    number = first + (first - (outline.after[k] if of_edge else k)) % len(hole)
    return shape.edge_index(number) if of_edge else shape.vertex_index(number)
