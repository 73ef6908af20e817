"""The judge of layouts, compared with CGAL and shapely, and its growth over doubling sizes.

All three find the placed parts that overlap or leave the container. shapely and CGAL compute
intersections; CGAL also tests them by `do_intersect`. The layouts are tilings by interlocking
parts, with a small gap or none, as dense as the layouts of nesting programs.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from random import Random
from statistics import median
from tempfile import TemporaryDirectory
from time import process_time
from tracemalloc import get_traced_memory, start, stop
from typing import Any, NamedTuple

from rich.table import Table

from benchmarks.clock import milliseconds
from benchmarks.peers.adapters import MissingError
from benchmarks.peers.cgal import compile_program
from benchmarks.peers.process import run
from exactsweep import Point, Region
from exactsweep.layout import Layout, judge_layout

SOURCE = Path(__file__).parent / "cgal" / "layouts.cpp"

GAP, TOUCHING = "a gap", "touching borders"
CELL = 10**9
# Placements and vertices per part, as in published records.
RECORDS = ((24, 8), (28, 8), (30, 12), (48, 20), (99, 8), (64, 12), (50, 116), (80, 212))
DOUBLINGS = (625, 1250, 2500, 5000, 10_000)
GROWING = 52
OPERATIONS = {"CGAL": "intersection", "CGAL meet": "meet"}

Pairs = set[tuple[int, int]]
Offsets = list[tuple[int, int]]


def tile(number: int, vertices: int, *, gap: bool, seed: int = 1) -> Layout:
    """Make a layout of interlocking parts."""
    random = Random(f"{number}:{vertices}:{seed}")
    inner = (vertices - 4) // 4
    columns = round(number**0.5)
    borders = [draw_border(random, inner) for _ in range(3)]
    room = CELL // (200 * (inner + 1)) if gap else 0
    parts: dict[tuple[int, ...], str] = {}
    described, placements = [], []
    for k in range(number):
        row, column = divmod(k, columns)
        kinds = tuple(
            (place * (1 + column if axis else 1 + row) + 2 * axis) % 3
            for axis, place in ((0, column), (0, column + 1), (1, row), (1, row + 1))
        )
        key = *kinds, k % 2
        if key not in parts:
            parts[key] = f"part {len(parts)}"
            ring = draw_tile([borders[kind] for kind in kinds], room)
            ring = [(-x, -y) for x, y in ring] if k % 2 else ring
            described.append({"id": parts[key], "exterior": ring})
        # Borders may be steep, so a small move can close a gap.
        x, y = (CELL * place + random.randint(0, room // vertices) for place in (column, row))
        turn = 180 if k % 2 else 0
        placements.append({"part": parts[key], "turn": turn, "move": [x, y]})
    rows = -(-number // columns)
    low, right, high = -CELL // 2, CELL * columns + CELL // 2, CELL * rows + CELL // 2
    container = [(low, low), (right, low), (right, high), (low, high)]
    data = {"container": {"exterior": container}, "parts": described, "placements": placements}
    return Layout.from_json(data)


def draw_border(random: Random, inner: int) -> Offsets:
    """Draw the interior points of a border, as pairs of a position along it and an offset."""
    found = []
    for k in range(1, inner + 1):
        along = CELL * k // (inner + 1)
        # Borders that meet at a corner stay in separate quadrants.
        most = 9 * min(along, CELL - along, CELL // 3) // 10
        found.append((along, random.randint(-most, most)))
    return found


def draw_tile(borders: list[Offsets], room: int) -> list[tuple[int, int]]:
    """Make the part in a cell from its left, right, lower and upper borders, shrunk by a gap."""
    left, right, low, high = borders
    ring = [(room, room), *((along, off + room) for along, off in low)]
    ring += [(CELL - room, room), *((CELL + off - room, along) for along, off in right)]
    ring += [(CELL - room, CELL - room), *((al, CELL + off - room) for al, off in high[::-1])]
    return [*ring, (room, CELL - room), *((off + room, along) for along, off in left[::-1])]


def place_all(layout: Layout) -> list[Region]:
    """List the placed parts, and the complement of the container in a frame."""
    placed = []
    for placement in layout.placements:
        region = layout.part_by_id[placement.part].region
        assert region is not None
        region = region.mirrored() if placement.mirrored else region
        cosine, sine, _ = placement.turn.near()
        placed.append(region.rotated((cosine, sine)).translated(placement.move))
    assert isinstance(layout.container, Region)
    low, high = zip(*(shape.bounding_box for shape in (*placed, layout.container)), strict=True)
    left, bottom = min(p.x for p in low) - 1, min(p.y for p in low) - 1
    right, top = max(p.x for p in high) + 1, max(p.y for p in high) + 1
    frame = [Point(left, bottom), Point(right, bottom), Point(right, top), Point(left, top)]
    return [*placed, Region(frame, [layout.container.exterior])]


def judge_ours(layout: Layout) -> Pairs:
    """Find the overlapping pairs by our judge; the outside has the last index."""
    outside = len(layout.placements)
    return {
        (fault.placements[0], fault.placements[1] if fault.kind == "overlap" else outside)
        for fault in judge_layout(layout).faults
        if fault.kind in ("overlap", "outside")
    }


def make_shapely(shapes: list[Region]) -> Callable[[], Pairs]:
    """Return a function that finds the overlapping pairs by areas of intersections."""
    import numpy
    import shapely

    rings = [[numpy.array([(float(x), float(y)) for x, y in r]) for r in s.rings] for s in shapes]

    def judge() -> Pairs:
        made = shapely.polygons([shapely.linearrings(ring) for ring, *_ in rings])
        for k, (_, *holes) in enumerate(rings):
            if holes:
                made[k] = shapely.polygons(
                    made[k].exterior, [shapely.linearrings(h) for h in holes]
                )
        first, second = shapely.STRtree(made).query(made)
        near = first < second
        first, second = first[near], second[near]
        meets = shapely.area(shapely.intersection(made[first], made[second])) > 0
        return set(zip(first[meets].tolist(), second[meets].tolist(), strict=True))

    return judge


def write_shapes(shapes: list[Region]) -> str:
    """Write the input of the CGAL program."""
    lines = [str(len(shapes))]
    for shape in shapes:
        lines.append(str(len(shape.rings)))
        for k, ring in enumerate(shape.rings):
            lines.append(str(len(ring)))
            lines += (f"{x} {y}" for x, y in (ring[::-1] if k else ring))
    return "\n".join(lines) + "\n"


class ComparedLayout(NamedTuple):
    """Median times in ms for one layout, and whether all programs find the same pairs."""

    name: str
    placements: int
    vertices: int
    times: dict[str, float]
    same: bool


def measure(name: str, layout: Layout, cgal: Path | None, seconds: float = 0.2) -> ComparedLayout:
    """Judge a layout by all programs alternately, twice."""
    *placed, outside = place_all(layout)
    shapes = [*placed, outside]
    by_shapely = make_shapely(shapes)
    given = write_shapes(shapes)
    taken: defaultdict[str, list[float]] = defaultdict(list)
    found = judge_ours(layout)
    same = found == by_shapely()
    for _ in range(2):
        taken["ours"] += milliseconds(partial(judge_ours, layout), seconds)
        taken["shapely"] += milliseconds(by_shapely, seconds)
        for program, operation in OPERATIONS.items() if cgal else ():
            times, *pairs = run([str(cgal), operation, str(seconds)], given, 100.0).splitlines()
            taken[program] += map(float, times.split())
            same = same and found == {(int(a), int(b)) for a, b in map(str.split, pairs)}
    medians = {program: median(times) for program, times in taken.items()}
    return ComparedLayout(name, len(placed), sum(map(len, placed)) // len(placed), medians, same)


def compare_all(cgal: Path | None, *, quick: bool) -> Iterator[ComparedLayout]:
    """Measure tilings as large as published records, with and without a gap."""
    for number, vertices in RECORDS[:2] if quick else RECORDS:
        for gap in (True, False):
            yield measure(GAP if gap else TOUCHING, tile(number, vertices, gap=gap), cgal)


class Grown(NamedTuple):
    """Seconds for layouts of several sizes, and peak MB."""

    placements: int
    verdict: float
    distance: float
    memory: float


def grow(number: int) -> Grown:
    """Judge a large tiling once, and find its nearest parts."""
    layout = tile(number, GROWING, gap=True)
    for part in layout.parts:
        assert part.region is not None
    began = process_time()
    judgement = judge_layout(layout)
    judged = process_time()
    assert judgement.valid
    assert judgement.distance is not None
    ended = process_time()
    start()
    judge_layout(layout)
    _, most = get_traced_memory()
    stop()
    return Grown(number, judged - began, ended - judged, most / 1e6)


def compile_judge(folder: Path) -> Path | None:
    """Compile the CGAL program if CGAL is installed."""
    try:
        return compile_program(folder, SOURCE)
    except MissingError:
        return None


def tabulate(cgal: Path | None, *, quick: bool) -> Iterator[Table | str]:
    """Yield the tables, and lines with the medians of the ratios."""
    with TemporaryDirectory() as folder:
        cgal = cgal or compile_judge(Path(folder))
        found = list(compare_all(cgal, quick=quick))
    table = Table(title="Judging of layouts, median processor time in ms")
    programs = [*found[0].times]
    ratios = [("ours", "shapely"), *((program, "ours") for program in programs[2:])]
    for column in ("parts with", "placements", "vertices", *programs):
        table.add_column(column, justify="right")
    for ratio in ratios:
        table.add_column(" / ".join(ratio), justify="right")
    table.add_column("same pairs")
    for row in found:
        table.add_row(
            *(row.name, str(row.placements), str(row.vertices)),
            *(f"{row.times[program]:.2f}" for program in programs),
            *(f"{row.times[a] / row.times[b]:.1f}" for a, b in ratios),
            "yes" if row.same else "no",
        )
    yield table
    for name in (GAP, TOUCHING):
        for a, b in ratios:
            half = median(row.times[a] / row.times[b] for row in found if row.name == name)
            yield f"{name}: {a} / {b}: median {half:.1f}"
    growth = Table(title=f"Tilings by parts of {GROWING} vertices: seconds, and peak MB")
    for name in ("placements", "verdict", "minimum distance", "memory"):
        growth.add_column(name, justify="right")
    for number in DOUBLINGS[:1] if quick else DOUBLINGS:
        grown = grow(number)
        row_of: list[Any] = [f"{grown.verdict:.2f}", f"{grown.distance:.2f}", f"{grown.memory:.0f}"]
        growth.add_row(str(grown.placements), *row_of)
    yield growth
