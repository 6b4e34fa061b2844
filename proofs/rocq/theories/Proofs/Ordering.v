(* Theorem 7.2, invariant spatial ordering, in its sharp form, and why 1/2
   (for three drones: 1) cannot be improved. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis Spec.Theorems.UpperBound.
From Cordon Require Import Proofs.Real Proofs.Dynamics.
Local Open Scope R_scope.

Definition increasing_seq (M : nat) (x : nat -> R) : Prop :=
  forall i, (i < M)%nat -> x i < x (S i).

Lemma convex_pos_2 : forall a g h, 0 <= a <= 1 -> 0 < g -> 0 < h -> 0 < (1 - a) * g + a * h.
Proof.
  intros a g h [H0 H1] Hg Hh.
  destruct (Rle_lt_dec a (1/2)).
  - assert (0 < (1 - a) * g) by (apply Rmult_lt_0_compat; lra).
    assert (0 <= a * h) by (apply Rmult_le_pos; lra). lra.
  - assert (0 <= (1 - a) * g) by (apply Rmult_le_pos; lra).
    assert (0 < a * h) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma convex_pos_3 : forall a b f g h, 0 <= a -> 0 <= b -> a + b <= 1 ->
  0 < f -> 0 < g -> 0 < h -> 0 < a * f + (1 - a - b) * g + b * h.
Proof.
  intros a b f g h Ha Hb Hab Hf Hg Hh.
  assert (0 <= a * f) by (apply Rmult_le_pos; lra).
  assert (0 <= b * h) by (apply Rmult_le_pos; lra).
  assert (0 <= (1 - a - b) * g) by (apply Rmult_le_pos; lra).
  destruct (Rle_lt_dec a 0); [|assert (0 < a * f) by (apply Rmult_lt_0_compat; lra); lra].
  destruct (Rle_lt_dec b 0); [|assert (0 < b * h) by (apply Rmult_lt_0_compat; lra); lra].
  assert (0 < (1 - a - b) * g) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(* Each new gap is a convex combination of old ones as soon as the weights of
   two neighbours add up to at most 1 (the end drones have weight 0). *)
Lemma ordering_weighted : forall M a x y, (2 <= M)%nat ->
  weighted M a x y ->
  (forall i, (0 < i < M)%nat -> 0 <= a i <= 1) ->
  (forall i, (0 < i)%nat -> (S i < M)%nat -> a i + a (S i) <= 1) ->
  increasing_seq M x -> increasing_seq M y.
Proof.
  intros M a x y HM [H0 HL Hi] Ha Haa Hx [|j] Hj.
  - rewrite H0, (Hi 0%nat) by lia.
    pose proof (convex_pos_2 (a 1%nat) (x 1%nat - x 0%nat) (x 2%nat - x 1%nat)) as C.
    specialize (Ha 1%nat ltac:(lia)).
    pose proof (Hx 0%nat ltac:(lia)); pose proof (Hx 1%nat ltac:(lia)).
    specialize (C Ha ltac:(lra) ltac:(lra)); lra.
  - rewrite (Hi j) by lia.
    pose proof (Hx j ltac:(lia)); pose proof (Hx (S j) ltac:(lia)).
    pose proof (Ha (S j) ltac:(lia)) as Haj.
    destruct (Nat.eq_dec (S (S j)) M) as [E|E].
    + rewrite E, HL, <- E.
      pose proof (convex_pos_2 (a (S j)) (x (S (S j)) - x (S j)) (x (S j) - x j) Haj
                    ltac:(lra) ltac:(lra)); lra.
    + rewrite (Hi (S j)) by lia.
      pose proof (Ha (S (S j)) ltac:(lia)) as Haj'.
      pose proof (Hx (S (S j)) ltac:(lia)).
      pose proof (convex_pos_3 (a (S j)) (a (S (S j)))
                    (x (S j) - x j) (x (S (S j)) - x (S j)) (x (S (S (S j))) - x (S (S j)))
                    ltac:(lra) ltac:(lra) (Haa (S j) ltac:(lia) ltac:(lia))
                    ltac:(lra) ltac:(lra) ltac:(lra)); lra.
Qed.

Lemma ordering_run : forall M e X, (2 <= M)%nat ->
  0 <= e -> e <= 1/2 \/ M = 2%nat /\ e <= 1 ->
  run M e X -> increasing_seq M (X O) -> forall k, increasing_seq M (X k).
Proof.
  intros M e X HM He Hcase HX H0 k; induction k as [|k IH]; [exact H0|].
  apply ordering_weighted with (a := fun _ => e) (x := X k); auto.
  - apply step_weighted, HX.
  - intros i Hi; lra.
  - intros i Hi Hi'; destruct Hcase as [Hc|[-> Hc]]; [lra|lia].
Qed.

Lemma ordered_iff : forall m : DroneMap R, (1 < count m)%nat ->
  (ordered m <-> increasing_seq (count m - 1) (get m)).
Proof.
  intros m Hm; unfold ordered, increasing_seq; split; intros H i Hi.
  - rewrite <- Nat.add_1_r; apply H; lia.
  - rewrite Nat.add_1_r; apply H; lia.
Qed.

Lemma ordering_general : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) ->
  0 <= p_eps p -> p_eps p <= 1/2 \/ count (drones s) = 3%nat /\ p_eps p <= 1 ->
  ordered (drones s) -> forall k, ordered (drones (protocol_step p s k)).
