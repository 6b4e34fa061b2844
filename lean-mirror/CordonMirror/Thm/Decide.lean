import CordonMirror.Spec.Theorems.UpperBound

/-! The predicates of a placement are decidable, so that vectors can execute them. -/

namespace CordonMirror

instance (p : Params) (x : DroneMap Rat) : Decidable (anchored p x) :=
  inferInstanceAs (Decidable (get x 0 = p.min ∧ get x (count x - 1) = p.max))

instance (x : DroneMap Rat) : Decidable (ordered x) :=
  decidable_of_iff (∀ i : Nat, i < count x - 1 → get x i < get x (i + 1))
    (Iff.intro (fun h i hi => h i (by omega)) (fun h i hi => h i (by omega)))

instance (p : Params) (x : DroneMap Rat) : Decidable (in_first_subsegment p x) :=
  decidable_of_iff
    (∀ i : Nat, i < count x - 1 →
      0 < i → gaps x * get x i < gaps x * p.min + (p.max - p.min))
    (Iff.intro (fun h i h0 hi => h i (by omega) h0) (fun h i hi h0 => h i h0 (by omega)))

instance (p : Params) (x : DroneMap Rat) : Decidable (upper_bounded p x) :=
  inferInstanceAs (Decidable (∀ i : Nat, i < count x → 0 ≤ scaled_error p.min p.max x i))

instance (p : Params) (x : DroneMap Rat) (i : Nat) : Decidable (at_target p x i) :=
  inferInstanceAs (Decidable (scaled_error p.min p.max x i = 0))

instance (p : Params) (x : DroneMap Rat) : Decidable (at_targets p x) :=
  inferInstanceAs (Decidable (∀ i : Nat, i < count x → at_target p x i))

instance (p : Params) (x : DroneMap Rat) : Decidable (above_targets p x) :=
  inferInstanceAs (Decidable (∀ i : Nat, i < count x → scaled_error p.min p.max x i ≤ 0))

instance (p : Params) (x : DroneMap Rat) : Decidable (in_box p x) :=
  inferInstanceAs (Decidable (∀ i : Nat, i < count x → p.min ≤ get x i ∧ get x i ≤ p.max))

instance (num den : Rat) (N : Nat) : Decidable (below_critical num den N) :=
  decidable_of_iff
    (∀ k : Nat, k < N - 1 → 1 ≤ k → 0 < (minors (2 * den - 2 * num) (num * num) k).2)
    (Iff.intro (fun h k h1 hk => h k (by omega) h1) (fun h k hk h1 => h k h1 (by omega)))

end CordonMirror
