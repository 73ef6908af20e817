(* Sums of pieces, and `boundary`, the check for no-fit polygons, inner fits and sweeps. D is a list of convex pieces or
   segments, H a list of convex pieces; a sum is the interior of the Minkowski sum of an element of D and an element of
   H. Vertices are integers, at a common denominator N. *)
Require Import QArith Lqa ZArith Lia List Bool FMapPositive.
From Exactsweep Require Import Cancel Constant Fans Pieces Convex Solid Gaps Boxes Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers Spans.
Import ListNotations.
Open Scope Z_scope.

(* 1. The functions of the checker *)

Definition same (p q : pt) : bool := (fst p =? fst q) && (snd p =? snd q).
Definition plus (p q : pt) : pt := (fst p + fst q, snd p + snd q).
Definition turned (r : ring) : ring := map opposite r.

(* A ring that starts at its lowest vertex, or the left one of two *)
Definition lower (p q : pt) : bool := (snd p <? snd q) || (snd p =? snd q) && (fst p <? fst q).
Definition lowest (p : pt) (r : ring) : pt := fold_right (fun q best => if lower q best then q else best) p r.
Fixpoint rotate (v : pt) (seen rest : ring) : ring :=
  match rest with [] => rev seen | p :: r => if same p v then rest ++ rev seen else rotate v (p :: seen) r end.
Definition from_lowest (r : ring) : ring := match r with [] => [] | p :: _ => rotate (lowest p r) [] r end.

(* The vertices of a sum, ordered by directions of edges, each as a pair of summands *)
Definition turn (e f : edge) : Z :=
  (fst (snd e) - fst (fst e)) * (snd (snd f) - snd (fst f)) - (snd (snd e) - snd (fst e)) * (fst (snd f) - fst (fst f)).
Fixpoint add_from (steps : nat) (p q : pt) (one other : list edge) : list (pt * pt) :=
  match steps, one, other with
  | O, _, _ | _, [], [] => []
  | S n, e :: one', [] => (p, q) :: add_from n (snd e) q one' []
  | S n, [], f :: other' => (p, q) :: add_from n p (snd f) [] other'
  | S n, e :: one', f :: other' =>
      (p, q) :: (if 0 <? turn e f then add_from n (snd e) q one' other
                 else if turn e f <? 0 then add_from n p (snd f) one other'
                 else add_from n (snd e) (snd f) one' other')
  end.
Definition add (one other : ring) : list (pt * pt) :=
  let one := from_lowest one in let other := from_lowest other in
  match one, other with
  | p :: _, q :: _ => add_from (length one + length other) p q (edges one) (edges other)
  | _, _ => []
  end.
Definition sum_vertices (one other : ring) : ring := map (fun x => plus (fst x) (snd x)) (add one other).
Definition sum_sides (one other : ring) : list edge := edges (sum_vertices one other).

(* Three times a point inside a piece or on a segment *)
Definition center (r : ring) : pt :=
  match r with p :: q :: s :: _ => plus (plus p q) s | p :: _ => grow 3 p | [] => (0, 0) end.
Definition left_of (z : pt) (f : edge) : bool := 0 <? det (grow 3 (fst f)) (grow 3 (snd f)) z.

(* A line separates a sum from a segment. *)
Definition most (n : pt) (r : ring) : Z := match r with v :: vs => max_dot n v vs | [] => 0 end.
Definition bound (one other : ring) (n : pt) : Z := most n one + most n other.
Definition is_beyond (one other : ring) (e : edge) (n : pt) : bool :=
  if same n (0, 0) then false else let m := bound one other n in (m <=? dot n (fst e)) && (m <=? dot n (snd e)).
Definition clear (one other : ring) (normals : list pt) (e : edge) : bool :=
  some (is_beyond one other e) (normals ++ [normal e; opposite (normal e)]).
Definition is_box_beyond (b c : extremes) : bool :=
  let '(r, u, l, d) := b in let '(x, y, z, w) := c in if r <=? x then true else if u <=? y then true else if l <=? z then true else d <=? w.
Definition box_of (one other : ring) : extremes :=
  let m := bound one other in (m (1, 0), m (0, 1), m (-1, 0), m (0, -1)).

