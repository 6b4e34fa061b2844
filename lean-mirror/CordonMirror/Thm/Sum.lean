import CordonMirror.Thm.NonDecreasing
import CordonMirror.Thm.Arithmetic

/-! Corollary 7.4: the sum of the positions is bounded, and meets its bound exactly when every
drone is at its target. -/

namespace CordonMirror

/-! ### Sums -/

theorem sumn_ext (f g : Nat → Rat) (n : Nat) :
    (∀ i : Nat, i < n → f i = g i) → sumn f n = sumn g n := by
  induction n with
  | zero =>
    intro _
    rfl
  | succ n ih =>
    intro h
    have h1 : sumn f n = sumn g n := ih (fun i hi => h i (by omega))
    have h2 : f n = g n := h n (by omega)
    show sumn f n + f n = sumn g n + g n
    rw [h1, h2]

theorem sumn_add (f g : Nat → Rat) (n : Nat) :
    sumn (fun i => f i + g i) n = sumn f n + sumn g n := by
  induction n with
  | zero =>
    show (0 : Rat) = 0 + 0
    grind
  | succ n ih =>
    show sumn (fun i => f i + g i) n + (f n + g n) = (sumn f n + f n) + (sumn g n + g n)
    rw [ih]
    grind

theorem sumn_scale (c : Rat) (f : Nat → Rat) (n : Nat) :
    sumn (fun i => c * f i) n = c * sumn f n := by
  induction n with
  | zero =>
    show (0 : Rat) = c * 0
    grind
  | succ n ih =>
    show sumn (fun i => c * f i) n + c * f n = c * (sumn f n + f n)
    rw [ih]
    grind

theorem sumn_zero (f : Nat → Rat) (n : Nat) :
    (∀ i : Nat, i < n → f i = 0) → sumn f n = 0 := by
  induction n with
  | zero =>
    intro _
    rfl
  | succ n ih =>
    intro h
    have h1 : sumn f n = 0 := ih (fun i hi => h i (by omega))
    have h2 : f n = 0 := h n (by omega)
    show sumn f n + f n = 0
    grind

theorem sumn_nonneg (f : Nat → Rat) (n : Nat) :
    (∀ i : Nat, i < n → 0 ≤ f i) → 0 ≤ sumn f n := by
  induction n with
  | zero =>
    intro _
    exact Rat.le_refl
  | succ n ih =>
    intro h
    have h1 : 0 ≤ sumn f n := ih (fun i hi => h i (by omega))
    have h2 : 0 ≤ f n := h n (by omega)
    show 0 ≤ sumn f n + f n
    grind

theorem sumn_zero_each (f : Nat → Rat) (n : Nat) :
    (∀ i : Nat, i < n → 0 ≤ f i) → sumn f n = 0 → ∀ i : Nat, i < n → f i = 0 := by
  induction n with
  | zero =>
    intro _ _ i hi
    exact absurd hi (Nat.not_lt_zero i)
  | succ n ih =>
    intro h hs i hi
    have hn : 0 ≤ sumn f n := sumn_nonneg f n (fun j hj => h j (by omega))
    have hf : 0 ≤ f n := h n (by omega)
    have hs2 : sumn f n + f n = 0 := hs
    have z1 : sumn f n = 0 := by grind
    have z2 : f n = 0 := by grind
    by_cases hl : i = n
    · rw [hl]
      exact z2
    · exact ih (fun j hj => h j (by omega)) z1 i (by omega)

theorem sumn_line (M : Nat) (lo up : Rat) (n : Nat) :
    2 * sumn (scaled_line M lo up) n
      = 2 * ((n : Rat) * ((M : Rat) * lo)) + (n : Rat) * ((n : Rat) - 1) * (up - lo) := by
  induction n with
  | zero =>
    have h0 : ((0 : Nat) : Rat) = 0 := rfl
    have hs : sumn (scaled_line M lo up) 0 = 0 := rfl
    rw [h0, hs]
    grind
  | succ n ih =>
    have h1 : ((n + 1 : Nat) : Rat) = (n : Rat) + 1 := cast_add_one n
    have hl : scaled_line M lo up n = (M : Rat) * lo + (n : Rat) * (up - lo) := rfl
    have hs : sumn (scaled_line M lo up) (n + 1)
        = sumn (scaled_line M lo up) n + scaled_line M lo up n := rfl
    rw [h1, hs, hl]
    grind

