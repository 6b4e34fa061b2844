(* Maps from drone identifiers to values: the paper's dmap (Listing 3).  They
   are tabulated, as in Rust: looking a drone up recomputes nothing, so that k
   steps cost k updates. *)
From Coq Require Import List ZArith.
From Cordon Require Import Spec.Scalar.

(* Rust: spec/src/drone_map.rs DroneMap *)
Definition DroneMap (T : Type) : Type := list T.

(* Rust: spec/src/drone_map.rs count *)
Definition count {T : Type} (m : DroneMap T) : nat := length m.

(* Rust: spec/src/drone_map.rs lambda, the paper's LAMBDA; it takes the number
   of drones where the Rust takes a map that has as many. *)
Definition lambda {T : Type} (n : nat) (f : nat -> T) : DroneMap T :=
  map f (seq 0 n).

(* Rust indexes `as_ref()[i]`.  Zero outside the map, where Rust would panic; no
   definition of the spec looks there. *)
Definition get {T : Type} `{Scalar T} (m : DroneMap T) (i : nat) : T :=
  nth i m (from_int 0%Z).
