"""Outlines of parts such as are nested in sheets: 20 to 150 vertices, in thousandths of a unit.

Each is monotone to the X axis. `part_pairs` turns every other pair.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, pi, sin, sqrt

from exactsweep.corpus.generator.shapes import Ring

Outline = Ring
Corner = tuple[float, float]


def _ring(bottom: Sequence[Corner], top: Sequence[Corner]) -> Outline:
    """A polygon from two chains, both from left to right; points closer than 1/1000 are one."""
    rounded = [(round(1000 * x), round(1000 * y)) for x, y in [*bottom, *reversed(top)]]
    return [point for k, point in enumerate(rounded) if point != rounded[k - 1]]


def _arc(x: float, y: float, radius: float, first: float, last: float, steps: int) -> list[Corner]:
    """Points on a circle, from one angle to another, in degrees."""
    angles = [pi / 180 * (first + (last - first) * k / steps) for k in range(steps + 1)]
    return [(x + radius * cos(a), y + radius * sin(a)) for a in angles]


def rack(teeth: int = 18) -> Outline:
    """A gear rack: trapezoidal teeth on a bar."""
    top = [
        (4 * k + x, y) for k in range(teeth) for x, y in ((0, 6), (0.9, 8.2), (2.2, 8.2), (3.1, 6))
    ]
    return _ring([(0, 0), (4 * teeth - 0.9, 0)], top)


def sector(teeth: int = 7) -> Outline:
    """A sector of a large gear; the flanks of its teeth stay monotone."""
    profile = ((-0.5, 60.0), (-0.22, 63.4), (0.18, 63.4), (0.46, 60.0))
    top = [
        (radius * sin(a), radius * cos(a) - 40)
        for k in range(teeth)
        for at, radius in profile
        for a in [pi / 180 * 7 * (k - (teeth - 1) / 2 + at)]
    ]
    return _ring([(x, y - 40) for x, y in _arc(0, 0, 34, 115, 65, 12)], top)


def cam() -> Outline:
    """A disc cam: two arcs and their tangents, convex."""
    nose = _arc(0, 20, 4, 155, 25, 10)
    return _ring(
        _arc(0, 0, 12, 180, 360, 24),
        [*_arc(0, 0, 12, 180, 157.5, 3), *nose, *_arc(0, 0, 12, 22.5, 0, 3)],
    )


def channel() -> Outline:
    """A U channel with round inner corners."""
    inner = [*_arc(8, 8, 5, 180, 270, 10), *_arc(32, 8, 5, 270, 360, 10)]
    return _ring(
        [*_arc(5, 5, 5, 180, 270, 8), *_arc(35, 5, 5, 270, 360, 8)],
        [(0, 30), (3, 30), *inner, (37, 30), (40, 30)],
    )


def bracket() -> Outline:
    """An L bracket with a fillet and rounded ends."""
    return _ring(
        [(0, 0), *_arc(48, 3, 3, 270, 360, 6)],
        [
            *_arc(3, 37, 3, 180, 0, 12),
            *_arc(14, 14, 8, 180, 270, 10),
            (48, 6),
            *_arc(48, 3, 3, 90, 0, 6),
        ],
    )


def letter_h() -> Outline:
    """An H whose two slots have round ends."""
    below = [(0, 0), (7, 0), *_arc(13, 10, 6, 180, 0, 12), (19, 0), (26, 0)]
    above = [(0, 40), (7, 40), *_arc(13, 30, 6, 180, 360, 12), (19, 40), (26, 40)]
    return _ring(below, above)


def letter_w() -> Outline:
    """A W with slightly rounded feet."""
    below = [
        (0, 40),
        *_arc(10, 1.5, 1.5, 195, 345, 5),
        (20, 26),
        *_arc(30, 1.5, 1.5, 195, 345, 5),
        (40, 40),
    ]
    above = [(0, 40), (6, 40), (10.5, 14), (17.5, 38), (22.5, 38), (29.5, 14), (34, 40), (40, 40)]
    return _ring(below, above)


def heat_sink(fins: int = 12) -> Outline:
    """Fins with vertical walls on a plate."""
    top = [(4 * k + x, y) for k in range(fins) for x, y in ((0, 5), (0, 22), (1.4, 22), (1.4, 5))]
    return _ring([(0, 0), (4 * fins - 2.6, 0)], top)


def shaft() -> Outline:
    """The silhouette of a turned shaft: steps, a fillet and a groove, the same on both sides."""
    half = [
        (0, 3),
        (1, 4),
        (12, 4),
        (12, 6),
        (26, 6),
        (26, 5.2),
        (28, 5.2),
        (28, 6),
        (30, 6),
        *_arc(30, 10, 4, 270, 360, 8)[1:],
        (44, 10),
        (46, 9),
        (46, 5),
        (70, 5),
        (71, 4),
        (71, 3.5),
        (90, 3.5),
        (91, 2.5),
    ]
    return _ring([(x, -y) for x, y in half], half)


def aerofoil(count: int = 40) -> Outline:
    """A cambered wing section."""
    xs = [0.5 * (1 - cos(pi * k / count)) for k in range(count + 1)]
    thick = [
        0.6 * (0.2969 * sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)
        for x in xs
    ]
    camber = [0.24 * x * (1 - x) for x in xs]
    bottom = [(80 * x, 80 * (c - t)) for x, c, t in zip(xs, camber, thick, strict=True)]
    top = [(80 * x, 80 * (c + t)) for x, c, t in zip(xs, camber, thick, strict=True)]
    return _ring(bottom, top)


def ratchet(teeth: int = 30) -> Outline:
    """A straight ratchet bar: saw teeth with one vertical flank."""
    top = [(2 * k + x, y) for k in range(teeth) for x, y in ((0, 5), (2, 6.5))]
    return _ring([(0, 0), (2 * teeth, 0)], top)


def arch() -> Outline:
    """A bridge with three round arches and a curved deck."""
    below: list[Corner] = [(0, 0), (3, 0)]
    for k in range(3):
        below += [*_arc(13 + 23 * k, 4, 10, 180, 0, 16), (23 + 23 * k, 0), (26 + 23 * k, 0)]
    return _ring(below, _arc(36, -180, 200, 100.4, 79.6, 16))


def wave(count: int = 60) -> Outline:
    """A corrugated strip."""
    xs = [k * 90 / count for k in range(count + 1)]
    bottom = [(x, 4 * sin(x * pi / 15)) for x in xs]
    return _ring(bottom, [(x, y + 3) for x, y in bottom])


def key() -> Outline:
    """A key: a round head and cuts of different depth."""
    cuts = [3, 5, 2, 4, 6, 3, 5]
    top = [*_arc(0, 0, 11, 180, 35, 16)]
    for k, depth in enumerate(cuts):
        top += [(14 + 5 * k, 6), (16 + 5 * k, 6 - depth), (17.5 + 5 * k, 6 - depth)]
    return _ring([*_arc(0, 0, 11, 180, 325, 16), (49, -6.3), (52, -3)], [*top, (50, 5), (52, 2)])


OUTLINES = {
    outline.__name__: outline()
    for outline in (
        rack,
        sector,
        cam,
        channel,
        bracket,
        letter_h,
        letter_w,
        heat_sink,
        shaft,
        aerofoil,
        ratchet,
        arch,
        wave,
        key,
    )
}


def part_pairs() -> Iterator[tuple[Outline, Outline]]:
    """All pairs (generatrix, directrix) of different outlines."""
    outlines = list(OUTLINES.values())
    for i, generatrix in enumerate(outlines):
        for j, directrix in enumerate(outlines):
            if i == j:
                continue
            # The shared direction of a turned pair has to be found.
            if (i + j) % 2:
                yield _turned(generatrix), _turned(directrix)
            else:
                yield generatrix, directrix


def _turned(outline: Outline) -> Outline:
    """Turned by the angle of a 3-4-5 triangle, on integers."""
    return [(4 * x - 3 * y, 3 * x + 4 * y) for x, y in outline]
