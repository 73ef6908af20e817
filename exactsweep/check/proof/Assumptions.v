(* The assumptions of the main theorems: each line prints "Closed under the global context", that is, no axiom. *)
From Exactsweep Require Import HalfOpen RealPoints Layout Faults NoFit InnerFit Sweep Claims Certificates.
Print Assumptions disjoint_iff.
Print Assumptions real_overlap.
Print Assumptions real_at_least.
Print Assumptions rotation_error_sound.
Print Assumptions fits_iff.
Print Assumptions layout_sound.
Print Assumptions valid_exact.
Print Assumptions faults_sound.
Print Assumptions no_fit_sound.
Print Assumptions inner_fit_sound.
Print Assumptions sweep_sound.
Print Assumptions no_fit_polygon_sound.
Print Assumptions inner_fit_polygon_sound.
Print Assumptions whole_sweep_sound.
Print Assumptions path_sum_sound.
Print Assumptions locate_sound.
Print Assumptions no_fit_accepted.
Print Assumptions inner_fit_accepted.
Print Assumptions sweep_accepted.
Print Assumptions sum_accepted.
Print Assumptions layout_accepted.
Print Assumptions faults_accepted.
