(* What positions and weights are made of: a commutative ring with embedded
   integers.  Every definition of this folder is generic over it, as the Rust is
   over its trait, so that the same text is proved at the reals and executed at
   the rationals. *)
From Coq Require Import ZArith.

(* Rust: spec/src/scalar.rs Scalar *)
Class Scalar (T : Type) : Type := {
  from_int : Z -> T;
  add : T -> T -> T;
  sub : T -> T -> T;
  mul : T -> T -> T
}.

(* Rust: spec/src/scalar.rs from_index *)
Definition from_index {T} `{Scalar T} (i : nat) : T := from_int (Z.of_nat i).

(* Rust: spec/src/scalar.rs Ordered.  The order of exact scalars is total, so
   two relations say what `compare` says. *)
Class Ordered (T : Type) : Type := {
  less : T -> T -> Prop;
  at_most : T -> T -> Prop
}.
