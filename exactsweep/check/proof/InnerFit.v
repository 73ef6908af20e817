(* The checker of inner fits, and its theorem. The part leaves the frame at positions in four half-planes; it leaves the
   container at these positions and at sums of a piece outside the container and a piece of the part. *)
Require Import QArith Lqa ZArith Lia List Bool Permutation.
From Exactsweep Require Import Cancel Constant Fans Pieces Convex Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers Spans Sums SumsSound Pairs.
Import ListNotations.
Open Scope Q_scope.

Record inner_fit_certificate := {
  unit : positive; box : Z * Z * Z * Z;            (* the frame: left, bottom, right, top *)
  outside : list ring; part : list ring; listed_sums : list (Z * list (list Z)); around : list (list Z) }.

(* The edges of a reversed ring are the reversed edges. *)
Definition swap (e : side) : side := (snd e, fst e).
Lemma swap_on e x : Statements.on_segment (swap e) x <-> Statements.on_segment e x.
Proof.
  assert (H : forall e, Statements.on_segment e x -> Statements.on_segment (swap e) x).
  { intros f (s & (S0 & S1) & X & Y). exists (1 - s). unfold swap. cbn [fst snd]. split; [lra|]. rewrite X, Y. split; ring. }
  split; [|apply H]. intro S. apply H in S. destruct e; exact S.
Qed.
Lemma crossing_swap z e : Statements.crossing z (swap e) = (- Statements.crossing z e)%Z.
Proof.
  destruct e as [a b]. unfold swap. cbn [fst snd]. unfold Statements.crossing.
  assert (E : Statements.orient b a z == - Statements.orient a b z) by (unfold Statements.orient; ring).
  destruct (leb_cases (snd b) (snd z)) as [(A & ->)|(A & ->)]; destruct (less_cases (snd z) (snd a)) as [(B & ->)|(B & ->)];
  destruct (leb_cases (snd a) (snd z)) as [(C & ->)|(C & ->)]; destruct (less_cases (snd z) (snd b)) as [(F & ->)|(F & ->)];
  try (exfalso; lra); cbn [andb]; try reflexivity.
  - destruct (less_cases 0 (Statements.orient b a z)) as [(X & ->)|(X & ->)];
    destruct (less_cases (Statements.orient a b z) 0) as [(Y & ->)|(Y & ->)]; try reflexivity; exfalso; lra.
  - destruct (less_cases (Statements.orient b a z) 0) as [(X & ->)|(X & ->)];
    destruct (less_cases 0 (Statements.orient a b z)) as [(Y & ->)|(Y & ->)]; try reflexivity; exfalso; lra.
Qed.

Fixpoint path (l : list qpoint) : list side :=
  match l with a :: ((b :: _) as m) => (a, b) :: path m | _ => [] end.
Lemma path_cons a b m : path (a :: b :: m) = (a, b) :: path (b :: m).
Proof. reflexivity. Qed.
Lemma edges_path p t : Statements.edges (p :: t) = path (p :: t ++ [p]).
Proof.
  cbn [Statements.edges]. assert (G : forall t a b, combine (a :: t) (t ++ [b]) = path (a :: t ++ [b])); [|apply G].
  clear. induction t as [|c t IH]; intros a b; [reflexivity|]. cbn [app combine]. rewrite path_cons, <- IH. reflexivity.
Qed.
Lemma path_snoc l a b : path (l ++ [a; b]) = path (l ++ [a]) ++ [(a, b)].
Proof.
  induction l as [|c l IH]; [reflexivity|]. cbn [app]. destruct l as [|d l]; [reflexivity|]. cbn [app] in *. rewrite !path_cons, IH. reflexivity.
Qed.
Lemma path_rev l : path (rev l) = rev (map swap (path l)).
Proof.
  induction l as [|a l IH]; [reflexivity|]. destruct l as [|b l]; [reflexivity|]. rewrite path_cons. cbn [map rev] in *.
  rewrite <- app_assoc. cbn [app]. rewrite path_snoc, IH. reflexivity.
Qed.
Lemma edges_rev r : Permutation (Statements.edges (rev r)) (map swap (Statements.edges r)).
Proof.
  destruct r as [|p t]; [constructor|]. rewrite edges_path. cbn [rev].
  rewrite (Permutation_rev (map swap (path (p :: t ++ [p])))), <- path_rev. cbn [rev]. rewrite rev_app_distr. cbn [rev app].
  destruct (rev t) as [|q u]; [reflexivity|]. cbn [app]. rewrite edges_path, path_cons.
  replace (q :: (u ++ [p]) ++ [q]) with ((q :: u) ++ [p; q]) by (cbn [app]; rewrite <- app_assoc; reflexivity).
  rewrite path_snoc. rewrite Permutation_app_comm. reflexivity.
Qed.
Lemma wind_perm es fs z : Permutation es fs -> wind_sides es z = wind_sides fs z.
Proof. unfold wind_sides. induction 1; cbn [map fold_right] in *; lia. Qed.
Lemma wind_swap es z : wind_sides (map swap es) z = (- wind_sides es z)%Z.
Proof. unfold wind_sides. induction es as [|e es IH]; [reflexivity|]. cbn [map fold_right]. rewrite IH, crossing_swap. lia. Qed.
Lemma all_edges_rev rs : Permutation (flat_map Statements.edges (map (@rev _) rs)) (map swap (flat_map Statements.edges rs)).
Proof.
  induction rs as [|r rs IH]; [constructor|]. cbn [map flat_map]. rewrite map_app. apply Permutation_app; [apply edges_rev|exact IH].
Qed.
Lemma winding_rev rs z : Statements.winding (map (@rev _) rs) z = (- Statements.winding rs z)%Z.
Proof.
  change (wind_sides (flat_map Statements.edges (map (@rev _) rs)) z = - wind_sides (flat_map Statements.edges rs) z)%Z.
  rewrite (wind_perm _ _ z (all_edges_rev rs)). apply wind_swap.
