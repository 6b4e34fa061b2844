import CordonMirror.Thm.Dynamics

/-! Theorem 7.2, invariant spatial ordering, in its sharp form. -/

namespace CordonMirror

theorem convex_pos_2 (a g h : Rat) (a0 : 0 ≤ a) (a1 : a ≤ 1) (hg : 0 < g) (hh : 0 < h) :
    0 < (1 - a) * g + a * h := by
  by_cases hc : a < 1
  · have p1 : 0 < (1 - a) * g := Rat.mul_pos (by grind) hg
    have p2 : 0 ≤ a * h := Rat.mul_nonneg a0 (Rat.le_of_lt hh)
    grind
  · have h1 : 1 ≤ a := Rat.not_lt.mp hc
    have p1 : 0 ≤ (1 - a) * g := Rat.mul_nonneg (by grind) (Rat.le_of_lt hg)
    have p2 : 0 < a * h := Rat.mul_pos (by grind) hh
    grind

theorem convex_pos_3 (a b f g h : Rat) (a0 : 0 ≤ a) (b0 : 0 ≤ b) (ab : a + b ≤ 1)
    (hf : 0 < f) (hg : 0 < g) (hh : 0 < h) :
    0 < a * f + (1 - a - b) * g + b * h := by
  have p1 : 0 ≤ a * f := Rat.mul_nonneg a0 (Rat.le_of_lt hf)
  have p2 : 0 ≤ (1 - a - b) * g := Rat.mul_nonneg (by grind) (Rat.le_of_lt hg)
  have p3 : 0 ≤ b * h := Rat.mul_nonneg b0 (Rat.le_of_lt hh)
  by_cases ha : 0 < a
  · have q : 0 < a * f := Rat.mul_pos ha hf
    grind
  · by_cases hb : 0 < b
    · have q : 0 < b * h := Rat.mul_pos hb hh
      grind
    · have a1 : a ≤ 0 := Rat.not_lt.mp ha
      have b1 : b ≤ 0 := Rat.not_lt.mp hb
      have q : 0 < (1 - a - b) * g := Rat.mul_pos (by grind) hg
      grind

/-- Each new gap is a convex combination of old ones as soon as the weights of two
neighbours add up to at most 1. -/
theorem ordering_weighted (M : Nat) (hM : 2 ≤ M) (a x y : Nat → Rat) (hw : Weighted M a x y)
    (ha0 : ∀ i : Nat, 0 < i → i < M → 0 ≤ a i)
    (ha1 : ∀ i : Nat, 0 < i → i < M → a i ≤ 1)
    (haa : ∀ i : Nat, 0 < i → i + 1 < M → a i + a (i + 1) ≤ 1)
    (hx : ∀ i : Nat, i < M → x i < x (i + 1)) :
    ∀ i : Nat, i < M → y i < y (i + 1) := by
  intro i hi
  by_cases h0 : i = 0
  · subst h0
    have y0 : y 0 = x 0 := hw.left_end
    have y1 : y 1 = x 1 + a 1 * (x 0 - 2 * x 1 + x 2) := hw.inner 0 (by omega)
    have g0 : x 0 < x 1 := hx 0 (by omega)
    have g1 : x 1 < x 2 := hx 1 (by omega)
    have c : 0 < (1 - a 1) * (x 1 - x 0) + a 1 * (x 2 - x 1) :=
      convex_pos_2 (a 1) (x 1 - x 0) (x 2 - x 1)
        (ha0 1 (by omega) (by omega)) (ha1 1 (by omega) (by omega))
        (by grind) (by grind)
    show y 0 < y 1
    rw [y0, y1]
    grind
  · obtain ⟨j, hj⟩ : ∃ j : Nat, i = j + 1 := ⟨i - 1, by omega⟩
    subst hj
    have y1 : y (j + 1) = x (j + 1) + a (j + 1) * (x j - 2 * x (j + 1) + x (j + 2)) :=
      hw.inner j (by omega)
    have g0 : x j < x (j + 1) := hx j (by omega)
    have g1 : x (j + 1) < x (j + 2) := hx (j + 1) (by omega)
    have p0 : 0 ≤ a (j + 1) := ha0 (j + 1) (by omega) (by omega)
    have p1 : a (j + 1) ≤ 1 := ha1 (j + 1) (by omega) (by omega)
    by_cases hl : j + 2 = M
    · have y2 : y (j + 2) = x (j + 2) := by
        rw [hl]
        exact hw.right_end
      have c : 0 < (1 - a (j + 1)) * (x (j + 2) - x (j + 1)) + a (j + 1) * (x (j + 1) - x j) :=
        convex_pos_2 (a (j + 1)) (x (j + 2) - x (j + 1)) (x (j + 1) - x j) p0 p1
          (by grind) (by grind)
      show y (j + 1) < y (j + 2)
      rw [y1, y2]
      grind
    · have y2 : y (j + 2)
          = x (j + 2) + a (j + 2) * (x (j + 1) - 2 * x (j + 2) + x (j + 3)) :=
        hw.inner (j + 1) (by omega)
      have g2 : x (j + 2) < x (j + 3) := hx (j + 2) (by omega)
      have q0 : 0 ≤ a (j + 2) := ha0 (j + 2) (by omega) (by omega)
      have pq : a (j + 1) + a (j + 2) ≤ 1 := haa (j + 1) (by omega) (by omega)
      have c : 0 < a (j + 1) * (x (j + 1) - x j)
          + (1 - a (j + 1) - a (j + 2)) * (x (j + 2) - x (j + 1))
          + a (j + 2) * (x (j + 3) - x (j + 2)) :=
        convex_pos_3 (a (j + 1)) (a (j + 2)) (x (j + 1) - x j) (x (j + 2) - x (j + 1))
          (x (j + 3) - x (j + 2)) p0 q0 pq (by grind) (by grind) (by grind)
      show y (j + 1) < y (j + 2)
      rw [y1, y2]
      grind

