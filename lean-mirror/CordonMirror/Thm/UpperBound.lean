import CordonMirror.Thm.Dynamics
import CordonMirror.Thm.Arithmetic

/-! Theorem 7.3, the reference position upper bound, in its sharp form, its mirror image
and the box. All four are one statement: a nonnegative affine image of the positions stays
nonnegative. -/

namespace CordonMirror

/-- An affine image of the positions, the constant part being straight in the drone's number,
moves with the same weights. -/
theorem Weighted.affine {M : Nat} {a x y : Nat → Rat} (h : Weighted M a x y)
    (b : Nat → Rat) (d : Rat) (hb : ∀ i : Nat, b i + b (i + 2) = 2 * b (i + 1)) :
    Weighted M a (fun i => b i + d * x i) (fun i => b i + d * y i) := by
  refine Weighted.mk ?_ ?_ ?_
  · show b 0 + d * y 0 = b 0 + d * x 0
    rw [h.left_end]
  · show b M + d * y M = b M + d * x M
    rw [h.right_end]
  · intro i hi
    have hy : y (i + 1) = x (i + 1) + a (i + 1) * (x i - 2 * x (i + 1) + x (i + 2)) :=
      h.inner i hi
    have hb2 : b (i + 2) = 2 * b (i + 1) - b i := by
      have hbi : b i + b (i + 2) = 2 * b (i + 1) := hb i
      grind
    show b (i + 1) + d * y (i + 1)
      = b (i + 1) + d * x (i + 1)
        + a (i + 1) * (b i + d * x i - 2 * (b (i + 1) + d * x (i + 1))
          + (b (i + 2) + d * x (i + 2)))
    rw [hy, hb2]
    grind

theorem nonneg_weighted (M : Nat) (a x y : Nat → Rat) (hw : Weighted M a x y)
    (ha0 : ∀ i : Nat, 0 < i → i < M → 0 ≤ a i)
    (ha1 : ∀ i : Nat, 0 < i → i < M → 2 * a i ≤ 1)
    (hx : ∀ i : Nat, i ≤ M → 0 ≤ x i) : ∀ i : Nat, i ≤ M → 0 ≤ y i := by
  intro i hi
  by_cases hl : i = M
  · rw [hl, hw.right_end]
    exact hx M (Nat.le_refl M)
  · by_cases h0 : i = 0
    · rw [h0, hw.left_end]
      exact hx 0 (Nat.zero_le M)
    · obtain ⟨j, hj⟩ : ∃ j : Nat, i = j + 1 := ⟨i - 1, by omega⟩
      subst hj
      have hy : y (j + 1) = x (j + 1) + a (j + 1) * (x j - 2 * x (j + 1) + x (j + 2)) :=
        hw.inner j (by omega)
      have a0 : 0 ≤ a (j + 1) := ha0 (j + 1) (by omega) (by omega)
      have a1 : 2 * a (j + 1) ≤ 1 := ha1 (j + 1) (by omega) (by omega)
      have p0 : 0 ≤ a (j + 1) * x j := Rat.mul_nonneg a0 (hx j (by omega))
      have p1 : 0 ≤ (1 - 2 * a (j + 1)) * x (j + 1) :=
        Rat.mul_nonneg (by grind) (hx (j + 1) (by omega))
      have p2 : 0 ≤ a (j + 1) * x (j + 2) := Rat.mul_nonneg a0 (hx (j + 2) (by omega))
      rw [hy]
      grind

theorem nonneg_run (M : Nat) (e : Rat) (X : Nat → Nat → Rat) (e0 : 0 ≤ e) (e1 : 2 * e ≤ 1)
    (hX : Run M e X) (b : Nat → Rat) (d : Rat)
    (hb : ∀ i : Nat, b i + b (i + 2) = 2 * b (i + 1))
    (h0 : ∀ i : Nat, i ≤ M → 0 ≤ b i + d * X 0 i) :
    ∀ k i : Nat, i ≤ M → 0 ≤ b i + d * X k i := by
  intro k
  induction k with
  | zero => exact h0
  | succ k ih =>
    exact nonneg_weighted M (fun _ => e) (fun i => b i + d * X k i)
      (fun i => b i + d * X (k + 1) i)
      (Weighted.affine (Step.weighted (hX k)) b d hb)
      (fun _ _ _ => e0) (fun _ _ _ => e1) ih

/-! ### Straight lines -/

/-- `M` times the target of drone `i`. -/
def scaled_line (M : Nat) (lo up : Rat) (i : Nat) : Rat :=
  (M : Rat) * lo + (i : Rat) * (up - lo)

theorem scaled_line_straight (M : Nat) (lo up : Rat) (i : Nat) :
    scaled_line M lo up i + scaled_line M lo up (i + 2) = 2 * scaled_line M lo up (i + 1) := by
  have h1 : ((i + 1 : Nat) : Rat) = (i : Rat) + 1 := cast_add_one i
  have h2 : ((i + 2 : Nat) : Rat) = (i : Rat) + 2 := cast_add_two i
  unfold scaled_line
  rw [h1, h2]
  grind

