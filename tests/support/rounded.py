"""Random discs, slots and rounded rectangles near contact, in SVG, with verdicts.

Each is a point, a segment or a rectangle with a radius. Two of them overlap if their distance is
less than the sum of the radii, as decided in rational arithmetic.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import cos, isqrt, sin, tau
from random import Random

from exactsweep.cli.judging import judge_finely
from exactsweep.formats.decimals import format_decimal
from exactsweep.formats.layouts import parse_layouts
from exactsweep.numbers.number import Point

_DIRECTIONS = [(3, 4), (4, -3), (-3, 4), (7, 24), (1, 0), (0, 1)]
_TOLERANCES = [None, "1/2", "1/10", "1/100", "1/1000"]
_PLACES = 12


@dataclass
class RoundedPair:
    """Two shapes on a sheet, and the verdict on them."""

    text: str
    tolerance: str | None
    overlap: bool
    verdict: str = ""


def draw_rounded(rng: Random) -> RoundedPair:
    """Draw two shapes that touch, nearly touch or barely overlap."""
    (one, r), (other, s) = _draw_core(rng), _draw_core(rng)
    angle = rng.random() * tau
    way = Point(
        Fraction(round(cos(angle) * 10**6), 10**6), Fraction(round(sin(angle) * 10**6), 10**6)
    )
    low, high = Fraction(0), Fraction(90)
    for _ in range(50):
        middle = (low + high) / 2
        if measure(one, _move(other, way, middle)) < (r + s) ** 2:
            low = middle
        else:
            high = middle
    off = rng.choice([-1, 1]) * Fraction(rng.randint(1, 9), 10 ** rng.randint(1, 9))
    by = Point(*(_round((high + off) * part) for part in way))
    moved = _move(other, by, Fraction(1))
    sheet = '<rect x="-200" y="-200" width="400" height="400"/>'
    text = f"<svg>{sheet}{_write(one, r)}{_write(moved, s)}</svg>"
    overlap = measure(one, moved) < (r + s) ** 2
    return RoundedPair(text, rng.choice(_TOLERANCES), overlap)


def compare_rounded(pair: RoundedPair, rng: Random, deep: bool) -> str:
    """Judge a pair; describe a false verdict, "" if none."""
    (found,) = parse_layouts(pair.text, tolerance=pair.tolerance)
    faults = judge_finely(found, {}, "the pair").faults
    pair.verdict = faults[0].kind if faults else "valid"
    expected = "overlap" if pair.overlap else "valid"
    return "" if pair.verdict == expected else f"{pair.verdict}, not {expected}"


def _draw_core(rng: Random) -> tuple[list[Point], Fraction]:
    """Draw a point, a segment or a rectangle, and a radius."""
    radius, zero = Fraction(rng.randint(5, 40), 10), Fraction(0)
    match rng.randrange(3):
        case 0:
            corners = [(zero, zero)]
        case 1:
            x, y = rng.choice(_DIRECTIONS)
            times = rng.randint(1, 3)
            corners = [(zero, zero), (Fraction(x * times), Fraction(y * times))]
        case _:
            u, v = (Fraction(rng.randint(1, 60), 10) for _ in "xy")
            corners = [(zero, zero), (u, zero), (u, v), (zero, v)]
    return [Point(*corner) for corner in corners], radius


def _move(core: list[Point], way: Point, times: Fraction) -> list[Point]:
    return [Point(x + way.x * times, y + way.y * times) for x, y in core]


def _round(value: Fraction) -> Fraction:
    return Fraction(round(value * 10**_PLACES), 10**_PLACES)


def _write(core: list[Point], r: Fraction) -> str:
    """Write a shape as an element of SVG, exactly."""
    x, y = core[0]
    if len(core) == 1:
        return '<circle cx="{}" cy="{}" r="{}"/>'.format(*map(format_decimal, (x, y, r)))
    if len(core) == 4:
        width, height = core[1].x - x, core[2].y - y
        numbers = x - r, y - r, width + 2 * r, height + 2 * r, r
        words = 'x="{}" y="{}" width="{}" height="{}" rx="{}"'
        return f"<rect {words.format(*map(format_decimal, numbers))}/>"
    u, v = core[1]
    dx, dy = u - x, v - y
    length = isqrt(int(dx * dx + dy * dy))
    a, b = -dy * r / length, dx * r / length
    ends = (x + a, y + b), (x - a, y - b), (u - a, v - b), (u + a, v + b)
    one, two, three, four = (f"{format_decimal(p)} {format_decimal(q)}" for p, q in ends)
    arc = f"A{format_decimal(r)} {format_decimal(r)} 0 0 1"
    return f'<path d="M{one} {arc} {two} L{three} {arc} {four}z"/>'


def measure(one: list[Point], other: list[Point]) -> Fraction:
    """Return the squared distance of two points, segments or axis-aligned rectangles."""
    if any(_is_inside(p, q) for p, q in ((one[0], other), (other[0], one))):
        return Fraction(0)
    pairs = product(_sides(one), _sides(other))
    return min(_measure_segments(e, f) for e, f in pairs)


def _is_inside(p: Point, core: list[Point]) -> bool:
    low, high = core[0], core[len(core) // 2]
    return len(core) == 4 and low.x <= p.x <= high.x and low.y <= p.y <= high.y


def _sides(core: list[Point]) -> list[tuple[Point, Point]]:
    return [(p, core[(k + 1) % len(core)]) for k, p in enumerate(core)]


def _measure_segments(one: tuple[Point, Point], other: tuple[Point, Point]) -> Fraction:
    (a, b), (p, q) = one, other
    if _turn(a, b, p) * _turn(a, b, q) < 0 and _turn(p, q, a) * _turn(p, q, b) < 0:
        return Fraction(0)
    ends = [(p, one), (q, one), (a, other), (b, other)]
    return min(_measure_point(point, segment) for point, segment in ends)


def _turn(a: Point, b: Point, c: Point) -> Fraction:
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)


def _measure_point(p: Point, segment: tuple[Point, Point]) -> Fraction:
    a, b = segment
    dx, dy = b.x - a.x, b.y - a.y
    length = dx * dx + dy * dy
    t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / length if length else Fraction(0)
    t = min(max(t, Fraction(0)), Fraction(1))
    return (a.x + t * dx - p.x) ** 2 + (a.y + t * dy - p.y) ** 2
