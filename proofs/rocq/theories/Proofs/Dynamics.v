(* One update of the swarm as a relation between two sequences of positions,
   and its two linear pictures: gaps and errors.  Here M = N - 1 is the number
   of the last drone.  Every theorem is proved on this relation and then read
   back on the spec. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis Spec.Theorems.UpperBound.
From Cordon Require Import Proofs.Real.
Local Open Scope R_scope.

(* Drone i moves with a weight a i of its own: 0 when it skips the update. *)
Record weighted (M : nat) (a x y : nat -> R) : Prop := {
  weighted_first : y O = x O;
  weighted_last : y M = x M;
  weighted_inner : forall i, (S i < M)%nat ->
    y (S i) = x (S i) + a (S i) * (x i - 2 * x (S i) + x (S (S i)))
}.

(* All internal drones move with the same weight e. *)
Record step (M : nat) (e : R) (x y : nat -> R) : Prop := {
  step_first : y O = x O;
  step_last : y M = x M;
  step_inner : forall i, (S i < M)%nat ->
    y (S i) = e * x i + (1 - 2 * e) * x (S i) + e * x (S (S i))
}.

Definition run (M : nat) (e : R) (X : nat -> nat -> R) : Prop :=
  forall k, step M e (X k) (X (S k)).

Lemma step_weighted : forall M e x y, step M e x y -> weighted M (fun _ => e) x y.
Proof.
  intros M e x y [H0 HM Hi]; split; auto.
  intros i Hlt; rewrite (Hi i Hlt); ring.
Qed.

Lemma run_shift : forall M e X k, run M e X -> run M e (fun j => X (k + j)%nat).
Proof.
  intros M e X k H j; specialize (H (k + j)%nat).
  rewrite <- plus_n_Sm; exact H.
Qed.

Lemma run_ends : forall M e X, run M e X -> forall k, X k O = X O O /\ X k M = X O M.
Proof.
  intros M e X H k; induction k as [|k [IH0 IHM]]; [split; reflexivity|].
  rewrite (step_first _ _ _ _ (H k)), (step_last _ _ _ _ (H k)); split; assumption.
Qed.

(* ---- Errors ---- *)

(* The straight line from x 0 to x M: where the drones are sent. *)
Definition line (lo hi : R) (M i : nat) : R := lo + INR i * ((hi - lo) / INR M).

Lemma line_first : forall lo hi M, line lo hi M 0 = lo.
Proof. intros; unfold line; simpl; ring. Qed.

Lemma line_last : forall lo hi M, (0 < M)%nat -> line lo hi M M = hi.
Proof.
  intros lo hi M HM; unfold line; assert (0 < INR M) by (apply INR_pos; lia).
  field; lra.
Qed.

Lemma line_middle : forall lo hi M i,
  2 * line lo hi M (S i) = line lo hi M i + line lo hi M (S (S i)).
Proof. intros; unfold line; rewrite !S_INR; ring. Qed.

Lemma step_line : forall M e lo hi, step M e (line lo hi M) (line lo hi M).
Proof.
  intros M e lo hi; split; try reflexivity.
  intros i _; pose proof (line_middle lo hi M i); nra.
Qed.

Definition err (lo hi : R) (M : nat) (x : nat -> R) (i : nat) : R := line lo hi M i - x i.

Lemma step_err : forall M e lo hi x y, step M e x y -> step M e (err lo hi M x) (err lo hi M y).
Proof.
  intros M e lo hi x y [H0 HM Hi]; unfold err; split.
  - rewrite H0; reflexivity.
  - rewrite HM; reflexivity.
  - intros i Hlt; rewrite (Hi i Hlt); pose proof (line_middle lo hi M i); nra.
Qed.

(* ---- Reading back on the spec ---- *)

(* Positions after k protocol steps, as a function of step and drone. *)
Definition positions (p : Params R) (s : State R) (k i : nat) : R :=
  get (drones (protocol_step p s k)) i.

Lemma exec_coverage_step : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) ->
  step (count (drones s) - 1) (p_eps p) (get (drones s)) (get (drones (exec_coverage p s))).
Proof.
  intros p s Hn [H0 HM]; split.
  - rewrite get_exec_first by lia; symmetry; exact H0.
  - rewrite get_exec_last by lia; symmetry; exact HM.
  - intros i Hi.
    replace (S i) with (i + 1)%nat by lia.
    rewrite get_exec_inner by lia.
    replace (S (i + 1)) with (i + 2)%nat by lia; reflexivity.
Qed.

Lemma anchored_exec : forall p (s : State R),
  (2 <= count (drones s))%nat -> anchored p (drones (exec_coverage p s)).
Proof.
  intros p s Hn; split.
  - apply get_exec_first; lia.
  - rewrite count_exec_coverage; apply get_exec_last; lia.
Qed.

Lemma anchored_step : forall p (s : State R) k,
  (2 <= count (drones s))%nat -> anchored p (drones s) ->
  anchored p (drones (protocol_step p s k)).
Proof.
  intros p s k Hn Ha; induction k as [|k IH]; [exact Ha|].
  simpl; apply anchored_exec; rewrite count_protocol_step; exact Hn.
Qed.

Lemma positions_run : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) ->
  run (count (drones s) - 1) (p_eps p) (positions p s).
Proof.
  intros p s Hn Ha k; unfold positions; simpl.
  rewrite <- (count_protocol_step _ _ p s k).
  apply exec_coverage_step.
  - rewrite count_protocol_step; exact Hn.
  - apply anchored_step; [lia|exact Ha].
Qed.

Lemma target_line : forall p N i,
  target p N i = line (p_min p) (p_max p) (N - 1) i.
