"""Figures of layouts: rings or rounded pieces, and their placements, for claims in Coq."""

from __future__ import annotations

from fractions import Fraction
from itertools import chain
from typing import Any, NamedTuple

from exactsweep.check.standalone import AXES, is_convex, node, rotation_error
from exactsweep.check.terms import (
    Nat,
    RationalPoint,
    Record,
    TheoremError,
    read_points,
    read_rings,
)


class Figure(NamedTuple):
    """A shape, given by its rings or its rounded pieces (points and radius), and its error."""

    outline: list[list[RationalPoint]]
    rounded: list[tuple[list[RationalPoint], Fraction]]
    error: Fraction

    def points(self) -> list[RationalPoint]:
        """Return all vertices."""
        return [*chain(*self.rings())]

    def rings(self) -> list[list[RationalPoint]]:
        """Return the rings and the points of each piece."""
        return self.outline + [points for points, _ in self.rounded]

    def numbers(self) -> list[Fraction]:
        """Return the error and the radii."""
        return [self.error, *(radius for _, radius in self.rounded)]

    def term(self) -> Record:
        """Return the figure as a term."""
        return record(self._asdict())


class PlacedPart(NamedTuple):
    """A placement: its part, its motion, its rotation error, whether its rotation is allowed."""

    kind: int
    motion: Any
    slack: Fraction
    is_allowed: bool

    def term(self, slack: Fraction) -> Record:
        """Return the placement as a term."""
        names = ("mirrored", "cosine", "sine", "shift")
        by_motion = record(dict(zip(names, self.motion, strict=True)))
        return record({"kind": Nat(self.kind), "by_motion": by_motion, "slack": slack})


def record(fields: dict[str, Any]) -> Record:
    """Return a record of Statements.v."""
    return Record({f"Statements.{key}": value for key, value in fields.items()})


def read_figure(item: Any) -> Figure:
    """Read a body; raise TheoremError if it has rings and pieces, or a piece that is not convex."""
    error = Fraction(item.get("error") or 0)
    if item.get("pieces") is None:
        return Figure(read_rings(item), [], error)
    if item.get("exterior") is not None or item.get("holes"):
        raise TheoremError("a shape with rings and pieces")
    rounded = [(read_points(e["points"]), Fraction(e.get("radius") or 0)) for e in item["pieces"]]
    for points, _ in rounded:
        if len(points) > 2 and not is_convex([node(*p) for p in points]):
            raise TheoremError("a rounded piece that is not convex, counter-clockwise")
    return Figure([], rounded, error)


def read_rotation(turn: Any) -> Any:
    """Return cosine and sine, or degrees if these are irrational."""
    if type(turn) is list:
        return Fraction(turn[0]), Fraction(turn[1])
    degrees = Fraction("0" if turn is None else turn) % 360
    return degrees if degrees % 90 else tuple(map(Fraction, AXES[int(degrees) // 90]))


def read_move(item: Any, turn: Any, index: Any, drawn: list[Figure], allowed: Any) -> PlacedPart:
    """Read a placement; raise TheoremError if its entry in `turns` is another rotation."""
    k, asked, to = index[item["part"]], read_rotation(item.get("turn")), read_rotation(turn)
    slack, is_mirrored = Fraction(0), item.get("mirrored") is True
    turns = allowed[k][is_mirrored]
    if asked != to:
        if type(asked) is not Fraction:
            raise TheoremError("an entry of turns is not the rotation of its placement")
        slack = max(abs(x) + abs(y) for x, y in drawn[k].points()) * rotation_error(to, asked)
    motion = (is_mirrored, *to, read_points([item["move"]])[0])
    return PlacedPart(k, motion, slack, turns is None or asked in turns)


def place(move: PlacedPart, figure: Figure) -> Figure:
    """Return the placed figure, with the rotation error added to its own."""
    rounded = [(move_ring(move.motion, points), radius) for points, radius in figure.rounded]
    outline = [move_ring(move.motion, ring) for ring in figure.outline]
    return Figure(outline, rounded, figure.error + move.slack)


def move_ring(motion: Any, ring: list[RationalPoint]) -> list[RationalPoint]:
    """Return a ring mirrored, rotated and translated."""
    flag, c, s, (u, v) = motion
    points = [(-x if flag else x, y) for x, y in (ring[::-1] if flag else ring)]
    return [(c * x - s * y + u, s * x + c * y + v) for x, y in points]
