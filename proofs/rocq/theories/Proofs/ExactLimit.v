(* Theorem 7.8, sharp: every start converges if and only if
   0 < eps < eps*_N = 1/(1 + cos(pi/(N-1))), and the exact rate per N.
   The eigenvectors are sin(i*theta) and (-1)^i sin(i*theta), theta = pi/(N-1). *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.Ordering Proofs.UpperBound.
From Cordon Require Import Proofs.Increasing Proofs.Limit.
Local Open Scope R_scope.

Definition theta (M : nat) : R := PI / INR M.

Definition critical_weight (N : nat) : R := 1 / (1 + cos (PI / INR (N - 1))).

Definition wave (M i : nat) : R := sin (INR i * theta M).

Definition zigzag (M i : nat) : R := (-1) ^ i * wave M i.

Section Waves.
Variable M : nat.
Hypothesis HM : (2 <= M)%nat.

Let INR_M : 2 <= INR M.
Proof. apply (le_INR 2); exact HM. Qed.

Lemma theta_range : 0 < theta M <= PI / 2.
Proof.
  pose proof PI_RGT_0 as HPI; unfold theta; split.
  - apply Rdiv_lt_0_compat; lra.
  - unfold Rdiv; apply Rmult_le_compat_l; [lra|].
    apply Rinv_le_contravar; lra.
Qed.

Lemma theta_M : INR M * theta M = PI.
Proof. unfold theta; field; lra. Qed.

Lemma cos_theta_range : 0 <= cos (theta M) < 1.
Proof.
  pose proof theta_range as Ht; pose proof PI_RGT_0 as HPI; split.
  - apply cos_ge_0; lra.
  - rewrite <- cos_0; apply cos_decreasing_1; lra.
Qed.

Lemma wave_first : wave M 0 = 0.
Proof. unfold wave; simpl; rewrite Rmult_0_l; apply sin_0. Qed.

Lemma wave_last : wave M M = 0.
Proof. unfold wave; rewrite theta_M; apply sin_PI. Qed.

Lemma wave_pos : forall i, (0 < i < M)%nat -> 0 < wave M i.
Proof.
  intros i Hi; pose proof theta_range as Ht; unfold wave; apply sin_gt_0.
  - apply Rmult_lt_0_compat; [apply INR_pos; lia|lra].
  - rewrite <- theta_M; apply Rmult_lt_compat_r; [lra|apply lt_INR; lia].
Qed.

Lemma wave_middle : forall i, wave M i + wave M (S (S i)) = 2 * cos (theta M) * wave M (S i).
Proof.
  intros i; unfold wave.
  replace (INR i * theta M) with (INR (S i) * theta M - theta M) by (rewrite S_INR; ring).
  replace (INR (S (S i)) * theta M) with (INR (S i) * theta M + theta M)
    by (rewrite (S_INR (S i)); ring).
  rewrite sin_minus, sin_plus; ring.
Qed.

Lemma zigzag_middle : forall i,
  zigzag M i + zigzag M (S (S i)) = - (2 * cos (theta M)) * zigzag M (S i).
Proof.
  intros i; unfold zigzag; simpl pow.
  replace ((-1) ^ i * wave M i + -1 * (-1 * (-1) ^ i) * wave M (S (S i)))
    with ((-1) ^ i * (wave M i + wave M (S (S i)))) by ring.
  rewrite wave_middle; ring.
Qed.

Lemma zigzag_first : zigzag M 0 = 0.
Proof. unfold zigzag; rewrite wave_first; ring. Qed.

Lemma zigzag_last : zigzag M M = 0.
Proof. unfold zigzag; rewrite wave_last; ring. Qed.

(* ---- The spectral radius ---- *)

(* The two extreme eigenvalues of A. *)
Definition largest_eigenvalue (e : R) : R := 1 - 2 * e * (1 - cos (theta M)).
Definition least_eigenvalue (e : R) : R := 1 - 2 * e * (1 + cos (theta M)).

Definition spectral_radius (e : R) : R :=
  Rmax (Rabs (largest_eigenvalue e)) (Rabs (least_eigenvalue e)).

Lemma spectral_radius_eq : forall e, 0 <= e ->
  spectral_radius e = Rabs (1 - 2 * e) + 2 * e * cos (theta M).
Proof.
  intros e He; pose proof cos_theta_range as Hc.
  unfold spectral_radius, largest_eigenvalue, least_eigenvalue.
  assert (0 <= e * cos (theta M)) by (apply Rmult_le_pos; lra).
  destruct (Rle_lt_dec (2 * e) 1) as [Hl|Hl].
  - rewrite (Rabs_pos_eq (1 - 2 * e)) by lra.
    rewrite (Rabs_pos_eq (1 - 2 * e * (1 - cos (theta M)))) by lra.
    rewrite Rmax_left; [ring|].
    apply Rabs_le; lra.
  - rewrite (Rabs_left (1 - 2 * e)) by lra.
    rewrite (Rabs_left1 (1 - 2 * e * (1 + cos (theta M)))) by lra.
    rewrite Rmax_right; [ring|].
    apply Rabs_le; lra.
Qed.

Lemma critical_weight_range : 1/2 < critical_weight (M + 1) <= 1.
Proof.
  pose proof cos_theta_range as Hc; unfold critical_weight.
  replace (M + 1 - 1)%nat with M by lia; fold (theta M); unfold Rdiv; rewrite !Rmult_1_l; split.
  - apply Rinv_lt_contravar; [apply Rmult_lt_0_compat|]; lra.
  - rewrite <- Rinv_1 at 2; apply Rinv_le_contravar; lra.
Qed.

Lemma below_critical_iff : forall e,
  e < critical_weight (M + 1) <-> e * (1 + cos (theta M)) < 1.
Proof.
  intros e; pose proof cos_theta_range as Hc; unfold critical_weight.
  replace (M + 1 - 1)%nat with M by lia; fold (theta M).
  assert (Hr : 1 / (1 + cos (theta M)) * (1 + cos (theta M)) = 1) by (field; lra).
  split; intros H.
  - apply Rmult_lt_compat_r with (r := 1 + cos (theta M)) in H; lra.
  - apply Rmult_lt_reg_r with (1 + cos (theta M)); lra.
Qed.

Lemma spectral_radius_below_one : forall e, 0 < e < critical_weight (M + 1) ->
  0 <= spectral_radius e < 1.
Proof.
  intros e [He Hs]; apply below_critical_iff in Hs; pose proof cos_theta_range as Hc.
  rewrite spectral_radius_eq by lra.
  assert (0 <= e * cos (theta M)) by (apply Rmult_le_pos; lra).
  pose proof (Rabs_pos (1 - 2 * e)); split; [lra|].
  destruct (Rle_lt_dec (2 * e) 1) as [Hl|Hl].
  - rewrite Rabs_pos_eq by lra.
    assert (0 < e * (1 - cos (theta M))) by (apply Rmult_lt_0_compat; lra). lra.
  - rewrite Rabs_left by lra; lra.
Qed.

(* The best weight is 1/2, with rate cos(pi/(N-1)). *)
Lemma spectral_radius_least : forall e, 0 <= e -> spectral_radius (1/2) <= spectral_radius e.
Proof.
  intros e He; rewrite !spectral_radius_eq by lra; pose proof cos_theta_range as Hc.
  replace (1 - 2 * (1 / 2)) with 0 by field; rewrite Rabs_R0.
  destruct (Rle_lt_dec (2 * e) 1) as [Hl|Hl].
  - rewrite (Rabs_pos_eq (1 - 2 * e)) by lra.
    assert (0 <= (1 - 2 * e) * (1 - cos (theta M))) by (apply Rmult_le_pos; lra). lra.
  - rewrite (Rabs_left (1 - 2 * e)) by lra.
    assert (0 <= (2 * e - 1) * (1 + cos (theta M))) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma spectral_radius_half : spectral_radius (1/2) = cos (theta M).
Proof.
  rewrite spectral_radius_eq by lra.
  replace (1 - 2 * (1 / 2)) with 0 by field; rewrite Rabs_R0; field.
Qed.

Lemma wave_contracts : forall e i, 0 <= e ->
  Rabs e * wave M i + Rabs (1 - 2 * e) * wave M (S i) + Rabs e * wave M (S (S i))
  <= spectral_radius e * wave M (S i).
Proof.
  intros e i He; rewrite (Rabs_pos_eq e), spectral_radius_eq by exact He.
  pose proof (wave_middle i) as Hm.
  replace (e * wave M i + Rabs (1 - 2 * e) * wave M (S i) + e * wave M (S (S i)))
    with (e * (wave M i + wave M (S (S i))) + Rabs (1 - 2 * e) * wave M (S i)) by ring.
  rewrite Hm; lra.
Qed.

(* ---- Runs along an eigenvector ---- *)

Lemma eigen_run : forall e lambda v E,
  (forall i, (S i < M)%nat -> e * v i + (1 - 2 * e) * v (S i) + e * v (S (S i)) = lambda * v (S i)) ->
  v O = 0 -> v M = 0 -> run M e E -> (forall i, (i <= M)%nat -> E O i = v i) ->
  forall k i, (i <= M)%nat -> E k i = lambda ^ k * v i.
Proof.
  intros e lambda v E Hv V0 VM HE H0 k; induction k as [|k IH]; intros i Hi.
  - rewrite H0 by exact Hi; simpl; ring.
  - destruct (HE k) as [S0 SM Si].
    destruct (Nat.eq_dec i M) as [->|Hne]; [rewrite SM, IH, VM by lia; ring|].
    destruct i as [|i]; [rewrite S0, IH, V0 by lia; ring|].
    rewrite Si, !IH by lia.
    replace (e * (lambda ^ k * v i) + (1 - 2 * e) * (lambda ^ k * v (S i))
             + e * (lambda ^ k * v (S (S i))))
      with (lambda ^ k * (e * v i + (1 - 2 * e) * v (S i) + e * v (S (S i)))) by ring.
    rewrite Hv by lia; simpl; ring.
Qed.

Lemma wave_eigen : forall e i,
  e * wave M i + (1 - 2 * e) * wave M (S i) + e * wave M (S (S i))
  = largest_eigenvalue e * wave M (S i).
Proof.
  intros e i; pose proof (wave_middle i) as Hm; unfold largest_eigenvalue.
  replace (e * wave M i + (1 - 2 * e) * wave M (S i) + e * wave M (S (S i)))
    with (e * (wave M i + wave M (S (S i))) + (1 - 2 * e) * wave M (S i)) by ring.
  rewrite Hm; ring.
Qed.

Lemma zigzag_eigen : forall e i,
  e * zigzag M i + (1 - 2 * e) * zigzag M (S i) + e * zigzag M (S (S i))
  = least_eigenvalue e * zigzag M (S i).
Proof.
  intros e i; pose proof (zigzag_middle i) as Hm; unfold least_eigenvalue.
  replace (e * zigzag M i + (1 - 2 * e) * zigzag M (S i) + e * zigzag M (S (S i)))
    with (e * (zigzag M i + zigzag M (S (S i))) + (1 - 2 * e) * zigzag M (S i)) by ring.
  rewrite Hm; ring.
Qed.

End Waves.

(* ---- On the spec ---- *)

(* max_j |e_j^0| / sin(j*theta) over the internal drones. *)
Definition initial_wave_ratio (p : Params R) (s : State R) : R :=
  internal_ratio (count (drones s) - 1) (error p s 0) (wave (count (drones s) - 1)).

(* The exact rate as an upper bound, for every weight eps >= 0. *)
Theorem limit_exact_rate : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p ->
  forall k i, (i < count (drones s))%nat ->
  Rabs (error p s k i) <=
    spectral_radius (count (drones s) - 1) (p_eps p) ^ k * initial_wave_ratio p s
    * wave (count (drones s) - 1) i.
Proof.
  intros p s Hn Ha He k i Hi; destruct (error_ends p s Hn Ha) as [E0 EM].
  set (M := (count (drones s) - 1)%nat) in *.
  assert (HM : (2 <= M)%nat) by (unfold M; lia).
  pose proof (wave_first M) as W0; pose proof (wave_last M HM) as WM.
  apply contraction_run with (M := M) (e := p_eps p); auto; try lra.
  - apply error_run; assumption.
  - apply max_ratio_nonneg.
  - eapply Rle_trans; [apply Rabs_pos|apply Rmax_l].
  - intros j Hj; apply wave_contracts; assumption.
  - intros j Hj; unfold initial_wave_ratio; fold M.
    apply internal_ratio_bounds; auto; try lra.
    intros l Hl; apply wave_pos; assumption.
  - unfold M; lia.
Qed.

Lemma limit_anchored : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) ->
  0 < p_eps p < critical_weight (count (drones s)) ->
  forall i, (i < count (drones s))%nat ->
  Un_cv (fun k => get (drones (protocol_step p s k)) i) (target p (count (drones s)) i).