theorem ordering_run (M : Nat) (e : Rat) (X : Nat → Nat → Rat) (hM : 2 ≤ M)
    (e0 : 0 ≤ e) (e1 : e ≤ 1) (e2 : 2 * e ≤ 1 ∨ M = 2) (hX : Run M e X)
    (h0 : ∀ i : Nat, i < M → X 0 i < X 0 (i + 1)) :
    ∀ k i : Nat, i < M → X k i < X k (i + 1) := by
  intro k
  induction k with
  | zero => exact h0
  | succ k ih =>
    refine ordering_weighted M hM (fun _ => e) (X k) (X (k + 1)) (Step.weighted (hX k))
      (fun _ _ _ => e0) (fun _ _ _ => e1) ?_ ih
    intro i hi hiM
    show e + e ≤ 1
    cases e2 with
    | inl h => grind
    | inr h => exact absurd hiM (by omega)

theorem ordering_general (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : p.eps ≤ 1)
    (e2 : 2 * p.eps ≤ 1 ∨ count s.drones - 1 = 2) (ho : ordered s.drones) (k : Nat) :
    ordered (protocol_step p s k).drones := by
  intro i hi
  have hc : count (protocol_step p s k).drones = count s.drones := count_step p s k
  rw [hc] at hi
  have h0 : ∀ j : Nat, j < count s.drones - 1 → positions p s 0 j < positions p s 0 (j + 1) := by
    intro j hj
    exact ho j (by omega)
  exact ordering_run (count s.drones - 1) p.eps (positions p s) (by omega) e0 e1 e2
    (positions_run p s hn ha) h0 k i (by omega)

/-- 7.2, sharp: `0 ≤ eps ≤ 1/2`, any strictly ordered start. -/
theorem ordering_sharp (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (ho : ordered s.drones) (k : Nat) : ordered (protocol_step p s k).drones :=
  ordering_general p s hn ha e0 (by grind) (Or.inl e1) ho k

/-- 7.2 for three drones: up to `eps = 1`. -/
theorem ordering_three (p : Params) (s : State) (hn : count s.drones = 3)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : p.eps ≤ 1)
    (ho : ordered s.drones) (k : Nat) : ordered (protocol_step p s k).drones :=
  ordering_general p s (by omega) ha e0 e1 (Or.inr (by omega)) ho k

/-- 7.2 under the paper's hypothesis. -/
theorem ordering_paper (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 3 * p.eps < 1)
    (ho : ordered s.drones) (k : Nat) : ordered (protocol_step p s k).drones :=
  ordering_sharp p s hn ha e0 (by grind) ho k

end CordonMirror
