"""The claims of certificates: their arguments in Coq, and where certificates contain them."""

from __future__ import annotations

import sys
from functools import reduce
from pathlib import Path
from typing import Any, NamedTuple

from exactsweep.check.standalone import FORMAT, PROVERS, VERSION, load, read
from exactsweep.theorem import readers
from exactsweep.theorem.layouts import read_faults, read_layout, read_normals, read_points
from exactsweep.theorem.terms import TheoremError, write_words

# Kinds of arguments: their types in Coq, and their readers
KINDS: dict[str, tuple[str, Any]] = {
    "rational": ("Q", readers.read_rational),
    "ring": ("ring", readers.read_ring),
    "rings": ("list ring", readers.read_rings),
    "shape": ("list ring", readers.read_shape),
    "path": ("ring", readers.read_path),
    "fits": ("list segment", readers.read_fits),
    "regions": ("list (ring * list ring)", readers.read_regions),
    "pieces": ("list ring", readers.read_pieces),
    "all_pieces": ("list (list ring)", readers.read_all_pieces),
    "frame": ("Q * Q * Q * Q", readers.read_frame),
    "sums": ("listed", readers.read_sums),
    "chains": ("list (list Z)", list),
    "cut": ("rational_cut", readers.cut_region),
    "cuts": ("list rational_cut", readers.cut_regions),
    "layout": ("Statements.layout", read_layout),
    "faults": ("list Statements.fault", read_faults),
    "points": ("ring", read_points),
    "entries": ("list entry", read_normals),
}

# Arguments by name: their kinds, and their keys in certificates if these differ from the names
_SHAPES = {"directrix": "shape", "generatrix": "shape"}
_LOOPS = {"exterior": "ring", "holes": "rings"}
_NO_FIT = {**_SHAPES, **_LOOPS, "exact_fits": "fits"}
_SWEPT = {"outer": "ring", "inner": "ring", "unswept": "rings", "slits": "fits proof.slits"}
_PIECES = {"still": "pieces proof.directrix", "moving": "pieces proof.generatrix"}
_SUMS = {"sums": "sums proof.sums", "cut": "cut exterior holes"}

# The name of each claim in Statements.v, the arguments of the statement, and the evidence, which is
# not trusted. The checker is `accept_KIND`, and its soundness theorem `KIND_accepted`.
CLAIMS = {
    "no_fit": ("no_fit_polygon", _NO_FIT, {**_PIECES, **_SUMS}),
    "sweep": (
        "sweep_of",
        {**_NO_FIT, **_SWEPT, "area": "rational"},
        {**_PIECES, **_SUMS, "swept": "sums proof.swept", "swept_cut": "cut outer unswept inner"},
    ),
    "sum": (
        "path_sum",
        {"shape": "shape", "path": "path", **_LOOPS, "slits": "fits proof.slits"},
        {"pieces": "pieces proof.shape", **_SUMS},
    ),
    "inner_fit": (
        "inner_fit_polygon",
        {"container": "shape", "part": "shape", "regions": "regions", "exact_fits": "fits"},
        {
            "frame": "frame proof.frame",
            "outside": "pieces proof.outside",
            "pieces": "pieces proof.part",
            "sums": "sums proof.sums",
            "around": "chains proof.around",
            "cuts": "cuts regions",
        },
    ),
    "layout": (
        "valid",
        {"layout": "layout *"},
        {
            "pieces": "all_pieces proof.pieces",
            "frame": "frame proof.frame",
            "entries": "entries proof.apart",
        },
    ),
    "faults": ("faulty", {"layout": "layout *", "faults": "faults *"}, {"points": "points faults"}),
}


class CoqClaim(NamedTuple):
    """A claim of a certificate: its kind, and its arguments by name, with types and terms."""

    kind: str
    statement: dict[str, tuple[str, Any]]
    evidence: dict[str, tuple[str, Any]]


def to_claim(certificate: Any) -> CoqClaim:
    """Return the claim of a certificate.

    Raises TheoremError for other versions or claims, and Refused if its form is wrong.
    """
    if (certificate["format"], certificate["version"]) != (FORMAT, VERSION):
        raise TheoremError(f"not a certificate of version {VERSION}")
    kind = certificate["claim"]
    if kind not in PROVERS:
        raise TheoremError("not a known claim")
    read("", certificate, PROVERS[kind][0])
    if kind == "layout" and certificate["valid"] is False:
        kind = "faults"
    statement, evidence = (
        {name: _read(certificate, *row.split(), name) for name, row in rows.items()}
        for rows in CLAIMS[kind][1:]
    )
    return CoqClaim(kind, statement, evidence)


def _read(certificate: Any, kind: str, *keys: str) -> tuple[str, Any]:
    places = keys[:-1] or keys
    values = (
        certificate if place == "*" else reduce(dict.get, place.split("."), certificate)
        for place in places
    )
    return KINDS[kind][0], KINDS[kind][1](*values)


def write_numbers(claim: CoqClaim) -> str:
    """Write a claim as the input of the extracted checker."""
    terms = tuple(term for part in claim[1:] for _, term in part.values())
    return " ".join([claim.kind, *write_words(terms)])


if __name__ == "__main__":
    print(write_numbers(to_claim(load(Path(sys.argv[1]).read_text(encoding="utf-8")))))
