import CordonMirror.Thm.LimitHalf

/-! Theorem 7.8 from `eps = 1/2` on, on error sequences, without a cosine. The vector
`w_0 = 0`, `w_1 = 1`, `eps (w_i + w_{i+2}) = (2 - 2 eps) w_{i+1}` satisfies `|A| w = w`; its
members are the leading minors of `below_critical`, scaled. If `w_1 .. w_{N-1}` are positive then
bounds `|e_i| ≤ C w_i` persist and shrink every `N-2` steps; if one of them is not, errors of
alternating sign and size `w_i` never shrink. -/

namespace CordonMirror

/-- With `t = (2 - 2 eps) / eps`: the vector `w`. -/
def wave (t : Rat) : Nat → Rat
  | 0 => 0
  | 1 => 1
  | i + 2 => t * wave t (i + 1) - wave t i

theorem wave_next (t : Rat) (i : Nat) : wave t (i + 2) = t * wave t (i + 1) - wave t i := by
  rw [wave]

theorem wave_balance (e t : Rat) (ht : e * t = 2 - 2 * e) (i : Nat) :
    e * (wave t i + wave t (i + 2)) = (2 - 2 * e) * wave t (i + 1) := by
  have h : e * t * wave t (i + 1) = (2 - 2 * e) * wave t (i + 1) :=
    congrArg (fun x => x * wave t (i + 1)) ht
  rw [wave_next]
  grind

/-! ### The minors of `below_critical` -/

theorem minors_wave (e t : Rat) (ht : e * t = 2 - 2 * e) (k : Nat) :
    e * (minors (2 * 1 - 2 * e) (e * e) k).1 = e ^ k * wave t k ∧
    (minors (2 * 1 - 2 * e) (e * e) k).2 = e ^ k * wave t (k + 1) := by
  induction k with
  | zero =>
    have h1 : e ^ 0 = 1 := Rat.pow_zero _
    have w0 : wave t 0 = 0 := rfl
    have w1 : wave t 1 = 1 := rfl
    have m1 : (minors (2 * 1 - 2 * e) (e * e) 0).1 = 0 := rfl
    have m2 : (minors (2 * 1 - 2 * e) (e * e) 0).2 = 1 := rfl
    rw [h1, w0, w1, m1, m2]
    exact And.intro (by grind) (by grind)
  | succ k ih =>
    have m1 : (minors (2 * 1 - 2 * e) (e * e) (k + 1)).1
        = (minors (2 * 1 - 2 * e) (e * e) k).2 := rfl
    have m2 : (minors (2 * 1 - 2 * e) (e * e) (k + 1)).2
        = (2 * 1 - 2 * e) * (minors (2 * 1 - 2 * e) (e * e) k).2
          - e * e * (minors (2 * 1 - 2 * e) (e * e) k).1 := rfl
    have hp : e ^ (k + 1) = e ^ k * e := Rat.pow_succ e k
    have hb : e ^ k * (e * (wave t k + wave t (k + 2)))
        = e ^ k * ((2 - 2 * e) * wave t (k + 1)) :=
      congrArg (fun x => e ^ k * x) (wave_balance e t ht k)
    have h1 : e * (e * (minors (2 * 1 - 2 * e) (e * e) k).1) = e * (e ^ k * wave t k) :=
      congrArg (fun x => e * x) ih.1
    have h2 : (2 - 2 * e) * (minors (2 * 1 - 2 * e) (e * e) k).2
        = (2 - 2 * e) * (e ^ k * wave t (k + 1)) :=
      congrArg (fun x => (2 - 2 * e) * x) ih.2
    rw [m1, m2, hp]
    refine And.intro ?_ ?_
    · rw [ih.2]
      grind
    · grind

theorem below_critical_wave (e t : Rat) (N : Nat) (e0 : 0 < e) (ht : e * t = 2 - 2 * e) :
    below_critical e 1 N ↔ ∀ i : Nat, 1 ≤ i → i ≤ N - 1 → 0 < wave t i := by
  have w1 : wave t 1 = 1 := rfl
  constructor
  · intro h i h1 hi
    by_cases hone : i = 1
    · rw [hone, w1]
      grind
    · obtain ⟨k, hk⟩ : ∃ k : Nat, i = k + 1 := ⟨i - 1, by omega⟩
      subst hk
      have hm : 0 < (minors (2 * 1 - 2 * e) (e * e) k).2 := h k (by omega) (by omega)
      rw [(minors_wave e t ht k).2] at hm
      exact pos_of_scaled (e ^ k) (wave t (k + 1)) (Rat.pow_pos e0) hm
  · intro h k h1 hk
    have hm : (minors (2 * 1 - 2 * e) (e * e) k).2 = e ^ k * wave t (k + 1) :=
      (minors_wave e t ht k).2
    rw [hm]
    exact Rat.mul_pos (Rat.pow_pos e0) (h (k + 1) (by omega) (by omega))

