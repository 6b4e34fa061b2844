(* Steps in which only some drones update. *)
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage.

Section Activation.
Context {T : Type} `{Scalar T}.

(* Rust: spec/src/activation.rs exec_coverage_active *)
Definition exec_coverage_active (p : Params T) (s : State T) (active : nat -> bool) : State T :=
  let N := count (drones s) in
  mkState (lambda N (fun i => if active i then update p N i (getx s) else getx s i))
          (timesteps s).

End Activation.
