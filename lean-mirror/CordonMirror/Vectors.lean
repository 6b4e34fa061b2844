import CordonMirror.Spec.Coverage
import CordonMirror.Spec.Local
import CordonMirror.Spec.Consensus
import CordonMirror.Spec.Formation
import CordonMirror.Spec.Activation
import CordonMirror.Spec.Delay
import CordonMirror.Spec.Theorems.NonDecreasing
import CordonMirror.Thm.Decide

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

def alone (min max eps : Rat) (n drones : Nat) (prec own foll : Rat) (id k : Nat) : List Rat :=
  let p := LocalParams.mk (Params.mk min max eps n) drones (whole n)
  let l := (fmu_kth_step p (SimState.mk 0 (LocalState.mk prec own foll id)) k).st
  [l.prec, l.own, l.foll]

def consensus (eps : Rat) (start : List Rat) (k : Nat) : List Rat :=
  consensus_step eps (path start.length) start k

def meeting (eps : Rat) (edges : List (Nat × Nat)) (start : List Rat) (k : Nat) : List Rat :=
  consensus_step eps (edge_graph start.length edges) start k

def formation (eps : Rat) (edges : List (Nat × Nat)) (start input : List Rat) : List Rat :=
  exec_formation eps (edge_graph start.length edges) start input

def active (min max eps : Rat) (start : List Rat) (flags : List Bool) : List Rat :=
  (exec_coverage_active (Params.mk min max eps 0) (State.mk start 0)
    (fun i => get_or false flags i)).drones

def delayed (min max eps : Rat) (start seen : List Rat) : List Rat :=
  (exec_coverage_delayed (Params.mk min max eps 0) (State.mk start 0)
    (fun i j => get seen (i * start.length + j))).drones

def quantities (min max : Rat) (x : List Rat) : List Rat :=
  let all := lambda (count x) (fun i => i)
  [gaps x, sum x, scaled_energy min max x] ++ lambda (count x - 1) (gap x) ++
    all.map (scaled_target min max (count x)) ++ all.map (scaled_error min max x) ++
    all.map (fun i => ((contraction_weight (count x) i : Nat) : Rat))

def residual (eps : Rat) (before after : List Rat) : List Rat :=
  [telescoping_residual eps before after]

def yes (P : Prop) [Decidable P] : Rat := if P then 1 else 0

def predicates (min max : Rat) (x : List Rat) : List Rat :=
  let p := Params.mk min max 0 0
  [yes (anchored p x), yes (anchored p x ∧ ordered x),
    yes (anchored p x ∧ ordered x ∧ in_first_subsegment p x),
    yes (anchored p x ∧ upper_bounded p x), yes (at_targets p x), yes (above_targets p x),
    yes (in_box p x)]

