import Mathlib

/-! Facts of arithmetic that several theorems need, each closed by one tactic. -/

namespace CordonMirror

theorem pos_of_scaled (c x : Rat) (hc : 0 < c) (h : 0 < c * x) : 0 < x := by
  by_contra hneg
  have hx : x ≤ 0 := not_lt.mp hneg
  have hp : 0 ≤ c * (-x) := mul_nonneg (le_of_lt hc) (by linarith)
  linarith

theorem zero_of_scaled (c x : Rat) (hc : 0 < c) (h : c * x = 0) : x = 0 := by
  have h2 : c = 0 ∨ x = 0 := mul_eq_zero.mp h
  cases h2 with
  | inl h0 =>
    exfalso
    linarith
  | inr h0 => exact h0

theorem exists_inverse (c : Rat) (hc : 0 < c) : ∃ q : Rat, c * q = 1 := by
  have hne : c ≠ 0 := Ne.symm (ne_of_lt hc)
  exact Exists.intro c⁻¹ (mul_inv_cancel₀ hne)

theorem exists_quotient (c a : Rat) (hc : 0 < c) : ∃ d : Rat, c * d = a := by
  obtain ⟨q, hq⟩ := exists_inverse c hc
  have h : c * (q * a) = a := by
    have h1 : c * (q * a) = (c * q) * a := by ring
    rw [h1, hq]
    ring
  exact Exists.intro (q * a) h

theorem exists_half (a : Rat) (ha : 0 < a) : ∃ h : Rat, 0 < h ∧ h < a := by
  obtain ⟨q, hq⟩ := exists_quotient 2 a (by norm_num)
  have h0 : 0 < q := by linarith
  have h1 : q < a := by linarith
  exact Exists.intro q (And.intro h0 h1)

theorem cast_pos_of_pos (n : Nat) (hn : 0 < n) : (0 : Rat) < (n : Rat) := Nat.cast_pos.mpr hn

theorem one_le_cast (n : Nat) (hn : 1 ≤ n) : (1 : Rat) ≤ (n : Rat) := by
  exact_mod_cast hn

theorem cast_le_cast (m n : Nat) (h : m ≤ n) : (m : Rat) ≤ (n : Rat) := by
  exact_mod_cast h

/-- Bernoulli's inequality, for the powers of a ratio up to 1. -/
theorem pow_bernoulli (r : Rat) (r0 : 0 ≤ r) (k : Nat) :
    r ^ k * (1 + (k : Rat) * (1 - r)) ≤ 1 := by
  induction k with
  | zero =>
    have h0 : ((0 : Nat) : Rat) = 0 := Nat.cast_zero
    have h1 : r ^ 0 = 1 := pow_zero r
    rw [h0, h1]
    linarith
  | succ k ih =>
    have hc : ((k + 1 : Nat) : Rat) = (k : Rat) + 1 := Nat.cast_succ k
    have hp : r ^ (k + 1) = r * r ^ k := by ring
    have hk : (0 : Rat) ≤ (k : Rat) := Nat.cast_nonneg k
    have hs : 0 ≤ (1 - r) * (1 - r) := mul_self_nonneg (1 - r)
    have hks : 0 ≤ ((k : Rat) + 1) * ((1 - r) * (1 - r)) := mul_nonneg (by linarith) hs
    have hpow : 0 ≤ r ^ k := pow_nonneg r0 k
    have hall : 0 ≤ r ^ k * (((k : Rat) + 1) * ((1 - r) * (1 - r))) := mul_nonneg hpow hks
    have he : r * r ^ k * (1 + ((k : Rat) + 1) * (1 - r))
        = r ^ k * (1 + (k : Rat) * (1 - r))
          - r ^ k * (((k : Rat) + 1) * ((1 - r) * (1 - r))) := by
      ring
    rw [hc, hp, he]
    linarith

/-- Powers of a ratio below 1 become small. -/
theorem pow_small (r A d : Rat) (r0 : 0 ≤ r) (r1 : r < 1) (hd : 0 < d) :
    ∃ K : Nat, ∀ k : Nat, K ≤ k → r ^ k * A < d := by
  obtain ⟨h, h0, h1⟩ := exists_half d hd
  have hr : 0 < (1 - r) * h := mul_pos (by linarith) h0
  obtain ⟨q, hq⟩ := exists_inverse ((1 - r) * h) hr
  obtain ⟨K, hK⟩ := exists_nat_gt (A * q)
  refine Exists.intro K ?_
  intro k hk
  have hkK : (K : Rat) ≤ (k : Rat) := cast_le_cast K k hk
  have hg : 0 < (1 - r) * h * ((k : Rat) - A * q) := mul_pos hr (by linarith)
  have he : (1 - r) * h * ((k : Rat) - A * q) = (1 - r) * h * (k : Rat) - A := by
    have h2 : (1 - r) * h * ((k : Rat) - A * q)
        = (1 - r) * h * (k : Rat) - ((1 - r) * h * q) * A := by
      ring
    rw [h2, hq]
    ring
  rw [he] at hg
  have hpow : 0 ≤ r ^ k := pow_nonneg r0 k
  have p1 : 0 ≤ r ^ k * ((1 - r) * h * (k : Rat) - A) := mul_nonneg hpow (le_of_lt hg)
  have hb : r ^ k * (1 + (k : Rat) * (1 - r)) ≤ 1 := pow_bernoulli r r0 k
  have p2 : 0 ≤ h * (1 - r ^ k * (1 + (k : Rat) * (1 - r))) :=
    mul_nonneg (le_of_lt h0) (by linarith)
  have p3 : 0 ≤ r ^ k * h := mul_nonneg hpow (le_of_lt h0)
  have p4 : r ^ k * A = h
      - (h * (1 - r ^ k * (1 + (k : Rat) * (1 - r))) + r ^ k * h
        + r ^ k * ((1 - r) * h * (k : Rat) - A)) := by
    ring
  linarith

end CordonMirror
