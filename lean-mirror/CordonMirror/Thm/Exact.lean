import CordonMirror.Thm.Errors

/-! Both bounds on the weight are exact: for every `eps > 1/2` some start violates 7.2, some
start violates 7.3; and at `eps = 0` the converse 7.6 (ii) is false. Divisions are avoided:
a spacing is an unknown that a multiple of it defines. -/

namespace CordonMirror

/-! ### 7.3 -/

/-- Every drone at its target, spacing `2 d`, but drone 1, which is `d` behind. -/
def late (lo d : Rat) (i : Nat) : Rat := if i = 1 then lo + d else lo + 2 * (i : Rat) * d

theorem late_one (lo d : Rat) : late lo d 1 = lo + d := by
  unfold late
  exact if_pos rfl

theorem late_other (lo d : Rat) (i : Nat) (h : ¬ (i = 1)) :
    late lo d i = lo + 2 * (i : Rat) * d := by
  unfold late
  exact if_neg h

theorem late_zero (lo d : Rat) : late lo d 0 = lo := by
  have h0 : ((0 : Nat) : Rat) = 0 := rfl
  have h : late lo d 0 = lo + 2 * ((0 : Nat) : Rat) * d := late_other lo d 0 (by omega)
  rw [h0] at h
  grind

theorem late_two (lo d : Rat) : late lo d 2 = lo + 4 * d := by
  have h2 : ((2 : Nat) : Rat) = 2 := by grind
  have h : late lo d 2 = lo + 2 * ((2 : Nat) : Rat) * d := late_other lo d 2 (by omega)
  rw [h2] at h
  grind

/-- That start, for `m + 2` drones. -/
def late_start (p : Params) (m : Nat) (d : Rat) : State :=
  State.mk (lambda (m + 2) (late p.min d)) 0

theorem count_late (p : Params) (m : Nat) (d : Rat) :
    count (late_start p m d).drones = m + 2 := count_lambda (m + 2) (late p.min d)

theorem get_late (p : Params) (m : Nat) (d : Rat) (i : Nat) (h : i < m + 2) :
    get (late_start p m d).drones i = late p.min d i := get_lambda (m + 2) (late p.min d) i h

theorem late_anchored (p : Params) (m : Nat) (d : Rat) (h1 : 1 ≤ m)
    (hd : 2 * ((m : Rat) + 1) * d = p.max - p.min) : anchored p (late_start p m d).drones := by
  have hc : count (late_start p m d).drones = m + 2 := count_late p m d
  have k1 : ((m + 1 : Nat) : Rat) = (m : Rat) + 1 := cast_add_one m
  have g0 : get (late_start p m d).drones 0 = p.min :=
    Eq.trans (get_late p m d 0 (by omega)) (late_zero p.min d)
  have gl : get (late_start p m d).drones (m + 1) = p.max := by
    have h : late p.min d (m + 1) = p.min + 2 * ((m + 1 : Nat) : Rat) * d :=
      late_other p.min d (m + 1) (by omega)
    rw [k1] at h
    have hg : get (late_start p m d).drones (m + 1) = late p.min d (m + 1) :=
      get_late p m d (m + 1) (by omega)
    grind
  have hM : count (late_start p m d).drones - 1 = m + 1 := by omega
  refine And.intro g0 ?_
  rw [hM]
  exact gl

theorem late_ordered (p : Params) (m : Nat) (d : Rat) (h0 : 0 < d) :
    ordered (late_start p m d).drones := by
  intro i hi
  have hc : count (late_start p m d).drones = m + 2 := count_late p m d
  have ga : get (late_start p m d).drones i = late p.min d i := get_late p m d i (by omega)
  have gb : get (late_start p m d).drones (i + 1) = late p.min d (i + 1) :=
    get_late p m d (i + 1) (by omega)
  rw [ga, gb]
  by_cases hz : i = 0
  · subst hz
    have a : late p.min d 0 = p.min := late_zero p.min d
    have b : late p.min d (0 + 1) = p.min + d := late_one p.min d
    grind
  · by_cases ho : i = 1
    · subst ho
      have a : late p.min d 1 = p.min + d := late_one p.min d
      have b : late p.min d (1 + 1) = p.min + 4 * d := late_two p.min d
      grind
    · have a : late p.min d i = p.min + 2 * (i : Rat) * d := late_other p.min d i ho
      have b : late p.min d (i + 1) = p.min + 2 * ((i + 1 : Nat) : Rat) * d :=
        late_other p.min d (i + 1) (by omega)
      have k1 : ((i + 1 : Nat) : Rat) = (i : Rat) + 1 := cast_add_one i
      rw [k1] at b
      grind

