(* Points deep in a figure or far from it: a disc around them is entirely inside it or entirely outside. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Statements.
From Exactsweep Require Import Gaps Scaling HalfOpen Nearby Boundary SumPoints PiecePoints Covers Near.
Import ListNotations.
Open Scope Q_scope.

Definition vector (y z : qpoint) : qpoint := (fst z - fst y, snd z - snd y).
Definition across (e : side) : qpoint := (snd (snd e) - snd (fst e), - (fst (snd e) - fst (fst e))).   (* to the right of an edge *)
Definition reduced (n : qpoint) : qpoint := (Qred (fst n), Qred (snd n)).
Definition back (n : qpoint) : qpoint := (- fst n, - snd n).

(* In direction n, all points are more than d ahead of z. *)
Definition ahead (d : Q) (z : qpoint) (ps : list qpoint) (n : qpoint) : bool :=
  let s := Qred (d * d * square_of n) in
  forallb (fun p => let g := Qred (along n p - along n z) in Statements.less 0 g && Statements.less s (g * g)) ps.
Definition directions (z : qpoint) (ps : list qpoint) : list qpoint :=
  map (fun p => reduced (vector z p)) ps ++ flat_map (fun e => let n := reduced (across e) in [n; back n]) (Statements.edges ps).
Definition is_far (d : Q) (ps : list qpoint) (z : qpoint) : bool := some (ahead d z ps) (directions z ps).
Definition far_edges (d : Q) (rs : list Statements.ring) (z : qpoint) : bool :=
  let z := reduced z in forallb (fun e => is_far d [reduced (fst e); reduced (snd e)] z) (flat_map Statements.edges rs).

(* Points of a hull: vertices, points on edges, and z itself if it is in a triangle of vertices *)
Definition foot (z : qpoint) (e : side) : list qpoint :=
  let v := vector (fst e) (snd e) in let t := along v (vector (fst e) z) / square_of v in
  if Statements.less 0 (square_of v) && Qle_bool 0 t && Qle_bool t 1 then [(fst (fst e) + t * fst v, snd (fst e) + t * snd v)] else [].
Definition in_triangle (p : qpoint) (e : side) (z : qpoint) : bool :=
  let w := o (p, fst e) z in let u := o e z in let v := o (snd e, p) z in
  Qle_bool 0 w && Qle_bool 0 u && Qle_bool 0 v && Statements.less 0 (u + v + w).
Definition hull_points (ps : list qpoint) (z : qpoint) : list qpoint :=
  ps ++ flat_map (foot z) (Statements.edges ps) ++ if existsb (fun e => in_triangle (hd z ps) e z) (Statements.edges ps) then [z] else [].
Definition inner (d : Q) (ps : list qpoint) (z : qpoint) : bool :=     (* left of all edges, at distance more than d *)
  match ps with [] => false | _ => forallb (fun e => ahead d z [fst e] (across e)) (Statements.edges ps) end.

(* 1. Disc and line *)
Lemma square_of_nonneg n : 0 <= square_of n.
Proof. unfold square_of. pose proof (sq_nonneg (fst n)). pose proof (sq_nonneg (snd n)). lra. Qed.
Lemma sq_less a b : 0 <= b -> a * a < b * b -> a < b.
Proof. intros B H. destruct (Qlt_le_dec a b) as [|L]; [assumption|exfalso]. pose proof (sq_le b a B L). lra. Qed.
Lemma root_above d N x : 0 <= d -> 0 <= N -> d * d * N < x -> exists c, d < c /\ c * c * N < x.
Proof.
  intros D Np H. set (k := N * (2 * d + 1) + 1). assert (K : 0 < k) by (assert (0 <= N * (2 * d + 1)) by (apply Qmult_le_0_compat; lra); unfold k; lra).
  assert (V : 0 < (x - d * d * N) / k) by (apply Qlt_shift_div_l; lra).
  destruct (below 1 ((x - d * d * N) / k)) as (e & E & E1 & E2); [lra|exact V|]. exists (d + e / 2). assert (H2 : e / 2 == (1 # 2) * e) by field.
  split; [lra|]. rewrite H2. pose proof (mono_le k e _ ltac:(lra) E2) as J. assert (M : k * ((x - d * d * N) / k) == x - d * d * N) by (field; lra). rewrite M in J.
  assert (F : (d + (1 # 2) * e) * (d + (1 # 2) * e) * N == d * d * N + N * (d + (1 # 4) * e) * e) by ring. rewrite F.
  assert (G : N * (d + (1 # 4) * e) * e <= N * (2 * d + 1) * e).
  { apply Qmult_le_compat_r; [|lra]. apply mono_le; lra. }
  assert (0 < e * 1) by lra. unfold k in J. assert (X : (N * (2 * d + 1) + 1) * e == N * (2 * d + 1) * e + e) by ring. rewrite X in J. lra.
Qed.
Lemma ahead_spec d z ps n : 0 <= d -> ps <> [] -> ahead d z ps n = true ->
  exists c m, d < c /\ (forall y, Statements.dist2 y z <= c * c -> along n y < m) /\ forall p, In p ps -> m <= along n p.
Proof.
  intros D Ne H. unfold ahead in H. rewrite forallb_forall in H.
  destruct (least (along n) (fun _ => True) (fun _ => left I) ps) as (p & Ip & _ & M).
  { destruct ps as [|p ps]; [contradiction|]. exists p. split; [left; reflexivity|exact I]. }
  specialize (H p Ip). cbv zeta in H. apply andb_prop in H as (G0 & G). apply less_true in G0, G. rewrite !Qred_correct in G. rewrite Qred_correct in G0.
  destruct (root_above d (square_of n) _ D (square_of_nonneg n) G) as (c & C & L). exists c, (along n p). split; [exact C|]. split.
  - intros y Y. rewrite dist2_sym in Y. pose proof (cauchy n z y c ltac:(lra) Y) as X.
    assert (along n y - along n z < along n p - along n z); [|lra]. apply sq_less; [lra|].
    assert (E : square_of n * (c * c) == c * c * square_of n) by ring. lra.
  - intros q Iq. apply M; [exact Iq|exact I].
Qed.
Lemma is_far_spec d ps z : 0 <= d -> ps <> [] -> is_far d ps z = true ->
  exists n c m, d < c /\ (forall y, Statements.dist2 y z <= c * c -> along n y < m) /\ forall p, In p ps -> m <= along n p.
Proof.
  intros D Ne H. apply some_exists in H as (n & _ & H). exists n. exact (ahead_spec d z ps n D Ne H).
Qed.
Lemma is_far_some d ps z : is_far d ps z = true -> ps <> [].
Proof. intros H E. rewrite E in H. discriminate. Qed.

(* A common disc for all members of a list *)
Lemma common_disc {A} d z (P : A -> qpoint -> Prop) l :
  (forall a, In a l -> exists c, d < c /\ forall y, Statements.dist2 y z <= c * c -> P a y) -> 0 <= d ->
  exists c, d < c /\ forall y, Statements.dist2 y z <= c * c -> forall a, In a l -> P a y.
Proof.
  intros H D. induction l as [|a l IH]; [exists (d + 1); split; [lra|intros y _ a []]|].
  destruct IH as (c & C & F); [intros b B; apply H; right; exact B|]. destruct (H a (or_introl eq_refl)) as (c' & C' & F').
  destruct (Qlt_le_dec c c') as [L|L].
  - exists c. split; [exact C|]. intros y Y b [<-|B]; [apply F'|exact (F y Y b B)]. pose proof (sq_lt c c' ltac:(lra) L). lra.
  - exists c'. split; [exact C'|]. intros y Y b [<-|B]; [apply F', Y|apply (F y); [|exact B]]. pose proof (sq_le c' c ltac:(lra) L). lra.
Qed.

(* 2. Winding numbers in a disc *)
Lemma integral_mul N k q : integral N q = true -> integral (N * k) q = true.
Proof.
  unfold integral. intro H. apply Z.eqb_eq in H. apply Z.eqb_eq. apply Z.mod_divide in H; [|discriminate]. apply Z.mod_divide; [discriminate|].
  apply Z.divide_mul_l, H.
Qed.
Lemma integral_own q : integral (QDen (Qred q)) q = true.
Proof. unfold integral. apply Z.eqb_eq, Z_mod_same_full. Qed.
Lemma common_unit (l : list Q) : exists N, (0 < N)%Z /\ forall q, In q l -> integral N q = true.
Proof.
  induction l as [|q l (N & P & H)]; [exists 1%Z; split; [reflexivity|intros q []]|].
  exists (N * QDen (Qred q))%Z. split; [lia|]. intros r [<-|I]; [|apply integral_mul, H, I].
  rewrite Z.mul_comm. apply integral_mul, integral_own.
Qed.
Lemma common_rings rs : exists N, (0 < N)%Z /\ all_integral N rs = true.
Proof.
  destruct (common_unit (flat_map (flat_map (fun p => [fst p; snd p])) rs)) as (N & P & H). exists N. split; [exact P|].
  unfold all_integral. apply forallb_forall. intros r R. apply forallb_forall. intros p Ip. apply andb_true_intro.
  split; apply H; apply in_flat_map; exists r; (split; [exact R|]); apply in_flat_map; exists p; (split; [exact Ip|]); cbn; auto.
Qed.
Lemma constant_disc rs x y :
  (forall e, In e (flat_map Statements.edges rs) -> exists n m, along n x < m /\ along n y < m /\ m <= along n (fst e) /\ m <= along n (snd e)) ->
  Statements.winding rs x = Statements.winding rs y.
Proof.
  intro H. destruct (common_rings rs) as (N & P & In_). apply (constant_rings_q N rs x y P In_). intros e E.
  destruct (H e E) as (n & m & H1 & H2 & H3 & H4). destruct (at_common (fst n) (snd n) 0 0) as (k & a & b & _ & _ & K & A & B & _).
  exists (a, b), (inject_Z k * m). unfold at_ in A, B. pose proof (inject_pos k K) as Kq.
  assert (F : forall z, qdot (a, b) z == inject_Z k * along n z) by (intro z; unfold qdot, along; cbn [fst snd]; rewrite <- A, <- B; ring).
  rewrite !F. repeat split; try (apply mono_lt; assumption); apply mono_le; try assumption; lra.
Qed.
Lemma along_reduced n p : along n (reduced p) == along n p.
Proof. unfold along, reduced. cbn [fst snd]. rewrite !Qred_correct. reflexivity. Qed.
Lemma dist2_reduced y z : Statements.dist2 y (reduced z) == Statements.dist2 y z.
Proof. unfold Statements.dist2, reduced. cbn [fst snd]. rewrite !Qred_correct. reflexivity. Qed.
Lemma far_winding d rs z : 0 <= d -> far_edges d rs z = true ->
  exists c, d < c /\ forall y, Statements.dist2 y z <= c * c -> Statements.winding rs y = Statements.winding rs z.
Proof.
  intros D H. unfold far_edges in H. cbv zeta in H. rewrite forallb_forall in H.
  destruct (common_disc d z (fun e y => exists n m, along n y < m /\ along n z < m /\ m <= along n (fst e) /\ m <= along n (snd e)) (flat_map Statements.edges rs))
    as (c & C & F); [|exact D|].
  - intros e E. destruct (is_far_spec d [reduced (fst e); reduced (snd e)] (reduced z) D ltac:(discriminate) (H e E)) as (n & c & m & C & Y & P). exists c. split; [exact C|].
    assert (Y' : forall y, Statements.dist2 y z <= c * c -> along n y < m) by (intros y Dy; apply Y; rewrite dist2_reduced; exact Dy).
    intros y Dy. exists n, m. split; [apply Y', Dy|]. split; [|split; rewrite <- along_reduced; apply P; [left|right; left]; reflexivity].
    apply Y'. assert (Z : Statements.dist2 z z == 0) by (unfold Statements.dist2; ring). rewrite Z. apply sq_nonneg.
  - exists c. split; [exact C|]. intros y Y. apply constant_disc. exact (F y Y).
Qed.

(* 3. Hulls *)
Lemma hull_vertex ps p : In p ps -> Statements.hull ps p.
Proof. intros I a b c H. apply H, I. Qed.
Lemma hull_edge ps e t : In (fst e) ps -> In (snd e) ps -> 0 <= t <= 1 ->
  Statements.hull ps (fst (fst e) + t * fst (vector (fst e) (snd e)), snd (fst e) + t * snd (vector (fst e) (snd e))).
Proof.
  intros I J (T0 & T1) a b c H. pose proof (H _ I) as X. pose proof (H _ J) as Y. unfold vector. cbn [fst snd].
  assert (0 <= t * (c - (a * fst (snd e) + b * snd (snd e)))) by (apply Qmult_le_0_compat; lra).
  assert (0 <= (1 - t) * (c - (a * fst (fst e) + b * snd (fst e)))) by (apply Qmult_le_0_compat; lra). lra.
Qed.
Lemma hull_triangle ps p a b z : In p ps -> In a ps -> In b ps -> 0 <= o (p, a) z -> 0 <= o (a, b) z -> 0 <= o (b, p) z ->
  0 < o (p, a) b -> Statements.hull ps z.
Proof.
  intros P A B W U V T i j c H. destruct (mean_self p a b z T) as (X & Y). pose proof (o_total p a b z) as E. rewrite X, Y. clear X Y.
  pose proof (H p P) as Hp. pose proof (H a A) as Ha. pose proof (H b B) as Hb. revert W U V E. generalize (o (p, a) z) (o (a, b) z) (o (b, p) z). intros w u v W U V E.
  unfold mean. cbn [fst snd]. assert (S0 : 0 < u + v + w) by lra.
  assert (F : i * ((u * fst p + v * fst a + w * fst b) / (u + v + w)) + j * ((u * snd p + v * snd a + w * snd b) / (u + v + w)) ==
    (u * (i * fst p + j * snd p) + v * (i * fst a + j * snd a) + w * (i * fst b + j * snd b)) / (u + v + w)) by (field; lra).
  rewrite F. apply Qle_shift_div_r; [exact S0|].
  assert (0 <= u * (c - (i * fst p + j * snd p))) by (apply Qmult_le_0_compat; lra).
  assert (0 <= v * (c - (i * fst a + j * snd a))) by (apply Qmult_le_0_compat; lra).
  assert (0 <= w * (c - (i * fst b + j * snd b))) by (apply Qmult_le_0_compat; lra). lra.
Qed.
Lemma qedges_ends ps e : In e (Statements.edges ps) -> In (fst e) ps /\ In (snd e) ps.
Proof.
  destruct ps as [|p t]; [intros []|]. cbn [Statements.edges]. destruct e as [a b]. intro I. split; [exact (in_combine_l _ _ _ _ I)|].
  apply in_combine_r, in_app_or in I as [I|[<-|[]]]; [right; exact I|left; reflexivity].
Qed.
Lemma hull_points_in ps z q : In q (hull_points ps z) -> Statements.hull ps q.
Proof.
  unfold hull_points. intro I. apply in_app_or in I as [I|I]; [apply hull_vertex, I|]. apply in_app_or in I as [I|I].
  - apply in_flat_map in I as (e & E & I). apply qedges_ends in E as (E1 & E2). unfold foot in I. cbv zeta in I.
    destruct (Statements.less 0 (square_of (vector (fst e) (snd e))) && Qle_bool 0 _ && Qle_bool _ 1) eqn:C; [|destruct I].
    apply andb_prop in C as (C & C1). apply andb_prop in C as (_ & C0). apply Qle_bool_iff in C0, C1. destruct I as [<-|[]].
    apply hull_edge; [exact E1|exact E2|split; assumption].
  - destruct (existsb _ _) eqn:E; [|destruct I]. destruct I as [<-|[]]. apply existsb_exists in E as (e & E & T).
    pose proof (qedges_ends ps e E) as (E1 & E2). destruct ps as [|p ps]; [destruct E1|]. cbn [hd] in T. unfold in_triangle in T. cbv zeta in T.
    apply andb_prop in T as (T & S). apply andb_prop in T as (T & V). apply andb_prop in T as (W & U). apply Qle_bool_iff in W, U, V. apply less_true in S.
    destruct e as [a b]. cbn [fst snd] in *. apply (hull_triangle _ p a b); try assumption; [left; reflexivity|]. rewrite <- (o_total p a b z). exact S.
Qed.
Lemma inner_spec d ps z : 0 <= d -> inner d ps z = true -> exists c, d < c /\ forall y, Statements.dist2 y z <= c * c -> Statements.hull ps y.
Proof.
  intros D H. assert (Ne : ps <> []) by (destruct ps; [discriminate|discriminate]).
  assert (H' : forallb (fun e => ahead d z [fst e] (across e)) (Statements.edges ps) = true) by (destruct ps; [discriminate|exact H]). clear H. rewrite forallb_forall in H'.
  destruct (common_disc d z (fun e y => 0 < o e y) (Statements.edges ps)) as (c & C & F); [|exact D|].
  - intros e E. destruct (ahead_spec d z [fst e] (across e) D ltac:(discriminate) (H' e E)) as (c & m & C & Y & P). exists c. split; [exact C|].
    intros y Dy. specialize (Y y Dy). specialize (P (fst e) (or_introl eq_refl)). unfold along, across, o, Statements.orient in *. cbn [fst snd] in *. lra.
  - exists c. split; [exact C|]. intros y Y. destruct (find_triangle ps y (F y Y) Ne) as (p & a & b & P & A & B & H1 & H2 & H3).
    apply (hull_triangle ps p a b); try assumption; try lra. rewrite <- (o_total p a b y). lra.
Qed.
