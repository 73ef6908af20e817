(* Winding numbers along segments that avoid the loops *)
Require Import ZArith Lia List Bool.
From Exactsweep Require Import Cancel.
Import ListNotations.
Open Scope Z_scope.

Lemma wind_app es fs z : wind (es ++ fs) z = wind es z + wind fs z.
Proof. induction es as [|e r IH]; [reflexivity|]. 
  change (cross e z + wind (r ++ fs) z = cross e z + wind r z + wind fs z). rewrite IH. ring. Qed.

(* W is constant along segments that avoid the loops; this does not need the Jordan curve theorem. `apart`: a line
   strictly separates the edge from the segment. *)
Definition val (s : Z * Z * Z) (p : pt) : Z := let '(a, b, c) := s in a * fst p + b * snd p + c.
Definition apart (e : edge) (x y : pt) : Prop :=
  exists s, 0 < val s (fst e) /\ 0 < val s (snd e) /\ val s x < 0 /\ val s y < 0.

(* 1 for points in the half-open strip of heights of x and y, right of the segment from x up to y *)
Definition beyond (x y p : pt) : Z :=
  if (snd x <? snd p) && (snd p <=? snd y) && (det x y p <? 0) then 1 else 0.

Lemma identity1 p q x y s :
  (snd q - snd p) * (det p q x * val s y - det p q y * val s x) =
  (det p q x * (snd y - snd p) - det p q y * (snd x - snd p)) * val s q +
  (det p q x * (snd q - snd y) - det p q y * (snd q - snd x)) * val s p.
Proof. destruct s as [[a b] c], p, q, x, y. unfold det, val; cbn. ring. Qed.

Lemma identity2 p q x y s :
  let H1 := snd q - snd p in let H2 := snd y - snd x in
  let al := det p q x in let ga := det x y q in
  ga * ((snd q - snd x) * val s p + (snd x - snd p) * val s q) + al * H2 * val s q =
  ga * H1 * val s x + al * ((snd y - snd q) * val s x + (snd q - snd x) * val s y).
Proof. destruct s as [[a b] c], p, q, x, y. unfold det, val; cbn. ring. Qed.

(* both ends of an edge that spans the strip are on one side *)
Lemma spans p q x y : apart (p, q) x y ->
  snd p <= snd x -> snd x <= snd y -> snd y < snd q -> 0 < det p q x -> 0 < det p q y.
Proof.
  intros (s & P & Q & X & Y) A B C D. cbn in *.
  destruct (Z.lt_ge_cases 0 (det p q y)) as [|N]; [assumption|exfalso].
  pose proof (identity1 p q x y s) as I.
  assert (det p q x * val s y < 0) by nia. assert (0 <= det p q y * val s x) by nia.
  assert (0 <= det p q x * (snd y - snd p)) by nia. assert (det p q y * (snd x - snd p) <= 0) by nia.
  assert (0 < det p q x * (snd q - snd y)) by nia. assert (det p q y * (snd q - snd x) <= 0) by nia.
  nia.
Qed.
Lemma spans' p q x y : apart (p, q) x y ->
  snd p <= snd x -> snd x <= snd y -> snd y < snd q -> 0 < det p q y -> 0 < det p q x.
Proof.
  intros (s & P & Q & X & Y) A B C D. cbn in *.
  destruct (Z.lt_ge_cases 0 (det p q x)) as [|N]; [assumption|exfalso].
  pose proof (identity1 p q x y s) as I.
  assert (0 <= det p q x * val s y) by nia. assert (det p q y * val s x < 0) by nia.
  assert (det p q x * (snd y - snd p) <= 0) by nia. assert (0 <= det p q y * (snd x - snd p)) by nia.
  assert (det p q x * (snd q - snd y) <= 0) by nia. assert (0 < det p q y * (snd q - snd x)) by nia.
  nia.
Qed.

Lemma enters p q x y : apart (p, q) x y -> snd p <= snd x -> snd x < snd q -> snd q <= snd y ->
  (0 < det p q x <-> det x y q < 0).
