(* Any subset of the drones may skip any update: ordering and bounds still hold. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Activation Spec.Theorems.Hypothesis Spec.Theorems.UpperBound.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.Ordering Proofs.UpperBound.
Local Open Scope R_scope.

(* k steps; step j lets the drones of `schedule j` update. *)
Fixpoint active_step {T : Type} `{Scalar T} (p : Params T) (schedule : nat -> nat -> bool)
    (start : State T) (k : nat) : State T :=
  match k with
  | O => start
  | S k' => exec_coverage_active p (active_step p schedule start k') (schedule k')
  end.

Lemma count_active : forall p (s : State R) active,
  count (drones (exec_coverage_active p s active)) = count (drones s).
Proof. intros; apply count_lambda. Qed.

Lemma count_active_step : forall p schedule (s : State R) k,
  count (drones (active_step p schedule s k)) = count (drones s).
Proof.
  intros p schedule s k; induction k as [|k IH]; [reflexivity|].
  simpl active_step; rewrite count_active; exact IH.
Qed.

(* A drone that skips is one that moves with weight 0. *)
Definition active_weight (e : R) (active : nat -> bool) (i : nat) : R :=
  if active i then e else 0.

Lemma active_weighted : forall p (s : State R) active,
  (3 <= count (drones s))%nat -> anchored p (drones s) ->
  weighted (count (drones s) - 1) (active_weight (p_eps p) active)
    (get (drones s)) (get (drones (exec_coverage_active p s active))).
Proof.
  intros p s active Hn [H0 HL]; unfold exec_coverage_active, getx; cbn [drones]; split.
  - rewrite get_lambda by lia; destruct (active 0%nat); [rewrite H0; reflexivity|reflexivity].
  - rewrite get_lambda by lia; destruct (active (count (drones s) - 1)%nat); [|reflexivity].
    rewrite HL; apply update_last; lia.
  - intros i Hi; rewrite get_lambda by lia; unfold active_weight.
    destruct (active (S i)); [|ring].
    replace (S (S i)) with (i + 2)%nat by lia; replace (S i) with (i + 1)%nat by lia.
    rewrite update_inner by lia; unfold getx; ring.
Qed.

Lemma anchored_active : forall p schedule (s : State R) k,
  (3 <= count (drones s))%nat -> anchored p (drones s) ->
  anchored p (drones (active_step p schedule s k)).
Proof.
  intros p schedule s k Hn Ha; induction k as [|k IH]; [exact Ha|].
  simpl active_step.
  destruct (active_weighted p (active_step p schedule s k) (schedule k)) as [W0 WL _];
    [rewrite count_active_step; exact Hn|exact IH|].
  unfold anchored; rewrite count_active, W0, WL; exact IH.
Qed.

Lemma active_run : forall p schedule (s : State R) k,
  (3 <= count (drones s))%nat -> anchored p (drones s) ->
  weighted (count (drones s) - 1) (active_weight (p_eps p) (schedule k))
    (get (drones (active_step p schedule s k))) (get (drones (active_step p schedule s (S k)))).
Proof.
  intros p schedule s k Hn Ha; rewrite <- (count_active_step p schedule s k).
  apply active_weighted; [rewrite count_active_step; exact Hn|].
  apply anchored_active; assumption.
Qed.

Lemma active_weight_range : forall e active i, 0 <= e <= 1/2 -> 0 <= active_weight e active i <= 1/2.
Proof. intros e active i He; unfold active_weight; destruct (active i); lra. Qed.

(* Ordering survives any activation schedule. *)
Theorem ordering_active : forall p schedule (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  ordered (drones s) -> forall k, ordered (drones (active_step p schedule s k)).
Proof.
  intros p schedule s Hn Ha He Ho k; induction k as [|k IH]; [exact Ho|].
  apply ordered_iff; rewrite count_active_step; [lia|].
  apply ordering_weighted with (2 := active_run p schedule s k Hn Ha).
  - lia.
  - intros i _; pose proof (active_weight_range (p_eps p) (schedule k) i He); lra.
  - intros i _ _; pose proof (active_weight_range (p_eps p) (schedule k) i He).
    pose proof (active_weight_range (p_eps p) (schedule k) (S i) He); lra.
  - apply ordered_iff in IH; rewrite count_active_step in *; [exact IH|lia].
Qed.

Lemma below_active : forall p schedule (s : State R) b,
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  concave (count (drones s) - 1) b -> below (count (drones s) - 1) (get (drones s)) b ->
  forall k, below (count (drones s) - 1) (get (drones (active_step p schedule s k))) b.
Proof.
  intros p schedule s b Hn Ha He Hb H0 k; induction k as [|k IH]; [exact H0|].
  apply below_weighted with (1 := active_run p schedule s k Hn Ha); auto.
  intros i _; apply active_weight_range; exact He.
Qed.

Lemma above_active : forall p schedule (s : State R) b,
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  concave (count (drones s) - 1) b ->
  below (count (drones s) - 1) (fun i => - get (drones s) i) b ->
  forall k, below (count (drones s) - 1) (fun i => - get (drones (active_step p schedule s k)) i) b.
Proof.
  intros p schedule s b Hn Ha He Hb H0 k; induction k as [|k IH]; [exact H0|].
  apply below_weighted with (1 := weighted_opp _ _ _ _ (active_run p schedule s k Hn Ha)); auto.
  intros i _; apply active_weight_range; exact He.
Qed.

Theorem upper_bound_active : forall p schedule (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  upper_bounded p (drones s) -> forall k, upper_bounded p (drones (active_step p schedule s k)).
Proof.
  intros p schedule s Hn Ha He Hu k.
  apply upper_bounded_below; rewrite count_active_step; [lia|].
  apply below_active; auto; [apply concave_line|apply upper_bounded_below; [lia|exact Hu]].
Qed.

Theorem lower_bound_active : forall p schedule (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  above_targets p (drones s) -> forall k, above_targets p (drones (active_step p schedule s k)).
Proof.
  intros p schedule s Hn Ha He Hu k.
  apply above_targets_below; rewrite count_active_step; [lia|].
  apply above_active; auto; [apply concave_opp_line|apply above_targets_below; [lia|exact Hu]].
Qed.

Theorem box_active : forall p schedule (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  in_box p (drones s) -> forall k, in_box p (drones (active_step p schedule s k)).
Proof.
  intros p schedule s Hn Ha He Hb k i Hi; rewrite count_active_step in Hi; simpl; split.
  - apply Ropp_le_cancel.
    apply (above_active p schedule s (fun _ => - p_min p)); auto; [apply concave_const| |lia].
    intros j Hj; apply Ropp_le_contravar, Hb; lia.
  - apply (below_active p schedule s (fun _ => p_max p)); auto; [apply concave_const| |lia].
    intros j Hj; apply Hb; lia.
Qed.