theorem scaled_error_eq (lo up : Rat) (x : DroneMap Rat) (i : Nat) :
    scaled_error lo up x i
      = scaled_line (count x - 1) lo up i + (-((count x - 1 : Nat) : Rat)) * get x i := by
  unfold scaled_error scaled_target gaps scaled_line
  grind

/-! ### On the spec -/

/-- 7.3, sharp. -/
theorem upper_bound_sharp (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (hu : upper_bounded p s.drones) (k : Nat) :
    upper_bounded p (protocol_step p s k).drones := by
  intro i hi
  have hc : count (protocol_step p s k).drones = count s.drones := count_step p s k
  have h0 : ∀ j : Nat, j ≤ count s.drones - 1 →
      0 ≤ scaled_line (count s.drones - 1) p.min p.max j
        + (-((count s.drones - 1 : Nat) : Rat)) * positions p s 0 j := by
    intro j hj
    have hj2 : 0 ≤ scaled_error p.min p.max s.drones j := hu j (by omega)
    rw [scaled_error_eq] at hj2
    exact hj2
  rw [scaled_error_eq, hc]
  rw [hc] at hi
  exact nonneg_run (count s.drones - 1) p.eps (positions p s) e0 e1
    (positions_run p s hn ha) (scaled_line (count s.drones - 1) p.min p.max)
    (-((count s.drones - 1 : Nat) : Rat))
    (scaled_line_straight (count s.drones - 1) p.min p.max) h0 k i (by omega)

/-- The mirror image: the negated errors. -/
theorem lower_bound_sharp (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (hu : above_targets p s.drones) (k : Nat) :
    above_targets p (protocol_step p s k).drones := by
  intro i hi
  have hc : count (protocol_step p s k).drones = count s.drones := count_step p s k
  have hb : ∀ j : Nat,
      -scaled_line (count s.drones - 1) p.min p.max j
        + -scaled_line (count s.drones - 1) p.min p.max (j + 2)
      = 2 * -scaled_line (count s.drones - 1) p.min p.max (j + 1) := by
    intro j
    have h := scaled_line_straight (count s.drones - 1) p.min p.max j
    grind
  have h0 : ∀ j : Nat, j ≤ count s.drones - 1 →
      0 ≤ -scaled_line (count s.drones - 1) p.min p.max j
        + ((count s.drones - 1 : Nat) : Rat) * positions p s 0 j := by
    intro j hj
    have hj2 : scaled_error p.min p.max s.drones j ≤ 0 := hu j (by omega)
    rw [scaled_error_eq] at hj2
    have hp : positions p s 0 j = get s.drones j := rfl
    rw [hp]
    grind
  rw [hc] at hi
  have hk : 0 ≤ -scaled_line (count s.drones - 1) p.min p.max i
      + ((count s.drones - 1 : Nat) : Rat) * positions p s k i :=
    nonneg_run (count s.drones - 1) p.eps (positions p s) e0 e1
      (positions_run p s hn ha)
      (fun j => -scaled_line (count s.drones - 1) p.min p.max j)
      ((count s.drones - 1 : Nat) : Rat) hb h0 k i (by omega)
  have hp : positions p s k i = get (protocol_step p s k).drones i := rfl
  rw [hp] at hk
  rw [scaled_error_eq, hc]
  grind

/-- The box. -/
theorem box_sharp (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (hb : in_box p s.drones) (k : Nat) : in_box p (protocol_step p s k).drones := by
  intro i hi
  have hc : count (protocol_step p s k).drones = count s.drones := count_step p s k
  rw [hc] at hi
  have hp : positions p s k i = get (protocol_step p s k).drones i := rfl
  have hlo : 0 ≤ -p.min + 1 * positions p s k i := by
    refine nonneg_run (count s.drones - 1) p.eps (positions p s) e0 e1
      (positions_run p s hn ha) (fun _ => -p.min) 1 ?_ ?_ k i (by omega)
    · intro j
      show -p.min + -p.min = 2 * -p.min
      grind
    · intro j hj
      have hj2 : p.min ≤ get s.drones j := (hb j (by omega)).1
      have hp0 : positions p s 0 j = get s.drones j := rfl
      show 0 ≤ -p.min + 1 * positions p s 0 j
      rw [hp0]
      grind
  have hup : 0 ≤ p.max + (-1) * positions p s k i := by
    refine nonneg_run (count s.drones - 1) p.eps (positions p s) e0 e1
      (positions_run p s hn ha) (fun _ => p.max) (-1) ?_ ?_ k i (by omega)
    · intro j
      show p.max + p.max = 2 * p.max
      grind
    · intro j hj
      have hj2 : get s.drones j ≤ p.max := (hb j (by omega)).2
      have hp0 : positions p s 0 j = get s.drones j := rfl
      show 0 ≤ p.max + (-1) * positions p s 0 j
      rw [hp0]
      grind
  rw [hp] at hlo hup
  exact And.intro (by grind) (by grind)

end CordonMirror