def critical (num den : Rat) (drones : Nat) : List Rat :=
  [yes (0 < num ∧ below_critical num den drones)]

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
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 8 / 1] 1) [-1 / 1, 18 / 5, 8 / 1] -- drones3_first_1
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 8 / 1] 3) [-1 / 1, 18 / 5, 8 / 1] -- drones3_first_3
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 8 / 1] 7) [-1 / 1, 438 / 125, 8 / 1] -- drones3_first_7
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 8 / 1] 1) [-1 / 1, 4 / 1, 8 / 1] -- drones3_last_1
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 8 / 1] 3) [-1 / 1, 18 / 5, 8 / 1] -- drones3_last_3
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 8 / 1] 7) [-1 / 1, 88 / 25, 8 / 1] -- drones3_last_7
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 8 / 1] [false, true, true]) [-1 / 1, 18 / 5, 8 / 1] -- rest3_first
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 8 / 1] [true, false, true]) [-1 / 1, 4 / 1, 8 / 1] -- rest3_second
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 8 / 1] [true, true, false]) [-1 / 1, 18 / 5, 8 / 1] -- rest3_third
#guard agree (delayed (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 1 / 2, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3, 1 / 3, -1 / 1]) [-1 / 1, 19 / 30, 8 / 1] -- late3
#guard agree (meeting (2 / 5) [(1, 0), (2, 0), (1, 1)] [-1 / 1, 4 / 1, 8 / 1] 2) [87 / 25, 76 / 25, 112 / 25] -- meet_star3
#guard agree (formation (2 / 5) [(1, 0), (2, 0), (1, 1)] [-1 / 1, 1 / 2, 8 / 1] [-4 / 3, 1 / 1, -1 / 3]) [8 / 3, 3 / 10, 64 / 15] -- form_star3
#guard agree (meeting (2 / 5) [(0, 1), (1, 2), (2, 0), (1, 0)] [-1 / 1, 4 / 1, 8 / 1] 2) [87 / 25, 92 / 25, 96 / 25] -- meet_ring3
#guard agree (formation (2 / 5) [(0, 1), (1, 2), (2, 0), (1, 0)] [-1 / 1, 1 / 2, 8 / 1] [-4 / 3, 1 / 1, -1 / 3]) [8 / 3, 33 / 10, 19 / 15] -- form_ring3
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 3 (-4 / 3) (1 / 1) (-1 / 3) 0 6) [-4 / 3, -1 / 1, -1 / 3] -- alone3_0
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 3 (-4 / 3) (1 / 1) (-1 / 3) 1 6) [-4 / 3, -19 / 25, -1 / 3] -- alone3_1
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 3 (-4 / 3) (1 / 1) (-1 / 3) 2 6) [-4 / 3, 8 / 1, -1 / 3] -- alone3_2
#guard agree (quantities (-1 / 1) (8 / 1) [-1 / 1, 4 / 1, 8 / 1]) [2 / 1, 11 / 1, 1 / 1, 5 / 1, 4 / 1, -2 / 1, 7 / 1, 16 / 1, 0 / 1, -1 / 1, 0 / 1, 0 / 1, 1 / 1, 0 / 1] -- quantities3
#guard agree (residual (2 / 5) [-1 / 1, 4 / 1, 8 / 1] [-4 / 3, 1 / 1, -1 / 3]) [-169 / 15] -- residual3
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 7 / 2, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 1 / 1, 1 / 1, 1 / 1, 1 / 1] -- targets3
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 61 / 18, 8 / 1]) [1 / 1, 1 / 1, 1 / 1, 1 / 1, 0 / 1, 0 / 1, 1 / 1] -- behind3
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 65 / 18, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 0 / 1, 0 / 1, 1 / 1, 1 / 1] -- before3
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, -99 / 100, 8 / 1]) [1 / 1, 1 / 1, 1 / 1, 1 / 1, 0 / 1, 0 / 1, 1 / 1] -- crowd3
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 4 / 1, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 0 / 1, 0 / 1, 1 / 1, 1 / 1] -- mixed3
#guard agree (predicates (-1 / 1) (8 / 1) [-4 / 3, 1 / 1, -1 / 3]) [0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1] -- loose3
#guard agree (critical (1 / 1) (2 / 1) 3) [1 / 1] -- critical3_half
#guard agree (critical (53 / 1) (100 / 1) 3) [1 / 1] -- critical3_low
#guard agree (critical (55 / 1) (100 / 1) 3) [1 / 1] -- critical3_five
#guard agree (critical (58 / 1) (100 / 1) 3) [1 / 1] -- critical3_four
#guard agree (critical (60 / 1) (100 / 1) 3) [1 / 1] -- critical3_middle
#guard agree (critical (2 / 1) (3 / 1) 3) [1 / 1] -- critical3_high
#guard agree (critical (1 / 1) (1 / 1) 3) [0 / 1] -- critical3_one
#guard agree (critical (0 / 1) (1 / 1) 3) [0 / 1] -- critical3_zero
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 1 / 5, 8 / 1] 1) [-1 / 1, 12 / 25, 121 / 25, 8 / 1] -- drones4_first_1
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 1 / 5, 8 / 1] 3) [-1 / 1, 12 / 25, 121 / 25, 8 / 1] -- drones4_first_3
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 1 / 5, 8 / 1] 7) [-1 / 1, 1044 / 625, 2953 / 625, 8 / 1] -- drones4_first_7
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 1 / 5, 8 / 1] 1) [-1 / 1, 4 / 1, 1 / 5, 8 / 1] -- drones4_last_1
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 1 / 5, 8 / 1] 3) [-1 / 1, 12 / 25, 121 / 25, 8 / 1] -- drones4_last_3
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 1 / 5, 8 / 1] 7) [-1 / 1, 204 / 125, 109 / 25, 8 / 1] -- drones4_last_7
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 8 / 1] [false, true, true, false]) [-1 / 1, 12 / 25, 121 / 25, 8 / 1] -- rest4_first
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 8 / 1] [true, false, true, true]) [-1 / 1, 4 / 1, 121 / 25, 8 / 1] -- rest4_second
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 8 / 1] [true, true, false, true]) [-1 / 1, 12 / 25, 1 / 5, 8 / 1] -- rest4_third
#guard agree (delayed (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 1 / 2, 2 / 3, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3, 1 / 3, -1 / 1, 4 / 3, 0 / 1, -4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3]) [-1 / 1, 31 / 30, 2 / 15, 8 / 1] -- late4
#guard agree (meeting (2 / 5) [(1, 0), (2, 0), (3, 0), (1, 1)] [-1 / 1, 4 / 1, 1 / 5, 8 / 1] 2) [179 / 125, 404 / 125, 233 / 125, 584 / 125] -- meet_star4
#guard agree (formation (2 / 5) [(1, 0), (2, 0), (3, 0), (1, 1)] [-1 / 1, 1 / 2, 2 / 3, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1]) [10 / 3, 3 / 10, -2 / 15, 26 / 5] -- form_star4
#guard agree (meeting (2 / 5) [(0, 1), (1, 2), (2, 3), (3, 0), (1, 0)] [-1 / 1, 4 / 1, 1 / 5, 8 / 1] 2) [203 / 125, 484 / 125, 209 / 125, 504 / 125] -- meet_ring4
#guard agree (formation (2 / 5) [(0, 1), (1, 2), (2, 3), (3, 0), (1, 0)] [-1 / 1, 1 / 2, 2 / 3, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1]) [8 / 3, 11 / 30, 17 / 5, 34 / 15] -- form_ring4
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 4 (-4 / 3) (1 / 1) (-1 / 3) 0 6) [-4 / 3, -1 / 1, -1 / 3] -- alone4_0
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 4 (-4 / 3) (1 / 1) (-1 / 3) 1 6) [-4 / 3, -19 / 25, -1 / 3] -- alone4_1
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 4 (-4 / 3) (1 / 1) (-1 / 3) 3 6) [-4 / 3, 8 / 1, -1 / 3] -- alone4_3
#guard agree (quantities (-1 / 1) (8 / 1) [-1 / 1, 4 / 1, 1 / 5, 8 / 1]) [3 / 1, 56 / 5, 6084 / 25, 5 / 1, -19 / 5, 39 / 5, -3 / 1, 6 / 1, 15 / 1, 24 / 1, 0 / 1, -6 / 1, 72 / 5, 0 / 1, 0 / 1, 2 / 1, 2 / 1, 0 / 1] -- quantities4
#guard agree (residual (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1]) [-824 / 75] -- residual4
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 2 / 1, 5 / 1, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 1 / 1, 1 / 1, 1 / 1, 1 / 1] -- targets4
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 17 / 9, 44 / 9, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 1 / 1, 0 / 1, 0 / 1, 1 / 1] -- behind4
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 19 / 9, 46 / 9, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 0 / 1, 0 / 1, 1 / 1, 1 / 1] -- before4
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, -99 / 100, -49 / 50, 8 / 1]) [1 / 1, 1 / 1, 1 / 1, 1 / 1, 0 / 1, 0 / 1, 1 / 1] -- crowd4
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 4 / 1, 1 / 5, 8 / 1]) [1 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 1 / 1] -- mixed4
#guard agree (predicates (-1 / 1) (8 / 1) [-4 / 3, 1 / 1, -1 / 3, 2 / 1]) [0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1] -- loose4
#guard agree (critical (1 / 1) (2 / 1) 4) [1 / 1] -- critical4_half
#guard agree (critical (53 / 1) (100 / 1) 4) [1 / 1] -- critical4_low
#guard agree (critical (55 / 1) (100 / 1) 4) [1 / 1] -- critical4_five
#guard agree (critical (58 / 1) (100 / 1) 4) [1 / 1] -- critical4_four
#guard agree (critical (60 / 1) (100 / 1) 4) [1 / 1] -- critical4_middle
#guard agree (critical (2 / 1) (3 / 1) 4) [0 / 1] -- critical4_high
#guard agree (critical (1 / 1) (1 / 1) 4) [0 / 1] -- critical4_one
#guard agree (critical (0 / 1) (1 / 1) 4) [0 / 1] -- critical4_zero
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] 1) [-1 / 1, 12 / 25, 131 / 25, 127 / 25, 8 / 1] -- drones5_first_1
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] 3) [-1 / 1, 12 / 25, 131 / 25, 127 / 25, 8 / 1] -- drones5_first_3
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] 7) [-1 / 1, 792 / 625, 487 / 125, 3607 / 625, 8 / 1] -- drones5_first_7
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] 1) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] -- drones5_last_1
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] 3) [-1 / 1, 12 / 25, 131 / 25, 127 / 25, 8 / 1] -- drones5_last_3
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] 7) [-1 / 1, 224 / 125, 409 / 125, 789 / 125, 8 / 1] -- drones5_last_7
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] [false, true, true, false, true]) [-1 / 1, 12 / 25, 131 / 25, 9 / 1, 8 / 1] -- rest5_first
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] [true, false, true, true, false]) [-1 / 1, 4 / 1, 131 / 25, 127 / 25, 8 / 1] -- rest5_second
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] [true, true, false, true, true]) [-1 / 1, 12 / 25, 1 / 5, 127 / 25, 8 / 1] -- rest5_third
#guard agree (delayed (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 1 / 2, 2 / 3, 3 / 1, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3, 1 / 3, -1 / 1, 4 / 3, 0 / 1, -4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3, 1 / 3, -1 / 1, 4 / 3, 0 / 1, -4 / 3, 1 / 1, -1 / 3]) [-1 / 1, -1 / 30, -8 / 15, 13 / 15, 8 / 1] -- late5
#guard agree (meeting (2 / 5) [(1, 0), (2, 0), (3, 0), (4, 0), (1, 1)] [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] 2) [-1 / 1, 604 / 125, 433 / 125, 829 / 125, 784 / 125] -- meet_star5
#guard agree (formation (2 / 5) [(1, 0), (2, 0), (3, 0), (4, 0), (1, 1)] [-1 / 1, 1 / 2, 2 / 3, 3 / 1, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3]) [74 / 15, 3 / 10, -2 / 15, 11 / 5, 14 / 3] -- form_star5
#guard agree (meeting (2 / 5) [(0, 1), (1, 2), (2, 3), (3, 4), (4, 0), (1, 0)] [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] 2) [379 / 125, 504 / 125, 409 / 125, 629 / 125, 604 / 125] -- meet_ring5
#guard agree (formation (2 / 5) [(0, 1), (1, 2), (2, 3), (3, 4), (4, 0), (1, 0)] [-1 / 1, 1 / 2, 2 / 3, 3 / 1, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3]) [8 / 3, 11 / 30, 7 / 5, 73 / 15, 8 / 3] -- form_ring5
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 5 (-4 / 3) (1 / 1) (-1 / 3) 0 6) [-4 / 3, -1 / 1, -1 / 3] -- alone5_0
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 5 (-4 / 3) (1 / 1) (-1 / 3) 1 6) [-4 / 3, -19 / 25, -1 / 3] -- alone5_1
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 5 (-4 / 3) (1 / 1) (-1 / 3) 4 6) [-4 / 3, 8 / 1, -1 / 3] -- alone5_4
#guard agree (quantities (-1 / 1) (8 / 1) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1]) [4 / 1, 101 / 5, 11606 / 25, 5 / 1, -19 / 5, 44 / 5, -1 / 1, -4 / 1, 5 / 1, 14 / 1, 23 / 1, 32 / 1, 0 / 1, -11 / 1, 66 / 5, -13 / 1, 0 / 1, 0 / 1, 3 / 1, 4 / 1, 3 / 1, 0 / 1] -- quantities5
#guard agree (residual (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3]) [-79 / 5] -- residual5
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 5 / 4, 7 / 2, 23 / 4, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 1 / 1, 1 / 1, 1 / 1, 1 / 1] -- targets5
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 41 / 36, 61 / 18, 203 / 36, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 1 / 1, 0 / 1, 0 / 1, 1 / 1] -- behind5
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 49 / 36, 65 / 18, 211 / 36, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 0 / 1, 0 / 1, 1 / 1, 1 / 1] -- before5
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, -99 / 100, -49 / 50, -97 / 100, 8 / 1]) [1 / 1, 1 / 1, 1 / 1, 1 / 1, 0 / 1, 0 / 1, 1 / 1] -- crowd5
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, 8 / 1]) [1 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1] -- mixed5
#guard agree (predicates (-1 / 1) (8 / 1) [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3]) [0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1] -- loose5
#guard agree (critical (1 / 1) (2 / 1) 5) [1 / 1] -- critical5_half
#guard agree (critical (53 / 1) (100 / 1) 5) [1 / 1] -- critical5_low
#guard agree (critical (55 / 1) (100 / 1) 5) [1 / 1] -- critical5_five
#guard agree (critical (58 / 1) (100 / 1) 5) [1 / 1] -- critical5_four
#guard agree (critical (60 / 1) (100 / 1) 5) [0 / 1] -- critical5_middle
#guard agree (critical (2 / 1) (3 / 1) 5) [0 / 1] -- critical5_high
#guard agree (critical (1 / 1) (1 / 1) 5) [0 / 1] -- critical5_one
#guard agree (critical (0 / 1) (1 / 1) 5) [0 / 1] -- critical5_zero
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] 1) [-1 / 1, 12 / 25, 131 / 25, 91 / 75, 97 / 15, 8 / 1] -- drones6_first_1
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] 3) [-1 / 1, 12 / 25, 131 / 25, 91 / 75, 97 / 15, 8 / 1] -- drones6_first_3
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] 7) [-1 / 1, 1216 / 1875, 379 / 125, 11 / 3, 11561 / 1875, 8 / 1] -- drones6_first_7
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] 1) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] -- drones6_last_1
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] 3) [-1 / 1, 12 / 25, 131 / 25, 91 / 75, 97 / 15, 8 / 1] -- drones6_last_3
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] 7) [-1 / 1, 224 / 125, 647 / 375, 1847 / 375, 1867 / 375, 8 / 1] -- drones6_last_7
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] [false, true, true, false, true, true]) [-1 / 1, 12 / 25, 131 / 25, 9 / 1, 97 / 15, 8 / 1] -- rest6_first
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] [true, false, true, true, false, true]) [-1 / 1, 4 / 1, 131 / 25, 91 / 75, -5 / 3, 8 / 1] -- rest6_second
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] [true, true, false, true, true, false]) [-1 / 1, 12 / 25, 1 / 5, 91 / 75, 97 / 15, 8 / 1] -- rest6_third
#guard agree (delayed (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 1 / 2, 2 / 3, 3 / 1, 7 / 2, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3, 1 / 3, -1 / 1, 4 / 3, 0 / 1, -4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3, 1 / 3, -1 / 1, 4 / 3, 0 / 1, -4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3, 1 / 3, -1 / 1, 4 / 3, 0 / 1, -4 / 3, 1 / 1, -1 / 3]) [-1 / 1, 11 / 30, 4 / 15, 3 / 5, 17 / 30, 8 / 1] -- late6
#guard agree (meeting (2 / 5) [(1, 0), (2, 0), (3, 0), (4, 0), (5, 0), (1, 1)] [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] 2) [-1847 / 375, 1772 / 375, 1259 / 375, 2447 / 375, 1007 / 375, 2312 / 375] -- meet_star6
#guard agree (formation (2 / 5) [(1, 0), (2, 0), (3, 0), (4, 0), (5, 0), (1, 1)] [-1 / 1, 1 / 2, 2 / 3, 3 / 1, 7 / 2, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3]) [101 / 15, 3 / 10, -2 / 15, 11 / 5, 59 / 30, 62 / 15] -- form_star6
#guard agree (meeting (2 / 5) [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (1, 0)] [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] 2) [497 / 375, 504 / 125, 647 / 375, 1847 / 375, 249 / 125, 68 / 15] -- meet_ring6
#guard agree (formation (2 / 5) [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (1, 0)] [-1 / 1, 1 / 2, 2 / 3, 3 / 1, 7 / 2, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3]) [8 / 3, 11 / 30, 7 / 5, 46 / 15, 161 / 30, 7 / 3] -- form_ring6
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 6 (-4 / 3) (1 / 1) (-1 / 3) 0 6) [-4 / 3, -1 / 1, -1 / 3] -- alone6_0
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 6 (-4 / 3) (1 / 1) (-1 / 3) 1 6) [-4 / 3, -19 / 25, -1 / 3] -- alone6_1
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 6 (-4 / 3) (1 / 1) (-1 / 3) 5 6) [-4 / 3, 8 / 1, -1 / 3] -- alone6_5
#guard agree (quantities (-1 / 1) (8 / 1) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1]) [5 / 1, 278 / 15, 22285 / 9, 5 / 1, -19 / 5, 44 / 5, -32 / 3, 29 / 3, -5 / 1, 4 / 1, 13 / 1, 22 / 1, 31 / 1, 40 / 1, 0 / 1, -16 / 1, 12 / 1, -23 / 1, 118 / 3, 0 / 1, 0 / 1, 4 / 1, 6 / 1, 6 / 1, 4 / 1, 0 / 1] -- quantities6
#guard agree (residual (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3]) [-286 / 15] -- residual6
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 4 / 5, 13 / 5, 22 / 5, 31 / 5, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 1 / 1, 1 / 1, 1 / 1, 1 / 1] -- targets6
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 31 / 45, 112 / 45, 193 / 45, 274 / 45, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 1 / 1, 0 / 1, 0 / 1, 1 / 1] -- behind6
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 41 / 45, 122 / 45, 203 / 45, 284 / 45, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 0 / 1, 0 / 1, 1 / 1, 1 / 1] -- before6
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, -99 / 100, -49 / 50, -97 / 100, -24 / 25, 8 / 1]) [1 / 1, 1 / 1, 1 / 1, 1 / 1, 0 / 1, 0 / 1, 1 / 1] -- crowd6
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 8 / 1]) [1 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1] -- mixed6
#guard agree (predicates (-1 / 1) (8 / 1) [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3]) [0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1] -- loose6
#guard agree (critical (1 / 1) (2 / 1) 6) [1 / 1] -- critical6_half
#guard agree (critical (53 / 1) (100 / 1) 6) [1 / 1] -- critical6_low
#guard agree (critical (55 / 1) (100 / 1) 6) [1 / 1] -- critical6_five
#guard agree (critical (58 / 1) (100 / 1) 6) [0 / 1] -- critical6_four
#guard agree (critical (60 / 1) (100 / 1) 6) [0 / 1] -- critical6_middle
#guard agree (critical (2 / 1) (3 / 1) 6) [0 / 1] -- critical6_high
#guard agree (critical (1 / 1) (1 / 1) 6) [0 / 1] -- critical6_one
#guard agree (critical (0 / 1) (1 / 1) 6) [0 / 1] -- critical6_zero
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] 1) [-1 / 1, 12 / 25, 131 / 25, 91 / 75, 17 / 3, 56 / 15, 8 / 1] -- drones7_first_1
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] 3) [-1 / 1, 12 / 25, 131 / 25, 91 / 75, 17 / 3, 56 / 15, 8 / 1] -- drones7_first_3
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.First [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] 7) [-1 / 1, 1216 / 1875, 363 / 125, 357 / 125, 9281 / 1875, 10664 / 1875, 8 / 1] -- drones7_first_7
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] 1) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] -- drones7_last_1
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] 3) [-1 / 1, 12 / 25, 131 / 25, 91 / 75, 17 / 3, 56 / 15, 8 / 1] -- drones7_last_3
#guard agree (coverage (-1 / 1) (8 / 1) (2 / 5) 2 Phase.Last [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] 7) [-1 / 1, 224 / 125, 647 / 375, 1727 / 375, 389 / 125, 466 / 75, 8 / 1] -- drones7_last_7
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] [false, true, true, false, true, true, false]) [-1 / 1, 12 / 25, 131 / 25, 9 / 1, 17 / 3, 56 / 15, 8 / 1] -- rest7_first
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] [true, false, true, true, false, true, true]) [-1 / 1, 4 / 1, 131 / 25, 91 / 75, -5 / 3, 56 / 15, 8 / 1] -- rest7_second
#guard agree (active (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] [true, true, false, true, true, false, true]) [-1 / 1, 12 / 25, 1 / 5, 91 / 75, 17 / 3, 6 / 1, 8 / 1] -- rest7_third
#guard agree (delayed (-1 / 1) (8 / 1) (2 / 5) [-1 / 1, 1 / 2, 2 / 3, 3 / 1, 7 / 2, 27 / 4, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3, 1 / 3, -1 / 1, 4 / 3, 0 / 1, -4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3, 1 / 3, -1 / 1, 4 / 3, 0 / 1, -4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3, 1 / 3, -1 / 1, 4 / 3, 0 / 1, -4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3, 1 / 3, -1 / 1, 4 / 3, 0 / 1, -4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3]) [-1 / 1, 23 / 30, 16 / 15, 9 / 5, 7 / 10, 97 / 60, 8 / 1] -- late7
#guard agree (meeting (2 / 5) [(1, 0), (2, 0), (3, 0), (4, 0), (5, 0), (6, 0), (1, 1)] [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] 2) [-4159 / 375, 2192 / 375, 1679 / 375, 2867 / 375, 1427 / 375, 2462 / 375, 2732 / 375] -- meet_star7
#guard agree (formation (2 / 5) [(1, 0), (2, 0), (3, 0), (4, 0), (5, 0), (6, 0), (1, 1)] [-1 / 1, 1 / 2, 2 / 3, 3 / 1, 7 / 2, 27 / 4, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3]) [59 / 6, 3 / 10, -2 / 15, 11 / 5, 59 / 30, 203 / 60, 76 / 15] -- form_star7
#guard agree (meeting (2 / 5) [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 6), (6, 0), (1, 0)] [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] 2) [319 / 125, 504 / 125, 647 / 375, 1727 / 375, 389 / 125, 334 / 75, 304 / 75] -- meet_ring7
#guard agree (formation (2 / 5) [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 6), (6, 0), (1, 0)] [-1 / 1, 1 / 2, 2 / 3, 3 / 1, 7 / 2, 27 / 4, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3]) [8 / 3, 11 / 30, 7 / 5, 46 / 15, 73 / 15, 341 / 60, 137 / 30] -- form_ring7
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 7 (-4 / 3) (1 / 1) (-1 / 3) 0 6) [-4 / 3, -1 / 1, -1 / 3] -- alone7_0
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 7 (-4 / 3) (1 / 1) (-1 / 3) 1 6) [-4 / 3, -19 / 25, -1 / 3] -- alone7_1
#guard agree (alone (-1 / 1) (8 / 1) (2 / 5) 2 7 (-4 / 3) (1 / 1) (-1 / 3) 6 6) [-4 / 3, 8 / 1, -1 / 3] -- alone7_6
#guard agree (quantities (-1 / 1) (8 / 1) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1]) [6 / 1, 368 / 15, 81391 / 25, 5 / 1, -19 / 5, 44 / 5, -32 / 3, 23 / 3, 2 / 1, -6 / 1, 3 / 1, 12 / 1, 21 / 1, 30 / 1, 39 / 1, 48 / 1, 0 / 1, -21 / 1, 54 / 5, -33 / 1, 40 / 1, 3 / 1, 0 / 1, 0 / 1, 5 / 1, 8 / 1, 9 / 1, 8 / 1, 5 / 1, 0 / 1] -- quantities7
#guard agree (residual (2 / 5) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1] [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3]) [-61 / 3] -- residual7
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 1 / 2, 2 / 1, 7 / 2, 5 / 1, 13 / 2, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 1 / 1, 1 / 1, 1 / 1, 1 / 1] -- targets7
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 7 / 18, 17 / 9, 61 / 18, 44 / 9, 115 / 18, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 1 / 1, 0 / 1, 0 / 1, 1 / 1] -- behind7
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 11 / 18, 19 / 9, 65 / 18, 46 / 9, 119 / 18, 8 / 1]) [1 / 1, 1 / 1, 0 / 1, 0 / 1, 0 / 1, 1 / 1, 1 / 1] -- before7
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, -99 / 100, -49 / 50, -97 / 100, -24 / 25, -19 / 20, 8 / 1]) [1 / 1, 1 / 1, 1 / 1, 1 / 1, 0 / 1, 0 / 1, 1 / 1] -- crowd7
#guard agree (predicates (-1 / 1) (8 / 1) [-1 / 1, 4 / 1, 1 / 5, 9 / 1, -5 / 3, 6 / 1, 8 / 1]) [1 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1] -- mixed7
#guard agree (predicates (-1 / 1) (8 / 1) [-4 / 3, 1 / 1, -1 / 3, 2 / 1, 2 / 3, -2 / 3, 5 / 3]) [0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1, 0 / 1] -- loose7
#guard agree (critical (1 / 1) (2 / 1) 7) [1 / 1] -- critical7_half
#guard agree (critical (53 / 1) (100 / 1) 7) [1 / 1] -- critical7_low
#guard agree (critical (55 / 1) (100 / 1) 7) [0 / 1] -- critical7_five
#guard agree (critical (58 / 1) (100 / 1) 7) [0 / 1] -- critical7_four
#guard agree (critical (60 / 1) (100 / 1) 7) [0 / 1] -- critical7_middle
#guard agree (critical (2 / 1) (3 / 1) 7) [0 / 1] -- critical7_high
#guard agree (critical (1 / 1) (1 / 1) 7) [0 / 1] -- critical7_one
#guard agree (critical (0 / 1) (1 / 1) 7) [0 / 1] -- critical7_zero

end CordonMirror.Vectors
