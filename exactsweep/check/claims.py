"""Certificates as claims for the checker in Coq.

This module and `layout_claims` read the file, so answers of the extracted checker depend on them.
Vertices of pieces are multiplied by a common denominator.
"""

from __future__ import annotations

import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

from exactsweep.check.layout_claims import claim_layout
from exactsweep.check.standalone import FORMAT, VERSION, load
from exactsweep.check.terms import (
    POINT,
    SEGMENTS,
    CoqClaim,
    Nat,
    RationalPoint,
    Record,
    TheoremError,
    find_unit,
    read_fits,
    read_path,
    read_ring,
    read_rings,
    scale,
    write_numbers,
)

RINGS, RING = "list Statements.ring", "Statements.ring"
PATH = "list Statements.point"
REGIONS = "list (Statements.ring * list Statements.ring)"


def to_claim(certificate: Any) -> CoqClaim:
    """Return the claim of a certificate of version 3 that conforms to the schema.

    Raises TheoremError for other versions and claims that are not covered; see `claim_layout`.
    """
    kinds = {"no_fit": _no_fit, "sweep": _sweep, "sum": _sum, "inner_fit": _inner_fit}
    kinds["layout"] = claim_layout
    if (certificate["format"], certificate["version"]) != (FORMAT, VERSION):
        raise TheoremError(f"not a certificate of version {VERSION}")
    return kinds[certificate["claim"]](certificate)


def _no_fit(c: Any) -> CoqClaim:
    d, g, exterior, holes, fits = _answer(c)
    loops = [exterior, *(hole[::-1] for hole in holes)]
    known = _evidence(c["proof"], d, g, loops, fits)
    cut = _cut(known[1].fields["NoFit.unit"], exterior, holes)
    evidence = {"evidence": known, "cut": cut}
    return CoqClaim("no_fit", _question(d, g, exterior, holes, fits), evidence)


def _answer(c: Any) -> tuple[Any, ...]:
    fits = read_fits(c["exact_fits"])
    shapes = read_rings(c["directrix"]), read_rings(c["generatrix"])
    return *shapes, read_ring(c["exterior"]), [*map(read_ring, c["holes"])], fits


def _question(d: Any, g: Any, exterior: Any, holes: Any, fits: Any) -> dict[str, tuple[str, Any]]:
    found = {"directrix": (RINGS, d), "generatrix": (RINGS, g), "exterior": (RING, exterior)}
    return {**found, "holes": (RINGS, holes), "exact_fits": (SEGMENTS, fits)}


def _evidence(proof: Any, d: Any, g: Any, loops: Any, fits: Any) -> tuple[str, Record]:
    still, moving = ([*map(read_ring, proof[k])] for k in ("directrix", "generatrix"))
    unit = find_unit(*d, *g, *loops, *fits, *still, *moving)
    pieces = {"NoFit.still": scale(still, unit), "NoFit.moving": scale(moving, unit)}
    sums = _sums(proof["sums"])
    return "no_fit_certificate", Record({"NoFit.unit": unit, **pieces, "NoFit.listed_sums": sums})


def _sweep(c: Any) -> CoqClaim:
    d, g, exterior, holes, fits = _answer(c)
    proof, outer, inner = c["proof"], read_ring(c["outer"]), read_ring(c["inner"])
    unswept, slits = [*map(read_ring, c["unswept"])], read_fits(c["proof"]["slits"])
    swept = _swept(
        proof["generatrix"], proof["swept"], exterior, g, [outer, inner, *unswept], slits
    )
    statement = _question(d, g, exterior, holes, fits)
    statement |= {"outer": (RING, outer), "inner": (RING, inner), "unswept": (RINGS, unswept)}
    statement |= {"slits": (SEGMENTS, slits), "area": ("Q", Fraction(c["area"]))}
    around = [exterior, *(hole[::-1] for hole in holes)]
    known = _evidence(proof, d, g, around, fits)
    one, two, three = read_ring(proof["directrix"][0])[:3]
    middle = tuple((x + y + z) / 3 for x, y, z in zip(one, two, three, strict=True))
    evidence = {
        "evidence": known,
        "cut": _cut(known[1].fields["NoFit.unit"], exterior, holes),
    }
    unit = swept[1].fields["Sweep.unit"]
    evidence |= {"swept": swept, "swept_cut": _cut(unit, outer, [inner, *unswept])}
    return CoqClaim("sweep", statement, {**evidence, "middle": (POINT, middle)})


