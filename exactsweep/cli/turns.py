"""Rotations and mirrored copies of a part: --turns and --mirrored."""

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

import click

from exactsweep import Point, Region
from exactsweep.cli.options import Decorator, checked, gather
from exactsweep.cli.parts import print_notes
from exactsweep.geometry.point_set import AffineMap
from exactsweep.geometry.turn import TURN_BITS, Turn, read_turn
from exactsweep.numbers.digits import abridge
from exactsweep.numbers.number import to_fraction


class Pose(NamedTuple):
    """A rotation of a part, preceded by mirroring (x to -x) if `mirrored`."""

    turn: Turn
    mirrored: bool = False

    @property
    def name(self) -> str:
        """The degrees, followed by ", mirrored" if that applies."""
        degrees = abridge(self.turn.degrees or Fraction(0))
        return f"{degrees}, mirrored" if self.mirrored else degrees

    @property
    def _map(self) -> AffineMap:
        cosine, sine, _ = self.turn.near(TURN_BITS)
        across = -1 if self.mirrored else 1
        return AffineMap(across * cosine, -sine, across * sine, cosine)

    def place(self, part: Region) -> Region:
        """Return the part in this pose."""
        return part._image(self._map)

    def place_point(self, point: Point) -> Point:
        """Return a point of the part in this pose."""
        a, b, c, d = self._map[:4]
        return Point(a * point.x + b * point.y, c * point.x + d * point.y)


def _read_turns(text: str) -> list[Turn]:
    return [read_turn(to_fraction(word.strip())) for word in text.split(",")]


def _make_poses(turns: list[Turn] | None, mirrored: bool) -> list[Pose] | None:
    if turns is None and not mirrored:
        return None
    return list(_list_poses(turns or [read_turn(0)], mirrored=mirrored))


def _list_poses(turns: list[Turn], *, mirrored: bool) -> Iterator[Pose]:
    for turn in turns:
        if turn.exact is None:
            degrees = abridge(turn.degrees or Fraction(0))
            print_notes([f"{degrees} degrees: rotated by a rational angle within 2^-{TURN_BITS}"])
        yield Pose(turn)
    if mirrored:
        yield from (Pose(turn, mirrored=True) for turn in turns)


def takes_turns(part: str) -> Decorator:
    """Add --turns and --mirrored, as `poses`, or None without them."""
    return gather(
        "poses",
        _make_poses,
        click.option(
            "--turns",
            "--rotations",
            "turns",
            callback=checked(_read_turns),
            metavar="DEGREES,...",
            help=f"Rotate {part} counter-clockwise about its origin by each of these angles.",
        ),
        click.option(
            "--mirrored", is_flag=True, help=f"Also mirror {part} (x to -x) before rotating it."
        ),
    )
