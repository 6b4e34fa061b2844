import CordonMirror.Spec.State

/-! The coverage protocol of the whole swarm (equation 10, Listing 4). -/

namespace CordonMirror

/-- Rust: spec/src/coverage.rs exec_cvg -/
def exec_cvg (p : Params) (N : Nat) (a b c : Rat) (i : Nat) : Rat :=
  if i = 0 then p.min
  else if i + 1 = N then p.max
  else p.eps * a + (1 - 2 * p.eps) * b + p.eps * c

/-- Rust: spec/src/coverage.rs getx -/
def getx (s : State) (i : Nat) : Rat := get s.drones i

/-- Rust: spec/src/coverage.rs update -/
def update (p : Params) (N i : Nat) (position_of : Nat → Rat) : Rat :=
  exec_cvg p N
    (if 0 < i then position_of (i - 1) else p.min)
    (position_of i)
    (if i + 1 < N then position_of (i + 1) else p.max)
    i

/-- Rust: spec/src/coverage.rs next_placement -/
def next_placement (p : Params) (x : DroneMap Rat) : DroneMap Rat :=
  lambda (count x) (fun i => update p (count x) i (get x))

/-- Rust: spec/src/coverage.rs exec_coverage -/
def exec_coverage (p : Params) (s : State) : State :=
  State.mk (next_placement p s.drones) s.timesteps

/-- Rust: spec/src/coverage.rs tick -/
def tick (p : Params) (s : State) : State :=
  tick_with s p.n (next_placement p)

/-- Rust: spec/src/coverage.rs kth_step. `k` counts ticks. -/
def kth_step (p : Params) (start : State) : Nat → State
  | 0 => start
  | k + 1 => tick p (kth_step p start k)

end CordonMirror
