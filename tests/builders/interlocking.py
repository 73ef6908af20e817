"""Shapes that hook into each other, and cannot be taken apart, or only one way."""

from collections.abc import Iterator

from builders.entry import Entry, in_places
from exactsweep import Region
from exactsweep.corpus.generator.cells import draw

TITLE = "Hooks, clamps, dovetails, keys in locks, links"

C = draw("####", "#   ", "#   ", "####")
C_BACK = draw("####", "   #", "   #", "####")
NARROW_C = draw("###", "#  ", "###")


def entries() -> Iterator[Entry]:
    for slug, title, d, g in [
        ("two-c", "Two letters C that hold each other", C, C_BACK),
        ("two-c-tight", "Two letters C without any room", NARROW_C, draw("###", "  #", "###")),
        ("c-itself", "A letter C around itself", C, C),
        ("hooks", "Two hooks", draw("###", "# #", "#  "), draw("  #", "# #", "###")),
        ("spirals", "Two short spirals that wind into each other", WOUND, WOUND_BACK),
        ("dovetail", "A dovetail in its slot", SLOT, DOVETAIL),
        ("dovetail-loose", "A dovetail in a slot with room", LOOSE, DOVETAIL),
        ("t-slot", "A tee in a tee slot", T_SLOT, draw("###", " # ", " # ")),
        ("t-slot-loose", "A tee in a larger tee slot", T_ROOM, draw("###", " # ", " # ")),
        ("key", "A key in its lock", LOCK, draw("#   ", "####", "# # ")),
        ("e-and-comb", "A letter E and a comb", draw("###", "#", "###", "#", "###"), COMB),
        ("s-and-z", "A letter S and a letter Z", draw("###", "#  ", "###", "  #", "###"), Z),
        ("link", "A link around the middle of an eight", EIGHT, draw("###", "# #", "###")),
        ("clamp", "A clamp that grips exactly", draw("####", "#  #", "#   "), draw("##", "##")),
        ("ratchet", "Teeth that slide one way", TEETH, PAWL),
    ]:
        yield from in_places(slug, title, d, g)


WOUND = draw("#####", "#   #", "# # #", "# ###", "#    ")
WOUND_BACK = draw("    #", "### #", "# # #", "#   #", "#####")
SLOT = Region([(0, 0), (3, 0), (2, 3), (7, 3), (6, 0), (9, 0), (9, 5), (0, 5)])
LOOSE = Region([(0, 0), (3, 0), (1, 4), (8, 4), (6, 0), (9, 0), (9, 6), (0, 6)])
DOVETAIL = Region([(0, 0), (3, 0), (4, 3), (-1, 3)])
T_SLOT = draw("#####", "#   #", "## ##", "## ##")
T_ROOM = draw("#######", "#     #", "#     #", "### ###", "### ###")
LOCK = draw("#######", "# ## ##", "#    ##", "# # ###", "#######")
COMB = draw("#", "###", "#", "###", "#")
Z = draw("###", "  #", "###", "#  ", "###")
EIGHT = draw("###", "# #", "###", "# #", "###")
TEETH = Region([(0, 0), (2, 2), (2, 0), (4, 2), (4, 0), (6, 2), (6, 0), (8, 2), (8, -1), (0, -1)])
PAWL = Region([(0, 2), (0, 0), (2, 2), (2, 0), (4, 2), (4, 3), (0, 3)])
