import CordonMirror.Spec.Consensus

/-! Formation control: equation 8 in discrete time. -/

namespace CordonMirror

/-- Rust: spec/src/formation.rs exec_formation -/
def exec_formation (eps : Rat) (g : Graph) (x b : DroneMap Rat) : DroneMap Rat :=
  lambda (count x) (fun i => get x i + eps * (pull g x i + get b i))

end CordonMirror
