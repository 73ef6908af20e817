(* The checker of swept areas, and the theorem.  O is the union of the open sums of an edge of T and a
   piece of G; what G covers on its way along T is the closure of O. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers Pairs.
Import ListNotations.
Open Scope Q_scope.

(* A sum polygon: an edge of T, a piece of G, and corners that are sums of ends of the edge (false: the
   first) and corners of the piece *)
Record swept_sum := { path : side; piece : ring; ends : list (bool * pt) }.
Record sweep_certificate := { unit : positive; moving : list ring; listed_sums : list swept_sum }.

Definition plus (x : qpoint * qpoint) : qpoint := (fst (fst x) + fst (snd x), snd (fst x) + snd (snd x)).
Definition end_of (e : side) (b : bool) : qpoint := if b then snd e else fst e.

Lemma on_ends e b : Statements.on_segment e (end_of e b).
Proof. destruct b; [exists 1|exists 0]; cbn [end_of]; repeat split; try lra; ring. Qed.

Lemma on_mean e u v w p a b : 0 <= u -> 0 <= v -> 0 <= w -> 0 < u + v + w ->
  Statements.on_segment e p -> Statements.on_segment e a -> Statements.on_segment e b -> Statements.on_segment e (mean u v w p a b).
Proof.
  intros U V W T (r & (R0 & R1) & Rx & Ry) (s & (S0 & S1) & Sx & Sy) (q & (Q0 & Q1) & Qx & Qy).
  exists ((u * r + v * s + w * q) / (u + v + w)). unfold mean. cbn [fst snd]. split; [split|].
  - apply Qle_shift_div_l; [exact T|].
    assert (0 <= u * r) by (apply Qmult_le_0_compat; lra). assert (0 <= v * s) by (apply Qmult_le_0_compat; lra).
    assert (0 <= w * q) by (apply Qmult_le_0_compat; lra). lra.
  - apply Qle_shift_div_r; [exact T|].
    assert (0 <= u * (1 - r)) by (apply Qmult_le_0_compat; lra). assert (0 <= v * (1 - s)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= w * (1 - q)) by (apply Qmult_le_0_compat; lra). lra.
  - rewrite Rx, Ry, Sx, Sy, Qx, Qy. split; field; lra.
Qed.
Lemma on_mix e k y x : 0 < k -> Statements.on_segment e y -> Statements.on_segment e x -> Statements.on_segment e (mix k y x).
Proof.
  intros K (r & (R0 & R1) & Rx & Ry) (s & (S0 & S1) & Sx & Sy). exists ((r + k * s) / (1 + k)). unfold mix. cbn [fst snd].
  split; [split|].
  - apply Qle_shift_div_l; [lra|]. assert (0 <= k * s) by (apply Qmult_le_0_compat; lra). lra.
  - apply Qle_shift_div_r; [lra|]. assert (0 <= k * (1 - s)) by (apply Qmult_le_0_compat; lra). lra.
  - rewrite Rx, Ry, Sx, Sy. split; field; lra.
Qed.

(* A point strictly inside a sum polygon is strictly inside the piece, somewhere on the way along the edge. *)
Lemma sum_swept e G pairs cG p : left_all G -> inS (Statements.edges G) cG ->
  (forall x, In x pairs -> Statements.on_segment e (fst x) /\ In (snd x) G) ->
  inS (Statements.edges (map plus pairs)) p -> pairs <> [] ->
  exists t w, Statements.on_segment e t /\ inS (Statements.edges G) w /\ fst p == fst w + fst t /\ snd p == snd w + snd t.
Proof.
  intros LG CG In_ I N. set (c := plus (fst e, cG)).
  destruct (away_inside _ p c I) as (k & K & J). set (p' := away k p c) in *.
  destruct (find_triangle _ p' J) as (x & y & z & Ix & Iy & Iz & H1 & H2 & H3).
  { destruct pairs; [contradiction|discriminate]. }
  apply in_map_iff in Ix as (xp & <- & Ix). apply in_map_iff in Iy as (xa & <- & Iy). apply in_map_iff in Iz as (xb & <- & Iz).
  destruct (In_ xp Ix) as (Pp & Gp). destruct (In_ xa Iy) as (Pa & Ga). destruct (In_ xb Iz) as (Pb & Gb).
  pose proof (o_total (plus xp) (plus xa) (plus xb) p') as T.
  destruct (mean_self (plus xp) (plus xa) (plus xb) p') as (X & Y); [lra|].
  revert X Y H1 H2 H3 T. generalize (o (plus xp, plus xa) p') (o (plus xa, plus xb) p') (o (plus xb, plus xp) p')
    (o (plus xp, plus xa) (plus xb)). intros w u v s X Y H1 H2 H3 T.
  exists (mix k (mean u v w (fst xp) (fst xa) (fst xb)) (fst e)), (mix k (mean u v w (snd xp) (snd xa) (snd xb)) cG).
  split; [apply on_mix; [exact K|apply on_mean; try assumption; lra|exact (on_ends e false)]|].
  split; [apply mix_strict; try assumption; lra|].
  unfold mix, mean, plus, p', away, c in *. cbn [fst snd] in *.
  assert (D : 0 < u + v + w) by lra. assert (D' : 0 < 1 + k) by lra. split.
  - assert (Z : fst p == ((u * (fst (fst xp) + fst (snd xp)) + v * (fst (fst xa) + fst (snd xa)) +
      w * (fst (fst xb) + fst (snd xb))) / (u + v + w) + k * (fst (fst e) + fst cG)) / (1 + k)).
    { rewrite <- X. unfold plus. cbn [fst snd]. field. lra. }
    rewrite Z. field. lra.
  - assert (Z : snd p == ((u * (snd (fst xp) + snd (snd xp)) + v * (snd (fst xa) + snd (snd xa)) +
      w * (snd (fst xb) + snd (snd xb))) / (u + v + w) + k * (snd (fst e) + snd cG)) / (1 + k)).
    { rewrite <- Y. unfold plus. cbn [fst snd]. field. lra. }
    rewrite Z. field. lra.
Qed.

Section Check.
Variables (hint : ring -> ring -> pt) (clear : side -> ring -> side -> pt) (inner : ring -> qpoint) (side_cuts edge_cuts : side -> list Q).
Section Data.
Variables (T : Statements.ring) (G loops : list Statements.ring) (slits : list side) (c : sweep_certificate).
Let N := unit c.
Definition segments : list side := flat_map Statements.edges loops ++ slits.
Definition sides_of (s : swept_sum) : list side :=
  Statements.edges (map plus (map (fun x => (end_of (path s) (fst x), qpt N (snd x))) (ends s))).
Definition sums : list (list side) := map sides_of (listed_sums c).
Definition solid_G : solid := {| rings := int_rings (Zpos N) G; pieces := moving c |}.
Definition start (e : side) (Q : ring) : qpoint := plus (fst e, inner Q).

(* All of Q, moved along e, is on one side of a line, and the segment f is on the other. *)
Definition clear_b (e : side) (Q : ring) (f : side) : bool :=
  let n := clear e Q f in
  match Q with
  | v :: vs =>
      let m := (max_dot n v vs # N) in
      negb ((fst n =? 0) && (snd n =? 0))%Z &&
      forallb (fun a => forallb (fun b => Qle_bool (qdot n a + m) (qdot n b)) [fst f; snd f]) [fst e; snd e]
  | [] => false
  end.
Definition pair_b (e : side) (Q : ring) : bool :=
  (Statements.winding loops (start e Q) =? 1)%Z && forallb (clear_b e Q) segments.
Definition side_member (e : side) (es : list side) : bool :=
  existsb (fun f => same_b (fst e) (fst f) && same_b (snd e) (snd f)) es.
Definition sum_b (s : swept_sum) : bool :=
  side_member (path s) (Statements.edges T) && member (piece s) (moving c) &&
  negb (match ends s with [] => true | _ => false end) &&
  forallb (fun x => point_member (snd x) (piece s)) (ends s) &&
  convex_b (sides_of s) && inS_b (sides_of s) (start (path s) (piece s)) &&
  forallb (fun f => cover_b sums segments (side_cuts f) f) (sides_of s).
Definition check_sweep : bool :=
  all_integral (Zpos N) G && all_integral (Zpos N) loops && simple_solid hint solid_G &&
  all_pairs distinct_b (flat_map Statements.edges loops) && forallb (piece_b N inner) (moving c) &&
  forallb (fun e => forallb (pair_b e) (moving c)) (Statements.edges T) &&
  forallb sum_b (listed_sums c) &&
  forallb (fun e => beside_b sums (edge_cuts e) e) (flat_map Statements.edges loops) &&
  forallb (both_b edge_cuts sums) slits.

Definition reaches (e : side) (Q : ring) (p : qpoint) : Prop := exists t,
  Statements.on_segment e t /\ inS (Statements.edges (qring N Q)) (back_by t p).
Definition O (p : qpoint) : Prop := exists e Q, In e (Statements.edges T) /\ In Q (moving c) /\ reaches e Q p.

Section Accepted.
Hypothesis IG : all_integral (Zpos N) G = true.
Hypothesis IL : all_integral (Zpos N) loops = true.
Hypothesis SG : simple_solid hint solid_G = true.
Hypothesis Ds : all_pairs distinct_b (flat_map Statements.edges loops) = true.
Hypothesis PG : forall Q, In Q (moving c) -> piece_b N inner Q = true.
Hypothesis Pairs : forall e Q, In e (Statements.edges T) -> In Q (moving c) -> pair_b e Q = true.
Hypothesis Sums : forall s, In s (listed_sums c) -> sum_b s = true.
Hypothesis Beside : forall e, In e (flat_map Statements.edges loops) -> beside_b sums (edge_cuts e) e = true.
Hypothesis Slits : forall e, In e slits -> both_b edge_cuts sums e = true.

Lemma fan_moving : fans (moving c).
Proof. exact (proj1 (proj2 (simple_spec hint solid_G SG))). Qed.

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

Lemma clear_spec e Q f : In Q (moving c) -> clear_b e Q f = true -> exists n m,
  (forall p, reaches e Q p -> qdot n p < m) /\ m <= qdot n (fst f) /\ m <= qdot n (snd f).
Proof.
  intros IQ H. pose proof (fan_moving Q IQ) as FQ. unfold clear_b in H. destruct Q as [|v vs]; [discriminate|].
  set (n := clear e (v :: vs) f) in *. cbv zeta in H. apply andb_prop in H as (H0 & H).
  cbn [forallb] in H. rewrite !andb_true_r in H. apply andb_prop in H as (A & B).
  apply andb_prop in A as (A1 & A2). apply andb_prop in B as (B1 & B2). apply Qle_bool_iff in A1, A2, B1, B2.
  assert (Nz : n <> (0, 0)%Z) by (intro E; rewrite E in H0; discriminate).
  set (g := max_dot n v vs # N) in *.
  assert (Core : forall m, qdot n (fst e) + g <= m -> qdot n (snd e) + g <= m -> forall p, reaches e (v :: vs) p -> qdot n p < m).
  { intros m M1 M2 p (t & (s & (S0 & S1) & X & Y) & I).
    pose proof (piece_lt (v :: vs) n (max_dot n v vs) (back_by t p) FQ Nz (fun u U => max_dot_spec n v vs u U) I) as L. fold g in L.
    assert (E1 : qdot n p == qdot n (back_by t p) + qdot n t) by (unfold qdot, back_by; cbn [fst snd]; ring).
    assert (E2 : qdot n t == (1 - s) * qdot n (fst e) + s * qdot n (snd e)) by (unfold qdot; rewrite X, Y; ring).
    assert (0 <= s * (m - g - qdot n (snd e))) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (1 - s) * (m - g - qdot n (fst e))) by (apply Qmult_le_0_compat; lra). rewrite E1, E2. lra. }
  destruct (Qlt_le_dec (qdot n (fst f)) (qdot n (snd f))) as [Lf|Lf].
  - exists n, (qdot n (fst f)). split; [apply Core; assumption|lra].
  - exists n, (qdot n (snd f)). split; [apply Core; assumption|lra].
Qed.
Lemma pair_clear e Q f : In e (Statements.edges T) -> In Q (moving c) -> In f segments -> clear_b e Q f = true.
Proof.
  intros Ie IQ I. pose proof (Pairs e Q Ie IQ) as H. unfold pair_b in H. apply andb_prop in H as (_ & H).
  rewrite forallb_forall in H. apply H, I.
Qed.
Lemma free p : Statements.on_any segments p -> ~ O p.
Proof.
  intros (f & I & s & (S0 & S1) & X & Y) (e & Q & Ie & IQ & R).
  destruct (clear_spec e Q f IQ (pair_clear e Q f Ie IQ I)) as (n & m & H & H1 & H2). specialize (H p R).
  assert (E : qdot n p == (1 - s) * qdot n (fst f) + s * qdot n (snd f)) by (unfold qdot; rewrite X, Y; ring). rewrite E in H.
  assert (0 <= s * (qdot n (snd f) - m)) by (apply Qmult_le_0_compat; lra).
  assert (0 <= (1 - s) * (qdot n (fst f) - m)) by (apply Qmult_le_0_compat; lra). lra.
Qed.

Lemma start_reaches e Q : In Q (moving c) -> reaches e Q (start e Q).
Proof.
  intro IQ. exists (fst e). split; [exact (on_ends e false)|].
  destruct (piece_inner N inner Q (PG Q IQ)) as (A & _). apply (inS_same _ (inner Q)); [|exact A].
  unfold back_by, start, plus. cbn [fst snd]. split; cbn [fst snd]; ring.
Qed.
Lemma once p : O p -> Statements.winding loops p = 1%Z.
Proof.
  intros (e & Q & Ie & IQ & R). pose proof (Pairs e Q Ie IQ) as H. unfold pair_b in H. apply andb_prop in H as (H & _).
  apply Z.eqb_eq in H. rewrite <- H. apply (constant_rings_q (Zpos N)); [reflexivity|exact IL|]. intros f I.
  destruct (clear_spec e Q f IQ (pair_clear e Q f Ie IQ (in_or_app _ _ _ (or_introl I)))) as (n & m & B & H1 & H2).
  exists n, m. split; [apply B, R|]. split; [apply B, start_reaches, IQ|]. split; assumption.
Qed.

Lemma part_pieces z : Statements.winding G z = 1%Z <-> exists Q, In Q (moving c) /\ Statements.winding [qring N Q] z = 1%Z.
Proof. exact (count_pieces N hint solid_G G z SG IG eq_refl). Qed.

Lemma O_swept p : O p -> Statements.swept T G p.
Proof.
  intros (e & Q & Ie & IQ & t & Ot & I). exists t. split; [exists e; auto|]. intros k K. exists p. split; [|apply close_refl, K].
  unfold Statements.inside. rewrite winding_translate. apply part_pieces. exists Q. split; [exact IQ|].
  apply strict_inside; [apply fan_moving, IQ|exact I].
Qed.

Lemma piece_closed Q w f : In Q (moving c) -> Statements.winding [qring N Q] w = 1%Z ->
  In f (Statements.edges (qring N Q)) -> 0 <= o f w.
Proof.
  intros IQ X F. destruct (piece_inner N inner Q (PG Q IQ)) as (_ & L). rewrite qedges_map in F.
  apply in_map_iff in F as (g & <- & Ig). set (a := fst g) in *. set (b := snd g) in *.
  set (n := (snd b - snd a, - (fst b - fst a))%Z).
  assert (Form : forall z, o (qpt N a, qpt N b) z == (((dot n a) # N) - qdot n z) * (1 # N)).
  { intro z. unfold o, Statements.orient, qpt, qdot, dot, n. cbn [fst snd].
    assert (Q1 : exists r, forall i : Z, (i # N) == inject_Z i * r).
    { exists (1 # N). intro i. unfold Qeq, Qmult, inject_Z. cbn [Qnum Qden]. rewrite Pos.mul_1_l. ring. }
    destruct Q1 as (r & Q1). rewrite !Q1. change (inject_Z 1) with 1. repeat (rewrite ?inject_Z_mult, ?inject_Z_plus, ?inject_Z_opp || unfold Z.sub). ring. }
  assert (Pn : 0 < 1 # N) by reflexivity.
  assert (Bound : forall v, In v Q -> (dot n v <= dot n a)%Z).
  { intros v Iv. assert (Fe : In (qpt N a, qpt N b) (Statements.edges (qring N Q))).
    { rewrite qedges_map. exact (in_map (fun e => (qpt N (fst e), qpt N (snd e))) _ g Ig). }
    pose proof (L (qpt N a, qpt N b) (qpt N v) Fe (in_map (qpt N) Q v Iv)) as H. rewrite Form in H. apply (pos_cancel _ _ Pn) in H.
    assert (E : qdot n (qpt N v) == dot n v # N).
    { unfold qdot, qpt, dot, Qeq, Qplus, Qmult, inject_Z. cbn [fst snd Qnum Qden]. rewrite !Pos.mul_1_l, Pos2Z.inj_mul. ring. }
    rewrite E in H. assert (H' : (dot n v # N) <= (dot n a # N)) by lra. unfold Qle in H'. cbn [Qnum Qden] in H'. nia. }
  pose proof (piece_le Q n (dot n a) w (fan_moving Q IQ) Bound X) as H. rewrite Form. apply Qmult_le_0_compat; lra.
Qed.

Lemma swept_closure p : Statements.swept T G p -> Statements.closure O p.
Proof.
  intros (t & (e & Ie & Ot) & Cl) k K.
  destruct (Cl (k / 2)) as (y & Hy & (Cy1 & Cy1') & Cy2 & Cy2'); [apply Qlt_shift_div_l; lra|].
  assert (K2 : k / 2 == (1 # 2) * k) by field. rewrite K2 in Cy1, Cy1', Cy2, Cy2'.
  unfold Statements.inside in Hy. rewrite winding_translate in Hy. apply part_pieces in Hy as (Q & IQ & X).
  set (w := back_by t y) in *. destruct (piece_inner N inner Q (PG Q IQ)) as (A & _). set (i := inner Q) in *.
  set (u := fst i - fst w). set (v := snd i - snd w). set (m := u * u + v * v + 1).
  pose proof (square u) as U2. pose proof (square v) as V2. assert (M : 0 < m) by (unfold m; lra).
  assert (Um : - m <= u <= m) by (pose proof (abs_bound u); unfold m; lra).
  assert (Vm : - m <= v <= m) by (pose proof (abs_bound v); unfold m; lra).
  assert (P : 0 < k / (4 * m)) by (apply Qlt_shift_div_l; lra).
  destruct (below 1 (k / (4 * m))) as (d & Dp & D1 & D2); [lra|exact P|].
  assert (D3 : 4 * m * d <= k).
  { pose proof (mono_le (4 * m) d _ ltac:(lra) D2). assert (4 * m * (k / (4 * m)) == k) by (field; lra). lra. }
  pose proof (prod_bound u m d Um ltac:(lra)) as Bu. pose proof (prod_bound v m d Vm ltac:(lra)) as Bv.
  assert (md : 0 < m * d) by (apply Qmult_lt_0_compat; assumption).
  set (w' := (fst w + d * u, snd w + d * v) : qpoint).
  assert (Sw : inS (Statements.edges (qring N Q)) w').
  { intros f F. rewrite (o_share f w i d w'); [|reflexivity|reflexivity]. pose proof (piece_closed Q w f IQ X F). pose proof (A f F).
    assert (0 <= (1 - d) * o f w) by (apply Qmult_le_0_compat; lra).
    assert (0 < d * o f i) by (apply Qmult_lt_0_compat; assumption). lra. }
  exists (fst w' + fst t, snd w' + snd t). split.
  - exists e, Q. split; [exact Ie|]. split; [exact IQ|]. exists t. split; [exact Ot|].
    apply (inS_same _ w'); [|exact Sw]. unfold back_by. cbn [fst snd]. split; cbn [fst snd]; ring.
  - assert (E1 : fst w' + fst t - fst p == (fst y - fst p) + u * d) by (unfold w', w, back_by; cbn [fst snd]; ring).
    assert (E2 : snd w' + snd t - snd p == (snd y - snd p) + v * d) by (unfold w', w, back_by; cbn [fst snd]; ring).
    unfold Statements.close. cbn [fst snd]. rewrite E1, E2. repeat split; lra.
Qed.

Lemma side_member_spec e es : side_member e es = true -> exists f, In f es /\ meets_at (fst e) (fst f) /\ meets_at (snd e) (snd f).
Proof.
  unfold side_member, same_b. intro H. apply existsb_exists in H as (f & I & H). apply andb_prop in H as (A & B).
  apply andb_prop in A as (A1 & A2). apply andb_prop in B as (B1 & B2). apply Qeq_bool_iff in A1, A2, B1, B2.
  exists f. repeat split; assumption.
Qed.

Theorem accepted : Statements.sweep_claim T G loops slits.
Proof.
  assert (Poly : forall S, In S sums -> exists s, In s (listed_sums c) /\ S = sides_of s /\ convex S /\ linked S /\ (exists x, inS S x) /\
    forall f x, In f S -> Statements.on_segment f x -> covered sums segments x).
  { intros S I. apply in_map_iff in I as (s & <- & I). exists s. split; [exact I|]. split; [reflexivity|].
    pose proof (Sums s I) as H. unfold sum_b in H. apply andb_prop in H as (H & Cv). apply andb_prop in H as (H & J).
    apply andb_prop in H as (_ & H). apply convex_b_spec in H as (A & B). split; [exact A|]. split; [exact B|].
    split; [eexists; apply inS_b_spec, J|]. intros f x F X. rewrite forallb_forall in Cv.
    exact (cover_b_spec sums segments (side_cuts f) f x (Cv f F) X). }
  assert (Convex : forall S, In S sums -> convex S) by (intros S I; destruct (Poly S I) as (s & _ & _ & A & _); exact A).
  assert (Inner : forall S, In S sums -> exists x, inS S x) by (intros S I; destruct (Poly S I) as (s & _ & _ & _ & _ & A & _); exact A).
  assert (Sum : forall S p, In S sums -> inS S p -> O p).
  { intros S p I J. destruct (Poly S I) as (s & Is & -> & _). pose proof (Sums s Is) as H. unfold sum_b in H.
    apply andb_prop in H as (H & _). apply andb_prop in H as (H & _). apply andb_prop in H as (H & _).
    apply andb_prop in H as (H & Cs). apply andb_prop in H as (H & Ne). apply andb_prop in H as (M1 & M2).
    apply side_member_spec in M1 as (f & If & F1 & F2). unfold member in M2.
    destruct (in_dec (list_eq_dec pt_dec) (piece s) (moving c)) as [IQ|]; [|discriminate]. rewrite forallb_forall in Cs.
    destruct (piece_inner N inner _ (PG _ IQ)) as (A & L).
    destruct (sum_swept (path s) (qring N (piece s)) (map (fun x => (end_of (path s) (fst x), qpt N (snd x))) (ends s)) (inner (piece s)) p L A)
      as (t & w & Ot & Sw & X & Y).
    - intros x Ix. apply in_map_iff in Ix as (y & <- & Iy). cbn [fst snd]. split; [apply on_ends|]. specialize (Cs y Iy).
      unfold point_member in Cs. destruct (in_dec pt_dec (snd y) (piece s)) as [K|]; [|discriminate]. apply (in_map (qpt N)), K.
    - exact J.
    - destruct (ends s); discriminate.
    - exists f, (piece s). split; [exact If|]. split; [exact IQ|]. exists t. split.
      + destruct Ot as (r & R & X0 & Y0). exists r. destruct F1 as (F11 & F12). destruct F2 as (F21 & F22).
        split; [exact R|]. rewrite <- F11, <- F12, <- F21, <- F22. split; assumption.
      + apply (inS_same _ w); [|exact Sw]. unfold back_by. split; cbn [fst snd]; lra. }
  assert (Cover : forall S f x, In S sums -> In f S -> o f x == 0 -> (forall g, In g S -> 0 <= o g x) ->
    U sums x \/ L (flat_map Statements.edges loops) slits x).
  { intros S f x I F X0 X1. destruct (Poly S I) as (s & _ & _ & _ & Lk & _ & Cv). exact (Cv f x F (closed_on_side _ f x Lk F X0 X1)). }
  assert (Left : forall e x, In e (flat_map Statements.edges loops) -> Statements.on_segment e x ->
    exists S f, In S sums /\ In f S /\ Statements.on_segment f x /\ (0 < rise e -> 0 < rise f) /\ (rise e < 0 -> rise f < 0))
    by (intros e x I X; exact (beside_b_spec sums (edge_cuts e) e x (Beside e I) X)).
  assert (Both : forall e x, In e slits -> ~ rise e == 0 -> Statements.on_segment e x ->
    exists S f, In S sums /\ In f S /\ Statements.on_segment f x /\ 0 < rise f)
    by (intros e x I R X; exact (both_left edge_cuts sums e x (Slits e I) R X)).
  assert (Touch : forall e x, In e (flat_map Statements.edges loops ++ slits) -> Statements.on_segment e x ->
    exists S f, In S sums /\ In f S /\ Statements.on_segment f x).
  { intros e x I X. apply in_app_or in I as [I|I].
    - destruct (Left e x I X) as (S & f & IS & IF & Of & _). exists S, f. auto.
    - exact (both_touch edge_cuts sums e x (Slits e I) X). }
  pose proof (core sums (flat_map Statements.edges loops) slits O 1%Z Convex Sum free once (or_introl eq_refl) Cover Left Both (distinct_pairs _ Ds)) as Core.
  pose proof (boundary sums (flat_map Statements.edges loops) slits O 1%Z Convex Sum free once (or_introl eq_refl) Cover Left Both (distinct_pairs _ Ds)
    Inner Touch (fun t => on_any_dec segments t)) as Bound. unfold L in Core, Bound.
  unfold Statements.sweep_claim. fold segments. intros p NL. destruct (Core p NL) as [(Op & W)|(NO & W)].
  - left. split; [apply O_swept, Op|exact W].
  - right. split; [|exact W]. intro Sp. apply NL, (Bound p). split; [apply swept_closure, Sp|exact NO].
Qed.
End Accepted.

Theorem sweep_sound : check_sweep = true -> Statements.sweep_claim T G loops slits.
Proof.
  unfold check_sweep. intro H. repeat match type of H with _ && _ = true => let X := fresh "X" in apply andb_prop in H as (H & X) end.
  rewrite forallb_forall in X, X0, X1, X2, X3.
  apply accepted; try assumption. intros e Q Ie IQ. specialize (X2 e Ie). rewrite forallb_forall in X2. exact (X2 Q IQ).
Qed.
End Data.
End Check.
