(* Soundness of `boundary`: the loops and fits are the boundary of the union of all sums. *)
Require Import QArith Lqa ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant Fans Pieces Convex Solid Gaps Boxes Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers Spans Sums.
Import ListNotations.
Open Scope Q_scope.

Lemma qrings_at N loops : rings_at (Zpos N) (map (qring N) loops) loops.
Proof. unfold rings_at. induction loops as [|r l IH]; constructor; [apply qring_at|exact IH]. Qed.

Section Accepted.
Variables (N : positive) (ds hs : list ring) (beyond : list edge) (loops : list ring) (fits : list edge)
  (listed : list (Z * list (list Z))) (around : list (list Z)) (wanted : Z).
(* Properties of the sum of two pieces as a set *)
Variable at_sum : ring -> ring -> qpoint -> Prop.
Notation qe := (qe N).
Hypothesis Bound : forall P Q n t, In P ds -> In Q hs -> n <> (0, 0)%Z -> at_sum P Q t ->
  qdot n t * inject_Z (Zpos N) < inject_Z (most n P + most n Q).
Hypothesis Center : forall P Q, In P ds -> In Q hs -> at_sum P Q (third N (plus (center P) (center Q))).
Hypothesis Inside : forall P Q t, In P ds -> In Q hs -> add P Q <> [] -> inS (map qe (sum_sides P Q)) t -> at_sum P Q t.
Hypothesis Common :
  (forall P P' Q v, In P ds -> In P' ds -> In Q hs -> In v P -> In v P' -> exists t, at_sum P Q t /\ at_sum P' Q t) /\
  (are_segments ds = false -> forall P Q Q' v, In P ds -> In Q hs -> In Q' hs -> In v Q -> In v Q' -> exists t, at_sum P Q t /\ at_sum P Q' t).
Definition beyond_at (t : qpoint) : Prop := exists f, In f beyond /\ 0 < o (qe f) t.
Definition O (t : qpoint) : Prop := (exists P Q, In P ds /\ In Q hs /\ at_sum P Q t) \/ beyond_at t.
Definition wind_at (t : qpoint) : Z := Statements.winding (map (qring N) loops) t.
Hypothesis Level : forall t, beyond_at t -> wind_at t = wanted.
Hypothesis Line : forall f x, In f beyond -> o (qe f) x == 0 -> Statements.on_segment (qe f) x \/ beyond_at x.
Hypothesis Proper : forall f, In f beyond -> exists x, 0 < o (qe f) x.
Hypothesis Far : wanted = 1%Z \/ forall t, exists x, fst t <= x /\ beyond_at (at_x t x).

Notation known := (known loops fits).
Notation loop_edges := (loop_edges loops).
Notation polygons := (polygons ds hs beyond listed).
Notation chains := (chains listed around).
Notation named := (named ds hs beyond listed around).
Definition on_known (t : qpoint) : Prop := Statements.on_any (map qe known) t.

Hypothesis Edges : forall e, In e loop_edges -> fst e <> snd e.
Hypothesis Distinct : all_pairs distinct loop_edges = true.
Hypothesis Clear : all_clear ds hs loops fits = true.
Hypothesis Winds : wind_all ds hs loops wanted = true.
Hypothesis Outside : forall f e, In f beyond -> In e known -> (det (fst f) (snd f) (fst e) <= 0 /\ det (fst f) (snd f) (snd e) <= 0)%Z.
Hypothesis Sums_ : forall x, In x listed -> is_sum ds hs (fst x) = true.
Hypothesis Chains : zip_all (zip_all (fun f chain => negb (same (fst f) (snd f)) && covers (spans_of polygons known f chain))) polygons chains = true.
Notation sides := (sides_at (by_edge named)).
Hypothesis Beside : forall e, In e loop_edges -> exists k, beside true (sides k) e = true.
Hypothesis Fits : forall e, In e fits -> exists k,
  (if same (fst e) (snd e) then on_side (sides k) e else beside true (sides k) e && beside false (sides k) e) = true.

(* (a) *)
Lemma clear_bound P Q e : In P ds -> In Q hs -> In e known -> exists n m,
  (forall t, at_sum P Q t -> qdot n t * inject_Z (Zpos N) < inject_Z m) /\ (m <= dot n (fst e))%Z /\ (m <= dot n (snd e))%Z.
