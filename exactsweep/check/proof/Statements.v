(* Definitions of the claims.  Nothing here is computed by a checker; this is the page to read first.

   The plane is the set of pairs of rational numbers.  All vertices are rational, so every open set that two shapes could
   share contains a rational point.  Real points (RealPoints.v): one in the interiors of two sets proves an overlap, and
   `at_least` holds for real limits. *)
Require Import QArith List Bool.
Import ListNotations.
Open Scope Q_scope.

Definition point := (Q * Q)%type.
Definition ring := list point.                                  (* closed: an edge joins the last vertex to the first *)
Definition edges (r : ring) : list (point * point) := match r with [] => [] | p :: t => combine r (t ++ [p]) end.

(* Twice the signed area of the triangle a, b, p: positive where p is left of the line from a to b. *)
Definition orient (a b p : point) : Q := (fst b - fst a) * (snd p - snd a) - (snd b - snd a) * (fst p - fst a).

(* The winding number of rings around z: the upward edges that cross the ray from z to the right, minus the downward
   ones.  The lower end of an edge belongs to it, the upper end does not. *)
Definition less (x y : Q) : bool := negb (Qle_bool y x).
Definition crossing (z : point) (e : point * point) : Z :=
  let (a, b) := e in
  if Qle_bool (snd a) (snd z) && less (snd z) (snd b) && less 0 (orient a b z) then 1%Z
  else if Qle_bool (snd b) (snd z) && less (snd z) (snd a) && less (orient a b z) 0 then (-1)%Z
  else 0%Z.
Definition winding (rs : list ring) (z : point) : Z := fold_right Z.add 0%Z (map (crossing z) (flat_map edges rs)).

(* A shape is the set with winding number 1; exteriors are counter-clockwise, holes clockwise.  By the rule above it
   contains its left and lower sides, not the others; by `half_open` (HalfOpen.v) only its boundary depends on the rule. *)
Definition inside (rs : list ring) (z : point) : Prop := winding rs z = 1%Z.

(* Topology and distance *)
Definition close (e : Q) (y z : point) : Prop := - e < fst y - fst z < e /\ - e < snd y - snd z < e.
Definition interior (S : point -> Prop) (z : point) : Prop := exists e, 0 < e /\ forall y, close e y z -> S y.
Definition closure (S : point -> Prop) (z : point) : Prop := forall e, 0 < e -> exists y, S y /\ close e y z.
Definition dist2 (y z : point) : Q := (fst y - fst z) * (fst y - fst z) + (snd y - snd z) * (snd y - snd z).
Definition overlap (S T : point -> Prop) : Prop := exists z, interior S z /\ interior T z.
Definition disjoint (S T : point -> Prop) : Prop := forall z, ~ (S z /\ T z).
Definition at_least (d : Q) (S T : point -> Prop) : Prop :=     (* any two points are at distance d or more *)
  forall y z, closure S y -> closure T z -> d * d <= dist2 y z.

(* A simple shape: all winding numbers of its rings are 0 or 1, and its interior is not empty. *)
Definition simple (rs : list ring) : Prop :=
  (forall z, winding rs z = 0%Z \/ winding rs z = 1%Z) /\ exists z, interior (inside rs) z.

(* Figures are drawn as rings or as rounded pieces: all points at distance r or less from a convex hull (of one point for
   a disc, two for a slot).  Given an error e, the true shape is any set of points at distance e or less from the figure. *)
Definition hull (ps : list point) (z : point) : Prop :=         (* in every half-plane that contains the points *)
  forall a b c, (forall p, In p ps -> a * fst p + b * snd p <= c) -> a * fst z + b * snd z <= c.
Definition within (e : Q) (S : point -> Prop) (z : point) : Prop :=     (* at distance e or less from S and its limits *)
  forall d, e < d -> ~ forall y, S y -> d * d < dist2 y z.
Definition known_to (e : Q) (drawn true : point -> Prop) : Prop := forall z, true z -> within e drawn z.
Record figure := { outline : list ring; rounded : list (list point * Q); error : Q }.   (* rounded: points, radius *)
Definition drawn (f : figure) (z : point) : Prop :=
  inside (outline f) z \/ exists p, In p (rounded f) /\ within (snd p) (hull (fst p)) z.
