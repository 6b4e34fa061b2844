(* The spec decides eps < eps*_N = 1/(1 + cos(pi/(N-1))) on integers, by the signs
   of a tridiagonal matrix' leading minors.  Here is why that is right: a Sturm
   comparison of the minors' recurrence with that of sin(k*theta). *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.ExactLimit.
Local Open Scope R_scope.

(* u_0 = 0, u_1 = 1, u_{k+2} = t u_{k+1} - u_k; the pair (u_k, u_{k+1}). *)
Fixpoint chebyshev (t : R) (k : nat) : R * R :=
  match k with
  | O => (0, 1)
  | S k' => let (b, m) := chebyshev t k' in (m, t * m - b)
  end.

Definition u (t : R) (k : nat) : R := fst (chebyshev t k).

Lemma u_next : forall t k, snd (chebyshev t k) = u t (S k).
Proof. intros t k; unfold u; simpl; destruct (chebyshev t k); reflexivity. Qed.

Lemma u_recurrence : forall t k, u t (S (S k)) = t * u t (S k) - u t k.
Proof.
  intros t k; rewrite <- !u_next; unfold u; simpl; destruct (chebyshev t k); reflexivity.
Qed.

(* The minors are the u_{k+1}, scaled. *)
Lemma minors_u : forall num den k, num <> 0 ->
  let t := (2 * den - 2 * num) / num in
  minors (T := R) (2 * den - 2 * num) (num * num) k = (num ^ (k - 1) * u t k, num ^ k * u t (S k)).
Proof.
  intros num den k Hnum t; induction k as [|k IH].
  - unfold u; simpl; f_equal; ring.
  - simpl minors; rewrite IH, u_recurrence; f_equal.
    + replace (S k - 1)%nat with k by lia; reflexivity.
    + change (sub ?a ?b) with (a - b); change (mul ?a ?b) with (a * b).
      destruct k as [|k].
      * unfold t, u; simpl; field; exact Hnum.
      * replace (S k - 1)%nat with k by lia; unfold t; simpl pow; field; exact Hnum.
Qed.

Section Comparison.
Variable M : nat.
Hypothesis HM : (2 <= M)%nat.
Variable t : R.

(* The Casoratian of the two solutions. *)
Definition casoratian (k : nat) : R := u t (S k) * wave M k - u t k * wave M (S k).

Lemma casoratian_next : forall k,
  casoratian (S k) = casoratian k + (t - 2 * cos (theta M)) * (u t (S k) * wave M (S k)).
Proof.
  intros k; unfold casoratian; rewrite u_recurrence.
  pose proof (wave_middle M k) as Hm.
  replace (wave M (S (S k))) with (2 * cos (theta M) * wave M (S k) - wave M k) by lra.
  ring.
Qed.

Lemma casoratian_first : casoratian 0 = 0.
Proof. unfold casoratian; rewrite wave_first; unfold u; simpl; ring. Qed.

(* Above 2 cos theta the solution stays positive up to M. *)
Lemma above_positive : 2 * cos (theta M) < t ->
  forall k, (S k <= M)%nat -> 0 < u t (S k) /\ 0 <= casoratian k.
Proof.
  intros Ht k; induction k as [|k IHu]; intros Hk.
  - rewrite casoratian_first; unfold u; simpl; lra.
  - destruct (IHu ltac:(lia)) as [Hu Hc].
    assert (Hw : 0 < wave M (S k)) by (apply wave_pos; lia).
    assert (Hstep : 0 < casoratian (S k)).
    { rewrite casoratian_next.
      assert (0 < (t - 2 * cos (theta M)) * (u t (S k) * wave M (S k)))
        by (apply Rmult_lt_0_compat; [lra|apply Rmult_lt_0_compat; assumption]).
      lra. }
    split; [|lra].
    unfold casoratian in Hstep.
    assert (Hw2 : 0 <= wave M (S (S k))).
    { destruct (Nat.eq_dec (S (S k)) M) as [E|E]; [rewrite E, wave_last by exact HM; lra|].
      apply Rlt_le, wave_pos; lia. }
    assert (0 <= u t (S k) * wave M (S (S k))) by (apply Rmult_le_pos; lra).
    apply Rmult_lt_reg_r with (wave M (S k)); [exact Hw|lra].
Qed.

(* At or below it some member up to M is not positive. *)
Lemma below_nonpositive : t <= 2 * cos (theta M) ->
  ~ (forall k, (1 <= k <= M)%nat -> 0 < u t k).
Proof.
  intros Ht Hall.
  assert (Hc : forall k, (S k <= M)%nat -> casoratian k <= 0).
  { induction k as [|k IH]; intros Hk; [rewrite casoratian_first; lra|].
    rewrite casoratian_next; specialize (IH ltac:(lia)).
    assert (Hw : 0 < wave M (S k)) by (apply wave_pos; lia).
    assert (Hu : 0 < u t (S k)) by (apply Hall; lia).
    assert (0 <= (2 * cos (theta M) - t) * (u t (S k) * wave M (S k)))
      by (apply Rmult_le_pos; [lra|apply Rmult_le_pos; lra]).
    lra. }
  specialize (Hc (M - 1)%nat ltac:(lia)); unfold casoratian in Hc.
  replace (S (M - 1)) with M in Hc by lia; rewrite (wave_last M HM) in Hc.
  assert (0 < u t M) by (apply Hall; lia).
  assert (0 < wave M (M - 1)) by (apply wave_pos; lia).
  assert (0 < u t M * wave M (M - 1)) by (apply Rmult_lt_0_compat; assumption).
  lra.
Qed.
End Comparison.

(* The spec's decision is right, for every N >= 3 and every positive weight. *)
Theorem below_critical_correct : forall num den N, (3 <= N)%nat -> 0 < num -> 0 < den ->
  (below_critical num den N <-> num / den < critical_weight N).
Proof.
  intros num den N HN Hnum Hden; set (M := (N - 1)%nat).
  assert (HM : (2 <= M)%nat) by (unfold M; lia).
  set (t := (2 * den - 2 * num) / num).
  assert (Hminor : below_critical num den N <-> forall k, (1 <= k <= M)%nat -> 0 < u t k).
  { unfold below_critical; cbv zeta.
    change (sub (mul (from_int 2%Z) den) (mul (from_int 2%Z) num)) with (2 * den - 2 * num).
    change (mul num num) with (num * num); change (from_int 0%Z) with 0.
    change (less (T := R)) with Rlt.
    split; intros H k Hk.
    - destruct (Nat.eq_dec k 1) as [->|E]; [unfold u; simpl; lra|].
      specialize (H (k - 1)%nat ltac:(unfold M in Hk; lia)).
      rewrite minors_u in H by lra; cbv zeta in H; fold t in H; simpl snd in H.
      replace (S (k - 1)) with k in H by lia.
      assert (0 < num ^ (k - 1)) by (apply pow_lt; exact Hnum).
      apply Rmult_lt_reg_l with (num ^ (k - 1)); lra.
    - rewrite minors_u by lra; cbv zeta; fold t; simpl snd.
      apply Rmult_lt_0_compat; [apply pow_lt; exact Hnum|apply H; unfold M; lia]. }
  assert (Hcrit : num / den < critical_weight N <-> 2 * cos (theta M) < t).
  { replace N with (M + 1)%nat by (unfold M; lia); rewrite below_critical_iff by exact HM.
    pose proof (cos_theta_range M HM) as Hcos.
    assert (E1 : num / den * (1 + cos (theta M)) * den = num * (1 + cos (theta M))) by (field; lra).
    assert (E2 : t * num = 2 * den - 2 * num) by (unfold t; field; lra).
    split; intros H.
    - apply Rmult_lt_compat_r with (r := den) in H; [|exact Hden].
      apply Rmult_lt_reg_r with num; [exact Hnum|]; lra.
    - apply Rmult_lt_compat_r with (r := num) in H; [|exact Hnum].
      apply Rmult_lt_reg_r with den; [exact Hden|]; lra. }
  rewrite Hminor, Hcrit; split; intros H.
  - destruct (Rlt_le_dec (2 * cos (theta M)) t) as [Hlt|Hle]; [exact Hlt|].
    exfalso; apply (below_nonpositive M HM t Hle H).
  - intros k Hk; destruct k as [|k]; [lia|].
    apply (above_positive M HM t H k); lia.
Qed.
