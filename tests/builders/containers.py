"""Containers: with room, with room in one direction, with none, too small, with defects."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from builders import outlines
from builders.entry import UNIT, Entry, Ring, box, in_places, moved, scaled
from exactsweep import Region
from exactsweep.corpus.generator.cells import draw

TITLE = "Containers: room inside, none, defects, several rooms"

TRIANGLE: Ring = [(0, 0), (6, 0), (0, 6)]
L: Ring = [(0, 0), (6, 0), (6, 2), (2, 2), (2, 5), (0, 5)]
NEAR = 10**15


def entries() -> Iterator[Entry]:
    for slug, title, d, g in [
        ("room", "A bin with room", box(7, 5), box(3, 2)),
        ("as-wide", "A bin as wide as the part", box(3, 5), box(3, 2)),
        ("as-high", "A bin as high as the part", box(7, 2), box(3, 2)),
        ("exact", "A bin of the shape of the part", box(3, 2), box(3, 2)),
        ("too-low", "A bin too low", box(9, 1), box(3, 2)),
        ("triangles", "A triangle in a triangle", TRIANGLE, scaled(TRIANGLE, Fraction(1, 2))),
        ("triangle-itself", "A triangle in itself", TRIANGLE, TRIANGLE),
        ("triangle-inverse", "A triangle that points the other way", TRIANGLE, INVERSE),
        ("diamond", "A diamond in a bin as wide as it", box(4, 4), DIAMOND),
        ("l-in-bin", "A bin of the width and height of an L", box(6, 5), L),
        ("bin-in-l", "A part in an L, in both arms", L, box(2, 2)),
        ("bin-in-l-small", "A part with room in both arms", L, UNIT),
        ("u", "A container with two arms", [*COLUMNS], box(2, 2)),
        ("hourglass", "Two rooms with a waist too narrow", HOURGLASS, box(4, 4)),
        ("hourglass-exact", "Two rooms, the waist as wide as the part", HOURGLASS, box(2, 4)),
    ]:
        yield from in_places(slug, title, Region(d), Region(g))
    defects = Region(box(9, 6), [box(1, 1, 3, 2), [(6, 1), (7, 2), (6, 3), (5, 2)]])
    for slug, title, part in [
        ("defects", "A sheet with defects", Region(UNIT)),
        ("defects-between", "Between two defects the part fits exactly", Region(box(2, 1))),
        ("defects-large", "A part that goes beside the defects only", Region(box(3, 3))),
        ("defects-around", "A frame that can be put around a defect", draw("###", "# #", "###")),
        ("defects-all", "No room beside the defects", Region(box(9, 6))),
    ]:
        yield from in_places(slug, title, defects, part)
    three = draw("#########", "#  ## ###", "#  #    #", "#  #    #", "#########")
    yield from in_places("complement", "A sheet whose rest is a frame", three, Region(UNIT))
    for slug, title, side in [
        ("near-too-small", "A bin too narrow by one part in 10^15", NEAR - 1),
        ("near-exact", "A bin of 10^15, as wide as the part", NEAR),
        ("near-too-wide", "A bin wider by one part in 10^15", NEAR + 1),
    ]:
        yield Entry(slug, title, box(side, 2 * NEAR), box(NEAR, NEAR), inside=True)
    tenth = Fraction(1, 10)
    yield Entry(
        "tenths",
        "A bin of 3/10 and a part from 1/10 to 4/10: as doubles they differ",
        box(3 * tenth, 1),
        box(3 * tenth, tenth, tenth, 0),
        inside=True,
    )
    yield Entry("clockwise", "Both given clockwise", box(7, 5)[::-1], box(3, 2)[::-1], inside=True)
    yield Entry("clockwise-exact", "Both clockwise, no room", L[::-1], L[::-1], inside=True)
    repeated = [(0, 0), *box(7, 5), (0, 0)]
    yield Entry("repeated", "The bin's first vertex three times", repeated, UNIT, inside=True)
    yield Entry(
        "reference",
        "The reference point far away, on sevenths",
        box(3, 5),
        box(3, 2),
        reference=(Fraction(10**12, 7), Fraction(-1, 7)),
        inside=True,
    )
    yield Entry(
        "parts-in-sheet", "A bracket in a sheet", box(120, 80), outlines.bracket(), inside=True
    )
    yield Entry(
        "part-in-arch", "A key in the arches of a bridge", outlines.bridge(), KEY, inside=True
    )
    yield Entry("beyond-binary64", "A bin at 10^400", *at(10**400), inside=True)
    yield Entry("tiny", "A bin at 10^-30", *at(Fraction(1, 10**30)), inside=True)
    yield Entry("int64", "A bin of the full range of int64", FULL, box(2**63, 5), inside=True)


def at(scale: Any) -> tuple[Ring, Ring]:
    return scaled(box(3, 5), scale), scaled(box(3, 2), scale)


INVERSE: Ring = [(0, 0), (-2, 0), (0, -2)]
DIAMOND: Ring = [(0, 0), (2, -2), (4, 0), (2, 2)]
COLUMNS: Ring = [(0, 0), (8, 0), (8, 6), (6, 6), (6, 3), (2, 3), (2, 6), (0, 6)]
HOURGLASS: Ring = [
    (0, 0),
    (6, 0),
    (6, 5),
    (4, 5),
    (4, 6),
    (6, 6),
    (6, 11),
    (0, 11),
    (0, 6),
    (2, 6),
    (2, 5),
    (0, 5),
]
KEY: Ring = moved(scaled(outlines.arrow(), Fraction(1, 2)), 7, 7)
FULL: Ring = [(-(2**63), -9), (2**63 - 1, -9), (2**63 - 1, 9), (-(2**63), 9)]
