"""Certificates as input of the checker in Coq: terms, written as plain numbers or as Coq.

A term is an int (an integer in Coq), a Fraction (a rational), a `Nat`, a bool, a list, a tuple, a
`Record`, or a `Some` or None. Vertices of pieces are multiplied by a common denominator. An answer
of the extracted checker about a file rests on this module, which reads the file.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable
from fractions import Fraction
from itertools import chain
from math import ceil, lcm
from pathlib import Path
from typing import Any, NamedTuple

from exactsweep.check.standalone import FORMAT, VERSION, rotation_error
from exactsweep.numbers.error import ExactSweepError

RationalPoint = tuple[Fraction, Fraction]
AXES = ((1, 0), (0, 1), (-1, 0), (0, -1))
SLACK = 2**40  # errors of rotations are rounded up to one in so many of the common denominator


class TheoremError(ExactSweepError):
    """A certificate whose claim the checker in Coq does not cover."""


class Nat(int):
    """A natural number, of Coq's type nat."""


class Some(NamedTuple):
    """A value that may be missing."""

    value: Any


class Record(NamedTuple):
    """Named fields, in the order of the record in Coq."""

    fields: dict[str, Any]


class CoqClaim(NamedTuple):
    """A claim for the checker in Coq.

    `statement` are the arguments of the claim, by name and type; `evidence` the others, of which
    no property is used.
    """

    kind: str
    statement: dict[str, tuple[str, Any]]
    evidence: dict[str, tuple[str, Any]]


def to_claim(certificate: Any) -> CoqClaim:
    """Return the claim of a certificate of version 3 that is valid by the schema.

    A layout with faults has no claim here.
    """
    kinds = {"no_fit": _no_fit, "sweep": _sweep, "inner_fit": _inner_fit, "layout": _layout}
    if (certificate["format"], certificate["version"]) != (FORMAT, VERSION):
        raise TheoremError(f"not a certificate of version {VERSION}")
    return kinds[certificate["claim"]](certificate)


def write_numbers(claim: CoqClaim) -> str:
    """Return a claim as words that the extracted checker reads."""
    terms = [term for part in claim[1:] for _, term in part.values()]
    return " ".join([claim.kind, *(word for term in terms for word in _words(term))])


# --- Reading --------------------------------------------------------------------------------------


def _points(items: Any) -> list[RationalPoint]:
    return [(Fraction(x), Fraction(y)) for x, y in items]


def _ring(items: Any) -> list[RationalPoint]:
    points = _points(items)
    return [p for k, p in enumerate(points) if p != points[k - 1]]


def _fits(items: Any) -> list[tuple[RationalPoint, RationalPoint]]:
    return [(start, end) for start, end in map(_points, items)]


def _area(ring: list[RationalPoint]) -> Fraction:
    ends = zip(ring, ring[1:] + ring[:1], strict=True)
    return sum((p[0] * q[1] - p[1] * q[0] for p, q in ends), Fraction(0))


def _rings(shape: Any) -> list[list[RationalPoint]]:
    """Return the rings of a shape, the exterior counter-clockwise, holes clockwise."""
    rings = [_ring(shape["exterior"]), *map(_ring, shape.get("holes") or [])]
    return [e if (_area(e) > 0) != bool(k) else e[::-1] for k, e in enumerate(rings)]


def _sums(items: Any) -> list[Any]:
    return [(Nat(k), [_named(chain) for chain in chains]) for k, *chains in items]


def _named(item: Any) -> list[int]:
    return [item] if type(item) is int else item


def _unit(*rings: Iterable[RationalPoint]) -> int:
    return lcm(*(n.denominator for ring in rings for p in ring for n in p))


def _scaled(pieces: list[list[RationalPoint]], unit: int) -> list[Any]:
    return [[(int(x * unit), int(y * unit)) for x, y in ring] for ring in pieces]


# --- Claims ---------------------------------------------------------------------------------------

RINGS, RING, POINT = "list Statements.ring", "Statements.ring", "Statements.point"
REGIONS = "list (Statements.ring * list Statements.ring)"
SEGMENTS = "list (Statements.point * Statements.point)"


