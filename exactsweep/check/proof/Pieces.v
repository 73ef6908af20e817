(* Winding numbers of triangles and fans at every point, including points on edges. `cross` counts the edges to the
   right of a point: a shape contains its left and lower sides, not its right and upper sides. So a counter-clockwise
   triangle has winding number 0 or 1 around any point, and two triangles on opposite sides of a line are disjoint. *)
Require Import ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans.
Import ListNotations.
Open Scope Z_scope.

Definition dot (n p : pt) : Z := fst n * fst p + snd n * snd p.

(* A direction that points to the right, or straight up. *)
Definition rightward (n : pt) : Prop := 0 < fst n \/ fst n = 0 /\ 0 < snd n.

Lemma either_way n : n <> (0, 0) -> rightward n \/ rightward (- fst n, - snd n).
Proof.
  destruct n as [u v]. unfold rightward. cbn [fst snd]. intro N.
  destruct (Z.lt_trichotomy u 0) as [|[->|]]; [lia| |lia].
  destruct (Z.lt_trichotomy v 0) as [|[->|]]; [lia| |lia]. congruence.
Qed.

Lemma dot_opp n p : dot (- fst n, - snd n) p = - dot n p.
Proof. unfold dot. cbn. ring. Qed.

(* The winding number is 0 around a point without edges to its right. *)
Lemma lean_edge p q z n : rightward n -> dot n p <= dot n z -> dot n q <= dot n z -> cross (p, q) z <= 0.
Proof.
  intros R A B. unfold cross.
  destruct (Z.leb_spec (snd p) (snd z)); destruct (Z.ltb_spec (snd z) (snd q)); cbn [andb];
    try (destruct ((snd q <=? snd z) && (snd z <? snd p) && (det p q z <? 0)); lia).
  destruct (Z.ltb_spec 0 (det p q z)) as [D|D];
    [|destruct ((snd q <=? snd z) && (snd z <? snd p) && (det p q z <? 0)); lia].
  exfalso. unfold dot, det, rightward in *.
  destruct p as [a b], q as [c d], z as [x y], n as [u v]. cbn [fst snd] in *.
  destruct R as [U|[U V]].
  - assert (E : u * ((c - a) * (y - b) - (d - b) * (x - a)) =
      (u * a + v * b - (u * x + v * y)) * (d - y) + (u * c + v * d - (u * x + v * y)) * (y - b)) by ring.
    assert ((u * a + v * b - (u * x + v * y)) * (d - y) <= 0) by nia.
    assert ((u * c + v * d - (u * x + v * y)) * (y - b) <= 0) by nia.
    nia.
  - subst u. nia.
Qed.

Lemma lean es z n : rightward n ->
  (forall e, In e es -> dot n (fst e) <= dot n z /\ dot n (snd e) <= dot n z) -> wind es z <= 0.
Proof.
  intros R. induction es as [|[p q] r IH]; intro H; cbn [wind]; [lia|].
  destruct (H (p, q) (or_introl eq_refl)). pose proof (lean_edge p q z n R H0 H1).
  assert (wind r z <= 0) by (apply IH; intros; apply H; right; assumption). lia.
Qed.

(* A triangle has winding number 0 or 1, and 1 only around points of the closed triangle. *)
Lemma half_open a b c z : 0 < det a b c ->
  wind (edges3 (a, b, c)) z = 0 \/
  wind (edges3 (a, b, c)) z = 1 /\ 0 <= det a b z /\ 0 <= det b c z /\ 0 <= det c a z.
Proof.
  unfold edges3, wind, cross. intros H.
  assert (I : det a b z * (snd c - snd z) + det b c z * (snd a - snd z)
              + det c a z * (snd b - snd z) = 0) by (unfold det; ring).
  assert (S : det a b z + det b c z + det c a z = det a b c) by (unfold det; ring).
  revert H I S. generalize (det a b z) (det b c z) (det c a z) (det a b c).
  generalize (snd a) (snd b) (snd c) (snd z). clear. intros A B C Y u v w D H I S.
  destruct (Z.leb_spec A Y); destruct (Z.leb_spec B Y); destruct (Z.leb_spec C Y);
  destruct (Z.ltb_spec Y A); destruct (Z.ltb_spec Y B); destruct (Z.ltb_spec Y C); try lia;
  destruct (Z.ltb_spec 0 u); destruct (Z.ltb_spec 0 v); destruct (Z.ltb_spec 0 w);
  destruct (Z.ltb_spec u 0); destruct (Z.ltb_spec v 0); destruct (Z.ltb_spec w 0); try lia; cbn;
  try (left; reflexivity); try (right; lia); exfalso; nia.
