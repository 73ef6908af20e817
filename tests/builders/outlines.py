"""Outlines of parts, on integers; arcs run through integer points of circles.

All those in ALONG_X meet every vertical line in one piece, those in ALONG_Y every horizontal one.
"""

from builders.entry import Ring, columns

Chain = list[tuple[int, int]]

# A quarter of a circle around the origin, counter-clockwise from the x-axis on.
QUARTERS: dict[int, Chain] = {
    5: [(5, 0), (4, 3), (3, 4), (0, 5)],
    10: [(10, 0), (8, 6), (6, 8), (0, 10)],
    25: [(25, 0), (24, 7), (20, 15), (15, 20), (7, 24), (0, 25)],
}


def arc(x: int, y: int, radius: int, first: int, last: int) -> Chain:
    """Points around (x, y), counter-clockwise from one quarter turn to another."""
    points: Chain = []
    for quarter in range(first, last):
        turn = QUARTERS[radius]
        for _ in range(quarter % 4):
            turn = [(-b, a) for a, b in turn]
        points += turn[:-1] if quarter < last - 1 else turn
    return [(x + a, y + b) for a, b in points]


def clockwise(x: int, y: int, radius: int, first: int, last: int) -> Chain:
    return arc(x, y, radius, last, first)[::-1]


def ring(bottom: Chain, top: Chain) -> Ring:
    """A polygon from two chains, both from left to right."""
    return _once([*bottom, *reversed(top)])


def upright(right: Chain, left: Chain) -> Ring:
    """A polygon from its right and its left side, both from the bottom up."""
    return _once([*right, *reversed(left)])


def _once(points: Chain) -> Ring:
    """Without a vertex that is the same as the one before it."""
    return [point for k, point in enumerate(points) if point != points[k - 1]]


def rack() -> Ring:
    top = [(8 * k + x, y) for k in range(6) for x, y in ((0, 8), (2, 13), (4, 13), (6, 8))]
    return ring([(0, 0), (46, 0)], top)


def ratchet() -> Ring:
    return ring([(0, 0), (42, 0)], [(6 * k + x, y) for k in range(7) for x, y in ((0, 5), (6, 9))])


def sector() -> Ring:
    """Two teeth and two half teeth on the rim of a wheel."""
    right = [(60, 320), (80, 315), (96, 378), (150, 360), (165, 280), (195, 260)]
    left = [(-x, y) for x, y in reversed(right)]
    hub = [(-120, 160), (-56, 192), (0, 200), (56, 192), (120, 160)]
    return ring([left[0], *hub, right[-1]], [*left, *right])


def cam() -> Ring:
    nose = [(4, 43), (3, 44), (0, 45), (-3, 44), (-4, 43)]
    return [*arc(0, 0, 25, 2, 4), (24, 7), *nose, (-24, 7)]


def channel() -> Ring:
    bottom = [*arc(5, 5, 5, 2, 3), *arc(45, 5, 5, 3, 4)]
    inside = [*arc(9, 14, 5, 2, 3), *arc(41, 14, 5, 3, 4)]
    return ring(bottom, [(0, 30), (4, 30), *inside, (46, 30), (50, 30)])


def bracket() -> Ring:
    top = [(0, 45), (6, 45), *arc(11, 11, 5, 2, 3), (50, 6)]
    return ring([(0, 0), (50, 0)], top)


def tee() -> Ring:
    top = [(0, 6), *arc(12, 11, 5, 3, 4), (17, 36), (23, 36), *arc(28, 11, 5, 2, 3), (40, 6)]
    return ring([(0, 0), (40, 0)], top)


def letter_h() -> Ring:
    below = [(0, 0), (10, 0), *clockwise(20, 12, 10, 2, 0), (30, 0), (40, 0)]
    above = [(0, 50), (10, 50), *arc(20, 38, 10, 2, 4), (30, 50), (40, 50)]
    return ring(below, above)


def letter_w() -> Ring:
    below = [(0, 40), (10, 0), (14, 0), (22, 26), (30, 0), (34, 0), (44, 40)]
    above = [(0, 40), (6, 40), (12, 14), (20, 40), (24, 40), (32, 14), (38, 40), (44, 40)]
    return ring(below, above)


def letter_y() -> Ring:
    below = [(0, 50), (19, 22), (19, 0), (27, 0), (27, 22), (46, 50)]
    return ring(below, [(0, 50), (9, 50), (23, 30), (37, 50), (46, 50)])


def heat_sink() -> Ring:
    return ring([(0, 0), (44, 0)], columns([4] * 11, [24, 5] * 5 + [24]))


def shaft() -> Ring:
    """A turned shaft from the side: steps, a groove, a fillet, a collar, chamfered ends."""
    half: Chain = [
        *[(0, 3), (1, 4), (12, 4), (12, 6), (24, 6), (24, 5), (26, 5), (26, 6), (30, 6)],
        *[(33, 7), (34, 8), (35, 11), (40, 11), (42, 9), (42, 5), (60, 5), (61, 4)],
    ]
    return ring([(x, -y) for x, y in half], half)


