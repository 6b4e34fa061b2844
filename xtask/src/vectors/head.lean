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