/-- Up to `eps = 1/2` the vector grows, so that no minor fails. -/
theorem wave_grows (e t : Rat) (e0 : 0 < e) (e1 : 2 * e ≤ 1) (ht : e * t = 2 - 2 * e) (i : Nat) :
    0 < wave t (i + 1) ∧ 0 ≤ wave t (i + 1) - wave t i := by
  induction i with
  | zero =>
    have w0 : wave t 0 = 0 := rfl
    have w1 : wave t (0 + 1) = 1 := rfl
    rw [w0, w1]
    exact And.intro (by grind) (by grind)
  | succ i ih =>
    have hb : e * (wave t i + wave t (i + 2)) = (2 - 2 * e) * wave t (i + 1) :=
      wave_balance e t ht i
    have p1 : 0 ≤ (2 - 4 * e) * wave t (i + 1) :=
      Rat.mul_nonneg (by grind) (Rat.le_of_lt ih.1)
    have p2 : 0 ≤ e * (wave t (i + 1) - wave t i) := Rat.mul_nonneg (Rat.le_of_lt e0) ih.2
    have hd : 0 ≤ wave t (i + 2) - wave t (i + 1) := by
      refine Classical.byContradiction fun hneg => ?_
      have hlt : wave t (i + 2) - wave t (i + 1) < 0 := Rat.not_le.mp hneg
      have hp : e * (wave t (i + 2) - wave t (i + 1)) < 0 := mul_neg_of_pos_of_neg e0 hlt
      grind
    exact And.intro (by grind) hd

/-! ### Below the critical weight -/

/-- Every position of `x` within `C` times the vector. -/
def Within (M : Nat) (t C : Rat) (x : Nat → Rat) : Prop :=
  ∀ i : Nat, i ≤ M → x i ≤ C * wave t i ∧ -x i ≤ C * wave t i

/-- One row of a step: a margin `m` on the right is a margin `e m` after it. -/
theorem margin_row (e C a b c m u v w : Rat) (e0 : 0 ≤ e) (e1 : 1 ≤ 2 * e)
    (hb : e * (u + w) = (2 - 2 * e) * v) (ha : a ≤ C * u) (hv : -b ≤ C * v)
    (hc : c + m ≤ C * w) : e * a + (1 - 2 * e) * b + e * c + e * m ≤ C * v := by
  have p1 : 0 ≤ e * (C * u - a) := Rat.mul_nonneg e0 (by grind)
  have p2 : 0 ≤ (2 * e - 1) * (C * v + b) := Rat.mul_nonneg (by grind) (by grind)
  have p3 : 0 ≤ e * (C * w - c - m) := Rat.mul_nonneg e0 (by grind)
  have p4 : C * (e * (u + w)) = C * ((2 - 2 * e) * v) := congrArg (fun x => C * x) hb
  grind

theorem within_step (M : Nat) (e t C : Rat) (e0 : 0 ≤ e) (e1 : 1 ≤ 2 * e)
    (ht : e * t = 2 - 2 * e) (x y : Nat → Rat) (h : Step M e x y) (hx : Within M t C x) :
    Within M t C y := by
  intro i hi
  by_cases hl : i = M
  · rw [hl, h.right_end]
    exact hx M (Nat.le_refl M)
  · by_cases h0 : i = 0
    · rw [h0, h.left_end]
      exact hx 0 (Nat.zero_le M)
    · obtain ⟨j, hj⟩ : ∃ j : Nat, i = j + 1 := ⟨i - 1, by omega⟩
      subst hj
      have hy : y (j + 1) = e * x j + (1 - 2 * e) * x (j + 1) + e * x (j + 2) :=
        h.inner j (by omega)
      have b0 := hx j (by omega)
      have b1 := hx (j + 1) (by omega)
      have b2 := hx (j + 2) (by omega)
      have hw := wave_balance e t ht j
      have up := margin_row e C (x j) (x (j + 1)) (x (j + 2)) 0 (wave t j) (wave t (j + 1))
        (wave t (j + 2)) e0 e1 hw b0.1 b1.2 (by grind)
      have lo := margin_row e C (-x j) (-x (j + 1)) (-x (j + 2)) 0 (wave t j) (wave t (j + 1))
        (wave t (j + 2)) e0 e1 hw b0.2 (by grind) (by grind)
      rw [hy]
      exact And.intro (by grind) (by grind)

