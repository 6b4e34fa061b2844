import CordonMirror.Thm.Ticks
import CordonMirror.Thm.Errors
import CordonMirror.Thm.Sum

/-! The paper's assumption 3 implies UB; theorems 7.3 and 7.4 under the paper's hypothesis. -/

namespace CordonMirror

/-- Assumption 3 implies UB, order or not. -/
theorem first_subsegment_upper_bounded (p : Params) (x : DroneMap Rat)
    (hs : p.min ≤ p.max) (ha : anchored p x) (hf : in_first_subsegment p x) :
    upper_bounded p x := by
  intro i hi
  by_cases h0 : i = 0
  · rw [h0]
    exact le_of_eq (Eq.symm (error_first p x ha.1))
  · by_cases hl : i = count x - 1
    · rw [hl]
      exact le_of_eq (Eq.symm (error_last p x ha.2))
    · have hi1 : (1 : Rat) ≤ (i : Rat) := one_le_cast i (by omega)
      have hx : gaps x * get x i < gaps x * p.min + (p.max - p.min) := hf i (by omega) (by omega)
      have hp : 0 ≤ ((i : Rat) - 1) * (p.max - p.min) := Rat.mul_nonneg (by grind) (by grind)
      have he : scaled_error p.min p.max x i
          = gaps x * p.min + (i : Rat) * (p.max - p.min) - gaps x * get x i := rfl
      rw [he]
      grind

/-- 7.3 under the paper's hypothesis, after every tick. -/
theorem upper_bound_paper (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (hs : p.min < p.max) (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps < 1)
    (hf : in_first_subsegment p s.drones) (k : Nat) :
    upper_bounded p (kth_step p s k).drones :=
  upper_bound_ticks p s hn ha e0 (Rat.le_of_lt e1)
    (first_subsegment_upper_bounded p s.drones (Rat.le_of_lt hs) ha hf) k

/-- 7.4 under the paper's hypothesis. -/
theorem sum_paper (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (hs : p.min < p.max) (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps < 1)
    (hf : in_first_subsegment p s.drones) (k : Nat) :
    2 * sum (protocol_step p s k).drones ≤ (count s.drones : Rat) * (p.min + p.max) ∧
    (2 * sum (protocol_step p s k).drones = (count s.drones : Rat) * (p.min + p.max) ↔
      at_targets p (protocol_step p s k).drones) :=
  sum_bounded_and_maximal p s hn ha e0 (Rat.le_of_lt e1)
    (first_subsegment_upper_bounded p s.drones (Rat.le_of_lt hs) ha hf) k

end CordonMirror