Proof.
  intros p s Hn Ha He i Hi.
  apply geometric_cv with
    (r := spectral_radius (count (drones s) - 1) (p_eps p))
    (C := initial_wave_ratio p s * wave (count (drones s) - 1) i).
  - apply spectral_radius_below_one; [lia|].
    replace (count (drones s) - 1 + 1)%nat with (count (drones s)) by lia; exact He.
  - intros k; rewrite Rabs_minus_sym, <- Rmult_assoc.
    apply (limit_exact_rate p s Hn Ha); [lra|exact Hi].
Qed.

Lemma protocol_step_shift : forall (T : Type) (K : Scalar T) p (s : State T) k,
  protocol_step p s (S k) = protocol_step p (exec_coverage p s) k.
Proof.
  intros T K p s k; induction k as [|k IH]; [reflexivity|].
  change (protocol_step p s (S (S k))) with (exec_coverage p (protocol_step p s (S k))).
  rewrite IH; reflexivity.
Qed.

(* 7.8, sharp: any start at all, even one whose end drones are elsewhere. *)
Theorem limit_sharp : forall p (s : State R),
  (3 <= count (drones s))%nat -> 0 < p_eps p < critical_weight (count (drones s)) ->
  forall i, (i < count (drones s))%nat ->
  Un_cv (fun k => get (drones (protocol_step p s k)) i) (target p (count (drones s)) i).
