"""Shapes that touch in several places at once: two teeth, slots, walls, slanted edges, stairs."""

FORK = [(0, 0), (3, 0), (3, 2), (2, 2), (2, 1), (1, 1), (1, 2), (0, 2)]
TABLE = [(0, 3), (0, 0), (1, 0), (1, 1), (2, 1), (2, 0), (4, 0), (4, 1), (5, 1), (5, 0), (6, 0)]
TABLE += [(6, 3)]
ROOF = [(0, 0), (2, 3), (4, 0), (5, 2), (6, 0), (6, 4), (3, 6), (0, 4)]
# Along these, walls are touched in turn.
STAIRS = [(0, 2), (0, 0), (1, 0), (1, -1), (2, -1), (2, -3), (3, -3), (3, 2)]
STEPS = [(0, -5), (3, -5), (3, -3), (2, -3), (2, -1), (1, -1), (1, 0), (0, 0)]
