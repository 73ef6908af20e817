(* The checker of no-fit polygons, and the theorem: what it accepts is the no-fit polygon. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers Pairs.
Import ListNotations.
Open Scope Q_scope.

(* The evidence: integer pieces of both shapes at a common denominator, and sum polygons. *)
Record no_fit_certificate := { unit : positive; still : list ring; moving : list ring; listed_sums : list listed }.

Section Check.
(* Further evidence, as any functions at all: no property of them is used.  See Pairs.v.
   `hint`: a normal of a line between two pieces of one shape. *)
Variables (hint : ring -> ring -> pt) (clear : ring -> ring -> side -> pt) (inner : ring -> qpoint)
  (side_cuts edge_cuts : side -> list Q).

Section Data.
Variables (D G loops : list Statements.ring) (fits : list side) (c : no_fit_certificate).
Let N := unit c.
Definition segments : list side := flat_map Statements.edges loops ++ fits.
Definition sum_sides : list (list side) := map (sides_of N) (listed_sums c).
Definition solid_D : solid := {| rings := int_rings (Zpos N) D; pieces := still c |}.
Definition solid_G : solid := {| rings := int_rings (Zpos N) G; pieces := moving c |}.
Definition pair_b (P Q : ring) : bool :=
  (Statements.winding loops (corner (inner P, inner Q)) =? 1)%Z && forallb (clear_b N clear P Q) segments.

Definition check_no_fit : bool :=
  all_integral (Zpos N) D && all_integral (Zpos N) G && all_integral (Zpos N) loops &&
  simple_solid hint solid_D && simple_solid hint solid_G &&
  all_pairs distinct_b (flat_map Statements.edges loops) &&
  forallb (piece_b N inner) (still c) && forallb (piece_b N inner) (moving c) &&
  forallb (fun P => forallb (pair_b P) (moving c)) (still c) &&
  forallb (sum_b N inner side_cuts (still c) (moving c) sum_sides segments) (listed_sums c) &&
  forallb (fun e => beside_b sum_sides (edge_cuts e) e) (flat_map Statements.edges loops) &&
  forallb (both_b edge_cuts sum_sides) fits.

Section Accepted.
Hypothesis ID : all_integral (Zpos N) D = true.
Hypothesis IG : all_integral (Zpos N) G = true.
Hypothesis IL : all_integral (Zpos N) loops = true.
Hypothesis SD : simple_solid hint solid_D = true.
Hypothesis SG : simple_solid hint solid_G = true.
Hypothesis Ds : all_pairs distinct_b (flat_map Statements.edges loops) = true.
Hypothesis PD : forall P, In P (still c) -> piece_b N inner P = true.
Hypothesis PG : forall Q, In Q (moving c) -> piece_b N inner Q = true.
Hypothesis Pairs : forall P Q, In P (still c) -> In Q (moving c) -> pair_b P Q = true.
Hypothesis Sums : forall s, In s (listed_sums c) ->
  sum_b N inner side_cuts (still c) (moving c) sum_sides segments s = true.
Hypothesis Beside : forall e, In e (flat_map Statements.edges loops) -> beside_b sum_sides (edge_cuts e) e = true.
Hypothesis Fits : forall e, In e fits -> both_b edge_cuts sum_sides e = true.

Lemma fan_still : fans (still c).
Proof. exact (proj1 (proj2 (simple_spec hint solid_D SD))). Qed.
Lemma fan_moving : fans (moving c).
Proof. exact (proj1 (proj2 (simple_spec hint solid_G SG))). Qed.

Lemma overlaps_iff t : Statements.overlaps_at D G t <-> exists P Q, In P (still c) /\ In Q (moving c) /\ shares N P Q t.
Proof.
  split.
  - intros (z & (e & E & A) & (e' & E' & B)).
    pose proof (A z (close_refl e z E)) as Az. pose proof (B z (close_refl e' z E')) as Bz.
    unfold Statements.inside in Az, Bz. rewrite winding_translate in Bz.
    apply (count_pieces N hint solid_D D z SD ID eq_refl) in Az as (P & IP & Az).
    apply (count_pieces N hint solid_G G _ SG IG eq_refl) in Bz as (Q & IQ & Bz).
    exists P, Q. split; [exact IP|]. split; [exact IQ|]. exists z. auto.
  - intros (P & Q & IP & IQ & z & Az & Bz). apply (overlap_of_point _ _ z).
    + apply (count_pieces N hint solid_D D z SD ID eq_refl). exists P. auto.
    + unfold Statements.inside. rewrite winding_translate.
      apply (count_pieces N hint solid_G G _ SG IG eq_refl). exists Q. auto.
Qed.

Lemma pair_spec P Q e : In P (still c) -> In Q (moving c) -> In e segments -> clear_b N clear P Q e = true.
Proof.
  intros IP IQ I. pose proof (Pairs P Q IP IQ) as H. unfold pair_b in H. apply andb_prop in H as (_ & H).
  rewrite forallb_forall in H. apply H, I.
Qed.

Lemma free t : Statements.on_any segments t -> ~ Statements.overlaps_at D G t.
Proof.
  intros (e & I & X) Ov. apply overlaps_iff in Ov as (P & Q & IP & IQ & Sh).
  exact (clear_free N clear P Q e t (fan_still P IP) (fan_moving Q IQ) (pair_spec P Q e IP IQ I) X Sh).
Qed.

Lemma once t : Statements.overlaps_at D G t -> Statements.winding loops t = 1%Z.
Proof.
  intro Ov. apply overlaps_iff in Ov as (P & Q & IP & IQ & Sh). pose proof (fan_still P IP) as FP. pose proof (fan_moving Q IQ) as FQ.
  pose proof (Pairs P Q IP IQ) as H. unfold pair_b in H. apply andb_prop in H as (H & _). apply Z.eqb_eq in H. rewrite <- H.
  apply (clear_constant N clear P Q); [exact FP|exact FQ|exact IL| |exact Sh|].
  - intros e I. apply (pair_spec P Q e IP IQ), in_or_app. left. exact I.
  - apply inner_shares; [exact FP|exact FQ|apply PD, IP|apply PG, IQ].
Qed.

Theorem accepted : Statements.no_fit_claim D G loops fits.
Proof.
  assert (Poly : forall S, In S sum_sides -> exists s, In s (listed_sums c) /\ S = sides_of N s).
  { intros S I. apply in_map_iff in I as (s & <- & I). exists s. auto. }
  assert (Convex : forall S, In S sum_sides -> convex S).
  { intros S I. destruct (Poly S I) as (s & J & ->). exact (proj1 (sum_polygon N inner side_cuts _ _ _ _ s (Sums s J))). }
  assert (Inner : forall S, In S sum_sides -> exists x, inS S x).
  { intros S I. destruct (Poly S I) as (s & J & ->).
    exact (proj1 (proj2 (proj2 (sum_polygon N inner side_cuts _ _ _ _ s (Sums s J))))). }
  assert (Sum : forall S t, In S sum_sides -> inS S t -> Statements.overlaps_at D G t).
  { intros S t I J. destruct (Poly S I) as (s & K & ->). apply overlaps_iff.
    exact (sum_shares N inner side_cuts _ _ _ _ s t fan_still fan_moving PD PG (Sums s K) J). }
  assert (Cover : forall S f x, In S sum_sides -> In f S -> o f x == 0 -> (forall g, In g S -> 0 <= o g x) ->
    U sum_sides x \/ L (flat_map Statements.edges loops) fits x).
  { intros S f x I F X0 X1. destruct (Poly S I) as (s & J & ->).
    destruct (sum_polygon N inner side_cuts _ _ _ _ s (Sums s J)) as (_ & Lk & _ & Cv).
    exact (Cv f x F (closed_on_side _ f x Lk F X0 X1)). }
  assert (Left : forall e x, In e (flat_map Statements.edges loops) -> Statements.on_segment e x ->
    exists S f, In S sum_sides /\ In f S /\ Statements.on_segment f x /\ (0 < rise e -> 0 < rise f) /\ (rise e < 0 -> rise f < 0))
    by (intros e x I X; exact (beside_b_spec sum_sides (edge_cuts e) e x (Beside e I) X)).
  assert (Both : forall e x, In e fits -> ~ rise e == 0 -> Statements.on_segment e x ->
    exists S f, In S sum_sides /\ In f S /\ Statements.on_segment f x /\ 0 < rise f)
    by (intros e x I R X; exact (both_left edge_cuts sum_sides e x (Fits e I) R X)).
  assert (Touch : forall e x, In e (flat_map Statements.edges loops ++ fits) -> Statements.on_segment e x ->
    exists S f, In S sum_sides /\ In f S /\ Statements.on_segment f x).
  { intros e x I X. apply in_app_or in I as [I|I].
    - destruct (Left e x I X) as (S & f & IS & IF & Of & _). exists S, f. auto.
    - exact (both_touch edge_cuts sum_sides e x (Fits e I) X). }
  unfold Statements.no_fit_claim. cbv zeta. fold segments. split.
  - apply (boundary sum_sides (flat_map Statements.edges loops) fits (Statements.overlaps_at D G) 1%Z
      Convex Sum free once (or_introl eq_refl) Cover Left Both (distinct_pairs _ Ds) Inner Touch).
    intro t. apply on_any_dec.
  - apply (core sum_sides (flat_map Statements.edges loops) fits (Statements.overlaps_at D G) 1%Z
      Convex Sum free once (or_introl eq_refl) Cover Left Both (distinct_pairs _ Ds)).
Qed.
End Accepted.

Theorem no_fit_sound : check_no_fit = true -> Statements.no_fit_claim D G loops fits.
Proof.
  unfold check_no_fit. intro H. repeat match type of H with _ && _ = true => let X := fresh "X" in apply andb_prop in H as (H & X) end.
  rewrite forallb_forall in X, X0, X1, X2, X3, X4.
  apply accepted; try assumption. intros P Q IP IQ. specialize (X2 P IP). rewrite forallb_forall in X2. exact (X2 Q IQ).
Qed.
End Data.
End Check.
