(* Convex pieces: one pass over the vertices proves that all triples of vertices, in order, turn left. *)
Require Import ZArith Lia List Bool.
From Exactsweep Require Import Cancel Pieces.
Import ListNotations.
Open Scope Z_scope.

(* Each vertex c turns left after its predecessors a and b, and follows b and the edge from p to q as seen from p. *)
Fixpoint goes_left (p q a b : pt) (l : list pt) : bool :=
  match l with
  | [] => true
  | c :: m => (0 <? det a b c) && (0 <? det p b c) && (0 <? det p q c) && goes_left p q b c m
  end.
Definition is_convex (r : ring) : bool := match r with p :: q :: s :: l => goes_left p q p q (s :: l) | _ => false end.

Notation pairs := ForallOrdPairs.
Fixpoint triples (l : list pt) : Prop :=
  match l with [] => True | a :: m => pairs (fun b c => 0 < det a b c) m /\ triples m end.

Lemma pairs_snoc {A} (R : A -> A -> Prop) l b : pairs R (l ++ [b]) <-> pairs R l /\ Forall (fun a => R a b) l.
Proof.
  induction l as [|a l IH]; cbn [app].
  - split; [intro; split; constructor|intro; repeat constructor].
  - split.
    + intro H. inversion H as [|x y F P]; subst. apply IH in P as (P & Q). apply Forall_app in F as (F & G). inversion G; subst.
      split; constructor; assumption.
    + intros (H & G). inversion H as [|x y F P]; subst. inversion G; subst. constructor; [apply Forall_app; split; [assumption|repeat constructor; assumption]|].
      apply IH. split; assumption.
Qed.
Lemma triples_snoc l c : triples l -> pairs (fun a b => 0 < det a b c) l -> triples (l ++ [c]).
Proof.
  induction l as [|a l IH]; intros T P; cbn [app triples] in *; [split; constructor|].
  inversion P as [|x y F P']; subst. destruct T as (T1 & T2). split; [apply pairs_snoc; split; assumption|exact (IH T2 P')].
Qed.
Lemma product_pos x y s : 0 < x -> x * y = s -> 0 < s -> 0 < y.
Proof. nia. Qed.

Section Step.
Variables (p q a b c : pt) (m : list pt).
Hypothesis First : exists l, m = q :: l.
Hypothesis Last : exists l, m = l ++ [a].
Hypothesis Seen : pairs (fun x y => 0 < det p x y) (m ++ [b]).
Hypothesis Before : pairs (fun x y => 0 < det x y b) m.
Hypothesis Turn : 0 < det a b c.
Hypothesis After : 0 < det p b c.
Hypothesis Left : 0 < det p q c.
Lemma seen_next : Forall (fun y => 0 < det p y c) (m ++ [b]).
Proof.
  apply Forall_app. split; [|repeat constructor; exact After]. apply pairs_snoc in Seen as (S & B).
  destruct First as (l & ->). inversion S as [|x y F _]; subst. inversion B as [|x y Bq Bl]; subst. constructor; [exact Left|].
  rewrite Forall_forall in *. intros y I. specialize (F y I). specialize (Bl y I).
  apply (product_pos (det p q b) _ (det p q y * det p b c + det p q c * det p y b)); [exact Bq|unfold det; ring|nia].
Qed.
Lemma turns_next : Forall (fun x => 0 < det x b c) m.
Proof.
  pose proof Seen as S. apply pairs_snoc in S as (_ & B). destruct Last as (l & ->). apply pairs_snoc in Before as (_ & Bl).
  apply Forall_app in B as (Bx & Ba). inversion Ba as [|y z Pab _]; subst. apply Forall_app. split; [|repeat constructor; exact Turn].
  rewrite Forall_forall in *. intros x I. specialize (Bl x I). specialize (Bx x I).
  apply (product_pos (det p a b) _ (det p b c * det x a b + det p x b * det a b c)); [exact Pab|unfold det; ring|nia].
