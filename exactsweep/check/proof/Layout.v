(* The checker of layouts, and its theorem: accepted layouts are valid. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Convex Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers Spans Sums Pairs Near Depth Hull.
Import ListNotations.
Open Scope Z_scope.

(* The evidence, in integers at a common denominator: pieces of each placement, part and obstacle drawn as rings, and of
   the complement of the sheet in a frame (left, bottom, right, top). *)
Record certificate := {
  denominator : positive;
  part_pieces : list (list ring); kind_pieces : list (list ring); obstacle_pieces : list (list ring);
  outside_pieces : list ring; frame : Z * Z * Z * Z }.

(* A rounded piece has a radius. An item: its pieces, its error, and the extents of its box. *)
Definition rounded_piece := (ring * Z)%type.
Record item := { parts : list rounded_piece; reach : Z; extents : list Z }.
Definition extent (ps : list rounded_piece) (n : pt) : Z :=
  match ps with [] => 0 | p :: r => fold_right (fun q m => Z.max (most n (fst q) + snd q) m) (most n (fst p) + snd p) r end.
Definition make_item (ps : list rounded_piece) (e : Z) : item := {| parts := ps; reach := e; extents := map (extent ps) axes |}.

Definition gap (d : Z) (p q : rounded_piece) (n : pt) : bool := far (d + snd p + snd q) n (fst p) (fst q).
(* Boxes at distance d, in the order of `axes`: right, up, left, down *)
Definition box_gap (d : Z) (x y : list Z) : bool :=
  match x, y with
  | [r; u; l; b], [r'; u'; l'; b'] => (d <=? - l' - r) || (d <=? - b' - u) || (d <=? - r' - l) || (d <=? - u' - b)
  | _, _ => false
  end.
Definition numbered {A} (l : list A) : list (nat * A) := combine (seq 0 (length l)) l.
Definition is_apart (d : Z) (normals : nat -> nat -> pt) (x y : item) : bool :=
  let d := d + reach x + reach y in
  box_gap d (extents x) (extents y) ||
  forallb (fun p => forallb (fun q => some (gap d (snd p) (snd q)) (normals (fst p) (fst q) :: axes)) (numbered (parts y))) (numbered (parts x)).
Fixpoint all_apart (d : Z) (normals : nat -> nat -> nat -> nat -> pt) (l : list (nat * item)) : bool :=
  match l with
  | [] => true
  | (a, x) :: r => forallb (fun y => is_apart d (fun i j => normals a i (fst y) j) x (snd y)) r && all_apart d normals r
  end.

Definition planes (f : Z * Z * Z * Z) : list (pt * Z) :=
  let '(l, b, r, t) := f in [((1, 0), r); ((0, 1), t); ((-1, 0), - l); ((0, -1), - b)].
Definition within_frame (d : Z) (f : Z * Z * Z * Z) (x : item) : bool :=
  forallb (fun p => forallb (fun h => most (fst h) (fst p) + snd p + reach x + d <=? snd h) (planes f)) (parts x).

Definition are_amounts (f : Statements.figure) : bool :=
  Qle_bool 0 (Statements.error f) && forallb (fun p => Qle_bool 0 (snd p)) (Statements.rounded f).
Definition is_well_formed (l : Statements.layout) : bool :=
  (Qle_bool 0 (Statements.spacing l) && Qle_bool 0 (Statements.margin l)) &&
  (forallb (fun p => are_amounts (Statements.form p)) (Statements.kinds l) &&
  (forallb (fun o => are_amounts (fst o) && Qle_bool 0 (snd o)) (Statements.obstacles l) &&
  (match Statements.sheet l with Some f => are_amounts f | None => true end &&
  forallb (fun x => let m := Statements.by_motion x in Qle_bool 0 (Statements.slack x) &&
    Qeq_bool (Statements.cosine m * Statements.cosine m + Statements.sine m * Statements.sine m) 1) (Statements.placements l)))).
Definition is_by (x : Statements.placement) (r : Statements.rotation) : bool :=
  match r, Statements.degrees x with
  | Statements.Rational c s, None => Qeq_bool c (Statements.cosine (Statements.by_motion x)) && Qeq_bool s (Statements.sine (Statements.by_motion x))
  | Statements.Degrees d, Some e => Qeq_bool d e
  | _, _ => false
  end.
Definition is_rotated (l : Statements.layout) (x : Statements.placement) : bool :=
  match (if Statements.mirrored (Statements.by_motion x) then Statements.mirrored_rotations else Statements.rotations) (Statements.kind_of l x) with
  | None => true
  | Some rs => existsb (is_by x) rs
  end.
Definition check_allowed (l : Statements.layout) (x : Statements.placement) : bool :=
  (Statements.kind x <? length (Statements.kinds l))%nat &&
  (negb (Statements.mirrored (Statements.by_motion x)) || Statements.may_mirror (Statements.kind_of l x)) && is_rotated l x.
Definition check_supply (l : Statements.layout) : bool :=
  forallb (fun k => match nth_error (Statements.kinds l) k with
    | None => true
    | Some p => match Statements.demand p with
      | None => true
      | Some n => (Statements.number l k =? n)%N
      end
    end) (seq 0 (length (Statements.kinds l))).

Definition is_amount (D : Z) (q : Q) : bool := Qle_bool 0 q && integral D q.

Section Check.
(* The normals of the certificate, an arbitrary function: no property of it is used. `outside_normals` -1: the
   complement of the sheet; -2 - k: obstacle k; both are on the first side of the normal. *)
Variables (normals : nat -> nat -> nat -> nat -> pt) (outside_normals : Z -> nat -> nat -> nat -> pt).
Variables (l : Statements.layout) (c : certificate).
Let D := Zpos (denominator c).

(* A figure and the pieces of its rings *)
Definition item_of (x : Statements.figure * list ring) : item :=
  make_item (map (fun p => (p, 0)) (snd x) ++ map (fun p => (map (int_point D) (fst p), int D (snd p))) (Statements.rounded (fst x)))
    (int D (Statements.error (fst x))).
Definition is_solid_figure (x : Statements.figure * list ring) : bool :=
  let rs := Statements.outline (fst x) in
  is_amount D (Statements.error (fst x)) && all_integral D rs &&
  forallb (fun p => all_integral D [fst p] && is_amount D (snd p) && negb (match fst p with [] => true | _ => false end)) (Statements.rounded (fst x)) &&
  match rs, snd x, Statements.rounded (fst x) with
  | [], [], _ :: _ => true
  | [], _, _ => false
  | _, ps, _ => simple_solid {| rings := int_rings D rs; pieces := ps |}
  end.

(* The sheet: d is the margin.  A rounded sheet contains a piece if all vertices of the piece are close enough to the
   hull. *)
Definition in_rounded (d : Z) (ps : list qpoint) (radius : Z) (x : item) : bool :=
  forallb (fun q => let room := radius - snd q - reach x - d in
    (0 <=? room) && forallb (fun v => near_hull (room # denominator c) ps (qpt (denominator c) v)) (fst q)) (parts x).
Definition check_sheet (f : Statements.figure) (d : Z) (l : list (nat * item)) : bool :=
  let rs := Statements.outline f in let e := int D (Statements.error f) in
  is_amount D (Statements.error f) &&
  match rs, Statements.rounded f with
  | [], [(p :: ps, r)] => is_amount D r && forallb (fun x => in_rounded (d + e) (p :: ps) (int D r) (snd x)) l
  | _, [] =>
      let '(x0, y0, x1, y1) := frame c in let out := make_item (map (fun p => (p, 0)) (outside_pieces c)) e in
      (x0 <? x1) && (y0 <? y1) && all_integral D rs && forallb is_convex (outside_pieces c) &&
      cancel (flat_map edges (outside_pieces c) ++ flat_map edges (int_rings D rs)) (edges (box_ring x0 y0 x1 y1)) &&
      forallb (fun x => within_frame (d + e) (frame c) (snd x) && is_apart d (fun i j => outside_normals (-1) i (fst x) j) out (snd x)) l
  | _, _ => false
  end.

Definition solid_parts := combine (map (Statements.placed l) (Statements.placements l)) (part_pieces c).
Definition solid_kinds := combine (map Statements.form (Statements.kinds l)) (kind_pieces c).
Definition solid_obstacles := combine (map fst (Statements.obstacles l)) (obstacle_pieces c).
Definition obstacle_items : list (nat * (item * Q)) := numbered (combine (map item_of solid_obstacles) (map snd (Statements.obstacles l))).
Definition items : list (nat * item) := numbered (map item_of solid_parts).
Definition check_layout : bool :=
  is_well_formed l && forallb (check_allowed l) (Statements.placements l) && check_supply l &&
  (length (Statements.placements l) =? length (part_pieces c))%nat &&
  (length (Statements.kinds l) =? length (kind_pieces c))%nat && forallb is_solid_figure solid_kinds &&
  (length (Statements.obstacles l) =? length (obstacle_pieces c))%nat &&
  is_amount D (Statements.spacing l) && is_amount D (Statements.margin l) &&
  forallb is_solid_figure solid_parts && forallb is_solid_figure solid_obstacles &&
  all_apart (int D (Statements.spacing l)) normals items &&
  forallb (fun o => let d := snd (snd o) in is_amount D d &&
    forallb (fun x => is_apart (int D d) (fun i j => outside_normals (-2 - Z.of_nat (fst o)) i (fst x) j) (fst (snd o)) (snd x)) items) obstacle_items &&
  match Statements.sheet l with
  | None => true
  | Some f => check_sheet f (int D (Statements.margin l)) items
  end.
End Check.

(* 2. Soundness *)
Lemma forallb_Forall {A} (f : A -> bool) (P : A -> Prop) l : (forall x, f x = true -> P x) -> forallb f l = true -> Forall P l.
Proof. rewrite forallb_forall, Forall_forall. auto. Qed.
Lemma are_amounts_spec f : are_amounts f = true -> Statements.amounts f.
Proof.
  intro H. apply andb_prop in H as (E & R). split; [apply Qle_bool_iff, E|]. revert R. apply forallb_Forall. intros p. apply Qle_bool_iff.
Qed.
Lemma is_well_formed_spec l : is_well_formed l = true -> Statements.well_formed l.
Proof.
  unfold is_well_formed. intro H. apply andb_prop in H as (D & H). apply andb_prop in H as (K & H). apply andb_prop in H as (O & H).
  apply andb_prop in H as (C & P). apply andb_prop in D as (D1 & D2). split; [split; apply Qle_bool_iff; assumption|]. split; [|split; [|split]].
  - revert K. apply forallb_Forall. intros p. apply are_amounts_spec.
  - revert O. apply forallb_Forall. intros o H. apply andb_prop in H as (A & B). split; [apply are_amounts_spec, A|apply Qle_bool_iff, B].
  - intros f E. rewrite E in C. apply are_amounts_spec, C.
  - revert P. apply forallb_Forall. cbv zeta. intros x H. apply andb_prop in H as (A & B). split; [apply Qle_bool_iff, A|apply Qeq_bool_iff, B].
Qed.
Lemma is_by_spec x r : is_by x r = true <-> Statements.is_by x r.
Proof.
  unfold is_by, Statements.is_by. destruct r as [c s|d], (Statements.degrees x) as [e|]; try (split; [discriminate|intros []]); [|apply Qeq_bool_iff].
  rewrite andb_true_iff, !Qeq_bool_iff. reflexivity.
Qed.
Lemma is_rotated_spec l x : is_rotated l x = true <-> Statements.rotated l x.
Proof.
  unfold Statements.rotated, is_rotated. destruct ((if Statements.mirrored _ then _ else _) _) as [rs|]; [|split; [discriminate|reflexivity]].
  rewrite existsb_exists. split.
  - intros (r & I & H) rs' [= <-]. apply Exists_exists. exists r. split; [exact I|apply is_by_spec, H].
  - intro H. specialize (H rs eq_refl). apply Exists_exists in H as (r & I & H). exists r. split; [exact I|apply is_by_spec, H].
Qed.
Lemma check_allowed_spec l x : check_allowed l x = true -> Statements.allowed l x.
Proof.
  unfold check_allowed, Statements.allowed. intro H. apply andb_prop in H as (H & R). apply andb_prop in H as (I & M). split; [|split].
  - apply Nat.ltb_lt, I.
  - intro E. rewrite E in M. exact M.
  - apply is_rotated_spec, R.
Qed.
Lemma check_supply_spec l : check_supply l = true -> Statements.supplied l.
Proof.
  unfold check_supply, Statements.supplied. rewrite forallb_forall. intros H k n (p & E & F).
  assert (k < length (Statements.kinds l))%nat by (apply nth_error_Some; congruence).
  specialize (H k). rewrite E, F in H. apply N.eqb_eq, H, in_seq. lia.
Qed.

Open Scope Q_scope.
Section Regions.
Variable N : positive.
Definition qnormal (n : pt) : qpoint := (inject_Z (fst n), inject_Z (snd n)).
Definition core (p : ring) (y : qpoint) : Prop := forall n a, (forall v, In v p -> (dot n v <= a)%Z) -> along (qnormal n) y <= a # N.
Definition region_of (p : rounded_piece) : region := (core (fst p), snd p # N).

Lemma piece_core P y : is_fan P = true -> Statements.winding [qring N P] y = 1%Z -> core P y.
Proof. intros F W n a B. exact (piece_le N P n a y F B W). Qed.
Lemma frac_nonneg a : (0 <= a)%Z -> 0 <= a # N.
Proof. unfold Qle. cbn [Qnum Qden]. lia. Qed.
Lemma frac_plus a b : (a + b # N) == (a # N) + (b # N).
Proof. unfold Qeq, Qplus. cbn [Qnum Qden]. rewrite Pos2Z.inj_mul. ring. Qed.

Lemma far_between d n p q s (r r' : Q) : far d n p q = true -> s + r + r' == d # N -> gap_between s (core p, r) (core q, r').
Proof.
  intros F E. destruct (far_spec _ _ _ _ F) as (Nz & a & b & A & B & O & W).
  exists (qnormal n), (a # N), (b # N). cbn [fst snd]. repeat split.
  - intros y Y. apply Y, A.
  - intros y Y. assert (H : along (qnormal (opposite n)) y <= - b # N).
    { apply Y. intros v V. specialize (B v V). unfold dot, opposite in *. cbn [fst snd]. lia. }
    unfold along, qnormal, opposite in *. cbn [fst snd] in *. rewrite !inject_Z_opp in H.
    assert (X : (- b # N) == - (b # N)) by (unfold Qeq, Qopp; cbn [Qnum Qden]; ring). lra.
  - unfold square_of, qnormal. cbn [fst snd]. rewrite <- !inject_Z_mult, <- inject_Z_plus. apply inject_pos.
    destruct n as [u v]. cbn [fst snd]. assert (u <> 0 \/ v <> 0)%Z by (destruct (Z.eq_dec u 0); [right; congruence|left; assumption]). nia.
  - apply frac_le, O.
  - rewrite E. unfold square_of, qnormal. cbn [fst snd]. rewrite (qfrac N d), (qfrac N a), (qfrac N b).
    assert (W' : inject_Z (d * d * dot n n) <= inject_Z ((b - a) * (b - a))) by (rewrite <- Zle_Qle; exact W).
    unfold dot, Z.sub in W'. repeat rewrite ?inject_Z_mult, ?inject_Z_plus, ?inject_Z_opp in W'.
    pose proof (unit_pos N) as P. pose proof (mono_le (unit N * unit N) _ _ ltac:(lra) W') as M.
    assert (E1 : inject_Z d * unit N * (inject_Z d * unit N) * (inject_Z (fst n) * inject_Z (fst n) + inject_Z (snd n) * inject_Z (snd n)) ==
      unit N * unit N * (inject_Z d * inject_Z d * (inject_Z (fst n) * inject_Z (fst n) + inject_Z (snd n) * inject_Z (snd n)))) by ring.
    assert (E2 : (inject_Z b * unit N - inject_Z a * unit N) * (inject_Z b * unit N - inject_Z a * unit N) ==
      unit N * unit N * ((inject_Z b + - inject_Z a) * (inject_Z b + - inject_Z a))) by ring.
    rewrite E1, E2. exact M.
Qed.

(* Boxes *)
Lemma extent_spec ps n p : In p ps -> (most n (fst p) + snd p <= extent ps n)%Z.
Proof.
  destruct ps as [|q ps]; [intros []|]. unfold extent. induction ps as [|w ps IH]; cbn [fold_right]; intros [<-|I]; try lia; [destruct I| |].
  - specialize (IH (or_introl eq_refl)). lia.
  - destruct I as [<-|I]; [lia|]. specialize (IH (or_intror I)). lia.
Qed.
Lemma axis_between n d p q s (r r' : Q) : In n axes -> (0 <= d)%Z -> (d <= - most (opposite n) q - most n p)%Z ->
  s + r + r' == d # N -> gap_between s (core p, r) (core q, r').
Proof.
  intros I D0 L E. exists (qnormal n), (most n p # N), (- most (opposite n) q # N). cbn [fst snd].
  assert (S : square_of (qnormal n) == 1) by (destruct I as [<-|[<-|[<-|[<-|[]]]]]; unfold square_of, qnormal; cbn [fst snd]; ring).
  repeat split.
  - intros y Y. apply Y. intros v V. apply most_spec, V.
  - intros y Y. assert (H : along (qnormal (opposite n)) y <= most (opposite n) q # N) by (apply Y; intros v V; apply most_spec, V).
    unfold along, qnormal, opposite in *. cbn [fst snd] in *. rewrite !inject_Z_opp in H.
    assert (X : forall i, (- i # N) == - (i # N)) by (intro i; unfold Qeq, Qopp; cbn [Qnum Qden]; ring). rewrite X. lra.
  - rewrite S. reflexivity.
  - apply frac_le. lia.
  - rewrite E, S, Qmult_1_r. assert (G : (d # N) <= (- most (opposite n) q # N) - (most n p # N)).
    { assert (G : (d # N) <= (- most (opposite n) q - most n p # N)) by (apply frac_le, L).
      unfold Z.sub in G. rewrite frac_plus in G. assert (X : forall i, (- i # N) == - (i # N)) by (intro i; unfold Qeq, Qopp; cbn [Qnum Qden]; ring).
      rewrite (X (most n p)) in G. lra. }
    apply sq_le; [apply frac_nonneg, D0|exact G].
Qed.

(* Two solids at distance d *)
Definition sound (x : item) : Prop := (0 <= reach x)%Z /\ extents x = map (extent (parts x)) axes /\ forall p, In p (parts x) -> (0 <= snd p)%Z.
Definition regions (x : item) : list region := map (fun p => (fst p, (reach x # N) + snd p)) (map region_of (parts x)).
Lemma numbered_in {A} (l : list A) a : In a l -> exists i, In (i, a) (numbered l).
Proof.
  unfold numbered. generalize 0%nat. induction l as [|b l IH]; intros k I; [destruct I|]. cbn [length seq combine].
  destruct I as [->|I]; [exists k; left; reflexivity|]. destruct (IH (S k) I) as (i & J). exists i. right. exact J.
Qed.
Lemma is_apart_between d normals x y s : sound x -> sound y -> (0 <= d)%Z -> is_apart d normals x y = true -> s == d # N ->
  forall p q, In p (regions x) -> In q (regions y) -> gap_between s p q.
Proof.
  intros (Rx & Ex & Px) (Ry & Ey & Py) D0 H Es p' q' Ip Iq.
  apply in_map_iff in Ip as (p1 & <- & Ip). apply in_map_iff in Ip as (p & <- & Ip).
  apply in_map_iff in Iq as (q1 & <- & Iq). apply in_map_iff in Iq as (q & <- & Iq). cbn [fst snd region_of].
  pose proof (Px p Ip) as P0. pose proof (Py q Iq) as Q0.
  assert (E : s + ((reach x # N) + (snd p # N)) + ((reach y # N) + (snd q # N)) == d + reach x + reach y + snd p + snd q # N).
  { rewrite Es, !frac_plus. ring. }
  unfold is_apart in H. cbv zeta in H. apply orb_prop in H as [H|H].
  - rewrite Ex, Ey in H. unfold box_gap, axes in H. cbn [map] in H.
    assert (G : exists n, In n axes /\ (d + reach x + reach y <= - extent (parts y) (opposite n) - extent (parts x) n)%Z).
    { apply orb_prop in H as [H|H]; [apply orb_prop in H as [H|H]; [apply orb_prop in H as [H|H]|]|]; apply Z.leb_le in H.
      - exists (1, 0)%Z. split; [left; reflexivity|exact H].
      - exists (0, 1)%Z. split; [right; left; reflexivity|exact H].
      - exists (-1, 0)%Z. split; [right; right; left; reflexivity|exact H].
      - exists (0, -1)%Z. split; [right; right; right; left; reflexivity|exact H]. }
    destruct G as (n & I & G). apply (axis_between n (d + reach x + reach y + snd p + snd q)); [exact I|lia| |exact E].
    pose proof (extent_spec (parts x) n p Ip). pose proof (extent_spec (parts y) (opposite n) q Iq). lia.
  - rewrite forallb_forall in H. destruct (numbered_in _ p Ip) as (i & Ji). specialize (H _ Ji). rewrite forallb_forall in H.
    destruct (numbered_in _ q Iq) as (j & Jj). specialize (H _ Jj). apply some_exists in H as (n & _ & H). unfold gap in H. cbn [fst snd] in H.
    exact (far_between _ n (fst p) (fst q) s _ _ H E).
Qed.
Lemma regions_nonneg x : sound x -> forall p, In p (regions x) -> 0 <= snd p.
Proof.
  intros (R & _ & P) p' I. apply in_map_iff in I as (p1 & <- & I). apply in_map_iff in I as (p & <- & I). cbn [snd region_of].
  pose proof (frac_nonneg _ R). pose proof (frac_nonneg _ (P p I)). lra.
Qed.

(* An item covers a set: each point of the set is within the radius of a piece. *)
Definition covers_set (x : item) (S : qpoint -> Prop) : Prop := forall y, S y -> in_some (map region_of (parts x)) y.
Lemma cover_known x e S T : sound x -> e == reach x # N -> covers_set x S -> Statements.known_to e S T -> forall z, T z -> in_some (regions x) z.
Proof.
  intros (R & _ & P) E C K z Tz. apply (within_union (reach x # N) (map region_of (parts x)) S z).
  - apply frac_nonneg, R.
  - intros p' I. apply in_map_iff in I as (p & <- & I). cbn [snd region_of]. apply frac_nonneg, P, I.
  - exact C.
  - intros d D. apply (K z Tz). lra.
Qed.
Theorem apart_keeps d normals x y s e e' S T S' T' : sound x -> sound y -> (0 <= d)%Z -> s == d # N -> is_apart d normals x y = true ->
  e == reach x # N -> e' == reach y # N -> covers_set x S -> covers_set y T -> Statements.known_to e S S' -> Statements.known_to e' T T' ->
  Statements.keeps s S' T'.
Proof.
  intros X Y D0 Es H E E' CS CT KS KT. apply (keeps_regions s (regions x) (regions y)).
  - rewrite Es. apply frac_nonneg, D0.
  - apply regions_nonneg, X.
  - apply regions_nonneg, Y.
  - exact (cover_known x e S S' X E CS KS).
  - exact (cover_known y e' T T' Y E' CT KT).
  - exact (is_apart_between d normals x y s X Y D0 H Es).
Qed.
Lemma keeps_sym s S T : Statements.keeps s S T -> Statements.keeps s T S.
Proof.
  intros (A & B). split.
  - intros (z & X & Y). apply A. exists z. auto.
  - intros y z Y Z. specialize (B z y Z Y). unfold Statements.dist2 in *. lra.
Qed.
Lemma make_sound ps e : (0 <= e)%Z -> (forall p, In p ps -> (0 <= snd p)%Z) -> sound (make_item ps e).
Proof. intros E P. split; [exact E|]. split; [reflexivity|exact P]. Qed.
Lemma flat_sound (ps : list ring) e : (0 <= e)%Z -> sound (make_item (map (fun p => (p, 0%Z)) ps) e).
Proof. intro E. apply make_sound; [exact E|]. intros p I. apply in_map_iff in I as (q & <- & _). cbn. lia. Qed.
End Regions.

Lemma amount_spec N q : is_amount (Zpos N) q = true -> (0 <= int (Zpos N) q)%Z /\ q == int (Zpos N) q # N.
Proof.
  unfold is_amount. intro H. apply andb_prop in H as (A & B). apply Qle_bool_iff in A. apply int_at in B.
  assert (P : 0 < inject_Z (Zpos N)) by (apply inject_pos; reflexivity). unfold at_ in B. split.
  - rewrite Zle_Qle. change (inject_Z 0) with 0. rewrite <- B. apply Qmult_le_0_compat; lra.
  - apply (Qmult_inj_r _ _ (inject_Z (Zpos N))); [lra|]. rewrite B. unfold Qeq, Qmult, inject_Z. cbn [Qnum Qden]. rewrite !Pos.mul_1_r. ring.
Qed.

(* The frame *)
Section Frame.
Variables (N : positive) (x0 y0 x1 y1 : Z) (C : list Statements.ring) (out : list ring).
Definition beyond_plane (h : pt * Z) (y : qpoint) : Prop := (snd h # N) <= along (qnormal (fst h)) y.
Hypothesis IC : all_integral (Zpos N) C = true.
Hypothesis Fx : (x0 < x1)%Z.
Hypothesis Fy : (y0 < y1)%Z.
Hypothesis FO : fans out.
Hypothesis Cn : cancel (flat_map edges out ++ flat_map edges (int_rings (Zpos N) C)) (edges (box_ring x0 y0 x1 y1)) = true.
Lemma frame_inside z : (forall h, In h (planes (x0, y0, x1, y1)) -> ~ beyond_plane h z) ->
  (forall P, In P out -> Statements.winding [qring N P] z <> 1%Z) -> Statements.inside C z.
Proof.
  intros NB NP. unfold Statements.inside. destruct (pat_common z z) as (k & v & _ & K & V & _).
  rewrite (winding_W (Zpos N) k C (int_rings (Zpos N) C) z v); [|reflexivity|exact K|apply int_rings_at, IC|exact V].
  pose proof (cancel_wind k _ _ (grow (Zpos N) v) K Cn) as E. rewrite map_app, wind_app in E.
  fold (W k out (grow (Zpos N) v)) (W k (int_rings (Zpos N) C) (grow (Zpos N) v)) in E. rewrite W_count in E.
  pose proof (box_wind k x0 y0 x1 y1 (grow (Zpos N) v) K Fx Fy) as B. unfold W at 1 in B. cbn [flat_map] in B.
  rewrite app_nil_r in B. rewrite B in E. clear B.
  destruct (count_some k out (grow (Zpos N) v) K FO) as (C1 & C2).
  assert (C3 : ~ (1 <= count k out (grow (Zpos N) v))%Z).
  { intro H. destruct (C2 H) as (P & IP & X). apply (NP P IP). rewrite (piece_at N k P z v K V). exact X. }
  assert (Scale : forall a q n, at_ k q n -> ((a # N) <= q <-> (k * a <= Zpos N * n)%Z) /\ (q <= (a # N) <-> (Zpos N * n <= k * a)%Z)).
  { intros a q n A. assert (X : at_ (k * Zpos N) (a # N) (k * a)).
    { unfold at_, Qeq, Qmult, inject_Z. cbn [Qnum Qden]. rewrite Pos.mul_1_r. ring. }
    assert (Y : at_ (k * Zpos N) q (Zpos N * n)) by (unfold at_ in *; rewrite !inject_Z_mult, <- A; ring).
    split; apply (at_le (k * Zpos N)); try assumption; nia. }
  destruct V as (Vx & Vy). destruct (Scale x0 _ _ Vx) as (_ & S1). destruct (Scale x1 _ _ Vx) as (S2 & _).
  destruct (Scale y0 _ _ Vy) as (_ & S3). destruct (Scale y1 _ _ Vy) as (S4 & _).
  pose proof (NB ((1, 0)%Z, x1) (or_introl eq_refl)) as B1. pose proof (NB ((0, 1)%Z, y1) (or_intror (or_introl eq_refl))) as B2.
  pose proof (NB ((-1, 0)%Z, (- x0)%Z) (or_intror (or_intror (or_introl eq_refl)))) as B3.
  pose proof (NB ((0, -1)%Z, (- y0)%Z) (or_intror (or_intror (or_intror (or_introl eq_refl))))) as B4.
  unfold beyond_plane, along, qnormal in *. cbn [fst snd] in *.
  change (inject_Z 1) with 1 in *. change (inject_Z 0) with 0 in *. change (inject_Z (-1)) with (- (1)) in *.
  assert (X : forall i, (- i # N) == - (i # N)) by (intro i; unfold Qeq, Qopp; cbn [Qnum Qden]; ring). rewrite X in B3, B4.
  assert (D1 : ~ (x1 # N) <= fst z) by (intro L; apply B1; lra). assert (D2 : ~ (y1 # N) <= snd z) by (intro L; apply B2; lra).
  assert (D3 : ~ fst z <= (x0 # N)) by (intro L; apply B3; lra). assert (D4 : ~ snd z <= (y0 # N)) by (intro L; apply B4; lra).
  rewrite S2 in D1. rewrite S4 in D2. rewrite S1 in D3. rewrite S3 in D4. unfold grow in E. cbn [fst snd] in E.
  destruct (Z.leb_spec (k * x0) (Zpos N * fst v)); [|lia]. destruct (Z.ltb_spec (Zpos N * fst v) (k * x1)); [|lia].
  destruct (Z.leb_spec (k * y0) (Zpos N * snd v)); [|lia]. destruct (Z.ltb_spec (Zpos N * snd v) (k * y1)); [|lia].
  cbn [andb] in E. unfold grow in *. lia.
Qed.
End Frame.

Lemma plane_between N f h q d s (r r' : Q) : In h (planes f) -> (0 <= d)%Z -> (most (fst h) q + d <= snd h)%Z ->
  s + r + r' == d # N -> gap_between s (beyond_plane N h, r) (core N q, r').
Proof.
  intros I D0 L E. set (n := fst h) in *. exists (qnormal (opposite n)), (- snd h # N), (- most n q # N). cbn [fst snd].
  assert (X : forall i, (- i # N) == - (i # N)) by (intro i; unfold Qeq, Qopp; cbn [Qnum Qden]; ring).
  assert (F : forall y, along (qnormal (opposite n)) y == - along (qnormal n) y) by (intro y; unfold along, qnormal, opposite; cbn [fst snd]; rewrite !inject_Z_opp; ring).
  assert (S : square_of (qnormal (opposite n)) == 1).
  { destruct f as [[[l b] r0] t]. destruct I as [J|[J|[J|[J|[]]]]]; unfold n; rewrite <- J; reflexivity. }
  repeat split.
  - intros y Y. unfold beyond_plane in Y. fold n in Y. rewrite F, X. lra.
  - intros y Y. assert (H : along (qnormal n) y <= most n q # N) by (apply Y; intros v V; apply most_spec, V). rewrite F, X. lra.
  - rewrite S. reflexivity.
  - apply frac_le. lia.
  - rewrite E, S, Qmult_1_r. apply sq_le; [apply frac_nonneg, D0|].
    assert (G : (most n q + d # N) <= (snd h # N)) by (apply frac_le, L). rewrite frac_plus in G. rewrite !X. lra.
Qed.

Lemma simple_rings N rs ps : all_integral (Zpos N) rs = true -> simple_solid {| rings := int_rings (Zpos N) rs; pieces := ps |} = true ->
  Statements.simple rs /\ exists z, Statements.inside rs z.
Proof.
  intros I S. pose proof (simple_shape _ S) as (W01 & z & Z1). cbn [rings] in *. pose proof (int_rings_at (Zpos N) _ I) as Ra.
  assert (In1 : Statements.inside rs (third N z)).
  { unfold Statements.inside. rewrite <- Z1, <- W_edges. apply (winding_at (3 * Zpos N)); [lia|apply rings_grow, Ra|apply third_at]. }
  split; [split|exists (third N z); exact In1].
  - intro q. destruct (pat_common q q) as (k & v & _ & K & V & _).
    rewrite (winding_W (Zpos N) k _ _ q v eq_refl K Ra V). apply W01, K.
  - apply (interior_of_point _ _ In1).
Qed.
Lemma nth_combine {A B} (a : list A) (b : list B) i x : length a = length b -> nth_error a i = Some x -> exists y, nth_error (combine a b) i = Some (x, y).
Proof.
  revert b i. induction a as [|u a IH]; intros [|v b] [|i] L E; try discriminate; cbn in *.
  - injection E as ->. exists v. reflexivity.
  - apply IH; [lia|exact E].
Qed.
Lemma nth_numbered {A} (m : list A) i x : nth_error m i = Some x -> exists k, nth_error (numbered m) i = Some (k, x).
Proof.
  unfold numbered. generalize 0%nat. revert i. induction m as [|u m IH]; intros [|i] k E; try discriminate; cbn in *.
  - injection E as ->. exists k. reflexivity.
  - apply IH, E.
Qed.
Lemma pairs_nth {A} (R : A -> A -> Prop) m : ForallOrdPairs R m -> forall i j a b, (i < j)%nat ->
  nth_error m i = Some a -> nth_error m j = Some b -> R a b.
Proof.
  induction 1 as [|x m H _ IH]; intros i j a b L E F; [destruct i; discriminate|].
  destruct j as [|j]; [lia|]. destruct i as [|i]; cbn in *.
  - injection E as ->. rewrite Forall_forall in H. apply H. eapply nth_error_In, F.
  - apply (IH i j); [lia|assumption|assumption].
Qed.

Section Sound.
Variables (normals : nat -> nat -> nat -> nat -> pt) (outside_normals : Z -> nat -> nat -> nat -> pt).
Variables (l : Statements.layout) (c : certificate).
Let N := denominator c.

Lemma greatest {A} (f : A -> Z) a l' : exists v, In v (a :: l') /\ forall w, In w (a :: l') -> (f w <= f v)%Z.
Proof.
  induction l' as [|b l' (v & V & M)]; [exists a; split; [left; reflexivity|intros w [<-|[]]; lia]|].
  destruct (Z.le_ge_cases (f v) (f b)) as [L|L].
  - exists b. split; [right; left; reflexivity|]. intros w [<-|[<-|I]]; [specialize (M a (or_introl eq_refl)); lia|lia|specialize (M w (or_intror I)); lia].
  - exists v. split; [destruct V as [<-|V]; [left; reflexivity|right; right; exact V]|]. intros w [<-|[<-|I]]; [apply M; left; reflexivity|lia|apply M; right; exact I].
Qed.
Lemma hull_core ps z : all_integral (Zpos N) [ps] = true -> Statements.hull ps z -> core N (map (int_point (Zpos N)) ps) z.
Proof.
  intros I H n a B. unfold along, qnormal. cbn [fst snd]. apply H. intros p P.
  pose proof (B _ (in_map (int_point (Zpos N)) ps p P)) as L.
  unfold all_integral in I. cbn [forallb] in I. rewrite andb_true_r, forallb_forall in I. pose proof (I p P) as Ip. apply andb_prop in Ip as (I1 & I2).
  pose proof (qdot_at n (Zpos N) p (int_point (Zpos N) p) (conj (int_at _ _ I1) (int_at _ _ I2))) as A. unfold at_ in A.
  assert (Pn : 0 < inject_Z (Zpos N)) by (apply inject_pos; reflexivity).
  assert (Q0 : (a # N) * inject_Z (Zpos N) == inject_Z a) by (unfold Qeq, Qmult, inject_Z; cbn [Qnum Qden]; rewrite !Pos.mul_1_r; ring).
  rewrite Zle_Qle, <- A, <- Q0 in L. apply Qmult_le_r in L; [exact L|exact Pn].
Qed.

Lemma figure_spec f ps : is_solid_figure c (f, ps) = true -> sound (item_of c (f, ps)) /\
  Statements.error f == reach (item_of c (f, ps)) # N /\ covers_set N (item_of c (f, ps)) (Statements.drawn f) /\ Statements.is_shape f.
Proof.
  unfold is_solid_figure. cbn [fst snd]. intro H. apply andb_prop in H as (H & S). apply andb_prop in H as (H & R). apply andb_prop in H as (E & I).
  destruct (amount_spec N _ E) as (E1 & E2). rewrite forallb_forall in R.
  assert (R0 : forall p, In p (Statements.rounded f) -> 0 <= snd p).
  { intros p Ip. specialize (R p Ip). apply andb_prop in R as (R & _). apply andb_prop in R as (_ & R). apply andb_prop in R as (R & _).
    apply Qle_bool_iff, R. }
  assert (S' : (Statements.outline f = [] /\ ps = [] /\ Statements.rounded f <> []) \/
    (Statements.outline f <> [] /\ simple_solid {| rings := int_rings (Zpos N) (Statements.outline f); pieces := ps |} = true)).
  { fold N in S. destruct (Statements.outline f) as [|r0 rest]; [left|right; split; [discriminate|exact S]].
    destruct ps; [|discriminate]. destruct (Statements.rounded f); [discriminate|]. repeat split. discriminate. }
  split; [|split; [|split]].
  - apply make_sound; [exact E1|]. intros p Ip. cbn [fst snd] in Ip. apply in_app_or in Ip as [Ip|Ip]; apply in_map_iff in Ip as (q & <- & Iq); cbn [snd]; [lia|].
    specialize (R q Iq). apply andb_prop in R as (R & _). apply andb_prop in R as (_ & R). apply (amount_spec N _ R).
  - exact E2.
  - intros y Y K. unfold item_of in K. cbn [fst snd make_item parts] in K.
    assert (Kl : forall p, In p ps -> ~ core N p y).
    { intros p Ip Cp. apply (K (region_of N (p, 0%Z))); [apply in_map, in_or_app; left; exact (in_map (fun p => (p, 0%Z)) ps p Ip)|].
      apply within_self; [apply frac_nonneg; cbn; lia|exact Cp]. }
    destruct Y as [Y|(p & Ip & Y)].
    + destruct S' as [(O & _)|(_ & S')]; [unfold Statements.inside in Y; rewrite O in Y; discriminate|].
      apply (count_pieces N {| rings := int_rings (Zpos N) (Statements.outline f); pieces := ps |} _ y S' I eq_refl) in Y as (P & IP & W).
      apply (Kl P IP), piece_core; [exact (proj1 (proj2 (simple_spec _ S')) P IP)|exact W].
    + specialize (R _ Ip). apply andb_prop in R as (R & _). apply andb_prop in R as (R1 & R2).
      destruct (amount_spec N _ R2) as (R3 & R4).
      apply (K (region_of N (map (int_point (Zpos N)) (fst p), int (Zpos N) (snd p)))).
      * apply in_map, in_or_app. right. exact (in_map (fun p => (map (int_point (Zpos N)) (fst p), int (Zpos N) (snd p))) _ _ Ip).
      * cbn [region_of fst snd]. intros d D. assert (Dr : snd p < d) by (apply (Qle_lt_trans _ (int (Zpos N) (snd p) # N)); [rewrite <- R4; apply Qle_refl|exact D]).
        apply (within_more _ _ _ y (fun z Hz => hull_core _ z R1 Hz) Y d Dr).
  - destruct S' as [(O & _ & Ne)|(_ & S')].
    + split; [left; exact O|]. destruct (Statements.rounded f) as [|p0 rest] eqn:Ro; [congruence|]. specialize (R p0 (or_introl eq_refl)).
      apply andb_prop in R as (_ & R). destruct p0 as [[|q0 qs] rd]; [discriminate R|].
      exists q0. right. exists (q0 :: qs, rd). rewrite Ro. split; [left; reflexivity|]. apply within_self; [apply R0; left; reflexivity|].
      intros a b d B. apply B. left. reflexivity.
    + destruct (simple_rings N _ _ I S') as (Si & z & Z). split; [right; exact Si|exists z; left; exact Z].
Qed.

Lemma parts_some f ps : is_solid_figure c (f, ps) = true -> parts (item_of c (f, ps)) <> [].
Proof.
  intro H. destruct (figure_spec f ps H) as (_ & _ & Cov & _ & z & Z). intro E. apply (Cov z Z). rewrite E. intros p [].
Qed.

Lemma all_apart_spec d m : all_apart d normals m = true -> ForallOrdPairs (fun x y => exists f, is_apart d f (snd x) (snd y) = true) m.
Proof.
  induction m as [|(a, x) m IH]; cbn [all_apart]; intro H; constructor; apply andb_prop in H as (H & H2); [|apply IH, H2].
  rewrite forallb_forall in H. rewrite Forall_forall. intros y I. eexists. exact (H y I).
Qed.

(* A part that keeps a distance from the complement of the sheet *)
Definition is_kept (d : Z) (f : Statements.figure) (x : item) : Prop :=
  forall s (S U : qpoint -> Prop), s == d # N -> (forall z, S z -> in_some (regions N x) z) -> Statements.outside_of f U -> Statements.keeps s S U.
Lemma core_along p y n : core N p y -> exists v, In v p /\ along n y <= along n (qpt N v).
Proof.
  intro C. destruct (at_common (fst n) (snd n) 0 0) as (k & a & b & _ & _ & K & A & A' & _). unfold at_ in A, A'.
  assert (K0 : 0 < inject_Z k) by (apply inject_pos, K).
  assert (G : exists v, In v p /\ forall v', In v' p -> (dot (a, b) v' <= dot (a, b) v)%Z).
  { destruct p as [|v0 p]; [exfalso|exact (greatest (dot (a, b)) v0 p)]. pose proof (C (0, 0)%Z (-1)%Z (fun v H => match H with end)) as H.
    unfold along, qnormal in H. cbn [fst snd] in H. assert (E : inject_Z 0 * fst y + inject_Z 0 * snd y == 0) by (change (inject_Z 0) with 0; ring).
    rewrite E in H. unfold Qle in H. cbn in H. lia. }
  destruct G as (v & V & M). exists v. split; [exact V|]. pose proof (C (a, b) (dot (a, b) v) M) as H.
  assert (F : (dot (a, b) v # N) == inject_Z a * (fst v # N) + inject_Z b * (snd v # N)).
  { unfold dot. cbn [fst snd]. rewrite frac_plus. unfold Qeq, Qplus, Qmult, inject_Z. cbn [Qnum Qden]. rewrite ?Pos.mul_1_l, ?Pos2Z.inj_mul. ring. }
  rewrite F in H. unfold along, qnormal, qpt in *. cbn [fst snd] in *. rewrite <- A, <- A' in H. apply (Qmult_le_r _ _ (inject_Z k)); [exact K0|]. lra.
Qed.
Lemma rounded_keeps e ps r x d : (0 <= d)%Z -> is_amount (Zpos N) e = true -> ps <> [] ->
  is_amount (Zpos N) r = true -> sound x -> parts x <> [] -> in_rounded c (d + int (Zpos N) e) ps (int (Zpos N) r) x = true ->
  is_kept d {| Statements.outline := []; Statements.rounded := [(ps, r)]; Statements.error := e |} x.
Proof.
  intros D0 Ae Ip Ar Sx Ne H s S U Es Cov K. pose proof Sx as (R0 & _ & Rp). destruct (amount_spec N _ Ae) as (E0 & E1). destruct (amount_spec N _ Ar) as (Q0 & Q1).
  unfold in_rounded in H. rewrite forallb_forall in H. cbn [Statements.error] in *.
  assert (Room : forall q, In q (parts x) -> (0 <= int (Zpos N) r - snd q - reach x - (d + int (Zpos N) e))%Z /\
    forall v, In v (fst q) -> near_hull (int (Zpos N) r - snd q - reach x - (d + int (Zpos N) e) # N) ps (qpt N v) = true).
  { intros q Iq. specialize (H q Iq). cbv zeta in H. apply andb_prop in H as (H1 & H2). apply Z.leb_le in H1. split; [exact H1|].
    rewrite forallb_forall in H2. exact H2. }
  apply (keeps_hull s r e ps (regions N x) S (fun z => ~ Statements.drawn {| Statements.outline := []; Statements.rounded := [(ps, r)]; Statements.error := e |} z) U).
  - rewrite Es. apply frac_nonneg, D0.
  - rewrite E1. apply frac_nonneg, E0.
  - destruct (parts x) as [|q qs] eqn:Px; [congruence|]. destruct (Room q (or_introl eq_refl)) as (L & _).
    specialize (Rp q (or_introl eq_refl)).
    assert (X : (d # N) + (int (Zpos N) e # N) <= (int (Zpos N) r # N)) by (rewrite <- frac_plus; apply frac_le; lia). lra.
  - exact Cov.
  - intros q' Iq'. split; [apply (regions_nonneg N x Sx), Iq'|].
    apply in_map_iff in Iq' as (q1 & <- & Iq'). apply in_map_iff in Iq' as (q & <- & Iq). cbn [fst snd region_of].
    destruct (Room q Iq) as (L & B). exists (int (Zpos N) r - snd q - reach x - (d + int (Zpos N) e) # N). split; [apply frac_nonneg, L|]. split.
    + assert (X : (int (Zpos N) r - snd q - reach x - (d + int (Zpos N) e) # N) + ((reach x # N) + (snd q # N)) + (d # N) + (int (Zpos N) e # N) <= (int (Zpos N) r # N))
        by (rewrite <- !frac_plus; apply frac_le; lia). lra.
    + intros y Y. apply (within_hull ps (map (qpt N) (fst q))); [exact Ip|apply frac_nonneg, L| |].
      * intros v V. apply in_map_iff in V as (w & <- & W). exact (near_hull_point _ _ _ (B w W)).
      * intro n. destruct (core_along (fst q) y n Y) as (v & V & G). exists (qpt N v). split; [exact (in_map (qpt N) _ _ V)|exact G].
  - intros y Ny W. apply Ny. right. exists (ps, r). split; [left; reflexivity|exact W].
  - exact K.
Qed.
Lemma rings_keep f x d : (0 <= d)%Z -> Statements.rounded f = [] -> sound x -> forall normals',
  (let '(x0, y0, x1, y1) := frame c in let e := int (Zpos N) (Statements.error f) in let out := make_item (map (fun p => (p, 0%Z)) (outside_pieces c)) e in
    is_amount (Zpos N) (Statements.error f) && ((x0 <? x1)%Z && (y0 <? y1)%Z && all_integral (Zpos N) (Statements.outline f) && forallb is_convex (outside_pieces c) &&
    cancel (flat_map edges (outside_pieces c) ++ flat_map edges (int_rings (Zpos N) (Statements.outline f))) (edges (box_ring x0 y0 x1 y1))) &&
    (within_frame (d + e) (frame c) x && is_apart d normals' out x)) = true -> is_kept d f x.
Proof.
  intros D0 Ro P1 normals' H s S U Es Cov K. destruct (frame c) as [[[x0 y0] x1] y1] eqn:Fr. cbv zeta in H.
  set (C := Statements.outline f) in *. set (e := Statements.error f) in *.
  apply andb_prop in H as (H & W). apply andb_prop in W as (Wf & Ap). apply andb_prop in H as (Ae & H).
  apply andb_prop in H as (H & X0). apply andb_prop in H as (H & X1). apply andb_prop in H as (H & X2). apply andb_prop in H as (Hs & X4).
  rewrite forallb_forall in X1. pose proof (fun p I => is_convex_fan p (X1 p I)) as FX. apply Z.ltb_lt in Hs, X4.
  destruct (amount_spec N _ Ae) as (E0 & E1). set (out := make_item _ _) in Ap.
  assert (So' : sound out) by (apply flat_sound, E0). apply keeps_sym.
  set (base := map (region_of N) (parts out) ++ map (fun h => (beyond_plane N h, 0)) (planes (x0, y0, x1, y1))).
  apply (keeps_regions _ (map (fun p => (fst p, (reach out # N) + snd p)) base) (regions N x)).
  - rewrite Es. apply frac_nonneg, D0.
  - intros p' Ip. apply in_map_iff in Ip as (p & <- & Ip). cbn [snd]. apply in_app_or in Ip as [Ip|Ip]; apply in_map_iff in Ip as (q & <- & Iq); cbn [snd region_of].
    + destruct So' as (_ & _ & So'). pose proof (frac_nonneg N _ (So' q Iq)). pose proof (frac_nonneg N (reach out) E0). lra.
    + pose proof (frac_nonneg N (reach out) E0). lra.
  - apply regions_nonneg, P1.
  - intros z Uz. apply (within_union (reach out # N) base (fun y => ~ Statements.drawn f y) z).
    + apply frac_nonneg, E0.
    + intros p Ip. apply in_app_or in Ip as [Ip|Ip]; apply in_map_iff in Ip as (q & <- & Iq); cbn [snd region_of]; [|lra].
      destruct So' as (_ & _ & So'). apply frac_nonneg, So', Iq.
    + intros y Ny Ky. apply Ny. left. apply (frame_inside N x0 y0 x1 y1 C (outside_pieces c) X2 Hs X4 FX X0).
      * intros h Ih Bh. apply (Ky (beyond_plane N h, 0)); [apply in_or_app; right; exact (in_map (fun h => (beyond_plane N h, 0)) _ h Ih)|].
        apply within_self; [cbn; lra|exact Bh].
      * intros P IP Wp. apply (Ky (region_of N (P, 0%Z))).
        -- apply in_or_app. left. apply in_map. unfold out, make_item. cbn [parts]. exact (in_map (fun p => (p, 0%Z)) _ P IP).
        -- apply within_self; [apply frac_nonneg; cbn; lia|]. apply piece_core; [apply FX, IP|exact Wp].
    + intros t Dd. apply (K z Uz). fold e. rewrite E1. exact Dd.
  - exact Cov.
  - intros p' q' Ip Iq. apply in_map_iff in Ip as (p & <- & Ip). apply in_app_or in Ip as [Ip|Ip].
    + apply (is_apart_between N d _ out x _ So' P1 D0 Ap Es); [|exact Iq].
      exact (in_map (fun p => (fst p, (reach out # N) + snd p)) _ p Ip).
    + apply in_map_iff in Ip as (h & <- & Ih). cbn [fst snd].
      apply in_map_iff in Iq as (q1 & <- & Iq). apply in_map_iff in Iq as (q & <- & Iq). cbn [fst snd region_of].
      unfold within_frame in Wf. rewrite forallb_forall in Wf. specialize (Wf q Iq). rewrite forallb_forall in Wf. specialize (Wf h Ih). apply Z.leb_le in Wf.
      destruct P1 as (R0 & _ & Pq). specialize (Pq q Iq).
      apply (plane_between N _ h (fst q) (d + int (Zpos N) e + reach x + snd q) _ _ _ Ih).
      * lia.
      * lia.
      * rewrite Es, !frac_plus. unfold out, make_item. cbn [reach]. fold e. lra.
Qed.
Lemma check_sheet_spec f d l' i x : check_sheet outside_normals c f d l' = true -> (0 <= d)%Z -> In (i, x) l' -> sound x -> parts x <> [] -> is_kept d f x.
Proof.
  unfold check_sheet. cbv zeta. intros H D0 I Sx Ne. apply andb_prop in H as (Ae & H). fold N in Ae, H.
  assert (G : Statements.rounded f = [] -> (let '(x0, y0, x1, y1) := frame c in
      let out := make_item (map (fun p : ring => (p, 0%Z)) (outside_pieces c)) (int (Zpos N) (Statements.error f)) in
      (x0 <? x1)%Z && (y0 <? y1)%Z && all_integral (Zpos N) (Statements.outline f) && forallb is_convex (outside_pieces c) &&
      cancel (flat_map edges (outside_pieces c) ++ flat_map edges (int_rings (Zpos N) (Statements.outline f))) (edges (box_ring x0 y0 x1 y1)) &&
      forallb (fun x => within_frame (d + int (Zpos N) (Statements.error f)) (frame c) (snd x) && is_apart d (fun i j => outside_normals (-1) i (fst x) j) out (snd x)) l') = true -> is_kept d f x).
  { intros Ro H'. apply (rings_keep f x d D0 Ro Sx (fun a b => outside_normals (-1) a i b)). cbv zeta. destruct (frame c) as [[[x0 y0] x1] y1] eqn:Fr.
    apply andb_prop in H' as (H' & W). rewrite forallb_forall in W. specialize (W _ I). cbn [fst snd] in W. rewrite Ae, H', W. reflexivity. }
  destruct f as [rs ro e]. cbn [Statements.outline Statements.rounded Statements.error] in *.
  destruct rs as [|r0 rs]; [destruct ro as [|[[|p ps] r] [|]]|destruct ro]; try discriminate; try (apply G; [reflexivity|exact H]).
  apply andb_prop in H as (Ar & F). rewrite forallb_forall in F. specialize (F _ I). cbn [snd] in F.
  exact (rounded_keeps e (p :: ps) r x d D0 Ae ltac:(discriminate) Ar Sx Ne F).
Qed.

Theorem layout_sound : check_layout normals outside_normals l c = true -> Statements.valid l.
Proof.
  unfold check_layout. intro H.
  apply andb_prop in H as (H & Hs). apply andb_prop in H as (H & Ho). apply andb_prop in H as (H & Ha). apply andb_prop in H as (H & So).
  apply andb_prop in H as (H & Sp). apply andb_prop in H as (H & Hm). apply andb_prop in H as (H & Hd). apply andb_prop in H as (H & Lo).
  apply andb_prop in H as (H & Sk). apply andb_prop in H as (H & Lk). apply andb_prop in H as (H & Lp). apply andb_prop in H as (H & Su).
  apply andb_prop in H as (Wf & Al). rewrite forallb_forall in Al, So, Sp, Sk. apply Nat.eqb_eq in Lp, Lo, Lk.
  destruct (amount_spec N _ Hm) as (M0 & M1). destruct (amount_spec N _ Hd) as (D0 & D1).
  assert (At : forall i x, nth_error (Statements.placements l) i = Some x -> exists ps k, In (Statements.placed l x, ps) (solid_parts l c) /\
    nth_error (items l c) i = Some (k, item_of c (Statements.placed l x, ps))).
  { intros i x E. destruct (nth_combine (map (Statements.placed l) (Statements.placements l)) (part_pieces c) i (Statements.placed l x)) as (ps & F).
    { rewrite map_length. exact Lp. }
    { rewrite nth_error_map, E. reflexivity. }
    exists ps. fold (solid_parts l c) in F.
    destruct (nth_numbered (map (item_of c) (solid_parts l c)) i (item_of c (Statements.placed l x, ps))) as (k & G).
    { rewrite nth_error_map, F. reflexivity. }
    exists k. split; [eapply nth_error_In, F|exact G]. }
  assert (In_ : forall x, In x (Statements.placements l) -> exists ps k, In (Statements.placed l x, ps) (solid_parts l c) /\
    In (k, item_of c (Statements.placed l x, ps)) (items l c)).
  { intros x I. apply In_nth_error in I as (i & I). destruct (At i x I) as (ps & k & A & B). exists ps, k. split; [exact A|eapply nth_error_In, B]. }
  assert (Obs : forall o, In o (Statements.obstacles l) -> exists ps i, In (fst o, ps) (solid_obstacles l c) /\ In (i, (item_of c (fst o, ps), snd o)) (obstacle_items l c)).
  { intros o I. apply In_nth_error in I as (i & I).
    destruct (nth_combine (map fst (Statements.obstacles l)) (obstacle_pieces c) i (fst o)) as (ps & F); [rewrite map_length; exact Lo|rewrite nth_error_map, I; reflexivity|].
    fold (solid_obstacles l c) in F. exists ps.
    assert (Len : length (map (item_of c) (solid_obstacles l c)) = length (map snd (Statements.obstacles l))).
    { unfold solid_obstacles. rewrite !map_length, combine_length, map_length. lia. }
    destruct (nth_combine _ (map snd (Statements.obstacles l)) i (item_of c (fst o, ps)) Len) as (q & G); [rewrite nth_error_map, F; reflexivity|].
    assert (Q0 : q = snd o).
    { pose proof (nth_error_In _ _ G) as J. clear J. assert (H1 : nth_error (map snd (Statements.obstacles l)) i = Some (snd o)) by (rewrite nth_error_map, I; reflexivity).
      enough (H2 : nth_error (map snd (Statements.obstacles l)) i = Some q) by congruence.
      revert G. clear. generalize (map (item_of c) (solid_obstacles l c)) (map snd (Statements.obstacles l)). intros a b. revert b i.
      induction a as [|u a IH]; intros [|v b] [|i] E; try discriminate; cbn in *; [injection E; congruence|exact (IH b i E)]. }
    subst q. destruct (nth_numbered _ i _ G) as (k & K). exists k. split; [eapply nth_error_In, F|eapply nth_error_In, K]. }
  constructor.
  - apply is_well_formed_spec, Wf.
  - split; [rewrite Forall_forall; intros x I; apply check_allowed_spec, Al, I|apply check_supply_spec, Su].
  - split; [|split]; rewrite Forall_forall.
    + intros k I. apply (in_map Statements.form) in I. apply In_nth_error in I as (i & I).
      destruct (nth_combine _ (kind_pieces c) i (Statements.form k) ltac:(rewrite map_length; exact Lk) I) as (ps & F).
      apply (figure_spec _ ps (Sk _ (nth_error_In _ _ F))).
    + intros x I. destruct (In_ x I) as (ps & k & A & _). apply (figure_spec _ ps (Sp _ A)).
    + intros o I. destruct (Obs o I) as (ps & i & A & _). apply (figure_spec _ ps (So _ A)).
  - assert (G : forall i j x y S T, (i < j)%nat -> nth_error (Statements.placements l) i = Some x -> nth_error (Statements.placements l) j = Some y ->
      Statements.shape_of (Statements.placed l x) S -> Statements.shape_of (Statements.placed l y) T -> Statements.keeps (Statements.spacing l) S T).
    { intros i j x y S T L X Y KS KT. destruct (At i x X) as (ps & k & A & B). destruct (At j y Y) as (qs & k' & A' & B').
      destruct (pairs_nth _ _ (all_apart_spec _ _ Ha) i j _ _ L B B') as (f & F). cbn [snd] in F.
      destruct (figure_spec _ ps (Sp _ A)) as (X1 & X2 & X3 & _). destruct (figure_spec _ qs (Sp _ A')) as (Y1 & Y2 & Y3 & _).
      exact (apart_keeps N _ f _ _ _ _ _ _ _ S T X1 Y1 D0 D1 F X2 Y2 X3 Y3 KS KT). }
    intros i j x y S T X Y Ne KS KT. destruct (Nat.lt_gt_cases i j) as (Lt & _). destruct (Lt Ne) as [L|L].
    + exact (G i j x y S T L X Y KS KT).
    + apply keeps_sym. exact (G j i y x T S L Y X KT KS).
  - intros x f S U I E KS KU. rewrite E in Hs. destruct (In_ x I) as (ps & k & A & B).
    destruct (figure_spec _ ps (Sp _ A)) as (P1 & P2 & P3 & P4).
    apply (check_sheet_spec f _ _ k _ Hs M0 B P1 (parts_some _ ps (Sp _ A))); [exact M1| |exact KU].
    exact (cover_known N _ _ _ S P1 P2 P3 KS).
  - intros x o S T I J KS KT. destruct (In_ x I) as (ps & k & A & B). destruct (Obs o J) as (qs & i & Q0 & Ji).
    rewrite forallb_forall in Ho. specialize (Ho _ Ji). cbv zeta in Ho. cbn [fst snd] in Ho. apply andb_prop in Ho as (Am & Ho).
    destruct (amount_spec N _ Am) as (A0 & A1). rewrite forallb_forall in Ho. specialize (Ho _ B). cbn [fst snd] in Ho.
    destruct (figure_spec _ ps (Sp _ A)) as (X1 & X2 & X3 & _). destruct (figure_spec _ qs (So _ Q0)) as (Y1 & Y2 & Y3 & _).
    apply keeps_sym. exact (apart_keeps N _ _ _ _ _ _ _ _ _ T S Y1 X1 A0 A1 Ho Y2 X2 Y3 X3 KT KS).
Qed.
End Sound.
