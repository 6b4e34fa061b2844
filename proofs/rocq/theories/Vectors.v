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

Example paper_first_0 : coverage (0 # 1) (100 # 1) (1 # 5) 3 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 0 = [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_first_1 : coverage (0 # 1) (100 # 1) (1 # 5) 3 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 1 = [0 # 1; 10 # 1; 20 # 1; 42 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_first_2 : coverage (0 # 1) (100 # 1) (1 # 5) 3 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 2 = [0 # 1; 10 # 1; 20 # 1; 42 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_first_4 : coverage (0 # 1) (100 # 1) (1 # 5) 3 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 4 = [0 # 1; 10 # 1; 20 # 1; 42 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_first_5 : coverage (0 # 1) (100 # 1) (1 # 5) 3 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 5 = [0 # 1; 10 # 1; 112 # 5; 246 # 5; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_first_8 : coverage (0 # 1) (100 # 1) (1 # 5) 3 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 8 = [0 # 1; 10 # 1; 112 # 5; 246 # 5; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_first_9 : coverage (0 # 1) (100 # 1) (1 # 5) 3 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 9 = [0 # 1; 262 # 25; 632 # 25; 54 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_first_13 : coverage (0 # 1) (100 # 1) (1 # 5) 3 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 13 = [0 # 1; 1418 # 125; 3508 # 125; 7182 # 125; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_first_20 : coverage (0 # 1) (100 # 1) (1 # 5) 3 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 20 = [0 # 1; 7762 # 625; 19124 # 625; 37554 # 625; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_first_21 : coverage (0 # 1) (100 # 1) (1 # 5) 3 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 21 = [0 # 1; 8482 # 625; 102688 # 3125; 194286 # 3125; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_first_37 : coverage (0 # 1) (100 # 1) (1 # 5) 3 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 37 = [0 # 1; 34620002 # 1953125; 77312656 # 1953125; 131921958 # 1953125; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_first_40 : coverage (0 # 1) (100 # 1) (1 # 5) 3 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 40 = [0 # 1; 34620002 # 1953125; 77312656 # 1953125; 131921958 # 1953125; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_last_0 : coverage (0 # 1) (100 # 1) (1 # 5) 3 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 0 = [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_last_1 : coverage (0 # 1) (100 # 1) (1 # 5) 3 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 1 = [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_last_3 : coverage (0 # 1) (100 # 1) (1 # 5) 3 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 3 = [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_last_4 : coverage (0 # 1) (100 # 1) (1 # 5) 3 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 4 = [0 # 1; 10 # 1; 20 # 1; 42 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_last_5 : coverage (0 # 1) (100 # 1) (1 # 5) 3 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 5 = [0 # 1; 10 # 1; 20 # 1; 42 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_last_8 : coverage (0 # 1) (100 # 1) (1 # 5) 3 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 8 = [0 # 1; 10 # 1; 112 # 5; 246 # 5; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_last_12 : coverage (0 # 1) (100 # 1) (1 # 5) 3 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 12 = [0 # 1; 262 # 25; 632 # 25; 54 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_last_20 : coverage (0 # 1) (100 # 1) (1 # 5) 3 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 20 = [0 # 1; 7762 # 625; 19124 # 625; 37554 # 625; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example paper_last_40 : coverage (0 # 1) (100 # 1) (1 # 5) 3 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 40 = [0 # 1; 34620002 # 1953125; 77312656 # 1953125; 131921958 # 1953125; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example high_weight_0 : coverage (0 # 1) (100 # 1) (7 # 10) 13 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 0 = [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example high_weight_1 : coverage (0 # 1) (100 # 1) (7 # 10) 13 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 1 = [0 # 1; 10 # 1; 20 # 1; 72 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example high_weight_14 : coverage (0 # 1) (100 # 1) (7 # 10) 13 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 14 = [0 # 1; 10 # 1; 20 # 1; 72 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example high_weight_15 : coverage (0 # 1) (100 # 1) (7 # 10) 13 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 15 = [0 # 1; 10 # 1; 247 # 5; 276 # 5; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example high_weight_29 : coverage (0 # 1) (100 # 1) (7 # 10) 13 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 29 = [0 # 1; 1529 # 50; 647 # 25; 165 # 2; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example high_weight_57 : coverage (0 # 1) (100 # 1) (7 # 10) 13 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 57 = [0 # 1; 114523 # 2500; 18973 # 1250; 240291 # 2500; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example high_weight_99 : coverage (0 # 1) (100 # 1) (7 # 10) 13 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 99 = [0 # 1; -22857323 # 625000; 85016717 # 625000; 8380389 # 625000; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example high_weight_150 : coverage (0 # 1) (100 # 1) (7 # 10) 13 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 150 = [0 # 1; 59149945319 # 312500000; -28522788907 # 156250000; 14955067707 # 62500000; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example recorded_0 : coverage (0 # 1) (10 # 1) (1 # 4) 5 First [0 # 1; 1 # 1; 2 # 1; 3 # 1; 10 # 1] 0 = [0 # 1; 1 # 1; 2 # 1; 3 # 1; 10 # 1]. Proof. vm_compute. reflexivity. Qed.
Example recorded_1 : coverage (0 # 1) (10 # 1) (1 # 4) 5 First [0 # 1; 1 # 1; 2 # 1; 3 # 1; 10 # 1] 1 = [0 # 1; 1 # 1; 2 # 1; 9 # 2; 10 # 1]. Proof. vm_compute. reflexivity. Qed.
Example recorded_6 : coverage (0 # 1) (10 # 1) (1 # 4) 5 First [0 # 1; 1 # 1; 2 # 1; 3 # 1; 10 # 1] 6 = [0 # 1; 1 # 1; 2 # 1; 9 # 2; 10 # 1]. Proof. vm_compute. reflexivity. Qed.
Example recorded_7 : coverage (0 # 1) (10 # 1) (1 # 4) 5 First [0 # 1; 1 # 1; 2 # 1; 3 # 1; 10 # 1] 7 = [0 # 1; 1 # 1; 19 # 8; 21 # 4; 10 # 1]. Proof. vm_compute. reflexivity. Qed.
Example recorded_60 : coverage (0 # 1) (10 # 1) (1 # 4) 5 First [0 # 1; 1 # 1; 2 # 1; 3 # 1; 10 # 1] 60 = [0 # 1; 64745 # 32768; 139483 # 32768; 228489 # 32768; 10 # 1]. Proof. vm_compute. reflexivity. Qed.
Example recorded_121 : coverage (0 # 1) (10 # 1) (1 # 4) 5 First [0 # 1; 1 # 1; 2 # 1; 3 # 1; 10 # 1] 121 = [0 # 1; 10341912343 # 4294967296; 5228875583 # 1073741824; 31816742679 # 4294967296; 10 # 1]. Proof. vm_compute. reflexivity. Qed.
Example three_drones_0 : coverage (-1 # 1) (2 # 1) (1 # 1) 0 First [-1 # 1; -1 # 4; 2 # 1] 0 = [-1 # 1; -1 # 4; 2 # 1]. Proof. vm_compute. reflexivity. Qed.
Example three_drones_1 : coverage (-1 # 1) (2 # 1) (1 # 1) 0 First [-1 # 1; -1 # 4; 2 # 1] 1 = [-1 # 1; 5 # 4; 2 # 1]. Proof. vm_compute. reflexivity. Qed.
Example three_drones_2 : coverage (-1 # 1) (2 # 1) (1 # 1) 0 First [-1 # 1; -1 # 4; 2 # 1] 2 = [-1 # 1; -1 # 4; 2 # 1]. Proof. vm_compute. reflexivity. Qed.
Example three_drones_3 : coverage (-1 # 1) (2 # 1) (1 # 1) 0 First [-1 # 1; -1 # 4; 2 # 1] 3 = [-1 # 1; 5 # 4; 2 # 1]. Proof. vm_compute. reflexivity. Qed.
Example three_drones_last_1 : coverage (-1 # 1) (2 # 1) (1 # 3) 1 Last [-1 # 1; -1 # 4; 2 # 1] 1 = [-1 # 1; -1 # 4; 2 # 1]. Proof. vm_compute. reflexivity. Qed.
Example three_drones_last_2 : coverage (-1 # 1) (2 # 1) (1 # 3) 1 Last [-1 # 1; -1 # 4; 2 # 1] 2 = [-1 # 1; 1 # 4; 2 # 1]. Proof. vm_compute. reflexivity. Qed.
Example three_drones_last_3 : coverage (-1 # 1) (2 # 1) (1 # 3) 1 Last [-1 # 1; -1 # 4; 2 # 1] 3 = [-1 # 1; 1 # 4; 2 # 1]. Proof. vm_compute. reflexivity. Qed.
Example three_drones_last_4 : coverage (-1 # 1) (2 # 1) (1 # 3) 1 Last [-1 # 1; -1 # 4; 2 # 1] 4 = [-1 # 1; 5 # 12; 2 # 1]. Proof. vm_compute. reflexivity. Qed.
Example three_drones_last_7 : coverage (-1 # 1) (2 # 1) (1 # 3) 1 Last [-1 # 1; -1 # 4; 2 # 1] 7 = [-1 # 1; 17 # 36; 2 # 1]. Proof. vm_compute. reflexivity. Qed.
Example not_monotonic_1 : coverage (0 # 1) (100 # 1) (1 # 5) 0 First [0 # 1; 10 # 1; 11 # 1; 24 # 1; 100 # 1] 1 = [0 # 1; 41 # 5; 67 # 5; 183 # 5; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example crossing_0 : coverage (0 # 1) (1 # 1) (3 # 5) 0 First [0 # 1; 1 # 10; 9 # 10; 1 # 1] 0 = [0 # 1; 1 # 10; 9 # 10; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example crossing_1 : coverage (0 # 1) (1 # 1) (3 # 5) 0 First [0 # 1; 1 # 10; 9 # 10; 1 # 1] 1 = [0 # 1; 13 # 25; 12 # 25; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example seven_drones_1 : coverage (0 # 1) (6 # 1) (1 # 2) 0 First [0 # 1; 1 # 7; 2 # 7; 3 # 7; 4 # 7; 5 # 7; 6 # 1] 1 = [0 # 1; 1 # 7; 2 # 7; 3 # 7; 4 # 7; 23 # 7; 6 # 1]. Proof. vm_compute. reflexivity. Qed.
Example seven_drones_2 : coverage (0 # 1) (6 # 1) (1 # 2) 0 First [0 # 1; 1 # 7; 2 # 7; 3 # 7; 4 # 7; 5 # 7; 6 # 1] 2 = [0 # 1; 1 # 7; 2 # 7; 3 # 7; 13 # 7; 23 # 7; 6 # 1]. Proof. vm_compute. reflexivity. Qed.
Example seven_drones_3 : coverage (0 # 1) (6 # 1) (1 # 2) 0 First [0 # 1; 1 # 7; 2 # 7; 3 # 7; 4 # 7; 5 # 7; 6 # 1] 3 = [0 # 1; 1 # 7; 2 # 7; 15 # 14; 13 # 7; 55 # 14; 6 # 1]. Proof. vm_compute. reflexivity. Qed.
Example seven_drones_10 : coverage (0 # 1) (6 # 1) (1 # 2) 0 First [0 # 1; 1 # 7; 2 # 7; 3 # 7; 4 # 7; 5 # 7; 6 # 1] 10 = [0 # 1; 533 # 896; 89 # 64; 1959 # 896; 6073 # 1792; 2057 # 448; 6 # 1]. Proof. vm_compute. reflexivity. Qed.
Example local_first_0 : local (0 # 1) (100 # 1) (1 # 5) 7 2 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 0 = [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example local_first_1 : local (0 # 1) (100 # 1) (1 # 5) 7 2 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 1 = [0 # 1; 10 # 1; 20 # 1; 42 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example local_first_5 : local (0 # 1) (100 # 1) (1 # 5) 7 2 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 5 = [0 # 1; 10 # 1; 20 # 1; 42 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example local_first_6 : local (0 # 1) (100 # 1) (1 # 5) 7 2 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 6 = [0 # 1; 10 # 1; 112 # 5; 246 # 5; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example local_first_11 : local (0 # 1) (100 # 1) (1 # 5) 7 2 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 11 = [0 # 1; 262 # 25; 632 # 25; 54 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example local_first_20 : local (0 # 1) (100 # 1) (1 # 5) 7 2 First [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 20 = [0 # 1; 1418 # 125; 3508 # 125; 7182 # 125; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example local_last_0 : local (0 # 1) (100 # 1) (1 # 5) 4 1 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 0 = [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example local_last_4 : local (0 # 1) (100 # 1) (1 # 5) 4 1 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 4 = [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example local_last_5 : local (0 # 1) (100 # 1) (1 # 5) 4 1 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 5 = [0 # 1; 10 # 1; 20 # 1; 42 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example local_last_10 : local (0 # 1) (100 # 1) (1 # 5) 4 1 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 10 = [0 # 1; 10 # 1; 112 # 5; 246 # 5; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example local_last_20 : local (0 # 1) (100 # 1) (1 # 5) 4 1 Last [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 20 = [0 # 1; 1418 # 125; 3508 # 125; 7182 # 125; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rendezvous_0 : consensus (3 # 10) [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 0 = [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rendezvous_1 : consensus (3 # 10) [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 1 = [3 # 1; 10 # 1; 20 # 1; 48 # 1; 79 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rendezvous_2 : consensus (3 # 10) [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 2 = [51 # 10; 109 # 10; 127 # 5; 489 # 10; 697 # 10]. Proof. vm_compute. reflexivity. Qed.
Example rendezvous_5 : consensus (3 # 10) [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 5 = [21909 # 2000; 179227 # 10000; 6133 # 200; 452523 # 10000; 110411 # 2000]. Proof. vm_compute. reflexivity. Qed.
Example rendezvous_10 : consensus (3 # 10) [0 # 1; 10 # 1; 20 # 1; 30 # 1; 100 # 1] 10 = [4007373513 # 200000000; 12266063123 # 500000000; 6381643 # 200000; 2463196719 # 62500000; 8822328737 # 200000000]. Proof. vm_compute. reflexivity. Qed.
Example drones3_first_1 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 8 # 1] 1 = [-1 # 1; 18 # 5; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones3_first_3 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 8 # 1] 3 = [-1 # 1; 18 # 5; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones3_first_7 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 8 # 1] 7 = [-1 # 1; 438 # 125; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones3_last_1 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 8 # 1] 1 = [-1 # 1; 4 # 1; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones3_last_3 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 8 # 1] 3 = [-1 # 1; 18 # 5; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones3_last_7 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 8 # 1] 7 = [-1 # 1; 88 # 25; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest3_first : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 8 # 1] [false; true; true] = [-1 # 1; 18 # 5; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest3_second : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 8 # 1] [true; false; true] = [-1 # 1; 4 # 1; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest3_third : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 8 # 1] [true; true; false] = [-1 # 1; 18 # 5; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example late3 : delayed (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 1 # 2; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3; 1 # 3; -1 # 1] = [-1 # 1; 19 # 30; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example meet_star3 : meeting (2 # 5) [(1, 0); (2, 0); (1, 1)]%nat [-1 # 1; 4 # 1; 8 # 1] 2 = [87 # 25; 76 # 25; 112 # 25]. Proof. vm_compute. reflexivity. Qed.
Example form_star3 : formation (2 # 5) [(1, 0); (2, 0); (1, 1)]%nat [-1 # 1; 1 # 2; 8 # 1] [-4 # 3; 1 # 1; -1 # 3] = [8 # 3; 3 # 10; 64 # 15]. Proof. vm_compute. reflexivity. Qed.
Example meet_ring3 : meeting (2 # 5) [(0, 1); (1, 2); (2, 0); (1, 0)]%nat [-1 # 1; 4 # 1; 8 # 1] 2 = [87 # 25; 92 # 25; 96 # 25]. Proof. vm_compute. reflexivity. Qed.
Example form_ring3 : formation (2 # 5) [(0, 1); (1, 2); (2, 0); (1, 0)]%nat [-1 # 1; 1 # 2; 8 # 1] [-4 # 3; 1 # 1; -1 # 3] = [8 # 3; 33 # 10; 19 # 15]. Proof. vm_compute. reflexivity. Qed.
Example alone3_0 : alone (-1 # 1) (8 # 1) (2 # 5) 2 3 (-4 # 3) (1 # 1) (-1 # 3) 0 6 = [-4 # 3; -1 # 1; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example alone3_1 : alone (-1 # 1) (8 # 1) (2 # 5) 2 3 (-4 # 3) (1 # 1) (-1 # 3) 1 6 = [-4 # 3; -19 # 25; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example alone3_2 : alone (-1 # 1) (8 # 1) (2 # 5) 2 3 (-4 # 3) (1 # 1) (-1 # 3) 2 6 = [-4 # 3; 8 # 1; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example quantities3 : quantities (-1 # 1) (8 # 1) [-1 # 1; 4 # 1; 8 # 1] = [2 # 1; 11 # 1; 1 # 1; 5 # 1; 4 # 1; -2 # 1; 7 # 1; 16 # 1; 0 # 1; -1 # 1; 0 # 1; 0 # 1; 1 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example residual3 : residual (2 # 5) [-1 # 1; 4 # 1; 8 # 1] [-4 # 3; 1 # 1; -1 # 3] = [-169 # 15]. Proof. vm_compute. reflexivity. Qed.
Example targets3 : predicates (-1 # 1) (8 # 1) [-1 # 1; 7 # 2; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 1 # 1; 1 # 1; 1 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example behind3 : predicates (-1 # 1) (8 # 1) [-1 # 1; 61 # 18; 8 # 1] = [1 # 1; 1 # 1; 1 # 1; 1 # 1; 0 # 1; 0 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example before3 : predicates (-1 # 1) (8 # 1) [-1 # 1; 65 # 18; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 0 # 1; 0 # 1; 1 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example crowd3 : predicates (-1 # 1) (8 # 1) [-1 # 1; -99 # 100; 8 # 1] = [1 # 1; 1 # 1; 1 # 1; 1 # 1; 0 # 1; 0 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example mixed3 : predicates (-1 # 1) (8 # 1) [-1 # 1; 4 # 1; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 0 # 1; 0 # 1; 1 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example loose3 : predicates (-1 # 1) (8 # 1) [-4 # 3; 1 # 1; -1 # 3] = [0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical3_half : critical (1 # 1) (2 # 1) 3 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical3_low : critical (53 # 1) (100 # 1) 3 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical3_five : critical (55 # 1) (100 # 1) 3 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical3_four : critical (58 # 1) (100 # 1) 3 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical3_middle : critical (60 # 1) (100 # 1) 3 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical3_high : critical (2 # 1) (3 # 1) 3 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical3_one : critical (1 # 1) (1 # 1) 3 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical3_zero : critical (0 # 1) (1 # 1) 3 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones4_first_1 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 1 # 5; 8 # 1] 1 = [-1 # 1; 12 # 25; 121 # 25; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones4_first_3 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 1 # 5; 8 # 1] 3 = [-1 # 1; 12 # 25; 121 # 25; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones4_first_7 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 1 # 5; 8 # 1] 7 = [-1 # 1; 1044 # 625; 2953 # 625; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones4_last_1 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 1 # 5; 8 # 1] 1 = [-1 # 1; 4 # 1; 1 # 5; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones4_last_3 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 1 # 5; 8 # 1] 3 = [-1 # 1; 12 # 25; 121 # 25; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones4_last_7 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 1 # 5; 8 # 1] 7 = [-1 # 1; 204 # 125; 109 # 25; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest4_first : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 8 # 1] [false; true; true; false] = [-1 # 1; 12 # 25; 121 # 25; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest4_second : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 8 # 1] [true; false; true; true] = [-1 # 1; 4 # 1; 121 # 25; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest4_third : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 8 # 1] [true; true; false; true] = [-1 # 1; 12 # 25; 1 # 5; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example late4 : delayed (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 1 # 2; 2 # 3; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3; 1 # 3; -1 # 1; 4 # 3; 0 # 1; -4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3] = [-1 # 1; 31 # 30; 2 # 15; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example meet_star4 : meeting (2 # 5) [(1, 0); (2, 0); (3, 0); (1, 1)]%nat [-1 # 1; 4 # 1; 1 # 5; 8 # 1] 2 = [179 # 125; 404 # 125; 233 # 125; 584 # 125]. Proof. vm_compute. reflexivity. Qed.
Example form_star4 : formation (2 # 5) [(1, 0); (2, 0); (3, 0); (1, 1)]%nat [-1 # 1; 1 # 2; 2 # 3; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1] = [10 # 3; 3 # 10; -2 # 15; 26 # 5]. Proof. vm_compute. reflexivity. Qed.
Example meet_ring4 : meeting (2 # 5) [(0, 1); (1, 2); (2, 3); (3, 0); (1, 0)]%nat [-1 # 1; 4 # 1; 1 # 5; 8 # 1] 2 = [203 # 125; 484 # 125; 209 # 125; 504 # 125]. Proof. vm_compute. reflexivity. Qed.
Example form_ring4 : formation (2 # 5) [(0, 1); (1, 2); (2, 3); (3, 0); (1, 0)]%nat [-1 # 1; 1 # 2; 2 # 3; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1] = [8 # 3; 11 # 30; 17 # 5; 34 # 15]. Proof. vm_compute. reflexivity. Qed.
Example alone4_0 : alone (-1 # 1) (8 # 1) (2 # 5) 2 4 (-4 # 3) (1 # 1) (-1 # 3) 0 6 = [-4 # 3; -1 # 1; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example alone4_1 : alone (-1 # 1) (8 # 1) (2 # 5) 2 4 (-4 # 3) (1 # 1) (-1 # 3) 1 6 = [-4 # 3; -19 # 25; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example alone4_3 : alone (-1 # 1) (8 # 1) (2 # 5) 2 4 (-4 # 3) (1 # 1) (-1 # 3) 3 6 = [-4 # 3; 8 # 1; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example quantities4 : quantities (-1 # 1) (8 # 1) [-1 # 1; 4 # 1; 1 # 5; 8 # 1] = [3 # 1; 56 # 5; 6084 # 25; 5 # 1; -19 # 5; 39 # 5; -3 # 1; 6 # 1; 15 # 1; 24 # 1; 0 # 1; -6 # 1; 72 # 5; 0 # 1; 0 # 1; 2 # 1; 2 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example residual4 : residual (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1] = [-824 # 75]. Proof. vm_compute. reflexivity. Qed.
Example targets4 : predicates (-1 # 1) (8 # 1) [-1 # 1; 2 # 1; 5 # 1; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 1 # 1; 1 # 1; 1 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example behind4 : predicates (-1 # 1) (8 # 1) [-1 # 1; 17 # 9; 44 # 9; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 1 # 1; 0 # 1; 0 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example before4 : predicates (-1 # 1) (8 # 1) [-1 # 1; 19 # 9; 46 # 9; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 0 # 1; 0 # 1; 1 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example crowd4 : predicates (-1 # 1) (8 # 1) [-1 # 1; -99 # 100; -49 # 50; 8 # 1] = [1 # 1; 1 # 1; 1 # 1; 1 # 1; 0 # 1; 0 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example mixed4 : predicates (-1 # 1) (8 # 1) [-1 # 1; 4 # 1; 1 # 5; 8 # 1] = [1 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example loose4 : predicates (-1 # 1) (8 # 1) [-4 # 3; 1 # 1; -1 # 3; 2 # 1] = [0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical4_half : critical (1 # 1) (2 # 1) 4 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical4_low : critical (53 # 1) (100 # 1) 4 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical4_five : critical (55 # 1) (100 # 1) 4 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical4_four : critical (58 # 1) (100 # 1) 4 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical4_middle : critical (60 # 1) (100 # 1) 4 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical4_high : critical (2 # 1) (3 # 1) 4 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical4_one : critical (1 # 1) (1 # 1) 4 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical4_zero : critical (0 # 1) (1 # 1) 4 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones5_first_1 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] 1 = [-1 # 1; 12 # 25; 131 # 25; 127 # 25; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones5_first_3 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] 3 = [-1 # 1; 12 # 25; 131 # 25; 127 # 25; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones5_first_7 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] 7 = [-1 # 1; 792 # 625; 487 # 125; 3607 # 625; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones5_last_1 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] 1 = [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones5_last_3 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] 3 = [-1 # 1; 12 # 25; 131 # 25; 127 # 25; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones5_last_7 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] 7 = [-1 # 1; 224 # 125; 409 # 125; 789 # 125; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest5_first : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] [false; true; true; false; true] = [-1 # 1; 12 # 25; 131 # 25; 9 # 1; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest5_second : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] [true; false; true; true; false] = [-1 # 1; 4 # 1; 131 # 25; 127 # 25; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest5_third : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] [true; true; false; true; true] = [-1 # 1; 12 # 25; 1 # 5; 127 # 25; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example late5 : delayed (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 1 # 2; 2 # 3; 3 # 1; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3; 1 # 3; -1 # 1; 4 # 3; 0 # 1; -4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3; 1 # 3; -1 # 1; 4 # 3; 0 # 1; -4 # 3; 1 # 1; -1 # 3] = [-1 # 1; -1 # 30; -8 # 15; 13 # 15; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example meet_star5 : meeting (2 # 5) [(1, 0); (2, 0); (3, 0); (4, 0); (1, 1)]%nat [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] 2 = [-1 # 1; 604 # 125; 433 # 125; 829 # 125; 784 # 125]. Proof. vm_compute. reflexivity. Qed.
Example form_star5 : formation (2 # 5) [(1, 0); (2, 0); (3, 0); (4, 0); (1, 1)]%nat [-1 # 1; 1 # 2; 2 # 3; 3 # 1; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3] = [74 # 15; 3 # 10; -2 # 15; 11 # 5; 14 # 3]. Proof. vm_compute. reflexivity. Qed.
Example meet_ring5 : meeting (2 # 5) [(0, 1); (1, 2); (2, 3); (3, 4); (4, 0); (1, 0)]%nat [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] 2 = [379 # 125; 504 # 125; 409 # 125; 629 # 125; 604 # 125]. Proof. vm_compute. reflexivity. Qed.
Example form_ring5 : formation (2 # 5) [(0, 1); (1, 2); (2, 3); (3, 4); (4, 0); (1, 0)]%nat [-1 # 1; 1 # 2; 2 # 3; 3 # 1; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3] = [8 # 3; 11 # 30; 7 # 5; 73 # 15; 8 # 3]. Proof. vm_compute. reflexivity. Qed.
Example alone5_0 : alone (-1 # 1) (8 # 1) (2 # 5) 2 5 (-4 # 3) (1 # 1) (-1 # 3) 0 6 = [-4 # 3; -1 # 1; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example alone5_1 : alone (-1 # 1) (8 # 1) (2 # 5) 2 5 (-4 # 3) (1 # 1) (-1 # 3) 1 6 = [-4 # 3; -19 # 25; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example alone5_4 : alone (-1 # 1) (8 # 1) (2 # 5) 2 5 (-4 # 3) (1 # 1) (-1 # 3) 4 6 = [-4 # 3; 8 # 1; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example quantities5 : quantities (-1 # 1) (8 # 1) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] = [4 # 1; 101 # 5; 11606 # 25; 5 # 1; -19 # 5; 44 # 5; -1 # 1; -4 # 1; 5 # 1; 14 # 1; 23 # 1; 32 # 1; 0 # 1; -11 # 1; 66 # 5; -13 # 1; 0 # 1; 0 # 1; 3 # 1; 4 # 1; 3 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example residual5 : residual (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3] = [-79 # 5]. Proof. vm_compute. reflexivity. Qed.
Example targets5 : predicates (-1 # 1) (8 # 1) [-1 # 1; 5 # 4; 7 # 2; 23 # 4; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 1 # 1; 1 # 1; 1 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example behind5 : predicates (-1 # 1) (8 # 1) [-1 # 1; 41 # 36; 61 # 18; 203 # 36; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 1 # 1; 0 # 1; 0 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example before5 : predicates (-1 # 1) (8 # 1) [-1 # 1; 49 # 36; 65 # 18; 211 # 36; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 0 # 1; 0 # 1; 1 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example crowd5 : predicates (-1 # 1) (8 # 1) [-1 # 1; -99 # 100; -49 # 50; -97 # 100; 8 # 1] = [1 # 1; 1 # 1; 1 # 1; 1 # 1; 0 # 1; 0 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example mixed5 : predicates (-1 # 1) (8 # 1) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; 8 # 1] = [1 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example loose5 : predicates (-1 # 1) (8 # 1) [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3] = [0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical5_half : critical (1 # 1) (2 # 1) 5 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical5_low : critical (53 # 1) (100 # 1) 5 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical5_five : critical (55 # 1) (100 # 1) 5 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical5_four : critical (58 # 1) (100 # 1) 5 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical5_middle : critical (60 # 1) (100 # 1) 5 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical5_high : critical (2 # 1) (3 # 1) 5 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical5_one : critical (1 # 1) (1 # 1) 5 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical5_zero : critical (0 # 1) (1 # 1) 5 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones6_first_1 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] 1 = [-1 # 1; 12 # 25; 131 # 25; 91 # 75; 97 # 15; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones6_first_3 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] 3 = [-1 # 1; 12 # 25; 131 # 25; 91 # 75; 97 # 15; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones6_first_7 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] 7 = [-1 # 1; 1216 # 1875; 379 # 125; 11 # 3; 11561 # 1875; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones6_last_1 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] 1 = [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones6_last_3 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] 3 = [-1 # 1; 12 # 25; 131 # 25; 91 # 75; 97 # 15; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones6_last_7 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] 7 = [-1 # 1; 224 # 125; 647 # 375; 1847 # 375; 1867 # 375; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest6_first : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] [false; true; true; false; true; true] = [-1 # 1; 12 # 25; 131 # 25; 9 # 1; 97 # 15; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest6_second : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] [true; false; true; true; false; true] = [-1 # 1; 4 # 1; 131 # 25; 91 # 75; -5 # 3; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest6_third : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] [true; true; false; true; true; false] = [-1 # 1; 12 # 25; 1 # 5; 91 # 75; 97 # 15; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example late6 : delayed (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 1 # 2; 2 # 3; 3 # 1; 7 # 2; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3; 1 # 3; -1 # 1; 4 # 3; 0 # 1; -4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3; 1 # 3; -1 # 1; 4 # 3; 0 # 1; -4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3; 1 # 3; -1 # 1; 4 # 3; 0 # 1; -4 # 3; 1 # 1; -1 # 3] = [-1 # 1; 11 # 30; 4 # 15; 3 # 5; 17 # 30; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example meet_star6 : meeting (2 # 5) [(1, 0); (2, 0); (3, 0); (4, 0); (5, 0); (1, 1)]%nat [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] 2 = [-1847 # 375; 1772 # 375; 1259 # 375; 2447 # 375; 1007 # 375; 2312 # 375]. Proof. vm_compute. reflexivity. Qed.
Example form_star6 : formation (2 # 5) [(1, 0); (2, 0); (3, 0); (4, 0); (5, 0); (1, 1)]%nat [-1 # 1; 1 # 2; 2 # 3; 3 # 1; 7 # 2; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3] = [101 # 15; 3 # 10; -2 # 15; 11 # 5; 59 # 30; 62 # 15]. Proof. vm_compute. reflexivity. Qed.
Example meet_ring6 : meeting (2 # 5) [(0, 1); (1, 2); (2, 3); (3, 4); (4, 5); (5, 0); (1, 0)]%nat [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] 2 = [497 # 375; 504 # 125; 647 # 375; 1847 # 375; 249 # 125; 68 # 15]. Proof. vm_compute. reflexivity. Qed.
Example form_ring6 : formation (2 # 5) [(0, 1); (1, 2); (2, 3); (3, 4); (4, 5); (5, 0); (1, 0)]%nat [-1 # 1; 1 # 2; 2 # 3; 3 # 1; 7 # 2; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3] = [8 # 3; 11 # 30; 7 # 5; 46 # 15; 161 # 30; 7 # 3]. Proof. vm_compute. reflexivity. Qed.
Example alone6_0 : alone (-1 # 1) (8 # 1) (2 # 5) 2 6 (-4 # 3) (1 # 1) (-1 # 3) 0 6 = [-4 # 3; -1 # 1; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example alone6_1 : alone (-1 # 1) (8 # 1) (2 # 5) 2 6 (-4 # 3) (1 # 1) (-1 # 3) 1 6 = [-4 # 3; -19 # 25; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example alone6_5 : alone (-1 # 1) (8 # 1) (2 # 5) 2 6 (-4 # 3) (1 # 1) (-1 # 3) 5 6 = [-4 # 3; 8 # 1; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example quantities6 : quantities (-1 # 1) (8 # 1) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] = [5 # 1; 278 # 15; 22285 # 9; 5 # 1; -19 # 5; 44 # 5; -32 # 3; 29 # 3; -5 # 1; 4 # 1; 13 # 1; 22 # 1; 31 # 1; 40 # 1; 0 # 1; -16 # 1; 12 # 1; -23 # 1; 118 # 3; 0 # 1; 0 # 1; 4 # 1; 6 # 1; 6 # 1; 4 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example residual6 : residual (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3] = [-286 # 15]. Proof. vm_compute. reflexivity. Qed.
Example targets6 : predicates (-1 # 1) (8 # 1) [-1 # 1; 4 # 5; 13 # 5; 22 # 5; 31 # 5; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 1 # 1; 1 # 1; 1 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example behind6 : predicates (-1 # 1) (8 # 1) [-1 # 1; 31 # 45; 112 # 45; 193 # 45; 274 # 45; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 1 # 1; 0 # 1; 0 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example before6 : predicates (-1 # 1) (8 # 1) [-1 # 1; 41 # 45; 122 # 45; 203 # 45; 284 # 45; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 0 # 1; 0 # 1; 1 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example crowd6 : predicates (-1 # 1) (8 # 1) [-1 # 1; -99 # 100; -49 # 50; -97 # 100; -24 # 25; 8 # 1] = [1 # 1; 1 # 1; 1 # 1; 1 # 1; 0 # 1; 0 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example mixed6 : predicates (-1 # 1) (8 # 1) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 8 # 1] = [1 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example loose6 : predicates (-1 # 1) (8 # 1) [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3] = [0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical6_half : critical (1 # 1) (2 # 1) 6 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical6_low : critical (53 # 1) (100 # 1) 6 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical6_five : critical (55 # 1) (100 # 1) 6 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical6_four : critical (58 # 1) (100 # 1) 6 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical6_middle : critical (60 # 1) (100 # 1) 6 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical6_high : critical (2 # 1) (3 # 1) 6 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical6_one : critical (1 # 1) (1 # 1) 6 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical6_zero : critical (0 # 1) (1 # 1) 6 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones7_first_1 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] 1 = [-1 # 1; 12 # 25; 131 # 25; 91 # 75; 17 # 3; 56 # 15; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones7_first_3 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] 3 = [-1 # 1; 12 # 25; 131 # 25; 91 # 75; 17 # 3; 56 # 15; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones7_first_7 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 First [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] 7 = [-1 # 1; 1216 # 1875; 363 # 125; 357 # 125; 9281 # 1875; 10664 # 1875; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones7_last_1 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] 1 = [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones7_last_3 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] 3 = [-1 # 1; 12 # 25; 131 # 25; 91 # 75; 17 # 3; 56 # 15; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example drones7_last_7 : coverage (-1 # 1) (8 # 1) (2 # 5) 2 Last [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] 7 = [-1 # 1; 224 # 125; 647 # 375; 1727 # 375; 389 # 125; 466 # 75; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest7_first : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] [false; true; true; false; true; true; false] = [-1 # 1; 12 # 25; 131 # 25; 9 # 1; 17 # 3; 56 # 15; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest7_second : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] [true; false; true; true; false; true; true] = [-1 # 1; 4 # 1; 131 # 25; 91 # 75; -5 # 3; 56 # 15; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example rest7_third : active (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] [true; true; false; true; true; false; true] = [-1 # 1; 12 # 25; 1 # 5; 91 # 75; 17 # 3; 6 # 1; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example late7 : delayed (-1 # 1) (8 # 1) (2 # 5) [-1 # 1; 1 # 2; 2 # 3; 3 # 1; 7 # 2; 27 # 4; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3; 1 # 3; -1 # 1; 4 # 3; 0 # 1; -4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3; 1 # 3; -1 # 1; 4 # 3; 0 # 1; -4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3; 1 # 3; -1 # 1; 4 # 3; 0 # 1; -4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3; 1 # 3; -1 # 1; 4 # 3; 0 # 1; -4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3] = [-1 # 1; 23 # 30; 16 # 15; 9 # 5; 7 # 10; 97 # 60; 8 # 1]. Proof. vm_compute. reflexivity. Qed.
Example meet_star7 : meeting (2 # 5) [(1, 0); (2, 0); (3, 0); (4, 0); (5, 0); (6, 0); (1, 1)]%nat [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] 2 = [-4159 # 375; 2192 # 375; 1679 # 375; 2867 # 375; 1427 # 375; 2462 # 375; 2732 # 375]. Proof. vm_compute. reflexivity. Qed.
Example form_star7 : formation (2 # 5) [(1, 0); (2, 0); (3, 0); (4, 0); (5, 0); (6, 0); (1, 1)]%nat [-1 # 1; 1 # 2; 2 # 3; 3 # 1; 7 # 2; 27 # 4; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3] = [59 # 6; 3 # 10; -2 # 15; 11 # 5; 59 # 30; 203 # 60; 76 # 15]. Proof. vm_compute. reflexivity. Qed.
Example meet_ring7 : meeting (2 # 5) [(0, 1); (1, 2); (2, 3); (3, 4); (4, 5); (5, 6); (6, 0); (1, 0)]%nat [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] 2 = [319 # 125; 504 # 125; 647 # 375; 1727 # 375; 389 # 125; 334 # 75; 304 # 75]. Proof. vm_compute. reflexivity. Qed.
Example form_ring7 : formation (2 # 5) [(0, 1); (1, 2); (2, 3); (3, 4); (4, 5); (5, 6); (6, 0); (1, 0)]%nat [-1 # 1; 1 # 2; 2 # 3; 3 # 1; 7 # 2; 27 # 4; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3] = [8 # 3; 11 # 30; 7 # 5; 46 # 15; 73 # 15; 341 # 60; 137 # 30]. Proof. vm_compute. reflexivity. Qed.
Example alone7_0 : alone (-1 # 1) (8 # 1) (2 # 5) 2 7 (-4 # 3) (1 # 1) (-1 # 3) 0 6 = [-4 # 3; -1 # 1; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example alone7_1 : alone (-1 # 1) (8 # 1) (2 # 5) 2 7 (-4 # 3) (1 # 1) (-1 # 3) 1 6 = [-4 # 3; -19 # 25; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example alone7_6 : alone (-1 # 1) (8 # 1) (2 # 5) 2 7 (-4 # 3) (1 # 1) (-1 # 3) 6 6 = [-4 # 3; 8 # 1; -1 # 3]. Proof. vm_compute. reflexivity. Qed.
Example quantities7 : quantities (-1 # 1) (8 # 1) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] = [6 # 1; 368 # 15; 81391 # 25; 5 # 1; -19 # 5; 44 # 5; -32 # 3; 23 # 3; 2 # 1; -6 # 1; 3 # 1; 12 # 1; 21 # 1; 30 # 1; 39 # 1; 48 # 1; 0 # 1; -21 # 1; 54 # 5; -33 # 1; 40 # 1; 3 # 1; 0 # 1; 0 # 1; 5 # 1; 8 # 1; 9 # 1; 8 # 1; 5 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example residual7 : residual (2 # 5) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3] = [-61 # 3]. Proof. vm_compute. reflexivity. Qed.
Example targets7 : predicates (-1 # 1) (8 # 1) [-1 # 1; 1 # 2; 2 # 1; 7 # 2; 5 # 1; 13 # 2; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 1 # 1; 1 # 1; 1 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example behind7 : predicates (-1 # 1) (8 # 1) [-1 # 1; 7 # 18; 17 # 9; 61 # 18; 44 # 9; 115 # 18; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 1 # 1; 0 # 1; 0 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example before7 : predicates (-1 # 1) (8 # 1) [-1 # 1; 11 # 18; 19 # 9; 65 # 18; 46 # 9; 119 # 18; 8 # 1] = [1 # 1; 1 # 1; 0 # 1; 0 # 1; 0 # 1; 1 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example crowd7 : predicates (-1 # 1) (8 # 1) [-1 # 1; -99 # 100; -49 # 50; -97 # 100; -24 # 25; -19 # 20; 8 # 1] = [1 # 1; 1 # 1; 1 # 1; 1 # 1; 0 # 1; 0 # 1; 1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example mixed7 : predicates (-1 # 1) (8 # 1) [-1 # 1; 4 # 1; 1 # 5; 9 # 1; -5 # 3; 6 # 1; 8 # 1] = [1 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example loose7 : predicates (-1 # 1) (8 # 1) [-4 # 3; 1 # 1; -1 # 3; 2 # 1; 2 # 3; -2 # 3; 5 # 3] = [0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1; 0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical7_half : critical (1 # 1) (2 # 1) 7 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical7_low : critical (53 # 1) (100 # 1) 7 = [1 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical7_five : critical (55 # 1) (100 # 1) 7 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical7_four : critical (58 # 1) (100 # 1) 7 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical7_middle : critical (60 # 1) (100 # 1) 7 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical7_high : critical (2 # 1) (3 # 1) 7 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical7_one : critical (1 # 1) (1 # 1) 7 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
Example critical7_zero : critical (0 # 1) (1 # 1) 7 = [0 # 1]. Proof. vm_compute. reflexivity. Qed.
