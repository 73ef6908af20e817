(* Small cases, computed by Coq. *)
Require Import QArith ZArith List Bool.
From Exactsweep Require Import Cancel Pieces Solid Gaps Layout NoFit Sums.
From Exactsweep Require Statements.
Import ListNotations.
Open Scope Z_scope.

Definition square : Statements.ring := [(0, 0); (1, 0); (1, 1); (0, 1)]%Q.
Definition unit_square : ring := [(0, 0); (1, 0); (1, 1); (0, 1)].
Definition no_normals (_ _ _ _ : nat) : pt := (0, 0).
Definition no_outside_normals (_ : Z) : nat -> nat -> nat -> pt := fun _ _ _ => (0, 0).

(* Two unit squares at distance 1/2 in a 3 by 1 sheet, one of them rotated by a right angle; and a disc of radius 1/2 at
   the center of a 1 by 1 sheet, which touches all its sides. *)
Definition still (u v : Q) : Statements.motion :=
  {| Statements.mirrored := false; Statements.cosine := 1; Statements.sine := 0; Statements.shift := (u, v) |}.
Definition rings_only (rs : list Statements.ring) : Statements.figure :=
  {| Statements.outline := rs; Statements.rounded := []; Statements.error := 0 |}.
Definition two_squares : Statements.layout :=
  {| Statements.sheet := Some (rings_only [[(0, 0); (3, 0); (3, 1); (0, 1)]%Q]); Statements.obstacles := [];
     Statements.kinds := [{| Statements.form := rings_only [square]; Statements.demand := Some 2%N;
       Statements.rotations := Some [Statements.Rational 1 0; Statements.Rational 0 1]; Statements.mirrored_rotations := None; Statements.may_mirror := false |}];
     Statements.placements := [
       {| Statements.kind := 0; Statements.by_motion := still 0 0; Statements.degrees := None; Statements.slack := 0 |};
       {| Statements.kind := 0; Statements.by_motion :=
         {| Statements.mirrored := false; Statements.cosine := 0; Statements.sine := 1; Statements.shift := (5 # 2, 0)%Q |}; Statements.degrees := None; Statements.slack := 0 |}];
     Statements.spacing := 1 # 2; Statements.margin := 0 |}.
Definition evidence : certificate :=
  {| denominator := 2;
     part_pieces := [[[(0, 0); (2, 0); (2, 2); (0, 2)]]; [[(5, 0); (5, 2); (3, 2); (3, 0)]]];
     kind_pieces := [[[(0, 0); (2, 0); (2, 2); (0, 2)]]]; obstacle_pieces := [];
     outside_pieces := [[(-2, -2); (8, -2); (6, 0); (0, 0)]; [(8, -2); (8, 4); (6, 2); (6, 0)];
       [(8, 4); (-2, 4); (0, 2); (6, 2)]; [(-2, 4); (-2, -2); (0, 0); (0, 2)]];
     frame := (-2, -2, 8, 4) |}.
Example layout_accepted : check_layout no_normals no_outside_normals two_squares evidence = true.
Proof. vm_compute. reflexivity. Qed.
Example layout_valid : Statements.valid two_squares.
Proof. exact (layout_sound _ _ _ _ layout_accepted). Qed.

Definition disc_in (container : Statements.figure) (margin : Q) : Statements.layout :=
  {| Statements.sheet := Some container; Statements.obstacles := [];
     Statements.kinds := [{| Statements.form := {| Statements.outline := []; Statements.rounded := [([(0, 0)%Q], 1 # 2)]; Statements.error := 0 |};
       Statements.demand := None; Statements.rotations := None; Statements.mirrored_rotations := None; Statements.may_mirror := true |}];
     Statements.placements := [{| Statements.kind := 0; Statements.by_motion := still (1 # 2) (1 # 2); Statements.degrees := None; Statements.slack := 0 |}];
     Statements.spacing := 0; Statements.margin := margin |}.
Definition disc_evidence : certificate :=
  {| denominator := 4; part_pieces := [[]]; kind_pieces := [[]]; obstacle_pieces := [];
     outside_pieces := [[(-4, -4); (8, -4); (4, 0); (0, 0)]; [(8, -4); (8, 8); (4, 4); (4, 0)];
       [(8, 8); (-4, 8); (0, 4); (4, 4)]; [(-4, 8); (-4, -4); (0, 0); (0, 4)]];
     frame := (-4, -4, 8, 8) |}.
Example disc_valid : Statements.valid (disc_in (rings_only [square]) 0).
Proof. apply (layout_sound no_normals no_outside_normals _ disc_evidence). vm_compute. reflexivity. Qed.
Example disc_too_close : check_layout no_normals no_outside_normals (disc_in (rings_only [square]) (1 # 4)) disc_evidence = false.
Proof. vm_compute. reflexivity. Qed.

(* A disc as the container: a disc fits with margin 1/4, but not 1/3. *)
Definition dish : Statements.figure :=
  {| Statements.outline := []; Statements.rounded := [([(1 # 2, 1 # 2)], 3 # 4)]; Statements.error := 0 |}.
Definition no_frame : certificate := {| denominator := 12; part_pieces := [[]]; kind_pieces := [[]]; obstacle_pieces := []; outside_pieces := []; frame := (0, 0, 0, 0) |}.
Example disc_in_dish : Statements.valid (disc_in dish (1 # 4)).
Proof. apply (layout_sound no_normals no_outside_normals _ no_frame). vm_compute. reflexivity. Qed.
Example dish_too_small : check_layout no_normals no_outside_normals (disc_in dish (1 # 3)) no_frame = false.
Proof. vm_compute. reflexivity. Qed.

(* The no-fit polygon of two unit squares: one sum, with each side on one edge of the loop *)
Definition loop : Statements.ring := [(-1 # 1, -1 # 1); (1, -1 # 1); (1, 1); (-1 # 1, 1)]%Q.
Definition no_fit_evidence : no_fit_certificate :=
  {| unit := 1; NoFit.still := [unit_square]; moving := [unit_square]; listed_sums := [(0, [[-1]; [-2]; [-3]; [-4]])] |}.
Example no_fit_square : Statements.no_fit_claim [square] [square] [loop] [].
Proof. apply (no_fit_sound _ _ _ _ no_fit_evidence). vm_compute. reflexivity. Qed.

(* A ring with winding number 2 is rejected, although pieces cancel to it. *)
Example twice_rejected :
  is_solid {| rings := [unit_square; unit_square]; pieces := [unit_square; unit_square] |} = true /\
  simple_solid {| rings := [unit_square; unit_square]; pieces := [unit_square; unit_square] |} = false.
Proof. vm_compute. split; reflexivity. Qed.
