(* Theorem 7.7 with the exact number of steps: while some drone is off its
   target, the sum first increases h + 1 steps later, h + 1 being the least
   distance, counted in drones, from an off-target drone to an end. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis Spec.Theorems.NonDecreasing.
From Cordon Require Import Proofs.Real Proofs.Dynamics Proofs.UpperBound Proofs.NonDecreasing.
Local Open Scope R_scope.

(* ---- Errors that vanish at the ends ---- *)

(* The mirrored swarm. *)
Lemma run_mirror : forall M e X, run M e X -> run M e (fun k i => X k (M - i)%nat).
Proof.
  intros M e X HX k; destruct (HX k) as [H0 HL Hi]; split.
  - rewrite Nat.sub_0_r; exact HL.
  - rewrite Nat.sub_diag; exact H0.
  - intros i Hlt; specialize (Hi (M - S (S i))%nat ltac:(lia)).
    replace (S (M - S (S i))) with (M - S i)%nat in Hi by lia.
    replace (S (M - S i)) with (M - i)%nat in Hi by lia.
    rewrite Hi; ring.
Qed.

Section Errors.
Variables (M : nat) (e : R) (E : nat -> nat -> R).
Hypothesis HE : run M e E.
Hypothesis Hend0 : forall k, E k O = 0.
Hypothesis Hpos : forall k i, (i <= M)%nat -> 0 <= E k i.
Hypothesis He : 0 <= e <= 1/2.

(* An error reaches drone i, t drones further left, within t steps. *)
Lemma spread : forall t k i, (S i + t < M)%nat -> e ^ t * E k (S i + t)%nat <= E (k + t)%nat (S i).
Proof.
  induction t as [|t IH]; intros k i Hi.
  - rewrite !Nat.add_0_r; simpl; lra.
  - replace (k + S t)%nat with (S (k + t)) by lia.
    rewrite (step_inner _ _ _ _ (HE (k + t)%nat) i) by lia.
    specialize (IH k (S i) ltac:(lia)).
    replace (S (S i) + t)%nat with (S i + S t)%nat in IH by lia.
    pose proof (Hpos (k + t) i ltac:(lia)) as P0.
    pose proof (Hpos (k + t) (S i) ltac:(lia)) as P1.
    assert (0 <= e * E (k + t)%nat i) by (apply Rmult_le_pos; lra).
    assert (0 <= (1 - 2 * e) * E (k + t)%nat (S i)) by (apply Rmult_le_pos; lra).
    assert (e * (e ^ t * E k (S i + S t)%nat) <= e * E (k + t)%nat (S (S i)))
      by (apply Rmult_le_compat_l; lra).
    simpl pow; lra.
Qed.

(* Where the first h drones are at their targets, h - t of them still are after t steps. *)
Lemma quiet : forall h k, (h < M)%nat -> (forall i, (i <= h)%nat -> E k i = 0) ->
  forall t i, (i + t <= h)%nat -> E (k + t)%nat i = 0.
Proof.
  intros h k Hh H0 t; induction t as [|t IH]; intros i Hi.
  - rewrite Nat.add_0_r; apply H0; lia.
  - destruct i as [|i]; [apply Hend0|].
    replace (k + S t)%nat with (S (k + t)) by lia.
    rewrite (step_inner _ _ _ _ (HE (k + t)%nat) i) by lia.
    rewrite !IH by lia; ring.
Qed.
End Errors.

(* ---- The sum increases by eps * (e_1 + e_{M-1}) ---- *)

Section Swarm.
Variables (M : nat) (e lo hi : R) (X : nat -> nat -> R).
Hypothesis HM : (2 <= M)%nat.
Hypothesis HX : run M e X.
Hypothesis Hlo : X O O = lo.
Hypothesis Hhi : X O M = hi.

Definition errors (k i : nat) : R := err lo hi M (X k) i.

Lemma errors_run : run M e errors.
Proof. intros k; apply step_err, HX. Qed.

Lemma errors_first : forall k, errors k O = 0.
Proof.
  intros k; unfold errors, err; rewrite line_first.
  destruct (run_ends _ _ _ HX k) as [-> _]; rewrite Hlo; ring.
Qed.

Lemma errors_last : forall k, errors k M = 0.
Proof.
  intros k; unfold errors, err; rewrite line_last by lia.
  destruct (run_ends _ _ _ HX k) as [_ ->]; rewrite Hhi; ring.
Qed.

Lemma sum_increment : forall k,
  sumn (X (S k)) (S M) - sumn (X k) (S M) = e * (errors k 1 + errors k (M - 1)%nat).
Proof.
  intros k; rewrite (telescope_all M e _ _ ltac:(lia) (HX k)).
  destruct (run_ends _ _ _ HX k) as [E0 EM]; rewrite E0, EM, Hlo, Hhi.
  unfold errors, err.
  assert (L0 : line lo hi M 1 = lo + (hi - lo) / INR M) by (unfold line; simpl; ring).
  assert (L1 : line lo hi M (M - 1) = line lo hi M M - (hi - lo) / INR M)
    by (unfold line; rewrite minus_INR by lia; change (INR 1) with 1; ring).
  rewrite L0, L1, line_last by lia; ring.
Qed.

Lemma first_increase : 0 < e <= 1/2 -> (forall i, (i <= M)%nat -> 0 <= errors O i) ->
  forall k h j, (j <= M)%nat -> errors k j <> 0 -> Nat.min j (M - j) = S h ->
  (forall i, (i <= M)%nat -> errors k i <> 0 -> (S h <= Nat.min i (M - i))%nat) ->
  (forall t, (t < h)%nat -> sumn (X (S (k + t))) (S M) = sumn (X (k + t)%nat) (S M)) /\
  sumn (X (k + h)%nat) (S M) < sumn (X (S (k + h))) (S M).
Proof.
  intros He H0 k h j Hj Hoff Hdepth Hleast.
  assert (Hpos : forall k i, (i <= M)%nat -> 0 <= errors k i).
  { intros k' i Hi.
    assert (B : below M (fun i => - errors k' i) (fun _ => 0)).
    { apply below_run with (e := e) (X := fun k i => - errors k i).
      - apply run_opp, errors_run.
      - lra.
      - apply concave_const.
      - intros i' Hi'; specialize (H0 i' Hi'); lra. }
    specialize (B i Hi); simpl in B; lra. }
  set (F := fun k i => errors k (M - i)%nat).
  assert (FR : run M e F) by (apply run_mirror, errors_run).
  assert (F0 : forall k, F k O = 0) by (intros k'; unfold F; rewrite Nat.sub_0_r; apply errors_last).
  assert (FP : forall k i, (i <= M)%nat -> 0 <= F k i) by (intros; apply Hpos; lia).
  split.
  - intros t Ht; pose proof (sum_increment (k + t)) as Hs.
    assert (Q1 : errors (k + t) 1 = 0).
    { apply (quiet M e errors errors_run errors_first h k); try lia.
      intros i Hi; destruct (Req_dec (errors k i) 0) as [Z|Z]; [exact Z|].
      specialize (Hleast i ltac:(lia) Z); lia. }
    assert (Q2 : F (k + t)%nat 1%nat = 0).
    { apply (quiet M e F FR F0 h k); try lia.
      intros i Hi; unfold F.
      destruct (Req_dec (errors k (M - i)%nat) 0) as [Z|Z]; [exact Z|].
      specialize (Hleast (M - i)%nat ltac:(lia) Z); lia. }
    unfold F in Q2; rewrite Q1, Q2 in Hs; lra.
  - pose proof (sum_increment (k + h)) as Hs.
    assert (P1 : 0 <= errors (k + h) 1) by (apply Hpos; lia).
    assert (P2 : 0 <= errors (k + h) (M - 1)) by (apply Hpos; lia).
    assert (He' : 0 < e ^ h) by (apply pow_lt; lra).
    assert (Hgt : 0 < errors (k + h) 1 + errors (k + h) (M - 1)).
    { destruct (Nat.le_gt_cases j (M - j)) as [Hl|Hl].
      - rewrite Nat.min_l in Hdepth by exact Hl; subst j.
        pose proof (spread M e errors errors_run Hpos ltac:(lra) h k 0 ltac:(lia)) as Sp.
        simpl Nat.add in Sp.
        assert (0 < errors k (S h)) by (pose proof (Hpos k (S h) Hj); lra).
        assert (0 < e ^ h * errors k (S h)) by (apply Rmult_lt_0_compat; assumption).
        lra.
      - rewrite Nat.min_r in Hdepth by lia.
        pose proof (spread M e F FR FP ltac:(lra) h k 0 ltac:(lia)) as Sp.
        simpl Nat.add in Sp; unfold F in Sp.
        replace (M - S h)%nat with j in Sp by lia.
        assert (0 < errors k j) by (pose proof (Hpos k j Hj); lra).
        assert (0 < e ^ h * errors k j) by (apply Rmult_lt_0_compat; assumption).
        lra. }
    assert (0 < e * (errors (k + h) 1 + errors (k + h) (M - 1)%nat))
      by (apply Rmult_lt_0_compat; lra).
    lra.
Qed.
End Swarm.

(* ---- On the spec ---- *)

(* How many drones from the nearer end drone i stands. *)
Definition depth (N i : nat) : nat := Nat.min i (N - 1 - i).

Definition c (p : Params R) (s : State R) (k : nat) : R := sum (drones (protocol_step p s k)).

Lemma c_sumn : forall p s k, c p s k = sumn (positions p s k) (count (drones s)).
Proof. intros; unfold c; rewrite sum_sumn, count_protocol_step; reflexivity. Qed.

Lemma at_target_errors : forall p (s : State R) k i, (3 <= count (drones s))%nat ->
  (at_target p (drones (protocol_step p s k)) i <->
   errors (count (drones s) - 1) (p_min p) (p_max p) (positions p s) k i = 0).
Proof.
  intros p s k i Hn; rewrite at_target_iff by (rewrite count_protocol_step; lia).
  rewrite count_protocol_step, target_line; unfold errors, err, positions; split; lra.
Qed.

(* 7.7, sharp. *)
Theorem increasing_sharp : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 < p_eps p <= 1/2 ->
  upper_bounded p (drones s) ->
  forall k h j,
  let N := count (drones s) in
  let off i := (i < N)%nat /\ ~ at_target p (drones (protocol_step p s k)) i in
  off j -> depth N j = S h -> (forall i, off i -> (S h <= depth N i)%nat) ->
  (forall t, (t <= h)%nat -> c p s (k + t) = c p s k) /\ c p s (k + h) < c p s (k + h + 1).
Proof.
  intros p s Hn Ha He Hu k h j N off [Hj Hoff] Hd Hleast.
  set (M := (N - 1)%nat).
  destruct (first_increase M (p_eps p) (p_min p) (p_max p) (positions p s)) with
    (k := k) (h := h) (j := j) as [Hc Hi]; auto.
  - unfold M, N; lia.
  - apply positions_run; assumption.
  - exact (proj1 Ha).
  - exact (proj2 Ha).
  - intros i Hi; unfold errors, err.
    pose proof (proj1 (upper_bounded_below p (drones s) ltac:(lia)) Hu i ltac:(unfold M, N in *; lia)) as B.
    fold N in B; fold M in B; unfold positions; simpl; lra.
  - unfold M; lia.
  - intros Z; apply Hoff, at_target_errors; assumption.
  - intros i Hi Z; apply (Hleast i); split; [unfold M in Hi; lia|].
    intros T; apply Z, at_target_errors; assumption.
  - assert (HS : S M = N) by (unfold M, N; lia); rewrite HS in Hc, Hi.
    split.
    + intros t; induction t as [|t IH]; intros Ht; [rewrite Nat.add_0_r; reflexivity|].
      rewrite <- IH by lia; rewrite !c_sumn; fold N.
      replace (k + S t)%nat with (S (k + t)) by lia; apply Hc; lia.
    + rewrite Nat.add_1_r, !c_sumn; fold N; exact Hi.
Qed.

(* Among finitely many off-target drones one is nearest to an end. *)
Lemma argmin : forall (P : nat -> Prop) (d : nat -> nat) n, (forall i, P i \/ ~ P i) ->
  (forall i, (i < n)%nat -> ~ P i) \/
  exists j, (j < n)%nat /\ P j /\ forall i, (i < n)%nat -> P i -> (d j <= d i)%nat.
Proof.
  intros P d n dec; induction n as [|n [IH|[j [Hj [Pj IH]]]]].
  - left; intros; lia.
  - destruct (dec n) as [Pn|Pn].
    + right; exists n; split; [lia|split; [exact Pn|]].
      intros i Hi Pi; destruct (Nat.eq_dec i n) as [->|Hne]; [lia|].
      exfalso; apply (IH i); [lia|exact Pi].
    + left; intros i Hi; destruct (Nat.eq_dec i n) as [->|Hne]; [exact Pn|apply IH; lia].
  - right; destruct (dec n) as [Pn|Pn].
    + destruct (Nat.le_gt_cases (d j) (d n)) as [Hd|Hd].
      * exists j; split; [lia|split; [exact Pj|]].
        intros i Hi Pi; destruct (Nat.eq_dec i n) as [->|Hne]; [exact Hd|apply IH; [lia|exact Pi]].
      * exists n; split; [lia|split; [exact Pn|]].
        intros i Hi Pi; destruct (Nat.eq_dec i n) as [->|Hne]; [lia|].
        specialize (IH i ltac:(lia) Pi); lia.
    + exists j; split; [lia|split; [exact Pj|]].
      intros i Hi Pi; destruct (Nat.eq_dec i n) as [->|Hne]; [contradiction|apply IH; [lia|exact Pi]].
Qed.

Lemma at_target_dec : forall p (x : DroneMap R) i, at_target p x i \/ ~ at_target p x i.
Proof. intros; unfold at_target; apply Req_dec. Qed.

(* The end drones are always at their targets. *)
Lemma off_target_internal : forall p (s : State R) k j,
  (3 <= count (drones s))%nat -> anchored p (drones s) -> (j < count (drones s))%nat ->
  ~ at_target p (drones (protocol_step p s k)) j -> (1 <= depth (count (drones s)) j)%nat.
Proof.
  intros p s k j Hn Ha Hj Hoff; unfold depth.
  destruct (Nat.eq_dec j 0) as [->|E0].
  { exfalso; apply Hoff, at_target_errors; auto.
    apply (errors_first _ (p_eps p)); [apply positions_run; assumption|exact (proj1 Ha)]. }
  destruct (Nat.eq_dec j (count (drones s) - 1)) as [->|E1]; [|lia].
  exfalso; apply Hoff, at_target_errors; auto.
  apply (errors_last _ (p_eps p)); [lia|apply positions_run; assumption|exact (proj2 Ha)].
Qed.

(* Off the targets an increase comes within ceil((N-2)/2) steps. *)
Theorem increasing_within : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 < p_eps p <= 1/2 ->
  upper_bounded p (drones s) -> forall k,
  ~ at_targets p (drones (protocol_step p s k)) ->
  exists h, (h + 1 <= (count (drones s) - 2 + 1) / 2)%nat /\
    (forall t, (t <= h)%nat -> c p s (k + t) = c p s k) /\ c p s (k + h) < c p s (k + h + 1).
Proof.
  intros p s Hn Ha He Hu k Hoff; set (N := count (drones s)) in *.
  destruct (argmin (fun i => ~ at_target p (drones (protocol_step p s k)) i) (depth N) N)
    as [Hnone|[j [Hj [Pj Hmin]]]].
  - intros i; destruct (at_target_dec p (drones (protocol_step p s k)) i); tauto.
  - exfalso; apply Hoff; intros i Hi; rewrite count_protocol_step in Hi.
    destruct (at_target_dec p (drones (protocol_step p s k)) i) as [T|T]; [exact T|].
    exfalso; apply (Hnone i); [exact Hi|exact T].
  - pose proof (off_target_internal p s k j Hn Ha Hj Pj) as Hd; fold N in Hd.
    destruct (depth N j) as [|h] eqn:Ed; [lia|].
    exists h; split.
    + assert (2 * S h <= N - 1)%nat by (unfold depth in Ed; lia).
      apply Nat.div_le_lower_bound; lia.
    + apply (increasing_sharp p s Hn Ha He Hu k h j); [split; assumption|exact Ed|].
      intros i [Hi Pi]; apply Hmin; assumption.
Qed.

(* 7.7 as printed, its slips mended: the step of the increase exists. *)
Corollary increasing_paper : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 < p_eps p <= 1/2 ->
  upper_bounded p (drones s) -> forall k,
  c p s (k + 1) = c p s k -> ~ at_targets p (drones (protocol_step p s k)) ->
  exists h, (1 <= h)%nat /\ c p s (k + h) < c p s (k + h + 1).
Proof.
  intros p s Hn Ha He Hu k Hc Hoff.
  destruct (increasing_within p s Hn Ha He Hu k Hoff) as [h [_ [_ Hi]]].
  exists h; split; [|exact Hi].
  destruct h as [|h]; [|lia]; rewrite Nat.add_0_r in Hi; lra.
Qed.
