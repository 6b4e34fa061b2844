import CordonMirror.Spec.Activation
import CordonMirror.Thm.Ordering
import CordonMirror.Thm.UpperBound

/-! Any subset of the drones may skip any update: ordering and bounds still hold. -/

namespace CordonMirror

/-- `k` steps; step `j` lets the drones of `schedule j` update. -/
def active_step (p : Params) (schedule : Nat → Nat → Bool) (start : State) : Nat → State
  | 0 => start
  | k + 1 => exec_coverage_active p (active_step p schedule start k) (schedule k)

/-- A drone that skips is one that moves with weight 0. -/
def active_weight (e : Rat) (active : Nat → Bool) (i : Nat) : Rat :=
  if active i = true then e else 0

theorem active_weight_nonneg (e : Rat) (active : Nat → Bool) (i : Nat) (e0 : 0 ≤ e) :
    0 ≤ active_weight e active i := by
  unfold active_weight
  by_cases h : active i = true
  · have hp : (if active i = true then e else 0) = e := if_pos h
    rw [hp]
    exact e0
  · have hz : (if active i = true then e else 0) = 0 := if_neg h
    exact le_of_eq (Eq.symm hz)

theorem active_weight_le (e : Rat) (active : Nat → Bool) (i : Nat) (e1 : 2 * e ≤ 1) :
    2 * active_weight e active i ≤ 1 := by
  unfold active_weight
  by_cases h : active i = true
  · have hp : (if active i = true then e else 0) = e := if_pos h
    rw [hp]
    exact e1
  · have hz : (if active i = true then e else 0) = 0 := if_neg h
    rw [hz]
    grind

theorem count_active (p : Params) (s : State) (active : Nat → Bool) :
    count (exec_coverage_active p s active).drones = count s.drones :=
  count_lambda (count s.drones) (fun i =>
    if active i = true then update p (count s.drones) i (getx s) else getx s i)

theorem get_active (p : Params) (s : State) (active : Nat → Bool) (i : Nat)
    (h : i < count s.drones) :
    get (exec_coverage_active p s active).drones i
      = if active i = true then update p (count s.drones) i (getx s) else getx s i :=
  get_lambda (count s.drones) (fun j =>
    if active j = true then update p (count s.drones) j (getx s) else getx s j) i h

theorem active_weighted (p : Params) (s : State) (active : Nat → Bool)
    (hn : 3 ≤ count s.drones) (ha : anchored p s.drones) :
    Weighted (count s.drones - 1) (active_weight p.eps active)
      (get s.drones) (get (exec_coverage_active p s active).drones) := by
  refine Weighted.mk ?_ ?_ ?_
  · have h : get (exec_coverage_active p s active).drones 0
        = if active 0 = true then update p (count s.drones) 0 (getx s) else getx s 0 :=
      get_active p s active 0 (by omega)
    rw [h]
    by_cases hb : active 0 = true
    · rw [if_pos hb]
      exact Eq.trans (update_first p (count s.drones) (getx s)) (Eq.symm ha.1)
    · exact if_neg hb
  · have h : get (exec_coverage_active p s active).drones (count s.drones - 1)
        = if active (count s.drones - 1) = true
          then update p (count s.drones) (count s.drones - 1) (getx s)
          else getx s (count s.drones - 1) :=
      get_active p s active (count s.drones - 1) (by omega)
    rw [h]
    by_cases hb : active (count s.drones - 1) = true
    · rw [if_pos hb]
      exact Eq.trans (update_last p (count s.drones) (getx s) (by omega)) (Eq.symm ha.2)
    · exact if_neg hb
  · intro i hi
    have h : get (exec_coverage_active p s active).drones (i + 1)
        = if active (i + 1) = true then update p (count s.drones) (i + 1) (getx s)
          else getx s (i + 1) :=
      get_active p s active (i + 1) (by omega)
    rw [h]
    unfold active_weight
    by_cases hb : active (i + 1) = true
    · rw [if_pos hb, if_pos hb]
      have hu : update p (count s.drones) (i + 1) (getx s)
          = p.eps * get s.drones i + (1 - 2 * p.eps) * get s.drones (i + 1)
            + p.eps * get s.drones (i + 2) :=
        update_inner p (count s.drones) i (getx s) (by omega)
      rw [hu]
      grind
    · rw [if_neg hb, if_neg hb]
      have hg : getx s (i + 1) = get s.drones (i + 1) := rfl
      rw [hg]
      grind

