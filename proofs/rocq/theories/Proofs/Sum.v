(* Corollary 7.4: the sum of the positions is bounded, and meets its bound
   exactly when every drone is at its target. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis Spec.Theorems.UpperBound.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.UpperBound.
Local Open Scope R_scope.

(* N*min + N(N-1)/2 * l *)
Definition sum_bound (p : Params R) (N : nat) : R :=
  INR N * p_min p + INR N * (INR N - 1) / 2 * spacing p N.

(* Twice the bound, free of division: N*(min + max). *)
Lemma sum_bound_doubled : forall p N, (1 < N)%nat ->
  2 * sum_bound p N = INR N * (p_min p + p_max p).
Proof.
  intros p N HN; unfold sum_bound, spacing; rewrite minus_INR by lia; change (INR 1) with 1.
  assert (1 < INR N) by (apply (lt_INR 1); lia).
  field; lra.
Qed.

Lemma sumn_affine : forall a b n,
  sumn (fun i => a + INR i * b) n = INR n * a + INR n * (INR n - 1) / 2 * b.
Proof.
  intros a b n; induction n as [|n IH]; [simpl; field|].
  change (sumn (fun i => a + INR i * b) (S n))
    with (sumn (fun i => a + INR i * b) n + (a + INR n * b)).
  rewrite IH, S_INR; field.
Qed.

Lemma sumn_targets : forall p N, sumn (target p N) N = sum_bound p N.
Proof. intros p N; unfold target, sum_bound; apply sumn_affine. Qed.

Lemma sum_below : forall p (x : DroneMap R), (3 <= count x)%nat ->
  upper_bounded p x ->
  sum x <= sum_bound p (count x) /\ (sum x = sum_bound p (count x) <-> at_targets p x).
Proof.
  intros p x Hn Hu; set (N := count x) in *.
  assert (Hu' : forall i, (i < N)%nat -> 0 <= target p N i - get x i).
  { intros i Hi; pose proof (proj1 (upper_bounded_iff p x ltac:(lia)) Hu i Hi) as H.
    fold N in H; lra. }
  assert (Hs : sumn (fun i => target p N i - get x i) N = sum_bound p N - sum x).
  { rewrite sumn_minus, sumn_targets, sum_sumn; reflexivity. }
  split; [pose proof (sumn_nonneg _ N Hu') as H; rewrite Hs in H; lra|split; intros E].
  - apply at_targets_iff; [lia|]; intros i Hi; fold N.
    pose proof (sumn_nonneg_zero _ N Hu' ltac:(rewrite Hs; lra) i Hi) as H; simpl in H; lra.
  - pose proof (proj1 (at_targets_iff p x ltac:(lia)) E) as H; fold N in H.
    rewrite sum_sumn, <- sumn_targets; fold N; apply sumn_ext; exact H.
Qed.

(* 7.4 (i), sharp. *)
Theorem sum_bounded_sharp : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  upper_bounded p (drones s) ->
  forall k, sum (drones (protocol_step p s k)) <= sum_bound p (count (drones s)).
Proof.
  intros p s Hn Ha He Hu k; rewrite <- (count_protocol_step _ _ p s k).
  apply sum_below; [rewrite count_protocol_step; lia|apply upper_bound_sharp; assumption].
Qed.

(* 7.4 (ii), sharp. *)
Theorem sum_maximal_sharp : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  upper_bounded p (drones s) ->
  forall k, sum (drones (protocol_step p s k)) = sum_bound p (count (drones s)) <->
            at_targets p (drones (protocol_step p s k)).
Proof.
  intros p s Hn Ha He Hu k; rewrite <- (count_protocol_step _ _ p s k).
  apply sum_below; [rewrite count_protocol_step; lia|apply upper_bound_sharp; assumption].
Qed.

(* 7.4 under the paper's hypotheses. *)
Corollary sum_paper : forall p (s : State R),
  (3 <= count (drones s))%nat -> p_min p < p_max p -> anchored p (drones s) ->
  0 <= p_eps p < 1/2 -> in_first_subsegment p (drones s) ->
  forall k, sum (drones (protocol_step p s k)) <= sum_bound p (count (drones s)) /\
            (sum (drones (protocol_step p s k)) = sum_bound p (count (drones s)) <->
             at_targets p (drones (protocol_step p s k))).
Proof.
  intros p s Hn Hseg Ha He Hf k.
  assert (Hu : upper_bounded p (drones s))
    by (apply first_subsegment_upper_bounded; auto; lra).
  split; [apply sum_bounded_sharp|apply sum_maximal_sharp]; auto; lra.
Qed.
