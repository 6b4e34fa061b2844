import CordonMirror.Spec.Coverage

/-! Steps in which only some drones update. -/

namespace CordonMirror

/-- Rust: spec/src/activation.rs exec_coverage_active -/
def exec_coverage_active (p : Params) (s : State) (active : Nat → Bool) : State :=
  State.mk
    (lambda (count s.drones) (fun i =>
      if active i = true then update p (count s.drones) i (getx s) else getx s i))
    s.timesteps

end CordonMirror