theorem count_active_step (p : Params) (schedule : Nat → Nat → Bool) (s : State) :
    ∀ k : Nat, count (active_step p schedule s k).drones = count s.drones
  | 0 => rfl
  | k + 1 => Eq.trans (count_active p (active_step p schedule s k) (schedule k))
      (count_active_step p schedule s k)

theorem anchored_active (p : Params) (schedule : Nat → Nat → Bool) (s : State)
    (hn : 3 ≤ count s.drones) (ha : anchored p s.drones) (k : Nat) :
    anchored p (active_step p schedule s k).drones := by
  induction k with
  | zero => exact ha
  | succ k ih =>
    have hc : count (active_step p schedule s k).drones = count s.drones :=
      count_active_step p schedule s k
    have hc2 : count (active_step p schedule s (k + 1)).drones = count s.drones :=
      count_active_step p schedule s (k + 1)
    have hw : Weighted (count (active_step p schedule s k).drones - 1)
        (active_weight p.eps (schedule k)) (get (active_step p schedule s k).drones)
        (get (active_step p schedule s (k + 1)).drones) :=
      active_weighted p (active_step p schedule s k) (schedule k) (by omega) ih
    have h0 : get (active_step p schedule s (k + 1)).drones 0 = p.min :=
      Eq.trans hw.left_end ih.1
    have hl : get (active_step p schedule s (k + 1)).drones
        (count (active_step p schedule s k).drones - 1) = p.max :=
      Eq.trans hw.right_end ih.2
    refine And.intro h0 ?_
    rw [hc] at hl
    rw [hc2]
    exact hl

theorem active_run (p : Params) (schedule : Nat → Nat → Bool) (s : State)
    (hn : 3 ≤ count s.drones) (ha : anchored p s.drones) (k : Nat) :
    Weighted (count s.drones - 1) (active_weight p.eps (schedule k))
      (get (active_step p schedule s k).drones)
      (get (active_step p schedule s (k + 1)).drones) := by
  have hc : count (active_step p schedule s k).drones = count s.drones :=
    count_active_step p schedule s k
  have hw : Weighted (count (active_step p schedule s k).drones - 1)
      (active_weight p.eps (schedule k)) (get (active_step p schedule s k).drones)
      (get (active_step p schedule s (k + 1)).drones) :=
    active_weighted p (active_step p schedule s k) (schedule k) (by omega)
      (anchored_active p schedule s hn ha k)
  rw [hc] at hw
  exact hw

/-- Ordering survives any activation schedule. -/
theorem ordering_active (p : Params) (schedule : Nat → Nat → Bool) (s : State)
    (hn : 3 ≤ count s.drones) (ha : anchored p s.drones) (e0 : 0 ≤ p.eps)
    (e1 : 2 * p.eps ≤ 1) (ho : ordered s.drones) (k : Nat) :
    ordered (active_step p schedule s k).drones := by
  have key : ∀ i : Nat, i < count s.drones - 1 →
      get (active_step p schedule s k).drones i
        < get (active_step p schedule s k).drones (i + 1) := by
    induction k with
    | zero =>
      intro i hi
      exact ho i (by omega)
    | succ k ih =>
      refine ordering_weighted (count s.drones - 1) (by omega)
        (active_weight p.eps (schedule k))
        (get (active_step p schedule s k).drones)
        (get (active_step p schedule s (k + 1)).drones)
        (active_run p schedule s hn ha k) ?_ ?_ ?_ ih
      · intro i _ _
        exact active_weight_nonneg p.eps (schedule k) i e0
      · intro i _ _
        have h0 : 0 ≤ active_weight p.eps (schedule k) i :=
          active_weight_nonneg p.eps (schedule k) i e0
        have h1 : 2 * active_weight p.eps (schedule k) i ≤ 1 :=
          active_weight_le p.eps (schedule k) i e1
        grind
      · intro i _ _
        have h1 : 2 * active_weight p.eps (schedule k) i ≤ 1 :=
          active_weight_le p.eps (schedule k) i e1
        have h2 : 2 * active_weight p.eps (schedule k) (i + 1) ≤ 1 :=
          active_weight_le p.eps (schedule k) (i + 1) e1
        grind
  intro i hi
  have hc : count (active_step p schedule s k).drones = count s.drones :=
    count_active_step p schedule s k
  exact key i (by omega)

end CordonMirror
