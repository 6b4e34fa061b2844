import CordonMirror.Spec.DroneMap

/-! Quantities of a placement, free of division. -/

namespace CordonMirror

/-- Rust: spec/src/placement.rs gap -/
def gap (x : DroneMap Rat) (i : Nat) : Rat := get x (i + 1) - get x i

/-- Rust: spec/src/placement.rs sum -/
def sum (x : DroneMap Rat) : Rat := List.foldl (fun c xi => c + xi) 0 x

/-- Rust: spec/src/placement.rs gaps -/
def gaps (x : DroneMap Rat) : Rat := ((count x - 1 : Nat) : Rat)

/-- Rust: spec/src/placement.rs scaled_target -/
def scaled_target (min max : Rat) (N i : Nat) : Rat :=
  ((N - 1 : Nat) : Rat) * min + (i : Rat) * (max - min)

/-- Rust: spec/src/placement.rs scaled_error -/
def scaled_error (min max : Rat) (x : DroneMap Rat) (i : Nat) : Rat :=
  scaled_target min max (count x) i - gaps x * get x i

/-- Rust: spec/src/placement.rs scaled_energy -/
def scaled_energy (min max : Rat) (x : DroneMap Rat) : Rat :=
  List.foldl
    (fun c i => c + scaled_error min max x i * scaled_error min max x i) 0
    (lambda (count x) (fun i => i))

/-- Rust: spec/src/placement.rs contraction_weight -/
def contraction_weight (N i : Nat) : Nat := i * (N - 1 - i)

end CordonMirror
