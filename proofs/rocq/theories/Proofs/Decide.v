(* The predicates of a placement decided on fractions, so that vectors can
   execute them.  The procedures compute: they end with Defined. *)
From Coq Require Import QArith Arith Lia List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis Spec.Theorems.UpperBound.
From Cordon Require Import Spec.Theorems.Statements.
From Cordon Require Import Proofs.Rational.

#[global] Instance rational_ordered : Ordered Q := { less := Qlt; at_most := Qle }.

Definition decided (P : Prop) : Set := {P} + {~ P}.

Definition less_dec (a b : Q) : decided (less a b).
Proof.
  destruct (Qlt_le_dec a b) as [H|H]; [left; exact H|right; apply Qle_not_lt; exact H].
Defined.

Definition at_most_dec (a b : Q) : decided (at_most a b).
Proof.
  destruct (Qlt_le_dec b a) as [H|H]; [right; apply Qlt_not_le; exact H|left; exact H].
Defined.

(* Fractions in lowest terms are equal when they are the same. *)
Definition same_dec (a b : Q) : decided (a = b).
Proof.
  destruct a as [n d], b as [n' d'].
  destruct (Z.eq_dec n n') as [H|H]; [|right; congruence].
  destruct (Pos.eq_dec d d') as [H'|H']; [left; congruence|right; congruence].
Defined.

Definition both {A B : Prop} (a : decided A) (b : decided B) : decided (A /\ B).
Proof. destruct a; [|right; tauto]; destruct b; [left|right]; tauto. Defined.

Definition implied {A B : Prop} (a : decided A) (b : decided B) : decided (A -> B).
Proof. destruct a; [|left; tauto]; destruct b; [left|right]; tauto. Defined.

Definition every (P : nat -> Prop) (d : forall i, decided (P i)) (n : nat) :
  decided (forall i, i < n -> P i)%nat.
Proof.
  induction n as [|n [H|H]]; [left; intros i Hi; exfalso; lia| |right; auto with arith].
  destruct (d n) as [Hn|Hn]; [left|right; auto].
  intros i Hi; destruct (Nat.eq_dec i n) as [->|Hne]; [exact Hn|apply H; lia].
Defined.

(* The same where the range is written otherwise. *)
Definition recast {A B : Prop} (Hab : A <-> B) (a : decided A) : decided B.
Proof. destruct a; [left|right]; tauto. Defined.

Definition anchored_dec (p : Params Q) x : decided (anchored p x) := both (same_dec _ _) (same_dec _ _).

Definition ordered_dec (x : DroneMap Q) : decided (ordered x).
Proof.
  apply (recast (A := forall i, (i < count x - 1)%nat -> less (get x i) (get x (i + 1)))).
  - split; intros H i Hi; apply H; lia.
  - apply every; intros i; apply less_dec.
Defined.

Definition in_first_subsegment_dec (p : Params Q) x : decided (in_first_subsegment p x).
Proof.
  apply (recast (A := forall i, (i < count x - 1)%nat -> (0 < i)%nat ->
    less (mul (gaps x) (get x i)) (add (mul (gaps x) (p_min p)) (sub (p_max p) (p_min p))))).
  - split; intros H i H1 H2; apply H; lia.
  - apply every; intros i; apply implied; [apply lt_dec|apply less_dec].
Defined.

Definition upper_bounded_dec (p : Params Q) x : decided (upper_bounded p x) :=
  every _ (fun i => at_most_dec _ _) (count x).

Definition at_targets_dec (p : Params Q) x : decided (at_targets p x) :=
  every _ (fun i => same_dec _ _) (count x).

Definition above_targets_dec (p : Params Q) x : decided (above_targets p x) :=
  every _ (fun i => at_most_dec _ _) (count x).

Definition in_box_dec (p : Params Q) x : decided (in_box p x) :=
  every _ (fun i => both (at_most_dec _ _) (at_most_dec _ _)) (count x).

Definition in_set_dec (starts : StartSet) (p : Params Q) x : decided (in_set starts p x).
Proof.
  apply both; [apply anchored_dec|]; destruct starts.
  - left; exact I.
  - apply ordered_dec.
  - apply both; [apply ordered_dec|apply in_first_subsegment_dec].
  - apply upper_bounded_dec.
Defined.

Definition below_critical_dec (num den : Q) (N : nat) : decided (below_critical num den N).
Proof.
  apply (recast (A := forall k, (k < N - 1)%nat -> (1 <= k)%nat ->
    less (from_int 0%Z) (snd (minors (sub (mul (from_int 2%Z) den) (mul (from_int 2%Z) num)) (mul num num) k)))).
  - split; intros H k; [intros Hk; apply H; lia|intros H1 H2; apply H; lia].
  - apply every; intros k; apply implied; [apply le_dec|apply less_dec].
Defined.

Definition critical_dec (num den : Q) (N : nat) : decided (in_range BelowCritical num den N) :=
  both (less_dec _ _) (below_critical_dec num den N).