Proof. reflexivity. Qed.

(* ---- Ticks ---- *)

(* How many updates k ticks contain, when the counter starts at c. *)
Definition updates (n c k : nat) : nat := (k + c) / (n + 1).

Fixpoint iterate {A : Type} (f : A -> A) (x : A) (k : nat) : A :=
  match k with
  | O => x
  | S k' => f (iterate f x k')
  end.

(* tick_with applied k times. *)
Fixpoint ticks {T : Type} (n : nat) (protocol : DroneMap T -> DroneMap T) (s : State T) (k : nat)
  : State T :=
  match k with
  | O => s
  | S k' => tick_with (ticks n protocol s k') n protocol
  end.

(* The period of the paper's Listing 4 is n + 1 ticks; with the counter at c
   the first update is in tick n + 1 - c.  For any protocol: coverage,
   consensus, formation. *)
Theorem ticks_iterate : forall (T : Type) n (f : DroneMap T -> DroneMap T) (s : State T) k,
  (timesteps s <= n)%nat ->
  drones (ticks n f s k) = iterate f (drones s) (updates n (timesteps s) k) /\
  timesteps (ticks n f s k) = ((k + timesteps s) mod (n + 1))%nat.
Proof.
  intros T n f s k Hc; set (c := timesteps s) in *.
  unfold updates; induction k as [|k [IHd IHt]].
  - rewrite Nat.div_small, Nat.mod_small by lia; split; reflexivity.
  - simpl ticks; unfold tick_with; rewrite IHt.
    pose proof (Nat.div_mod (k + c) (n + 1) ltac:(lia)) as Hdm.
    pose proof (Nat.mod_upper_bound (k + c) (n + 1) ltac:(lia)) as Hub.
    set (q := ((k + c) / (n + 1))%nat) in *; set (r := ((k + c) mod (n + 1))%nat) in *.
    destruct (Nat.eqb_spec r n) as [E|E].
    + assert (Hq : ((S k + c) / (n + 1) = S q)%nat)
        by (symmetry; apply Nat.div_unique with 0%nat; lia).
      assert (Hr : ((S k + c) mod (n + 1) = 0)%nat)
        by (symmetry; apply Nat.mod_unique with (S q); lia).
      rewrite Hq, Hr; split; [|reflexivity].
      cbn [drones iterate]; rewrite IHd; reflexivity.
    + assert (Hq : ((S k + c) / (n + 1) = q)%nat)
        by (symmetry; apply Nat.div_unique with (S r); lia).
      assert (Hr : ((S k + c) mod (n + 1) = S r)%nat)
        by (symmetry; apply Nat.mod_unique with q; lia).
      rewrite Hq, Hr; cbn [drones timesteps]; split; [exact IHd|lia].
Qed.

Lemma kth_step_ticks : forall (T : Type) (K : Scalar T) p (s : State T) k,
  kth_step p s k = ticks (p_n p) (next_placement p) s k.
Proof.
  intros T K p s k; induction k as [|k IH]; [reflexivity|].
  simpl; rewrite IH; reflexivity.
Qed.

Lemma protocol_step_iterate : forall (T : Type) (K : Scalar T) p (s : State T) k,
  drones (protocol_step p s k) = iterate (next_placement p) (drones s) k.
Proof.
  intros T K p s k; induction k as [|k IH]; [reflexivity|].
  simpl; rewrite IH; reflexivity.
Qed.

(* The same of coverage, as Listing 4 has it. *)
Theorem kth_step_protocol_step : forall (T : Type) (K : Scalar T) p (s : State T) k,
  (timesteps s <= p_n p)%nat ->
  drones (kth_step p s k) = drones (protocol_step p s (updates (p_n p) (timesteps s) k)) /\
  timesteps (kth_step p s k) = ((k + timesteps s) mod (p_n p + 1))%nat.
Proof.
  intros T K p s k Hc; rewrite kth_step_ticks, protocol_step_iterate.
  apply ticks_iterate; exact Hc.
Qed.

(* With n = 0 every tick is a protocol step. *)
Corollary kth_step_every_tick : forall (T : Type) (K : Scalar T) p (s : State T) k,
  p_n p = 0%nat -> timesteps s = 0%nat ->
  drones (kth_step p s k) = drones (protocol_step p s k).
Proof.
  intros T K p s k Hn Hs; destruct (kth_step_protocol_step T K p s k) as [-> _]; [lia|].
  unfold updates; rewrite Hn, Hs, Nat.add_0_r; simpl Nat.add; rewrite Nat.div_1_r; reflexivity.
Qed.

(* Whatever the counter, ticks reach only placements that protocol steps reach:
   an invariant of protocol steps is an invariant of ticks. *)
Theorem kth_step_reaches : forall (T : Type) (K : Scalar T) p (s : State T) k,
  exists j, drones (kth_step p s k) = drones (protocol_step p s j).
Proof.
  intros T K p s k; induction k as [|k [j IH]]; [exists 0%nat; reflexivity|].
  simpl kth_step; rewrite !tick_eq; destruct (Nat.eqb _ _); cbn [drones].
  - exists (S j); cbn [protocol_step exec_coverage drones]; rewrite IH; reflexivity.
  - exists j; exact IH.
Qed.

(* Every protocol step is reached: after (j - 1) further periods. *)
Lemma updates_unbounded : forall n c j, exists k0, forall k, (k0 <= k)%nat -> (j <= updates n c k)%nat.
Proof.
  intros n c j; exists (j * (n + 1))%nat; intros k Hk; unfold updates.
  apply Nat.div_le_lower_bound; lia.
Qed.
