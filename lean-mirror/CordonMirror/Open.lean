import CordonMirror.Spec.Theorems.Hypothesis
import CordonMirror.Thm.Bounds

/-! Statements that have no Lean proof. Each is a definition of type `Prop`, so that it is
checked for being well formed and claims nothing. All of them are proved in Rocq
(`proofs/rocq/theorems.tsv`). The critical weight 1/(1 + cos(pi/(N-1))) is no rational number;
`below_critical` says the same of a rational weight by the signs of leading minors. -/

namespace CordonMirror.Open

/-- Every drone of the run `X` comes and stays as near its target as one likes. -/
def converges (p : Params) (X : Nat → State) : Prop :=
  ∀ (i : Nat) (d : Rat), i < count (X 0).drones → 0 < d →
    ∃ K : Nat, ∀ k : Nat, K ≤ k →
      scaled_error p.min p.max (X k).drones i < d ∧
      -scaled_error p.min p.max (X k).drones i < d

/-- 7.8, sharp: below the critical weight every anchored start converges. Rocq: `limit_sharp`
with `below_critical_correct`. -/
def limit_sharp : Prop :=
  ∀ (p : Params) (s : State), 3 ≤ count s.drones → anchored p s.drones →
    0 < p.eps → below_critical p.eps 1 (count s.drones) → converges p (protocol_step p s)

/-- 7.8, the converse: from the critical weight on some start does not converge. Rocq:
`limit_iff` with `below_critical_correct`. -/
def limit_only_below : Prop :=
  ∀ (p : Params) (N : Nat), 3 ≤ N → p.min < p.max →
    (∀ s : State, count s.drones = N → anchored p s.drones → converges p (protocol_step p s)) →
    0 < p.eps ∧ below_critical p.eps 1 N

/-- 7.8 with delays of at most `D`. Rocq: `limit_delayed`. -/
def limit_delayed : Prop :=
  ∀ (p : Params) (delay : Nat → Nat → Nat → Nat) (X : Nat → State) (D : Nat),
    DelayedRun p delay X → 3 ≤ count (X 0).drones → anchored p (X 0).drones →
    0 < p.eps → 2 * p.eps ≤ 1 → (∀ k i j : Nat, delay k i j ≤ D) → converges p X

end CordonMirror.Open
