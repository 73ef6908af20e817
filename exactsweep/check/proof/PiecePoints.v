(* Pieces with a common denominator, as sets of rational points. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints.
Import ListNotations.
Open Scope Z_scope.

(* A point strictly left of all sides, and on no line through the first vertex and another vertex, is in exactly one
   triangle of the fan. *)
Lemma fan_strict p z l : forall q, sorted p q l = true -> 0 < det p q z ->
  (forall f, In f (back p q l) -> 0 < det (fst f) (snd f) z) -> (forall a, In a l -> det p a z <> 0) ->
  1 <= wind (flat_map edges3 (fan_from p q l)) z.
Proof.
  induction l as [|r m IH]; intros q S Q H N.
  - exfalso. specialize (H (q, p) (or_introl eq_refl)). cbn [fst snd] in H.
    replace (det q p z) with (- det p q z) in H by (unfold det; ring). lia.
  - cbn [sorted] in S. apply andb_prop in S as (S & S2). apply andb_prop in S as (S0 & _). apply Z.ltb_lt in S0.
    cbn [fan_from flat_map]. rewrite wind_app.
    assert (T : 0 <= wind (edges3 (p, q, r)) z) by (destruct (Pieces.half_open p q r z S0) as [->|(-> & _)]; lia).
    assert (F : 0 <= wind (flat_map edges3 (fan_from p r m)) z) by (destruct (fan_01 p m z r S2) as [->|(-> & _)]; lia).
    destruct (Z.lt_trichotomy (det p r z) 0) as [L|[L|L]].
    + assert (wind (edges3 (p, q, r)) z = 1); [|lia].
      pose proof (H (q, r) (or_introl eq_refl)) as E. cbn [fst snd] in E.
      assert (E2 : 0 < det r p z) by (replace (det r p z) with (- det p r z) by (unfold det; ring); lia).
      rewrite triangle; [|exact S0|unfold on; lia]. unfold inside.
      destruct (Z.ltb_spec 0 (det p q z)), (Z.ltb_spec 0 (det q r z)), (Z.ltb_spec 0 (det r p z)); try reflexivity; lia.
    + exfalso. apply (N r (or_introl eq_refl) L).
    + enough (1 <= wind (flat_map edges3 (fan_from p r m)) z) by lia.
      apply (IH r S2 L); intros; [apply H|apply N]; right; assumption.
Qed.

Lemma ring_strict r z : is_fan r = true -> (forall f, In f (edges r) -> 0 < det (fst f) (snd f) z) ->
  (forall a, In a r -> det (hd (0, 0) r) a z = 0 -> a = hd (0, 0) r) -> ring_wind r z = 1.
Proof.
  intros F H N. destruct (piece_01 r z F) as [E|E]; [exfalso|exact E].
  destruct (fan_shape r F) as (p & q & s & l & -> & S). cbn [hd] in N.
  unfold ring_wind in E. rewrite edges_sides, fan_sum in E.
  rewrite edges_sides in H. cbn [sides] in H.
  assert (Hq : 0 < det p q z) by (apply (H (p, q)); left; reflexivity).
  assert (1 <= wind (flat_map edges3 (fan_from p q (s :: l))) z); [|lia].
  apply fan_strict; [exact S|exact Hq|intros f I; apply H; right; exact I|].
  intros a I E0. specialize (N a (or_intror (or_intror I)) E0). subst a.
  (* no later vertex equals the first one *)
  cbn [sorted] in S. clear - S I. revert q s S I. induction l as [|x l IH]; intros q s S [->|I].
  - apply andb_prop in S as (S & _). apply andb_prop in S as (S & _). apply Z.ltb_lt in S. unfold det in S. lia.
  - destruct I.
  - apply andb_prop in S as (S & _). apply andb_prop in S as (S & _). apply Z.ltb_lt in S. unfold det in S. lia.
  - apply andb_prop in S as (_ & S). cbn [sorted] in S. exact (IH s x S I).
Qed.

Definition pt_dec (a b : pt) : {a = b} + {a <> b}.
Proof. repeat decide equality. Defined.

Section Scale.
Variable D : positive.
Definition qpt (v : pt) : qpoint := (fst v # D, snd v # D).
Definition qring (r : ring) : list qpoint := map qpt r.

Lemma qpt_at v : pat (Zpos D) (qpt v) v.
Proof. unfold pat, at_, qpt, Qeq, Qmult, inject_Z. cbn [fst snd Qnum Qden]. rewrite Pos.mul_1_r. split; ring. Qed.
Lemma qring_at r : Forall2 (pat (Zpos D)) (qring r) r.
Proof. induction r as [|v r IH]; constructor; [apply qpt_at|exact IH]. Qed.

Lemma piece_at k r z v : 0 < k -> pat k z v -> Statements.winding [qring r] z = ring_wind (map (grow k) r) (grow (Zpos D) v).
Proof.
  intros K V. rewrite (winding_W (Zpos D) k [qring r] [r] z v); [|lia|exact K|constructor; [apply qring_at|constructor]|exact V].
  rewrite W_cons. unfold W. cbn. lia.
Qed.

Lemma det_at k a b z v : 0 < k -> pat k z v ->
  at_ (k * Zpos D * (k * Zpos D)) (o (qpt a, qpt b) z) (det (grow k a) (grow k b) (grow (Zpos D) v)).
Proof. intros K V. apply orient_at; [apply pat_grow, qpt_at|apply pat_grow, qpt_at|apply pat_grow', V]. Qed.

Lemma qedges_map r : Statements.edges (qring r) = map (fun e => (qpt (fst e), qpt (snd e))) (edges r).
Proof.
  destruct r as [|p t]; [reflexivity|]. unfold qring. cbn [Statements.edges edges map].
  change (qpt p :: map qpt t) with (map qpt (p :: t)). replace (map qpt t ++ [qpt p]) with (map qpt (t ++ [p])) by apply map_app.
  generalize (t ++ [p]). generalize (p :: t). intro l. induction l as [|a l IH]; intros [|b m]; cbn; try reflexivity.
  f_equal. apply IH.
Qed.

Open Scope Q_scope.
Lemma ev_strict f z : 0 < o f z -> ev z (fun y => 0 < o f y).
Proof.
  intro H. assert (Form : forall y, o f y == - rise f * fst y + run f * snd y + o f (0, 0))
    by (intro y; rewrite (o_move f (0, 0) y); cbn [fst snd]; ring).
  rewrite Form in H. apply ev_affine in H. revert H. apply ev_weaken. intros y Y. rewrite Form. exact Y.
Qed.
Lemma ev_inS es z : inS es z -> ev z (inS es).
Proof. intro H. apply (ev_all z (fun f y => 0 < o f y)). intros f I. apply ev_strict, H, I. Qed.

Lemma ev_nonzero f z : ~ meets_at (fst f) (snd f) -> ev z (fun y => ~ o f y == 0).
Proof.
  intro N. destruct (Qlt_le_dec 0 (o f z)) as [P|P].
  { generalize (ev_strict f z P). apply ev_weaken. intros y Y C. lra. }
  destruct (Qlt_le_dec (o f z) 0) as [M|M].
  { assert (M' : 0 < o (snd f, fst f) z) by (rewrite o_sym; destruct f; cbn [fst snd]; lra).
    generalize (ev_strict _ z M'). apply ev_weaken. intros y Y C. rewrite o_sym in Y. destruct f; cbn [fst snd] in *. lra. }
  assert (Z : o f z == 0) by lra.
  destruct (Qeq_dec (rise f) 0) as [R|R].
  - (* horizontal *)
    exists 1. split; [lra|]. intros y (Y1 & Y2 & Y3) C. rewrite (o_move f z y), Z, R in C.
    assert (E : run f * (snd y - snd z) == 0) by lra. apply Qmult_integral in E.
    destruct E as [E|E]; [|lra]. apply N. unfold run, rise in *. split; lra.
  - (* |run| t < |rise| s near z *)
    set (m := run f * run f + 1). pose proof (abs_bound (run f)) as B. fold m in B.
    assert (M0 : 0 < m) by (pose proof (square (run f)); unfold m; lra).
    set (r := rise f) in *. assert (R2 : 0 < r * r) by (pose proof (square r) as S2; destruct (Qeq_dec (r * r) 0) as [E|E];
      [apply Qmult_integral in E; tauto|lra]).
    (* a d with d m <= |r| *)
    destruct (Qlt_le_dec r 0) as [Rn|Rp].
    + assert (P0 : 0 < - r / m) by (apply Qlt_shift_div_l; lra). exists (- r / m). split; [exact P0|].
      intros y ((Y1 & Y2) & Y3 & Y4) C. rewrite (o_move f z y), Z in C. fold r in C.
      set (s := fst y - fst z) in *. set (t := snd y - snd z) in *.
      pose proof (prod_bound (run f) m t B ltac:(lra)) as Bt. pose proof (mono_lt m t _ M0 Y4) as L.
      assert (E : m * (- r / m * s) == - r * s) by (field; lra). lra.
    + assert (P0 : 0 < r / m) by (apply Qlt_shift_div_l; lra). exists (r / m). split; [exact P0|].
      intros y ((Y1 & Y2) & Y3 & Y4) C. rewrite (o_move f z y), Z in C. fold r in C.
      set (s := fst y - fst z) in *. set (t := snd y - snd z) in *.
      pose proof (prod_bound (run f) m t B ltac:(lra)) as Bt. pose proof (mono_lt m t _ M0 Y4) as L.
      assert (E : m * (r / m * s) == r * s) by (field; lra). lra.
Qed.

Lemma qpt_inj u v : meets_at (qpt u) (qpt v) -> u = v.
Proof.
  unfold meets_at, qpt, Qeq. cbn [fst snd Qnum Qden]. intros (A & B). destruct u, v. cbn [fst snd] in *.
  f_equal; [apply (Z.mul_reg_r _ _ (Zpos D)) in A|apply (Z.mul_reg_r _ _ (Zpos D)) in B]; lia.
Qed.

(* Strictly left of all sides of a piece: inside. *)
Theorem strict_inside r z : is_fan r = true -> inS (Statements.edges (qring r)) z -> Statements.winding [qring r] z = 1%Z.
Proof.
  intros F H.
  assert (E1 : ev z (fun y => forall a, In a r -> a <> hd (0, 0)%Z r -> ~ o (qpt (hd (0, 0)%Z r), qpt a) y == 0)).
  { apply ev_all. intros a I. destruct (pt_dec a (hd (0, 0)%Z r)) as [E|E].
    - exists 1. split; [lra|]. intros y _ C. exfalso. exact (C E).
    - assert (X : ev z (fun y => ~ o (qpt (hd (0, 0)%Z r), qpt a) y == 0)).
      { apply ev_nonzero. cbn [fst snd]. intro M. apply qpt_inj in M. congruence. }
      revert X. apply ev_weaken. intros y Y _. exact Y. }
  destruct (ev_point _ _ (ev_and _ _ _ (ev_and _ _ _ (ev_inS _ _ H) E1) (wind_ev (flat_map Statements.edges [qring r]) z)))
    as (y & (A & B) & C).
  change (Statements.winding [qring r] y = Statements.winding [qring r] z) in C. rewrite <- C. clear C.
  destruct (pat_common y y) as (k & v & _ & K & V & _). rewrite (piece_at k r y v K V).
  assert (KK : (0 < k * Zpos D * (k * Zpos D))%Z) by nia.
  apply ring_strict; [apply is_fan_grow; assumption| |].
  - intros f I. rewrite edges_map in I. apply in_map_iff in I as (e & <- & I). cbn [fst snd].
    assert (P : 0 < o (qpt (fst e), qpt (snd e)) y).
    { apply A. rewrite qedges_map. apply (in_map (fun e => (qpt (fst e), qpt (snd e)))). exact I. }
    pose proof (det_at k (fst e) (snd e) y v K V) as Dt.
    destruct (Z.lt_ge_cases 0 (det (grow k (fst e)) (grow k (snd e)) (grow (Zpos D) v))) as [|Le]; [assumption|exfalso].
    apply (proj2 (at_le _ _ _ _ _ KK Dt (at_zero _))) in Le. lra.
  - intros a I Z0. apply in_map_iff in I as (u & <- & I).
    assert (Hd : hd (0, 0)%Z (map (grow k) r) = grow k (hd (0, 0)%Z r)) by (destruct r; [destruct I|reflexivity]).
    rewrite Hd in *. destruct (pt_dec u (hd (0, 0)%Z r)) as [E|E]; [congruence|exfalso].
    apply (B u I); [congruence|]. pose proof (det_at k (hd (0, 0)%Z r) u y v K V) as Dt. rewrite Z0 in Dt.
    unfold at_ in Dt. change (inject_Z 0) with 0 in Dt. apply Qmult_integral in Dt. destruct Dt as [Dt|Dt]; [exact Dt|].
    exfalso. pose proof (inject_pos _ KK). lra.
Qed.

(* A linear function on the common points of two pieces *)
Definition qdot (n : pt) (z : qpoint) : Q := inject_Z (fst n) * fst z + inject_Z (snd n) * snd z.

Lemma qdot_at n K z v : pat K z v -> at_ K (qdot n z) (dot n v).
Proof.
  intros (A & B). unfold at_ in *. unfold qdot, dot. rewrite inject_Z_plus, !inject_Z_mult, <- A, <- B. ring.
Qed.

Theorem share_bound P G n a b z w : is_fan P = true -> is_fan G = true -> n <> (0, 0)%Z ->
  (forall v, In v P -> (dot n v <= a)%Z) -> (forall v, In v G -> (b <= dot n v)%Z) ->
  Statements.winding [qring P] z = 1%Z -> Statements.winding [qring G] w = 1%Z ->
  (qdot n z - qdot n w) * inject_Z (Zpos D) < inject_Z (a - b).
Proof.
  intros FP FG N A B Z1 W1. destruct (pat_common z w) as (k & v & u & K & V & U).
  rewrite (piece_at k P z v K V) in Z1. rewrite (piece_at k G w u K U) in W1.
  pose proof (is_fan_grow k P K FP) as FP'. pose proof (is_fan_grow k G K FG) as FG'.
  assert (A' : forall x, In x (map (grow k) P) -> (dot n x <= k * a)%Z).
  { intros x I. apply in_map_iff in I as (y & <- & I). rewrite dot_grow. specialize (A y I). nia. }
  assert (B' : forall x, In x (map (grow k) G) -> (dot (- fst n, - snd n)%Z x <= - (k * b))%Z).
  { intros x I. apply in_map_iff in I as (y & <- & I). rewrite dot_opp, dot_grow. specialize (B y I). nia. }
  pose proof (piece_bound _ (grow (Zpos D) v) n _ FP' ltac:(lia) A') as L1.
  pose proof (piece_bound _ (grow (Zpos D) u) _ _ FG' ltac:(lia) B') as L2.
  assert (Lt : (dot n (grow (Zpos D) v) - dot n (grow (Zpos D) u) < k * (a - b))%Z).
  { destruct (Z.eq_dec (dot n (grow (Zpos D) v)) (k * a)) as [E1|E1]; [|rewrite dot_opp in L2; lia].
    destruct (Z.eq_dec (dot (- fst n, - snd n)%Z (grow (Zpos D) u)) (- (k * b))) as [E2|E2]; [exfalso|rewrite dot_opp in *; lia].
    destruct (either_way n N) as [R|R].
    - enough (ring_wind (map (grow k) P) (grow (Zpos D) v) <= 0)%Z by lia. apply (lean _ _ n R).
      intros e I. apply edges_ends in I as (I & J). rewrite E1. split; apply A'; assumption.
    - enough (ring_wind (map (grow k) G) (grow (Zpos D) u) <= 0)%Z by lia. apply (lean _ _ _ R).
      intros e I. apply edges_ends in I as (I & J). rewrite E2. split; apply B'; assumption. }
  pose proof (qdot_at n _ z _ (pat_grow' (Zpos D) k z v V)) as E1.
  pose proof (qdot_at n _ w _ (pat_grow' (Zpos D) k w u U)) as E2. unfold at_ in E1, E2.
  rewrite Zlt_Qlt in Lt. unfold Z.sub in Lt at 1. rewrite inject_Z_plus, inject_Z_opp, <- E1, <- E2 in Lt.
  rewrite !inject_Z_mult in Lt. pose proof (inject_pos k K) as Kq.
  apply (Qmult_lt_r _ _ (inject_Z k) Kq). lra.
Qed.
End Scale.

(* Translations *)
Open Scope Q_scope.
Lemma qedges_gen (f : qpoint -> qpoint) r :
  Statements.edges (map f r) = map (fun e => (f (fst e), f (snd e))) (Statements.edges r).
Proof.
  destruct r as [|p t]; [reflexivity|]. cbn [Statements.edges map].
  change (f p :: map f t) with (map f (p :: t)). replace (map f t ++ [f p]) with (map f (t ++ [p])) by apply map_app.
  generalize (t ++ [p]). generalize (p :: t). intro l. induction l as [|a l IH]; intros [|b m]; cbn; try reflexivity.
  f_equal. apply IH.
Qed.
Definition back_by (t z : qpoint) : qpoint := (fst z - fst t, snd z - snd t).
Lemma winding_translate t rs z : Statements.winding (Statements.translate t rs) z = Statements.winding rs (back_by t z).
Proof.
  assert (C : forall a b, Statements.crossing z ((fst a + fst t, snd a + snd t), (fst b + fst t, snd b + snd t)) =
    Statements.crossing (back_by t z) (a, b)).
  { intros a b. unfold Statements.crossing.
    assert (E : Statements.orient (fst a + fst t, snd a + snd t) (fst b + fst t, snd b + snd t) z ==
      Statements.orient a b (back_by t z)) by (unfold Statements.orient, back_by; cbn [fst snd]; ring).
    unfold back_by at 1 2 4 5. cbn [fst snd].
    assert (L1 : forall c, Qle_bool (c + snd t) (snd z) = Qle_bool c (snd z - snd t)).
    { intro c. destruct (leb_cases (c + snd t) (snd z)) as [(H & ->)|(H & ->)];
      destruct (leb_cases c (snd z - snd t)) as [(H' & ->)|(H' & ->)]; try reflexivity; lra. }
    assert (L2 : forall c, Statements.less (snd z) (c + snd t) = Statements.less (snd z - snd t) c).
    { intro c. unfold Statements.less. rewrite L1. reflexivity. }
    rewrite !L1, !L2.
    assert (L3 : Statements.less 0 (Statements.orient (fst a + fst t, snd a + snd t) (fst b + fst t, snd b + snd t) z) =
      Statements.less 0 (Statements.orient a b (back_by t z))).
    { destruct (less_cases 0 (Statements.orient (fst a + fst t, snd a + snd t) (fst b + fst t, snd b + snd t) z)) as [(H & ->)|(H & ->)];
      destruct (less_cases 0 (Statements.orient a b (back_by t z))) as [(H' & ->)|(H' & ->)]; try reflexivity; rewrite E in H; lra. }
    assert (L4 : Statements.less (Statements.orient (fst a + fst t, snd a + snd t) (fst b + fst t, snd b + snd t) z) 0 =
      Statements.less (Statements.orient a b (back_by t z)) 0).
    { destruct (less_cases (Statements.orient (fst a + fst t, snd a + snd t) (fst b + fst t, snd b + snd t) z) 0) as [(H & ->)|(H & ->)];
      destruct (less_cases (Statements.orient a b (back_by t z)) 0) as [(H' & ->)|(H' & ->)]; try reflexivity; rewrite E in H; lra. }
    rewrite L3, L4. reflexivity. }
  unfold Statements.winding, Statements.translate.
  set (f := fun p : qpoint => (fst p + fst t, snd p + snd t)).
  pose proof (qedges_gen f) as Ed.
  induction rs as [|r rs IH]; [reflexivity|]. cbn [map flat_map].
  rewrite !map_app, !fold_right_app.
  assert (G : forall es c, fold_right Z.add c (map (Statements.crossing z) (map (fun e => (f (fst e), f (snd e))) es)) =
    fold_right Z.add c (map (Statements.crossing (back_by t z)) es)).
  { induction es as [|[a b] es IHe]; intro c; [reflexivity|]. cbn [map fold_right fst snd]. rewrite IHe. f_equal. apply C. }
  rewrite Ed, G, IH. reflexivity.
Qed.
