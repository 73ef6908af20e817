(* The half-open rule: two shapes have a common point if and only if their interiors overlap. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Statements.
Import ListNotations.
Open Scope Q_scope.

Lemma leb_cases x y : (x <= y /\ Qle_bool x y = true) \/ (y < x /\ Qle_bool x y = false).
Proof.
  destruct (Qlt_le_dec y x) as [H|H]; [right|left]; split; try assumption.
  - destruct (Qle_bool x y) eqn:E; [|reflexivity]. apply Qle_bool_iff in E. lra.
  - apply Qle_bool_iff, H.
Qed.
Lemma less_cases x y : (x < y /\ Statements.less x y = true) \/ (y <= x /\ Statements.less x y = false).
Proof. unfold Statements.less. destruct (leb_cases y x) as [(H & ->)|(H & ->)]; auto. Qed.

Lemma below x y : 0 < x -> 0 < y -> exists d, 0 < d /\ d <= x /\ d <= y.
Proof. intros X Y. destruct (Qlt_le_dec x y); [exists x|exists y]; repeat split; lra. Qed.

Lemma abs_bound (a : Q) : - (a * a + 1) <= a <= a * a + 1.
Proof. split; nra. Qed.

Lemma prod_bound (a m t : Q) : - m <= a <= m -> 0 <= t -> - (m * t) <= a * t <= m * t.
Proof. intros (A & B) T. split; nra. Qed.
Lemma mono_le (m x y : Q) : 0 <= m -> x <= y -> m * x <= m * y.
Proof. intros. nra. Qed.
Lemma mono_lt (m x y : Q) : 0 < m -> x < y -> m * x < m * y.
Proof. intros. nra. Qed.

(* Points to the right of z and slightly above it *)
Definition wedge (d : Q) (z y : Statements.point) : Prop :=
  0 < fst y - fst z < d /\ 0 < snd y - snd z < d * (fst y - fst z).

Lemma wedge_less d e z y : d <= e -> wedge d z y -> wedge e z y.
Proof. unfold wedge. intros L ((A & B) & C & D). repeat split; try lra.
  pose proof (mono_le (fst y - fst z) d e ltac:(lra) L). lra. Qed.

Lemma crossing_wedge z e : exists d, 0 < d /\ forall y, wedge d z y -> Statements.crossing y e = Statements.crossing z e.
Proof.
  destruct e as [a b]. set (A := fst b - fst a). set (B := snd b - snd a). set (o := Statements.orient a b z).
  set (m := A * A + B * B + 1).
  assert (A2 : 0 <= A * A) by nra. assert (B2 : 0 <= B * B) by nra.
  assert (M : 0 < m) by (unfold m; lra).
  assert (Am : - m <= A <= m) by (pose proof (abs_bound A); unfold m; lra).
  assert (Bm : - m <= B <= m) by (pose proof (abs_bound B); unfold m; lra).
  assert (P : forall q, exists d, 0 < d /\ d <= 1 /\ (0 < q -> d <= q)).
  { intro q. destruct (Qlt_le_dec 0 q) as [H|H].
    - destruct (below 1 q) as (d & D & E & F); [lra|assumption|]. exists d. auto.
    - exists 1. repeat split; lra. }
  destruct (P (snd a - snd z)) as (d1 & D1 & E1 & F1). destruct (P (snd b - snd z)) as (d2 & D2 & E2 & F2).
  destruct (P (o / (2 * m))) as (d3 & D3 & E3 & F3). destruct (P (- o / (2 * m))) as (d4 & D4 & E4 & F4).
  destruct (P (B / m)) as (d5 & D5 & E5 & F5). destruct (P (- B / m)) as (d6 & D6 & E6 & F6).
  destruct (below d1 d2 D1 D2) as (c1 & C1 & G1 & G2). destruct (below d3 d4 D3 D4) as (c2 & C2 & G3 & G4).
  destruct (below d5 d6 D5 D6) as (c3 & C3 & G5 & G6). destruct (below c1 c2 C1 C2) as (c4 & C4 & G7 & G8).
  destruct (below c3 c4 C3 C4) as (d & D & G9 & G10). exists d. split; [exact D|].
  assert (F3' : 0 < o -> d * (2 * m) <= o).
  { intro O. assert (0 < o / (2 * m)) by (apply Qlt_shift_div_l; lra).
    assert (d <= o / (2 * m)) by (specialize (F3 H); lra).
    assert (o / (2 * m) * (2 * m) == o) by (field; lra).
    pose proof (mono_le (2 * m) _ _ ltac:(lra) H0). lra. }
  assert (F4' : o < 0 -> d * (2 * m) <= - o).
  { intro O. assert (0 < - o / (2 * m)) by (apply Qlt_shift_div_l; lra).
    assert (d <= - o / (2 * m)) by (specialize (F4 H); lra).
    assert (- o / (2 * m) * (2 * m) == - o) by (field; lra).
    pose proof (mono_le (2 * m) _ _ ltac:(lra) H0). lra. }
  assert (F5' : 0 < B -> d * m <= B).
  { intro O. assert (0 < B / m) by (apply Qlt_shift_div_l; lra).
    assert (d <= B / m) by (specialize (F5 H); lra). assert (B / m * m == B) by (field; lra).
    pose proof (mono_le m _ _ ltac:(lra) H0). lra. }
  assert (F6' : B < 0 -> d * m <= - B).
  { intro O. assert (0 < - B / m) by (apply Qlt_shift_div_l; lra).
    assert (d <= - B / m) by (specialize (F6 H); lra). assert (- B / m * m == - B) by (field; lra).
    pose proof (mono_le m _ _ ltac:(lra) H0). lra. }
  intros y ((Y1 & Y2) & Y3 & Y4). set (s := fst y - fst z) in *. set (t := snd y - snd z) in *.
  assert (T : t < d).
  { pose proof (mono_lt d s d D Y2). pose proof (mono_le d d 1 ltac:(lra) ltac:(lra)). lra. }
  assert (Hy : snd y == snd z + t) by (unfold t; ring).
  assert (Ho : Statements.orient a b y == o + A * t - B * s) by (unfold Statements.orient, o, A, B, s, t, Statements.orient; ring).
  pose proof (prod_bound A m t Am ltac:(lra)) as At. pose proof (prod_bound B m s Bm ltac:(lra)) as Bs.
  assert (mt : m * t <= m * (d * s)) by (apply mono_le; lra).
  assert (ms : m * s < m * d) by (apply mono_lt; lra).
  assert (mt' : m * t < m * d) by (apply mono_lt; lra).
  assert (K1 : 0 < o -> 0 < o + A * t - B * s) by (intro O; specialize (F3' O); lra).
  assert (K2 : o < 0 -> o + A * t - B * s < 0) by (intro O; specialize (F4' O); lra).
  assert (K3 : 0 < B -> o <= 0 -> o + A * t - B * s <= 0).
  { intros O O'. specialize (F5' O). pose proof (mono_le s (d * m) B ltac:(lra) F5'). lra. }
  assert (K4 : B < 0 -> 0 <= o -> 0 <= o + A * t - B * s).
  { intros O O'. specialize (F6' O). pose proof (mono_le s (d * m) (- B) ltac:(lra) F6'). lra. }
  clear mt ms mt' At Bs F3' F4' F5' F6'.
  unfold Statements.crossing. fold o.
  destruct (leb_cases (snd a) (snd z)) as [(X1 & ->)|(X1 & ->)];
  destruct (leb_cases (snd a) (snd y)) as [(X2 & ->)|(X2 & ->)]; try (exfalso; lra);
  destruct (leb_cases (snd b) (snd z)) as [(X3 & ->)|(X3 & ->)];
  destruct (leb_cases (snd b) (snd y)) as [(X4 & ->)|(X4 & ->)]; try (exfalso; lra);
  destruct (less_cases (snd z) (snd a)) as [(X5 & ->)|(X5 & ->)]; try (exfalso; lra);
  destruct (less_cases (snd y) (snd a)) as [(X6 & ->)|(X6 & ->)]; try (exfalso; lra);
  destruct (less_cases (snd z) (snd b)) as [(X7 & ->)|(X7 & ->)]; try (exfalso; lra);
  destruct (less_cases (snd y) (snd b)) as [(X8 & ->)|(X8 & ->)]; try (exfalso; lra);
  cbn [andb]; try reflexivity.
  - assert (0 < B) by (unfold B; lra).
    destruct (less_cases 0 o) as [(X9 & ->)|(X9 & ->)];
    destruct (less_cases 0 (Statements.orient a b y)) as [(X0 & ->)|(X0 & ->)]; try reflexivity; exfalso; rewrite Ho in X0.
    + specialize (K1 X9). lra.
    + specialize (K3 H X9). lra.
  - assert (B < 0) by (unfold B; lra).
    destruct (less_cases o 0) as [(X9 & ->)|(X9 & ->)];
    destruct (less_cases (Statements.orient a b y) 0) as [(X0 & ->)|(X0 & ->)]; try reflexivity; exfalso; rewrite Ho in X0.
    + specialize (K2 X9). lra.
    + specialize (K4 H X9). lra.
Qed.

Theorem half_open rs z : exists d, 0 < d /\ forall y, wedge d z y -> Statements.winding rs y = Statements.winding rs z.
Proof.
  unfold Statements.winding. induction (flat_map Statements.edges rs) as [|e es (d & D & H)]; [exists 1; split; [lra|reflexivity]|].
  destruct (crossing_wedge z e) as (d' & D' & H'). destruct (below d d' D D') as (c & C & L & L').
  exists c. split; [exact C|]. intros y Y. cbn [map fold_right].
  rewrite H, H'; [reflexivity| |]; eapply wedge_less; eassumption.
Qed.

(* Each wedge contains an open square. *)
Lemma wedge_square d z : 0 < d -> exists c e, 0 < e /\ forall y, Statements.close e y c -> wedge d z y.
Proof.
  intro D. destruct (below d 1 D) as (r & R & L & L1); [lra|].
  exists (fst z + r / 2, snd z + r * r / 4), (r * r / 8).
  pose proof (mono_le r r 1 ltac:(lra) L1) as R1. pose proof (mono_lt r 0 r R R) as R2.
  split; [apply Qlt_shift_div_l; lra|].
  intros y ((A & B) & C & E). cbn [fst snd] in *. apply (wedge_less r d z y L).
  assert (X : fst y - (fst z + r / 2) == fst y - fst z - r / 2) by ring.
  set (s := fst y - fst z) in *. set (t := snd y - snd z).
  assert (Y : snd y - (snd z + r * r / 4) == t - r * r / 4) by (unfold t; ring).
  rewrite X in A, B. rewrite Y in C, E. clear X Y.
  assert (H1 : r * r / 8 == (1 # 8) * (r * r)) by field. assert (H2 : r / 2 == (1 # 2) * r) by field.
  assert (H3 : r * r / 4 == (1 # 4) * (r * r)) by field. rewrite H1, H2 in A, B. rewrite H1, H3 in C, E.
  unfold wedge. fold s t. repeat split; try lra.
  assert (S1 : (1 # 2) * r - (1 # 8) * (r * r) < s) by lra.
  pose proof (mono_lt r _ _ R S1). pose proof (mono_le r (r * r) r ltac:(lra) ltac:(lra)). lra.
Qed.

Lemma overlap_of_point A B z : Statements.inside A z -> Statements.inside B z -> Statements.overlap (Statements.inside A) (Statements.inside B).
Proof.
  intros HA HB. destruct (half_open A z) as (d & D & H). destruct (half_open B z) as (d' & D' & H').
  destruct (below d d' D D') as (r & R & L & L'). destruct (wedge_square r z R) as (c & e & E & C).
  exists c. split; exists e; (split; [exact E|]); intros y Y; specialize (C y Y); unfold Statements.inside.
  - rewrite (H y); [exact HA|]. apply (wedge_less r d z y L C).
  - rewrite (H' y); [exact HB|]. apply (wedge_less r d' z y L' C).
Qed.

Lemma close_refl e z : 0 < e -> Statements.close e z z.
Proof. intro E. unfold Statements.close. repeat split; lra. Qed.

Theorem disjoint_iff A B : Statements.disjoint (Statements.inside A) (Statements.inside B) <-> ~ Statements.overlap (Statements.inside A) (Statements.inside B).
Proof.
  split.
  - intros H (z & (e & E & X) & (e' & E' & Y)). apply (H z). split; [apply X|apply Y]; apply close_refl; assumption.
  - intros H z (X & Y). apply H. apply (overlap_of_point A B z X Y).
Qed.

Lemma interior_of_point A z : Statements.inside A z -> exists c, Statements.interior (Statements.inside A) c.
Proof. intro H. destruct (overlap_of_point A A z H H) as (c & C & _). exists c. exact C. Qed.
