(* The consensus (rendez-vous) protocol: equation 6. *)
From Coq Require Import List ZArith.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.Graph.

Section Consensus.
Context {T : Type} `{Scalar T}.

(* Rust: spec/src/consensus.rs pull: component i of -L x. *)
Definition pull (g : Graph) (x : DroneMap T) (i : nat) : T :=
  fold_left (fun sum j => add sum (sub (get x j) (get x i))) (neighbours g i) (from_int 0%Z).

(* Rust: spec/src/consensus.rs exec_consensus *)
Definition exec_consensus (eps : T) (g : Graph) (x : DroneMap T) : DroneMap T :=
  lambda (count x) (fun i => add (get x i) (mul eps (pull g x i))).

End Consensus.
