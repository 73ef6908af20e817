(* The checkers on certificates: here, rational evidence is multiplied by a common denominator. *)
Require Import QArith ZArith List Bool.
From Exactsweep Require Import Cancel Scaling Sums Layout Faults NoFit InnerFit Sweep Claims.
From Exactsweep Require Statements.
Import ListNotations.

Notation ring := Statements.ring.
Notation segment := (Statements.point * Statements.point)%type.
Notation listed := (list (Z * list (list Z))).      (* sums: the number of each sum, and the chains of its sides *)

(* The least common multiple of denominators *)
Definition join (D : Z) (q : Q) : Z := let d := QDen (Qred q) in if (D mod d =? 0)%Z then D else Z.lcm D d.
Definition common (qs : list Q) : positive := Z.to_pos (fold_left join qs 1%Z).
Definition coordinates (rs : list ring) : list Q := flat_map (fun p => [fst p; snd p]) (concat rs).
Definition unit_of (rs : list ring) : positive := common (coordinates rs).
Definition ends (es : list segment) : list ring := map (fun e => [fst e; snd e]) es.

Definition rational_cut := (list ring * list (list ring))%type.
Definition int_cut (N : positive) (t : rational_cut) : cut := (int_rings (Zpos N) (fst t), map (int_rings (Zpos N)) (snd t)).
Definition quadruple (N : positive) (f : Q * Q * Q * Q) : Z * Z * Z * Z :=
  let '(a, b, c, d) := f in let i := int (Zpos N) in (i a, i b, i c, i d).

Definition no_fit_evidence (D G loops : list ring) (fits : list segment) (still moving : list ring) (sums : listed) : no_fit_certificate :=
  let N := unit_of (D ++ G ++ loops ++ ends fits ++ still ++ moving) in
  {| NoFit.unit := N; NoFit.still := int_rings (Zpos N) still; NoFit.moving := int_rings (Zpos N) moving; NoFit.listed_sums := sums |}.
Definition accept_no_fit D G exterior holes fits still moving sums t : bool :=
  let c := no_fit_evidence D G (exterior :: holes) fits still moving sums in
  check_no_fit_polygon D G exterior holes fits c (int_cut (NoFit.unit c) t).
Theorem no_fit_accepted D G exterior holes fits still moving sums t :
  accept_no_fit D G exterior holes fits still moving sums t = true -> Statements.no_fit_polygon D G exterior holes fits.
Proof. apply no_fit_polygon_sound. Qed.

Definition accept_inner_fit C G regions fits frame outside part sums around (ts : list rational_cut) : bool :=
  let loops := flat_map (fun r => fst r :: snd r) regions in
  let '(a, b, c, d) := frame in
  let N := unit_of (C ++ G ++ loops ++ ends fits ++ outside ++ part ++ [[(a, b); (c, d)]]) in
  check_inner_fit_polygon C G regions fits
    {| InnerFit.unit := N; box := quadruple N frame; InnerFit.outside := int_rings (Zpos N) outside; InnerFit.part := int_rings (Zpos N) part;
       InnerFit.listed_sums := sums; InnerFit.around := around |} (map (int_cut N) ts).
Theorem inner_fit_accepted C G regions fits frame outside part sums around ts :
  accept_inner_fit C G regions fits frame outside part sums around ts = true -> Statements.inner_fit_polygon C G regions fits.
Proof. unfold accept_inner_fit. destruct frame as (((a, b), c), d). apply inner_fit_polygon_sound. Qed.

Definition sweep_evidence (T : ring) (G loops : list ring) (slits : list segment) (moving : list ring) (sums : listed) : sweep_certificate :=
  let N := unit_of (T :: G ++ loops ++ ends slits ++ moving) in
  {| Sweep.unit := N; Sweep.moving := int_rings (Zpos N) moving; Sweep.listed_sums := sums |}.
(* The point of D that the inner loop winds around is in the first piece of D. *)
Definition accept_sweep D G exterior holes fits outer inner unswept slits area still moving sums t swept t' : bool :=
  let c := no_fit_evidence D G (exterior :: holes) fits still moving sums in
  let c' := sweep_evidence exterior G (outer :: inner :: unswept) slits moving swept in
  let z := third (NoFit.unit c) (center (hd [] (NoFit.still c))) in
  check_whole_sweep D G exterior holes fits outer inner unswept slits area c (int_cut (NoFit.unit c) t) c' (int_cut (Sweep.unit c') t') z.
