(* Consensus on a path of N drones: every start converges to its average if and
   only if 0 < eps < 1/(1 + cos(pi/N)).  The gaps of consensus on N drones move
   as the errors of coverage on N + 1 drones do. *)
From Coq Require Import Reals Lra Lia ZArith Arith List Bool.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Placement Spec.Graph.
From Cordon Require Import Spec.Consensus.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.Limit Proofs.ExactLimit.
From Cordon Require Import Proofs.Consensus.
Local Open Scope R_scope.

(* ---- What one drone on a path computes ---- *)

Lemma sumn_single : forall (f : nat -> R) a n,
  sumn (fun j => if Nat.eqb j a then f j else 0) n = if Nat.ltb a n then f a else 0.
Proof.
  intros f a n; induction n as [|n IH]; [reflexivity|].
  simpl sumn; rewrite IH.
  destruct (Nat.eqb_spec n a) as [->|Hne].
  - replace (Nat.ltb a a) with false by (symmetry; apply Nat.ltb_irrefl).
    replace (Nat.ltb a (S a)) with true by (symmetry; apply Nat.ltb_lt; lia). ring.
  - destruct (Nat.ltb_spec a n).
    + replace (Nat.ltb a (S n)) with true by (symmetry; apply Nat.ltb_lt; lia). ring.
    + replace (Nat.ltb a (S n)) with false by (symmetry; apply Nat.ltb_ge; lia). ring.
Qed.

(* The gap before drone j, for 0 < j < N; 0 outside. *)
Definition gap_before (N : nat) (x : nat -> R) (j : nat) : R :=
  if (Nat.ltb 0 j && Nat.ltb j N)%bool then x j - x (j - 1)%nat else 0.

Lemma pull_path : forall N (x : DroneMap R) i, (i < N)%nat ->
  pull (path N) x i = gap_before N (get x) (S i) - gap_before N (get x) i.
Proof.
  intros N x i Hi; rewrite pull_sumn; simpl graph_count; simpl linked.
  set (f := fun j => get x j - get x i).
  rewrite (sumn_ext _ (fun j =>
    (if Nat.eqb j (S i) then f j else 0) +
    (if Nat.eqb j (i - 1) then (if Nat.eqb i 0 then 0 else f j) else 0))).
  - rewrite sumn_plus, sumn_single, (sumn_single (fun j => if Nat.eqb i 0 then 0 else f j)).
    unfold gap_before, f; simpl Nat.sub; rewrite Nat.sub_0_r.
    replace (Nat.ltb 0 (S i)) with true by reflexivity; simpl andb.
    replace (Nat.ltb i N) with true by (symmetry; apply Nat.ltb_lt; lia).
    replace (Nat.ltb (i - 1) N) with true by (symmetry; apply Nat.ltb_lt; lia).
    destruct i as [|i]; [simpl; ring|].
    replace (Nat.ltb 0 (S i)) with true by reflexivity; simpl andb.
    replace (Nat.eqb (S i) 0) with false by reflexivity. ring.
  - intros j Hj; unfold path_linked.
    replace (Nat.ltb j N) with true by (symmetry; apply Nat.ltb_lt; lia).
    replace (Nat.ltb i N) with true by (symmetry; apply Nat.ltb_lt; lia).
    rewrite !andb_true_r; fold f; unfold f.
    destruct (Nat.eqb_spec (i + 1) j); destruct (Nat.eqb_spec (j + 1) i);
      destruct (Nat.eqb_spec j (S i)); destruct (Nat.eqb_spec j (i - 1));
      destruct (Nat.eqb_spec i 0); simpl; try lia; ring.
Qed.

Definition X (N : nat) (e : R) (x : DroneMap R) (k i : nat) : R :=
  get (consensus_step e (path N) x k) i.

