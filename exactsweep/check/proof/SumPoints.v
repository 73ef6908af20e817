(* Open convex sums: at a translation strictly inside a sum polygon the two pieces overlap. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary.
Import ListNotations.
Open Scope Q_scope.

Lemma square (a : Q) : 0 <= a * a.
Proof. nra. Qed.

Notation qpoint := Statements.point.

(* A point strictly left of all sides of a polygon is in a closed triangle of the fan of the polygon. *)
Fixpoint qback (p q : qpoint) (l : list qpoint) : list side :=
  match l with [] => [(q, p)] | r :: m => (q, r) :: qback p r m end.
Lemma qedges p q l : Statements.edges (p :: q :: l) = (p, q) :: qback p q l.
Proof.
  cbn. f_equal. revert q. induction l as [|r m IH]; intro q; [reflexivity|]. cbn. f_equal. apply IH.
Qed.

Lemma o_sym a b z : o (b, a) z == - o (a, b) z.
Proof. unfold o, Statements.orient. cbn [fst snd]. ring. Qed.

Lemma fan_find p z l : forall q, 0 <= o (p, q) z -> (forall f, In f (qback p q l) -> 0 < o f z) ->
  exists a b, In a (q :: l) /\ In b (q :: l) /\ 0 <= o (p, a) z /\ 0 < o (a, b) z /\ 0 < o (b, p) z.
Proof.
  induction l as [|r m IH]; intros q Q H.
  - exfalso. specialize (H (q, p) (or_introl eq_refl)). rewrite o_sym in H. lra.
  - destruct (Qlt_le_dec (o (p, r) z) 0) as [N|N].
    + exists q, r. repeat split; [left; reflexivity|right; left; reflexivity|exact Q|apply H; left; reflexivity|].
      rewrite o_sym. lra.
    + destruct (IH r N (fun f I => H f (or_intror I))) as (a & b & A & B & C).
      exists a, b. split; [right; exact A|]. split; [right; exact B|exact C].
Qed.

Lemma find_triangle S z : inS (Statements.edges S) z -> S <> [] -> exists p a b, In p S /\ In a S /\ In b S /\
  0 <= o (p, a) z /\ 0 < o (a, b) z /\ 0 < o (b, p) z.
Proof.
  destruct S as [|p [|q l]]; intros H N; [contradiction| |].
  - exfalso. specialize (H (p, p) (or_introl eq_refl)). unfold o, Statements.orient in H. cbn [fst snd] in H. lra.
  - rewrite qedges in H. destruct (fan_find p z l q) as (a & b & A & B & C).
    + pose proof (H (p, q) (or_introl eq_refl)). lra.
    + intros f I. apply H. right. exact I.
    + exists p, a, b. split; [left; reflexivity|]. split; [right; exact A|]. split; [right; exact B|exact C].
Qed.

Lemma o_total p a b z : o (a, b) z + o (b, p) z + o (p, a) z == o (p, a) b.
Proof. unfold o, Statements.orient. cbn [fst snd]. ring. Qed.

(* Weighted means *)
Definition mean (u v w : Q) (p a b : qpoint) : qpoint :=
  ((u * fst p + v * fst a + w * fst b) / (u + v + w), (u * snd p + v * snd a + w * snd b) / (u + v + w)).
Lemma o_mean f u v w p a b : 0 < u + v + w -> o f (mean u v w p a b) == (u * o f p + v * o f a + w * o f b) / (u + v + w).
Proof. intro H. unfold o, Statements.orient, mean. cbn [fst snd]. field. lra. Qed.
Lemma mean_self p a b z : 0 < o (p, a) b ->
  fst z == fst (mean (o (a, b) z) (o (b, p) z) (o (p, a) z) p a b) /\
  snd z == snd (mean (o (a, b) z) (o (b, p) z) (o (p, a) z) p a b).
Proof.
  intro H. pose proof (o_total p a b z) as T.
  assert (N : ~ o (a, b) z + o (b, p) z + o (p, a) z == 0) by (rewrite T; lra).
  unfold mean. cbn [fst snd]. split.
  - apply (Qmult_inj_r _ _ (o (a, b) z + o (b, p) z + o (p, a) z)); [exact N|].
    unfold o, Statements.orient in *. cbn [fst snd] in *. field. exact N.
  - apply (Qmult_inj_r _ _ (o (a, b) z + o (b, p) z + o (p, a) z)); [exact N|].
    unfold o, Statements.orient in *. cbn [fst snd] in *. field. exact N.
Qed.

(* A point between y and c, close to y *)
Definition mix (e : Q) (y c : qpoint) : qpoint := ((fst y + e * fst c) / (1 + e), (snd y + e * snd c) / (1 + e)).
Lemma o_mix f e y c : 0 < e -> o f (mix e y c) == (o f y + e * o f c) / (1 + e).
Proof. intro H. unfold o, Statements.orient, mix. cbn [fst snd]. field. lra. Qed.

(* A convex polygon: no vertex to the right of a side *)
Definition left_all (P : list qpoint) : Prop := forall f v, In f (Statements.edges P) -> In v P -> 0 <= o f v.

Lemma mix_strict P u v w p a b c e : left_all P -> In p P -> In a P -> In b P -> inS (Statements.edges P) c ->
  0 <= u -> 0 <= v -> 0 <= w -> 0 < u + v + w -> 0 < e ->
  inS (Statements.edges P) (mix e (mean u v w p a b) c).
Proof.
  intros L Pp Pa Pb C U V W T E f I. rewrite o_mix by exact E. apply Qlt_shift_div_l; [lra|]. rewrite Qmult_0_l.
  rewrite o_mean by exact T. pose proof (L f p I Pp). pose proof (L f a I Pa). pose proof (L f b I Pb).
  pose proof (C f I). assert (0 < e * o f c) by (apply Qmult_lt_0_compat; assumption).
  assert (0 <= (u * o f p + v * o f a + w * o f b) / (u + v + w)); [|lra].
  apply Qle_shift_div_l; [exact T|].
  assert (0 <= u * o f p) by (apply Qmult_le_0_compat; assumption).
  assert (0 <= v * o f a) by (apply Qmult_le_0_compat; assumption).
  assert (0 <= w * o f b) by (apply Qmult_le_0_compat; assumption). lra.
Qed.

(* A point slightly farther from c than t is still inside. *)
Definition away (e : Q) (t c : qpoint) : qpoint := (fst t + e * (fst t - fst c), snd t + e * (snd t - snd c)).
Lemma away_all es t c : inS es t -> exists e, 0 < e /\ forall d, 0 < d -> d <= e -> inS es (away d t c).
Proof.
  intro H. induction es as [|f es IH]; [exists 1; split; [lra|intros d _ _ g []]|].
  destruct IH as (e & E & X); [intros g G; apply H; right; exact G|].
  pose proof (H f (or_introl eq_refl)) as F.
  set (m := (o f t - o f c) * (o f t - o f c) + 1). pose proof (abs_bound (o f t - o f c)) as B. fold m in B.
  assert (M : 0 < m) by (pose proof (square (o f t - o f c)); unfold m; lra). assert (P : 0 < o f t / (2 * m)) by (apply Qlt_shift_div_l; lra).
  destruct (below e (o f t / (2 * m)) E P) as (r & R & R1 & R2). exists r. split; [exact R|].
  intros d D D' g [<-|G]; [|apply (X d D); [lra|exact G]].
  assert (Form : o f (away d t c) == o f t + (o f t - o f c) * d)
    by (unfold o, Statements.orient, away; cbn [fst snd]; ring).
  rewrite Form. pose proof (prod_bound (o f t - o f c) m d B ltac:(lra)).
  pose proof (mono_le (2 * m) d (o f t / (2 * m)) ltac:(lra) ltac:(lra)).
  assert (2 * m * (o f t / (2 * m)) == o f t) by (field; lra). lra.
Qed.
Lemma away_inside es t c : inS es t -> exists e, 0 < e /\ inS es (away e t c).
Proof. intro H. destruct (away_all es t c H) as (e & E & X). exists e. split; [exact E|]. apply X; lra. Qed.

(* The sum polygon has vertices d - g; at a translation strictly inside it the two pieces overlap. *)
Definition corner (x : qpoint * qpoint) : qpoint := (fst (fst x) - fst (snd x), snd (fst x) - snd (snd x)).

Theorem sum_overlaps P G pairs cP cG t : left_all P -> left_all G ->
  inS (Statements.edges P) cP -> inS (Statements.edges G) cG ->
  (forall x, In x pairs -> In (fst x) P /\ In (snd x) G) ->
  inS (Statements.edges (map corner pairs)) t -> pairs <> [] ->
  exists z w, inS (Statements.edges P) z /\ inS (Statements.edges G) w /\
    fst z == fst w + fst t /\ snd z == snd w + snd t.
Proof.
  intros LP LG CP CG In_ I N. set (c := corner (cP, cG)).
  destruct (away_inside _ t c I) as (e & E & J). set (t' := away e t c) in *.
  destruct (find_triangle _ t' J) as (p & a & b & Ip & Ia & Ib & H1 & H2 & H3).
  { destruct pairs; [contradiction|discriminate]. }
  apply in_map_iff in Ip as (xp & <- & Ip). apply in_map_iff in Ia as (xa & <- & Ia). apply in_map_iff in Ib as (xb & <- & Ib).
  destruct (In_ xp Ip) as (Pp & Gp). destruct (In_ xa Ia) as (Pa & Ga). destruct (In_ xb Ib) as (Pb & Gb).
  pose proof (o_total (corner xp) (corner xa) (corner xb) t') as T.
  destruct (mean_self (corner xp) (corner xa) (corner xb) t') as (X & Y); [lra|].
  revert X Y H1 H2 H3 T. generalize (o (corner xp, corner xa) t') (o (corner xa, corner xb) t') (o (corner xb, corner xp) t')
    (o (corner xp, corner xa) (corner xb)). intros w u v s X Y H1 H2 H3 T.
  exists (mix e (mean u v w (fst xp) (fst xa) (fst xb)) cP), (mix e (mean u v w (snd xp) (snd xa) (snd xb)) cG).
  split; [apply mix_strict; try assumption; lra|]. split; [apply mix_strict; try assumption; lra|].
  unfold mix, mean, corner, t', away, c in *. cbn [fst snd] in *.
  assert (D : 0 < u + v + w) by lra. assert (D' : 0 < 1 + e) by lra.
  split.
  - assert (Z : fst t == ((u * (fst (fst xp) - fst (snd xp)) + v * (fst (fst xa) - fst (snd xa)) +
      w * (fst (fst xb) - fst (snd xb))) / (u + v + w) + e * (fst cP - fst cG)) / (1 + e)).
    { rewrite <- X. unfold corner. cbn [fst snd]. field. lra. }
    rewrite Z. field. lra.
  - assert (Z : snd t == ((u * (snd (fst xp) - snd (snd xp)) + v * (snd (fst xa) - snd (snd xa)) +
      w * (snd (fst xb) - snd (snd xb))) / (u + v + w) + e * (snd cP - snd cG)) / (1 + e)).
    { rewrite <- Y. unfold corner. cbn [fst snd]. field. lra. }
    rewrite Z. field. lra.
Qed.
