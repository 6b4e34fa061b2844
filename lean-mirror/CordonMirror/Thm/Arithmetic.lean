/-! Facts of arithmetic that several theorems need and core's rationals have not. -/

namespace CordonMirror

theorem le_of_eq {a b : Rat} (h : a = b) : a ≤ b := by grind

theorem lt_of_le_of_lt {a b c : Rat} (h : a ≤ b) (k : b < c) : a < c := by grind

theorem lt_of_lt_of_le {a b c : Rat} (h : a < b) (k : b ≤ c) : a < c := by grind

theorem mul_self_nonneg (a : Rat) : 0 ≤ a * a := by
  by_cases h : 0 ≤ a
  · exact Rat.mul_nonneg h h
  · have hn : 0 ≤ -a := by grind
    have hp : 0 ≤ -a * -a := Rat.mul_nonneg hn hn
    grind

theorem mul_neg_of_pos_of_neg {a b : Rat} (h : 0 < a) (k : b < 0) : a * b < 0 := by
  have hp : 0 < a * -b := Rat.mul_pos h (by grind)
  grind

theorem cast_add_one (i : Nat) : ((i + 1 : Nat) : Rat) = (i : Rat) + 1 := Rat.natCast_add i 1

theorem cast_add_two (i : Nat) : ((i + 2 : Nat) : Rat) = (i : Rat) + 2 := Rat.natCast_add i 2

/-- Archimedes: some natural number is greater. -/
theorem exists_nat_gt (x : Rat) : ∃ n : Nat, x < (n : Rat) := by
  have hf : x < ((x.floor + 1 : Int) : Rat) := Rat.lt_floor_add_one x
  have hn : x.floor + 1 ≤ ((x.floor + 1).toNat : Int) := by omega
  have hr : ((x.floor + 1 : Int) : Rat) ≤ (((x.floor + 1).toNat : Int) : Rat) :=
    Rat.intCast_le_intCast.mpr hn
  rw [Rat.intCast_natCast] at hr
  exact Exists.intro (x.floor + 1).toNat (lt_of_lt_of_le hf hr)

theorem pos_of_scaled (c x : Rat) (hc : 0 < c) (h : 0 < c * x) : 0 < x := by
  refine Classical.byContradiction fun hneg => ?_
  have hx : x ≤ 0 := Rat.not_lt.mp hneg
  have hp : 0 ≤ c * (-x) := Rat.mul_nonneg (Rat.le_of_lt hc) (by grind)
  grind

theorem zero_of_scaled (c x : Rat) (hc : 0 < c) (h : c * x = 0) : x = 0 := by
  have h2 : c = 0 ∨ x = 0 := Rat.mul_eq_zero.mp h
  cases h2 with
  | inl h0 =>
    exfalso
    grind
  | inr h0 => exact h0

theorem exists_inverse (c : Rat) (hc : 0 < c) : ∃ q : Rat, c * q = 1 := by
  have hne : c ≠ 0 := Ne.symm (Rat.ne_of_lt hc)
  exact Exists.intro c⁻¹ (Rat.mul_inv_cancel c hne)

theorem exists_quotient (c a : Rat) (hc : 0 < c) : ∃ d : Rat, c * d = a := by
  obtain ⟨q, hq⟩ := exists_inverse c hc
  have h : c * (q * a) = a := by
    have h1 : c * (q * a) = (c * q) * a := by grind
    rw [h1, hq]
    grind
  exact Exists.intro (q * a) h

theorem exists_half (a : Rat) (ha : 0 < a) : ∃ h : Rat, 0 < h ∧ h < a := by
  obtain ⟨q, hq⟩ := exists_quotient 2 a (by grind)
  have h0 : 0 < q := by grind
  have h1 : q < a := by grind
  exact Exists.intro q (And.intro h0 h1)

theorem cast_pos_of_pos (n : Nat) (hn : 0 < n) : (0 : Rat) < (n : Rat) := Rat.natCast_pos.mpr hn

theorem one_le_cast (n : Nat) (hn : 1 ≤ n) : (1 : Rat) ≤ (n : Rat) :=
  Rat.natCast_le_natCast.mpr hn