theorem within_run (M : Nat) (e t C : Rat) (e0 : 0 ≤ e) (e1 : 1 ≤ 2 * e)
    (ht : e * t = 2 - 2 * e) (E : Nat → Nat → Rat) (hE : Run M e E) (k : Nat)
    (hk : Within M t C (E k)) (h : Nat) : Within M t C (E (k + h)) := by
  induction h with
  | zero => exact hk
  | succ h ih => exact within_step M e t C e0 e1 ht (E (k + h)) (E (k + h + 1)) (hE (k + h)) ih

/-- The margin at the last drone, whose error is 0, travels inwards one drone a step. -/
theorem margin_run (M : Nat) (e t C : Rat) (e0 : 0 ≤ e) (e1 : 1 ≤ 2 * e)
    (ht : e * t = 2 - 2 * e) (E : Nat → Nat → Rat) (hE : Run M e E) (k : Nat)
    (hM : ∀ l : Nat, E l M = 0) (hk : Within M t C (E k)) (h : Nat) :
    ∀ i : Nat, 1 ≤ i → i ≤ M → M ≤ i + h →
      E (k + h) i + C * (e ^ (M - i) * wave t M) ≤ C * wave t i ∧
      -E (k + h) i + C * (e ^ (M - i) * wave t M) ≤ C * wave t i := by
  have last : ∀ l : Nat, E l M + C * (e ^ (M - M) * wave t M) ≤ C * wave t M ∧
      -E l M + C * (e ^ (M - M) * wave t M) ≤ C * wave t M := by
    intro l
    have hz : M - M = 0 := Nat.sub_self M
    have h1 : e ^ 0 = 1 := Rat.pow_zero _
    rw [hM l, hz, h1]
    exact And.intro (by grind) (by grind)
  induction h with
  | zero =>
    intro i h1 hi hh
    have he : i = M := by omega
    rw [he]
    exact last (k + 0)
  | succ h ih =>
    intro i h1 hi hh
    by_cases hl : i = M
    · rw [hl]
      exact last (k + (h + 1))
    · obtain ⟨j, hj⟩ : ∃ j : Nat, i = j + 1 := ⟨i - 1, by omega⟩
      subst hj
      have hy : E (k + h + 1) (j + 1)
          = e * E (k + h) j + (1 - 2 * e) * E (k + h) (j + 1) + e * E (k + h) (j + 2) :=
        (hE (k + h)).inner j (by omega)
      have hb : Within M t C (E (k + h)) := within_run M e t C e0 e1 ht E hE k hk h
      have b0 := hb j (by omega)
      have b1 := hb (j + 1) (by omega)
      have b2 := ih (j + 2) (by omega) (by omega) (by omega)
      have hs : M - (j + 1) = M - (j + 2) + 1 := by omega
      have hp : e ^ (M - (j + 1)) = e ^ (M - (j + 2)) * e := by
        rw [hs]
        exact Rat.pow_succ e (M - (j + 2))
      have hw := wave_balance e t ht j
      have up := margin_row e C (E (k + h) j) (E (k + h) (j + 1)) (E (k + h) (j + 2))
        (C * (e ^ (M - (j + 2)) * wave t M)) (wave t j) (wave t (j + 1)) (wave t (j + 2))
        e0 e1 hw b0.1 b1.2 b2.1
      have lo := margin_row e C (-E (k + h) j) (-E (k + h) (j + 1)) (-E (k + h) (j + 2))
        (C * (e ^ (M - (j + 2)) * wave t M)) (wave t j) (wave t (j + 1)) (wave t (j + 2))
        e0 e1 hw b0.2 (by grind) b2.2
      have hk1 : k + (h + 1) = k + h + 1 := rfl
      rw [hk1, hy, hp]
      exact And.intro (by grind) (by grind)

