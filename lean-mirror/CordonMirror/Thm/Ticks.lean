import CordonMirror.Thm.Ordering
import CordonMirror.Thm.UpperBound

/-! Ticks. Whatever the period and the counter, they reach only placements that protocol steps
reach, so that an invariant of protocol steps is one of ticks. -/

namespace CordonMirror

theorem tick_fires (p : Params) (s : State) (h : s.timesteps = p.n) :
    tick p s = State.mk (next_placement p s.drones) 0 := by
  unfold tick tick_with
  exact if_pos h

theorem tick_waits (p : Params) (s : State) (h : ¬ (s.timesteps = p.n)) :
    tick p s = State.mk s.drones (s.timesteps + 1) := by
  unfold tick tick_with
  exact if_neg h

theorem count_tick (p : Params) (s : State) : count (tick p s).drones = count s.drones := by
  by_cases h : s.timesteps = p.n
  · have h1 : count (tick p s).drones = count (next_placement p s.drones) :=
      congrArg (fun t => count (State.drones t)) (tick_fires p s h)
    exact Eq.trans h1 (count_exec p s)
  · have h1 : count (tick p s).drones = count s.drones :=
      congrArg (a₂ := State.mk s.drones (s.timesteps + 1)) (fun t => count (State.drones t))
        (tick_waits p s h)
    exact h1

theorem count_kth_step (p : Params) (s : State) :
    ∀ k : Nat, count (kth_step p s k).drones = count s.drones
  | 0 => rfl
  | k + 1 => Eq.trans (count_tick p (kth_step p s k)) (count_kth_step p s k)

/-- The counter stays within `0 .. n`. -/
theorem tick_counter (p : Params) (s : State) (h : s.timesteps ≤ p.n) :
    (tick p s).timesteps ≤ p.n := by
  by_cases hf : s.timesteps = p.n
  · have h1 : (tick p s).timesteps = 0 := congrArg State.timesteps (tick_fires p s hf)
    omega
  · have h1 : (tick p s).timesteps = s.timesteps + 1 :=
      congrArg State.timesteps (tick_waits p s hf)
    omega

theorem kth_step_counter (p : Params) (s : State) (h : s.timesteps ≤ p.n) (k : Nat) :
    (kth_step p s k).timesteps ≤ p.n := by
  induction k with
  | zero => exact h
  | succ k ih => exact tick_counter p (kth_step p s k) ih

/-- Ticks reach only placements that protocol steps reach. -/
theorem kth_step_reaches (p : Params) (s : State) (k : Nat) :
    ∃ j : Nat, (kth_step p s k).drones = (protocol_step p s j).drones := by
  induction k with
  | zero => exact Exists.intro 0 rfl
  | succ k ih =>
    obtain ⟨j, hj⟩ := ih
    by_cases h : (kth_step p s k).timesteps = p.n
    · have h1 : (tick p (kth_step p s k)).drones
          = next_placement p (kth_step p s k).drones :=
        congrArg State.drones (tick_fires p (kth_step p s k) h)
      have h2 : next_placement p (kth_step p s k).drones
          = next_placement p (protocol_step p s j).drones := congrArg (next_placement p) hj
      exact Exists.intro (j + 1) (Eq.trans h1 h2)
    · have h1 : (tick p (kth_step p s k)).drones = (kth_step p s k).drones :=
        congrArg (a₂ := State.mk (kth_step p s k).drones ((kth_step p s k).timesteps + 1))
          State.drones (tick_waits p (kth_step p s k) h)
      exact Exists.intro j (Eq.trans h1 hj)

/-- 7.2 after every tick. -/
theorem ordering_ticks (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (ho : ordered s.drones) (k : Nat) : ordered (kth_step p s k).drones := by
  obtain ⟨j, hj⟩ := kth_step_reaches p s k
  rw [hj]
  exact ordering_sharp p s hn ha e0 e1 ho j

/-- 7.3 after every tick. -/
theorem upper_bound_ticks (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (hu : upper_bounded p s.drones) (k : Nat) : upper_bounded p (kth_step p s k).drones := by
  obtain ⟨j, hj⟩ := kth_step_reaches p s k
  rw [hj]
  exact upper_bound_sharp p s hn ha e0 e1 hu j

/-- The mirror image after every tick. -/
theorem lower_bound_ticks (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (hu : above_targets p s.drones) (k : Nat) : above_targets p (kth_step p s k).drones := by
  obtain ⟨j, hj⟩ := kth_step_reaches p s k
  rw [hj]
  exact lower_bound_sharp p s hn ha e0 e1 hu j

/-- The box after every tick. -/
theorem box_ticks (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (hb : in_box p s.drones) (k : Nat) : in_box p (kth_step p s k).drones := by
  obtain ⟨j, hj⟩ := kth_step_reaches p s k
  rw [hj]
  exact box_sharp p s hn ha e0 e1 hb j

end CordonMirror
