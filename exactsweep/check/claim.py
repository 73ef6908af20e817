"""Proving a certificate for polygons of any shape: its answer is found again, and compared.

The key `claim` of a certificate names one of these:

    no_fit      directrix, generatrix; exterior, holes, exact_fits: translations of the generatrix
    inner_fit   container, part; regions, exact_fits: translations of the part
    sweep       as no_fit, and kind, inner, outer, unswept, area: the area swept along the exterior

1. Input. `standalone` decides that D and G are polygons with holes: rings are simple, touch at most
   in points, holes lie inside the exterior and apart from each other, and the interior is
   connected.
2. Answer. `no_fit` finds it from the definition. It is unique, and there is one way to write it:
   loops begin with their least vertex, lists are sorted, numbers are in lowest terms. So a claim
   is right if and only if it is the same text. The message names the first entry that differs, and
   the witness is a vertex that just one of both has there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain, zip_longest
from typing import Any

from exactsweep.check import standalone
from exactsweep.check.monotone import has_shared_direction
from exactsweep.check.no_fit import find_inner_fit, find_no_fit, find_swept
from exactsweep.check.shape import Outlines
from exactsweep.check.standalone import (
    Node,
    Refused,
    Work,
    fields,
    items,
    least_first,
    place,
    under,
)
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import Loop, Point

_NO_FIT = "directrix", "generatrix", "exterior", "holes", "exact_fits"
_KEYS = {
    "no_fit": _NO_FIT,
    "inner_fit": ("container", "part", "regions", "exact_fits"),
    "sweep": (*_NO_FIT, "kind", "outer", "inner", "unswept", "area"),
}

# Steps to see that a ring is simple at a vertex, and where its edge is.
_VERTEX = 100


def prove_claim(certificate: dict[str, Any], max_steps: int) -> None:
    """Prove a certificate that has the key `claim`.

    Raises:
        Refused: the first thing that is wrong, with a witness.

    Cost: that of `reference_no_fit`, `reference_inner_fit` and `reference_swept`.
    """
    standalone.check_format(certificate)
    claim = certificate["claim"]
    if type(claim) is not str or claim not in _KEYS:
        raise Refused(f"claim is not {', '.join(_KEYS)}")
    fields(certificate, " ".join(_KEYS[claim]), "format version claim proof")
    work = Work(max_steps)
    names = _KEYS[claim][:2]
    d, g = shapes = [_read_shape(certificate[name], name) for name in names]
    _take_all_pairs(d, g, work)
    work.fit([_enter(d[0]), _enter(g[0])])
    for name, shape in zip(names, shapes, strict=True):
        _check_shape(name, shape, work)
    find = _find_inner_fit if claim == "inner_fit" else _find_no_fit
    for key, found in find(certificate, shapes, work):
        _compare(key, certificate[key], _write(found))


def _read_shape(item: Any, name: str) -> Outlines:
    exterior, holes = under(name, lambda shape: fields(shape, "exterior holes"), item)
    rings = [exterior, *under(f"{name}.holes", items, holes)]
    read = [under(f"{name}, ring {k}", least_first, ring) for k, ring in enumerate(rings)]
    return tuple(tuple(Point(*place(p)) for p in ring) for ring in read)


def _check_shape(name: str, shape: Outlines, work: Work) -> None:
    """Check that a shape is a polygon with holes, canonical and sorted."""
    rings = [*map(_enter, shape)]
    try:
        standalone.check_shape(rings, work)
    except Refused as refused:
        raise Refused(f"{name}: {refused}", shape[0][0]) from None
    if [*map(standalone.outline, rings)] != rings or [*shape[1:]] != sorted(shape[1:]):
        raise Refused(f"{name}: not canonical, or its holes are not sorted")


def _take_all_pairs(d: Outlines, g: Outlines, budget: Work) -> None:
    """Refuse at once what would take too long in any case: all vertices, and all pairs of edges."""
    m, n = (sum(map(len, rings)) for rings in (d, g))
    bits = max(c.bit_length() for ring in (*d, *g) for p in _enter(ring) for c in p)
    budget.take(_VERTEX * (m + n) + 3 * m * n + m * m + n * n, bits)


def _find_no_fit(
    certificate: dict[str, Any], shapes: Sequence[Outlines], budget: Work
) -> Iterator[tuple[str, Any]]:
    """Find the answer to the claims `no_fit` and `sweep`, each entry after the last is compared."""
    d, g = shapes
    no_fit = find_no_fit(d, g, budget)
    yield from no_fit._asdict().items()
    if certificate["claim"] == "no_fit":
        return
    if len(d) == len(g) == 1 and has_shared_direction([d[0], g[0]]):
        raise Refused("kind: there is a shared direction, so it is not SS")
    yield "kind", "SS"
    _take_all_pairs((no_fit.exterior,), g, budget)
    swept = find_swept(d, g, no_fit.exterior, budget)
    yield from swept._asdict().items()
    outer, *inside = map(_enter, (swept.outer, swept.inner, *swept.unswept))
    loops = [outer, *(points[::-1] for points in inside)]
    standalone.check_area(certificate["area"], loops, Work(standalone.MAX_STEPS))


def _find_inner_fit(
    _: dict[str, Any], shapes: Sequence[Outlines], budget: Work
) -> Iterator[tuple[str, Any]]:
    container, part = shapes
    found = find_inner_fit(container, part, budget)
    yield "regions", [{"exterior": outer, "holes": holes} for outer, holes in found.regions]
    yield "exact_fits", found.exact_fits


def _enter(points: Loop) -> list[Node]:
    return [standalone.node(*p) for p in points]


def _write(item: Any) -> Any:
    """Write an answer as certificates have it."""
    if isinstance(item, dict):
        return {key: _write(entry) for key, entry in item.items()}
    if isinstance(item, (str, Fraction)):
        return item if isinstance(item, str) else format_fraction(item)
    return [*map(_write, item)]


# --- Differences ---------------------------------------------------------------------------------


def _compare(name: str, claimed: Any, true: Any) -> None:
    """Raise Refused for the first entry of a list that differs, and a point that just one has."""
    if claimed == true:
        return
    if type(claimed) is not list or type(true) is not list:
        raise Refused(f"{name}: not {true if type(true) is str else 'a list'}")
    one, other = (dict.fromkeys(_list_points(item)) for item in (claimed, true))
    witness = next(
        chain((p for p in one if p not in other), (p for p in other if p not in one)), None
    )
    pairs = enumerate(zip_longest(claimed, true, fillvalue=()))
    k = next(k for k, pair in pairs if pair[0] != pair[1])
    if claimed[k : k + 1] and claimed[k] not in true:
        raise Refused(f"{name}[{k}]: not in the answer", witness)
    if true[k : k + 1] and true[k] not in claimed:
        raise Refused(f"{name}: one is missing", witness)
    raise Refused(f"{name}: not in order, or one is listed twice", witness)


def _list_points(item: Any, levels: int = 5) -> Iterator[Point]:
    """List the points in an answer, or a claim."""
    try:
        yield Point(*place(standalone.point(item)))
    except Refused:
        parts = item.values() if type(item) is dict else item if type(item) is list else ()
        for part in parts if levels else ():
            yield from _list_points(part, levels - 1)