/-- The scaled error of drone `i` there: only drone 1 has one. -/
theorem late_error (p : Params) (m : Nat) (d : Rat)
    (hd : 2 * ((m : Rat) + 1) * d = p.max - p.min) (i : Nat) (hi : i < m + 2) :
    scaled_error p.min p.max (late_start p m d).drones i
      = ((m : Rat) + 1) * (p.min + 2 * (i : Rat) * d - late p.min d i) := by
  have hc : count (late_start p m d).drones = m + 2 := count_late p m d
  have hM : count (late_start p m d).drones - 1 = m + 1 := by omega
  have k1 : ((m + 1 : Nat) : Rat) = (m : Rat) + 1 := cast_add_one m
  have hg : get (late_start p m d).drones i = late p.min d i := get_late p m d i hi
  rw [scaled_error_eq, hM, hg]
  unfold scaled_line
  rw [k1, ← hd]
  grind

theorem late_upper_bounded (p : Params) (m : Nat) (d : Rat) (h0 : 0 < d)
    (hd : 2 * ((m : Rat) + 1) * d = p.max - p.min) :
    upper_bounded p (late_start p m d).drones := by
  intro i hi
  have hc : count (late_start p m d).drones = m + 2 := count_late p m d
  have he := late_error p m d hd i (by omega)
  have mpos : (0 : Rat) ≤ (m : Rat) := Rat.natCast_nonneg
  rw [he]
  by_cases ho : i = 1
  · subst ho
    have a : late p.min d 1 = p.min + d := late_one p.min d
    have k : ((1 : Nat) : Rat) = 1 := rfl
    rw [a, k]
    exact Rat.mul_nonneg (by grind) (by grind)
  · have a : late p.min d i = p.min + 2 * (i : Rat) * d := late_other p.min d i ho
    rw [a]
    exact Rat.mul_nonneg (by grind) (by grind)

/-- 7.3 is exact: `N ≥ 3`, any `eps > 1/2`, any segment. -/
theorem upper_bound_exact (p : Params) (N : Nat) (hN : 3 ≤ N) (hs : p.min < p.max)
    (he : 1 < 2 * p.eps) :
    ∃ s : State, count s.drones = N ∧ anchored p s.drones ∧ ordered s.drones ∧
      upper_bounded p s.drones ∧ ¬ upper_bounded p (exec_coverage p s).drones := by
  obtain ⟨m, hm⟩ : ∃ m : Nat, N = m + 2 := ⟨N - 2, by omega⟩
  subst hm
  have mpos : (0 : Rat) ≤ (m : Rat) := Rat.natCast_nonneg
  have cpos : 0 < 2 * ((m : Rat) + 1) := by grind
  obtain ⟨d, hd⟩ := exists_quotient (2 * ((m : Rat) + 1)) (p.max - p.min) cpos
  have h0 : 0 < d := pos_of_scaled (2 * ((m : Rat) + 1)) d cpos (by grind)
  have hc : count (late_start p m d).drones = m + 2 := count_late p m d
  refine Exists.intro (late_start p m d) ?_
  refine And.intro hc ?_
  refine And.intro (late_anchored p m d (by omega) hd) ?_
  refine And.intro (late_ordered p m d h0) ?_
  refine And.intro (late_upper_bounded p m d h0 hd) ?_
  intro hu
  have hce : count (exec_coverage p (late_start p m d)).drones = m + 2 :=
    Eq.trans (count_exec p (late_start p m d)) hc
  have hM : count (exec_coverage p (late_start p m d)).drones - 1 = m + 1 := by omega
  have hu1 : 0 ≤ scaled_error p.min p.max (exec_coverage p (late_start p m d)).drones 1 :=
    hu 1 (by omega)
  have x1 : get (exec_coverage p (late_start p m d)).drones 1
      = p.eps * get (late_start p m d).drones 0
        + (1 - 2 * p.eps) * get (late_start p m d).drones 1
        + p.eps * get (late_start p m d).drones 2 :=
    Eq.trans (get_exec p (late_start p m d) 1 (by omega))
      (update_inner p (count (late_start p m d).drones) 0 (get (late_start p m d).drones)
        (by omega))
  have y0 : get (late_start p m d).drones 0 = p.min :=
    Eq.trans (get_late p m d 0 (by omega)) (late_zero p.min d)
  have y1 : get (late_start p m d).drones 1 = p.min + d :=
    Eq.trans (get_late p m d 1 (by omega)) (late_one p.min d)
  have y2 : get (late_start p m d).drones 2 = p.min + 4 * d :=
    Eq.trans (get_late p m d 2 (by omega)) (late_two p.min d)
  have k1 : ((m + 1 : Nat) : Rat) = (m : Rat) + 1 := cast_add_one m
  have k0 : ((1 : Nat) : Rat) = 1 := rfl
  rw [scaled_error_eq, hM, x1, y0, y1, y2] at hu1
  unfold scaled_line at hu1
  rw [k1, k0, ← hd] at hu1
  have hpos : 0 < ((m : Rat) + 1) * ((2 * p.eps - 1) * d) :=
    Rat.mul_pos (by grind) (Rat.mul_pos (by grind) h0)
  grind

