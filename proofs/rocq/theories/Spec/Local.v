(* The coverage protocol of one drone that knows only its neighbours (Listings 5
   and 6), and what the master does between two ticks. *)
From Coq Require Import Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage.

(* Rust: spec/src/local.rs TickRatio.  The quotient eps/stepsize of Listing 6,
   seconds over seconds: not always an integer.  den is positive. *)
Record TickRatio : Type := mkRatio { num : nat; den : nat }.

(* Rust: spec/src/local.rs whole *)
Definition whole (n : nat) : TickRatio := mkRatio n 1.

(* Rust: spec/src/local.rs reached_by: timesteps >= num/den, on integers. *)
Definition reached_by (r : TickRatio) (timesteps : nat) : bool :=
  num r <=? timesteps * den r.

(* Rust: spec/src/local.rs counter_limit: the quotient rounded up. *)
Definition counter_limit (r : TickRatio) : nat := (num r + (den r - 1)) / den r.

(* Rust: spec/src/local.rs LocalParams *)
Record LocalParams (T : Type) : Type := mkLocalParams {
  protocol : Params T;
  local_count : nat;
  ratio : TickRatio
}.
Arguments mkLocalParams {T}.
Arguments protocol {T}.
Arguments local_count {T}.
Arguments ratio {T}.

(* Rust: spec/src/local.rs LocalState *)
Record LocalState (T : Type) : Type := mkLocal {
  prec : T;
  own : T;
  foll : T;
  id : nat
}.
Arguments mkLocal {T}.
Arguments prec {T}.
Arguments own {T}.
Arguments foll {T}.
Arguments id {T}.

(* Rust: spec/src/local.rs SimState *)
Record SimState (T : Type) : Type := mkSim {
  sim_timesteps : nat;
  st : LocalState T
}.
Arguments mkSim {T}.
Arguments sim_timesteps {T}.
Arguments st {T}.

Section Local.
Context {T : Type} `{Scalar T}.

(* Rust: spec/src/local.rs fmu_exec_cvg *)
Definition fmu_exec_cvg (p : LocalParams T) (a b c : T) (i : nat) : T :=
  exec_cvg (protocol p) (local_count p) a b c i.

(* Rust: spec/src/local.rs fmu_tick *)
Definition fmu_tick (p : LocalParams T) (s : SimState T) : SimState T :=
  if reached_by (ratio p) (sim_timesteps s) then
    let l := st s in
    let xp := if 0 <? id l then prec l else p_min (protocol p) in
    let xf := if id l + 1 <? local_count p then foll l else p_max (protocol p) in
    mkSim 0 (mkLocal (prec l) (fmu_exec_cvg p xp (own l) xf (id l)) (foll l) (id l))
  else mkSim (sim_timesteps s + 1) (st s).

(* Rust: spec/src/local.rs fmu_kth_step *)
Fixpoint fmu_kth_step (p : LocalParams T) (start : SimState T) (k : nat) : SimState T :=
  match k with
  | 0 => start
  | S k' => fmu_tick p (fmu_kth_step p start k')
  end.

(* Rust: spec/src/local.rs project *)
Definition project (p : Params T) (s : State T) (i : nat) : SimState T :=
  let prec := if 0 <? i then getx s (i - 1) else p_min p in
  let foll := if i + 1 <? count (drones s) then getx s (i + 1) else p_max p in
  mkSim (timesteps s) (mkLocal prec (getx s i) foll i).

(* Rust indexes `m[i]`.  Any machine outside the map; nothing looks there. *)
Definition machine (m : DroneMap (SimState T)) (i : nat) : SimState T :=
  let z := from_int BinNums.Z0 in
  nth i m (mkSim 0 (mkLocal z z z 0)).

(* Rust: spec/src/local.rs exchange *)
Definition exchange (m : DroneMap (SimState T)) : DroneMap (SimState T) :=
  lambda (count m) (fun i =>
    let l := st (machine m i) in
    mkSim (sim_timesteps (machine m i))
      (mkLocal (if 0 <? i then own (st (machine m (i - 1))) else prec l)
               (own l)
               (if i + 1 <? count m then own (st (machine m (i + 1))) else foll l)
               (id l))).

(* Rust: spec/src/local.rs swarm_tick *)
Definition swarm_tick (p : LocalParams T) (m : DroneMap (SimState T)) : DroneMap (SimState T) :=
  exchange (lambda (count m) (fun i => fmu_tick p (machine m i))).

End Local.
