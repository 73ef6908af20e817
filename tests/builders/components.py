"""Answers of several components: rooms that have nothing to do with each other."""

from collections.abc import Iterator

from builders.entry import Entry, Ring, box, in_places
from exactsweep import Region
from exactsweep.corpus.generator.cells import draw

TITLE = "Answers of several components: rooms, fits, parts that are left out"


def entries() -> Iterator[Entry]:
    for slug, title, d, g in [
        ("two-rooms", "Two equal rooms", draw("#######", "#  #  #", "#  #  #", "#######"), DOT),
        ("three-rooms", "Rooms of three sizes", SIZES, DOT),
        ("room-and-fit", "A room, a segment and a single position", SIZES, draw("##", "##")),
        ("rooms-of-the-part", "Four holes of the part's shape", FOUR, draw("#", "##")),
        ("touching-rooms", "Rooms of positions that touch in a point", DIAGONAL, draw("##", "##")),
        ("crossing-fits", "Fits that cross each other", CROSS, DOT),
        ("fit-between-rooms", "A fit that joins two rooms", JOINED, DOT),
        ("fit-from-outside", "A fit that joins a room and the outside", OPEN, DOT),
        ("unswept", "A triangle passes by the middle of a cave", CAVE, SPIKE),
        ("unswept-two", "It passes by the middle of two caves", TWO_CAVES, SPIKE),
        ("inner-rooms", "Rooms of a container, with waists between them", WAISTS, BRICK),
        ("inner-fits", "The waists are as high as the part", WAISTS, draw("#", "#")),
        ("islands", "Islands in one room", ISLANDS, DOT),
        ("islands-large", "Positions around each island only", ISLANDS, draw("##", "##")),
    ]:
        yield from in_places(slug, title, d, g)


DOT = draw("#")
BRICK = draw("#", "#", "#")
SIZES = draw("############", "#   ##  ## #", "#   ##  ####", "#   ########", "############")
FOUR = draw("#######", "# ## ##", "#  #  #", "#######", "# ## ##", "#  #  #", "#######")
DIAGONAL = draw("########", "#   ####", "#   ####", "#     ##", "###   ##", "###   ##", "########")
CROSS = draw("#######", "### ###", "### ###", "#     #", "### ###", "### ###", "#######")
JOINED = draw("#########", "#  ###  #", "#       #", "#  ###  #", "#########")
OPEN = draw("#######", "#  ####", "#      ", "#  ####", "#######")
_HALL: Ring = [(0, 0), (20, 0), (20, 20), (0, 20)]
CAVE = Region(
    [*_HALL[:3], (13, 20), (13, 16), (18, 16), (18, 2), (2, 2), (2, 16), (7, 16), (7, 20), (0, 20)]
)
TWO_CAVES = Region(
    [
        *[(0, 0), (40, 0), (40, 20), (33, 20), (33, 16), (38, 16), (38, 2), (22, 2), (22, 16)],
        *[(27, 16), (27, 20), (13, 20), (13, 16), (18, 16), (18, 2), (2, 2), (2, 16), (7, 16)],
        *[(7, 20), (0, 20)],
    ]
)
SPIKE = Region([(0, 0), (3, 0), (1, 3)])
WAISTS = Region(
    [
        *[(0, 0), (4, 0), (4, 1), (6, 1), (6, 0), (10, 0), (10, 1), (12, 1), (12, 0), (16, 0)],
        *[(16, 4), (12, 4), (12, 3), (10, 3), (10, 4), (6, 4), (6, 3), (4, 3), (4, 4), (0, 4)],
    ]
)
ISLANDS = Region(box(11, 8), [box(1, 1, 2, 2), box(1, 1, 2, 5), box(2, 1, 6, 3)])
