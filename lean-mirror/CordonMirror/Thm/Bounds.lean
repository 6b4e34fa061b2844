import CordonMirror.Thm.Activation
import CordonMirror.Spec.Delay

/-! The bounds of 7.3 under any activation schedule and under any delays. As without them, each
bound says that a nonnegative affine image of the positions stays nonnegative. -/

namespace CordonMirror

/-! ### The bounds as affine images -/

theorem upper_bounded_line (p : Params) (x : DroneMap Rat) (hu : upper_bounded p x) :
    ∀ j : Nat, j < count x →
      0 ≤ scaled_line (count x - 1) p.min p.max j + (-((count x - 1 : Nat) : Rat)) * get x j := by
  intro j hj
  have h : 0 ≤ scaled_error p.min p.max x j := hu j hj
  rw [scaled_error_eq] at h
  exact h

theorem line_upper_bounded (p : Params) (x : DroneMap Rat)
    (h : ∀ j : Nat, j < count x →
      0 ≤ scaled_line (count x - 1) p.min p.max j + (-((count x - 1 : Nat) : Rat)) * get x j) :
    upper_bounded p x := by
  intro j hj
  rw [scaled_error_eq]
  exact h j hj

/-! ### Activation -/

theorem nonneg_active (p : Params) (schedule : Nat → Nat → Bool) (s : State)
    (hn : 3 ≤ count s.drones) (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (b : Nat → Rat) (d : Rat) (hb : ∀ i : Nat, b i + b (i + 2) = 2 * b (i + 1))
    (h0 : ∀ i : Nat, i ≤ count s.drones - 1 → 0 ≤ b i + d * get s.drones i) (k : Nat) :
    ∀ i : Nat, i ≤ count s.drones - 1 →
      0 ≤ b i + d * get (active_step p schedule s k).drones i := by
  induction k with
  | zero => exact h0
  | succ k ih =>
    exact nonneg_weighted (count s.drones - 1) (active_weight p.eps (schedule k))
      (fun i => b i + d * get (active_step p schedule s k).drones i)
      (fun i => b i + d * get (active_step p schedule s (k + 1)).drones i)
      (Weighted.affine (active_run p schedule s hn ha k) b d hb)
      (fun i _ _ => active_weight_nonneg p.eps (schedule k) i e0)
      (fun i _ _ => active_weight_le p.eps (schedule k) i e1) ih

/-- Any activation schedule preserves UB. -/
theorem upper_bound_active (p : Params) (schedule : Nat → Nat → Bool) (s : State)
    (hn : 3 ≤ count s.drones) (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (hu : upper_bounded p s.drones) (k : Nat) :
    upper_bounded p (active_step p schedule s k).drones := by
  have hc : count (active_step p schedule s k).drones = count s.drones :=
    count_active_step p schedule s k
  have h0 : ∀ i : Nat, i ≤ count s.drones - 1 →
      0 ≤ scaled_line (count s.drones - 1) p.min p.max i
        + (-((count s.drones - 1 : Nat) : Rat)) * get s.drones i :=
    fun i hi => upper_bounded_line p s.drones hu i (by omega)
  refine line_upper_bounded p (active_step p schedule s k).drones ?_
  intro j hj
  rw [hc]
  exact nonneg_active p schedule s hn ha e0 e1 (scaled_line (count s.drones - 1) p.min p.max)
    (-((count s.drones - 1 : Nat) : Rat))
    (scaled_line_straight (count s.drones - 1) p.min p.max) h0 k j (by omega)

/-- Any activation schedule preserves the box. -/
theorem box_active (p : Params) (schedule : Nat → Nat → Bool) (s : State)
    (hn : 3 ≤ count s.drones) (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (hb : in_box p s.drones) (k : Nat) : in_box p (active_step p schedule s k).drones := by
  intro i hi
  have hc : count (active_step p schedule s k).drones = count s.drones :=
    count_active_step p schedule s k
  have lo0 : ∀ j : Nat, j ≤ count s.drones - 1 → 0 ≤ -p.min + 1 * get s.drones j := by
    intro j hj
    have h : p.min ≤ get s.drones j := (hb j (by omega)).1
    grind
  have up0 : ∀ j : Nat, j ≤ count s.drones - 1 → 0 ≤ p.max + (-1) * get s.drones j := by
    intro j hj
    have h : get s.drones j ≤ p.max := (hb j (by omega)).2
    grind
  have slo : ∀ j : Nat, (fun _ : Nat => -p.min) j + (fun _ : Nat => -p.min) (j + 2)
      = 2 * (fun _ : Nat => -p.min) (j + 1) := by
    intro j
    show -p.min + -p.min = 2 * -p.min
    grind
  have sup : ∀ j : Nat, (fun _ : Nat => p.max) j + (fun _ : Nat => p.max) (j + 2)
      = 2 * (fun _ : Nat => p.max) (j + 1) := by
    intro j
    show p.max + p.max = 2 * p.max
    grind
  have lo : 0 ≤ -p.min + 1 * get (active_step p schedule s k).drones i :=
    nonneg_active p schedule s hn ha e0 e1 (fun _ => -p.min) 1 slo lo0 k i (by omega)
  have up : 0 ≤ p.max + (-1) * get (active_step p schedule s k).drones i :=
    nonneg_active p schedule s hn ha e0 e1 (fun _ => p.max) (-1) sup up0 k i (by omega)
  exact And.intro (by grind) (by grind)

/-! ### Delays -/

/-- `X` is a run in which, in step `k`, drone `i` sees drone `j` where it was `delay k i j` steps
before; before the start every drone stood where it started. -/
def DelayedRun (p : Params) (delay : Nat → Nat → Nat → Nat) (X : Nat → State) : Prop :=
  ∀ k : Nat, X (k + 1)
    = exec_coverage_delayed p (X k) (fun i j => getx (X (k - delay k i j)) j)

theorem count_delayed (p : Params) (s : State) (seen : Nat → Nat → Rat) :
    count (exec_coverage_delayed p s seen).drones = count s.drones :=
  count_lambda (count s.drones) (fun i =>
    update p (count s.drones) i (fun j => if j = i then getx s i else seen i j))

theorem get_delayed (p : Params) (s : State) (seen : Nat → Nat → Rat) (i : Nat)
    (h : i < count s.drones) :
    get (exec_coverage_delayed p s seen).drones i
      = update p (count s.drones) i (fun j => if j = i then getx s i else seen i j) :=
  get_lambda (count s.drones) (fun i =>
    update p (count s.drones) i (fun j => if j = i then getx s i else seen i j)) i h

theorem count_delayed_run (p : Params) (delay : Nat → Nat → Nat → Nat) (X : Nat → State)
    (hX : DelayedRun p delay X) : ∀ k : Nat, count (X k).drones = count (X 0).drones := by
  intro k
  induction k with
  | zero => rfl
  | succ k ih =>
    have hstep : X (k + 1)
        = exec_coverage_delayed p (X k) (fun i j => getx (X (k - delay k i j)) j) := hX k
    rw [hstep]
    exact Eq.trans (count_delayed p (X k) (fun i j => getx (X (k - delay k i j)) j)) ih

theorem delayed_inner (p : Params) (s : State) (seen : Nat → Nat → Rat) (i : Nat)
    (h : i + 2 < count s.drones) :
    get (exec_coverage_delayed p s seen).drones (i + 1)
      = p.eps * seen (i + 1) i + (1 - 2 * p.eps) * get s.drones (i + 1)
        + p.eps * seen (i + 1) (i + 2) := by
  have hg : get (exec_coverage_delayed p s seen).drones (i + 1)
      = update p (count s.drones) (i + 1)
        (fun j => if j = i + 1 then getx s (i + 1) else seen (i + 1) j) :=
    get_delayed p s seen (i + 1) (by omega)
  have hu : update p (count s.drones) (i + 1)
        (fun j => if j = i + 1 then getx s (i + 1) else seen (i + 1) j)
      = p.eps * (if i = i + 1 then getx s (i + 1) else seen (i + 1) i)
        + (1 - 2 * p.eps) * (if i + 1 = i + 1 then getx s (i + 1) else seen (i + 1) (i + 1))
        + p.eps * (if i + 2 = i + 1 then getx s (i + 1) else seen (i + 1) (i + 2)) :=
    update_inner p (count s.drones) i
      (fun j => if j = i + 1 then getx s (i + 1) else seen (i + 1) j) h
  have n0 : ¬ (i = i + 1) := by omega
  have n2 : ¬ (i + 2 = i + 1) := by omega
  have a0 : (if i = i + 1 then getx s (i + 1) else seen (i + 1) i) = seen (i + 1) i := if_neg n0
  have a1 : (if i + 1 = i + 1 then getx s (i + 1) else seen (i + 1) (i + 1))
      = get s.drones (i + 1) := if_pos rfl
  have a2 : (if i + 2 = i + 1 then getx s (i + 1) else seen (i + 1) (i + 2))
      = seen (i + 1) (i + 2) := if_neg n2
  rw [a0, a1, a2] at hu
  exact Eq.trans hg hu

theorem nonneg_delayed (p : Params) (delay : Nat → Nat → Nat → Nat) (X : Nat → State)
    (hX : DelayedRun p delay X) (hn : 3 ≤ count (X 0).drones) (ha : anchored p (X 0).drones)
    (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1) (b : Nat → Rat) (d : Rat)
    (hb : ∀ i : Nat, b i + b (i + 2) = 2 * b (i + 1))
    (h0 : ∀ i : Nat, i < count (X 0).drones → 0 ≤ b i + d * get (X 0).drones i) (k : Nat) :
    ∀ l : Nat, l ≤ k → ∀ i : Nat, i < count (X 0).drones → 0 ≤ b i + d * get (X l).drones i := by
  induction k with
  | zero =>
    intro l hl
    have hz : l = 0 := by omega
    rw [hz]
    exact h0
  | succ k ih =>
    intro l hl i hi
    by_cases hlk : l ≤ k
    · exact ih l hlk i hi
    · have hl2 : l = k + 1 := by omega
      have hc : count (X k).drones = count (X 0).drones := count_delayed_run p delay X hX k
      have hstep : X (k + 1)
          = exec_coverage_delayed p (X k) (fun i j => getx (X (k - delay k i j)) j) := hX k
      rw [hl2, hstep]
      by_cases hz : i = 0
      · have hg : get (exec_coverage_delayed p (X k)
            (fun i j => getx (X (k - delay k i j)) j)).drones 0 = p.min :=
          Eq.trans (get_delayed p (X k) (fun i j => getx (X (k - delay k i j)) j) 0 (by omega))
            (update_first p (count (X k).drones) _)
        have hs : get (X 0).drones 0 = p.min := ha.1
        rw [hz, hg, ← hs]
        exact h0 0 (by omega)
      · by_cases he : i = count (X 0).drones - 1
        · have hg : get (exec_coverage_delayed p (X k)
              (fun i j => getx (X (k - delay k i j)) j)).drones (count (X k).drones - 1) = p.max :=
            Eq.trans (get_delayed p (X k) (fun i j => getx (X (k - delay k i j)) j)
              (count (X k).drones - 1) (by omega))
              (update_last p (count (X k).drones) _ (by omega))
          rw [hc] at hg
          have hs : get (X 0).drones (count (X 0).drones - 1) = p.max := ha.2
          have h := h0 (count (X 0).drones - 1) (by omega)
          rw [hs] at h
          rw [he, hg]
          exact h
        · obtain ⟨j, hj⟩ : ∃ j : Nat, i = j + 1 := ⟨i - 1, by omega⟩
          subst hj
          have hg : get (exec_coverage_delayed p (X k)
                (fun i j => getx (X (k - delay k i j)) j)).drones (j + 1)
              = p.eps * getx (X (k - delay k (j + 1) j)) j
                + (1 - 2 * p.eps) * get (X k).drones (j + 1)
                + p.eps * getx (X (k - delay k (j + 1) (j + 2))) (j + 2) :=
            delayed_inner p (X k) (fun i j => getx (X (k - delay k i j)) j) j (by omega)
          have q0 : 0 ≤ b j + d * getx (X (k - delay k (j + 1) j)) j :=
            ih (k - delay k (j + 1) j) (by omega) j (by omega)
          have q1 : 0 ≤ b (j + 1) + d * get (X k).drones (j + 1) :=
            ih k (Nat.le_refl k) (j + 1) (by omega)
          have q2 : 0 ≤ b (j + 2) + d * getx (X (k - delay k (j + 1) (j + 2))) (j + 2) :=
            ih (k - delay k (j + 1) (j + 2)) (by omega) (j + 2) (by omega)
          have p0 := Rat.mul_nonneg e0 q0
          have p1 : 0 ≤ (1 - 2 * p.eps) * (b (j + 1) + d * get (X k).drones (j + 1)) :=
            Rat.mul_nonneg (by grind) q1
          have p2 := Rat.mul_nonneg e0 q2
          have hbj : p.eps * (b j + b (j + 2)) = p.eps * (2 * b (j + 1)) :=
            congrArg (fun t => p.eps * t) (hb j)
          rw [hg]
          grind

/-- Any delays preserve UB. -/
theorem upper_bound_delayed (p : Params) (delay : Nat → Nat → Nat → Nat) (X : Nat → State)
    (hX : DelayedRun p delay X) (hn : 3 ≤ count (X 0).drones) (ha : anchored p (X 0).drones)
    (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1) (hu : upper_bounded p (X 0).drones) (k : Nat) :
    upper_bounded p (X k).drones := by
  have hc : count (X k).drones = count (X 0).drones := count_delayed_run p delay X hX k
  refine line_upper_bounded p (X k).drones ?_
  intro j hj
  rw [hc]
  rw [hc] at hj
  exact nonneg_delayed p delay X hX hn ha e0 e1
    (scaled_line (count (X 0).drones - 1) p.min p.max)
    (-((count (X 0).drones - 1 : Nat) : Rat))
    (scaled_line_straight (count (X 0).drones - 1) p.min p.max)
    (upper_bounded_line p (X 0).drones hu) k k (Nat.le_refl k) j hj

/-! ### Delays do not preserve order: executed, not proved -/

/-- The history of a delayed run, the newest state first. -/
def delayed_history (p : Params) (delay : Nat → Nat → Nat → Nat) (s : State) :
    Nat → List State
  | 0 => [s]
  | k + 1 =>
    let h := delayed_history p delay s k
    exec_coverage_delayed p (get_or s h 0) (fun i j => getx (get_or s h (delay k i j)) j) :: h

/-- PROTOCOL's five drones: 1 and 2 see each other three steps late. -/
def crossing_run (k : Nat) : State :=
  get_or (State.mk [] 0)
    (delayed_history (Params.mk 0 1 (1 / 3) 0)
      (fun _ i j => if (i = 1 ∧ j = 2) ∨ (i = 2 ∧ j = 1) then 3 else 0)
      (State.mk [0, 1 / 100, 98 / 100, 99 / 100, 1] 0) k) 0

#guard decide (getx (crossing_run 3) 1 < getx (crossing_run 3) 2)
#guard decide (getx (crossing_run 4) 2 < getx (crossing_run 4) 1)

end CordonMirror
