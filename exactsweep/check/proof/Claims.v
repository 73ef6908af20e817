(* What certificates are checked with: a sweep together with its no-fit polygon, and normals by number. *)
Require Import QArith ZArith List Bool.
From Exactsweep Require Import Cancel Pieces Covers Layout NoFit InnerFit Sweep.
From Exactsweep Require Statements.
Import ListNotations.

(* Exteriors counter-clockwise, holes listed counter-clockwise and walked the other way around *)
Definition with_holes (exterior : Statements.ring) (holes : list Statements.ring) : list Statements.ring :=
  exterior :: map (@rev _) holes.

(* T, along which G is swept, is the exterior of the no-fit polygon; the area is that within the loops. *)
Definition check_whole_sweep (D G : list Statements.ring) (exterior : Statements.ring) (holes : list Statements.ring)
    (fits : list (Statements.point * Statements.point)) (loops : list Statements.ring)
    (slits : list (Statements.point * Statements.point)) (area : Q) (c : no_fit_certificate) (c' : sweep_certificate) : bool :=
  check_no_fit D G (with_holes exterior holes) fits c && check_sweep exterior G loops slits c' &&
  Qeq_bool (2 * area) (Statements.doubled_area loops).
Theorem whole_sweep_sound D G exterior holes fits loops slits area c c' :
  check_whole_sweep D G exterior holes fits loops slits area c c' = true ->
  Statements.no_fit_claim D G (with_holes exterior holes) fits /\ Statements.sweep_claim exterior G loops slits /\
  (2 * area == Statements.doubled_area loops)%Q.
Proof.
  unfold check_whole_sweep. intro H. apply andb_prop in H as (H & E). apply andb_prop in H as (A & B). split; [|split].
  - exact (no_fit_sound _ _ _ _ c A).
  - exact (sweep_sound _ _ _ _ c' B).
  - apply Qeq_bool_iff, E.
Qed.

(* One translation, decided by the loops and fits of a no-fit polygon *)
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

(* The normals of a layout: an entry for two pieces, else one for two solids as a whole *)
Definition entry := (Z * Z * Z * Z * pt)%type.
Definition is_for (a i b j : Z) (e : entry) : bool :=
  let '(a', i', b', j', _) := e in ((a =? a') && (i =? i') && (b =? b') && (j =? j'))%Z.
Definition lookup (l : list entry) (a i b j : Z) : pt :=
  match find (is_for a i b j) l with
  | Some e => snd e
  | None => match find (is_for a (-1) b (-1)) l with Some e => snd e | None => (0, 0)%Z end
  end.
Definition normals_of (l : list entry) (a i b j : nat) : pt := lookup l (Z.of_nat a) (Z.of_nat i) (Z.of_nat b) (Z.of_nat j).
Definition outside_normals_of (l : list entry) (a : Z) (i b j : nat) : pt := lookup l a (Z.of_nat i) (Z.of_nat b) (Z.of_nat j).
Corollary layout_valid entries l c : check_layout (normals_of entries) (outside_normals_of entries) l c = true -> Statements.valid l.
Proof. apply layout_sound. Qed.
