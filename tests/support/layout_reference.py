"""Layouts judged by the definition: all pairs by `classify`, distances by all pairs of edges."""

import json
from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations, pairwise, product
from math import lcm
from random import Random
from typing import Any, NamedTuple

from random_layouts import RandomLayout

from exactsweep import Point, Region
from exactsweep.check import classify, verify
from exactsweep.layout import Judgement, Layout, LayoutError, Placement, judge_layout

MOVES = 2
BITS = 320
"""The precision of rational rotations near an irrational one."""

Pairs = set[tuple[int, ...]]
IntEdge = tuple[int, int, int, int]


class Truth(NamedTuple):
    """The faults of a layout, as placements by kind, and the other answers of a judge."""

    faults: Counter[tuple[str, tuple[int, ...]]]
    contacts: Pairs
    distance: Fraction | None
    density: Fraction
    shapes: list[Region]


def place(layout: Layout, placement: Placement) -> Region:
    """Return the placed part, mirrored, rotated and translated vertex by vertex."""
    (part,) = [one for one in layout.parts if one.id == placement.part]
    cosine, sine, _ = placement.turn.near(BITS)
    dx, dy = placement.move

    def put(p: Point) -> tuple[Fraction, Fraction]:
        x, y = (-p.x if placement.mirrored else p.x), p.y
        return cosine * x - sine * y + dx, sine * x + cosine * y + dy

    return Region([put(p) for p in part.exterior], [[put(p) for p in hole] for hole in part.holes])


def squared_distance(one: Region, other: Region) -> Fraction:
    """Return the squared distance of the boundaries, by all pairs of edges."""
    scale = lcm(*(c.denominator for region in (one, other) for p in region.vertices for c in p))
    n, d = 0, 0
    for a, b in product(list_edges(one, scale), list_edges(other, scale)):
        square, length = segments_apart(a, b)
        if d == 0 or square * d < n * length:
            n, d = square, length
    return Fraction(n, d * scale * scale)


def boxes_apart(one: tuple[Point, Point], other: tuple[Point, Point]) -> Fraction:
    """Return the squared distance of two boxes."""
    (a, b), (c, d) = one, other
    across = max(a.x - d.x, c.x - b.x, Fraction(0))
    up = max(a.y - d.y, c.y - b.y, Fraction(0))
    return across**2 + up**2


def list_edges(region: Region, scale: int) -> list[IntEdge]:
    """Return the edges of all rings, times the scale."""
    return [
        (int(a.x * scale), int(a.y * scale), int(b.x * scale), int(b.y * scale))
        for ring in region.rings
        for a, b in pairwise((*ring, ring[0]))
    ]


def segments_apart(one: IntEdge, other: IntEdge) -> tuple[int, int]:
    """Return the squared distance of two segments, as a quotient."""
    ax, ay, bx, by = one
    px, py, qx, qy = other
    of_p, of_q = turn(ax, ay, bx, by, px, py), turn(ax, ay, bx, by, qx, qy)
    of_a, of_b = turn(px, py, qx, qy, ax, ay), turn(px, py, qx, qy, bx, by)
    if of_p * of_q < 0 and of_a * of_b < 0:
        return 0, 1
    found = [
        point_apart(px, py, one),
        point_apart(qx, qy, one),
        point_apart(ax, ay, other),
        point_apart(bx, by, other),
    ]
    n, d = found[0]
    for square, length in found[1:]:
        if square * d < n * length:
            n, d = square, length
    return n, d


def turn(ax: int, ay: int, bx: int, by: int, cx: int, cy: int) -> int:
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


def point_apart(x: int, y: int, edge: IntEdge) -> tuple[int, int]:
    """Return the squared distance of a point from a segment, as a quotient."""
    ax, ay, bx, by = edge
    length = (bx - ax) ** 2 + (by - ay) ** 2
    share = min(max((x - ax) * (bx - ax) + (y - ay) * (by - ay), 0), length)
    # The foot is a + share / length * (b - a).
    dx = (x - ax) * length - share * (bx - ax)
    dy = (y - ay) * length - share * (by - ay)
    return dx * dx + dy * dy, length * length


