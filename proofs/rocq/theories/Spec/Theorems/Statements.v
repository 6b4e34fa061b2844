(* The theorems as the Rust evaluates them: which weights and starts each is
   about, how many placements its conclusion reads, and the conclusion.  A
   verdict "holds" or "vacuous" is a proposition that is true here, "violated"
   one that is false.  The weight is p_eps, over 1, where the Rust has a
   quotient. *)
From Coq Require Import Arith ZArith.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis.

(* Rust: spec/src/theorems/hypothesis.rs WeightRange *)
Inductive WeightRange : Type :=
  AnyWeight | Unit | BelowThird | BelowHalf | UpToHalf | UpToHalfOrOne | PositiveUpToHalf
  | BelowCritical.

(* Rust: spec/src/theorems/hypothesis.rs StartSet *)
Inductive StartSet : Type := AnyStart | OrderedStart | FirstSubsegment | UpperBoundedStart.

(* Rust: spec/src/theorems/mod.rs Form *)
Inductive Form : Type := Paper | Sharp.

(* Rust: spec/src/theorems/mod.rs Theorem *)
Inductive TheoremName : Type :=
  Ordering | UpperBound | SumBounded | SumMaximal | SumNonDecreasing | SumStationary
  | TargetsFixed | ConstantSum | GloballyIncreasing | Limit.

(* Rust: spec/src/theorems/mod.rs hypothesis *)
Definition hypothesis (form : Form) (th : TheoremName) : WeightRange * StartSet :=
  match form, th with
  | Paper, Ordering => (BelowThird, OrderedStart)
  | Paper, (UpperBound | SumBounded | SumMaximal | SumNonDecreasing) => (BelowHalf, FirstSubsegment)
  | Paper, (TargetsFixed | ConstantSum) => (BelowThird, FirstSubsegment)
  | Paper, (SumStationary | Limit) => (Unit, FirstSubsegment)
  | Paper, GloballyIncreasing => (Unit, UpperBoundedStart)
  | Sharp, Ordering => (UpToHalfOrOne, OrderedStart)
  | Sharp, (UpperBound | SumBounded | SumMaximal | SumNonDecreasing) => (UpToHalf, UpperBoundedStart)
  | Sharp, (SumStationary | TargetsFixed) => (AnyWeight, AnyStart)
  | Sharp, (ConstantSum | GloballyIncreasing) => (PositiveUpToHalf, UpperBoundedStart)
  | Sharp, Limit => (BelowCritical, AnyStart)
  end.

(* Rust: spec/src/theorems/mod.rs span.  Placements beyond X^k that the
   conclusion about step k reads, of N drones. *)
Definition span (form : Form) (th : TheoremName) (N : nat) : nat :=
  let internal := Nat.max (N - 2) 1 in
  match th, form with
  | (Ordering | UpperBound | SumBounded | SumMaximal), _ => 0
  | (SumNonDecreasing | SumStationary | Limit), _ => 1
  | (TargetsFixed | ConstantSum), Paper => internal
  | (TargetsFixed | ConstantSum), Sharp => (internal + 1) / 2
  | GloballyIncreasing, Paper => internal + 1
  | GloballyIncreasing, Sharp => (N - 1) / 2
  end.

Section Statements.
Context {T : Type} `{Scalar T} `{Ordered T}.

(* Rust: spec/src/theorems/hypothesis.rs contains, of a range *)
Definition in_range (range : WeightRange) (num den : T) (N : nat) : Prop :=
  let zero := from_int 0%Z in
  let times (n : Z) := mul (from_int n) num in
  match range with
  | AnyWeight => True
  | Unit => at_most zero num /\ at_most num den
  | BelowThird => at_most zero num /\ less (times 3%Z) den
  | BelowHalf => at_most zero num /\ less (times 2%Z) den
  | UpToHalf => at_most zero num /\ at_most (times 2%Z) den
  | UpToHalfOrOne => at_most zero num /\ (if N =? 3 then at_most num den else at_most (times 2%Z) den)
  | PositiveUpToHalf => less zero num /\ at_most (times 2%Z) den
  | BelowCritical => less zero num /\ below_critical num den N
  end.

(* Rust: spec/src/theorems/hypothesis.rs contains, of a set *)
Definition in_set (starts : StartSet) (p : Params T) (x : DroneMap T) : Prop :=
  anchored p x /\
  match starts with
  | AnyStart => True
  | OrderedStart => ordered x
  | FirstSubsegment => ordered x /\ in_first_subsegment p x
  | UpperBoundedStart => upper_bounded p x
  end.

(* Rust: spec/src/theorems/hypothesis.rs met_by *)
Definition met_by (form : Form) (th : TheoremName) (p : Params T) (x : DroneMap T) : Prop :=
  in_range (fst (hypothesis form th)) (p_eps p) (from_int 1%Z) (count x) /\
  in_set (snd (hypothesis form th)) p x.

