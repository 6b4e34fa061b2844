import CordonMirror.Thm.Activation
import CordonMirror.Thm.Bounds
import CordonMirror.Thm.Consensus
import CordonMirror.Thm.Critical
import CordonMirror.Thm.Exact
import CordonMirror.Thm.FixedPoint
import CordonMirror.Thm.Limit
import CordonMirror.Thm.LimitDelayed
import CordonMirror.Thm.LimitHalf
import CordonMirror.Thm.LimitSharp
import CordonMirror.Thm.NonDecreasing
import CordonMirror.Thm.Ordering
import CordonMirror.Thm.Paper
import CordonMirror.Thm.Projection
import CordonMirror.Thm.Sum
import CordonMirror.Thm.SumGrowth
import CordonMirror.Thm.Ticks
import CordonMirror.Thm.UpperBound

/-! The statements of `theorems.tsv`, and what each rests on, as this version of Lean prints them:
one that changes, or a proof that rests on anything but the axioms of Lean's own logic, is an
error. Written by Lean; a change of it is a change of what is claimed. -/

namespace CordonMirror

/--
info: ordering_sharp : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 ≤ p.eps → 2 * p.eps ≤ 1 → ordered s.drones → ∀ (k : Nat), ordered (protocol_step p s k).drones
-/
#guard_msgs in
#check @ordering_sharp

/--
info: 'CordonMirror.ordering_sharp' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms ordering_sharp

/--
info: ordering_three : ∀ (p : Params) (s : State),
  count s.drones = 3 →
    anchored p s.drones → 0 ≤ p.eps → p.eps ≤ 1 → ordered s.drones → ∀ (k : Nat), ordered (protocol_step p s k).drones
-/
#guard_msgs in
#check @ordering_three

/--
info: 'CordonMirror.ordering_three' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms ordering_three

/--
info: ordering_ticks : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones → 0 ≤ p.eps → 2 * p.eps ≤ 1 → ordered s.drones → ∀ (k : Nat), ordered (kth_step p s k).drones
-/
#guard_msgs in
#check @ordering_ticks

/--
info: 'CordonMirror.ordering_ticks' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms ordering_ticks

/--
info: ordering_paper : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 ≤ p.eps → 3 * p.eps < 1 → ordered s.drones → ∀ (k : Nat), ordered (protocol_step p s k).drones
-/
#guard_msgs in
#check @ordering_paper

/--
info: 'CordonMirror.ordering_paper' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms ordering_paper

/--
info: ordering_exact : ∀ (p : Params) (N : Nat),
  4 ≤ N →
    p.min < p.max →
      1 < 2 * p.eps →
        ∃ s,
          count s.drones = N ∧
            anchored p s.drones ∧ ordered s.drones ∧ get (exec_coverage p s).drones 2 < get (exec_coverage p s).drones 1
-/
#guard_msgs in
#check @ordering_exact

/--
info: 'CordonMirror.ordering_exact' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms ordering_exact

/--
info: upper_bound_sharp : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 ≤ p.eps → 2 * p.eps ≤ 1 → upper_bounded p s.drones → ∀ (k : Nat), upper_bounded p (protocol_step p s k).drones
-/
#guard_msgs in
#check @upper_bound_sharp

/--
info: 'CordonMirror.upper_bound_sharp' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms upper_bound_sharp

/--
info: lower_bound_sharp : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 ≤ p.eps → 2 * p.eps ≤ 1 → above_targets p s.drones → ∀ (k : Nat), above_targets p (protocol_step p s k).drones
-/
#guard_msgs in
#check @lower_bound_sharp

/--
info: 'CordonMirror.lower_bound_sharp' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms lower_bound_sharp

/--
info: box_sharp : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 ≤ p.eps → 2 * p.eps ≤ 1 → in_box p s.drones → ∀ (k : Nat), in_box p (protocol_step p s k).drones
-/
#guard_msgs in
#check @box_sharp

/--
info: 'CordonMirror.box_sharp' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms box_sharp

