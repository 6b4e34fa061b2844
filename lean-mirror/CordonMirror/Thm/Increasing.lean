import CordonMirror.Thm.NonDecreasing

/-! Theorem 7.7 with the exact step, and theorem 7.6, on error sequences: `E k i` is the error
of drone `i` after `k` steps (times any positive constant), `E k 0 = E k M = 0`. By the identity
of 7.5 the sum grows from step `k` to step `k + 1` by `e * (E k 1 + E k (M - 1))`; what is proved
here is when that is zero and when it is positive. -/

namespace CordonMirror

/-- The mirrored swarm. -/
theorem Run.mirror {M : Nat} {e : Rat} {X : Nat → Nat → Rat} (h : Run M e X) :
    Run M e (fun k i => X k (M - i)) := by
  intro k
  have hk : Step M e (X k) (X (k + 1)) := h k
  refine Step.mk ?_ ?_ ?_
  · show X (k + 1) (M - 0) = X k (M - 0)
    have hz : M - 0 = M := by omega
    rw [hz]
    exact hk.right_end
  · show X (k + 1) (M - M) = X k (M - M)
    have hz : M - M = 0 := by omega
    rw [hz]
    exact hk.left_end
  · intro i hi
    obtain ⟨j, hj⟩ : ∃ j : Nat, M = j + i + 2 := ⟨M - i - 2, by omega⟩
    have a0 : M - i = j + 2 := by omega
    have a1 : M - (i + 1) = j + 1 := by omega
    have a2 : M - (i + 2) = j := by omega
    have hin : X (k + 1) (j + 1)
        = e * X k j + (1 - 2 * e) * X k (j + 1) + e * X k (j + 2) := hk.inner j (by omega)
    show X (k + 1) (M - (i + 1))
      = e * X k (M - i) + (1 - 2 * e) * X k (M - (i + 1)) + e * X k (M - (i + 2))
    rw [a0, a1, a2, hin]
    grind

theorem errors_nonneg (M : Nat) (e : Rat) (E : Nat → Nat → Rat) (e0 : 0 ≤ e)
    (e1 : 2 * e ≤ 1) (hE : Run M e E) (h0 : ∀ i : Nat, i ≤ M → 0 ≤ E 0 i) (k : Nat) :
    ∀ i : Nat, i ≤ M → 0 ≤ E k i := by
  induction k with
  | zero => exact h0
  | succ k ih =>
    exact nonneg_weighted M (fun _ => e) (E k) (E (k + 1)) (Step.weighted (hE k))
      (fun _ _ _ => e0) (fun _ _ _ => e1) ih

/-- An error reaches drone `i + 1`, `t` drones further left, within `t` steps. -/
theorem spread (M : Nat) (e : Rat) (E : Nat → Nat → Rat) (e0 : 0 ≤ e) (e1 : 2 * e ≤ 1)
    (hE : Run M e E) (hpos : ∀ k i : Nat, i ≤ M → 0 ≤ E k i) (t : Nat) :
    ∀ k i : Nat, i + 1 + t < M → e ^ t * E k (i + 1 + t) ≤ E (k + t) (i + 1) := by
  induction t with
  | zero =>
    intro k i hi
    have h1 : e ^ 0 * E k (i + 1 + 0) = E k (i + 1) := by
      show e ^ 0 * E k (i + 1) = E k (i + 1)
      grind
    have h2 : E (k + 0) (i + 1) = E k (i + 1) := rfl
    exact le_of_eq (Eq.trans h1 (Eq.symm h2))
  | succ t ih =>
    intro k i hi
    have hs : E (k + t + 1) (i + 1)
        = e * E (k + t) i + (1 - 2 * e) * E (k + t) (i + 1) + e * E (k + t) (i + 2) :=
      (hE (k + t)).inner i (by omega)
    have ix : i + 1 + (t + 1) = i + 1 + 1 + t := by omega
    have ih2 : e ^ t * E k (i + 1 + 1 + t) ≤ E (k + t) (i + 1 + 1) := ih k (i + 1) (by omega)
    have p0 : 0 ≤ e * E (k + t) i := Rat.mul_nonneg e0 (hpos (k + t) i (by omega))
    have p1 : 0 ≤ (1 - 2 * e) * E (k + t) (i + 1) :=
      Rat.mul_nonneg (by grind) (hpos (k + t) (i + 1) (by omega))
    have p2 : e * (e ^ t * E k (i + 1 + 1 + t)) ≤ e * E (k + t) (i + 2) :=
      Rat.mul_le_mul_of_nonneg_left ih2 e0
    have hp : e ^ (t + 1) * E k (i + 1 + 1 + t) = e * (e ^ t * E k (i + 1 + 1 + t)) := by grind
    rw [ix, hp]
    show e * (e ^ t * E k (i + 1 + 1 + t)) ≤ E (k + t + 1) (i + 1)
    rw [hs]
    grind

