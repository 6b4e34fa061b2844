import CordonMirror.Thm.UpperBound

/-! Theorem 7.5: the identity, for every weight and every start, and its first part. -/

namespace CordonMirror

/-- The sum of `f 0 .. f (n - 1)`. -/
def sumn (f : Nat → Rat) : Nat → Rat
  | 0 => 0
  | n + 1 => sumn f n + f n

theorem sumn_shift (f : Nat → Rat) :
    ∀ n : Nat, sumn f (n + 1) = f 0 + sumn (fun i => f (i + 1)) n
  | 0 => by
    show (0 : Rat) + f 0 = f 0 + 0
    grind
  | n + 1 => by
    have ih : sumn f (n + 1) = f 0 + sumn (fun i => f (i + 1)) n := sumn_shift f n
    show sumn f (n + 1) + f (n + 1) = f 0 + (sumn (fun i => f (i + 1)) n + f (n + 1))
    rw [ih]
    grind

theorem foldl_add :
    ∀ (l : List Rat) (c : Rat),
      l.foldl (fun a b : Rat => a + b) c = c + l.foldl (fun a b : Rat => a + b) 0
  | [], c => Eq.symm (Rat.add_zero c)
  | x :: l, c => by
    have h1 : l.foldl (fun a b : Rat => a + b) (c + x)
        = (c + x) + l.foldl (fun a b : Rat => a + b) 0 :=
      foldl_add l (c + x)
    have h2 : l.foldl (fun a b : Rat => a + b) (0 + x)
        = (0 + x) + l.foldl (fun a b : Rat => a + b) 0 :=
      foldl_add l (0 + x)
    show l.foldl (fun a b : Rat => a + b) (c + x)
      = c + l.foldl (fun a b : Rat => a + b) (0 + x)
    rw [h1, h2]
    grind

theorem sum_cons (a : Rat) (l : List Rat) : sum (a :: l) = a + sum l := by
  have h : l.foldl (fun c xi : Rat => c + xi) (0 + a)
      = (0 + a) + l.foldl (fun c xi : Rat => c + xi) 0 :=
    foldl_add l (0 + a)
  show l.foldl (fun c xi : Rat => c + xi) (0 + a)
    = a + l.foldl (fun c xi : Rat => c + xi) 0
  rw [h]
  grind

theorem sum_sumn : ∀ x : List Rat, sum x = sumn (get x) (count x)
  | [] => rfl
  | a :: l => by
    have h1 : sum (a :: l) = a + sum l := sum_cons a l
    have h2 : sumn (get (a :: l)) (count l + 1) = a + sumn (get l) (count l) :=
      sumn_shift (get (a :: l)) (count l)
    have h3 : a + sum l = a + sumn (get l) (count l) :=
      congrArg (fun t => a + t) (sum_sumn l)
    exact Eq.trans h1 (Eq.trans h3 (Eq.symm h2))

/-- Second differences telescope. -/
theorem telescope (M : Nat) (e : Rat) (x y : Nat → Rat) (h : Step M e x y) (m : Nat) :
    m < M → sumn y (m + 1) - sumn x (m + 1) = e * ((x (m + 1) - x m) - (x 1 - x 0)) := by
  induction m with
  | zero =>
    intro _
    show ((0 : Rat) + y 0) - (0 + x 0) = e * ((x 1 - x 0) - (x 1 - x 0))
    rw [h.left_end]
    grind
  | succ m ih =>
    intro hm
    have hy : y (m + 1) = e * x m + (1 - 2 * e) * x (m + 1) + e * x (m + 2) :=
      h.inner m hm
    have ih2 : sumn y (m + 1) - sumn x (m + 1) = e * ((x (m + 1) - x m) - (x 1 - x 0)) :=
      ih (by omega)
    show (sumn y (m + 1) + y (m + 1)) - (sumn x (m + 1) + x (m + 1))
      = e * ((x (m + 2) - x (m + 1)) - (x 1 - x 0))
    rw [hy]
    grind

/-- `c^{k+1} - c^k = eps * (g_{N-2} - g_0)`, on sequences. -/
theorem telescope_all (m : Nat) (e : Rat) (x y : Nat → Rat) (h : Step (m + 1) e x y) :
    sumn y (m + 2) - sumn x (m + 2) = e * ((x (m + 1) - x m) - (x 1 - x 0)) := by
  have ht : sumn y (m + 1) - sumn x (m + 1) = e * ((x (m + 1) - x m) - (x 1 - x 0)) :=
    telescope (m + 1) e x y h m (by omega)
  have hl : y (m + 1) = x (m + 1) := h.right_end
  show (sumn y (m + 1) + y (m + 1)) - (sumn x (m + 1) + x (m + 1))
    = e * ((x (m + 1) - x m) - (x 1 - x 0))
  rw [hl]
  grind

