(* The main lemma: the loops wind exactly once around the points of O and not around any others. U is a union of open
   convex polygons, given by their sides. L is a set of segments: the edges of the loops, and the fits. On a horizontal
   line in general position, a ray to the right from a point outside U and L either meets nothing or first meets a
   descending edge of a loop with U behind it. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby.
Import ListNotations.
Open Scope Q_scope.

Definition meets_at (p q : Statements.point) : Prop := fst p == fst q /\ snd p == snd q.
(* A convex region, given by some of its sides: all ends are on or left of all sides, and collinear sides have the same
   direction. A single side bounds a half-plane. *)
Definition convex (S : list side) : Prop := forall f g, In f S -> In g S ->
  0 <= o g (fst f) /\ 0 <= o g (snd f) /\ (0 < o g (fst f) \/ 0 < o g (snd f) \/ rise g == rise f).
(* A polygon: each side has a predecessor and a successor, with left turns. *)
Definition linked (S : list side) : Prop := forall f, In f S ->
  (exists g, In g S /\ meets_at (snd g) (fst f) /\ 0 < o g (snd f)) /\
  (exists g, In g S /\ meets_at (fst g) (snd f) /\ 0 < o g (fst f)).
Definition inS (S : list side) (t : Statements.point) : Prop := forall f, In f S -> 0 < o f t.

Lemma o_same f p q : meets_at p q -> o f p == o f q.
Proof. intros (A & B). unfold o, Statements.orient. rewrite A, B. reflexivity. Qed.

Lemma o_share f a b s x : fst x == fst a + s * (fst b - fst a) -> snd x == snd a + s * (snd b - snd a) ->
  o f x == (1 - s) * o f a + s * o f b.
Proof. intros X Y. unfold o, Statements.orient. rewrite X, Y. ring. Qed.

Lemma line_share f x : o f x == 0 -> ~ meets_at (fst f) (snd f) -> exists s,
  fst x == fst (fst f) + s * (fst (snd f) - fst (fst f)) /\ snd x == snd (fst f) + s * (snd (snd f) - snd (fst f)).
Proof.
  intros O N. unfold o, Statements.orient in O. destruct f as [a b]. cbn [fst snd] in *.
  assert (E : (fst b - fst a) * (snd x - snd a) == (snd b - snd a) * (fst x - fst a)) by lra.
  destruct (Qeq_dec (fst a) (fst b)) as [A|A].
  - destruct (Qeq_dec (snd a) (snd b)) as [B|B]; [exfalso; apply N; split; assumption|].
    exists ((snd x - snd a) / (snd b - snd a)). split; [|field; lra].
    assert (fst x - fst a == (snd x - snd a) / (snd b - snd a) * (fst b - fst a)); [|lra].
    apply (Qmult_inj_l _ _ (snd b - snd a)); [lra|]. rewrite <- E. field. lra.
  - exists ((fst x - fst a) / (fst b - fst a)). split; [field; lra|].
    assert (snd x - snd a == (fst x - fst a) / (fst b - fst a) * (snd b - snd a)); [|lra].
    apply (Qmult_inj_l _ _ (fst b - fst a)); [lra|]. rewrite E. field. lra.
Qed.

Lemma pos_cancel a b : 0 < b -> 0 <= a * b -> 0 <= a.
Proof. intros B H. destruct (Qlt_le_dec a 0) as [L|L]; [exfalso|exact L]. nra. Qed.

(* If a point of the closed polygon is on the line of a side, it is on the side. *)
Lemma closed_on_side S f x : linked S -> In f S -> o f x == 0 -> (forall g, In g S -> 0 <= o g x) ->
  Statements.on_segment f x.
Proof.
  intros C I O A. destruct (C f I) as ((g & G & Gm & Gp) & (h & H & Hm & Hp)).
  assert (N : ~ meets_at (fst f) (snd f)).
  { intro M. rewrite <- (o_same g _ _ M), <- (o_same g _ _ Gm) in Gp. unfold o, Statements.orient in Gp. lra. }
  destruct (line_share f x O N) as (s & X & Y). exists s. split; [|split; assumption].
  pose proof (A g G) as Ag. rewrite (o_share g _ _ s x X Y), <- (o_same g _ _ Gm) in Ag.
  pose proof (A h H) as Ah. rewrite (o_share h _ _ s x X Y), <- (o_same h _ _ Hm) in Ah.
  assert (Z1 : o g (snd g) == 0) by (unfold o, Statements.orient; ring).
  assert (Z2 : o h (fst h) == 0) by (unfold o, Statements.orient; ring).
  rewrite Z1 in Ag. rewrite Z2 in Ah. split.
  - apply (pos_cancel s _ Gp). lra.
  - assert (0 <= 1 - s); [|lra]. apply (pos_cancel _ _ Hp). lra.
Qed.

Definition at_x (t : Statements.point) (x : Q) : Statements.point := (x, snd t).
Lemma o_line f t x : o f (at_x t x) == o f t - rise f * (x - fst t).
Proof. rewrite (o_move f t). unfold at_x. cbn [fst snd]. ring. Qed.
(* The intersection of a horizontal line and the line of a non-horizontal side *)
Definition root (f : side) (t : Statements.point) : Q := fst t + o f t / rise f.
Lemma o_root f t x : ~ rise f == 0 -> o f (at_x t x) == rise f * (root f t - x).
Proof. intro N. rewrite o_line. unfold root. field. exact N. Qed.

(* The region is adjacent to interior points of its sides. *)
Lemma beside S f y : convex S -> In f S -> Statements.on_segment f y ->
  ~ snd (fst f) == snd y -> ~ snd (snd f) == snd y ->
  forall g, In g S -> 0 < o g y \/ o g y == 0 /\ rise g == rise f.
Proof.
  intros C I (s & (S0 & S1) & X & Y) N1 N2 g G. destruct (C f g I G) as (H1 & H2 & H3). rewrite (o_share g _ _ s y X Y).
  assert (s0 : 0 < s).
  { destruct (Qeq_dec s 0) as [E|E]; [|lra]. exfalso. apply N1. rewrite Y, E. ring. }
  assert (s1 : 0 < 1 - s).
  { destruct (Qeq_dec s 1) as [E|E]; [|lra]. exfalso. apply N2. rewrite Y, E. ring. }
  assert (0 <= (1 - s) * o g (fst f)) by (apply Qmult_le_0_compat; lra).
  assert (0 <= s * o g (snd f)) by (apply Qmult_le_0_compat; lra).
  destruct H3 as [H3|[H3|H3]].
  - left. assert (0 < (1 - s) * o g (fst f)) by (apply Qmult_lt_0_compat; lra). lra.
  - left. assert (0 < s * o g (snd f)) by (apply Qmult_lt_0_compat; lra). lra.
  - destruct (Qlt_le_dec 0 ((1 - s) * o g (fst f) + s * o g (snd f))); [left; assumption|right]. split; [lra|exact H3].
Qed.

Lemma enter S y k : (forall g, In g S -> 0 < o g y \/ o g y == 0 /\ 0 < k * rise g) ->
  forall r, 0 < r -> exists e, 0 < e /\ e <= r /\ inS S (at_x y (fst y - k * e)).
Proof.
  intros H r R. induction S as [|g S IH].
  - exists r. repeat split; [lra|lra|intros g []].
  - destruct IH as (e & E & L & J); [intros h I; apply H; right; assumption|].
    assert (X : exists c, 0 < c /\ forall d, 0 < d -> d <= c -> 0 < o g (at_x y (fst y - k * d))).
    { assert (Form : forall d, o g (at_x y (fst y - k * d)) == o g y + k * rise g * d) by (intro d; rewrite o_line; ring).
      destruct (H g (or_introl eq_refl)) as [P|(P & Q)].
      - set (m := k * rise g * (k * rise g) + 1). pose proof (abs_bound (k * rise g)) as B. fold m in B.
        assert (M : 0 < m) by (unfold m; nra). assert (0 < o g y / (2 * m)) by (apply Qlt_shift_div_l; lra).
        exists (o g y / (2 * m)). split; [assumption|]. intros d D D'. rewrite Form.
        pose proof (prod_bound (k * rise g) m d B ltac:(lra)).
        pose proof (mono_le (2 * m) _ _ ltac:(lra) D').
        assert (2 * m * (o g y / (2 * m)) == o g y) by (field; lra). lra.
      - exists 1. split; [lra|]. intros d D _. rewrite Form, P.
        assert (0 < k * rise g * d) by (apply Qmult_lt_0_compat; assumption). lra. }
    destruct X as (c & C & X). destruct (below c e C E) as (d & D & D1 & D2). exists d. split; [exact D|]. split; [lra|].
    intros h [<-|I]; [apply X; assumption|].
    (* by convexity along the line between y and the point at e *)
    pose proof (J h I) as Jh. rewrite o_line in *.
    assert (Hy : 0 <= o h y) by (destruct (H h (or_intror I)) as [|(Z0 & _)]; lra).
    assert (Q1 : o h y - rise h * (fst y - k * d - fst y) == o h y + k * rise h * d) by ring.
    assert (Q2 : o h y - rise h * (fst y - k * e - fst y) == o h y + k * rise h * e) by ring.
    rewrite Q1. rewrite Q2 in Jh. destruct (H h (or_intror I)) as [P|(P & Q)].
    + destruct (Qlt_le_dec (k * rise h) 0) as [N|N].
      * pose proof (mono_le (- (k * rise h)) d e ltac:(lra) D2). lra.
      * assert (0 <= k * rise h * d) by (apply Qmult_le_0_compat; lra). lra.
    + assert (0 < k * rise h * d) by (apply Qmult_lt_0_compat; lra). lra.
Qed.

(* Maxima and minima over lists *)
Lemma least {A} (key : A -> Q) (P : A -> Prop) (dec : forall x, {P x} + {~ P x}) l :
  (exists x, In x l /\ P x) -> exists x, In x l /\ P x /\ forall y, In y l -> P y -> key x <= key y.
Proof.
  induction l as [|a l IH]; intros (x & I & Px); [destruct I|].
  destruct (Exists_dec P l dec) as [E|E].
  - rewrite Exists_exists in E. destruct (IH E) as (m & M & Pm & Lm).
    destruct (dec a) as [Pa|Na].
    + destruct (Qlt_le_dec (key a) (key m)) as [L|L].
      * exists a. split; [left; reflexivity|]. split; [exact Pa|]. intros y [<-|J] Py; [lra|]. specialize (Lm y J Py). lra.
      * exists m. split; [right; exact M|]. split; [exact Pm|]. intros y [<-|J] Py; [lra|exact (Lm y J Py)].
    + exists m. split; [right; exact M|]. split; [exact Pm|]. intros y [<-|J] Py; [contradiction|exact (Lm y J Py)].
  - destruct I as [<-|I]; [|exfalso; apply E; rewrite Exists_exists; exists x; auto].
    exists a. split; [left; reflexivity|]. split; [exact Px|]. intros y [<-|J] Py; [lra|].
    exfalso. apply E. rewrite Exists_exists. exists y. auto.
Qed.

Definition count_below (X : list Q) (x : Q) : nat := length (filter (fun q => Statements.less q x) X).
Lemma count_less X x y : In y X -> y < x -> (count_below X y < count_below X x)%nat.
Proof.
  unfold count_below. intros I L.
  assert (M : forall l, (length (filter (fun q => Statements.less q y) l) <= length (filter (fun q => Statements.less q x) l))%nat).
  { induction l as [|a l IH]; [cbn; lia|]. cbn [filter].
    destruct (less_cases a y) as [(H & ->)|(H & ->)]; destruct (less_cases a x) as [(H' & ->)|(H' & ->)]; cbn [length]; try lia. lra. }
  induction X as [|a X IH]; [destruct I|]. cbn [filter]. destruct I as [->|I].
  - destruct (less_cases y y) as [(H & _)|(H & ->)]; [lra|]. destruct (less_cases y x) as [(H' & ->)|(H' & _)]; [|lra].
    cbn [length]. specialize (M X). lia.
  - specialize (IH I). destruct (less_cases a y) as [(H & ->)|(H & ->)]; destruct (less_cases a x) as [(H' & ->)|(H' & ->)]; cbn [length]; try lia. lra.
Qed.

(* Two edges do not overlap: they are not parallel, not collinear, or share at most one height. *)
Definition low (e : side) : Q := if Qlt_le_dec (snd (fst e)) (snd (snd e)) then snd (fst e) else snd (snd e).
Definition high (e : side) : Q := if Qlt_le_dec (snd (fst e)) (snd (snd e)) then snd (snd e) else snd (fst e).
Definition distinct (e g : side) : Prop :=
  ~ rise e * run g - rise g * run e == 0 \/ ~ o e (fst g) == 0 \/ high e <= low g \/ high g <= low e.

Section Line.
Variables (sums : list (list side)) (loops fits : list side) (O : Statements.point -> Prop) (level : Z).
Definition L (t : Statements.point) : Prop := Statements.on_any (loops ++ fits) t.
Definition U (t : Statements.point) : Prop := exists S, In S sums /\ inS S t.
Definition wind_sides (es : list side) (t : Statements.point) : Z :=
  fold_right Z.add 0%Z (map (Statements.crossing t) es).

Hypothesis Convex : forall S, In S sums -> convex S.
Hypothesis Sum : forall S t, In S sums -> inS S t -> O t.
Hypothesis Free : forall t, L t -> ~ O t.
Hypothesis Once : forall t, O t -> wind_sides loops t = level.
(* Beyond all loops lies U, or the level is 1, one above that of the complement. *)
Hypothesis Far : level = 1%Z \/ forall t, exists x, fst t <= x /\ U (at_x t x).
Hypothesis Cover : forall S f x, In S sums -> In f S -> o f x == 0 -> (forall g, In g S -> 0 <= o g x) -> U x \/ L x.
Hypothesis Left : forall e x, In e loops -> Statements.on_segment e x ->
  exists S f, In S sums /\ In f S /\ Statements.on_segment f x /\ (0 < rise e -> 0 < rise f) /\ (rise e < 0 -> rise f < 0).
Hypothesis Both : forall e x, In e fits -> ~ rise e == 0 -> Statements.on_segment e x ->
  exists S f, In S sums /\ In f S /\ Statements.on_segment f x /\ 0 < rise f.

Hypothesis Distinct : ForallOrdPairs distinct loops.

Section At.
Variable t : Statements.point.
Hypothesis Generic : forall f, In f (concat sums) \/ In f (loops ++ fits) -> ~ snd (fst f) == snd t /\ ~ snd (snd f) == snd t.
Hypothesis NotU : ~ U t.
Hypothesis NotL : ~ L t.
Hypothesis Single : ForallOrdPairs (fun e g => straddles e (snd t) -> straddles g (snd t) -> ~ root e t == root g t) loops.

Lemma generic_sum S f : In S sums -> In f S -> ~ snd (fst f) == snd t /\ ~ snd (snd f) == snd t.
Proof. intros I J. apply Generic. left. apply in_concat. exists S. auto. Qed.

Lemma some_not S : ~ inS S t -> exists f, In f S /\ o f t <= 0.
Proof.
  intro N. destruct (Exists_dec (fun f => o f t <= 0) S) as [E|E].
  { intro f. destruct (Qlt_le_dec 0 (o f t)); [right; lra|left; assumption]. }
  - rewrite Exists_exists in E. exact E.
  - exfalso. apply N. intros f I. destruct (Qlt_le_dec 0 (o f t)) as [|H]; [assumption|].
    exfalso. apply E. rewrite Exists_exists. exists f. auto.
Qed.

(* From t along the line, no point of U comes before the first point of L. *)
Lemma no_entry : forall n x, (count_below (map (fun f => root f t) (concat sums)) x < n)%nat -> fst t <= x ->
  (forall y, fst t <= y -> y < x -> ~ L (at_x t y)) -> ~ U (at_x t x).
Proof.
  induction n as [|n IH]; intros x Cn Lx NL (S & I & J); [lia|].
  assert (NS : ~ inS S t) by (intro H; apply NotU; exists S; auto).
  destruct (least (fun f => - root f t) (fun f => o f t <= 0)
    (fun f => match Qlt_le_dec 0 (o f t) with left H => right (Qlt_not_le _ _ H) | right H => left H end) S (some_not S NS))
    as (f & F & Of & Max).
  assert (R : forall g, In g S -> o g t <= 0 -> rise g < 0 /\ fst t <= root g t /\ root g t < x).
  { intros g G Og. pose proof (J g G) as Jg. pose proof Jg as Jg'. rewrite o_line in Jg.
    assert (Rg : rise g < 0).
    { destruct (Qlt_le_dec (rise g) 0) as [|N]; [assumption|exfalso].
      assert (0 <= rise g * (x - fst t)) by (apply Qmult_le_0_compat; lra). lra. }
    split; [exact Rg|]. rewrite o_root in Jg' by lra.
    assert (T : at_x t (fst t) = t) by (destruct t; reflexivity).
    pose proof (o_root g t (fst t) ltac:(lra)) as Rt. rewrite T in Rt. rewrite Rt in Og. split.
    - destruct (Qlt_le_dec (root g t) (fst t)) as [N|]; [exfalso|assumption].
      assert (0 < - rise g * (fst t - root g t)) by (apply Qmult_lt_0_compat; lra). lra.
    - destruct (Qlt_le_dec (root g t) x) as [|N]; [assumption|exfalso].
      assert (0 <= - rise g * (root g t - x)) by (apply Qmult_le_0_compat; lra). lra. }
  destruct (R f F Of) as (Rf & R1 & R2). set (y := root f t) in *.
  assert (Cl : forall g, In g S -> 0 <= o g (at_x t y)).
  { intros g G. destruct (Qlt_le_dec 0 (o g t)) as [P|P].
    - pose proof (J g G) as Jg. rewrite o_line in *. destruct (Qlt_le_dec (rise g) 0) as [N|N].
      + assert (0 <= - rise g * (y - fst t)) by (apply Qmult_le_0_compat; lra). lra.
      + assert (0 <= rise g * (x - y)) by (apply Qmult_le_0_compat; lra). lra.
    - destruct (R g G P) as (Rg & _ & _). rewrite o_root by lra. specialize (Max g G P).
      assert (0 <= - rise g * (y - root g t)) by (apply Qmult_le_0_compat; lra). lra. }
  assert (On : o f (at_x t y) == 0) by (rewrite o_root by lra; unfold y; ring).
  destruct (Cover S f (at_x t y) I F On Cl) as [Uy|Ly].
  - revert Uy. apply (IH y); [|exact R1|].
    + assert (count_below (map (fun f => root f t) (concat sums)) y < count_below (map (fun f => root f t) (concat sums)) x)%nat; [|lia].
      apply count_less; [|exact R2]. apply (in_map (fun f => root f t)). apply in_concat. exists S. auto.
    + intros z Z1 Z2. apply NL; lra.
  - exact (NL y R1 R2 Ly).
Qed.

Lemma crossing_cases e u : snd u = snd t -> In e (loops ++ fits) ->
  (Statements.crossing u e = 1%Z /\ 0 < rise e /\ straddles e (snd t) /\ fst u < root e t) \/
  (Statements.crossing u e = (-1)%Z /\ rise e < 0 /\ straddles e (snd t) /\ fst u < root e t) \/
  (Statements.crossing u e = 0%Z /\ (straddles e (snd t) -> root e t <= fst u)).
Proof.
  intros Hu I. destruct (Generic e (or_intror I)) as (N1 & N2). destruct e as [a b]. cbn [fst snd] in *.
  assert (Eu : Statements.orient a b u == rise (a, b) * (root (a, b) t - fst u) \/ rise (a, b) == 0).
  { destruct (Qeq_dec (rise (a, b)) 0) as [Z|Z]; [right; exact Z|left].
    rewrite <- (o_root (a, b) t (fst u) Z). unfold at_x. rewrite <- Hu. unfold o. destruct u; reflexivity. }
  unfold Statements.crossing, straddles. rewrite Hu. unfold rise in *. cbn [fst snd] in *.
  destruct (leb_cases (snd a) (snd t)) as [(A & ->)|(A & ->)]; destruct (less_cases (snd t) (snd b)) as [(B & ->)|(B & ->)];
  destruct (leb_cases (snd b) (snd t)) as [(A' & ->)|(A' & ->)]; destruct (less_cases (snd t) (snd a)) as [(B' & ->)|(B' & ->)];
  try (exfalso; lra); cbn [andb].
  - destruct Eu as [Eu|Eu]; [|exfalso; lra].
    destruct (less_cases 0 (Statements.orient a b u)) as [(C & ->)|(C & ->)]; rewrite Eu in C.
    + left. repeat split; try lra. destruct (Qlt_le_dec (fst u) (root (a, b) t)) as [|N]; [assumption|exfalso].
      assert (0 <= (snd b - snd a) * (fst u - root (a, b) t)) by (apply Qmult_le_0_compat; lra). lra.
    + right; right. split; [reflexivity|]. intros _. destruct (Qlt_le_dec (fst u) (root (a, b) t)) as [N|]; [exfalso|assumption].
      assert (0 < (snd b - snd a) * (root (a, b) t - fst u)) by (apply Qmult_lt_0_compat; lra). lra.
  - right; right. split; [reflexivity|]. lra.
  - right; right. split; [reflexivity|]. lra.
  - destruct Eu as [Eu|Eu]; [|exfalso; lra].
    destruct (less_cases (Statements.orient a b u) 0) as [(C & ->)|(C & ->)]; rewrite Eu in C.
    + right; left. repeat split; try lra. destruct (Qlt_le_dec (fst u) (root (a, b) t)) as [|N]; [assumption|exfalso].
      assert (0 <= - (snd b - snd a) * (fst u - root (a, b) t)) by (apply Qmult_le_0_compat; lra). lra.
    + right; right. split; [reflexivity|]. intros _. destruct (Qlt_le_dec (fst u) (root (a, b) t)) as [N|]; [exfalso|assumption].
      assert (0 < - (snd b - snd a) * (root (a, b) t - fst u)) by (apply Qmult_lt_0_compat; lra). lra.
Qed.

Lemma straddle_rise e : straddles e (snd t) -> ~ rise e == 0.
Proof. unfold straddles, rise. lra. Qed.

Lemma on_root e : straddles e (snd t) -> Statements.on_segment e (at_x t (root e t)).
Proof.
  intro St. pose proof (straddle_rise e St) as N.
  assert (Z : o e (at_x t (root e t)) == 0) by (rewrite o_root by exact N; ring).
  destruct (line_share e _ Z) as (s & X & Y).
  { intros (_ & M). unfold rise in N. lra. }
  exists s. split; [|split; assumption]. unfold at_x in Y. cbn [snd] in Y. unfold straddles, rise in *.
  set (b := snd (snd e) - snd (fst e)) in *. destruct St as [(S1 & S2)|(S1 & S2)].
  - split; [apply (pos_cancel s b); unfold b in *; lra|].
    assert (0 <= 1 - s); [apply (pos_cancel _ b); unfold b in *; lra|lra].
  - split; [apply (pos_cancel s (- b)); unfold b in *; lra|].
    assert (0 <= 1 - s); [apply (pos_cancel _ (- b)); unfold b in *; lra|lra].
Qed.

Lemma on_line e x : In e (loops ++ fits) -> Statements.on_segment e (at_x t x) -> straddles e (snd t) /\ x == root e t.
Proof.
  intros I (s & (S0 & S1) & X & Y). destruct (Generic e (or_intror I)) as (N1 & N2). unfold at_x in X, Y. cbn [fst snd] in X, Y.
  assert (St : straddles e (snd t)).
  { unfold straddles. destruct (Qlt_le_dec (snd (fst e)) (snd (snd e))) as [H|H].
    - assert (0 <= s * (snd (snd e) - snd (fst e))) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - s) * (snd (snd e) - snd (fst e))) by (apply Qmult_le_0_compat; lra). left. lra.
    - assert (0 <= s * (snd (fst e) - snd (snd e))) by (apply Qmult_le_0_compat; lra).
      assert (0 <= (1 - s) * (snd (fst e) - snd (snd e))) by (apply Qmult_le_0_compat; lra). right. lra. }
  split; [exact St|]. pose proof (straddle_rise e St) as N.
  assert (Z : o e (at_x t x) == 0) by (unfold o, at_x, Statements.orient; cbn [fst snd]; rewrite X, Y; ring).
  rewrite o_root in Z by exact N. apply Qmult_integral in Z. destruct Z as [Z|Z]; [contradiction|lra].
