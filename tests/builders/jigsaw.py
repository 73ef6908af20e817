"""Shapes cut in two: the parts fit each other along segments, or in single positions."""

from collections.abc import Iterator

from builders.entry import Entry, in_places
from exactsweep import Region
from exactsweep.corpus.generator.cells import build_block, connect, draw, trace_outline

TITLE = "Jigsaws: parts that fit along segments and in single positions"


def entries() -> Iterator[Entry]:
    for slug, title, d, g in [
        ("tab", "A tab and its blank", draw("#####", "## ##", "## ##"), draw(" # ", " # ", "###")),
        ("knob", "A knob with a neck, in one position", KNOB_BLANK, KNOB),
        ("knob-loose", "A knob with a neck and some room", LOOSE_BLANK, KNOB),
        ("two-knobs", "Two knobs at once", TWO_BLANKS, TWO_KNOBS),
        ("two-knobs-apart", "Two knobs that do not match", TWO_BLANKS, draw("#  #", "####")),
        ("mould", "A part and the mould around it", mould(S), trace_outline(S)),
        ("mould-open", "A mould open to one side", mould(S, left=0), trace_outline(S)),
        ("mould-of-c", "A mould of a letter C", mould(C), trace_outline(C)),
        (
            "mould-with-hole",
            "A mould of a ring: the core is lost",
            mould(RING),
            trace_outline(RING),
        ),
        ("stairs", "Stairs on stairs", draw("#   ", "##  ", "### ", "####"), STAIRS),
        ("diagonal", "Parts of a square cut along a stair", draw("###", "##", "#"), LOWER),
        ("puzzle-corner", "A corner piece", CORNER, draw("##", "## ", "#")),
        ("triangles", "A triangle cut out of a triangle", CUT, SMALL),
        ("arrow", "An arrow in its notch", NOTCH, ARROW),
        ("cross", "A cross in a cross", mould(CROSS), trace_outline(CROSS)),
    ]:
        yield from in_places(slug, title, d, g)


def mould(cells: set[tuple[int, int]], left: int = 1) -> Region:
    """A block around some squares, with those cut out."""
    xs, ys = zip(*cells, strict=True)
    width, height = max(xs) - min(xs) + 2 + left, max(ys) - min(ys) + 3
    around = build_block(width, height, min(xs) - left, min(ys) - 1)
    return trace_outline(connect(around - cells))


def cells(*rows: str) -> set[tuple[int, int]]:
    return {(x, -y) for y, row in enumerate(rows) for x, c in enumerate(row) if c == "#"}


S = cells(" ##", "## ", "#  ")
C = cells("###", "#  ", "###")
RING = cells("###", "# #", "###")
CROSS = cells(" # ", "###", " # ")
KNOB = draw("###", " # ", "###", "###")
KNOB_BLANK = draw("#####", "#   #", "## ##", "## ##")
LOOSE_BLANK = draw("#######", "#     #", "#     #", "### ###", "### ###")
TWO_BLANKS = draw("#######", "## # ##", "## # ##")
TWO_KNOBS = draw("# #", "# #", "###")
STAIRS = draw("####", " ###", "  ##", "   #")
LOWER = draw("  #", " ##", "###")
CORNER = draw("####", "## #", "#  #", "# ##")
CUT = Region([(0, 0), (8, 0), (8, 8)], [[(5, 1), (7, 1), (7, 3)]])
SMALL = Region([(0, 0), (2, 0), (2, 2)])
NOTCH = Region(
    [(0, 0), (2, 0), (2, 2), (1, 2), (3, 4), (5, 2), (4, 2), (4, 0), (6, 0), (6, 6), (0, 6)]
)
ARROW = Region([(-1, 0), (1, 0), (1, 2), (2, 2), (0, 4), (-2, 2), (-1, 2)])
