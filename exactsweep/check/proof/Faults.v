(* Faults, proved by one or two points for all possible true shapes; and `valid` for exactly known shapes. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Statements.
From Exactsweep Require Import Gaps HalfOpen Nearby Boundary SumPoints PiecePoints Covers Near Depth Hull Layout.
Import ListNotations.
Open Scope Q_scope.

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

(* Figures drawn as rings and known exactly: they are pairwise disjoint, inside the sheet, and disjoint from all
   obstacles. *)
Lemma shape_inside f : 0 <= Statements.error f -> Statements.shape_of f (Statements.inside (Statements.outline f)).
Proof. intros E z I. apply within_self; [exact E|left; exact I]. Qed.
Theorem valid_exact l : Statements.valid l ->
  (forall i j x y, nth_error (Statements.placements l) i = Some x -> nth_error (Statements.placements l) j = Some y -> i <> j ->
    let S := Statements.inside (Statements.outline (Statements.placed l x)) in let T := Statements.inside (Statements.outline (Statements.placed l y)) in
    Statements.disjoint S T /\ Statements.at_least (Statements.spacing l) S T) /\
  (forall x C e, In x (Statements.placements l) -> Statements.sheet l = Some {| Statements.outline := C; Statements.rounded := []; Statements.error := e |} ->
    let S := Statements.inside (Statements.outline (Statements.placed l x)) in
    (forall z, S z -> Statements.inside C z) /\ Statements.at_least (Statements.margin l) S (fun z => ~ Statements.inside C z)) /\
  (forall x o, In x (Statements.placements l) -> In o (Statements.obstacles l) ->
    let S := Statements.inside (Statements.outline (Statements.placed l x)) in let T := Statements.inside (Statements.outline (fst o)) in
    Statements.disjoint S T /\ Statements.at_least (snd o) S T).
Proof.
  intro V. destruct (Statements.measures l V) as (_ & M & O & Sh0 & P). rewrite Forall_forall in M, O, P.
  assert (E : forall x, In x (Statements.placements l) -> 0 <= Statements.error (Statements.placed l x)).
  { intros x I. pose proof (proj1 (Statements.rules l V)) as A. rewrite Forall_forall in A. destruct (A x I) as (K & _).
    destruct (M _ (nth_In (Statements.kinds l) Statements.no_part K)) as (Ek & _). destruct (P x I) as (Sl & _).
    unfold Statements.placed, Statements.kind_of. cbn [Statements.error]. lra. }
  split; [|split].
  - intros i j x y X Y Ne. pose proof (Statements.apart l V i j x y _ _ X Y Ne (shape_inside _ (E x (nth_error_In _ _ X)))
      (shape_inside _ (E y (nth_error_In _ _ Y)))) as K. split; [apply (keeps_disjoint _ _ _ K)|apply K].
  - intros x C e I Sh. destruct (Sh0 _ Sh) as (E0 & _). cbn [Statements.error] in E0.
    assert (U : Statements.outside_of {| Statements.outline := C; Statements.rounded := []; Statements.error := e |} (fun z => ~ Statements.inside C z)).
    { intros z N. apply within_self; [exact E0|]. intros [Y|(p & [] & _)]. exact (N Y). }
    pose proof (Statements.contained l V x _ _ _ I Sh (shape_inside _ (E x I)) U) as (K1 & K2).
    split; [|exact K2]. intros z Z. destruct (Z.eq_dec (Statements.winding C z) 1) as [|N]; [assumption|exfalso]. apply K1.
    destruct (half_open (Statements.outline (Statements.placed l x)) z) as (d & D & H). destruct (half_open C z) as (d' & D' & H').
    destruct (below d d' D D') as (r & R & L & L'). destruct (wedge_square r z R) as (c & q & Q0 & Sq).
    exists c. split; exists q; (split; [exact Q0|]); intros y Y; specialize (Sq y Y); unfold Statements.inside.
    + rewrite (H y); [exact Z|]. apply (wedge_less r d z y L Sq).
    + rewrite (H' y); [exact N|]. apply (wedge_less r d' z y L' Sq).
  - intros x o I J. destruct (O o J) as ((E0 & _) & _). pose proof (Statements.no_defect l V x o _ _ I J (shape_inside _ (E x I)) (shape_inside (fst o) E0)) as K.
    split; [apply (keeps_disjoint _ _ _ K)|apply K].
Qed.

(* Faults.  A point is deeper than d in a figure or its complement, or belongs to it. *)
Definition deep (d : Q) (f : Statements.figure) (z : qpoint) : bool :=
  (Statements.winding (Statements.outline f) z =? 1)%Z && far_edges d (Statements.outline f) z ||
  existsb (fun p => Qle_bool 0 (snd p) && (inner d (fst p) z || Statements.less d (snd p) &&
    existsb (fun q => Statements.less (Statements.dist2 q z) ((snd p - d) * (snd p - d))) (hull_points (fst p) z))) (Statements.rounded f).
Definition deep_outside (d : Q) (f : Statements.figure) (z : qpoint) : bool :=
  (Statements.winding (Statements.outline f) z =? 0)%Z && far_edges d (Statements.outline f) z &&
  forallb (fun p => Qle_bool 0 (snd p) && is_far (d + snd p) (fst p) z) (Statements.rounded f).
Definition is_drawn (f : Statements.figure) (z : qpoint) : bool :=
  (Statements.winding (Statements.outline f) z =? 1)%Z || existsb (fun p => Qle_bool 0 (snd p) && near_hull (snd p) (fst p) z) (Statements.rounded f).
Definition is_outside (f : Statements.figure) (z : qpoint) : bool :=
  (Statements.winding (Statements.outline f) z =? 0)%Z && forallb (fun p => Qle_bool 0 (snd p) && is_far (snd p) (fst p) z) (Statements.rounded f).

(* A point of a set at distance less than r from z: z itself, or a point close to an edge of the figure, displaced by
   about the radius.  The search refines its unit step by step; no property of it is used. *)
Definition borders (f : Statements.figure) : list (side * Q) :=
  map (fun e => (e, 0)) (flat_map Statements.edges (Statements.outline f)) ++
  flat_map (fun p => map (fun e => (e, snd p)) (Statements.edges (fst p))) (Statements.rounded f).
Definition displaced (z : qpoint) (unit : positive) (x : side * Q) : list qpoint :=
  let (e, radius) := x in let v := vector (fst e) (snd e) in let step := if Qeq_bool radius 0 then 1 # unit else 0 in
  let t := Qred (along v (vector (fst e) z) / square_of v) in
  let t := if Statements.less t step then step else if Statements.less (1 - step) t then 1 - step else t in
  let foot := (fst (fst e) + t * fst v, snd (fst e) + t * snd v) in
  flat_map (fun n =>
    let q := Qred (radius * radius * inject_Z (Zpos unit ^ 4) / square_of n) in let m := Z.sqrt (Qnum q / QDen q) in
    map (fun k => let s := k # unit * unit in (fst foot + s * fst n, snd foot + s * snd n)) [m - 1; m + 2; 1 - m; - m - 2]%Z)
    (map reduced [vector foot z; across e; (1, 0)]).
Definition units : list positive := map (fun k => 2 ^ k)%positive [1; 2; 4; 8; 16; 32; 64; 128; 256; 512]%positive.
Definition near (belongs : qpoint -> bool) (f : Statements.figure) (r : Q) (z : qpoint) : bool :=
  let is_right p := if Statements.less (Statements.dist2 p z) (r * r) then belongs (reduced p) else false in let es := borders f in
  if is_right z then true else some (fun unit => some (fun x => some is_right (displaced z unit x)) es) units.
(* A body: whether it is the complement of a figure, the figure, and the required distance from it *)
Definition figure_of (l : Statements.layout) (b : Statements.body) : option (bool * Statements.figure * Q) :=
  match b with
  | Statements.Part i => option_map (fun x => (false, Statements.placed l x, Statements.spacing l)) (nth_error (Statements.placements l) i)
  | Statements.Beyond => option_map (fun f => (true, f, Statements.margin l)) (Statements.sheet l)
  | Statements.Obstacle k => option_map (fun o => (false, fst o, snd o)) (nth_error (Statements.obstacles l) k)
  end.
Definition is_same (b : Statements.body) (i : nat) : bool := match b with Statements.Part j => (i =? j)%nat | _ => false end.
Definition check_between (l : Statements.layout) (i : nat) (b : Statements.body) (c : Statements.figure -> bool -> Statements.figure -> Q -> bool) : bool :=
  match nth_error (Statements.placements l) i, figure_of l b with
  | Some x, Some (out, g, d) => negb (is_same b i) && Qle_bool 0 (Statements.error (Statements.placed l x)) && Qle_bool 0 (Statements.error g) &&
      c (Statements.placed l x) out g d
  | _, _ => false
  end.
Definition check_number (l : Statements.layout) (k : nat) (c : N -> N -> bool) : bool :=
  match nth_error (Statements.kinds l) k with
  | Some p => match Statements.demand p with Some n => c (Statements.number l k) n | None => false end
  | None => false
  end.
(* z: a point deep in both bodies, near both, or with a winding number other than 0 and 1 *)
Definition check_fault (l : Statements.layout) (f : Statements.fault) (z : qpoint) : bool :=
  match f with
  | Statements.Missing k => check_number l k N.ltb
  | Statements.Surplus k => check_number l k (fun m n => (n <? m)%N)
  | Statements.Mirrored k => existsb (fun x => (Statements.kind x =? k)%nat && Statements.mirrored (Statements.by_motion x) &&
      negb (Statements.may_mirror (Statements.kind_of l x))) (Statements.placements l)
  | Statements.Rotated k => existsb (fun x => (Statements.kind x =? k)%nat && negb (is_rotated l x)) (Statements.placements l)
  | Statements.Not_simple k => match nth_error (Statements.kinds l) k with
      | Some p => let w := Statements.winding (Statements.outline (Statements.form p)) z in negb (w =? 0)%Z && negb (w =? 1)%Z
      | None => false
      end
  | Statements.Overlapping i b => check_between l i b (fun f out g _ => deep (Statements.error f) f z &&
      if out then deep_outside (Statements.error g) g z else deep (Statements.error g) g z)
  | Statements.Too_close i b => check_between l i b (fun f out g d =>
      let r := (d - Statements.error f - Statements.error g) * (1 # 2) in
      Statements.less 0 r && near (is_drawn f) f r z && near (if out then is_outside g else is_drawn g) g r z)
  end.
Definition check_faults (l : Statements.layout) (fs : list Statements.fault) (at_ : list qpoint) : bool :=
  is_well_formed l && match fs with [] => false | _ => true end && (length fs =? length at_)%nat &&
  forallb (fun x => check_fault l (fst x) (snd x)) (combine fs at_).

Lemma near_disc c z d (P : qpoint -> Prop) : 0 <= d -> d < c -> (forall y, Statements.dist2 y z <= c * c -> P y) ->
  exists h, 0 < h /\ forall y, Statements.dist2 y z <= h * h -> forall w, Statements.dist2 w y <= (d + h) * (d + h) -> P w.
Proof.
  intros D L H. set (h := (c - d) / 2). assert (E : h == (1 # 2) * (c - d)) by (unfold h; field). exists h. split; [lra|].
  intros y Y w W. apply H. pose proof (triangle w y z (d + h) h ltac:(lra) ltac:(lra) W Y) as T. assert (F : d + h + h == c) by lra. rewrite F in T. exact T.
Qed.
Lemma deep_spec d f z : 0 <= d -> deep d f z = true -> exists c, d < c /\ forall y, Statements.dist2 y z <= c * c -> Statements.drawn f y.
Proof.
  intros D H. unfold deep in H. apply orb_prop in H as [H|H].
  - apply andb_prop in H as (W & F). apply Z.eqb_eq in W. destruct (far_winding d _ z D F) as (c & C & E). exists c. split; [exact C|].
    intros y Y. left. unfold Statements.inside. rewrite (E y Y). exact W.
  - apply existsb_exists in H as (p & I & H). apply andb_prop in H as (R & H). apply Qle_bool_iff in R. apply orb_prop in H as [H|H].
    + destruct (inner_spec d _ z D H) as (c & C & E). exists c. split; [exact C|]. intros y Y. right. exists p. split; [exact I|].
      apply within_self; [exact R|apply E, Y].
    + apply andb_prop in H as (L & H). apply Covers.less_true in L. apply existsb_exists in H as (q & Iq & H). apply Covers.less_true in H.
      apply hull_points_in in Iq. destruct (root_below _ (snd p - d) (dist2_nonneg q z) ltac:(lra) H) as (k & (K0 & K) & Dk).
      exists (snd p - k). split; [lra|]. intros y Y. right. exists p. split; [exact I|]. intros r Lr F. specialize (F q Iq).
      pose proof (triangle q z y k (snd p - k) K0 ltac:(lra) Dk ltac:(rewrite dist2_sym; exact Y)) as T.
      assert (E : k + (snd p - k) == snd p) by ring. rewrite E in T. pose proof (sq_lt (snd p) r R Lr). lra.
Qed.
Lemma far_hull d r ps z : 0 <= d -> 0 <= r -> is_far (d + r) ps z = true ->
  exists c, d < c /\ forall y, Statements.dist2 y z <= c * c -> ~ Statements.within r (Statements.hull ps) y.
Proof.
  intros D R H. destruct (is_far_spec (d + r) ps z ltac:(lra) (is_far_some _ _ _ H) H) as (n & c & m & C & A & B).
  set (h := (c - (d + r)) / 2). assert (E : h == (1 # 2) * (c - (d + r))) by (unfold h; field). exists (d + h). split; [lra|].
  intros y Y W. apply (W (r + h) ltac:(lra)). intros q Q. destruct (Qlt_le_dec ((r + h) * (r + h)) (Statements.dist2 q y)) as [|L]; [assumption|exfalso].
  pose proof (triangle q y z (r + h) (d + h) ltac:(lra) ltac:(lra) L Y) as T. assert (F : r + h + (d + h) == c) by lra. rewrite F in T.
  specialize (A q T). specialize (Q (- fst n) (- snd n) (- m)).
  assert (G : - fst n * fst q + - snd n * snd q <= - m); [apply Q; intros p P; specialize (B p P); unfold along in B; lra|unfold along in A; lra].
Qed.
Lemma deep_outside_spec d f z : 0 <= d -> deep_outside d f z = true -> exists c, d < c /\ forall y, Statements.dist2 y z <= c * c -> ~ Statements.drawn f y.
Proof.
  intros D H. unfold deep_outside in H. apply andb_prop in H as (H & P). apply andb_prop in H as (W & F). rewrite forallb_forall in P.
  destruct (far_winding d _ z D F) as (c & C & E).
  destruct (common_disc d z (fun p y => ~ Statements.within (snd p) (Statements.hull (fst p)) y) (Statements.rounded f)) as (c' & C' & E'); [|exact D|].
  - intros p I. specialize (P p I). apply andb_prop in P as (R & P). apply Qle_bool_iff in R. exact (far_hull d (snd p) (fst p) z D R P).
  - assert (G : forall y, ~ Statements.inside (Statements.outline f) y \/ Statements.winding (Statements.outline f) y <> Statements.winding (Statements.outline f) z).
    { intro y. destruct (Z.eq_dec (Statements.winding (Statements.outline f) y) (Statements.winding (Statements.outline f) z)) as [X|]; [left|right; assumption].
      unfold Statements.inside. rewrite X. intro V. rewrite V in W. discriminate. }
    destruct (Qlt_le_dec c c') as [L|L]; [exists c|exists c']; (split; [assumption|]); intros y Y [Z'|(p & I & Z')].
    + destruct (G y) as [N|N]; [exact (N Z')|exact (N (E y Y))].
    + apply (E' y) with (a := p); [|exact I|exact Z']. pose proof (sq_lt c c' ltac:(lra) L). lra.
    + destruct (G y) as [N|N]; [exact (N Z')|apply N, E]. pose proof (sq_le c' c ltac:(lra) L). lra.
    + exact (E' y Y p I Z').
Qed.
Lemma is_drawn_spec f z : is_drawn f z = true -> Statements.drawn f z.
Proof.
  unfold is_drawn. intro H. apply orb_prop in H as [H|H]; [left; apply Z.eqb_eq, H|]. apply existsb_exists in H as (p & I & H).
  apply andb_prop in H as (R & H). apply Qle_bool_iff in R. right. exists p. split; [exact I|exact (near_hull_spec _ _ _ R H)].
Qed.
Lemma is_outside_spec f z : is_outside f z = true -> ~ Statements.drawn f z.
Proof.
  unfold is_outside. intro H. apply andb_prop in H as (W & P). rewrite forallb_forall in P. intros [Z'|(p & I & Z')].
  - unfold Statements.inside in Z'. rewrite Z' in W. discriminate.
  - specialize (P p I). apply andb_prop in P as (R & P). apply Qle_bool_iff in R.
    assert (P' : is_far (0 + snd p) (fst p) z = true -> False).
    { intro X. destruct (far_hull 0 (snd p) (fst p) z ltac:(lra) R X) as (c & C & E). apply (E z); [|exact Z'].
      assert (Z0 : Statements.dist2 z z == 0) by (unfold Statements.dist2; ring). rewrite Z0. apply sq_nonneg. }
    destruct (is_far_spec (snd p) (fst p) z R (is_far_some _ _ _ P) P) as (n & c & m & C & A & B). apply (Z' c C). intros q Q.
    destruct (Qlt_le_dec (c * c) (Statements.dist2 q z)) as [|L]; [assumption|exfalso]. specialize (A q L). specialize (Q (- fst n) (- snd n) (- m)).
    assert (G : - fst n * fst q + - snd n * snd q <= - m); [apply Q; intros v V; specialize (B v V); unfold along in B; lra|unfold along in A; lra].
Qed.

(* True shapes *)
Lemma some_true f : 0 <= Statements.error f -> Statements.true_shape f (fun z => ~ ~ Statements.drawn f z).
Proof.
  intro E. split; [|split; [|split]].
  - intros z H N. apply H. apply within_self; [exact E|exact N].
  - intros z N d D F. apply N. intro Z. exact (within_self _ _ z E Z d D F).
  - intros z Z. apply within_self; [exact E|]. intro N. exact (N Z).
  - intros z N. apply within_self; [exact E|]. intro M. exact (M N).
Qed.
Lemma true_deep f z S : 0 <= Statements.error f -> deep (Statements.error f) f z = true -> Statements.true_shape f S ->
  exists h, 0 < h /\ forall y, Statements.dist2 y z <= h * h -> S y.
Proof.
  intros E H (T & _). destruct (deep_spec _ f z E H) as (c & C & P). destruct (near_disc c z _ _ E C P) as (h & H0 & N). exists h. split; [exact H0|].
  intros y Y. apply T. intro W. apply (W (Statements.error f + h) ltac:(lra)). intros w Nw.
  destruct (Qlt_le_dec ((Statements.error f + h) * (Statements.error f + h)) (Statements.dist2 w y)) as [|L]; [assumption|exfalso]. exact (Nw (N y Y w L)).
Qed.
Lemma true_outside f z C : 0 <= Statements.error f -> deep_outside (Statements.error f) f z = true -> Statements.true_shape f C ->
  exists h, 0 < h /\ forall y, Statements.dist2 y z <= h * h -> ~ C y.
Proof.
  intros E H (_ & K & _). destruct (deep_outside_spec _ f z E H) as (c & L & P). destruct (near_disc c z _ _ E L P) as (h & H0 & N). exists h. split; [exact H0|].
  intros y Y Cy. apply (K y Cy (Statements.error f + h) ltac:(lra)). intros w W.
  destruct (Qlt_le_dec ((Statements.error f + h) * (Statements.error f + h)) (Statements.dist2 w y)) as [|L']; [assumption|exfalso]. exact (N y Y w L' W).
Qed.
Lemma disc_interior h z (S : qpoint -> Prop) : 0 < h -> (forall y, Statements.dist2 y z <= h * h -> S y) -> Statements.interior S z.
Proof.
  intros H P. exists (h / 2). assert (E : h / 2 == (1 # 2) * h) by field. split; [lra|]. intros y (Y1 & Y2). apply P. unfold Statements.dist2.
  assert (B : forall a, - (h / 2) < a < h / 2 -> a * a <= (1 # 4) * (h * h)).
  { intros a A. rewrite E in A. assert (0 <= ((1 # 2) * h - a) * ((1 # 2) * h + a)) by (apply Qmult_le_0_compat; lra).
    assert (F : ((1 # 2) * h - a) * ((1 # 2) * h + a) == (1 # 4) * (h * h) - a * a) by ring. lra. }
  pose proof (B _ Y1). pose proof (B _ Y2). pose proof (sq_nonneg h). lra.
Qed.
Lemma in_closure (S : Statements.point -> Prop) z : S z -> Statements.closure S z.
Proof. intros H e E. exists z. split; [exact H|apply close_refl, E]. Qed.
Lemma close_points d e e' y z (S T : qpoint -> Prop) : 0 <= e -> 0 <= e' -> 0 < d - e - e' -> Statements.dist2 y z < (d - e - e') * (d - e - e') ->
  Statements.within e S y -> Statements.within e' T z -> ~ Statements.at_least d S T.
Proof.
  intros E E' R L WS WT A. destruct (root_below _ (d - e - e') (dist2_nonneg y z) ltac:(lra) L) as (k & (K0 & K) & Dk).
  set (h := (d - e - e' - k) / 2). assert (Eh : h == (1 # 2) * (d - e - e' - k)) by (unfold h; field).
  apply (WS (e + h) ltac:(lra)). intros s Hs. destruct (Qlt_le_dec ((e + h) * (e + h)) (Statements.dist2 s y)) as [|Ds]; [assumption|exfalso].
  set (g := h / 2). assert (Eg : g == (1 # 2) * h) by (unfold g; field).
  apply (WT (e' + g) ltac:(lra)). intros t Ht. destruct (Qlt_le_dec ((e' + g) * (e' + g)) (Statements.dist2 t z)) as [|Dt]; [assumption|exfalso].
  specialize (A s t (in_closure _ _ Hs) (in_closure _ _ Ht)).
  pose proof (triangle s y z (e + h) k ltac:(lra) K0 Ds Dk) as T1. rewrite dist2_sym in Dt.
  pose proof (triangle s z t (e + h + k) (e' + g) ltac:(lra) ltac:(lra) T1 Dt) as T2.
  pose proof (sq_lt (e + h + k + (e' + g)) d ltac:(lra) ltac:(lra)). lra.
Qed.

Definition true_body (out : bool) (g : Statements.figure) (T : qpoint -> Prop) : Prop :=
  if out then exists C, Statements.true_shape g C /\ T = fun z => ~ C z else Statements.true_shape g T.
Lemma figure_of_spec l b out g d : figure_of l b = Some (out, g, d) -> Statements.body_of l b = Some (d, true_body out g).
Proof.
  destruct b as [i| |k]; cbn [figure_of Statements.body_of]; [destruct (nth_error (Statements.placements l) i)|destruct (Statements.sheet l)|destruct (nth_error (Statements.obstacles l) k)];
    cbn [option_map]; intro H; try discriminate; injection H as <- <- <-; reflexivity.
Qed.
Lemma check_between_spec l i b c (R : Q -> (qpoint -> Prop) -> (qpoint -> Prop) -> Prop) : check_between l i b c = true ->
  (forall f out g d S T, 0 <= Statements.error f -> 0 <= Statements.error g -> c f out g d = true -> Statements.true_shape f S -> true_body out g T -> R d S T) ->
  Statements.between l i b R.
Proof.
  unfold check_between. intros H K. destruct (nth_error (Statements.placements l) i) as [x|] eqn:X; [|discriminate].
  destruct (figure_of l b) as [((out, g), d)|] eqn:F; [|discriminate]. apply andb_prop in H as (H & C). apply andb_prop in H as (H & E').
  apply andb_prop in H as (Ne & E). apply Qle_bool_iff in E, E'. split.
  - intro B. subst b. cbn [is_same] in Ne. rewrite Nat.eqb_refl in Ne. discriminate.
  - exists x, d, (true_body out g). split; [exact X|]. split; [exact (figure_of_spec _ _ _ _ _ F)|]. split.
    + eexists. exists (if out then fun z => ~ ~ ~ Statements.drawn g z else fun z => ~ ~ Statements.drawn g z). split; [exact (some_true _ E)|].
      destruct out; [exists (fun z => ~ ~ Statements.drawn g z); split; [exact (some_true _ E')|reflexivity]|exact (some_true _ E')].
    + intros S T HS HT. exact (K _ out g d S T E E' C HS HT).
Qed.
Lemma check_number_spec l k c : check_number l k c = true -> exists n, Statements.demanded l k n /\ c (Statements.number l k) n = true.
Proof.
  unfold check_number. destruct (nth_error (Statements.kinds l) k) as [p|] eqn:P; [|discriminate].
  destruct (Statements.demand p) as [n|] eqn:D; [|discriminate]. intro H. exists n. split; [exists p; split; assumption|exact H].
Qed.
Lemma near_spec belongs f r z : 0 < r -> near belongs f r z = true ->
  exists p, belongs p = true /\ exists a, 0 <= a < r /\ Statements.dist2 p z <= a * a.
Proof.
  intros R H. assert (X : exists p, Statements.less (Statements.dist2 p z) (r * r) && belongs (reduced p) = true).
  { unfold near in H. cbv zeta in H. destruct (if Statements.less (Statements.dist2 z z) (r * r) then belongs (reduced z) else false) eqn:Z; [exists z; exact Z|].
    apply some_exists in H as (u & _ & H). apply some_exists in H as (x & _ & H). apply some_exists in H as (p & _ & H). exists p. exact H. }
  destruct X as (p & X). apply andb_prop in X as (L & B). apply Covers.less_true in L. exists (reduced p). split; [exact B|].
  assert (E : Statements.dist2 (reduced p) z == Statements.dist2 p z) by (unfold Statements.dist2, reduced; cbn [fst snd]; rewrite !Qred_correct; reflexivity).
  destruct (root_below _ r (dist2_nonneg p z) ltac:(lra) L) as (a & A & D). exists a. rewrite E. auto.
Qed.
Theorem fault_sound l f z : check_fault l f z = true -> Statements.has l f.
Proof.
  destruct f as [k|k|k|k|k|i b|i b]; cbn [check_fault Statements.has]; intro H.
  - apply check_number_spec in H as (n & D & L). exists n. split; [exact D|apply N.ltb_lt, L].
  - apply check_number_spec in H as (n & D & L). exists n. split; [exact D|apply N.ltb_lt, L].
  - apply existsb_exists in H as (x & I & H). apply andb_prop in H as (H & M). apply andb_prop in H as (K & N). exists x.
    split; [exact I|]. split; [apply Nat.eqb_eq, K|]. split; [exact N|apply negb_true_iff, M].
  - apply existsb_exists in H as (x & I & H). apply andb_prop in H as (K & N). exists x. split; [exact I|]. split; [apply Nat.eqb_eq, K|].
    intro R. apply is_rotated_spec in R. rewrite R in N. discriminate.
  - destruct (nth_error (Statements.kinds l) k) as [p|] eqn:P; [|discriminate]. cbv zeta in H. apply andb_prop in H as (A & B).
    exists p, z. split; [reflexivity|]. split; intro W; rewrite W in *; discriminate.
  - apply (check_between_spec _ _ _ _ _ H). clear H. intros f out g d S T E E' H HS HT. apply andb_prop in H as (A & B). exists z.
    destruct (true_deep f z S E A HS) as (h & H0 & P). split; [exact (disc_interior h z S H0 P)|].
    destruct out; cbn [true_body] in HT.
    + destruct HT as (C & HC & ->). destruct (true_outside g z C E' B HC) as (h' & H1 & P'). exact (disc_interior h' z _ H1 P').
    + destruct (true_deep g z T E' B HT) as (h' & H1 & P'). exact (disc_interior h' z T H1 P').
  - apply (check_between_spec _ _ _ _ _ H). clear H. intros f out g d S T E E' H HS HT. cbv zeta in H. apply andb_prop in H as (H & B).
    apply andb_prop in H as (R & A). apply Covers.less_true in R. set (r := (d - Statements.error f - Statements.error g) * (1 # 2)) in *.
    apply near_spec in A as (y & A & Dy), B as (w & B & Dw); try exact R. apply (close_points d _ _ y w S T E E').
    + unfold r in R. lra.
    + destruct Dy as (u & (A0 & A1) & Dy), Dw as (v & (B0 & B1) & Dw). rewrite dist2_sym in Dw. pose proof (triangle y z w u v A0 B0 Dy Dw) as D.
      assert (X : u + v < d - Statements.error f - Statements.error g) by (unfold r in *; lra). pose proof (sq_lt (u + v) _ ltac:(lra) X). lra.
    + destruct HS as (_ & _ & K & _). apply K, is_drawn_spec, A.
    + destruct out; cbn [true_body] in HT; [destruct HT as (U & (_ & _ & _ & K) & ->); apply K, is_outside_spec, B|].
      destruct HT as (_ & _ & K & _). apply K, is_drawn_spec, B.
Qed.

(* A layout with a fault is not valid. *)
Lemma true_complement f C : Statements.true_shape f C -> Statements.outside_of f (fun z => ~ C z).
Proof.
  intros (T & _) z N d D F. apply N, T. intro W. exact (W d D F).
Qed.
Lemma between_refutes l i b (R : Q -> (qpoint -> Prop) -> (qpoint -> Prop) -> Prop) : (forall d S T, Statements.keeps d S T -> R d S T -> False) ->
  Statements.between l i b R -> ~ Statements.valid l.
Proof.
  intros K (Ne & x & d & F & X & B & (S & T & HS & HT) & A) V. apply (K d S T); [|exact (A S T HS HT)]. pose proof HS as (_ & S1 & _).
  destruct b as [j| |k]; cbn [Statements.body_of] in B.
  - destruct (nth_error (Statements.placements l) j) as [y|] eqn:Y; [|discriminate]. injection B as <- <-. destruct HT as (_ & T1 & _).
    apply (Statements.apart l V i j x y S T X Y); [congruence|exact S1|exact T1].
  - destruct (Statements.sheet l) as [f|] eqn:Sh; [|discriminate]. injection B as <- <-. destruct HT as (C & HC & ->).
    exact (Statements.contained l V x f S _ (nth_error_In _ _ X) Sh S1 (true_complement f C HC)).
  - destruct (nth_error (Statements.obstacles l) k) as [o|] eqn:O; [|discriminate]. injection B as <- <-. destruct HT as (_ & T1 & _).
    exact (Statements.no_defect l V x o S T (nth_error_In _ _ X) (nth_error_In _ _ O) S1 T1).
Qed.
Theorem fault_refutes l f : Statements.has l f -> ~ Statements.valid l.
Proof.
  destruct f as [k|k|k|k|k|i b|i b]; cbn [Statements.has].
  - intros (n & D & L) V. rewrite (proj2 (Statements.rules l V) k n D) in L. exact (N.lt_irrefl n L).
  - intros (n & D & L) V. rewrite (proj2 (Statements.rules l V) k n D) in L. exact (N.lt_irrefl n L).
  - intros (x & I & _ & M & N) V. pose proof (proj1 (Statements.rules l V)) as A. rewrite Forall_forall in A. destruct (A x I) as (_ & B & _).
    rewrite (B M) in N. discriminate.
  - intros (x & I & _ & N) V. pose proof (proj1 (Statements.rules l V)) as A. rewrite Forall_forall in A. apply N. apply (A x I).
  - intros (p & z & P & W0 & W1) V. pose proof (proj1 (Statements.shapes l V)) as A. rewrite Forall_forall in A.
    destruct (A p (nth_error_In _ _ P)) as ([O|(S & _)] & _); [rewrite O in W0; exact (W0 eq_refl)|]. destruct (S z); contradiction.
  - apply between_refutes. intros d S T (N & _) O. exact (N O).
  - apply between_refutes. intros d S T (_ & A) N. exact (N A).
Qed.
Theorem faults_sound l fs ps : check_faults l fs ps = true -> Statements.faulty l fs.
Proof.
  unfold check_faults. intro H. apply andb_prop in H as (H & C). apply andb_prop in H as (H & L). apply andb_prop in H as (Wf & Ne). apply Nat.eqb_eq in L. rewrite forallb_forall in C.
  assert (A : Forall (Statements.has l) fs).
  { rewrite Forall_forall. intros f I. apply In_nth_error in I as (i & I). destruct (nth_combine _ _ i f L I) as (p & P).
    specialize (C _ (nth_error_In _ _ P)). cbn [fst snd] in C. exact (fault_sound l f _ C). }
  split; [apply is_well_formed_spec, Wf|]. split; [destruct fs; discriminate|]. split; [exact A|]. destruct fs as [|f fs]; [discriminate Ne|]. inversion A; subst. exact (fault_refutes l f ltac:(assumption)).
Qed.
