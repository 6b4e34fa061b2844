(* Parameters and state of the swarm (Listing 3 and the paper's theory initial).
   Counters are natural numbers here and u32 in Rust; within 0 .. n, where every
   run stays, the two agree. *)
From Coq Require Import Arith.
From Cordon Require Import Spec.DroneMap.

(* Rust: spec/src/state.rs Params *)
Record Params (T : Type) : Type := mkParams {
  p_min : T;
  p_max : T;
  p_eps : T;
  p_n : nat
}.
Arguments mkParams {T}.
Arguments p_min {T}.
Arguments p_max {T}.
Arguments p_eps {T}.
Arguments p_n {T}.

(* Rust: spec/src/state.rs State *)
Record State (T : Type) : Type := mkState {
  drones : DroneMap T;
  timesteps : nat
}.
Arguments mkState {T}.
Arguments drones {T}.
Arguments timesteps {T}.

(* Rust: spec/src/state.rs Phase.  First: the counter starts at n, so that the
   first update is in tick 1.  Last: it starts at 0, first update in tick n + 1. *)
Inductive Phase : Type := First | Last.

(* Rust: spec/src/state.rs initial *)
Definition initial {T : Type} (m : DroneMap T) (n : nat) (phase : Phase) : State T :=
  mkState m (match phase with First => n | Last => 0 end).

(* Rust: spec/src/state.rs tick_with: one tick of any protocol. *)
Definition tick_with {T : Type} (s : State T) (n : nat) (protocol : DroneMap T -> DroneMap T)
  : State T :=
  if timesteps s =? n then mkState (protocol (drones s)) 0
  else mkState (drones s) (timesteps s + 1).
