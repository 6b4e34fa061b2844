import CordonMirror.Thm.Bounds
import CordonMirror.Thm.LimitSharp

/-! Theorem 7.8 for `0 < eps ≤ 1/2` under delays of at most `D` steps: one contraction every
`D + 1` steps. -/

namespace CordonMirror

/-- From step `a` on every scaled error is within `C` times the contraction vector. -/
def BoundedFrom (p : Params) (M : Nat) (C : Rat) (X : Nat → State) (a : Nat) : Prop :=
  ∀ l : Nat, a ≤ l → ∀ i : Nat, i ≤ M →
    scaled_error p.min p.max (X l).drones i ≤ C * weight M i ∧
    -scaled_error p.min p.max (X l).drones i ≤ C * weight M i

theorem delayed_ends (p : Params) (delay : Nat → Nat → Nat → Nat) (X : Nat → State)
    (hX : DelayedRun p delay X) (hn : 3 ≤ count (X 0).drones) (ha : anchored p (X 0).drones)
    (k : Nat) : anchored p (X k).drones := by
  cases k with
  | zero => exact ha
  | succ k =>
    have hc : count (X k).drones = count (X 0).drones := count_delayed_run p delay X hX k
    have hc2 : count (X (k + 1)).drones = count (X 0).drones :=
      count_delayed_run p delay X hX (k + 1)
    have hstep : X (k + 1)
        = exec_coverage_delayed p (X k) (fun i j => getx (X (k - delay k i j)) j) := hX k
    refine And.intro ?_ ?_
    · rw [hstep]
      exact Eq.trans
        (get_delayed p (X k) (fun i j => getx (X (k - delay k i j)) j) 0 (by omega))
        (update_first p (count (X k).drones) _)
    · rw [hc2, ← hc, hstep]
      exact Eq.trans
        (get_delayed p (X k) (fun i j => getx (X (k - delay k i j)) j)
          (count (X k).drones - 1) (by omega))
        (update_last p (count (X k).drones) _ (by omega))

/-- One drone's error after a step with delays. -/
theorem delayed_error (p : Params) (delay : Nat → Nat → Nat → Nat) (X : Nat → State)
    (hX : DelayedRun p delay X) (k j : Nat) (hj : j + 2 < count (X 0).drones) :
    scaled_error p.min p.max (X (k + 1)).drones (j + 1)
      = p.eps * scaled_error p.min p.max (X (k - delay k (j + 1) j)).drones j
        + (1 - 2 * p.eps) * scaled_error p.min p.max (X k).drones (j + 1)
        + p.eps * scaled_error p.min p.max (X (k - delay k (j + 1) (j + 2))).drones (j + 2) := by
  have hc : ∀ l : Nat, count (X l).drones = count (X 0).drones := count_delayed_run p delay X hX
  have hstep : X (k + 1)
      = exec_coverage_delayed p (X k) (fun i j => getx (X (k - delay k i j)) j) := hX k
  have hk : j + 2 < count (X k).drones := by
    have h := hc k
    omega
  have hg : get (X (k + 1)).drones (j + 1)
      = p.eps * get (X (k - delay k (j + 1) j)).drones j
        + (1 - 2 * p.eps) * get (X k).drones (j + 1)
        + p.eps * get (X (k - delay k (j + 1) (j + 2))).drones (j + 2) := by
    rw [hstep]
    exact delayed_inner p (X k) (fun i j => getx (X (k - delay k i j)) j) j hk
  have hl : p.eps * (scaled_line (count (X 0).drones - 1) p.min p.max j
        + scaled_line (count (X 0).drones - 1) p.min p.max (j + 2))
      = p.eps * (2 * scaled_line (count (X 0).drones - 1) p.min p.max (j + 1)) :=
    congrArg (fun x => p.eps * x) (scaled_line_straight (count (X 0).drones - 1) p.min p.max j)
  rw [scaled_error_eq, scaled_error_eq, scaled_error_eq, scaled_error_eq, hc (k + 1), hc k,
    hc (k - delay k (j + 1) j), hc (k - delay k (j + 1) (j + 2)), hg]
  grind

