(* Formation control: equation 8 in discrete time. *)
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.Graph Spec.Consensus.

Section Formation.
Context {T : Type} `{Scalar T}.

(* Rust: spec/src/formation.rs exec_formation *)
Definition exec_formation (eps : T) (g : Graph) (x b : DroneMap T) : DroneMap T :=
  lambda (count x) (fun i => add (get x i) (mul eps (add (pull g x i) (get b i)))).

End Formation.
