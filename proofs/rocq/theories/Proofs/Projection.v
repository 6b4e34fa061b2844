(* The projection theorem: N local machines that exchange their positions after
   every tick compute exactly the global kth_step.  Over any Scalar: no law of
   arithmetic is used. *)
From Coq Require Import Arith Lia List ZArith.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Local.
From Cordon Require Import Proofs.Real Proofs.Dynamics.

Section Projection.
Context {T : Type} `{Scalar T}.

(* swarm_tick applied k times. *)
Fixpoint swarm_kth_step (p : LocalParams T) (start : DroneMap (SimState T)) (k : nat)
  : DroneMap (SimState T) :=
  match k with
  | 0 => start
  | S k' => swarm_tick p (swarm_kth_step p start k')
  end.

(* All local machines that agree with a global state. *)
Definition swarm_of (p : Params T) (s : State T) : DroneMap (SimState T) :=
  lambda (count (drones s)) (project p s).

Lemma lambda_ext : forall (A : Type) n (f g : nat -> A),
  (forall i, i < n -> f i = g i) -> lambda n f = lambda n g.
Proof.
  intros A n f g Hfg; unfold lambda; apply map_ext_in; intros i Hi.
  apply in_seq in Hi; apply Hfg; lia.
Qed.

Lemma machine_lambda : forall n (f : nat -> SimState T) i, i < n -> machine (lambda n f) i = f i.
Proof.
  intros n f i Hi; unfold machine, lambda.
  rewrite (nth_indep _ _ (f 0)) by (rewrite map_len, seq_len; exact Hi).
  rewrite map_nth, seq_nth by exact Hi; reflexivity.
Qed.

(* The local counter fires where the global one does: at the quotient rounded up. *)
Lemma reached_by_counter_limit : forall r t, 0 < den r -> t <= counter_limit r ->
  reached_by r t = (t =? counter_limit r).
Proof.
  intros r t Hden Ht; unfold reached_by.
  pose proof (Nat.div_mod (num r + (den r - 1)) (den r) ltac:(lia)) as Hdm.
  pose proof (Nat.mod_upper_bound (num r + (den r - 1)) (den r) ltac:(lia)) as Hub.
  fold (counter_limit r) in Hdm.
  set (n := counter_limit r) in *.
  destruct (Nat.eqb_spec t n) as [->|Hne].
  - apply Nat.leb_le; nia.
  - apply Nat.leb_gt; assert (t + 1 <= n) by lia; nia.
Qed.

(* One drone, one tick: its own position and its counter are the global ones. *)
Lemma fmu_tick_project : forall (p : LocalParams T) (s : State T) i,
  0 < den (ratio p) -> p_n (protocol p) = counter_limit (ratio p) ->
  local_count p = count (drones s) -> timesteps s <= p_n (protocol p) ->
  i < count (drones s) ->
  let l := fmu_tick p (project (protocol p) s i) in
  sim_timesteps l = timesteps (tick (protocol p) s) /\
  own (st l) = getx (tick (protocol p) s) i /\ id (st l) = i /\
  prec (st l) = prec (st (project (protocol p) s i)) /\
  foll (st l) = foll (st (project (protocol p) s i)).
Proof.
  intros p s i Hden Hn Hcount Ht Hi; unfold fmu_tick; rewrite !tick_eq.
  rewrite reached_by_counter_limit by (simpl; lia).
  simpl sim_timesteps; rewrite <- Hn.
  destruct (timesteps s =? p_n (protocol p)); [|repeat split; reflexivity].
  cbn [sim_timesteps st own id prec foll timesteps].
  repeat split.
  unfold getx at 1; cbn [drones]; unfold exec_coverage, next_placement; cbn [drones].
  rewrite get_lambda by exact Hi.
  unfold update, project, fmu_exec_cvg; cbn [st prec own foll id].
  rewrite Hcount.
  destruct (0 <? i); destruct (i + 1 <? count (drones s)); reflexivity.
Qed.

Lemma swarm_tick_of : forall (p : LocalParams T) (s : State T),
  0 < den (ratio p) -> p_n (protocol p) = counter_limit (ratio p) ->
  local_count p = count (drones s) -> timesteps s <= p_n (protocol p) ->
  swarm_tick p (swarm_of (protocol p) s) = swarm_of (protocol p) (tick (protocol p) s).
Proof.
  intros p s Hden Hn Hcount Ht.
  assert (Hsize : count (drones (tick (protocol p) s)) = count (drones s)).
  { rewrite !tick_eq; destruct (timesteps s =? p_n (protocol p)); [apply count_exec_coverage|reflexivity]. }
  unfold swarm_tick, swarm_of; rewrite Hsize, count_lambda.
  rewrite (lambda_ext _ _ _ (fun i => fmu_tick p (project (protocol p) s i)))
    by (intros i Hi; rewrite machine_lambda by exact Hi; reflexivity).
  unfold exchange; rewrite count_lambda; apply lambda_ext; intros i Hi.
  rewrite machine_lambda by exact Hi.
  set (machines := lambda (count (drones s)) (fun i => fmu_tick p (project (protocol p) s i))).
  assert (Hown : forall j, j < count (drones s) ->
            own (st (machine machines j)) = getx (tick (protocol p) s) j).
  { intros j Hj; unfold machines; rewrite machine_lambda by exact Hj.
    apply (fmu_tick_project p s j Hden Hn Hcount Ht Hj). }
  destruct (fmu_tick_project p s i Hden Hn Hcount Ht Hi) as [E1 [E2 [E3 [E4 E5]]]].
  cbv zeta in *.
  unfold project at 6; rewrite Hsize, E1, E2, E3, E4, E5; f_equal; f_equal.
  - destruct (Nat.ltb_spec 0 i) as [Hl|Hl]; [apply Hown; lia|].
    unfold project; cbn [st prec]; rewrite (proj2 (Nat.ltb_ge 0 i) Hl); reflexivity.
  - destruct (Nat.ltb_spec (i + 1) (count (drones s))) as [Hl|Hl]; [apply Hown; lia|].
    unfold project; cbn [st foll]; rewrite (proj2 (Nat.ltb_ge (i + 1) _) Hl); reflexivity.
Qed.

Lemma tick_counter : forall (p : Params T) (s : State T),
  timesteps s <= p_n p -> timesteps (tick p s) <= p_n p.
Proof.
  intros p s Hs; rewrite !tick_eq; destruct (Nat.eqb_spec (timesteps s) (p_n p)); cbn [timesteps]; lia.
Qed.

Lemma kth_step_counter : forall (p : Params T) (s : State T) k,
  timesteps s <= p_n p -> timesteps (kth_step p s k) <= p_n p.
Proof.
  intros p s k Hs; induction k as [|k IH]; [exact Hs|]; simpl; apply tick_counter; exact IH.
Qed.

(* The projection theorem: the machines are the projections of the global state,
   field by field, after every number of ticks. *)
Theorem projection : forall (p : LocalParams T) (s : State T),
  0 < den (ratio p) -> p_n (protocol p) = counter_limit (ratio p) ->
  local_count p = count (drones s) -> timesteps s <= p_n (protocol p) ->
  forall k,
  swarm_kth_step p (swarm_of (protocol p) s) k = swarm_of (protocol p) (kth_step (protocol p) s k).
Proof.
  intros p s Hden Hn Hcount Ht k; induction k as [|k IH]; [reflexivity|].
  simpl swarm_kth_step; rewrite IH; apply swarm_tick_of; auto.
  - rewrite count_kth_step; exact Hcount.
  - apply kth_step_counter; exact Ht.
Qed.

(* Read off: own positions, for both phases, any start, any period, any number
   of drones. *)
Corollary projection_positions : forall (p : LocalParams T) (x : DroneMap T) phase k,
  0 < den (ratio p) -> p_n (protocol p) = counter_limit (ratio p) ->
  local_count p = count x ->
  let s := initial x (p_n (protocol p)) phase in
  map (fun m => own (st m)) (swarm_kth_step p (swarm_of (protocol p) s) k)
  = drones (kth_step (protocol p) s k).
Proof.
  intros p x phase k Hden Hn Hcount s.
  rewrite projection; auto; [|destruct phase; simpl; lia].
  unfold swarm_of, lambda; rewrite map_map; simpl.
  apply (map_ext_get _ _).
  - unfold count at 1; rewrite map_len, seq_len; reflexivity.
  - intros i Hi; unfold count in Hi at 1; rewrite map_len, seq_len in Hi.
    apply (get_lambda _ _ _ (fun i => getx (kth_step (protocol p) s k) i) i Hi).
Qed.

End Projection.
