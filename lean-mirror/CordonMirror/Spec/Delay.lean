import CordonMirror.Spec.Coverage

/-! Steps that read stale messages. -/

namespace CordonMirror

/-- Rust: spec/src/delay.rs exec_coverage_delayed -/
def exec_coverage_delayed (p : Params) (s : State) (seen : Nat → Nat → Rat) : State :=
  State.mk
    (lambda (count s.drones) (fun i =>
      update p (count s.drones) i (fun j => if j = i then getx s i else seen i j)))
    s.timesteps

end CordonMirror
