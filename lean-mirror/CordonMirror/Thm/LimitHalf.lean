import CordonMirror.Thm.Limit
import CordonMirror.Thm.Errors

/-! Theorem 7.8 for `0 < eps ≤ 1/2` on the spec, in epsilon form. -/

namespace CordonMirror

/-- Finitely many numbers have a common bound. -/
theorem exists_bound (f : Nat → Rat) (n : Nat) :
    ∃ C : Rat, 0 ≤ C ∧ ∀ i : Nat, i < n → f i ≤ C ∧ -f i ≤ C := by
  induction n with
  | zero =>
    refine Exists.intro 0 (And.intro (Rat.le_refl) ?_)
    intro i hi
    exact absurd hi (Nat.not_lt_zero i)
  | succ n ih =>
    obtain ⟨C, hC, hb⟩ := ih
    by_cases hf : 0 ≤ f n
    · refine Exists.intro (C + f n) (And.intro (by grind) ?_)
      intro i hi
      by_cases hl : i = n
      · subst hl
        exact And.intro (by grind) (by grind)
      · have h := hb i (by omega)
        exact And.intro (by grind) (by grind)
    · have hf2 : f n < 0 := Rat.not_le.mp hf
      refine Exists.intro (C - f n) (And.intro (by grind) ?_)
      intro i hi
      by_cases hl : i = n
      · subst hl
        exact And.intro (by grind) (by grind)
      · have h := hb i (by omega)
        exact And.intro (by grind) (by grind)

theorem weight_ge_one (M i : Nat) (h0 : 0 < i) (hM : i < M) : 1 ≤ weight M i := by
  have hi : (1 : Rat) ≤ (i : Rat) := one_le_cast i h0
  have h2 : ((i + 1 : Nat) : Rat) ≤ (M : Rat) := cast_le_cast (i + 1) M hM
  have h3 : ((i + 1 : Nat) : Rat) = (i : Rat) + 1 := cast_add_one i
  rw [h3] at h2
  have hp : 0 ≤ ((i : Rat) - 1) * ((M : Rat) - (i : Rat) - 1) :=
    Rat.mul_nonneg (by grind) (by grind)
  unfold weight
  grind

/-- The rate `1 - 8 eps / M²` without division. -/
theorem exists_rate (M : Nat) (e : Rat) (hM : 2 ≤ M) (e0 : 0 < e) (e1 : 2 * e ≤ 1) :
    ∃ r : Rat, 0 ≤ r ∧ r < 1 ∧
      (M : Rat) * (M : Rat) * r = (M : Rat) * (M : Rat) - 8 * e := by
  have h2 : ((2 : Nat) : Rat) ≤ (M : Rat) := cast_le_cast 2 M hM
  have k2 : ((2 : Nat) : Rat) = 2 := by grind
  rw [k2] at h2
  have hs : 0 ≤ ((M : Rat) - 2) * ((M : Rat) - 2) := mul_self_nonneg ((M : Rat) - 2)
  have mm : 4 ≤ (M : Rat) * (M : Rat) := by grind
  have mpos : 0 < (M : Rat) * (M : Rat) := by grind
  obtain ⟨r, hr⟩ := exists_quotient ((M : Rat) * (M : Rat)) ((M : Rat) * (M : Rat) - 8 * e) mpos
  refine Exists.intro r ?_
  refine And.intro ?_ (And.intro ?_ hr)
  · refine Classical.byContradiction fun hneg => ?_
    have hlt : r < 0 := Rat.not_le.mp hneg
    have hp : (M : Rat) * (M : Rat) * r < 0 := mul_neg_of_pos_of_neg mpos hlt
    grind
  · have hp : 0 < (M : Rat) * (M : Rat) * (1 - r) := by grind
    have h : 0 < 1 - r := pos_of_scaled ((M : Rat) * (M : Rat)) (1 - r) mpos hp
    grind

/-- 7.8 for `0 < eps ≤ 1/2`, in epsilon form, free of division. -/
theorem limit_half (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 < p.eps) (e1 : 2 * p.eps ≤ 1) (i : Nat) (d : Rat)
    (hi : i < count s.drones) (hd : 0 < d) :
    ∃ K : Nat, ∀ k : Nat, K ≤ k →
      scaled_error p.min p.max (protocol_step p s k).drones i < d ∧
      -scaled_error p.min p.max (protocol_step p s k).drones i < d := by
  obtain ⟨m, hm⟩ : ∃ m : Nat, count s.drones = m + 1 := ⟨count s.drones - 1, by omega⟩
  have hM : count s.drones - 1 = m := by omega
  have hE : Run m p.eps (errors p s) := by
    have h0 : Run (count s.drones - 1) p.eps (errors p s) := errors_run p s hn ha
    rw [hM] at h0
    exact h0
  have z0 : errors p s 0 0 = 0 := errors_first p s hn ha 0
  have zM : errors p s 0 m = 0 := by
    have h0 : errors p s 0 (count s.drones - 1) = 0 := errors_last p s hn ha 0
    rw [hM] at h0
    exact h0
  obtain ⟨r, r0, r1, hr⟩ := exists_rate m p.eps (by omega) e0 e1
  obtain ⟨C, hC, hb⟩ := exists_bound (errors p s 0) (m + 1)
  have hbound : ∀ j : Nat, j ≤ m →
      errors p s 0 j ≤ C * weight m j ∧ -errors p s 0 j ≤ C * weight m j := by
    intro j hj
    by_cases h0 : j = 0
    · subst h0
      have hw : weight m 0 = 0 := weight_first m
      rw [hw, z0]
      exact And.intro (by grind) (by grind)
    · by_cases hl : j = m
      · rw [hl]
        have hw : weight m m = 0 := weight_last m
        rw [hw, zM]
        exact And.intro (by grind) (by grind)
      · have hw : 1 ≤ weight m j := weight_ge_one m j (by omega) (by omega)
        have hcw : 0 ≤ C * (weight m j - 1) := Rat.mul_nonneg hC (by grind)
        have h := hb j (by omega)
        exact And.intro (by grind) (by grind)
  obtain ⟨K, hK⟩ := pow_small r (C * weight m i) d r0 r1 hd
  refine Exists.intro K ?_
  intro k hk
  have hs : r ^ k * (C * weight m i) < d := hK k hk
  have h : errors p s k i ≤ r ^ k * C * weight m i ∧ -errors p s k i ≤ r ^ k * C * weight m i :=
    limit_rate m p.eps r C (by omega) (Rat.le_of_lt e0) e1 r0 hr hC (errors p s) hE z0 zM
      (fun j hj => (hbound j hj).1) (fun j hj => (hbound j hj).2) k i (by omega)
  have hp : r ^ k * C * weight m i = r ^ k * (C * weight m i) := by grind
  rw [hp] at h
  exact And.intro (lt_of_le_of_lt h.1 hs) (lt_of_le_of_lt h.2 hs)

end CordonMirror
