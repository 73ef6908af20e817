(* Sets known up to an error, on two sides of a gap: they do not overlap and keep a distance. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Scaling.
Import ListNotations.
Open Scope Q_scope.

Notation qpoint := Statements.point.
Definition along (n z : qpoint) : Q := fst n * fst z + snd n * snd z.
Definition square_of (n : qpoint) : Q := fst n * fst n + snd n * snd n.

Lemma sq_nonneg (a : Q) : 0 <= a * a.
Proof. nra. Qed.
Lemma sq_lt a b : 0 <= a -> a < b -> a * a < b * b.
Proof. intros. nra. Qed.
Lemma sq_le a b : 0 <= a -> a <= b -> a * a <= b * b.
Proof. intros. nra. Qed.

(* Cauchy's inequality *)
Lemma cauchy n y z d : 0 <= d -> Statements.dist2 y z <= d * d -> (along n z - along n y) * (along n z - along n y) <= square_of n * (d * d).
Proof.
  intros D H. pose proof (sq_nonneg (fst n * (snd z - snd y) - snd n * (fst z - fst y))) as P.
  assert (E : (along n z - along n y) * (along n z - along n y) ==
    square_of n * Statements.dist2 y z - (fst n * (snd z - snd y) - snd n * (fst z - fst y)) * (fst n * (snd z - snd y) - snd n * (fst z - fst y)))
    by (unfold along, square_of, Statements.dist2; ring).
  assert (N : 0 <= square_of n) by (unfold square_of; pose proof (sq_nonneg (fst n)); pose proof (sq_nonneg (snd n)); lra).
  pose proof (mono_le (square_of n) _ _ N H). lra.
Qed.

Lemma add_roots N c d x y : 0 <= N -> 0 <= c -> 0 <= d -> x * x <= N * (c * c) -> y * y <= N * (d * d) ->
  (x + y) * (x + y) <= N * ((c + d) * (c + d)).
Proof.
  intros HN C D X Y. assert (P : x * y <= N * (c * d)).
  { destruct (Qlt_le_dec (N * (c * d)) (x * y)) as [L|L]; [exfalso|exact L].
    assert (0 <= c * d) by (apply Qmult_le_0_compat; assumption). assert (0 <= N * (c * d)) by (apply Qmult_le_0_compat; assumption).
    pose proof (sq_lt _ _ H0 L) as S.
    assert (M1 : (x * x) * (y * y) <= (N * (c * c)) * (y * y)) by (apply Qmult_le_compat_r; [exact X|apply sq_nonneg]).
    assert (M2 : (y * y) * (N * (c * c)) <= (N * (d * d)) * (N * (c * c)))
      by (apply Qmult_le_compat_r; [exact Y|apply Qmult_le_0_compat; [exact HN|apply sq_nonneg]]).
    assert (E1 : (x * x) * (y * y) == x * y * (x * y)) by ring. assert (E2 : (y * y) * (N * (c * c)) == (N * (c * c)) * (y * y)) by ring.
    assert (E3 : (N * (d * d)) * (N * (c * c)) == N * (c * d) * (N * (c * d))) by ring. lra. }
  assert (E : (x + y) * (x + y) == x * x + y * y + 2 * (x * y)) by ring.
  assert (F : N * ((c + d) * (c + d)) == N * (c * c) + N * (d * d) + 2 * (N * (c * d))) by ring. lra.
Qed.

(* The limit of bounds for all d > r *)
Lemma square_limit N r x : 0 <= N -> 0 <= r -> (forall d, r < d -> x * x <= N * (d * d)) -> x * x <= N * (r * r).
Proof.
  intros HN R H. destruct (Qlt_le_dec (N * (r * r)) (x * x)) as [L|L]; [exfalso|exact L].
  set (k := N * (2 * r + 1) + 1). assert (K : 0 < k) by (assert (0 <= N * (2 * r + 1)) by (apply Qmult_le_0_compat; lra); unfold k; lra).
  set (v := x * x - N * (r * r)) in *. assert (V : 0 < v / (2 * k)) by (apply Qlt_shift_div_l; unfold v; lra).
  destruct (below 1 (v / (2 * k))) as (e & E & E1 & E2); [lra|exact V|].
  specialize (H (r + e) ltac:(lra)).
  assert (F : N * ((r + e) * (r + e)) == N * (r * r) + N * (2 * r + e) * e) by ring. rewrite F in H.
  assert (G : N * (2 * r + e) * e <= k * e).
  { apply Qmult_le_compat_r; [|lra]. pose proof (mono_le N (2 * r + e) (2 * r + 1) HN ltac:(lra)). unfold k. lra. }
  pose proof (mono_le k e _ ltac:(lra) E2) as J. assert (M : k * (v / (2 * k)) == v / 2) by (field; lra). rewrite M in J.
  assert (T : v / 2 == (1 # 2) * v) by field. rewrite T in J. unfold v in *. lra.
Qed.

(* n: a normal.  A: a set below the bound a in direction n.  B: a set above the bound b. *)
Section Gap.
Variables (n : qpoint) (a b r r' s : Q) (A B : qpoint -> Prop).
Hypothesis HA : forall y, A y -> along n y <= a.
Hypothesis HB : forall y, B y -> b <= along n y.
Hypothesis R : 0 <= r.
Hypothesis R' : 0 <= r'.
Hypothesis S0 : 0 <= s.
Hypothesis Nz : 0 < square_of n.
Hypothesis Order : a <= b.
Hypothesis Wide : (s + r + r') * (s + r + r') * square_of n <= (b - a) * (b - a).

Lemma near_gap z w : Statements.within r A z -> Statements.within r' B w -> along n w - along n z <= b - a ->
  (b - a - (along n w - along n z)) * (b - a - (along n w - along n z)) <= square_of n * ((r + r') * (r + r')).
Proof.
  intros Wz Ww T. apply square_limit; [lra|lra|]. intros d D. set (e := (d - (r + r')) / 2).
  assert (E2 : e == (1 # 2) * (d - (r + r'))) by (unfold e; field). assert (E : 0 < e) by lra.
  match goal with |- ?l <= ?h => destruct (Qlt_le_dec h l) as [No|]; [exfalso|assumption] end.
  apply (Wz (r + e) ltac:(lra)). intros y Y. destruct (Qlt_le_dec ((r + e) * (r + e)) (Statements.dist2 y z)) as [|Dy]; [assumption|exfalso].
  apply (Ww (r' + e) ltac:(lra)). intros v V. destruct (Qlt_le_dec ((r' + e) * (r' + e)) (Statements.dist2 v w)) as [|Dv]; [assumption|exfalso].
  apply HA in Y. apply HB in V. pose proof (cauchy n y z (r + e) ltac:(lra) Dy) as C. pose proof (cauchy n v w (r' + e) ltac:(lra) Dv) as C'.
  set (x := along n z - along n y) in *. set (x' := along n v - along n w).
  assert (Cx : x' * x' == (along n w - along n v) * (along n w - along n v)) by (unfold x'; ring).
  rewrite <- Cx in C'. pose proof (add_roots (square_of n) (r + e) (r' + e) x x' ltac:(lra) ltac:(lra) ltac:(lra) C C') as P.
  assert (L : b - a - (along n w - along n z) <= x + x') by (unfold x, x'; lra).
  pose proof (sq_le (b - a - (along n w - along n z)) (x + x') ltac:(lra) L) as Q0. assert (De : (r + e + (r' + e)) == d) by lra. rewrite De in P. lra.
Qed.

Lemma gap_distance z w : Statements.within r A z -> Statements.within r' B w -> s * s <= Statements.dist2 z w.
Proof.
  intros Wz Ww. destruct (Qlt_le_dec (Statements.dist2 z w) (s * s)) as [L|L]; [exfalso|exact L].
  set (D := Statements.dist2 z w) in *. assert (D0 : 0 <= D) by (unfold D, Statements.dist2; pose proof (sq_nonneg (fst z - fst w)); pose proof (sq_nonneg (snd z - snd w)); lra).
  assert (Sp : 0 < s). { destruct (Qlt_le_dec 0 s) as [|Z]; [assumption|]. assert (E : s == 0) by lra. rewrite E in L. lra. }
  set (d := (D + s * s) / (2 * s)). assert (Ed : d * (2 * s) == D + s * s) by (unfold d; field; lra).
  assert (Dp : 0 < d) by (unfold d; apply Qlt_shift_div_l; lra).
  assert (Dl : d < s) by (unfold d; apply Qlt_shift_div_r; lra).
  assert (Dd : D <= d * d).
  { pose proof (sq_nonneg (s - d)) as P. assert (F : (s - d) * (s - d) == s * s + d * d - d * (2 * s)) by ring. lra. }
  pose proof (cauchy n z w d ltac:(lra) Dd) as C. set (t := along n w - along n z) in *.
  assert (Big : square_of n * ((r + r' + d) * (r + r' + d)) < (b - a) * (b - a)).
  { pose proof (sq_lt (r + r' + d) (s + r + r') ltac:(lra) ltac:(lra)) as P. pose proof (mono_lt (square_of n) _ _ Nz P). lra. }
  destruct (Qlt_le_dec (b - a) t) as [T|T].
  - pose proof (sq_lt (b - a) t ltac:(lra) T). pose proof (sq_le d (r + r' + d) ltac:(lra) ltac:(lra)) as P.
    pose proof (mono_le (square_of n) _ _ ltac:(lra) P). lra.
  - pose proof (near_gap z w Wz Ww T) as P. fold t in P.
    pose proof (add_roots (square_of n) (r + r') d (b - a - t) t ltac:(lra) ltac:(lra) ltac:(lra) P C) as Q0.
    assert (E : b - a - t + t == b - a) by ring. rewrite E in Q0. lra.
Qed.

Lemma gap_order z w : Statements.within r A z -> Statements.within r' B w -> along n z <= along n w.
Proof.
  intros Wz Ww. destruct (Qlt_le_dec (along n w) (along n z)) as [L|L]; [exfalso|exact L].
  pose proof (near_gap z w Wz Ww ltac:(lra)) as P.
  pose proof (sq_lt (b - a) (b - a - (along n w - along n z)) ltac:(lra) ltac:(lra)) as Q0.
  pose proof (sq_le (r + r') (s + r + r') ltac:(lra) ltac:(lra)) as M. pose proof (mono_le (square_of n) _ _ ltac:(lra) M) as M2. lra.
Qed.
End Gap.

(* Finitely many lines do not cover an open square. *)
Definition thin (P : qpoint -> Prop) (n : qpoint) : Prop := forall y z, P y -> P z -> along n y == along n z.
Lemma not_covered (l : list (qpoint -> Prop)) c e : 0 < e ->
  (forall P, In P l -> exists n, 0 < square_of n /\ thin P n) ->
  (forall y, Statements.close e y c -> ~ ~ exists P, In P l /\ P y) -> False.
Proof.
  revert c e. induction l as [|P l IH]; intros c e E T C.
  - apply (C c (close_refl e c E)). intros (P & [] & _).
  - destruct (T P (or_introl eq_refl)) as (n & N & Th).
    assert (M : exists u, Statements.close (e / 2) u c /\ 0 < along n u - along n c).
    { assert (H2 : e / 2 == (1 # 2) * e) by field. unfold square_of in N.
      destruct (Qlt_le_dec 0 (fst n)) as [P1|P1]; [exists (fst c + (1 # 4) * e, snd c); unfold Statements.close, along; cbn [fst snd]; rewrite H2; split; [lra|];
        assert (X : fst n * (fst c + (1 # 4) * e) + snd n * snd c - (fst n * fst c + snd n * snd c) == (1 # 4) * (fst n * e)) by ring; rewrite X; assert (0 < fst n * e) by (apply Qmult_lt_0_compat; assumption); lra|].
      destruct (Qlt_le_dec (fst n) 0) as [P2|P2]; [exists (fst c - (1 # 4) * e, snd c); unfold Statements.close, along; cbn [fst snd]; rewrite H2; split; [lra|];
        assert (X : fst n * (fst c - (1 # 4) * e) + snd n * snd c - (fst n * fst c + snd n * snd c) == (1 # 4) * (- fst n * e)) by ring; rewrite X; assert (0 < - fst n * e) by (apply Qmult_lt_0_compat; lra); lra|].
      assert (F0 : fst n == 0) by lra. rewrite F0 in N.
      destruct (Qlt_le_dec 0 (snd n)) as [P3|P3]; [exists (fst c, snd c + (1 # 4) * e); unfold Statements.close, along; cbn [fst snd]; rewrite H2; split; [lra|];
        assert (X : fst n * fst c + snd n * (snd c + (1 # 4) * e) - (fst n * fst c + snd n * snd c) == (1 # 4) * (snd n * e)) by ring; rewrite X; assert (0 < snd n * e) by (apply Qmult_lt_0_compat; assumption); lra|].
      destruct (Qlt_le_dec (snd n) 0) as [P4|P4]; [exists (fst c, snd c - (1 # 4) * e); unfold Statements.close, along; cbn [fst snd]; rewrite H2; split; [lra|];
        assert (X : fst n * fst c + snd n * (snd c - (1 # 4) * e) - (fst n * fst c + snd n * snd c) == (1 # 4) * (- snd n * e)) by ring; rewrite X; assert (0 < - snd n * e) by (apply Qmult_lt_0_compat; lra); lra|].
      assert (F1 : snd n == 0) by lra. rewrite F1 in N. lra. }
    destruct M as (u & Cu & U).
    (* near c and near u the values of n differ: P meets at most one of two small squares *)
    set (k := fst n * fst n + snd n * snd n + 1). set (g := along n u - along n c) in *.
    assert (A2 : 0 <= fst n * fst n) by apply sq_nonneg. assert (B2 : 0 <= snd n * snd n) by apply sq_nonneg. assert (K : 0 < k) by (unfold k; lra).
    assert (An : - k <= fst n <= k) by (pose proof (abs_bound (fst n)); unfold k; lra).
    assert (Bn : - k <= snd n <= k) by (pose proof (abs_bound (snd n)); unfold k; lra).
    assert (G : 0 < g / (8 * k)) by (apply Qlt_shift_div_l; lra).
    assert (E2 : 0 < e / 2) by (apply Qlt_shift_div_l; lra).
    destruct (below (e / 2) (g / (8 * k)) E2 G) as (d & D & D1 & D2).
    assert (D3 : k * d <= (1 # 8) * g).
    { pose proof (mono_le k d _ ltac:(lra) D2). assert (k * (g / (8 * k)) == (1 # 8) * g) by (field; lra). lra. }
    assert (Near : forall v y, Statements.close d y v -> - (2 * (k * d)) <= along n y - along n v <= 2 * (k * d)).
    { intros v y (Y1 & Y2). unfold along.
      assert (X : fst n * fst y + snd n * snd y - (fst n * fst v + snd n * snd v) == fst n * (fst y - fst v) + snd n * (snd y - snd v)) by ring. rewrite X.
      assert (Bd : forall m h, - k <= m <= k -> - d < h < d -> - (k * d) <= m * h <= k * d).
      { intros m h Hm Hh. destruct (Qlt_le_dec h 0) as [Z|Z].
        - pose proof (prod_bound m k (- h) Hm ltac:(lra)). pose proof (mono_le k (- h) d ltac:(lra) ltac:(lra)). assert (m * - h == - (m * h)) by ring. lra.
        - pose proof (prod_bound m k h Hm Z). pose proof (mono_le k h d ltac:(lra) ltac:(lra)). lra. }
      pose proof (Bd _ _ An Y1). pose proof (Bd _ _ Bn Y2). lra. }
    assert (H2 : e / 2 == (1 # 2) * e) by field.
    (* one of the squares around c and u has no point of P; which one is not decidable *)
    assert (Dc : forall y, Statements.close d y c -> Statements.close e y c) by (unfold Statements.close; intros y Y; lra).
    assert (Du : forall y, Statements.close d y u -> Statements.close e y c) by (unfold Statements.close in *; intros y Y; lra).
    assert (Tl : forall Q0, In Q0 l -> exists m, 0 < square_of m /\ thin Q0 m) by (intros Q0 I; apply T; right; exact I).
    apply (IH c d D Tl). intros y Y N1. apply (C y (Dc y Y)). intros (Q0 & [<-|I] & Py); [|apply N1; exists Q0; auto].
    apply (IH u d D Tl). intros z Z N2. apply (C z (Du z Z)). intros (Q1 & [<-|I] & Pz); [|apply N2; exists Q1; auto].
    pose proof (Th y z Py Pz) as Eq. pose proof (Near c y Y). pose proof (Near u z Z). unfold g in *. lra.
Qed.

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

(* Distances from unions and from neighborhoods *)
Lemma triangle x y z c d : 0 <= c -> 0 <= d -> Statements.dist2 x y <= c * c -> Statements.dist2 y z <= d * d ->
  Statements.dist2 x z <= (c + d) * (c + d).
Proof.
  intros C D X Y. unfold Statements.dist2 in *. set (p := fst x - fst y) in *. set (q := snd x - snd y) in *.
  set (u := fst y - fst z) in *. set (v := snd y - snd z) in *.
  assert (E1 : fst x - fst z == p + u) by (unfold p, u; ring). assert (E2 : snd x - snd z == q + v) by (unfold q, v; ring). rewrite E1, E2.
  assert (P : p * u + q * v <= c * d).
  { destruct (Qlt_le_dec (c * d) (p * u + q * v)) as [L|L]; [exfalso|exact L].
    assert (Cd : 0 <= c * d) by (apply Qmult_le_0_compat; assumption). pose proof (sq_lt _ _ Cd L) as S.
    pose proof (sq_nonneg (p * v - q * u)) as N.
    assert (E : (p * u + q * v) * (p * u + q * v) == (p * p + q * q) * (u * u + v * v) - (p * v - q * u) * (p * v - q * u)) by ring.
    assert (U0 : 0 <= u * u + v * v) by (pose proof (sq_nonneg u); pose proof (sq_nonneg v); lra).
    assert (M1 : (p * p + q * q) * (u * u + v * v) <= (c * c) * (u * u + v * v)) by (apply Qmult_le_compat_r; assumption).
    assert (M2 : (u * u + v * v) * (c * c) <= (d * d) * (c * c)) by (apply Qmult_le_compat_r; [assumption|apply sq_nonneg]).
    assert (E3 : (c * d) * (c * d) == (d * d) * (c * c)) by ring. lra. }
  assert (E : (p + u) * (p + u) + (q + v) * (q + v) == (p * p + q * q) + (u * u + v * v) + 2 * (p * u + q * v)) by ring.
  assert (F : (c + d) * (c + d) == c * c + d * d + 2 * (c * d)) by ring. lra.
Qed.
Lemma within_within e r S z : 0 <= e -> 0 <= r -> Statements.within e (Statements.within r S) z -> Statements.within (e + r) S z.
Proof.
  intros E R W d D F. set (h := (d - (e + r)) / 2). assert (H2 : h == (1 # 2) * (d - (e + r))) by (unfold h; field).
  apply (W (e + h) ltac:(lra)). intros y Y. destruct (Qlt_le_dec ((e + h) * (e + h)) (Statements.dist2 y z)) as [|Dy]; [assumption|exfalso].
  apply (Y (r + h) ltac:(lra)). intros u U. destruct (Qlt_le_dec ((r + h) * (r + h)) (Statements.dist2 u y)) as [|Du]; [assumption|exfalso].
  specialize (F u U). pose proof (triangle u y z (r + h) (e + h) ltac:(lra) ltac:(lra) Du Dy) as T.
  assert (X : r + h + (e + h) == d) by lra. rewrite X in T. lra.
Qed.
Lemma within_more e (S T : qpoint -> Prop) z : (forall y, S y -> T y) -> Statements.within e S z -> Statements.within e T z.
Proof. intros I W d D F. apply (W d D). intros y Y. apply F, I, Y. Qed.
Lemma within_self e (S : qpoint -> Prop) z : 0 <= e -> S z -> Statements.within e S z.
Proof.
  intros E I d D F. specialize (F z I). assert (Z : Statements.dist2 z z == 0) by (unfold Statements.dist2; ring). rewrite Z in F.
  pose proof (sq_nonneg d). lra.
Qed.

Definition region := ((qpoint -> Prop) * Q)%type.     (* a set and a radius around it *)
Definition in_some (l : list region) (z : qpoint) : Prop := ~ forall p, In p l -> ~ Statements.within (snd p) (fst p) z.
Lemma within_union e (l : list region) (S : qpoint -> Prop) z : 0 <= e -> (forall p, In p l -> 0 <= snd p) ->
  (forall y, S y -> in_some l y) -> Statements.within e S z -> in_some (map (fun p => (fst p, e + snd p)) l) z.
Proof.
  intros E0 R Cov W K.
  assert (G : forall m, (forall p, In p m -> In p l) -> ~ ~ exists d, e < d /\ forall p, In p m -> forall y, Statements.within (snd p) (fst p) y -> d * d < Statements.dist2 y z).
  { induction m as [|p m IH]; intros Sub N.
    - apply N. exists (e + 1). split; [lra|]. intros p [].
    - apply IH; [intros q I; apply Sub; right; exact I|]. intros (d & D & H).
      apply (K (fst p, e + snd p)); [exact (in_map (fun p => (fst p, e + snd p)) l p (Sub p (or_introl eq_refl)))|]. cbn [fst snd].
      apply within_within; [exact E0|apply R, Sub; left; reflexivity|]. intros d' D' F. apply N.
      destruct (Qlt_le_dec d d') as [L|L].
      + exists d. split; [exact D|]. intros q [<-|I] y Y; [|exact (H q I y Y)]. specialize (F y Y). pose proof (sq_lt d d' ltac:(lra) L). lra.
      + exists d'. split; [exact D'|]. intros q [<-|I] y Y; [exact (F y Y)|]. specialize (H q I y Y). pose proof (sq_le d' d ltac:(lra) L). lra. }
  apply (G l (fun p I => I)). intros (d & D & H). apply (W d D). intros y Y.
  destruct (Qlt_le_dec (d * d) (Statements.dist2 y z)) as [|L]; [assumption|exfalso].
  apply (Cov y Y). intros p I Wp. specialize (H p I y Wp). lra.
Qed.

(* Two sets covered by regions with pairwise gaps *)
Definition gap_between (s : Q) (p q : region) : Prop := exists n a b,
  (forall y, fst p y -> along n y <= a) /\ (forall y, fst q y -> b <= along n y) /\ 0 < square_of n /\ a <= b /\
  (s + snd p + snd q) * (s + snd p + snd q) * square_of n <= (b - a) * (b - a).
Theorem keeps_regions s (lp lq : list region) (S T : qpoint -> Prop) : 0 <= s ->
  (forall p, In p lp -> 0 <= snd p) -> (forall q, In q lq -> 0 <= snd q) ->
  (forall z, S z -> in_some lp z) -> (forall z, T z -> in_some lq z) ->
  (forall p q, In p lp -> In q lq -> gap_between s p q) -> Statements.keeps s S T.
Proof.
  intros S0 Rp Rq CS CT G. split.
  - intros (c & (e & E & HS) & (e' & E' & HT)). destruct (below e e' E E') as (d & D & D1 & D2).
    set (pairs := flat_map (fun p => map (fun q => fun z => Statements.within (snd p) (fst p) z /\ Statements.within (snd q) (fst q) z) lq) lp).
    apply (not_covered pairs c d D).
    + intros P I. apply in_flat_map in I as (p & Ip & I). apply in_map_iff in I as (q & <- & Iq).
      destruct (G p q Ip Iq) as (n & a & b & A & B & N & O & Wd). exists n. split; [exact N|]. intros y z (Y1 & Y2) (Z1 & Z2).
      pose proof (gap_order n a b (snd p) (snd q) s (fst p) (fst q) A B (Rp p Ip) (Rq q Iq) S0 N O Wd) as Or.
      pose proof (Or y z Y1 Z2). pose proof (Or z y Z1 Y2). lra.
    + intros y Y No. apply (CS y); [apply HS; unfold Statements.close in *; lra|]. intros p Ip Wp.
      apply (CT y); [apply HT; unfold Statements.close in *; lra|]. intros q Iq Wq. apply No.
      eexists. split; [apply in_flat_map; exists p; split; [exact Ip|apply in_map_iff; exists q; split; [reflexivity|exact Iq]]|].
      split; assumption.
  - apply closure_dist. intros y z Y Z. destruct (Qlt_le_dec (Statements.dist2 y z) (s * s)) as [L|]; [exfalso|assumption].
    apply (CS y Y). intros p Ip Wp. apply (CT z Z). intros q Iq Wq. destruct (G p q Ip Iq) as (n & a & b & A & B & N & O & Wd).
    pose proof (gap_distance n a b (snd p) (snd q) s (fst p) (fst q) A B (Rp p Ip) (Rq q Iq) S0 N O Wd y z Wp Wq). lra.
Qed.