theorem pow_le_one (e : Rat) (e0 : 0 ≤ e) (e1 : e ≤ 1) (n : Nat) : e ^ n ≤ 1 := by
  induction n with
  | zero =>
    have h1 : e ^ 0 = 1 := Rat.pow_zero _
    grind
  | succ n ih =>
    have hp : e ^ (n + 1) = e ^ n * e := Rat.pow_succ e n
    have hn : 0 ≤ e ^ n := Rat.pow_nonneg e0
    have h2 : 0 ≤ e ^ n * (1 - e) := Rat.mul_nonneg hn (by grind)
    grind

/-- Powers fall as their exponents grow. -/
theorem pow_antitone (e : Rat) (e0 : 0 ≤ e) (e1 : e ≤ 1) (m n : Nat) : e ^ (m + n) ≤ e ^ m := by
  induction n with
  | zero => exact Rat.le_refl
  | succ n ih =>
    have hp : e ^ (m + (n + 1)) = e ^ (m + n) * e := Rat.pow_succ e (m + n)
    have hn : 0 ≤ e ^ (m + n) := Rat.pow_nonneg e0
    have h2 : 0 ≤ e ^ (m + n) * (1 - e) := Rat.mul_nonneg hn (by grind)
    grind

/-- The part of the vector by which bounds shrink. -/
theorem exists_shrink (M : Nat) (e t : Rat) (e0 : 0 < e) (e1 : e ≤ 1)
    (hM : 1 ≤ M) (hpos : ∀ i : Nat, 1 ≤ i → i ≤ M → 0 < wave t i) :
    ∃ q : Rat, 0 < q ∧ q ≤ 1 ∧
      ∀ i : Nat, 1 ≤ i → i ≤ M → q * wave t i ≤ e ^ (M - i) * wave t M := by
  obtain ⟨B, hB, hb⟩ := exists_bound (wave t) (M + 1)
  have wM : 0 < wave t M := hpos M hM (Nat.le_refl M)
  have pM : 0 < e ^ M := Rat.pow_pos e0
  have hnum : 0 < e ^ M * wave t M := Rat.mul_pos pM wM
  have bM : wave t M ≤ B := (hb M (by omega)).1
  have B0 : 0 < B := by grind
  obtain ⟨q, hq⟩ := exists_quotient B (e ^ M * wave t M) B0
  have q0 : 0 < q := pos_of_scaled B q B0 (by grind)
  refine Exists.intro q (And.intro q0 (And.intro ?_ ?_))
  · have h1 : 0 ≤ (1 - e ^ M) * wave t M :=
      Rat.mul_nonneg (by have h := pow_le_one e (Rat.le_of_lt e0) e1 M; grind) (Rat.le_of_lt wM)
    have h2 : 0 ≤ B * (1 - q) := by grind
    refine Classical.byContradiction fun hneg => ?_
    have h3 : 1 - q < 0 := by grind
    have h4 : B * (1 - q) < 0 := mul_neg_of_pos_of_neg B0 h3
    grind
  · intro i h1 hi
    have h2 : 0 ≤ q * (B - wave t i) :=
      Rat.mul_nonneg (Rat.le_of_lt q0) (by have h := (hb i (by omega)).1; grind)
    have hs : M - i + i = M := by omega
    have h3 : e ^ M ≤ e ^ (M - i) := by
      have h := pow_antitone e (Rat.le_of_lt e0) e1 (M - i) i
      rw [hs] at h
      exact h
    have h4 : 0 ≤ (e ^ (M - i) - e ^ M) * wave t M :=
      Rat.mul_nonneg (by grind) (Rat.le_of_lt wM)
    grind

/-- Bounds shrink by `1 - q` every `M` steps. -/
theorem within_shrinks (M : Nat) (e t C q : Rat) (e0 : 0 < e) (e1 : 1 ≤ 2 * e)
    (ht : e * t = 2 - 2 * e) (hC : 0 ≤ C) (E : Nat → Nat → Rat) (hE : Run M e E)
    (h0 : ∀ l : Nat, E l 0 = 0) (hM : ∀ l : Nat, E l M = 0)
    (hq : ∀ i : Nat, 1 ≤ i → i ≤ M → q * wave t i ≤ e ^ (M - i) * wave t M) (k : Nat)
    (hk : Within M t C (E k)) : Within M t ((1 - q) * C) (E (k + M)) := by
  intro i hi
  by_cases hz : i = 0
  · have w0 : wave t 0 = 0 := rfl
    rw [hz, h0, w0]
    exact And.intro (by grind) (by grind)
  · have hm := margin_run M e t C (Rat.le_of_lt e0) e1 ht E hE k hM hk M i (by omega) hi (by omega)
    have hp : C * (q * wave t i) ≤ C * (e ^ (M - i) * wave t M) :=
      Rat.mul_le_mul_of_nonneg_left (hq i (by omega) hi) hC
    exact And.intro (by grind) (by grind)

