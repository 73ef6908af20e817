(* The checker of no-fit polygons, and the theorem: what it accepts is the no-fit polygon. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers Spans Sums SumsSound Pairs.
Import ListNotations.
Open Scope Q_scope.

(* The evidence: integer pieces of both shapes at a common denominator, and the listed sums, each with its
   number, i n + j for the pieces i and j, and a chain for each of its sides. *)
Record no_fit_certificate := {
  unit : positive; still : list ring; moving : list ring; listed_sums : list (nat * list (list Z)) }.

Section Data.
Variables (D G loops : list Statements.ring) (fits : list side) (c : no_fit_certificate).
Let N := unit c.
Definition solid_D : solid := {| rings := int_rings (Zpos N) D; pieces := still c |}.
Definition solid_G : solid := {| rings := int_rings (Zpos N) G; pieces := moving c |}.

Definition check_no_fit : bool :=
  all_integral (Zpos N) D && all_integral (Zpos N) G && all_integral (Zpos N) loops && forallb (integral_edge N) fits &&
  simple_solid solid_D && simple_solid solid_G && forallb is_convex (still c) && forallb is_convex (moving c) &&
  Sums.boundary (still c) (map turned (moving c)) [] (int_rings (Zpos N) loops) (map (int_edge N) fits) (listed_sums c) [] 1.

Section Accepted.
Hypothesis ID : all_integral (Zpos N) D = true.
Hypothesis IG : all_integral (Zpos N) G = true.
Hypothesis SD : simple_solid solid_D = true.
Hypothesis SG : simple_solid solid_G = true.
Hypothesis CD : forall P, In P (still c) -> is_convex P = true.
Hypothesis CG : forall Q, In Q (moving c) -> is_convex Q = true.

Definition at_sum (P H : ring) (t : qpoint) : Prop := shares N P (turned H) t.
Lemma turned_convex H : In H (map turned (moving c)) -> is_convex (turned H) = true.
Proof. intro I. apply in_map_iff in I as (Q & <- & I). rewrite turned_turned. exact (CG Q I). Qed.
Lemma fan_of r : is_convex r = true -> is_fan r = true.
Proof. intro H. exact (proj1 (is_convex_spec N r H)). Qed.

Lemma overlaps_iff t : Statements.overlaps_at D G t <-> O N (still c) (map turned (moving c)) [] at_sum t.
Proof.
  split.
  - intros (z & (e & E & A) & (e' & E' & B)).
    pose proof (A z (close_refl e z E)) as Az. pose proof (B z (close_refl e' z E')) as Bz.
    unfold Statements.inside in Az, Bz. rewrite winding_translate in Bz.
    apply (count_pieces N solid_D D z SD ID eq_refl) in Az as (P & IP & Az).
    apply (count_pieces N solid_G G _ SG IG eq_refl) in Bz as (Q & IQ & Bz).
    left. exists P, (turned Q). split; [exact IP|]. split; [apply in_map, IQ|].
    unfold at_sum. rewrite turned_turned. exists z. auto.
  - intros [(P & H & IP & IH & z & Az & Bz)|(f & [] & _)].
    apply in_map_iff in IH as (Q & <- & IQ). rewrite turned_turned in Bz. apply (overlap_of_point _ _ z).
    + apply (count_pieces N solid_D D z SD ID eq_refl). exists P. auto.
    + unfold Statements.inside. rewrite winding_translate.
      apply (count_pieces N solid_G G _ SG IG eq_refl). exists Q. auto.
Qed.
End Accepted.

Theorem no_fit_sound : check_no_fit = true -> Statements.no_fit_claim D G loops fits.
Proof.
  unfold check_no_fit. intro H. repeat match type of H with _ && _ = true => let X := fresh "X" in apply andb_prop in H as (H & X) end.
  rewrite forallb_forall in X0, X1. destruct (boundary_parts _ _ _ _ _ _ _ _ X) as (B1 & B2 & B3 & B4 & B5 & B6 & B7 & B8).
  pose proof (overlaps_iff H X6 X3 X2) as Ov.
  assert (Bd : forall P Q n t, In P (still c) -> In Q (map turned (moving c)) -> n <> (0, 0)%Z -> at_sum P Q t ->
    qdot n t * inject_Z (Zpos N) < inject_Z (most n P + most n Q)).
  { intros P Q n t IP IQ Nz T. apply shares_bound; [apply fan_of, X1, IP|apply fan_of, (turned_convex X0), IQ|exact Nz|exact T]. }
  assert (Ce : forall P Q, In P (still c) -> In Q (map turned (moving c)) -> at_sum P Q (third N (plus (center P) (center Q)))).
  { intros P Q IP IQ. apply shares_center; [exact (X1 P IP)|exact (turned_convex X0 Q IQ)]. }
  assert (Is : forall P Q t, In P (still c) -> In Q (map turned (moving c)) -> add P Q <> [] -> inS (map (qe N) (sum_sides P Q)) t -> at_sum P Q t).
  { intros P Q t IP IQ. apply shares_inside; [exact (X1 P IP)|exact (turned_convex X0 Q IQ)]. }
  pose proof (fun x => known_meet N loops fits x X5 X4) as Known.
  pose proof (fun z => winding_meet loops _ z (int_rings_meet N loops X5)) as Wind.
  unfold Statements.no_fit_claim. cbv zeta. split; intro t; rewrite Known.
  - etransitivity; [apply (boundary_limits N (still c) (map turned (moving c)) [] (int_rings (Zpos N) loops) (map (int_edge N) fits) (listed_sums c) [] 1%Z at_sum Bd Ce Is); try assumption|].
    + intros u (f & [] & _).
    + intros f x [].
    + intros f [].
    + left. reflexivity.
    + rewrite (Ov t). split; intros (Cl & NO); (split; [|exact NO]); intros e E; destruct (Cl e E) as (y & Y & Cy); exists y; (split; [apply Ov, Y|exact Cy]).
  - intro NL. rewrite Wind, (Ov t).
    apply (boundary_core N (still c) (map turned (moving c)) [] (int_rings (Zpos N) loops) (map (int_edge N) fits) (listed_sums c) [] 1%Z at_sum Bd Ce Is) in NL; try assumption.
    + intros u (f & [] & _).
    + intros f x [].
    + intros f [].
    + left. reflexivity.
Qed.
End Data.