(* Whether two edges of loops have at most one common point *)
Definition distinct (e g : edge) : bool :=
  negb (turn e g =? 0) || negb (det (fst e) (snd e) (fst g) =? 0) ||
  (Z.max (snd (fst e)) (snd (snd e)) <=? Z.min (snd (fst g)) (snd (snd g))) ||
  (Z.max (snd (fst g)) (snd (snd g)) <=? Z.min (snd (fst e)) (snd (snd e))).

(* Groups of pieces connected by common vertices: one piece and all vertices of each group *)
Definition meets (p : ring) (g : ring * list pt) : bool := some (fun v => some (same v) (snd g)) p.
Fixpoint groups (ps : list ring) : list (ring * list pt) :=
  match ps with
  | [] => []
  | p :: r => let (met, others) := partition (meets p) (groups r) in (p, p ++ concat (map snd met)) :: others
  end.
Definition are_segments (ps : list ring) : bool := match ps with [_; _] :: _ => true | _ => false end.

(* An index in the chain of a side: n >= 0 is listed polygon n, -1 - n is known edge n. *)
Definition spans_of (polygons : list (list edge)) (known : list edge) (f : edge) (chain : list Z) : list span :=
  flat_map (fun n =>
    if 0 <=? n then
      match nth_error polygons (Z.to_nat n) with
      | Some lines => match clip lines (fst f) (snd f) with Some (s, t) => [(s, t, false)] | None => [] end
      | None => []
      end
    else
      match nth_error known (Z.to_nat (-1 - n)) with
      | Some e => match share f e with Some (s, t) => [(s, t, true)] | None => [] end
      | None => []
      end) chain.

(* Intervals of a known edge covered by sides of sums, in its direction (the sum is on its left) or against it *)
Definition rightwards (e : edge) : bool :=
  (fst (fst e) <? fst (snd e)) || (fst (fst e) =? fst (snd e)) && (snd (fst e) <? snd (snd e)).
Definition along (e f : edge) (left : bool) : list span :=
  if (det (fst e) (snd e) (fst f) =? 0) && (det (fst e) (snd e) (snd f) =? 0) && negb (same (fst f) (snd f)) &&
     Bool.eqb (Bool.eqb (rightwards e) (rightwards f)) left
  then match share e f with Some (s, t) => [(s, t, true)] | None => [] end else [].
Definition beside (left : bool) (sides : list edge) (e : edge) : bool := covers (flat_map (fun f => along e f left) sides).
Definition on_side (sides : list edge) (e : edge) : bool :=
  existsb (fun f => match share f e with Some (s, t) => Qle_bool 0 s && Qle_bool s 1 | None => false end && negb (same (fst f) (snd f))) sides.

(* The sides that refer to a known edge; edges are numbered from 1. *)
Definition table := PositiveMap.t (list edge).
Definition sides_at (m : table) (k : positive) : list edge := match PositiveMap.find k m with Some l => l | None => [] end.
Definition add_side (f : edge) (n : Z) (m : table) : table :=
  if n <? 0 then let k := Z.to_pos (- n) in PositiveMap.add k (f :: sides_at m k) m else m.
Definition by_edge (named : list (edge * list Z)) : table :=
  fold_right (fun x m => fold_right (add_side (fst x)) m (snd x)) (PositiveMap.empty _) named.
Fixpoint all_sided (f : list edge -> edge -> bool) (m : table) (k : positive) (es : list edge) : bool :=
  match es with [] => true | e :: r => f (sides_at m k) e && all_sided f m (Pos.succ k) r end.

Fixpoint zip_all {A B} (f : A -> B -> bool) (l : list A) (m : list B) : bool :=
  match l, m with [], [] => true | a :: l', b :: m' => f a b && zip_all f l' m' | _, _ => false end.

Section Check.
(* Loops, oriented with the sums on the left, and fits; the listed sums, each with its number and the chains of its
   sides; and open half-planes to the right of edges, which count as listed, with one chain each. *)
Variables (ds hs : list ring) (beyond : list edge) (loops : list ring) (fits : list edge)
  (listed : list (Z * list (list Z))) (around : list (list Z)) (wanted : Z).