Qed.
Lemma pairs_next : pairs (fun x y => 0 < det x y c) (m ++ [b]).
Proof.
  apply pairs_snoc. split; [|exact turns_next]. pose proof seen_next as C. apply Forall_app in C as (C & _). pose proof turns_next as T.
  pose proof Seen as S. apply pairs_snoc in S as (S & B). clear First Last Seen. revert S B C T Before. generalize m. clear Turn After Left. intro l.
  induction l as [|x l IH]; intros S B C T F; [constructor|].
  inversion S as [|? ? S1 S2]; subst. inversion B as [|? ? B1 B2]; subst. inversion C as [|? ? C1 C2]; subst. inversion T as [|? ? T1 T2]; subst.
  inversion F as [|? ? F1 F2]; subst. constructor; [|apply IH; assumption]. rewrite Forall_forall in *. intros y I.
  specialize (S1 y I). specialize (B2 y I). specialize (C2 y I). specialize (T2 y I). specialize (F1 y I).
  apply (product_pos (det p y b) _ (det p y c * det x y b + det p x y * det y b c)); [exact B2|unfold det; ring|nia].
Qed.
End Step.

Lemma goes_left_triples p q : forall l a b m, (exists k, m = q :: k) -> (exists k, m = k ++ [a]) ->
  pairs (fun x y => 0 < det p x y) (m ++ [b]) -> pairs (fun x y => 0 < det x y b) m -> triples m -> goes_left p q a b l = true ->
  triples (p :: m ++ b :: l).
Proof.
  induction l as [|c l IH]; intros a b m (k & Fk) La S B T H.
  - split; [exact S|apply triples_snoc; assumption].
  - cbn [goes_left] in H. apply andb_prop in H as (H & R). apply andb_prop in H as (H & H3). apply andb_prop in H as (H1 & H2).
    apply Z.ltb_lt in H1, H2, H3. assert (E : m ++ b :: c :: l = (m ++ [b]) ++ c :: l) by (rewrite <- app_assoc; reflexivity). rewrite E.
    apply (IH b c (m ++ [b])); [exists (k ++ [b]); rewrite Fk; reflexivity|exists m; reflexivity| | | |exact R].
    + apply pairs_snoc. split; [exact S|]. apply (seen_next p q a b c m); first [assumption|exists k; exact Fk].
    + apply (pairs_next p q a b c m); first [assumption|exists k; exact Fk].
    + apply triples_snoc; assumption.
Qed.
Theorem is_convex_triples r : is_convex r = true -> triples r.
Proof.
  destruct r as [|p [|q [|s l]]]; try discriminate. unfold is_convex. intro H. cbn [goes_left] in H.
  apply andb_prop in H as (H & R). apply andb_prop in H as (H & _). apply andb_prop in H as (H & _). apply Z.ltb_lt in H.
  apply (goes_left_triples p q l q s [q]); [exists []; reflexivity|exists []; reflexivity| | |split; constructor|exact R].
  - constructor; [constructor; [exact H|constructor]|]. constructor; [constructor|constructor].
  - constructor; constructor.
Qed.

(* By position *)
Lemma pairs_nth {A} (R : A -> A -> Prop) l d : pairs R l -> forall i j, (i < j < length l)%nat -> R (nth i l d) (nth j l d).
Proof.
  intro H. induction H as [|a l F P IH]; intros i j L; cbn [length] in L; [lia|]. destruct j as [|j]; [lia|]. destruct i as [|i]; cbn [nth].
  - rewrite Forall_forall in F. apply F, nth_In. lia.
  - apply IH. lia.
Qed.
Lemma triples_nth l d : triples l -> forall i j k, (i < j)%nat -> (j < k < length l)%nat -> 0 < det (nth i l d) (nth j l d) (nth k l d).
Proof.
  induction l as [|a l IH]; intros T i j k L M; cbn [length] in M; [lia|]. destruct T as (T1 & T2). destruct j as [|j]; [lia|]. destruct k as [|k]; [lia|].
  destruct i as [|i]; cbn [nth]; [apply (pairs_nth _ l d T1)|apply IH; [exact T2| |]]; lia.
Qed.
Lemma edges_nth p t e : In e (edges (p :: t)) <-> exists i, (i < length (p :: t))%nat /\ e = (nth i (p :: t) p, nth (S i) (p :: t) p).
Proof.
  unfold edges. assert (L : length (p :: t) = length (t ++ [p])) by (rewrite app_length; cbn [length]; lia).
  assert (E : forall i, nth i (t ++ [p]) p = nth (S i) (p :: t) p).
  { intro i. cbn [nth]. destruct (Nat.lt_ge_cases i (length t)) as [K|K]; [apply app_nth1, K|]. rewrite app_nth2, (nth_overflow t) by exact K.
    destruct (i - length t)%nat as [|[|n]]; reflexivity. }
  split.
  - intro I. apply (In_nth _ _ (p, p)) in I as (i & Li & <-). exists i. rewrite combine_length, <- L, Nat.min_id in Li. split; [exact Li|].
    rewrite combine_nth by exact L. rewrite E. reflexivity.
  - intros (i & Li & ->). rewrite <- E, <- combine_nth by exact L. apply nth_In. rewrite combine_length, <- L, Nat.min_id. exact Li.