Definition shape_of (f : figure) : (point -> Prop) -> Prop := known_to (error f) (drawn f).
Definition outside_of (f : figure) : (point -> Prop) -> Prop := known_to (error f) (fun z => ~ drawn f z).
Definition is_shape (f : figure) : Prop := (outline f = [] \/ simple (outline f)) /\ exists z, drawn f z.

(* Layouts.  A part is mirrored (x to -x) first, then rotated about its origin, then translated. *)
Record motion := { mirrored : bool; cosine : Q; sine : Q; shift : point }.
Definition move (m : motion) (p : point) : point :=
  let x := if mirrored m then - fst p else fst p in
  (cosine m * x - sine m * snd p + fst (shift m), sine m * x + cosine m * snd p + snd (shift m)).
Definition place (m : motion) (rs : list ring) : list ring := map (fun r => map (move m) (if mirrored m then rev r else r)) rs.

(* A rotation, by cosine and sine, or by degrees from 0 to 360 if these are irrational (not a multiple of 90) *)
Inductive rotation := Rational (c s : Q) | Degrees (d : Q).
Record part := {
  form : figure; demand : option N;                                       (* None: any number *)
  rotations : option (list rotation);                                     (* allowed; None: any *)
  mirrored_rotations : option (list rotation); may_mirror : bool }.       (* for mirrored placements *)
(* `degrees`: None, or those of an irrational rotation. Then by_motion has a rational one, and points are off by at most `slack`. *)
Record placement := { kind : nat; by_motion : motion; degrees : option Q; slack : Q }.
Record layout := {
  sheet : option figure;                   (* the container: rings with its holes, or a rounded piece; None: no container *)
  obstacles : list (figure * Q);           (* further defects, which may cross its edge, and their required distances *)
  kinds : list part; placements : list placement; spacing : Q; margin : Q }.
Definition no_part : part :=
  {| form := {| outline := []; rounded := []; error := 0 |}; demand := None; rotations := None; mirrored_rotations := None; may_mirror := true |}.
Definition kind_of (l : layout) (x : placement) : part := nth (kind x) (kinds l) no_part.
Definition placed (l : layout) (x : placement) : figure :=
  let f := form (kind_of l x) in
  {| outline := place (by_motion x) (outline f); error := error f + slack x;
     rounded := map (fun p => (map (move (by_motion x)) (fst p), snd p)) (rounded f) |}.

Definition is_by (x : placement) (r : rotation) : Prop := match r, degrees x with
  | Rational c s, None => c == cosine (by_motion x) /\ s == sine (by_motion x) | Degrees d, Some e => d == e | _, _ => False end.
Definition rotated (l : layout) (x : placement) : Prop :=      (* by an allowed rotation *)
  forall rs, (if mirrored (by_motion x) then mirrored_rotations else rotations) (kind_of l x) = Some rs -> Exists (is_by x) rs.
Definition allowed (l : layout) (x : placement) : Prop :=
  (kind x < length (kinds l))%nat /\ (mirrored (by_motion x) = true -> may_mirror (kind_of l x) = true) /\ rotated l x.
Definition number (l : layout) (k : nat) : N := N.of_nat (count_occ Nat.eq_dec (map kind (placements l)) k).
Definition demanded (l : layout) (k : nat) (n : N) : Prop := exists p, nth_error (kinds l) k = Some p /\ demand p = Some n.
Definition supplied (l : layout) : Prop := forall k n, demanded l k n -> number l k = n.
Definition keeps (d : Q) (S T : point -> Prop) : Prop := ~ overlap S T /\ at_least d S T.

(* Distances, radii, errors and slacks are not negative; placements are rotations, with or without mirroring. *)
Definition amounts (f : figure) : Prop := 0 <= error f /\ Forall (fun p => 0 <= snd p) (rounded f).
Definition well_formed (l : layout) : Prop :=
  (0 <= spacing l /\ 0 <= margin l) /\ Forall (fun p => amounts (form p)) (kinds l) /\
  Forall (fun o => amounts (fst o) /\ 0 <= snd o) (obstacles l) /\ (forall f, sheet l = Some f -> amounts f) /\
  Forall (fun x => let m := by_motion x in 0 <= slack x /\ cosine m * cosine m + sine m * sine m == 1) (placements l).