Qed.
Lemma on_any_rev rs fits z : Statements.on_any (flat_map Statements.edges (map (@rev _) rs) ++ fits) z <-> Statements.on_any (flat_map Statements.edges rs ++ fits) z.
Proof.
  split; intros (e & I & X); apply in_app_or in I as [I|I].
  - apply (Permutation_in _ (all_edges_rev rs)) in I. apply in_map_iff in I as (f & <- & I). exists f.
    split; [apply in_or_app; left; exact I|apply swap_on, X].
  - exists e. split; [apply in_or_app; right; exact I|exact X].
  - exists (swap e). split; [|apply swap_on, X]. apply in_or_app. left.
    apply (Permutation_in _ (Permutation_sym (all_edges_rev rs))), in_map, I.
  - exists e. split; [apply in_or_app; right; exact I|exact X].
Qed.

(* An edge that is not to the right of z, or not at its height, contributes nothing. *)
Lemma crossing_none z a b : (snd a <= snd z /\ snd b <= snd z) \/ (snd z < snd a /\ snd z < snd b) \/
  (fst a <= fst z /\ fst b <= fst z) -> Statements.crossing z (a, b) = 0%Z.
Proof.
  intro H. unfold Statements.crossing.
  destruct (leb_cases (snd a) (snd z)) as [(A & ->)|(A & ->)]; destruct (less_cases (snd z) (snd b)) as [(B & ->)|(B & ->)];
  destruct (leb_cases (snd b) (snd z)) as [(C & ->)|(C & ->)]; destruct (less_cases (snd z) (snd a)) as [(F & ->)|(F & ->)];
  try (exfalso; lra); cbn [andb]; try reflexivity.
  - destruct (less_cases 0 (Statements.orient a b z)) as [(X & ->)|(X & ->)]; [exfalso|reflexivity].
    destruct H as [H|[H|(H1 & H2)]]; [lra|lra|].
    assert (E : Statements.orient a b z == - ((snd b - snd z) * (fst z - fst a) + (snd z - snd a) * (fst z - fst b)))
      by (unfold Statements.orient; ring).
    assert (0 <= (snd b - snd z) * (fst z - fst a)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (snd z - snd a) * (fst z - fst b)) by (apply Qmult_le_0_compat; lra). lra.
  - destruct (less_cases (Statements.orient a b z) 0) as [(X & ->)|(X & ->)]; [exfalso|reflexivity].
    destruct H as [H|[H|(H1 & H2)]]; [lra|lra|].
    assert (E : Statements.orient a b z == (snd a - snd z) * (fst z - fst b) + (snd z - snd b) * (fst z - fst a))
      by (unfold Statements.orient; ring).
    assert (0 <= (snd a - snd z) * (fst z - fst b)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (snd z - snd b) * (fst z - fst a)) by (apply Qmult_le_0_compat; lra). lra.
Qed.

Lemma count_ge k ps P z : (0 < k)%Z -> fans ps -> In P ps -> ring_wind (map (grow k) P) z = 1%Z -> (1 <= count k ps z)%Z.
Proof.
  intros K. induction ps as [|q r IH]; intros F J X; [destruct J|]. cbn [count].
  assert (Fr : fans r) by (intros x Ix; apply F; right; assumption).
  pose proof (proj1 (count_some k r z K Fr)). pose proof (piece_01 _ z (is_fan_grow k q K (F q (or_introl eq_refl)))).
  destruct J as [->|J]; [lia|]. specialize (IH Fr J X). lia.
Qed.