/-- The errors add up to what the sum lacks, times `(N - 1) / 2`. -/
theorem sum_errors (lo up : Rat) (x : DroneMap Rat) (m : Nat) (hm : count x = m + 1) :
    2 * sumn (scaled_error lo up x) (m + 1)
      = (m : Rat) * ((count x : Rat) * (lo + up) - 2 * sum x) := by
  have hM : count x - 1 = m := by omega
  have hf : ∀ i : Nat, i < m + 1 →
      scaled_error lo up x i = scaled_line m lo up i + (-(m : Rat)) * get x i := by
    intro i _
    have h : scaled_error lo up x i
        = scaled_line (count x - 1) lo up i + (-((count x - 1 : Nat) : Rat)) * get x i :=
      scaled_error_eq lo up x i
    rw [hM] at h
    exact h
  have h1 : sumn (scaled_error lo up x) (m + 1)
      = sumn (fun i => scaled_line m lo up i + (-(m : Rat)) * get x i) (m + 1) :=
    sumn_ext (scaled_error lo up x)
      (fun i => scaled_line m lo up i + (-(m : Rat)) * get x i) (m + 1) hf
  have h2 : sumn (fun i => scaled_line m lo up i + (-(m : Rat)) * get x i) (m + 1)
      = sumn (scaled_line m lo up) (m + 1) + sumn (fun i => (-(m : Rat)) * get x i) (m + 1) :=
    sumn_add (scaled_line m lo up) (fun i => (-(m : Rat)) * get x i) (m + 1)
  have h3 : sumn (fun i => (-(m : Rat)) * get x i) (m + 1)
      = (-(m : Rat)) * sumn (get x) (m + 1) := sumn_scale (-(m : Rat)) (get x) (m + 1)
  have h4 : sum x = sumn (get x) (m + 1) := by
    have h : sum x = sumn (get x) (count x) := sum_sumn x
    rw [hm] at h
    exact h
  have h5 : 2 * sumn (scaled_line m lo up) (m + 1)
      = 2 * (((m + 1 : Nat) : Rat) * ((m : Rat) * lo))
        + ((m + 1 : Nat) : Rat) * (((m + 1 : Nat) : Rat) - 1) * (up - lo) :=
    sumn_line m lo up (m + 1)
  have h6 : ((m + 1 : Nat) : Rat) = (m : Rat) + 1 := cast_add_one m
  rw [h6] at h5
  rw [hm, h6, h1, h2, h3, h4]
  grind

/-! ### On the spec -/

theorem sum_below (p : Params) (x : DroneMap Rat) (hn : 3 ≤ count x) (hu : upper_bounded p x) :
    2 * sum x ≤ (count x : Rat) * (p.min + p.max) ∧
    (2 * sum x = (count x : Rat) * (p.min + p.max) ↔ at_targets p x) := by
  obtain ⟨m, hm⟩ : ∃ m : Nat, count x = m + 1 := ⟨count x - 1, by omega⟩
  have he : 2 * sumn (scaled_error p.min p.max x) (m + 1)
      = (m : Rat) * ((count x : Rat) * (p.min + p.max) - 2 * sum x) :=
    sum_errors p.min p.max x m hm
  have mpos : (0 : Rat) < (m : Rat) := cast_pos_of_pos m (by omega)
  have hpos : ∀ i : Nat, i < m + 1 → 0 ≤ scaled_error p.min p.max x i :=
    fun i hi => hu i (by omega)
  have hs : 0 ≤ sumn (scaled_error p.min p.max x) (m + 1) :=
    sumn_nonneg (scaled_error p.min p.max x) (m + 1) hpos
  refine And.intro ?_ (Iff.intro ?_ ?_)
  · refine Classical.byContradiction fun hneg => ?_
    have hlt : (count x : Rat) * (p.min + p.max) - 2 * sum x < 0 := by
      have h : (count x : Rat) * (p.min + p.max) < 2 * sum x := Rat.not_le.mp hneg
      grind
    have hprod : (m : Rat) * ((count x : Rat) * (p.min + p.max) - 2 * sum x) < 0 :=
      mul_neg_of_pos_of_neg mpos hlt
    grind
  · intro heq i hi
    have hd : (count x : Rat) * (p.min + p.max) - 2 * sum x = 0 := by grind
    rw [hd] at he
    have hs0 : sumn (scaled_error p.min p.max x) (m + 1) = 0 := by grind
    exact sumn_zero_each (scaled_error p.min p.max x) (m + 1) hpos hs0 i (by omega)
  · intro ht
    have hs0 : sumn (scaled_error p.min p.max x) (m + 1) = 0 :=
      sumn_zero (scaled_error p.min p.max x) (m + 1) (fun i hi => ht i (by omega))
    have hz : (m : Rat) * ((count x : Rat) * (p.min + p.max) - 2 * sum x) = 0 := by grind
    have hd : (count x : Rat) * (p.min + p.max) - 2 * sum x = 0 :=
      zero_of_scaled (m : Rat) ((count x : Rat) * (p.min + p.max) - 2 * sum x) mpos hz
    grind

/-- 7.4, both parts, free of division. -/
theorem sum_bounded_and_maximal (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (hu : upper_bounded p s.drones) (k : Nat) :
    2 * sum (protocol_step p s k).drones ≤ (count s.drones : Rat) * (p.min + p.max) ∧
    (2 * sum (protocol_step p s k).drones = (count s.drones : Rat) * (p.min + p.max) ↔
      at_targets p (protocol_step p s k).drones) := by
  have hc : count (protocol_step p s k).drones = count s.drones := count_step p s k
  have hk : upper_bounded p (protocol_step p s k).drones :=
    upper_bound_sharp p s hn ha e0 e1 hu k
  have h : 2 * sum (protocol_step p s k).drones
        ≤ (count (protocol_step p s k).drones : Rat) * (p.min + p.max) ∧
      (2 * sum (protocol_step p s k).drones
        = (count (protocol_step p s k).drones : Rat) * (p.min + p.max) ↔
        at_targets p (protocol_step p s k).drones) :=
    sum_below p (protocol_step p s k).drones (by omega) hk
  rw [hc] at h
  exact h

end CordonMirror