Proof.
  intros (s & P & Q & X & Y) A B C. cbn in *. pose proof (identity2 p q x y s) as I. cbn in I.
  set (sp := val s p) in *. set (sq := val s q) in *. set (sx := val s x) in *. set (sy := val s y) in *.
  set (al := det p q x) in *. set (ga := det x y q) in *. clearbody sp sq sx sy al ga.
  assert (U1 : 0 < (snd q - snd x) * sp) by nia. assert (U2 : 0 <= (snd x - snd p) * sq) by nia.
  assert (V1 : (snd y - snd q) * sx <= 0) by nia. assert (V2 : (snd q - snd x) * sy < 0) by nia.
  assert (W1 : (snd q - snd p) * sx < 0) by nia. assert (W2 : 0 < (snd y - snd x) * sq) by nia.
  replace (al * (snd y - snd x) * sq) with (al * ((snd y - snd x) * sq)) in I by ring.
  replace (ga * (snd q - snd p) * sx) with (ga * ((snd q - snd p) * sx)) in I by ring.
  revert I U1 U2 V1 V2 W1 W2.
  generalize ((snd q - snd x) * sp) ((snd x - snd p) * sq) ((snd y - snd q) * sx) ((snd q - snd x) * sy)
    ((snd q - snd p) * sx) ((snd y - snd x) * sq). intros u1 u2 v1 v2 w1 w2 I U1 U2 V1 V2 W1 W2.
  split; intro D.
  - destruct (Z.lt_ge_cases ga 0) as [|N]; [assumption|exfalso]. nia.
  - destruct (Z.lt_ge_cases 0 al) as [|N]; [assumption|exfalso]. nia.
Qed.

Lemma leaves p q x y : apart (p, q) x y -> snd x < snd p -> snd p <= snd y -> snd y < snd q ->
  (0 < det p q y <-> det x y p < 0).
Proof.
  intros (s & P & Q & X & Y) A B C. cbn in *. pose proof (identity2 q p y x s) as I. cbn in I.
  replace (det q p y) with (- det p q y) in I by (unfold det; ring).
  replace (det y x p) with (- det x y p) in I by (unfold det; ring).
  set (sp := val s p) in *. set (sq := val s q) in *. set (sx := val s x) in *. set (sy := val s y) in *.
  set (al := det p q y) in *. set (ga := det x y p) in *. clearbody sp sq sx sy al ga.
  assert (U1 : 0 < (snd x - snd p) * sy) by nia. assert (U2 : 0 <= (snd p - snd y) * sx) by nia.
  assert (V1 : (snd p - snd y) * sq <= 0) by nia. assert (V2 : (snd y - snd q) * sp < 0) by nia.
  assert (W1 : (snd p - snd q) * sy > 0) by nia. assert (W2 : (snd x - snd y) * sp < 0) by nia.
  replace (- al * (snd x - snd y) * sp) with (- al * ((snd x - snd y) * sp)) in I by ring.
  replace (- ga * (snd p - snd q) * sy) with (- ga * ((snd p - snd q) * sy)) in I by ring.
  revert I U1 U2 V1 V2 W1 W2.
  generalize ((snd x - snd p) * sy) ((snd p - snd y) * sx) ((snd p - snd y) * sq) ((snd y - snd q) * sp)
    ((snd p - snd q) * sy) ((snd x - snd y) * sp). intros u1 u2 v1 v2 w1 w2 I U1 U2 V1 V2 W1 W2.
  split; intro D.
  - destruct (Z.lt_ge_cases ga 0) as [|N]; [assumption|exfalso]. nia.
  - destruct (Z.lt_ge_cases 0 al) as [|N]; [assumption|exfalso]. nia.
Qed.

Lemma within p q x y : apart (p, q) x y ->
  snd x < snd p -> snd p <= snd y -> snd x < snd q -> snd q <= snd y ->
  det x y p < 0 -> det x y q < 0.
Proof.
  intros (s & P & Q & X & Y) A B C D E. cbn in *. pose proof (identity1 x y p q s) as I.
  destruct (Z.lt_ge_cases (det x y q) 0) as [|N]; [assumption|exfalso].
  set (sp := val s p) in *. set (sq := val s q) in *. set (sx := val s x) in *. set (sy := val s y) in *.
  set (al := det x y p) in *. set (ga := det x y q) in *. clearbody sp sq sx sy al ga.
  assert (al * sq - ga * sp < 0) by nia.
  assert ((snd y - snd x) * (al * sq - ga * sp) < 0) by nia.
  assert (al * (snd q - snd x) - ga * (snd p - snd x) < 0) by nia.
  assert (0 < (al * (snd q - snd x) - ga * (snd p - snd x)) * sy) by nia.
  assert (al * (snd y - snd q) - ga * (snd y - snd p) <= 0) by nia.
  assert (0 <= (al * (snd y - snd q) - ga * (snd y - snd p)) * sx) by nia.
  lia.
Qed.

