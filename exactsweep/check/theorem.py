"""Certificates as Coq theorems, proved by soundness and computation.

The first half of a file is the statement, with the numbers of the certificate; the second half is
the evidence, and a proof of one line. `proof/README.md` explains how to check it.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from exactsweep.check.claims import to_claim
from exactsweep.check.terms import POINT, SEGMENTS, Constructor, Nat, Record, Some

CLAIMS = {
    "no_fit": ("no_fit_polygon", "no_fit_polygon_sound", "check_no_fit_polygon"),
    "inner_fit": ("inner_fit_polygon", "inner_fit_polygon_sound", "check_inner_fit_polygon"),
    "sweep": ("sweep_of", "whole_sweep_sound", "check_whole_sweep"),
    "sum": ("path_sum", "path_sum_sound", "check_path_sum"),
    "faults": ("faulty", "faults_sound", "check_faults"),
    "layout": ("valid", "layout_valid", "check_entries"),
}
HEAD = """(* {title}

   Check it with: coqc -R PROOF Exactsweep {name}.v
   PROOF is the folder exactsweep/check/proof, after `make` there. *)
Require Import QArith ZArith List.
From Exactsweep Require Import Layout Faults NoFit InnerFit Sweep Claims.
From Exactsweep Require Statements.
Import ListNotations.

(* The statement.  Statements.v says what it means. *)
Open Scope Q_scope.
"""
ANSWER = """(* The answer of the checker. If it is false, Coq reports at Qed that the term has type
   "true = true" while it is expected to have type "accepted = true". *)
"""
TITLES = {
    "no_fit": "A no-fit polygon: exterior, holes, and exact fits.",
    "inner_fit": "An inner fit: regions, and exact fits.",
    "sweep": "A no-fit polygon, and the area swept along its exterior.",
    "sum": "The sum of a shape and a path.",
    "layout": "A valid layout.",
    "faults": "Faults of a layout.",
}


def write_theorem(certificate: Any, name: str = "certificate") -> str:
    """Write a certificate of version 3 as the theorem of a Coq file, given without its suffix.

    Coq accepts the file if and only if the checker in Coq accepts the certificate, which must
    conform to the schema. Raises TheoremError for other versions and claims that are not covered.
    """
    claim = to_claim(certificate)
    stated, sound, check = CLAIMS[claim.kind]
    question, names = " ".join(claim.statement), " ".join([*claim.statement, *claim.evidence])
    lines = [HEAD.format(title=TITLES[claim.kind], name=name)]
    lines += _define(claim.statement)
    lines += ["\n(* The evidence, in integers at a common denominator *)", "Open Scope Z_scope.\n"]
    lines += _define(claim.evidence)
    lines += [
        f"\n{ANSWER}Notation accepted :=\n  ({check} {names}).",
        f"\nTheorem proved : Statements.{stated} {question}.",
        f"Proof.\n  apply ({sound} {names}).",
        "  vm_cast_no_check (eq_refl true).\nQed.",
        "Print Assumptions proved.\n",
    ]
    return "\n".join(lines)


def _define(terms: dict[str, tuple[str, Any]]) -> list[str]:
    scopes = dict.fromkeys((POINT, SEGMENTS), "%Q")
    return [
        f"Definition {key} : {kind} :=\n  {_coq(term)}{scopes.get(kind, '')}."
        for key, (kind, term) in terms.items()
    ]


def _coq(term: Any) -> str:
    """Format a term in Coq syntax, with integers and rationals in the open scopes."""
    if isinstance(term, Some):
        return f"Some {_coq(term.value)}"
    if isinstance(term, Constructor):
        return f"({' '.join([term.name, *map(_coq, term.arguments)])})"
    if isinstance(term, Record):
        return "{| " + ";\n   ".join(f"{k} := {_coq(v)}" for k, v in term.fields.items()) + " |}"
    if isinstance(term, list):
        return f"[{'; '.join(map(_coq, term))}]"
    if isinstance(term, tuple):
        return f"({', '.join(map(_coq, term))})"
    if isinstance(term, Fraction):
        return (
            str(term.numerator)
            if term.denominator == 1
            else f"{term.numerator} # {term.denominator}"
        )
    if isinstance(term, Nat):
        return f"{int(term)}%nat"
    return (
        {None: "None", True: "true", False: "false"}[term]
        if term is None or type(term) is bool
        else str(term)
    )