/--
info: upper_bound_ticks : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 ≤ p.eps → 2 * p.eps ≤ 1 → upper_bounded p s.drones → ∀ (k : Nat), upper_bounded p (kth_step p s k).drones
-/
#guard_msgs in
#check @upper_bound_ticks

/--
info: 'CordonMirror.upper_bound_ticks' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms upper_bound_ticks

/--
info: lower_bound_ticks : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 ≤ p.eps → 2 * p.eps ≤ 1 → above_targets p s.drones → ∀ (k : Nat), above_targets p (kth_step p s k).drones
-/
#guard_msgs in
#check @lower_bound_ticks

/--
info: 'CordonMirror.lower_bound_ticks' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms lower_bound_ticks

/--
info: box_ticks : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones → 0 ≤ p.eps → 2 * p.eps ≤ 1 → in_box p s.drones → ∀ (k : Nat), in_box p (kth_step p s k).drones
-/
#guard_msgs in
#check @box_ticks

/--
info: 'CordonMirror.box_ticks' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms box_ticks

/--
info: first_subsegment_upper_bounded : ∀ (p : Params) (x : DroneMap Rat),
  p.min ≤ p.max → anchored p x → in_first_subsegment p x → upper_bounded p x
-/
#guard_msgs in
#check @first_subsegment_upper_bounded

/--
info: 'CordonMirror.first_subsegment_upper_bounded' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms first_subsegment_upper_bounded

/--
info: upper_bound_paper : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    p.min < p.max →
      anchored p s.drones →
        0 ≤ p.eps →
          2 * p.eps < 1 → in_first_subsegment p s.drones → ∀ (k : Nat), upper_bounded p (kth_step p s k).drones
-/
#guard_msgs in
#check @upper_bound_paper

/--
info: 'CordonMirror.upper_bound_paper' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms upper_bound_paper

/--
info: upper_bound_exact : ∀ (p : Params) (N : Nat),
  3 ≤ N →
    p.min < p.max →
      1 < 2 * p.eps →
        ∃ s,
          count s.drones = N ∧
            anchored p s.drones ∧
              ordered s.drones ∧ upper_bounded p s.drones ∧ ¬upper_bounded p (exec_coverage p s).drones
-/
#guard_msgs in
#check @upper_bound_exact

/--
info: 'CordonMirror.upper_bound_exact' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms upper_bound_exact

/--
info: sum_bounded_and_maximal : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 ≤ p.eps →
        2 * p.eps ≤ 1 →
          upper_bounded p s.drones →
            ∀ (k : Nat),
              2 * sum (protocol_step p s k).drones ≤ ↑(count s.drones) * (p.min + p.max) ∧
                (2 * sum (protocol_step p s k).drones = ↑(count s.drones) * (p.min + p.max) ↔
                  at_targets p (protocol_step p s k).drones)
-/
#guard_msgs in
#check @sum_bounded_and_maximal

/--
info: 'CordonMirror.sum_bounded_and_maximal' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms sum_bounded_and_maximal

/--
info: sum_paper : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    p.min < p.max →
      anchored p s.drones →
        0 ≤ p.eps →
          2 * p.eps < 1 →
            in_first_subsegment p s.drones →
              ∀ (k : Nat),
                2 * sum (protocol_step p s k).drones ≤ ↑(count s.drones) * (p.min + p.max) ∧
                  (2 * sum (protocol_step p s k).drones = ↑(count s.drones) * (p.min + p.max) ↔
                    at_targets p (protocol_step p s k).drones)
-/
#guard_msgs in
#check @sum_paper

/--
info: 'CordonMirror.sum_paper' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms sum_paper

/--
info: sum_identity : ∀ (p : Params) (s : State) (m : Nat),
  count s.drones = m + 2 →
    1 ≤ m →
      anchored p s.drones →
        ∀ (k : Nat),
          sum (protocol_step p s (k + 1)).drones - sum (protocol_step p s k).drones =
            p.eps * (gap (protocol_step p s k).drones m - gap (protocol_step p s k).drones 0)
