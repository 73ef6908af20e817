(* Gaps between pieces: a normal proves that two pieces are disjoint and at a distance. *)
Require Import ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Convex Solid.
Import ListNotations.
Open Scope Z_scope.

Definition dist2 (y z : pt) : Z := (fst y - fst z) * (fst y - fst z) + (snd y - snd z) * (snd y - snd z).

Definition max_dot (n v : pt) (vs : list pt) : Z := fold_right (fun p m => Z.max (dot n p) m) (dot n v) vs.
Definition min_dot (n v : pt) (vs : list pt) : Z := fold_right (fun p m => Z.min (dot n p) m) (dot n v) vs.

Lemma max_dot_spec n v vs p : In p (v :: vs) -> dot n p <= max_dot n v vs.
Proof.
  unfold max_dot. induction vs as [|w vs IH]; cbn [fold_right]; intros [<-|I]; try lia; [destruct I| |].
  - specialize (IH (or_introl eq_refl)). lia.
  - destruct I as [<-|I]; [lia|]. specialize (IH (or_intror I)). lia.
Qed.
Lemma min_dot_spec n v vs p : In p (v :: vs) -> min_dot n v vs <= dot n p.
Proof.
  unfold min_dot. induction vs as [|w vs IH]; cbn [fold_right]; intros [<-|I]; try lia; [destruct I| |].
  - specialize (IH (or_introl eq_refl)). lia.
  - destruct I as [<-|I]; [lia|]. specialize (IH (or_intror I)). lia.
Qed.

(* A line with normal n has one piece on each side, and the gap is at least d wide. *)
Definition far (d : Z) (n : pt) (vs ws : ring) : bool :=
  match vs, ws with
  | v :: vs', w :: ws' =>
      let g := min_dot n w ws' - max_dot n v vs' in
      negb ((fst n =? 0) && (snd n =? 0)) && (0 <=? g) && (d * d * dot n n <=? g * g)
  | _, _ => false
  end.

Lemma far_spec d n vs ws : far d n vs ws = true -> n <> (0, 0) /\
  exists a b, (forall v, In v vs -> dot n v <= a) /\ (forall w, In w ws -> b <= dot n w) /\ a <= b /\
    d * d * dot n n <= (b - a) * (b - a).
Proof.
  destruct vs as [|v vs]; [discriminate|]. destruct ws as [|w ws]; [discriminate|].
  unfold far. intro H. apply andb_prop in H as (H & H3). apply andb_prop in H as (H1 & H2). split.
  - intros ->. discriminate.
  - exists (max_dot n v vs), (min_dot n w ws). apply Z.leb_le in H2, H3. repeat split; try assumption; try lia.
    + intros. apply max_dot_spec. assumption.
    + intros. apply min_dot_spec. assumption.
Qed.


(* Subsets of distant sets are distant. *)

Lemma dot_grow k n p : dot n (grow k p) = k * dot n p.
Proof. unfold dot, grow. cbn. ring. Qed.



Lemma far_share d n p q k z : 0 < k -> far d n p q = true -> is_fan p = true -> is_fan q = true ->
  ring_wind (map (grow k) p) z + ring_wind (map (grow k) q) z <= 1.
Proof.
  intros K F P Q. destruct (far_spec _ _ _ _ F) as (N & a & b & A & B & C & _).
  apply (piece_sep _ _ z n (k * a) (is_fan_grow k p K P) (is_fan_grow k q K Q) N).
  - intros v I. apply in_map_iff in I as (u & <- & I). rewrite dot_grow. specialize (A u I). nia.
  - intros v I. apply in_map_iff in I as (u & <- & I). rewrite dot_grow. specialize (B u I). nia.
Qed.

(* existsb that stops at the first match, also when computed in Coq *)
Fixpoint some {A} (f : A -> bool) (l : list A) : bool :=
  match l with [] => false | a :: r => if f a then true else some f r end.