/-! ### 7.2 -/

/-- Two crowds, at the two ends, with gaps `d` between their members. -/
def crowds (lo up d : Rat) (m i : Nat) : Rat :=
  if i ≤ 1 then lo + (i : Rat) * d else up - ((m : Rat) + 1 - (i : Rat)) * d

theorem crowds_left (lo up d : Rat) (m i : Nat) (h : i ≤ 1) :
    crowds lo up d m i = lo + (i : Rat) * d := by
  unfold crowds
  exact if_pos h

theorem crowds_right (lo up d : Rat) (m i : Nat) (h : ¬ (i ≤ 1)) :
    crowds lo up d m i = up - ((m : Rat) + 1 - (i : Rat)) * d := by
  unfold crowds
  exact if_neg h

def crowds_start (p : Params) (m : Nat) (d : Rat) : State :=
  State.mk (lambda (m + 2) (crowds p.min p.max d m)) 0

theorem count_crowds (p : Params) (m : Nat) (d : Rat) :
    count (crowds_start p m d).drones = m + 2 := count_lambda (m + 2) (crowds p.min p.max d m)

theorem get_crowds (p : Params) (m : Nat) (d : Rat) (i : Nat) (h : i < m + 2) :
    get (crowds_start p m d).drones i = crowds p.min p.max d m i :=
  get_lambda (m + 2) (crowds p.min p.max d m) i h

theorem crowds_zero (p : Params) (m : Nat) (d : Rat) :
    get (crowds_start p m d).drones 0 = p.min := by
  have k : ((0 : Nat) : Rat) = 0 := rfl
  have hg : get (crowds_start p m d).drones 0 = crowds p.min p.max d m 0 :=
    get_crowds p m d 0 (by omega)
  have hx : crowds p.min p.max d m 0 = p.min + ((0 : Nat) : Rat) * d :=
    crowds_left p.min p.max d m 0 (by omega)
  rw [k] at hx
  grind

theorem crowds_one (p : Params) (m : Nat) (d : Rat) :
    get (crowds_start p m d).drones 1 = p.min + d := by
  have k : ((1 : Nat) : Rat) = 1 := rfl
  have hg : get (crowds_start p m d).drones 1 = crowds p.min p.max d m 1 :=
    get_crowds p m d 1 (by omega)
  have hx : crowds p.min p.max d m 1 = p.min + ((1 : Nat) : Rat) * d :=
    crowds_left p.min p.max d m 1 (by omega)
  rw [k] at hx
  grind

theorem crowds_two (p : Params) (m : Nat) (d : Rat) (h : 2 < m + 2) :
    get (crowds_start p m d).drones 2 = p.max - ((m : Rat) - 1) * d := by
  have k : ((2 : Nat) : Rat) = 2 := by grind
  have hg : get (crowds_start p m d).drones 2 = crowds p.min p.max d m 2 :=
    get_crowds p m d 2 h
  have hx : crowds p.min p.max d m 2 = p.max - ((m : Rat) + 1 - ((2 : Nat) : Rat)) * d :=
    crowds_right p.min p.max d m 2 (by omega)
  rw [k] at hx
  grind

theorem crowds_three (p : Params) (m : Nat) (d : Rat) (h : 3 < m + 2) :
    get (crowds_start p m d).drones 3 = p.max - ((m : Rat) - 2) * d := by
  have k : ((3 : Nat) : Rat) = 3 := by grind
  have hg : get (crowds_start p m d).drones 3 = crowds p.min p.max d m 3 :=
    get_crowds p m d 3 h
  have hx : crowds p.min p.max d m 3 = p.max - ((m : Rat) + 1 - ((3 : Nat) : Rat)) * d :=
    crowds_right p.min p.max d m 3 (by omega)
  rw [k] at hx
  grind