Proof.
  intros p s Hn Ha He Hc Ho k.
  apply ordered_iff; [rewrite count_protocol_step; lia|].
  rewrite count_protocol_step.
  apply ordering_run with (e := p_eps p) (X := positions p s); auto.
  - lia.
  - destruct Hc as [Hc|[-> Hc]]; [left; lra|right; split; [reflexivity|lra]].
  - apply positions_run; assumption.
  - apply ordered_iff; [lia|exact Ho].
Qed.

(* 7.2, sharp: any strictly ordered start, 0 <= eps <= 1/2. *)
Theorem ordering_sharp : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  ordered (drones s) -> forall k, ordered (drones (protocol_step p s k)).
Proof. intros p s Hn Ha [H0 H1] Ho; apply ordering_general; auto. Qed.

(* 7.2 for three drones: up to eps = 1. *)
Theorem ordering_three : forall p (s : State R),
  count (drones s) = 3%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1 ->
  ordered (drones s) -> forall k, ordered (drones (protocol_step p s k)).
Proof. intros p s Hn Ha [H0 H1] Ho; apply ordering_general; auto; lia. Qed.

(* 7.2 in ticks, whatever the period and the counter. *)
Theorem ordering_ticks : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p <= 1/2 ->
  ordered (drones s) -> forall k, ordered (drones (kth_step p s k)).
Proof.
  intros p s Hn Ha He Ho k; destruct (kth_step_reaches _ _ p s k) as [j ->].
  apply ordering_sharp; assumption.
Qed.

