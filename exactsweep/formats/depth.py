"""Nesting of outlines: polygons, holes, polygons inside holes, and so on.

Outlines may cross, since parts may overlap; one inside two crossing outlines is ambiguous.
"""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import NamedTuple

from exactsweep.formats.candidate import Candidate
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.near import Bounds, BoxRows, bound_points
from exactsweep.geometry.overlap import contains
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region, common_lattice
from exactsweep.numbers.error import quote


class Nested(NamedTuple):
    # Rings inside an even number of others, with the rings directly inside as holes, and rings that
    # are not simple.
    outlines: list[Candidate]
    holes: list[tuple[Candidate, Candidate]]  # outlines read as holes, and the outlines around them
    islands: list[tuple[Candidate, Candidate]]  # polygons inside holes, and these holes
    # Outlines inside two crossing ones, not in `outlines`.
    ambiguous: list[tuple[Candidate, tuple[Candidate, Candidate]]]


def nest_candidates(outlines: Sequence[Candidate]) -> list[Candidate]:
    """Turn outlines at odd depth into holes; reject all if one, maybe a hole, is not simple."""
    plain = [outline for outline in outlines if not outline.ornament]
    try:
        for outline in plain:
            for ring in (outline, *outline.holes()):
                ring._replace(holes=tuple).polygon()
    except ValueError as error:
        reason = f"cannot nest the outlines: {error}"
        return [one if one.ornament else one.rejected(reason) for one in outlines]
    found = nest_outlines(plain)
    rejected = [one.rejected(describe_ambiguity(one, around)) for one, around in found.ambiguous]
    return [*found.outlines, *rejected, *(outline for outline in outlines if outline.ornament)]


def nest_lines(outlines: Sequence[Candidate]) -> list[Candidate]:
    """Turn the outlines of one shape into regions with holes; ambiguous ones stay separate."""
    found = nest_outlines(outlines)
    return [*found.outlines, *(outline for outline, _ in found.ambiguous)]


def separate_holes(outline: Candidate) -> tuple[Region, list[Region]]:
    """Read an outline; return holes that touch or cross other rings as regions."""
    try:
        return outline.region(), []
    except PolygonError:
        if not outline.holes():
            raise
        rings = [one._replace(holes=tuple) for one in (outline, *outline.holes())]
        exterior, *holes = [ring.region() for ring in rings]
        return exterior, holes


def describe_ambiguity(outline: Candidate, around: Sequence[Candidate]) -> str:
    one, other = (describe_place(ring) for ring in around)
    return f"{describe_place(outline)} is inside {one} and inside {other}, which cross"


def describe_place(outline: Candidate) -> str:
    if outline.name and quote(outline.name) not in outline.place:
        return f"{outline.place or 'outline'} {quote(outline.name)}"
    return outline.place or "the exterior"


def nest_outlines(outlines: Sequence[Candidate]) -> Nested:
    """Turn outlines, which may cross, into polygons with holes.

    An outline inside an odd number of others is a hole of the innermost one, otherwise a polygon.
    Of equal outlines inside the same polygon, the first is a hole and the others are polygons in
    it; other equal outlines are overlapping polygons.
    """
    rings: list[_OwnedRing] = []
    for outline in outlines:
        own = len(rings)
        for ring in (outline, *outline.holes()):
            plain = ring._replace(
                vertices=partial(list, ring.vertices()),
                holes=tuple,
                error=outline.error,
                rule=outline.rule,
            )
            owner = None if ring is outline else own
            rings.append(_OwnedRing(plain, _find_polygon(plain), owner))
    tree = _nest([ring.polygon for ring in rings])
    holes: defaultdict[int, list[int]] = defaultdict(list)
    exteriors: list[int] = []
    ambiguous, islands = [], []
    # For each group of equal rings, the depth directly inside, and the polygons with holes there.
    inside: dict[int, tuple[int, list[int]]] = {}
    for group in tree.groups:
        first = group[0]
        owners = {i: owner for i in group if (owner := rings[i].owner) is not None}
        others = [i for i in group if i not in owners]
        for i, owner in owners.items():
            holes[owner].append(i)
        if first in tree.crossings:
            one, other = tree.crossings[first]
            ambiguous += [
                (rings[i].outline, (rings[one].outline, rings[other].outline)) for i in others
            ]
            continue
        parent = tree.parents[first]
        depth, polygons = (0, []) if parent is None else inside[parent]
        if depth % 2:
            free = [k for k in polygons if k not in owners.values()]
            for i, k in zip(others, free, strict=False):
                holes[k].append(i)
            others = others[len(free) :]
            depth += bool(others)
        exteriors += others
        if parent is not None:
            islands += [(rings[i].outline, rings[parent].outline) for i in others]
        inside[first] = depth + 1, others or [*owners.values()]
    for i, found in enumerate(rings):
        if found.polygon is None and found.owner is None:
            exteriors.append(i)
        elif found.polygon is None and found.owner is not None:
            holes[found.owner].append(i)
    exteriors.sort()
    return Nested(
        [_join(rings, i, holes[i]) for i in exteriors],
        [
            (rings[k].outline, rings[i].outline)
            for i in exteriors
            for k in holes[i]
            if rings[k].owner is None
        ],
        islands,
        ambiguous,
    )