theorem crowds_anchored (p : Params) (m : Nat) (d : Rat) (h1 : 1 ≤ m) :
    anchored p (crowds_start p m d).drones := by
  have hc : count (crowds_start p m d).drones = m + 2 := count_crowds p m d
  have hM : count (crowds_start p m d).drones - 1 = m + 1 := by omega
  have k1 : ((m + 1 : Nat) : Rat) = (m : Rat) + 1 := cast_add_one m
  refine And.intro (crowds_zero p m d) ?_
  rw [hM]
  have hg : get (crowds_start p m d).drones (m + 1) = crowds p.min p.max d m (m + 1) :=
    get_crowds p m d (m + 1) (by omega)
  have hx : crowds p.min p.max d m (m + 1)
      = p.max - ((m : Rat) + 1 - ((m + 1 : Nat) : Rat)) * d :=
    crowds_right p.min p.max d m (m + 1) (by omega)
  rw [k1] at hx
  grind

theorem crowds_ordered (p : Params) (m : Nat) (d : Rat) (h0 : 0 < d)
    (hw : 0 < p.max - p.min - (m : Rat) * d) : ordered (crowds_start p m d).drones := by
  intro i hi
  have hc : count (crowds_start p m d).drones = m + 2 := count_crowds p m d
  by_cases hz : i = 0
  · subst hz
    have a : get (crowds_start p m d).drones 0 = p.min := crowds_zero p m d
    have b : get (crowds_start p m d).drones (0 + 1) = p.min + d := crowds_one p m d
    grind
  · by_cases ho : i = 1
    · subst ho
      have a : get (crowds_start p m d).drones 1 = p.min + d := crowds_one p m d
      have b : get (crowds_start p m d).drones (1 + 1) = p.max - ((m : Rat) - 1) * d :=
        crowds_two p m d (by omega)
      grind
    · have ga : get (crowds_start p m d).drones i = crowds p.min p.max d m i :=
        get_crowds p m d i (by omega)
      have gb : get (crowds_start p m d).drones (i + 1) = crowds p.min p.max d m (i + 1) :=
        get_crowds p m d (i + 1) (by omega)
      have a : crowds p.min p.max d m i = p.max - ((m : Rat) + 1 - (i : Rat)) * d :=
        crowds_right p.min p.max d m i (by omega)
      have b : crowds p.min p.max d m (i + 1)
          = p.max - ((m : Rat) + 1 - ((i + 1 : Nat) : Rat)) * d :=
        crowds_right p.min p.max d m (i + 1) (by omega)
      have k1 : ((i + 1 : Nat) : Rat) = (i : Rat) + 1 := cast_add_one i
      rw [k1] at b
      grind

/-- 7.2 is exact: `N ≥ 4`, any `eps > 1/2`, any segment: an ordered start that crosses. -/
theorem ordering_exact (p : Params) (N : Nat) (hN : 4 ≤ N) (hs : p.min < p.max)
    (he : 1 < 2 * p.eps) :
    ∃ s : State, count s.drones = N ∧ anchored p s.drones ∧ ordered s.drones ∧
      get (exec_coverage p s).drones 2 < get (exec_coverage p s).drones 1 := by
  obtain ⟨m, hm⟩ : ∃ m : Nat, N = m + 2 := ⟨N - 2, by omega⟩
  subst hm
  have mpos : (0 : Rat) ≤ (m : Rat) := Rat.natCast_nonneg
  have e1 : 0 < 2 * p.eps - 1 := by grind
  have pm : 0 ≤ (2 * p.eps - 1) * (m : Rat) := Rat.mul_nonneg (Rat.le_of_lt e1) mpos
  have cpos : 0 < 2 * (2 * p.eps + (2 * p.eps - 1) * (m : Rat)) := by grind
  have wpos : 0 < (2 * p.eps - 1) * (p.max - p.min) := Rat.mul_pos e1 (by grind)
  obtain ⟨d, hd⟩ := exists_quotient (2 * (2 * p.eps + (2 * p.eps - 1) * (m : Rat)))
    ((2 * p.eps - 1) * (p.max - p.min)) cpos
  have h0 : 0 < d :=
    pos_of_scaled (2 * (2 * p.eps + (2 * p.eps - 1) * (m : Rat))) d cpos (by grind)
  have hkey : 2 * p.eps * d < (2 * p.eps - 1) * (p.max - p.min - (m : Rat) * d) := by grind
  have hed : 0 < 2 * p.eps * d := Rat.mul_pos (by grind) h0
  have hw : 0 < p.max - p.min - (m : Rat) * d :=
    pos_of_scaled (2 * p.eps - 1) (p.max - p.min - (m : Rat) * d) e1 (by grind)
  have hc : count (crowds_start p m d).drones = m + 2 := count_crowds p m d
  refine Exists.intro (crowds_start p m d) ?_
  refine And.intro hc ?_
  refine And.intro (crowds_anchored p m d (by omega)) ?_
  refine And.intro (crowds_ordered p m d h0 hw) ?_
  have x1 : get (exec_coverage p (crowds_start p m d)).drones 1
      = p.eps * get (crowds_start p m d).drones 0
        + (1 - 2 * p.eps) * get (crowds_start p m d).drones 1
        + p.eps * get (crowds_start p m d).drones 2 :=
    Eq.trans (get_exec p (crowds_start p m d) 1 (by omega))
      (update_inner p (count (crowds_start p m d).drones) 0 (get (crowds_start p m d).drones)
        (by omega))
  have x2 : get (exec_coverage p (crowds_start p m d)).drones 2
      = p.eps * get (crowds_start p m d).drones 1
        + (1 - 2 * p.eps) * get (crowds_start p m d).drones 2
        + p.eps * get (crowds_start p m d).drones 3 :=
    Eq.trans (get_exec p (crowds_start p m d) 2 (by omega))
      (update_inner p (count (crowds_start p m d).drones) 1 (get (crowds_start p m d).drones)
        (by omega))
  have y0 : get (crowds_start p m d).drones 0 = p.min := crowds_zero p m d
  have y1 : get (crowds_start p m d).drones 1 = p.min + d := crowds_one p m d
  have y2 : get (crowds_start p m d).drones 2 = p.max - ((m : Rat) - 1) * d :=
    crowds_two p m d (by omega)
  have y3 : get (crowds_start p m d).drones 3 = p.max - ((m : Rat) - 2) * d :=
    crowds_three p m d (by omega)
  rw [x1, x2, y0, y1, y2, y3]
  grind

