(* The spec at the real numbers, and what each of its definitions says there in
   ordinary notation. *)
From Coq Require Import Reals Lra Lia ZArith Arith List.
From Cordon Require Import Spec.Scalar Spec.DroneMap Spec.State Spec.Coverage Spec.Placement.
From Cordon Require Import Spec.Theorems.Hypothesis Spec.Theorems.UpperBound.
Local Open Scope R_scope.

#[global] Instance real_scalar : Scalar R := {
  from_int := IZR; add := Rplus; sub := Rminus; mul := Rmult
}.

#[global] Instance real_ordered : Ordered R := { less := Rlt; at_most := Rle }.

(* ---- DroneMap ---- *)

(* Two lemmas the standard library has under names that changed between versions. *)
Lemma map_len : forall (A B : Type) (f : A -> B) l, length (map f l) = length l.
Proof. intros A B f l; induction l as [|x l IH]; simpl; [|rewrite IH]; reflexivity. Qed.

Lemma seq_len : forall N start, length (seq start N) = N.
Proof. intros N; induction N as [|c IH]; intros start; simpl; [|rewrite IH]; reflexivity. Qed.

Lemma count_lambda : forall (T : Type) (N : nat) (f : nat -> T),
  count (lambda N f) = N.
Proof.
  intros; unfold count, lambda; rewrite map_len, seq_len; reflexivity.
Qed.

Lemma get_lambda : forall (T : Type) (K : Scalar T) (N : nat) (f : nat -> T) (i : nat),
  (i < N)%nat -> get (lambda N f) i = f i.
Proof.
  intros T K N f i Hi; unfold get, lambda.
  rewrite (nth_indep _ (from_int 0%Z) (f 0%nat)) by (rewrite map_len, seq_len; exact Hi).
  rewrite map_nth, seq_nth by exact Hi; reflexivity.
Qed.

Lemma get_outside : forall (T : Type) (K : Scalar T) (m : DroneMap T) (i : nat),
  (count m <= i)%nat -> get m i = from_int 0%Z.
Proof. intros; unfold get; apply nth_overflow; assumption. Qed.

Lemma map_ext_get : forall (T : Type) (K : Scalar T) (m m' : DroneMap T),
  count m = count m' -> (forall i, (i < count m)%nat -> get m i = get m' i) -> m = m'.
Proof.
  intros T K m m' Hlen Hget; apply nth_ext with (d := from_int 0%Z) (d' := from_int 0%Z).
  - exact Hlen.
  - exact Hget.
Qed.

(* Convergence in plain notation; the standard library has the distance under a
   name that changed between versions. *)
Lemma cv_abs : forall (v : nat -> R) l,
  Un_cv v l <->
  forall eps, 0 < eps -> exists K, forall k, (K <= k)%nat -> Rabs (v k - l) < eps.
Proof. intros v l; split; intros H eps Heps; destruct (H eps Heps) as [K HK]; exists K; exact HK. Qed.

(* ---- Sums ---- *)

(* The sum of f 0 .. f (n - 1). *)
Fixpoint sumn (f : nat -> R) (n : nat) : R :=
  match n with
  | O => 0
  | S n' => sumn f n' + f n'
  end.

Lemma sumn_ext : forall f g n,
  (forall i, (i < n)%nat -> f i = g i) -> sumn f n = sumn g n.
Proof.
  intros f g n; induction n as [|n IH]; intros Hfg; simpl; [reflexivity|].
  rewrite (Hfg n) by lia; rewrite IH; [reflexivity|].
  intros i Hi; apply Hfg; lia.
Qed.

Lemma sumn_plus : forall f g n, sumn (fun i => f i + g i) n = sumn f n + sumn g n.
Proof. intros f g n; induction n as [|n IH]; simpl; [ring|rewrite IH; ring]. Qed.

Lemma sumn_minus : forall f g n, sumn (fun i => f i - g i) n = sumn f n - sumn g n.
Proof. intros f g n; induction n as [|n IH]; simpl; [ring|rewrite IH; ring]. Qed.