theorem sum_positions (p : Params) (s : State) (N : Nat) (hN : count s.drones = N) (k : Nat) :
    sum (protocol_step p s k).drones = sumn (positions p s k) N := by
  have h1 : sum (protocol_step p s k).drones
      = sumn (get (protocol_step p s k).drones) (count (protocol_step p s k).drones) :=
    sum_sumn (protocol_step p s k).drones
  have h2 : count (protocol_step p s k).drones = N := Eq.trans (count_step p s k) hN
  rw [h2] at h1
  exact h1

/-- The identity behind 7.5, for every weight and every start. -/
theorem sum_identity (p : Params) (s : State) (m : Nat) (hm : count s.drones = m + 2)
    (h1 : 1 ≤ m) (ha : anchored p s.drones) (k : Nat) :
    sum (protocol_step p s (k + 1)).drones - sum (protocol_step p s k).drones
      = p.eps * (gap (protocol_step p s k).drones m - gap (protocol_step p s k).drones 0) := by
  have hr : Run (count s.drones - 1) p.eps (positions p s) :=
    positions_run p s (by omega) ha
  have hM : count s.drones - 1 = m + 1 := by omega
  rw [hM] at hr
  have ht : sumn (positions p s (k + 1)) (m + 2) - sumn (positions p s k) (m + 2)
      = p.eps * ((positions p s k (m + 1) - positions p s k m)
        - (positions p s k 1 - positions p s k 0)) :=
    telescope_all m p.eps (positions p s k) (positions p s (k + 1)) (hr k)
  have c0 : sum (protocol_step p s k).drones = sumn (positions p s k) (m + 2) :=
    sum_positions p s (m + 2) hm k
  have c1 : sum (protocol_step p s (k + 1)).drones = sumn (positions p s (k + 1)) (m + 2) :=
    sum_positions p s (m + 2) hm (k + 1)
  rw [c0, c1]
  exact ht

/-- 7.5 (i), sharp: `UB`, `0 ≤ eps ≤ 1/2`. -/
theorem sum_non_decreasing_sharp (p : Params) (s : State) (m : Nat)
    (hm : count s.drones = m + 2) (h1 : 1 ≤ m) (ha : anchored p s.drones)
    (e0 : 0 ≤ p.eps) (e1 : 2 * p.eps ≤ 1) (hu : upper_bounded p s.drones) (k : Nat) :
    sum (protocol_step p s k).drones ≤ sum (protocol_step p s (k + 1)).drones := by
  have hid : sum (protocol_step p s (k + 1)).drones - sum (protocol_step p s k).drones
      = p.eps * (gap (protocol_step p s k).drones m - gap (protocol_step p s k).drones 0) :=
    sum_identity p s m hm h1 ha k
  have hc : count (protocol_step p s k).drones = m + 2 := by
    rw [count_step p s k]
    exact hm
  have hk : upper_bounded p (protocol_step p s k).drones :=
    upper_bound_sharp p s (by omega) ha e0 e1 hu k
  have hak : anchored p (protocol_step p s k).drones := anchored_step p s (by omega) ha k
  have hM : count (protocol_step p s k).drones - 1 = m + 1 := by omega
  have x0 : get (protocol_step p s k).drones 0 = p.min := hak.1
  have xl : get (protocol_step p s k).drones (m + 1) = p.max := by
    have h := hak.2
    rw [hM] at h
    exact h
  have u1 : 0 ≤ scaled_error p.min p.max (protocol_step p s k).drones 1 := hk 1 (by omega)
  have um : 0 ≤ scaled_error p.min p.max (protocol_step p s k).drones m := hk m (by omega)
  rw [scaled_error_eq, hM] at u1 um
  unfold scaled_line at u1 um
  have k1 : ((m + 1 : Nat) : Rat) = (m : Rat) + 1 := cast_add_one m
  have k0 : ((1 : Nat) : Rat) = 1 := rfl
  rw [k1, k0] at u1
  rw [k1] at um
  have mpos : (0 : Rat) ≤ (m : Rat) := Rat.natCast_nonneg
  have g : 0 ≤ gap (protocol_step p s k).drones m - gap (protocol_step p s k).drones 0 := by
    unfold gap
    show 0 ≤ get (protocol_step p s k).drones (m + 1) - get (protocol_step p s k).drones m
      - (get (protocol_step p s k).drones 1 - get (protocol_step p s k).drones 0)
    rw [x0, xl]
    have q : 0 ≤ ((m : Rat) + 1)
        * (p.max - get (protocol_step p s k).drones m
          - (get (protocol_step p s k).drones 1 - p.min)) := by
      grind
    refine Classical.byContradiction fun hneg => ?_
    have hlt : p.max - get (protocol_step p s k).drones m
        - (get (protocol_step p s k).drones 1 - p.min) < 0 := Rat.not_le.mp hneg
    have hprod : ((m : Rat) + 1)
        * (p.max - get (protocol_step p s k).drones m
          - (get (protocol_step p s k).drones 1 - p.min)) < 0 :=
      mul_neg_of_pos_of_neg (by grind) hlt
    grind
  have hprod : 0 ≤ p.eps
      * (gap (protocol_step p s k).drones m - gap (protocol_step p s k).drones 0) :=
    Rat.mul_nonneg e0 g
  grind

end CordonMirror