class _OwnedRing(NamedTuple):
    """A ring, its polygon if simple, and the index of its exterior if it is a given hole."""

    outline: Candidate
    polygon: Polygon | None
    owner: int | None


def _join(rings: Sequence[_OwnedRing], exterior: int, holes: Sequence[int]) -> Candidate:
    outline, inner = rings[exterior].outline, [rings[k].outline for k in holes]
    own = [rings[k].outline for k in holes if rings[k].owner is not None]
    others = [rings[k].outline for k in holes if rings[k].owner is None]
    return outline._replace(
        holes=partial(tuple, inner),
        error=max(one.error for one in (outline, *inner)),
        finer=partial(_find_finer, outline, own, others),
        rule="evenodd" if outline.rule and inner else outline.rule,
    )


def _find_finer(
    outline: Candidate, own: Sequence[Candidate], others: Sequence[Candidate], tolerance: Fraction
) -> Candidate | None:
    found = []
    for one in (outline, *others):
        finer = one.finer(tolerance) if one.finer else None if one.error else one
        if finer is None:
            return None
        found.append(finer)
    first, *holes = found
    holes += first.holes() if outline.finer else own
    if len(holes) != len(own) + len(others):
        return None
    error = max(one.error for one in found)
    return first._replace(holes=partial(tuple, holes), error=error)


def _find_polygon(ring: Candidate) -> Polygon | None:
    try:
        return ring.polygon()
    except ValueError:
        return None


class _Nesting(NamedTuple):
    """The nesting of polygons; the first of several equal ones represents all."""

    parents: dict[int, int | None]  # the innermost polygon around each one
    crossings: dict[int, tuple[int, int]]  # by polygon, two crossing polygons around it
    groups: list[list[int]]  # equal polygons, largest first


def _nest(rings: Sequence[Polygon | None]) -> _Nesting:
    polygons = {k: ring for k, ring in enumerate(rings) if ring is not None}
    order = sorted(polygons, key=lambda k: (-polygons[k].area, k))
    _, points = common_lattice([polygons[k] for k in order])
    shapes = dict(zip(order, points, strict=True))
    boxes = [*map(bound_points, points)]
    rows = BoxRows(boxes)
    parents: dict[int, int | None] = {}
    crossings: dict[int, tuple[int, int]] = {}
    groups: dict[int, list[int]] = {}
    for place, k in enumerate(order):
        # From small to large, skipping outlines known to contain the first one found.
        chain: set[int] = set()
        around: list[int] = []
        for i in sorted((i for i in rows.find(boxes[place]) if i < place), reverse=True):
            j = order[i]
            is_new = j in groups and j not in chain and _contains_box(boxes[i], boxes[place])
            if is_new and contains([shapes[j]], [shapes[k]]):
                around.append(j)
                if len(around) > 1 or polygons[j].area == polygons[k].area:
                    break
                chain = {*_list_parents(j, parents)}
        parent = around[0] if around else None
        if parent is not None and polygons[parent].area == polygons[k].area:
            groups[parent].append(k)
            continue
        groups[k], parents[k] = [k], parent
        if parent in crossings:
            crossings[k] = crossings[parent]
        elif len(around) > 1:
            crossings[k] = around[0], around[1]
    return _Nesting(parents, crossings, [*groups.values()])


def _list_parents(k: int, parents: Mapping[int, int | None]) -> Iterator[int]:
    parent = parents[k]
    while parent is not None:
        yield parent
        parent = parents[parent]


def _contains_box(outer: Bounds, inner: Bounds) -> bool:
    left, right, low, high = outer
    west, east, south, north = inner
    return left <= west and east <= right and low <= south and north <= high
