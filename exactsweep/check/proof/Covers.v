(* Boolean tests of covers of segments, and winding numbers along segments that avoid the loops *)
Require Import QArith Qround Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints.
Import ListNotations.
Open Scope Q_scope.

(* 1. Winding numbers are constant along segments that avoid the loops. *)
Lemma total_starts (l m : list pt) k : length l = length m ->
  total (ends (combine l m)) k =
  (total (map (fun p => ((0, 0, 0, p)%Z, 1%Z)) l) k - total (map (fun p => ((0, 0, 0, p)%Z, 1%Z)) m) k)%Z.
Proof.
  revert m. induction l as [|a l IH]; intros [|b m] H; try discriminate; [reflexivity|].
  injection H as H. specialize (IH m H).
  change (total (ends (combine (a :: l) (b :: m))) k) with ((if key_dec (0, 0, 0, a)%Z k then 1 else 0) +
    ((if key_dec (0, 0, 0, b)%Z k then -1 else 0) + total (ends (combine l m)) k))%Z.
  rewrite IH. cbn [map total]. destruct (key_dec (0, 0, 0, a)%Z k), (key_dec (0, 0, 0, b)%Z k); ring.
Qed.
Lemma closed_rings rs : closed (flat_map edges rs).
Proof.
  intro k. induction rs as [|r rs IH]; [reflexivity|]. cbn [flat_map].
  assert (A : forall a b, ends (a ++ b) = ends a ++ ends b) by (intros; apply flat_map_app).
  rewrite A, total_app, IH. clear A IH.
  destruct r as [|p t]; [reflexivity|]. cbn [edges]. change (total (ends (combine (p :: t) (t ++ [p]))) k + 0 = 0)%Z.
  rewrite total_starts; [|rewrite app_length; cbn; lia]. rewrite map_app, total_app. cbn. destruct (key_dec (0, 0, 0, p)%Z k); lia.
Qed.

Lemma forall2_right {A B} (R : A -> B -> Prop) l m : Forall2 R l m -> forall y, In y m -> exists x, In x l /\ R x y.
Proof.
  induction 1 as [|x y l m H _ IH]; intros z; [intros []|]. intros [<-|I]; [exists x; split; [left; reflexivity|exact H]|].
  destruct (IH z I) as (w & J & K). exists w. split; [right; exact J|exact K].
Qed.

Theorem constant_rings N loops x y : (0 < N)%Z -> all_integral N loops = true ->
  (forall e, In e (flat_map Statements.edges loops) -> exists n m, qdot n x * inject_Z N < inject_Z m /\
    qdot n y * inject_Z N < inject_Z m /\ inject_Z m <= qdot n (fst e) * inject_Z N /\ inject_Z m <= qdot n (snd e) * inject_Z N) ->
  Statements.winding loops x = Statements.winding loops y.