Definition loop_edges : list edge := flat_map edges loops.
Definition known : list edge := loop_edges ++ fits.
Definition columns : Z := Z.of_nat (length hs).
Definition pair_of (k : Z) : ring * ring := (nth (Z.to_nat (k / columns)) ds [], nth (Z.to_nat (k mod columns)) hs []).
Definition sides_of (k : Z) : list edge := let (one, other) := pair_of k in sum_sides one other.
Definition polygons : list (list edge) := map (fun x => sides_of (fst x)) listed ++ map (fun f => [f]) beyond.
Definition chains : list (list (list Z)) := map snd listed ++ map (fun c => [c]) around.
Definition named : list (edge * list Z) := flat_map (fun x => combine (fst x) (snd x)) (combine polygons chains).

(* Condition (a) for a pair of pieces, and (d) for the pieces of each group.  Along a segment, sums of pieces with a
   common vertex may be disjoint. *)
Definition is_clear (trees : list tree) (one other : ring) : bool :=
  let normals := axes ++ map normal (edges one) ++ map normal (edges other) in
  forallb (all_in (is_box_beyond (box_of one other)) (clear one other normals)) trees.
Definition all_clear : bool := let trees := trees_of known in forallb (fun one => forallb (is_clear trees one) hs) ds.
Definition winds (es : list edge) (one other : ring) : bool := wind es (plus (center one) (center other)) =? wanted.
Definition wind_all : bool :=
  let es := map (grow_edge 3) loop_edges in let inner := if are_segments ds then hs else map fst (groups hs) in
  forallb (fun g => forallb (winds es (fst g)) inner) (groups ds).
Definition is_sum (k : Z) : bool :=
  let (one, other) := pair_of k in
  (0 <=? k) && (k <? Z.of_nat (length ds) * columns) && is_convex (sum_vertices one other) && forallb (left_of (plus (center one) (center other))) (sides_of k).
Definition boundary : bool :=
  forallb (fun e => negb (same (fst e) (snd e))) loop_edges && all_pairs distinct loop_edges &&
  all_clear && wind_all &&
  forallb (fun f => forallb (fun e => (det (fst f) (snd f) (fst e) <=? 0) && (det (fst f) (snd f) (snd e) <=? 0)) known) beyond &&
  forallb (fun x => is_sum (fst x)) listed &&
  (length around =? length beyond)%nat &&
  let ps := polygons in let es := known in
  zip_all (zip_all (fun f chain => negb (same (fst f) (snd f)) && covers (spans_of ps es f chain))) ps chains &&
  let m := by_edge named in all_sided (beside true) m 1 loop_edges &&
  all_sided (fun sides e => if same (fst e) (snd e) then on_side sides e else beside true sides e && beside false sides e)
    m (Pos.of_succ_nat (length loop_edges)) fits.
End Check.

(* 2. Properties *)

Lemma same_spec p q : same p q = true <-> p = q.
Proof.
  unfold same. destruct p, q. cbn [fst snd]. split.
  - intro H. apply andb_prop in H as (A & B). apply Z.eqb_eq in A, B. congruence.
  - intro E. injection E as -> ->. rewrite !Z.eqb_refl. reflexivity.
Qed.
Lemma same_not p q : negb (same p q) = true -> p <> q.
Proof. intros H E. apply same_spec in E. rewrite E in H. discriminate. Qed.

Lemma groups_spec {A} (f : ring -> A) ps : (forall p q v, In p ps -> In q ps -> In v p -> In v q -> f p = f q) ->
  (forall p, In p ps -> exists g, In g (groups ps) /\ f p = f (fst g)) /\
  (forall g, In g (groups ps) -> In (fst g) ps /\ forall v, In v (snd g) -> exists p, In p ps /\ In v p /\ f p = f (fst g)).
