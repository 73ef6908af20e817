(* From rational shapes to integer ones: scaling by a common denominator keeps winding numbers. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Solid Gaps.
From Exactsweep Require Statements.
Import ListNotations.
Open Scope Z_scope.

(* K times q is the integer n. *)
Definition at_ (K : Z) (q : Q) (n : Z) : Prop := (q * inject_Z K == inject_Z n)%Q.
Definition pat (K : Z) (p : Statements.point) (v : pt) : Prop := at_ K (fst p) (fst v) /\ at_ K (snd p) (snd v).
Definition rings_at (K : Z) (rs : list Statements.ring) (ns : list ring) : Prop := Forall2 (Forall2 (pat K)) rs ns.

Lemma inject_pos K : 0 < K -> (0 < inject_Z K)%Q.
Proof. intro H. change 0%Q with (inject_Z 0). rewrite <- Zlt_Qlt. exact H. Qed.

Lemma at_le K q r n m : 0 < K -> at_ K q n -> at_ K r m -> ((q <= r)%Q <-> n <= m).
Proof.
  unfold at_. intros P A B. pose proof (inject_pos K P) as H. rewrite Zle_Qle, <- A, <- B. split; intro C.
  - apply Qmult_le_compat_r; [exact C|lra].
  - apply (Qmult_lt_0_le_reg_r _ _ _ H C).
Qed.
Lemma at_leb K q r n m : 0 < K -> at_ K q n -> at_ K r m -> Qle_bool q r = (n <=? m).
Proof.
  intros P A B. pose proof (at_le K q r n m P A B) as H. rewrite <- Qle_bool_iff in H.
  destruct (Z.leb_spec n m), (Qle_bool q r); try reflexivity; [rewrite (proj2 H); auto|].
  pose proof (proj1 H eq_refl). lia.
Qed.
Lemma at_less K q r n m : 0 < K -> at_ K q n -> at_ K r m -> Statements.less q r = (n <? m).
Proof. intros P A B. unfold Statements.less. rewrite (at_leb K r q m n P B A). symmetry. apply Z.ltb_antisym. Qed.
Lemma at_zero K : at_ K 0 0.
Proof. unfold at_. change (inject_Z 0) with 0%Q. ring. Qed.

Lemma orient_at K a b z a' b' z' : pat K a a' -> pat K b b' -> pat K z z' ->
  at_ (K * K) (Statements.orient a b z) (det a' b' z').
Proof.
  intros (A & B) (C & D) (E & F). unfold at_ in *. unfold Statements.orient, det.
  repeat (rewrite ?inject_Z_mult, ?inject_Z_plus, ?inject_Z_opp || unfold Z.sub).
  rewrite <- A, <- B, <- C, <- D, <- E, <- F. ring.
Qed.

Lemma crossing_at K a b z a' b' z' : 0 < K -> pat K a a' -> pat K b b' -> pat K z z' ->
  Statements.crossing z (a, b) = cross (a', b') z'.
Proof.
  intros P A B C. pose proof (orient_at K a b z a' b' z' A B C) as O.
  assert (P2 : 0 < K * K) by nia. destruct A as (A1 & A), B as (B1 & B), C as (C1 & C).
  unfold Statements.crossing, cross.
  rewrite (at_leb K _ _ _ _ P A C), (at_less K _ _ _ _ P C B), (at_leb K _ _ _ _ P B C), (at_less K _ _ _ _ P C A).
  rewrite (at_less (K * K) _ _ _ _ P2 (at_zero _) O), (at_less (K * K) _ _ _ _ P2 O (at_zero _)). reflexivity.
Qed.

Definition edge_at (K : Z) (e : Statements.point * Statements.point) (f : edge) := pat K (fst e) (fst f) /\ pat K (snd e) (snd f).

Lemma edges_at K r n : Forall2 (pat K) r n -> Forall2 (edge_at K) (Statements.edges r) (edges n).
Proof.
  intro H. destruct H as [|p v t w P T]; [constructor|]. cbn [Statements.edges edges].
  assert (A : Forall2 (pat K) (p :: t) (v :: w)) by (constructor; assumption).
  assert (B : Forall2 (pat K) (t ++ [p]) (w ++ [v])) by (apply Forall2_app; [assumption|constructor; [assumption|constructor]]).
  revert A B. generalize (t ++ [p]) (w ++ [v]) (p :: t) (v :: w). clear. intros l m a b A. revert l m.
  induction A as [|x y a b X A IH]; intros l m B; [constructor|].
  destruct B as [|u u' l m U B]; [constructor|]. cbn [combine]. constructor; [split; assumption|apply IH, B].
Qed.

Lemma all_edges_at K rs ns : rings_at K rs ns -> Forall2 (edge_at K) (flat_map Statements.edges rs) (flat_map edges ns).
Proof.
  induction 1 as [|r n rs ns H R IH]; [constructor|]. cbn [flat_map]. apply Forall2_app; [apply edges_at, H|exact IH].
Qed.

Lemma winding_at K rs ns z z' : 0 < K -> rings_at K rs ns -> pat K z z' ->
  Statements.winding rs z = wind (flat_map edges ns) z'.
Proof.
  intros P R Z. unfold Statements.winding. apply all_edges_at in R. induction R as [|(a & b) (a' & b') es fs (A & B) R IH]; [reflexivity|].
  cbn [map fold_right wind]. rewrite IH. f_equal. apply (crossing_at K); assumption.
Qed.

(* Scaling *)
Lemma pat_grow D k p v : pat D p v -> pat (k * D) p (grow k v).
Proof.
  unfold pat, at_, grow. cbn [fst snd]. intros (A & B). rewrite !inject_Z_mult, <- A, <- B. split; ring.
Qed.
Lemma pat_grow' D k p v : pat k p v -> pat (k * D) p (grow D v).
Proof. rewrite Z.mul_comm. apply pat_grow. Qed.

Lemma rings_grow D k rs ns : rings_at D rs ns -> rings_at (k * D) rs (map (map (grow k)) ns).
Proof.
  unfold rings_at. induction 1 as [|r n rs ns H R IH]; [constructor|]. cbn [map]. constructor; [|exact IH].
  clear R IH. induction H; constructor; [apply pat_grow|]; assumption.
Qed.

Lemma W_edges k ns z : wind (flat_map edges (map (map (grow k)) ns)) z = W k ns z.
Proof.
  induction ns as [|n r IH]; [reflexivity|]. rewrite W_cons, <- IH. cbn [map flat_map]. rewrite wind_app. reflexivity.
Qed.

Lemma winding_W D k rs ns z v : 0 < D -> 0 < k -> rings_at D rs ns -> pat k z v ->
  Statements.winding rs z = W k ns (grow D v).
Proof.
  intros P K R Z. rewrite <- W_edges. apply (winding_at (k * D)); [nia|apply rings_grow, R|apply pat_grow', Z].
Qed.

(* Every two points have a common denominator. *)
Lemma at_common q r s t : exists k a b c d, 0 < k /\ at_ k q a /\ at_ k r b /\ at_ k s c /\ at_ k t d.
Proof.
  destruct q as [q q'], r as [r r'], s as [s s'], t as [t t'].
  exists (Zpos q' * Zpos r' * Zpos s' * Zpos t'),
    (q * (Zpos r' * Zpos s' * Zpos t')), (r * (Zpos q' * Zpos s' * Zpos t')),
    (s * (Zpos q' * Zpos r' * Zpos t')), (t * (Zpos q' * Zpos r' * Zpos s')).
  split; [lia|]. unfold at_, Qeq, inject_Z, Qmult. cbn [Qnum Qden].
  rewrite !Pos2Z.inj_mul. repeat split; ring.
Qed.
Lemma pat_common y z : exists k v w, 0 < k /\ pat k y v /\ pat k z w.
Proof.
  destruct (at_common (fst y) (snd y) (fst z) (snd z)) as (k & a & b & c & d & K & A & B & C & E).
  exists k, (a, b), (c, d). repeat split; assumption.
Qed.


(* Numbers at a common denominator. Fractions are reduced first; `move` does not reduce. *)
Definition integral (D : Z) (q : Q) : bool := D mod (QDen (Qred q)) =? 0.
Definition int (D : Z) (q : Q) : Z := Qnum (Qred q) * (D / QDen (Qred q)).
Lemma int_at D q : integral D q = true -> at_ D q (int D q).
Proof.
  unfold integral, int, at_. rewrite <- (Qred_correct q) at 2. generalize (Qred q). clear q. intros q H.
  apply Z.eqb_eq in H. destruct q as [n d]. cbn [Qnum Qden] in *.
  pose proof (Z.div_mod D (Zpos d) ltac:(lia)) as E. rewrite H, Z.add_0_r in E.
  unfold Qeq, Qmult, inject_Z. cbn [Qnum Qden]. rewrite Pos.mul_1_r, Z.mul_1_r. rewrite E at 1. ring.
Qed.
Definition int_point (D : Z) (p : Statements.point) : pt := (int D (fst p), int D (snd p)).
Definition int_rings (D : Z) (rs : list Statements.ring) : list ring := map (map (int_point D)) rs.
Definition all_integral (D : Z) (rs : list Statements.ring) : bool :=
  forallb (forallb (fun p => integral D (fst p) && integral D (snd p))) rs.
Lemma int_rings_at D rs : all_integral D rs = true -> rings_at D rs (int_rings D rs).
Proof.
  unfold all_integral, rings_at, int_rings. induction rs as [|r rs IH]; intro H; [constructor|].
  cbn [forallb] in H. apply andb_prop in H as (H & R). cbn [map]. constructor; [|apply IH, R]. clear IH R.
  induction r as [|p r IH]; [constructor|]. cbn [forallb] in H. apply andb_prop in H as (H & R).
  apply andb_prop in H as (H1 & H2). cbn [map]. constructor; [|apply IH, R].
  split; apply int_at; assumption.
Qed.

(* Closures preserve distances. *)
Open Scope Q_scope.
Lemma abs_bound (a : Q) : - (a * a + 1) <= a <= a * a + 1.
Proof. split; nra. Qed.

Lemma product_bound (a m d e : Q) : - m <= a <= m -> - e < d < e -> 0 <= m -> - (m * e) <= a * d <= m * e.
Proof.
  intros (A & B) (C & D) M.
  assert (0 <= (m - a) * (e + d)) by (apply Qmult_le_0_compat; lra).
  assert (0 <= (m + a) * (e - d)) by (apply Qmult_le_0_compat; lra).
  assert (0 <= (m + a) * (e + d)) by (apply Qmult_le_0_compat; lra).
  assert (0 <= (m - a) * (e - d)) by (apply Qmult_le_0_compat; lra).
  split; lra.
Qed.

Lemma closure_dist d (A B : Statements.point -> Prop) : (forall y z, A y -> B z -> d * d <= Statements.dist2 y z) -> Statements.at_least d A B.
Proof.
  intros H y z Y Z. destruct (Qlt_le_dec (Statements.dist2 y z) (d * d)) as [L|]; [exfalso|assumption].
  unfold Statements.dist2 in *. set (u := fst y - fst z) in *. set (v := snd y - snd z) in *.
  set (m := u * u + v * v + 1). set (r := d * d - (u * u + v * v)).
  assert (R : 0 < r) by (unfold r; lra).
  assert (U2 : 0 <= u * u) by nra. assert (V2 : 0 <= v * v) by nra.
  assert (M : 0 < m) by (unfold m; lra).
  set (e := r / (8 * (m + 1) + r)).
  assert (E : e * (8 * (m + 1) + r) == r) by (unfold e; field; lra).
  assert (E0 : 0 < e) by (unfold e; apply Qlt_shift_div_l; lra).
  assert (E1 : e < 1) by (unfold e; apply Qlt_shift_div_r; lra).
  destruct (Y e E0) as (y' & Sy & (Y1 & Y2) & Y3 & Y4). destruct (Z e E0) as (z' & Tz & (Z1 & Z2) & Z3 & Z4).
  specialize (H y' z' Sy Tz).
  set (p := (fst y' - fst y) - (fst z' - fst z)). set (q := (snd y' - snd y) - (snd z' - snd z)).
  assert (P : - (2 * e) < p < 2 * e) by (unfold p; lra). assert (Q0 : - (2 * e) < q < 2 * e) by (unfold q; lra).
  assert (Hp : fst y' - fst z' == u + p) by (unfold u, p; ring).
  assert (Hq : snd y' - snd z' == v + q) by (unfold v, q; ring).
  rewrite Hp, Hq in H.
  assert (Um : - m <= u <= m) by (pose proof (abs_bound u); unfold m; lra).
  assert (Vm : - m <= v <= m) by (pose proof (abs_bound v); unfold m; lra).
  pose proof (product_bound u m p (2 * e) Um P ltac:(lra)) as B1.
  pose proof (product_bound v m q (2 * e) Vm Q0 ltac:(lra)) as B2.
  pose proof (product_bound p (2 * e) p (2 * e) ltac:(lra) P ltac:(lra)) as B3.
  pose proof (product_bound q (2 * e) q (2 * e) ltac:(lra) Q0 ltac:(lra)) as B4.
  assert (E2 : e * e <= e) by nra.
  assert (0 < e * r) by (apply Qmult_lt_0_compat; assumption).
  unfold r in *. nra.
Qed.