Qed.

Section Convex.
Variables (p : pt) (t : list pt).
Let r := p :: t.
Hypothesis Convex : is_convex r = true.
Let v (i : nat) : pt := nth i r p.
Lemma at_least_three : (3 <= length r)%nat.
Proof. unfold r in *. destruct t as [|q [|s l]]; try discriminate. cbn [length]. lia. Qed.
Lemma left_turn i j k : (i < j)%nat -> (j < k < length r)%nat -> 0 < det (v i) (v j) (v k).
Proof. apply triples_nth, is_convex_triples, Convex. Qed.
Lemma last_vertex : v (length r) = p.
Proof. unfold v. apply nth_overflow. lia. Qed.
Lemma det_turn a b c : det a b c = det b c a.
Proof. unfold det. ring. Qed.
Lemma det_same a b : det a b a = 0 /\ det a b b = 0.
Proof. unfold det. lia. Qed.
(* All vertices except the ends of an edge are on its left. *)
Lemma left_of_edge i j : (i < length r)%nat -> (j < length r)%nat -> j <> i -> (j <> S i) -> (S i = length r -> j <> 0%nat) -> 0 < det (v i) (v (S i)) (v j).
Proof.
  intros I J N N' M. destruct (Nat.eq_dec (S i) (length r)) as [E|E].
  - rewrite E, last_vertex. change p with (v 0). rewrite det_turn. apply left_turn; lia.
  - destruct (Nat.lt_ge_cases j i) as [L|L]; [rewrite <- det_turn; apply left_turn; lia|apply left_turn; lia].
