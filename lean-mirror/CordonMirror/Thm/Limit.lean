import CordonMirror.Thm.UpperBound

/-! Theorem 7.8 for `0 ≤ eps ≤ 1/2`, the rate: the vector `w_i = i (M - i)` contracts by `r`,
where `M² r = M² - 8 eps`, that is `r = 1 - 8 eps / (N-1)²`. -/

namespace CordonMirror

theorem Step.neg {M : Nat} {e : Rat} {x y : Nat → Rat} (h : Step M e x y) :
    Step M e (fun i => -x i) (fun i => -y i) := by
  refine Step.mk ?_ ?_ ?_
  · show -y 0 = -x 0
    rw [h.left_end]
  · show -y M = -x M
    rw [h.right_end]
  · intro i hi
    have hy : y (i + 1) = e * x i + (1 - 2 * e) * x (i + 1) + e * x (i + 2) := h.inner i hi
    show -y (i + 1) = e * -x i + (1 - 2 * e) * -x (i + 1) + e * -x (i + 2)
    rw [hy]
    grind

/-- The contraction vector, with `M = N - 1`. -/
def weight (M i : Nat) : Rat := (i : Rat) * ((M : Rat) - (i : Rat))

theorem weight_first (M : Nat) : weight M 0 = 0 := by
  have h0 : ((0 : Nat) : Rat) = 0 := rfl
  unfold weight
  rw [h0]
  grind

theorem weight_last (M : Nat) : weight M M = 0 := by
  unfold weight
  grind

/-- `A w = w - 2 eps`. -/
theorem weight_eigen (M : Nat) (e : Rat) (i : Nat) :
    e * weight M i + (1 - 2 * e) * weight M (i + 1) + e * weight M (i + 2)
      = weight M (i + 1) - 2 * e := by
  have h1 : ((i + 1 : Nat) : Rat) = (i : Rat) + 1 := cast_add_one i
  have h2 : ((i + 2 : Nat) : Rat) = (i : Rat) + 2 := cast_add_two i
  unfold weight
  rw [h1, h2]
  grind

/-- `4 w_i ≤ M²`. -/
theorem weight_le (M i : Nat) : 4 * weight M i ≤ (M : Rat) * (M : Rat) := by
  have h : 0 ≤ ((M : Rat) - 2 * (i : Rat)) * ((M : Rat) - 2 * (i : Rat)) :=
    mul_self_nonneg ((M : Rat) - 2 * (i : Rat))
  unfold weight
  grind

/-- `A w ≤ r w`. -/
theorem weight_contracts (M : Nat) (e r : Rat) (hM : 0 < M) (e0 : 0 ≤ e)
    (hr : (M : Rat) * (M : Rat) * r = (M : Rat) * (M : Rat) - 8 * e) (i : Nat) :
    weight M i - 2 * e ≤ r * weight M i := by
  have m0 : (0 : Rat) < (M : Rat) := Rat.natCast_pos.mpr hM
  have mm : 0 < (M : Rat) * (M : Rat) := Rat.mul_pos m0 m0
  have h4 : 0 ≤ (M : Rat) * (M : Rat) - 4 * weight M i := by
    have h : 4 * weight M i ≤ (M : Rat) * (M : Rat) := weight_le M i
    grind
  have h5 : 0 ≤ e * ((M : Rat) * (M : Rat) - 4 * weight M i) := Rat.mul_nonneg e0 h4
  have h6 : (M : Rat) * (M : Rat) * (r * weight M i - weight M i + 2 * e)
      = 2 * (e * ((M : Rat) * (M : Rat) - 4 * weight M i)) := by
    have h7 : (M : Rat) * (M : Rat) * (r * weight M i - weight M i + 2 * e)
        = ((M : Rat) * (M : Rat) * r) * weight M i
          - (M : Rat) * (M : Rat) * weight M i + 2 * ((M : Rat) * (M : Rat)) * e := by
      grind
    rw [h7, hr]
    grind
  refine Classical.byContradiction fun hneg => ?_
  have hlt : r * weight M i - weight M i + 2 * e < 0 := by
    have h : r * weight M i < weight M i - 2 * e := Rat.not_le.mp hneg
    grind
  have hprod : (M : Rat) * (M : Rat) * (r * weight M i - weight M i + 2 * e) < 0 :=
    mul_neg_of_pos_of_neg mm hlt
  rw [h6] at hprod
  grind