Lemma sumn_scal : forall c f n, sumn (fun i => c * f i) n = c * sumn f n.
Proof. intros c f n; induction n as [|n IH]; simpl; [ring|rewrite IH; ring]. Qed.

Lemma sumn_zero : forall f n, (forall i, (i < n)%nat -> f i = 0) -> sumn f n = 0.
Proof.
  intros f n; induction n as [|n IH]; intros Hf; simpl; [reflexivity|].
  rewrite (Hf n) by lia; rewrite IH; [ring|intros i Hi; apply Hf; lia].
Qed.

Lemma sumn_nonneg : forall f n, (forall i, (i < n)%nat -> 0 <= f i) -> 0 <= sumn f n.
Proof.
  intros f n; induction n as [|n IH]; intros Hf; simpl; [lra|].
  assert (0 <= f n) by (apply Hf; lia).
  assert (0 <= sumn f n) by (apply IH; intros i Hi; apply Hf; lia).
  lra.
Qed.

Lemma sumn_nonneg_zero : forall f n,
  (forall i, (i < n)%nat -> 0 <= f i) -> sumn f n = 0 ->
  forall i, (i < n)%nat -> f i = 0.
Proof.
  intros f n; induction n as [|n IH]; intros Hf Hsum i Hi; [lia|].
  simpl in Hsum.
  assert (Hn : 0 <= f n) by (apply Hf; lia).
  assert (Hs : 0 <= sumn f n) by (apply sumn_nonneg; intros j Hj; apply Hf; lia).
  destruct (Nat.eq_dec i n) as [->|Hne]; [lra|].
  apply IH; [intros j Hj; apply Hf; lia|lra|lia].
Qed.

Lemma sumn_swap : forall (f : nat -> nat -> R) n m,
  sumn (fun i => sumn (fun j => f i j) m) n = sumn (fun j => sumn (fun i => f i j) n) m.
Proof.
  intros f n m; induction n as [|n IH]; simpl.
  - symmetry; apply sumn_zero; reflexivity.
  - rewrite IH, sumn_plus; reflexivity.
Qed.

Lemma sumn_shift : forall f n, sumn f (S n) = f O + sumn (fun i => f (S i)) n.
Proof.
  intros f n; induction n as [|n IH]; [simpl; ring|].
  change (sumn f (S (S n))) with (sumn f (S n) + f (S n)).
  rewrite IH; simpl; ring.
Qed.

Lemma fold_left_add : forall (f : nat -> R) l acc,
  fold_left (fun sum j => sum + f j) l acc = acc + fold_left (fun sum j => sum + f j) l 0.
Proof.
  intros f l; induction l as [|j l IH]; intros acc; simpl; [ring|].
  rewrite IH, (IH (0 + f j)); ring.
Qed.

Lemma fold_left_Rplus : forall (l : list R) acc, fold_left Rplus l acc = acc + fold_left Rplus l 0.
Proof.
  induction l as [|x l IH]; intros acc; simpl; [ring|].
  rewrite IH, (IH (0 + x)); ring.
Qed.

Lemma sum_sumn : forall m : DroneMap R, sum m = sumn (get m) (count m).
Proof.
  unfold sum; simpl; induction m as [|x m IH]; [reflexivity|].
  change (count (x :: m)) with (S (count m)).
  rewrite sumn_shift; simpl; rewrite fold_left_Rplus, IH.
  change (get (x :: m) 0) with x; rewrite Rplus_0_l; reflexivity.
Qed.

(* ---- Coverage ---- *)

Lemma tick_eq : forall (T : Type) (K : Scalar T) p (s : State T),
  tick p s = if Nat.eqb (timesteps s) (p_n p)
             then mkState (drones (exec_coverage p s)) 0
             else mkState (drones s) (timesteps s + 1).
Proof. reflexivity. Qed.

Lemma count_exec_coverage : forall (T : Type) (K : Scalar T) p (s : State T),
  count (drones (exec_coverage p s)) = count (drones s).
Proof. intros; apply count_lambda. Qed.

(* Positions after k protocol steps, that is updates: what the theorems of
   section 7 of the paper count.  `kth_step` counts ticks; with n = 0 the two
   are the same (kth_step_every_tick). *)