-/
#guard_msgs in
#check @sum_identity

/--
info: 'CordonMirror.sum_identity' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms sum_identity

/--
info: sum_non_decreasing_sharp : ∀ (p : Params) (s : State) (m : Nat),
  count s.drones = m + 2 →
    1 ≤ m →
      anchored p s.drones →
        0 ≤ p.eps →
          2 * p.eps ≤ 1 →
            upper_bounded p s.drones →
              ∀ (k : Nat), sum (protocol_step p s k).drones ≤ sum (protocol_step p s (k + 1)).drones
-/
#guard_msgs in
#check @sum_non_decreasing_sharp

/--
info: 'CordonMirror.sum_non_decreasing_sharp' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms sum_non_decreasing_sharp

/--
info: sum_stationary_sharp : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      ∀ (k : Nat),
        at_targets p (protocol_step p s k).drones →
          sum (protocol_step p s (k + 1)).drones = sum (protocol_step p s k).drones
-/
#guard_msgs in
#check @sum_stationary_sharp

/--
info: 'CordonMirror.sum_stationary_sharp' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms sum_stationary_sharp

/--
info: targets_fixed_sharp : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      ∀ (k : Nat),
        at_targets p (protocol_step p s k).drones → ∀ (h : Nat), at_targets p (protocol_step p s (k + h)).drones
-/
#guard_msgs in
#check @targets_fixed_sharp

/--
info: 'CordonMirror.targets_fixed_sharp' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms targets_fixed_sharp

/--
info: targets_fixed_sum : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      ∀ (k : Nat),
        at_targets p (protocol_step p s k).drones →
          ∀ (h : Nat), sum (protocol_step p s (k + h)).drones = sum (protocol_step p s k).drones
-/
#guard_msgs in
#check @targets_fixed_sum

/--
info: 'CordonMirror.targets_fixed_sum' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms targets_fixed_sum

/--
info: constant_sum_bounded : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 < p.eps →
        2 * p.eps ≤ 1 →
          upper_bounded p s.drones →
            ∀ (k : Nat),
              (∀ (h : Nat),
                  1 ≤ h →
                    h ≤ (count s.drones - 1) / 2 →
                      sum (protocol_step p s (k + h)).drones = sum (protocol_step p s k).drones) →
                at_targets p (protocol_step p s k).drones
-/
#guard_msgs in
#check @constant_sum_bounded

/--
info: 'CordonMirror.constant_sum_bounded' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms constant_sum_bounded

/--
info: constant_sum_sharp : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 < p.eps →
        2 * p.eps ≤ 1 →
          upper_bounded p s.drones →
            ∀ (k : Nat),
              (∀ (h : Nat), 1 ≤ h → sum (protocol_step p s (k + h)).drones = sum (protocol_step p s k).drones) →
                at_targets p (protocol_step p s k).drones
-/
#guard_msgs in
#check @constant_sum_sharp

/--
info: 'CordonMirror.constant_sum_sharp' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms constant_sum_sharp

/--
info: constant_sum_zero_weight : ∀ (p : Params) (N : Nat),
  3 ≤ N →
    p.min < p.max →
      p.eps = 0 →
        ∃ s,
          count s.drones = N ∧
            anchored p s.drones ∧
              ordered s.drones ∧
                upper_bounded p s.drones ∧
                  (∀ (k : Nat), sum (protocol_step p s k).drones = sum s.drones) ∧ ¬at_targets p s.drones
-/
#guard_msgs in
#check @constant_sum_zero_weight

/--
info: 'CordonMirror.constant_sum_zero_weight' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms constant_sum_zero_weight

