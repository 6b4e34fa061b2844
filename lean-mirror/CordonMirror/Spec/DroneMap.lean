/-! Maps from drone identifiers to values: the paper's dmap (Listing 3), tabulated. -/

namespace CordonMirror

/-- Rust: spec/src/drone_map.rs DroneMap -/
abbrev DroneMap (α : Type) : Type := List α

/-- Rust: spec/src/drone_map.rs count -/
def count {α : Type} (m : DroneMap α) : Nat := List.length m

/-- Rust: spec/src/drone_map.rs lambda -/
def lambda {α : Type} : Nat → (Nat → α) → DroneMap α
  | 0, _ => []
  | n + 1, f => f 0 :: lambda n (fun i => f (i + 1))

/-- Rust indexes `as_ref()[i]`. Outside the map `z`; no definition of the spec looks there. -/
def get_or {α : Type} (z : α) : DroneMap α → Nat → α
  | [], _ => z
  | x :: _, 0 => x
  | _ :: m, i + 1 => get_or z m i

/-- The position of drone `i`. -/
def get (m : DroneMap Rat) (i : Nat) : Rat := get_or 0 m i

end CordonMirror
