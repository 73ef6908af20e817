(* The checker of layouts, and the theorem: what it accepts is valid. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Solid Gaps Scaling.
From Exactsweep Require Statements HalfOpen.
Import ListNotations.
Open Scope Z_scope.

(* The evidence: integer pieces at a common denominator.  `bounds`: a frame around all parts. *)
Record certificate := {
  denominator : positive;
  part_pieces : list (list ring);
  obstacle_pieces : list (list ring);
  outside_pieces : list ring;
  bounds : Z * Z * Z * Z }.

Definition check_allowed (l : Statements.layout) (x : nat * Statements.motion) : bool :=
  let m := snd x in let k := Statements.kind_of l x in
  (fst x <? length (Statements.kinds l))%nat &&
  Qeq_bool (Statements.cosine m * Statements.cosine m + Statements.sine m * Statements.sine m) 1 &&
  (negb (Statements.mirrored m) || Statements.may_mirror k) &&
  match Statements.rotations k with
  | None => true
  | Some cs => existsb (fun c => Qeq_bool (fst c) (Statements.cosine m) && Qeq_bool (snd c) (Statements.sine m)) cs
  end.
Definition check_supply (l : Statements.layout) : bool :=
  forallb (fun k => match nth_error (Statements.kinds l) k with
    | None => true
    | Some p => match Statements.demand p with
      | None => true
      | Some n => (count_occ Nat.eq_dec (map fst (Statements.placements l)) k =? n)%nat
      end
    end) (seq 0 (length (Statements.kinds l))).

Definition solids (D : Z) (rss : list (list Statements.ring)) (pss : list (list ring)) : list solid :=
  map (fun x => {| rings := int_rings D (fst x); pieces := snd x |}) (combine rss pss).

Definition problem_of (l : Statements.layout) (c : certificate) : problem :=
  let D := Zpos (denominator c) in
  {| container := int_rings D (Statements.sheet l); outside := outside_pieces c; frame := bounds c;
     parts := solids D (Statements.placed l) (part_pieces c); defects := solids D (Statements.obstacles l) (obstacle_pieces c);
     spacing := int D (Statements.spacing l); margin := int D (Statements.margin l) |}.

Definition check_layout (hint : ring -> ring -> pt) (l : Statements.layout) (c : certificate) : bool :=
  let D := Zpos (denominator c) in
  forallb (check_allowed l) (Statements.placements l) && check_supply l &&
  (length (Statements.placed l) =? length (part_pieces c))%nat &&
  (length (Statements.obstacles l) =? length (obstacle_pieces c))%nat &&
  all_integral D (Statements.sheet l) && forallb (all_integral D) (Statements.placed l) &&
  forallb (all_integral D) (Statements.obstacles l) && integral D (Statements.spacing l) && integral D (Statements.margin l) &&
  check hint (problem_of l c).

Lemma check_allowed_spec l x : check_allowed l x = true -> Statements.allowed l x.
Proof.
  unfold check_allowed, Statements.allowed. intro H.
  apply andb_prop in H as (H & R). apply andb_prop in H as (H & M). apply andb_prop in H as (I & T).
  repeat split.
  - apply Nat.ltb_lt, I.
  - apply Qeq_bool_iff, T.
  - intro E. rewrite E in M. exact M.
  - destruct (Statements.rotations (Statements.kind_of l x)) as [cs|]; [|exact Logic.I].
    apply existsb_exists in R as (c & J & R). apply andb_prop in R as (R1 & R2).
    exists c. repeat split; [exact J| |]; apply Qeq_bool_iff; assumption.
Qed.

Lemma check_supply_spec l : check_supply l = true -> Statements.supplied l.
Proof.
  unfold check_supply, Statements.supplied. rewrite forallb_forall. intros H k p n E F.
  assert (k < length (Statements.kinds l))%nat by (apply nth_error_Some; congruence).
  specialize (H k). rewrite E, F in H. apply Nat.eqb_eq, H, in_seq. lia.
Qed.

Lemma nth_solids D rss pss i rs : length rss = length pss -> nth_error rss i = Some rs ->
  exists ps, nth_error (solids D rss pss) i = Some {| rings := int_rings D rs; pieces := ps |}.
Proof.
  unfold solids. revert pss i. induction rss as [|r rss IH]; intros [|p pss] [|i] L E; try discriminate.
  - cbn in *. injection E as ->. exists p. reflexivity.
  - cbn in *. apply IH; [lia|exact E].
Qed.

Lemma pairs_nth {A} (R : A -> A -> Prop) l : ForallOrdPairs R l -> forall i j a b, (i < j)%nat ->
  nth_error l i = Some a -> nth_error l j = Some b -> R a b.
Proof.
  induction 1 as [|x l H _ IH]; intros i j a b L E F; [destruct i; discriminate|].
  destruct j as [|j]; [lia|]. destruct i as [|i]; cbn in *.
  - injection E as ->. rewrite Forall_forall in H. apply H. eapply nth_error_In, F.
  - apply (IH i j); [lia|assumption|assumption].
Qed.

Section Transfer.
Variable D : Z.
Hypothesis Dpos : 0 < D.

Lemma transfer_simple rs s : rings_at D rs (rings s) -> shape_ok s -> Statements.simple rs.
Proof.
  intros R (H & z & Z1). split.
  - intro q. destruct (pat_common q q) as (k & v & _ & K & V & _).
    rewrite (winding_W D k rs (rings s) q v Dpos K R V). apply H, K.
  - apply (HalfOpen.interior_of_point rs (fst z # Z.to_pos (3 * D), snd z # Z.to_pos (3 * D))).
    unfold Statements.inside. rewrite <- Z1, <- W_edges. apply (winding_at (3 * D)); [lia|apply rings_grow, R|].
    unfold pat, at_, Qeq, Qmult, inject_Z. cbn [fst snd Qnum Qden].
    rewrite Pos.mul_1_r, Z2Pos.id by lia. split; ring.
Qed.

Lemma transfer_dist d k y z v w : 0 < k -> pat k y v -> pat k z w ->
  integral D d = true -> (k * int D d) * (k * int D d) <= dist2 (grow D v) (grow D w) ->
  (d * d <= Statements.dist2 y z)%Q.
Proof.
  intros K V X I H. apply (at_le ((k * D) * (k * D)) (d * d) (Statements.dist2 y z)
    ((k * int D d) * (k * int D d)) (dist2 (grow D v) (grow D w))); [nia| | |exact H].
  - pose proof (int_at D d I) as E. unfold at_ in *. rewrite !inject_Z_mult, <- E. ring.
  - apply dist2_at; apply pat_grow'; assumption.
Qed.

Lemma transfer_apart d rs qs s t : integral D d = true -> rings_at D rs (rings s) -> rings_at D qs (rings t) ->
  keep_apart (int D d) s t -> Statements.disjoint (Statements.inside rs) (Statements.inside qs) /\ Statements.at_least d (Statements.inside rs) (Statements.inside qs).
Proof.
  intros I R Q A. split.
  - intros z (X & Y). destruct (pat_common z z) as (k & v & _ & K & V & _). unfold Statements.inside in *.
    rewrite (winding_W D k rs (rings s) z v Dpos K R V) in X. rewrite (winding_W D k qs (rings t) z v Dpos K Q V) in Y.
    apply (proj1 (A k K) (grow D v)). split; assumption.
  - apply closure_dist. intros y z X Y. destruct (pat_common y z) as (k & v & w & K & V & U). unfold Statements.inside in *.
    rewrite (winding_W D k rs (rings s) y v Dpos K R V) in X. rewrite (winding_W D k qs (rings t) z w Dpos K Q U) in Y.
    apply (transfer_dist d k y z v w K V U I). apply (proj2 (A k K)); assumption.
Qed.

Lemma apart_sym d rs qs : Statements.disjoint (Statements.inside rs) (Statements.inside qs) /\ Statements.at_least d (Statements.inside rs) (Statements.inside qs) ->
  Statements.disjoint (Statements.inside qs) (Statements.inside rs) /\ Statements.at_least d (Statements.inside qs) (Statements.inside rs).
Proof.
  intros (A & B). split.
  - intros z (X & Y). apply (A z). split; assumption.
  - intros y z X Y. specialize (B z y Y X). unfold Statements.dist2 in *. lra.
Qed.

Lemma transfer_inside d rs cs s ns : integral D d = true -> rings_at D rs (rings s) -> rings_at D cs ns ->
  keep_inside (int D d) s ns -> (forall z, Statements.inside rs z -> Statements.inside cs z) /\
  Statements.at_least d (Statements.inside rs) (fun z => ~ Statements.inside cs z).
Proof.
  intros I R Q A. split.
  - intros z X. destruct (pat_common z z) as (k & v & _ & K & V & _). unfold Statements.inside in *.
    rewrite (winding_W D k rs (rings s) z v Dpos K R V) in X. rewrite (winding_W D k cs ns z v Dpos K Q V).
    apply (proj1 (A k K)), X.
  - apply closure_dist. intros y z X Y. destruct (pat_common y z) as (k & v & w & K & V & U). unfold Statements.inside in *.
    rewrite (winding_W D k rs (rings s) y v Dpos K R V) in X. rewrite (winding_W D k cs ns z w Dpos K Q U) in Y.
    apply (transfer_dist d k y z v w K V U I). apply (proj2 (A k K)); assumption.
Qed.
End Transfer.

Theorem layout_sound hint l c : check_layout hint l c = true -> Statements.valid l.
Proof.
  unfold check_layout. intro H. set (D := Zpos (denominator c)) in *. assert (P : 0 < D) by reflexivity.
  apply andb_prop in H as (H & Ck). apply andb_prop in H as (H & Im). apply andb_prop in H as (H & Is).
  apply andb_prop in H as (H & Io). apply andb_prop in H as (H & Ip). apply andb_prop in H as (H & Ic).
  apply andb_prop in H as (H & Lo). apply andb_prop in H as (H & Lp). apply andb_prop in H as (Al & Su).
  rewrite forallb_forall in Al, Ip, Io. apply Nat.eqb_eq in Lp, Lo.
  destruct (check_sound hint _ Ck) as (Sh & Df & Pairs & In_ & Def).
  change (parts (problem_of l c)) with (solids D (Statements.placed l) (part_pieces c)) in *.
  change (defects (problem_of l c)) with (solids D (Statements.obstacles l) (obstacle_pieces c)) in *.
  change (spacing (problem_of l c)) with (int D (Statements.spacing l)) in *.
  change (margin (problem_of l c)) with (int D (Statements.margin l)) in *.
  change (container (problem_of l c)) with (int_rings D (Statements.sheet l)) in *.
  rewrite Forall_forall in Sh, Df.
  assert (Part : forall a, In a (Statements.placed l) -> exists s, In s (solids D (Statements.placed l) (part_pieces c)) /\ rings_at D a (rings s)).
  { intros a I. pose proof (int_rings_at D a (Ip a I)) as R. apply In_nth_error in I as (i & I).
    destruct (nth_solids D _ _ i a Lp I) as (ps & E). eexists. split; [eapply nth_error_In, E|exact R]. }
  assert (Obst : forall a, In a (Statements.obstacles l) -> exists s, In s (solids D (Statements.obstacles l) (obstacle_pieces c)) /\ rings_at D a (rings s)).
  { intros a I. pose proof (int_rings_at D a (Io a I)) as R. apply In_nth_error in I as (i & I).
    destruct (nth_solids D _ _ i a Lo I) as (ps & E). eexists. split; [eapply nth_error_In, E|exact R]. }
  constructor.
  - split; [rewrite Forall_forall; intros x I; apply check_allowed_spec, Al, I|apply check_supply_spec, Su].
  - split; rewrite Forall_forall; intros a I.
    + destruct (Part a I) as (s & J & R). apply (transfer_simple D P a s R), Sh, J.
    + destruct (Obst a I) as (s & J & R). apply (transfer_simple D P a s R), Df, J.
  - assert (G : forall i j a b, (i < j)%nat -> nth_error (Statements.placed l) i = Some a -> nth_error (Statements.placed l) j = Some b ->
      Statements.disjoint (Statements.inside a) (Statements.inside b) /\ Statements.at_least (Statements.spacing l) (Statements.inside a) (Statements.inside b)).
    { intros i j a b L A B. destruct (nth_solids D _ _ i a Lp A) as (ps & E). destruct (nth_solids D _ _ j b Lp B) as (qs & F).
      apply (transfer_apart D P (Statements.spacing l) a b {| rings := int_rings D a; pieces := ps |} {| rings := int_rings D b; pieces := qs |}); [exact Is| | |].
      - apply int_rings_at, Ip. eapply nth_error_In, A.
      - apply int_rings_at, Ip. eapply nth_error_In, B.
      - exact (pairs_nth _ _ Pairs i j _ _ L E F). }
    intros i j a b A B N. destruct (Nat.lt_gt_cases i j) as (C & _). destruct (C N) as [C'|C'].
    + exact (G i j a b C' A B).
    + apply apart_sym, (G j i b a C' B A).
  - intros a I. destruct (Part a I) as (s & J & R).
    apply (transfer_inside D P (Statements.margin l) a (Statements.sheet l) s (int_rings D (Statements.sheet l)) Im R);
      [apply int_rings_at, Ic|apply In_, J].
  - intros a o I O. destruct (Part a I) as (s & J & R). destruct (Obst o O) as (f & F & Q).
    apply (transfer_apart D P (Statements.margin l) a o s f Im R Q), Def; assumption.
Qed.

(* Faults need no pieces: the definitions are computed. *)
Definition check_overlap (A B : list Statements.ring) (z : Statements.point) : bool := (Statements.winding A z =? 1) && (Statements.winding B z =? 1).
Theorem overlap_sound A B z : check_overlap A B z = true -> Statements.overlap (Statements.inside A) (Statements.inside B).
Proof.
  unfold check_overlap. intro H. apply andb_prop in H as (X & Y). apply Z.eqb_eq in X, Y.
  exact (HalfOpen.overlap_of_point A B z X Y).
Qed.

Lemma in_closure (S : Statements.point -> Prop) z : S z -> Statements.closure S z.
Proof. intros H e E. exists z. split; [exact H|apply HalfOpen.close_refl, E]. Qed.

Definition check_too_close (A B : list Statements.ring) (d : Q) (y z : Statements.point) : bool :=
  (Statements.winding A y =? 1) && (Statements.winding B z =? 1) && negb (Qle_bool (d * d) (Statements.dist2 y z)).
Theorem too_close_sound A B d y z : check_too_close A B d y z = true -> ~ Statements.at_least d (Statements.inside A) (Statements.inside B).
Proof.
  unfold check_too_close. intros H N. apply andb_prop in H as (H & X). apply andb_prop in H as (Y & Z').
  apply Z.eqb_eq in Y, Z'. specialize (N y z (in_closure _ y Y) (in_closure _ z Z')).
  apply Qle_bool_iff in N. rewrite N in X. discriminate.
Qed.

Definition check_outside (A C : list Statements.ring) (z : Statements.point) : bool := (Statements.winding A z =? 1) && negb (Statements.winding C z =? 1).
Theorem outside_sound A C z : check_outside A C z = true -> ~ (forall y, Statements.inside A y -> Statements.inside C y).
Proof.
  unfold check_outside. intros H N. apply andb_prop in H as (X & Y). apply Z.eqb_eq in X.
  specialize (N z X). unfold Statements.inside in N. rewrite N in Y. discriminate.
Qed.

(* So an overlap refutes a layout. *)
Corollary overlap_refutes l i j a b z : nth_error (Statements.placed l) i = Some a -> nth_error (Statements.placed l) j = Some b ->
  i <> j -> check_overlap a b z = true -> ~ Statements.valid l.
Proof.
  intros A B N H V. destruct (Statements.no_overlap l V i j a b A B N) as (Dj & _).
  apply (proj1 (HalfOpen.disjoint_iff a b) Dj), (overlap_sound a b z H).
Qed.