Record valid (l : layout) : Prop := {
  measures : well_formed l;
  rules : Forall (allowed l) (placements l) /\ supplied l;
  shapes : Forall (fun p => is_shape (form p)) (kinds l) /\ Forall (fun x => is_shape (placed l x)) (placements l) /\
    Forall (fun o => is_shape (fst o)) (obstacles l);
  apart : forall i j x y S T, nth_error (placements l) i = Some x -> nth_error (placements l) j = Some y -> i <> j ->
    shape_of (placed l x) S -> shape_of (placed l y) T -> keeps (spacing l) S T;
  (* U: the complement of the true container *)
  contained : forall x f S U, In x (placements l) -> sheet l = Some f ->
    shape_of (placed l x) S -> outside_of f U -> keeps (margin l) S U;
  no_defect : forall x o S T, In x (placements l) -> In o (obstacles l) ->
    shape_of (placed l x) S -> shape_of (fst o) T -> keeps (snd o) S T }.

(* Faults for all possible true shapes S: the Hausdorff distance of S and the drawn shape is at most the error, and so
   is that of their complements. *)
Definition true_shape (f : figure) (S : point -> Prop) : Prop :=
  (forall z, ~ within (error f) (fun y => ~ drawn f y) z -> S z) /\ known_to (error f) (drawn f) S /\
  known_to (error f) S (drawn f) /\ known_to (error f) (fun z => ~ S z) (fun z => ~ drawn f z).
Inductive body := Part (i : nat) | Beyond | Obstacle (k : nat).       (* Beyond: the complement of the sheet *)
Definition body_of (l : layout) (b : body) : option (Q * ((point -> Prop) -> Prop)) :=     (* distance; possible sets *)
  match b with
  | Part i => option_map (fun x => (spacing l, true_shape (placed l x))) (nth_error (placements l) i)
  | Beyond => option_map (fun f => (margin l, fun U => exists C, true_shape f C /\ U = fun z => ~ C z)) (sheet l)
  | Obstacle k => option_map (fun o => (snd o, true_shape (fst o))) (nth_error (obstacles l) k)
  end.
Definition between (l : layout) (i : nat) (b : body) (R : Q -> (point -> Prop) -> (point -> Prop) -> Prop) : Prop :=
  b <> Part i /\ exists x d F, nth_error (placements l) i = Some x /\ body_of l b = Some (d, F) /\
  (exists S T, true_shape (placed l x) S /\ F T) /\ forall S T, true_shape (placed l x) S -> F T -> R d S T.
Inductive fault := Missing (k : nat) | Surplus (k : nat) | Mirrored (k : nat) | Rotated (k : nat) | Not_simple (k : nat)
  | Overlapping (i : nat) (b : body) | Too_close (i : nat) (b : body).
Definition has (l : layout) (f : fault) : Prop :=
  match f with
  | Missing k => exists n, demanded l k n /\ (number l k < n)%N
  | Surplus k => exists n, demanded l k n /\ (n < number l k)%N
  | Mirrored k => exists x, In x (placements l) /\ kind x = k /\ mirrored (by_motion x) = true /\ may_mirror (kind_of l x) = false
  | Rotated k => exists x, In x (placements l) /\ kind x = k /\ ~ rotated l x
  | Not_simple k => exists p z, nth_error (kinds l) k = Some p /\ winding (outline (form p)) z <> 0%Z /\ winding (outline (form p)) z <> 1%Z
  | Overlapping i b => between l i b (fun _ S T => overlap S T)
  | Too_close i b => between l i b (fun d S T => ~ at_least d S T)
  end.
Definition faulty (l : layout) (fs : list fault) : Prop := well_formed l /\ fs <> [] /\ Forall (has l) fs /\ ~ valid l.

(* No-fit polygons.  O is the set of translations t at which G + t overlaps D.  The claim: together, rings (loops) and segments
   (exact fits) are the boundary of O, where G + t touches D; off them, the loops wind once around O, and not around the rest. *)
Definition translate (t : point) (rs : list ring) : list ring := map (map (fun p => (fst p + fst t, snd p + snd t))) rs.
Definition overlaps_at (D G : list ring) (t : point) : Prop := overlap (inside D) (inside (translate t G)).
Definition on_segment (e : point * point) (z : point) : Prop :=
  exists s, 0 <= s <= 1 /\ fst z == fst (fst e) + s * (fst (snd e) - fst (fst e)) /\
                         snd z == snd (fst e) + s * (snd (snd e) - snd (fst e)).
Definition on_any (es : list (point * point)) (z : point) : Prop := exists e, In e es /\ on_segment e z.