def _no_fit(c: Any) -> CoqClaim:
    d, g, exterior, holes, fits = _answer(c)
    loops = [exterior, *(hole[::-1] for hole in holes)]
    known = _evidence(c["proof"], d, g, loops, fits)
    cut = _cut(known[1].fields["NoFit.unit"], exterior, holes)
    evidence = {"evidence": known, "cut": cut}
    return CoqClaim("no_fit", _question(d, g, exterior, holes, fits), evidence)


def _answer(c: Any) -> tuple[Any, ...]:
    fits = _fits(c["exact_fits"])
    shapes = _rings(c["directrix"]), _rings(c["generatrix"])
    return *shapes, _ring(c["exterior"]), [*map(_ring, c["holes"] or [])], fits


def _question(d: Any, g: Any, exterior: Any, holes: Any, fits: Any) -> dict[str, tuple[str, Any]]:
    found = {"directrix": (RINGS, d), "generatrix": (RINGS, g), "exterior": (RING, exterior)}
    return {**found, "holes": (RINGS, holes), "exact_fits": (SEGMENTS, fits)}


def _evidence(proof: Any, d: Any, g: Any, loops: Any, fits: Any) -> tuple[str, Record]:
    still, moving = ([*map(_ring, proof[k])] for k in ("directrix", "generatrix"))
    unit = _unit(*d, *g, *loops, *fits, *still, *moving)
    pieces = {"NoFit.still": _scaled(still, unit), "NoFit.moving": _scaled(moving, unit)}
    sums = _sums(proof["sums"])
    return "no_fit_certificate", Record({"NoFit.unit": unit, **pieces, "NoFit.listed_sums": sums})


def _sweep(c: Any) -> CoqClaim:
    d, g, exterior, holes, fits = _answer(c)
    proof, outer, inner = c["proof"], _ring(c["outer"]), _ring(c["inner"])
    unswept, slits = [*map(_ring, c["unswept"])], _fits(c["proof"]["slits"])
    moving = [*map(_ring, proof["generatrix"])]
    unit = _unit(exterior, *g, outer, inner, *unswept, *slits, *moving)
    swept = {"Sweep.unit": unit, "Sweep.moving": _scaled(moving, unit)}
    swept["Sweep.listed_sums"] = _sums(proof["swept"])
    statement = _question(d, g, exterior, holes, fits)
    statement |= {"outer": (RING, outer), "inner": (RING, inner), "unswept": (RINGS, unswept)}
    statement |= {"slits": (SEGMENTS, slits), "area": ("Q", Fraction(c["area"]))}
    around = [exterior, *(hole[::-1] for hole in holes)]
    known = _evidence(proof, d, g, around, fits)
    one, two, three = _ring(proof["directrix"][0])[:3]
    middle = tuple((x + y + z) / 3 for x, y, z in zip(one, two, three, strict=True))
    evidence = {
        "evidence": known,
        "cut": _cut(known[1].fields["NoFit.unit"], exterior, holes),
    }
    evidence |= {"swept": ("sweep_certificate", Record(swept))}
    evidence |= {"swept_cut": _cut(unit, outer, [inner, *unswept])}
    return CoqClaim("sweep", statement, {**evidence, "middle": (POINT, middle)})


def _inner_fit(c: Any) -> CoqClaim:
    proof, container, part = c["proof"], _rings(c["container"]), _rings(c["part"])
    regions = [(_ring(e["exterior"]), [*map(_ring, e["holes"] or [])]) for e in c["regions"]]
    fits, loops = _fits(c["exact_fits"]), [ring for e, holes in regions for ring in (e, *holes)]
    outside, moving = ([*map(_ring, proof[k])] for k in ("outside", "part"))
    ends = [Fraction(n) for n in proof["frame"]]
    unit = _unit(*container, *part, *loops, *fits, *outside, *moving, [(n, n) for n in ends])
    statement: dict[str, tuple[str, Any]] = {"container": (RINGS, container)}
    statement |= {"part": (RINGS, part), "regions": (REGIONS, regions)}
    statement |= {"exact_fits": (SEGMENTS, fits)}
    found = {"InnerFit.unit": unit, "InnerFit.box": tuple(int(n * unit) for n in ends)}
    found |= {"InnerFit.outside": _scaled(outside, unit), "InnerFit.part": _scaled(moving, unit)}
    found |= {"InnerFit.listed_sums": _sums(proof["sums"])}
    found |= {"InnerFit.around": [_named(chain) for chain in proof["around"]]}
    cut = [_cut(unit, *region)[1] for region in regions]
    evidence = {"evidence": ("inner_fit_certificate", Record(found))}
    return CoqClaim("inner_fit", statement, {**evidence, "cut": ("list triangles", cut)})


