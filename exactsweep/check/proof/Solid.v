(* Cancellation at rational points, and solids: rings with convex pieces that cancel to them. Vertices are integers.
   The rational point (x / k, y / k) is z = (x, y) with all vertices multiplied by k; statements for all k > 0 and z hold
   at all rational points. *)
Require Import ZArith Lia List Bool Permutation Orders Mergesort.
From Exactsweep Require Import Cancel Constant Fans Pieces Convex.
Import ListNotations.
Open Scope Z_scope.

Definition grow (k : Z) (p : pt) : pt := (k * fst p, k * snd p).
Definition grow_edge (k : Z) (e : edge) : edge := (grow k (fst e), grow k (snd e)).

Lemma det_grow k p q r : det (grow k p) (grow k q) (grow k r) = k * k * det p q r.
Proof. unfold det, grow. cbn. ring. Qed.

Lemma edges_map f r : edges (map f r) = map (fun e => (f (fst e), f (snd e))) (edges r).
Proof.
  destruct r as [|p t]; [reflexivity|]. cbn [edges map].
  change (f p :: map f t) with (map f (p :: t)). replace (map f t ++ [f p]) with (map f (t ++ [p])) by apply map_app.
  generalize (t ++ [p]). generalize (p :: t). intro l. induction l as [|a l IH]; intros [|b m]; cbn; try reflexivity.
  f_equal. apply IH.
Qed.

(* Cancellation, at scale k *)
Definition Lk (k : Z) (l : Z * Z * Z) (z : pt) : Z :=
  let '(a, b, c) := l in if a * fst z + b * snd z + c * k <? 0 then 1 else 0.
Definition phik (k : Z) (z : pt) (x : key) : Z := Lk k (fst x) z * h (grow k (snd x)) z.

Lemma scale_sign_k a b c s k z : a <> 0 -> s = 1 \/ s = -1 ->
  Lk k (scale (s * g3 (a, b, c)) (a, b, c)) z = if s * (a * fst z + b * snd z + c * k) <? 0 then 1 else 0.
Proof.
  intros Ha Hs. pose proof (g3_pos a b c Ha) as Hg.
  destruct (g3_div a b c) as ((x & Hx) & (y & Hy) & (w & Hw)).
  set (g := g3 (a,b,c)) in *. clearbody g. unfold scale, Lk.
  assert (D : forall n m, n = m * g -> n / (s * g) = s * m).
  { intros n m E. replace n with ((s * m) * (s * g)) by (rewrite E; destruct Hs as [->| ->]; ring).
    apply Z.div_mul. destruct Hs as [->| ->]; lia. }
  rewrite (D a x Hx), (D b y Hy), (D c w Hw).
  replace (s * (a * fst z + b * snd z + c * k)) with ((s * x * fst z + s * y * snd z + s * w * k) * g)
    by (rewrite Hx, Hy, Hw; ring).
  destruct (Z.ltb_spec (s * x * fst z + s * y * snd z + s * w * k) 0);
  destruct (Z.ltb_spec ((s * x * fst z + s * y * snd z + s * w * k) * g) 0); try reflexivity; nia.
Qed.

Lemma le_grow k a b : 0 < k -> (k * a <? k * b) = (a <? b).
Proof. intro K. destruct (Z.ltb_spec (k * a) (k * b)); destruct (Z.ltb_spec a b); try reflexivity; nia. Qed.