Lemma apart_sym p q x y : apart (p, q) x y -> apart (q, p) x y.
Proof. intros (s & ?). exists s. cbn in *. tauto. Qed.

Lemma cross_sym p q z : cross (q, p) z = - cross (p, q) z.
Proof.
  unfold cross. replace (det q p z) with (- det p q z) by (unfold det; ring).
  generalize (det p q z). intro d.
  destruct (Z.leb_spec (snd p) (snd z)); destruct (Z.leb_spec (snd q) (snd z));
  destruct (Z.ltb_spec (snd z) (snd q)); destruct (Z.ltb_spec (snd z) (snd p));
  destruct (Z.ltb_spec 0 d); destruct (Z.ltb_spec d 0);
  destruct (Z.ltb_spec 0 (- d)); destruct (Z.ltb_spec (- d) 0); cbn; lia.
Qed.

Lemma step_up p q x y : apart (p, q) x y -> snd p <= snd q -> snd x <= snd y ->
  cross (p, q) x - cross (p, q) y = beyond x y q - beyond x y p.
Proof.
  intros A B C. unfold cross, beyond.
  pose proof (spans p q x y A) as S1. pose proof (spans' p q x y A) as S2.
  pose proof (enters p q x y A) as S3. pose proof (leaves p q x y A) as S4.
  pose proof (within p q x y A) as S5. pose proof (within q p x y (apart_sym _ _ _ _ A)) as S6.
  revert S1 S2 S3 S4 S5 S6. generalize (det p q x) (det p q y) (det x y p) (det x y q).
  intros a b c d S1 S2 S3 S4 S5 S6. clear A.
  destruct (Z.leb_spec (snd p) (snd x)); destruct (Z.leb_spec (snd p) (snd y)); try lia;
  destruct (Z.leb_spec (snd q) (snd x)); destruct (Z.leb_spec (snd q) (snd y)); try lia;
  destruct (Z.ltb_spec (snd x) (snd p)); destruct (Z.ltb_spec (snd y) (snd p)); try lia;
  destruct (Z.ltb_spec (snd x) (snd q)); destruct (Z.ltb_spec (snd y) (snd q)); try lia;
  destruct (Z.ltb_spec 0 a); destruct (Z.ltb_spec 0 b);
  destruct (Z.ltb_spec c 0); destruct (Z.ltb_spec d 0); cbn; try reflexivity; try lia; exfalso; lia.
Qed.

Lemma step e x y : apart e x y -> snd x <= snd y ->
  cross e x - cross e y = beyond x y (snd e) - beyond x y (fst e).
Proof.
  destruct e as [p q]. intros A C. cbn [fst snd].
  destruct (Z.le_ge_cases (snd p) (snd q)) as [B|B]; [apply step_up; assumption|].
  pose proof (step_up q p x y (apart_sym _ _ _ _ A) B C) as S. rewrite !(cross_sym q p) . lia.
Qed.

(* in rings, equally many edges start and end at each point *)
Definition ends (es : list edge) : list (key * Z) :=
  flat_map (fun e => [(((0, 0, 0), fst e), 1); (((0, 0, 0), snd e), -1)]) es.
Definition closed (es : list edge) : Prop := forall k, total (ends es) k = 0.

Theorem constant es x y : closed es -> (forall e, In e es -> apart e x y) -> wind es x = wind es y.
Proof.
  assert (G : forall x y, snd x <= snd y -> closed es -> (forall e, In e es -> apart e x y) ->
    wind es x = wind es y).
  { clear x y. intros x y C K A.
    assert (wind es x - wind es y = - weigh (fun k => beyond x y (snd k)) (ends es)) as E.
    { clear K. induction es as [|e r IH]; [reflexivity|].
      change (cross e x + wind r x - (cross e y + wind r y) =
        - (1 * beyond x y (fst e) + (-1 * beyond x y (snd e) + weigh (fun k => beyond x y (snd k)) (ends r)))).
      pose proof (step e x y (A e (or_introl eq_refl)) C).
      assert (wind r x - wind r y = - weigh (fun k => beyond x y (snd k)) (ends r)).
      { apply IH. intros. apply A. right. assumption. }
      lia. }
    rewrite (weigh_zero _ (length (ends es)) (ends es)) in E; [lia|apply le_n|exact K]. }
  intros K A. destruct (Z.le_ge_cases (snd x) (snd y)) as [C|C]; [apply G; assumption|].
  symmetry. apply G; [assumption|assumption|].
  intros e I. destruct (A e I) as (s & ?). exists s. tauto.
Qed.
