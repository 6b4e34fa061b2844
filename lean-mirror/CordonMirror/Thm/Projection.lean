import CordonMirror.Spec.Local
import CordonMirror.Thm.Ticks

/-! The projection theorem: N local machines that exchange their positions after every tick are
the projections of the global state. No law of arithmetic is used. -/

namespace CordonMirror

theorem ite_twice (c : Prop) [Decidable c] (a b : Rat) :
    (if c then (if c then a else b) else b) = (if c then a else b) := by
  by_cases h : c
  · exact if_pos h
  · exact Eq.trans (if_neg h) (Eq.symm (if_neg h))

theorem ite_else (c : Prop) [Decidable c] (a b d : Rat) :
    (if c then a else (if c then b else d)) = (if c then a else d) := by
  by_cases h : c
  · exact Eq.trans (if_pos h) (Eq.symm (if_pos h))
  · exact Eq.trans (if_neg h) (Eq.trans (if_neg h) (Eq.symm (if_neg h)))

theorem machine_lambda (n : Nat) (f : Nat → SimState) (i : Nat) (h : i < n) :
    machine (lambda n f) i = f i :=
  get_or_lambda (SimState.mk 0 (LocalState.mk 0 0 0 0)) n f i h

/-! ### Counters -/

theorem counter_limit_spec (r : TickRatio) (hD : 0 < r.den) :
    ∃ rest : Nat, rest < r.den ∧ r.den * counter_limit r + rest = r.num + (r.den - 1) :=
  Exists.intro ((r.num + (r.den - 1)) % r.den)
    (And.intro (Nat.mod_lt (r.num + (r.den - 1)) hD)
      (Nat.div_add_mod (r.num + (r.den - 1)) r.den))

/-- The local counter fires where the global one does: at the quotient rounded up. -/
theorem reached_iff (r : TickRatio) (t : Nat) (hD : 0 < r.den) (ht : t ≤ counter_limit r) :
    r.num ≤ t * r.den ↔ t = counter_limit r := by
  obtain ⟨rest, h1, h2⟩ := counter_limit_spec r hD
  have hcomm : t * r.den = r.den * t := Nat.mul_comm t r.den
  rw [hcomm]
  refine Iff.intro ?_ ?_
  · intro hle
    refine Classical.byContradiction fun hne => ?_
    have hlt : t + 1 ≤ counter_limit r := by omega
    have hmul : r.den * (t + 1) ≤ r.den * counter_limit r := Nat.mul_le_mul_left r.den hlt
    have hexp : r.den * (t + 1) = r.den * t + r.den := Nat.mul_succ r.den t
    omega
  · intro he
    rw [he]
    omega

/-! ### One machine, one tick -/

/-- What the machine of drone `i` is after its own tick, before the exchange. -/
def ticked (p : LocalParams) (s : State) (i : Nat) : SimState :=
  SimState.mk (tick p.protocol s).timesteps
    (LocalState.mk (project p.protocol s i).st.prec (getx (tick p.protocol s) i)
      (project p.protocol s i).st.foll i)

theorem local_update (p : LocalParams) (s : State) (i : Nat) (hc : p.count = count s.drones) :
    fmu_exec_cvg p
        (if 0 < i then (if 0 < i then getx s (i - 1) else p.protocol.min) else p.protocol.min)
        (getx s i)
        (if i + 1 < p.count then
          (if i + 1 < count s.drones then getx s (i + 1) else p.protocol.max)
          else p.protocol.max) i
      = update p.protocol (count s.drones) i (get s.drones) := by
  unfold fmu_exec_cvg
  rw [hc, ite_twice, ite_twice]
  exact Eq.refl (update p.protocol (count s.drones) i (get s.drones))