def _swept(
    pieces: Any, sums: Any, path: Any, shape: Any, loops: Any, slits: Any
) -> tuple[str, Record]:
    moving = [*map(read_ring, pieces)]
    unit = find_unit(path, *shape, *loops, *slits, *moving)
    found = {"Sweep.unit": unit, "Sweep.moving": scale(moving, unit)}
    return "sweep_certificate", Record({**found, "Sweep.listed_sums": _sums(sums)})


def _sum(c: Any) -> CoqClaim:
    proof, exterior, holes = c["proof"], read_ring(c["exterior"]), [*map(read_ring, c["holes"])]
    shape, path, slits = read_rings(c["shape"]), read_path(c["path"]), read_fits(proof["slits"])
    statement: dict[str, tuple[str, Any]] = {"shape": (RINGS, shape)}
    statement |= {"path": (PATH, path), "exterior": (RING, exterior), "holes": (RINGS, holes)}
    statement |= {"slits": (SEGMENTS, slits)}
    swept = _swept(proof["shape"], proof["sums"], path, shape, [exterior, *holes], slits)
    cut = _cut(swept[1].fields["Sweep.unit"], exterior, holes)
    return CoqClaim("sum", statement, {"evidence": swept, "cut": cut})


def _inner_fit(c: Any) -> CoqClaim:
    proof, container, part = c["proof"], read_rings(c["container"]), read_rings(c["part"])
    regions = [
        (read_ring(e["exterior"]), [*map(read_ring, e["holes"] or [])]) for e in c["regions"]
    ]
    fits, loops = read_fits(c["exact_fits"]), [ring for e, holes in regions for ring in (e, *holes)]
    outside, moving = ([*map(read_ring, proof[k])] for k in ("outside", "part"))
    ends = [Fraction(n) for n in proof["frame"]]
    unit = find_unit(*container, *part, *loops, *fits, *outside, *moving, [(n, n) for n in ends])
    statement: dict[str, tuple[str, Any]] = {"container": (RINGS, container)}
    statement |= {"part": (RINGS, part), "regions": (REGIONS, regions)}
    statement |= {"exact_fits": (SEGMENTS, fits)}
    found = {"InnerFit.unit": unit, "InnerFit.box": tuple(int(n * unit) for n in ends)}
    found |= {"InnerFit.outside": scale(outside, unit), "InnerFit.part": scale(moving, unit)}
    found |= {"InnerFit.listed_sums": _sums(proof["sums"])}
    found |= {"InnerFit.around": [_named(chain) for chain in proof["around"]]}
    cut = [_cut(unit, *region)[1] for region in regions]
    evidence = {"evidence": ("inner_fit_certificate", Record(found))}
    return CoqClaim("inner_fit", statement, {**evidence, "cut": ("list triangles", cut)})


def _cut(unit: int, exterior: Any, holes: Any) -> tuple[str, Any]:
    return "triangles", (_triangles(exterior, unit), [_triangles(hole, unit) for hole in holes])


def _triangles(loop: list[RationalPoint], unit: int) -> list[Any]:
    """Cut a loop into ears; return none if that fails, for example where the loop meets itself."""
    ((left,), found) = scale([loop], unit), []

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


def _sums(items: Any) -> list[Any]:
    return [(Nat(k), [_named(chain) for chain in chains]) for k, *chains in items]


def _named(item: Any) -> list[int]:
    return [item] if type(item) is int else item


if __name__ == "__main__":
    print(write_numbers(to_claim(load(Path(sys.argv[1]).read_text(encoding="utf-8")))))