Qed.

(* A linear bound on the vertices holds for the points of a triangle. *)
Lemma tri_bound a b c z n m : 0 < det a b c -> 1 <= wind (edges3 (a, b, c)) z ->
  dot n a <= m -> dot n b <= m -> dot n c <= m -> dot n z <= m.
Proof.
  intros D W A B C. destruct (half_open a b c z D) as [E|(_ & U & V & X)]; [lia|].
  assert (S : det a b z + det b c z + det c a z = det a b c) by (unfold det; ring).
  assert (E : det a b c * dot n z = det b c z * dot n a + det c a z * dot n b + det a b z * dot n c)
    by (unfold dot, det; ring).
  revert D U V X S E A B C. generalize (det a b c) (det a b z) (det b c z) (det c a z)
    (dot n a) (dot n b) (dot n c) (dot n z). intros. nia.
Qed.

(* Rings *)
Definition ring := list pt.
Definition edges (r : ring) : list edge := match r with [] => [] | p :: t => combine r (t ++ [p]) end.

Lemma edges_sides p q l : edges (p :: q :: l) = sides (p, q, l).
Proof.
  cbn. f_equal. revert q. induction l as [|r m IH]; intro q; [reflexivity|].
  cbn. f_equal. apply IH.
Qed.

Lemma edges_ends r e : In e (edges r) -> In (fst e) r /\ In (snd e) r.
Proof.
  destruct r as [|p t]; [intros []|]. cbn [edges]. intro H. destruct e as [a b]. split.
  - eapply in_combine_l, H.
  - apply in_combine_r in H. apply in_app_or in H. cbn in *. tauto.
Qed.

Definition ring_wind (r : ring) (z : pt) : Z := wind (edges r) z.

(* A fan: a vertex p, and the others in counter-clockwise order as seen from p. Convex pieces are fans. *)
Fixpoint sorted (p q : pt) (l : list pt) : bool :=
  match l with
  | [] => true
  | r :: m => (0 <? det p q r) && forallb (fun x => 0 <=? det p q x) m && sorted p r m
  end.
Definition is_fan (r : ring) : bool :=
  match r with p :: q :: s :: l => sorted p q (s :: l) | _ => false end.

Definition tri_in (p q : pt) (l : list pt) (a b : pt) := In a (q :: l) /\ In b (q :: l) /\ 0 < det p a b.

Lemma fan_sum p q l z : wind (sides (p, q, l)) z = wind (flat_map edges3 (fan_from p q l)) z.
Proof. exact (wind_fan (p, q, l) z). Qed.

Lemma fan_01 p l z : forall q, sorted p q l = true ->
  wind (flat_map edges3 (fan_from p q l)) z = 0 \/
  wind (flat_map edges3 (fan_from p q l)) z = 1 /\
  exists a b, tri_in p q l a b /\ wind (edges3 (p, a, b)) z = 1.