theorem fmu_tick_project (p : LocalParams) (s : State) (i : Nat) (hD : 0 < p.ratio.den)
    (hl : p.protocol.n = counter_limit p.ratio) (hc : p.count = count s.drones)
    (ht : s.timesteps ≤ p.protocol.n) (hi : i < count s.drones) :
    fmu_tick p (project p.protocol s i) = ticked p s i := by
  have hiff : p.ratio.num ≤ s.timesteps * p.ratio.den ↔ s.timesteps = counter_limit p.ratio :=
    reached_iff p.ratio s.timesteps hD (by omega)
  by_cases h : s.timesteps = p.protocol.n
  · have hle : p.ratio.num ≤ s.timesteps * p.ratio.den := hiff.mpr (Eq.trans h hl)
    have hr : reached_by p.ratio s.timesteps = true := decide_eq_true hle
    have e1 : fmu_tick p (project p.protocol s i)
        = SimState.mk 0
          (LocalState.mk (project p.protocol s i).st.prec
            (fmu_exec_cvg p
              (if 0 < i then (if 0 < i then getx s (i - 1) else p.protocol.min)
                else p.protocol.min)
              (getx s i)
              (if i + 1 < p.count then
                (if i + 1 < count s.drones then getx s (i + 1) else p.protocol.max)
                else p.protocol.max) i)
            (project p.protocol s i).st.foll i) := by
      unfold fmu_tick
      exact if_pos hr
    have e2 : SimState.mk 0
          (LocalState.mk (project p.protocol s i).st.prec
            (fmu_exec_cvg p
              (if 0 < i then (if 0 < i then getx s (i - 1) else p.protocol.min)
                else p.protocol.min)
              (getx s i)
              (if i + 1 < p.count then
                (if i + 1 < count s.drones then getx s (i + 1) else p.protocol.max)
                else p.protocol.max) i)
            (project p.protocol s i).st.foll i)
        = SimState.mk 0
          (LocalState.mk (project p.protocol s i).st.prec
            (update p.protocol (count s.drones) i (get s.drones))
            (project p.protocol s i).st.foll i) :=
      congrArg (fun v => SimState.mk 0
        (LocalState.mk (project p.protocol s i).st.prec v (project p.protocol s i).st.foll i))
        (local_update p s i hc)
    have hg : getx (State.mk (next_placement p.protocol s.drones) 0) i
        = update p.protocol (count s.drones) i (get s.drones) :=
      get_lambda (count s.drones)
        (fun j => update p.protocol (count s.drones) j (get s.drones)) i hi
    have e3 : ticked p s i
        = SimState.mk 0
          (LocalState.mk (project p.protocol s i).st.prec
            (getx (State.mk (next_placement p.protocol s.drones) 0) i)
            (project p.protocol s i).st.foll i) :=
      congrArg (fun t => SimState.mk (State.timesteps t)
        (LocalState.mk (project p.protocol s i).st.prec (getx t i)
          (project p.protocol s i).st.foll i))
        (tick_fires p.protocol s h)
    have e4 : SimState.mk 0
          (LocalState.mk (project p.protocol s i).st.prec
            (getx (State.mk (next_placement p.protocol s.drones) 0) i)
            (project p.protocol s i).st.foll i)
        = SimState.mk 0
          (LocalState.mk (project p.protocol s i).st.prec
            (update p.protocol (count s.drones) i (get s.drones))
            (project p.protocol s i).st.foll i) :=
      congrArg (fun v => SimState.mk 0
        (LocalState.mk (project p.protocol s i).st.prec v (project p.protocol s i).st.foll i)) hg
    exact Eq.trans (Eq.trans e1 e2) (Eq.symm (Eq.trans e3 e4))
  · have hr : ¬ (reached_by p.ratio s.timesteps = true) := by
      intro hb
      have hle : p.ratio.num ≤ s.timesteps * p.ratio.den := of_decide_eq_true hb
      exact h (Eq.trans (hiff.mp hle) (Eq.symm hl))
    have e1 : fmu_tick p (project p.protocol s i)
        = SimState.mk (s.timesteps + 1) (project p.protocol s i).st := by
      unfold fmu_tick
      exact if_neg hr
    have e3 : ticked p s i
        = SimState.mk (s.timesteps + 1) (project p.protocol s i).st :=
      congrArg (fun t => SimState.mk (State.timesteps t)
        (LocalState.mk (project p.protocol s i).st.prec (getx t i)
          (project p.protocol s i).st.foll i))
        (tick_waits p.protocol s h)
    exact Eq.trans e1 (Eq.symm e3)

