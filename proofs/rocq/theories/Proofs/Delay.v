(* Stale messages: bounds and convergence survive bounded delays, ordering does not. *)
From Coq Require Import Reals QArith Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Delay Spec.Theorems.Hypothesis Spec.Theorems.UpperBound.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.UpperBound Proofs.Increasing.
From Cordon Require Import Proofs.Limit Proofs.Rational.
Local Open Scope R_scope.

Section Run.
Context {T : Type} `{Scalar T}.

(* In step k drone i sees drone j where it was `delay k i j` steps before; before
   the start every drone stood where it started. *)
Definition sees (delay : nat -> nat -> nat -> nat) (X : nat -> State T) (k i j : nat) : T :=
  getx (X (k - delay k i j)%nat) j.

Definition delayed_run (p : Params T) (delay : nat -> nat -> nat -> nat) (X : nat -> State T) : Prop :=
  forall k, X (S k) = exec_coverage_delayed p (X k) (sees delay X k).

(* The run, computed: the history has the newest state first. *)
Fixpoint history (p : Params T) (delay : nat -> nat -> nat -> nat) (s : State T) (k : nat)
  : list (State T) :=
  match k with
  | O => s :: nil
  | S k' =>
      let h := history p delay s k' in
      let at_age d := nth d h s in
      exec_coverage_delayed p (at_age O) (fun i j => getx (at_age (Nat.min (delay k' i j) k')) j) :: h
  end.

Definition delayed_step (p : Params T) (delay : nat -> nat -> nat -> nat) (s : State T) (k : nat)
  : State T :=
  nth 0 (history p delay s k) s.

Lemma history_ages : forall p delay s k d, (d <= k)%nat ->
  nth d (history p delay s k) s = delayed_step p delay s (k - d).
Proof.
  intros p delay s k; induction k as [|k IH]; intros d Hd.
  - replace d with O by lia; reflexivity.
  - destruct d as [|d]; [reflexivity|].
    change (nth d (history p delay s k) s = delayed_step p delay s (S k - S d)).
    apply IH; lia.
Qed.

(* Every delay schedule has its run, for every start. *)
Theorem delayed_step_run : forall p delay s, delayed_run p delay (delayed_step p delay s).
Proof.
  intros p delay s k; unfold delayed_step at 1; simpl nth.
  unfold exec_coverage_delayed; rewrite history_ages by lia; rewrite Nat.sub_0_r.
  f_equal; unfold lambda; apply map_ext; intros i; unfold update.
  assert (E : forall j,
    (if (j =? i)%nat then getx (delayed_step p delay s k) i
     else getx (nth (Nat.min (delay k i j) k) (history p delay s k) s) j)
    = (if (j =? i)%nat then getx (delayed_step p delay s k) i
       else sees delay (delayed_step p delay s) k i j)).
  { intros j; destruct (j =? i)%nat; [reflexivity|].
    unfold sees; rewrite history_ages by lia; do 2 f_equal; lia. }
  rewrite !E; reflexivity.
Qed.
End Run.

(* ---- What one drone computes ---- *)

Lemma delayed_count : forall p delay (X : nat -> State R),
  delayed_run p delay X -> forall k, count (drones (X k)) = count (drones (X O)).
Proof.
  intros p delay X HX k; induction k as [|k IH]; [reflexivity|].
  rewrite HX; unfold exec_coverage_delayed; cbn [drones]; rewrite count_lambda; exact IH.
Qed.

Section Bounds.
Variables (p : Params R) (delay : nat -> nat -> nat -> nat) (X : nat -> State R).
Hypothesis HX : delayed_run p delay X.
Hypothesis Hn : (3 <= count (drones (X O)))%nat.
Hypothesis Ha : anchored p (drones (X O)).

Let N := count (drones (X O)).
Let M := (N - 1)%nat.

Lemma delayed_ends : forall k, anchored p (drones (X k)).
Proof.
  intros [|k]; [exact Ha|].
  rewrite HX; unfold anchored, exec_coverage_delayed; cbn [drones].
  rewrite count_lambda, (delayed_count p delay X HX k).
  split; rewrite get_lambda by lia; [reflexivity|].
  apply update_last; lia.
Qed.

Lemma delayed_inner : forall k i, (S i < M)%nat ->
  getx (X (S k)) (S i) =
  p_eps p * getx (X (k - delay k (S i) i)%nat) i + (1 - 2 * p_eps p) * getx (X k) (S i)
  + p_eps p * getx (X (k - delay k (S i) (S (S i)))%nat) (S (S i)).
Proof.
  intros k i Hi; unfold getx at 1; rewrite HX; unfold exec_coverage_delayed; cbn [drones].
  rewrite (delayed_count p delay X HX k), get_lambda by (unfold M, N in Hi; lia).
  replace (S (S i)) with (i + 2)%nat by lia; replace (S i) with (i + 1)%nat by lia.
  rewrite update_inner by (unfold M, N in Hi; lia).
  replace (i =? i + 1)%nat with false by (symmetry; apply Nat.eqb_neq; lia).
  replace (i + 2 =? i + 1)%nat with false by (symmetry; apply Nat.eqb_neq; lia).
  rewrite Nat.eqb_refl; reflexivity.
Qed.

(* A concave barrier of the start is a barrier for ever, above or below. *)
Lemma delayed_below : forall sigma b, 0 <= p_eps p <= 1/2 -> sigma = 1 \/ sigma = -1 ->
  concave M b -> below M (fun i => sigma * getx (X O) i) b ->
  forall k, below M (fun i => sigma * getx (X k) i) b.
Proof.
  intros sigma b He Hsigma Hb H0.
  assert (All : forall k j, (j <= k)%nat -> below M (fun i => sigma * getx (X j) i) b).
  { induction k as [|k IH]; intros j Hj; [replace j with O by lia; exact H0|].
    destruct (Nat.eq_dec j (S k)) as [->|Hne]; [|apply IH; lia].
    intros i Hi.
    destruct (delayed_ends O) as [A0 AM]; destruct (delayed_ends (S k)) as [B0 BM].
    rewrite (delayed_count p delay X HX (S k)) in BM; fold N in AM, BM; fold M in AM, BM.
    destruct (Nat.eq_dec i M) as [->|E].
    { unfold getx; rewrite BM, <- AM; apply H0; lia. }
    destruct i as [|i]; [unfold getx; rewrite B0, <- A0; apply H0; lia|].
    rewrite delayed_inner by lia.
    pose proof (IH (k - delay k (S i) i)%nat ltac:(lia) i ltac:(lia)) as P0.
    pose proof (IH k ltac:(lia) (S i) ltac:(lia)) as P1.
    pose proof (IH (k - delay k (S i) (S (S i)))%nat ltac:(lia) (S (S i)) ltac:(lia)) as P2.
    specialize (Hb i ltac:(lia)); cbv beta in P0, P1, P2.
    set (x0 := getx (X (k - delay k (S i) i)%nat) i) in *.
    set (x1 := getx (X k) (S i)) in *.
    set (x2 := getx (X (k - delay k (S i) (S (S i)))%nat) (S (S i))) in *.
    assert (p_eps p * (sigma * x0 + sigma * x2) <= p_eps p * (2 * b (S i)))
      by (apply Rmult_le_compat_l; lra).
    assert ((1 - 2 * p_eps p) * (sigma * x1) <= (1 - 2 * p_eps p) * b (S i))
      by (apply Rmult_le_compat_l; lra).
    lra. }
  intros k; apply (All k k); lia.
Qed.

Lemma delayed_upper : forall b, 0 <= p_eps p <= 1/2 -> concave M b ->
  below M (getx (X O)) b -> forall k, below M (getx (X k)) b.
Proof.
  intros b He Hb H0 k i Hi.
  pose proof (delayed_below 1 b He (or_introl eq_refl) Hb) as H.
  cbv beta in H; specialize (H ltac:(intros j Hj; specialize (H0 j Hj); lra) k i Hi).
  cbv beta in H; lra.
Qed.

Lemma delayed_lower : forall b, 0 <= p_eps p <= 1/2 -> concave M b ->
  below M (fun i => - getx (X O) i) b -> forall k, below M (fun i => - getx (X k) i) b.
Proof.
  intros b He Hb H0 k i Hi.
  pose proof (delayed_below (-1) b He (or_intror eq_refl) Hb) as H.
  cbv beta in H; specialize (H ltac:(intros j Hj; specialize (H0 j Hj); cbv beta in H0; lra) k i Hi).
  cbv beta in H; lra.
Qed.

(* UB, its mirror image and the box, with any delays at all. *)
Theorem upper_bound_delayed : 0 <= p_eps p <= 1/2 ->
  upper_bounded p (drones (X O)) -> forall k, upper_bounded p (drones (X k)).
Proof.
  intros He Hu k; apply upper_bounded_below; rewrite (delayed_count p delay X HX k); [lia|].
  apply delayed_upper; auto; [apply concave_line|].
  apply upper_bounded_below in Hu; [exact Hu|lia].
Qed.

Theorem lower_bound_delayed : 0 <= p_eps p <= 1/2 ->
  above_targets p (drones (X O)) -> forall k, above_targets p (drones (X k)).
Proof.
  intros He Hu k; apply above_targets_below; rewrite (delayed_count p delay X HX k); [lia|].
  apply delayed_lower; auto; [apply concave_opp_line|].
  apply above_targets_below in Hu; [exact Hu|lia].
Qed.

Theorem box_delayed : 0 <= p_eps p <= 1/2 ->
  in_box p (drones (X O)) -> forall k, in_box p (drones (X k)).
Proof.
  intros He Hb k i Hi; rewrite (delayed_count p delay X HX k) in Hi; fold N in Hi; simpl; split.
  - apply Ropp_le_cancel.
    apply (delayed_lower (fun _ => - p_min p) He (concave_const _ _)); [|unfold M; lia].
    intros j Hj; apply Ropp_le_contravar, Hb; unfold M, N in Hj; lia.
  - apply (delayed_upper (fun _ => p_max p) He (concave_const _ _)); [|unfold M; lia].
    intros j Hj; apply Hb; unfold M, N in Hj; lia.
Qed.

(* Convergence: delays of at most D stretch one contraction over D + 1 steps. *)
Definition delayed_error (k i : nat) : R := target p N i - getx (X k) i.

Lemma delayed_error_inner : forall k i, (S i < M)%nat ->
  delayed_error (S k) (S i) =
  p_eps p * delayed_error (k - delay k (S i) i) i + (1 - 2 * p_eps p) * delayed_error k (S i)
  + p_eps p * delayed_error (k - delay k (S i) (S (S i))) (S (S i)).
Proof.
  intros k i Hi; unfold delayed_error; rewrite delayed_inner by exact Hi.
  rewrite !target_line; fold M; pose proof (line_middle (p_min p) (p_max p) M i); nra.
Qed.

Lemma delayed_error_ends : forall k, delayed_error k O = 0 /\ delayed_error k M = 0.
Proof.
  intros k; destruct (delayed_ends k) as [B0 BM].
  rewrite (delayed_count p delay X HX k) in BM; fold N in BM; fold M in BM.
  unfold delayed_error, getx; rewrite B0, BM, !target_line; fold M.
  rewrite line_first, line_last by (unfold M, N; lia); split; ring.
Qed.

Definition delayed_ratio : R := internal_ratio M (delayed_error O) (weight M).

Theorem limit_rate_delayed : forall D, 0 < p_eps p <= 1/2 ->
  (forall k i j, (delay k i j <= D)%nat) ->
  forall m k, (m * (D + 1) <= k)%nat -> forall i, (i <= M)%nat ->
  Rabs (delayed_error k i) <= rate M (p_eps p) ^ m * (delayed_ratio * weight M i).
Proof.
  intros D He HD.
  assert (HM : (2 <= M)%nat) by (unfold M, N; lia).
  pose proof (rate_range M (p_eps p) HM He) as Hr.
  assert (HC : 0 <= delayed_ratio) by apply max_ratio_nonneg.
  assert (HW : forall i, 0 <= weight M i)
    by (intros i; unfold weight; apply Rmult_le_pos; apply pos_INR).
  assert (Hboth : forall m, 0 <= rate M (p_eps p) ^ m * delayed_ratio)
    by (intros m; apply Rmult_le_pos; [apply pow_le; lra|exact HC]).
  (* Bounds C*w on a window of D + 1 steps give r*C*w at the next step. *)
  assert (Next : forall C k, 0 <= C ->
    (forall l i, (k - D <= l <= k)%nat -> (i <= M)%nat -> Rabs (delayed_error l i) <= C * weight M i) ->
    forall i, (i <= M)%nat -> Rabs (delayed_error (S k) i) <= rate M (p_eps p) * C * weight M i).
  { intros C k HC' Hwin i Hi; destruct (delayed_error_ends (S k)) as [E0 EM].
    assert (Hpos : 0 <= rate M (p_eps p) * C * weight M i)
      by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply HW]).
    destruct (Nat.eq_dec i M) as [->|Hne]; [rewrite EM, Rabs_R0; exact Hpos|].
    destruct i as [|i]; [rewrite E0, Rabs_R0; exact Hpos|].
    rewrite delayed_error_inner by lia.
    pose proof (Hwin (k - delay k (S i) i)%nat i
                  ltac:(pose proof (HD k (S i) i); lia) ltac:(lia)) as P0.
    pose proof (Hwin k (S i) ltac:(lia) ltac:(lia)) as P1.
    pose proof (Hwin (k - delay k (S i) (S (S i)))%nat (S (S i))
                  ltac:(pose proof (HD k (S i) (S (S i))); lia) ltac:(lia)) as P2.
    pose proof (weight_contracts M (p_eps p) i ltac:(lra) ltac:(lia)) as Hw.
    eapply Rle_trans; [apply Rabs_triang|].
    eapply Rle_trans; [apply Rplus_le_compat_r, Rabs_triang|].
    rewrite !Rabs_mult.
    pose proof (Rabs_pos (p_eps p)) as Q0; pose proof (Rabs_pos (1 - 2 * p_eps p)) as Q1.
    apply (Rmult_le_compat_l _ _ _ Q0) in P0.
    apply (Rmult_le_compat_l _ _ _ Q1) in P1.
    apply (Rmult_le_compat_l _ _ _ Q0) in P2.
    apply (Rmult_le_compat_l _ _ _ HC') in Hw.
    lra. }
  induction m as [|m IH].
  - (* No contraction yet: C*w is an invariant barrier of the history. *)
    assert (All : forall k l i, (l <= k)%nat -> (i <= M)%nat ->
      Rabs (delayed_error l i) <= delayed_ratio * weight M i).
    { induction k as [|k IHk]; intros l i Hl Hi.
      - replace l with O by lia; unfold delayed_ratio; apply internal_ratio_bounds; auto;
          try apply delayed_error_ends.
        intros j Hj; apply weight_pos; exact Hj.
      - destruct (Nat.eq_dec l (S k)) as [->|Hne]; [|apply IHk; lia].
        apply Rle_trans with (rate M (p_eps p) * delayed_ratio * weight M i).
        + apply Next; auto; intros l' i' Hl' Hi'; apply IHk; lia.
        + apply Rmult_le_compat_r; [apply HW|].
          rewrite <- (Rmult_1_l delayed_ratio) at 2; apply Rmult_le_compat_r; lra. }
    intros k _ i Hi; simpl; rewrite Rmult_1_l; apply (All k k); lia.
  - intros k Hk i Hi; destruct k as [|k]; [lia|].
    simpl pow; rewrite (Rmult_assoc (rate M (p_eps p))), <- (Rmult_assoc _ delayed_ratio).
    rewrite <- Rmult_assoc; apply Next; auto.
    intros l j Hl Hj; rewrite Rmult_assoc; apply IH; lia.
Qed.

(* 7.8 with delays of at most D: every drone still converges to its target. *)
Theorem limit_delayed : forall D, 0 < p_eps p <= 1/2 ->
  (forall k i j, (delay k i j <= D)%nat) ->
  forall i, (i < N)%nat -> Un_cv (fun k => getx (X k) i) (target p N i).
Proof.
  intros D He HD i Hi; apply cv_abs; intros eps Heps.
  assert (HM : (2 <= M)%nat) by (unfold M, N; lia).
  assert (Hcv : Un_cv (fun m => rate M (p_eps p) ^ m * (delayed_ratio * weight M i)) 0).
  { apply geometric_cv with (r := rate M (p_eps p)) (C := Rabs (delayed_ratio * weight M i)).
    - apply rate_range; assumption.
    - intros m; rewrite Rminus_0_r, Rabs_mult.
      rewrite (Rabs_pos_eq (rate M (p_eps p) ^ m));
        [lra|apply pow_le, (rate_range M (p_eps p) HM He)]. }
  rewrite cv_abs in Hcv; destruct (Hcv eps Heps) as [m Hm].
  exists (m * (D + 1))%nat; intros k Hk.
  specialize (Hm m ltac:(lia)); rewrite Rminus_0_r in Hm.
  apply Rle_lt_trans with (2 := Hm); rewrite Rabs_minus_sym.
  eapply Rle_trans; [|apply Rle_abs].
  apply (limit_rate_delayed D He HD m k Hk i); unfold M; lia.
Qed.
End Bounds.

(* ---- Ordering fails ---- *)

Definition crossing_params : Params Q := mkParams 0%Q 1%Q (1 # 3)%Q 0.

Definition crossing_start : State Q :=
  mkState (0 :: (1 # 100) :: (98 # 100) :: (99 # 100) :: 1 :: nil)%Q 0.

(* Drones 1 and 2 see each other three steps late. *)
Definition crossing_delay (k i j : nat) : nat :=
  if ((i =? 1) && (j =? 2) || (i =? 2) && (j =? 1))%nat%bool then 3 else 0.

Theorem ordering_delayed_fails :
  (forall i, (i < 4)%nat ->
     (getx crossing_start i < getx crossing_start (i + 1))%Q) /\
  (getx (delayed_step crossing_params crossing_delay crossing_start 4) 2 <
   getx (delayed_step crossing_params crossing_delay crossing_start 4) 1)%Q /\
  (getx (delayed_step crossing_params crossing_delay crossing_start 3) 1 <
   getx (delayed_step crossing_params crossing_delay crossing_start 3) 2)%Q.
Proof.
  split; [|split; vm_compute; reflexivity].
  intros i Hi; do 4 (destruct i as [|i]; [vm_compute; reflexivity|]); lia.
Qed.
