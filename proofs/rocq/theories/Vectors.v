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