/-! ### The swarm -/

theorem exchange_lambda (N : Nat) (f : Nat → SimState) :
    exchange (lambda N f)
      = lambda N (fun i =>
          SimState.mk (f i).timesteps
            (LocalState.mk
              (if 0 < i then (f (i - 1)).st.own else (f i).st.prec)
              (f i).st.own
              (if i + 1 < N then (f (i + 1)).st.own else (f i).st.foll)
              (f i).st.id)) := by
  have hc : count (lambda N f) = N := count_lambda N f
  unfold exchange
  rw [hc]
  refine lambda_ext N _ _ ?_
  intro i hi
  have m0 : machine (lambda N f) i = f i := machine_lambda N f i hi
  have a : (if 0 < i then (machine (lambda N f) (i - 1)).st.own
        else (machine (lambda N f) i).st.prec)
      = (if 0 < i then (f (i - 1)).st.own else (f i).st.prec) := by
    rw [m0, machine_lambda N f (i - 1) (by omega)]
  have c : (if i + 1 < N then (machine (lambda N f) (i + 1)).st.own
        else (machine (lambda N f) i).st.foll)
      = (if i + 1 < N then (f (i + 1)).st.own else (f i).st.foll) := by
    by_cases h : i + 1 < N
    · rw [m0, machine_lambda N f (i + 1) h]
    · rw [m0]
      exact Eq.trans (if_neg h) (Eq.symm (if_neg h))
  show SimState.mk (machine (lambda N f) i).timesteps
      (LocalState.mk
        (if 0 < i then (machine (lambda N f) (i - 1)).st.own
          else (machine (lambda N f) i).st.prec)
        (machine (lambda N f) i).st.own
        (if i + 1 < N then (machine (lambda N f) (i + 1)).st.own
          else (machine (lambda N f) i).st.foll)
        (machine (lambda N f) i).st.id)
    = SimState.mk (f i).timesteps
      (LocalState.mk
        (if 0 < i then (f (i - 1)).st.own else (f i).st.prec)
        (f i).st.own
        (if i + 1 < N then (f (i + 1)).st.own else (f i).st.foll)
        (f i).st.id)
  rw [a, c, m0]