/-! ### 7.6 (ii) at `eps = 0` -/

/-- At `eps = 0` the sum of any swarm stays. -/
theorem sum_zero_weight (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (he : p.eps = 0) (k : Nat) :
    sum (protocol_step p s k).drones = sum s.drones := by
  obtain ⟨m, hm⟩ : ∃ m : Nat, count s.drones = m + 2 := ⟨count s.drones - 2, by omega⟩
  induction k with
  | zero => rfl
  | succ k ih =>
    have hid := sum_identity p s m hm (by omega) ha k
    rw [he] at hid
    grind

/-- 7.6 (ii) is false at `eps = 0`, for every `N ≥ 3` and every segment. -/
theorem constant_sum_zero_weight (p : Params) (N : Nat) (hN : 3 ≤ N) (hs : p.min < p.max)
    (he : p.eps = 0) :
    ∃ s : State, count s.drones = N ∧ anchored p s.drones ∧ ordered s.drones ∧
      upper_bounded p s.drones ∧
      (∀ k : Nat, sum (protocol_step p s k).drones = sum s.drones) ∧
      ¬ at_targets p s.drones := by
  obtain ⟨m, hm⟩ : ∃ m : Nat, N = m + 2 := ⟨N - 2, by omega⟩
  subst hm
  have mpos : (0 : Rat) ≤ (m : Rat) := Rat.natCast_nonneg
  have cpos : 0 < 2 * ((m : Rat) + 1) := by grind
  obtain ⟨d, hd⟩ := exists_quotient (2 * ((m : Rat) + 1)) (p.max - p.min) cpos
  have h0 : 0 < d := pos_of_scaled (2 * ((m : Rat) + 1)) d cpos (by grind)
  have hc : count (late_start p m d).drones = m + 2 := count_late p m d
  have ha : anchored p (late_start p m d).drones := late_anchored p m d (by omega) hd
  refine Exists.intro (late_start p m d) ?_
  refine And.intro hc ?_
  refine And.intro ha ?_
  refine And.intro (late_ordered p m d h0) ?_
  refine And.intro (late_upper_bounded p m d h0 hd) ?_
  refine And.intro (sum_zero_weight p (late_start p m d) (by omega) ha he) ?_
  intro ht
  have ht1 : scaled_error p.min p.max (late_start p m d).drones 1 = 0 := ht 1 (by omega)
  have h1 : scaled_error p.min p.max (late_start p m d).drones 1
      = ((m : Rat) + 1) * (p.min + 2 * ((1 : Nat) : Rat) * d - late p.min d 1) :=
    late_error p m d hd 1 (by omega)
  have a : late p.min d 1 = p.min + d := late_one p.min d
  have k : ((1 : Nat) : Rat) = 1 := rfl
  rw [a, k] at h1
  have hpos : 0 < ((m : Rat) + 1) * d := Rat.mul_pos (by grind) h0
  grind

end CordonMirror