Proof.
  induction l as [|r m IH]; intros q S; [left; reflexivity|].
  cbn [sorted] in S. apply andb_prop in S as (S & S2). apply andb_prop in S as (S0 & S1).
  apply Z.ltb_lt in S0. rewrite forallb_forall in S1.
  cbn [fan_from flat_map]. rewrite wind_app.
  destruct (half_open p q r z S0) as [E|(E & E1 & E2 & E3)]; rewrite E.
  - destruct (IH r S2) as [->|(-> & a & b & (I & J & D) & T)]; [left; reflexivity|right].
    split; [reflexivity|]. exists a, b. repeat split; try assumption; right; assumption.
  - destruct (IH r S2) as [->|(-> & a & b & (I & J & D) & T)].
    + right. split; [reflexivity|]. exists q, r. repeat split; cbn; auto.
    + exfalso.
      (* the line from p through r weakly separates q from a and b *)
      set (n := (snd p - snd r, fst r - fst p)).
      assert (Dn : forall v, dot n v - dot n p = det p r v) by (intro v; unfold dot, det, n; cbn; ring).
      assert (Later : forall v, In v (r :: m) -> 0 <= det p r v).
      { intros v [<-|V]; [replace (det p r r) with 0 by (unfold det; ring); lia|]. destruct m as [|s m']; [destruct V|].
        cbn [sorted] in S2. apply andb_prop in S2 as (S2 & _). apply andb_prop in S2 as (S2 & S3).
        apply Z.ltb_lt in S2. rewrite forallb_forall in S3.
        destruct V as [<-|V]; [lia|]. apply Z.leb_le, S3, V. }
      pose proof (Later a I). pose proof (Later b J).
      assert (Q : det p r q < 0) by (replace (det p r q) with (- det p q r) by (unfold det; ring); lia).
      assert (Zn : n <> (0, 0)).
      { intro Z0. unfold n in Z0. injection Z0 as Z1 Z2. unfold det in Q. nia. }
      pose proof (Dn q) as Dq. pose proof (Dn r) as Dr. pose proof (Dn a) as Da. pose proof (Dn b) as Db.
      assert (det p r r = 0) as Drr by (unfold det; ring).
      assert (L1 : dot n z <= dot n p) by (eapply (tri_bound p q r z n); lia).
      assert (L2 : dot (- fst n, - snd n) z <= - dot n p).
      { eapply (tri_bound p a b z); rewrite ?dot_opp; lia. }
      rewrite dot_opp in L2.
      destruct (either_way n Zn) as [R|R].
      * assert (wind (edges3 (p, q, r)) z <= 0); [|lia].
        apply (lean _ z n R). intros e [<-|[<-|[<-|[]]]]; cbn [fst snd]; lia.
      * assert (wind (edges3 (p, a, b)) z <= 0); [|lia].
        apply (lean _ z _ R). intros e [<-|[<-|[<-|[]]]]; cbn [fst snd]; rewrite !dot_opp; lia.
Qed.

Lemma fan_shape r : is_fan r = true -> exists p q s l, r = p :: q :: s :: l /\ sorted p q (s :: l) = true.
Proof.
  destruct r as [|p [|q [|s l]]]; try discriminate. intro H. exists p, q, s, l. split; [reflexivity|exact H].
Qed.

Lemma piece_01 r z : is_fan r = true -> ring_wind r z = 0 \/ ring_wind r z = 1.
Proof.
  intro H. destruct (fan_shape r H) as (p & q & s & l & -> & S).
  unfold ring_wind. rewrite edges_sides, fan_sum. destruct (fan_01 p (s :: l) z q S) as [->|(-> & _)]; auto.
Qed.

Lemma piece_bound r z n m : is_fan r = true -> 1 <= ring_wind r z ->
  (forall v, In v r -> dot n v <= m) -> dot n z <= m.
Proof.
  intros H W B. destruct (fan_shape r H) as (p & q & s & l & -> & S).
  unfold ring_wind in W. rewrite edges_sides, fan_sum in W.
  destruct (fan_01 p (s :: l) z q S) as [E|(E & a & b & (I & J & D) & T)]; [lia|].
  apply (tri_bound p a b z n m D); [lia|apply B; left; reflexivity| |]; apply B; right; assumption.
Qed.

(* Two pieces on opposite sides of a line are disjoint. *)
Lemma piece_sep r s z n m : is_fan r = true -> is_fan s = true -> n <> (0, 0) ->
  (forall v, In v r -> dot n v <= m) -> (forall v, In v s -> m <= dot n v) ->
  ring_wind r z + ring_wind s z <= 1.
Proof.
  intros R S N A B. destruct (piece_01 r z R) as [E|E]; destruct (piece_01 s z S) as [F|F]; try lia. exfalso.
  assert (L1 : dot n z <= m) by (apply (piece_bound r z n m R); [lia|assumption]).
  assert (L2 : dot (- fst n, - snd n) z <= - m).
  { apply (piece_bound s z _ _ S); [lia|]. intros v V. rewrite dot_opp. specialize (B v V). lia. }
  rewrite dot_opp in L2.
  destruct (either_way n N) as [R'|R'].
  - assert (ring_wind r z <= 0); [|lia]. apply (lean _ z n R'). intros e I.
    apply edges_ends in I as (I & J). split; [specialize (A _ I)|specialize (A _ J)]; lia.
  - assert (ring_wind s z <= 0); [|lia]. apply (lean _ z _ R'). intros e I.
    apply edges_ends in I as (I & J). rewrite !dot_opp.
    split; [specialize (B _ I)|specialize (B _ J)]; lia.
Qed.
