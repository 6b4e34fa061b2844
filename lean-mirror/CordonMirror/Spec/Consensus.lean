import CordonMirror.Spec.Graph

/-! The consensus (rendez-vous) protocol: equation 6. -/

namespace CordonMirror

/-- Rust: spec/src/consensus.rs pull -/
def pull (g : Graph) (x : DroneMap Rat) (i : Nat) : Rat :=
  List.foldl (fun sum j => sum + (get x j - get x i)) 0 (neighbours g i)

/-- Rust: spec/src/consensus.rs exec_consensus -/
def exec_consensus (eps : Rat) (g : Graph) (x : DroneMap Rat) : DroneMap Rat :=
  lambda (count x) (fun i => get x i + eps * pull g x i)

/-- `exec_consensus` applied `k` times. -/
def consensus_step (eps : Rat) (g : Graph) (x : DroneMap Rat) : Nat → DroneMap Rat
  | 0 => x
  | k + 1 => exec_consensus eps g (consensus_step eps g x k)

end CordonMirror
