"""Layouts whose verdicts are worked out by hand: right ones that look wrong, and wrong ones."""

from fractions import Fraction

from layouts import box, lay, put

from exactsweep.layout import Layout

TILE = box(0, 0, 1, 1)
SHEET = box(0, 0, 10, 10)
# A ring one wide around a room of 2 by 2.
RING = {"exterior": box(0, 0, 4, 4), "holes": [box(1, 1, 3, 3)]}
TRIANGLE = [(0, 0), (4, 0), (0, 3)]


TINY = Fraction(1, 10**30)

VALID = {
    "tiles that fill the container": lay(
        box(0, 0, 2, 2), {"t": TILE}, *(put("t", (x, y)) for x in (0, 1) for y in (0, 1))
    ),
    "triangles that fill it, one of them turned": lay(
        box(0, 0, 4, 3), {"t": TRIANGLE}, put("t"), put("t", (4, 3), 180)
    ),
    "triangles that fill it, mirrored and then turned": lay(
        box(0, 0, 4, 3),
        {"t": TRIANGLE, "u": [(0, 0), (3, 0), (0, 4)]},
        put("t"),
        # (x, y) -> (-x, y) -> (-y, -x): corners (0, 0), (0, -3), (-4, 0), moved by (4, 3).
        put("u", (4, 3), 90, mirrored=True),
    ),
    "a part that fills the hole of another": lay(
        SHEET, {"r": RING, "t": box(0, 0, 2, 2)}, put("r"), put("t", (1, 1))
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
    "spacing met to the last digit": lay(
        SHEET, {"t": TILE}, put("t"), put("t", ("1.000001", 0)), spacing="0.000001"
    ),
    "spacing met at a corner, 3-4-5": lay(
        SHEET, {"t": TILE}, put("t"), put("t", (4, 5)), spacing=5
    ),
    "spacing met in a hole": lay(
        SHEET, {"r": RING, "t": TILE}, put("r"), put("t", ("1.5", "1.5")), spacing="1/2"
    ),
    "margin met exactly": lay(box(0, 0, 2, 2), {"t": TILE}, put("t", ("1/2", "1/2")), margin="1/2"),
    "margin met at a defect": lay(
        SHEET, {"t": TILE}, put("t", (3, 3)), defects=[box(6, 3, 7, 4)], margin=2
    ),
    "a gap of 1e-30": lay(SHEET, {"t": TILE}, put("t"), put("t", (1 + TINY, 0))),
    "two in contact at a corner": lay(SHEET, {"t": TILE}, put("t"), put("t", (1, 1))),
    "a part around a defect that fills its hole": lay(
        SHEET, {"r": RING}, put("r"), defects=[box(1, 1, 3, 3)]
    ),
    "turned by 3-4-5 onto the border": lay(
        box(-4, 0, 3, 7), {"s": box(0, 0, 5, 5)}, put("s", (0, 0), ["3/5", "4/5"])
    ),
    "no placements": lay(SHEET, {"t": TILE}),
    "demand met by turned and mirrored ones": lay(
        SHEET,
        {"t": {"exterior": TILE, "demand": 2, "turns": [0, 90], "mirrored": True}},
        put("t"),
        put("t", (5, 5), 450, mirrored=True),
    ),
}


FAULTY: dict[str, tuple[Layout, list[tuple[str, tuple[int, ...]]]]] = {
    "the same part twice": (
        lay(SHEET, {"t": TILE}, put("t", (3, 3)), put("t", (3, 3))),
        [("overlap", (0, 1))],
    ),
    "an overlap 1e-30 deep": (
        lay(SHEET, {"t": TILE}, put("t"), put("t", (1 - TINY, 0))),
        [("overlap", (0, 1))],
    ),
    "a part inside another, which has a hole elsewhere": (
        lay(
            SHEET,
            {"r": {"exterior": box(0, 0, 6, 4), "holes": [box(3, 1, 5, 3)]}, "t": TILE},
            put("r"),
            put("t", (1, 1)),
        ),
        [("overlap", (0, 1))],
    ),
    "a part around a part in its own outline": (
        lay(SHEET, {"big": box(0, 0, 4, 4), "t": box(1, 1, 3, 3)}, put("big"), put("t")),
        [("overlap", (0, 1))],
    ),
    "a part larger than the hole": (
        lay(SHEET, {"r": RING, "t": box(0, 0, 2, "2.001")}, put("r"), put("t", (1, 1))),
        [("overlap", (0, 1))],
    ),
    "crosses without a vertex inside": (
        lay(SHEET, {"a": box(0, 2, 6, 3), "b": box(2, 0, 3, 6)}, put("a"), put("b")),
        [("overlap", (0, 1))],
    ),
    "through a vertex on the border": (
        lay(SHEET, {"d": [(0, 0), (2, 2), (0, 4), (-2, 2)]}, put("d", (1, 3))),
        [("outside", (0,))],
    ),
    "outside by 1e-30": (lay(SHEET, {"t": TILE}, put("t", (9 + TINY, 0))), [("outside", (0,))]),
    "a bar across a container with two arms": (
        lay(
            [(0, 0), (9, 0), (9, 9), (6, 9), (6, 3), (3, 3), (3, 9), (0, 9)],
            {"bar": box(0, 0, 7, 1)},
            put("bar", (1, 6)),
        ),
        [("outside", (0,))],
    ),
    "wholly outside": (lay(SHEET, {"t": TILE}, put("t", (50, 50))), [("outside", (0,))]),
    "around the container": (
        lay(SHEET, {"big": box(-1, -1, 11, 11)}, put("big")),
        [("outside", (0,))],
    ),
    "a frame around the container": (
        lay(SHEET, {"f": {"exterior": box(-1, -1, 11, 11), "holes": [SHEET]}}, put("f")),
        [("outside", (0,))],
    ),
    "on a defect": (
        lay(SHEET, {"t": TILE}, put("t", (3, 3)), defects=[box(3, 3, 4, 4)]),
        [("outside", (0,))],
    ),
    "around a defect": (
        lay(SHEET, {"t": box(0, 0, 5, 5)}, put("t", (1, 1)), defects=[box(3, 3, 4, 4)]),
        [("outside", (0,))],
    ),
    "inside a defect": (
        lay(SHEET, {"t": TILE}, put("t", (3, 3)), defects=[box(1, 1, 6, 6)]),
        [("outside", (0,))],
    ),
    "spacing missed in the last digit": (
        lay(SHEET, {"t": TILE}, put("t"), put("t", ("1.000001", 0)), spacing="0.0000010001"),
        [("too close", (0, 1))],
    ),
    "spacing missed at a corner": (
        lay(SHEET, {"t": TILE}, put("t"), put("t", (4, 5)), spacing="5.0001"),
        [("too close", (0, 1))],
    ),
    "contact where a spacing is asked for": (
        lay(SHEET, {"t": TILE}, put("t"), put("t", (1, 0)), spacing=TINY),
        [("too close", (0, 1))],
    ),
    "too close in a hole": (
        lay(SHEET, {"r": RING, "t": TILE}, put("r"), put("t", ("1.5", "1.4")), spacing="1/2"),
        [("too close", (0, 1))],
    ),
    "an overlap is not too close as well": (
        lay(SHEET, {"t": TILE}, put("t"), put("t", ("1/2", 0)), spacing=1),
        [("overlap", (0, 1))],
    ),
    "margin missed at the border": (
        lay(SHEET, {"t": TILE}, put("t", (8, 4)), margin="1.001"),
        [("too close", (0,))],
    ),
    "margin missed at a defect": (
        lay(SHEET, {"t": TILE}, put("t", (3, 3)), defects=[box(6, 3, 7, 4)], margin="2.0001"),
        [("too close", (0,))],
    ),
    "the spacing is not the margin": (
        lay(SHEET, {"t": TILE}, put("t"), put("t", (3, 0)), spacing=1, margin=TINY),
        [("too close", (0,)), ("too close", (1,))],
    ),
    "turned the wrong way": (
        lay(box(0, 0, 4, 3), {"t": TRIANGLE}, put("t"), put("t", (4, 3), 90)),
        [("outside", (1,))],
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
    "a part that crosses itself": (
        lay(
            SHEET,
            {"bow": [(0, 0), (1, 1), (1, 0), (0, 1)], "t": TILE},
            put("bow"),
            put("t"),
            put("bow", (90, 90)),
        ),
        [("shape", (0, 2))],
    ),
}
