(* Faults, proved by one or two points; and `valid` for shapes that are known exactly. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Near.
Import ListNotations.
Open Scope Q_scope.

Lemma known_self e (S : qpoint -> Prop) : 0 <= e -> Statements.known_to e S S.
Proof. intros E z I. apply within_self; assumption. Qed.
Lemma keeps_disjoint d A B : Statements.keeps d (Statements.inside A) (Statements.inside B) ->
  Statements.disjoint (Statements.inside A) (Statements.inside B).
Proof. intros (N & _). apply disjoint_iff, N. Qed.

(* A part is in a container if and only if it does not overlap the complement. *)
Theorem fits_iff C G t : Statements.fits_at C G t <->
  ~ Statements.overlap (Statements.inside (Statements.translate t G)) (fun z => ~ Statements.inside C z).
Proof.
  split.
  - intros H (z & (d & D & A) & (e & E & B)). apply (B z (close_refl e z E)), H, (A z (close_refl d z D)).
  - intros H z Z. destruct (Z.eq_dec (Statements.winding C z) 1) as [|N]; [assumption|exfalso]. apply H.
    destruct (half_open (Statements.translate t G) z) as (d & D & P). destruct (half_open C z) as (d' & D' & P').
    destruct (below d d' D D') as (r & R & L & L'). destruct (wedge_square r z R) as (c & q & Q0 & Sq).
    exists c. split; exists q; (split; [exact Q0|]); intros y Y; specialize (Sq y Y); unfold Statements.inside.
    + rewrite (P y); [exact Z|]. apply (wedge_less r d z y L Sq).
    + rewrite (P' y); [exact N|]. apply (wedge_less r d' z y L' Sq).
Qed.

(* Figures drawn as rings and known exactly: no two have a common point; each is in the sheet and off each obstacle. *)
Lemma shape_drawn f : 0 <= Statements.error f -> Statements.shape_of f (Statements.drawn f).
Proof. intros E z I. apply within_self; [exact E|exact I]. Qed.
Lemma shape_inside f : 0 <= Statements.error f -> Statements.shape_of f (Statements.inside (Statements.outline f)).
Proof. intros E z I. apply within_self; [exact E|left; exact I]. Qed.
Theorem valid_exact l : Statements.valid l ->
  (forall x, In x (Statements.placements l) -> 0 <= Statements.error (Statements.placed l x)) ->
  (forall i j x y, nth_error (Statements.placements l) i = Some x -> nth_error (Statements.placements l) j = Some y -> i <> j ->
    let S := Statements.inside (Statements.outline (Statements.placed l x)) in let T := Statements.inside (Statements.outline (Statements.placed l y)) in
    Statements.disjoint S T /\ Statements.at_least (Statements.spacing l) S T) /\
  (forall x C e, In x (Statements.placements l) -> Statements.sheet l = Some {| Statements.outline := C; Statements.rounded := []; Statements.error := e |} -> 0 <= e ->
    let S := Statements.inside (Statements.outline (Statements.placed l x)) in
    (forall z, S z -> Statements.inside C z) /\ Statements.at_least (Statements.margin l) S (fun z => ~ Statements.inside C z)) /\
  (forall x o, In x (Statements.placements l) -> In o (Statements.obstacles l) -> 0 <= Statements.error (fst o) ->
    let S := Statements.inside (Statements.outline (Statements.placed l x)) in let T := Statements.inside (Statements.outline (fst o)) in
    Statements.disjoint S T /\ Statements.at_least (snd o) S T).
Proof.
  intros V E. split; [|split].
  - intros i j x y X Y Ne. pose proof (Statements.apart l V i j x y _ _ X Y Ne (shape_inside _ (E x (nth_error_In _ _ X)))
      (shape_inside _ (E y (nth_error_In _ _ Y)))) as K. split; [apply (keeps_disjoint _ _ _ K)|apply K].
  - intros x C e I Sh E0.
    assert (U : Statements.outside_of {| Statements.outline := C; Statements.rounded := []; Statements.error := e |} (fun z => ~ Statements.inside C z)).
    { intros z N. apply within_self; [exact E0|]. intros [Y|(p & [] & _)]. exact (N Y). }
    pose proof (Statements.contained l V x _ _ _ I Sh (shape_inside _ (E x I)) U) as (K1 & K2).
    split; [|exact K2]. intros z Z. destruct (Z.eq_dec (Statements.winding C z) 1) as [|N]; [assumption|exfalso]. apply K1.
    destruct (half_open (Statements.outline (Statements.placed l x)) z) as (d & D & H). destruct (half_open C z) as (d' & D' & H').
    destruct (below d d' D D') as (r & R & L & L'). destruct (wedge_square r z R) as (c & q & Q0 & Sq).
    exists c. split; exists q; (split; [exact Q0|]); intros y Y; specialize (Sq y Y); unfold Statements.inside.
    + rewrite (H y); [exact Z|]. apply (wedge_less r d z y L Sq).
    + rewrite (H' y); [exact N|]. apply (wedge_less r d' z y L' Sq).
  - intros x o I J E0. pose proof (Statements.no_defect l V x o _ _ I J (shape_inside _ (E x I)) (shape_inside (fst o) E0)) as K.
    split; [apply (keeps_disjoint _ _ _ K)|apply K].
Qed.

(* Faults of shapes that are known exactly *)
Definition check_overlap (A B : list Statements.ring) (z : Statements.point) : bool :=
  (Statements.winding A z =? 1)%Z && (Statements.winding B z =? 1)%Z.
Theorem overlap_sound A B z : check_overlap A B z = true -> Statements.overlap (Statements.inside A) (Statements.inside B).
Proof.
  unfold check_overlap. intro H. apply andb_prop in H as (X & Y). apply Z.eqb_eq in X, Y.
  exact (overlap_of_point A B z X Y).
Qed.
Lemma in_closure (S : Statements.point -> Prop) z : S z -> Statements.closure S z.
Proof. intros H e E. exists z. split; [exact H|apply close_refl, E]. Qed.

Definition check_too_close (A B : list Statements.ring) (d : Q) (y z : Statements.point) : bool :=
  (Statements.winding A y =? 1)%Z && (Statements.winding B z =? 1)%Z && negb (Qle_bool (d * d) (Statements.dist2 y z)).
Theorem too_close_sound A B d y z : check_too_close A B d y z = true -> ~ Statements.at_least d (Statements.inside A) (Statements.inside B).
Proof.
  unfold check_too_close. intros H N. apply andb_prop in H as (H & X). apply andb_prop in H as (Y & Z').
  apply Z.eqb_eq in Y, Z'. specialize (N y z (in_closure _ y Y) (in_closure _ z Z')).
  apply Qle_bool_iff in N. rewrite N in X. discriminate.
Qed.
Definition check_outside (A C : list Statements.ring) (z : Statements.point) : bool :=
  (Statements.winding A z =? 1)%Z && negb (Statements.winding C z =? 1)%Z.
Theorem outside_sound A C z : check_outside A C z = true -> ~ (forall y, Statements.inside A y -> Statements.inside C y).
Proof.
  unfold check_outside. intros H N. apply andb_prop in H as (X & Y). apply Z.eqb_eq in X.
  specialize (N z X). unfold Statements.inside in N. rewrite N in Y. discriminate.
Qed.
Definition check_shape (A : list Statements.ring) (z : Statements.point) : bool :=
  negb ((Statements.winding A z =? 0)%Z || (Statements.winding A z =? 1)%Z).
Theorem shape_sound A z : check_shape A z = true -> ~ Statements.simple A.
Proof.
  unfold check_shape. intros H (S & _). destruct (S z) as [E|E]; rewrite E in H; discriminate.
Qed.

(* An overlap of drawn parts refutes a layout. *)
Corollary overlap_refutes l i j x y z : nth_error (Statements.placements l) i = Some x -> nth_error (Statements.placements l) j = Some y ->
  i <> j -> 0 <= Statements.error (Statements.placed l x) -> 0 <= Statements.error (Statements.placed l y) ->
  check_overlap (Statements.outline (Statements.placed l x)) (Statements.outline (Statements.placed l y)) z = true -> ~ Statements.valid l.
Proof.
  intros X Y N E E' H V. destruct (Statements.apart l V i j x y _ _ X Y N (shape_inside _ E) (shape_inside _ E')) as (K & _).
  apply K. exact (overlap_sound _ _ z H).
Qed.
