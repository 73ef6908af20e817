(* A disc as the container: sets near its center are at a distance from its complement. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Scaling Near.
Import ListNotations.
Open Scope Q_scope.

Lemma dist2_nonneg y z : 0 <= Statements.dist2 y z.
Proof. unfold Statements.dist2. pose proof (sq_nonneg (fst y - fst z)). pose proof (sq_nonneg (snd y - snd z)). lra. Qed.
Lemma dist2_sym y z : Statements.dist2 y z == Statements.dist2 z y.
Proof. unfold Statements.dist2. ring. Qed.
(* A rational number below s whose square is at least x *)
Lemma root_below x s : 0 <= x -> 0 <= s -> x < s * s -> exists d, 0 <= d < s /\ x <= d * d.
Proof.
  intros X S L. assert (Sp : 0 < s). { destruct (Qlt_le_dec 0 s) as [|Z]; [assumption|]. assert (E : s == 0) by lra. rewrite E in L. lra. }
  set (d := (x + s * s) / (2 * s)). assert (E : d * (2 * s) == x + s * s) by (unfold d; field; lra). exists d. split; [split|].
  - unfold d. apply Qle_shift_div_l; [lra|]. pose proof (sq_nonneg s). lra.
  - unfold d. apply Qlt_shift_div_r; lra.
  - pose proof (sq_nonneg (s - d)) as P. assert (F : (s - d) * (s - d) == s * s + d * d - d * (2 * s)) by ring. lra.
Qed.
Lemma ball_limit x r : 0 <= x -> 0 <= r -> (forall d, r < d -> x <= d * d) -> x <= r * r.
Proof.
  intros X R H. destruct (Qlt_le_dec 0 x) as [P|Z]; [|pose proof (sq_nonneg r); lra].
  assert (L : x * x <= x * (r * r)) by (apply square_limit; [lra|exact R|]; intros d D; apply mono_le; [lra|apply H, D]).
  destruct (Qlt_le_dec (r * r) x) as [N|]; [exfalso|assumption]. pose proof (mono_lt x _ _ P N). lra.
Qed.
Lemma within_ball r e (S : qpoint -> Prop) p z : 0 <= r -> 0 <= e -> (forall y, S y -> Statements.dist2 y p <= r * r) ->
  Statements.within e S z -> Statements.dist2 z p <= (r + e) * (r + e).
Proof.
  intros R E B W. apply ball_limit; [apply dist2_nonneg|lra|]. intros d D.
  destruct (Qlt_le_dec (d * d) (Statements.dist2 z p)) as [L|]; [exfalso|assumption].
  apply (W (d - r) ltac:(lra)). intros y Y. destruct (Qlt_le_dec ((d - r) * (d - r)) (Statements.dist2 y z)) as [|N]; [assumption|exfalso].
  rewrite dist2_sym in N. pose proof (triangle z y p (d - r) r ltac:(lra) R N (B y Y)) as T.
  assert (F : d - r + r == d) by ring. rewrite F in T. lra.
Qed.
Lemma beyond_ball r e (S : qpoint -> Prop) p z : 0 <= e -> e <= r -> (forall y, S y -> r * r < Statements.dist2 y p) ->
  Statements.within e S z -> (r - e) * (r - e) <= Statements.dist2 z p.
Proof.
  intros E L B W. destruct (Qlt_le_dec (Statements.dist2 z p) ((r - e) * (r - e))) as [N|]; [exfalso|assumption].
  destruct (root_below _ (r - e) (dist2_nonneg z p) ltac:(lra) N) as (c & (C & Cl) & D).
  apply (W (r - c) ltac:(lra)). intros y Y. destruct (Qlt_le_dec ((r - c) * (r - c)) (Statements.dist2 y z)) as [|M]; [assumption|exfalso].
  pose proof (triangle y z p (r - c) c ltac:(lra) C M D) as T. assert (F : r - c + c == r) by ring. rewrite F in T. specialize (B y Y). lra.
Qed.

(* r: the radius.  e: the error of the disc.  Each region is a set in a disc, and a distance from it. *)
Theorem keeps_ball s r e p (l : list region) (S D U : qpoint -> Prop) : 0 <= s -> 0 <= e -> s + e <= r ->
  (forall z, S z -> in_some l z) ->
  (forall q, In q l -> 0 <= snd q /\ exists b, 0 <= b /\ b + snd q + s + e <= r /\ forall y, fst q y -> Statements.dist2 y p <= b * b) ->
  (forall y, D y -> r * r < Statements.dist2 y p) -> Statements.known_to e D U -> Statements.keeps s S U.
Proof.
  intros S0 E0 Le Cov B Far K. set (b := r - s - e).
  assert (In_ : forall z, S z -> Statements.dist2 z p <= b * b).
  { intros z Z. destruct (Qlt_le_dec (b * b) (Statements.dist2 z p)) as [L|]; [exfalso|assumption].
    apply (Cov z Z). intros q Iq W. destruct (B q Iq) as (Q0 & c & C & Lc & Hc). pose proof (within_ball c (snd q) (fst q) p z C Q0 Hc W) as T.
    pose proof (sq_le (c + snd q) b ltac:(lra) ltac:(unfold b; lra)). lra. }
  assert (Out : forall u, U u -> (r - e) * (r - e) <= Statements.dist2 u p).
  { intros u Hu. apply (beyond_ball r e D); [exact E0|lra|exact Far|apply K, Hu]. }
  split.
  - intros (c & (d & Dp & HS) & (d' & Dp' & HU)). destruct (below d d' Dp Dp') as (h & H & H1 & H2).
    assert (Eq : forall y, Statements.close h y c -> Statements.dist2 y p == (r - e) * (r - e)).
    { intros y Y. pose proof (In_ y (HS y ltac:(unfold Statements.close in *; lra))). pose proof (Out y (HU y ltac:(unfold Statements.close in *; lra))).
      pose proof (sq_le b (r - e) ltac:(unfold b; lra) ltac:(unfold b; lra)). lra. }
    assert (Hh : h / 2 == (1 # 2) * h) by field.
    pose proof (Eq c (close_refl h c H)) as E1.
    pose proof (Eq (fst c + h / 2, snd c) ltac:(unfold Statements.close; cbn [fst snd]; rewrite Hh; lra)) as E2.
    pose proof (Eq (fst c - h / 2, snd c) ltac:(unfold Statements.close; cbn [fst snd]; rewrite Hh; lra)) as E3.
    unfold Statements.dist2 in *. cbn [fst snd] in *. set (x := fst c - fst p) in *. set (y := snd c - snd p) in *.
    assert (F2 : fst c + h / 2 - fst p == x + (1 # 2) * h) by (unfold x; rewrite Hh; ring). assert (F3 : fst c - h / 2 - fst p == x - (1 # 2) * h) by (unfold x; rewrite Hh; ring).
    rewrite F2 in E2. rewrite F3 in E3. assert (Hp : 0 < h * h) by (apply Qmult_lt_0_compat; exact H).
    assert (G : (x + (1 # 2) * h) * (x + (1 # 2) * h) + y * y + ((x - (1 # 2) * h) * (x - (1 # 2) * h) + y * y) == 2 * (x * x + y * y) + (1 # 2) * (h * h)) by ring. lra.
  - apply closure_dist. intros z u Z Hu. destruct (Qlt_le_dec (Statements.dist2 z u) (s * s)) as [L|]; [exfalso|assumption].
    destruct (root_below _ _ (dist2_nonneg z u) S0 L) as (d & (D0 & Dl) & Dd). rewrite dist2_sym in Dd.
    pose proof (triangle u z p d b D0 ltac:(unfold b; lra) Dd (In_ z Z)) as T. pose proof (Out u Hu).
    pose proof (sq_lt (d + b) (r - e) ltac:(unfold b; lra) ltac:(unfold b; lra)). lra.
Qed.