(* 7.2 under the paper's hypothesis (definition 6 gives 0 <= eps). *)
Corollary ordering_paper : forall p (s : State R),
  (3 <= count (drones s))%nat -> anchored p (drones s) -> 0 <= p_eps p < 1/3 ->
  ordered (drones s) -> forall k, ordered (drones (kth_step p s k)).
Proof. intros p s Hn Ha He; apply ordering_ticks; auto; lra. Qed.

(* ---- Exactness ---- *)

(* Two crowds, at the two ends, with gaps d between their members. *)
Definition two_crowds (lo hi d : R) (M i : nat) : R :=
  if Nat.leb i 1 then lo + INR i * d else hi - INR (M - i) * d.

Definition start_of (p : Params R) (N : nat) (x : nat -> R) : State R :=
  mkState (lambda N x) 0.

Lemma get_start : forall p N x i, (i < N)%nat ->
  get (drones (start_of p N x)) i = x i.
Proof. intros; unfold start_of; cbn [drones]; apply get_lambda; assumption. Qed.

Lemma count_start : forall p N x, count (drones (start_of p N x)) = N.
Proof. intros; apply count_lambda. Qed.

(* For N >= 4 and every eps > 1/2, on every segment: an ordered start whose
   drones 1 and 2 have changed places after one update. *)
Theorem ordering_exact : forall p N,
  (4 <= N)%nat -> p_min p < p_max p -> 1/2 < p_eps p ->
  exists s : State R,
    count (drones s) = N /\ anchored p (drones s) /\ ordered (drones s) /\
    get (drones (exec_coverage p s)) 2 < get (drones (exec_coverage p s)) 1.
Proof.
  intros p N Hn Hseg He.
  set (lo := p_min p) in *; set (hi := p_max p) in *; set (e := p_eps p) in *.
  set (M := (N - 1)%nat).
  assert (HMR : 3 <= INR M) by (replace 3 with (INR 3) by (simpl; ring); apply le_INR; lia).
  set (D := 2 * (2 * e + (2 * e - 1) * (INR M - 1))).
  assert (HD : 0 < D) by (unfold D; nra).
  set (d := (2 * e - 1) * (hi - lo) / D).
  assert (Hd0 : 0 < d) by (unfold d; apply Rdiv_lt_0_compat; nra).
  assert (HdD : d * D = (2 * e - 1) * (hi - lo)) by (unfold d; field; lra).
  assert (Hwide : 2 * ((INR M - 1) * d) < hi - lo).
  { assert (0 < 2 * e - 1) by lra.
    assert (Hlt : 0 < 4 * e * d) by nra.
    assert ((2 * e - 1) * (2 * ((INR M - 1) * d)) < (2 * e - 1) * (hi - lo)).
    { rewrite <- HdD; unfold D; nra. }
    apply Rmult_lt_reg_l with (2 * e - 1); lra. }
  exists (start_of p N (two_crowds lo hi d M)).
  assert (Hlen : count (drones (start_of p N (two_crowds lo hi d M))) = N)
    by apply count_start.
  assert (X0 : two_crowds lo hi d M 0 = lo) by (unfold two_crowds; simpl; ring).
  assert (X1 : two_crowds lo hi d M 1 = lo + d) by (unfold two_crowds; simpl; ring).
  assert (XI : forall i, (2 <= i <= M)%nat ->
            two_crowds lo hi d M i = hi - (INR M - INR i) * d).
  { intros i Hi; unfold two_crowds.
    replace (Nat.leb i 1) with false by (symmetry; apply Nat.leb_gt; lia).
    rewrite minus_INR by lia; reflexivity. }
  assert (I2 : INR 2 = 2) by (simpl; ring).
  assert (I3 : INR 3 = 3) by (simpl; ring).
  split; [exact Hlen|]. split; [|split].
  - split; rewrite ?Hlen, get_start by lia.
    + exact X0.
    + fold M; rewrite XI by lia; fold hi; ring.
  - intros i Hi; rewrite Hlen in Hi; rewrite !get_start by lia; simpl.
    destruct i as [|[|i]].
    + rewrite X0; simpl; rewrite X1; lra.
    + rewrite X1; simpl; rewrite (XI 2%nat) by lia; rewrite I2.
      assert (0 < (INR M - 1) * d) by nra. lra.
    + rewrite !XI by lia. rewrite plus_INR; change (INR 1) with 1. lra.
  - pose proof (get_exec_inner p (start_of p N (two_crowds lo hi d M)) 0) as E1.
    pose proof (get_exec_inner p (start_of p N (two_crowds lo hi d M)) 1) as E2.
    rewrite Hlen in E1, E2; specialize (E1 ltac:(lia)); specialize (E2 ltac:(lia)).
    simpl Nat.add in E1, E2; rewrite !get_start in E1, E2 by lia.
    rewrite E1, E2, X0, X1, (XI 2%nat), (XI 3%nat) by lia.
    rewrite I2, I3; fold e.
    assert (0 < (2 * e - 1) * (hi - lo)) by nra.
    unfold D in HdD; nra.
Qed.

(* For N = 3 and every eps > 1: an ordered start whose middle drone overtakes
   the last one at the first update. *)
Theorem ordering_three_exact : forall p,
  p_min p < p_max p -> 1 < p_eps p ->
  exists s : State R,
    count (drones s) = 3%nat /\ anchored p (drones s) /\ ordered (drones s) /\
    get (drones (exec_coverage p s)) 2 < get (drones (exec_coverage p s)) 1.
Proof.
  intros p Hseg He.
  set (lo := p_min p) in *; set (hi := p_max p) in *; set (e := p_eps p) in *.
  set (d := (e - 1) * (hi - lo) / (2 * (2 * e - 1))).
  assert (Hd0 : 0 < d) by (unfold d; apply Rdiv_lt_0_compat; nra).
  assert (Hd : d * (2 * (2 * e - 1)) = (e - 1) * (hi - lo)) by (unfold d; field; lra).
  assert (Hd1 : d < hi - lo) by nra.
  exists (mkState (lo :: lo + d :: hi :: nil) 0).
  split; [reflexivity|split; [split; reflexivity|split]].
  - intros [|[|i]] Hi; simpl in Hi |- *; unfold get; simpl; [lra|lra|lia].
  - pose proof (get_exec_inner p (mkState (lo :: lo + d :: hi :: nil) 0) 0) as E1.
    pose proof (get_exec_last p (mkState (lo :: lo + d :: hi :: nil) 0)) as E2.
    simpl in E1, E2 |- *.
    specialize (E1 ltac:(lia)); specialize (E2 ltac:(lia)).
    unfold get in E1, E2 |- *; simpl in E1, E2 |- *.
    rewrite E1, E2; fold e hi.
    assert (0 < (e - 1) * (hi - lo)) by nra. nra.
Qed.
