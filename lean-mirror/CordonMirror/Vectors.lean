import CordonMirror.Spec.Coverage
import CordonMirror.Spec.Local
import CordonMirror.Spec.Consensus

/-! Generated from proofs/rocq/vectors.tsv: do not edit. The format is described in README.md. -/

namespace CordonMirror.Vectors

def coverage (min max eps : Rat) (n : Nat) (phase : Phase) (start : List Rat) (k : Nat) :
    List Rat :=
  (kth_step (Params.mk min max eps n) (initial start n phase) k).drones

def local_swarm (min max eps : Rat) (num den : Nat) (phase : Phase) (start : List Rat) (k : Nat) :
    List Rat :=
  let ratio := TickRatio.mk num den
  let p := Params.mk min max eps (counter_limit ratio)
  let machines := swarm_of p (initial start p.n phase)
  List.map (fun m => m.st.own)
    (swarm_kth_step (LocalParams.mk p start.length ratio) machines k)

def consensus (eps : Rat) (start : List Rat) (k : Nat) : List Rat :=
  consensus_step eps (path start.length) start k

/-- Both lists are of rationals here, so that the fractions below are read as such. -/
def agree (computed expected : List Rat) : Bool := computed == expected

#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 0) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] -- paper_first_0
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 1) [0 / 1, 10 / 1, 20 / 1, 42 / 1, 100 / 1] -- paper_first_1
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 2) [0 / 1, 10 / 1, 20 / 1, 42 / 1, 100 / 1] -- paper_first_2
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 4) [0 / 1, 10 / 1, 20 / 1, 42 / 1, 100 / 1] -- paper_first_4
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 5) [0 / 1, 10 / 1, 112 / 5, 246 / 5, 100 / 1] -- paper_first_5
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 8) [0 / 1, 10 / 1, 112 / 5, 246 / 5, 100 / 1] -- paper_first_8
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 9) [0 / 1, 262 / 25, 632 / 25, 54 / 1, 100 / 1] -- paper_first_9
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 13) [0 / 1, 1418 / 125, 3508 / 125, 7182 / 125, 100 / 1] -- paper_first_13
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 20) [0 / 1, 7762 / 625, 19124 / 625, 37554 / 625, 100 / 1] -- paper_first_20
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 21) [0 / 1, 8482 / 625, 102688 / 3125, 194286 / 3125, 100 / 1] -- paper_first_21
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 37) [0 / 1, 34620002 / 1953125, 77312656 / 1953125, 131921958 / 1953125, 100 / 1] -- paper_first_37
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 40) [0 / 1, 34620002 / 1953125, 77312656 / 1953125, 131921958 / 1953125, 100 / 1] -- paper_first_40
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 0) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] -- paper_last_0
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 1) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] -- paper_last_1
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 3) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] -- paper_last_3
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 4) [0 / 1, 10 / 1, 20 / 1, 42 / 1, 100 / 1] -- paper_last_4
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 5) [0 / 1, 10 / 1, 20 / 1, 42 / 1, 100 / 1] -- paper_last_5
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 8) [0 / 1, 10 / 1, 112 / 5, 246 / 5, 100 / 1] -- paper_last_8
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 12) [0 / 1, 262 / 25, 632 / 25, 54 / 1, 100 / 1] -- paper_last_12
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 20) [0 / 1, 7762 / 625, 19124 / 625, 37554 / 625, 100 / 1] -- paper_last_20
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 3 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 40) [0 / 1, 34620002 / 1953125, 77312656 / 1953125, 131921958 / 1953125, 100 / 1] -- paper_last_40
#guard agree (coverage (0 / 1) (100 / 1) (7 / 10) 13 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 0) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] -- high_weight_0
#guard agree (coverage (0 / 1) (100 / 1) (7 / 10) 13 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 1) [0 / 1, 10 / 1, 20 / 1, 72 / 1, 100 / 1] -- high_weight_1
#guard agree (coverage (0 / 1) (100 / 1) (7 / 10) 13 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 14) [0 / 1, 10 / 1, 20 / 1, 72 / 1, 100 / 1] -- high_weight_14
#guard agree (coverage (0 / 1) (100 / 1) (7 / 10) 13 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 15) [0 / 1, 10 / 1, 247 / 5, 276 / 5, 100 / 1] -- high_weight_15
#guard agree (coverage (0 / 1) (100 / 1) (7 / 10) 13 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 29) [0 / 1, 1529 / 50, 647 / 25, 165 / 2, 100 / 1] -- high_weight_29
#guard agree (coverage (0 / 1) (100 / 1) (7 / 10) 13 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 57) [0 / 1, 114523 / 2500, 18973 / 1250, 240291 / 2500, 100 / 1] -- high_weight_57
#guard agree (coverage (0 / 1) (100 / 1) (7 / 10) 13 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 99) [0 / 1, -22857323 / 625000, 85016717 / 625000, 8380389 / 625000, 100 / 1] -- high_weight_99
#guard agree (coverage (0 / 1) (100 / 1) (7 / 10) 13 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 150) [0 / 1, 59149945319 / 312500000, -28522788907 / 156250000, 14955067707 / 62500000, 100 / 1] -- high_weight_150
#guard agree (coverage (0 / 1) (10 / 1) (1 / 4) 5 Phase.First [0 / 1, 1 / 1, 2 / 1, 3 / 1, 10 / 1] 0) [0 / 1, 1 / 1, 2 / 1, 3 / 1, 10 / 1] -- recorded_0
#guard agree (coverage (0 / 1) (10 / 1) (1 / 4) 5 Phase.First [0 / 1, 1 / 1, 2 / 1, 3 / 1, 10 / 1] 1) [0 / 1, 1 / 1, 2 / 1, 9 / 2, 10 / 1] -- recorded_1
#guard agree (coverage (0 / 1) (10 / 1) (1 / 4) 5 Phase.First [0 / 1, 1 / 1, 2 / 1, 3 / 1, 10 / 1] 6) [0 / 1, 1 / 1, 2 / 1, 9 / 2, 10 / 1] -- recorded_6
#guard agree (coverage (0 / 1) (10 / 1) (1 / 4) 5 Phase.First [0 / 1, 1 / 1, 2 / 1, 3 / 1, 10 / 1] 7) [0 / 1, 1 / 1, 19 / 8, 21 / 4, 10 / 1] -- recorded_7
#guard agree (coverage (0 / 1) (10 / 1) (1 / 4) 5 Phase.First [0 / 1, 1 / 1, 2 / 1, 3 / 1, 10 / 1] 60) [0 / 1, 64745 / 32768, 139483 / 32768, 228489 / 32768, 10 / 1] -- recorded_60
#guard agree (coverage (0 / 1) (10 / 1) (1 / 4) 5 Phase.First [0 / 1, 1 / 1, 2 / 1, 3 / 1, 10 / 1] 121) [0 / 1, 10341912343 / 4294967296, 5228875583 / 1073741824, 31816742679 / 4294967296, 10 / 1] -- recorded_121
#guard agree (coverage (-1 / 1) (2 / 1) (1 / 1) 0 Phase.First [-1 / 1, -1 / 4, 2 / 1] 0) [-1 / 1, -1 / 4, 2 / 1] -- three_drones_0
#guard agree (coverage (-1 / 1) (2 / 1) (1 / 1) 0 Phase.First [-1 / 1, -1 / 4, 2 / 1] 1) [-1 / 1, 5 / 4, 2 / 1] -- three_drones_1
#guard agree (coverage (-1 / 1) (2 / 1) (1 / 1) 0 Phase.First [-1 / 1, -1 / 4, 2 / 1] 2) [-1 / 1, -1 / 4, 2 / 1] -- three_drones_2
#guard agree (coverage (-1 / 1) (2 / 1) (1 / 1) 0 Phase.First [-1 / 1, -1 / 4, 2 / 1] 3) [-1 / 1, 5 / 4, 2 / 1] -- three_drones_3
#guard agree (coverage (-1 / 1) (2 / 1) (1 / 3) 1 Phase.Last [-1 / 1, -1 / 4, 2 / 1] 1) [-1 / 1, -1 / 4, 2 / 1] -- three_drones_last_1
#guard agree (coverage (-1 / 1) (2 / 1) (1 / 3) 1 Phase.Last [-1 / 1, -1 / 4, 2 / 1] 2) [-1 / 1, 1 / 4, 2 / 1] -- three_drones_last_2
#guard agree (coverage (-1 / 1) (2 / 1) (1 / 3) 1 Phase.Last [-1 / 1, -1 / 4, 2 / 1] 3) [-1 / 1, 1 / 4, 2 / 1] -- three_drones_last_3
#guard agree (coverage (-1 / 1) (2 / 1) (1 / 3) 1 Phase.Last [-1 / 1, -1 / 4, 2 / 1] 4) [-1 / 1, 5 / 12, 2 / 1] -- three_drones_last_4
#guard agree (coverage (-1 / 1) (2 / 1) (1 / 3) 1 Phase.Last [-1 / 1, -1 / 4, 2 / 1] 7) [-1 / 1, 17 / 36, 2 / 1] -- three_drones_last_7
#guard agree (coverage (0 / 1) (100 / 1) (1 / 5) 0 Phase.First [0 / 1, 10 / 1, 11 / 1, 24 / 1, 100 / 1] 1) [0 / 1, 41 / 5, 67 / 5, 183 / 5, 100 / 1] -- not_monotonic_1
#guard agree (coverage (0 / 1) (1 / 1) (3 / 5) 0 Phase.First [0 / 1, 1 / 10, 9 / 10, 1 / 1] 0) [0 / 1, 1 / 10, 9 / 10, 1 / 1] -- crossing_0
#guard agree (coverage (0 / 1) (1 / 1) (3 / 5) 0 Phase.First [0 / 1, 1 / 10, 9 / 10, 1 / 1] 1) [0 / 1, 13 / 25, 12 / 25, 1 / 1] -- crossing_1
#guard agree (coverage (0 / 1) (6 / 1) (1 / 2) 0 Phase.First [0 / 1, 1 / 7, 2 / 7, 3 / 7, 4 / 7, 5 / 7, 6 / 1] 1) [0 / 1, 1 / 7, 2 / 7, 3 / 7, 4 / 7, 23 / 7, 6 / 1] -- seven_drones_1
#guard agree (coverage (0 / 1) (6 / 1) (1 / 2) 0 Phase.First [0 / 1, 1 / 7, 2 / 7, 3 / 7, 4 / 7, 5 / 7, 6 / 1] 2) [0 / 1, 1 / 7, 2 / 7, 3 / 7, 13 / 7, 23 / 7, 6 / 1] -- seven_drones_2
#guard agree (coverage (0 / 1) (6 / 1) (1 / 2) 0 Phase.First [0 / 1, 1 / 7, 2 / 7, 3 / 7, 4 / 7, 5 / 7, 6 / 1] 3) [0 / 1, 1 / 7, 2 / 7, 15 / 14, 13 / 7, 55 / 14, 6 / 1] -- seven_drones_3
#guard agree (coverage (0 / 1) (6 / 1) (1 / 2) 0 Phase.First [0 / 1, 1 / 7, 2 / 7, 3 / 7, 4 / 7, 5 / 7, 6 / 1] 10) [0 / 1, 533 / 896, 89 / 64, 1959 / 896, 6073 / 1792, 2057 / 448, 6 / 1] -- seven_drones_10
#guard agree (local_swarm (0 / 1) (100 / 1) (1 / 5) 7 2 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 0) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] -- local_first_0
#guard agree (local_swarm (0 / 1) (100 / 1) (1 / 5) 7 2 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 1) [0 / 1, 10 / 1, 20 / 1, 42 / 1, 100 / 1] -- local_first_1
#guard agree (local_swarm (0 / 1) (100 / 1) (1 / 5) 7 2 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 5) [0 / 1, 10 / 1, 20 / 1, 42 / 1, 100 / 1] -- local_first_5
#guard agree (local_swarm (0 / 1) (100 / 1) (1 / 5) 7 2 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 6) [0 / 1, 10 / 1, 112 / 5, 246 / 5, 100 / 1] -- local_first_6
#guard agree (local_swarm (0 / 1) (100 / 1) (1 / 5) 7 2 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 11) [0 / 1, 262 / 25, 632 / 25, 54 / 1, 100 / 1] -- local_first_11
#guard agree (local_swarm (0 / 1) (100 / 1) (1 / 5) 7 2 Phase.First [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 20) [0 / 1, 1418 / 125, 3508 / 125, 7182 / 125, 100 / 1] -- local_first_20
#guard agree (local_swarm (0 / 1) (100 / 1) (1 / 5) 4 1 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 0) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] -- local_last_0
#guard agree (local_swarm (0 / 1) (100 / 1) (1 / 5) 4 1 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 4) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] -- local_last_4
#guard agree (local_swarm (0 / 1) (100 / 1) (1 / 5) 4 1 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 5) [0 / 1, 10 / 1, 20 / 1, 42 / 1, 100 / 1] -- local_last_5
#guard agree (local_swarm (0 / 1) (100 / 1) (1 / 5) 4 1 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 10) [0 / 1, 10 / 1, 112 / 5, 246 / 5, 100 / 1] -- local_last_10
#guard agree (local_swarm (0 / 1) (100 / 1) (1 / 5) 4 1 Phase.Last [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 20) [0 / 1, 1418 / 125, 3508 / 125, 7182 / 125, 100 / 1] -- local_last_20
#guard agree (consensus (3 / 10) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 0) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] -- rendezvous_0
#guard agree (consensus (3 / 10) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 1) [3 / 1, 10 / 1, 20 / 1, 48 / 1, 79 / 1] -- rendezvous_1
#guard agree (consensus (3 / 10) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 2) [51 / 10, 109 / 10, 127 / 5, 489 / 10, 697 / 10] -- rendezvous_2
#guard agree (consensus (3 / 10) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 5) [21909 / 2000, 179227 / 10000, 6133 / 200, 452523 / 10000, 110411 / 2000] -- rendezvous_5
#guard agree (consensus (3 / 10) [0 / 1, 10 / 1, 20 / 1, 30 / 1, 100 / 1] 10) [4007373513 / 200000000, 12266063123 / 500000000, 6381643 / 200000, 2463196719 / 62500000, 8822328737 / 200000000] -- rendezvous_10

end CordonMirror.Vectors
