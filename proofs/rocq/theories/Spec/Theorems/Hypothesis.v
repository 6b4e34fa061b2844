(* Which starts a theorem is about. *)
From Coq Require Import Arith ZArith.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Placement.

Section StartSets.
Context {T : Type} `{Scalar T} `{Ordered T}.

(* Rust: spec/src/theorems/hypothesis.rs contains, the part common to all start
   sets: drones 0 and N-1 stand at min and max (assumption 1). *)
Definition anchored (p : Params T) (x : DroneMap T) : Prop :=
  get x 0 = p_min p /\ get x (count x - 1) = p_max p.

(* Rust: spec/src/theorems/hypothesis.rs ordered (assumption 2) *)
Definition ordered (x : DroneMap T) : Prop :=
  forall i, i + 1 < count x -> less (get x i) (get x (i + 1)).

(* Rust: spec/src/theorems/hypothesis.rs in_first_subsegment (assumption 3) *)
Definition in_first_subsegment (p : Params T) (x : DroneMap T) : Prop :=
  forall i, 0 < i -> i + 1 < count x ->
  less (mul (gaps x) (get x i)) (add (mul (gaps x) (p_min p)) (sub (p_max p) (p_min p))).

(* Rust: spec/src/theorems/hypothesis.rs upper_bounded (UB) *)
Definition upper_bounded (p : Params T) (x : DroneMap T) : Prop :=
  forall i, i < count x -> at_most (from_int 0%Z) (scaled_error (p_min p) (p_max p) x i).

(* Rust: spec/src/theorems/hypothesis.rs at_target *)
Definition at_target (p : Params T) (x : DroneMap T) (i : nat) : Prop :=
  scaled_error (p_min p) (p_max p) x i = from_int 0%Z.

(* Rust: spec/src/theorems/hypothesis.rs at_targets *)
Definition at_targets (p : Params T) (x : DroneMap T) : Prop :=
  forall i, i < count x -> at_target p x i.

(* The leading minors of den*(I + A), by their three-term recurrence: the last
   two after k steps. *)
Fixpoint minors (diagonal off_squared : T) (k : nat) : T * T :=
  match k with
  | 0 => (from_int 0%Z, from_int 1%Z)
  | S k' =>
      let (before, minor) := minors diagonal off_squared k' in
      (minor, sub (mul diagonal minor) (mul off_squared before))
  end.

(* Rust: spec/src/theorems/hypothesis.rs below_critical: whether
   num/den < 1/(1 + cos(pi/(N-1))), without the cosine. *)
Definition below_critical (num den : T) (N : nat) : Prop :=
  let two := from_int 2%Z in
  let diagonal := sub (mul two den) (mul two num) in
  let off_squared := mul num num in
  forall k, 1 <= k <= N - 2 -> less (from_int 0%Z) (snd (minors diagonal off_squared k)).

End StartSets.
