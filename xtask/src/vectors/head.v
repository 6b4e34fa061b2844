(* Generated from vectors.tsv: do not edit.  The format is described in README.md.
   The definitions that are proved about, executed on exact fractions. *)
From Coq Require Import QArith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage.
From Cordon Require Import Spec.Local Spec.Graph Spec.Consensus Spec.Formation.
From Cordon Require Import Spec.Activation Spec.Delay Spec.Placement.
From Cordon Require Import Spec.Theorems.Statements Spec.Theorems.NonDecreasing.
From Cordon Require Import Proofs.Rational Proofs.Decide Proofs.Projection Proofs.Consensus.
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

Definition alone (min max eps : Q) (n drones : nat) (prec own foll : Q) (id k : nat) : list Q :=
  let p := mkLocalParams (mkParams min max eps n) drones (whole n) in
  let l := st (fmu_kth_step p (mkSim 0 (mkLocal prec own foll id)) k) in
  [Spec.Local.prec l; Spec.Local.own l; Spec.Local.foll l].

Definition consensus (eps : Q) (start : list Q) (k : nat) : list Q :=
  consensus_step eps (path (length start)) start k.

Definition meeting (eps : Q) (edges : list (nat * nat)) (start : list Q) (k : nat) : list Q :=
  consensus_step eps (edge_graph (length start) edges) start k.

Definition formation (eps : Q) (edges : list (nat * nat)) (start input : list Q) : list Q :=
  exec_formation eps (edge_graph (length start) edges) start input.

Definition active (min max eps : Q) (start : list Q) (flags : list bool) : list Q :=
  drones (exec_coverage_active (mkParams min max eps 0) (mkState start 0) (fun i => nth i flags false)).

Definition delayed (min max eps : Q) (start seen : list Q) : list Q :=
  drones (exec_coverage_delayed (mkParams min max eps 0) (mkState start 0)
    (fun i j => nth (i * length start + j) seen 0)).

Definition quantities (min max : Q) (x : list Q) : list Q :=
  let all := seq 0 (count x) in
  [gaps x; sum x; scaled_energy min max x] ++ map (gap x) (seq 0 (count x - 1)) ++
  map (scaled_target min max (count x)) all ++ map (scaled_error min max x) all ++
  map (fun i => from_index (contraction_weight (count x) i)) all.

Definition residual (eps : Q) (before after : list Q) : list Q :=
  [telescoping_residual eps before after].

Definition yes {P : Prop} (d : decided P) : Q := if d then 1 else 0.

Definition predicates (min max : Q) (x : list Q) : list Q :=
  let p := mkParams min max 0 0 in
  [yes (in_set_dec AnyStart p x); yes (in_set_dec OrderedStart p x);
   yes (in_set_dec FirstSubsegment p x); yes (in_set_dec UpperBoundedStart p x);
   yes (at_targets_dec p x); yes (above_targets_dec p x); yes (in_box_dec p x)].

Definition critical (num den : Q) (drones : nat) : list Q := [yes (critical_dec num den drones)].