/--
info: increasing_sharp : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 < p.eps →
        2 * p.eps ≤ 1 →
          upper_bounded p s.drones →
            ∀ (k h j : Nat),
              j < count s.drones →
                ¬at_target p (protocol_step p s k).drones j →
                  depth (count s.drones) j = h + 1 →
                    (∀ (i : Nat),
                        i < count s.drones →
                          ¬at_target p (protocol_step p s k).drones i → h + 1 ≤ depth (count s.drones) i) →
                      (∀ (t : Nat), t ≤ h → sum (protocol_step p s (k + t)).drones = sum (protocol_step p s k).drones) ∧
                        sum (protocol_step p s (k + h)).drones < sum (protocol_step p s (k + h + 1)).drones
-/
#guard_msgs in
#check @increasing_sharp

/--
info: 'CordonMirror.increasing_sharp' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms increasing_sharp

/--
info: limit_rate : ∀ (M : Nat) (e r C : Rat),
  0 < M →
    0 ≤ e →
      2 * e ≤ 1 →
        0 ≤ r →
          ↑M * ↑M * r = ↑M * ↑M - 8 * e →
            0 ≤ C →
              ∀ (E : Nat → Nat → Rat),
                Run M e E →
                  E 0 0 = 0 →
                    E 0 M = 0 →
                      (∀ (i : Nat), i ≤ M → E 0 i ≤ C * weight M i) →
                        (∀ (i : Nat), i ≤ M → -E 0 i ≤ C * weight M i) →
                          ∀ (k i : Nat), i ≤ M → E k i ≤ r ^ k * C * weight M i ∧ -E k i ≤ r ^ k * C * weight M i
-/
#guard_msgs in
#check @limit_rate

/--
info: 'CordonMirror.limit_rate' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms limit_rate

/--
info: limit_half : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 < p.eps →
        2 * p.eps ≤ 1 →
          ∀ (i : Nat) (d : Rat),
            i < count s.drones →
              0 < d →
                ∃ K,
                  ∀ (k : Nat),
                    K ≤ k →
                      scaled_error p.min p.max (protocol_step p s k).drones i < d ∧
                        -scaled_error p.min p.max (protocol_step p s k).drones i < d
-/
#guard_msgs in
#check @limit_half

/--
info: 'CordonMirror.limit_half' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms limit_half

/--
info: limit_sharp : ∀ (p : Params) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones → 0 < p.eps → below_critical p.eps 1 (count s.drones) → converges p (protocol_step p s)
-/
#guard_msgs in
#check @limit_sharp

/--
info: 'CordonMirror.limit_sharp' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms limit_sharp

/--
info: limit_only_below : ∀ (p : Params) (N : Nat),
  3 ≤ N →
    (∀ (s : State), count s.drones = N → anchored p s.drones → converges p (protocol_step p s)) →
      0 < p.eps ∧ below_critical p.eps 1 N
-/
#guard_msgs in
#check @limit_only_below

/--
info: 'CordonMirror.limit_only_below' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms limit_only_below

/--
info: limit_iff : ∀ (p : Params) (N : Nat),
  3 ≤ N →
    ((∀ (s : State), count s.drones = N → anchored p s.drones → converges p (protocol_step p s)) ↔
      0 < p.eps ∧ below_critical p.eps 1 N)
-/
#guard_msgs in
#check @limit_iff

/--
info: 'CordonMirror.limit_iff' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms limit_iff

/--
info: below_critical_wave : ∀ (e t : Rat) (N : Nat),
  0 < e → e * t = 2 - 2 * e → (below_critical e 1 N ↔ ∀ (i : Nat), 1 ≤ i → i ≤ N - 1 → 0 < wave t i)
-/
#guard_msgs in
#check @below_critical_wave

/--
info: 'CordonMirror.below_critical_wave' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms below_critical_wave

/--
info: kth_step_reaches : ∀ (p : Params) (s : State) (k : Nat), ∃ j, (kth_step p s k).drones = (protocol_step p s j).drones
-/
#guard_msgs in
#check @kth_step_reaches

/--
info: 'CordonMirror.kth_step_reaches' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms kth_step_reaches

