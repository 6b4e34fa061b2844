import CordonMirror.Thm.Critical

/-! Theorem 7.8 as an equivalence on the spec: every anchored start converges exactly for
`0 < eps` below the critical weight, as the leading minors of `below_critical` decide it. -/

namespace CordonMirror

/-- Every drone of the run `X` comes and stays as near its target as one likes. -/
def converges (p : Params) (X : Nat → State) : Prop :=
  ∀ (i : Nat) (d : Rat), i < count (X 0).drones → 0 < d →
    ∃ K : Nat, ∀ k : Nat, K ≤ k →
      scaled_error p.min p.max (X k).drones i < d ∧
      -scaled_error p.min p.max (X k).drones i < d

/-- 7.8, sharp: below the critical weight every anchored start converges. -/
theorem limit_sharp (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) (e0 : 0 < p.eps) (hc : below_critical p.eps 1 (count s.drones)) :
    converges p (protocol_step p s) := by
  intro i d hi hd
  by_cases e1 : 2 * p.eps ≤ 1
  · exact limit_half p s hn ha e0 e1 i d hi hd
  · obtain ⟨t, ht⟩ := exists_quotient p.eps (2 - 2 * p.eps) e0
    have hpos := (below_critical_wave p.eps t (count s.drones) e0 ht).mp hc
    have e2 : p.eps ≤ 1 := by
      have w2 : 0 < wave t 2 := hpos 2 (by omega) (by omega)
      have hw : wave t 2 = t * wave t 1 - wave t 0 := wave_next t 0
      have w0 : wave t 0 = 0 := rfl
      have w1 : wave t 1 = 1 := rfl
      rw [hw, w0, w1] at w2
      have hp : 0 < p.eps * t := Rat.mul_pos e0 (by grind)
      grind
    have hlast : i ≤ count s.drones - 1 := Nat.le_sub_one_of_lt hi
    exact errors_vanish (count s.drones - 1) p.eps t d (by omega) e0 (by grind) e2 ht hd hpos
      (errors p s) (errors_run p s hn ha) (errors_first p s hn ha 0) (errors_last p s hn ha 0)
      i hlast

/-- A start with prescribed errors, scaled by `N - 1`. -/
theorem exists_start (p : Params) (N : Nat) (hN : 3 ≤ N) (f : Nat → Rat) (f0 : f 0 = 0)
    (fl : f (N - 1) = 0) :
    ∃ s : State, count s.drones = N ∧ anchored p s.drones ∧
      ∀ i : Nat, i < N → errors p s 0 i = f i := by
  have g0 : (0 : Rat) < ((N - 1 : Nat) : Rat) := cast_pos_of_pos (N - 1) (by omega)
  obtain ⟨q, hq⟩ := exists_inverse ((N - 1 : Nat) : Rat) g0
  refine Exists.intro
    (State.mk (lambda N (fun i => (scaled_target p.min p.max N i - f i) * q)) 0) ?_
  have hc : count (lambda N (fun i => (scaled_target p.min p.max N i - f i) * q)) = N :=
    count_lambda N _
  have hg : ∀ i : Nat, i < N →
      get (lambda N (fun i => (scaled_target p.min p.max N i - f i) * q)) i
        = (scaled_target p.min p.max N i - f i) * q :=
    fun i hi => get_lambda N _ i hi
  refine And.intro hc (And.intro (And.intro ?_ ?_) ?_)
  · have h := hg 0 (by omega)
    have z : ((0 : Nat) : Rat) = 0 := rfl
    have hm : p.min * (((N - 1 : Nat) : Rat) * q) = p.min * 1 := congrArg (fun x => p.min * x) hq
    unfold scaled_target at h
    rw [f0, z] at h
    exact Eq.trans h (by grind)
  · have h := hg (N - 1) (by omega)
    have hm : p.max * (((N - 1 : Nat) : Rat) * q) = p.max * 1 := congrArg (fun x => p.max * x) hq
    unfold scaled_target at h
    rw [fl] at h
    show get (lambda N (fun i => (scaled_target p.min p.max N i - f i) * q))
      (count (lambda N (fun i => (scaled_target p.min p.max N i - f i) * q)) - 1) = p.max
    rw [hc]
    exact Eq.trans h (by grind)
  · intro i hi
    show scaled_error p.min p.max
      (lambda N (fun i => (scaled_target p.min p.max N i - f i) * q)) i = f i
    have hm : (scaled_target p.min p.max N i - f i) * (((N - 1 : Nat) : Rat) * q)
        = (scaled_target p.min p.max N i - f i) * 1 :=
      congrArg (fun x => (scaled_target p.min p.max N i - f i) * x) hq
    unfold scaled_error gaps
    rw [hc, hg i hi]
    grind

theorem sign_values (n : Nat) : sign n = 1 ∨ sign n = -1 := by
  induction n with
  | zero => exact Or.inl rfl
  | succ n ih =>
    have h : sign (n + 1) = -sign n := rfl
    rw [h]
    cases ih with
    | inl h1 => exact Or.inr (by rw [h1])
    | inr h1 => exact Or.inl (by rw [h1]; grind)

/-- A run in which drone 1 always has an error of at least 1 does not converge. -/
theorem not_converges (p : Params) (s : State) (hn : 3 ≤ count s.drones) (turn : Nat → Nat)
    (h : ∀ k : Nat, 1 ≤ sign (turn k) * errors p s k 1) : ¬ converges p (protocol_step p s) := by
  intro hc
  obtain ⟨K, hK⟩ := hc 1 1 (show 1 < count s.drones by omega) (by grind)
  have hb : errors p s K 1 < 1 ∧ -errors p s K 1 < 1 := hK K (Nat.le_refl K)
  have hl := h K
  cases sign_values (turn K) with
  | inl h1 =>
    rw [h1] at hl
    grind
  | inr h1 =>
    rw [h1] at hl
    grind

