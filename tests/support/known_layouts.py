"""Layouts of kinds that the corpus lacks, with known verdicts."""

from fractions import Fraction

from layouts import box, lay, put

from exactsweep.layout import Layout

TILE = box(0, 0, 1, 1)
SHEET = box(0, 0, 10, 10)
# A ring of width 1 around a 2 by 2 hole.
RING = {"exterior": box(0, 0, 4, 4), "holes": [box(1, 1, 3, 3)]}
TRIANGLE = [(0, 0), (4, 0), (0, 3)]


TINY = Fraction(1, 10**30)

VALID = {
    "triangles that fill it, mirrored and then turned": lay(
        box(0, 0, 4, 3),
        {"t": TRIANGLE, "u": [(0, 0), (3, 0), (0, 4)]},
        put("t"),
        # (x, y) -> (-x, y) -> (-y, -x): corners (0, 0), (0, -3), (-4, 0), moved by (4, 3).
        put("u", (4, 3), 90, mirrored=True),
    ),
    "a part in the hole of a part in a hole": lay(
        box(0, 0, 12, 12),
        {
            "outer": {"exterior": box(0, 0, 12, 12), "holes": [box(4, 4, 8, 8)]},
            "r": RING,
            "t": TILE,
        },
        put("outer"),
        put("r", (4, 4)),
        put("t", (5, 5)),
    ),
    "spacing met in a hole": lay(
        SHEET, {"r": RING, "t": TILE}, put("r"), put("t", ("1.5", "1.5")), spacing="1/2"
    ),
    "a part around a defect that fills its hole": lay(
        SHEET, {"r": RING}, put("r"), defects=[box(1, 1, 3, 3)]
    ),
    "no placements": lay(SHEET, {"t": TILE}),
}


FAULTY: dict[str, tuple[Layout, list[tuple[str, tuple[int, ...]]]]] = {
    "around the container": (
        lay(SHEET, {"big": box(-1, -1, 11, 11)}, put("big")),
        [("outside", (0,))],
    ),
    "a frame around the container": (
        lay(SHEET, {"f": {"exterior": box(-1, -1, 11, 11), "holes": [SHEET]}}, put("f")),
        [("outside", (0,))],
    ),
    "contact despite a required spacing": (
        lay(SHEET, {"t": TILE}, put("t"), put("t", (1, 0)), spacing=TINY),
        [("too close", (0, 1))],
    ),
    "too close in a hole": (
        lay(SHEET, {"r": RING, "t": TILE}, put("r"), put("t", ("1.5", "1.4")), spacing="1/2"),
        [("too close", (0, 1))],
    ),
    "an overlap is not also too close": (
        lay(SHEET, {"t": TILE}, put("t"), put("t", ("1/2", 0)), spacing=1),
        [("overlap", (0, 1))],
    ),
    "mirrored onto the other one": (
        lay(box(0, 0, 4, 3), {"t": TRIANGLE}, put("t"), put("t", (4, 3), 90, mirrored=True)),
        [("overlap", (0, 1)), ("outside", (1,))],
    ),
    "demand": (
        lay(
            SHEET,
            {
                "few": {"exterior": TILE, "demand": 3},
                "many": {"exterior": TILE, "demand": 1},
                "none": {"exterior": TILE, "demand": 0},
            },
            put("few"),
            put("many", (2, 0)),
            put("many", (4, 0), 90),
        ),
        [("missing", (0,)), ("surplus", (1, 2))],
    ),
    "turns and mirroring": (
        lay(
            SHEET,
            {"t": {"exterior": TILE, "turns": [0, 180], "mirrored": False}},
            put("t", (1, 1), 180),
            put("t", (3, 1), 90),
            put("t", (5, 1), ["3/5", "4/5"]),
            put("t", (8, 1), mirrored=True),
        ),
        [("turn", (1,)), ("turn", (2,)), ("mirror", (3,))],
    ),
}
