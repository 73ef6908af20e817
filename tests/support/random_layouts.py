"""Seeded random layouts of 2 to 60 parts: jigsaws, rows, and heaps.

The only source of randomness is one `random.Random`, so the seed reproduces a layout.
"""

from collections.abc import Callable
from fractions import Fraction
from random import Random
from typing import Any, NamedTuple

from layouts import Ring, box
from placed import draw_jigsaw
from shape_families import SHAPES

from exactsweep import PolygonError, Region
from exactsweep.corpus.generator.prng import Prng
from exactsweep.layout import Layout

PYTHAGORAS = [(3, 4, 5), (4, -3, 5), (-5, 12, 13), (7, 24, 25), (-21, -20, 29)]
SCALES = [Fraction(1), Fraction(1), Fraction(7, 3), Fraction(10**30), Fraction(1, 10**30)]
TINY = Fraction(1, 10**40)

Pair = tuple[Fraction, Fraction]


def draw_turn(rng: Random, *, exact: bool = False) -> Any:
    """Draw a rotation: usually a multiple of 90 degrees, else a cosine and a sine, or any angle."""
    kind = rng.random()
    if kind < 0.5:
        return rng.choice([0, 90, 180, 270, -90, 450])
    if kind < 0.8 or exact:
        a, b, c = rng.choice(PYTHAGORAS)
        return [Fraction(a, c), Fraction(b, c)]
    return Fraction(rng.randint(-3600, 3600), rng.choice([10, 1000, 7]))


