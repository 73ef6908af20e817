"""Open lines joined at equal ends to closed outlines."""

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import NamedTuple

from exactsweep.formats.outline import Outline
from exactsweep.geometry.point import Point
from exactsweep.words import pair


class Piece(NamedTuple):
    """An open line.

    Attributes:
        line: the line of the file on which it starts.
        place: what and where it is, for messages.
        ends: its first and its last point.
        points: reads all of its points, from the first to the last.
    """

    line: int
    place: str
    ends: tuple[Point, Point]
    points: Callable[[], Sequence[Point]]


def join(pieces: Sequence[Piece], layer: str) -> Iterator[tuple[int, Outline]]:
    """Join lines whose ends are equal.

    Args:
        pieces: open lines of one layer.
        layer: its name.

    Yields:
        (line, Outline) for each set of lines that hang together; where not every end meets exactly
        one other, its `vertices` refuses it and names the place.

    Cost: linear.
    """
    at: defaultdict[Point, list[int]] = defaultdict(list)
    for k, piece in enumerate(pieces):
        for end in piece.ends:
            at[end].append(k)
    seen: set[int] = set()
    for first in range(len(pieces)):
        if first in seen:
            continue
        found, fault = [first], ""
        seen.add(first)
        for k in found:
            for end in pieces[k].ends:
                fault = fault or _fault(pieces[k], end, len(at[end]))
                new = [other for other in at[end] if other not in seen]
                seen.update(new)
                found += new
        together = [pieces[k] for k in sorted(found)]
        if fault:
            outline = Outline.refused(fault, layer=layer)
        else:
            outline = Outline(together[0].place, partial(_walk, together), layer=layer)
        yield together[0].line, outline


def _fault(piece: Piece, end: Point, count: int) -> str:
    if count == 2:
        return ""
    meets = "meets no other end exactly" if count == 1 else f"is one of {count} that meet"
    return f"{piece.place}: the end {pair(end)} {meets}"


def _walk(pieces: Sequence[Piece]) -> list[Point]:
    """Walk along pieces, each of whose ends meets one other, back to the start."""
    at: defaultdict[Point, list[Piece]] = defaultdict(list)
    for piece in pieces:
        for end in piece.ends:
            at[end].append(piece)
    outline: list[Point] = []
    piece = pieces[0]
    place = piece.ends[0]
    for _ in pieces:
        points = piece.points()
        if piece.ends[0] != place:
            points = points[::-1]
        outline += points[:-1]
        place = piece.ends[piece.ends[0] == place]
        one, other = at[place]
        piece = other if one is piece else one
    return outline
