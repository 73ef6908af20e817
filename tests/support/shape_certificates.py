"""Certificates of polygons of any shape, written from the definition, and how to falsify them."""

import json
import marshal
from collections.abc import Iterator, Sequence
from fractions import Fraction
from random import Random
from typing import Any

from cells import Holed

from exactsweep import Point, Polygon, Region, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import to_fraction

Certificate = dict[str, Any]
Written = list[list[str]]


def write(points: Sequence[Point]) -> Written:
    return [[format_fraction(c) for c in p] for p in points]


def read(points: Written) -> list[Point]:
    return [Point(*map(to_fraction, p)) for p in points]


def outline(shape: Holed) -> dict[str, Any]:
    holes = [write(hole.vertices) for hole in shape.holes]
    return {"exterior": write(shape.exterior.vertices), "holes": holes}


def shape_in(written: dict[str, Any]) -> Holed:
    return Holed(Polygon(written["exterior"]), tuple(map(Polygon, written["holes"])))


def no_fit_certificate(d: Holed, g: Holed) -> Certificate:
    return _write(no_fit_polygon(_region(d), _region(g)))


def inner_fit_certificate(container: Holed, part: Holed) -> Certificate:
    return _write(inner_fit_polygon(_region(container), _region(part)))


def sweep_certificate(d: Holed, g: Holed) -> Certificate:
    return _write(sweep(_region(g), _region(d)))


def _region(shape: Holed) -> Region:
    return Region(shape.exterior, shape.holes)


def _write(answer: Any) -> Certificate:
    found: Certificate = json.loads(json.dumps(answer.certificate()))
    return found


def written_again(certificate: Certificate) -> Certificate:
    """The certificate that the input of another one should have."""
    if certificate["claim"] == "inner_fit":
        container, part = (shape_in(certificate[key]) for key in ("container", "part"))
        return inner_fit_certificate(container, part)
    d, g = (shape_in(certificate[key]) for key in ("directrix", "generatrix"))
    return (no_fit_certificate if certificate["claim"] == "no_fit" else sweep_certificate)(d, g)


# --- False ones ----------------------------------------------------------------------------------


def falsified(certificate: Certificate, rng: Random) -> Iterator[tuple[str, Certificate]]:
    """Every kind of single change, each with a name; none of them leaves the answer as it is."""
    for key in ("holes", "unswept", "regions", "exact_fits"):
        listed = certificate.get(key, [])
        for k in range(len(listed)):
            yield f"drop {key}[{k}]", {**certificate, key: listed[:k] + listed[k + 1 :]}
        if listed:
            yield f"repeat {key}[0]", {**certificate, key: [listed[0], *listed]}
        if len(listed) > 1:
            yield f"swap {key}", {**certificate, key: listed[::-1]}
    yield from _with_false_fits(certificate, rng)
    for place, loop in _loops(certificate):
        for name, false in _false_loops(loop, rng):
            yield f"{name} of {place}", _put(certificate, place, false)
    for hole in certificate.get("holes", []):
        fits = [[p, q] for p, q in zip(hole, [*hole[1:], hole[0]], strict=True)]
        fewer = [h for h in certificate["holes"] if h is not hole]
        listed = sorted(certificate["exact_fits"] + fits, key=read)
        yield "hole as a ring of fits", {**certificate, "holes": fewer, "exact_fits": listed}
        yield "hole as exterior", {**certificate, "exterior": hole}
        exchanged = [certificate["exterior"] if h is hole else h for h in certificate["holes"]]
        changed = {**certificate, "exterior": hole, "holes": sorted(exchanged, key=read)}
        yield "hole and exterior exchanged", changed
    if "area" in certificate:
        area = to_fraction(certificate["area"]) + 1
        yield "area", {**certificate, "area": format_fraction(area)}
        yield "inner is outer", {**certificate, "inner": certificate["outer"]}
        both = {"inner": certificate["outer"], "outer": certificate["inner"]}
        yield "inner and outer exchanged", {**certificate, **both}
        more = sorted([*certificate["unswept"], certificate["inner"]], key=read)
        yield "inner is unswept, too", {**certificate, "unswept": more}


