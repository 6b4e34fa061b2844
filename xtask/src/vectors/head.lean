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