Lemma X_step : forall N e x k i, count x = N -> (i < N)%nat ->
  X N e x (S k) i =
  X N e x k i + e * (gap_before N (X N e x k) (S i) - gap_before N (X N e x k) i).
Proof.
  intros N e x k i Hc Hi; unfold X; simpl consensus_step; unfold exec_consensus.
  rewrite count_consensus_step, get_lambda by lia; simpl.
  rewrite pull_path by exact Hi; reflexivity.
Qed.

Lemma gap_run : forall N e x, (2 <= N)%nat -> count x = N ->
  run N e (fun k j => gap_before N (X N e x k) j).
Proof.
  intros N e x HN Hc k; split.
  - reflexivity.
  - unfold gap_before; rewrite Nat.ltb_irrefl, andb_false_r; reflexivity.
  - intros i Hi.
    unfold gap_before at 1.
    replace (Nat.ltb 0 (S i) && Nat.ltb (S i) N)%bool with true
      by (symmetry; apply andb_true_intro; split; apply Nat.ltb_lt; lia).
    replace (S i - 1)%nat with i by lia.
    rewrite !X_step by (assumption || lia).
    assert (Hg : gap_before N (X N e x k) (S i) = X N e x k (S i) - X N e x k i).
    { unfold gap_before.
      replace (Nat.ltb 0 (S i) && Nat.ltb (S i) N)%bool with true
        by (symmetry; apply andb_true_intro; split; apply Nat.ltb_lt; lia).
      replace (S i - 1)%nat with i by lia; reflexivity. }
    rewrite Hg; ring.
Qed.

Lemma gap_ends : forall N x, gap_before N x 0 = 0 /\ gap_before N x N = 0.
Proof.
  intros N x; split; [reflexivity|].
  unfold gap_before; rewrite Nat.ltb_irrefl, andb_false_r; reflexivity.
Qed.

(* ---- Small gaps mean positions near the average ---- *)

Lemma near_first : forall N x B, (forall j, (j <= N)%nat -> Rabs (gap_before N x j) <= B) ->
  forall i, (i < N)%nat -> Rabs (x i - x O) <= INR i * B.
