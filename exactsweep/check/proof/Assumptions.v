(* What the main theorems assume: each line prints "Closed under the global context", that is, no axiom. *)
From Exactsweep Require Import HalfOpen Layout Faults NoFit InnerFit Sweep Claims.
Print Assumptions disjoint_iff.
Print Assumptions layout_sound.
Print Assumptions valid_exact.
Print Assumptions overlap_refutes.
Print Assumptions no_fit_sound.
Print Assumptions inner_fit_sound.
Print Assumptions sweep_sound.
Print Assumptions no_fit_polygon_sound.
Print Assumptions inner_fit_polygon_sound.
Print Assumptions whole_sweep_sound.
Print Assumptions locate_sound.
Print Assumptions layout_valid.
