(* The coverage protocol of the whole swarm (equation 10, Listing 4). *)
From Coq Require Import Arith ZArith.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State.

Section Coverage.
Context {T : Type} `{Scalar T}.

(* Rust: spec/src/coverage.rs exec_cvg *)
Definition exec_cvg (p : Params T) (N : nat) (a b c : T) (i : nat) : T :=
  if i =? 0 then p_min p
  else if i + 1 =? N then p_max p
  else
    let eps := p_eps p in
    let one := from_int 1%Z in
    let two := from_int 2%Z in
    add (add (mul eps a) (mul (sub one (mul two eps)) b)) (mul eps c).

(* Rust: spec/src/coverage.rs getx *)
Definition getx (s : State T) (i : nat) : T := get (drones s) i.

(* Rust: spec/src/coverage.rs update: the LET xp, x, xf block of Listing 4. *)
Definition update (p : Params T) (N i : nat) (position_of : nat -> T) : T :=
  let xp := if 0 <? i then position_of (i - 1) else p_min p in
  let x := position_of i in
  let xf := if i + 1 <? N then position_of (i + 1) else p_max p in
  exec_cvg p N xp x xf i.

(* Rust: spec/src/coverage.rs next_placement.  Every drone reads the same old
   positions: Jacobi, never in place. *)
Definition next_placement (p : Params T) (x : DroneMap T) : DroneMap T :=
  let N := count x in
  lambda N (fun i => update p N i (get x)).

(* Rust: spec/src/coverage.rs exec_coverage *)
Definition exec_coverage (p : Params T) (s : State T) : State T :=
  mkState (next_placement p (drones s)) (timesteps s).

(* Rust: spec/src/coverage.rs tick *)
Definition tick (p : Params T) (s : State T) : State T :=
  tick_with s (p_n p) (next_placement p).

(* Rust: spec/src/coverage.rs kth_step.  k counts ticks. *)
Fixpoint kth_step (p : Params T) (start : State T) (k : nat) : State T :=
  match k with
  | 0 => start
  | S k' => tick p (kth_step p start k')
  end.

End Coverage.
