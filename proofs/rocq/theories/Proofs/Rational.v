(* The spec at the rationals, where it is executed, and the bridge to the reals,
   where it is proved: a ring morphism commutes with every run. *)
From Coq Require Import Reals Qreals QArith Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage.
From Cordon Require Import Spec.Graph Spec.Consensus.
From Cordon Require Import Proofs.Real Proofs.Consensus.

(* Fractions are kept in lowest terms, so that their size stays linear in the
   number of steps and equal values are equal terms. *)
#[global] Instance rational_scalar : Scalar Q := {
  from_int := inject_Z;
  add a b := Qred (a + b)%Q;
  sub a b := Qred (a - b)%Q;
  mul a b := Qred (a * b)%Q
}.

Section Morphism.
Context {A B : Type} `{KA : Scalar A} `{KB : Scalar B}.
Variable f : A -> B.
Hypothesis f_int : forall z, f (from_int z) = from_int z.
Hypothesis f_add : forall a b, f (add a b) = add (f a) (f b).
Hypothesis f_sub : forall a b, f (sub a b) = sub (f a) (f b).
Hypothesis f_mul : forall a b, f (mul a b) = mul (f a) (f b).

Definition map_params (p : Params A) : Params B :=
  mkParams (f (p_min p)) (f (p_max p)) (f (p_eps p)) (p_n p).

Definition map_state (s : State A) : State B := mkState (map f (drones s)) (timesteps s).

Lemma get_map : forall (m : DroneMap A) i, get (map f m) i = f (get m i).
Proof. intros m i; unfold get; rewrite <- f_int; apply map_nth. Qed.

Lemma count_map : forall (m : DroneMap A), count (map f m) = count m.
Proof. intros m; apply map_len. Qed.

Lemma update_map : forall p N i (g : nat -> A) (h : nat -> B),
  (forall j, h j = f (g j)) -> update (map_params p) N i h = f (update p N i g).
Proof.
  intros p N i g h Hgh; unfold update, exec_cvg; cbn [map_params p_min p_max p_eps].
  rewrite !Hgh.
  destruct (i =? 0)%nat; [reflexivity|].
  destruct (i + 1 =? N)%nat; [reflexivity|].
  rewrite !f_add, !f_mul, !f_sub, !f_mul, !f_int.
  destruct (0 <? i)%nat; destruct (i + 1 <? N)%nat; reflexivity.
Qed.

Lemma exec_coverage_map : forall p s,
  exec_coverage (map_params p) (map_state s) = map_state (exec_coverage p s).
Proof.
  intros p s; unfold exec_coverage, next_placement, map_state; cbn [drones timesteps].
  rewrite count_map; f_equal; unfold lambda; rewrite map_map; apply map_ext; intros i.
  apply update_map; intros j; apply get_map.
Qed.

Lemma kth_step_map : forall p s k,
  kth_step (map_params p) (map_state s) k = map_state (kth_step p s k).
Proof.
  intros p s k; induction k as [|k IH]; [reflexivity|].
  simpl kth_step; rewrite IH; rewrite !tick_eq; cbn [map_params p_n].
  change (timesteps (map_state (kth_step p s k))) with (timesteps (kth_step p s k)).
  destruct (timesteps (kth_step p s k) =? p_n p)%nat; [|reflexivity].
  fold (map_params p); rewrite exec_coverage_map; reflexivity.
Qed.

Lemma pull_map : forall g x i, pull g (map f x) i = f (pull g x i).
Proof.
  intros g x i; unfold pull; rewrite <- f_int.
  generalize (neighbours g i) as l; generalize (from_int (T := A) 0) as acc.
  intros acc l; revert acc; induction l as [|j l IH]; intros acc; [reflexivity|].
  simpl; rewrite <- IH; f_equal; rewrite f_add, f_sub, !get_map; reflexivity.
Qed.

Lemma exec_consensus_map : forall eps g x,
  exec_consensus (f eps) g (map f x) = map f (exec_consensus eps g x).
Proof.
  intros eps g x; unfold exec_consensus; rewrite count_map; unfold lambda; rewrite map_map.
  apply map_ext; intros i; rewrite f_add, f_mul, get_map, pull_map; reflexivity.
Qed.

Lemma consensus_step_map : forall eps g x k,
  consensus_step (f eps) g (map f x) k = map f (consensus_step eps g x k).
Proof.
  intros eps g x k; induction k as [|k IH]; [reflexivity|].
  simpl consensus_step; rewrite IH; apply exec_consensus_map.
Qed.
End Morphism.

(* The bridge: what is executed at the rationals is what is proved at the reals. *)

Lemma Q2R_red : forall a, Q2R (Qred a) = Q2R a.
Proof. intros a; apply Qeq_eqR, Qred_correct. Qed.

Lemma Q2R_int : forall z, Q2R (from_int z) = from_int z.
Proof. intros z; simpl; unfold Q2R; simpl; rewrite Rinv_1, Rmult_1_r; reflexivity. Qed.

Lemma Q2R_add : forall a b, Q2R (add a b) = add (Q2R a) (Q2R b).
Proof.
  intros a b; change (add a b) with (Qred (a + b)); rewrite Q2R_red; exact (Q2R_plus a b).
Qed.

Lemma Q2R_sub : forall a b, Q2R (sub a b) = sub (Q2R a) (Q2R b).
Proof.
  intros a b; change (sub a b) with (Qred (a - b)); rewrite Q2R_red; exact (Q2R_minus a b).
Qed.

Lemma Q2R_mul : forall a b, Q2R (mul a b) = mul (Q2R a) (Q2R b).
Proof.
  intros a b; change (mul a b) with (Qred (a * b)); rewrite Q2R_red; exact (Q2R_mult a b).
Qed.

Theorem execution_is_proved : forall (p : Params Q) (s : State Q) k,
  drones (kth_step (map_params Q2R p) (map_state Q2R s) k)
  = map Q2R (drones (kth_step p s k)).
Proof.
  intros p s k; rewrite (kth_step_map Q2R Q2R_int Q2R_add Q2R_sub Q2R_mul); reflexivity.
Qed.

(* The same for k steps of consensus. *)
Theorem consensus_execution_is_proved : forall (eps : Q) g (x : DroneMap Q) k,
  consensus_step (Q2R eps) g (map Q2R x) k = map Q2R (consensus_step eps g x k).
Proof. intros; apply (consensus_step_map Q2R Q2R_int Q2R_add Q2R_sub Q2R_mul). Qed.
