(* Checkers of whole claims: loops by name, a sweep with its no-fit polygon, sums with paths, one translation. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Pieces Solid Gaps Scaling HalfOpen Nearby Boundary SumPoints PiecePoints Covers Pairs Layout NoFit InnerFit Sweep.
From Exactsweep Require Statements.
Import ListNotations.

Lemma winding_cons r rs z : Statements.winding (r :: rs) z = (Statements.winding [r] z + Statements.winding rs z)%Z.
Proof.
  unfold Statements.winding. cbn [flat_map]. rewrite app_nil_r, map_app.
  generalize (map (Statements.crossing z) (Statements.edges r)) (map (Statements.crossing z) (flat_map Statements.edges rs)). intros a b.
  induction a as [|x a IH]; cbn [app fold_right]; [reflexivity|]. rewrite IH. lia.
Qed.
Lemma winding_with_holes z exterior holes :
  Statements.winding (Statements.with_holes exterior holes) z = (Statements.winding [exterior] z - Statements.winding holes z)%Z.
Proof. unfold Statements.with_holes. rewrite winding_cons, winding_rev. lia. Qed.

(* Named loops, with convex pieces of the exterior minus the holes, and of each hole *)
Definition cut := (list ring * list (list ring))%type.
Definition is_simple (N : positive) (rs : list Statements.ring) (ps : list ring) : bool :=
  all_integral (Zpos N) rs && simple_solid {| rings := int_rings (Zpos N) rs; pieces := ps |}.
Definition check_named (N : positive) (exterior : Statements.ring) (holes : list Statements.ring) (t : cut) : bool :=
  let within := concat (snd t) in is_simple N [exterior] (fst t ++ within) &&
  match holes with
  | [] => true
  | _ => is_simple N (Statements.with_holes exterior holes) (fst t) && is_simple N holes within &&
      (length holes =? length (snd t))%nat && forallb (fun x => is_simple N [fst x] (snd x)) (combine holes (snd t))
  end.
Lemma is_simple_spec N rs ps : is_simple N rs ps = true -> Statements.simple rs.
Proof.
  unfold is_simple. intro H. apply andb_prop in H as (I & S).
  exact (proj1 (simple_rings N rs ps I S)).
Qed.
Lemma check_named_spec N exterior holes t : check_named N exterior holes t = true -> Statements.named exterior holes.
Proof.
  unfold check_named. cbv zeta. intro H. apply andb_prop in H as (S & H). apply is_simple_spec in S. split; [exact S|].
  destruct holes as [|h holes].
  { split; [constructor|]. split; [left; reflexivity|]. intros z W. discriminate. }
  apply andb_prop in H as (H & E). apply andb_prop in H as (H & L). apply andb_prop in H as (R & A). apply is_simple_spec in R, A. split; [|split].
  - apply Nat.eqb_eq in L. rewrite Forall_forall. intros g I. apply In_nth_error in I as (i & I).
    destruct (Layout.nth_combine _ _ i g L I) as (ps & F). rewrite forallb_forall in E. apply (is_simple_spec N _ ps), (E _ (nth_error_In _ _ F)).
  - apply A.
  - intros z W. destruct S as (S & _), R as (R & _). specialize (S z). specialize (R z). rewrite winding_with_holes, W in R. lia.
Qed.

Definition check_no_fit_polygon (D G : list Statements.ring) (exterior : Statements.ring) (holes : list Statements.ring)
    (fits : list (Statements.point * Statements.point)) (c : no_fit_certificate) (t : cut) : bool :=
  check_no_fit D G (Statements.with_holes exterior holes) fits c && check_named (NoFit.unit c) exterior holes t.
Lemma touch_limit D G t : (exists z, Statements.closure (Statements.inside D) z /\ Statements.closure (Statements.inside (Statements.translate t G)) z) ->
  Statements.closure (Statements.overlaps_at D G) t.
Proof.
  intros (z & A & B) e E. assert (H : e / 2 == (1 # 2) * e) by field.
  destruct (A (e / 2)) as (y & Y & C1 & C2); [apply Qlt_shift_div_l; lra|]. destruct (B (e / 2)) as (w & W & C3 & C4); [apply Qlt_shift_div_l; lra|].
  exists (fst t + (fst y - fst w), snd t + (snd y - snd w)). split.
  - apply (overlap_of_point _ _ y Y). unfold Statements.inside in *. rewrite winding_translate in *. rewrite <- W. apply winding_same.
    unfold meets_at, back_by. cbn [fst snd]. split; ring.
  - rewrite H in *. unfold Statements.close. cbn [fst snd]. lra.
Qed.
Theorem no_fit_polygon_sound D G exterior holes fits c t :
  check_no_fit_polygon D G exterior holes fits c t = true -> Statements.no_fit_polygon D G exterior holes fits.
Proof.
  unfold check_no_fit_polygon. intro H. apply andb_prop in H as (A & B). pose proof (no_fit_sound _ _ _ _ c A) as C.
  split; [exact C|]. split; [|exact (check_named_spec _ _ _ _ B)]. intro u. split.
  - intro L. split; [exact (no_fit_contact _ _ _ _ c A u L)|]. apply (proj1 C u), L.
  - intros (T & N). apply (proj1 C u). split; [apply touch_limit, T|exact N].
Qed.

Definition check_inner_fit_polygon (C G : list Statements.ring) (regions : list (Statements.ring * list Statements.ring))
    (fits : list (Statements.point * Statements.point)) (c : inner_fit_certificate) (ts : list cut) : bool :=
  check_inner_fit C G (flat_map (fun r => Statements.with_holes (fst r) (snd r)) regions) fits c && (length regions =? length ts)%nat &&
  forallb (fun x => check_named (InnerFit.unit c) (fst (fst x)) (snd (fst x)) (snd x)) (combine regions ts).
Theorem inner_fit_polygon_sound C G regions fits c ts :
  check_inner_fit_polygon C G regions fits c ts = true -> Statements.inner_fit_polygon C G regions fits.
Proof.
  unfold check_inner_fit_polygon. intro H. apply andb_prop in H as (H & E). apply andb_prop in H as (A & L). split; [exact (inner_fit_sound _ _ _ _ c A)|].
  apply Nat.eqb_eq in L. rewrite Forall_forall. intros r I. apply In_nth_error in I as (i & I).
  destruct (Layout.nth_combine _ _ i r L I) as (t & F). rewrite forallb_forall in E. exact (check_named_spec _ _ _ t (E _ (nth_error_In _ _ F))).
Qed.

(* G is swept along T, the exterior of the no-fit polygon; z: a point of D in the inner loop. *)
Definition check_whole_sweep (D G : list Statements.ring) (exterior : Statements.ring) (holes : list Statements.ring)
    (fits : list (Statements.point * Statements.point)) (outer inner : Statements.ring) (unswept : list Statements.ring)
    (slits : list (Statements.point * Statements.point)) (area : Q) (c : no_fit_certificate) (t : cut)
    (c' : sweep_certificate) (t' : cut) (z : Statements.point) : bool :=
  let loops := Statements.with_holes outer (inner :: unswept) in
  check_no_fit_polygon D G exterior holes fits c t && check_sweep (Statements.edges exterior) G loops slits c' &&
  check_named (Sweep.unit c') outer (inner :: unswept) t' && (Statements.winding D z =? 1)%Z && (Statements.winding [inner] z =? 1)%Z &&
  Qeq_bool (2 * area) (Statements.doubled_area loops).
Theorem whole_sweep_sound D G exterior holes fits outer inner unswept slits area c t c' t' z :
  check_whole_sweep D G exterior holes fits outer inner unswept slits area c t c' t' z = true ->
  Statements.sweep_of D G exterior holes fits outer inner unswept slits area.
Proof.
  unfold check_whole_sweep. cbv zeta. intro H. apply andb_prop in H as (H & E). apply andb_prop in H as (H & W'). apply andb_prop in H as (H & W).
  apply andb_prop in H as (H & Na). apply andb_prop in H as (A & B). split; [|split; [|split; [|split]]].
  - exact (no_fit_polygon_sound _ _ _ _ _ _ _ A).
  - exact (sweep_sound _ _ _ _ c' B).
  - exact (check_named_spec _ _ _ _ Na).
  - exists z. split; apply Z.eqb_eq; assumption.
  - apply Qeq_bool_iff, E.
Qed.

(* Sums with paths *)
Definition check_path_sum (G : list Statements.ring) (path : list Statements.point) (exterior : Statements.ring) (holes : list Statements.ring)
    (slits : list (Statements.point * Statements.point)) (c : sweep_certificate) (t : cut) : bool :=
  check_sweep (combine path (tl path)) G (Statements.with_holes exterior holes) slits c && check_named (Sweep.unit c) exterior holes t.
Theorem path_sum_sound G path exterior holes slits c t :
  check_path_sum G path exterior holes slits c t = true -> Statements.path_sum G path exterior holes slits.
Proof.
  unfold check_path_sum. intro H. apply andb_prop in H as (A & B). split; [exact (sweep_sound _ _ _ _ c A)|exact (check_named_spec _ _ _ _ B)].
Qed.

(* A single translation, located by the loops and fits of a no-fit polygon *)
Inductive verdict := Overlap | Contact | Free.
Definition locate (loops : list Statements.ring) (fits : list (Statements.point * Statements.point)) (t : Statements.point) : verdict :=
  if existsb (fun e => on_b e t) (flat_map Statements.edges loops ++ fits) then Contact
  else if (Statements.winding loops t =? 1)%Z then Overlap else Free.
Theorem locate_sound D G loops fits t : Statements.no_fit_claim D G loops fits ->
  match locate loops fits t with
  | Overlap => Statements.overlaps_at D G t
  | Contact => Statements.closure (Statements.overlaps_at D G) t /\ ~ Statements.overlaps_at D G t
  | Free => ~ Statements.closure (Statements.overlaps_at D G) t
  end.
Proof.
  intros (A & B). unfold locate. destruct (existsb (fun e => on_b e t) (flat_map Statements.edges loops ++ fits)) eqn:E.
  - apply A. apply existsb_exists in E as (e & I & H). exists e. split; [exact I|apply on_b_spec, H].
  - assert (N : ~ Statements.on_any (flat_map Statements.edges loops ++ fits) t).
    { intros (e & I & H). apply on_b_complete in H. assert (T : existsb (fun e => on_b e t) (flat_map Statements.edges loops ++ fits) = true)
        by (apply existsb_exists; exists e; auto). congruence. }
    destruct (B t N) as [(O & W)|(O & W)]; rewrite W; [exact O|]. intro Cl. apply N, A. split; assumption.
Qed.
