(* Consensus and formation on any undirected graph: what happens to the sum. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.Placement Spec.Graph.
From Cordon Require Import Spec.Consensus Spec.Formation.
From Cordon Require Import Proofs.Real.
Local Open Scope R_scope.

Fixpoint consensus_step {T : Type} `{Scalar T} (eps : T) (g : Graph) (x : DroneMap T) (k : nat)
  : DroneMap T :=
  match k with
  | O => x
  | S k' => exec_consensus eps g (consensus_step eps g x k')
  end.

Lemma fold_filter : forall (P : nat -> bool) (f : nat -> R) n,
  fold_left (fun sum j => sum + f j) (filter P (seq 0 n)) 0
  = sumn (fun j => if P j then f j else 0) n.
Proof.
  intros P f n; induction n as [|n IH]; [reflexivity|].
  rewrite seq_S, filter_app, fold_left_app, IH; simpl.
  destruct (P n); simpl; ring.
Qed.

Lemma pull_sumn : forall g (x : DroneMap R) i,
  pull g x i = sumn (fun j => if linked g i j then get x j - get x i else 0) (graph_count g).
Proof. intros g x i; unfold pull, neighbours; apply fold_filter. Qed.

(* What one drone gains through a link the other loses. *)
Lemma pulls_cancel : forall g (x : DroneMap R),
  sumn (fun i => pull g x i) (graph_count g) = 0.
Proof.
  intros g x; set (n := graph_count g).
  set (F := fun i j => if linked g i j then get x j - get x i else 0).
  assert (HF : sumn (fun i => sumn (F i) n) n = - sumn (fun i => sumn (F i) n) n).
  { rewrite sumn_swap at 1.
    replace (- sumn (fun i => sumn (F i) n) n) with (-1 * sumn (fun i => sumn (F i) n) n) by ring.
    rewrite <- sumn_scal; apply sumn_ext; intros j Hj.
    rewrite <- sumn_scal; apply sumn_ext; intros i Hi; unfold F.
    rewrite (linked_sym g i j); destruct (linked g j i); ring. }
  assert (HP : sumn (fun i => pull g x i) n = sumn (fun i => sumn (F i) n) n).
  { apply sumn_ext; intros i Hi; rewrite pull_sumn; reflexivity. }
  rewrite HP; lra.
Qed.

Lemma sum_lambda : forall n (f : nat -> R), sum (lambda n f) = sumn f n.
Proof.
  intros n f; rewrite sum_sumn, count_lambda; apply sumn_ext; intros i Hi.
  apply get_lambda; exact Hi.
Qed.

Theorem consensus_sum : forall eps g (x : DroneMap R),
  graph_count g = count x -> sum (exec_consensus eps g x) = sum x.
Proof.
  intros eps g x Hg; unfold exec_consensus; rewrite sum_lambda, sum_sumn; simpl.
  rewrite sumn_plus, sumn_scal, <- Hg, pulls_cancel; ring.
Qed.

Lemma count_consensus_step : forall eps g (x : DroneMap R) k,
  count (consensus_step eps g x k) = count x.
Proof.
  intros eps g x k; induction k as [|k IH]; [reflexivity|].
  simpl consensus_step; unfold exec_consensus; rewrite count_lambda; exact IH.
Qed.

(* The average is preserved, for every weight and every number of steps. *)
Theorem consensus_average : forall eps g (x : DroneMap R) k,
  graph_count g = count x ->
  sum (consensus_step eps g x k) / INR (count (consensus_step eps g x k))
  = sum x / INR (count x).
Proof.
  intros eps g x k Hg; rewrite count_consensus_step; f_equal.
  induction k as [|k IH]; [reflexivity|].
  simpl consensus_step; rewrite consensus_sum; [exact IH|].
  rewrite count_consensus_step; exact Hg.
Qed.

(* A swarm in agreement stays, on any graph. *)
Theorem consensus_fixed : forall eps g (x : DroneMap R) a,
  graph_count g = count x -> (forall i, (i < count x)%nat -> get x i = a) ->
  exec_consensus eps g x = x.
Proof.
  intros eps g x a Hg Hx; unfold exec_consensus.
  apply (map_ext_get _ real_scalar); rewrite count_lambda; [reflexivity|].
  intros i Hi; rewrite get_lambda by exact Hi; simpl.
  rewrite pull_sumn, sumn_zero; [ring|].
  intros j Hj; rewrite Hg in Hj; rewrite !Hx by assumption; destruct (linked g i j); ring.
Qed.

(* Formation moves the sum by eps times the sum of the input. *)
Theorem formation_sum : forall eps g (x b : DroneMap R),
  graph_count g = count x -> count b = count x ->
  sum (exec_formation eps g x b) = sum x + eps * sum b.
Proof.
  intros eps g x b Hg Hb; unfold exec_formation; rewrite sum_lambda, !sum_sumn; simpl.
  rewrite sumn_plus, sumn_scal, sumn_plus, Hb, <- Hg, pulls_cancel; ring.
Qed.

(* Without input, formation is consensus. *)
Theorem formation_without_input : forall eps g (x b : DroneMap R),
  (forall i, (i < count x)%nat -> get b i = 0) ->
  exec_formation eps g x b = exec_consensus eps g x.
Proof.
  intros eps g x b Hb; unfold exec_formation, exec_consensus.
  apply (map_ext_get _ real_scalar); rewrite !count_lambda; [reflexivity|].
  intros i Hi; rewrite !get_lambda by exact Hi; simpl; rewrite Hb by exact Hi; ring.
Qed.
