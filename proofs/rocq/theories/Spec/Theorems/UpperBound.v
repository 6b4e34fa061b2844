(* The companions of theorem 7.3. *)
From Coq Require Import Arith ZArith.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Placement.

Section Companions.
Context {T : Type} `{Scalar T} `{Ordered T}.

(* Rust: spec/src/theorems/upper_bound.rs above_targets *)
Definition above_targets (p : Params T) (x : DroneMap T) : Prop :=
  forall i, i < count x -> at_most (scaled_error (p_min p) (p_max p) x i) (from_int 0%Z).

(* Rust: spec/src/theorems/upper_bound.rs in_box *)
Definition in_box (p : Params T) (x : DroneMap T) : Prop :=
  forall i, i < count x -> at_most (p_min p) (get x i) /\ at_most (get x i) (p_max p).

End Companions.