/-- Finitely many numbers are within a multiple of the vector where it is positive. -/
theorem exists_within (t : Rat) (x : Nat → Rat) (n : Nat) :
    ∃ C : Rat, 0 ≤ C ∧ ∀ i : Nat, i < n → 0 < wave t i →
      x i ≤ C * wave t i ∧ -x i ≤ C * wave t i := by
  induction n with
  | zero =>
    refine Exists.intro 0 (And.intro Rat.le_refl ?_)
    intro i hi
    exact absurd hi (Nat.not_lt_zero i)
  | succ n ih =>
    obtain ⟨C, hC, hb⟩ := ih
    by_cases hw : 0 < wave t n
    · obtain ⟨B, hB, hx⟩ := exists_bound x (n + 1)
      obtain ⟨D, hD⟩ := exists_quotient (wave t n) B hw
      have xb := hx n (by omega)
      have D0 : 0 ≤ D := by
        refine Classical.byContradiction fun hneg => ?_
        have h : wave t n * D < 0 := mul_neg_of_pos_of_neg hw (Rat.not_le.mp hneg)
        grind
      refine Exists.intro (C + D) (And.intro (by grind) ?_)
      intro i hi hwi
      by_cases hl : i = n
      · subst hl
        have p : 0 ≤ C * wave t i := Rat.mul_nonneg hC (Rat.le_of_lt hwi)
        exact And.intro (by grind) (by grind)
      · have h := hb i (by omega) hwi
        have p : 0 ≤ D * wave t i := Rat.mul_nonneg D0 (Rat.le_of_lt hwi)
        exact And.intro (by grind) (by grind)
    · refine Exists.intro C (And.intro hC ?_)
      intro i hi hwi
      by_cases hl : i = n
      · subst hl
        exact absurd hwi hw
      · exact hb i (by omega) hwi

/-- From `eps = 1/2` on, below the critical weight, errors become and stay small. -/
theorem errors_vanish (M : Nat) (e t d : Rat) (hM : 1 ≤ M) (e0 : 0 < e) (e1 : 1 ≤ 2 * e)
    (e2 : e ≤ 1) (ht : e * t = 2 - 2 * e) (hd : 0 < d)
    (hpos : ∀ i : Nat, 1 ≤ i → i ≤ M → 0 < wave t i) (E : Nat → Nat → Rat) (hE : Run M e E)
    (E0 : E 0 0 = 0) (EM : E 0 M = 0) (i : Nat) (hi : i ≤ M) :
    ∃ K : Nat, ∀ k : Nat, K ≤ k → E k i < d ∧ -E k i < d := by
  have z0 : ∀ l : Nat, E l 0 = 0 := fun l => Eq.trans (Run.ends hE l).1 E0
  have zM : ∀ l : Nat, E l M = 0 := fun l => Eq.trans (Run.ends hE l).2 EM
  obtain ⟨q, q0, q1, hq⟩ := exists_shrink M e t e0 e2 hM hpos
  obtain ⟨C, hC, hb⟩ := exists_within t (E 0) (M + 1)
  have hstart : Within M t C (E 0) := by
    intro j hj
    by_cases h0 : j = 0
    · have w0 : wave t 0 = 0 := rfl
      rw [h0, E0, w0]
      exact And.intro (by grind) (by grind)
    · exact hb j (by omega) (hpos j (by omega) hj)
  have hblock : ∀ n : Nat, Within M t ((1 - q) ^ n * C) (E (n * M)) := by
    intro n
    induction n with
    | zero =>
      have h1 : (1 - q) ^ 0 = 1 := Rat.pow_zero _
      have hz : 0 * M = 0 := Nat.zero_mul M
      have hc : 1 * C = C := by grind
      rw [h1, hz, hc]
      exact hstart
    | succ n ih =>
      have hn : 0 ≤ (1 - q) ^ n * C := Rat.mul_nonneg (Rat.pow_nonneg (by grind)) hC
      have hp : (1 - q) ^ (n + 1) * C = (1 - q) * ((1 - q) ^ n * C) := by
        have h : (1 - q) ^ (n + 1) = (1 - q) ^ n * (1 - q) := Rat.pow_succ (1 - q) n
        rw [h]
        grind
      have hm : (n + 1) * M = n * M + M := Nat.succ_mul n M
      rw [hp, hm]
      exact within_shrinks M e t ((1 - q) ^ n * C) q e0 e1 ht hn E hE z0 zM hq (n * M) ih
  obtain ⟨n, hn⟩ := pow_small (1 - q) (C * wave t i) d (by grind) (by grind) hd
  refine Exists.intro (n * M) ?_
  intro k hk
  obtain ⟨h, hh⟩ : ∃ h : Nat, k = n * M + h := ⟨k - n * M, by omega⟩
  have hw := within_run M e t ((1 - q) ^ n * C) (Rat.le_of_lt e0) e1 ht E hE (n * M) (hblock n) h
    i hi
  have hs : (1 - q) ^ n * (C * wave t i) < d := hn n (Nat.le_refl n)
  rw [hh]
  exact And.intro (by grind) (by grind)

