(* The nearest point of a convex hull; and rounded pieces as containers: sets near their hulls keep a distance from the
   complement. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Statements.
From Exactsweep Require Import Gaps Scaling HalfOpen Nearby Boundary SumPoints PiecePoints Covers Near Depth.
Import ListNotations.
Open Scope Q_scope.

(* The nearest point of a segment *)
Definition point_on (a b : qpoint) (t : Q) : qpoint := (fst a + t * (fst b - fst a), snd a + t * (snd b - snd a)).
Lemma dist2_on a b u t : Statements.dist2 (point_on a b t) u ==
  Statements.dist2 a u - 2 * t * along (vector a b) (vector a u) + t * t * square_of (vector a b).
Proof. unfold Statements.dist2, point_on, along, vector, square_of. cbn [fst snd]. ring. Qed.
Lemma nearest_on a b u : exists t, 0 <= t <= 1 /\ forall r, 0 <= r <= 1 -> Statements.dist2 (point_on a b t) u <= Statements.dist2 (point_on a b r) u.
Proof.
  set (v := vector a b). set (k := along v (vector a u)). set (m := square_of v). pose proof (square_of_nonneg v) as M. fold m in M.
  assert (E : forall t r, Statements.dist2 (point_on a b r) u - Statements.dist2 (point_on a b t) u == (r - t) * (m * (r + t) - 2 * k)).
  { intros t r. rewrite !dist2_on. fold v k m. ring. }
  destruct (Qlt_le_dec 0 k) as [K|K].
  - destruct (Qlt_le_dec k m) as [L|L].
    + exists (k / m). assert (F : m * (k / m) == k) by (field; lra). split; [split; [apply Qle_shift_div_l; lra|apply Qle_shift_div_r; lra]|].
      intros r R. specialize (E (k / m) r). assert (G : (r - k / m) * (m * (r + k / m) - 2 * k) == m * ((r - k / m) * (r - k / m))).
      { assert (X : 2 * k == 2 * (m * (k / m))) by (rewrite F; reflexivity). rewrite X. ring. }
      rewrite G in E. assert (0 <= m * ((r - k / m) * (r - k / m))) by (apply Qmult_le_0_compat; [exact M|apply sq_nonneg]). lra.
    + exists 1. split; [lra|]. intros r R. specialize (E 1 r).
      assert (0 <= (1 - r) * (2 * k - m * (r + 1))); [|assert (X : (r - 1) * (m * (r + 1) - 2 * k) == (1 - r) * (2 * k - m * (r + 1))) by ring; lra].
      apply Qmult_le_0_compat; [lra|]. pose proof (mono_le m (r + 1) 2 M ltac:(lra)). lra.
  - exists 0. split; [lra|]. intros r R. specialize (E 0 r).
    assert (0 <= r * (m * r - 2 * k)); [|assert (X : (r - 0) * (m * (r + 0) - 2 * k) == r * (m * r - 2 * k)) by ring; lra].
    apply Qmult_le_0_compat; [lra|]. assert (0 <= m * r) by (apply Qmult_le_0_compat; lra). lra.
Qed.

(* A segment from a point of a triangle to a point outside meets a side. *)
Definition on_side (a b y : qpoint) : Prop := exists t, 0 <= t <= 1 /\ meets_at y (point_on a b t).
Lemma towards f x u t : o f (point_on x u t) == o f x + t * (o f u - o f x).
Proof. unfold o, Statements.orient, point_on. cbn [fst snd]. ring. Qed.
Lemma dist2_towards x u t : Statements.dist2 (point_on x u t) u == (1 - t) * (1 - t) * Statements.dist2 x u.
Proof. unfold Statements.dist2, point_on. cbn [fst snd]. ring. Qed.
Definition neg_dec u (f : side) : {o f u < 0} + {~ o f u < 0}.
Proof. destruct (Qlt_le_dec (o f u) 0) as [L|L]; [left; exact L|right; lra]. Defined.
Lemma zero_side p a b y : 0 < o (p, a) b -> 0 <= o (p, a) y -> 0 <= o (b, p) y -> o (a, b) y == 0 -> on_side a b y.
Proof.
  intros T W V U. destruct (mean_self p a b y T) as (X & Y). pose proof (o_total p a b y) as S.
  set (w := o (p, a) y) in *. set (v := o (b, p) y) in *. set (s := o (p, a) b) in *.
  exists (w / s). assert (Ws : w / s * s == w) by (field; lra). split; [split; [apply Qle_shift_div_l; lra|apply Qle_shift_div_r; lra]|].
  unfold meets_at, point_on, mean in *. cbn [fst snd] in *. assert (V' : v == s - w) by lra. rewrite U, V' in X, Y. split; [rewrite X|rewrite Y]; field; lra.
Qed.
Lemma exit_side p a b x u : 0 < o (p, a) b -> 0 <= o (p, a) x -> 0 <= o (a, b) x -> 0 <= o (b, p) x ->
  o (p, a) u < 0 \/ o (a, b) u < 0 \/ o (b, p) u < 0 ->
  exists y, (on_side p a y \/ on_side a b y \/ on_side b p y) /\ Statements.dist2 y u <= Statements.dist2 x u.
Proof.
  intros T X1 X2 X3 N.
  set (fs := [(p, a); (a, b); (b, p)]).
  set (key := fun f => o f x / (o f x - o f u)).
  assert (Pos : forall f, In f fs -> 0 <= o f x) by (intros f [<-|[<-|[<-|[]]]]; assumption).
  destruct (least key (fun f => o f u < 0) (neg_dec u) fs) as (f & If & Fu & Le).
  { destruct N as [N|[N|N]]; eexists; (split; [|exact N]); unfold fs; cbn; auto. }
  set (t := key f). assert (D : 0 < o f x - o f u) by (pose proof (Pos f If); lra).
  assert (Tt : t * (o f x - o f u) == o f x) by (unfold t, key; field; lra).
  assert (T01 : 0 <= t <= 1) by (pose proof (Pos f If); split; [apply Qle_shift_div_l; lra|apply Qle_shift_div_r; lra]).
  set (y := point_on x u t).
  assert (Y : forall g, In g fs -> 0 <= o g y).
  { intros g Ig. unfold y. rewrite towards. pose proof (Pos g Ig) as Gx. destruct (Qlt_le_dec (o g u) 0) as [L|L].
    - specialize (Le g Ig L). fold t in Le. assert (E : key g * (o g x - o g u) == o g x) by (unfold key; field; lra).
      assert (t * (o g x - o g u) <= key g * (o g x - o g u)) by (apply Qmult_le_compat_r; lra). lra.
    - assert (0 <= t * o g u) by (apply Qmult_le_0_compat; lra). assert (0 <= (1 - t) * o g x) by (apply Qmult_le_0_compat; lra). lra. }
  assert (Z : o f y == 0) by (unfold y; rewrite towards; lra).
  exists y. split.
  - pose proof (Y (p, a) (or_introl eq_refl)) as Y1. pose proof (Y (a, b) (or_intror (or_introl eq_refl))) as Y2.
    pose proof (Y (b, p) (or_intror (or_intror (or_introl eq_refl)))) as Y3.
    assert (Ta : 0 < o (a, b) p) by (assert (E : o (a, b) p == o (p, a) b) by (unfold o, Statements.orient; cbn [fst snd]; ring); lra).
    assert (Tb : 0 < o (b, p) a) by (assert (E : o (b, p) a == o (p, a) b) by (unfold o, Statements.orient; cbn [fst snd]; ring); lra).
    destruct If as [<-|[<-|[<-|[]]]].
    + left. exact (zero_side b p a y Tb Y3 Y2 Z).
    + right. left. exact (zero_side p a b y T Y1 Y3 Z).
    + right. right. exact (zero_side a b p y Ta Y2 Y1 Z).
  - unfold y. rewrite dist2_towards. assert (0 <= (1 - (1 - t) * (1 - t)) * Statements.dist2 x u); [|lra].
    apply Qmult_le_0_compat; [|apply dist2_nonneg]. assert (0 <= t * (2 - t)) by (apply Qmult_le_0_compat; lra).
    assert (E : 1 - (1 - t) * (1 - t) == t * (2 - t)) by ring. lra.
Qed.

Lemma hull_on ps a b t : In a ps -> In b ps -> 0 <= t <= 1 -> Statements.hull ps (point_on a b t).
Proof. intros A B T. exact (hull_edge ps (a, b) t A B T). Qed.
Lemma dist2_same y z u : meets_at y z -> Statements.dist2 y u == Statements.dist2 z u.
Proof. intros (A & B). unfold Statements.dist2. rewrite A, B. reflexivity. Qed.
Lemma not_triangle p a b u : in_triangle p (a, b) u = false -> 0 < o (p, a) b -> o (p, a) u < 0 \/ o (a, b) u < 0 \/ o (b, p) u < 0.
Proof.
  intros H T. destruct (Qlt_le_dec (o (p, a) u) 0) as [L1|L1]; [left; exact L1|]. destruct (Qlt_le_dec (o (a, b) u) 0) as [L2|L2]; [right; left; exact L2|].
  destruct (Qlt_le_dec (o (b, p) u) 0) as [L3|L3]; [right; right; exact L3|exfalso].
  unfold in_triangle in H. cbv zeta in H. cbn [fst snd] in H. pose proof (o_total p a b u) as E.
  apply Qle_bool_iff in L1, L2, L3. rewrite L1, L2, L3 in H. cbn [andb] in H.
  assert (X : Statements.less 0 (o (a, b) u + o (b, p) u + o (p, a) u) = true) by (apply less_true; lra). congruence.
Qed.
(* Between a point of a segment and a third point on its line *)
Lemma on_line {X : qpoint -> Prop} a b p t s : X a -> X b -> X p -> 0 <= t <= 1 -> 0 <= s <= 1 -> o (a, b) p == 0 -> ~ meets_at a b ->
  (forall c d r, X c -> X d -> 0 <= r <= 1 -> meets_at (point_on (point_on a b t) p s) (point_on c d r) -> False) -> False.
Proof.
  intros A B P T S Z N Cl. destruct (line_share (a, b) p Z N) as (r & Px & Py). cbn [fst snd] in Px, Py.
  set (v := (1 - s) * t + s * r).
  assert (T0 : 0 <= (1 - s) * t) by (apply Qmult_le_0_compat; lra). assert (T1 : 0 <= (1 - s) * (1 - t)) by (apply Qmult_le_0_compat; lra).
  destruct (Qlt_le_dec v 0) as [V0|V0]; [|destruct (Qlt_le_dec 1 v) as [V1|V1]].
  - assert (R : r < 0). { destruct (Qlt_le_dec r 0) as [|L]; [assumption|exfalso]. assert (0 <= s * r) by (apply Qmult_le_0_compat; lra). unfold v in V0. lra. }
    assert (Vr : v - r == (1 - s) * (t - r)) by (unfold v; ring). assert (0 <= (1 - s) * (t - r)) by (apply Qmult_le_0_compat; lra).
    assert (E : v / r * r == v) by (field; lra). assert (E' : v / r == (- v) / (- r)) by (field; lra).
    apply (Cl a p (v / r) A P); [rewrite E'; split; [apply Qle_shift_div_l; lra|apply Qle_shift_div_r; lra]|].
    unfold meets_at, point_on. cbn [fst snd]. rewrite Px, Py. unfold v. split; field; lra.
  - assert (R : 1 < r). { destruct (Qlt_le_dec 1 r) as [|L]; [assumption|exfalso]. assert (0 <= s * (1 - r)) by (apply Qmult_le_0_compat; lra). unfold v in V1. lra. }
    assert (Vr : r - v == (1 - s) * (r - t)) by (unfold v; ring). assert (0 <= (1 - s) * (r - t)) by (apply Qmult_le_0_compat; lra).
    apply (Cl b p ((v - 1) / (r - 1)) B P); [split; [apply Qle_shift_div_l; lra|apply Qle_shift_div_r; lra]|].
    unfold meets_at, point_on. cbn [fst snd]. rewrite Px, Py. unfold v. split; field; lra.
  - apply (Cl a b v A B ltac:(lra)). unfold meets_at, point_on. cbn [fst snd]. rewrite Px, Py. unfold v. split; ring.
Qed.
Theorem nearest ps u : ps <> [] -> exists q, Statements.hull ps q /\ forall p, In p ps -> along (vector q u) (vector q p) <= 0.
Proof.
  intro Ne. destruct (existsb (fun p => existsb (fun a => existsb (fun b => in_triangle p (a, b) u && Statements.less 0 (o (p, a) b)) ps) ps) ps) eqn:Tr.
  - apply existsb_exists in Tr as (p & P & Tr). apply existsb_exists in Tr as (a & A & Tr). apply existsb_exists in Tr as (b & B & Tr).
    apply andb_prop in Tr as (Tr & T). apply less_true in T. unfold in_triangle in Tr. cbv zeta in Tr. cbn [fst snd] in Tr.
    apply andb_prop in Tr as (Tr & _). apply andb_prop in Tr as (Tr & V). apply andb_prop in Tr as (W & U). apply Qle_bool_iff in W, U, V.
    exists u. split; [exact (hull_triangle ps p a b u P A B W U V T)|]. intros q _. unfold along, vector. cbn [fst snd].
    assert (E : (fst u - fst u) * (fst q - fst u) + (snd u - snd u) * (snd q - snd u) == 0) by ring. lra.
  - assert (NT : forall p a b, In p ps -> In a ps -> In b ps -> 0 < o (p, a) b -> o (p, a) u < 0 \/ o (a, b) u < 0 \/ o (b, p) u < 0).
    { intros p a b P A B T. apply not_triangle; [|exact T]. destruct (in_triangle p (a, b) u) eqn:E; [exfalso|reflexivity].
      assert (X : existsb (fun p => existsb (fun a => existsb (fun b => in_triangle p (a, b) u && Statements.less 0 (o (p, a) b)) ps) ps) ps = true); [|congruence].
      apply existsb_exists. exists p. split; [exact P|]. apply existsb_exists. exists a. split; [exact A|]. apply existsb_exists. exists b. split; [exact B|].
      rewrite E. apply less_true, T. }
    assert (Mn : forall l : list (qpoint * qpoint), l <> [] -> exists a b t, In (a, b) l /\ 0 <= t <= 1 /\
      forall c d r, In (c, d) l -> 0 <= r <= 1 -> Statements.dist2 (point_on a b t) u <= Statements.dist2 (point_on c d r) u).
    { induction l as [|(c, d) l IH]; [contradiction|intros _]. destruct (nearest_on c d u) as (s & S & Sm).
      destruct l as [|x l]; [exists c, d, s; split; [left; reflexivity|split; [exact S|intros c' d' r [E|[]] R; injection E as <- <-; exact (Sm r R)]]|].
      destruct IH as (a & b & t & I & T & M); [discriminate|].
      destruct (Qlt_le_dec (Statements.dist2 (point_on a b t) u) (Statements.dist2 (point_on c d s) u)) as [L|L].
      - exists a, b, t. split; [right; exact I|]. split; [exact T|]. intros c' d' r [E|J] R; [injection E as <- <-; pose proof (Sm r R); lra|exact (M c' d' r J R)].
      - exists c, d, s. split; [left; reflexivity|]. split; [exact S|]. intros c' d' r [E|J] R; [injection E as <- <-; exact (Sm r R)|pose proof (M c' d' r J R); lra]. }
    destruct (Mn (list_prod ps ps)) as (a & b & t & I & T & M); [destruct ps; [contradiction|discriminate]|]. apply in_prod_iff in I as (A & B).
    assert (M' : forall c d r, In c ps -> In d ps -> 0 <= r <= 1 -> Statements.dist2 (point_on a b t) u <= Statements.dist2 (point_on c d r) u)
      by (intros c d r C D; apply M, in_prod; assumption). clear M Mn Tr.
    set (q := point_on a b t) in *. exists q. split; [exact (hull_on ps a b t A B T)|]. intros p P.
    destruct (Qlt_le_dec 0 (along (vector q u) (vector q p))) as [L|]; [exfalso|assumption].
    (* a point between q and p is nearer to u *)
    set (k := along (vector q u) (vector q p)) in *. set (m := square_of (vector q p)) in *. pose proof (square_of_nonneg (vector q p)) as M0. fold m in M0.
    assert (Kq : 0 < k / (m + k)) by (apply Qlt_shift_div_l; lra).
    set (s := k / (m + k)) in *. assert (Es : s * (m + k) == k) by (unfold s; field; lra).
    assert (S1 : s <= 1) by (apply Qle_shift_div_r; lra).
    set (x := point_on q p s).
    assert (Near : Statements.dist2 x u < Statements.dist2 q u).
    { unfold x. rewrite dist2_on. fold m. assert (Ek : along (vector q p) (vector q u) == k) by (unfold k, along; ring). rewrite Ek.
      assert (s * s * m <= s * k) by (assert (X : s * s * m == s * (s * m)) by ring; rewrite X; apply mono_le; [lra|]; assert (0 <= s * k) by (apply Qmult_le_0_compat; lra); lra).
      assert (0 < s * k) by (apply Qmult_lt_0_compat; assumption). lra. }
    assert (Side : forall c d y, In c ps -> In d ps -> on_side c d y -> Statements.dist2 q u <= Statements.dist2 y u).
    { intros c d y C D (r & R & Y). rewrite (dist2_same y _ u Y). exact (M' c d r C D R). }
    assert (Q_ : o (a, b) q == 0) by (unfold q, o, Statements.orient, point_on; cbn [fst snd]; ring).
    assert (Oq : forall c d, o (c, d) x == (1 - s) * o (c, d) q + s * o (c, d) p) by (intros c d; unfold x; rewrite towards; ring).
    destruct (Qlt_le_dec 0 (o (p, a) b)) as [O1|O1].
    + destruct (exit_side p a b x u O1) as (y & Y & Dy); [| | |exact (NT p a b P A B O1)|].
      * rewrite Oq. assert (E : o (p, a) p == 0) by (unfold o, Statements.orient; cbn [fst snd]; ring). rewrite E.
        assert (F : o (p, a) q == t * o (p, a) b) by (unfold q, o, Statements.orient, point_on; cbn [fst snd]; ring). rewrite F.
        assert (0 <= t * o (p, a) b) by (apply Qmult_le_0_compat; lra). assert (0 <= (1 - s) * (t * o (p, a) b)) by (apply Qmult_le_0_compat; lra). lra.
      * rewrite Oq, Q_. assert (F : o (a, b) p == o (p, a) b) by (unfold o, Statements.orient; cbn [fst snd]; ring). rewrite F.
        assert (0 <= s * o (p, a) b) by (apply Qmult_le_0_compat; lra). lra.
      * rewrite Oq. assert (E : o (b, p) p == 0) by (unfold o, Statements.orient; cbn [fst snd]; ring). rewrite E.
        assert (F : o (b, p) q == (1 - t) * o (p, a) b) by (unfold q, o, Statements.orient, point_on; cbn [fst snd]; ring). rewrite F.
        assert (0 <= (1 - t) * o (p, a) b) by (apply Qmult_le_0_compat; lra). assert (0 <= (1 - s) * ((1 - t) * o (p, a) b)) by (apply Qmult_le_0_compat; lra). lra.
      * destruct Y as [Y|[Y|Y]]; [pose proof (Side p a y P A Y)|pose proof (Side a b y A B Y)|pose proof (Side b p y B P Y)]; lra.
    + destruct (Qlt_le_dec (o (p, a) b) 0) as [O2|O2].
      * assert (O3 : 0 < o (p, b) a) by (assert (F : o (p, b) a == - o (p, a) b) by (unfold o, Statements.orient; cbn [fst snd]; ring); lra).
        destruct (exit_side p b a x u O3) as (y & Y & Dy); [| | |exact (NT p b a P B A O3)|].
        -- rewrite Oq. assert (E : o (p, b) p == 0) by (unfold o, Statements.orient; cbn [fst snd]; ring). rewrite E.
           assert (F : o (p, b) q == (1 - t) * o (p, b) a) by (unfold q, o, Statements.orient, point_on; cbn [fst snd]; ring). rewrite F.
           assert (0 <= (1 - t) * o (p, b) a) by (apply Qmult_le_0_compat; lra). assert (0 <= (1 - s) * ((1 - t) * o (p, b) a)) by (apply Qmult_le_0_compat; lra). lra.
        -- rewrite Oq. assert (G : o (b, a) q == 0) by (unfold q, o, Statements.orient, point_on; cbn [fst snd]; ring). rewrite G.
           assert (F : o (b, a) p == o (p, b) a) by (unfold o, Statements.orient; cbn [fst snd]; ring). rewrite F.
           assert (0 <= s * o (p, b) a) by (apply Qmult_le_0_compat; lra). lra.
        -- rewrite Oq. assert (E : o (a, p) p == 0) by (unfold o, Statements.orient; cbn [fst snd]; ring). rewrite E.
           assert (F : o (a, p) q == t * o (p, b) a) by (unfold q, o, Statements.orient, point_on; cbn [fst snd]; ring). rewrite F.
           assert (0 <= t * o (p, b) a) by (apply Qmult_le_0_compat; lra). assert (0 <= (1 - s) * (t * o (p, b) a)) by (apply Qmult_le_0_compat; lra). lra.
        -- destruct Y as [Y|[Y|Y]]; [pose proof (Side p b y P B Y)|pose proof (Side b a y B A Y)|pose proof (Side a p y A P Y)]; lra.
      * (* p on the line of a and b, or a = b *)
        assert (Z : o (a, b) p == 0) by (assert (F : o (a, b) p == o (p, a) b) by (unfold o, Statements.orient; cbn [fst snd]; ring); lra).
        assert (Cl : forall c d r, In c ps -> In d ps -> 0 <= r <= 1 -> meets_at x (point_on c d r) -> False).
        { intros c d r C D R Y. pose proof (Side c d x C D (ex_intro _ r (conj R Y))). lra. }
        destruct (Qeq_dec (fst a) (fst b)) as [Ea|Ea]; [destruct (Qeq_dec (snd a) (snd b)) as [Eb|Eb]|].
        -- apply (Cl a p s A P ltac:(lra)). unfold x, q, meets_at, point_on. cbn [fst snd]. rewrite <- Ea, <- Eb. split; ring.
        -- apply (@on_line (fun c => In c ps) a b p t s A B P T ltac:(lra) Z ltac:(intros (_ & E); exact (Eb E)) Cl).
        -- apply (@on_line (fun c => In c ps) a b p t s A B P T ltac:(lra) Z ltac:(intros (E & _); exact (Ea E)) Cl).
Qed.

(* Points near a hull *)
Definition near_hull (r : Q) (ps : list qpoint) (z : qpoint) : bool := some (fun q => Qle_bool (Statements.dist2 q z) (r * r)) (hull_points ps z).
Lemma near_hull_point r ps z : near_hull r ps z = true -> exists q, Statements.hull ps q /\ Statements.dist2 q z <= r * r.
Proof.
  intro H. apply some_exists in H as (q & I & H). apply Qle_bool_iff in H. exists q. split; [exact (hull_points_in ps z q I)|exact H].
Qed.
Lemma near_hull_spec r ps z : 0 <= r -> near_hull r ps z = true -> Statements.within r (Statements.hull ps) z.
Proof.
  intros R H d D F. destruct (near_hull_point r ps z H) as (q & I & L). specialize (F q I). pose proof (sq_lt r d R D). lra.
Qed.
(* The hull of points near a hull is near that hull. *)
Lemma within_hull ps vs c y : ps <> [] -> 0 <= c -> (forall v, In v vs -> exists q, Statements.hull ps q /\ Statements.dist2 q v <= c * c) ->
  (forall n, exists v, In v vs /\ along n y <= along n v) -> Statements.within c (Statements.hull ps) y.
Proof.
  intros Ne C H D d Dc F. destruct (nearest ps y Ne) as (q & Hq & Nq). set (n := vector q y).
  destruct (D n) as (v & V & L). destruct (H v V) as (w & Hw & Dw).
  assert (Nw : along n w <= along n q).
  { assert (G : fst n * fst w + snd n * snd w <= along n q); [|exact G]. apply Hw. intros p P. specialize (Nq p P). fold n in Nq. unfold vector, along in *. cbn [fst snd] in *. lra. }
  specialize (F q Hq). pose proof (cauchy n w v c C Dw) as Ca.
  assert (E : square_of n == along n y - along n q) by (unfold square_of, along, n, vector; cbn [fst snd]; ring).
  assert (Dn : Statements.dist2 q y == square_of n) by (unfold Statements.dist2, square_of, n, vector; cbn [fst snd]; ring). rewrite Dn in F.
  set (N := square_of n) in *. pose proof (square_of_nonneg n) as N0. fold N in N0.
  assert (Nl : N <= along n v - along n w) by lra. pose proof (sq_le N (along n v - along n w) N0 Nl) as Sq.
  pose proof (sq_lt c d C Dc) as Cd. assert (Np : 0 < N) by (pose proof (sq_nonneg d); lra).
  assert (X : N * N <= N * (c * c)) by lra. assert (Y : N * (c * c) < N * N) by (apply mono_lt; lra). lra.
Qed.

(* R: the radius of the container. e: its error. Each region is near the hull and leaves a distance s. *)
Theorem keeps_hull s R e ps (l : list region) (S D U : qpoint -> Prop) : 0 <= s -> 0 <= e -> s + e <= R ->
  (forall z, S z -> in_some l z) ->
  (forall q, In q l -> 0 <= snd q /\ exists b, 0 <= b /\ b + snd q + s + e <= R /\ forall y, fst q y -> Statements.within b (Statements.hull ps) y) ->
  (forall y, D y -> ~ Statements.within R (Statements.hull ps) y) -> Statements.known_to e D U -> Statements.keeps s S U.
Proof.
  intros S0 E0 Le Cov B Far K. set (b := R - s - e). assert (B0 : 0 <= b) by (unfold b; lra).
  assert (In_ : forall z, S z -> Statements.within b (Statements.hull ps) z).
  { intros z Z d Dd F. apply (Cov z Z). intros q Iq W. destruct (B q Iq) as (Q0 & c & C & Lc & Hc).
    pose proof (within_within (snd q) c (Statements.hull ps) z Q0 C (within_more _ _ _ z Hc W)) as T.
    apply (T d); [unfold b in Dd; lra|exact F]. }
  assert (Out : forall z u c, S z -> D u -> 0 <= c -> Statements.dist2 z u <= c * c -> b + c < R -> False).
  { intros z u c Z Du C Dz Lt. apply (Far u Du). intros d Dd F. apply (In_ z Z (R - c) ltac:(lra)). intros q Hq. specialize (F q Hq).
    destruct (Qlt_le_dec ((R - c) * (R - c)) (Statements.dist2 q z)) as [|L]; [assumption|exfalso].
    pose proof (triangle q z u (R - c) c ltac:(lra) C L Dz) as T. assert (X : R - c + c == R) by ring. rewrite X in T. pose proof (sq_lt R d ltac:(lra) Dd). lra. }
  split.
  - intros (c & (h & Hp & HS) & (h' & Hp' & HU)). destruct (below h h' Hp Hp') as (g & G & G1 & G2).
    assert (Uc : U c) by (apply HU; unfold Statements.close; lra). set (t := g / 8). assert (Et : t == (1 # 8) * g) by (unfold t; field).
    set (L := e + t). apply (K c Uc L ltac:(unfold L; lra)). intros u Du. destruct (Qlt_le_dec (L * L) (Statements.dist2 u c)) as [|N]; [assumption|exfalso].
    assert (L0 : 0 < L) by (unfold L; lra).
    destruct (Qlt_le_dec L (g / 2)) as [Sm|Lg]; assert (E2 : g / 2 == (1 # 2) * g) by field.
    + assert (Cu : Statements.close h u c).
      { assert (Bd : forall a, a * a <= L * L -> - g < a < g) by (intros a A; split; [assert (- a < g); [|lra]|]; apply sq_less; try lra; pose proof (sq_lt L g ltac:(lra) ltac:(lra)); assert ((- a) * (- a) == a * a) by ring; lra).
        unfold Statements.dist2 in N. unfold Statements.close. pose proof (sq_nonneg (fst u - fst c)). pose proof (sq_nonneg (snd u - snd c)).
        pose proof (Bd (fst u - fst c) ltac:(lra)). pose proof (Bd (snd u - snd c) ltac:(lra)). lra. }
      apply (Far u Du). intros d Dd F. apply (In_ u (HS u Cu) d); [unfold b; lra|exact F].
    + set (r := (g / 2) / L). assert (Er : r * L == (1 # 2) * g) by (unfold r; field; lra).
      assert (R01 : 0 < r <= 1) by (split; [apply Qlt_shift_div_l; lra|apply Qle_shift_div_r; lra]).
      set (y := point_on c u r).
      assert (Cy : Statements.close h y c).
      { assert (Bd : forall a, a * a <= L * L -> - g < r * a < g).
        { intros a A. assert (A1 : - (2 * L) < a < 2 * L) by (split; [assert (- a < 2 * L); [|lra]|]; apply sq_less; try lra; pose proof (sq_lt L (2 * L) ltac:(lra) ltac:(lra)); assert ((- a) * (- a) == a * a) by ring; lra).
          assert (r * a < r * (2 * L)) by (apply mono_lt; lra). assert (r * - a < r * (2 * L)) by (apply mono_lt; lra).
          assert (r * (2 * L) == g) by (assert (X : r * (2 * L) == 2 * (r * L)) by ring; rewrite X, Er; ring). assert (r * - a == - (r * a)) by ring. lra. }
        unfold Statements.dist2 in N. unfold Statements.close, y, point_on. cbn [fst snd]. pose proof (sq_nonneg (fst u - fst c)). pose proof (sq_nonneg (snd u - snd c)).
        pose proof (Bd (fst u - fst c) ltac:(lra)) as X. pose proof (Bd (snd u - snd c) ltac:(lra)) as Y.
        assert (X' : fst c + r * (fst u - fst c) - fst c == r * (fst u - fst c)) by ring. assert (Y' : snd c + r * (snd u - snd c) - snd c == r * (snd u - snd c)) by ring.
        rewrite X', Y'. lra. }
      apply (Out y u ((1 - r) * L) (HS y Cy) Du); [apply Qmult_le_0_compat; lra| |].
      * unfold y. rewrite dist2_towards, dist2_sym. assert (X : (1 - r) * L * ((1 - r) * L) == (1 - r) * (1 - r) * (L * L)) by ring. rewrite X.
        apply mono_le; [apply sq_nonneg|exact N].
      * assert (X : (1 - r) * L == L - r * L) by ring. rewrite X, Er. unfold L, b. lra.
  - apply closure_dist. intros z u Z Hu. destruct (Qlt_le_dec (Statements.dist2 z u) (s * s)) as [Lt|]; [exfalso|assumption].
    destruct (root_below _ _ (dist2_nonneg z u) S0 Lt) as (k & (K0 & Kl) & Dk). set (t := (s - k) / 2). assert (Et : t == (1 # 2) * (s - k)) by (unfold t; field).
    apply (K u Hu (e + t) ltac:(lra)). intros w Dw. destruct (Qlt_le_dec ((e + t) * (e + t)) (Statements.dist2 w u)) as [|N]; [assumption|exfalso].
    rewrite dist2_sym in N. pose proof (triangle z u w k (e + t) K0 ltac:(lra) Dk N) as T.
    apply (Out z w (k + (e + t)) Z Dw ltac:(lra) T). unfold b. lra.
Qed.
