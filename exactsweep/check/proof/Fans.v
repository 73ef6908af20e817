(* Pieces with any number of vertices *)
Require Import ZArith Lia List Bool.
From Exactsweep Require Import Cancel Constant.
Import ListNotations.
Open Scope Z_scope.

(* a ring p, q, l...; its edges, and the triangles from p *)
Definition poly := (pt * pt * list pt)%type.
Fixpoint back (p q : pt) (l : list pt) : list edge :=
  match l with [] => [(q, p)] | r :: m => (q, r) :: back p r m end.
Definition sides (o : poly) : list edge := let '(p, q, l) := o in (p, q) :: back p q l.
Fixpoint fan_from (p q : pt) (l : list pt) : list tri :=
  match l with [] => [] | r :: m => (p, q, r) :: fan_from p r m end.
Definition fan (o : poly) : list tri := let '(p, q, l) := o in fan_from p q l.

Lemma wind_fan o z : wind (sides o) z = wind (flat_map edges3 (fan o)) z.
Proof.
  destruct o as [[p q] l]. cbn [sides fan]. revert q. induction l as [|r m IH]; intro q.
  - change (cross (p, q) z + (cross (q, p) z + 0) = 0). rewrite (cross_sym p q). lia.
  - change (cross (p, q) z + (cross (q, r) z + wind (back p r m) z) =
      wind (edges3 (p, q, r) ++ flat_map edges3 (fan_from p r m)) z).
    rewrite wind_app. specialize (IH r).
    change (cross (p, r) z + wind (back p r m) z = wind (flat_map edges3 (fan_from p r m)) z) in IH.
    change (wind (edges3 (p, q, r)) z) with (cross (p, q) z + (cross (q, r) z + (cross (r, p) z + 0))).
    rewrite (cross_sym p r). lia.
Qed.