Proof.
  intros P I H. destruct (pat_common x y) as (k & v & u & K & V & X). pose proof (int_rings_at N loops I) as R.
  rewrite (winding_W N k loops _ x v P K R V), (winding_W N k loops _ y u P K R X). rewrite <- !W_edges.
  apply constant; [apply closed_rings|]. intros e' E'.
  assert (G : exists e0, In e0 (flat_map edges (int_rings N loops)) /\ e' = grow_edge k e0).
  { apply in_flat_map in E' as (r' & R' & E'). apply in_map_iff in R' as (r & <- & R'). rewrite edges_map in E'.
    apply in_map_iff in E' as (e0 & <- & E'). exists e0. split; [apply in_flat_map; exists r; auto|reflexivity]. }
  destruct G as (e0 & E0 & ->). destruct (forall2_right _ _ _ (all_edges_at N _ _ R) e0 E0) as (e & E & A & B).
  destruct (H e E) as (n & m & H1 & H2 & H3 & H4).
  pose proof (qdot_at n _ _ _ A) as A1. pose proof (qdot_at n _ _ _ B) as B1. unfold at_ in A1, B1.
  rewrite A1, <- Zle_Qle in H3. rewrite B1, <- Zle_Qle in H4.
  assert (Side : forall z w, pat k z w -> qdot n z * inject_Z N < inject_Z m -> (dot n (grow N w) < k * m)%Z).
  { intros z w Z0 L0. pose proof (qdot_at n _ z _ (pat_grow' N k z w Z0)) as Q1. unfold at_ in Q1.
    rewrite Zlt_Qlt, <- Q1, !inject_Z_mult. pose proof (inject_pos k K) as Kq.
    pose proof (mono_lt (inject_Z k) _ _ Kq L0). lra. }
  pose proof (Side x v V H1) as S1. pose proof (Side y u X H2) as S2.
  exists (2 * fst n, 2 * snd n, 1 - 2 * (k * m))%Z. unfold val, grow_edge. cbn [fst snd].
  assert (E1 : (dot n (grow k (fst e0)) = k * dot n (fst e0))%Z) by apply dot_grow.
  assert (E2 : (dot n (grow k (snd e0)) = k * dot n (snd e0))%Z) by apply dot_grow.
  unfold dot in *. repeat split; nia.
Qed.

Lemma forall2_left {A B} (R : A -> B -> Prop) l m : Forall2 R l m -> forall x, In x l -> exists y, In y m /\ R x y.
Proof.
  induction 1 as [|x y l m H _ IH]; intros z; [intros []|]. intros [<-|I]; [exists y; split; [left; reflexivity|exact H]|].
  destruct (IH z I) as (w & J & K). exists w. split; [right; exact J|exact K].
Qed.
Corollary constant_rings_q N loops x y : (0 < N)%Z -> all_integral N loops = true ->
  (forall e, In e (flat_map Statements.edges loops) -> exists n m, qdot n x < m /\ qdot n y < m /\
    m <= qdot n (fst e) /\ m <= qdot n (snd e)) ->
  Statements.winding loops x = Statements.winding loops y.
Proof.
  intros P I H. apply (constant_rings N loops x y P I). intros e E. destruct (H e E) as (n & m & H1 & H2 & H3 & H4).
  destruct (forall2_left _ _ _ (all_edges_at N _ _ (int_rings_at N loops I)) e E) as (e0 & _ & A & B).
  pose proof (qdot_at n N _ _ A) as A1. pose proof (qdot_at n N _ _ B) as B1. unfold at_ in A1, B1.
  assert (Nq : 0 < inject_Z N) by (apply inject_pos, P). exists n, (Qceiling (m * inject_Z N)).
  pose proof (Qle_ceiling (m * inject_Z N)) as C.
  assert (Up : forall q z, m <= q -> q * inject_Z N == inject_Z z -> inject_Z (Qceiling (m * inject_Z N)) <= q * inject_Z N).
  { intros q z L E0. rewrite E0, <- Zle_Qle. rewrite <- (Qceiling_Z z). apply Qceiling_resp_le. rewrite <- E0.
    apply Qmult_le_compat_r; lra. }
  assert (S1 : qdot n x * inject_Z N < m * inject_Z N) by (apply Qmult_lt_r; assumption).
  assert (S2 : qdot n y * inject_Z N < m * inject_Z N) by (apply Qmult_lt_r; assumption).
  repeat split; [lra|lra|exact (Up _ _ H3 A1)|exact (Up _ _ H4 B1)].
Qed.

(* 2. Booleans *)
Lemma less_true x y : Statements.less x y = true <-> x < y.
Proof. destruct (less_cases x y) as [(H & ->)|(H & ->)]; split; try congruence; try lra; auto. Qed.

Definition within (a b x : Q) : bool := (Qle_bool a x && Qle_bool x b) || (Qle_bool b x && Qle_bool x a).
Definition on_b (e : side) (x : qpoint) : bool :=
  Qeq_bool (o e x) 0 && within (fst (fst e)) (fst (snd e)) (fst x) && within (snd (fst e)) (snd (snd e)) (snd x).
Lemma within_spec a b x : within a b x = true -> (a <= x <= b) \/ (b <= x <= a).
Proof.
  unfold within. intro H. apply orb_prop in H as [H|H]; apply andb_prop in H as (H & H'); apply Qle_bool_iff in H, H'; auto.
Qed.
Lemma within_share a b x : within a b x = true -> ~ a == b -> 0 <= (x - a) / (b - a) <= 1 /\ x == a + (x - a) / (b - a) * (b - a).
Proof.
  intros H N. apply within_spec in H. split; [|field; lra]. destruct H as [H|H].
  - split; [apply Qle_shift_div_l; lra|apply Qle_shift_div_r; lra].
  - assert (E : (x - a) / (b - a) == (a - x) / (a - b)) by (field; lra). rewrite E.
    split; [apply Qle_shift_div_l; lra|apply Qle_shift_div_r; lra].
Qed.
Lemma on_b_spec e x : on_b e x = true -> Statements.on_segment e x.
Proof.
  unfold on_b. intro H. apply andb_prop in H as (H & Y). apply andb_prop in H as (O & X). apply Qeq_bool_iff in O.
  destruct e as [p q]. unfold o, Statements.orient in O. cbn [fst snd] in *.
  destruct (Qeq_dec (fst p) (fst q)) as [E|E].
  - destruct (Qeq_dec (snd p) (snd q)) as [F|F].
    + exists 0. apply within_spec in X, Y. cbn [fst snd]. repeat split; lra.
    + destruct (within_share _ _ _ Y F) as (S & Eq). exists ((snd x - snd p) / (snd q - snd p)).
      split; [exact S|]. cbn [fst snd]. split; [|exact Eq]. apply within_spec in X.
      assert (Z : fst q - fst p == 0) by lra. rewrite Z. lra.
  - destruct (within_share _ _ _ X E) as (S & Eq). exists ((fst x - fst p) / (fst q - fst p)).
    split; [exact S|]. cbn [fst snd]. split; [exact Eq|].
    assert (snd x - snd p == (fst x - fst p) / (fst q - fst p) * (snd q - snd p)); [|lra].
    apply (Qmult_inj_l _ _ (fst q - fst p)); [lra|].
    assert (M : (fst q - fst p) * (snd x - snd p) == (snd q - snd p) * (fst x - fst p)) by lra. rewrite M. field. lra.
Qed.

Lemma within_convex a b s : 0 <= s <= 1 -> within a b (a + s * (b - a)) = true.
Proof.
  intros (S0 & S1). unfold within. apply orb_true_intro. destruct (Qlt_le_dec a b) as [L|L]; [left|right]; apply andb_true_intro.
  - assert (0 <= s * (b - a)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (1 - s) * (b - a)) by (apply Qmult_le_0_compat; lra). split; apply Qle_bool_iff; lra.
  - assert (0 <= s * (a - b)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (1 - s) * (a - b)) by (apply Qmult_le_0_compat; lra). split; apply Qle_bool_iff; lra.
Qed.
Lemma within_same a b x y : x == y -> within a b x = within a b y.
Proof. intro E. unfold within. rewrite !E. reflexivity. Qed.
Lemma on_b_complete e x : Statements.on_segment e x -> on_b e x = true.
Proof.
  intros (s & S & X & Y). unfold on_b. apply andb_true_intro. split; [apply andb_true_intro; split|].
  - apply Qeq_bool_iff. unfold o, Statements.orient. rewrite X, Y. ring.
  - rewrite (within_same _ _ _ _ X). apply within_convex, S.
  - rewrite (within_same _ _ _ _ Y). apply within_convex, S.
Qed.
Lemma on_any_dec es x : {Statements.on_any es x} + {~ Statements.on_any es x}.
Proof.
  destruct (existsb (fun e => on_b e x) es) eqn:E; [left|right].
  - apply existsb_exists in E as (e & I & H). exists e. split; [exact I|apply on_b_spec, H].
  - intros (e & I & H). apply on_b_complete in H.
    assert (existsb (fun e => on_b e x) es = true); [|congruence]. apply existsb_exists. exists e. auto.
Qed.



(* 3. Chains of parameters along a segment *)
Definition point_at (f : side) (s : Q) : qpoint :=
  (fst (fst f) + s * (fst (snd f) - fst (fst f)), snd (fst f) + s * (snd (snd f) - snd (fst f))).
Fixpoint chain (step : Q -> Q -> bool) (s : Q) (l : list Q) : bool :=
  match l with [] => true | r :: m => step s r && chain step r m end.


Lemma on_same e x y : meets_at x y -> Statements.on_segment e x -> Statements.on_segment e y.
Proof. intros (A & B) (s & S & X & Y). exists s. split; [exact S|]. rewrite <- A, <- B. split; assumption. Qed.
Lemma inS_same S x y : meets_at x y -> inS S x -> inS S y.
Proof. intros M H f I. rewrite <- (o_same f x y M). apply H, I. Qed.

Lemma point_mid f u x v : u <= x <= v -> ~ u == v -> exists s, 0 <= s <= 1 /\ (u < x -> 0 < s) /\ (x < v -> s < 1) /\
  x == u + s * (v - u) /\
  fst (point_at f x) == fst (point_at f u) + s * (fst (point_at f v) - fst (point_at f u)) /\
  snd (point_at f x) == snd (point_at f u) + s * (snd (point_at f v) - snd (point_at f u)).
Proof.
  intros (A & B) N. exists ((x - u) / (v - u)).
  assert (E : x == u + (x - u) / (v - u) * (v - u)) by (field; lra).
  split; [split; [apply Qle_shift_div_l; lra|apply Qle_shift_div_r; lra]|].
  split; [intro; apply Qlt_shift_div_l; lra|]. split; [intro; apply Qlt_shift_div_r; lra|]. split; [exact E|].
  unfold point_at. cbn [fst snd]. revert E. generalize ((x - u) / (v - u)). intros s E. rewrite E. split; ring.
Qed.

Lemma segment_convex e a b x s : 0 <= s <= 1 -> Statements.on_segment e a -> Statements.on_segment e b ->
  fst x == fst a + s * (fst b - fst a) -> snd x == snd a + s * (snd b - snd a) -> Statements.on_segment e x.
Proof.
  intros (S0 & S1) (u & (U0 & U1) & Ux & Uy) (v & (V0 & V1) & Vx & Vy) X Y. exists (u + s * (v - u)). split.
  - assert (0 <= s * v) by (apply Qmult_le_0_compat; lra). assert (0 <= (1 - s) * u) by (apply Qmult_le_0_compat; lra).
    assert (0 <= s * (1 - v)) by (apply Qmult_le_0_compat; lra). assert (0 <= (1 - s) * (1 - u)) by (apply Qmult_le_0_compat; lra). lra.
  - rewrite X, Y, Ux, Uy, Vx, Vy. split; ring.
Qed.