Proof.
  induction ps as [|p r IH]; intro H; [split; [intros p []|intros g []]|].
  destruct IH as (IP & IG); [intros q s v Q S; apply H; right; assumption|]. cbn [groups].
  destruct (partition (meets p) (groups r)) as (met, others) eqn:P.
  assert (Met : forall g, In g met -> In g (groups r) /\ f p = f (fst g)).
  { intros g I. assert (J : In g (groups r)) by (apply (elements_in_partition _ _ P); left; exact I). split; [exact J|].
    assert (M : meets p g = true).
    { revert P I. clear. revert met others. induction (groups r) as [|h l IH]; intros met others P I; cbn [partition] in P; [injection P as <- <-; destruct I|].
      destruct (partition (meets p) l) as (m, o). destruct (meets p h) eqn:M; injection P as <- <-; [destruct I as [<-|I]; [exact M|]|];
        exact (IH _ _ eq_refl I). }
    apply some_exists in M as (v & V & M). apply some_exists in M as (w & W & M). apply same_spec in M. subst w.
    destruct (proj2 (IG g J) v W) as (q & Q & Vq & E). rewrite <- E. apply (H p q v); [left; reflexivity|right; exact Q|exact V|exact Vq]. }
  split.
  - intros q [<-|Q]; [eexists; split; [left; reflexivity|reflexivity]|]. destruct (IP q Q) as (g & G & E).
    apply (elements_in_partition _ _ P) in G as [G|G]; [|exists g; split; [right; exact G|exact E]].
    eexists. split; [left; reflexivity|]. rewrite E. symmetry. exact (proj2 (Met g G)).
  - intros g [<-|G].
    + split; [left; reflexivity|]. intros v V. apply in_app_or in V as [V|V]; [exists p; repeat split; [left; reflexivity|exact V]|].
      apply in_concat in V as (l & L & V). apply in_map_iff in L as (g & <- & G). destruct (Met g G) as (J & E).
      destruct (proj2 (IG g J) v V) as (q & Q & Vq & F). exists q. split; [right; exact Q|]. split; [exact Vq|]. cbn [fst]. congruence.
    + assert (J : In g (groups r)) by (apply (elements_in_partition _ _ P); right; exact G). destruct (IG g J) as (K & L).
      split; [right; exact K|]. intros v V. destruct (L v V) as (q & Q & W). exists q. split; [right; exact Q|exact W].
Qed.

Lemma rotate_in v p : forall rest seen, In p (rotate v seen rest) -> In p rest \/ In p seen.
Proof.
  induction rest as [|q r IH]; intros seen I; cbn [rotate] in I; [right; apply in_rev, I|].
  destruct (same q v).
  - apply in_app_or in I as [I|I]; [left; exact I|right; apply in_rev, I].
  - destruct (IH _ I) as [J|[<-|J]]; [left; right; exact J|left; left; reflexivity|right; exact J].
Qed.
Lemma from_lowest_in r p : In p (from_lowest r) -> In p r.
Proof. destruct r as [|q r]; [intros []|]. intro I. apply rotate_in in I as [I|[]]. exact I. Qed.

Lemma add_from_in (A B : ring) : forall n p q one other, In p A -> In q B ->
  (forall e, In e one -> In (snd e) A) -> (forall e, In e other -> In (snd e) B) ->
  forall x, In x (add_from n p q one other) -> In (fst x) A /\ In (snd x) B.
Proof.
  induction n as [|n IH]; intros p q one other P Q Ho Hr x I; [destruct I|].
  destruct one as [|e one], other as [|f other]; cbn [add_from] in I; [destruct I| | |];
    (destruct I as [<-|I]; [split; assumption|]).
  - exact (IH p (snd f) [] other P (Hr f (or_introl eq_refl)) Ho (fun g G => Hr g (or_intror G)) x I).
  - exact (IH (snd e) q one [] (Ho e (or_introl eq_refl)) Q (fun g G => Ho g (or_intror G)) Hr x I).
  - assert (He := Ho e (or_introl eq_refl)). assert (Hf := Hr f (or_introl eq_refl)).
    destruct (0 <? turn e f); [|destruct (turn e f <? 0)].
    + exact (IH (snd e) q one (f :: other) He Q (fun g G => Ho g (or_intror G)) Hr x I).
    + exact (IH p (snd f) (e :: one) other P Hf Ho (fun g G => Hr g (or_intror G)) x I).
    + exact (IH (snd e) (snd f) one other He Hf (fun g G => Ho g (or_intror G)) (fun g G => Hr g (or_intror G)) x I).
