(* Sums of two lists of pieces: the checks, and what they say. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers.
Import ListNotations.
Open Scope Q_scope.

(* A sum polygon.  A corner is a corner of the first piece minus a corner of the second. *)
Record listed := { first : ring; second : ring; corners : list (pt * pt) }.

Section Pairs.
(* N: the common denominator.  `clear`: a normal of a line between the open sum of two pieces and a
   segment.  `inner`: a point strictly inside a piece.  `side_cuts`, `edge_cuts`: parameters at which a
   side, or an edge of the loops, is cut.  They may be any functions: no property of them is used. *)
Variables (N : positive) (clear : ring -> ring -> side -> pt) (inner : ring -> qpoint)
  (side_cuts edge_cuts : side -> list Q).

Definition sides_of (s : listed) : list side :=
  Statements.edges (map corner (map (fun x => (qpt N (fst x), qpt N (snd x))) (corners s))).

Definition piece_b (P : ring) : bool :=
  inS_b (Statements.edges (qring N P)) (inner P) &&
  forallb (fun f => forallb (fun v => Qle_bool 0 (o f v)) (qring N P)) (Statements.edges (qring N P)).

(* The open sum of P and -Q has no point of the segment. *)
Definition clear_b (P Q : ring) (e : side) : bool :=
  let n := clear P Q e in
  match P, Q with
  | v :: vs, w :: ws =>
      let m := inject_Z (max_dot n v vs - min_dot n w ws) in
      negb ((fst n =? 0) && (snd n =? 0))%Z &&
      Qle_bool m (qdot n (fst e) * inject_Z (Zpos N)) && Qle_bool m (qdot n (snd e) * inject_Z (Zpos N))
  | _, _ => false
  end.
Definition member (P : ring) (ps : list ring) : bool := if in_dec (list_eq_dec pt_dec) P ps then true else false.
Definition point_member (v : pt) (P : ring) : bool := if in_dec pt_dec v P then true else false.
Definition sum_b (ps qs : list ring) (sums : list (list side)) (segments : list side) (s : listed) : bool :=
  member (first s) ps && member (second s) qs &&
  negb (match corners s with [] => true | _ => false end) &&
  forallb (fun x => point_member (fst x) (first s) && point_member (snd x) (second s)) (corners s) &&
  convex_b (sides_of s) && inS_b (sides_of s) (corner (inner (first s), inner (second s))) &&
  forallb (fun f => cover_b sums segments (side_cuts f) f) (sides_of s).

Definition swap (e : side) : side := (snd e, fst e).
Definition point_b (sums : list (list side)) (e : side) : bool :=
  Qeq_bool (rise e) 0 && Qeq_bool (run e) 0 && existsb (existsb (fun f => on_b f (fst e))) sums.
Definition both_b (sums : list (list side)) (e : side) : bool :=
  point_b sums e || beside_b sums (edge_cuts e) e && beside_b sums (edge_cuts (swap e)) (swap e).

Definition shares (P Q : ring) (t : qpoint) : Prop := exists z,
  Statements.winding [qring N P] z = 1%Z /\ Statements.winding [qring N Q] (back_by t z) = 1%Z.

Lemma winding_same rs x y : meets_at x y -> Statements.winding rs x = Statements.winding rs y.
Proof.
  intros (A & B). unfold Statements.winding. induction (flat_map Statements.edges rs) as [|[a b] es IH]; [reflexivity|].
  cbn [map fold_right]. rewrite IH. f_equal. unfold Statements.crossing, Statements.less.
  assert (E : Statements.orient a b x == Statements.orient a b y) by (unfold Statements.orient; rewrite A, B; reflexivity).
  rewrite !E, !B. reflexivity.
Qed.

Lemma piece_inner P : piece_b P = true -> inS (Statements.edges (qring N P)) (inner P) /\ left_all (qring N P).
Proof.
  unfold piece_b. intro H. apply andb_prop in H as (H & L). apply inS_b_spec in H. split; [exact H|].
  intros f v F V. rewrite forallb_forall in L. specialize (L f F). rewrite forallb_forall in L. apply Qle_bool_iff, L, V.
Qed.

(* A segment of L bounds what is shared. *)
Lemma clear_spec P Q e : is_fan P = true -> is_fan Q = true -> clear_b P Q e = true ->
  exists n m, (forall t, shares P Q t -> qdot n t * inject_Z (Zpos N) < inject_Z m) /\
    inject_Z m <= qdot n (fst e) * inject_Z (Zpos N) /\ inject_Z m <= qdot n (snd e) * inject_Z (Zpos N).
Proof.
  intros FP FQ H. unfold clear_b in H.
  destruct P as [|v vs]; [discriminate|]. destruct Q as [|w ws]; [discriminate|].
  set (n := clear (v :: vs) (w :: ws) e) in *. cbv zeta in H.
  apply andb_prop in H as (H & H2). apply andb_prop in H as (H0 & H1). apply Qle_bool_iff in H1, H2.
  exists n, (max_dot n v vs - min_dot n w ws)%Z. split; [|split; assumption].
  intros t (z & A & B).
  assert (Nz : n <> (0, 0)%Z) by (intro E; rewrite E in H0; discriminate).
  pose proof (share_bound N (v :: vs) (w :: ws) n (max_dot n v vs) (min_dot n w ws) z (back_by t z) FP FQ Nz
    (fun x X => max_dot_spec n v vs x X) (fun x X => min_dot_spec n w ws x X) A B) as S.
  assert (E : qdot n z - qdot n (back_by t z) == qdot n t) by (unfold qdot, back_by; cbn [fst snd]; ring).
  rewrite E in S. exact S.
Qed.

Lemma inner_shares P Q : is_fan P = true -> is_fan Q = true -> piece_b P = true -> piece_b Q = true -> shares P Q (corner (inner P, inner Q)).
Proof.
  intros FP FQ PP PQ. destruct (piece_inner P PP) as (A & _). destruct (piece_inner Q PQ) as (B & _).
  exists (inner P). split; [apply strict_inside; [exact FP|exact A]|].
  rewrite (winding_same _ _ (inner Q)); [apply strict_inside; [exact FQ|exact B]|].
  unfold back_by, corner. cbn [fst snd]. split; cbn [fst snd]; ring.
Qed.

Lemma sum_shares ps qs sums segments s t : fans ps -> fans qs -> (forall P, In P ps -> piece_b P = true) ->
  (forall Q, In Q qs -> piece_b Q = true) -> sum_b ps qs sums segments s = true -> inS (sides_of s) t ->
  exists P Q, In P ps /\ In Q qs /\ shares P Q t.
Proof.
  intros Fp Fq PD PG H J. unfold sum_b in H.
  apply andb_prop in H as (H & _). apply andb_prop in H as (H & _). apply andb_prop in H as (H & _).
  apply andb_prop in H as (H & Cs).
  apply andb_prop in H as (H & Ne). apply andb_prop in H as (M1 & M2). unfold member in M1, M2.
  destruct (in_dec (list_eq_dec pt_dec) (first s) ps) as [IP|]; [|discriminate].
  destruct (in_dec (list_eq_dec pt_dec) (second s) qs) as [IQ|]; [|discriminate].
  destruct (piece_inner _ (PD _ IP)) as (A1 & A2). destruct (piece_inner _ (PG _ IQ)) as (B1 & B2).
  rewrite forallb_forall in Cs.
  destruct (sum_overlaps (qring N (first s)) (qring N (second s)) (map (fun x => (qpt N (fst x), qpt N (snd x))) (corners s))
    (inner (first s)) (inner (second s)) t A2 B2 A1 B1) as (z & w & Z & W & X & Y).
  - intros x X. apply in_map_iff in X as (y & <- & X). specialize (Cs y X). apply andb_prop in Cs as (C1 & C2).
    unfold point_member in C1, C2. destruct (in_dec pt_dec (fst y) (first s)) as [K1|]; [|discriminate].
    destruct (in_dec pt_dec (snd y) (second s)) as [K2|]; [|discriminate]. split; apply (in_map (qpt N)); assumption.
  - exact J.
  - destruct (corners s); [discriminate|]. discriminate.
  - exists (first s), (second s). split; [exact IP|]. split; [exact IQ|]. exists z.
    split; [apply strict_inside; [apply Fp, IP|exact Z]|].
    rewrite (winding_same _ _ w); [apply strict_inside; [apply Fq, IQ|exact W]|].
    split; unfold back_by; cbn [fst snd]; lra.
Qed.

Lemma sum_polygon ps qs sums segments s : sum_b ps qs sums segments s = true ->
  convex (sides_of s) /\ linked (sides_of s) /\ (exists x, inS (sides_of s) x) /\
  forall f x, In f (sides_of s) -> Statements.on_segment f x -> covered sums segments x.
Proof.
  intro H. unfold sum_b in H. apply andb_prop in H as (H & Cv). apply andb_prop in H as (H & J). apply andb_prop in H as (_ & H).
  apply convex_b_spec in H as (A & B). split; [exact A|]. split; [exact B|]. split; [eexists; apply inS_b_spec, J|].
  intros f x F X. rewrite forallb_forall in Cv. exact (cover_b_spec sums segments (side_cuts f) f x (Cv f F) X).
Qed.

(* Segments with sums along both sides, and single points on a side *)
Lemma both_left sums e x : both_b sums e = true -> ~ rise e == 0 -> Statements.on_segment e x ->
  exists S f, In S sums /\ In f S /\ Statements.on_segment f x /\ 0 < rise f.
Proof.
  intros H R X. apply orb_prop in H as [H|H].
  - apply andb_prop in H as (H & _). apply andb_prop in H as (H & _). apply Qeq_bool_iff in H. contradiction.
  - apply andb_prop in H as (H1 & H2). destruct (Qlt_le_dec 0 (rise e)) as [P|P].
    + destruct (beside_b_spec _ _ _ x H1 X) as (S & f & IS & IF & Of & Up & _). exists S, f. auto.
    + assert (X' : Statements.on_segment (swap e) x).
      { destruct X as (s & (S0 & S1) & X & Y). exists (1 - s). unfold swap. cbn [fst snd].
        split; [lra|]. rewrite X, Y. split; ring. }
      destruct (beside_b_spec _ _ _ x H2 X') as (S & f & IS & IF & Of & Up & _). exists S, f.
      split; [exact IS|]. split; [exact IF|]. split; [exact Of|]. apply Up.
      assert (rise (swap e) == - rise e) by (unfold rise, swap; cbn [fst snd]; ring). lra.
Qed.
Lemma both_touch sums e x : both_b sums e = true -> Statements.on_segment e x ->
  exists S f, In S sums /\ In f S /\ Statements.on_segment f x.
Proof.
  intros H X. apply orb_prop in H as [H|H].
  - apply andb_prop in H as (H & E). apply andb_prop in H as (H1 & H2). apply Qeq_bool_iff in H1, H2.
    apply existsb_exists in E as (S & IS & E). apply existsb_exists in E as (f & IF & E). apply on_b_spec in E.
    exists S, f. split; [exact IS|]. split; [exact IF|]. apply (on_same f (fst e)); [|exact E].
    destruct X as (s & _ & X & Y). unfold rise, run in *. split; [rewrite X, H2|rewrite Y, H1]; ring.
  - apply andb_prop in H as (H & _).
    destruct (beside_b_spec sums (edge_cuts e) e x H X) as (S & f & IS & IF & Of & _). exists S, f. auto.
Qed.

(* A segment that is clear of two pieces has no point in their open sum. *)
Lemma clear_free P Q e t : is_fan P = true -> is_fan Q = true -> clear_b P Q e = true ->
  Statements.on_segment e t -> ~ shares P Q t.
Proof.
  intros FP FQ C (s & (S0 & S1) & X & Y) Sh. destruct (clear_spec P Q e FP FQ C) as (n & m & H & H1 & H2). specialize (H t Sh).
  assert (E : qdot n t == (1 - s) * qdot n (fst e) + s * qdot n (snd e)) by (unfold qdot; rewrite X, Y; ring).
  rewrite E in H.
  assert (0 <= s * (qdot n (snd e) * inject_Z (Zpos N) - inject_Z m)) by (apply Qmult_le_0_compat; lra).
  assert (0 <= (1 - s) * (qdot n (fst e) * inject_Z (Zpos N) - inject_Z m)) by (apply Qmult_le_0_compat; lra). lra.
Qed.

(* So the winding number is the same on all of an open sum. *)
Lemma clear_constant P Q loops t u : is_fan P = true -> is_fan Q = true -> all_integral (Zpos N) loops = true ->
  (forall e, In e (flat_map Statements.edges loops) -> clear_b P Q e = true) -> shares P Q t -> shares P Q u ->
  Statements.winding loops t = Statements.winding loops u.
Proof.
  intros FP FQ IL C St Su. apply (constant_rings (Zpos N)); [reflexivity|exact IL|]. intros e I.
  destruct (clear_spec P Q e FP FQ (C e I)) as (n & m & B & H1 & H2).
  exists n, m. split; [apply B, St|]. split; [apply B, Su|]. split; assumption.
Qed.
Lemma count_pieces hint S rs z : simple_solid hint S = true -> all_integral (Zpos N) rs = true ->
  rings S = int_rings (Zpos N) rs ->
  (Statements.winding rs z = 1%Z <-> exists P, In P (pieces S) /\ Statements.winding [qring N P] z = 1%Z).
Proof.
  intros H I E. destruct (simple_spec hint S H) as (S1 & S2 & _ & S4).
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