Proof.
  intros p s Hn He i Hi.
  pose proof (count_exec_coverage _ _ p s) as Hc.
  pose proof (limit_anchored p (exec_coverage p s)) as H; rewrite Hc in H.
  specialize (H Hn (anchored_exec p s ltac:(lia)) He i Hi).
  intros eps Heps; destruct (H eps Heps) as [K HK]; exists (S K); intros [|k] Hk; [lia|].
  rewrite protocol_step_shift; apply HK; lia.
Qed.

(* The same in ticks, for a counter within 0 .. n: both phases. *)
Theorem limit_sharp_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> 0 < p_eps p < critical_weight (count (drones s)) ->
  (timesteps s <= p_n p)%nat -> forall i, (i < count (drones s))%nat ->
  Un_cv (fun k => get (drones (kth_step p s k)) i) (target p (count (drones s)) i).
Proof. intros; apply limit_ticks_of_steps; [assumption|apply limit_sharp; assumption]. Qed.

(* A start with prescribed errors. *)
Lemma start_with_errors : forall p N (v : nat -> R), (3 <= N)%nat ->
  v O = 0 -> v (N - 1)%nat = 0 ->
  let s := start_of p N (fun i => target p N i - v i) in
  count (drones s) = N /\ anchored p (drones s) /\
  forall i, (i <= N - 1)%nat -> error p s 0 i = v i.
