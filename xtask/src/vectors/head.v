(* Generated from vectors.tsv: do not edit.  The format is described in README.md.
   The definitions that are proved about, executed on exact fractions. *)
From Coq Require Import QArith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage.
From Cordon Require Import Spec.Local Spec.Graph Spec.Consensus.
From Cordon Require Import Proofs.Rational Proofs.Projection Proofs.Consensus.
Import ListNotations.
Local Open Scope Q_scope.

Definition coverage (min max eps : Q) (n : nat) (phase : Phase) (start : list Q) (k : nat) : list Q :=
  drones (kth_step (mkParams min max eps n) (initial start n phase) k).

Definition local (min max eps : Q) (num den : nat) (phase : Phase) (start : list Q) (k : nat) : list Q :=
  let ratio := mkRatio num den in
  let p := mkParams min max eps (counter_limit ratio) in
  let s := initial start (p_n p) phase in
  map (fun m => own (st m))
    (swarm_kth_step (mkLocalParams p (length start) ratio) (swarm_of p s) k).

Definition consensus (eps : Q) (start : list Q) (k : nat) : list Q :=
  consensus_step eps (path (length start)) start k.

