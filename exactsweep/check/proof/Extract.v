(* The checkers as an OCaml program, with the integers of zarith and OCaml's booleans, lists, options and pairs. *)
From Exactsweep Require Import Certificates.
Require Import Extraction ExtrOcamlBasic ExtrOcamlZBigInt ExtrOcamlNatInt.
Extraction Language OCaml.
Extraction "extracted/checker.ml" accept_no_fit accept_inner_fit accept_sweep accept_sum accept_by whole accept_faults.
