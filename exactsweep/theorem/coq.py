"""Certificates as Coq theorems, proved by soundness and computation."""

from __future__ import annotations

from typing import Any

from exactsweep.theorem.claims import CLAIMS, to_claim
from exactsweep.theorem.terms import write_coq

_FILE = """(* A certificate as a theorem. Check it with: coqc -R PROOF Exactsweep {name}.v
   PROOF is the folder exactsweep/check/proof, after `make` there. *)
Require Import QArith ZArith List.
From Exactsweep Require Import Certificates.
From Exactsweep Require Statements.
Import ListNotations.
Open Scope Q_scope.

(* The statement.  Statements.v says what it means. *)
{statement}
(* The evidence *)
{evidence}
(* The answer of the checker. If it is false, Coq reports at Qed that the term has type
   "true = true" while it is expected to have type "accepted = true". *)
Notation accepted :=
  (accept_{kind} {arguments}).

Theorem proved : Statements.{claim} {question}.
Proof.
  apply ({kind}_accepted {arguments}).
  vm_cast_no_check (eq_refl true).
Qed.
Print Assumptions proved.
"""


def write_theorem(certificate: Any, name: str = "certificate") -> str:
    """Write a certificate of version 3 as a theorem in a Coq file; `name` has no suffix.

    Coq accepts the file if and only if the checker in Coq accepts the certificate. Raises
    TheoremError for other versions and unknown claims, and Refused if the form is wrong.
    """
    kind, *parts = to_claim(certificate)
    statement, evidence = (
        "".join(
            f"Definition {key} : {coq} :=\n  {write_coq(term)}.\n"
            for key, (coq, term) in part.items()
        )
        for part in parts
    )
    return _FILE.format(
        name=name,
        kind=kind,
        claim=CLAIMS[kind][0],
        statement=statement,
        evidence=evidence,
        question=" ".join(parts[0]),
        arguments=" ".join([*parts[0], *parts[1]]),
    )
