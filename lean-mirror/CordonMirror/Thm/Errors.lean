import CordonMirror.Thm.FixedPoint
import CordonMirror.Thm.Increasing
import CordonMirror.Thm.Arithmetic

/-! The scaled errors of a run of the spec: they are a run themselves, zero at both ends, and
the sum grows by those of drones 1 and N-2. -/

namespace CordonMirror

/-- `N - 1` times the error of drone `i` after `k` protocol steps. -/
def errors (p : Params) (s : State) (k i : Nat) : Rat :=
  scaled_error p.min p.max (protocol_step p s k).drones i

theorem error_first (p : Params) (x : DroneMap Rat) (h : get x 0 = p.min) :
    scaled_error p.min p.max x 0 = 0 := by
  have h0 : ((0 : Nat) : Rat) = 0 := rfl
  have he : scaled_error p.min p.max x 0
      = scaled_line (count x - 1) p.min p.max 0 + (-((count x - 1 : Nat) : Rat)) * get x 0 :=
    scaled_error_eq p.min p.max x 0
  rw [he, h]
  unfold scaled_line
  rw [h0]
  grind

theorem error_last (p : Params) (x : DroneMap Rat) (h : get x (count x - 1) = p.max) :
    scaled_error p.min p.max x (count x - 1) = 0 := by
  have he : scaled_error p.min p.max x (count x - 1)
      = scaled_line (count x - 1) p.min p.max (count x - 1)
        + (-((count x - 1 : Nat) : Rat)) * get x (count x - 1) :=
    scaled_error_eq p.min p.max x (count x - 1)
  rw [he, h]
  unfold scaled_line
  grind

theorem errors_run (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) : Run (count s.drones - 1) p.eps (errors p s) := by
  intro k
  have hc : count (protocol_step p s k).drones = count s.drones := count_step p s k
  have hw : Weighted (count (protocol_step p s k).drones - 1) (fun _ => p.eps)
      (scaled_error p.min p.max (protocol_step p s k).drones)
      (scaled_error p.min p.max (exec_coverage p (protocol_step p s k)).drones) :=
    scaled_error_step p (protocol_step p s k) (by omega) (anchored_step p s hn ha k)
  rw [hc] at hw
  have hs : Step (count s.drones - 1) p.eps
      (scaled_error p.min p.max (protocol_step p s k).drones)
      (scaled_error p.min p.max (exec_coverage p (protocol_step p s k)).drones) :=
    Weighted.step hw
  exact hs

theorem errors_first (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (k : Nat) : errors p s k 0 = 0 :=
  error_first p (protocol_step p s k).drones (anchored_step p s hn ha k).1

theorem errors_last (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (k : Nat) : errors p s k (count s.drones - 1) = 0 := by
  have hc : count (protocol_step p s k).drones = count s.drones := count_step p s k
  have h : scaled_error p.min p.max (protocol_step p s k).drones
      (count (protocol_step p s k).drones - 1) = 0 :=
    error_last p (protocol_step p s k).drones (anchored_step p s hn ha k).2
  rw [hc] at h
  exact h

theorem errors_all_nonneg (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1)
    (hu : upper_bounded p s.drones) (k i : Nat) (hi : i < count s.drones) :
    0 ≤ errors p s k i := by
  have hc : count (protocol_step p s k).drones = count s.drones := count_step p s k
  have hk : upper_bounded p (protocol_step p s k).drones :=
    upper_bound_sharp p s hn ha e0 e1 hu k
  exact hk i (by omega)

/-- The identity of 7.5 in errors: `(N-1) (c^{k+1} - c^k) = eps (e_1 + e_{N-2})`. -/
theorem sum_increment (p : Params) (s : State) (m : Nat) (hm : count s.drones = m + 2)
    (h1 : 1 ≤ m) (ha : anchored p s.drones) (k : Nat) :
    ((m : Rat) + 1)
        * (sum (protocol_step p s (k + 1)).drones - sum (protocol_step p s k).drones)
      = p.eps * (errors p s k 1 + errors p s k m) := by
  have hid : sum (protocol_step p s (k + 1)).drones - sum (protocol_step p s k).drones
      = p.eps * (gap (protocol_step p s k).drones m - gap (protocol_step p s k).drones 0) :=
    sum_identity p s m hm h1 ha k
  have hc : count (protocol_step p s k).drones = m + 2 := Eq.trans (count_step p s k) hm
  have hM : count (protocol_step p s k).drones - 1 = m + 1 := by omega
  have hak : anchored p (protocol_step p s k).drones := anchored_step p s (by omega) ha k
  have x0 : get (protocol_step p s k).drones 0 = p.min := hak.1
  have xl : get (protocol_step p s k).drones (m + 1) = p.max := by
    have h : get (protocol_step p s k).drones (count (protocol_step p s k).drones - 1) = p.max :=
      hak.2
    rw [hM] at h
    exact h
  have k0 : ((1 : Nat) : Rat) = 1 := rfl
  have k1 : ((m + 1 : Nat) : Rat) = (m : Rat) + 1 := cast_add_one m
  have u1 : errors p s k 1 = ((m : Rat) + 1) * p.min + (p.max - p.min)
      - ((m : Rat) + 1) * get (protocol_step p s k).drones 1 := by
    unfold errors
    rw [scaled_error_eq, hM]
    unfold scaled_line
    rw [k1, k0]
    grind
  have um : errors p s k m = ((m : Rat) + 1) * p.min + (m : Rat) * (p.max - p.min)
      - ((m : Rat) + 1) * get (protocol_step p s k).drones m := by
    unfold errors
    rw [scaled_error_eq, hM]
    unfold scaled_line
    rw [k1]
    grind
  have hg : gap (protocol_step p s k).drones m - gap (protocol_step p s k).drones 0
      = p.max - get (protocol_step p s k).drones m
        - (get (protocol_step p s k).drones 1 - p.min) := by
    have g1 : gap (protocol_step p s k).drones m
        = get (protocol_step p s k).drones (m + 1) - get (protocol_step p s k).drones m := rfl
    have g0 : gap (protocol_step p s k).drones 0
        = get (protocol_step p s k).drones 1 - get (protocol_step p s k).drones 0 := rfl
    rw [g1, g0, xl, x0]
  rw [hid, hg, u1, um]
  grind

end CordonMirror