/-! ### From the critical weight on -/

/-- `(-1)^n`. -/
def sign : Nat → Rat
  | 0 => 1
  | n + 1 => -sign n

theorem sign_square (n : Nat) : sign n * sign n = 1 := by
  induction n with
  | zero =>
    have h : sign 0 = 1 := rfl
    rw [h]
    grind
  | succ n ih =>
    have h : sign (n + 1) = -sign n := rfl
    rw [h]
    grind

/-- Errors of alternating sign grow under a weight that is not positive. -/
theorem alternating_grows (M : Nat) (e : Rat) (e0 : e ≤ 0) (E : Nat → Nat → Rat)
    (hE : Run M e E) (E0 : E 0 0 = 0) (EM : E 0 M = 0)
    (hstart : ∀ i : Nat, 0 < i → i < M → 1 ≤ sign i * E 0 i) (k : Nat) :
    ∀ i : Nat, 0 < i → i < M → 1 ≤ sign i * E k i := by
  induction k with
  | zero => exact hstart
  | succ k ih =>
    intro i h0 hi
    obtain ⟨j, hj⟩ : ∃ j : Nat, i = j + 1 := ⟨i - 1, by omega⟩
    subst hj
    have hy : E (k + 1) (j + 1) = e * E k j + (1 - 2 * e) * E k (j + 1) + e * E k (j + 2) :=
      (hE k).inner j hi
    have z0 : E k 0 = 0 := Eq.trans (Run.ends hE k).1 E0
    have zM : E k M = 0 := Eq.trans (Run.ends hE k).2 EM
    have s1 : sign (j + 1) = -sign j := rfl
    have s2 : sign (j + 2) = -sign (j + 1) := rfl
    have a0 : 0 ≤ sign j * E k j := by
      by_cases hz : j = 0
      · rw [hz, z0]
        grind
      · have h := ih j (by omega) (by omega)
        grind
    have a1 : 1 ≤ sign (j + 1) * E k (j + 1) := ih (j + 1) h0 hi
    have a2 : 0 ≤ sign (j + 2) * E k (j + 2) := by
      by_cases hz : j + 2 = M
      · rw [hz, zM]
        grind
      · have h := ih (j + 2) (by omega) (by omega)
        grind
    have p0 : 0 ≤ -e * (sign j * E k j) := Rat.mul_nonneg (by grind) a0
    have p1 : 0 ≤ (1 - 2 * e) * (sign (j + 1) * E k (j + 1) - 1) :=
      Rat.mul_nonneg (by grind) (by grind)
    have p2 : 0 ≤ -e * (sign (j + 2) * E k (j + 2)) := Rat.mul_nonneg (by grind) a2
    have s3 : sign (j + 2) = sign j := by grind
    rw [s1] at p1
    rw [s3] at p2
    rw [hy, s1]
    clear ih hstart
    grind

