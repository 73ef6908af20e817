(* Why rational points suffice: the claims extend to real points, given by rational approximations. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Scaling Near.
Import ListNotations.
Open Scope Q_scope.

(* Real points: sequences of rational points; both coordinates of the n-th point have errors of at most 1 / (n + 1) *)
Definition radius (n : nat) : Q := 1 # Pos.of_succ_nat n.
Definition real_point (x : nat -> qpoint) : Prop := forall n m,
  let d := radius n + radius m in - d <= fst (x n) - fst (x m) <= d /\ - d <= snd (x n) - snd (x m) <= d.
Definition real_interior (S : qpoint -> Prop) (x : nat -> qpoint) : Prop :=   (* a square around it, of rational points of S *)
  exists n e, radius n < e /\ forall y, Statements.close e y (x n) -> S y.
Definition real_closure (S : qpoint -> Prop) (x : nat -> qpoint) : Prop :=
  forall n, exists y, S y /\ Statements.close (2 * radius n) y (x n).

Lemma radius_pos n : 0 < radius n.
Proof. reflexivity. Qed.
Lemma radius_small e : 0 < e -> exists n, forall m, (n <= m)%nat -> radius m < e.
Proof.
  intro E. exists (Pos.to_nat (Qden e)). intros m L. unfold radius, Qlt in *. cbn [Qnum Qden] in *.
  assert (P : (Zpos (Qden e) < Zpos (Pos.of_succ_nat m))%Z) by lia. nia.
Qed.
(* A real point in the interiors of two sets proves an overlap. *)
Theorem real_overlap S T x : real_point x -> real_interior S x -> real_interior T x -> Statements.overlap S T.
Proof.
  intros R (n & e & E & HS) (m & d & D & HT).
  destruct (below (e - radius n) (d - radius m)) as (c & C & C1 & C2); [lra|lra|].
  destruct (radius_small (c / 2)) as (k & K); [apply Qlt_shift_div_l; lra|]. specialize (K k (le_n k)).
  assert (H2 : c / 2 == (1 # 2) * c) by field. pose proof (R k n) as (Rn1 & Rn2). pose proof (R k m) as (Rm1 & Rm2).
  exists (x k). split; exists (c / 2); (split; [lra|]); intros y (Y1 & Y2); [apply HS|apply HT]; unfold Statements.close in *; lra.
Qed.
(* Two real points in the closures of two sets at distance d: for each c < d, the approximations are eventually at a
   distance greater than c. *)
Theorem real_at_least d S T x y : Statements.at_least d S T -> real_closure S x -> real_closure T y ->
  forall c, 0 <= c -> c < d -> exists n, forall m, (n <= m)%nat -> c * c < Statements.dist2 (x m) (y m).
Proof.
  intros A X Y c C L. destruct (radius_small ((d - c) / 6)) as (n & N); [apply Qlt_shift_div_l; lra|]. exists n. intros m M. specialize (N m M).
  assert (H6 : (d - c) / 6 == (1 # 6) * (d - c)) by field. pose proof (radius_pos m) as Rp. set (r := radius m) in *.
  destruct (X m) as (s & Ss & Sx1 & Sx2). destruct (Y m) as (t & Tt & Ty1 & Ty2). fold r in Sx1, Sx2, Ty1, Ty2.
  destruct (Qlt_le_dec (c * c) (Statements.dist2 (x m) (y m))) as [|G]; [assumption|exfalso].
  assert (B : forall u v, - (2 * r) < u < 2 * r -> - (2 * r) < v < 2 * r -> u * u + v * v <= 3 * r * (3 * r)) by (intros; nra).
  pose proof (B _ _ Sx1 Sx2) as B1. pose proof (B _ _ Ty1 Ty2) as B2.
  assert (D1 : Statements.dist2 s (x m) <= 3 * r * (3 * r)) by (unfold Statements.dist2; lra).
  assert (D2 : Statements.dist2 (y m) t <= 3 * r * (3 * r)) by (unfold Statements.dist2 in *; lra).
  pose proof (triangle s (x m) (y m) (3 * r) c ltac:(lra) C D1 G) as T1.
  pose proof (triangle s (y m) t (3 * r + c) (3 * r) ltac:(lra) ltac:(lra) T1 D2) as T2.
  pose proof (A s t (fun e E => ex_intro _ s (conj Ss (close_refl e s E))) (fun e E => ex_intro _ t (conj Tt (close_refl e t E)))) as F.
  pose proof (sq_lt (3 * r + c + 3 * r) d ltac:(lra) ltac:(lra)). lra.
Qed.

(* Rotations with an error.  Two motions whose cosines and sines differ by d and d' map a point with |x| + |y| <= r to
   points at distance (d + d') r or less.  Let a figure lie within distance `round` of a core whose points satisfy this
   bound, and move its true shape, known up to e, by a rotation m'.  Then the core moved by m, with the same radius, is
   the moved shape up to e + (d + d') r.  As m' preserves distances, neither the radius nor e is multiplied. *)
Definition moved_by (m : Statements.motion) (S : qpoint -> Prop) (z : qpoint) : Prop := exists p, S p /\ z = Statements.move m p.
Definition bounded (r : Q) (p : qpoint) : Prop := exists a b, - a <= fst p <= a /\ - b <= snd p <= b /\ a + b <= r.
Lemma move_near m m' d d' r p : Statements.mirrored m = Statements.mirrored m' -> Statements.shift m = Statements.shift m' ->
  - d <= Statements.cosine m - Statements.cosine m' <= d -> - d' <= Statements.sine m - Statements.sine m' <= d' -> 0 <= r -> bounded r p ->
  Statements.dist2 (Statements.move m p) (Statements.move m' p) <= (d + d') * r * ((d + d') * r).
Proof.
  intros E F C S R (a & b & A & B & L). unfold Statements.dist2, Statements.move. rewrite <- E, <- F. cbn [fst snd].
  set (x := if Statements.mirrored m then - fst p else fst p). assert (X : - a <= x <= a) by (unfold x; destruct (Statements.mirrored m); lra).
  set (y := snd p) in *. set (c := Statements.cosine m - Statements.cosine m') in *. set (s := Statements.sine m - Statements.sine m') in *.
  assert (E1 : Statements.cosine m * x - Statements.sine m * y + fst (Statements.shift m) - (Statements.cosine m' * x - Statements.sine m' * y + fst (Statements.shift m)) == c * x - s * y)
    by (unfold c, s; ring).
  assert (E2 : Statements.sine m * x + Statements.cosine m * y + snd (Statements.shift m) - (Statements.sine m' * x + Statements.cosine m' * y + snd (Statements.shift m)) == s * x + c * y)
    by (unfold c, s; ring).
  rewrite E1, E2. assert (E3 : (c * x - s * y) * (c * x - s * y) + (s * x + c * y) * (s * x + c * y) == (c * c + s * s) * (x * x + y * y)) by ring.
  rewrite E3. assert (H1 : c * c + s * s <= (d + d') * (d + d')) by nra. assert (H2 : x * x + y * y <= r * r) by nra.
  assert (H0 : 0 <= x * x + y * y) by nra. assert (H3 : 0 <= (d + d') * (d + d')) by nra.
  pose proof (Qmult_le_compat_r _ _ (x * x + y * y) H1 H0). pose proof (mono_le _ _ _ H3 H2).
  assert (E4 : (d + d') * r * ((d + d') * r) == (d + d') * (d + d') * (r * r)) by ring. lra.
Qed.
Lemma move_isometry m p q : Statements.cosine m * Statements.cosine m + Statements.sine m * Statements.sine m == 1 ->
  Statements.dist2 (Statements.move m p) (Statements.move m q) == Statements.dist2 p q.
Proof.
  intro E. unfold Statements.dist2, Statements.move. destruct (Statements.mirrored m); cbn [fst snd];
    rewrite <- (Qmult_1_l ((fst p - fst q) * (fst p - fst q) + (snd p - snd q) * (snd p - snd q))), <- E; ring.
Qed.
Theorem rotation_error_sound m m' d d' r round e (core drawn S : qpoint -> Prop) :
  Statements.mirrored m = Statements.mirrored m' -> Statements.shift m = Statements.shift m' ->
  - d <= Statements.cosine m - Statements.cosine m' <= d -> - d' <= Statements.sine m - Statements.sine m' <= d' ->
  Statements.cosine m' * Statements.cosine m' + Statements.sine m' * Statements.sine m' == 1 -> 0 <= r -> 0 <= round -> 0 <= e ->
  (forall p, core p -> bounded r p) -> Statements.known_to round core drawn -> Statements.known_to e drawn S ->
  Statements.known_to (e + (d + d') * r) (Statements.within round (moved_by m core)) (moved_by m' S).
Proof.
  intros E F C Si Rot R R0 E0 B Kd K z (p & Sp & ->) t T H. set (D := (d + d') * r) in *.
  assert (D0 : 0 <= D) by (apply Qmult_le_0_compat; lra).
  set (g := (t - e - D) / 4). assert (Eg : g == (1 # 4) * (t - e - D)) by (unfold g; field).
  apply (K p Sp (e + g) ltac:(lra)). intros y Y.
  destruct (Qlt_le_dec ((e + g) * (e + g)) (Statements.dist2 y p)) as [|Gy]; [assumption|exfalso].
  apply (Kd y Y (round + g) ltac:(lra)). intros v V.
  destruct (Qlt_le_dec ((round + g) * (round + g)) (Statements.dist2 v y)) as [|Gv]; [assumption|exfalso].
  pose proof (triangle v y p (round + g) (e + g) ltac:(lra) ltac:(lra) Gv Gy) as T1. rewrite <- (move_isometry m' v p Rot) in T1.
  pose proof (move_near m m' d d' r v E F C Si R (B v V)) as N. fold D in N.
  pose proof (triangle (Statements.move m v) (Statements.move m' v) (Statements.move m' p) D (round + g + (e + g)) D0 ltac:(lra) N T1) as T2.
  set (w := Statements.move m v) in *. set (z := Statements.move m' p) in *. set (q := e + D + 2 * g).
  assert (Q0 : 0 < q) by (unfold q; lra). assert (L : q < t) by (unfold q; lra).
  assert (Eq : D + (round + g + (e + g)) == round + q) by (unfold q; ring). rewrite Eq in T2.
  (* u: the point that divides the segment from w to z in the ratio round to q *)
  set (s := round / (round + q)). assert (Es : s * (round + q) == round) by (unfold s; field; lra).
  assert (Es' : (1 - s) * (round + q) == q) by lra.
  set (u := (fst w + s * (fst z - fst w), snd w + s * (snd z - snd w))).
  assert (Uw : Statements.dist2 w u == s * s * Statements.dist2 w z) by (unfold Statements.dist2, u; cbn [fst snd]; ring).
  assert (Uz : Statements.dist2 u z == (1 - s) * (1 - s) * Statements.dist2 w z) by (unfold Statements.dist2, u; cbn [fst snd]; ring).
  assert (Sq : forall a, a * a * Statements.dist2 w z <= a * (round + q) * (a * (round + q))).
  { intro a. pose proof (mono_le (a * a) _ _ (sq_nonneg a) T2) as M. assert (X : a * (round + q) * (a * (round + q)) == a * a * ((round + q) * (round + q))) by ring. lra. }
  pose proof (Sq s) as S1. pose proof (Sq (1 - s)) as S2. rewrite Es in S1. rewrite Es' in S2.
  assert (Wu : Statements.within round (moved_by m core) u).
  { intros k Lk G. specialize (G w (ex_intro _ v (conj V eq_refl))). pose proof (sq_lt round k R0 Lk). lra. }
  pose proof (H u Wu). pose proof (sq_lt q t ltac:(lra) L). lra.
Qed.