def _with_false_fits(certificate: Certificate, rng: Random) -> Iterator[tuple[str, Certificate]]:
    fits = certificate["exact_fits"]

    def having(*new: Written, without: int | None = None) -> Certificate:
        kept = [fit for k, fit in enumerate(fits) if k != without]
        return {**certificate, "exact_fits": sorted([*kept, *new], key=read)}

    for k, fit in enumerate(fits):
        a, b = read(fit)
        middle = Point((a.x + b.x) / 2, (a.y + b.y) / 2)
        if a == b:
            yield "point grows", having(write([a, Point(a.x + 1, a.y)]), without=k)
            continue
        yield "fit cut short", having(write([a, middle]), without=k)
        yield "fit lengthened", having(write([a, _beyond(a, b)]), without=k)
        yield "fit in two parts", having(write([a, middle]), write([middle, b]), without=k)
        yield "fit the other way", having(write([b, a]), without=k)
        yield "end of a fit", having(write([b, b]))
        yield "part of a fit, too", having(write([middle, b]))
    loops = [read(loop) for _, loop in _loops(certificate)]
    if not loops:
        return
    for _ in range(3):
        p, q = rng.choice(rng.choice(loops)), rng.choice(rng.choice(loops))
        between = Point((p.x + q.x) / 2 + Fraction(1, 97), (p.y + q.y) / 2 + Fraction(1, 89))
        yield "position invented", having(write([between, between]))
        yield "fit invented", having(write([p, between]))
    far = Point(max(p.x for p in loops[0]) + 9, Fraction(0))
    yield "fit far away", having(write([far, far]))
    a, b = loops[0][:2]
    yield "edge as a fit, too", having(write([a, b]))


def _beyond(a: Point, b: Point) -> Point:
    return Point(b.x + (b.x - a.x) / 1000, b.y + (b.y - a.y) / 1000)


def _loops(certificate: Certificate) -> Iterator[tuple[tuple[Any, ...], Written]]:
    """The loops of the answer, and where they are."""
    for key in ("exterior", "inner", "outer"):
        if key in certificate:
            yield (key,), certificate[key]
    for key in ("holes", "unswept"):
        for k, loop in enumerate(certificate.get(key, [])):
            yield (key, k), loop
    for k, region in enumerate(certificate.get("regions", [])):
        yield ("regions", k, "exterior"), region["exterior"]
        for j, loop in enumerate(region["holes"]):
            yield ("regions", k, "holes", j), loop


def _put(certificate: Certificate, place: tuple[Any, ...], value: Any) -> Certificate:
    changed: Certificate = marshal.loads(marshal.dumps(certificate))
    at: Any = changed
    for key in place[:-1]:
        at = at[key]
    at[place[-1]] = value
    return changed


def _false_loops(loop: Written, rng: Random) -> Iterator[tuple[str, Written]]:
    yield "another start", loop[1:] + loop[:1]
    yield "the other orientation", [loop[0], *loop[:0:-1]]
    k = rng.randrange(len(loop))
    points = read(loop)
    p = points[k]
    for dx, dy in ((Fraction(1, 1000), 0), (0, Fraction(1, 1000)), (-1, 1)):
        moved = [*points[:k], Point(p.x + dx, p.y + dy), *points[k + 1 :]]
        least = moved.index(min(moved))
        yield f"vertex {k} moved", write(moved[least:] + moved[:least])
    if len(loop) > 3:
        fewer = points[:k] + points[k + 1 :]
        least = fewer.index(min(fewer))
        yield f"vertex {k} dropped", write(fewer[least:] + fewer[:least])
    q = points[(k + 1) % len(points)]
    middle = Point((p.x + q.x) / 2, (p.y + q.y) / 2)
    if k + 1 < len(points):
        yield "straight vertex", write([*points[: k + 1], middle, *points[k + 1 :]])
