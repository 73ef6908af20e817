(* Intervals of a segment: in an open polygon (`clip`), on another segment (`share`), and whether they cover it
   (`covers`). The parameter s, from 0 to 1, is the point a + s (b - a) of the segment from a to b. Vertices are
   integers, to be divided by a common denominator N. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers.
Import ListNotations.
Open Scope Q_scope.

(* 1. The functions of the checker *)

(* Start, end, and whether the interval is closed *)
Definition span := (Q * Q * bool)%type.

Definition before (x y : span) : bool :=
  let '(a, _, c) := x in let '(a', _, c') := y in
  Statements.less a a' || (Qeq_bool a a' && (c || negb c')).
Fixpoint insert (x : span) (l : list span) : list span :=
  match l with [] => [x] | y :: r => if before x y then x :: l else y :: insert x r end.

(* All parameters below `reach` are covered, and `reach` itself if `shut`. *)
Fixpoint covers_from (reach : Q) (shut : bool) (l : list span) : bool :=
  match l with
  | [] => Statements.less 1 reach || (Qeq_bool 1 reach && shut)
  | (a, b, closed) :: r =>
      if Statements.less a reach || (Qeq_bool a reach && (closed || shut)) then
        if Statements.less reach b then covers_from b closed r
        else if Qeq_bool reach b then covers_from reach (shut || closed) r
        else covers_from reach shut r
      else covers_from reach shut r
  end.
Definition covers (l : list span) : bool := covers_from 0 false (fold_right insert [] l).

(* The parameters at which the segment from a to b is strictly left of all edges; -1 or 2 beyond an end *)
Fixpoint clip_from (low high : Q) (lines : list edge) (a b : pt) : option (Q * Q) :=
  match lines with
  | [] => if Statements.less low high then Some (low, high) else None
  | (p, q) :: r =>
      let at_a := det p q a in let at_b := det p q b in
      if (at_a <=? 0)%Z then
        if (at_b <=? 0)%Z then None
        else let s := (- at_a # Z.to_pos (at_b - at_a)) in
          clip_from (if Qle_bool low s then s else low) high r a b
      else if (at_b <=? 0)%Z then
        let s := (at_a # Z.to_pos (at_a - at_b)) in
          clip_from low (if Qle_bool s high then s else high) r a b
      else clip_from low high r a b
  end.
Definition clip (lines : list edge) (a b : pt) : option (Q * Q) := clip_from (-1 # 1) (2 # 1) lines a b.

Definition ratio (a b : Z) : Q := if (0 <? b)%Z then a # Z.to_pos b else (- a) # Z.to_pos (- b).

(* The parameters at which the first segment is on the second one *)
Definition share (one other : edge) : option (Q * Q) :=
  let (a, b) := one in let (p, q) := other in
  let at_p := det a b p in let at_q := det a b q in
  if ((at_p =? 0) && (at_q =? 0))%Z then
    let k := if (fst a =? fst b)%Z then snd else fst in
    let s := ratio (k p - k a) (k b - k a) in let t := ratio (k q - k a) (k b - k a) in
    let (s, t) := if Qle_bool s t then (s, t) else (t, s) in
    if Qle_bool s 1 && Qle_bool 0 t then Some (s, t) else None
  else
    let at_a := det p q a in let at_b := det p q b in
    if ((at_p * at_q <=? 0) && (at_a * at_b <=? 0) && negb (at_a =? at_b))%Z
    then let s := ratio at_a (at_a - at_b) in Some (s, s) else None.

(* 2. Properties *)

Definition in_span (s : Q) (x : span) : Prop :=
  let '(a, b, closed) := x in if closed then a <= s <= b else a < s < b.

Lemma insert_in x y l : In y (insert x l) -> y = x \/ In y l.
Proof.
  induction l as [|z r IH]; cbn [insert]; [intros [->|[]]; auto|].
  destruct (before x z); [intros [->|I]; auto|]. intros [->|I]; [right; left; reflexivity|].
  destruct (IH I); [left|right; right]; assumption.
Qed.
Lemma sort_in y l : In y (fold_right insert [] l) -> In y l.
Proof.
  induction l as [|x r IH]; [intros []|]. cbn [fold_right]. intro I. apply insert_in in I as [->|I]; [left; reflexivity|right; auto].
Qed.

Lemma covers_from_spec (P : Q -> Prop) l : (forall s x, In x l -> in_span s x -> P s) ->
  forall reach shut, covers_from reach shut l = true ->
  (forall s, 0 <= s -> s < reach -> P s) -> (shut = true -> forall s, s == reach -> P s) ->
  forall s, 0 <= s <= 1 -> P s.
Proof.
  induction l as [|((a, b), c) r IH]; intros Q reach shut C B E s S; cbn [covers_from] in C.
  - apply orb_prop in C as [C|C].
    + apply less_true in C. apply B; lra.
    + apply andb_prop in C as (C & Sh). apply Qeq_bool_iff in C.
      destruct (Qlt_le_dec s reach) as [L|L]; [apply B; lra|]. apply (E Sh). lra.
  - assert (Q' : forall s x, In x r -> in_span s x -> P s) by (intros s' x I; apply (Q s' x); right; exact I).
    pose proof (fun s => Q s (a, b, c) (or_introl eq_refl)) as Qa. cbn [in_span] in Qa.
    destruct (Statements.less a reach || (Qeq_bool a reach && (c || shut))) eqn:C0; [|exact (IH Q' reach shut C B E s S)].
    assert (A : a <= reach) by (apply orb_prop in C0 as [C0|C0]; [apply less_true in C0; lra|apply andb_prop in C0 as (C0 & _); apply Qeq_bool_iff in C0; lra]).
    destruct (less_cases reach b) as [(L & X)|(L & X)]; rewrite X in C.
    + apply (IH Q' b c C); [|intros -> t T; apply Qa; lra|exact S].
      intros t T0 T1. destruct (Qlt_le_dec t reach) as [L1|L1]; [apply B; assumption|].
      apply orb_prop in C0 as [C0|C0].
      * apply less_true in C0. apply Qa. destruct c; lra.
      * apply andb_prop in C0 as (C0 & C1). apply Qeq_bool_iff in C0.
        destruct (Qlt_le_dec a t) as [L2|L2]; [apply Qa; destruct c; lra|].
        apply orb_prop in C1 as [-> | ->]; [apply Qa; lra|apply (E eq_refl); lra].
    + destruct (Qeq_bool reach b) eqn:Y.
      * apply Qeq_bool_iff in Y. apply (IH Q' reach (shut || c) C); [exact B| |exact S].
        intros H t T. apply orb_prop in H as [H|H]; [exact (E H t T)|]. subst c. apply Qa. lra.
      * exact (IH Q' reach shut C B E s S).
Qed.
Theorem covers_spec l s : covers l = true -> 0 <= s <= 1 -> exists x, In x l /\ in_span s x.
Proof.
  intros C S. apply (covers_from_spec (fun s => exists x, In x l /\ in_span s x) (fold_right insert [] l)) with (reach := 0) (shut := false).
  - intros t x I X. exists x. split; [apply sort_in, I|exact X].
  - exact C.
  - intros t T0 T1. lra.
  - discriminate.
  - exact S.
Qed.

Lemma ratio_spec a b : b <> 0%Z -> ratio a b * inject_Z b == inject_Z a.
Proof.
  intro B. unfold ratio, Qeq, Qmult, inject_Z. destruct (Z.ltb_spec 0 b); cbn [Qnum Qden]; rewrite Pos.mul_1_r, !Z2Pos.id by lia; ring.
Qed.
Lemma pos_ratio a b : (0 < b)%Z -> (a # Z.to_pos b) * inject_Z b == inject_Z a.
Proof.
  intro B. pose proof (ratio_spec a b ltac:(lia)) as R. unfold ratio in R. destruct (Z.ltb_spec 0 b); [exact R|lia].
Qed.

Lemma clip_spec lines a b : forall low high s t, clip_from low high lines a b = Some (s, t) -> low <= s /\ t <= high /\
  forall u, s < u < t -> 0 <= u <= 1 -> forall f, In f lines ->
  0 < (1 - u) * inject_Z (det (fst f) (snd f) a) + u * inject_Z (det (fst f) (snd f) b).
Proof.
  induction lines as [|(p, q) r IH]; intros low high s t C; cbn [clip_from] in C.
  - destruct (Statements.less low high); [|discriminate]. injection C as <- <-. split; [lra|]. split; [lra|]. intros u _ _ f [].
  - destruct (Z.leb_spec (det p q a) 0) as [A|A]; destruct (Z.leb_spec (det p q b) 0) as [B|B]; try discriminate.
    + set (x := (- det p q a # Z.to_pos (det p q b - det p q a))) in *. destruct (IH _ _ _ _ C) as (L & H & F).
      assert (L' : low <= s /\ x <= s) by (destruct (leb_cases low x) as [(Y & X)|(Y & X)]; rewrite X in L; lra).
      split; [apply L'|]. split; [exact H|]. intros u U U1 f [<-|I]; [|exact (F u U U1 f I)]. cbn [fst snd].
      pose proof (pos_ratio (- det p q a) (det p q b - det p q a) ltac:(lia)) as R. fold x in R.
      unfold Z.sub in R. rewrite inject_Z_plus, !inject_Z_opp in R.
      assert (P : 0 < inject_Z (det p q b) - inject_Z (det p q a)).
      { assert (0 < inject_Z (det p q b - det p q a)) by (apply inject_pos; lia). unfold Z.sub in H0. rewrite inject_Z_plus, inject_Z_opp in H0. lra. }
      pose proof (mono_lt _ x u P ltac:(lra)). lra.
    + set (x := (det p q a # Z.to_pos (det p q a - det p q b))) in *. destruct (IH _ _ _ _ C) as (L & H & F).
      assert (H' : t <= high /\ t <= x) by (destruct (leb_cases x high) as [(Y & X)|(Y & X)]; rewrite X in H; lra).
      split; [exact L|]. split; [apply H'|]. intros u U U1 f [<-|I]; [|exact (F u U U1 f I)]. cbn [fst snd].
      pose proof (pos_ratio (det p q a) (det p q a - det p q b) ltac:(lia)) as R. fold x in R.
      unfold Z.sub in R. rewrite inject_Z_plus, !inject_Z_opp in R.
      assert (P : 0 < inject_Z (det p q a) - inject_Z (det p q b)).
      { assert (0 < inject_Z (det p q a - det p q b)) by (apply inject_pos; lia). unfold Z.sub in H0. rewrite inject_Z_plus, inject_Z_opp in H0. lra. }
      pose proof (mono_lt _ u x P ltac:(lra)). lra.
    + destruct (IH _ _ _ _ C) as (L & H & F). split; [exact L|]. split; [exact H|].
      intros u U U1 f [<-|I]; [|exact (F u U U1 f I)]. cbn [fst snd].
      pose proof (inject_pos _ A). pose proof (inject_pos _ B).
      destruct (Qlt_le_dec 0 u) as [V|V].
      * assert (0 < u * inject_Z (det p q b)) by (apply Qmult_lt_0_compat; assumption).
        assert (0 <= (1 - u) * inject_Z (det p q a)) by (apply Qmult_le_0_compat; lra). lra.
      * assert (E : u == 0) by lra. rewrite E. lra.
Qed.

Section Scale.
Variable N : positive.
Definition qe (e : edge) : side := (qpt N (fst e), qpt N (snd e)).
Definition unit : Q := 1 # N.
Lemma qfrac i : i # N == inject_Z i * unit.
Proof. unfold unit, Qeq, Qmult, inject_Z. cbn [Qnum Qden]. rewrite Pos.mul_1_l. ring. Qed.
Lemma o_qpt f z : o (qe f) (qpt N z) == inject_Z (det (fst f) (snd f) z) * (unit * unit).
Proof.
  unfold o, Statements.orient, qe, qpt, det. cbn [fst snd]. rewrite !qfrac.
  repeat (rewrite ?inject_Z_mult, ?inject_Z_plus, ?inject_Z_opp || unfold Z.sub). ring.
Qed.
Lemma unit_pos : 0 < unit * unit.
Proof. reflexivity. Qed.
Opaque unit.
Lemma o_pos f z : 0 < o (qe f) (qpt N z) <-> (0 < det (fst f) (snd f) z)%Z.
Proof.
  rewrite o_qpt, Zlt_Qlt. pose proof unit_pos as P. revert P. generalize (unit * unit) (inject_Z (det (fst f) (snd f) z)).
  intros u d U. change (inject_Z 0) with 0. split; intro H; [|apply Qmult_lt_0_compat; assumption].
  destruct (Qlt_le_dec 0 d); [assumption|exfalso]. assert (0 <= - d * u) by (apply Qmult_le_0_compat; lra). lra.
Qed.
Lemma o_nonneg f z : 0 <= o (qe f) (qpt N z) <-> (0 <= det (fst f) (snd f) z)%Z.
Proof.
  rewrite o_qpt, Zle_Qle. pose proof unit_pos as P. revert P. generalize (unit * unit) (inject_Z (det (fst f) (snd f) z)).
  intros u d U. change (inject_Z 0) with 0. split; intro H; [|apply Qmult_le_0_compat; lra].
  destruct (Qlt_le_dec d 0); [exfalso|assumption]. assert (0 < - d * u) by (apply Qmult_lt_0_compat; lra). lra.
Qed.

Lemma point_at_o f e s : o f (point_at e s) == (1 - s) * o f (fst e) + s * o f (snd e).
Proof. apply o_share; reflexivity. Qed.

(* Between both parameters of `clip` a segment is inside the polygon. *)
Theorem clip_inside lines e s t u : clip lines (fst e) (snd e) = Some (s, t) -> s < u < t -> 0 <= u <= 1 ->
  inS (map qe lines) (point_at (qe e) u).
Proof.
  intros C U U1 g G. apply in_map_iff in G as (f & <- & I). unfold clip in C.
  destruct (clip_spec lines _ _ _ _ _ _ C) as (_ & _ & F). specialize (F u U U1 f I).
  rewrite point_at_o. change (fst (qe e)) with (qpt N (fst e)). change (snd (qe e)) with (qpt N (snd e)). rewrite !o_qpt.
  assert (E : (1 - u) * (inject_Z (det (fst f) (snd f) (fst e)) * (unit * unit)) + u * (inject_Z (det (fst f) (snd f) (snd e)) * (unit * unit))
    == ((1 - u) * inject_Z (det (fst f) (snd f) (fst e)) + u * inject_Z (det (fst f) (snd f) (snd e))) * (unit * unit)) by ring.
  rewrite E. apply Qmult_lt_0_compat; [exact F|exact unit_pos].
Qed.

(* A vertex on the line of a segment is at the parameter of one coordinate. *)
Lemma vertex_at e p s : det (fst e) (snd e) p = 0%Z -> fst e <> snd e ->
  s = (let k := if (fst (fst e) =? fst (snd e))%Z then snd else fst in ratio (k p - k (fst e)) (k (snd e) - k (fst e)))%Z ->
  meets_at (point_at (qe e) s) (qpt N p).
Proof.
  destruct e as [[ax ay] [bx b_y]], p as [px py]. unfold det, meets_at, point_at, qe, qpt. cbn [fst snd]. intros D Ne S.
  rewrite !qfrac. destruct (Z.eqb_spec ax bx) as [E|E]; cbn [fst snd] in S.
  - assert (B : (b_y - ay <> 0)%Z) by (intro; apply Ne; f_equal; lia).
    pose proof (ratio_spec (py - ay) (b_y - ay) B) as R. rewrite <- S in R. unfold Z.sub in R. rewrite !inject_Z_plus, !inject_Z_opp in R.
    assert (X : (px = ax)%Z) by nia. subst px bx. split; [ring|]. 
    assert (Y : inject_Z py == inject_Z ay + s * (inject_Z b_y + - inject_Z ay)) by lra. rewrite Y. ring.
  - pose proof (ratio_spec (px - ax) (bx - ax) ltac:(lia)) as R. rewrite <- S in R. unfold Z.sub in R. rewrite !inject_Z_plus, !inject_Z_opp in R.
    assert (X : inject_Z px == inject_Z ax + s * (inject_Z bx + - inject_Z ax)) by lra. split; [rewrite X; ring|].
    assert (Y : inject_Z py == inject_Z ay + s * (inject_Z b_y + - inject_Z ay)).
    { apply (Qmult_inj_l _ _ (inject_Z bx - inject_Z ax)).
      - intro Z0. apply E. apply inject_Z_injective. lra.
      - assert (D' : (inject_Z bx - inject_Z ax) * (inject_Z py - inject_Z ay) == (inject_Z b_y - inject_Z ay) * (inject_Z px - inject_Z ax)).
        { assert (G : forall a b, a - b == a + - b) by (intros; reflexivity). rewrite !G, <- !inject_Z_opp, <- !inject_Z_plus, <- !inject_Z_mult.
          apply inject_Z_injective. lia. }
        rewrite X in D'. lra. }
    rewrite Y. ring.
Qed.

Lemma on_end e : Statements.on_segment e (fst e) /\ Statements.on_segment e (snd e).
Proof. split; [exists 0|exists 1]; repeat split; try lra; ring. Qed.

Lemma between_signs v w r : (1 - r) * v + r * w == 0 -> v * w <= 0 -> ~ (v == 0 /\ w == 0) -> 0 <= r <= 1.
Proof.
  intros Z S Nz. destruct (Qlt_le_dec 0 v) as [V|V].
  - assert (W : w <= 0) by (destruct (Qlt_le_dec 0 w) as [W|W]; [pose proof (Qmult_lt_0_compat v w V W); lra|lra]).
    split; [apply (pos_cancel r (v - w)); lra|]. assert (0 <= 1 - r); [apply (pos_cancel _ (v - w)); lra|lra].
  - destruct (Qlt_le_dec v 0) as [V'|V'].
    + assert (W : 0 <= w).
      { destruct (Qlt_le_dec w 0) as [W|W]; [|exact W]. pose proof (Qmult_lt_0_compat (- v) (- w) ltac:(lra) ltac:(lra)). lra. }
      split; [apply (pos_cancel r (w - v)); lra|]. assert (0 <= 1 - r); [apply (pos_cancel _ (w - v)); lra|lra].
    + assert (E : v == 0) by lra. rewrite E in Z. assert (Z' : r * w == 0) by lra. apply Qmult_integral in Z' as [Z'|Z']; [lra|].
      exfalso. apply Nz. auto.
Qed.

Theorem share_on one other s t u : fst one <> snd one -> share one other = Some (s, t) -> s <= u <= t ->
  Statements.on_segment (qe other) (point_at (qe one) u).
Proof.
  intros Ne H U. destruct one as [a b], other as [p q]. unfold share in H. cbv zeta in H. cbn [fst snd] in Ne.
  destruct (Z.eqb_spec (det a b p) 0) as [P|P]; destruct (Z.eqb_spec (det a b q) 0) as [Q0|Q0]; cbn [andb] in H.
  1: { pose proof (vertex_at (a, b) p _ P Ne eq_refl) as Mp. pose proof (vertex_at (a, b) q _ Q0 Ne eq_refl) as Mq. cbv zeta in Mp, Mq. cbn [fst snd] in Mp, Mq.
    set (k := if (fst a =? fst b)%Z then snd else fst) in *.
    set (x := ratio (k p - k a) (k b - k a)) in *. set (y := ratio (k q - k a) (k b - k a)) in *. clearbody x y.
    assert (M : (s = x /\ t = y) \/ (s = y /\ t = x)).
    { destruct (Qle_bool x y); destruct (Qle_bool _ 1 && Qle_bool 0 _) in H; try discriminate; injection H as <- <-; auto. }
    pose proof (on_end (qe (p, q))) as (Op & Oq). unfold qe in Op, Oq. cbn [fst snd] in Op, Oq.
    apply (on_same _ _ _ (conj (Qeq_sym _ _ (proj1 Mp)) (Qeq_sym _ _ (proj2 Mp)))) in Op.
    apply (on_same _ _ _ (conj (Qeq_sym _ _ (proj1 Mq)) (Qeq_sym _ _ (proj2 Mq)))) in Oq.
    assert (Os : Statements.on_segment (qe (p, q)) (point_at (qe (a, b)) s) /\ Statements.on_segment (qe (p, q)) (point_at (qe (a, b)) t))
      by (destruct M as [(-> & ->)|(-> & ->)]; split; assumption).
    destruct Os as (Os & Ot). destruct (Qeq_dec s t) as [E|E].
    - apply (on_same _ (point_at (qe (a, b)) s)); [|exact Os]. assert (E' : s == u) by lra.
      split; unfold point_at; cbn [fst snd]; rewrite E'; reflexivity.
    - destruct (point_mid (qe (a, b)) s u t U E) as (r & R & _ & _ & _ & Rx & Ry). exact (segment_convex _ _ _ _ r R Os Ot Rx Ry). }
  all: destruct (Z.leb_spec (det a b p * det a b q) 0) as [S1|S1]; cbn [andb] in H; [|discriminate];
    destruct (Z.leb_spec (det p q a * det p q b) 0) as [S2|S2]; cbn [andb] in H; [|discriminate];
    destruct (Z.eqb_spec (det p q a) (det p q b)) as [S3|S3]; cbn [negb] in H; [discriminate|];
    injection H as H1 H2; assert (Ru : u == s) by (subst s t; lra); subst t;
    pose proof (ratio_spec (det p q a) (det p q a - det p q b) ltac:(lia)) as R; rewrite H1 in R;
    unfold Z.sub in R; rewrite inject_Z_plus, inject_Z_opp in R; rewrite <- Ru in R;
    (assert (O1 : o (qe (p, q)) (point_at (qe (a, b)) u) == 0) by
      (rewrite point_at_o; change (fst (qe (a, b))) with (qpt N a); change (snd (qe (a, b))) with (qpt N b); rewrite !o_qpt; cbn [fst snd];
       assert (Z0 : (1 - u) * inject_Z (det p q a) + u * inject_Z (det p q b) == 0) by lra;
       transitivity (((1 - u) * inject_Z (det p q a) + u * inject_Z (det p q b)) * (unit * unit)); [ring|rewrite Z0; ring]));
    (assert (Np : ~ meets_at (fst (qe (p, q))) (snd (qe (p, q)))) by
      (intro M; apply qpt_inj in M; cbn [fst snd] in M; subst q; apply S3; unfold det; ring));
    destruct (line_share (qe (p, q)) _ O1 Np) as (r & X & Y); exists r;
    (split; [|split; assumption]);
    (assert (O2 : o (qe (a, b)) (point_at (qe (a, b)) u) == 0) by (unfold o, Statements.orient, point_at; cbn [fst snd]; ring));
    rewrite (o_share (qe (a, b)) _ _ r _ X Y) in O2; change (fst (qe (p, q))) with (qpt N p) in O2;
    change (snd (qe (p, q))) with (qpt N q) in O2; rewrite !o_qpt in O2; cbn [fst snd] in O2.
  all: apply (between_signs (inject_Z (det a b p) * (unit * unit)) (inject_Z (det a b q) * (unit * unit)) r O2);
    [|intros (V & W); apply Qmult_integral in V, W; pose proof unit_pos as UP;
      destruct V as [V|V]; [|lra]; destruct W as [W|W]; [|lra];
      change 0 with (inject_Z 0) in V, W; apply (proj1 (inject_Z_injective _ _)) in V; apply (proj1 (inject_Z_injective _ _)) in W; lia].
  all: assert (S4 : 0 <= inject_Z (- (det a b p * det a b q))) by (change 0 with (inject_Z 0); rewrite <- Zle_Qle; lia).
  all: rewrite inject_Z_opp, inject_Z_mult in S4; pose proof unit_pos as UP;
    revert S4 UP; generalize (inject_Z (det a b p)) (inject_Z (det a b q)) (unit * unit); clear; intros v w k S4 UP;
    assert (G : 0 <= (k * k) * - (v * w)) by (apply Qmult_le_0_compat; [apply square|exact S4]); lra.
Qed.
End Scale.