Proof.
  intros p N v HN V0 VM s.
  assert (Hc : count (drones s) = N) by apply count_start.
  split; [exact Hc|split].
  - split; [|rewrite Hc]; unfold s; rewrite get_start by lia.
    + rewrite V0, target_line, line_first; ring.
    + rewrite VM, target_line, line_last by lia; ring.
  - intros i Hi; unfold error; rewrite Hc; simpl protocol_step; unfold s.
    rewrite get_start by lia; ring.
Qed.

(* Both extreme eigenvalues are attained: the exact rate is no worse than the truth. *)
Theorem limit_exact_rate_attained : forall p N, (3 <= N)%nat ->
  (exists s : State R, count (drones s) = N /\ anchored p (drones s) /\ 0 < error p s 0 1 /\
     forall k i, (i <= N - 1)%nat ->
     error p s k i = largest_eigenvalue (N - 1) (p_eps p) ^ k * error p s 0 i) /\
  (exists s : State R, count (drones s) = N /\ anchored p (drones s) /\ error p s 0 1 < 0 /\
     forall k i, (i <= N - 1)%nat ->
     error p s k i = least_eigenvalue (N - 1) (p_eps p) ^ k * error p s 0 i).
Proof.
  intros p N HN; assert (HM : (2 <= N - 1)%nat) by lia.
  pose proof (wave_pos (N - 1) HM 1 ltac:(lia)) as Hw1.
  split.
  - destruct (start_with_errors p N (wave (N - 1)) HN (wave_first _) (wave_last _ HM)) as [Hc [Ha He]].
    eexists; split; [exact Hc|split; [exact Ha|split]].
    + rewrite He by lia; exact Hw1.
    + intros k i Hi; rewrite (He i) by exact Hi.
      apply eigen_run with (M := (N - 1)%nat) (e := p_eps p); auto.
      * intros j Hj; apply wave_eigen.
      * apply wave_first.
      * apply wave_last; exact HM.
      * rewrite <- Hc at 1; apply error_run; [rewrite Hc; exact HN|exact Ha].
  - destruct (start_with_errors p N (zigzag (N - 1)) HN (zigzag_first _) (zigzag_last _ HM)) as [Hc [Ha He]].
    eexists; split; [exact Hc|split; [exact Ha|split]].
    + rewrite He by lia; unfold zigzag; simpl; lra.
    + intros k i Hi; rewrite (He i) by exact Hi.
      apply eigen_run with (M := (N - 1)%nat) (e := p_eps p); auto.
      * intros j Hj; apply zigzag_eigen.
      * apply zigzag_first.
      * apply zigzag_last; exact HM.
      * rewrite <- Hc at 1; apply error_run; [rewrite Hc; exact HN|exact Ha].