Lemma cross_phik k e z : 0 < k -> cross (grow_edge k e) z = phik k z (ln e, fst e) - phik k z (ln e, snd e).
Proof.
  intro K. destruct e as [p q]. unfold phik, grow_edge. cbn [fst snd].
  destruct (Z.eq_dec (snd p) (snd q)) as [E|E].
  - assert (h (grow k p) z = h (grow k q) z) as -> by (unfold h, grow; cbn; rewrite E; reflexivity).
    unfold cross, grow. cbn [fst snd]. rewrite E.
    destruct (k * snd q <=? snd z) eqn:A; destruct (snd z <? k * snd q) eqn:B; cbn; try lia.
  - unfold ln, raw. rewrite !scale_sign_k; [|lia|destruct (snd q <? snd p); auto].
    set (d := (snd p - snd q) * fst z + (fst q - fst p) * snd z + (fst p * snd q - fst q * snd p) * k).
    unfold cross, h.
    replace (det (grow k p) (grow k q) z) with (k * d) by (unfold det, d, grow; cbn; ring).
    replace (0 <? k * d) with (0 <? d) by (rewrite <- (le_grow k 0 d K); f_equal; ring).
    replace (k * d <? 0) with (d <? 0) by (rewrite <- (le_grow k d 0 K); f_equal; ring).
    rewrite <- (le_grow k (snd q) (snd p) K). clearbody d. unfold grow. cbn [fst snd].
    assert (k * snd p <> k * snd q) by nia. generalize dependent (k * snd p). generalize (k * snd q). clear.
    intros b a N.
    destruct (Z.ltb_spec b a);
    destruct (Z.leb_spec a (snd z)); destruct (Z.leb_spec b (snd z));
    destruct (Z.ltb_spec (snd z) b); destruct (Z.ltb_spec (snd z) a);
    destruct (Z.ltb_spec 0 d); destruct (Z.ltb_spec d 0); try lia;
    rewrite ?Z.mul_1_l, <- ?Z.opp_eq_mul_m1; cbn [andb];
    try destruct (Z.ltb_spec d 0); try destruct (Z.ltb_spec (- d) 0); try lia;
    try destruct (Z.ltb_spec (-1 * d) 0); lia.
Qed.

(* Horizontal edges contribute nothing. *)
Definition tilted (e : edge) : bool := negb (snd (fst e) =? snd (snd e)).
Lemma wind_tilted k es z : wind (map (grow_edge k) (filter tilted es)) z = wind (map (grow_edge k) es) z.
Proof.
  induction es as [|[p q] r IH]; [reflexivity|]. cbn [filter map]. unfold tilted at 1. cbn [fst snd].
  destruct (Z.eqb_spec (snd p) (snd q)) as [E|E]; cbn [negb map wind]; rewrite IH; [|reflexivity].
  assert (cross (grow_edge k (p, q)) z = 0) as ->; [|reflexivity].
  unfold cross, grow_edge, grow. cbn [fst snd]. rewrite E.
  destruct (Z.leb_spec (k * snd q) (snd z)); destruct (Z.ltb_spec (snd z) (k * snd q)); cbn; try reflexivity; lia.
Qed.

