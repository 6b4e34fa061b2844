import CordonMirror.Spec.DroneMap

/-! Parameters and state of the swarm (Listing 3). Counters are natural numbers here and
`u32` in Rust; within `0 .. n`, where every run stays, the two agree. -/

namespace CordonMirror

/-- Rust: spec/src/state.rs Params -/
structure Params where
  min : Rat
  max : Rat
  eps : Rat
  n : Nat

/-- Rust: spec/src/state.rs State -/
structure State where
  drones : DroneMap Rat
  timesteps : Nat

/-- Rust: spec/src/state.rs Phase -/
inductive Phase where
  | First
  | Last

/-- Rust: spec/src/state.rs initial -/
def initial (m : DroneMap Rat) (n : Nat) (phase : Phase) : State :=
  match phase with
  | Phase.First => State.mk m n
  | Phase.Last => State.mk m 0

/-- Rust: spec/src/state.rs tick_with -/
def tick_with (s : State) (n : Nat) (protocol : DroneMap Rat → DroneMap Rat) : State :=
  if s.timesteps = n then State.mk (protocol s.drones) 0
  else State.mk s.drones (s.timesteps + 1)

end CordonMirror