/-- Rows of a step with delays: what bounds all that is seen shrinks by `r`. -/
theorem delayed_row (M : Nat) (e r C a b c : Rat) (j : Nat) (hM : 0 < M) (e0 : 0 ≤ e)
    (e1 : 2 * e ≤ 1) (hr : (M : Rat) * (M : Rat) * r = (M : Rat) * (M : Rat) - 8 * e)
    (hC : 0 ≤ C) (ha : a ≤ C * weight M j) (hb : b ≤ C * weight M (j + 1))
    (hc : c ≤ C * weight M (j + 2)) :
    e * a + (1 - 2 * e) * b + e * c ≤ r * C * weight M (j + 1) := by
  have b0 : e * a ≤ e * (C * weight M j) := Rat.mul_le_mul_of_nonneg_left ha e0
  have b1 : (1 - 2 * e) * b ≤ (1 - 2 * e) * (C * weight M (j + 1)) :=
    Rat.mul_le_mul_of_nonneg_left hb (by grind)
  have b2 : e * c ≤ e * (C * weight M (j + 2)) := Rat.mul_le_mul_of_nonneg_left hc e0
  have hw : C * (weight M (j + 1) - 2 * e) ≤ C * (r * weight M (j + 1)) :=
    Rat.mul_le_mul_of_nonneg_left (weight_contracts M e r hM e0 hr (j + 1)) hC
  have he : C * (e * weight M j + (1 - 2 * e) * weight M (j + 1) + e * weight M (j + 2))
      = C * (weight M (j + 1) - 2 * e) :=
    congrArg (fun t => C * t) (weight_eigen M e j)
  grind

