(* Common points of two pieces, one of them translated; pieces of shapes. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Convex Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers Spans Sums.
Import ListNotations.
Open Scope Q_scope.

(* Points may be replaced by equal ones. *)
Lemma winding_same rs x y : meets_at x y -> Statements.winding rs x = Statements.winding rs y.
Proof.
  intros (A & B). unfold Statements.winding. induction (flat_map Statements.edges rs) as [|[a b] es IH]; [reflexivity|].
  cbn [map fold_right]. rewrite IH. f_equal. unfold Statements.crossing, Statements.less.
  assert (E : Statements.orient a b x == Statements.orient a b y) by (unfold Statements.orient; rewrite A, B; reflexivity).
  rewrite !E, !B. reflexivity.
Qed.


Lemma edges_meet r s : Forall2 meets_at r s ->
  Forall2 (fun e f => meets_at (fst e) (fst f) /\ meets_at (snd e) (snd f)) (Statements.edges r) (Statements.edges s).
Proof.
  intro H. destruct H as [|p v t w P T]; [constructor|]. cbn [Statements.edges].
  assert (A : Forall2 meets_at (p :: t) (v :: w)) by (constructor; assumption).
  assert (B : Forall2 meets_at (t ++ [p]) (w ++ [v])) by (apply Forall2_app; [assumption|constructor; [assumption|constructor]]).
  revert A B. generalize (t ++ [p]) (w ++ [v]) (p :: t) (v :: w). clear. intros l m a b A. revert l m.
  induction A as [|x y a b X A IH]; intros l m B; [constructor|].
  destruct B as [|u u' l m U B]; [constructor|]. cbn [combine]. constructor; [split; assumption|apply IH, B].
Qed.
Lemma all_edges_meet rs ss : Forall2 (Forall2 meets_at) rs ss ->
  Forall2 (fun e f => meets_at (fst e) (fst f) /\ meets_at (snd e) (snd f)) (flat_map Statements.edges rs) (flat_map Statements.edges ss).
Proof. induction 1; [constructor|]. cbn [flat_map]. apply Forall2_app; [apply edges_meet; assumption|assumption]. Qed.
Lemma meets_sym p q : meets_at p q -> meets_at q p.
Proof. intros (A & B). split; symmetry; assumption. Qed.
Lemma inS_meet r s t : Forall2 meets_at r s -> inS (Statements.edges r) t -> inS (Statements.edges s) t.
Proof.
  intros H I f F. destruct (forall2_right _ _ _ (edges_meet r s H) f F) as (e & E & A & B). specialize (I e E).
  destruct A as (A1 & A2), B as (B1 & B2). unfold o, Statements.orient in *. rewrite <- A1, <- A2, <- B1, <- B2. exact I.
Qed.
Lemma winding_meet rs ss z : Forall2 (Forall2 meets_at) rs ss -> Statements.winding rs z = Statements.winding ss z.
Proof.
  intro H. apply all_edges_meet in H. unfold Statements.winding.
  induction H as [|(a & b) (a' & b') es fs ((A1 & A2) & (B1 & B2)) H IH]; [reflexivity|]. cbn [map fold_right]. rewrite IH. f_equal.
  cbn [fst snd] in *. unfold Statements.crossing, Statements.less.
  assert (E : Statements.orient a b z == Statements.orient a' b' z) by (unfold Statements.orient; rewrite A1, A2, B1, B2; reflexivity).
  rewrite !E, !A2, !B2. reflexivity.
Qed.
Lemma on_meet (e f : side) x : meets_at (fst e) (fst f) -> meets_at (snd e) (snd f) -> Statements.on_segment e x -> Statements.on_segment f x.
Proof.
  intros (A1 & A2) (B1 & B2) (s & S & X & Y). exists s. rewrite <- A1, <- A2, <- B1, <- B2. auto.
Qed.
Lemma on_any_meet es fs x : Forall2 (fun e f : side => meets_at (fst e) (fst f) /\ meets_at (snd e) (snd f)) es fs ->
  (Statements.on_any es x <-> Statements.on_any fs x).
Proof.
  intro H. split; intros (e & I & X).
  - destruct (forall2_left _ _ _ H e I) as (f & F & A & B). exists f. split; [exact F|exact (on_meet e f x A B X)].
  - destruct (forall2_right _ _ _ H e I) as (f & F & A & B). exists f. split; [exact F|exact (on_meet e f x (meets_sym _ _ A) (meets_sym _ _ B) X)].
Qed.

Section Pairs.
Variable N : positive.
Notation qe := (qe N).

(* Rings and edges at a common denominator *)
Lemma int_meets p : integral (Zpos N) (fst p) && integral (Zpos N) (snd p) = true -> meets_at p (qpt N (int_point (Zpos N) p)).
Proof.
  intro H. apply andb_prop in H as (A & B). apply int_at in A, B. unfold at_ in *. unfold meets_at, qpt, int_point. cbn [fst snd].
  assert (P : 0 < inject_Z (Zpos N)) by (apply inject_pos; reflexivity).
  assert (F : forall i, (i # N) * inject_Z (Zpos N) == inject_Z i) by (intro i; unfold Qeq, Qmult, inject_Z; cbn [Qnum Qden]; rewrite !Pos.mul_1_r; ring).
  split; apply (Qmult_inj_r _ _ (inject_Z (Zpos N))); try lra; rewrite F; assumption.
Qed.
Lemma int_rings_meet rs : all_integral (Zpos N) rs = true -> Forall2 (Forall2 meets_at) rs (map (qring N) (int_rings (Zpos N) rs)).
Proof.
  unfold all_integral, int_rings. induction rs as [|r rs IH]; intro H; [constructor|]. cbn [forallb] in H. apply andb_prop in H as (H & R).
  cbn [map]. constructor; [|apply IH, R]. clear IH R. induction r as [|p r IH]; [constructor|]. cbn [forallb] in H.
  apply andb_prop in H as (H & R). cbn [map]. constructor; [apply int_meets, H|apply IH, R].
Qed.
Definition int_edge (e : side) : edge := (int_point (Zpos N) (fst e), int_point (Zpos N) (snd e)).
Definition integral_edge (e : side) : bool := all_integral (Zpos N) [[fst e; snd e]].
Lemma int_edges_meet es : forallb integral_edge es = true ->
  Forall2 (fun e f : side => meets_at (fst e) (fst f) /\ meets_at (snd e) (snd f)) es (map qe (map int_edge es)).
Proof.
  induction es as [|e es IH]; intro H; [constructor|]. cbn [forallb] in H. apply andb_prop in H as (H & R). cbn [map]. constructor; [|apply IH, R].
  unfold integral_edge, all_integral in H. cbn [forallb] in H. rewrite !andb_true_r in H. apply andb_prop in H as (A & B).
  split; apply int_meets; assumption.
Qed.
Lemma known_meet loops fits x : all_integral (Zpos N) loops = true -> forallb integral_edge fits = true ->
  (Statements.on_any (flat_map Statements.edges loops ++ fits) x <->
   Statements.on_any (map qe (known (int_rings (Zpos N) loops) (map int_edge fits))) x).
Proof.
  intros A B. apply on_any_meet. unfold known. rewrite map_app. apply Forall2_app; [|apply int_edges_meet, B].
  pose proof (all_edges_meet _ _ (int_rings_meet loops A)) as H. replace (map qe (loop_edges (int_rings (Zpos N) loops)))
    with (flat_map Statements.edges (map (qring N) (int_rings (Zpos N) loops))); [exact H|].
  unfold loop_edges. generalize (int_rings (Zpos N) loops). intro l. induction l as [|r l IH]; [reflexivity|].
  cbn [map flat_map]. rewrite map_app, IH, ring_sides. reflexivity.
Qed.

(* Common points of P and Q + t *)
Definition shares (P Q : ring) (t : qpoint) : Prop := exists z,
  Statements.winding [qring N P] z = 1%Z /\ Statements.winding [qring N Q] (back_by t z) = 1%Z.

Lemma most_spec n r v : In v r -> (dot n v <= most n r)%Z.
Proof. destruct r as [|w r]; [intros []|]. apply max_dot_spec. Qed.
Lemma turned_turned r : turned (turned r) = r.
Proof.
  unfold turned. rewrite map_map. induction r as [|(x, y) r IH]; [reflexivity|]. cbn [map]. rewrite IH. unfold opposite. cbn [fst snd].
  rewrite !Z.opp_involutive. reflexivity.
Qed.
Lemma turned_in r v : In v (turned r) -> exists u, In u r /\ v = opposite u.
Proof. intro I. apply in_map_iff in I as (u & <- & I). exists u. auto. Qed.
Lemma dot_opposite n v : (dot n (opposite v) = - dot n v)%Z.
Proof. unfold dot, opposite. cbn [fst snd]. ring. Qed.
Lemma center_turned r : center (turned r) = opposite (center r).
Proof.
  destruct r as [|p [|q [|s r]]]; unfold center, turned, opposite, plus, grow; cbn [map fst snd]; f_equal; ring.
Qed.

Lemma shares_bound P H n t : is_fan P = true -> is_fan (turned H) = true -> n <> (0, 0)%Z -> shares P (turned H) t ->
  qdot n t * inject_Z (Zpos N) < inject_Z (most n P + most n H).
Proof.
  intros FP FH Nz (z & A & B).
  pose proof (share_bound N P (turned H) n (most n P) (- most n H) z (back_by t z) FP FH Nz (most_spec n P)) as S.
  assert (L : forall v, In v (turned H) -> (- most n H <= dot n v)%Z).
  { intros v V. destruct (turned_in H v V) as (u & U & ->). rewrite dot_opposite. pose proof (most_spec n H u U). lia. }
  specialize (S L A B). rewrite Z.sub_opp_r in S.
  assert (E : qdot n z - qdot n (back_by t z) == qdot n t) by (unfold qdot, back_by; cbn [fst snd]; ring).
  rewrite E in S. exact S.
Qed.

Lemma shares_center P H : is_convex P = true -> is_convex (turned H) = true -> shares P (turned H) (third N (plus (center P) (center H))).
Proof.
  intros CP CH. destruct (is_convex_spec N P CP) as (FP & A & _). destruct (is_convex_spec N _ CH) as (FH & B & _).
  exists (third N (center P)). split; [apply strict_inside; assumption|].
  rewrite (winding_same _ _ (third N (center (turned H)))); [apply strict_inside; assumption|].
  rewrite center_turned. unfold meets_at, back_by, third, plus, opposite. cbn [fst snd].
  split; unfold Qeq, Qminus, Qplus, Qopp; cbn [Qnum Qden]; rewrite !Pos2Z.inj_mul; ring.
Qed.

Lemma shares_sym P Q t : shares P Q t -> shares Q P (- fst t, - snd t).
Proof.
  intros (z & Z & W). exists (back_by t z). split; [exact W|]. rewrite (winding_same _ _ z); [exact Z|].
  unfold meets_at, back_by. cbn [fst snd]. split; ring.
Qed.
(* A vertex of one piece and a point inside the other *)
Lemma shares_vertex P Q v : is_convex P = true -> is_convex Q = true -> In v P ->
  shares P Q (fst (qpt N v) - fst (third N (center Q)), snd (qpt N v) - snd (third N (center Q))).
Proof.
  intros CP CQ V. destruct (is_convex_spec N P CP) as (FP & A & LP). destruct (is_convex_spec N Q CQ) as (FQ & B & _).
  set (a := third N (center P)) in *. set (b := third N (center Q)) in *. set (w := qpt N v).
  destruct (away_all _ b (fst b - (fst a - fst w), snd b - (snd a - snd w)) B) as (e & E & X). exists (mix e w a). split.
  - apply strict_inside; [exact FP|].
    pose proof (mix_strict (qring N P) 1 0 0 w w w a e LP (in_map _ _ _ V) (in_map _ _ _ V) (in_map _ _ _ V) A
      ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) E) as T.
    refine (inS_same _ _ _ _ T). unfold meets_at, mix, mean. cbn [fst snd]. split; field; lra.
  - apply strict_inside; [exact FQ|]. assert (D : 0 < e / (1 + e) /\ e / (1 + e) <= e).
    { split; [apply Qlt_shift_div_l; lra|]. apply Qle_shift_div_r; [lra|]. assert (0 <= e * e) by (apply Qmult_le_0_compat; lra). lra. }
    refine (inS_same _ _ _ _ (X (e / (1 + e)) (proj1 D) (proj2 D))). unfold meets_at, away, back_by, mix. cbn [fst snd]. split; field; lra.
Qed.
Lemma shares_common_first P P' Q v : is_convex P = true -> is_convex P' = true -> is_convex Q = true -> In v P -> In v P' ->
  exists t, shares P Q t /\ shares P' Q t.
Proof. intros. eexists. split; apply shares_vertex; eassumption. Qed.
Lemma shares_common P (Q Q' : ring) v : is_convex P = true -> is_convex (turned Q) = true -> is_convex (turned Q') = true -> In v Q -> In v Q' ->
  exists t, shares P (turned Q) t /\ shares P (turned Q') t.
Proof.
  intros CP C C' V V'. eexists. split; apply shares_sym, shares_vertex; try assumption; apply (in_map opposite _ v); assumption.
Qed.

Lemma shares_inside P H t : is_convex P = true -> is_convex (turned H) = true -> add P H <> [] ->
  inS (map qe (sum_sides P H)) t -> shares P (turned H) t.
Proof.
  intros CP CH Ne I. destruct (is_convex_spec N P CP) as (FP & A & LP). destruct (is_convex_spec N _ CH) as (FH & B & LH).
  set (pairs := map (fun x => (qpt N (fst x), qpt N (opposite (snd x)))) (add P H)).
  destruct (sum_overlaps (qring N P) (qring N (turned H)) pairs _ _ t LP LH A B) as (z & w & Z & W & X & Y).
  - intros x Ix. apply in_map_iff in Ix as (y & <- & Iy). cbn [fst snd]. apply add_in in Iy as (I1 & I2).
    split; [exact (in_map (qpt N) _ _ I1)|exact (in_map (qpt N) _ _ (in_map opposite _ _ I2))].
  - unfold sum_sides, sum_vertices in I. rewrite ring_sides in I. revert I. apply inS_meet. unfold pairs, qring. rewrite !map_map.
    generalize (add P H). clear. intro l. induction l as [|x l IH]; [constructor|]. cbn [map]. constructor; [|exact IH].
    unfold meets_at, corner, qpt, plus, opposite. cbn [fst snd]. split; unfold Qeq, Qminus, Qplus, Qopp; cbn [Qnum Qden]; rewrite !Pos2Z.inj_mul; ring.
  - unfold pairs. destruct (add P H); [contradiction|discriminate].
  - exists z. split; [apply strict_inside; assumption|].
    rewrite (winding_same _ _ w); [apply strict_inside; assumption|]. split; unfold back_by; cbn [fst snd]; lra.
Qed.

(* Linear functions on a piece *)
Lemma piece_le Q n m w : is_fan Q = true -> (forall v, In v Q -> (dot n v <= m)%Z) -> Statements.winding [qring N Q] w = 1%Z ->
  qdot n w <= m # N.
Proof.
  intros F B X. destruct (pat_common w w) as (k & v & _ & K & V & _). rewrite (piece_at N k Q w v K V) in X.
  assert (L : (dot n (grow (Zpos N) v) <= k * m)%Z).
  { apply (piece_bound _ _ n _ (is_fan_grow k Q K F)); [lia|]. intros x I. apply in_map_iff in I as (y & <- & I).
    rewrite dot_grow. specialize (B y I). nia. }
  apply (at_le (k * Zpos N) _ _ (dot n (grow (Zpos N) v)) (k * m)); [nia|apply qdot_at, pat_grow', V| |exact L].
  unfold at_, Qeq, Qmult, inject_Z. cbn [Qnum Qden]. rewrite Pos.mul_1_r. ring.
Qed.
Lemma piece_lt Q n m w : is_fan Q = true -> n <> (0, 0)%Z -> (forall v, In v Q -> (dot n v <= m)%Z) ->
  inS (Statements.edges (qring N Q)) w -> qdot n w < m # N.
Proof.
  intros F Nz B I.
  set (d := (inject_Z (fst n), inject_Z (snd n)) : qpoint).
  destruct (away_inside _ w (fst w - fst d, snd w - snd d) I) as (k & K & J).
  pose proof (piece_le Q n m _ F B (strict_inside N Q _ F J)) as L.
  assert (E : qdot n (away k w (fst w - fst d, snd w - snd d)) == qdot n w + k * (inject_Z (fst n) * inject_Z (fst n) + inject_Z (snd n) * inject_Z (snd n)))
    by (unfold qdot, away, d; cbn [fst snd]; ring).
  rewrite E in L.
  assert (P : 0 < inject_Z (fst n) * inject_Z (fst n) + inject_Z (snd n) * inject_Z (snd n)).
  { rewrite <- !inject_Z_mult, <- inject_Z_plus. apply inject_pos. destruct n as [a b]. cbn [fst snd].
    assert (a <> 0 \/ b <> 0)%Z by (destruct (Z.eq_dec a 0); [right; congruence|left; assumption]). nia. }
  assert (0 < k * (inject_Z (fst n) * inject_Z (fst n) + inject_Z (snd n) * inject_Z (snd n))) by (apply Qmult_lt_0_compat; assumption).
  lra.
Qed.

(* A shape is the union of its pieces. *)
Lemma count_pieces S rs z : simple_solid S = true -> all_integral (Zpos N) rs = true ->
  rings S = int_rings (Zpos N) rs ->
  (Statements.winding rs z = 1%Z <-> exists P, In P (pieces S) /\ Statements.winding [qring N P] z = 1%Z).
Proof.
  intros H I E. destruct (simple_spec S H) as (S1 & S2 & _ & S4).
  destruct (pat_common z z) as (k & v & _ & K & V & _). pose proof (int_rings_at (Zpos N) rs I) as R. rewrite <- E in R.
  rewrite (winding_W (Zpos N) k rs (rings S) z v); [|lia|exact K|exact R|exact V].
  destruct (count_some k (pieces S) (grow (Zpos N) v) K S2) as (C1 & C2).
  pose proof (solid_count k S (grow (Zpos N) v) K S1) as C0. split.
  - intro W1. destruct C2 as (P & J & X); [lia|]. exists P. split; [exact J|]. rewrite (piece_at N k P z v K V). exact X.
  - intros (P & J & X). rewrite (piece_at N k P z v K V) in X.
    destruct (S4 k (grow (Zpos N) v) K) as [Z0|]; [exfalso|assumption]. rewrite C0 in Z0. clear C0 C1 C2 S4 S1 H I E R.
    revert J S2 Z0. generalize (pieces S). intros ps J F Z0. induction ps as [|q r IH]; [destruct J|]. cbn [count] in Z0.
    assert (Fr : fans r) by (intros x Ix; apply F; right; assumption).
    pose proof (proj1 (count_some k r (grow (Zpos N) v) K Fr)).
    pose proof (piece_01 _ (grow (Zpos N) v) (is_fan_grow k q K (F q (or_introl eq_refl)))).
    destruct J as [->|J]; [lia|]. apply IH; [assumption|assumption|lia].
Qed.

End Pairs.