Qed.
Lemma end_or_left i j : (i < length r)%nat -> (j < length r)%nat -> v j = v i \/ v j = v (S i) \/ 0 < det (v i) (v (S i)) (v j).
Proof.
  intros I J. destruct (Nat.eq_dec j i) as [->|N]; [auto|]. destruct (Nat.eq_dec j (S i)) as [->|N']; [auto|].
  destruct (Nat.eq_dec (S i) (length r)) as [E|E]; [|right; right; apply left_of_edge; auto; lia].
  destruct (Nat.eq_dec j 0) as [->|Z]; [right; left; rewrite E, last_vertex; reflexivity|right; right; apply left_of_edge; auto].
Qed.
Lemma in_vertex x : In x r -> exists j, (j < length r)%nat /\ x = v j.
Proof. intro I. apply (In_nth _ _ p) in I as (j & J & E). exists j. split; [exact J|symmetry; exact E]. Qed.
Lemma vertex_in j : (j < length r)%nat -> In (v j) r.
Proof. apply nth_In. Qed.
Lemma in_edge e : In e (edges r) -> exists i, (i < length r)%nat /\ e = (v i, v (S i)).
Proof. apply edges_nth. Qed.
Lemma edge_in i : (i < length r)%nat -> In (v i, v (S i)) (edges r).
Proof. intro I. apply edges_nth. exists i. split; [exact I|reflexivity]. Qed.

Lemma edge_left e x : In e (edges r) -> In x r -> x = fst e \/ x = snd e \/ 0 < det (fst e) (snd e) x.
Proof. intros E X. apply in_edge in E as (i & I & ->). apply in_vertex in X as (j & J & ->). exact (end_or_left i j I J). Qed.
Lemma edge_left_weak e x : In e (edges r) -> In x r -> 0 <= det (fst e) (snd e) x.
Proof.
  intros E X. pose proof (det_same (fst e) (snd e)) as (S1 & S2). destruct (edge_left e x E X) as [->|[->|L]]; lia.
Qed.
Lemma third_vertex i : (i < length r)%nat -> exists j, (j < 3)%nat /\ 0 < det (v i) (v (S i)) (v j).
Proof.
  intro I. pose proof at_least_three as T.
  assert (H : exists j, (j < 3)%nat /\ j <> i /\ j <> S i /\ (S i = length r -> j <> 0%nat)).
  { destruct i as [|[|i]]; [exists 2%nat|exists 0%nat|exists 1%nat]; lia. }
  destruct H as (j & J & A & B & C). exists j. split; [exact J|]. apply left_of_edge; auto; lia.
Qed.
Lemma edge_proper e : In e (edges r) -> exists x, In x r /\ 0 < det (fst e) (snd e) x.
Proof.
  intro E. apply in_edge in E as (i & I & ->). destruct (third_vertex i I) as (j & J & L). pose proof at_least_three.
  exists (v j). split; [apply vertex_in; lia|exact L].
Qed.
(* One end of an edge is on the left of another edge, unless the edges are equal. *)
Lemma edges_differ e f : In e (edges r) -> In f (edges r) -> f = e \/ 0 < det (fst e) (snd e) (fst f) \/ 0 < det (fst e) (snd e) (snd f).
Proof.
  intros E F. assert (Ends : In (fst f) r /\ In (snd f) r).
  { pose proof F as G. apply in_edge in G as (i & I & ->). cbn [fst snd]. split; [apply vertex_in, I|].
    destruct (Nat.eq_dec (S i) (length r)) as [L|L]; [rewrite L, last_vertex; left; reflexivity|apply vertex_in; lia]. }
  destruct Ends as (F1 & F2). destruct (edge_proper f F) as (x & X & P). pose proof (edge_left_weak e x E X) as W.
  destruct e as (a, b), f as (c, d). cbn [fst snd] in *. destruct (edge_left (a, b) c E F1) as [A|[A|A]]; cbn [fst snd] in A; [| |auto];
    (destruct (edge_left (a, b) d E F2) as [B|[B|B]]; cbn [fst snd] in B; [| |auto]); subst; try (left; reflexivity); exfalso; revert P W; unfold det; nia.
Qed.
Lemma previous e : In e (edges r) -> exists g, In g (edges r) /\ snd g = fst e /\ 0 < det (fst g) (snd g) (snd e).
Proof.
  intro E. apply in_edge in E as (i & I & ->). pose proof at_least_three as T. destruct i as [|i].
  - assert (L : S (length r - 1) = length r) by lia. exists (v (length r - 1), v (S (length r - 1))). split; [apply edge_in; lia|]. cbn [fst snd].
    rewrite L, last_vertex. split; [reflexivity|]. change p with (v 0). rewrite det_turn. apply left_turn; lia.
  - exists (v i, v (S i)). split; [apply edge_in; lia|]. split; [reflexivity|]. cbn [fst snd]. destruct (Nat.eq_dec (S (S i)) (length r)) as [L|L].
    + rewrite L, last_vertex. change p with (v 0). rewrite <- det_turn. apply left_turn; lia.
    + apply left_turn; lia.
Qed.
Lemma following e : In e (edges r) -> exists g, In g (edges r) /\ fst g = snd e /\ 0 < det (fst g) (snd g) (fst e).
Proof.
  intro E. apply in_edge in E as (i & I & ->). pose proof at_least_three as T. cbn [fst snd]. destruct (Nat.eq_dec (S i) (length r)) as [L|L].
  - exists (v 0, v 1). split; [apply edge_in; lia|]. cbn [fst snd]. rewrite L, last_vertex. split; [reflexivity|]. apply left_turn; lia.
  - exists (v (S i), v (S (S i))). split; [apply edge_in; lia|]. split; [reflexivity|]. cbn [fst snd]. rewrite <- det_turn.
    destruct (Nat.eq_dec (S (S i)) (length r)) as [M|M]; [|apply left_turn; lia]. rewrite M, last_vertex, <- det_turn. change p with (v 0). apply left_turn; lia.
Qed.
Lemma convex_fan : is_fan r = true.
Proof.
  pose proof (is_convex_triples r Convex) as T. unfold r in *. destruct t as [|q [|s l]]; try discriminate. destruct T as (T & _). cbn [is_fan].
  revert T. generalize (s :: l). clear. intro l. revert q. induction l as [|x l IH]; intros q T; [reflexivity|].
  inversion T as [|a b F P]; subst. inversion F as [|a b F1 F2]; subst. cbn [sorted]. rewrite !andb_true_iff. split; [split|].
  - apply Z.ltb_lt, F1.
  - rewrite forallb_forall. rewrite Forall_forall in F2. intros y I. apply Z.leb_le. specialize (F2 y I). lia.
  - apply IH, P.
Qed.
End Convex.
Corollary is_convex_fan r : is_convex r = true -> is_fan r = true.
Proof. destruct r as [|p t]; [discriminate|]. apply convex_fan. Qed.
