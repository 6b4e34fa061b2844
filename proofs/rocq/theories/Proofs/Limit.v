(* Theorem 7.8 for 0 < eps <= 1/2, with a rate for every N at once: the vector
   w_i = i(N-1-i) contracts. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.UpperBound Proofs.NonDecreasing.
From Cordon Require Import Proofs.Increasing.
Local Open Scope R_scope.

(* ---- Contraction ---- *)

(* If |A| w <= r w on the internal drones, then bounds C*w shrink by r a step. *)
Lemma contraction_step : forall M e r w C x y,
  step M e x y -> 0 <= C -> x O = 0 -> x M = 0 -> 0 <= w O -> 0 <= w M ->
  0 <= r ->
  (forall i, (S i < M)%nat ->
     Rabs e * w i + Rabs (1 - 2 * e) * w (S i) + Rabs e * w (S (S i)) <= r * w (S i)) ->
  (forall i, (i <= M)%nat -> Rabs (x i) <= C * w i) ->
  forall i, (i <= M)%nat -> Rabs (y i) <= r * C * w i.
Proof.
  intros M e r w C x y [H0 HL Hi] HC X0 XM W0 WM Hr Hw Hx i HiM.
  assert (Hends : 0 <= r * C * w O /\ 0 <= r * C * w M)
    by (split; repeat apply Rmult_le_pos; assumption).
  destruct (Nat.eq_dec i M) as [->|E]; [rewrite HL, XM, Rabs_R0; tauto|].
  destruct i as [|i]; [rewrite H0, X0, Rabs_R0; tauto|].
  rewrite Hi by lia.
  specialize (Hw i ltac:(lia)).
  pose proof (Hx i ltac:(lia)) as B0; pose proof (Hx (S i) ltac:(lia)) as B1.
  pose proof (Hx (S (S i)) ltac:(lia)) as B2.
  apply Rle_trans with
    (Rabs (e * x i) + Rabs ((1 - 2 * e) * x (S i)) + Rabs (e * x (S (S i)))).
  { eapply Rle_trans; [apply Rabs_triang|]; apply Rplus_le_compat_r, Rabs_triang. }
  rewrite !Rabs_mult.
  assert (Rabs e * Rabs (x i) <= Rabs e * (C * w i))
    by (apply Rmult_le_compat_l; [apply Rabs_pos|exact B0]).
  assert (Rabs (1 - 2 * e) * Rabs (x (S i)) <= Rabs (1 - 2 * e) * (C * w (S i)))
    by (apply Rmult_le_compat_l; [apply Rabs_pos|exact B1]).
  assert (Rabs e * Rabs (x (S (S i))) <= Rabs e * (C * w (S (S i))))
    by (apply Rmult_le_compat_l; [apply Rabs_pos|exact B2]).
  assert (C * (Rabs e * w i + Rabs (1 - 2 * e) * w (S i) + Rabs e * w (S (S i)))
          <= C * (r * w (S i))) by (apply Rmult_le_compat_l; assumption).
  lra.
Qed.

Lemma contraction_run : forall M e r w C E,
  run M e E -> (forall k, E k O = 0) -> (forall k, E k M = 0) ->
  0 <= C -> 0 <= w O -> 0 <= w M -> 0 <= r ->
  (forall i, (S i < M)%nat ->
     Rabs e * w i + Rabs (1 - 2 * e) * w (S i) + Rabs e * w (S (S i)) <= r * w (S i)) ->
  (forall i, (i <= M)%nat -> Rabs (E O i) <= C * w i) ->
  forall k i, (i <= M)%nat -> Rabs (E k i) <= r ^ k * C * w i.
Proof.
  intros M e r w C E HE E0 EM HC W0 WM Hr Hw H0 k; induction k as [|k IH].
  - intros i Hi; simpl; rewrite Rmult_1_l; apply H0; exact Hi.
  - intros i Hi; simpl pow; rewrite (Rmult_assoc r).
    apply contraction_step with (M := M) (e := e) (x := E k); auto.
    apply Rmult_le_pos; [apply pow_le; exact Hr|exact HC].
Qed.

(* ---- The weights w_i = i(M-i) ---- *)

Definition weight (M i : nat) : R := INR i * INR (M - i).

(* They are the spec's contraction weights. *)
Lemma weight_contraction_weight : forall N i,
  weight (N - 1) i = INR (contraction_weight N i).
Proof. intros N i; unfold weight, contraction_weight; rewrite mult_INR; reflexivity. Qed.

Lemma weight_minus : forall M i, (i <= M)%nat -> weight M i = INR i * (INR M - INR i).
Proof. intros M i Hi; unfold weight; rewrite minus_INR by exact Hi; reflexivity. Qed.

Lemma weight_pos : forall M i, (0 < i < M)%nat -> 0 < weight M i.
Proof. intros M i Hi; unfold weight; apply Rmult_lt_0_compat; apply INR_pos; lia. Qed.

(* A w = w - 2 eps. *)
Lemma weight_eigen : forall M e i, (S i < M)%nat ->
  e * weight M i + (1 - 2 * e) * weight M (S i) + e * weight M (S (S i)) = weight M (S i) - 2 * e.
Proof. intros M e i Hi; rewrite !weight_minus by lia; rewrite !S_INR; ring. Qed.

(* w_i <= M^2/4, so that A w <= (1 - 8 eps/M^2) w. *)
Definition rate (M : nat) (e : R) : R := 1 - 8 * e / (INR M * INR M).

Lemma weight_le : forall M i, (i <= M)%nat -> 4 * weight M i <= INR M * INR M.
Proof.
  intros M i Hi; rewrite weight_minus by exact Hi.
  pose proof (Rle_0_sqr (INR M - 2 * INR i)) as H; unfold Rsqr in H; lra.
Qed.

Lemma weight_contracts : forall M e i, 0 <= e <= 1/2 -> (S i < M)%nat ->
  Rabs e * weight M i + Rabs (1 - 2 * e) * weight M (S i) + Rabs e * weight M (S (S i))
  <= rate M e * weight M (S i).
Proof.
  intros M e i He Hi.
  rewrite (Rabs_pos_eq e), (Rabs_pos_eq (1 - 2 * e)), weight_eigen by (lra || lia).
  unfold rate; assert (HM : 0 < INR M) by (apply INR_pos; lia).
  pose proof (weight_le M (S i) ltac:(lia)) as Hw.
  assert (HMM : 0 < INR M * INR M) by (apply Rmult_lt_0_compat; exact HM).
  assert (H : 8 * e / (INR M * INR M) * weight M (S i) <= 2 * e).
  { replace (8 * e / (INR M * INR M) * weight M (S i))
      with (2 * e * (4 * weight M (S i)) * / (INR M * INR M)) by (field; lra).
    replace (2 * e) with (2 * e * (INR M * INR M) * / (INR M * INR M)) at 2 by (field; lra).
    apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat, HMM|].
    apply Rmult_le_compat_l; lra. }
  lra.
Qed.

Lemma rate_range : forall M e, (2 <= M)%nat -> 0 < e <= 1/2 -> 0 <= rate M e < 1.
Proof.
  intros M e HM He; unfold rate.
  assert (2 <= INR M) by (apply (le_INR 2); exact HM).
  assert (HMM : 4 <= INR M * INR M) by nra.
  assert (Hp : 0 < 8 * e / (INR M * INR M)) by (apply Rdiv_lt_0_compat; lra).
  assert (Hq : 8 * e / (INR M * INR M) <= 1).
  { apply Rmult_le_reg_r with (INR M * INR M); [lra|].
    replace (8 * e / (INR M * INR M) * (INR M * INR M)) with (8 * e) by (field; lra). lra. }
  lra.
Qed.

(* ---- The constant max_j |e_j| / w_j ---- *)

Fixpoint max_ratio (E w : nat -> R) (n : nat) : R :=
  match n with
  | O => 0
  | S n' => Rmax (max_ratio E w n') (Rabs (E n') / w n')
  end.

Lemma max_ratio_nonneg : forall E w n, 0 <= max_ratio E w n.
Proof.
  intros E w n; induction n as [|n IH]; simpl; [lra|].
  apply Rle_trans with (1 := IH), Rmax_l.
Qed.

Lemma max_ratio_ge : forall E w n i, (i < n)%nat -> Rabs (E i) / w i <= max_ratio E w n.
Proof.
  intros E w n i; induction n as [|n IH]; intros Hi; [lia|]; simpl.
  destruct (Nat.eq_dec i n) as [->|Hne]; [apply Rmax_r|].
  apply Rle_trans with (max_ratio E w n); [apply IH; lia|apply Rmax_l].
Qed.

(* The largest |e_j|/w_j over the internal drones 1 .. M-1. *)
Definition internal_ratio (M : nat) (E w : nat -> R) : R :=
  max_ratio (fun i => E (S i)) (fun i => w (S i)) (M - 1).

Lemma internal_ratio_bounds : forall M E w,
  E O = 0 -> E M = 0 -> 0 <= w O -> 0 <= w M -> (forall i, (0 < i < M)%nat -> 0 < w i) ->
  forall i, (i <= M)%nat -> Rabs (E i) <= internal_ratio M E w * w i.
Proof.
  intros M E w E0 EM W0 WM Hw i Hi.
  pose proof (max_ratio_nonneg (fun i => E (S i)) (fun i => w (S i)) (M - 1)) as HC.
  fold (internal_ratio M E w) in HC.
  destruct (Nat.eq_dec i M) as [->|E1];
    [rewrite EM, Rabs_R0; apply Rmult_le_pos; assumption|].
  destruct i as [|i]; [rewrite E0, Rabs_R0; apply Rmult_le_pos; assumption|].
  pose proof (Hw (S i) ltac:(lia)) as Hwi.
  pose proof (max_ratio_ge (fun i => E (S i)) (fun i => w (S i)) (M - 1) i ltac:(lia)) as Hr.
  fold (internal_ratio M E w) in Hr; cbv beta in Hr.
  apply Rmult_le_compat_r with (r := w (S i)) in Hr; [|lra].
  replace (Rabs (E (S i)) / w (S i) * w (S i)) with (Rabs (E (S i))) in Hr by (field; lra).
  exact Hr.
Qed.

Lemma geometric_cv : forall (u : nat -> R) r C l, 0 <= r < 1 ->
  (forall k, Rabs (u k - l) <= r ^ k * C) -> Un_cv u l.
Proof.
  intros u r C l Hr Hu; apply cv_abs; intros eps Heps.
  destruct (pow_lt_1_zero r) with (y := eps / (Rabs C + 1)) as [K HK].
  - rewrite Rabs_pos_eq by lra; lra.
  - apply Rdiv_lt_0_compat; [exact Heps|pose proof (Rabs_pos C); lra].
  - exists K; intros k Hk.
    pose proof (Rabs_pos C) as HC.
    specialize (HK k Hk); rewrite Rabs_pos_eq in HK by (apply pow_le; lra).
    apply Rle_lt_trans with (r ^ k * (Rabs C + 1)).
    + apply Rle_trans with (1 := Hu k).
      apply Rmult_le_compat_l; [apply pow_le; lra|].
      pose proof (Rle_abs C); lra.
    + apply Rmult_lt_compat_r with (r := Rabs C + 1) in HK; [|lra].
      replace (eps / (Rabs C + 1) * (Rabs C + 1)) with eps in HK by (field; lra).
      exact HK.
Qed.

(* ---- On the spec ---- *)

(* The error e_i = T_i - X_i after k protocol steps. *)
Definition error (p : Params R) (s : State R) (k i : nat) : R :=
  target p (count (drones s)) i - get (drones (protocol_step p s k)) i.

Lemma error_errors : forall p s k i,
  error p s k i = errors (count (drones s) - 1) (p_min p) (p_max p) (positions p s) k i.
Proof. reflexivity. Qed.

Lemma error_run : forall p s, (3 <= count (drones s))%nat -> anchored p (drones s) ->
  run (count (drones s) - 1) (p_eps p) (error p s).
Proof. intros p s Hn Ha k; apply step_err, positions_run; assumption. Qed.

Lemma error_ends : forall p s, (3 <= count (drones s))%nat -> anchored p (drones s) ->
  (forall k, error p s k 0 = 0) /\ (forall k, error p s k (count (drones s) - 1) = 0).
Proof.
  intros p s Hn Ha; split; intros k; rewrite error_errors.
  - apply (errors_first _ (p_eps p)); [apply positions_run; assumption|exact (proj1 Ha)].
  - apply (errors_last _ (p_eps p)); [lia|apply positions_run; assumption|exact (proj2 Ha)].
Qed.

(* max_j |e_j^0|/w_j over the internal drones. *)
Definition initial_ratio (p : Params R) (s : State R) : R :=
  internal_ratio (count (drones s) - 1) (error p s 0) (weight (count (drones s) - 1)).

(* 7.8, the rate, for 0 <= eps <= 1/2 and any start:
   |e_i^k| <= (1 - 8 eps/(N-1)^2)^k * max_j(|e_j^0|/w_j) * w_i. *)
Theorem limit_rate : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 < p_eps p <= 1/2 ->
  forall k i, (i < count (drones s))%nat ->
  Rabs (error p s k i) <=
    rate (count (drones s) - 1) (p_eps p) ^ k * initial_ratio p s
    * INR (contraction_weight (count (drones s)) i).
Proof.
  intros p s Hn Ha He k i Hi; rewrite <- weight_contraction_weight.
  destruct (error_ends p s Hn Ha) as [E0 EM].
  set (M := (count (drones s) - 1)%nat) in *.
  assert (W0 : weight M 0 = 0) by (unfold weight; simpl; ring).
  assert (WM : weight M M = 0) by (unfold weight; rewrite Nat.sub_diag; simpl; ring).
  apply contraction_run with (M := M) (e := p_eps p); auto; try lra.
  - apply error_run; assumption.
  - apply max_ratio_nonneg.
  - apply rate_range; [unfold M; lia|exact He].
  - intros j Hj; apply weight_contracts; [lra|exact Hj].
  - intros j Hj; unfold initial_ratio; fold M.
    apply internal_ratio_bounds; auto; try lra.
    intros l Hl; apply weight_pos; exact Hl.
  - unfold M; lia.
Qed.

(* A drone that converges in protocol steps converges in ticks. *)
Lemma limit_ticks_of_steps : forall p (s : State R) i l,
  (timesteps s <= p_n p)%nat ->
  Un_cv (fun k => get (drones (protocol_step p s k)) i) l ->
  Un_cv (fun k => get (drones (kth_step p s k)) i) l.
Proof.
  intros p s i l Hc Hcv eps Heps; destruct (Hcv eps Heps) as [J HJ].
  destruct (updates_unbounded (p_n p) (timesteps s) J) as [K HK].
  exists K; intros k Hk.
  destruct (kth_step_protocol_step _ _ p s k Hc) as [-> _].
  apply HJ, HK; exact Hk.
Qed.

(* 7.8, sharp up to 1/2, in protocol steps: any anchored start. *)
Theorem limit_half : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 < p_eps p <= 1/2 ->
  forall i, (i < count (drones s))%nat ->
  Un_cv (fun k => get (drones (protocol_step p s k)) i) (target p (count (drones s)) i).
Proof.
  intros p s Hn Ha He i Hi.
  apply geometric_cv with
    (r := rate (count (drones s) - 1) (p_eps p))
    (C := initial_ratio p s * INR (contraction_weight (count (drones s)) i)).
  - apply rate_range; [lia|exact He].
  - intros k; rewrite Rabs_minus_sym, <- Rmult_assoc.
    apply (limit_rate p s Hn Ha He k i Hi).
Qed.

(* In ticks, for both phases: a counter within 0 .. n. *)
Theorem limit_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 < p_eps p <= 1/2 ->
  (timesteps s <= p_n p)%nat -> forall i, (i < count (drones s))%nat ->
  Un_cv (fun k => get (drones (kth_step p s k)) i) (target p (count (drones s)) i).
Proof. intros; apply limit_ticks_of_steps; [assumption|apply limit_half; assumption]. Qed.

Corollary limit_both_phases : forall p (x : DroneMap R) phase,
  (3 <= count x)%nat -> anchored p x -> 0 < p_eps p <= 1/2 ->
  forall i, (i < count x)%nat ->
  Un_cv (fun k => get (drones (kth_step p (initial x (p_n p) phase) k)) i) (target p (count x) i).
Proof.
  intros p x phase Hn Ha He i Hi; apply (limit_ticks p (initial x (p_n p) phase)); auto.
  destruct phase; simpl; lia.
Qed.
