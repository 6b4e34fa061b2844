import CordonMirror.Spec.Local
import CordonMirror.Spec.Consensus
import CordonMirror.Spec.Delay
import CordonMirror.Thm.NonDecreasing
import CordonMirror.Thm.Activation

/-! Statements that have no Lean proof. Each is a definition of type `Prop`, so that it is
checked for being well formed and claims nothing. All of them are proved in Rocq
(`proofs/rocq/theorems.tsv`). -/

namespace CordonMirror.Open

/-- 7.2 is exact: `N ≥ 4`, any `eps > 1/2`, any segment: an ordered start that crosses. -/
def ordering_exact : Prop :=
  ∀ (p : Params) (N : Nat), 4 ≤ N → p.min < p.max → 1 < 2 * p.eps →
    ∃ s : State, count s.drones = N ∧ anchored p s.drones ∧ ordered s.drones ∧
      get (exec_coverage p s).drones 2 < get (exec_coverage p s).drones 1

/-- 7.3 is exact: `N ≥ 3`, any `eps > 1/2`, any segment. -/
def upper_bound_exact : Prop :=
  ∀ (p : Params) (N : Nat), 3 ≤ N → p.min < p.max → 1 < 2 * p.eps →
    ∃ s : State, count s.drones = N ∧ anchored p s.drones ∧ ordered s.drones ∧
      upper_bounded p s.drones ∧ ¬ upper_bounded p (exec_coverage p s).drones

/-- 7.4, both parts, free of division. -/
def sum_bounded_and_maximal : Prop :=
  ∀ (p : Params) (s : State), 3 ≤ count s.drones → anchored p s.drones →
    0 ≤ p.eps → 2 * p.eps ≤ 1 → upper_bounded p s.drones → ∀ k : Nat,
      2 * sum (protocol_step p s k).drones ≤ (count s.drones : Rat) * (p.min + p.max) ∧
      (2 * sum (protocol_step p s k).drones = (count s.drones : Rat) * (p.min + p.max) ↔
        at_targets p (protocol_step p s k).drones)

/-- 7.6 (ii), bounded form, of the spec. -/
def constant_sum_bounded : Prop :=
  ∀ (p : Params) (s : State), 3 ≤ count s.drones → anchored p s.drones →
    0 < p.eps → 2 * p.eps ≤ 1 → upper_bounded p s.drones → ∀ k : Nat,
      (∀ h : Nat, 1 ≤ h → h ≤ (count s.drones - 1) / 2 →
        sum (protocol_step p s (k + h)).drones = sum (protocol_step p s k).drones) →
      at_targets p (protocol_step p s k).drones

/-- 7.7, exact, of the spec: `h + 1` is the least distance, in drones, from an off-target
drone to an end. -/
def increasing_sharp : Prop :=
  ∀ (p : Params) (s : State), 3 ≤ count s.drones → anchored p s.drones →
    0 < p.eps → 2 * p.eps ≤ 1 → upper_bounded p s.drones → ∀ k h j : Nat,
      j < count s.drones → ¬ at_target p (protocol_step p s k).drones j →
      Nat.min j (count s.drones - 1 - j) = h + 1 →
      (∀ i : Nat, i < count s.drones → ¬ at_target p (protocol_step p s k).drones i →
        h + 1 ≤ Nat.min i (count s.drones - 1 - i)) →
      (∀ t : Nat, t ≤ h →
        sum (protocol_step p s (k + t)).drones = sum (protocol_step p s k).drones) ∧
      sum (protocol_step p s (k + h)).drones < sum (protocol_step p s (k + h + 1)).drones

/-- 7.8 for `0 < eps ≤ 1/2`, in epsilon form, free of division. -/
def limit_half : Prop :=
  ∀ (p : Params) (s : State), 3 ≤ count s.drones → anchored p s.drones →
    0 < p.eps → 2 * p.eps ≤ 1 → ∀ (i : Nat) (d : Rat), i < count s.drones → 0 < d →
      ∃ K : Nat, ∀ k : Nat, K ≤ k →
        scaled_error p.min p.max (protocol_step p s k).drones i < d ∧
        -scaled_error p.min p.max (protocol_step p s k).drones i < d

/-- The projection theorem. -/
def projection : Prop :=
  ∀ (p : LocalParams) (s : State), 0 < p.ratio.den →
    p.protocol.n = counter_limit p.ratio → p.count = count s.drones →
    s.timesteps ≤ p.protocol.n → ∀ k : Nat,
      swarm_kth_step p (swarm_of p.protocol s) k
        = swarm_of p.protocol (kth_step p.protocol s k)

/-- Bounds under activation. -/
def upper_bound_active : Prop :=
  ∀ (p : Params) (schedule : Nat → Nat → Bool) (s : State), 3 ≤ count s.drones →
    anchored p s.drones → 0 ≤ p.eps → 2 * p.eps ≤ 1 → upper_bounded p s.drones →
    ∀ k : Nat, upper_bounded p (active_step p schedule s k).drones

/-- Consensus preserves the sum on any undirected graph. -/
def consensus_sum : Prop :=
  ∀ (eps : Rat) (g : Graph) (x : DroneMap Rat),
    (∀ i j : Nat, g.linked i j = g.linked j i) → g.count = count x →
    sum (exec_consensus eps g x) = sum x

end CordonMirror.Open
