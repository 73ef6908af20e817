(* The checker of swept areas, and its theorem. O is the union of the open sums of a segment of the path T and a piece
   of G; the area that G covers along T is the closure of O. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Convex Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers Spans Sums SumsSound Pairs.
Import ListNotations.
Open Scope Q_scope.

Record sweep_certificate := { unit : positive; moving : list ring; listed_sums : list (Z * list (list Z)) }.

Definition qplus (x : qpoint * qpoint) : qpoint := (fst (fst x) + fst (snd x), snd (fst x) + snd (snd x)).
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

(* A point strictly inside a sum polygon is strictly inside the piece translated to some point of the edge. *)
Lemma sum_swept e G pairs cG p : left_all G -> inS (Statements.edges G) cG ->
  (forall x, In x pairs -> Statements.on_segment e (fst x) /\ In (snd x) G) ->
  inS (Statements.edges (map qplus pairs)) p -> pairs <> [] ->
  exists t w, Statements.on_segment e t /\ inS (Statements.edges G) w /\ fst p == fst w + fst t /\ snd p == snd w + snd t.
Proof.
  intros LG CG In_ I N. set (c := qplus (fst e, cG)).
  destruct (away_inside _ p c I) as (k & K & J). set (p' := away k p c) in *.
  destruct (find_triangle _ p' J) as (x & y & z & Ix & Iy & Iz & H1 & H2 & H3).
  { destruct pairs; [contradiction|discriminate]. }
  apply in_map_iff in Ix as (xp & <- & Ix). apply in_map_iff in Iy as (xa & <- & Iy). apply in_map_iff in Iz as (xb & <- & Iz).
  destruct (In_ xp Ix) as (Pp & Gp). destruct (In_ xa Iy) as (Pa & Ga). destruct (In_ xb Iz) as (Pb & Gb).
  pose proof (o_total (qplus xp) (qplus xa) (qplus xb) p') as T.
  destruct (mean_self (qplus xp) (qplus xa) (qplus xb) p') as (X & Y); [lra|].
  revert X Y H1 H2 H3 T. generalize (o (qplus xp, qplus xa) p') (o (qplus xa, qplus xb) p') (o (qplus xb, qplus xp) p')
    (o (qplus xp, qplus xa) (qplus xb)). intros w u v s X Y H1 H2 H3 T.
  exists (mix k (mean u v w (fst xp) (fst xa) (fst xb)) (fst e)), (mix k (mean u v w (snd xp) (snd xa) (snd xb)) cG).
  split; [apply on_mix; [exact K|apply on_mean; try assumption; lra|exact (on_ends e false)]|].
  split; [apply mix_strict; try assumption; lra|].
  unfold mix, mean, qplus, p', away, c in *. cbn [fst snd] in *.
  assert (D : 0 < u + v + w) by lra. assert (D' : 0 < 1 + k) by lra. split.
  - assert (Z : fst p == ((u * (fst (fst xp) + fst (snd xp)) + v * (fst (fst xa) + fst (snd xa)) +
      w * (fst (fst xb) + fst (snd xb))) / (u + v + w) + k * (fst (fst e) + fst cG)) / (1 + k)).
    { rewrite <- X. unfold qplus. cbn [fst snd]. field. lra. }
    rewrite Z. field. lra.
  - assert (Z : snd p == ((u * (snd (fst xp) + snd (snd xp)) + v * (snd (fst xa) + snd (snd xa)) +
      w * (snd (fst xb) + snd (snd xb))) / (u + v + w) + k * (snd (fst e) + snd cG)) / (1 + k)).
    { rewrite <- Y. unfold qplus. cbn [fst snd]. field. lra. }
    rewrite Z. field. lra.
Qed.

Section Data.
Variables (T : list side) (G loops : list Statements.ring) (slits : list side) (c : sweep_certificate).
Let N := unit c.
Definition solid_G : solid := {| rings := int_rings (Zpos N) G; pieces := moving c |}.
Definition segments : list ring := map (fun e => [fst e; snd e]) (map (int_edge N) T).
Definition check_sweep : bool :=
  forallb (integral_edge N) T && all_integral (Zpos N) G && all_integral (Zpos N) loops && forallb (integral_edge N) slits &&
  simple_solid solid_G &&
  Sums.boundary segments (moving c) [] (int_rings (Zpos N) loops) (map (int_edge N) slits) (listed_sums c) [] 1.

Definition reaches (e : side) (Q : ring) (p : qpoint) : Prop := exists t,
  Statements.on_segment e t /\ inS (Statements.edges (qring N Q)) (back_by t p).
Definition at_sum (P Q : ring) (p : qpoint) : Prop :=
  match P with [a; b] => reaches (qpt N a, qpt N b) Q p | _ => False end.
Definition O (p : qpoint) : Prop := exists e Q, In e T /\ In Q (moving c) /\ reaches e Q p.

Section Accepted.
Hypothesis IT : forallb (integral_edge N) T = true.
Hypothesis IG : all_integral (Zpos N) G = true.
Hypothesis SG : simple_solid solid_G = true.
Hypothesis PG : forall Q, In Q (moving c) -> is_convex Q = true.

Lemma fan_moving Q : In Q (moving c) -> is_fan Q = true.
Proof. intro I. exact (proj1 (is_convex_spec N Q (PG Q I))). Qed.

Lemma segment_spec P : In P segments -> exists a b, P = [a; b].
Proof. intro I. apply in_map_iff in I as ((a, b) & <- & _). exists a, b. reflexivity. Qed.

Lemma frac_at n v : qdot n (qpt N v) == (dot n v # N).
Proof. unfold qdot, qpt, dot, Qeq, Qplus, Qmult, inject_Z. cbn [fst snd Qnum Qden]. rewrite !Pos.mul_1_l, Pos2Z.inj_mul. ring. Qed.
Lemma sum_bound P Q n p : In P segments -> In Q (moving c) -> n <> (0, 0)%Z -> at_sum P Q p ->
  qdot n p * inject_Z (Zpos N) < inject_Z (most n P + most n Q).
Proof.
  intros IP IQ Nz R. destruct (segment_spec P IP) as (a & b & ->). destruct R as (t & (s & (S0 & S1) & X & Y) & I).
  pose proof (piece_lt N Q n (most n Q) (back_by t p) (fan_moving Q IQ) Nz (most_spec n Q) I) as L.
  assert (E1 : qdot n p == qdot n (back_by t p) + qdot n t) by (unfold qdot, back_by; cbn [fst snd]; ring).
  assert (E2 : qdot n t == (1 - s) * qdot n (qpt N a) + s * qdot n (qpt N b)) by (unfold qdot; rewrite X, Y; cbn [fst snd]; ring).
  rewrite !frac_at in E2.
  assert (A : (dot n a # N) <= (most n [a; b] # N)) by (apply frac_le, most_spec; left; reflexivity).
  assert (B : (dot n b # N) <= (most n [a; b] # N)) by (apply frac_le, most_spec; right; left; reflexivity).
  assert (0 <= s * ((most n [a; b] # N) - (dot n b # N))) by (apply Qmult_le_0_compat; lra).
  assert (0 <= (1 - s) * ((most n [a; b] # N) - (dot n a # N))) by (apply Qmult_le_0_compat; lra).
  assert (F : forall i, (i # N) * inject_Z (Zpos N) == inject_Z i) by (intro i; unfold Qeq, Qmult, inject_Z; cbn [Qnum Qden]; rewrite !Pos.mul_1_r; ring).
  rewrite inject_Z_plus, <- (F (most n [a; b])), <- (F (most n Q)), E1, E2. assert (P : 0 < inject_Z (Zpos N)) by (apply inject_pos; reflexivity).
  rewrite <- Qmult_plus_distr_l. apply Qmult_lt_r; [exact P|]. lra.
Qed.
Lemma sum_vertex P Q v : In P segments -> In Q (moving c) -> In v P -> at_sum P Q (third N (Sums.plus (grow 3 v) (center Q))).
Proof.
  intros IP IQ V. destruct (segment_spec P IP) as (a & b & ->). exists (qpt N v).
  split; [destruct V as [<-|[<-|[]]]; [exact (on_ends (qpt N a, qpt N b) false)|exact (on_ends (qpt N a, qpt N b) true)]|].
  destruct (is_convex_spec N Q (PG Q IQ)) as (_ & A & _). apply (inS_same _ (third N (center Q))); [|exact A].
  unfold meets_at, back_by, third, Sums.plus, center, grow, qpt. cbn [fst snd].
  split; unfold Qeq, Qminus, Qplus, Qopp; cbn [Qnum Qden]; rewrite !Pos2Z.inj_mul; ring.
Qed.
Lemma sum_center P Q : In P segments -> In Q (moving c) -> at_sum P Q (third N (Sums.plus (center P) (center Q))).
Proof.
  intros IP IQ. pose proof IP as I. destruct (segment_spec P I) as (a & b & ->). exact (sum_vertex [a; b] Q a IP IQ (or_introl eq_refl)).
Qed.
Lemma sum_inside P Q p : In P segments -> In Q (moving c) -> add P Q <> [] -> inS (map (qe N) (sum_sides P Q)) p -> at_sum P Q p.
Proof.
  intros IP IQ Ne I. destruct (segment_spec P IP) as (a & b & ->). destruct (is_convex_spec N Q (PG Q IQ)) as (_ & A & L).
  set (pairs := map (fun x => (qpt N (fst x), qpt N (snd x))) (add [a; b] Q)).
  destruct (sum_swept (qpt N a, qpt N b) (qring N Q) pairs _ p L A) as (t & w & Ot & Sw & X & Y).
  - intros x Ix. apply in_map_iff in Ix as (y & <- & Iy). cbn [fst snd]. apply add_in in Iy as (I1 & I2).
    split; [|exact (in_map (qpt N) _ _ I2)].
    destruct I1 as [<-|[<-|[]]]; [exact (on_ends (qpt N a, qpt N b) false)|exact (on_ends (qpt N a, qpt N b) true)].
  - unfold sum_sides, sum_vertices in I. rewrite ring_sides in I. revert I. apply inS_meet. unfold pairs, qring. rewrite !map_map.
    generalize (add [a; b] Q). clear. intro l. induction l as [|x l IH]; [constructor|]. cbn [map]. constructor; [|exact IH].
    unfold meets_at, qplus, qpt, Sums.plus. cbn [fst snd]. split; unfold Qeq, Qplus; cbn [Qnum Qden]; rewrite !Pos2Z.inj_mul; ring.
  - unfold pairs. destruct (add [a; b] Q); [contradiction|discriminate].
  - exists t. split; [exact Ot|]. apply (inS_same _ w); [|exact Sw]. unfold back_by. split; cbn [fst snd]; lra.
Qed.

Lemma O_iff p : O p <-> SumsSound.O N segments (moving c) [] at_sum p.
Proof.
  pose proof (int_edges_meet N T IT) as M.
  split.
  - intros (e & Q & Ie & IQ & t & Ot & I). destruct (forall2_left _ _ _ M e Ie) as (f' & F & A & B). apply in_map_iff in F as (f & <- & F).
    left. exists [fst f; snd f], Q. split; [exact (in_map (fun e => [fst e; snd e]) _ f F)|]. split; [exact IQ|].
    exists t. split; [exact (on_meet e (qe N f) t A B Ot)|exact I].
  - intros [(P & Q & IP & IQ & R)|(f & [] & _)]. apply in_map_iff in IP as (f & <- & F). destruct R as (t & Ot & I).
    destruct (forall2_right _ _ _ M (qe N f) (in_map _ _ f F)) as (e & Ie & A & B).
    exists e, Q. split; [exact Ie|]. split; [exact IQ|]. exists t. split; [|exact I].
    exact (on_meet (qe N f) e t (meets_sym _ _ A) (meets_sym _ _ B) Ot).
Qed.

Lemma part_pieces z : Statements.winding G z = 1%Z <-> exists Q, In Q (moving c) /\ Statements.winding [qring N Q] z = 1%Z.
Proof. exact (count_pieces N solid_G G z SG IG eq_refl). Qed.

Lemma O_swept p : O p -> Statements.swept T G p.
Proof.
  intros (e & Q & Ie & IQ & t & Ot & I). exists t. split; [exists e; auto|]. intros k K. exists p. split; [|apply close_refl, K].
  unfold Statements.inside. rewrite winding_translate. apply part_pieces. exists Q. split; [exact IQ|].
  apply strict_inside; [apply fan_moving, IQ|exact I].
Qed.

Lemma piece_closed Q w f : In Q (moving c) -> Statements.winding [qring N Q] w = 1%Z ->
  In f (Statements.edges (qring N Q)) -> 0 <= o f w.
Proof.
  intros IQ X F. destruct (is_convex_spec N Q (PG Q IQ)) as (_ & _ & L). rewrite qedges_map in F.
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
  pose proof (piece_le N Q n (dot n a) w (fan_moving Q IQ) Bound X) as H. rewrite Form. apply Qmult_le_0_compat; lra.
Qed.

Lemma swept_closure p : Statements.swept T G p -> Statements.closure O p.
Proof.
  intros (t & (e & Ie & Ot) & Cl) k K.
  destruct (Cl (k / 2)) as (y & Hy & (Cy1 & Cy1') & Cy2 & Cy2'); [apply Qlt_shift_div_l; lra|].
  assert (K2 : k / 2 == (1 # 2) * k) by field. rewrite K2 in Cy1, Cy1', Cy2, Cy2'.
  unfold Statements.inside in Hy. rewrite winding_translate in Hy. apply part_pieces in Hy as (Q & IQ & X).
  set (w := back_by t y) in *. destruct (is_convex_spec N Q (PG Q IQ)) as (_ & A & _). set (i := third N (center Q)) in *.
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

End Accepted.

Theorem sweep_sound : check_sweep = true -> Statements.sweep_claim T G loops slits.
Proof.
  unfold check_sweep. intro H. repeat match type of H with _ && _ = true => let X := fresh "X" in apply andb_prop in H as (H & X) end.
  rename X3 into X4, X2 into X3, X1 into X2, X0 into X1.
  pose proof (fun P => simple_convex solid_G P X1 : In P (moving c) -> is_convex P = true) as X0. destruct (boundary_parts _ _ _ _ _ _ _ _ X) as (B1 & B2 & B3 & Bw & B4 & B5 & B6 & B7 & B8).
  pose proof (sum_bound X0) as Bd. pose proof (sum_center X0) as Ce. pose proof (sum_inside X0) as Is. pose proof (O_iff H) as Oi.
  pose proof (fun x => known_meet N loops slits x X3 X2) as Known.
  pose proof (fun z => winding_meet loops _ z (int_rings_meet N loops X3)) as Wind.
  unfold Statements.sweep_claim. intros p NL. rewrite Known in NL. rewrite Wind.
  assert (Cm : (forall P P' Q v, In P segments -> In P' segments -> In Q (moving c) -> In v P -> In v P' ->
      exists t, at_sum P Q t /\ at_sum P' Q t) /\ (are_segments segments = false -> forall P Q Q' v, In P segments ->
      In Q (moving c) -> In Q' (moving c) -> In v Q -> In v Q' -> exists t, at_sum P Q t /\ at_sum P Q' t)).
  { split.
    - intros P P' Q v I I' IQ V V'. exists (third N (Sums.plus (grow 3 v) (center Q))). split; apply (sum_vertex X0); assumption.
    - intros S P Q Q' v IP. exfalso. destruct segments as [|P0 r] eqn:E; [destruct IP|].
      destruct (segment_spec P0) as (a & b & F); [rewrite E; left; reflexivity|]. rewrite F in S. discriminate. }
  assert (Core := boundary_core N segments (moving c) [] (int_rings (Zpos N) loops) (map (int_edge N) slits) (listed_sums c) [] 1%Z at_sum Bd Ce Is Cm).
  assert (Limit := boundary_limits N segments (moving c) [] (int_rings (Zpos N) loops) (map (int_edge N) slits) (listed_sums c) [] 1%Z at_sum Bd Ce Is Cm).
  assert (E1 : forall t, beyond_at N [] t -> wind_at N (int_rings (Zpos N) loops) t = 1%Z) by (intros t (f & [] & _)).
  assert (E2 : forall (f : edge) (x : qpoint), In f [] -> o (qe N f) x == 0 -> Statements.on_segment (qe N f) x \/ beyond_at N [] x) by (intros f x []).
  assert (E3 : forall f : edge, In f [] -> exists x, 0 < o (qe N f) x) by (intros f []).
  specialize (Core E1 E2 E3 (or_introl eq_refl) B1 B2 B3 Bw B4 B5 B6 B7 B8 p NL).
  specialize (Limit E1 E2 E3 (or_introl eq_refl) B1 B2 B3 Bw B4 B5 B6 B7 B8 p).
  destruct Core as [(Op & W)|(NO & W)].
  - left. split; [|exact W]. apply (O_swept X4 X1 X0), Oi, Op.
  - right. split; [|exact W]. intro Sp. apply NL, Limit. split; [|exact NO].
    intros e E. destruct (swept_closure X4 X1 X0 p Sp e E) as (y & Y & Cy). exists y. split; [apply Oi, Y|exact Cy].
Qed.
End Data.
