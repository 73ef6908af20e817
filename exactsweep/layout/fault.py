"""Faults of layouts: their kinds, placements, proofs and measures."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Literal

from exactsweep.geometry.distance import find_foot
from exactsweep.layout.solid import Solid, share_scale
from exactsweep.layout.verdict import find_witness
from exactsweep.numbers.digits import abridge, to_plain
from exactsweep.numbers.number import Point
from exactsweep.sweep import inner_fit_polygon, no_fit_polygon
from exactsweep.words import count, write_pair

if TYPE_CHECKING:
    from exactsweep.geometry.polygon import Polygon
    from exactsweep.layout.board import Board

FaultKind = Literal[
    "overlap", "outside", "too close", "missing", "surplus", "turn", "mirror", "shape", "undecided"
]
"""The kinds of faults, the worst first."""


@dataclass(frozen=True)
class Fault:
    """A fault of a layout.

    Attributes:
        kind: "overlap": two placed parts overlap; "outside": a placed part is not inside the
            container, or overlaps a defect; "too close": two placed parts are nearer than the
            spacing, or one is nearer than the margin to the boundary of the container or of a
            defect; "missing", "surplus": a part has fewer or more placements than its demand;
            "turn", "mirror": a placement has a turn or a mirroring that its part forbids; "shape":
            a part is not simple, so its placements are not judged; "undecided": an angle without a
            rational turn, or flattened curves, leave the verdict open within the bound.
        placements: the numbers of the placements, ascending.
        part: the id of the part, for "missing", "surplus" and "shape".
        reason: the refusal of a part that is not simple, or the undecided question.
        number: the number of missing or surplus placements.
        distance_squared: the squared distance, for "too close".
        bound: the greatest error of the placed parts because of angles that have no rational turn,
            and of flattened curves; 0 if all is exact. The proof of a fault holds for the true
            turns and curves; `move` may be off by the bound.
        error: the share of the bound that is due to flattened curves.
        wall: the obstacle of a fault with one placement: 0 for the outside, k for defect k - 1.
    """

    kind: FaultKind
    placements: tuple[int, ...] = ()
    part: str | None = None
    reason: str = ""
    number: int = 0
    distance_squared: Fraction | None = None
    bound: Fraction = Fraction(0)
    _nearest: tuple[Point, ...] = field(default=(), repr=False)
    _board: Board | None = field(default=None, repr=False, compare=False)
    _bits: int = field(default=0, repr=False, compare=False)
    wall: int = field(default=0, repr=False, compare=False)
    error: Fraction = Fraction(0)

    @cached_property
    def points(self) -> tuple[Point, ...]:
        """The points that prove the fault.

        "overlap": a point inside both parts. "outside": a point inside the part that is outside the
        container or inside a defect. "too close": the two nearest points, the second one on the
        other part, on the container's boundary or on a defect. Other kinds have no points.
        """
        if self.kind not in ("overlap", "outside"):
            return self._nearest
        a, b = self.find_pair(self._bits)
        found = find_witness(a, b)
        assert found is not None
        return (found.point,)

    def find_pair(self, bits: int) -> tuple[Solid, Solid]:
        """Return the two solids of a fault, on one lattice.

        For a fault with one placement, the second solid is the outside or a defect.
        """
        board = self._board
        assert board is not None
        first = board.solid(self.placements[0], bits)
        if len(self.placements) > 1:
            return share_scale(first, board.solid(self.placements[1], bits))
        return share_scale(first, board.around[self.wall])

    @cached_property
    def move(self) -> Point | None:
        """The shortest move that repairs an "overlap" or "outside"; else None.

        For an overlap, the move frees the last placement from the first, without regard to other
        parts. For a part outside, it moves the part into the container, free of defects; it is None
        if the part, with its turn, does not fit in.

        Cost: that of `no_fit_polygon` or of `inner_fit_polygon`, on first access.
        """
        if self.kind not in ("overlap", "outside"):
            return None
        assert self._board is not None
        k = self.placements[-1]
        moved, at = self._board.turned(k, self._bits), self._board.layout.placements[k].move
        loops: Iterable[Polygon]
        if self.kind == "outside":
            inner = inner_fit_polygon(self._board.layout.container, moved)
            loops = [ring for one in inner.regions for ring in (one.exterior, *one.holes)]
            fits = inner.exact_fits
        else:
            j = self.placements[0]
            fixed, there = self._board.turned(j, self._bits), self._board.layout.placements[j].move
            at = Point(at.x - there.x, at.y - there.y)
            no_fit = no_fit_polygon(stationary=fixed, orbiting=moved)
            loops, fits = [no_fit.exterior, *no_fit.holes], no_fit.exact_fits
        edges = [(a, b) for loop in loops for a, b in pairwise((*loop.vertices, loop.vertices[0]))]
        moves = [
            Point(foot.x - at.x, foot.y - at.y)
            for foot in (find_foot(at, edge) for edge in (*edges, *fits))
        ]
        return min(moves, key=lambda by: (by.x * by.x + by.y * by.y, by), default=None)

    @property
    def depth_squared(self) -> Fraction | None:
        """The squared length of `move`, if there is one."""
        return None if self.move is None else self.move.x**2 + self.move.y**2

    def to_json(self) -> dict[str, Any]:
        """Write the fault as plain JSON data, numbers as strings."""
        found = {
            "part": self.part,
            "reason": self.reason or None,
            "number": self.number or None,
            "points": self.points or None,
            "distance_squared": self.distance_squared,
            "move": self.move,
            "bound": self.bound or None,
            "error": self.error or None,
        }
        given = {name: value for name, value in found.items() if value is not None}
        return to_plain({"kind": self.kind, "placements": self.placements, **given})

    def __str__(self) -> str:
        named = " and ".join(map(str, self.placements))
        at = write_pair(self.points[0]) if self.points else ""
        square = "" if self.distance_squared is None else abridge(self.distance_squared)
        near = "placements" if len(self.placements) > 1 else "the container and placement"
        placements = count(self.number, "placement")
        texts: dict[FaultKind, str] = {
            "overlap": f"placements {named} overlap at {at}",
            "outside": f"placement {named} is outside at {at}",
            "too close": f"{near} {named} are too close: squared distance {square}",
            "missing": f"{placements} of part {self.part} missing",
            "surplus": f"{placements} of part {self.part} too many",
            "shape": f"part {self.part} is not simple: {self.reason}",
            "undecided": f"placements {named}: {self.reason}",
        }
        return texts.get(self.kind, f"placement {named}: {self.reason}")