Definition no_fit_claim (D G loops : list ring) (fits : list (point * point)) : Prop :=
  let L := on_any (flat_map edges loops ++ fits) in
  (forall t, L t <-> (closure (overlaps_at D G) t /\ ~ overlaps_at D G t)) /\
  (forall t, ~ L t -> (overlaps_at D G t /\ winding loops t = 1%Z) \/ (~ overlaps_at D G t /\ winding loops t = 0%Z)).

(* Named loops, all listed counter-clockwise: each is simple, and the holes are disjoint and inside the exterior.
   `simple` concerns winding numbers: a loop may touch itself. *)
Definition named (exterior : ring) (holes : list ring) : Prop :=
  simple [exterior] /\ Forall (fun h => simple [h]) holes /\ (forall z, winding holes z = 0%Z \/ winding holes z = 1%Z) /\
  forall z, winding holes z = 1%Z -> winding [exterior] z = 1%Z.
Definition with_holes (exterior : ring) (holes : list ring) : list ring := exterior :: map (@rev _) holes.
(* Contact: the closed shapes have a common point, but no overlap. *)
Definition touches_at (D G : list ring) (t : point) : Prop :=
  (exists z, closure (inside D) z /\ closure (inside (translate t G)) z) /\ ~ overlaps_at D G t.
Definition no_fit_polygon (D G : list ring) (exterior : ring) (holes : list ring) (fits : list (point * point)) : Prop :=
  let L := on_any (flat_map edges (with_holes exterior holes) ++ fits) in
  no_fit_claim D G (with_holes exterior holes) fits /\ (forall t, L t <-> touches_at D G t) /\ named exterior holes.

(* Inner fits: the translations t at which G + t is in the container C.  The claim about regions and exact fits. *)
Definition fits_at (C G : list ring) (t : point) : Prop := forall z, inside (translate t G) z -> inside C z.
Definition inner_fit_claim (C G regions : list ring) (fits : list (point * point)) : Prop :=
  let L := on_any (flat_map edges regions ++ fits) in
  (forall t, L t <-> (fits_at C G t /\ closure (fun u => ~ fits_at C G u) t)) /\
  (forall t, ~ L t -> (fits_at C G t /\ winding regions t = 1%Z) \/ (~ fits_at C G t /\ winding regions t = 0%Z)).
Definition inner_fit_polygon (C G : list ring) (regions : list (ring * list ring)) (fits : list (point * point)) : Prop :=
  inner_fit_claim C G (flat_map (fun r => with_holes (fst r) (snd r)) regions) fits /\ Forall (fun r => named (fst r) (snd r)) regions.

(* Swept areas: G moves along the segments T.  Off the loops and the slits, which are not part of the answer, the loops
   wind once around the points that G covers, and not around others. *)
Definition swept (T : list (point * point)) (G : list ring) (p : point) : Prop := exists t, on_any T t /\ closure (inside (translate t G)) p.
Definition sweep_claim (T : list (point * point)) (G loops : list ring) (slits : list (point * point)) : Prop :=
  forall p, ~ on_any (flat_map edges loops ++ slits) p ->
    (swept T G p /\ winding loops p = 1%Z) \/ (~ swept T G p /\ winding loops p = 0%Z).
(* Twice the area of rings, by the shoelace formula *)
Definition doubled_area (rs : list ring) : Q :=
  fold_right Qplus 0 (map (fun e => fst (fst e) * snd (snd e) - fst (snd e) * snd (fst e)) (flat_map edges rs)).
(* A sweep: T is the exterior of the no-fit polygon; the inner loop winds around D, that is, around a point of D. *)
Definition sweep_of (D G : list ring) (T : ring) (holes : list ring) (fits : list (point * point))
    (outer inner : ring) (unswept : list ring) (slits : list (point * point)) (area : Q) : Prop :=
  let loops := with_holes outer (inner :: unswept) in
  no_fit_polygon D G T holes fits /\ sweep_claim (edges T) G loops slits /\ named outer (inner :: unswept) /\
  (exists z, inside D z /\ winding [inner] z = 1%Z) /\ 2 * area == doubled_area loops.
(* The sum of a shape and a path: the area that the shape covers along the path *)
Definition path_sum (G : list ring) (path : list point) (exterior : ring) (holes : list ring) (slits : list (point * point)) : Prop :=
  sweep_claim (combine path (tl path)) G (with_holes exterior holes) slits /\ named exterior holes.
