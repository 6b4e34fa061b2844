(* The identity behind theorem 7.5. *)
From Coq Require Import Arith.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.Placement.

Section Identity.
Context {T : Type} `{Scalar T}.

(* Rust: spec/src/theorems/non_decreasing.rs telescoping_residual *)
Definition telescoping_residual (eps : T) (before after : DroneMap T) : T :=
  let last := count before - 2 in
  let ends := sub (gap before last) (gap before 0) in
  sub (sub (sum after) (sum before)) (mul eps ends).

End Identity.