/-- If `w_{n+1} ≤ 0`, errors of alternating sign and size `w_i` up to `n`, and 0 behind, never
shrink. -/
theorem alternating_stays (M n : Nat) (e t : Rat) (e0 : 0 ≤ e) (e1 : 1 ≤ 2 * e)
    (ht : e * t = 2 - 2 * e) (hn : n + 1 ≤ M) (hw : wave t (n + 1) ≤ 0) (E : Nat → Nat → Rat)
    (hE : Run M e E) (E0 : E 0 0 = 0) (EM : E 0 M = 0)
    (hnonneg : ∀ i : Nat, i ≤ M → 0 ≤ sign i * E 0 i)
    (hstart : ∀ i : Nat, i ≤ n → wave t i ≤ sign i * E 0 i) (k : Nat) :
    (∀ i : Nat, i ≤ M → 0 ≤ sign (i + k) * E k i) ∧
    ∀ i : Nat, i ≤ n → wave t i ≤ sign (i + k) * E k i := by
  induction k with
  | zero => exact And.intro hnonneg hstart
  | succ k ih =>
    have z0 : E k 0 = 0 := Eq.trans (Run.ends hE k).1 E0
    have zM : E k M = 0 := Eq.trans (Run.ends hE k).2 EM
    -- One row, in signed errors: all coefficients are nonnegative.
    have row : ∀ j : Nat, j + 1 < M → sign (j + 1 + (k + 1)) * E (k + 1) (j + 1)
        = e * (sign (j + k) * E k j) + (2 * e - 1) * (sign (j + 1 + k) * E k (j + 1))
          + e * (sign (j + 2 + k) * E k (j + 2)) := by
      intro j hj
      have hy : E (k + 1) (j + 1) = e * E k j + (1 - 2 * e) * E k (j + 1) + e * E k (j + 2) :=
        (hE k).inner j hj
      have n1 : j + 1 + k = j + k + 1 := by omega
      have n2 : j + 2 + k = j + k + 1 + 1 := by omega
      have n3 : j + 1 + (k + 1) = j + k + 1 + 1 := by omega
      have s1 : sign (j + k + 1) = -sign (j + k) := rfl
      have s2 : sign (j + k + 1 + 1) = -sign (j + k + 1) := rfl
      rw [n1, n2, n3, s2, s1, hy]
      grind
    have wide : ∀ i : Nat, i ≤ n + 1 → wave t i ≤ sign (i + k) * E k i := by
      intro i hi
      by_cases hl : i = n + 1
      · have h := ih.1 i (by omega)
        rw [hl] at h
        rw [hl]
        grind
      · exact ih.2 i (by omega)
    refine And.intro ?_ ?_
    · intro i hi
      by_cases hl : i = M
      · have zl : E (k + 1) M = 0 := Eq.trans (Run.ends hE (k + 1)).2 EM
        rw [hl, zl]
        grind
      · by_cases hz : i = 0
        · have zf : E (k + 1) 0 = 0 := Eq.trans (Run.ends hE (k + 1)).1 E0
          rw [hz, zf]
          grind
        · obtain ⟨j, hj⟩ : ∃ j : Nat, i = j + 1 := ⟨i - 1, by omega⟩
          subst hj
          have p0 : 0 ≤ e * (sign (j + k) * E k j) := Rat.mul_nonneg e0 (ih.1 j (by omega))
          have p1 : 0 ≤ (2 * e - 1) * (sign (j + 1 + k) * E k (j + 1)) :=
            Rat.mul_nonneg (by grind) (ih.1 (j + 1) hi)
          have p2 : 0 ≤ e * (sign (j + 2 + k) * E k (j + 2)) :=
            Rat.mul_nonneg e0 (ih.1 (j + 2) (by omega))
          rw [row j (by omega)]
          grind
    · intro i hi
      by_cases hz : i = 0
      · have zf : E (k + 1) 0 = 0 := Eq.trans (Run.ends hE (k + 1)).1 E0
        have w0 : wave t 0 = 0 := rfl
        rw [hz, zf, w0]
        grind
      · obtain ⟨j, hj⟩ : ∃ j : Nat, i = j + 1 := ⟨i - 1, by omega⟩
        subst hj
        have p0 : 0 ≤ e * (sign (j + k) * E k j - wave t j) :=
          Rat.mul_nonneg e0 (by have h := wide j (by omega); grind)
        have p1 : 0 ≤ (2 * e - 1) * (sign (j + 1 + k) * E k (j + 1) - wave t (j + 1)) :=
          Rat.mul_nonneg (by grind) (by have h := wide (j + 1) (by omega); grind)
        have p2 : 0 ≤ e * (sign (j + 2 + k) * E k (j + 2) - wave t (j + 2)) :=
          Rat.mul_nonneg e0 (by have h := wide (j + 2) (by omega); grind)
        have hb := wave_balance e t ht j
        rw [row j (by omega)]
        grind

end CordonMirror