Lemma some_exists {A} (f : A -> bool) l : some f l = true <-> exists x, In x l /\ f x = true.
Proof. rewrite <- existsb_exists. induction l as [|a r IH]; [reflexivity|]. cbn [some existsb]. destruct (f a); [split; reflexivity|exact IH]. Qed.
Fixpoint all_pairs {A : Type} (f : A -> A -> bool) (l : list A) : bool :=
  match l with [] => true | x :: r => forallb (f x) r && all_pairs f r end.
Lemma all_pairs_spec {A} (f : A -> A -> bool) l : all_pairs f l = true -> ForallOrdPairs (fun x y => f x y = true) l.
Proof.
  induction l as [|x r IH]; cbn; intro H; constructor; apply andb_prop in H as (H & H2).
  - rewrite forallb_forall in H. rewrite Forall_forall. exact H.
  - apply IH, H2.
Qed.

(* One piece has a side with the other piece on its right, or an axis direction separates them. *)
Definition normal (e : edge) : pt := (snd (snd e) - snd (fst e), fst (fst e) - fst (snd e)).
Definition opposite (p : pt) : pt := (- fst p, - snd p).
Definition axes : list pt := [(1, 0); (0, 1); (-1, 0); (0, -1)].
Definition apart (p q : ring) : bool :=
  some (fun n => far 0 n p q) (axes ++ map normal (edges p) ++ map (fun e => opposite (normal e)) (edges q)).
Lemma apart_spec p q : apart p q = true -> exists n, far 0 n p q = true.
Proof. unfold apart. intro H. apply some_exists in H as (n & _ & H). exists n. exact H. Qed.

(* A decomposition of a shape: at least one piece; the pieces are convex, pairwise disjoint, and cancel to the rings. *)
Definition simple_solid (s : solid) : bool :=
  is_solid s && negb (match pieces s with [] => true | _ => false end) && all_pairs apart (pieces s).
Lemma simple_convex s p : simple_solid s = true -> In p (pieces s) -> is_convex p = true.
Proof.
  unfold simple_solid, is_solid. intros H. apply andb_prop in H as (H & _). apply andb_prop in H as (H & _). apply andb_prop in H as (H & _).
  rewrite forallb_forall in H. apply H.
Qed.
Lemma simple_spec s : simple_solid s = true ->
  is_solid s = true /\ fans (pieces s) /\ (exists p, In p (pieces s)) /\
  forall k z, 0 < k -> W k (rings s) z = 0 \/ W k (rings s) z = 1.
Proof.
  unfold simple_solid. intro H. apply andb_prop in H as (H & A). apply andb_prop in H as (H & E).
  pose proof (solid_fans s H) as F. repeat split; try assumption.
  - destruct (pieces s) as [|p r]; [discriminate|]. exists p. left. reflexivity.
  - intros k z K. rewrite (solid_count k s z K H). apply count_one; try assumption.
    apply all_pairs_spec in A. revert F A. generalize (pieces s). intros ps F A.
    induction A as [|p r A1 A2 IH]; constructor.
    + rewrite Forall_forall in *. intros q Q. destruct (apart_spec p q (A1 q Q)) as (n & Fn).
      apply (far_share 0 n); [assumption|exact Fn|apply F; left; reflexivity|apply F; right; assumption].
    + apply IH. intros q Q. apply F. right. assumption.
Qed.


Definition box_ring (l b r t : Z) : ring := [(l, b); (r, b); (r, t); (l, t)].

Definition in_frame (m : Z) (f : Z * Z * Z * Z) (p : ring) : bool :=
  let '(l, b, r, t) := f in
  forallb (fun v => (l + m <=? fst v) && (fst v <=? r - m) && (b + m <=? snd v) && (snd v <=? t - m)) p.


