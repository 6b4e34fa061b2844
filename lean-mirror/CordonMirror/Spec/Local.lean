import CordonMirror.Spec.Coverage

/-! The coverage protocol of one drone that knows only its neighbours (Listings 5 and 6). -/

namespace CordonMirror

/-- Rust: spec/src/local.rs TickRatio -/
structure TickRatio where
  num : Nat
  den : Nat

/-- Rust: spec/src/local.rs whole -/
def whole (n : Nat) : TickRatio := TickRatio.mk n 1

/-- Rust: spec/src/local.rs reached_by -/
def reached_by (r : TickRatio) (timesteps : Nat) : Bool :=
  decide (r.num ≤ timesteps * r.den)

/-- Rust: spec/src/local.rs counter_limit -/
def counter_limit (r : TickRatio) : Nat := (r.num + (r.den - 1)) / r.den

/-- Rust: spec/src/local.rs LocalParams -/
structure LocalParams where
  protocol : Params
  count : Nat
  ratio : TickRatio

/-- Rust: spec/src/local.rs LocalState -/
structure LocalState where
  prec : Rat
  own : Rat
  foll : Rat
  id : Nat

/-- Rust: spec/src/local.rs SimState -/
structure SimState where
  timesteps : Nat
  st : LocalState

/-- Rust: spec/src/local.rs fmu_exec_cvg -/
def fmu_exec_cvg (p : LocalParams) (a b c : Rat) (i : Nat) : Rat :=
  exec_cvg p.protocol p.count a b c i

/-- Rust: spec/src/local.rs fmu_tick -/
def fmu_tick (p : LocalParams) (s : SimState) : SimState :=
  if reached_by p.ratio s.timesteps = true then
    SimState.mk 0
      (LocalState.mk s.st.prec
        (fmu_exec_cvg p
          (if 0 < s.st.id then s.st.prec else p.protocol.min)
          s.st.own
          (if s.st.id + 1 < p.count then s.st.foll else p.protocol.max)
          s.st.id)
        s.st.foll s.st.id)
  else SimState.mk (s.timesteps + 1) s.st

/-- Rust: spec/src/local.rs fmu_kth_step -/
def fmu_kth_step (p : LocalParams) (start : SimState) : Nat → SimState
  | 0 => start
  | k + 1 => fmu_tick p (fmu_kth_step p start k)

/-- Rust: spec/src/local.rs project -/
def project (p : Params) (s : State) (i : Nat) : SimState :=
  SimState.mk s.timesteps
    (LocalState.mk
      (if 0 < i then getx s (i - 1) else p.min)
      (getx s i)
      (if i + 1 < count s.drones then getx s (i + 1) else p.max)
      i)

/-- Rust indexes `m[i]`. Any machine outside the map; nothing looks there. -/
def machine (m : DroneMap SimState) (i : Nat) : SimState :=
  get_or (SimState.mk 0 (LocalState.mk 0 0 0 0)) m i

/-- Rust: spec/src/local.rs exchange -/
def exchange (m : DroneMap SimState) : DroneMap SimState :=
  lambda (count m) (fun i =>
    SimState.mk (machine m i).timesteps
      (LocalState.mk
        (if 0 < i then (machine m (i - 1)).st.own else (machine m i).st.prec)
        (machine m i).st.own
        (if i + 1 < count m then (machine m (i + 1)).st.own else (machine m i).st.foll)
        (machine m i).st.id))

/-- Rust: spec/src/local.rs swarm_tick -/
def swarm_tick (p : LocalParams) (m : DroneMap SimState) : DroneMap SimState :=
  exchange (lambda (count m) (fun i => fmu_tick p (machine m i)))

/-- `swarm_tick` applied `k` times. -/
def swarm_kth_step (p : LocalParams) (start : DroneMap SimState) : Nat → DroneMap SimState
  | 0 => start
  | k + 1 => swarm_tick p (swarm_kth_step p start k)

/-- All local machines that agree with a global state. -/
def swarm_of (p : Params) (s : State) : DroneMap SimState :=
  lambda (count s.drones) (project p s)

end CordonMirror
