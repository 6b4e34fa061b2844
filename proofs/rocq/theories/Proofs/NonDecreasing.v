(* Theorem 7.5: the identity, and its two parts. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis Spec.Theorems.NonDecreasing.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.UpperBound Proofs.Sum.
Local Open Scope R_scope.

(* Second differences telescope. *)
Lemma telescope : forall M e x y, step M e x y -> forall m, (m < M)%nat ->
  sumn y (S m) - sumn x (S m) = e * ((x (S m) - x m) - (x 1%nat - x 0%nat)).
Proof.
  intros M e x y [H0 HL Hi] m; induction m as [|m IH]; intros Hm.
  - simpl; rewrite H0; ring.
  - change (sumn y (S (S m))) with (sumn y (S m) + y (S m)).
    change (sumn x (S (S m))) with (sumn x (S m) + x (S m)).
    rewrite (Hi m Hm).
    replace (sumn y (S m)) with (sumn x (S m) + e * ((x (S m) - x m) - (x 1%nat - x 0%nat)))
      by (rewrite <- IH by lia; ring).
    ring.
Qed.

Lemma telescope_all : forall M e x y, (1 <= M)%nat -> step M e x y ->
  sumn y (S M) - sumn x (S M) = e * ((x M - x (M - 1)%nat) - (x 1%nat - x 0%nat)).
Proof.
  intros M e x y HM Hs; pose proof (step_last _ _ _ _ Hs) as HL.
  pose proof (telescope M e x y Hs (M - 1) ltac:(lia)) as Ht.
  replace (S (M - 1)) with M in Ht by lia.
  simpl; rewrite HL; lra.
Qed.

(* The identity behind 7.5, for every weight and every start:
   c^{k+1} - c^k = eps * (g_{N-2} - g_0). *)
Theorem sum_identity : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) ->
  forall k,
  let x := drones (protocol_step p s k) in
  let x' := drones (protocol_step p s (k + 1)) in
  sum x' - sum x = p_eps p * (gap x (count x - 2) - gap x 0).
Proof.
  intros p s Hn Ha k x x'.
  assert (Hx : count x = count (drones s)) by apply count_protocol_step.
  assert (Hx' : count x' = count (drones s)) by apply count_protocol_step.
  pose proof (positions_run p s Hn Ha k) as Hs.
  pose proof (telescope_all (count (drones s) - 1) _ _ _ ltac:(lia) Hs) as Ht.
  rewrite !sum_sumn, Hx, Hx'; unfold gap.
  replace (count (drones s) - 2 + 1)%nat with (count (drones s) - 1)%nat by lia.
  replace (count (drones s) - 1 - 1)%nat with (count (drones s) - 2)%nat in Ht by lia.
  replace (S (count (drones s) - 1)) with (count (drones s)) in Ht by lia.
  unfold x, x'; rewrite Nat.add_1_r; exact Ht.
Qed.

(* The same, as the spec states it: the residual vanishes. *)
Corollary telescoping_residual_zero : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) ->
  telescoping_residual (p_eps p) (drones s) (drones (exec_coverage p s)) = 0.
Proof.
  intros p s Hn Ha; pose proof (sum_identity p s Hn Ha 0) as H; simpl in H.
  unfold telescoping_residual; simpl; rewrite <- H; ring.
Qed.

(* 7.5 (i), sharp. *)
Theorem sum_non_decreasing_sharp : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  upper_bounded p (drones s) ->
  forall k, sum (drones (protocol_step p s k)) <= sum (drones (protocol_step p s (k + 1))).
Proof.
  intros p s Hn Ha He Hu k.
  pose proof (sum_identity p s Hn Ha k) as Hid; cbv zeta in Hid.
  set (x := drones (protocol_step p s k)) in *.
  assert (Hx : count x = count (drones s)) by apply count_protocol_step.
  pose proof (upper_bound_sharp p s Hn Ha He Hu k) as Hux; fold x in Hux.
  pose proof (proj1 (upper_bounded_below p x ltac:(lia)) Hux) as Hb.
  pose proof (anchored_step p s k ltac:(lia) Ha) as [A0 AL]; fold x in A0, AL.
  set (lo := p_min p) in *; set (hi := p_max p) in *.
  set (M := (count x - 1)%nat) in *.
  pose proof (Hb 1%nat ltac:(lia)) as B1.
  pose proof (Hb (M - 1)%nat ltac:(lia)) as BL.
  assert (L0 : line lo hi M 1 = line lo hi M 0 + (hi - lo) / INR M)
    by (unfold line; simpl; ring).
  assert (L1 : line lo hi M (M - 1) = line lo hi M M - (hi - lo) / INR M)
    by (unfold line; rewrite minus_INR by lia; change (INR 1) with 1; ring).
  rewrite line_first in L0; rewrite line_last in L1 by lia.
  assert (0 <= gap x (count x - 2) - gap x 0).
  { unfold gap; replace (count x - 2 + 1)%nat with M by (unfold M; lia).
    replace (count x - 2)%nat with (M - 1)%nat by (unfold M; lia).
    simpl Nat.add; rewrite A0, AL; simpl; lra. }
  assert (0 <= p_eps p * (gap x (count x - 2) - gap x 0)) by (apply Rmult_le_pos; lra).
  lra.
Qed.

(* The sum grows from any step to any later one. *)
Corollary sum_monotone : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  upper_bounded p (drones s) ->
  forall k h, sum (drones (protocol_step p s k)) <= sum (drones (protocol_step p s (k + h))).
Proof.
  intros p s Hn Ha He Hu k h; induction h as [|h IH].
  - rewrite Nat.add_0_r; apply Rle_refl.
  - apply Rle_trans with (1 := IH).
    replace (k + S h)%nat with (k + h + 1)%nat by lia.
    apply sum_non_decreasing_sharp; assumption.
Qed.

(* 7.5 (i) under the paper's hypotheses. *)
Corollary sum_non_decreasing_paper : forall p (s : State R),
  (3 <= count (drones s))%nat -> p_min p < p_max p -> anchored p (drones s) ->
  0 <= p_eps p < 1/2 -> in_first_subsegment p (drones s) ->
  forall k, sum (drones (protocol_step p s k)) <= sum (drones (protocol_step p s (k + 1))).
Proof.
  intros p s Hn Hseg Ha He Hf; apply sum_non_decreasing_sharp; auto; [lra|].
  apply first_subsegment_upper_bounded; auto; lra.
Qed.