Proof.
  intros IP IQ I. pose proof Clear as H. unfold all_clear in H. cbv zeta in H. rewrite forallb_forall in H. specialize (H P IP).
  rewrite forallb_forall in H. specialize (H Q IQ). unfold is_clear in H. cbv zeta in H.
  assert (G : exists n, n <> (0, 0)%Z /\ (bound P Q n <= dot n (fst e))%Z /\ (bound P Q n <= dot n (snd e))%Z).
  { destruct (trees_all _ _ known H e I) as [C|(b & S & W)].
    - unfold clear in C. apply some_exists in C as (n & _ & C). unfold is_beyond in C. destruct (same n (0, 0)%Z) eqn:Z; [discriminate|].
      cbv zeta in C. apply andb_prop in C as (C1 & C2). apply Z.leb_le in C1, C2. exists n. split; [intro X; apply same_spec in X; congruence|auto].
    - unfold is_box_beyond, box_of in S. destruct b as (((x, y), u), v). pose proof (W (fst e) (or_introl eq_refl)) as W1.
      pose proof (W (snd e) (or_intror eq_refl)) as W2.
      destruct (Z.leb_spec (bound P Q (1, 0)%Z) x); [exists (1, 0)%Z|destruct (Z.leb_spec (bound P Q (0, 1)%Z) y);
        [exists (0, 1)%Z|destruct (Z.leb_spec (bound P Q (-1, 0)%Z) u); [exists (-1, 0)%Z|apply Z.leb_le in S; exists (0, -1)%Z]]];
        (split; [discriminate|]); unfold dot; cbn [fst snd]; lia. }
  destruct G as (n & G0 & G1 & G2). exists n, (bound P Q n). split; [|split; assumption].
  intros t T. exact (Bound P Q n t IP IQ G0 T).
Qed.

Lemma on_ends e x n m : Statements.on_segment (qe e) x -> (m <= dot n (fst e))%Z -> (m <= dot n (snd e))%Z ->
  inject_Z m <= qdot n x * inject_Z (Zpos N).
Proof.
  intros (s & (S0 & S1) & X & Y) A B.
  assert (E : qdot n x * inject_Z (Zpos N) == (1 - s) * (qdot n (fst (qe e)) * inject_Z (Zpos N)) + s * (qdot n (snd (qe e)) * inject_Z (Zpos N)))
    by (unfold qdot; rewrite X, Y; ring).
  change (fst (qe e)) with (qpt N (fst e)) in E. change (snd (qe e)) with (qpt N (snd e)) in E.
  rewrite !qdot_qpt in E. rewrite E. rewrite Zle_Qle in A, B.
  assert (0 <= s * (inject_Z (dot n (snd e)) - inject_Z m)) by (apply Qmult_le_0_compat; lra).
  assert (0 <= (1 - s) * (inject_Z (dot n (fst e)) - inject_Z m)) by (apply Qmult_le_0_compat; lra). lra.
Qed.

