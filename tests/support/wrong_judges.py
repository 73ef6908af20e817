"""Judges with one plausible mistake each; known layouts must detect all of them."""

from collections.abc import Callable, Iterable
from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from typing import Any

from layout_reference import list_walls, place

from exactsweep import Point, Region
from exactsweep.check import classify, point_in_polygon
from exactsweep.geometry.turn import Turn, read_turn
from exactsweep.layout import Layout, LayoutPart, Placement, judge_layout

Answer = list[tuple[str, tuple[int, ...]]]
WRONG: dict[str, Callable[[Layout], Answer]] = {}
TOLERANCE = Fraction(1, 10**9)


def right(layout: Layout) -> Answer:
    """Return the answer of the judge, in the order of kinds and placements."""
    return [(fault.kind, fault.placements) for fault in judge_layout(layout).faults]


def wrong(judge: Callable[[Layout], Answer]) -> Callable[[Layout], Answer]:
    WRONG[judge.__name__] = judge
    return judge


def with_placements(layout: Layout, change: Callable[[Placement], Placement]) -> Layout:
    return replace(layout, placements=tuple(map(change, layout.placements)))


def with_parts(layout: Layout, change: Callable[[LayoutPart], LayoutPart]) -> Layout:
    return replace(layout, parts=tuple(map(change, layout.parts)))


def without(answer: Answer, *kinds: str) -> Answer:
    return [(kind, where) for kind, where in answer if kind not in kinds]


def turned_back(turn: Turn) -> Turn:
    """Return the same angle clockwise."""
    if turn.degrees is not None:
        return read_turn(-turn.degrees)
    assert turn.exact is not None
    return read_turn((turn.exact[0], -turn.exact[1]))


@wrong
def asks_for_more_than_the_spacing(layout: Layout) -> Answer:
    """Reject a distance equal to the spacing."""
    return right(replace(layout, spacing=layout.spacing + layout.spacing * Fraction(1, 10**40)))


@wrong
def asks_for_more_than_the_margin(layout: Layout) -> Answer:
    return right(replace(layout, margin=layout.margin + layout.margin * Fraction(1, 10**40)))


@wrong
def allows_a_tolerance(layout: Layout) -> Answer:
    """Compare distances with a tolerance, as for doubles."""
    return right(replace(layout, spacing=max(Fraction(0), layout.spacing - TOLERANCE)))


@wrong
def rounds_to_doubles(layout: Layout) -> Answer:
    def rounded(p: Placement) -> Placement:
        return replace(p, move=Point(*(Fraction(float(c)) for c in p.move)))

    return right(with_placements(layout, rounded))


@wrong
def takes_contact_for_overlap(layout: Layout) -> Answer:
    judgement = judge_layout(layout)
    return [("overlap", pair) for pair in judgement.contacts] + right(layout)


@wrong
def takes_boxes_for_parts(layout: Layout) -> Answer:
    found = []
    boxes = [shape.bounding_box for shape in place_all(layout)]
    for (k, (a, b)), (j, (c, d)) in combinations(enumerate(boxes), 2):
        if a.x < d.x and c.x < b.x and a.y < d.y and c.y < b.y:
            found.append(("overlap", (k, j)))
    return found + without(right(layout), "overlap")


@wrong
def looks_for_vertices_inside_only(layout: Layout) -> Answer:
    """Accept two parts if no vertex of one is inside the other."""
    found = []
    for (k, one), (j, other) in combinations(enumerate(place_all(layout)), 2):
        if has_vertex_inside(one, other) or has_vertex_inside(other, one):
            found.append(("overlap", (k, j)))
    return found + without(right(layout), "overlap")


@wrong
def looks_for_vertices_outside_only(layout: Layout) -> Answer:
    """Accept a part if all its vertices are inside the container."""
    shapes = place_all(layout)
    walls = list_walls(layout, shapes)
    found: Answer = [
        ("outside", (k,))
        for k, shape in enumerate(shapes)
        if any(has_vertex_inside(wall, shape) for wall in walls)
    ]
    answer = right(layout)
    kept = [one for one in without(answer, "outside") if one[0] == "overlap"]
    return kept + found + without(answer, "outside", "overlap")


@wrong
def looks_for_crossing_edges_only(layout: Layout) -> Answer:
    """Accept a part in the middle of another one."""
    shapes = place_all(layout)

    def crosses(k: int, j: int) -> bool:
        one, other = shapes[k], shapes[j]
        return has_vertex_inside(one, other) != all_vertices_inside(one, other)

    return [
        (kind, where)
        for kind, where in right(layout)
        if kind != "overlap"
        or crosses(*where)
        or not all_vertices_inside(shapes[where[0]], shapes[where[1]])
    ]