def judge_by_definition(layout: Layout) -> Truth:
    """Judge a layout with simple parts by the definition, pair by pair."""
    faults: Counter[tuple[str, tuple[int, ...]]] = Counter()
    contacts: Pairs = set()
    shapes = [place(layout, placement) for placement in layout.placements]
    least: Fraction | None = None
    boxes = [shape.bounding_box for shape in shapes]
    for (k, one), (j, other) in combinations(enumerate(shapes), 2):
        # Boxes are no farther apart than shapes.
        between = boxes_apart(boxes[k], boxes[j])
        if between > layout.spacing**2 and least is not None and between > least:
            continue
        verdict = classify(one, other, (0, 0)).verdict
        apart = Fraction(0) if verdict == "OVERLAP" else squared_distance(one, other)
        least = apart if least is None else min(least, apart)
        if verdict == "OVERLAP":
            faults["overlap", (k, j)] += 1
        elif apart < layout.spacing**2:
            faults["too close", (k, j)] += 1
        if verdict == "CONTACT":
            contacts.add((k, j))
    walls = list_walls(layout, shapes)
    for k, shape in enumerate(shapes):
        verdicts = [classify(wall, shape, (0, 0)).verdict for wall in walls]
        if "OVERLAP" in verdicts:
            faults["outside", (k,)] += 1
        elif min(squared_distance(wall, shape) for wall in walls) < layout.margin**2:
            faults["too close", (k,)] += 1
    for part in layout.parts:
        its = tuple(k for k, p in enumerate(layout.placements) if p.part == part.id)
        if part.demand is not None and len(its) < part.demand:
            faults["missing", its] += 1
        if part.demand is not None and len(its) > part.demand:
            faults["surplus", its] += 1
        for k in its:
            if part.turns is not None and layout.placements[k].turn not in part.turns:
                faults["turn", (k,)] += 1
            if part.mirrored is False and layout.placements[k].mirrored:
                faults["mirror", (k,)] += 1
    assert isinstance(layout.container, Region)
    density = sum((shape.area for shape in shapes), Fraction(0)) / layout.container.area
    return Truth(faults, contacts, least, density, shapes)


def list_walls(layout: Layout, shapes: Sequence[Region]) -> list[Region]:
    """List the complement of the container in a large frame, and the defects."""
    assert isinstance(layout.container, Region)
    corners = [*layout.container.vertices, *(p for shape in shapes for p in shape.vertices)]
    left, right = min(p.x for p in corners), max(p.x for p in corners)
    low, high = min(p.y for p in corners), max(p.y for p in corners)
    # Tested moves stay inside the frame.
    room = 2 * (right - left + high - low + layout.margin)
    left, right, low, high = left - room, right + room, low - room, high + room
    frame = [(left, low), (right, low), (right, high), (left, high)]
    assert isinstance(layout.container, Region)
    defects = [*map(Region, layout.container.holes)]
    defects += [one.shape for one in layout.defects if isinstance(one.shape, Region)]
    return [Region(frame, [layout.container.exterior]), *defects]


def compare(drawn: RandomLayout, rng: Random, deep: bool) -> str:
    """Judge a random layout; describe a difference from the definition, "" if none."""
    judgement = judge_layout(drawn.layout)
    return (
        find_difference(drawn.layout, judgement)
        or find_wrong_move(drawn.layout, judgement, MOVES)
        or find_unproved(judgement, rng)
    )


def find_difference(layout: Layout, judgement: Any) -> str:
    """Describe a difference of a judgement from the definition; "" if none."""
    truth = judge_by_definition(layout)
    found = Counter((fault.kind, fault.placements) for fault in judgement.faults)
    undecided = {
        fault.placements: fault.bound for fault in judgement.faults if fault.kind == "undecided"
    }
    walls = list_walls(layout, truth.shapes)
    for placements, bound in undecided.items():
        if not _is_close_call(layout, truth, walls, placements, bound):
            return f"{placements} undecided"
        for kind in ("undecided", "overlap", "too close", "outside"):
            truth.faults.pop((kind, placements), None)
            found.pop((kind, placements), None)
    if found != truth.faults:
        return f"faults: {dict(found - truth.faults)} and not {dict(truth.faults - found)}"
    contacts = set(judgement.contacts) ^ truth.contacts
    if any(pair not in undecided for pair in contacts):
        return f"contacts: {contacts}"
    if judgement.valid is not (not judgement.faults):
        return "valid"
    if judgement.density != truth.density:
        return "density"
    nearest = judgement.distance
    square = None if nearest is None else nearest.square
    if square != truth.distance and not _has_angles(layout):
        return f"distance: {square}, not {truth.distance}"
    return next(filter(None, (_find_wrong(layout, truth, walls, f) for f in judgement.faults)), "")


def _has_angles(layout: Layout) -> bool:
    return any(placement.turn.exact is None for placement in layout.placements)


