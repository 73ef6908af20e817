(* The checkers accept: three small cases, computed by Coq itself. *)
Require Import QArith ZArith List Bool.
From Exactsweep Require Import Cancel Pieces Solid Gaps Layout Nearby PiecePoints Covers Pairs NoFit.
From Exactsweep Require Statements.
Import ListNotations.
Open Scope Z_scope.

Definition square : Statements.ring := [(0, 0); (1, 0); (1, 1); (0, 1)]%Q.
Definition unit_square : ring := [(0, 0); (1, 0); (1, 1); (0, 1)].

(* Two unit squares, one of them rotated by a right angle, half a unit apart in a sheet of 3 by 1. *)
Definition two_squares : Statements.layout :=
  {| Statements.sheet := [[(0, 0); (3, 0); (3, 1); (0, 1)]%Q]; Statements.obstacles := [];
     Statements.kinds := [{| Statements.outline := [square]; Statements.demand := Some 2%nat;
       Statements.rotations := Some [(1, 0); (0, 1)]%Q; Statements.may_mirror := false |}];
     Statements.placements := [(0%nat, {| Statements.mirrored := false; Statements.cosine := 1; Statements.sine := 0; Statements.shift := (0, 0)%Q |});
       (0%nat, {| Statements.mirrored := false; Statements.cosine := 0; Statements.sine := 1; Statements.shift := (5 # 2, 0)%Q |})];
     Statements.spacing := 1 # 2; Statements.margin := 0 |}.
Definition evidence : certificate :=
  {| denominator := 2;
     part_pieces := [[[(0, 0); (2, 0); (2, 2); (0, 2)]]; [[(5, 0); (5, 2); (3, 2); (3, 0)]]];
     obstacle_pieces := [];
     outside_pieces := [[(-2, -2); (8, -2); (6, 0); (0, 0)]; [(8, -2); (8, 4); (6, 2); (6, 0)];
       [(8, 4); (-2, 4); (0, 2); (6, 2)]; [(-2, 4); (-2, -2); (0, 0); (0, 2)]];
     bounds := (-2, -2, 8, 4) |}.
(* A normal between two pieces: along an axis, where their boxes are apart *)
Definition axis (p q : ring) : pt :=
  match find (fun n => far 0 n p q) [(1, 0); (-1, 0); (0, 1); (0, -1)] with Some n => n | None => (1, 0) end.

Example layout_accepted : check_layout axis two_squares evidence = true.
Proof. vm_compute. reflexivity. Qed.
Example layout_valid : Statements.valid two_squares.
Proof. exact (layout_sound axis _ _ layout_accepted). Qed.

(* The no-fit polygon of two unit squares *)
Definition loop : Statements.ring := [(-1 # 1, -1 # 1); (1, -1 # 1); (1, 1); (-1 # 1, 1)]%Q.
Definition sum : listed := {| first := unit_square; second := unit_square;
  corners := [((0, 0), (1, 1)); ((1, 0), (0, 1)); ((1, 1), (0, 0)); ((0, 1), (1, 0))] |}.
Definition no_fit_evidence : no_fit_certificate :=
  {| unit := 1; still := [unit_square]; moving := [unit_square]; listed_sums := [sum] |}.
(* A normal of a line between the open square of side 2 around 0 and a segment *)
Definition clear (P Q : ring) (e : side) : pt :=
  match find (fun n => Qle_bool 1 (qdot n (fst e)) && Qle_bool 1 (qdot n (snd e))) [(1, 0); (-1, 0); (0, 1); (0, -1)]
  with Some n => n | None => (1, 0) end.
Definition center (_ : ring) : Statements.point := (1 # 2, 1 # 2).
Definition no_cuts (_ : side) : list Q := [].

Example no_fit_accepted :
  check_no_fit axis clear center no_cuts no_cuts [square] [square] [loop] [] no_fit_evidence = true.
Proof. vm_compute. reflexivity. Qed.
Example no_fit_square : Statements.no_fit_claim [square] [square] [loop] [].
Proof. exact (no_fit_sound _ _ _ _ _ _ _ _ _ _ no_fit_accepted). Qed.

(* A ring that goes twice around is rejected, although its pieces cancel to it. *)
Example twice_rejected :
  is_solid {| rings := [unit_square; unit_square]; pieces := [unit_square; unit_square] |} = true /\
  simple_solid axis {| rings := [unit_square; unit_square]; pieces := [unit_square; unit_square] |} = false.
Proof. vm_compute. split; reflexivity. Qed.
