(* Convergence and non-convergence from one positive vector (Collatz-Wielandt):
   what a certificate for one N and one eps has to show, without eigenvalues. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.Ordering Proofs.Limit.
From Cordon Require Import Proofs.ExactLimit.
Local Open Scope R_scope.

(* |A| w <= r w with r < 1 and w positive on the internal drones. *)
Definition contracting (M : nat) (e r : R) (w : nat -> R) : Prop :=
  0 <= w O /\ 0 <= w M /\ (forall i, (0 < i < M)%nat -> 0 < w i) /\
  forall i, (S i < M)%nat ->
    Rabs e * w i + Rabs (1 - 2 * e) * w (S i) + Rabs e * w (S (S i)) <= r * w (S i).

(* |A| w >= w with w positive on the internal drones, for eps >= 1/2. *)
Definition expanding (M : nat) (e : R) (w : nat -> R) : Prop :=
  w O = 0 /\ w M = 0 /\ (forall i, (0 < i < M)%nat -> 0 < w i) /\
  forall i, (S i < M)%nat ->
    w (S i) <= e * w i + (2 * e - 1) * w (S i) + e * w (S (S i)).

(* A contracting vector bounds every error, for every start. *)
Theorem certificate_rate : forall p (s : State R) r w,
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= r ->
  contracting (count (drones s) - 1) (p_eps p) r w ->
  forall k i, (i < count (drones s))%nat ->
  Rabs (error p s k i) <= r ^ k * internal_ratio (count (drones s) - 1) (error p s 0) w * w i.
Proof.
  intros p s r w Hn Ha Hr [W0 [WM [Wp Wc]]] k i Hi; destruct (error_ends p s Hn Ha) as [E0 EM].
  apply contraction_run with (M := (count (drones s) - 1)%nat) (e := p_eps p); auto.
  - apply error_run; assumption.
  - apply max_ratio_nonneg.
  - intros j Hj; apply internal_ratio_bounds; auto.
  - lia.
Qed.

(* So it proves convergence from every start. *)
Theorem certificate_converges : forall p (s : State R) r w,
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= r < 1 ->
  contracting (count (drones s) - 1) (p_eps p) r w ->
  forall i, (i < count (drones s))%nat ->
  Un_cv (fun k => get (drones (protocol_step p s k)) i) (target p (count (drones s)) i).
Proof.
  intros p s r w Hn Ha Hr Hw i Hi.
  apply geometric_cv with
    (r := r) (C := internal_ratio (count (drones s) - 1) (error p s 0) w * w i); [exact Hr|].
  intros k; rewrite Rabs_minus_sym, <- Rmult_assoc.
  apply (certificate_rate p s r w Hn Ha); [lra|exact Hw|exact Hi].
Qed.

(* The start whose errors alternate along an expanding vector never comes closer. *)
Lemma expanding_run : forall M e w E, 1/2 <= e -> expanding M e w -> run M e E ->
  (forall i, (i <= M)%nat -> E O i = (-1) ^ i * w i) ->
  forall k i, (i <= M)%nat -> w i <= (-1) ^ (k + i) * E k i.
Proof.
  intros M e w E He [W0 [WM [Wp Wc]]] HE H0 k; induction k as [|k IH]; intros i Hi.
  - rewrite H0 by exact Hi; simpl Nat.add.
    replace ((-1) ^ i * ((-1) ^ i * w i)) with (((-1) * (-1)) ^ i * w i)
      by (rewrite Rpow_mult_distr; ring).
    replace (-1 * -1) with 1 by ring; rewrite pow1; lra.
  - assert (Hends : forall k, E k O = 0 /\ E k M = 0).
    { intros k'; destruct (run_ends _ _ _ HE k') as [-> ->].
      rewrite !H0, W0, WM by lia; split; ring. }
    destruct (Nat.eq_dec i M) as [->|Hne];
      [rewrite (proj2 (Hends (S k))), WM; lra|].
    destruct i as [|i]; [rewrite (proj1 (Hends (S k))), W0; lra|].
    rewrite (step_inner _ _ _ _ (HE k) i) by lia.
    pose proof (IH i ltac:(lia)) as P0; pose proof (IH (S i) ltac:(lia)) as P1.
    pose proof (IH (S (S i)) ltac:(lia)) as P2; specialize (Wc i ltac:(lia)).
    replace (k + S i)%nat with (S (k + i)) in P1 by lia.
    replace (k + S (S i))%nat with (S (S (k + i))) in P2 by lia.
    replace (S k + S i)%nat with (S (S (k + i))) by lia.
    simpl pow in P1, P2 |- *; set (q := (-1) ^ (k + i)) in *.
    assert (e * w i <= e * (q * E k i)) by (apply Rmult_le_compat_l; lra).
    assert ((2 * e - 1) * w (S i) <= (2 * e - 1) * (-1 * q * E k (S i)))
      by (apply Rmult_le_compat_l; lra).
    assert (e * w (S (S i)) <= e * (-1 * (-1 * q) * E k (S (S i))))
      by (apply Rmult_le_compat_l; lra).
    lra.
Qed.

(* An expanding vector proves that some start does not converge. *)
Theorem certificate_diverges : forall p N w, (3 <= N)%nat -> 1/2 <= p_eps p ->
  expanding (N - 1) (p_eps p) w ->
  exists s : State R, count (drones s) = N /\ anchored p (drones s) /\
    forall i, (0 < i < N - 1)%nat ->
    (forall k, w i <= Rabs (error p s k i)) /\
    ~ Un_cv (fun k => get (drones (protocol_step p s k)) i) (target p N i).
Proof.
  intros p N w HN He Hw; pose proof Hw as [W0 [WM [Wp _]]].
  destruct (start_with_errors p N (fun i => (-1) ^ i * w i) HN) as [Hc [Ha H0]].
  - rewrite W0; ring.
  - rewrite WM; ring.
  - eexists; split; [exact Hc|split; [exact Ha|]]; intros i Hi.
    assert (Hge : forall k, w i <= Rabs (error p (start_of p N (fun i => target p N i - (-1) ^ i * w i)) k i)).
    { intros k; eapply Rle_trans.
      - apply (expanding_run (N - 1) (p_eps p) w) with (k := k); auto; [|lia].
        rewrite <- Hc at 1; apply error_run; [rewrite Hc; exact HN|exact Ha].
      - eapply Rle_trans; [apply Rle_abs|].
        rewrite Rabs_mult, pow_1_abs, Rmult_1_l; apply Rle_refl. }
    split; [exact Hge|]; intros Hcv; rewrite cv_abs in Hcv.
    destruct (Hcv (w i) (Wp i Hi)) as [K HK]; specialize (HK K ltac:(lia)).
    specialize (Hge K); unfold error in Hge; rewrite Hc in Hge.
    rewrite Rabs_minus_sym in HK; lra.
Qed.
