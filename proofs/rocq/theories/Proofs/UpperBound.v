(* Theorem 7.3, the reference position upper bound, in its sharp form, its
   mirror image, the box, and why 1/2 cannot be improved. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis Spec.Theorems.UpperBound.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.Ordering.
Local Open Scope R_scope.

(* An upper barrier: any b that is concave in the drone's number stays an upper
   bound, drone by drone, for weights between 0 and 1/2.  The targets (a straight
   line), the constant max and the contraction weights are such barriers. *)
Definition concave (M : nat) (b : nat -> R) : Prop :=
  forall i, (S i < M)%nat -> b i + b (S (S i)) <= 2 * b (S i).

Definition below (M : nat) (x b : nat -> R) : Prop := forall i, (i <= M)%nat -> x i <= b i.

Lemma below_weighted : forall M a x y b, weighted M a x y ->
  (forall i, (0 < i < M)%nat -> 0 <= a i <= 1/2) ->
  concave M b -> below M x b -> below M y b.
Proof.
  intros M a x y b [H0 HL Hi] Ha Hb Hx i HiM.
  destruct (Nat.eq_dec i M) as [->|Hne]; [rewrite HL; apply Hx; lia|].
  destruct i as [|i]; [rewrite H0; apply Hx; lia|].
  rewrite (Hi i) by lia.
  specialize (Ha (S i) ltac:(lia)); specialize (Hb i ltac:(lia)).
  pose proof (Hx i ltac:(lia)) as X0; pose proof (Hx (S i) ltac:(lia)) as X1.
  pose proof (Hx (S (S i)) ltac:(lia)) as X2.
  assert (a (S i) * (x i + x (S (S i))) <= a (S i) * (2 * b (S i)))
    by (apply Rmult_le_compat_l; lra).
  assert ((1 - 2 * a (S i)) * x (S i) <= (1 - 2 * a (S i)) * b (S i))
    by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

Lemma below_run : forall M e X b, run M e X -> 0 <= e <= 1/2 -> concave M b ->
  below M (X O) b -> forall k, below M (X k) b.
Proof.
  intros M e X b HX He Hb H0 k; induction k as [|k IH]; [exact H0|].
  apply below_weighted with (a := fun _ => e) (x := X k); auto.
  apply step_weighted, HX.
Qed.

(* Lower bounds are upper bounds of the mirrored swarm. *)
Lemma weighted_opp : forall M a x y, weighted M a x y ->
  weighted M a (fun i => - x i) (fun i => - y i).
Proof.
  intros M a x y [H0 HL Hi]; split.
  - rewrite H0; reflexivity.
  - rewrite HL; reflexivity.
  - intros i Hlt; rewrite (Hi i Hlt); ring.
Qed.

Lemma step_opp : forall M e x y, step M e x y -> step M e (fun i => - x i) (fun i => - y i).
Proof.
  intros M e x y [H0 HL Hi]; split.
  - rewrite H0; reflexivity.
  - rewrite HL; reflexivity.
  - intros i Hlt; rewrite (Hi i Hlt); ring.
Qed.

Lemma run_opp : forall M e X, run M e X -> run M e (fun k i => - X k i).
Proof. intros M e X HX k; apply step_opp, HX. Qed.

Lemma concave_line : forall lo hi M, concave M (line lo hi M).
Proof. intros lo hi M i _; pose proof (line_middle lo hi M i); lra. Qed.

Lemma concave_opp_line : forall lo hi M, concave M (fun i => - line lo hi M i).
Proof. intros lo hi M i _; pose proof (line_middle lo hi M i); lra. Qed.

Lemma concave_const : forall c M, concave M (fun _ => c).
Proof. intros c M i _; lra. Qed.

(* ---- On the spec ---- *)

Lemma upper_bounded_below : forall p (x : DroneMap R), (1 < count x)%nat ->
  (upper_bounded p x <->
   below (count x - 1) (get x) (line (p_min p) (p_max p) (count x - 1))).
Proof.
  intros p x Hx; rewrite upper_bounded_iff by exact Hx; unfold below; split; intros H i Hi;
    [rewrite <- target_line; apply H; lia|rewrite target_line; apply H; lia].
Qed.

Lemma above_targets_below : forall p (x : DroneMap R), (1 < count x)%nat ->
  (above_targets p x <->
   below (count x - 1) (fun i => - get x i)
         (fun i => - line (p_min p) (p_max p) (count x - 1) i)).
Proof.
  intros p x Hx; rewrite above_targets_iff by exact Hx; unfold below; split; intros H i Hi.
  - rewrite <- target_line; apply Ropp_le_contravar, H; lia.
  - rewrite target_line; apply Ropp_le_cancel, H; lia.
Qed.

(* 7.3, sharp: UB is preserved for 0 <= eps <= 1/2. *)
Theorem upper_bound_sharp : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  upper_bounded p (drones s) -> forall k, upper_bounded p (drones (protocol_step p s k)).
Proof.
  intros p s Hn Ha He Hu k.
  apply upper_bounded_below; rewrite count_protocol_step; [lia|].
  apply below_run with (e := p_eps p) (X := positions p s).
  - apply positions_run; assumption.
  - exact He.
  - apply concave_line.
  - apply upper_bounded_below; [lia|exact Hu].
Qed.

(* The mirror image. *)
Theorem lower_bound_sharp : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  above_targets p (drones s) -> forall k, above_targets p (drones (protocol_step p s k)).
Proof.
  intros p s Hn Ha He Hu k.
  apply above_targets_below; rewrite count_protocol_step; [lia|].
  apply below_run with (e := p_eps p) (X := fun k i => - positions p s k i).
  - apply run_opp, positions_run; assumption.
  - exact He.
  - apply concave_opp_line.
  - apply above_targets_below; [lia|exact Hu].
Qed.

(* The box. *)
Theorem box_sharp : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  in_box p (drones s) -> forall k, in_box p (drones (protocol_step p s k)).
Proof.
  intros p s Hn Ha He Hb k.
  pose proof (positions_run p s Hn Ha) as HX.
  assert (Hhi : below (count (drones s) - 1) (positions p s k) (fun _ => p_max p)).
  { apply below_run with (e := p_eps p) (X := positions p s); auto.
    - apply concave_const.
    - intros i Hi; apply Hb; lia. }
  assert (Hlo : below (count (drones s) - 1) (fun i => - positions p s k i) (fun _ => - p_min p)).
  { apply below_run with (e := p_eps p) (X := fun k i => - positions p s k i); auto.
    - apply run_opp, HX.
    - apply concave_const.
    - intros i Hi; apply Ropp_le_contravar, Hb; lia. }
  intros i Hi; rewrite count_protocol_step in Hi; simpl; split.
  - apply Ropp_le_cancel, Hlo; lia.
  - apply Hhi; lia.
Qed.

(* In ticks, whatever the period and the counter. *)
Theorem upper_bound_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  upper_bounded p (drones s) -> forall k, upper_bounded p (drones (kth_step p s k)).
Proof.
  intros p s Hn Ha He Hu k; destruct (kth_step_reaches _ _ p s k) as [j ->].
  apply upper_bound_sharp; assumption.
Qed.

Theorem lower_bound_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  above_targets p (drones s) -> forall k, above_targets p (drones (kth_step p s k)).
Proof.
  intros p s Hn Ha He Hu k; destruct (kth_step_reaches _ _ p s k) as [j ->].
  apply lower_bound_sharp; assumption.
Qed.

Theorem box_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  in_box p (drones s) -> forall k, in_box p (drones (kth_step p s k)).
Proof.
  intros p s Hn Ha He Hu k; destruct (kth_step_reaches _ _ p s k) as [j ->].
  apply box_sharp; assumption.
Qed.

(* Assumption 3 implies UB, order or not, on a segment that is not reversed. *)
Theorem first_subsegment_upper_bounded : forall p (x : DroneMap R),
  (3 <= count x)%nat -> p_min p <= p_max p -> anchored p x ->
  in_first_subsegment p x -> upper_bounded p x.
Proof.
  intros p x Hn Hseg [H0 HL] Hf.
  apply upper_bounded_iff; [lia|]; intros i Hi.
  pose proof (proj1 (in_first_subsegment_iff p x ltac:(lia)) Hf) as Hf'.
  destruct (Nat.eq_dec i (count x - 1)) as [E|E].
  - rewrite E, HL, target_line, line_last by lia; lra.
  - destruct i as [|i]; [rewrite H0; unfold target; simpl; lra|].
    specialize (Hf' (S i) ltac:(lia) ltac:(lia)).
    assert (0 <= spacing p (count x)).
    { unfold spacing; apply Rmult_le_pos; [lra|].
      apply Rlt_le, Rinv_0_lt_compat, INR_pos; lia. }
    unfold target; rewrite S_INR.
    assert (0 <= INR i * spacing p (count x)) by (apply Rmult_le_pos; [apply pos_INR|lra]).
    lra.
Qed.

(* 7.3 under the paper's hypothesis: assumption 3 and eps < 1/2. *)
Corollary upper_bound_paper : forall p (s : State R),
  (3 <= count (drones s))%nat -> p_min p < p_max p -> anchored p (drones s) ->
  0 <= p_eps p < 1/2 -> in_first_subsegment p (drones s) ->
  forall k, upper_bounded p (drones (kth_step p s k)).
Proof.
  intros p s Hn Hseg Ha He Hf; apply upper_bound_ticks; auto; [lra|].
  apply first_subsegment_upper_bounded; auto; lra.
Qed.

(* ---- Exactness ---- *)

(* For N >= 3 and every eps > 1/2, on every segment: a start that is ordered,
   inside the box and UB, and violates UB after one update.  Drone 1 is half a
   spacing behind its target, every other drone at its target. *)
Definition late_first (lo hi : R) (M i : nat) : R :=
  if Nat.eqb i 1 then lo + (hi - lo) / INR M / 2 else line lo hi M i.

Theorem upper_bound_exact : forall p N,
  (3 <= N)%nat -> p_min p < p_max p -> 1/2 < p_eps p ->
  exists s : State R,
    count (drones s) = N /\ anchored p (drones s) /\ ordered (drones s) /\
    upper_bounded p (drones s) /\ ~ upper_bounded p (drones (exec_coverage p s)).
Proof.
  intros p N Hn Hseg He.
  set (lo := p_min p) in *; set (hi := p_max p) in *; set (e := p_eps p) in *.
  set (M := (N - 1)%nat).
  assert (HM : 0 < INR M) by (apply INR_pos; lia).
  assert (Hl : 0 < (hi - lo) / INR M) by (apply Rdiv_lt_0_compat; lra).
  exists (start_of p N (late_first lo hi M)).
  pose proof (count_start p N (late_first lo hi M)) as Hc.
  assert (X1 : late_first lo hi M 1 = lo + (hi - lo) / INR M / 2) by reflexivity.
  assert (XI : forall i, i <> 1%nat -> late_first lo hi M i = line lo hi M i).
  { intros i Hi; unfold late_first; rewrite (proj2 (Nat.eqb_neq i 1) Hi); reflexivity. }
  assert (L1 : line lo hi M 1 = lo + (hi - lo) / INR M) by (unfold line; simpl; ring).
  assert (LS : forall i, line lo hi M (S i) = line lo hi M i + (hi - lo) / INR M)
    by (intros i; unfold line; rewrite S_INR; ring).
  split; [exact Hc|split; [|split; [|split]]].
  - split; rewrite ?Hc, get_start by lia.
    + rewrite XI by lia; apply line_first.
    + fold M; rewrite XI by lia; apply line_last; lia.
  - intros i Hi; rewrite Hc in Hi; rewrite !get_start by lia; simpl.
    rewrite Nat.add_1_r.
    destruct (Nat.eq_dec i 0) as [->|E0].
    + rewrite X1, XI, line_first by lia; lra.
    + rewrite (XI (S i)), LS by lia.
      destruct (Nat.eq_dec i 1) as [->|E1]; [rewrite X1, L1; lra|rewrite XI by lia; lra].
  - apply upper_bounded_below; rewrite Hc; [lia|]; fold M; intros i Hi.
    rewrite get_start by lia.
    destruct (Nat.eq_dec i 1) as [->|E1]; [fold lo hi; rewrite X1, L1; lra|].
    rewrite XI by lia; fold lo hi; lra.
  - intros Hu.
    pose proof (proj1 (upper_bounded_below p _ ltac:(rewrite count_exec_coverage, Hc; lia)) Hu) as Hb.
    rewrite count_exec_coverage, Hc in Hb; fold M in Hb.
    specialize (Hb 1%nat ltac:(lia)); fold lo hi in Hb.
    pose proof (get_exec_inner p (start_of p N (late_first lo hi M)) 0) as E1.
    rewrite Hc in E1; specialize (E1 ltac:(lia)); simpl Nat.add in E1.
    rewrite !get_start in E1 by lia.
    rewrite E1, X1, (XI 0%nat), (XI 2%nat), line_first, (LS 1%nat), L1 in Hb by lia.
    fold e in Hb.
    assert (0 < (2 * e - 1) * ((hi - lo) / INR M)) by (apply Rmult_lt_0_compat; lra).
    lra.
Qed.