(* Rust: spec/src/theorems/sum.rs doubled *)
Definition doubled (p : Params T) (x : DroneMap T) : T * T :=
  (mul (from_int 2%Z) (sum x), mul (from_index (count x)) (add (p_min p) (p_max p))).

(* Rust: spec/src/theorems/increasing.rs first_off_target_is_late *)
Definition first_off_target_is_late (p : Params T) (x : DroneMap T) : Prop :=
  exists j, j < count x /\ 3 <= j /\ (forall i, i < j -> at_target p x i) /\
            less (from_int 0%Z) (scaled_error (p_min p) (p_max p) x j).

(* The step of the first increase that 7.7 predicts: the least depth of a drone
   off its target.  Rust: spec/src/theorems/increasing.rs exact *)
Definition first_increase_at (p : Params T) (x : DroneMap T) (step : nat) : Prop :=
  let depth i := Nat.min i (count x - 1 - i) in
  (exists j, j < count x /\ ~ at_target p x j /\ depth j = step) /\
  forall i, i < count x -> ~ at_target p x i -> step <= depth i.

(* Rust: spec/src/theorems/limit.rs magnitude *)
Definition magnitude (e m : T) : Prop :=
  (less e (from_int 0%Z) /\ m = sub (from_int 0%Z) e) \/ (at_most (from_int 0%Z) e /\ m = e).

(* Rust: spec/src/theorems/limit.rs at_rate *)
Definition at_rate (p : Params T) (now next : DroneMap T) : Prop :=
  let N := count now in
  let whole := mul (mul (from_index (N - 1)) (from_index (N - 1))) (from_int 1%Z) in
  let kept := sub whole (mul (from_int 8%Z) (p_eps p)) in
  let weight i := from_index (contraction_weight N i) in
  let error x i := scaled_error (p_min p) (p_max p) x i in
  in_range PositiveUpToHalf (p_eps p) (from_int 1%Z) N ->
  forall i, 1 <= i < N - 1 ->
  exists j after before, 1 <= j < N - 1 /\
    magnitude (error next i) after /\ magnitude (error now j) before /\
    at_most (mul (mul whole after) (weight j)) (mul (mul kept before) (weight i)).

(* Rust: spec/src/theorems/mod.rs conclusion, of the run X 0, X 1, ... *)
Definition conclusion (form : Form) (th : TheoremName) (p : Params T) (X : nat -> DroneMap T) : Prop :=
  let now := X 0 in
  let reads := span form th (count now) in
  match th with
  | Ordering => ordered now
  | UpperBound => upper_bounded p now
  | SumBounded => at_most (fst (doubled p now)) (snd (doubled p now))
  | SumMaximal => fst (doubled p now) = snd (doubled p now) <-> at_targets p now
  | SumNonDecreasing => at_most (sum now) (sum (X 1))
  | SumStationary => at_targets p now -> sum now = sum (X 1)
  | TargetsFixed =>
      at_targets p now -> forall h, 1 <= h <= reads ->
      match form with Paper => sum now = sum (X h) | Sharp => at_targets p (X h) end
  | ConstantSum => (forall h, 1 <= h <= reads -> sum now = sum (X h)) -> at_targets p now
  | GloballyIncreasing =>
      match form with
      | Paper =>
          sum now = sum (X 1) -> first_off_target_is_late p now ->
          exists h, 1 <= h < reads /\ less (sum (X h)) (sum (X (h + 1)))
      | Sharp =>
          forall step, first_increase_at p now step ->
          (forall h, 1 <= h < step -> sum now = sum (X h)) /\ less (sum now) (sum (X step))
      end
  | Limit =>
      ~ at_targets p now ->
      less (scaled_energy (p_min p) (p_max p) (X 1)) (scaled_energy (p_min p) (p_max p) now) /\
      match form with Paper => True | Sharp => at_rate p now (X 1) end
  end.

(* What the conclusions about all later steps say, when no span bounds them. *)
Definition for_ever (form : Form) (th : TheoremName) (p : Params T) (X : nat -> DroneMap T) : Prop :=
  let now := X 0 in
  match th, form with
  | TargetsFixed, Paper => at_targets p now -> forall h, 1 <= h -> sum now = sum (X h)
  | TargetsFixed, Sharp => at_targets p now -> forall h, 1 <= h -> at_targets p (X h)
  | ConstantSum, _ => (forall h, 1 <= h -> sum now = sum (X h)) -> at_targets p now
  | GloballyIncreasing, Paper =>
      sum now = sum (X 1) -> first_off_target_is_late p now ->
      exists h, 1 <= h /\ less (sum (X h)) (sum (X (h + 1)))
  | _, _ => conclusion form th p X
  end.

End Statements.