theorem swarm_tick_of (p : LocalParams) (s : State) (hD : 0 < p.ratio.den)
    (hl : p.protocol.n = counter_limit p.ratio) (hc : p.count = count s.drones)
    (ht : s.timesteps ≤ p.protocol.n) :
    swarm_tick p (swarm_of p.protocol s) = swarm_of p.protocol (tick p.protocol s) := by
  have hm : count (swarm_of p.protocol s) = count s.drones :=
    count_lambda (count s.drones) (project p.protocol s)
  have hsize : count (tick p.protocol s).drones = count s.drones := count_tick p.protocol s
  have h1 : lambda (count (swarm_of p.protocol s))
        (fun i => fmu_tick p (machine (swarm_of p.protocol s) i))
      = lambda (count s.drones) (ticked p s) := by
    rw [hm]
    refine lambda_ext (count s.drones) _ _ ?_
    intro i hi
    have hmi : machine (swarm_of p.protocol s) i = project p.protocol s i :=
      machine_lambda (count s.drones) (project p.protocol s) i hi
    have hf : fmu_tick p (machine (swarm_of p.protocol s) i)
        = fmu_tick p (project p.protocol s i) := congrArg (fmu_tick p) hmi
    exact Eq.trans hf (fmu_tick_project p s i hD hl hc ht hi)
  have h2 : swarm_tick p (swarm_of p.protocol s)
      = exchange (lambda (count s.drones) (ticked p s)) := congrArg exchange h1
  have h3 := exchange_lambda (count s.drones) (ticked p s)
  have h4 : lambda (count s.drones) (fun i =>
          SimState.mk (ticked p s i).timesteps
            (LocalState.mk
              (if 0 < i then (ticked p s (i - 1)).st.own else (ticked p s i).st.prec)
              (ticked p s i).st.own
              (if i + 1 < count s.drones then (ticked p s (i + 1)).st.own
                else (ticked p s i).st.foll)
              (ticked p s i).st.id))
      = lambda (count s.drones) (project p.protocol (tick p.protocol s)) := by
    refine lambda_ext (count s.drones) _ _ ?_
    intro i hi
    have a : (if 0 < i then getx (tick p.protocol s) (i - 1)
          else (if 0 < i then getx s (i - 1) else p.protocol.min))
        = (if 0 < i then getx (tick p.protocol s) (i - 1) else p.protocol.min) :=
      ite_else (0 < i) (getx (tick p.protocol s) (i - 1)) (getx s (i - 1)) p.protocol.min
    have c : (if i + 1 < count s.drones then getx (tick p.protocol s) (i + 1)
          else (if i + 1 < count s.drones then getx s (i + 1) else p.protocol.max))
        = (if i + 1 < count s.drones then getx (tick p.protocol s) (i + 1)
          else p.protocol.max) :=
      ite_else (i + 1 < count s.drones) (getx (tick p.protocol s) (i + 1)) (getx s (i + 1))
        p.protocol.max
    show SimState.mk (tick p.protocol s).timesteps
        (LocalState.mk
          (if 0 < i then getx (tick p.protocol s) (i - 1)
            else (if 0 < i then getx s (i - 1) else p.protocol.min))
          (getx (tick p.protocol s) i)
          (if i + 1 < count s.drones then getx (tick p.protocol s) (i + 1)
            else (if i + 1 < count s.drones then getx s (i + 1) else p.protocol.max))
          i)
      = SimState.mk (tick p.protocol s).timesteps
        (LocalState.mk
          (if 0 < i then getx (tick p.protocol s) (i - 1) else p.protocol.min)
          (getx (tick p.protocol s) i)
          (if i + 1 < count (tick p.protocol s).drones then getx (tick p.protocol s) (i + 1)
            else p.protocol.max)
          i)
    rw [hsize, a, c]
  have h5 : swarm_of p.protocol (tick p.protocol s)
      = lambda (count s.drones) (project p.protocol (tick p.protocol s)) :=
    congrArg (fun n => lambda n (project p.protocol (tick p.protocol s))) hsize
  exact Eq.trans h2 (Eq.trans h3 (Eq.trans h4 (Eq.symm h5)))

/-- The projection theorem. -/
theorem projection (p : LocalParams) (s : State) (hD : 0 < p.ratio.den)
    (hl : p.protocol.n = counter_limit p.ratio) (hc : p.count = count s.drones)
    (ht : s.timesteps ≤ p.protocol.n) (k : Nat) :
    swarm_kth_step p (swarm_of p.protocol s) k = swarm_of p.protocol (kth_step p.protocol s k) := by
  induction k with
  | zero => rfl
  | succ k ih =>
    have hck : p.count = count (kth_step p.protocol s k).drones :=
      Eq.trans hc (Eq.symm (count_kth_step p.protocol s k))
    have h1 : swarm_tick p (swarm_kth_step p (swarm_of p.protocol s) k)
        = swarm_tick p (swarm_of p.protocol (kth_step p.protocol s k)) :=
      congrArg (swarm_tick p) ih
    exact Eq.trans h1 (swarm_tick_of p (kth_step p.protocol s k) hD hl hck
      (kth_step_counter p.protocol s ht k))

end CordonMirror