theorem cast_le_cast (m n : Nat) (h : m ≤ n) : (m : Rat) ≤ (n : Rat) :=
  Rat.natCast_le_natCast.mpr h

/-- Bernoulli's inequality, for the powers of a ratio up to 1. -/
theorem pow_bernoulli (r : Rat) (r0 : 0 ≤ r) (k : Nat) :
    r ^ k * (1 + (k : Rat) * (1 - r)) ≤ 1 := by
  induction k with
  | zero =>
    have h0 : ((0 : Nat) : Rat) = 0 := rfl
    have h1 : r ^ 0 = 1 := Rat.pow_zero r
    rw [h0, h1]
    grind
  | succ k ih =>
    have hc : ((k + 1 : Nat) : Rat) = (k : Rat) + 1 := cast_add_one k
    have hp : r ^ (k + 1) = r * r ^ k := by grind
    have hk : (0 : Rat) ≤ (k : Rat) := Rat.natCast_nonneg
    have hs : 0 ≤ (1 - r) * (1 - r) := mul_self_nonneg (1 - r)
    have hks : 0 ≤ ((k : Rat) + 1) * ((1 - r) * (1 - r)) := Rat.mul_nonneg (by grind) hs
    have hpow : 0 ≤ r ^ k := Rat.pow_nonneg r0
    have hall : 0 ≤ r ^ k * (((k : Rat) + 1) * ((1 - r) * (1 - r))) := Rat.mul_nonneg hpow hks
    have he : r * r ^ k * (1 + ((k : Rat) + 1) * (1 - r))
        = r ^ k * (1 + (k : Rat) * (1 - r))
          - r ^ k * (((k : Rat) + 1) * ((1 - r) * (1 - r))) := by
      grind
    rw [hc, hp, he]
    grind

/-- Powers of a ratio below 1 become small. -/
theorem pow_small (r A d : Rat) (r0 : 0 ≤ r) (r1 : r < 1) (hd : 0 < d) :
    ∃ K : Nat, ∀ k : Nat, K ≤ k → r ^ k * A < d := by
  obtain ⟨h, h0, h1⟩ := exists_half d hd
  have hr : 0 < (1 - r) * h := Rat.mul_pos (by grind) h0
  obtain ⟨q, hq⟩ := exists_inverse ((1 - r) * h) hr
  obtain ⟨K, hK⟩ := exists_nat_gt (A * q)
  refine Exists.intro K ?_
  intro k hk
  have hkK : (K : Rat) ≤ (k : Rat) := cast_le_cast K k hk
  have hg : 0 < (1 - r) * h * ((k : Rat) - A * q) := Rat.mul_pos hr (by grind)
  have he : (1 - r) * h * ((k : Rat) - A * q) = (1 - r) * h * (k : Rat) - A := by
    have h2 : (1 - r) * h * ((k : Rat) - A * q)
        = (1 - r) * h * (k : Rat) - ((1 - r) * h * q) * A := by
      grind
    rw [h2, hq]
    grind
  rw [he] at hg
  have hpow : 0 ≤ r ^ k := Rat.pow_nonneg r0
  have p1 : 0 ≤ r ^ k * ((1 - r) * h * (k : Rat) - A) := Rat.mul_nonneg hpow (Rat.le_of_lt hg)
  have hb : r ^ k * (1 + (k : Rat) * (1 - r)) ≤ 1 := pow_bernoulli r r0 k
  have p2 : 0 ≤ h * (1 - r ^ k * (1 + (k : Rat) * (1 - r))) :=
    Rat.mul_nonneg (Rat.le_of_lt h0) (by grind)
  have p3 : 0 ≤ r ^ k * h := Rat.mul_nonneg hpow (Rat.le_of_lt h0)
  have p4 : r ^ k * A = h
      - (h * (1 - r ^ k * (1 + (k : Rat) * (1 - r))) + r ^ k * h
        + r ^ k * ((1 - r) * h * (k : Rat) - A)) := by
    grind
  grind

end CordonMirror