Qed.
Lemma add_in one other x : In x (add one other) -> In (fst x) one /\ In (snd x) other.
Proof.
  unfold add. destruct (from_lowest one) as [|p r] eqn:E; [intros []|]. destruct (from_lowest other) as [|q s] eqn:F; [intros []|].
  assert (Ho : forall v, In v (p :: r) -> In v one) by (intros v I; apply from_lowest_in; rewrite E; exact I).
  assert (Hr : forall v, In v (q :: s) -> In v other) by (intros v I; apply from_lowest_in; rewrite F; exact I).
  apply add_from_in.
  - apply Ho. left. reflexivity.
  - apply Hr. left. reflexivity.
  - intros e I. apply edges_ends in I as (_ & I). apply Ho, I.
  - intros e I. apply edges_ends in I as (_ & I). apply Hr, I.
Qed.

Lemma zip_all_in {A B} (f : A -> B -> bool) l m : zip_all f l m = true -> forall a, In a l -> exists b, In (a, b) (combine l m) /\ f a b = true.
Proof.
  revert m. induction l as [|a l IH]; intros [|b m] H; cbn [zip_all] in H; try discriminate; [intros a []|].
  apply andb_prop in H as (H1 & H2). intros c [<-|I]; [exists b; split; [left; reflexivity|exact H1]|].
  destruct (IH m H2 c I) as (d & D & F). exists d. split; [right; exact D|exact F].
Qed.
Lemma add_side_in f n m k g : In g (sides_at (add_side f n m) k) -> g = f \/ In g (sides_at m k).
Proof.
  unfold add_side. destruct (n <? 0); [|auto]. unfold sides_at. destruct (Pos.eq_dec k (Z.to_pos (- n))) as [->|N].
  - rewrite PositiveMap.gss. intros [<-|I]; auto.
  - rewrite PositiveMap.gso by exact N. auto.
Qed.
Lemma by_edge_in named k f : In f (sides_at (by_edge named) k) -> exists c, In (f, c) named.
Proof.
  induction named as [|(g, c) r IH]; cbn [by_edge fold_right fst snd].
  - unfold sides_at. rewrite PositiveMap.gempty. intros [].
  - intro I. assert (J : f = g \/ In f (sides_at (by_edge r) k)).
    { revert I. generalize c. clear. intro l. induction l as [|n l IH]; cbn [fold_right]; [auto|]. intro I. apply add_side_in in I as [I|I]; auto. }
    destruct J as [->|J]; [exists c; left; reflexivity|]. destruct (IH J) as (c' & I'). exists c'. right. exact I'.
Qed.
Lemma all_sided_spec f m es : forall k, all_sided f m k es = true -> forall e, In e es -> exists k', f (sides_at m k') e = true.
Proof.
  induction es as [|a es IH]; intros k H e; [intros []|]. cbn [all_sided] in H. apply andb_prop in H as (H1 & H2).
  intros [<-|I]; [exists k; exact H1|exact (IH _ H2 e I)].
Qed.

Open Scope Q_scope.
Section Scale.
Variable N : positive.
Notation qe := (qe N).
Notation qpt := (qpt N).