Proof.
  intros N x B HB i; induction i as [|i IH]; intros Hi.
  - rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; simpl; lra.
  - specialize (IH ltac:(lia)); specialize (HB (S i) ltac:(lia)); revert HB.
    unfold gap_before.
    replace (Nat.ltb 0 (S i) && Nat.ltb (S i) N)%bool with true
      by (symmetry; apply andb_true_intro; split; apply Nat.ltb_lt; lia).
    replace (S i - 1)%nat with i by lia; intros HB.
    replace (x (S i) - x O) with ((x (S i) - x i) + (x i - x O)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; rewrite S_INR; lra.
Qed.

Lemma sumn_abs : forall f B n, (forall i, (i < n)%nat -> Rabs (f i) <= B) ->
  Rabs (sumn f n) <= INR n * B.
Proof.
  intros f B n; induction n as [|n IH]; intros Hf; [simpl; rewrite Rabs_R0; lra|].
  change (sumn f (S n)) with (sumn f n + f n); rewrite S_INR.
  eapply Rle_trans; [apply Rabs_triang|].
  assert (Rabs (sumn f n) <= INR n * B) by (apply IH; intros i Hi; apply Hf; lia).
  specialize (Hf n ltac:(lia)); lra.
Qed.

Lemma sumn_const : forall c n, sumn (fun _ => c) n = INR n * c.
Proof. intros c n; induction n as [|n IH]; [simpl; ring|]; simpl sumn; rewrite IH, S_INR; ring. Qed.

Lemma near_average : forall N x B, (1 <= N)%nat ->
  (forall j, (j <= N)%nat -> Rabs (gap_before N x j) <= B) ->
  forall i, (i < N)%nat -> Rabs (x i - sumn x N / INR N) <= 2 * INR N * B.
Proof.
  intros N x B HN HB i Hi.
  assert (HB0 : 0 <= B) by (eapply Rle_trans; [apply Rabs_pos|apply (HB O); lia]).
  assert (HNR : 0 < INR N) by (apply INR_pos; lia).
  assert (Hpair : forall j, (j < N)%nat -> Rabs (x i - x j) <= 2 * INR N * B).
  { intros j Hj; replace (x i - x j) with ((x i - x O) + - (x j - x O)) by ring.
    eapply Rle_trans; [apply Rabs_triang|]; rewrite Rabs_Ropp.
    pose proof (near_first N x B HB i Hi); pose proof (near_first N x B HB j Hj).
    assert (INR i * B <= INR N * B) by (apply Rmult_le_compat_r; [exact HB0|apply le_INR; lia]).
    assert (INR j * B <= INR N * B) by (apply Rmult_le_compat_r; [exact HB0|apply le_INR; lia]).
    lra. }
  pose proof (sumn_abs (fun j => x i - x j) _ N Hpair) as Hs.
  rewrite sumn_minus, sumn_const in Hs.
  replace (x i - sumn x N / INR N) with ((INR N * x i - sumn x N) * / INR N) by (field; lra).
  rewrite Rabs_mult, (Rabs_pos_eq (/ INR N)) by (apply Rlt_le, Rinv_0_lt_compat; exact HNR).
  apply Rmult_le_reg_r with (INR N); [exact HNR|].
  rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; lra.
Qed.

(* ---- Convergence exactly below the critical weight ---- *)

Definition consensus_critical_weight (N : nat) : R := 1 / (1 + cos (PI / INR N)).

Lemma consensus_critical_coverage : forall N,
  consensus_critical_weight N = critical_weight (N + 1).
Proof.
  intros N; unfold consensus_critical_weight, critical_weight.
  replace (N + 1 - 1)%nat with N by lia; reflexivity.
Qed.

Theorem consensus_path_rate : forall N e (x : DroneMap R) k i,
  (2 <= N)%nat -> count x = N -> 0 <= e -> (i < N)%nat ->
  Rabs (get (consensus_step e (path N) x k) i - sum x / INR N)
  <= spectral_radius N e ^ k
     * (2 * INR N * internal_ratio N (gap_before N (get x)) (wave N)).
Proof.
  intros N e x k i HN Hc He Hi.
  set (r := spectral_radius N e); set (C := internal_ratio N (gap_before N (get x)) (wave N)).
  assert (Hr : 0 <= r) by (eapply Rle_trans; [apply Rabs_pos|apply Rmax_l]).
  assert (HC : 0 <= C) by apply max_ratio_nonneg.
  pose proof (wave_first N) as W0; pose proof (wave_last N HN) as WN.
  assert (Hgap : forall j, (j <= N)%nat -> Rabs (gap_before N (X N e x k) j) <= r ^ k * C).
  { intros j Hj; apply Rle_trans with (r ^ k * C * wave N j).
    - apply contraction_run with (M := N) (e := e) (E := fun k j => gap_before N (X N e x k) j);
        auto; try lra.
      + apply gap_run; assumption.
      + intros k'; apply gap_ends.
      + intros l Hl; apply wave_contracts; assumption.
      + intros l Hl; unfold C, X; simpl.
        apply internal_ratio_bounds; try lra; try apply gap_ends; [|exact Hl].
        intros m Hm; apply wave_pos; assumption.
    - rewrite <- (Rmult_1_r (r ^ k * C)) at 2; apply Rmult_le_compat_l.
      + apply Rmult_le_pos; [apply pow_le; exact Hr|exact HC].
      + apply SIN_bound. }
  pose proof (near_average N (X N e x k) (r ^ k * C) ltac:(lia) Hgap i Hi) as H.
  assert (Hsum : sumn (X N e x k) N = sum x).
  { pose proof (consensus_average e (path N) x k ltac:(simpl; lia)) as Ha.
    rewrite count_consensus_step, Hc in Ha.
    unfold Rdiv in Ha; apply Rmult_eq_reg_r in Ha.
    - rewrite <- Ha, sum_sumn, count_consensus_step, Hc; reflexivity.
    - apply Rgt_not_eq, Rinv_0_lt_compat, INR_pos; lia. }
  rewrite Hsum in H; unfold X in H; lra.
Qed.

Theorem consensus_path_limit : forall N e (x : DroneMap R) i,
  (2 <= N)%nat -> count x = N -> 0 < e < consensus_critical_weight N -> (i < N)%nat ->
  Un_cv (fun k => get (consensus_step e (path N) x k) i) (sum x / INR N).
Proof.
  intros N e x i HN Hc He Hi; rewrite consensus_critical_coverage in He.
  apply geometric_cv with (r := spectral_radius N e)
    (C := 2 * INR N * internal_ratio N (gap_before N (get x)) (wave N)).
  - apply spectral_radius_below_one; assumption.
  - intros k; apply consensus_path_rate; auto; lra.
Qed.

(* A start with prescribed gaps, along an eigenvector. *)
Lemma start_with_gaps : forall N e v lambda, (2 <= N)%nat -> v O = 0 -> v N = 0 ->
  (forall i, (S i < N)%nat ->
     e * v i + (1 - 2 * e) * v (S i) + e * v (S (S i)) = lambda * v (S i)) ->
  exists x : DroneMap R, count x = N /\
    forall k, X N e x k 1 - X N e x k 0 = lambda ^ k * v 1%nat.
Proof.
  intros N e v lambda HN V0 VN Hv.
  exists (DroneMap.lambda N (fun i => sumn (fun j => v (S j)) i)).
  assert (Hc : count (DroneMap.lambda N (fun i => sumn (fun j => v (S j)) i)) = N) by apply count_lambda.
  split; [exact Hc|]; intros k.
  set (x := DroneMap.lambda N (fun i => sumn (fun j => v (S j)) i)) in *.
  assert (H0 : forall i, (i <= N)%nat -> gap_before N (X N e x 0) i = v i).
  { intros i Hi; destruct (gap_ends N (X N e x 0)) as [G0 GN].
    destruct (Nat.eq_dec i N) as [->|Hne]; [rewrite GN, VN; reflexivity|].
    destruct i as [|i]; [rewrite G0, V0; reflexivity|].
    unfold gap_before.
    replace (Nat.ltb 0 (S i) && Nat.ltb (S i) N)%bool with true
      by (symmetry; apply andb_true_intro; split; apply Nat.ltb_lt; lia).
    replace (S i - 1)%nat with i by lia.
    unfold X, x; simpl consensus_step; rewrite !get_lambda by lia; simpl; ring. }
  assert (H : gap_before N (X N e x k) 1 = lambda ^ k * v 1%nat).
  { apply eigen_run with (M := N) (e := e) (E := fun k j => gap_before N (X N e x k) j);
      auto; [apply gap_run; assumption|lia]. }
  rewrite <- H; unfold gap_before.
  replace (Nat.ltb 0 1 && Nat.ltb 1 N)%bool with true
    by (symmetry; apply andb_true_intro; split; apply Nat.ltb_lt; lia).
  reflexivity.
Qed.

(* The rate of consensus_path_rate is no worse than the truth: both extreme
   eigenvalues are met by the first gap of some start. *)
Theorem consensus_path_rate_attained : forall N e, (2 <= N)%nat ->
  (exists x : DroneMap R, count x = N /\ X N e x 0 1 - X N e x 0 0 <> 0 /\
     forall k, X N e x k 1 - X N e x k 0 =
               largest_eigenvalue N e ^ k * (X N e x 0 1 - X N e x 0 0)) /\
  (exists x : DroneMap R, count x = N /\ X N e x 0 1 - X N e x 0 0 <> 0 /\
     forall k, X N e x k 1 - X N e x k 0 =
               least_eigenvalue N e ^ k * (X N e x 0 1 - X N e x 0 0)).
Proof.
  intros N e HN; pose proof (wave_pos N HN 1 ltac:(lia)) as Hw; split.
  - destruct (start_with_gaps N e (wave N) (largest_eigenvalue N e) HN (wave_first N)
                (wave_last N HN) (fun i _ => wave_eigen N e i)) as [x [Hx Hk]].
    exists x; split; [exact Hx|]; rewrite (Hk 0%nat), pow_O, Rmult_1_l; split; [lra|exact Hk].
  - destruct (start_with_gaps N e (zigzag N) (least_eigenvalue N e) HN (zigzag_first N)
                (zigzag_last N HN) (fun i _ => zigzag_eigen N e i)) as [x [Hx Hk]].
    exists x; split; [exact Hx|]; rewrite (Hk 0%nat), pow_O, Rmult_1_l; split; [|exact Hk].
    unfold zigzag; simpl; lra.
Qed.

Theorem consensus_path_iff : forall N e, (2 <= N)%nat ->
  ((forall x : DroneMap R, count x = N -> forall i, (i < N)%nat ->
      Un_cv (fun k => get (consensus_step e (path N) x k) i) (sum x / INR N))
   <-> 0 < e < consensus_critical_weight N).
Proof.
  intros N e HN; split.
  - intros Hcv; rewrite consensus_critical_coverage.
    pose proof (wave_pos N HN 1 ltac:(lia)) as Hw; pose proof (cos_theta_range N HN) as Hcos.
    assert (Hdiff : forall x : DroneMap R, count x = N ->
              Un_cv (fun k => X N e x k 1 - X N e x k 0) 0).
    { intros x Hx; replace 0 with (sum x / INR N - sum x / INR N) by ring.
      apply CV_minus; apply Hcv; auto; lia. }
    assert (Hno : forall x lambda a, count x = N -> 1 <= Rabs lambda -> a <> 0 ->
              (forall k, X N e x k 1 - X N e x k 0 = lambda ^ k * a) -> False).
    { intros x lambda a Hx Hl Ha Hk; apply (no_decay lambda (- a) 0); [exact Hl|lra|].
      intros eps Heps; destruct (Hdiff x Hx eps Heps) as [K HK]; exists K; intros k Hk'.
      specialize (HK k Hk'); rewrite Hk in HK.
      replace (0 - lambda ^ k * - a) with (lambda ^ k * a) by ring; exact HK. }
    split; apply Rnot_le_lt; intros Hbad.
    + destruct (start_with_gaps N e (wave N) (largest_eigenvalue N e) HN (wave_first N)
                  (wave_last N HN) (fun i _ => wave_eigen N e i)) as [x [Hx Hk]].
      apply (Hno x (largest_eigenvalue N e) (wave N 1)); auto; [|lra].
      unfold largest_eigenvalue; eapply Rle_trans; [|apply Rle_abs].
      assert (0 <= - e * (1 - cos (theta N))) by (apply Rmult_le_pos; lra). lra.
    + destruct (start_with_gaps N e (zigzag N) (least_eigenvalue N e) HN (zigzag_first N)
                  (zigzag_last N HN) (fun i _ => zigzag_eigen N e i)) as [x [Hx Hk]].
      apply (Hno x (least_eigenvalue N e) (zigzag N 1)); auto.
      * assert (Hge : 1 <= e * (1 + cos (theta N))).
        { apply Rnot_lt_le; intros Hlt.
          pose proof (proj2 (below_critical_iff N HN e) Hlt); lra. }
        unfold least_eigenvalue; rewrite Rabs_left by lra; lra.
      * unfold zigzag; simpl; lra.
  - intros He x Hx i Hi; apply consensus_path_limit; assumption.
Qed.