def _cut(unit: int, exterior: Any, holes: Any) -> tuple[str, Any]:
    """Cut loops into triangles."""
    return "triangles", (_triangles(exterior, unit), [_triangles(hole, unit) for hole in holes])


def _triangles(loop: list[RationalPoint], unit: int) -> list[Any]:
    """Cut ears from a loop; none if there is none, as where it meets itself."""
    ((left,), found) = _scaled([loop], unit), []

    def turn(a: Any, b: Any, c: Any) -> int:
        return int((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))

    def is_ear(k: int) -> bool:
        a, b, c = left[k - 1], left[k], left[(k + 1) % len(left)]
        within = (
            turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0
            for p in left
            if p not in (a, b, c)
        )
        return turn(a, b, c) > 0 and not any(within)

    while len(left) > 2:
        k = next(filter(is_ear, range(len(left))), None)
        if k is None:
            return []
        found.append([left[k - 1], left[k], left[(k + 1) % len(left)]])
        del left[k]
    return found


def _rotation(turn: Any) -> Any:
    """Return cosine and sine, or degrees where these are irrational."""
    if type(turn) is list:
        return Fraction(turn[0]), Fraction(turn[1])
    degrees = Fraction("0" if turn is None else turn) % 360
    return degrees if degrees % 90 else tuple(map(Fraction, AXES[int(degrees) // 90]))


def _layout(c: Any) -> CoqClaim:
    if c["valid"] is not True:
        raise TheoremError("a layout with faults has no theorem")
    given, proof = c["layout"], c["proof"]
    parts, solids = given["parts"], [given.get("container"), *(given.get("defects") or [])]
    index = {part["id"]: k for k, part in enumerate(parts)}
    if len(index) != len(parts):
        raise TheoremError("two parts have one id")
    drawn, cut = [*map(_figure, parts)], [_pieces(e) for e in proof["pieces"]]
    sheet, obstacles = solids[0] and _figure(solids[0]), [*map(_figure, solids[1:])]
    outside, *cut_obstacles = map(_pieces, proof["outside"])
    allowed = [[*map(_rotation, part.get("turns") or [])] for part in parts]
    moves = [
        _moved(*one, index, drawn, allowed)
        for one in zip(given["placements"], c["turns"], strict=True)
    ]
    placed = [_placed(motion, drawn[k]) for k, motion, _ in moves]
    pieces = [[_move(motion, ring) for ring in cut[k]] for k, motion, _ in moves]
    frame = [Fraction(n) for n in proof.get("frame") or [0] * 4]
    gaps = {key: Fraction(given.get(key) or 0) for key in ("spacing", "margin")}
    every = [*placed, *drawn, *obstacles, *([sheet] if sheet else [])]
    points = [ring for one in every for ring in one.rings()]
    numbers = [*gaps.values(), *frame, *(n for one in every for n in one.numbers())]
    rings = [*points, *chain(*pieces, *cut, *cut_obstacles), *outside]
    unit = _unit(*rings, [(n, n) for n in numbers]) * (SLACK if any(s for *_, s in moves) else 1)
    layout = {
        "sheet": Some(sheet.term()) if sheet else None,
        "obstacles": [one.term() for one in obstacles],
        "kinds": [_part(*one) for one in zip(parts, drawn, allowed, strict=True)],
        "placements": [_placement(k, to, Fraction(ceil(e * unit), unit)) for k, to, e in moves],
        **gaps,
    }
    found = {"Layout.denominator": unit, "Layout.part_pieces": [_scaled(e, unit) for e in pieces]}
    found |= {"Layout.kind_pieces": [_scaled(e, unit) for e in cut]}
    found |= {"Layout.obstacle_pieces": [_scaled(e, unit) for e in cut_obstacles]}
    found |= {"Layout.outside_pieces": _scaled(outside, unit)}
    found |= {"Layout.frame": tuple(int(n * unit) for n in frame)}
    normals = [(*key, _whole(x, y)) for *key, x, y in proof["apart"]]
    evidence = {"evidence": ("certificate", Record(found)), "entries": ("list entry", normals)}
    return CoqClaim("layout", {"layout": ("Statements.layout", _record(layout))}, evidence)


class _Figure(NamedTuple):
    """A shape: its rings, or else its rounded pieces (points and radius), and its error."""

    outline: list[list[RationalPoint]]
    rounded: list[tuple[list[RationalPoint], Fraction]]
    error: Fraction

    def rings(self) -> list[list[RationalPoint]]:
        return self.outline + [points for points, _ in self.rounded]

    def numbers(self) -> list[Fraction]:
        return [self.error, *(radius for _, radius in self.rounded)]

    def term(self) -> Record:
        return _record(self._asdict())


def _record(fields: dict[str, Any]) -> Record:
    return Record({f"Statements.{key}": value for key, value in fields.items()})


def _figure(item: Any) -> _Figure:
    error = Fraction(item.get("error") or 0)
    if item.get("pieces") is None:
        return _Figure(_rings(item), [], error)
    if item.get("exterior") is not None or item.get("holes"):
        raise TheoremError("a shape with rings and pieces")
    rounded = [(_points(e["points"]), Fraction(e.get("radius") or 0)) for e in item["pieces"]]
    return _Figure([], rounded, error)


def _pieces(items: Any) -> list[list[RationalPoint]]:
    return [_ring(e) for e in items or []]


def _moved(item: Any, turn: Any, index: Any, drawn: Any, allowed: Any) -> tuple[int, Any, Fraction]:
    """Return the part, the motion and the error of the rotation of a placement.

    A rational rotation that stands for an irrational one that is allowed is allowed, too.
    """
    k, asked, to = index[item["part"]], _rotation(item.get("turn")), _rotation(turn)
    slack = Fraction(0)
    if asked != to:  # irrational, or refused
        far = max(abs(x) + abs(y) for ring in drawn[k].rings() for x, y in ring)
        slack = far * rotation_error(to, asked) if type(asked) is Fraction else Fraction(-1)
        allowed[k] += [to] * (asked in allowed[k])
    return k, (bool(item.get("mirrored")), *to, _points([item["move"]])[0]), slack


def _placed(motion: Any, figure: _Figure) -> _Figure:
    rounded = [(_move(motion, points), radius) for points, radius in figure.rounded]
    return _Figure([_move(motion, ring) for ring in figure.outline], rounded, figure.error)


def _move(motion: Any, ring: list[RationalPoint]) -> list[RationalPoint]:
    flag, c, s, (u, v) = motion
    points = [(-x if flag else x, y) for x, y in (ring[::-1] if flag else ring)]
    return [(c * x - s * y + u, s * x + c * y + v) for x, y in points]


def _part(part: Any, drawn: _Figure, allowed: list[Any]) -> Record:
    demand, turns = part.get("demand"), [e for e in allowed if type(e) is tuple]
    rules = {"demand": None if demand is None else Some(Nat(demand))}
    rules |= {"rotations": None if part.get("turns") is None else Some(turns)}
    return _record({"form": drawn.term(), **rules, "may_mirror": part.get("mirrored") is not False})


def _placement(kind: int, motion: Any, slack: Fraction) -> Record:
    names = ("mirrored", "cosine", "sine", "shift")
    by_motion = _record(dict(zip(names, motion, strict=True)))
    return _record({"kind": Nat(kind), "by_motion": by_motion, "slack": slack})


def _whole(x: str, y: str) -> tuple[int, int]:
    """Return a normal as two integers."""
    unit = lcm(Fraction(x).denominator, Fraction(y).denominator)
    return int(Fraction(x) * unit), int(Fraction(y) * unit)


# --- Plain numbers --------------------------------------------------------------------------------


def _words(term: Any) -> Iterable[str]:
    if isinstance(term, Some):
        return ["1", *_words(term.value)]
    if isinstance(term, Record):
        return [word for value in term.fields.values() for word in _words(value)]
    if isinstance(term, list):
        return [str(len(term)), *(word for value in term for word in _words(value))]
    if isinstance(term, tuple):
        return [word for value in term for word in _words(value)]
    if isinstance(term, Fraction):
        return [f"{term.numerator}/{term.denominator}"]
    return ["0" if term is None else str(int(term))]


if __name__ == "__main__":
    print(write_numbers(to_claim(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")))))
