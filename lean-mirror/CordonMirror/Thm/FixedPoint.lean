import CordonMirror.Thm.NonDecreasing

/-! Theorem 7.6 (i): the targets are a fixed point, for every weight. -/

namespace CordonMirror

theorem scaled_error_step (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) :
    Weighted (count s.drones - 1) (fun _ => p.eps)
      (scaled_error p.min p.max s.drones)
      (scaled_error p.min p.max (exec_coverage p s).drones) := by
  have hc : count (exec_coverage p s).drones = count s.drones := count_exec p s
  have hw : Weighted (count s.drones - 1) (fun _ => p.eps)
      (fun i => scaled_line (count s.drones - 1) p.min p.max i
        + (-((count s.drones - 1 : Nat) : Rat)) * get s.drones i)
      (fun i => scaled_line (count s.drones - 1) p.min p.max i
        + (-((count s.drones - 1 : Nat) : Rat)) * get (exec_coverage p s).drones i) :=
    Weighted.affine (Step.weighted (exec_step p s hn ha))
      (scaled_line (count s.drones - 1) p.min p.max) (-((count s.drones - 1 : Nat) : Rat))
      (scaled_line_straight (count s.drones - 1) p.min p.max)
  have hx : ∀ i : Nat, scaled_error p.min p.max s.drones i
      = scaled_line (count s.drones - 1) p.min p.max i
        + (-((count s.drones - 1 : Nat) : Rat)) * get s.drones i :=
    fun i => scaled_error_eq p.min p.max s.drones i
  have hy : ∀ i : Nat, scaled_error p.min p.max (exec_coverage p s).drones i
      = scaled_line (count s.drones - 1) p.min p.max i
        + (-((count s.drones - 1 : Nat) : Rat)) * get (exec_coverage p s).drones i := by
    intro i
    have h : scaled_error p.min p.max (exec_coverage p s).drones i
        = scaled_line (count (exec_coverage p s).drones - 1) p.min p.max i
          + (-((count (exec_coverage p s).drones - 1 : Nat) : Rat))
            * get (exec_coverage p s).drones i :=
      scaled_error_eq p.min p.max (exec_coverage p s).drones i
    rw [hc] at h
    exact h
  have fx : scaled_error p.min p.max s.drones
      = fun i => scaled_line (count s.drones - 1) p.min p.max i
        + (-((count s.drones - 1 : Nat) : Rat)) * get s.drones i := funext hx
  have fy : scaled_error p.min p.max (exec_coverage p s).drones
      = fun i => scaled_line (count s.drones - 1) p.min p.max i
        + (-((count s.drones - 1 : Nat) : Rat)) * get (exec_coverage p s).drones i := funext hy
  rw [fx, fy]
  exact hw

theorem exec_at_targets (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (ht : at_targets p s.drones) :
    at_targets p (exec_coverage p s).drones := by
  intro i hi
  have hc : count (exec_coverage p s).drones = count s.drones := count_exec p s
  rw [hc] at hi
  have hw : Weighted (count s.drones - 1) (fun _ => p.eps)
      (scaled_error p.min p.max s.drones)
      (scaled_error p.min p.max (exec_coverage p s).drones) := scaled_error_step p s hn ha
  show scaled_error p.min p.max (exec_coverage p s).drones i = 0
  by_cases hl : i = count s.drones - 1
  · rw [hl]
    exact Eq.trans hw.right_end (ht (count s.drones - 1) (by omega))
  · by_cases h0 : i = 0
    · rw [h0]
      exact Eq.trans hw.left_end (ht 0 (by omega))
    · obtain ⟨j, hj⟩ : ∃ j : Nat, i = j + 1 := ⟨i - 1, by omega⟩
      subst hj
      have hy : scaled_error p.min p.max (exec_coverage p s).drones (j + 1)
          = scaled_error p.min p.max s.drones (j + 1)
            + p.eps * (scaled_error p.min p.max s.drones j
              - 2 * scaled_error p.min p.max s.drones (j + 1)
              + scaled_error p.min p.max s.drones (j + 2)) := hw.inner j (by omega)
      have z0 : scaled_error p.min p.max s.drones j = 0 := ht j (by omega)
      have z1 : scaled_error p.min p.max s.drones (j + 1) = 0 := ht (j + 1) (by omega)
      have z2 : scaled_error p.min p.max s.drones (j + 2) = 0 := ht (j + 2) (by omega)
      rw [hy, z0, z1, z2]
      grind

/-- 7.6 (i), for every weight: once at the targets, at the targets for ever. -/
theorem targets_fixed_sharp (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (k : Nat)
    (ht : at_targets p (protocol_step p s k).drones) (h : Nat) :
    at_targets p (protocol_step p s (k + h)).drones := by
  induction h with
  | zero => exact ht
  | succ h ih =>
    have hc : count (protocol_step p s (k + h)).drones = count s.drones :=
      count_step p s (k + h)
    exact exec_at_targets p (protocol_step p s (k + h)) (by omega)
      (anchored_step p s hn ha (k + h)) ih

end CordonMirror