def _is_close_call(
    layout: Layout, truth: Truth, walls: list[Region], placements: tuple[int, ...], bound: Fraction
) -> bool:
    """Decide whether a pair is too close to contact or its spacing to be decided by bounds."""
    first = truth.shapes[placements[0]]
    others = [truth.shapes[placements[1]]] if len(placements) > 1 else walls
    asked = layout.spacing if len(placements) > 1 else layout.margin
    squares = [squared_distance(first, other) for other in others]
    return any(
        square <= 4 * bound**2
        or (asked > 2 * bound and (asked - 2 * bound) ** 2 <= square <= (asked + 2 * bound) ** 2)
        for square in squares
    )


def _find_wrong(layout: Layout, truth: Truth, walls: list[Region], fault: Any) -> str:
    """Describe an error in the proof of a fault; "" if none."""
    shapes = [truth.shapes[k] for k in fault.placements] if fault.points else []
    if fault.kind == "overlap":
        (point,) = fault.points
        if not all(shape.contains(point, strictly=True) for shape in shapes):
            return f"{fault.kind} {fault.placements}: the point is not inside both"
    elif fault.kind == "outside":
        (point,) = fault.points
        if not shapes[0].contains(point, strictly=True) or not any(
            wall.contains(point, strictly=True) for wall in walls
        ):
            return f"{fault.kind} {fault.placements}: the point is not outside"
    elif fault.kind == "too close":
        p, q = fault.points
        square = (p.x - q.x) ** 2 + (p.y - q.y) ** 2
        if square != fault.distance_squared:
            return f"{fault.kind} {fault.placements}: the points are not as far apart"
        others = shapes[1:] or walls
        apart = min(squared_distance(shapes[0], other) for other in others)
        if fault.bound == 0 and apart != square:
            return f"{fault.kind} {fault.placements}: the points are not the nearest"
    return ""


def find_wrong_move(layout: Layout, judgement: Judgement, number: int) -> str:
    """Describe an error in the shortest moves of the first faults; "" if none."""
    shapes = [place(layout, placement) for placement in layout.placements]
    walls = list_walls(layout, shapes)
    tried = [f for f in judgement.faults if f.kind in ("overlap", "outside") and not f.bound]
    for fault in tried[:number]:
        moved = shapes[fault.placements[-1]]
        fixed = [shapes[fault.placements[0]]] if fault.kind == "overlap" else walls
        move = fault.move
        if move is None:
            continue
        if any(classify(one, moved, move).verdict == "OVERLAP" for one in fixed):
            return f"{fault.kind} {fault.placements}: the move does not free it"
        length, depth = move.x**2 + move.y**2, fault.depth_squared
        if depth is not None and length < depth:
            return f"{fault.kind} {fault.placements}: the move is shorter than the depth"
        # A repair also keeps the distances, so it is the shortest move only without distances.
        if layout.spacing if fault.kind == "overlap" else layout.margin:
            continue
        if depth not in (None, length):
            return f"{fault.kind} {fault.placements}: the depth is not that of the move"
        for a, b, c in ((1, 0, 1), (0, 1, 1), (-1, 0, 1), (0, -1, 1), (3, 4, 5), (-5, 12, 13)):
            for share in (Fraction(1, 2), Fraction(999, 1000)):
                x, y = (
                    share * part / c for part in (move.x * a - move.y * b, move.x * b + move.y * a)
                )
                if all(classify(one, moved, (x, y)).verdict != "OVERLAP" for one in fixed):
                    return f"{fault.kind} {fault.placements}: a shorter move frees it"
    return ""


def find_unproved(judgement: Judgement, rng: Random) -> str:
    """Describe a certificate that is not proved, or is proved after a change; "" if none."""
    kinds = {fault.kind for fault in judgement.faults}
    try:
        certificate = json.loads(json.dumps(judgement.certificate()))
    except LayoutError as error:
        return "" if kinds == {"undecided"} else str(error)
    result = verify(certificate)
    if not result.proved:
        return f"certificate: {result.reason}"
    if verify({**certificate, "valid": not certificate["valid"]}).proved:
        return "certificate: the other verdict is also proved"
    # A normal for all pieces may be unnecessary: perhaps no two of them are near.
    apart = certificate["proof"]["apart"] if certificate["valid"] else []
    needed = [entry for entry in apart if entry[1] >= 0]
    if needed:
        apart.remove(rng.choice(needed))
        if verify(certificate).proved:
            return "certificate: it is proved without one of its normals"
    return ""
