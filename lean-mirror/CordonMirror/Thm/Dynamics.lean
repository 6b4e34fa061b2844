import CordonMirror.Spec.Coverage
import CordonMirror.Spec.Theorems.UpperBound
import CordonMirror.Spec.Theorems.NonDecreasing

/-! One update of the swarm as a relation between two sequences of positions. `M = N - 1` is
the number of the last drone. The theorems are proved of this relation. -/

namespace CordonMirror

/-! ### Drone maps -/

theorem count_lambda {α : Type} : ∀ (n : Nat) (f : Nat → α), count (lambda n f) = n
  | 0, _ => rfl
  | n + 1, f => by
    have ih : count (lambda n (fun i => f (i + 1))) = n := count_lambda n (fun i => f (i + 1))
    show count (lambda n (fun i => f (i + 1))) + 1 = n + 1
    rw [ih]

/-- A placement is known by what its drones do. -/
theorem lambda_ext {α : Type} (n : Nat) :
    ∀ f g : Nat → α, (∀ i : Nat, i < n → f i = g i) → lambda n f = lambda n g := by
  induction n with
  | zero =>
    intro f g _
    rfl
  | succ n ih =>
    intro f g h
    have h0 : f 0 = g 0 := h 0 (by omega)
    have ht : lambda n (fun i => f (i + 1)) = lambda n (fun i => g (i + 1)) :=
      ih (fun i => f (i + 1)) (fun i => g (i + 1)) (fun i hi => h (i + 1) (by omega))
    show f 0 :: lambda n (fun i => f (i + 1)) = g 0 :: lambda n (fun i => g (i + 1))
    rw [h0, ht]

theorem get_or_lambda {α : Type} (z : α) :
    ∀ (n : Nat) (f : Nat → α) (i : Nat), i < n → get_or z (lambda n f) i = f i
  | 0, _, i, h => absurd h (Nat.not_lt_zero i)
  | _ + 1, _, 0, _ => rfl
  | n + 1, f, i + 1, h => get_or_lambda z n (fun j => f (j + 1)) i (Nat.lt_of_succ_lt_succ h)

theorem get_lambda (n : Nat) (f : Nat → Rat) (i : Nat) (h : i < n) :
    get (lambda n f) i = f i :=
  get_or_lambda 0 n f i h

/-! ### One drone -/

theorem update_first (p : Params) (N : Nat) (f : Nat → Rat) : update p N 0 f = p.min := by
  unfold update exec_cvg
  exact if_pos rfl

theorem update_last (p : Params) (N : Nat) (f : Nat → Rat) (h : 1 < N) :
    update p N (N - 1) f = p.max := by
  have h0 : ¬ (N - 1 = 0) := by omega
  have h1 : N - 1 + 1 = N := by omega
  unfold update exec_cvg
  exact Eq.trans (if_neg h0) (if_pos h1)

theorem update_inner (p : Params) (N i : Nat) (f : Nat → Rat) (h : i + 2 < N) :
    update p N (i + 1) f
      = p.eps * f i + (1 - 2 * p.eps) * f (i + 1) + p.eps * f (i + 2) := by
  have h0 : ¬ (i + 1 = 0) := Nat.succ_ne_zero i
  have h1 : ¬ (i + 1 + 1 = N) := by omega
  have h2 : 0 < i + 1 := Nat.succ_pos i
  have h3 : i + 1 + 1 < N := by omega
  have a : (if 0 < i + 1 then f (i + 1 - 1) else p.min) = f i := if_pos h2
  have c : (if i + 1 + 1 < N then f (i + 1 + 1) else p.max) = f (i + 2) := if_pos h3
  have e : p.eps * (if 0 < i + 1 then f (i + 1 - 1) else p.min)
      + (1 - 2 * p.eps) * f (i + 1)
      + p.eps * (if i + 1 + 1 < N then f (i + 1 + 1) else p.max)
      = p.eps * f i + (1 - 2 * p.eps) * f (i + 1) + p.eps * f (i + 2) := by
    rw [a, c]
  unfold update exec_cvg
  exact Eq.trans (if_neg h0) (Eq.trans (if_neg h1) e)

/-! ### The swarm -/

/-- `exec_coverage` applied `k` times: `k` counts protocol steps. -/
def protocol_step (p : Params) (start : State) : Nat → State
  | 0 => start
  | k + 1 => exec_coverage p (protocol_step p start k)

theorem count_exec (p : Params) (s : State) :
    count (exec_coverage p s).drones = count s.drones :=
  count_lambda (count s.drones) (fun i => update p (count s.drones) i (get s.drones))

theorem count_step (p : Params) (s : State) :
    ∀ k : Nat, count (protocol_step p s k).drones = count s.drones
  | 0 => rfl
  | k + 1 => Eq.trans (count_exec p (protocol_step p s k)) (count_step p s k)

theorem get_exec (p : Params) (s : State) (i : Nat) (h : i < count s.drones) :
    get (exec_coverage p s).drones i = update p (count s.drones) i (get s.drones) :=
  get_lambda (count s.drones) (fun j => update p (count s.drones) j (get s.drones)) i h

