(* Overlap, proved by a point strictly inside a convex piece of both shapes. *)
Require Import QArith ZArith List Bool.
From Exactsweep Require Import Cancel Pieces Solid Gaps Scaling.
From Exactsweep Require Statements.
From Exactsweep Require Import HalfOpen Nearby Boundary SumPoints PiecePoints Covers Pairs.
Import ListNotations.

(* `solid_of`: the integer pieces of a shape at the common denominator N. *)
Definition solid_of (N : positive) (rs : list Statements.ring) (ps : list ring) : solid :=
  {| rings := int_rings (Zpos N) rs; pieces := ps |}.
Definition check_witness (N : positive) (hint : ring -> ring -> pt) (A B : list Statements.ring) (ps qs : list ring) (z : qpoint) : bool :=
  all_integral (Zpos N) A && all_integral (Zpos N) B &&
  simple_solid hint (solid_of N A ps) && simple_solid hint (solid_of N B qs) &&
  existsb (fun p => inS_b (Statements.edges (qring N p)) z) ps &&
  existsb (fun q => inS_b (Statements.edges (qring N q)) z) qs.

Theorem witness_sound N hint A B ps qs z : check_witness N hint A B ps qs z = true ->
  Statements.overlap (Statements.inside A) (Statements.inside B).
Proof.
  unfold check_witness. intro H. apply andb_prop in H as (H & Q). apply andb_prop in H as (H & P).
  apply andb_prop in H as (H & SB). apply andb_prop in H as (H & SA). apply andb_prop in H as (IA & IB).
  apply existsb_exists in P as (p & Ip & P). apply existsb_exists in Q as (q & Iq & Q). apply inS_b_spec in P, Q.
  apply (overlap_of_point A B z).
  - apply (count_pieces N hint (solid_of N A ps) A z SA IA eq_refl). exists p. split; [exact Ip|].
    apply strict_inside; [exact (proj1 (proj2 (simple_spec hint _ SA)) p Ip)|exact P].
  - apply (count_pieces N hint (solid_of N B qs) B z SB IB eq_refl). exists q. split; [exact Iq|].
    apply strict_inside; [exact (proj1 (proj2 (simple_spec hint _ SB)) q Iq)|exact Q].
Qed.
