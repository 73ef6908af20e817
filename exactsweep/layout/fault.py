"""Faults of layouts: their kinds, placements, witnesses and measures."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

from exactsweep.geometry.overlap import Relation
from exactsweep.layout.clearance import Clearance, find_clearance, is_rounded, relate
from exactsweep.layout.repair import find_depth_move, find_repair
from exactsweep.layout.solid import Solid, share_scale
from exactsweep.layout.verdict import find_witness
from exactsweep.numbers.digits import abridge, to_plain
from exactsweep.numbers.number import Point
from exactsweep.words import count, write_pair

if TYPE_CHECKING:
    from exactsweep.layout.board import Board

FaultKind = Literal[
    "overlap", "outside", "too close", "missing", "surplus", "turn", "mirror", "shape", "undecided"
]  # the worst first
# Depths with a greater ratio differ only by rounding.
_ALMOST = 1 - Fraction(1, 2**50)
_REPAIRED = "overlap", "outside", "too close", "undecided"


@dataclass(frozen=True)
class Fault:
    """A fault of a layout; README.md lists the kinds.

    Attributes:
        kind: one of `FaultKind`.
        placements: the indices of the placements, ascending.
        part: the id of the part, for "missing", "surplus" and "shape".
        reason: why a part is not simple, a placement is forbidden, or the verdict is undecided.
        number: the number of missing or surplus placements.
        distance_squared: the squared distance, for "too close".
        bound: a bound on the errors that irrational rotations and flattened curves cause in both
            solids. The fault holds for the true rotations and curves; `move` may be off by this.
        error: the part of the bound due to flattened curves.
        wall: the obstacle of a fault with one placement, an index in `Board.obstacles`.
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

        "overlap": a point inside both parts. "outside": a point of the part that is outside the
        container or inside a defect. "too close": the two nearest points; the second is on the
        other part, the container's boundary or a defect. Other kinds have no points.
        """
        if self.kind not in ("overlap", "outside"):
            return self._nearest
        a, b = self.find_pair(self._bits)
        found = find_witness(a, b)
        assert found is not None
        return (found,)

    def find_pair(self, bits: int) -> tuple[Solid, Solid]:
        """Return the two solids of a fault on a common lattice; an obstacle comes second."""
        board = self._board
        assert board is not None
        first = board.solid(self.placements[0], bits)
        if len(self.placements) > 1:
            return share_scale(first, board.solid(self.placements[1], bits))
        return share_scale(first, board.obstacles[self.wall])

    @cached_property
    def move(self) -> Point | None:
        """A shortest move of the last placement that repairs the fault; None if there is none.

        It respects the spacing or the margin, but ignores other parts. A part outside moves into
        the container, off the defects, if it fits at its rotation. The judge accepts the result.
        The move is shortest if no distance is required and all rotations are rational; otherwise
        see `exactsweep.layout.repair`. It is computed on first access.
        """
        if self._board is None or self.kind not in _REPAIRED:
            return None
        return find_repair(self._board, self.placements, self._bits)

    @cached_property
    def depth_squared(self) -> Fraction | None:
        """The squared length of the shortest move to contact, for "overlap" and "outside".

        It ignores the spacing and the margin, and is None if the part fits nowhere. The length may
        be off by the bound. For rounded parts it is rounded up, and only an upper bound if one of
        them is not convex. It is computed on first access.
        """
        if self._board is None or self.kind not in ("overlap", "outside"):
            return None
        move = find_depth_move(self._board, self.placements, self._bits)
        return None if move is None else move.x**2 + move.y**2

    @property
    def box_depth(self) -> Fraction:
        """The overlap of the two bounding boxes, a bound on the depth; 0 for other faults."""
        if self._board is None or len(self.placements) < 2:
            return Fraction(0)
        one, other = map(self._board.solid, self.placements)
        (left, right, low, high), (west, east, south, north) = (
            [Fraction(side) / solid.scale for side in solid.box] for solid in (one, other)
        )
        return min(right - west, east - left, high - south, north - low)

    @cached_property
    def clearance(self) -> Clearance | None:
        """The exact distance or depth of two rounded shapes; None for polygons."""
        if self._board is None or self.kind not in _REPAIRED:
            return None
        pair = self.find_pair(self._bits)
        return find_clearance(*pair) if is_rounded(*pair) else None

    @property
    def least_depth_squared(self) -> Fraction | None:
        """A lower bound on `depth_squared`, equal except for nonconvex rounded parts."""
        if self.clearance is None or self.depth_squared is None:
            return self.depth_squared
        depth = self.clearance.bound(up=True)
        is_exact = self.depth_squared * _ALMOST <= depth * depth
        return self.depth_squared if depth >= 0 or is_exact else depth * depth

    @property
    def required(self) -> Fraction | None:
        """The required distance, for "too close"."""
        if self._board is None or self.kind != "too close":
            return None
        if len(self.placements) > 1:
            return self._board.layout.spacing
        return self._board.required(self.wall)

    def is_within(self, depth: Fraction) -> bool:
        """Return whether the depth or the missing distance is at most `depth`.

        This is proved for the true rotations and curves. For overlaps, it needs `depth_squared`.
        """
        room = depth - self.bound
        if room < 0 or self._board is None:
            return False
        if self.kind in ("overlap", "outside"):
            return self.depth_squared is not None and self.depth_squared <= room * room
        if self.kind == "too close":
            assert self.required is not None
            assert self.distance_squared is not None
            least = self.required - room
            if self.clearance is not None:
                return not self.clearance.is_below(least)
            return least <= 0 or self.distance_squared >= least * least
        if self.kind != "undecided":
            return False
        if relate(*self.find_pair(self._bits)) is not Relation.OVERLAP:
            return 2 * self.bound <= depth
        move = find_depth_move(self._board, self.placements, self._bits)
        return move is not None and move.x**2 + move.y**2 <= room * room

    def to_json(self, *, measured: bool = True) -> dict[str, Any]:
        """Return plain JSON data; include the depth and the repair if `measured`."""
        found = {
            "part": self.part,
            "reason": self.reason or None,
            "number": self.number or None,
            "points": self.points or None,
            "distance_squared": self.distance_squared,
            "required": self.required,
            "hull_distance_squared": self.clearance and self.clearance.square,
            "radii": self.clearance and self.clearance.radius,
            "depth_squared": self.depth_squared if measured else None,
            "least_depth_squared": self.least_depth_squared if measured else None,
            "move": self.move if measured else None,
            "bound": self.bound or None,
            "error": self.error or None,
        }
        if found["least_depth_squared"] == found["depth_squared"]:
            found["least_depth_squared"] = None
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
            "missing": f"part {self.part}: {placements} missing",
            "surplus": f"part {self.part}: {placements} too many",
            "shape": f"part {self.part} is not simple: {self.reason}",
            "undecided": f"placements {named}: {self.reason}",
        }
        return texts.get(self.kind, f"placement {named}: {self.reason}")