(* Sorted keys: starts and ends at one point of one line are adjacent. *)
Definition then_compare (c d : comparison) : comparison := match c with Eq => d | _ => c end.
Definition key_compare (x y : key) : comparison :=
  let '((a, b, c), p) := x in let '((a', b', c'), p') := y in
  then_compare (Z.compare a a') (then_compare (Z.compare b b') (then_compare (Z.compare c c')
    (then_compare (Z.compare (fst p) (fst p')) (Z.compare (snd p) (snd p'))))).
Module KeyOrder <: TotalLeBool.
  Definition t := (key * Z)%type.
  Definition leb (x y : t) : bool := match key_compare (fst x) (fst y) with Gt => false | _ => true end.
  Theorem leb_total : forall x y, leb x y = true \/ leb y x = true.
  Proof.
    intros ((((a, b), c), (u, v)), s) ((((a', b'), c'), (u', v')), s'). unfold leb, key_compare. cbn [fst snd].
    rewrite (Z.compare_antisym a a'), (Z.compare_antisym b b'), (Z.compare_antisym c c'), (Z.compare_antisym u u'), (Z.compare_antisym v v').
    destruct (a ?= a'), (b ?= b'), (c ?= c'), (u ?= u'), (v ?= v'); cbn; auto.
  Qed.
End KeyOrder.
Module KeySort := Sort KeyOrder.
Lemma key_compare_eq x y : key_compare x y = Eq -> x = y.
Proof.
  destruct x as (((a, b), c), (u, v)), y as (((a', b'), c'), (u', v')). unfold key_compare. cbn [fst snd].
  destruct (Z.compare_spec a a'); try discriminate. destruct (Z.compare_spec b b'); try discriminate.
  destruct (Z.compare_spec c c'); try discriminate. destruct (Z.compare_spec u u'); try discriminate.
  destruct (Z.compare_spec v v'); try discriminate. cbn. congruence.
Qed.
(* Equal keys are merged; those that add up to 0 are dropped. *)
Definition keep (k : key) (s : Z) (l : list (key * Z)) : list (key * Z) := if s =? 0 then l else (k, s) :: l.
Fixpoint runs (k : key) (s : Z) (l : list (key * Z)) : list (key * Z) :=
  match l with
  | [] => keep k s []
  | (k', s') :: r => match key_compare k k' with Eq => runs k (s + s') r | _ => keep k s (runs k' s' r) end
  end.
Definition merge (l : list (key * Z)) : list (key * Z) := match KeySort.sort l with [] => [] | (k, s) :: r => runs k s r end.

Lemma keep_weigh f k s l : weigh f (keep k s l) = s * f k + weigh f l.
Proof. unfold keep. destruct (Z.eqb_spec s 0) as [->|]; [ring|reflexivity]. Qed.
Lemma runs_weigh f l : forall k s, weigh f (runs k s l) = s * f k + weigh f l.
Proof.
  induction l as [|(k', s') r IH]; intros k s; cbn [runs weigh]; [apply keep_weigh|].
  destruct (key_compare k k') eqn:C; [|rewrite keep_weigh, IH; ring|rewrite keep_weigh, IH; ring].
  apply key_compare_eq in C. subst k'. rewrite IH. ring.
Qed.
Lemma weigh_permutation f l m : Permutation l m -> weigh f l = weigh f m.
Proof. induction 1 as [|(k, s) l m _ IH|(k, s) (k', s') l|l m n _ IH _ IH']; cbn [weigh]; lia. Qed.
Lemma merge_weigh f l : weigh f (merge l) = weigh f l.
Proof.
  rewrite (weigh_permutation f l _ (KeySort.Permuted_sort l)). unfold merge.
  destruct (KeySort.sort l) as [|(k, s) r]; [reflexivity|]. apply runs_weigh.
Qed.

(* First, opposite edges of two pieces cancel, and edges of pieces with equal edges of rings; then parts of edges cancel
   line by line. *)
Definition edge_key (e : edge) : key * Z :=
  let (p, q) := e in if snd p <? snd q then (((fst p, snd p, fst q), (snd q, 0)), 1) else (((fst q, snd q, fst p), (snd p, 0)), -1).
Definition key_edge (k : key) : edge := let '((a, b, c), (d, _)) := k in ((a, b), (c, d)).
Definition edge_keys (es : list edge) : list (key * Z) := map edge_key (filter tilted es).
Definition line_keys (x : key * Z) : list (key * Z) :=
  let e := key_edge (fst x) in let l := ln e in [((l, fst e), snd x); ((l, snd e), - snd x)].
Definition cancel (pieces rings : list edge) : bool :=
  match merge (flat_map line_keys (merge (edge_keys pieces ++ neg (edge_keys rings)))) with [] => true | _ => false end.

Lemma edge_keys_wind k es z : weigh (fun x => cross (grow_edge k (key_edge x)) z) (edge_keys es) = wind (map (grow_edge k) es) z.
Proof.
  rewrite <- wind_tilted. unfold edge_keys. induction (filter tilted es) as [|((a, b), (c, d)) r IH]; [reflexivity|].
  cbn [map wind]. rewrite <- IH. unfold edge_key at 1. cbn [fst snd].
  destruct (b <? d); cbn [weigh key_edge]; unfold grow_edge; cbn [fst snd]; [ring|]. rewrite (cross_sym (grow k (a, b))). ring.
Qed.
Lemma line_keys_weigh k l z : 0 < k -> weigh (phik k z) (flat_map line_keys l) = weigh (fun x => cross (grow_edge k (key_edge x)) z) l.
Proof.
  intro K. induction l as [|(x, s) r IH]; [reflexivity|]. cbn [flat_map]. rewrite weigh_app, IH. unfold line_keys. cbv zeta. cbn [weigh fst snd].
  rewrite (cross_phik k _ z K). ring.
Qed.
Lemma cancel_wind k es fs z : 0 < k -> cancel es fs = true ->
  wind (map (grow_edge k) es) z = wind (map (grow_edge k) fs) z.
Proof.
  intros K C. rewrite <- !edge_keys_wind. unfold cancel in C. set (l := edge_keys es ++ neg (edge_keys fs)) in *.
  pose proof (merge_weigh (phik k z) (flat_map line_keys (merge l))) as M.
  destruct (merge (flat_map line_keys (merge l))); [|discriminate]. rewrite (line_keys_weigh k _ z K), merge_weigh in M. unfold l in M.
  rewrite weigh_app, weigh_neg in M. change (weigh (phik k z) []) with 0 in M. lia.
Qed.

(* Winding numbers at scale k *)
Definition W (k : Z) (rs : list ring) (z : pt) : Z := wind (map (grow_edge k) (flat_map edges rs)) z.

Lemma W_cons k r rs z : W k (r :: rs) z = ring_wind (map (grow k) r) z + W k rs z.
Proof.
  unfold W, ring_wind. cbn [flat_map]. rewrite map_app, wind_app, edges_map. reflexivity.
Qed.

Lemma sorted_grow k p l : 0 < k -> forall q, sorted p q l = true -> sorted (grow k p) (grow k q) (map (grow k) l) = true.
Proof.
  intro K. induction l as [|r m IH]; intros q S; [reflexivity|]. cbn [sorted map] in *.
  apply andb_prop in S as (S & S2). apply andb_prop in S as (S0 & S1).
  rewrite (IH r S2), andb_true_r. rewrite det_grow. apply andb_true_intro. split.
  - apply Z.ltb_lt in S0. apply Z.ltb_lt. nia.
  - rewrite forallb_forall in *. intros x I. apply in_map_iff in I as (y & <- & I). apply S1 in I.
    apply Z.leb_le in I. rewrite det_grow. apply Z.leb_le. nia.
Qed.

Lemma is_fan_grow k r : 0 < k -> is_fan r = true -> is_fan (map (grow k) r) = true.
Proof.
  intros K H. destruct (fan_shape r H) as (p & q & s & l & -> & S). exact (sorted_grow k p (s :: l) K q S).
Qed.

(* Solids *)
Record solid := { rings : list ring; pieces : list ring }.
Definition is_solid (s : solid) : bool :=
  forallb is_convex (pieces s) && cancel (flat_map edges (pieces s)) (flat_map edges (rings s)).

Fixpoint count (k : Z) (ps : list ring) (z : pt) : Z :=
  match ps with [] => 0 | p :: r => ring_wind (map (grow k) p) z + count k r z end.

Lemma W_count k ps z : W k ps z = count k ps z.
Proof. induction ps as [|p r IH]; [reflexivity|]. rewrite W_cons, IH. reflexivity. Qed.

Lemma solid_count k s z : 0 < k -> is_solid s = true -> W k (rings s) z = count k (pieces s) z.
Proof.
  intros K H. unfold is_solid in H. apply andb_prop in H as (_ & C).
  rewrite <- W_count. unfold W. symmetry. apply cancel_wind; assumption.
Qed.

Definition fans (ps : list ring) : Prop := forall p, In p ps -> is_fan p = true.
Lemma solid_fans s : is_solid s = true -> fans (pieces s).
Proof. intros H p I. apply is_convex_fan. unfold is_solid in H. apply andb_prop in H as (H & _). rewrite forallb_forall in H. exact (H p I). Qed.

Lemma count_some k ps z : 0 < k -> fans ps ->
  0 <= count k ps z /\ (1 <= count k ps z -> exists p, In p ps /\ ring_wind (map (grow k) p) z = 1).
Proof.
  intros K. induction ps as [|p r IH]; intro H; cbn [count]; [lia|].
  destruct IH as (N & E); [intros q Q; apply H; right; assumption|].
  destruct (piece_01 _ z (is_fan_grow k p K (H p (or_introl eq_refl)))) as [Z0|Z1].
  - split; [lia|]. rewrite Z0. intro P. destruct (E P) as (q & I & Q). exists q. split; [right|]; assumption.
  - split; [lia|]. intros _. exists p. split; [left; reflexivity|assumption].
Qed.

(* At most one of pairwise disjoint pieces contains a given point. *)
Lemma count_one k ps z : 0 < k -> fans ps ->
  ForallOrdPairs (fun p q => ring_wind (map (grow k) p) z + ring_wind (map (grow k) q) z <= 1) ps ->
  count k ps z = 0 \/ count k ps z = 1.
Proof.
  intros K H. induction ps as [|p r IH]; intro A; cbn [count]; [auto|].
  assert (Hr : fans r) by (intros q Q; apply H; right; assumption).
  inversion A as [|? ? A1 A2]; subst. specialize (IH Hr A2).
  destruct (piece_01 _ z (is_fan_grow k p K (H p (or_introl eq_refl)))) as [Z0|Z1]; [rewrite Z0; lia|].
  destruct IH as [IH|IH]; [lia|exfalso].
  destruct (proj2 (count_some k r z K Hr)) as (q & I & Q); [lia|].
  rewrite Forall_forall in A1. specialize (A1 q I). lia.
Qed.