Lemma free t : on_known t -> ~ O t.
Proof.
  intros (e' & I & X). apply in_map_iff in I as (e & <- & I). intros [(P & Q & IP & IQ & T)|(f & F & T)].
  - destruct (clear_bound P Q e IP IQ I) as (n & m & B & A1 & A2). specialize (B t T).
    pose proof (on_ends e t n m X A1 A2). lra.
  - destruct (Outside f e F I) as (A & B). destruct X as (s & (S0 & S1) & X & Y). rewrite (o_share _ _ _ s t X Y) in T.
    change (fst (qe e)) with (qpt N (fst e)) in T. change (snd (qe e)) with (qpt N (snd e)) in T.
    assert (A' : o (qe f) (qpt N (fst e)) <= 0) by (destruct (Qlt_le_dec 0 (o (qe f) (qpt N (fst e)))) as [L|L]; [apply o_pos in L; lia|exact L]).
    assert (B' : o (qe f) (qpt N (snd e)) <= 0) by (destruct (Qlt_le_dec 0 (o (qe f) (qpt N (snd e)))) as [L|L]; [apply o_pos in L; lia|exact L]).
    assert (0 <= s * - o (qe f) (qpt N (snd e))) by (apply Qmult_le_0_compat; lra).
    assert (0 <= (1 - s) * - o (qe f) (qpt N (fst e))) by (apply Qmult_le_0_compat; lra). lra.
Qed.

(* (d) *)
Definition level (P Q : ring) : Z := wind_at (third N (plus (center P) (center Q))).
Lemma level_of P Q t : In P ds -> In Q hs -> at_sum P Q t -> wind_at t = level P Q.
Proof.
  intros IP IQ T. apply constant_loops. intros e I. destruct (clear_bound P Q e IP IQ) as (n & m & B & A1 & A2); [apply in_or_app; left; exact I|].
    exists n, m. split; [exact (B t T)|]. split; [apply B, Center; assumption|]. split; assumption.
Qed.
Lemma level_wanted P Q : winds wanted (map (grow_edge 3) loop_edges) P Q = true -> level P Q = wanted.
Proof.
  unfold winds. intro H. apply Z.eqb_eq in H. rewrite <- H. unfold level, wind_at.
  rewrite (winding_at (3 * Zpos N) (map (qring N) loops) (map (map (grow 3)) loops) _ (plus (center P) (center Q)));
    [|lia|apply rings_grow, qrings_at|apply third_at].
  rewrite W_edges. reflexivity.
Qed.
Lemma level_all P Q : In P ds -> In Q hs -> level P Q = wanted.
Proof.
  intros IP IQ. pose proof Winds as H. unfold wind_all in H. cbv zeta in H. rewrite forallb_forall in H. destruct Common as (Cd & Ch).
  destruct (groups_spec (fun P' => level P' Q) ds) as (Gp & Gg).
  { intros P1 P2 v I1 I2 V1 V2. destruct (Cd P1 P2 Q v I1 I2 IQ V1 V2) as (t & T1 & T2).
    rewrite <- (level_of P1 Q t I1 IQ T1). exact (level_of P2 Q t I2 IQ T2). }
  destruct (Gp P IP) as (g & G & ->). specialize (H g G). rewrite forallb_forall in H. pose proof (proj1 (Gg g G)) as IR.
  destruct (are_segments ds) eqn:S; [apply level_wanted, H, IQ|].
  destruct (groups_spec (level (fst g)) hs) as (Hp & _).
  { intros Q1 Q2 v I1 I2 V1 V2. destruct (Ch eq_refl (fst g) Q1 Q2 v IR I1 I2 V1 V2) as (t & T1 & T2).
    rewrite <- (level_of (fst g) Q1 t IR I1 T1). exact (level_of (fst g) Q2 t IR I2 T2). }
  destruct (Hp Q IQ) as (h & Hh & ->). apply level_wanted, H, in_map, Hh.
Qed.
Lemma once t : O t -> wind_at t = wanted.
Proof.
  intros [(P & Q & IP & IQ & T)|B]; [|exact (Level t B)]. rewrite (level_of P Q t IP IQ T). exact (level_all P Q IP IQ).
Qed.

(* The listed polygons *)
Lemma pair_in k : (0 <= k < Z.of_nat (length ds) * columns hs)%Z -> In (fst (pair_of ds hs k)) ds /\ In (snd (pair_of ds hs k)) hs.
Proof.
  intro K. unfold pair_of. cbn [fst snd]. unfold columns in *.
  assert (H : (0 < Z.of_nat (length hs))%Z) by nia. split; apply nth_In.
  - assert (k / Z.of_nat (length hs) < Z.of_nat (length ds))%Z by (apply Z.div_lt_upper_bound; lia). pose proof (Z.div_pos k _ (proj1 K) H). lia.
  - pose proof (Z.mod_pos_bound k _ H). lia.
Qed.
Lemma polygon_cases p : In p polygons -> (exists x, In x listed /\ p = sides_of ds hs (fst x)) \/ (exists f, In f beyond /\ p = [f]).
Proof.
  intro I. apply in_app_or in I as [I|I]; apply in_map_iff in I as (x & <- & I); [left|right]; exists x; auto.
Qed.
Lemma listed_spec x : In x listed -> let p := map qe (sides_of ds hs (fst x)) in
  convex p /\ linked p /\ (exists z, inS p z) /\ (forall t, inS p t -> O t).
Proof.
  intro I. pose proof (Sums_ x I) as H. unfold is_sum in H. destruct (pair_of ds hs (fst x)) as (P, Q) eqn:E.
  apply andb_prop in H as (H & C). apply andb_prop in H as (K & H). apply andb_prop in K as (K0 & K). apply Z.leb_le in K0. apply Z.ltb_lt in K.
  pose proof (pair_in (fst x) (conj K0 K)) as (IP & IQ). rewrite E in IP, IQ. cbn [fst snd] in IP, IQ.
  destruct (convex_sides N _ H) as (A & B). assert (S : sides_of ds hs (fst x) = sum_sides P Q) by (unfold sides_of; rewrite E; reflexivity).
  cbv zeta. rewrite S in *. split; [exact A|]. split; [exact B|]. split.
  - exists (third N (plus (center P) (center Q))). intros f' F. apply in_map_iff in F as (f & <- & F).
    rewrite forallb_forall in C. apply left_of_spec, C, F.
  - intros t T. left. exists P, Q. split; [exact IP|]. split; [exact IQ|].
    apply Inside; [exact IP|exact IQ| |exact T]. intro Ad. unfold sum_vertices in H. rewrite Ad in H. discriminate.
Qed.
Lemma beyond_half f : In f beyond -> let p := map qe [f] in convex p /\ (exists z, inS p z) /\ (forall t, inS p t -> O t).
Proof.
  intro I. cbv zeta. cbn [map]. split; [|split].
  - intros g h [<-|[]] [<-|[]].
    assert (A : o (qe f) (fst (qe f)) == 0) by (unfold o, Statements.orient; ring).
    assert (B : o (qe f) (snd (qe f)) == 0) by (unfold o, Statements.orient; ring).
    split; [lra|]. split; [lra|]. right. right. reflexivity.
  - destruct (Proper f I) as (x & X). exists x. intros g [<-|[]]. exact X.
  - intros t T. right. exists f. split; [exact I|]. apply T. left. reflexivity.
Qed.

Definition sums : list (list side) := map (map qe) polygons.
Lemma sum_cases S : In S sums -> exists p, In p polygons /\ S = map qe p.
Proof. intro I. apply in_map_iff in I as (p & <- & I). exists p. auto. Qed.
Lemma sum_convex S : In S sums -> convex S.
Proof.
  intro I. destruct (sum_cases S I) as (p & J & ->). destruct (polygon_cases p J) as [(x & X & ->)|(f & F & ->)].
  - apply (listed_spec x X).
  - apply (beyond_half f F).
Qed.
Lemma sum_inner S : In S sums -> exists z, inS S z.
Proof.
  intro I. destruct (sum_cases S I) as (p & J & ->). destruct (polygon_cases p J) as [(x & X & ->)|(f & F & ->)].
  - apply (listed_spec x X).
  - apply (beyond_half f F).
Qed.
Lemma sum_O S t : In S sums -> inS S t -> O t.
Proof.
  intro I. destruct (sum_cases S I) as (p & J & ->). destruct (polygon_cases p J) as [(x & X & ->)|(f & F & ->)].
  - apply (listed_spec x X).
  - apply (beyond_half f F).
Qed.
Notation edges_of := (map qe).
Lemma known_app t : on_known t <-> L (edges_of loop_edges) (edges_of fits) t.
Proof. unfold on_known, L. unfold Sums.known. rewrite map_app. reflexivity. Qed.
Lemma beyond_U t : beyond_at t -> U sums t.
Proof.
  intros (f & I & F). exists (map qe [f]). split.
  - apply in_map, in_or_app. right. apply (in_map (fun f => [f])), I.
  - intros g [<-|[]]. exact F.
Qed.

(* (b) *)
Lemma chain_of p f : In p polygons -> In f p -> exists c, In (f, c) named /\ fst f <> snd f /\ covers (spans_of polygons known f c) = true.
Proof.
  intros I F. destruct (zip_all_in _ _ _ Chains p I) as (cs & J & H). destruct (zip_all_in _ _ _ H f F) as (c & K & C).
  apply andb_prop in C as (C1 & C2). exists c. split; [|split; [apply same_not, C1|exact C2]].
  apply in_flat_map. exists (p, cs). split; assumption.
Qed.
Lemma covered_side p f x : In p polygons -> In f p -> Statements.on_segment (qe f) x -> U sums x \/ on_known x.
Proof.
  intros I F X. destruct (chain_of p f I F) as (c & _ & Ne & C). destruct (on_point_at _ _ X) as (s & S & M).
  destruct (covers_spec _ s C S) as (y & Y & Sp). unfold spans_of in Y. apply in_flat_map in Y as (n & _ & Y).
  destruct (0 <=? n)%Z.
  - destruct (nth_error polygons (Z.to_nat n)) as [q|] eqn:Q; [|destruct Y].
    destruct (clip q (fst f) (snd f)) as [(u, v)|] eqn:Cl; [|destruct Y]. destruct Y as [<-|[]]. cbn [in_span] in Sp.
    left. exists (map qe q). split; [apply in_map, (nth_error_In _ _ Q)|]. apply (inS_same _ _ _ M).
    exact (clip_inside N q f u v s Cl Sp S).
  - destruct (nth_error known (Z.to_nat (-1 - n))) as [e|] eqn:E; [|destruct Y].
    destruct (share f e) as [(u, v)|] eqn:Sh; [|destruct Y]. destruct Y as [<-|[]]. cbn [in_span] in Sp.
    right. exists (qe e). split; [apply in_map, (nth_error_In _ _ E)|]. apply (on_same _ _ _ M).
    exact (share_on N f e u v s Ne Sh Sp).
Qed.
Lemma cover S f x : In S sums -> In f S -> o f x == 0 -> (forall g, In g S -> 0 <= o g x) -> U sums x \/ on_known x.
Proof.
  intros I F X A. destruct (sum_cases S I) as (p & J & ->). pose proof F as F'. apply in_map_iff in F as (g & <- & G).
  destruct (polygon_cases p J) as [(y & Y & E)|(h & Hh & E)].
  - apply (covered_side p g x J G). destruct (listed_spec y Y) as (_ & Lk & _). rewrite <- E in Lk. exact (closed_on_side _ _ x Lk F' X A).
  - subst p. destruct G as [<-|[]]. destruct (Line h x Hh X) as [On|B]; [|left; apply beyond_U, B].
    apply (covered_side [h] h x J (or_introl eq_refl) On).
Qed.

(* (c) *)
Lemma sides_of_polygons k f : In f (sides k) -> exists p, In p polygons /\ In f p.
Proof.
  intro I. apply by_edge_in in I as (c & I). apply in_flat_map in I as ((p, cs) & I & J). apply in_combine_l in I, J. exists p. auto.
Qed.
Lemma along_spec k e left x : fst e <> snd e -> beside left (sides k) e = true -> Statements.on_segment (qe e) x ->
  exists p f, In p polygons /\ In f p /\ Statements.on_segment (qe f) x /\
    (left = true -> (0 < rise (qe e) -> 0 < rise (qe f)) /\ (rise (qe e) < 0 -> rise (qe f) < 0)) /\
    (left = false -> rise (qe e) < 0 -> 0 < rise (qe f)).
Proof.
  intros Ne H X. unfold beside in H. destruct (on_point_at _ _ X) as (s & S & M). destruct (covers_spec _ s H S) as (y & Y & Sp).
  apply in_flat_map in Y as (f & J & Y). apply sides_of_polygons in J as (p & I & J).
  unfold along in Y. destruct ((det (fst e) (snd e) (fst f) =? 0)%Z && (det (fst e) (snd e) (snd f) =? 0)%Z && negb (same (fst f) (snd f)) &&
    Bool.eqb (Bool.eqb (rightwards e) (rightwards f)) left) eqn:T; [|destruct Y].
  destruct (share e f) as [(u, v)|] eqn:Sh; [|destruct Y]. destruct Y as [<-|[]]. cbn [in_span] in Sp.
  apply andb_prop in T as (T & T4). apply andb_prop in T as (T & T3). apply andb_prop in T as (T1 & T2).
  apply Z.eqb_eq in T1, T2. apply same_not in T3. apply Bool.eqb_prop in T4.
  destruct (along_rise e f T1 T2 Ne T3) as (R1 & R2).
  exists p, f. split; [exact I|]. split; [exact J|]. split.
  - apply (on_same _ _ _ M). exact (share_on N e f u v s Ne Sh Sp).
  - split; intros ->.
    + apply Bool.eqb_prop in T4. destruct (R1 T4) as (R3 & R4). rewrite !rise_pos, !rise_neg. split; assumption.
    + apply Bool.eqb_false_iff in T4. rewrite rise_pos, rise_neg. exact (R2 T4).
Qed.
Lemma left_side e' x : In e' (edges_of loop_edges) -> Statements.on_segment e' x -> exists S f, In S sums /\ In f S /\
  Statements.on_segment f x /\ (0 < rise e' -> 0 < rise f) /\ (rise e' < 0 -> rise f < 0).
Proof.
  intros I X. apply in_map_iff in I as (e & <- & I). pose proof (Edges e I) as Ne. destruct (Beside e I) as (k & B).
  destruct (along_spec k e true x Ne B X) as (p & f & P & F & On & R & _).
  exists (map qe p), (qe f). split; [apply in_map, P|]. split; [apply in_map, F|]. split; [exact On|]. exact (R eq_refl).
Qed.
Lemma both_sides e' x : In e' (edges_of fits) -> ~ rise e' == 0 -> Statements.on_segment e' x -> exists S f, In S sums /\ In f S /\
  Statements.on_segment f x /\ 0 < rise f.
Proof.
  intros I R X. apply in_map_iff in I as (e & <- & I). destruct (Fits e I) as (i & H). destruct (same (fst e) (snd e)) eqn:Sm.
  - exfalso. apply same_spec in Sm. apply R. unfold rise, Spans.qe. cbn [fst snd]. rewrite Sm. ring.
  - assert (Ne : fst e <> snd e) by (intro E; apply same_spec in E; congruence). apply andb_prop in H as (H1 & H2).
    destruct (Qlt_le_dec 0 (rise (qe e))) as [P|P].
    + destruct (along_spec i e true x Ne H1 X) as (p & f & Pp & F & On & Rf & _).
      exists (map qe p), (qe f). split; [apply in_map, Pp|]. split; [apply in_map, F|]. split; [exact On|]. apply Rf; [reflexivity|exact P].
    + destruct (along_spec i e false x Ne H2 X) as (p & f & Pp & F & On & _ & Rf).
      exists (map qe p), (qe f). split; [apply in_map, Pp|]. split; [apply in_map, F|]. split; [exact On|]. apply Rf; [reflexivity|lra].
Qed.
Lemma touch e' x : In e' (edges_of loop_edges ++ edges_of fits) -> Statements.on_segment e' x -> exists S f, In S sums /\ In f S /\ Statements.on_segment f x.
Proof.
  intros I X. apply in_app_or in I as [I|I].
  - destruct (left_side e' x I X) as (S & f & A & B & C & _). exists S, f. auto.
  - apply in_map_iff in I as (e & <- & I). destruct (Fits e I) as (i & H).
    destruct (same (fst e) (snd e)) eqn:Sm.
    + apply same_spec in Sm. unfold on_side in H. apply existsb_exists in H as (f & J & H).
      apply andb_prop in H as (H & Ne). apply same_not in Ne. apply sides_of_polygons in J as (p & J & K).
      destruct (share f e) as [(s, t)|] eqn:Sh; [|discriminate]. apply andb_prop in H as (H1 & H2). apply Qle_bool_iff in H1, H2.
      assert (St : s <= t).
      { unfold share in Sh. destruct f as (a, b), e as (p0, q0). cbn [fst snd] in Sm. subst q0.
        destruct ((det a b p0 =? 0)%Z && (det a b p0 =? 0)%Z).
        - set (y := ratio _ _) in Sh at 1. destruct (leb_cases y y) as [(_ & Z0)|(Z0 & _)]; [|lra].
          change (ratio ((if (fst a =? fst b)%Z then snd else fst) p0 - (if (fst a =? fst b)%Z then snd else fst) a)
            ((if (fst a =? fst b)%Z then snd else fst) b - (if (fst a =? fst b)%Z then snd else fst) a))%Z with y in Sh.
          rewrite Z0 in Sh. destruct (Qle_bool y 1 && Qle_bool 0 y); [|discriminate]. injection Sh as <- <-. lra.
        - destruct (_ && _ && _)%bool in Sh; [|discriminate]. injection Sh as <- <-. lra. }
      pose proof (share_on N f e s t s Ne Sh ltac:(lra)) as On.
      exists (map qe p), (qe f). split; [apply in_map, J|]. split; [apply in_map, K|].
      exists s. split; [lra|]. destruct On as (r & _ & Rx & Ry). destruct X as (r' & _ & Xx & Xy).
      unfold Spans.qe in Rx, Ry, Xx, Xy. rewrite Sm in Rx, Ry, Xx, Xy. cbn [fst snd point_at] in Rx, Ry, Xx, Xy. unfold Spans.qe. cbn [fst snd].
      split; [rewrite Xx; transitivity (fst (qpt N (fst f)) + s * (fst (qpt N (snd f)) - fst (qpt N (fst f)))); [rewrite Rx; ring|reflexivity]|].
      rewrite Xy. transitivity (snd (qpt N (fst f)) + s * (snd (qpt N (snd f)) - snd (qpt N (fst f)))); [rewrite Ry; ring|reflexivity].
    + assert (Ne : fst e <> snd e) by (intro E; apply same_spec in E; congruence). apply andb_prop in H as (H1 & _).
      destruct (along_spec i e true x Ne H1 X) as (p & f & Pp & F & On & _).
      exists (map qe p), (qe f). split; [apply in_map, Pp|]. split; [apply in_map, F|]. exact On.
Qed.
Lemma all_distinct : ForallOrdPairs Boundary.distinct (edges_of loop_edges).
Proof.
  pose proof (all_pairs_spec _ _ Distinct) as H. revert H. generalize loop_edges. intros edges_ H. induction H as [|a l A B IH]; [apply FOP_nil|]. cbn [map]. apply FOP_cons; [|exact IH].
  rewrite Forall_forall in *. intros g G. apply in_map_iff in G as (f & <- & G). apply distinct_spec, A, G.
Qed.

Lemma winding_sides t : wind_sides (edges_of loop_edges) t = wind_at t.
Proof. apply wind_sides_qe. Qed.
Lemma far_U : wanted = 1%Z \/ forall t, exists x, fst t <= x /\ U sums (at_x t x).
Proof.
  destruct Far as [F|F]; [left; exact F|right]. intro t. destruct (F t) as (x & X & B). exists x. split; [exact X|apply beyond_U, B].
Qed.

(* Off loops and fits, the winding number is `wanted` on the sums and one lower elsewhere. *)
Theorem boundary_core t : ~ on_known t -> (O t /\ wind_at t = wanted) \/ (~ O t /\ wind_at t = (wanted - 1)%Z).
Proof.
  intro NL. rewrite <- winding_sides.
  apply (core sums (edges_of loop_edges) (edges_of fits) O wanted sum_convex sum_O); [| |exact far_U| |exact left_side|exact both_sides|exact all_distinct|].
  - intros u Lu. apply free, known_app, Lu.
  - intros u Ou. rewrite winding_sides. apply once, Ou.
  - intros S f x I F X A. destruct (cover S f x I F X A) as [|K]; [left; assumption|right; apply known_app, K].
  - intro Lt. apply NL, known_app, Lt.
Qed.

(* Loops and fits consist of the limit points of the sums that are in no sum. *)
Theorem boundary_limits t : on_known t <-> (Statements.closure O t /\ ~ O t).
Proof.
  rewrite known_app.
  apply (Boundary.boundary sums (edges_of loop_edges) (edges_of fits) O wanted sum_convex sum_O); [| |exact far_U| |exact left_side|exact both_sides|exact all_distinct|exact sum_inner|exact touch|].
  - intros u Lu. apply free, known_app, Lu.
  - intros u Ou. rewrite winding_sides. apply once, Ou.
  - intros S f x I F X A. destruct (cover S f x I F X A) as [|K]; [left; assumption|right; apply known_app, K].
  - intro u. unfold L. apply on_any_dec.
Qed.
(* Without half-planes, each point of a loop or fit is the sum of two points on sides of pieces. *)
Definition between (s : Q) (a b : pt) : qpoint := (fst (qpt N a) + s * (fst (qpt N b) - fst (qpt N a)), snd (qpt N a) + s * (snd (qpt N b) - snd (qpt N a))).
Theorem boundary_contact t : beyond = [] -> on_known t -> exists P Q a b c d s, In P ds /\ In Q hs /\ In a P /\ In b P /\ In c Q /\ In d Q /\
  0 <= s <= 1 /\ fst t == fst (between s a b) + fst (between s c d) /\ snd t == snd (between s a b) + snd (between s c d).
Proof.
  intros Nb K. apply known_app in K as (e & I & X). destruct (touch e t I X) as (S & f & IS & IF & (s & Hs & Tx & Ty)).
  destruct (sum_cases S IS) as (p & J & ->). apply in_map_iff in IF as (g & <- & G).
  destruct (polygon_cases p J) as [(x & Y & ->)|(h & Hh & _)]; [|rewrite Nb in Hh; destruct Hh].
  pose proof (Sums_ x Y) as H. unfold is_sum in H. destruct (pair_of ds hs (fst x)) as (P, Q) eqn:E.
  apply andb_prop in H as (H & _). apply andb_prop in H as (K & _). apply andb_prop in K as (K0 & K1). apply Z.leb_le in K0. apply Z.ltb_lt in K1.
  pose proof (pair_in (fst x) (conj K0 K1)) as (IP & IQ). rewrite E in IP, IQ. cbn [fst snd] in IP, IQ.
  assert (Sd : sides_of ds hs (fst x) = sum_sides P Q) by (unfold sides_of; rewrite E; reflexivity). rewrite Sd in G.
  unfold sum_sides, sum_vertices in G. apply edges_ends in G as (G1 & G2). apply in_map_iff in G1 as ((a, c) & E1 & G1). apply in_map_iff in G2 as ((b, d) & E2 & G2).
  apply add_in in G1 as (Ga & Gc). apply add_in in G2 as (Gb & Gd). cbn [fst snd] in *.
  exists P, Q, a, b, c, d, s. do 6 (split; [assumption|]). split; [exact Hs|].
  unfold between, Spans.qe in *. cbn [fst snd] in *. rewrite <- E1, <- E2 in Tx, Ty. unfold plus, qpt in *. cbn [fst snd] in *.
  assert (F : forall i j : Z, (i + j # N) == (i # N) + (j # N)) by (intros i j; unfold Qeq, Qplus; cbn [Qnum Qden]; rewrite Pos2Z.inj_mul; ring).
  rewrite !F in Tx, Ty. split; [rewrite Tx|rewrite Ty]; ring.
Qed.
End Accepted.

(* All conditions as one Boolean *)
Lemma boundary_parts ds hs beyond loops fits listed around wanted : Sums.boundary ds hs beyond loops fits listed around wanted = true ->
  (forall e, In e (loop_edges loops) -> fst e <> snd e) /\ all_pairs distinct (loop_edges loops) = true /\
  all_clear ds hs loops fits = true /\ wind_all ds hs loops wanted = true /\
  (forall f e, In f beyond -> In e (known loops fits) -> (det (fst f) (snd f) (fst e) <= 0 /\ det (fst f) (snd f) (snd e) <= 0)%Z) /\
  (forall x, In x listed -> is_sum ds hs (fst x) = true) /\
  zip_all (zip_all (fun f chain => negb (same (fst f) (snd f)) && covers (spans_of (polygons ds hs beyond listed) (known loops fits) f chain)))
    (polygons ds hs beyond listed) (chains listed around) = true /\
  (forall e, In e (loop_edges loops) -> exists k, beside true (sides_at (by_edge (named ds hs beyond listed around)) k) e = true) /\
  (forall e, In e fits -> exists k, let sides := sides_at (by_edge (named ds hs beyond listed around)) k in
    (if same (fst e) (snd e) then on_side sides e else beside true sides e && beside false sides e) = true).
Proof.
  unfold Sums.boundary. cbv zeta. intro H.
  repeat match type of H with _ && _ = true => let X := fresh "X" in apply andb_prop in H as (H & X) end.
  apply andb_prop in X as (XC & X). apply andb_prop in X as (XB & XF). rewrite forallb_forall in H, X1, X2. repeat split.
  - intros e I. apply same_not, H, I.
  - exact X5.
  - exact X4.
  - exact X3.
  - specialize (X2 f H0). rewrite forallb_forall in X2. specialize (X2 e H1). apply andb_prop in X2 as (A & _). apply Z.leb_le, A.
  - specialize (X2 f H0). rewrite forallb_forall in X2. specialize (X2 e H1). apply andb_prop in X2 as (_ & A). apply Z.leb_le, A.
  - exact X1.
  - exact XC.
  - exact (all_sided_spec _ _ _ _ XB).
  - exact (all_sided_spec _ _ _ _ XF).
Qed.