(* A solid is not empty: the centroid of a triangle of its first piece, at scale 3. *)
Lemma fan_inhabited r : is_fan r = true -> exists z, ring_wind (map (grow 3) r) z = 1.
Proof.
  intro H. pose proof (is_fan_grow 3 r eq_refl H) as H3.
  destruct (fan_shape r H) as (p & q & s & l & -> & S). cbn [sorted] in S.
  apply andb_prop in S as (S & S2). apply andb_prop in S as (S0 & S1). apply Z.ltb_lt in S0.
  set (z := (fst p + fst q + fst s, snd p + snd q + snd s)). exists z.
  destruct (piece_01 _ z H3) as [E|E]; [exfalso|exact E].
  cbn [map] in E, H3. unfold ring_wind in E. rewrite edges_sides, fan_sum in E.
  assert (D : 0 < det (grow 3 p) (grow 3 q) (grow 3 s)) by (rewrite det_grow; lia).
  assert (D1 : det (grow 3 p) (grow 3 q) z = 3 * det p q s) by (unfold det, grow, z; cbn [fst snd]; ring).
  assert (D2 : det (grow 3 q) (grow 3 s) z = 3 * det p q s) by (unfold det, grow, z; cbn [fst snd]; ring).
  assert (D3 : det (grow 3 s) (grow 3 p) z = 3 * det p q s) by (unfold det, grow, z; cbn [fst snd]; ring).
  assert (T : wind (edges3 (grow 3 p, grow 3 q, grow 3 s)) z = 1).
  { rewrite triangle; [|exact D|unfold on; lia]. unfold inside. rewrite D1, D2, D3.
    destruct (Z.ltb_spec 0 (3 * det p q s)); [reflexivity|lia]. }
  cbn [fan_from flat_map] in E. rewrite wind_app, T in E.
  assert (S3 : sorted (grow 3 p) (grow 3 s) (map (grow 3) l) = true) by (apply sorted_grow; [lia|exact S2]).
  destruct (fan_01 _ _ z _ S3) as [F|(F & _)]; rewrite F in E; discriminate.
Qed.

Lemma box_wind k l b r t z : 0 < k -> l < r -> b < t ->
  W k [box_ring l b r t] z =
  if (k * l <=? fst z) && (fst z <? k * r) && (k * b <=? snd z) && (snd z <? k * t) then 1 else 0.
Proof.
  intros K H V. rewrite W_cons. unfold W, ring_wind. cbn [box_ring map grow edges combine app flat_map wind cross fst snd].
  unfold det, grow. cbn [fst snd].
  replace ((k * r - k * l) * (snd z - k * b) - (k * b - k * b) * (fst z - k * l)) with ((k * r - k * l) * (snd z - k * b)) by ring.
  replace ((k * r - k * r) * (snd z - k * b) - (k * t - k * b) * (fst z - k * r)) with ((k * t - k * b) * (k * r - fst z)) by ring.
  replace ((k * l - k * r) * (snd z - k * t) - (k * t - k * t) * (fst z - k * r)) with ((k * r - k * l) * (k * t - snd z)) by ring.
  replace ((k * l - k * l) * (snd z - k * t) - (k * b - k * t) * (fst z - k * l)) with ((k * t - k * b) * (fst z - k * l)) by ring.
  assert (A : k * l < k * r) by nia. assert (B : k * b < k * t) by nia.
  revert A B. generalize (k * l) (k * r) (k * b) (k * t) (fst z) (snd z). clear. intros l r b t x y A B.
  destruct (Z.leb_spec b y); destruct (Z.ltb_spec y b); destruct (Z.leb_spec t y); destruct (Z.ltb_spec y t);
  destruct (Z.leb_spec l x); destruct (Z.ltb_spec x r); try lia; cbn [andb];
  repeat match goal with |- context [if ?a <? ?b then _ else _] => destruct (Z.ltb_spec a b) end;
  try reflexivity; try lia; exfalso; nia.
Qed.

