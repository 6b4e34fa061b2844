(* Theorems 7.4 to 7.8 in ticks.  kth_step p s k is the placement after
   `updates` protocol steps, so each theorem about protocol steps is one about
   ticks.  The counter of s is anything within 0 .. n; both phases start there. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.UpperBound Proofs.Sum.
From Cordon Require Import Proofs.NonDecreasing Proofs.Increasing Proofs.FixedPoint.
From Cordon Require Import Proofs.Limit Proofs.ExactLimit.
Local Open Scope R_scope.

Lemma initial_counter : forall (T : Type) (x : DroneMap T) n phase,
  (timesteps (initial x n phase) <= n)%nat.
Proof. intros T x n [|]; simpl; lia. Qed.

(* ---- Counting ---- *)

(* Updates within the first k ticks of a run from s. *)
Definition updates_of (p : Params R) (s : State R) (k : nat) : nat :=
  updates (p_n p) (timesteps s) k.

(* Ticks from the k-th on that pass before the one with the next update. *)
Definition wait (p : Params R) (s : State R) (k : nat) : nat :=
  p_n p - (k + timesteps s) mod (p_n p + 1).

Lemma drones_of_tick : forall p (s : State R) k, (timesteps s <= p_n p)%nat ->
  drones (kth_step p s k) = drones (protocol_step p s (updates_of p s k)).
Proof. intros p s k Hc; apply kth_step_protocol_step; exact Hc. Qed.

Lemma updates_le : forall p (s : State R) k k', (k <= k')%nat ->
  (updates_of p s k <= updates_of p s k')%nat.
Proof. intros p s k k' Hk; unfold updates_of, updates; apply Nat.div_le_mono; lia. Qed.

Lemma updates_periods : forall p (s : State R) k h,
  updates_of p s (k + h * (p_n p + 1)) = (updates_of p s k + h)%nat.
Proof.
  intros p s k h; unfold updates_of, updates.
  replace (k + h * (p_n p + 1) + timesteps s)%nat with (k + timesteps s + h * (p_n p + 1))%nat by lia.
  apply Nat.div_add; lia.
Qed.

Lemma updates_waited : forall p (s : State R) k,
  updates_of p s (k + wait p s k) = updates_of p s k /\
  updates_of p s (k + wait p s k + 1) = S (updates_of p s k).
Proof.
  intros p s k; unfold updates_of, updates, wait.
  pose proof (Nat.div_mod (k + timesteps s) (p_n p + 1) ltac:(lia)) as Hdm.
  pose proof (Nat.mod_upper_bound (k + timesteps s) (p_n p + 1) ltac:(lia)) as Hub.
  set (q := ((k + timesteps s) / (p_n p + 1))%nat) in *.
  set (r := ((k + timesteps s) mod (p_n p + 1))%nat) in *.
  split; symmetry; [apply Nat.div_unique with (p_n p)|apply Nat.div_unique with 0%nat]; lia.
Qed.

(* ---- 7.4 ---- *)

Corollary sum_bounded_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  upper_bounded p (drones s) -> (timesteps s <= p_n p)%nat ->
  forall k, sum (drones (kth_step p s k)) <= sum_bound p (count (drones s)).
Proof. intros; rewrite drones_of_tick by assumption; apply sum_bounded_sharp; assumption. Qed.

Corollary sum_maximal_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  upper_bounded p (drones s) -> (timesteps s <= p_n p)%nat ->
  forall k, sum (drones (kth_step p s k)) = sum_bound p (count (drones s)) <->
            at_targets p (drones (kth_step p s k)).
Proof. intros; rewrite drones_of_tick by assumption; apply sum_maximal_sharp; assumption. Qed.

(* ---- 7.5 ---- *)

Corollary sum_non_decreasing_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  upper_bounded p (drones s) -> (timesteps s <= p_n p)%nat ->
  forall k h, sum (drones (kth_step p s k)) <= sum (drones (kth_step p s (k + h))).
Proof.
  intros p s Hn Ha He Hu Hc k h; rewrite !drones_of_tick by exact Hc.
  pose proof (updates_le p s k (k + h) ltac:(lia)) as Hle.
  replace (updates_of p s (k + h)) with (updates_of p s k + (updates_of p s (k + h) - updates_of p s k))%nat by lia.
  apply sum_monotone; assumption.
Qed.

Corollary sum_stationary_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> (timesteps s <= p_n p)%nat ->
  forall k, at_targets p (drones (kth_step p s k)) ->
  sum (drones (kth_step p s (k + 1))) = sum (drones (kth_step p s k)).
Proof.
  intros p s Hn Hc k; rewrite !drones_of_tick by exact Hc; intros Ht.
  pose proof (updates_le p s k (k + 1) ltac:(lia)) as Hle.
  replace (updates_of p s (k + 1)) with (updates_of p s k + (updates_of p s (k + 1) - updates_of p s k))%nat by lia.
  rewrite targets_fixed_sharp by assumption; reflexivity.
Qed.

(* ---- 7.6 ---- *)

Corollary targets_fixed_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> (timesteps s <= p_n p)%nat ->
  forall k, at_targets p (drones (kth_step p s k)) ->
  forall h, drones (kth_step p s (k + h)) = drones (kth_step p s k).
Proof.
  intros p s Hn Hc k; rewrite drones_of_tick by exact Hc; intros Ht h.
  rewrite drones_of_tick by exact Hc.
  pose proof (updates_le p s k (k + h) ltac:(lia)) as Hle.
  replace (updates_of p s (k + h)) with (updates_of p s k + (updates_of p s (k + h) - updates_of p s k))%nat by lia.
  apply targets_fixed_sharp; assumption.
Qed.

(* ceil((N-2)/2) periods of equal sums are enough. *)
Corollary constant_sum_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 < p_eps p <= 1/2 ->
  upper_bounded p (drones s) -> (timesteps s <= p_n p)%nat -> forall k,
  (forall h, (1 <= h <= (count (drones s) - 2 + 1) / 2 * (p_n p + 1))%nat ->
     sum (drones (kth_step p s (k + h))) = sum (drones (kth_step p s k))) ->
  at_targets p (drones (kth_step p s k)).
Proof.
  intros p s Hn Ha He Hu Hc k Hsum; rewrite drones_of_tick by exact Hc.
  apply constant_sum_bounded; auto; intros h Hh; unfold c.
  assert (Hrange : (1 <= h * (p_n p + 1) <= (count (drones s) - 2 + 1) / 2 * (p_n p + 1))%nat) by nia.
  specialize (Hsum (h * (p_n p + 1))%nat Hrange).
  rewrite !drones_of_tick, updates_periods in Hsum by exact Hc; exact Hsum.
Qed.

(* ---- 7.7 ---- *)

(* The sum stays through the tick before the (h+1)-th update to come, and
   increases in the tick of that update. *)
Corollary increasing_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 < p_eps p <= 1/2 ->
  upper_bounded p (drones s) -> (timesteps s <= p_n p)%nat ->
  forall k h j,
  let N := count (drones s) in
  let off i := (i < N)%nat /\ ~ at_target p (drones (kth_step p s k)) i in
  let before := (k + wait p s k + h * (p_n p + 1))%nat in
  off j -> depth N j = S h -> (forall i, off i -> (S h <= depth N i)%nat) ->
  (forall t, (k <= t <= before)%nat -> sum (drones (kth_step p s t)) = sum (drones (kth_step p s k))) /\
  sum (drones (kth_step p s before)) < sum (drones (kth_step p s (before + 1))).
Proof.
  intros p s Hn Ha He Hu Hc k h j N off before Hj Hd Hleast.
  assert (Hbefore : updates_of p s before = (updates_of p s k + h)%nat).
  { unfold before; rewrite updates_periods, (proj1 (updates_waited p s k)); reflexivity. }
  assert (Hafter : updates_of p s (before + 1) = (updates_of p s k + h + 1)%nat).
  { unfold before.
    replace (k + wait p s k + h * (p_n p + 1) + 1)%nat
      with (k + wait p s k + 1 + h * (p_n p + 1))%nat by lia.
    rewrite updates_periods, (proj2 (updates_waited p s k)); lia. }
  destruct (increasing_sharp p s Hn Ha He Hu (updates_of p s k) h j) as [Hstay Hup].
  - destruct Hj as [HjN Hjoff]; rewrite drones_of_tick in Hjoff by exact Hc; split; assumption.
  - exact Hd.
  - intros i [Hi Hoff]; apply Hleast; split; [exact Hi|].
    rewrite drones_of_tick by exact Hc; exact Hoff.
  - unfold c in Hstay, Hup; split.
    + intros t Ht; rewrite !drones_of_tick by exact Hc.
      pose proof (updates_le p s k t ltac:(lia)); pose proof (updates_le p s t before ltac:(lia)).
      replace (updates_of p s t) with (updates_of p s k + (updates_of p s t - updates_of p s k))%nat by lia.
      apply Hstay; lia.
    + rewrite !drones_of_tick, Hbefore, Hafter by exact Hc; exact Hup.
Qed.

(* ---- 7.8 ---- *)

(* The error e_i = T_i - X_i after k ticks. *)
Definition tick_error (p : Params R) (s : State R) (k i : nat) : R :=
  target p (count (drones s)) i - get (drones (kth_step p s k)) i.

Lemma tick_error_error : forall p (s : State R) k i, (timesteps s <= p_n p)%nat ->
  tick_error p s k i = error p s (updates_of p s k) i.
Proof. intros; unfold tick_error, error; rewrite drones_of_tick by assumption; reflexivity. Qed.

Corollary limit_rate_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 < p_eps p <= 1/2 ->
  (timesteps s <= p_n p)%nat -> forall k i, (i < count (drones s))%nat ->
  Rabs (tick_error p s k i) <=
    rate (count (drones s) - 1) (p_eps p) ^ updates (p_n p) (timesteps s) k * initial_ratio p s
    * INR (contraction_weight (count (drones s)) i).
Proof. intros; rewrite tick_error_error by assumption; apply limit_rate; assumption. Qed.

Corollary limit_exact_rate_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p ->
  (timesteps s <= p_n p)%nat -> forall k i, (i < count (drones s))%nat ->
  Rabs (tick_error p s k i) <=
    spectral_radius (count (drones s) - 1) (p_eps p) ^ updates (p_n p) (timesteps s) k
    * initial_wave_ratio p s * wave (count (drones s) - 1) i.
Proof. intros; rewrite tick_error_error by assumption; apply limit_exact_rate; assumption. Qed.

(* What converges in ticks converges in protocol steps: every step is reached. *)
Lemma limit_steps_of_ticks : forall p (s : State R) i l, (timesteps s <= p_n p)%nat ->
  Un_cv (fun k => get (drones (kth_step p s k)) i) l ->
  Un_cv (fun k => get (drones (protocol_step p s k)) i) l.
Proof.
  intros p s i l Hc Hcv eps Heps; destruct (Hcv eps Heps) as [K HK].
  exists K; intros k Hk; specialize (HK (k * (p_n p + 1))%nat ltac:(nia)).
  rewrite drones_of_tick in HK by exact Hc.
  replace (k * (p_n p + 1))%nat with (0 + k * (p_n p + 1))%nat in HK by lia.
  rewrite updates_periods in HK.
  assert (Hz : (updates_of p s 0 = 0)%nat) by (apply Nat.div_small; simpl; lia).
  rewrite Hz in HK; exact HK.
Qed.

(* 7.8 as an equivalence, in ticks, for either phase. *)
Corollary limit_iff_ticks : forall p N phase, (3 <= N)%nat ->
  ((forall x : DroneMap R, count x = N -> anchored p x -> forall i, (i < N)%nat ->
      Un_cv (fun k => get (drones (kth_step p (initial x (p_n p) phase) k)) i) (target p N i))
   <-> 0 < p_eps p < critical_weight N).
Proof.
  intros p N phase HN; rewrite <- (limit_iff p N HN); split; intros H.
  - intros s Hs Ha i Hi.
    pose proof (limit_steps_of_ticks p (initial (drones s) (p_n p) phase) i (target p N i)
      (initial_counter _ _ _ _) (H (drones s) Hs Ha i Hi)) as Hcv.
    intros eps Heps; destruct (Hcv eps Heps) as [K HK]; exists K; intros k Hk.
    specialize (HK k Hk); rewrite protocol_step_iterate in HK |- *; exact HK.
  - intros x Hx Ha i Hi; apply limit_ticks_of_steps; [apply initial_counter|].
    apply H; assumption.
Qed.
