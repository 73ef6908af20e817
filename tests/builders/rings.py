"""Rings around rings: frames, washers and letters C, one inside the other."""

from collections.abc import Iterator
from fractions import Fraction

from builders import outlines
from builders.entry import Entry, Ring, box, in_places, scaled
from exactsweep import Region
from exactsweep.corpus.generator.cells import build_frame, connect, trace_outline

TITLE = "Rings around rings"

DIAMOND: Ring = [(3, 0), (0, 3), (-3, 0), (0, -3)]


def entries() -> Iterator[Entry]:
    for slug, title, d, g in [
        ("nested", "A frame inside a frame, with room", square(7), square(3)),
        ("nested-exact", "A frame in one position inside a frame", square(5), square(3)),
        (
            "nested-slide",
            "A frame that slides inside a frame",
            trace_outline(build_frame(7, 5)),
            square(3),
        ),
        ("outside", "A frame that moves around a smaller one", square(3), square(7)),
        ("outside-exact", "A frame in one position around a smaller one", square(3), square(5)),
        ("equal", "A frame around itself", square(4), square(4)),
        ("linked", "Frames of one size, each too thick for the other", square(4), square(3)),
        ("three", "A frame between two: D is a frame with an island's width", square(9), square(5)),
        ("gap", "A frame with a gap, and a bar", gapped(5), Region(box(1, 1))),
        ("gap-ring", "A frame with a gap, and a smaller ring", gapped(7), square(3)),
        ("gap-around", "A ring around a frame with a gap", gapped(3), square(7)),
        ("washers", "A washer inside a washer", washer(25, 10), washer(10, 5)),
        ("washers-equal", "Two washers of one size", washer(10, 5), washer(10, 5)),
        ("washers-exact", "A washer in the hole of its size", washer(25, 10), washer(10, 5)),
        ("diamonds", "A diamond ring in a square one", square(8), diamond()),
        ("diamond-around", "A diamond ring around a square", Region(box(1, 1)), diamond()),
    ]:
        yield from in_places(slug, title, d, g)


def square(side: int) -> Region:
    return trace_outline(build_frame(side, side))


def gapped(side: int) -> Region:
    return trace_outline(connect(build_frame(side, side) - {(side // 2, 0)}))


def washer(radius: int, hole: int) -> Region:
    return Region(_circle(radius), [_circle(hole)])


def _circle(radius: int) -> Ring:
    return outlines.arc(0, 0, radius, 0, 4)[:-1]


def diamond() -> Region:
    return Region(DIAMOND, [scaled(DIAMOND, Fraction(1, 2))])