/-- Drone `i` moves with a weight `a i` of its own: 0 when it skips the update. -/
structure Weighted (M : Nat) (a x y : Nat → Rat) : Prop where
  left_end : y 0 = x 0
  right_end : y M = x M
  inner : ∀ i : Nat, i + 1 < M →
    y (i + 1) = x (i + 1) + a (i + 1) * (x i - 2 * x (i + 1) + x (i + 2))

/-- All internal drones move with the same weight `e`. -/
structure Step (M : Nat) (e : Rat) (x y : Nat → Rat) : Prop where
  left_end : y 0 = x 0
  right_end : y M = x M
  inner : ∀ i : Nat, i + 1 < M →
    y (i + 1) = e * x i + (1 - 2 * e) * x (i + 1) + e * x (i + 2)

/-- A run: successive placements, each one step after the other. -/
def Run (M : Nat) (e : Rat) (X : Nat → Nat → Rat) : Prop :=
  ∀ k : Nat, Step M e (X k) (X (k + 1))

theorem Step.weighted {M : Nat} {e : Rat} {x y : Nat → Rat} (h : Step M e x y) :
    Weighted M (fun _ => e) x y := by
  refine Weighted.mk h.left_end h.right_end ?_
  intro i hi
  have hy : y (i + 1) = e * x i + (1 - 2 * e) * x (i + 1) + e * x (i + 2) := h.inner i hi
  show y (i + 1) = x (i + 1) + e * (x i - 2 * x (i + 1) + x (i + 2))
  rw [hy]
  grind

theorem Weighted.step {M : Nat} {e : Rat} {x y : Nat → Rat}
    (h : Weighted M (fun _ => e) x y) : Step M e x y := by
  refine Step.mk h.left_end h.right_end ?_
  intro i hi
  have hy : y (i + 1) = x (i + 1) + e * (x i - 2 * x (i + 1) + x (i + 2)) := h.inner i hi
  rw [hy]
  grind

theorem exec_step (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) :
    Step (count s.drones - 1) p.eps (get s.drones) (get (exec_coverage p s).drones) := by
  have h0 : get (exec_coverage p s).drones 0 = p.min :=
    Eq.trans (get_exec p s 0 (by omega)) (update_first p (count s.drones) (get s.drones))
  have hl : get (exec_coverage p s).drones (count s.drones - 1) = p.max :=
    Eq.trans (get_exec p s (count s.drones - 1) (by omega))
      (update_last p (count s.drones) (get s.drones) (by omega))
  refine Step.mk (Eq.trans h0 (Eq.symm ha.1)) (Eq.trans hl (Eq.symm ha.2)) ?_
  intro i hi
  exact Eq.trans (get_exec p s (i + 1) (by omega))
    (update_inner p (count s.drones) i (get s.drones) (by omega))

theorem anchored_exec (p : Params) (s : State) (hn : 3 ≤ count s.drones) :
    anchored p (exec_coverage p s).drones := by
  have h0 : get (exec_coverage p s).drones 0 = p.min :=
    Eq.trans (get_exec p s 0 (by omega)) (update_first p (count s.drones) (get s.drones))
  have hl : get (exec_coverage p s).drones (count s.drones - 1) = p.max :=
    Eq.trans (get_exec p s (count s.drones - 1) (by omega))
      (update_last p (count s.drones) (get s.drones) (by omega))
  have hc : count (exec_coverage p s).drones = count s.drones := count_exec p s
  refine And.intro h0 ?_
  rw [hc]
  exact hl

theorem anchored_step (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) : ∀ k : Nat, anchored p (protocol_step p s k).drones
  | 0 => ha
  | k + 1 => anchored_exec p (protocol_step p s k)
      (by rw [count_step p s k]; exact hn)

/-- Positions after `k` protocol steps, as a function of step and drone. -/
def positions (p : Params) (s : State) (k i : Nat) : Rat :=
  get (protocol_step p s k).drones i

theorem positions_run (p : Params) (s : State) (hn : 3 ≤ count s.drones)
    (ha : anchored p s.drones) : Run (count s.drones - 1) p.eps (positions p s) := by
  intro k
  have hc : count (protocol_step p s k).drones = count s.drones := count_step p s k
  have hs : Step (count (protocol_step p s k).drones - 1) p.eps
      (get (protocol_step p s k).drones)
      (get (exec_coverage p (protocol_step p s k)).drones) :=
    exec_step p (protocol_step p s k) (by rw [hc]; exact hn) (anchored_step p s hn ha k)
  rw [hc] at hs
  exact hs

theorem Run.ends {M : Nat} {e : Rat} {X : Nat → Nat → Rat} (h : Run M e X) :
    ∀ k : Nat, X k 0 = X 0 0 ∧ X k M = X 0 M
  | 0 => And.intro rfl rfl
  | k + 1 => And.intro
      (Eq.trans (h k).left_end (Run.ends h k).1)
      (Eq.trans (h k).right_end (Run.ends h k).2)

end CordonMirror
