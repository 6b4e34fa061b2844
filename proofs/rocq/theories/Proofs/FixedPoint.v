(* Theorem 7.6: the targets are a fixed point, and the sum is constant only there. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.Ordering Proofs.UpperBound.
From Cordon Require Import Proofs.NonDecreasing Proofs.Increasing.
Local Open Scope R_scope.

Lemma at_targets_line : forall p (x : DroneMap R), (2 <= count x)%nat ->
  (at_targets p x <->
   forall i, (i < count x)%nat -> get x i = line (p_min p) (p_max p) (count x - 1) i).
Proof. intros p x Hx; apply at_targets_iff; lia. Qed.

Lemma exec_coverage_at_targets : forall p (s : State R), (3 <= count (drones s))%nat ->
  at_targets p (drones s) -> drones (exec_coverage p s) = drones s.
Proof.
  intros p s Hn Ht.
  pose proof (proj1 (at_targets_line p (drones s) ltac:(lia)) Ht) as H.
  assert (Ha : anchored p (drones s)).
  { split; rewrite H by lia; [apply line_first|apply line_last; lia]. }
  pose proof (exec_coverage_step p s Hn Ha) as [S0 SL Si].
  apply (map_ext_get _ real_scalar); rewrite count_exec_coverage; [reflexivity|].
  intros i Hi.
  destruct (Nat.eq_dec i (count (drones s) - 1)) as [->|E]; [exact SL|].
  destruct i as [|i]; [exact S0|].
  rewrite Si, !H by lia.
  pose proof (line_middle (p_min p) (p_max p) (count (drones s) - 1) i); nra.
Qed.

(* 7.6 (i), for every weight: at the targets no drone moves any more. *)
Theorem targets_fixed_sharp : forall p (s : State R), (3 <= count (drones s))%nat ->
  forall k, at_targets p (drones (protocol_step p s k)) ->
  forall h, drones (protocol_step p s (k + h)) = drones (protocol_step p s k).
Proof.
  intros p s Hn k Ht h; induction h as [|h IH]; [rewrite Nat.add_0_r; reflexivity|].
  rewrite Nat.add_succ_r; simpl protocol_step.
  rewrite exec_coverage_at_targets; [exact IH| |rewrite IH; exact Ht].
  rewrite count_protocol_step; exact Hn.
Qed.

(* 7.6 (i) as printed, and 7.5 (ii): the sum stays. *)
Corollary targets_fixed_sum : forall p (s : State R), (3 <= count (drones s))%nat ->
  forall k, at_targets p (drones (protocol_step p s k)) -> forall h, c p s (k + h) = c p s k.
Proof.
  intros p s Hn k Ht h; unfold c; rewrite targets_fixed_sharp by assumption; reflexivity.
Qed.

Corollary sum_stationary_sharp : forall p (s : State R), (3 <= count (drones s))%nat ->
  forall k, at_targets p (drones (protocol_step p s k)) -> c p s (k + 1) = c p s k.
Proof. intros p s Hn k Ht; apply targets_fixed_sum; assumption. Qed.

(* 7.6 (ii), sharp and bounded: ceil((N-2)/2) equal sums are enough. *)
Theorem constant_sum_bounded : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 < p_eps p <= 1/2 ->
  upper_bounded p (drones s) -> forall k,
  (forall h, (1 <= h <= (count (drones s) - 2 + 1) / 2)%nat -> c p s (k + h) = c p s k) ->
  at_targets p (drones (protocol_step p s k)).
Proof.
  intros p s Hn Ha He Hu k Hc; intros i Hi.
  destruct (at_target_dec p (drones (protocol_step p s k)) i) as [T|T]; [exact T|exfalso].
  destruct (increasing_within p s Hn Ha He Hu k) as [h [Hh [Hq Hlt]]].
  - intros All; apply T, All; exact Hi.
  - rewrite (Hq h) in Hlt by lia.
    replace (k + h + 1)%nat with (k + (h + 1))%nat in Hlt by lia.
    rewrite Hc in Hlt by lia; lra.
Qed.

(* 7.6 (ii), sharp. *)
Corollary constant_sum_sharp : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 < p_eps p <= 1/2 ->
  upper_bounded p (drones s) -> forall k,
  (forall h, (1 <= h)%nat -> c p s (k + h) = c p s k) ->
  at_targets p (drones (protocol_step p s k)).
Proof.
  intros p s Hn Ha He Hu k Hc; apply constant_sum_bounded; auto.
  intros h Hh; apply Hc; lia.
Qed.

(* 7.6 (ii) under the paper's hypotheses, with eps = 0 excluded. *)
Corollary constant_sum_paper : forall p (s : State R),
  (3 <= count (drones s))%nat -> p_min p < p_max p -> anchored p (drones s) ->
  0 < p_eps p < 1/3 -> in_first_subsegment p (drones s) -> forall k,
  (forall h, (1 <= h)%nat -> c p s (k + h) = c p s k) ->
  at_targets p (drones (protocol_step p s k)).
Proof.
  intros p s Hn Hseg Ha He Hf; apply constant_sum_sharp; auto; [lra|].
  apply first_subsegment_upper_bounded; auto; lra.
Qed.

(* ---- eps = 0, which the paper's definition 6 allows ---- *)

Lemma exec_coverage_zero : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> p_eps p = 0 ->
  drones (exec_coverage p s) = drones s.
Proof.
  intros p s Hn Ha He.
  pose proof (exec_coverage_step p s Hn Ha) as [S0 SL Si].
  apply (map_ext_get _ real_scalar); rewrite count_exec_coverage; [reflexivity|].
  intros i Hi.
  destruct (Nat.eq_dec i (count (drones s) - 1)) as [->|E]; [exact SL|].
  destruct i as [|i]; [exact S0|].
  rewrite Si, He by lia; ring.
Qed.

Lemma protocol_step_zero : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> p_eps p = 0 ->
  forall k, drones (protocol_step p s k) = drones s.
Proof.
  intros p s Hn Ha He k; induction k as [|k IH]; [reflexivity|].
  simpl protocol_step.
  rewrite exec_coverage_zero; rewrite ?IH; auto.
Qed.

(* With eps = 0 nothing moves: for every N >= 3, on every segment, an ordered UB
   start whose sum is constant for ever is not at its targets.  So 7.6 (ii) is
   false there, and with it 7.7 and 7.8. *)
Theorem constant_sum_zero_weight : forall p N,
  (3 <= N)%nat -> p_min p < p_max p -> p_eps p = 0 ->
  exists s : State R,
    count (drones s) = N /\ anchored p (drones s) /\ ordered (drones s) /\
    upper_bounded p (drones s) /\ (forall k, c p s k = c p s 0) /\
    ~ at_targets p (drones s).
Proof.
  intros p N Hn Hseg He.
  (* The start of upper_bound_exact does; it is taken from there with a weight
     for which that theorem speaks. *)
  set (p' := mkParams (p_min p) (p_max p) 1 (p_n p)).
  destruct (upper_bound_exact p' N Hn) as [s [Hc [Ha [Ho [Hu Hnot]]]]];
    [exact Hseg|simpl; lra|].
  exists s; split; [exact Hc|split; [exact Ha|split; [exact Ho|split; [exact Hu|split]]]].
  - intros k; unfold c; rewrite !protocol_step_zero; auto; lia.
  - intros Ht; apply Hnot.
    assert (E : drones (exec_coverage p' s) = drones s)
      by (apply exec_coverage_at_targets; [lia|exact Ht]).
    rewrite E; exact Hu.
Qed.
