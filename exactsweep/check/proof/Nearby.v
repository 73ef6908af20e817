(* Properties of all points in a small wedge at z, to the right and slightly above. Finitely many of them hold
   simultaneously (`ev_and`, `ev_all`), so a point can be moved into general position: to a height of no vertex
   (`ev_height`) and off a segment (`ev_off`). *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen.
Import ListNotations.
Open Scope Q_scope.

Definition side := (Statements.point * Statements.point)%type.
Definition o (f : side) (t : Statements.point) : Q := Statements.orient (fst f) (snd f) t.
Definition rise (f : side) : Q := snd (snd f) - snd (fst f).
Definition run (f : side) : Q := fst (snd f) - fst (fst f).

Lemma o_move f t u : o f u == o f t + run f * (snd u - snd t) - rise f * (fst u - fst t).
Proof. unfold o, run, rise, Statements.orient. ring. Qed.

(* Properties of all points in a small wedge at z *)
Definition ev (z : Statements.point) (P : Statements.point -> Prop) : Prop :=
  exists d, 0 < d /\ forall y, wedge d z y -> P y.
Lemma ev_and z P Q : ev z P -> ev z Q -> ev z (fun y => P y /\ Q y).
Proof.
  intros (d & D & H) (d' & D' & H'). destruct (below d d' D D') as (c & C & L & L').
  exists c. split; [exact C|]. intros y Y.
  split; [apply H, (wedge_less c d z y L Y)|apply H', (wedge_less c d' z y L' Y)].
Qed.
Lemma ev_all {A} z (P : A -> Statements.point -> Prop) l : (forall x, In x l -> ev z (P x)) ->
  ev z (fun y => forall x, In x l -> P x y).
Proof.
  induction l as [|a l IH]; intro H; [exists 1; split; [lra|intros y _ x []]|].
  destruct (ev_and z _ _ (H a (or_introl eq_refl)) (IH (fun x I => H x (or_intror I)))) as (d & D & E).
  exists d. split; [exact D|]. intros y Y x [<-|I]; destruct (E y Y) as (E1 & E2); [exact E1|exact (E2 x I)].
Qed.
Lemma ev_point z P : ev z P -> exists y, P y.
Proof.
  intros (d & D & H). destruct (wedge_square d z D) as (c & e & E & C). exists c. apply H, C, close_refl, E.
Qed.
Lemma ev_weaken z (P Q : Statements.point -> Prop) : (forall y, P y -> Q y) -> ev z P -> ev z Q.
Proof. intros I (d & D & H). exists d. split; [exact D|]. intros y Y. apply I, H, Y. Qed.

Lemma ev_affine a b c z : 0 < a * fst z + b * snd z + c -> ev z (fun y => 0 < a * fst y + b * snd y + c).
Proof.
  intro H. set (v := a * fst z + b * snd z + c) in *. set (m := a * a + b * b + 1).
  assert (A2 : 0 <= a * a) by nra. assert (B2 : 0 <= b * b) by nra. assert (M : 0 < m) by (unfold m; lra).
  assert (Am : - m <= a <= m) by (pose proof (abs_bound a); unfold m; lra).
  assert (Bm : - m <= b <= m) by (pose proof (abs_bound b); unfold m; lra).
  assert (V : 0 < v / (2 * m)) by (apply Qlt_shift_div_l; lra).
  destruct (below 1 (v / (2 * m))) as (d & D & E & F); [lra|exact V|].
  assert (F' : d * (2 * m) <= v).
  { assert (v / (2 * m) * (2 * m) == v) by (field; lra). pose proof (mono_le (2 * m) _ _ ltac:(lra) F). lra. }
  exists d. split; [exact D|]. intros y ((Y1 & Y2) & Y3 & Y4).
  set (s := fst y - fst z) in *. set (t := snd y - snd z) in *.
  assert (T : t < d).
  { pose proof (mono_lt d s d D Y2). pose proof (mono_le d d 1 ltac:(lra) E). lra. }
  pose proof (prod_bound a m s Am ltac:(lra)). pose proof (prod_bound b m t Bm ltac:(lra)).
  pose proof (mono_lt m s d M Y2). pose proof (mono_lt m t d M T).
  assert (X : a * fst y + b * snd y + c == v + a * s + b * t) by (unfold v, s, t; ring).
  rewrite X. lra.
Qed.

Lemma ev_height z h : ev z (fun y => ~ h == snd y).
Proof.
  destruct (Qlt_le_dec (snd z) h) as [H|H].
  - assert (E : ev z (fun y => 0 < 0 * fst y + -1 * snd y + h)) by (apply ev_affine; lra).
    revert E. apply ev_weaken. intros y Y C. rewrite C in Y. lra.
  - exists 1. split; [lra|]. intros y (_ & Y & _) C. rewrite <- C in Y. lra.
Qed.

Definition straddles (e : side) (h : Q) : Prop := snd (fst e) < h < snd (snd e) \/ snd (snd e) < h < snd (fst e).

(* A segment is closed. *)
Lemma ev_off e z : ~ Statements.on_segment e z -> ev z (fun y => ~ Statements.on_segment e y).
Proof.
  intro N. destruct e as [p q].
  assert (Box : forall y, Statements.on_segment (p, q) y ->
    Statements.orient p q y == 0 /\ (fst p <= fst y \/ fst q <= fst y) /\ (fst y <= fst p \/ fst y <= fst q) /\
    (snd p <= snd y \/ snd q <= snd y) /\ (snd y <= snd p \/ snd y <= snd q)).
  { intros y (s & (S0 & S1) & X & Y). cbn [fst snd] in *. split; [unfold Statements.orient; rewrite X, Y; ring|].
    assert (I : forall a b c, c == a + s * (b - a) -> (a <= c \/ b <= c) /\ (c <= a \/ c <= b)).
    { intros a b c C. destruct (Qlt_le_dec a b) as [L|L].
      - assert (0 <= s * (b - a)) by (apply Qmult_le_0_compat; lra).
        assert (0 <= (1 - s) * (b - a)) by (apply Qmult_le_0_compat; lra). split; [left|right]; lra.
      - assert (0 <= s * (a - b)) by (apply Qmult_le_0_compat; lra).
        assert (0 <= (1 - s) * (a - b)) by (apply Qmult_le_0_compat; lra). split; [right|left]; lra. }
    destruct (I _ _ _ X), (I _ _ _ Y). auto. }
  set (a := - (snd q - snd p)). set (b := fst q - fst p). set (c := (snd q - snd p) * fst p - (fst q - fst p) * snd p).
  assert (Or : forall y, Statements.orient p q y == a * fst y + b * snd y + c)
    by (intro y; unfold Statements.orient, a, b, c; ring).
  destruct (Qlt_le_dec 0 (Statements.orient p q z)) as [O1|O1].
  { rewrite Or in O1. eapply ev_weaken; [|apply (ev_affine a b c z O1)]. intros y Y BB. apply Box in BB as (B & _). rewrite Or in B. cbn beta in Y. lra. }
  destruct (Qlt_le_dec (Statements.orient p q z) 0) as [O2|O2].
  { rewrite Or in O2. assert (O3 : 0 < - a * fst z + - b * snd z + - c) by lra.
    eapply ev_weaken; [|apply (ev_affine (- a) (- b) (- c) z O3)]. intros y Y BB. apply Box in BB as (B & _). rewrite Or in B. cbn beta in Y. lra. }
  assert (Two : forall u v w w', 0 < u * fst z + v * snd z + w -> 0 < u * fst z + v * snd z + w' ->
    ev z (fun y => 0 < u * fst y + v * snd y + w /\ 0 < u * fst y + v * snd y + w')).
  { intros. apply ev_and; apply ev_affine; assumption. }
  destruct (Qlt_le_dec (fst z) (fst p)) as [X1|X1].
  { destruct (Qlt_le_dec (fst z) (fst q)) as [X2|X2].
    { eapply ev_weaken; [|apply (Two (-1) 0 (fst p) (fst q) ltac:(lra) ltac:(lra))]. intros y Y BB. apply Box in BB as (_ & B & _). cbn beta in Y. lra. }
    exfalso. apply N. exists ((fst z - fst p) / (fst q - fst p)). cbn [fst snd].
    assert (M : (fst z - fst p) / (fst q - fst p) == (fst p - fst z) / (fst p - fst q)) by (field; lra).
    repeat split.
    - rewrite M. apply Qle_shift_div_l; lra.
    - rewrite M. apply Qle_shift_div_r; lra.
    - field. lra.
    - unfold Statements.orient in O1, O2.
      assert (E : (fst q - fst p) * (snd z - snd p) == (snd q - snd p) * (fst z - fst p)) by lra.
      assert (snd z - snd p == (fst z - fst p) / (fst q - fst p) * (snd q - snd p)); [|lra].
      apply (Qmult_inj_l _ _ (fst q - fst p)); [lra|]. rewrite E. field. lra. }
  destruct (Qlt_le_dec (fst q) (fst z)) as [X2|X2].
  { destruct (Qlt_le_dec (fst p) (fst z)) as [X3|X3].
    { eapply ev_weaken; [|apply (Two 1 0 (- fst p) (- fst q) ltac:(lra) ltac:(lra))]. intros y Y BB. apply Box in BB as (_ & _ & B & _). cbn beta in Y. lra. }
    exfalso. apply N. exists 0. cbn [fst snd]. assert (E : fst z == fst p) by lra. repeat split; try lra.
    unfold Statements.orient in O1, O2. rewrite E in O1, O2. assert (Q0 : (fst q - fst p) * (snd z - snd p) == 0) by lra.
    apply Qmult_integral in Q0. lra. }
  destruct (Qeq_dec (fst p) (fst q)) as [X3|X3].
  - assert (fst z == fst p) by lra.
    destruct (Qlt_le_dec (snd z) (snd p)) as [Y1|Y1].
    { destruct (Qlt_le_dec (snd z) (snd q)) as [Y2|Y2].
      { eapply ev_weaken; [|apply (Two 0 (-1) (snd p) (snd q) ltac:(lra) ltac:(lra))]. intros y Y BB. apply Box in BB as (_ & _ & _ & B & _). cbn beta in Y. lra. }
      exfalso. apply N. exists ((snd p - snd z) / (snd p - snd q)). cbn [fst snd]. repeat split.
      - apply Qle_shift_div_l; lra.
      - apply Qle_shift_div_r; lra.
      - rewrite X3, H, X3. ring.
      - field. lra. }
    destruct (Qlt_le_dec (snd q) (snd z)) as [Y2|Y2].
    { destruct (Qlt_le_dec (snd p) (snd z)) as [Y3|Y3].
      { eapply ev_weaken; [|apply (Two 0 1 (- snd p) (- snd q) ltac:(lra) ltac:(lra))]. intros y Y BB. apply Box in BB as (_ & _ & _ & _ & B). cbn beta in Y. lra. }
      exfalso. apply N. exists 0. cbn [fst snd]. repeat split; lra. }
    destruct (Qeq_dec (snd p) (snd q)) as [Y3|Y3].
    + exfalso. apply N. exists 0. cbn [fst snd]. repeat split; lra.
    + exfalso. apply N. exists ((snd z - snd p) / (snd q - snd p)). cbn [fst snd]. repeat split.
      * apply Qle_shift_div_l; lra.
      * apply Qle_shift_div_r; lra.
      * rewrite X3, H, X3. ring.
      * field. lra.
  - exfalso. apply N. exists ((fst z - fst p) / (fst q - fst p)). cbn [fst snd]. repeat split.
    + apply Qle_shift_div_l; lra.
    + apply Qle_shift_div_r; lra.
    + field. lra.
    + unfold Statements.orient in O1, O2.
      assert (E : (fst q - fst p) * (snd z - snd p) == (snd q - snd p) * (fst z - fst p)) by lra.
      assert (snd z - snd p == (fst z - fst p) / (fst q - fst p) * (snd q - snd p)); [|lra].
      apply (Qmult_inj_l _ _ (fst q - fst p)); [lra|]. rewrite E. field. lra.
Qed.