Theorem sweep_accepted D G exterior holes fits outer inner unswept slits area still moving sums t swept t' :
  accept_sweep D G exterior holes fits outer inner unswept slits area still moving sums t swept t' = true ->
  Statements.sweep_of D G exterior holes fits outer inner unswept slits area.
Proof. apply whole_sweep_sound. Qed.

Definition accept_sum G path exterior holes slits moving sums t : bool :=
  let c := sweep_evidence path G (exterior :: holes) slits moving sums in
  check_path_sum G path exterior holes slits c (int_cut (Sweep.unit c) t).
Theorem sum_accepted G path exterior holes slits moving sums t :
  accept_sum G path exterior holes slits moving sums t = true -> Statements.path_sum G path exterior holes slits.
Proof. apply path_sum_sound. Qed.

(* Layouts: pieces of parts, of the complement of the sheet in the frame, and of obstacles.  The pieces of a part move
   with each placement. *)
Definition numbers_of (f : Statements.figure) : list Q :=
  Statements.error f :: map snd (Statements.rounded f) ++ coordinates (Statements.outline f ++ map fst (Statements.rounded f)).
Definition layout_evidence (l : Statements.layout) (pieces : list (list ring)) (frame : Q * Q * Q * Q) : certificate :=
  let n := length (Statements.kinds l) in let kinds := firstn n pieces in let others := skipn n pieces in
  let moved := map (fun x => Statements.place (Statements.by_motion x) (nth (Statements.kind x) kinds [])) (Statements.placements l) in
  let figures := map Statements.form (Statements.kinds l) ++ map (Statements.placed l) (Statements.placements l) ++ map fst (Statements.obstacles l)
    ++ match Statements.sheet l with Some f => [f] | None => [] end in
  let '(a, b, c, d) := frame in
  let N := common (flat_map numbers_of figures ++ coordinates (concat (moved ++ pieces))
    ++ Statements.spacing l :: Statements.margin l :: map snd (Statements.obstacles l) ++ [a; b; c; d]) in
  let cut := map (int_rings (Zpos N)) in
  {| Layout.denominator := N; Layout.part_pieces := cut moved; Layout.kind_pieces := cut kinds; Layout.obstacle_pieces := cut (tl others);
     Layout.outside_pieces := int_rings (Zpos N) (hd [] others); Layout.frame := quadruple N frame |}.

(* The normals of a layout: an entry for two pieces, otherwise one for two whole solids *)
Definition entry := (Z * Z * Z * Z * Statements.point)%type.
Definition is_for (a i b j : Z) (e : entry) : bool :=
  let '(a', i', b', j', _) := e in ((a =? a') && (i =? i') && (b =? b') && (j =? j'))%Z.
Definition whole (n : Statements.point) : pt := (Qnum (fst n) * QDen (snd n), Qnum (snd n) * QDen (fst n))%Z.
Definition lookup (es : list entry) (a : Z) (i b j : nat) : pt :=
  let find := fun i j => find (is_for a i (Z.of_nat b) j) es in
  match find (Z.of_nat i) (Z.of_nat j), find (-1)%Z (-1)%Z with
  | Some e, _ | None, Some e => whole (snd e)
  | None, None => (0, 0)%Z
  end.
Definition accept_by (normal : Z -> nat -> nat -> nat -> pt) l pieces frame : bool :=
  check_layout (fun a => normal (Z.of_nat a)) normal l (layout_evidence l pieces frame).
Definition accept_layout l pieces frame entries : bool := accept_by (lookup entries) l pieces frame.
Theorem layout_accepted l pieces frame entries : accept_layout l pieces frame entries = true -> Statements.valid l.
Proof. apply layout_sound. Qed.

Definition accept_faults := check_faults.
Theorem faults_accepted l fs points : accept_faults l fs points = true -> Statements.faulty l fs.
Proof. apply faults_sound. Qed.