@wrong
def fills_the_holes_of_parts(layout: Layout) -> Answer:
    return right(with_parts(layout, lambda part: replace(part, holes=())))


@wrong
def takes_no_holes_of_rings_into_account_for_distances(layout: Layout) -> Answer:
    """Ignore the distance of a part in a hole from the ring around it."""
    shapes = place_all(layout)
    answer = right(layout)
    return [
        (kind, where)
        for kind, where in answer
        if kind != "too close" or len(where) < 2 or not is_in_a_hole(*(shapes[k] for k in where))
    ]


@wrong
def turns_clockwise(layout: Layout) -> Answer:
    return right(with_placements(layout, lambda p: replace(p, turn=turned_back(p.turn))))


@wrong
def mirrors_after_turning(layout: Layout) -> Answer:
    return right(
        with_placements(layout, lambda p: replace(p, turn=turned_back(p.turn)) if p.mirrored else p)
    )


@wrong
def does_not_mirror(layout: Layout) -> Answer:
    answer = right(with_placements(layout, lambda p: replace(p, mirrored=False)))
    return answer + [one for one in right(layout) if one[0] == "mirror"]


@wrong
def mirrors_up_and_down(layout: Layout) -> Answer:
    """Mirror y to -y, that is, x to -x and a half turn."""

    def flipped(p: Placement) -> Placement:
        if not p.mirrored or p.turn.exact is None:
            return p
        c, s = p.turn.exact
        return replace(p, turn=read_turn((-c, -s)))

    return right(with_placements(layout, flipped))


@wrong
def ignores_defects(layout: Layout) -> Answer:
    assert isinstance(layout.container, Region)
    return right(replace(layout, container=Region(layout.container.exterior)))


@wrong
def ignores_the_margin_to_defects(layout: Layout) -> Answer:
    assert isinstance(layout.container, Region)
    without_defects = replace(layout, container=Region(layout.container.exterior))
    answer = right(without_defects)
    return answer + [one for one in right(replace(layout, margin=Fraction(0))) if one not in answer]


@wrong
def takes_the_spacing_for_the_margin(layout: Layout) -> Answer:
    return right(replace(layout, margin=layout.spacing))


@wrong
def counts_demand_for_each_turn(layout: Layout) -> Answer:
    counted: dict[tuple[str, Turn], list[int]] = {}
    for k, placement in enumerate(layout.placements):
        counted.setdefault((placement.part, placement.turn), []).append(k)
    found: Answer = []
    for (id, _), where in counted.items():
        demand = layout.part_by_id[id].demand
        if demand is not None and len(where) != demand:
            found.append(("missing" if len(where) < demand else "surplus", tuple(where)))
    answer = right(layout)
    return (
        without(answer, "missing", "surplus", "turn", "mirror")
        + found
        + [one for one in answer if one[0] in ("turn", "mirror")]
    )


@wrong
def takes_demand_for_a_limit(layout: Layout) -> Answer:
    return without(right(layout), "missing")


@wrong
def allows_quarters_wherever_a_turn_is_allowed(layout: Layout) -> Answer:
    """Treat the list of rotations as steps, all multiples of which are allowed."""
    quarters = tuple(map(read_turn, (0, 90, 180, 270)))
    return right(
        with_parts(
            layout, lambda p: p if p.turns is None else replace(p, turns=(*p.turns, *quarters))
        )
    )


@wrong
def believes_that_parts_are_simple(layout: Layout) -> Answer:
    return without(right(layout), "shape")


def place_all(layout: Layout) -> list[Region]:
    return [
        place(layout, p) for p in layout.placements if layout.part_by_id[p.part].region is not None
    ]


def inside(shape: Region, points: Iterable[Point]) -> list[int]:
    return [point_in_polygon(p, shape) for p in points]


def has_vertex_inside(one: Region, other: Region) -> bool:
    return 1 in inside(one, other.vertices)


def all_vertices_inside(one: Region, other: Region) -> bool:
    return set(inside(one, other.vertices)) == {1} or set(inside(other, one.vertices)) == {1}


def is_in_a_hole(*pair: Region) -> bool:
    one, other = pair
    return any(
        classify(hole, inner, (0, 0)).verdict == "OVERLAP"
        for outer, inner in ((one, other), (other, one))
        for hole in outer.holes
    )


def answers(judge: Callable[[Layout], Answer], layout: Layout) -> Any:
    """Return the sorted answer of a judge, or its failure."""
    try:
        return sorted(judge(layout))
    except Exception as error:
        return type(error).__name__
