import CordonMirror.Spec.Placement

/-! The identity behind theorem 7.5. -/

namespace CordonMirror

/-- Rust: spec/src/theorems/non_decreasing.rs telescoping_residual -/
def telescoping_residual (eps : Rat) (before after : DroneMap Rat) : Rat :=
  sum after - sum before - eps * (gap before (count before - 2) - gap before 0)

end CordonMirror