/--
info: projection : ∀ (p : LocalParams) (s : State),
  0 < p.ratio.den →
    p.protocol.n = counter_limit p.ratio →
      p.count = count s.drones →
        s.timesteps ≤ p.protocol.n →
          ∀ (k : Nat), swarm_kth_step p (swarm_of p.protocol s) k = swarm_of p.protocol (kth_step p.protocol s k)
-/
#guard_msgs in
#check @projection

/--
info: 'CordonMirror.projection' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms projection

/--
info: ordering_active : ∀ (p : Params) (schedule : Nat → Nat → Bool) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 ≤ p.eps → 2 * p.eps ≤ 1 → ordered s.drones → ∀ (k : Nat), ordered (active_step p schedule s k).drones
-/
#guard_msgs in
#check @ordering_active

/--
info: 'CordonMirror.ordering_active' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms ordering_active

/--
info: upper_bound_active : ∀ (p : Params) (schedule : Nat → Nat → Bool) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 ≤ p.eps →
        2 * p.eps ≤ 1 → upper_bounded p s.drones → ∀ (k : Nat), upper_bounded p (active_step p schedule s k).drones
-/
#guard_msgs in
#check @upper_bound_active

/--
info: 'CordonMirror.upper_bound_active' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms upper_bound_active

/--
info: box_active : ∀ (p : Params) (schedule : Nat → Nat → Bool) (s : State),
  3 ≤ count s.drones →
    anchored p s.drones →
      0 ≤ p.eps → 2 * p.eps ≤ 1 → in_box p s.drones → ∀ (k : Nat), in_box p (active_step p schedule s k).drones
-/
#guard_msgs in
#check @box_active

/--
info: 'CordonMirror.box_active' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms box_active

/--
info: upper_bound_delayed : ∀ (p : Params) (delay : Nat → Nat → Nat → Nat) (X : Nat → State),
  DelayedRun p delay X →
    3 ≤ count (X 0).drones →
      anchored p (X 0).drones →
        0 ≤ p.eps → 2 * p.eps ≤ 1 → upper_bounded p (X 0).drones → ∀ (k : Nat), upper_bounded p (X k).drones
-/
#guard_msgs in
#check @upper_bound_delayed

/--
info: 'CordonMirror.upper_bound_delayed' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms upper_bound_delayed

/--
info: limit_delayed : ∀ (p : Params) (delay : Nat → Nat → Nat → Nat) (X : Nat → State) (D : Nat),
  DelayedRun p delay X →
    3 ≤ count (X 0).drones →
      anchored p (X 0).drones → 0 < p.eps → 2 * p.eps ≤ 1 → (∀ (k i j : Nat), delay k i j ≤ D) → converges p X
-/
#guard_msgs in
#check @limit_delayed

/--
info: 'CordonMirror.limit_delayed' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms limit_delayed

/--
info: consensus_sum : ∀ (eps : Rat) (g : Graph) (x : DroneMap Rat),
  (∀ (i j : Nat), g.linked i j = g.linked j i) → g.count = count x → sum (exec_consensus eps g x) = sum x
-/
#guard_msgs in
#check @consensus_sum

/--
info: 'CordonMirror.consensus_sum' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms consensus_sum

/--
info: formation_sum : ∀ (eps : Rat) (g : Graph) (x b : DroneMap Rat),
  (∀ (i j : Nat), g.linked i j = g.linked j i) →
    g.count = count x → count b = count x → sum (exec_formation eps g x b) = sum x + eps * sum b
-/
#guard_msgs in
#check @formation_sum

/--
info: 'CordonMirror.formation_sum' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms formation_sum

/--
info: formation_without_input : ∀ (eps : Rat) (g : Graph) (x b : DroneMap Rat),
  (∀ (i : Nat), i < count x → get b i = 0) → exec_formation eps g x b = exec_consensus eps g x
-/
#guard_msgs in
#check @formation_without_input

/--
info: 'CordonMirror.formation_without_input' depends on axioms: [propext, Classical.choice, Quot.sound]
-/
#guard_msgs in
#print axioms formation_without_input

end CordonMirror
