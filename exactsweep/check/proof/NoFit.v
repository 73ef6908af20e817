(* The checker of no-fit polygons, and its theorem. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Convex Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers Spans Sums SumsSound Pairs.
Import ListNotations.
Open Scope Q_scope.

(* The evidence: integer pieces of both shapes at a common denominator, and the listed sums, each with its number
   (i n + j for pieces i and j) and a chain for each of its sides. *)
Record no_fit_certificate := {
  unit : positive; still : list ring; moving : list ring; listed_sums : list (Z * list (list Z)) }.

Section Data.
Variables (D G loops : list Statements.ring) (fits : list side) (c : no_fit_certificate).
Let N := unit c.
Definition solid_D : solid := {| rings := int_rings (Zpos N) D; pieces := still c |}.
Definition solid_G : solid := {| rings := int_rings (Zpos N) G; pieces := moving c |}.

Definition check_no_fit : bool :=
  all_integral (Zpos N) D && all_integral (Zpos N) G && all_integral (Zpos N) loops && forallb (integral_edge N) fits &&
  simple_solid solid_D && simple_solid solid_G &&
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
  rename X4 into X6, X3 into X5, X2 into X4, X1 into X3, X0 into X2.
  pose proof (fun P => simple_convex solid_D P X3 : In P (still c) -> is_convex P = true) as X1.
  pose proof (fun P => simple_convex solid_G P X2 : In P (moving c) -> is_convex P = true) as X0. destruct (boundary_parts _ _ _ _ _ _ _ _ X) as (B1 & B2 & B3 & Bw & B4 & B5 & B6 & B7 & B8).
  pose proof (overlaps_iff H X6 X3 X2) as Ov.
  assert (Bd : forall P Q n t, In P (still c) -> In Q (map turned (moving c)) -> n <> (0, 0)%Z -> at_sum P Q t ->
    qdot n t * inject_Z (Zpos N) < inject_Z (most n P + most n Q)).
  { intros P Q n t IP IQ Nz T. apply shares_bound; [apply fan_of, X1, IP|apply fan_of, (turned_convex X0), IQ|exact Nz|exact T]. }
  assert (Ce : forall P Q, In P (still c) -> In Q (map turned (moving c)) -> at_sum P Q (third N (plus (center P) (center Q)))).
  { intros P Q IP IQ. apply shares_center; [exact (X1 P IP)|exact (turned_convex X0 Q IQ)]. }
  assert (Is : forall P Q t, In P (still c) -> In Q (map turned (moving c)) -> add P Q <> [] -> inS (map (qe N) (sum_sides P Q)) t -> at_sum P Q t).
  { intros P Q t IP IQ. apply shares_inside; [exact (X1 P IP)|exact (turned_convex X0 Q IQ)]. }
  assert (Cm : (forall P P' Q v, In P (still c) -> In P' (still c) -> In Q (map turned (moving c)) -> In v P -> In v P' ->
      exists t, at_sum P Q t /\ at_sum P' Q t) /\ (are_segments (still c) = false -> forall P Q Q' v, In P (still c) ->
      In Q (map turned (moving c)) -> In Q' (map turned (moving c)) -> In v Q -> In v Q' -> exists t, at_sum P Q t /\ at_sum P Q' t)).
  { split.
    - intros P P' Q v I I' IQ V V'. exact (shares_common_first N P P' _ v (X1 P I) (X1 P' I') (turned_convex X0 Q IQ) V V').
    - intros _ P Q Q' v IP I I' V V'. exact (shares_common N P Q Q' v (X1 P IP) (turned_convex X0 Q I) (turned_convex X0 Q' I') V V'). }
  pose proof (fun x => known_meet N loops fits x X5 X4) as Known.
  pose proof (fun z => winding_meet loops _ z (int_rings_meet N loops X5)) as Wind.
  unfold Statements.no_fit_claim. cbv zeta. split; intro t; rewrite Known.
  - etransitivity; [apply (boundary_limits N (still c) (map turned (moving c)) [] (int_rings (Zpos N) loops) (map (int_edge N) fits) (listed_sums c) [] 1%Z at_sum Bd Ce Is Cm); try assumption|].
    + intros u (f & [] & _).
    + intros f x [].
    + intros f [].
    + left. reflexivity.
    + rewrite (Ov t). split; intros (Cl & NO); (split; [|exact NO]); intros e E; destruct (Cl e E) as (y & Y & Cy); exists y; (split; [apply Ov, Y|exact Cy]).
  - intro NL. rewrite Wind, (Ov t).
    apply (boundary_core N (still c) (map turned (moving c)) [] (int_rings (Zpos N) loops) (map (int_edge N) fits) (listed_sums c) [] 1%Z at_sum Bd Ce Is Cm) in NL; try assumption.
    + intros u (f & [] & _).
    + intros f x [].
    + intros f [].
    + left. reflexivity.
Qed.
(* Contact: the closed shapes have a common point. *)
Lemma near_mix k y w e : 0 < k -> (fst w - fst y) * (fst w - fst y) + (snd w - snd y) * (snd w - snd y) + 1 <= e / k -> Statements.close e (mix k y w) y.
Proof.
  intros K L. set (m := (fst w - fst y) * (fst w - fst y) + (snd w - snd y) * (snd w - snd y) + 1) in *.
  pose proof (square (fst w - fst y)) as U2. pose proof (square (snd w - snd y)) as V2.
  pose proof (abs_bound (fst w - fst y)) as Bu. pose proof (abs_bound (snd w - snd y)) as Bv.
  assert (Lk : k * m <= e). { pose proof (mono_le k m (e / k) ltac:(lra) L). assert (k * (e / k) == e) by (field; lra). lra. }
  assert (E1 : fst (mix k y w) - fst y == (k * (fst w - fst y)) / (1 + k)) by (unfold mix; cbn [fst snd]; field; lra).
  assert (E2 : snd (mix k y w) - snd y == (k * (snd w - snd y)) / (1 + k)) by (unfold mix; cbn [fst snd]; field; lra).
  assert (Sz : forall u, - m <= u <= m -> - e < (k * u) / (1 + k) < e).
  { intros u (A & B). pose proof (mono_le k u m ltac:(lra) B). pose proof (mono_le k (- m) u ltac:(lra) A).
    assert (Ep : 0 < e). { assert (0 < m) by (unfold m; lra). assert (0 < k * m) by (apply Qmult_lt_0_compat; assumption). lra. }
    assert (0 < e * k) by (apply Qmult_lt_0_compat; assumption).
    split; [apply Qlt_shift_div_l; [lra|]|apply Qlt_shift_div_r; [lra|]]; lra. }
  unfold Statements.close. rewrite E1, E2. split; apply Sz; unfold m; lra.
Qed.
Lemma closed_piece rs ps P a b s : simple_solid {| rings := int_rings (Zpos N) rs; pieces := ps |} = true -> all_integral (Zpos N) rs = true ->
  In P ps -> is_convex P = true -> In a P -> In b P -> 0 <= s <= 1 -> Statements.closure (Statements.inside rs) (between N s a b).
Proof.
  intros S I IP CP A B Hs e E. destruct (is_convex_spec N P CP) as (FP & C & L). set (w := third N (center P)) in *. set (y := between N s a b).
  set (m := (fst w - fst y) * (fst w - fst y) + (snd w - snd y) * (snd w - snd y) + 1).
  pose proof (square (fst w - fst y)) as U2. pose proof (square (snd w - snd y)) as V2. assert (M : 0 < m) by (unfold m; lra).
  set (k := e / m). assert (K : 0 < k) by (unfold k; apply Qlt_shift_div_l; lra).
  exists (mix k y w). split.
  - unfold Statements.inside. apply (count_pieces N {| rings := int_rings (Zpos N) rs; pieces := ps |} rs _ S I eq_refl). exists P. split; [exact IP|].
    apply strict_inside; [exact FP|].
    pose proof (mix_strict (qring N P) (1 - s) s 0 (qpt N a) (qpt N b) (qpt N a) w k L (in_map _ _ _ A) (in_map _ _ _ B) (in_map _ _ _ A) C
      ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) K) as T.
    refine (inS_same _ _ _ _ T). unfold meets_at, mix, mean, y, between. cbn [fst snd]. split; field; lra.
  - apply near_mix; [exact K|]. fold m. unfold k. assert (F : e / (e / m) == m) by (field; lra). rewrite F. lra.
Qed.
Theorem no_fit_contact : check_no_fit = true -> forall t, Statements.on_any (flat_map Statements.edges loops ++ fits) t ->
  exists z, Statements.closure (Statements.inside D) z /\ Statements.closure (Statements.inside (Statements.translate t G)) z.
Proof.
  unfold check_no_fit. intro H. repeat match type of H with _ && _ = true => let X := fresh "X" in apply andb_prop in H as (H & X) end.
  rename X4 into X6, X3 into X5, X2 into X4, X1 into X3, X0 into X2.
  pose proof (fun P => simple_convex solid_D P X3 : In P (still c) -> is_convex P = true) as X1.
  pose proof (fun P => simple_convex solid_G P X2 : In P (moving c) -> is_convex P = true) as X0. destruct (boundary_parts _ _ _ _ _ _ _ _ X) as (B1 & B2 & B3 & Bw & B4 & B5 & B6 & B7 & B8).
  intros t K. rewrite (known_meet N loops fits t X5 X4) in K.
  destruct (boundary_contact N (still c) (map turned (moving c)) [] (int_rings (Zpos N) loops) (map (int_edge N) fits) (listed_sums c) []) with (t := t)
    as (P & Q & a & b & u & v & s & IP & IQ & Ia & Ib & Iu & Iv & Hs & Tx & Ty); try assumption; try reflexivity.
  apply in_map_iff in IQ as (Q' & <- & IQ). destruct (turned_in Q' u Iu) as (u' & Iu' & ->). destruct (turned_in Q' v Iv) as (v' & Iv' & ->).
  exists (between N s a b). split.
  - exact (closed_piece D (still c) P a b s X3 H IP (X1 P IP) Ia Ib Hs).
  - intros e E. destruct (closed_piece G (moving c) Q' u' v' s X2 X6 IQ (X0 Q' IQ) Iu' Iv' Hs e E) as (y & Y & C1 & C2).
    exists (fst y + fst t, snd y + snd t). split.
    + unfold Statements.inside. rewrite winding_translate. rewrite (winding_same G (back_by t (fst y + fst t, snd y + snd t)) y); [exact Y|]. unfold meets_at, back_by. cbn [fst snd]. split; ring.
    + unfold Statements.close. cbn [fst snd]. unfold between, opposite, qpt in *. cbn [fst snd] in *.
      assert (F : forall i : Z, (- i # N) == - (i # N)) by (intro i; unfold Qeq, Qopp; cbn [Qnum Qden]; ring). rewrite !F in Tx, Ty.
      split; lra.
Qed.
End Data.