def turn_back(turn: Any, *, mirrored: bool) -> Callable[[Pair], Pair]:
    """Invert an exact rotation and the mirroring before it."""
    quarters = [(1, 0), (0, 1), (-1, 0), (0, -1)]
    c, s = map(Fraction, turn if isinstance(turn, list) else quarters[turn // 90 % 4])

    def back(p: Pair) -> Pair:
        x, y = c * p[0] + s * p[1], c * p[1] - s * p[0]
        return (-x if mirrored else x), y

    return back


def draw_gap(rng: Random, unit: Fraction) -> Fraction:
    """Draw a required distance, mostly 0."""
    return rng.choice([Fraction(0), Fraction(0), unit / 4, unit, 2 * unit, unit * TINY])


def lay_jigsaw(rng: Random, scale: Fraction) -> dict[str, Any]:
    """Place pieces cut from a sheet, exactly or with one displaced."""
    *shapes, _ = draw_jigsaw(rng)
    sheet, *pieces = shapes
    parts: list[dict[str, Any]] = []
    placements: list[dict[str, Any]] = []
    astray = rng.random() < 0.5
    steps = [Fraction(1), Fraction(-1), TINY, -TINY, Fraction(1, 3)]
    for k, piece in enumerate(pieces):
        turn, mirrored = draw_turn(rng, exact=True), rng.random() < 0.3
        x, y = (Fraction(rng.randint(-20, 20), rng.choice([1, 3])) for _ in "xy")
        back = turn_back(turn, mirrored=mirrored)
        rings: list[list[Pair]] = [
            [back((scale * px - x, scale * py - y)) for px, py in ring] for ring in piece.rings
        ]
        if astray and rng.random() < 0.15:
            x += scale * rng.choice(steps)
        if astray and rng.random() < 0.1:
            y += scale * rng.choice(steps)
        parts.append({"id": f"p{k}", "exterior": rings[0], "holes": rings[1:]})
        placements.append({"part": f"p{k}", "turn": turn, "mirrored": mirrored, "move": [x, y]})
    outline = [[(scale * px, scale * py) for px, py in ring] for ring in sheet.rings]
    return {
        "container": {"exterior": outline[0], "holes": outline[1:]},
        "parts": parts,
        "placements": placements,
    }


def draw_parts(rng: Random, scale: Fraction) -> list[dict[str, Any]]:
    """Draw one to four parts of any shape."""
    parts: list[dict[str, Any]] = []
    for k in range(rng.randint(1, 4)):
        pair = SHAPES[rng.choice([*SHAPES])](Prng(str(rng.getrandbits(64))))
        rings = [[(scale * x, scale * y) for x, y in ring] for ring in rng.choice(pair).rings]
        if rng.random() < 0.5:
            rings = [ring[::-1] for ring in rings]
        parts.append({"id": f"p{k}", "exterior": rings[0], "holes": rings[1:]})
        if rng.random() < 0.1:
            parts[-1]["turns"] = [draw_turn(rng) for _ in range(rng.randint(0, 3))]
        if rng.random() < 0.1:
            parts[-1]["mirrored"] = rng.random() < 0.5
    return parts


def lay_rows(rng: Random, scale: Fraction, spacing: Fraction) -> dict[str, Any]:
    """Place parts in rows, with boxes that touch, keep the spacing, or are slightly off."""
    parts, number = (
        draw_parts(rng, scale),
        rng.choice([2, 2, 3, 4, 5, 6, 8, 13, rng.choice([13, 30, 60])]),
    )
    columns = rng.randint(1, number)
    placements: list[dict[str, Any]] = []
    steps = [spacing]
    if rng.random() < 0.5:
        steps = [Fraction(0), spacing] * 4
        steps += [spacing - scale * TINY, spacing + scale * TINY, -scale, scale / 3]
    y = above = Fraction(0)
    x = Fraction(0)
    for k in range(number):
        if k % columns == 0:
            x, y = Fraction(0), above
        part, turn = rng.choice(parts), draw_turn(rng)
        mirrored = rng.random() < 0.3
        low, high = bounds(part, turn, mirrored=mirrored)
        placements.append(
            {
                "part": part["id"],
                "turn": turn,
                "mirrored": mirrored,
                "move": [x - low[0], y - low[1]],
            }
        )
        x += high[0] - low[0] + rng.choice(steps)
        above = max(above, y + high[1] - low[1] + rng.choice(steps))
    return {"parts": parts, "placements": placements}


def bounds(part: dict[str, Any], turn: Any, *, mirrored: bool) -> tuple[Pair, Pair]:
    """Return the box of a mirrored and rotated part; approximate for inexact angles."""
    region = Region(part["exterior"])
    region = region.mirrored() if mirrored else region
    low, high = region.rotated(tuple(turn) if isinstance(turn, list) else turn, bits=8).bounding_box
    return (low.x, low.y), (high.x, high.y)


def lay_heap(rng: Random, scale: Fraction, _: Fraction) -> dict[str, Any]:
    """Place parts anywhere on a small grid."""
    parts, number = draw_parts(rng, scale), rng.choice([2, 3, 4, 6, 10, 25])
    side = rng.choice([6, 20, 60, 100])
    placements = [
        {
            "part": rng.choice(parts)["id"],
            "turn": draw_turn(rng),
            "mirrored": rng.random() < 0.3,
            "move": [scale * Fraction(rng.randint(0, 2 * side), 2) for _ in "xy"],
        }
        for _ in range(number)
    ]
    return {"parts": parts, "placements": placements}


def put_around(rng: Random, data: dict[str, Any], scale: Fraction, margin: Fraction) -> None:
    """Add a container: roughly the box of all parts, with cut corners and defects."""
    by_id = {part["id"]: part for part in data["parts"]}
    xs, ys = [], []
    for one in data["placements"]:
        box_of = bounds(by_id[one["part"]], one["turn"], mirrored=one["mirrored"])
        xs += [one["move"][0] + corner[0] for corner in box_of]
        ys += [one["move"][1] + corner[1] for corner in box_of]
    margins = [margin] * 9 + [margin + scale * TINY, margin - scale * TINY, 2 * scale]
    room = [rng.choice(margins) for _ in range(4)]
    left, right = min(xs) - room[0], max(xs) + room[1]
    low, high = min(ys) - room[2], max(ys) + room[3]
    exterior: Ring = box(left, low, right, high)
    if rng.random() < 0.3:
        cut = min(right - left, high - low) / rng.choice([2, 3, 7])
        exterior = [(left + cut, low), *exterior[1:], (left, low + cut)]
    defects: list[Ring] = []
    for _ in range(rng.choice([0, 0, 0, 0, 1, 2, 4])):
        x = left + (right - left) * Fraction(rng.randint(1, 11), 12)
        y = low + (high - low) * Fraction(rng.randint(1, 11), 12)
        shape: Ring = rng.choice([box(0, 0, 1, 1), [(0, 0), (2, 0), (1, 3)]])
        ring = [(x + scale * px, y + scale * py) for px, py in shape]
        try:
            Region(exterior, [*defects, ring])
        except PolygonError:
            continue
        defects.append(ring)
    data["container"] = {"exterior": exterior, "holes": defects}


class RandomLayout(NamedTuple):
    """A layout and its family."""

    family: str
    layout: Layout


def draw_layout(rng: Random) -> RandomLayout:
    scale = rng.choice(SCALES)
    spacing, margin = draw_gap(rng, scale), draw_gap(rng, scale)
    family = rng.choice(["jigsaw", "rows", "rows", "heap"])
    if family == "jigsaw":
        if rng.random() < 0.7:
            spacing = margin = Fraction(0)
        data = lay_jigsaw(rng, scale)
    else:
        data = {"rows": lay_rows, "heap": lay_heap}[family](rng, scale, spacing)
        put_around(rng, data, scale, margin)
    for part in data["parts"]:
        if rng.random() < 0.3:
            placed = sum(one["part"] == part["id"] for one in data["placements"])
            part["demand"] = max(0, placed + rng.choice([*[0] * 8, 1, -1]))
    data |= {"spacing": spacing, "margin": margin}
    return RandomLayout(family, Layout.from_json(data))