(* A third of a point at the denominator N *)
Definition third (z : pt) : qpoint := (fst z # 3 * N, snd z # 3 * N).
Lemma third_at z : pat (3 * Zpos N) (third z) z.
Proof.
  unfold pat, at_, third, Qeq, Qmult, inject_Z. cbn [fst snd Qnum Qden]. rewrite !Pos.mul_1_r.
  change (Z.pos (3 * N)) with (3 * Z.pos N)%Z. split; ring.
Qed.
Lemma grow_at z : pat (3 * Zpos N) (qpt z) (grow 3 z).
Proof. apply pat_grow, qpt_at. Qed.
Lemma left_of_spec z f : left_of z f = true -> 0 < o (qe f) (third z).
Proof.
  unfold left_of. intro H. apply Z.ltb_lt in H.
  pose proof (orient_at (3 * Zpos N) (qpt (fst f)) (qpt (snd f)) (third z) _ _ _ (grow_at _) (grow_at _) (third_at z)) as A.
  destruct (Qlt_le_dec 0 (o (qe f) (third z))) as [|L]; [assumption|exfalso].
  unfold o, Spans.qe in L. cbn [fst snd] in L.
  apply (at_le (3 * Zpos N * (3 * Zpos N)) _ _ _ 0%Z ltac:(lia) A (at_zero _)) in L. lia.
Qed.

Lemma convex_sides r : is_convex r = true -> convex (map qe (edges r)) /\ linked (map qe (edges r)).
Proof.
  destruct r as [|p t]; [discriminate|]. intro H. split.
  - intros f' g' F G. apply in_map_iff in F as (f & <- & F). apply in_map_iff in G as (g & <- & G).
    pose proof (edges_ends _ _ F) as (F1 & F2). split; [apply o_nonneg, (edge_left_weak p t H g _ G F1)|].
    split; [apply o_nonneg, (edge_left_weak p t H g _ G F2)|].
    destruct (edges_differ p t H g f G F) as [->|[L|L]]; [right; right; reflexivity|left|right; left]; apply o_pos, L.
  - intros f' F. apply in_map_iff in F as (f & <- & F). split.
    + destruct (previous p t H f F) as (g & G & E & L). exists (qe g). split; [apply in_map, G|]. split; [|apply o_pos, L].
      change (snd (qe g)) with (qpt (snd g)). rewrite E. split; reflexivity.
    + destruct (following p t H f F) as (g & G & E & L). exists (qe g). split; [apply in_map, G|]. split; [|apply o_pos, L].
      change (fst (qe g)) with (qpt (fst g)). rewrite E. split; reflexivity.
Qed.

Lemma ring_sides r : map qe (edges r) = Statements.edges (qring N r).
Proof. rewrite qedges_map. reflexivity. Qed.

(* The pieces of a shape *)
Lemma is_convex_spec r : is_convex r = true -> is_fan r = true /\ inS (Statements.edges (qring N r)) (third (center r)) /\ left_all (qring N r).
Proof.
  intro H. split; [exact (is_convex_fan r H)|]. destruct r as [|p t]; [discriminate|]. rewrite <- ring_sides. split.
  - intros f' I. apply in_map_iff in I as (f & <- & I). apply left_of_spec. apply Z.ltb_lt.
    destruct (in_edge p t f I) as (i & Li & E). destruct (third_vertex p t H i Li) as (j & J & L).
    assert (W : forall x, In x (p :: t) -> (0 <= det (fst f) (snd f) x)%Z) by (intro x; apply (edge_left_weak p t H f x I)).
    destruct t as [|q [|s l]]; try discriminate. pose proof (W p ltac:(cbn; auto)). pose proof (W q ltac:(cbn; auto)). pose proof (W s ltac:(cbn; auto)).
    assert (P : (0 < det (fst f) (snd f) p \/ 0 < det (fst f) (snd f) q \/ 0 < det (fst f) (snd f) s)%Z)
      by (rewrite E; destruct j as [|[|[|j]]]; [left|right; left|right; right|lia]; exact L).
    assert (S : det (grow 3 (fst f)) (grow 3 (snd f)) (center (p :: q :: s :: l)) = (3 * (det (fst f) (snd f) p + det (fst f) (snd f) q + det (fst f) (snd f) s))%Z)
      by (unfold center, plus, det, grow; cbn [fst snd]; ring).
    rewrite S. lia.
  - intros f' v' I V. rewrite <- ring_sides in I. apply in_map_iff in I as (f & <- & I). apply in_map_iff in V as (v & <- & V).
    apply o_nonneg, (edge_left_weak p t H f v I V).
Qed.

(* Winding numbers along a segment that avoids all edges *)
Lemma loops_at loops k z v : (0 < k)%Z -> pat k z v -> Statements.winding (map (qring N) loops) z = W k loops (grow (Zpos N) v).
Proof.
  intros K V. apply winding_W; [reflexivity|exact K| |exact V]. unfold rings_at. induction loops as [|r l IH]; constructor; [apply qring_at|exact IH].
Qed.
Lemma wind_sides_qe loops z : wind_sides (map qe (flat_map edges loops)) z = Statements.winding (map (qring N) loops) z.
Proof.
  unfold wind_sides, Statements.winding. f_equal. f_equal.
  induction loops as [|r l IH]; [reflexivity|]. cbn [flat_map map]. rewrite map_app, IH, ring_sides. reflexivity.
Qed.
Theorem constant_loops loops x y :
  (forall e, In e (flat_map edges loops) -> exists n m, qdot n x * inject_Z (Zpos N) < inject_Z m /\
    qdot n y * inject_Z (Zpos N) < inject_Z m /\ (m <= dot n (fst e))%Z /\ (m <= dot n (snd e))%Z) ->
  Statements.winding (map (qring N) loops) x = Statements.winding (map (qring N) loops) y.
Proof.
  intro H. destruct (pat_common x y) as (k & v & u & K & V & X).
  rewrite (loops_at loops k x v K V), (loops_at loops k y u K X). rewrite <- !W_edges.
  apply constant; [apply closed_rings|]. intros e' E'.
  assert (G : exists e0, In e0 (flat_map edges loops) /\ e' = grow_edge k e0).
  { apply in_flat_map in E' as (r' & R' & E'). apply in_map_iff in R' as (r & <- & R'). rewrite edges_map in E'.
    apply in_map_iff in E' as (e0 & <- & E'). exists e0. split; [apply in_flat_map; exists r; auto|reflexivity]. }
  destruct G as (e0 & E0 & ->). destruct (H e0 E0) as (n & m & H1 & H2 & H3 & H4).
  assert (Side : forall z w, pat k z w -> qdot n z * inject_Z (Zpos N) < inject_Z m -> (dot n (grow (Zpos N) w) < k * m)%Z).
  { intros z w Z0 L0. pose proof (qdot_at n _ z _ (pat_grow' (Zpos N) k z w Z0)) as Q1. unfold at_ in Q1.
    rewrite Zlt_Qlt, <- Q1, !inject_Z_mult. pose proof (inject_pos k K) as Kq.
    pose proof (mono_lt (inject_Z k) _ _ Kq L0). lra. }
  pose proof (Side x v V H1) as S1. pose proof (Side y u X H2) as S2.
  exists (2 * fst n, 2 * snd n, 1 - 2 * (k * m))%Z. unfold val, grow_edge. cbn [fst snd].
  assert (E1 : (dot n (grow k (fst e0)) = k * dot n (fst e0))%Z) by apply dot_grow.
  assert (E2 : (dot n (grow k (snd e0)) = k * dot n (snd e0))%Z) by apply dot_grow.
  unfold dot in *. repeat split; nia.
Qed.

Lemma qdot_qpt n v : qdot n (qpt v) * inject_Z (Zpos N) == inject_Z (dot n v).
Proof. exact (qdot_at n (Zpos N) (qpt v) v (qpt_at N v)). Qed.

Lemma frac_lt a b : (a # N) < (b # N) <-> (a < b)%Z.
Proof. unfold Qlt, Qnum, Qden. rewrite <- Z.mul_lt_mono_pos_r; [reflexivity|apply Pos2Z.is_pos]. Qed.
Lemma frac_le a b : (a # N) <= (b # N) <-> (a <= b)%Z.
Proof. unfold Qle, Qnum, Qden. rewrite <- Z.mul_le_mono_pos_r; [reflexivity|apply Pos2Z.is_pos]. Qed.

Lemma distinct_spec e g : distinct e g = true -> Boundary.distinct (qe e) (qe g).
Proof.
  assert (Low : forall f, (Z.min (snd (fst f)) (snd (snd f)) # N) == low (qe f)).
  { intro f. unfold low, Spans.qe, PiecePoints.qpt. cbn [fst snd]. destruct (Qlt_le_dec _ _) as [L|L].
    - rewrite Z.min_l; [reflexivity|]. apply (proj1 (frac_lt _ _)) in L; apply Z.lt_le_incl; exact L.
    - rewrite Z.min_r; [reflexivity|]. apply (proj1 (frac_le _ _)) in L; exact L. }
  assert (High : forall f, (Z.max (snd (fst f)) (snd (snd f)) # N) == high (qe f)).
  { intro f. unfold high, Spans.qe, PiecePoints.qpt. cbn [fst snd]. destruct (Qlt_le_dec _ _) as [L|L].
    - rewrite Z.max_r; [reflexivity|]. apply (proj1 (frac_lt _ _)) in L; apply Z.lt_le_incl; exact L.
    - rewrite Z.max_l; [reflexivity|]. apply (proj1 (frac_le _ _)) in L; exact L. }
  unfold distinct, Boundary.distinct. intro H. apply orb_prop in H as [H|H].
  2:{ right. right. right. apply Z.leb_le in H. rewrite <- Low, <- High. apply frac_le, H. }
  apply orb_prop in H as [H|H].
  2:{ right. right. left. apply Z.leb_le in H. rewrite <- Low, <- High. apply frac_le, H. }
  apply orb_prop in H as [H|H]; apply negb_true_iff, Z.eqb_neq in H.
  - left. intro E. apply H. apply inject_Z_injective. unfold turn.
    repeat (rewrite ?inject_Z_mult, ?inject_Z_plus, ?inject_Z_opp || unfold Z.sub).
    unfold rise, run, Spans.qe, PiecePoints.qpt in E. cbn [fst snd] in E. rewrite !(qfrac N) in E.
    apply (Qmult_inj_r _ _ (unit N * unit N)); [pose proof (unit_pos N); lra|]. change (inject_Z 0) with 0. rewrite Qmult_0_l.
    assert (X : forall p, p == 0 -> - p == 0) by (intros p P; rewrite P; ring). apply X in E. rewrite <- E. ring.
  - right. left. change (fst (qe g)) with (qpt (fst g)). rewrite o_qpt. intro E. apply Qmult_integral in E as [E|E].
    + apply H. apply inject_Z_injective. exact E.
    + pose proof (unit_pos N). lra.
Qed.

Lemma along_rise e f : det (fst e) (snd e) (fst f) = 0%Z -> det (fst e) (snd e) (snd f) = 0%Z -> fst e <> snd e -> fst f <> snd f ->
  (rightwards e = rightwards f -> (snd (fst e) < snd (snd e) -> snd (fst f) < snd (snd f))%Z /\ (snd (snd e) < snd (fst e) -> snd (snd f) < snd (fst f))%Z) /\
  (rightwards e <> rightwards f -> (snd (snd e) < snd (fst e) -> snd (fst f) < snd (snd f))%Z).
Proof.
  destruct e as [[ax ay] [bx b_y]], f as [[px py] [qx qy]]. unfold det, rightwards. cbn [fst snd]. intros A B E F.
  assert (C : ((bx - ax) * (qy - py) = (b_y - ay) * (qx - px))%Z) by lia.
  assert (E' : (bx <> ax \/ b_y <> ay)%Z) by (destruct (Z.eq_dec bx ax); [right; intro; apply E; f_equal; lia|left; assumption]).
  assert (F' : (qx <> px \/ qy <> py)%Z) by (destruct (Z.eq_dec qx px); [right; intro; apply F; f_equal; lia|left; assumption]).
  clear A B E F. destruct (Z.ltb_spec ax bx), (Z.eqb_spec ax bx), (Z.ltb_spec px qx), (Z.eqb_spec px qx), (Z.ltb_spec ay b_y), (Z.ltb_spec py qy);
    cbn [orb andb]; (split; [intro R; try discriminate R|intro R; try (exfalso; apply R; reflexivity)]); try split; intros; nia.
Qed.
Lemma rise_pos e : 0 < rise (qe e) <-> (snd (fst e) < snd (snd e))%Z.
Proof.
  unfold rise, Spans.qe, PiecePoints.qpt. cbn [fst snd]. split; intro H.
  - assert (L : (snd (fst e) # N) < (snd (snd e) # N)) by lra. apply (proj1 (frac_lt _ _)) in L; exact L.
  - assert (L : (snd (fst e) # N) < (snd (snd e) # N)) by (apply frac_lt; assumption). lra.
Qed.
Lemma rise_neg e : rise (qe e) < 0 <-> (snd (snd e) < snd (fst e))%Z.
Proof.
  unfold rise, Spans.qe, PiecePoints.qpt. cbn [fst snd]. split; intro H.
  - assert (L : (snd (snd e) # N) < (snd (fst e) # N)) by lra. apply (proj1 (frac_lt _ _)) in L; exact L.
  - assert (L : (snd (snd e) # N) < (snd (fst e) # N)) by (apply frac_lt; assumption). lra.
Qed.

Lemma on_point_at e x : Statements.on_segment e x -> exists s, 0 <= s <= 1 /\ meets_at (point_at e s) x.
Proof. intros (s & S & X & Y). exists s. split; [exact S|]. split; unfold point_at; cbn [fst snd]; symmetry; assumption. Qed.
End Scale.
