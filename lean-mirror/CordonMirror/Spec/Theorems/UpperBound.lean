import CordonMirror.Spec.Theorems.Hypothesis

/-! The companions of theorem 7.3. -/

namespace CordonMirror

/-- Rust: spec/src/theorems/upper_bound.rs above_targets -/
def above_targets (p : Params) (x : DroneMap Rat) : Prop :=
  ∀ i : Nat, i < count x → scaled_error p.min p.max x i ≤ 0

/-- Rust: spec/src/theorems/upper_bound.rs in_box -/
def in_box (p : Params) (x : DroneMap Rat) : Prop :=
  ∀ i : Nat, i < count x → p.min ≤ get x i ∧ get x i ≤ p.max

end CordonMirror