Qed.

Lemma wind_zero es u : (forall e, In e es -> Statements.crossing u e = 0%Z) -> wind_sides es u = 0%Z.
Proof.
  intro H. unfold wind_sides. induction es as [|e es IH]; [reflexivity|]. cbn [map fold_right].
  rewrite (H e (or_introl eq_refl)), IH; [reflexivity|]. intros. apply H. right. assumption.
Qed.
Lemma wind_one es u v (P : side -> Prop) :
  (forall e, In e es -> Statements.crossing v e = Statements.crossing u e \/
    Statements.crossing v e = (Statements.crossing u e + 1)%Z /\ P e) ->
  ForallOrdPairs (fun e g => P e -> P g -> False) es ->
  (exists e, In e es /\ Statements.crossing v e = (Statements.crossing u e + 1)%Z) ->
  wind_sides es v = (wind_sides es u + 1)%Z.
Proof.
  unfold wind_sides. induction es as [|a es IH]; intros H A (e & I & E); [destruct I|]. cbn [map fold_right].
  inversion A as [|? ? A1 A2]; subst. rewrite Forall_forall in A1.
  assert (H' : forall e, In e es -> Statements.crossing v e = Statements.crossing u e \/
    Statements.crossing v e = (Statements.crossing u e + 1)%Z /\ P e) by (intros; apply H; right; assumption).
  destruct (H a (or_introl eq_refl)) as [Ha|(Ha & Pa)].
  - destruct I as [<-|I]; [lia|]. rewrite (IH H' A2 ltac:(exists e; auto)), Ha. lia.
  - assert (Rest : map (Statements.crossing v) es = map (Statements.crossing u) es).
    { apply map_ext_in. intros g G. destruct (H' g G) as [|(_ & Pg)]; [assumption|]. destruct (A1 g G Pa Pg). }
    rewrite Rest, Ha. lia.
Qed.

Theorem outside_line : wind_sides loops t = (level - 1)%Z.
Proof.
  set (hit := fun e => Statements.crossing t e <> 0%Z).
  assert (dec : forall e, {hit e} + {~ hit e}).
  { intro e. unfold hit. destruct (Z.eq_dec (Statements.crossing t e) 0); [right|left]; tauto. }
  destruct (Exists_dec hit (loops ++ fits) dec) as [E|E].
  2:{ assert (None : forall e, In e (loops ++ fits) -> Statements.crossing t e = 0%Z).
      { intros e I. destruct (dec e) as [H|H]; [|unfold hit in H; lia].
        exfalso. apply E. rewrite Exists_exists. exists e. split; [exact I|exact H]. }
      destruct Far as [W|F].
      - rewrite wind_zero; [lia|]. intros e I. apply None, in_or_app. left. exact I.
      - exfalso. destruct (F t) as (x & X & Ux). revert Ux.
        apply (no_entry (S (count_below (map (fun f => root f t) (concat sums)) x))); [lia|exact X|].
        intros y Y1 Y2 (g & G & On). destruct (on_line g y G On) as (Sg & Rg).
        destruct (Qeq_dec y (fst t)) as [Z3|Z3].
        + apply NotL. exists g. split; [exact G|]. destruct On as (s & S01 & X1 & X2). exists s. split; [exact S01|].
          unfold at_x in X1, X2. cbn [fst snd] in X1, X2. rewrite Z3 in X1. split; assumption.
        + destruct (crossing_cases g t eq_refl G) as [(A & _)|[(A & _)|(_ & A)]]; try (rewrite (None g G) in A; discriminate).
          specialize (A Sg). lra. }
  rewrite Exists_exists in E. destruct (least (fun e => root e t) hit dec _ E) as (e & I & He & Min). clear E.
  set (x := root e t). set (y := at_x t x).
  assert (Hx : straddles e (snd t) /\ fst t < x).
  { destruct (crossing_cases e t eq_refl I) as [(_ & _ & A & B)|[(_ & _ & A & B)|(A & _)]]; [split; assumption|split; assumption|].
    unfold hit in He. contradiction. }
  destruct Hx as (St & Hx).
  (* every edge that meets the line right of t does so at x or beyond *)
  assert (First : forall g, In g (loops ++ fits) -> straddles g (snd t) -> fst t < root g t -> x <= root g t).
  { intros g G Sg Rg. apply (Min g G). unfold hit.
    destruct (crossing_cases g t eq_refl G) as [(A & _)|[(A & _)|(_ & A)]]; try (rewrite A; discriminate). specialize (A Sg). lra. }
  assert (NL : forall z, fst t <= z -> z < x -> ~ L (at_x t z)).
  { intros z Z1 Z2 (g & G & On). destruct (on_line g z G On) as (Sg & Rg).
    destruct (Qeq_dec z (fst t)) as [Z3|Z3].
    - apply NotL. exists g. split; [exact G|]. destruct On as (s & S01 & X & Y). exists s. split; [exact S01|].
      unfold at_x in X, Y. cbn [fst snd] in X, Y. rewrite Z3 in X. split; assumption.
    - pose proof (First g G Sg ltac:(lra)). lra. }
  assert (NU : forall z, fst t <= z -> z < x -> ~ U (at_x t z)).
  { intros z Z1 Z2. apply (no_entry (S (count_below (map (fun f => root f t) (concat sums)) z))); [lia|exact Z1|].
    intros w W1 W2. apply NL; lra. }
  (* no polygon ends at y: it would meet the line before x *)
  assert (NoLeft : forall S f, In S sums -> In f S -> Statements.on_segment f y -> 0 < rise f -> False).
  { intros S f IS IF On Rf. destruct (generic_sum S f IS IF) as (G1 & G2).
    destruct (enter S y 1) with (r := x - fst t) as (c & C & C' & J).
    - intros g G. destruct (beside S f y (Convex S IS) IF On G1 G2 g G) as [P|(P & Q)]; [left; exact P|right]. split; [exact P|lra].
    - lra.
    - apply (NU (x - 1 * c)); [lra|lra|]. exists S. split; [exact IS|exact J]. }
  assert (Down : forall g, In g (loops ++ fits) -> straddles g (snd t) -> root g t == x ->
    In g loops /\ rise g < 0).
  { intros g G Sg Rg.
    assert (On : Statements.on_segment g y).
    { pose proof (on_root g Sg) as (s & S01 & X & Y). exists s. split; [exact S01|]. unfold y, at_x in *. cbn [fst snd] in *.
      rewrite <- Rg. split; assumption. }
    pose proof (straddle_rise g Sg) as N. apply in_app_or in G. destruct G as [G|G].
    - split; [exact G|]. destruct (Qlt_le_dec (rise g) 0) as [|P]; [assumption|exfalso].
      destruct (Left g y G On) as (S & f & IS & IF & Of & Up & _). apply (NoLeft S f IS IF Of). apply Up. lra.
    - exfalso. destruct (Both g y G N On) as (S & f & IS & IF & Of & Up). exact (NoLeft S f IS IF Of Up). }
  destruct (Down e I St ltac:(reflexivity)) as (Ie & Re).
  destruct (Left e y Ie (on_root e St)) as (S & f & IS & IF & Of & _ & Rf). specialize (Rf Re).
  destruct (generic_sum S f IS IF) as (G1 & G2).
  pose proof (beside S f y (Convex S IS) IF Of G1 G2) as Bs.
  destruct (enter S y (-1)) with (r := 1) as (c & C & _ & J).
  { intros g G. destruct (Bs g G) as [P|(P & Q)]; [left; exact P|right]. split; [exact P|lra]. }
  { lra. }
  set (u := at_x y (fst y - -1 * c)) in *.
  assert (Ut : snd u = snd t) by reflexivity.
  assert (Ux : fst u == x + c) by (unfold u, y, at_x; cbn [fst]; ring).
  pose proof (Once u (Sum S u IS J)) as W1.
  (* no segment of L between x and u *)
  assert (Gap : forall g, In g (loops ++ fits) -> straddles g (snd t) -> x < root g t -> fst u < root g t).
  { intros g G Sg Rg. destruct (Qlt_le_dec (fst u) (root g t)) as [|N]; [assumption|exfalso].
    apply (Free (at_x t (root g t))); [exists g; split; [exact G|apply on_root, Sg]|]. apply (Sum S _ IS).
    intros h H. pose proof (J h H) as Jh. destruct (Bs h H) as [P|(P & Q)].
    - unfold y in P. unfold u in Jh. rewrite o_line in P, Jh |- *. unfold y in Jh. rewrite o_line in Jh. cbn [fst at_x] in Jh.
      destruct (Qlt_le_dec (rise h) 0) as [A|A].
      + assert (0 <= - rise h * (root g t - x)) by (apply Qmult_le_0_compat; lra). lra.
      + rewrite Ux in N. assert (0 <= rise h * (x + c - root g t)) by (apply Qmult_le_0_compat; lra). lra.
    - unfold y in P. rewrite o_line in P |- *. rewrite Q.
      assert (0 < - rise f * (root g t - x)) by (apply Qmult_lt_0_compat; lra). rewrite Q in P. lra. }
  enough (wind_sides loops u = wind_sides loops t + 1)%Z by lia.
  apply (wind_one loops t u (fun g => straddles g (snd t) /\ root g t == x)).
  - intros g G. assert (G' : In g (loops ++ fits)) by (apply in_or_app; left; exact G).
    destruct (crossing_cases g t eq_refl G') as [(A & A1 & A2 & A3)|[(A & A1 & A2 & A3)|(A & A1)]];
    destruct (crossing_cases g u Ut G') as [(B & B1 & B2 & B3)|[(B & B1 & B2 & B3)|(B & B1)]]; rewrite A, B; try (left; reflexivity).
    + exfalso. lra.
    + exfalso. specialize (B1 A2). pose proof (First g G' A2 A3) as F1. destruct (Qlt_le_dec x (root g t)) as [F2|F2].
      * pose proof (Gap g G' A2 F2). lra.
      * destruct (Down g G' A2 ltac:(lra)) as (_ & F3). lra.
    + exfalso. lra.
    + right. split; [reflexivity|]. split; [exact A2|]. specialize (B1 A2). pose proof (First g G' A2 A3) as F1.
      destruct (Qlt_le_dec x (root g t)) as [F2|F2]; [|lra]. pose proof (Gap g G' A2 F2). lra.
    + exfalso. specialize (A1 B2). lra.
    + exfalso. specialize (A1 B2). lra.
  - assert (Weaken : forall l, ForallOrdPairs (fun e g => straddles e (snd t) -> straddles g (snd t) -> ~ root e t == root g t) l ->
      ForallOrdPairs (fun g h => (straddles g (snd t) /\ root g t == x) -> (straddles h (snd t) /\ root h t == x) -> False) l).
    { intros l A. induction A as [|a m A1 A2 IH]; [apply FOP_nil|apply FOP_cons; [|exact IH]].
      rewrite Forall_forall in *. intros g G (P1 & P2) (Q1 & Q2). apply (A1 g G P1 Q1). rewrite P2, Q2. reflexivity. }
    exact (Weaken loops Single).
  - exists e. split; [exact Ie|].
    destruct (crossing_cases e t eq_refl I) as [(A & A1 & A2 & A3)|[(A & A1 & A2 & A3)|(A & A1)]]; [exfalso; lra| |].
    + destruct (crossing_cases e u Ut I) as [(B & B1 & B2 & B3)|[(B & B1 & B2 & B3)|(B & B1)]]; rewrite A, B; [exfalso; lra| |reflexivity].
      exfalso. fold x in B3. lra.
    + unfold hit in He. contradiction.
Qed.
End At.

Lemma wind_ev es z : ev z (fun y => wind_sides es y = wind_sides es z).
Proof.
  assert (E : ev z (fun y => forall e, In e es -> Statements.crossing y e = Statements.crossing z e)).
  { apply ev_all. intros e _. destruct (crossing_wedge z e) as (d & D & H). exists d. split; [exact D|exact H]. }
  revert E. apply ev_weaken. intros y. unfold wind_sides. induction es as [|e es IH]; intro H; [reflexivity|].
  cbn [map fold_right]. rewrite (H e (or_introl eq_refl)), IH; [reflexivity|]. intros. apply H. right. assumption.
Qed.

(* Distinct edges meet the horizontal line just above z in distinct points. *)
Lemma distinct_ev z e g : distinct e g ->
  ev z (fun y => straddles e (snd y) -> straddles g (snd y) -> ~ root e y == root g y).
Proof.
  intro H. set (k := rise e * run g - rise g * run e) in *.
  assert (Eq : forall y, straddles e (snd y) -> straddles g (snd y) -> root e y == root g y ->
    o e (at_x y (root e y)) == 0 /\ o g (at_x y (root e y)) == 0).
  { intros y Se Sg R. assert (Ne : ~ rise e == 0) by (unfold straddles, rise in *; lra).
    assert (Ng : ~ rise g == 0) by (unfold straddles, rise in *; lra). split.
    - rewrite o_root by exact Ne. ring.
    - rewrite o_root by exact Ng. rewrite R. ring. }
  assert (Form : forall f y, o f y == o f (0, 0) + run f * snd y - rise f * fst y)
    by (intros f y; rewrite (o_move f (0, 0) y); cbn [fst snd]; ring).
  destruct (Qeq_dec k 0) as [K|K].
  - exists 1. split; [lra|]. intros y _ Se Sg R. destruct (Eq y Se Sg R) as (E1 & E2).
    destruct H as [H|[H|H]]; [contradiction| |].
    + apply H. assert (Ng : ~ rise g == 0) by (unfold straddles, rise in *; lra).
      set (p := at_x y (root e y)) in *.
      assert (G0 : o g (fst g) == 0) by (unfold o, Statements.orient; ring).
      rewrite (o_move e p (fst g)), E1. rewrite (o_move g p (fst g)), E2 in G0.
      apply (Qmult_inj_l _ _ (rise g)); [exact Ng|].
      assert (M : rise g * (0 + run e * (snd (fst g) - snd p) - rise e * (fst (fst g) - fst p)) ==
        rise e * (0 + run g * (snd (fst g) - snd p) - rise g * (fst (fst g) - fst p)) - k * (snd (fst g) - snd p))
        by (unfold k; ring).
      rewrite M, G0, K. ring.
    + unfold straddles, high, low in *.
      destruct (Qlt_le_dec (snd (fst e)) (snd (snd e))), (Qlt_le_dec (snd (fst g)) (snd (snd g))); lra.
  - generalize (ev_height z ((rise g * o e (0, 0) - rise e * o g (0, 0)) / k)). apply ev_weaken.
    intros y Y Se Sg R. apply Y. destruct (Eq y Se Sg R) as (E1 & E2).
    set (p := at_x y (root e y)) in *. rewrite Form in E1, E2. change (snd p) with (snd y) in *.
    apply (Qmult_inj_l _ _ k); [exact K|].
    assert (M : k * ((rise g * o e (0, 0) - rise e * o g (0, 0)) / k) == rise g * o e (0, 0) - rise e * o g (0, 0)) by (field; exact K).
    rewrite M.
    assert (X : rise g * (o e (0, 0) + run e * snd y - rise e * fst p) - rise e * (o g (0, 0) + run g * snd y - rise g * fst p) ==
      rise g * o e (0, 0) - rise e * o g (0, 0) - k * snd y) by (unfold k; ring).
    rewrite E1, E2 in X. lra.
Qed.

Lemma distinct_all z l : ForallOrdPairs distinct l ->
  ev z (fun y => ForallOrdPairs (fun e g => straddles e (snd y) -> straddles g (snd y) -> ~ root e y == root g y) l).
Proof.
  induction 1 as [|e l H A IH]; [exists 1; split; [lra|intros; constructor]|]. rewrite Forall_forall in H.
  assert (E : ev z (fun y => forall g, In g l -> straddles e (snd y) -> straddles g (snd y) -> ~ root e y == root g y)).
  { apply ev_all. intros g G. apply distinct_ev, H, G. }
  generalize (ev_and _ _ _ E IH). apply ev_weaken. intros y (Y1 & Y2). constructor; [rewrite Forall_forall; exact Y1|exact Y2].
Qed.

(* Outside U and L the winding number is one below the level of O. *)
Theorem outside_all t : ~ U t -> ~ L t -> wind_sides loops t = (level - 1)%Z.
Proof.
  intros NU NL.
  assert (E1 : ev t (fun y => forall S, In S sums -> ~ inS S y)).
  { apply ev_all. intros S I.
    assert (X : exists f, In f S /\ o f t < 0).
    { destruct (Exists_dec (fun f => o f t < 0) S) as [E|E].
      { intro f. destruct (Qlt_le_dec (o f t) 0); [left; assumption|right; lra]. }
      - rewrite Exists_exists in E. exact E.
      - exfalso. assert (A : forall g, In g S -> 0 <= o g t).
        { intros g G. destruct (Qlt_le_dec (o g t) 0) as [H|]; [exfalso|assumption]. apply E. rewrite Exists_exists. exists g. auto. }
        destruct (some_not t S) as (f & F & Of). { intro H. apply NU. exists S. auto. }
        assert (Z : o f t == 0) by (specialize (A f F); lra).
        destruct (Cover S f t I F Z A); contradiction. }
    destruct X as (f & F & Of).
    assert (Form : forall y, o f y == rise f * -1 * fst y + run f * snd y + o f (0, 0))
      by (intro y; rewrite (o_move f (0, 0) y); cbn [fst snd]; ring).
    assert (H : 0 < rise f * fst t + - run f * snd t + - o f (0, 0)) by (rewrite Form in Of; lra).
    apply ev_affine in H. revert H. apply ev_weaken. intros y Y J. specialize (J f F). rewrite Form in J. lra. }
  assert (E2 : ev t (fun y => forall e, In e (loops ++ fits) -> ~ Statements.on_segment e y)).
  { apply ev_all. intros e I. apply ev_off. intro On. apply NL. exists e. auto. }
  assert (E3 : ev t (fun y => forall f, In f (concat sums ++ (loops ++ fits)) -> ~ snd (fst f) == snd y /\ ~ snd (snd f) == snd y)).
  { apply ev_all. intros f _. apply ev_and; apply ev_height. }
  destruct (ev_point _ _ (ev_and _ _ _ (ev_and _ _ _ E1 E2) (ev_and _ _ _ E3 (ev_and _ _ _ (wind_ev loops t) (distinct_all t loops Distinct)))))
    as (y & (A & B) & C & D & E).
  rewrite <- D. apply outside_line.
  - intros f F. apply C, in_or_app. exact F.
  - intros (S & I & J). exact (A S I J).
  - intros (e & I & On). exact (B e I On).
  - exact E.
Qed.

Lemma inS_dec S t : {inS S t} + {~ inS S t}.
Proof.
  destruct (Forall_dec (fun f => 0 < o f t) (fun f => match Qlt_le_dec 0 (o f t) with left H => left H | right H => right (Qle_not_lt _ _ H) end) S) as [F|F].
  - left. intros f I. rewrite Forall_forall in F. exact (F f I).
  - right. intro J. apply F. rewrite Forall_forall. exact J.
Qed.
Lemma U_dec t : U t \/ ~ U t.
Proof.
  unfold U. destruct (Exists_dec (fun S => inS S t) sums (fun S => inS_dec S t)) as [E|E];
  rewrite Exists_exists in E; [left|right]; exact E.
Qed.

(* Off L, the winding number equals this level on O and is one lower elsewhere. *)
Theorem core t : ~ L t -> (O t /\ wind_sides loops t = level) \/ (~ O t /\ wind_sides loops t = (level - 1)%Z).
Proof.
  intros NL. destruct (U_dec t) as [(S & I & J)|N].
  - left. split; [exact (Sum S t I J)|apply Once, (Sum S t I J)].
  - right. pose proof (outside_all t N NL) as W. split; [|exact W]. intro Ot. pose proof (Once t Ot). lia.
Qed.

(* L is the boundary of O if each polygon has an interior point and each point of L is on a side. *)
Hypothesis Inner : forall S, In S sums -> exists c, inS S c.
Hypothesis Touch : forall e x, In e (loops ++ fits) -> Statements.on_segment e x ->
  exists S f, In S sums /\ In f S /\ Statements.on_segment f x.

Lemma in_closure_of_side S f x : In S sums -> In f S -> Statements.on_segment f x -> Statements.closure O x.
Proof.
  intros IS IF (s & (S0 & S1) & X & Y) e E. destruct (Inner S IS) as (c & Hc).
  assert (Cl : forall g, In g S -> 0 <= o g x).
  { intros g G. destruct (Convex S IS f g IF G) as (H1 & H2 & _). rewrite (o_share g _ _ s x X Y).
    assert (0 <= (1 - s) * o g (fst f)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= s * o g (snd f)) by (apply Qmult_le_0_compat; lra). lra. }
  set (u := fst c - fst x). set (v := snd c - snd x). set (m := u * u + v * v + 1).
  assert (U2 : 0 <= u * u) by nra. assert (V2 : 0 <= v * v) by nra. assert (M : 0 < m) by (unfold m; lra).
  assert (Um : - m <= u <= m) by (pose proof (abs_bound u); unfold m; lra).
  assert (Vm : - m <= v <= m) by (pose proof (abs_bound v); unfold m; lra).
  assert (P : 0 < e / (2 * m)) by (apply Qlt_shift_div_l; lra).
  destruct (below 1 (e / (2 * m))) as (d & D & D1 & D2); [lra|exact P|].
  assert (D3 : 2 * m * d <= e).
  { pose proof (mono_le (2 * m) d _ ltac:(lra) D2). assert (2 * m * (e / (2 * m)) == e) by (field; lra). lra. }
  exists (fst x + d * u, snd x + d * v). split.
  - apply (Sum S _ IS). intros g G. rewrite (o_share g x c d).
    + pose proof (Cl g G). pose proof (Hc g G).
      assert (0 <= (1 - d) * o g x) by (apply Qmult_le_0_compat; lra).
      assert (0 < d * o g c) by (apply Qmult_lt_0_compat; assumption). lra.
    + unfold u. cbn [fst snd]. ring.
    + unfold v. cbn [fst snd]. ring.
  - pose proof (prod_bound u m d Um ltac:(lra)) as Bu. pose proof (prod_bound v m d Vm ltac:(lra)) as Bv.
    assert (md : 0 < m * d) by (apply Qmult_lt_0_compat; assumption).
    assert (E1 : fst x + d * u - fst x == u * d) by ring. assert (E2 : snd x + d * v - snd x == v * d) by ring.
    unfold Statements.close. cbn [fst snd]. rewrite E1, E2. repeat split; lra.
Qed.

Lemma near_affine a b c z : 0 < a * fst z + b * snd z + c ->
  exists e, 0 < e /\ forall y, Statements.close e y z -> 0 < a * fst y + b * snd y + c.
Proof.
  intro H. set (q := a * fst z + b * snd z + c) in *. set (m := a * a + b * b + 1).
  assert (A2 : 0 <= a * a) by nra. assert (B2 : 0 <= b * b) by nra. assert (M : 0 < m) by (unfold m; lra).
  assert (Am : - m <= a <= m) by (pose proof (abs_bound a); unfold m; lra).
  assert (Bm : - m <= b <= m) by (pose proof (abs_bound b); unfold m; lra).
  assert (P : 0 < q / (2 * m)) by (apply Qlt_shift_div_l; lra).
  exists (q / (2 * m)). split; [exact P|]. set (e := q / (2 * m)) in *.
  assert (E : 2 * m * e == q) by (unfold e; field; lra).
  intros y (X & Y). set (s := fst y - fst z) in *. set (t := snd y - snd z) in *.
  assert (Bound : forall k r, - m <= k <= m -> - e < r < e -> - (m * e) < k * r \/ 0 <= k * r).
  { intros k r K R. destruct (Qlt_le_dec 0 r) as [R0|R0].
    - pose proof (prod_bound k m r K ltac:(lra)). pose proof (mono_lt m r e M ltac:(lra)). left. lra.
    - pose proof (prod_bound k m (- r) K ltac:(lra)). pose proof (mono_lt m (- r) e M ltac:(lra)).
      assert (k * - r == - (k * r)) by ring. left. lra. }
  assert (me : 0 < m * e) by (apply Qmult_lt_0_compat; assumption).
  assert (F : a * fst y + b * snd y + c == q + a * s + b * t) by (unfold q, s, t; ring). rewrite F.
  destruct (Bound a s Am X), (Bound b t Bm Y); lra.
Qed.

Lemma outside_open t : ~ U t -> ~ L t -> exists e, 0 < e /\ forall y, Statements.close e y t -> ~ U y.
Proof.
  intros NU NL.
  assert (Each : forall S, In S sums -> exists f, In f S /\ o f t < 0).
  { intros S I. destruct (Exists_dec (fun f => o f t < 0) S) as [E|E].
    { intro f. destruct (Qlt_le_dec (o f t) 0); [left; assumption|right; lra]. }
    - rewrite Exists_exists in E. exact E.
    - exfalso. assert (A : forall g, In g S -> 0 <= o g t).
      { intros g G. destruct (Qlt_le_dec (o g t) 0) as [H|]; [exfalso|assumption]. apply E. rewrite Exists_exists. exists g. auto. }
      destruct (some_not t S) as (f & F & Of). { intro H. apply NU. exists S. auto. }
      assert (Z : o f t == 0) by (specialize (A f F); lra).
      destruct (Cover S f t I F Z A); contradiction. }
  assert (All : forall l, (forall S, In S l -> In S sums) -> exists e, 0 < e /\ forall y, Statements.close e y t -> forall S, In S l -> ~ inS S y).
  { induction l as [|S l IH]; intro Sub; [exists 1; split; [lra|intros y _ S []]|].
    destruct IH as (e & E & He); [intros; apply Sub; right; assumption|].
    destruct (Each S (Sub S (or_introl eq_refl))) as (f & F & Of).
    assert (Form : forall y, o f y == - rise f * fst y + run f * snd y + o f (0, 0))
      by (intro y; rewrite (o_move f (0, 0) y); cbn [fst snd]; ring).
    destruct (near_affine (rise f) (- run f) (- o f (0, 0)) t) as (e' & E' & He'); [rewrite Form in Of; lra|].
    destruct (below e e' E E') as (d & D & D1 & D2). exists d. split; [exact D|].
    intros y (Y1 & Y2) S' [<-|I'].
    - intro J. specialize (J f F). rewrite Form in J.
      assert (Statements.close e' y t) by (unfold Statements.close; lra). specialize (He' y H). lra.
    - apply He; [unfold Statements.close; lra|exact I']. }
  destruct (All sums ltac:(auto)) as (e & E & He). exists e. split; [exact E|]. intros y Y (S & I & J). exact (He y Y S I J).
Qed.


Theorem boundary : (forall t, {L t} + {~ L t}) -> forall t, L t <-> (Statements.closure O t /\ ~ O t).
Proof.
  intros Dec t. split.
  - intro Lt. split; [|exact (Free t Lt)]. destruct Lt as (e & I & On).
    destruct (Touch e t I On) as (S & f & IS & IF & Of). exact (in_closure_of_side S f t IS IF Of).
  - intros (C & N). destruct (Dec t) as [|NL]; [assumption|exfalso].
    assert (NU : ~ U t) by (intros (S & I & J); exact (N (Sum S t I J))).
    destruct (outside_open t NU NL) as (e & E & He). destruct (C e E) as (y & Oy & Cy).
    apply (He y Cy). destruct (U_dec y) as [|NUy]; [assumption|exfalso].
    assert (NLy : ~ L y) by (intro Ly; exact (Free y Ly Oy)).
    pose proof (outside_all y NUy NLy). pose proof (Once y Oy). lia.
Qed.
End Line.
