import CordonMirror.Thm.Errors

/-! Theorems 7.5 (ii), 7.6 (ii) and 7.7 on the spec. -/

namespace CordonMirror

/-- 7.5 (ii), for every weight. -/
theorem sum_stationary_sharp (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (k : Nat) (ht : at_targets p (protocol_step p s k).drones) :
    sum (protocol_step p s (k + 1)).drones = sum (protocol_step p s k).drones := by
  obtain ⟨m, hm⟩ : ∃ m : Nat, count s.drones = m + 2 := ⟨count s.drones - 2, by omega⟩
  have hc : count (protocol_step p s k).drones = count s.drones := count_step p s k
  have hi := sum_increment p s m hm (by omega) ha k
  have z1 : errors p s k 1 = 0 := ht 1 (by omega)
  have zm : errors p s k m = 0 := ht m (by omega)
  have mpos : (0 : Rat) ≤ (m : Rat) := Rat.natCast_nonneg
  rw [z1, zm] at hi
  have hz : ((m : Rat) + 1)
      * (sum (protocol_step p s (k + 1)).drones - sum (protocol_step p s k).drones) = 0 := by
    rw [hi]
    grind
  have hd : sum (protocol_step p s (k + 1)).drones - sum (protocol_step p s k).drones = 0 :=
    zero_of_scaled ((m : Rat) + 1)
      (sum (protocol_step p s (k + 1)).drones - sum (protocol_step p s k).drones)
      (by grind) hz
  grind

/-- 7.6 (i) as printed: once at the targets, the sum stays. -/
theorem targets_fixed_sum (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (k : Nat) (ht : at_targets p (protocol_step p s k).drones)
    (h : Nat) : sum (protocol_step p s (k + h)).drones = sum (protocol_step p s k).drones := by
  induction h with
  | zero => rfl
  | succ h ih =>
    have hs : sum (protocol_step p s (k + h + 1)).drones = sum (protocol_step p s (k + h)).drones :=
      sum_stationary_sharp p s hn ha (k + h) (targets_fixed_sharp p s hn ha k ht h)
    exact Eq.trans hs ih

/-! ### How far an error is from the ends -/

/-- How many drones from the nearer end drone `i` of `N` stands: `min(i, N-1-i)`. -/
def depth (N i : Nat) : Nat := if i ≤ N - 1 - i then i else N - 1 - i

theorem depth_left (N i : Nat) (h : i ≤ N - 1 - i) : depth N i = i := by
  unfold depth
  exact if_pos h

theorem depth_right (N i : Nat) (h : ¬ (i ≤ N - 1 - i)) : depth N i = N - 1 - i := by
  unfold depth
  exact if_neg h

theorem depth_le_left (N i : Nat) : depth N i ≤ i := by
  by_cases h : i ≤ N - 1 - i
  · have hd : depth N i = i := depth_left N i h
    omega
  · have hd : depth N i = N - 1 - i := depth_right N i h
    omega

theorem depth_le_right (N i : Nat) : depth N i ≤ N - 1 - i := by
  by_cases h : i ≤ N - 1 - i
  · have hd : depth N i = i := depth_left N i h
    omega
  · have hd : depth N i = N - 1 - i := depth_right N i h
    omega

/-- An error reaches drone 1 from drone `h + 1`, in powers of the weight. -/
theorem reach_left (M : Nat) (e : Rat) (E : Nat → Nat → Rat) (e0 : 0 < e) (e1 : 2 * e ≤ 1)
    (hE : Run M e E) (hpos : ∀ k i : Nat, i ≤ M → 0 ≤ E k i) (k h : Nat) (hh : h + 1 < M) :
    e ^ h * E k (h + 1) ≤ E (k + h) 1 := by
  have hs : e ^ h * E k (0 + 1 + h) ≤ E (k + h) (0 + 1) :=
    spread M e E (Rat.le_of_lt e0) e1 hE hpos h k 0 (by omega)
  have ix : 0 + 1 + h = h + 1 := by omega
  rw [ix] at hs
  exact hs

/-- The mirror image. -/
theorem reach_right (m : Nat) (e : Rat) (E : Nat → Nat → Rat) (e0 : 0 < e) (e1 : 2 * e ≤ 1)
    (hE : Run (m + 1) e E) (hpos : ∀ k i : Nat, i ≤ m + 1 → 0 ≤ E k i) (k h : Nat)
    (hh : h < m) : e ^ h * E k (m - h) ≤ E (k + h) m := by
  have hs : e ^ h * E k (m + 1 - (h + 1)) ≤ E (k + h) (m + 1 - 1) :=
    reach_left (m + 1) e (fun l i => E l (m + 1 - i)) e0 e1 (Run.mirror hE)
      (fun l i _ => hpos l (m + 1 - i) (by omega)) k h (by omega)
  have i1 : m + 1 - (h + 1) = m - h := by omega
  have i2 : m + 1 - 1 = m := by omega
  rw [i1, i2] at hs
  exact hs

/-- 7.7 on error sequences: what the sum gains is zero before step `h` and positive then. -/
theorem first_gain (m : Nat) (e : Rat) (E : Nat → Nat → Rat) (h1 : 1 ≤ m) (e0 : 0 < e)
    (e1 : 2 * e ≤ 1) (hE : Run (m + 1) e E) (hend : ∀ k : Nat, E k 0 = 0)
    (hlast : ∀ k : Nat, E k (m + 1) = 0) (hpos : ∀ k i : Nat, i ≤ m + 1 → 0 ≤ E k i)
    (k h j : Nat) (hj : j < m + 2) (hoff : ¬ (E k j = 0)) (hd : depth (m + 2) j = h + 1)
    (hleast : ∀ i : Nat, i < m + 2 → ¬ (E k i = 0) → h + 1 ≤ depth (m + 2) i) :
    (∀ t : Nat, t < h → E (k + t) 1 + E (k + t) m = 0) ∧ 0 < E (k + h) 1 + E (k + h) m := by
  have jl : depth (m + 2) j ≤ j := depth_le_left (m + 2) j
  have jr : depth (m + 2) j ≤ m + 2 - 1 - j := depth_le_right (m + 2) j
  refine And.intro ?_ ?_
  · intro t ht
    have hon : ∀ i : Nat, i ≤ h → E k i = 0 := by
      intro i hi
      refine Classical.byContradiction fun hne => ?_
      have hl : h + 1 ≤ depth (m + 2) i := hleast i (by omega) hne
      have hl2 : depth (m + 2) i ≤ i := depth_le_left (m + 2) i
      omega
    have hon2 : ∀ i : Nat, i ≤ h → E k (m + 1 - i) = 0 := by
      intro i hi
      refine Classical.byContradiction fun hne => ?_
      have hl : h + 1 ≤ depth (m + 2) (m + 1 - i) := hleast (m + 1 - i) (by omega) hne
      have hl2 : depth (m + 2) (m + 1 - i) ≤ m + 2 - 1 - (m + 1 - i) :=
        depth_le_right (m + 2) (m + 1 - i)
      omega
    have hlast0 : ∀ l : Nat, E l (m + 1 - 0) = 0 := by
      intro l
      have hz : m + 1 - 0 = m + 1 := by omega
      rw [hz]
      exact hlast l
    have q1 : E (k + t) 1 = 0 :=
      quiet (m + 1) e E hE hend h k (by omega) hon t 1 (by omega)
    have q2 : E (k + t) (m + 1 - 1) = 0 :=
      quiet (m + 1) e (fun l i => E l (m + 1 - i)) (Run.mirror hE) hlast0 h k (by omega) hon2 t 1
        (by omega)
    have i2 : m + 1 - 1 = m := by omega
    rw [i2] at q2
    grind
  · have p1 : 0 ≤ E (k + h) 1 := hpos (k + h) 1 (by omega)
    have pm : 0 ≤ E (k + h) m := hpos (k + h) m (by omega)
    have pj : 0 ≤ E k j := hpos k j (by omega)
    have sj : 0 < E k j := Rat.lt_of_le_of_ne pj (fun h0 => hoff (Eq.symm h0))
    have pe : 0 < e ^ h := Rat.pow_pos e0
    have pp : 0 < e ^ h * E k j := Rat.mul_pos pe sj
    by_cases hc : j ≤ m + 2 - 1 - j
    · have hdj : depth (m + 2) j = j := depth_left (m + 2) j hc
      have hj2 : h + 1 = j := by omega
      have hr : e ^ h * E k (h + 1) ≤ E (k + h) 1 :=
        reach_left (m + 1) e E e0 e1 hE hpos k h (by omega)
      rw [hj2] at hr
      grind
    · have hdj : depth (m + 2) j = m + 2 - 1 - j := depth_right (m + 2) j hc
      have hj2 : m - h = j := by omega
      have hr : e ^ h * E k (m - h) ≤ E (k + h) m :=
        reach_right m e E e0 e1 hE hpos k h (by omega)
      rw [hj2] at hr
      grind

/-- 7.7, exact: `h + 1` is the least depth of an off-target drone. -/
theorem increasing_sharp (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 < p.eps) (e1 : 2 * p.eps ≤ 1)
    (hu : upper_bounded p s.drones) (k h j : Nat) (hj : j < count s.drones)
    (hoff : ¬ at_target p (protocol_step p s k).drones j)
    (hd : depth (count s.drones) j = h + 1)
    (hleast : ∀ i : Nat, i < count s.drones → ¬ at_target p (protocol_step p s k).drones i →
      h + 1 ≤ depth (count s.drones) i) :
    (∀ t : Nat, t ≤ h →
      sum (protocol_step p s (k + t)).drones = sum (protocol_step p s k).drones) ∧
    sum (protocol_step p s (k + h)).drones < sum (protocol_step p s (k + h + 1)).drones := by
  obtain ⟨m, hm⟩ : ∃ m : Nat, count s.drones = m + 2 := ⟨count s.drones - 2, by omega⟩
  have hm1 : count s.drones - 1 = m + 1 := by omega
  have hE : Run (m + 1) p.eps (errors p s) := by
    have h0 : Run (count s.drones - 1) p.eps (errors p s) := errors_run p s hn ha
    rw [hm1] at h0
    exact h0
  have hlast : ∀ l : Nat, errors p s l (m + 1) = 0 := by
    intro l
    have h0 : errors p s l (count s.drones - 1) = 0 := errors_last p s hn ha l
    rw [hm1] at h0
    exact h0
  have hpos : ∀ l i : Nat, i ≤ m + 1 → 0 ≤ errors p s l i :=
    fun l i hi => errors_all_nonneg p s hn ha (Rat.le_of_lt e0) e1 hu l i (by omega)
  have mpos : (0 : Rat) ≤ (m : Rat) := Rat.natCast_nonneg
  have mpos1 : (0 : Rat) < (m : Rat) + 1 := by grind
  rw [hm] at hj hd hleast
  have hg : (∀ t : Nat, t < h → errors p s (k + t) 1 + errors p s (k + t) m = 0) ∧
      0 < errors p s (k + h) 1 + errors p s (k + h) m :=
    first_gain m p.eps (errors p s) (by omega) e0 e1 hE (errors_first p s hn ha) hlast hpos
      k h j hj hoff hd hleast
  have hstep : ∀ t : Nat, t < h →
      sum (protocol_step p s (k + t + 1)).drones = sum (protocol_step p s (k + t)).drones := by
    intro t ht
    have hi := sum_increment p s m hm (by omega) ha (k + t)
    have hz : errors p s (k + t) 1 + errors p s (k + t) m = 0 := hg.1 t ht
    rw [hz] at hi
    have hz2 : ((m : Rat) + 1)
        * (sum (protocol_step p s (k + t + 1)).drones - sum (protocol_step p s (k + t)).drones)
        = 0 := by
      rw [hi]
      grind
    have hd0 := zero_of_scaled ((m : Rat) + 1)
      (sum (protocol_step p s (k + t + 1)).drones - sum (protocol_step p s (k + t)).drones)
      mpos1 hz2
    grind
  refine And.intro ?_ ?_
  · intro t
    induction t with
    | zero =>
      intro _
      rfl
    | succ t ih =>
      intro ht
      have h0 : sum (protocol_step p s (k + t)).drones = sum (protocol_step p s k).drones :=
        ih (by omega)
      exact Eq.trans (hstep t (by omega)) h0
  · have hi := sum_increment p s m hm (by omega) ha (k + h)
    have hp : 0 < p.eps * (errors p s (k + h) 1 + errors p s (k + h) m) := Rat.mul_pos e0 hg.2
    rw [← hi] at hp
    have hd0 := pos_of_scaled ((m : Rat) + 1)
      (sum (protocol_step p s (k + h + 1)).drones - sum (protocol_step p s (k + h)).drones)
      mpos1 hp
    grind

/-- 7.6 (ii), sharp and bounded: `ceil((N-2)/2) = (N-1)/2` equal sums are enough. -/
theorem constant_sum_bounded (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 < p.eps) (e1 : 2 * p.eps ≤ 1)
    (hu : upper_bounded p s.drones) (k : Nat)
    (hc : ∀ h : Nat, 1 ≤ h → h ≤ (count s.drones - 1) / 2 →
      sum (protocol_step p s (k + h)).drones = sum (protocol_step p s k).drones) :
    at_targets p (protocol_step p s k).drones := by
  obtain ⟨m, hm⟩ : ∃ m : Nat, count s.drones = m + 2 := ⟨count s.drones - 2, by omega⟩
  have hm1 : count s.drones - 1 = m + 1 := by omega
  rw [hm1] at hc
  have hE : Run (m + 1) p.eps (errors p s) := by
    have h0 : Run (count s.drones - 1) p.eps (errors p s) := errors_run p s hn ha
    rw [hm1] at h0
    exact h0
  have hpos : ∀ l i : Nat, i ≤ m + 1 → 0 ≤ errors p s l i :=
    fun l i hi => errors_all_nonneg p s hn ha (Rat.le_of_lt e0) e1 hu l i (by omega)
  have hall : ∀ h : Nat, h ≤ (m + 1) / 2 →
      sum (protocol_step p s (k + h)).drones = sum (protocol_step p s k).drones := by
    intro h hh
    by_cases hz : h = 0
    · subst hz
      rfl
    · exact hc h (by omega) hh
  have hquiet : ∀ h : Nat, h + 1 ≤ (m + 1) / 2 →
      errors p s (k + h) 1 + errors p s (k + h) m = 0 := by
    intro h hh
    have hi := sum_increment p s m hm (by omega) ha (k + h)
    have s0 : sum (protocol_step p s (k + h)).drones = sum (protocol_step p s k).drones :=
      hall h (by omega)
    have s1 : sum (protocol_step p s (k + h + 1)).drones = sum (protocol_step p s k).drones :=
      hall (h + 1) hh
    rw [s0, s1] at hi
    have hz : p.eps * (errors p s (k + h) 1 + errors p s (k + h) m) = 0 := by
      rw [← hi]
      grind
    exact zero_of_scaled p.eps (errors p s (k + h) 1 + errors p s (k + h) m) e0 hz
  have hleft : ∀ h : Nat, h + 1 ≤ (m + 1) / 2 → errors p s k (h + 1) = 0 := by
    intro h hh
    have hr : p.eps ^ h * errors p s k (h + 1) ≤ errors p s (k + h) 1 :=
      reach_left (m + 1) p.eps (errors p s) e0 e1 hE hpos k h (by omega)
    have hq := hquiet h hh
    have pm : 0 ≤ errors p s (k + h) m := hpos (k + h) m (by omega)
    have pj : 0 ≤ errors p s k (h + 1) := hpos k (h + 1) (by omega)
    have pe : 0 < p.eps ^ h := Rat.pow_pos e0
    have pp : 0 ≤ p.eps ^ h * errors p s k (h + 1) := Rat.mul_nonneg (Rat.le_of_lt pe) pj
    have hz : p.eps ^ h * errors p s k (h + 1) = 0 := by grind
    exact zero_of_scaled (p.eps ^ h) (errors p s k (h + 1)) pe hz
  have hright : ∀ h : Nat, h + 1 ≤ (m + 1) / 2 → errors p s k (m - h) = 0 := by
    intro h hh
    have hr : p.eps ^ h * errors p s k (m - h) ≤ errors p s (k + h) m :=
      reach_right m p.eps (errors p s) e0 e1 hE hpos k h (by omega)
    have hq := hquiet h hh
    have p1 : 0 ≤ errors p s (k + h) 1 := hpos (k + h) 1 (by omega)
    have pj : 0 ≤ errors p s k (m - h) := hpos k (m - h) (by omega)
    have pe : 0 < p.eps ^ h := Rat.pow_pos e0
    have pp : 0 ≤ p.eps ^ h * errors p s k (m - h) := Rat.mul_nonneg (Rat.le_of_lt pe) pj
    have hz : p.eps ^ h * errors p s k (m - h) = 0 := by grind
    exact zero_of_scaled (p.eps ^ h) (errors p s k (m - h)) pe hz
  intro i hi
  have hck : count (protocol_step p s k).drones = count s.drones := count_step p s k
  show errors p s k i = 0
  by_cases h0 : i = 0
  · rw [h0]
    exact errors_first p s hn ha k
  · by_cases hl : i = count s.drones - 1
    · rw [hl]
      exact errors_last p s hn ha k
    · by_cases hside : i ≤ (m + 1) / 2
      · have z : errors p s k (i - 1 + 1) = 0 := hleft (i - 1) (by omega)
        have ix : i - 1 + 1 = i := by omega
        rw [ix] at z
        exact z
      · have z : errors p s k (m - (m - i)) = 0 := hright (m - i) (by omega)
        have ix : m - (m - i) = i := by omega
        rw [ix] at z
        exact z

/-- 7.6 (ii), sharp. -/
theorem constant_sum_sharp (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 < p.eps) (e1 : 2 * p.eps ≤ 1)
    (hu : upper_bounded p s.drones) (k : Nat)
    (hc : ∀ h : Nat, 1 ≤ h →
      sum (protocol_step p s (k + h)).drones = sum (protocol_step p s k).drones) :
    at_targets p (protocol_step p s k).drones :=
  constant_sum_bounded p s hn ha e0 e1 hu k (fun h h1 _ => hc h h1)

end CordonMirror