theorem contraction_step (M : Nat) (e r C : Rat) (hM : 0 < M) (e0 : 0 ≤ e) (e1 : 2 * e ≤ 1)
    (hr : (M : Rat) * (M : Rat) * r = (M : Rat) * (M : Rat) - 8 * e) (hC : 0 ≤ C)
    (x y : Nat → Rat) (h : Step M e x y) (x0 : x 0 = 0) (xM : x M = 0)
    (hx : ∀ i : Nat, i ≤ M → x i ≤ C * weight M i) :
    ∀ i : Nat, i ≤ M → y i ≤ r * C * weight M i := by
  intro i hi
  by_cases hl : i = M
  · rw [hl, h.right_end, xM, weight_last]
    grind
  · by_cases h0 : i = 0
    · rw [h0, h.left_end, x0, weight_first]
      grind
    · obtain ⟨j, hj⟩ : ∃ j : Nat, i = j + 1 := ⟨i - 1, by omega⟩
      subst hj
      have hy : y (j + 1) = e * x j + (1 - 2 * e) * x (j + 1) + e * x (j + 2) :=
        h.inner j (by omega)
      have b0 : e * x j ≤ e * (C * weight M j) :=
        Rat.mul_le_mul_of_nonneg_left (hx j (by omega)) e0
      have b1 : (1 - 2 * e) * x (j + 1) ≤ (1 - 2 * e) * (C * weight M (j + 1)) :=
        Rat.mul_le_mul_of_nonneg_left (hx (j + 1) (by omega)) (by grind)
      have b2 : e * x (j + 2) ≤ e * (C * weight M (j + 2)) :=
        Rat.mul_le_mul_of_nonneg_left (hx (j + 2) (by omega)) e0
      have hw : weight M (j + 1) - 2 * e ≤ r * weight M (j + 1) :=
        weight_contracts M e r hM e0 hr (j + 1)
      have hCw : C * (weight M (j + 1) - 2 * e) ≤ C * (r * weight M (j + 1)) :=
        Rat.mul_le_mul_of_nonneg_left hw hC
      have he : C * (e * weight M j + (1 - 2 * e) * weight M (j + 1) + e * weight M (j + 2))
          = C * (weight M (j + 1) - 2 * e) :=
        congrArg (fun t => C * t) (weight_eigen M e j)
      rw [hy]
      grind

/-- 7.8, the rate, on error sequences. `C` is any bound of the initial errors:
`|E_0 i| ≤ C w_i`; then `|E_k i| ≤ r^k C w_i`. -/
theorem limit_rate (M : Nat) (e r C : Rat) (hM : 0 < M) (e0 : 0 ≤ e) (e1 : 2 * e ≤ 1)
    (r0 : 0 ≤ r) (hr : (M : Rat) * (M : Rat) * r = (M : Rat) * (M : Rat) - 8 * e)
    (hC : 0 ≤ C) (E : Nat → Nat → Rat) (hE : Run M e E) (E0 : E 0 0 = 0) (EM : E 0 M = 0)
    (hup : ∀ i : Nat, i ≤ M → E 0 i ≤ C * weight M i)
    (hlo : ∀ i : Nat, i ≤ M → -E 0 i ≤ C * weight M i) (k : Nat) :
    ∀ i : Nat, i ≤ M → E k i ≤ r ^ k * C * weight M i ∧ -E k i ≤ r ^ k * C * weight M i := by
  induction k with
  | zero =>
    intro i hi
    have h1 : r ^ 0 * C * weight M i = C * weight M i := by grind
    rw [h1]
    exact And.intro (hup i hi) (hlo i hi)
  | succ k ih =>
    intro i hi
    have hk : 0 ≤ r ^ k * C := Rat.mul_nonneg (Rat.pow_nonneg r0) hC
    have hp : r ^ (k + 1) * C * weight M i = r * (r ^ k * C) * weight M i := by grind
    have k0 : E k 0 = 0 := Eq.trans (Run.ends hE k).1 E0
    have kM : E k M = 0 := Eq.trans (Run.ends hE k).2 EM
    have n0 : -E k 0 = 0 := by grind
    have nM : -E k M = 0 := by grind
    rw [hp]
    refine And.intro ?_ ?_
    · exact contraction_step M e r (r ^ k * C) hM e0 e1 hr hk (E k) (E (k + 1)) (hE k) k0 kM
        (fun j hj => (ih j hj).1) i hi
    · exact contraction_step M e r (r ^ k * C) hM e0 e1 hr hk (fun j => -E k j)
        (fun j => -E (k + 1) j) (Step.neg (hE k)) n0 nM (fun j hj => (ih j hj).2) i hi

end CordonMirror
