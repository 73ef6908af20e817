"""Caves: rooms inside D with a way in, with one that fits exactly, and with none."""

from collections.abc import Iterator
from typing import Any

from builders.entry import UNIT, Entry, Ring, box, in_places
from exactsweep.corpus.generator.cells import draw

TITLE = "Caves with a way in, with one that fits exactly, and with none"

SQUARE, WIDE, TALL, LARGE = draw("#"), draw("##"), draw("#", "#"), draw("##", "##")
ROOM = draw("######", "#    #", "#    #", "#    #", "## ###")
WIDE_DOOR = draw("######", "#    #", "#    #", "#    #", "#  ###")
NEAR = 10**15


def entries() -> Iterator[Entry]:
    yield from in_places("open", "A cave with a door that is wide enough", WIDE_DOOR, SQUARE)
    yield from in_places("exact-door", "A cave with a door exactly as wide", ROOM, SQUARE)
    yield from in_places("no-door", "A cave with a door that is too narrow", ROOM, WIDE)
    yield from in_places("as-wide", "A cave as high as the part, its door too narrow", ROOM, HIGH)
    yield from in_places("one-position", "A cave of the shape of the part", ROOM, WHOLE)
    yield from in_places("turn", "A part that gets in only if it could turn", TURN, draw("###"))
    yield from in_places("two-rooms", "Two rooms and a passage as wide as the part", TWO, SQUARE)
    yield from in_places("two-closed", "Two rooms, neither of which can be left", TWO, LARGE)
    yield from in_places("pillar", "A room with a pillar", PILLAR, SQUARE)
    yield from in_places("pillar-large", "A pillar that leaves exactly the width", PILLAR, LARGE)
    yield from in_places("dogleg", "A way in with two bends", DOGLEG, SQUARE)
    yield from in_places("dogleg-long", "A bend that the part cannot take", DOGLEG, WIDE)
    yield from in_places("pocket", "An anteroom before the room", ANTEROOM, LARGE)
    yield from in_places("hook-in-cave", "A hook whose tip only gets in", ROOM, HOOK)
    for slug, title, width in [
        ("near-closed", "A door too narrow by one part in 10^15", NEAR - 1),
        ("near-exact", "A door of 10^15 that fits", NEAR),
        ("near-open", "A door wider by one part in 10^15", NEAR + 1),
    ]:
        yield Entry(slug, title, cave(NEAR, width), box(NEAR, NEAR))
    yield Entry("beyond-binary64", "A cave at 10^400", cave(10**400, 10**400), box(10**400, 1))
    yield Entry("slanted-door", "A door with slanted jambs", JAMBS, UNIT)
    yield Entry("wedge", "A room that narrows to a point", WEDGE, UNIT)


def cave(unit: Any, door: Any) -> Ring:
    """A room three units wide and high, with a door of this width in the middle of its floor."""
    left, right = 2 * unit, 2 * unit + door
    inside = [(left, 0), (left, unit), (unit, unit), (unit, 4 * unit), (4 * unit, 4 * unit)]
    inside += [(4 * unit, unit), (right, unit), (right, 0)]
    return [(0, 0), *inside, (5 * unit, 0), (5 * unit, 5 * unit), (0, 5 * unit)]


HIGH = draw("##", "##", "##")
WHOLE = draw("####", "####", "####")
TURN = draw("#####", "#   #", "#   #", "#   #", "## ##")
TWO = draw("##########", "#   ##   #", "#        #", "#   ##   #", "##########")
PILLAR = draw("#######", "#  #  #", "#  #  #", "#  #  #", "#     #", "#     #", "### ###")
DOGLEG = draw("#######", "#     #", "#     #", "#### ##", "#    ##", "# #####", "# #####")
ANTEROOM = draw("########", "#      #", "#      #", "#      #", "### ####", "##    ##", "##    ##")
HOOK = draw("###", "  #", "  #")
JAMBS: Ring = [
    *[(0, 0), (2, 0), (3, 1), (1, 1), (1, 4), (6, 4), (6, 1), (4, 1), (5, 0)],
    *[(7, 0), (7, 5), (0, 5)],
]
WEDGE: Ring = [
    (0, 0),
    (3, 0),
    (3, 1),
    (1, 1),
    (4, 7),
    (7, 1),
    (4, 1),
    (4, 0),
    (8, 0),
    (8, 9),
    (0, 9),
]