Lemma in_frame_spec m l b r t p k z : 0 < k -> in_frame m (l, b, r, t) p = true -> is_fan p = true ->
  1 <= ring_wind (map (grow k) p) z ->
  k * (l + m) <= fst z /\ fst z < k * (r - m) /\ k * (b + m) <= snd z /\ snd z < k * (t - m).
Proof.
  intros K I F Y. unfold in_frame in I. rewrite forallb_forall in I.
  assert (B : forall v, In v (map (grow k) p) ->
    k * (l + m) <= fst v /\ fst v <= k * (r - m) /\ k * (b + m) <= snd v /\ snd v <= k * (t - m)).
  { intros v V. apply in_map_iff in V as (u & <- & U). specialize (I u U).
    apply andb_prop in I as (I & I4). apply andb_prop in I as (I & I3). apply andb_prop in I as (I1 & I2).
    apply Z.leb_le in I1, I2, I3, I4. unfold grow. cbn [fst snd]. nia. }
  pose proof (is_fan_grow k p K F) as G.
  assert (C : forall n c, (forall v, In v (map (grow k) p) -> dot n v <= c) -> dot n z <= c)
    by (intros n c Hc; exact (piece_bound _ z n c G Y Hc)).
  assert (D : forall n c, rightward n -> (forall v, In v (map (grow k) p) -> dot n v <= c) -> dot n z < c).
  { intros n c R Hc. pose proof (C n c Hc). destruct (Z.eq_dec (dot n z) c) as [E|]; [exfalso|lia].
    enough (ring_wind (map (grow k) p) z <= 0) by lia. apply (lean _ z n R).
    intros e J. apply edges_ends in J as (J1 & J2). rewrite E. split; apply Hc; assumption. }
  pose proof (C (-1, 0) (- (k * (l + m)))) as C1. pose proof (D (1, 0) (k * (r - m))) as C2.
  pose proof (C (0, -1) (- (k * (b + m)))) as C3. pose proof (D (0, 1) (k * (t - m))) as C4.
  unfold dot, rightward in *. cbn [fst snd] in *.
  assert (fst z < k * (r - m)) by (enough (1 * fst z + 0 * snd z < k * (r - m)) by lia; apply C2; [lia|intros v V; specialize (B v V); lia]).
  assert (snd z < k * (t - m)) by (enough (0 * fst z + 1 * snd z < k * (t - m)) by lia; apply C4; [lia|intros v V; specialize (B v V); lia]).
  assert (-1 * fst z + 0 * snd z <= - (k * (l + m))) by (apply C1; intros v V; specialize (B v V); lia).
  assert (0 * fst z + -1 * snd z <= - (k * (b + m))) by (apply C3; intros v V; specialize (B v V); lia).
  lia.
Qed.

Definition shape_ok (s : solid) : Prop :=
  (forall k z, 0 < k -> W k (rings s) z = 0 \/ W k (rings s) z = 1) /\ exists z, W 3 (rings s) z = 1.
Lemma simple_shape s : simple_solid s = true -> shape_ok s.
Proof.
  intro H. destruct (simple_spec s H) as (S & F & (p & P) & B). split; [exact B|].
  destruct (fan_inhabited p (F p P)) as (z & Z1). exists z.
  destruct (B 3 z eq_refl) as [E|E]; [exfalso|exact E].
  rewrite (solid_count 3 s z eq_refl S) in E. revert E. pose proof F as F'. revert P F'.
  generalize (pieces s). intros ps P F' E. revert F' E. induction ps as [|q r IH]; [destruct P|].
  intros F' E. cbn [count] in E.
  assert (Fr : fans r) by (intros x X; apply F'; right; assumption).
  pose proof (proj1 (count_some 3 r z eq_refl Fr)).
  pose proof (piece_01 _ z (is_fan_grow 3 q eq_refl (F' q (or_introl eq_refl)))).
  destruct P as [->|P]; [lia|]. apply IH; [assumption|assumption|lia].
Qed.
