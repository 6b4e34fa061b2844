(* Steps that read stale messages. *)
From Coq Require Import Arith.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage.

Section Delay.
Context {T : Type} `{Scalar T}.

(* Rust: spec/src/delay.rs exec_coverage_delayed.  Drone i sees drone j at
   seen i j; its own position it knows. *)
Definition exec_coverage_delayed (p : Params T) (s : State T) (seen : nat -> nat -> T) : State T :=
  let N := count (drones s) in
  mkState
    (lambda N (fun i => update p N i (fun j => if j =? i then getx s i else seen i j)))
    (timesteps s).

End Delay.
