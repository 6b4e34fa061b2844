(* Quantities of a placement, all free of division so that they make sense in any
   ring: where a formula would divide by N - 1, the quantity here is the one
   multiplied by N - 1, and its name says so. *)
From Coq Require Import Arith ZArith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap.

Section Placement.
Context {T : Type} `{Scalar T}.

(* Rust: spec/src/placement.rs gap *)
Definition gap (x : DroneMap T) (i : nat) : T := sub (get x (i + 1)) (get x i).

(* Rust: spec/src/placement.rs sum *)
Definition sum (x : DroneMap T) : T := fold_left add x (from_int 0%Z).

(* Rust: spec/src/placement.rs gaps *)
Definition gaps (x : DroneMap T) : T := from_index (count x - 1).

(* Rust: spec/src/placement.rs scaled_target *)
Definition scaled_target (min max : T) (N i : nat) : T :=
  add (mul (from_index (N - 1)) min) (mul (from_index i) (sub max min)).

(* Rust: spec/src/placement.rs scaled_error *)
Definition scaled_error (min max : T) (x : DroneMap T) (i : nat) : T :=
  sub (scaled_target min max (count x) i) (mul (gaps x) (get x i)).

(* Rust: spec/src/placement.rs scaled_energy *)
Definition scaled_energy (min max : T) (x : DroneMap T) : T :=
  fold_left (fun sum i => let e := scaled_error min max x i in add sum (mul e e))
    (seq 0 (count x)) (from_int 0%Z).

End Placement.

(* Rust: spec/src/placement.rs contraction_weight *)
Definition contraction_weight (N i : nat) : nat := i * (N - 1 - i).