def aerofoil() -> Ring:
    below: Chain = [(0, 0), (1, -4), (5, -8), (14, -11), (30, -12), (60, -8), (100, 0)]
    return ring(below, [(0, 0), (1, 6), (6, 13), (18, 19), (36, 20), (64, 13), (100, 0)])


def bridge() -> Ring:
    below: Chain = [(0, 0)]
    for x in 30, 84:
        below += [(x - 25, 0), *clockwise(x, 4, 25, 2, 0), (x + 25, 0)]
    return ring([*below, (114, 0)], [(0, 34), (28, 38), (57, 40), (86, 38), (114, 34)])


def key() -> Ring:
    """A round head, a shaft, and cuts of different depth."""
    top: Chain = [*clockwise(0, 0, 25, 2, 1), (15, 20)]
    x = 26
    for depth in 2, 5, 3, 7, 4:
        top += [(x, 10), (x + 3, 10 - depth), (x + 5, 10 - depth)]
        x += 8
    bottom: Chain = [*arc(0, 0, 25, 2, 3), (15, -20), (26, -8), (66, -8)]
    return ring(bottom, [*top, (66, 8), (72, 2)])


def roofing() -> Ring:
    """A corrugated sheet of thickness 2."""
    wave = [(0, 0), (3, 1), (6, 5), (9, 6), (12, 5), (15, 1), (18, 0)]
    below = [(18 * k + x, y) for k in range(3) for x, y in wave[: None if k == 2 else -1]]
    return ring(below, [(x, y + 2) for x, y in below])


def castle_nut() -> Ring:
    top = columns([6, 4, 8, 4, 8, 4, 6], [20, 14, 20, 14, 20, 14, 20])
    return ring([(0, 2), (2, 0), (38, 0), (40, 2)], top)


def bottle() -> Ring:
    half: Chain = [(0, 8), (2, 10), (40, 10), (48, 8), (54, 4), (70, 4), (70, 5), (74, 5)]
    return ring([(x, -y) for x, y in half], half)


def boomerang() -> Ring:
    below: Chain = [(0, 40), (8, 12), (25, 0), (42, 12), (50, 40)]
    return ring(below, [(0, 40), (14, 21), (25, 16), (36, 21), (50, 40)])


def arrow() -> Ring:
    below: Chain = [(0, -3), (30, -3), (30, -9), (50, 0)]
    return ring(below, [(0, 3), (30, 3), (30, 9), (50, 0)])


ALONG_X: dict[str, Ring] = {
    "rack": rack(),
    "ratchet": ratchet(),
    "sector": sector(),
    "cam": cam(),
    "channel": channel(),
    "bracket": bracket(),
    "tee": tee(),
    "letter-h": letter_h(),
    "letter-w": letter_w(),
    "letter-y": letter_y(),
    "heat-sink": heat_sink(),
    "shaft": shaft(),
    "aerofoil": aerofoil(),
    "bridge": bridge(),
    "key": key(),
    "roofing": roofing(),
    "castle-nut": castle_nut(),
    "bottle": bottle(),
    "boomerang": boomerang(),
    "arrow": arrow(),
}


ALONG_Y: dict[str, Ring] = {
    "letter-c": upright(
        [
            *[(24, 0), (24, 6)],
            *clockwise(11, 11, 5, 3, 2),
            *clockwise(11, 34, 5, 2, 1),
            *[(24, 39), (24, 45)],
        ],
        [*clockwise(5, 5, 5, 3, 2), *clockwise(5, 40, 5, 2, 1)],
    ),
    "letter-e": upright(
        [
            (24, 0),
            (24, 6),
            (6, 6),
            (6, 19),
            (20, 19),
            (20, 25),
            (6, 25),
            (6, 38),
            (24, 38),
            (24, 44),
        ],
        [(0, 0), (0, 44)],
    ),
    "letter-f": upright(
        [(6, 0), (6, 19), (20, 19), (20, 25), (6, 25), (6, 38), (24, 38), (24, 44)],
        [(0, 0), (0, 44)],
    ),
    "letter-z": upright(
        [(28, 0), (28, 6), (9, 6), (28, 38), (28, 44)], [(0, 0), (0, 6), (19, 38), (0, 38), (0, 44)]
    ),
    "letter-t": upright(
        [(16, 0), (16, 38), (28, 38), (28, 44)], [(10, 0), (10, 38), (-2, 38), (-2, 44)]
    ),
    "clamp": upright(
        [(40, 0), (40, 8), (30, 12), (10, 12), (10, 30), (30, 30), (34, 34), (34, 40)],
        [(4, 0), (0, 4), (0, 36), (4, 40)],
    ),
    "mushroom": upright(
        [(8, 0), (6, 4), (6, 20), *arc(5, 20, 25, 0, 1)],
        [(-8, 0), (-6, 4), (-6, 20), *clockwise(-5, 20, 25, 2, 1)],
    ),
    "hourglass": upright(
        [(20, 0), (4, 20), (4, 24), (20, 44)], [(-20, 0), (-4, 20), (-4, 24), (-20, 44)]
    ),
}
