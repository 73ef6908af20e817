(* Trees of boxes: a bound that holds for a box holds for all edges in it, so most edges need no test. *)
Require Import ZArith Lia List Bool.
From Exactsweep Require Import Cancel Pieces Gaps.
Import ListNotations.
Open Scope Z_scope.

(* The minima over a box in the directions of `axes`: right, up, left, down *)
Definition extremes := (Z * Z * Z * Z)%type.
Definition within (b : extremes) (e : edge) : Prop :=
  let '(x, y, u, v) := b in forall p, p = fst e \/ p = snd e -> x <= fst p /\ y <= snd p /\ u <= - fst p /\ v <= - snd p.
Definition frame_edge (e : edge) : extremes :=
  let (p, q) := e in (Z.min (fst p) (fst q), Z.min (snd p) (snd q), Z.min (- fst p) (- fst q), Z.min (- snd p) (- snd q)).
Definition unite (b c : extremes) : extremes :=
  let '(x, y, u, v) := b in let '(x', y', u', v') := c in (Z.min x x', Z.min y y', Z.min u u', Z.min v v').

Inductive tree := Leaf (e : edge) | Node (b : extremes) (t u : tree).
Definition frame_of (t : tree) : extremes := match t with Leaf e => frame_edge e | Node b _ _ => b end.
Definition join (t u : tree) : tree := Node (unite (frame_of t) (frame_of u)) t u.
Fixpoint join_all (ts : list tree) : list tree := match ts with t :: u :: r => join t u :: join_all r | _ => ts end.
Fixpoint join_levels (n : nat) (ts : list tree) : list tree := match n with O => ts | S m => join_levels m (join_all ts) end.
(* Consecutive edges of loops are close to each other, so they share a tree. *)
Definition trees_of (es : list edge) : list tree := join_levels (S (Nat.log2 (length es))) (map Leaf es).

Section Query.
Variables (skips : extremes -> bool) (holds : edge -> bool).
Fixpoint all_in (t : tree) : bool :=
  match t with
  | Leaf e => holds e
  | Node b l r => if skips b then true else if all_in l then all_in r else false
  end.

Fixpoint edges_in (t : tree) : list edge := match t with Leaf e => [e] | Node _ l r => edges_in l ++ edges_in r end.
Fixpoint is_framed (t : tree) : Prop :=
  match t with Leaf _ => True | Node b l r => (forall e, In e (edges_in l ++ edges_in r) -> within b e) /\ is_framed l /\ is_framed r end.
Lemma frame_spec t : is_framed t -> forall e, In e (edges_in t) -> within (frame_of t) e.
Proof.
  destruct t as [f|b l r]; intros F e I; [|apply F, I]. destruct I as [<-|[]]. destruct f as ((x, y), (u, v)). intros p [->| ->]; cbn [fst snd]; lia.
Qed.
Lemma join_framed t u : is_framed t -> is_framed u -> is_framed (join t u).
Proof.
  intros T U. split; [|split; assumption]. intros e I. pose proof (frame_spec t T e) as A. pose proof (frame_spec u U e) as B.
  destruct (frame_of t) as (((x, y), z), w), (frame_of u) as (((x', y'), z'), w'). intros p P.
  apply in_app_or in I as [I|I]; [specialize (A I p P)|specialize (B I p P)]; lia.
Qed.
Lemma join_all_spec : forall n ts, (length ts <= n)%nat -> flat_map edges_in (join_all ts) = flat_map edges_in ts /\
  (Forall is_framed ts -> Forall is_framed (join_all ts)).
Proof.
  induction n as [|n IH]; intros [|t [|u r]] L; try (split; [reflexivity|auto]); cbn [length] in L; try lia.
  destruct (IH r ltac:(lia)) as (E & F). split.
  - cbn [join_all flat_map join edges_in]. rewrite E, app_assoc. reflexivity.
  - intro H. inversion H as [|? ? T H']; subst. inversion H' as [|? ? U R]; subst. constructor; [apply join_framed; assumption|apply F, R].
Qed.
Lemma trees_spec es : flat_map edges_in (trees_of es) = es /\ Forall is_framed (trees_of es).
Proof.
  unfold trees_of. assert (H : forall n ts, Forall is_framed ts -> flat_map edges_in (join_levels n ts) = flat_map edges_in ts /\ Forall is_framed (join_levels n ts)).
  { induction n as [|n IH]; intros ts F; [split; [reflexivity|exact F]|]. cbn [join_levels]. destruct (join_all_spec _ ts (le_n _)) as (E & G).
    destruct (IH _ (G F)) as (E' & F'). rewrite E', E. split; [reflexivity|exact F']. }
  destruct (H (S (Nat.log2 (length es))) (map Leaf es)) as (E & F); [apply Forall_forall; intros t I; apply in_map_iff in I as (e & <- & _); exact I|].
  split; [|exact F]. rewrite E. clear. induction es as [|e r IH]; [reflexivity|]. cbn [map flat_map edges_in app]. rewrite IH. reflexivity.
Qed.
Lemma all_in_spec t : is_framed t -> all_in t = true -> forall e, In e (edges_in t) -> holds e = true \/ exists b, skips b = true /\ within b e.
Proof.
  induction t as [f|b l IL r IR]; intros F H e I.
  - destruct I as [<-|[]]. left. exact H.
  - cbn [all_in] in H. destruct F as (B & FL & FR). destruct (skips b) eqn:S; [right; exists b; split; [exact S|apply B, I]|].
    destruct (all_in l) eqn:L; [|discriminate]. apply in_app_or in I as [I|I]; [exact (IL FL eq_refl e I)|exact (IR FR H e I)].
Qed.
Theorem trees_all es : forallb all_in (trees_of es) = true -> forall e, In e es -> holds e = true \/ exists b, skips b = true /\ within b e.
Proof.
  intros H e I. destruct (trees_spec es) as (E & F). rewrite <- E in I. apply in_flat_map in I as (t & T & I).
  rewrite forallb_forall in H. rewrite Forall_forall in F. exact (all_in_spec t (F t T) (H t T) e I).
Qed.
End Query.