/-- Where the first `h` drones are at their targets, `h - t` of them still are after `t`
steps. -/
theorem quiet (M : Nat) (e : Rat) (E : Nat → Nat → Rat) (hE : Run M e E)
    (hend : ∀ k : Nat, E k 0 = 0) (h k : Nat) (hh : h < M)
    (h0 : ∀ i : Nat, i ≤ h → E k i = 0) (t : Nat) :
    ∀ i : Nat, i + t ≤ h → E (k + t) i = 0 := by
  induction t with
  | zero =>
    intro i hi
    exact h0 i (by omega)
  | succ t ih =>
    intro i hi
    by_cases hz : i = 0
    · rw [hz]
      exact hend (k + (t + 1))
    · obtain ⟨j, hj⟩ : ∃ j : Nat, i = j + 1 := ⟨i - 1, by omega⟩
      subst hj
      have hs : E (k + t + 1) (j + 1)
          = e * E (k + t) j + (1 - 2 * e) * E (k + t) (j + 1) + e * E (k + t) (j + 2) :=
        (hE (k + t)).inner j (by omega)
      have z0 : E (k + t) j = 0 := ih j (by omega)
      have z1 : E (k + t) (j + 1) = 0 := ih (j + 1) (by omega)
      have z2 : E (k + t) (j + 2) = 0 := ih (j + 2) (by omega)
      show E (k + t + 1) (j + 1) = 0
      rw [hs, z0, z1, z2]
      grind

/-- 7.7, exact, left half: if drone `h + 1` is off target and the drones before it are not,
the error first reaches drone 1 after `h` steps. -/
theorem first_reach (M : Nat) (e : Rat) (E : Nat → Nat → Rat) (e0 : 0 < e) (e1 : 2 * e ≤ 1)
    (hE : Run M e E) (hend : ∀ k : Nat, E k 0 = 0)
    (hpos : ∀ i : Nat, i ≤ M → 0 ≤ E 0 i) (k h : Nat) (hh : h + 1 < M)
    (hoff : 0 < E k (h + 1)) (hon : ∀ i : Nat, i ≤ h → E k i = 0) :
    (∀ t : Nat, t < h → E (k + t) 1 = 0) ∧ 0 < E (k + h) 1 := by
  have hall : ∀ k i : Nat, i ≤ M → 0 ≤ E k i :=
    errors_nonneg M e E (Rat.le_of_lt e0) e1 hE hpos
  refine And.intro ?_ ?_
  · intro t ht
    exact quiet M e E hE hend h k (by omega) hon t 1 (by omega)
  · have hs : e ^ h * E k (0 + 1 + h) ≤ E (k + h) (0 + 1) :=
      spread M e E (Rat.le_of_lt e0) e1 hE hall h k 0 (by omega)
    have ix : 0 + 1 + h = h + 1 := by omega
    rw [ix] at hs
    have hp : 0 < e ^ h * E k (h + 1) := Rat.mul_pos (Rat.pow_pos e0) hoff
    exact lt_of_lt_of_le hp hs

/-- 7.7, exact, right half: the mirror image. -/
theorem first_reach_right (M : Nat) (e : Rat) (E : Nat → Nat → Rat) (e0 : 0 < e)
    (e1 : 2 * e ≤ 1) (hE : Run M e E) (hend : ∀ k : Nat, E k M = 0)
    (hpos : ∀ i : Nat, i ≤ M → 0 ≤ E 0 i) (k h : Nat) (hh : h + 1 < M)
    (hoff : 0 < E k (M - (h + 1))) (hon : ∀ i : Nat, i ≤ h → E k (M - i) = 0) :
    (∀ t : Nat, t < h → E (k + t) (M - 1) = 0) ∧ 0 < E (k + h) (M - 1) :=
  first_reach M e (fun k i => E k (M - i)) e0 e1 (Run.mirror hE) hend
    (fun i _ => hpos (M - i) (by omega)) k h hh hoff hon

end CordonMirror