/-- Errors of size 1 and alternating sign on the internal drones. -/
def alternating (N i : Nat) : Rat := if 0 < i ∧ i + 1 < N then sign i else 0

/-- Errors of size `w_i` and alternating sign up to drone `n`. -/
def alternating_wave (t : Rat) (n i : Nat) : Rat := if i ≤ n then sign i * wave t i else 0

/-- 7.8, the converse: if every anchored start converges, the weight is positive and below the
critical weight. -/
theorem limit_only_below (p : Params) (N : Nat) (hN : 3 ≤ N)
    (hall : ∀ s : State, count s.drones = N → anchored p s.drones →
      converges p (protocol_step p s)) :
    0 < p.eps ∧ below_critical p.eps 1 N := by
  by_cases e0 : 0 < p.eps
  · refine And.intro e0 ?_
    obtain ⟨t, ht⟩ := exists_quotient p.eps (2 - 2 * p.eps) e0
    have w0 : wave t 0 = 0 := rfl
    have w1 : wave t 1 = 1 := rfl
    refine (below_critical_wave p.eps t N e0 ht).mpr ?_
    intro i
    induction i using Nat.strongRecOn with
    | ind i ih =>
      intro h1 hi
      refine Classical.byContradiction fun hneg => ?_
      have hw : wave t i ≤ 0 := Rat.not_lt.mp hneg
      have hone : ¬ (i = 1) := by
        intro he
        rw [he, w1] at hw
        grind
      obtain ⟨n, hn⟩ : ∃ n : Nat, i = n + 1 := ⟨i - 1, by omega⟩
      subst hn
      have e1 : 1 ≤ 2 * p.eps := by
        refine Classical.byContradiction fun hlow => ?_
        have hg := (wave_grows p.eps t e0 (by grind) ht n).1
        grind
      have hpos : ∀ j : Nat, j ≤ n → 0 ≤ wave t j := by
        intro j hj
        by_cases hz : j = 0
        · rw [hz, w0]
          exact Rat.le_refl
        · exact Rat.le_of_lt (ih j (by omega) (by omega) (by omega))
      have f0 : alternating_wave t n 0 = 0 := by
        unfold alternating_wave
        rw [if_pos (Nat.zero_le n), w0]
        grind
      have fl : alternating_wave t n (N - 1) = 0 := if_neg (by omega)
      obtain ⟨s, hc, ha, hs⟩ := exists_start p N hN (alternating_wave t n) f0 fl
      have hn3 : 3 ≤ count s.drones := by omega
      have hE : Run (N - 1) p.eps (errors p s) := by
        have h := errors_run p s hn3 ha
        rw [hc] at h
        exact h
      have E0 : errors p s 0 0 = 0 := Eq.trans (hs 0 (by omega)) f0
      have EM : errors p s 0 (N - 1) = 0 := Eq.trans (hs (N - 1) (by omega)) fl
      have signed : ∀ j : Nat, j ≤ n → sign j * errors p s 0 j = wave t j := by
        intro j hj
        have hf : alternating_wave t n j = sign j * wave t j := if_pos hj
        have hq := sign_square j
        have hm : (sign j * sign j) * wave t j = 1 * wave t j :=
          congrArg (fun x => x * wave t j) hq
        rw [hs j (by omega), hf]
        grind
      have hnonneg : ∀ j : Nat, j ≤ N - 1 → 0 ≤ sign j * errors p s 0 j := by
        intro j hj
        by_cases hjn : j ≤ n
        · rw [signed j hjn]
          exact hpos j hjn
        · have hf : alternating_wave t n j = 0 := if_neg hjn
          rw [hs j (by omega), hf]
          grind
      have hstays := alternating_stays (N - 1) n p.eps t (Rat.le_of_lt e0) e1 ht hi hw
        (errors p s) hE E0 EM hnonneg (fun j hj => le_of_eq (Eq.symm (signed j hj)))
      refine not_converges p s hn3 (fun k => 1 + k) ?_ (hall s hc ha)
      intro k
      have h := (hstays k).2 1 (by omega)
      rw [w1] at h
      exact h
  · exfalso
    have f0 : alternating N 0 = 0 := if_neg (by omega)
    have fl : alternating N (N - 1) = 0 := if_neg (by omega)
    obtain ⟨s, hc, ha, hs⟩ := exists_start p N hN (alternating N) f0 fl
    have hn3 : 3 ≤ count s.drones := by omega
    have hE : Run (N - 1) p.eps (errors p s) := by
      have h := errors_run p s hn3 ha
      rw [hc] at h
      exact h
    have hgrow := alternating_grows (N - 1) p.eps (Rat.not_lt.mp e0) (errors p s) hE
      (Eq.trans (hs 0 (by omega)) f0) (Eq.trans (hs (N - 1) (by omega)) fl) (by
        intro i h0 hi
        have hf : alternating N i = sign i := if_pos (by omega)
        have hq := sign_square i
        rw [hs i (by omega), hf]
        grind)
    refine not_converges p s hn3 (fun _ => 1) ?_ (hall s hc ha)
    intro k
    exact hgrow k 1 (by omega) (by omega)

/-- 7.8 as an equivalence. -/
theorem limit_iff (p : Params) (N : Nat) (hN : 3 ≤ N) :
    (∀ s : State, count s.drones = N → anchored p s.drones → converges p (protocol_step p s))
      ↔ 0 < p.eps ∧ below_critical p.eps 1 N := by
  refine Iff.intro (limit_only_below p N hN) ?_
  intro h s hc ha
  exact limit_sharp p s (by omega) ha h.1 (by rw [hc]; exact h.2)

end CordonMirror
