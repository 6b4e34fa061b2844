import CordonMirror.Spec.State
import CordonMirror.Spec.Placement

/-! Which starts a theorem is about. -/

namespace CordonMirror

/-- Rust: spec/src/theorems/hypothesis.rs contains, the part common to all start sets -/
def anchored (p : Params) (x : DroneMap Rat) : Prop :=
  get x 0 = p.min ∧ get x (count x - 1) = p.max

/-- Rust: spec/src/theorems/hypothesis.rs ordered -/
def ordered (x : DroneMap Rat) : Prop :=
  ∀ i : Nat, i + 1 < count x → get x i < get x (i + 1)

/-- Rust: spec/src/theorems/hypothesis.rs in_first_subsegment -/
def in_first_subsegment (p : Params) (x : DroneMap Rat) : Prop :=
  ∀ i : Nat, 0 < i → i + 1 < count x → gaps x * get x i < gaps x * p.min + (p.max - p.min)

/-- Rust: spec/src/theorems/hypothesis.rs upper_bounded -/
def upper_bounded (p : Params) (x : DroneMap Rat) : Prop :=
  ∀ i : Nat, i < count x → 0 ≤ scaled_error p.min p.max x i

/-- Rust: spec/src/theorems/hypothesis.rs at_target -/
def at_target (p : Params) (x : DroneMap Rat) (i : Nat) : Prop :=
  scaled_error p.min p.max x i = 0

/-- Rust: spec/src/theorems/hypothesis.rs at_targets -/
def at_targets (p : Params) (x : DroneMap Rat) : Prop :=
  ∀ i : Nat, i < count x → at_target p x i

/-- The leading minors of `den * (I + A)`, by their three-term recurrence: the last two after
`k` steps. -/
def minors (diagonal off_squared : Rat) : Nat → Rat × Rat
  | 0 => (0, 1)
  | k + 1 =>
    ((minors diagonal off_squared k).2,
      diagonal * (minors diagonal off_squared k).2
        - off_squared * (minors diagonal off_squared k).1)

/-- Rust: spec/src/theorems/hypothesis.rs below_critical -/
def below_critical (num den : Rat) (N : Nat) : Prop :=
  ∀ k : Nat, 1 ≤ k → k ≤ N - 2 → 0 < (minors (2 * den - 2 * num) (num * num) k).2

end CordonMirror