Lemma scale_le N k a q n : (0 < k)%Z -> at_ k q n -> (a # N <= q <-> (k * a <= Zpos N * n)%Z).
Proof.
  intros K H. apply (at_le (k * Zpos N)); [nia| |].
  - unfold at_, Qeq, Qmult, inject_Z. cbn [Qnum Qden]. rewrite Pos.mul_1_r. ring.
  - unfold at_ in *. rewrite !inject_Z_mult, <- H. ring.
Qed.
Lemma scale_lt N k a q n : (0 < k)%Z -> at_ k q n -> (q < a # N <-> (Zpos N * n < k * a)%Z).
Proof.
  intros K H. pose proof (scale_le N k a q n K H) as E. split; intro L.
  - destruct (Z.lt_ge_cases (Zpos N * n) (k * a)) as [|G]; [assumption|exfalso]. apply E in G. lra.
  - destruct (Qlt_le_dec q (a # N)) as [|G]; [assumption|exfalso]. apply E in G. lia.
Qed.

Section Data.
Variables (C G regions : list Statements.ring) (fits : list side) (c : inner_fit_certificate).
Let N := unit c.
Let fl := fst (fst (fst (box c))).
Let fb := snd (fst (fst (box c))).
Let fr := snd (fst (box c)).
Let ft := snd (box c).
Definition corners_of_part : list pt := concat (part c).
Definition extreme (best : pt -> pt -> list pt -> Z) (n : pt) : Z :=
  match corners_of_part with v :: vs => best n v vs | [] => 0%Z end.
(* The rectangle of positions at which the part is in the frame *)
Let bl := (fl - extreme min_dot (1, 0))%Z.
Let bb := (fb - extreme min_dot (0, 1))%Z.
Let br := (fr - extreme max_dot (1, 0))%Z.
Let bt := (ft - extreme max_dot (0, 1))%Z.
Definition beyond_box : list edge :=
  [((br, bb), (bl, bb)); ((br, bt), (br, bb)); ((bl, bt), (br, bt)); ((bl, bb), (bl, bt))].
Definition half_planes : list (list side) := map (fun f => [qe N f]) beyond_box.
(* Oriented with the positions at which the part does not fit on the left *)
Definition loops : list ring := map (@rev pt) (int_rings (Zpos N) regions).
Definition segments : list side := flat_map Statements.edges regions ++ fits.
Definition solid_G : solid := {| rings := int_rings (Zpos N) G; pieces := part c |}.
Definition in_box (p : qpoint) : bool :=
  Qle_bool (bl # N) (fst p) && Qle_bool (fst p) (br # N) && Qle_bool (bb # N) (snd p) && Qle_bool (snd p) (bt # N).

Definition check_inner_fit : bool :=
  all_integral (Zpos N) C && all_integral (Zpos N) G && all_integral (Zpos N) regions && forallb (integral_edge N) fits &&
  (fl <? fr)%Z && (fb <? ft)%Z && (bl <? br)%Z && (bb <? bt)%Z &&
  cancel (flat_map edges (outside c) ++ flat_map edges (int_rings (Zpos N) C)) (edges (box_ring fl fb fr ft)) &&
  simple_solid solid_G &&
  forallb (fun e => in_box (fst e) && in_box (snd e)) segments &&
  forallb is_convex (outside c) &&
  Sums.boundary (outside c) (map turned (part c)) beyond_box loops (map (int_edge N) fits) (listed_sums c) (around c) 0.

Section Accepted.
Hypothesis IC : all_integral (Zpos N) C = true.
Hypothesis IG : all_integral (Zpos N) G = true.
Hypothesis IR : all_integral (Zpos N) regions = true.
Hypothesis Fx : (fl < fr)%Z.
Hypothesis Fy : (fb < ft)%Z.
Hypothesis Bx : (bl < br)%Z.
Hypothesis By : (bb < bt)%Z.
Hypothesis Cn : cancel (flat_map edges (outside c) ++ flat_map edges (int_rings (Zpos N) C)) (edges (box_ring fl fb fr ft)) = true.
Hypothesis SG : simple_solid solid_G = true.
Hypothesis Within : forall e, In e segments -> in_box (fst e) = true /\ in_box (snd e) = true.
Hypothesis PO : forall P, In P (outside c) -> is_convex P = true.
Hypothesis PG : forall Q, In Q (part c) -> is_convex Q = true.

Lemma FO : fans (outside c).
Proof. intros P I. exact (proj1 (is_convex_spec N P (PO P I))). Qed.
Lemma fan_part : fans (part c).
Proof. intros P I. exact (proj1 (is_convex_spec N P (PG P I))). Qed.

Definition beyond (t : qpoint) : Prop := fst t < bl # N \/ br # N < fst t \/ snd t < bb # N \/ bt # N < snd t.
Definition O (t : qpoint) : Prop := beyond t \/ exists P Q, In P (outside c) /\ In Q (part c) /\ shares N P Q t.

Lemma box_order : bl # N < br # N /\ bb # N < bt # N.
Proof. unfold Qlt. cbn. split; nia. Qed.

Lemma half_beyond t : (exists S, In S half_planes /\ inS S t) <-> beyond t.
Proof.
  destruct box_order as (X & Y). unfold half_planes, beyond_box, inS, beyond, o, Statements.orient, qe, qpt. cbn [map fst snd].
  assert (Pos : forall a b, 0 < a -> (0 < a * b <-> 0 < b)).
  { intros a b A. split; intro H; [|apply Qmult_lt_0_compat; assumption].
    destruct (Qlt_le_dec 0 b) as [|L]; [assumption|exfalso]. assert (0 <= a * - b) by (apply Qmult_le_0_compat; lra). lra. }
  split.
  - intros (S & [<-|[<-|[<-|[<-|[]]]]] & H); specialize (H _ (or_introl eq_refl)); cbn [fst snd] in H.
    + right; right; left. assert (0 < (bb # N) - snd t); [|lra]. apply (Pos ((br # N) - (bl # N))); lra.
    + right; left. assert (0 < fst t - (br # N)); [|lra]. apply (Pos ((bt # N) - (bb # N))); lra.
    + right; right; right. assert (0 < snd t - (bt # N)); [|lra]. apply (Pos ((br # N) - (bl # N))); lra.
    + left. assert (0 < (bl # N) - fst t); [|lra]. apply (Pos ((bt # N) - (bb # N))); lra.
  - assert (P1 : 0 < (br # N) - (bl # N)) by lra. assert (P2 : 0 < (bt # N) - (bb # N)) by lra.
    intros [H|[H|[H|H]]].
    + eexists. split; [right; right; right; left; reflexivity|]. intros f [<-|[]]. cbn [fst snd].
      pose proof (proj2 (Pos _ ((bl # N) - fst t) P2) ltac:(lra)). lra.
    + eexists. split; [right; left; reflexivity|]. intros f [<-|[]]. cbn [fst snd].
      pose proof (proj2 (Pos _ (fst t - (br # N)) P2) ltac:(lra)). lra.
    + eexists. split; [left; reflexivity|]. intros f [<-|[]]. cbn [fst snd].
      pose proof (proj2 (Pos _ ((bb # N) - snd t) P1) ltac:(lra)). lra.
    + eexists. split; [right; right; left; reflexivity|]. intros f [<-|[]]. cbn [fst snd].
      pose proof (proj2 (Pos _ (snd t - (bt # N)) P1) ltac:(lra)). lra.
Qed.

(* No point of L is in a half-plane beyond the box. *)
Lemma in_box_spec p : in_box p = true -> (bl # N <= fst p <= br # N) /\ (bb # N <= snd p <= bt # N).
Proof.
  unfold in_box. intro H. repeat match type of H with _ && _ = true => let X := fresh "X" in apply andb_prop in H as (H & X); apply Qle_bool_iff in X end.
  apply Qle_bool_iff in H. lra.
Qed.

Lemma region_edge e : In e (flat_map Statements.edges regions) ->
  (bl # N <= fst (fst e) <= br # N /\ bb # N <= snd (fst e) <= bt # N) /\
  (bl # N <= fst (snd e) <= br # N /\ bb # N <= snd (snd e) <= bt # N).
Proof.
  intro I. destruct (Within e (in_or_app _ _ _ (or_introl I))) as (A & B). apply in_box_spec in A, B. split; assumption.
Qed.
Lemma no_crossing t : (forall e, In e (flat_map Statements.edges regions) -> Statements.crossing t e = 0%Z) ->
  Statements.winding regions t = 0%Z.
Proof. intro H. exact (wind_zero (flat_map Statements.edges regions) t H). Qed.
Lemma above_zero t : bt # N < snd t -> Statements.winding regions t = 0%Z.
Proof.
  intro H. apply no_crossing. intros [a b] I. pose proof (region_edge _ I) as ((_ & A) & _ & B). cbn [fst snd] in *.
  apply crossing_none. left. lra.
Qed.

Lemma beyond_zero t : beyond t -> Statements.winding regions t = 0%Z.
Proof.
  intros [B|[B|[B|B]]].
  - rewrite (constant_rings (Zpos N) regions t (fst t, (bt # N) + 1)); [apply above_zero; cbn [snd]; lra|reflexivity|exact IR|].
    intros e I. destruct (region_edge e I) as ((A & _) & (A' & _)). exists (1, 0)%Z, bl. unfold qdot. cbn [fst snd].
    change (inject_Z 1) with 1. change (inject_Z 0) with 0.
    assert (Nq : 0 < inject_Z (Zpos N)) by (apply inject_pos; reflexivity).
    assert (E : inject_Z bl == (bl # N) * inject_Z (Zpos N)) by (unfold Qeq, Qmult, inject_Z; cbn; rewrite Pos.mul_1_r; ring).
    rewrite E. repeat split.
    + apply Qmult_lt_r; [exact Nq|]. lra.
    + apply Qmult_lt_r; [exact Nq|]. lra.
    + apply Qmult_le_compat_r; lra.
    + apply Qmult_le_compat_r; lra.
  - apply no_crossing. intros [a b] I. pose proof (region_edge _ I) as ((A & _) & A' & _). cbn [fst snd] in *.
    apply crossing_none. right. right. lra.
  - apply no_crossing. intros [a b] I. pose proof (region_edge _ I) as ((_ & A) & _ & A'). cbn [fst snd] in *.
    apply crossing_none. right. left. lra.
  - apply above_zero, B.
Qed.
Lemma beyond_iff t : beyond_at N beyond_box t <-> beyond t.
Proof.
  rewrite <- half_beyond. unfold half_planes. split.
  - intros (f & I & F). exists [qe N f]. split; [exact (in_map (fun f => [qe N f]) _ f I)|]. intros g [<-|[]]. exact F.
  - intros (S & I & J). apply in_map_iff in I as (f & <- & I). exists f. split; [exact I|]. apply J. left. reflexivity.
Qed.
Lemma box_line f x : In f beyond_box -> o (qe N f) x == 0 -> Statements.on_segment (qe N f) x \/ beyond x.
Proof.
  intros I X. destruct box_order as (Ox & Oy).
  destruct (Qlt_le_dec (fst x) (bl # N)) as [H1|H1]; [right; left; exact H1|].
  destruct (Qlt_le_dec (br # N) (fst x)) as [H2|H2]; [right; right; left; exact H2|].
  destruct (Qlt_le_dec (snd x) (bb # N)) as [H3|H3]; [right; right; right; left; exact H3|].
  destruct (Qlt_le_dec (bt # N) (snd x)) as [H4|H4]; [right; right; right; right; exact H4|].
  left. apply on_b_spec. unfold on_b.
  assert (Zero : forall a b, 0 < a -> a * b == 0 -> b == 0).
  { intros a b A E. apply Qmult_integral in E. destruct E; [lra|assumption]. }
  apply andb_true_intro. split; [apply andb_true_intro; split; [apply Qeq_bool_iff, X|]|].
  - destruct I as [<-|[<-|[<-|[<-|[]]]]]; unfold qe in *; cbn [fst snd] in *; unfold o, Statements.orient, qpt in X; unfold qpt; cbn [fst snd] in X |- *;
      unfold within; apply orb_true_intro.
    + right. apply andb_true_intro. split; apply Qle_bool_iff; assumption.
    + left. assert (fst x - (br # N) == 0) by (apply (Zero ((bt # N) - (bb # N))); lra). apply andb_true_intro. split; apply Qle_bool_iff; lra.
    + left. apply andb_true_intro. split; apply Qle_bool_iff; assumption.
    + left. assert (fst x - (bl # N) == 0) by (apply (Zero ((bt # N) - (bb # N))); lra). apply andb_true_intro. split; apply Qle_bool_iff; lra.
  - destruct I as [<-|[<-|[<-|[<-|[]]]]]; unfold qe in *; cbn [fst snd] in *; unfold o, Statements.orient, qpt in X; unfold qpt; cbn [fst snd] in X |- *;
      unfold within; apply orb_true_intro.
    + left. assert (snd x - (bb # N) == 0) by (apply (Zero ((br # N) - (bl # N))); lra). apply andb_true_intro. split; apply Qle_bool_iff; lra.
    + right. apply andb_true_intro. split; apply Qle_bool_iff; assumption.
    + left. assert (snd x - (bt # N) == 0) by (apply (Zero ((br # N) - (bl # N))); lra). apply andb_true_intro. split; apply Qle_bool_iff; lra.
    + left. apply andb_true_intro. split; apply Qle_bool_iff; assumption.
Qed.

(* In the container: in the frame, and in no piece of the complement. *)
Definition in_frame_at (z : qpoint) : Prop := fl # N <= fst z < fr # N /\ fb # N <= snd z < ft # N.
Lemma container_wind z :
  (in_frame_at z -> (forall P, In P (outside c) -> Statements.winding [qring N P] z <> 1%Z) -> Statements.winding C z = 1%Z) /\
  (Statements.winding C z = 1%Z -> in_frame_at z /\ forall P, In P (outside c) -> Statements.winding [qring N P] z <> 1%Z).
Proof.
  destruct (pat_common z z) as (k & v & _ & K & V & _).
  rewrite (winding_W (Zpos N) k C (int_rings (Zpos N) C) z v); [|reflexivity|exact K|apply int_rings_at, IC|exact V].
  pose proof (cancel_wind k _ _ (grow (Zpos N) v) K Cn) as E. rewrite map_app, wind_app in E.
  fold (W k (outside c) (grow (Zpos N) v)) (W k (int_rings (Zpos N) C) (grow (Zpos N) v)) in E. rewrite W_count in E.
  pose proof (box_wind k fl fb fr ft (grow (Zpos N) v) K Fx Fy) as B. unfold W at 1 in B. cbn [flat_map] in B.
  rewrite app_nil_r in B. rewrite B in E. clear B.
  destruct (count_some k (outside c) (grow (Zpos N) v) K FO) as (C1 & C2).
  destruct V as (Vx & Vy). pose proof (conj Vx Vy : pat k z v) as V. unfold in_frame_at.
  rewrite (scale_le N k fl _ _ K Vx), (scale_lt N k fr _ _ K Vx), (scale_le N k fb _ _ K Vy), (scale_lt N k ft _ _ K Vy).
  change (Zpos N * fst v)%Z with (fst (grow (Zpos N) v)) in *. change (Zpos N * snd v)%Z with (snd (grow (Zpos N) v)) in *.
  split.
  - intros ((F1 & F2) & F3 & F4) NP.
    assert (C3 : ~ (1 <= count k (outside c) (grow (Zpos N) v))%Z).
    { intro H. destruct (C2 H) as (P & IP & X). apply (NP P IP). rewrite (piece_at N k P z v K V). exact X. }
    destruct (Z.leb_spec (k * fl) (fst (grow (Zpos N) v))); [|lia]. destruct (Z.ltb_spec (fst (grow (Zpos N) v)) (k * fr)); [|lia].
    destruct (Z.leb_spec (k * fb) (snd (grow (Zpos N) v))); [|lia]. destruct (Z.ltb_spec (snd (grow (Zpos N) v)) (k * ft)); [|lia].
    cbn [andb] in E. lia.
  - intro W1. rewrite W1 in E.
    destruct (Z.leb_spec (k * fl) (fst (grow (Zpos N) v))); [|cbn [andb] in E; lia].
    destruct (Z.ltb_spec (fst (grow (Zpos N) v)) (k * fr)); [|cbn [andb] in E; lia].
    destruct (Z.leb_spec (k * fb) (snd (grow (Zpos N) v))); [|cbn [andb] in E; lia].
    destruct (Z.ltb_spec (snd (grow (Zpos N) v)) (k * ft)); [|cbn [andb] in E; lia].
    split; [split; split; assumption|]. intros P IP X. rewrite (piece_at N k P z v K V) in X.
    pose proof (count_ge k (outside c) P _ K FO IP X). cbn [andb] in E. lia.
Qed.

Lemma part_pieces z : Statements.winding G z = 1%Z <-> exists Q, In Q (part c) /\ Statements.winding [qring N Q] z = 1%Z.
Proof. exact (count_pieces N solid_G G z SG IG eq_refl). Qed.

(* The box of the part *)
Lemma extreme_spec n v : In v corners_of_part -> (extreme min_dot n <= dot n v <= extreme max_dot n)%Z.
Proof.
  unfold extreme. destruct corners_of_part as [|w ws]; [intros []|]. intro I.
  split; [apply min_dot_spec, I|apply max_dot_spec, I].
Qed.
Lemma corner_in Q v : In Q (part c) -> In v Q -> In v corners_of_part.
Proof. intros IQ I. apply in_concat. exists Q. auto. Qed.

Lemma part_box Q w : In Q (part c) -> Statements.winding [qring N Q] w = 1%Z ->
  (extreme min_dot (1, 0)%Z # N <= fst w < extreme max_dot (1, 0)%Z # N) /\
  (extreme min_dot (0, 1)%Z # N <= snd w < extreme max_dot (0, 1)%Z # N).
Proof.
  intros IQ X. destruct (pat_common w w) as (k & v & _ & K & V & _). rewrite (piece_at N k Q w v K V) in X.
  assert (B : in_frame 0 (extreme min_dot (1, 0)%Z, extreme min_dot (0, 1)%Z, extreme max_dot (1, 0)%Z, extreme max_dot (0, 1)%Z) Q = true).
  { unfold in_frame. rewrite forallb_forall. intros u I.
    pose proof (extreme_spec (1, 0)%Z u (corner_in Q u IQ I)) as A. pose proof (extreme_spec (0, 1)%Z u (corner_in Q u IQ I)) as B.
    unfold dot in A, B. cbn [fst snd] in A, B.
    apply andb_true_intro; split; [apply andb_true_intro; split; [apply andb_true_intro; split|]|]; apply Z.leb_le; lia. }
  pose proof (in_frame_spec 0 _ _ _ _ Q k (grow (Zpos N) v) K B (fan_part Q IQ) ltac:(lia)) as (A1 & A2 & A3 & A4).
  rewrite !Z.add_0_r in *. rewrite !Z.sub_0_r in *. destruct V as (Vx & Vy).
  repeat split.
  - apply (scale_le N k _ _ _ K Vx). exact A1.
  - apply (scale_lt N k _ _ _ K Vx). exact A2.
  - apply (scale_le N k _ _ _ K Vy). exact A3.
  - apply (scale_lt N k _ _ _ K Vy). exact A4.
Qed.

Lemma sub_q a b : (a - b # N) == (a # N) - (b # N).
Proof. unfold Qeq, Qminus, Qplus, Qopp. cbn [Qnum Qden]. rewrite Pos2Z.inj_mul. ring. Qed.

Lemma fits_of_not t : ~ O t -> Statements.fits_at C G t.
Proof.
  intros NO z Hz. unfold Statements.inside in *. rewrite winding_translate in Hz. apply part_pieces in Hz as (Q & IQ & X).
  assert (NB : ~ beyond t) by (intro B; apply NO; left; exact B).
  assert (Bd : bl # N <= fst t <= br # N /\ bb # N <= snd t <= bt # N).
  { unfold beyond in NB. destruct (Qlt_le_dec (fst t) (bl # N)), (Qlt_le_dec (br # N) (fst t)), (Qlt_le_dec (snd t) (bb # N)), (Qlt_le_dec (bt # N) (snd t)); try (exfalso; apply NB; auto; fail); auto. }
  pose proof (part_box Q _ IQ X) as (A & B). unfold back_by in A, B. cbn [fst snd] in A, B.
  unfold bl, bb, br, bt in Bd. rewrite !sub_q in Bd. apply container_wind.
  - unfold in_frame_at. lra.
  - intros P IP Y. apply NO. right. exists P, Q. split; [exact IP|]. split; [exact IQ|]. exists z. auto.
Qed.

(* Near an extreme vertex the part has points beyond the frame. *)
Lemma poke Q v t n f : In Q (part c) -> In v Q -> f < qdot n (qpt N v) + qdot n t ->
  exists z, Statements.winding (Statements.translate t G) z = 1%Z /\ f < qdot n z.
Proof.
  intros IQ Iv H. destruct (is_convex_spec N Q (PG Q IQ)) as (_ & A & B). set (w := third N (center Q)) in *.
  set (d := qdot n (qpt N v) + qdot n t - f). set (g := qdot n w - qdot n (qpt N v)). set (m := g * g + 1).
  pose proof (abs_bound g) as Bg. fold m in Bg. assert (M : 0 < m) by (pose proof (square g); unfold m; lra).
  assert (P : 0 < d / (2 * m)) by (apply Qlt_shift_div_l; unfold d; lra).
  destruct (below 1 (d / (2 * m))) as (e & E & E1 & E2); [lra|exact P|].
  assert (E3 : 2 * m * e <= d).
  { pose proof (mono_le (2 * m) e _ ltac:(lra) E2). assert (2 * m * (d / (2 * m)) == d) by (field; lra). lra. }
  set (y := (fst (qpt N v) + e * (fst w - fst (qpt N v)), snd (qpt N v) + e * (snd w - snd (qpt N v))) : qpoint).
  assert (Sy : inS (Statements.edges (qring N Q)) y).
  { intros h Ih. rewrite (o_share h (qpt N v) w e y); [|reflexivity|reflexivity].
    pose proof (A h Ih). pose proof (B h (qpt N v) Ih (in_map (qpt N) Q v Iv)).
    assert (0 <= (1 - e) * o h (qpt N v)) by (apply Qmult_le_0_compat; lra).
    assert (0 < e * o h w) by (apply Qmult_lt_0_compat; assumption). lra. }
  exists (fst y + fst t, snd y + snd t). split.
  - rewrite winding_translate. apply part_pieces. exists Q. split; [exact IQ|].
    rewrite (winding_same _ _ y); [apply strict_inside; [apply fan_part, IQ|exact Sy]|].
    unfold back_by. cbn [fst snd]. split; cbn [fst snd]; ring.
  - assert (F : qdot n (fst y + fst t, snd y + snd t) == qdot n (qpt N v) + qdot n t + g * e)
      by (unfold qdot, g, y, qdot; cbn [fst snd]; ring).
    rewrite F. pose proof (prod_bound g m e Bg ltac:(lra)). unfold d in E3.
    assert (0 < m * e) by (apply Qmult_lt_0_compat; assumption). lra.
Qed.

Lemma extreme_at best n : (best = max_dot \/ best = min_dot) -> exists Q v, In Q (part c) /\ In v Q /\ dot n v = extreme best n.
Proof.
  intro Hb. destruct (simple_spec solid_G SG) as (_ & _ & (Q0 & I0) & _).
  assert (Ne : corners_of_part <> []).
  { pose proof (fan_part Q0 I0) as F. destruct Q0 as [|v Q0]; [discriminate|]. intro E.
    assert (In v corners_of_part) by (apply (corner_in (v :: Q0)); [exact I0|left; reflexivity]). rewrite E in H. destruct H. }
  assert (X : exists v, In v corners_of_part /\ dot n v = extreme best n).
  { unfold extreme. destruct corners_of_part as [|w ws]; [contradiction|]. clear Ne.
    induction ws as [|u ws IH].
    - exists w. split; [left; reflexivity|]. destruct Hb as [-> | ->]; reflexivity.
    - destruct IH as (v & I & E). assert (I' : In v (w :: u :: ws)) by (destruct I as [<-|I]; [left|right; right]; auto).
      destruct Hb as [-> | ->]; unfold max_dot, min_dot in *; cbn [fold_right].
      + destruct (Z.max_spec (dot n u) (fold_right (fun p m => Z.max (dot n p) m) (dot n w) ws)) as [(_ & ->)|(_ & ->)];
          [exists v; auto|exists u; split; [right; left; reflexivity|reflexivity]].
      + destruct (Z.min_spec (dot n u) (fold_right (fun p m => Z.min (dot n p) m) (dot n w) ws)) as [(_ & ->)|(_ & ->)];
          [exists u; split; [right; left; reflexivity|reflexivity]|exists v; auto]. }
  destruct X as (v & I & E). apply in_concat in I as (Q & IQ & I). exists Q, v. auto.
Qed.

Lemma not_of_fits t : Statements.fits_at C G t -> ~ O t.
Proof.
  intros F [B|(P & Q & IP & IQ & z & Pz & Qz)].
  2:{ assert (Z1 : Statements.inside C z).
      { apply F. unfold Statements.inside. rewrite winding_translate. apply part_pieces. exists Q. auto. }
      apply container_wind in Z1 as (_ & NP). exact (NP P IP Pz). }
  assert (Fr : forall z, Statements.winding (Statements.translate t G) z = 1%Z -> in_frame_at z).
  { intros z Hz. pose proof (F z Hz) as Z1. apply container_wind in Z1 as (Z1 & _). exact Z1. }
  unfold beyond, bl, br, bb, bt in B. rewrite !sub_q in B.
  assert (At : forall n (v : pt), qdot n (qpt N v) == dot n v # N).
  { intros n v. unfold qdot, qpt, dot, Qeq, Qplus, Qmult, inject_Z. cbn [fst snd Qnum Qden]. rewrite !Pos.mul_1_l, Pos2Z.inj_mul. ring. }
  assert (Neg : forall a b : Z, (a * -1 + b * 0 # N) == - (a # N)).
  { intros. unfold Qeq, Qopp. cbn [Qnum Qden]. ring. }
  destruct B as [B|[B|[B|B]]].
  - destruct (extreme_at min_dot (1, 0)%Z) as (Q & v & IQ & Iv & E); [auto|].
    destruct (poke Q v t (-1, 0)%Z (- (fl # N)) IQ Iv) as (z & Hz & Lz).
    + unfold dot in E. cbn [fst snd] in E. rewrite At. unfold dot, qdot. cbn [fst snd].
      assert (X : (-1 * fst v + 0 * snd v # N) == - (extreme min_dot (1, 0)%Z # N)) by (rewrite <- E; unfold Qeq, Qopp; cbn [Qnum Qden]; ring).
      rewrite X. change (inject_Z (-1)) with (- (1)). change (inject_Z 0) with 0. lra.
    + specialize (Fr z Hz). unfold qdot in Lz. cbn [fst snd] in Lz. change (inject_Z (-1)) with (- (1)) in Lz. change (inject_Z 0) with 0 in Lz.
      unfold in_frame_at in Fr. lra.
  - destruct (extreme_at max_dot (1, 0)%Z) as (Q & v & IQ & Iv & E); [auto|].
    destruct (poke Q v t (1, 0)%Z (fr # N) IQ Iv) as (z & Hz & Lz).
    + rewrite At, E. unfold qdot. cbn [fst snd]. change (inject_Z 1) with 1. change (inject_Z 0) with 0. lra.
    + specialize (Fr z Hz). unfold qdot in Lz. cbn [fst snd] in Lz. change (inject_Z 1) with 1 in Lz. change (inject_Z 0) with 0 in Lz.
      unfold in_frame_at in Fr. lra.
  - destruct (extreme_at min_dot (0, 1)%Z) as (Q & v & IQ & Iv & E); [auto|].
    destruct (poke Q v t (0, -1)%Z (- (fb # N)) IQ Iv) as (z & Hz & Lz).
    + unfold dot in E. cbn [fst snd] in E. rewrite At. unfold dot, qdot. cbn [fst snd].
      assert (X : (0 * fst v + -1 * snd v # N) == - (extreme min_dot (0, 1)%Z # N)) by (rewrite <- E; unfold Qeq, Qopp; cbn [Qnum Qden]; ring).
      rewrite X. change (inject_Z (-1)) with (- (1)). change (inject_Z 0) with 0. lra.
    + specialize (Fr z Hz). unfold qdot in Lz. cbn [fst snd] in Lz. change (inject_Z (-1)) with (- (1)) in Lz. change (inject_Z 0) with 0 in Lz.
      unfold in_frame_at in Fr. lra.
  - destruct (extreme_at max_dot (0, 1)%Z) as (Q & v & IQ & Iv & E); [auto|].
    destruct (poke Q v t (0, 1)%Z (ft # N) IQ Iv) as (z & Hz & Lz).
    + rewrite At, E. unfold qdot. cbn [fst snd]. change (inject_Z 1) with 1. change (inject_Z 0) with 0. lra.
    + specialize (Fr z Hz). unfold qdot in Lz. cbn [fst snd] in Lz. change (inject_Z 1) with 1 in Lz. change (inject_Z 0) with 0 in Lz.
      unfold in_frame_at in Fr. lra.
Qed.

Definition at_sum (P H : ring) (t : qpoint) : Prop := shares N P (turned H) t.
Lemma turned_convex H : In H (map turned (part c)) -> is_convex (turned H) = true.
Proof. intro I. apply in_map_iff in I as (Q & <- & I). rewrite turned_turned. exact (PG Q I). Qed.
Lemma O_iff t : O t <-> SumsSound.O N (outside c) (map turned (part c)) beyond_box at_sum t.
Proof.
  split.
  - intros [B|(P & Q & IP & IQ & S)]; [right; apply beyond_iff, B|left]. exists P, (turned Q).
    split; [exact IP|]. split; [apply in_map, IQ|]. unfold at_sum. rewrite turned_turned. exact S.
  - intros [(P & H & IP & IH & S)|B]; [|left; apply beyond_iff, B]. right. apply in_map_iff in IH as (Q & <- & IQ).
    unfold at_sum in S. rewrite turned_turned in S. exists P, Q. auto.
Qed.
Lemma wind_loops t : wind_at N loops t = (- Statements.winding regions t)%Z.
Proof.
  unfold wind_at, loops. rewrite (winding_meet regions _ t (int_rings_meet N regions IR)), <- winding_rev. f_equal.
  rewrite !map_map. apply map_ext. intro r. unfold qring. rewrite map_rev. reflexivity.
Qed.
Lemma on_known_iff t : forallb (integral_edge N) fits = true ->
  (on_known N loops (map (int_edge N) fits) t <-> Statements.on_any segments t).
Proof.
  intro IF. unfold segments. rewrite (known_meet N regions fits t IR IF). unfold on_known, Sums.known. rewrite !map_app.
  replace (map (qe N) (loop_edges loops)) with (flat_map Statements.edges (map (@rev _) (map (qring N) (int_rings (Zpos N) regions)))).
  - rewrite on_any_rev. replace (map (qe N) (loop_edges (int_rings (Zpos N) regions)))
      with (flat_map Statements.edges (map (qring N) (int_rings (Zpos N) regions))); [reflexivity|].
    unfold loop_edges. generalize (int_rings (Zpos N) regions). intro l. induction l as [|r l IH]; [reflexivity|].
    cbn [map flat_map]. rewrite map_app, IH, ring_sides. reflexivity.
  - unfold loops, loop_edges. generalize (int_rings (Zpos N) regions). intro l. induction l as [|r l IH]; [reflexivity|].
    cbn [map flat_map]. rewrite map_app, IH, ring_sides. unfold qring. rewrite map_rev. reflexivity.
Qed.

Lemma accepted : forallb (integral_edge N) fits = true ->
  Sums.boundary (outside c) (map turned (part c)) beyond_box loops (map (int_edge N) fits) (listed_sums c) (around c) 0 = true ->
  Statements.inner_fit_claim C G regions fits.
Proof.
  intros IF X. destruct (boundary_parts _ _ _ _ _ _ _ _ X) as (B1 & B2 & B3 & Bw & B4 & B5 & B6 & B7 & B8).
  assert (Bd : forall P Q n t, In P (outside c) -> In Q (map turned (part c)) -> n <> (0, 0)%Z -> at_sum P Q t ->
    qdot n t * inject_Z (Zpos N) < inject_Z (most n P + most n Q)).
  { intros P Q n t IP IQ Nz T. apply shares_bound; [exact (FO P IP)|exact (proj1 (is_convex_spec N _ (turned_convex Q IQ)))|exact Nz|exact T]. }
  assert (Ce : forall P Q, In P (outside c) -> In Q (map turned (part c)) -> at_sum P Q (third N (plus (center P) (center Q)))).
  { intros P Q IP IQ. apply shares_center; [exact (PO P IP)|exact (turned_convex Q IQ)]. }
  assert (Is : forall P Q t, In P (outside c) -> In Q (map turned (part c)) -> add P Q <> [] -> inS (map (qe N) (sum_sides P Q)) t -> at_sum P Q t).
  { intros P Q t IP IQ. apply shares_inside; [exact (PO P IP)|exact (turned_convex Q IQ)]. }
  assert (Cm : (forall P P' Q v, In P (outside c) -> In P' (outside c) -> In Q (map turned (part c)) -> In v P -> In v P' ->
      exists t, at_sum P Q t /\ at_sum P' Q t) /\ (are_segments (outside c) = false -> forall P Q Q' v, In P (outside c) ->
      In Q (map turned (part c)) -> In Q' (map turned (part c)) -> In v Q -> In v Q' -> exists t, at_sum P Q t /\ at_sum P Q' t)).
  { split.
    - intros P P' Q v I I' IQ V V'. exact (shares_common_first N P P' _ v (PO P I) (PO P' I') (turned_convex Q IQ) V V').
    - intros _ P Q Q' v IP I I' V V'. exact (shares_common N P Q Q' v (PO P IP) (turned_convex Q I) (turned_convex Q' I') V V'). }
  assert (E1 : forall t, beyond_at N beyond_box t -> wind_at N loops t = 0%Z).
  { intros t B. rewrite wind_loops, beyond_zero; [reflexivity|apply beyond_iff, B]. }
  assert (E2 : forall f x, In f beyond_box -> o (qe N f) x == 0 -> Statements.on_segment (qe N f) x \/ beyond_at N beyond_box x).
  { intros f x I Z. destruct (box_line f x I Z); [left; assumption|right; apply beyond_iff; assumption]. }
  assert (E3 : forall f, In f beyond_box -> exists x, 0 < o (qe N f) x).
  { intros f I. destruct box_order as (Ox & Oy).
    assert (R : ~ (rise (qe N f) == 0 /\ run (qe N f) == 0)).
    { destruct I as [<-|[<-|[<-|[<-|[]]]]]; unfold rise, run, qe, qpt; cbn [fst snd]; lra. }
    exists (fst (fst (qe N f)) - rise (qe N f), snd (fst (qe N f)) + run (qe N f)).
    assert (E : o (qe N f) (fst (fst (qe N f)) - rise (qe N f), snd (fst (qe N f)) + run (qe N f)) == rise (qe N f) * rise (qe N f) + run (qe N f) * run (qe N f))
      by (unfold o, Statements.orient, rise, run; cbn [fst snd]; ring).
    rewrite E. revert R. generalize (rise (qe N f)) (run (qe N f)). clear. intros a b R. pose proof (square a). pose proof (square b).
    destruct (Qlt_le_dec 0 (a * a + b * b)) as [|Le]; [assumption|exfalso]. apply R.
    assert (Z1 : a * a == 0) by lra. assert (Z2 : b * b == 0) by lra. apply Qmult_integral in Z1, Z2. split; tauto. }
  assert (Far : forall t : qpoint, exists x, fst t <= x /\ beyond_at N beyond_box (at_x t x)).
  { intro t. destruct (Qlt_le_dec (fst t) ((br # N) + 1)) as [H|H].
    - exists ((br # N) + 1). split; [lra|]. apply beyond_iff. right. left. unfold at_x. cbn [fst]. lra.
    - exists (fst t). split; [lra|]. apply beyond_iff. right. left. unfold at_x. cbn [fst]. lra. }
  assert (Core := boundary_core N (outside c) (map turned (part c)) beyond_box loops (map (int_edge N) fits) (listed_sums c) (around c) 0%Z at_sum Bd Ce Is Cm
    E1 E2 E3 (or_intror Far) B1 B2 B3 Bw B4 B5 B6 B7 B8).
  assert (Limit := boundary_limits N (outside c) (map turned (part c)) beyond_box loops (map (int_edge N) fits) (listed_sums c) (around c) 0%Z at_sum Bd Ce Is Cm
    E1 E2 E3 (or_intror Far) B1 B2 B3 Bw B4 B5 B6 B7 B8).
  assert (Dec : forall u, ~ Statements.fits_at C G u -> O u).
  { intros u NF. destruct (on_any_dec segments u) as [Lu|NL].
    - exfalso. apply NF, fits_of_not. intro Ou. apply (on_known_iff u IF), Limit in Lu. apply Lu, O_iff, Ou.
    - destruct (Core u) as [(Ou & _)|(NO & _)]; [intro K; apply NL, (on_known_iff u IF), K|apply O_iff, Ou|].
      exfalso. apply NF, fits_of_not. intro Ou. apply NO, O_iff, Ou. }
  unfold Statements.inner_fit_claim. cbv zeta. fold segments. split; intro t.
  - rewrite <- (on_known_iff t IF), (Limit t). split.
    + intros (Cl & NO). assert (NO' : ~ O t) by (intro Ot; apply NO, O_iff, Ot). split; [apply fits_of_not, NO'|].
      intros e E. destruct (Cl e E) as (y & Oy & Cy). exists y. split; [|exact Cy]. intro Fit. exact (not_of_fits y Fit (proj2 (O_iff y) Oy)).
    + intros (Ft & Cl). split; [|intro Ot; exact (not_of_fits t Ft (proj2 (O_iff t) Ot))]. intros e E. destruct (Cl e E) as (y & Ny & Cy).
      exists y. split; [apply O_iff, Dec, Ny|exact Cy].
  - intro NL. destruct (Core t) as [(Ot & W0)|(NO & W0)]; [intro K; apply NL, (on_known_iff t IF), K| |]; rewrite wind_loops in W0.
    + right. split; [intro Ft; exact (not_of_fits t Ft (proj2 (O_iff t) Ot))|lia].
    + left. split; [apply fits_of_not; intro Ot; apply NO, O_iff, Ot|lia].
Qed.
End Accepted.

Theorem inner_fit_sound : check_inner_fit = true -> Statements.inner_fit_claim C G regions fits.
Proof.
  unfold check_inner_fit. intro H. repeat match type of H with _ && _ = true => let X := fresh "X" in apply andb_prop in H as (H & X) end.
  rewrite forallb_forall in X0, X1. apply Z.ltb_lt in X4, X5, X6, X7.
  apply accepted; try assumption; [|exact (fun Q => simple_convex solid_G Q X2)]. intros e I. specialize (X1 e I). apply andb_prop in X1. exact X1.
Qed.
End Data.