/-- One step: if all that was seen is within `C`, the result is within `r C`. -/
theorem delayed_contracts (p : Params) (delay : Nat → Nat → Nat → Nat) (X : Nat → State) (M : Nat)
    (r C : Rat) (hX : DelayedRun p delay X) (hM : count (X 0).drones = M + 1) (h2 : 2 ≤ M)
    (ha : anchored p (X 0).drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (hr : (M : Rat) * (M : Rat) * r = (M : Rat) * (M : Rat) - 8 * p.eps) (hC : 0 ≤ C) (k : Nat)
    (hseen : ∀ l : Nat, l ≤ k → (l = k ∨ ∃ i j : Nat, l = k - delay k i j) →
      ∀ i : Nat, i ≤ M → scaled_error p.min p.max (X l).drones i ≤ C * weight M i ∧
        -scaled_error p.min p.max (X l).drones i ≤ C * weight M i) :
    ∀ i : Nat, i ≤ M →
      scaled_error p.min p.max (X (k + 1)).drones i ≤ r * C * weight M i ∧
      -scaled_error p.min p.max (X (k + 1)).drones i ≤ r * C * weight M i := by
  intro i hi
  have hn : 3 ≤ count (X 0).drones := by omega
  have hc : count (X (k + 1)).drones = M + 1 :=
    Eq.trans (count_delayed_run p delay X hX (k + 1)) hM
  have hends := delayed_ends p delay X hX hn ha (k + 1)
  by_cases hz : i = 0
  · rw [hz, error_first p (X (k + 1)).drones hends.1, weight_first]
    exact And.intro (by grind) (by grind)
  · by_cases hl : i = M
    · have he := error_last p (X (k + 1)).drones hends.2
      have hm : count (X (k + 1)).drones - 1 = M := by omega
      rw [hm] at he
      rw [hl, he, weight_last]
      exact And.intro (by grind) (by grind)
    · obtain ⟨j, hj⟩ : ∃ j : Nat, i = j + 1 := ⟨i - 1, by omega⟩
      subst hj
      have a := hseen (k - delay k (j + 1) j) (by omega)
        (Or.inr (Exists.intro (j + 1) (Exists.intro j rfl))) j (by omega)
      have b := hseen k (Nat.le_refl k) (Or.inl rfl) (j + 1) hi
      have c := hseen (k - delay k (j + 1) (j + 2)) (by omega)
        (Or.inr (Exists.intro (j + 1) (Exists.intro (j + 2) rfl))) (j + 2) (by omega)
      have up := delayed_row M p.eps r C _ _ _ j (by omega) e0 e1 hr hC a.1 b.1 c.1
      have lo := delayed_row M p.eps r C _ _ _ j (by omega) e0 e1 hr hC a.2 b.2 c.2
      rw [delayed_error p delay X hX k j (by omega)]
      exact And.intro up (by grind)

/-- 7.8 with delays of at most `D`, for `0 < eps ≤ 1/2`. -/
theorem limit_delayed (p : Params) (delay : Nat → Nat → Nat → Nat) (X : Nat → State) (D : Nat)
    (hX : DelayedRun p delay X) (hn : 3 ≤ count (X 0).drones) (ha : anchored p (X 0).drones)
    (e0 : 0 < p.eps) (e1 : 2 * p.eps ≤ 1) (hD : ∀ k i j : Nat, delay k i j ≤ D) :
    converges p X := by
  intro i d hi hd
  obtain ⟨M, hM⟩ : ∃ M : Nat, count (X 0).drones = M + 1 := ⟨count (X 0).drones - 1, by omega⟩
  obtain ⟨r, r0, r1, hr⟩ := exists_rate M p.eps (by omega) e0 e1
  obtain ⟨C, hC, hb⟩ := exists_bound (scaled_error p.min p.max (X 0).drones) (M + 1)
  have wpos : ∀ j : Nat, j ≤ M → 0 ≤ weight M j := by
    intro j hj
    by_cases h0 : j = 0
    · rw [h0, weight_first]
      exact Rat.le_refl
    · by_cases hl : j = M
      · rw [hl, weight_last]
        exact Rat.le_refl
      · have h := weight_ge_one M j (by omega) (by omega)
        grind
  have hstart : ∀ j : Nat, j ≤ M →
      scaled_error p.min p.max (X 0).drones j ≤ C * weight M j ∧
      -scaled_error p.min p.max (X 0).drones j ≤ C * weight M j := by
    intro j hj
    by_cases h0 : j = 0
    · rw [h0, error_first p (X 0).drones ha.1, weight_first]
      exact And.intro (by grind) (by grind)
    · by_cases hl : j = M
      · have he := error_last p (X 0).drones ha.2
        have hm : count (X 0).drones - 1 = M := by omega
        rw [hm] at he
        rw [hl, he, weight_last]
        exact And.intro (by grind) (by grind)
      · have hw := weight_ge_one M j (by omega) (by omega)
        have hcw : 0 ≤ C * (weight M j - 1) := Rat.mul_nonneg hC (by grind)
        have h := hb j (by omega)
        exact And.intro (by grind) (by grind)
  -- Bounds never grow ...
  have hall : BoundedFrom p M C X 0 := by
    intro l
    induction l using Nat.strongRecOn with
    | ind l ih =>
      intro _
      cases l with
      | zero => exact hstart
      | succ k =>
        intro j hj
        have h := delayed_contracts p delay X M r C hX hM (by omega) ha (Rat.le_of_lt e0) e1 hr hC
          k (fun l hl _ => ih l (by omega) (Nat.zero_le l)) j hj
        have hrc : 0 ≤ (1 - r) * (C * weight M j) :=
          Rat.mul_nonneg (by grind) (Rat.mul_nonneg hC (wpos j hj))
        exact And.intro (by grind) (by grind)
  -- ... and shrink by `r` once all that is older than `D` steps is forgotten.
  have hblock : ∀ n : Nat, BoundedFrom p M (r ^ n * C) X (n * (D + 1)) := by
    intro n
    induction n with
    | zero =>
      have h1 : r ^ 0 = 1 := Rat.pow_zero _
      have hz : 0 * (D + 1) = 0 := Nat.zero_mul (D + 1)
      have hc : 1 * C = C := by grind
      rw [h1, hz, hc]
      exact hall
    | succ n ih =>
      have hp : r ^ (n + 1) * C = r * (r ^ n * C) := by
        have h : r ^ (n + 1) = r ^ n * r := Rat.pow_succ r n
        rw [h]
        grind
      have hm : (n + 1) * (D + 1) = n * (D + 1) + (D + 1) := Nat.succ_mul n (D + 1)
      rw [hp, hm]
      intro l hl
      obtain ⟨k, hk⟩ : ∃ k : Nat, l = k + 1 := ⟨l - 1, by omega⟩
      subst hk
      refine delayed_contracts p delay X M r (r ^ n * C) hX hM (by omega) ha (Rat.le_of_lt e0) e1 hr
        (Rat.mul_nonneg (Rat.pow_nonneg r0) hC) k ?_
      intro l _ hseen
      refine ih l ?_
      cases hseen with
      | inl h => omega
      | inr h =>
        obtain ⟨a, b, hab⟩ := h
        have hd2 := hD k a b
        omega
  obtain ⟨n, hs⟩ := pow_small r (C * weight M i) d r0 r1 hd
  refine Exists.intro (n * (D + 1)) ?_
  intro k hk
  have h := hblock n k hk i (by omega)
  have hlt : r ^ n * (C * weight M i) < d := hs n (Nat.le_refl n)
  exact And.intro (by grind) (by grind)

end CordonMirror