Qed.

Lemma no_decay : forall lambda a l, 1 <= Rabs lambda -> a <> 0 ->
  ~ Un_cv (fun k => l - lambda ^ k * a) l.
Proof.
  intros lambda a l Hl Ha Hcv; rewrite cv_abs in Hcv.
  destruct (Hcv (Rabs a)) as [K HK]; [apply Rabs_pos_lt; exact Ha|].
  specialize (HK K ltac:(lia)).
  replace (l - lambda ^ K * a - l) with (- (lambda ^ K * a)) in HK by ring.
  rewrite Rabs_Ropp, Rabs_mult, <- RPow_abs in HK.
  assert (1 <= Rabs lambda ^ K) by (apply pow_R1_Rle; exact Hl).
  pose proof (Rabs_pos a); assert (1 * Rabs a <= Rabs lambda ^ K * Rabs a)
    by (apply Rmult_le_compat_r; lra).
  lra.
Qed.

(* 7.8 as an equivalence. *)
Theorem limit_iff : forall p N, (3 <= N)%nat ->
  ((forall s : State R, count (drones s) = N -> anchored p (drones s) ->
      forall i, (i < N)%nat ->
      Un_cv (fun k => get (drones (protocol_step p s k)) i) (target p N i))
   <-> 0 < p_eps p < critical_weight N).