Fixpoint protocol_step {T : Type} `{Scalar T} (p : Params T) (start : State T) (k : nat) : State T :=
  match k with
  | O => start
  | S k' => exec_coverage p (protocol_step p start k')
  end.

Lemma count_protocol_step : forall (T : Type) (K : Scalar T) p (s : State T) k,
  count (drones (protocol_step p s k)) = count (drones s).
Proof.
  intros T K p s k; induction k as [|k IH]; [reflexivity|].
  simpl protocol_step; rewrite count_exec_coverage; exact IH.
Qed.

Lemma count_kth_step : forall (T : Type) (K : Scalar T) p (s : State T) k,
  count (drones (kth_step p s k)) = count (drones s).
Proof.
  intros T K p s k; induction k as [|k IH]; [reflexivity|].
  simpl kth_step; rewrite !tick_eq; destruct (Nat.eqb _ _); cbn [drones];
    [rewrite count_exec_coverage|]; exact IH.
Qed.

(* update at the three kinds of drones, in ordinary notation. *)

Lemma update_first : forall (p : Params R) N f, update p N 0 f = p_min p.
Proof. reflexivity. Qed.

Lemma update_last : forall (p : Params R) N f, (1 < N)%nat -> update p N (N - 1) f = p_max p.
Proof.
  intros p N f HN; unfold update, exec_cvg.
  replace (Nat.eqb (N - 1) 0) with false by (symmetry; apply Nat.eqb_neq; lia).
  replace (Nat.eqb (N - 1 + 1) N) with true by (symmetry; apply Nat.eqb_eq; lia).
  reflexivity.
Qed.

Lemma update_inner : forall (p : Params R) N i f, (i + 2 < N)%nat ->
  update p N (i + 1) f = p_eps p * f i + (1 - 2 * p_eps p) * f (i + 1)%nat + p_eps p * f (i + 2)%nat.
Proof.
  intros p N i f Hi; unfold update, exec_cvg.
  replace (Nat.ltb 0 (i + 1)) with true by (symmetry; apply Nat.ltb_lt; lia).
  replace (Nat.ltb (i + 1 + 1) N) with true by (symmetry; apply Nat.ltb_lt; lia).
  replace (Nat.eqb (i + 1) 0) with false by (symmetry; apply Nat.eqb_neq; lia).
  replace (Nat.eqb (i + 1 + 1) N) with false by (symmetry; apply Nat.eqb_neq; lia).
  replace (i + 1 - 1)%nat with i by lia.
  replace (i + 1 + 1)%nat with (i + 2)%nat by lia.
  reflexivity.
Qed.

(* exec_coverage at the three kinds of drones. *)

Lemma get_exec_first : forall p (s : State R),
  (0 < count (drones s))%nat -> get (drones (exec_coverage p s)) 0 = p_min p.
Proof.
  intros p s Hn; unfold exec_coverage, next_placement; cbn [drones].
  rewrite get_lambda by exact Hn; apply update_first.
Qed.

Lemma get_exec_last : forall p (s : State R),
  (1 < count (drones s))%nat ->
  get (drones (exec_coverage p s)) (count (drones s) - 1) = p_max p.
Proof.
  intros p s Hn; unfold exec_coverage, next_placement; cbn [drones].
  rewrite get_lambda by lia; apply update_last; exact Hn.
Qed.

Lemma get_exec_inner : forall p (s : State R) i,
  (i + 2 < count (drones s))%nat ->
  get (drones (exec_coverage p s)) (i + 1) =
  p_eps p * get (drones s) i + (1 - 2 * p_eps p) * get (drones s) (i + 1)
  + p_eps p * get (drones s) (i + 2).
Proof.
  intros p s i Hi; unfold exec_coverage, next_placement; cbn [drones].
  rewrite get_lambda by lia; apply update_inner; exact Hi.
Qed.

(* ---- Placement ---- *)

(* The spacing l and the targets, with division: what the scaled quantities of
   the spec mean at the reals. *)
Definition spacing (p : Params R) (N : nat) : R :=
  (p_max p - p_min p) / INR (N - 1).

Definition target (p : Params R) (N i : nat) : R :=
  p_min p + INR i * spacing p N.

Lemma from_index_INR : forall i, from_index i = INR i.
Proof. intros i; unfold from_index; simpl; symmetry; apply INR_IZR_INZ. Qed.

Lemma INR_pos : forall n, (0 < n)%nat -> 0 < INR n.
Proof. intros n Hn; apply lt_0_INR; exact Hn. Qed.

Lemma scaled_error_target : forall p (x : DroneMap R) i, (1 < count x)%nat ->
  scaled_error (p_min p) (p_max p) x i = INR (count x - 1) * (target p (count x) i - get x i).
Proof.
  intros p x i Hc; unfold scaled_error, scaled_target, gaps, target, spacing.
  rewrite !from_index_INR; simpl.
  assert (0 < INR (count x - 1)) by (apply INR_pos; lia).
  field; lra.
Qed.

Lemma scale_pos : forall x : DroneMap R, (1 < count x)%nat -> 0 < INR (count x - 1).
Proof. intros x Hx; apply INR_pos; lia. Qed.

Lemma at_target_iff : forall p (m : DroneMap R) i, (1 < count m)%nat ->
  (at_target p m i <-> get m i = target p (count m) i).
Proof.
  intros p m i Hm; unfold at_target; rewrite scaled_error_target by exact Hm; simpl.
  pose proof (scale_pos m Hm); split; intros E; [|rewrite E; ring].
  apply Rmult_integral in E; destruct E; lra.
Qed.

Lemma at_targets_iff : forall p (m : DroneMap R), (1 < count m)%nat ->
  (at_targets p m <-> forall i, (i < count m)%nat -> get m i = target p (count m) i).
Proof.
  intros p m Hm; unfold at_targets; split; intros E i Hi; apply at_target_iff; auto.
Qed.

Lemma upper_bounded_iff : forall p (m : DroneMap R), (1 < count m)%nat ->
  (upper_bounded p m <-> forall i, (i < count m)%nat -> get m i <= target p (count m) i).
Proof.
  intros p m Hm; pose proof (scale_pos m Hm) as Hs; unfold upper_bounded; split; intros E i Hi;
    specialize (E i Hi); revert E; rewrite scaled_error_target by exact Hm; simpl; intros E.
  - apply Rnot_lt_le; intros Hlt.
    assert (0 < INR (count m - 1) * (get m i - target p (count m) i))
      by (apply Rmult_lt_0_compat; lra). lra.
  - apply Rmult_le_pos; lra.
Qed.

Lemma above_targets_iff : forall p (m : DroneMap R), (1 < count m)%nat ->
  (above_targets p m <-> forall i, (i < count m)%nat -> target p (count m) i <= get m i).
Proof.
  intros p m Hm; pose proof (scale_pos m Hm) as Hs; unfold above_targets; split; intros E i Hi;
    specialize (E i Hi); revert E; rewrite scaled_error_target by exact Hm; simpl; intros E.
  - apply Rnot_lt_le; intros Hlt.
    assert (0 < INR (count m - 1) * (target p (count m) i - get m i))
      by (apply Rmult_lt_0_compat; lra). lra.
  - assert (0 <= INR (count m - 1) * (get m i - target p (count m) i))
      by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma in_first_subsegment_iff : forall p (m : DroneMap R), (1 < count m)%nat ->
  (in_first_subsegment p m <->
   forall i, (0 < i)%nat -> (i + 1 < count m)%nat -> get m i < p_min p + spacing p (count m)).
Proof.
  intros p m Hm; pose proof (scale_pos m Hm) as Hs.
  assert (Hl : INR (count m - 1) * spacing p (count m) = p_max p - p_min p)
    by (unfold spacing; field; lra).
  unfold in_first_subsegment, gaps; rewrite from_index_INR; simpl.
  split; intros E i Hi Hi'; specialize (E i Hi Hi').
  - apply Rmult_lt_reg_l with (INR (count m - 1)); lra.
  - assert (INR (count m - 1) * get m i
            < INR (count m - 1) * (p_min p + spacing p (count m)))
      by (apply Rmult_lt_compat_l; lra). lra.
Qed.
