(* The checker of inner fits, and the theorem.

   Positions at which the part leaves the frame are four half-planes; the others at which it is not
   inside the container are sums of the pieces outside the container and of those of the part. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers Pairs.
Import ListNotations.
Open Scope Q_scope.

Record inner_fit_certificate := {
  unit : positive; box : Z * Z * Z * Z;            (* the frame: left, bottom, right, top *)
  outside : list ring; part : list ring; listed_sums : list listed }.

Definition flip (es : list side) : list side := map swap es.
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
Lemma wind_flip es z : wind_sides (flip es) z = (- wind_sides es z)%Z.
Proof.
  unfold wind_sides, flip. induction es as [|e es IH]; [reflexivity|]. cbn [map fold_right]. rewrite IH, crossing_swap. lia.
Qed.

(* An edge that is not right of z, or not at its height, does not count. *)
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

Section Check.
Variables (clear : ring -> ring -> side -> pt) (inner : ring -> qpoint) (side_cuts edge_cuts : side -> list Q)
  (hint : ring -> ring -> pt).

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
Definition half_planes : list (list side) :=
  [[(qpt N (br, bb), qpt N (bl, bb))]; [(qpt N (br, bt), qpt N (br, bb))];
   [(qpt N (bl, bt), qpt N (br, bt))]; [(qpt N (bl, bb), qpt N (bl, bt))]].
Definition loops : list side := flip (flat_map Statements.edges regions).
Definition segments : list side := loops ++ fits.
Definition sums : list (list side) := map (sides_of N) (listed_sums c) ++ half_planes.
Definition solid_G : solid := {| rings := int_rings (Zpos N) G; pieces := part c |}.
Definition in_box (p : qpoint) : bool :=
  Qle_bool (bl # N) (fst p) && Qle_bool (fst p) (br # N) && Qle_bool (bb # N) (snd p) && Qle_bool (snd p) (bt # N).
Definition pair_b (P Q : ring) : bool :=
  (Statements.winding regions (corner (inner P, inner Q)) =? 0)%Z &&
  forallb (clear_b N clear P Q) segments && forallb (clear_b N clear P Q) (flat_map Statements.edges regions).

Definition check_inner_fit : bool :=
  all_integral (Zpos N) C && all_integral (Zpos N) G && all_integral (Zpos N) regions &&
  (fl <? fr)%Z && (fb <? ft)%Z && (bl <? br)%Z && (bb <? bt)%Z &&
  forallb is_fan (outside c) &&
  cancels (flat_map edges (outside c) ++ flat_map edges (int_rings (Zpos N) C)) (edges (box_ring fl fb fr ft)) &&
  simple_solid hint solid_G &&
  all_pairs distinct_b loops &&
  forallb (fun e => in_box (fst e) && in_box (snd e)) segments &&
  forallb (piece_b N inner) (outside c) && forallb (piece_b N inner) (part c) &&
  forallb (fun P => forallb (pair_b P) (part c)) (outside c) &&
  forallb (sum_b N inner side_cuts (outside c) (part c) sums segments) (listed_sums c) &&
  forallb (fun S => forallb (fun f => cover_b sums segments (side_cuts f) f) S) half_planes &&
  forallb (fun e => beside_b sums (edge_cuts e) e) loops &&
  forallb (both_b edge_cuts sums) fits.

Section Accepted.
Hypothesis IC : all_integral (Zpos N) C = true.
Hypothesis IG : all_integral (Zpos N) G = true.
Hypothesis IR : all_integral (Zpos N) regions = true.
Hypothesis Fx : (fl < fr)%Z.
Hypothesis Fy : (fb < ft)%Z.
Hypothesis Bx : (bl < br)%Z.
Hypothesis By : (bb < bt)%Z.
Hypothesis FO : fans (outside c).
Hypothesis Cn : cancels (flat_map edges (outside c) ++ flat_map edges (int_rings (Zpos N) C)) (edges (box_ring fl fb fr ft)) = true.
Hypothesis SG : simple_solid hint solid_G = true.
Hypothesis Ds : all_pairs distinct_b loops = true.
Hypothesis Within : forall e, In e segments -> in_box (fst e) = true /\ in_box (snd e) = true.
Hypothesis PO : forall P, In P (outside c) -> piece_b N inner P = true.
Hypothesis PG : forall Q, In Q (part c) -> piece_b N inner Q = true.
Hypothesis Pairs : forall P Q, In P (outside c) -> In Q (part c) -> pair_b P Q = true.
Hypothesis Sums : forall s, In s (listed_sums c) -> sum_b N inner side_cuts (outside c) (part c) sums segments s = true.
Hypothesis Halves : forall S f, In S half_planes -> In f S -> cover_b sums segments (side_cuts f) f = true.
Hypothesis Beside : forall e, In e loops -> beside_b sums (edge_cuts e) e = true.
Hypothesis Fits : forall e, In e fits -> both_b edge_cuts sums e = true.

Lemma fan_part : fans (part c).
Proof. exact (proj1 (proj2 (simple_spec hint solid_G SG))). Qed.

Definition beyond (t : qpoint) : Prop := fst t < bl # N \/ br # N < fst t \/ snd t < bb # N \/ bt # N < snd t.
Definition O (t : qpoint) : Prop := beyond t \/ exists P Q, In P (outside c) /\ In Q (part c) /\ shares N P Q t.

Lemma box_order : bl # N < br # N /\ bb # N < bt # N.
Proof. unfold Qlt. cbn. split; nia. Qed.

Lemma half_beyond t : (exists S, In S half_planes /\ inS S t) <-> beyond t.
Proof.
  destruct box_order as (X & Y). unfold half_planes, inS, beyond, o, Statements.orient, qpt.
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

(* On L nothing is beyond. *)
Lemma in_box_spec p : in_box p = true -> (bl # N <= fst p <= br # N) /\ (bb # N <= snd p <= bt # N).
Proof.
  unfold in_box. intro H. repeat match type of H with _ && _ = true => let X := fresh "X" in apply andb_prop in H as (H & X); apply Qle_bool_iff in X end.
  apply Qle_bool_iff in H. lra.
Qed.
Lemma within_L t : Statements.on_any segments t -> ~ beyond t.
Proof.
  intros (e & I & s & (S0 & S1) & X & Y). destruct (Within e I) as (A & B). apply in_box_spec in A, B. unfold beyond.
  assert (M : forall l r p q x, l <= p <= r -> l <= q <= r -> x == p + s * (q - p) -> l <= x <= r).
  { intros l r p q x (P1 & P2) (Q1 & Q2) E.
    assert (0 <= s * (q - l)) by (apply Qmult_le_0_compat; lra). assert (0 <= (1 - s) * (p - l)) by (apply Qmult_le_0_compat; lra).
    assert (0 <= s * (r - q)) by (apply Qmult_le_0_compat; lra). assert (0 <= (1 - s) * (r - p)) by (apply Qmult_le_0_compat; lra). lra. }
  pose proof (M _ _ _ _ _ (proj1 A) (proj1 B) X). pose proof (M _ _ _ _ _ (proj2 A) (proj2 B) Y). lra.
Qed.

Lemma pair_clear P Q e : In P (outside c) -> In Q (part c) ->
  In e segments \/ In e (flat_map Statements.edges regions) -> clear_b N clear P Q e = true.
Proof.
  intros IP IQ I. pose proof (Pairs P Q IP IQ) as H. unfold pair_b in H. apply andb_prop in H as (H & H2). apply andb_prop in H as (_ & H1).
  rewrite forallb_forall in H1, H2. destruct I as [I|I]; [apply H1|apply H2]; exact I.
Qed.
Lemma free t : Statements.on_any segments t -> ~ O t.
Proof.
  intros Lt [B|(P & Q & IP & IQ & Sh)]; [exact (within_L t Lt B)|]. destruct Lt as (e & I & X).
  exact (clear_free N clear P Q e t (FO P IP) (fan_part Q IQ) (pair_clear P Q e IP IQ (or_introl I)) X Sh).
Qed.

Lemma region_edge e : In e (flat_map Statements.edges regions) ->
  (bl # N <= fst (fst e) <= br # N /\ bb # N <= snd (fst e) <= bt # N) /\
  (bl # N <= fst (snd e) <= br # N /\ bb # N <= snd (snd e) <= bt # N).
Proof.
  intro I. assert (J : In (swap e) segments) by (apply in_or_app; left; apply in_map; exact I).
  destruct (Within _ J) as (A & B). apply in_box_spec in A, B. unfold swap in *. cbn [fst snd] in *. split; assumption.
Qed.
Lemma no_crossing t : (forall e, In e (flat_map Statements.edges regions) -> Statements.crossing t e = 0%Z) ->
  Statements.winding regions t = 0%Z.
Proof. intro H. exact (wind_zero (flat_map Statements.edges regions) t H). Qed.
Lemma above_zero t : bt # N < snd t -> Statements.winding regions t = 0%Z.
Proof.
  intro H. apply no_crossing. intros [a b] I. pose proof (region_edge _ I) as ((_ & A) & _ & B). cbn [fst snd] in *.
  apply crossing_none. left. lra.
Qed.

Lemma once t : O t -> wind_sides loops t = 0%Z.
Proof.
  intro Ot. unfold loops. rewrite wind_flip. change (wind_sides (flat_map Statements.edges regions) t) with (Statements.winding regions t).
  enough (Statements.winding regions t = 0%Z) by lia. destruct Ot as [[B|[B|[B|B]]]|(P & Q & IP & IQ & Sh)].
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
  - pose proof (Pairs P Q IP IQ) as H. unfold pair_b in H. apply andb_prop in H as (H & _). apply andb_prop in H as (H & _).
    apply Z.eqb_eq in H. rewrite <- H. apply (clear_constant N clear P Q); [apply FO, IP|apply fan_part, IQ|exact IR| |exact Sh|].
    + intros e I. apply (pair_clear P Q e IP IQ). right. exact I.
    + apply inner_shares; [apply FO, IP|apply fan_part, IQ|apply PO, IP|apply PG, IQ].
Qed.

(* The hypotheses of the lemma *)
Lemma half_in S : In S half_planes -> In S sums.
Proof. intro I. apply in_or_app. right. exact I. Qed.
Lemma beyond_U t : beyond t -> U sums t.
Proof. intro B. apply half_beyond in B as (S & I & J). exists S. split; [apply half_in, I|exact J]. Qed.
Lemma sum_cases S : In S sums -> (exists s, In s (listed_sums c) /\ S = sides_of N s) \/ In S half_planes.
Proof.
  intro I. apply in_app_or in I as [I|I]; [left|right; exact I]. apply in_map_iff in I as (s & <- & I). exists s. auto.
Qed.
Lemma half_one S : In S half_planes -> exists f, S = [f].
Proof. intros [<-|[<-|[<-|[<-|[]]]]]; eexists; reflexivity. Qed.

Lemma half_cover S f x : In S half_planes -> In f S -> o f x == 0 -> U sums x \/ L loops fits x.
Proof.
  intros I F X. pose proof (Halves S f I F) as H. destruct box_order as (Ox & Oy).
  destruct (Qlt_le_dec (fst x) (bl # N)) as [H1|H1]; [left; apply beyond_U; left; exact H1|].
  destruct (Qlt_le_dec (br # N) (fst x)) as [H2|H2]; [left; apply beyond_U; right; left; exact H2|].
  destruct (Qlt_le_dec (snd x) (bb # N)) as [H3|H3]; [left; apply beyond_U; right; right; left; exact H3|].
  destruct (Qlt_le_dec (bt # N) (snd x)) as [H4|H4]; [left; apply beyond_U; right; right; right; exact H4|].
  apply (cover_b_spec sums segments (side_cuts f) f x H). apply on_b_spec. unfold on_b.
  assert (Zero : forall a b, 0 < a -> a * b == 0 -> b == 0).
  { intros a b A E. apply Qmult_integral in E. destruct E; [lra|assumption]. }
  apply andb_true_intro. split; [apply andb_true_intro; split; [apply Qeq_bool_iff, X|]|].
  - destruct I as [<-|[<-|[<-|[<-|[]]]]]; destruct F as [<-|[]]; unfold o, Statements.orient, qpt in X; unfold qpt; cbn [fst snd] in X |- *;
      unfold within; apply orb_true_intro.
    + right. apply andb_true_intro. split; apply Qle_bool_iff; assumption.
    + left. assert (fst x - (br # N) == 0) by (apply (Zero ((bt # N) - (bb # N))); lra). apply andb_true_intro. split; apply Qle_bool_iff; lra.
    + left. apply andb_true_intro. split; apply Qle_bool_iff; assumption.
    + left. assert (fst x - (bl # N) == 0) by (apply (Zero ((bt # N) - (bb # N))); lra). apply andb_true_intro. split; apply Qle_bool_iff; lra.
  - destruct I as [<-|[<-|[<-|[<-|[]]]]]; destruct F as [<-|[]]; unfold o, Statements.orient, qpt in X; unfold qpt; cbn [fst snd] in X |- *;
      unfold within; apply orb_true_intro.
    + left. assert (snd x - (bb # N) == 0) by (apply (Zero ((br # N) - (bl # N))); lra). apply andb_true_intro. split; apply Qle_bool_iff; lra.
    + right. apply andb_true_intro. split; apply Qle_bool_iff; assumption.
    + left. assert (snd x - (bt # N) == 0) by (apply (Zero ((br # N) - (bl # N))); lra). apply andb_true_intro. split; apply Qle_bool_iff; lra.
    + left. apply andb_true_intro. split; apply Qle_bool_iff; assumption.
Qed.

(* In the container: in the frame, and in no piece outside. *)
Definition in_frame_at (z : qpoint) : Prop := fl # N <= fst z < fr # N /\ fb # N <= snd z < ft # N.
Lemma container_wind z :
  (in_frame_at z -> (forall P, In P (outside c) -> Statements.winding [qring N P] z <> 1%Z) -> Statements.winding C z = 1%Z) /\
  (Statements.winding C z = 1%Z -> in_frame_at z /\ forall P, In P (outside c) -> Statements.winding [qring N P] z <> 1%Z).
Proof.
  destruct (pat_common z z) as (k & v & _ & K & V & _).
  rewrite (winding_W (Zpos N) k C (int_rings (Zpos N) C) z v); [|reflexivity|exact K|apply int_rings_at, IC|exact V].
  pose proof (cancels_wind k _ _ (grow (Zpos N) v) K Cn) as E. rewrite map_app, wind_app in E.
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
Proof. exact (count_pieces N hint solid_G G z SG IG eq_refl). Qed.

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

(* Near an extreme corner the part has points beyond the frame. *)
Lemma poke Q v t n f : In Q (part c) -> In v Q -> f < qdot n (qpt N v) + qdot n t ->
  exists z, Statements.winding (Statements.translate t G) z = 1%Z /\ f < qdot n z.
Proof.
  intros IQ Iv H. destruct (piece_inner N inner Q (PG Q IQ)) as (A & B). set (w := inner Q) in *.
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
  intro Hb. destruct (simple_spec hint solid_G SG) as (_ & _ & (Q0 & I0) & _).
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

Lemma on_flip es t : Statements.on_any (flip es ++ fits) t <-> Statements.on_any (es ++ fits) t.
Proof.
  split; intros (e & I & X); apply in_app_or in I as [I|I].
  - apply in_map_iff in I as (f & <- & I). exists f. split; [apply in_or_app; left; exact I|apply swap_on, X].
  - exists e. split; [apply in_or_app; right; exact I|exact X].
  - exists (swap e). split; [apply in_or_app; left; apply in_map, I|apply swap_on, X].
  - exists e. split; [apply in_or_app; right; exact I|exact X].
Qed.

Theorem accepted : Statements.inner_fit_claim C G regions fits.
Proof.
  assert (Convex : forall S, In S sums -> convex S).
  { intros S I. destruct (sum_cases S I) as [(s & J & ->)|J].
    - exact (proj1 (sum_polygon N inner side_cuts _ _ _ _ s (Sums s J))).
    - destruct (half_one S J) as (f & ->). intros g h [<-|[]] [<-|[]].
      assert (o f (fst f) == 0) by (unfold o, Statements.orient; ring). assert (o f (snd f) == 0) by (unfold o, Statements.orient; ring).
      split; [lra|]. split; [lra|]. right. right. reflexivity. }
  assert (Inner : forall S, In S sums -> exists x, inS S x).
  { intros S I. destruct (sum_cases S I) as [(s & J & ->)|J].
    - exact (proj1 (proj2 (proj2 (sum_polygon N inner side_cuts _ _ _ _ s (Sums s J))))).
    - destruct (half_one S J) as (f & ->). destruct box_order as (Ox & Oy).
      assert (R : ~ (rise f == 0 /\ run f == 0)).
      { destruct J as [J|[J|[J|[J|[]]]]]; injection J as <-; unfold rise, run, qpt; cbn [fst snd]; lra. }
      exists (fst (fst f) - rise f, snd (fst f) + run f). intros g [<-|[]].
      assert (E : o f (fst (fst f) - rise f, snd (fst f) + run f) == rise f * rise f + run f * run f)
        by (unfold o, Statements.orient, rise, run; cbn [fst snd]; ring).
      rewrite E. pose proof (square (rise f)). pose proof (square (run f)).
      destruct (Qlt_le_dec 0 (rise f * rise f + run f * run f)) as [|Le]; [assumption|exfalso]. apply R.
      assert (Z1 : rise f * rise f == 0) by lra. assert (Z2 : run f * run f == 0) by lra.
      apply Qmult_integral in Z1, Z2. split; tauto. }
  assert (Sum : forall S t, In S sums -> inS S t -> O t).
  { intros S t I J. destruct (sum_cases S I) as [(s & K & ->)|K].
    - right. exact (sum_shares N inner side_cuts _ _ _ _ s t FO fan_part PO PG (Sums s K) J).
    - left. apply half_beyond. exists S. auto. }
  assert (Far : forall t : qpoint, exists x, fst t <= x /\ U sums (at_x t x)).
  { intro t. destruct (Qlt_le_dec (fst t) ((br # N) + 1)) as [H|H].
    - exists ((br # N) + 1). split; [lra|]. apply beyond_U. right. left. unfold at_x. cbn [fst]. lra.
    - exists (fst t). split; [lra|]. apply beyond_U. right. left. unfold at_x. cbn [fst]. lra. }
  assert (Cover : forall S f x, In S sums -> In f S -> o f x == 0 -> (forall g, In g S -> 0 <= o g x) ->
    U sums x \/ L loops fits x).
  { intros S f x I F X0 X1. destruct (sum_cases S I) as [(s & J & ->)|J].
    - destruct (sum_polygon N inner side_cuts _ _ _ _ s (Sums s J)) as (_ & Lk & _ & Cv).
      exact (Cv f x F (closed_on_side _ f x Lk F X0 X1)).
    - exact (half_cover S f x J F X0). }
  assert (Left : forall e x, In e loops -> Statements.on_segment e x ->
    exists S f, In S sums /\ In f S /\ Statements.on_segment f x /\ (0 < rise e -> 0 < rise f) /\ (rise e < 0 -> rise f < 0))
    by (intros e x I X; exact (beside_b_spec sums (edge_cuts e) e x (Beside e I) X)).
  assert (Both : forall e x, In e fits -> ~ rise e == 0 -> Statements.on_segment e x ->
    exists S f, In S sums /\ In f S /\ Statements.on_segment f x /\ 0 < rise f)
    by (intros e x I R X; exact (both_left edge_cuts sums e x (Fits e I) R X)).
  assert (Touch : forall e x, In e (loops ++ fits) -> Statements.on_segment e x ->
    exists S f, In S sums /\ In f S /\ Statements.on_segment f x).
  { intros e x I X. apply in_app_or in I as [I|I].
    - destruct (Left e x I X) as (S & f & IS & IF & Of & _). exists S, f. auto.
    - exact (both_touch edge_cuts sums e x (Fits e I) X). }
  pose proof (core sums loops fits O 0%Z Convex Sum free once (or_intror Far) Cover Left Both (distinct_pairs _ Ds)) as Core.
  pose proof (boundary sums loops fits O 0%Z Convex Sum free once (or_intror Far) Cover Left Both (distinct_pairs _ Ds) Inner Touch
    (fun t => on_any_dec segments t)) as Bound. unfold L in Core, Bound.
  assert (Dec : forall u, ~ Statements.fits_at C G u -> O u).
  { intros u NF. destruct (on_any_dec segments u) as [Lu|NL].
    - exfalso. apply NF, fits_of_not, free, Lu.
    - destruct (Core u NL) as [(Ou & _)|(NO & _)]; [exact Ou|]. exfalso. apply NF, fits_of_not, NO. }
  unfold Statements.inner_fit_claim. cbv zeta. split; intro t; rewrite <- on_flip; fold loops.
  - rewrite (Bound t). split.
    + intros (Cl & NO). split; [apply fits_of_not, NO|]. intros e E. destruct (Cl e E) as (y & Oy & Cy).
      exists y. split; [|exact Cy]. intro Fit. exact (not_of_fits y Fit Oy).
    + intros (Ft & Cl). split; [|exact (not_of_fits t Ft)]. intros e E. destruct (Cl e E) as (y & Ny & Cy).
      exists y. split; [apply Dec, Ny|exact Cy].
  - intro NL. assert (Wd : wind_sides loops t = (- Statements.winding regions t)%Z) by apply wind_flip.
    destruct (Core t NL) as [(Ot & W0)|(NO & W0)].
    + right. split; [intro Ft; exact (not_of_fits t Ft Ot)|lia].
    + left. split; [apply fits_of_not, NO|lia].
Qed.
End Accepted.

Theorem inner_fit_sound : check_inner_fit = true -> Statements.inner_fit_claim C G regions fits.
Proof.
  unfold check_inner_fit. intro H. repeat match type of H with _ && _ = true => let X := fresh "X" in apply andb_prop in H as (H & X) end.
  rewrite forallb_forall in X, X0, X1, X2, X3, X4, X5, X6, X10. apply Z.ltb_lt in X11, X12, X13, X14.
  apply accepted; try assumption.
  - intros e I. specialize (X6 e I). apply andb_prop in X6. exact X6.
  - intros P Q IP IQ. specialize (X3 P IP). rewrite forallb_forall in X3. exact (X3 Q IQ).
  - intros S f IS IF. specialize (X1 S IS). rewrite forallb_forall in X1. exact (X1 f IF).
Qed.
End Data.
End Check.