Proof.
  intros p N HN; assert (HM : (2 <= N - 1)%nat) by lia.
  pose proof (cos_theta_range (N - 1) HM) as Hcos.
  assert (Hback : forall s k, count (drones s) = N ->
    get (drones (protocol_step p s k)) 1 = target p N 1 - error p s k 1).
  { intros s k Hc; unfold error; rewrite Hc; ring. }
  destruct (limit_exact_rate_attained p N HN) as
    [[s1 [C1 [A1 [P1 R1]]]] [s2 [C2 [A2 [P2 R2]]]]].
  split.
  - intros Hcv; split; apply Rnot_le_lt; intros Hbad.
    + apply (no_decay (largest_eigenvalue (N - 1) (p_eps p)) (error p s1 0 1) (target p N 1));
        [|lra|].
      * unfold largest_eigenvalue; eapply Rle_trans; [|apply Rle_abs].
        assert (0 <= - p_eps p * (1 - cos (theta (N - 1)))) by (apply Rmult_le_pos; lra). lra.
      * intros eps Heps; destruct (Hcv s1 C1 A1 1%nat ltac:(lia) eps Heps) as [K HK].
        exists K; intros k Hk; specialize (HK k Hk).
        rewrite Hback, R1 in HK by (assumption || lia); exact HK.
    + apply (no_decay (least_eigenvalue (N - 1) (p_eps p)) (error p s2 0 1) (target p N 1));
        [|lra|].
      * assert (Hge : 1 <= p_eps p * (1 + cos (theta (N - 1)))).
        { apply Rnot_lt_le; intros Hlt.
          pose proof (proj2 (below_critical_iff (N - 1) HM (p_eps p)) Hlt) as H.
          replace (N - 1 + 1)%nat with N in H by lia; lra. }
        unfold least_eigenvalue; rewrite Rabs_left by lra; lra.
      * intros eps Heps; destruct (Hcv s2 C2 A2 1%nat ltac:(lia) eps Heps) as [K HK].
        exists K; intros k Hk; specialize (HK k Hk).
        rewrite Hback, R2 in HK by (assumption || lia); exact HK.
  - intros He s Hc Ha i Hi; rewrite <- Hc in *; apply limit_sharp; auto.
Qed.

(* ---- The critical weights of PROTOCOL section 2 ---- *)

Theorem critical_weight_3 : critical_weight 3 = 1.
Proof.
  unfold critical_weight; replace (INR (3 - 1)) with 2 by (simpl; ring).
  rewrite cos_PI2; field.
Qed.

Theorem critical_weight_4 : critical_weight 4 = 2/3.
Proof.
  unfold critical_weight; replace (INR (4 - 1)) with 3 by (simpl; ring).
  rewrite cos_PI3; field.
Qed.

Theorem critical_weight_5 : critical_weight 5 = 2 - sqrt 2.
Proof.
  unfold critical_weight; replace (INR (5 - 1)) with 4 by (simpl; ring).
  rewrite cos_PI4; pose proof (sqrt_lt_R0 2 ltac:(lra)) as H.
  pose proof (sqrt_sqrt 2 ltac:(lra)) as Hs.
  apply Rmult_eq_reg_r with (1 + 1 / sqrt 2); [|apply Rgt_not_eq, Rlt_gt].
  - replace (1 / (1 + 1 / sqrt 2) * (1 + 1 / sqrt 2)) with 1
      by (field; split; [lra|]; apply Rgt_not_eq, Rlt_gt; lra).
    apply Rmult_eq_reg_r with (sqrt 2); [|lra].
    replace ((2 - sqrt 2) * (1 + 1 / sqrt 2) * sqrt 2)
      with (2 * sqrt 2 + 2 - sqrt 2 * sqrt 2 - sqrt 2) by (field; lra).
    lra.
  - assert (0 < 1 / sqrt 2) by (apply Rdiv_lt_0_compat; lra). lra.
Qed.

(* eps = 1/2 is always safe, and the fastest weight. *)
Theorem half_is_below_critical : forall N, (3 <= N)%nat -> 1/2 < critical_weight N.
Proof.
  intros N HN; pose proof (critical_weight_range (N - 1) ltac:(lia)) as H.
  replace (N - 1 + 1)%nat with N in H by lia; lra.
Qed.

Theorem half_is_fastest : forall N e, (3 <= N)%nat -> 0 <= e ->
  spectral_radius (N - 1) (1/2) = cos (PI / INR (N - 1)) /\
  spectral_radius (N - 1) (1/2) <= spectral_radius (N - 1) e.
Proof.
  intros N e HN He; split.
  - apply spectral_radius_half; lia.
  - apply spectral_radius_least; [lia|exact He].
Qed.
