(* The checkers as an OCaml program.  Integers are those of zarith; booleans, lists, options and pairs are OCaml's own. *)
From Exactsweep Require Import Layout Faults NoFit InnerFit Sweep Claims.
From Exactsweep Require Statements.
Require Import Extraction ExtrOcamlBasic ExtrOcamlZBigInt ExtrOcamlNatInt.
Extraction Language OCaml.
Extraction "extracted/checker.ml" check_layout check_faults check_no_fit_polygon check_inner_fit_polygon check_whole_sweep check_path_sum.
